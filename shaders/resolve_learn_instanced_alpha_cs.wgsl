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
    light: vec4<f32>,
    test: vec4<f32>,
    size: vec2<u32>,
    map_size: u32,
    epsilon: f32,
    root: u32,
    level_count: u32,
    fade_uv: f32,
    pad0_: u32,
}

struct type_32 {
    member: abi_ShadowParams,
}

struct lt_bvh_Node {
    frame: vec4<u32>,
    links: vec4<u32>,
    x: vec4<u32>,
    y: vec4<u32>,
    z: vec4<u32>,
}

struct type_37 {
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

struct type_41 {
    member: array<lt_bvh_Triangle>,
}

struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
}

struct type_45 {
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

struct type_49 {
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

struct type_63 {
    member: array<lt_bvh_Instance>,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_17;
@group(0) @binding(0) 
var<uniform> p: type_32;
@group(0) @binding(2) 
var<storage> nodes: type_37;
@group(0) @binding(3) 
var<storage> triangles: type_41;
@group(0) @binding(5) 
var<storage> list: type_13;
@group(0) @binding(6) 
var<storage, read_write> bits: type_13;
@group(0) @binding(7) 
var<storage> instances: type_63;
@group(0) @binding(8) 
var<storage> vertices: type_45;
@group(0) @binding(9) 
var<storage> materials: type_49;
@group(0) @binding(10) 
var<storage> alpha_texels: type_13;

fn core_intrinsics_maximum_number_nsz_f32_(param: f32, param_1: f32) -> f32 {
    var phi_207_: bool;
    var phi_211_: f32;

    if (param != param) {
        phi_207_ = true;
    } else {
        let _e70 = (param_1 >= param);
        if _e70 {
        }
        phi_207_ = _e70;
    }
    let _e72 = phi_207_;
    if _e72 {
        phi_211_ = param_1;
    } else {
        phi_211_ = param;
    }
    let _e74 = phi_211_;
    return _e74;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_2: f32, param_3: f32) -> f32 {
    var phi_223_: bool;
    var phi_227_: f32;

    if (param_2 != param_2) {
        phi_223_ = true;
    } else {
        let _e70 = (param_3 <= param_2);
        if _e70 {
        }
        phi_223_ = _e70;
    }
    let _e72 = phi_223_;
    if _e72 {
        phi_227_ = param_3;
    } else {
        phi_227_ = param_2;
    }
    let _e74 = phi_227_;
    return _e74;
}

fn _lt_shaders_texture_TextureView_quad(param_4: ptr<function, texture_TextureView>, param_5: f32, param_6: f32) -> texture_TexelQuad {
    var phi_269_: f32;
    var phi_274_: f32;
    var phi_275_: bool;
    var phi_276_: f32;
    var phi_277_: bool;
    var phi_281_: f32;
    var phi_307_: f32;
    var phi_312_: f32;
    var phi_313_: bool;
    var phi_314_: f32;
    var phi_315_: bool;
    var phi_319_: f32;
    var phi_327_: f32;
    var phi_328_: f32;
    var phi_329_: f32;
    var phi_338_: f32;
    var phi_339_: f32;
    var phi_357_: u32;
    var phi_371_: u32;
    var phi_378_: u32;
    var phi_383_: u32;
    var phi_389_: u32;
    var phi_394_: u32;
    var phi_396_: texture_Axis;
    var phi_424_: f32;
    var phi_429_: f32;
    var phi_430_: bool;
    var phi_431_: f32;
    var phi_432_: bool;
    var phi_436_: f32;
    var phi_462_: f32;
    var phi_467_: f32;
    var phi_468_: bool;
    var phi_469_: f32;
    var phi_470_: bool;
    var phi_474_: f32;
    var phi_482_: f32;
    var phi_483_: f32;
    var phi_484_: f32;
    var phi_493_: f32;
    var phi_494_: f32;
    var phi_512_: u32;
    var phi_526_: u32;
    var phi_533_: u32;
    var phi_538_: u32;
    var phi_544_: u32;
    var phi_549_: u32;
    var phi_551_: texture_Axis;

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
                phi_269_ = 1f;
            } else {
                phi_269_ = 0f;
            }
            let _e101 = phi_269_;
            if (param_5 < 8388608f) {
                phi_274_ = (_e98 - _e101);
                phi_275_ = false;
            } else {
                phi_274_ = f32();
                phi_275_ = true;
            }
            let _e104 = phi_274_;
            let _e106 = phi_275_;
            phi_276_ = _e104;
            phi_277_ = _e106;
        } else {
            phi_276_ = f32();
            phi_277_ = true;
        }
        let _e108 = phi_276_;
        let _e110 = phi_277_;
        if _e110 {
            phi_281_ = param_5;
        } else {
            phi_281_ = _e108;
        }
        let _e112 = phi_281_;
        phi_329_ = (param_5 - _e112);
    } else {
        if (_e85 == 1u) {
            let _e115 = (param_5 * 0.5f);
            if (_e115 > -8388608f) {
                let _e127 = f32(select(0i, select(select(i32(_e115), i32(-2147483648), (_e115 < bitcast<f32>(3472883712u))), 2147483647i, (_e115 > bitcast<f32>(1325400063u))), (_e115 == _e115)));
                if (_e127 > _e115) {
                    phi_307_ = 1f;
                } else {
                    phi_307_ = 0f;
                }
                let _e130 = phi_307_;
                if (_e115 < 8388608f) {
                    phi_312_ = (_e127 - _e130);
                    phi_313_ = false;
                } else {
                    phi_312_ = f32();
                    phi_313_ = true;
                }
                let _e133 = phi_312_;
                let _e135 = phi_313_;
                phi_314_ = _e133;
                phi_315_ = _e135;
            } else {
                phi_314_ = f32();
                phi_315_ = true;
            }
            let _e137 = phi_314_;
            let _e139 = phi_315_;
            if _e139 {
                phi_319_ = _e115;
            } else {
                phi_319_ = _e137;
            }
            let _e141 = phi_319_;
            let _e143 = (param_5 - (2f * _e141));
            if (_e143 > 1f) {
                phi_327_ = (2f - _e143);
            } else {
                phi_327_ = _e143;
            }
            let _e147 = phi_327_;
            phi_328_ = _e147;
        } else {
            phi_328_ = param_5;
        }
        let _e149 = phi_328_;
        phi_329_ = _e149;
    }
    let _e151 = phi_329_;
    if (_e151 > 0f) {
        if (_e151 < 1f) {
            phi_338_ = _e151;
        } else {
            phi_338_ = 1f;
        }
        let _e155 = phi_338_;
        phi_339_ = _e155;
    } else {
        phi_339_ = 0f;
    }
    let _e157 = phi_339_;
    let _e158 = (_e72 - 1u);
    let _e160 = (_e157 * f32(_e72));
    if _e80 {
        let _e167 = select(select(u32(_e160), 0u, (_e160 < bitcast<f32>(0u))), 4294967295u, (_e160 > bitcast<f32>(1333788671u)));
        if (_e158 < _e167) {
            phi_357_ = _e158;
        } else {
            phi_357_ = _e167;
        }
        let _e170 = phi_357_;
        phi_396_ = texture_Axis(_e170, _e170, 0f);
    } else {
        let _e172 = (_e160 + 0.5f);
        let _e179 = select(select(u32(_e172), 0u, (_e172 < bitcast<f32>(0u))), 4294967295u, (_e172 > bitcast<f32>(1333788671u)));
        if (_e72 < _e179) {
            phi_371_ = _e72;
        } else {
            phi_371_ = _e179;
        }
        let _e182 = phi_371_;
        if (_e85 == 0u) {
            phi_378_ = _e158;
        } else {
            phi_378_ = 0u;
        }
        let _e187 = phi_378_;
        if (_e85 == 0u) {
            phi_383_ = 0u;
        } else {
            phi_383_ = _e158;
        }
        let _e190 = phi_383_;
        if (_e182 == 0u) {
            phi_389_ = _e187;
        } else {
            phi_389_ = (_e182 - 1u);
        }
        let _e194 = phi_389_;
        if (_e182 > _e158) {
            phi_394_ = _e190;
        } else {
            phi_394_ = _e182;
        }
        let _e197 = phi_394_;
        phi_396_ = texture_Axis(_e194, _e197, (_e172 - f32(_e182)));
    }
    let _e200 = phi_396_;
    let _e202 = (*param_4).flags;
    let _e205 = ((_e202 >> bitcast<u32>(6u)) & 3u);
    if (_e205 == 0u) {
        if (param_6 > -8388608f) {
            let _e218 = f32(select(0i, select(select(i32(param_6), i32(-2147483648), (param_6 < bitcast<f32>(3472883712u))), 2147483647i, (param_6 > bitcast<f32>(1325400063u))), (param_6 == param_6)));
            if (_e218 > param_6) {
                phi_424_ = 1f;
            } else {
                phi_424_ = 0f;
            }
            let _e221 = phi_424_;
            if (param_6 < 8388608f) {
                phi_429_ = (_e218 - _e221);
                phi_430_ = false;
            } else {
                phi_429_ = f32();
                phi_430_ = true;
            }
            let _e224 = phi_429_;
            let _e226 = phi_430_;
            phi_431_ = _e224;
            phi_432_ = _e226;
        } else {
            phi_431_ = f32();
            phi_432_ = true;
        }
        let _e228 = phi_431_;
        let _e230 = phi_432_;
        if _e230 {
            phi_436_ = param_6;
        } else {
            phi_436_ = _e228;
        }
        let _e232 = phi_436_;
        phi_484_ = (param_6 - _e232);
    } else {
        if (_e205 == 1u) {
            let _e235 = (param_6 * 0.5f);
            if (_e235 > -8388608f) {
                let _e247 = f32(select(0i, select(select(i32(_e235), i32(-2147483648), (_e235 < bitcast<f32>(3472883712u))), 2147483647i, (_e235 > bitcast<f32>(1325400063u))), (_e235 == _e235)));
                if (_e247 > _e235) {
                    phi_462_ = 1f;
                } else {
                    phi_462_ = 0f;
                }
                let _e250 = phi_462_;
                if (_e235 < 8388608f) {
                    phi_467_ = (_e247 - _e250);
                    phi_468_ = false;
                } else {
                    phi_467_ = f32();
                    phi_468_ = true;
                }
                let _e253 = phi_467_;
                let _e255 = phi_468_;
                phi_469_ = _e253;
                phi_470_ = _e255;
            } else {
                phi_469_ = f32();
                phi_470_ = true;
            }
            let _e257 = phi_469_;
            let _e259 = phi_470_;
            if _e259 {
                phi_474_ = _e235;
            } else {
                phi_474_ = _e257;
            }
            let _e261 = phi_474_;
            let _e263 = (param_6 - (2f * _e261));
            if (_e263 > 1f) {
                phi_482_ = (2f - _e263);
            } else {
                phi_482_ = _e263;
            }
            let _e267 = phi_482_;
            phi_483_ = _e267;
        } else {
            phi_483_ = param_6;
        }
        let _e269 = phi_483_;
        phi_484_ = _e269;
    }
    let _e271 = phi_484_;
    if (_e271 > 0f) {
        if (_e271 < 1f) {
            phi_493_ = _e271;
        } else {
            phi_493_ = 1f;
        }
        let _e275 = phi_493_;
        phi_494_ = _e275;
    } else {
        phi_494_ = 0f;
    }
    let _e277 = phi_494_;
    let _e278 = (_e76 - 1u);
    let _e280 = (_e277 * f32(_e76));
    if _e80 {
        let _e287 = select(select(u32(_e280), 0u, (_e280 < bitcast<f32>(0u))), 4294967295u, (_e280 > bitcast<f32>(1333788671u)));
        if (_e278 < _e287) {
            phi_512_ = _e278;
        } else {
            phi_512_ = _e287;
        }
        let _e290 = phi_512_;
        phi_551_ = texture_Axis(_e290, _e290, 0f);
    } else {
        let _e292 = (_e280 + 0.5f);
        let _e299 = select(select(u32(_e292), 0u, (_e292 < bitcast<f32>(0u))), 4294967295u, (_e292 > bitcast<f32>(1333788671u)));
        if (_e76 < _e299) {
            phi_526_ = _e76;
        } else {
            phi_526_ = _e299;
        }
        let _e302 = phi_526_;
        if (_e205 == 0u) {
            phi_533_ = _e278;
        } else {
            phi_533_ = 0u;
        }
        let _e307 = phi_533_;
        if (_e205 == 0u) {
            phi_538_ = 0u;
        } else {
            phi_538_ = _e278;
        }
        let _e310 = phi_538_;
        if (_e302 == 0u) {
            phi_544_ = _e307;
        } else {
            phi_544_ = (_e302 - 1u);
        }
        let _e314 = phi_544_;
        if (_e302 > _e278) {
            phi_549_ = _e310;
        } else {
            phi_549_ = _e302;
        }
        let _e317 = phi_549_;
        phi_551_ = texture_Axis(_e314, _e317, (_e292 - f32(_e302)));
    }
    let _e320 = phi_551_;
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
    var phi_698_: f32;
    var phi_754_: bool;
    var phi_755_: bool;
    var phi_756_: bool;
    var phi_760_: bool;
    var phi_761_: bool;
    var phi_762_: bool;
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
    var phi_781_: bool;
    var phi_785_: bool;
    var phi_855_: f32;
    var phi_862_: f32;
    var phi_869_: f32;
    var phi_876_: f32;
    var phi_883_: f32;
    var phi_890_: f32;
    var phi_907_: f32;
    var phi_912_: f32;
    var phi_917_: f32;
    var phi_938_: u32;
    var phi_943_: u32;
    var phi_948_: u32;
    var phi_1062_: bool;
    var phi_1063_: bool;
    var phi_1094_: u32;
    var phi_1096_: u32;
    var phi_1099_: bool;
    var phi_1179_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1206_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1233_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1239_: u32;
    var phi_1242_: u32;
    var phi_1256_: u32;
    var phi_1266_: u32;
    var phi_1276_: u32;
    var phi_1294_: u32;
    var phi_1304_: u32;
    var phi_1314_: u32;
    var phi_1350_: u32;
    var phi_1363_: u32;
    var phi_1368_: u32;
    var phi_1369_: u32;
    var phi_1370_: u32;
    var phi_1240_: u32;
    var phi_1243_: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_1428_: u32;
    var phi_1431_: bool;
    var phi_1480_: f32;
    var phi_1485_: f32;
    var phi_1490_: f32;
    var phi_1498_: f32;
    var phi_1503_: f32;
    var phi_1508_: f32;
    var phi_1652_: bool;
    var phi_1653_: bool;
    var phi_1654_: bool;
    var phi_1658_: bool;
    var phi_1659_: bool;
    var phi_1660_: bool;
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
    var phi_1679_: bool;
    var phi_1683_: bool;
    var phi_1753_: f32;
    var phi_1760_: f32;
    var phi_1767_: f32;
    var phi_1774_: f32;
    var phi_1781_: f32;
    var phi_1788_: f32;
    var phi_1805_: f32;
    var phi_1810_: f32;
    var phi_1815_: f32;
    var phi_1843_: bool;
    var phi_1844_: bool;
    var phi_1852_: u32;
    var phi_1853_: u32;
    var phi_1864_: vec3<f32>;
    var phi_1865_: vec3<f32>;
    var phi_1878_: u32;
    var phi_1883_: u32;
    var phi_1888_: u32;
    var phi_2002_: bool;
    var phi_2003_: bool;
    var phi_2034_: u32;
    var phi_2036_: u32;
    var phi_2039_: bool;
    var phi_2119_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2146_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2173_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2179_: u32;
    var phi_2182_: u32;
    var phi_2196_: u32;
    var phi_2206_: u32;
    var phi_2216_: u32;
    var phi_2234_: u32;
    var phi_2244_: u32;
    var phi_2254_: u32;
    var phi_2290_: u32;
    var phi_2303_: u32;
    var phi_2308_: u32;
    var phi_2309_: u32;
    var phi_2310_: u32;
    var phi_2180_: u32;
    var phi_2183_: u32;
    var local_6: u32;
    var local_7: u32;
    var local_8: u32;
    var phi_2368_: u32;
    var phi_2371_: bool;
    var phi_2415_: vec3<f32>;
    var phi_2416_: vec3<f32>;
    var phi_2445_: vec3<f32>;
    var phi_2446_: vec3<f32>;
    var phi_2475_: vec3<f32>;
    var phi_2476_: vec3<f32>;
    var phi_2494_: bool;
    var phi_2495_: bool;
    var phi_2499_: f32;
    var phi_2500_: f32;
    var phi_2501_: f32;
    var phi_2502_: f32;
    var phi_2510_: f32;
    var phi_2520_: bool;
    var phi_2521_: bool;
    var phi_2525_: f32;
    var phi_2526_: f32;
    var phi_2527_: f32;
    var phi_2528_: f32;
    var phi_2536_: f32;
    var phi_2546_: bool;
    var phi_2547_: bool;
    var phi_2551_: f32;
    var phi_2552_: f32;
    var phi_2553_: f32;
    var phi_2554_: f32;
    var phi_2562_: f32;
    var phi_2577_: f32;
    var phi_2578_: bool;
    var phi_2579_: f32;
    var phi_2580_: bool;
    var phi_2581_: f32;
    var phi_2582_: bool;
    var phi_2600_: f32;
    var phi_2601_: bool;
    var phi_2602_: bool;
    var phi_2603_: f32;
    var phi_2604_: bool;
    var phi_2605_: bool;
    var phi_2609_: bool;
    var phi_2610_: f32;
    var phi_2611_: bool;
    var phi_2639_: vec3<f32>;
    var phi_2640_: vec3<f32>;
    var phi_2665_: vec3<f32>;
    var phi_2666_: vec3<f32>;
    var phi_2691_: vec3<f32>;
    var phi_2692_: vec3<f32>;
    var phi_2748_: f32;
    var phi_2757_: f32;
    var phi_2766_: f32;
    var phi_2775_: f32;
    var phi_2782_: f32;
    var phi_2789_: f32;
    var phi_2802_: f32;
    var phi_2811_: f32;
    var phi_2820_: f32;
    var phi_2829_: f32;
    var phi_2836_: f32;
    var phi_2843_: f32;
    var phi_2860_: f32;
    var phi_2865_: f32;
    var phi_2870_: f32;
    var phi_2878_: f32;
    var phi_2883_: f32;
    var phi_2888_: f32;
    var phi_2900_: f32;
    var phi_2905_: f32;
    var phi_2910_: f32;
    var phi_2915_: f32;
    var phi_2920_: lt_bvh_triangle_Intersection;
    var phi_2921_: bool;
    var phi_2922_: lt_bvh_triangle_Intersection;
    var phi_2923_: bool;
    var phi_2927_: lt_bvh_triangle_Intersection;
    var phi_2928_: bool;
    var phi_2929_: lt_bvh_triangle_Intersection;
    var phi_2930_: bool;
    var phi_2931_: bool;
    var phi_2935_: bool;
    var phi_2939_: lt_bvh_triangle_Intersection;
    var phi_3153_: f32;
    var phi_3156_: bool;
    var phi_3157_: bool;
    var phi_3158_: bool;
    var phi_3162_: bool;
    var phi_3163_: bool;
    var phi_3164_: bool;
    var phi_3165_: bool;
    var phi_3166_: bool;
    var phi_3167_: bool;
    var phi_3168_: bool;
    var phi_3169_: bool;
    var phi_3170_: bool;
    var phi_3171_: bool;
    var phi_2369_: u32;
    var phi_2372_: bool;
    var phi_3175_: bool;
    var phi_3176_: bool;
    var local_9: bool;
    var phi_3218_: bool;
    var phi_3219_: bool;
    var phi_3250_: u32;
    var phi_3251_: u32;
    var phi_2037_: u32;
    var phi_2040_: bool;
    var phi_3252_: bool;
    var phi_3253_: bool;
    var phi_3254_: bool;
    var local_10: bool;
    var phi_3258_: bool;
    var phi_3262_: bool;
    var phi_3263_: bool;
    var phi_3264_: bool;
    var phi_3265_: bool;
    var phi_3269_: bool;
    var phi_3273_: bool;
    var phi_3274_: bool;
    var phi_3275_: bool;
    var phi_3276_: bool;
    var phi_3277_: bool;
    var phi_3278_: bool;
    var phi_3279_: bool;
    var phi_1429_: u32;
    var phi_1432_: bool;
    var phi_3283_: bool;
    var local_11: bool;
    var phi_3325_: bool;
    var phi_3326_: bool;
    var phi_3357_: u32;
    var phi_3358_: u32;
    var phi_1097_: u32;
    var phi_1100_: bool;
    var phi_3359_: bool;
    var phi_3360_: bool;
    var local_12: bool;
    var phi_3364_: bool;
    var phi_3368_: bool;
    var phi_3369_: bool;
    var phi_3370_: bool;
    var phi_3374_: bool;
    var phi_3375_: bool;
    var phi_3379_: bool;
    var phi_3383_: f32;
    var phi_3404_: u32;
    var phi_3419_: u32;
    var phi_3424_: u32;
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
        let _e121 = p.member.light;
        let _e123 = samples.member[(0u + _e114)].position;
        let _e125 = samples.member[(0u + _e114)].normal;
        let _e127 = samples.member[(0u + _e114)].magnitude;
        let _e129 = ((8f / 8388608f) * _e127);
        let _e137 = (_e123.x + (_e125.x * _e129));
        let _e139 = (_e123.y + (_e125.y * _e129));
        let _e141 = (_e123.z + (_e125.z * _e129));
        if (_e121.w == 0f) {
            phi_698_ = 300000000000000000000000000000000000000f;
        } else {
            phi_698_ = 1f;
        }
        let _e145 = phi_698_;
        let _e153 = (_e121.x - (_e137 * _e121.w));
        let _e154 = (_e121.y - (_e139 * _e121.w));
        let _e155 = (_e121.z - (_e141 * _e121.w));
        let _e159 = abs(_e153);
        let _e160 = abs(_e154);
        let _e161 = abs(_e155);
        if (abs(_e137) < 1000000000000000f) {
            if (abs(_e139) < 1000000000000000f) {
                if (abs(_e141) < 1000000000000000f) {
                    if (_e159 < 1000000000000000f) {
                        if (_e160 < 1000000000000000f) {
                            if (_e161 < 1000000000000000f) {
                                if (_e159 > 0f) {
                                    phi_755_ = bool();
                                    phi_756_ = true;
                                } else {
                                    let _e169 = (_e160 > 0f);
                                    if _e169 {
                                        phi_754_ = bool();
                                    } else {
                                        phi_754_ = (_e161 > 0f);
                                    }
                                    let _e172 = phi_754_;
                                    phi_755_ = _e172;
                                    phi_756_ = _e169;
                                }
                                let _e174 = phi_755_;
                                let _e176 = phi_756_;
                                if _e176 {
                                    phi_760_ = true;
                                } else {
                                    phi_760_ = _e174;
                                }
                                let _e178 = phi_760_;
                                phi_761_ = _e178;
                                phi_762_ = false;
                            } else {
                                phi_761_ = bool();
                                phi_762_ = true;
                            }
                            let _e180 = phi_761_;
                            let _e182 = phi_762_;
                            phi_763_ = _e180;
                            phi_764_ = false;
                            phi_765_ = _e182;
                        } else {
                            phi_763_ = bool();
                            phi_764_ = true;
                            phi_765_ = false;
                        }
                        let _e184 = phi_763_;
                        let _e186 = phi_764_;
                        let _e188 = phi_765_;
                        phi_766_ = _e184;
                        phi_767_ = _e186;
                        phi_768_ = _e188;
                    } else {
                        phi_766_ = bool();
                        phi_767_ = true;
                        phi_768_ = false;
                    }
                    let _e190 = phi_766_;
                    let _e192 = phi_767_;
                    let _e194 = phi_768_;
                    phi_769_ = _e190;
                    phi_770_ = _e192;
                    phi_771_ = _e194;
                } else {
                    phi_769_ = bool();
                    phi_770_ = true;
                    phi_771_ = false;
                }
                let _e196 = phi_769_;
                let _e198 = phi_770_;
                let _e200 = phi_771_;
                phi_772_ = _e196;
                phi_773_ = _e198;
                phi_774_ = _e200;
            } else {
                phi_772_ = bool();
                phi_773_ = true;
                phi_774_ = false;
            }
            let _e202 = phi_772_;
            let _e204 = phi_773_;
            let _e206 = phi_774_;
            phi_775_ = _e202;
            phi_776_ = _e204;
            phi_777_ = _e206;
        } else {
            phi_775_ = bool();
            phi_776_ = true;
            phi_777_ = false;
        }
        let _e208 = phi_775_;
        let _e210 = phi_776_;
        let _e212 = phi_777_;
        if _e210 {
            phi_781_ = true;
        } else {
            phi_781_ = _e212;
        }
        let _e214 = phi_781_;
        if _e214 {
            phi_785_ = false;
        } else {
            phi_785_ = _e208;
        }
        let _e216 = phi_785_;
        if _e216 {
            let _e217 = (_e116 >= _e77);
            if _e217 {
                phi_3368_ = false;
            } else {
                if (_e116 < _e77) {
                } else {
                    return;
                }
                let _e223 = nodes.member[(0u + _e116)].frame[0u];
                let _e227 = nodes.member[(0u + _e116)].frame[1u];
                let _e231 = nodes.member[(0u + _e116)].frame[2u];
                let _e235 = nodes.member[(0u + _e116)].frame[0u];
                let _e239 = nodes.member[(0u + _e116)].frame[1u];
                let _e243 = nodes.member[(0u + _e116)].frame[2u];
                let _e247 = nodes.member[(0u + _e116)].frame[3u];
                let _e281 = core_intrinsics_maximum_number_nsz_f32_(abs(_e153), abs(_e154));
                let _e282 = core_intrinsics_maximum_number_nsz_f32_(_e281, abs(_e155));
                let _e283 = (_e282 * 0.0000000000009094947f);
                if (abs(_e153) < _e283) {
                    phi_855_ = _e283;
                } else {
                    phi_855_ = abs(_e153);
                }
                let _e288 = phi_855_;
                if (_e153 < 0f) {
                    phi_862_ = (-1f / _e288);
                } else {
                    phi_862_ = (1f / _e288);
                }
                let _e293 = phi_862_;
                if (abs(_e154) < _e283) {
                    phi_869_ = _e283;
                } else {
                    phi_869_ = abs(_e154);
                }
                let _e298 = phi_869_;
                if (_e154 < 0f) {
                    phi_876_ = (-1f / _e298);
                } else {
                    phi_876_ = (1f / _e298);
                }
                let _e303 = phi_876_;
                if (abs(_e155) < _e283) {
                    phi_883_ = _e283;
                } else {
                    phi_883_ = abs(_e155);
                }
                let _e308 = phi_883_;
                if (_e155 < 0f) {
                    phi_890_ = (-1f / _e308);
                } else {
                    phi_890_ = (1f / _e308);
                }
                let _e313 = phi_890_;
                let _e317 = abs((bitcast<f32>(_e223) - _e137));
                let _e318 = abs((bitcast<f32>(_e227) - _e139));
                let _e319 = abs((bitcast<f32>(_e231) - _e141));
                let _e323 = abs(((bitcast<f32>(_e235) + (bitcast<f32>((((_e247 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e137));
                let _e324 = abs(((bitcast<f32>(_e239) + (bitcast<f32>((((_e247 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e139));
                let _e325 = abs(((bitcast<f32>(_e243) + (bitcast<f32>((((_e247 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e141));
                if (_e317 > _e323) {
                    phi_907_ = _e317;
                } else {
                    phi_907_ = _e323;
                }
                let _e328 = phi_907_;
                if (_e318 > _e324) {
                    phi_912_ = _e318;
                } else {
                    phi_912_ = _e324;
                }
                let _e331 = phi_912_;
                if (_e319 > _e325) {
                    phi_917_ = _e319;
                } else {
                    phi_917_ = _e325;
                }
                let _e334 = phi_917_;
                let _e335 = core_intrinsics_maximum_number_nsz_f32_(_e328, _e331);
                let _e336 = core_intrinsics_maximum_number_nsz_f32_(_e335, _e334);
                let _e340 = (_e336 * 0.0000019073486f);
                let _e341 = (abs(_e293) * _e340);
                let _e342 = (abs(_e303) * _e340);
                let _e343 = (abs(_e313) * _e340);
                let _e347 = (_e336 * 0.0000009536743f);
                let _e348 = (abs(_e293) * _e347);
                let _e349 = (abs(_e303) * _e347);
                let _e350 = (abs(_e313) * _e347);
                if (_e293 < 0f) {
                    phi_938_ = 0u;
                } else {
                    phi_938_ = 1u;
                }
                let _e353 = phi_938_;
                if (_e303 < 0f) {
                    phi_943_ = 0u;
                } else {
                    phi_943_ = 2u;
                }
                let _e356 = phi_943_;
                if (_e313 < 0f) {
                    phi_948_ = 0u;
                } else {
                    phi_948_ = 4u;
                }
                let _e359 = phi_948_;
                let _e361 = ((_e353 | _e356) | _e359);
                let _e362 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e116, 2147483648u);
                local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e362.first[0], _e362.first[1], _e362.first[2], _e362.first[3], _e362.first[4], _e362.first[5], _e362.first[6], _e362.first[7], _e362.first[8], _e362.first[9], _e362.first[10], _e362.first[11], _e362.first[12], _e362.first[13], _e362.first[14], _e362.first[15], _e362.first[16], _e362.first[17], _e362.first[18], _e362.first[19], _e362.first[20], _e362.first[21], _e362.first[22], _e362.first[23], _e362.first[24], _e362.first[25], _e362.first[26], _e362.first[27], _e362.first[28], _e362.first[29], _e362.first[30], _e362.first[31]), array<u32, 32>(_e362.mask[0], _e362.mask[1], _e362.mask[2], _e362.mask[3], _e362.mask[4], _e362.mask[5], _e362.mask[6], _e362.mask[7], _e362.mask[8], _e362.mask[9], _e362.mask[10], _e362.mask[11], _e362.mask[12], _e362.mask[13], _e362.mask[14], _e362.mask[15], _e362.mask[16], _e362.mask[17], _e362.mask[18], _e362.mask[19], _e362.mask[20], _e362.mask[21], _e362.mask[22], _e362.mask[23], _e362.mask[24], _e362.mask[25], _e362.mask[26], _e362.mask[27], _e362.mask[28], _e362.mask[29], _e362.mask[30], _e362.mask[31]), _e362.len, _e362.group, _e362.group_mask);
                let _e436 = local_2.group_mask;
                if ((_e436 & 4278190080u) == 0u) {
                    let _e440 = local_2.len;
                    if (_e440 == 0u) {
                        phi_1062_ = false;
                    } else {
                        let _e444 = local_2.len;
                        local_2.len = (_e444 - 1u);
                        let _e447 = local_2.len;
                        if (_e447 < 32u) {
                        } else {
                            return;
                        }
                        let _e452 = local_2.first[(0u + _e447)];
                        local_2.group = _e452;
                        let _e455 = local_2.len;
                        if (_e455 < 32u) {
                        } else {
                            return;
                        }
                        let _e460 = local_2.mask[(0u + _e455)];
                        local_2.group_mask = _e460;
                        phi_1062_ = true;
                    }
                    let _e463 = phi_1062_;
                    phi_1063_ = _e463;
                } else {
                    phi_1063_ = true;
                }
                let _e465 = phi_1063_;
                if _e465 {
                    let _e467 = local_2.group_mask;
                    let _e473 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e467)), 32u, (_e467 == 0u)));
                    let _e477 = local_2.group_mask;
                    let _e491 = local_2.group_mask;
                    local_2.group_mask = (_e491 & ~((1u << bitcast<u32>((_e473 & 31u)))));
                    let _e494 = local_2.group;
                    phi_1094_ = (_e494 + countOneBits(((_e477 & ~((4294967295u << bitcast<u32>((((_e473 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1094_ = 4294967295u;
                }
                let _e497 = phi_1094_;
                phi_1096_ = _e497;
                phi_1099_ = false;
                loop {
                    let _e499 = phi_1096_;
                    let _e501 = phi_1099_;
                    if (_e499 != 4294967295u) {
                        if (_e499 < _e77) {
                        } else {
                            return;
                        }
                        let _e508 = nodes.member[(0u + _e499)].frame[3u];
                        let _e533 = (bitcast<f32>((((_e508 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e293);
                        let _e534 = (bitcast<f32>((((_e508 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e303);
                        let _e535 = (bitcast<f32>((((_e508 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e313);
                        let _e538 = nodes.member[(0u + _e499)].frame[0u];
                        let _e542 = nodes.member[(0u + _e499)].frame[1u];
                        let _e546 = nodes.member[(0u + _e499)].frame[2u];
                        let _e551 = ((bitcast<f32>(_e538) - _e137) * _e293);
                        let _e552 = ((bitcast<f32>(_e542) - _e139) * _e303);
                        let _e553 = ((bitcast<f32>(_e546) - _e141) * _e313);
                        let _e561 = nodes.member[(0u + _e499)].x;
                        if (_e293 < 0f) {
                            let _e572 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e561.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e578 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e572.unnamed.root, _e561.w), _e572.unnamed_1);
                            let _e584 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e578.unnamed, lt_bvh_traverse_Tree(_e561.x, _e578.unnamed_1.first_primitive));
                            phi_1179_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e584.unnamed, lt_bvh_traverse_Tree(_e584.unnamed_1.root, _e561.y));
                        } else {
                            let _e600 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e561.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e606 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e600.unnamed.root, _e561.y), _e600.unnamed_1);
                            let _e612 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e606.unnamed, lt_bvh_traverse_Tree(_e561.z, _e606.unnamed_1.first_primitive));
                            phi_1179_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e612.unnamed, lt_bvh_traverse_Tree(_e612.unnamed_1.root, _e561.w));
                        }
                        let _e620 = phi_1179_;
                        let _e630 = nodes.member[(0u + _e499)].y;
                        if (_e303 < 0f) {
                            let _e641 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e630.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e647 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e641.unnamed.root, _e630.w), _e641.unnamed_1);
                            let _e653 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e647.unnamed, lt_bvh_traverse_Tree(_e630.x, _e647.unnamed_1.first_primitive));
                            phi_1206_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e653.unnamed, lt_bvh_traverse_Tree(_e653.unnamed_1.root, _e630.y));
                        } else {
                            let _e669 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e630.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e675 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e669.unnamed.root, _e630.y), _e669.unnamed_1);
                            let _e681 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e675.unnamed, lt_bvh_traverse_Tree(_e630.z, _e675.unnamed_1.first_primitive));
                            phi_1206_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e681.unnamed, lt_bvh_traverse_Tree(_e681.unnamed_1.root, _e630.w));
                        }
                        let _e689 = phi_1206_;
                        let _e699 = nodes.member[(0u + _e499)].z;
                        if (_e313 < 0f) {
                            let _e710 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e699.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e716 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e710.unnamed.root, _e699.w), _e710.unnamed_1);
                            let _e722 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e716.unnamed, lt_bvh_traverse_Tree(_e699.x, _e716.unnamed_1.first_primitive));
                            phi_1233_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e722.unnamed, lt_bvh_traverse_Tree(_e722.unnamed_1.root, _e699.y));
                        } else {
                            let _e738 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e699.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e744 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e738.unnamed.root, _e699.y), _e738.unnamed_1);
                            let _e750 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e744.unnamed, lt_bvh_traverse_Tree(_e699.z, _e744.unnamed_1.first_primitive));
                            phi_1233_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e750.unnamed, lt_bvh_traverse_Tree(_e750.unnamed_1.root, _e699.w));
                        }
                        let _e758 = phi_1233_;
                        phi_1239_ = 0u;
                        phi_1242_ = 0u;
                        loop {
                            let _e768 = phi_1239_;
                            let _e770 = phi_1242_;
                            local_3 = _e770;
                            local_4 = _e770;
                            local_5 = _e770;
                            let _e771 = (_e768 < 8u);
                            if _e771 {
                                let _e773 = (_e768 >> bitcast<u32>(2i));
                                let _e774 = (_e768 & 3u);
                                if (_e773 == 0u) {
                                    phi_1256_ = _e620.unnamed.root;
                                } else {
                                    phi_1256_ = _e620.unnamed.first_primitive;
                                }
                                let _e777 = phi_1256_;
                                if (_e773 == 0u) {
                                    phi_1266_ = _e689.unnamed.root;
                                } else {
                                    phi_1266_ = _e689.unnamed.first_primitive;
                                }
                                let _e786 = phi_1266_;
                                if (_e773 == 0u) {
                                    phi_1276_ = _e758.unnamed.root;
                                } else {
                                    phi_1276_ = _e758.unnamed.first_primitive;
                                }
                                let _e795 = phi_1276_;
                                let _e808 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e777 >> bitcast<u32>(((_e774 * 8u) & 31u))) & 255u)) * _e533) + (_e551 - _e341)), ((f32(((_e786 >> bitcast<u32>(((_e774 * 8u) & 31u))) & 255u)) * _e534) + (_e552 - _e342)));
                                let _e809 = core_intrinsics_maximum_number_nsz_f32_(_e808, ((f32(((_e795 >> bitcast<u32>(((_e774 * 8u) & 31u))) & 255u)) * _e535) + (_e553 - _e343)));
                                if (_e773 == 0u) {
                                    phi_1294_ = _e620.unnamed_1.root;
                                } else {
                                    phi_1294_ = _e620.unnamed_1.first_primitive;
                                }
                                let _e812 = phi_1294_;
                                if (_e773 == 0u) {
                                    phi_1304_ = _e689.unnamed_1.root;
                                } else {
                                    phi_1304_ = _e689.unnamed_1.first_primitive;
                                }
                                let _e821 = phi_1304_;
                                if (_e773 == 0u) {
                                    phi_1314_ = _e758.unnamed_1.root;
                                } else {
                                    phi_1314_ = _e758.unnamed_1.first_primitive;
                                }
                                let _e830 = phi_1314_;
                                let _e843 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e812 >> bitcast<u32>(((_e774 * 8u) & 31u))) & 255u)) * _e533) + (_e551 + _e341)), ((f32(((_e821 >> bitcast<u32>(((_e774 * 8u) & 31u))) & 255u)) * _e534) + (_e552 + _e342)));
                                let _e844 = core_intrinsics_minimum_number_nsz_f32_(_e843, ((f32(((_e830 >> bitcast<u32>(((_e774 * 8u) & 31u))) & 255u)) * _e535) + (_e553 + _e343)));
                                if (_e809 <= _e844) {
                                    if (_e809 <= _e145) {
                                        if (_e844 >= 0f) {
                                            if (_e773 == 0u) {
                                                let _e851 = nodes.member[(0u + _e499)].links[2u];
                                                phi_1350_ = _e851;
                                            } else {
                                                let _e854 = nodes.member[(0u + _e499)].links[3u];
                                                phi_1350_ = _e854;
                                            }
                                            let _e856 = phi_1350_;
                                            let _e861 = ((_e856 >> bitcast<u32>(((_e774 * 8u) & 31u))) & 255u);
                                            let _e862 = (_e861 & 31u);
                                            if (_e862 >= 24u) {
                                                phi_1363_ = (24u + ((_e862 - 24u) ^ _e361));
                                            } else {
                                                phi_1363_ = _e862;
                                            }
                                            let _e868 = phi_1363_;
                                            phi_1368_ = (_e770 | ((_e861 >> bitcast<u32>(5i)) << bitcast<u32>((_e868 & 31u))));
                                        } else {
                                            phi_1368_ = _e770;
                                        }
                                        let _e876 = phi_1368_;
                                        phi_1369_ = _e876;
                                    } else {
                                        phi_1369_ = _e770;
                                    }
                                    let _e878 = phi_1369_;
                                    phi_1370_ = _e878;
                                } else {
                                    phi_1370_ = _e770;
                                }
                                let _e880 = phi_1370_;
                                phi_1240_ = (_e768 + 1u);
                                phi_1243_ = _e880;
                            } else {
                                phi_1240_ = u32();
                                phi_1243_ = u32();
                            }
                            let _e883 = phi_1240_;
                            let _e885 = phi_1243_;
                            continue;
                            continuing {
                                phi_1239_ = _e883;
                                phi_1242_ = _e885;
                                break if !(_e771);
                            }
                        }
                        let _e889 = nodes.member[(0u + _e499)].links[0u];
                        let _e893 = nodes.member[(0u + _e499)].frame[3u];
                        let _e897 = local_3;
                        if ((_e897 & 4278190080u) == 0u) {
                        } else {
                            let _e901 = local_2.group_mask;
                            if ((_e901 & 4278190080u) == 0u) {
                            } else {
                                let _e905 = local_2.len;
                                if (_e905 < 32u) {
                                    let _e908 = local_2.group;
                                    let _e910 = local_2.len;
                                    if (_e910 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.first[(0u + _e910)] = _e908;
                                    let _e916 = local_2.group_mask;
                                    let _e918 = local_2.len;
                                    if (_e918 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.mask[(0u + _e918)] = _e916;
                                    let _e925 = local_2.len;
                                    local_2.len = (_e925 + 1u);
                                }
                            }
                            local_2.group = (_e116 + _e889);
                            let _e929 = local_4;
                            local_2.group_mask = ((_e929 & 4278190080u) | (_e893 >> bitcast<u32>(24i)));
                        }
                        let _e934 = local_5;
                        phi_1428_ = (_e934 & 16777215u);
                        phi_1431_ = _e501;
                        loop {
                            let _e937 = phi_1428_;
                            let _e939 = phi_1431_;
                            local_18 = _e939;
                            let _e940 = (_e937 == 0u);
                            local_11 = _e940;
                            local_19 = _e940;
                            if _e940 {
                                phi_1429_ = u32();
                                phi_1432_ = bool();
                                phi_3283_ = false;
                            } else {
                                let _e943 = nodes.member[(0u + _e499)].links[1u];
                                let _e947 = (_e943 + select(firstTrailingBit(_e937), 32u, (_e937 == 0u)));
                                if (_e947 < arrayLength((&instances.member))) {
                                } else {
                                    return;
                                }
                                let _e954 = instances.member[(0u + _e947)].low_world;
                                let _e956 = instances.member[(0u + _e947)].high_world;
                                let _e963 = ((_e954.x - _e137) * _e293);
                                let _e964 = ((_e954.y - _e139) * _e303);
                                let _e965 = ((_e954.z - _e141) * _e313);
                                let _e972 = ((_e956.x - _e137) * _e293);
                                let _e973 = ((_e956.y - _e139) * _e303);
                                let _e974 = ((_e956.z - _e141) * _e313);
                                if (_e963 < _e972) {
                                    phi_1480_ = _e963;
                                } else {
                                    phi_1480_ = _e972;
                                }
                                let _e977 = phi_1480_;
                                if (_e964 < _e973) {
                                    phi_1485_ = _e964;
                                } else {
                                    phi_1485_ = _e973;
                                }
                                let _e980 = phi_1485_;
                                if (_e965 < _e974) {
                                    phi_1490_ = _e965;
                                } else {
                                    phi_1490_ = _e974;
                                }
                                let _e983 = phi_1490_;
                                if (_e963 > _e972) {
                                    phi_1498_ = _e963;
                                } else {
                                    phi_1498_ = _e972;
                                }
                                let _e989 = phi_1498_;
                                if (_e964 > _e973) {
                                    phi_1503_ = _e964;
                                } else {
                                    phi_1503_ = _e973;
                                }
                                let _e992 = phi_1503_;
                                if (_e965 > _e974) {
                                    phi_1508_ = _e965;
                                } else {
                                    phi_1508_ = _e974;
                                }
                                let _e995 = phi_1508_;
                                let _e999 = core_intrinsics_maximum_number_nsz_f32_((_e977 - _e348), (_e980 - _e349));
                                let _e1000 = core_intrinsics_maximum_number_nsz_f32_(_e999, (_e983 - _e350));
                                let _e1001 = core_intrinsics_minimum_number_nsz_f32_((_e989 + _e348), (_e992 + _e349));
                                let _e1002 = core_intrinsics_minimum_number_nsz_f32_(_e1001, (_e995 + _e350));
                                if (_e1000 <= _e1002) {
                                    if (_e1000 <= _e145) {
                                        if (_e1002 >= 0f) {
                                            let _e1008 = instances.member[(0u + _e947)].world_to_object[0u];
                                            let _e1019 = ((((_e1008.x * _e137) + (_e1008.y * _e139)) + (_e1008.z * _e141)) + (_e1008.w * 1f));
                                            let _e1021 = instances.member[(0u + _e947)].world_to_object[1u];
                                            let _e1032 = ((((_e1021.x * _e137) + (_e1021.y * _e139)) + (_e1021.z * _e141)) + (_e1021.w * 1f));
                                            let _e1034 = instances.member[(0u + _e947)].world_to_object[2u];
                                            let _e1045 = ((((_e1034.x * _e137) + (_e1034.y * _e139)) + (_e1034.z * _e141)) + (_e1034.w * 1f));
                                            let _e1048 = instances.member[(0u + _e947)].world_to_object[0u];
                                            let _e1059 = ((((_e1048.x * _e153) + (_e1048.y * _e154)) + (_e1048.z * _e155)) + (_e1048.w * 0f));
                                            let _e1061 = instances.member[(0u + _e947)].world_to_object[1u];
                                            let _e1072 = ((((_e1061.x * _e153) + (_e1061.y * _e154)) + (_e1061.z * _e155)) + (_e1061.w * 0f));
                                            let _e1074 = instances.member[(0u + _e947)].world_to_object[2u];
                                            let _e1085 = ((((_e1074.x * _e153) + (_e1074.y * _e154)) + (_e1074.z * _e155)) + (_e1074.w * 0f));
                                            let _e1088 = instances.member[(0u + _e947)].root;
                                            let _e1090 = instances.member[(0u + _e947)].first_triangle;
                                            let _e1094 = abs(_e1059);
                                            let _e1095 = abs(_e1072);
                                            let _e1096 = abs(_e1085);
                                            if (abs(_e1019) < 1000000000000000f) {
                                                if (abs(_e1032) < 1000000000000000f) {
                                                    if (abs(_e1045) < 1000000000000000f) {
                                                        if (_e1094 < 1000000000000000f) {
                                                            if (_e1095 < 1000000000000000f) {
                                                                if (_e1096 < 1000000000000000f) {
                                                                    if (_e1094 > 0f) {
                                                                        phi_1653_ = bool();
                                                                        phi_1654_ = true;
                                                                    } else {
                                                                        let _e1104 = (_e1095 > 0f);
                                                                        if _e1104 {
                                                                            phi_1652_ = bool();
                                                                        } else {
                                                                            phi_1652_ = (_e1096 > 0f);
                                                                        }
                                                                        let _e1107 = phi_1652_;
                                                                        phi_1653_ = _e1107;
                                                                        phi_1654_ = _e1104;
                                                                    }
                                                                    let _e1109 = phi_1653_;
                                                                    let _e1111 = phi_1654_;
                                                                    if _e1111 {
                                                                        phi_1658_ = true;
                                                                    } else {
                                                                        phi_1658_ = _e1109;
                                                                    }
                                                                    let _e1113 = phi_1658_;
                                                                    phi_1659_ = _e1113;
                                                                    phi_1660_ = false;
                                                                } else {
                                                                    phi_1659_ = bool();
                                                                    phi_1660_ = true;
                                                                }
                                                                let _e1115 = phi_1659_;
                                                                let _e1117 = phi_1660_;
                                                                phi_1661_ = _e1115;
                                                                phi_1662_ = false;
                                                                phi_1663_ = _e1117;
                                                            } else {
                                                                phi_1661_ = bool();
                                                                phi_1662_ = true;
                                                                phi_1663_ = false;
                                                            }
                                                            let _e1119 = phi_1661_;
                                                            let _e1121 = phi_1662_;
                                                            let _e1123 = phi_1663_;
                                                            phi_1664_ = _e1119;
                                                            phi_1665_ = _e1121;
                                                            phi_1666_ = _e1123;
                                                        } else {
                                                            phi_1664_ = bool();
                                                            phi_1665_ = true;
                                                            phi_1666_ = false;
                                                        }
                                                        let _e1125 = phi_1664_;
                                                        let _e1127 = phi_1665_;
                                                        let _e1129 = phi_1666_;
                                                        phi_1667_ = _e1125;
                                                        phi_1668_ = _e1127;
                                                        phi_1669_ = _e1129;
                                                    } else {
                                                        phi_1667_ = bool();
                                                        phi_1668_ = true;
                                                        phi_1669_ = false;
                                                    }
                                                    let _e1131 = phi_1667_;
                                                    let _e1133 = phi_1668_;
                                                    let _e1135 = phi_1669_;
                                                    phi_1670_ = _e1131;
                                                    phi_1671_ = _e1133;
                                                    phi_1672_ = _e1135;
                                                } else {
                                                    phi_1670_ = bool();
                                                    phi_1671_ = true;
                                                    phi_1672_ = false;
                                                }
                                                let _e1137 = phi_1670_;
                                                let _e1139 = phi_1671_;
                                                let _e1141 = phi_1672_;
                                                phi_1673_ = _e1137;
                                                phi_1674_ = _e1139;
                                                phi_1675_ = _e1141;
                                            } else {
                                                phi_1673_ = bool();
                                                phi_1674_ = true;
                                                phi_1675_ = false;
                                            }
                                            let _e1143 = phi_1673_;
                                            let _e1145 = phi_1674_;
                                            let _e1147 = phi_1675_;
                                            if _e1145 {
                                                phi_1679_ = true;
                                            } else {
                                                phi_1679_ = _e1147;
                                            }
                                            let _e1149 = phi_1679_;
                                            if _e1149 {
                                                phi_1683_ = false;
                                            } else {
                                                phi_1683_ = _e1143;
                                            }
                                            let _e1151 = phi_1683_;
                                            if _e1151 {
                                                let _e1152 = (_e1088 >= _e77);
                                                if _e1152 {
                                                    phi_3263_ = bool();
                                                } else {
                                                    if (_e1088 < _e77) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1158 = nodes.member[(0u + _e1088)].frame[0u];
                                                    let _e1162 = nodes.member[(0u + _e1088)].frame[1u];
                                                    let _e1166 = nodes.member[(0u + _e1088)].frame[2u];
                                                    let _e1170 = nodes.member[(0u + _e1088)].frame[0u];
                                                    let _e1174 = nodes.member[(0u + _e1088)].frame[1u];
                                                    let _e1178 = nodes.member[(0u + _e1088)].frame[2u];
                                                    let _e1182 = nodes.member[(0u + _e1088)].frame[3u];
                                                    let _e1216 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1059), abs(_e1072));
                                                    let _e1217 = core_intrinsics_maximum_number_nsz_f32_(_e1216, abs(_e1085));
                                                    let _e1218 = (_e1217 * 0.0000000000009094947f);
                                                    if (abs(_e1059) < _e1218) {
                                                        phi_1753_ = _e1218;
                                                    } else {
                                                        phi_1753_ = abs(_e1059);
                                                    }
                                                    let _e1223 = phi_1753_;
                                                    if (_e1059 < 0f) {
                                                        phi_1760_ = (-1f / _e1223);
                                                    } else {
                                                        phi_1760_ = (1f / _e1223);
                                                    }
                                                    let _e1228 = phi_1760_;
                                                    if (abs(_e1072) < _e1218) {
                                                        phi_1767_ = _e1218;
                                                    } else {
                                                        phi_1767_ = abs(_e1072);
                                                    }
                                                    let _e1233 = phi_1767_;
                                                    if (_e1072 < 0f) {
                                                        phi_1774_ = (-1f / _e1233);
                                                    } else {
                                                        phi_1774_ = (1f / _e1233);
                                                    }
                                                    let _e1238 = phi_1774_;
                                                    if (abs(_e1085) < _e1218) {
                                                        phi_1781_ = _e1218;
                                                    } else {
                                                        phi_1781_ = abs(_e1085);
                                                    }
                                                    let _e1243 = phi_1781_;
                                                    if (_e1085 < 0f) {
                                                        phi_1788_ = (-1f / _e1243);
                                                    } else {
                                                        phi_1788_ = (1f / _e1243);
                                                    }
                                                    let _e1248 = phi_1788_;
                                                    let _e1252 = abs((bitcast<f32>(_e1158) - _e1019));
                                                    let _e1253 = abs((bitcast<f32>(_e1162) - _e1032));
                                                    let _e1254 = abs((bitcast<f32>(_e1166) - _e1045));
                                                    let _e1258 = abs(((bitcast<f32>(_e1170) + (bitcast<f32>((((_e1182 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1019));
                                                    let _e1259 = abs(((bitcast<f32>(_e1174) + (bitcast<f32>((((_e1182 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1032));
                                                    let _e1260 = abs(((bitcast<f32>(_e1178) + (bitcast<f32>((((_e1182 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1045));
                                                    if (_e1252 > _e1258) {
                                                        phi_1805_ = _e1252;
                                                    } else {
                                                        phi_1805_ = _e1258;
                                                    }
                                                    let _e1263 = phi_1805_;
                                                    if (_e1253 > _e1259) {
                                                        phi_1810_ = _e1253;
                                                    } else {
                                                        phi_1810_ = _e1259;
                                                    }
                                                    let _e1266 = phi_1810_;
                                                    if (_e1254 > _e1260) {
                                                        phi_1815_ = _e1254;
                                                    } else {
                                                        phi_1815_ = _e1260;
                                                    }
                                                    let _e1269 = phi_1815_;
                                                    let _e1270 = core_intrinsics_maximum_number_nsz_f32_(_e1263, _e1266);
                                                    let _e1271 = core_intrinsics_maximum_number_nsz_f32_(_e1270, _e1269);
                                                    let _e1275 = (_e1271 * 0.0000019073486f);
                                                    let _e1276 = (abs(_e1228) * _e1275);
                                                    let _e1277 = (abs(_e1238) * _e1275);
                                                    let _e1278 = (abs(_e1248) * _e1275);
                                                    let _e1282 = (_e1271 * 0.0000009536743f);
                                                    let _e1283 = (abs(_e1228) * _e1282);
                                                    let _e1284 = (abs(_e1238) * _e1282);
                                                    let _e1285 = (abs(_e1248) * _e1282);
                                                    let _e1286 = abs(_e1059);
                                                    let _e1287 = abs(_e1072);
                                                    let _e1288 = abs(_e1085);
                                                    if (_e1286 >= _e1287) {
                                                        if (_e1286 >= _e1288) {
                                                            phi_1843_ = false;
                                                        } else {
                                                            phi_1843_ = true;
                                                        }
                                                        let _e1292 = phi_1843_;
                                                        phi_1844_ = _e1292;
                                                    } else {
                                                        phi_1844_ = true;
                                                    }
                                                    let _e1294 = phi_1844_;
                                                    if _e1294 {
                                                        if (_e1287 >= _e1288) {
                                                            phi_1852_ = 1u;
                                                        } else {
                                                            phi_1852_ = 2u;
                                                        }
                                                        let _e1297 = phi_1852_;
                                                        phi_1853_ = _e1297;
                                                    } else {
                                                        phi_1853_ = 0u;
                                                    }
                                                    let _e1299 = phi_1853_;
                                                    if (_e1299 == 0u) {
                                                        phi_1865_ = vec3<f32>(_e1072, _e1085, _e1059);
                                                    } else {
                                                        if (_e1299 == 1u) {
                                                            phi_1864_ = vec3<f32>(_e1085, _e1059, _e1072);
                                                        } else {
                                                            phi_1864_ = vec3<f32>(_e1059, _e1072, _e1085);
                                                        }
                                                        let _e1305 = phi_1864_;
                                                        phi_1865_ = _e1305;
                                                    }
                                                    let _e1307 = phi_1865_;
                                                    let _e1310 = (_e1307.x / _e1307.z);
                                                    let _e1313 = (_e1307.y / _e1307.z);
                                                    if (_e1228 < 0f) {
                                                        phi_1878_ = 0u;
                                                    } else {
                                                        phi_1878_ = 1u;
                                                    }
                                                    let _e1318 = phi_1878_;
                                                    if (_e1238 < 0f) {
                                                        phi_1883_ = 0u;
                                                    } else {
                                                        phi_1883_ = 2u;
                                                    }
                                                    let _e1321 = phi_1883_;
                                                    if (_e1248 < 0f) {
                                                        phi_1888_ = 0u;
                                                    } else {
                                                        phi_1888_ = 4u;
                                                    }
                                                    let _e1324 = phi_1888_;
                                                    let _e1326 = ((_e1318 | _e1321) | _e1324);
                                                    let _e1327 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1088, 2147483648u);
                                                    local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e1327.first[0], _e1327.first[1], _e1327.first[2], _e1327.first[3], _e1327.first[4], _e1327.first[5], _e1327.first[6], _e1327.first[7], _e1327.first[8], _e1327.first[9], _e1327.first[10], _e1327.first[11], _e1327.first[12], _e1327.first[13], _e1327.first[14], _e1327.first[15], _e1327.first[16], _e1327.first[17], _e1327.first[18], _e1327.first[19], _e1327.first[20], _e1327.first[21], _e1327.first[22], _e1327.first[23], _e1327.first[24], _e1327.first[25], _e1327.first[26], _e1327.first[27], _e1327.first[28], _e1327.first[29], _e1327.first[30], _e1327.first[31]), array<u32, 32>(_e1327.mask[0], _e1327.mask[1], _e1327.mask[2], _e1327.mask[3], _e1327.mask[4], _e1327.mask[5], _e1327.mask[6], _e1327.mask[7], _e1327.mask[8], _e1327.mask[9], _e1327.mask[10], _e1327.mask[11], _e1327.mask[12], _e1327.mask[13], _e1327.mask[14], _e1327.mask[15], _e1327.mask[16], _e1327.mask[17], _e1327.mask[18], _e1327.mask[19], _e1327.mask[20], _e1327.mask[21], _e1327.mask[22], _e1327.mask[23], _e1327.mask[24], _e1327.mask[25], _e1327.mask[26], _e1327.mask[27], _e1327.mask[28], _e1327.mask[29], _e1327.mask[30], _e1327.mask[31]), _e1327.len, _e1327.group, _e1327.group_mask);
                                                    let _e1401 = local_1.group_mask;
                                                    if ((_e1401 & 4278190080u) == 0u) {
                                                        let _e1405 = local_1.len;
                                                        if (_e1405 == 0u) {
                                                            phi_2002_ = false;
                                                        } else {
                                                            let _e1409 = local_1.len;
                                                            local_1.len = (_e1409 - 1u);
                                                            let _e1412 = local_1.len;
                                                            if (_e1412 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1417 = local_1.first[(0u + _e1412)];
                                                            local_1.group = _e1417;
                                                            let _e1420 = local_1.len;
                                                            if (_e1420 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1425 = local_1.mask[(0u + _e1420)];
                                                            local_1.group_mask = _e1425;
                                                            phi_2002_ = true;
                                                        }
                                                        let _e1428 = phi_2002_;
                                                        phi_2003_ = _e1428;
                                                    } else {
                                                        phi_2003_ = true;
                                                    }
                                                    let _e1430 = phi_2003_;
                                                    if _e1430 {
                                                        let _e1432 = local_1.group_mask;
                                                        let _e1438 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1432)), 32u, (_e1432 == 0u)));
                                                        let _e1442 = local_1.group_mask;
                                                        let _e1456 = local_1.group_mask;
                                                        local_1.group_mask = (_e1456 & ~((1u << bitcast<u32>((_e1438 & 31u)))));
                                                        let _e1459 = local_1.group;
                                                        phi_2034_ = (_e1459 + countOneBits(((_e1442 & ~((4294967295u << bitcast<u32>((((_e1438 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_2034_ = 4294967295u;
                                                    }
                                                    let _e1462 = phi_2034_;
                                                    phi_2036_ = _e1462;
                                                    phi_2039_ = _e939;
                                                    loop {
                                                        let _e1464 = phi_2036_;
                                                        let _e1466 = phi_2039_;
                                                        local_17 = _e1466;
                                                        if (_e1464 != 4294967295u) {
                                                            if (_e1464 < _e77) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1473 = nodes.member[(0u + _e1464)].frame[3u];
                                                            let _e1498 = (bitcast<f32>((((_e1473 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1228);
                                                            let _e1499 = (bitcast<f32>((((_e1473 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1238);
                                                            let _e1500 = (bitcast<f32>((((_e1473 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1248);
                                                            let _e1503 = nodes.member[(0u + _e1464)].frame[0u];
                                                            let _e1507 = nodes.member[(0u + _e1464)].frame[1u];
                                                            let _e1511 = nodes.member[(0u + _e1464)].frame[2u];
                                                            let _e1516 = ((bitcast<f32>(_e1503) - _e1019) * _e1228);
                                                            let _e1517 = ((bitcast<f32>(_e1507) - _e1032) * _e1238);
                                                            let _e1518 = ((bitcast<f32>(_e1511) - _e1045) * _e1248);
                                                            let _e1526 = nodes.member[(0u + _e1464)].x;
                                                            if (_e1228 < 0f) {
                                                                let _e1537 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1526.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1543 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1537.unnamed.root, _e1526.w), _e1537.unnamed_1);
                                                                let _e1549 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1543.unnamed, lt_bvh_traverse_Tree(_e1526.x, _e1543.unnamed_1.first_primitive));
                                                                phi_2119_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1549.unnamed, lt_bvh_traverse_Tree(_e1549.unnamed_1.root, _e1526.y));
                                                            } else {
                                                                let _e1565 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1526.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1571 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1565.unnamed.root, _e1526.y), _e1565.unnamed_1);
                                                                let _e1577 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1571.unnamed, lt_bvh_traverse_Tree(_e1526.z, _e1571.unnamed_1.first_primitive));
                                                                phi_2119_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1577.unnamed, lt_bvh_traverse_Tree(_e1577.unnamed_1.root, _e1526.w));
                                                            }
                                                            let _e1585 = phi_2119_;
                                                            let _e1595 = nodes.member[(0u + _e1464)].y;
                                                            if (_e1238 < 0f) {
                                                                let _e1606 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1595.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1612 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1606.unnamed.root, _e1595.w), _e1606.unnamed_1);
                                                                let _e1618 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1612.unnamed, lt_bvh_traverse_Tree(_e1595.x, _e1612.unnamed_1.first_primitive));
                                                                phi_2146_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1618.unnamed, lt_bvh_traverse_Tree(_e1618.unnamed_1.root, _e1595.y));
                                                            } else {
                                                                let _e1634 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1595.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1640 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1634.unnamed.root, _e1595.y), _e1634.unnamed_1);
                                                                let _e1646 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1640.unnamed, lt_bvh_traverse_Tree(_e1595.z, _e1640.unnamed_1.first_primitive));
                                                                phi_2146_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1646.unnamed, lt_bvh_traverse_Tree(_e1646.unnamed_1.root, _e1595.w));
                                                            }
                                                            let _e1654 = phi_2146_;
                                                            let _e1664 = nodes.member[(0u + _e1464)].z;
                                                            if (_e1248 < 0f) {
                                                                let _e1675 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1664.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1681 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1675.unnamed.root, _e1664.w), _e1675.unnamed_1);
                                                                let _e1687 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1681.unnamed, lt_bvh_traverse_Tree(_e1664.x, _e1681.unnamed_1.first_primitive));
                                                                phi_2173_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1687.unnamed, lt_bvh_traverse_Tree(_e1687.unnamed_1.root, _e1664.y));
                                                            } else {
                                                                let _e1703 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1664.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1709 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1703.unnamed.root, _e1664.y), _e1703.unnamed_1);
                                                                let _e1715 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1709.unnamed, lt_bvh_traverse_Tree(_e1664.z, _e1709.unnamed_1.first_primitive));
                                                                phi_2173_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1715.unnamed, lt_bvh_traverse_Tree(_e1715.unnamed_1.root, _e1664.w));
                                                            }
                                                            let _e1723 = phi_2173_;
                                                            phi_2179_ = 0u;
                                                            phi_2182_ = 0u;
                                                            loop {
                                                                let _e1733 = phi_2179_;
                                                                let _e1735 = phi_2182_;
                                                                local_6 = _e1735;
                                                                local_7 = _e1735;
                                                                local_8 = _e1735;
                                                                let _e1736 = (_e1733 < 8u);
                                                                if _e1736 {
                                                                    let _e1738 = (_e1733 >> bitcast<u32>(2i));
                                                                    let _e1739 = (_e1733 & 3u);
                                                                    if (_e1738 == 0u) {
                                                                        phi_2196_ = _e1585.unnamed.root;
                                                                    } else {
                                                                        phi_2196_ = _e1585.unnamed.first_primitive;
                                                                    }
                                                                    let _e1742 = phi_2196_;
                                                                    if (_e1738 == 0u) {
                                                                        phi_2206_ = _e1654.unnamed.root;
                                                                    } else {
                                                                        phi_2206_ = _e1654.unnamed.first_primitive;
                                                                    }
                                                                    let _e1751 = phi_2206_;
                                                                    if (_e1738 == 0u) {
                                                                        phi_2216_ = _e1723.unnamed.root;
                                                                    } else {
                                                                        phi_2216_ = _e1723.unnamed.first_primitive;
                                                                    }
                                                                    let _e1760 = phi_2216_;
                                                                    let _e1773 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1742 >> bitcast<u32>(((_e1739 * 8u) & 31u))) & 255u)) * _e1498) + (_e1516 - _e1276)), ((f32(((_e1751 >> bitcast<u32>(((_e1739 * 8u) & 31u))) & 255u)) * _e1499) + (_e1517 - _e1277)));
                                                                    let _e1774 = core_intrinsics_maximum_number_nsz_f32_(_e1773, ((f32(((_e1760 >> bitcast<u32>(((_e1739 * 8u) & 31u))) & 255u)) * _e1500) + (_e1518 - _e1278)));
                                                                    if (_e1738 == 0u) {
                                                                        phi_2234_ = _e1585.unnamed_1.root;
                                                                    } else {
                                                                        phi_2234_ = _e1585.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1777 = phi_2234_;
                                                                    if (_e1738 == 0u) {
                                                                        phi_2244_ = _e1654.unnamed_1.root;
                                                                    } else {
                                                                        phi_2244_ = _e1654.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1786 = phi_2244_;
                                                                    if (_e1738 == 0u) {
                                                                        phi_2254_ = _e1723.unnamed_1.root;
                                                                    } else {
                                                                        phi_2254_ = _e1723.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1795 = phi_2254_;
                                                                    let _e1808 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1777 >> bitcast<u32>(((_e1739 * 8u) & 31u))) & 255u)) * _e1498) + (_e1516 + _e1276)), ((f32(((_e1786 >> bitcast<u32>(((_e1739 * 8u) & 31u))) & 255u)) * _e1499) + (_e1517 + _e1277)));
                                                                    let _e1809 = core_intrinsics_minimum_number_nsz_f32_(_e1808, ((f32(((_e1795 >> bitcast<u32>(((_e1739 * 8u) & 31u))) & 255u)) * _e1500) + (_e1518 + _e1278)));
                                                                    if (_e1774 <= _e1809) {
                                                                        if (_e1774 <= _e145) {
                                                                            if (_e1809 >= 0f) {
                                                                                if (_e1738 == 0u) {
                                                                                    let _e1816 = nodes.member[(0u + _e1464)].links[2u];
                                                                                    phi_2290_ = _e1816;
                                                                                } else {
                                                                                    let _e1819 = nodes.member[(0u + _e1464)].links[3u];
                                                                                    phi_2290_ = _e1819;
                                                                                }
                                                                                let _e1821 = phi_2290_;
                                                                                let _e1826 = ((_e1821 >> bitcast<u32>(((_e1739 * 8u) & 31u))) & 255u);
                                                                                let _e1827 = (_e1826 & 31u);
                                                                                if (_e1827 >= 24u) {
                                                                                    phi_2303_ = (24u + ((_e1827 - 24u) ^ _e1326));
                                                                                } else {
                                                                                    phi_2303_ = _e1827;
                                                                                }
                                                                                let _e1833 = phi_2303_;
                                                                                phi_2308_ = (_e1735 | ((_e1826 >> bitcast<u32>(5i)) << bitcast<u32>((_e1833 & 31u))));
                                                                            } else {
                                                                                phi_2308_ = _e1735;
                                                                            }
                                                                            let _e1841 = phi_2308_;
                                                                            phi_2309_ = _e1841;
                                                                        } else {
                                                                            phi_2309_ = _e1735;
                                                                        }
                                                                        let _e1843 = phi_2309_;
                                                                        phi_2310_ = _e1843;
                                                                    } else {
                                                                        phi_2310_ = _e1735;
                                                                    }
                                                                    let _e1845 = phi_2310_;
                                                                    phi_2180_ = (_e1733 + 1u);
                                                                    phi_2183_ = _e1845;
                                                                } else {
                                                                    phi_2180_ = u32();
                                                                    phi_2183_ = u32();
                                                                }
                                                                let _e1848 = phi_2180_;
                                                                let _e1850 = phi_2183_;
                                                                continue;
                                                                continuing {
                                                                    phi_2179_ = _e1848;
                                                                    phi_2182_ = _e1850;
                                                                    break if !(_e1736);
                                                                }
                                                            }
                                                            let _e1854 = nodes.member[(0u + _e1464)].links[0u];
                                                            let _e1858 = nodes.member[(0u + _e1464)].frame[3u];
                                                            let _e1862 = local_6;
                                                            if ((_e1862 & 4278190080u) == 0u) {
                                                            } else {
                                                                let _e1866 = local_1.group_mask;
                                                                if ((_e1866 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1870 = local_1.len;
                                                                    if (_e1870 < 32u) {
                                                                        let _e1873 = local_1.group;
                                                                        let _e1875 = local_1.len;
                                                                        if (_e1875 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_1.first[(0u + _e1875)] = _e1873;
                                                                        let _e1881 = local_1.group_mask;
                                                                        let _e1883 = local_1.len;
                                                                        if (_e1883 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_1.mask[(0u + _e1883)] = _e1881;
                                                                        let _e1890 = local_1.len;
                                                                        local_1.len = (_e1890 + 1u);
                                                                    }
                                                                }
                                                                local_1.group = (_e1088 + _e1854);
                                                                let _e1894 = local_7;
                                                                local_1.group_mask = ((_e1894 & 4278190080u) | (_e1858 >> bitcast<u32>(24i)));
                                                            }
                                                            let _e1899 = local_8;
                                                            phi_2368_ = (_e1899 & 16777215u);
                                                            phi_2371_ = _e1466;
                                                            loop {
                                                                let _e1902 = phi_2368_;
                                                                let _e1904 = phi_2371_;
                                                                local_13 = _e1904;
                                                                let _e1905 = (_e1902 == 0u);
                                                                local_9 = _e1905;
                                                                local_15 = _e1905;
                                                                if _e1905 {
                                                                    phi_2369_ = u32();
                                                                    phi_2372_ = bool();
                                                                    phi_3175_ = bool();
                                                                    phi_3176_ = false;
                                                                } else {
                                                                    let _e1908 = nodes.member[(0u + _e1464)].links[1u];
                                                                    let _e1913 = ((_e1090 + _e1908) + select(firstTrailingBit(_e1902), 32u, (_e1902 == 0u)));
                                                                    if (_e1913 < _e80) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1920 = triangles.member[(0u + _e1913)].v0_;
                                                                    let _e1922 = (_e1920.x - _e1019);
                                                                    let _e1924 = (_e1920.y - _e1032);
                                                                    let _e1926 = (_e1920.z - _e1045);
                                                                    if (_e1299 == 0u) {
                                                                        phi_2416_ = vec3<f32>(_e1924, _e1926, _e1922);
                                                                    } else {
                                                                        if (_e1299 == 1u) {
                                                                            phi_2415_ = vec3<f32>(_e1926, _e1922, _e1924);
                                                                        } else {
                                                                            phi_2415_ = (_e1920 - vec3<f32>(_e1019, _e1032, _e1045));
                                                                        }
                                                                        let _e1934 = phi_2415_;
                                                                        phi_2416_ = _e1934;
                                                                    }
                                                                    let _e1936 = phi_2416_;
                                                                    let _e1940 = (_e1936.x - (_e1310 * _e1936.z));
                                                                    let _e1944 = (_e1936.y - (_e1313 * _e1936.z));
                                                                    let _e1946 = triangles.member[(0u + _e1913)].v1_;
                                                                    let _e1948 = (_e1946.x - _e1019);
                                                                    let _e1950 = (_e1946.y - _e1032);
                                                                    let _e1952 = (_e1946.z - _e1045);
                                                                    if (_e1299 == 0u) {
                                                                        phi_2446_ = vec3<f32>(_e1950, _e1952, _e1948);
                                                                    } else {
                                                                        if (_e1299 == 1u) {
                                                                            phi_2445_ = vec3<f32>(_e1952, _e1948, _e1950);
                                                                        } else {
                                                                            phi_2445_ = (_e1946 - vec3<f32>(_e1019, _e1032, _e1045));
                                                                        }
                                                                        let _e1960 = phi_2445_;
                                                                        phi_2446_ = _e1960;
                                                                    }
                                                                    let _e1962 = phi_2446_;
                                                                    let _e1966 = (_e1962.x - (_e1310 * _e1962.z));
                                                                    let _e1970 = (_e1962.y - (_e1313 * _e1962.z));
                                                                    let _e1972 = triangles.member[(0u + _e1913)].v2_;
                                                                    let _e1974 = (_e1972.x - _e1019);
                                                                    let _e1976 = (_e1972.y - _e1032);
                                                                    let _e1978 = (_e1972.z - _e1045);
                                                                    if (_e1299 == 0u) {
                                                                        phi_2476_ = vec3<f32>(_e1976, _e1978, _e1974);
                                                                    } else {
                                                                        if (_e1299 == 1u) {
                                                                            phi_2475_ = vec3<f32>(_e1978, _e1974, _e1976);
                                                                        } else {
                                                                            phi_2475_ = (_e1972 - vec3<f32>(_e1019, _e1032, _e1045));
                                                                        }
                                                                        let _e1986 = phi_2475_;
                                                                        phi_2476_ = _e1986;
                                                                    }
                                                                    let _e1988 = phi_2476_;
                                                                    let _e1992 = (_e1988.x - (_e1310 * _e1988.z));
                                                                    let _e1996 = (_e1988.y - (_e1313 * _e1988.z));
                                                                    if (_e1966 < _e1992) {
                                                                        phi_2495_ = true;
                                                                    } else {
                                                                        if (_e1966 == _e1992) {
                                                                            phi_2494_ = (_e1970 < _e1996);
                                                                        } else {
                                                                            phi_2494_ = false;
                                                                        }
                                                                        let _e2001 = phi_2494_;
                                                                        phi_2495_ = _e2001;
                                                                    }
                                                                    let _e2003 = phi_2495_;
                                                                    if _e2003 {
                                                                        phi_2499_ = _e1996;
                                                                        phi_2500_ = _e1992;
                                                                        phi_2501_ = _e1970;
                                                                        phi_2502_ = _e1966;
                                                                    } else {
                                                                        phi_2499_ = _e1970;
                                                                        phi_2500_ = _e1966;
                                                                        phi_2501_ = _e1996;
                                                                        phi_2502_ = _e1992;
                                                                    }
                                                                    let _e2005 = phi_2499_;
                                                                    let _e2007 = phi_2500_;
                                                                    let _e2009 = phi_2501_;
                                                                    let _e2011 = phi_2502_;
                                                                    let _e2014 = ((_e2011 * _e2005) - (_e2009 * _e2007));
                                                                    if _e2003 {
                                                                        phi_2510_ = -(_e2014);
                                                                    } else {
                                                                        phi_2510_ = _e2014;
                                                                    }
                                                                    let _e2017 = phi_2510_;
                                                                    if (_e1992 < _e1940) {
                                                                        phi_2521_ = true;
                                                                    } else {
                                                                        if (_e1992 == _e1940) {
                                                                            phi_2520_ = (_e1996 < _e1944);
                                                                        } else {
                                                                            phi_2520_ = false;
                                                                        }
                                                                        let _e2022 = phi_2520_;
                                                                        phi_2521_ = _e2022;
                                                                    }
                                                                    let _e2024 = phi_2521_;
                                                                    if _e2024 {
                                                                        phi_2525_ = _e1944;
                                                                        phi_2526_ = _e1940;
                                                                        phi_2527_ = _e1996;
                                                                        phi_2528_ = _e1992;
                                                                    } else {
                                                                        phi_2525_ = _e1996;
                                                                        phi_2526_ = _e1992;
                                                                        phi_2527_ = _e1944;
                                                                        phi_2528_ = _e1940;
                                                                    }
                                                                    let _e2026 = phi_2525_;
                                                                    let _e2028 = phi_2526_;
                                                                    let _e2030 = phi_2527_;
                                                                    let _e2032 = phi_2528_;
                                                                    let _e2035 = ((_e2032 * _e2026) - (_e2030 * _e2028));
                                                                    if _e2024 {
                                                                        phi_2536_ = -(_e2035);
                                                                    } else {
                                                                        phi_2536_ = _e2035;
                                                                    }
                                                                    let _e2038 = phi_2536_;
                                                                    if (_e1940 < _e1966) {
                                                                        phi_2547_ = true;
                                                                    } else {
                                                                        if (_e1940 == _e1966) {
                                                                            phi_2546_ = (_e1944 < _e1970);
                                                                        } else {
                                                                            phi_2546_ = false;
                                                                        }
                                                                        let _e2043 = phi_2546_;
                                                                        phi_2547_ = _e2043;
                                                                    }
                                                                    let _e2045 = phi_2547_;
                                                                    if _e2045 {
                                                                        phi_2551_ = _e1970;
                                                                        phi_2552_ = _e1966;
                                                                        phi_2553_ = _e1944;
                                                                        phi_2554_ = _e1940;
                                                                    } else {
                                                                        phi_2551_ = _e1944;
                                                                        phi_2552_ = _e1940;
                                                                        phi_2553_ = _e1970;
                                                                        phi_2554_ = _e1966;
                                                                    }
                                                                    let _e2047 = phi_2551_;
                                                                    let _e2049 = phi_2552_;
                                                                    let _e2051 = phi_2553_;
                                                                    let _e2053 = phi_2554_;
                                                                    let _e2056 = ((_e2053 * _e2047) - (_e2051 * _e2049));
                                                                    if _e2045 {
                                                                        phi_2562_ = -(_e2056);
                                                                    } else {
                                                                        phi_2562_ = _e2056;
                                                                    }
                                                                    let _e2059 = phi_2562_;
                                                                    if (_e2017 >= 0f) {
                                                                        if (_e2038 >= 0f) {
                                                                            if (_e2059 >= 0f) {
                                                                                phi_2577_ = ((_e2017 + _e2038) + _e2059);
                                                                                phi_2578_ = false;
                                                                            } else {
                                                                                phi_2577_ = f32();
                                                                                phi_2578_ = true;
                                                                            }
                                                                            let _e2066 = phi_2577_;
                                                                            let _e2068 = phi_2578_;
                                                                            phi_2579_ = _e2066;
                                                                            phi_2580_ = _e2068;
                                                                        } else {
                                                                            phi_2579_ = f32();
                                                                            phi_2580_ = true;
                                                                        }
                                                                        let _e2070 = phi_2579_;
                                                                        let _e2072 = phi_2580_;
                                                                        phi_2581_ = _e2070;
                                                                        phi_2582_ = _e2072;
                                                                    } else {
                                                                        phi_2581_ = f32();
                                                                        phi_2582_ = true;
                                                                    }
                                                                    let _e2074 = phi_2581_;
                                                                    let _e2076 = phi_2582_;
                                                                    if _e2076 {
                                                                        if (_e2017 <= 0f) {
                                                                            if (_e2038 <= 0f) {
                                                                                let _e2079 = (_e2059 <= 0f);
                                                                                if _e2079 {
                                                                                }
                                                                                phi_2600_ = ((_e2017 + _e2038) + _e2059);
                                                                                phi_2601_ = false;
                                                                                phi_2602_ = _e2079;
                                                                            } else {
                                                                                phi_2600_ = f32();
                                                                                phi_2601_ = true;
                                                                                phi_2602_ = false;
                                                                            }
                                                                            let _e2083 = phi_2600_;
                                                                            let _e2085 = phi_2601_;
                                                                            let _e2087 = phi_2602_;
                                                                            phi_2603_ = _e2083;
                                                                            phi_2604_ = _e2085;
                                                                            phi_2605_ = _e2087;
                                                                        } else {
                                                                            phi_2603_ = f32();
                                                                            phi_2604_ = true;
                                                                            phi_2605_ = false;
                                                                        }
                                                                        let _e2089 = phi_2603_;
                                                                        let _e2091 = phi_2604_;
                                                                        let _e2093 = phi_2605_;
                                                                        if _e2091 {
                                                                            phi_2609_ = false;
                                                                        } else {
                                                                            phi_2609_ = _e2093;
                                                                        }
                                                                        let _e2095 = phi_2609_;
                                                                        phi_2610_ = _e2089;
                                                                        phi_2611_ = _e2095;
                                                                    } else {
                                                                        phi_2610_ = _e2074;
                                                                        phi_2611_ = true;
                                                                    }
                                                                    let _e2097 = phi_2610_;
                                                                    let _e2099 = phi_2611_;
                                                                    if _e2099 {
                                                                        let _e2100 = (_e2097 == 0f);
                                                                        if _e2100 {
                                                                            phi_2927_ = lt_bvh_triangle_Intersection();
                                                                            phi_2928_ = false;
                                                                        } else {
                                                                            let _e2102 = triangles.member[(0u + _e1913)].v0_;
                                                                            let _e2104 = (_e2102.x - _e1019);
                                                                            let _e2106 = (_e2102.y - _e1032);
                                                                            let _e2108 = (_e2102.z - _e1045);
                                                                            if (_e1299 == 0u) {
                                                                                phi_2640_ = vec3<f32>(_e2106, _e2108, _e2104);
                                                                            } else {
                                                                                if (_e1299 == 1u) {
                                                                                    phi_2639_ = vec3<f32>(_e2108, _e2104, _e2106);
                                                                                } else {
                                                                                    phi_2639_ = (_e2102 - vec3<f32>(_e1019, _e1032, _e1045));
                                                                                }
                                                                                let _e2116 = phi_2639_;
                                                                                phi_2640_ = _e2116;
                                                                            }
                                                                            let _e2118 = phi_2640_;
                                                                            let _e2120 = triangles.member[(0u + _e1913)].v1_;
                                                                            let _e2122 = triangles.member[(0u + _e1913)].v0_;
                                                                            let _e2125 = (_e2120.x - _e2122.x);
                                                                            let _e2128 = (_e2120.y - _e2122.y);
                                                                            let _e2131 = (_e2120.z - _e2122.z);
                                                                            if (_e1299 == 0u) {
                                                                                phi_2666_ = vec3<f32>(_e2128, _e2131, _e2125);
                                                                            } else {
                                                                                if (_e1299 == 1u) {
                                                                                    phi_2665_ = vec3<f32>(_e2131, _e2125, _e2128);
                                                                                } else {
                                                                                    phi_2665_ = (_e2120 - _e2122);
                                                                                }
                                                                                let _e2138 = phi_2665_;
                                                                                phi_2666_ = _e2138;
                                                                            }
                                                                            let _e2140 = phi_2666_;
                                                                            let _e2142 = triangles.member[(0u + _e1913)].v2_;
                                                                            let _e2144 = triangles.member[(0u + _e1913)].v0_;
                                                                            let _e2147 = (_e2142.x - _e2144.x);
                                                                            let _e2150 = (_e2142.y - _e2144.y);
                                                                            let _e2153 = (_e2142.z - _e2144.z);
                                                                            if (_e1299 == 0u) {
                                                                                phi_2692_ = vec3<f32>(_e2150, _e2153, _e2147);
                                                                            } else {
                                                                                if (_e1299 == 1u) {
                                                                                    phi_2691_ = vec3<f32>(_e2153, _e2147, _e2150);
                                                                                } else {
                                                                                    phi_2691_ = (_e2142 - _e2144);
                                                                                }
                                                                                let _e2160 = phi_2691_;
                                                                                phi_2692_ = _e2160;
                                                                            }
                                                                            let _e2162 = phi_2692_;
                                                                            let _e2169 = ((_e2140.y * _e2162.z) - (_e2140.z * _e2162.y));
                                                                            let _e2176 = ((_e2140.z * _e2162.x) - (_e2140.x * _e2162.z));
                                                                            let _e2183 = ((_e2140.x * _e2162.y) - (_e2140.y * _e2162.x));
                                                                            let _e2197 = (((1f / _e1307.z) * (((_e2169 * _e2118.x) + (_e2176 * _e2118.y)) + (_e2183 * _e2118.z))) / (((_e2169 * _e1310) + (_e2176 * _e1313)) + _e2183));
                                                                            if (_e2197 > 0f) {
                                                                                if (_e2197 < _e145) {
                                                                                    let _e2201 = triangles.member[(0u + _e1913)].v0_;
                                                                                    let _e2203 = triangles.member[(0u + _e1913)].v1_;
                                                                                    if (_e2201.x < _e2203.x) {
                                                                                        phi_2748_ = _e2201.x;
                                                                                    } else {
                                                                                        phi_2748_ = _e2203.x;
                                                                                    }
                                                                                    let _e2210 = phi_2748_;
                                                                                    if (_e2201.y < _e2203.y) {
                                                                                        phi_2757_ = _e2201.y;
                                                                                    } else {
                                                                                        phi_2757_ = _e2203.y;
                                                                                    }
                                                                                    let _e2217 = phi_2757_;
                                                                                    if (_e2201.z < _e2203.z) {
                                                                                        phi_2766_ = _e2201.z;
                                                                                    } else {
                                                                                        phi_2766_ = _e2203.z;
                                                                                    }
                                                                                    let _e2224 = phi_2766_;
                                                                                    let _e2226 = triangles.member[(0u + _e1913)].v2_;
                                                                                    if (_e2210 < _e2226.x) {
                                                                                        phi_2775_ = _e2210;
                                                                                    } else {
                                                                                        phi_2775_ = _e2226.x;
                                                                                    }
                                                                                    let _e2231 = phi_2775_;
                                                                                    if (_e2217 < _e2226.y) {
                                                                                        phi_2782_ = _e2217;
                                                                                    } else {
                                                                                        phi_2782_ = _e2226.y;
                                                                                    }
                                                                                    let _e2236 = phi_2782_;
                                                                                    if (_e2224 < _e2226.z) {
                                                                                        phi_2789_ = _e2224;
                                                                                    } else {
                                                                                        phi_2789_ = _e2226.z;
                                                                                    }
                                                                                    let _e2241 = phi_2789_;
                                                                                    let _e2243 = triangles.member[(0u + _e1913)].v0_;
                                                                                    let _e2245 = triangles.member[(0u + _e1913)].v1_;
                                                                                    if (_e2243.x > _e2245.x) {
                                                                                        phi_2802_ = _e2243.x;
                                                                                    } else {
                                                                                        phi_2802_ = _e2245.x;
                                                                                    }
                                                                                    let _e2252 = phi_2802_;
                                                                                    if (_e2243.y > _e2245.y) {
                                                                                        phi_2811_ = _e2243.y;
                                                                                    } else {
                                                                                        phi_2811_ = _e2245.y;
                                                                                    }
                                                                                    let _e2259 = phi_2811_;
                                                                                    if (_e2243.z > _e2245.z) {
                                                                                        phi_2820_ = _e2243.z;
                                                                                    } else {
                                                                                        phi_2820_ = _e2245.z;
                                                                                    }
                                                                                    let _e2266 = phi_2820_;
                                                                                    let _e2268 = triangles.member[(0u + _e1913)].v2_;
                                                                                    if (_e2252 > _e2268.x) {
                                                                                        phi_2829_ = _e2252;
                                                                                    } else {
                                                                                        phi_2829_ = _e2268.x;
                                                                                    }
                                                                                    let _e2273 = phi_2829_;
                                                                                    if (_e2259 > _e2268.y) {
                                                                                        phi_2836_ = _e2259;
                                                                                    } else {
                                                                                        phi_2836_ = _e2268.y;
                                                                                    }
                                                                                    let _e2278 = phi_2836_;
                                                                                    if (_e2266 > _e2268.z) {
                                                                                        phi_2843_ = _e2266;
                                                                                    } else {
                                                                                        phi_2843_ = _e2268.z;
                                                                                    }
                                                                                    let _e2283 = phi_2843_;
                                                                                    let _e2287 = ((_e2231 - _e1019) * _e1228);
                                                                                    let _e2288 = ((_e2236 - _e1032) * _e1238);
                                                                                    let _e2289 = ((_e2241 - _e1045) * _e1248);
                                                                                    let _e2293 = ((_e2273 - _e1019) * _e1228);
                                                                                    let _e2294 = ((_e2278 - _e1032) * _e1238);
                                                                                    let _e2295 = ((_e2283 - _e1045) * _e1248);
                                                                                    if (_e2287 < _e2293) {
                                                                                        phi_2860_ = _e2287;
                                                                                    } else {
                                                                                        phi_2860_ = _e2293;
                                                                                    }
                                                                                    let _e2298 = phi_2860_;
                                                                                    if (_e2288 < _e2294) {
                                                                                        phi_2865_ = _e2288;
                                                                                    } else {
                                                                                        phi_2865_ = _e2294;
                                                                                    }
                                                                                    let _e2301 = phi_2865_;
                                                                                    if (_e2289 < _e2295) {
                                                                                        phi_2870_ = _e2289;
                                                                                    } else {
                                                                                        phi_2870_ = _e2295;
                                                                                    }
                                                                                    let _e2304 = phi_2870_;
                                                                                    if (_e2287 > _e2293) {
                                                                                        phi_2878_ = _e2287;
                                                                                    } else {
                                                                                        phi_2878_ = _e2293;
                                                                                    }
                                                                                    let _e2310 = phi_2878_;
                                                                                    if (_e2288 > _e2294) {
                                                                                        phi_2883_ = _e2288;
                                                                                    } else {
                                                                                        phi_2883_ = _e2294;
                                                                                    }
                                                                                    let _e2313 = phi_2883_;
                                                                                    if (_e2289 > _e2295) {
                                                                                        phi_2888_ = _e2289;
                                                                                    } else {
                                                                                        phi_2888_ = _e2295;
                                                                                    }
                                                                                    let _e2316 = phi_2888_;
                                                                                    let _e2320 = core_intrinsics_maximum_number_nsz_f32_((_e2298 - _e1283), (_e2301 - _e1284));
                                                                                    let _e2321 = core_intrinsics_maximum_number_nsz_f32_(_e2320, (_e2304 - _e1285));
                                                                                    let _e2322 = core_intrinsics_minimum_number_nsz_f32_((_e2310 + _e1283), (_e2313 + _e1284));
                                                                                    let _e2323 = core_intrinsics_minimum_number_nsz_f32_(_e2322, (_e2316 + _e1285));
                                                                                    if (_e2321 > _e1000) {
                                                                                        phi_2900_ = _e2321;
                                                                                    } else {
                                                                                        phi_2900_ = _e1000;
                                                                                    }
                                                                                    let _e2326 = phi_2900_;
                                                                                    if (_e2323 < _e1002) {
                                                                                        phi_2905_ = _e2323;
                                                                                    } else {
                                                                                        phi_2905_ = _e1002;
                                                                                    }
                                                                                    let _e2329 = phi_2905_;
                                                                                    if (_e2197 < _e2326) {
                                                                                        phi_2910_ = _e2326;
                                                                                    } else {
                                                                                        phi_2910_ = _e2197;
                                                                                    }
                                                                                    let _e2332 = phi_2910_;
                                                                                    if (_e2332 > _e2329) {
                                                                                        phi_2915_ = _e2329;
                                                                                    } else {
                                                                                        phi_2915_ = _e2332;
                                                                                    }
                                                                                    let _e2335 = phi_2915_;
                                                                                    phi_2920_ = lt_bvh_triangle_Intersection(_e2335, (_e2038 / _e2097), (_e2059 / _e2097), (_e2326 <= _e2329));
                                                                                    phi_2921_ = false;
                                                                                } else {
                                                                                    phi_2920_ = lt_bvh_triangle_Intersection();
                                                                                    phi_2921_ = true;
                                                                                }
                                                                                let _e2341 = phi_2920_;
                                                                                let _e2343 = phi_2921_;
                                                                                phi_2922_ = _e2341;
                                                                                phi_2923_ = _e2343;
                                                                            } else {
                                                                                phi_2922_ = lt_bvh_triangle_Intersection();
                                                                                phi_2923_ = true;
                                                                            }
                                                                            let _e2345 = phi_2922_;
                                                                            let _e2347 = phi_2923_;
                                                                            if _e2347 {
                                                                            }
                                                                            phi_2927_ = _e2345;
                                                                            phi_2928_ = _e2347;
                                                                        }
                                                                        let _e2349 = phi_2927_;
                                                                        let _e2351 = phi_2928_;
                                                                        phi_2929_ = _e2349;
                                                                        phi_2930_ = _e2100;
                                                                        phi_2931_ = _e2351;
                                                                    } else {
                                                                        phi_2929_ = lt_bvh_triangle_Intersection();
                                                                        phi_2930_ = true;
                                                                        phi_2931_ = false;
                                                                    }
                                                                    let _e2353 = phi_2929_;
                                                                    let _e2355 = phi_2930_;
                                                                    let _e2357 = phi_2931_;
                                                                    if _e2355 {
                                                                        phi_2935_ = true;
                                                                    } else {
                                                                        phi_2935_ = _e2357;
                                                                    }
                                                                    let _e2359 = phi_2935_;
                                                                    if _e2359 {
                                                                        phi_2939_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_2939_ = _e2353;
                                                                    }
                                                                    let _e2361 = phi_2939_;
                                                                    if _e2361.is_hit {
                                                                        if (_e2361.t > 0f) {
                                                                            if (_e2361.t < _e145) {
                                                                                let _e2368 = triangles.member[(0u + _e1913)].i0_;
                                                                                if ((_e2368 & 2147483648u) == 0u) {
                                                                                    phi_3158_ = true;
                                                                                } else {
                                                                                    if (_e1913 < _e80) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2377 = triangles.member[(0u + _e1913)].i0_;
                                                                                    let _e2378 = (_e2377 & 2147483647u);
                                                                                    let _e2380 = triangles.member[(0u + _e1913)].i1_;
                                                                                    let _e2382 = triangles.member[(0u + _e1913)].i2_;
                                                                                    if (_e2378 < _e95) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2386 = vertices.member[(0u + _e2378)];
                                                                                    if (_e2380 < _e95) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2390 = vertices.member[(0u + _e2380)];
                                                                                    if (_e2382 < _e95) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2394 = vertices.member[(0u + _e2382)];
                                                                                    let _e2395 = array<abi_Vertex, 3>(_e2386, _e2390, _e2394);
                                                                                    if (_e2395[0].material < arrayLength((&materials.member))) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2401 = materials.member[(0u + _e2395[0].material)];
                                                                                    if ((_e2401.flags & 1u) == 1u) {
                                                                                        let _e2406 = ((1f - _e2361.u) - _e2361.v);
                                                                                        if (_e2401.cutoff <= 0f) {
                                                                                            phi_3156_ = true;
                                                                                        } else {
                                                                                            let _e2433 = (_e2401.base_color.w * ((((f32((_e2395[0].color >> bitcast<u32>(24i))) * _e2406) + (f32((_e2395[1].color >> bitcast<u32>(24i))) * _e2361.u)) + (f32((_e2395[2].color >> bitcast<u32>(24i))) * _e2361.v)) * (1f / 255f)));
                                                                                            if (_e2401.alpha_size == 0u) {
                                                                                                phi_3153_ = _e2433;
                                                                                            } else {
                                                                                                local.offset = _e2401.alpha_offset;
                                                                                                local.size = _e2401.alpha_size;
                                                                                                local.flags = _e2401.flags;
                                                                                                let _e2464 = _lt_shaders_texture_TextureView_quad((&local), (((_e2395[0].u * _e2406) + (_e2395[1].u * _e2361.u)) + (_e2395[2].u * _e2361.v)), (((_e2395[0].v * _e2406) + (_e2395[1].v * _e2361.u)) + (_e2395[2].v * _e2361.v)));
                                                                                                let _e2468 = (_e2464.indices[0] >> bitcast<u32>(2i));
                                                                                                if (_e2468 < _e101) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2472 = alpha_texels.member[(0u + _e2468)];
                                                                                                let _e2488 = (_e2464.indices[1] >> bitcast<u32>(2i));
                                                                                                if (_e2488 < _e101) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2492 = alpha_texels.member[(0u + _e2488)];
                                                                                                let _e2509 = (_e2464.indices[2] >> bitcast<u32>(2i));
                                                                                                if (_e2509 < _e101) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2513 = alpha_texels.member[(0u + _e2509)];
                                                                                                let _e2530 = (_e2464.indices[3] >> bitcast<u32>(2i));
                                                                                                if (_e2530 < _e101) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2534 = alpha_texels.member[(0u + _e2530)];
                                                                                                phi_3153_ = (_e2433 * (((((f32(((_e2472 >> bitcast<u32>((((_e2464.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2464.weights.x) + ((f32(((_e2492 >> bitcast<u32>((((_e2464.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2464.weights.y)) + ((f32(((_e2513 >> bitcast<u32>((((_e2464.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2464.weights.z)) + ((f32(((_e2534 >> bitcast<u32>((((_e2464.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2464.weights.w)));
                                                                                            }
                                                                                            let _e2550 = phi_3153_;
                                                                                            phi_3156_ = (_e2550 >= _e2401.cutoff);
                                                                                        }
                                                                                        let _e2554 = phi_3156_;
                                                                                        phi_3157_ = _e2554;
                                                                                    } else {
                                                                                        phi_3157_ = false;
                                                                                    }
                                                                                    let _e2556 = phi_3157_;
                                                                                    phi_3158_ = _e2556;
                                                                                }
                                                                                let _e2558 = phi_3158_;
                                                                                if _e2558 {
                                                                                    phi_3162_ = false;
                                                                                } else {
                                                                                    phi_3162_ = true;
                                                                                }
                                                                                let _e2560 = phi_3162_;
                                                                                phi_3163_ = _e2558;
                                                                                phi_3164_ = _e2558;
                                                                                phi_3165_ = _e2560;
                                                                            } else {
                                                                                phi_3163_ = bool();
                                                                                phi_3164_ = _e1904;
                                                                                phi_3165_ = true;
                                                                            }
                                                                            let _e2562 = phi_3163_;
                                                                            let _e2564 = phi_3164_;
                                                                            let _e2566 = phi_3165_;
                                                                            phi_3166_ = _e2562;
                                                                            phi_3167_ = _e2564;
                                                                            phi_3168_ = _e2566;
                                                                        } else {
                                                                            phi_3166_ = bool();
                                                                            phi_3167_ = _e1904;
                                                                            phi_3168_ = true;
                                                                        }
                                                                        let _e2568 = phi_3166_;
                                                                        let _e2570 = phi_3167_;
                                                                        let _e2572 = phi_3168_;
                                                                        phi_3169_ = _e2568;
                                                                        phi_3170_ = _e2570;
                                                                        phi_3171_ = _e2572;
                                                                    } else {
                                                                        phi_3169_ = bool();
                                                                        phi_3170_ = _e1904;
                                                                        phi_3171_ = true;
                                                                    }
                                                                    let _e2574 = phi_3169_;
                                                                    let _e2576 = phi_3170_;
                                                                    let _e2578 = phi_3171_;
                                                                    if _e2578 {
                                                                    }
                                                                    phi_2369_ = (_e1902 & (_e1902 - 1u));
                                                                    phi_2372_ = _e2576;
                                                                    phi_3175_ = _e2574;
                                                                    phi_3176_ = _e2578;
                                                                }
                                                                let _e2580 = phi_2369_;
                                                                let _e2582 = phi_2372_;
                                                                let _e2584 = phi_3175_;
                                                                let _e2586 = phi_3176_;
                                                                local_14 = _e2584;
                                                                continue;
                                                                continuing {
                                                                    phi_2368_ = _e2580;
                                                                    phi_2371_ = _e2582;
                                                                    break if !(_e2586);
                                                                }
                                                            }
                                                            let _e2589 = local_9;
                                                            if _e2589 {
                                                                let _e2591 = local_1.group_mask;
                                                                if ((_e2591 & 4278190080u) == 0u) {
                                                                    let _e2595 = local_1.len;
                                                                    if (_e2595 == 0u) {
                                                                        phi_3218_ = false;
                                                                    } else {
                                                                        let _e2599 = local_1.len;
                                                                        local_1.len = (_e2599 - 1u);
                                                                        let _e2602 = local_1.len;
                                                                        if (_e2602 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e2607 = local_1.first[(0u + _e2602)];
                                                                        local_1.group = _e2607;
                                                                        let _e2610 = local_1.len;
                                                                        if (_e2610 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e2615 = local_1.mask[(0u + _e2610)];
                                                                        local_1.group_mask = _e2615;
                                                                        phi_3218_ = true;
                                                                    }
                                                                    let _e2618 = phi_3218_;
                                                                    phi_3219_ = _e2618;
                                                                } else {
                                                                    phi_3219_ = true;
                                                                }
                                                                let _e2620 = phi_3219_;
                                                                if _e2620 {
                                                                    let _e2622 = local_1.group_mask;
                                                                    let _e2628 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2622)), 32u, (_e2622 == 0u)));
                                                                    let _e2632 = local_1.group_mask;
                                                                    let _e2646 = local_1.group_mask;
                                                                    local_1.group_mask = (_e2646 & ~((1u << bitcast<u32>((_e2628 & 31u)))));
                                                                    let _e2649 = local_1.group;
                                                                    phi_3250_ = (_e2649 + countOneBits(((_e2632 & ~((4294967295u << bitcast<u32>((((_e2628 - 24u) ^ _e1326) & 31u))))) & 255u)));
                                                                } else {
                                                                    phi_3250_ = 4294967295u;
                                                                }
                                                                let _e2652 = phi_3250_;
                                                                phi_3251_ = _e2652;
                                                            } else {
                                                                phi_3251_ = u32();
                                                            }
                                                            let _e2654 = phi_3251_;
                                                            phi_2037_ = _e2654;
                                                            let _e3070 = local_13;
                                                            phi_2040_ = _e3070;
                                                            let _e3073 = local_14;
                                                            phi_3252_ = _e3073;
                                                            let _e3076 = local_15;
                                                            phi_3253_ = _e3076;
                                                            phi_3254_ = false;
                                                        } else {
                                                            phi_2037_ = u32();
                                                            phi_2040_ = bool();
                                                            phi_3252_ = bool();
                                                            phi_3253_ = false;
                                                            phi_3254_ = true;
                                                        }
                                                        let _e2656 = phi_2037_;
                                                        let _e2658 = phi_2040_;
                                                        let _e2660 = phi_3252_;
                                                        let _e2662 = phi_3253_;
                                                        let _e2664 = phi_3254_;
                                                        local_10 = _e2664;
                                                        local_16 = _e2660;
                                                        continue;
                                                        continuing {
                                                            phi_2036_ = _e2656;
                                                            phi_2039_ = _e2658;
                                                            break if !(_e2662);
                                                        }
                                                    }
                                                    let _e2667 = local_10;
                                                    if _e2667 {
                                                        phi_3258_ = false;
                                                    } else {
                                                        phi_3258_ = true;
                                                    }
                                                    let _e2669 = phi_3258_;
                                                    if _e2669 {
                                                        let _e3082 = local_16;
                                                        phi_3262_ = _e3082;
                                                    } else {
                                                        let _e3084 = local_17;
                                                        phi_3262_ = _e3084;
                                                    }
                                                    let _e2671 = phi_3262_;
                                                    phi_3263_ = _e2671;
                                                }
                                                let _e2673 = phi_3263_;
                                                phi_3264_ = _e2673;
                                                phi_3265_ = _e1152;
                                            } else {
                                                phi_3264_ = bool();
                                                phi_3265_ = true;
                                            }
                                            let _e2675 = phi_3264_;
                                            let _e2677 = phi_3265_;
                                            if _e2677 {
                                                phi_3269_ = _e939;
                                            } else {
                                                phi_3269_ = _e2675;
                                            }
                                            let _e2679 = phi_3269_;
                                            if _e2679 {
                                                phi_3273_ = false;
                                            } else {
                                                phi_3273_ = true;
                                            }
                                            let _e2681 = phi_3273_;
                                            phi_3274_ = _e2679;
                                            phi_3275_ = _e2681;
                                        } else {
                                            phi_3274_ = _e939;
                                            phi_3275_ = true;
                                        }
                                        let _e2683 = phi_3274_;
                                        let _e2685 = phi_3275_;
                                        phi_3276_ = _e2683;
                                        phi_3277_ = _e2685;
                                    } else {
                                        phi_3276_ = _e939;
                                        phi_3277_ = true;
                                    }
                                    let _e2687 = phi_3276_;
                                    let _e2689 = phi_3277_;
                                    phi_3278_ = _e2687;
                                    phi_3279_ = _e2689;
                                } else {
                                    phi_3278_ = _e939;
                                    phi_3279_ = true;
                                }
                                let _e2691 = phi_3278_;
                                let _e2693 = phi_3279_;
                                if _e2693 {
                                }
                                phi_1429_ = (_e937 & (_e937 - 1u));
                                phi_1432_ = _e2691;
                                phi_3283_ = _e2693;
                            }
                            let _e2695 = phi_1429_;
                            let _e2697 = phi_1432_;
                            let _e2699 = phi_3283_;
                            continue;
                            continuing {
                                phi_1428_ = _e2695;
                                phi_1431_ = _e2697;
                                break if !(_e2699);
                            }
                        }
                        let _e2702 = local_11;
                        if _e2702 {
                            let _e2704 = local_2.group_mask;
                            if ((_e2704 & 4278190080u) == 0u) {
                                let _e2708 = local_2.len;
                                if (_e2708 == 0u) {
                                    phi_3325_ = false;
                                } else {
                                    let _e2712 = local_2.len;
                                    local_2.len = (_e2712 - 1u);
                                    let _e2715 = local_2.len;
                                    if (_e2715 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e2720 = local_2.first[(0u + _e2715)];
                                    local_2.group = _e2720;
                                    let _e2723 = local_2.len;
                                    if (_e2723 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e2728 = local_2.mask[(0u + _e2723)];
                                    local_2.group_mask = _e2728;
                                    phi_3325_ = true;
                                }
                                let _e2731 = phi_3325_;
                                phi_3326_ = _e2731;
                            } else {
                                phi_3326_ = true;
                            }
                            let _e2733 = phi_3326_;
                            if _e2733 {
                                let _e2735 = local_2.group_mask;
                                let _e2741 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2735)), 32u, (_e2735 == 0u)));
                                let _e2745 = local_2.group_mask;
                                let _e2759 = local_2.group_mask;
                                local_2.group_mask = (_e2759 & ~((1u << bitcast<u32>((_e2741 & 31u)))));
                                let _e2762 = local_2.group;
                                phi_3357_ = (_e2762 + countOneBits(((_e2745 & ~((4294967295u << bitcast<u32>((((_e2741 - 24u) ^ _e361) & 31u))))) & 255u)));
                            } else {
                                phi_3357_ = 4294967295u;
                            }
                            let _e2765 = phi_3357_;
                            phi_3358_ = _e2765;
                        } else {
                            phi_3358_ = u32();
                        }
                        let _e2767 = phi_3358_;
                        phi_1097_ = _e2767;
                        let _e3107 = local_18;
                        phi_1100_ = _e3107;
                        let _e3110 = local_19;
                        phi_3359_ = _e3110;
                        phi_3360_ = false;
                    } else {
                        phi_1097_ = u32();
                        phi_1100_ = bool();
                        phi_3359_ = false;
                        phi_3360_ = true;
                    }
                    let _e2769 = phi_1097_;
                    let _e2771 = phi_1100_;
                    let _e2773 = phi_3359_;
                    let _e2775 = phi_3360_;
                    local_12 = _e2775;
                    continue;
                    continuing {
                        phi_1096_ = _e2769;
                        phi_1099_ = _e2771;
                        break if !(_e2773);
                    }
                }
                let _e2778 = local_12;
                if _e2778 {
                    phi_3364_ = false;
                } else {
                    phi_3364_ = true;
                }
                let _e2780 = phi_3364_;
                if _e2780 {
                }
                phi_3368_ = _e2780;
            }
            let _e2782 = phi_3368_;
            phi_3369_ = _e217;
            phi_3370_ = _e2782;
        } else {
            phi_3369_ = true;
            phi_3370_ = false;
        }
        let _e2784 = phi_3369_;
        let _e2786 = phi_3370_;
        if _e2784 {
            phi_3374_ = false;
            phi_3375_ = true;
        } else {
            phi_3374_ = true;
            phi_3375_ = _e2786;
        }
        let _e2788 = phi_3374_;
        let _e2790 = phi_3375_;
        if _e2790 {
            phi_3379_ = _e2788;
        } else {
            phi_3379_ = false;
        }
        let _e2792 = phi_3379_;
        if _e2792 {
            phi_3383_ = 0f;
        } else {
            phi_3383_ = 1f;
        }
        let _e2794 = phi_3383_;
        if (_e114 < _e83) {
        } else {
            return;
        }
        visibility.member[(0u + _e114)] = _e2794;
        if (_e114 < _e89) {
        } else {
            return;
        }
        let _e2801 = bits.member[(0u + _e114)];
        if ((_e2801 & 2u) == 0u) {
            phi_3404_ = (_e2801 & 1u);
        } else {
            phi_3404_ = (_e2801 & 7u);
        }
        let _e2807 = phi_3404_;
        if (_e114 < _e83) {
        } else {
            return;
        }
        let _e2811 = visibility.member[(0u + _e114)];
        if ((_e2807 & 1u) != 0u) {
            phi_3419_ = (2u | 1u);
        } else {
            phi_3419_ = 2u;
        }
        let _e2817 = phi_3419_;
        if (_e2811 < 0.5f) {
            phi_3424_ = (_e2817 | 4u);
        } else {
            phi_3424_ = _e2817;
        }
        let _e2820 = phi_3424_;
        if (_e114 < _e89) {
        } else {
            return;
        }
        bits.member[(0u + _e114)] = _e2820;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_learn_instanced_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
