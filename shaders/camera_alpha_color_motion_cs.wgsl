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
                let _e312 = phi_911_;
                if (_e164.direction.x < 0f) {
                    phi_918_ = (-1f / _e312);
                } else {
                    phi_918_ = (1f / _e312);
                }
                let _e317 = phi_918_;
                if (abs(_e164.direction.y) < _e306) {
                    phi_926_ = _e306;
                } else {
                    phi_926_ = abs(_e164.direction.y);
                }
                let _e323 = phi_926_;
                if (_e164.direction.y < 0f) {
                    phi_933_ = (-1f / _e323);
                } else {
                    phi_933_ = (1f / _e323);
                }
                let _e328 = phi_933_;
                if (abs(_e164.direction.z) < _e306) {
                    phi_941_ = _e306;
                } else {
                    phi_941_ = abs(_e164.direction.z);
                }
                let _e334 = phi_941_;
                if (_e164.direction.z < 0f) {
                    phi_948_ = (-1f / _e334);
                } else {
                    phi_948_ = (1f / _e334);
                }
                let _e339 = phi_948_;
                let _e347 = abs((bitcast<f32>(_e242) - _e164.origin.x));
                let _e348 = abs((bitcast<f32>(_e246) - _e164.origin.y));
                let _e349 = abs((bitcast<f32>(_e250) - _e164.origin.z));
                let _e357 = abs(((bitcast<f32>(_e254) + (bitcast<f32>((((_e266 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e164.origin.x));
                let _e358 = abs(((bitcast<f32>(_e258) + (bitcast<f32>((((_e266 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e164.origin.y));
                let _e359 = abs(((bitcast<f32>(_e262) + (bitcast<f32>((((_e266 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e164.origin.z));
                if (_e347 > _e357) {
                    phi_973_ = _e347;
                } else {
                    phi_973_ = _e357;
                }
                let _e362 = phi_973_;
                if (_e348 > _e358) {
                    phi_978_ = _e348;
                } else {
                    phi_978_ = _e358;
                }
                let _e365 = phi_978_;
                if (_e349 > _e359) {
                    phi_983_ = _e349;
                } else {
                    phi_983_ = _e359;
                }
                let _e368 = phi_983_;
                let _e369 = core_intrinsics_maximum_number_nsz_f32_(_e362, _e365);
                let _e370 = core_intrinsics_maximum_number_nsz_f32_(_e369, _e368);
                let _e375 = (_e370 * 0.0000019073486f);
                let _e376 = (abs(_e317) * _e375);
                let _e377 = (abs(_e328) * _e375);
                let _e378 = (abs(_e339) * _e375);
                let _e382 = (_e370 * 0.0000009536743f);
                let _e383 = (abs(_e317) * _e382);
                let _e384 = (abs(_e328) * _e382);
                let _e385 = (abs(_e339) * _e382);
                let _e388 = abs(_e164.direction.x);
                let _e390 = abs(_e164.direction.y);
                let _e392 = abs(_e164.direction.z);
                if (_e388 >= _e390) {
                    if (_e388 >= _e392) {
                        phi_1016_ = false;
                    } else {
                        phi_1016_ = true;
                    }
                    let _e396 = phi_1016_;
                    phi_1017_ = _e396;
                } else {
                    phi_1017_ = true;
                }
                let _e398 = phi_1017_;
                if _e398 {
                    if (_e390 >= _e392) {
                        phi_1025_ = 1u;
                    } else {
                        phi_1025_ = 2u;
                    }
                    let _e401 = phi_1025_;
                    phi_1026_ = _e401;
                } else {
                    phi_1026_ = 0u;
                }
                let _e403 = phi_1026_;
                if (_e403 == 0u) {
                    phi_1045_ = vec3<f32>(_e164.direction.y, _e164.direction.z, _e164.direction.x);
                } else {
                    if (_e403 == 1u) {
                        phi_1044_ = vec3<f32>(_e164.direction.z, _e164.direction.x, _e164.direction.y);
                    } else {
                        phi_1044_ = _e164.direction;
                    }
                    let _e416 = phi_1044_;
                    phi_1045_ = _e416;
                }
                let _e418 = phi_1045_;
                let _e422 = (_e418.x / _e418.z);
                let _e425 = (_e418.y / _e418.z);
                if (_e317 < 0f) {
                    phi_1059_ = 0u;
                } else {
                    phi_1059_ = 1u;
                }
                let _e430 = phi_1059_;
                if (_e328 < 0f) {
                    phi_1064_ = 0u;
                } else {
                    phi_1064_ = 2u;
                }
                let _e433 = phi_1064_;
                if (_e339 < 0f) {
                    phi_1069_ = 0u;
                } else {
                    phi_1069_ = 4u;
                }
                let _e436 = phi_1069_;
                let _e438 = ((_e430 | _e433) | _e436);
                let _e439 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e439.first[0], _e439.first[1], _e439.first[2], _e439.first[3], _e439.first[4], _e439.first[5], _e439.first[6], _e439.first[7], _e439.first[8], _e439.first[9], _e439.first[10], _e439.first[11], _e439.first[12], _e439.first[13], _e439.first[14], _e439.first[15], _e439.first[16], _e439.first[17], _e439.first[18], _e439.first[19], _e439.first[20], _e439.first[21], _e439.first[22], _e439.first[23], _e439.first[24], _e439.first[25], _e439.first[26], _e439.first[27], _e439.first[28], _e439.first[29], _e439.first[30], _e439.first[31]), array<u32, 32>(_e439.mask[0], _e439.mask[1], _e439.mask[2], _e439.mask[3], _e439.mask[4], _e439.mask[5], _e439.mask[6], _e439.mask[7], _e439.mask[8], _e439.mask[9], _e439.mask[10], _e439.mask[11], _e439.mask[12], _e439.mask[13], _e439.mask[14], _e439.mask[15], _e439.mask[16], _e439.mask[17], _e439.mask[18], _e439.mask[19], _e439.mask[20], _e439.mask[21], _e439.mask[22], _e439.mask[23], _e439.mask[24], _e439.mask[25], _e439.mask[26], _e439.mask[27], _e439.mask[28], _e439.mask[29], _e439.mask[30], _e439.mask[31]), _e439.len, _e439.group, _e439.group_mask);
                let _e513 = local_2.group_mask;
                if ((_e513 & 4278190080u) == 0u) {
                    let _e517 = local_2.len;
                    if (_e517 == 0u) {
                        phi_1183_ = false;
                    } else {
                        let _e521 = local_2.len;
                        local_2.len = (_e521 - 1u);
                        let _e524 = local_2.len;
                        if (_e524 < 32u) {
                        } else {
                            return;
                        }
                        let _e529 = local_2.first[(0u + _e524)];
                        local_2.group = _e529;
                        let _e532 = local_2.len;
                        if (_e532 < 32u) {
                        } else {
                            return;
                        }
                        let _e537 = local_2.mask[(0u + _e532)];
                        local_2.group_mask = _e537;
                        phi_1183_ = true;
                    }
                    let _e540 = phi_1183_;
                    phi_1184_ = _e540;
                } else {
                    phi_1184_ = true;
                }
                let _e542 = phi_1184_;
                if _e542 {
                    let _e544 = local_2.group_mask;
                    let _e550 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e544)), 32u, (_e544 == 0u)));
                    let _e554 = local_2.group_mask;
                    let _e568 = local_2.group_mask;
                    local_2.group_mask = (_e568 & ~((1u << bitcast<u32>((_e550 & 31u)))));
                    let _e571 = local_2.group;
                    phi_1215_ = (_e571 + countOneBits(((_e554 & ~((4294967295u << bitcast<u32>((((_e550 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1215_ = 4294967295u;
                }
                let _e574 = phi_1215_;
                phi_1217_ = _e166;
                phi_1220_ = _e574;
                loop {
                    let _e576 = phi_1217_;
                    let _e578 = phi_1220_;
                    local_7 = _e576;
                    let _e579 = (_e578 != 4294967295u);
                    if _e579 {
                        if (_e578 < _e79) {
                        } else {
                            return;
                        }
                        let _e587 = nodes.member[(0u + _e578)].frame[3u];
                        let _e612 = (bitcast<f32>((((_e587 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e317);
                        let _e613 = (bitcast<f32>((((_e587 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e328);
                        let _e614 = (bitcast<f32>((((_e587 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e339);
                        let _e617 = nodes.member[(0u + _e578)].frame[0u];
                        let _e621 = nodes.member[(0u + _e578)].frame[1u];
                        let _e625 = nodes.member[(0u + _e578)].frame[2u];
                        let _e633 = ((bitcast<f32>(_e617) - _e164.origin.x) * _e317);
                        let _e634 = ((bitcast<f32>(_e621) - _e164.origin.y) * _e328);
                        let _e635 = ((bitcast<f32>(_e625) - _e164.origin.z) * _e339);
                        let _e643 = nodes.member[(0u + _e578)].x;
                        if (_e317 < 0f) {
                            let _e654 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e643.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e660 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e654.unnamed.word, _e643.w), _e654.unnamed_1);
                            let _e666 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e660.unnamed, lt_mask_LightPlace(_e643.x, _e660.unnamed_1.shift));
                            phi_1305_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e666.unnamed, lt_mask_LightPlace(_e666.unnamed_1.word, _e643.y));
                        } else {
                            let _e682 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e643.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e688 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e682.unnamed.word, _e643.y), _e682.unnamed_1);
                            let _e694 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e688.unnamed, lt_mask_LightPlace(_e643.z, _e688.unnamed_1.shift));
                            phi_1305_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e694.unnamed, lt_mask_LightPlace(_e694.unnamed_1.word, _e643.w));
                        }
                        let _e702 = phi_1305_;
                        let _e712 = nodes.member[(0u + _e578)].y;
                        if (_e328 < 0f) {
                            let _e723 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e712.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e729 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e723.unnamed.word, _e712.w), _e723.unnamed_1);
                            let _e735 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e729.unnamed, lt_mask_LightPlace(_e712.x, _e729.unnamed_1.shift));
                            phi_1332_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e735.unnamed, lt_mask_LightPlace(_e735.unnamed_1.word, _e712.y));
                        } else {
                            let _e751 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e712.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e757 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e751.unnamed.word, _e712.y), _e751.unnamed_1);
                            let _e763 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e757.unnamed, lt_mask_LightPlace(_e712.z, _e757.unnamed_1.shift));
                            phi_1332_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e763.unnamed, lt_mask_LightPlace(_e763.unnamed_1.word, _e712.w));
                        }
                        let _e771 = phi_1332_;
                        let _e781 = nodes.member[(0u + _e578)].z;
                        if (_e339 < 0f) {
                            let _e792 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e781.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e798 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e792.unnamed.word, _e781.w), _e792.unnamed_1);
                            let _e804 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e798.unnamed, lt_mask_LightPlace(_e781.x, _e798.unnamed_1.shift));
                            phi_1359_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e804.unnamed, lt_mask_LightPlace(_e804.unnamed_1.word, _e781.y));
                        } else {
                            let _e820 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e781.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e826 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e820.unnamed.word, _e781.y), _e820.unnamed_1);
                            let _e832 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e826.unnamed, lt_mask_LightPlace(_e781.z, _e826.unnamed_1.shift));
                            phi_1359_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e832.unnamed, lt_mask_LightPlace(_e832.unnamed_1.word, _e781.w));
                        }
                        let _e840 = phi_1359_;
                        phi_1365_ = 0u;
                        phi_1368_ = 0u;
                        loop {
                            let _e850 = phi_1365_;
                            let _e852 = phi_1368_;
                            local_3 = _e852;
                            local_4 = _e852;
                            local_5 = _e852;
                            let _e853 = (_e850 < 8u);
                            if _e853 {
                                let _e855 = (_e850 >> bitcast<u32>(2i));
                                let _e856 = (_e850 & 3u);
                                if (_e855 == 0u) {
                                    phi_1382_ = _e702.unnamed.word;
                                } else {
                                    phi_1382_ = _e702.unnamed.shift;
                                }
                                let _e859 = phi_1382_;
                                if (_e855 == 0u) {
                                    phi_1392_ = _e771.unnamed.word;
                                } else {
                                    phi_1392_ = _e771.unnamed.shift;
                                }
                                let _e868 = phi_1392_;
                                if (_e855 == 0u) {
                                    phi_1402_ = _e840.unnamed.word;
                                } else {
                                    phi_1402_ = _e840.unnamed.shift;
                                }
                                let _e877 = phi_1402_;
                                let _e890 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e859 >> bitcast<u32>(((_e856 * 8u) & 31u))) & 255u)) * _e612) + (_e633 - _e376)), ((f32(((_e868 >> bitcast<u32>(((_e856 * 8u) & 31u))) & 255u)) * _e613) + (_e634 - _e377)));
                                let _e891 = core_intrinsics_maximum_number_nsz_f32_(_e890, ((f32(((_e877 >> bitcast<u32>(((_e856 * 8u) & 31u))) & 255u)) * _e614) + (_e635 - _e378)));
                                if (_e855 == 0u) {
                                    phi_1420_ = _e702.unnamed_1.word;
                                } else {
                                    phi_1420_ = _e702.unnamed_1.shift;
                                }
                                let _e894 = phi_1420_;
                                if (_e855 == 0u) {
                                    phi_1430_ = _e771.unnamed_1.word;
                                } else {
                                    phi_1430_ = _e771.unnamed_1.shift;
                                }
                                let _e903 = phi_1430_;
                                if (_e855 == 0u) {
                                    phi_1440_ = _e840.unnamed_1.word;
                                } else {
                                    phi_1440_ = _e840.unnamed_1.shift;
                                }
                                let _e912 = phi_1440_;
                                let _e925 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e894 >> bitcast<u32>(((_e856 * 8u) & 31u))) & 255u)) * _e612) + (_e633 + _e376)), ((f32(((_e903 >> bitcast<u32>(((_e856 * 8u) & 31u))) & 255u)) * _e613) + (_e634 + _e377)));
                                let _e926 = core_intrinsics_minimum_number_nsz_f32_(_e925, ((f32(((_e912 >> bitcast<u32>(((_e856 * 8u) & 31u))) & 255u)) * _e614) + (_e635 + _e378)));
                                if (_e891 <= _e926) {
                                    if (_e891 <= _e576.t) {
                                        if (_e926 >= _e164.tmin) {
                                            if (_e855 == 0u) {
                                                let _e933 = nodes.member[(0u + _e578)].links[2u];
                                                phi_1476_ = _e933;
                                            } else {
                                                let _e936 = nodes.member[(0u + _e578)].links[3u];
                                                phi_1476_ = _e936;
                                            }
                                            let _e938 = phi_1476_;
                                            let _e943 = ((_e938 >> bitcast<u32>(((_e856 * 8u) & 31u))) & 255u);
                                            let _e944 = (_e943 & 31u);
                                            if (_e944 >= 24u) {
                                                phi_1489_ = (24u + ((_e944 - 24u) ^ _e438));
                                            } else {
                                                phi_1489_ = _e944;
                                            }
                                            let _e950 = phi_1489_;
                                            phi_1494_ = (_e852 | ((_e943 >> bitcast<u32>(5i)) << bitcast<u32>((_e950 & 31u))));
                                        } else {
                                            phi_1494_ = _e852;
                                        }
                                        let _e958 = phi_1494_;
                                        phi_1495_ = _e958;
                                    } else {
                                        phi_1495_ = _e852;
                                    }
                                    let _e960 = phi_1495_;
                                    phi_1496_ = _e960;
                                } else {
                                    phi_1496_ = _e852;
                                }
                                let _e962 = phi_1496_;
                                phi_1366_ = (_e850 + 1u);
                                phi_1369_ = _e962;
                            } else {
                                phi_1366_ = u32();
                                phi_1369_ = u32();
                            }
                            let _e965 = phi_1366_;
                            let _e967 = phi_1369_;
                            continue;
                            continuing {
                                phi_1365_ = _e965;
                                phi_1368_ = _e967;
                                break if !(_e853);
                            }
                        }
                        let _e971 = nodes.member[(0u + _e578)].links[0u];
                        let _e975 = nodes.member[(0u + _e578)].frame[3u];
                        let _e979 = local_3;
                        if ((_e979 & 4278190080u) == 0u) {
                        } else {
                            let _e983 = local_2.group_mask;
                            if ((_e983 & 4278190080u) == 0u) {
                            } else {
                                let _e987 = local_2.len;
                                if (_e987 < 32u) {
                                    let _e990 = local_2.group;
                                    let _e992 = local_2.len;
                                    if (_e992 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.first[(0u + _e992)] = _e990;
                                    let _e998 = local_2.group_mask;
                                    let _e1000 = local_2.len;
                                    if (_e1000 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.mask[(0u + _e1000)] = _e998;
                                    let _e1007 = local_2.len;
                                    local_2.len = (_e1007 + 1u);
                                }
                            }
                            local_2.group = (0u + _e971);
                            let _e1011 = local_4;
                            local_2.group_mask = ((_e1011 & 4278190080u) | (_e975 >> bitcast<u32>(24i)));
                        }
                        let _e1016 = local_5;
                        phi_1554_ = _e576;
                        phi_1557_ = (_e1016 & 16777215u);
                        loop {
                            let _e1019 = phi_1554_;
                            let _e1021 = phi_1557_;
                            local_6 = _e1019;
                            if (_e1021 == 0u) {
                                phi_1555_ = lt_bvh_Hit();
                                phi_1558_ = u32();
                                phi_2413_ = false;
                            } else {
                                let _e1025 = nodes.member[(0u + _e578)].links[1u];
                                let _e1030 = ((0u + _e1025) + select(firstTrailingBit(_e1021), 32u, (_e1021 == 0u)));
                                if (_e1030 < _e82) {
                                } else {
                                    return;
                                }
                                let _e1037 = triangles.member[(0u + _e1030)].v0_;
                                let _e1040 = (_e1037.x - _e164.origin.x);
                                let _e1043 = (_e1037.y - _e164.origin.y);
                                let _e1046 = (_e1037.z - _e164.origin.z);
                                if (_e403 == 0u) {
                                    phi_1604_ = vec3<f32>(_e1043, _e1046, _e1040);
                                } else {
                                    if (_e403 == 1u) {
                                        phi_1603_ = vec3<f32>(_e1046, _e1040, _e1043);
                                    } else {
                                        phi_1603_ = (_e1037 - _e164.origin);
                                    }
                                    let _e1053 = phi_1603_;
                                    phi_1604_ = _e1053;
                                }
                                let _e1055 = phi_1604_;
                                let _e1059 = (_e1055.x - (_e422 * _e1055.z));
                                let _e1063 = (_e1055.y - (_e425 * _e1055.z));
                                let _e1065 = triangles.member[(0u + _e1030)].v1_;
                                let _e1068 = (_e1065.x - _e164.origin.x);
                                let _e1071 = (_e1065.y - _e164.origin.y);
                                let _e1074 = (_e1065.z - _e164.origin.z);
                                if (_e403 == 0u) {
                                    phi_1636_ = vec3<f32>(_e1071, _e1074, _e1068);
                                } else {
                                    if (_e403 == 1u) {
                                        phi_1635_ = vec3<f32>(_e1074, _e1068, _e1071);
                                    } else {
                                        phi_1635_ = (_e1065 - _e164.origin);
                                    }
                                    let _e1081 = phi_1635_;
                                    phi_1636_ = _e1081;
                                }
                                let _e1083 = phi_1636_;
                                let _e1087 = (_e1083.x - (_e422 * _e1083.z));
                                let _e1091 = (_e1083.y - (_e425 * _e1083.z));
                                let _e1093 = triangles.member[(0u + _e1030)].v2_;
                                let _e1096 = (_e1093.x - _e164.origin.x);
                                let _e1099 = (_e1093.y - _e164.origin.y);
                                let _e1102 = (_e1093.z - _e164.origin.z);
                                if (_e403 == 0u) {
                                    phi_1668_ = vec3<f32>(_e1099, _e1102, _e1096);
                                } else {
                                    if (_e403 == 1u) {
                                        phi_1667_ = vec3<f32>(_e1102, _e1096, _e1099);
                                    } else {
                                        phi_1667_ = (_e1093 - _e164.origin);
                                    }
                                    let _e1109 = phi_1667_;
                                    phi_1668_ = _e1109;
                                }
                                let _e1111 = phi_1668_;
                                let _e1115 = (_e1111.x - (_e422 * _e1111.z));
                                let _e1119 = (_e1111.y - (_e425 * _e1111.z));
                                if (_e1087 < _e1115) {
                                    phi_1687_ = true;
                                } else {
                                    if (_e1087 == _e1115) {
                                        phi_1686_ = (_e1091 < _e1119);
                                    } else {
                                        phi_1686_ = false;
                                    }
                                    let _e1124 = phi_1686_;
                                    phi_1687_ = _e1124;
                                }
                                let _e1126 = phi_1687_;
                                if _e1126 {
                                    phi_1691_ = _e1119;
                                    phi_1692_ = _e1115;
                                    phi_1693_ = _e1091;
                                    phi_1694_ = _e1087;
                                } else {
                                    phi_1691_ = _e1091;
                                    phi_1692_ = _e1087;
                                    phi_1693_ = _e1119;
                                    phi_1694_ = _e1115;
                                }
                                let _e1128 = phi_1691_;
                                let _e1130 = phi_1692_;
                                let _e1132 = phi_1693_;
                                let _e1134 = phi_1694_;
                                let _e1137 = ((_e1134 * _e1128) - (_e1132 * _e1130));
                                if _e1126 {
                                    phi_1702_ = -(_e1137);
                                } else {
                                    phi_1702_ = _e1137;
                                }
                                let _e1140 = phi_1702_;
                                if (_e1115 < _e1059) {
                                    phi_1713_ = true;
                                } else {
                                    if (_e1115 == _e1059) {
                                        phi_1712_ = (_e1119 < _e1063);
                                    } else {
                                        phi_1712_ = false;
                                    }
                                    let _e1145 = phi_1712_;
                                    phi_1713_ = _e1145;
                                }
                                let _e1147 = phi_1713_;
                                if _e1147 {
                                    phi_1717_ = _e1063;
                                    phi_1718_ = _e1059;
                                    phi_1719_ = _e1119;
                                    phi_1720_ = _e1115;
                                } else {
                                    phi_1717_ = _e1119;
                                    phi_1718_ = _e1115;
                                    phi_1719_ = _e1063;
                                    phi_1720_ = _e1059;
                                }
                                let _e1149 = phi_1717_;
                                let _e1151 = phi_1718_;
                                let _e1153 = phi_1719_;
                                let _e1155 = phi_1720_;
                                let _e1158 = ((_e1155 * _e1149) - (_e1153 * _e1151));
                                if _e1147 {
                                    phi_1728_ = -(_e1158);
                                } else {
                                    phi_1728_ = _e1158;
                                }
                                let _e1161 = phi_1728_;
                                if (_e1059 < _e1087) {
                                    phi_1739_ = true;
                                } else {
                                    if (_e1059 == _e1087) {
                                        phi_1738_ = (_e1063 < _e1091);
                                    } else {
                                        phi_1738_ = false;
                                    }
                                    let _e1166 = phi_1738_;
                                    phi_1739_ = _e1166;
                                }
                                let _e1168 = phi_1739_;
                                if _e1168 {
                                    phi_1743_ = _e1091;
                                    phi_1744_ = _e1087;
                                    phi_1745_ = _e1063;
                                    phi_1746_ = _e1059;
                                } else {
                                    phi_1743_ = _e1063;
                                    phi_1744_ = _e1059;
                                    phi_1745_ = _e1091;
                                    phi_1746_ = _e1087;
                                }
                                let _e1170 = phi_1743_;
                                let _e1172 = phi_1744_;
                                let _e1174 = phi_1745_;
                                let _e1176 = phi_1746_;
                                let _e1179 = ((_e1176 * _e1170) - (_e1174 * _e1172));
                                if _e1168 {
                                    phi_1754_ = -(_e1179);
                                } else {
                                    phi_1754_ = _e1179;
                                }
                                let _e1182 = phi_1754_;
                                if (_e1140 >= 0f) {
                                    if (_e1161 >= 0f) {
                                        if (_e1182 >= 0f) {
                                            phi_1769_ = ((_e1140 + _e1161) + _e1182);
                                            phi_1770_ = false;
                                        } else {
                                            phi_1769_ = f32();
                                            phi_1770_ = true;
                                        }
                                        let _e1189 = phi_1769_;
                                        let _e1191 = phi_1770_;
                                        phi_1771_ = _e1189;
                                        phi_1772_ = _e1191;
                                    } else {
                                        phi_1771_ = f32();
                                        phi_1772_ = true;
                                    }
                                    let _e1193 = phi_1771_;
                                    let _e1195 = phi_1772_;
                                    phi_1773_ = _e1193;
                                    phi_1774_ = _e1195;
                                } else {
                                    phi_1773_ = f32();
                                    phi_1774_ = true;
                                }
                                let _e1197 = phi_1773_;
                                let _e1199 = phi_1774_;
                                if _e1199 {
                                    if (_e1140 <= 0f) {
                                        if (_e1161 <= 0f) {
                                            let _e1202 = (_e1182 <= 0f);
                                            if _e1202 {
                                            }
                                            phi_1792_ = ((_e1140 + _e1161) + _e1182);
                                            phi_1793_ = false;
                                            phi_1794_ = _e1202;
                                        } else {
                                            phi_1792_ = f32();
                                            phi_1793_ = true;
                                            phi_1794_ = false;
                                        }
                                        let _e1206 = phi_1792_;
                                        let _e1208 = phi_1793_;
                                        let _e1210 = phi_1794_;
                                        phi_1795_ = _e1206;
                                        phi_1796_ = _e1208;
                                        phi_1797_ = _e1210;
                                    } else {
                                        phi_1795_ = f32();
                                        phi_1796_ = true;
                                        phi_1797_ = false;
                                    }
                                    let _e1212 = phi_1795_;
                                    let _e1214 = phi_1796_;
                                    let _e1216 = phi_1797_;
                                    if _e1214 {
                                        phi_1801_ = false;
                                    } else {
                                        phi_1801_ = _e1216;
                                    }
                                    let _e1218 = phi_1801_;
                                    phi_1802_ = _e1212;
                                    phi_1803_ = _e1218;
                                } else {
                                    phi_1802_ = _e1197;
                                    phi_1803_ = true;
                                }
                                let _e1220 = phi_1802_;
                                let _e1222 = phi_1803_;
                                if _e1222 {
                                    let _e1223 = (_e1220 == 0f);
                                    if _e1223 {
                                        phi_2129_ = lt_bvh_triangle_Intersection();
                                        phi_2130_ = false;
                                    } else {
                                        let _e1225 = triangles.member[(0u + _e1030)].v0_;
                                        let _e1228 = (_e1225.x - _e164.origin.x);
                                        let _e1231 = (_e1225.y - _e164.origin.y);
                                        let _e1234 = (_e1225.z - _e164.origin.z);
                                        if (_e403 == 0u) {
                                            phi_1834_ = vec3<f32>(_e1231, _e1234, _e1228);
                                        } else {
                                            if (_e403 == 1u) {
                                                phi_1833_ = vec3<f32>(_e1234, _e1228, _e1231);
                                            } else {
                                                phi_1833_ = (_e1225 - _e164.origin);
                                            }
                                            let _e1241 = phi_1833_;
                                            phi_1834_ = _e1241;
                                        }
                                        let _e1243 = phi_1834_;
                                        let _e1245 = triangles.member[(0u + _e1030)].v1_;
                                        let _e1247 = triangles.member[(0u + _e1030)].v0_;
                                        let _e1250 = (_e1245.x - _e1247.x);
                                        let _e1253 = (_e1245.y - _e1247.y);
                                        let _e1256 = (_e1245.z - _e1247.z);
                                        if (_e403 == 0u) {
                                            phi_1860_ = vec3<f32>(_e1253, _e1256, _e1250);
                                        } else {
                                            if (_e403 == 1u) {
                                                phi_1859_ = vec3<f32>(_e1256, _e1250, _e1253);
                                            } else {
                                                phi_1859_ = (_e1245 - _e1247);
                                            }
                                            let _e1263 = phi_1859_;
                                            phi_1860_ = _e1263;
                                        }
                                        let _e1265 = phi_1860_;
                                        let _e1267 = triangles.member[(0u + _e1030)].v2_;
                                        let _e1269 = triangles.member[(0u + _e1030)].v0_;
                                        let _e1272 = (_e1267.x - _e1269.x);
                                        let _e1275 = (_e1267.y - _e1269.y);
                                        let _e1278 = (_e1267.z - _e1269.z);
                                        if (_e403 == 0u) {
                                            phi_1886_ = vec3<f32>(_e1275, _e1278, _e1272);
                                        } else {
                                            if (_e403 == 1u) {
                                                phi_1885_ = vec3<f32>(_e1278, _e1272, _e1275);
                                            } else {
                                                phi_1885_ = (_e1267 - _e1269);
                                            }
                                            let _e1285 = phi_1885_;
                                            phi_1886_ = _e1285;
                                        }
                                        let _e1287 = phi_1886_;
                                        let _e1294 = ((_e1265.y * _e1287.z) - (_e1265.z * _e1287.y));
                                        let _e1301 = ((_e1265.z * _e1287.x) - (_e1265.x * _e1287.z));
                                        let _e1308 = ((_e1265.x * _e1287.y) - (_e1265.y * _e1287.x));
                                        let _e1322 = (((1f / _e418.z) * (((_e1294 * _e1243.x) + (_e1301 * _e1243.y)) + (_e1308 * _e1243.z))) / (((_e1294 * _e422) + (_e1301 * _e425)) + _e1308));
                                        if (_e1322 > _e164.tmin) {
                                            if (_e1322 < _e164.tmax) {
                                                let _e1328 = triangles.member[(0u + _e1030)].v0_;
                                                let _e1330 = triangles.member[(0u + _e1030)].v1_;
                                                if (_e1328.x < _e1330.x) {
                                                    phi_1944_ = _e1328.x;
                                                } else {
                                                    phi_1944_ = _e1330.x;
                                                }
                                                let _e1337 = phi_1944_;
                                                if (_e1328.y < _e1330.y) {
                                                    phi_1953_ = _e1328.y;
                                                } else {
                                                    phi_1953_ = _e1330.y;
                                                }
                                                let _e1344 = phi_1953_;
                                                if (_e1328.z < _e1330.z) {
                                                    phi_1962_ = _e1328.z;
                                                } else {
                                                    phi_1962_ = _e1330.z;
                                                }
                                                let _e1351 = phi_1962_;
                                                let _e1353 = triangles.member[(0u + _e1030)].v2_;
                                                if (_e1337 < _e1353.x) {
                                                    phi_1971_ = _e1337;
                                                } else {
                                                    phi_1971_ = _e1353.x;
                                                }
                                                let _e1358 = phi_1971_;
                                                if (_e1344 < _e1353.y) {
                                                    phi_1978_ = _e1344;
                                                } else {
                                                    phi_1978_ = _e1353.y;
                                                }
                                                let _e1363 = phi_1978_;
                                                if (_e1351 < _e1353.z) {
                                                    phi_1985_ = _e1351;
                                                } else {
                                                    phi_1985_ = _e1353.z;
                                                }
                                                let _e1368 = phi_1985_;
                                                let _e1370 = triangles.member[(0u + _e1030)].v0_;
                                                let _e1372 = triangles.member[(0u + _e1030)].v1_;
                                                if (_e1370.x > _e1372.x) {
                                                    phi_1998_ = _e1370.x;
                                                } else {
                                                    phi_1998_ = _e1372.x;
                                                }
                                                let _e1379 = phi_1998_;
                                                if (_e1370.y > _e1372.y) {
                                                    phi_2007_ = _e1370.y;
                                                } else {
                                                    phi_2007_ = _e1372.y;
                                                }
                                                let _e1386 = phi_2007_;
                                                if (_e1370.z > _e1372.z) {
                                                    phi_2016_ = _e1370.z;
                                                } else {
                                                    phi_2016_ = _e1372.z;
                                                }
                                                let _e1393 = phi_2016_;
                                                let _e1395 = triangles.member[(0u + _e1030)].v2_;
                                                if (_e1379 > _e1395.x) {
                                                    phi_2025_ = _e1379;
                                                } else {
                                                    phi_2025_ = _e1395.x;
                                                }
                                                let _e1400 = phi_2025_;
                                                if (_e1386 > _e1395.y) {
                                                    phi_2032_ = _e1386;
                                                } else {
                                                    phi_2032_ = _e1395.y;
                                                }
                                                let _e1405 = phi_2032_;
                                                if (_e1393 > _e1395.z) {
                                                    phi_2039_ = _e1393;
                                                } else {
                                                    phi_2039_ = _e1395.z;
                                                }
                                                let _e1410 = phi_2039_;
                                                let _e1417 = ((_e1358 - _e164.origin.x) * _e317);
                                                let _e1418 = ((_e1363 - _e164.origin.y) * _e328);
                                                let _e1419 = ((_e1368 - _e164.origin.z) * _e339);
                                                let _e1426 = ((_e1400 - _e164.origin.x) * _e317);
                                                let _e1427 = ((_e1405 - _e164.origin.y) * _e328);
                                                let _e1428 = ((_e1410 - _e164.origin.z) * _e339);
                                                if (_e1417 < _e1426) {
                                                    phi_2062_ = _e1417;
                                                } else {
                                                    phi_2062_ = _e1426;
                                                }
                                                let _e1431 = phi_2062_;
                                                if (_e1418 < _e1427) {
                                                    phi_2067_ = _e1418;
                                                } else {
                                                    phi_2067_ = _e1427;
                                                }
                                                let _e1434 = phi_2067_;
                                                if (_e1419 < _e1428) {
                                                    phi_2072_ = _e1419;
                                                } else {
                                                    phi_2072_ = _e1428;
                                                }
                                                let _e1437 = phi_2072_;
                                                if (_e1417 > _e1426) {
                                                    phi_2080_ = _e1417;
                                                } else {
                                                    phi_2080_ = _e1426;
                                                }
                                                let _e1443 = phi_2080_;
                                                if (_e1418 > _e1427) {
                                                    phi_2085_ = _e1418;
                                                } else {
                                                    phi_2085_ = _e1427;
                                                }
                                                let _e1446 = phi_2085_;
                                                if (_e1419 > _e1428) {
                                                    phi_2090_ = _e1419;
                                                } else {
                                                    phi_2090_ = _e1428;
                                                }
                                                let _e1449 = phi_2090_;
                                                let _e1453 = core_intrinsics_maximum_number_nsz_f32_((_e1431 - _e383), (_e1434 - _e384));
                                                let _e1454 = core_intrinsics_maximum_number_nsz_f32_(_e1453, (_e1437 - _e385));
                                                let _e1455 = core_intrinsics_minimum_number_nsz_f32_((_e1443 + _e383), (_e1446 + _e384));
                                                let _e1456 = core_intrinsics_minimum_number_nsz_f32_(_e1455, (_e1449 + _e385));
                                                if (_e1454 > -300000000000000000000000000000000000000f) {
                                                    phi_2102_ = _e1454;
                                                } else {
                                                    phi_2102_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1459 = phi_2102_;
                                                if (_e1456 < 300000000000000000000000000000000000000f) {
                                                    phi_2107_ = _e1456;
                                                } else {
                                                    phi_2107_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1462 = phi_2107_;
                                                if (_e1322 < _e1459) {
                                                    phi_2112_ = _e1459;
                                                } else {
                                                    phi_2112_ = _e1322;
                                                }
                                                let _e1465 = phi_2112_;
                                                if (_e1465 > _e1462) {
                                                    phi_2117_ = _e1462;
                                                } else {
                                                    phi_2117_ = _e1465;
                                                }
                                                let _e1468 = phi_2117_;
                                                phi_2122_ = lt_bvh_triangle_Intersection(_e1468, (_e1161 / _e1220), (_e1182 / _e1220), (_e1459 <= _e1462));
                                                phi_2123_ = false;
                                            } else {
                                                phi_2122_ = lt_bvh_triangle_Intersection();
                                                phi_2123_ = true;
                                            }
                                            let _e1474 = phi_2122_;
                                            let _e1476 = phi_2123_;
                                            phi_2124_ = _e1474;
                                            phi_2125_ = _e1476;
                                        } else {
                                            phi_2124_ = lt_bvh_triangle_Intersection();
                                            phi_2125_ = true;
                                        }
                                        let _e1478 = phi_2124_;
                                        let _e1480 = phi_2125_;
                                        if _e1480 {
                                        }
                                        phi_2129_ = _e1478;
                                        phi_2130_ = _e1480;
                                    }
                                    let _e1482 = phi_2129_;
                                    let _e1484 = phi_2130_;
                                    phi_2131_ = _e1482;
                                    phi_2132_ = _e1223;
                                    phi_2133_ = _e1484;
                                } else {
                                    phi_2131_ = lt_bvh_triangle_Intersection();
                                    phi_2132_ = true;
                                    phi_2133_ = false;
                                }
                                let _e1486 = phi_2131_;
                                let _e1488 = phi_2132_;
                                let _e1490 = phi_2133_;
                                if _e1488 {
                                    phi_2137_ = true;
                                } else {
                                    phi_2137_ = _e1490;
                                }
                                let _e1492 = phi_2137_;
                                if _e1492 {
                                    phi_2141_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_2141_ = _e1486;
                                }
                                let _e1494 = phi_2141_;
                                if _e1494.is_hit {
                                    if (_e1494.t > _e164.tmin) {
                                        if (_e1494.t < _e1019.t) {
                                            phi_2190_ = true;
                                        } else {
                                            if (_e1494.t == _e1019.t) {
                                                if (_e1019.triangle != 4294967295u) {
                                                    if (_e1030 < _e1019.triangle) {
                                                        phi_2181_ = true;
                                                    } else {
                                                        if (_e1030 == _e1019.triangle) {
                                                            phi_2180_ = (4294967295u < _e1019.instance);
                                                        } else {
                                                            phi_2180_ = false;
                                                        }
                                                        let _e1513 = phi_2180_;
                                                        phi_2181_ = _e1513;
                                                    }
                                                    let _e1515 = phi_2181_;
                                                    phi_2182_ = _e1515;
                                                    phi_2183_ = false;
                                                } else {
                                                    phi_2182_ = bool();
                                                    phi_2183_ = true;
                                                }
                                                let _e1517 = phi_2182_;
                                                let _e1519 = phi_2183_;
                                                phi_2184_ = _e1517;
                                                phi_2185_ = _e1519;
                                            } else {
                                                phi_2184_ = bool();
                                                phi_2185_ = true;
                                            }
                                            let _e1521 = phi_2184_;
                                            let _e1523 = phi_2185_;
                                            if _e1523 {
                                                phi_2189_ = false;
                                            } else {
                                                phi_2189_ = _e1521;
                                            }
                                            let _e1525 = phi_2189_;
                                            phi_2190_ = _e1525;
                                        }
                                        let _e1527 = phi_2190_;
                                        if _e1527 {
                                            let _e1529 = triangles.member[(0u + _e1030)].i0_;
                                            if ((_e1529 & 2147483648u) == 0u) {
                                                phi_2401_ = true;
                                            } else {
                                                if (_e1030 < _e82) {
                                                } else {
                                                    return;
                                                }
                                                let _e1538 = triangles.member[(0u + _e1030)].i0_;
                                                let _e1539 = (_e1538 & 2147483647u);
                                                let _e1541 = triangles.member[(0u + _e1030)].i1_;
                                                let _e1543 = triangles.member[(0u + _e1030)].i2_;
                                                if (_e1539 < _e85) {
                                                } else {
                                                    return;
                                                }
                                                let _e1547 = vertices.member[(0u + _e1539)];
                                                if (_e1541 < _e85) {
                                                } else {
                                                    return;
                                                }
                                                let _e1551 = vertices.member[(0u + _e1541)];
                                                if (_e1543 < _e85) {
                                                } else {
                                                    return;
                                                }
                                                let _e1555 = vertices.member[(0u + _e1543)];
                                                let _e1556 = array<abi_Vertex, 3>(_e1547, _e1551, _e1555);
                                                if (_e1556[0].material < _e88) {
                                                } else {
                                                    return;
                                                }
                                                let _e1562 = materials.member[(0u + _e1556[0].material)];
                                                if ((_e1562.flags & 0u) == 0u) {
                                                    let _e1567 = ((1f - _e1494.u) - _e1494.v);
                                                    if (_e1562.cutoff <= 0f) {
                                                        phi_2396_ = true;
                                                    } else {
                                                        let _e1594 = (_e1562.base_color.w * ((((f32((_e1556[0].color >> bitcast<u32>(24i))) * _e1567) + (f32((_e1556[1].color >> bitcast<u32>(24i))) * _e1494.u)) + (f32((_e1556[2].color >> bitcast<u32>(24i))) * _e1494.v)) * (1f / 255f)));
                                                        if (_e1562.alpha_size == 0u) {
                                                            phi_2393_ = _e1594;
                                                        } else {
                                                            local_1.offset = _e1562.alpha_offset;
                                                            local_1.size = _e1562.alpha_size;
                                                            local_1.flags = _e1562.flags;
                                                            let _e1625 = _lt_shaders_texture_TextureView_quad((&local_1), (((_e1556[0].u * _e1567) + (_e1556[1].u * _e1494.u)) + (_e1556[2].u * _e1494.v)), (((_e1556[0].v * _e1567) + (_e1556[1].v * _e1494.u)) + (_e1556[2].v * _e1494.v)));
                                                            let _e1629 = (_e1625.indices[0] >> bitcast<u32>(2i));
                                                            if (_e1629 < _e94) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1633 = alpha_texels.member[(0u + _e1629)];
                                                            let _e1649 = (_e1625.indices[1] >> bitcast<u32>(2i));
                                                            if (_e1649 < _e94) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1653 = alpha_texels.member[(0u + _e1649)];
                                                            let _e1670 = (_e1625.indices[2] >> bitcast<u32>(2i));
                                                            if (_e1670 < _e94) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1674 = alpha_texels.member[(0u + _e1670)];
                                                            let _e1691 = (_e1625.indices[3] >> bitcast<u32>(2i));
                                                            if (_e1691 < _e94) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1695 = alpha_texels.member[(0u + _e1691)];
                                                            phi_2393_ = (_e1594 * (((((f32(((_e1633 >> bitcast<u32>((((_e1625.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1625.weights.x) + ((f32(((_e1653 >> bitcast<u32>((((_e1625.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1625.weights.y)) + ((f32(((_e1674 >> bitcast<u32>((((_e1625.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1625.weights.z)) + ((f32(((_e1695 >> bitcast<u32>((((_e1625.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1625.weights.w)));
                                                        }
                                                        let _e1711 = phi_2393_;
                                                        phi_2396_ = (_e1711 >= _e1562.cutoff);
                                                    }
                                                    let _e1715 = phi_2396_;
                                                    phi_2397_ = _e1715;
                                                } else {
                                                    phi_2397_ = false;
                                                }
                                                let _e1717 = phi_2397_;
                                                if _e1717 {
                                                }
                                                phi_2401_ = _e1717;
                                            }
                                            let _e1719 = phi_2401_;
                                            if _e1719 {
                                                phi_2409_ = lt_bvh_Hit(_e1494.t, _e1494.u, _e1494.v, _e1030, 4294967295u);
                                            } else {
                                                phi_2409_ = _e1019;
                                            }
                                            let _e1725 = phi_2409_;
                                            phi_2410_ = _e1725;
                                        } else {
                                            phi_2410_ = _e1019;
                                        }
                                        let _e1727 = phi_2410_;
                                        phi_2411_ = _e1727;
                                    } else {
                                        phi_2411_ = _e1019;
                                    }
                                    let _e1729 = phi_2411_;
                                    phi_2412_ = _e1729;
                                } else {
                                    phi_2412_ = _e1019;
                                }
                                let _e1731 = phi_2412_;
                                phi_1555_ = _e1731;
                                phi_1558_ = (_e1021 & (_e1021 - 1u));
                                phi_2413_ = true;
                            }
                            let _e1733 = phi_1555_;
                            let _e1735 = phi_1558_;
                            let _e1737 = phi_2413_;
                            continue;
                            continuing {
                                phi_1554_ = _e1733;
                                phi_1557_ = _e1735;
                                break if !(_e1737);
                            }
                        }
                        let _e1740 = local_2.group_mask;
                        if ((_e1740 & 4278190080u) == 0u) {
                            let _e1744 = local_2.len;
                            if (_e1744 == 0u) {
                                phi_2452_ = false;
                            } else {
                                let _e1748 = local_2.len;
                                local_2.len = (_e1748 - 1u);
                                let _e1751 = local_2.len;
                                if (_e1751 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1756 = local_2.first[(0u + _e1751)];
                                local_2.group = _e1756;
                                let _e1759 = local_2.len;
                                if (_e1759 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1764 = local_2.mask[(0u + _e1759)];
                                local_2.group_mask = _e1764;
                                phi_2452_ = true;
                            }
                            let _e1767 = phi_2452_;
                            phi_2453_ = _e1767;
                        } else {
                            phi_2453_ = true;
                        }
                        let _e1769 = phi_2453_;
                        if _e1769 {
                            let _e1771 = local_2.group_mask;
                            let _e1777 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1771)), 32u, (_e1771 == 0u)));
                            let _e1781 = local_2.group_mask;
                            let _e1795 = local_2.group_mask;
                            local_2.group_mask = (_e1795 & ~((1u << bitcast<u32>((_e1777 & 31u)))));
                            let _e1798 = local_2.group;
                            phi_2484_ = (_e1798 + countOneBits(((_e1781 & ~((4294967295u << bitcast<u32>((((_e1777 - 24u) ^ _e438) & 31u))))) & 255u)));
                        } else {
                            phi_2484_ = 4294967295u;
                        }
                        let _e1801 = phi_2484_;
                        let _e2724 = local_6;
                        phi_1218_ = _e2724;
                        phi_1221_ = _e1801;
                    } else {
                        phi_1218_ = lt_bvh_Hit();
                        phi_1221_ = u32();
                    }
                    let _e1803 = phi_1218_;
                    let _e1805 = phi_1221_;
                    continue;
                    continuing {
                        phi_1217_ = _e1803;
                        phi_1220_ = _e1805;
                        break if !(_e579);
                    }
                }
                let _e2728 = local_7;
                phi_2485_ = _e2728;
            }
            let _e1808 = phi_2485_;
            phi_2486_ = _e1808;
            phi_2487_ = _e236;
        } else {
            phi_2486_ = lt_bvh_Hit();
            phi_2487_ = true;
        }
        let _e1810 = phi_2486_;
        let _e1812 = phi_2487_;
        if _e1812 {
            phi_2491_ = _e166;
        } else {
            phi_2491_ = _e1810;
        }
        let _e1814 = phi_2491_;
        if (_e1814.triangle != 4294967295u) {
            let _e1820 = ((1f - _e1814.u) - _e1814.v);
            if (_e1814.triangle < _e82) {
            } else {
                return;
            }
            let _e1825 = triangles.member[(0u + _e1814.triangle)];
            let _e1850 = (((_e1825.v0_.x * _e1820) + (_e1825.v1_.x * _e1814.u)) + (_e1825.v2_.x * _e1814.v));
            let _e1851 = (((_e1825.v0_.y * _e1820) + (_e1825.v1_.y * _e1814.u)) + (_e1825.v2_.y * _e1814.v));
            let _e1852 = (((_e1825.v0_.z * _e1820) + (_e1825.v1_.z * _e1814.u)) + (_e1825.v2_.z * _e1814.v));
            let _e1855 = abs(_e1825.v0_.x);
            let _e1857 = abs(_e1825.v0_.y);
            let _e1859 = abs(_e1825.v0_.z);
            let _e1861 = abs(_e1825.v1_.x);
            let _e1863 = abs(_e1825.v1_.y);
            let _e1865 = abs(_e1825.v1_.z);
            if (_e1855 > _e1861) {
                phi_2555_ = _e1855;
            } else {
                phi_2555_ = _e1861;
            }
            let _e1868 = phi_2555_;
            if (_e1857 > _e1863) {
                phi_2560_ = _e1857;
            } else {
                phi_2560_ = _e1863;
            }
            let _e1871 = phi_2560_;
            if (_e1859 > _e1865) {
                phi_2565_ = _e1859;
            } else {
                phi_2565_ = _e1865;
            }
            let _e1874 = phi_2565_;
            let _e1876 = abs(_e1825.v2_.x);
            let _e1878 = abs(_e1825.v2_.y);
            let _e1880 = abs(_e1825.v2_.z);
            if (_e1868 > _e1876) {
                phi_2576_ = _e1868;
            } else {
                phi_2576_ = _e1876;
            }
            let _e1883 = phi_2576_;
            if (_e1871 > _e1878) {
                phi_2581_ = _e1871;
            } else {
                phi_2581_ = _e1878;
            }
            let _e1886 = phi_2581_;
            if (_e1874 > _e1880) {
                phi_2586_ = _e1874;
            } else {
                phi_2586_ = _e1880;
            }
            let _e1889 = phi_2586_;
            let _e1892 = (_e1825.v1_.x - _e1825.v0_.x);
            let _e1895 = (_e1825.v1_.y - _e1825.v0_.y);
            let _e1898 = (_e1825.v1_.z - _e1825.v0_.z);
            let _e1901 = (_e1825.v2_.x - _e1825.v0_.x);
            let _e1904 = (_e1825.v2_.y - _e1825.v0_.y);
            let _e1907 = (_e1825.v2_.z - _e1825.v0_.z);
            let _e1911 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1895), abs(_e1898));
            let _e1912 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1892), _e1911);
            let _e1913 = (_e1892 / _e1912);
            let _e1914 = (_e1895 / _e1912);
            let _e1915 = (_e1898 / _e1912);
            let _e1919 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1904), abs(_e1907));
            let _e1920 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1901), _e1919);
            let _e1921 = (_e1901 / _e1920);
            let _e1922 = (_e1904 / _e1920);
            let _e1923 = (_e1907 / _e1920);
            let _e1926 = ((_e1914 * _e1923) - (_e1922 * _e1915));
            let _e1929 = ((_e1915 * _e1921) - (_e1923 * _e1913));
            let _e1932 = ((_e1913 * _e1922) - (_e1921 * _e1914));
            let _e1934 = p.member.eye;
            let _e1947 = (1f / sqrt((((_e1926 * _e1926) + (_e1929 * _e1929)) + (_e1932 * _e1932))));
            let _e1948 = (_e1926 * _e1947);
            let _e1949 = (_e1929 * _e1947);
            let _e1950 = (_e1932 * _e1947);
            if ((((_e1948 * (_e1934.x - _e1850)) + (_e1949 * (_e1934.y - _e1851))) + (_e1950 * (_e1934.z - _e1852))) < 0f) {
                phi_2662_ = vec3<f32>(-(_e1948), -(_e1949), -(_e1950));
            } else {
                phi_2662_ = vec3<f32>(_e1948, _e1949, _e1950);
            }
            let _e1963 = phi_2662_;
            if (_e1814.triangle < _e82) {
            } else {
                return;
            }
            let _e1968 = triangles.member[(0u + _e1814.triangle)];
            let _e1970 = (_e1968.i0_ & 2147483647u);
            if (_e1970 < _e85) {
            } else {
                return;
            }
            let _e1976 = vertices.member[(0u + _e1970)];
            if (_e1968.i1_ < _e85) {
            } else {
                return;
            }
            let _e1980 = vertices.member[(0u + _e1968.i1_)];
            if (_e1968.i2_ < _e85) {
            } else {
                return;
            }
            let _e1984 = vertices.member[(0u + _e1968.i2_)];
            let _e1985 = array<abi_Vertex, 3>(_e1976, _e1980, _e1984);
            if (_e1985[0].material < _e88) {
            } else {
                return;
            }
            let _e1991 = materials.member[(0u + _e1985[0].material)];
            let _e2008 = (1f / 255f);
            let _e2027 = (1f / 255f);
            let _e2049 = (1f / 255f);
            if (_e1991.color_size == 0u) {
                phi_2905_ = vec3<f32>(1f, 1f, 1f);
            } else {
                local.offset = _e1991.color_offset;
                local.size = _e1991.color_size;
                local.flags = _e1991.flags;
                let _e2092 = _lt_shaders_texture_TextureView_quad((&local), (((_e1985[0].u * _e1820) + (_e1985[1].u * _e1814.u)) + (_e1985[2].u * _e1814.v)), (((_e1985[0].v * _e1820) + (_e1985[1].v * _e1814.u)) + (_e1985[2].v * _e1814.v)));
                if (_e2092.indices[0] < _e97) {
                } else {
                    return;
                }
                let _e2098 = color_texels.member[(0u + _e2092.indices[0])];
                let _e2109 = (1f / 255f);
                if (_e2092.indices[1] < _e97) {
                } else {
                    return;
                }
                let _e2123 = color_texels.member[(0u + _e2092.indices[1])];
                let _e2134 = (1f / 255f);
                if (_e2092.indices[2] < _e97) {
                } else {
                    return;
                }
                let _e2151 = color_texels.member[(0u + _e2092.indices[2])];
                let _e2162 = (1f / 255f);
                if (_e2092.indices[3] < _e97) {
                } else {
                    return;
                }
                let _e2179 = color_texels.member[(0u + _e2092.indices[3])];
                let _e2190 = (1f / 255f);
                let _e2199 = (((((f32((_e2098 & 255u)) * _e2109) * _e2092.weights.x) + ((f32((_e2123 & 255u)) * _e2134) * _e2092.weights.y)) + ((f32((_e2151 & 255u)) * _e2162) * _e2092.weights.z)) + ((f32((_e2179 & 255u)) * _e2190) * _e2092.weights.w));
                let _e2200 = (((((f32(((_e2098 >> bitcast<u32>(8i)) & 255u)) * _e2109) * _e2092.weights.x) + ((f32(((_e2123 >> bitcast<u32>(8i)) & 255u)) * _e2134) * _e2092.weights.y)) + ((f32(((_e2151 >> bitcast<u32>(8i)) & 255u)) * _e2162) * _e2092.weights.z)) + ((f32(((_e2179 >> bitcast<u32>(8i)) & 255u)) * _e2190) * _e2092.weights.w));
                let _e2201 = (((((f32(((_e2098 >> bitcast<u32>(16i)) & 255u)) * _e2109) * _e2092.weights.x) + ((f32(((_e2123 >> bitcast<u32>(16i)) & 255u)) * _e2134) * _e2092.weights.y)) + ((f32(((_e2151 >> bitcast<u32>(16i)) & 255u)) * _e2162) * _e2092.weights.z)) + ((f32(((_e2179 >> bitcast<u32>(16i)) & 255u)) * _e2190) * _e2092.weights.w));
                phi_2905_ = vec3<f32>((_e2199 * _e2199), (_e2200 * _e2200), (_e2201 * _e2201));
            }
            let _e2207 = phi_2905_;
            let _e2209 = ((_e1991.base_color.x * ((((f32((_e1985[0].color & 255u)) * _e2008) * _e1820) + ((f32((_e1985[1].color & 255u)) * _e2027) * _e1814.u)) + ((f32((_e1985[2].color & 255u)) * _e2049) * _e1814.v))) * _e2207.x);
            let _e2211 = ((_e1991.base_color.y * ((((f32(((_e1985[0].color >> bitcast<u32>(8i)) & 255u)) * _e2008) * _e1820) + ((f32(((_e1985[1].color >> bitcast<u32>(8i)) & 255u)) * _e2027) * _e1814.u)) + ((f32(((_e1985[2].color >> bitcast<u32>(8i)) & 255u)) * _e2049) * _e1814.v))) * _e2207.y);
            let _e2213 = ((_e1991.base_color.z * ((((f32(((_e1985[0].color >> bitcast<u32>(16i)) & 255u)) * _e2008) * _e1820) + ((f32(((_e1985[1].color >> bitcast<u32>(16i)) & 255u)) * _e2027) * _e1814.u)) + ((f32(((_e1985[2].color >> bitcast<u32>(16i)) & 255u)) * _e2049) * _e1814.v))) * _e2207.z);
            let _e2214 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1886, _e1889);
            let _e2215 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1883, _e2214);
            if ((_e1991.flags & 2u) == 0u) {
                phi_2920_ = 0u;
            } else {
                phi_2920_ = 1u;
            }
            let _e2220 = phi_2920_;
            if (_e1985[0].normal == 2147516416u) {
                phi_3123_ = _e1963;
            } else {
                let _e2233 = (f32((bitcast<i32>((_e1985[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2239 = (f32((bitcast<i32>(_e1985[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2243 = ((1f - abs(_e2233)) - abs(_e2239));
                if (_e2243 < 0f) {
                    phi_2947_ = -(_e2243);
                } else {
                    phi_2947_ = 0f;
                }
                let _e2247 = phi_2947_;
                if (_e2233 < 0f) {
                    phi_2954_ = (_e2233 + _e2247);
                } else {
                    phi_2954_ = (_e2233 - _e2247);
                }
                let _e2252 = phi_2954_;
                if (_e2239 < 0f) {
                    phi_2961_ = (_e2239 + _e2247);
                } else {
                    phi_2961_ = (_e2239 - _e2247);
                }
                let _e2257 = phi_2961_;
                let _e2264 = (1f / sqrt((((_e2252 * _e2252) + (_e2257 * _e2257)) + (_e2243 * _e2243))));
                let _e2280 = (f32((bitcast<i32>((_e1985[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2286 = (f32((bitcast<i32>(_e1985[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2290 = ((1f - abs(_e2280)) - abs(_e2286));
                if (_e2290 < 0f) {
                    phi_2996_ = -(_e2290);
                } else {
                    phi_2996_ = 0f;
                }
                let _e2294 = phi_2996_;
                if (_e2280 < 0f) {
                    phi_3003_ = (_e2280 + _e2294);
                } else {
                    phi_3003_ = (_e2280 - _e2294);
                }
                let _e2299 = phi_3003_;
                if (_e2286 < 0f) {
                    phi_3010_ = (_e2286 + _e2294);
                } else {
                    phi_3010_ = (_e2286 - _e2294);
                }
                let _e2304 = phi_3010_;
                let _e2311 = (1f / sqrt((((_e2299 * _e2299) + (_e2304 * _e2304)) + (_e2290 * _e2290))));
                let _e2330 = (f32((bitcast<i32>((_e1985[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2336 = (f32((bitcast<i32>(_e1985[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2340 = ((1f - abs(_e2330)) - abs(_e2336));
                if (_e2340 < 0f) {
                    phi_3048_ = -(_e2340);
                } else {
                    phi_3048_ = 0f;
                }
                let _e2344 = phi_3048_;
                if (_e2330 < 0f) {
                    phi_3055_ = (_e2330 + _e2344);
                } else {
                    phi_3055_ = (_e2330 - _e2344);
                }
                let _e2349 = phi_3055_;
                if (_e2336 < 0f) {
                    phi_3062_ = (_e2336 + _e2344);
                } else {
                    phi_3062_ = (_e2336 - _e2344);
                }
                let _e2354 = phi_3062_;
                let _e2361 = (1f / sqrt((((_e2349 * _e2349) + (_e2354 * _e2354)) + (_e2340 * _e2340))));
                let _e2372 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(vec3<f32>(((((_e2252 * _e2264) * _e1820) + ((_e2299 * _e2311) * _e1814.u)) + ((_e2349 * _e2361) * _e1814.v)), ((((_e2257 * _e2264) * _e1820) + ((_e2304 * _e2311) * _e1814.u)) + ((_e2354 * _e2361) * _e1814.v)), ((((_e2243 * _e2264) * _e1820) + ((_e2290 * _e2311) * _e1814.u)) + ((_e2340 * _e2361) * _e1814.v))));
                let _e2384 = sqrt((((_e2372.x * _e2372.x) + (_e2372.y * _e2372.y)) + (_e2372.z * _e2372.z)));
                if (_e2384 > 0f) {
                    let _e2387 = (_e2372.x / _e2384);
                    let _e2389 = (_e2372.y / _e2384);
                    let _e2391 = (_e2372.z / _e2384);
                    if ((((_e2387 * _e1963.x) + (_e2389 * _e1963.y)) + (_e2391 * _e1963.z)) < 0f) {
                        phi_3121_ = vec3<f32>(-(_e2387), -(_e2389), -(_e2391));
                    } else {
                        phi_3121_ = (_e2372 / vec3(_e2384));
                    }
                    let _e2408 = phi_3121_;
                    phi_3122_ = _e2408;
                } else {
                    phi_3122_ = _e1963;
                }
                let _e2410 = phi_3122_;
                phi_3123_ = _e2410;
            }
            let _e2412 = phi_3123_;
            if (_e2209 > 0f) {
                if (_e2209 < 1f) {
                    phi_3132_ = _e2209;
                } else {
                    phi_3132_ = 1f;
                }
                let _e2416 = phi_3132_;
                phi_3133_ = _e2416;
            } else {
                phi_3133_ = 0f;
            }
            let _e2418 = phi_3133_;
            if (_e2211 > 0f) {
                if (_e2211 < 1f) {
                    phi_3143_ = _e2211;
                } else {
                    phi_3143_ = 1f;
                }
                let _e2423 = phi_3143_;
                phi_3144_ = _e2423;
            } else {
                phi_3144_ = 0f;
            }
            let _e2425 = phi_3144_;
            if (_e2213 > 0f) {
                if (_e2213 < 1f) {
                    phi_3154_ = _e2213;
                } else {
                    phi_3154_ = 1f;
                }
                let _e2430 = phi_3154_;
                phi_3155_ = _e2430;
            } else {
                phi_3155_ = 0f;
            }
            let _e2432 = phi_3155_;
            let _e2435 = ((sqrt(_e2418) * 255f) + 0.5f);
            let _e2444 = ((sqrt(_e2425) * 255f) + 0.5f);
            let _e2456 = ((sqrt(_e2432) * 255f) + 0.5f);
            phi_3190_ = abi_Sample(vec3<f32>(_e1850, _e1851, _e1852), _e2215, _e1963, _e2220, _e2412, ((select(select(u32(_e2435), 0u, (_e2435 < bitcast<f32>(0u))), 4294967295u, (_e2435 > bitcast<f32>(1333788671u))) | (select(select(u32(_e2444), 0u, (_e2444 < bitcast<f32>(0u))), 4294967295u, (_e2444 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e2456), 0u, (_e2456 < bitcast<f32>(0u))), 4294967295u, (_e2456 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_3190_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e2470 = phi_3190_;
        if (_e109.shift < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e109.shift)] = _e2470;
        if (_e1814.triangle != 4294967295u) {
            let _e2479 = ((1f - _e1814.u) - _e1814.v);
            if (_e1814.triangle < _e82) {
            } else {
                return;
            }
            let _e2484 = triangles.member[(0u + _e1814.triangle)];
            let _e2486 = (_e2484.i0_ & 2147483647u);
            if (_e2486 < _e100) {
            } else {
                return;
            }
            let _e2492 = before.member[(0u + _e2486)];
            if (_e2484.i1_ < _e100) {
            } else {
                return;
            }
            let _e2496 = before.member[(0u + _e2484.i1_)];
            if (_e2484.i2_ < _e100) {
            } else {
                return;
            }
            let _e2500 = before.member[(0u + _e2484.i2_)];
            let _e2505 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(vec3<f32>(_e2492.x, _e2492.y, _e2492.z));
            let _e2516 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(vec3<f32>(_e2496.x, _e2496.y, _e2496.z));
            let _e2530 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(vec3<f32>(_e2500.x, _e2500.y, _e2500.z));
            phi_3281_ = vec3<f32>((((_e2505.x * _e2479) + (_e2516.x * _e1814.u)) + (_e2530.x * _e1814.v)), (((_e2505.y * _e2479) + (_e2516.y * _e1814.u)) + (_e2530.y * _e1814.v)), (((_e2505.z * _e2479) + (_e2516.z * _e1814.u)) + (_e2530.z * _e1814.v)));
        } else {
            phi_3281_ = vec3<f32>(0f, 0f, 0f);
        }
        let _e2542 = phi_3281_;
        if (_e109.shift < arrayLength((&past.member))) {
        } else {
            return;
        }
        past.member[(0u + _e109.shift)] = vec4<f32>(_e2542.x, _e2542.y, _e2542.z, 1f);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_alpha_color_motion_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
