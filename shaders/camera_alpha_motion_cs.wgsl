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
var<storage> before: type_26;
@group(0) @binding(8) 
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
        let _e84 = phi_220_;
        let _e86 = phi_221_;
        phi_222_ = _e84;
        phi_223_ = _e86;
    } else {
        phi_222_ = lt_mask_LightPlace();
        phi_223_ = true;
    }
    let _e88 = phi_222_;
    let _e90 = phi_223_;
    if _e90 {
        phi_228_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_228_ = _e88;
    }
    let _e95 = phi_228_;
    return lt_mask_LightPlace(_e95.word, _e95.shift);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_243_: bool;
    var phi_247_: f32;

    if (param_3 != param_3) {
        phi_243_ = true;
    } else {
        let _e74 = (param_4 >= param_3);
        if _e74 {
        }
        phi_243_ = _e74;
    }
    let _e76 = phi_243_;
    if _e76 {
        phi_247_ = param_4;
    } else {
        phi_247_ = param_3;
    }
    let _e78 = phi_247_;
    return _e78;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_259_: bool;
    var phi_263_: f32;

    if (param_5 != param_5) {
        phi_259_ = true;
    } else {
        let _e74 = (param_6 <= param_5);
        if _e74 {
        }
        phi_259_ = _e74;
    }
    let _e76 = phi_259_;
    if _e76 {
        phi_263_ = param_6;
    } else {
        phi_263_ = param_5;
    }
    let _e78 = phi_263_;
    return _e78;
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

    let _e75 = (*param_7).size;
    let _e76 = (_e75 & 65535u);
    let _e78 = (*param_7).size;
    let _e80 = (_e78 >> bitcast<u32>(16i));
    let _e82 = (*param_7).flags;
    let _e84 = ((_e82 & 4u) != 0u);
    let _e86 = (*param_7).flags;
    let _e89 = ((_e86 >> bitcast<u32>(4u)) & 3u);
    if (_e89 == 0u) {
        if (param_8 > -8388608f) {
            let _e102 = f32(select(0i, select(select(i32(param_8), i32(-2147483648), (param_8 < bitcast<f32>(3472883712u))), 2147483647i, (param_8 > bitcast<f32>(1325400063u))), (param_8 == param_8)));
            if (_e102 > param_8) {
                phi_305_ = 1f;
            } else {
                phi_305_ = 0f;
            }
            let _e105 = phi_305_;
            if (param_8 < 8388608f) {
                phi_310_ = (_e102 - _e105);
                phi_311_ = false;
            } else {
                phi_310_ = f32();
                phi_311_ = true;
            }
            let _e108 = phi_310_;
            let _e110 = phi_311_;
            phi_312_ = _e108;
            phi_313_ = _e110;
        } else {
            phi_312_ = f32();
            phi_313_ = true;
        }
        let _e112 = phi_312_;
        let _e114 = phi_313_;
        if _e114 {
            phi_317_ = param_8;
        } else {
            phi_317_ = _e112;
        }
        let _e116 = phi_317_;
        phi_365_ = (param_8 - _e116);
    } else {
        if (_e89 == 1u) {
            let _e119 = (param_8 * 0.5f);
            if (_e119 > -8388608f) {
                let _e131 = f32(select(0i, select(select(i32(_e119), i32(-2147483648), (_e119 < bitcast<f32>(3472883712u))), 2147483647i, (_e119 > bitcast<f32>(1325400063u))), (_e119 == _e119)));
                if (_e131 > _e119) {
                    phi_343_ = 1f;
                } else {
                    phi_343_ = 0f;
                }
                let _e134 = phi_343_;
                if (_e119 < 8388608f) {
                    phi_348_ = (_e131 - _e134);
                    phi_349_ = false;
                } else {
                    phi_348_ = f32();
                    phi_349_ = true;
                }
                let _e137 = phi_348_;
                let _e139 = phi_349_;
                phi_350_ = _e137;
                phi_351_ = _e139;
            } else {
                phi_350_ = f32();
                phi_351_ = true;
            }
            let _e141 = phi_350_;
            let _e143 = phi_351_;
            if _e143 {
                phi_355_ = _e119;
            } else {
                phi_355_ = _e141;
            }
            let _e145 = phi_355_;
            let _e147 = (param_8 - (2f * _e145));
            if (_e147 > 1f) {
                phi_363_ = (2f - _e147);
            } else {
                phi_363_ = _e147;
            }
            let _e151 = phi_363_;
            phi_364_ = _e151;
        } else {
            phi_364_ = param_8;
        }
        let _e153 = phi_364_;
        phi_365_ = _e153;
    }
    let _e155 = phi_365_;
    if (_e155 > 0f) {
        if (_e155 < 1f) {
            phi_374_ = _e155;
        } else {
            phi_374_ = 1f;
        }
        let _e159 = phi_374_;
        phi_375_ = _e159;
    } else {
        phi_375_ = 0f;
    }
    let _e161 = phi_375_;
    let _e162 = (_e76 - 1u);
    let _e164 = (_e161 * f32(_e76));
    if _e84 {
        let _e171 = select(select(u32(_e164), 0u, (_e164 < bitcast<f32>(0u))), 4294967295u, (_e164 > bitcast<f32>(1333788671u)));
        if (_e162 < _e171) {
            phi_393_ = _e162;
        } else {
            phi_393_ = _e171;
        }
        let _e174 = phi_393_;
        phi_432_ = texture_Axis(_e174, _e174, 0f);
    } else {
        let _e176 = (_e164 + 0.5f);
        let _e183 = select(select(u32(_e176), 0u, (_e176 < bitcast<f32>(0u))), 4294967295u, (_e176 > bitcast<f32>(1333788671u)));
        if (_e76 < _e183) {
            phi_407_ = _e76;
        } else {
            phi_407_ = _e183;
        }
        let _e186 = phi_407_;
        if (_e89 == 0u) {
            phi_414_ = _e162;
        } else {
            phi_414_ = 0u;
        }
        let _e191 = phi_414_;
        if (_e89 == 0u) {
            phi_419_ = 0u;
        } else {
            phi_419_ = _e162;
        }
        let _e194 = phi_419_;
        if (_e186 == 0u) {
            phi_425_ = _e191;
        } else {
            phi_425_ = (_e186 - 1u);
        }
        let _e198 = phi_425_;
        if (_e186 > _e162) {
            phi_430_ = _e194;
        } else {
            phi_430_ = _e186;
        }
        let _e201 = phi_430_;
        phi_432_ = texture_Axis(_e198, _e201, (_e176 - f32(_e186)));
    }
    let _e204 = phi_432_;
    let _e206 = (*param_7).flags;
    let _e209 = ((_e206 >> bitcast<u32>(6u)) & 3u);
    if (_e209 == 0u) {
        if (param_9 > -8388608f) {
            let _e222 = f32(select(0i, select(select(i32(param_9), i32(-2147483648), (param_9 < bitcast<f32>(3472883712u))), 2147483647i, (param_9 > bitcast<f32>(1325400063u))), (param_9 == param_9)));
            if (_e222 > param_9) {
                phi_460_ = 1f;
            } else {
                phi_460_ = 0f;
            }
            let _e225 = phi_460_;
            if (param_9 < 8388608f) {
                phi_465_ = (_e222 - _e225);
                phi_466_ = false;
            } else {
                phi_465_ = f32();
                phi_466_ = true;
            }
            let _e228 = phi_465_;
            let _e230 = phi_466_;
            phi_467_ = _e228;
            phi_468_ = _e230;
        } else {
            phi_467_ = f32();
            phi_468_ = true;
        }
        let _e232 = phi_467_;
        let _e234 = phi_468_;
        if _e234 {
            phi_472_ = param_9;
        } else {
            phi_472_ = _e232;
        }
        let _e236 = phi_472_;
        phi_520_ = (param_9 - _e236);
    } else {
        if (_e209 == 1u) {
            let _e239 = (param_9 * 0.5f);
            if (_e239 > -8388608f) {
                let _e251 = f32(select(0i, select(select(i32(_e239), i32(-2147483648), (_e239 < bitcast<f32>(3472883712u))), 2147483647i, (_e239 > bitcast<f32>(1325400063u))), (_e239 == _e239)));
                if (_e251 > _e239) {
                    phi_498_ = 1f;
                } else {
                    phi_498_ = 0f;
                }
                let _e254 = phi_498_;
                if (_e239 < 8388608f) {
                    phi_503_ = (_e251 - _e254);
                    phi_504_ = false;
                } else {
                    phi_503_ = f32();
                    phi_504_ = true;
                }
                let _e257 = phi_503_;
                let _e259 = phi_504_;
                phi_505_ = _e257;
                phi_506_ = _e259;
            } else {
                phi_505_ = f32();
                phi_506_ = true;
            }
            let _e261 = phi_505_;
            let _e263 = phi_506_;
            if _e263 {
                phi_510_ = _e239;
            } else {
                phi_510_ = _e261;
            }
            let _e265 = phi_510_;
            let _e267 = (param_9 - (2f * _e265));
            if (_e267 > 1f) {
                phi_518_ = (2f - _e267);
            } else {
                phi_518_ = _e267;
            }
            let _e271 = phi_518_;
            phi_519_ = _e271;
        } else {
            phi_519_ = param_9;
        }
        let _e273 = phi_519_;
        phi_520_ = _e273;
    }
    let _e275 = phi_520_;
    if (_e275 > 0f) {
        if (_e275 < 1f) {
            phi_529_ = _e275;
        } else {
            phi_529_ = 1f;
        }
        let _e279 = phi_529_;
        phi_530_ = _e279;
    } else {
        phi_530_ = 0f;
    }
    let _e281 = phi_530_;
    let _e282 = (_e80 - 1u);
    let _e284 = (_e281 * f32(_e80));
    if _e84 {
        let _e291 = select(select(u32(_e284), 0u, (_e284 < bitcast<f32>(0u))), 4294967295u, (_e284 > bitcast<f32>(1333788671u)));
        if (_e282 < _e291) {
            phi_548_ = _e282;
        } else {
            phi_548_ = _e291;
        }
        let _e294 = phi_548_;
        phi_587_ = texture_Axis(_e294, _e294, 0f);
    } else {
        let _e296 = (_e284 + 0.5f);
        let _e303 = select(select(u32(_e296), 0u, (_e296 < bitcast<f32>(0u))), 4294967295u, (_e296 > bitcast<f32>(1333788671u)));
        if (_e80 < _e303) {
            phi_562_ = _e80;
        } else {
            phi_562_ = _e303;
        }
        let _e306 = phi_562_;
        if (_e209 == 0u) {
            phi_569_ = _e282;
        } else {
            phi_569_ = 0u;
        }
        let _e311 = phi_569_;
        if (_e209 == 0u) {
            phi_574_ = 0u;
        } else {
            phi_574_ = _e282;
        }
        let _e314 = phi_574_;
        if (_e306 == 0u) {
            phi_580_ = _e311;
        } else {
            phi_580_ = (_e306 - 1u);
        }
        let _e318 = phi_580_;
        if (_e306 > _e282) {
            phi_585_ = _e314;
        } else {
            phi_585_ = _e306;
        }
        let _e321 = phi_585_;
        phi_587_ = texture_Axis(_e318, _e321, (_e296 - f32(_e306)));
    }
    let _e324 = phi_587_;
    let _e328 = (*param_7).offset;
    let _e335 = (*param_7).offset;
    let _e342 = (*param_7).offset;
    let _e349 = (*param_7).offset;
    return texture_TexelQuad(array<u32, 4>(((_e328 + (_e324.low * _e76)) + _e204.low), ((_e335 + (_e324.low * _e76)) + _e204.high), ((_e342 + (_e324.high * _e76)) + _e204.low), ((_e349 + (_e324.high * _e76)) + _e204.high)), vec4<f32>(((1f - _e204.fraction) * (1f - _e324.fraction)), (_e204.fraction * (1f - _e324.fraction)), ((1f - _e204.fraction) * _e324.fraction), (_e204.fraction * _e324.fraction)));
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
    let _e75 = phi_646_;
    return _e75;
}

fn _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(param_14: vec3<f32>) -> vec3<f32> {
    return vec3<f32>(1f, 1f, 1f);
}

fn _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(param_15: vec3<f32>) -> vec3<f32> {
    return param_15;
}

fn _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(param_16: vec3<f32>) -> vec3<f32> {
    return param_16;
}

fn function_() {
    var local: texture_TextureView;
    var local_1: lt_bvh_traverse_Stack;
    var phi_804_: bool;
    var phi_805_: bool;
    var phi_806_: bool;
    var phi_810_: bool;
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
    var phi_831_: bool;
    var phi_835_: bool;
    var phi_910_: f32;
    var phi_917_: f32;
    var phi_925_: f32;
    var phi_932_: f32;
    var phi_940_: f32;
    var phi_947_: f32;
    var phi_972_: f32;
    var phi_977_: f32;
    var phi_982_: f32;
    var phi_1015_: bool;
    var phi_1016_: bool;
    var phi_1024_: u32;
    var phi_1025_: u32;
    var phi_1043_: vec3<f32>;
    var phi_1044_: vec3<f32>;
    var phi_1058_: u32;
    var phi_1063_: u32;
    var phi_1068_: u32;
    var phi_1182_: bool;
    var phi_1183_: bool;
    var phi_1214_: u32;
    var phi_1216_: lt_bvh_Hit;
    var phi_1219_: u32;
    var phi_1304_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1331_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1358_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1364_: u32;
    var phi_1367_: u32;
    var phi_1381_: u32;
    var phi_1391_: u32;
    var phi_1401_: u32;
    var phi_1419_: u32;
    var phi_1429_: u32;
    var phi_1439_: u32;
    var phi_1475_: u32;
    var phi_1488_: u32;
    var phi_1493_: u32;
    var phi_1494_: u32;
    var phi_1495_: u32;
    var phi_1365_: u32;
    var phi_1368_: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_1553_: lt_bvh_Hit;
    var phi_1556_: u32;
    var phi_1602_: vec3<f32>;
    var phi_1603_: vec3<f32>;
    var phi_1634_: vec3<f32>;
    var phi_1635_: vec3<f32>;
    var phi_1666_: vec3<f32>;
    var phi_1667_: vec3<f32>;
    var phi_1685_: bool;
    var phi_1686_: bool;
    var phi_1690_: f32;
    var phi_1691_: f32;
    var phi_1692_: f32;
    var phi_1693_: f32;
    var phi_1701_: f32;
    var phi_1711_: bool;
    var phi_1712_: bool;
    var phi_1716_: f32;
    var phi_1717_: f32;
    var phi_1718_: f32;
    var phi_1719_: f32;
    var phi_1727_: f32;
    var phi_1737_: bool;
    var phi_1738_: bool;
    var phi_1742_: f32;
    var phi_1743_: f32;
    var phi_1744_: f32;
    var phi_1745_: f32;
    var phi_1753_: f32;
    var phi_1768_: f32;
    var phi_1769_: bool;
    var phi_1770_: f32;
    var phi_1771_: bool;
    var phi_1772_: f32;
    var phi_1773_: bool;
    var phi_1791_: f32;
    var phi_1792_: bool;
    var phi_1793_: bool;
    var phi_1794_: f32;
    var phi_1795_: bool;
    var phi_1796_: bool;
    var phi_1800_: bool;
    var phi_1801_: f32;
    var phi_1802_: bool;
    var phi_1832_: vec3<f32>;
    var phi_1833_: vec3<f32>;
    var phi_1858_: vec3<f32>;
    var phi_1859_: vec3<f32>;
    var phi_1884_: vec3<f32>;
    var phi_1885_: vec3<f32>;
    var phi_1943_: f32;
    var phi_1952_: f32;
    var phi_1961_: f32;
    var phi_1970_: f32;
    var phi_1977_: f32;
    var phi_1984_: f32;
    var phi_1997_: f32;
    var phi_2006_: f32;
    var phi_2015_: f32;
    var phi_2024_: f32;
    var phi_2031_: f32;
    var phi_2038_: f32;
    var phi_2061_: f32;
    var phi_2066_: f32;
    var phi_2071_: f32;
    var phi_2079_: f32;
    var phi_2084_: f32;
    var phi_2089_: f32;
    var phi_2101_: f32;
    var phi_2106_: f32;
    var phi_2111_: f32;
    var phi_2116_: f32;
    var phi_2121_: lt_bvh_triangle_Intersection;
    var phi_2122_: bool;
    var phi_2123_: lt_bvh_triangle_Intersection;
    var phi_2124_: bool;
    var phi_2128_: lt_bvh_triangle_Intersection;
    var phi_2129_: bool;
    var phi_2130_: lt_bvh_triangle_Intersection;
    var phi_2131_: bool;
    var phi_2132_: bool;
    var phi_2136_: bool;
    var phi_2140_: lt_bvh_triangle_Intersection;
    var phi_2179_: bool;
    var phi_2180_: bool;
    var phi_2181_: bool;
    var phi_2182_: bool;
    var phi_2183_: bool;
    var phi_2184_: bool;
    var phi_2188_: bool;
    var phi_2189_: bool;
    var phi_2392_: f32;
    var phi_2395_: bool;
    var phi_2396_: bool;
    var phi_2400_: bool;
    var phi_2408_: lt_bvh_Hit;
    var phi_2409_: lt_bvh_Hit;
    var phi_2410_: lt_bvh_Hit;
    var phi_2411_: lt_bvh_Hit;
    var phi_1554_: lt_bvh_Hit;
    var phi_1557_: u32;
    var phi_2412_: bool;
    var phi_2451_: bool;
    var phi_2452_: bool;
    var phi_2483_: u32;
    var phi_1217_: lt_bvh_Hit;
    var phi_1220_: u32;
    var phi_2484_: lt_bvh_Hit;
    var phi_2485_: lt_bvh_Hit;
    var phi_2486_: bool;
    var phi_2490_: lt_bvh_Hit;
    var phi_2555_: f32;
    var phi_2560_: f32;
    var phi_2565_: f32;
    var phi_2576_: f32;
    var phi_2581_: f32;
    var phi_2586_: f32;
    var phi_2662_: vec3<f32>;
    var phi_2783_: u32;
    var phi_2810_: f32;
    var phi_2817_: f32;
    var phi_2824_: f32;
    var phi_2859_: f32;
    var phi_2866_: f32;
    var phi_2873_: f32;
    var phi_2911_: f32;
    var phi_2918_: f32;
    var phi_2925_: f32;
    var phi_2984_: vec3<f32>;
    var phi_2985_: vec3<f32>;
    var phi_2986_: vec3<f32>;
    var phi_2995_: f32;
    var phi_2996_: f32;
    var phi_3006_: f32;
    var phi_3007_: f32;
    var phi_3017_: f32;
    var phi_3018_: f32;
    var phi_3053_: abi_Sample;
    var phi_3144_: vec3<f32>;
    var local_5: lt_bvh_Hit;
    var local_6: lt_bvh_Hit;

    let _e73 = id_1;
    let _e77 = arrayLength((&nodes.member));
    let _e80 = arrayLength((&triangles.member));
    let _e83 = arrayLength((&vertices.member));
    let _e86 = arrayLength((&materials.member));
    let _e92 = arrayLength((&alpha_texels.member));
    let _e95 = arrayLength((&before.member));
    let _e101 = p.member.size[0u];
    let _e103 = p.member.size[1u];
    let _e104 = lt_shaders_entry_pixel_index(_e73, _e101, _e103);
    if (bitcast<i32>(_e104.word) != 0i) {
        let _e112 = p.member.eye;
        let _e117 = p.member.size[0u];
        let _e121 = ((((f32(_e73.x) + 0.5f) / f32(_e117)) * 2f) - 1f);
        let _e126 = p.member.size[1u];
        let _e130 = (1f - (((f32(_e73.y) + 0.5f) / f32(_e126)) * 2f));
        let _e132 = p.member.forward;
        let _e134 = p.member.right;
        let _e148 = p.member.up;
        let _e159 = _lt_bvh_ray_Ray_new(_e112, vec3<f32>(((_e132.x + (_e134.x * _e121)) + (_e148.x * _e130)), ((_e132.y + (_e134.y * _e121)) + (_e148.y * _e130)), ((_e132.z + (_e134.z * _e121)) + (_e148.z * _e130))));
        let _e161 = lt_bvh_Hit(_e159.tmax, 0f, 0f, 4294967295u, 4294967295u);
        let _e171 = abs(_e159.direction.x);
        let _e173 = abs(_e159.direction.y);
        let _e175 = abs(_e159.direction.z);
        if (abs(_e159.origin.x) < 1000000000000000f) {
            if (abs(_e159.origin.y) < 1000000000000000f) {
                if (abs(_e159.origin.z) < 1000000000000000f) {
                    if (_e171 < 1000000000000000f) {
                        if (_e173 < 1000000000000000f) {
                            if (_e175 < 1000000000000000f) {
                                if (_e171 > 0f) {
                                    phi_805_ = bool();
                                    phi_806_ = true;
                                } else {
                                    let _e183 = (_e173 > 0f);
                                    if _e183 {
                                        phi_804_ = bool();
                                    } else {
                                        phi_804_ = (_e175 > 0f);
                                    }
                                    let _e186 = phi_804_;
                                    phi_805_ = _e186;
                                    phi_806_ = _e183;
                                }
                                let _e188 = phi_805_;
                                let _e190 = phi_806_;
                                if _e190 {
                                    phi_810_ = true;
                                } else {
                                    phi_810_ = _e188;
                                }
                                let _e192 = phi_810_;
                                phi_811_ = _e192;
                                phi_812_ = false;
                            } else {
                                phi_811_ = bool();
                                phi_812_ = true;
                            }
                            let _e194 = phi_811_;
                            let _e196 = phi_812_;
                            phi_813_ = _e194;
                            phi_814_ = false;
                            phi_815_ = _e196;
                        } else {
                            phi_813_ = bool();
                            phi_814_ = true;
                            phi_815_ = false;
                        }
                        let _e198 = phi_813_;
                        let _e200 = phi_814_;
                        let _e202 = phi_815_;
                        phi_816_ = _e198;
                        phi_817_ = _e200;
                        phi_818_ = _e202;
                    } else {
                        phi_816_ = bool();
                        phi_817_ = true;
                        phi_818_ = false;
                    }
                    let _e204 = phi_816_;
                    let _e206 = phi_817_;
                    let _e208 = phi_818_;
                    phi_819_ = _e204;
                    phi_820_ = _e206;
                    phi_821_ = _e208;
                } else {
                    phi_819_ = bool();
                    phi_820_ = true;
                    phi_821_ = false;
                }
                let _e210 = phi_819_;
                let _e212 = phi_820_;
                let _e214 = phi_821_;
                phi_822_ = _e210;
                phi_823_ = _e212;
                phi_824_ = _e214;
            } else {
                phi_822_ = bool();
                phi_823_ = true;
                phi_824_ = false;
            }
            let _e216 = phi_822_;
            let _e218 = phi_823_;
            let _e220 = phi_824_;
            phi_825_ = _e216;
            phi_826_ = _e218;
            phi_827_ = _e220;
        } else {
            phi_825_ = bool();
            phi_826_ = true;
            phi_827_ = false;
        }
        let _e222 = phi_825_;
        let _e224 = phi_826_;
        let _e226 = phi_827_;
        if _e224 {
            phi_831_ = true;
        } else {
            phi_831_ = _e226;
        }
        let _e228 = phi_831_;
        if _e228 {
            phi_835_ = false;
        } else {
            phi_835_ = _e222;
        }
        let _e230 = phi_835_;
        if _e230 {
            let _e231 = (0u >= _e77);
            if _e231 {
                phi_2484_ = lt_bvh_Hit();
            } else {
                if (0u < _e77) {
                } else {
                    return;
                }
                let _e237 = nodes.member[(0u + 0u)].frame[0u];
                let _e241 = nodes.member[(0u + 0u)].frame[1u];
                let _e245 = nodes.member[(0u + 0u)].frame[2u];
                let _e249 = nodes.member[(0u + 0u)].frame[0u];
                let _e253 = nodes.member[(0u + 0u)].frame[1u];
                let _e257 = nodes.member[(0u + 0u)].frame[2u];
                let _e261 = nodes.member[(0u + 0u)].frame[3u];
                let _e299 = core_intrinsics_maximum_number_nsz_f32_(abs(_e159.direction.x), abs(_e159.direction.y));
                let _e300 = core_intrinsics_maximum_number_nsz_f32_(_e299, abs(_e159.direction.z));
                let _e301 = (_e300 * 0.0000000000009094947f);
                if (abs(_e159.direction.x) < _e301) {
                    phi_910_ = _e301;
                } else {
                    phi_910_ = abs(_e159.direction.x);
                }
                let _e307 = phi_910_;
                if (_e159.direction.x < 0f) {
                    phi_917_ = (-1f / _e307);
                } else {
                    phi_917_ = (1f / _e307);
                }
                let _e312 = phi_917_;
                if (abs(_e159.direction.y) < _e301) {
                    phi_925_ = _e301;
                } else {
                    phi_925_ = abs(_e159.direction.y);
                }
                let _e318 = phi_925_;
                if (_e159.direction.y < 0f) {
                    phi_932_ = (-1f / _e318);
                } else {
                    phi_932_ = (1f / _e318);
                }
                let _e323 = phi_932_;
                if (abs(_e159.direction.z) < _e301) {
                    phi_940_ = _e301;
                } else {
                    phi_940_ = abs(_e159.direction.z);
                }
                let _e329 = phi_940_;
                if (_e159.direction.z < 0f) {
                    phi_947_ = (-1f / _e329);
                } else {
                    phi_947_ = (1f / _e329);
                }
                let _e334 = phi_947_;
                let _e342 = abs((bitcast<f32>(_e237) - _e159.origin.x));
                let _e343 = abs((bitcast<f32>(_e241) - _e159.origin.y));
                let _e344 = abs((bitcast<f32>(_e245) - _e159.origin.z));
                let _e352 = abs(((bitcast<f32>(_e249) + (bitcast<f32>((((_e261 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e159.origin.x));
                let _e353 = abs(((bitcast<f32>(_e253) + (bitcast<f32>((((_e261 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e159.origin.y));
                let _e354 = abs(((bitcast<f32>(_e257) + (bitcast<f32>((((_e261 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e159.origin.z));
                if (_e342 > _e352) {
                    phi_972_ = _e342;
                } else {
                    phi_972_ = _e352;
                }
                let _e357 = phi_972_;
                if (_e343 > _e353) {
                    phi_977_ = _e343;
                } else {
                    phi_977_ = _e353;
                }
                let _e360 = phi_977_;
                if (_e344 > _e354) {
                    phi_982_ = _e344;
                } else {
                    phi_982_ = _e354;
                }
                let _e363 = phi_982_;
                let _e364 = core_intrinsics_maximum_number_nsz_f32_(_e357, _e360);
                let _e365 = core_intrinsics_maximum_number_nsz_f32_(_e364, _e363);
                let _e370 = (_e365 * 0.0000019073486f);
                let _e371 = (abs(_e312) * _e370);
                let _e372 = (abs(_e323) * _e370);
                let _e373 = (abs(_e334) * _e370);
                let _e377 = (_e365 * 0.0000009536743f);
                let _e378 = (abs(_e312) * _e377);
                let _e379 = (abs(_e323) * _e377);
                let _e380 = (abs(_e334) * _e377);
                let _e383 = abs(_e159.direction.x);
                let _e385 = abs(_e159.direction.y);
                let _e387 = abs(_e159.direction.z);
                if (_e383 >= _e385) {
                    if (_e383 >= _e387) {
                        phi_1015_ = false;
                    } else {
                        phi_1015_ = true;
                    }
                    let _e391 = phi_1015_;
                    phi_1016_ = _e391;
                } else {
                    phi_1016_ = true;
                }
                let _e393 = phi_1016_;
                if _e393 {
                    if (_e385 >= _e387) {
                        phi_1024_ = 1u;
                    } else {
                        phi_1024_ = 2u;
                    }
                    let _e396 = phi_1024_;
                    phi_1025_ = _e396;
                } else {
                    phi_1025_ = 0u;
                }
                let _e398 = phi_1025_;
                if (_e398 == 0u) {
                    phi_1044_ = vec3<f32>(_e159.direction.y, _e159.direction.z, _e159.direction.x);
                } else {
                    if (_e398 == 1u) {
                        phi_1043_ = vec3<f32>(_e159.direction.z, _e159.direction.x, _e159.direction.y);
                    } else {
                        phi_1043_ = _e159.direction;
                    }
                    let _e411 = phi_1043_;
                    phi_1044_ = _e411;
                }
                let _e413 = phi_1044_;
                let _e417 = (_e413.x / _e413.z);
                let _e420 = (_e413.y / _e413.z);
                if (_e312 < 0f) {
                    phi_1058_ = 0u;
                } else {
                    phi_1058_ = 1u;
                }
                let _e425 = phi_1058_;
                if (_e323 < 0f) {
                    phi_1063_ = 0u;
                } else {
                    phi_1063_ = 2u;
                }
                let _e428 = phi_1063_;
                if (_e334 < 0f) {
                    phi_1068_ = 0u;
                } else {
                    phi_1068_ = 4u;
                }
                let _e431 = phi_1068_;
                let _e433 = ((_e425 | _e428) | _e431);
                let _e434 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e434.first[0], _e434.first[1], _e434.first[2], _e434.first[3], _e434.first[4], _e434.first[5], _e434.first[6], _e434.first[7], _e434.first[8], _e434.first[9], _e434.first[10], _e434.first[11], _e434.first[12], _e434.first[13], _e434.first[14], _e434.first[15], _e434.first[16], _e434.first[17], _e434.first[18], _e434.first[19], _e434.first[20], _e434.first[21], _e434.first[22], _e434.first[23], _e434.first[24], _e434.first[25], _e434.first[26], _e434.first[27], _e434.first[28], _e434.first[29], _e434.first[30], _e434.first[31]), array<u32, 32>(_e434.mask[0], _e434.mask[1], _e434.mask[2], _e434.mask[3], _e434.mask[4], _e434.mask[5], _e434.mask[6], _e434.mask[7], _e434.mask[8], _e434.mask[9], _e434.mask[10], _e434.mask[11], _e434.mask[12], _e434.mask[13], _e434.mask[14], _e434.mask[15], _e434.mask[16], _e434.mask[17], _e434.mask[18], _e434.mask[19], _e434.mask[20], _e434.mask[21], _e434.mask[22], _e434.mask[23], _e434.mask[24], _e434.mask[25], _e434.mask[26], _e434.mask[27], _e434.mask[28], _e434.mask[29], _e434.mask[30], _e434.mask[31]), _e434.len, _e434.group, _e434.group_mask);
                let _e508 = local_1.group_mask;
                if ((_e508 & 4278190080u) == 0u) {
                    let _e512 = local_1.len;
                    if (_e512 == 0u) {
                        phi_1182_ = false;
                    } else {
                        let _e516 = local_1.len;
                        local_1.len = (_e516 - 1u);
                        let _e519 = local_1.len;
                        if (_e519 < 32u) {
                        } else {
                            return;
                        }
                        let _e524 = local_1.first[(0u + _e519)];
                        local_1.group = _e524;
                        let _e527 = local_1.len;
                        if (_e527 < 32u) {
                        } else {
                            return;
                        }
                        let _e532 = local_1.mask[(0u + _e527)];
                        local_1.group_mask = _e532;
                        phi_1182_ = true;
                    }
                    let _e535 = phi_1182_;
                    phi_1183_ = _e535;
                } else {
                    phi_1183_ = true;
                }
                let _e537 = phi_1183_;
                if _e537 {
                    let _e539 = local_1.group_mask;
                    let _e545 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e539)), 32u, (_e539 == 0u)));
                    let _e549 = local_1.group_mask;
                    let _e563 = local_1.group_mask;
                    local_1.group_mask = (_e563 & ~((1u << bitcast<u32>((_e545 & 31u)))));
                    let _e566 = local_1.group;
                    phi_1214_ = (_e566 + countOneBits(((_e549 & ~((4294967295u << bitcast<u32>((((_e545 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1214_ = 4294967295u;
                }
                let _e569 = phi_1214_;
                phi_1216_ = _e161;
                phi_1219_ = _e569;
                loop {
                    let _e571 = phi_1216_;
                    let _e573 = phi_1219_;
                    local_6 = _e571;
                    let _e574 = (_e573 != 4294967295u);
                    if _e574 {
                        if (_e573 < _e77) {
                        } else {
                            return;
                        }
                        let _e582 = nodes.member[(0u + _e573)].frame[3u];
                        let _e607 = (bitcast<f32>((((_e582 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e312);
                        let _e608 = (bitcast<f32>((((_e582 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e323);
                        let _e609 = (bitcast<f32>((((_e582 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e334);
                        let _e612 = nodes.member[(0u + _e573)].frame[0u];
                        let _e616 = nodes.member[(0u + _e573)].frame[1u];
                        let _e620 = nodes.member[(0u + _e573)].frame[2u];
                        let _e628 = ((bitcast<f32>(_e612) - _e159.origin.x) * _e312);
                        let _e629 = ((bitcast<f32>(_e616) - _e159.origin.y) * _e323);
                        let _e630 = ((bitcast<f32>(_e620) - _e159.origin.z) * _e334);
                        let _e638 = nodes.member[(0u + _e573)].x;
                        if (_e312 < 0f) {
                            let _e649 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e638.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e655 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e649.unnamed.word, _e638.w), _e649.unnamed_1);
                            let _e661 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e655.unnamed, lt_mask_LightPlace(_e638.x, _e655.unnamed_1.shift));
                            phi_1304_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e661.unnamed, lt_mask_LightPlace(_e661.unnamed_1.word, _e638.y));
                        } else {
                            let _e677 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e638.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e683 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e677.unnamed.word, _e638.y), _e677.unnamed_1);
                            let _e689 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e683.unnamed, lt_mask_LightPlace(_e638.z, _e683.unnamed_1.shift));
                            phi_1304_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e689.unnamed, lt_mask_LightPlace(_e689.unnamed_1.word, _e638.w));
                        }
                        let _e697 = phi_1304_;
                        let _e707 = nodes.member[(0u + _e573)].y;
                        if (_e323 < 0f) {
                            let _e718 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e707.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e724 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e718.unnamed.word, _e707.w), _e718.unnamed_1);
                            let _e730 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e724.unnamed, lt_mask_LightPlace(_e707.x, _e724.unnamed_1.shift));
                            phi_1331_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e730.unnamed, lt_mask_LightPlace(_e730.unnamed_1.word, _e707.y));
                        } else {
                            let _e746 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e707.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e752 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e746.unnamed.word, _e707.y), _e746.unnamed_1);
                            let _e758 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e752.unnamed, lt_mask_LightPlace(_e707.z, _e752.unnamed_1.shift));
                            phi_1331_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e758.unnamed, lt_mask_LightPlace(_e758.unnamed_1.word, _e707.w));
                        }
                        let _e766 = phi_1331_;
                        let _e776 = nodes.member[(0u + _e573)].z;
                        if (_e334 < 0f) {
                            let _e787 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e776.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e793 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e787.unnamed.word, _e776.w), _e787.unnamed_1);
                            let _e799 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e793.unnamed, lt_mask_LightPlace(_e776.x, _e793.unnamed_1.shift));
                            phi_1358_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e799.unnamed, lt_mask_LightPlace(_e799.unnamed_1.word, _e776.y));
                        } else {
                            let _e815 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e776.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e821 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e815.unnamed.word, _e776.y), _e815.unnamed_1);
                            let _e827 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e821.unnamed, lt_mask_LightPlace(_e776.z, _e821.unnamed_1.shift));
                            phi_1358_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e827.unnamed, lt_mask_LightPlace(_e827.unnamed_1.word, _e776.w));
                        }
                        let _e835 = phi_1358_;
                        phi_1364_ = 0u;
                        phi_1367_ = 0u;
                        loop {
                            let _e845 = phi_1364_;
                            let _e847 = phi_1367_;
                            local_2 = _e847;
                            local_3 = _e847;
                            local_4 = _e847;
                            let _e848 = (_e845 < 8u);
                            if _e848 {
                                let _e850 = (_e845 >> bitcast<u32>(2i));
                                let _e851 = (_e845 & 3u);
                                if (_e850 == 0u) {
                                    phi_1381_ = _e697.unnamed.word;
                                } else {
                                    phi_1381_ = _e697.unnamed.shift;
                                }
                                let _e854 = phi_1381_;
                                if (_e850 == 0u) {
                                    phi_1391_ = _e766.unnamed.word;
                                } else {
                                    phi_1391_ = _e766.unnamed.shift;
                                }
                                let _e863 = phi_1391_;
                                if (_e850 == 0u) {
                                    phi_1401_ = _e835.unnamed.word;
                                } else {
                                    phi_1401_ = _e835.unnamed.shift;
                                }
                                let _e872 = phi_1401_;
                                let _e885 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e854 >> bitcast<u32>(((_e851 * 8u) & 31u))) & 255u)) * _e607) + (_e628 - _e371)), ((f32(((_e863 >> bitcast<u32>(((_e851 * 8u) & 31u))) & 255u)) * _e608) + (_e629 - _e372)));
                                let _e886 = core_intrinsics_maximum_number_nsz_f32_(_e885, ((f32(((_e872 >> bitcast<u32>(((_e851 * 8u) & 31u))) & 255u)) * _e609) + (_e630 - _e373)));
                                if (_e850 == 0u) {
                                    phi_1419_ = _e697.unnamed_1.word;
                                } else {
                                    phi_1419_ = _e697.unnamed_1.shift;
                                }
                                let _e889 = phi_1419_;
                                if (_e850 == 0u) {
                                    phi_1429_ = _e766.unnamed_1.word;
                                } else {
                                    phi_1429_ = _e766.unnamed_1.shift;
                                }
                                let _e898 = phi_1429_;
                                if (_e850 == 0u) {
                                    phi_1439_ = _e835.unnamed_1.word;
                                } else {
                                    phi_1439_ = _e835.unnamed_1.shift;
                                }
                                let _e907 = phi_1439_;
                                let _e920 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e889 >> bitcast<u32>(((_e851 * 8u) & 31u))) & 255u)) * _e607) + (_e628 + _e371)), ((f32(((_e898 >> bitcast<u32>(((_e851 * 8u) & 31u))) & 255u)) * _e608) + (_e629 + _e372)));
                                let _e921 = core_intrinsics_minimum_number_nsz_f32_(_e920, ((f32(((_e907 >> bitcast<u32>(((_e851 * 8u) & 31u))) & 255u)) * _e609) + (_e630 + _e373)));
                                if (_e886 <= _e921) {
                                    if (_e886 <= _e571.t) {
                                        if (_e921 >= _e159.tmin) {
                                            if (_e850 == 0u) {
                                                let _e928 = nodes.member[(0u + _e573)].links[2u];
                                                phi_1475_ = _e928;
                                            } else {
                                                let _e931 = nodes.member[(0u + _e573)].links[3u];
                                                phi_1475_ = _e931;
                                            }
                                            let _e933 = phi_1475_;
                                            let _e938 = ((_e933 >> bitcast<u32>(((_e851 * 8u) & 31u))) & 255u);
                                            let _e939 = (_e938 & 31u);
                                            if (_e939 >= 24u) {
                                                phi_1488_ = (24u + ((_e939 - 24u) ^ _e433));
                                            } else {
                                                phi_1488_ = _e939;
                                            }
                                            let _e945 = phi_1488_;
                                            phi_1493_ = (_e847 | ((_e938 >> bitcast<u32>(5i)) << bitcast<u32>((_e945 & 31u))));
                                        } else {
                                            phi_1493_ = _e847;
                                        }
                                        let _e953 = phi_1493_;
                                        phi_1494_ = _e953;
                                    } else {
                                        phi_1494_ = _e847;
                                    }
                                    let _e955 = phi_1494_;
                                    phi_1495_ = _e955;
                                } else {
                                    phi_1495_ = _e847;
                                }
                                let _e957 = phi_1495_;
                                phi_1365_ = (_e845 + 1u);
                                phi_1368_ = _e957;
                            } else {
                                phi_1365_ = u32();
                                phi_1368_ = u32();
                            }
                            let _e960 = phi_1365_;
                            let _e962 = phi_1368_;
                            continue;
                            continuing {
                                phi_1364_ = _e960;
                                phi_1367_ = _e962;
                                break if !(_e848);
                            }
                        }
                        let _e966 = nodes.member[(0u + _e573)].links[0u];
                        let _e970 = nodes.member[(0u + _e573)].frame[3u];
                        let _e974 = local_2;
                        if ((_e974 & 4278190080u) == 0u) {
                        } else {
                            let _e978 = local_1.group_mask;
                            if ((_e978 & 4278190080u) == 0u) {
                            } else {
                                let _e982 = local_1.len;
                                if (_e982 < 32u) {
                                    let _e985 = local_1.group;
                                    let _e987 = local_1.len;
                                    if (_e987 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.first[(0u + _e987)] = _e985;
                                    let _e993 = local_1.group_mask;
                                    let _e995 = local_1.len;
                                    if (_e995 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.mask[(0u + _e995)] = _e993;
                                    let _e1002 = local_1.len;
                                    local_1.len = (_e1002 + 1u);
                                }
                            }
                            local_1.group = (0u + _e966);
                            let _e1006 = local_3;
                            local_1.group_mask = ((_e1006 & 4278190080u) | (_e970 >> bitcast<u32>(24i)));
                        }
                        let _e1011 = local_4;
                        phi_1553_ = _e571;
                        phi_1556_ = (_e1011 & 16777215u);
                        loop {
                            let _e1014 = phi_1553_;
                            let _e1016 = phi_1556_;
                            local_5 = _e1014;
                            if (_e1016 == 0u) {
                                phi_1554_ = lt_bvh_Hit();
                                phi_1557_ = u32();
                                phi_2412_ = false;
                            } else {
                                let _e1020 = nodes.member[(0u + _e573)].links[1u];
                                let _e1025 = ((0u + _e1020) + select(firstTrailingBit(_e1016), 32u, (_e1016 == 0u)));
                                if (_e1025 < _e80) {
                                } else {
                                    return;
                                }
                                let _e1032 = triangles.member[(0u + _e1025)].v0_;
                                let _e1035 = (_e1032.x - _e159.origin.x);
                                let _e1038 = (_e1032.y - _e159.origin.y);
                                let _e1041 = (_e1032.z - _e159.origin.z);
                                if (_e398 == 0u) {
                                    phi_1603_ = vec3<f32>(_e1038, _e1041, _e1035);
                                } else {
                                    if (_e398 == 1u) {
                                        phi_1602_ = vec3<f32>(_e1041, _e1035, _e1038);
                                    } else {
                                        phi_1602_ = (_e1032 - _e159.origin);
                                    }
                                    let _e1048 = phi_1602_;
                                    phi_1603_ = _e1048;
                                }
                                let _e1050 = phi_1603_;
                                let _e1054 = (_e1050.x - (_e417 * _e1050.z));
                                let _e1058 = (_e1050.y - (_e420 * _e1050.z));
                                let _e1060 = triangles.member[(0u + _e1025)].v1_;
                                let _e1063 = (_e1060.x - _e159.origin.x);
                                let _e1066 = (_e1060.y - _e159.origin.y);
                                let _e1069 = (_e1060.z - _e159.origin.z);
                                if (_e398 == 0u) {
                                    phi_1635_ = vec3<f32>(_e1066, _e1069, _e1063);
                                } else {
                                    if (_e398 == 1u) {
                                        phi_1634_ = vec3<f32>(_e1069, _e1063, _e1066);
                                    } else {
                                        phi_1634_ = (_e1060 - _e159.origin);
                                    }
                                    let _e1076 = phi_1634_;
                                    phi_1635_ = _e1076;
                                }
                                let _e1078 = phi_1635_;
                                let _e1082 = (_e1078.x - (_e417 * _e1078.z));
                                let _e1086 = (_e1078.y - (_e420 * _e1078.z));
                                let _e1088 = triangles.member[(0u + _e1025)].v2_;
                                let _e1091 = (_e1088.x - _e159.origin.x);
                                let _e1094 = (_e1088.y - _e159.origin.y);
                                let _e1097 = (_e1088.z - _e159.origin.z);
                                if (_e398 == 0u) {
                                    phi_1667_ = vec3<f32>(_e1094, _e1097, _e1091);
                                } else {
                                    if (_e398 == 1u) {
                                        phi_1666_ = vec3<f32>(_e1097, _e1091, _e1094);
                                    } else {
                                        phi_1666_ = (_e1088 - _e159.origin);
                                    }
                                    let _e1104 = phi_1666_;
                                    phi_1667_ = _e1104;
                                }
                                let _e1106 = phi_1667_;
                                let _e1110 = (_e1106.x - (_e417 * _e1106.z));
                                let _e1114 = (_e1106.y - (_e420 * _e1106.z));
                                if (_e1082 < _e1110) {
                                    phi_1686_ = true;
                                } else {
                                    if (_e1082 == _e1110) {
                                        phi_1685_ = (_e1086 < _e1114);
                                    } else {
                                        phi_1685_ = false;
                                    }
                                    let _e1119 = phi_1685_;
                                    phi_1686_ = _e1119;
                                }
                                let _e1121 = phi_1686_;
                                if _e1121 {
                                    phi_1690_ = _e1114;
                                    phi_1691_ = _e1110;
                                    phi_1692_ = _e1086;
                                    phi_1693_ = _e1082;
                                } else {
                                    phi_1690_ = _e1086;
                                    phi_1691_ = _e1082;
                                    phi_1692_ = _e1114;
                                    phi_1693_ = _e1110;
                                }
                                let _e1123 = phi_1690_;
                                let _e1125 = phi_1691_;
                                let _e1127 = phi_1692_;
                                let _e1129 = phi_1693_;
                                let _e1132 = ((_e1129 * _e1123) - (_e1127 * _e1125));
                                if _e1121 {
                                    phi_1701_ = -(_e1132);
                                } else {
                                    phi_1701_ = _e1132;
                                }
                                let _e1135 = phi_1701_;
                                if (_e1110 < _e1054) {
                                    phi_1712_ = true;
                                } else {
                                    if (_e1110 == _e1054) {
                                        phi_1711_ = (_e1114 < _e1058);
                                    } else {
                                        phi_1711_ = false;
                                    }
                                    let _e1140 = phi_1711_;
                                    phi_1712_ = _e1140;
                                }
                                let _e1142 = phi_1712_;
                                if _e1142 {
                                    phi_1716_ = _e1058;
                                    phi_1717_ = _e1054;
                                    phi_1718_ = _e1114;
                                    phi_1719_ = _e1110;
                                } else {
                                    phi_1716_ = _e1114;
                                    phi_1717_ = _e1110;
                                    phi_1718_ = _e1058;
                                    phi_1719_ = _e1054;
                                }
                                let _e1144 = phi_1716_;
                                let _e1146 = phi_1717_;
                                let _e1148 = phi_1718_;
                                let _e1150 = phi_1719_;
                                let _e1153 = ((_e1150 * _e1144) - (_e1148 * _e1146));
                                if _e1142 {
                                    phi_1727_ = -(_e1153);
                                } else {
                                    phi_1727_ = _e1153;
                                }
                                let _e1156 = phi_1727_;
                                if (_e1054 < _e1082) {
                                    phi_1738_ = true;
                                } else {
                                    if (_e1054 == _e1082) {
                                        phi_1737_ = (_e1058 < _e1086);
                                    } else {
                                        phi_1737_ = false;
                                    }
                                    let _e1161 = phi_1737_;
                                    phi_1738_ = _e1161;
                                }
                                let _e1163 = phi_1738_;
                                if _e1163 {
                                    phi_1742_ = _e1086;
                                    phi_1743_ = _e1082;
                                    phi_1744_ = _e1058;
                                    phi_1745_ = _e1054;
                                } else {
                                    phi_1742_ = _e1058;
                                    phi_1743_ = _e1054;
                                    phi_1744_ = _e1086;
                                    phi_1745_ = _e1082;
                                }
                                let _e1165 = phi_1742_;
                                let _e1167 = phi_1743_;
                                let _e1169 = phi_1744_;
                                let _e1171 = phi_1745_;
                                let _e1174 = ((_e1171 * _e1165) - (_e1169 * _e1167));
                                if _e1163 {
                                    phi_1753_ = -(_e1174);
                                } else {
                                    phi_1753_ = _e1174;
                                }
                                let _e1177 = phi_1753_;
                                if (_e1135 >= 0f) {
                                    if (_e1156 >= 0f) {
                                        if (_e1177 >= 0f) {
                                            phi_1768_ = ((_e1135 + _e1156) + _e1177);
                                            phi_1769_ = false;
                                        } else {
                                            phi_1768_ = f32();
                                            phi_1769_ = true;
                                        }
                                        let _e1184 = phi_1768_;
                                        let _e1186 = phi_1769_;
                                        phi_1770_ = _e1184;
                                        phi_1771_ = _e1186;
                                    } else {
                                        phi_1770_ = f32();
                                        phi_1771_ = true;
                                    }
                                    let _e1188 = phi_1770_;
                                    let _e1190 = phi_1771_;
                                    phi_1772_ = _e1188;
                                    phi_1773_ = _e1190;
                                } else {
                                    phi_1772_ = f32();
                                    phi_1773_ = true;
                                }
                                let _e1192 = phi_1772_;
                                let _e1194 = phi_1773_;
                                if _e1194 {
                                    if (_e1135 <= 0f) {
                                        if (_e1156 <= 0f) {
                                            let _e1197 = (_e1177 <= 0f);
                                            if _e1197 {
                                            }
                                            phi_1791_ = ((_e1135 + _e1156) + _e1177);
                                            phi_1792_ = false;
                                            phi_1793_ = _e1197;
                                        } else {
                                            phi_1791_ = f32();
                                            phi_1792_ = true;
                                            phi_1793_ = false;
                                        }
                                        let _e1201 = phi_1791_;
                                        let _e1203 = phi_1792_;
                                        let _e1205 = phi_1793_;
                                        phi_1794_ = _e1201;
                                        phi_1795_ = _e1203;
                                        phi_1796_ = _e1205;
                                    } else {
                                        phi_1794_ = f32();
                                        phi_1795_ = true;
                                        phi_1796_ = false;
                                    }
                                    let _e1207 = phi_1794_;
                                    let _e1209 = phi_1795_;
                                    let _e1211 = phi_1796_;
                                    if _e1209 {
                                        phi_1800_ = false;
                                    } else {
                                        phi_1800_ = _e1211;
                                    }
                                    let _e1213 = phi_1800_;
                                    phi_1801_ = _e1207;
                                    phi_1802_ = _e1213;
                                } else {
                                    phi_1801_ = _e1192;
                                    phi_1802_ = true;
                                }
                                let _e1215 = phi_1801_;
                                let _e1217 = phi_1802_;
                                if _e1217 {
                                    let _e1218 = (_e1215 == 0f);
                                    if _e1218 {
                                        phi_2128_ = lt_bvh_triangle_Intersection();
                                        phi_2129_ = false;
                                    } else {
                                        let _e1220 = triangles.member[(0u + _e1025)].v0_;
                                        let _e1223 = (_e1220.x - _e159.origin.x);
                                        let _e1226 = (_e1220.y - _e159.origin.y);
                                        let _e1229 = (_e1220.z - _e159.origin.z);
                                        if (_e398 == 0u) {
                                            phi_1833_ = vec3<f32>(_e1226, _e1229, _e1223);
                                        } else {
                                            if (_e398 == 1u) {
                                                phi_1832_ = vec3<f32>(_e1229, _e1223, _e1226);
                                            } else {
                                                phi_1832_ = (_e1220 - _e159.origin);
                                            }
                                            let _e1236 = phi_1832_;
                                            phi_1833_ = _e1236;
                                        }
                                        let _e1238 = phi_1833_;
                                        let _e1240 = triangles.member[(0u + _e1025)].v1_;
                                        let _e1242 = triangles.member[(0u + _e1025)].v0_;
                                        let _e1245 = (_e1240.x - _e1242.x);
                                        let _e1248 = (_e1240.y - _e1242.y);
                                        let _e1251 = (_e1240.z - _e1242.z);
                                        if (_e398 == 0u) {
                                            phi_1859_ = vec3<f32>(_e1248, _e1251, _e1245);
                                        } else {
                                            if (_e398 == 1u) {
                                                phi_1858_ = vec3<f32>(_e1251, _e1245, _e1248);
                                            } else {
                                                phi_1858_ = (_e1240 - _e1242);
                                            }
                                            let _e1258 = phi_1858_;
                                            phi_1859_ = _e1258;
                                        }
                                        let _e1260 = phi_1859_;
                                        let _e1262 = triangles.member[(0u + _e1025)].v2_;
                                        let _e1264 = triangles.member[(0u + _e1025)].v0_;
                                        let _e1267 = (_e1262.x - _e1264.x);
                                        let _e1270 = (_e1262.y - _e1264.y);
                                        let _e1273 = (_e1262.z - _e1264.z);
                                        if (_e398 == 0u) {
                                            phi_1885_ = vec3<f32>(_e1270, _e1273, _e1267);
                                        } else {
                                            if (_e398 == 1u) {
                                                phi_1884_ = vec3<f32>(_e1273, _e1267, _e1270);
                                            } else {
                                                phi_1884_ = (_e1262 - _e1264);
                                            }
                                            let _e1280 = phi_1884_;
                                            phi_1885_ = _e1280;
                                        }
                                        let _e1282 = phi_1885_;
                                        let _e1289 = ((_e1260.y * _e1282.z) - (_e1260.z * _e1282.y));
                                        let _e1296 = ((_e1260.z * _e1282.x) - (_e1260.x * _e1282.z));
                                        let _e1303 = ((_e1260.x * _e1282.y) - (_e1260.y * _e1282.x));
                                        let _e1317 = (((1f / _e413.z) * (((_e1289 * _e1238.x) + (_e1296 * _e1238.y)) + (_e1303 * _e1238.z))) / (((_e1289 * _e417) + (_e1296 * _e420)) + _e1303));
                                        if (_e1317 > _e159.tmin) {
                                            if (_e1317 < _e159.tmax) {
                                                let _e1323 = triangles.member[(0u + _e1025)].v0_;
                                                let _e1325 = triangles.member[(0u + _e1025)].v1_;
                                                if (_e1323.x < _e1325.x) {
                                                    phi_1943_ = _e1323.x;
                                                } else {
                                                    phi_1943_ = _e1325.x;
                                                }
                                                let _e1332 = phi_1943_;
                                                if (_e1323.y < _e1325.y) {
                                                    phi_1952_ = _e1323.y;
                                                } else {
                                                    phi_1952_ = _e1325.y;
                                                }
                                                let _e1339 = phi_1952_;
                                                if (_e1323.z < _e1325.z) {
                                                    phi_1961_ = _e1323.z;
                                                } else {
                                                    phi_1961_ = _e1325.z;
                                                }
                                                let _e1346 = phi_1961_;
                                                let _e1348 = triangles.member[(0u + _e1025)].v2_;
                                                if (_e1332 < _e1348.x) {
                                                    phi_1970_ = _e1332;
                                                } else {
                                                    phi_1970_ = _e1348.x;
                                                }
                                                let _e1353 = phi_1970_;
                                                if (_e1339 < _e1348.y) {
                                                    phi_1977_ = _e1339;
                                                } else {
                                                    phi_1977_ = _e1348.y;
                                                }
                                                let _e1358 = phi_1977_;
                                                if (_e1346 < _e1348.z) {
                                                    phi_1984_ = _e1346;
                                                } else {
                                                    phi_1984_ = _e1348.z;
                                                }
                                                let _e1363 = phi_1984_;
                                                let _e1365 = triangles.member[(0u + _e1025)].v0_;
                                                let _e1367 = triangles.member[(0u + _e1025)].v1_;
                                                if (_e1365.x > _e1367.x) {
                                                    phi_1997_ = _e1365.x;
                                                } else {
                                                    phi_1997_ = _e1367.x;
                                                }
                                                let _e1374 = phi_1997_;
                                                if (_e1365.y > _e1367.y) {
                                                    phi_2006_ = _e1365.y;
                                                } else {
                                                    phi_2006_ = _e1367.y;
                                                }
                                                let _e1381 = phi_2006_;
                                                if (_e1365.z > _e1367.z) {
                                                    phi_2015_ = _e1365.z;
                                                } else {
                                                    phi_2015_ = _e1367.z;
                                                }
                                                let _e1388 = phi_2015_;
                                                let _e1390 = triangles.member[(0u + _e1025)].v2_;
                                                if (_e1374 > _e1390.x) {
                                                    phi_2024_ = _e1374;
                                                } else {
                                                    phi_2024_ = _e1390.x;
                                                }
                                                let _e1395 = phi_2024_;
                                                if (_e1381 > _e1390.y) {
                                                    phi_2031_ = _e1381;
                                                } else {
                                                    phi_2031_ = _e1390.y;
                                                }
                                                let _e1400 = phi_2031_;
                                                if (_e1388 > _e1390.z) {
                                                    phi_2038_ = _e1388;
                                                } else {
                                                    phi_2038_ = _e1390.z;
                                                }
                                                let _e1405 = phi_2038_;
                                                let _e1412 = ((_e1353 - _e159.origin.x) * _e312);
                                                let _e1413 = ((_e1358 - _e159.origin.y) * _e323);
                                                let _e1414 = ((_e1363 - _e159.origin.z) * _e334);
                                                let _e1421 = ((_e1395 - _e159.origin.x) * _e312);
                                                let _e1422 = ((_e1400 - _e159.origin.y) * _e323);
                                                let _e1423 = ((_e1405 - _e159.origin.z) * _e334);
                                                if (_e1412 < _e1421) {
                                                    phi_2061_ = _e1412;
                                                } else {
                                                    phi_2061_ = _e1421;
                                                }
                                                let _e1426 = phi_2061_;
                                                if (_e1413 < _e1422) {
                                                    phi_2066_ = _e1413;
                                                } else {
                                                    phi_2066_ = _e1422;
                                                }
                                                let _e1429 = phi_2066_;
                                                if (_e1414 < _e1423) {
                                                    phi_2071_ = _e1414;
                                                } else {
                                                    phi_2071_ = _e1423;
                                                }
                                                let _e1432 = phi_2071_;
                                                if (_e1412 > _e1421) {
                                                    phi_2079_ = _e1412;
                                                } else {
                                                    phi_2079_ = _e1421;
                                                }
                                                let _e1438 = phi_2079_;
                                                if (_e1413 > _e1422) {
                                                    phi_2084_ = _e1413;
                                                } else {
                                                    phi_2084_ = _e1422;
                                                }
                                                let _e1441 = phi_2084_;
                                                if (_e1414 > _e1423) {
                                                    phi_2089_ = _e1414;
                                                } else {
                                                    phi_2089_ = _e1423;
                                                }
                                                let _e1444 = phi_2089_;
                                                let _e1448 = core_intrinsics_maximum_number_nsz_f32_((_e1426 - _e378), (_e1429 - _e379));
                                                let _e1449 = core_intrinsics_maximum_number_nsz_f32_(_e1448, (_e1432 - _e380));
                                                let _e1450 = core_intrinsics_minimum_number_nsz_f32_((_e1438 + _e378), (_e1441 + _e379));
                                                let _e1451 = core_intrinsics_minimum_number_nsz_f32_(_e1450, (_e1444 + _e380));
                                                if (_e1449 > -300000000000000000000000000000000000000f) {
                                                    phi_2101_ = _e1449;
                                                } else {
                                                    phi_2101_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1454 = phi_2101_;
                                                if (_e1451 < 300000000000000000000000000000000000000f) {
                                                    phi_2106_ = _e1451;
                                                } else {
                                                    phi_2106_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1457 = phi_2106_;
                                                if (_e1317 < _e1454) {
                                                    phi_2111_ = _e1454;
                                                } else {
                                                    phi_2111_ = _e1317;
                                                }
                                                let _e1460 = phi_2111_;
                                                if (_e1460 > _e1457) {
                                                    phi_2116_ = _e1457;
                                                } else {
                                                    phi_2116_ = _e1460;
                                                }
                                                let _e1463 = phi_2116_;
                                                phi_2121_ = lt_bvh_triangle_Intersection(_e1463, (_e1156 / _e1215), (_e1177 / _e1215), (_e1454 <= _e1457));
                                                phi_2122_ = false;
                                            } else {
                                                phi_2121_ = lt_bvh_triangle_Intersection();
                                                phi_2122_ = true;
                                            }
                                            let _e1469 = phi_2121_;
                                            let _e1471 = phi_2122_;
                                            phi_2123_ = _e1469;
                                            phi_2124_ = _e1471;
                                        } else {
                                            phi_2123_ = lt_bvh_triangle_Intersection();
                                            phi_2124_ = true;
                                        }
                                        let _e1473 = phi_2123_;
                                        let _e1475 = phi_2124_;
                                        if _e1475 {
                                        }
                                        phi_2128_ = _e1473;
                                        phi_2129_ = _e1475;
                                    }
                                    let _e1477 = phi_2128_;
                                    let _e1479 = phi_2129_;
                                    phi_2130_ = _e1477;
                                    phi_2131_ = _e1218;
                                    phi_2132_ = _e1479;
                                } else {
                                    phi_2130_ = lt_bvh_triangle_Intersection();
                                    phi_2131_ = true;
                                    phi_2132_ = false;
                                }
                                let _e1481 = phi_2130_;
                                let _e1483 = phi_2131_;
                                let _e1485 = phi_2132_;
                                if _e1483 {
                                    phi_2136_ = true;
                                } else {
                                    phi_2136_ = _e1485;
                                }
                                let _e1487 = phi_2136_;
                                if _e1487 {
                                    phi_2140_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_2140_ = _e1481;
                                }
                                let _e1489 = phi_2140_;
                                if _e1489.is_hit {
                                    if (_e1489.t > _e159.tmin) {
                                        if (_e1489.t < _e1014.t) {
                                            phi_2189_ = true;
                                        } else {
                                            if (_e1489.t == _e1014.t) {
                                                if (_e1014.triangle != 4294967295u) {
                                                    if (_e1025 < _e1014.triangle) {
                                                        phi_2180_ = true;
                                                    } else {
                                                        if (_e1025 == _e1014.triangle) {
                                                            phi_2179_ = (4294967295u < _e1014.instance);
                                                        } else {
                                                            phi_2179_ = false;
                                                        }
                                                        let _e1508 = phi_2179_;
                                                        phi_2180_ = _e1508;
                                                    }
                                                    let _e1510 = phi_2180_;
                                                    phi_2181_ = _e1510;
                                                    phi_2182_ = false;
                                                } else {
                                                    phi_2181_ = bool();
                                                    phi_2182_ = true;
                                                }
                                                let _e1512 = phi_2181_;
                                                let _e1514 = phi_2182_;
                                                phi_2183_ = _e1512;
                                                phi_2184_ = _e1514;
                                            } else {
                                                phi_2183_ = bool();
                                                phi_2184_ = true;
                                            }
                                            let _e1516 = phi_2183_;
                                            let _e1518 = phi_2184_;
                                            if _e1518 {
                                                phi_2188_ = false;
                                            } else {
                                                phi_2188_ = _e1516;
                                            }
                                            let _e1520 = phi_2188_;
                                            phi_2189_ = _e1520;
                                        }
                                        let _e1522 = phi_2189_;
                                        if _e1522 {
                                            let _e1524 = triangles.member[(0u + _e1025)].i0_;
                                            if ((_e1524 & 2147483648u) == 0u) {
                                                phi_2400_ = true;
                                            } else {
                                                if (_e1025 < _e80) {
                                                } else {
                                                    return;
                                                }
                                                let _e1533 = triangles.member[(0u + _e1025)].i0_;
                                                let _e1534 = (_e1533 & 2147483647u);
                                                let _e1536 = triangles.member[(0u + _e1025)].i1_;
                                                let _e1538 = triangles.member[(0u + _e1025)].i2_;
                                                if (_e1534 < _e83) {
                                                } else {
                                                    return;
                                                }
                                                let _e1542 = vertices.member[(0u + _e1534)];
                                                if (_e1536 < _e83) {
                                                } else {
                                                    return;
                                                }
                                                let _e1546 = vertices.member[(0u + _e1536)];
                                                if (_e1538 < _e83) {
                                                } else {
                                                    return;
                                                }
                                                let _e1550 = vertices.member[(0u + _e1538)];
                                                let _e1551 = array<abi_Vertex, 3>(_e1542, _e1546, _e1550);
                                                if (_e1551[0].material < _e86) {
                                                } else {
                                                    return;
                                                }
                                                let _e1557 = materials.member[(0u + _e1551[0].material)];
                                                if ((_e1557.flags & 0u) == 0u) {
                                                    let _e1562 = ((1f - _e1489.u) - _e1489.v);
                                                    if (_e1557.cutoff <= 0f) {
                                                        phi_2395_ = true;
                                                    } else {
                                                        let _e1589 = (_e1557.base_color.w * ((((f32((_e1551[0].color >> bitcast<u32>(24i))) * _e1562) + (f32((_e1551[1].color >> bitcast<u32>(24i))) * _e1489.u)) + (f32((_e1551[2].color >> bitcast<u32>(24i))) * _e1489.v)) * (1f / 255f)));
                                                        if (_e1557.alpha_size == 0u) {
                                                            phi_2392_ = _e1589;
                                                        } else {
                                                            local.offset = _e1557.alpha_offset;
                                                            local.size = _e1557.alpha_size;
                                                            local.flags = _e1557.flags;
                                                            let _e1620 = _lt_shaders_texture_TextureView_quad((&local), (((_e1551[0].u * _e1562) + (_e1551[1].u * _e1489.u)) + (_e1551[2].u * _e1489.v)), (((_e1551[0].v * _e1562) + (_e1551[1].v * _e1489.u)) + (_e1551[2].v * _e1489.v)));
                                                            let _e1624 = (_e1620.indices[0] >> bitcast<u32>(2i));
                                                            if (_e1624 < _e92) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1628 = alpha_texels.member[(0u + _e1624)];
                                                            let _e1644 = (_e1620.indices[1] >> bitcast<u32>(2i));
                                                            if (_e1644 < _e92) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1648 = alpha_texels.member[(0u + _e1644)];
                                                            let _e1665 = (_e1620.indices[2] >> bitcast<u32>(2i));
                                                            if (_e1665 < _e92) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1669 = alpha_texels.member[(0u + _e1665)];
                                                            let _e1686 = (_e1620.indices[3] >> bitcast<u32>(2i));
                                                            if (_e1686 < _e92) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1690 = alpha_texels.member[(0u + _e1686)];
                                                            phi_2392_ = (_e1589 * (((((f32(((_e1628 >> bitcast<u32>((((_e1620.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1620.weights.x) + ((f32(((_e1648 >> bitcast<u32>((((_e1620.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1620.weights.y)) + ((f32(((_e1669 >> bitcast<u32>((((_e1620.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1620.weights.z)) + ((f32(((_e1690 >> bitcast<u32>((((_e1620.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1620.weights.w)));
                                                        }
                                                        let _e1706 = phi_2392_;
                                                        phi_2395_ = (_e1706 >= _e1557.cutoff);
                                                    }
                                                    let _e1710 = phi_2395_;
                                                    phi_2396_ = _e1710;
                                                } else {
                                                    phi_2396_ = false;
                                                }
                                                let _e1712 = phi_2396_;
                                                if _e1712 {
                                                }
                                                phi_2400_ = _e1712;
                                            }
                                            let _e1714 = phi_2400_;
                                            if _e1714 {
                                                phi_2408_ = lt_bvh_Hit(_e1489.t, _e1489.u, _e1489.v, _e1025, 4294967295u);
                                            } else {
                                                phi_2408_ = _e1014;
                                            }
                                            let _e1720 = phi_2408_;
                                            phi_2409_ = _e1720;
                                        } else {
                                            phi_2409_ = _e1014;
                                        }
                                        let _e1722 = phi_2409_;
                                        phi_2410_ = _e1722;
                                    } else {
                                        phi_2410_ = _e1014;
                                    }
                                    let _e1724 = phi_2410_;
                                    phi_2411_ = _e1724;
                                } else {
                                    phi_2411_ = _e1014;
                                }
                                let _e1726 = phi_2411_;
                                phi_1554_ = _e1726;
                                phi_1557_ = (_e1016 & (_e1016 - 1u));
                                phi_2412_ = true;
                            }
                            let _e1728 = phi_1554_;
                            let _e1730 = phi_1557_;
                            let _e1732 = phi_2412_;
                            continue;
                            continuing {
                                phi_1553_ = _e1728;
                                phi_1556_ = _e1730;
                                break if !(_e1732);
                            }
                        }
                        let _e1735 = local_1.group_mask;
                        if ((_e1735 & 4278190080u) == 0u) {
                            let _e1739 = local_1.len;
                            if (_e1739 == 0u) {
                                phi_2451_ = false;
                            } else {
                                let _e1743 = local_1.len;
                                local_1.len = (_e1743 - 1u);
                                let _e1746 = local_1.len;
                                if (_e1746 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1751 = local_1.first[(0u + _e1746)];
                                local_1.group = _e1751;
                                let _e1754 = local_1.len;
                                if (_e1754 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1759 = local_1.mask[(0u + _e1754)];
                                local_1.group_mask = _e1759;
                                phi_2451_ = true;
                            }
                            let _e1762 = phi_2451_;
                            phi_2452_ = _e1762;
                        } else {
                            phi_2452_ = true;
                        }
                        let _e1764 = phi_2452_;
                        if _e1764 {
                            let _e1766 = local_1.group_mask;
                            let _e1772 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1766)), 32u, (_e1766 == 0u)));
                            let _e1776 = local_1.group_mask;
                            let _e1790 = local_1.group_mask;
                            local_1.group_mask = (_e1790 & ~((1u << bitcast<u32>((_e1772 & 31u)))));
                            let _e1793 = local_1.group;
                            phi_2483_ = (_e1793 + countOneBits(((_e1776 & ~((4294967295u << bitcast<u32>((((_e1772 - 24u) ^ _e433) & 31u))))) & 255u)));
                        } else {
                            phi_2483_ = 4294967295u;
                        }
                        let _e1796 = phi_2483_;
                        let _e2575 = local_5;
                        phi_1217_ = _e2575;
                        phi_1220_ = _e1796;
                    } else {
                        phi_1217_ = lt_bvh_Hit();
                        phi_1220_ = u32();
                    }
                    let _e1798 = phi_1217_;
                    let _e1800 = phi_1220_;
                    continue;
                    continuing {
                        phi_1216_ = _e1798;
                        phi_1219_ = _e1800;
                        break if !(_e574);
                    }
                }
                let _e2579 = local_6;
                phi_2484_ = _e2579;
            }
            let _e1803 = phi_2484_;
            phi_2485_ = _e1803;
            phi_2486_ = _e231;
        } else {
            phi_2485_ = lt_bvh_Hit();
            phi_2486_ = true;
        }
        let _e1805 = phi_2485_;
        let _e1807 = phi_2486_;
        if _e1807 {
            phi_2490_ = _e161;
        } else {
            phi_2490_ = _e1805;
        }
        let _e1809 = phi_2490_;
        if (_e1809.triangle != 4294967295u) {
            let _e1815 = ((1f - _e1809.u) - _e1809.v);
            if (_e1809.triangle < _e80) {
            } else {
                return;
            }
            let _e1821 = triangles.member[(0u + _e1809.triangle)];
            let _e1846 = (((_e1821.v0_.x * _e1815) + (_e1821.v1_.x * _e1809.u)) + (_e1821.v2_.x * _e1809.v));
            let _e1847 = (((_e1821.v0_.y * _e1815) + (_e1821.v1_.y * _e1809.u)) + (_e1821.v2_.y * _e1809.v));
            let _e1848 = (((_e1821.v0_.z * _e1815) + (_e1821.v1_.z * _e1809.u)) + (_e1821.v2_.z * _e1809.v));
            let _e1851 = abs(_e1821.v0_.x);
            let _e1853 = abs(_e1821.v0_.y);
            let _e1855 = abs(_e1821.v0_.z);
            let _e1857 = abs(_e1821.v1_.x);
            let _e1859 = abs(_e1821.v1_.y);
            let _e1861 = abs(_e1821.v1_.z);
            if (_e1851 > _e1857) {
                phi_2555_ = _e1851;
            } else {
                phi_2555_ = _e1857;
            }
            let _e1864 = phi_2555_;
            if (_e1853 > _e1859) {
                phi_2560_ = _e1853;
            } else {
                phi_2560_ = _e1859;
            }
            let _e1867 = phi_2560_;
            if (_e1855 > _e1861) {
                phi_2565_ = _e1855;
            } else {
                phi_2565_ = _e1861;
            }
            let _e1870 = phi_2565_;
            let _e1872 = abs(_e1821.v2_.x);
            let _e1874 = abs(_e1821.v2_.y);
            let _e1876 = abs(_e1821.v2_.z);
            if (_e1864 > _e1872) {
                phi_2576_ = _e1864;
            } else {
                phi_2576_ = _e1872;
            }
            let _e1879 = phi_2576_;
            if (_e1867 > _e1874) {
                phi_2581_ = _e1867;
            } else {
                phi_2581_ = _e1874;
            }
            let _e1882 = phi_2581_;
            if (_e1870 > _e1876) {
                phi_2586_ = _e1870;
            } else {
                phi_2586_ = _e1876;
            }
            let _e1885 = phi_2586_;
            let _e1888 = (_e1821.v1_.x - _e1821.v0_.x);
            let _e1891 = (_e1821.v1_.y - _e1821.v0_.y);
            let _e1894 = (_e1821.v1_.z - _e1821.v0_.z);
            let _e1897 = (_e1821.v2_.x - _e1821.v0_.x);
            let _e1900 = (_e1821.v2_.y - _e1821.v0_.y);
            let _e1903 = (_e1821.v2_.z - _e1821.v0_.z);
            let _e1907 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1891), abs(_e1894));
            let _e1908 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1888), _e1907);
            let _e1909 = (_e1888 / _e1908);
            let _e1910 = (_e1891 / _e1908);
            let _e1911 = (_e1894 / _e1908);
            let _e1915 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1900), abs(_e1903));
            let _e1916 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1897), _e1915);
            let _e1917 = (_e1897 / _e1916);
            let _e1918 = (_e1900 / _e1916);
            let _e1919 = (_e1903 / _e1916);
            let _e1922 = ((_e1910 * _e1919) - (_e1918 * _e1911));
            let _e1925 = ((_e1911 * _e1917) - (_e1919 * _e1909));
            let _e1928 = ((_e1909 * _e1918) - (_e1917 * _e1910));
            let _e1930 = p.member.eye;
            let _e1943 = (1f / sqrt((((_e1922 * _e1922) + (_e1925 * _e1925)) + (_e1928 * _e1928))));
            let _e1944 = (_e1922 * _e1943);
            let _e1945 = (_e1925 * _e1943);
            let _e1946 = (_e1928 * _e1943);
            if ((((_e1944 * (_e1930.x - _e1846)) + (_e1945 * (_e1930.y - _e1847))) + (_e1946 * (_e1930.z - _e1848))) < 0f) {
                phi_2662_ = vec3<f32>(-(_e1944), -(_e1945), -(_e1946));
            } else {
                phi_2662_ = vec3<f32>(_e1944, _e1945, _e1946);
            }
            let _e1959 = phi_2662_;
            if (_e1809.triangle < _e80) {
            } else {
                return;
            }
            let _e1964 = triangles.member[(0u + _e1809.triangle)];
            let _e1966 = (_e1964.i0_ & 2147483647u);
            if (_e1966 < _e83) {
            } else {
                return;
            }
            let _e1972 = vertices.member[(0u + _e1966)];
            if (_e1964.i1_ < _e83) {
            } else {
                return;
            }
            let _e1976 = vertices.member[(0u + _e1964.i1_)];
            if (_e1964.i2_ < _e83) {
            } else {
                return;
            }
            let _e1980 = vertices.member[(0u + _e1964.i2_)];
            let _e1981 = array<abi_Vertex, 3>(_e1972, _e1976, _e1980);
            if (_e1981[0].material < _e86) {
            } else {
                return;
            }
            let _e1987 = materials.member[(0u + _e1981[0].material)];
            let _e2004 = (1f / 255f);
            let _e2023 = (1f / 255f);
            let _e2045 = (1f / 255f);
            let _e2058 = _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(vec3<f32>(_e1815, _e1809.u, _e1809.v));
            let _e2060 = ((_e1987.base_color.x * ((((f32((_e1981[0].color & 255u)) * _e2004) * _e1815) + ((f32((_e1981[1].color & 255u)) * _e2023) * _e1809.u)) + ((f32((_e1981[2].color & 255u)) * _e2045) * _e1809.v))) * _e2058.x);
            let _e2062 = ((_e1987.base_color.y * ((((f32(((_e1981[0].color >> bitcast<u32>(8i)) & 255u)) * _e2004) * _e1815) + ((f32(((_e1981[1].color >> bitcast<u32>(8i)) & 255u)) * _e2023) * _e1809.u)) + ((f32(((_e1981[2].color >> bitcast<u32>(8i)) & 255u)) * _e2045) * _e1809.v))) * _e2058.y);
            let _e2064 = ((_e1987.base_color.z * ((((f32(((_e1981[0].color >> bitcast<u32>(16i)) & 255u)) * _e2004) * _e1815) + ((f32(((_e1981[1].color >> bitcast<u32>(16i)) & 255u)) * _e2023) * _e1809.u)) + ((f32(((_e1981[2].color >> bitcast<u32>(16i)) & 255u)) * _e2045) * _e1809.v))) * _e2058.z);
            let _e2065 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1882, _e1885);
            let _e2066 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1879, _e2065);
            if ((_e1987.flags & 2u) == 0u) {
                phi_2783_ = 0u;
            } else {
                phi_2783_ = 1u;
            }
            let _e2071 = phi_2783_;
            if (_e1981[0].normal == 2147516416u) {
                phi_2986_ = _e1959;
            } else {
                let _e2084 = (f32((bitcast<i32>((_e1981[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2090 = (f32((bitcast<i32>(_e1981[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2094 = ((1f - abs(_e2084)) - abs(_e2090));
                if (_e2094 < 0f) {
                    phi_2810_ = -(_e2094);
                } else {
                    phi_2810_ = 0f;
                }
                let _e2098 = phi_2810_;
                if (_e2084 < 0f) {
                    phi_2817_ = (_e2084 + _e2098);
                } else {
                    phi_2817_ = (_e2084 - _e2098);
                }
                let _e2103 = phi_2817_;
                if (_e2090 < 0f) {
                    phi_2824_ = (_e2090 + _e2098);
                } else {
                    phi_2824_ = (_e2090 - _e2098);
                }
                let _e2108 = phi_2824_;
                let _e2115 = (1f / sqrt((((_e2103 * _e2103) + (_e2108 * _e2108)) + (_e2094 * _e2094))));
                let _e2131 = (f32((bitcast<i32>((_e1981[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2137 = (f32((bitcast<i32>(_e1981[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2141 = ((1f - abs(_e2131)) - abs(_e2137));
                if (_e2141 < 0f) {
                    phi_2859_ = -(_e2141);
                } else {
                    phi_2859_ = 0f;
                }
                let _e2145 = phi_2859_;
                if (_e2131 < 0f) {
                    phi_2866_ = (_e2131 + _e2145);
                } else {
                    phi_2866_ = (_e2131 - _e2145);
                }
                let _e2150 = phi_2866_;
                if (_e2137 < 0f) {
                    phi_2873_ = (_e2137 + _e2145);
                } else {
                    phi_2873_ = (_e2137 - _e2145);
                }
                let _e2155 = phi_2873_;
                let _e2162 = (1f / sqrt((((_e2150 * _e2150) + (_e2155 * _e2155)) + (_e2141 * _e2141))));
                let _e2181 = (f32((bitcast<i32>((_e1981[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2187 = (f32((bitcast<i32>(_e1981[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2191 = ((1f - abs(_e2181)) - abs(_e2187));
                if (_e2191 < 0f) {
                    phi_2911_ = -(_e2191);
                } else {
                    phi_2911_ = 0f;
                }
                let _e2195 = phi_2911_;
                if (_e2181 < 0f) {
                    phi_2918_ = (_e2181 + _e2195);
                } else {
                    phi_2918_ = (_e2181 - _e2195);
                }
                let _e2200 = phi_2918_;
                if (_e2187 < 0f) {
                    phi_2925_ = (_e2187 + _e2195);
                } else {
                    phi_2925_ = (_e2187 - _e2195);
                }
                let _e2205 = phi_2925_;
                let _e2212 = (1f / sqrt((((_e2200 * _e2200) + (_e2205 * _e2205)) + (_e2191 * _e2191))));
                let _e2223 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(vec3<f32>(((((_e2103 * _e2115) * _e1815) + ((_e2150 * _e2162) * _e1809.u)) + ((_e2200 * _e2212) * _e1809.v)), ((((_e2108 * _e2115) * _e1815) + ((_e2155 * _e2162) * _e1809.u)) + ((_e2205 * _e2212) * _e1809.v)), ((((_e2094 * _e2115) * _e1815) + ((_e2141 * _e2162) * _e1809.u)) + ((_e2191 * _e2212) * _e1809.v))));
                let _e2235 = sqrt((((_e2223.x * _e2223.x) + (_e2223.y * _e2223.y)) + (_e2223.z * _e2223.z)));
                if (_e2235 > 0f) {
                    let _e2238 = (_e2223.x / _e2235);
                    let _e2240 = (_e2223.y / _e2235);
                    let _e2242 = (_e2223.z / _e2235);
                    if ((((_e2238 * _e1959.x) + (_e2240 * _e1959.y)) + (_e2242 * _e1959.z)) < 0f) {
                        phi_2984_ = vec3<f32>(-(_e2238), -(_e2240), -(_e2242));
                    } else {
                        phi_2984_ = (_e2223 / vec3(_e2235));
                    }
                    let _e2259 = phi_2984_;
                    phi_2985_ = _e2259;
                } else {
                    phi_2985_ = _e1959;
                }
                let _e2261 = phi_2985_;
                phi_2986_ = _e2261;
            }
            let _e2263 = phi_2986_;
            if (_e2060 > 0f) {
                if (_e2060 < 1f) {
                    phi_2995_ = _e2060;
                } else {
                    phi_2995_ = 1f;
                }
                let _e2267 = phi_2995_;
                phi_2996_ = _e2267;
            } else {
                phi_2996_ = 0f;
            }
            let _e2269 = phi_2996_;
            if (_e2062 > 0f) {
                if (_e2062 < 1f) {
                    phi_3006_ = _e2062;
                } else {
                    phi_3006_ = 1f;
                }
                let _e2274 = phi_3006_;
                phi_3007_ = _e2274;
            } else {
                phi_3007_ = 0f;
            }
            let _e2276 = phi_3007_;
            if (_e2064 > 0f) {
                if (_e2064 < 1f) {
                    phi_3017_ = _e2064;
                } else {
                    phi_3017_ = 1f;
                }
                let _e2281 = phi_3017_;
                phi_3018_ = _e2281;
            } else {
                phi_3018_ = 0f;
            }
            let _e2283 = phi_3018_;
            let _e2286 = ((sqrt(_e2269) * 255f) + 0.5f);
            let _e2295 = ((sqrt(_e2276) * 255f) + 0.5f);
            let _e2307 = ((sqrt(_e2283) * 255f) + 0.5f);
            phi_3053_ = abi_Sample(vec3<f32>(_e1846, _e1847, _e1848), _e2066, _e1959, _e2071, _e2263, ((select(select(u32(_e2286), 0u, (_e2286 < bitcast<f32>(0u))), 4294967295u, (_e2286 > bitcast<f32>(1333788671u))) | (select(select(u32(_e2295), 0u, (_e2295 < bitcast<f32>(0u))), 4294967295u, (_e2295 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e2307), 0u, (_e2307 < bitcast<f32>(0u))), 4294967295u, (_e2307 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_3053_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e2321 = phi_3053_;
        if (_e104.shift < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e104.shift)] = _e2321;
        if (_e1809.triangle != 4294967295u) {
            let _e2330 = ((1f - _e1809.u) - _e1809.v);
            if (_e1809.triangle < _e80) {
            } else {
                return;
            }
            let _e2335 = triangles.member[(0u + _e1809.triangle)];
            let _e2337 = (_e2335.i0_ & 2147483647u);
            if (_e2337 < _e95) {
            } else {
                return;
            }
            let _e2343 = before.member[(0u + _e2337)];
            if (_e2335.i1_ < _e95) {
            } else {
                return;
            }
            let _e2347 = before.member[(0u + _e2335.i1_)];
            if (_e2335.i2_ < _e95) {
            } else {
                return;
            }
            let _e2351 = before.member[(0u + _e2335.i2_)];
            let _e2356 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(vec3<f32>(_e2343.x, _e2343.y, _e2343.z));
            let _e2367 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(vec3<f32>(_e2347.x, _e2347.y, _e2347.z));
            let _e2381 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(vec3<f32>(_e2351.x, _e2351.y, _e2351.z));
            phi_3144_ = vec3<f32>((((_e2356.x * _e2330) + (_e2367.x * _e1809.u)) + (_e2381.x * _e1809.v)), (((_e2356.y * _e2330) + (_e2367.y * _e1809.u)) + (_e2381.y * _e1809.v)), (((_e2356.z * _e2330) + (_e2367.z * _e1809.u)) + (_e2381.z * _e1809.v)));
        } else {
            phi_3144_ = vec3<f32>(0f, 0f, 0f);
        }
        let _e2393 = phi_3144_;
        if (_e104.shift < arrayLength((&past.member))) {
        } else {
            return;
        }
        past.member[(0u + _e104.shift)] = vec4<f32>(_e2393.x, _e2393.y, _e2393.z, 1f);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_alpha_motion_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
