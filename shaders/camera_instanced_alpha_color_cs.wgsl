struct abi_CameraParams {
    eye: vec3<f32>,
    root: u32,
    right: vec3<f32>,
    layers_behind: u32,
    up: vec3<f32>,
    pad1_: u32,
    forward: vec3<f32>,
    pad2_: u32,
    size: vec2<u32>,
    grid: vec2<u32>,
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

struct type_31 {
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

struct type_35 {
    member: array<lt_bvh_Triangle>,
}

struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
}

struct type_39 {
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

struct type_43 {
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

struct type_57 {
    member: array<lt_bvh_Instance>,
}

struct type_61 {
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
var<storage> vertices: type_39;
@group(0) @binding(4) 
var<storage> materials: type_43;
@group(0) @binding(0) 
var<uniform> p: type_61;
@group(0) @binding(1) 
var<storage> nodes: type_31;
@group(0) @binding(2) 
var<storage> triangles: type_35;
@group(0) @binding(5) 
var<storage, read_write> samples: type_9;
@group(0) @binding(6) 
var<storage> instances: type_57;
@group(0) @binding(7) 
var<storage> alpha_texels: type_13;
@group(0) @binding(8) 
var<storage> color_texels: type_13;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_mask_LightPlace {
    var phi_224_: lt_mask_LightPlace;
    var phi_225_: bool;
    var phi_226_: lt_mask_LightPlace;
    var phi_227_: bool;
    var phi_232_: lt_mask_LightPlace;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_224_ = lt_mask_LightPlace(1u, ((param.y * param_1) + param.x));
            phi_225_ = false;
        } else {
            phi_224_ = lt_mask_LightPlace();
            phi_225_ = true;
        }
        let _e84 = phi_224_;
        let _e86 = phi_225_;
        phi_226_ = _e84;
        phi_227_ = _e86;
    } else {
        phi_226_ = lt_mask_LightPlace();
        phi_227_ = true;
    }
    let _e88 = phi_226_;
    let _e90 = phi_227_;
    if _e90 {
        phi_232_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_232_ = _e88;
    }
    let _e95 = phi_232_;
    return lt_mask_LightPlace(_e95.word, _e95.shift);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_247_: bool;
    var phi_251_: f32;

    if (param_3 != param_3) {
        phi_247_ = true;
    } else {
        let _e74 = (param_4 >= param_3);
        if _e74 {
        }
        phi_247_ = _e74;
    }
    let _e76 = phi_247_;
    if _e76 {
        phi_251_ = param_4;
    } else {
        phi_251_ = param_3;
    }
    let _e78 = phi_251_;
    return _e78;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_263_: bool;
    var phi_267_: f32;

    if (param_5 != param_5) {
        phi_263_ = true;
    } else {
        let _e74 = (param_6 <= param_5);
        if _e74 {
        }
        phi_263_ = _e74;
    }
    let _e76 = phi_263_;
    if _e76 {
        phi_267_ = param_6;
    } else {
        phi_267_ = param_5;
    }
    let _e78 = phi_267_;
    return _e78;
}

fn _lt_shaders_texture_TextureView_quad(param_7: ptr<function, texture_TextureView>, param_8: f32, param_9: f32) -> texture_TexelQuad {
    var phi_309_: f32;
    var phi_314_: f32;
    var phi_315_: bool;
    var phi_316_: f32;
    var phi_317_: bool;
    var phi_321_: f32;
    var phi_347_: f32;
    var phi_352_: f32;
    var phi_353_: bool;
    var phi_354_: f32;
    var phi_355_: bool;
    var phi_359_: f32;
    var phi_367_: f32;
    var phi_368_: f32;
    var phi_369_: f32;
    var phi_378_: f32;
    var phi_379_: f32;
    var phi_397_: u32;
    var phi_411_: u32;
    var phi_418_: u32;
    var phi_423_: u32;
    var phi_429_: u32;
    var phi_434_: u32;
    var phi_436_: texture_Axis;
    var phi_464_: f32;
    var phi_469_: f32;
    var phi_470_: bool;
    var phi_471_: f32;
    var phi_472_: bool;
    var phi_476_: f32;
    var phi_502_: f32;
    var phi_507_: f32;
    var phi_508_: bool;
    var phi_509_: f32;
    var phi_510_: bool;
    var phi_514_: f32;
    var phi_522_: f32;
    var phi_523_: f32;
    var phi_524_: f32;
    var phi_533_: f32;
    var phi_534_: f32;
    var phi_552_: u32;
    var phi_566_: u32;
    var phi_573_: u32;
    var phi_578_: u32;
    var phi_584_: u32;
    var phi_589_: u32;
    var phi_591_: texture_Axis;

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
                phi_309_ = 1f;
            } else {
                phi_309_ = 0f;
            }
            let _e105 = phi_309_;
            if (param_8 < 8388608f) {
                phi_314_ = (_e102 - _e105);
                phi_315_ = false;
            } else {
                phi_314_ = f32();
                phi_315_ = true;
            }
            let _e108 = phi_314_;
            let _e110 = phi_315_;
            phi_316_ = _e108;
            phi_317_ = _e110;
        } else {
            phi_316_ = f32();
            phi_317_ = true;
        }
        let _e112 = phi_316_;
        let _e114 = phi_317_;
        if _e114 {
            phi_321_ = param_8;
        } else {
            phi_321_ = _e112;
        }
        let _e116 = phi_321_;
        phi_369_ = (param_8 - _e116);
    } else {
        if (_e89 == 1u) {
            let _e119 = (param_8 * 0.5f);
            if (_e119 > -8388608f) {
                let _e131 = f32(select(0i, select(select(i32(_e119), i32(-2147483648), (_e119 < bitcast<f32>(3472883712u))), 2147483647i, (_e119 > bitcast<f32>(1325400063u))), (_e119 == _e119)));
                if (_e131 > _e119) {
                    phi_347_ = 1f;
                } else {
                    phi_347_ = 0f;
                }
                let _e134 = phi_347_;
                if (_e119 < 8388608f) {
                    phi_352_ = (_e131 - _e134);
                    phi_353_ = false;
                } else {
                    phi_352_ = f32();
                    phi_353_ = true;
                }
                let _e137 = phi_352_;
                let _e139 = phi_353_;
                phi_354_ = _e137;
                phi_355_ = _e139;
            } else {
                phi_354_ = f32();
                phi_355_ = true;
            }
            let _e141 = phi_354_;
            let _e143 = phi_355_;
            if _e143 {
                phi_359_ = _e119;
            } else {
                phi_359_ = _e141;
            }
            let _e145 = phi_359_;
            let _e147 = (param_8 - (2f * _e145));
            if (_e147 > 1f) {
                phi_367_ = (2f - _e147);
            } else {
                phi_367_ = _e147;
            }
            let _e151 = phi_367_;
            phi_368_ = _e151;
        } else {
            phi_368_ = param_8;
        }
        let _e153 = phi_368_;
        phi_369_ = _e153;
    }
    let _e155 = phi_369_;
    if (_e155 > 0f) {
        if (_e155 < 1f) {
            phi_378_ = _e155;
        } else {
            phi_378_ = 1f;
        }
        let _e159 = phi_378_;
        phi_379_ = _e159;
    } else {
        phi_379_ = 0f;
    }
    let _e161 = phi_379_;
    let _e162 = (_e76 - 1u);
    let _e164 = (_e161 * f32(_e76));
    if _e84 {
        let _e171 = select(select(u32(_e164), 0u, (_e164 < bitcast<f32>(0u))), 4294967295u, (_e164 > bitcast<f32>(1333788671u)));
        if (_e162 < _e171) {
            phi_397_ = _e162;
        } else {
            phi_397_ = _e171;
        }
        let _e174 = phi_397_;
        phi_436_ = texture_Axis(_e174, _e174, 0f);
    } else {
        let _e176 = (_e164 + 0.5f);
        let _e183 = select(select(u32(_e176), 0u, (_e176 < bitcast<f32>(0u))), 4294967295u, (_e176 > bitcast<f32>(1333788671u)));
        if (_e76 < _e183) {
            phi_411_ = _e76;
        } else {
            phi_411_ = _e183;
        }
        let _e186 = phi_411_;
        if (_e89 == 0u) {
            phi_418_ = _e162;
        } else {
            phi_418_ = 0u;
        }
        let _e191 = phi_418_;
        if (_e89 == 0u) {
            phi_423_ = 0u;
        } else {
            phi_423_ = _e162;
        }
        let _e194 = phi_423_;
        if (_e186 == 0u) {
            phi_429_ = _e191;
        } else {
            phi_429_ = (_e186 - 1u);
        }
        let _e198 = phi_429_;
        if (_e186 > _e162) {
            phi_434_ = _e194;
        } else {
            phi_434_ = _e186;
        }
        let _e201 = phi_434_;
        phi_436_ = texture_Axis(_e198, _e201, (_e176 - f32(_e186)));
    }
    let _e204 = phi_436_;
    let _e206 = (*param_7).flags;
    let _e209 = ((_e206 >> bitcast<u32>(6u)) & 3u);
    if (_e209 == 0u) {
        if (param_9 > -8388608f) {
            let _e222 = f32(select(0i, select(select(i32(param_9), i32(-2147483648), (param_9 < bitcast<f32>(3472883712u))), 2147483647i, (param_9 > bitcast<f32>(1325400063u))), (param_9 == param_9)));
            if (_e222 > param_9) {
                phi_464_ = 1f;
            } else {
                phi_464_ = 0f;
            }
            let _e225 = phi_464_;
            if (param_9 < 8388608f) {
                phi_469_ = (_e222 - _e225);
                phi_470_ = false;
            } else {
                phi_469_ = f32();
                phi_470_ = true;
            }
            let _e228 = phi_469_;
            let _e230 = phi_470_;
            phi_471_ = _e228;
            phi_472_ = _e230;
        } else {
            phi_471_ = f32();
            phi_472_ = true;
        }
        let _e232 = phi_471_;
        let _e234 = phi_472_;
        if _e234 {
            phi_476_ = param_9;
        } else {
            phi_476_ = _e232;
        }
        let _e236 = phi_476_;
        phi_524_ = (param_9 - _e236);
    } else {
        if (_e209 == 1u) {
            let _e239 = (param_9 * 0.5f);
            if (_e239 > -8388608f) {
                let _e251 = f32(select(0i, select(select(i32(_e239), i32(-2147483648), (_e239 < bitcast<f32>(3472883712u))), 2147483647i, (_e239 > bitcast<f32>(1325400063u))), (_e239 == _e239)));
                if (_e251 > _e239) {
                    phi_502_ = 1f;
                } else {
                    phi_502_ = 0f;
                }
                let _e254 = phi_502_;
                if (_e239 < 8388608f) {
                    phi_507_ = (_e251 - _e254);
                    phi_508_ = false;
                } else {
                    phi_507_ = f32();
                    phi_508_ = true;
                }
                let _e257 = phi_507_;
                let _e259 = phi_508_;
                phi_509_ = _e257;
                phi_510_ = _e259;
            } else {
                phi_509_ = f32();
                phi_510_ = true;
            }
            let _e261 = phi_509_;
            let _e263 = phi_510_;
            if _e263 {
                phi_514_ = _e239;
            } else {
                phi_514_ = _e261;
            }
            let _e265 = phi_514_;
            let _e267 = (param_9 - (2f * _e265));
            if (_e267 > 1f) {
                phi_522_ = (2f - _e267);
            } else {
                phi_522_ = _e267;
            }
            let _e271 = phi_522_;
            phi_523_ = _e271;
        } else {
            phi_523_ = param_9;
        }
        let _e273 = phi_523_;
        phi_524_ = _e273;
    }
    let _e275 = phi_524_;
    if (_e275 > 0f) {
        if (_e275 < 1f) {
            phi_533_ = _e275;
        } else {
            phi_533_ = 1f;
        }
        let _e279 = phi_533_;
        phi_534_ = _e279;
    } else {
        phi_534_ = 0f;
    }
    let _e281 = phi_534_;
    let _e282 = (_e80 - 1u);
    let _e284 = (_e281 * f32(_e80));
    if _e84 {
        let _e291 = select(select(u32(_e284), 0u, (_e284 < bitcast<f32>(0u))), 4294967295u, (_e284 > bitcast<f32>(1333788671u)));
        if (_e282 < _e291) {
            phi_552_ = _e282;
        } else {
            phi_552_ = _e291;
        }
        let _e294 = phi_552_;
        phi_591_ = texture_Axis(_e294, _e294, 0f);
    } else {
        let _e296 = (_e284 + 0.5f);
        let _e303 = select(select(u32(_e296), 0u, (_e296 < bitcast<f32>(0u))), 4294967295u, (_e296 > bitcast<f32>(1333788671u)));
        if (_e80 < _e303) {
            phi_566_ = _e80;
        } else {
            phi_566_ = _e303;
        }
        let _e306 = phi_566_;
        if (_e209 == 0u) {
            phi_573_ = _e282;
        } else {
            phi_573_ = 0u;
        }
        let _e311 = phi_573_;
        if (_e209 == 0u) {
            phi_578_ = 0u;
        } else {
            phi_578_ = _e282;
        }
        let _e314 = phi_578_;
        if (_e306 == 0u) {
            phi_584_ = _e311;
        } else {
            phi_584_ = (_e306 - 1u);
        }
        let _e318 = phi_584_;
        if (_e306 > _e282) {
            phi_589_ = _e314;
        } else {
            phi_589_ = _e306;
        }
        let _e321 = phi_589_;
        phi_591_ = texture_Axis(_e318, _e321, (_e296 - f32(_e306)));
    }
    let _e324 = phi_591_;
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
    var phi_650_: f32;

    if (param_12 > param_13) {
        phi_650_ = param_12;
    } else {
        phi_650_ = param_13;
    }
    let _e75 = phi_650_;
    return _e75;
}

fn function_() {
    var local: texture_TextureView;
    var local_1: texture_TextureView;
    var local_2: lt_bvh_traverse_Stack;
    var local_3: lt_bvh_traverse_Stack;
    var phi_804_: bool;
    var phi_805_: bool;
    var phi_806_: bool;
    var phi_807_: bool;
    var phi_811_: bool;
    var phi_824_: bool;
    var phi_825_: bool;
    var phi_826_: bool;
    var phi_827_: bool;
    var phi_831_: bool;
    var phi_844_: bool;
    var phi_845_: bool;
    var phi_846_: bool;
    var phi_850_: bool;
    var phi_851_: bool;
    var phi_852_: bool;
    var phi_853_: bool;
    var phi_854_: bool;
    var phi_858_: bool;
    var phi_934_: f32;
    var phi_941_: f32;
    var phi_949_: f32;
    var phi_956_: f32;
    var phi_964_: f32;
    var phi_971_: f32;
    var phi_994_: f32;
    var phi_999_: f32;
    var phi_1004_: f32;
    var phi_1009_: f32;
    var phi_1014_: f32;
    var phi_1033_: u32;
    var phi_1038_: u32;
    var phi_1043_: u32;
    var phi_1157_: bool;
    var phi_1158_: bool;
    var phi_1189_: u32;
    var phi_1191_: u32;
    var phi_1194_: lt_bvh_Hit;
    var phi_1279_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1306_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1333_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1339_: u32;
    var phi_1342_: u32;
    var phi_1356_: u32;
    var phi_1366_: u32;
    var phi_1376_: u32;
    var phi_1394_: u32;
    var phi_1404_: u32;
    var phi_1414_: u32;
    var phi_1450_: u32;
    var phi_1463_: u32;
    var phi_1468_: u32;
    var phi_1469_: u32;
    var phi_1470_: u32;
    var phi_1340_: u32;
    var phi_1343_: u32;
    var local_4: u32;
    var local_5: u32;
    var local_6: u32;
    var phi_1528_: u32;
    var phi_1531_: lt_bvh_Hit;
    var phi_1586_: f32;
    var phi_1591_: f32;
    var phi_1596_: f32;
    var phi_1604_: f32;
    var phi_1609_: f32;
    var phi_1614_: f32;
    var phi_1746_: bool;
    var phi_1747_: bool;
    var phi_1748_: bool;
    var phi_1749_: bool;
    var phi_1753_: bool;
    var phi_1766_: bool;
    var phi_1767_: bool;
    var phi_1768_: bool;
    var phi_1769_: bool;
    var phi_1773_: bool;
    var phi_1786_: bool;
    var phi_1787_: bool;
    var phi_1788_: bool;
    var phi_1792_: bool;
    var phi_1793_: bool;
    var phi_1794_: bool;
    var phi_1795_: bool;
    var phi_1796_: bool;
    var phi_1800_: bool;
    var phi_1870_: f32;
    var phi_1877_: f32;
    var phi_1884_: f32;
    var phi_1891_: f32;
    var phi_1898_: f32;
    var phi_1905_: f32;
    var phi_1922_: f32;
    var phi_1927_: f32;
    var phi_1932_: f32;
    var phi_1937_: f32;
    var phi_1942_: f32;
    var phi_1968_: bool;
    var phi_1969_: bool;
    var phi_1977_: u32;
    var phi_1978_: u32;
    var phi_1989_: vec3<f32>;
    var phi_1990_: vec3<f32>;
    var phi_2003_: u32;
    var phi_2008_: u32;
    var phi_2013_: u32;
    var phi_2127_: bool;
    var phi_2128_: bool;
    var phi_2159_: u32;
    var phi_2161_: lt_bvh_Hit;
    var phi_2164_: u32;
    var phi_2245_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2272_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2299_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2305_: u32;
    var phi_2308_: u32;
    var phi_2322_: u32;
    var phi_2332_: u32;
    var phi_2342_: u32;
    var phi_2360_: u32;
    var phi_2370_: u32;
    var phi_2380_: u32;
    var phi_2416_: u32;
    var phi_2429_: u32;
    var phi_2434_: u32;
    var phi_2435_: u32;
    var phi_2436_: u32;
    var phi_2306_: u32;
    var phi_2309_: u32;
    var local_7: u32;
    var local_8: u32;
    var local_9: u32;
    var phi_2494_: lt_bvh_Hit;
    var phi_2497_: u32;
    var phi_2541_: vec3<f32>;
    var phi_2542_: vec3<f32>;
    var phi_2571_: vec3<f32>;
    var phi_2572_: vec3<f32>;
    var phi_2601_: vec3<f32>;
    var phi_2602_: vec3<f32>;
    var phi_2620_: bool;
    var phi_2621_: bool;
    var phi_2625_: f32;
    var phi_2626_: f32;
    var phi_2627_: f32;
    var phi_2628_: f32;
    var phi_2636_: f32;
    var phi_2646_: bool;
    var phi_2647_: bool;
    var phi_2651_: f32;
    var phi_2652_: f32;
    var phi_2653_: f32;
    var phi_2654_: f32;
    var phi_2662_: f32;
    var phi_2672_: bool;
    var phi_2673_: bool;
    var phi_2677_: f32;
    var phi_2678_: f32;
    var phi_2679_: f32;
    var phi_2680_: f32;
    var phi_2688_: f32;
    var phi_2703_: f32;
    var phi_2704_: bool;
    var phi_2705_: f32;
    var phi_2706_: bool;
    var phi_2707_: f32;
    var phi_2708_: bool;
    var phi_2726_: f32;
    var phi_2727_: bool;
    var phi_2728_: bool;
    var phi_2729_: f32;
    var phi_2730_: bool;
    var phi_2731_: bool;
    var phi_2735_: bool;
    var phi_2736_: f32;
    var phi_2737_: bool;
    var phi_2765_: vec3<f32>;
    var phi_2766_: vec3<f32>;
    var phi_2791_: vec3<f32>;
    var phi_2792_: vec3<f32>;
    var phi_2817_: vec3<f32>;
    var phi_2818_: vec3<f32>;
    var phi_2874_: f32;
    var phi_2883_: f32;
    var phi_2892_: f32;
    var phi_2901_: f32;
    var phi_2908_: f32;
    var phi_2915_: f32;
    var phi_2928_: f32;
    var phi_2937_: f32;
    var phi_2946_: f32;
    var phi_2955_: f32;
    var phi_2962_: f32;
    var phi_2969_: f32;
    var phi_2986_: f32;
    var phi_2991_: f32;
    var phi_2996_: f32;
    var phi_3004_: f32;
    var phi_3009_: f32;
    var phi_3014_: f32;
    var phi_3026_: f32;
    var phi_3031_: f32;
    var phi_3036_: f32;
    var phi_3041_: f32;
    var phi_3046_: lt_bvh_triangle_Intersection;
    var phi_3047_: bool;
    var phi_3048_: lt_bvh_triangle_Intersection;
    var phi_3049_: bool;
    var phi_3053_: lt_bvh_triangle_Intersection;
    var phi_3054_: bool;
    var phi_3055_: lt_bvh_triangle_Intersection;
    var phi_3056_: bool;
    var phi_3057_: bool;
    var phi_3061_: bool;
    var phi_3065_: lt_bvh_triangle_Intersection;
    var phi_3103_: bool;
    var phi_3104_: bool;
    var phi_3105_: bool;
    var phi_3106_: bool;
    var phi_3107_: bool;
    var phi_3108_: bool;
    var phi_3112_: bool;
    var phi_3113_: bool;
    var phi_3316_: f32;
    var phi_3319_: bool;
    var phi_3320_: bool;
    var phi_3324_: bool;
    var phi_3332_: lt_bvh_Hit;
    var phi_3333_: lt_bvh_Hit;
    var phi_3334_: lt_bvh_Hit;
    var phi_3335_: lt_bvh_Hit;
    var phi_2495_: lt_bvh_Hit;
    var phi_2498_: u32;
    var phi_3336_: bool;
    var phi_3375_: bool;
    var phi_3376_: bool;
    var phi_3407_: u32;
    var phi_2162_: lt_bvh_Hit;
    var phi_2165_: u32;
    var phi_3408_: lt_bvh_Hit;
    var phi_3409_: lt_bvh_Hit;
    var phi_3410_: bool;
    var phi_3414_: lt_bvh_Hit;
    var phi_3415_: lt_bvh_Hit;
    var phi_3416_: lt_bvh_Hit;
    var phi_3417_: lt_bvh_Hit;
    var phi_1529_: u32;
    var phi_1532_: lt_bvh_Hit;
    var phi_3418_: bool;
    var phi_3457_: bool;
    var phi_3458_: bool;
    var phi_3489_: u32;
    var phi_1192_: u32;
    var phi_1195_: lt_bvh_Hit;
    var phi_3490_: lt_bvh_Hit;
    var phi_3491_: lt_bvh_Hit;
    var phi_3492_: bool;
    var phi_3496_: lt_bvh_Hit;
    var phi_3683_: f32;
    var phi_3688_: f32;
    var phi_3693_: f32;
    var phi_3701_: f32;
    var phi_3706_: f32;
    var phi_3711_: f32;
    var phi_3775_: vec3<f32>;
    var phi_4018_: vec3<f32>;
    var phi_4033_: u32;
    var phi_4060_: f32;
    var phi_4067_: f32;
    var phi_4074_: f32;
    var phi_4109_: f32;
    var phi_4116_: f32;
    var phi_4123_: f32;
    var phi_4161_: f32;
    var phi_4168_: f32;
    var phi_4175_: f32;
    var phi_4261_: vec3<f32>;
    var phi_4262_: vec3<f32>;
    var phi_4263_: vec3<f32>;
    var phi_4272_: f32;
    var phi_4273_: f32;
    var phi_4283_: f32;
    var phi_4284_: f32;
    var phi_4294_: f32;
    var phi_4295_: f32;
    var phi_4330_: abi_Sample;
    var local_10: lt_bvh_Hit;
    var local_11: lt_bvh_Hit;
    var local_12: lt_bvh_Hit;
    var local_13: lt_bvh_Hit;

    let _e75 = id_1;
    let _e79 = arrayLength((&nodes.member));
    let _e82 = arrayLength((&triangles.member));
    let _e85 = arrayLength((&vertices.member));
    let _e88 = arrayLength((&materials.member));
    let _e94 = arrayLength((&instances.member));
    let _e97 = arrayLength((&alpha_texels.member));
    let _e100 = arrayLength((&color_texels.member));
    let _e103 = p.member.size[0u];
    let _e105 = p.member.size[1u];
    let _e106 = lt_shaders_entry_pixel_index(_e75, _e103, _e105);
    if (bitcast<i32>(_e106.word) != 0i) {
        let _e112 = p.member.root;
        let _e116 = p.member.eye;
        let _e119 = p.member.grid[0u];
        let _e121 = p.member.grid[1u];
        let _e140 = p.member.size[0u];
        let _e144 = ((((f32(_e75.x) + ((f32((_e75.y & (_e121 - 1u))) + 0.5f) / f32(_e121))) / f32(_e140)) * 2f) - 1f);
        let _e147 = p.member.size[1u];
        let _e151 = (1f - (((f32(_e75.y) + ((f32((_e75.x & (_e119 - 1u))) + 0.5f) / f32(_e119))) / f32(_e147)) * 2f));
        let _e153 = p.member.forward;
        let _e155 = p.member.right;
        let _e169 = p.member.up;
        let _e180 = _lt_bvh_ray_Ray_new(_e116, vec3<f32>(((_e153.x + (_e155.x * _e144)) + (_e169.x * _e151)), ((_e153.y + (_e155.y * _e144)) + (_e169.y * _e151)), ((_e153.z + (_e155.z * _e144)) + (_e169.z * _e151))));
        let _e182 = lt_bvh_Hit(_e180.tmax, 0f, 0f, 4294967295u, 4294967295u);
        let _e185 = abs(_e180.direction.x);
        let _e187 = abs(_e180.direction.y);
        let _e189 = abs(_e180.direction.z);
        if (abs(_e180.origin.x) < 1000000000000000f) {
            if (abs(_e180.origin.y) < 1000000000000000f) {
                phi_804_ = (abs(_e180.origin.z) < 1000000000000000f);
                phi_805_ = false;
            } else {
                phi_804_ = bool();
                phi_805_ = true;
            }
            let _e201 = phi_804_;
            let _e203 = phi_805_;
            phi_806_ = _e201;
            phi_807_ = _e203;
        } else {
            phi_806_ = bool();
            phi_807_ = true;
        }
        let _e205 = phi_806_;
        let _e207 = phi_807_;
        if _e207 {
            phi_811_ = false;
        } else {
            phi_811_ = _e205;
        }
        let _e209 = phi_811_;
        if _e209 {
            if (_e185 < 1000000000000000f) {
                if (_e187 < 1000000000000000f) {
                    phi_824_ = (_e189 < 1000000000000000f);
                    phi_825_ = false;
                } else {
                    phi_824_ = bool();
                    phi_825_ = true;
                }
                let _e214 = phi_824_;
                let _e216 = phi_825_;
                phi_826_ = _e214;
                phi_827_ = _e216;
            } else {
                phi_826_ = bool();
                phi_827_ = true;
            }
            let _e218 = phi_826_;
            let _e220 = phi_827_;
            if _e220 {
                phi_831_ = false;
            } else {
                phi_831_ = _e218;
            }
            let _e222 = phi_831_;
            if _e222 {
                if (_e185 > 0f) {
                    phi_845_ = bool();
                    phi_846_ = true;
                } else {
                    let _e224 = (_e187 > 0f);
                    if _e224 {
                        phi_844_ = bool();
                    } else {
                        phi_844_ = (_e189 > 0f);
                    }
                    let _e227 = phi_844_;
                    phi_845_ = _e227;
                    phi_846_ = _e224;
                }
                let _e229 = phi_845_;
                let _e231 = phi_846_;
                if _e231 {
                    phi_850_ = true;
                } else {
                    phi_850_ = _e229;
                }
                let _e233 = phi_850_;
                phi_851_ = _e233;
                phi_852_ = false;
            } else {
                phi_851_ = bool();
                phi_852_ = true;
            }
            let _e235 = phi_851_;
            let _e237 = phi_852_;
            phi_853_ = _e235;
            phi_854_ = _e237;
        } else {
            phi_853_ = bool();
            phi_854_ = true;
        }
        let _e239 = phi_853_;
        let _e241 = phi_854_;
        if _e241 {
            phi_858_ = false;
        } else {
            phi_858_ = _e239;
        }
        let _e243 = phi_858_;
        if _e243 {
            let _e244 = (_e112 >= _e79);
            if _e244 {
                phi_3490_ = lt_bvh_Hit();
            } else {
                if (_e112 < _e79) {
                } else {
                    return;
                }
                let _e250 = nodes.member[(0u + _e112)].frame[0u];
                let _e254 = nodes.member[(0u + _e112)].frame[1u];
                let _e258 = nodes.member[(0u + _e112)].frame[2u];
                let _e262 = nodes.member[(0u + _e112)].frame[0u];
                let _e266 = nodes.member[(0u + _e112)].frame[1u];
                let _e270 = nodes.member[(0u + _e112)].frame[2u];
                let _e274 = nodes.member[(0u + _e112)].frame[3u];
                let _e313 = core_intrinsics_maximum_number_nsz_f32_(abs(_e180.direction.x), abs(_e180.direction.y));
                let _e314 = core_intrinsics_maximum_number_nsz_f32_(_e313, abs(_e180.direction.z));
                let _e315 = (_e314 * 0.0000000000009094947f);
                if (abs(_e180.direction.x) < _e315) {
                    phi_934_ = _e315;
                } else {
                    phi_934_ = abs(_e180.direction.x);
                }
                let _e321 = phi_934_;
                if (_e180.direction.x < 0f) {
                    phi_941_ = (-1f / _e321);
                } else {
                    phi_941_ = (1f / _e321);
                }
                let _e326 = phi_941_;
                if (abs(_e180.direction.y) < _e315) {
                    phi_949_ = _e315;
                } else {
                    phi_949_ = abs(_e180.direction.y);
                }
                let _e332 = phi_949_;
                if (_e180.direction.y < 0f) {
                    phi_956_ = (-1f / _e332);
                } else {
                    phi_956_ = (1f / _e332);
                }
                let _e337 = phi_956_;
                if (abs(_e180.direction.z) < _e315) {
                    phi_964_ = _e315;
                } else {
                    phi_964_ = abs(_e180.direction.z);
                }
                let _e343 = phi_964_;
                if (_e180.direction.z < 0f) {
                    phi_971_ = (-1f / _e343);
                } else {
                    phi_971_ = (1f / _e343);
                }
                let _e348 = phi_971_;
                let _e355 = abs((bitcast<f32>(_e250) - _e180.origin.x));
                let _e356 = abs((bitcast<f32>(_e254) - _e180.origin.y));
                let _e357 = abs((bitcast<f32>(_e258) - _e180.origin.z));
                let _e364 = abs(((bitcast<f32>(_e262) + (bitcast<f32>((((_e274 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e180.origin.x));
                let _e365 = abs(((bitcast<f32>(_e266) + (bitcast<f32>((((_e274 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e180.origin.y));
                let _e366 = abs(((bitcast<f32>(_e270) + (bitcast<f32>((((_e274 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e180.origin.z));
                if (_e355 > _e364) {
                    phi_994_ = _e355;
                } else {
                    phi_994_ = _e364;
                }
                let _e369 = phi_994_;
                if (_e356 > _e365) {
                    phi_999_ = _e356;
                } else {
                    phi_999_ = _e365;
                }
                let _e372 = phi_999_;
                if (_e357 > _e366) {
                    phi_1004_ = _e357;
                } else {
                    phi_1004_ = _e366;
                }
                let _e375 = phi_1004_;
                if (_e369 > _e372) {
                    phi_1009_ = _e369;
                } else {
                    phi_1009_ = _e372;
                }
                let _e378 = phi_1009_;
                if (_e378 > _e375) {
                    phi_1014_ = _e378;
                } else {
                    phi_1014_ = _e375;
                }
                let _e381 = phi_1014_;
                let _e385 = (_e381 * 0.0000019073486f);
                let _e386 = (abs(_e326) * _e385);
                let _e387 = (abs(_e337) * _e385);
                let _e388 = (abs(_e348) * _e385);
                let _e392 = (_e381 * 0.0000009536743f);
                let _e393 = (abs(_e326) * _e392);
                let _e394 = (abs(_e337) * _e392);
                let _e395 = (abs(_e348) * _e392);
                if (_e326 < 0f) {
                    phi_1033_ = 0u;
                } else {
                    phi_1033_ = 1u;
                }
                let _e398 = phi_1033_;
                if (_e337 < 0f) {
                    phi_1038_ = 0u;
                } else {
                    phi_1038_ = 2u;
                }
                let _e401 = phi_1038_;
                if (_e348 < 0f) {
                    phi_1043_ = 0u;
                } else {
                    phi_1043_ = 4u;
                }
                let _e404 = phi_1043_;
                let _e406 = ((_e398 | _e401) | _e404);
                let _e407 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e112, 2147483648u);
                local_3 = lt_bvh_traverse_Stack(array<u32, 32>(_e407.first[0], _e407.first[1], _e407.first[2], _e407.first[3], _e407.first[4], _e407.first[5], _e407.first[6], _e407.first[7], _e407.first[8], _e407.first[9], _e407.first[10], _e407.first[11], _e407.first[12], _e407.first[13], _e407.first[14], _e407.first[15], _e407.first[16], _e407.first[17], _e407.first[18], _e407.first[19], _e407.first[20], _e407.first[21], _e407.first[22], _e407.first[23], _e407.first[24], _e407.first[25], _e407.first[26], _e407.first[27], _e407.first[28], _e407.first[29], _e407.first[30], _e407.first[31]), array<u32, 32>(_e407.mask[0], _e407.mask[1], _e407.mask[2], _e407.mask[3], _e407.mask[4], _e407.mask[5], _e407.mask[6], _e407.mask[7], _e407.mask[8], _e407.mask[9], _e407.mask[10], _e407.mask[11], _e407.mask[12], _e407.mask[13], _e407.mask[14], _e407.mask[15], _e407.mask[16], _e407.mask[17], _e407.mask[18], _e407.mask[19], _e407.mask[20], _e407.mask[21], _e407.mask[22], _e407.mask[23], _e407.mask[24], _e407.mask[25], _e407.mask[26], _e407.mask[27], _e407.mask[28], _e407.mask[29], _e407.mask[30], _e407.mask[31]), _e407.len, _e407.group, _e407.group_mask);
                let _e481 = local_3.group_mask;
                if ((_e481 & 4278190080u) == 0u) {
                    let _e485 = local_3.len;
                    if (_e485 == 0u) {
                        phi_1157_ = false;
                    } else {
                        let _e489 = local_3.len;
                        local_3.len = (_e489 - 1u);
                        let _e492 = local_3.len;
                        if (_e492 < 32u) {
                        } else {
                            return;
                        }
                        let _e497 = local_3.first[(0u + _e492)];
                        local_3.group = _e497;
                        let _e500 = local_3.len;
                        if (_e500 < 32u) {
                        } else {
                            return;
                        }
                        let _e505 = local_3.mask[(0u + _e500)];
                        local_3.group_mask = _e505;
                        phi_1157_ = true;
                    }
                    let _e508 = phi_1157_;
                    phi_1158_ = _e508;
                } else {
                    phi_1158_ = true;
                }
                let _e510 = phi_1158_;
                if _e510 {
                    let _e512 = local_3.group_mask;
                    let _e518 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e512)), 32u, (_e512 == 0u)));
                    let _e522 = local_3.group_mask;
                    let _e536 = local_3.group_mask;
                    local_3.group_mask = (_e536 & ~((1u << bitcast<u32>((_e518 & 31u)))));
                    let _e539 = local_3.group;
                    phi_1189_ = (_e539 + countOneBits(((_e522 & ~((4294967295u << bitcast<u32>((((_e518 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1189_ = 4294967295u;
                }
                let _e542 = phi_1189_;
                phi_1191_ = _e542;
                phi_1194_ = _e182;
                loop {
                    let _e544 = phi_1191_;
                    let _e546 = phi_1194_;
                    local_13 = _e546;
                    let _e547 = (_e544 != 4294967295u);
                    if _e547 {
                        if (_e544 < _e79) {
                        } else {
                            return;
                        }
                        let _e555 = nodes.member[(0u + _e544)].frame[3u];
                        let _e580 = (bitcast<f32>((((_e555 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e326);
                        let _e581 = (bitcast<f32>((((_e555 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e337);
                        let _e582 = (bitcast<f32>((((_e555 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e348);
                        let _e585 = nodes.member[(0u + _e544)].frame[0u];
                        let _e589 = nodes.member[(0u + _e544)].frame[1u];
                        let _e593 = nodes.member[(0u + _e544)].frame[2u];
                        let _e601 = ((bitcast<f32>(_e585) - _e180.origin.x) * _e326);
                        let _e602 = ((bitcast<f32>(_e589) - _e180.origin.y) * _e337);
                        let _e603 = ((bitcast<f32>(_e593) - _e180.origin.z) * _e348);
                        let _e611 = nodes.member[(0u + _e544)].x;
                        if (_e326 < 0f) {
                            let _e622 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e611.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e628 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e622.unnamed.word, _e611.w), _e622.unnamed_1);
                            let _e634 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e628.unnamed, lt_mask_LightPlace(_e611.x, _e628.unnamed_1.shift));
                            phi_1279_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e634.unnamed, lt_mask_LightPlace(_e634.unnamed_1.word, _e611.y));
                        } else {
                            let _e650 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e611.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e656 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e650.unnamed.word, _e611.y), _e650.unnamed_1);
                            let _e662 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e656.unnamed, lt_mask_LightPlace(_e611.z, _e656.unnamed_1.shift));
                            phi_1279_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e662.unnamed, lt_mask_LightPlace(_e662.unnamed_1.word, _e611.w));
                        }
                        let _e670 = phi_1279_;
                        let _e680 = nodes.member[(0u + _e544)].y;
                        if (_e337 < 0f) {
                            let _e691 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e680.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e697 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e691.unnamed.word, _e680.w), _e691.unnamed_1);
                            let _e703 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e697.unnamed, lt_mask_LightPlace(_e680.x, _e697.unnamed_1.shift));
                            phi_1306_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e703.unnamed, lt_mask_LightPlace(_e703.unnamed_1.word, _e680.y));
                        } else {
                            let _e719 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e680.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e725 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e719.unnamed.word, _e680.y), _e719.unnamed_1);
                            let _e731 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e725.unnamed, lt_mask_LightPlace(_e680.z, _e725.unnamed_1.shift));
                            phi_1306_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e731.unnamed, lt_mask_LightPlace(_e731.unnamed_1.word, _e680.w));
                        }
                        let _e739 = phi_1306_;
                        let _e749 = nodes.member[(0u + _e544)].z;
                        if (_e348 < 0f) {
                            let _e760 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e749.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e766 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e760.unnamed.word, _e749.w), _e760.unnamed_1);
                            let _e772 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e766.unnamed, lt_mask_LightPlace(_e749.x, _e766.unnamed_1.shift));
                            phi_1333_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e772.unnamed, lt_mask_LightPlace(_e772.unnamed_1.word, _e749.y));
                        } else {
                            let _e788 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e749.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e794 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e788.unnamed.word, _e749.y), _e788.unnamed_1);
                            let _e800 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e794.unnamed, lt_mask_LightPlace(_e749.z, _e794.unnamed_1.shift));
                            phi_1333_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e800.unnamed, lt_mask_LightPlace(_e800.unnamed_1.word, _e749.w));
                        }
                        let _e808 = phi_1333_;
                        phi_1339_ = 0u;
                        phi_1342_ = 0u;
                        loop {
                            let _e818 = phi_1339_;
                            let _e820 = phi_1342_;
                            local_4 = _e820;
                            local_5 = _e820;
                            local_6 = _e820;
                            let _e821 = (_e818 < 8u);
                            if _e821 {
                                let _e823 = (_e818 >> bitcast<u32>(2i));
                                let _e824 = (_e818 & 3u);
                                if (_e823 == 0u) {
                                    phi_1356_ = _e670.unnamed.word;
                                } else {
                                    phi_1356_ = _e670.unnamed.shift;
                                }
                                let _e827 = phi_1356_;
                                if (_e823 == 0u) {
                                    phi_1366_ = _e739.unnamed.word;
                                } else {
                                    phi_1366_ = _e739.unnamed.shift;
                                }
                                let _e836 = phi_1366_;
                                if (_e823 == 0u) {
                                    phi_1376_ = _e808.unnamed.word;
                                } else {
                                    phi_1376_ = _e808.unnamed.shift;
                                }
                                let _e845 = phi_1376_;
                                let _e858 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e827 >> bitcast<u32>(((_e824 * 8u) & 31u))) & 255u)) * _e580) + (_e601 - _e386)), ((f32(((_e836 >> bitcast<u32>(((_e824 * 8u) & 31u))) & 255u)) * _e581) + (_e602 - _e387)));
                                let _e859 = core_intrinsics_maximum_number_nsz_f32_(_e858, ((f32(((_e845 >> bitcast<u32>(((_e824 * 8u) & 31u))) & 255u)) * _e582) + (_e603 - _e388)));
                                if (_e823 == 0u) {
                                    phi_1394_ = _e670.unnamed_1.word;
                                } else {
                                    phi_1394_ = _e670.unnamed_1.shift;
                                }
                                let _e862 = phi_1394_;
                                if (_e823 == 0u) {
                                    phi_1404_ = _e739.unnamed_1.word;
                                } else {
                                    phi_1404_ = _e739.unnamed_1.shift;
                                }
                                let _e871 = phi_1404_;
                                if (_e823 == 0u) {
                                    phi_1414_ = _e808.unnamed_1.word;
                                } else {
                                    phi_1414_ = _e808.unnamed_1.shift;
                                }
                                let _e880 = phi_1414_;
                                let _e893 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e862 >> bitcast<u32>(((_e824 * 8u) & 31u))) & 255u)) * _e580) + (_e601 + _e386)), ((f32(((_e871 >> bitcast<u32>(((_e824 * 8u) & 31u))) & 255u)) * _e581) + (_e602 + _e387)));
                                let _e894 = core_intrinsics_minimum_number_nsz_f32_(_e893, ((f32(((_e880 >> bitcast<u32>(((_e824 * 8u) & 31u))) & 255u)) * _e582) + (_e603 + _e388)));
                                if (_e859 <= _e894) {
                                    if (_e859 <= _e546.t) {
                                        if (_e894 >= _e180.tmin) {
                                            if (_e823 == 0u) {
                                                let _e901 = nodes.member[(0u + _e544)].links[2u];
                                                phi_1450_ = _e901;
                                            } else {
                                                let _e904 = nodes.member[(0u + _e544)].links[3u];
                                                phi_1450_ = _e904;
                                            }
                                            let _e906 = phi_1450_;
                                            let _e911 = ((_e906 >> bitcast<u32>(((_e824 * 8u) & 31u))) & 255u);
                                            let _e912 = (_e911 & 31u);
                                            if (_e912 >= 24u) {
                                                phi_1463_ = (24u + ((_e912 - 24u) ^ _e406));
                                            } else {
                                                phi_1463_ = _e912;
                                            }
                                            let _e918 = phi_1463_;
                                            phi_1468_ = (_e820 | ((_e911 >> bitcast<u32>(5i)) << bitcast<u32>((_e918 & 31u))));
                                        } else {
                                            phi_1468_ = _e820;
                                        }
                                        let _e926 = phi_1468_;
                                        phi_1469_ = _e926;
                                    } else {
                                        phi_1469_ = _e820;
                                    }
                                    let _e928 = phi_1469_;
                                    phi_1470_ = _e928;
                                } else {
                                    phi_1470_ = _e820;
                                }
                                let _e930 = phi_1470_;
                                phi_1340_ = (_e818 + 1u);
                                phi_1343_ = _e930;
                            } else {
                                phi_1340_ = u32();
                                phi_1343_ = u32();
                            }
                            let _e933 = phi_1340_;
                            let _e935 = phi_1343_;
                            continue;
                            continuing {
                                phi_1339_ = _e933;
                                phi_1342_ = _e935;
                                break if !(_e821);
                            }
                        }
                        let _e939 = nodes.member[(0u + _e544)].links[0u];
                        let _e943 = nodes.member[(0u + _e544)].frame[3u];
                        let _e947 = local_4;
                        if ((_e947 & 4278190080u) == 0u) {
                        } else {
                            let _e951 = local_3.group_mask;
                            if ((_e951 & 4278190080u) == 0u) {
                            } else {
                                let _e955 = local_3.len;
                                if (_e955 < 32u) {
                                    let _e958 = local_3.group;
                                    let _e960 = local_3.len;
                                    if (_e960 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_3.first[(0u + _e960)] = _e958;
                                    let _e966 = local_3.group_mask;
                                    let _e968 = local_3.len;
                                    if (_e968 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_3.mask[(0u + _e968)] = _e966;
                                    let _e975 = local_3.len;
                                    local_3.len = (_e975 + 1u);
                                }
                            }
                            local_3.group = (_e112 + _e939);
                            let _e979 = local_5;
                            local_3.group_mask = ((_e979 & 4278190080u) | (_e943 >> bitcast<u32>(24i)));
                        }
                        let _e984 = local_6;
                        phi_1528_ = (_e984 & 16777215u);
                        phi_1531_ = _e546;
                        loop {
                            let _e987 = phi_1528_;
                            let _e989 = phi_1531_;
                            local_12 = _e989;
                            if (_e987 == 0u) {
                                phi_1529_ = u32();
                                phi_1532_ = lt_bvh_Hit();
                                phi_3418_ = false;
                            } else {
                                let _e993 = nodes.member[(0u + _e544)].links[1u];
                                let _e997 = (_e993 + select(firstTrailingBit(_e987), 32u, (_e987 == 0u)));
                                if (_e997 < _e94) {
                                } else {
                                    return;
                                }
                                let _e1004 = instances.member[(0u + _e997)].low_world;
                                let _e1006 = instances.member[(0u + _e997)].high_world;
                                let _e1016 = ((_e1004.x - _e180.origin.x) * _e326);
                                let _e1017 = ((_e1004.y - _e180.origin.y) * _e337);
                                let _e1018 = ((_e1004.z - _e180.origin.z) * _e348);
                                let _e1028 = ((_e1006.x - _e180.origin.x) * _e326);
                                let _e1029 = ((_e1006.y - _e180.origin.y) * _e337);
                                let _e1030 = ((_e1006.z - _e180.origin.z) * _e348);
                                if (_e1016 < _e1028) {
                                    phi_1586_ = _e1016;
                                } else {
                                    phi_1586_ = _e1028;
                                }
                                let _e1033 = phi_1586_;
                                if (_e1017 < _e1029) {
                                    phi_1591_ = _e1017;
                                } else {
                                    phi_1591_ = _e1029;
                                }
                                let _e1036 = phi_1591_;
                                if (_e1018 < _e1030) {
                                    phi_1596_ = _e1018;
                                } else {
                                    phi_1596_ = _e1030;
                                }
                                let _e1039 = phi_1596_;
                                if (_e1016 > _e1028) {
                                    phi_1604_ = _e1016;
                                } else {
                                    phi_1604_ = _e1028;
                                }
                                let _e1045 = phi_1604_;
                                if (_e1017 > _e1029) {
                                    phi_1609_ = _e1017;
                                } else {
                                    phi_1609_ = _e1029;
                                }
                                let _e1048 = phi_1609_;
                                if (_e1018 > _e1030) {
                                    phi_1614_ = _e1018;
                                } else {
                                    phi_1614_ = _e1030;
                                }
                                let _e1051 = phi_1614_;
                                let _e1055 = core_intrinsics_maximum_number_nsz_f32_((_e1033 - _e393), (_e1036 - _e394));
                                let _e1056 = core_intrinsics_maximum_number_nsz_f32_(_e1055, (_e1039 - _e395));
                                let _e1057 = core_intrinsics_minimum_number_nsz_f32_((_e1045 + _e393), (_e1048 + _e394));
                                let _e1058 = core_intrinsics_minimum_number_nsz_f32_(_e1057, (_e1051 + _e395));
                                if (_e1056 <= _e1058) {
                                    if (_e1056 <= _e989.t) {
                                        if (_e1058 >= _e180.tmin) {
                                            let _e1070 = instances.member[(0u + _e997)].world_to_object[0u];
                                            let _e1081 = ((((_e1070.x * _e180.origin.x) + (_e1070.y * _e180.origin.y)) + (_e1070.z * _e180.origin.z)) + (_e1070.w * 1f));
                                            let _e1083 = instances.member[(0u + _e997)].world_to_object[1u];
                                            let _e1094 = ((((_e1083.x * _e180.origin.x) + (_e1083.y * _e180.origin.y)) + (_e1083.z * _e180.origin.z)) + (_e1083.w * 1f));
                                            let _e1096 = instances.member[(0u + _e997)].world_to_object[2u];
                                            let _e1107 = ((((_e1096.x * _e180.origin.x) + (_e1096.y * _e180.origin.y)) + (_e1096.z * _e180.origin.z)) + (_e1096.w * 1f));
                                            let _e1114 = instances.member[(0u + _e997)].world_to_object[0u];
                                            let _e1125 = ((((_e1114.x * _e180.direction.x) + (_e1114.y * _e180.direction.y)) + (_e1114.z * _e180.direction.z)) + (_e1114.w * 0f));
                                            let _e1127 = instances.member[(0u + _e997)].world_to_object[1u];
                                            let _e1138 = ((((_e1127.x * _e180.direction.x) + (_e1127.y * _e180.direction.y)) + (_e1127.z * _e180.direction.z)) + (_e1127.w * 0f));
                                            let _e1140 = instances.member[(0u + _e997)].world_to_object[2u];
                                            let _e1151 = ((((_e1140.x * _e180.direction.x) + (_e1140.y * _e180.direction.y)) + (_e1140.z * _e180.direction.z)) + (_e1140.w * 0f));
                                            let _e1156 = instances.member[(0u + _e997)].root;
                                            let _e1158 = instances.member[(0u + _e997)].first_triangle;
                                            let _e1159 = abs(_e1125);
                                            let _e1160 = abs(_e1138);
                                            let _e1161 = abs(_e1151);
                                            if (abs(_e1081) < 1000000000000000f) {
                                                if (abs(_e1094) < 1000000000000000f) {
                                                    phi_1746_ = (abs(_e1107) < 1000000000000000f);
                                                    phi_1747_ = false;
                                                } else {
                                                    phi_1746_ = bool();
                                                    phi_1747_ = true;
                                                }
                                                let _e1169 = phi_1746_;
                                                let _e1171 = phi_1747_;
                                                phi_1748_ = _e1169;
                                                phi_1749_ = _e1171;
                                            } else {
                                                phi_1748_ = bool();
                                                phi_1749_ = true;
                                            }
                                            let _e1173 = phi_1748_;
                                            let _e1175 = phi_1749_;
                                            if _e1175 {
                                                phi_1753_ = false;
                                            } else {
                                                phi_1753_ = _e1173;
                                            }
                                            let _e1177 = phi_1753_;
                                            if _e1177 {
                                                if (_e1159 < 1000000000000000f) {
                                                    if (_e1160 < 1000000000000000f) {
                                                        phi_1766_ = (_e1161 < 1000000000000000f);
                                                        phi_1767_ = false;
                                                    } else {
                                                        phi_1766_ = bool();
                                                        phi_1767_ = true;
                                                    }
                                                    let _e1182 = phi_1766_;
                                                    let _e1184 = phi_1767_;
                                                    phi_1768_ = _e1182;
                                                    phi_1769_ = _e1184;
                                                } else {
                                                    phi_1768_ = bool();
                                                    phi_1769_ = true;
                                                }
                                                let _e1186 = phi_1768_;
                                                let _e1188 = phi_1769_;
                                                if _e1188 {
                                                    phi_1773_ = false;
                                                } else {
                                                    phi_1773_ = _e1186;
                                                }
                                                let _e1190 = phi_1773_;
                                                if _e1190 {
                                                    if (_e1159 > 0f) {
                                                        phi_1787_ = bool();
                                                        phi_1788_ = true;
                                                    } else {
                                                        let _e1192 = (_e1160 > 0f);
                                                        if _e1192 {
                                                            phi_1786_ = bool();
                                                        } else {
                                                            phi_1786_ = (_e1161 > 0f);
                                                        }
                                                        let _e1195 = phi_1786_;
                                                        phi_1787_ = _e1195;
                                                        phi_1788_ = _e1192;
                                                    }
                                                    let _e1197 = phi_1787_;
                                                    let _e1199 = phi_1788_;
                                                    if _e1199 {
                                                        phi_1792_ = true;
                                                    } else {
                                                        phi_1792_ = _e1197;
                                                    }
                                                    let _e1201 = phi_1792_;
                                                    phi_1793_ = _e1201;
                                                    phi_1794_ = false;
                                                } else {
                                                    phi_1793_ = bool();
                                                    phi_1794_ = true;
                                                }
                                                let _e1203 = phi_1793_;
                                                let _e1205 = phi_1794_;
                                                phi_1795_ = _e1203;
                                                phi_1796_ = _e1205;
                                            } else {
                                                phi_1795_ = bool();
                                                phi_1796_ = true;
                                            }
                                            let _e1207 = phi_1795_;
                                            let _e1209 = phi_1796_;
                                            if _e1209 {
                                                phi_1800_ = false;
                                            } else {
                                                phi_1800_ = _e1207;
                                            }
                                            let _e1211 = phi_1800_;
                                            if _e1211 {
                                                let _e1212 = (_e1156 >= _e79);
                                                if _e1212 {
                                                    phi_3408_ = lt_bvh_Hit();
                                                } else {
                                                    if (_e1156 < _e79) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1218 = nodes.member[(0u + _e1156)].frame[0u];
                                                    let _e1222 = nodes.member[(0u + _e1156)].frame[1u];
                                                    let _e1226 = nodes.member[(0u + _e1156)].frame[2u];
                                                    let _e1230 = nodes.member[(0u + _e1156)].frame[0u];
                                                    let _e1234 = nodes.member[(0u + _e1156)].frame[1u];
                                                    let _e1238 = nodes.member[(0u + _e1156)].frame[2u];
                                                    let _e1242 = nodes.member[(0u + _e1156)].frame[3u];
                                                    let _e1276 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1125), abs(_e1138));
                                                    let _e1277 = core_intrinsics_maximum_number_nsz_f32_(_e1276, abs(_e1151));
                                                    let _e1278 = (_e1277 * 0.0000000000009094947f);
                                                    if (abs(_e1125) < _e1278) {
                                                        phi_1870_ = _e1278;
                                                    } else {
                                                        phi_1870_ = abs(_e1125);
                                                    }
                                                    let _e1283 = phi_1870_;
                                                    if (_e1125 < 0f) {
                                                        phi_1877_ = (-1f / _e1283);
                                                    } else {
                                                        phi_1877_ = (1f / _e1283);
                                                    }
                                                    let _e1288 = phi_1877_;
                                                    if (abs(_e1138) < _e1278) {
                                                        phi_1884_ = _e1278;
                                                    } else {
                                                        phi_1884_ = abs(_e1138);
                                                    }
                                                    let _e1293 = phi_1884_;
                                                    if (_e1138 < 0f) {
                                                        phi_1891_ = (-1f / _e1293);
                                                    } else {
                                                        phi_1891_ = (1f / _e1293);
                                                    }
                                                    let _e1298 = phi_1891_;
                                                    if (abs(_e1151) < _e1278) {
                                                        phi_1898_ = _e1278;
                                                    } else {
                                                        phi_1898_ = abs(_e1151);
                                                    }
                                                    let _e1303 = phi_1898_;
                                                    if (_e1151 < 0f) {
                                                        phi_1905_ = (-1f / _e1303);
                                                    } else {
                                                        phi_1905_ = (1f / _e1303);
                                                    }
                                                    let _e1308 = phi_1905_;
                                                    let _e1312 = abs((bitcast<f32>(_e1218) - _e1081));
                                                    let _e1313 = abs((bitcast<f32>(_e1222) - _e1094));
                                                    let _e1314 = abs((bitcast<f32>(_e1226) - _e1107));
                                                    let _e1318 = abs(((bitcast<f32>(_e1230) + (bitcast<f32>((((_e1242 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1081));
                                                    let _e1319 = abs(((bitcast<f32>(_e1234) + (bitcast<f32>((((_e1242 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1094));
                                                    let _e1320 = abs(((bitcast<f32>(_e1238) + (bitcast<f32>((((_e1242 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1107));
                                                    if (_e1312 > _e1318) {
                                                        phi_1922_ = _e1312;
                                                    } else {
                                                        phi_1922_ = _e1318;
                                                    }
                                                    let _e1323 = phi_1922_;
                                                    if (_e1313 > _e1319) {
                                                        phi_1927_ = _e1313;
                                                    } else {
                                                        phi_1927_ = _e1319;
                                                    }
                                                    let _e1326 = phi_1927_;
                                                    if (_e1314 > _e1320) {
                                                        phi_1932_ = _e1314;
                                                    } else {
                                                        phi_1932_ = _e1320;
                                                    }
                                                    let _e1329 = phi_1932_;
                                                    if (_e1323 > _e1326) {
                                                        phi_1937_ = _e1323;
                                                    } else {
                                                        phi_1937_ = _e1326;
                                                    }
                                                    let _e1332 = phi_1937_;
                                                    if (_e1332 > _e1329) {
                                                        phi_1942_ = _e1332;
                                                    } else {
                                                        phi_1942_ = _e1329;
                                                    }
                                                    let _e1335 = phi_1942_;
                                                    let _e1339 = (_e1335 * 0.0000019073486f);
                                                    let _e1340 = (abs(_e1288) * _e1339);
                                                    let _e1341 = (abs(_e1298) * _e1339);
                                                    let _e1342 = (abs(_e1308) * _e1339);
                                                    let _e1346 = (_e1335 * 0.0000009536743f);
                                                    let _e1347 = (abs(_e1288) * _e1346);
                                                    let _e1348 = (abs(_e1298) * _e1346);
                                                    let _e1349 = (abs(_e1308) * _e1346);
                                                    let _e1350 = abs(_e1125);
                                                    let _e1351 = abs(_e1138);
                                                    let _e1352 = abs(_e1151);
                                                    if (_e1350 >= _e1351) {
                                                        if (_e1350 >= _e1352) {
                                                            phi_1968_ = false;
                                                        } else {
                                                            phi_1968_ = true;
                                                        }
                                                        let _e1356 = phi_1968_;
                                                        phi_1969_ = _e1356;
                                                    } else {
                                                        phi_1969_ = true;
                                                    }
                                                    let _e1358 = phi_1969_;
                                                    if _e1358 {
                                                        if (_e1351 >= _e1352) {
                                                            phi_1977_ = 1u;
                                                        } else {
                                                            phi_1977_ = 2u;
                                                        }
                                                        let _e1361 = phi_1977_;
                                                        phi_1978_ = _e1361;
                                                    } else {
                                                        phi_1978_ = 0u;
                                                    }
                                                    let _e1363 = phi_1978_;
                                                    if (_e1363 == 0u) {
                                                        phi_1990_ = vec3<f32>(_e1138, _e1151, _e1125);
                                                    } else {
                                                        if (_e1363 == 1u) {
                                                            phi_1989_ = vec3<f32>(_e1151, _e1125, _e1138);
                                                        } else {
                                                            phi_1989_ = vec3<f32>(_e1125, _e1138, _e1151);
                                                        }
                                                        let _e1369 = phi_1989_;
                                                        phi_1990_ = _e1369;
                                                    }
                                                    let _e1371 = phi_1990_;
                                                    let _e1374 = (_e1371.x / _e1371.z);
                                                    let _e1377 = (_e1371.y / _e1371.z);
                                                    if (_e1288 < 0f) {
                                                        phi_2003_ = 0u;
                                                    } else {
                                                        phi_2003_ = 1u;
                                                    }
                                                    let _e1382 = phi_2003_;
                                                    if (_e1298 < 0f) {
                                                        phi_2008_ = 0u;
                                                    } else {
                                                        phi_2008_ = 2u;
                                                    }
                                                    let _e1385 = phi_2008_;
                                                    if (_e1308 < 0f) {
                                                        phi_2013_ = 0u;
                                                    } else {
                                                        phi_2013_ = 4u;
                                                    }
                                                    let _e1388 = phi_2013_;
                                                    let _e1390 = ((_e1382 | _e1385) | _e1388);
                                                    let _e1391 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1156, 2147483648u);
                                                    local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e1391.first[0], _e1391.first[1], _e1391.first[2], _e1391.first[3], _e1391.first[4], _e1391.first[5], _e1391.first[6], _e1391.first[7], _e1391.first[8], _e1391.first[9], _e1391.first[10], _e1391.first[11], _e1391.first[12], _e1391.first[13], _e1391.first[14], _e1391.first[15], _e1391.first[16], _e1391.first[17], _e1391.first[18], _e1391.first[19], _e1391.first[20], _e1391.first[21], _e1391.first[22], _e1391.first[23], _e1391.first[24], _e1391.first[25], _e1391.first[26], _e1391.first[27], _e1391.first[28], _e1391.first[29], _e1391.first[30], _e1391.first[31]), array<u32, 32>(_e1391.mask[0], _e1391.mask[1], _e1391.mask[2], _e1391.mask[3], _e1391.mask[4], _e1391.mask[5], _e1391.mask[6], _e1391.mask[7], _e1391.mask[8], _e1391.mask[9], _e1391.mask[10], _e1391.mask[11], _e1391.mask[12], _e1391.mask[13], _e1391.mask[14], _e1391.mask[15], _e1391.mask[16], _e1391.mask[17], _e1391.mask[18], _e1391.mask[19], _e1391.mask[20], _e1391.mask[21], _e1391.mask[22], _e1391.mask[23], _e1391.mask[24], _e1391.mask[25], _e1391.mask[26], _e1391.mask[27], _e1391.mask[28], _e1391.mask[29], _e1391.mask[30], _e1391.mask[31]), _e1391.len, _e1391.group, _e1391.group_mask);
                                                    let _e1465 = local_2.group_mask;
                                                    if ((_e1465 & 4278190080u) == 0u) {
                                                        let _e1469 = local_2.len;
                                                        if (_e1469 == 0u) {
                                                            phi_2127_ = false;
                                                        } else {
                                                            let _e1473 = local_2.len;
                                                            local_2.len = (_e1473 - 1u);
                                                            let _e1476 = local_2.len;
                                                            if (_e1476 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1481 = local_2.first[(0u + _e1476)];
                                                            local_2.group = _e1481;
                                                            let _e1484 = local_2.len;
                                                            if (_e1484 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1489 = local_2.mask[(0u + _e1484)];
                                                            local_2.group_mask = _e1489;
                                                            phi_2127_ = true;
                                                        }
                                                        let _e1492 = phi_2127_;
                                                        phi_2128_ = _e1492;
                                                    } else {
                                                        phi_2128_ = true;
                                                    }
                                                    let _e1494 = phi_2128_;
                                                    if _e1494 {
                                                        let _e1496 = local_2.group_mask;
                                                        let _e1502 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1496)), 32u, (_e1496 == 0u)));
                                                        let _e1506 = local_2.group_mask;
                                                        let _e1520 = local_2.group_mask;
                                                        local_2.group_mask = (_e1520 & ~((1u << bitcast<u32>((_e1502 & 31u)))));
                                                        let _e1523 = local_2.group;
                                                        phi_2159_ = (_e1523 + countOneBits(((_e1506 & ~((4294967295u << bitcast<u32>((((_e1502 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_2159_ = 4294967295u;
                                                    }
                                                    let _e1526 = phi_2159_;
                                                    phi_2161_ = _e989;
                                                    phi_2164_ = _e1526;
                                                    loop {
                                                        let _e1528 = phi_2161_;
                                                        let _e1530 = phi_2164_;
                                                        local_11 = _e1528;
                                                        let _e1531 = (_e1530 != 4294967295u);
                                                        if _e1531 {
                                                            if (_e1530 < _e79) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1538 = nodes.member[(0u + _e1530)].frame[3u];
                                                            let _e1563 = (bitcast<f32>((((_e1538 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1288);
                                                            let _e1564 = (bitcast<f32>((((_e1538 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1298);
                                                            let _e1565 = (bitcast<f32>((((_e1538 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1308);
                                                            let _e1568 = nodes.member[(0u + _e1530)].frame[0u];
                                                            let _e1572 = nodes.member[(0u + _e1530)].frame[1u];
                                                            let _e1576 = nodes.member[(0u + _e1530)].frame[2u];
                                                            let _e1581 = ((bitcast<f32>(_e1568) - _e1081) * _e1288);
                                                            let _e1582 = ((bitcast<f32>(_e1572) - _e1094) * _e1298);
                                                            let _e1583 = ((bitcast<f32>(_e1576) - _e1107) * _e1308);
                                                            let _e1591 = nodes.member[(0u + _e1530)].x;
                                                            if (_e1288 < 0f) {
                                                                let _e1602 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1591.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1608 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1602.unnamed.word, _e1591.w), _e1602.unnamed_1);
                                                                let _e1614 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1608.unnamed, lt_mask_LightPlace(_e1591.x, _e1608.unnamed_1.shift));
                                                                phi_2245_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1614.unnamed, lt_mask_LightPlace(_e1614.unnamed_1.word, _e1591.y));
                                                            } else {
                                                                let _e1630 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1591.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1636 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1630.unnamed.word, _e1591.y), _e1630.unnamed_1);
                                                                let _e1642 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1636.unnamed, lt_mask_LightPlace(_e1591.z, _e1636.unnamed_1.shift));
                                                                phi_2245_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1642.unnamed, lt_mask_LightPlace(_e1642.unnamed_1.word, _e1591.w));
                                                            }
                                                            let _e1650 = phi_2245_;
                                                            let _e1660 = nodes.member[(0u + _e1530)].y;
                                                            if (_e1298 < 0f) {
                                                                let _e1671 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1660.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1677 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1671.unnamed.word, _e1660.w), _e1671.unnamed_1);
                                                                let _e1683 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1677.unnamed, lt_mask_LightPlace(_e1660.x, _e1677.unnamed_1.shift));
                                                                phi_2272_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1683.unnamed, lt_mask_LightPlace(_e1683.unnamed_1.word, _e1660.y));
                                                            } else {
                                                                let _e1699 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1660.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1705 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1699.unnamed.word, _e1660.y), _e1699.unnamed_1);
                                                                let _e1711 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1705.unnamed, lt_mask_LightPlace(_e1660.z, _e1705.unnamed_1.shift));
                                                                phi_2272_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1711.unnamed, lt_mask_LightPlace(_e1711.unnamed_1.word, _e1660.w));
                                                            }
                                                            let _e1719 = phi_2272_;
                                                            let _e1729 = nodes.member[(0u + _e1530)].z;
                                                            if (_e1308 < 0f) {
                                                                let _e1740 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1729.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1746 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1740.unnamed.word, _e1729.w), _e1740.unnamed_1);
                                                                let _e1752 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1746.unnamed, lt_mask_LightPlace(_e1729.x, _e1746.unnamed_1.shift));
                                                                phi_2299_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1752.unnamed, lt_mask_LightPlace(_e1752.unnamed_1.word, _e1729.y));
                                                            } else {
                                                                let _e1768 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1729.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1774 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1768.unnamed.word, _e1729.y), _e1768.unnamed_1);
                                                                let _e1780 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1774.unnamed, lt_mask_LightPlace(_e1729.z, _e1774.unnamed_1.shift));
                                                                phi_2299_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1780.unnamed, lt_mask_LightPlace(_e1780.unnamed_1.word, _e1729.w));
                                                            }
                                                            let _e1788 = phi_2299_;
                                                            phi_2305_ = 0u;
                                                            phi_2308_ = 0u;
                                                            loop {
                                                                let _e1798 = phi_2305_;
                                                                let _e1800 = phi_2308_;
                                                                local_7 = _e1800;
                                                                local_8 = _e1800;
                                                                local_9 = _e1800;
                                                                let _e1801 = (_e1798 < 8u);
                                                                if _e1801 {
                                                                    let _e1803 = (_e1798 >> bitcast<u32>(2i));
                                                                    let _e1804 = (_e1798 & 3u);
                                                                    if (_e1803 == 0u) {
                                                                        phi_2322_ = _e1650.unnamed.word;
                                                                    } else {
                                                                        phi_2322_ = _e1650.unnamed.shift;
                                                                    }
                                                                    let _e1807 = phi_2322_;
                                                                    if (_e1803 == 0u) {
                                                                        phi_2332_ = _e1719.unnamed.word;
                                                                    } else {
                                                                        phi_2332_ = _e1719.unnamed.shift;
                                                                    }
                                                                    let _e1816 = phi_2332_;
                                                                    if (_e1803 == 0u) {
                                                                        phi_2342_ = _e1788.unnamed.word;
                                                                    } else {
                                                                        phi_2342_ = _e1788.unnamed.shift;
                                                                    }
                                                                    let _e1825 = phi_2342_;
                                                                    let _e1838 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1807 >> bitcast<u32>(((_e1804 * 8u) & 31u))) & 255u)) * _e1563) + (_e1581 - _e1340)), ((f32(((_e1816 >> bitcast<u32>(((_e1804 * 8u) & 31u))) & 255u)) * _e1564) + (_e1582 - _e1341)));
                                                                    let _e1839 = core_intrinsics_maximum_number_nsz_f32_(_e1838, ((f32(((_e1825 >> bitcast<u32>(((_e1804 * 8u) & 31u))) & 255u)) * _e1565) + (_e1583 - _e1342)));
                                                                    if (_e1803 == 0u) {
                                                                        phi_2360_ = _e1650.unnamed_1.word;
                                                                    } else {
                                                                        phi_2360_ = _e1650.unnamed_1.shift;
                                                                    }
                                                                    let _e1842 = phi_2360_;
                                                                    if (_e1803 == 0u) {
                                                                        phi_2370_ = _e1719.unnamed_1.word;
                                                                    } else {
                                                                        phi_2370_ = _e1719.unnamed_1.shift;
                                                                    }
                                                                    let _e1851 = phi_2370_;
                                                                    if (_e1803 == 0u) {
                                                                        phi_2380_ = _e1788.unnamed_1.word;
                                                                    } else {
                                                                        phi_2380_ = _e1788.unnamed_1.shift;
                                                                    }
                                                                    let _e1860 = phi_2380_;
                                                                    let _e1873 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1842 >> bitcast<u32>(((_e1804 * 8u) & 31u))) & 255u)) * _e1563) + (_e1581 + _e1340)), ((f32(((_e1851 >> bitcast<u32>(((_e1804 * 8u) & 31u))) & 255u)) * _e1564) + (_e1582 + _e1341)));
                                                                    let _e1874 = core_intrinsics_minimum_number_nsz_f32_(_e1873, ((f32(((_e1860 >> bitcast<u32>(((_e1804 * 8u) & 31u))) & 255u)) * _e1565) + (_e1583 + _e1342)));
                                                                    if (_e1839 <= _e1874) {
                                                                        if (_e1839 <= _e1528.t) {
                                                                            if (_e1874 >= _e180.tmin) {
                                                                                if (_e1803 == 0u) {
                                                                                    let _e1881 = nodes.member[(0u + _e1530)].links[2u];
                                                                                    phi_2416_ = _e1881;
                                                                                } else {
                                                                                    let _e1884 = nodes.member[(0u + _e1530)].links[3u];
                                                                                    phi_2416_ = _e1884;
                                                                                }
                                                                                let _e1886 = phi_2416_;
                                                                                let _e1891 = ((_e1886 >> bitcast<u32>(((_e1804 * 8u) & 31u))) & 255u);
                                                                                let _e1892 = (_e1891 & 31u);
                                                                                if (_e1892 >= 24u) {
                                                                                    phi_2429_ = (24u + ((_e1892 - 24u) ^ _e1390));
                                                                                } else {
                                                                                    phi_2429_ = _e1892;
                                                                                }
                                                                                let _e1898 = phi_2429_;
                                                                                phi_2434_ = (_e1800 | ((_e1891 >> bitcast<u32>(5i)) << bitcast<u32>((_e1898 & 31u))));
                                                                            } else {
                                                                                phi_2434_ = _e1800;
                                                                            }
                                                                            let _e1906 = phi_2434_;
                                                                            phi_2435_ = _e1906;
                                                                        } else {
                                                                            phi_2435_ = _e1800;
                                                                        }
                                                                        let _e1908 = phi_2435_;
                                                                        phi_2436_ = _e1908;
                                                                    } else {
                                                                        phi_2436_ = _e1800;
                                                                    }
                                                                    let _e1910 = phi_2436_;
                                                                    phi_2306_ = (_e1798 + 1u);
                                                                    phi_2309_ = _e1910;
                                                                } else {
                                                                    phi_2306_ = u32();
                                                                    phi_2309_ = u32();
                                                                }
                                                                let _e1913 = phi_2306_;
                                                                let _e1915 = phi_2309_;
                                                                continue;
                                                                continuing {
                                                                    phi_2305_ = _e1913;
                                                                    phi_2308_ = _e1915;
                                                                    break if !(_e1801);
                                                                }
                                                            }
                                                            let _e1919 = nodes.member[(0u + _e1530)].links[0u];
                                                            let _e1923 = nodes.member[(0u + _e1530)].frame[3u];
                                                            let _e1927 = local_7;
                                                            if ((_e1927 & 4278190080u) == 0u) {
                                                            } else {
                                                                let _e1931 = local_2.group_mask;
                                                                if ((_e1931 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1935 = local_2.len;
                                                                    if (_e1935 < 32u) {
                                                                        let _e1938 = local_2.group;
                                                                        let _e1940 = local_2.len;
                                                                        if (_e1940 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_2.first[(0u + _e1940)] = _e1938;
                                                                        let _e1946 = local_2.group_mask;
                                                                        let _e1948 = local_2.len;
                                                                        if (_e1948 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_2.mask[(0u + _e1948)] = _e1946;
                                                                        let _e1955 = local_2.len;
                                                                        local_2.len = (_e1955 + 1u);
                                                                    }
                                                                }
                                                                local_2.group = (_e1156 + _e1919);
                                                                let _e1959 = local_8;
                                                                local_2.group_mask = ((_e1959 & 4278190080u) | (_e1923 >> bitcast<u32>(24i)));
                                                            }
                                                            let _e1964 = local_9;
                                                            phi_2494_ = _e1528;
                                                            phi_2497_ = (_e1964 & 16777215u);
                                                            loop {
                                                                let _e1967 = phi_2494_;
                                                                let _e1969 = phi_2497_;
                                                                local_10 = _e1967;
                                                                if (_e1969 == 0u) {
                                                                    phi_2495_ = lt_bvh_Hit();
                                                                    phi_2498_ = u32();
                                                                    phi_3336_ = false;
                                                                } else {
                                                                    let _e1973 = nodes.member[(0u + _e1530)].links[1u];
                                                                    let _e1978 = ((_e1158 + _e1973) + select(firstTrailingBit(_e1969), 32u, (_e1969 == 0u)));
                                                                    if (_e1978 < _e82) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1985 = triangles.member[(0u + _e1978)].v0_;
                                                                    let _e1987 = (_e1985.x - _e1081);
                                                                    let _e1989 = (_e1985.y - _e1094);
                                                                    let _e1991 = (_e1985.z - _e1107);
                                                                    if (_e1363 == 0u) {
                                                                        phi_2542_ = vec3<f32>(_e1989, _e1991, _e1987);
                                                                    } else {
                                                                        if (_e1363 == 1u) {
                                                                            phi_2541_ = vec3<f32>(_e1991, _e1987, _e1989);
                                                                        } else {
                                                                            phi_2541_ = (_e1985 - vec3<f32>(_e1081, _e1094, _e1107));
                                                                        }
                                                                        let _e1999 = phi_2541_;
                                                                        phi_2542_ = _e1999;
                                                                    }
                                                                    let _e2001 = phi_2542_;
                                                                    let _e2005 = (_e2001.x - (_e1374 * _e2001.z));
                                                                    let _e2009 = (_e2001.y - (_e1377 * _e2001.z));
                                                                    let _e2011 = triangles.member[(0u + _e1978)].v1_;
                                                                    let _e2013 = (_e2011.x - _e1081);
                                                                    let _e2015 = (_e2011.y - _e1094);
                                                                    let _e2017 = (_e2011.z - _e1107);
                                                                    if (_e1363 == 0u) {
                                                                        phi_2572_ = vec3<f32>(_e2015, _e2017, _e2013);
                                                                    } else {
                                                                        if (_e1363 == 1u) {
                                                                            phi_2571_ = vec3<f32>(_e2017, _e2013, _e2015);
                                                                        } else {
                                                                            phi_2571_ = (_e2011 - vec3<f32>(_e1081, _e1094, _e1107));
                                                                        }
                                                                        let _e2025 = phi_2571_;
                                                                        phi_2572_ = _e2025;
                                                                    }
                                                                    let _e2027 = phi_2572_;
                                                                    let _e2031 = (_e2027.x - (_e1374 * _e2027.z));
                                                                    let _e2035 = (_e2027.y - (_e1377 * _e2027.z));
                                                                    let _e2037 = triangles.member[(0u + _e1978)].v2_;
                                                                    let _e2039 = (_e2037.x - _e1081);
                                                                    let _e2041 = (_e2037.y - _e1094);
                                                                    let _e2043 = (_e2037.z - _e1107);
                                                                    if (_e1363 == 0u) {
                                                                        phi_2602_ = vec3<f32>(_e2041, _e2043, _e2039);
                                                                    } else {
                                                                        if (_e1363 == 1u) {
                                                                            phi_2601_ = vec3<f32>(_e2043, _e2039, _e2041);
                                                                        } else {
                                                                            phi_2601_ = (_e2037 - vec3<f32>(_e1081, _e1094, _e1107));
                                                                        }
                                                                        let _e2051 = phi_2601_;
                                                                        phi_2602_ = _e2051;
                                                                    }
                                                                    let _e2053 = phi_2602_;
                                                                    let _e2057 = (_e2053.x - (_e1374 * _e2053.z));
                                                                    let _e2061 = (_e2053.y - (_e1377 * _e2053.z));
                                                                    if (_e2031 < _e2057) {
                                                                        phi_2621_ = true;
                                                                    } else {
                                                                        if (_e2031 == _e2057) {
                                                                            phi_2620_ = (_e2035 < _e2061);
                                                                        } else {
                                                                            phi_2620_ = false;
                                                                        }
                                                                        let _e2066 = phi_2620_;
                                                                        phi_2621_ = _e2066;
                                                                    }
                                                                    let _e2068 = phi_2621_;
                                                                    if _e2068 {
                                                                        phi_2625_ = _e2061;
                                                                        phi_2626_ = _e2057;
                                                                        phi_2627_ = _e2035;
                                                                        phi_2628_ = _e2031;
                                                                    } else {
                                                                        phi_2625_ = _e2035;
                                                                        phi_2626_ = _e2031;
                                                                        phi_2627_ = _e2061;
                                                                        phi_2628_ = _e2057;
                                                                    }
                                                                    let _e2070 = phi_2625_;
                                                                    let _e2072 = phi_2626_;
                                                                    let _e2074 = phi_2627_;
                                                                    let _e2076 = phi_2628_;
                                                                    let _e2079 = ((_e2076 * _e2070) - (_e2074 * _e2072));
                                                                    if _e2068 {
                                                                        phi_2636_ = -(_e2079);
                                                                    } else {
                                                                        phi_2636_ = _e2079;
                                                                    }
                                                                    let _e2082 = phi_2636_;
                                                                    if (_e2057 < _e2005) {
                                                                        phi_2647_ = true;
                                                                    } else {
                                                                        if (_e2057 == _e2005) {
                                                                            phi_2646_ = (_e2061 < _e2009);
                                                                        } else {
                                                                            phi_2646_ = false;
                                                                        }
                                                                        let _e2087 = phi_2646_;
                                                                        phi_2647_ = _e2087;
                                                                    }
                                                                    let _e2089 = phi_2647_;
                                                                    if _e2089 {
                                                                        phi_2651_ = _e2009;
                                                                        phi_2652_ = _e2005;
                                                                        phi_2653_ = _e2061;
                                                                        phi_2654_ = _e2057;
                                                                    } else {
                                                                        phi_2651_ = _e2061;
                                                                        phi_2652_ = _e2057;
                                                                        phi_2653_ = _e2009;
                                                                        phi_2654_ = _e2005;
                                                                    }
                                                                    let _e2091 = phi_2651_;
                                                                    let _e2093 = phi_2652_;
                                                                    let _e2095 = phi_2653_;
                                                                    let _e2097 = phi_2654_;
                                                                    let _e2100 = ((_e2097 * _e2091) - (_e2095 * _e2093));
                                                                    if _e2089 {
                                                                        phi_2662_ = -(_e2100);
                                                                    } else {
                                                                        phi_2662_ = _e2100;
                                                                    }
                                                                    let _e2103 = phi_2662_;
                                                                    if (_e2005 < _e2031) {
                                                                        phi_2673_ = true;
                                                                    } else {
                                                                        if (_e2005 == _e2031) {
                                                                            phi_2672_ = (_e2009 < _e2035);
                                                                        } else {
                                                                            phi_2672_ = false;
                                                                        }
                                                                        let _e2108 = phi_2672_;
                                                                        phi_2673_ = _e2108;
                                                                    }
                                                                    let _e2110 = phi_2673_;
                                                                    if _e2110 {
                                                                        phi_2677_ = _e2035;
                                                                        phi_2678_ = _e2031;
                                                                        phi_2679_ = _e2009;
                                                                        phi_2680_ = _e2005;
                                                                    } else {
                                                                        phi_2677_ = _e2009;
                                                                        phi_2678_ = _e2005;
                                                                        phi_2679_ = _e2035;
                                                                        phi_2680_ = _e2031;
                                                                    }
                                                                    let _e2112 = phi_2677_;
                                                                    let _e2114 = phi_2678_;
                                                                    let _e2116 = phi_2679_;
                                                                    let _e2118 = phi_2680_;
                                                                    let _e2121 = ((_e2118 * _e2112) - (_e2116 * _e2114));
                                                                    if _e2110 {
                                                                        phi_2688_ = -(_e2121);
                                                                    } else {
                                                                        phi_2688_ = _e2121;
                                                                    }
                                                                    let _e2124 = phi_2688_;
                                                                    if (_e2082 >= 0f) {
                                                                        if (_e2103 >= 0f) {
                                                                            if (_e2124 >= 0f) {
                                                                                phi_2703_ = ((_e2082 + _e2103) + _e2124);
                                                                                phi_2704_ = false;
                                                                            } else {
                                                                                phi_2703_ = f32();
                                                                                phi_2704_ = true;
                                                                            }
                                                                            let _e2131 = phi_2703_;
                                                                            let _e2133 = phi_2704_;
                                                                            phi_2705_ = _e2131;
                                                                            phi_2706_ = _e2133;
                                                                        } else {
                                                                            phi_2705_ = f32();
                                                                            phi_2706_ = true;
                                                                        }
                                                                        let _e2135 = phi_2705_;
                                                                        let _e2137 = phi_2706_;
                                                                        phi_2707_ = _e2135;
                                                                        phi_2708_ = _e2137;
                                                                    } else {
                                                                        phi_2707_ = f32();
                                                                        phi_2708_ = true;
                                                                    }
                                                                    let _e2139 = phi_2707_;
                                                                    let _e2141 = phi_2708_;
                                                                    if _e2141 {
                                                                        if (_e2082 <= 0f) {
                                                                            if (_e2103 <= 0f) {
                                                                                let _e2144 = (_e2124 <= 0f);
                                                                                if _e2144 {
                                                                                }
                                                                                phi_2726_ = ((_e2082 + _e2103) + _e2124);
                                                                                phi_2727_ = false;
                                                                                phi_2728_ = _e2144;
                                                                            } else {
                                                                                phi_2726_ = f32();
                                                                                phi_2727_ = true;
                                                                                phi_2728_ = false;
                                                                            }
                                                                            let _e2148 = phi_2726_;
                                                                            let _e2150 = phi_2727_;
                                                                            let _e2152 = phi_2728_;
                                                                            phi_2729_ = _e2148;
                                                                            phi_2730_ = _e2150;
                                                                            phi_2731_ = _e2152;
                                                                        } else {
                                                                            phi_2729_ = f32();
                                                                            phi_2730_ = true;
                                                                            phi_2731_ = false;
                                                                        }
                                                                        let _e2154 = phi_2729_;
                                                                        let _e2156 = phi_2730_;
                                                                        let _e2158 = phi_2731_;
                                                                        if _e2156 {
                                                                            phi_2735_ = false;
                                                                        } else {
                                                                            phi_2735_ = _e2158;
                                                                        }
                                                                        let _e2160 = phi_2735_;
                                                                        phi_2736_ = _e2154;
                                                                        phi_2737_ = _e2160;
                                                                    } else {
                                                                        phi_2736_ = _e2139;
                                                                        phi_2737_ = true;
                                                                    }
                                                                    let _e2162 = phi_2736_;
                                                                    let _e2164 = phi_2737_;
                                                                    if _e2164 {
                                                                        let _e2165 = (_e2162 == 0f);
                                                                        if _e2165 {
                                                                            phi_3053_ = lt_bvh_triangle_Intersection();
                                                                            phi_3054_ = false;
                                                                        } else {
                                                                            let _e2167 = triangles.member[(0u + _e1978)].v0_;
                                                                            let _e2169 = (_e2167.x - _e1081);
                                                                            let _e2171 = (_e2167.y - _e1094);
                                                                            let _e2173 = (_e2167.z - _e1107);
                                                                            if (_e1363 == 0u) {
                                                                                phi_2766_ = vec3<f32>(_e2171, _e2173, _e2169);
                                                                            } else {
                                                                                if (_e1363 == 1u) {
                                                                                    phi_2765_ = vec3<f32>(_e2173, _e2169, _e2171);
                                                                                } else {
                                                                                    phi_2765_ = (_e2167 - vec3<f32>(_e1081, _e1094, _e1107));
                                                                                }
                                                                                let _e2181 = phi_2765_;
                                                                                phi_2766_ = _e2181;
                                                                            }
                                                                            let _e2183 = phi_2766_;
                                                                            let _e2185 = triangles.member[(0u + _e1978)].v1_;
                                                                            let _e2187 = triangles.member[(0u + _e1978)].v0_;
                                                                            let _e2190 = (_e2185.x - _e2187.x);
                                                                            let _e2193 = (_e2185.y - _e2187.y);
                                                                            let _e2196 = (_e2185.z - _e2187.z);
                                                                            if (_e1363 == 0u) {
                                                                                phi_2792_ = vec3<f32>(_e2193, _e2196, _e2190);
                                                                            } else {
                                                                                if (_e1363 == 1u) {
                                                                                    phi_2791_ = vec3<f32>(_e2196, _e2190, _e2193);
                                                                                } else {
                                                                                    phi_2791_ = (_e2185 - _e2187);
                                                                                }
                                                                                let _e2203 = phi_2791_;
                                                                                phi_2792_ = _e2203;
                                                                            }
                                                                            let _e2205 = phi_2792_;
                                                                            let _e2207 = triangles.member[(0u + _e1978)].v2_;
                                                                            let _e2209 = triangles.member[(0u + _e1978)].v0_;
                                                                            let _e2212 = (_e2207.x - _e2209.x);
                                                                            let _e2215 = (_e2207.y - _e2209.y);
                                                                            let _e2218 = (_e2207.z - _e2209.z);
                                                                            if (_e1363 == 0u) {
                                                                                phi_2818_ = vec3<f32>(_e2215, _e2218, _e2212);
                                                                            } else {
                                                                                if (_e1363 == 1u) {
                                                                                    phi_2817_ = vec3<f32>(_e2218, _e2212, _e2215);
                                                                                } else {
                                                                                    phi_2817_ = (_e2207 - _e2209);
                                                                                }
                                                                                let _e2225 = phi_2817_;
                                                                                phi_2818_ = _e2225;
                                                                            }
                                                                            let _e2227 = phi_2818_;
                                                                            let _e2234 = ((_e2205.y * _e2227.z) - (_e2205.z * _e2227.y));
                                                                            let _e2241 = ((_e2205.z * _e2227.x) - (_e2205.x * _e2227.z));
                                                                            let _e2248 = ((_e2205.x * _e2227.y) - (_e2205.y * _e2227.x));
                                                                            let _e2262 = (((1f / _e1371.z) * (((_e2234 * _e2183.x) + (_e2241 * _e2183.y)) + (_e2248 * _e2183.z))) / (((_e2234 * _e1374) + (_e2241 * _e1377)) + _e2248));
                                                                            if (_e2262 > _e180.tmin) {
                                                                                if (_e2262 < _e180.tmax) {
                                                                                    let _e2266 = triangles.member[(0u + _e1978)].v0_;
                                                                                    let _e2268 = triangles.member[(0u + _e1978)].v1_;
                                                                                    if (_e2266.x < _e2268.x) {
                                                                                        phi_2874_ = _e2266.x;
                                                                                    } else {
                                                                                        phi_2874_ = _e2268.x;
                                                                                    }
                                                                                    let _e2275 = phi_2874_;
                                                                                    if (_e2266.y < _e2268.y) {
                                                                                        phi_2883_ = _e2266.y;
                                                                                    } else {
                                                                                        phi_2883_ = _e2268.y;
                                                                                    }
                                                                                    let _e2282 = phi_2883_;
                                                                                    if (_e2266.z < _e2268.z) {
                                                                                        phi_2892_ = _e2266.z;
                                                                                    } else {
                                                                                        phi_2892_ = _e2268.z;
                                                                                    }
                                                                                    let _e2289 = phi_2892_;
                                                                                    let _e2291 = triangles.member[(0u + _e1978)].v2_;
                                                                                    if (_e2275 < _e2291.x) {
                                                                                        phi_2901_ = _e2275;
                                                                                    } else {
                                                                                        phi_2901_ = _e2291.x;
                                                                                    }
                                                                                    let _e2296 = phi_2901_;
                                                                                    if (_e2282 < _e2291.y) {
                                                                                        phi_2908_ = _e2282;
                                                                                    } else {
                                                                                        phi_2908_ = _e2291.y;
                                                                                    }
                                                                                    let _e2301 = phi_2908_;
                                                                                    if (_e2289 < _e2291.z) {
                                                                                        phi_2915_ = _e2289;
                                                                                    } else {
                                                                                        phi_2915_ = _e2291.z;
                                                                                    }
                                                                                    let _e2306 = phi_2915_;
                                                                                    let _e2308 = triangles.member[(0u + _e1978)].v0_;
                                                                                    let _e2310 = triangles.member[(0u + _e1978)].v1_;
                                                                                    if (_e2308.x > _e2310.x) {
                                                                                        phi_2928_ = _e2308.x;
                                                                                    } else {
                                                                                        phi_2928_ = _e2310.x;
                                                                                    }
                                                                                    let _e2317 = phi_2928_;
                                                                                    if (_e2308.y > _e2310.y) {
                                                                                        phi_2937_ = _e2308.y;
                                                                                    } else {
                                                                                        phi_2937_ = _e2310.y;
                                                                                    }
                                                                                    let _e2324 = phi_2937_;
                                                                                    if (_e2308.z > _e2310.z) {
                                                                                        phi_2946_ = _e2308.z;
                                                                                    } else {
                                                                                        phi_2946_ = _e2310.z;
                                                                                    }
                                                                                    let _e2331 = phi_2946_;
                                                                                    let _e2333 = triangles.member[(0u + _e1978)].v2_;
                                                                                    if (_e2317 > _e2333.x) {
                                                                                        phi_2955_ = _e2317;
                                                                                    } else {
                                                                                        phi_2955_ = _e2333.x;
                                                                                    }
                                                                                    let _e2338 = phi_2955_;
                                                                                    if (_e2324 > _e2333.y) {
                                                                                        phi_2962_ = _e2324;
                                                                                    } else {
                                                                                        phi_2962_ = _e2333.y;
                                                                                    }
                                                                                    let _e2343 = phi_2962_;
                                                                                    if (_e2331 > _e2333.z) {
                                                                                        phi_2969_ = _e2331;
                                                                                    } else {
                                                                                        phi_2969_ = _e2333.z;
                                                                                    }
                                                                                    let _e2348 = phi_2969_;
                                                                                    let _e2352 = ((_e2296 - _e1081) * _e1288);
                                                                                    let _e2353 = ((_e2301 - _e1094) * _e1298);
                                                                                    let _e2354 = ((_e2306 - _e1107) * _e1308);
                                                                                    let _e2358 = ((_e2338 - _e1081) * _e1288);
                                                                                    let _e2359 = ((_e2343 - _e1094) * _e1298);
                                                                                    let _e2360 = ((_e2348 - _e1107) * _e1308);
                                                                                    if (_e2352 < _e2358) {
                                                                                        phi_2986_ = _e2352;
                                                                                    } else {
                                                                                        phi_2986_ = _e2358;
                                                                                    }
                                                                                    let _e2363 = phi_2986_;
                                                                                    if (_e2353 < _e2359) {
                                                                                        phi_2991_ = _e2353;
                                                                                    } else {
                                                                                        phi_2991_ = _e2359;
                                                                                    }
                                                                                    let _e2366 = phi_2991_;
                                                                                    if (_e2354 < _e2360) {
                                                                                        phi_2996_ = _e2354;
                                                                                    } else {
                                                                                        phi_2996_ = _e2360;
                                                                                    }
                                                                                    let _e2369 = phi_2996_;
                                                                                    if (_e2352 > _e2358) {
                                                                                        phi_3004_ = _e2352;
                                                                                    } else {
                                                                                        phi_3004_ = _e2358;
                                                                                    }
                                                                                    let _e2375 = phi_3004_;
                                                                                    if (_e2353 > _e2359) {
                                                                                        phi_3009_ = _e2353;
                                                                                    } else {
                                                                                        phi_3009_ = _e2359;
                                                                                    }
                                                                                    let _e2378 = phi_3009_;
                                                                                    if (_e2354 > _e2360) {
                                                                                        phi_3014_ = _e2354;
                                                                                    } else {
                                                                                        phi_3014_ = _e2360;
                                                                                    }
                                                                                    let _e2381 = phi_3014_;
                                                                                    let _e2385 = core_intrinsics_maximum_number_nsz_f32_((_e2363 - _e1347), (_e2366 - _e1348));
                                                                                    let _e2386 = core_intrinsics_maximum_number_nsz_f32_(_e2385, (_e2369 - _e1349));
                                                                                    let _e2387 = core_intrinsics_minimum_number_nsz_f32_((_e2375 + _e1347), (_e2378 + _e1348));
                                                                                    let _e2388 = core_intrinsics_minimum_number_nsz_f32_(_e2387, (_e2381 + _e1349));
                                                                                    if (_e2386 > _e1056) {
                                                                                        phi_3026_ = _e2386;
                                                                                    } else {
                                                                                        phi_3026_ = _e1056;
                                                                                    }
                                                                                    let _e2391 = phi_3026_;
                                                                                    if (_e2388 < _e1058) {
                                                                                        phi_3031_ = _e2388;
                                                                                    } else {
                                                                                        phi_3031_ = _e1058;
                                                                                    }
                                                                                    let _e2394 = phi_3031_;
                                                                                    if (_e2262 < _e2391) {
                                                                                        phi_3036_ = _e2391;
                                                                                    } else {
                                                                                        phi_3036_ = _e2262;
                                                                                    }
                                                                                    let _e2397 = phi_3036_;
                                                                                    if (_e2397 > _e2394) {
                                                                                        phi_3041_ = _e2394;
                                                                                    } else {
                                                                                        phi_3041_ = _e2397;
                                                                                    }
                                                                                    let _e2400 = phi_3041_;
                                                                                    phi_3046_ = lt_bvh_triangle_Intersection(_e2400, (_e2103 / _e2162), (_e2124 / _e2162), (_e2391 <= _e2394));
                                                                                    phi_3047_ = false;
                                                                                } else {
                                                                                    phi_3046_ = lt_bvh_triangle_Intersection();
                                                                                    phi_3047_ = true;
                                                                                }
                                                                                let _e2406 = phi_3046_;
                                                                                let _e2408 = phi_3047_;
                                                                                phi_3048_ = _e2406;
                                                                                phi_3049_ = _e2408;
                                                                            } else {
                                                                                phi_3048_ = lt_bvh_triangle_Intersection();
                                                                                phi_3049_ = true;
                                                                            }
                                                                            let _e2410 = phi_3048_;
                                                                            let _e2412 = phi_3049_;
                                                                            if _e2412 {
                                                                            }
                                                                            phi_3053_ = _e2410;
                                                                            phi_3054_ = _e2412;
                                                                        }
                                                                        let _e2414 = phi_3053_;
                                                                        let _e2416 = phi_3054_;
                                                                        phi_3055_ = _e2414;
                                                                        phi_3056_ = _e2165;
                                                                        phi_3057_ = _e2416;
                                                                    } else {
                                                                        phi_3055_ = lt_bvh_triangle_Intersection();
                                                                        phi_3056_ = true;
                                                                        phi_3057_ = false;
                                                                    }
                                                                    let _e2418 = phi_3055_;
                                                                    let _e2420 = phi_3056_;
                                                                    let _e2422 = phi_3057_;
                                                                    if _e2420 {
                                                                        phi_3061_ = true;
                                                                    } else {
                                                                        phi_3061_ = _e2422;
                                                                    }
                                                                    let _e2424 = phi_3061_;
                                                                    if _e2424 {
                                                                        phi_3065_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_3065_ = _e2418;
                                                                    }
                                                                    let _e2426 = phi_3065_;
                                                                    if _e2426.is_hit {
                                                                        if (_e2426.t > _e180.tmin) {
                                                                            if (_e2426.t < _e1967.t) {
                                                                                phi_3113_ = true;
                                                                            } else {
                                                                                if (_e2426.t == _e1967.t) {
                                                                                    if (_e1967.triangle != 4294967295u) {
                                                                                        if (_e1978 < _e1967.triangle) {
                                                                                            phi_3104_ = true;
                                                                                        } else {
                                                                                            if (_e1978 == _e1967.triangle) {
                                                                                                phi_3103_ = (_e997 < _e1967.instance);
                                                                                            } else {
                                                                                                phi_3103_ = false;
                                                                                            }
                                                                                            let _e2444 = phi_3103_;
                                                                                            phi_3104_ = _e2444;
                                                                                        }
                                                                                        let _e2446 = phi_3104_;
                                                                                        phi_3105_ = _e2446;
                                                                                        phi_3106_ = false;
                                                                                    } else {
                                                                                        phi_3105_ = bool();
                                                                                        phi_3106_ = true;
                                                                                    }
                                                                                    let _e2448 = phi_3105_;
                                                                                    let _e2450 = phi_3106_;
                                                                                    phi_3107_ = _e2448;
                                                                                    phi_3108_ = _e2450;
                                                                                } else {
                                                                                    phi_3107_ = bool();
                                                                                    phi_3108_ = true;
                                                                                }
                                                                                let _e2452 = phi_3107_;
                                                                                let _e2454 = phi_3108_;
                                                                                if _e2454 {
                                                                                    phi_3112_ = false;
                                                                                } else {
                                                                                    phi_3112_ = _e2452;
                                                                                }
                                                                                let _e2456 = phi_3112_;
                                                                                phi_3113_ = _e2456;
                                                                            }
                                                                            let _e2458 = phi_3113_;
                                                                            if _e2458 {
                                                                                let _e2460 = triangles.member[(0u + _e1978)].i0_;
                                                                                if ((_e2460 & 2147483648u) == 0u) {
                                                                                    phi_3324_ = true;
                                                                                } else {
                                                                                    if (_e1978 < _e82) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2469 = triangles.member[(0u + _e1978)].i0_;
                                                                                    let _e2470 = (_e2469 & 2147483647u);
                                                                                    let _e2472 = triangles.member[(0u + _e1978)].i1_;
                                                                                    let _e2474 = triangles.member[(0u + _e1978)].i2_;
                                                                                    if (_e2470 < _e85) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2478 = vertices.member[(0u + _e2470)];
                                                                                    if (_e2472 < _e85) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2482 = vertices.member[(0u + _e2472)];
                                                                                    if (_e2474 < _e85) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2486 = vertices.member[(0u + _e2474)];
                                                                                    let _e2487 = array<abi_Vertex, 3>(_e2478, _e2482, _e2486);
                                                                                    if (_e2487[0].material < _e88) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2493 = materials.member[(0u + _e2487[0].material)];
                                                                                    if ((_e2493.flags & 0u) == 0u) {
                                                                                        let _e2498 = ((1f - _e2426.u) - _e2426.v);
                                                                                        if (_e2493.cutoff <= 0f) {
                                                                                            phi_3319_ = true;
                                                                                        } else {
                                                                                            let _e2525 = (_e2493.base_color.w * ((((f32((_e2487[0].color >> bitcast<u32>(24i))) * _e2498) + (f32((_e2487[1].color >> bitcast<u32>(24i))) * _e2426.u)) + (f32((_e2487[2].color >> bitcast<u32>(24i))) * _e2426.v)) * (1f / 255f)));
                                                                                            if (_e2493.alpha_size == 0u) {
                                                                                                phi_3316_ = _e2525;
                                                                                            } else {
                                                                                                local_1.offset = _e2493.alpha_offset;
                                                                                                local_1.size = _e2493.alpha_size;
                                                                                                local_1.flags = _e2493.flags;
                                                                                                let _e2556 = _lt_shaders_texture_TextureView_quad((&local_1), (((_e2487[0].u * _e2498) + (_e2487[1].u * _e2426.u)) + (_e2487[2].u * _e2426.v)), (((_e2487[0].v * _e2498) + (_e2487[1].v * _e2426.u)) + (_e2487[2].v * _e2426.v)));
                                                                                                let _e2560 = (_e2556.indices[0] >> bitcast<u32>(2i));
                                                                                                if (_e2560 < _e97) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2564 = alpha_texels.member[(0u + _e2560)];
                                                                                                let _e2580 = (_e2556.indices[1] >> bitcast<u32>(2i));
                                                                                                if (_e2580 < _e97) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2584 = alpha_texels.member[(0u + _e2580)];
                                                                                                let _e2601 = (_e2556.indices[2] >> bitcast<u32>(2i));
                                                                                                if (_e2601 < _e97) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2605 = alpha_texels.member[(0u + _e2601)];
                                                                                                let _e2622 = (_e2556.indices[3] >> bitcast<u32>(2i));
                                                                                                if (_e2622 < _e97) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2626 = alpha_texels.member[(0u + _e2622)];
                                                                                                phi_3316_ = (_e2525 * (((((f32(((_e2564 >> bitcast<u32>((((_e2556.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2556.weights.x) + ((f32(((_e2584 >> bitcast<u32>((((_e2556.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2556.weights.y)) + ((f32(((_e2605 >> bitcast<u32>((((_e2556.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2556.weights.z)) + ((f32(((_e2626 >> bitcast<u32>((((_e2556.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2556.weights.w)));
                                                                                            }
                                                                                            let _e2642 = phi_3316_;
                                                                                            phi_3319_ = (_e2642 >= _e2493.cutoff);
                                                                                        }
                                                                                        let _e2646 = phi_3319_;
                                                                                        phi_3320_ = _e2646;
                                                                                    } else {
                                                                                        phi_3320_ = false;
                                                                                    }
                                                                                    let _e2648 = phi_3320_;
                                                                                    if _e2648 {
                                                                                    }
                                                                                    phi_3324_ = _e2648;
                                                                                }
                                                                                let _e2650 = phi_3324_;
                                                                                if _e2650 {
                                                                                    phi_3332_ = lt_bvh_Hit(_e2426.t, _e2426.u, _e2426.v, _e1978, _e997);
                                                                                } else {
                                                                                    phi_3332_ = _e1967;
                                                                                }
                                                                                let _e2656 = phi_3332_;
                                                                                phi_3333_ = _e2656;
                                                                            } else {
                                                                                phi_3333_ = _e1967;
                                                                            }
                                                                            let _e2658 = phi_3333_;
                                                                            phi_3334_ = _e2658;
                                                                        } else {
                                                                            phi_3334_ = _e1967;
                                                                        }
                                                                        let _e2660 = phi_3334_;
                                                                        phi_3335_ = _e2660;
                                                                    } else {
                                                                        phi_3335_ = _e1967;
                                                                    }
                                                                    let _e2662 = phi_3335_;
                                                                    phi_2495_ = _e2662;
                                                                    phi_2498_ = (_e1969 & (_e1969 - 1u));
                                                                    phi_3336_ = true;
                                                                }
                                                                let _e2664 = phi_2495_;
                                                                let _e2666 = phi_2498_;
                                                                let _e2668 = phi_3336_;
                                                                continue;
                                                                continuing {
                                                                    phi_2494_ = _e2664;
                                                                    phi_2497_ = _e2666;
                                                                    break if !(_e2668);
                                                                }
                                                            }
                                                            let _e2671 = local_2.group_mask;
                                                            if ((_e2671 & 4278190080u) == 0u) {
                                                                let _e2675 = local_2.len;
                                                                if (_e2675 == 0u) {
                                                                    phi_3375_ = false;
                                                                } else {
                                                                    let _e2679 = local_2.len;
                                                                    local_2.len = (_e2679 - 1u);
                                                                    let _e2682 = local_2.len;
                                                                    if (_e2682 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2687 = local_2.first[(0u + _e2682)];
                                                                    local_2.group = _e2687;
                                                                    let _e2690 = local_2.len;
                                                                    if (_e2690 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2695 = local_2.mask[(0u + _e2690)];
                                                                    local_2.group_mask = _e2695;
                                                                    phi_3375_ = true;
                                                                }
                                                                let _e2698 = phi_3375_;
                                                                phi_3376_ = _e2698;
                                                            } else {
                                                                phi_3376_ = true;
                                                            }
                                                            let _e2700 = phi_3376_;
                                                            if _e2700 {
                                                                let _e2702 = local_2.group_mask;
                                                                let _e2708 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2702)), 32u, (_e2702 == 0u)));
                                                                let _e2712 = local_2.group_mask;
                                                                let _e2726 = local_2.group_mask;
                                                                local_2.group_mask = (_e2726 & ~((1u << bitcast<u32>((_e2708 & 31u)))));
                                                                let _e2729 = local_2.group;
                                                                phi_3407_ = (_e2729 + countOneBits(((_e2712 & ~((4294967295u << bitcast<u32>((((_e2708 - 24u) ^ _e1390) & 31u))))) & 255u)));
                                                            } else {
                                                                phi_3407_ = 4294967295u;
                                                            }
                                                            let _e2732 = phi_3407_;
                                                            let _e3861 = local_10;
                                                            phi_2162_ = _e3861;
                                                            phi_2165_ = _e2732;
                                                        } else {
                                                            phi_2162_ = lt_bvh_Hit();
                                                            phi_2165_ = u32();
                                                        }
                                                        let _e2734 = phi_2162_;
                                                        let _e2736 = phi_2165_;
                                                        continue;
                                                        continuing {
                                                            phi_2161_ = _e2734;
                                                            phi_2164_ = _e2736;
                                                            break if !(_e1531);
                                                        }
                                                    }
                                                    let _e3865 = local_11;
                                                    phi_3408_ = _e3865;
                                                }
                                                let _e2739 = phi_3408_;
                                                phi_3409_ = _e2739;
                                                phi_3410_ = _e1212;
                                            } else {
                                                phi_3409_ = lt_bvh_Hit();
                                                phi_3410_ = true;
                                            }
                                            let _e2741 = phi_3409_;
                                            let _e2743 = phi_3410_;
                                            if _e2743 {
                                                phi_3414_ = _e989;
                                            } else {
                                                phi_3414_ = _e2741;
                                            }
                                            let _e2745 = phi_3414_;
                                            phi_3415_ = _e2745;
                                        } else {
                                            phi_3415_ = _e989;
                                        }
                                        let _e2747 = phi_3415_;
                                        phi_3416_ = _e2747;
                                    } else {
                                        phi_3416_ = _e989;
                                    }
                                    let _e2749 = phi_3416_;
                                    phi_3417_ = _e2749;
                                } else {
                                    phi_3417_ = _e989;
                                }
                                let _e2751 = phi_3417_;
                                phi_1529_ = (_e987 & (_e987 - 1u));
                                phi_1532_ = _e2751;
                                phi_3418_ = true;
                            }
                            let _e2753 = phi_1529_;
                            let _e2755 = phi_1532_;
                            let _e2757 = phi_3418_;
                            continue;
                            continuing {
                                phi_1528_ = _e2753;
                                phi_1531_ = _e2755;
                                break if !(_e2757);
                            }
                        }
                        let _e2760 = local_3.group_mask;
                        if ((_e2760 & 4278190080u) == 0u) {
                            let _e2764 = local_3.len;
                            if (_e2764 == 0u) {
                                phi_3457_ = false;
                            } else {
                                let _e2768 = local_3.len;
                                local_3.len = (_e2768 - 1u);
                                let _e2771 = local_3.len;
                                if (_e2771 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2776 = local_3.first[(0u + _e2771)];
                                local_3.group = _e2776;
                                let _e2779 = local_3.len;
                                if (_e2779 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2784 = local_3.mask[(0u + _e2779)];
                                local_3.group_mask = _e2784;
                                phi_3457_ = true;
                            }
                            let _e2787 = phi_3457_;
                            phi_3458_ = _e2787;
                        } else {
                            phi_3458_ = true;
                        }
                        let _e2789 = phi_3458_;
                        if _e2789 {
                            let _e2791 = local_3.group_mask;
                            let _e2797 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2791)), 32u, (_e2791 == 0u)));
                            let _e2801 = local_3.group_mask;
                            let _e2815 = local_3.group_mask;
                            local_3.group_mask = (_e2815 & ~((1u << bitcast<u32>((_e2797 & 31u)))));
                            let _e2818 = local_3.group;
                            phi_3489_ = (_e2818 + countOneBits(((_e2801 & ~((4294967295u << bitcast<u32>((((_e2797 - 24u) ^ _e406) & 31u))))) & 255u)));
                        } else {
                            phi_3489_ = 4294967295u;
                        }
                        let _e2821 = phi_3489_;
                        phi_1192_ = _e2821;
                        let _e3881 = local_12;
                        phi_1195_ = _e3881;
                    } else {
                        phi_1192_ = u32();
                        phi_1195_ = lt_bvh_Hit();
                    }
                    let _e2823 = phi_1192_;
                    let _e2825 = phi_1195_;
                    continue;
                    continuing {
                        phi_1191_ = _e2823;
                        phi_1194_ = _e2825;
                        break if !(_e547);
                    }
                }
                let _e3884 = local_13;
                phi_3490_ = _e3884;
            }
            let _e2828 = phi_3490_;
            phi_3491_ = _e2828;
            phi_3492_ = _e244;
        } else {
            phi_3491_ = lt_bvh_Hit();
            phi_3492_ = true;
        }
        let _e2830 = phi_3491_;
        let _e2832 = phi_3492_;
        if _e2832 {
            phi_3496_ = _e182;
        } else {
            phi_3496_ = _e2830;
        }
        let _e2834 = phi_3496_;
        if (_e2834.triangle != 4294967295u) {
            let _e2840 = ((1f - _e2834.u) - _e2834.v);
            if (_e2834.triangle < _e82) {
            } else {
                return;
            }
            let _e2845 = triangles.member[(0u + _e2834.triangle)];
            if (_e2834.instance < _e94) {
            } else {
                return;
            }
            let _e2856 = instances.member[(0u + _e2834.instance)].object_to_world[0u];
            let _e2867 = ((((_e2856.x * _e2845.v0_.x) + (_e2856.y * _e2845.v0_.y)) + (_e2856.z * _e2845.v0_.z)) + (_e2856.w * 1f));
            let _e2869 = instances.member[(0u + _e2834.instance)].object_to_world[1u];
            let _e2880 = ((((_e2869.x * _e2845.v0_.x) + (_e2869.y * _e2845.v0_.y)) + (_e2869.z * _e2845.v0_.z)) + (_e2869.w * 1f));
            let _e2882 = instances.member[(0u + _e2834.instance)].object_to_world[2u];
            let _e2893 = ((((_e2882.x * _e2845.v0_.x) + (_e2882.y * _e2845.v0_.y)) + (_e2882.z * _e2845.v0_.z)) + (_e2882.w * 1f));
            let _e2900 = instances.member[(0u + _e2834.instance)].object_to_world[0u];
            let _e2911 = ((((_e2900.x * _e2845.v1_.x) + (_e2900.y * _e2845.v1_.y)) + (_e2900.z * _e2845.v1_.z)) + (_e2900.w * 1f));
            let _e2913 = instances.member[(0u + _e2834.instance)].object_to_world[1u];
            let _e2924 = ((((_e2913.x * _e2845.v1_.x) + (_e2913.y * _e2845.v1_.y)) + (_e2913.z * _e2845.v1_.z)) + (_e2913.w * 1f));
            let _e2926 = instances.member[(0u + _e2834.instance)].object_to_world[2u];
            let _e2937 = ((((_e2926.x * _e2845.v1_.x) + (_e2926.y * _e2845.v1_.y)) + (_e2926.z * _e2845.v1_.z)) + (_e2926.w * 1f));
            let _e2944 = instances.member[(0u + _e2834.instance)].object_to_world[0u];
            let _e2955 = ((((_e2944.x * _e2845.v2_.x) + (_e2944.y * _e2845.v2_.y)) + (_e2944.z * _e2845.v2_.z)) + (_e2944.w * 1f));
            let _e2957 = instances.member[(0u + _e2834.instance)].object_to_world[1u];
            let _e2968 = ((((_e2957.x * _e2845.v2_.x) + (_e2957.y * _e2845.v2_.y)) + (_e2957.z * _e2845.v2_.z)) + (_e2957.w * 1f));
            let _e2970 = instances.member[(0u + _e2834.instance)].object_to_world[2u];
            let _e2981 = ((((_e2970.x * _e2845.v2_.x) + (_e2970.y * _e2845.v2_.y)) + (_e2970.z * _e2845.v2_.z)) + (_e2970.w * 1f));
            let _e2994 = (((_e2867 * _e2840) + (_e2911 * _e2834.u)) + (_e2955 * _e2834.v));
            let _e2995 = (((_e2880 * _e2840) + (_e2924 * _e2834.u)) + (_e2968 * _e2834.v));
            let _e2996 = (((_e2893 * _e2840) + (_e2937 * _e2834.u)) + (_e2981 * _e2834.v));
            let _e2998 = abs(_e2867);
            let _e2999 = abs(_e2880);
            let _e3000 = abs(_e2893);
            let _e3001 = abs(_e2911);
            let _e3002 = abs(_e2924);
            let _e3003 = abs(_e2937);
            if (_e2998 > _e3001) {
                phi_3683_ = _e2998;
            } else {
                phi_3683_ = _e3001;
            }
            let _e3006 = phi_3683_;
            if (_e2999 > _e3002) {
                phi_3688_ = _e2999;
            } else {
                phi_3688_ = _e3002;
            }
            let _e3009 = phi_3688_;
            if (_e3000 > _e3003) {
                phi_3693_ = _e3000;
            } else {
                phi_3693_ = _e3003;
            }
            let _e3012 = phi_3693_;
            let _e3013 = abs(_e2955);
            let _e3014 = abs(_e2968);
            let _e3015 = abs(_e2981);
            if (_e3006 > _e3013) {
                phi_3701_ = _e3006;
            } else {
                phi_3701_ = _e3013;
            }
            let _e3018 = phi_3701_;
            if (_e3009 > _e3014) {
                phi_3706_ = _e3009;
            } else {
                phi_3706_ = _e3014;
            }
            let _e3021 = phi_3706_;
            if (_e3012 > _e3015) {
                phi_3711_ = _e3012;
            } else {
                phi_3711_ = _e3015;
            }
            let _e3024 = phi_3711_;
            let _e3025 = (_e2911 - _e2867);
            let _e3026 = (_e2924 - _e2880);
            let _e3027 = (_e2937 - _e2893);
            let _e3028 = (_e2955 - _e2867);
            let _e3029 = (_e2968 - _e2880);
            let _e3030 = (_e2981 - _e2893);
            let _e3034 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3026), abs(_e3027));
            let _e3035 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3025), _e3034);
            let _e3036 = (_e3025 / _e3035);
            let _e3037 = (_e3026 / _e3035);
            let _e3038 = (_e3027 / _e3035);
            let _e3042 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3029), abs(_e3030));
            let _e3043 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3028), _e3042);
            let _e3044 = (_e3028 / _e3043);
            let _e3045 = (_e3029 / _e3043);
            let _e3046 = (_e3030 / _e3043);
            let _e3049 = ((_e3037 * _e3046) - (_e3045 * _e3038));
            let _e3052 = ((_e3038 * _e3044) - (_e3046 * _e3036));
            let _e3055 = ((_e3036 * _e3045) - (_e3044 * _e3037));
            let _e3057 = p.member.eye;
            let _e3070 = (1f / sqrt((((_e3049 * _e3049) + (_e3052 * _e3052)) + (_e3055 * _e3055))));
            let _e3071 = (_e3049 * _e3070);
            let _e3072 = (_e3052 * _e3070);
            let _e3073 = (_e3055 * _e3070);
            if ((((_e3071 * (_e3057.x - _e2994)) + (_e3072 * (_e3057.y - _e2995))) + (_e3073 * (_e3057.z - _e2996))) < 0f) {
                phi_3775_ = vec3<f32>(-(_e3071), -(_e3072), -(_e3073));
            } else {
                phi_3775_ = vec3<f32>(_e3071, _e3072, _e3073);
            }
            let _e3086 = phi_3775_;
            if (_e2834.triangle < _e82) {
            } else {
                return;
            }
            let _e3091 = triangles.member[(0u + _e2834.triangle)];
            let _e3093 = (_e3091.i0_ & 2147483647u);
            if (_e3093 < _e85) {
            } else {
                return;
            }
            let _e3099 = vertices.member[(0u + _e3093)];
            if (_e3091.i1_ < _e85) {
            } else {
                return;
            }
            let _e3103 = vertices.member[(0u + _e3091.i1_)];
            if (_e3091.i2_ < _e85) {
            } else {
                return;
            }
            let _e3107 = vertices.member[(0u + _e3091.i2_)];
            let _e3108 = array<abi_Vertex, 3>(_e3099, _e3103, _e3107);
            if (_e3108[0].material < _e88) {
            } else {
                return;
            }
            let _e3114 = materials.member[(0u + _e3108[0].material)];
            let _e3131 = (1f / 255f);
            let _e3150 = (1f / 255f);
            let _e3172 = (1f / 255f);
            if (_e3114.color_size == 0u) {
                phi_4018_ = vec3<f32>(1f, 1f, 1f);
            } else {
                local.offset = _e3114.color_offset;
                local.size = _e3114.color_size;
                local.flags = _e3114.flags;
                let _e3215 = _lt_shaders_texture_TextureView_quad((&local), (((_e3108[0].u * _e2840) + (_e3108[1].u * _e2834.u)) + (_e3108[2].u * _e2834.v)), (((_e3108[0].v * _e2840) + (_e3108[1].v * _e2834.u)) + (_e3108[2].v * _e2834.v)));
                if (_e3215.indices[0] < _e100) {
                } else {
                    return;
                }
                let _e3221 = color_texels.member[(0u + _e3215.indices[0])];
                let _e3232 = (1f / 255f);
                if (_e3215.indices[1] < _e100) {
                } else {
                    return;
                }
                let _e3246 = color_texels.member[(0u + _e3215.indices[1])];
                let _e3257 = (1f / 255f);
                if (_e3215.indices[2] < _e100) {
                } else {
                    return;
                }
                let _e3274 = color_texels.member[(0u + _e3215.indices[2])];
                let _e3285 = (1f / 255f);
                if (_e3215.indices[3] < _e100) {
                } else {
                    return;
                }
                let _e3302 = color_texels.member[(0u + _e3215.indices[3])];
                let _e3313 = (1f / 255f);
                let _e3322 = (((((f32((_e3221 & 255u)) * _e3232) * _e3215.weights.x) + ((f32((_e3246 & 255u)) * _e3257) * _e3215.weights.y)) + ((f32((_e3274 & 255u)) * _e3285) * _e3215.weights.z)) + ((f32((_e3302 & 255u)) * _e3313) * _e3215.weights.w));
                let _e3323 = (((((f32(((_e3221 >> bitcast<u32>(8i)) & 255u)) * _e3232) * _e3215.weights.x) + ((f32(((_e3246 >> bitcast<u32>(8i)) & 255u)) * _e3257) * _e3215.weights.y)) + ((f32(((_e3274 >> bitcast<u32>(8i)) & 255u)) * _e3285) * _e3215.weights.z)) + ((f32(((_e3302 >> bitcast<u32>(8i)) & 255u)) * _e3313) * _e3215.weights.w));
                let _e3324 = (((((f32(((_e3221 >> bitcast<u32>(16i)) & 255u)) * _e3232) * _e3215.weights.x) + ((f32(((_e3246 >> bitcast<u32>(16i)) & 255u)) * _e3257) * _e3215.weights.y)) + ((f32(((_e3274 >> bitcast<u32>(16i)) & 255u)) * _e3285) * _e3215.weights.z)) + ((f32(((_e3302 >> bitcast<u32>(16i)) & 255u)) * _e3313) * _e3215.weights.w));
                phi_4018_ = vec3<f32>((_e3322 * _e3322), (_e3323 * _e3323), (_e3324 * _e3324));
            }
            let _e3330 = phi_4018_;
            let _e3332 = ((_e3114.base_color.x * ((((f32((_e3108[0].color & 255u)) * _e3131) * _e2840) + ((f32((_e3108[1].color & 255u)) * _e3150) * _e2834.u)) + ((f32((_e3108[2].color & 255u)) * _e3172) * _e2834.v))) * _e3330.x);
            let _e3334 = ((_e3114.base_color.y * ((((f32(((_e3108[0].color >> bitcast<u32>(8i)) & 255u)) * _e3131) * _e2840) + ((f32(((_e3108[1].color >> bitcast<u32>(8i)) & 255u)) * _e3150) * _e2834.u)) + ((f32(((_e3108[2].color >> bitcast<u32>(8i)) & 255u)) * _e3172) * _e2834.v))) * _e3330.y);
            let _e3336 = ((_e3114.base_color.z * ((((f32(((_e3108[0].color >> bitcast<u32>(16i)) & 255u)) * _e3131) * _e2840) + ((f32(((_e3108[1].color >> bitcast<u32>(16i)) & 255u)) * _e3150) * _e2834.u)) + ((f32(((_e3108[2].color >> bitcast<u32>(16i)) & 255u)) * _e3172) * _e2834.v))) * _e3330.z);
            let _e3337 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e3021, _e3024);
            let _e3338 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e3018, _e3337);
            if ((_e3114.flags & 2u) == 0u) {
                phi_4033_ = 0u;
            } else {
                phi_4033_ = 1u;
            }
            let _e3343 = phi_4033_;
            if (_e3108[0].normal == 2147516416u) {
                phi_4263_ = _e3086;
            } else {
                let _e3356 = (f32((bitcast<i32>((_e3108[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3362 = (f32((bitcast<i32>(_e3108[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3366 = ((1f - abs(_e3356)) - abs(_e3362));
                if (_e3366 < 0f) {
                    phi_4060_ = -(_e3366);
                } else {
                    phi_4060_ = 0f;
                }
                let _e3370 = phi_4060_;
                if (_e3356 < 0f) {
                    phi_4067_ = (_e3356 + _e3370);
                } else {
                    phi_4067_ = (_e3356 - _e3370);
                }
                let _e3375 = phi_4067_;
                if (_e3362 < 0f) {
                    phi_4074_ = (_e3362 + _e3370);
                } else {
                    phi_4074_ = (_e3362 - _e3370);
                }
                let _e3380 = phi_4074_;
                let _e3387 = (1f / sqrt((((_e3375 * _e3375) + (_e3380 * _e3380)) + (_e3366 * _e3366))));
                let _e3403 = (f32((bitcast<i32>((_e3108[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3409 = (f32((bitcast<i32>(_e3108[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3413 = ((1f - abs(_e3403)) - abs(_e3409));
                if (_e3413 < 0f) {
                    phi_4109_ = -(_e3413);
                } else {
                    phi_4109_ = 0f;
                }
                let _e3417 = phi_4109_;
                if (_e3403 < 0f) {
                    phi_4116_ = (_e3403 + _e3417);
                } else {
                    phi_4116_ = (_e3403 - _e3417);
                }
                let _e3422 = phi_4116_;
                if (_e3409 < 0f) {
                    phi_4123_ = (_e3409 + _e3417);
                } else {
                    phi_4123_ = (_e3409 - _e3417);
                }
                let _e3427 = phi_4123_;
                let _e3434 = (1f / sqrt((((_e3422 * _e3422) + (_e3427 * _e3427)) + (_e3413 * _e3413))));
                let _e3453 = (f32((bitcast<i32>((_e3108[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3459 = (f32((bitcast<i32>(_e3108[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3463 = ((1f - abs(_e3453)) - abs(_e3459));
                if (_e3463 < 0f) {
                    phi_4161_ = -(_e3463);
                } else {
                    phi_4161_ = 0f;
                }
                let _e3467 = phi_4161_;
                if (_e3453 < 0f) {
                    phi_4168_ = (_e3453 + _e3467);
                } else {
                    phi_4168_ = (_e3453 - _e3467);
                }
                let _e3472 = phi_4168_;
                if (_e3459 < 0f) {
                    phi_4175_ = (_e3459 + _e3467);
                } else {
                    phi_4175_ = (_e3459 - _e3467);
                }
                let _e3477 = phi_4175_;
                let _e3484 = (1f / sqrt((((_e3472 * _e3472) + (_e3477 * _e3477)) + (_e3463 * _e3463))));
                let _e3491 = ((((_e3375 * _e3387) * _e2840) + ((_e3422 * _e3434) * _e2834.u)) + ((_e3472 * _e3484) * _e2834.v));
                let _e3492 = ((((_e3380 * _e3387) * _e2840) + ((_e3427 * _e3434) * _e2834.u)) + ((_e3477 * _e3484) * _e2834.v));
                let _e3493 = ((((_e3366 * _e3387) * _e2840) + ((_e3413 * _e3434) * _e2834.u)) + ((_e3463 * _e3484) * _e2834.v));
                if (_e2834.instance < _e94) {
                } else {
                    return;
                }
                let _e3500 = instances.member[(0u + _e2834.instance)].world_to_object[0u];
                let _e3509 = instances.member[(0u + _e2834.instance)].world_to_object[1u];
                let _e3521 = instances.member[(0u + _e2834.instance)].world_to_object[2u];
                let _e3528 = (((_e3500.x * _e3491) + (_e3509.x * _e3492)) + (_e3521.x * _e3493));
                let _e3529 = (((_e3500.y * _e3491) + (_e3509.y * _e3492)) + (_e3521.y * _e3493));
                let _e3530 = (((_e3500.z * _e3491) + (_e3509.z * _e3492)) + (_e3521.z * _e3493));
                let _e3536 = sqrt((((_e3528 * _e3528) + (_e3529 * _e3529)) + (_e3530 * _e3530)));
                if (_e3536 > 0f) {
                    let _e3538 = (_e3528 / _e3536);
                    let _e3539 = (_e3529 / _e3536);
                    let _e3540 = (_e3530 / _e3536);
                    if ((((_e3538 * _e3086.x) + (_e3539 * _e3086.y)) + (_e3540 * _e3086.z)) < 0f) {
                        phi_4261_ = vec3<f32>(-(_e3538), -(_e3539), -(_e3540));
                    } else {
                        phi_4261_ = vec3<f32>(_e3538, _e3539, _e3540);
                    }
                    let _e3556 = phi_4261_;
                    phi_4262_ = _e3556;
                } else {
                    phi_4262_ = _e3086;
                }
                let _e3558 = phi_4262_;
                phi_4263_ = _e3558;
            }
            let _e3560 = phi_4263_;
            if (_e3332 > 0f) {
                if (_e3332 < 1f) {
                    phi_4272_ = _e3332;
                } else {
                    phi_4272_ = 1f;
                }
                let _e3564 = phi_4272_;
                phi_4273_ = _e3564;
            } else {
                phi_4273_ = 0f;
            }
            let _e3566 = phi_4273_;
            if (_e3334 > 0f) {
                if (_e3334 < 1f) {
                    phi_4283_ = _e3334;
                } else {
                    phi_4283_ = 1f;
                }
                let _e3571 = phi_4283_;
                phi_4284_ = _e3571;
            } else {
                phi_4284_ = 0f;
            }
            let _e3573 = phi_4284_;
            if (_e3336 > 0f) {
                if (_e3336 < 1f) {
                    phi_4294_ = _e3336;
                } else {
                    phi_4294_ = 1f;
                }
                let _e3578 = phi_4294_;
                phi_4295_ = _e3578;
            } else {
                phi_4295_ = 0f;
            }
            let _e3580 = phi_4295_;
            let _e3583 = ((sqrt(_e3566) * 255f) + 0.5f);
            let _e3592 = ((sqrt(_e3573) * 255f) + 0.5f);
            let _e3604 = ((sqrt(_e3580) * 255f) + 0.5f);
            phi_4330_ = abi_Sample(vec3<f32>(_e2994, _e2995, _e2996), _e3338, _e3086, _e3343, _e3560, ((select(select(u32(_e3583), 0u, (_e3583 < bitcast<f32>(0u))), 4294967295u, (_e3583 > bitcast<f32>(1333788671u))) | (select(select(u32(_e3592), 0u, (_e3592 < bitcast<f32>(0u))), 4294967295u, (_e3592 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e3604), 0u, (_e3604 < bitcast<f32>(0u))), 4294967295u, (_e3604 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_4330_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e3618 = phi_4330_;
        if (_e106.shift < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e106.shift)] = _e3618;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_instanced_alpha_color_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
