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

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_mask_LightPlace {
    var phi_225_: lt_mask_LightPlace;
    var phi_226_: bool;
    var phi_227_: lt_mask_LightPlace;
    var phi_228_: bool;
    var phi_233_: lt_mask_LightPlace;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_225_ = lt_mask_LightPlace(1u, ((param.y * param_1) + param.x));
            phi_226_ = false;
        } else {
            phi_225_ = lt_mask_LightPlace();
            phi_226_ = true;
        }
        let _e83 = phi_225_;
        let _e85 = phi_226_;
        phi_227_ = _e83;
        phi_228_ = _e85;
    } else {
        phi_227_ = lt_mask_LightPlace();
        phi_228_ = true;
    }
    let _e87 = phi_227_;
    let _e89 = phi_228_;
    if _e89 {
        phi_233_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_233_ = _e87;
    }
    let _e94 = phi_233_;
    return lt_mask_LightPlace(_e94.word, _e94.shift);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_248_: bool;
    var phi_252_: f32;

    if (param_3 != param_3) {
        phi_248_ = true;
    } else {
        let _e73 = (param_4 >= param_3);
        if _e73 {
        }
        phi_248_ = _e73;
    }
    let _e75 = phi_248_;
    if _e75 {
        phi_252_ = param_4;
    } else {
        phi_252_ = param_3;
    }
    let _e77 = phi_252_;
    return _e77;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_264_: bool;
    var phi_268_: f32;

    if (param_5 != param_5) {
        phi_264_ = true;
    } else {
        let _e73 = (param_6 <= param_5);
        if _e73 {
        }
        phi_264_ = _e73;
    }
    let _e75 = phi_264_;
    if _e75 {
        phi_268_ = param_6;
    } else {
        phi_268_ = param_5;
    }
    let _e77 = phi_268_;
    return _e77;
}

fn _lt_shaders_texture_TextureView_quad(param_7: ptr<function, texture_TextureView>, param_8: f32, param_9: f32) -> texture_TexelQuad {
    var phi_310_: f32;
    var phi_315_: f32;
    var phi_316_: bool;
    var phi_317_: f32;
    var phi_318_: bool;
    var phi_322_: f32;
    var phi_348_: f32;
    var phi_353_: f32;
    var phi_354_: bool;
    var phi_355_: f32;
    var phi_356_: bool;
    var phi_360_: f32;
    var phi_368_: f32;
    var phi_369_: f32;
    var phi_370_: f32;
    var phi_379_: f32;
    var phi_380_: f32;
    var phi_398_: u32;
    var phi_412_: u32;
    var phi_419_: u32;
    var phi_424_: u32;
    var phi_430_: u32;
    var phi_435_: u32;
    var phi_437_: texture_Axis;
    var phi_465_: f32;
    var phi_470_: f32;
    var phi_471_: bool;
    var phi_472_: f32;
    var phi_473_: bool;
    var phi_477_: f32;
    var phi_503_: f32;
    var phi_508_: f32;
    var phi_509_: bool;
    var phi_510_: f32;
    var phi_511_: bool;
    var phi_515_: f32;
    var phi_523_: f32;
    var phi_524_: f32;
    var phi_525_: f32;
    var phi_534_: f32;
    var phi_535_: f32;
    var phi_553_: u32;
    var phi_567_: u32;
    var phi_574_: u32;
    var phi_579_: u32;
    var phi_585_: u32;
    var phi_590_: u32;
    var phi_592_: texture_Axis;

    let _e74 = (*param_7).size;
    let _e75 = (_e74 & 65535u);
    let _e77 = (*param_7).size;
    let _e79 = (_e77 >> bitcast<u32>(16i));
    let _e81 = (*param_7).flags;
    let _e83 = ((_e81 & 4u) != 0u);
    let _e85 = (*param_7).flags;
    let _e88 = ((_e85 >> bitcast<u32>(4u)) & 3u);
    if (_e88 == 0u) {
        if (param_8 > -8388608f) {
            let _e101 = f32(select(0i, select(select(i32(param_8), i32(-2147483648), (param_8 < bitcast<f32>(3472883712u))), 2147483647i, (param_8 > bitcast<f32>(1325400063u))), (param_8 == param_8)));
            if (_e101 > param_8) {
                phi_310_ = 1f;
            } else {
                phi_310_ = 0f;
            }
            let _e104 = phi_310_;
            if (param_8 < 8388608f) {
                phi_315_ = (_e101 - _e104);
                phi_316_ = false;
            } else {
                phi_315_ = f32();
                phi_316_ = true;
            }
            let _e107 = phi_315_;
            let _e109 = phi_316_;
            phi_317_ = _e107;
            phi_318_ = _e109;
        } else {
            phi_317_ = f32();
            phi_318_ = true;
        }
        let _e111 = phi_317_;
        let _e113 = phi_318_;
        if _e113 {
            phi_322_ = param_8;
        } else {
            phi_322_ = _e111;
        }
        let _e115 = phi_322_;
        phi_370_ = (param_8 - _e115);
    } else {
        if (_e88 == 1u) {
            let _e118 = (param_8 * 0.5f);
            if (_e118 > -8388608f) {
                let _e130 = f32(select(0i, select(select(i32(_e118), i32(-2147483648), (_e118 < bitcast<f32>(3472883712u))), 2147483647i, (_e118 > bitcast<f32>(1325400063u))), (_e118 == _e118)));
                if (_e130 > _e118) {
                    phi_348_ = 1f;
                } else {
                    phi_348_ = 0f;
                }
                let _e133 = phi_348_;
                if (_e118 < 8388608f) {
                    phi_353_ = (_e130 - _e133);
                    phi_354_ = false;
                } else {
                    phi_353_ = f32();
                    phi_354_ = true;
                }
                let _e136 = phi_353_;
                let _e138 = phi_354_;
                phi_355_ = _e136;
                phi_356_ = _e138;
            } else {
                phi_355_ = f32();
                phi_356_ = true;
            }
            let _e140 = phi_355_;
            let _e142 = phi_356_;
            if _e142 {
                phi_360_ = _e118;
            } else {
                phi_360_ = _e140;
            }
            let _e144 = phi_360_;
            let _e146 = (param_8 - (2f * _e144));
            if (_e146 > 1f) {
                phi_368_ = (2f - _e146);
            } else {
                phi_368_ = _e146;
            }
            let _e150 = phi_368_;
            phi_369_ = _e150;
        } else {
            phi_369_ = param_8;
        }
        let _e152 = phi_369_;
        phi_370_ = _e152;
    }
    let _e154 = phi_370_;
    if (_e154 > 0f) {
        if (_e154 < 1f) {
            phi_379_ = _e154;
        } else {
            phi_379_ = 1f;
        }
        let _e158 = phi_379_;
        phi_380_ = _e158;
    } else {
        phi_380_ = 0f;
    }
    let _e160 = phi_380_;
    let _e161 = (_e75 - 1u);
    let _e163 = (_e160 * f32(_e75));
    if _e83 {
        let _e170 = select(select(u32(_e163), 0u, (_e163 < bitcast<f32>(0u))), 4294967295u, (_e163 > bitcast<f32>(1333788671u)));
        if (_e161 < _e170) {
            phi_398_ = _e161;
        } else {
            phi_398_ = _e170;
        }
        let _e173 = phi_398_;
        phi_437_ = texture_Axis(_e173, _e173, 0f);
    } else {
        let _e175 = (_e163 + 0.5f);
        let _e182 = select(select(u32(_e175), 0u, (_e175 < bitcast<f32>(0u))), 4294967295u, (_e175 > bitcast<f32>(1333788671u)));
        if (_e75 < _e182) {
            phi_412_ = _e75;
        } else {
            phi_412_ = _e182;
        }
        let _e185 = phi_412_;
        if (_e88 == 0u) {
            phi_419_ = _e161;
        } else {
            phi_419_ = 0u;
        }
        let _e190 = phi_419_;
        if (_e88 == 0u) {
            phi_424_ = 0u;
        } else {
            phi_424_ = _e161;
        }
        let _e193 = phi_424_;
        if (_e185 == 0u) {
            phi_430_ = _e190;
        } else {
            phi_430_ = (_e185 - 1u);
        }
        let _e197 = phi_430_;
        if (_e185 > _e161) {
            phi_435_ = _e193;
        } else {
            phi_435_ = _e185;
        }
        let _e200 = phi_435_;
        phi_437_ = texture_Axis(_e197, _e200, (_e175 - f32(_e185)));
    }
    let _e203 = phi_437_;
    let _e205 = (*param_7).flags;
    let _e208 = ((_e205 >> bitcast<u32>(6u)) & 3u);
    if (_e208 == 0u) {
        if (param_9 > -8388608f) {
            let _e221 = f32(select(0i, select(select(i32(param_9), i32(-2147483648), (param_9 < bitcast<f32>(3472883712u))), 2147483647i, (param_9 > bitcast<f32>(1325400063u))), (param_9 == param_9)));
            if (_e221 > param_9) {
                phi_465_ = 1f;
            } else {
                phi_465_ = 0f;
            }
            let _e224 = phi_465_;
            if (param_9 < 8388608f) {
                phi_470_ = (_e221 - _e224);
                phi_471_ = false;
            } else {
                phi_470_ = f32();
                phi_471_ = true;
            }
            let _e227 = phi_470_;
            let _e229 = phi_471_;
            phi_472_ = _e227;
            phi_473_ = _e229;
        } else {
            phi_472_ = f32();
            phi_473_ = true;
        }
        let _e231 = phi_472_;
        let _e233 = phi_473_;
        if _e233 {
            phi_477_ = param_9;
        } else {
            phi_477_ = _e231;
        }
        let _e235 = phi_477_;
        phi_525_ = (param_9 - _e235);
    } else {
        if (_e208 == 1u) {
            let _e238 = (param_9 * 0.5f);
            if (_e238 > -8388608f) {
                let _e250 = f32(select(0i, select(select(i32(_e238), i32(-2147483648), (_e238 < bitcast<f32>(3472883712u))), 2147483647i, (_e238 > bitcast<f32>(1325400063u))), (_e238 == _e238)));
                if (_e250 > _e238) {
                    phi_503_ = 1f;
                } else {
                    phi_503_ = 0f;
                }
                let _e253 = phi_503_;
                if (_e238 < 8388608f) {
                    phi_508_ = (_e250 - _e253);
                    phi_509_ = false;
                } else {
                    phi_508_ = f32();
                    phi_509_ = true;
                }
                let _e256 = phi_508_;
                let _e258 = phi_509_;
                phi_510_ = _e256;
                phi_511_ = _e258;
            } else {
                phi_510_ = f32();
                phi_511_ = true;
            }
            let _e260 = phi_510_;
            let _e262 = phi_511_;
            if _e262 {
                phi_515_ = _e238;
            } else {
                phi_515_ = _e260;
            }
            let _e264 = phi_515_;
            let _e266 = (param_9 - (2f * _e264));
            if (_e266 > 1f) {
                phi_523_ = (2f - _e266);
            } else {
                phi_523_ = _e266;
            }
            let _e270 = phi_523_;
            phi_524_ = _e270;
        } else {
            phi_524_ = param_9;
        }
        let _e272 = phi_524_;
        phi_525_ = _e272;
    }
    let _e274 = phi_525_;
    if (_e274 > 0f) {
        if (_e274 < 1f) {
            phi_534_ = _e274;
        } else {
            phi_534_ = 1f;
        }
        let _e278 = phi_534_;
        phi_535_ = _e278;
    } else {
        phi_535_ = 0f;
    }
    let _e280 = phi_535_;
    let _e281 = (_e79 - 1u);
    let _e283 = (_e280 * f32(_e79));
    if _e83 {
        let _e290 = select(select(u32(_e283), 0u, (_e283 < bitcast<f32>(0u))), 4294967295u, (_e283 > bitcast<f32>(1333788671u)));
        if (_e281 < _e290) {
            phi_553_ = _e281;
        } else {
            phi_553_ = _e290;
        }
        let _e293 = phi_553_;
        phi_592_ = texture_Axis(_e293, _e293, 0f);
    } else {
        let _e295 = (_e283 + 0.5f);
        let _e302 = select(select(u32(_e295), 0u, (_e295 < bitcast<f32>(0u))), 4294967295u, (_e295 > bitcast<f32>(1333788671u)));
        if (_e79 < _e302) {
            phi_567_ = _e79;
        } else {
            phi_567_ = _e302;
        }
        let _e305 = phi_567_;
        if (_e208 == 0u) {
            phi_574_ = _e281;
        } else {
            phi_574_ = 0u;
        }
        let _e310 = phi_574_;
        if (_e208 == 0u) {
            phi_579_ = 0u;
        } else {
            phi_579_ = _e281;
        }
        let _e313 = phi_579_;
        if (_e305 == 0u) {
            phi_585_ = _e310;
        } else {
            phi_585_ = (_e305 - 1u);
        }
        let _e317 = phi_585_;
        if (_e305 > _e281) {
            phi_590_ = _e313;
        } else {
            phi_590_ = _e305;
        }
        let _e320 = phi_590_;
        phi_592_ = texture_Axis(_e317, _e320, (_e295 - f32(_e305)));
    }
    let _e323 = phi_592_;
    let _e327 = (*param_7).offset;
    let _e334 = (*param_7).offset;
    let _e341 = (*param_7).offset;
    let _e348 = (*param_7).offset;
    return texture_TexelQuad(array<u32, 4>(((_e327 + (_e323.low * _e75)) + _e203.low), ((_e334 + (_e323.low * _e75)) + _e203.high), ((_e341 + (_e323.high * _e75)) + _e203.low), ((_e348 + (_e323.high * _e75)) + _e203.high)), vec4<f32>(((1f - _e203.fraction) * (1f - _e323.fraction)), (_e203.fraction * (1f - _e323.fraction)), ((1f - _e203.fraction) * _e323.fraction), (_e203.fraction * _e323.fraction)));
}

fn _lt_bvh_ray_Ray_new(param_10: vec3<f32>, param_11: vec3<f32>) -> lt_bvh_Ray {
    return lt_bvh_Ray(param_10, 0f, param_11, 300000000000000000000000000000000000000f);
}

fn _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(param_12: f32, param_13: f32) -> f32 {
    var phi_651_: f32;

    if (param_12 > param_13) {
        phi_651_ = param_12;
    } else {
        phi_651_ = param_13;
    }
    let _e74 = phi_651_;
    return _e74;
}

fn _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(param_14: vec3<f32>) -> vec3<f32> {
    return vec3<f32>(1f, 1f, 1f);
}

fn function_() {
    var local: texture_TextureView;
    var local_1: lt_bvh_traverse_Stack;
    var local_2: lt_bvh_traverse_Stack;
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
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
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
    var local_6: u32;
    var local_7: u32;
    var local_8: u32;
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
    var phi_3684_: f32;
    var phi_3689_: f32;
    var phi_3694_: f32;
    var phi_3702_: f32;
    var phi_3707_: f32;
    var phi_3712_: f32;
    var phi_3776_: vec3<f32>;
    var phi_3897_: u32;
    var phi_3924_: f32;
    var phi_3931_: f32;
    var phi_3938_: f32;
    var phi_3973_: f32;
    var phi_3980_: f32;
    var phi_3987_: f32;
    var phi_4025_: f32;
    var phi_4032_: f32;
    var phi_4039_: f32;
    var phi_4125_: vec3<f32>;
    var phi_4126_: vec3<f32>;
    var phi_4127_: vec3<f32>;
    var phi_4136_: f32;
    var phi_4137_: f32;
    var phi_4147_: f32;
    var phi_4148_: f32;
    var phi_4158_: f32;
    var phi_4159_: f32;
    var phi_4194_: abi_Sample;
    var local_9: lt_bvh_Hit;
    var local_10: lt_bvh_Hit;
    var local_11: lt_bvh_Hit;
    var local_12: lt_bvh_Hit;

    let _e73 = id_1;
    let _e77 = arrayLength((&nodes.member));
    let _e80 = arrayLength((&triangles.member));
    let _e83 = arrayLength((&vertices.member));
    let _e86 = arrayLength((&materials.member));
    let _e92 = arrayLength((&instances.member));
    let _e95 = arrayLength((&alpha_texels.member));
    let _e98 = p.member.size[0u];
    let _e100 = p.member.size[1u];
    let _e101 = lt_shaders_entry_pixel_index(_e73, _e98, _e100);
    if (bitcast<i32>(_e101.word) != 0i) {
        let _e107 = p.member.root;
        let _e111 = p.member.eye;
        let _e114 = p.member.grid[0u];
        let _e116 = p.member.grid[1u];
        let _e135 = p.member.size[0u];
        let _e139 = ((((f32(_e73.x) + ((f32((_e73.y & (_e116 - 1u))) + 0.5f) / f32(_e116))) / f32(_e135)) * 2f) - 1f);
        let _e142 = p.member.size[1u];
        let _e146 = (1f - (((f32(_e73.y) + ((f32((_e73.x & (_e114 - 1u))) + 0.5f) / f32(_e114))) / f32(_e142)) * 2f));
        let _e148 = p.member.forward;
        let _e150 = p.member.right;
        let _e164 = p.member.up;
        let _e175 = _lt_bvh_ray_Ray_new(_e111, vec3<f32>(((_e148.x + (_e150.x * _e139)) + (_e164.x * _e146)), ((_e148.y + (_e150.y * _e139)) + (_e164.y * _e146)), ((_e148.z + (_e150.z * _e139)) + (_e164.z * _e146))));
        let _e177 = lt_bvh_Hit(_e175.tmax, 0f, 0f, 4294967295u, 4294967295u);
        let _e180 = abs(_e175.direction.x);
        let _e182 = abs(_e175.direction.y);
        let _e184 = abs(_e175.direction.z);
        if (abs(_e175.origin.x) < 1000000000000000f) {
            if (abs(_e175.origin.y) < 1000000000000000f) {
                phi_804_ = (abs(_e175.origin.z) < 1000000000000000f);
                phi_805_ = false;
            } else {
                phi_804_ = bool();
                phi_805_ = true;
            }
            let _e196 = phi_804_;
            let _e198 = phi_805_;
            phi_806_ = _e196;
            phi_807_ = _e198;
        } else {
            phi_806_ = bool();
            phi_807_ = true;
        }
        let _e200 = phi_806_;
        let _e202 = phi_807_;
        if _e202 {
            phi_811_ = false;
        } else {
            phi_811_ = _e200;
        }
        let _e204 = phi_811_;
        if _e204 {
            if (_e180 < 1000000000000000f) {
                if (_e182 < 1000000000000000f) {
                    phi_824_ = (_e184 < 1000000000000000f);
                    phi_825_ = false;
                } else {
                    phi_824_ = bool();
                    phi_825_ = true;
                }
                let _e209 = phi_824_;
                let _e211 = phi_825_;
                phi_826_ = _e209;
                phi_827_ = _e211;
            } else {
                phi_826_ = bool();
                phi_827_ = true;
            }
            let _e213 = phi_826_;
            let _e215 = phi_827_;
            if _e215 {
                phi_831_ = false;
            } else {
                phi_831_ = _e213;
            }
            let _e217 = phi_831_;
            if _e217 {
                if (_e180 > 0f) {
                    phi_845_ = bool();
                    phi_846_ = true;
                } else {
                    let _e219 = (_e182 > 0f);
                    if _e219 {
                        phi_844_ = bool();
                    } else {
                        phi_844_ = (_e184 > 0f);
                    }
                    let _e222 = phi_844_;
                    phi_845_ = _e222;
                    phi_846_ = _e219;
                }
                let _e224 = phi_845_;
                let _e226 = phi_846_;
                if _e226 {
                    phi_850_ = true;
                } else {
                    phi_850_ = _e224;
                }
                let _e228 = phi_850_;
                phi_851_ = _e228;
                phi_852_ = false;
            } else {
                phi_851_ = bool();
                phi_852_ = true;
            }
            let _e230 = phi_851_;
            let _e232 = phi_852_;
            phi_853_ = _e230;
            phi_854_ = _e232;
        } else {
            phi_853_ = bool();
            phi_854_ = true;
        }
        let _e234 = phi_853_;
        let _e236 = phi_854_;
        if _e236 {
            phi_858_ = false;
        } else {
            phi_858_ = _e234;
        }
        let _e238 = phi_858_;
        if _e238 {
            let _e239 = (_e107 >= _e77);
            if _e239 {
                phi_3490_ = lt_bvh_Hit();
            } else {
                if (_e107 < _e77) {
                } else {
                    return;
                }
                let _e245 = nodes.member[(0u + _e107)].frame[0u];
                let _e249 = nodes.member[(0u + _e107)].frame[1u];
                let _e253 = nodes.member[(0u + _e107)].frame[2u];
                let _e257 = nodes.member[(0u + _e107)].frame[0u];
                let _e261 = nodes.member[(0u + _e107)].frame[1u];
                let _e265 = nodes.member[(0u + _e107)].frame[2u];
                let _e269 = nodes.member[(0u + _e107)].frame[3u];
                let _e308 = core_intrinsics_maximum_number_nsz_f32_(abs(_e175.direction.x), abs(_e175.direction.y));
                let _e309 = core_intrinsics_maximum_number_nsz_f32_(_e308, abs(_e175.direction.z));
                let _e310 = (_e309 * 0.0000000000009094947f);
                if (abs(_e175.direction.x) < _e310) {
                    phi_934_ = _e310;
                } else {
                    phi_934_ = abs(_e175.direction.x);
                }
                let _e316 = phi_934_;
                if (_e175.direction.x < 0f) {
                    phi_941_ = (-1f / _e316);
                } else {
                    phi_941_ = (1f / _e316);
                }
                let _e321 = phi_941_;
                if (abs(_e175.direction.y) < _e310) {
                    phi_949_ = _e310;
                } else {
                    phi_949_ = abs(_e175.direction.y);
                }
                let _e327 = phi_949_;
                if (_e175.direction.y < 0f) {
                    phi_956_ = (-1f / _e327);
                } else {
                    phi_956_ = (1f / _e327);
                }
                let _e332 = phi_956_;
                if (abs(_e175.direction.z) < _e310) {
                    phi_964_ = _e310;
                } else {
                    phi_964_ = abs(_e175.direction.z);
                }
                let _e338 = phi_964_;
                if (_e175.direction.z < 0f) {
                    phi_971_ = (-1f / _e338);
                } else {
                    phi_971_ = (1f / _e338);
                }
                let _e343 = phi_971_;
                let _e350 = abs((bitcast<f32>(_e245) - _e175.origin.x));
                let _e351 = abs((bitcast<f32>(_e249) - _e175.origin.y));
                let _e352 = abs((bitcast<f32>(_e253) - _e175.origin.z));
                let _e359 = abs(((bitcast<f32>(_e257) + (bitcast<f32>((((_e269 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e175.origin.x));
                let _e360 = abs(((bitcast<f32>(_e261) + (bitcast<f32>((((_e269 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e175.origin.y));
                let _e361 = abs(((bitcast<f32>(_e265) + (bitcast<f32>((((_e269 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e175.origin.z));
                if (_e350 > _e359) {
                    phi_994_ = _e350;
                } else {
                    phi_994_ = _e359;
                }
                let _e364 = phi_994_;
                if (_e351 > _e360) {
                    phi_999_ = _e351;
                } else {
                    phi_999_ = _e360;
                }
                let _e367 = phi_999_;
                if (_e352 > _e361) {
                    phi_1004_ = _e352;
                } else {
                    phi_1004_ = _e361;
                }
                let _e370 = phi_1004_;
                if (_e364 > _e367) {
                    phi_1009_ = _e364;
                } else {
                    phi_1009_ = _e367;
                }
                let _e373 = phi_1009_;
                if (_e373 > _e370) {
                    phi_1014_ = _e373;
                } else {
                    phi_1014_ = _e370;
                }
                let _e376 = phi_1014_;
                let _e380 = (_e376 * 0.0000019073486f);
                let _e381 = (abs(_e321) * _e380);
                let _e382 = (abs(_e332) * _e380);
                let _e383 = (abs(_e343) * _e380);
                let _e387 = (_e376 * 0.0000009536743f);
                let _e388 = (abs(_e321) * _e387);
                let _e389 = (abs(_e332) * _e387);
                let _e390 = (abs(_e343) * _e387);
                if (_e321 < 0f) {
                    phi_1033_ = 0u;
                } else {
                    phi_1033_ = 1u;
                }
                let _e393 = phi_1033_;
                if (_e332 < 0f) {
                    phi_1038_ = 0u;
                } else {
                    phi_1038_ = 2u;
                }
                let _e396 = phi_1038_;
                if (_e343 < 0f) {
                    phi_1043_ = 0u;
                } else {
                    phi_1043_ = 4u;
                }
                let _e399 = phi_1043_;
                let _e401 = ((_e393 | _e396) | _e399);
                let _e402 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e107, 2147483648u);
                local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e402.first[0], _e402.first[1], _e402.first[2], _e402.first[3], _e402.first[4], _e402.first[5], _e402.first[6], _e402.first[7], _e402.first[8], _e402.first[9], _e402.first[10], _e402.first[11], _e402.first[12], _e402.first[13], _e402.first[14], _e402.first[15], _e402.first[16], _e402.first[17], _e402.first[18], _e402.first[19], _e402.first[20], _e402.first[21], _e402.first[22], _e402.first[23], _e402.first[24], _e402.first[25], _e402.first[26], _e402.first[27], _e402.first[28], _e402.first[29], _e402.first[30], _e402.first[31]), array<u32, 32>(_e402.mask[0], _e402.mask[1], _e402.mask[2], _e402.mask[3], _e402.mask[4], _e402.mask[5], _e402.mask[6], _e402.mask[7], _e402.mask[8], _e402.mask[9], _e402.mask[10], _e402.mask[11], _e402.mask[12], _e402.mask[13], _e402.mask[14], _e402.mask[15], _e402.mask[16], _e402.mask[17], _e402.mask[18], _e402.mask[19], _e402.mask[20], _e402.mask[21], _e402.mask[22], _e402.mask[23], _e402.mask[24], _e402.mask[25], _e402.mask[26], _e402.mask[27], _e402.mask[28], _e402.mask[29], _e402.mask[30], _e402.mask[31]), _e402.len, _e402.group, _e402.group_mask);
                let _e476 = local_2.group_mask;
                if ((_e476 & 4278190080u) == 0u) {
                    let _e480 = local_2.len;
                    if (_e480 == 0u) {
                        phi_1157_ = false;
                    } else {
                        let _e484 = local_2.len;
                        local_2.len = (_e484 - 1u);
                        let _e487 = local_2.len;
                        if (_e487 < 32u) {
                        } else {
                            return;
                        }
                        let _e492 = local_2.first[(0u + _e487)];
                        local_2.group = _e492;
                        let _e495 = local_2.len;
                        if (_e495 < 32u) {
                        } else {
                            return;
                        }
                        let _e500 = local_2.mask[(0u + _e495)];
                        local_2.group_mask = _e500;
                        phi_1157_ = true;
                    }
                    let _e503 = phi_1157_;
                    phi_1158_ = _e503;
                } else {
                    phi_1158_ = true;
                }
                let _e505 = phi_1158_;
                if _e505 {
                    let _e507 = local_2.group_mask;
                    let _e513 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e507)), 32u, (_e507 == 0u)));
                    let _e517 = local_2.group_mask;
                    let _e531 = local_2.group_mask;
                    local_2.group_mask = (_e531 & ~((1u << bitcast<u32>((_e513 & 31u)))));
                    let _e534 = local_2.group;
                    phi_1189_ = (_e534 + countOneBits(((_e517 & ~((4294967295u << bitcast<u32>((((_e513 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1189_ = 4294967295u;
                }
                let _e537 = phi_1189_;
                phi_1191_ = _e537;
                phi_1194_ = _e177;
                loop {
                    let _e539 = phi_1191_;
                    let _e541 = phi_1194_;
                    local_12 = _e541;
                    let _e542 = (_e539 != 4294967295u);
                    if _e542 {
                        if (_e539 < _e77) {
                        } else {
                            return;
                        }
                        let _e550 = nodes.member[(0u + _e539)].frame[3u];
                        let _e575 = (bitcast<f32>((((_e550 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e321);
                        let _e576 = (bitcast<f32>((((_e550 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e332);
                        let _e577 = (bitcast<f32>((((_e550 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e343);
                        let _e580 = nodes.member[(0u + _e539)].frame[0u];
                        let _e584 = nodes.member[(0u + _e539)].frame[1u];
                        let _e588 = nodes.member[(0u + _e539)].frame[2u];
                        let _e596 = ((bitcast<f32>(_e580) - _e175.origin.x) * _e321);
                        let _e597 = ((bitcast<f32>(_e584) - _e175.origin.y) * _e332);
                        let _e598 = ((bitcast<f32>(_e588) - _e175.origin.z) * _e343);
                        let _e606 = nodes.member[(0u + _e539)].x;
                        if (_e321 < 0f) {
                            let _e617 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e606.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e623 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e617.unnamed.word, _e606.w), _e617.unnamed_1);
                            let _e629 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e623.unnamed, lt_mask_LightPlace(_e606.x, _e623.unnamed_1.shift));
                            phi_1279_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e629.unnamed, lt_mask_LightPlace(_e629.unnamed_1.word, _e606.y));
                        } else {
                            let _e645 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e606.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e651 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e645.unnamed.word, _e606.y), _e645.unnamed_1);
                            let _e657 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e651.unnamed, lt_mask_LightPlace(_e606.z, _e651.unnamed_1.shift));
                            phi_1279_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e657.unnamed, lt_mask_LightPlace(_e657.unnamed_1.word, _e606.w));
                        }
                        let _e665 = phi_1279_;
                        let _e675 = nodes.member[(0u + _e539)].y;
                        if (_e332 < 0f) {
                            let _e686 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e675.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e692 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e686.unnamed.word, _e675.w), _e686.unnamed_1);
                            let _e698 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e692.unnamed, lt_mask_LightPlace(_e675.x, _e692.unnamed_1.shift));
                            phi_1306_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e698.unnamed, lt_mask_LightPlace(_e698.unnamed_1.word, _e675.y));
                        } else {
                            let _e714 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e675.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e720 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e714.unnamed.word, _e675.y), _e714.unnamed_1);
                            let _e726 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e720.unnamed, lt_mask_LightPlace(_e675.z, _e720.unnamed_1.shift));
                            phi_1306_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e726.unnamed, lt_mask_LightPlace(_e726.unnamed_1.word, _e675.w));
                        }
                        let _e734 = phi_1306_;
                        let _e744 = nodes.member[(0u + _e539)].z;
                        if (_e343 < 0f) {
                            let _e755 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e744.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e761 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e755.unnamed.word, _e744.w), _e755.unnamed_1);
                            let _e767 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e761.unnamed, lt_mask_LightPlace(_e744.x, _e761.unnamed_1.shift));
                            phi_1333_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e767.unnamed, lt_mask_LightPlace(_e767.unnamed_1.word, _e744.y));
                        } else {
                            let _e783 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e744.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e789 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e783.unnamed.word, _e744.y), _e783.unnamed_1);
                            let _e795 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e789.unnamed, lt_mask_LightPlace(_e744.z, _e789.unnamed_1.shift));
                            phi_1333_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e795.unnamed, lt_mask_LightPlace(_e795.unnamed_1.word, _e744.w));
                        }
                        let _e803 = phi_1333_;
                        phi_1339_ = 0u;
                        phi_1342_ = 0u;
                        loop {
                            let _e813 = phi_1339_;
                            let _e815 = phi_1342_;
                            local_3 = _e815;
                            local_4 = _e815;
                            local_5 = _e815;
                            let _e816 = (_e813 < 8u);
                            if _e816 {
                                let _e818 = (_e813 >> bitcast<u32>(2i));
                                let _e819 = (_e813 & 3u);
                                if (_e818 == 0u) {
                                    phi_1356_ = _e665.unnamed.word;
                                } else {
                                    phi_1356_ = _e665.unnamed.shift;
                                }
                                let _e822 = phi_1356_;
                                if (_e818 == 0u) {
                                    phi_1366_ = _e734.unnamed.word;
                                } else {
                                    phi_1366_ = _e734.unnamed.shift;
                                }
                                let _e831 = phi_1366_;
                                if (_e818 == 0u) {
                                    phi_1376_ = _e803.unnamed.word;
                                } else {
                                    phi_1376_ = _e803.unnamed.shift;
                                }
                                let _e840 = phi_1376_;
                                let _e853 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e822 >> bitcast<u32>(((_e819 * 8u) & 31u))) & 255u)) * _e575) + (_e596 - _e381)), ((f32(((_e831 >> bitcast<u32>(((_e819 * 8u) & 31u))) & 255u)) * _e576) + (_e597 - _e382)));
                                let _e854 = core_intrinsics_maximum_number_nsz_f32_(_e853, ((f32(((_e840 >> bitcast<u32>(((_e819 * 8u) & 31u))) & 255u)) * _e577) + (_e598 - _e383)));
                                if (_e818 == 0u) {
                                    phi_1394_ = _e665.unnamed_1.word;
                                } else {
                                    phi_1394_ = _e665.unnamed_1.shift;
                                }
                                let _e857 = phi_1394_;
                                if (_e818 == 0u) {
                                    phi_1404_ = _e734.unnamed_1.word;
                                } else {
                                    phi_1404_ = _e734.unnamed_1.shift;
                                }
                                let _e866 = phi_1404_;
                                if (_e818 == 0u) {
                                    phi_1414_ = _e803.unnamed_1.word;
                                } else {
                                    phi_1414_ = _e803.unnamed_1.shift;
                                }
                                let _e875 = phi_1414_;
                                let _e888 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e857 >> bitcast<u32>(((_e819 * 8u) & 31u))) & 255u)) * _e575) + (_e596 + _e381)), ((f32(((_e866 >> bitcast<u32>(((_e819 * 8u) & 31u))) & 255u)) * _e576) + (_e597 + _e382)));
                                let _e889 = core_intrinsics_minimum_number_nsz_f32_(_e888, ((f32(((_e875 >> bitcast<u32>(((_e819 * 8u) & 31u))) & 255u)) * _e577) + (_e598 + _e383)));
                                if (_e854 <= _e889) {
                                    if (_e854 <= _e541.t) {
                                        if (_e889 >= _e175.tmin) {
                                            if (_e818 == 0u) {
                                                let _e896 = nodes.member[(0u + _e539)].links[2u];
                                                phi_1450_ = _e896;
                                            } else {
                                                let _e899 = nodes.member[(0u + _e539)].links[3u];
                                                phi_1450_ = _e899;
                                            }
                                            let _e901 = phi_1450_;
                                            let _e906 = ((_e901 >> bitcast<u32>(((_e819 * 8u) & 31u))) & 255u);
                                            let _e907 = (_e906 & 31u);
                                            if (_e907 >= 24u) {
                                                phi_1463_ = (24u + ((_e907 - 24u) ^ _e401));
                                            } else {
                                                phi_1463_ = _e907;
                                            }
                                            let _e913 = phi_1463_;
                                            phi_1468_ = (_e815 | ((_e906 >> bitcast<u32>(5i)) << bitcast<u32>((_e913 & 31u))));
                                        } else {
                                            phi_1468_ = _e815;
                                        }
                                        let _e921 = phi_1468_;
                                        phi_1469_ = _e921;
                                    } else {
                                        phi_1469_ = _e815;
                                    }
                                    let _e923 = phi_1469_;
                                    phi_1470_ = _e923;
                                } else {
                                    phi_1470_ = _e815;
                                }
                                let _e925 = phi_1470_;
                                phi_1340_ = (_e813 + 1u);
                                phi_1343_ = _e925;
                            } else {
                                phi_1340_ = u32();
                                phi_1343_ = u32();
                            }
                            let _e928 = phi_1340_;
                            let _e930 = phi_1343_;
                            continue;
                            continuing {
                                phi_1339_ = _e928;
                                phi_1342_ = _e930;
                                break if !(_e816);
                            }
                        }
                        let _e934 = nodes.member[(0u + _e539)].links[0u];
                        let _e938 = nodes.member[(0u + _e539)].frame[3u];
                        let _e942 = local_3;
                        if ((_e942 & 4278190080u) == 0u) {
                        } else {
                            let _e946 = local_2.group_mask;
                            if ((_e946 & 4278190080u) == 0u) {
                            } else {
                                let _e950 = local_2.len;
                                if (_e950 < 32u) {
                                    let _e953 = local_2.group;
                                    let _e955 = local_2.len;
                                    if (_e955 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.first[(0u + _e955)] = _e953;
                                    let _e961 = local_2.group_mask;
                                    let _e963 = local_2.len;
                                    if (_e963 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.mask[(0u + _e963)] = _e961;
                                    let _e970 = local_2.len;
                                    local_2.len = (_e970 + 1u);
                                }
                            }
                            local_2.group = (_e107 + _e934);
                            let _e974 = local_4;
                            local_2.group_mask = ((_e974 & 4278190080u) | (_e938 >> bitcast<u32>(24i)));
                        }
                        let _e979 = local_5;
                        phi_1528_ = (_e979 & 16777215u);
                        phi_1531_ = _e541;
                        loop {
                            let _e982 = phi_1528_;
                            let _e984 = phi_1531_;
                            local_11 = _e984;
                            if (_e982 == 0u) {
                                phi_1529_ = u32();
                                phi_1532_ = lt_bvh_Hit();
                                phi_3418_ = false;
                            } else {
                                let _e988 = nodes.member[(0u + _e539)].links[1u];
                                let _e992 = (_e988 + select(firstTrailingBit(_e982), 32u, (_e982 == 0u)));
                                if (_e992 < _e92) {
                                } else {
                                    return;
                                }
                                let _e999 = instances.member[(0u + _e992)].low_world;
                                let _e1001 = instances.member[(0u + _e992)].high_world;
                                let _e1011 = ((_e999.x - _e175.origin.x) * _e321);
                                let _e1012 = ((_e999.y - _e175.origin.y) * _e332);
                                let _e1013 = ((_e999.z - _e175.origin.z) * _e343);
                                let _e1023 = ((_e1001.x - _e175.origin.x) * _e321);
                                let _e1024 = ((_e1001.y - _e175.origin.y) * _e332);
                                let _e1025 = ((_e1001.z - _e175.origin.z) * _e343);
                                if (_e1011 < _e1023) {
                                    phi_1586_ = _e1011;
                                } else {
                                    phi_1586_ = _e1023;
                                }
                                let _e1028 = phi_1586_;
                                if (_e1012 < _e1024) {
                                    phi_1591_ = _e1012;
                                } else {
                                    phi_1591_ = _e1024;
                                }
                                let _e1031 = phi_1591_;
                                if (_e1013 < _e1025) {
                                    phi_1596_ = _e1013;
                                } else {
                                    phi_1596_ = _e1025;
                                }
                                let _e1034 = phi_1596_;
                                if (_e1011 > _e1023) {
                                    phi_1604_ = _e1011;
                                } else {
                                    phi_1604_ = _e1023;
                                }
                                let _e1040 = phi_1604_;
                                if (_e1012 > _e1024) {
                                    phi_1609_ = _e1012;
                                } else {
                                    phi_1609_ = _e1024;
                                }
                                let _e1043 = phi_1609_;
                                if (_e1013 > _e1025) {
                                    phi_1614_ = _e1013;
                                } else {
                                    phi_1614_ = _e1025;
                                }
                                let _e1046 = phi_1614_;
                                let _e1050 = core_intrinsics_maximum_number_nsz_f32_((_e1028 - _e388), (_e1031 - _e389));
                                let _e1051 = core_intrinsics_maximum_number_nsz_f32_(_e1050, (_e1034 - _e390));
                                let _e1052 = core_intrinsics_minimum_number_nsz_f32_((_e1040 + _e388), (_e1043 + _e389));
                                let _e1053 = core_intrinsics_minimum_number_nsz_f32_(_e1052, (_e1046 + _e390));
                                if (_e1051 <= _e1053) {
                                    if (_e1051 <= _e984.t) {
                                        if (_e1053 >= _e175.tmin) {
                                            let _e1065 = instances.member[(0u + _e992)].world_to_object[0u];
                                            let _e1076 = ((((_e1065.x * _e175.origin.x) + (_e1065.y * _e175.origin.y)) + (_e1065.z * _e175.origin.z)) + (_e1065.w * 1f));
                                            let _e1078 = instances.member[(0u + _e992)].world_to_object[1u];
                                            let _e1089 = ((((_e1078.x * _e175.origin.x) + (_e1078.y * _e175.origin.y)) + (_e1078.z * _e175.origin.z)) + (_e1078.w * 1f));
                                            let _e1091 = instances.member[(0u + _e992)].world_to_object[2u];
                                            let _e1102 = ((((_e1091.x * _e175.origin.x) + (_e1091.y * _e175.origin.y)) + (_e1091.z * _e175.origin.z)) + (_e1091.w * 1f));
                                            let _e1109 = instances.member[(0u + _e992)].world_to_object[0u];
                                            let _e1120 = ((((_e1109.x * _e175.direction.x) + (_e1109.y * _e175.direction.y)) + (_e1109.z * _e175.direction.z)) + (_e1109.w * 0f));
                                            let _e1122 = instances.member[(0u + _e992)].world_to_object[1u];
                                            let _e1133 = ((((_e1122.x * _e175.direction.x) + (_e1122.y * _e175.direction.y)) + (_e1122.z * _e175.direction.z)) + (_e1122.w * 0f));
                                            let _e1135 = instances.member[(0u + _e992)].world_to_object[2u];
                                            let _e1146 = ((((_e1135.x * _e175.direction.x) + (_e1135.y * _e175.direction.y)) + (_e1135.z * _e175.direction.z)) + (_e1135.w * 0f));
                                            let _e1151 = instances.member[(0u + _e992)].root;
                                            let _e1153 = instances.member[(0u + _e992)].first_triangle;
                                            let _e1154 = abs(_e1120);
                                            let _e1155 = abs(_e1133);
                                            let _e1156 = abs(_e1146);
                                            if (abs(_e1076) < 1000000000000000f) {
                                                if (abs(_e1089) < 1000000000000000f) {
                                                    phi_1746_ = (abs(_e1102) < 1000000000000000f);
                                                    phi_1747_ = false;
                                                } else {
                                                    phi_1746_ = bool();
                                                    phi_1747_ = true;
                                                }
                                                let _e1164 = phi_1746_;
                                                let _e1166 = phi_1747_;
                                                phi_1748_ = _e1164;
                                                phi_1749_ = _e1166;
                                            } else {
                                                phi_1748_ = bool();
                                                phi_1749_ = true;
                                            }
                                            let _e1168 = phi_1748_;
                                            let _e1170 = phi_1749_;
                                            if _e1170 {
                                                phi_1753_ = false;
                                            } else {
                                                phi_1753_ = _e1168;
                                            }
                                            let _e1172 = phi_1753_;
                                            if _e1172 {
                                                if (_e1154 < 1000000000000000f) {
                                                    if (_e1155 < 1000000000000000f) {
                                                        phi_1766_ = (_e1156 < 1000000000000000f);
                                                        phi_1767_ = false;
                                                    } else {
                                                        phi_1766_ = bool();
                                                        phi_1767_ = true;
                                                    }
                                                    let _e1177 = phi_1766_;
                                                    let _e1179 = phi_1767_;
                                                    phi_1768_ = _e1177;
                                                    phi_1769_ = _e1179;
                                                } else {
                                                    phi_1768_ = bool();
                                                    phi_1769_ = true;
                                                }
                                                let _e1181 = phi_1768_;
                                                let _e1183 = phi_1769_;
                                                if _e1183 {
                                                    phi_1773_ = false;
                                                } else {
                                                    phi_1773_ = _e1181;
                                                }
                                                let _e1185 = phi_1773_;
                                                if _e1185 {
                                                    if (_e1154 > 0f) {
                                                        phi_1787_ = bool();
                                                        phi_1788_ = true;
                                                    } else {
                                                        let _e1187 = (_e1155 > 0f);
                                                        if _e1187 {
                                                            phi_1786_ = bool();
                                                        } else {
                                                            phi_1786_ = (_e1156 > 0f);
                                                        }
                                                        let _e1190 = phi_1786_;
                                                        phi_1787_ = _e1190;
                                                        phi_1788_ = _e1187;
                                                    }
                                                    let _e1192 = phi_1787_;
                                                    let _e1194 = phi_1788_;
                                                    if _e1194 {
                                                        phi_1792_ = true;
                                                    } else {
                                                        phi_1792_ = _e1192;
                                                    }
                                                    let _e1196 = phi_1792_;
                                                    phi_1793_ = _e1196;
                                                    phi_1794_ = false;
                                                } else {
                                                    phi_1793_ = bool();
                                                    phi_1794_ = true;
                                                }
                                                let _e1198 = phi_1793_;
                                                let _e1200 = phi_1794_;
                                                phi_1795_ = _e1198;
                                                phi_1796_ = _e1200;
                                            } else {
                                                phi_1795_ = bool();
                                                phi_1796_ = true;
                                            }
                                            let _e1202 = phi_1795_;
                                            let _e1204 = phi_1796_;
                                            if _e1204 {
                                                phi_1800_ = false;
                                            } else {
                                                phi_1800_ = _e1202;
                                            }
                                            let _e1206 = phi_1800_;
                                            if _e1206 {
                                                let _e1207 = (_e1151 >= _e77);
                                                if _e1207 {
                                                    phi_3408_ = lt_bvh_Hit();
                                                } else {
                                                    if (_e1151 < _e77) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1213 = nodes.member[(0u + _e1151)].frame[0u];
                                                    let _e1217 = nodes.member[(0u + _e1151)].frame[1u];
                                                    let _e1221 = nodes.member[(0u + _e1151)].frame[2u];
                                                    let _e1225 = nodes.member[(0u + _e1151)].frame[0u];
                                                    let _e1229 = nodes.member[(0u + _e1151)].frame[1u];
                                                    let _e1233 = nodes.member[(0u + _e1151)].frame[2u];
                                                    let _e1237 = nodes.member[(0u + _e1151)].frame[3u];
                                                    let _e1271 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1120), abs(_e1133));
                                                    let _e1272 = core_intrinsics_maximum_number_nsz_f32_(_e1271, abs(_e1146));
                                                    let _e1273 = (_e1272 * 0.0000000000009094947f);
                                                    if (abs(_e1120) < _e1273) {
                                                        phi_1870_ = _e1273;
                                                    } else {
                                                        phi_1870_ = abs(_e1120);
                                                    }
                                                    let _e1278 = phi_1870_;
                                                    if (_e1120 < 0f) {
                                                        phi_1877_ = (-1f / _e1278);
                                                    } else {
                                                        phi_1877_ = (1f / _e1278);
                                                    }
                                                    let _e1283 = phi_1877_;
                                                    if (abs(_e1133) < _e1273) {
                                                        phi_1884_ = _e1273;
                                                    } else {
                                                        phi_1884_ = abs(_e1133);
                                                    }
                                                    let _e1288 = phi_1884_;
                                                    if (_e1133 < 0f) {
                                                        phi_1891_ = (-1f / _e1288);
                                                    } else {
                                                        phi_1891_ = (1f / _e1288);
                                                    }
                                                    let _e1293 = phi_1891_;
                                                    if (abs(_e1146) < _e1273) {
                                                        phi_1898_ = _e1273;
                                                    } else {
                                                        phi_1898_ = abs(_e1146);
                                                    }
                                                    let _e1298 = phi_1898_;
                                                    if (_e1146 < 0f) {
                                                        phi_1905_ = (-1f / _e1298);
                                                    } else {
                                                        phi_1905_ = (1f / _e1298);
                                                    }
                                                    let _e1303 = phi_1905_;
                                                    let _e1307 = abs((bitcast<f32>(_e1213) - _e1076));
                                                    let _e1308 = abs((bitcast<f32>(_e1217) - _e1089));
                                                    let _e1309 = abs((bitcast<f32>(_e1221) - _e1102));
                                                    let _e1313 = abs(((bitcast<f32>(_e1225) + (bitcast<f32>((((_e1237 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1076));
                                                    let _e1314 = abs(((bitcast<f32>(_e1229) + (bitcast<f32>((((_e1237 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1089));
                                                    let _e1315 = abs(((bitcast<f32>(_e1233) + (bitcast<f32>((((_e1237 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1102));
                                                    if (_e1307 > _e1313) {
                                                        phi_1922_ = _e1307;
                                                    } else {
                                                        phi_1922_ = _e1313;
                                                    }
                                                    let _e1318 = phi_1922_;
                                                    if (_e1308 > _e1314) {
                                                        phi_1927_ = _e1308;
                                                    } else {
                                                        phi_1927_ = _e1314;
                                                    }
                                                    let _e1321 = phi_1927_;
                                                    if (_e1309 > _e1315) {
                                                        phi_1932_ = _e1309;
                                                    } else {
                                                        phi_1932_ = _e1315;
                                                    }
                                                    let _e1324 = phi_1932_;
                                                    if (_e1318 > _e1321) {
                                                        phi_1937_ = _e1318;
                                                    } else {
                                                        phi_1937_ = _e1321;
                                                    }
                                                    let _e1327 = phi_1937_;
                                                    if (_e1327 > _e1324) {
                                                        phi_1942_ = _e1327;
                                                    } else {
                                                        phi_1942_ = _e1324;
                                                    }
                                                    let _e1330 = phi_1942_;
                                                    let _e1334 = (_e1330 * 0.0000019073486f);
                                                    let _e1335 = (abs(_e1283) * _e1334);
                                                    let _e1336 = (abs(_e1293) * _e1334);
                                                    let _e1337 = (abs(_e1303) * _e1334);
                                                    let _e1341 = (_e1330 * 0.0000009536743f);
                                                    let _e1342 = (abs(_e1283) * _e1341);
                                                    let _e1343 = (abs(_e1293) * _e1341);
                                                    let _e1344 = (abs(_e1303) * _e1341);
                                                    let _e1345 = abs(_e1120);
                                                    let _e1346 = abs(_e1133);
                                                    let _e1347 = abs(_e1146);
                                                    if (_e1345 >= _e1346) {
                                                        if (_e1345 >= _e1347) {
                                                            phi_1968_ = false;
                                                        } else {
                                                            phi_1968_ = true;
                                                        }
                                                        let _e1351 = phi_1968_;
                                                        phi_1969_ = _e1351;
                                                    } else {
                                                        phi_1969_ = true;
                                                    }
                                                    let _e1353 = phi_1969_;
                                                    if _e1353 {
                                                        if (_e1346 >= _e1347) {
                                                            phi_1977_ = 1u;
                                                        } else {
                                                            phi_1977_ = 2u;
                                                        }
                                                        let _e1356 = phi_1977_;
                                                        phi_1978_ = _e1356;
                                                    } else {
                                                        phi_1978_ = 0u;
                                                    }
                                                    let _e1358 = phi_1978_;
                                                    if (_e1358 == 0u) {
                                                        phi_1990_ = vec3<f32>(_e1133, _e1146, _e1120);
                                                    } else {
                                                        if (_e1358 == 1u) {
                                                            phi_1989_ = vec3<f32>(_e1146, _e1120, _e1133);
                                                        } else {
                                                            phi_1989_ = vec3<f32>(_e1120, _e1133, _e1146);
                                                        }
                                                        let _e1364 = phi_1989_;
                                                        phi_1990_ = _e1364;
                                                    }
                                                    let _e1366 = phi_1990_;
                                                    let _e1369 = (_e1366.x / _e1366.z);
                                                    let _e1372 = (_e1366.y / _e1366.z);
                                                    if (_e1283 < 0f) {
                                                        phi_2003_ = 0u;
                                                    } else {
                                                        phi_2003_ = 1u;
                                                    }
                                                    let _e1377 = phi_2003_;
                                                    if (_e1293 < 0f) {
                                                        phi_2008_ = 0u;
                                                    } else {
                                                        phi_2008_ = 2u;
                                                    }
                                                    let _e1380 = phi_2008_;
                                                    if (_e1303 < 0f) {
                                                        phi_2013_ = 0u;
                                                    } else {
                                                        phi_2013_ = 4u;
                                                    }
                                                    let _e1383 = phi_2013_;
                                                    let _e1385 = ((_e1377 | _e1380) | _e1383);
                                                    let _e1386 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1151, 2147483648u);
                                                    local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e1386.first[0], _e1386.first[1], _e1386.first[2], _e1386.first[3], _e1386.first[4], _e1386.first[5], _e1386.first[6], _e1386.first[7], _e1386.first[8], _e1386.first[9], _e1386.first[10], _e1386.first[11], _e1386.first[12], _e1386.first[13], _e1386.first[14], _e1386.first[15], _e1386.first[16], _e1386.first[17], _e1386.first[18], _e1386.first[19], _e1386.first[20], _e1386.first[21], _e1386.first[22], _e1386.first[23], _e1386.first[24], _e1386.first[25], _e1386.first[26], _e1386.first[27], _e1386.first[28], _e1386.first[29], _e1386.first[30], _e1386.first[31]), array<u32, 32>(_e1386.mask[0], _e1386.mask[1], _e1386.mask[2], _e1386.mask[3], _e1386.mask[4], _e1386.mask[5], _e1386.mask[6], _e1386.mask[7], _e1386.mask[8], _e1386.mask[9], _e1386.mask[10], _e1386.mask[11], _e1386.mask[12], _e1386.mask[13], _e1386.mask[14], _e1386.mask[15], _e1386.mask[16], _e1386.mask[17], _e1386.mask[18], _e1386.mask[19], _e1386.mask[20], _e1386.mask[21], _e1386.mask[22], _e1386.mask[23], _e1386.mask[24], _e1386.mask[25], _e1386.mask[26], _e1386.mask[27], _e1386.mask[28], _e1386.mask[29], _e1386.mask[30], _e1386.mask[31]), _e1386.len, _e1386.group, _e1386.group_mask);
                                                    let _e1460 = local_1.group_mask;
                                                    if ((_e1460 & 4278190080u) == 0u) {
                                                        let _e1464 = local_1.len;
                                                        if (_e1464 == 0u) {
                                                            phi_2127_ = false;
                                                        } else {
                                                            let _e1468 = local_1.len;
                                                            local_1.len = (_e1468 - 1u);
                                                            let _e1471 = local_1.len;
                                                            if (_e1471 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1476 = local_1.first[(0u + _e1471)];
                                                            local_1.group = _e1476;
                                                            let _e1479 = local_1.len;
                                                            if (_e1479 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1484 = local_1.mask[(0u + _e1479)];
                                                            local_1.group_mask = _e1484;
                                                            phi_2127_ = true;
                                                        }
                                                        let _e1487 = phi_2127_;
                                                        phi_2128_ = _e1487;
                                                    } else {
                                                        phi_2128_ = true;
                                                    }
                                                    let _e1489 = phi_2128_;
                                                    if _e1489 {
                                                        let _e1491 = local_1.group_mask;
                                                        let _e1497 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1491)), 32u, (_e1491 == 0u)));
                                                        let _e1501 = local_1.group_mask;
                                                        let _e1515 = local_1.group_mask;
                                                        local_1.group_mask = (_e1515 & ~((1u << bitcast<u32>((_e1497 & 31u)))));
                                                        let _e1518 = local_1.group;
                                                        phi_2159_ = (_e1518 + countOneBits(((_e1501 & ~((4294967295u << bitcast<u32>((((_e1497 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_2159_ = 4294967295u;
                                                    }
                                                    let _e1521 = phi_2159_;
                                                    phi_2161_ = _e984;
                                                    phi_2164_ = _e1521;
                                                    loop {
                                                        let _e1523 = phi_2161_;
                                                        let _e1525 = phi_2164_;
                                                        local_10 = _e1523;
                                                        let _e1526 = (_e1525 != 4294967295u);
                                                        if _e1526 {
                                                            if (_e1525 < _e77) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1533 = nodes.member[(0u + _e1525)].frame[3u];
                                                            let _e1558 = (bitcast<f32>((((_e1533 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1283);
                                                            let _e1559 = (bitcast<f32>((((_e1533 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1293);
                                                            let _e1560 = (bitcast<f32>((((_e1533 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1303);
                                                            let _e1563 = nodes.member[(0u + _e1525)].frame[0u];
                                                            let _e1567 = nodes.member[(0u + _e1525)].frame[1u];
                                                            let _e1571 = nodes.member[(0u + _e1525)].frame[2u];
                                                            let _e1576 = ((bitcast<f32>(_e1563) - _e1076) * _e1283);
                                                            let _e1577 = ((bitcast<f32>(_e1567) - _e1089) * _e1293);
                                                            let _e1578 = ((bitcast<f32>(_e1571) - _e1102) * _e1303);
                                                            let _e1586 = nodes.member[(0u + _e1525)].x;
                                                            if (_e1283 < 0f) {
                                                                let _e1597 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1586.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1603 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1597.unnamed.word, _e1586.w), _e1597.unnamed_1);
                                                                let _e1609 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1603.unnamed, lt_mask_LightPlace(_e1586.x, _e1603.unnamed_1.shift));
                                                                phi_2245_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1609.unnamed, lt_mask_LightPlace(_e1609.unnamed_1.word, _e1586.y));
                                                            } else {
                                                                let _e1625 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1586.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1631 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1625.unnamed.word, _e1586.y), _e1625.unnamed_1);
                                                                let _e1637 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1631.unnamed, lt_mask_LightPlace(_e1586.z, _e1631.unnamed_1.shift));
                                                                phi_2245_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1637.unnamed, lt_mask_LightPlace(_e1637.unnamed_1.word, _e1586.w));
                                                            }
                                                            let _e1645 = phi_2245_;
                                                            let _e1655 = nodes.member[(0u + _e1525)].y;
                                                            if (_e1293 < 0f) {
                                                                let _e1666 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1655.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1672 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1666.unnamed.word, _e1655.w), _e1666.unnamed_1);
                                                                let _e1678 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1672.unnamed, lt_mask_LightPlace(_e1655.x, _e1672.unnamed_1.shift));
                                                                phi_2272_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1678.unnamed, lt_mask_LightPlace(_e1678.unnamed_1.word, _e1655.y));
                                                            } else {
                                                                let _e1694 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1655.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1700 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1694.unnamed.word, _e1655.y), _e1694.unnamed_1);
                                                                let _e1706 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1700.unnamed, lt_mask_LightPlace(_e1655.z, _e1700.unnamed_1.shift));
                                                                phi_2272_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1706.unnamed, lt_mask_LightPlace(_e1706.unnamed_1.word, _e1655.w));
                                                            }
                                                            let _e1714 = phi_2272_;
                                                            let _e1724 = nodes.member[(0u + _e1525)].z;
                                                            if (_e1303 < 0f) {
                                                                let _e1735 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1724.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1741 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1735.unnamed.word, _e1724.w), _e1735.unnamed_1);
                                                                let _e1747 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1741.unnamed, lt_mask_LightPlace(_e1724.x, _e1741.unnamed_1.shift));
                                                                phi_2299_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1747.unnamed, lt_mask_LightPlace(_e1747.unnamed_1.word, _e1724.y));
                                                            } else {
                                                                let _e1763 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1724.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1769 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1763.unnamed.word, _e1724.y), _e1763.unnamed_1);
                                                                let _e1775 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1769.unnamed, lt_mask_LightPlace(_e1724.z, _e1769.unnamed_1.shift));
                                                                phi_2299_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1775.unnamed, lt_mask_LightPlace(_e1775.unnamed_1.word, _e1724.w));
                                                            }
                                                            let _e1783 = phi_2299_;
                                                            phi_2305_ = 0u;
                                                            phi_2308_ = 0u;
                                                            loop {
                                                                let _e1793 = phi_2305_;
                                                                let _e1795 = phi_2308_;
                                                                local_6 = _e1795;
                                                                local_7 = _e1795;
                                                                local_8 = _e1795;
                                                                let _e1796 = (_e1793 < 8u);
                                                                if _e1796 {
                                                                    let _e1798 = (_e1793 >> bitcast<u32>(2i));
                                                                    let _e1799 = (_e1793 & 3u);
                                                                    if (_e1798 == 0u) {
                                                                        phi_2322_ = _e1645.unnamed.word;
                                                                    } else {
                                                                        phi_2322_ = _e1645.unnamed.shift;
                                                                    }
                                                                    let _e1802 = phi_2322_;
                                                                    if (_e1798 == 0u) {
                                                                        phi_2332_ = _e1714.unnamed.word;
                                                                    } else {
                                                                        phi_2332_ = _e1714.unnamed.shift;
                                                                    }
                                                                    let _e1811 = phi_2332_;
                                                                    if (_e1798 == 0u) {
                                                                        phi_2342_ = _e1783.unnamed.word;
                                                                    } else {
                                                                        phi_2342_ = _e1783.unnamed.shift;
                                                                    }
                                                                    let _e1820 = phi_2342_;
                                                                    let _e1833 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1802 >> bitcast<u32>(((_e1799 * 8u) & 31u))) & 255u)) * _e1558) + (_e1576 - _e1335)), ((f32(((_e1811 >> bitcast<u32>(((_e1799 * 8u) & 31u))) & 255u)) * _e1559) + (_e1577 - _e1336)));
                                                                    let _e1834 = core_intrinsics_maximum_number_nsz_f32_(_e1833, ((f32(((_e1820 >> bitcast<u32>(((_e1799 * 8u) & 31u))) & 255u)) * _e1560) + (_e1578 - _e1337)));
                                                                    if (_e1798 == 0u) {
                                                                        phi_2360_ = _e1645.unnamed_1.word;
                                                                    } else {
                                                                        phi_2360_ = _e1645.unnamed_1.shift;
                                                                    }
                                                                    let _e1837 = phi_2360_;
                                                                    if (_e1798 == 0u) {
                                                                        phi_2370_ = _e1714.unnamed_1.word;
                                                                    } else {
                                                                        phi_2370_ = _e1714.unnamed_1.shift;
                                                                    }
                                                                    let _e1846 = phi_2370_;
                                                                    if (_e1798 == 0u) {
                                                                        phi_2380_ = _e1783.unnamed_1.word;
                                                                    } else {
                                                                        phi_2380_ = _e1783.unnamed_1.shift;
                                                                    }
                                                                    let _e1855 = phi_2380_;
                                                                    let _e1868 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1837 >> bitcast<u32>(((_e1799 * 8u) & 31u))) & 255u)) * _e1558) + (_e1576 + _e1335)), ((f32(((_e1846 >> bitcast<u32>(((_e1799 * 8u) & 31u))) & 255u)) * _e1559) + (_e1577 + _e1336)));
                                                                    let _e1869 = core_intrinsics_minimum_number_nsz_f32_(_e1868, ((f32(((_e1855 >> bitcast<u32>(((_e1799 * 8u) & 31u))) & 255u)) * _e1560) + (_e1578 + _e1337)));
                                                                    if (_e1834 <= _e1869) {
                                                                        if (_e1834 <= _e1523.t) {
                                                                            if (_e1869 >= _e175.tmin) {
                                                                                if (_e1798 == 0u) {
                                                                                    let _e1876 = nodes.member[(0u + _e1525)].links[2u];
                                                                                    phi_2416_ = _e1876;
                                                                                } else {
                                                                                    let _e1879 = nodes.member[(0u + _e1525)].links[3u];
                                                                                    phi_2416_ = _e1879;
                                                                                }
                                                                                let _e1881 = phi_2416_;
                                                                                let _e1886 = ((_e1881 >> bitcast<u32>(((_e1799 * 8u) & 31u))) & 255u);
                                                                                let _e1887 = (_e1886 & 31u);
                                                                                if (_e1887 >= 24u) {
                                                                                    phi_2429_ = (24u + ((_e1887 - 24u) ^ _e1385));
                                                                                } else {
                                                                                    phi_2429_ = _e1887;
                                                                                }
                                                                                let _e1893 = phi_2429_;
                                                                                phi_2434_ = (_e1795 | ((_e1886 >> bitcast<u32>(5i)) << bitcast<u32>((_e1893 & 31u))));
                                                                            } else {
                                                                                phi_2434_ = _e1795;
                                                                            }
                                                                            let _e1901 = phi_2434_;
                                                                            phi_2435_ = _e1901;
                                                                        } else {
                                                                            phi_2435_ = _e1795;
                                                                        }
                                                                        let _e1903 = phi_2435_;
                                                                        phi_2436_ = _e1903;
                                                                    } else {
                                                                        phi_2436_ = _e1795;
                                                                    }
                                                                    let _e1905 = phi_2436_;
                                                                    phi_2306_ = (_e1793 + 1u);
                                                                    phi_2309_ = _e1905;
                                                                } else {
                                                                    phi_2306_ = u32();
                                                                    phi_2309_ = u32();
                                                                }
                                                                let _e1908 = phi_2306_;
                                                                let _e1910 = phi_2309_;
                                                                continue;
                                                                continuing {
                                                                    phi_2305_ = _e1908;
                                                                    phi_2308_ = _e1910;
                                                                    break if !(_e1796);
                                                                }
                                                            }
                                                            let _e1914 = nodes.member[(0u + _e1525)].links[0u];
                                                            let _e1918 = nodes.member[(0u + _e1525)].frame[3u];
                                                            let _e1922 = local_6;
                                                            if ((_e1922 & 4278190080u) == 0u) {
                                                            } else {
                                                                let _e1926 = local_1.group_mask;
                                                                if ((_e1926 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1930 = local_1.len;
                                                                    if (_e1930 < 32u) {
                                                                        let _e1933 = local_1.group;
                                                                        let _e1935 = local_1.len;
                                                                        if (_e1935 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_1.first[(0u + _e1935)] = _e1933;
                                                                        let _e1941 = local_1.group_mask;
                                                                        let _e1943 = local_1.len;
                                                                        if (_e1943 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_1.mask[(0u + _e1943)] = _e1941;
                                                                        let _e1950 = local_1.len;
                                                                        local_1.len = (_e1950 + 1u);
                                                                    }
                                                                }
                                                                local_1.group = (_e1151 + _e1914);
                                                                let _e1954 = local_7;
                                                                local_1.group_mask = ((_e1954 & 4278190080u) | (_e1918 >> bitcast<u32>(24i)));
                                                            }
                                                            let _e1959 = local_8;
                                                            phi_2494_ = _e1523;
                                                            phi_2497_ = (_e1959 & 16777215u);
                                                            loop {
                                                                let _e1962 = phi_2494_;
                                                                let _e1964 = phi_2497_;
                                                                local_9 = _e1962;
                                                                if (_e1964 == 0u) {
                                                                    phi_2495_ = lt_bvh_Hit();
                                                                    phi_2498_ = u32();
                                                                    phi_3336_ = false;
                                                                } else {
                                                                    let _e1968 = nodes.member[(0u + _e1525)].links[1u];
                                                                    let _e1973 = ((_e1153 + _e1968) + select(firstTrailingBit(_e1964), 32u, (_e1964 == 0u)));
                                                                    if (_e1973 < _e80) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1980 = triangles.member[(0u + _e1973)].v0_;
                                                                    let _e1982 = (_e1980.x - _e1076);
                                                                    let _e1984 = (_e1980.y - _e1089);
                                                                    let _e1986 = (_e1980.z - _e1102);
                                                                    if (_e1358 == 0u) {
                                                                        phi_2542_ = vec3<f32>(_e1984, _e1986, _e1982);
                                                                    } else {
                                                                        if (_e1358 == 1u) {
                                                                            phi_2541_ = vec3<f32>(_e1986, _e1982, _e1984);
                                                                        } else {
                                                                            phi_2541_ = (_e1980 - vec3<f32>(_e1076, _e1089, _e1102));
                                                                        }
                                                                        let _e1994 = phi_2541_;
                                                                        phi_2542_ = _e1994;
                                                                    }
                                                                    let _e1996 = phi_2542_;
                                                                    let _e2000 = (_e1996.x - (_e1369 * _e1996.z));
                                                                    let _e2004 = (_e1996.y - (_e1372 * _e1996.z));
                                                                    let _e2006 = triangles.member[(0u + _e1973)].v1_;
                                                                    let _e2008 = (_e2006.x - _e1076);
                                                                    let _e2010 = (_e2006.y - _e1089);
                                                                    let _e2012 = (_e2006.z - _e1102);
                                                                    if (_e1358 == 0u) {
                                                                        phi_2572_ = vec3<f32>(_e2010, _e2012, _e2008);
                                                                    } else {
                                                                        if (_e1358 == 1u) {
                                                                            phi_2571_ = vec3<f32>(_e2012, _e2008, _e2010);
                                                                        } else {
                                                                            phi_2571_ = (_e2006 - vec3<f32>(_e1076, _e1089, _e1102));
                                                                        }
                                                                        let _e2020 = phi_2571_;
                                                                        phi_2572_ = _e2020;
                                                                    }
                                                                    let _e2022 = phi_2572_;
                                                                    let _e2026 = (_e2022.x - (_e1369 * _e2022.z));
                                                                    let _e2030 = (_e2022.y - (_e1372 * _e2022.z));
                                                                    let _e2032 = triangles.member[(0u + _e1973)].v2_;
                                                                    let _e2034 = (_e2032.x - _e1076);
                                                                    let _e2036 = (_e2032.y - _e1089);
                                                                    let _e2038 = (_e2032.z - _e1102);
                                                                    if (_e1358 == 0u) {
                                                                        phi_2602_ = vec3<f32>(_e2036, _e2038, _e2034);
                                                                    } else {
                                                                        if (_e1358 == 1u) {
                                                                            phi_2601_ = vec3<f32>(_e2038, _e2034, _e2036);
                                                                        } else {
                                                                            phi_2601_ = (_e2032 - vec3<f32>(_e1076, _e1089, _e1102));
                                                                        }
                                                                        let _e2046 = phi_2601_;
                                                                        phi_2602_ = _e2046;
                                                                    }
                                                                    let _e2048 = phi_2602_;
                                                                    let _e2052 = (_e2048.x - (_e1369 * _e2048.z));
                                                                    let _e2056 = (_e2048.y - (_e1372 * _e2048.z));
                                                                    if (_e2026 < _e2052) {
                                                                        phi_2621_ = true;
                                                                    } else {
                                                                        if (_e2026 == _e2052) {
                                                                            phi_2620_ = (_e2030 < _e2056);
                                                                        } else {
                                                                            phi_2620_ = false;
                                                                        }
                                                                        let _e2061 = phi_2620_;
                                                                        phi_2621_ = _e2061;
                                                                    }
                                                                    let _e2063 = phi_2621_;
                                                                    if _e2063 {
                                                                        phi_2625_ = _e2056;
                                                                        phi_2626_ = _e2052;
                                                                        phi_2627_ = _e2030;
                                                                        phi_2628_ = _e2026;
                                                                    } else {
                                                                        phi_2625_ = _e2030;
                                                                        phi_2626_ = _e2026;
                                                                        phi_2627_ = _e2056;
                                                                        phi_2628_ = _e2052;
                                                                    }
                                                                    let _e2065 = phi_2625_;
                                                                    let _e2067 = phi_2626_;
                                                                    let _e2069 = phi_2627_;
                                                                    let _e2071 = phi_2628_;
                                                                    let _e2074 = ((_e2071 * _e2065) - (_e2069 * _e2067));
                                                                    if _e2063 {
                                                                        phi_2636_ = -(_e2074);
                                                                    } else {
                                                                        phi_2636_ = _e2074;
                                                                    }
                                                                    let _e2077 = phi_2636_;
                                                                    if (_e2052 < _e2000) {
                                                                        phi_2647_ = true;
                                                                    } else {
                                                                        if (_e2052 == _e2000) {
                                                                            phi_2646_ = (_e2056 < _e2004);
                                                                        } else {
                                                                            phi_2646_ = false;
                                                                        }
                                                                        let _e2082 = phi_2646_;
                                                                        phi_2647_ = _e2082;
                                                                    }
                                                                    let _e2084 = phi_2647_;
                                                                    if _e2084 {
                                                                        phi_2651_ = _e2004;
                                                                        phi_2652_ = _e2000;
                                                                        phi_2653_ = _e2056;
                                                                        phi_2654_ = _e2052;
                                                                    } else {
                                                                        phi_2651_ = _e2056;
                                                                        phi_2652_ = _e2052;
                                                                        phi_2653_ = _e2004;
                                                                        phi_2654_ = _e2000;
                                                                    }
                                                                    let _e2086 = phi_2651_;
                                                                    let _e2088 = phi_2652_;
                                                                    let _e2090 = phi_2653_;
                                                                    let _e2092 = phi_2654_;
                                                                    let _e2095 = ((_e2092 * _e2086) - (_e2090 * _e2088));
                                                                    if _e2084 {
                                                                        phi_2662_ = -(_e2095);
                                                                    } else {
                                                                        phi_2662_ = _e2095;
                                                                    }
                                                                    let _e2098 = phi_2662_;
                                                                    if (_e2000 < _e2026) {
                                                                        phi_2673_ = true;
                                                                    } else {
                                                                        if (_e2000 == _e2026) {
                                                                            phi_2672_ = (_e2004 < _e2030);
                                                                        } else {
                                                                            phi_2672_ = false;
                                                                        }
                                                                        let _e2103 = phi_2672_;
                                                                        phi_2673_ = _e2103;
                                                                    }
                                                                    let _e2105 = phi_2673_;
                                                                    if _e2105 {
                                                                        phi_2677_ = _e2030;
                                                                        phi_2678_ = _e2026;
                                                                        phi_2679_ = _e2004;
                                                                        phi_2680_ = _e2000;
                                                                    } else {
                                                                        phi_2677_ = _e2004;
                                                                        phi_2678_ = _e2000;
                                                                        phi_2679_ = _e2030;
                                                                        phi_2680_ = _e2026;
                                                                    }
                                                                    let _e2107 = phi_2677_;
                                                                    let _e2109 = phi_2678_;
                                                                    let _e2111 = phi_2679_;
                                                                    let _e2113 = phi_2680_;
                                                                    let _e2116 = ((_e2113 * _e2107) - (_e2111 * _e2109));
                                                                    if _e2105 {
                                                                        phi_2688_ = -(_e2116);
                                                                    } else {
                                                                        phi_2688_ = _e2116;
                                                                    }
                                                                    let _e2119 = phi_2688_;
                                                                    if (_e2077 >= 0f) {
                                                                        if (_e2098 >= 0f) {
                                                                            if (_e2119 >= 0f) {
                                                                                phi_2703_ = ((_e2077 + _e2098) + _e2119);
                                                                                phi_2704_ = false;
                                                                            } else {
                                                                                phi_2703_ = f32();
                                                                                phi_2704_ = true;
                                                                            }
                                                                            let _e2126 = phi_2703_;
                                                                            let _e2128 = phi_2704_;
                                                                            phi_2705_ = _e2126;
                                                                            phi_2706_ = _e2128;
                                                                        } else {
                                                                            phi_2705_ = f32();
                                                                            phi_2706_ = true;
                                                                        }
                                                                        let _e2130 = phi_2705_;
                                                                        let _e2132 = phi_2706_;
                                                                        phi_2707_ = _e2130;
                                                                        phi_2708_ = _e2132;
                                                                    } else {
                                                                        phi_2707_ = f32();
                                                                        phi_2708_ = true;
                                                                    }
                                                                    let _e2134 = phi_2707_;
                                                                    let _e2136 = phi_2708_;
                                                                    if _e2136 {
                                                                        if (_e2077 <= 0f) {
                                                                            if (_e2098 <= 0f) {
                                                                                let _e2139 = (_e2119 <= 0f);
                                                                                if _e2139 {
                                                                                }
                                                                                phi_2726_ = ((_e2077 + _e2098) + _e2119);
                                                                                phi_2727_ = false;
                                                                                phi_2728_ = _e2139;
                                                                            } else {
                                                                                phi_2726_ = f32();
                                                                                phi_2727_ = true;
                                                                                phi_2728_ = false;
                                                                            }
                                                                            let _e2143 = phi_2726_;
                                                                            let _e2145 = phi_2727_;
                                                                            let _e2147 = phi_2728_;
                                                                            phi_2729_ = _e2143;
                                                                            phi_2730_ = _e2145;
                                                                            phi_2731_ = _e2147;
                                                                        } else {
                                                                            phi_2729_ = f32();
                                                                            phi_2730_ = true;
                                                                            phi_2731_ = false;
                                                                        }
                                                                        let _e2149 = phi_2729_;
                                                                        let _e2151 = phi_2730_;
                                                                        let _e2153 = phi_2731_;
                                                                        if _e2151 {
                                                                            phi_2735_ = false;
                                                                        } else {
                                                                            phi_2735_ = _e2153;
                                                                        }
                                                                        let _e2155 = phi_2735_;
                                                                        phi_2736_ = _e2149;
                                                                        phi_2737_ = _e2155;
                                                                    } else {
                                                                        phi_2736_ = _e2134;
                                                                        phi_2737_ = true;
                                                                    }
                                                                    let _e2157 = phi_2736_;
                                                                    let _e2159 = phi_2737_;
                                                                    if _e2159 {
                                                                        let _e2160 = (_e2157 == 0f);
                                                                        if _e2160 {
                                                                            phi_3053_ = lt_bvh_triangle_Intersection();
                                                                            phi_3054_ = false;
                                                                        } else {
                                                                            let _e2162 = triangles.member[(0u + _e1973)].v0_;
                                                                            let _e2164 = (_e2162.x - _e1076);
                                                                            let _e2166 = (_e2162.y - _e1089);
                                                                            let _e2168 = (_e2162.z - _e1102);
                                                                            if (_e1358 == 0u) {
                                                                                phi_2766_ = vec3<f32>(_e2166, _e2168, _e2164);
                                                                            } else {
                                                                                if (_e1358 == 1u) {
                                                                                    phi_2765_ = vec3<f32>(_e2168, _e2164, _e2166);
                                                                                } else {
                                                                                    phi_2765_ = (_e2162 - vec3<f32>(_e1076, _e1089, _e1102));
                                                                                }
                                                                                let _e2176 = phi_2765_;
                                                                                phi_2766_ = _e2176;
                                                                            }
                                                                            let _e2178 = phi_2766_;
                                                                            let _e2180 = triangles.member[(0u + _e1973)].v1_;
                                                                            let _e2182 = triangles.member[(0u + _e1973)].v0_;
                                                                            let _e2185 = (_e2180.x - _e2182.x);
                                                                            let _e2188 = (_e2180.y - _e2182.y);
                                                                            let _e2191 = (_e2180.z - _e2182.z);
                                                                            if (_e1358 == 0u) {
                                                                                phi_2792_ = vec3<f32>(_e2188, _e2191, _e2185);
                                                                            } else {
                                                                                if (_e1358 == 1u) {
                                                                                    phi_2791_ = vec3<f32>(_e2191, _e2185, _e2188);
                                                                                } else {
                                                                                    phi_2791_ = (_e2180 - _e2182);
                                                                                }
                                                                                let _e2198 = phi_2791_;
                                                                                phi_2792_ = _e2198;
                                                                            }
                                                                            let _e2200 = phi_2792_;
                                                                            let _e2202 = triangles.member[(0u + _e1973)].v2_;
                                                                            let _e2204 = triangles.member[(0u + _e1973)].v0_;
                                                                            let _e2207 = (_e2202.x - _e2204.x);
                                                                            let _e2210 = (_e2202.y - _e2204.y);
                                                                            let _e2213 = (_e2202.z - _e2204.z);
                                                                            if (_e1358 == 0u) {
                                                                                phi_2818_ = vec3<f32>(_e2210, _e2213, _e2207);
                                                                            } else {
                                                                                if (_e1358 == 1u) {
                                                                                    phi_2817_ = vec3<f32>(_e2213, _e2207, _e2210);
                                                                                } else {
                                                                                    phi_2817_ = (_e2202 - _e2204);
                                                                                }
                                                                                let _e2220 = phi_2817_;
                                                                                phi_2818_ = _e2220;
                                                                            }
                                                                            let _e2222 = phi_2818_;
                                                                            let _e2229 = ((_e2200.y * _e2222.z) - (_e2200.z * _e2222.y));
                                                                            let _e2236 = ((_e2200.z * _e2222.x) - (_e2200.x * _e2222.z));
                                                                            let _e2243 = ((_e2200.x * _e2222.y) - (_e2200.y * _e2222.x));
                                                                            let _e2257 = (((1f / _e1366.z) * (((_e2229 * _e2178.x) + (_e2236 * _e2178.y)) + (_e2243 * _e2178.z))) / (((_e2229 * _e1369) + (_e2236 * _e1372)) + _e2243));
                                                                            if (_e2257 > _e175.tmin) {
                                                                                if (_e2257 < _e175.tmax) {
                                                                                    let _e2261 = triangles.member[(0u + _e1973)].v0_;
                                                                                    let _e2263 = triangles.member[(0u + _e1973)].v1_;
                                                                                    if (_e2261.x < _e2263.x) {
                                                                                        phi_2874_ = _e2261.x;
                                                                                    } else {
                                                                                        phi_2874_ = _e2263.x;
                                                                                    }
                                                                                    let _e2270 = phi_2874_;
                                                                                    if (_e2261.y < _e2263.y) {
                                                                                        phi_2883_ = _e2261.y;
                                                                                    } else {
                                                                                        phi_2883_ = _e2263.y;
                                                                                    }
                                                                                    let _e2277 = phi_2883_;
                                                                                    if (_e2261.z < _e2263.z) {
                                                                                        phi_2892_ = _e2261.z;
                                                                                    } else {
                                                                                        phi_2892_ = _e2263.z;
                                                                                    }
                                                                                    let _e2284 = phi_2892_;
                                                                                    let _e2286 = triangles.member[(0u + _e1973)].v2_;
                                                                                    if (_e2270 < _e2286.x) {
                                                                                        phi_2901_ = _e2270;
                                                                                    } else {
                                                                                        phi_2901_ = _e2286.x;
                                                                                    }
                                                                                    let _e2291 = phi_2901_;
                                                                                    if (_e2277 < _e2286.y) {
                                                                                        phi_2908_ = _e2277;
                                                                                    } else {
                                                                                        phi_2908_ = _e2286.y;
                                                                                    }
                                                                                    let _e2296 = phi_2908_;
                                                                                    if (_e2284 < _e2286.z) {
                                                                                        phi_2915_ = _e2284;
                                                                                    } else {
                                                                                        phi_2915_ = _e2286.z;
                                                                                    }
                                                                                    let _e2301 = phi_2915_;
                                                                                    let _e2303 = triangles.member[(0u + _e1973)].v0_;
                                                                                    let _e2305 = triangles.member[(0u + _e1973)].v1_;
                                                                                    if (_e2303.x > _e2305.x) {
                                                                                        phi_2928_ = _e2303.x;
                                                                                    } else {
                                                                                        phi_2928_ = _e2305.x;
                                                                                    }
                                                                                    let _e2312 = phi_2928_;
                                                                                    if (_e2303.y > _e2305.y) {
                                                                                        phi_2937_ = _e2303.y;
                                                                                    } else {
                                                                                        phi_2937_ = _e2305.y;
                                                                                    }
                                                                                    let _e2319 = phi_2937_;
                                                                                    if (_e2303.z > _e2305.z) {
                                                                                        phi_2946_ = _e2303.z;
                                                                                    } else {
                                                                                        phi_2946_ = _e2305.z;
                                                                                    }
                                                                                    let _e2326 = phi_2946_;
                                                                                    let _e2328 = triangles.member[(0u + _e1973)].v2_;
                                                                                    if (_e2312 > _e2328.x) {
                                                                                        phi_2955_ = _e2312;
                                                                                    } else {
                                                                                        phi_2955_ = _e2328.x;
                                                                                    }
                                                                                    let _e2333 = phi_2955_;
                                                                                    if (_e2319 > _e2328.y) {
                                                                                        phi_2962_ = _e2319;
                                                                                    } else {
                                                                                        phi_2962_ = _e2328.y;
                                                                                    }
                                                                                    let _e2338 = phi_2962_;
                                                                                    if (_e2326 > _e2328.z) {
                                                                                        phi_2969_ = _e2326;
                                                                                    } else {
                                                                                        phi_2969_ = _e2328.z;
                                                                                    }
                                                                                    let _e2343 = phi_2969_;
                                                                                    let _e2347 = ((_e2291 - _e1076) * _e1283);
                                                                                    let _e2348 = ((_e2296 - _e1089) * _e1293);
                                                                                    let _e2349 = ((_e2301 - _e1102) * _e1303);
                                                                                    let _e2353 = ((_e2333 - _e1076) * _e1283);
                                                                                    let _e2354 = ((_e2338 - _e1089) * _e1293);
                                                                                    let _e2355 = ((_e2343 - _e1102) * _e1303);
                                                                                    if (_e2347 < _e2353) {
                                                                                        phi_2986_ = _e2347;
                                                                                    } else {
                                                                                        phi_2986_ = _e2353;
                                                                                    }
                                                                                    let _e2358 = phi_2986_;
                                                                                    if (_e2348 < _e2354) {
                                                                                        phi_2991_ = _e2348;
                                                                                    } else {
                                                                                        phi_2991_ = _e2354;
                                                                                    }
                                                                                    let _e2361 = phi_2991_;
                                                                                    if (_e2349 < _e2355) {
                                                                                        phi_2996_ = _e2349;
                                                                                    } else {
                                                                                        phi_2996_ = _e2355;
                                                                                    }
                                                                                    let _e2364 = phi_2996_;
                                                                                    if (_e2347 > _e2353) {
                                                                                        phi_3004_ = _e2347;
                                                                                    } else {
                                                                                        phi_3004_ = _e2353;
                                                                                    }
                                                                                    let _e2370 = phi_3004_;
                                                                                    if (_e2348 > _e2354) {
                                                                                        phi_3009_ = _e2348;
                                                                                    } else {
                                                                                        phi_3009_ = _e2354;
                                                                                    }
                                                                                    let _e2373 = phi_3009_;
                                                                                    if (_e2349 > _e2355) {
                                                                                        phi_3014_ = _e2349;
                                                                                    } else {
                                                                                        phi_3014_ = _e2355;
                                                                                    }
                                                                                    let _e2376 = phi_3014_;
                                                                                    let _e2380 = core_intrinsics_maximum_number_nsz_f32_((_e2358 - _e1342), (_e2361 - _e1343));
                                                                                    let _e2381 = core_intrinsics_maximum_number_nsz_f32_(_e2380, (_e2364 - _e1344));
                                                                                    let _e2382 = core_intrinsics_minimum_number_nsz_f32_((_e2370 + _e1342), (_e2373 + _e1343));
                                                                                    let _e2383 = core_intrinsics_minimum_number_nsz_f32_(_e2382, (_e2376 + _e1344));
                                                                                    if (_e2381 > _e1051) {
                                                                                        phi_3026_ = _e2381;
                                                                                    } else {
                                                                                        phi_3026_ = _e1051;
                                                                                    }
                                                                                    let _e2386 = phi_3026_;
                                                                                    if (_e2383 < _e1053) {
                                                                                        phi_3031_ = _e2383;
                                                                                    } else {
                                                                                        phi_3031_ = _e1053;
                                                                                    }
                                                                                    let _e2389 = phi_3031_;
                                                                                    if (_e2257 < _e2386) {
                                                                                        phi_3036_ = _e2386;
                                                                                    } else {
                                                                                        phi_3036_ = _e2257;
                                                                                    }
                                                                                    let _e2392 = phi_3036_;
                                                                                    if (_e2392 > _e2389) {
                                                                                        phi_3041_ = _e2389;
                                                                                    } else {
                                                                                        phi_3041_ = _e2392;
                                                                                    }
                                                                                    let _e2395 = phi_3041_;
                                                                                    phi_3046_ = lt_bvh_triangle_Intersection(_e2395, (_e2098 / _e2157), (_e2119 / _e2157), (_e2386 <= _e2389));
                                                                                    phi_3047_ = false;
                                                                                } else {
                                                                                    phi_3046_ = lt_bvh_triangle_Intersection();
                                                                                    phi_3047_ = true;
                                                                                }
                                                                                let _e2401 = phi_3046_;
                                                                                let _e2403 = phi_3047_;
                                                                                phi_3048_ = _e2401;
                                                                                phi_3049_ = _e2403;
                                                                            } else {
                                                                                phi_3048_ = lt_bvh_triangle_Intersection();
                                                                                phi_3049_ = true;
                                                                            }
                                                                            let _e2405 = phi_3048_;
                                                                            let _e2407 = phi_3049_;
                                                                            if _e2407 {
                                                                            }
                                                                            phi_3053_ = _e2405;
                                                                            phi_3054_ = _e2407;
                                                                        }
                                                                        let _e2409 = phi_3053_;
                                                                        let _e2411 = phi_3054_;
                                                                        phi_3055_ = _e2409;
                                                                        phi_3056_ = _e2160;
                                                                        phi_3057_ = _e2411;
                                                                    } else {
                                                                        phi_3055_ = lt_bvh_triangle_Intersection();
                                                                        phi_3056_ = true;
                                                                        phi_3057_ = false;
                                                                    }
                                                                    let _e2413 = phi_3055_;
                                                                    let _e2415 = phi_3056_;
                                                                    let _e2417 = phi_3057_;
                                                                    if _e2415 {
                                                                        phi_3061_ = true;
                                                                    } else {
                                                                        phi_3061_ = _e2417;
                                                                    }
                                                                    let _e2419 = phi_3061_;
                                                                    if _e2419 {
                                                                        phi_3065_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_3065_ = _e2413;
                                                                    }
                                                                    let _e2421 = phi_3065_;
                                                                    if _e2421.is_hit {
                                                                        if (_e2421.t > _e175.tmin) {
                                                                            if (_e2421.t < _e1962.t) {
                                                                                phi_3113_ = true;
                                                                            } else {
                                                                                if (_e2421.t == _e1962.t) {
                                                                                    if (_e1962.triangle != 4294967295u) {
                                                                                        if (_e1973 < _e1962.triangle) {
                                                                                            phi_3104_ = true;
                                                                                        } else {
                                                                                            if (_e1973 == _e1962.triangle) {
                                                                                                phi_3103_ = (_e992 < _e1962.instance);
                                                                                            } else {
                                                                                                phi_3103_ = false;
                                                                                            }
                                                                                            let _e2439 = phi_3103_;
                                                                                            phi_3104_ = _e2439;
                                                                                        }
                                                                                        let _e2441 = phi_3104_;
                                                                                        phi_3105_ = _e2441;
                                                                                        phi_3106_ = false;
                                                                                    } else {
                                                                                        phi_3105_ = bool();
                                                                                        phi_3106_ = true;
                                                                                    }
                                                                                    let _e2443 = phi_3105_;
                                                                                    let _e2445 = phi_3106_;
                                                                                    phi_3107_ = _e2443;
                                                                                    phi_3108_ = _e2445;
                                                                                } else {
                                                                                    phi_3107_ = bool();
                                                                                    phi_3108_ = true;
                                                                                }
                                                                                let _e2447 = phi_3107_;
                                                                                let _e2449 = phi_3108_;
                                                                                if _e2449 {
                                                                                    phi_3112_ = false;
                                                                                } else {
                                                                                    phi_3112_ = _e2447;
                                                                                }
                                                                                let _e2451 = phi_3112_;
                                                                                phi_3113_ = _e2451;
                                                                            }
                                                                            let _e2453 = phi_3113_;
                                                                            if _e2453 {
                                                                                let _e2455 = triangles.member[(0u + _e1973)].i0_;
                                                                                if ((_e2455 & 2147483648u) == 0u) {
                                                                                    phi_3324_ = true;
                                                                                } else {
                                                                                    if (_e1973 < _e80) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2464 = triangles.member[(0u + _e1973)].i0_;
                                                                                    let _e2465 = (_e2464 & 2147483647u);
                                                                                    let _e2467 = triangles.member[(0u + _e1973)].i1_;
                                                                                    let _e2469 = triangles.member[(0u + _e1973)].i2_;
                                                                                    if (_e2465 < _e83) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2473 = vertices.member[(0u + _e2465)];
                                                                                    if (_e2467 < _e83) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2477 = vertices.member[(0u + _e2467)];
                                                                                    if (_e2469 < _e83) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2481 = vertices.member[(0u + _e2469)];
                                                                                    let _e2482 = array<abi_Vertex, 3>(_e2473, _e2477, _e2481);
                                                                                    if (_e2482[0].material < _e86) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2488 = materials.member[(0u + _e2482[0].material)];
                                                                                    if ((_e2488.flags & 0u) == 0u) {
                                                                                        let _e2493 = ((1f - _e2421.u) - _e2421.v);
                                                                                        if (_e2488.cutoff <= 0f) {
                                                                                            phi_3319_ = true;
                                                                                        } else {
                                                                                            let _e2520 = (_e2488.base_color.w * ((((f32((_e2482[0].color >> bitcast<u32>(24i))) * _e2493) + (f32((_e2482[1].color >> bitcast<u32>(24i))) * _e2421.u)) + (f32((_e2482[2].color >> bitcast<u32>(24i))) * _e2421.v)) * (1f / 255f)));
                                                                                            if (_e2488.alpha_size == 0u) {
                                                                                                phi_3316_ = _e2520;
                                                                                            } else {
                                                                                                local.offset = _e2488.alpha_offset;
                                                                                                local.size = _e2488.alpha_size;
                                                                                                local.flags = _e2488.flags;
                                                                                                let _e2551 = _lt_shaders_texture_TextureView_quad((&local), (((_e2482[0].u * _e2493) + (_e2482[1].u * _e2421.u)) + (_e2482[2].u * _e2421.v)), (((_e2482[0].v * _e2493) + (_e2482[1].v * _e2421.u)) + (_e2482[2].v * _e2421.v)));
                                                                                                let _e2555 = (_e2551.indices[0] >> bitcast<u32>(2i));
                                                                                                if (_e2555 < _e95) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2559 = alpha_texels.member[(0u + _e2555)];
                                                                                                let _e2575 = (_e2551.indices[1] >> bitcast<u32>(2i));
                                                                                                if (_e2575 < _e95) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2579 = alpha_texels.member[(0u + _e2575)];
                                                                                                let _e2596 = (_e2551.indices[2] >> bitcast<u32>(2i));
                                                                                                if (_e2596 < _e95) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2600 = alpha_texels.member[(0u + _e2596)];
                                                                                                let _e2617 = (_e2551.indices[3] >> bitcast<u32>(2i));
                                                                                                if (_e2617 < _e95) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2621 = alpha_texels.member[(0u + _e2617)];
                                                                                                phi_3316_ = (_e2520 * (((((f32(((_e2559 >> bitcast<u32>((((_e2551.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2551.weights.x) + ((f32(((_e2579 >> bitcast<u32>((((_e2551.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2551.weights.y)) + ((f32(((_e2600 >> bitcast<u32>((((_e2551.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2551.weights.z)) + ((f32(((_e2621 >> bitcast<u32>((((_e2551.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2551.weights.w)));
                                                                                            }
                                                                                            let _e2637 = phi_3316_;
                                                                                            phi_3319_ = (_e2637 >= _e2488.cutoff);
                                                                                        }
                                                                                        let _e2641 = phi_3319_;
                                                                                        phi_3320_ = _e2641;
                                                                                    } else {
                                                                                        phi_3320_ = false;
                                                                                    }
                                                                                    let _e2643 = phi_3320_;
                                                                                    if _e2643 {
                                                                                    }
                                                                                    phi_3324_ = _e2643;
                                                                                }
                                                                                let _e2645 = phi_3324_;
                                                                                if _e2645 {
                                                                                    phi_3332_ = lt_bvh_Hit(_e2421.t, _e2421.u, _e2421.v, _e1973, _e992);
                                                                                } else {
                                                                                    phi_3332_ = _e1962;
                                                                                }
                                                                                let _e2651 = phi_3332_;
                                                                                phi_3333_ = _e2651;
                                                                            } else {
                                                                                phi_3333_ = _e1962;
                                                                            }
                                                                            let _e2653 = phi_3333_;
                                                                            phi_3334_ = _e2653;
                                                                        } else {
                                                                            phi_3334_ = _e1962;
                                                                        }
                                                                        let _e2655 = phi_3334_;
                                                                        phi_3335_ = _e2655;
                                                                    } else {
                                                                        phi_3335_ = _e1962;
                                                                    }
                                                                    let _e2657 = phi_3335_;
                                                                    phi_2495_ = _e2657;
                                                                    phi_2498_ = (_e1964 & (_e1964 - 1u));
                                                                    phi_3336_ = true;
                                                                }
                                                                let _e2659 = phi_2495_;
                                                                let _e2661 = phi_2498_;
                                                                let _e2663 = phi_3336_;
                                                                continue;
                                                                continuing {
                                                                    phi_2494_ = _e2659;
                                                                    phi_2497_ = _e2661;
                                                                    break if !(_e2663);
                                                                }
                                                            }
                                                            let _e2666 = local_1.group_mask;
                                                            if ((_e2666 & 4278190080u) == 0u) {
                                                                let _e2670 = local_1.len;
                                                                if (_e2670 == 0u) {
                                                                    phi_3375_ = false;
                                                                } else {
                                                                    let _e2674 = local_1.len;
                                                                    local_1.len = (_e2674 - 1u);
                                                                    let _e2677 = local_1.len;
                                                                    if (_e2677 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2682 = local_1.first[(0u + _e2677)];
                                                                    local_1.group = _e2682;
                                                                    let _e2685 = local_1.len;
                                                                    if (_e2685 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2690 = local_1.mask[(0u + _e2685)];
                                                                    local_1.group_mask = _e2690;
                                                                    phi_3375_ = true;
                                                                }
                                                                let _e2693 = phi_3375_;
                                                                phi_3376_ = _e2693;
                                                            } else {
                                                                phi_3376_ = true;
                                                            }
                                                            let _e2695 = phi_3376_;
                                                            if _e2695 {
                                                                let _e2697 = local_1.group_mask;
                                                                let _e2703 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2697)), 32u, (_e2697 == 0u)));
                                                                let _e2707 = local_1.group_mask;
                                                                let _e2721 = local_1.group_mask;
                                                                local_1.group_mask = (_e2721 & ~((1u << bitcast<u32>((_e2703 & 31u)))));
                                                                let _e2724 = local_1.group;
                                                                phi_3407_ = (_e2724 + countOneBits(((_e2707 & ~((4294967295u << bitcast<u32>((((_e2703 - 24u) ^ _e1385) & 31u))))) & 255u)));
                                                            } else {
                                                                phi_3407_ = 4294967295u;
                                                            }
                                                            let _e2727 = phi_3407_;
                                                            let _e3712 = local_9;
                                                            phi_2162_ = _e3712;
                                                            phi_2165_ = _e2727;
                                                        } else {
                                                            phi_2162_ = lt_bvh_Hit();
                                                            phi_2165_ = u32();
                                                        }
                                                        let _e2729 = phi_2162_;
                                                        let _e2731 = phi_2165_;
                                                        continue;
                                                        continuing {
                                                            phi_2161_ = _e2729;
                                                            phi_2164_ = _e2731;
                                                            break if !(_e1526);
                                                        }
                                                    }
                                                    let _e3716 = local_10;
                                                    phi_3408_ = _e3716;
                                                }
                                                let _e2734 = phi_3408_;
                                                phi_3409_ = _e2734;
                                                phi_3410_ = _e1207;
                                            } else {
                                                phi_3409_ = lt_bvh_Hit();
                                                phi_3410_ = true;
                                            }
                                            let _e2736 = phi_3409_;
                                            let _e2738 = phi_3410_;
                                            if _e2738 {
                                                phi_3414_ = _e984;
                                            } else {
                                                phi_3414_ = _e2736;
                                            }
                                            let _e2740 = phi_3414_;
                                            phi_3415_ = _e2740;
                                        } else {
                                            phi_3415_ = _e984;
                                        }
                                        let _e2742 = phi_3415_;
                                        phi_3416_ = _e2742;
                                    } else {
                                        phi_3416_ = _e984;
                                    }
                                    let _e2744 = phi_3416_;
                                    phi_3417_ = _e2744;
                                } else {
                                    phi_3417_ = _e984;
                                }
                                let _e2746 = phi_3417_;
                                phi_1529_ = (_e982 & (_e982 - 1u));
                                phi_1532_ = _e2746;
                                phi_3418_ = true;
                            }
                            let _e2748 = phi_1529_;
                            let _e2750 = phi_1532_;
                            let _e2752 = phi_3418_;
                            continue;
                            continuing {
                                phi_1528_ = _e2748;
                                phi_1531_ = _e2750;
                                break if !(_e2752);
                            }
                        }
                        let _e2755 = local_2.group_mask;
                        if ((_e2755 & 4278190080u) == 0u) {
                            let _e2759 = local_2.len;
                            if (_e2759 == 0u) {
                                phi_3457_ = false;
                            } else {
                                let _e2763 = local_2.len;
                                local_2.len = (_e2763 - 1u);
                                let _e2766 = local_2.len;
                                if (_e2766 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2771 = local_2.first[(0u + _e2766)];
                                local_2.group = _e2771;
                                let _e2774 = local_2.len;
                                if (_e2774 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2779 = local_2.mask[(0u + _e2774)];
                                local_2.group_mask = _e2779;
                                phi_3457_ = true;
                            }
                            let _e2782 = phi_3457_;
                            phi_3458_ = _e2782;
                        } else {
                            phi_3458_ = true;
                        }
                        let _e2784 = phi_3458_;
                        if _e2784 {
                            let _e2786 = local_2.group_mask;
                            let _e2792 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2786)), 32u, (_e2786 == 0u)));
                            let _e2796 = local_2.group_mask;
                            let _e2810 = local_2.group_mask;
                            local_2.group_mask = (_e2810 & ~((1u << bitcast<u32>((_e2792 & 31u)))));
                            let _e2813 = local_2.group;
                            phi_3489_ = (_e2813 + countOneBits(((_e2796 & ~((4294967295u << bitcast<u32>((((_e2792 - 24u) ^ _e401) & 31u))))) & 255u)));
                        } else {
                            phi_3489_ = 4294967295u;
                        }
                        let _e2816 = phi_3489_;
                        phi_1192_ = _e2816;
                        let _e3732 = local_11;
                        phi_1195_ = _e3732;
                    } else {
                        phi_1192_ = u32();
                        phi_1195_ = lt_bvh_Hit();
                    }
                    let _e2818 = phi_1192_;
                    let _e2820 = phi_1195_;
                    continue;
                    continuing {
                        phi_1191_ = _e2818;
                        phi_1194_ = _e2820;
                        break if !(_e542);
                    }
                }
                let _e3735 = local_12;
                phi_3490_ = _e3735;
            }
            let _e2823 = phi_3490_;
            phi_3491_ = _e2823;
            phi_3492_ = _e239;
        } else {
            phi_3491_ = lt_bvh_Hit();
            phi_3492_ = true;
        }
        let _e2825 = phi_3491_;
        let _e2827 = phi_3492_;
        if _e2827 {
            phi_3496_ = _e177;
        } else {
            phi_3496_ = _e2825;
        }
        let _e2829 = phi_3496_;
        if (_e2829.triangle != 4294967295u) {
            let _e2835 = ((1f - _e2829.u) - _e2829.v);
            if (_e2829.triangle < _e80) {
            } else {
                return;
            }
            let _e2841 = triangles.member[(0u + _e2829.triangle)];
            if (_e2829.instance < _e92) {
            } else {
                return;
            }
            let _e2852 = instances.member[(0u + _e2829.instance)].object_to_world[0u];
            let _e2863 = ((((_e2852.x * _e2841.v0_.x) + (_e2852.y * _e2841.v0_.y)) + (_e2852.z * _e2841.v0_.z)) + (_e2852.w * 1f));
            let _e2865 = instances.member[(0u + _e2829.instance)].object_to_world[1u];
            let _e2876 = ((((_e2865.x * _e2841.v0_.x) + (_e2865.y * _e2841.v0_.y)) + (_e2865.z * _e2841.v0_.z)) + (_e2865.w * 1f));
            let _e2878 = instances.member[(0u + _e2829.instance)].object_to_world[2u];
            let _e2889 = ((((_e2878.x * _e2841.v0_.x) + (_e2878.y * _e2841.v0_.y)) + (_e2878.z * _e2841.v0_.z)) + (_e2878.w * 1f));
            let _e2896 = instances.member[(0u + _e2829.instance)].object_to_world[0u];
            let _e2907 = ((((_e2896.x * _e2841.v1_.x) + (_e2896.y * _e2841.v1_.y)) + (_e2896.z * _e2841.v1_.z)) + (_e2896.w * 1f));
            let _e2909 = instances.member[(0u + _e2829.instance)].object_to_world[1u];
            let _e2920 = ((((_e2909.x * _e2841.v1_.x) + (_e2909.y * _e2841.v1_.y)) + (_e2909.z * _e2841.v1_.z)) + (_e2909.w * 1f));
            let _e2922 = instances.member[(0u + _e2829.instance)].object_to_world[2u];
            let _e2933 = ((((_e2922.x * _e2841.v1_.x) + (_e2922.y * _e2841.v1_.y)) + (_e2922.z * _e2841.v1_.z)) + (_e2922.w * 1f));
            let _e2940 = instances.member[(0u + _e2829.instance)].object_to_world[0u];
            let _e2951 = ((((_e2940.x * _e2841.v2_.x) + (_e2940.y * _e2841.v2_.y)) + (_e2940.z * _e2841.v2_.z)) + (_e2940.w * 1f));
            let _e2953 = instances.member[(0u + _e2829.instance)].object_to_world[1u];
            let _e2964 = ((((_e2953.x * _e2841.v2_.x) + (_e2953.y * _e2841.v2_.y)) + (_e2953.z * _e2841.v2_.z)) + (_e2953.w * 1f));
            let _e2966 = instances.member[(0u + _e2829.instance)].object_to_world[2u];
            let _e2977 = ((((_e2966.x * _e2841.v2_.x) + (_e2966.y * _e2841.v2_.y)) + (_e2966.z * _e2841.v2_.z)) + (_e2966.w * 1f));
            let _e2990 = (((_e2863 * _e2835) + (_e2907 * _e2829.u)) + (_e2951 * _e2829.v));
            let _e2991 = (((_e2876 * _e2835) + (_e2920 * _e2829.u)) + (_e2964 * _e2829.v));
            let _e2992 = (((_e2889 * _e2835) + (_e2933 * _e2829.u)) + (_e2977 * _e2829.v));
            let _e2994 = abs(_e2863);
            let _e2995 = abs(_e2876);
            let _e2996 = abs(_e2889);
            let _e2997 = abs(_e2907);
            let _e2998 = abs(_e2920);
            let _e2999 = abs(_e2933);
            if (_e2994 > _e2997) {
                phi_3684_ = _e2994;
            } else {
                phi_3684_ = _e2997;
            }
            let _e3002 = phi_3684_;
            if (_e2995 > _e2998) {
                phi_3689_ = _e2995;
            } else {
                phi_3689_ = _e2998;
            }
            let _e3005 = phi_3689_;
            if (_e2996 > _e2999) {
                phi_3694_ = _e2996;
            } else {
                phi_3694_ = _e2999;
            }
            let _e3008 = phi_3694_;
            let _e3009 = abs(_e2951);
            let _e3010 = abs(_e2964);
            let _e3011 = abs(_e2977);
            if (_e3002 > _e3009) {
                phi_3702_ = _e3002;
            } else {
                phi_3702_ = _e3009;
            }
            let _e3014 = phi_3702_;
            if (_e3005 > _e3010) {
                phi_3707_ = _e3005;
            } else {
                phi_3707_ = _e3010;
            }
            let _e3017 = phi_3707_;
            if (_e3008 > _e3011) {
                phi_3712_ = _e3008;
            } else {
                phi_3712_ = _e3011;
            }
            let _e3020 = phi_3712_;
            let _e3021 = (_e2907 - _e2863);
            let _e3022 = (_e2920 - _e2876);
            let _e3023 = (_e2933 - _e2889);
            let _e3024 = (_e2951 - _e2863);
            let _e3025 = (_e2964 - _e2876);
            let _e3026 = (_e2977 - _e2889);
            let _e3030 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3022), abs(_e3023));
            let _e3031 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3021), _e3030);
            let _e3032 = (_e3021 / _e3031);
            let _e3033 = (_e3022 / _e3031);
            let _e3034 = (_e3023 / _e3031);
            let _e3038 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3025), abs(_e3026));
            let _e3039 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3024), _e3038);
            let _e3040 = (_e3024 / _e3039);
            let _e3041 = (_e3025 / _e3039);
            let _e3042 = (_e3026 / _e3039);
            let _e3045 = ((_e3033 * _e3042) - (_e3041 * _e3034));
            let _e3048 = ((_e3034 * _e3040) - (_e3042 * _e3032));
            let _e3051 = ((_e3032 * _e3041) - (_e3040 * _e3033));
            let _e3053 = p.member.eye;
            let _e3066 = (1f / sqrt((((_e3045 * _e3045) + (_e3048 * _e3048)) + (_e3051 * _e3051))));
            let _e3067 = (_e3045 * _e3066);
            let _e3068 = (_e3048 * _e3066);
            let _e3069 = (_e3051 * _e3066);
            if ((((_e3067 * (_e3053.x - _e2990)) + (_e3068 * (_e3053.y - _e2991))) + (_e3069 * (_e3053.z - _e2992))) < 0f) {
                phi_3776_ = vec3<f32>(-(_e3067), -(_e3068), -(_e3069));
            } else {
                phi_3776_ = vec3<f32>(_e3067, _e3068, _e3069);
            }
            let _e3082 = phi_3776_;
            if (_e2829.triangle < _e80) {
            } else {
                return;
            }
            let _e3087 = triangles.member[(0u + _e2829.triangle)];
            let _e3089 = (_e3087.i0_ & 2147483647u);
            if (_e3089 < _e83) {
            } else {
                return;
            }
            let _e3095 = vertices.member[(0u + _e3089)];
            if (_e3087.i1_ < _e83) {
            } else {
                return;
            }
            let _e3099 = vertices.member[(0u + _e3087.i1_)];
            if (_e3087.i2_ < _e83) {
            } else {
                return;
            }
            let _e3103 = vertices.member[(0u + _e3087.i2_)];
            let _e3104 = array<abi_Vertex, 3>(_e3095, _e3099, _e3103);
            if (_e3104[0].material < _e86) {
            } else {
                return;
            }
            let _e3110 = materials.member[(0u + _e3104[0].material)];
            let _e3127 = (1f / 255f);
            let _e3146 = (1f / 255f);
            let _e3168 = (1f / 255f);
            let _e3181 = _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(vec3<f32>(_e2835, _e2829.u, _e2829.v));
            let _e3183 = ((_e3110.base_color.x * ((((f32((_e3104[0].color & 255u)) * _e3127) * _e2835) + ((f32((_e3104[1].color & 255u)) * _e3146) * _e2829.u)) + ((f32((_e3104[2].color & 255u)) * _e3168) * _e2829.v))) * _e3181.x);
            let _e3185 = ((_e3110.base_color.y * ((((f32(((_e3104[0].color >> bitcast<u32>(8i)) & 255u)) * _e3127) * _e2835) + ((f32(((_e3104[1].color >> bitcast<u32>(8i)) & 255u)) * _e3146) * _e2829.u)) + ((f32(((_e3104[2].color >> bitcast<u32>(8i)) & 255u)) * _e3168) * _e2829.v))) * _e3181.y);
            let _e3187 = ((_e3110.base_color.z * ((((f32(((_e3104[0].color >> bitcast<u32>(16i)) & 255u)) * _e3127) * _e2835) + ((f32(((_e3104[1].color >> bitcast<u32>(16i)) & 255u)) * _e3146) * _e2829.u)) + ((f32(((_e3104[2].color >> bitcast<u32>(16i)) & 255u)) * _e3168) * _e2829.v))) * _e3181.z);
            let _e3188 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e3017, _e3020);
            let _e3189 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e3014, _e3188);
            if ((_e3110.flags & 2u) == 0u) {
                phi_3897_ = 0u;
            } else {
                phi_3897_ = 1u;
            }
            let _e3194 = phi_3897_;
            if (_e3104[0].normal == 2147516416u) {
                phi_4127_ = _e3082;
            } else {
                let _e3207 = (f32((bitcast<i32>((_e3104[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3213 = (f32((bitcast<i32>(_e3104[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3217 = ((1f - abs(_e3207)) - abs(_e3213));
                if (_e3217 < 0f) {
                    phi_3924_ = -(_e3217);
                } else {
                    phi_3924_ = 0f;
                }
                let _e3221 = phi_3924_;
                if (_e3207 < 0f) {
                    phi_3931_ = (_e3207 + _e3221);
                } else {
                    phi_3931_ = (_e3207 - _e3221);
                }
                let _e3226 = phi_3931_;
                if (_e3213 < 0f) {
                    phi_3938_ = (_e3213 + _e3221);
                } else {
                    phi_3938_ = (_e3213 - _e3221);
                }
                let _e3231 = phi_3938_;
                let _e3238 = (1f / sqrt((((_e3226 * _e3226) + (_e3231 * _e3231)) + (_e3217 * _e3217))));
                let _e3254 = (f32((bitcast<i32>((_e3104[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3260 = (f32((bitcast<i32>(_e3104[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3264 = ((1f - abs(_e3254)) - abs(_e3260));
                if (_e3264 < 0f) {
                    phi_3973_ = -(_e3264);
                } else {
                    phi_3973_ = 0f;
                }
                let _e3268 = phi_3973_;
                if (_e3254 < 0f) {
                    phi_3980_ = (_e3254 + _e3268);
                } else {
                    phi_3980_ = (_e3254 - _e3268);
                }
                let _e3273 = phi_3980_;
                if (_e3260 < 0f) {
                    phi_3987_ = (_e3260 + _e3268);
                } else {
                    phi_3987_ = (_e3260 - _e3268);
                }
                let _e3278 = phi_3987_;
                let _e3285 = (1f / sqrt((((_e3273 * _e3273) + (_e3278 * _e3278)) + (_e3264 * _e3264))));
                let _e3304 = (f32((bitcast<i32>((_e3104[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3310 = (f32((bitcast<i32>(_e3104[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3314 = ((1f - abs(_e3304)) - abs(_e3310));
                if (_e3314 < 0f) {
                    phi_4025_ = -(_e3314);
                } else {
                    phi_4025_ = 0f;
                }
                let _e3318 = phi_4025_;
                if (_e3304 < 0f) {
                    phi_4032_ = (_e3304 + _e3318);
                } else {
                    phi_4032_ = (_e3304 - _e3318);
                }
                let _e3323 = phi_4032_;
                if (_e3310 < 0f) {
                    phi_4039_ = (_e3310 + _e3318);
                } else {
                    phi_4039_ = (_e3310 - _e3318);
                }
                let _e3328 = phi_4039_;
                let _e3335 = (1f / sqrt((((_e3323 * _e3323) + (_e3328 * _e3328)) + (_e3314 * _e3314))));
                let _e3342 = ((((_e3226 * _e3238) * _e2835) + ((_e3273 * _e3285) * _e2829.u)) + ((_e3323 * _e3335) * _e2829.v));
                let _e3343 = ((((_e3231 * _e3238) * _e2835) + ((_e3278 * _e3285) * _e2829.u)) + ((_e3328 * _e3335) * _e2829.v));
                let _e3344 = ((((_e3217 * _e3238) * _e2835) + ((_e3264 * _e3285) * _e2829.u)) + ((_e3314 * _e3335) * _e2829.v));
                if (_e2829.instance < _e92) {
                } else {
                    return;
                }
                let _e3351 = instances.member[(0u + _e2829.instance)].world_to_object[0u];
                let _e3360 = instances.member[(0u + _e2829.instance)].world_to_object[1u];
                let _e3372 = instances.member[(0u + _e2829.instance)].world_to_object[2u];
                let _e3379 = (((_e3351.x * _e3342) + (_e3360.x * _e3343)) + (_e3372.x * _e3344));
                let _e3380 = (((_e3351.y * _e3342) + (_e3360.y * _e3343)) + (_e3372.y * _e3344));
                let _e3381 = (((_e3351.z * _e3342) + (_e3360.z * _e3343)) + (_e3372.z * _e3344));
                let _e3387 = sqrt((((_e3379 * _e3379) + (_e3380 * _e3380)) + (_e3381 * _e3381)));
                if (_e3387 > 0f) {
                    let _e3389 = (_e3379 / _e3387);
                    let _e3390 = (_e3380 / _e3387);
                    let _e3391 = (_e3381 / _e3387);
                    if ((((_e3389 * _e3082.x) + (_e3390 * _e3082.y)) + (_e3391 * _e3082.z)) < 0f) {
                        phi_4125_ = vec3<f32>(-(_e3389), -(_e3390), -(_e3391));
                    } else {
                        phi_4125_ = vec3<f32>(_e3389, _e3390, _e3391);
                    }
                    let _e3407 = phi_4125_;
                    phi_4126_ = _e3407;
                } else {
                    phi_4126_ = _e3082;
                }
                let _e3409 = phi_4126_;
                phi_4127_ = _e3409;
            }
            let _e3411 = phi_4127_;
            if (_e3183 > 0f) {
                if (_e3183 < 1f) {
                    phi_4136_ = _e3183;
                } else {
                    phi_4136_ = 1f;
                }
                let _e3415 = phi_4136_;
                phi_4137_ = _e3415;
            } else {
                phi_4137_ = 0f;
            }
            let _e3417 = phi_4137_;
            if (_e3185 > 0f) {
                if (_e3185 < 1f) {
                    phi_4147_ = _e3185;
                } else {
                    phi_4147_ = 1f;
                }
                let _e3422 = phi_4147_;
                phi_4148_ = _e3422;
            } else {
                phi_4148_ = 0f;
            }
            let _e3424 = phi_4148_;
            if (_e3187 > 0f) {
                if (_e3187 < 1f) {
                    phi_4158_ = _e3187;
                } else {
                    phi_4158_ = 1f;
                }
                let _e3429 = phi_4158_;
                phi_4159_ = _e3429;
            } else {
                phi_4159_ = 0f;
            }
            let _e3431 = phi_4159_;
            let _e3434 = ((sqrt(_e3417) * 255f) + 0.5f);
            let _e3443 = ((sqrt(_e3424) * 255f) + 0.5f);
            let _e3455 = ((sqrt(_e3431) * 255f) + 0.5f);
            phi_4194_ = abi_Sample(vec3<f32>(_e2990, _e2991, _e2992), _e3189, _e3082, _e3194, _e3411, ((select(select(u32(_e3434), 0u, (_e3434 < bitcast<f32>(0u))), 4294967295u, (_e3434 > bitcast<f32>(1333788671u))) | (select(select(u32(_e3443), 0u, (_e3443 < bitcast<f32>(0u))), 4294967295u, (_e3443 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e3455), 0u, (_e3455 < bitcast<f32>(0u))), 4294967295u, (_e3455 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_4194_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e3469 = phi_4194_;
        if (_e101.shift < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e101.shift)] = _e3469;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_instanced_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
