struct abi_LightParams {
    place: vec4<f32>,
    axis: vec3<f32>,
    cos_outer: f32,
    range_squared: f32,
    cos_inner: f32,
    pad: vec2<u32>,
}

struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_9 {
    member: array<abi_Sample>,
}

struct type_13 {
    member: array<u32>,
}

struct type_17 {
    member: array<f32>,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
}

struct texture_TextureView {
    offset: u32,
    size: u32,
    flags: u32,
}

struct lt_bvh_traverse_Stack {
    first: array<u32, 32>,
    mask: array<u32, 32>,
    len: u32,
    group: u32,
    group_mask: u32,
}

struct lt_math_LightProjection {
    row_x: vec4<f32>,
    row_y: vec4<f32>,
    row_z: vec4<f32>,
    row_w: vec4<f32>,
}

struct abi_ShadowParams {
    projection: lt_math_LightProjection,
    light: abi_LightParams,
    test: vec4<f32>,
    size: vec2<u32>,
    map_size: u32,
    epsilon: f32,
    root: u32,
    level_count: u32,
    pad0_: u32,
    pad1_: u32,
}

struct type_33 {
    member: abi_ShadowParams,
}

struct lt_bvh_Node {
    frame: vec4<u32>,
    links: vec4<u32>,
    x: vec4<u32>,
    y: vec4<u32>,
    z: vec4<u32>,
}

struct type_38 {
    member: array<lt_bvh_Node>,
}

struct lt_bvh_Triangle {
    v0_: vec3<f32>,
    i0_: u32,
    v1_: vec3<f32>,
    i1_: u32,
    v2_: vec3<f32>,
    i2_: u32,
}

struct type_42 {
    member: array<lt_bvh_Triangle>,
}

struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
}

struct type_46 {
    member: array<abi_Vertex>,
}

struct abi_Material {
    base_color: vec4<f32>,
    cutoff: f32,
    flags: u32,
    alpha_offset: u32,
    alpha_size: u32,
    color_offset: u32,
    color_size: u32,
    transmission: f32,
    pad: u32,
}

struct type_50 {
    member: array<abi_Material>,
}

struct u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_ {
    unnamed: lt_bvh_traverse_Tree,
    unnamed_1: lt_bvh_traverse_Tree,
}

struct lt_bvh_triangle_Intersection {
    t: f32,
    u: f32,
    v: f32,
    is_hit: bool,
}

struct texture_TexelQuad {
    indices: array<u32, 4>,
    weights: vec4<f32>,
}

struct texture_Axis {
    low: u32,
    high: u32,
    fraction: f32,
}

struct lt_bvh_Instance {
    world_to_object: array<vec4<f32>, 3>,
    object_to_world: array<vec4<f32>, 3>,
    low_world: vec3<f32>,
    root: u32,
    high_world: vec3<f32>,
    first_triangle: u32,
    source: u32,
    padding: array<u32, 3>,
}

struct type_64 {
    member: array<lt_bvh_Instance>,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_17;
@group(0) @binding(0) 
var<uniform> p: type_33;
@group(0) @binding(2) 
var<storage> nodes: type_38;
@group(0) @binding(3) 
var<storage> triangles: type_42;
@group(0) @binding(5) 
var<storage> list: type_13;
@group(0) @binding(6) 
var<storage, read_write> bits: type_13;
@group(0) @binding(7) 
var<storage> instances: type_64;
@group(0) @binding(8) 
var<storage> vertices: type_46;
@group(0) @binding(9) 
var<storage> materials: type_50;
@group(0) @binding(10) 
var<storage> alpha_texels: type_13;

fn core_intrinsics_maximum_number_nsz_f32_(param: f32, param_1: f32) -> f32 {
    var phi_209_: bool;
    var phi_213_: f32;

    if (param != param) {
        phi_209_ = true;
    } else {
        let _e70 = (param_1 >= param);
        if _e70 {
        }
        phi_209_ = _e70;
    }
    let _e72 = phi_209_;
    if _e72 {
        phi_213_ = param_1;
    } else {
        phi_213_ = param;
    }
    let _e74 = phi_213_;
    return _e74;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_2: f32, param_3: f32) -> f32 {
    var phi_225_: bool;
    var phi_229_: f32;

    if (param_2 != param_2) {
        phi_225_ = true;
    } else {
        let _e70 = (param_3 <= param_2);
        if _e70 {
        }
        phi_225_ = _e70;
    }
    let _e72 = phi_225_;
    if _e72 {
        phi_229_ = param_3;
    } else {
        phi_229_ = param_2;
    }
    let _e74 = phi_229_;
    return _e74;
}

fn _lt_shaders_texture_TextureView_quad(param_4: ptr<function, texture_TextureView>, param_5: f32, param_6: f32) -> texture_TexelQuad {
    var phi_271_: f32;
    var phi_276_: f32;
    var phi_277_: bool;
    var phi_278_: f32;
    var phi_279_: bool;
    var phi_283_: f32;
    var phi_309_: f32;
    var phi_314_: f32;
    var phi_315_: bool;
    var phi_316_: f32;
    var phi_317_: bool;
    var phi_321_: f32;
    var phi_329_: f32;
    var phi_330_: f32;
    var phi_331_: f32;
    var phi_340_: f32;
    var phi_341_: f32;
    var phi_359_: u32;
    var phi_373_: u32;
    var phi_380_: u32;
    var phi_385_: u32;
    var phi_391_: u32;
    var phi_396_: u32;
    var phi_398_: texture_Axis;
    var phi_426_: f32;
    var phi_431_: f32;
    var phi_432_: bool;
    var phi_433_: f32;
    var phi_434_: bool;
    var phi_438_: f32;
    var phi_464_: f32;
    var phi_469_: f32;
    var phi_470_: bool;
    var phi_471_: f32;
    var phi_472_: bool;
    var phi_476_: f32;
    var phi_484_: f32;
    var phi_485_: f32;
    var phi_486_: f32;
    var phi_495_: f32;
    var phi_496_: f32;
    var phi_514_: u32;
    var phi_528_: u32;
    var phi_535_: u32;
    var phi_540_: u32;
    var phi_546_: u32;
    var phi_551_: u32;
    var phi_553_: texture_Axis;

    let _e71 = (*param_4).size;
    let _e72 = (_e71 & 65535u);
    let _e74 = (*param_4).size;
    let _e76 = (_e74 >> bitcast<u32>(16i));
    let _e78 = (*param_4).flags;
    let _e80 = ((_e78 & 4u) != 0u);
    let _e82 = (*param_4).flags;
    let _e85 = ((_e82 >> bitcast<u32>(4u)) & 3u);
    if (_e85 == 0u) {
        if (param_5 > -8388608f) {
            let _e98 = f32(select(0i, select(select(i32(param_5), i32(-2147483648), (param_5 < bitcast<f32>(3472883712u))), 2147483647i, (param_5 > bitcast<f32>(1325400063u))), (param_5 == param_5)));
            if (_e98 > param_5) {
                phi_271_ = 1f;
            } else {
                phi_271_ = 0f;
            }
            let _e101 = phi_271_;
            if (param_5 < 8388608f) {
                phi_276_ = (_e98 - _e101);
                phi_277_ = false;
            } else {
                phi_276_ = f32();
                phi_277_ = true;
            }
            let _e104 = phi_276_;
            let _e106 = phi_277_;
            phi_278_ = _e104;
            phi_279_ = _e106;
        } else {
            phi_278_ = f32();
            phi_279_ = true;
        }
        let _e108 = phi_278_;
        let _e110 = phi_279_;
        if _e110 {
            phi_283_ = param_5;
        } else {
            phi_283_ = _e108;
        }
        let _e112 = phi_283_;
        phi_331_ = (param_5 - _e112);
    } else {
        if (_e85 == 1u) {
            let _e115 = (param_5 * 0.5f);
            if (_e115 > -8388608f) {
                let _e127 = f32(select(0i, select(select(i32(_e115), i32(-2147483648), (_e115 < bitcast<f32>(3472883712u))), 2147483647i, (_e115 > bitcast<f32>(1325400063u))), (_e115 == _e115)));
                if (_e127 > _e115) {
                    phi_309_ = 1f;
                } else {
                    phi_309_ = 0f;
                }
                let _e130 = phi_309_;
                if (_e115 < 8388608f) {
                    phi_314_ = (_e127 - _e130);
                    phi_315_ = false;
                } else {
                    phi_314_ = f32();
                    phi_315_ = true;
                }
                let _e133 = phi_314_;
                let _e135 = phi_315_;
                phi_316_ = _e133;
                phi_317_ = _e135;
            } else {
                phi_316_ = f32();
                phi_317_ = true;
            }
            let _e137 = phi_316_;
            let _e139 = phi_317_;
            if _e139 {
                phi_321_ = _e115;
            } else {
                phi_321_ = _e137;
            }
            let _e141 = phi_321_;
            let _e143 = (param_5 - (2f * _e141));
            if (_e143 > 1f) {
                phi_329_ = (2f - _e143);
            } else {
                phi_329_ = _e143;
            }
            let _e147 = phi_329_;
            phi_330_ = _e147;
        } else {
            phi_330_ = param_5;
        }
        let _e149 = phi_330_;
        phi_331_ = _e149;
    }
    let _e151 = phi_331_;
    if (_e151 > 0f) {
        if (_e151 < 1f) {
            phi_340_ = _e151;
        } else {
            phi_340_ = 1f;
        }
        let _e155 = phi_340_;
        phi_341_ = _e155;
    } else {
        phi_341_ = 0f;
    }
    let _e157 = phi_341_;
    let _e158 = (_e72 - 1u);
    let _e160 = (_e157 * f32(_e72));
    if _e80 {
        let _e167 = select(select(u32(_e160), 0u, (_e160 < bitcast<f32>(0u))), 4294967295u, (_e160 > bitcast<f32>(1333788671u)));
        if (_e158 < _e167) {
            phi_359_ = _e158;
        } else {
            phi_359_ = _e167;
        }
        let _e170 = phi_359_;
        phi_398_ = texture_Axis(_e170, _e170, 0f);
    } else {
        let _e172 = (_e160 + 0.5f);
        let _e179 = select(select(u32(_e172), 0u, (_e172 < bitcast<f32>(0u))), 4294967295u, (_e172 > bitcast<f32>(1333788671u)));
        if (_e72 < _e179) {
            phi_373_ = _e72;
        } else {
            phi_373_ = _e179;
        }
        let _e182 = phi_373_;
        if (_e85 == 0u) {
            phi_380_ = _e158;
        } else {
            phi_380_ = 0u;
        }
        let _e187 = phi_380_;
        if (_e85 == 0u) {
            phi_385_ = 0u;
        } else {
            phi_385_ = _e158;
        }
        let _e190 = phi_385_;
        if (_e182 == 0u) {
            phi_391_ = _e187;
        } else {
            phi_391_ = (_e182 - 1u);
        }
        let _e194 = phi_391_;
        if (_e182 > _e158) {
            phi_396_ = _e190;
        } else {
            phi_396_ = _e182;
        }
        let _e197 = phi_396_;
        phi_398_ = texture_Axis(_e194, _e197, (_e172 - f32(_e182)));
    }
    let _e200 = phi_398_;
    let _e202 = (*param_4).flags;
    let _e205 = ((_e202 >> bitcast<u32>(6u)) & 3u);
    if (_e205 == 0u) {
        if (param_6 > -8388608f) {
            let _e218 = f32(select(0i, select(select(i32(param_6), i32(-2147483648), (param_6 < bitcast<f32>(3472883712u))), 2147483647i, (param_6 > bitcast<f32>(1325400063u))), (param_6 == param_6)));
            if (_e218 > param_6) {
                phi_426_ = 1f;
            } else {
                phi_426_ = 0f;
            }
            let _e221 = phi_426_;
            if (param_6 < 8388608f) {
                phi_431_ = (_e218 - _e221);
                phi_432_ = false;
            } else {
                phi_431_ = f32();
                phi_432_ = true;
            }
            let _e224 = phi_431_;
            let _e226 = phi_432_;
            phi_433_ = _e224;
            phi_434_ = _e226;
        } else {
            phi_433_ = f32();
            phi_434_ = true;
        }
        let _e228 = phi_433_;
        let _e230 = phi_434_;
        if _e230 {
            phi_438_ = param_6;
        } else {
            phi_438_ = _e228;
        }
        let _e232 = phi_438_;
        phi_486_ = (param_6 - _e232);
    } else {
        if (_e205 == 1u) {
            let _e235 = (param_6 * 0.5f);
            if (_e235 > -8388608f) {
                let _e247 = f32(select(0i, select(select(i32(_e235), i32(-2147483648), (_e235 < bitcast<f32>(3472883712u))), 2147483647i, (_e235 > bitcast<f32>(1325400063u))), (_e235 == _e235)));
                if (_e247 > _e235) {
                    phi_464_ = 1f;
                } else {
                    phi_464_ = 0f;
                }
                let _e250 = phi_464_;
                if (_e235 < 8388608f) {
                    phi_469_ = (_e247 - _e250);
                    phi_470_ = false;
                } else {
                    phi_469_ = f32();
                    phi_470_ = true;
                }
                let _e253 = phi_469_;
                let _e255 = phi_470_;
                phi_471_ = _e253;
                phi_472_ = _e255;
            } else {
                phi_471_ = f32();
                phi_472_ = true;
            }
            let _e257 = phi_471_;
            let _e259 = phi_472_;
            if _e259 {
                phi_476_ = _e235;
            } else {
                phi_476_ = _e257;
            }
            let _e261 = phi_476_;
            let _e263 = (param_6 - (2f * _e261));
            if (_e263 > 1f) {
                phi_484_ = (2f - _e263);
            } else {
                phi_484_ = _e263;
            }
            let _e267 = phi_484_;
            phi_485_ = _e267;
        } else {
            phi_485_ = param_6;
        }
        let _e269 = phi_485_;
        phi_486_ = _e269;
    }
    let _e271 = phi_486_;
    if (_e271 > 0f) {
        if (_e271 < 1f) {
            phi_495_ = _e271;
        } else {
            phi_495_ = 1f;
        }
        let _e275 = phi_495_;
        phi_496_ = _e275;
    } else {
        phi_496_ = 0f;
    }
    let _e277 = phi_496_;
    let _e278 = (_e76 - 1u);
    let _e280 = (_e277 * f32(_e76));
    if _e80 {
        let _e287 = select(select(u32(_e280), 0u, (_e280 < bitcast<f32>(0u))), 4294967295u, (_e280 > bitcast<f32>(1333788671u)));
        if (_e278 < _e287) {
            phi_514_ = _e278;
        } else {
            phi_514_ = _e287;
        }
        let _e290 = phi_514_;
        phi_553_ = texture_Axis(_e290, _e290, 0f);
    } else {
        let _e292 = (_e280 + 0.5f);
        let _e299 = select(select(u32(_e292), 0u, (_e292 < bitcast<f32>(0u))), 4294967295u, (_e292 > bitcast<f32>(1333788671u)));
        if (_e76 < _e299) {
            phi_528_ = _e76;
        } else {
            phi_528_ = _e299;
        }
        let _e302 = phi_528_;
        if (_e205 == 0u) {
            phi_535_ = _e278;
        } else {
            phi_535_ = 0u;
        }
        let _e307 = phi_535_;
        if (_e205 == 0u) {
            phi_540_ = 0u;
        } else {
            phi_540_ = _e278;
        }
        let _e310 = phi_540_;
        if (_e302 == 0u) {
            phi_546_ = _e307;
        } else {
            phi_546_ = (_e302 - 1u);
        }
        let _e314 = phi_546_;
        if (_e302 > _e278) {
            phi_551_ = _e310;
        } else {
            phi_551_ = _e302;
        }
        let _e317 = phi_551_;
        phi_553_ = texture_Axis(_e314, _e317, (_e292 - f32(_e302)));
    }
    let _e320 = phi_553_;
    let _e324 = (*param_4).offset;
    let _e331 = (*param_4).offset;
    let _e338 = (*param_4).offset;
    let _e345 = (*param_4).offset;
    return texture_TexelQuad(array<u32, 4>(((_e324 + (_e320.low * _e72)) + _e200.low), ((_e331 + (_e320.low * _e72)) + _e200.high), ((_e338 + (_e320.high * _e72)) + _e200.low), ((_e345 + (_e320.high * _e72)) + _e200.high)), vec4<f32>(((1f - _e200.fraction) * (1f - _e320.fraction)), (_e200.fraction * (1f - _e320.fraction)), ((1f - _e200.fraction) * _e320.fraction), (_e200.fraction * _e320.fraction)));
}

fn function_() {
    var local: texture_TextureView;
    var local_1: lt_bvh_traverse_Stack;
    var local_2: lt_bvh_traverse_Stack;
    var phi_701_: f32;
    var phi_757_: bool;
    var phi_758_: bool;
    var phi_759_: bool;
    var phi_763_: bool;
    var phi_764_: bool;
    var phi_765_: bool;
    var phi_766_: bool;
    var phi_767_: bool;
    var phi_768_: bool;
    var phi_769_: bool;
    var phi_770_: bool;
    var phi_771_: bool;
    var phi_772_: bool;
    var phi_773_: bool;
    var phi_774_: bool;
    var phi_775_: bool;
    var phi_776_: bool;
    var phi_777_: bool;
    var phi_778_: bool;
    var phi_779_: bool;
    var phi_780_: bool;
    var phi_784_: bool;
    var phi_788_: bool;
    var phi_858_: f32;
    var phi_865_: f32;
    var phi_872_: f32;
    var phi_879_: f32;
    var phi_886_: f32;
    var phi_893_: f32;
    var phi_910_: f32;
    var phi_915_: f32;
    var phi_920_: f32;
    var phi_941_: u32;
    var phi_946_: u32;
    var phi_951_: u32;
    var phi_1065_: bool;
    var phi_1066_: bool;
    var phi_1097_: u32;
    var phi_1099_: u32;
    var phi_1102_: bool;
    var phi_1182_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1209_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1236_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1242_: u32;
    var phi_1245_: u32;
    var phi_1259_: u32;
    var phi_1269_: u32;
    var phi_1279_: u32;
    var phi_1297_: u32;
    var phi_1307_: u32;
    var phi_1317_: u32;
    var phi_1353_: u32;
    var phi_1366_: u32;
    var phi_1371_: u32;
    var phi_1372_: u32;
    var phi_1373_: u32;
    var phi_1243_: u32;
    var phi_1246_: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_1431_: u32;
    var phi_1434_: bool;
    var phi_1483_: f32;
    var phi_1488_: f32;
    var phi_1493_: f32;
    var phi_1501_: f32;
    var phi_1506_: f32;
    var phi_1511_: f32;
    var phi_1655_: bool;
    var phi_1656_: bool;
    var phi_1657_: bool;
    var phi_1661_: bool;
    var phi_1662_: bool;
    var phi_1663_: bool;
    var phi_1664_: bool;
    var phi_1665_: bool;
    var phi_1666_: bool;
    var phi_1667_: bool;
    var phi_1668_: bool;
    var phi_1669_: bool;
    var phi_1670_: bool;
    var phi_1671_: bool;
    var phi_1672_: bool;
    var phi_1673_: bool;
    var phi_1674_: bool;
    var phi_1675_: bool;
    var phi_1676_: bool;
    var phi_1677_: bool;
    var phi_1678_: bool;
    var phi_1682_: bool;
    var phi_1686_: bool;
    var phi_1756_: f32;
    var phi_1763_: f32;
    var phi_1770_: f32;
    var phi_1777_: f32;
    var phi_1784_: f32;
    var phi_1791_: f32;
    var phi_1808_: f32;
    var phi_1813_: f32;
    var phi_1818_: f32;
    var phi_1846_: bool;
    var phi_1847_: bool;
    var phi_1855_: u32;
    var phi_1856_: u32;
    var phi_1867_: vec3<f32>;
    var phi_1868_: vec3<f32>;
    var phi_1881_: u32;
    var phi_1886_: u32;
    var phi_1891_: u32;
    var phi_2005_: bool;
    var phi_2006_: bool;
    var phi_2037_: u32;
    var phi_2039_: u32;
    var phi_2042_: bool;
    var phi_2122_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2149_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2176_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2182_: u32;
    var phi_2185_: u32;
    var phi_2199_: u32;
    var phi_2209_: u32;
    var phi_2219_: u32;
    var phi_2237_: u32;
    var phi_2247_: u32;
    var phi_2257_: u32;
    var phi_2293_: u32;
    var phi_2306_: u32;
    var phi_2311_: u32;
    var phi_2312_: u32;
    var phi_2313_: u32;
    var phi_2183_: u32;
    var phi_2186_: u32;
    var local_6: u32;
    var local_7: u32;
    var local_8: u32;
    var phi_2371_: u32;
    var phi_2374_: bool;
    var phi_2418_: vec3<f32>;
    var phi_2419_: vec3<f32>;
    var phi_2448_: vec3<f32>;
    var phi_2449_: vec3<f32>;
    var phi_2478_: vec3<f32>;
    var phi_2479_: vec3<f32>;
    var phi_2497_: bool;
    var phi_2498_: bool;
    var phi_2502_: f32;
    var phi_2503_: f32;
    var phi_2504_: f32;
    var phi_2505_: f32;
    var phi_2513_: f32;
    var phi_2523_: bool;
    var phi_2524_: bool;
    var phi_2528_: f32;
    var phi_2529_: f32;
    var phi_2530_: f32;
    var phi_2531_: f32;
    var phi_2539_: f32;
    var phi_2549_: bool;
    var phi_2550_: bool;
    var phi_2554_: f32;
    var phi_2555_: f32;
    var phi_2556_: f32;
    var phi_2557_: f32;
    var phi_2565_: f32;
    var phi_2580_: f32;
    var phi_2581_: bool;
    var phi_2582_: f32;
    var phi_2583_: bool;
    var phi_2584_: f32;
    var phi_2585_: bool;
    var phi_2603_: f32;
    var phi_2604_: bool;
    var phi_2605_: bool;
    var phi_2606_: f32;
    var phi_2607_: bool;
    var phi_2608_: bool;
    var phi_2612_: bool;
    var phi_2613_: f32;
    var phi_2614_: bool;
    var phi_2642_: vec3<f32>;
    var phi_2643_: vec3<f32>;
    var phi_2668_: vec3<f32>;
    var phi_2669_: vec3<f32>;
    var phi_2694_: vec3<f32>;
    var phi_2695_: vec3<f32>;
    var phi_2751_: f32;
    var phi_2760_: f32;
    var phi_2769_: f32;
    var phi_2778_: f32;
    var phi_2785_: f32;
    var phi_2792_: f32;
    var phi_2805_: f32;
    var phi_2814_: f32;
    var phi_2823_: f32;
    var phi_2832_: f32;
    var phi_2839_: f32;
    var phi_2846_: f32;
    var phi_2863_: f32;
    var phi_2868_: f32;
    var phi_2873_: f32;
    var phi_2881_: f32;
    var phi_2886_: f32;
    var phi_2891_: f32;
    var phi_2903_: f32;
    var phi_2908_: f32;
    var phi_2913_: f32;
    var phi_2918_: f32;
    var phi_2923_: lt_bvh_triangle_Intersection;
    var phi_2924_: bool;
    var phi_2925_: lt_bvh_triangle_Intersection;
    var phi_2926_: bool;
    var phi_2930_: lt_bvh_triangle_Intersection;
    var phi_2931_: bool;
    var phi_2932_: lt_bvh_triangle_Intersection;
    var phi_2933_: bool;
    var phi_2934_: bool;
    var phi_2938_: bool;
    var phi_2942_: lt_bvh_triangle_Intersection;
    var phi_3156_: f32;
    var phi_3159_: bool;
    var phi_3160_: bool;
    var phi_3161_: bool;
    var phi_3165_: bool;
    var phi_3166_: bool;
    var phi_3167_: bool;
    var phi_3168_: bool;
    var phi_3169_: bool;
    var phi_3170_: bool;
    var phi_3171_: bool;
    var phi_3172_: bool;
    var phi_3173_: bool;
    var phi_3174_: bool;
    var phi_2372_: u32;
    var phi_2375_: bool;
    var phi_3178_: bool;
    var phi_3179_: bool;
    var local_9: bool;
    var phi_3221_: bool;
    var phi_3222_: bool;
    var phi_3253_: u32;
    var phi_3254_: u32;
    var phi_2040_: u32;
    var phi_2043_: bool;
    var phi_3255_: bool;
    var phi_3256_: bool;
    var phi_3257_: bool;
    var local_10: bool;
    var phi_3261_: bool;
    var phi_3265_: bool;
    var phi_3266_: bool;
    var phi_3267_: bool;
    var phi_3268_: bool;
    var phi_3272_: bool;
    var phi_3276_: bool;
    var phi_3277_: bool;
    var phi_3278_: bool;
    var phi_3279_: bool;
    var phi_3280_: bool;
    var phi_3281_: bool;
    var phi_3282_: bool;
    var phi_1432_: u32;
    var phi_1435_: bool;
    var phi_3286_: bool;
    var local_11: bool;
    var phi_3328_: bool;
    var phi_3329_: bool;
    var phi_3360_: u32;
    var phi_3361_: u32;
    var phi_1100_: u32;
    var phi_1103_: bool;
    var phi_3362_: bool;
    var phi_3363_: bool;
    var local_12: bool;
    var phi_3367_: bool;
    var phi_3371_: bool;
    var phi_3372_: bool;
    var phi_3373_: bool;
    var phi_3377_: bool;
    var phi_3378_: bool;
    var phi_3382_: bool;
    var phi_3386_: f32;
    var phi_3407_: u32;
    var phi_3422_: u32;
    var phi_3427_: u32;
    var local_13: bool;
    var local_14: bool;
    var local_15: bool;
    var local_16: bool;
    var local_17: bool;
    var local_18: bool;
    var local_19: bool;

    let _e70 = id_1;
    let _e77 = arrayLength((&nodes.member));
    let _e80 = arrayLength((&triangles.member));
    let _e83 = arrayLength((&visibility.member));
    let _e86 = arrayLength((&list.member));
    let _e89 = arrayLength((&bits.member));
    let _e95 = arrayLength((&vertices.member));
    let _e101 = arrayLength((&alpha_texels.member));
    let _e105 = ((_e70.y * 2097152u) + _e70.x);
    if (3u < _e86) {
    } else {
        return;
    }
    let _e108 = list.member[3u];
    if (_e105 < _e108) {
        let _e110 = (_e105 + 4u);
        if (_e110 < _e86) {
        } else {
            return;
        }
        let _e114 = list.member[(0u + _e110)];
        let _e116 = p.member.root;
        if (_e114 < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e122 = samples.member[(0u + _e114)].position;
        let _e124 = samples.member[(0u + _e114)].normal;
        let _e126 = samples.member[(0u + _e114)].magnitude;
        let _e128 = ((8f / 8388608f) * _e126);
        let _e136 = (_e122.x + (_e124.x * _e128));
        let _e138 = (_e122.y + (_e124.y * _e128));
        let _e140 = (_e122.z + (_e124.z * _e128));
        let _e142 = p.member.light.place;
        if (_e142.w == 0f) {
            phi_701_ = 300000000000000000000000000000000000000f;
        } else {
            phi_701_ = 1f;
        }
        let _e146 = phi_701_;
        let _e154 = (_e142.x - (_e136 * _e142.w));
        let _e155 = (_e142.y - (_e138 * _e142.w));
        let _e156 = (_e142.z - (_e140 * _e142.w));
        let _e160 = abs(_e154);
        let _e161 = abs(_e155);
        let _e162 = abs(_e156);
        if (abs(_e136) < 1000000000000000f) {
            if (abs(_e138) < 1000000000000000f) {
                if (abs(_e140) < 1000000000000000f) {
                    if (_e160 < 1000000000000000f) {
                        if (_e161 < 1000000000000000f) {
                            if (_e162 < 1000000000000000f) {
                                if (_e160 > 0f) {
                                    phi_758_ = bool();
                                    phi_759_ = true;
                                } else {
                                    let _e170 = (_e161 > 0f);
                                    if _e170 {
                                        phi_757_ = bool();
                                    } else {
                                        phi_757_ = (_e162 > 0f);
                                    }
                                    let _e173 = phi_757_;
                                    phi_758_ = _e173;
                                    phi_759_ = _e170;
                                }
                                let _e175 = phi_758_;
                                let _e177 = phi_759_;
                                if _e177 {
                                    phi_763_ = true;
                                } else {
                                    phi_763_ = _e175;
                                }
                                let _e179 = phi_763_;
                                phi_764_ = _e179;
                                phi_765_ = false;
                            } else {
                                phi_764_ = bool();
                                phi_765_ = true;
                            }
                            let _e181 = phi_764_;
                            let _e183 = phi_765_;
                            phi_766_ = _e181;
                            phi_767_ = false;
                            phi_768_ = _e183;
                        } else {
                            phi_766_ = bool();
                            phi_767_ = true;
                            phi_768_ = false;
                        }
                        let _e185 = phi_766_;
                        let _e187 = phi_767_;
                        let _e189 = phi_768_;
                        phi_769_ = _e185;
                        phi_770_ = _e187;
                        phi_771_ = _e189;
                    } else {
                        phi_769_ = bool();
                        phi_770_ = true;
                        phi_771_ = false;
                    }
                    let _e191 = phi_769_;
                    let _e193 = phi_770_;
                    let _e195 = phi_771_;
                    phi_772_ = _e191;
                    phi_773_ = _e193;
                    phi_774_ = _e195;
                } else {
                    phi_772_ = bool();
                    phi_773_ = true;
                    phi_774_ = false;
                }
                let _e197 = phi_772_;
                let _e199 = phi_773_;
                let _e201 = phi_774_;
                phi_775_ = _e197;
                phi_776_ = _e199;
                phi_777_ = _e201;
            } else {
                phi_775_ = bool();
                phi_776_ = true;
                phi_777_ = false;
            }
            let _e203 = phi_775_;
            let _e205 = phi_776_;
            let _e207 = phi_777_;
            phi_778_ = _e203;
            phi_779_ = _e205;
            phi_780_ = _e207;
        } else {
            phi_778_ = bool();
            phi_779_ = true;
            phi_780_ = false;
        }
        let _e209 = phi_778_;
        let _e211 = phi_779_;
        let _e213 = phi_780_;
        if _e211 {
            phi_784_ = true;
        } else {
            phi_784_ = _e213;
        }
        let _e215 = phi_784_;
        if _e215 {
            phi_788_ = false;
        } else {
            phi_788_ = _e209;
        }
        let _e217 = phi_788_;
        if _e217 {
            let _e218 = (_e116 >= _e77);
            if _e218 {
                phi_3371_ = false;
            } else {
                if (_e116 < _e77) {
                } else {
                    return;
                }
                let _e224 = nodes.member[(0u + _e116)].frame[0u];
                let _e228 = nodes.member[(0u + _e116)].frame[1u];
                let _e232 = nodes.member[(0u + _e116)].frame[2u];
                let _e236 = nodes.member[(0u + _e116)].frame[0u];
                let _e240 = nodes.member[(0u + _e116)].frame[1u];
                let _e244 = nodes.member[(0u + _e116)].frame[2u];
                let _e248 = nodes.member[(0u + _e116)].frame[3u];
                let _e282 = core_intrinsics_maximum_number_nsz_f32_(abs(_e154), abs(_e155));
                let _e283 = core_intrinsics_maximum_number_nsz_f32_(_e282, abs(_e156));
                let _e284 = (_e283 * 0.0000000000009094947f);
                if (abs(_e154) < _e284) {
                    phi_858_ = _e284;
                } else {
                    phi_858_ = abs(_e154);
                }
                let _e289 = phi_858_;
                if (_e154 < 0f) {
                    phi_865_ = (-1f / _e289);
                } else {
                    phi_865_ = (1f / _e289);
                }
                let _e294 = phi_865_;
                if (abs(_e155) < _e284) {
                    phi_872_ = _e284;
                } else {
                    phi_872_ = abs(_e155);
                }
                let _e299 = phi_872_;
                if (_e155 < 0f) {
                    phi_879_ = (-1f / _e299);
                } else {
                    phi_879_ = (1f / _e299);
                }
                let _e304 = phi_879_;
                if (abs(_e156) < _e284) {
                    phi_886_ = _e284;
                } else {
                    phi_886_ = abs(_e156);
                }
                let _e309 = phi_886_;
                if (_e156 < 0f) {
                    phi_893_ = (-1f / _e309);
                } else {
                    phi_893_ = (1f / _e309);
                }
                let _e314 = phi_893_;
                let _e318 = abs((bitcast<f32>(_e224) - _e136));
                let _e319 = abs((bitcast<f32>(_e228) - _e138));
                let _e320 = abs((bitcast<f32>(_e232) - _e140));
                let _e324 = abs(((bitcast<f32>(_e236) + (bitcast<f32>((((_e248 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e136));
                let _e325 = abs(((bitcast<f32>(_e240) + (bitcast<f32>((((_e248 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e138));
                let _e326 = abs(((bitcast<f32>(_e244) + (bitcast<f32>((((_e248 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e140));
                if (_e318 > _e324) {
                    phi_910_ = _e318;
                } else {
                    phi_910_ = _e324;
                }
                let _e329 = phi_910_;
                if (_e319 > _e325) {
                    phi_915_ = _e319;
                } else {
                    phi_915_ = _e325;
                }
                let _e332 = phi_915_;
                if (_e320 > _e326) {
                    phi_920_ = _e320;
                } else {
                    phi_920_ = _e326;
                }
                let _e335 = phi_920_;
                let _e336 = core_intrinsics_maximum_number_nsz_f32_(_e329, _e332);
                let _e337 = core_intrinsics_maximum_number_nsz_f32_(_e336, _e335);
                let _e341 = (_e337 * 0.0000019073486f);
                let _e342 = (abs(_e294) * _e341);
                let _e343 = (abs(_e304) * _e341);
                let _e344 = (abs(_e314) * _e341);
                let _e348 = (_e337 * 0.0000009536743f);
                let _e349 = (abs(_e294) * _e348);
                let _e350 = (abs(_e304) * _e348);
                let _e351 = (abs(_e314) * _e348);
                if (_e294 < 0f) {
                    phi_941_ = 0u;
                } else {
                    phi_941_ = 1u;
                }
                let _e354 = phi_941_;
                if (_e304 < 0f) {
                    phi_946_ = 0u;
                } else {
                    phi_946_ = 2u;
                }
                let _e357 = phi_946_;
                if (_e314 < 0f) {
                    phi_951_ = 0u;
                } else {
                    phi_951_ = 4u;
                }
                let _e360 = phi_951_;
                let _e362 = ((_e354 | _e357) | _e360);
                let _e363 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e116, 2147483648u);
                local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e363.first[0], _e363.first[1], _e363.first[2], _e363.first[3], _e363.first[4], _e363.first[5], _e363.first[6], _e363.first[7], _e363.first[8], _e363.first[9], _e363.first[10], _e363.first[11], _e363.first[12], _e363.first[13], _e363.first[14], _e363.first[15], _e363.first[16], _e363.first[17], _e363.first[18], _e363.first[19], _e363.first[20], _e363.first[21], _e363.first[22], _e363.first[23], _e363.first[24], _e363.first[25], _e363.first[26], _e363.first[27], _e363.first[28], _e363.first[29], _e363.first[30], _e363.first[31]), array<u32, 32>(_e363.mask[0], _e363.mask[1], _e363.mask[2], _e363.mask[3], _e363.mask[4], _e363.mask[5], _e363.mask[6], _e363.mask[7], _e363.mask[8], _e363.mask[9], _e363.mask[10], _e363.mask[11], _e363.mask[12], _e363.mask[13], _e363.mask[14], _e363.mask[15], _e363.mask[16], _e363.mask[17], _e363.mask[18], _e363.mask[19], _e363.mask[20], _e363.mask[21], _e363.mask[22], _e363.mask[23], _e363.mask[24], _e363.mask[25], _e363.mask[26], _e363.mask[27], _e363.mask[28], _e363.mask[29], _e363.mask[30], _e363.mask[31]), _e363.len, _e363.group, _e363.group_mask);
                let _e437 = local_2.group_mask;
                if ((_e437 & 4278190080u) == 0u) {
                    let _e441 = local_2.len;
                    if (_e441 == 0u) {
                        phi_1065_ = false;
                    } else {
                        let _e445 = local_2.len;
                        local_2.len = (_e445 - 1u);
                        let _e448 = local_2.len;
                        if (_e448 < 32u) {
                        } else {
                            return;
                        }
                        let _e453 = local_2.first[(0u + _e448)];
                        local_2.group = _e453;
                        let _e456 = local_2.len;
                        if (_e456 < 32u) {
                        } else {
                            return;
                        }
                        let _e461 = local_2.mask[(0u + _e456)];
                        local_2.group_mask = _e461;
                        phi_1065_ = true;
                    }
                    let _e464 = phi_1065_;
                    phi_1066_ = _e464;
                } else {
                    phi_1066_ = true;
                }
                let _e466 = phi_1066_;
                if _e466 {
                    let _e468 = local_2.group_mask;
                    let _e474 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e468)), 32u, (_e468 == 0u)));
                    let _e478 = local_2.group_mask;
                    let _e492 = local_2.group_mask;
                    local_2.group_mask = (_e492 & ~((1u << bitcast<u32>((_e474 & 31u)))));
                    let _e495 = local_2.group;
                    phi_1097_ = (_e495 + countOneBits(((_e478 & ~((4294967295u << bitcast<u32>((((_e474 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1097_ = 4294967295u;
                }
                let _e498 = phi_1097_;
                phi_1099_ = _e498;
                phi_1102_ = false;
                loop {
                    let _e500 = phi_1099_;
                    let _e502 = phi_1102_;
                    if (_e500 != 4294967295u) {
                        if (_e500 < _e77) {
                        } else {
                            return;
                        }
                        let _e509 = nodes.member[(0u + _e500)].frame[3u];
                        let _e534 = (bitcast<f32>((((_e509 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e294);
                        let _e535 = (bitcast<f32>((((_e509 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e304);
                        let _e536 = (bitcast<f32>((((_e509 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e314);
                        let _e539 = nodes.member[(0u + _e500)].frame[0u];
                        let _e543 = nodes.member[(0u + _e500)].frame[1u];
                        let _e547 = nodes.member[(0u + _e500)].frame[2u];
                        let _e552 = ((bitcast<f32>(_e539) - _e136) * _e294);
                        let _e553 = ((bitcast<f32>(_e543) - _e138) * _e304);
                        let _e554 = ((bitcast<f32>(_e547) - _e140) * _e314);
                        let _e562 = nodes.member[(0u + _e500)].x;
                        if (_e294 < 0f) {
                            let _e573 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e562.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e579 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e573.unnamed.root, _e562.w), _e573.unnamed_1);
                            let _e585 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e579.unnamed, lt_bvh_traverse_Tree(_e562.x, _e579.unnamed_1.first_primitive));
                            phi_1182_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e585.unnamed, lt_bvh_traverse_Tree(_e585.unnamed_1.root, _e562.y));
                        } else {
                            let _e601 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e562.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e607 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e601.unnamed.root, _e562.y), _e601.unnamed_1);
                            let _e613 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e607.unnamed, lt_bvh_traverse_Tree(_e562.z, _e607.unnamed_1.first_primitive));
                            phi_1182_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e613.unnamed, lt_bvh_traverse_Tree(_e613.unnamed_1.root, _e562.w));
                        }
                        let _e621 = phi_1182_;
                        let _e631 = nodes.member[(0u + _e500)].y;
                        if (_e304 < 0f) {
                            let _e642 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e631.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e648 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e642.unnamed.root, _e631.w), _e642.unnamed_1);
                            let _e654 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e648.unnamed, lt_bvh_traverse_Tree(_e631.x, _e648.unnamed_1.first_primitive));
                            phi_1209_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e654.unnamed, lt_bvh_traverse_Tree(_e654.unnamed_1.root, _e631.y));
                        } else {
                            let _e670 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e631.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e676 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e670.unnamed.root, _e631.y), _e670.unnamed_1);
                            let _e682 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e676.unnamed, lt_bvh_traverse_Tree(_e631.z, _e676.unnamed_1.first_primitive));
                            phi_1209_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e682.unnamed, lt_bvh_traverse_Tree(_e682.unnamed_1.root, _e631.w));
                        }
                        let _e690 = phi_1209_;
                        let _e700 = nodes.member[(0u + _e500)].z;
                        if (_e314 < 0f) {
                            let _e711 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e700.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e717 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e711.unnamed.root, _e700.w), _e711.unnamed_1);
                            let _e723 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e717.unnamed, lt_bvh_traverse_Tree(_e700.x, _e717.unnamed_1.first_primitive));
                            phi_1236_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e723.unnamed, lt_bvh_traverse_Tree(_e723.unnamed_1.root, _e700.y));
                        } else {
                            let _e739 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e700.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e745 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e739.unnamed.root, _e700.y), _e739.unnamed_1);
                            let _e751 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e745.unnamed, lt_bvh_traverse_Tree(_e700.z, _e745.unnamed_1.first_primitive));
                            phi_1236_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e751.unnamed, lt_bvh_traverse_Tree(_e751.unnamed_1.root, _e700.w));
                        }
                        let _e759 = phi_1236_;
                        phi_1242_ = 0u;
                        phi_1245_ = 0u;
                        loop {
                            let _e769 = phi_1242_;
                            let _e771 = phi_1245_;
                            local_3 = _e771;
                            local_4 = _e771;
                            local_5 = _e771;
                            let _e772 = (_e769 < 8u);
                            if _e772 {
                                let _e774 = (_e769 >> bitcast<u32>(2i));
                                let _e775 = (_e769 & 3u);
                                if (_e774 == 0u) {
                                    phi_1259_ = _e621.unnamed.root;
                                } else {
                                    phi_1259_ = _e621.unnamed.first_primitive;
                                }
                                let _e778 = phi_1259_;
                                if (_e774 == 0u) {
                                    phi_1269_ = _e690.unnamed.root;
                                } else {
                                    phi_1269_ = _e690.unnamed.first_primitive;
                                }
                                let _e787 = phi_1269_;
                                if (_e774 == 0u) {
                                    phi_1279_ = _e759.unnamed.root;
                                } else {
                                    phi_1279_ = _e759.unnamed.first_primitive;
                                }
                                let _e796 = phi_1279_;
                                let _e809 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e778 >> bitcast<u32>(((_e775 * 8u) & 31u))) & 255u)) * _e534) + (_e552 - _e342)), ((f32(((_e787 >> bitcast<u32>(((_e775 * 8u) & 31u))) & 255u)) * _e535) + (_e553 - _e343)));
                                let _e810 = core_intrinsics_maximum_number_nsz_f32_(_e809, ((f32(((_e796 >> bitcast<u32>(((_e775 * 8u) & 31u))) & 255u)) * _e536) + (_e554 - _e344)));
                                if (_e774 == 0u) {
                                    phi_1297_ = _e621.unnamed_1.root;
                                } else {
                                    phi_1297_ = _e621.unnamed_1.first_primitive;
                                }
                                let _e813 = phi_1297_;
                                if (_e774 == 0u) {
                                    phi_1307_ = _e690.unnamed_1.root;
                                } else {
                                    phi_1307_ = _e690.unnamed_1.first_primitive;
                                }
                                let _e822 = phi_1307_;
                                if (_e774 == 0u) {
                                    phi_1317_ = _e759.unnamed_1.root;
                                } else {
                                    phi_1317_ = _e759.unnamed_1.first_primitive;
                                }
                                let _e831 = phi_1317_;
                                let _e844 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e813 >> bitcast<u32>(((_e775 * 8u) & 31u))) & 255u)) * _e534) + (_e552 + _e342)), ((f32(((_e822 >> bitcast<u32>(((_e775 * 8u) & 31u))) & 255u)) * _e535) + (_e553 + _e343)));
                                let _e845 = core_intrinsics_minimum_number_nsz_f32_(_e844, ((f32(((_e831 >> bitcast<u32>(((_e775 * 8u) & 31u))) & 255u)) * _e536) + (_e554 + _e344)));
                                if (_e810 <= _e845) {
                                    if (_e810 <= _e146) {
                                        if (_e845 >= 0f) {
                                            if (_e774 == 0u) {
                                                let _e852 = nodes.member[(0u + _e500)].links[2u];
                                                phi_1353_ = _e852;
                                            } else {
                                                let _e855 = nodes.member[(0u + _e500)].links[3u];
                                                phi_1353_ = _e855;
                                            }
                                            let _e857 = phi_1353_;
                                            let _e862 = ((_e857 >> bitcast<u32>(((_e775 * 8u) & 31u))) & 255u);
                                            let _e863 = (_e862 & 31u);
                                            if (_e863 >= 24u) {
                                                phi_1366_ = (24u + ((_e863 - 24u) ^ _e362));
                                            } else {
                                                phi_1366_ = _e863;
                                            }
                                            let _e869 = phi_1366_;
                                            phi_1371_ = (_e771 | ((_e862 >> bitcast<u32>(5i)) << bitcast<u32>((_e869 & 31u))));
                                        } else {
                                            phi_1371_ = _e771;
                                        }
                                        let _e877 = phi_1371_;
                                        phi_1372_ = _e877;
                                    } else {
                                        phi_1372_ = _e771;
                                    }
                                    let _e879 = phi_1372_;
                                    phi_1373_ = _e879;
                                } else {
                                    phi_1373_ = _e771;
                                }
                                let _e881 = phi_1373_;
                                phi_1243_ = (_e769 + 1u);
                                phi_1246_ = _e881;
                            } else {
                                phi_1243_ = u32();
                                phi_1246_ = u32();
                            }
                            let _e884 = phi_1243_;
                            let _e886 = phi_1246_;
                            continue;
                            continuing {
                                phi_1242_ = _e884;
                                phi_1245_ = _e886;
                                break if !(_e772);
                            }
                        }
                        let _e890 = nodes.member[(0u + _e500)].links[0u];
                        let _e894 = nodes.member[(0u + _e500)].frame[3u];
                        let _e898 = local_3;
                        if ((_e898 & 4278190080u) == 0u) {
                        } else {
                            let _e902 = local_2.group_mask;
                            if ((_e902 & 4278190080u) == 0u) {
                            } else {
                                let _e906 = local_2.len;
                                if (_e906 < 32u) {
                                    let _e909 = local_2.group;
                                    let _e911 = local_2.len;
                                    if (_e911 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.first[(0u + _e911)] = _e909;
                                    let _e917 = local_2.group_mask;
                                    let _e919 = local_2.len;
                                    if (_e919 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.mask[(0u + _e919)] = _e917;
                                    let _e926 = local_2.len;
                                    local_2.len = (_e926 + 1u);
                                }
                            }
                            local_2.group = (_e116 + _e890);
                            let _e930 = local_4;
                            local_2.group_mask = ((_e930 & 4278190080u) | (_e894 >> bitcast<u32>(24i)));
                        }
                        let _e935 = local_5;
                        phi_1431_ = (_e935 & 16777215u);
                        phi_1434_ = _e502;
                        loop {
                            let _e938 = phi_1431_;
                            let _e940 = phi_1434_;
                            local_18 = _e940;
                            let _e941 = (_e938 == 0u);
                            local_11 = _e941;
                            local_19 = _e941;
                            if _e941 {
                                phi_1432_ = u32();
                                phi_1435_ = bool();
                                phi_3286_ = false;
                            } else {
                                let _e944 = nodes.member[(0u + _e500)].links[1u];
                                let _e948 = (_e944 + select(firstTrailingBit(_e938), 32u, (_e938 == 0u)));
                                if (_e948 < arrayLength((&instances.member))) {
                                } else {
                                    return;
                                }
                                let _e955 = instances.member[(0u + _e948)].low_world;
                                let _e957 = instances.member[(0u + _e948)].high_world;
                                let _e964 = ((_e955.x - _e136) * _e294);
                                let _e965 = ((_e955.y - _e138) * _e304);
                                let _e966 = ((_e955.z - _e140) * _e314);
                                let _e973 = ((_e957.x - _e136) * _e294);
                                let _e974 = ((_e957.y - _e138) * _e304);
                                let _e975 = ((_e957.z - _e140) * _e314);
                                if (_e964 < _e973) {
                                    phi_1483_ = _e964;
                                } else {
                                    phi_1483_ = _e973;
                                }
                                let _e978 = phi_1483_;
                                if (_e965 < _e974) {
                                    phi_1488_ = _e965;
                                } else {
                                    phi_1488_ = _e974;
                                }
                                let _e981 = phi_1488_;
                                if (_e966 < _e975) {
                                    phi_1493_ = _e966;
                                } else {
                                    phi_1493_ = _e975;
                                }
                                let _e984 = phi_1493_;
                                if (_e964 > _e973) {
                                    phi_1501_ = _e964;
                                } else {
                                    phi_1501_ = _e973;
                                }
                                let _e990 = phi_1501_;
                                if (_e965 > _e974) {
                                    phi_1506_ = _e965;
                                } else {
                                    phi_1506_ = _e974;
                                }
                                let _e993 = phi_1506_;
                                if (_e966 > _e975) {
                                    phi_1511_ = _e966;
                                } else {
                                    phi_1511_ = _e975;
                                }
                                let _e996 = phi_1511_;
                                let _e1000 = core_intrinsics_maximum_number_nsz_f32_((_e978 - _e349), (_e981 - _e350));
                                let _e1001 = core_intrinsics_maximum_number_nsz_f32_(_e1000, (_e984 - _e351));
                                let _e1002 = core_intrinsics_minimum_number_nsz_f32_((_e990 + _e349), (_e993 + _e350));
                                let _e1003 = core_intrinsics_minimum_number_nsz_f32_(_e1002, (_e996 + _e351));
                                if (_e1001 <= _e1003) {
                                    if (_e1001 <= _e146) {
                                        if (_e1003 >= 0f) {
                                            let _e1009 = instances.member[(0u + _e948)].world_to_object[0u];
                                            let _e1020 = ((((_e1009.x * _e136) + (_e1009.y * _e138)) + (_e1009.z * _e140)) + (_e1009.w * 1f));
                                            let _e1022 = instances.member[(0u + _e948)].world_to_object[1u];
                                            let _e1033 = ((((_e1022.x * _e136) + (_e1022.y * _e138)) + (_e1022.z * _e140)) + (_e1022.w * 1f));
                                            let _e1035 = instances.member[(0u + _e948)].world_to_object[2u];
                                            let _e1046 = ((((_e1035.x * _e136) + (_e1035.y * _e138)) + (_e1035.z * _e140)) + (_e1035.w * 1f));
                                            let _e1049 = instances.member[(0u + _e948)].world_to_object[0u];
                                            let _e1060 = ((((_e1049.x * _e154) + (_e1049.y * _e155)) + (_e1049.z * _e156)) + (_e1049.w * 0f));
                                            let _e1062 = instances.member[(0u + _e948)].world_to_object[1u];
                                            let _e1073 = ((((_e1062.x * _e154) + (_e1062.y * _e155)) + (_e1062.z * _e156)) + (_e1062.w * 0f));
                                            let _e1075 = instances.member[(0u + _e948)].world_to_object[2u];
                                            let _e1086 = ((((_e1075.x * _e154) + (_e1075.y * _e155)) + (_e1075.z * _e156)) + (_e1075.w * 0f));
                                            let _e1089 = instances.member[(0u + _e948)].root;
                                            let _e1091 = instances.member[(0u + _e948)].first_triangle;
                                            let _e1095 = abs(_e1060);
                                            let _e1096 = abs(_e1073);
                                            let _e1097 = abs(_e1086);
                                            if (abs(_e1020) < 1000000000000000f) {
                                                if (abs(_e1033) < 1000000000000000f) {
                                                    if (abs(_e1046) < 1000000000000000f) {
                                                        if (_e1095 < 1000000000000000f) {
                                                            if (_e1096 < 1000000000000000f) {
                                                                if (_e1097 < 1000000000000000f) {
                                                                    if (_e1095 > 0f) {
                                                                        phi_1656_ = bool();
                                                                        phi_1657_ = true;
                                                                    } else {
                                                                        let _e1105 = (_e1096 > 0f);
                                                                        if _e1105 {
                                                                            phi_1655_ = bool();
                                                                        } else {
                                                                            phi_1655_ = (_e1097 > 0f);
                                                                        }
                                                                        let _e1108 = phi_1655_;
                                                                        phi_1656_ = _e1108;
                                                                        phi_1657_ = _e1105;
                                                                    }
                                                                    let _e1110 = phi_1656_;
                                                                    let _e1112 = phi_1657_;
                                                                    if _e1112 {
                                                                        phi_1661_ = true;
                                                                    } else {
                                                                        phi_1661_ = _e1110;
                                                                    }
                                                                    let _e1114 = phi_1661_;
                                                                    phi_1662_ = _e1114;
                                                                    phi_1663_ = false;
                                                                } else {
                                                                    phi_1662_ = bool();
                                                                    phi_1663_ = true;
                                                                }
                                                                let _e1116 = phi_1662_;
                                                                let _e1118 = phi_1663_;
                                                                phi_1664_ = _e1116;
                                                                phi_1665_ = false;
                                                                phi_1666_ = _e1118;
                                                            } else {
                                                                phi_1664_ = bool();
                                                                phi_1665_ = true;
                                                                phi_1666_ = false;
                                                            }
                                                            let _e1120 = phi_1664_;
                                                            let _e1122 = phi_1665_;
                                                            let _e1124 = phi_1666_;
                                                            phi_1667_ = _e1120;
                                                            phi_1668_ = _e1122;
                                                            phi_1669_ = _e1124;
                                                        } else {
                                                            phi_1667_ = bool();
                                                            phi_1668_ = true;
                                                            phi_1669_ = false;
                                                        }
                                                        let _e1126 = phi_1667_;
                                                        let _e1128 = phi_1668_;
                                                        let _e1130 = phi_1669_;
                                                        phi_1670_ = _e1126;
                                                        phi_1671_ = _e1128;
                                                        phi_1672_ = _e1130;
                                                    } else {
                                                        phi_1670_ = bool();
                                                        phi_1671_ = true;
                                                        phi_1672_ = false;
                                                    }
                                                    let _e1132 = phi_1670_;
                                                    let _e1134 = phi_1671_;
                                                    let _e1136 = phi_1672_;
                                                    phi_1673_ = _e1132;
                                                    phi_1674_ = _e1134;
                                                    phi_1675_ = _e1136;
                                                } else {
                                                    phi_1673_ = bool();
                                                    phi_1674_ = true;
                                                    phi_1675_ = false;
                                                }
                                                let _e1138 = phi_1673_;
                                                let _e1140 = phi_1674_;
                                                let _e1142 = phi_1675_;
                                                phi_1676_ = _e1138;
                                                phi_1677_ = _e1140;
                                                phi_1678_ = _e1142;
                                            } else {
                                                phi_1676_ = bool();
                                                phi_1677_ = true;
                                                phi_1678_ = false;
                                            }
                                            let _e1144 = phi_1676_;
                                            let _e1146 = phi_1677_;
                                            let _e1148 = phi_1678_;
                                            if _e1146 {
                                                phi_1682_ = true;
                                            } else {
                                                phi_1682_ = _e1148;
                                            }
                                            let _e1150 = phi_1682_;
                                            if _e1150 {
                                                phi_1686_ = false;
                                            } else {
                                                phi_1686_ = _e1144;
                                            }
                                            let _e1152 = phi_1686_;
                                            if _e1152 {
                                                let _e1153 = (_e1089 >= _e77);
                                                if _e1153 {
                                                    phi_3266_ = bool();
                                                } else {
                                                    if (_e1089 < _e77) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1159 = nodes.member[(0u + _e1089)].frame[0u];
                                                    let _e1163 = nodes.member[(0u + _e1089)].frame[1u];
                                                    let _e1167 = nodes.member[(0u + _e1089)].frame[2u];
                                                    let _e1171 = nodes.member[(0u + _e1089)].frame[0u];
                                                    let _e1175 = nodes.member[(0u + _e1089)].frame[1u];
                                                    let _e1179 = nodes.member[(0u + _e1089)].frame[2u];
                                                    let _e1183 = nodes.member[(0u + _e1089)].frame[3u];
                                                    let _e1217 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1060), abs(_e1073));
                                                    let _e1218 = core_intrinsics_maximum_number_nsz_f32_(_e1217, abs(_e1086));
                                                    let _e1219 = (_e1218 * 0.0000000000009094947f);
                                                    if (abs(_e1060) < _e1219) {
                                                        phi_1756_ = _e1219;
                                                    } else {
                                                        phi_1756_ = abs(_e1060);
                                                    }
                                                    let _e1224 = phi_1756_;
                                                    if (_e1060 < 0f) {
                                                        phi_1763_ = (-1f / _e1224);
                                                    } else {
                                                        phi_1763_ = (1f / _e1224);
                                                    }
                                                    let _e1229 = phi_1763_;
                                                    if (abs(_e1073) < _e1219) {
                                                        phi_1770_ = _e1219;
                                                    } else {
                                                        phi_1770_ = abs(_e1073);
                                                    }
                                                    let _e1234 = phi_1770_;
                                                    if (_e1073 < 0f) {
                                                        phi_1777_ = (-1f / _e1234);
                                                    } else {
                                                        phi_1777_ = (1f / _e1234);
                                                    }
                                                    let _e1239 = phi_1777_;
                                                    if (abs(_e1086) < _e1219) {
                                                        phi_1784_ = _e1219;
                                                    } else {
                                                        phi_1784_ = abs(_e1086);
                                                    }
                                                    let _e1244 = phi_1784_;
                                                    if (_e1086 < 0f) {
                                                        phi_1791_ = (-1f / _e1244);
                                                    } else {
                                                        phi_1791_ = (1f / _e1244);
                                                    }
                                                    let _e1249 = phi_1791_;
                                                    let _e1253 = abs((bitcast<f32>(_e1159) - _e1020));
                                                    let _e1254 = abs((bitcast<f32>(_e1163) - _e1033));
                                                    let _e1255 = abs((bitcast<f32>(_e1167) - _e1046));
                                                    let _e1259 = abs(((bitcast<f32>(_e1171) + (bitcast<f32>((((_e1183 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1020));
                                                    let _e1260 = abs(((bitcast<f32>(_e1175) + (bitcast<f32>((((_e1183 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1033));
                                                    let _e1261 = abs(((bitcast<f32>(_e1179) + (bitcast<f32>((((_e1183 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1046));
                                                    if (_e1253 > _e1259) {
                                                        phi_1808_ = _e1253;
                                                    } else {
                                                        phi_1808_ = _e1259;
                                                    }
                                                    let _e1264 = phi_1808_;
                                                    if (_e1254 > _e1260) {
                                                        phi_1813_ = _e1254;
                                                    } else {
                                                        phi_1813_ = _e1260;
                                                    }
                                                    let _e1267 = phi_1813_;
                                                    if (_e1255 > _e1261) {
                                                        phi_1818_ = _e1255;
                                                    } else {
                                                        phi_1818_ = _e1261;
                                                    }
                                                    let _e1270 = phi_1818_;
                                                    let _e1271 = core_intrinsics_maximum_number_nsz_f32_(_e1264, _e1267);
                                                    let _e1272 = core_intrinsics_maximum_number_nsz_f32_(_e1271, _e1270);
                                                    let _e1276 = (_e1272 * 0.0000019073486f);
                                                    let _e1277 = (abs(_e1229) * _e1276);
                                                    let _e1278 = (abs(_e1239) * _e1276);
                                                    let _e1279 = (abs(_e1249) * _e1276);
                                                    let _e1283 = (_e1272 * 0.0000009536743f);
                                                    let _e1284 = (abs(_e1229) * _e1283);
                                                    let _e1285 = (abs(_e1239) * _e1283);
                                                    let _e1286 = (abs(_e1249) * _e1283);
                                                    let _e1287 = abs(_e1060);
                                                    let _e1288 = abs(_e1073);
                                                    let _e1289 = abs(_e1086);
                                                    if (_e1287 >= _e1288) {
                                                        if (_e1287 >= _e1289) {
                                                            phi_1846_ = false;
                                                        } else {
                                                            phi_1846_ = true;
                                                        }
                                                        let _e1293 = phi_1846_;
                                                        phi_1847_ = _e1293;
                                                    } else {
                                                        phi_1847_ = true;
                                                    }
                                                    let _e1295 = phi_1847_;
                                                    if _e1295 {
                                                        if (_e1288 >= _e1289) {
                                                            phi_1855_ = 1u;
                                                        } else {
                                                            phi_1855_ = 2u;
                                                        }
                                                        let _e1298 = phi_1855_;
                                                        phi_1856_ = _e1298;
                                                    } else {
                                                        phi_1856_ = 0u;
                                                    }
                                                    let _e1300 = phi_1856_;
                                                    if (_e1300 == 0u) {
                                                        phi_1868_ = vec3<f32>(_e1073, _e1086, _e1060);
                                                    } else {
                                                        if (_e1300 == 1u) {
                                                            phi_1867_ = vec3<f32>(_e1086, _e1060, _e1073);
                                                        } else {
                                                            phi_1867_ = vec3<f32>(_e1060, _e1073, _e1086);
                                                        }
                                                        let _e1306 = phi_1867_;
                                                        phi_1868_ = _e1306;
                                                    }
                                                    let _e1308 = phi_1868_;
                                                    let _e1311 = (_e1308.x / _e1308.z);
                                                    let _e1314 = (_e1308.y / _e1308.z);
                                                    if (_e1229 < 0f) {
                                                        phi_1881_ = 0u;
                                                    } else {
                                                        phi_1881_ = 1u;
                                                    }
                                                    let _e1319 = phi_1881_;
                                                    if (_e1239 < 0f) {
                                                        phi_1886_ = 0u;
                                                    } else {
                                                        phi_1886_ = 2u;
                                                    }
                                                    let _e1322 = phi_1886_;
                                                    if (_e1249 < 0f) {
                                                        phi_1891_ = 0u;
                                                    } else {
                                                        phi_1891_ = 4u;
                                                    }
                                                    let _e1325 = phi_1891_;
                                                    let _e1327 = ((_e1319 | _e1322) | _e1325);
                                                    let _e1328 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1089, 2147483648u);
                                                    local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e1328.first[0], _e1328.first[1], _e1328.first[2], _e1328.first[3], _e1328.first[4], _e1328.first[5], _e1328.first[6], _e1328.first[7], _e1328.first[8], _e1328.first[9], _e1328.first[10], _e1328.first[11], _e1328.first[12], _e1328.first[13], _e1328.first[14], _e1328.first[15], _e1328.first[16], _e1328.first[17], _e1328.first[18], _e1328.first[19], _e1328.first[20], _e1328.first[21], _e1328.first[22], _e1328.first[23], _e1328.first[24], _e1328.first[25], _e1328.first[26], _e1328.first[27], _e1328.first[28], _e1328.first[29], _e1328.first[30], _e1328.first[31]), array<u32, 32>(_e1328.mask[0], _e1328.mask[1], _e1328.mask[2], _e1328.mask[3], _e1328.mask[4], _e1328.mask[5], _e1328.mask[6], _e1328.mask[7], _e1328.mask[8], _e1328.mask[9], _e1328.mask[10], _e1328.mask[11], _e1328.mask[12], _e1328.mask[13], _e1328.mask[14], _e1328.mask[15], _e1328.mask[16], _e1328.mask[17], _e1328.mask[18], _e1328.mask[19], _e1328.mask[20], _e1328.mask[21], _e1328.mask[22], _e1328.mask[23], _e1328.mask[24], _e1328.mask[25], _e1328.mask[26], _e1328.mask[27], _e1328.mask[28], _e1328.mask[29], _e1328.mask[30], _e1328.mask[31]), _e1328.len, _e1328.group, _e1328.group_mask);
                                                    let _e1402 = local_1.group_mask;
                                                    if ((_e1402 & 4278190080u) == 0u) {
                                                        let _e1406 = local_1.len;
                                                        if (_e1406 == 0u) {
                                                            phi_2005_ = false;
                                                        } else {
                                                            let _e1410 = local_1.len;
                                                            local_1.len = (_e1410 - 1u);
                                                            let _e1413 = local_1.len;
                                                            if (_e1413 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1418 = local_1.first[(0u + _e1413)];
                                                            local_1.group = _e1418;
                                                            let _e1421 = local_1.len;
                                                            if (_e1421 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1426 = local_1.mask[(0u + _e1421)];
                                                            local_1.group_mask = _e1426;
                                                            phi_2005_ = true;
                                                        }
                                                        let _e1429 = phi_2005_;
                                                        phi_2006_ = _e1429;
                                                    } else {
                                                        phi_2006_ = true;
                                                    }
                                                    let _e1431 = phi_2006_;
                                                    if _e1431 {
                                                        let _e1433 = local_1.group_mask;
                                                        let _e1439 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1433)), 32u, (_e1433 == 0u)));
                                                        let _e1443 = local_1.group_mask;
                                                        let _e1457 = local_1.group_mask;
                                                        local_1.group_mask = (_e1457 & ~((1u << bitcast<u32>((_e1439 & 31u)))));
                                                        let _e1460 = local_1.group;
                                                        phi_2037_ = (_e1460 + countOneBits(((_e1443 & ~((4294967295u << bitcast<u32>((((_e1439 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_2037_ = 4294967295u;
                                                    }
                                                    let _e1463 = phi_2037_;
                                                    phi_2039_ = _e1463;
                                                    phi_2042_ = _e940;
                                                    loop {
                                                        let _e1465 = phi_2039_;
                                                        let _e1467 = phi_2042_;
                                                        local_17 = _e1467;
                                                        if (_e1465 != 4294967295u) {
                                                            if (_e1465 < _e77) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1474 = nodes.member[(0u + _e1465)].frame[3u];
                                                            let _e1499 = (bitcast<f32>((((_e1474 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1229);
                                                            let _e1500 = (bitcast<f32>((((_e1474 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1239);
                                                            let _e1501 = (bitcast<f32>((((_e1474 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1249);
                                                            let _e1504 = nodes.member[(0u + _e1465)].frame[0u];
                                                            let _e1508 = nodes.member[(0u + _e1465)].frame[1u];
                                                            let _e1512 = nodes.member[(0u + _e1465)].frame[2u];
                                                            let _e1517 = ((bitcast<f32>(_e1504) - _e1020) * _e1229);
                                                            let _e1518 = ((bitcast<f32>(_e1508) - _e1033) * _e1239);
                                                            let _e1519 = ((bitcast<f32>(_e1512) - _e1046) * _e1249);
                                                            let _e1527 = nodes.member[(0u + _e1465)].x;
                                                            if (_e1229 < 0f) {
                                                                let _e1538 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1527.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1544 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1538.unnamed.root, _e1527.w), _e1538.unnamed_1);
                                                                let _e1550 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1544.unnamed, lt_bvh_traverse_Tree(_e1527.x, _e1544.unnamed_1.first_primitive));
                                                                phi_2122_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1550.unnamed, lt_bvh_traverse_Tree(_e1550.unnamed_1.root, _e1527.y));
                                                            } else {
                                                                let _e1566 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1527.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1572 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1566.unnamed.root, _e1527.y), _e1566.unnamed_1);
                                                                let _e1578 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1572.unnamed, lt_bvh_traverse_Tree(_e1527.z, _e1572.unnamed_1.first_primitive));
                                                                phi_2122_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1578.unnamed, lt_bvh_traverse_Tree(_e1578.unnamed_1.root, _e1527.w));
                                                            }
                                                            let _e1586 = phi_2122_;
                                                            let _e1596 = nodes.member[(0u + _e1465)].y;
                                                            if (_e1239 < 0f) {
                                                                let _e1607 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1596.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1613 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1607.unnamed.root, _e1596.w), _e1607.unnamed_1);
                                                                let _e1619 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1613.unnamed, lt_bvh_traverse_Tree(_e1596.x, _e1613.unnamed_1.first_primitive));
                                                                phi_2149_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1619.unnamed, lt_bvh_traverse_Tree(_e1619.unnamed_1.root, _e1596.y));
                                                            } else {
                                                                let _e1635 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1596.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1641 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1635.unnamed.root, _e1596.y), _e1635.unnamed_1);
                                                                let _e1647 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1641.unnamed, lt_bvh_traverse_Tree(_e1596.z, _e1641.unnamed_1.first_primitive));
                                                                phi_2149_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1647.unnamed, lt_bvh_traverse_Tree(_e1647.unnamed_1.root, _e1596.w));
                                                            }
                                                            let _e1655 = phi_2149_;
                                                            let _e1665 = nodes.member[(0u + _e1465)].z;
                                                            if (_e1249 < 0f) {
                                                                let _e1676 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1665.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1682 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1676.unnamed.root, _e1665.w), _e1676.unnamed_1);
                                                                let _e1688 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1682.unnamed, lt_bvh_traverse_Tree(_e1665.x, _e1682.unnamed_1.first_primitive));
                                                                phi_2176_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1688.unnamed, lt_bvh_traverse_Tree(_e1688.unnamed_1.root, _e1665.y));
                                                            } else {
                                                                let _e1704 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1665.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1710 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1704.unnamed.root, _e1665.y), _e1704.unnamed_1);
                                                                let _e1716 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1710.unnamed, lt_bvh_traverse_Tree(_e1665.z, _e1710.unnamed_1.first_primitive));
                                                                phi_2176_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1716.unnamed, lt_bvh_traverse_Tree(_e1716.unnamed_1.root, _e1665.w));
                                                            }
                                                            let _e1724 = phi_2176_;
                                                            phi_2182_ = 0u;
                                                            phi_2185_ = 0u;
                                                            loop {
                                                                let _e1734 = phi_2182_;
                                                                let _e1736 = phi_2185_;
                                                                local_6 = _e1736;
                                                                local_7 = _e1736;
                                                                local_8 = _e1736;
                                                                let _e1737 = (_e1734 < 8u);
                                                                if _e1737 {
                                                                    let _e1739 = (_e1734 >> bitcast<u32>(2i));
                                                                    let _e1740 = (_e1734 & 3u);
                                                                    if (_e1739 == 0u) {
                                                                        phi_2199_ = _e1586.unnamed.root;
                                                                    } else {
                                                                        phi_2199_ = _e1586.unnamed.first_primitive;
                                                                    }
                                                                    let _e1743 = phi_2199_;
                                                                    if (_e1739 == 0u) {
                                                                        phi_2209_ = _e1655.unnamed.root;
                                                                    } else {
                                                                        phi_2209_ = _e1655.unnamed.first_primitive;
                                                                    }
                                                                    let _e1752 = phi_2209_;
                                                                    if (_e1739 == 0u) {
                                                                        phi_2219_ = _e1724.unnamed.root;
                                                                    } else {
                                                                        phi_2219_ = _e1724.unnamed.first_primitive;
                                                                    }
                                                                    let _e1761 = phi_2219_;
                                                                    let _e1774 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1743 >> bitcast<u32>(((_e1740 * 8u) & 31u))) & 255u)) * _e1499) + (_e1517 - _e1277)), ((f32(((_e1752 >> bitcast<u32>(((_e1740 * 8u) & 31u))) & 255u)) * _e1500) + (_e1518 - _e1278)));
                                                                    let _e1775 = core_intrinsics_maximum_number_nsz_f32_(_e1774, ((f32(((_e1761 >> bitcast<u32>(((_e1740 * 8u) & 31u))) & 255u)) * _e1501) + (_e1519 - _e1279)));
                                                                    if (_e1739 == 0u) {
                                                                        phi_2237_ = _e1586.unnamed_1.root;
                                                                    } else {
                                                                        phi_2237_ = _e1586.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1778 = phi_2237_;
                                                                    if (_e1739 == 0u) {
                                                                        phi_2247_ = _e1655.unnamed_1.root;
                                                                    } else {
                                                                        phi_2247_ = _e1655.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1787 = phi_2247_;
                                                                    if (_e1739 == 0u) {
                                                                        phi_2257_ = _e1724.unnamed_1.root;
                                                                    } else {
                                                                        phi_2257_ = _e1724.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1796 = phi_2257_;
                                                                    let _e1809 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1778 >> bitcast<u32>(((_e1740 * 8u) & 31u))) & 255u)) * _e1499) + (_e1517 + _e1277)), ((f32(((_e1787 >> bitcast<u32>(((_e1740 * 8u) & 31u))) & 255u)) * _e1500) + (_e1518 + _e1278)));
                                                                    let _e1810 = core_intrinsics_minimum_number_nsz_f32_(_e1809, ((f32(((_e1796 >> bitcast<u32>(((_e1740 * 8u) & 31u))) & 255u)) * _e1501) + (_e1519 + _e1279)));
                                                                    if (_e1775 <= _e1810) {
                                                                        if (_e1775 <= _e146) {
                                                                            if (_e1810 >= 0f) {
                                                                                if (_e1739 == 0u) {
                                                                                    let _e1817 = nodes.member[(0u + _e1465)].links[2u];
                                                                                    phi_2293_ = _e1817;
                                                                                } else {
                                                                                    let _e1820 = nodes.member[(0u + _e1465)].links[3u];
                                                                                    phi_2293_ = _e1820;
                                                                                }
                                                                                let _e1822 = phi_2293_;
                                                                                let _e1827 = ((_e1822 >> bitcast<u32>(((_e1740 * 8u) & 31u))) & 255u);
                                                                                let _e1828 = (_e1827 & 31u);
                                                                                if (_e1828 >= 24u) {
                                                                                    phi_2306_ = (24u + ((_e1828 - 24u) ^ _e1327));
                                                                                } else {
                                                                                    phi_2306_ = _e1828;
                                                                                }
                                                                                let _e1834 = phi_2306_;
                                                                                phi_2311_ = (_e1736 | ((_e1827 >> bitcast<u32>(5i)) << bitcast<u32>((_e1834 & 31u))));
                                                                            } else {
                                                                                phi_2311_ = _e1736;
                                                                            }
                                                                            let _e1842 = phi_2311_;
                                                                            phi_2312_ = _e1842;
                                                                        } else {
                                                                            phi_2312_ = _e1736;
                                                                        }
                                                                        let _e1844 = phi_2312_;
                                                                        phi_2313_ = _e1844;
                                                                    } else {
                                                                        phi_2313_ = _e1736;
                                                                    }
                                                                    let _e1846 = phi_2313_;
                                                                    phi_2183_ = (_e1734 + 1u);
                                                                    phi_2186_ = _e1846;
                                                                } else {
                                                                    phi_2183_ = u32();
                                                                    phi_2186_ = u32();
                                                                }
                                                                let _e1849 = phi_2183_;
                                                                let _e1851 = phi_2186_;
                                                                continue;
                                                                continuing {
                                                                    phi_2182_ = _e1849;
                                                                    phi_2185_ = _e1851;
                                                                    break if !(_e1737);
                                                                }
                                                            }
                                                            let _e1855 = nodes.member[(0u + _e1465)].links[0u];
                                                            let _e1859 = nodes.member[(0u + _e1465)].frame[3u];
                                                            let _e1863 = local_6;
                                                            if ((_e1863 & 4278190080u) == 0u) {
                                                            } else {
                                                                let _e1867 = local_1.group_mask;
                                                                if ((_e1867 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1871 = local_1.len;
                                                                    if (_e1871 < 32u) {
                                                                        let _e1874 = local_1.group;
                                                                        let _e1876 = local_1.len;
                                                                        if (_e1876 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_1.first[(0u + _e1876)] = _e1874;
                                                                        let _e1882 = local_1.group_mask;
                                                                        let _e1884 = local_1.len;
                                                                        if (_e1884 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_1.mask[(0u + _e1884)] = _e1882;
                                                                        let _e1891 = local_1.len;
                                                                        local_1.len = (_e1891 + 1u);
                                                                    }
                                                                }
                                                                local_1.group = (_e1089 + _e1855);
                                                                let _e1895 = local_7;
                                                                local_1.group_mask = ((_e1895 & 4278190080u) | (_e1859 >> bitcast<u32>(24i)));
                                                            }
                                                            let _e1900 = local_8;
                                                            phi_2371_ = (_e1900 & 16777215u);
                                                            phi_2374_ = _e1467;
                                                            loop {
                                                                let _e1903 = phi_2371_;
                                                                let _e1905 = phi_2374_;
                                                                local_13 = _e1905;
                                                                let _e1906 = (_e1903 == 0u);
                                                                local_9 = _e1906;
                                                                local_15 = _e1906;
                                                                if _e1906 {
                                                                    phi_2372_ = u32();
                                                                    phi_2375_ = bool();
                                                                    phi_3178_ = bool();
                                                                    phi_3179_ = false;
                                                                } else {
                                                                    let _e1909 = nodes.member[(0u + _e1465)].links[1u];
                                                                    let _e1914 = ((_e1091 + _e1909) + select(firstTrailingBit(_e1903), 32u, (_e1903 == 0u)));
                                                                    if (_e1914 < _e80) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1921 = triangles.member[(0u + _e1914)].v0_;
                                                                    let _e1923 = (_e1921.x - _e1020);
                                                                    let _e1925 = (_e1921.y - _e1033);
                                                                    let _e1927 = (_e1921.z - _e1046);
                                                                    if (_e1300 == 0u) {
                                                                        phi_2419_ = vec3<f32>(_e1925, _e1927, _e1923);
                                                                    } else {
                                                                        if (_e1300 == 1u) {
                                                                            phi_2418_ = vec3<f32>(_e1927, _e1923, _e1925);
                                                                        } else {
                                                                            phi_2418_ = (_e1921 - vec3<f32>(_e1020, _e1033, _e1046));
                                                                        }
                                                                        let _e1935 = phi_2418_;
                                                                        phi_2419_ = _e1935;
                                                                    }
                                                                    let _e1937 = phi_2419_;
                                                                    let _e1941 = (_e1937.x - (_e1311 * _e1937.z));
                                                                    let _e1945 = (_e1937.y - (_e1314 * _e1937.z));
                                                                    let _e1947 = triangles.member[(0u + _e1914)].v1_;
                                                                    let _e1949 = (_e1947.x - _e1020);
                                                                    let _e1951 = (_e1947.y - _e1033);
                                                                    let _e1953 = (_e1947.z - _e1046);
                                                                    if (_e1300 == 0u) {
                                                                        phi_2449_ = vec3<f32>(_e1951, _e1953, _e1949);
                                                                    } else {
                                                                        if (_e1300 == 1u) {
                                                                            phi_2448_ = vec3<f32>(_e1953, _e1949, _e1951);
                                                                        } else {
                                                                            phi_2448_ = (_e1947 - vec3<f32>(_e1020, _e1033, _e1046));
                                                                        }
                                                                        let _e1961 = phi_2448_;
                                                                        phi_2449_ = _e1961;
                                                                    }
                                                                    let _e1963 = phi_2449_;
                                                                    let _e1967 = (_e1963.x - (_e1311 * _e1963.z));
                                                                    let _e1971 = (_e1963.y - (_e1314 * _e1963.z));
                                                                    let _e1973 = triangles.member[(0u + _e1914)].v2_;
                                                                    let _e1975 = (_e1973.x - _e1020);
                                                                    let _e1977 = (_e1973.y - _e1033);
                                                                    let _e1979 = (_e1973.z - _e1046);
                                                                    if (_e1300 == 0u) {
                                                                        phi_2479_ = vec3<f32>(_e1977, _e1979, _e1975);
                                                                    } else {
                                                                        if (_e1300 == 1u) {
                                                                            phi_2478_ = vec3<f32>(_e1979, _e1975, _e1977);
                                                                        } else {
                                                                            phi_2478_ = (_e1973 - vec3<f32>(_e1020, _e1033, _e1046));
                                                                        }
                                                                        let _e1987 = phi_2478_;
                                                                        phi_2479_ = _e1987;
                                                                    }
                                                                    let _e1989 = phi_2479_;
                                                                    let _e1993 = (_e1989.x - (_e1311 * _e1989.z));
                                                                    let _e1997 = (_e1989.y - (_e1314 * _e1989.z));
                                                                    if (_e1967 < _e1993) {
                                                                        phi_2498_ = true;
                                                                    } else {
                                                                        if (_e1967 == _e1993) {
                                                                            phi_2497_ = (_e1971 < _e1997);
                                                                        } else {
                                                                            phi_2497_ = false;
                                                                        }
                                                                        let _e2002 = phi_2497_;
                                                                        phi_2498_ = _e2002;
                                                                    }
                                                                    let _e2004 = phi_2498_;
                                                                    if _e2004 {
                                                                        phi_2502_ = _e1997;
                                                                        phi_2503_ = _e1993;
                                                                        phi_2504_ = _e1971;
                                                                        phi_2505_ = _e1967;
                                                                    } else {
                                                                        phi_2502_ = _e1971;
                                                                        phi_2503_ = _e1967;
                                                                        phi_2504_ = _e1997;
                                                                        phi_2505_ = _e1993;
                                                                    }
                                                                    let _e2006 = phi_2502_;
                                                                    let _e2008 = phi_2503_;
                                                                    let _e2010 = phi_2504_;
                                                                    let _e2012 = phi_2505_;
                                                                    let _e2015 = ((_e2012 * _e2006) - (_e2010 * _e2008));
                                                                    if _e2004 {
                                                                        phi_2513_ = -(_e2015);
                                                                    } else {
                                                                        phi_2513_ = _e2015;
                                                                    }
                                                                    let _e2018 = phi_2513_;
                                                                    if (_e1993 < _e1941) {
                                                                        phi_2524_ = true;
                                                                    } else {
                                                                        if (_e1993 == _e1941) {
                                                                            phi_2523_ = (_e1997 < _e1945);
                                                                        } else {
                                                                            phi_2523_ = false;
                                                                        }
                                                                        let _e2023 = phi_2523_;
                                                                        phi_2524_ = _e2023;
                                                                    }
                                                                    let _e2025 = phi_2524_;
                                                                    if _e2025 {
                                                                        phi_2528_ = _e1945;
                                                                        phi_2529_ = _e1941;
                                                                        phi_2530_ = _e1997;
                                                                        phi_2531_ = _e1993;
                                                                    } else {
                                                                        phi_2528_ = _e1997;
                                                                        phi_2529_ = _e1993;
                                                                        phi_2530_ = _e1945;
                                                                        phi_2531_ = _e1941;
                                                                    }
                                                                    let _e2027 = phi_2528_;
                                                                    let _e2029 = phi_2529_;
                                                                    let _e2031 = phi_2530_;
                                                                    let _e2033 = phi_2531_;
                                                                    let _e2036 = ((_e2033 * _e2027) - (_e2031 * _e2029));
                                                                    if _e2025 {
                                                                        phi_2539_ = -(_e2036);
                                                                    } else {
                                                                        phi_2539_ = _e2036;
                                                                    }
                                                                    let _e2039 = phi_2539_;
                                                                    if (_e1941 < _e1967) {
                                                                        phi_2550_ = true;
                                                                    } else {
                                                                        if (_e1941 == _e1967) {
                                                                            phi_2549_ = (_e1945 < _e1971);
                                                                        } else {
                                                                            phi_2549_ = false;
                                                                        }
                                                                        let _e2044 = phi_2549_;
                                                                        phi_2550_ = _e2044;
                                                                    }
                                                                    let _e2046 = phi_2550_;
                                                                    if _e2046 {
                                                                        phi_2554_ = _e1971;
                                                                        phi_2555_ = _e1967;
                                                                        phi_2556_ = _e1945;
                                                                        phi_2557_ = _e1941;
                                                                    } else {
                                                                        phi_2554_ = _e1945;
                                                                        phi_2555_ = _e1941;
                                                                        phi_2556_ = _e1971;
                                                                        phi_2557_ = _e1967;
                                                                    }
                                                                    let _e2048 = phi_2554_;
                                                                    let _e2050 = phi_2555_;
                                                                    let _e2052 = phi_2556_;
                                                                    let _e2054 = phi_2557_;
                                                                    let _e2057 = ((_e2054 * _e2048) - (_e2052 * _e2050));
                                                                    if _e2046 {
                                                                        phi_2565_ = -(_e2057);
                                                                    } else {
                                                                        phi_2565_ = _e2057;
                                                                    }
                                                                    let _e2060 = phi_2565_;
                                                                    if (_e2018 >= 0f) {
                                                                        if (_e2039 >= 0f) {
                                                                            if (_e2060 >= 0f) {
                                                                                phi_2580_ = ((_e2018 + _e2039) + _e2060);
                                                                                phi_2581_ = false;
                                                                            } else {
                                                                                phi_2580_ = f32();
                                                                                phi_2581_ = true;
                                                                            }
                                                                            let _e2067 = phi_2580_;
                                                                            let _e2069 = phi_2581_;
                                                                            phi_2582_ = _e2067;
                                                                            phi_2583_ = _e2069;
                                                                        } else {
                                                                            phi_2582_ = f32();
                                                                            phi_2583_ = true;
                                                                        }
                                                                        let _e2071 = phi_2582_;
                                                                        let _e2073 = phi_2583_;
                                                                        phi_2584_ = _e2071;
                                                                        phi_2585_ = _e2073;
                                                                    } else {
                                                                        phi_2584_ = f32();
                                                                        phi_2585_ = true;
                                                                    }
                                                                    let _e2075 = phi_2584_;
                                                                    let _e2077 = phi_2585_;
                                                                    if _e2077 {
                                                                        if (_e2018 <= 0f) {
                                                                            if (_e2039 <= 0f) {
                                                                                let _e2080 = (_e2060 <= 0f);
                                                                                if _e2080 {
                                                                                }
                                                                                phi_2603_ = ((_e2018 + _e2039) + _e2060);
                                                                                phi_2604_ = false;
                                                                                phi_2605_ = _e2080;
                                                                            } else {
                                                                                phi_2603_ = f32();
                                                                                phi_2604_ = true;
                                                                                phi_2605_ = false;
                                                                            }
                                                                            let _e2084 = phi_2603_;
                                                                            let _e2086 = phi_2604_;
                                                                            let _e2088 = phi_2605_;
                                                                            phi_2606_ = _e2084;
                                                                            phi_2607_ = _e2086;
                                                                            phi_2608_ = _e2088;
                                                                        } else {
                                                                            phi_2606_ = f32();
                                                                            phi_2607_ = true;
                                                                            phi_2608_ = false;
                                                                        }
                                                                        let _e2090 = phi_2606_;
                                                                        let _e2092 = phi_2607_;
                                                                        let _e2094 = phi_2608_;
                                                                        if _e2092 {
                                                                            phi_2612_ = false;
                                                                        } else {
                                                                            phi_2612_ = _e2094;
                                                                        }
                                                                        let _e2096 = phi_2612_;
                                                                        phi_2613_ = _e2090;
                                                                        phi_2614_ = _e2096;
                                                                    } else {
                                                                        phi_2613_ = _e2075;
                                                                        phi_2614_ = true;
                                                                    }
                                                                    let _e2098 = phi_2613_;
                                                                    let _e2100 = phi_2614_;
                                                                    if _e2100 {
                                                                        let _e2101 = (_e2098 == 0f);
                                                                        if _e2101 {
                                                                            phi_2930_ = lt_bvh_triangle_Intersection();
                                                                            phi_2931_ = false;
                                                                        } else {
                                                                            let _e2103 = triangles.member[(0u + _e1914)].v0_;
                                                                            let _e2105 = (_e2103.x - _e1020);
                                                                            let _e2107 = (_e2103.y - _e1033);
                                                                            let _e2109 = (_e2103.z - _e1046);
                                                                            if (_e1300 == 0u) {
                                                                                phi_2643_ = vec3<f32>(_e2107, _e2109, _e2105);
                                                                            } else {
                                                                                if (_e1300 == 1u) {
                                                                                    phi_2642_ = vec3<f32>(_e2109, _e2105, _e2107);
                                                                                } else {
                                                                                    phi_2642_ = (_e2103 - vec3<f32>(_e1020, _e1033, _e1046));
                                                                                }
                                                                                let _e2117 = phi_2642_;
                                                                                phi_2643_ = _e2117;
                                                                            }
                                                                            let _e2119 = phi_2643_;
                                                                            let _e2121 = triangles.member[(0u + _e1914)].v1_;
                                                                            let _e2123 = triangles.member[(0u + _e1914)].v0_;
                                                                            let _e2126 = (_e2121.x - _e2123.x);
                                                                            let _e2129 = (_e2121.y - _e2123.y);
                                                                            let _e2132 = (_e2121.z - _e2123.z);
                                                                            if (_e1300 == 0u) {
                                                                                phi_2669_ = vec3<f32>(_e2129, _e2132, _e2126);
                                                                            } else {
                                                                                if (_e1300 == 1u) {
                                                                                    phi_2668_ = vec3<f32>(_e2132, _e2126, _e2129);
                                                                                } else {
                                                                                    phi_2668_ = (_e2121 - _e2123);
                                                                                }
                                                                                let _e2139 = phi_2668_;
                                                                                phi_2669_ = _e2139;
                                                                            }
                                                                            let _e2141 = phi_2669_;
                                                                            let _e2143 = triangles.member[(0u + _e1914)].v2_;
                                                                            let _e2145 = triangles.member[(0u + _e1914)].v0_;
                                                                            let _e2148 = (_e2143.x - _e2145.x);
                                                                            let _e2151 = (_e2143.y - _e2145.y);
                                                                            let _e2154 = (_e2143.z - _e2145.z);
                                                                            if (_e1300 == 0u) {
                                                                                phi_2695_ = vec3<f32>(_e2151, _e2154, _e2148);
                                                                            } else {
                                                                                if (_e1300 == 1u) {
                                                                                    phi_2694_ = vec3<f32>(_e2154, _e2148, _e2151);
                                                                                } else {
                                                                                    phi_2694_ = (_e2143 - _e2145);
                                                                                }
                                                                                let _e2161 = phi_2694_;
                                                                                phi_2695_ = _e2161;
                                                                            }
                                                                            let _e2163 = phi_2695_;
                                                                            let _e2170 = ((_e2141.y * _e2163.z) - (_e2141.z * _e2163.y));
                                                                            let _e2177 = ((_e2141.z * _e2163.x) - (_e2141.x * _e2163.z));
                                                                            let _e2184 = ((_e2141.x * _e2163.y) - (_e2141.y * _e2163.x));
                                                                            let _e2198 = (((1f / _e1308.z) * (((_e2170 * _e2119.x) + (_e2177 * _e2119.y)) + (_e2184 * _e2119.z))) / (((_e2170 * _e1311) + (_e2177 * _e1314)) + _e2184));
                                                                            if (_e2198 > 0f) {
                                                                                if (_e2198 < _e146) {
                                                                                    let _e2202 = triangles.member[(0u + _e1914)].v0_;
                                                                                    let _e2204 = triangles.member[(0u + _e1914)].v1_;
                                                                                    if (_e2202.x < _e2204.x) {
                                                                                        phi_2751_ = _e2202.x;
                                                                                    } else {
                                                                                        phi_2751_ = _e2204.x;
                                                                                    }
                                                                                    let _e2211 = phi_2751_;
                                                                                    if (_e2202.y < _e2204.y) {
                                                                                        phi_2760_ = _e2202.y;
                                                                                    } else {
                                                                                        phi_2760_ = _e2204.y;
                                                                                    }
                                                                                    let _e2218 = phi_2760_;
                                                                                    if (_e2202.z < _e2204.z) {
                                                                                        phi_2769_ = _e2202.z;
                                                                                    } else {
                                                                                        phi_2769_ = _e2204.z;
                                                                                    }
                                                                                    let _e2225 = phi_2769_;
                                                                                    let _e2227 = triangles.member[(0u + _e1914)].v2_;
                                                                                    if (_e2211 < _e2227.x) {
                                                                                        phi_2778_ = _e2211;
                                                                                    } else {
                                                                                        phi_2778_ = _e2227.x;
                                                                                    }
                                                                                    let _e2232 = phi_2778_;
                                                                                    if (_e2218 < _e2227.y) {
                                                                                        phi_2785_ = _e2218;
                                                                                    } else {
                                                                                        phi_2785_ = _e2227.y;
                                                                                    }
                                                                                    let _e2237 = phi_2785_;
                                                                                    if (_e2225 < _e2227.z) {
                                                                                        phi_2792_ = _e2225;
                                                                                    } else {
                                                                                        phi_2792_ = _e2227.z;
                                                                                    }
                                                                                    let _e2242 = phi_2792_;
                                                                                    let _e2244 = triangles.member[(0u + _e1914)].v0_;
                                                                                    let _e2246 = triangles.member[(0u + _e1914)].v1_;
                                                                                    if (_e2244.x > _e2246.x) {
                                                                                        phi_2805_ = _e2244.x;
                                                                                    } else {
                                                                                        phi_2805_ = _e2246.x;
                                                                                    }
                                                                                    let _e2253 = phi_2805_;
                                                                                    if (_e2244.y > _e2246.y) {
                                                                                        phi_2814_ = _e2244.y;
                                                                                    } else {
                                                                                        phi_2814_ = _e2246.y;
                                                                                    }
                                                                                    let _e2260 = phi_2814_;
                                                                                    if (_e2244.z > _e2246.z) {
                                                                                        phi_2823_ = _e2244.z;
                                                                                    } else {
                                                                                        phi_2823_ = _e2246.z;
                                                                                    }
                                                                                    let _e2267 = phi_2823_;
                                                                                    let _e2269 = triangles.member[(0u + _e1914)].v2_;
                                                                                    if (_e2253 > _e2269.x) {
                                                                                        phi_2832_ = _e2253;
                                                                                    } else {
                                                                                        phi_2832_ = _e2269.x;
                                                                                    }
                                                                                    let _e2274 = phi_2832_;
                                                                                    if (_e2260 > _e2269.y) {
                                                                                        phi_2839_ = _e2260;
                                                                                    } else {
                                                                                        phi_2839_ = _e2269.y;
                                                                                    }
                                                                                    let _e2279 = phi_2839_;
                                                                                    if (_e2267 > _e2269.z) {
                                                                                        phi_2846_ = _e2267;
                                                                                    } else {
                                                                                        phi_2846_ = _e2269.z;
                                                                                    }
                                                                                    let _e2284 = phi_2846_;
                                                                                    let _e2288 = ((_e2232 - _e1020) * _e1229);
                                                                                    let _e2289 = ((_e2237 - _e1033) * _e1239);
                                                                                    let _e2290 = ((_e2242 - _e1046) * _e1249);
                                                                                    let _e2294 = ((_e2274 - _e1020) * _e1229);
                                                                                    let _e2295 = ((_e2279 - _e1033) * _e1239);
                                                                                    let _e2296 = ((_e2284 - _e1046) * _e1249);
                                                                                    if (_e2288 < _e2294) {
                                                                                        phi_2863_ = _e2288;
                                                                                    } else {
                                                                                        phi_2863_ = _e2294;
                                                                                    }
                                                                                    let _e2299 = phi_2863_;
                                                                                    if (_e2289 < _e2295) {
                                                                                        phi_2868_ = _e2289;
                                                                                    } else {
                                                                                        phi_2868_ = _e2295;
                                                                                    }
                                                                                    let _e2302 = phi_2868_;
                                                                                    if (_e2290 < _e2296) {
                                                                                        phi_2873_ = _e2290;
                                                                                    } else {
                                                                                        phi_2873_ = _e2296;
                                                                                    }
                                                                                    let _e2305 = phi_2873_;
                                                                                    if (_e2288 > _e2294) {
                                                                                        phi_2881_ = _e2288;
                                                                                    } else {
                                                                                        phi_2881_ = _e2294;
                                                                                    }
                                                                                    let _e2311 = phi_2881_;
                                                                                    if (_e2289 > _e2295) {
                                                                                        phi_2886_ = _e2289;
                                                                                    } else {
                                                                                        phi_2886_ = _e2295;
                                                                                    }
                                                                                    let _e2314 = phi_2886_;
                                                                                    if (_e2290 > _e2296) {
                                                                                        phi_2891_ = _e2290;
                                                                                    } else {
                                                                                        phi_2891_ = _e2296;
                                                                                    }
                                                                                    let _e2317 = phi_2891_;
                                                                                    let _e2321 = core_intrinsics_maximum_number_nsz_f32_((_e2299 - _e1284), (_e2302 - _e1285));
                                                                                    let _e2322 = core_intrinsics_maximum_number_nsz_f32_(_e2321, (_e2305 - _e1286));
                                                                                    let _e2323 = core_intrinsics_minimum_number_nsz_f32_((_e2311 + _e1284), (_e2314 + _e1285));
                                                                                    let _e2324 = core_intrinsics_minimum_number_nsz_f32_(_e2323, (_e2317 + _e1286));
                                                                                    if (_e2322 > _e1001) {
                                                                                        phi_2903_ = _e2322;
                                                                                    } else {
                                                                                        phi_2903_ = _e1001;
                                                                                    }
                                                                                    let _e2327 = phi_2903_;
                                                                                    if (_e2324 < _e1003) {
                                                                                        phi_2908_ = _e2324;
                                                                                    } else {
                                                                                        phi_2908_ = _e1003;
                                                                                    }
                                                                                    let _e2330 = phi_2908_;
                                                                                    if (_e2198 < _e2327) {
                                                                                        phi_2913_ = _e2327;
                                                                                    } else {
                                                                                        phi_2913_ = _e2198;
                                                                                    }
                                                                                    let _e2333 = phi_2913_;
                                                                                    if (_e2333 > _e2330) {
                                                                                        phi_2918_ = _e2330;
                                                                                    } else {
                                                                                        phi_2918_ = _e2333;
                                                                                    }
                                                                                    let _e2336 = phi_2918_;
                                                                                    phi_2923_ = lt_bvh_triangle_Intersection(_e2336, (_e2039 / _e2098), (_e2060 / _e2098), (_e2327 <= _e2330));
                                                                                    phi_2924_ = false;
                                                                                } else {
                                                                                    phi_2923_ = lt_bvh_triangle_Intersection();
                                                                                    phi_2924_ = true;
                                                                                }
                                                                                let _e2342 = phi_2923_;
                                                                                let _e2344 = phi_2924_;
                                                                                phi_2925_ = _e2342;
                                                                                phi_2926_ = _e2344;
                                                                            } else {
                                                                                phi_2925_ = lt_bvh_triangle_Intersection();
                                                                                phi_2926_ = true;
                                                                            }
                                                                            let _e2346 = phi_2925_;
                                                                            let _e2348 = phi_2926_;
                                                                            if _e2348 {
                                                                            }
                                                                            phi_2930_ = _e2346;
                                                                            phi_2931_ = _e2348;
                                                                        }
                                                                        let _e2350 = phi_2930_;
                                                                        let _e2352 = phi_2931_;
                                                                        phi_2932_ = _e2350;
                                                                        phi_2933_ = _e2101;
                                                                        phi_2934_ = _e2352;
                                                                    } else {
                                                                        phi_2932_ = lt_bvh_triangle_Intersection();
                                                                        phi_2933_ = true;
                                                                        phi_2934_ = false;
                                                                    }
                                                                    let _e2354 = phi_2932_;
                                                                    let _e2356 = phi_2933_;
                                                                    let _e2358 = phi_2934_;
                                                                    if _e2356 {
                                                                        phi_2938_ = true;
                                                                    } else {
                                                                        phi_2938_ = _e2358;
                                                                    }
                                                                    let _e2360 = phi_2938_;
                                                                    if _e2360 {
                                                                        phi_2942_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_2942_ = _e2354;
                                                                    }
                                                                    let _e2362 = phi_2942_;
                                                                    if _e2362.is_hit {
                                                                        if (_e2362.t > 0f) {
                                                                            if (_e2362.t < _e146) {
                                                                                let _e2369 = triangles.member[(0u + _e1914)].i0_;
                                                                                if ((_e2369 & 2147483648u) == 0u) {
                                                                                    phi_3161_ = true;
                                                                                } else {
                                                                                    if (_e1914 < _e80) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2378 = triangles.member[(0u + _e1914)].i0_;
                                                                                    let _e2379 = (_e2378 & 2147483647u);
                                                                                    let _e2381 = triangles.member[(0u + _e1914)].i1_;
                                                                                    let _e2383 = triangles.member[(0u + _e1914)].i2_;
                                                                                    if (_e2379 < _e95) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2387 = vertices.member[(0u + _e2379)];
                                                                                    if (_e2381 < _e95) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2391 = vertices.member[(0u + _e2381)];
                                                                                    if (_e2383 < _e95) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2395 = vertices.member[(0u + _e2383)];
                                                                                    let _e2396 = array<abi_Vertex, 3>(_e2387, _e2391, _e2395);
                                                                                    if (_e2396[0].material < arrayLength((&materials.member))) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2402 = materials.member[(0u + _e2396[0].material)];
                                                                                    if ((_e2402.flags & 1u) == 1u) {
                                                                                        let _e2407 = ((1f - _e2362.u) - _e2362.v);
                                                                                        if (_e2402.cutoff <= 0f) {
                                                                                            phi_3159_ = true;
                                                                                        } else {
                                                                                            let _e2434 = (_e2402.base_color.w * ((((f32((_e2396[0].color >> bitcast<u32>(24i))) * _e2407) + (f32((_e2396[1].color >> bitcast<u32>(24i))) * _e2362.u)) + (f32((_e2396[2].color >> bitcast<u32>(24i))) * _e2362.v)) * (1f / 255f)));
                                                                                            if (_e2402.alpha_size == 0u) {
                                                                                                phi_3156_ = _e2434;
                                                                                            } else {
                                                                                                local.offset = _e2402.alpha_offset;
                                                                                                local.size = _e2402.alpha_size;
                                                                                                local.flags = _e2402.flags;
                                                                                                let _e2465 = _lt_shaders_texture_TextureView_quad((&local), (((_e2396[0].u * _e2407) + (_e2396[1].u * _e2362.u)) + (_e2396[2].u * _e2362.v)), (((_e2396[0].v * _e2407) + (_e2396[1].v * _e2362.u)) + (_e2396[2].v * _e2362.v)));
                                                                                                let _e2469 = (_e2465.indices[0] >> bitcast<u32>(2i));
                                                                                                if (_e2469 < _e101) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2473 = alpha_texels.member[(0u + _e2469)];
                                                                                                let _e2489 = (_e2465.indices[1] >> bitcast<u32>(2i));
                                                                                                if (_e2489 < _e101) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2493 = alpha_texels.member[(0u + _e2489)];
                                                                                                let _e2510 = (_e2465.indices[2] >> bitcast<u32>(2i));
                                                                                                if (_e2510 < _e101) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2514 = alpha_texels.member[(0u + _e2510)];
                                                                                                let _e2531 = (_e2465.indices[3] >> bitcast<u32>(2i));
                                                                                                if (_e2531 < _e101) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2535 = alpha_texels.member[(0u + _e2531)];
                                                                                                phi_3156_ = (_e2434 * (((((f32(((_e2473 >> bitcast<u32>((((_e2465.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2465.weights.x) + ((f32(((_e2493 >> bitcast<u32>((((_e2465.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2465.weights.y)) + ((f32(((_e2514 >> bitcast<u32>((((_e2465.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2465.weights.z)) + ((f32(((_e2535 >> bitcast<u32>((((_e2465.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2465.weights.w)));
                                                                                            }
                                                                                            let _e2551 = phi_3156_;
                                                                                            phi_3159_ = (_e2551 >= _e2402.cutoff);
                                                                                        }
                                                                                        let _e2555 = phi_3159_;
                                                                                        phi_3160_ = _e2555;
                                                                                    } else {
                                                                                        phi_3160_ = false;
                                                                                    }
                                                                                    let _e2557 = phi_3160_;
                                                                                    phi_3161_ = _e2557;
                                                                                }
                                                                                let _e2559 = phi_3161_;
                                                                                if _e2559 {
                                                                                    phi_3165_ = false;
                                                                                } else {
                                                                                    phi_3165_ = true;
                                                                                }
                                                                                let _e2561 = phi_3165_;
                                                                                phi_3166_ = _e2559;
                                                                                phi_3167_ = _e2559;
                                                                                phi_3168_ = _e2561;
                                                                            } else {
                                                                                phi_3166_ = bool();
                                                                                phi_3167_ = _e1905;
                                                                                phi_3168_ = true;
                                                                            }
                                                                            let _e2563 = phi_3166_;
                                                                            let _e2565 = phi_3167_;
                                                                            let _e2567 = phi_3168_;
                                                                            phi_3169_ = _e2563;
                                                                            phi_3170_ = _e2565;
                                                                            phi_3171_ = _e2567;
                                                                        } else {
                                                                            phi_3169_ = bool();
                                                                            phi_3170_ = _e1905;
                                                                            phi_3171_ = true;
                                                                        }
                                                                        let _e2569 = phi_3169_;
                                                                        let _e2571 = phi_3170_;
                                                                        let _e2573 = phi_3171_;
                                                                        phi_3172_ = _e2569;
                                                                        phi_3173_ = _e2571;
                                                                        phi_3174_ = _e2573;
                                                                    } else {
                                                                        phi_3172_ = bool();
                                                                        phi_3173_ = _e1905;
                                                                        phi_3174_ = true;
                                                                    }
                                                                    let _e2575 = phi_3172_;
                                                                    let _e2577 = phi_3173_;
                                                                    let _e2579 = phi_3174_;
                                                                    if _e2579 {
                                                                    }
                                                                    phi_2372_ = (_e1903 & (_e1903 - 1u));
                                                                    phi_2375_ = _e2577;
                                                                    phi_3178_ = _e2575;
                                                                    phi_3179_ = _e2579;
                                                                }
                                                                let _e2581 = phi_2372_;
                                                                let _e2583 = phi_2375_;
                                                                let _e2585 = phi_3178_;
                                                                let _e2587 = phi_3179_;
                                                                local_14 = _e2585;
                                                                continue;
                                                                continuing {
                                                                    phi_2371_ = _e2581;
                                                                    phi_2374_ = _e2583;
                                                                    break if !(_e2587);
                                                                }
                                                            }
                                                            let _e2590 = local_9;
                                                            if _e2590 {
                                                                let _e2592 = local_1.group_mask;
                                                                if ((_e2592 & 4278190080u) == 0u) {
                                                                    let _e2596 = local_1.len;
                                                                    if (_e2596 == 0u) {
                                                                        phi_3221_ = false;
                                                                    } else {
                                                                        let _e2600 = local_1.len;
                                                                        local_1.len = (_e2600 - 1u);
                                                                        let _e2603 = local_1.len;
                                                                        if (_e2603 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e2608 = local_1.first[(0u + _e2603)];
                                                                        local_1.group = _e2608;
                                                                        let _e2611 = local_1.len;
                                                                        if (_e2611 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e2616 = local_1.mask[(0u + _e2611)];
                                                                        local_1.group_mask = _e2616;
                                                                        phi_3221_ = true;
                                                                    }
                                                                    let _e2619 = phi_3221_;
                                                                    phi_3222_ = _e2619;
                                                                } else {
                                                                    phi_3222_ = true;
                                                                }
                                                                let _e2621 = phi_3222_;
                                                                if _e2621 {
                                                                    let _e2623 = local_1.group_mask;
                                                                    let _e2629 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2623)), 32u, (_e2623 == 0u)));
                                                                    let _e2633 = local_1.group_mask;
                                                                    let _e2647 = local_1.group_mask;
                                                                    local_1.group_mask = (_e2647 & ~((1u << bitcast<u32>((_e2629 & 31u)))));
                                                                    let _e2650 = local_1.group;
                                                                    phi_3253_ = (_e2650 + countOneBits(((_e2633 & ~((4294967295u << bitcast<u32>((((_e2629 - 24u) ^ _e1327) & 31u))))) & 255u)));
                                                                } else {
                                                                    phi_3253_ = 4294967295u;
                                                                }
                                                                let _e2653 = phi_3253_;
                                                                phi_3254_ = _e2653;
                                                            } else {
                                                                phi_3254_ = u32();
                                                            }
                                                            let _e2655 = phi_3254_;
                                                            phi_2040_ = _e2655;
                                                            let _e3071 = local_13;
                                                            phi_2043_ = _e3071;
                                                            let _e3074 = local_14;
                                                            phi_3255_ = _e3074;
                                                            let _e3077 = local_15;
                                                            phi_3256_ = _e3077;
                                                            phi_3257_ = false;
                                                        } else {
                                                            phi_2040_ = u32();
                                                            phi_2043_ = bool();
                                                            phi_3255_ = bool();
                                                            phi_3256_ = false;
                                                            phi_3257_ = true;
                                                        }
                                                        let _e2657 = phi_2040_;
                                                        let _e2659 = phi_2043_;
                                                        let _e2661 = phi_3255_;
                                                        let _e2663 = phi_3256_;
                                                        let _e2665 = phi_3257_;
                                                        local_10 = _e2665;
                                                        local_16 = _e2661;
                                                        continue;
                                                        continuing {
                                                            phi_2039_ = _e2657;
                                                            phi_2042_ = _e2659;
                                                            break if !(_e2663);
                                                        }
                                                    }
                                                    let _e2668 = local_10;
                                                    if _e2668 {
                                                        phi_3261_ = false;
                                                    } else {
                                                        phi_3261_ = true;
                                                    }
                                                    let _e2670 = phi_3261_;
                                                    if _e2670 {
                                                        let _e3083 = local_16;
                                                        phi_3265_ = _e3083;
                                                    } else {
                                                        let _e3085 = local_17;
                                                        phi_3265_ = _e3085;
                                                    }
                                                    let _e2672 = phi_3265_;
                                                    phi_3266_ = _e2672;
                                                }
                                                let _e2674 = phi_3266_;
                                                phi_3267_ = _e2674;
                                                phi_3268_ = _e1153;
                                            } else {
                                                phi_3267_ = bool();
                                                phi_3268_ = true;
                                            }
                                            let _e2676 = phi_3267_;
                                            let _e2678 = phi_3268_;
                                            if _e2678 {
                                                phi_3272_ = _e940;
                                            } else {
                                                phi_3272_ = _e2676;
                                            }
                                            let _e2680 = phi_3272_;
                                            if _e2680 {
                                                phi_3276_ = false;
                                            } else {
                                                phi_3276_ = true;
                                            }
                                            let _e2682 = phi_3276_;
                                            phi_3277_ = _e2680;
                                            phi_3278_ = _e2682;
                                        } else {
                                            phi_3277_ = _e940;
                                            phi_3278_ = true;
                                        }
                                        let _e2684 = phi_3277_;
                                        let _e2686 = phi_3278_;
                                        phi_3279_ = _e2684;
                                        phi_3280_ = _e2686;
                                    } else {
                                        phi_3279_ = _e940;
                                        phi_3280_ = true;
                                    }
                                    let _e2688 = phi_3279_;
                                    let _e2690 = phi_3280_;
                                    phi_3281_ = _e2688;
                                    phi_3282_ = _e2690;
                                } else {
                                    phi_3281_ = _e940;
                                    phi_3282_ = true;
                                }
                                let _e2692 = phi_3281_;
                                let _e2694 = phi_3282_;
                                if _e2694 {
                                }
                                phi_1432_ = (_e938 & (_e938 - 1u));
                                phi_1435_ = _e2692;
                                phi_3286_ = _e2694;
                            }
                            let _e2696 = phi_1432_;
                            let _e2698 = phi_1435_;
                            let _e2700 = phi_3286_;
                            continue;
                            continuing {
                                phi_1431_ = _e2696;
                                phi_1434_ = _e2698;
                                break if !(_e2700);
                            }
                        }
                        let _e2703 = local_11;
                        if _e2703 {
                            let _e2705 = local_2.group_mask;
                            if ((_e2705 & 4278190080u) == 0u) {
                                let _e2709 = local_2.len;
                                if (_e2709 == 0u) {
                                    phi_3328_ = false;
                                } else {
                                    let _e2713 = local_2.len;
                                    local_2.len = (_e2713 - 1u);
                                    let _e2716 = local_2.len;
                                    if (_e2716 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e2721 = local_2.first[(0u + _e2716)];
                                    local_2.group = _e2721;
                                    let _e2724 = local_2.len;
                                    if (_e2724 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e2729 = local_2.mask[(0u + _e2724)];
                                    local_2.group_mask = _e2729;
                                    phi_3328_ = true;
                                }
                                let _e2732 = phi_3328_;
                                phi_3329_ = _e2732;
                            } else {
                                phi_3329_ = true;
                            }
                            let _e2734 = phi_3329_;
                            if _e2734 {
                                let _e2736 = local_2.group_mask;
                                let _e2742 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2736)), 32u, (_e2736 == 0u)));
                                let _e2746 = local_2.group_mask;
                                let _e2760 = local_2.group_mask;
                                local_2.group_mask = (_e2760 & ~((1u << bitcast<u32>((_e2742 & 31u)))));
                                let _e2763 = local_2.group;
                                phi_3360_ = (_e2763 + countOneBits(((_e2746 & ~((4294967295u << bitcast<u32>((((_e2742 - 24u) ^ _e362) & 31u))))) & 255u)));
                            } else {
                                phi_3360_ = 4294967295u;
                            }
                            let _e2766 = phi_3360_;
                            phi_3361_ = _e2766;
                        } else {
                            phi_3361_ = u32();
                        }
                        let _e2768 = phi_3361_;
                        phi_1100_ = _e2768;
                        let _e3108 = local_18;
                        phi_1103_ = _e3108;
                        let _e3111 = local_19;
                        phi_3362_ = _e3111;
                        phi_3363_ = false;
                    } else {
                        phi_1100_ = u32();
                        phi_1103_ = bool();
                        phi_3362_ = false;
                        phi_3363_ = true;
                    }
                    let _e2770 = phi_1100_;
                    let _e2772 = phi_1103_;
                    let _e2774 = phi_3362_;
                    let _e2776 = phi_3363_;
                    local_12 = _e2776;
                    continue;
                    continuing {
                        phi_1099_ = _e2770;
                        phi_1102_ = _e2772;
                        break if !(_e2774);
                    }
                }
                let _e2779 = local_12;
                if _e2779 {
                    phi_3367_ = false;
                } else {
                    phi_3367_ = true;
                }
                let _e2781 = phi_3367_;
                if _e2781 {
                }
                phi_3371_ = _e2781;
            }
            let _e2783 = phi_3371_;
            phi_3372_ = _e218;
            phi_3373_ = _e2783;
        } else {
            phi_3372_ = true;
            phi_3373_ = false;
        }
        let _e2785 = phi_3372_;
        let _e2787 = phi_3373_;
        if _e2785 {
            phi_3377_ = false;
            phi_3378_ = true;
        } else {
            phi_3377_ = true;
            phi_3378_ = _e2787;
        }
        let _e2789 = phi_3377_;
        let _e2791 = phi_3378_;
        if _e2791 {
            phi_3382_ = _e2789;
        } else {
            phi_3382_ = false;
        }
        let _e2793 = phi_3382_;
        if _e2793 {
            phi_3386_ = 0f;
        } else {
            phi_3386_ = 1f;
        }
        let _e2795 = phi_3386_;
        if (_e114 < _e83) {
        } else {
            return;
        }
        visibility.member[(0u + _e114)] = _e2795;
        if (_e114 < _e89) {
        } else {
            return;
        }
        let _e2802 = bits.member[(0u + _e114)];
        if ((_e2802 & 2u) == 0u) {
            phi_3407_ = (_e2802 & 1u);
        } else {
            phi_3407_ = (_e2802 & 7u);
        }
        let _e2808 = phi_3407_;
        if (_e114 < _e83) {
        } else {
            return;
        }
        let _e2812 = visibility.member[(0u + _e114)];
        if ((_e2808 & 1u) != 0u) {
            phi_3422_ = (2u | 1u);
        } else {
            phi_3422_ = 2u;
        }
        let _e2818 = phi_3422_;
        if (_e2812 < 0.5f) {
            phi_3427_ = (_e2818 | 4u);
        } else {
            phi_3427_ = _e2818;
        }
        let _e2821 = phi_3427_;
        if (_e114 < _e89) {
        } else {
            return;
        }
        bits.member[(0u + _e114)] = _e2821;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_learn_instanced_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
