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

struct type_32 {
    member: array<lt_bvh_Triangle>,
}

struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
}

struct type_36 {
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

struct type_40 {
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

struct type_51 {
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

struct type_60 {
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
    light: abi_LightParams,
    test: vec4<f32>,
    size: vec2<u32>,
    map_size: u32,
    epsilon: f32,
    root: u32,
    level_count: u32,
    fade_uv: f32,
    pad0_: u32,
}

struct type_66 {
    member: abi_ShadowParams,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_17;
@group(0) @binding(0) 
var<uniform> p: type_66;
@group(0) @binding(2) 
var<storage> nodes: type_60;
@group(0) @binding(3) 
var<storage> triangles: type_32;
@group(0) @binding(5) 
var<storage> list: type_13;
@group(0) @binding(6) 
var<storage, read_write> bits: type_13;
@group(0) @binding(7) 
var<storage> instances: type_51;
@group(0) @binding(8) 
var<storage> vertices: type_36;
@group(0) @binding(9) 
var<storage> materials: type_40;
@group(0) @binding(10) 
var<storage> alpha_texels: type_13;

fn _lt_shaders_texture_TextureView_quad(param: ptr<function, texture_TextureView>, param_1: f32, param_2: f32) -> texture_TexelQuad {
    var phi_239_: f32;
    var phi_244_: f32;
    var phi_245_: bool;
    var phi_246_: f32;
    var phi_247_: bool;
    var phi_251_: f32;
    var phi_277_: f32;
    var phi_282_: f32;
    var phi_283_: bool;
    var phi_284_: f32;
    var phi_285_: bool;
    var phi_289_: f32;
    var phi_297_: f32;
    var phi_298_: f32;
    var phi_299_: f32;
    var phi_308_: f32;
    var phi_309_: f32;
    var phi_327_: u32;
    var phi_341_: u32;
    var phi_348_: u32;
    var phi_353_: u32;
    var phi_359_: u32;
    var phi_364_: u32;
    var phi_366_: texture_Axis;
    var phi_394_: f32;
    var phi_399_: f32;
    var phi_400_: bool;
    var phi_401_: f32;
    var phi_402_: bool;
    var phi_406_: f32;
    var phi_432_: f32;
    var phi_437_: f32;
    var phi_438_: bool;
    var phi_439_: f32;
    var phi_440_: bool;
    var phi_444_: f32;
    var phi_452_: f32;
    var phi_453_: f32;
    var phi_454_: f32;
    var phi_463_: f32;
    var phi_464_: f32;
    var phi_482_: u32;
    var phi_496_: u32;
    var phi_503_: u32;
    var phi_508_: u32;
    var phi_514_: u32;
    var phi_519_: u32;
    var phi_521_: texture_Axis;

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
                phi_239_ = 1f;
            } else {
                phi_239_ = 0f;
            }
            let _e101 = phi_239_;
            if (param_1 < 8388608f) {
                phi_244_ = (_e98 - _e101);
                phi_245_ = false;
            } else {
                phi_244_ = f32();
                phi_245_ = true;
            }
            let _e104 = phi_244_;
            let _e106 = phi_245_;
            phi_246_ = _e104;
            phi_247_ = _e106;
        } else {
            phi_246_ = f32();
            phi_247_ = true;
        }
        let _e108 = phi_246_;
        let _e110 = phi_247_;
        if _e110 {
            phi_251_ = param_1;
        } else {
            phi_251_ = _e108;
        }
        let _e112 = phi_251_;
        phi_299_ = (param_1 - _e112);
    } else {
        if (_e85 == 1u) {
            let _e115 = (param_1 * 0.5f);
            if (_e115 > -8388608f) {
                let _e127 = f32(select(0i, select(select(i32(_e115), i32(-2147483648), (_e115 < bitcast<f32>(3472883712u))), 2147483647i, (_e115 > bitcast<f32>(1325400063u))), (_e115 == _e115)));
                if (_e127 > _e115) {
                    phi_277_ = 1f;
                } else {
                    phi_277_ = 0f;
                }
                let _e130 = phi_277_;
                if (_e115 < 8388608f) {
                    phi_282_ = (_e127 - _e130);
                    phi_283_ = false;
                } else {
                    phi_282_ = f32();
                    phi_283_ = true;
                }
                let _e133 = phi_282_;
                let _e135 = phi_283_;
                phi_284_ = _e133;
                phi_285_ = _e135;
            } else {
                phi_284_ = f32();
                phi_285_ = true;
            }
            let _e137 = phi_284_;
            let _e139 = phi_285_;
            if _e139 {
                phi_289_ = _e115;
            } else {
                phi_289_ = _e137;
            }
            let _e141 = phi_289_;
            let _e143 = (param_1 - (2f * _e141));
            if (_e143 > 1f) {
                phi_297_ = (2f - _e143);
            } else {
                phi_297_ = _e143;
            }
            let _e147 = phi_297_;
            phi_298_ = _e147;
        } else {
            phi_298_ = param_1;
        }
        let _e149 = phi_298_;
        phi_299_ = _e149;
    }
    let _e151 = phi_299_;
    if (_e151 > 0f) {
        if (_e151 < 1f) {
            phi_308_ = _e151;
        } else {
            phi_308_ = 1f;
        }
        let _e155 = phi_308_;
        phi_309_ = _e155;
    } else {
        phi_309_ = 0f;
    }
    let _e157 = phi_309_;
    let _e158 = (_e72 - 1u);
    let _e160 = (_e157 * f32(_e72));
    if _e80 {
        let _e167 = select(select(u32(_e160), 0u, (_e160 < bitcast<f32>(0u))), 4294967295u, (_e160 > bitcast<f32>(1333788671u)));
        if (_e158 < _e167) {
            phi_327_ = _e158;
        } else {
            phi_327_ = _e167;
        }
        let _e170 = phi_327_;
        phi_366_ = texture_Axis(_e170, _e170, 0f);
    } else {
        let _e172 = (_e160 + 0.5f);
        let _e179 = select(select(u32(_e172), 0u, (_e172 < bitcast<f32>(0u))), 4294967295u, (_e172 > bitcast<f32>(1333788671u)));
        if (_e72 < _e179) {
            phi_341_ = _e72;
        } else {
            phi_341_ = _e179;
        }
        let _e182 = phi_341_;
        if (_e85 == 0u) {
            phi_348_ = _e158;
        } else {
            phi_348_ = 0u;
        }
        let _e187 = phi_348_;
        if (_e85 == 0u) {
            phi_353_ = 0u;
        } else {
            phi_353_ = _e158;
        }
        let _e190 = phi_353_;
        if (_e182 == 0u) {
            phi_359_ = _e187;
        } else {
            phi_359_ = (_e182 - 1u);
        }
        let _e194 = phi_359_;
        if (_e182 > _e158) {
            phi_364_ = _e190;
        } else {
            phi_364_ = _e182;
        }
        let _e197 = phi_364_;
        phi_366_ = texture_Axis(_e194, _e197, (_e172 - f32(_e182)));
    }
    let _e200 = phi_366_;
    let _e202 = (*param).flags;
    let _e205 = ((_e202 >> bitcast<u32>(6u)) & 3u);
    if (_e205 == 0u) {
        if (param_2 > -8388608f) {
            let _e218 = f32(select(0i, select(select(i32(param_2), i32(-2147483648), (param_2 < bitcast<f32>(3472883712u))), 2147483647i, (param_2 > bitcast<f32>(1325400063u))), (param_2 == param_2)));
            if (_e218 > param_2) {
                phi_394_ = 1f;
            } else {
                phi_394_ = 0f;
            }
            let _e221 = phi_394_;
            if (param_2 < 8388608f) {
                phi_399_ = (_e218 - _e221);
                phi_400_ = false;
            } else {
                phi_399_ = f32();
                phi_400_ = true;
            }
            let _e224 = phi_399_;
            let _e226 = phi_400_;
            phi_401_ = _e224;
            phi_402_ = _e226;
        } else {
            phi_401_ = f32();
            phi_402_ = true;
        }
        let _e228 = phi_401_;
        let _e230 = phi_402_;
        if _e230 {
            phi_406_ = param_2;
        } else {
            phi_406_ = _e228;
        }
        let _e232 = phi_406_;
        phi_454_ = (param_2 - _e232);
    } else {
        if (_e205 == 1u) {
            let _e235 = (param_2 * 0.5f);
            if (_e235 > -8388608f) {
                let _e247 = f32(select(0i, select(select(i32(_e235), i32(-2147483648), (_e235 < bitcast<f32>(3472883712u))), 2147483647i, (_e235 > bitcast<f32>(1325400063u))), (_e235 == _e235)));
                if (_e247 > _e235) {
                    phi_432_ = 1f;
                } else {
                    phi_432_ = 0f;
                }
                let _e250 = phi_432_;
                if (_e235 < 8388608f) {
                    phi_437_ = (_e247 - _e250);
                    phi_438_ = false;
                } else {
                    phi_437_ = f32();
                    phi_438_ = true;
                }
                let _e253 = phi_437_;
                let _e255 = phi_438_;
                phi_439_ = _e253;
                phi_440_ = _e255;
            } else {
                phi_439_ = f32();
                phi_440_ = true;
            }
            let _e257 = phi_439_;
            let _e259 = phi_440_;
            if _e259 {
                phi_444_ = _e235;
            } else {
                phi_444_ = _e257;
            }
            let _e261 = phi_444_;
            let _e263 = (param_2 - (2f * _e261));
            if (_e263 > 1f) {
                phi_452_ = (2f - _e263);
            } else {
                phi_452_ = _e263;
            }
            let _e267 = phi_452_;
            phi_453_ = _e267;
        } else {
            phi_453_ = param_2;
        }
        let _e269 = phi_453_;
        phi_454_ = _e269;
    }
    let _e271 = phi_454_;
    if (_e271 > 0f) {
        if (_e271 < 1f) {
            phi_463_ = _e271;
        } else {
            phi_463_ = 1f;
        }
        let _e275 = phi_463_;
        phi_464_ = _e275;
    } else {
        phi_464_ = 0f;
    }
    let _e277 = phi_464_;
    let _e278 = (_e76 - 1u);
    let _e280 = (_e277 * f32(_e76));
    if _e80 {
        let _e287 = select(select(u32(_e280), 0u, (_e280 < bitcast<f32>(0u))), 4294967295u, (_e280 > bitcast<f32>(1333788671u)));
        if (_e278 < _e287) {
            phi_482_ = _e278;
        } else {
            phi_482_ = _e287;
        }
        let _e290 = phi_482_;
        phi_521_ = texture_Axis(_e290, _e290, 0f);
    } else {
        let _e292 = (_e280 + 0.5f);
        let _e299 = select(select(u32(_e292), 0u, (_e292 < bitcast<f32>(0u))), 4294967295u, (_e292 > bitcast<f32>(1333788671u)));
        if (_e76 < _e299) {
            phi_496_ = _e76;
        } else {
            phi_496_ = _e299;
        }
        let _e302 = phi_496_;
        if (_e205 == 0u) {
            phi_503_ = _e278;
        } else {
            phi_503_ = 0u;
        }
        let _e307 = phi_503_;
        if (_e205 == 0u) {
            phi_508_ = 0u;
        } else {
            phi_508_ = _e278;
        }
        let _e310 = phi_508_;
        if (_e302 == 0u) {
            phi_514_ = _e307;
        } else {
            phi_514_ = (_e302 - 1u);
        }
        let _e314 = phi_514_;
        if (_e302 > _e278) {
            phi_519_ = _e310;
        } else {
            phi_519_ = _e302;
        }
        let _e317 = phi_519_;
        phi_521_ = texture_Axis(_e314, _e317, (_e292 - f32(_e302)));
    }
    let _e320 = phi_521_;
    let _e324 = (*param).offset;
    let _e331 = (*param).offset;
    let _e338 = (*param).offset;
    let _e345 = (*param).offset;
    return texture_TexelQuad(array<u32, 4>(((_e324 + (_e320.low * _e72)) + _e200.low), ((_e331 + (_e320.low * _e72)) + _e200.high), ((_e338 + (_e320.high * _e72)) + _e200.low), ((_e345 + (_e320.high * _e72)) + _e200.high)), vec4<f32>(((1f - _e200.fraction) * (1f - _e320.fraction)), (_e200.fraction * (1f - _e320.fraction)), ((1f - _e200.fraction) * _e320.fraction), (_e200.fraction * _e320.fraction)));
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_580_: bool;
    var phi_584_: f32;

    if (param_3 != param_3) {
        phi_580_ = true;
    } else {
        let _e70 = (param_4 >= param_3);
        if _e70 {
        }
        phi_580_ = _e70;
    }
    let _e72 = phi_580_;
    if _e72 {
        phi_584_ = param_4;
    } else {
        phi_584_ = param_3;
    }
    let _e74 = phi_584_;
    return _e74;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_596_: bool;
    var phi_600_: f32;

    if (param_5 != param_5) {
        phi_596_ = true;
    } else {
        let _e70 = (param_6 <= param_5);
        if _e70 {
        }
        phi_596_ = _e70;
    }
    let _e72 = phi_596_;
    if _e72 {
        phi_600_ = param_6;
    } else {
        phi_600_ = param_5;
    }
    let _e74 = phi_600_;
    return _e74;
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
    var phi_1180_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1207_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1234_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1240_: u32;
    var phi_1243_: u32;
    var phi_1257_: u32;
    var phi_1267_: u32;
    var phi_1277_: u32;
    var phi_1295_: u32;
    var phi_1305_: u32;
    var phi_1315_: u32;
    var phi_1351_: u32;
    var phi_1364_: u32;
    var phi_1369_: u32;
    var phi_1370_: u32;
    var phi_1371_: u32;
    var phi_1241_: u32;
    var phi_1244_: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_1429_: u32;
    var phi_1479_: f32;
    var phi_1484_: f32;
    var phi_1489_: f32;
    var phi_1497_: f32;
    var phi_1502_: f32;
    var phi_1507_: f32;
    var phi_1651_: bool;
    var phi_1652_: bool;
    var phi_1653_: bool;
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
    var phi_1673_: bool;
    var phi_1674_: bool;
    var phi_1678_: bool;
    var phi_1682_: bool;
    var phi_1752_: f32;
    var phi_1759_: f32;
    var phi_1766_: f32;
    var phi_1773_: f32;
    var phi_1780_: f32;
    var phi_1787_: f32;
    var phi_1804_: f32;
    var phi_1809_: f32;
    var phi_1814_: f32;
    var phi_1842_: bool;
    var phi_1843_: bool;
    var phi_1851_: u32;
    var phi_1852_: u32;
    var phi_1863_: vec3<f32>;
    var phi_1864_: vec3<f32>;
    var phi_1877_: u32;
    var phi_1882_: u32;
    var phi_1887_: u32;
    var phi_2001_: bool;
    var phi_2002_: bool;
    var phi_2033_: u32;
    var phi_2035_: u32;
    var phi_2116_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2143_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2170_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2176_: u32;
    var phi_2179_: u32;
    var phi_2193_: u32;
    var phi_2203_: u32;
    var phi_2213_: u32;
    var phi_2231_: u32;
    var phi_2241_: u32;
    var phi_2251_: u32;
    var phi_2287_: u32;
    var phi_2300_: u32;
    var phi_2305_: u32;
    var phi_2306_: u32;
    var phi_2307_: u32;
    var phi_2177_: u32;
    var phi_2180_: u32;
    var local_6: u32;
    var local_7: u32;
    var local_8: u32;
    var phi_2365_: u32;
    var phi_2410_: vec3<f32>;
    var phi_2411_: vec3<f32>;
    var phi_2440_: vec3<f32>;
    var phi_2441_: vec3<f32>;
    var phi_2470_: vec3<f32>;
    var phi_2471_: vec3<f32>;
    var phi_2489_: bool;
    var phi_2490_: bool;
    var phi_2494_: f32;
    var phi_2495_: f32;
    var phi_2496_: f32;
    var phi_2497_: f32;
    var phi_2505_: f32;
    var phi_2515_: bool;
    var phi_2516_: bool;
    var phi_2520_: f32;
    var phi_2521_: f32;
    var phi_2522_: f32;
    var phi_2523_: f32;
    var phi_2531_: f32;
    var phi_2541_: bool;
    var phi_2542_: bool;
    var phi_2546_: f32;
    var phi_2547_: f32;
    var phi_2548_: f32;
    var phi_2549_: f32;
    var phi_2557_: f32;
    var phi_2572_: f32;
    var phi_2573_: bool;
    var phi_2574_: f32;
    var phi_2575_: bool;
    var phi_2576_: f32;
    var phi_2577_: bool;
    var phi_2595_: f32;
    var phi_2596_: bool;
    var phi_2597_: bool;
    var phi_2598_: f32;
    var phi_2599_: bool;
    var phi_2600_: bool;
    var phi_2604_: bool;
    var phi_2605_: f32;
    var phi_2606_: bool;
    var phi_2634_: vec3<f32>;
    var phi_2635_: vec3<f32>;
    var phi_2660_: vec3<f32>;
    var phi_2661_: vec3<f32>;
    var phi_2686_: vec3<f32>;
    var phi_2687_: vec3<f32>;
    var phi_2743_: f32;
    var phi_2752_: f32;
    var phi_2761_: f32;
    var phi_2770_: f32;
    var phi_2777_: f32;
    var phi_2784_: f32;
    var phi_2797_: f32;
    var phi_2806_: f32;
    var phi_2815_: f32;
    var phi_2824_: f32;
    var phi_2831_: f32;
    var phi_2838_: f32;
    var phi_2855_: f32;
    var phi_2860_: f32;
    var phi_2865_: f32;
    var phi_2873_: f32;
    var phi_2878_: f32;
    var phi_2883_: f32;
    var phi_2895_: f32;
    var phi_2900_: f32;
    var phi_2905_: f32;
    var phi_2910_: f32;
    var phi_2915_: lt_bvh_triangle_Intersection;
    var phi_2916_: bool;
    var phi_2917_: lt_bvh_triangle_Intersection;
    var phi_2918_: bool;
    var phi_2922_: lt_bvh_triangle_Intersection;
    var phi_2923_: bool;
    var phi_2924_: lt_bvh_triangle_Intersection;
    var phi_2925_: bool;
    var phi_2926_: bool;
    var phi_2930_: bool;
    var phi_2934_: lt_bvh_triangle_Intersection;
    var phi_3148_: f32;
    var phi_3151_: bool;
    var phi_3152_: bool;
    var phi_3156_: bool;
    var phi_3157_: bool;
    var phi_3158_: bool;
    var phi_3159_: bool;
    var phi_3160_: bool;
    var phi_3161_: bool;
    var phi_3162_: bool;
    var phi_3163_: bool;
    var phi_3164_: bool;
    var phi_3165_: bool;
    var phi_3166_: bool;
    var phi_3167_: bool;
    var phi_3171_: bool;
    var phi_3172_: bool;
    var phi_2366_: u32;
    var phi_3173_: bool;
    var phi_3174_: bool;
    var phi_3175_: bool;
    var local_9: bool;
    var phi_3217_: bool;
    var phi_3218_: bool;
    var phi_3249_: u32;
    var phi_3250_: u32;
    var phi_3251_: bool;
    var phi_3252_: bool;
    var phi_2036_: u32;
    var phi_3253_: bool;
    var phi_3254_: bool;
    var phi_3255_: bool;
    var phi_3256_: bool;
    var local_10: bool;
    var phi_3260_: bool;
    var phi_3261_: bool;
    var phi_3265_: bool;
    var phi_3269_: bool;
    var phi_3270_: bool;
    var phi_3271_: bool;
    var phi_3272_: bool;
    var phi_3276_: bool;
    var phi_3280_: bool;
    var phi_3281_: bool;
    var phi_3282_: bool;
    var phi_3283_: bool;
    var phi_1430_: u32;
    var phi_3287_: bool;
    var local_11: bool;
    var phi_3329_: bool;
    var phi_3330_: bool;
    var phi_3361_: u32;
    var phi_3362_: u32;
    var phi_1100_: u32;
    var phi_3363_: bool;
    var phi_3364_: bool;
    var local_12: bool;
    var phi_3368_: bool;
    var phi_3372_: bool;
    var phi_3373_: bool;
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
                phi_3373_ = bool();
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
                loop {
                    let _e500 = phi_1099_;
                    if (_e500 != 4294967295u) {
                        if (_e500 < _e77) {
                        } else {
                            return;
                        }
                        let _e507 = nodes.member[(0u + _e500)].frame[3u];
                        let _e532 = (bitcast<f32>((((_e507 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e294);
                        let _e533 = (bitcast<f32>((((_e507 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e304);
                        let _e534 = (bitcast<f32>((((_e507 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e314);
                        let _e537 = nodes.member[(0u + _e500)].frame[0u];
                        let _e541 = nodes.member[(0u + _e500)].frame[1u];
                        let _e545 = nodes.member[(0u + _e500)].frame[2u];
                        let _e550 = ((bitcast<f32>(_e537) - _e136) * _e294);
                        let _e551 = ((bitcast<f32>(_e541) - _e138) * _e304);
                        let _e552 = ((bitcast<f32>(_e545) - _e140) * _e314);
                        let _e560 = nodes.member[(0u + _e500)].x;
                        if (_e294 < 0f) {
                            let _e571 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e560.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e577 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e571.unnamed.root, _e560.w), _e571.unnamed_1);
                            let _e583 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e577.unnamed, lt_bvh_traverse_Tree(_e560.x, _e577.unnamed_1.first_primitive));
                            phi_1180_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e583.unnamed, lt_bvh_traverse_Tree(_e583.unnamed_1.root, _e560.y));
                        } else {
                            let _e599 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e560.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e605 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e599.unnamed.root, _e560.y), _e599.unnamed_1);
                            let _e611 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e605.unnamed, lt_bvh_traverse_Tree(_e560.z, _e605.unnamed_1.first_primitive));
                            phi_1180_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e611.unnamed, lt_bvh_traverse_Tree(_e611.unnamed_1.root, _e560.w));
                        }
                        let _e619 = phi_1180_;
                        let _e629 = nodes.member[(0u + _e500)].y;
                        if (_e304 < 0f) {
                            let _e640 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e629.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e646 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e640.unnamed.root, _e629.w), _e640.unnamed_1);
                            let _e652 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e646.unnamed, lt_bvh_traverse_Tree(_e629.x, _e646.unnamed_1.first_primitive));
                            phi_1207_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e652.unnamed, lt_bvh_traverse_Tree(_e652.unnamed_1.root, _e629.y));
                        } else {
                            let _e668 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e629.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e674 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e668.unnamed.root, _e629.y), _e668.unnamed_1);
                            let _e680 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e674.unnamed, lt_bvh_traverse_Tree(_e629.z, _e674.unnamed_1.first_primitive));
                            phi_1207_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e680.unnamed, lt_bvh_traverse_Tree(_e680.unnamed_1.root, _e629.w));
                        }
                        let _e688 = phi_1207_;
                        let _e698 = nodes.member[(0u + _e500)].z;
                        if (_e314 < 0f) {
                            let _e709 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e698.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e715 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e709.unnamed.root, _e698.w), _e709.unnamed_1);
                            let _e721 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e715.unnamed, lt_bvh_traverse_Tree(_e698.x, _e715.unnamed_1.first_primitive));
                            phi_1234_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e721.unnamed, lt_bvh_traverse_Tree(_e721.unnamed_1.root, _e698.y));
                        } else {
                            let _e737 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e698.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e743 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e737.unnamed.root, _e698.y), _e737.unnamed_1);
                            let _e749 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e743.unnamed, lt_bvh_traverse_Tree(_e698.z, _e743.unnamed_1.first_primitive));
                            phi_1234_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e749.unnamed, lt_bvh_traverse_Tree(_e749.unnamed_1.root, _e698.w));
                        }
                        let _e757 = phi_1234_;
                        phi_1240_ = 0u;
                        phi_1243_ = 0u;
                        loop {
                            let _e767 = phi_1240_;
                            let _e769 = phi_1243_;
                            local_3 = _e769;
                            local_4 = _e769;
                            local_5 = _e769;
                            let _e770 = (_e767 < 8u);
                            if _e770 {
                                let _e772 = (_e767 >> bitcast<u32>(2i));
                                let _e773 = (_e767 & 3u);
                                if (_e772 == 0u) {
                                    phi_1257_ = _e619.unnamed.root;
                                } else {
                                    phi_1257_ = _e619.unnamed.first_primitive;
                                }
                                let _e776 = phi_1257_;
                                if (_e772 == 0u) {
                                    phi_1267_ = _e688.unnamed.root;
                                } else {
                                    phi_1267_ = _e688.unnamed.first_primitive;
                                }
                                let _e785 = phi_1267_;
                                if (_e772 == 0u) {
                                    phi_1277_ = _e757.unnamed.root;
                                } else {
                                    phi_1277_ = _e757.unnamed.first_primitive;
                                }
                                let _e794 = phi_1277_;
                                let _e807 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e776 >> bitcast<u32>(((_e773 * 8u) & 31u))) & 255u)) * _e532) + (_e550 - _e342)), ((f32(((_e785 >> bitcast<u32>(((_e773 * 8u) & 31u))) & 255u)) * _e533) + (_e551 - _e343)));
                                let _e808 = core_intrinsics_maximum_number_nsz_f32_(_e807, ((f32(((_e794 >> bitcast<u32>(((_e773 * 8u) & 31u))) & 255u)) * _e534) + (_e552 - _e344)));
                                if (_e772 == 0u) {
                                    phi_1295_ = _e619.unnamed_1.root;
                                } else {
                                    phi_1295_ = _e619.unnamed_1.first_primitive;
                                }
                                let _e811 = phi_1295_;
                                if (_e772 == 0u) {
                                    phi_1305_ = _e688.unnamed_1.root;
                                } else {
                                    phi_1305_ = _e688.unnamed_1.first_primitive;
                                }
                                let _e820 = phi_1305_;
                                if (_e772 == 0u) {
                                    phi_1315_ = _e757.unnamed_1.root;
                                } else {
                                    phi_1315_ = _e757.unnamed_1.first_primitive;
                                }
                                let _e829 = phi_1315_;
                                let _e842 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e811 >> bitcast<u32>(((_e773 * 8u) & 31u))) & 255u)) * _e532) + (_e550 + _e342)), ((f32(((_e820 >> bitcast<u32>(((_e773 * 8u) & 31u))) & 255u)) * _e533) + (_e551 + _e343)));
                                let _e843 = core_intrinsics_minimum_number_nsz_f32_(_e842, ((f32(((_e829 >> bitcast<u32>(((_e773 * 8u) & 31u))) & 255u)) * _e534) + (_e552 + _e344)));
                                if (_e808 <= _e843) {
                                    if (_e808 <= _e146) {
                                        if (_e843 >= 0f) {
                                            if (_e772 == 0u) {
                                                let _e850 = nodes.member[(0u + _e500)].links[2u];
                                                phi_1351_ = _e850;
                                            } else {
                                                let _e853 = nodes.member[(0u + _e500)].links[3u];
                                                phi_1351_ = _e853;
                                            }
                                            let _e855 = phi_1351_;
                                            let _e860 = ((_e855 >> bitcast<u32>(((_e773 * 8u) & 31u))) & 255u);
                                            let _e861 = (_e860 & 31u);
                                            if (_e861 >= 24u) {
                                                phi_1364_ = (24u + ((_e861 - 24u) ^ _e362));
                                            } else {
                                                phi_1364_ = _e861;
                                            }
                                            let _e867 = phi_1364_;
                                            phi_1369_ = (_e769 | ((_e860 >> bitcast<u32>(5i)) << bitcast<u32>((_e867 & 31u))));
                                        } else {
                                            phi_1369_ = _e769;
                                        }
                                        let _e875 = phi_1369_;
                                        phi_1370_ = _e875;
                                    } else {
                                        phi_1370_ = _e769;
                                    }
                                    let _e877 = phi_1370_;
                                    phi_1371_ = _e877;
                                } else {
                                    phi_1371_ = _e769;
                                }
                                let _e879 = phi_1371_;
                                phi_1241_ = (_e767 + 1u);
                                phi_1244_ = _e879;
                            } else {
                                phi_1241_ = u32();
                                phi_1244_ = u32();
                            }
                            let _e882 = phi_1241_;
                            let _e884 = phi_1244_;
                            continue;
                            continuing {
                                phi_1240_ = _e882;
                                phi_1243_ = _e884;
                                break if !(_e770);
                            }
                        }
                        let _e888 = nodes.member[(0u + _e500)].links[0u];
                        let _e892 = nodes.member[(0u + _e500)].frame[3u];
                        let _e896 = local_3;
                        if ((_e896 & 4278190080u) == 0u) {
                        } else {
                            let _e900 = local_2.group_mask;
                            if ((_e900 & 4278190080u) == 0u) {
                            } else {
                                let _e904 = local_2.len;
                                if (_e904 < 32u) {
                                    let _e907 = local_2.group;
                                    let _e909 = local_2.len;
                                    if (_e909 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.first[(0u + _e909)] = _e907;
                                    let _e915 = local_2.group_mask;
                                    let _e917 = local_2.len;
                                    if (_e917 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.mask[(0u + _e917)] = _e915;
                                    let _e924 = local_2.len;
                                    local_2.len = (_e924 + 1u);
                                }
                            }
                            local_2.group = (_e116 + _e888);
                            let _e928 = local_4;
                            local_2.group_mask = ((_e928 & 4278190080u) | (_e892 >> bitcast<u32>(24i)));
                        }
                        let _e933 = local_5;
                        phi_1429_ = (_e933 & 16777215u);
                        loop {
                            let _e936 = phi_1429_;
                            let _e937 = (_e936 == 0u);
                            local_11 = _e937;
                            local_18 = _e937;
                            if _e937 {
                                phi_1430_ = u32();
                                phi_3287_ = false;
                            } else {
                                let _e940 = nodes.member[(0u + _e500)].links[1u];
                                let _e944 = (_e940 + select(firstTrailingBit(_e936), 32u, (_e936 == 0u)));
                                if (_e944 < arrayLength((&instances.member))) {
                                } else {
                                    return;
                                }
                                let _e951 = instances.member[(0u + _e944)].low_world;
                                let _e953 = instances.member[(0u + _e944)].high_world;
                                let _e960 = ((_e951.x - _e136) * _e294);
                                let _e961 = ((_e951.y - _e138) * _e304);
                                let _e962 = ((_e951.z - _e140) * _e314);
                                let _e969 = ((_e953.x - _e136) * _e294);
                                let _e970 = ((_e953.y - _e138) * _e304);
                                let _e971 = ((_e953.z - _e140) * _e314);
                                if (_e960 < _e969) {
                                    phi_1479_ = _e960;
                                } else {
                                    phi_1479_ = _e969;
                                }
                                let _e974 = phi_1479_;
                                if (_e961 < _e970) {
                                    phi_1484_ = _e961;
                                } else {
                                    phi_1484_ = _e970;
                                }
                                let _e977 = phi_1484_;
                                if (_e962 < _e971) {
                                    phi_1489_ = _e962;
                                } else {
                                    phi_1489_ = _e971;
                                }
                                let _e980 = phi_1489_;
                                if (_e960 > _e969) {
                                    phi_1497_ = _e960;
                                } else {
                                    phi_1497_ = _e969;
                                }
                                let _e986 = phi_1497_;
                                if (_e961 > _e970) {
                                    phi_1502_ = _e961;
                                } else {
                                    phi_1502_ = _e970;
                                }
                                let _e989 = phi_1502_;
                                if (_e962 > _e971) {
                                    phi_1507_ = _e962;
                                } else {
                                    phi_1507_ = _e971;
                                }
                                let _e992 = phi_1507_;
                                let _e996 = core_intrinsics_maximum_number_nsz_f32_((_e974 - _e349), (_e977 - _e350));
                                let _e997 = core_intrinsics_maximum_number_nsz_f32_(_e996, (_e980 - _e351));
                                let _e998 = core_intrinsics_minimum_number_nsz_f32_((_e986 + _e349), (_e989 + _e350));
                                let _e999 = core_intrinsics_minimum_number_nsz_f32_(_e998, (_e992 + _e351));
                                if (_e997 <= _e999) {
                                    if (_e997 <= _e146) {
                                        if (_e999 >= 0f) {
                                            let _e1005 = instances.member[(0u + _e944)].world_to_object[0u];
                                            let _e1016 = ((((_e1005.x * _e136) + (_e1005.y * _e138)) + (_e1005.z * _e140)) + (_e1005.w * 1f));
                                            let _e1018 = instances.member[(0u + _e944)].world_to_object[1u];
                                            let _e1029 = ((((_e1018.x * _e136) + (_e1018.y * _e138)) + (_e1018.z * _e140)) + (_e1018.w * 1f));
                                            let _e1031 = instances.member[(0u + _e944)].world_to_object[2u];
                                            let _e1042 = ((((_e1031.x * _e136) + (_e1031.y * _e138)) + (_e1031.z * _e140)) + (_e1031.w * 1f));
                                            let _e1045 = instances.member[(0u + _e944)].world_to_object[0u];
                                            let _e1056 = ((((_e1045.x * _e154) + (_e1045.y * _e155)) + (_e1045.z * _e156)) + (_e1045.w * 0f));
                                            let _e1058 = instances.member[(0u + _e944)].world_to_object[1u];
                                            let _e1069 = ((((_e1058.x * _e154) + (_e1058.y * _e155)) + (_e1058.z * _e156)) + (_e1058.w * 0f));
                                            let _e1071 = instances.member[(0u + _e944)].world_to_object[2u];
                                            let _e1082 = ((((_e1071.x * _e154) + (_e1071.y * _e155)) + (_e1071.z * _e156)) + (_e1071.w * 0f));
                                            let _e1085 = instances.member[(0u + _e944)].root;
                                            let _e1087 = instances.member[(0u + _e944)].first_triangle;
                                            let _e1091 = abs(_e1056);
                                            let _e1092 = abs(_e1069);
                                            let _e1093 = abs(_e1082);
                                            if (abs(_e1016) < 1000000000000000f) {
                                                if (abs(_e1029) < 1000000000000000f) {
                                                    if (abs(_e1042) < 1000000000000000f) {
                                                        if (_e1091 < 1000000000000000f) {
                                                            if (_e1092 < 1000000000000000f) {
                                                                if (_e1093 < 1000000000000000f) {
                                                                    if (_e1091 > 0f) {
                                                                        phi_1652_ = bool();
                                                                        phi_1653_ = true;
                                                                    } else {
                                                                        let _e1101 = (_e1092 > 0f);
                                                                        if _e1101 {
                                                                            phi_1651_ = bool();
                                                                        } else {
                                                                            phi_1651_ = (_e1093 > 0f);
                                                                        }
                                                                        let _e1104 = phi_1651_;
                                                                        phi_1652_ = _e1104;
                                                                        phi_1653_ = _e1101;
                                                                    }
                                                                    let _e1106 = phi_1652_;
                                                                    let _e1108 = phi_1653_;
                                                                    if _e1108 {
                                                                        phi_1657_ = true;
                                                                    } else {
                                                                        phi_1657_ = _e1106;
                                                                    }
                                                                    let _e1110 = phi_1657_;
                                                                    phi_1658_ = _e1110;
                                                                    phi_1659_ = false;
                                                                } else {
                                                                    phi_1658_ = bool();
                                                                    phi_1659_ = true;
                                                                }
                                                                let _e1112 = phi_1658_;
                                                                let _e1114 = phi_1659_;
                                                                phi_1660_ = _e1112;
                                                                phi_1661_ = false;
                                                                phi_1662_ = _e1114;
                                                            } else {
                                                                phi_1660_ = bool();
                                                                phi_1661_ = true;
                                                                phi_1662_ = false;
                                                            }
                                                            let _e1116 = phi_1660_;
                                                            let _e1118 = phi_1661_;
                                                            let _e1120 = phi_1662_;
                                                            phi_1663_ = _e1116;
                                                            phi_1664_ = _e1118;
                                                            phi_1665_ = _e1120;
                                                        } else {
                                                            phi_1663_ = bool();
                                                            phi_1664_ = true;
                                                            phi_1665_ = false;
                                                        }
                                                        let _e1122 = phi_1663_;
                                                        let _e1124 = phi_1664_;
                                                        let _e1126 = phi_1665_;
                                                        phi_1666_ = _e1122;
                                                        phi_1667_ = _e1124;
                                                        phi_1668_ = _e1126;
                                                    } else {
                                                        phi_1666_ = bool();
                                                        phi_1667_ = true;
                                                        phi_1668_ = false;
                                                    }
                                                    let _e1128 = phi_1666_;
                                                    let _e1130 = phi_1667_;
                                                    let _e1132 = phi_1668_;
                                                    phi_1669_ = _e1128;
                                                    phi_1670_ = _e1130;
                                                    phi_1671_ = _e1132;
                                                } else {
                                                    phi_1669_ = bool();
                                                    phi_1670_ = true;
                                                    phi_1671_ = false;
                                                }
                                                let _e1134 = phi_1669_;
                                                let _e1136 = phi_1670_;
                                                let _e1138 = phi_1671_;
                                                phi_1672_ = _e1134;
                                                phi_1673_ = _e1136;
                                                phi_1674_ = _e1138;
                                            } else {
                                                phi_1672_ = bool();
                                                phi_1673_ = true;
                                                phi_1674_ = false;
                                            }
                                            let _e1140 = phi_1672_;
                                            let _e1142 = phi_1673_;
                                            let _e1144 = phi_1674_;
                                            if _e1142 {
                                                phi_1678_ = true;
                                            } else {
                                                phi_1678_ = _e1144;
                                            }
                                            let _e1146 = phi_1678_;
                                            if _e1146 {
                                                phi_1682_ = false;
                                            } else {
                                                phi_1682_ = _e1140;
                                            }
                                            let _e1148 = phi_1682_;
                                            if _e1148 {
                                                let _e1149 = (_e1085 >= _e77);
                                                if _e1149 {
                                                    phi_3270_ = bool();
                                                } else {
                                                    if (_e1085 < _e77) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1155 = nodes.member[(0u + _e1085)].frame[0u];
                                                    let _e1159 = nodes.member[(0u + _e1085)].frame[1u];
                                                    let _e1163 = nodes.member[(0u + _e1085)].frame[2u];
                                                    let _e1167 = nodes.member[(0u + _e1085)].frame[0u];
                                                    let _e1171 = nodes.member[(0u + _e1085)].frame[1u];
                                                    let _e1175 = nodes.member[(0u + _e1085)].frame[2u];
                                                    let _e1179 = nodes.member[(0u + _e1085)].frame[3u];
                                                    let _e1213 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1056), abs(_e1069));
                                                    let _e1214 = core_intrinsics_maximum_number_nsz_f32_(_e1213, abs(_e1082));
                                                    let _e1215 = (_e1214 * 0.0000000000009094947f);
                                                    if (abs(_e1056) < _e1215) {
                                                        phi_1752_ = _e1215;
                                                    } else {
                                                        phi_1752_ = abs(_e1056);
                                                    }
                                                    let _e1220 = phi_1752_;
                                                    if (_e1056 < 0f) {
                                                        phi_1759_ = (-1f / _e1220);
                                                    } else {
                                                        phi_1759_ = (1f / _e1220);
                                                    }
                                                    let _e1225 = phi_1759_;
                                                    if (abs(_e1069) < _e1215) {
                                                        phi_1766_ = _e1215;
                                                    } else {
                                                        phi_1766_ = abs(_e1069);
                                                    }
                                                    let _e1230 = phi_1766_;
                                                    if (_e1069 < 0f) {
                                                        phi_1773_ = (-1f / _e1230);
                                                    } else {
                                                        phi_1773_ = (1f / _e1230);
                                                    }
                                                    let _e1235 = phi_1773_;
                                                    if (abs(_e1082) < _e1215) {
                                                        phi_1780_ = _e1215;
                                                    } else {
                                                        phi_1780_ = abs(_e1082);
                                                    }
                                                    let _e1240 = phi_1780_;
                                                    if (_e1082 < 0f) {
                                                        phi_1787_ = (-1f / _e1240);
                                                    } else {
                                                        phi_1787_ = (1f / _e1240);
                                                    }
                                                    let _e1245 = phi_1787_;
                                                    let _e1249 = abs((bitcast<f32>(_e1155) - _e1016));
                                                    let _e1250 = abs((bitcast<f32>(_e1159) - _e1029));
                                                    let _e1251 = abs((bitcast<f32>(_e1163) - _e1042));
                                                    let _e1255 = abs(((bitcast<f32>(_e1167) + (bitcast<f32>((((_e1179 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1016));
                                                    let _e1256 = abs(((bitcast<f32>(_e1171) + (bitcast<f32>((((_e1179 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1029));
                                                    let _e1257 = abs(((bitcast<f32>(_e1175) + (bitcast<f32>((((_e1179 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1042));
                                                    if (_e1249 > _e1255) {
                                                        phi_1804_ = _e1249;
                                                    } else {
                                                        phi_1804_ = _e1255;
                                                    }
                                                    let _e1260 = phi_1804_;
                                                    if (_e1250 > _e1256) {
                                                        phi_1809_ = _e1250;
                                                    } else {
                                                        phi_1809_ = _e1256;
                                                    }
                                                    let _e1263 = phi_1809_;
                                                    if (_e1251 > _e1257) {
                                                        phi_1814_ = _e1251;
                                                    } else {
                                                        phi_1814_ = _e1257;
                                                    }
                                                    let _e1266 = phi_1814_;
                                                    let _e1267 = core_intrinsics_maximum_number_nsz_f32_(_e1260, _e1263);
                                                    let _e1268 = core_intrinsics_maximum_number_nsz_f32_(_e1267, _e1266);
                                                    let _e1272 = (_e1268 * 0.0000019073486f);
                                                    let _e1273 = (abs(_e1225) * _e1272);
                                                    let _e1274 = (abs(_e1235) * _e1272);
                                                    let _e1275 = (abs(_e1245) * _e1272);
                                                    let _e1279 = (_e1268 * 0.0000009536743f);
                                                    let _e1280 = (abs(_e1225) * _e1279);
                                                    let _e1281 = (abs(_e1235) * _e1279);
                                                    let _e1282 = (abs(_e1245) * _e1279);
                                                    let _e1283 = abs(_e1056);
                                                    let _e1284 = abs(_e1069);
                                                    let _e1285 = abs(_e1082);
                                                    if (_e1283 >= _e1284) {
                                                        if (_e1283 >= _e1285) {
                                                            phi_1842_ = false;
                                                        } else {
                                                            phi_1842_ = true;
                                                        }
                                                        let _e1289 = phi_1842_;
                                                        phi_1843_ = _e1289;
                                                    } else {
                                                        phi_1843_ = true;
                                                    }
                                                    let _e1291 = phi_1843_;
                                                    if _e1291 {
                                                        if (_e1284 >= _e1285) {
                                                            phi_1851_ = 1u;
                                                        } else {
                                                            phi_1851_ = 2u;
                                                        }
                                                        let _e1294 = phi_1851_;
                                                        phi_1852_ = _e1294;
                                                    } else {
                                                        phi_1852_ = 0u;
                                                    }
                                                    let _e1296 = phi_1852_;
                                                    if (_e1296 == 0u) {
                                                        phi_1864_ = vec3<f32>(_e1069, _e1082, _e1056);
                                                    } else {
                                                        if (_e1296 == 1u) {
                                                            phi_1863_ = vec3<f32>(_e1082, _e1056, _e1069);
                                                        } else {
                                                            phi_1863_ = vec3<f32>(_e1056, _e1069, _e1082);
                                                        }
                                                        let _e1302 = phi_1863_;
                                                        phi_1864_ = _e1302;
                                                    }
                                                    let _e1304 = phi_1864_;
                                                    let _e1307 = (_e1304.x / _e1304.z);
                                                    let _e1310 = (_e1304.y / _e1304.z);
                                                    if (_e1225 < 0f) {
                                                        phi_1877_ = 0u;
                                                    } else {
                                                        phi_1877_ = 1u;
                                                    }
                                                    let _e1315 = phi_1877_;
                                                    if (_e1235 < 0f) {
                                                        phi_1882_ = 0u;
                                                    } else {
                                                        phi_1882_ = 2u;
                                                    }
                                                    let _e1318 = phi_1882_;
                                                    if (_e1245 < 0f) {
                                                        phi_1887_ = 0u;
                                                    } else {
                                                        phi_1887_ = 4u;
                                                    }
                                                    let _e1321 = phi_1887_;
                                                    let _e1323 = ((_e1315 | _e1318) | _e1321);
                                                    let _e1324 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1085, 2147483648u);
                                                    local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e1324.first[0], _e1324.first[1], _e1324.first[2], _e1324.first[3], _e1324.first[4], _e1324.first[5], _e1324.first[6], _e1324.first[7], _e1324.first[8], _e1324.first[9], _e1324.first[10], _e1324.first[11], _e1324.first[12], _e1324.first[13], _e1324.first[14], _e1324.first[15], _e1324.first[16], _e1324.first[17], _e1324.first[18], _e1324.first[19], _e1324.first[20], _e1324.first[21], _e1324.first[22], _e1324.first[23], _e1324.first[24], _e1324.first[25], _e1324.first[26], _e1324.first[27], _e1324.first[28], _e1324.first[29], _e1324.first[30], _e1324.first[31]), array<u32, 32>(_e1324.mask[0], _e1324.mask[1], _e1324.mask[2], _e1324.mask[3], _e1324.mask[4], _e1324.mask[5], _e1324.mask[6], _e1324.mask[7], _e1324.mask[8], _e1324.mask[9], _e1324.mask[10], _e1324.mask[11], _e1324.mask[12], _e1324.mask[13], _e1324.mask[14], _e1324.mask[15], _e1324.mask[16], _e1324.mask[17], _e1324.mask[18], _e1324.mask[19], _e1324.mask[20], _e1324.mask[21], _e1324.mask[22], _e1324.mask[23], _e1324.mask[24], _e1324.mask[25], _e1324.mask[26], _e1324.mask[27], _e1324.mask[28], _e1324.mask[29], _e1324.mask[30], _e1324.mask[31]), _e1324.len, _e1324.group, _e1324.group_mask);
                                                    let _e1398 = local_1.group_mask;
                                                    if ((_e1398 & 4278190080u) == 0u) {
                                                        let _e1402 = local_1.len;
                                                        if (_e1402 == 0u) {
                                                            phi_2001_ = false;
                                                        } else {
                                                            let _e1406 = local_1.len;
                                                            local_1.len = (_e1406 - 1u);
                                                            let _e1409 = local_1.len;
                                                            if (_e1409 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1414 = local_1.first[(0u + _e1409)];
                                                            local_1.group = _e1414;
                                                            let _e1417 = local_1.len;
                                                            if (_e1417 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1422 = local_1.mask[(0u + _e1417)];
                                                            local_1.group_mask = _e1422;
                                                            phi_2001_ = true;
                                                        }
                                                        let _e1425 = phi_2001_;
                                                        phi_2002_ = _e1425;
                                                    } else {
                                                        phi_2002_ = true;
                                                    }
                                                    let _e1427 = phi_2002_;
                                                    if _e1427 {
                                                        let _e1429 = local_1.group_mask;
                                                        let _e1435 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1429)), 32u, (_e1429 == 0u)));
                                                        let _e1439 = local_1.group_mask;
                                                        let _e1453 = local_1.group_mask;
                                                        local_1.group_mask = (_e1453 & ~((1u << bitcast<u32>((_e1435 & 31u)))));
                                                        let _e1456 = local_1.group;
                                                        phi_2033_ = (_e1456 + countOneBits(((_e1439 & ~((4294967295u << bitcast<u32>((((_e1435 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_2033_ = 4294967295u;
                                                    }
                                                    let _e1459 = phi_2033_;
                                                    phi_2035_ = _e1459;
                                                    loop {
                                                        let _e1461 = phi_2035_;
                                                        if (_e1461 != 4294967295u) {
                                                            if (_e1461 < _e77) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1468 = nodes.member[(0u + _e1461)].frame[3u];
                                                            let _e1493 = (bitcast<f32>((((_e1468 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1225);
                                                            let _e1494 = (bitcast<f32>((((_e1468 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1235);
                                                            let _e1495 = (bitcast<f32>((((_e1468 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1245);
                                                            let _e1498 = nodes.member[(0u + _e1461)].frame[0u];
                                                            let _e1502 = nodes.member[(0u + _e1461)].frame[1u];
                                                            let _e1506 = nodes.member[(0u + _e1461)].frame[2u];
                                                            let _e1511 = ((bitcast<f32>(_e1498) - _e1016) * _e1225);
                                                            let _e1512 = ((bitcast<f32>(_e1502) - _e1029) * _e1235);
                                                            let _e1513 = ((bitcast<f32>(_e1506) - _e1042) * _e1245);
                                                            let _e1521 = nodes.member[(0u + _e1461)].x;
                                                            if (_e1225 < 0f) {
                                                                let _e1532 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1521.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1538 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1532.unnamed.root, _e1521.w), _e1532.unnamed_1);
                                                                let _e1544 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1538.unnamed, lt_bvh_traverse_Tree(_e1521.x, _e1538.unnamed_1.first_primitive));
                                                                phi_2116_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1544.unnamed, lt_bvh_traverse_Tree(_e1544.unnamed_1.root, _e1521.y));
                                                            } else {
                                                                let _e1560 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1521.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1566 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1560.unnamed.root, _e1521.y), _e1560.unnamed_1);
                                                                let _e1572 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1566.unnamed, lt_bvh_traverse_Tree(_e1521.z, _e1566.unnamed_1.first_primitive));
                                                                phi_2116_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1572.unnamed, lt_bvh_traverse_Tree(_e1572.unnamed_1.root, _e1521.w));
                                                            }
                                                            let _e1580 = phi_2116_;
                                                            let _e1590 = nodes.member[(0u + _e1461)].y;
                                                            if (_e1235 < 0f) {
                                                                let _e1601 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1590.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1607 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1601.unnamed.root, _e1590.w), _e1601.unnamed_1);
                                                                let _e1613 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1607.unnamed, lt_bvh_traverse_Tree(_e1590.x, _e1607.unnamed_1.first_primitive));
                                                                phi_2143_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1613.unnamed, lt_bvh_traverse_Tree(_e1613.unnamed_1.root, _e1590.y));
                                                            } else {
                                                                let _e1629 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1590.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1635 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1629.unnamed.root, _e1590.y), _e1629.unnamed_1);
                                                                let _e1641 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1635.unnamed, lt_bvh_traverse_Tree(_e1590.z, _e1635.unnamed_1.first_primitive));
                                                                phi_2143_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1641.unnamed, lt_bvh_traverse_Tree(_e1641.unnamed_1.root, _e1590.w));
                                                            }
                                                            let _e1649 = phi_2143_;
                                                            let _e1659 = nodes.member[(0u + _e1461)].z;
                                                            if (_e1245 < 0f) {
                                                                let _e1670 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1659.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1676 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1670.unnamed.root, _e1659.w), _e1670.unnamed_1);
                                                                let _e1682 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1676.unnamed, lt_bvh_traverse_Tree(_e1659.x, _e1676.unnamed_1.first_primitive));
                                                                phi_2170_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1682.unnamed, lt_bvh_traverse_Tree(_e1682.unnamed_1.root, _e1659.y));
                                                            } else {
                                                                let _e1698 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1659.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1704 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1698.unnamed.root, _e1659.y), _e1698.unnamed_1);
                                                                let _e1710 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1704.unnamed, lt_bvh_traverse_Tree(_e1659.z, _e1704.unnamed_1.first_primitive));
                                                                phi_2170_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1710.unnamed, lt_bvh_traverse_Tree(_e1710.unnamed_1.root, _e1659.w));
                                                            }
                                                            let _e1718 = phi_2170_;
                                                            phi_2176_ = 0u;
                                                            phi_2179_ = 0u;
                                                            loop {
                                                                let _e1728 = phi_2176_;
                                                                let _e1730 = phi_2179_;
                                                                local_6 = _e1730;
                                                                local_7 = _e1730;
                                                                local_8 = _e1730;
                                                                let _e1731 = (_e1728 < 8u);
                                                                if _e1731 {
                                                                    let _e1733 = (_e1728 >> bitcast<u32>(2i));
                                                                    let _e1734 = (_e1728 & 3u);
                                                                    if (_e1733 == 0u) {
                                                                        phi_2193_ = _e1580.unnamed.root;
                                                                    } else {
                                                                        phi_2193_ = _e1580.unnamed.first_primitive;
                                                                    }
                                                                    let _e1737 = phi_2193_;
                                                                    if (_e1733 == 0u) {
                                                                        phi_2203_ = _e1649.unnamed.root;
                                                                    } else {
                                                                        phi_2203_ = _e1649.unnamed.first_primitive;
                                                                    }
                                                                    let _e1746 = phi_2203_;
                                                                    if (_e1733 == 0u) {
                                                                        phi_2213_ = _e1718.unnamed.root;
                                                                    } else {
                                                                        phi_2213_ = _e1718.unnamed.first_primitive;
                                                                    }
                                                                    let _e1755 = phi_2213_;
                                                                    let _e1768 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1737 >> bitcast<u32>(((_e1734 * 8u) & 31u))) & 255u)) * _e1493) + (_e1511 - _e1273)), ((f32(((_e1746 >> bitcast<u32>(((_e1734 * 8u) & 31u))) & 255u)) * _e1494) + (_e1512 - _e1274)));
                                                                    let _e1769 = core_intrinsics_maximum_number_nsz_f32_(_e1768, ((f32(((_e1755 >> bitcast<u32>(((_e1734 * 8u) & 31u))) & 255u)) * _e1495) + (_e1513 - _e1275)));
                                                                    if (_e1733 == 0u) {
                                                                        phi_2231_ = _e1580.unnamed_1.root;
                                                                    } else {
                                                                        phi_2231_ = _e1580.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1772 = phi_2231_;
                                                                    if (_e1733 == 0u) {
                                                                        phi_2241_ = _e1649.unnamed_1.root;
                                                                    } else {
                                                                        phi_2241_ = _e1649.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1781 = phi_2241_;
                                                                    if (_e1733 == 0u) {
                                                                        phi_2251_ = _e1718.unnamed_1.root;
                                                                    } else {
                                                                        phi_2251_ = _e1718.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1790 = phi_2251_;
                                                                    let _e1803 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1772 >> bitcast<u32>(((_e1734 * 8u) & 31u))) & 255u)) * _e1493) + (_e1511 + _e1273)), ((f32(((_e1781 >> bitcast<u32>(((_e1734 * 8u) & 31u))) & 255u)) * _e1494) + (_e1512 + _e1274)));
                                                                    let _e1804 = core_intrinsics_minimum_number_nsz_f32_(_e1803, ((f32(((_e1790 >> bitcast<u32>(((_e1734 * 8u) & 31u))) & 255u)) * _e1495) + (_e1513 + _e1275)));
                                                                    if (_e1769 <= _e1804) {
                                                                        if (_e1769 <= _e146) {
                                                                            if (_e1804 >= 0f) {
                                                                                if (_e1733 == 0u) {
                                                                                    let _e1811 = nodes.member[(0u + _e1461)].links[2u];
                                                                                    phi_2287_ = _e1811;
                                                                                } else {
                                                                                    let _e1814 = nodes.member[(0u + _e1461)].links[3u];
                                                                                    phi_2287_ = _e1814;
                                                                                }
                                                                                let _e1816 = phi_2287_;
                                                                                let _e1821 = ((_e1816 >> bitcast<u32>(((_e1734 * 8u) & 31u))) & 255u);
                                                                                let _e1822 = (_e1821 & 31u);
                                                                                if (_e1822 >= 24u) {
                                                                                    phi_2300_ = (24u + ((_e1822 - 24u) ^ _e1323));
                                                                                } else {
                                                                                    phi_2300_ = _e1822;
                                                                                }
                                                                                let _e1828 = phi_2300_;
                                                                                phi_2305_ = (_e1730 | ((_e1821 >> bitcast<u32>(5i)) << bitcast<u32>((_e1828 & 31u))));
                                                                            } else {
                                                                                phi_2305_ = _e1730;
                                                                            }
                                                                            let _e1836 = phi_2305_;
                                                                            phi_2306_ = _e1836;
                                                                        } else {
                                                                            phi_2306_ = _e1730;
                                                                        }
                                                                        let _e1838 = phi_2306_;
                                                                        phi_2307_ = _e1838;
                                                                    } else {
                                                                        phi_2307_ = _e1730;
                                                                    }
                                                                    let _e1840 = phi_2307_;
                                                                    phi_2177_ = (_e1728 + 1u);
                                                                    phi_2180_ = _e1840;
                                                                } else {
                                                                    phi_2177_ = u32();
                                                                    phi_2180_ = u32();
                                                                }
                                                                let _e1843 = phi_2177_;
                                                                let _e1845 = phi_2180_;
                                                                continue;
                                                                continuing {
                                                                    phi_2176_ = _e1843;
                                                                    phi_2179_ = _e1845;
                                                                    break if !(_e1731);
                                                                }
                                                            }
                                                            let _e1849 = nodes.member[(0u + _e1461)].links[0u];
                                                            let _e1853 = nodes.member[(0u + _e1461)].frame[3u];
                                                            let _e1857 = local_6;
                                                            if ((_e1857 & 4278190080u) == 0u) {
                                                            } else {
                                                                let _e1861 = local_1.group_mask;
                                                                if ((_e1861 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1865 = local_1.len;
                                                                    if (_e1865 < 32u) {
                                                                        let _e1868 = local_1.group;
                                                                        let _e1870 = local_1.len;
                                                                        if (_e1870 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_1.first[(0u + _e1870)] = _e1868;
                                                                        let _e1876 = local_1.group_mask;
                                                                        let _e1878 = local_1.len;
                                                                        if (_e1878 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_1.mask[(0u + _e1878)] = _e1876;
                                                                        let _e1885 = local_1.len;
                                                                        local_1.len = (_e1885 + 1u);
                                                                    }
                                                                }
                                                                local_1.group = (_e1085 + _e1849);
                                                                let _e1889 = local_7;
                                                                local_1.group_mask = ((_e1889 & 4278190080u) | (_e1853 >> bitcast<u32>(24i)));
                                                            }
                                                            let _e1894 = local_8;
                                                            phi_2365_ = (_e1894 & 16777215u);
                                                            loop {
                                                                let _e1897 = phi_2365_;
                                                                let _e1898 = (_e1897 == 0u);
                                                                local_9 = _e1898;
                                                                local_15 = _e1898;
                                                                if _e1898 {
                                                                    phi_2366_ = u32();
                                                                    phi_3173_ = false;
                                                                    phi_3174_ = false;
                                                                    phi_3175_ = false;
                                                                } else {
                                                                    let _e1901 = nodes.member[(0u + _e1461)].links[1u];
                                                                    let _e1906 = ((_e1087 + _e1901) + select(firstTrailingBit(_e1897), 32u, (_e1897 == 0u)));
                                                                    if (_e1906 < _e80) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1913 = triangles.member[(0u + _e1906)].v0_;
                                                                    let _e1915 = (_e1913.x - _e1016);
                                                                    let _e1917 = (_e1913.y - _e1029);
                                                                    let _e1919 = (_e1913.z - _e1042);
                                                                    if (_e1296 == 0u) {
                                                                        phi_2411_ = vec3<f32>(_e1917, _e1919, _e1915);
                                                                    } else {
                                                                        if (_e1296 == 1u) {
                                                                            phi_2410_ = vec3<f32>(_e1919, _e1915, _e1917);
                                                                        } else {
                                                                            phi_2410_ = (_e1913 - vec3<f32>(_e1016, _e1029, _e1042));
                                                                        }
                                                                        let _e1927 = phi_2410_;
                                                                        phi_2411_ = _e1927;
                                                                    }
                                                                    let _e1929 = phi_2411_;
                                                                    let _e1933 = (_e1929.x - (_e1307 * _e1929.z));
                                                                    let _e1937 = (_e1929.y - (_e1310 * _e1929.z));
                                                                    let _e1939 = triangles.member[(0u + _e1906)].v1_;
                                                                    let _e1941 = (_e1939.x - _e1016);
                                                                    let _e1943 = (_e1939.y - _e1029);
                                                                    let _e1945 = (_e1939.z - _e1042);
                                                                    if (_e1296 == 0u) {
                                                                        phi_2441_ = vec3<f32>(_e1943, _e1945, _e1941);
                                                                    } else {
                                                                        if (_e1296 == 1u) {
                                                                            phi_2440_ = vec3<f32>(_e1945, _e1941, _e1943);
                                                                        } else {
                                                                            phi_2440_ = (_e1939 - vec3<f32>(_e1016, _e1029, _e1042));
                                                                        }
                                                                        let _e1953 = phi_2440_;
                                                                        phi_2441_ = _e1953;
                                                                    }
                                                                    let _e1955 = phi_2441_;
                                                                    let _e1959 = (_e1955.x - (_e1307 * _e1955.z));
                                                                    let _e1963 = (_e1955.y - (_e1310 * _e1955.z));
                                                                    let _e1965 = triangles.member[(0u + _e1906)].v2_;
                                                                    let _e1967 = (_e1965.x - _e1016);
                                                                    let _e1969 = (_e1965.y - _e1029);
                                                                    let _e1971 = (_e1965.z - _e1042);
                                                                    if (_e1296 == 0u) {
                                                                        phi_2471_ = vec3<f32>(_e1969, _e1971, _e1967);
                                                                    } else {
                                                                        if (_e1296 == 1u) {
                                                                            phi_2470_ = vec3<f32>(_e1971, _e1967, _e1969);
                                                                        } else {
                                                                            phi_2470_ = (_e1965 - vec3<f32>(_e1016, _e1029, _e1042));
                                                                        }
                                                                        let _e1979 = phi_2470_;
                                                                        phi_2471_ = _e1979;
                                                                    }
                                                                    let _e1981 = phi_2471_;
                                                                    let _e1985 = (_e1981.x - (_e1307 * _e1981.z));
                                                                    let _e1989 = (_e1981.y - (_e1310 * _e1981.z));
                                                                    if (_e1959 < _e1985) {
                                                                        phi_2490_ = true;
                                                                    } else {
                                                                        if (_e1959 == _e1985) {
                                                                            phi_2489_ = (_e1963 < _e1989);
                                                                        } else {
                                                                            phi_2489_ = false;
                                                                        }
                                                                        let _e1994 = phi_2489_;
                                                                        phi_2490_ = _e1994;
                                                                    }
                                                                    let _e1996 = phi_2490_;
                                                                    if _e1996 {
                                                                        phi_2494_ = _e1989;
                                                                        phi_2495_ = _e1985;
                                                                        phi_2496_ = _e1963;
                                                                        phi_2497_ = _e1959;
                                                                    } else {
                                                                        phi_2494_ = _e1963;
                                                                        phi_2495_ = _e1959;
                                                                        phi_2496_ = _e1989;
                                                                        phi_2497_ = _e1985;
                                                                    }
                                                                    let _e1998 = phi_2494_;
                                                                    let _e2000 = phi_2495_;
                                                                    let _e2002 = phi_2496_;
                                                                    let _e2004 = phi_2497_;
                                                                    let _e2007 = ((_e2004 * _e1998) - (_e2002 * _e2000));
                                                                    if _e1996 {
                                                                        phi_2505_ = -(_e2007);
                                                                    } else {
                                                                        phi_2505_ = _e2007;
                                                                    }
                                                                    let _e2010 = phi_2505_;
                                                                    if (_e1985 < _e1933) {
                                                                        phi_2516_ = true;
                                                                    } else {
                                                                        if (_e1985 == _e1933) {
                                                                            phi_2515_ = (_e1989 < _e1937);
                                                                        } else {
                                                                            phi_2515_ = false;
                                                                        }
                                                                        let _e2015 = phi_2515_;
                                                                        phi_2516_ = _e2015;
                                                                    }
                                                                    let _e2017 = phi_2516_;
                                                                    if _e2017 {
                                                                        phi_2520_ = _e1937;
                                                                        phi_2521_ = _e1933;
                                                                        phi_2522_ = _e1989;
                                                                        phi_2523_ = _e1985;
                                                                    } else {
                                                                        phi_2520_ = _e1989;
                                                                        phi_2521_ = _e1985;
                                                                        phi_2522_ = _e1937;
                                                                        phi_2523_ = _e1933;
                                                                    }
                                                                    let _e2019 = phi_2520_;
                                                                    let _e2021 = phi_2521_;
                                                                    let _e2023 = phi_2522_;
                                                                    let _e2025 = phi_2523_;
                                                                    let _e2028 = ((_e2025 * _e2019) - (_e2023 * _e2021));
                                                                    if _e2017 {
                                                                        phi_2531_ = -(_e2028);
                                                                    } else {
                                                                        phi_2531_ = _e2028;
                                                                    }
                                                                    let _e2031 = phi_2531_;
                                                                    if (_e1933 < _e1959) {
                                                                        phi_2542_ = true;
                                                                    } else {
                                                                        if (_e1933 == _e1959) {
                                                                            phi_2541_ = (_e1937 < _e1963);
                                                                        } else {
                                                                            phi_2541_ = false;
                                                                        }
                                                                        let _e2036 = phi_2541_;
                                                                        phi_2542_ = _e2036;
                                                                    }
                                                                    let _e2038 = phi_2542_;
                                                                    if _e2038 {
                                                                        phi_2546_ = _e1963;
                                                                        phi_2547_ = _e1959;
                                                                        phi_2548_ = _e1937;
                                                                        phi_2549_ = _e1933;
                                                                    } else {
                                                                        phi_2546_ = _e1937;
                                                                        phi_2547_ = _e1933;
                                                                        phi_2548_ = _e1963;
                                                                        phi_2549_ = _e1959;
                                                                    }
                                                                    let _e2040 = phi_2546_;
                                                                    let _e2042 = phi_2547_;
                                                                    let _e2044 = phi_2548_;
                                                                    let _e2046 = phi_2549_;
                                                                    let _e2049 = ((_e2046 * _e2040) - (_e2044 * _e2042));
                                                                    if _e2038 {
                                                                        phi_2557_ = -(_e2049);
                                                                    } else {
                                                                        phi_2557_ = _e2049;
                                                                    }
                                                                    let _e2052 = phi_2557_;
                                                                    if (_e2010 >= 0f) {
                                                                        if (_e2031 >= 0f) {
                                                                            if (_e2052 >= 0f) {
                                                                                phi_2572_ = ((_e2010 + _e2031) + _e2052);
                                                                                phi_2573_ = false;
                                                                            } else {
                                                                                phi_2572_ = f32();
                                                                                phi_2573_ = true;
                                                                            }
                                                                            let _e2059 = phi_2572_;
                                                                            let _e2061 = phi_2573_;
                                                                            phi_2574_ = _e2059;
                                                                            phi_2575_ = _e2061;
                                                                        } else {
                                                                            phi_2574_ = f32();
                                                                            phi_2575_ = true;
                                                                        }
                                                                        let _e2063 = phi_2574_;
                                                                        let _e2065 = phi_2575_;
                                                                        phi_2576_ = _e2063;
                                                                        phi_2577_ = _e2065;
                                                                    } else {
                                                                        phi_2576_ = f32();
                                                                        phi_2577_ = true;
                                                                    }
                                                                    let _e2067 = phi_2576_;
                                                                    let _e2069 = phi_2577_;
                                                                    if _e2069 {
                                                                        if (_e2010 <= 0f) {
                                                                            if (_e2031 <= 0f) {
                                                                                let _e2072 = (_e2052 <= 0f);
                                                                                if _e2072 {
                                                                                }
                                                                                phi_2595_ = ((_e2010 + _e2031) + _e2052);
                                                                                phi_2596_ = false;
                                                                                phi_2597_ = _e2072;
                                                                            } else {
                                                                                phi_2595_ = f32();
                                                                                phi_2596_ = true;
                                                                                phi_2597_ = false;
                                                                            }
                                                                            let _e2076 = phi_2595_;
                                                                            let _e2078 = phi_2596_;
                                                                            let _e2080 = phi_2597_;
                                                                            phi_2598_ = _e2076;
                                                                            phi_2599_ = _e2078;
                                                                            phi_2600_ = _e2080;
                                                                        } else {
                                                                            phi_2598_ = f32();
                                                                            phi_2599_ = true;
                                                                            phi_2600_ = false;
                                                                        }
                                                                        let _e2082 = phi_2598_;
                                                                        let _e2084 = phi_2599_;
                                                                        let _e2086 = phi_2600_;
                                                                        if _e2084 {
                                                                            phi_2604_ = false;
                                                                        } else {
                                                                            phi_2604_ = _e2086;
                                                                        }
                                                                        let _e2088 = phi_2604_;
                                                                        phi_2605_ = _e2082;
                                                                        phi_2606_ = _e2088;
                                                                    } else {
                                                                        phi_2605_ = _e2067;
                                                                        phi_2606_ = true;
                                                                    }
                                                                    let _e2090 = phi_2605_;
                                                                    let _e2092 = phi_2606_;
                                                                    if _e2092 {
                                                                        let _e2093 = (_e2090 == 0f);
                                                                        if _e2093 {
                                                                            phi_2922_ = lt_bvh_triangle_Intersection();
                                                                            phi_2923_ = false;
                                                                        } else {
                                                                            let _e2095 = triangles.member[(0u + _e1906)].v0_;
                                                                            let _e2097 = (_e2095.x - _e1016);
                                                                            let _e2099 = (_e2095.y - _e1029);
                                                                            let _e2101 = (_e2095.z - _e1042);
                                                                            if (_e1296 == 0u) {
                                                                                phi_2635_ = vec3<f32>(_e2099, _e2101, _e2097);
                                                                            } else {
                                                                                if (_e1296 == 1u) {
                                                                                    phi_2634_ = vec3<f32>(_e2101, _e2097, _e2099);
                                                                                } else {
                                                                                    phi_2634_ = (_e2095 - vec3<f32>(_e1016, _e1029, _e1042));
                                                                                }
                                                                                let _e2109 = phi_2634_;
                                                                                phi_2635_ = _e2109;
                                                                            }
                                                                            let _e2111 = phi_2635_;
                                                                            let _e2113 = triangles.member[(0u + _e1906)].v1_;
                                                                            let _e2115 = triangles.member[(0u + _e1906)].v0_;
                                                                            let _e2118 = (_e2113.x - _e2115.x);
                                                                            let _e2121 = (_e2113.y - _e2115.y);
                                                                            let _e2124 = (_e2113.z - _e2115.z);
                                                                            if (_e1296 == 0u) {
                                                                                phi_2661_ = vec3<f32>(_e2121, _e2124, _e2118);
                                                                            } else {
                                                                                if (_e1296 == 1u) {
                                                                                    phi_2660_ = vec3<f32>(_e2124, _e2118, _e2121);
                                                                                } else {
                                                                                    phi_2660_ = (_e2113 - _e2115);
                                                                                }
                                                                                let _e2131 = phi_2660_;
                                                                                phi_2661_ = _e2131;
                                                                            }
                                                                            let _e2133 = phi_2661_;
                                                                            let _e2135 = triangles.member[(0u + _e1906)].v2_;
                                                                            let _e2137 = triangles.member[(0u + _e1906)].v0_;
                                                                            let _e2140 = (_e2135.x - _e2137.x);
                                                                            let _e2143 = (_e2135.y - _e2137.y);
                                                                            let _e2146 = (_e2135.z - _e2137.z);
                                                                            if (_e1296 == 0u) {
                                                                                phi_2687_ = vec3<f32>(_e2143, _e2146, _e2140);
                                                                            } else {
                                                                                if (_e1296 == 1u) {
                                                                                    phi_2686_ = vec3<f32>(_e2146, _e2140, _e2143);
                                                                                } else {
                                                                                    phi_2686_ = (_e2135 - _e2137);
                                                                                }
                                                                                let _e2153 = phi_2686_;
                                                                                phi_2687_ = _e2153;
                                                                            }
                                                                            let _e2155 = phi_2687_;
                                                                            let _e2162 = ((_e2133.y * _e2155.z) - (_e2133.z * _e2155.y));
                                                                            let _e2169 = ((_e2133.z * _e2155.x) - (_e2133.x * _e2155.z));
                                                                            let _e2176 = ((_e2133.x * _e2155.y) - (_e2133.y * _e2155.x));
                                                                            let _e2190 = (((1f / _e1304.z) * (((_e2162 * _e2111.x) + (_e2169 * _e2111.y)) + (_e2176 * _e2111.z))) / (((_e2162 * _e1307) + (_e2169 * _e1310)) + _e2176));
                                                                            if (_e2190 > 0f) {
                                                                                if (_e2190 < _e146) {
                                                                                    let _e2194 = triangles.member[(0u + _e1906)].v0_;
                                                                                    let _e2196 = triangles.member[(0u + _e1906)].v1_;
                                                                                    if (_e2194.x < _e2196.x) {
                                                                                        phi_2743_ = _e2194.x;
                                                                                    } else {
                                                                                        phi_2743_ = _e2196.x;
                                                                                    }
                                                                                    let _e2203 = phi_2743_;
                                                                                    if (_e2194.y < _e2196.y) {
                                                                                        phi_2752_ = _e2194.y;
                                                                                    } else {
                                                                                        phi_2752_ = _e2196.y;
                                                                                    }
                                                                                    let _e2210 = phi_2752_;
                                                                                    if (_e2194.z < _e2196.z) {
                                                                                        phi_2761_ = _e2194.z;
                                                                                    } else {
                                                                                        phi_2761_ = _e2196.z;
                                                                                    }
                                                                                    let _e2217 = phi_2761_;
                                                                                    let _e2219 = triangles.member[(0u + _e1906)].v2_;
                                                                                    if (_e2203 < _e2219.x) {
                                                                                        phi_2770_ = _e2203;
                                                                                    } else {
                                                                                        phi_2770_ = _e2219.x;
                                                                                    }
                                                                                    let _e2224 = phi_2770_;
                                                                                    if (_e2210 < _e2219.y) {
                                                                                        phi_2777_ = _e2210;
                                                                                    } else {
                                                                                        phi_2777_ = _e2219.y;
                                                                                    }
                                                                                    let _e2229 = phi_2777_;
                                                                                    if (_e2217 < _e2219.z) {
                                                                                        phi_2784_ = _e2217;
                                                                                    } else {
                                                                                        phi_2784_ = _e2219.z;
                                                                                    }
                                                                                    let _e2234 = phi_2784_;
                                                                                    let _e2236 = triangles.member[(0u + _e1906)].v0_;
                                                                                    let _e2238 = triangles.member[(0u + _e1906)].v1_;
                                                                                    if (_e2236.x > _e2238.x) {
                                                                                        phi_2797_ = _e2236.x;
                                                                                    } else {
                                                                                        phi_2797_ = _e2238.x;
                                                                                    }
                                                                                    let _e2245 = phi_2797_;
                                                                                    if (_e2236.y > _e2238.y) {
                                                                                        phi_2806_ = _e2236.y;
                                                                                    } else {
                                                                                        phi_2806_ = _e2238.y;
                                                                                    }
                                                                                    let _e2252 = phi_2806_;
                                                                                    if (_e2236.z > _e2238.z) {
                                                                                        phi_2815_ = _e2236.z;
                                                                                    } else {
                                                                                        phi_2815_ = _e2238.z;
                                                                                    }
                                                                                    let _e2259 = phi_2815_;
                                                                                    let _e2261 = triangles.member[(0u + _e1906)].v2_;
                                                                                    if (_e2245 > _e2261.x) {
                                                                                        phi_2824_ = _e2245;
                                                                                    } else {
                                                                                        phi_2824_ = _e2261.x;
                                                                                    }
                                                                                    let _e2266 = phi_2824_;
                                                                                    if (_e2252 > _e2261.y) {
                                                                                        phi_2831_ = _e2252;
                                                                                    } else {
                                                                                        phi_2831_ = _e2261.y;
                                                                                    }
                                                                                    let _e2271 = phi_2831_;
                                                                                    if (_e2259 > _e2261.z) {
                                                                                        phi_2838_ = _e2259;
                                                                                    } else {
                                                                                        phi_2838_ = _e2261.z;
                                                                                    }
                                                                                    let _e2276 = phi_2838_;
                                                                                    let _e2280 = ((_e2224 - _e1016) * _e1225);
                                                                                    let _e2281 = ((_e2229 - _e1029) * _e1235);
                                                                                    let _e2282 = ((_e2234 - _e1042) * _e1245);
                                                                                    let _e2286 = ((_e2266 - _e1016) * _e1225);
                                                                                    let _e2287 = ((_e2271 - _e1029) * _e1235);
                                                                                    let _e2288 = ((_e2276 - _e1042) * _e1245);
                                                                                    if (_e2280 < _e2286) {
                                                                                        phi_2855_ = _e2280;
                                                                                    } else {
                                                                                        phi_2855_ = _e2286;
                                                                                    }
                                                                                    let _e2291 = phi_2855_;
                                                                                    if (_e2281 < _e2287) {
                                                                                        phi_2860_ = _e2281;
                                                                                    } else {
                                                                                        phi_2860_ = _e2287;
                                                                                    }
                                                                                    let _e2294 = phi_2860_;
                                                                                    if (_e2282 < _e2288) {
                                                                                        phi_2865_ = _e2282;
                                                                                    } else {
                                                                                        phi_2865_ = _e2288;
                                                                                    }
                                                                                    let _e2297 = phi_2865_;
                                                                                    if (_e2280 > _e2286) {
                                                                                        phi_2873_ = _e2280;
                                                                                    } else {
                                                                                        phi_2873_ = _e2286;
                                                                                    }
                                                                                    let _e2303 = phi_2873_;
                                                                                    if (_e2281 > _e2287) {
                                                                                        phi_2878_ = _e2281;
                                                                                    } else {
                                                                                        phi_2878_ = _e2287;
                                                                                    }
                                                                                    let _e2306 = phi_2878_;
                                                                                    if (_e2282 > _e2288) {
                                                                                        phi_2883_ = _e2282;
                                                                                    } else {
                                                                                        phi_2883_ = _e2288;
                                                                                    }
                                                                                    let _e2309 = phi_2883_;
                                                                                    let _e2313 = core_intrinsics_maximum_number_nsz_f32_((_e2291 - _e1280), (_e2294 - _e1281));
                                                                                    let _e2314 = core_intrinsics_maximum_number_nsz_f32_(_e2313, (_e2297 - _e1282));
                                                                                    let _e2315 = core_intrinsics_minimum_number_nsz_f32_((_e2303 + _e1280), (_e2306 + _e1281));
                                                                                    let _e2316 = core_intrinsics_minimum_number_nsz_f32_(_e2315, (_e2309 + _e1282));
                                                                                    if (_e2314 > _e997) {
                                                                                        phi_2895_ = _e2314;
                                                                                    } else {
                                                                                        phi_2895_ = _e997;
                                                                                    }
                                                                                    let _e2319 = phi_2895_;
                                                                                    if (_e2316 < _e999) {
                                                                                        phi_2900_ = _e2316;
                                                                                    } else {
                                                                                        phi_2900_ = _e999;
                                                                                    }
                                                                                    let _e2322 = phi_2900_;
                                                                                    if (_e2190 < _e2319) {
                                                                                        phi_2905_ = _e2319;
                                                                                    } else {
                                                                                        phi_2905_ = _e2190;
                                                                                    }
                                                                                    let _e2325 = phi_2905_;
                                                                                    if (_e2325 > _e2322) {
                                                                                        phi_2910_ = _e2322;
                                                                                    } else {
                                                                                        phi_2910_ = _e2325;
                                                                                    }
                                                                                    let _e2328 = phi_2910_;
                                                                                    phi_2915_ = lt_bvh_triangle_Intersection(_e2328, (_e2031 / _e2090), (_e2052 / _e2090), (_e2319 <= _e2322));
                                                                                    phi_2916_ = false;
                                                                                } else {
                                                                                    phi_2915_ = lt_bvh_triangle_Intersection();
                                                                                    phi_2916_ = true;
                                                                                }
                                                                                let _e2334 = phi_2915_;
                                                                                let _e2336 = phi_2916_;
                                                                                phi_2917_ = _e2334;
                                                                                phi_2918_ = _e2336;
                                                                            } else {
                                                                                phi_2917_ = lt_bvh_triangle_Intersection();
                                                                                phi_2918_ = true;
                                                                            }
                                                                            let _e2338 = phi_2917_;
                                                                            let _e2340 = phi_2918_;
                                                                            if _e2340 {
                                                                            }
                                                                            phi_2922_ = _e2338;
                                                                            phi_2923_ = _e2340;
                                                                        }
                                                                        let _e2342 = phi_2922_;
                                                                        let _e2344 = phi_2923_;
                                                                        phi_2924_ = _e2342;
                                                                        phi_2925_ = _e2093;
                                                                        phi_2926_ = _e2344;
                                                                    } else {
                                                                        phi_2924_ = lt_bvh_triangle_Intersection();
                                                                        phi_2925_ = true;
                                                                        phi_2926_ = false;
                                                                    }
                                                                    let _e2346 = phi_2924_;
                                                                    let _e2348 = phi_2925_;
                                                                    let _e2350 = phi_2926_;
                                                                    if _e2348 {
                                                                        phi_2930_ = true;
                                                                    } else {
                                                                        phi_2930_ = _e2350;
                                                                    }
                                                                    let _e2352 = phi_2930_;
                                                                    if _e2352 {
                                                                        phi_2934_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_2934_ = _e2346;
                                                                    }
                                                                    let _e2354 = phi_2934_;
                                                                    if _e2354.is_hit {
                                                                        if (_e2354.t > 0f) {
                                                                            if (_e2354.t < _e146) {
                                                                                let _e2361 = triangles.member[(0u + _e1906)].i0_;
                                                                                let _e2363 = ((_e2361 & 2147483648u) == 0u);
                                                                                if _e2363 {
                                                                                    phi_3157_ = false;
                                                                                    phi_3158_ = false;
                                                                                } else {
                                                                                    if (_e1906 < _e80) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2370 = triangles.member[(0u + _e1906)].i0_;
                                                                                    let _e2371 = (_e2370 & 2147483647u);
                                                                                    let _e2373 = triangles.member[(0u + _e1906)].i1_;
                                                                                    let _e2375 = triangles.member[(0u + _e1906)].i2_;
                                                                                    if (_e2371 < _e95) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2379 = vertices.member[(0u + _e2371)];
                                                                                    if (_e2373 < _e95) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2383 = vertices.member[(0u + _e2373)];
                                                                                    if (_e2375 < _e95) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2387 = vertices.member[(0u + _e2375)];
                                                                                    let _e2388 = array<abi_Vertex, 3>(_e2379, _e2383, _e2387);
                                                                                    if (_e2388[0].material < arrayLength((&materials.member))) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2394 = materials.member[(0u + _e2388[0].material)];
                                                                                    if ((_e2394.flags & 1u) == 1u) {
                                                                                        let _e2399 = ((1f - _e2354.u) - _e2354.v);
                                                                                        if (_e2394.cutoff <= 0f) {
                                                                                            phi_3151_ = true;
                                                                                        } else {
                                                                                            let _e2426 = (_e2394.base_color.w * ((((f32((_e2388[0].color >> bitcast<u32>(24i))) * _e2399) + (f32((_e2388[1].color >> bitcast<u32>(24i))) * _e2354.u)) + (f32((_e2388[2].color >> bitcast<u32>(24i))) * _e2354.v)) * (1f / 255f)));
                                                                                            if (_e2394.alpha_size == 0u) {
                                                                                                phi_3148_ = _e2426;
                                                                                            } else {
                                                                                                local.offset = _e2394.alpha_offset;
                                                                                                local.size = _e2394.alpha_size;
                                                                                                local.flags = _e2394.flags;
                                                                                                let _e2457 = _lt_shaders_texture_TextureView_quad((&local), (((_e2388[0].u * _e2399) + (_e2388[1].u * _e2354.u)) + (_e2388[2].u * _e2354.v)), (((_e2388[0].v * _e2399) + (_e2388[1].v * _e2354.u)) + (_e2388[2].v * _e2354.v)));
                                                                                                let _e2461 = (_e2457.indices[0] >> bitcast<u32>(2i));
                                                                                                if (_e2461 < _e101) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2465 = alpha_texels.member[(0u + _e2461)];
                                                                                                let _e2481 = (_e2457.indices[1] >> bitcast<u32>(2i));
                                                                                                if (_e2481 < _e101) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2485 = alpha_texels.member[(0u + _e2481)];
                                                                                                let _e2502 = (_e2457.indices[2] >> bitcast<u32>(2i));
                                                                                                if (_e2502 < _e101) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2506 = alpha_texels.member[(0u + _e2502)];
                                                                                                let _e2523 = (_e2457.indices[3] >> bitcast<u32>(2i));
                                                                                                if (_e2523 < _e101) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2527 = alpha_texels.member[(0u + _e2523)];
                                                                                                phi_3148_ = (_e2426 * (((((f32(((_e2465 >> bitcast<u32>((((_e2457.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2457.weights.x) + ((f32(((_e2485 >> bitcast<u32>((((_e2457.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2457.weights.y)) + ((f32(((_e2506 >> bitcast<u32>((((_e2457.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2457.weights.z)) + ((f32(((_e2527 >> bitcast<u32>((((_e2457.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2457.weights.w)));
                                                                                            }
                                                                                            let _e2543 = phi_3148_;
                                                                                            phi_3151_ = (_e2543 >= _e2394.cutoff);
                                                                                        }
                                                                                        let _e2547 = phi_3151_;
                                                                                        phi_3152_ = _e2547;
                                                                                    } else {
                                                                                        phi_3152_ = false;
                                                                                    }
                                                                                    let _e2549 = phi_3152_;
                                                                                    if _e2549 {
                                                                                        phi_3156_ = false;
                                                                                    } else {
                                                                                        phi_3156_ = true;
                                                                                    }
                                                                                    let _e2551 = phi_3156_;
                                                                                    phi_3157_ = _e2551;
                                                                                    phi_3158_ = _e2549;
                                                                                }
                                                                                let _e2553 = phi_3157_;
                                                                                let _e2555 = phi_3158_;
                                                                                phi_3159_ = _e2553;
                                                                                phi_3160_ = _e2363;
                                                                                phi_3161_ = _e2555;
                                                                            } else {
                                                                                phi_3159_ = true;
                                                                                phi_3160_ = false;
                                                                                phi_3161_ = false;
                                                                            }
                                                                            let _e2557 = phi_3159_;
                                                                            let _e2559 = phi_3160_;
                                                                            let _e2561 = phi_3161_;
                                                                            phi_3162_ = _e2557;
                                                                            phi_3163_ = _e2559;
                                                                            phi_3164_ = _e2561;
                                                                        } else {
                                                                            phi_3162_ = true;
                                                                            phi_3163_ = false;
                                                                            phi_3164_ = false;
                                                                        }
                                                                        let _e2563 = phi_3162_;
                                                                        let _e2565 = phi_3163_;
                                                                        let _e2567 = phi_3164_;
                                                                        phi_3165_ = _e2563;
                                                                        phi_3166_ = _e2565;
                                                                        phi_3167_ = _e2567;
                                                                    } else {
                                                                        phi_3165_ = true;
                                                                        phi_3166_ = false;
                                                                        phi_3167_ = false;
                                                                    }
                                                                    let _e2569 = phi_3165_;
                                                                    let _e2571 = phi_3166_;
                                                                    let _e2573 = phi_3167_;
                                                                    if _e2569 {
                                                                        phi_3171_ = false;
                                                                        phi_3172_ = false;
                                                                    } else {
                                                                        phi_3171_ = _e2571;
                                                                        phi_3172_ = _e2573;
                                                                    }
                                                                    let _e2575 = phi_3171_;
                                                                    let _e2577 = phi_3172_;
                                                                    phi_2366_ = (_e1897 & (_e1897 - 1u));
                                                                    phi_3173_ = _e2569;
                                                                    phi_3174_ = _e2575;
                                                                    phi_3175_ = _e2577;
                                                                }
                                                                let _e2579 = phi_2366_;
                                                                let _e2581 = phi_3173_;
                                                                let _e2583 = phi_3174_;
                                                                let _e2585 = phi_3175_;
                                                                local_13 = _e2583;
                                                                local_14 = _e2585;
                                                                continue;
                                                                continuing {
                                                                    phi_2365_ = _e2579;
                                                                    break if !(_e2581);
                                                                }
                                                            }
                                                            let _e2588 = local_9;
                                                            if _e2588 {
                                                                let _e2590 = local_1.group_mask;
                                                                if ((_e2590 & 4278190080u) == 0u) {
                                                                    let _e2594 = local_1.len;
                                                                    if (_e2594 == 0u) {
                                                                        phi_3217_ = false;
                                                                    } else {
                                                                        let _e2598 = local_1.len;
                                                                        local_1.len = (_e2598 - 1u);
                                                                        let _e2601 = local_1.len;
                                                                        if (_e2601 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e2606 = local_1.first[(0u + _e2601)];
                                                                        local_1.group = _e2606;
                                                                        let _e2609 = local_1.len;
                                                                        if (_e2609 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e2614 = local_1.mask[(0u + _e2609)];
                                                                        local_1.group_mask = _e2614;
                                                                        phi_3217_ = true;
                                                                    }
                                                                    let _e2617 = phi_3217_;
                                                                    phi_3218_ = _e2617;
                                                                } else {
                                                                    phi_3218_ = true;
                                                                }
                                                                let _e2619 = phi_3218_;
                                                                if _e2619 {
                                                                    let _e2621 = local_1.group_mask;
                                                                    let _e2627 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2621)), 32u, (_e2621 == 0u)));
                                                                    let _e2631 = local_1.group_mask;
                                                                    let _e2645 = local_1.group_mask;
                                                                    local_1.group_mask = (_e2645 & ~((1u << bitcast<u32>((_e2627 & 31u)))));
                                                                    let _e2648 = local_1.group;
                                                                    phi_3249_ = (_e2648 + countOneBits(((_e2631 & ~((4294967295u << bitcast<u32>((((_e2627 - 24u) ^ _e1323) & 31u))))) & 255u)));
                                                                } else {
                                                                    phi_3249_ = 4294967295u;
                                                                }
                                                                let _e2651 = phi_3249_;
                                                                phi_3250_ = _e2651;
                                                                phi_3251_ = false;
                                                                phi_3252_ = false;
                                                            } else {
                                                                phi_3250_ = u32();
                                                                let _e3063 = local_13;
                                                                phi_3251_ = _e3063;
                                                                let _e3066 = local_14;
                                                                phi_3252_ = _e3066;
                                                            }
                                                            let _e2653 = phi_3250_;
                                                            let _e2655 = phi_3251_;
                                                            let _e2657 = phi_3252_;
                                                            phi_2036_ = _e2653;
                                                            let _e3070 = local_15;
                                                            phi_3253_ = _e3070;
                                                            phi_3254_ = false;
                                                            phi_3255_ = _e2655;
                                                            phi_3256_ = _e2657;
                                                        } else {
                                                            phi_2036_ = u32();
                                                            phi_3253_ = false;
                                                            phi_3254_ = true;
                                                            phi_3255_ = false;
                                                            phi_3256_ = false;
                                                        }
                                                        let _e2659 = phi_2036_;
                                                        let _e2661 = phi_3253_;
                                                        let _e2663 = phi_3254_;
                                                        let _e2665 = phi_3255_;
                                                        let _e2667 = phi_3256_;
                                                        local_10 = _e2663;
                                                        local_16 = _e2665;
                                                        local_17 = _e2667;
                                                        continue;
                                                        continuing {
                                                            phi_2035_ = _e2659;
                                                            break if !(_e2661);
                                                        }
                                                    }
                                                    let _e2670 = local_10;
                                                    if _e2670 {
                                                        phi_3260_ = false;
                                                        phi_3261_ = false;
                                                    } else {
                                                        let _e3077 = local_16;
                                                        phi_3260_ = _e3077;
                                                        let _e3080 = local_17;
                                                        phi_3261_ = _e3080;
                                                    }
                                                    let _e2672 = phi_3260_;
                                                    let _e2674 = phi_3261_;
                                                    if _e2672 {
                                                        phi_3265_ = true;
                                                    } else {
                                                        phi_3265_ = _e2674;
                                                    }
                                                    let _e2676 = phi_3265_;
                                                    if _e2676 {
                                                        phi_3269_ = true;
                                                    } else {
                                                        phi_3269_ = false;
                                                    }
                                                    let _e2678 = phi_3269_;
                                                    phi_3270_ = _e2678;
                                                }
                                                let _e2680 = phi_3270_;
                                                phi_3271_ = _e2680;
                                                phi_3272_ = _e1149;
                                            } else {
                                                phi_3271_ = bool();
                                                phi_3272_ = true;
                                            }
                                            let _e2682 = phi_3271_;
                                            let _e2684 = phi_3272_;
                                            if _e2684 {
                                                phi_3276_ = false;
                                            } else {
                                                phi_3276_ = _e2682;
                                            }
                                            let _e2686 = phi_3276_;
                                            if _e2686 {
                                                phi_3280_ = false;
                                            } else {
                                                phi_3280_ = true;
                                            }
                                            let _e2688 = phi_3280_;
                                            phi_3281_ = _e2688;
                                        } else {
                                            phi_3281_ = true;
                                        }
                                        let _e2690 = phi_3281_;
                                        phi_3282_ = _e2690;
                                    } else {
                                        phi_3282_ = true;
                                    }
                                    let _e2692 = phi_3282_;
                                    phi_3283_ = _e2692;
                                } else {
                                    phi_3283_ = true;
                                }
                                let _e2694 = phi_3283_;
                                if _e2694 {
                                }
                                phi_1430_ = (_e936 & (_e936 - 1u));
                                phi_3287_ = _e2694;
                            }
                            let _e2696 = phi_1430_;
                            let _e2698 = phi_3287_;
                            continue;
                            continuing {
                                phi_1429_ = _e2696;
                                break if !(_e2698);
                            }
                        }
                        let _e2701 = local_11;
                        if _e2701 {
                            let _e2703 = local_2.group_mask;
                            if ((_e2703 & 4278190080u) == 0u) {
                                let _e2707 = local_2.len;
                                if (_e2707 == 0u) {
                                    phi_3329_ = false;
                                } else {
                                    let _e2711 = local_2.len;
                                    local_2.len = (_e2711 - 1u);
                                    let _e2714 = local_2.len;
                                    if (_e2714 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e2719 = local_2.first[(0u + _e2714)];
                                    local_2.group = _e2719;
                                    let _e2722 = local_2.len;
                                    if (_e2722 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e2727 = local_2.mask[(0u + _e2722)];
                                    local_2.group_mask = _e2727;
                                    phi_3329_ = true;
                                }
                                let _e2730 = phi_3329_;
                                phi_3330_ = _e2730;
                            } else {
                                phi_3330_ = true;
                            }
                            let _e2732 = phi_3330_;
                            if _e2732 {
                                let _e2734 = local_2.group_mask;
                                let _e2740 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2734)), 32u, (_e2734 == 0u)));
                                let _e2744 = local_2.group_mask;
                                let _e2758 = local_2.group_mask;
                                local_2.group_mask = (_e2758 & ~((1u << bitcast<u32>((_e2740 & 31u)))));
                                let _e2761 = local_2.group;
                                phi_3361_ = (_e2761 + countOneBits(((_e2744 & ~((4294967295u << bitcast<u32>((((_e2740 - 24u) ^ _e362) & 31u))))) & 255u)));
                            } else {
                                phi_3361_ = 4294967295u;
                            }
                            let _e2764 = phi_3361_;
                            phi_3362_ = _e2764;
                        } else {
                            phi_3362_ = u32();
                        }
                        let _e2766 = phi_3362_;
                        phi_1100_ = _e2766;
                        let _e3101 = local_18;
                        phi_3363_ = _e3101;
                        phi_3364_ = false;
                    } else {
                        phi_1100_ = u32();
                        phi_3363_ = false;
                        phi_3364_ = true;
                    }
                    let _e2768 = phi_1100_;
                    let _e2770 = phi_3363_;
                    let _e2772 = phi_3364_;
                    local_12 = _e2772;
                    continue;
                    continuing {
                        phi_1099_ = _e2768;
                        break if !(_e2770);
                    }
                }
                let _e2775 = local_12;
                if _e2775 {
                    phi_3368_ = false;
                } else {
                    phi_3368_ = true;
                }
                let _e2777 = phi_3368_;
                if _e2777 {
                    phi_3372_ = true;
                } else {
                    phi_3372_ = false;
                }
                let _e2779 = phi_3372_;
                phi_3373_ = _e2779;
            }
            let _e2781 = phi_3373_;
            phi_3374_ = _e2781;
            phi_3375_ = _e218;
        } else {
            phi_3374_ = bool();
            phi_3375_ = true;
        }
        let _e2783 = phi_3374_;
        let _e2785 = phi_3375_;
        if _e2785 {
            phi_3379_ = false;
        } else {
            phi_3379_ = _e2783;
        }
        let _e2787 = phi_3379_;
        if _e2787 {
            phi_3383_ = 0f;
        } else {
            phi_3383_ = 1f;
        }
        let _e2789 = phi_3383_;
        if (_e114 < _e83) {
        } else {
            return;
        }
        visibility.member[(0u + _e114)] = _e2789;
        if (_e114 < _e89) {
        } else {
            return;
        }
        let _e2796 = bits.member[(0u + _e114)];
        if ((_e2796 & 2u) == 0u) {
            phi_3404_ = (_e2796 & 1u);
        } else {
            phi_3404_ = (_e2796 & 7u);
        }
        let _e2802 = phi_3404_;
        if (_e114 < _e83) {
        } else {
            return;
        }
        let _e2806 = visibility.member[(0u + _e114)];
        if ((_e2802 & 1u) != 0u) {
            phi_3419_ = (2u | 1u);
        } else {
            phi_3419_ = 2u;
        }
        let _e2812 = phi_3419_;
        if (_e2806 < 0.5f) {
            phi_3424_ = (_e2812 | 4u);
        } else {
            phi_3424_ = _e2812;
        }
        let _e2815 = phi_3424_;
        if (_e114 < _e89) {
        } else {
            return;
        }
        bits.member[(0u + _e114)] = _e2815;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_learn_instanced_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
