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
                let _e308 = phi_910_;
                if (_e159.direction.x < 0f) {
                    phi_917_ = (-1f / _e308);
                } else {
                    phi_917_ = (1f / _e308);
                }
                let _e313 = phi_917_;
                if (abs(_e159.direction.y) < _e301) {
                    phi_925_ = _e301;
                } else {
                    phi_925_ = abs(_e159.direction.y);
                }
                let _e320 = phi_925_;
                if (_e159.direction.y < 0f) {
                    phi_932_ = (-1f / _e320);
                } else {
                    phi_932_ = (1f / _e320);
                }
                let _e325 = phi_932_;
                if (abs(_e159.direction.z) < _e301) {
                    phi_940_ = _e301;
                } else {
                    phi_940_ = abs(_e159.direction.z);
                }
                let _e332 = phi_940_;
                if (_e159.direction.z < 0f) {
                    phi_947_ = (-1f / _e332);
                } else {
                    phi_947_ = (1f / _e332);
                }
                let _e337 = phi_947_;
                let _e345 = abs((bitcast<f32>(_e237) - _e159.origin.x));
                let _e346 = abs((bitcast<f32>(_e241) - _e159.origin.y));
                let _e347 = abs((bitcast<f32>(_e245) - _e159.origin.z));
                let _e355 = abs(((bitcast<f32>(_e249) + (bitcast<f32>((((_e261 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e159.origin.x));
                let _e356 = abs(((bitcast<f32>(_e253) + (bitcast<f32>((((_e261 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e159.origin.y));
                let _e357 = abs(((bitcast<f32>(_e257) + (bitcast<f32>((((_e261 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e159.origin.z));
                if (_e345 > _e355) {
                    phi_972_ = _e345;
                } else {
                    phi_972_ = _e355;
                }
                let _e360 = phi_972_;
                if (_e346 > _e356) {
                    phi_977_ = _e346;
                } else {
                    phi_977_ = _e356;
                }
                let _e363 = phi_977_;
                if (_e347 > _e357) {
                    phi_982_ = _e347;
                } else {
                    phi_982_ = _e357;
                }
                let _e366 = phi_982_;
                let _e367 = core_intrinsics_maximum_number_nsz_f32_(_e360, _e363);
                let _e368 = core_intrinsics_maximum_number_nsz_f32_(_e367, _e366);
                let _e373 = (_e368 * 0.0000019073486f);
                let _e374 = (abs(_e313) * _e373);
                let _e375 = (abs(_e325) * _e373);
                let _e376 = (abs(_e337) * _e373);
                let _e380 = (_e368 * 0.0000009536743f);
                let _e381 = (abs(_e313) * _e380);
                let _e382 = (abs(_e325) * _e380);
                let _e383 = (abs(_e337) * _e380);
                let _e386 = abs(_e159.direction.x);
                let _e388 = abs(_e159.direction.y);
                let _e390 = abs(_e159.direction.z);
                if (_e386 >= _e388) {
                    if (_e386 >= _e390) {
                        phi_1015_ = false;
                    } else {
                        phi_1015_ = true;
                    }
                    let _e394 = phi_1015_;
                    phi_1016_ = _e394;
                } else {
                    phi_1016_ = true;
                }
                let _e396 = phi_1016_;
                if _e396 {
                    if (_e388 >= _e390) {
                        phi_1024_ = 1u;
                    } else {
                        phi_1024_ = 2u;
                    }
                    let _e399 = phi_1024_;
                    phi_1025_ = _e399;
                } else {
                    phi_1025_ = 0u;
                }
                let _e401 = phi_1025_;
                if (_e401 == 0u) {
                    phi_1044_ = vec3<f32>(_e159.direction.y, _e159.direction.z, _e159.direction.x);
                } else {
                    if (_e401 == 1u) {
                        phi_1043_ = vec3<f32>(_e159.direction.z, _e159.direction.x, _e159.direction.y);
                    } else {
                        phi_1043_ = _e159.direction;
                    }
                    let _e414 = phi_1043_;
                    phi_1044_ = _e414;
                }
                let _e416 = phi_1044_;
                let _e420 = (_e416.x / _e416.z);
                let _e423 = (_e416.y / _e416.z);
                if (_e313 < 0f) {
                    phi_1058_ = 0u;
                } else {
                    phi_1058_ = 1u;
                }
                let _e428 = phi_1058_;
                if (_e325 < 0f) {
                    phi_1063_ = 0u;
                } else {
                    phi_1063_ = 2u;
                }
                let _e431 = phi_1063_;
                if (_e337 < 0f) {
                    phi_1068_ = 0u;
                } else {
                    phi_1068_ = 4u;
                }
                let _e434 = phi_1068_;
                let _e436 = ((_e428 | _e431) | _e434);
                let _e437 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e437.first[0], _e437.first[1], _e437.first[2], _e437.first[3], _e437.first[4], _e437.first[5], _e437.first[6], _e437.first[7], _e437.first[8], _e437.first[9], _e437.first[10], _e437.first[11], _e437.first[12], _e437.first[13], _e437.first[14], _e437.first[15], _e437.first[16], _e437.first[17], _e437.first[18], _e437.first[19], _e437.first[20], _e437.first[21], _e437.first[22], _e437.first[23], _e437.first[24], _e437.first[25], _e437.first[26], _e437.first[27], _e437.first[28], _e437.first[29], _e437.first[30], _e437.first[31]), array<u32, 32>(_e437.mask[0], _e437.mask[1], _e437.mask[2], _e437.mask[3], _e437.mask[4], _e437.mask[5], _e437.mask[6], _e437.mask[7], _e437.mask[8], _e437.mask[9], _e437.mask[10], _e437.mask[11], _e437.mask[12], _e437.mask[13], _e437.mask[14], _e437.mask[15], _e437.mask[16], _e437.mask[17], _e437.mask[18], _e437.mask[19], _e437.mask[20], _e437.mask[21], _e437.mask[22], _e437.mask[23], _e437.mask[24], _e437.mask[25], _e437.mask[26], _e437.mask[27], _e437.mask[28], _e437.mask[29], _e437.mask[30], _e437.mask[31]), _e437.len, _e437.group, _e437.group_mask);
                let _e511 = local_1.group_mask;
                if ((_e511 & 4278190080u) == 0u) {
                    let _e515 = local_1.len;
                    if (_e515 == 0u) {
                        phi_1182_ = false;
                    } else {
                        let _e519 = local_1.len;
                        local_1.len = (_e519 - 1u);
                        let _e522 = local_1.len;
                        if (_e522 < 32u) {
                        } else {
                            return;
                        }
                        let _e527 = local_1.first[(0u + _e522)];
                        local_1.group = _e527;
                        let _e530 = local_1.len;
                        if (_e530 < 32u) {
                        } else {
                            return;
                        }
                        let _e535 = local_1.mask[(0u + _e530)];
                        local_1.group_mask = _e535;
                        phi_1182_ = true;
                    }
                    let _e538 = phi_1182_;
                    phi_1183_ = _e538;
                } else {
                    phi_1183_ = true;
                }
                let _e540 = phi_1183_;
                if _e540 {
                    let _e542 = local_1.group_mask;
                    let _e548 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e542)), 32u, (_e542 == 0u)));
                    let _e552 = local_1.group_mask;
                    let _e566 = local_1.group_mask;
                    local_1.group_mask = (_e566 & ~((1u << bitcast<u32>((_e548 & 31u)))));
                    let _e569 = local_1.group;
                    phi_1214_ = (_e569 + countOneBits(((_e552 & ~((4294967295u << bitcast<u32>((((_e548 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1214_ = 4294967295u;
                }
                let _e572 = phi_1214_;
                phi_1216_ = _e161;
                phi_1219_ = _e572;
                loop {
                    let _e574 = phi_1216_;
                    let _e576 = phi_1219_;
                    local_6 = _e574;
                    let _e577 = (_e576 != 4294967295u);
                    if _e577 {
                        if (_e576 < _e77) {
                        } else {
                            return;
                        }
                        let _e585 = nodes.member[(0u + _e576)].frame[3u];
                        let _e610 = (bitcast<f32>((((_e585 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e313);
                        let _e611 = (bitcast<f32>((((_e585 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e325);
                        let _e612 = (bitcast<f32>((((_e585 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e337);
                        let _e615 = nodes.member[(0u + _e576)].frame[0u];
                        let _e619 = nodes.member[(0u + _e576)].frame[1u];
                        let _e623 = nodes.member[(0u + _e576)].frame[2u];
                        let _e631 = ((bitcast<f32>(_e615) - _e159.origin.x) * _e313);
                        let _e632 = ((bitcast<f32>(_e619) - _e159.origin.y) * _e325);
                        let _e633 = ((bitcast<f32>(_e623) - _e159.origin.z) * _e337);
                        let _e641 = nodes.member[(0u + _e576)].x;
                        if (_e313 < 0f) {
                            let _e652 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e641.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e658 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e652.unnamed.word, _e641.w), _e652.unnamed_1);
                            let _e664 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e658.unnamed, lt_mask_LightPlace(_e641.x, _e658.unnamed_1.shift));
                            phi_1304_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e664.unnamed, lt_mask_LightPlace(_e664.unnamed_1.word, _e641.y));
                        } else {
                            let _e680 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e641.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e686 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e680.unnamed.word, _e641.y), _e680.unnamed_1);
                            let _e692 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e686.unnamed, lt_mask_LightPlace(_e641.z, _e686.unnamed_1.shift));
                            phi_1304_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e692.unnamed, lt_mask_LightPlace(_e692.unnamed_1.word, _e641.w));
                        }
                        let _e700 = phi_1304_;
                        let _e710 = nodes.member[(0u + _e576)].y;
                        if (_e325 < 0f) {
                            let _e721 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e710.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e727 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e721.unnamed.word, _e710.w), _e721.unnamed_1);
                            let _e733 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e727.unnamed, lt_mask_LightPlace(_e710.x, _e727.unnamed_1.shift));
                            phi_1331_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e733.unnamed, lt_mask_LightPlace(_e733.unnamed_1.word, _e710.y));
                        } else {
                            let _e749 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e710.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e755 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e749.unnamed.word, _e710.y), _e749.unnamed_1);
                            let _e761 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e755.unnamed, lt_mask_LightPlace(_e710.z, _e755.unnamed_1.shift));
                            phi_1331_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e761.unnamed, lt_mask_LightPlace(_e761.unnamed_1.word, _e710.w));
                        }
                        let _e769 = phi_1331_;
                        let _e779 = nodes.member[(0u + _e576)].z;
                        if (_e337 < 0f) {
                            let _e790 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e779.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e796 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e790.unnamed.word, _e779.w), _e790.unnamed_1);
                            let _e802 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e796.unnamed, lt_mask_LightPlace(_e779.x, _e796.unnamed_1.shift));
                            phi_1358_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e802.unnamed, lt_mask_LightPlace(_e802.unnamed_1.word, _e779.y));
                        } else {
                            let _e818 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e779.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e824 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e818.unnamed.word, _e779.y), _e818.unnamed_1);
                            let _e830 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e824.unnamed, lt_mask_LightPlace(_e779.z, _e824.unnamed_1.shift));
                            phi_1358_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e830.unnamed, lt_mask_LightPlace(_e830.unnamed_1.word, _e779.w));
                        }
                        let _e838 = phi_1358_;
                        phi_1364_ = 0u;
                        phi_1367_ = 0u;
                        loop {
                            let _e848 = phi_1364_;
                            let _e850 = phi_1367_;
                            local_2 = _e850;
                            local_3 = _e850;
                            local_4 = _e850;
                            let _e851 = (_e848 < 8u);
                            if _e851 {
                                let _e853 = (_e848 >> bitcast<u32>(2i));
                                let _e854 = (_e848 & 3u);
                                if (_e853 == 0u) {
                                    phi_1381_ = _e700.unnamed.word;
                                } else {
                                    phi_1381_ = _e700.unnamed.shift;
                                }
                                let _e857 = phi_1381_;
                                if (_e853 == 0u) {
                                    phi_1391_ = _e769.unnamed.word;
                                } else {
                                    phi_1391_ = _e769.unnamed.shift;
                                }
                                let _e866 = phi_1391_;
                                if (_e853 == 0u) {
                                    phi_1401_ = _e838.unnamed.word;
                                } else {
                                    phi_1401_ = _e838.unnamed.shift;
                                }
                                let _e875 = phi_1401_;
                                let _e888 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e857 >> bitcast<u32>(((_e854 * 8u) & 31u))) & 255u)) * _e610) + (_e631 - _e374)), ((f32(((_e866 >> bitcast<u32>(((_e854 * 8u) & 31u))) & 255u)) * _e611) + (_e632 - _e375)));
                                let _e889 = core_intrinsics_maximum_number_nsz_f32_(_e888, ((f32(((_e875 >> bitcast<u32>(((_e854 * 8u) & 31u))) & 255u)) * _e612) + (_e633 - _e376)));
                                if (_e853 == 0u) {
                                    phi_1419_ = _e700.unnamed_1.word;
                                } else {
                                    phi_1419_ = _e700.unnamed_1.shift;
                                }
                                let _e892 = phi_1419_;
                                if (_e853 == 0u) {
                                    phi_1429_ = _e769.unnamed_1.word;
                                } else {
                                    phi_1429_ = _e769.unnamed_1.shift;
                                }
                                let _e901 = phi_1429_;
                                if (_e853 == 0u) {
                                    phi_1439_ = _e838.unnamed_1.word;
                                } else {
                                    phi_1439_ = _e838.unnamed_1.shift;
                                }
                                let _e910 = phi_1439_;
                                let _e923 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e892 >> bitcast<u32>(((_e854 * 8u) & 31u))) & 255u)) * _e610) + (_e631 + _e374)), ((f32(((_e901 >> bitcast<u32>(((_e854 * 8u) & 31u))) & 255u)) * _e611) + (_e632 + _e375)));
                                let _e924 = core_intrinsics_minimum_number_nsz_f32_(_e923, ((f32(((_e910 >> bitcast<u32>(((_e854 * 8u) & 31u))) & 255u)) * _e612) + (_e633 + _e376)));
                                if (_e889 <= _e924) {
                                    if (_e889 <= _e574.t) {
                                        if (_e924 >= _e159.tmin) {
                                            if (_e853 == 0u) {
                                                let _e931 = nodes.member[(0u + _e576)].links[2u];
                                                phi_1475_ = _e931;
                                            } else {
                                                let _e934 = nodes.member[(0u + _e576)].links[3u];
                                                phi_1475_ = _e934;
                                            }
                                            let _e936 = phi_1475_;
                                            let _e941 = ((_e936 >> bitcast<u32>(((_e854 * 8u) & 31u))) & 255u);
                                            let _e942 = (_e941 & 31u);
                                            if (_e942 >= 24u) {
                                                phi_1488_ = (24u + ((_e942 - 24u) ^ _e436));
                                            } else {
                                                phi_1488_ = _e942;
                                            }
                                            let _e948 = phi_1488_;
                                            phi_1493_ = (_e850 | ((_e941 >> bitcast<u32>(5i)) << bitcast<u32>((_e948 & 31u))));
                                        } else {
                                            phi_1493_ = _e850;
                                        }
                                        let _e956 = phi_1493_;
                                        phi_1494_ = _e956;
                                    } else {
                                        phi_1494_ = _e850;
                                    }
                                    let _e958 = phi_1494_;
                                    phi_1495_ = _e958;
                                } else {
                                    phi_1495_ = _e850;
                                }
                                let _e960 = phi_1495_;
                                phi_1365_ = (_e848 + 1u);
                                phi_1368_ = _e960;
                            } else {
                                phi_1365_ = u32();
                                phi_1368_ = u32();
                            }
                            let _e963 = phi_1365_;
                            let _e965 = phi_1368_;
                            continue;
                            continuing {
                                phi_1364_ = _e963;
                                phi_1367_ = _e965;
                                break if !(_e851);
                            }
                        }
                        let _e969 = nodes.member[(0u + _e576)].links[0u];
                        let _e973 = nodes.member[(0u + _e576)].frame[3u];
                        let _e977 = local_2;
                        if ((_e977 & 4278190080u) == 0u) {
                        } else {
                            let _e981 = local_1.group_mask;
                            if ((_e981 & 4278190080u) == 0u) {
                            } else {
                                let _e985 = local_1.len;
                                if (_e985 < 32u) {
                                    let _e988 = local_1.group;
                                    let _e990 = local_1.len;
                                    if (_e990 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.first[(0u + _e990)] = _e988;
                                    let _e996 = local_1.group_mask;
                                    let _e998 = local_1.len;
                                    if (_e998 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.mask[(0u + _e998)] = _e996;
                                    let _e1005 = local_1.len;
                                    local_1.len = (_e1005 + 1u);
                                }
                            }
                            local_1.group = (0u + _e969);
                            let _e1009 = local_3;
                            local_1.group_mask = ((_e1009 & 4278190080u) | (_e973 >> bitcast<u32>(24i)));
                        }
                        let _e1014 = local_4;
                        phi_1553_ = _e574;
                        phi_1556_ = (_e1014 & 16777215u);
                        loop {
                            let _e1017 = phi_1553_;
                            let _e1019 = phi_1556_;
                            local_5 = _e1017;
                            if (_e1019 == 0u) {
                                phi_1554_ = lt_bvh_Hit();
                                phi_1557_ = u32();
                                phi_2412_ = false;
                            } else {
                                let _e1023 = nodes.member[(0u + _e576)].links[1u];
                                let _e1028 = ((0u + _e1023) + select(firstTrailingBit(_e1019), 32u, (_e1019 == 0u)));
                                if (_e1028 < _e80) {
                                } else {
                                    return;
                                }
                                let _e1035 = triangles.member[(0u + _e1028)].v0_;
                                let _e1038 = (_e1035.x - _e159.origin.x);
                                let _e1041 = (_e1035.y - _e159.origin.y);
                                let _e1044 = (_e1035.z - _e159.origin.z);
                                if (_e401 == 0u) {
                                    phi_1603_ = vec3<f32>(_e1041, _e1044, _e1038);
                                } else {
                                    if (_e401 == 1u) {
                                        phi_1602_ = vec3<f32>(_e1044, _e1038, _e1041);
                                    } else {
                                        phi_1602_ = (_e1035 - _e159.origin);
                                    }
                                    let _e1051 = phi_1602_;
                                    phi_1603_ = _e1051;
                                }
                                let _e1053 = phi_1603_;
                                let _e1057 = (_e1053.x - (_e420 * _e1053.z));
                                let _e1061 = (_e1053.y - (_e423 * _e1053.z));
                                let _e1063 = triangles.member[(0u + _e1028)].v1_;
                                let _e1066 = (_e1063.x - _e159.origin.x);
                                let _e1069 = (_e1063.y - _e159.origin.y);
                                let _e1072 = (_e1063.z - _e159.origin.z);
                                if (_e401 == 0u) {
                                    phi_1635_ = vec3<f32>(_e1069, _e1072, _e1066);
                                } else {
                                    if (_e401 == 1u) {
                                        phi_1634_ = vec3<f32>(_e1072, _e1066, _e1069);
                                    } else {
                                        phi_1634_ = (_e1063 - _e159.origin);
                                    }
                                    let _e1079 = phi_1634_;
                                    phi_1635_ = _e1079;
                                }
                                let _e1081 = phi_1635_;
                                let _e1085 = (_e1081.x - (_e420 * _e1081.z));
                                let _e1089 = (_e1081.y - (_e423 * _e1081.z));
                                let _e1091 = triangles.member[(0u + _e1028)].v2_;
                                let _e1094 = (_e1091.x - _e159.origin.x);
                                let _e1097 = (_e1091.y - _e159.origin.y);
                                let _e1100 = (_e1091.z - _e159.origin.z);
                                if (_e401 == 0u) {
                                    phi_1667_ = vec3<f32>(_e1097, _e1100, _e1094);
                                } else {
                                    if (_e401 == 1u) {
                                        phi_1666_ = vec3<f32>(_e1100, _e1094, _e1097);
                                    } else {
                                        phi_1666_ = (_e1091 - _e159.origin);
                                    }
                                    let _e1107 = phi_1666_;
                                    phi_1667_ = _e1107;
                                }
                                let _e1109 = phi_1667_;
                                let _e1113 = (_e1109.x - (_e420 * _e1109.z));
                                let _e1117 = (_e1109.y - (_e423 * _e1109.z));
                                if (_e1085 < _e1113) {
                                    phi_1686_ = true;
                                } else {
                                    if (_e1085 == _e1113) {
                                        phi_1685_ = (_e1089 < _e1117);
                                    } else {
                                        phi_1685_ = false;
                                    }
                                    let _e1122 = phi_1685_;
                                    phi_1686_ = _e1122;
                                }
                                let _e1124 = phi_1686_;
                                if _e1124 {
                                    phi_1690_ = _e1117;
                                    phi_1691_ = _e1113;
                                    phi_1692_ = _e1089;
                                    phi_1693_ = _e1085;
                                } else {
                                    phi_1690_ = _e1089;
                                    phi_1691_ = _e1085;
                                    phi_1692_ = _e1117;
                                    phi_1693_ = _e1113;
                                }
                                let _e1126 = phi_1690_;
                                let _e1128 = phi_1691_;
                                let _e1130 = phi_1692_;
                                let _e1132 = phi_1693_;
                                let _e1135 = ((_e1132 * _e1126) - (_e1130 * _e1128));
                                if _e1124 {
                                    phi_1701_ = -(_e1135);
                                } else {
                                    phi_1701_ = _e1135;
                                }
                                let _e1138 = phi_1701_;
                                if (_e1113 < _e1057) {
                                    phi_1712_ = true;
                                } else {
                                    if (_e1113 == _e1057) {
                                        phi_1711_ = (_e1117 < _e1061);
                                    } else {
                                        phi_1711_ = false;
                                    }
                                    let _e1143 = phi_1711_;
                                    phi_1712_ = _e1143;
                                }
                                let _e1145 = phi_1712_;
                                if _e1145 {
                                    phi_1716_ = _e1061;
                                    phi_1717_ = _e1057;
                                    phi_1718_ = _e1117;
                                    phi_1719_ = _e1113;
                                } else {
                                    phi_1716_ = _e1117;
                                    phi_1717_ = _e1113;
                                    phi_1718_ = _e1061;
                                    phi_1719_ = _e1057;
                                }
                                let _e1147 = phi_1716_;
                                let _e1149 = phi_1717_;
                                let _e1151 = phi_1718_;
                                let _e1153 = phi_1719_;
                                let _e1156 = ((_e1153 * _e1147) - (_e1151 * _e1149));
                                if _e1145 {
                                    phi_1727_ = -(_e1156);
                                } else {
                                    phi_1727_ = _e1156;
                                }
                                let _e1159 = phi_1727_;
                                if (_e1057 < _e1085) {
                                    phi_1738_ = true;
                                } else {
                                    if (_e1057 == _e1085) {
                                        phi_1737_ = (_e1061 < _e1089);
                                    } else {
                                        phi_1737_ = false;
                                    }
                                    let _e1164 = phi_1737_;
                                    phi_1738_ = _e1164;
                                }
                                let _e1166 = phi_1738_;
                                if _e1166 {
                                    phi_1742_ = _e1089;
                                    phi_1743_ = _e1085;
                                    phi_1744_ = _e1061;
                                    phi_1745_ = _e1057;
                                } else {
                                    phi_1742_ = _e1061;
                                    phi_1743_ = _e1057;
                                    phi_1744_ = _e1089;
                                    phi_1745_ = _e1085;
                                }
                                let _e1168 = phi_1742_;
                                let _e1170 = phi_1743_;
                                let _e1172 = phi_1744_;
                                let _e1174 = phi_1745_;
                                let _e1177 = ((_e1174 * _e1168) - (_e1172 * _e1170));
                                if _e1166 {
                                    phi_1753_ = -(_e1177);
                                } else {
                                    phi_1753_ = _e1177;
                                }
                                let _e1180 = phi_1753_;
                                if (_e1138 >= 0f) {
                                    if (_e1159 >= 0f) {
                                        if (_e1180 >= 0f) {
                                            phi_1768_ = ((_e1138 + _e1159) + _e1180);
                                            phi_1769_ = false;
                                        } else {
                                            phi_1768_ = f32();
                                            phi_1769_ = true;
                                        }
                                        let _e1187 = phi_1768_;
                                        let _e1189 = phi_1769_;
                                        phi_1770_ = _e1187;
                                        phi_1771_ = _e1189;
                                    } else {
                                        phi_1770_ = f32();
                                        phi_1771_ = true;
                                    }
                                    let _e1191 = phi_1770_;
                                    let _e1193 = phi_1771_;
                                    phi_1772_ = _e1191;
                                    phi_1773_ = _e1193;
                                } else {
                                    phi_1772_ = f32();
                                    phi_1773_ = true;
                                }
                                let _e1195 = phi_1772_;
                                let _e1197 = phi_1773_;
                                if _e1197 {
                                    if (_e1138 <= 0f) {
                                        if (_e1159 <= 0f) {
                                            let _e1200 = (_e1180 <= 0f);
                                            if _e1200 {
                                            }
                                            phi_1791_ = ((_e1138 + _e1159) + _e1180);
                                            phi_1792_ = false;
                                            phi_1793_ = _e1200;
                                        } else {
                                            phi_1791_ = f32();
                                            phi_1792_ = true;
                                            phi_1793_ = false;
                                        }
                                        let _e1204 = phi_1791_;
                                        let _e1206 = phi_1792_;
                                        let _e1208 = phi_1793_;
                                        phi_1794_ = _e1204;
                                        phi_1795_ = _e1206;
                                        phi_1796_ = _e1208;
                                    } else {
                                        phi_1794_ = f32();
                                        phi_1795_ = true;
                                        phi_1796_ = false;
                                    }
                                    let _e1210 = phi_1794_;
                                    let _e1212 = phi_1795_;
                                    let _e1214 = phi_1796_;
                                    if _e1212 {
                                        phi_1800_ = false;
                                    } else {
                                        phi_1800_ = _e1214;
                                    }
                                    let _e1216 = phi_1800_;
                                    phi_1801_ = _e1210;
                                    phi_1802_ = _e1216;
                                } else {
                                    phi_1801_ = _e1195;
                                    phi_1802_ = true;
                                }
                                let _e1218 = phi_1801_;
                                let _e1220 = phi_1802_;
                                if _e1220 {
                                    let _e1221 = (_e1218 == 0f);
                                    if _e1221 {
                                        phi_2128_ = lt_bvh_triangle_Intersection();
                                        phi_2129_ = false;
                                    } else {
                                        let _e1223 = triangles.member[(0u + _e1028)].v0_;
                                        let _e1226 = (_e1223.x - _e159.origin.x);
                                        let _e1229 = (_e1223.y - _e159.origin.y);
                                        let _e1232 = (_e1223.z - _e159.origin.z);
                                        if (_e401 == 0u) {
                                            phi_1833_ = vec3<f32>(_e1229, _e1232, _e1226);
                                        } else {
                                            if (_e401 == 1u) {
                                                phi_1832_ = vec3<f32>(_e1232, _e1226, _e1229);
                                            } else {
                                                phi_1832_ = (_e1223 - _e159.origin);
                                            }
                                            let _e1239 = phi_1832_;
                                            phi_1833_ = _e1239;
                                        }
                                        let _e1241 = phi_1833_;
                                        let _e1243 = triangles.member[(0u + _e1028)].v1_;
                                        let _e1245 = triangles.member[(0u + _e1028)].v0_;
                                        let _e1248 = (_e1243.x - _e1245.x);
                                        let _e1251 = (_e1243.y - _e1245.y);
                                        let _e1254 = (_e1243.z - _e1245.z);
                                        if (_e401 == 0u) {
                                            phi_1859_ = vec3<f32>(_e1251, _e1254, _e1248);
                                        } else {
                                            if (_e401 == 1u) {
                                                phi_1858_ = vec3<f32>(_e1254, _e1248, _e1251);
                                            } else {
                                                phi_1858_ = (_e1243 - _e1245);
                                            }
                                            let _e1261 = phi_1858_;
                                            phi_1859_ = _e1261;
                                        }
                                        let _e1263 = phi_1859_;
                                        let _e1265 = triangles.member[(0u + _e1028)].v2_;
                                        let _e1267 = triangles.member[(0u + _e1028)].v0_;
                                        let _e1270 = (_e1265.x - _e1267.x);
                                        let _e1273 = (_e1265.y - _e1267.y);
                                        let _e1276 = (_e1265.z - _e1267.z);
                                        if (_e401 == 0u) {
                                            phi_1885_ = vec3<f32>(_e1273, _e1276, _e1270);
                                        } else {
                                            if (_e401 == 1u) {
                                                phi_1884_ = vec3<f32>(_e1276, _e1270, _e1273);
                                            } else {
                                                phi_1884_ = (_e1265 - _e1267);
                                            }
                                            let _e1283 = phi_1884_;
                                            phi_1885_ = _e1283;
                                        }
                                        let _e1285 = phi_1885_;
                                        let _e1292 = ((_e1263.y * _e1285.z) - (_e1263.z * _e1285.y));
                                        let _e1299 = ((_e1263.z * _e1285.x) - (_e1263.x * _e1285.z));
                                        let _e1306 = ((_e1263.x * _e1285.y) - (_e1263.y * _e1285.x));
                                        let _e1320 = (((1f / _e416.z) * (((_e1292 * _e1241.x) + (_e1299 * _e1241.y)) + (_e1306 * _e1241.z))) / (((_e1292 * _e420) + (_e1299 * _e423)) + _e1306));
                                        if (_e1320 > _e159.tmin) {
                                            if (_e1320 < _e159.tmax) {
                                                let _e1326 = triangles.member[(0u + _e1028)].v0_;
                                                let _e1328 = triangles.member[(0u + _e1028)].v1_;
                                                if (_e1326.x < _e1328.x) {
                                                    phi_1943_ = _e1326.x;
                                                } else {
                                                    phi_1943_ = _e1328.x;
                                                }
                                                let _e1335 = phi_1943_;
                                                if (_e1326.y < _e1328.y) {
                                                    phi_1952_ = _e1326.y;
                                                } else {
                                                    phi_1952_ = _e1328.y;
                                                }
                                                let _e1342 = phi_1952_;
                                                if (_e1326.z < _e1328.z) {
                                                    phi_1961_ = _e1326.z;
                                                } else {
                                                    phi_1961_ = _e1328.z;
                                                }
                                                let _e1349 = phi_1961_;
                                                let _e1351 = triangles.member[(0u + _e1028)].v2_;
                                                if (_e1335 < _e1351.x) {
                                                    phi_1970_ = _e1335;
                                                } else {
                                                    phi_1970_ = _e1351.x;
                                                }
                                                let _e1356 = phi_1970_;
                                                if (_e1342 < _e1351.y) {
                                                    phi_1977_ = _e1342;
                                                } else {
                                                    phi_1977_ = _e1351.y;
                                                }
                                                let _e1361 = phi_1977_;
                                                if (_e1349 < _e1351.z) {
                                                    phi_1984_ = _e1349;
                                                } else {
                                                    phi_1984_ = _e1351.z;
                                                }
                                                let _e1366 = phi_1984_;
                                                let _e1368 = triangles.member[(0u + _e1028)].v0_;
                                                let _e1370 = triangles.member[(0u + _e1028)].v1_;
                                                if (_e1368.x > _e1370.x) {
                                                    phi_1997_ = _e1368.x;
                                                } else {
                                                    phi_1997_ = _e1370.x;
                                                }
                                                let _e1377 = phi_1997_;
                                                if (_e1368.y > _e1370.y) {
                                                    phi_2006_ = _e1368.y;
                                                } else {
                                                    phi_2006_ = _e1370.y;
                                                }
                                                let _e1384 = phi_2006_;
                                                if (_e1368.z > _e1370.z) {
                                                    phi_2015_ = _e1368.z;
                                                } else {
                                                    phi_2015_ = _e1370.z;
                                                }
                                                let _e1391 = phi_2015_;
                                                let _e1393 = triangles.member[(0u + _e1028)].v2_;
                                                if (_e1377 > _e1393.x) {
                                                    phi_2024_ = _e1377;
                                                } else {
                                                    phi_2024_ = _e1393.x;
                                                }
                                                let _e1398 = phi_2024_;
                                                if (_e1384 > _e1393.y) {
                                                    phi_2031_ = _e1384;
                                                } else {
                                                    phi_2031_ = _e1393.y;
                                                }
                                                let _e1403 = phi_2031_;
                                                if (_e1391 > _e1393.z) {
                                                    phi_2038_ = _e1391;
                                                } else {
                                                    phi_2038_ = _e1393.z;
                                                }
                                                let _e1408 = phi_2038_;
                                                let _e1415 = ((_e1356 - _e159.origin.x) * _e313);
                                                let _e1416 = ((_e1361 - _e159.origin.y) * _e325);
                                                let _e1417 = ((_e1366 - _e159.origin.z) * _e337);
                                                let _e1424 = ((_e1398 - _e159.origin.x) * _e313);
                                                let _e1425 = ((_e1403 - _e159.origin.y) * _e325);
                                                let _e1426 = ((_e1408 - _e159.origin.z) * _e337);
                                                if (_e1415 < _e1424) {
                                                    phi_2061_ = _e1415;
                                                } else {
                                                    phi_2061_ = _e1424;
                                                }
                                                let _e1429 = phi_2061_;
                                                if (_e1416 < _e1425) {
                                                    phi_2066_ = _e1416;
                                                } else {
                                                    phi_2066_ = _e1425;
                                                }
                                                let _e1432 = phi_2066_;
                                                if (_e1417 < _e1426) {
                                                    phi_2071_ = _e1417;
                                                } else {
                                                    phi_2071_ = _e1426;
                                                }
                                                let _e1435 = phi_2071_;
                                                if (_e1415 > _e1424) {
                                                    phi_2079_ = _e1415;
                                                } else {
                                                    phi_2079_ = _e1424;
                                                }
                                                let _e1441 = phi_2079_;
                                                if (_e1416 > _e1425) {
                                                    phi_2084_ = _e1416;
                                                } else {
                                                    phi_2084_ = _e1425;
                                                }
                                                let _e1444 = phi_2084_;
                                                if (_e1417 > _e1426) {
                                                    phi_2089_ = _e1417;
                                                } else {
                                                    phi_2089_ = _e1426;
                                                }
                                                let _e1447 = phi_2089_;
                                                let _e1451 = core_intrinsics_maximum_number_nsz_f32_((_e1429 - _e381), (_e1432 - _e382));
                                                let _e1452 = core_intrinsics_maximum_number_nsz_f32_(_e1451, (_e1435 - _e383));
                                                let _e1453 = core_intrinsics_minimum_number_nsz_f32_((_e1441 + _e381), (_e1444 + _e382));
                                                let _e1454 = core_intrinsics_minimum_number_nsz_f32_(_e1453, (_e1447 + _e383));
                                                if (_e1452 > -300000000000000000000000000000000000000f) {
                                                    phi_2101_ = _e1452;
                                                } else {
                                                    phi_2101_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1457 = phi_2101_;
                                                if (_e1454 < 300000000000000000000000000000000000000f) {
                                                    phi_2106_ = _e1454;
                                                } else {
                                                    phi_2106_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1460 = phi_2106_;
                                                if (_e1320 < _e1457) {
                                                    phi_2111_ = _e1457;
                                                } else {
                                                    phi_2111_ = _e1320;
                                                }
                                                let _e1463 = phi_2111_;
                                                if (_e1463 > _e1460) {
                                                    phi_2116_ = _e1460;
                                                } else {
                                                    phi_2116_ = _e1463;
                                                }
                                                let _e1466 = phi_2116_;
                                                phi_2121_ = lt_bvh_triangle_Intersection(_e1466, (_e1159 / _e1218), (_e1180 / _e1218), (_e1457 <= _e1460));
                                                phi_2122_ = false;
                                            } else {
                                                phi_2121_ = lt_bvh_triangle_Intersection();
                                                phi_2122_ = true;
                                            }
                                            let _e1472 = phi_2121_;
                                            let _e1474 = phi_2122_;
                                            phi_2123_ = _e1472;
                                            phi_2124_ = _e1474;
                                        } else {
                                            phi_2123_ = lt_bvh_triangle_Intersection();
                                            phi_2124_ = true;
                                        }
                                        let _e1476 = phi_2123_;
                                        let _e1478 = phi_2124_;
                                        if _e1478 {
                                        }
                                        phi_2128_ = _e1476;
                                        phi_2129_ = _e1478;
                                    }
                                    let _e1480 = phi_2128_;
                                    let _e1482 = phi_2129_;
                                    phi_2130_ = _e1480;
                                    phi_2131_ = _e1221;
                                    phi_2132_ = _e1482;
                                } else {
                                    phi_2130_ = lt_bvh_triangle_Intersection();
                                    phi_2131_ = true;
                                    phi_2132_ = false;
                                }
                                let _e1484 = phi_2130_;
                                let _e1486 = phi_2131_;
                                let _e1488 = phi_2132_;
                                if _e1486 {
                                    phi_2136_ = true;
                                } else {
                                    phi_2136_ = _e1488;
                                }
                                let _e1490 = phi_2136_;
                                if _e1490 {
                                    phi_2140_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_2140_ = _e1484;
                                }
                                let _e1492 = phi_2140_;
                                if _e1492.is_hit {
                                    if (_e1492.t > _e159.tmin) {
                                        if (_e1492.t < _e1017.t) {
                                            phi_2189_ = true;
                                        } else {
                                            if (_e1492.t == _e1017.t) {
                                                if (_e1017.triangle != 4294967295u) {
                                                    if (_e1028 < _e1017.triangle) {
                                                        phi_2180_ = true;
                                                    } else {
                                                        if (_e1028 == _e1017.triangle) {
                                                            phi_2179_ = (4294967295u < _e1017.instance);
                                                        } else {
                                                            phi_2179_ = false;
                                                        }
                                                        let _e1511 = phi_2179_;
                                                        phi_2180_ = _e1511;
                                                    }
                                                    let _e1513 = phi_2180_;
                                                    phi_2181_ = _e1513;
                                                    phi_2182_ = false;
                                                } else {
                                                    phi_2181_ = bool();
                                                    phi_2182_ = true;
                                                }
                                                let _e1515 = phi_2181_;
                                                let _e1517 = phi_2182_;
                                                phi_2183_ = _e1515;
                                                phi_2184_ = _e1517;
                                            } else {
                                                phi_2183_ = bool();
                                                phi_2184_ = true;
                                            }
                                            let _e1519 = phi_2183_;
                                            let _e1521 = phi_2184_;
                                            if _e1521 {
                                                phi_2188_ = false;
                                            } else {
                                                phi_2188_ = _e1519;
                                            }
                                            let _e1523 = phi_2188_;
                                            phi_2189_ = _e1523;
                                        }
                                        let _e1525 = phi_2189_;
                                        if _e1525 {
                                            let _e1527 = triangles.member[(0u + _e1028)].i0_;
                                            if ((_e1527 & 2147483648u) == 0u) {
                                                phi_2400_ = true;
                                            } else {
                                                if (_e1028 < _e80) {
                                                } else {
                                                    return;
                                                }
                                                let _e1536 = triangles.member[(0u + _e1028)].i0_;
                                                let _e1537 = (_e1536 & 2147483647u);
                                                let _e1539 = triangles.member[(0u + _e1028)].i1_;
                                                let _e1541 = triangles.member[(0u + _e1028)].i2_;
                                                if (_e1537 < _e83) {
                                                } else {
                                                    return;
                                                }
                                                let _e1545 = vertices.member[(0u + _e1537)];
                                                if (_e1539 < _e83) {
                                                } else {
                                                    return;
                                                }
                                                let _e1549 = vertices.member[(0u + _e1539)];
                                                if (_e1541 < _e83) {
                                                } else {
                                                    return;
                                                }
                                                let _e1553 = vertices.member[(0u + _e1541)];
                                                let _e1554 = array<abi_Vertex, 3>(_e1545, _e1549, _e1553);
                                                if (_e1554[0].material < _e86) {
                                                } else {
                                                    return;
                                                }
                                                let _e1560 = materials.member[(0u + _e1554[0].material)];
                                                if ((_e1560.flags & 0u) == 0u) {
                                                    let _e1565 = ((1f - _e1492.u) - _e1492.v);
                                                    if (_e1560.cutoff <= 0f) {
                                                        phi_2395_ = true;
                                                    } else {
                                                        let _e1592 = (_e1560.base_color.w * ((((f32((_e1554[0].color >> bitcast<u32>(24i))) * _e1565) + (f32((_e1554[1].color >> bitcast<u32>(24i))) * _e1492.u)) + (f32((_e1554[2].color >> bitcast<u32>(24i))) * _e1492.v)) * (1f / 255f)));
                                                        if (_e1560.alpha_size == 0u) {
                                                            phi_2392_ = _e1592;
                                                        } else {
                                                            local.offset = _e1560.alpha_offset;
                                                            local.size = _e1560.alpha_size;
                                                            local.flags = _e1560.flags;
                                                            let _e1623 = _lt_shaders_texture_TextureView_quad((&local), (((_e1554[0].u * _e1565) + (_e1554[1].u * _e1492.u)) + (_e1554[2].u * _e1492.v)), (((_e1554[0].v * _e1565) + (_e1554[1].v * _e1492.u)) + (_e1554[2].v * _e1492.v)));
                                                            let _e1627 = (_e1623.indices[0] >> bitcast<u32>(2i));
                                                            if (_e1627 < _e92) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1631 = alpha_texels.member[(0u + _e1627)];
                                                            let _e1647 = (_e1623.indices[1] >> bitcast<u32>(2i));
                                                            if (_e1647 < _e92) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1651 = alpha_texels.member[(0u + _e1647)];
                                                            let _e1668 = (_e1623.indices[2] >> bitcast<u32>(2i));
                                                            if (_e1668 < _e92) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1672 = alpha_texels.member[(0u + _e1668)];
                                                            let _e1689 = (_e1623.indices[3] >> bitcast<u32>(2i));
                                                            if (_e1689 < _e92) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1693 = alpha_texels.member[(0u + _e1689)];
                                                            phi_2392_ = (_e1592 * (((((f32(((_e1631 >> bitcast<u32>((((_e1623.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1623.weights.x) + ((f32(((_e1651 >> bitcast<u32>((((_e1623.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1623.weights.y)) + ((f32(((_e1672 >> bitcast<u32>((((_e1623.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1623.weights.z)) + ((f32(((_e1693 >> bitcast<u32>((((_e1623.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1623.weights.w)));
                                                        }
                                                        let _e1709 = phi_2392_;
                                                        phi_2395_ = (_e1709 >= _e1560.cutoff);
                                                    }
                                                    let _e1713 = phi_2395_;
                                                    phi_2396_ = _e1713;
                                                } else {
                                                    phi_2396_ = false;
                                                }
                                                let _e1715 = phi_2396_;
                                                if _e1715 {
                                                }
                                                phi_2400_ = _e1715;
                                            }
                                            let _e1717 = phi_2400_;
                                            if _e1717 {
                                                phi_2408_ = lt_bvh_Hit(_e1492.t, _e1492.u, _e1492.v, _e1028, 4294967295u);
                                            } else {
                                                phi_2408_ = _e1017;
                                            }
                                            let _e1723 = phi_2408_;
                                            phi_2409_ = _e1723;
                                        } else {
                                            phi_2409_ = _e1017;
                                        }
                                        let _e1725 = phi_2409_;
                                        phi_2410_ = _e1725;
                                    } else {
                                        phi_2410_ = _e1017;
                                    }
                                    let _e1727 = phi_2410_;
                                    phi_2411_ = _e1727;
                                } else {
                                    phi_2411_ = _e1017;
                                }
                                let _e1729 = phi_2411_;
                                phi_1554_ = _e1729;
                                phi_1557_ = (_e1019 & (_e1019 - 1u));
                                phi_2412_ = true;
                            }
                            let _e1731 = phi_1554_;
                            let _e1733 = phi_1557_;
                            let _e1735 = phi_2412_;
                            continue;
                            continuing {
                                phi_1553_ = _e1731;
                                phi_1556_ = _e1733;
                                break if !(_e1735);
                            }
                        }
                        let _e1738 = local_1.group_mask;
                        if ((_e1738 & 4278190080u) == 0u) {
                            let _e1742 = local_1.len;
                            if (_e1742 == 0u) {
                                phi_2451_ = false;
                            } else {
                                let _e1746 = local_1.len;
                                local_1.len = (_e1746 - 1u);
                                let _e1749 = local_1.len;
                                if (_e1749 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1754 = local_1.first[(0u + _e1749)];
                                local_1.group = _e1754;
                                let _e1757 = local_1.len;
                                if (_e1757 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1762 = local_1.mask[(0u + _e1757)];
                                local_1.group_mask = _e1762;
                                phi_2451_ = true;
                            }
                            let _e1765 = phi_2451_;
                            phi_2452_ = _e1765;
                        } else {
                            phi_2452_ = true;
                        }
                        let _e1767 = phi_2452_;
                        if _e1767 {
                            let _e1769 = local_1.group_mask;
                            let _e1775 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1769)), 32u, (_e1769 == 0u)));
                            let _e1779 = local_1.group_mask;
                            let _e1793 = local_1.group_mask;
                            local_1.group_mask = (_e1793 & ~((1u << bitcast<u32>((_e1775 & 31u)))));
                            let _e1796 = local_1.group;
                            phi_2483_ = (_e1796 + countOneBits(((_e1779 & ~((4294967295u << bitcast<u32>((((_e1775 - 24u) ^ _e436) & 31u))))) & 255u)));
                        } else {
                            phi_2483_ = 4294967295u;
                        }
                        let _e1799 = phi_2483_;
                        let _e2578 = local_5;
                        phi_1217_ = _e2578;
                        phi_1220_ = _e1799;
                    } else {
                        phi_1217_ = lt_bvh_Hit();
                        phi_1220_ = u32();
                    }
                    let _e1801 = phi_1217_;
                    let _e1803 = phi_1220_;
                    continue;
                    continuing {
                        phi_1216_ = _e1801;
                        phi_1219_ = _e1803;
                        break if !(_e577);
                    }
                }
                let _e2582 = local_6;
                phi_2484_ = _e2582;
            }
            let _e1806 = phi_2484_;
            phi_2485_ = _e1806;
            phi_2486_ = _e231;
        } else {
            phi_2485_ = lt_bvh_Hit();
            phi_2486_ = true;
        }
        let _e1808 = phi_2485_;
        let _e1810 = phi_2486_;
        if _e1810 {
            phi_2490_ = _e161;
        } else {
            phi_2490_ = _e1808;
        }
        let _e1812 = phi_2490_;
        if (_e1812.triangle != 4294967295u) {
            let _e1818 = ((1f - _e1812.u) - _e1812.v);
            if (_e1812.triangle < _e80) {
            } else {
                return;
            }
            let _e1824 = triangles.member[(0u + _e1812.triangle)];
            let _e1849 = (((_e1824.v0_.x * _e1818) + (_e1824.v1_.x * _e1812.u)) + (_e1824.v2_.x * _e1812.v));
            let _e1850 = (((_e1824.v0_.y * _e1818) + (_e1824.v1_.y * _e1812.u)) + (_e1824.v2_.y * _e1812.v));
            let _e1851 = (((_e1824.v0_.z * _e1818) + (_e1824.v1_.z * _e1812.u)) + (_e1824.v2_.z * _e1812.v));
            let _e1854 = abs(_e1824.v0_.x);
            let _e1856 = abs(_e1824.v0_.y);
            let _e1858 = abs(_e1824.v0_.z);
            let _e1860 = abs(_e1824.v1_.x);
            let _e1862 = abs(_e1824.v1_.y);
            let _e1864 = abs(_e1824.v1_.z);
            if (_e1854 > _e1860) {
                phi_2555_ = _e1854;
            } else {
                phi_2555_ = _e1860;
            }
            let _e1867 = phi_2555_;
            if (_e1856 > _e1862) {
                phi_2560_ = _e1856;
            } else {
                phi_2560_ = _e1862;
            }
            let _e1870 = phi_2560_;
            if (_e1858 > _e1864) {
                phi_2565_ = _e1858;
            } else {
                phi_2565_ = _e1864;
            }
            let _e1873 = phi_2565_;
            let _e1875 = abs(_e1824.v2_.x);
            let _e1877 = abs(_e1824.v2_.y);
            let _e1879 = abs(_e1824.v2_.z);
            if (_e1867 > _e1875) {
                phi_2576_ = _e1867;
            } else {
                phi_2576_ = _e1875;
            }
            let _e1882 = phi_2576_;
            if (_e1870 > _e1877) {
                phi_2581_ = _e1870;
            } else {
                phi_2581_ = _e1877;
            }
            let _e1885 = phi_2581_;
            if (_e1873 > _e1879) {
                phi_2586_ = _e1873;
            } else {
                phi_2586_ = _e1879;
            }
            let _e1888 = phi_2586_;
            let _e1891 = (_e1824.v1_.x - _e1824.v0_.x);
            let _e1894 = (_e1824.v1_.y - _e1824.v0_.y);
            let _e1897 = (_e1824.v1_.z - _e1824.v0_.z);
            let _e1900 = (_e1824.v2_.x - _e1824.v0_.x);
            let _e1903 = (_e1824.v2_.y - _e1824.v0_.y);
            let _e1906 = (_e1824.v2_.z - _e1824.v0_.z);
            let _e1910 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1894), abs(_e1897));
            let _e1911 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1891), _e1910);
            let _e1912 = (_e1891 / _e1911);
            let _e1913 = (_e1894 / _e1911);
            let _e1914 = (_e1897 / _e1911);
            let _e1918 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1903), abs(_e1906));
            let _e1919 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1900), _e1918);
            let _e1920 = (_e1900 / _e1919);
            let _e1921 = (_e1903 / _e1919);
            let _e1922 = (_e1906 / _e1919);
            let _e1925 = ((_e1913 * _e1922) - (_e1921 * _e1914));
            let _e1928 = ((_e1914 * _e1920) - (_e1922 * _e1912));
            let _e1931 = ((_e1912 * _e1921) - (_e1920 * _e1913));
            let _e1933 = p.member.eye;
            let _e1946 = (1f / sqrt((((_e1925 * _e1925) + (_e1928 * _e1928)) + (_e1931 * _e1931))));
            let _e1947 = (_e1925 * _e1946);
            let _e1948 = (_e1928 * _e1946);
            let _e1949 = (_e1931 * _e1946);
            if ((((_e1947 * (_e1933.x - _e1849)) + (_e1948 * (_e1933.y - _e1850))) + (_e1949 * (_e1933.z - _e1851))) < 0f) {
                phi_2662_ = vec3<f32>(-(_e1947), -(_e1948), -(_e1949));
            } else {
                phi_2662_ = vec3<f32>(_e1947, _e1948, _e1949);
            }
            let _e1962 = phi_2662_;
            if (_e1812.triangle < _e80) {
            } else {
                return;
            }
            let _e1967 = triangles.member[(0u + _e1812.triangle)];
            let _e1969 = (_e1967.i0_ & 2147483647u);
            if (_e1969 < _e83) {
            } else {
                return;
            }
            let _e1975 = vertices.member[(0u + _e1969)];
            if (_e1967.i1_ < _e83) {
            } else {
                return;
            }
            let _e1979 = vertices.member[(0u + _e1967.i1_)];
            if (_e1967.i2_ < _e83) {
            } else {
                return;
            }
            let _e1983 = vertices.member[(0u + _e1967.i2_)];
            let _e1984 = array<abi_Vertex, 3>(_e1975, _e1979, _e1983);
            if (_e1984[0].material < _e86) {
            } else {
                return;
            }
            let _e1990 = materials.member[(0u + _e1984[0].material)];
            let _e2007 = (1f / 255f);
            let _e2026 = (1f / 255f);
            let _e2048 = (1f / 255f);
            let _e2061 = _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(vec3<f32>(_e1818, _e1812.u, _e1812.v));
            let _e2063 = ((_e1990.base_color.x * ((((f32((_e1984[0].color & 255u)) * _e2007) * _e1818) + ((f32((_e1984[1].color & 255u)) * _e2026) * _e1812.u)) + ((f32((_e1984[2].color & 255u)) * _e2048) * _e1812.v))) * _e2061.x);
            let _e2065 = ((_e1990.base_color.y * ((((f32(((_e1984[0].color >> bitcast<u32>(8i)) & 255u)) * _e2007) * _e1818) + ((f32(((_e1984[1].color >> bitcast<u32>(8i)) & 255u)) * _e2026) * _e1812.u)) + ((f32(((_e1984[2].color >> bitcast<u32>(8i)) & 255u)) * _e2048) * _e1812.v))) * _e2061.y);
            let _e2067 = ((_e1990.base_color.z * ((((f32(((_e1984[0].color >> bitcast<u32>(16i)) & 255u)) * _e2007) * _e1818) + ((f32(((_e1984[1].color >> bitcast<u32>(16i)) & 255u)) * _e2026) * _e1812.u)) + ((f32(((_e1984[2].color >> bitcast<u32>(16i)) & 255u)) * _e2048) * _e1812.v))) * _e2061.z);
            let _e2068 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1885, _e1888);
            let _e2069 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1882, _e2068);
            if ((_e1990.flags & 2u) == 0u) {
                phi_2783_ = 0u;
            } else {
                phi_2783_ = 1u;
            }
            let _e2074 = phi_2783_;
            if (_e1984[0].normal == 2147516416u) {
                phi_2986_ = _e1962;
            } else {
                let _e2087 = (f32((bitcast<i32>((_e1984[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2093 = (f32((bitcast<i32>(_e1984[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2097 = ((1f - abs(_e2087)) - abs(_e2093));
                if (_e2097 < 0f) {
                    phi_2810_ = -(_e2097);
                } else {
                    phi_2810_ = 0f;
                }
                let _e2101 = phi_2810_;
                if (_e2087 < 0f) {
                    phi_2817_ = (_e2087 + _e2101);
                } else {
                    phi_2817_ = (_e2087 - _e2101);
                }
                let _e2106 = phi_2817_;
                if (_e2093 < 0f) {
                    phi_2824_ = (_e2093 + _e2101);
                } else {
                    phi_2824_ = (_e2093 - _e2101);
                }
                let _e2111 = phi_2824_;
                let _e2118 = (1f / sqrt((((_e2106 * _e2106) + (_e2111 * _e2111)) + (_e2097 * _e2097))));
                let _e2134 = (f32((bitcast<i32>((_e1984[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2140 = (f32((bitcast<i32>(_e1984[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2144 = ((1f - abs(_e2134)) - abs(_e2140));
                if (_e2144 < 0f) {
                    phi_2859_ = -(_e2144);
                } else {
                    phi_2859_ = 0f;
                }
                let _e2148 = phi_2859_;
                if (_e2134 < 0f) {
                    phi_2866_ = (_e2134 + _e2148);
                } else {
                    phi_2866_ = (_e2134 - _e2148);
                }
                let _e2153 = phi_2866_;
                if (_e2140 < 0f) {
                    phi_2873_ = (_e2140 + _e2148);
                } else {
                    phi_2873_ = (_e2140 - _e2148);
                }
                let _e2158 = phi_2873_;
                let _e2165 = (1f / sqrt((((_e2153 * _e2153) + (_e2158 * _e2158)) + (_e2144 * _e2144))));
                let _e2184 = (f32((bitcast<i32>((_e1984[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2190 = (f32((bitcast<i32>(_e1984[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2194 = ((1f - abs(_e2184)) - abs(_e2190));
                if (_e2194 < 0f) {
                    phi_2911_ = -(_e2194);
                } else {
                    phi_2911_ = 0f;
                }
                let _e2198 = phi_2911_;
                if (_e2184 < 0f) {
                    phi_2918_ = (_e2184 + _e2198);
                } else {
                    phi_2918_ = (_e2184 - _e2198);
                }
                let _e2203 = phi_2918_;
                if (_e2190 < 0f) {
                    phi_2925_ = (_e2190 + _e2198);
                } else {
                    phi_2925_ = (_e2190 - _e2198);
                }
                let _e2208 = phi_2925_;
                let _e2215 = (1f / sqrt((((_e2203 * _e2203) + (_e2208 * _e2208)) + (_e2194 * _e2194))));
                let _e2226 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(vec3<f32>(((((_e2106 * _e2118) * _e1818) + ((_e2153 * _e2165) * _e1812.u)) + ((_e2203 * _e2215) * _e1812.v)), ((((_e2111 * _e2118) * _e1818) + ((_e2158 * _e2165) * _e1812.u)) + ((_e2208 * _e2215) * _e1812.v)), ((((_e2097 * _e2118) * _e1818) + ((_e2144 * _e2165) * _e1812.u)) + ((_e2194 * _e2215) * _e1812.v))));
                let _e2238 = sqrt((((_e2226.x * _e2226.x) + (_e2226.y * _e2226.y)) + (_e2226.z * _e2226.z)));
                if (_e2238 > 0f) {
                    let _e2241 = (_e2226.x / _e2238);
                    let _e2243 = (_e2226.y / _e2238);
                    let _e2245 = (_e2226.z / _e2238);
                    if ((((_e2241 * _e1962.x) + (_e2243 * _e1962.y)) + (_e2245 * _e1962.z)) < 0f) {
                        phi_2984_ = vec3<f32>(-(_e2241), -(_e2243), -(_e2245));
                    } else {
                        phi_2984_ = (_e2226 / vec3(_e2238));
                    }
                    let _e2262 = phi_2984_;
                    phi_2985_ = _e2262;
                } else {
                    phi_2985_ = _e1962;
                }
                let _e2264 = phi_2985_;
                phi_2986_ = _e2264;
            }
            let _e2266 = phi_2986_;
            if (_e2063 > 0f) {
                if (_e2063 < 1f) {
                    phi_2995_ = _e2063;
                } else {
                    phi_2995_ = 1f;
                }
                let _e2270 = phi_2995_;
                phi_2996_ = _e2270;
            } else {
                phi_2996_ = 0f;
            }
            let _e2272 = phi_2996_;
            if (_e2065 > 0f) {
                if (_e2065 < 1f) {
                    phi_3006_ = _e2065;
                } else {
                    phi_3006_ = 1f;
                }
                let _e2277 = phi_3006_;
                phi_3007_ = _e2277;
            } else {
                phi_3007_ = 0f;
            }
            let _e2279 = phi_3007_;
            if (_e2067 > 0f) {
                if (_e2067 < 1f) {
                    phi_3017_ = _e2067;
                } else {
                    phi_3017_ = 1f;
                }
                let _e2284 = phi_3017_;
                phi_3018_ = _e2284;
            } else {
                phi_3018_ = 0f;
            }
            let _e2286 = phi_3018_;
            let _e2289 = ((sqrt(_e2272) * 255f) + 0.5f);
            let _e2298 = ((sqrt(_e2279) * 255f) + 0.5f);
            let _e2310 = ((sqrt(_e2286) * 255f) + 0.5f);
            phi_3053_ = abi_Sample(vec3<f32>(_e1849, _e1850, _e1851), _e2069, _e1962, _e2074, _e2266, ((select(select(u32(_e2289), 0u, (_e2289 < bitcast<f32>(0u))), 4294967295u, (_e2289 > bitcast<f32>(1333788671u))) | (select(select(u32(_e2298), 0u, (_e2298 < bitcast<f32>(0u))), 4294967295u, (_e2298 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e2310), 0u, (_e2310 < bitcast<f32>(0u))), 4294967295u, (_e2310 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_3053_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e2324 = phi_3053_;
        if (_e104.shift < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e104.shift)] = _e2324;
        if (_e1812.triangle != 4294967295u) {
            let _e2333 = ((1f - _e1812.u) - _e1812.v);
            if (_e1812.triangle < _e80) {
            } else {
                return;
            }
            let _e2338 = triangles.member[(0u + _e1812.triangle)];
            let _e2340 = (_e2338.i0_ & 2147483647u);
            if (_e2340 < _e95) {
            } else {
                return;
            }
            let _e2346 = before.member[(0u + _e2340)];
            if (_e2338.i1_ < _e95) {
            } else {
                return;
            }
            let _e2350 = before.member[(0u + _e2338.i1_)];
            if (_e2338.i2_ < _e95) {
            } else {
                return;
            }
            let _e2354 = before.member[(0u + _e2338.i2_)];
            let _e2359 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(vec3<f32>(_e2346.x, _e2346.y, _e2346.z));
            let _e2370 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(vec3<f32>(_e2350.x, _e2350.y, _e2350.z));
            let _e2384 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(vec3<f32>(_e2354.x, _e2354.y, _e2354.z));
            phi_3144_ = vec3<f32>((((_e2359.x * _e2333) + (_e2370.x * _e1812.u)) + (_e2384.x * _e1812.v)), (((_e2359.y * _e2333) + (_e2370.y * _e1812.u)) + (_e2384.y * _e1812.v)), (((_e2359.z * _e2333) + (_e2370.z * _e1812.u)) + (_e2384.z * _e1812.v)));
        } else {
            phi_3144_ = vec3<f32>(0f, 0f, 0f);
        }
        let _e2396 = phi_3144_;
        if (_e104.shift < arrayLength((&past.member))) {
        } else {
            return;
        }
        past.member[(0u + _e104.shift)] = vec4<f32>(_e2396.x, _e2396.y, _e2396.z, 1f);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_alpha_motion_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
