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

struct type_61 {
    member: array<lt_bvh_Instance>,
}

struct type_65 {
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
var<uniform> p: type_65;
@group(0) @binding(1) 
var<storage> nodes: type_35;
@group(0) @binding(2) 
var<storage> triangles: type_39;
@group(0) @binding(5) 
var<storage, read_write> samples: type_9;
@group(0) @binding(6) 
var<storage> instances: type_61;
@group(0) @binding(7) 
var<storage> color_texels: type_13;
@group(0) @binding(8) 
var<storage> before: type_26;
@group(0) @binding(9) 
var<storage, read_write> past: type_26;

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
        let _e85 = phi_224_;
        let _e87 = phi_225_;
        phi_226_ = _e85;
        phi_227_ = _e87;
    } else {
        phi_226_ = lt_mask_LightPlace();
        phi_227_ = true;
    }
    let _e89 = phi_226_;
    let _e91 = phi_227_;
    if _e91 {
        phi_232_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_232_ = _e89;
    }
    let _e96 = phi_232_;
    return lt_mask_LightPlace(_e96.word, _e96.shift);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_247_: bool;
    var phi_251_: f32;

    if (param_3 != param_3) {
        phi_247_ = true;
    } else {
        let _e75 = (param_4 >= param_3);
        if _e75 {
        }
        phi_247_ = _e75;
    }
    let _e77 = phi_247_;
    if _e77 {
        phi_251_ = param_4;
    } else {
        phi_251_ = param_3;
    }
    let _e79 = phi_251_;
    return _e79;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_263_: bool;
    var phi_267_: f32;

    if (param_5 != param_5) {
        phi_263_ = true;
    } else {
        let _e75 = (param_6 <= param_5);
        if _e75 {
        }
        phi_263_ = _e75;
    }
    let _e77 = phi_263_;
    if _e77 {
        phi_267_ = param_6;
    } else {
        phi_267_ = param_5;
    }
    let _e79 = phi_267_;
    return _e79;
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
                phi_309_ = 1f;
            } else {
                phi_309_ = 0f;
            }
            let _e106 = phi_309_;
            if (param_8 < 8388608f) {
                phi_314_ = (_e103 - _e106);
                phi_315_ = false;
            } else {
                phi_314_ = f32();
                phi_315_ = true;
            }
            let _e109 = phi_314_;
            let _e111 = phi_315_;
            phi_316_ = _e109;
            phi_317_ = _e111;
        } else {
            phi_316_ = f32();
            phi_317_ = true;
        }
        let _e113 = phi_316_;
        let _e115 = phi_317_;
        if _e115 {
            phi_321_ = param_8;
        } else {
            phi_321_ = _e113;
        }
        let _e117 = phi_321_;
        phi_369_ = (param_8 - _e117);
    } else {
        if (_e90 == 1u) {
            let _e120 = (param_8 * 0.5f);
            if (_e120 > -8388608f) {
                let _e132 = f32(select(0i, select(select(i32(_e120), i32(-2147483648), (_e120 < bitcast<f32>(3472883712u))), 2147483647i, (_e120 > bitcast<f32>(1325400063u))), (_e120 == _e120)));
                if (_e132 > _e120) {
                    phi_347_ = 1f;
                } else {
                    phi_347_ = 0f;
                }
                let _e135 = phi_347_;
                if (_e120 < 8388608f) {
                    phi_352_ = (_e132 - _e135);
                    phi_353_ = false;
                } else {
                    phi_352_ = f32();
                    phi_353_ = true;
                }
                let _e138 = phi_352_;
                let _e140 = phi_353_;
                phi_354_ = _e138;
                phi_355_ = _e140;
            } else {
                phi_354_ = f32();
                phi_355_ = true;
            }
            let _e142 = phi_354_;
            let _e144 = phi_355_;
            if _e144 {
                phi_359_ = _e120;
            } else {
                phi_359_ = _e142;
            }
            let _e146 = phi_359_;
            let _e148 = (param_8 - (2f * _e146));
            if (_e148 > 1f) {
                phi_367_ = (2f - _e148);
            } else {
                phi_367_ = _e148;
            }
            let _e152 = phi_367_;
            phi_368_ = _e152;
        } else {
            phi_368_ = param_8;
        }
        let _e154 = phi_368_;
        phi_369_ = _e154;
    }
    let _e156 = phi_369_;
    if (_e156 > 0f) {
        if (_e156 < 1f) {
            phi_378_ = _e156;
        } else {
            phi_378_ = 1f;
        }
        let _e160 = phi_378_;
        phi_379_ = _e160;
    } else {
        phi_379_ = 0f;
    }
    let _e162 = phi_379_;
    let _e163 = (_e77 - 1u);
    let _e165 = (_e162 * f32(_e77));
    if _e85 {
        let _e172 = select(select(u32(_e165), 0u, (_e165 < bitcast<f32>(0u))), 4294967295u, (_e165 > bitcast<f32>(1333788671u)));
        if (_e163 < _e172) {
            phi_397_ = _e163;
        } else {
            phi_397_ = _e172;
        }
        let _e175 = phi_397_;
        phi_436_ = texture_Axis(_e175, _e175, 0f);
    } else {
        let _e177 = (_e165 + 0.5f);
        let _e184 = select(select(u32(_e177), 0u, (_e177 < bitcast<f32>(0u))), 4294967295u, (_e177 > bitcast<f32>(1333788671u)));
        if (_e77 < _e184) {
            phi_411_ = _e77;
        } else {
            phi_411_ = _e184;
        }
        let _e187 = phi_411_;
        if (_e90 == 0u) {
            phi_418_ = _e163;
        } else {
            phi_418_ = 0u;
        }
        let _e192 = phi_418_;
        if (_e90 == 0u) {
            phi_423_ = 0u;
        } else {
            phi_423_ = _e163;
        }
        let _e195 = phi_423_;
        if (_e187 == 0u) {
            phi_429_ = _e192;
        } else {
            phi_429_ = (_e187 - 1u);
        }
        let _e199 = phi_429_;
        if (_e187 > _e163) {
            phi_434_ = _e195;
        } else {
            phi_434_ = _e187;
        }
        let _e202 = phi_434_;
        phi_436_ = texture_Axis(_e199, _e202, (_e177 - f32(_e187)));
    }
    let _e205 = phi_436_;
    let _e207 = (*param_7).flags;
    let _e210 = ((_e207 >> bitcast<u32>(6u)) & 3u);
    if (_e210 == 0u) {
        if (param_9 > -8388608f) {
            let _e223 = f32(select(0i, select(select(i32(param_9), i32(-2147483648), (param_9 < bitcast<f32>(3472883712u))), 2147483647i, (param_9 > bitcast<f32>(1325400063u))), (param_9 == param_9)));
            if (_e223 > param_9) {
                phi_464_ = 1f;
            } else {
                phi_464_ = 0f;
            }
            let _e226 = phi_464_;
            if (param_9 < 8388608f) {
                phi_469_ = (_e223 - _e226);
                phi_470_ = false;
            } else {
                phi_469_ = f32();
                phi_470_ = true;
            }
            let _e229 = phi_469_;
            let _e231 = phi_470_;
            phi_471_ = _e229;
            phi_472_ = _e231;
        } else {
            phi_471_ = f32();
            phi_472_ = true;
        }
        let _e233 = phi_471_;
        let _e235 = phi_472_;
        if _e235 {
            phi_476_ = param_9;
        } else {
            phi_476_ = _e233;
        }
        let _e237 = phi_476_;
        phi_524_ = (param_9 - _e237);
    } else {
        if (_e210 == 1u) {
            let _e240 = (param_9 * 0.5f);
            if (_e240 > -8388608f) {
                let _e252 = f32(select(0i, select(select(i32(_e240), i32(-2147483648), (_e240 < bitcast<f32>(3472883712u))), 2147483647i, (_e240 > bitcast<f32>(1325400063u))), (_e240 == _e240)));
                if (_e252 > _e240) {
                    phi_502_ = 1f;
                } else {
                    phi_502_ = 0f;
                }
                let _e255 = phi_502_;
                if (_e240 < 8388608f) {
                    phi_507_ = (_e252 - _e255);
                    phi_508_ = false;
                } else {
                    phi_507_ = f32();
                    phi_508_ = true;
                }
                let _e258 = phi_507_;
                let _e260 = phi_508_;
                phi_509_ = _e258;
                phi_510_ = _e260;
            } else {
                phi_509_ = f32();
                phi_510_ = true;
            }
            let _e262 = phi_509_;
            let _e264 = phi_510_;
            if _e264 {
                phi_514_ = _e240;
            } else {
                phi_514_ = _e262;
            }
            let _e266 = phi_514_;
            let _e268 = (param_9 - (2f * _e266));
            if (_e268 > 1f) {
                phi_522_ = (2f - _e268);
            } else {
                phi_522_ = _e268;
            }
            let _e272 = phi_522_;
            phi_523_ = _e272;
        } else {
            phi_523_ = param_9;
        }
        let _e274 = phi_523_;
        phi_524_ = _e274;
    }
    let _e276 = phi_524_;
    if (_e276 > 0f) {
        if (_e276 < 1f) {
            phi_533_ = _e276;
        } else {
            phi_533_ = 1f;
        }
        let _e280 = phi_533_;
        phi_534_ = _e280;
    } else {
        phi_534_ = 0f;
    }
    let _e282 = phi_534_;
    let _e283 = (_e81 - 1u);
    let _e285 = (_e282 * f32(_e81));
    if _e85 {
        let _e292 = select(select(u32(_e285), 0u, (_e285 < bitcast<f32>(0u))), 4294967295u, (_e285 > bitcast<f32>(1333788671u)));
        if (_e283 < _e292) {
            phi_552_ = _e283;
        } else {
            phi_552_ = _e292;
        }
        let _e295 = phi_552_;
        phi_591_ = texture_Axis(_e295, _e295, 0f);
    } else {
        let _e297 = (_e285 + 0.5f);
        let _e304 = select(select(u32(_e297), 0u, (_e297 < bitcast<f32>(0u))), 4294967295u, (_e297 > bitcast<f32>(1333788671u)));
        if (_e81 < _e304) {
            phi_566_ = _e81;
        } else {
            phi_566_ = _e304;
        }
        let _e307 = phi_566_;
        if (_e210 == 0u) {
            phi_573_ = _e283;
        } else {
            phi_573_ = 0u;
        }
        let _e312 = phi_573_;
        if (_e210 == 0u) {
            phi_578_ = 0u;
        } else {
            phi_578_ = _e283;
        }
        let _e315 = phi_578_;
        if (_e307 == 0u) {
            phi_584_ = _e312;
        } else {
            phi_584_ = (_e307 - 1u);
        }
        let _e319 = phi_584_;
        if (_e307 > _e283) {
            phi_589_ = _e315;
        } else {
            phi_589_ = _e307;
        }
        let _e322 = phi_589_;
        phi_591_ = texture_Axis(_e319, _e322, (_e297 - f32(_e307)));
    }
    let _e325 = phi_591_;
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
    var phi_650_: f32;

    if (param_12 > param_13) {
        phi_650_ = param_12;
    } else {
        phi_650_ = param_13;
    }
    let _e76 = phi_650_;
    return _e76;
}

fn function_() {
    var local: texture_TextureView;
    var local_1: lt_bvh_traverse_Stack;
    var local_2: lt_bvh_traverse_Stack;
    var phi_796_: bool;
    var phi_797_: bool;
    var phi_798_: bool;
    var phi_799_: bool;
    var phi_803_: bool;
    var phi_816_: bool;
    var phi_817_: bool;
    var phi_818_: bool;
    var phi_819_: bool;
    var phi_823_: bool;
    var phi_836_: bool;
    var phi_837_: bool;
    var phi_838_: bool;
    var phi_842_: bool;
    var phi_843_: bool;
    var phi_844_: bool;
    var phi_845_: bool;
    var phi_846_: bool;
    var phi_850_: bool;
    var phi_926_: f32;
    var phi_933_: f32;
    var phi_941_: f32;
    var phi_948_: f32;
    var phi_956_: f32;
    var phi_963_: f32;
    var phi_986_: f32;
    var phi_991_: f32;
    var phi_996_: f32;
    var phi_1001_: f32;
    var phi_1006_: f32;
    var phi_1025_: u32;
    var phi_1030_: u32;
    var phi_1035_: u32;
    var phi_1149_: bool;
    var phi_1150_: bool;
    var phi_1181_: u32;
    var phi_1183_: u32;
    var phi_1186_: lt_bvh_Hit;
    var phi_1271_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1298_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1325_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1331_: u32;
    var phi_1334_: u32;
    var phi_1348_: u32;
    var phi_1358_: u32;
    var phi_1368_: u32;
    var phi_1386_: u32;
    var phi_1396_: u32;
    var phi_1406_: u32;
    var phi_1442_: u32;
    var phi_1455_: u32;
    var phi_1460_: u32;
    var phi_1461_: u32;
    var phi_1462_: u32;
    var phi_1332_: u32;
    var phi_1335_: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_1520_: u32;
    var phi_1523_: lt_bvh_Hit;
    var phi_1578_: f32;
    var phi_1583_: f32;
    var phi_1588_: f32;
    var phi_1596_: f32;
    var phi_1601_: f32;
    var phi_1606_: f32;
    var phi_1738_: bool;
    var phi_1739_: bool;
    var phi_1740_: bool;
    var phi_1741_: bool;
    var phi_1745_: bool;
    var phi_1758_: bool;
    var phi_1759_: bool;
    var phi_1760_: bool;
    var phi_1761_: bool;
    var phi_1765_: bool;
    var phi_1778_: bool;
    var phi_1779_: bool;
    var phi_1780_: bool;
    var phi_1784_: bool;
    var phi_1785_: bool;
    var phi_1786_: bool;
    var phi_1787_: bool;
    var phi_1788_: bool;
    var phi_1792_: bool;
    var phi_1862_: f32;
    var phi_1869_: f32;
    var phi_1876_: f32;
    var phi_1883_: f32;
    var phi_1890_: f32;
    var phi_1897_: f32;
    var phi_1914_: f32;
    var phi_1919_: f32;
    var phi_1924_: f32;
    var phi_1929_: f32;
    var phi_1934_: f32;
    var phi_1960_: bool;
    var phi_1961_: bool;
    var phi_1969_: u32;
    var phi_1970_: u32;
    var phi_1981_: vec3<f32>;
    var phi_1982_: vec3<f32>;
    var phi_1995_: u32;
    var phi_2000_: u32;
    var phi_2005_: u32;
    var phi_2119_: bool;
    var phi_2120_: bool;
    var phi_2151_: u32;
    var phi_2153_: lt_bvh_Hit;
    var phi_2156_: u32;
    var phi_2237_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2264_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2291_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2297_: u32;
    var phi_2300_: u32;
    var phi_2314_: u32;
    var phi_2324_: u32;
    var phi_2334_: u32;
    var phi_2352_: u32;
    var phi_2362_: u32;
    var phi_2372_: u32;
    var phi_2408_: u32;
    var phi_2421_: u32;
    var phi_2426_: u32;
    var phi_2427_: u32;
    var phi_2428_: u32;
    var phi_2298_: u32;
    var phi_2301_: u32;
    var local_6: u32;
    var local_7: u32;
    var local_8: u32;
    var phi_2486_: lt_bvh_Hit;
    var phi_2489_: u32;
    var phi_2533_: vec3<f32>;
    var phi_2534_: vec3<f32>;
    var phi_2563_: vec3<f32>;
    var phi_2564_: vec3<f32>;
    var phi_2593_: vec3<f32>;
    var phi_2594_: vec3<f32>;
    var phi_2612_: bool;
    var phi_2613_: bool;
    var phi_2617_: f32;
    var phi_2618_: f32;
    var phi_2619_: f32;
    var phi_2620_: f32;
    var phi_2628_: f32;
    var phi_2638_: bool;
    var phi_2639_: bool;
    var phi_2643_: f32;
    var phi_2644_: f32;
    var phi_2645_: f32;
    var phi_2646_: f32;
    var phi_2654_: f32;
    var phi_2664_: bool;
    var phi_2665_: bool;
    var phi_2669_: f32;
    var phi_2670_: f32;
    var phi_2671_: f32;
    var phi_2672_: f32;
    var phi_2680_: f32;
    var phi_2695_: f32;
    var phi_2696_: bool;
    var phi_2697_: f32;
    var phi_2698_: bool;
    var phi_2699_: f32;
    var phi_2700_: bool;
    var phi_2718_: f32;
    var phi_2719_: bool;
    var phi_2720_: bool;
    var phi_2721_: f32;
    var phi_2722_: bool;
    var phi_2723_: bool;
    var phi_2727_: bool;
    var phi_2728_: f32;
    var phi_2729_: bool;
    var phi_2757_: vec3<f32>;
    var phi_2758_: vec3<f32>;
    var phi_2783_: vec3<f32>;
    var phi_2784_: vec3<f32>;
    var phi_2809_: vec3<f32>;
    var phi_2810_: vec3<f32>;
    var phi_2866_: f32;
    var phi_2875_: f32;
    var phi_2884_: f32;
    var phi_2893_: f32;
    var phi_2900_: f32;
    var phi_2907_: f32;
    var phi_2920_: f32;
    var phi_2929_: f32;
    var phi_2938_: f32;
    var phi_2947_: f32;
    var phi_2954_: f32;
    var phi_2961_: f32;
    var phi_2978_: f32;
    var phi_2983_: f32;
    var phi_2988_: f32;
    var phi_2996_: f32;
    var phi_3001_: f32;
    var phi_3006_: f32;
    var phi_3018_: f32;
    var phi_3023_: f32;
    var phi_3028_: f32;
    var phi_3033_: f32;
    var phi_3038_: lt_bvh_triangle_Intersection;
    var phi_3039_: bool;
    var phi_3040_: lt_bvh_triangle_Intersection;
    var phi_3041_: bool;
    var phi_3045_: lt_bvh_triangle_Intersection;
    var phi_3046_: bool;
    var phi_3047_: lt_bvh_triangle_Intersection;
    var phi_3048_: bool;
    var phi_3049_: bool;
    var phi_3053_: bool;
    var phi_3057_: lt_bvh_triangle_Intersection;
    var phi_3095_: bool;
    var phi_3096_: bool;
    var phi_3097_: bool;
    var phi_3098_: bool;
    var phi_3099_: bool;
    var phi_3100_: bool;
    var phi_3104_: bool;
    var phi_3105_: bool;
    var phi_3119_: bool;
    var phi_3127_: lt_bvh_Hit;
    var phi_3128_: lt_bvh_Hit;
    var phi_3129_: lt_bvh_Hit;
    var phi_3130_: lt_bvh_Hit;
    var phi_2487_: lt_bvh_Hit;
    var phi_2490_: u32;
    var phi_3131_: bool;
    var phi_3170_: bool;
    var phi_3171_: bool;
    var phi_3202_: u32;
    var phi_2154_: lt_bvh_Hit;
    var phi_2157_: u32;
    var phi_3203_: lt_bvh_Hit;
    var phi_3204_: lt_bvh_Hit;
    var phi_3205_: bool;
    var phi_3209_: lt_bvh_Hit;
    var phi_3210_: lt_bvh_Hit;
    var phi_3211_: lt_bvh_Hit;
    var phi_3212_: lt_bvh_Hit;
    var phi_1521_: u32;
    var phi_1524_: lt_bvh_Hit;
    var phi_3213_: bool;
    var phi_3252_: bool;
    var phi_3253_: bool;
    var phi_3284_: u32;
    var phi_1184_: u32;
    var phi_1187_: lt_bvh_Hit;
    var phi_3285_: lt_bvh_Hit;
    var phi_3286_: lt_bvh_Hit;
    var phi_3287_: bool;
    var phi_3291_: lt_bvh_Hit;
    var phi_3478_: f32;
    var phi_3483_: f32;
    var phi_3488_: f32;
    var phi_3496_: f32;
    var phi_3501_: f32;
    var phi_3506_: f32;
    var phi_3570_: vec3<f32>;
    var phi_3813_: vec3<f32>;
    var phi_3828_: u32;
    var phi_3855_: f32;
    var phi_3862_: f32;
    var phi_3869_: f32;
    var phi_3904_: f32;
    var phi_3911_: f32;
    var phi_3918_: f32;
    var phi_3956_: f32;
    var phi_3963_: f32;
    var phi_3970_: f32;
    var phi_4056_: vec3<f32>;
    var phi_4057_: vec3<f32>;
    var phi_4058_: vec3<f32>;
    var phi_4067_: f32;
    var phi_4068_: f32;
    var phi_4078_: f32;
    var phi_4079_: f32;
    var phi_4089_: f32;
    var phi_4090_: f32;
    var phi_4125_: abi_Sample;
    var phi_4348_: vec3<f32>;
    var local_9: lt_bvh_Hit;
    var local_10: lt_bvh_Hit;
    var local_11: lt_bvh_Hit;
    var local_12: lt_bvh_Hit;

    let _e75 = id_1;
    let _e79 = arrayLength((&nodes.member));
    let _e82 = arrayLength((&triangles.member));
    let _e85 = arrayLength((&vertices.member));
    let _e94 = arrayLength((&instances.member));
    let _e97 = arrayLength((&color_texels.member));
    let _e100 = arrayLength((&before.member));
    let _e106 = p.member.size[0u];
    let _e108 = p.member.size[1u];
    let _e109 = lt_shaders_entry_pixel_index(_e75, _e106, _e108);
    if (bitcast<i32>(_e109.word) != 0i) {
        let _e115 = p.member.root;
        let _e119 = p.member.eye;
        let _e122 = p.member.grid[0u];
        let _e124 = p.member.grid[1u];
        let _e143 = p.member.size[0u];
        let _e147 = ((((f32(_e75.x) + ((f32((_e75.y & (_e124 - 1u))) + 0.5f) / f32(_e124))) / f32(_e143)) * 2f) - 1f);
        let _e150 = p.member.size[1u];
        let _e154 = (1f - (((f32(_e75.y) + ((f32((_e75.x & (_e122 - 1u))) + 0.5f) / f32(_e122))) / f32(_e150)) * 2f));
        let _e156 = p.member.forward;
        let _e158 = p.member.right;
        let _e172 = p.member.up;
        let _e183 = _lt_bvh_ray_Ray_new(_e119, vec3<f32>(((_e156.x + (_e158.x * _e147)) + (_e172.x * _e154)), ((_e156.y + (_e158.y * _e147)) + (_e172.y * _e154)), ((_e156.z + (_e158.z * _e147)) + (_e172.z * _e154))));
        let _e185 = lt_bvh_Hit(_e183.tmax, 0f, 0f, 4294967295u, 4294967295u);
        let _e188 = abs(_e183.direction.x);
        let _e190 = abs(_e183.direction.y);
        let _e192 = abs(_e183.direction.z);
        if (abs(_e183.origin.x) < 1000000000000000f) {
            if (abs(_e183.origin.y) < 1000000000000000f) {
                phi_796_ = (abs(_e183.origin.z) < 1000000000000000f);
                phi_797_ = false;
            } else {
                phi_796_ = bool();
                phi_797_ = true;
            }
            let _e204 = phi_796_;
            let _e206 = phi_797_;
            phi_798_ = _e204;
            phi_799_ = _e206;
        } else {
            phi_798_ = bool();
            phi_799_ = true;
        }
        let _e208 = phi_798_;
        let _e210 = phi_799_;
        if _e210 {
            phi_803_ = false;
        } else {
            phi_803_ = _e208;
        }
        let _e212 = phi_803_;
        if _e212 {
            if (_e188 < 1000000000000000f) {
                if (_e190 < 1000000000000000f) {
                    phi_816_ = (_e192 < 1000000000000000f);
                    phi_817_ = false;
                } else {
                    phi_816_ = bool();
                    phi_817_ = true;
                }
                let _e217 = phi_816_;
                let _e219 = phi_817_;
                phi_818_ = _e217;
                phi_819_ = _e219;
            } else {
                phi_818_ = bool();
                phi_819_ = true;
            }
            let _e221 = phi_818_;
            let _e223 = phi_819_;
            if _e223 {
                phi_823_ = false;
            } else {
                phi_823_ = _e221;
            }
            let _e225 = phi_823_;
            if _e225 {
                if (_e188 > 0f) {
                    phi_837_ = bool();
                    phi_838_ = true;
                } else {
                    let _e227 = (_e190 > 0f);
                    if _e227 {
                        phi_836_ = bool();
                    } else {
                        phi_836_ = (_e192 > 0f);
                    }
                    let _e230 = phi_836_;
                    phi_837_ = _e230;
                    phi_838_ = _e227;
                }
                let _e232 = phi_837_;
                let _e234 = phi_838_;
                if _e234 {
                    phi_842_ = true;
                } else {
                    phi_842_ = _e232;
                }
                let _e236 = phi_842_;
                phi_843_ = _e236;
                phi_844_ = false;
            } else {
                phi_843_ = bool();
                phi_844_ = true;
            }
            let _e238 = phi_843_;
            let _e240 = phi_844_;
            phi_845_ = _e238;
            phi_846_ = _e240;
        } else {
            phi_845_ = bool();
            phi_846_ = true;
        }
        let _e242 = phi_845_;
        let _e244 = phi_846_;
        if _e244 {
            phi_850_ = false;
        } else {
            phi_850_ = _e242;
        }
        let _e246 = phi_850_;
        if _e246 {
            let _e247 = (_e115 >= _e79);
            if _e247 {
                phi_3285_ = lt_bvh_Hit();
            } else {
                if (_e115 < _e79) {
                } else {
                    return;
                }
                let _e253 = nodes.member[(0u + _e115)].frame[0u];
                let _e257 = nodes.member[(0u + _e115)].frame[1u];
                let _e261 = nodes.member[(0u + _e115)].frame[2u];
                let _e265 = nodes.member[(0u + _e115)].frame[0u];
                let _e269 = nodes.member[(0u + _e115)].frame[1u];
                let _e273 = nodes.member[(0u + _e115)].frame[2u];
                let _e277 = nodes.member[(0u + _e115)].frame[3u];
                let _e316 = core_intrinsics_maximum_number_nsz_f32_(abs(_e183.direction.x), abs(_e183.direction.y));
                let _e317 = core_intrinsics_maximum_number_nsz_f32_(_e316, abs(_e183.direction.z));
                let _e318 = (_e317 * 0.0000000000009094947f);
                if (abs(_e183.direction.x) < _e318) {
                    phi_926_ = _e318;
                } else {
                    phi_926_ = abs(_e183.direction.x);
                }
                let _e324 = phi_926_;
                if (_e183.direction.x < 0f) {
                    phi_933_ = (-1f / _e324);
                } else {
                    phi_933_ = (1f / _e324);
                }
                let _e329 = phi_933_;
                if (abs(_e183.direction.y) < _e318) {
                    phi_941_ = _e318;
                } else {
                    phi_941_ = abs(_e183.direction.y);
                }
                let _e335 = phi_941_;
                if (_e183.direction.y < 0f) {
                    phi_948_ = (-1f / _e335);
                } else {
                    phi_948_ = (1f / _e335);
                }
                let _e340 = phi_948_;
                if (abs(_e183.direction.z) < _e318) {
                    phi_956_ = _e318;
                } else {
                    phi_956_ = abs(_e183.direction.z);
                }
                let _e346 = phi_956_;
                if (_e183.direction.z < 0f) {
                    phi_963_ = (-1f / _e346);
                } else {
                    phi_963_ = (1f / _e346);
                }
                let _e351 = phi_963_;
                let _e358 = abs((bitcast<f32>(_e253) - _e183.origin.x));
                let _e359 = abs((bitcast<f32>(_e257) - _e183.origin.y));
                let _e360 = abs((bitcast<f32>(_e261) - _e183.origin.z));
                let _e367 = abs(((bitcast<f32>(_e265) + (bitcast<f32>((((_e277 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e183.origin.x));
                let _e368 = abs(((bitcast<f32>(_e269) + (bitcast<f32>((((_e277 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e183.origin.y));
                let _e369 = abs(((bitcast<f32>(_e273) + (bitcast<f32>((((_e277 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e183.origin.z));
                if (_e358 > _e367) {
                    phi_986_ = _e358;
                } else {
                    phi_986_ = _e367;
                }
                let _e372 = phi_986_;
                if (_e359 > _e368) {
                    phi_991_ = _e359;
                } else {
                    phi_991_ = _e368;
                }
                let _e375 = phi_991_;
                if (_e360 > _e369) {
                    phi_996_ = _e360;
                } else {
                    phi_996_ = _e369;
                }
                let _e378 = phi_996_;
                if (_e372 > _e375) {
                    phi_1001_ = _e372;
                } else {
                    phi_1001_ = _e375;
                }
                let _e381 = phi_1001_;
                if (_e381 > _e378) {
                    phi_1006_ = _e381;
                } else {
                    phi_1006_ = _e378;
                }
                let _e384 = phi_1006_;
                let _e388 = (_e384 * 0.0000019073486f);
                let _e389 = (abs(_e329) * _e388);
                let _e390 = (abs(_e340) * _e388);
                let _e391 = (abs(_e351) * _e388);
                let _e395 = (_e384 * 0.0000009536743f);
                let _e396 = (abs(_e329) * _e395);
                let _e397 = (abs(_e340) * _e395);
                let _e398 = (abs(_e351) * _e395);
                if (_e329 < 0f) {
                    phi_1025_ = 0u;
                } else {
                    phi_1025_ = 1u;
                }
                let _e401 = phi_1025_;
                if (_e340 < 0f) {
                    phi_1030_ = 0u;
                } else {
                    phi_1030_ = 2u;
                }
                let _e404 = phi_1030_;
                if (_e351 < 0f) {
                    phi_1035_ = 0u;
                } else {
                    phi_1035_ = 4u;
                }
                let _e407 = phi_1035_;
                let _e409 = ((_e401 | _e404) | _e407);
                let _e410 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e115, 2147483648u);
                local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e410.first[0], _e410.first[1], _e410.first[2], _e410.first[3], _e410.first[4], _e410.first[5], _e410.first[6], _e410.first[7], _e410.first[8], _e410.first[9], _e410.first[10], _e410.first[11], _e410.first[12], _e410.first[13], _e410.first[14], _e410.first[15], _e410.first[16], _e410.first[17], _e410.first[18], _e410.first[19], _e410.first[20], _e410.first[21], _e410.first[22], _e410.first[23], _e410.first[24], _e410.first[25], _e410.first[26], _e410.first[27], _e410.first[28], _e410.first[29], _e410.first[30], _e410.first[31]), array<u32, 32>(_e410.mask[0], _e410.mask[1], _e410.mask[2], _e410.mask[3], _e410.mask[4], _e410.mask[5], _e410.mask[6], _e410.mask[7], _e410.mask[8], _e410.mask[9], _e410.mask[10], _e410.mask[11], _e410.mask[12], _e410.mask[13], _e410.mask[14], _e410.mask[15], _e410.mask[16], _e410.mask[17], _e410.mask[18], _e410.mask[19], _e410.mask[20], _e410.mask[21], _e410.mask[22], _e410.mask[23], _e410.mask[24], _e410.mask[25], _e410.mask[26], _e410.mask[27], _e410.mask[28], _e410.mask[29], _e410.mask[30], _e410.mask[31]), _e410.len, _e410.group, _e410.group_mask);
                let _e484 = local_2.group_mask;
                if ((_e484 & 4278190080u) == 0u) {
                    let _e488 = local_2.len;
                    if (_e488 == 0u) {
                        phi_1149_ = false;
                    } else {
                        let _e492 = local_2.len;
                        local_2.len = (_e492 - 1u);
                        let _e495 = local_2.len;
                        if (_e495 < 32u) {
                        } else {
                            return;
                        }
                        let _e500 = local_2.first[(0u + _e495)];
                        local_2.group = _e500;
                        let _e503 = local_2.len;
                        if (_e503 < 32u) {
                        } else {
                            return;
                        }
                        let _e508 = local_2.mask[(0u + _e503)];
                        local_2.group_mask = _e508;
                        phi_1149_ = true;
                    }
                    let _e511 = phi_1149_;
                    phi_1150_ = _e511;
                } else {
                    phi_1150_ = true;
                }
                let _e513 = phi_1150_;
                if _e513 {
                    let _e515 = local_2.group_mask;
                    let _e521 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e515)), 32u, (_e515 == 0u)));
                    let _e525 = local_2.group_mask;
                    let _e539 = local_2.group_mask;
                    local_2.group_mask = (_e539 & ~((1u << bitcast<u32>((_e521 & 31u)))));
                    let _e542 = local_2.group;
                    phi_1181_ = (_e542 + countOneBits(((_e525 & ~((4294967295u << bitcast<u32>((((_e521 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1181_ = 4294967295u;
                }
                let _e545 = phi_1181_;
                phi_1183_ = _e545;
                phi_1186_ = _e185;
                loop {
                    let _e547 = phi_1183_;
                    let _e549 = phi_1186_;
                    local_12 = _e549;
                    let _e550 = (_e547 != 4294967295u);
                    if _e550 {
                        if (_e547 < _e79) {
                        } else {
                            return;
                        }
                        let _e558 = nodes.member[(0u + _e547)].frame[3u];
                        let _e583 = (bitcast<f32>((((_e558 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e329);
                        let _e584 = (bitcast<f32>((((_e558 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e340);
                        let _e585 = (bitcast<f32>((((_e558 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e351);
                        let _e588 = nodes.member[(0u + _e547)].frame[0u];
                        let _e592 = nodes.member[(0u + _e547)].frame[1u];
                        let _e596 = nodes.member[(0u + _e547)].frame[2u];
                        let _e604 = ((bitcast<f32>(_e588) - _e183.origin.x) * _e329);
                        let _e605 = ((bitcast<f32>(_e592) - _e183.origin.y) * _e340);
                        let _e606 = ((bitcast<f32>(_e596) - _e183.origin.z) * _e351);
                        let _e614 = nodes.member[(0u + _e547)].x;
                        if (_e329 < 0f) {
                            let _e625 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e614.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e631 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e625.unnamed.word, _e614.w), _e625.unnamed_1);
                            let _e637 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e631.unnamed, lt_mask_LightPlace(_e614.x, _e631.unnamed_1.shift));
                            phi_1271_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e637.unnamed, lt_mask_LightPlace(_e637.unnamed_1.word, _e614.y));
                        } else {
                            let _e653 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e614.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e659 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e653.unnamed.word, _e614.y), _e653.unnamed_1);
                            let _e665 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e659.unnamed, lt_mask_LightPlace(_e614.z, _e659.unnamed_1.shift));
                            phi_1271_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e665.unnamed, lt_mask_LightPlace(_e665.unnamed_1.word, _e614.w));
                        }
                        let _e673 = phi_1271_;
                        let _e683 = nodes.member[(0u + _e547)].y;
                        if (_e340 < 0f) {
                            let _e694 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e683.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e700 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e694.unnamed.word, _e683.w), _e694.unnamed_1);
                            let _e706 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e700.unnamed, lt_mask_LightPlace(_e683.x, _e700.unnamed_1.shift));
                            phi_1298_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e706.unnamed, lt_mask_LightPlace(_e706.unnamed_1.word, _e683.y));
                        } else {
                            let _e722 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e683.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e728 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e722.unnamed.word, _e683.y), _e722.unnamed_1);
                            let _e734 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e728.unnamed, lt_mask_LightPlace(_e683.z, _e728.unnamed_1.shift));
                            phi_1298_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e734.unnamed, lt_mask_LightPlace(_e734.unnamed_1.word, _e683.w));
                        }
                        let _e742 = phi_1298_;
                        let _e752 = nodes.member[(0u + _e547)].z;
                        if (_e351 < 0f) {
                            let _e763 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e752.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e769 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e763.unnamed.word, _e752.w), _e763.unnamed_1);
                            let _e775 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e769.unnamed, lt_mask_LightPlace(_e752.x, _e769.unnamed_1.shift));
                            phi_1325_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e775.unnamed, lt_mask_LightPlace(_e775.unnamed_1.word, _e752.y));
                        } else {
                            let _e791 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e752.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e797 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e791.unnamed.word, _e752.y), _e791.unnamed_1);
                            let _e803 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e797.unnamed, lt_mask_LightPlace(_e752.z, _e797.unnamed_1.shift));
                            phi_1325_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e803.unnamed, lt_mask_LightPlace(_e803.unnamed_1.word, _e752.w));
                        }
                        let _e811 = phi_1325_;
                        phi_1331_ = 0u;
                        phi_1334_ = 0u;
                        loop {
                            let _e821 = phi_1331_;
                            let _e823 = phi_1334_;
                            local_3 = _e823;
                            local_4 = _e823;
                            local_5 = _e823;
                            let _e824 = (_e821 < 8u);
                            if _e824 {
                                let _e826 = (_e821 >> bitcast<u32>(2i));
                                let _e827 = (_e821 & 3u);
                                if (_e826 == 0u) {
                                    phi_1348_ = _e673.unnamed.word;
                                } else {
                                    phi_1348_ = _e673.unnamed.shift;
                                }
                                let _e830 = phi_1348_;
                                if (_e826 == 0u) {
                                    phi_1358_ = _e742.unnamed.word;
                                } else {
                                    phi_1358_ = _e742.unnamed.shift;
                                }
                                let _e839 = phi_1358_;
                                if (_e826 == 0u) {
                                    phi_1368_ = _e811.unnamed.word;
                                } else {
                                    phi_1368_ = _e811.unnamed.shift;
                                }
                                let _e848 = phi_1368_;
                                let _e861 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e830 >> bitcast<u32>(((_e827 * 8u) & 31u))) & 255u)) * _e583) + (_e604 - _e389)), ((f32(((_e839 >> bitcast<u32>(((_e827 * 8u) & 31u))) & 255u)) * _e584) + (_e605 - _e390)));
                                let _e862 = core_intrinsics_maximum_number_nsz_f32_(_e861, ((f32(((_e848 >> bitcast<u32>(((_e827 * 8u) & 31u))) & 255u)) * _e585) + (_e606 - _e391)));
                                if (_e826 == 0u) {
                                    phi_1386_ = _e673.unnamed_1.word;
                                } else {
                                    phi_1386_ = _e673.unnamed_1.shift;
                                }
                                let _e865 = phi_1386_;
                                if (_e826 == 0u) {
                                    phi_1396_ = _e742.unnamed_1.word;
                                } else {
                                    phi_1396_ = _e742.unnamed_1.shift;
                                }
                                let _e874 = phi_1396_;
                                if (_e826 == 0u) {
                                    phi_1406_ = _e811.unnamed_1.word;
                                } else {
                                    phi_1406_ = _e811.unnamed_1.shift;
                                }
                                let _e883 = phi_1406_;
                                let _e896 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e865 >> bitcast<u32>(((_e827 * 8u) & 31u))) & 255u)) * _e583) + (_e604 + _e389)), ((f32(((_e874 >> bitcast<u32>(((_e827 * 8u) & 31u))) & 255u)) * _e584) + (_e605 + _e390)));
                                let _e897 = core_intrinsics_minimum_number_nsz_f32_(_e896, ((f32(((_e883 >> bitcast<u32>(((_e827 * 8u) & 31u))) & 255u)) * _e585) + (_e606 + _e391)));
                                if (_e862 <= _e897) {
                                    if (_e862 <= _e549.t) {
                                        if (_e897 >= _e183.tmin) {
                                            if (_e826 == 0u) {
                                                let _e904 = nodes.member[(0u + _e547)].links[2u];
                                                phi_1442_ = _e904;
                                            } else {
                                                let _e907 = nodes.member[(0u + _e547)].links[3u];
                                                phi_1442_ = _e907;
                                            }
                                            let _e909 = phi_1442_;
                                            let _e914 = ((_e909 >> bitcast<u32>(((_e827 * 8u) & 31u))) & 255u);
                                            let _e915 = (_e914 & 31u);
                                            if (_e915 >= 24u) {
                                                phi_1455_ = (24u + ((_e915 - 24u) ^ _e409));
                                            } else {
                                                phi_1455_ = _e915;
                                            }
                                            let _e921 = phi_1455_;
                                            phi_1460_ = (_e823 | ((_e914 >> bitcast<u32>(5i)) << bitcast<u32>((_e921 & 31u))));
                                        } else {
                                            phi_1460_ = _e823;
                                        }
                                        let _e929 = phi_1460_;
                                        phi_1461_ = _e929;
                                    } else {
                                        phi_1461_ = _e823;
                                    }
                                    let _e931 = phi_1461_;
                                    phi_1462_ = _e931;
                                } else {
                                    phi_1462_ = _e823;
                                }
                                let _e933 = phi_1462_;
                                phi_1332_ = (_e821 + 1u);
                                phi_1335_ = _e933;
                            } else {
                                phi_1332_ = u32();
                                phi_1335_ = u32();
                            }
                            let _e936 = phi_1332_;
                            let _e938 = phi_1335_;
                            continue;
                            continuing {
                                phi_1331_ = _e936;
                                phi_1334_ = _e938;
                                break if !(_e824);
                            }
                        }
                        let _e942 = nodes.member[(0u + _e547)].links[0u];
                        let _e946 = nodes.member[(0u + _e547)].frame[3u];
                        let _e950 = local_3;
                        if ((_e950 & 4278190080u) == 0u) {
                        } else {
                            let _e954 = local_2.group_mask;
                            if ((_e954 & 4278190080u) == 0u) {
                            } else {
                                let _e958 = local_2.len;
                                if (_e958 < 32u) {
                                    let _e961 = local_2.group;
                                    let _e963 = local_2.len;
                                    if (_e963 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.first[(0u + _e963)] = _e961;
                                    let _e969 = local_2.group_mask;
                                    let _e971 = local_2.len;
                                    if (_e971 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.mask[(0u + _e971)] = _e969;
                                    let _e978 = local_2.len;
                                    local_2.len = (_e978 + 1u);
                                }
                            }
                            local_2.group = (_e115 + _e942);
                            let _e982 = local_4;
                            local_2.group_mask = ((_e982 & 4278190080u) | (_e946 >> bitcast<u32>(24i)));
                        }
                        let _e987 = local_5;
                        phi_1520_ = (_e987 & 16777215u);
                        phi_1523_ = _e549;
                        loop {
                            let _e990 = phi_1520_;
                            let _e992 = phi_1523_;
                            local_11 = _e992;
                            if (_e990 == 0u) {
                                phi_1521_ = u32();
                                phi_1524_ = lt_bvh_Hit();
                                phi_3213_ = false;
                            } else {
                                let _e996 = nodes.member[(0u + _e547)].links[1u];
                                let _e1000 = (_e996 + select(firstTrailingBit(_e990), 32u, (_e990 == 0u)));
                                if (_e1000 < _e94) {
                                } else {
                                    return;
                                }
                                let _e1007 = instances.member[(0u + _e1000)].low_world;
                                let _e1009 = instances.member[(0u + _e1000)].high_world;
                                let _e1019 = ((_e1007.x - _e183.origin.x) * _e329);
                                let _e1020 = ((_e1007.y - _e183.origin.y) * _e340);
                                let _e1021 = ((_e1007.z - _e183.origin.z) * _e351);
                                let _e1031 = ((_e1009.x - _e183.origin.x) * _e329);
                                let _e1032 = ((_e1009.y - _e183.origin.y) * _e340);
                                let _e1033 = ((_e1009.z - _e183.origin.z) * _e351);
                                if (_e1019 < _e1031) {
                                    phi_1578_ = _e1019;
                                } else {
                                    phi_1578_ = _e1031;
                                }
                                let _e1036 = phi_1578_;
                                if (_e1020 < _e1032) {
                                    phi_1583_ = _e1020;
                                } else {
                                    phi_1583_ = _e1032;
                                }
                                let _e1039 = phi_1583_;
                                if (_e1021 < _e1033) {
                                    phi_1588_ = _e1021;
                                } else {
                                    phi_1588_ = _e1033;
                                }
                                let _e1042 = phi_1588_;
                                if (_e1019 > _e1031) {
                                    phi_1596_ = _e1019;
                                } else {
                                    phi_1596_ = _e1031;
                                }
                                let _e1048 = phi_1596_;
                                if (_e1020 > _e1032) {
                                    phi_1601_ = _e1020;
                                } else {
                                    phi_1601_ = _e1032;
                                }
                                let _e1051 = phi_1601_;
                                if (_e1021 > _e1033) {
                                    phi_1606_ = _e1021;
                                } else {
                                    phi_1606_ = _e1033;
                                }
                                let _e1054 = phi_1606_;
                                let _e1058 = core_intrinsics_maximum_number_nsz_f32_((_e1036 - _e396), (_e1039 - _e397));
                                let _e1059 = core_intrinsics_maximum_number_nsz_f32_(_e1058, (_e1042 - _e398));
                                let _e1060 = core_intrinsics_minimum_number_nsz_f32_((_e1048 + _e396), (_e1051 + _e397));
                                let _e1061 = core_intrinsics_minimum_number_nsz_f32_(_e1060, (_e1054 + _e398));
                                if (_e1059 <= _e1061) {
                                    if (_e1059 <= _e992.t) {
                                        if (_e1061 >= _e183.tmin) {
                                            let _e1073 = instances.member[(0u + _e1000)].world_to_object[0u];
                                            let _e1084 = ((((_e1073.x * _e183.origin.x) + (_e1073.y * _e183.origin.y)) + (_e1073.z * _e183.origin.z)) + (_e1073.w * 1f));
                                            let _e1086 = instances.member[(0u + _e1000)].world_to_object[1u];
                                            let _e1097 = ((((_e1086.x * _e183.origin.x) + (_e1086.y * _e183.origin.y)) + (_e1086.z * _e183.origin.z)) + (_e1086.w * 1f));
                                            let _e1099 = instances.member[(0u + _e1000)].world_to_object[2u];
                                            let _e1110 = ((((_e1099.x * _e183.origin.x) + (_e1099.y * _e183.origin.y)) + (_e1099.z * _e183.origin.z)) + (_e1099.w * 1f));
                                            let _e1117 = instances.member[(0u + _e1000)].world_to_object[0u];
                                            let _e1128 = ((((_e1117.x * _e183.direction.x) + (_e1117.y * _e183.direction.y)) + (_e1117.z * _e183.direction.z)) + (_e1117.w * 0f));
                                            let _e1130 = instances.member[(0u + _e1000)].world_to_object[1u];
                                            let _e1141 = ((((_e1130.x * _e183.direction.x) + (_e1130.y * _e183.direction.y)) + (_e1130.z * _e183.direction.z)) + (_e1130.w * 0f));
                                            let _e1143 = instances.member[(0u + _e1000)].world_to_object[2u];
                                            let _e1154 = ((((_e1143.x * _e183.direction.x) + (_e1143.y * _e183.direction.y)) + (_e1143.z * _e183.direction.z)) + (_e1143.w * 0f));
                                            let _e1159 = instances.member[(0u + _e1000)].root;
                                            let _e1161 = instances.member[(0u + _e1000)].first_triangle;
                                            let _e1162 = abs(_e1128);
                                            let _e1163 = abs(_e1141);
                                            let _e1164 = abs(_e1154);
                                            if (abs(_e1084) < 1000000000000000f) {
                                                if (abs(_e1097) < 1000000000000000f) {
                                                    phi_1738_ = (abs(_e1110) < 1000000000000000f);
                                                    phi_1739_ = false;
                                                } else {
                                                    phi_1738_ = bool();
                                                    phi_1739_ = true;
                                                }
                                                let _e1172 = phi_1738_;
                                                let _e1174 = phi_1739_;
                                                phi_1740_ = _e1172;
                                                phi_1741_ = _e1174;
                                            } else {
                                                phi_1740_ = bool();
                                                phi_1741_ = true;
                                            }
                                            let _e1176 = phi_1740_;
                                            let _e1178 = phi_1741_;
                                            if _e1178 {
                                                phi_1745_ = false;
                                            } else {
                                                phi_1745_ = _e1176;
                                            }
                                            let _e1180 = phi_1745_;
                                            if _e1180 {
                                                if (_e1162 < 1000000000000000f) {
                                                    if (_e1163 < 1000000000000000f) {
                                                        phi_1758_ = (_e1164 < 1000000000000000f);
                                                        phi_1759_ = false;
                                                    } else {
                                                        phi_1758_ = bool();
                                                        phi_1759_ = true;
                                                    }
                                                    let _e1185 = phi_1758_;
                                                    let _e1187 = phi_1759_;
                                                    phi_1760_ = _e1185;
                                                    phi_1761_ = _e1187;
                                                } else {
                                                    phi_1760_ = bool();
                                                    phi_1761_ = true;
                                                }
                                                let _e1189 = phi_1760_;
                                                let _e1191 = phi_1761_;
                                                if _e1191 {
                                                    phi_1765_ = false;
                                                } else {
                                                    phi_1765_ = _e1189;
                                                }
                                                let _e1193 = phi_1765_;
                                                if _e1193 {
                                                    if (_e1162 > 0f) {
                                                        phi_1779_ = bool();
                                                        phi_1780_ = true;
                                                    } else {
                                                        let _e1195 = (_e1163 > 0f);
                                                        if _e1195 {
                                                            phi_1778_ = bool();
                                                        } else {
                                                            phi_1778_ = (_e1164 > 0f);
                                                        }
                                                        let _e1198 = phi_1778_;
                                                        phi_1779_ = _e1198;
                                                        phi_1780_ = _e1195;
                                                    }
                                                    let _e1200 = phi_1779_;
                                                    let _e1202 = phi_1780_;
                                                    if _e1202 {
                                                        phi_1784_ = true;
                                                    } else {
                                                        phi_1784_ = _e1200;
                                                    }
                                                    let _e1204 = phi_1784_;
                                                    phi_1785_ = _e1204;
                                                    phi_1786_ = false;
                                                } else {
                                                    phi_1785_ = bool();
                                                    phi_1786_ = true;
                                                }
                                                let _e1206 = phi_1785_;
                                                let _e1208 = phi_1786_;
                                                phi_1787_ = _e1206;
                                                phi_1788_ = _e1208;
                                            } else {
                                                phi_1787_ = bool();
                                                phi_1788_ = true;
                                            }
                                            let _e1210 = phi_1787_;
                                            let _e1212 = phi_1788_;
                                            if _e1212 {
                                                phi_1792_ = false;
                                            } else {
                                                phi_1792_ = _e1210;
                                            }
                                            let _e1214 = phi_1792_;
                                            if _e1214 {
                                                let _e1215 = (_e1159 >= _e79);
                                                if _e1215 {
                                                    phi_3203_ = lt_bvh_Hit();
                                                } else {
                                                    if (_e1159 < _e79) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1221 = nodes.member[(0u + _e1159)].frame[0u];
                                                    let _e1225 = nodes.member[(0u + _e1159)].frame[1u];
                                                    let _e1229 = nodes.member[(0u + _e1159)].frame[2u];
                                                    let _e1233 = nodes.member[(0u + _e1159)].frame[0u];
                                                    let _e1237 = nodes.member[(0u + _e1159)].frame[1u];
                                                    let _e1241 = nodes.member[(0u + _e1159)].frame[2u];
                                                    let _e1245 = nodes.member[(0u + _e1159)].frame[3u];
                                                    let _e1279 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1128), abs(_e1141));
                                                    let _e1280 = core_intrinsics_maximum_number_nsz_f32_(_e1279, abs(_e1154));
                                                    let _e1281 = (_e1280 * 0.0000000000009094947f);
                                                    if (abs(_e1128) < _e1281) {
                                                        phi_1862_ = _e1281;
                                                    } else {
                                                        phi_1862_ = abs(_e1128);
                                                    }
                                                    let _e1286 = phi_1862_;
                                                    if (_e1128 < 0f) {
                                                        phi_1869_ = (-1f / _e1286);
                                                    } else {
                                                        phi_1869_ = (1f / _e1286);
                                                    }
                                                    let _e1291 = phi_1869_;
                                                    if (abs(_e1141) < _e1281) {
                                                        phi_1876_ = _e1281;
                                                    } else {
                                                        phi_1876_ = abs(_e1141);
                                                    }
                                                    let _e1296 = phi_1876_;
                                                    if (_e1141 < 0f) {
                                                        phi_1883_ = (-1f / _e1296);
                                                    } else {
                                                        phi_1883_ = (1f / _e1296);
                                                    }
                                                    let _e1301 = phi_1883_;
                                                    if (abs(_e1154) < _e1281) {
                                                        phi_1890_ = _e1281;
                                                    } else {
                                                        phi_1890_ = abs(_e1154);
                                                    }
                                                    let _e1306 = phi_1890_;
                                                    if (_e1154 < 0f) {
                                                        phi_1897_ = (-1f / _e1306);
                                                    } else {
                                                        phi_1897_ = (1f / _e1306);
                                                    }
                                                    let _e1311 = phi_1897_;
                                                    let _e1315 = abs((bitcast<f32>(_e1221) - _e1084));
                                                    let _e1316 = abs((bitcast<f32>(_e1225) - _e1097));
                                                    let _e1317 = abs((bitcast<f32>(_e1229) - _e1110));
                                                    let _e1321 = abs(((bitcast<f32>(_e1233) + (bitcast<f32>((((_e1245 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1084));
                                                    let _e1322 = abs(((bitcast<f32>(_e1237) + (bitcast<f32>((((_e1245 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1097));
                                                    let _e1323 = abs(((bitcast<f32>(_e1241) + (bitcast<f32>((((_e1245 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1110));
                                                    if (_e1315 > _e1321) {
                                                        phi_1914_ = _e1315;
                                                    } else {
                                                        phi_1914_ = _e1321;
                                                    }
                                                    let _e1326 = phi_1914_;
                                                    if (_e1316 > _e1322) {
                                                        phi_1919_ = _e1316;
                                                    } else {
                                                        phi_1919_ = _e1322;
                                                    }
                                                    let _e1329 = phi_1919_;
                                                    if (_e1317 > _e1323) {
                                                        phi_1924_ = _e1317;
                                                    } else {
                                                        phi_1924_ = _e1323;
                                                    }
                                                    let _e1332 = phi_1924_;
                                                    if (_e1326 > _e1329) {
                                                        phi_1929_ = _e1326;
                                                    } else {
                                                        phi_1929_ = _e1329;
                                                    }
                                                    let _e1335 = phi_1929_;
                                                    if (_e1335 > _e1332) {
                                                        phi_1934_ = _e1335;
                                                    } else {
                                                        phi_1934_ = _e1332;
                                                    }
                                                    let _e1338 = phi_1934_;
                                                    let _e1342 = (_e1338 * 0.0000019073486f);
                                                    let _e1343 = (abs(_e1291) * _e1342);
                                                    let _e1344 = (abs(_e1301) * _e1342);
                                                    let _e1345 = (abs(_e1311) * _e1342);
                                                    let _e1349 = (_e1338 * 0.0000009536743f);
                                                    let _e1350 = (abs(_e1291) * _e1349);
                                                    let _e1351 = (abs(_e1301) * _e1349);
                                                    let _e1352 = (abs(_e1311) * _e1349);
                                                    let _e1353 = abs(_e1128);
                                                    let _e1354 = abs(_e1141);
                                                    let _e1355 = abs(_e1154);
                                                    if (_e1353 >= _e1354) {
                                                        if (_e1353 >= _e1355) {
                                                            phi_1960_ = false;
                                                        } else {
                                                            phi_1960_ = true;
                                                        }
                                                        let _e1359 = phi_1960_;
                                                        phi_1961_ = _e1359;
                                                    } else {
                                                        phi_1961_ = true;
                                                    }
                                                    let _e1361 = phi_1961_;
                                                    if _e1361 {
                                                        if (_e1354 >= _e1355) {
                                                            phi_1969_ = 1u;
                                                        } else {
                                                            phi_1969_ = 2u;
                                                        }
                                                        let _e1364 = phi_1969_;
                                                        phi_1970_ = _e1364;
                                                    } else {
                                                        phi_1970_ = 0u;
                                                    }
                                                    let _e1366 = phi_1970_;
                                                    if (_e1366 == 0u) {
                                                        phi_1982_ = vec3<f32>(_e1141, _e1154, _e1128);
                                                    } else {
                                                        if (_e1366 == 1u) {
                                                            phi_1981_ = vec3<f32>(_e1154, _e1128, _e1141);
                                                        } else {
                                                            phi_1981_ = vec3<f32>(_e1128, _e1141, _e1154);
                                                        }
                                                        let _e1372 = phi_1981_;
                                                        phi_1982_ = _e1372;
                                                    }
                                                    let _e1374 = phi_1982_;
                                                    let _e1377 = (_e1374.x / _e1374.z);
                                                    let _e1380 = (_e1374.y / _e1374.z);
                                                    if (_e1291 < 0f) {
                                                        phi_1995_ = 0u;
                                                    } else {
                                                        phi_1995_ = 1u;
                                                    }
                                                    let _e1385 = phi_1995_;
                                                    if (_e1301 < 0f) {
                                                        phi_2000_ = 0u;
                                                    } else {
                                                        phi_2000_ = 2u;
                                                    }
                                                    let _e1388 = phi_2000_;
                                                    if (_e1311 < 0f) {
                                                        phi_2005_ = 0u;
                                                    } else {
                                                        phi_2005_ = 4u;
                                                    }
                                                    let _e1391 = phi_2005_;
                                                    let _e1393 = ((_e1385 | _e1388) | _e1391);
                                                    let _e1394 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1159, 2147483648u);
                                                    local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e1394.first[0], _e1394.first[1], _e1394.first[2], _e1394.first[3], _e1394.first[4], _e1394.first[5], _e1394.first[6], _e1394.first[7], _e1394.first[8], _e1394.first[9], _e1394.first[10], _e1394.first[11], _e1394.first[12], _e1394.first[13], _e1394.first[14], _e1394.first[15], _e1394.first[16], _e1394.first[17], _e1394.first[18], _e1394.first[19], _e1394.first[20], _e1394.first[21], _e1394.first[22], _e1394.first[23], _e1394.first[24], _e1394.first[25], _e1394.first[26], _e1394.first[27], _e1394.first[28], _e1394.first[29], _e1394.first[30], _e1394.first[31]), array<u32, 32>(_e1394.mask[0], _e1394.mask[1], _e1394.mask[2], _e1394.mask[3], _e1394.mask[4], _e1394.mask[5], _e1394.mask[6], _e1394.mask[7], _e1394.mask[8], _e1394.mask[9], _e1394.mask[10], _e1394.mask[11], _e1394.mask[12], _e1394.mask[13], _e1394.mask[14], _e1394.mask[15], _e1394.mask[16], _e1394.mask[17], _e1394.mask[18], _e1394.mask[19], _e1394.mask[20], _e1394.mask[21], _e1394.mask[22], _e1394.mask[23], _e1394.mask[24], _e1394.mask[25], _e1394.mask[26], _e1394.mask[27], _e1394.mask[28], _e1394.mask[29], _e1394.mask[30], _e1394.mask[31]), _e1394.len, _e1394.group, _e1394.group_mask);
                                                    let _e1468 = local_1.group_mask;
                                                    if ((_e1468 & 4278190080u) == 0u) {
                                                        let _e1472 = local_1.len;
                                                        if (_e1472 == 0u) {
                                                            phi_2119_ = false;
                                                        } else {
                                                            let _e1476 = local_1.len;
                                                            local_1.len = (_e1476 - 1u);
                                                            let _e1479 = local_1.len;
                                                            if (_e1479 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1484 = local_1.first[(0u + _e1479)];
                                                            local_1.group = _e1484;
                                                            let _e1487 = local_1.len;
                                                            if (_e1487 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1492 = local_1.mask[(0u + _e1487)];
                                                            local_1.group_mask = _e1492;
                                                            phi_2119_ = true;
                                                        }
                                                        let _e1495 = phi_2119_;
                                                        phi_2120_ = _e1495;
                                                    } else {
                                                        phi_2120_ = true;
                                                    }
                                                    let _e1497 = phi_2120_;
                                                    if _e1497 {
                                                        let _e1499 = local_1.group_mask;
                                                        let _e1505 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1499)), 32u, (_e1499 == 0u)));
                                                        let _e1509 = local_1.group_mask;
                                                        let _e1523 = local_1.group_mask;
                                                        local_1.group_mask = (_e1523 & ~((1u << bitcast<u32>((_e1505 & 31u)))));
                                                        let _e1526 = local_1.group;
                                                        phi_2151_ = (_e1526 + countOneBits(((_e1509 & ~((4294967295u << bitcast<u32>((((_e1505 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_2151_ = 4294967295u;
                                                    }
                                                    let _e1529 = phi_2151_;
                                                    phi_2153_ = _e992;
                                                    phi_2156_ = _e1529;
                                                    loop {
                                                        let _e1531 = phi_2153_;
                                                        let _e1533 = phi_2156_;
                                                        local_10 = _e1531;
                                                        let _e1534 = (_e1533 != 4294967295u);
                                                        if _e1534 {
                                                            if (_e1533 < _e79) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1541 = nodes.member[(0u + _e1533)].frame[3u];
                                                            let _e1566 = (bitcast<f32>((((_e1541 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1291);
                                                            let _e1567 = (bitcast<f32>((((_e1541 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1301);
                                                            let _e1568 = (bitcast<f32>((((_e1541 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1311);
                                                            let _e1571 = nodes.member[(0u + _e1533)].frame[0u];
                                                            let _e1575 = nodes.member[(0u + _e1533)].frame[1u];
                                                            let _e1579 = nodes.member[(0u + _e1533)].frame[2u];
                                                            let _e1584 = ((bitcast<f32>(_e1571) - _e1084) * _e1291);
                                                            let _e1585 = ((bitcast<f32>(_e1575) - _e1097) * _e1301);
                                                            let _e1586 = ((bitcast<f32>(_e1579) - _e1110) * _e1311);
                                                            let _e1594 = nodes.member[(0u + _e1533)].x;
                                                            if (_e1291 < 0f) {
                                                                let _e1605 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1594.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1611 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1605.unnamed.word, _e1594.w), _e1605.unnamed_1);
                                                                let _e1617 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1611.unnamed, lt_mask_LightPlace(_e1594.x, _e1611.unnamed_1.shift));
                                                                phi_2237_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1617.unnamed, lt_mask_LightPlace(_e1617.unnamed_1.word, _e1594.y));
                                                            } else {
                                                                let _e1633 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1594.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1639 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1633.unnamed.word, _e1594.y), _e1633.unnamed_1);
                                                                let _e1645 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1639.unnamed, lt_mask_LightPlace(_e1594.z, _e1639.unnamed_1.shift));
                                                                phi_2237_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1645.unnamed, lt_mask_LightPlace(_e1645.unnamed_1.word, _e1594.w));
                                                            }
                                                            let _e1653 = phi_2237_;
                                                            let _e1663 = nodes.member[(0u + _e1533)].y;
                                                            if (_e1301 < 0f) {
                                                                let _e1674 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1663.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1680 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1674.unnamed.word, _e1663.w), _e1674.unnamed_1);
                                                                let _e1686 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1680.unnamed, lt_mask_LightPlace(_e1663.x, _e1680.unnamed_1.shift));
                                                                phi_2264_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1686.unnamed, lt_mask_LightPlace(_e1686.unnamed_1.word, _e1663.y));
                                                            } else {
                                                                let _e1702 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1663.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1708 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1702.unnamed.word, _e1663.y), _e1702.unnamed_1);
                                                                let _e1714 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1708.unnamed, lt_mask_LightPlace(_e1663.z, _e1708.unnamed_1.shift));
                                                                phi_2264_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1714.unnamed, lt_mask_LightPlace(_e1714.unnamed_1.word, _e1663.w));
                                                            }
                                                            let _e1722 = phi_2264_;
                                                            let _e1732 = nodes.member[(0u + _e1533)].z;
                                                            if (_e1311 < 0f) {
                                                                let _e1743 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1732.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1749 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1743.unnamed.word, _e1732.w), _e1743.unnamed_1);
                                                                let _e1755 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1749.unnamed, lt_mask_LightPlace(_e1732.x, _e1749.unnamed_1.shift));
                                                                phi_2291_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1755.unnamed, lt_mask_LightPlace(_e1755.unnamed_1.word, _e1732.y));
                                                            } else {
                                                                let _e1771 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1732.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1777 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1771.unnamed.word, _e1732.y), _e1771.unnamed_1);
                                                                let _e1783 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1777.unnamed, lt_mask_LightPlace(_e1732.z, _e1777.unnamed_1.shift));
                                                                phi_2291_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1783.unnamed, lt_mask_LightPlace(_e1783.unnamed_1.word, _e1732.w));
                                                            }
                                                            let _e1791 = phi_2291_;
                                                            phi_2297_ = 0u;
                                                            phi_2300_ = 0u;
                                                            loop {
                                                                let _e1801 = phi_2297_;
                                                                let _e1803 = phi_2300_;
                                                                local_6 = _e1803;
                                                                local_7 = _e1803;
                                                                local_8 = _e1803;
                                                                let _e1804 = (_e1801 < 8u);
                                                                if _e1804 {
                                                                    let _e1806 = (_e1801 >> bitcast<u32>(2i));
                                                                    let _e1807 = (_e1801 & 3u);
                                                                    if (_e1806 == 0u) {
                                                                        phi_2314_ = _e1653.unnamed.word;
                                                                    } else {
                                                                        phi_2314_ = _e1653.unnamed.shift;
                                                                    }
                                                                    let _e1810 = phi_2314_;
                                                                    if (_e1806 == 0u) {
                                                                        phi_2324_ = _e1722.unnamed.word;
                                                                    } else {
                                                                        phi_2324_ = _e1722.unnamed.shift;
                                                                    }
                                                                    let _e1819 = phi_2324_;
                                                                    if (_e1806 == 0u) {
                                                                        phi_2334_ = _e1791.unnamed.word;
                                                                    } else {
                                                                        phi_2334_ = _e1791.unnamed.shift;
                                                                    }
                                                                    let _e1828 = phi_2334_;
                                                                    let _e1841 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1810 >> bitcast<u32>(((_e1807 * 8u) & 31u))) & 255u)) * _e1566) + (_e1584 - _e1343)), ((f32(((_e1819 >> bitcast<u32>(((_e1807 * 8u) & 31u))) & 255u)) * _e1567) + (_e1585 - _e1344)));
                                                                    let _e1842 = core_intrinsics_maximum_number_nsz_f32_(_e1841, ((f32(((_e1828 >> bitcast<u32>(((_e1807 * 8u) & 31u))) & 255u)) * _e1568) + (_e1586 - _e1345)));
                                                                    if (_e1806 == 0u) {
                                                                        phi_2352_ = _e1653.unnamed_1.word;
                                                                    } else {
                                                                        phi_2352_ = _e1653.unnamed_1.shift;
                                                                    }
                                                                    let _e1845 = phi_2352_;
                                                                    if (_e1806 == 0u) {
                                                                        phi_2362_ = _e1722.unnamed_1.word;
                                                                    } else {
                                                                        phi_2362_ = _e1722.unnamed_1.shift;
                                                                    }
                                                                    let _e1854 = phi_2362_;
                                                                    if (_e1806 == 0u) {
                                                                        phi_2372_ = _e1791.unnamed_1.word;
                                                                    } else {
                                                                        phi_2372_ = _e1791.unnamed_1.shift;
                                                                    }
                                                                    let _e1863 = phi_2372_;
                                                                    let _e1876 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1845 >> bitcast<u32>(((_e1807 * 8u) & 31u))) & 255u)) * _e1566) + (_e1584 + _e1343)), ((f32(((_e1854 >> bitcast<u32>(((_e1807 * 8u) & 31u))) & 255u)) * _e1567) + (_e1585 + _e1344)));
                                                                    let _e1877 = core_intrinsics_minimum_number_nsz_f32_(_e1876, ((f32(((_e1863 >> bitcast<u32>(((_e1807 * 8u) & 31u))) & 255u)) * _e1568) + (_e1586 + _e1345)));
                                                                    if (_e1842 <= _e1877) {
                                                                        if (_e1842 <= _e1531.t) {
                                                                            if (_e1877 >= _e183.tmin) {
                                                                                if (_e1806 == 0u) {
                                                                                    let _e1884 = nodes.member[(0u + _e1533)].links[2u];
                                                                                    phi_2408_ = _e1884;
                                                                                } else {
                                                                                    let _e1887 = nodes.member[(0u + _e1533)].links[3u];
                                                                                    phi_2408_ = _e1887;
                                                                                }
                                                                                let _e1889 = phi_2408_;
                                                                                let _e1894 = ((_e1889 >> bitcast<u32>(((_e1807 * 8u) & 31u))) & 255u);
                                                                                let _e1895 = (_e1894 & 31u);
                                                                                if (_e1895 >= 24u) {
                                                                                    phi_2421_ = (24u + ((_e1895 - 24u) ^ _e1393));
                                                                                } else {
                                                                                    phi_2421_ = _e1895;
                                                                                }
                                                                                let _e1901 = phi_2421_;
                                                                                phi_2426_ = (_e1803 | ((_e1894 >> bitcast<u32>(5i)) << bitcast<u32>((_e1901 & 31u))));
                                                                            } else {
                                                                                phi_2426_ = _e1803;
                                                                            }
                                                                            let _e1909 = phi_2426_;
                                                                            phi_2427_ = _e1909;
                                                                        } else {
                                                                            phi_2427_ = _e1803;
                                                                        }
                                                                        let _e1911 = phi_2427_;
                                                                        phi_2428_ = _e1911;
                                                                    } else {
                                                                        phi_2428_ = _e1803;
                                                                    }
                                                                    let _e1913 = phi_2428_;
                                                                    phi_2298_ = (_e1801 + 1u);
                                                                    phi_2301_ = _e1913;
                                                                } else {
                                                                    phi_2298_ = u32();
                                                                    phi_2301_ = u32();
                                                                }
                                                                let _e1916 = phi_2298_;
                                                                let _e1918 = phi_2301_;
                                                                continue;
                                                                continuing {
                                                                    phi_2297_ = _e1916;
                                                                    phi_2300_ = _e1918;
                                                                    break if !(_e1804);
                                                                }
                                                            }
                                                            let _e1922 = nodes.member[(0u + _e1533)].links[0u];
                                                            let _e1926 = nodes.member[(0u + _e1533)].frame[3u];
                                                            let _e1930 = local_6;
                                                            if ((_e1930 & 4278190080u) == 0u) {
                                                            } else {
                                                                let _e1934 = local_1.group_mask;
                                                                if ((_e1934 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1938 = local_1.len;
                                                                    if (_e1938 < 32u) {
                                                                        let _e1941 = local_1.group;
                                                                        let _e1943 = local_1.len;
                                                                        if (_e1943 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_1.first[(0u + _e1943)] = _e1941;
                                                                        let _e1949 = local_1.group_mask;
                                                                        let _e1951 = local_1.len;
                                                                        if (_e1951 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_1.mask[(0u + _e1951)] = _e1949;
                                                                        let _e1958 = local_1.len;
                                                                        local_1.len = (_e1958 + 1u);
                                                                    }
                                                                }
                                                                local_1.group = (_e1159 + _e1922);
                                                                let _e1962 = local_7;
                                                                local_1.group_mask = ((_e1962 & 4278190080u) | (_e1926 >> bitcast<u32>(24i)));
                                                            }
                                                            let _e1967 = local_8;
                                                            phi_2486_ = _e1531;
                                                            phi_2489_ = (_e1967 & 16777215u);
                                                            loop {
                                                                let _e1970 = phi_2486_;
                                                                let _e1972 = phi_2489_;
                                                                local_9 = _e1970;
                                                                if (_e1972 == 0u) {
                                                                    phi_2487_ = lt_bvh_Hit();
                                                                    phi_2490_ = u32();
                                                                    phi_3131_ = false;
                                                                } else {
                                                                    let _e1976 = nodes.member[(0u + _e1533)].links[1u];
                                                                    let _e1981 = ((_e1161 + _e1976) + select(firstTrailingBit(_e1972), 32u, (_e1972 == 0u)));
                                                                    if (_e1981 < _e82) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1988 = triangles.member[(0u + _e1981)].v0_;
                                                                    let _e1990 = (_e1988.x - _e1084);
                                                                    let _e1992 = (_e1988.y - _e1097);
                                                                    let _e1994 = (_e1988.z - _e1110);
                                                                    if (_e1366 == 0u) {
                                                                        phi_2534_ = vec3<f32>(_e1992, _e1994, _e1990);
                                                                    } else {
                                                                        if (_e1366 == 1u) {
                                                                            phi_2533_ = vec3<f32>(_e1994, _e1990, _e1992);
                                                                        } else {
                                                                            phi_2533_ = (_e1988 - vec3<f32>(_e1084, _e1097, _e1110));
                                                                        }
                                                                        let _e2002 = phi_2533_;
                                                                        phi_2534_ = _e2002;
                                                                    }
                                                                    let _e2004 = phi_2534_;
                                                                    let _e2008 = (_e2004.x - (_e1377 * _e2004.z));
                                                                    let _e2012 = (_e2004.y - (_e1380 * _e2004.z));
                                                                    let _e2014 = triangles.member[(0u + _e1981)].v1_;
                                                                    let _e2016 = (_e2014.x - _e1084);
                                                                    let _e2018 = (_e2014.y - _e1097);
                                                                    let _e2020 = (_e2014.z - _e1110);
                                                                    if (_e1366 == 0u) {
                                                                        phi_2564_ = vec3<f32>(_e2018, _e2020, _e2016);
                                                                    } else {
                                                                        if (_e1366 == 1u) {
                                                                            phi_2563_ = vec3<f32>(_e2020, _e2016, _e2018);
                                                                        } else {
                                                                            phi_2563_ = (_e2014 - vec3<f32>(_e1084, _e1097, _e1110));
                                                                        }
                                                                        let _e2028 = phi_2563_;
                                                                        phi_2564_ = _e2028;
                                                                    }
                                                                    let _e2030 = phi_2564_;
                                                                    let _e2034 = (_e2030.x - (_e1377 * _e2030.z));
                                                                    let _e2038 = (_e2030.y - (_e1380 * _e2030.z));
                                                                    let _e2040 = triangles.member[(0u + _e1981)].v2_;
                                                                    let _e2042 = (_e2040.x - _e1084);
                                                                    let _e2044 = (_e2040.y - _e1097);
                                                                    let _e2046 = (_e2040.z - _e1110);
                                                                    if (_e1366 == 0u) {
                                                                        phi_2594_ = vec3<f32>(_e2044, _e2046, _e2042);
                                                                    } else {
                                                                        if (_e1366 == 1u) {
                                                                            phi_2593_ = vec3<f32>(_e2046, _e2042, _e2044);
                                                                        } else {
                                                                            phi_2593_ = (_e2040 - vec3<f32>(_e1084, _e1097, _e1110));
                                                                        }
                                                                        let _e2054 = phi_2593_;
                                                                        phi_2594_ = _e2054;
                                                                    }
                                                                    let _e2056 = phi_2594_;
                                                                    let _e2060 = (_e2056.x - (_e1377 * _e2056.z));
                                                                    let _e2064 = (_e2056.y - (_e1380 * _e2056.z));
                                                                    if (_e2034 < _e2060) {
                                                                        phi_2613_ = true;
                                                                    } else {
                                                                        if (_e2034 == _e2060) {
                                                                            phi_2612_ = (_e2038 < _e2064);
                                                                        } else {
                                                                            phi_2612_ = false;
                                                                        }
                                                                        let _e2069 = phi_2612_;
                                                                        phi_2613_ = _e2069;
                                                                    }
                                                                    let _e2071 = phi_2613_;
                                                                    if _e2071 {
                                                                        phi_2617_ = _e2064;
                                                                        phi_2618_ = _e2060;
                                                                        phi_2619_ = _e2038;
                                                                        phi_2620_ = _e2034;
                                                                    } else {
                                                                        phi_2617_ = _e2038;
                                                                        phi_2618_ = _e2034;
                                                                        phi_2619_ = _e2064;
                                                                        phi_2620_ = _e2060;
                                                                    }
                                                                    let _e2073 = phi_2617_;
                                                                    let _e2075 = phi_2618_;
                                                                    let _e2077 = phi_2619_;
                                                                    let _e2079 = phi_2620_;
                                                                    let _e2082 = ((_e2079 * _e2073) - (_e2077 * _e2075));
                                                                    if _e2071 {
                                                                        phi_2628_ = -(_e2082);
                                                                    } else {
                                                                        phi_2628_ = _e2082;
                                                                    }
                                                                    let _e2085 = phi_2628_;
                                                                    if (_e2060 < _e2008) {
                                                                        phi_2639_ = true;
                                                                    } else {
                                                                        if (_e2060 == _e2008) {
                                                                            phi_2638_ = (_e2064 < _e2012);
                                                                        } else {
                                                                            phi_2638_ = false;
                                                                        }
                                                                        let _e2090 = phi_2638_;
                                                                        phi_2639_ = _e2090;
                                                                    }
                                                                    let _e2092 = phi_2639_;
                                                                    if _e2092 {
                                                                        phi_2643_ = _e2012;
                                                                        phi_2644_ = _e2008;
                                                                        phi_2645_ = _e2064;
                                                                        phi_2646_ = _e2060;
                                                                    } else {
                                                                        phi_2643_ = _e2064;
                                                                        phi_2644_ = _e2060;
                                                                        phi_2645_ = _e2012;
                                                                        phi_2646_ = _e2008;
                                                                    }
                                                                    let _e2094 = phi_2643_;
                                                                    let _e2096 = phi_2644_;
                                                                    let _e2098 = phi_2645_;
                                                                    let _e2100 = phi_2646_;
                                                                    let _e2103 = ((_e2100 * _e2094) - (_e2098 * _e2096));
                                                                    if _e2092 {
                                                                        phi_2654_ = -(_e2103);
                                                                    } else {
                                                                        phi_2654_ = _e2103;
                                                                    }
                                                                    let _e2106 = phi_2654_;
                                                                    if (_e2008 < _e2034) {
                                                                        phi_2665_ = true;
                                                                    } else {
                                                                        if (_e2008 == _e2034) {
                                                                            phi_2664_ = (_e2012 < _e2038);
                                                                        } else {
                                                                            phi_2664_ = false;
                                                                        }
                                                                        let _e2111 = phi_2664_;
                                                                        phi_2665_ = _e2111;
                                                                    }
                                                                    let _e2113 = phi_2665_;
                                                                    if _e2113 {
                                                                        phi_2669_ = _e2038;
                                                                        phi_2670_ = _e2034;
                                                                        phi_2671_ = _e2012;
                                                                        phi_2672_ = _e2008;
                                                                    } else {
                                                                        phi_2669_ = _e2012;
                                                                        phi_2670_ = _e2008;
                                                                        phi_2671_ = _e2038;
                                                                        phi_2672_ = _e2034;
                                                                    }
                                                                    let _e2115 = phi_2669_;
                                                                    let _e2117 = phi_2670_;
                                                                    let _e2119 = phi_2671_;
                                                                    let _e2121 = phi_2672_;
                                                                    let _e2124 = ((_e2121 * _e2115) - (_e2119 * _e2117));
                                                                    if _e2113 {
                                                                        phi_2680_ = -(_e2124);
                                                                    } else {
                                                                        phi_2680_ = _e2124;
                                                                    }
                                                                    let _e2127 = phi_2680_;
                                                                    if (_e2085 >= 0f) {
                                                                        if (_e2106 >= 0f) {
                                                                            if (_e2127 >= 0f) {
                                                                                phi_2695_ = ((_e2085 + _e2106) + _e2127);
                                                                                phi_2696_ = false;
                                                                            } else {
                                                                                phi_2695_ = f32();
                                                                                phi_2696_ = true;
                                                                            }
                                                                            let _e2134 = phi_2695_;
                                                                            let _e2136 = phi_2696_;
                                                                            phi_2697_ = _e2134;
                                                                            phi_2698_ = _e2136;
                                                                        } else {
                                                                            phi_2697_ = f32();
                                                                            phi_2698_ = true;
                                                                        }
                                                                        let _e2138 = phi_2697_;
                                                                        let _e2140 = phi_2698_;
                                                                        phi_2699_ = _e2138;
                                                                        phi_2700_ = _e2140;
                                                                    } else {
                                                                        phi_2699_ = f32();
                                                                        phi_2700_ = true;
                                                                    }
                                                                    let _e2142 = phi_2699_;
                                                                    let _e2144 = phi_2700_;
                                                                    if _e2144 {
                                                                        if (_e2085 <= 0f) {
                                                                            if (_e2106 <= 0f) {
                                                                                let _e2147 = (_e2127 <= 0f);
                                                                                if _e2147 {
                                                                                }
                                                                                phi_2718_ = ((_e2085 + _e2106) + _e2127);
                                                                                phi_2719_ = false;
                                                                                phi_2720_ = _e2147;
                                                                            } else {
                                                                                phi_2718_ = f32();
                                                                                phi_2719_ = true;
                                                                                phi_2720_ = false;
                                                                            }
                                                                            let _e2151 = phi_2718_;
                                                                            let _e2153 = phi_2719_;
                                                                            let _e2155 = phi_2720_;
                                                                            phi_2721_ = _e2151;
                                                                            phi_2722_ = _e2153;
                                                                            phi_2723_ = _e2155;
                                                                        } else {
                                                                            phi_2721_ = f32();
                                                                            phi_2722_ = true;
                                                                            phi_2723_ = false;
                                                                        }
                                                                        let _e2157 = phi_2721_;
                                                                        let _e2159 = phi_2722_;
                                                                        let _e2161 = phi_2723_;
                                                                        if _e2159 {
                                                                            phi_2727_ = false;
                                                                        } else {
                                                                            phi_2727_ = _e2161;
                                                                        }
                                                                        let _e2163 = phi_2727_;
                                                                        phi_2728_ = _e2157;
                                                                        phi_2729_ = _e2163;
                                                                    } else {
                                                                        phi_2728_ = _e2142;
                                                                        phi_2729_ = true;
                                                                    }
                                                                    let _e2165 = phi_2728_;
                                                                    let _e2167 = phi_2729_;
                                                                    if _e2167 {
                                                                        let _e2168 = (_e2165 == 0f);
                                                                        if _e2168 {
                                                                            phi_3045_ = lt_bvh_triangle_Intersection();
                                                                            phi_3046_ = false;
                                                                        } else {
                                                                            let _e2170 = triangles.member[(0u + _e1981)].v0_;
                                                                            let _e2172 = (_e2170.x - _e1084);
                                                                            let _e2174 = (_e2170.y - _e1097);
                                                                            let _e2176 = (_e2170.z - _e1110);
                                                                            if (_e1366 == 0u) {
                                                                                phi_2758_ = vec3<f32>(_e2174, _e2176, _e2172);
                                                                            } else {
                                                                                if (_e1366 == 1u) {
                                                                                    phi_2757_ = vec3<f32>(_e2176, _e2172, _e2174);
                                                                                } else {
                                                                                    phi_2757_ = (_e2170 - vec3<f32>(_e1084, _e1097, _e1110));
                                                                                }
                                                                                let _e2184 = phi_2757_;
                                                                                phi_2758_ = _e2184;
                                                                            }
                                                                            let _e2186 = phi_2758_;
                                                                            let _e2188 = triangles.member[(0u + _e1981)].v1_;
                                                                            let _e2190 = triangles.member[(0u + _e1981)].v0_;
                                                                            let _e2193 = (_e2188.x - _e2190.x);
                                                                            let _e2196 = (_e2188.y - _e2190.y);
                                                                            let _e2199 = (_e2188.z - _e2190.z);
                                                                            if (_e1366 == 0u) {
                                                                                phi_2784_ = vec3<f32>(_e2196, _e2199, _e2193);
                                                                            } else {
                                                                                if (_e1366 == 1u) {
                                                                                    phi_2783_ = vec3<f32>(_e2199, _e2193, _e2196);
                                                                                } else {
                                                                                    phi_2783_ = (_e2188 - _e2190);
                                                                                }
                                                                                let _e2206 = phi_2783_;
                                                                                phi_2784_ = _e2206;
                                                                            }
                                                                            let _e2208 = phi_2784_;
                                                                            let _e2210 = triangles.member[(0u + _e1981)].v2_;
                                                                            let _e2212 = triangles.member[(0u + _e1981)].v0_;
                                                                            let _e2215 = (_e2210.x - _e2212.x);
                                                                            let _e2218 = (_e2210.y - _e2212.y);
                                                                            let _e2221 = (_e2210.z - _e2212.z);
                                                                            if (_e1366 == 0u) {
                                                                                phi_2810_ = vec3<f32>(_e2218, _e2221, _e2215);
                                                                            } else {
                                                                                if (_e1366 == 1u) {
                                                                                    phi_2809_ = vec3<f32>(_e2221, _e2215, _e2218);
                                                                                } else {
                                                                                    phi_2809_ = (_e2210 - _e2212);
                                                                                }
                                                                                let _e2228 = phi_2809_;
                                                                                phi_2810_ = _e2228;
                                                                            }
                                                                            let _e2230 = phi_2810_;
                                                                            let _e2237 = ((_e2208.y * _e2230.z) - (_e2208.z * _e2230.y));
                                                                            let _e2244 = ((_e2208.z * _e2230.x) - (_e2208.x * _e2230.z));
                                                                            let _e2251 = ((_e2208.x * _e2230.y) - (_e2208.y * _e2230.x));
                                                                            let _e2265 = (((1f / _e1374.z) * (((_e2237 * _e2186.x) + (_e2244 * _e2186.y)) + (_e2251 * _e2186.z))) / (((_e2237 * _e1377) + (_e2244 * _e1380)) + _e2251));
                                                                            if (_e2265 > _e183.tmin) {
                                                                                if (_e2265 < _e183.tmax) {
                                                                                    let _e2269 = triangles.member[(0u + _e1981)].v0_;
                                                                                    let _e2271 = triangles.member[(0u + _e1981)].v1_;
                                                                                    if (_e2269.x < _e2271.x) {
                                                                                        phi_2866_ = _e2269.x;
                                                                                    } else {
                                                                                        phi_2866_ = _e2271.x;
                                                                                    }
                                                                                    let _e2278 = phi_2866_;
                                                                                    if (_e2269.y < _e2271.y) {
                                                                                        phi_2875_ = _e2269.y;
                                                                                    } else {
                                                                                        phi_2875_ = _e2271.y;
                                                                                    }
                                                                                    let _e2285 = phi_2875_;
                                                                                    if (_e2269.z < _e2271.z) {
                                                                                        phi_2884_ = _e2269.z;
                                                                                    } else {
                                                                                        phi_2884_ = _e2271.z;
                                                                                    }
                                                                                    let _e2292 = phi_2884_;
                                                                                    let _e2294 = triangles.member[(0u + _e1981)].v2_;
                                                                                    if (_e2278 < _e2294.x) {
                                                                                        phi_2893_ = _e2278;
                                                                                    } else {
                                                                                        phi_2893_ = _e2294.x;
                                                                                    }
                                                                                    let _e2299 = phi_2893_;
                                                                                    if (_e2285 < _e2294.y) {
                                                                                        phi_2900_ = _e2285;
                                                                                    } else {
                                                                                        phi_2900_ = _e2294.y;
                                                                                    }
                                                                                    let _e2304 = phi_2900_;
                                                                                    if (_e2292 < _e2294.z) {
                                                                                        phi_2907_ = _e2292;
                                                                                    } else {
                                                                                        phi_2907_ = _e2294.z;
                                                                                    }
                                                                                    let _e2309 = phi_2907_;
                                                                                    let _e2311 = triangles.member[(0u + _e1981)].v0_;
                                                                                    let _e2313 = triangles.member[(0u + _e1981)].v1_;
                                                                                    if (_e2311.x > _e2313.x) {
                                                                                        phi_2920_ = _e2311.x;
                                                                                    } else {
                                                                                        phi_2920_ = _e2313.x;
                                                                                    }
                                                                                    let _e2320 = phi_2920_;
                                                                                    if (_e2311.y > _e2313.y) {
                                                                                        phi_2929_ = _e2311.y;
                                                                                    } else {
                                                                                        phi_2929_ = _e2313.y;
                                                                                    }
                                                                                    let _e2327 = phi_2929_;
                                                                                    if (_e2311.z > _e2313.z) {
                                                                                        phi_2938_ = _e2311.z;
                                                                                    } else {
                                                                                        phi_2938_ = _e2313.z;
                                                                                    }
                                                                                    let _e2334 = phi_2938_;
                                                                                    let _e2336 = triangles.member[(0u + _e1981)].v2_;
                                                                                    if (_e2320 > _e2336.x) {
                                                                                        phi_2947_ = _e2320;
                                                                                    } else {
                                                                                        phi_2947_ = _e2336.x;
                                                                                    }
                                                                                    let _e2341 = phi_2947_;
                                                                                    if (_e2327 > _e2336.y) {
                                                                                        phi_2954_ = _e2327;
                                                                                    } else {
                                                                                        phi_2954_ = _e2336.y;
                                                                                    }
                                                                                    let _e2346 = phi_2954_;
                                                                                    if (_e2334 > _e2336.z) {
                                                                                        phi_2961_ = _e2334;
                                                                                    } else {
                                                                                        phi_2961_ = _e2336.z;
                                                                                    }
                                                                                    let _e2351 = phi_2961_;
                                                                                    let _e2355 = ((_e2299 - _e1084) * _e1291);
                                                                                    let _e2356 = ((_e2304 - _e1097) * _e1301);
                                                                                    let _e2357 = ((_e2309 - _e1110) * _e1311);
                                                                                    let _e2361 = ((_e2341 - _e1084) * _e1291);
                                                                                    let _e2362 = ((_e2346 - _e1097) * _e1301);
                                                                                    let _e2363 = ((_e2351 - _e1110) * _e1311);
                                                                                    if (_e2355 < _e2361) {
                                                                                        phi_2978_ = _e2355;
                                                                                    } else {
                                                                                        phi_2978_ = _e2361;
                                                                                    }
                                                                                    let _e2366 = phi_2978_;
                                                                                    if (_e2356 < _e2362) {
                                                                                        phi_2983_ = _e2356;
                                                                                    } else {
                                                                                        phi_2983_ = _e2362;
                                                                                    }
                                                                                    let _e2369 = phi_2983_;
                                                                                    if (_e2357 < _e2363) {
                                                                                        phi_2988_ = _e2357;
                                                                                    } else {
                                                                                        phi_2988_ = _e2363;
                                                                                    }
                                                                                    let _e2372 = phi_2988_;
                                                                                    if (_e2355 > _e2361) {
                                                                                        phi_2996_ = _e2355;
                                                                                    } else {
                                                                                        phi_2996_ = _e2361;
                                                                                    }
                                                                                    let _e2378 = phi_2996_;
                                                                                    if (_e2356 > _e2362) {
                                                                                        phi_3001_ = _e2356;
                                                                                    } else {
                                                                                        phi_3001_ = _e2362;
                                                                                    }
                                                                                    let _e2381 = phi_3001_;
                                                                                    if (_e2357 > _e2363) {
                                                                                        phi_3006_ = _e2357;
                                                                                    } else {
                                                                                        phi_3006_ = _e2363;
                                                                                    }
                                                                                    let _e2384 = phi_3006_;
                                                                                    let _e2388 = core_intrinsics_maximum_number_nsz_f32_((_e2366 - _e1350), (_e2369 - _e1351));
                                                                                    let _e2389 = core_intrinsics_maximum_number_nsz_f32_(_e2388, (_e2372 - _e1352));
                                                                                    let _e2390 = core_intrinsics_minimum_number_nsz_f32_((_e2378 + _e1350), (_e2381 + _e1351));
                                                                                    let _e2391 = core_intrinsics_minimum_number_nsz_f32_(_e2390, (_e2384 + _e1352));
                                                                                    if (_e2389 > _e1059) {
                                                                                        phi_3018_ = _e2389;
                                                                                    } else {
                                                                                        phi_3018_ = _e1059;
                                                                                    }
                                                                                    let _e2394 = phi_3018_;
                                                                                    if (_e2391 < _e1061) {
                                                                                        phi_3023_ = _e2391;
                                                                                    } else {
                                                                                        phi_3023_ = _e1061;
                                                                                    }
                                                                                    let _e2397 = phi_3023_;
                                                                                    if (_e2265 < _e2394) {
                                                                                        phi_3028_ = _e2394;
                                                                                    } else {
                                                                                        phi_3028_ = _e2265;
                                                                                    }
                                                                                    let _e2400 = phi_3028_;
                                                                                    if (_e2400 > _e2397) {
                                                                                        phi_3033_ = _e2397;
                                                                                    } else {
                                                                                        phi_3033_ = _e2400;
                                                                                    }
                                                                                    let _e2403 = phi_3033_;
                                                                                    phi_3038_ = lt_bvh_triangle_Intersection(_e2403, (_e2106 / _e2165), (_e2127 / _e2165), (_e2394 <= _e2397));
                                                                                    phi_3039_ = false;
                                                                                } else {
                                                                                    phi_3038_ = lt_bvh_triangle_Intersection();
                                                                                    phi_3039_ = true;
                                                                                }
                                                                                let _e2409 = phi_3038_;
                                                                                let _e2411 = phi_3039_;
                                                                                phi_3040_ = _e2409;
                                                                                phi_3041_ = _e2411;
                                                                            } else {
                                                                                phi_3040_ = lt_bvh_triangle_Intersection();
                                                                                phi_3041_ = true;
                                                                            }
                                                                            let _e2413 = phi_3040_;
                                                                            let _e2415 = phi_3041_;
                                                                            if _e2415 {
                                                                            }
                                                                            phi_3045_ = _e2413;
                                                                            phi_3046_ = _e2415;
                                                                        }
                                                                        let _e2417 = phi_3045_;
                                                                        let _e2419 = phi_3046_;
                                                                        phi_3047_ = _e2417;
                                                                        phi_3048_ = _e2168;
                                                                        phi_3049_ = _e2419;
                                                                    } else {
                                                                        phi_3047_ = lt_bvh_triangle_Intersection();
                                                                        phi_3048_ = true;
                                                                        phi_3049_ = false;
                                                                    }
                                                                    let _e2421 = phi_3047_;
                                                                    let _e2423 = phi_3048_;
                                                                    let _e2425 = phi_3049_;
                                                                    if _e2423 {
                                                                        phi_3053_ = true;
                                                                    } else {
                                                                        phi_3053_ = _e2425;
                                                                    }
                                                                    let _e2427 = phi_3053_;
                                                                    if _e2427 {
                                                                        phi_3057_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_3057_ = _e2421;
                                                                    }
                                                                    let _e2429 = phi_3057_;
                                                                    if _e2429.is_hit {
                                                                        if (_e2429.t > _e183.tmin) {
                                                                            if (_e2429.t < _e1970.t) {
                                                                                phi_3105_ = true;
                                                                            } else {
                                                                                if (_e2429.t == _e1970.t) {
                                                                                    if (_e1970.triangle != 4294967295u) {
                                                                                        if (_e1981 < _e1970.triangle) {
                                                                                            phi_3096_ = true;
                                                                                        } else {
                                                                                            if (_e1981 == _e1970.triangle) {
                                                                                                phi_3095_ = (_e1000 < _e1970.instance);
                                                                                            } else {
                                                                                                phi_3095_ = false;
                                                                                            }
                                                                                            let _e2447 = phi_3095_;
                                                                                            phi_3096_ = _e2447;
                                                                                        }
                                                                                        let _e2449 = phi_3096_;
                                                                                        phi_3097_ = _e2449;
                                                                                        phi_3098_ = false;
                                                                                    } else {
                                                                                        phi_3097_ = bool();
                                                                                        phi_3098_ = true;
                                                                                    }
                                                                                    let _e2451 = phi_3097_;
                                                                                    let _e2453 = phi_3098_;
                                                                                    phi_3099_ = _e2451;
                                                                                    phi_3100_ = _e2453;
                                                                                } else {
                                                                                    phi_3099_ = bool();
                                                                                    phi_3100_ = true;
                                                                                }
                                                                                let _e2455 = phi_3099_;
                                                                                let _e2457 = phi_3100_;
                                                                                if _e2457 {
                                                                                    phi_3104_ = false;
                                                                                } else {
                                                                                    phi_3104_ = _e2455;
                                                                                }
                                                                                let _e2459 = phi_3104_;
                                                                                phi_3105_ = _e2459;
                                                                            }
                                                                            let _e2461 = phi_3105_;
                                                                            if _e2461 {
                                                                                let _e2463 = triangles.member[(0u + _e1981)].i0_;
                                                                                if ((_e2463 & 2147483648u) == 0u) {
                                                                                    phi_3119_ = true;
                                                                                } else {
                                                                                    if true {
                                                                                    }
                                                                                    phi_3119_ = true;
                                                                                }
                                                                                let _e2467 = phi_3119_;
                                                                                if _e2467 {
                                                                                    phi_3127_ = lt_bvh_Hit(_e2429.t, _e2429.u, _e2429.v, _e1981, _e1000);
                                                                                } else {
                                                                                    phi_3127_ = _e1970;
                                                                                }
                                                                                let _e2473 = phi_3127_;
                                                                                phi_3128_ = _e2473;
                                                                            } else {
                                                                                phi_3128_ = _e1970;
                                                                            }
                                                                            let _e2475 = phi_3128_;
                                                                            phi_3129_ = _e2475;
                                                                        } else {
                                                                            phi_3129_ = _e1970;
                                                                        }
                                                                        let _e2477 = phi_3129_;
                                                                        phi_3130_ = _e2477;
                                                                    } else {
                                                                        phi_3130_ = _e1970;
                                                                    }
                                                                    let _e2479 = phi_3130_;
                                                                    phi_2487_ = _e2479;
                                                                    phi_2490_ = (_e1972 & (_e1972 - 1u));
                                                                    phi_3131_ = true;
                                                                }
                                                                let _e2481 = phi_2487_;
                                                                let _e2483 = phi_2490_;
                                                                let _e2485 = phi_3131_;
                                                                continue;
                                                                continuing {
                                                                    phi_2486_ = _e2481;
                                                                    phi_2489_ = _e2483;
                                                                    break if !(_e2485);
                                                                }
                                                            }
                                                            let _e2488 = local_1.group_mask;
                                                            if ((_e2488 & 4278190080u) == 0u) {
                                                                let _e2492 = local_1.len;
                                                                if (_e2492 == 0u) {
                                                                    phi_3170_ = false;
                                                                } else {
                                                                    let _e2496 = local_1.len;
                                                                    local_1.len = (_e2496 - 1u);
                                                                    let _e2499 = local_1.len;
                                                                    if (_e2499 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2504 = local_1.first[(0u + _e2499)];
                                                                    local_1.group = _e2504;
                                                                    let _e2507 = local_1.len;
                                                                    if (_e2507 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2512 = local_1.mask[(0u + _e2507)];
                                                                    local_1.group_mask = _e2512;
                                                                    phi_3170_ = true;
                                                                }
                                                                let _e2515 = phi_3170_;
                                                                phi_3171_ = _e2515;
                                                            } else {
                                                                phi_3171_ = true;
                                                            }
                                                            let _e2517 = phi_3171_;
                                                            if _e2517 {
                                                                let _e2519 = local_1.group_mask;
                                                                let _e2525 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2519)), 32u, (_e2519 == 0u)));
                                                                let _e2529 = local_1.group_mask;
                                                                let _e2543 = local_1.group_mask;
                                                                local_1.group_mask = (_e2543 & ~((1u << bitcast<u32>((_e2525 & 31u)))));
                                                                let _e2546 = local_1.group;
                                                                phi_3202_ = (_e2546 + countOneBits(((_e2529 & ~((4294967295u << bitcast<u32>((((_e2525 - 24u) ^ _e1393) & 31u))))) & 255u)));
                                                            } else {
                                                                phi_3202_ = 4294967295u;
                                                            }
                                                            let _e2549 = phi_3202_;
                                                            let _e3868 = local_9;
                                                            phi_2154_ = _e3868;
                                                            phi_2157_ = _e2549;
                                                        } else {
                                                            phi_2154_ = lt_bvh_Hit();
                                                            phi_2157_ = u32();
                                                        }
                                                        let _e2551 = phi_2154_;
                                                        let _e2553 = phi_2157_;
                                                        continue;
                                                        continuing {
                                                            phi_2153_ = _e2551;
                                                            phi_2156_ = _e2553;
                                                            break if !(_e1534);
                                                        }
                                                    }
                                                    let _e3872 = local_10;
                                                    phi_3203_ = _e3872;
                                                }
                                                let _e2556 = phi_3203_;
                                                phi_3204_ = _e2556;
                                                phi_3205_ = _e1215;
                                            } else {
                                                phi_3204_ = lt_bvh_Hit();
                                                phi_3205_ = true;
                                            }
                                            let _e2558 = phi_3204_;
                                            let _e2560 = phi_3205_;
                                            if _e2560 {
                                                phi_3209_ = _e992;
                                            } else {
                                                phi_3209_ = _e2558;
                                            }
                                            let _e2562 = phi_3209_;
                                            phi_3210_ = _e2562;
                                        } else {
                                            phi_3210_ = _e992;
                                        }
                                        let _e2564 = phi_3210_;
                                        phi_3211_ = _e2564;
                                    } else {
                                        phi_3211_ = _e992;
                                    }
                                    let _e2566 = phi_3211_;
                                    phi_3212_ = _e2566;
                                } else {
                                    phi_3212_ = _e992;
                                }
                                let _e2568 = phi_3212_;
                                phi_1521_ = (_e990 & (_e990 - 1u));
                                phi_1524_ = _e2568;
                                phi_3213_ = true;
                            }
                            let _e2570 = phi_1521_;
                            let _e2572 = phi_1524_;
                            let _e2574 = phi_3213_;
                            continue;
                            continuing {
                                phi_1520_ = _e2570;
                                phi_1523_ = _e2572;
                                break if !(_e2574);
                            }
                        }
                        let _e2577 = local_2.group_mask;
                        if ((_e2577 & 4278190080u) == 0u) {
                            let _e2581 = local_2.len;
                            if (_e2581 == 0u) {
                                phi_3252_ = false;
                            } else {
                                let _e2585 = local_2.len;
                                local_2.len = (_e2585 - 1u);
                                let _e2588 = local_2.len;
                                if (_e2588 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2593 = local_2.first[(0u + _e2588)];
                                local_2.group = _e2593;
                                let _e2596 = local_2.len;
                                if (_e2596 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2601 = local_2.mask[(0u + _e2596)];
                                local_2.group_mask = _e2601;
                                phi_3252_ = true;
                            }
                            let _e2604 = phi_3252_;
                            phi_3253_ = _e2604;
                        } else {
                            phi_3253_ = true;
                        }
                        let _e2606 = phi_3253_;
                        if _e2606 {
                            let _e2608 = local_2.group_mask;
                            let _e2614 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2608)), 32u, (_e2608 == 0u)));
                            let _e2618 = local_2.group_mask;
                            let _e2632 = local_2.group_mask;
                            local_2.group_mask = (_e2632 & ~((1u << bitcast<u32>((_e2614 & 31u)))));
                            let _e2635 = local_2.group;
                            phi_3284_ = (_e2635 + countOneBits(((_e2618 & ~((4294967295u << bitcast<u32>((((_e2614 - 24u) ^ _e409) & 31u))))) & 255u)));
                        } else {
                            phi_3284_ = 4294967295u;
                        }
                        let _e2638 = phi_3284_;
                        phi_1184_ = _e2638;
                        let _e3888 = local_11;
                        phi_1187_ = _e3888;
                    } else {
                        phi_1184_ = u32();
                        phi_1187_ = lt_bvh_Hit();
                    }
                    let _e2640 = phi_1184_;
                    let _e2642 = phi_1187_;
                    continue;
                    continuing {
                        phi_1183_ = _e2640;
                        phi_1186_ = _e2642;
                        break if !(_e550);
                    }
                }
                let _e3891 = local_12;
                phi_3285_ = _e3891;
            }
            let _e2645 = phi_3285_;
            phi_3286_ = _e2645;
            phi_3287_ = _e247;
        } else {
            phi_3286_ = lt_bvh_Hit();
            phi_3287_ = true;
        }
        let _e2647 = phi_3286_;
        let _e2649 = phi_3287_;
        if _e2649 {
            phi_3291_ = _e185;
        } else {
            phi_3291_ = _e2647;
        }
        let _e2651 = phi_3291_;
        if (_e2651.triangle != 4294967295u) {
            let _e2657 = ((1f - _e2651.u) - _e2651.v);
            if (_e2651.triangle < _e82) {
            } else {
                return;
            }
            let _e2662 = triangles.member[(0u + _e2651.triangle)];
            if (_e2651.instance < _e94) {
            } else {
                return;
            }
            let _e2673 = instances.member[(0u + _e2651.instance)].object_to_world[0u];
            let _e2684 = ((((_e2673.x * _e2662.v0_.x) + (_e2673.y * _e2662.v0_.y)) + (_e2673.z * _e2662.v0_.z)) + (_e2673.w * 1f));
            let _e2686 = instances.member[(0u + _e2651.instance)].object_to_world[1u];
            let _e2697 = ((((_e2686.x * _e2662.v0_.x) + (_e2686.y * _e2662.v0_.y)) + (_e2686.z * _e2662.v0_.z)) + (_e2686.w * 1f));
            let _e2699 = instances.member[(0u + _e2651.instance)].object_to_world[2u];
            let _e2710 = ((((_e2699.x * _e2662.v0_.x) + (_e2699.y * _e2662.v0_.y)) + (_e2699.z * _e2662.v0_.z)) + (_e2699.w * 1f));
            let _e2717 = instances.member[(0u + _e2651.instance)].object_to_world[0u];
            let _e2728 = ((((_e2717.x * _e2662.v1_.x) + (_e2717.y * _e2662.v1_.y)) + (_e2717.z * _e2662.v1_.z)) + (_e2717.w * 1f));
            let _e2730 = instances.member[(0u + _e2651.instance)].object_to_world[1u];
            let _e2741 = ((((_e2730.x * _e2662.v1_.x) + (_e2730.y * _e2662.v1_.y)) + (_e2730.z * _e2662.v1_.z)) + (_e2730.w * 1f));
            let _e2743 = instances.member[(0u + _e2651.instance)].object_to_world[2u];
            let _e2754 = ((((_e2743.x * _e2662.v1_.x) + (_e2743.y * _e2662.v1_.y)) + (_e2743.z * _e2662.v1_.z)) + (_e2743.w * 1f));
            let _e2761 = instances.member[(0u + _e2651.instance)].object_to_world[0u];
            let _e2772 = ((((_e2761.x * _e2662.v2_.x) + (_e2761.y * _e2662.v2_.y)) + (_e2761.z * _e2662.v2_.z)) + (_e2761.w * 1f));
            let _e2774 = instances.member[(0u + _e2651.instance)].object_to_world[1u];
            let _e2785 = ((((_e2774.x * _e2662.v2_.x) + (_e2774.y * _e2662.v2_.y)) + (_e2774.z * _e2662.v2_.z)) + (_e2774.w * 1f));
            let _e2787 = instances.member[(0u + _e2651.instance)].object_to_world[2u];
            let _e2798 = ((((_e2787.x * _e2662.v2_.x) + (_e2787.y * _e2662.v2_.y)) + (_e2787.z * _e2662.v2_.z)) + (_e2787.w * 1f));
            let _e2811 = (((_e2684 * _e2657) + (_e2728 * _e2651.u)) + (_e2772 * _e2651.v));
            let _e2812 = (((_e2697 * _e2657) + (_e2741 * _e2651.u)) + (_e2785 * _e2651.v));
            let _e2813 = (((_e2710 * _e2657) + (_e2754 * _e2651.u)) + (_e2798 * _e2651.v));
            let _e2815 = abs(_e2684);
            let _e2816 = abs(_e2697);
            let _e2817 = abs(_e2710);
            let _e2818 = abs(_e2728);
            let _e2819 = abs(_e2741);
            let _e2820 = abs(_e2754);
            if (_e2815 > _e2818) {
                phi_3478_ = _e2815;
            } else {
                phi_3478_ = _e2818;
            }
            let _e2823 = phi_3478_;
            if (_e2816 > _e2819) {
                phi_3483_ = _e2816;
            } else {
                phi_3483_ = _e2819;
            }
            let _e2826 = phi_3483_;
            if (_e2817 > _e2820) {
                phi_3488_ = _e2817;
            } else {
                phi_3488_ = _e2820;
            }
            let _e2829 = phi_3488_;
            let _e2830 = abs(_e2772);
            let _e2831 = abs(_e2785);
            let _e2832 = abs(_e2798);
            if (_e2823 > _e2830) {
                phi_3496_ = _e2823;
            } else {
                phi_3496_ = _e2830;
            }
            let _e2835 = phi_3496_;
            if (_e2826 > _e2831) {
                phi_3501_ = _e2826;
            } else {
                phi_3501_ = _e2831;
            }
            let _e2838 = phi_3501_;
            if (_e2829 > _e2832) {
                phi_3506_ = _e2829;
            } else {
                phi_3506_ = _e2832;
            }
            let _e2841 = phi_3506_;
            let _e2842 = (_e2728 - _e2684);
            let _e2843 = (_e2741 - _e2697);
            let _e2844 = (_e2754 - _e2710);
            let _e2845 = (_e2772 - _e2684);
            let _e2846 = (_e2785 - _e2697);
            let _e2847 = (_e2798 - _e2710);
            let _e2851 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2843), abs(_e2844));
            let _e2852 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2842), _e2851);
            let _e2853 = (_e2842 / _e2852);
            let _e2854 = (_e2843 / _e2852);
            let _e2855 = (_e2844 / _e2852);
            let _e2859 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2846), abs(_e2847));
            let _e2860 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2845), _e2859);
            let _e2861 = (_e2845 / _e2860);
            let _e2862 = (_e2846 / _e2860);
            let _e2863 = (_e2847 / _e2860);
            let _e2866 = ((_e2854 * _e2863) - (_e2862 * _e2855));
            let _e2869 = ((_e2855 * _e2861) - (_e2863 * _e2853));
            let _e2872 = ((_e2853 * _e2862) - (_e2861 * _e2854));
            let _e2874 = p.member.eye;
            let _e2887 = (1f / sqrt((((_e2866 * _e2866) + (_e2869 * _e2869)) + (_e2872 * _e2872))));
            let _e2888 = (_e2866 * _e2887);
            let _e2889 = (_e2869 * _e2887);
            let _e2890 = (_e2872 * _e2887);
            if ((((_e2888 * (_e2874.x - _e2811)) + (_e2889 * (_e2874.y - _e2812))) + (_e2890 * (_e2874.z - _e2813))) < 0f) {
                phi_3570_ = vec3<f32>(-(_e2888), -(_e2889), -(_e2890));
            } else {
                phi_3570_ = vec3<f32>(_e2888, _e2889, _e2890);
            }
            let _e2903 = phi_3570_;
            if (_e2651.triangle < _e82) {
            } else {
                return;
            }
            let _e2908 = triangles.member[(0u + _e2651.triangle)];
            let _e2910 = (_e2908.i0_ & 2147483647u);
            if (_e2910 < _e85) {
            } else {
                return;
            }
            let _e2916 = vertices.member[(0u + _e2910)];
            if (_e2908.i1_ < _e85) {
            } else {
                return;
            }
            let _e2920 = vertices.member[(0u + _e2908.i1_)];
            if (_e2908.i2_ < _e85) {
            } else {
                return;
            }
            let _e2924 = vertices.member[(0u + _e2908.i2_)];
            let _e2925 = array<abi_Vertex, 3>(_e2916, _e2920, _e2924);
            if (_e2925[0].material < arrayLength((&materials.member))) {
            } else {
                return;
            }
            let _e2931 = materials.member[(0u + _e2925[0].material)];
            let _e2948 = (1f / 255f);
            let _e2967 = (1f / 255f);
            let _e2989 = (1f / 255f);
            if (_e2931.color_size == 0u) {
                phi_3813_ = vec3<f32>(1f, 1f, 1f);
            } else {
                local.offset = _e2931.color_offset;
                local.size = _e2931.color_size;
                local.flags = _e2931.flags;
                let _e3032 = _lt_shaders_texture_TextureView_quad((&local), (((_e2925[0].u * _e2657) + (_e2925[1].u * _e2651.u)) + (_e2925[2].u * _e2651.v)), (((_e2925[0].v * _e2657) + (_e2925[1].v * _e2651.u)) + (_e2925[2].v * _e2651.v)));
                if (_e3032.indices[0] < _e97) {
                } else {
                    return;
                }
                let _e3038 = color_texels.member[(0u + _e3032.indices[0])];
                let _e3049 = (1f / 255f);
                if (_e3032.indices[1] < _e97) {
                } else {
                    return;
                }
                let _e3063 = color_texels.member[(0u + _e3032.indices[1])];
                let _e3074 = (1f / 255f);
                if (_e3032.indices[2] < _e97) {
                } else {
                    return;
                }
                let _e3091 = color_texels.member[(0u + _e3032.indices[2])];
                let _e3102 = (1f / 255f);
                if (_e3032.indices[3] < _e97) {
                } else {
                    return;
                }
                let _e3119 = color_texels.member[(0u + _e3032.indices[3])];
                let _e3130 = (1f / 255f);
                let _e3139 = (((((f32((_e3038 & 255u)) * _e3049) * _e3032.weights.x) + ((f32((_e3063 & 255u)) * _e3074) * _e3032.weights.y)) + ((f32((_e3091 & 255u)) * _e3102) * _e3032.weights.z)) + ((f32((_e3119 & 255u)) * _e3130) * _e3032.weights.w));
                let _e3140 = (((((f32(((_e3038 >> bitcast<u32>(8i)) & 255u)) * _e3049) * _e3032.weights.x) + ((f32(((_e3063 >> bitcast<u32>(8i)) & 255u)) * _e3074) * _e3032.weights.y)) + ((f32(((_e3091 >> bitcast<u32>(8i)) & 255u)) * _e3102) * _e3032.weights.z)) + ((f32(((_e3119 >> bitcast<u32>(8i)) & 255u)) * _e3130) * _e3032.weights.w));
                let _e3141 = (((((f32(((_e3038 >> bitcast<u32>(16i)) & 255u)) * _e3049) * _e3032.weights.x) + ((f32(((_e3063 >> bitcast<u32>(16i)) & 255u)) * _e3074) * _e3032.weights.y)) + ((f32(((_e3091 >> bitcast<u32>(16i)) & 255u)) * _e3102) * _e3032.weights.z)) + ((f32(((_e3119 >> bitcast<u32>(16i)) & 255u)) * _e3130) * _e3032.weights.w));
                phi_3813_ = vec3<f32>((_e3139 * _e3139), (_e3140 * _e3140), (_e3141 * _e3141));
            }
            let _e3147 = phi_3813_;
            let _e3149 = ((_e2931.base_color.x * ((((f32((_e2925[0].color & 255u)) * _e2948) * _e2657) + ((f32((_e2925[1].color & 255u)) * _e2967) * _e2651.u)) + ((f32((_e2925[2].color & 255u)) * _e2989) * _e2651.v))) * _e3147.x);
            let _e3151 = ((_e2931.base_color.y * ((((f32(((_e2925[0].color >> bitcast<u32>(8i)) & 255u)) * _e2948) * _e2657) + ((f32(((_e2925[1].color >> bitcast<u32>(8i)) & 255u)) * _e2967) * _e2651.u)) + ((f32(((_e2925[2].color >> bitcast<u32>(8i)) & 255u)) * _e2989) * _e2651.v))) * _e3147.y);
            let _e3153 = ((_e2931.base_color.z * ((((f32(((_e2925[0].color >> bitcast<u32>(16i)) & 255u)) * _e2948) * _e2657) + ((f32(((_e2925[1].color >> bitcast<u32>(16i)) & 255u)) * _e2967) * _e2651.u)) + ((f32(((_e2925[2].color >> bitcast<u32>(16i)) & 255u)) * _e2989) * _e2651.v))) * _e3147.z);
            let _e3154 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e2838, _e2841);
            let _e3155 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e2835, _e3154);
            if ((_e2931.flags & 2u) == 0u) {
                phi_3828_ = 0u;
            } else {
                phi_3828_ = 1u;
            }
            let _e3160 = phi_3828_;
            if (_e2925[0].normal == 2147516416u) {
                phi_4058_ = _e2903;
            } else {
                let _e3173 = (f32((bitcast<i32>((_e2925[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3179 = (f32((bitcast<i32>(_e2925[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3183 = ((1f - abs(_e3173)) - abs(_e3179));
                if (_e3183 < 0f) {
                    phi_3855_ = -(_e3183);
                } else {
                    phi_3855_ = 0f;
                }
                let _e3187 = phi_3855_;
                if (_e3173 < 0f) {
                    phi_3862_ = (_e3173 + _e3187);
                } else {
                    phi_3862_ = (_e3173 - _e3187);
                }
                let _e3192 = phi_3862_;
                if (_e3179 < 0f) {
                    phi_3869_ = (_e3179 + _e3187);
                } else {
                    phi_3869_ = (_e3179 - _e3187);
                }
                let _e3197 = phi_3869_;
                let _e3204 = (1f / sqrt((((_e3192 * _e3192) + (_e3197 * _e3197)) + (_e3183 * _e3183))));
                let _e3220 = (f32((bitcast<i32>((_e2925[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3226 = (f32((bitcast<i32>(_e2925[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3230 = ((1f - abs(_e3220)) - abs(_e3226));
                if (_e3230 < 0f) {
                    phi_3904_ = -(_e3230);
                } else {
                    phi_3904_ = 0f;
                }
                let _e3234 = phi_3904_;
                if (_e3220 < 0f) {
                    phi_3911_ = (_e3220 + _e3234);
                } else {
                    phi_3911_ = (_e3220 - _e3234);
                }
                let _e3239 = phi_3911_;
                if (_e3226 < 0f) {
                    phi_3918_ = (_e3226 + _e3234);
                } else {
                    phi_3918_ = (_e3226 - _e3234);
                }
                let _e3244 = phi_3918_;
                let _e3251 = (1f / sqrt((((_e3239 * _e3239) + (_e3244 * _e3244)) + (_e3230 * _e3230))));
                let _e3270 = (f32((bitcast<i32>((_e2925[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3276 = (f32((bitcast<i32>(_e2925[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3280 = ((1f - abs(_e3270)) - abs(_e3276));
                if (_e3280 < 0f) {
                    phi_3956_ = -(_e3280);
                } else {
                    phi_3956_ = 0f;
                }
                let _e3284 = phi_3956_;
                if (_e3270 < 0f) {
                    phi_3963_ = (_e3270 + _e3284);
                } else {
                    phi_3963_ = (_e3270 - _e3284);
                }
                let _e3289 = phi_3963_;
                if (_e3276 < 0f) {
                    phi_3970_ = (_e3276 + _e3284);
                } else {
                    phi_3970_ = (_e3276 - _e3284);
                }
                let _e3294 = phi_3970_;
                let _e3301 = (1f / sqrt((((_e3289 * _e3289) + (_e3294 * _e3294)) + (_e3280 * _e3280))));
                let _e3308 = ((((_e3192 * _e3204) * _e2657) + ((_e3239 * _e3251) * _e2651.u)) + ((_e3289 * _e3301) * _e2651.v));
                let _e3309 = ((((_e3197 * _e3204) * _e2657) + ((_e3244 * _e3251) * _e2651.u)) + ((_e3294 * _e3301) * _e2651.v));
                let _e3310 = ((((_e3183 * _e3204) * _e2657) + ((_e3230 * _e3251) * _e2651.u)) + ((_e3280 * _e3301) * _e2651.v));
                if (_e2651.instance < _e94) {
                } else {
                    return;
                }
                let _e3317 = instances.member[(0u + _e2651.instance)].world_to_object[0u];
                let _e3326 = instances.member[(0u + _e2651.instance)].world_to_object[1u];
                let _e3338 = instances.member[(0u + _e2651.instance)].world_to_object[2u];
                let _e3345 = (((_e3317.x * _e3308) + (_e3326.x * _e3309)) + (_e3338.x * _e3310));
                let _e3346 = (((_e3317.y * _e3308) + (_e3326.y * _e3309)) + (_e3338.y * _e3310));
                let _e3347 = (((_e3317.z * _e3308) + (_e3326.z * _e3309)) + (_e3338.z * _e3310));
                let _e3353 = sqrt((((_e3345 * _e3345) + (_e3346 * _e3346)) + (_e3347 * _e3347)));
                if (_e3353 > 0f) {
                    let _e3355 = (_e3345 / _e3353);
                    let _e3356 = (_e3346 / _e3353);
                    let _e3357 = (_e3347 / _e3353);
                    if ((((_e3355 * _e2903.x) + (_e3356 * _e2903.y)) + (_e3357 * _e2903.z)) < 0f) {
                        phi_4056_ = vec3<f32>(-(_e3355), -(_e3356), -(_e3357));
                    } else {
                        phi_4056_ = vec3<f32>(_e3355, _e3356, _e3357);
                    }
                    let _e3373 = phi_4056_;
                    phi_4057_ = _e3373;
                } else {
                    phi_4057_ = _e2903;
                }
                let _e3375 = phi_4057_;
                phi_4058_ = _e3375;
            }
            let _e3377 = phi_4058_;
            if (_e3149 > 0f) {
                if (_e3149 < 1f) {
                    phi_4067_ = _e3149;
                } else {
                    phi_4067_ = 1f;
                }
                let _e3381 = phi_4067_;
                phi_4068_ = _e3381;
            } else {
                phi_4068_ = 0f;
            }
            let _e3383 = phi_4068_;
            if (_e3151 > 0f) {
                if (_e3151 < 1f) {
                    phi_4078_ = _e3151;
                } else {
                    phi_4078_ = 1f;
                }
                let _e3388 = phi_4078_;
                phi_4079_ = _e3388;
            } else {
                phi_4079_ = 0f;
            }
            let _e3390 = phi_4079_;
            if (_e3153 > 0f) {
                if (_e3153 < 1f) {
                    phi_4089_ = _e3153;
                } else {
                    phi_4089_ = 1f;
                }
                let _e3395 = phi_4089_;
                phi_4090_ = _e3395;
            } else {
                phi_4090_ = 0f;
            }
            let _e3397 = phi_4090_;
            let _e3400 = ((sqrt(_e3383) * 255f) + 0.5f);
            let _e3409 = ((sqrt(_e3390) * 255f) + 0.5f);
            let _e3421 = ((sqrt(_e3397) * 255f) + 0.5f);
            phi_4125_ = abi_Sample(vec3<f32>(_e2811, _e2812, _e2813), _e3155, _e2903, _e3160, _e3377, ((select(select(u32(_e3400), 0u, (_e3400 < bitcast<f32>(0u))), 4294967295u, (_e3400 > bitcast<f32>(1333788671u))) | (select(select(u32(_e3409), 0u, (_e3409 < bitcast<f32>(0u))), 4294967295u, (_e3409 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e3421), 0u, (_e3421 < bitcast<f32>(0u))), 4294967295u, (_e3421 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_4125_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e3435 = phi_4125_;
        if (_e109.shift < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e109.shift)] = _e3435;
        if (_e2651.triangle != 4294967295u) {
            let _e3444 = ((1f - _e2651.u) - _e2651.v);
            if (_e2651.triangle < _e82) {
            } else {
                return;
            }
            let _e3449 = triangles.member[(0u + _e2651.triangle)];
            let _e3451 = (_e3449.i0_ & 2147483647u);
            if (_e3451 < _e100) {
            } else {
                return;
            }
            let _e3457 = before.member[(0u + _e3451)];
            if (_e3449.i1_ < _e100) {
            } else {
                return;
            }
            let _e3461 = before.member[(0u + _e3449.i1_)];
            if (_e3449.i2_ < _e100) {
            } else {
                return;
            }
            let _e3465 = before.member[(0u + _e3449.i2_)];
            if (_e2651.instance < _e94) {
            } else {
                return;
            }
            let _e3475 = instances.member[(0u + _e2651.instance)].object_to_world[0u];
            let _e3488 = instances.member[(0u + _e2651.instance)].object_to_world[1u];
            let _e3501 = instances.member[(0u + _e2651.instance)].object_to_world[2u];
            if (_e2651.instance < _e94) {
            } else {
                return;
            }
            let _e3525 = instances.member[(0u + _e2651.instance)].object_to_world[0u];
            let _e3538 = instances.member[(0u + _e2651.instance)].object_to_world[1u];
            let _e3551 = instances.member[(0u + _e2651.instance)].object_to_world[2u];
            if (_e2651.instance < _e94) {
            } else {
                return;
            }
            let _e3578 = instances.member[(0u + _e2651.instance)].object_to_world[0u];
            let _e3591 = instances.member[(0u + _e2651.instance)].object_to_world[1u];
            let _e3604 = instances.member[(0u + _e2651.instance)].object_to_world[2u];
            phi_4348_ = vec3<f32>((((((((_e3475.x * _e3457.x) + (_e3475.y * _e3457.y)) + (_e3475.z * _e3457.z)) + (_e3475.w * 1f)) * _e3444) + (((((_e3525.x * _e3461.x) + (_e3525.y * _e3461.y)) + (_e3525.z * _e3461.z)) + (_e3525.w * 1f)) * _e2651.u)) + (((((_e3578.x * _e3465.x) + (_e3578.y * _e3465.y)) + (_e3578.z * _e3465.z)) + (_e3578.w * 1f)) * _e2651.v)), (((((((_e3488.x * _e3457.x) + (_e3488.y * _e3457.y)) + (_e3488.z * _e3457.z)) + (_e3488.w * 1f)) * _e3444) + (((((_e3538.x * _e3461.x) + (_e3538.y * _e3461.y)) + (_e3538.z * _e3461.z)) + (_e3538.w * 1f)) * _e2651.u)) + (((((_e3591.x * _e3465.x) + (_e3591.y * _e3465.y)) + (_e3591.z * _e3465.z)) + (_e3591.w * 1f)) * _e2651.v)), (((((((_e3501.x * _e3457.x) + (_e3501.y * _e3457.y)) + (_e3501.z * _e3457.z)) + (_e3501.w * 1f)) * _e3444) + (((((_e3551.x * _e3461.x) + (_e3551.y * _e3461.y)) + (_e3551.z * _e3461.z)) + (_e3551.w * 1f)) * _e2651.u)) + (((((_e3604.x * _e3465.x) + (_e3604.y * _e3465.y)) + (_e3604.z * _e3465.z)) + (_e3604.w * 1f)) * _e2651.v)));
        } else {
            phi_4348_ = vec3<f32>(0f, 0f, 0f);
        }
        let _e3624 = phi_4348_;
        if (_e109.shift < arrayLength((&past.member))) {
        } else {
            return;
        }
        past.member[(0u + _e109.shift)] = vec4<f32>(_e3624.x, _e3624.y, _e3624.z, 1f);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_instanced_color_motion_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
