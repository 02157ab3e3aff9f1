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

struct lt_math_LightProjection {
    row_x: vec4<f32>,
    row_y: vec4<f32>,
    row_z: vec4<f32>,
    row_w: vec4<f32>,
}

struct lt_bvh_Triangle {
    v0_: vec3<f32>,
    i0_: u32,
    v1_: vec3<f32>,
    i1_: u32,
    v2_: vec3<f32>,
    i2_: u32,
}

struct type_31 {
    member: array<lt_bvh_Triangle>,
}

struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
}

struct type_35 {
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
    pad: vec2<u32>,
}

struct type_39 {
    member: array<abi_Material>,
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

struct type_50 {
    member: array<lt_bvh_Instance>,
}

struct lt_bvh_traverse_Stack {
    first: array<u32, 32>,
    mask: array<u32, 32>,
    len: u32,
    group: u32,
    group_mask: u32,
}

struct lt_bvh_Node {
    frame: vec4<u32>,
    links: vec4<u32>,
    x: vec4<u32>,
    y: vec4<u32>,
    z: vec4<u32>,
}

struct type_59 {
    member: array<lt_bvh_Node>,
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

struct abi_ShadowParams {
    projection: lt_math_LightProjection,
    light: vec4<f32>,
    test: vec4<f32>,
    size: vec2<u32>,
    map_size: u32,
    epsilon: f32,
    root: u32,
    pad0_: u32,
    pad1_: u32,
    pad2_: u32,
}

struct type_65 {
    member: abi_ShadowParams,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_17;
@group(0) @binding(0) 
var<uniform> p: type_65;
@group(0) @binding(2) 
var<storage> nodes: type_59;
@group(0) @binding(3) 
var<storage> triangles: type_31;
@group(0) @binding(5) 
var<storage> list: type_13;
@group(0) @binding(6) 
var<storage, read_write> bits: type_13;
@group(0) @binding(7) 
var<storage> instances: type_50;
@group(0) @binding(8) 
var<storage> vertices: type_35;
@group(0) @binding(9) 
var<storage> materials: type_39;
@group(0) @binding(10) 
var<storage> alpha_texels: type_13;

fn _lt_shaders_texture_TextureView_quad(param: ptr<function, texture_TextureView>, param_1: f32, param_2: f32) -> texture_TexelQuad {
    var phi_238_: f32;
    var phi_243_: f32;
    var phi_244_: bool;
    var phi_245_: f32;
    var phi_246_: bool;
    var phi_250_: f32;
    var phi_276_: f32;
    var phi_281_: f32;
    var phi_282_: bool;
    var phi_283_: f32;
    var phi_284_: bool;
    var phi_288_: f32;
    var phi_296_: f32;
    var phi_297_: f32;
    var phi_298_: f32;
    var phi_307_: f32;
    var phi_308_: f32;
    var phi_326_: u32;
    var phi_340_: u32;
    var phi_347_: u32;
    var phi_352_: u32;
    var phi_358_: u32;
    var phi_363_: u32;
    var phi_365_: texture_Axis;
    var phi_393_: f32;
    var phi_398_: f32;
    var phi_399_: bool;
    var phi_400_: f32;
    var phi_401_: bool;
    var phi_405_: f32;
    var phi_431_: f32;
    var phi_436_: f32;
    var phi_437_: bool;
    var phi_438_: f32;
    var phi_439_: bool;
    var phi_443_: f32;
    var phi_451_: f32;
    var phi_452_: f32;
    var phi_453_: f32;
    var phi_462_: f32;
    var phi_463_: f32;
    var phi_481_: u32;
    var phi_495_: u32;
    var phi_502_: u32;
    var phi_507_: u32;
    var phi_513_: u32;
    var phi_518_: u32;
    var phi_520_: texture_Axis;

    let _e71 = (*param).size;
    let _e72 = (_e71 & 65535u);
    let _e74 = (*param).size;
    let _e76 = (_e74 >> bitcast<u32>(16i));
    let _e78 = (*param).flags;
    let _e80 = ((_e78 & 4u) != 0u);
    let _e82 = (*param).flags;
    let _e85 = ((_e82 >> bitcast<u32>(4u)) & 3u);
    if (_e85 == 0u) {
        if (param_1 > -8388608f) {
            let _e98 = f32(select(0i, select(select(i32(param_1), i32(-2147483648), (param_1 < bitcast<f32>(3472883712u))), 2147483647i, (param_1 > bitcast<f32>(1325400063u))), (param_1 == param_1)));
            if (_e98 > param_1) {
                phi_238_ = 1f;
            } else {
                phi_238_ = 0f;
            }
            let _e101 = phi_238_;
            if (param_1 < 8388608f) {
                phi_243_ = (_e98 - _e101);
                phi_244_ = false;
            } else {
                phi_243_ = f32();
                phi_244_ = true;
            }
            let _e104 = phi_243_;
            let _e106 = phi_244_;
            phi_245_ = _e104;
            phi_246_ = _e106;
        } else {
            phi_245_ = f32();
            phi_246_ = true;
        }
        let _e108 = phi_245_;
        let _e110 = phi_246_;
        if _e110 {
            phi_250_ = param_1;
        } else {
            phi_250_ = _e108;
        }
        let _e112 = phi_250_;
        phi_298_ = (param_1 - _e112);
    } else {
        if (_e85 == 1u) {
            let _e115 = (param_1 * 0.5f);
            if (_e115 > -8388608f) {
                let _e127 = f32(select(0i, select(select(i32(_e115), i32(-2147483648), (_e115 < bitcast<f32>(3472883712u))), 2147483647i, (_e115 > bitcast<f32>(1325400063u))), (_e115 == _e115)));
                if (_e127 > _e115) {
                    phi_276_ = 1f;
                } else {
                    phi_276_ = 0f;
                }
                let _e130 = phi_276_;
                if (_e115 < 8388608f) {
                    phi_281_ = (_e127 - _e130);
                    phi_282_ = false;
                } else {
                    phi_281_ = f32();
                    phi_282_ = true;
                }
                let _e133 = phi_281_;
                let _e135 = phi_282_;
                phi_283_ = _e133;
                phi_284_ = _e135;
            } else {
                phi_283_ = f32();
                phi_284_ = true;
            }
            let _e137 = phi_283_;
            let _e139 = phi_284_;
            if _e139 {
                phi_288_ = _e115;
            } else {
                phi_288_ = _e137;
            }
            let _e141 = phi_288_;
            let _e143 = (param_1 - (2f * _e141));
            if (_e143 > 1f) {
                phi_296_ = (2f - _e143);
            } else {
                phi_296_ = _e143;
            }
            let _e147 = phi_296_;
            phi_297_ = _e147;
        } else {
            phi_297_ = param_1;
        }
        let _e149 = phi_297_;
        phi_298_ = _e149;
    }
    let _e151 = phi_298_;
    if (_e151 > 0f) {
        if (_e151 < 1f) {
            phi_307_ = _e151;
        } else {
            phi_307_ = 1f;
        }
        let _e155 = phi_307_;
        phi_308_ = _e155;
    } else {
        phi_308_ = 0f;
    }
    let _e157 = phi_308_;
    let _e158 = (_e72 - 1u);
    let _e160 = (_e157 * f32(_e72));
    if _e80 {
        let _e167 = select(select(u32(_e160), 0u, (_e160 < bitcast<f32>(0u))), 4294967295u, (_e160 > bitcast<f32>(1333788671u)));
        if (_e158 < _e167) {
            phi_326_ = _e158;
        } else {
            phi_326_ = _e167;
        }
        let _e170 = phi_326_;
        phi_365_ = texture_Axis(_e170, _e170, 0f);
    } else {
        let _e172 = (_e160 + 0.5f);
        let _e179 = select(select(u32(_e172), 0u, (_e172 < bitcast<f32>(0u))), 4294967295u, (_e172 > bitcast<f32>(1333788671u)));
        if (_e72 < _e179) {
            phi_340_ = _e72;
        } else {
            phi_340_ = _e179;
        }
        let _e182 = phi_340_;
        if (_e85 == 0u) {
            phi_347_ = _e158;
        } else {
            phi_347_ = 0u;
        }
        let _e187 = phi_347_;
        if (_e85 == 0u) {
            phi_352_ = 0u;
        } else {
            phi_352_ = _e158;
        }
        let _e190 = phi_352_;
        if (_e182 == 0u) {
            phi_358_ = _e187;
        } else {
            phi_358_ = (_e182 - 1u);
        }
        let _e194 = phi_358_;
        if (_e182 > _e158) {
            phi_363_ = _e190;
        } else {
            phi_363_ = _e182;
        }
        let _e197 = phi_363_;
        phi_365_ = texture_Axis(_e194, _e197, (_e172 - f32(_e182)));
    }
    let _e200 = phi_365_;
    let _e202 = (*param).flags;
    let _e205 = ((_e202 >> bitcast<u32>(6u)) & 3u);
    if (_e205 == 0u) {
        if (param_2 > -8388608f) {
            let _e218 = f32(select(0i, select(select(i32(param_2), i32(-2147483648), (param_2 < bitcast<f32>(3472883712u))), 2147483647i, (param_2 > bitcast<f32>(1325400063u))), (param_2 == param_2)));
            if (_e218 > param_2) {
                phi_393_ = 1f;
            } else {
                phi_393_ = 0f;
            }
            let _e221 = phi_393_;
            if (param_2 < 8388608f) {
                phi_398_ = (_e218 - _e221);
                phi_399_ = false;
            } else {
                phi_398_ = f32();
                phi_399_ = true;
            }
            let _e224 = phi_398_;
            let _e226 = phi_399_;
            phi_400_ = _e224;
            phi_401_ = _e226;
        } else {
            phi_400_ = f32();
            phi_401_ = true;
        }
        let _e228 = phi_400_;
        let _e230 = phi_401_;
        if _e230 {
            phi_405_ = param_2;
        } else {
            phi_405_ = _e228;
        }
        let _e232 = phi_405_;
        phi_453_ = (param_2 - _e232);
    } else {
        if (_e205 == 1u) {
            let _e235 = (param_2 * 0.5f);
            if (_e235 > -8388608f) {
                let _e247 = f32(select(0i, select(select(i32(_e235), i32(-2147483648), (_e235 < bitcast<f32>(3472883712u))), 2147483647i, (_e235 > bitcast<f32>(1325400063u))), (_e235 == _e235)));
                if (_e247 > _e235) {
                    phi_431_ = 1f;
                } else {
                    phi_431_ = 0f;
                }
                let _e250 = phi_431_;
                if (_e235 < 8388608f) {
                    phi_436_ = (_e247 - _e250);
                    phi_437_ = false;
                } else {
                    phi_436_ = f32();
                    phi_437_ = true;
                }
                let _e253 = phi_436_;
                let _e255 = phi_437_;
                phi_438_ = _e253;
                phi_439_ = _e255;
            } else {
                phi_438_ = f32();
                phi_439_ = true;
            }
            let _e257 = phi_438_;
            let _e259 = phi_439_;
            if _e259 {
                phi_443_ = _e235;
            } else {
                phi_443_ = _e257;
            }
            let _e261 = phi_443_;
            let _e263 = (param_2 - (2f * _e261));
            if (_e263 > 1f) {
                phi_451_ = (2f - _e263);
            } else {
                phi_451_ = _e263;
            }
            let _e267 = phi_451_;
            phi_452_ = _e267;
        } else {
            phi_452_ = param_2;
        }
        let _e269 = phi_452_;
        phi_453_ = _e269;
    }
    let _e271 = phi_453_;
    if (_e271 > 0f) {
        if (_e271 < 1f) {
            phi_462_ = _e271;
        } else {
            phi_462_ = 1f;
        }
        let _e275 = phi_462_;
        phi_463_ = _e275;
    } else {
        phi_463_ = 0f;
    }
    let _e277 = phi_463_;
    let _e278 = (_e76 - 1u);
    let _e280 = (_e277 * f32(_e76));
    if _e80 {
        let _e287 = select(select(u32(_e280), 0u, (_e280 < bitcast<f32>(0u))), 4294967295u, (_e280 > bitcast<f32>(1333788671u)));
        if (_e278 < _e287) {
            phi_481_ = _e278;
        } else {
            phi_481_ = _e287;
        }
        let _e290 = phi_481_;
        phi_520_ = texture_Axis(_e290, _e290, 0f);
    } else {
        let _e292 = (_e280 + 0.5f);
        let _e299 = select(select(u32(_e292), 0u, (_e292 < bitcast<f32>(0u))), 4294967295u, (_e292 > bitcast<f32>(1333788671u)));
        if (_e76 < _e299) {
            phi_495_ = _e76;
        } else {
            phi_495_ = _e299;
        }
        let _e302 = phi_495_;
        if (_e205 == 0u) {
            phi_502_ = _e278;
        } else {
            phi_502_ = 0u;
        }
        let _e307 = phi_502_;
        if (_e205 == 0u) {
            phi_507_ = 0u;
        } else {
            phi_507_ = _e278;
        }
        let _e310 = phi_507_;
        if (_e302 == 0u) {
            phi_513_ = _e307;
        } else {
            phi_513_ = (_e302 - 1u);
        }
        let _e314 = phi_513_;
        if (_e302 > _e278) {
            phi_518_ = _e310;
        } else {
            phi_518_ = _e302;
        }
        let _e317 = phi_518_;
        phi_520_ = texture_Axis(_e314, _e317, (_e292 - f32(_e302)));
    }
    let _e320 = phi_520_;
    let _e324 = (*param).offset;
    let _e331 = (*param).offset;
    let _e338 = (*param).offset;
    let _e345 = (*param).offset;
    return texture_TexelQuad(array<u32, 4>(((_e324 + (_e320.low * _e72)) + _e200.low), ((_e331 + (_e320.low * _e72)) + _e200.high), ((_e338 + (_e320.high * _e72)) + _e200.low), ((_e345 + (_e320.high * _e72)) + _e200.high)), vec4<f32>(((1f - _e200.fraction) * (1f - _e320.fraction)), (_e200.fraction * (1f - _e320.fraction)), ((1f - _e200.fraction) * _e320.fraction), (_e200.fraction * _e320.fraction)));
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_579_: bool;
    var phi_583_: f32;

    if (param_3 != param_3) {
        phi_579_ = true;
    } else {
        let _e70 = (param_4 >= param_3);
        if _e70 {
        }
        phi_579_ = _e70;
    }
    let _e72 = phi_579_;
    if _e72 {
        phi_583_ = param_4;
    } else {
        phi_583_ = param_3;
    }
    let _e74 = phi_583_;
    return _e74;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_595_: bool;
    var phi_599_: f32;

    if (param_5 != param_5) {
        phi_595_ = true;
    } else {
        let _e70 = (param_6 <= param_5);
        if _e70 {
        }
        phi_595_ = _e70;
    }
    let _e72 = phi_595_;
    if _e72 {
        phi_599_ = param_6;
    } else {
        phi_599_ = param_5;
    }
    let _e74 = phi_599_;
    return _e74;
}

fn function_() {
    var local: texture_TextureView;
    var local_1: lt_bvh_traverse_Stack;
    var local_2: lt_bvh_traverse_Stack;
    var phi_699_: f32;
    var phi_755_: bool;
    var phi_756_: bool;
    var phi_757_: bool;
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
    var phi_778_: bool;
    var phi_782_: bool;
    var phi_786_: bool;
    var phi_856_: f32;
    var phi_863_: f32;
    var phi_870_: f32;
    var phi_877_: f32;
    var phi_884_: f32;
    var phi_891_: f32;
    var phi_908_: f32;
    var phi_913_: f32;
    var phi_918_: f32;
    var phi_939_: u32;
    var phi_944_: u32;
    var phi_949_: u32;
    var phi_1063_: bool;
    var phi_1064_: bool;
    var phi_1095_: u32;
    var phi_1097_: u32;
    var phi_1178_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1205_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1232_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1238_: u32;
    var phi_1241_: u32;
    var phi_1255_: u32;
    var phi_1265_: u32;
    var phi_1275_: u32;
    var phi_1293_: u32;
    var phi_1303_: u32;
    var phi_1313_: u32;
    var phi_1349_: u32;
    var phi_1362_: u32;
    var phi_1367_: u32;
    var phi_1368_: u32;
    var phi_1369_: u32;
    var phi_1239_: u32;
    var phi_1242_: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_1427_: u32;
    var phi_1477_: f32;
    var phi_1482_: f32;
    var phi_1487_: f32;
    var phi_1495_: f32;
    var phi_1500_: f32;
    var phi_1505_: f32;
    var phi_1649_: bool;
    var phi_1650_: bool;
    var phi_1651_: bool;
    var phi_1655_: bool;
    var phi_1656_: bool;
    var phi_1657_: bool;
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
    var phi_1676_: bool;
    var phi_1680_: bool;
    var phi_1750_: f32;
    var phi_1757_: f32;
    var phi_1764_: f32;
    var phi_1771_: f32;
    var phi_1778_: f32;
    var phi_1785_: f32;
    var phi_1802_: f32;
    var phi_1807_: f32;
    var phi_1812_: f32;
    var phi_1840_: bool;
    var phi_1841_: bool;
    var phi_1849_: u32;
    var phi_1850_: u32;
    var phi_1861_: vec3<f32>;
    var phi_1862_: vec3<f32>;
    var phi_1875_: u32;
    var phi_1880_: u32;
    var phi_1885_: u32;
    var phi_1999_: bool;
    var phi_2000_: bool;
    var phi_2031_: u32;
    var phi_2033_: u32;
    var phi_2114_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2141_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2168_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2174_: u32;
    var phi_2177_: u32;
    var phi_2191_: u32;
    var phi_2201_: u32;
    var phi_2211_: u32;
    var phi_2229_: u32;
    var phi_2239_: u32;
    var phi_2249_: u32;
    var phi_2285_: u32;
    var phi_2298_: u32;
    var phi_2303_: u32;
    var phi_2304_: u32;
    var phi_2305_: u32;
    var phi_2175_: u32;
    var phi_2178_: u32;
    var local_6: u32;
    var local_7: u32;
    var local_8: u32;
    var phi_2363_: u32;
    var phi_2408_: vec3<f32>;
    var phi_2409_: vec3<f32>;
    var phi_2440_: vec3<f32>;
    var phi_2441_: vec3<f32>;
    var phi_2472_: vec3<f32>;
    var phi_2473_: vec3<f32>;
    var phi_2493_: bool;
    var phi_2494_: bool;
    var phi_2498_: f32;
    var phi_2499_: f32;
    var phi_2500_: f32;
    var phi_2501_: f32;
    var phi_2509_: f32;
    var phi_2519_: bool;
    var phi_2520_: bool;
    var phi_2524_: f32;
    var phi_2525_: f32;
    var phi_2526_: f32;
    var phi_2527_: f32;
    var phi_2535_: f32;
    var phi_2545_: bool;
    var phi_2546_: bool;
    var phi_2550_: f32;
    var phi_2551_: f32;
    var phi_2552_: f32;
    var phi_2553_: f32;
    var phi_2561_: f32;
    var phi_2576_: f32;
    var phi_2577_: bool;
    var phi_2578_: f32;
    var phi_2579_: bool;
    var phi_2580_: f32;
    var phi_2581_: bool;
    var phi_2599_: f32;
    var phi_2600_: bool;
    var phi_2601_: bool;
    var phi_2602_: f32;
    var phi_2603_: bool;
    var phi_2604_: bool;
    var phi_2608_: bool;
    var phi_2609_: f32;
    var phi_2610_: bool;
    var phi_2644_: f32;
    var phi_2653_: f32;
    var phi_2662_: f32;
    var phi_2671_: f32;
    var phi_2678_: f32;
    var phi_2685_: f32;
    var phi_2698_: f32;
    var phi_2707_: f32;
    var phi_2716_: f32;
    var phi_2725_: f32;
    var phi_2732_: f32;
    var phi_2739_: f32;
    var phi_2756_: f32;
    var phi_2761_: f32;
    var phi_2766_: f32;
    var phi_2774_: f32;
    var phi_2779_: f32;
    var phi_2784_: f32;
    var phi_2796_: f32;
    var phi_2801_: f32;
    var phi_2806_: f32;
    var phi_2811_: f32;
    var phi_2816_: lt_bvh_triangle_Intersection;
    var phi_2817_: bool;
    var phi_2818_: lt_bvh_triangle_Intersection;
    var phi_2819_: bool;
    var phi_2823_: lt_bvh_triangle_Intersection;
    var phi_2824_: bool;
    var phi_2825_: lt_bvh_triangle_Intersection;
    var phi_2826_: bool;
    var phi_2827_: bool;
    var phi_2831_: bool;
    var phi_2835_: lt_bvh_triangle_Intersection;
    var phi_3049_: f32;
    var phi_3052_: bool;
    var phi_3053_: bool;
    var phi_3057_: bool;
    var phi_3058_: bool;
    var phi_3059_: bool;
    var phi_3060_: bool;
    var phi_3061_: bool;
    var phi_3062_: bool;
    var phi_3063_: bool;
    var phi_3064_: bool;
    var phi_3065_: bool;
    var phi_3066_: bool;
    var phi_3067_: bool;
    var phi_3068_: bool;
    var phi_3072_: bool;
    var phi_3073_: bool;
    var phi_2364_: u32;
    var phi_3074_: bool;
    var phi_3075_: bool;
    var phi_3076_: bool;
    var local_9: bool;
    var phi_3118_: bool;
    var phi_3119_: bool;
    var phi_3150_: u32;
    var phi_3151_: u32;
    var phi_3152_: bool;
    var phi_3153_: bool;
    var phi_2034_: u32;
    var phi_3154_: bool;
    var phi_3155_: bool;
    var phi_3156_: bool;
    var phi_3157_: bool;
    var local_10: bool;
    var phi_3161_: bool;
    var phi_3162_: bool;
    var phi_3166_: bool;
    var phi_3170_: bool;
    var phi_3171_: bool;
    var phi_3172_: bool;
    var phi_3173_: bool;
    var phi_3177_: bool;
    var phi_3181_: bool;
    var phi_3182_: bool;
    var phi_3183_: bool;
    var phi_3184_: bool;
    var phi_1428_: u32;
    var phi_3188_: bool;
    var local_11: bool;
    var phi_3230_: bool;
    var phi_3231_: bool;
    var phi_3262_: u32;
    var phi_3263_: u32;
    var phi_1098_: u32;
    var phi_3264_: bool;
    var phi_3265_: bool;
    var local_12: bool;
    var phi_3269_: bool;
    var phi_3273_: bool;
    var phi_3274_: bool;
    var phi_3275_: bool;
    var phi_3276_: bool;
    var phi_3280_: bool;
    var phi_3284_: f32;
    var phi_3305_: u32;
    var phi_3320_: u32;
    var phi_3325_: u32;
    var local_13: bool;
    var local_14: bool;
    var local_15: bool;
    var local_16: bool;
    var local_17: bool;
    var local_18: bool;

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
            phi_699_ = 300000000000000000000000000000000000000f;
        } else {
            phi_699_ = 1f;
        }
        let _e145 = phi_699_;
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
                                    phi_756_ = bool();
                                    phi_757_ = true;
                                } else {
                                    let _e169 = (_e160 > 0f);
                                    if _e169 {
                                        phi_755_ = bool();
                                    } else {
                                        phi_755_ = (_e161 > 0f);
                                    }
                                    let _e172 = phi_755_;
                                    phi_756_ = _e172;
                                    phi_757_ = _e169;
                                }
                                let _e174 = phi_756_;
                                let _e176 = phi_757_;
                                if _e176 {
                                    phi_761_ = true;
                                } else {
                                    phi_761_ = _e174;
                                }
                                let _e178 = phi_761_;
                                phi_762_ = _e178;
                                phi_763_ = false;
                            } else {
                                phi_762_ = bool();
                                phi_763_ = true;
                            }
                            let _e180 = phi_762_;
                            let _e182 = phi_763_;
                            phi_764_ = _e180;
                            phi_765_ = false;
                            phi_766_ = _e182;
                        } else {
                            phi_764_ = bool();
                            phi_765_ = true;
                            phi_766_ = false;
                        }
                        let _e184 = phi_764_;
                        let _e186 = phi_765_;
                        let _e188 = phi_766_;
                        phi_767_ = _e184;
                        phi_768_ = _e186;
                        phi_769_ = _e188;
                    } else {
                        phi_767_ = bool();
                        phi_768_ = true;
                        phi_769_ = false;
                    }
                    let _e190 = phi_767_;
                    let _e192 = phi_768_;
                    let _e194 = phi_769_;
                    phi_770_ = _e190;
                    phi_771_ = _e192;
                    phi_772_ = _e194;
                } else {
                    phi_770_ = bool();
                    phi_771_ = true;
                    phi_772_ = false;
                }
                let _e196 = phi_770_;
                let _e198 = phi_771_;
                let _e200 = phi_772_;
                phi_773_ = _e196;
                phi_774_ = _e198;
                phi_775_ = _e200;
            } else {
                phi_773_ = bool();
                phi_774_ = true;
                phi_775_ = false;
            }
            let _e202 = phi_773_;
            let _e204 = phi_774_;
            let _e206 = phi_775_;
            phi_776_ = _e202;
            phi_777_ = _e204;
            phi_778_ = _e206;
        } else {
            phi_776_ = bool();
            phi_777_ = true;
            phi_778_ = false;
        }
        let _e208 = phi_776_;
        let _e210 = phi_777_;
        let _e212 = phi_778_;
        if _e210 {
            phi_782_ = true;
        } else {
            phi_782_ = _e212;
        }
        let _e214 = phi_782_;
        if _e214 {
            phi_786_ = false;
        } else {
            phi_786_ = _e208;
        }
        let _e216 = phi_786_;
        if _e216 {
            let _e217 = (_e116 >= _e77);
            if _e217 {
                phi_3274_ = bool();
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
                    phi_856_ = _e283;
                } else {
                    phi_856_ = abs(_e153);
                }
                let _e288 = phi_856_;
                if (_e153 < 0f) {
                    phi_863_ = (-1f / _e288);
                } else {
                    phi_863_ = (1f / _e288);
                }
                let _e293 = phi_863_;
                if (abs(_e154) < _e283) {
                    phi_870_ = _e283;
                } else {
                    phi_870_ = abs(_e154);
                }
                let _e298 = phi_870_;
                if (_e154 < 0f) {
                    phi_877_ = (-1f / _e298);
                } else {
                    phi_877_ = (1f / _e298);
                }
                let _e303 = phi_877_;
                if (abs(_e155) < _e283) {
                    phi_884_ = _e283;
                } else {
                    phi_884_ = abs(_e155);
                }
                let _e308 = phi_884_;
                if (_e155 < 0f) {
                    phi_891_ = (-1f / _e308);
                } else {
                    phi_891_ = (1f / _e308);
                }
                let _e313 = phi_891_;
                let _e317 = abs((bitcast<f32>(_e223) - _e137));
                let _e318 = abs((bitcast<f32>(_e227) - _e139));
                let _e319 = abs((bitcast<f32>(_e231) - _e141));
                let _e323 = abs(((bitcast<f32>(_e235) + (bitcast<f32>((((_e247 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e137));
                let _e324 = abs(((bitcast<f32>(_e239) + (bitcast<f32>((((_e247 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e139));
                let _e325 = abs(((bitcast<f32>(_e243) + (bitcast<f32>((((_e247 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e141));
                if (_e317 > _e323) {
                    phi_908_ = _e317;
                } else {
                    phi_908_ = _e323;
                }
                let _e328 = phi_908_;
                if (_e318 > _e324) {
                    phi_913_ = _e318;
                } else {
                    phi_913_ = _e324;
                }
                let _e331 = phi_913_;
                if (_e319 > _e325) {
                    phi_918_ = _e319;
                } else {
                    phi_918_ = _e325;
                }
                let _e334 = phi_918_;
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
                    phi_939_ = 0u;
                } else {
                    phi_939_ = 1u;
                }
                let _e353 = phi_939_;
                if (_e303 < 0f) {
                    phi_944_ = 0u;
                } else {
                    phi_944_ = 2u;
                }
                let _e356 = phi_944_;
                if (_e313 < 0f) {
                    phi_949_ = 0u;
                } else {
                    phi_949_ = 4u;
                }
                let _e359 = phi_949_;
                let _e361 = ((_e353 | _e356) | _e359);
                let _e362 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e116, 2147483648u);
                local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e362.first[0], _e362.first[1], _e362.first[2], _e362.first[3], _e362.first[4], _e362.first[5], _e362.first[6], _e362.first[7], _e362.first[8], _e362.first[9], _e362.first[10], _e362.first[11], _e362.first[12], _e362.first[13], _e362.first[14], _e362.first[15], _e362.first[16], _e362.first[17], _e362.first[18], _e362.first[19], _e362.first[20], _e362.first[21], _e362.first[22], _e362.first[23], _e362.first[24], _e362.first[25], _e362.first[26], _e362.first[27], _e362.first[28], _e362.first[29], _e362.first[30], _e362.first[31]), array<u32, 32>(_e362.mask[0], _e362.mask[1], _e362.mask[2], _e362.mask[3], _e362.mask[4], _e362.mask[5], _e362.mask[6], _e362.mask[7], _e362.mask[8], _e362.mask[9], _e362.mask[10], _e362.mask[11], _e362.mask[12], _e362.mask[13], _e362.mask[14], _e362.mask[15], _e362.mask[16], _e362.mask[17], _e362.mask[18], _e362.mask[19], _e362.mask[20], _e362.mask[21], _e362.mask[22], _e362.mask[23], _e362.mask[24], _e362.mask[25], _e362.mask[26], _e362.mask[27], _e362.mask[28], _e362.mask[29], _e362.mask[30], _e362.mask[31]), _e362.len, _e362.group, _e362.group_mask);
                let _e436 = local_2.group_mask;
                if ((_e436 & 4278190080u) == 0u) {
                    let _e440 = local_2.len;
                    if (_e440 == 0u) {
                        phi_1063_ = false;
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
                        phi_1063_ = true;
                    }
                    let _e463 = phi_1063_;
                    phi_1064_ = _e463;
                } else {
                    phi_1064_ = true;
                }
                let _e465 = phi_1064_;
                if _e465 {
                    let _e467 = local_2.group_mask;
                    let _e473 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e467)), 32u, (_e467 == 0u)));
                    let _e477 = local_2.group_mask;
                    let _e491 = local_2.group_mask;
                    local_2.group_mask = (_e491 & ~((1u << bitcast<u32>((_e473 & 31u)))));
                    let _e494 = local_2.group;
                    phi_1095_ = (_e494 + countOneBits(((_e477 & ~((4294967295u << bitcast<u32>((((_e473 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1095_ = 4294967295u;
                }
                let _e497 = phi_1095_;
                phi_1097_ = _e497;
                loop {
                    let _e499 = phi_1097_;
                    if (_e499 != 4294967295u) {
                        if (_e499 < _e77) {
                        } else {
                            return;
                        }
                        let _e506 = nodes.member[(0u + _e499)].frame[3u];
                        let _e531 = (bitcast<f32>((((_e506 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e293);
                        let _e532 = (bitcast<f32>((((_e506 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e303);
                        let _e533 = (bitcast<f32>((((_e506 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e313);
                        let _e536 = nodes.member[(0u + _e499)].frame[0u];
                        let _e540 = nodes.member[(0u + _e499)].frame[1u];
                        let _e544 = nodes.member[(0u + _e499)].frame[2u];
                        let _e549 = ((bitcast<f32>(_e536) - _e137) * _e293);
                        let _e550 = ((bitcast<f32>(_e540) - _e139) * _e303);
                        let _e551 = ((bitcast<f32>(_e544) - _e141) * _e313);
                        let _e559 = nodes.member[(0u + _e499)].x;
                        if (_e293 < 0f) {
                            let _e570 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e559.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e576 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e570.unnamed.root, _e559.w), _e570.unnamed_1);
                            let _e582 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e576.unnamed, lt_bvh_traverse_Tree(_e559.x, _e576.unnamed_1.first_primitive));
                            phi_1178_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e582.unnamed, lt_bvh_traverse_Tree(_e582.unnamed_1.root, _e559.y));
                        } else {
                            let _e598 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e559.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e604 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e598.unnamed.root, _e559.y), _e598.unnamed_1);
                            let _e610 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e604.unnamed, lt_bvh_traverse_Tree(_e559.z, _e604.unnamed_1.first_primitive));
                            phi_1178_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e610.unnamed, lt_bvh_traverse_Tree(_e610.unnamed_1.root, _e559.w));
                        }
                        let _e618 = phi_1178_;
                        let _e628 = nodes.member[(0u + _e499)].y;
                        if (_e303 < 0f) {
                            let _e639 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e628.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e645 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e639.unnamed.root, _e628.w), _e639.unnamed_1);
                            let _e651 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e645.unnamed, lt_bvh_traverse_Tree(_e628.x, _e645.unnamed_1.first_primitive));
                            phi_1205_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e651.unnamed, lt_bvh_traverse_Tree(_e651.unnamed_1.root, _e628.y));
                        } else {
                            let _e667 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e628.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e673 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e667.unnamed.root, _e628.y), _e667.unnamed_1);
                            let _e679 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e673.unnamed, lt_bvh_traverse_Tree(_e628.z, _e673.unnamed_1.first_primitive));
                            phi_1205_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e679.unnamed, lt_bvh_traverse_Tree(_e679.unnamed_1.root, _e628.w));
                        }
                        let _e687 = phi_1205_;
                        let _e697 = nodes.member[(0u + _e499)].z;
                        if (_e313 < 0f) {
                            let _e708 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e697.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e714 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e708.unnamed.root, _e697.w), _e708.unnamed_1);
                            let _e720 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e714.unnamed, lt_bvh_traverse_Tree(_e697.x, _e714.unnamed_1.first_primitive));
                            phi_1232_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e720.unnamed, lt_bvh_traverse_Tree(_e720.unnamed_1.root, _e697.y));
                        } else {
                            let _e736 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e697.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e742 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e736.unnamed.root, _e697.y), _e736.unnamed_1);
                            let _e748 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e742.unnamed, lt_bvh_traverse_Tree(_e697.z, _e742.unnamed_1.first_primitive));
                            phi_1232_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e748.unnamed, lt_bvh_traverse_Tree(_e748.unnamed_1.root, _e697.w));
                        }
                        let _e756 = phi_1232_;
                        phi_1238_ = 0u;
                        phi_1241_ = 0u;
                        loop {
                            let _e766 = phi_1238_;
                            let _e768 = phi_1241_;
                            local_3 = _e768;
                            local_4 = _e768;
                            local_5 = _e768;
                            let _e769 = (_e766 < 8u);
                            if _e769 {
                                let _e771 = (_e766 >> bitcast<u32>(2i));
                                let _e772 = (_e766 & 3u);
                                if (_e771 == 0u) {
                                    phi_1255_ = _e618.unnamed.root;
                                } else {
                                    phi_1255_ = _e618.unnamed.first_primitive;
                                }
                                let _e775 = phi_1255_;
                                if (_e771 == 0u) {
                                    phi_1265_ = _e687.unnamed.root;
                                } else {
                                    phi_1265_ = _e687.unnamed.first_primitive;
                                }
                                let _e784 = phi_1265_;
                                if (_e771 == 0u) {
                                    phi_1275_ = _e756.unnamed.root;
                                } else {
                                    phi_1275_ = _e756.unnamed.first_primitive;
                                }
                                let _e793 = phi_1275_;
                                let _e806 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e775 >> bitcast<u32>(((_e772 * 8u) & 31u))) & 255u)) * _e531) + (_e549 - _e341)), ((f32(((_e784 >> bitcast<u32>(((_e772 * 8u) & 31u))) & 255u)) * _e532) + (_e550 - _e342)));
                                let _e807 = core_intrinsics_maximum_number_nsz_f32_(_e806, ((f32(((_e793 >> bitcast<u32>(((_e772 * 8u) & 31u))) & 255u)) * _e533) + (_e551 - _e343)));
                                if (_e771 == 0u) {
                                    phi_1293_ = _e618.unnamed_1.root;
                                } else {
                                    phi_1293_ = _e618.unnamed_1.first_primitive;
                                }
                                let _e810 = phi_1293_;
                                if (_e771 == 0u) {
                                    phi_1303_ = _e687.unnamed_1.root;
                                } else {
                                    phi_1303_ = _e687.unnamed_1.first_primitive;
                                }
                                let _e819 = phi_1303_;
                                if (_e771 == 0u) {
                                    phi_1313_ = _e756.unnamed_1.root;
                                } else {
                                    phi_1313_ = _e756.unnamed_1.first_primitive;
                                }
                                let _e828 = phi_1313_;
                                let _e841 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e810 >> bitcast<u32>(((_e772 * 8u) & 31u))) & 255u)) * _e531) + (_e549 + _e341)), ((f32(((_e819 >> bitcast<u32>(((_e772 * 8u) & 31u))) & 255u)) * _e532) + (_e550 + _e342)));
                                let _e842 = core_intrinsics_minimum_number_nsz_f32_(_e841, ((f32(((_e828 >> bitcast<u32>(((_e772 * 8u) & 31u))) & 255u)) * _e533) + (_e551 + _e343)));
                                if (_e807 <= _e842) {
                                    if (_e807 <= _e145) {
                                        if (_e842 >= 0f) {
                                            if (_e771 == 0u) {
                                                let _e849 = nodes.member[(0u + _e499)].links[2u];
                                                phi_1349_ = _e849;
                                            } else {
                                                let _e852 = nodes.member[(0u + _e499)].links[3u];
                                                phi_1349_ = _e852;
                                            }
                                            let _e854 = phi_1349_;
                                            let _e859 = ((_e854 >> bitcast<u32>(((_e772 * 8u) & 31u))) & 255u);
                                            let _e860 = (_e859 & 31u);
                                            if (_e860 >= 24u) {
                                                phi_1362_ = (24u + ((_e860 - 24u) ^ _e361));
                                            } else {
                                                phi_1362_ = _e860;
                                            }
                                            let _e866 = phi_1362_;
                                            phi_1367_ = (_e768 | ((_e859 >> bitcast<u32>(5i)) << bitcast<u32>((_e866 & 31u))));
                                        } else {
                                            phi_1367_ = _e768;
                                        }
                                        let _e874 = phi_1367_;
                                        phi_1368_ = _e874;
                                    } else {
                                        phi_1368_ = _e768;
                                    }
                                    let _e876 = phi_1368_;
                                    phi_1369_ = _e876;
                                } else {
                                    phi_1369_ = _e768;
                                }
                                let _e878 = phi_1369_;
                                phi_1239_ = (_e766 + 1u);
                                phi_1242_ = _e878;
                            } else {
                                phi_1239_ = u32();
                                phi_1242_ = u32();
                            }
                            let _e881 = phi_1239_;
                            let _e883 = phi_1242_;
                            continue;
                            continuing {
                                phi_1238_ = _e881;
                                phi_1241_ = _e883;
                                break if !(_e769);
                            }
                        }
                        let _e887 = nodes.member[(0u + _e499)].links[0u];
                        let _e891 = nodes.member[(0u + _e499)].frame[3u];
                        let _e895 = local_3;
                        if ((_e895 & 4278190080u) == 0u) {
                        } else {
                            let _e899 = local_2.group_mask;
                            if ((_e899 & 4278190080u) == 0u) {
                            } else {
                                let _e903 = local_2.len;
                                if (_e903 < 32u) {
                                    let _e906 = local_2.group;
                                    let _e908 = local_2.len;
                                    if (_e908 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.first[(0u + _e908)] = _e906;
                                    let _e914 = local_2.group_mask;
                                    let _e916 = local_2.len;
                                    if (_e916 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.mask[(0u + _e916)] = _e914;
                                    let _e923 = local_2.len;
                                    local_2.len = (_e923 + 1u);
                                }
                            }
                            local_2.group = (_e116 + _e887);
                            let _e927 = local_4;
                            local_2.group_mask = ((_e927 & 4278190080u) | (_e891 >> bitcast<u32>(24i)));
                        }
                        let _e932 = local_5;
                        phi_1427_ = (_e932 & 16777215u);
                        loop {
                            let _e935 = phi_1427_;
                            let _e936 = (_e935 == 0u);
                            local_11 = _e936;
                            local_18 = _e936;
                            if _e936 {
                                phi_1428_ = u32();
                                phi_3188_ = false;
                            } else {
                                let _e939 = nodes.member[(0u + _e499)].links[1u];
                                let _e943 = (_e939 + select(firstTrailingBit(_e935), 32u, (_e935 == 0u)));
                                if (_e943 < arrayLength((&instances.member))) {
                                } else {
                                    return;
                                }
                                let _e950 = instances.member[(0u + _e943)].low_world;
                                let _e952 = instances.member[(0u + _e943)].high_world;
                                let _e959 = ((_e950.x - _e137) * _e293);
                                let _e960 = ((_e950.y - _e139) * _e303);
                                let _e961 = ((_e950.z - _e141) * _e313);
                                let _e968 = ((_e952.x - _e137) * _e293);
                                let _e969 = ((_e952.y - _e139) * _e303);
                                let _e970 = ((_e952.z - _e141) * _e313);
                                if (_e959 < _e968) {
                                    phi_1477_ = _e959;
                                } else {
                                    phi_1477_ = _e968;
                                }
                                let _e973 = phi_1477_;
                                if (_e960 < _e969) {
                                    phi_1482_ = _e960;
                                } else {
                                    phi_1482_ = _e969;
                                }
                                let _e976 = phi_1482_;
                                if (_e961 < _e970) {
                                    phi_1487_ = _e961;
                                } else {
                                    phi_1487_ = _e970;
                                }
                                let _e979 = phi_1487_;
                                if (_e959 > _e968) {
                                    phi_1495_ = _e959;
                                } else {
                                    phi_1495_ = _e968;
                                }
                                let _e985 = phi_1495_;
                                if (_e960 > _e969) {
                                    phi_1500_ = _e960;
                                } else {
                                    phi_1500_ = _e969;
                                }
                                let _e988 = phi_1500_;
                                if (_e961 > _e970) {
                                    phi_1505_ = _e961;
                                } else {
                                    phi_1505_ = _e970;
                                }
                                let _e991 = phi_1505_;
                                let _e995 = core_intrinsics_maximum_number_nsz_f32_((_e973 - _e348), (_e976 - _e349));
                                let _e996 = core_intrinsics_maximum_number_nsz_f32_(_e995, (_e979 - _e350));
                                let _e997 = core_intrinsics_minimum_number_nsz_f32_((_e985 + _e348), (_e988 + _e349));
                                let _e998 = core_intrinsics_minimum_number_nsz_f32_(_e997, (_e991 + _e350));
                                if (_e996 <= _e998) {
                                    if (_e996 <= _e145) {
                                        if (_e998 >= 0f) {
                                            let _e1004 = instances.member[(0u + _e943)].world_to_object[0u];
                                            let _e1015 = ((((_e1004.x * _e137) + (_e1004.y * _e139)) + (_e1004.z * _e141)) + (_e1004.w * 1f));
                                            let _e1017 = instances.member[(0u + _e943)].world_to_object[1u];
                                            let _e1028 = ((((_e1017.x * _e137) + (_e1017.y * _e139)) + (_e1017.z * _e141)) + (_e1017.w * 1f));
                                            let _e1030 = instances.member[(0u + _e943)].world_to_object[2u];
                                            let _e1041 = ((((_e1030.x * _e137) + (_e1030.y * _e139)) + (_e1030.z * _e141)) + (_e1030.w * 1f));
                                            let _e1044 = instances.member[(0u + _e943)].world_to_object[0u];
                                            let _e1055 = ((((_e1044.x * _e153) + (_e1044.y * _e154)) + (_e1044.z * _e155)) + (_e1044.w * 0f));
                                            let _e1057 = instances.member[(0u + _e943)].world_to_object[1u];
                                            let _e1068 = ((((_e1057.x * _e153) + (_e1057.y * _e154)) + (_e1057.z * _e155)) + (_e1057.w * 0f));
                                            let _e1070 = instances.member[(0u + _e943)].world_to_object[2u];
                                            let _e1081 = ((((_e1070.x * _e153) + (_e1070.y * _e154)) + (_e1070.z * _e155)) + (_e1070.w * 0f));
                                            let _e1084 = instances.member[(0u + _e943)].root;
                                            let _e1086 = instances.member[(0u + _e943)].first_triangle;
                                            let _e1090 = abs(_e1055);
                                            let _e1091 = abs(_e1068);
                                            let _e1092 = abs(_e1081);
                                            if (abs(_e1015) < 1000000000000000f) {
                                                if (abs(_e1028) < 1000000000000000f) {
                                                    if (abs(_e1041) < 1000000000000000f) {
                                                        if (_e1090 < 1000000000000000f) {
                                                            if (_e1091 < 1000000000000000f) {
                                                                if (_e1092 < 1000000000000000f) {
                                                                    if (_e1090 > 0f) {
                                                                        phi_1650_ = bool();
                                                                        phi_1651_ = true;
                                                                    } else {
                                                                        let _e1100 = (_e1091 > 0f);
                                                                        if _e1100 {
                                                                            phi_1649_ = bool();
                                                                        } else {
                                                                            phi_1649_ = (_e1092 > 0f);
                                                                        }
                                                                        let _e1103 = phi_1649_;
                                                                        phi_1650_ = _e1103;
                                                                        phi_1651_ = _e1100;
                                                                    }
                                                                    let _e1105 = phi_1650_;
                                                                    let _e1107 = phi_1651_;
                                                                    if _e1107 {
                                                                        phi_1655_ = true;
                                                                    } else {
                                                                        phi_1655_ = _e1105;
                                                                    }
                                                                    let _e1109 = phi_1655_;
                                                                    phi_1656_ = _e1109;
                                                                    phi_1657_ = false;
                                                                } else {
                                                                    phi_1656_ = bool();
                                                                    phi_1657_ = true;
                                                                }
                                                                let _e1111 = phi_1656_;
                                                                let _e1113 = phi_1657_;
                                                                phi_1658_ = _e1111;
                                                                phi_1659_ = false;
                                                                phi_1660_ = _e1113;
                                                            } else {
                                                                phi_1658_ = bool();
                                                                phi_1659_ = true;
                                                                phi_1660_ = false;
                                                            }
                                                            let _e1115 = phi_1658_;
                                                            let _e1117 = phi_1659_;
                                                            let _e1119 = phi_1660_;
                                                            phi_1661_ = _e1115;
                                                            phi_1662_ = _e1117;
                                                            phi_1663_ = _e1119;
                                                        } else {
                                                            phi_1661_ = bool();
                                                            phi_1662_ = true;
                                                            phi_1663_ = false;
                                                        }
                                                        let _e1121 = phi_1661_;
                                                        let _e1123 = phi_1662_;
                                                        let _e1125 = phi_1663_;
                                                        phi_1664_ = _e1121;
                                                        phi_1665_ = _e1123;
                                                        phi_1666_ = _e1125;
                                                    } else {
                                                        phi_1664_ = bool();
                                                        phi_1665_ = true;
                                                        phi_1666_ = false;
                                                    }
                                                    let _e1127 = phi_1664_;
                                                    let _e1129 = phi_1665_;
                                                    let _e1131 = phi_1666_;
                                                    phi_1667_ = _e1127;
                                                    phi_1668_ = _e1129;
                                                    phi_1669_ = _e1131;
                                                } else {
                                                    phi_1667_ = bool();
                                                    phi_1668_ = true;
                                                    phi_1669_ = false;
                                                }
                                                let _e1133 = phi_1667_;
                                                let _e1135 = phi_1668_;
                                                let _e1137 = phi_1669_;
                                                phi_1670_ = _e1133;
                                                phi_1671_ = _e1135;
                                                phi_1672_ = _e1137;
                                            } else {
                                                phi_1670_ = bool();
                                                phi_1671_ = true;
                                                phi_1672_ = false;
                                            }
                                            let _e1139 = phi_1670_;
                                            let _e1141 = phi_1671_;
                                            let _e1143 = phi_1672_;
                                            if _e1141 {
                                                phi_1676_ = true;
                                            } else {
                                                phi_1676_ = _e1143;
                                            }
                                            let _e1145 = phi_1676_;
                                            if _e1145 {
                                                phi_1680_ = false;
                                            } else {
                                                phi_1680_ = _e1139;
                                            }
                                            let _e1147 = phi_1680_;
                                            if _e1147 {
                                                let _e1148 = (_e1084 >= _e77);
                                                if _e1148 {
                                                    phi_3171_ = bool();
                                                } else {
                                                    if (_e1084 < _e77) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1154 = nodes.member[(0u + _e1084)].frame[0u];
                                                    let _e1158 = nodes.member[(0u + _e1084)].frame[1u];
                                                    let _e1162 = nodes.member[(0u + _e1084)].frame[2u];
                                                    let _e1166 = nodes.member[(0u + _e1084)].frame[0u];
                                                    let _e1170 = nodes.member[(0u + _e1084)].frame[1u];
                                                    let _e1174 = nodes.member[(0u + _e1084)].frame[2u];
                                                    let _e1178 = nodes.member[(0u + _e1084)].frame[3u];
                                                    let _e1212 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1055), abs(_e1068));
                                                    let _e1213 = core_intrinsics_maximum_number_nsz_f32_(_e1212, abs(_e1081));
                                                    let _e1214 = (_e1213 * 0.0000000000009094947f);
                                                    if (abs(_e1055) < _e1214) {
                                                        phi_1750_ = _e1214;
                                                    } else {
                                                        phi_1750_ = abs(_e1055);
                                                    }
                                                    let _e1219 = phi_1750_;
                                                    if (_e1055 < 0f) {
                                                        phi_1757_ = (-1f / _e1219);
                                                    } else {
                                                        phi_1757_ = (1f / _e1219);
                                                    }
                                                    let _e1224 = phi_1757_;
                                                    if (abs(_e1068) < _e1214) {
                                                        phi_1764_ = _e1214;
                                                    } else {
                                                        phi_1764_ = abs(_e1068);
                                                    }
                                                    let _e1229 = phi_1764_;
                                                    if (_e1068 < 0f) {
                                                        phi_1771_ = (-1f / _e1229);
                                                    } else {
                                                        phi_1771_ = (1f / _e1229);
                                                    }
                                                    let _e1234 = phi_1771_;
                                                    if (abs(_e1081) < _e1214) {
                                                        phi_1778_ = _e1214;
                                                    } else {
                                                        phi_1778_ = abs(_e1081);
                                                    }
                                                    let _e1239 = phi_1778_;
                                                    if (_e1081 < 0f) {
                                                        phi_1785_ = (-1f / _e1239);
                                                    } else {
                                                        phi_1785_ = (1f / _e1239);
                                                    }
                                                    let _e1244 = phi_1785_;
                                                    let _e1248 = abs((bitcast<f32>(_e1154) - _e1015));
                                                    let _e1249 = abs((bitcast<f32>(_e1158) - _e1028));
                                                    let _e1250 = abs((bitcast<f32>(_e1162) - _e1041));
                                                    let _e1254 = abs(((bitcast<f32>(_e1166) + (bitcast<f32>((((_e1178 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1015));
                                                    let _e1255 = abs(((bitcast<f32>(_e1170) + (bitcast<f32>((((_e1178 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1028));
                                                    let _e1256 = abs(((bitcast<f32>(_e1174) + (bitcast<f32>((((_e1178 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1041));
                                                    if (_e1248 > _e1254) {
                                                        phi_1802_ = _e1248;
                                                    } else {
                                                        phi_1802_ = _e1254;
                                                    }
                                                    let _e1259 = phi_1802_;
                                                    if (_e1249 > _e1255) {
                                                        phi_1807_ = _e1249;
                                                    } else {
                                                        phi_1807_ = _e1255;
                                                    }
                                                    let _e1262 = phi_1807_;
                                                    if (_e1250 > _e1256) {
                                                        phi_1812_ = _e1250;
                                                    } else {
                                                        phi_1812_ = _e1256;
                                                    }
                                                    let _e1265 = phi_1812_;
                                                    let _e1266 = core_intrinsics_maximum_number_nsz_f32_(_e1259, _e1262);
                                                    let _e1267 = core_intrinsics_maximum_number_nsz_f32_(_e1266, _e1265);
                                                    let _e1271 = (_e1267 * 0.0000019073486f);
                                                    let _e1272 = (abs(_e1224) * _e1271);
                                                    let _e1273 = (abs(_e1234) * _e1271);
                                                    let _e1274 = (abs(_e1244) * _e1271);
                                                    let _e1278 = (_e1267 * 0.0000009536743f);
                                                    let _e1279 = (abs(_e1224) * _e1278);
                                                    let _e1280 = (abs(_e1234) * _e1278);
                                                    let _e1281 = (abs(_e1244) * _e1278);
                                                    let _e1282 = abs(_e1055);
                                                    let _e1283 = abs(_e1068);
                                                    let _e1284 = abs(_e1081);
                                                    if (_e1282 >= _e1283) {
                                                        if (_e1282 >= _e1284) {
                                                            phi_1840_ = false;
                                                        } else {
                                                            phi_1840_ = true;
                                                        }
                                                        let _e1288 = phi_1840_;
                                                        phi_1841_ = _e1288;
                                                    } else {
                                                        phi_1841_ = true;
                                                    }
                                                    let _e1290 = phi_1841_;
                                                    if _e1290 {
                                                        if (_e1283 >= _e1284) {
                                                            phi_1849_ = 1u;
                                                        } else {
                                                            phi_1849_ = 2u;
                                                        }
                                                        let _e1293 = phi_1849_;
                                                        phi_1850_ = _e1293;
                                                    } else {
                                                        phi_1850_ = 0u;
                                                    }
                                                    let _e1295 = phi_1850_;
                                                    if (_e1295 == 0u) {
                                                        phi_1862_ = vec3<f32>(_e1068, _e1081, _e1055);
                                                    } else {
                                                        if (_e1295 == 1u) {
                                                            phi_1861_ = vec3<f32>(_e1081, _e1055, _e1068);
                                                        } else {
                                                            phi_1861_ = vec3<f32>(_e1055, _e1068, _e1081);
                                                        }
                                                        let _e1301 = phi_1861_;
                                                        phi_1862_ = _e1301;
                                                    }
                                                    let _e1303 = phi_1862_;
                                                    let _e1306 = (_e1303.x / _e1303.z);
                                                    let _e1309 = (_e1303.y / _e1303.z);
                                                    let _e1311 = (1f / _e1303.z);
                                                    if (_e1224 < 0f) {
                                                        phi_1875_ = 0u;
                                                    } else {
                                                        phi_1875_ = 1u;
                                                    }
                                                    let _e1314 = phi_1875_;
                                                    if (_e1234 < 0f) {
                                                        phi_1880_ = 0u;
                                                    } else {
                                                        phi_1880_ = 2u;
                                                    }
                                                    let _e1317 = phi_1880_;
                                                    if (_e1244 < 0f) {
                                                        phi_1885_ = 0u;
                                                    } else {
                                                        phi_1885_ = 4u;
                                                    }
                                                    let _e1320 = phi_1885_;
                                                    let _e1322 = ((_e1314 | _e1317) | _e1320);
                                                    let _e1323 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1084, 2147483648u);
                                                    local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e1323.first[0], _e1323.first[1], _e1323.first[2], _e1323.first[3], _e1323.first[4], _e1323.first[5], _e1323.first[6], _e1323.first[7], _e1323.first[8], _e1323.first[9], _e1323.first[10], _e1323.first[11], _e1323.first[12], _e1323.first[13], _e1323.first[14], _e1323.first[15], _e1323.first[16], _e1323.first[17], _e1323.first[18], _e1323.first[19], _e1323.first[20], _e1323.first[21], _e1323.first[22], _e1323.first[23], _e1323.first[24], _e1323.first[25], _e1323.first[26], _e1323.first[27], _e1323.first[28], _e1323.first[29], _e1323.first[30], _e1323.first[31]), array<u32, 32>(_e1323.mask[0], _e1323.mask[1], _e1323.mask[2], _e1323.mask[3], _e1323.mask[4], _e1323.mask[5], _e1323.mask[6], _e1323.mask[7], _e1323.mask[8], _e1323.mask[9], _e1323.mask[10], _e1323.mask[11], _e1323.mask[12], _e1323.mask[13], _e1323.mask[14], _e1323.mask[15], _e1323.mask[16], _e1323.mask[17], _e1323.mask[18], _e1323.mask[19], _e1323.mask[20], _e1323.mask[21], _e1323.mask[22], _e1323.mask[23], _e1323.mask[24], _e1323.mask[25], _e1323.mask[26], _e1323.mask[27], _e1323.mask[28], _e1323.mask[29], _e1323.mask[30], _e1323.mask[31]), _e1323.len, _e1323.group, _e1323.group_mask);
                                                    let _e1397 = local_1.group_mask;
                                                    if ((_e1397 & 4278190080u) == 0u) {
                                                        let _e1401 = local_1.len;
                                                        if (_e1401 == 0u) {
                                                            phi_1999_ = false;
                                                        } else {
                                                            let _e1405 = local_1.len;
                                                            local_1.len = (_e1405 - 1u);
                                                            let _e1408 = local_1.len;
                                                            if (_e1408 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1413 = local_1.first[(0u + _e1408)];
                                                            local_1.group = _e1413;
                                                            let _e1416 = local_1.len;
                                                            if (_e1416 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1421 = local_1.mask[(0u + _e1416)];
                                                            local_1.group_mask = _e1421;
                                                            phi_1999_ = true;
                                                        }
                                                        let _e1424 = phi_1999_;
                                                        phi_2000_ = _e1424;
                                                    } else {
                                                        phi_2000_ = true;
                                                    }
                                                    let _e1426 = phi_2000_;
                                                    if _e1426 {
                                                        let _e1428 = local_1.group_mask;
                                                        let _e1434 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1428)), 32u, (_e1428 == 0u)));
                                                        let _e1438 = local_1.group_mask;
                                                        let _e1452 = local_1.group_mask;
                                                        local_1.group_mask = (_e1452 & ~((1u << bitcast<u32>((_e1434 & 31u)))));
                                                        let _e1455 = local_1.group;
                                                        phi_2031_ = (_e1455 + countOneBits(((_e1438 & ~((4294967295u << bitcast<u32>((((_e1434 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_2031_ = 4294967295u;
                                                    }
                                                    let _e1458 = phi_2031_;
                                                    phi_2033_ = _e1458;
                                                    loop {
                                                        let _e1460 = phi_2033_;
                                                        if (_e1460 != 4294967295u) {
                                                            if (_e1460 < _e77) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1467 = nodes.member[(0u + _e1460)].frame[3u];
                                                            let _e1492 = (bitcast<f32>((((_e1467 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1224);
                                                            let _e1493 = (bitcast<f32>((((_e1467 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1234);
                                                            let _e1494 = (bitcast<f32>((((_e1467 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1244);
                                                            let _e1497 = nodes.member[(0u + _e1460)].frame[0u];
                                                            let _e1501 = nodes.member[(0u + _e1460)].frame[1u];
                                                            let _e1505 = nodes.member[(0u + _e1460)].frame[2u];
                                                            let _e1510 = ((bitcast<f32>(_e1497) - _e1015) * _e1224);
                                                            let _e1511 = ((bitcast<f32>(_e1501) - _e1028) * _e1234);
                                                            let _e1512 = ((bitcast<f32>(_e1505) - _e1041) * _e1244);
                                                            let _e1520 = nodes.member[(0u + _e1460)].x;
                                                            if (_e1224 < 0f) {
                                                                let _e1531 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1520.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1537 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1531.unnamed.root, _e1520.w), _e1531.unnamed_1);
                                                                let _e1543 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1537.unnamed, lt_bvh_traverse_Tree(_e1520.x, _e1537.unnamed_1.first_primitive));
                                                                phi_2114_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1543.unnamed, lt_bvh_traverse_Tree(_e1543.unnamed_1.root, _e1520.y));
                                                            } else {
                                                                let _e1559 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1520.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1565 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1559.unnamed.root, _e1520.y), _e1559.unnamed_1);
                                                                let _e1571 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1565.unnamed, lt_bvh_traverse_Tree(_e1520.z, _e1565.unnamed_1.first_primitive));
                                                                phi_2114_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1571.unnamed, lt_bvh_traverse_Tree(_e1571.unnamed_1.root, _e1520.w));
                                                            }
                                                            let _e1579 = phi_2114_;
                                                            let _e1589 = nodes.member[(0u + _e1460)].y;
                                                            if (_e1234 < 0f) {
                                                                let _e1600 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1589.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1606 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1600.unnamed.root, _e1589.w), _e1600.unnamed_1);
                                                                let _e1612 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1606.unnamed, lt_bvh_traverse_Tree(_e1589.x, _e1606.unnamed_1.first_primitive));
                                                                phi_2141_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1612.unnamed, lt_bvh_traverse_Tree(_e1612.unnamed_1.root, _e1589.y));
                                                            } else {
                                                                let _e1628 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1589.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1634 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1628.unnamed.root, _e1589.y), _e1628.unnamed_1);
                                                                let _e1640 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1634.unnamed, lt_bvh_traverse_Tree(_e1589.z, _e1634.unnamed_1.first_primitive));
                                                                phi_2141_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1640.unnamed, lt_bvh_traverse_Tree(_e1640.unnamed_1.root, _e1589.w));
                                                            }
                                                            let _e1648 = phi_2141_;
                                                            let _e1658 = nodes.member[(0u + _e1460)].z;
                                                            if (_e1244 < 0f) {
                                                                let _e1669 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1658.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1675 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1669.unnamed.root, _e1658.w), _e1669.unnamed_1);
                                                                let _e1681 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1675.unnamed, lt_bvh_traverse_Tree(_e1658.x, _e1675.unnamed_1.first_primitive));
                                                                phi_2168_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1681.unnamed, lt_bvh_traverse_Tree(_e1681.unnamed_1.root, _e1658.y));
                                                            } else {
                                                                let _e1697 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1658.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1703 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1697.unnamed.root, _e1658.y), _e1697.unnamed_1);
                                                                let _e1709 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1703.unnamed, lt_bvh_traverse_Tree(_e1658.z, _e1703.unnamed_1.first_primitive));
                                                                phi_2168_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1709.unnamed, lt_bvh_traverse_Tree(_e1709.unnamed_1.root, _e1658.w));
                                                            }
                                                            let _e1717 = phi_2168_;
                                                            phi_2174_ = 0u;
                                                            phi_2177_ = 0u;
                                                            loop {
                                                                let _e1727 = phi_2174_;
                                                                let _e1729 = phi_2177_;
                                                                local_6 = _e1729;
                                                                local_7 = _e1729;
                                                                local_8 = _e1729;
                                                                let _e1730 = (_e1727 < 8u);
                                                                if _e1730 {
                                                                    let _e1732 = (_e1727 >> bitcast<u32>(2i));
                                                                    let _e1733 = (_e1727 & 3u);
                                                                    if (_e1732 == 0u) {
                                                                        phi_2191_ = _e1579.unnamed.root;
                                                                    } else {
                                                                        phi_2191_ = _e1579.unnamed.first_primitive;
                                                                    }
                                                                    let _e1736 = phi_2191_;
                                                                    if (_e1732 == 0u) {
                                                                        phi_2201_ = _e1648.unnamed.root;
                                                                    } else {
                                                                        phi_2201_ = _e1648.unnamed.first_primitive;
                                                                    }
                                                                    let _e1745 = phi_2201_;
                                                                    if (_e1732 == 0u) {
                                                                        phi_2211_ = _e1717.unnamed.root;
                                                                    } else {
                                                                        phi_2211_ = _e1717.unnamed.first_primitive;
                                                                    }
                                                                    let _e1754 = phi_2211_;
                                                                    let _e1767 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1736 >> bitcast<u32>(((_e1733 * 8u) & 31u))) & 255u)) * _e1492) + (_e1510 - _e1272)), ((f32(((_e1745 >> bitcast<u32>(((_e1733 * 8u) & 31u))) & 255u)) * _e1493) + (_e1511 - _e1273)));
                                                                    let _e1768 = core_intrinsics_maximum_number_nsz_f32_(_e1767, ((f32(((_e1754 >> bitcast<u32>(((_e1733 * 8u) & 31u))) & 255u)) * _e1494) + (_e1512 - _e1274)));
                                                                    if (_e1732 == 0u) {
                                                                        phi_2229_ = _e1579.unnamed_1.root;
                                                                    } else {
                                                                        phi_2229_ = _e1579.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1771 = phi_2229_;
                                                                    if (_e1732 == 0u) {
                                                                        phi_2239_ = _e1648.unnamed_1.root;
                                                                    } else {
                                                                        phi_2239_ = _e1648.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1780 = phi_2239_;
                                                                    if (_e1732 == 0u) {
                                                                        phi_2249_ = _e1717.unnamed_1.root;
                                                                    } else {
                                                                        phi_2249_ = _e1717.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1789 = phi_2249_;
                                                                    let _e1802 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1771 >> bitcast<u32>(((_e1733 * 8u) & 31u))) & 255u)) * _e1492) + (_e1510 + _e1272)), ((f32(((_e1780 >> bitcast<u32>(((_e1733 * 8u) & 31u))) & 255u)) * _e1493) + (_e1511 + _e1273)));
                                                                    let _e1803 = core_intrinsics_minimum_number_nsz_f32_(_e1802, ((f32(((_e1789 >> bitcast<u32>(((_e1733 * 8u) & 31u))) & 255u)) * _e1494) + (_e1512 + _e1274)));
                                                                    if (_e1768 <= _e1803) {
                                                                        if (_e1768 <= _e145) {
                                                                            if (_e1803 >= 0f) {
                                                                                if (_e1732 == 0u) {
                                                                                    let _e1810 = nodes.member[(0u + _e1460)].links[2u];
                                                                                    phi_2285_ = _e1810;
                                                                                } else {
                                                                                    let _e1813 = nodes.member[(0u + _e1460)].links[3u];
                                                                                    phi_2285_ = _e1813;
                                                                                }
                                                                                let _e1815 = phi_2285_;
                                                                                let _e1820 = ((_e1815 >> bitcast<u32>(((_e1733 * 8u) & 31u))) & 255u);
                                                                                let _e1821 = (_e1820 & 31u);
                                                                                if (_e1821 >= 24u) {
                                                                                    phi_2298_ = (24u + ((_e1821 - 24u) ^ _e1322));
                                                                                } else {
                                                                                    phi_2298_ = _e1821;
                                                                                }
                                                                                let _e1827 = phi_2298_;
                                                                                phi_2303_ = (_e1729 | ((_e1820 >> bitcast<u32>(5i)) << bitcast<u32>((_e1827 & 31u))));
                                                                            } else {
                                                                                phi_2303_ = _e1729;
                                                                            }
                                                                            let _e1835 = phi_2303_;
                                                                            phi_2304_ = _e1835;
                                                                        } else {
                                                                            phi_2304_ = _e1729;
                                                                        }
                                                                        let _e1837 = phi_2304_;
                                                                        phi_2305_ = _e1837;
                                                                    } else {
                                                                        phi_2305_ = _e1729;
                                                                    }
                                                                    let _e1839 = phi_2305_;
                                                                    phi_2175_ = (_e1727 + 1u);
                                                                    phi_2178_ = _e1839;
                                                                } else {
                                                                    phi_2175_ = u32();
                                                                    phi_2178_ = u32();
                                                                }
                                                                let _e1842 = phi_2175_;
                                                                let _e1844 = phi_2178_;
                                                                continue;
                                                                continuing {
                                                                    phi_2174_ = _e1842;
                                                                    phi_2177_ = _e1844;
                                                                    break if !(_e1730);
                                                                }
                                                            }
                                                            let _e1848 = nodes.member[(0u + _e1460)].links[0u];
                                                            let _e1852 = nodes.member[(0u + _e1460)].frame[3u];
                                                            let _e1856 = local_6;
                                                            if ((_e1856 & 4278190080u) == 0u) {
                                                            } else {
                                                                let _e1860 = local_1.group_mask;
                                                                if ((_e1860 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1864 = local_1.len;
                                                                    if (_e1864 < 32u) {
                                                                        let _e1867 = local_1.group;
                                                                        let _e1869 = local_1.len;
                                                                        if (_e1869 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_1.first[(0u + _e1869)] = _e1867;
                                                                        let _e1875 = local_1.group_mask;
                                                                        let _e1877 = local_1.len;
                                                                        if (_e1877 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_1.mask[(0u + _e1877)] = _e1875;
                                                                        let _e1884 = local_1.len;
                                                                        local_1.len = (_e1884 + 1u);
                                                                    }
                                                                }
                                                                local_1.group = (_e1084 + _e1848);
                                                                let _e1888 = local_7;
                                                                local_1.group_mask = ((_e1888 & 4278190080u) | (_e1852 >> bitcast<u32>(24i)));
                                                            }
                                                            let _e1893 = local_8;
                                                            phi_2363_ = (_e1893 & 16777215u);
                                                            loop {
                                                                let _e1896 = phi_2363_;
                                                                let _e1897 = (_e1896 == 0u);
                                                                local_9 = _e1897;
                                                                local_15 = _e1897;
                                                                if _e1897 {
                                                                    phi_2364_ = u32();
                                                                    phi_3074_ = false;
                                                                    phi_3075_ = false;
                                                                    phi_3076_ = false;
                                                                } else {
                                                                    let _e1900 = nodes.member[(0u + _e1460)].links[1u];
                                                                    let _e1905 = ((_e1086 + _e1900) + select(firstTrailingBit(_e1896), 32u, (_e1896 == 0u)));
                                                                    if (_e1905 < _e80) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1912 = triangles.member[(0u + _e1905)].v0_;
                                                                    let _e1914 = (_e1912.x - _e1015);
                                                                    let _e1916 = (_e1912.y - _e1028);
                                                                    let _e1918 = (_e1912.z - _e1041);
                                                                    if (_e1295 == 0u) {
                                                                        phi_2409_ = vec3<f32>(_e1916, _e1918, _e1914);
                                                                    } else {
                                                                        if (_e1295 == 1u) {
                                                                            phi_2408_ = vec3<f32>(_e1918, _e1914, _e1916);
                                                                        } else {
                                                                            phi_2408_ = (_e1912 - vec3<f32>(_e1015, _e1028, _e1041));
                                                                        }
                                                                        let _e1926 = phi_2408_;
                                                                        phi_2409_ = _e1926;
                                                                    }
                                                                    let _e1928 = phi_2409_;
                                                                    let _e1932 = (_e1928.x - (_e1306 * _e1928.z));
                                                                    let _e1936 = (_e1928.y - (_e1309 * _e1928.z));
                                                                    let _e1940 = triangles.member[(0u + _e1905)].v1_;
                                                                    let _e1942 = (_e1940.x - _e1015);
                                                                    let _e1944 = (_e1940.y - _e1028);
                                                                    let _e1946 = (_e1940.z - _e1041);
                                                                    if (_e1295 == 0u) {
                                                                        phi_2441_ = vec3<f32>(_e1944, _e1946, _e1942);
                                                                    } else {
                                                                        if (_e1295 == 1u) {
                                                                            phi_2440_ = vec3<f32>(_e1946, _e1942, _e1944);
                                                                        } else {
                                                                            phi_2440_ = (_e1940 - vec3<f32>(_e1015, _e1028, _e1041));
                                                                        }
                                                                        let _e1954 = phi_2440_;
                                                                        phi_2441_ = _e1954;
                                                                    }
                                                                    let _e1956 = phi_2441_;
                                                                    let _e1960 = (_e1956.x - (_e1306 * _e1956.z));
                                                                    let _e1964 = (_e1956.y - (_e1309 * _e1956.z));
                                                                    let _e1968 = triangles.member[(0u + _e1905)].v2_;
                                                                    let _e1970 = (_e1968.x - _e1015);
                                                                    let _e1972 = (_e1968.y - _e1028);
                                                                    let _e1974 = (_e1968.z - _e1041);
                                                                    if (_e1295 == 0u) {
                                                                        phi_2473_ = vec3<f32>(_e1972, _e1974, _e1970);
                                                                    } else {
                                                                        if (_e1295 == 1u) {
                                                                            phi_2472_ = vec3<f32>(_e1974, _e1970, _e1972);
                                                                        } else {
                                                                            phi_2472_ = (_e1968 - vec3<f32>(_e1015, _e1028, _e1041));
                                                                        }
                                                                        let _e1982 = phi_2472_;
                                                                        phi_2473_ = _e1982;
                                                                    }
                                                                    let _e1984 = phi_2473_;
                                                                    let _e1988 = (_e1984.x - (_e1306 * _e1984.z));
                                                                    let _e1992 = (_e1984.y - (_e1309 * _e1984.z));
                                                                    if (_e1960 < _e1988) {
                                                                        phi_2494_ = true;
                                                                    } else {
                                                                        if (_e1960 == _e1988) {
                                                                            phi_2493_ = (_e1964 < _e1992);
                                                                        } else {
                                                                            phi_2493_ = false;
                                                                        }
                                                                        let _e1999 = phi_2493_;
                                                                        phi_2494_ = _e1999;
                                                                    }
                                                                    let _e2001 = phi_2494_;
                                                                    if _e2001 {
                                                                        phi_2498_ = _e1992;
                                                                        phi_2499_ = _e1988;
                                                                        phi_2500_ = _e1964;
                                                                        phi_2501_ = _e1960;
                                                                    } else {
                                                                        phi_2498_ = _e1964;
                                                                        phi_2499_ = _e1960;
                                                                        phi_2500_ = _e1992;
                                                                        phi_2501_ = _e1988;
                                                                    }
                                                                    let _e2003 = phi_2498_;
                                                                    let _e2005 = phi_2499_;
                                                                    let _e2007 = phi_2500_;
                                                                    let _e2009 = phi_2501_;
                                                                    let _e2012 = ((_e2009 * _e2003) - (_e2007 * _e2005));
                                                                    if _e2001 {
                                                                        phi_2509_ = -(_e2012);
                                                                    } else {
                                                                        phi_2509_ = _e2012;
                                                                    }
                                                                    let _e2015 = phi_2509_;
                                                                    if (_e1988 < _e1932) {
                                                                        phi_2520_ = true;
                                                                    } else {
                                                                        if (_e1988 == _e1932) {
                                                                            phi_2519_ = (_e1992 < _e1936);
                                                                        } else {
                                                                            phi_2519_ = false;
                                                                        }
                                                                        let _e2020 = phi_2519_;
                                                                        phi_2520_ = _e2020;
                                                                    }
                                                                    let _e2022 = phi_2520_;
                                                                    if _e2022 {
                                                                        phi_2524_ = _e1936;
                                                                        phi_2525_ = _e1932;
                                                                        phi_2526_ = _e1992;
                                                                        phi_2527_ = _e1988;
                                                                    } else {
                                                                        phi_2524_ = _e1992;
                                                                        phi_2525_ = _e1988;
                                                                        phi_2526_ = _e1936;
                                                                        phi_2527_ = _e1932;
                                                                    }
                                                                    let _e2024 = phi_2524_;
                                                                    let _e2026 = phi_2525_;
                                                                    let _e2028 = phi_2526_;
                                                                    let _e2030 = phi_2527_;
                                                                    let _e2033 = ((_e2030 * _e2024) - (_e2028 * _e2026));
                                                                    if _e2022 {
                                                                        phi_2535_ = -(_e2033);
                                                                    } else {
                                                                        phi_2535_ = _e2033;
                                                                    }
                                                                    let _e2036 = phi_2535_;
                                                                    if (_e1932 < _e1960) {
                                                                        phi_2546_ = true;
                                                                    } else {
                                                                        if (_e1932 == _e1960) {
                                                                            phi_2545_ = (_e1936 < _e1964);
                                                                        } else {
                                                                            phi_2545_ = false;
                                                                        }
                                                                        let _e2041 = phi_2545_;
                                                                        phi_2546_ = _e2041;
                                                                    }
                                                                    let _e2043 = phi_2546_;
                                                                    if _e2043 {
                                                                        phi_2550_ = _e1964;
                                                                        phi_2551_ = _e1960;
                                                                        phi_2552_ = _e1936;
                                                                        phi_2553_ = _e1932;
                                                                    } else {
                                                                        phi_2550_ = _e1936;
                                                                        phi_2551_ = _e1932;
                                                                        phi_2552_ = _e1964;
                                                                        phi_2553_ = _e1960;
                                                                    }
                                                                    let _e2045 = phi_2550_;
                                                                    let _e2047 = phi_2551_;
                                                                    let _e2049 = phi_2552_;
                                                                    let _e2051 = phi_2553_;
                                                                    let _e2054 = ((_e2051 * _e2045) - (_e2049 * _e2047));
                                                                    if _e2043 {
                                                                        phi_2561_ = -(_e2054);
                                                                    } else {
                                                                        phi_2561_ = _e2054;
                                                                    }
                                                                    let _e2057 = phi_2561_;
                                                                    if (_e2015 >= 0f) {
                                                                        if (_e2036 >= 0f) {
                                                                            if (_e2057 >= 0f) {
                                                                                phi_2576_ = ((_e2015 + _e2036) + _e2057);
                                                                                phi_2577_ = false;
                                                                            } else {
                                                                                phi_2576_ = f32();
                                                                                phi_2577_ = true;
                                                                            }
                                                                            let _e2064 = phi_2576_;
                                                                            let _e2066 = phi_2577_;
                                                                            phi_2578_ = _e2064;
                                                                            phi_2579_ = _e2066;
                                                                        } else {
                                                                            phi_2578_ = f32();
                                                                            phi_2579_ = true;
                                                                        }
                                                                        let _e2068 = phi_2578_;
                                                                        let _e2070 = phi_2579_;
                                                                        phi_2580_ = _e2068;
                                                                        phi_2581_ = _e2070;
                                                                    } else {
                                                                        phi_2580_ = f32();
                                                                        phi_2581_ = true;
                                                                    }
                                                                    let _e2072 = phi_2580_;
                                                                    let _e2074 = phi_2581_;
                                                                    if _e2074 {
                                                                        if (_e2015 <= 0f) {
                                                                            if (_e2036 <= 0f) {
                                                                                let _e2077 = (_e2057 <= 0f);
                                                                                if _e2077 {
                                                                                }
                                                                                phi_2599_ = ((_e2015 + _e2036) + _e2057);
                                                                                phi_2600_ = false;
                                                                                phi_2601_ = _e2077;
                                                                            } else {
                                                                                phi_2599_ = f32();
                                                                                phi_2600_ = true;
                                                                                phi_2601_ = false;
                                                                            }
                                                                            let _e2081 = phi_2599_;
                                                                            let _e2083 = phi_2600_;
                                                                            let _e2085 = phi_2601_;
                                                                            phi_2602_ = _e2081;
                                                                            phi_2603_ = _e2083;
                                                                            phi_2604_ = _e2085;
                                                                        } else {
                                                                            phi_2602_ = f32();
                                                                            phi_2603_ = true;
                                                                            phi_2604_ = false;
                                                                        }
                                                                        let _e2087 = phi_2602_;
                                                                        let _e2089 = phi_2603_;
                                                                        let _e2091 = phi_2604_;
                                                                        if _e2089 {
                                                                            phi_2608_ = false;
                                                                        } else {
                                                                            phi_2608_ = _e2091;
                                                                        }
                                                                        let _e2093 = phi_2608_;
                                                                        phi_2609_ = _e2087;
                                                                        phi_2610_ = _e2093;
                                                                    } else {
                                                                        phi_2609_ = _e2072;
                                                                        phi_2610_ = true;
                                                                    }
                                                                    let _e2095 = phi_2609_;
                                                                    let _e2097 = phi_2610_;
                                                                    if _e2097 {
                                                                        let _e2098 = (_e2095 == 0f);
                                                                        if _e2098 {
                                                                            phi_2823_ = lt_bvh_triangle_Intersection();
                                                                            phi_2824_ = false;
                                                                        } else {
                                                                            let _e2104 = ((((_e2015 * (_e1311 * _e1928.z)) + (_e2036 * (_e1311 * _e1956.z))) + (_e2057 * (_e1311 * _e1984.z))) / _e2095);
                                                                            if (_e2104 > 0f) {
                                                                                if (_e2104 < _e145) {
                                                                                    let _e2108 = triangles.member[(0u + _e1905)].v0_;
                                                                                    let _e2110 = triangles.member[(0u + _e1905)].v1_;
                                                                                    if (_e2108.x < _e2110.x) {
                                                                                        phi_2644_ = _e2108.x;
                                                                                    } else {
                                                                                        phi_2644_ = _e2110.x;
                                                                                    }
                                                                                    let _e2117 = phi_2644_;
                                                                                    if (_e2108.y < _e2110.y) {
                                                                                        phi_2653_ = _e2108.y;
                                                                                    } else {
                                                                                        phi_2653_ = _e2110.y;
                                                                                    }
                                                                                    let _e2124 = phi_2653_;
                                                                                    if (_e2108.z < _e2110.z) {
                                                                                        phi_2662_ = _e2108.z;
                                                                                    } else {
                                                                                        phi_2662_ = _e2110.z;
                                                                                    }
                                                                                    let _e2131 = phi_2662_;
                                                                                    let _e2133 = triangles.member[(0u + _e1905)].v2_;
                                                                                    if (_e2117 < _e2133.x) {
                                                                                        phi_2671_ = _e2117;
                                                                                    } else {
                                                                                        phi_2671_ = _e2133.x;
                                                                                    }
                                                                                    let _e2138 = phi_2671_;
                                                                                    if (_e2124 < _e2133.y) {
                                                                                        phi_2678_ = _e2124;
                                                                                    } else {
                                                                                        phi_2678_ = _e2133.y;
                                                                                    }
                                                                                    let _e2143 = phi_2678_;
                                                                                    if (_e2131 < _e2133.z) {
                                                                                        phi_2685_ = _e2131;
                                                                                    } else {
                                                                                        phi_2685_ = _e2133.z;
                                                                                    }
                                                                                    let _e2148 = phi_2685_;
                                                                                    let _e2150 = triangles.member[(0u + _e1905)].v0_;
                                                                                    let _e2152 = triangles.member[(0u + _e1905)].v1_;
                                                                                    if (_e2150.x > _e2152.x) {
                                                                                        phi_2698_ = _e2150.x;
                                                                                    } else {
                                                                                        phi_2698_ = _e2152.x;
                                                                                    }
                                                                                    let _e2159 = phi_2698_;
                                                                                    if (_e2150.y > _e2152.y) {
                                                                                        phi_2707_ = _e2150.y;
                                                                                    } else {
                                                                                        phi_2707_ = _e2152.y;
                                                                                    }
                                                                                    let _e2166 = phi_2707_;
                                                                                    if (_e2150.z > _e2152.z) {
                                                                                        phi_2716_ = _e2150.z;
                                                                                    } else {
                                                                                        phi_2716_ = _e2152.z;
                                                                                    }
                                                                                    let _e2173 = phi_2716_;
                                                                                    let _e2175 = triangles.member[(0u + _e1905)].v2_;
                                                                                    if (_e2159 > _e2175.x) {
                                                                                        phi_2725_ = _e2159;
                                                                                    } else {
                                                                                        phi_2725_ = _e2175.x;
                                                                                    }
                                                                                    let _e2180 = phi_2725_;
                                                                                    if (_e2166 > _e2175.y) {
                                                                                        phi_2732_ = _e2166;
                                                                                    } else {
                                                                                        phi_2732_ = _e2175.y;
                                                                                    }
                                                                                    let _e2185 = phi_2732_;
                                                                                    if (_e2173 > _e2175.z) {
                                                                                        phi_2739_ = _e2173;
                                                                                    } else {
                                                                                        phi_2739_ = _e2175.z;
                                                                                    }
                                                                                    let _e2190 = phi_2739_;
                                                                                    let _e2194 = ((_e2138 - _e1015) * _e1224);
                                                                                    let _e2195 = ((_e2143 - _e1028) * _e1234);
                                                                                    let _e2196 = ((_e2148 - _e1041) * _e1244);
                                                                                    let _e2200 = ((_e2180 - _e1015) * _e1224);
                                                                                    let _e2201 = ((_e2185 - _e1028) * _e1234);
                                                                                    let _e2202 = ((_e2190 - _e1041) * _e1244);
                                                                                    if (_e2194 < _e2200) {
                                                                                        phi_2756_ = _e2194;
                                                                                    } else {
                                                                                        phi_2756_ = _e2200;
                                                                                    }
                                                                                    let _e2205 = phi_2756_;
                                                                                    if (_e2195 < _e2201) {
                                                                                        phi_2761_ = _e2195;
                                                                                    } else {
                                                                                        phi_2761_ = _e2201;
                                                                                    }
                                                                                    let _e2208 = phi_2761_;
                                                                                    if (_e2196 < _e2202) {
                                                                                        phi_2766_ = _e2196;
                                                                                    } else {
                                                                                        phi_2766_ = _e2202;
                                                                                    }
                                                                                    let _e2211 = phi_2766_;
                                                                                    if (_e2194 > _e2200) {
                                                                                        phi_2774_ = _e2194;
                                                                                    } else {
                                                                                        phi_2774_ = _e2200;
                                                                                    }
                                                                                    let _e2217 = phi_2774_;
                                                                                    if (_e2195 > _e2201) {
                                                                                        phi_2779_ = _e2195;
                                                                                    } else {
                                                                                        phi_2779_ = _e2201;
                                                                                    }
                                                                                    let _e2220 = phi_2779_;
                                                                                    if (_e2196 > _e2202) {
                                                                                        phi_2784_ = _e2196;
                                                                                    } else {
                                                                                        phi_2784_ = _e2202;
                                                                                    }
                                                                                    let _e2223 = phi_2784_;
                                                                                    let _e2227 = core_intrinsics_maximum_number_nsz_f32_((_e2205 - _e1279), (_e2208 - _e1280));
                                                                                    let _e2228 = core_intrinsics_maximum_number_nsz_f32_(_e2227, (_e2211 - _e1281));
                                                                                    let _e2229 = core_intrinsics_minimum_number_nsz_f32_((_e2217 + _e1279), (_e2220 + _e1280));
                                                                                    let _e2230 = core_intrinsics_minimum_number_nsz_f32_(_e2229, (_e2223 + _e1281));
                                                                                    if (_e2228 > _e996) {
                                                                                        phi_2796_ = _e2228;
                                                                                    } else {
                                                                                        phi_2796_ = _e996;
                                                                                    }
                                                                                    let _e2233 = phi_2796_;
                                                                                    if (_e2230 < _e998) {
                                                                                        phi_2801_ = _e2230;
                                                                                    } else {
                                                                                        phi_2801_ = _e998;
                                                                                    }
                                                                                    let _e2236 = phi_2801_;
                                                                                    if (_e2104 < _e2233) {
                                                                                        phi_2806_ = _e2233;
                                                                                    } else {
                                                                                        phi_2806_ = _e2104;
                                                                                    }
                                                                                    let _e2239 = phi_2806_;
                                                                                    if (_e2239 > _e2236) {
                                                                                        phi_2811_ = _e2236;
                                                                                    } else {
                                                                                        phi_2811_ = _e2239;
                                                                                    }
                                                                                    let _e2242 = phi_2811_;
                                                                                    phi_2816_ = lt_bvh_triangle_Intersection(_e2242, (_e2036 / _e2095), (_e2057 / _e2095), (_e2233 <= _e2236));
                                                                                    phi_2817_ = false;
                                                                                } else {
                                                                                    phi_2816_ = lt_bvh_triangle_Intersection();
                                                                                    phi_2817_ = true;
                                                                                }
                                                                                let _e2248 = phi_2816_;
                                                                                let _e2250 = phi_2817_;
                                                                                phi_2818_ = _e2248;
                                                                                phi_2819_ = _e2250;
                                                                            } else {
                                                                                phi_2818_ = lt_bvh_triangle_Intersection();
                                                                                phi_2819_ = true;
                                                                            }
                                                                            let _e2252 = phi_2818_;
                                                                            let _e2254 = phi_2819_;
                                                                            if _e2254 {
                                                                            }
                                                                            phi_2823_ = _e2252;
                                                                            phi_2824_ = _e2254;
                                                                        }
                                                                        let _e2256 = phi_2823_;
                                                                        let _e2258 = phi_2824_;
                                                                        phi_2825_ = _e2256;
                                                                        phi_2826_ = _e2098;
                                                                        phi_2827_ = _e2258;
                                                                    } else {
                                                                        phi_2825_ = lt_bvh_triangle_Intersection();
                                                                        phi_2826_ = true;
                                                                        phi_2827_ = false;
                                                                    }
                                                                    let _e2260 = phi_2825_;
                                                                    let _e2262 = phi_2826_;
                                                                    let _e2264 = phi_2827_;
                                                                    if _e2262 {
                                                                        phi_2831_ = true;
                                                                    } else {
                                                                        phi_2831_ = _e2264;
                                                                    }
                                                                    let _e2266 = phi_2831_;
                                                                    if _e2266 {
                                                                        phi_2835_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_2835_ = _e2260;
                                                                    }
                                                                    let _e2268 = phi_2835_;
                                                                    if _e2268.is_hit {
                                                                        if (_e2268.t > 0f) {
                                                                            if (_e2268.t < _e145) {
                                                                                let _e2275 = triangles.member[(0u + _e1905)].i0_;
                                                                                let _e2277 = ((_e2275 & 2147483648u) == 0u);
                                                                                if _e2277 {
                                                                                    phi_3058_ = false;
                                                                                    phi_3059_ = false;
                                                                                } else {
                                                                                    if (_e1905 < _e80) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2284 = triangles.member[(0u + _e1905)].i0_;
                                                                                    let _e2285 = (_e2284 & 2147483647u);
                                                                                    let _e2287 = triangles.member[(0u + _e1905)].i1_;
                                                                                    let _e2289 = triangles.member[(0u + _e1905)].i2_;
                                                                                    if (_e2285 < _e95) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2293 = vertices.member[(0u + _e2285)];
                                                                                    if (_e2287 < _e95) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2297 = vertices.member[(0u + _e2287)];
                                                                                    if (_e2289 < _e95) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2301 = vertices.member[(0u + _e2289)];
                                                                                    let _e2302 = array<abi_Vertex, 3>(_e2293, _e2297, _e2301);
                                                                                    if (_e2302[0].material < arrayLength((&materials.member))) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2308 = materials.member[(0u + _e2302[0].material)];
                                                                                    if ((_e2308.flags & 1u) == 1u) {
                                                                                        let _e2313 = ((1f - _e2268.u) - _e2268.v);
                                                                                        if (_e2308.cutoff <= 0f) {
                                                                                            phi_3052_ = true;
                                                                                        } else {
                                                                                            let _e2340 = (_e2308.base_color.w * ((((f32((_e2302[0].color >> bitcast<u32>(24i))) * _e2313) + (f32((_e2302[1].color >> bitcast<u32>(24i))) * _e2268.u)) + (f32((_e2302[2].color >> bitcast<u32>(24i))) * _e2268.v)) * (1f / 255f)));
                                                                                            if (_e2308.alpha_size == 0u) {
                                                                                                phi_3049_ = _e2340;
                                                                                            } else {
                                                                                                local.offset = _e2308.alpha_offset;
                                                                                                local.size = _e2308.alpha_size;
                                                                                                local.flags = _e2308.flags;
                                                                                                let _e2371 = _lt_shaders_texture_TextureView_quad((&local), (((_e2302[0].u * _e2313) + (_e2302[1].u * _e2268.u)) + (_e2302[2].u * _e2268.v)), (((_e2302[0].v * _e2313) + (_e2302[1].v * _e2268.u)) + (_e2302[2].v * _e2268.v)));
                                                                                                let _e2375 = (_e2371.indices[0] >> bitcast<u32>(2i));
                                                                                                if (_e2375 < _e101) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2379 = alpha_texels.member[(0u + _e2375)];
                                                                                                let _e2395 = (_e2371.indices[1] >> bitcast<u32>(2i));
                                                                                                if (_e2395 < _e101) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2399 = alpha_texels.member[(0u + _e2395)];
                                                                                                let _e2416 = (_e2371.indices[2] >> bitcast<u32>(2i));
                                                                                                if (_e2416 < _e101) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2420 = alpha_texels.member[(0u + _e2416)];
                                                                                                let _e2437 = (_e2371.indices[3] >> bitcast<u32>(2i));
                                                                                                if (_e2437 < _e101) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2441 = alpha_texels.member[(0u + _e2437)];
                                                                                                phi_3049_ = (_e2340 * (((((f32(((_e2379 >> bitcast<u32>((((_e2371.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2371.weights.x) + ((f32(((_e2399 >> bitcast<u32>((((_e2371.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2371.weights.y)) + ((f32(((_e2420 >> bitcast<u32>((((_e2371.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2371.weights.z)) + ((f32(((_e2441 >> bitcast<u32>((((_e2371.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2371.weights.w)));
                                                                                            }
                                                                                            let _e2457 = phi_3049_;
                                                                                            phi_3052_ = (_e2457 >= _e2308.cutoff);
                                                                                        }
                                                                                        let _e2461 = phi_3052_;
                                                                                        phi_3053_ = _e2461;
                                                                                    } else {
                                                                                        phi_3053_ = false;
                                                                                    }
                                                                                    let _e2463 = phi_3053_;
                                                                                    if _e2463 {
                                                                                        phi_3057_ = false;
                                                                                    } else {
                                                                                        phi_3057_ = true;
                                                                                    }
                                                                                    let _e2465 = phi_3057_;
                                                                                    phi_3058_ = _e2465;
                                                                                    phi_3059_ = _e2463;
                                                                                }
                                                                                let _e2467 = phi_3058_;
                                                                                let _e2469 = phi_3059_;
                                                                                phi_3060_ = _e2467;
                                                                                phi_3061_ = _e2277;
                                                                                phi_3062_ = _e2469;
                                                                            } else {
                                                                                phi_3060_ = true;
                                                                                phi_3061_ = false;
                                                                                phi_3062_ = false;
                                                                            }
                                                                            let _e2471 = phi_3060_;
                                                                            let _e2473 = phi_3061_;
                                                                            let _e2475 = phi_3062_;
                                                                            phi_3063_ = _e2471;
                                                                            phi_3064_ = _e2473;
                                                                            phi_3065_ = _e2475;
                                                                        } else {
                                                                            phi_3063_ = true;
                                                                            phi_3064_ = false;
                                                                            phi_3065_ = false;
                                                                        }
                                                                        let _e2477 = phi_3063_;
                                                                        let _e2479 = phi_3064_;
                                                                        let _e2481 = phi_3065_;
                                                                        phi_3066_ = _e2477;
                                                                        phi_3067_ = _e2479;
                                                                        phi_3068_ = _e2481;
                                                                    } else {
                                                                        phi_3066_ = true;
                                                                        phi_3067_ = false;
                                                                        phi_3068_ = false;
                                                                    }
                                                                    let _e2483 = phi_3066_;
                                                                    let _e2485 = phi_3067_;
                                                                    let _e2487 = phi_3068_;
                                                                    if _e2483 {
                                                                        phi_3072_ = false;
                                                                        phi_3073_ = false;
                                                                    } else {
                                                                        phi_3072_ = _e2485;
                                                                        phi_3073_ = _e2487;
                                                                    }
                                                                    let _e2489 = phi_3072_;
                                                                    let _e2491 = phi_3073_;
                                                                    phi_2364_ = (_e1896 & (_e1896 - 1u));
                                                                    phi_3074_ = _e2483;
                                                                    phi_3075_ = _e2489;
                                                                    phi_3076_ = _e2491;
                                                                }
                                                                let _e2493 = phi_2364_;
                                                                let _e2495 = phi_3074_;
                                                                let _e2497 = phi_3075_;
                                                                let _e2499 = phi_3076_;
                                                                local_13 = _e2497;
                                                                local_14 = _e2499;
                                                                continue;
                                                                continuing {
                                                                    phi_2363_ = _e2493;
                                                                    break if !(_e2495);
                                                                }
                                                            }
                                                            let _e2502 = local_9;
                                                            if _e2502 {
                                                                let _e2504 = local_1.group_mask;
                                                                if ((_e2504 & 4278190080u) == 0u) {
                                                                    let _e2508 = local_1.len;
                                                                    if (_e2508 == 0u) {
                                                                        phi_3118_ = false;
                                                                    } else {
                                                                        let _e2512 = local_1.len;
                                                                        local_1.len = (_e2512 - 1u);
                                                                        let _e2515 = local_1.len;
                                                                        if (_e2515 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e2520 = local_1.first[(0u + _e2515)];
                                                                        local_1.group = _e2520;
                                                                        let _e2523 = local_1.len;
                                                                        if (_e2523 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e2528 = local_1.mask[(0u + _e2523)];
                                                                        local_1.group_mask = _e2528;
                                                                        phi_3118_ = true;
                                                                    }
                                                                    let _e2531 = phi_3118_;
                                                                    phi_3119_ = _e2531;
                                                                } else {
                                                                    phi_3119_ = true;
                                                                }
                                                                let _e2533 = phi_3119_;
                                                                if _e2533 {
                                                                    let _e2535 = local_1.group_mask;
                                                                    let _e2541 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2535)), 32u, (_e2535 == 0u)));
                                                                    let _e2545 = local_1.group_mask;
                                                                    let _e2559 = local_1.group_mask;
                                                                    local_1.group_mask = (_e2559 & ~((1u << bitcast<u32>((_e2541 & 31u)))));
                                                                    let _e2562 = local_1.group;
                                                                    phi_3150_ = (_e2562 + countOneBits(((_e2545 & ~((4294967295u << bitcast<u32>((((_e2541 - 24u) ^ _e1322) & 31u))))) & 255u)));
                                                                } else {
                                                                    phi_3150_ = 4294967295u;
                                                                }
                                                                let _e2565 = phi_3150_;
                                                                phi_3151_ = _e2565;
                                                                phi_3152_ = false;
                                                                phi_3153_ = false;
                                                            } else {
                                                                phi_3151_ = u32();
                                                                let _e2971 = local_13;
                                                                phi_3152_ = _e2971;
                                                                let _e2974 = local_14;
                                                                phi_3153_ = _e2974;
                                                            }
                                                            let _e2567 = phi_3151_;
                                                            let _e2569 = phi_3152_;
                                                            let _e2571 = phi_3153_;
                                                            phi_2034_ = _e2567;
                                                            let _e2978 = local_15;
                                                            phi_3154_ = _e2978;
                                                            phi_3155_ = false;
                                                            phi_3156_ = _e2569;
                                                            phi_3157_ = _e2571;
                                                        } else {
                                                            phi_2034_ = u32();
                                                            phi_3154_ = false;
                                                            phi_3155_ = true;
                                                            phi_3156_ = false;
                                                            phi_3157_ = false;
                                                        }
                                                        let _e2573 = phi_2034_;
                                                        let _e2575 = phi_3154_;
                                                        let _e2577 = phi_3155_;
                                                        let _e2579 = phi_3156_;
                                                        let _e2581 = phi_3157_;
                                                        local_10 = _e2577;
                                                        local_16 = _e2579;
                                                        local_17 = _e2581;
                                                        continue;
                                                        continuing {
                                                            phi_2033_ = _e2573;
                                                            break if !(_e2575);
                                                        }
                                                    }
                                                    let _e2584 = local_10;
                                                    if _e2584 {
                                                        phi_3161_ = false;
                                                        phi_3162_ = false;
                                                    } else {
                                                        let _e2985 = local_16;
                                                        phi_3161_ = _e2985;
                                                        let _e2988 = local_17;
                                                        phi_3162_ = _e2988;
                                                    }
                                                    let _e2586 = phi_3161_;
                                                    let _e2588 = phi_3162_;
                                                    if _e2586 {
                                                        phi_3166_ = true;
                                                    } else {
                                                        phi_3166_ = _e2588;
                                                    }
                                                    let _e2590 = phi_3166_;
                                                    if _e2590 {
                                                        phi_3170_ = true;
                                                    } else {
                                                        phi_3170_ = false;
                                                    }
                                                    let _e2592 = phi_3170_;
                                                    phi_3171_ = _e2592;
                                                }
                                                let _e2594 = phi_3171_;
                                                phi_3172_ = _e2594;
                                                phi_3173_ = _e1148;
                                            } else {
                                                phi_3172_ = bool();
                                                phi_3173_ = true;
                                            }
                                            let _e2596 = phi_3172_;
                                            let _e2598 = phi_3173_;
                                            if _e2598 {
                                                phi_3177_ = false;
                                            } else {
                                                phi_3177_ = _e2596;
                                            }
                                            let _e2600 = phi_3177_;
                                            if _e2600 {
                                                phi_3181_ = false;
                                            } else {
                                                phi_3181_ = true;
                                            }
                                            let _e2602 = phi_3181_;
                                            phi_3182_ = _e2602;
                                        } else {
                                            phi_3182_ = true;
                                        }
                                        let _e2604 = phi_3182_;
                                        phi_3183_ = _e2604;
                                    } else {
                                        phi_3183_ = true;
                                    }
                                    let _e2606 = phi_3183_;
                                    phi_3184_ = _e2606;
                                } else {
                                    phi_3184_ = true;
                                }
                                let _e2608 = phi_3184_;
                                if _e2608 {
                                }
                                phi_1428_ = (_e935 & (_e935 - 1u));
                                phi_3188_ = _e2608;
                            }
                            let _e2610 = phi_1428_;
                            let _e2612 = phi_3188_;
                            continue;
                            continuing {
                                phi_1427_ = _e2610;
                                break if !(_e2612);
                            }
                        }
                        let _e2615 = local_11;
                        if _e2615 {
                            let _e2617 = local_2.group_mask;
                            if ((_e2617 & 4278190080u) == 0u) {
                                let _e2621 = local_2.len;
                                if (_e2621 == 0u) {
                                    phi_3230_ = false;
                                } else {
                                    let _e2625 = local_2.len;
                                    local_2.len = (_e2625 - 1u);
                                    let _e2628 = local_2.len;
                                    if (_e2628 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e2633 = local_2.first[(0u + _e2628)];
                                    local_2.group = _e2633;
                                    let _e2636 = local_2.len;
                                    if (_e2636 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e2641 = local_2.mask[(0u + _e2636)];
                                    local_2.group_mask = _e2641;
                                    phi_3230_ = true;
                                }
                                let _e2644 = phi_3230_;
                                phi_3231_ = _e2644;
                            } else {
                                phi_3231_ = true;
                            }
                            let _e2646 = phi_3231_;
                            if _e2646 {
                                let _e2648 = local_2.group_mask;
                                let _e2654 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2648)), 32u, (_e2648 == 0u)));
                                let _e2658 = local_2.group_mask;
                                let _e2672 = local_2.group_mask;
                                local_2.group_mask = (_e2672 & ~((1u << bitcast<u32>((_e2654 & 31u)))));
                                let _e2675 = local_2.group;
                                phi_3262_ = (_e2675 + countOneBits(((_e2658 & ~((4294967295u << bitcast<u32>((((_e2654 - 24u) ^ _e361) & 31u))))) & 255u)));
                            } else {
                                phi_3262_ = 4294967295u;
                            }
                            let _e2678 = phi_3262_;
                            phi_3263_ = _e2678;
                        } else {
                            phi_3263_ = u32();
                        }
                        let _e2680 = phi_3263_;
                        phi_1098_ = _e2680;
                        let _e3009 = local_18;
                        phi_3264_ = _e3009;
                        phi_3265_ = false;
                    } else {
                        phi_1098_ = u32();
                        phi_3264_ = false;
                        phi_3265_ = true;
                    }
                    let _e2682 = phi_1098_;
                    let _e2684 = phi_3264_;
                    let _e2686 = phi_3265_;
                    local_12 = _e2686;
                    continue;
                    continuing {
                        phi_1097_ = _e2682;
                        break if !(_e2684);
                    }
                }
                let _e2689 = local_12;
                if _e2689 {
                    phi_3269_ = false;
                } else {
                    phi_3269_ = true;
                }
                let _e2691 = phi_3269_;
                if _e2691 {
                    phi_3273_ = true;
                } else {
                    phi_3273_ = false;
                }
                let _e2693 = phi_3273_;
                phi_3274_ = _e2693;
            }
            let _e2695 = phi_3274_;
            phi_3275_ = _e2695;
            phi_3276_ = _e217;
        } else {
            phi_3275_ = bool();
            phi_3276_ = true;
        }
        let _e2697 = phi_3275_;
        let _e2699 = phi_3276_;
        if _e2699 {
            phi_3280_ = false;
        } else {
            phi_3280_ = _e2697;
        }
        let _e2701 = phi_3280_;
        if _e2701 {
            phi_3284_ = 0f;
        } else {
            phi_3284_ = 1f;
        }
        let _e2703 = phi_3284_;
        if (_e114 < _e83) {
        } else {
            return;
        }
        visibility.member[(0u + _e114)] = _e2703;
        if (_e114 < _e89) {
        } else {
            return;
        }
        let _e2710 = bits.member[(0u + _e114)];
        if ((_e2710 & 2u) == 0u) {
            phi_3305_ = (_e2710 & 1u);
        } else {
            phi_3305_ = (_e2710 & 7u);
        }
        let _e2716 = phi_3305_;
        if (_e114 < _e83) {
        } else {
            return;
        }
        let _e2720 = visibility.member[(0u + _e114)];
        if ((_e2716 & 1u) != 0u) {
            phi_3320_ = (2u | 1u);
        } else {
            phi_3320_ = 2u;
        }
        let _e2726 = phi_3320_;
        if (_e2720 < 0.5f) {
            phi_3325_ = (_e2726 | 4u);
        } else {
            phi_3325_ = _e2726;
        }
        let _e2729 = phi_3325_;
        if (_e114 < _e89) {
        } else {
            return;
        }
        bits.member[(0u + _e114)] = _e2729;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_learn_instanced_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
