struct abi_CameraParams {
    eye: vec3<f32>,
    root: u32,
    right: vec3<f32>,
    pad0_: u32,
    up: vec3<f32>,
    pad1_: u32,
    forward: vec3<f32>,
    pad2_: u32,
    size: vec2<u32>,
    pad3_: vec2<u32>,
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

struct lt_mask_LightPlace {
    word: u32,
    shift: u32,
}

struct type_26 {
    member: array<vec4<f32>>,
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

struct lt_bvh_Node {
    frame: vec4<u32>,
    links: vec4<u32>,
    x: vec4<u32>,
    y: vec4<u32>,
    z: vec4<u32>,
}

struct type_35 {
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

struct type_39 {
    member: array<lt_bvh_Triangle>,
}

struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
}

struct type_43 {
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

struct type_47 {
    member: array<abi_Material>,
}

struct u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_ {
    unnamed: lt_mask_LightPlace,
    unnamed_1: lt_mask_LightPlace,
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

struct type_58 {
    member: abi_CameraParams,
}

struct lt_bvh_Ray {
    origin: vec3<f32>,
    tmin: f32,
    direction: vec3<f32>,
    tmax: f32,
}

struct lt_bvh_Hit {
    t: f32,
    u: f32,
    v: f32,
    triangle: u32,
    instance: u32,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(3) 
var<storage> vertices: type_43;
@group(0) @binding(4) 
var<storage> materials: type_47;
@group(0) @binding(0) 
var<uniform> p: type_58;
@group(0) @binding(1) 
var<storage> nodes: type_35;
@group(0) @binding(2) 
var<storage> triangles: type_39;
@group(0) @binding(5) 
var<storage, read_write> samples: type_9;
@group(0) @binding(6) 
var<storage> alpha_texels: type_13;
@group(0) @binding(7) 
var<storage> color_texels: type_13;
@group(0) @binding(8) 
var<storage> before: type_26;
@group(0) @binding(9) 
var<storage, read_write> past: type_26;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_mask_LightPlace {
    var phi_220_: lt_mask_LightPlace;
    var phi_221_: bool;
    var phi_222_: lt_mask_LightPlace;
    var phi_223_: bool;
    var phi_228_: lt_mask_LightPlace;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_220_ = lt_mask_LightPlace(1u, ((param.y * param_1) + param.x));
            phi_221_ = false;
        } else {
            phi_220_ = lt_mask_LightPlace();
            phi_221_ = true;
        }
        let _e85 = phi_220_;
        let _e87 = phi_221_;
        phi_222_ = _e85;
        phi_223_ = _e87;
    } else {
        phi_222_ = lt_mask_LightPlace();
        phi_223_ = true;
    }
    let _e89 = phi_222_;
    let _e91 = phi_223_;
    if _e91 {
        phi_228_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_228_ = _e89;
    }
    let _e96 = phi_228_;
    return lt_mask_LightPlace(_e96.word, _e96.shift);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_243_: bool;
    var phi_247_: f32;

    if (param_3 != param_3) {
        phi_243_ = true;
    } else {
        let _e75 = (param_4 >= param_3);
        if _e75 {
        }
        phi_243_ = _e75;
    }
    let _e77 = phi_243_;
    if _e77 {
        phi_247_ = param_4;
    } else {
        phi_247_ = param_3;
    }
    let _e79 = phi_247_;
    return _e79;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_259_: bool;
    var phi_263_: f32;

    if (param_5 != param_5) {
        phi_259_ = true;
    } else {
        let _e75 = (param_6 <= param_5);
        if _e75 {
        }
        phi_259_ = _e75;
    }
    let _e77 = phi_259_;
    if _e77 {
        phi_263_ = param_6;
    } else {
        phi_263_ = param_5;
    }
    let _e79 = phi_263_;
    return _e79;
}

fn _lt_shaders_texture_TextureView_quad(param_7: ptr<function, texture_TextureView>, param_8: f32, param_9: f32) -> texture_TexelQuad {
    var phi_305_: f32;
    var phi_310_: f32;
    var phi_311_: bool;
    var phi_312_: f32;
    var phi_313_: bool;
    var phi_317_: f32;
    var phi_343_: f32;
    var phi_348_: f32;
    var phi_349_: bool;
    var phi_350_: f32;
    var phi_351_: bool;
    var phi_355_: f32;
    var phi_363_: f32;
    var phi_364_: f32;
    var phi_365_: f32;
    var phi_374_: f32;
    var phi_375_: f32;
    var phi_393_: u32;
    var phi_407_: u32;
    var phi_414_: u32;
    var phi_419_: u32;
    var phi_425_: u32;
    var phi_430_: u32;
    var phi_432_: texture_Axis;
    var phi_460_: f32;
    var phi_465_: f32;
    var phi_466_: bool;
    var phi_467_: f32;
    var phi_468_: bool;
    var phi_472_: f32;
    var phi_498_: f32;
    var phi_503_: f32;
    var phi_504_: bool;
    var phi_505_: f32;
    var phi_506_: bool;
    var phi_510_: f32;
    var phi_518_: f32;
    var phi_519_: f32;
    var phi_520_: f32;
    var phi_529_: f32;
    var phi_530_: f32;
    var phi_548_: u32;
    var phi_562_: u32;
    var phi_569_: u32;
    var phi_574_: u32;
    var phi_580_: u32;
    var phi_585_: u32;
    var phi_587_: texture_Axis;

    let _e76 = (*param_7).size;
    let _e77 = (_e76 & 65535u);
    let _e79 = (*param_7).size;
    let _e81 = (_e79 >> bitcast<u32>(16i));
    let _e83 = (*param_7).flags;
    let _e85 = ((_e83 & 4u) != 0u);
    let _e87 = (*param_7).flags;
    let _e90 = ((_e87 >> bitcast<u32>(4u)) & 3u);
    if (_e90 == 0u) {
        if (param_8 > -8388608f) {
            let _e103 = f32(select(0i, select(select(i32(param_8), i32(-2147483648), (param_8 < bitcast<f32>(3472883712u))), 2147483647i, (param_8 > bitcast<f32>(1325400063u))), (param_8 == param_8)));
            if (_e103 > param_8) {
                phi_305_ = 1f;
            } else {
                phi_305_ = 0f;
            }
            let _e106 = phi_305_;
            if (param_8 < 8388608f) {
                phi_310_ = (_e103 - _e106);
                phi_311_ = false;
            } else {
                phi_310_ = f32();
                phi_311_ = true;
            }
            let _e109 = phi_310_;
            let _e111 = phi_311_;
            phi_312_ = _e109;
            phi_313_ = _e111;
        } else {
            phi_312_ = f32();
            phi_313_ = true;
        }
        let _e113 = phi_312_;
        let _e115 = phi_313_;
        if _e115 {
            phi_317_ = param_8;
        } else {
            phi_317_ = _e113;
        }
        let _e117 = phi_317_;
        phi_365_ = (param_8 - _e117);
    } else {
        if (_e90 == 1u) {
            let _e120 = (param_8 * 0.5f);
            if (_e120 > -8388608f) {
                let _e132 = f32(select(0i, select(select(i32(_e120), i32(-2147483648), (_e120 < bitcast<f32>(3472883712u))), 2147483647i, (_e120 > bitcast<f32>(1325400063u))), (_e120 == _e120)));
                if (_e132 > _e120) {
                    phi_343_ = 1f;
                } else {
                    phi_343_ = 0f;
                }
                let _e135 = phi_343_;
                if (_e120 < 8388608f) {
                    phi_348_ = (_e132 - _e135);
                    phi_349_ = false;
                } else {
                    phi_348_ = f32();
                    phi_349_ = true;
                }
                let _e138 = phi_348_;
                let _e140 = phi_349_;
                phi_350_ = _e138;
                phi_351_ = _e140;
            } else {
                phi_350_ = f32();
                phi_351_ = true;
            }
            let _e142 = phi_350_;
            let _e144 = phi_351_;
            if _e144 {
                phi_355_ = _e120;
            } else {
                phi_355_ = _e142;
            }
            let _e146 = phi_355_;
            let _e148 = (param_8 - (2f * _e146));
            if (_e148 > 1f) {
                phi_363_ = (2f - _e148);
            } else {
                phi_363_ = _e148;
            }
            let _e152 = phi_363_;
            phi_364_ = _e152;
        } else {
            phi_364_ = param_8;
        }
        let _e154 = phi_364_;
        phi_365_ = _e154;
    }
    let _e156 = phi_365_;
    if (_e156 > 0f) {
        if (_e156 < 1f) {
            phi_374_ = _e156;
        } else {
            phi_374_ = 1f;
        }
        let _e160 = phi_374_;
        phi_375_ = _e160;
    } else {
        phi_375_ = 0f;
    }
    let _e162 = phi_375_;
    let _e163 = (_e77 - 1u);
    let _e165 = (_e162 * f32(_e77));
    if _e85 {
        let _e172 = select(select(u32(_e165), 0u, (_e165 < bitcast<f32>(0u))), 4294967295u, (_e165 > bitcast<f32>(1333788671u)));
        if (_e163 < _e172) {
            phi_393_ = _e163;
        } else {
            phi_393_ = _e172;
        }
        let _e175 = phi_393_;
        phi_432_ = texture_Axis(_e175, _e175, 0f);
    } else {
        let _e177 = (_e165 + 0.5f);
        let _e184 = select(select(u32(_e177), 0u, (_e177 < bitcast<f32>(0u))), 4294967295u, (_e177 > bitcast<f32>(1333788671u)));
        if (_e77 < _e184) {
            phi_407_ = _e77;
        } else {
            phi_407_ = _e184;
        }
        let _e187 = phi_407_;
        if (_e90 == 0u) {
            phi_414_ = _e163;
        } else {
            phi_414_ = 0u;
        }
        let _e192 = phi_414_;
        if (_e90 == 0u) {
            phi_419_ = 0u;
        } else {
            phi_419_ = _e163;
        }
        let _e195 = phi_419_;
        if (_e187 == 0u) {
            phi_425_ = _e192;
        } else {
            phi_425_ = (_e187 - 1u);
        }
        let _e199 = phi_425_;
        if (_e187 > _e163) {
            phi_430_ = _e195;
        } else {
            phi_430_ = _e187;
        }
        let _e202 = phi_430_;
        phi_432_ = texture_Axis(_e199, _e202, (_e177 - f32(_e187)));
    }
    let _e205 = phi_432_;
    let _e207 = (*param_7).flags;
    let _e210 = ((_e207 >> bitcast<u32>(6u)) & 3u);
    if (_e210 == 0u) {
        if (param_9 > -8388608f) {
            let _e223 = f32(select(0i, select(select(i32(param_9), i32(-2147483648), (param_9 < bitcast<f32>(3472883712u))), 2147483647i, (param_9 > bitcast<f32>(1325400063u))), (param_9 == param_9)));
            if (_e223 > param_9) {
                phi_460_ = 1f;
            } else {
                phi_460_ = 0f;
            }
            let _e226 = phi_460_;
            if (param_9 < 8388608f) {
                phi_465_ = (_e223 - _e226);
                phi_466_ = false;
            } else {
                phi_465_ = f32();
                phi_466_ = true;
            }
            let _e229 = phi_465_;
            let _e231 = phi_466_;
            phi_467_ = _e229;
            phi_468_ = _e231;
        } else {
            phi_467_ = f32();
            phi_468_ = true;
        }
        let _e233 = phi_467_;
        let _e235 = phi_468_;
        if _e235 {
            phi_472_ = param_9;
        } else {
            phi_472_ = _e233;
        }
        let _e237 = phi_472_;
        phi_520_ = (param_9 - _e237);
    } else {
        if (_e210 == 1u) {
            let _e240 = (param_9 * 0.5f);
            if (_e240 > -8388608f) {
                let _e252 = f32(select(0i, select(select(i32(_e240), i32(-2147483648), (_e240 < bitcast<f32>(3472883712u))), 2147483647i, (_e240 > bitcast<f32>(1325400063u))), (_e240 == _e240)));
                if (_e252 > _e240) {
                    phi_498_ = 1f;
                } else {
                    phi_498_ = 0f;
                }
                let _e255 = phi_498_;
                if (_e240 < 8388608f) {
                    phi_503_ = (_e252 - _e255);
                    phi_504_ = false;
                } else {
                    phi_503_ = f32();
                    phi_504_ = true;
                }
                let _e258 = phi_503_;
                let _e260 = phi_504_;
                phi_505_ = _e258;
                phi_506_ = _e260;
            } else {
                phi_505_ = f32();
                phi_506_ = true;
            }
            let _e262 = phi_505_;
            let _e264 = phi_506_;
            if _e264 {
                phi_510_ = _e240;
            } else {
                phi_510_ = _e262;
            }
            let _e266 = phi_510_;
            let _e268 = (param_9 - (2f * _e266));
            if (_e268 > 1f) {
                phi_518_ = (2f - _e268);
            } else {
                phi_518_ = _e268;
            }
            let _e272 = phi_518_;
            phi_519_ = _e272;
        } else {
            phi_519_ = param_9;
        }
        let _e274 = phi_519_;
        phi_520_ = _e274;
    }
    let _e276 = phi_520_;
    if (_e276 > 0f) {
        if (_e276 < 1f) {
            phi_529_ = _e276;
        } else {
            phi_529_ = 1f;
        }
        let _e280 = phi_529_;
        phi_530_ = _e280;
    } else {
        phi_530_ = 0f;
    }
    let _e282 = phi_530_;
    let _e283 = (_e81 - 1u);
    let _e285 = (_e282 * f32(_e81));
    if _e85 {
        let _e292 = select(select(u32(_e285), 0u, (_e285 < bitcast<f32>(0u))), 4294967295u, (_e285 > bitcast<f32>(1333788671u)));
        if (_e283 < _e292) {
            phi_548_ = _e283;
        } else {
            phi_548_ = _e292;
        }
        let _e295 = phi_548_;
        phi_587_ = texture_Axis(_e295, _e295, 0f);
    } else {
        let _e297 = (_e285 + 0.5f);
        let _e304 = select(select(u32(_e297), 0u, (_e297 < bitcast<f32>(0u))), 4294967295u, (_e297 > bitcast<f32>(1333788671u)));
        if (_e81 < _e304) {
            phi_562_ = _e81;
        } else {
            phi_562_ = _e304;
        }
        let _e307 = phi_562_;
        if (_e210 == 0u) {
            phi_569_ = _e283;
        } else {
            phi_569_ = 0u;
        }
        let _e312 = phi_569_;
        if (_e210 == 0u) {
            phi_574_ = 0u;
        } else {
            phi_574_ = _e283;
        }
        let _e315 = phi_574_;
        if (_e307 == 0u) {
            phi_580_ = _e312;
        } else {
            phi_580_ = (_e307 - 1u);
        }
        let _e319 = phi_580_;
        if (_e307 > _e283) {
            phi_585_ = _e315;
        } else {
            phi_585_ = _e307;
        }
        let _e322 = phi_585_;
        phi_587_ = texture_Axis(_e319, _e322, (_e297 - f32(_e307)));
    }
    let _e325 = phi_587_;
    let _e329 = (*param_7).offset;
    let _e336 = (*param_7).offset;
    let _e343 = (*param_7).offset;
    let _e350 = (*param_7).offset;
    return texture_TexelQuad(array<u32, 4>(((_e329 + (_e325.low * _e77)) + _e205.low), ((_e336 + (_e325.low * _e77)) + _e205.high), ((_e343 + (_e325.high * _e77)) + _e205.low), ((_e350 + (_e325.high * _e77)) + _e205.high)), vec4<f32>(((1f - _e205.fraction) * (1f - _e325.fraction)), (_e205.fraction * (1f - _e325.fraction)), ((1f - _e205.fraction) * _e325.fraction), (_e205.fraction * _e325.fraction)));
}

fn _lt_bvh_ray_Ray_new(param_10: vec3<f32>, param_11: vec3<f32>) -> lt_bvh_Ray {
    return lt_bvh_Ray(param_10, 0f, param_11, 300000000000000000000000000000000000000f);
}

fn _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(param_12: f32, param_13: f32) -> f32 {
    var phi_646_: f32;

    if (param_12 > param_13) {
        phi_646_ = param_12;
    } else {
        phi_646_ = param_13;
    }
    let _e76 = phi_646_;
    return _e76;
}

fn _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(param_14: vec3<f32>) -> vec3<f32> {
    return param_14;
}

fn _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(param_15: vec3<f32>) -> vec3<f32> {
    return param_15;
}

fn function_() {
    var local: texture_TextureView;
    var local_1: texture_TextureView;
    var local_2: lt_bvh_traverse_Stack;
    var phi_805_: bool;
    var phi_806_: bool;
    var phi_807_: bool;
    var phi_811_: bool;
    var phi_812_: bool;
    var phi_813_: bool;
    var phi_814_: bool;
    var phi_815_: bool;
    var phi_816_: bool;
    var phi_817_: bool;
    var phi_818_: bool;
    var phi_819_: bool;
    var phi_820_: bool;
    var phi_821_: bool;
    var phi_822_: bool;
    var phi_823_: bool;
    var phi_824_: bool;
    var phi_825_: bool;
    var phi_826_: bool;
    var phi_827_: bool;
    var phi_828_: bool;
    var phi_832_: bool;
    var phi_836_: bool;
    var phi_911_: f32;
    var phi_918_: f32;
    var phi_926_: f32;
    var phi_933_: f32;
    var phi_941_: f32;
    var phi_948_: f32;
    var phi_973_: f32;
    var phi_978_: f32;
    var phi_983_: f32;
    var phi_1016_: bool;
    var phi_1017_: bool;
    var phi_1025_: u32;
    var phi_1026_: u32;
    var phi_1044_: vec3<f32>;
    var phi_1045_: vec3<f32>;
    var phi_1059_: u32;
    var phi_1064_: u32;
    var phi_1069_: u32;
    var phi_1183_: bool;
    var phi_1184_: bool;
    var phi_1215_: u32;
    var phi_1217_: lt_bvh_Hit;
    var phi_1220_: u32;
    var phi_1305_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1332_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1359_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1365_: u32;
    var phi_1368_: u32;
    var phi_1382_: u32;
    var phi_1392_: u32;
    var phi_1402_: u32;
    var phi_1420_: u32;
    var phi_1430_: u32;
    var phi_1440_: u32;
    var phi_1476_: u32;
    var phi_1489_: u32;
    var phi_1494_: u32;
    var phi_1495_: u32;
    var phi_1496_: u32;
    var phi_1366_: u32;
    var phi_1369_: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_1554_: lt_bvh_Hit;
    var phi_1557_: u32;
    var phi_1603_: vec3<f32>;
    var phi_1604_: vec3<f32>;
    var phi_1635_: vec3<f32>;
    var phi_1636_: vec3<f32>;
    var phi_1667_: vec3<f32>;
    var phi_1668_: vec3<f32>;
    var phi_1686_: bool;
    var phi_1687_: bool;
    var phi_1691_: f32;
    var phi_1692_: f32;
    var phi_1693_: f32;
    var phi_1694_: f32;
    var phi_1702_: f32;
    var phi_1712_: bool;
    var phi_1713_: bool;
    var phi_1717_: f32;
    var phi_1718_: f32;
    var phi_1719_: f32;
    var phi_1720_: f32;
    var phi_1728_: f32;
    var phi_1738_: bool;
    var phi_1739_: bool;
    var phi_1743_: f32;
    var phi_1744_: f32;
    var phi_1745_: f32;
    var phi_1746_: f32;
    var phi_1754_: f32;
    var phi_1769_: f32;
    var phi_1770_: bool;
    var phi_1771_: f32;
    var phi_1772_: bool;
    var phi_1773_: f32;
    var phi_1774_: bool;
    var phi_1792_: f32;
    var phi_1793_: bool;
    var phi_1794_: bool;
    var phi_1795_: f32;
    var phi_1796_: bool;
    var phi_1797_: bool;
    var phi_1801_: bool;
    var phi_1802_: f32;
    var phi_1803_: bool;
    var phi_1833_: vec3<f32>;
    var phi_1834_: vec3<f32>;
    var phi_1859_: vec3<f32>;
    var phi_1860_: vec3<f32>;
    var phi_1885_: vec3<f32>;
    var phi_1886_: vec3<f32>;
    var phi_1944_: f32;
    var phi_1953_: f32;
    var phi_1962_: f32;
    var phi_1971_: f32;
    var phi_1978_: f32;
    var phi_1985_: f32;
    var phi_1998_: f32;
    var phi_2007_: f32;
    var phi_2016_: f32;
    var phi_2025_: f32;
    var phi_2032_: f32;
    var phi_2039_: f32;
    var phi_2062_: f32;
    var phi_2067_: f32;
    var phi_2072_: f32;
    var phi_2080_: f32;
    var phi_2085_: f32;
    var phi_2090_: f32;
    var phi_2102_: f32;
    var phi_2107_: f32;
    var phi_2112_: f32;
    var phi_2117_: f32;
    var phi_2122_: lt_bvh_triangle_Intersection;
    var phi_2123_: bool;
    var phi_2124_: lt_bvh_triangle_Intersection;
    var phi_2125_: bool;
    var phi_2129_: lt_bvh_triangle_Intersection;
    var phi_2130_: bool;
    var phi_2131_: lt_bvh_triangle_Intersection;
    var phi_2132_: bool;
    var phi_2133_: bool;
    var phi_2137_: bool;
    var phi_2141_: lt_bvh_triangle_Intersection;
    var phi_2180_: bool;
    var phi_2181_: bool;
    var phi_2182_: bool;
    var phi_2183_: bool;
    var phi_2184_: bool;
    var phi_2185_: bool;
    var phi_2189_: bool;
    var phi_2190_: bool;
    var phi_2393_: f32;
    var phi_2396_: bool;
    var phi_2397_: bool;
    var phi_2401_: bool;
    var phi_2409_: lt_bvh_Hit;
    var phi_2410_: lt_bvh_Hit;
    var phi_2411_: lt_bvh_Hit;
    var phi_2412_: lt_bvh_Hit;
    var phi_1555_: lt_bvh_Hit;
    var phi_1558_: u32;
    var phi_2413_: bool;
    var phi_2452_: bool;
    var phi_2453_: bool;
    var phi_2484_: u32;
    var phi_1218_: lt_bvh_Hit;
    var phi_1221_: u32;
    var phi_2485_: lt_bvh_Hit;
    var phi_2486_: lt_bvh_Hit;
    var phi_2487_: bool;
    var phi_2491_: lt_bvh_Hit;
    var phi_2555_: f32;
    var phi_2560_: f32;
    var phi_2565_: f32;
    var phi_2576_: f32;
    var phi_2581_: f32;
    var phi_2586_: f32;
    var phi_2662_: vec3<f32>;
    var phi_2905_: vec3<f32>;
    var phi_2920_: u32;
    var phi_2947_: f32;
    var phi_2954_: f32;
    var phi_2961_: f32;
    var phi_2996_: f32;
    var phi_3003_: f32;
    var phi_3010_: f32;
    var phi_3048_: f32;
    var phi_3055_: f32;
    var phi_3062_: f32;
    var phi_3121_: vec3<f32>;
    var phi_3122_: vec3<f32>;
    var phi_3123_: vec3<f32>;
    var phi_3132_: f32;
    var phi_3133_: f32;
    var phi_3143_: f32;
    var phi_3144_: f32;
    var phi_3154_: f32;
    var phi_3155_: f32;
    var phi_3190_: abi_Sample;
    var phi_3281_: vec3<f32>;
    var local_6: lt_bvh_Hit;
    var local_7: lt_bvh_Hit;

    let _e75 = id_1;
    let _e79 = arrayLength((&nodes.member));
    let _e82 = arrayLength((&triangles.member));
    let _e85 = arrayLength((&vertices.member));
    let _e88 = arrayLength((&materials.member));
    let _e94 = arrayLength((&alpha_texels.member));
    let _e97 = arrayLength((&color_texels.member));
    let _e100 = arrayLength((&before.member));
    let _e106 = p.member.size[0u];
    let _e108 = p.member.size[1u];
    let _e109 = lt_shaders_entry_pixel_index(_e75, _e106, _e108);
    if (bitcast<i32>(_e109.word) != 0i) {
        let _e117 = p.member.eye;
        let _e122 = p.member.size[0u];
        let _e126 = ((((f32(_e75.x) + 0.5f) / f32(_e122)) * 2f) - 1f);
        let _e131 = p.member.size[1u];
        let _e135 = (1f - (((f32(_e75.y) + 0.5f) / f32(_e131)) * 2f));
        let _e137 = p.member.forward;
        let _e139 = p.member.right;
        let _e153 = p.member.up;
        let _e164 = _lt_bvh_ray_Ray_new(_e117, vec3<f32>(((_e137.x + (_e139.x * _e126)) + (_e153.x * _e135)), ((_e137.y + (_e139.y * _e126)) + (_e153.y * _e135)), ((_e137.z + (_e139.z * _e126)) + (_e153.z * _e135))));
        let _e166 = lt_bvh_Hit(_e164.tmax, 0f, 0f, 4294967295u, 4294967295u);
        let _e176 = abs(_e164.direction.x);
        let _e178 = abs(_e164.direction.y);
        let _e180 = abs(_e164.direction.z);
        if (abs(_e164.origin.x) < 1000000000000000f) {
            if (abs(_e164.origin.y) < 1000000000000000f) {
                if (abs(_e164.origin.z) < 1000000000000000f) {
                    if (_e176 < 1000000000000000f) {
                        if (_e178 < 1000000000000000f) {
                            if (_e180 < 1000000000000000f) {
                                if (_e176 > 0f) {
                                    phi_806_ = bool();
                                    phi_807_ = true;
                                } else {
                                    let _e188 = (_e178 > 0f);
                                    if _e188 {
                                        phi_805_ = bool();
                                    } else {
                                        phi_805_ = (_e180 > 0f);
                                    }
                                    let _e191 = phi_805_;
                                    phi_806_ = _e191;
                                    phi_807_ = _e188;
                                }
                                let _e193 = phi_806_;
                                let _e195 = phi_807_;
                                if _e195 {
                                    phi_811_ = true;
                                } else {
                                    phi_811_ = _e193;
                                }
                                let _e197 = phi_811_;
                                phi_812_ = _e197;
                                phi_813_ = false;
                            } else {
                                phi_812_ = bool();
                                phi_813_ = true;
                            }
                            let _e199 = phi_812_;
                            let _e201 = phi_813_;
                            phi_814_ = _e199;
                            phi_815_ = false;
                            phi_816_ = _e201;
                        } else {
                            phi_814_ = bool();
                            phi_815_ = true;
                            phi_816_ = false;
                        }
                        let _e203 = phi_814_;
                        let _e205 = phi_815_;
                        let _e207 = phi_816_;
                        phi_817_ = _e203;
                        phi_818_ = _e205;
                        phi_819_ = _e207;
                    } else {
                        phi_817_ = bool();
                        phi_818_ = true;
                        phi_819_ = false;
                    }
                    let _e209 = phi_817_;
                    let _e211 = phi_818_;
                    let _e213 = phi_819_;
                    phi_820_ = _e209;
                    phi_821_ = _e211;
                    phi_822_ = _e213;
                } else {
                    phi_820_ = bool();
                    phi_821_ = true;
                    phi_822_ = false;
                }
                let _e215 = phi_820_;
                let _e217 = phi_821_;
                let _e219 = phi_822_;
                phi_823_ = _e215;
                phi_824_ = _e217;
                phi_825_ = _e219;
            } else {
                phi_823_ = bool();
                phi_824_ = true;
                phi_825_ = false;
            }
            let _e221 = phi_823_;
            let _e223 = phi_824_;
            let _e225 = phi_825_;
            phi_826_ = _e221;
            phi_827_ = _e223;
            phi_828_ = _e225;
        } else {
            phi_826_ = bool();
            phi_827_ = true;
            phi_828_ = false;
        }
        let _e227 = phi_826_;
        let _e229 = phi_827_;
        let _e231 = phi_828_;
        if _e229 {
            phi_832_ = true;
        } else {
            phi_832_ = _e231;
        }
        let _e233 = phi_832_;
        if _e233 {
            phi_836_ = false;
        } else {
            phi_836_ = _e227;
        }
        let _e235 = phi_836_;
        if _e235 {
            let _e236 = (0u >= _e79);
            if _e236 {
                phi_2485_ = lt_bvh_Hit();
            } else {
                if (0u < _e79) {
                } else {
                    return;
                }
                let _e242 = nodes.member[(0u + 0u)].frame[0u];
                let _e246 = nodes.member[(0u + 0u)].frame[1u];
                let _e250 = nodes.member[(0u + 0u)].frame[2u];
                let _e254 = nodes.member[(0u + 0u)].frame[0u];
                let _e258 = nodes.member[(0u + 0u)].frame[1u];
                let _e262 = nodes.member[(0u + 0u)].frame[2u];
                let _e266 = nodes.member[(0u + 0u)].frame[3u];
                let _e304 = core_intrinsics_maximum_number_nsz_f32_(abs(_e164.direction.x), abs(_e164.direction.y));
                let _e305 = core_intrinsics_maximum_number_nsz_f32_(_e304, abs(_e164.direction.z));
                let _e306 = (_e305 * 0.0000000000009094947f);
                if (abs(_e164.direction.x) < _e306) {
                    phi_911_ = _e306;
                } else {
                    phi_911_ = abs(_e164.direction.x);
                }
                let _e313 = phi_911_;
                if (_e164.direction.x < 0f) {
                    phi_918_ = (-1f / _e313);
                } else {
                    phi_918_ = (1f / _e313);
                }
                let _e318 = phi_918_;
                if (abs(_e164.direction.y) < _e306) {
                    phi_926_ = _e306;
                } else {
                    phi_926_ = abs(_e164.direction.y);
                }
                let _e325 = phi_926_;
                if (_e164.direction.y < 0f) {
                    phi_933_ = (-1f / _e325);
                } else {
                    phi_933_ = (1f / _e325);
                }
                let _e330 = phi_933_;
                if (abs(_e164.direction.z) < _e306) {
                    phi_941_ = _e306;
                } else {
                    phi_941_ = abs(_e164.direction.z);
                }
                let _e337 = phi_941_;
                if (_e164.direction.z < 0f) {
                    phi_948_ = (-1f / _e337);
                } else {
                    phi_948_ = (1f / _e337);
                }
                let _e342 = phi_948_;
                let _e350 = abs((bitcast<f32>(_e242) - _e164.origin.x));
                let _e351 = abs((bitcast<f32>(_e246) - _e164.origin.y));
                let _e352 = abs((bitcast<f32>(_e250) - _e164.origin.z));
                let _e360 = abs(((bitcast<f32>(_e254) + (bitcast<f32>((((_e266 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e164.origin.x));
                let _e361 = abs(((bitcast<f32>(_e258) + (bitcast<f32>((((_e266 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e164.origin.y));
                let _e362 = abs(((bitcast<f32>(_e262) + (bitcast<f32>((((_e266 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e164.origin.z));
                if (_e350 > _e360) {
                    phi_973_ = _e350;
                } else {
                    phi_973_ = _e360;
                }
                let _e365 = phi_973_;
                if (_e351 > _e361) {
                    phi_978_ = _e351;
                } else {
                    phi_978_ = _e361;
                }
                let _e368 = phi_978_;
                if (_e352 > _e362) {
                    phi_983_ = _e352;
                } else {
                    phi_983_ = _e362;
                }
                let _e371 = phi_983_;
                let _e372 = core_intrinsics_maximum_number_nsz_f32_(_e365, _e368);
                let _e373 = core_intrinsics_maximum_number_nsz_f32_(_e372, _e371);
                let _e378 = (_e373 * 0.0000019073486f);
                let _e379 = (abs(_e318) * _e378);
                let _e380 = (abs(_e330) * _e378);
                let _e381 = (abs(_e342) * _e378);
                let _e385 = (_e373 * 0.0000009536743f);
                let _e386 = (abs(_e318) * _e385);
                let _e387 = (abs(_e330) * _e385);
                let _e388 = (abs(_e342) * _e385);
                let _e391 = abs(_e164.direction.x);
                let _e393 = abs(_e164.direction.y);
                let _e395 = abs(_e164.direction.z);
                if (_e391 >= _e393) {
                    if (_e391 >= _e395) {
                        phi_1016_ = false;
                    } else {
                        phi_1016_ = true;
                    }
                    let _e399 = phi_1016_;
                    phi_1017_ = _e399;
                } else {
                    phi_1017_ = true;
                }
                let _e401 = phi_1017_;
                if _e401 {
                    if (_e393 >= _e395) {
                        phi_1025_ = 1u;
                    } else {
                        phi_1025_ = 2u;
                    }
                    let _e404 = phi_1025_;
                    phi_1026_ = _e404;
                } else {
                    phi_1026_ = 0u;
                }
                let _e406 = phi_1026_;
                if (_e406 == 0u) {
                    phi_1045_ = vec3<f32>(_e164.direction.y, _e164.direction.z, _e164.direction.x);
                } else {
                    if (_e406 == 1u) {
                        phi_1044_ = vec3<f32>(_e164.direction.z, _e164.direction.x, _e164.direction.y);
                    } else {
                        phi_1044_ = _e164.direction;
                    }
                    let _e419 = phi_1044_;
                    phi_1045_ = _e419;
                }
                let _e421 = phi_1045_;
                let _e425 = (_e421.x / _e421.z);
                let _e428 = (_e421.y / _e421.z);
                if (_e318 < 0f) {
                    phi_1059_ = 0u;
                } else {
                    phi_1059_ = 1u;
                }
                let _e433 = phi_1059_;
                if (_e330 < 0f) {
                    phi_1064_ = 0u;
                } else {
                    phi_1064_ = 2u;
                }
                let _e436 = phi_1064_;
                if (_e342 < 0f) {
                    phi_1069_ = 0u;
                } else {
                    phi_1069_ = 4u;
                }
                let _e439 = phi_1069_;
                let _e441 = ((_e433 | _e436) | _e439);
                let _e442 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e442.first[0], _e442.first[1], _e442.first[2], _e442.first[3], _e442.first[4], _e442.first[5], _e442.first[6], _e442.first[7], _e442.first[8], _e442.first[9], _e442.first[10], _e442.first[11], _e442.first[12], _e442.first[13], _e442.first[14], _e442.first[15], _e442.first[16], _e442.first[17], _e442.first[18], _e442.first[19], _e442.first[20], _e442.first[21], _e442.first[22], _e442.first[23], _e442.first[24], _e442.first[25], _e442.first[26], _e442.first[27], _e442.first[28], _e442.first[29], _e442.first[30], _e442.first[31]), array<u32, 32>(_e442.mask[0], _e442.mask[1], _e442.mask[2], _e442.mask[3], _e442.mask[4], _e442.mask[5], _e442.mask[6], _e442.mask[7], _e442.mask[8], _e442.mask[9], _e442.mask[10], _e442.mask[11], _e442.mask[12], _e442.mask[13], _e442.mask[14], _e442.mask[15], _e442.mask[16], _e442.mask[17], _e442.mask[18], _e442.mask[19], _e442.mask[20], _e442.mask[21], _e442.mask[22], _e442.mask[23], _e442.mask[24], _e442.mask[25], _e442.mask[26], _e442.mask[27], _e442.mask[28], _e442.mask[29], _e442.mask[30], _e442.mask[31]), _e442.len, _e442.group, _e442.group_mask);
                let _e516 = local_2.group_mask;
                if ((_e516 & 4278190080u) == 0u) {
                    let _e520 = local_2.len;
                    if (_e520 == 0u) {
                        phi_1183_ = false;
                    } else {
                        let _e524 = local_2.len;
                        local_2.len = (_e524 - 1u);
                        let _e527 = local_2.len;
                        if (_e527 < 32u) {
                        } else {
                            return;
                        }
                        let _e532 = local_2.first[(0u + _e527)];
                        local_2.group = _e532;
                        let _e535 = local_2.len;
                        if (_e535 < 32u) {
                        } else {
                            return;
                        }
                        let _e540 = local_2.mask[(0u + _e535)];
                        local_2.group_mask = _e540;
                        phi_1183_ = true;
                    }
                    let _e543 = phi_1183_;
                    phi_1184_ = _e543;
                } else {
                    phi_1184_ = true;
                }
                let _e545 = phi_1184_;
                if _e545 {
                    let _e547 = local_2.group_mask;
                    let _e553 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e547)), 32u, (_e547 == 0u)));
                    let _e557 = local_2.group_mask;
                    let _e571 = local_2.group_mask;
                    local_2.group_mask = (_e571 & ~((1u << bitcast<u32>((_e553 & 31u)))));
                    let _e574 = local_2.group;
                    phi_1215_ = (_e574 + countOneBits(((_e557 & ~((4294967295u << bitcast<u32>((((_e553 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1215_ = 4294967295u;
                }
                let _e577 = phi_1215_;
                phi_1217_ = _e166;
                phi_1220_ = _e577;
                loop {
                    let _e579 = phi_1217_;
                    let _e581 = phi_1220_;
                    local_7 = _e579;
                    let _e582 = (_e581 != 4294967295u);
                    if _e582 {
                        if (_e581 < _e79) {
                        } else {
                            return;
                        }
                        let _e590 = nodes.member[(0u + _e581)].frame[3u];
                        let _e615 = (bitcast<f32>((((_e590 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e318);
                        let _e616 = (bitcast<f32>((((_e590 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e330);
                        let _e617 = (bitcast<f32>((((_e590 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e342);
                        let _e620 = nodes.member[(0u + _e581)].frame[0u];
                        let _e624 = nodes.member[(0u + _e581)].frame[1u];
                        let _e628 = nodes.member[(0u + _e581)].frame[2u];
                        let _e636 = ((bitcast<f32>(_e620) - _e164.origin.x) * _e318);
                        let _e637 = ((bitcast<f32>(_e624) - _e164.origin.y) * _e330);
                        let _e638 = ((bitcast<f32>(_e628) - _e164.origin.z) * _e342);
                        let _e646 = nodes.member[(0u + _e581)].x;
                        if (_e318 < 0f) {
                            let _e657 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e646.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e663 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e657.unnamed.word, _e646.w), _e657.unnamed_1);
                            let _e669 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e663.unnamed, lt_mask_LightPlace(_e646.x, _e663.unnamed_1.shift));
                            phi_1305_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e669.unnamed, lt_mask_LightPlace(_e669.unnamed_1.word, _e646.y));
                        } else {
                            let _e685 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e646.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e691 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e685.unnamed.word, _e646.y), _e685.unnamed_1);
                            let _e697 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e691.unnamed, lt_mask_LightPlace(_e646.z, _e691.unnamed_1.shift));
                            phi_1305_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e697.unnamed, lt_mask_LightPlace(_e697.unnamed_1.word, _e646.w));
                        }
                        let _e705 = phi_1305_;
                        let _e715 = nodes.member[(0u + _e581)].y;
                        if (_e330 < 0f) {
                            let _e726 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e715.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e732 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e726.unnamed.word, _e715.w), _e726.unnamed_1);
                            let _e738 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e732.unnamed, lt_mask_LightPlace(_e715.x, _e732.unnamed_1.shift));
                            phi_1332_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e738.unnamed, lt_mask_LightPlace(_e738.unnamed_1.word, _e715.y));
                        } else {
                            let _e754 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e715.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e760 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e754.unnamed.word, _e715.y), _e754.unnamed_1);
                            let _e766 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e760.unnamed, lt_mask_LightPlace(_e715.z, _e760.unnamed_1.shift));
                            phi_1332_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e766.unnamed, lt_mask_LightPlace(_e766.unnamed_1.word, _e715.w));
                        }
                        let _e774 = phi_1332_;
                        let _e784 = nodes.member[(0u + _e581)].z;
                        if (_e342 < 0f) {
                            let _e795 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e784.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e801 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e795.unnamed.word, _e784.w), _e795.unnamed_1);
                            let _e807 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e801.unnamed, lt_mask_LightPlace(_e784.x, _e801.unnamed_1.shift));
                            phi_1359_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e807.unnamed, lt_mask_LightPlace(_e807.unnamed_1.word, _e784.y));
                        } else {
                            let _e823 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e784.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e829 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e823.unnamed.word, _e784.y), _e823.unnamed_1);
                            let _e835 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e829.unnamed, lt_mask_LightPlace(_e784.z, _e829.unnamed_1.shift));
                            phi_1359_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e835.unnamed, lt_mask_LightPlace(_e835.unnamed_1.word, _e784.w));
                        }
                        let _e843 = phi_1359_;
                        phi_1365_ = 0u;
                        phi_1368_ = 0u;
                        loop {
                            let _e853 = phi_1365_;
                            let _e855 = phi_1368_;
                            local_3 = _e855;
                            local_4 = _e855;
                            local_5 = _e855;
                            let _e856 = (_e853 < 8u);
                            if _e856 {
                                let _e858 = (_e853 >> bitcast<u32>(2i));
                                let _e859 = (_e853 & 3u);
                                if (_e858 == 0u) {
                                    phi_1382_ = _e705.unnamed.word;
                                } else {
                                    phi_1382_ = _e705.unnamed.shift;
                                }
                                let _e862 = phi_1382_;
                                if (_e858 == 0u) {
                                    phi_1392_ = _e774.unnamed.word;
                                } else {
                                    phi_1392_ = _e774.unnamed.shift;
                                }
                                let _e871 = phi_1392_;
                                if (_e858 == 0u) {
                                    phi_1402_ = _e843.unnamed.word;
                                } else {
                                    phi_1402_ = _e843.unnamed.shift;
                                }
                                let _e880 = phi_1402_;
                                let _e893 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e862 >> bitcast<u32>(((_e859 * 8u) & 31u))) & 255u)) * _e615) + (_e636 - _e379)), ((f32(((_e871 >> bitcast<u32>(((_e859 * 8u) & 31u))) & 255u)) * _e616) + (_e637 - _e380)));
                                let _e894 = core_intrinsics_maximum_number_nsz_f32_(_e893, ((f32(((_e880 >> bitcast<u32>(((_e859 * 8u) & 31u))) & 255u)) * _e617) + (_e638 - _e381)));
                                if (_e858 == 0u) {
                                    phi_1420_ = _e705.unnamed_1.word;
                                } else {
                                    phi_1420_ = _e705.unnamed_1.shift;
                                }
                                let _e897 = phi_1420_;
                                if (_e858 == 0u) {
                                    phi_1430_ = _e774.unnamed_1.word;
                                } else {
                                    phi_1430_ = _e774.unnamed_1.shift;
                                }
                                let _e906 = phi_1430_;
                                if (_e858 == 0u) {
                                    phi_1440_ = _e843.unnamed_1.word;
                                } else {
                                    phi_1440_ = _e843.unnamed_1.shift;
                                }
                                let _e915 = phi_1440_;
                                let _e928 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e897 >> bitcast<u32>(((_e859 * 8u) & 31u))) & 255u)) * _e615) + (_e636 + _e379)), ((f32(((_e906 >> bitcast<u32>(((_e859 * 8u) & 31u))) & 255u)) * _e616) + (_e637 + _e380)));
                                let _e929 = core_intrinsics_minimum_number_nsz_f32_(_e928, ((f32(((_e915 >> bitcast<u32>(((_e859 * 8u) & 31u))) & 255u)) * _e617) + (_e638 + _e381)));
                                if (_e894 <= _e929) {
                                    if (_e894 <= _e579.t) {
                                        if (_e929 >= _e164.tmin) {
                                            if (_e858 == 0u) {
                                                let _e936 = nodes.member[(0u + _e581)].links[2u];
                                                phi_1476_ = _e936;
                                            } else {
                                                let _e939 = nodes.member[(0u + _e581)].links[3u];
                                                phi_1476_ = _e939;
                                            }
                                            let _e941 = phi_1476_;
                                            let _e946 = ((_e941 >> bitcast<u32>(((_e859 * 8u) & 31u))) & 255u);
                                            let _e947 = (_e946 & 31u);
                                            if (_e947 >= 24u) {
                                                phi_1489_ = (24u + ((_e947 - 24u) ^ _e441));
                                            } else {
                                                phi_1489_ = _e947;
                                            }
                                            let _e953 = phi_1489_;
                                            phi_1494_ = (_e855 | ((_e946 >> bitcast<u32>(5i)) << bitcast<u32>((_e953 & 31u))));
                                        } else {
                                            phi_1494_ = _e855;
                                        }
                                        let _e961 = phi_1494_;
                                        phi_1495_ = _e961;
                                    } else {
                                        phi_1495_ = _e855;
                                    }
                                    let _e963 = phi_1495_;
                                    phi_1496_ = _e963;
                                } else {
                                    phi_1496_ = _e855;
                                }
                                let _e965 = phi_1496_;
                                phi_1366_ = (_e853 + 1u);
                                phi_1369_ = _e965;
                            } else {
                                phi_1366_ = u32();
                                phi_1369_ = u32();
                            }
                            let _e968 = phi_1366_;
                            let _e970 = phi_1369_;
                            continue;
                            continuing {
                                phi_1365_ = _e968;
                                phi_1368_ = _e970;
                                break if !(_e856);
                            }
                        }
                        let _e974 = nodes.member[(0u + _e581)].links[0u];
                        let _e978 = nodes.member[(0u + _e581)].frame[3u];
                        let _e982 = local_3;
                        if ((_e982 & 4278190080u) == 0u) {
                        } else {
                            let _e986 = local_2.group_mask;
                            if ((_e986 & 4278190080u) == 0u) {
                            } else {
                                let _e990 = local_2.len;
                                if (_e990 < 32u) {
                                    let _e993 = local_2.group;
                                    let _e995 = local_2.len;
                                    if (_e995 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.first[(0u + _e995)] = _e993;
                                    let _e1001 = local_2.group_mask;
                                    let _e1003 = local_2.len;
                                    if (_e1003 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.mask[(0u + _e1003)] = _e1001;
                                    let _e1010 = local_2.len;
                                    local_2.len = (_e1010 + 1u);
                                }
                            }
                            local_2.group = (0u + _e974);
                            let _e1014 = local_4;
                            local_2.group_mask = ((_e1014 & 4278190080u) | (_e978 >> bitcast<u32>(24i)));
                        }
                        let _e1019 = local_5;
                        phi_1554_ = _e579;
                        phi_1557_ = (_e1019 & 16777215u);
                        loop {
                            let _e1022 = phi_1554_;
                            let _e1024 = phi_1557_;
                            local_6 = _e1022;
                            if (_e1024 == 0u) {
                                phi_1555_ = lt_bvh_Hit();
                                phi_1558_ = u32();
                                phi_2413_ = false;
                            } else {
                                let _e1028 = nodes.member[(0u + _e581)].links[1u];
                                let _e1033 = ((0u + _e1028) + select(firstTrailingBit(_e1024), 32u, (_e1024 == 0u)));
                                if (_e1033 < _e82) {
                                } else {
                                    return;
                                }
                                let _e1040 = triangles.member[(0u + _e1033)].v0_;
                                let _e1043 = (_e1040.x - _e164.origin.x);
                                let _e1046 = (_e1040.y - _e164.origin.y);
                                let _e1049 = (_e1040.z - _e164.origin.z);
                                if (_e406 == 0u) {
                                    phi_1604_ = vec3<f32>(_e1046, _e1049, _e1043);
                                } else {
                                    if (_e406 == 1u) {
                                        phi_1603_ = vec3<f32>(_e1049, _e1043, _e1046);
                                    } else {
                                        phi_1603_ = (_e1040 - _e164.origin);
                                    }
                                    let _e1056 = phi_1603_;
                                    phi_1604_ = _e1056;
                                }
                                let _e1058 = phi_1604_;
                                let _e1062 = (_e1058.x - (_e425 * _e1058.z));
                                let _e1066 = (_e1058.y - (_e428 * _e1058.z));
                                let _e1068 = triangles.member[(0u + _e1033)].v1_;
                                let _e1071 = (_e1068.x - _e164.origin.x);
                                let _e1074 = (_e1068.y - _e164.origin.y);
                                let _e1077 = (_e1068.z - _e164.origin.z);
                                if (_e406 == 0u) {
                                    phi_1636_ = vec3<f32>(_e1074, _e1077, _e1071);
                                } else {
                                    if (_e406 == 1u) {
                                        phi_1635_ = vec3<f32>(_e1077, _e1071, _e1074);
                                    } else {
                                        phi_1635_ = (_e1068 - _e164.origin);
                                    }
                                    let _e1084 = phi_1635_;
                                    phi_1636_ = _e1084;
                                }
                                let _e1086 = phi_1636_;
                                let _e1090 = (_e1086.x - (_e425 * _e1086.z));
                                let _e1094 = (_e1086.y - (_e428 * _e1086.z));
                                let _e1096 = triangles.member[(0u + _e1033)].v2_;
                                let _e1099 = (_e1096.x - _e164.origin.x);
                                let _e1102 = (_e1096.y - _e164.origin.y);
                                let _e1105 = (_e1096.z - _e164.origin.z);
                                if (_e406 == 0u) {
                                    phi_1668_ = vec3<f32>(_e1102, _e1105, _e1099);
                                } else {
                                    if (_e406 == 1u) {
                                        phi_1667_ = vec3<f32>(_e1105, _e1099, _e1102);
                                    } else {
                                        phi_1667_ = (_e1096 - _e164.origin);
                                    }
                                    let _e1112 = phi_1667_;
                                    phi_1668_ = _e1112;
                                }
                                let _e1114 = phi_1668_;
                                let _e1118 = (_e1114.x - (_e425 * _e1114.z));
                                let _e1122 = (_e1114.y - (_e428 * _e1114.z));
                                if (_e1090 < _e1118) {
                                    phi_1687_ = true;
                                } else {
                                    if (_e1090 == _e1118) {
                                        phi_1686_ = (_e1094 < _e1122);
                                    } else {
                                        phi_1686_ = false;
                                    }
                                    let _e1127 = phi_1686_;
                                    phi_1687_ = _e1127;
                                }
                                let _e1129 = phi_1687_;
                                if _e1129 {
                                    phi_1691_ = _e1122;
                                    phi_1692_ = _e1118;
                                    phi_1693_ = _e1094;
                                    phi_1694_ = _e1090;
                                } else {
                                    phi_1691_ = _e1094;
                                    phi_1692_ = _e1090;
                                    phi_1693_ = _e1122;
                                    phi_1694_ = _e1118;
                                }
                                let _e1131 = phi_1691_;
                                let _e1133 = phi_1692_;
                                let _e1135 = phi_1693_;
                                let _e1137 = phi_1694_;
                                let _e1140 = ((_e1137 * _e1131) - (_e1135 * _e1133));
                                if _e1129 {
                                    phi_1702_ = -(_e1140);
                                } else {
                                    phi_1702_ = _e1140;
                                }
                                let _e1143 = phi_1702_;
                                if (_e1118 < _e1062) {
                                    phi_1713_ = true;
                                } else {
                                    if (_e1118 == _e1062) {
                                        phi_1712_ = (_e1122 < _e1066);
                                    } else {
                                        phi_1712_ = false;
                                    }
                                    let _e1148 = phi_1712_;
                                    phi_1713_ = _e1148;
                                }
                                let _e1150 = phi_1713_;
                                if _e1150 {
                                    phi_1717_ = _e1066;
                                    phi_1718_ = _e1062;
                                    phi_1719_ = _e1122;
                                    phi_1720_ = _e1118;
                                } else {
                                    phi_1717_ = _e1122;
                                    phi_1718_ = _e1118;
                                    phi_1719_ = _e1066;
                                    phi_1720_ = _e1062;
                                }
                                let _e1152 = phi_1717_;
                                let _e1154 = phi_1718_;
                                let _e1156 = phi_1719_;
                                let _e1158 = phi_1720_;
                                let _e1161 = ((_e1158 * _e1152) - (_e1156 * _e1154));
                                if _e1150 {
                                    phi_1728_ = -(_e1161);
                                } else {
                                    phi_1728_ = _e1161;
                                }
                                let _e1164 = phi_1728_;
                                if (_e1062 < _e1090) {
                                    phi_1739_ = true;
                                } else {
                                    if (_e1062 == _e1090) {
                                        phi_1738_ = (_e1066 < _e1094);
                                    } else {
                                        phi_1738_ = false;
                                    }
                                    let _e1169 = phi_1738_;
                                    phi_1739_ = _e1169;
                                }
                                let _e1171 = phi_1739_;
                                if _e1171 {
                                    phi_1743_ = _e1094;
                                    phi_1744_ = _e1090;
                                    phi_1745_ = _e1066;
                                    phi_1746_ = _e1062;
                                } else {
                                    phi_1743_ = _e1066;
                                    phi_1744_ = _e1062;
                                    phi_1745_ = _e1094;
                                    phi_1746_ = _e1090;
                                }
                                let _e1173 = phi_1743_;
                                let _e1175 = phi_1744_;
                                let _e1177 = phi_1745_;
                                let _e1179 = phi_1746_;
                                let _e1182 = ((_e1179 * _e1173) - (_e1177 * _e1175));
                                if _e1171 {
                                    phi_1754_ = -(_e1182);
                                } else {
                                    phi_1754_ = _e1182;
                                }
                                let _e1185 = phi_1754_;
                                if (_e1143 >= 0f) {
                                    if (_e1164 >= 0f) {
                                        if (_e1185 >= 0f) {
                                            phi_1769_ = ((_e1143 + _e1164) + _e1185);
                                            phi_1770_ = false;
                                        } else {
                                            phi_1769_ = f32();
                                            phi_1770_ = true;
                                        }
                                        let _e1192 = phi_1769_;
                                        let _e1194 = phi_1770_;
                                        phi_1771_ = _e1192;
                                        phi_1772_ = _e1194;
                                    } else {
                                        phi_1771_ = f32();
                                        phi_1772_ = true;
                                    }
                                    let _e1196 = phi_1771_;
                                    let _e1198 = phi_1772_;
                                    phi_1773_ = _e1196;
                                    phi_1774_ = _e1198;
                                } else {
                                    phi_1773_ = f32();
                                    phi_1774_ = true;
                                }
                                let _e1200 = phi_1773_;
                                let _e1202 = phi_1774_;
                                if _e1202 {
                                    if (_e1143 <= 0f) {
                                        if (_e1164 <= 0f) {
                                            let _e1205 = (_e1185 <= 0f);
                                            if _e1205 {
                                            }
                                            phi_1792_ = ((_e1143 + _e1164) + _e1185);
                                            phi_1793_ = false;
                                            phi_1794_ = _e1205;
                                        } else {
                                            phi_1792_ = f32();
                                            phi_1793_ = true;
                                            phi_1794_ = false;
                                        }
                                        let _e1209 = phi_1792_;
                                        let _e1211 = phi_1793_;
                                        let _e1213 = phi_1794_;
                                        phi_1795_ = _e1209;
                                        phi_1796_ = _e1211;
                                        phi_1797_ = _e1213;
                                    } else {
                                        phi_1795_ = f32();
                                        phi_1796_ = true;
                                        phi_1797_ = false;
                                    }
                                    let _e1215 = phi_1795_;
                                    let _e1217 = phi_1796_;
                                    let _e1219 = phi_1797_;
                                    if _e1217 {
                                        phi_1801_ = false;
                                    } else {
                                        phi_1801_ = _e1219;
                                    }
                                    let _e1221 = phi_1801_;
                                    phi_1802_ = _e1215;
                                    phi_1803_ = _e1221;
                                } else {
                                    phi_1802_ = _e1200;
                                    phi_1803_ = true;
                                }
                                let _e1223 = phi_1802_;
                                let _e1225 = phi_1803_;
                                if _e1225 {
                                    let _e1226 = (_e1223 == 0f);
                                    if _e1226 {
                                        phi_2129_ = lt_bvh_triangle_Intersection();
                                        phi_2130_ = false;
                                    } else {
                                        let _e1228 = triangles.member[(0u + _e1033)].v0_;
                                        let _e1231 = (_e1228.x - _e164.origin.x);
                                        let _e1234 = (_e1228.y - _e164.origin.y);
                                        let _e1237 = (_e1228.z - _e164.origin.z);
                                        if (_e406 == 0u) {
                                            phi_1834_ = vec3<f32>(_e1234, _e1237, _e1231);
                                        } else {
                                            if (_e406 == 1u) {
                                                phi_1833_ = vec3<f32>(_e1237, _e1231, _e1234);
                                            } else {
                                                phi_1833_ = (_e1228 - _e164.origin);
                                            }
                                            let _e1244 = phi_1833_;
                                            phi_1834_ = _e1244;
                                        }
                                        let _e1246 = phi_1834_;
                                        let _e1248 = triangles.member[(0u + _e1033)].v1_;
                                        let _e1250 = triangles.member[(0u + _e1033)].v0_;
                                        let _e1253 = (_e1248.x - _e1250.x);
                                        let _e1256 = (_e1248.y - _e1250.y);
                                        let _e1259 = (_e1248.z - _e1250.z);
                                        if (_e406 == 0u) {
                                            phi_1860_ = vec3<f32>(_e1256, _e1259, _e1253);
                                        } else {
                                            if (_e406 == 1u) {
                                                phi_1859_ = vec3<f32>(_e1259, _e1253, _e1256);
                                            } else {
                                                phi_1859_ = (_e1248 - _e1250);
                                            }
                                            let _e1266 = phi_1859_;
                                            phi_1860_ = _e1266;
                                        }
                                        let _e1268 = phi_1860_;
                                        let _e1270 = triangles.member[(0u + _e1033)].v2_;
                                        let _e1272 = triangles.member[(0u + _e1033)].v0_;
                                        let _e1275 = (_e1270.x - _e1272.x);
                                        let _e1278 = (_e1270.y - _e1272.y);
                                        let _e1281 = (_e1270.z - _e1272.z);
                                        if (_e406 == 0u) {
                                            phi_1886_ = vec3<f32>(_e1278, _e1281, _e1275);
                                        } else {
                                            if (_e406 == 1u) {
                                                phi_1885_ = vec3<f32>(_e1281, _e1275, _e1278);
                                            } else {
                                                phi_1885_ = (_e1270 - _e1272);
                                            }
                                            let _e1288 = phi_1885_;
                                            phi_1886_ = _e1288;
                                        }
                                        let _e1290 = phi_1886_;
                                        let _e1297 = ((_e1268.y * _e1290.z) - (_e1268.z * _e1290.y));
                                        let _e1304 = ((_e1268.z * _e1290.x) - (_e1268.x * _e1290.z));
                                        let _e1311 = ((_e1268.x * _e1290.y) - (_e1268.y * _e1290.x));
                                        let _e1325 = (((1f / _e421.z) * (((_e1297 * _e1246.x) + (_e1304 * _e1246.y)) + (_e1311 * _e1246.z))) / (((_e1297 * _e425) + (_e1304 * _e428)) + _e1311));
                                        if (_e1325 > _e164.tmin) {
                                            if (_e1325 < _e164.tmax) {
                                                let _e1331 = triangles.member[(0u + _e1033)].v0_;
                                                let _e1333 = triangles.member[(0u + _e1033)].v1_;
                                                if (_e1331.x < _e1333.x) {
                                                    phi_1944_ = _e1331.x;
                                                } else {
                                                    phi_1944_ = _e1333.x;
                                                }
                                                let _e1340 = phi_1944_;
                                                if (_e1331.y < _e1333.y) {
                                                    phi_1953_ = _e1331.y;
                                                } else {
                                                    phi_1953_ = _e1333.y;
                                                }
                                                let _e1347 = phi_1953_;
                                                if (_e1331.z < _e1333.z) {
                                                    phi_1962_ = _e1331.z;
                                                } else {
                                                    phi_1962_ = _e1333.z;
                                                }
                                                let _e1354 = phi_1962_;
                                                let _e1356 = triangles.member[(0u + _e1033)].v2_;
                                                if (_e1340 < _e1356.x) {
                                                    phi_1971_ = _e1340;
                                                } else {
                                                    phi_1971_ = _e1356.x;
                                                }
                                                let _e1361 = phi_1971_;
                                                if (_e1347 < _e1356.y) {
                                                    phi_1978_ = _e1347;
                                                } else {
                                                    phi_1978_ = _e1356.y;
                                                }
                                                let _e1366 = phi_1978_;
                                                if (_e1354 < _e1356.z) {
                                                    phi_1985_ = _e1354;
                                                } else {
                                                    phi_1985_ = _e1356.z;
                                                }
                                                let _e1371 = phi_1985_;
                                                let _e1373 = triangles.member[(0u + _e1033)].v0_;
                                                let _e1375 = triangles.member[(0u + _e1033)].v1_;
                                                if (_e1373.x > _e1375.x) {
                                                    phi_1998_ = _e1373.x;
                                                } else {
                                                    phi_1998_ = _e1375.x;
                                                }
                                                let _e1382 = phi_1998_;
                                                if (_e1373.y > _e1375.y) {
                                                    phi_2007_ = _e1373.y;
                                                } else {
                                                    phi_2007_ = _e1375.y;
                                                }
                                                let _e1389 = phi_2007_;
                                                if (_e1373.z > _e1375.z) {
                                                    phi_2016_ = _e1373.z;
                                                } else {
                                                    phi_2016_ = _e1375.z;
                                                }
                                                let _e1396 = phi_2016_;
                                                let _e1398 = triangles.member[(0u + _e1033)].v2_;
                                                if (_e1382 > _e1398.x) {
                                                    phi_2025_ = _e1382;
                                                } else {
                                                    phi_2025_ = _e1398.x;
                                                }
                                                let _e1403 = phi_2025_;
                                                if (_e1389 > _e1398.y) {
                                                    phi_2032_ = _e1389;
                                                } else {
                                                    phi_2032_ = _e1398.y;
                                                }
                                                let _e1408 = phi_2032_;
                                                if (_e1396 > _e1398.z) {
                                                    phi_2039_ = _e1396;
                                                } else {
                                                    phi_2039_ = _e1398.z;
                                                }
                                                let _e1413 = phi_2039_;
                                                let _e1420 = ((_e1361 - _e164.origin.x) * _e318);
                                                let _e1421 = ((_e1366 - _e164.origin.y) * _e330);
                                                let _e1422 = ((_e1371 - _e164.origin.z) * _e342);
                                                let _e1429 = ((_e1403 - _e164.origin.x) * _e318);
                                                let _e1430 = ((_e1408 - _e164.origin.y) * _e330);
                                                let _e1431 = ((_e1413 - _e164.origin.z) * _e342);
                                                if (_e1420 < _e1429) {
                                                    phi_2062_ = _e1420;
                                                } else {
                                                    phi_2062_ = _e1429;
                                                }
                                                let _e1434 = phi_2062_;
                                                if (_e1421 < _e1430) {
                                                    phi_2067_ = _e1421;
                                                } else {
                                                    phi_2067_ = _e1430;
                                                }
                                                let _e1437 = phi_2067_;
                                                if (_e1422 < _e1431) {
                                                    phi_2072_ = _e1422;
                                                } else {
                                                    phi_2072_ = _e1431;
                                                }
                                                let _e1440 = phi_2072_;
                                                if (_e1420 > _e1429) {
                                                    phi_2080_ = _e1420;
                                                } else {
                                                    phi_2080_ = _e1429;
                                                }
                                                let _e1446 = phi_2080_;
                                                if (_e1421 > _e1430) {
                                                    phi_2085_ = _e1421;
                                                } else {
                                                    phi_2085_ = _e1430;
                                                }
                                                let _e1449 = phi_2085_;
                                                if (_e1422 > _e1431) {
                                                    phi_2090_ = _e1422;
                                                } else {
                                                    phi_2090_ = _e1431;
                                                }
                                                let _e1452 = phi_2090_;
                                                let _e1456 = core_intrinsics_maximum_number_nsz_f32_((_e1434 - _e386), (_e1437 - _e387));
                                                let _e1457 = core_intrinsics_maximum_number_nsz_f32_(_e1456, (_e1440 - _e388));
                                                let _e1458 = core_intrinsics_minimum_number_nsz_f32_((_e1446 + _e386), (_e1449 + _e387));
                                                let _e1459 = core_intrinsics_minimum_number_nsz_f32_(_e1458, (_e1452 + _e388));
                                                if (_e1457 > -300000000000000000000000000000000000000f) {
                                                    phi_2102_ = _e1457;
                                                } else {
                                                    phi_2102_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1462 = phi_2102_;
                                                if (_e1459 < 300000000000000000000000000000000000000f) {
                                                    phi_2107_ = _e1459;
                                                } else {
                                                    phi_2107_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1465 = phi_2107_;
                                                if (_e1325 < _e1462) {
                                                    phi_2112_ = _e1462;
                                                } else {
                                                    phi_2112_ = _e1325;
                                                }
                                                let _e1468 = phi_2112_;
                                                if (_e1468 > _e1465) {
                                                    phi_2117_ = _e1465;
                                                } else {
                                                    phi_2117_ = _e1468;
                                                }
                                                let _e1471 = phi_2117_;
                                                phi_2122_ = lt_bvh_triangle_Intersection(_e1471, (_e1164 / _e1223), (_e1185 / _e1223), (_e1462 <= _e1465));
                                                phi_2123_ = false;
                                            } else {
                                                phi_2122_ = lt_bvh_triangle_Intersection();
                                                phi_2123_ = true;
                                            }
                                            let _e1477 = phi_2122_;
                                            let _e1479 = phi_2123_;
                                            phi_2124_ = _e1477;
                                            phi_2125_ = _e1479;
                                        } else {
                                            phi_2124_ = lt_bvh_triangle_Intersection();
                                            phi_2125_ = true;
                                        }
                                        let _e1481 = phi_2124_;
                                        let _e1483 = phi_2125_;
                                        if _e1483 {
                                        }
                                        phi_2129_ = _e1481;
                                        phi_2130_ = _e1483;
                                    }
                                    let _e1485 = phi_2129_;
                                    let _e1487 = phi_2130_;
                                    phi_2131_ = _e1485;
                                    phi_2132_ = _e1226;
                                    phi_2133_ = _e1487;
                                } else {
                                    phi_2131_ = lt_bvh_triangle_Intersection();
                                    phi_2132_ = true;
                                    phi_2133_ = false;
                                }
                                let _e1489 = phi_2131_;
                                let _e1491 = phi_2132_;
                                let _e1493 = phi_2133_;
                                if _e1491 {
                                    phi_2137_ = true;
                                } else {
                                    phi_2137_ = _e1493;
                                }
                                let _e1495 = phi_2137_;
                                if _e1495 {
                                    phi_2141_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_2141_ = _e1489;
                                }
                                let _e1497 = phi_2141_;
                                if _e1497.is_hit {
                                    if (_e1497.t > _e164.tmin) {
                                        if (_e1497.t < _e1022.t) {
                                            phi_2190_ = true;
                                        } else {
                                            if (_e1497.t == _e1022.t) {
                                                if (_e1022.triangle != 4294967295u) {
                                                    if (_e1033 < _e1022.triangle) {
                                                        phi_2181_ = true;
                                                    } else {
                                                        if (_e1033 == _e1022.triangle) {
                                                            phi_2180_ = (4294967295u < _e1022.instance);
                                                        } else {
                                                            phi_2180_ = false;
                                                        }
                                                        let _e1516 = phi_2180_;
                                                        phi_2181_ = _e1516;
                                                    }
                                                    let _e1518 = phi_2181_;
                                                    phi_2182_ = _e1518;
                                                    phi_2183_ = false;
                                                } else {
                                                    phi_2182_ = bool();
                                                    phi_2183_ = true;
                                                }
                                                let _e1520 = phi_2182_;
                                                let _e1522 = phi_2183_;
                                                phi_2184_ = _e1520;
                                                phi_2185_ = _e1522;
                                            } else {
                                                phi_2184_ = bool();
                                                phi_2185_ = true;
                                            }
                                            let _e1524 = phi_2184_;
                                            let _e1526 = phi_2185_;
                                            if _e1526 {
                                                phi_2189_ = false;
                                            } else {
                                                phi_2189_ = _e1524;
                                            }
                                            let _e1528 = phi_2189_;
                                            phi_2190_ = _e1528;
                                        }
                                        let _e1530 = phi_2190_;
                                        if _e1530 {
                                            let _e1532 = triangles.member[(0u + _e1033)].i0_;
                                            if ((_e1532 & 2147483648u) == 0u) {
                                                phi_2401_ = true;
                                            } else {
                                                if (_e1033 < _e82) {
                                                } else {
                                                    return;
                                                }
                                                let _e1541 = triangles.member[(0u + _e1033)].i0_;
                                                let _e1542 = (_e1541 & 2147483647u);
                                                let _e1544 = triangles.member[(0u + _e1033)].i1_;
                                                let _e1546 = triangles.member[(0u + _e1033)].i2_;
                                                if (_e1542 < _e85) {
                                                } else {
                                                    return;
                                                }
                                                let _e1550 = vertices.member[(0u + _e1542)];
                                                if (_e1544 < _e85) {
                                                } else {
                                                    return;
                                                }
                                                let _e1554 = vertices.member[(0u + _e1544)];
                                                if (_e1546 < _e85) {
                                                } else {
                                                    return;
                                                }
                                                let _e1558 = vertices.member[(0u + _e1546)];
                                                let _e1559 = array<abi_Vertex, 3>(_e1550, _e1554, _e1558);
                                                if (_e1559[0].material < _e88) {
                                                } else {
                                                    return;
                                                }
                                                let _e1565 = materials.member[(0u + _e1559[0].material)];
                                                if ((_e1565.flags & 0u) == 0u) {
                                                    let _e1570 = ((1f - _e1497.u) - _e1497.v);
                                                    if (_e1565.cutoff <= 0f) {
                                                        phi_2396_ = true;
                                                    } else {
                                                        let _e1597 = (_e1565.base_color.w * ((((f32((_e1559[0].color >> bitcast<u32>(24i))) * _e1570) + (f32((_e1559[1].color >> bitcast<u32>(24i))) * _e1497.u)) + (f32((_e1559[2].color >> bitcast<u32>(24i))) * _e1497.v)) * (1f / 255f)));
                                                        if (_e1565.alpha_size == 0u) {
                                                            phi_2393_ = _e1597;
                                                        } else {
                                                            local_1.offset = _e1565.alpha_offset;
                                                            local_1.size = _e1565.alpha_size;
                                                            local_1.flags = _e1565.flags;
                                                            let _e1628 = _lt_shaders_texture_TextureView_quad((&local_1), (((_e1559[0].u * _e1570) + (_e1559[1].u * _e1497.u)) + (_e1559[2].u * _e1497.v)), (((_e1559[0].v * _e1570) + (_e1559[1].v * _e1497.u)) + (_e1559[2].v * _e1497.v)));
                                                            let _e1632 = (_e1628.indices[0] >> bitcast<u32>(2i));
                                                            if (_e1632 < _e94) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1636 = alpha_texels.member[(0u + _e1632)];
                                                            let _e1652 = (_e1628.indices[1] >> bitcast<u32>(2i));
                                                            if (_e1652 < _e94) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1656 = alpha_texels.member[(0u + _e1652)];
                                                            let _e1673 = (_e1628.indices[2] >> bitcast<u32>(2i));
                                                            if (_e1673 < _e94) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1677 = alpha_texels.member[(0u + _e1673)];
                                                            let _e1694 = (_e1628.indices[3] >> bitcast<u32>(2i));
                                                            if (_e1694 < _e94) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1698 = alpha_texels.member[(0u + _e1694)];
                                                            phi_2393_ = (_e1597 * (((((f32(((_e1636 >> bitcast<u32>((((_e1628.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1628.weights.x) + ((f32(((_e1656 >> bitcast<u32>((((_e1628.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1628.weights.y)) + ((f32(((_e1677 >> bitcast<u32>((((_e1628.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1628.weights.z)) + ((f32(((_e1698 >> bitcast<u32>((((_e1628.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1628.weights.w)));
                                                        }
                                                        let _e1714 = phi_2393_;
                                                        phi_2396_ = (_e1714 >= _e1565.cutoff);
                                                    }
                                                    let _e1718 = phi_2396_;
                                                    phi_2397_ = _e1718;
                                                } else {
                                                    phi_2397_ = false;
                                                }
                                                let _e1720 = phi_2397_;
                                                if _e1720 {
                                                }
                                                phi_2401_ = _e1720;
                                            }
                                            let _e1722 = phi_2401_;
                                            if _e1722 {
                                                phi_2409_ = lt_bvh_Hit(_e1497.t, _e1497.u, _e1497.v, _e1033, 4294967295u);
                                            } else {
                                                phi_2409_ = _e1022;
                                            }
                                            let _e1728 = phi_2409_;
                                            phi_2410_ = _e1728;
                                        } else {
                                            phi_2410_ = _e1022;
                                        }
                                        let _e1730 = phi_2410_;
                                        phi_2411_ = _e1730;
                                    } else {
                                        phi_2411_ = _e1022;
                                    }
                                    let _e1732 = phi_2411_;
                                    phi_2412_ = _e1732;
                                } else {
                                    phi_2412_ = _e1022;
                                }
                                let _e1734 = phi_2412_;
                                phi_1555_ = _e1734;
                                phi_1558_ = (_e1024 & (_e1024 - 1u));
                                phi_2413_ = true;
                            }
                            let _e1736 = phi_1555_;
                            let _e1738 = phi_1558_;
                            let _e1740 = phi_2413_;
                            continue;
                            continuing {
                                phi_1554_ = _e1736;
                                phi_1557_ = _e1738;
                                break if !(_e1740);
                            }
                        }
                        let _e1743 = local_2.group_mask;
                        if ((_e1743 & 4278190080u) == 0u) {
                            let _e1747 = local_2.len;
                            if (_e1747 == 0u) {
                                phi_2452_ = false;
                            } else {
                                let _e1751 = local_2.len;
                                local_2.len = (_e1751 - 1u);
                                let _e1754 = local_2.len;
                                if (_e1754 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1759 = local_2.first[(0u + _e1754)];
                                local_2.group = _e1759;
                                let _e1762 = local_2.len;
                                if (_e1762 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1767 = local_2.mask[(0u + _e1762)];
                                local_2.group_mask = _e1767;
                                phi_2452_ = true;
                            }
                            let _e1770 = phi_2452_;
                            phi_2453_ = _e1770;
                        } else {
                            phi_2453_ = true;
                        }
                        let _e1772 = phi_2453_;
                        if _e1772 {
                            let _e1774 = local_2.group_mask;
                            let _e1780 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1774)), 32u, (_e1774 == 0u)));
                            let _e1784 = local_2.group_mask;
                            let _e1798 = local_2.group_mask;
                            local_2.group_mask = (_e1798 & ~((1u << bitcast<u32>((_e1780 & 31u)))));
                            let _e1801 = local_2.group;
                            phi_2484_ = (_e1801 + countOneBits(((_e1784 & ~((4294967295u << bitcast<u32>((((_e1780 - 24u) ^ _e441) & 31u))))) & 255u)));
                        } else {
                            phi_2484_ = 4294967295u;
                        }
                        let _e1804 = phi_2484_;
                        let _e2727 = local_6;
                        phi_1218_ = _e2727;
                        phi_1221_ = _e1804;
                    } else {
                        phi_1218_ = lt_bvh_Hit();
                        phi_1221_ = u32();
                    }
                    let _e1806 = phi_1218_;
                    let _e1808 = phi_1221_;
                    continue;
                    continuing {
                        phi_1217_ = _e1806;
                        phi_1220_ = _e1808;
                        break if !(_e582);
                    }
                }
                let _e2731 = local_7;
                phi_2485_ = _e2731;
            }
            let _e1811 = phi_2485_;
            phi_2486_ = _e1811;
            phi_2487_ = _e236;
        } else {
            phi_2486_ = lt_bvh_Hit();
            phi_2487_ = true;
        }
        let _e1813 = phi_2486_;
        let _e1815 = phi_2487_;
        if _e1815 {
            phi_2491_ = _e166;
        } else {
            phi_2491_ = _e1813;
        }
        let _e1817 = phi_2491_;
        if (_e1817.triangle != 4294967295u) {
            let _e1823 = ((1f - _e1817.u) - _e1817.v);
            if (_e1817.triangle < _e82) {
            } else {
                return;
            }
            let _e1828 = triangles.member[(0u + _e1817.triangle)];
            let _e1853 = (((_e1828.v0_.x * _e1823) + (_e1828.v1_.x * _e1817.u)) + (_e1828.v2_.x * _e1817.v));
            let _e1854 = (((_e1828.v0_.y * _e1823) + (_e1828.v1_.y * _e1817.u)) + (_e1828.v2_.y * _e1817.v));
            let _e1855 = (((_e1828.v0_.z * _e1823) + (_e1828.v1_.z * _e1817.u)) + (_e1828.v2_.z * _e1817.v));
            let _e1858 = abs(_e1828.v0_.x);
            let _e1860 = abs(_e1828.v0_.y);
            let _e1862 = abs(_e1828.v0_.z);
            let _e1864 = abs(_e1828.v1_.x);
            let _e1866 = abs(_e1828.v1_.y);
            let _e1868 = abs(_e1828.v1_.z);
            if (_e1858 > _e1864) {
                phi_2555_ = _e1858;
            } else {
                phi_2555_ = _e1864;
            }
            let _e1871 = phi_2555_;
            if (_e1860 > _e1866) {
                phi_2560_ = _e1860;
            } else {
                phi_2560_ = _e1866;
            }
            let _e1874 = phi_2560_;
            if (_e1862 > _e1868) {
                phi_2565_ = _e1862;
            } else {
                phi_2565_ = _e1868;
            }
            let _e1877 = phi_2565_;
            let _e1879 = abs(_e1828.v2_.x);
            let _e1881 = abs(_e1828.v2_.y);
            let _e1883 = abs(_e1828.v2_.z);
            if (_e1871 > _e1879) {
                phi_2576_ = _e1871;
            } else {
                phi_2576_ = _e1879;
            }
            let _e1886 = phi_2576_;
            if (_e1874 > _e1881) {
                phi_2581_ = _e1874;
            } else {
                phi_2581_ = _e1881;
            }
            let _e1889 = phi_2581_;
            if (_e1877 > _e1883) {
                phi_2586_ = _e1877;
            } else {
                phi_2586_ = _e1883;
            }
            let _e1892 = phi_2586_;
            let _e1895 = (_e1828.v1_.x - _e1828.v0_.x);
            let _e1898 = (_e1828.v1_.y - _e1828.v0_.y);
            let _e1901 = (_e1828.v1_.z - _e1828.v0_.z);
            let _e1904 = (_e1828.v2_.x - _e1828.v0_.x);
            let _e1907 = (_e1828.v2_.y - _e1828.v0_.y);
            let _e1910 = (_e1828.v2_.z - _e1828.v0_.z);
            let _e1914 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1898), abs(_e1901));
            let _e1915 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1895), _e1914);
            let _e1916 = (_e1895 / _e1915);
            let _e1917 = (_e1898 / _e1915);
            let _e1918 = (_e1901 / _e1915);
            let _e1922 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1907), abs(_e1910));
            let _e1923 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1904), _e1922);
            let _e1924 = (_e1904 / _e1923);
            let _e1925 = (_e1907 / _e1923);
            let _e1926 = (_e1910 / _e1923);
            let _e1929 = ((_e1917 * _e1926) - (_e1925 * _e1918));
            let _e1932 = ((_e1918 * _e1924) - (_e1926 * _e1916));
            let _e1935 = ((_e1916 * _e1925) - (_e1924 * _e1917));
            let _e1937 = p.member.eye;
            let _e1950 = (1f / sqrt((((_e1929 * _e1929) + (_e1932 * _e1932)) + (_e1935 * _e1935))));
            let _e1951 = (_e1929 * _e1950);
            let _e1952 = (_e1932 * _e1950);
            let _e1953 = (_e1935 * _e1950);
            if ((((_e1951 * (_e1937.x - _e1853)) + (_e1952 * (_e1937.y - _e1854))) + (_e1953 * (_e1937.z - _e1855))) < 0f) {
                phi_2662_ = vec3<f32>(-(_e1951), -(_e1952), -(_e1953));
            } else {
                phi_2662_ = vec3<f32>(_e1951, _e1952, _e1953);
            }
            let _e1966 = phi_2662_;
            if (_e1817.triangle < _e82) {
            } else {
                return;
            }
            let _e1971 = triangles.member[(0u + _e1817.triangle)];
            let _e1973 = (_e1971.i0_ & 2147483647u);
            if (_e1973 < _e85) {
            } else {
                return;
            }
            let _e1979 = vertices.member[(0u + _e1973)];
            if (_e1971.i1_ < _e85) {
            } else {
                return;
            }
            let _e1983 = vertices.member[(0u + _e1971.i1_)];
            if (_e1971.i2_ < _e85) {
            } else {
                return;
            }
            let _e1987 = vertices.member[(0u + _e1971.i2_)];
            let _e1988 = array<abi_Vertex, 3>(_e1979, _e1983, _e1987);
            if (_e1988[0].material < _e88) {
            } else {
                return;
            }
            let _e1994 = materials.member[(0u + _e1988[0].material)];
            let _e2011 = (1f / 255f);
            let _e2030 = (1f / 255f);
            let _e2052 = (1f / 255f);
            if (_e1994.color_size == 0u) {
                phi_2905_ = vec3<f32>(1f, 1f, 1f);
            } else {
                local.offset = _e1994.color_offset;
                local.size = _e1994.color_size;
                local.flags = _e1994.flags;
                let _e2095 = _lt_shaders_texture_TextureView_quad((&local), (((_e1988[0].u * _e1823) + (_e1988[1].u * _e1817.u)) + (_e1988[2].u * _e1817.v)), (((_e1988[0].v * _e1823) + (_e1988[1].v * _e1817.u)) + (_e1988[2].v * _e1817.v)));
                if (_e2095.indices[0] < _e97) {
                } else {
                    return;
                }
                let _e2101 = color_texels.member[(0u + _e2095.indices[0])];
                let _e2112 = (1f / 255f);
                if (_e2095.indices[1] < _e97) {
                } else {
                    return;
                }
                let _e2126 = color_texels.member[(0u + _e2095.indices[1])];
                let _e2137 = (1f / 255f);
                if (_e2095.indices[2] < _e97) {
                } else {
                    return;
                }
                let _e2154 = color_texels.member[(0u + _e2095.indices[2])];
                let _e2165 = (1f / 255f);
                if (_e2095.indices[3] < _e97) {
                } else {
                    return;
                }
                let _e2182 = color_texels.member[(0u + _e2095.indices[3])];
                let _e2193 = (1f / 255f);
                let _e2202 = (((((f32((_e2101 & 255u)) * _e2112) * _e2095.weights.x) + ((f32((_e2126 & 255u)) * _e2137) * _e2095.weights.y)) + ((f32((_e2154 & 255u)) * _e2165) * _e2095.weights.z)) + ((f32((_e2182 & 255u)) * _e2193) * _e2095.weights.w));
                let _e2203 = (((((f32(((_e2101 >> bitcast<u32>(8i)) & 255u)) * _e2112) * _e2095.weights.x) + ((f32(((_e2126 >> bitcast<u32>(8i)) & 255u)) * _e2137) * _e2095.weights.y)) + ((f32(((_e2154 >> bitcast<u32>(8i)) & 255u)) * _e2165) * _e2095.weights.z)) + ((f32(((_e2182 >> bitcast<u32>(8i)) & 255u)) * _e2193) * _e2095.weights.w));
                let _e2204 = (((((f32(((_e2101 >> bitcast<u32>(16i)) & 255u)) * _e2112) * _e2095.weights.x) + ((f32(((_e2126 >> bitcast<u32>(16i)) & 255u)) * _e2137) * _e2095.weights.y)) + ((f32(((_e2154 >> bitcast<u32>(16i)) & 255u)) * _e2165) * _e2095.weights.z)) + ((f32(((_e2182 >> bitcast<u32>(16i)) & 255u)) * _e2193) * _e2095.weights.w));
                phi_2905_ = vec3<f32>((_e2202 * _e2202), (_e2203 * _e2203), (_e2204 * _e2204));
            }
            let _e2210 = phi_2905_;
            let _e2212 = ((_e1994.base_color.x * ((((f32((_e1988[0].color & 255u)) * _e2011) * _e1823) + ((f32((_e1988[1].color & 255u)) * _e2030) * _e1817.u)) + ((f32((_e1988[2].color & 255u)) * _e2052) * _e1817.v))) * _e2210.x);
            let _e2214 = ((_e1994.base_color.y * ((((f32(((_e1988[0].color >> bitcast<u32>(8i)) & 255u)) * _e2011) * _e1823) + ((f32(((_e1988[1].color >> bitcast<u32>(8i)) & 255u)) * _e2030) * _e1817.u)) + ((f32(((_e1988[2].color >> bitcast<u32>(8i)) & 255u)) * _e2052) * _e1817.v))) * _e2210.y);
            let _e2216 = ((_e1994.base_color.z * ((((f32(((_e1988[0].color >> bitcast<u32>(16i)) & 255u)) * _e2011) * _e1823) + ((f32(((_e1988[1].color >> bitcast<u32>(16i)) & 255u)) * _e2030) * _e1817.u)) + ((f32(((_e1988[2].color >> bitcast<u32>(16i)) & 255u)) * _e2052) * _e1817.v))) * _e2210.z);
            let _e2217 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1889, _e1892);
            let _e2218 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1886, _e2217);
            if ((_e1994.flags & 2u) == 0u) {
                phi_2920_ = 0u;
            } else {
                phi_2920_ = 1u;
            }
            let _e2223 = phi_2920_;
            if (_e1988[0].normal == 2147516416u) {
                phi_3123_ = _e1966;
            } else {
                let _e2236 = (f32((bitcast<i32>((_e1988[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2242 = (f32((bitcast<i32>(_e1988[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2246 = ((1f - abs(_e2236)) - abs(_e2242));
                if (_e2246 < 0f) {
                    phi_2947_ = -(_e2246);
                } else {
                    phi_2947_ = 0f;
                }
                let _e2250 = phi_2947_;
                if (_e2236 < 0f) {
                    phi_2954_ = (_e2236 + _e2250);
                } else {
                    phi_2954_ = (_e2236 - _e2250);
                }
                let _e2255 = phi_2954_;
                if (_e2242 < 0f) {
                    phi_2961_ = (_e2242 + _e2250);
                } else {
                    phi_2961_ = (_e2242 - _e2250);
                }
                let _e2260 = phi_2961_;
                let _e2267 = (1f / sqrt((((_e2255 * _e2255) + (_e2260 * _e2260)) + (_e2246 * _e2246))));
                let _e2283 = (f32((bitcast<i32>((_e1988[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2289 = (f32((bitcast<i32>(_e1988[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2293 = ((1f - abs(_e2283)) - abs(_e2289));
                if (_e2293 < 0f) {
                    phi_2996_ = -(_e2293);
                } else {
                    phi_2996_ = 0f;
                }
                let _e2297 = phi_2996_;
                if (_e2283 < 0f) {
                    phi_3003_ = (_e2283 + _e2297);
                } else {
                    phi_3003_ = (_e2283 - _e2297);
                }
                let _e2302 = phi_3003_;
                if (_e2289 < 0f) {
                    phi_3010_ = (_e2289 + _e2297);
                } else {
                    phi_3010_ = (_e2289 - _e2297);
                }
                let _e2307 = phi_3010_;
                let _e2314 = (1f / sqrt((((_e2302 * _e2302) + (_e2307 * _e2307)) + (_e2293 * _e2293))));
                let _e2333 = (f32((bitcast<i32>((_e1988[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2339 = (f32((bitcast<i32>(_e1988[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2343 = ((1f - abs(_e2333)) - abs(_e2339));
                if (_e2343 < 0f) {
                    phi_3048_ = -(_e2343);
                } else {
                    phi_3048_ = 0f;
                }
                let _e2347 = phi_3048_;
                if (_e2333 < 0f) {
                    phi_3055_ = (_e2333 + _e2347);
                } else {
                    phi_3055_ = (_e2333 - _e2347);
                }
                let _e2352 = phi_3055_;
                if (_e2339 < 0f) {
                    phi_3062_ = (_e2339 + _e2347);
                } else {
                    phi_3062_ = (_e2339 - _e2347);
                }
                let _e2357 = phi_3062_;
                let _e2364 = (1f / sqrt((((_e2352 * _e2352) + (_e2357 * _e2357)) + (_e2343 * _e2343))));
                let _e2375 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(vec3<f32>(((((_e2255 * _e2267) * _e1823) + ((_e2302 * _e2314) * _e1817.u)) + ((_e2352 * _e2364) * _e1817.v)), ((((_e2260 * _e2267) * _e1823) + ((_e2307 * _e2314) * _e1817.u)) + ((_e2357 * _e2364) * _e1817.v)), ((((_e2246 * _e2267) * _e1823) + ((_e2293 * _e2314) * _e1817.u)) + ((_e2343 * _e2364) * _e1817.v))));
                let _e2387 = sqrt((((_e2375.x * _e2375.x) + (_e2375.y * _e2375.y)) + (_e2375.z * _e2375.z)));
                if (_e2387 > 0f) {
                    let _e2390 = (_e2375.x / _e2387);
                    let _e2392 = (_e2375.y / _e2387);
                    let _e2394 = (_e2375.z / _e2387);
                    if ((((_e2390 * _e1966.x) + (_e2392 * _e1966.y)) + (_e2394 * _e1966.z)) < 0f) {
                        phi_3121_ = vec3<f32>(-(_e2390), -(_e2392), -(_e2394));
                    } else {
                        phi_3121_ = (_e2375 / vec3(_e2387));
                    }
                    let _e2411 = phi_3121_;
                    phi_3122_ = _e2411;
                } else {
                    phi_3122_ = _e1966;
                }
                let _e2413 = phi_3122_;
                phi_3123_ = _e2413;
            }
            let _e2415 = phi_3123_;
            if (_e2212 > 0f) {
                if (_e2212 < 1f) {
                    phi_3132_ = _e2212;
                } else {
                    phi_3132_ = 1f;
                }
                let _e2419 = phi_3132_;
                phi_3133_ = _e2419;
            } else {
                phi_3133_ = 0f;
            }
            let _e2421 = phi_3133_;
            if (_e2214 > 0f) {
                if (_e2214 < 1f) {
                    phi_3143_ = _e2214;
                } else {
                    phi_3143_ = 1f;
                }
                let _e2426 = phi_3143_;
                phi_3144_ = _e2426;
            } else {
                phi_3144_ = 0f;
            }
            let _e2428 = phi_3144_;
            if (_e2216 > 0f) {
                if (_e2216 < 1f) {
                    phi_3154_ = _e2216;
                } else {
                    phi_3154_ = 1f;
                }
                let _e2433 = phi_3154_;
                phi_3155_ = _e2433;
            } else {
                phi_3155_ = 0f;
            }
            let _e2435 = phi_3155_;
            let _e2438 = ((sqrt(_e2421) * 255f) + 0.5f);
            let _e2447 = ((sqrt(_e2428) * 255f) + 0.5f);
            let _e2459 = ((sqrt(_e2435) * 255f) + 0.5f);
            phi_3190_ = abi_Sample(vec3<f32>(_e1853, _e1854, _e1855), _e2218, _e1966, _e2223, _e2415, ((select(select(u32(_e2438), 0u, (_e2438 < bitcast<f32>(0u))), 4294967295u, (_e2438 > bitcast<f32>(1333788671u))) | (select(select(u32(_e2447), 0u, (_e2447 < bitcast<f32>(0u))), 4294967295u, (_e2447 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e2459), 0u, (_e2459 < bitcast<f32>(0u))), 4294967295u, (_e2459 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_3190_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e2473 = phi_3190_;
        if (_e109.shift < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e109.shift)] = _e2473;
        if (_e1817.triangle != 4294967295u) {
            let _e2482 = ((1f - _e1817.u) - _e1817.v);
            if (_e1817.triangle < _e82) {
            } else {
                return;
            }
            let _e2487 = triangles.member[(0u + _e1817.triangle)];
            let _e2489 = (_e2487.i0_ & 2147483647u);
            if (_e2489 < _e100) {
            } else {
                return;
            }
            let _e2495 = before.member[(0u + _e2489)];
            if (_e2487.i1_ < _e100) {
            } else {
                return;
            }
            let _e2499 = before.member[(0u + _e2487.i1_)];
            if (_e2487.i2_ < _e100) {
            } else {
                return;
            }
            let _e2503 = before.member[(0u + _e2487.i2_)];
            let _e2508 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(vec3<f32>(_e2495.x, _e2495.y, _e2495.z));
            let _e2519 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(vec3<f32>(_e2499.x, _e2499.y, _e2499.z));
            let _e2533 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(vec3<f32>(_e2503.x, _e2503.y, _e2503.z));
            phi_3281_ = vec3<f32>((((_e2508.x * _e2482) + (_e2519.x * _e1817.u)) + (_e2533.x * _e1817.v)), (((_e2508.y * _e2482) + (_e2519.y * _e1817.u)) + (_e2533.y * _e1817.v)), (((_e2508.z * _e2482) + (_e2519.z * _e1817.u)) + (_e2533.z * _e1817.v)));
        } else {
            phi_3281_ = vec3<f32>(0f, 0f, 0f);
        }
        let _e2545 = phi_3281_;
        if (_e109.shift < arrayLength((&past.member))) {
        } else {
            return;
        }
        past.member[(0u + _e109.shift)] = vec4<f32>(_e2545.x, _e2545.y, _e2545.z, 1f);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_alpha_color_motion_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
