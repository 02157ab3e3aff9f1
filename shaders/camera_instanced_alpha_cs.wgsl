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
    var phi_223_: lt_mask_LightPlace;
    var phi_224_: bool;
    var phi_225_: lt_mask_LightPlace;
    var phi_226_: bool;
    var phi_231_: lt_mask_LightPlace;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_223_ = lt_mask_LightPlace(1u, ((param.y * param_1) + param.x));
            phi_224_ = false;
        } else {
            phi_223_ = lt_mask_LightPlace();
            phi_224_ = true;
        }
        let _e82 = phi_223_;
        let _e84 = phi_224_;
        phi_225_ = _e82;
        phi_226_ = _e84;
    } else {
        phi_225_ = lt_mask_LightPlace();
        phi_226_ = true;
    }
    let _e86 = phi_225_;
    let _e88 = phi_226_;
    if _e88 {
        phi_231_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_231_ = _e86;
    }
    let _e93 = phi_231_;
    return lt_mask_LightPlace(_e93.word, _e93.shift);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_246_: bool;
    var phi_250_: f32;

    if (param_3 != param_3) {
        phi_246_ = true;
    } else {
        let _e72 = (param_4 >= param_3);
        if _e72 {
        }
        phi_246_ = _e72;
    }
    let _e74 = phi_246_;
    if _e74 {
        phi_250_ = param_4;
    } else {
        phi_250_ = param_3;
    }
    let _e76 = phi_250_;
    return _e76;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_262_: bool;
    var phi_266_: f32;

    if (param_5 != param_5) {
        phi_262_ = true;
    } else {
        let _e72 = (param_6 <= param_5);
        if _e72 {
        }
        phi_262_ = _e72;
    }
    let _e74 = phi_262_;
    if _e74 {
        phi_266_ = param_6;
    } else {
        phi_266_ = param_5;
    }
    let _e76 = phi_266_;
    return _e76;
}

fn _lt_shaders_texture_TextureView_quad(param_7: ptr<function, texture_TextureView>, param_8: f32, param_9: f32) -> texture_TexelQuad {
    var phi_308_: f32;
    var phi_313_: f32;
    var phi_314_: bool;
    var phi_315_: f32;
    var phi_316_: bool;
    var phi_320_: f32;
    var phi_346_: f32;
    var phi_351_: f32;
    var phi_352_: bool;
    var phi_353_: f32;
    var phi_354_: bool;
    var phi_358_: f32;
    var phi_366_: f32;
    var phi_367_: f32;
    var phi_368_: f32;
    var phi_377_: f32;
    var phi_378_: f32;
    var phi_396_: u32;
    var phi_410_: u32;
    var phi_417_: u32;
    var phi_422_: u32;
    var phi_428_: u32;
    var phi_433_: u32;
    var phi_435_: texture_Axis;
    var phi_463_: f32;
    var phi_468_: f32;
    var phi_469_: bool;
    var phi_470_: f32;
    var phi_471_: bool;
    var phi_475_: f32;
    var phi_501_: f32;
    var phi_506_: f32;
    var phi_507_: bool;
    var phi_508_: f32;
    var phi_509_: bool;
    var phi_513_: f32;
    var phi_521_: f32;
    var phi_522_: f32;
    var phi_523_: f32;
    var phi_532_: f32;
    var phi_533_: f32;
    var phi_551_: u32;
    var phi_565_: u32;
    var phi_572_: u32;
    var phi_577_: u32;
    var phi_583_: u32;
    var phi_588_: u32;
    var phi_590_: texture_Axis;

    let _e73 = (*param_7).size;
    let _e74 = (_e73 & 65535u);
    let _e76 = (*param_7).size;
    let _e78 = (_e76 >> bitcast<u32>(16i));
    let _e80 = (*param_7).flags;
    let _e82 = ((_e80 & 4u) != 0u);
    let _e84 = (*param_7).flags;
    let _e87 = ((_e84 >> bitcast<u32>(4u)) & 3u);
    if (_e87 == 0u) {
        if (param_8 > -8388608f) {
            let _e100 = f32(select(0i, select(select(i32(param_8), i32(-2147483648), (param_8 < bitcast<f32>(3472883712u))), 2147483647i, (param_8 > bitcast<f32>(1325400063u))), (param_8 == param_8)));
            if (_e100 > param_8) {
                phi_308_ = 1f;
            } else {
                phi_308_ = 0f;
            }
            let _e103 = phi_308_;
            if (param_8 < 8388608f) {
                phi_313_ = (_e100 - _e103);
                phi_314_ = false;
            } else {
                phi_313_ = f32();
                phi_314_ = true;
            }
            let _e106 = phi_313_;
            let _e108 = phi_314_;
            phi_315_ = _e106;
            phi_316_ = _e108;
        } else {
            phi_315_ = f32();
            phi_316_ = true;
        }
        let _e110 = phi_315_;
        let _e112 = phi_316_;
        if _e112 {
            phi_320_ = param_8;
        } else {
            phi_320_ = _e110;
        }
        let _e114 = phi_320_;
        phi_368_ = (param_8 - _e114);
    } else {
        if (_e87 == 1u) {
            let _e117 = (param_8 * 0.5f);
            if (_e117 > -8388608f) {
                let _e129 = f32(select(0i, select(select(i32(_e117), i32(-2147483648), (_e117 < bitcast<f32>(3472883712u))), 2147483647i, (_e117 > bitcast<f32>(1325400063u))), (_e117 == _e117)));
                if (_e129 > _e117) {
                    phi_346_ = 1f;
                } else {
                    phi_346_ = 0f;
                }
                let _e132 = phi_346_;
                if (_e117 < 8388608f) {
                    phi_351_ = (_e129 - _e132);
                    phi_352_ = false;
                } else {
                    phi_351_ = f32();
                    phi_352_ = true;
                }
                let _e135 = phi_351_;
                let _e137 = phi_352_;
                phi_353_ = _e135;
                phi_354_ = _e137;
            } else {
                phi_353_ = f32();
                phi_354_ = true;
            }
            let _e139 = phi_353_;
            let _e141 = phi_354_;
            if _e141 {
                phi_358_ = _e117;
            } else {
                phi_358_ = _e139;
            }
            let _e143 = phi_358_;
            let _e145 = (param_8 - (2f * _e143));
            if (_e145 > 1f) {
                phi_366_ = (2f - _e145);
            } else {
                phi_366_ = _e145;
            }
            let _e149 = phi_366_;
            phi_367_ = _e149;
        } else {
            phi_367_ = param_8;
        }
        let _e151 = phi_367_;
        phi_368_ = _e151;
    }
    let _e153 = phi_368_;
    if (_e153 > 0f) {
        if (_e153 < 1f) {
            phi_377_ = _e153;
        } else {
            phi_377_ = 1f;
        }
        let _e157 = phi_377_;
        phi_378_ = _e157;
    } else {
        phi_378_ = 0f;
    }
    let _e159 = phi_378_;
    let _e160 = (_e74 - 1u);
    let _e162 = (_e159 * f32(_e74));
    if _e82 {
        let _e169 = select(select(u32(_e162), 0u, (_e162 < bitcast<f32>(0u))), 4294967295u, (_e162 > bitcast<f32>(1333788671u)));
        if (_e160 < _e169) {
            phi_396_ = _e160;
        } else {
            phi_396_ = _e169;
        }
        let _e172 = phi_396_;
        phi_435_ = texture_Axis(_e172, _e172, 0f);
    } else {
        let _e174 = (_e162 + 0.5f);
        let _e181 = select(select(u32(_e174), 0u, (_e174 < bitcast<f32>(0u))), 4294967295u, (_e174 > bitcast<f32>(1333788671u)));
        if (_e74 < _e181) {
            phi_410_ = _e74;
        } else {
            phi_410_ = _e181;
        }
        let _e184 = phi_410_;
        if (_e87 == 0u) {
            phi_417_ = _e160;
        } else {
            phi_417_ = 0u;
        }
        let _e189 = phi_417_;
        if (_e87 == 0u) {
            phi_422_ = 0u;
        } else {
            phi_422_ = _e160;
        }
        let _e192 = phi_422_;
        if (_e184 == 0u) {
            phi_428_ = _e189;
        } else {
            phi_428_ = (_e184 - 1u);
        }
        let _e196 = phi_428_;
        if (_e184 > _e160) {
            phi_433_ = _e192;
        } else {
            phi_433_ = _e184;
        }
        let _e199 = phi_433_;
        phi_435_ = texture_Axis(_e196, _e199, (_e174 - f32(_e184)));
    }
    let _e202 = phi_435_;
    let _e204 = (*param_7).flags;
    let _e207 = ((_e204 >> bitcast<u32>(6u)) & 3u);
    if (_e207 == 0u) {
        if (param_9 > -8388608f) {
            let _e220 = f32(select(0i, select(select(i32(param_9), i32(-2147483648), (param_9 < bitcast<f32>(3472883712u))), 2147483647i, (param_9 > bitcast<f32>(1325400063u))), (param_9 == param_9)));
            if (_e220 > param_9) {
                phi_463_ = 1f;
            } else {
                phi_463_ = 0f;
            }
            let _e223 = phi_463_;
            if (param_9 < 8388608f) {
                phi_468_ = (_e220 - _e223);
                phi_469_ = false;
            } else {
                phi_468_ = f32();
                phi_469_ = true;
            }
            let _e226 = phi_468_;
            let _e228 = phi_469_;
            phi_470_ = _e226;
            phi_471_ = _e228;
        } else {
            phi_470_ = f32();
            phi_471_ = true;
        }
        let _e230 = phi_470_;
        let _e232 = phi_471_;
        if _e232 {
            phi_475_ = param_9;
        } else {
            phi_475_ = _e230;
        }
        let _e234 = phi_475_;
        phi_523_ = (param_9 - _e234);
    } else {
        if (_e207 == 1u) {
            let _e237 = (param_9 * 0.5f);
            if (_e237 > -8388608f) {
                let _e249 = f32(select(0i, select(select(i32(_e237), i32(-2147483648), (_e237 < bitcast<f32>(3472883712u))), 2147483647i, (_e237 > bitcast<f32>(1325400063u))), (_e237 == _e237)));
                if (_e249 > _e237) {
                    phi_501_ = 1f;
                } else {
                    phi_501_ = 0f;
                }
                let _e252 = phi_501_;
                if (_e237 < 8388608f) {
                    phi_506_ = (_e249 - _e252);
                    phi_507_ = false;
                } else {
                    phi_506_ = f32();
                    phi_507_ = true;
                }
                let _e255 = phi_506_;
                let _e257 = phi_507_;
                phi_508_ = _e255;
                phi_509_ = _e257;
            } else {
                phi_508_ = f32();
                phi_509_ = true;
            }
            let _e259 = phi_508_;
            let _e261 = phi_509_;
            if _e261 {
                phi_513_ = _e237;
            } else {
                phi_513_ = _e259;
            }
            let _e263 = phi_513_;
            let _e265 = (param_9 - (2f * _e263));
            if (_e265 > 1f) {
                phi_521_ = (2f - _e265);
            } else {
                phi_521_ = _e265;
            }
            let _e269 = phi_521_;
            phi_522_ = _e269;
        } else {
            phi_522_ = param_9;
        }
        let _e271 = phi_522_;
        phi_523_ = _e271;
    }
    let _e273 = phi_523_;
    if (_e273 > 0f) {
        if (_e273 < 1f) {
            phi_532_ = _e273;
        } else {
            phi_532_ = 1f;
        }
        let _e277 = phi_532_;
        phi_533_ = _e277;
    } else {
        phi_533_ = 0f;
    }
    let _e279 = phi_533_;
    let _e280 = (_e78 - 1u);
    let _e282 = (_e279 * f32(_e78));
    if _e82 {
        let _e289 = select(select(u32(_e282), 0u, (_e282 < bitcast<f32>(0u))), 4294967295u, (_e282 > bitcast<f32>(1333788671u)));
        if (_e280 < _e289) {
            phi_551_ = _e280;
        } else {
            phi_551_ = _e289;
        }
        let _e292 = phi_551_;
        phi_590_ = texture_Axis(_e292, _e292, 0f);
    } else {
        let _e294 = (_e282 + 0.5f);
        let _e301 = select(select(u32(_e294), 0u, (_e294 < bitcast<f32>(0u))), 4294967295u, (_e294 > bitcast<f32>(1333788671u)));
        if (_e78 < _e301) {
            phi_565_ = _e78;
        } else {
            phi_565_ = _e301;
        }
        let _e304 = phi_565_;
        if (_e207 == 0u) {
            phi_572_ = _e280;
        } else {
            phi_572_ = 0u;
        }
        let _e309 = phi_572_;
        if (_e207 == 0u) {
            phi_577_ = 0u;
        } else {
            phi_577_ = _e280;
        }
        let _e312 = phi_577_;
        if (_e304 == 0u) {
            phi_583_ = _e309;
        } else {
            phi_583_ = (_e304 - 1u);
        }
        let _e316 = phi_583_;
        if (_e304 > _e280) {
            phi_588_ = _e312;
        } else {
            phi_588_ = _e304;
        }
        let _e319 = phi_588_;
        phi_590_ = texture_Axis(_e316, _e319, (_e294 - f32(_e304)));
    }
    let _e322 = phi_590_;
    let _e326 = (*param_7).offset;
    let _e333 = (*param_7).offset;
    let _e340 = (*param_7).offset;
    let _e347 = (*param_7).offset;
    return texture_TexelQuad(array<u32, 4>(((_e326 + (_e322.low * _e74)) + _e202.low), ((_e333 + (_e322.low * _e74)) + _e202.high), ((_e340 + (_e322.high * _e74)) + _e202.low), ((_e347 + (_e322.high * _e74)) + _e202.high)), vec4<f32>(((1f - _e202.fraction) * (1f - _e322.fraction)), (_e202.fraction * (1f - _e322.fraction)), ((1f - _e202.fraction) * _e322.fraction), (_e202.fraction * _e322.fraction)));
}

fn _lt_bvh_ray_Ray_new(param_10: vec3<f32>, param_11: vec3<f32>) -> lt_bvh_Ray {
    return lt_bvh_Ray(param_10, 0f, param_11, 300000000000000000000000000000000000000f);
}

fn _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(param_12: f32, param_13: f32) -> f32 {
    var phi_649_: f32;

    if (param_12 > param_13) {
        phi_649_ = param_12;
    } else {
        phi_649_ = param_13;
    }
    let _e73 = phi_649_;
    return _e73;
}

fn _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(param_14: vec3<f32>) -> vec3<f32> {
    return vec3<f32>(1f, 1f, 1f);
}

fn function_() {
    var local: texture_TextureView;
    var local_1: lt_bvh_traverse_Stack;
    var local_2: lt_bvh_traverse_Stack;
    var phi_785_: bool;
    var phi_786_: bool;
    var phi_787_: bool;
    var phi_788_: bool;
    var phi_792_: bool;
    var phi_805_: bool;
    var phi_806_: bool;
    var phi_807_: bool;
    var phi_808_: bool;
    var phi_812_: bool;
    var phi_825_: bool;
    var phi_826_: bool;
    var phi_827_: bool;
    var phi_831_: bool;
    var phi_832_: bool;
    var phi_833_: bool;
    var phi_834_: bool;
    var phi_835_: bool;
    var phi_839_: bool;
    var phi_915_: f32;
    var phi_922_: f32;
    var phi_930_: f32;
    var phi_937_: f32;
    var phi_945_: f32;
    var phi_952_: f32;
    var phi_975_: f32;
    var phi_980_: f32;
    var phi_985_: f32;
    var phi_990_: f32;
    var phi_995_: f32;
    var phi_1014_: u32;
    var phi_1019_: u32;
    var phi_1024_: u32;
    var phi_1138_: bool;
    var phi_1139_: bool;
    var phi_1170_: u32;
    var phi_1172_: u32;
    var phi_1175_: lt_bvh_Hit;
    var phi_1260_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1287_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1314_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1320_: u32;
    var phi_1323_: u32;
    var phi_1337_: u32;
    var phi_1347_: u32;
    var phi_1357_: u32;
    var phi_1375_: u32;
    var phi_1385_: u32;
    var phi_1395_: u32;
    var phi_1431_: u32;
    var phi_1444_: u32;
    var phi_1449_: u32;
    var phi_1450_: u32;
    var phi_1451_: u32;
    var phi_1321_: u32;
    var phi_1324_: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_1509_: u32;
    var phi_1512_: lt_bvh_Hit;
    var phi_1567_: f32;
    var phi_1572_: f32;
    var phi_1577_: f32;
    var phi_1585_: f32;
    var phi_1590_: f32;
    var phi_1595_: f32;
    var phi_1727_: bool;
    var phi_1728_: bool;
    var phi_1729_: bool;
    var phi_1730_: bool;
    var phi_1734_: bool;
    var phi_1747_: bool;
    var phi_1748_: bool;
    var phi_1749_: bool;
    var phi_1750_: bool;
    var phi_1754_: bool;
    var phi_1767_: bool;
    var phi_1768_: bool;
    var phi_1769_: bool;
    var phi_1773_: bool;
    var phi_1774_: bool;
    var phi_1775_: bool;
    var phi_1776_: bool;
    var phi_1777_: bool;
    var phi_1781_: bool;
    var phi_1851_: f32;
    var phi_1858_: f32;
    var phi_1865_: f32;
    var phi_1872_: f32;
    var phi_1879_: f32;
    var phi_1886_: f32;
    var phi_1903_: f32;
    var phi_1908_: f32;
    var phi_1913_: f32;
    var phi_1918_: f32;
    var phi_1923_: f32;
    var phi_1949_: bool;
    var phi_1950_: bool;
    var phi_1958_: u32;
    var phi_1959_: u32;
    var phi_1970_: vec3<f32>;
    var phi_1971_: vec3<f32>;
    var phi_1984_: u32;
    var phi_1989_: u32;
    var phi_1994_: u32;
    var phi_2108_: bool;
    var phi_2109_: bool;
    var phi_2140_: u32;
    var phi_2142_: lt_bvh_Hit;
    var phi_2145_: u32;
    var phi_2226_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2253_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2280_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2286_: u32;
    var phi_2289_: u32;
    var phi_2303_: u32;
    var phi_2313_: u32;
    var phi_2323_: u32;
    var phi_2341_: u32;
    var phi_2351_: u32;
    var phi_2361_: u32;
    var phi_2397_: u32;
    var phi_2410_: u32;
    var phi_2415_: u32;
    var phi_2416_: u32;
    var phi_2417_: u32;
    var phi_2287_: u32;
    var phi_2290_: u32;
    var local_6: u32;
    var local_7: u32;
    var local_8: u32;
    var phi_2475_: lt_bvh_Hit;
    var phi_2478_: u32;
    var phi_2522_: vec3<f32>;
    var phi_2523_: vec3<f32>;
    var phi_2552_: vec3<f32>;
    var phi_2553_: vec3<f32>;
    var phi_2582_: vec3<f32>;
    var phi_2583_: vec3<f32>;
    var phi_2601_: bool;
    var phi_2602_: bool;
    var phi_2606_: f32;
    var phi_2607_: f32;
    var phi_2608_: f32;
    var phi_2609_: f32;
    var phi_2617_: f32;
    var phi_2627_: bool;
    var phi_2628_: bool;
    var phi_2632_: f32;
    var phi_2633_: f32;
    var phi_2634_: f32;
    var phi_2635_: f32;
    var phi_2643_: f32;
    var phi_2653_: bool;
    var phi_2654_: bool;
    var phi_2658_: f32;
    var phi_2659_: f32;
    var phi_2660_: f32;
    var phi_2661_: f32;
    var phi_2669_: f32;
    var phi_2684_: f32;
    var phi_2685_: bool;
    var phi_2686_: f32;
    var phi_2687_: bool;
    var phi_2688_: f32;
    var phi_2689_: bool;
    var phi_2707_: f32;
    var phi_2708_: bool;
    var phi_2709_: bool;
    var phi_2710_: f32;
    var phi_2711_: bool;
    var phi_2712_: bool;
    var phi_2716_: bool;
    var phi_2717_: f32;
    var phi_2718_: bool;
    var phi_2746_: vec3<f32>;
    var phi_2747_: vec3<f32>;
    var phi_2772_: vec3<f32>;
    var phi_2773_: vec3<f32>;
    var phi_2798_: vec3<f32>;
    var phi_2799_: vec3<f32>;
    var phi_2855_: f32;
    var phi_2864_: f32;
    var phi_2873_: f32;
    var phi_2882_: f32;
    var phi_2889_: f32;
    var phi_2896_: f32;
    var phi_2909_: f32;
    var phi_2918_: f32;
    var phi_2927_: f32;
    var phi_2936_: f32;
    var phi_2943_: f32;
    var phi_2950_: f32;
    var phi_2967_: f32;
    var phi_2972_: f32;
    var phi_2977_: f32;
    var phi_2985_: f32;
    var phi_2990_: f32;
    var phi_2995_: f32;
    var phi_3007_: f32;
    var phi_3012_: f32;
    var phi_3017_: f32;
    var phi_3022_: f32;
    var phi_3027_: lt_bvh_triangle_Intersection;
    var phi_3028_: bool;
    var phi_3029_: lt_bvh_triangle_Intersection;
    var phi_3030_: bool;
    var phi_3034_: lt_bvh_triangle_Intersection;
    var phi_3035_: bool;
    var phi_3036_: lt_bvh_triangle_Intersection;
    var phi_3037_: bool;
    var phi_3038_: bool;
    var phi_3042_: bool;
    var phi_3046_: lt_bvh_triangle_Intersection;
    var phi_3084_: bool;
    var phi_3085_: bool;
    var phi_3086_: bool;
    var phi_3087_: bool;
    var phi_3088_: bool;
    var phi_3089_: bool;
    var phi_3093_: bool;
    var phi_3094_: bool;
    var phi_3297_: f32;
    var phi_3300_: bool;
    var phi_3301_: bool;
    var phi_3305_: bool;
    var phi_3313_: lt_bvh_Hit;
    var phi_3314_: lt_bvh_Hit;
    var phi_3315_: lt_bvh_Hit;
    var phi_3316_: lt_bvh_Hit;
    var phi_2476_: lt_bvh_Hit;
    var phi_2479_: u32;
    var phi_3317_: bool;
    var phi_3356_: bool;
    var phi_3357_: bool;
    var phi_3388_: u32;
    var phi_2143_: lt_bvh_Hit;
    var phi_2146_: u32;
    var phi_3389_: lt_bvh_Hit;
    var phi_3390_: lt_bvh_Hit;
    var phi_3391_: bool;
    var phi_3395_: lt_bvh_Hit;
    var phi_3396_: lt_bvh_Hit;
    var phi_3397_: lt_bvh_Hit;
    var phi_3398_: lt_bvh_Hit;
    var phi_1510_: u32;
    var phi_1513_: lt_bvh_Hit;
    var phi_3399_: bool;
    var phi_3438_: bool;
    var phi_3439_: bool;
    var phi_3470_: u32;
    var phi_1173_: u32;
    var phi_1176_: lt_bvh_Hit;
    var phi_3471_: lt_bvh_Hit;
    var phi_3472_: lt_bvh_Hit;
    var phi_3473_: bool;
    var phi_3477_: lt_bvh_Hit;
    var phi_3665_: f32;
    var phi_3670_: f32;
    var phi_3675_: f32;
    var phi_3683_: f32;
    var phi_3688_: f32;
    var phi_3693_: f32;
    var phi_3757_: vec3<f32>;
    var phi_3878_: u32;
    var phi_3905_: f32;
    var phi_3912_: f32;
    var phi_3919_: f32;
    var phi_3954_: f32;
    var phi_3961_: f32;
    var phi_3968_: f32;
    var phi_4006_: f32;
    var phi_4013_: f32;
    var phi_4020_: f32;
    var phi_4106_: vec3<f32>;
    var phi_4107_: vec3<f32>;
    var phi_4108_: vec3<f32>;
    var phi_4117_: f32;
    var phi_4118_: f32;
    var phi_4128_: f32;
    var phi_4129_: f32;
    var phi_4139_: f32;
    var phi_4140_: f32;
    var phi_4175_: abi_Sample;
    var local_9: lt_bvh_Hit;
    var local_10: lt_bvh_Hit;
    var local_11: lt_bvh_Hit;
    var local_12: lt_bvh_Hit;

    let _e72 = id_1;
    let _e76 = arrayLength((&nodes.member));
    let _e79 = arrayLength((&triangles.member));
    let _e82 = arrayLength((&vertices.member));
    let _e85 = arrayLength((&materials.member));
    let _e91 = arrayLength((&instances.member));
    let _e94 = arrayLength((&alpha_texels.member));
    let _e97 = p.member.size[0u];
    let _e99 = p.member.size[1u];
    let _e100 = lt_shaders_entry_pixel_index(_e72, _e97, _e99);
    if (bitcast<i32>(_e100.word) != 0i) {
        let _e106 = p.member.root;
        let _e110 = p.member.eye;
        let _e115 = p.member.size[0u];
        let _e119 = ((((f32(_e72.x) + 0.5f) / f32(_e115)) * 2f) - 1f);
        let _e124 = p.member.size[1u];
        let _e128 = (1f - (((f32(_e72.y) + 0.5f) / f32(_e124)) * 2f));
        let _e130 = p.member.forward;
        let _e132 = p.member.right;
        let _e146 = p.member.up;
        let _e157 = _lt_bvh_ray_Ray_new(_e110, vec3<f32>(((_e130.x + (_e132.x * _e119)) + (_e146.x * _e128)), ((_e130.y + (_e132.y * _e119)) + (_e146.y * _e128)), ((_e130.z + (_e132.z * _e119)) + (_e146.z * _e128))));
        let _e159 = lt_bvh_Hit(_e157.tmax, 0f, 0f, 4294967295u, 4294967295u);
        let _e162 = abs(_e157.direction.x);
        let _e164 = abs(_e157.direction.y);
        let _e166 = abs(_e157.direction.z);
        if (abs(_e157.origin.x) < 1000000000000000f) {
            if (abs(_e157.origin.y) < 1000000000000000f) {
                phi_785_ = (abs(_e157.origin.z) < 1000000000000000f);
                phi_786_ = false;
            } else {
                phi_785_ = bool();
                phi_786_ = true;
            }
            let _e178 = phi_785_;
            let _e180 = phi_786_;
            phi_787_ = _e178;
            phi_788_ = _e180;
        } else {
            phi_787_ = bool();
            phi_788_ = true;
        }
        let _e182 = phi_787_;
        let _e184 = phi_788_;
        if _e184 {
            phi_792_ = false;
        } else {
            phi_792_ = _e182;
        }
        let _e186 = phi_792_;
        if _e186 {
            if (_e162 < 1000000000000000f) {
                if (_e164 < 1000000000000000f) {
                    phi_805_ = (_e166 < 1000000000000000f);
                    phi_806_ = false;
                } else {
                    phi_805_ = bool();
                    phi_806_ = true;
                }
                let _e191 = phi_805_;
                let _e193 = phi_806_;
                phi_807_ = _e191;
                phi_808_ = _e193;
            } else {
                phi_807_ = bool();
                phi_808_ = true;
            }
            let _e195 = phi_807_;
            let _e197 = phi_808_;
            if _e197 {
                phi_812_ = false;
            } else {
                phi_812_ = _e195;
            }
            let _e199 = phi_812_;
            if _e199 {
                if (_e162 > 0f) {
                    phi_826_ = bool();
                    phi_827_ = true;
                } else {
                    let _e201 = (_e164 > 0f);
                    if _e201 {
                        phi_825_ = bool();
                    } else {
                        phi_825_ = (_e166 > 0f);
                    }
                    let _e204 = phi_825_;
                    phi_826_ = _e204;
                    phi_827_ = _e201;
                }
                let _e206 = phi_826_;
                let _e208 = phi_827_;
                if _e208 {
                    phi_831_ = true;
                } else {
                    phi_831_ = _e206;
                }
                let _e210 = phi_831_;
                phi_832_ = _e210;
                phi_833_ = false;
            } else {
                phi_832_ = bool();
                phi_833_ = true;
            }
            let _e212 = phi_832_;
            let _e214 = phi_833_;
            phi_834_ = _e212;
            phi_835_ = _e214;
        } else {
            phi_834_ = bool();
            phi_835_ = true;
        }
        let _e216 = phi_834_;
        let _e218 = phi_835_;
        if _e218 {
            phi_839_ = false;
        } else {
            phi_839_ = _e216;
        }
        let _e220 = phi_839_;
        if _e220 {
            let _e221 = (_e106 >= _e76);
            if _e221 {
                phi_3471_ = lt_bvh_Hit();
            } else {
                if (_e106 < _e76) {
                } else {
                    return;
                }
                let _e227 = nodes.member[(0u + _e106)].frame[0u];
                let _e231 = nodes.member[(0u + _e106)].frame[1u];
                let _e235 = nodes.member[(0u + _e106)].frame[2u];
                let _e239 = nodes.member[(0u + _e106)].frame[0u];
                let _e243 = nodes.member[(0u + _e106)].frame[1u];
                let _e247 = nodes.member[(0u + _e106)].frame[2u];
                let _e251 = nodes.member[(0u + _e106)].frame[3u];
                let _e290 = core_intrinsics_maximum_number_nsz_f32_(abs(_e157.direction.x), abs(_e157.direction.y));
                let _e291 = core_intrinsics_maximum_number_nsz_f32_(_e290, abs(_e157.direction.z));
                let _e292 = (_e291 * 0.0000000000009094947f);
                if (abs(_e157.direction.x) < _e292) {
                    phi_915_ = _e292;
                } else {
                    phi_915_ = abs(_e157.direction.x);
                }
                let _e298 = phi_915_;
                if (_e157.direction.x < 0f) {
                    phi_922_ = (-1f / _e298);
                } else {
                    phi_922_ = (1f / _e298);
                }
                let _e303 = phi_922_;
                if (abs(_e157.direction.y) < _e292) {
                    phi_930_ = _e292;
                } else {
                    phi_930_ = abs(_e157.direction.y);
                }
                let _e309 = phi_930_;
                if (_e157.direction.y < 0f) {
                    phi_937_ = (-1f / _e309);
                } else {
                    phi_937_ = (1f / _e309);
                }
                let _e314 = phi_937_;
                if (abs(_e157.direction.z) < _e292) {
                    phi_945_ = _e292;
                } else {
                    phi_945_ = abs(_e157.direction.z);
                }
                let _e320 = phi_945_;
                if (_e157.direction.z < 0f) {
                    phi_952_ = (-1f / _e320);
                } else {
                    phi_952_ = (1f / _e320);
                }
                let _e325 = phi_952_;
                let _e332 = abs((bitcast<f32>(_e227) - _e157.origin.x));
                let _e333 = abs((bitcast<f32>(_e231) - _e157.origin.y));
                let _e334 = abs((bitcast<f32>(_e235) - _e157.origin.z));
                let _e341 = abs(((bitcast<f32>(_e239) + (bitcast<f32>((((_e251 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e157.origin.x));
                let _e342 = abs(((bitcast<f32>(_e243) + (bitcast<f32>((((_e251 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e157.origin.y));
                let _e343 = abs(((bitcast<f32>(_e247) + (bitcast<f32>((((_e251 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e157.origin.z));
                if (_e332 > _e341) {
                    phi_975_ = _e332;
                } else {
                    phi_975_ = _e341;
                }
                let _e346 = phi_975_;
                if (_e333 > _e342) {
                    phi_980_ = _e333;
                } else {
                    phi_980_ = _e342;
                }
                let _e349 = phi_980_;
                if (_e334 > _e343) {
                    phi_985_ = _e334;
                } else {
                    phi_985_ = _e343;
                }
                let _e352 = phi_985_;
                if (_e346 > _e349) {
                    phi_990_ = _e346;
                } else {
                    phi_990_ = _e349;
                }
                let _e355 = phi_990_;
                if (_e355 > _e352) {
                    phi_995_ = _e355;
                } else {
                    phi_995_ = _e352;
                }
                let _e358 = phi_995_;
                let _e362 = (_e358 * 0.0000019073486f);
                let _e363 = (abs(_e303) * _e362);
                let _e364 = (abs(_e314) * _e362);
                let _e365 = (abs(_e325) * _e362);
                let _e369 = (_e358 * 0.0000009536743f);
                let _e370 = (abs(_e303) * _e369);
                let _e371 = (abs(_e314) * _e369);
                let _e372 = (abs(_e325) * _e369);
                if (_e303 < 0f) {
                    phi_1014_ = 0u;
                } else {
                    phi_1014_ = 1u;
                }
                let _e375 = phi_1014_;
                if (_e314 < 0f) {
                    phi_1019_ = 0u;
                } else {
                    phi_1019_ = 2u;
                }
                let _e378 = phi_1019_;
                if (_e325 < 0f) {
                    phi_1024_ = 0u;
                } else {
                    phi_1024_ = 4u;
                }
                let _e381 = phi_1024_;
                let _e383 = ((_e375 | _e378) | _e381);
                let _e384 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e106, 2147483648u);
                local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e384.first[0], _e384.first[1], _e384.first[2], _e384.first[3], _e384.first[4], _e384.first[5], _e384.first[6], _e384.first[7], _e384.first[8], _e384.first[9], _e384.first[10], _e384.first[11], _e384.first[12], _e384.first[13], _e384.first[14], _e384.first[15], _e384.first[16], _e384.first[17], _e384.first[18], _e384.first[19], _e384.first[20], _e384.first[21], _e384.first[22], _e384.first[23], _e384.first[24], _e384.first[25], _e384.first[26], _e384.first[27], _e384.first[28], _e384.first[29], _e384.first[30], _e384.first[31]), array<u32, 32>(_e384.mask[0], _e384.mask[1], _e384.mask[2], _e384.mask[3], _e384.mask[4], _e384.mask[5], _e384.mask[6], _e384.mask[7], _e384.mask[8], _e384.mask[9], _e384.mask[10], _e384.mask[11], _e384.mask[12], _e384.mask[13], _e384.mask[14], _e384.mask[15], _e384.mask[16], _e384.mask[17], _e384.mask[18], _e384.mask[19], _e384.mask[20], _e384.mask[21], _e384.mask[22], _e384.mask[23], _e384.mask[24], _e384.mask[25], _e384.mask[26], _e384.mask[27], _e384.mask[28], _e384.mask[29], _e384.mask[30], _e384.mask[31]), _e384.len, _e384.group, _e384.group_mask);
                let _e458 = local_2.group_mask;
                if ((_e458 & 4278190080u) == 0u) {
                    let _e462 = local_2.len;
                    if (_e462 == 0u) {
                        phi_1138_ = false;
                    } else {
                        let _e466 = local_2.len;
                        local_2.len = (_e466 - 1u);
                        let _e469 = local_2.len;
                        if (_e469 < 32u) {
                        } else {
                            return;
                        }
                        let _e474 = local_2.first[(0u + _e469)];
                        local_2.group = _e474;
                        let _e477 = local_2.len;
                        if (_e477 < 32u) {
                        } else {
                            return;
                        }
                        let _e482 = local_2.mask[(0u + _e477)];
                        local_2.group_mask = _e482;
                        phi_1138_ = true;
                    }
                    let _e485 = phi_1138_;
                    phi_1139_ = _e485;
                } else {
                    phi_1139_ = true;
                }
                let _e487 = phi_1139_;
                if _e487 {
                    let _e489 = local_2.group_mask;
                    let _e495 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e489)), 32u, (_e489 == 0u)));
                    let _e499 = local_2.group_mask;
                    let _e513 = local_2.group_mask;
                    local_2.group_mask = (_e513 & ~((1u << bitcast<u32>((_e495 & 31u)))));
                    let _e516 = local_2.group;
                    phi_1170_ = (_e516 + countOneBits(((_e499 & ~((4294967295u << bitcast<u32>((((_e495 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1170_ = 4294967295u;
                }
                let _e519 = phi_1170_;
                phi_1172_ = _e519;
                phi_1175_ = _e159;
                loop {
                    let _e521 = phi_1172_;
                    let _e523 = phi_1175_;
                    local_12 = _e523;
                    let _e524 = (_e521 != 4294967295u);
                    if _e524 {
                        if (_e521 < _e76) {
                        } else {
                            return;
                        }
                        let _e532 = nodes.member[(0u + _e521)].frame[3u];
                        let _e557 = (bitcast<f32>((((_e532 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e303);
                        let _e558 = (bitcast<f32>((((_e532 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e314);
                        let _e559 = (bitcast<f32>((((_e532 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e325);
                        let _e562 = nodes.member[(0u + _e521)].frame[0u];
                        let _e566 = nodes.member[(0u + _e521)].frame[1u];
                        let _e570 = nodes.member[(0u + _e521)].frame[2u];
                        let _e578 = ((bitcast<f32>(_e562) - _e157.origin.x) * _e303);
                        let _e579 = ((bitcast<f32>(_e566) - _e157.origin.y) * _e314);
                        let _e580 = ((bitcast<f32>(_e570) - _e157.origin.z) * _e325);
                        let _e588 = nodes.member[(0u + _e521)].x;
                        if (_e303 < 0f) {
                            let _e599 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e588.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e605 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e599.unnamed.word, _e588.w), _e599.unnamed_1);
                            let _e611 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e605.unnamed, lt_mask_LightPlace(_e588.x, _e605.unnamed_1.shift));
                            phi_1260_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e611.unnamed, lt_mask_LightPlace(_e611.unnamed_1.word, _e588.y));
                        } else {
                            let _e627 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e588.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e633 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e627.unnamed.word, _e588.y), _e627.unnamed_1);
                            let _e639 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e633.unnamed, lt_mask_LightPlace(_e588.z, _e633.unnamed_1.shift));
                            phi_1260_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e639.unnamed, lt_mask_LightPlace(_e639.unnamed_1.word, _e588.w));
                        }
                        let _e647 = phi_1260_;
                        let _e657 = nodes.member[(0u + _e521)].y;
                        if (_e314 < 0f) {
                            let _e668 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e657.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e674 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e668.unnamed.word, _e657.w), _e668.unnamed_1);
                            let _e680 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e674.unnamed, lt_mask_LightPlace(_e657.x, _e674.unnamed_1.shift));
                            phi_1287_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e680.unnamed, lt_mask_LightPlace(_e680.unnamed_1.word, _e657.y));
                        } else {
                            let _e696 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e657.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e702 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e696.unnamed.word, _e657.y), _e696.unnamed_1);
                            let _e708 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e702.unnamed, lt_mask_LightPlace(_e657.z, _e702.unnamed_1.shift));
                            phi_1287_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e708.unnamed, lt_mask_LightPlace(_e708.unnamed_1.word, _e657.w));
                        }
                        let _e716 = phi_1287_;
                        let _e726 = nodes.member[(0u + _e521)].z;
                        if (_e325 < 0f) {
                            let _e737 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e726.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e743 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e737.unnamed.word, _e726.w), _e737.unnamed_1);
                            let _e749 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e743.unnamed, lt_mask_LightPlace(_e726.x, _e743.unnamed_1.shift));
                            phi_1314_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e749.unnamed, lt_mask_LightPlace(_e749.unnamed_1.word, _e726.y));
                        } else {
                            let _e765 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e726.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e771 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e765.unnamed.word, _e726.y), _e765.unnamed_1);
                            let _e777 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e771.unnamed, lt_mask_LightPlace(_e726.z, _e771.unnamed_1.shift));
                            phi_1314_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e777.unnamed, lt_mask_LightPlace(_e777.unnamed_1.word, _e726.w));
                        }
                        let _e785 = phi_1314_;
                        phi_1320_ = 0u;
                        phi_1323_ = 0u;
                        loop {
                            let _e795 = phi_1320_;
                            let _e797 = phi_1323_;
                            local_3 = _e797;
                            local_4 = _e797;
                            local_5 = _e797;
                            let _e798 = (_e795 < 8u);
                            if _e798 {
                                let _e800 = (_e795 >> bitcast<u32>(2i));
                                let _e801 = (_e795 & 3u);
                                if (_e800 == 0u) {
                                    phi_1337_ = _e647.unnamed.word;
                                } else {
                                    phi_1337_ = _e647.unnamed.shift;
                                }
                                let _e804 = phi_1337_;
                                if (_e800 == 0u) {
                                    phi_1347_ = _e716.unnamed.word;
                                } else {
                                    phi_1347_ = _e716.unnamed.shift;
                                }
                                let _e813 = phi_1347_;
                                if (_e800 == 0u) {
                                    phi_1357_ = _e785.unnamed.word;
                                } else {
                                    phi_1357_ = _e785.unnamed.shift;
                                }
                                let _e822 = phi_1357_;
                                let _e835 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e804 >> bitcast<u32>(((_e801 * 8u) & 31u))) & 255u)) * _e557) + (_e578 - _e363)), ((f32(((_e813 >> bitcast<u32>(((_e801 * 8u) & 31u))) & 255u)) * _e558) + (_e579 - _e364)));
                                let _e836 = core_intrinsics_maximum_number_nsz_f32_(_e835, ((f32(((_e822 >> bitcast<u32>(((_e801 * 8u) & 31u))) & 255u)) * _e559) + (_e580 - _e365)));
                                if (_e800 == 0u) {
                                    phi_1375_ = _e647.unnamed_1.word;
                                } else {
                                    phi_1375_ = _e647.unnamed_1.shift;
                                }
                                let _e839 = phi_1375_;
                                if (_e800 == 0u) {
                                    phi_1385_ = _e716.unnamed_1.word;
                                } else {
                                    phi_1385_ = _e716.unnamed_1.shift;
                                }
                                let _e848 = phi_1385_;
                                if (_e800 == 0u) {
                                    phi_1395_ = _e785.unnamed_1.word;
                                } else {
                                    phi_1395_ = _e785.unnamed_1.shift;
                                }
                                let _e857 = phi_1395_;
                                let _e870 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e839 >> bitcast<u32>(((_e801 * 8u) & 31u))) & 255u)) * _e557) + (_e578 + _e363)), ((f32(((_e848 >> bitcast<u32>(((_e801 * 8u) & 31u))) & 255u)) * _e558) + (_e579 + _e364)));
                                let _e871 = core_intrinsics_minimum_number_nsz_f32_(_e870, ((f32(((_e857 >> bitcast<u32>(((_e801 * 8u) & 31u))) & 255u)) * _e559) + (_e580 + _e365)));
                                if (_e836 <= _e871) {
                                    if (_e836 <= _e523.t) {
                                        if (_e871 >= _e157.tmin) {
                                            if (_e800 == 0u) {
                                                let _e878 = nodes.member[(0u + _e521)].links[2u];
                                                phi_1431_ = _e878;
                                            } else {
                                                let _e881 = nodes.member[(0u + _e521)].links[3u];
                                                phi_1431_ = _e881;
                                            }
                                            let _e883 = phi_1431_;
                                            let _e888 = ((_e883 >> bitcast<u32>(((_e801 * 8u) & 31u))) & 255u);
                                            let _e889 = (_e888 & 31u);
                                            if (_e889 >= 24u) {
                                                phi_1444_ = (24u + ((_e889 - 24u) ^ _e383));
                                            } else {
                                                phi_1444_ = _e889;
                                            }
                                            let _e895 = phi_1444_;
                                            phi_1449_ = (_e797 | ((_e888 >> bitcast<u32>(5i)) << bitcast<u32>((_e895 & 31u))));
                                        } else {
                                            phi_1449_ = _e797;
                                        }
                                        let _e903 = phi_1449_;
                                        phi_1450_ = _e903;
                                    } else {
                                        phi_1450_ = _e797;
                                    }
                                    let _e905 = phi_1450_;
                                    phi_1451_ = _e905;
                                } else {
                                    phi_1451_ = _e797;
                                }
                                let _e907 = phi_1451_;
                                phi_1321_ = (_e795 + 1u);
                                phi_1324_ = _e907;
                            } else {
                                phi_1321_ = u32();
                                phi_1324_ = u32();
                            }
                            let _e910 = phi_1321_;
                            let _e912 = phi_1324_;
                            continue;
                            continuing {
                                phi_1320_ = _e910;
                                phi_1323_ = _e912;
                                break if !(_e798);
                            }
                        }
                        let _e916 = nodes.member[(0u + _e521)].links[0u];
                        let _e920 = nodes.member[(0u + _e521)].frame[3u];
                        let _e924 = local_3;
                        if ((_e924 & 4278190080u) == 0u) {
                        } else {
                            let _e928 = local_2.group_mask;
                            if ((_e928 & 4278190080u) == 0u) {
                            } else {
                                let _e932 = local_2.len;
                                if (_e932 < 32u) {
                                    let _e935 = local_2.group;
                                    let _e937 = local_2.len;
                                    if (_e937 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.first[(0u + _e937)] = _e935;
                                    let _e943 = local_2.group_mask;
                                    let _e945 = local_2.len;
                                    if (_e945 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.mask[(0u + _e945)] = _e943;
                                    let _e952 = local_2.len;
                                    local_2.len = (_e952 + 1u);
                                }
                            }
                            local_2.group = (_e106 + _e916);
                            let _e956 = local_4;
                            local_2.group_mask = ((_e956 & 4278190080u) | (_e920 >> bitcast<u32>(24i)));
                        }
                        let _e961 = local_5;
                        phi_1509_ = (_e961 & 16777215u);
                        phi_1512_ = _e523;
                        loop {
                            let _e964 = phi_1509_;
                            let _e966 = phi_1512_;
                            local_11 = _e966;
                            if (_e964 == 0u) {
                                phi_1510_ = u32();
                                phi_1513_ = lt_bvh_Hit();
                                phi_3399_ = false;
                            } else {
                                let _e970 = nodes.member[(0u + _e521)].links[1u];
                                let _e974 = (_e970 + select(firstTrailingBit(_e964), 32u, (_e964 == 0u)));
                                if (_e974 < _e91) {
                                } else {
                                    return;
                                }
                                let _e981 = instances.member[(0u + _e974)].low_world;
                                let _e983 = instances.member[(0u + _e974)].high_world;
                                let _e993 = ((_e981.x - _e157.origin.x) * _e303);
                                let _e994 = ((_e981.y - _e157.origin.y) * _e314);
                                let _e995 = ((_e981.z - _e157.origin.z) * _e325);
                                let _e1005 = ((_e983.x - _e157.origin.x) * _e303);
                                let _e1006 = ((_e983.y - _e157.origin.y) * _e314);
                                let _e1007 = ((_e983.z - _e157.origin.z) * _e325);
                                if (_e993 < _e1005) {
                                    phi_1567_ = _e993;
                                } else {
                                    phi_1567_ = _e1005;
                                }
                                let _e1010 = phi_1567_;
                                if (_e994 < _e1006) {
                                    phi_1572_ = _e994;
                                } else {
                                    phi_1572_ = _e1006;
                                }
                                let _e1013 = phi_1572_;
                                if (_e995 < _e1007) {
                                    phi_1577_ = _e995;
                                } else {
                                    phi_1577_ = _e1007;
                                }
                                let _e1016 = phi_1577_;
                                if (_e993 > _e1005) {
                                    phi_1585_ = _e993;
                                } else {
                                    phi_1585_ = _e1005;
                                }
                                let _e1022 = phi_1585_;
                                if (_e994 > _e1006) {
                                    phi_1590_ = _e994;
                                } else {
                                    phi_1590_ = _e1006;
                                }
                                let _e1025 = phi_1590_;
                                if (_e995 > _e1007) {
                                    phi_1595_ = _e995;
                                } else {
                                    phi_1595_ = _e1007;
                                }
                                let _e1028 = phi_1595_;
                                let _e1032 = core_intrinsics_maximum_number_nsz_f32_((_e1010 - _e370), (_e1013 - _e371));
                                let _e1033 = core_intrinsics_maximum_number_nsz_f32_(_e1032, (_e1016 - _e372));
                                let _e1034 = core_intrinsics_minimum_number_nsz_f32_((_e1022 + _e370), (_e1025 + _e371));
                                let _e1035 = core_intrinsics_minimum_number_nsz_f32_(_e1034, (_e1028 + _e372));
                                if (_e1033 <= _e1035) {
                                    if (_e1033 <= _e966.t) {
                                        if (_e1035 >= _e157.tmin) {
                                            let _e1047 = instances.member[(0u + _e974)].world_to_object[0u];
                                            let _e1058 = ((((_e1047.x * _e157.origin.x) + (_e1047.y * _e157.origin.y)) + (_e1047.z * _e157.origin.z)) + (_e1047.w * 1f));
                                            let _e1060 = instances.member[(0u + _e974)].world_to_object[1u];
                                            let _e1071 = ((((_e1060.x * _e157.origin.x) + (_e1060.y * _e157.origin.y)) + (_e1060.z * _e157.origin.z)) + (_e1060.w * 1f));
                                            let _e1073 = instances.member[(0u + _e974)].world_to_object[2u];
                                            let _e1084 = ((((_e1073.x * _e157.origin.x) + (_e1073.y * _e157.origin.y)) + (_e1073.z * _e157.origin.z)) + (_e1073.w * 1f));
                                            let _e1091 = instances.member[(0u + _e974)].world_to_object[0u];
                                            let _e1102 = ((((_e1091.x * _e157.direction.x) + (_e1091.y * _e157.direction.y)) + (_e1091.z * _e157.direction.z)) + (_e1091.w * 0f));
                                            let _e1104 = instances.member[(0u + _e974)].world_to_object[1u];
                                            let _e1115 = ((((_e1104.x * _e157.direction.x) + (_e1104.y * _e157.direction.y)) + (_e1104.z * _e157.direction.z)) + (_e1104.w * 0f));
                                            let _e1117 = instances.member[(0u + _e974)].world_to_object[2u];
                                            let _e1128 = ((((_e1117.x * _e157.direction.x) + (_e1117.y * _e157.direction.y)) + (_e1117.z * _e157.direction.z)) + (_e1117.w * 0f));
                                            let _e1133 = instances.member[(0u + _e974)].root;
                                            let _e1135 = instances.member[(0u + _e974)].first_triangle;
                                            let _e1136 = abs(_e1102);
                                            let _e1137 = abs(_e1115);
                                            let _e1138 = abs(_e1128);
                                            if (abs(_e1058) < 1000000000000000f) {
                                                if (abs(_e1071) < 1000000000000000f) {
                                                    phi_1727_ = (abs(_e1084) < 1000000000000000f);
                                                    phi_1728_ = false;
                                                } else {
                                                    phi_1727_ = bool();
                                                    phi_1728_ = true;
                                                }
                                                let _e1146 = phi_1727_;
                                                let _e1148 = phi_1728_;
                                                phi_1729_ = _e1146;
                                                phi_1730_ = _e1148;
                                            } else {
                                                phi_1729_ = bool();
                                                phi_1730_ = true;
                                            }
                                            let _e1150 = phi_1729_;
                                            let _e1152 = phi_1730_;
                                            if _e1152 {
                                                phi_1734_ = false;
                                            } else {
                                                phi_1734_ = _e1150;
                                            }
                                            let _e1154 = phi_1734_;
                                            if _e1154 {
                                                if (_e1136 < 1000000000000000f) {
                                                    if (_e1137 < 1000000000000000f) {
                                                        phi_1747_ = (_e1138 < 1000000000000000f);
                                                        phi_1748_ = false;
                                                    } else {
                                                        phi_1747_ = bool();
                                                        phi_1748_ = true;
                                                    }
                                                    let _e1159 = phi_1747_;
                                                    let _e1161 = phi_1748_;
                                                    phi_1749_ = _e1159;
                                                    phi_1750_ = _e1161;
                                                } else {
                                                    phi_1749_ = bool();
                                                    phi_1750_ = true;
                                                }
                                                let _e1163 = phi_1749_;
                                                let _e1165 = phi_1750_;
                                                if _e1165 {
                                                    phi_1754_ = false;
                                                } else {
                                                    phi_1754_ = _e1163;
                                                }
                                                let _e1167 = phi_1754_;
                                                if _e1167 {
                                                    if (_e1136 > 0f) {
                                                        phi_1768_ = bool();
                                                        phi_1769_ = true;
                                                    } else {
                                                        let _e1169 = (_e1137 > 0f);
                                                        if _e1169 {
                                                            phi_1767_ = bool();
                                                        } else {
                                                            phi_1767_ = (_e1138 > 0f);
                                                        }
                                                        let _e1172 = phi_1767_;
                                                        phi_1768_ = _e1172;
                                                        phi_1769_ = _e1169;
                                                    }
                                                    let _e1174 = phi_1768_;
                                                    let _e1176 = phi_1769_;
                                                    if _e1176 {
                                                        phi_1773_ = true;
                                                    } else {
                                                        phi_1773_ = _e1174;
                                                    }
                                                    let _e1178 = phi_1773_;
                                                    phi_1774_ = _e1178;
                                                    phi_1775_ = false;
                                                } else {
                                                    phi_1774_ = bool();
                                                    phi_1775_ = true;
                                                }
                                                let _e1180 = phi_1774_;
                                                let _e1182 = phi_1775_;
                                                phi_1776_ = _e1180;
                                                phi_1777_ = _e1182;
                                            } else {
                                                phi_1776_ = bool();
                                                phi_1777_ = true;
                                            }
                                            let _e1184 = phi_1776_;
                                            let _e1186 = phi_1777_;
                                            if _e1186 {
                                                phi_1781_ = false;
                                            } else {
                                                phi_1781_ = _e1184;
                                            }
                                            let _e1188 = phi_1781_;
                                            if _e1188 {
                                                let _e1189 = (_e1133 >= _e76);
                                                if _e1189 {
                                                    phi_3389_ = lt_bvh_Hit();
                                                } else {
                                                    if (_e1133 < _e76) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1195 = nodes.member[(0u + _e1133)].frame[0u];
                                                    let _e1199 = nodes.member[(0u + _e1133)].frame[1u];
                                                    let _e1203 = nodes.member[(0u + _e1133)].frame[2u];
                                                    let _e1207 = nodes.member[(0u + _e1133)].frame[0u];
                                                    let _e1211 = nodes.member[(0u + _e1133)].frame[1u];
                                                    let _e1215 = nodes.member[(0u + _e1133)].frame[2u];
                                                    let _e1219 = nodes.member[(0u + _e1133)].frame[3u];
                                                    let _e1253 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1102), abs(_e1115));
                                                    let _e1254 = core_intrinsics_maximum_number_nsz_f32_(_e1253, abs(_e1128));
                                                    let _e1255 = (_e1254 * 0.0000000000009094947f);
                                                    if (abs(_e1102) < _e1255) {
                                                        phi_1851_ = _e1255;
                                                    } else {
                                                        phi_1851_ = abs(_e1102);
                                                    }
                                                    let _e1260 = phi_1851_;
                                                    if (_e1102 < 0f) {
                                                        phi_1858_ = (-1f / _e1260);
                                                    } else {
                                                        phi_1858_ = (1f / _e1260);
                                                    }
                                                    let _e1265 = phi_1858_;
                                                    if (abs(_e1115) < _e1255) {
                                                        phi_1865_ = _e1255;
                                                    } else {
                                                        phi_1865_ = abs(_e1115);
                                                    }
                                                    let _e1270 = phi_1865_;
                                                    if (_e1115 < 0f) {
                                                        phi_1872_ = (-1f / _e1270);
                                                    } else {
                                                        phi_1872_ = (1f / _e1270);
                                                    }
                                                    let _e1275 = phi_1872_;
                                                    if (abs(_e1128) < _e1255) {
                                                        phi_1879_ = _e1255;
                                                    } else {
                                                        phi_1879_ = abs(_e1128);
                                                    }
                                                    let _e1280 = phi_1879_;
                                                    if (_e1128 < 0f) {
                                                        phi_1886_ = (-1f / _e1280);
                                                    } else {
                                                        phi_1886_ = (1f / _e1280);
                                                    }
                                                    let _e1285 = phi_1886_;
                                                    let _e1289 = abs((bitcast<f32>(_e1195) - _e1058));
                                                    let _e1290 = abs((bitcast<f32>(_e1199) - _e1071));
                                                    let _e1291 = abs((bitcast<f32>(_e1203) - _e1084));
                                                    let _e1295 = abs(((bitcast<f32>(_e1207) + (bitcast<f32>((((_e1219 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1058));
                                                    let _e1296 = abs(((bitcast<f32>(_e1211) + (bitcast<f32>((((_e1219 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1071));
                                                    let _e1297 = abs(((bitcast<f32>(_e1215) + (bitcast<f32>((((_e1219 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1084));
                                                    if (_e1289 > _e1295) {
                                                        phi_1903_ = _e1289;
                                                    } else {
                                                        phi_1903_ = _e1295;
                                                    }
                                                    let _e1300 = phi_1903_;
                                                    if (_e1290 > _e1296) {
                                                        phi_1908_ = _e1290;
                                                    } else {
                                                        phi_1908_ = _e1296;
                                                    }
                                                    let _e1303 = phi_1908_;
                                                    if (_e1291 > _e1297) {
                                                        phi_1913_ = _e1291;
                                                    } else {
                                                        phi_1913_ = _e1297;
                                                    }
                                                    let _e1306 = phi_1913_;
                                                    if (_e1300 > _e1303) {
                                                        phi_1918_ = _e1300;
                                                    } else {
                                                        phi_1918_ = _e1303;
                                                    }
                                                    let _e1309 = phi_1918_;
                                                    if (_e1309 > _e1306) {
                                                        phi_1923_ = _e1309;
                                                    } else {
                                                        phi_1923_ = _e1306;
                                                    }
                                                    let _e1312 = phi_1923_;
                                                    let _e1316 = (_e1312 * 0.0000019073486f);
                                                    let _e1317 = (abs(_e1265) * _e1316);
                                                    let _e1318 = (abs(_e1275) * _e1316);
                                                    let _e1319 = (abs(_e1285) * _e1316);
                                                    let _e1323 = (_e1312 * 0.0000009536743f);
                                                    let _e1324 = (abs(_e1265) * _e1323);
                                                    let _e1325 = (abs(_e1275) * _e1323);
                                                    let _e1326 = (abs(_e1285) * _e1323);
                                                    let _e1327 = abs(_e1102);
                                                    let _e1328 = abs(_e1115);
                                                    let _e1329 = abs(_e1128);
                                                    if (_e1327 >= _e1328) {
                                                        if (_e1327 >= _e1329) {
                                                            phi_1949_ = false;
                                                        } else {
                                                            phi_1949_ = true;
                                                        }
                                                        let _e1333 = phi_1949_;
                                                        phi_1950_ = _e1333;
                                                    } else {
                                                        phi_1950_ = true;
                                                    }
                                                    let _e1335 = phi_1950_;
                                                    if _e1335 {
                                                        if (_e1328 >= _e1329) {
                                                            phi_1958_ = 1u;
                                                        } else {
                                                            phi_1958_ = 2u;
                                                        }
                                                        let _e1338 = phi_1958_;
                                                        phi_1959_ = _e1338;
                                                    } else {
                                                        phi_1959_ = 0u;
                                                    }
                                                    let _e1340 = phi_1959_;
                                                    if (_e1340 == 0u) {
                                                        phi_1971_ = vec3<f32>(_e1115, _e1128, _e1102);
                                                    } else {
                                                        if (_e1340 == 1u) {
                                                            phi_1970_ = vec3<f32>(_e1128, _e1102, _e1115);
                                                        } else {
                                                            phi_1970_ = vec3<f32>(_e1102, _e1115, _e1128);
                                                        }
                                                        let _e1346 = phi_1970_;
                                                        phi_1971_ = _e1346;
                                                    }
                                                    let _e1348 = phi_1971_;
                                                    let _e1351 = (_e1348.x / _e1348.z);
                                                    let _e1354 = (_e1348.y / _e1348.z);
                                                    if (_e1265 < 0f) {
                                                        phi_1984_ = 0u;
                                                    } else {
                                                        phi_1984_ = 1u;
                                                    }
                                                    let _e1359 = phi_1984_;
                                                    if (_e1275 < 0f) {
                                                        phi_1989_ = 0u;
                                                    } else {
                                                        phi_1989_ = 2u;
                                                    }
                                                    let _e1362 = phi_1989_;
                                                    if (_e1285 < 0f) {
                                                        phi_1994_ = 0u;
                                                    } else {
                                                        phi_1994_ = 4u;
                                                    }
                                                    let _e1365 = phi_1994_;
                                                    let _e1367 = ((_e1359 | _e1362) | _e1365);
                                                    let _e1368 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1133, 2147483648u);
                                                    local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e1368.first[0], _e1368.first[1], _e1368.first[2], _e1368.first[3], _e1368.first[4], _e1368.first[5], _e1368.first[6], _e1368.first[7], _e1368.first[8], _e1368.first[9], _e1368.first[10], _e1368.first[11], _e1368.first[12], _e1368.first[13], _e1368.first[14], _e1368.first[15], _e1368.first[16], _e1368.first[17], _e1368.first[18], _e1368.first[19], _e1368.first[20], _e1368.first[21], _e1368.first[22], _e1368.first[23], _e1368.first[24], _e1368.first[25], _e1368.first[26], _e1368.first[27], _e1368.first[28], _e1368.first[29], _e1368.first[30], _e1368.first[31]), array<u32, 32>(_e1368.mask[0], _e1368.mask[1], _e1368.mask[2], _e1368.mask[3], _e1368.mask[4], _e1368.mask[5], _e1368.mask[6], _e1368.mask[7], _e1368.mask[8], _e1368.mask[9], _e1368.mask[10], _e1368.mask[11], _e1368.mask[12], _e1368.mask[13], _e1368.mask[14], _e1368.mask[15], _e1368.mask[16], _e1368.mask[17], _e1368.mask[18], _e1368.mask[19], _e1368.mask[20], _e1368.mask[21], _e1368.mask[22], _e1368.mask[23], _e1368.mask[24], _e1368.mask[25], _e1368.mask[26], _e1368.mask[27], _e1368.mask[28], _e1368.mask[29], _e1368.mask[30], _e1368.mask[31]), _e1368.len, _e1368.group, _e1368.group_mask);
                                                    let _e1442 = local_1.group_mask;
                                                    if ((_e1442 & 4278190080u) == 0u) {
                                                        let _e1446 = local_1.len;
                                                        if (_e1446 == 0u) {
                                                            phi_2108_ = false;
                                                        } else {
                                                            let _e1450 = local_1.len;
                                                            local_1.len = (_e1450 - 1u);
                                                            let _e1453 = local_1.len;
                                                            if (_e1453 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1458 = local_1.first[(0u + _e1453)];
                                                            local_1.group = _e1458;
                                                            let _e1461 = local_1.len;
                                                            if (_e1461 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1466 = local_1.mask[(0u + _e1461)];
                                                            local_1.group_mask = _e1466;
                                                            phi_2108_ = true;
                                                        }
                                                        let _e1469 = phi_2108_;
                                                        phi_2109_ = _e1469;
                                                    } else {
                                                        phi_2109_ = true;
                                                    }
                                                    let _e1471 = phi_2109_;
                                                    if _e1471 {
                                                        let _e1473 = local_1.group_mask;
                                                        let _e1479 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1473)), 32u, (_e1473 == 0u)));
                                                        let _e1483 = local_1.group_mask;
                                                        let _e1497 = local_1.group_mask;
                                                        local_1.group_mask = (_e1497 & ~((1u << bitcast<u32>((_e1479 & 31u)))));
                                                        let _e1500 = local_1.group;
                                                        phi_2140_ = (_e1500 + countOneBits(((_e1483 & ~((4294967295u << bitcast<u32>((((_e1479 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_2140_ = 4294967295u;
                                                    }
                                                    let _e1503 = phi_2140_;
                                                    phi_2142_ = _e966;
                                                    phi_2145_ = _e1503;
                                                    loop {
                                                        let _e1505 = phi_2142_;
                                                        let _e1507 = phi_2145_;
                                                        local_10 = _e1505;
                                                        let _e1508 = (_e1507 != 4294967295u);
                                                        if _e1508 {
                                                            if (_e1507 < _e76) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1515 = nodes.member[(0u + _e1507)].frame[3u];
                                                            let _e1540 = (bitcast<f32>((((_e1515 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1265);
                                                            let _e1541 = (bitcast<f32>((((_e1515 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1275);
                                                            let _e1542 = (bitcast<f32>((((_e1515 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1285);
                                                            let _e1545 = nodes.member[(0u + _e1507)].frame[0u];
                                                            let _e1549 = nodes.member[(0u + _e1507)].frame[1u];
                                                            let _e1553 = nodes.member[(0u + _e1507)].frame[2u];
                                                            let _e1558 = ((bitcast<f32>(_e1545) - _e1058) * _e1265);
                                                            let _e1559 = ((bitcast<f32>(_e1549) - _e1071) * _e1275);
                                                            let _e1560 = ((bitcast<f32>(_e1553) - _e1084) * _e1285);
                                                            let _e1568 = nodes.member[(0u + _e1507)].x;
                                                            if (_e1265 < 0f) {
                                                                let _e1579 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1568.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1585 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1579.unnamed.word, _e1568.w), _e1579.unnamed_1);
                                                                let _e1591 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1585.unnamed, lt_mask_LightPlace(_e1568.x, _e1585.unnamed_1.shift));
                                                                phi_2226_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1591.unnamed, lt_mask_LightPlace(_e1591.unnamed_1.word, _e1568.y));
                                                            } else {
                                                                let _e1607 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1568.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1613 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1607.unnamed.word, _e1568.y), _e1607.unnamed_1);
                                                                let _e1619 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1613.unnamed, lt_mask_LightPlace(_e1568.z, _e1613.unnamed_1.shift));
                                                                phi_2226_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1619.unnamed, lt_mask_LightPlace(_e1619.unnamed_1.word, _e1568.w));
                                                            }
                                                            let _e1627 = phi_2226_;
                                                            let _e1637 = nodes.member[(0u + _e1507)].y;
                                                            if (_e1275 < 0f) {
                                                                let _e1648 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1637.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1654 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1648.unnamed.word, _e1637.w), _e1648.unnamed_1);
                                                                let _e1660 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1654.unnamed, lt_mask_LightPlace(_e1637.x, _e1654.unnamed_1.shift));
                                                                phi_2253_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1660.unnamed, lt_mask_LightPlace(_e1660.unnamed_1.word, _e1637.y));
                                                            } else {
                                                                let _e1676 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1637.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1682 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1676.unnamed.word, _e1637.y), _e1676.unnamed_1);
                                                                let _e1688 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1682.unnamed, lt_mask_LightPlace(_e1637.z, _e1682.unnamed_1.shift));
                                                                phi_2253_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1688.unnamed, lt_mask_LightPlace(_e1688.unnamed_1.word, _e1637.w));
                                                            }
                                                            let _e1696 = phi_2253_;
                                                            let _e1706 = nodes.member[(0u + _e1507)].z;
                                                            if (_e1285 < 0f) {
                                                                let _e1717 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1706.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1723 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1717.unnamed.word, _e1706.w), _e1717.unnamed_1);
                                                                let _e1729 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1723.unnamed, lt_mask_LightPlace(_e1706.x, _e1723.unnamed_1.shift));
                                                                phi_2280_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1729.unnamed, lt_mask_LightPlace(_e1729.unnamed_1.word, _e1706.y));
                                                            } else {
                                                                let _e1745 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1706.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1751 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1745.unnamed.word, _e1706.y), _e1745.unnamed_1);
                                                                let _e1757 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1751.unnamed, lt_mask_LightPlace(_e1706.z, _e1751.unnamed_1.shift));
                                                                phi_2280_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1757.unnamed, lt_mask_LightPlace(_e1757.unnamed_1.word, _e1706.w));
                                                            }
                                                            let _e1765 = phi_2280_;
                                                            phi_2286_ = 0u;
                                                            phi_2289_ = 0u;
                                                            loop {
                                                                let _e1775 = phi_2286_;
                                                                let _e1777 = phi_2289_;
                                                                local_6 = _e1777;
                                                                local_7 = _e1777;
                                                                local_8 = _e1777;
                                                                let _e1778 = (_e1775 < 8u);
                                                                if _e1778 {
                                                                    let _e1780 = (_e1775 >> bitcast<u32>(2i));
                                                                    let _e1781 = (_e1775 & 3u);
                                                                    if (_e1780 == 0u) {
                                                                        phi_2303_ = _e1627.unnamed.word;
                                                                    } else {
                                                                        phi_2303_ = _e1627.unnamed.shift;
                                                                    }
                                                                    let _e1784 = phi_2303_;
                                                                    if (_e1780 == 0u) {
                                                                        phi_2313_ = _e1696.unnamed.word;
                                                                    } else {
                                                                        phi_2313_ = _e1696.unnamed.shift;
                                                                    }
                                                                    let _e1793 = phi_2313_;
                                                                    if (_e1780 == 0u) {
                                                                        phi_2323_ = _e1765.unnamed.word;
                                                                    } else {
                                                                        phi_2323_ = _e1765.unnamed.shift;
                                                                    }
                                                                    let _e1802 = phi_2323_;
                                                                    let _e1815 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1784 >> bitcast<u32>(((_e1781 * 8u) & 31u))) & 255u)) * _e1540) + (_e1558 - _e1317)), ((f32(((_e1793 >> bitcast<u32>(((_e1781 * 8u) & 31u))) & 255u)) * _e1541) + (_e1559 - _e1318)));
                                                                    let _e1816 = core_intrinsics_maximum_number_nsz_f32_(_e1815, ((f32(((_e1802 >> bitcast<u32>(((_e1781 * 8u) & 31u))) & 255u)) * _e1542) + (_e1560 - _e1319)));
                                                                    if (_e1780 == 0u) {
                                                                        phi_2341_ = _e1627.unnamed_1.word;
                                                                    } else {
                                                                        phi_2341_ = _e1627.unnamed_1.shift;
                                                                    }
                                                                    let _e1819 = phi_2341_;
                                                                    if (_e1780 == 0u) {
                                                                        phi_2351_ = _e1696.unnamed_1.word;
                                                                    } else {
                                                                        phi_2351_ = _e1696.unnamed_1.shift;
                                                                    }
                                                                    let _e1828 = phi_2351_;
                                                                    if (_e1780 == 0u) {
                                                                        phi_2361_ = _e1765.unnamed_1.word;
                                                                    } else {
                                                                        phi_2361_ = _e1765.unnamed_1.shift;
                                                                    }
                                                                    let _e1837 = phi_2361_;
                                                                    let _e1850 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1819 >> bitcast<u32>(((_e1781 * 8u) & 31u))) & 255u)) * _e1540) + (_e1558 + _e1317)), ((f32(((_e1828 >> bitcast<u32>(((_e1781 * 8u) & 31u))) & 255u)) * _e1541) + (_e1559 + _e1318)));
                                                                    let _e1851 = core_intrinsics_minimum_number_nsz_f32_(_e1850, ((f32(((_e1837 >> bitcast<u32>(((_e1781 * 8u) & 31u))) & 255u)) * _e1542) + (_e1560 + _e1319)));
                                                                    if (_e1816 <= _e1851) {
                                                                        if (_e1816 <= _e1505.t) {
                                                                            if (_e1851 >= _e157.tmin) {
                                                                                if (_e1780 == 0u) {
                                                                                    let _e1858 = nodes.member[(0u + _e1507)].links[2u];
                                                                                    phi_2397_ = _e1858;
                                                                                } else {
                                                                                    let _e1861 = nodes.member[(0u + _e1507)].links[3u];
                                                                                    phi_2397_ = _e1861;
                                                                                }
                                                                                let _e1863 = phi_2397_;
                                                                                let _e1868 = ((_e1863 >> bitcast<u32>(((_e1781 * 8u) & 31u))) & 255u);
                                                                                let _e1869 = (_e1868 & 31u);
                                                                                if (_e1869 >= 24u) {
                                                                                    phi_2410_ = (24u + ((_e1869 - 24u) ^ _e1367));
                                                                                } else {
                                                                                    phi_2410_ = _e1869;
                                                                                }
                                                                                let _e1875 = phi_2410_;
                                                                                phi_2415_ = (_e1777 | ((_e1868 >> bitcast<u32>(5i)) << bitcast<u32>((_e1875 & 31u))));
                                                                            } else {
                                                                                phi_2415_ = _e1777;
                                                                            }
                                                                            let _e1883 = phi_2415_;
                                                                            phi_2416_ = _e1883;
                                                                        } else {
                                                                            phi_2416_ = _e1777;
                                                                        }
                                                                        let _e1885 = phi_2416_;
                                                                        phi_2417_ = _e1885;
                                                                    } else {
                                                                        phi_2417_ = _e1777;
                                                                    }
                                                                    let _e1887 = phi_2417_;
                                                                    phi_2287_ = (_e1775 + 1u);
                                                                    phi_2290_ = _e1887;
                                                                } else {
                                                                    phi_2287_ = u32();
                                                                    phi_2290_ = u32();
                                                                }
                                                                let _e1890 = phi_2287_;
                                                                let _e1892 = phi_2290_;
                                                                continue;
                                                                continuing {
                                                                    phi_2286_ = _e1890;
                                                                    phi_2289_ = _e1892;
                                                                    break if !(_e1778);
                                                                }
                                                            }
                                                            let _e1896 = nodes.member[(0u + _e1507)].links[0u];
                                                            let _e1900 = nodes.member[(0u + _e1507)].frame[3u];
                                                            let _e1904 = local_6;
                                                            if ((_e1904 & 4278190080u) == 0u) {
                                                            } else {
                                                                let _e1908 = local_1.group_mask;
                                                                if ((_e1908 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1912 = local_1.len;
                                                                    if (_e1912 < 32u) {
                                                                        let _e1915 = local_1.group;
                                                                        let _e1917 = local_1.len;
                                                                        if (_e1917 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_1.first[(0u + _e1917)] = _e1915;
                                                                        let _e1923 = local_1.group_mask;
                                                                        let _e1925 = local_1.len;
                                                                        if (_e1925 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_1.mask[(0u + _e1925)] = _e1923;
                                                                        let _e1932 = local_1.len;
                                                                        local_1.len = (_e1932 + 1u);
                                                                    }
                                                                }
                                                                local_1.group = (_e1133 + _e1896);
                                                                let _e1936 = local_7;
                                                                local_1.group_mask = ((_e1936 & 4278190080u) | (_e1900 >> bitcast<u32>(24i)));
                                                            }
                                                            let _e1941 = local_8;
                                                            phi_2475_ = _e1505;
                                                            phi_2478_ = (_e1941 & 16777215u);
                                                            loop {
                                                                let _e1944 = phi_2475_;
                                                                let _e1946 = phi_2478_;
                                                                local_9 = _e1944;
                                                                if (_e1946 == 0u) {
                                                                    phi_2476_ = lt_bvh_Hit();
                                                                    phi_2479_ = u32();
                                                                    phi_3317_ = false;
                                                                } else {
                                                                    let _e1950 = nodes.member[(0u + _e1507)].links[1u];
                                                                    let _e1955 = ((_e1135 + _e1950) + select(firstTrailingBit(_e1946), 32u, (_e1946 == 0u)));
                                                                    if (_e1955 < _e79) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1962 = triangles.member[(0u + _e1955)].v0_;
                                                                    let _e1964 = (_e1962.x - _e1058);
                                                                    let _e1966 = (_e1962.y - _e1071);
                                                                    let _e1968 = (_e1962.z - _e1084);
                                                                    if (_e1340 == 0u) {
                                                                        phi_2523_ = vec3<f32>(_e1966, _e1968, _e1964);
                                                                    } else {
                                                                        if (_e1340 == 1u) {
                                                                            phi_2522_ = vec3<f32>(_e1968, _e1964, _e1966);
                                                                        } else {
                                                                            phi_2522_ = (_e1962 - vec3<f32>(_e1058, _e1071, _e1084));
                                                                        }
                                                                        let _e1976 = phi_2522_;
                                                                        phi_2523_ = _e1976;
                                                                    }
                                                                    let _e1978 = phi_2523_;
                                                                    let _e1982 = (_e1978.x - (_e1351 * _e1978.z));
                                                                    let _e1986 = (_e1978.y - (_e1354 * _e1978.z));
                                                                    let _e1988 = triangles.member[(0u + _e1955)].v1_;
                                                                    let _e1990 = (_e1988.x - _e1058);
                                                                    let _e1992 = (_e1988.y - _e1071);
                                                                    let _e1994 = (_e1988.z - _e1084);
                                                                    if (_e1340 == 0u) {
                                                                        phi_2553_ = vec3<f32>(_e1992, _e1994, _e1990);
                                                                    } else {
                                                                        if (_e1340 == 1u) {
                                                                            phi_2552_ = vec3<f32>(_e1994, _e1990, _e1992);
                                                                        } else {
                                                                            phi_2552_ = (_e1988 - vec3<f32>(_e1058, _e1071, _e1084));
                                                                        }
                                                                        let _e2002 = phi_2552_;
                                                                        phi_2553_ = _e2002;
                                                                    }
                                                                    let _e2004 = phi_2553_;
                                                                    let _e2008 = (_e2004.x - (_e1351 * _e2004.z));
                                                                    let _e2012 = (_e2004.y - (_e1354 * _e2004.z));
                                                                    let _e2014 = triangles.member[(0u + _e1955)].v2_;
                                                                    let _e2016 = (_e2014.x - _e1058);
                                                                    let _e2018 = (_e2014.y - _e1071);
                                                                    let _e2020 = (_e2014.z - _e1084);
                                                                    if (_e1340 == 0u) {
                                                                        phi_2583_ = vec3<f32>(_e2018, _e2020, _e2016);
                                                                    } else {
                                                                        if (_e1340 == 1u) {
                                                                            phi_2582_ = vec3<f32>(_e2020, _e2016, _e2018);
                                                                        } else {
                                                                            phi_2582_ = (_e2014 - vec3<f32>(_e1058, _e1071, _e1084));
                                                                        }
                                                                        let _e2028 = phi_2582_;
                                                                        phi_2583_ = _e2028;
                                                                    }
                                                                    let _e2030 = phi_2583_;
                                                                    let _e2034 = (_e2030.x - (_e1351 * _e2030.z));
                                                                    let _e2038 = (_e2030.y - (_e1354 * _e2030.z));
                                                                    if (_e2008 < _e2034) {
                                                                        phi_2602_ = true;
                                                                    } else {
                                                                        if (_e2008 == _e2034) {
                                                                            phi_2601_ = (_e2012 < _e2038);
                                                                        } else {
                                                                            phi_2601_ = false;
                                                                        }
                                                                        let _e2043 = phi_2601_;
                                                                        phi_2602_ = _e2043;
                                                                    }
                                                                    let _e2045 = phi_2602_;
                                                                    if _e2045 {
                                                                        phi_2606_ = _e2038;
                                                                        phi_2607_ = _e2034;
                                                                        phi_2608_ = _e2012;
                                                                        phi_2609_ = _e2008;
                                                                    } else {
                                                                        phi_2606_ = _e2012;
                                                                        phi_2607_ = _e2008;
                                                                        phi_2608_ = _e2038;
                                                                        phi_2609_ = _e2034;
                                                                    }
                                                                    let _e2047 = phi_2606_;
                                                                    let _e2049 = phi_2607_;
                                                                    let _e2051 = phi_2608_;
                                                                    let _e2053 = phi_2609_;
                                                                    let _e2056 = ((_e2053 * _e2047) - (_e2051 * _e2049));
                                                                    if _e2045 {
                                                                        phi_2617_ = -(_e2056);
                                                                    } else {
                                                                        phi_2617_ = _e2056;
                                                                    }
                                                                    let _e2059 = phi_2617_;
                                                                    if (_e2034 < _e1982) {
                                                                        phi_2628_ = true;
                                                                    } else {
                                                                        if (_e2034 == _e1982) {
                                                                            phi_2627_ = (_e2038 < _e1986);
                                                                        } else {
                                                                            phi_2627_ = false;
                                                                        }
                                                                        let _e2064 = phi_2627_;
                                                                        phi_2628_ = _e2064;
                                                                    }
                                                                    let _e2066 = phi_2628_;
                                                                    if _e2066 {
                                                                        phi_2632_ = _e1986;
                                                                        phi_2633_ = _e1982;
                                                                        phi_2634_ = _e2038;
                                                                        phi_2635_ = _e2034;
                                                                    } else {
                                                                        phi_2632_ = _e2038;
                                                                        phi_2633_ = _e2034;
                                                                        phi_2634_ = _e1986;
                                                                        phi_2635_ = _e1982;
                                                                    }
                                                                    let _e2068 = phi_2632_;
                                                                    let _e2070 = phi_2633_;
                                                                    let _e2072 = phi_2634_;
                                                                    let _e2074 = phi_2635_;
                                                                    let _e2077 = ((_e2074 * _e2068) - (_e2072 * _e2070));
                                                                    if _e2066 {
                                                                        phi_2643_ = -(_e2077);
                                                                    } else {
                                                                        phi_2643_ = _e2077;
                                                                    }
                                                                    let _e2080 = phi_2643_;
                                                                    if (_e1982 < _e2008) {
                                                                        phi_2654_ = true;
                                                                    } else {
                                                                        if (_e1982 == _e2008) {
                                                                            phi_2653_ = (_e1986 < _e2012);
                                                                        } else {
                                                                            phi_2653_ = false;
                                                                        }
                                                                        let _e2085 = phi_2653_;
                                                                        phi_2654_ = _e2085;
                                                                    }
                                                                    let _e2087 = phi_2654_;
                                                                    if _e2087 {
                                                                        phi_2658_ = _e2012;
                                                                        phi_2659_ = _e2008;
                                                                        phi_2660_ = _e1986;
                                                                        phi_2661_ = _e1982;
                                                                    } else {
                                                                        phi_2658_ = _e1986;
                                                                        phi_2659_ = _e1982;
                                                                        phi_2660_ = _e2012;
                                                                        phi_2661_ = _e2008;
                                                                    }
                                                                    let _e2089 = phi_2658_;
                                                                    let _e2091 = phi_2659_;
                                                                    let _e2093 = phi_2660_;
                                                                    let _e2095 = phi_2661_;
                                                                    let _e2098 = ((_e2095 * _e2089) - (_e2093 * _e2091));
                                                                    if _e2087 {
                                                                        phi_2669_ = -(_e2098);
                                                                    } else {
                                                                        phi_2669_ = _e2098;
                                                                    }
                                                                    let _e2101 = phi_2669_;
                                                                    if (_e2059 >= 0f) {
                                                                        if (_e2080 >= 0f) {
                                                                            if (_e2101 >= 0f) {
                                                                                phi_2684_ = ((_e2059 + _e2080) + _e2101);
                                                                                phi_2685_ = false;
                                                                            } else {
                                                                                phi_2684_ = f32();
                                                                                phi_2685_ = true;
                                                                            }
                                                                            let _e2108 = phi_2684_;
                                                                            let _e2110 = phi_2685_;
                                                                            phi_2686_ = _e2108;
                                                                            phi_2687_ = _e2110;
                                                                        } else {
                                                                            phi_2686_ = f32();
                                                                            phi_2687_ = true;
                                                                        }
                                                                        let _e2112 = phi_2686_;
                                                                        let _e2114 = phi_2687_;
                                                                        phi_2688_ = _e2112;
                                                                        phi_2689_ = _e2114;
                                                                    } else {
                                                                        phi_2688_ = f32();
                                                                        phi_2689_ = true;
                                                                    }
                                                                    let _e2116 = phi_2688_;
                                                                    let _e2118 = phi_2689_;
                                                                    if _e2118 {
                                                                        if (_e2059 <= 0f) {
                                                                            if (_e2080 <= 0f) {
                                                                                let _e2121 = (_e2101 <= 0f);
                                                                                if _e2121 {
                                                                                }
                                                                                phi_2707_ = ((_e2059 + _e2080) + _e2101);
                                                                                phi_2708_ = false;
                                                                                phi_2709_ = _e2121;
                                                                            } else {
                                                                                phi_2707_ = f32();
                                                                                phi_2708_ = true;
                                                                                phi_2709_ = false;
                                                                            }
                                                                            let _e2125 = phi_2707_;
                                                                            let _e2127 = phi_2708_;
                                                                            let _e2129 = phi_2709_;
                                                                            phi_2710_ = _e2125;
                                                                            phi_2711_ = _e2127;
                                                                            phi_2712_ = _e2129;
                                                                        } else {
                                                                            phi_2710_ = f32();
                                                                            phi_2711_ = true;
                                                                            phi_2712_ = false;
                                                                        }
                                                                        let _e2131 = phi_2710_;
                                                                        let _e2133 = phi_2711_;
                                                                        let _e2135 = phi_2712_;
                                                                        if _e2133 {
                                                                            phi_2716_ = false;
                                                                        } else {
                                                                            phi_2716_ = _e2135;
                                                                        }
                                                                        let _e2137 = phi_2716_;
                                                                        phi_2717_ = _e2131;
                                                                        phi_2718_ = _e2137;
                                                                    } else {
                                                                        phi_2717_ = _e2116;
                                                                        phi_2718_ = true;
                                                                    }
                                                                    let _e2139 = phi_2717_;
                                                                    let _e2141 = phi_2718_;
                                                                    if _e2141 {
                                                                        let _e2142 = (_e2139 == 0f);
                                                                        if _e2142 {
                                                                            phi_3034_ = lt_bvh_triangle_Intersection();
                                                                            phi_3035_ = false;
                                                                        } else {
                                                                            let _e2144 = triangles.member[(0u + _e1955)].v0_;
                                                                            let _e2146 = (_e2144.x - _e1058);
                                                                            let _e2148 = (_e2144.y - _e1071);
                                                                            let _e2150 = (_e2144.z - _e1084);
                                                                            if (_e1340 == 0u) {
                                                                                phi_2747_ = vec3<f32>(_e2148, _e2150, _e2146);
                                                                            } else {
                                                                                if (_e1340 == 1u) {
                                                                                    phi_2746_ = vec3<f32>(_e2150, _e2146, _e2148);
                                                                                } else {
                                                                                    phi_2746_ = (_e2144 - vec3<f32>(_e1058, _e1071, _e1084));
                                                                                }
                                                                                let _e2158 = phi_2746_;
                                                                                phi_2747_ = _e2158;
                                                                            }
                                                                            let _e2160 = phi_2747_;
                                                                            let _e2162 = triangles.member[(0u + _e1955)].v1_;
                                                                            let _e2164 = triangles.member[(0u + _e1955)].v0_;
                                                                            let _e2167 = (_e2162.x - _e2164.x);
                                                                            let _e2170 = (_e2162.y - _e2164.y);
                                                                            let _e2173 = (_e2162.z - _e2164.z);
                                                                            if (_e1340 == 0u) {
                                                                                phi_2773_ = vec3<f32>(_e2170, _e2173, _e2167);
                                                                            } else {
                                                                                if (_e1340 == 1u) {
                                                                                    phi_2772_ = vec3<f32>(_e2173, _e2167, _e2170);
                                                                                } else {
                                                                                    phi_2772_ = (_e2162 - _e2164);
                                                                                }
                                                                                let _e2180 = phi_2772_;
                                                                                phi_2773_ = _e2180;
                                                                            }
                                                                            let _e2182 = phi_2773_;
                                                                            let _e2184 = triangles.member[(0u + _e1955)].v2_;
                                                                            let _e2186 = triangles.member[(0u + _e1955)].v0_;
                                                                            let _e2189 = (_e2184.x - _e2186.x);
                                                                            let _e2192 = (_e2184.y - _e2186.y);
                                                                            let _e2195 = (_e2184.z - _e2186.z);
                                                                            if (_e1340 == 0u) {
                                                                                phi_2799_ = vec3<f32>(_e2192, _e2195, _e2189);
                                                                            } else {
                                                                                if (_e1340 == 1u) {
                                                                                    phi_2798_ = vec3<f32>(_e2195, _e2189, _e2192);
                                                                                } else {
                                                                                    phi_2798_ = (_e2184 - _e2186);
                                                                                }
                                                                                let _e2202 = phi_2798_;
                                                                                phi_2799_ = _e2202;
                                                                            }
                                                                            let _e2204 = phi_2799_;
                                                                            let _e2211 = ((_e2182.y * _e2204.z) - (_e2182.z * _e2204.y));
                                                                            let _e2218 = ((_e2182.z * _e2204.x) - (_e2182.x * _e2204.z));
                                                                            let _e2225 = ((_e2182.x * _e2204.y) - (_e2182.y * _e2204.x));
                                                                            let _e2239 = (((1f / _e1348.z) * (((_e2211 * _e2160.x) + (_e2218 * _e2160.y)) + (_e2225 * _e2160.z))) / (((_e2211 * _e1351) + (_e2218 * _e1354)) + _e2225));
                                                                            if (_e2239 > _e157.tmin) {
                                                                                if (_e2239 < _e157.tmax) {
                                                                                    let _e2243 = triangles.member[(0u + _e1955)].v0_;
                                                                                    let _e2245 = triangles.member[(0u + _e1955)].v1_;
                                                                                    if (_e2243.x < _e2245.x) {
                                                                                        phi_2855_ = _e2243.x;
                                                                                    } else {
                                                                                        phi_2855_ = _e2245.x;
                                                                                    }
                                                                                    let _e2252 = phi_2855_;
                                                                                    if (_e2243.y < _e2245.y) {
                                                                                        phi_2864_ = _e2243.y;
                                                                                    } else {
                                                                                        phi_2864_ = _e2245.y;
                                                                                    }
                                                                                    let _e2259 = phi_2864_;
                                                                                    if (_e2243.z < _e2245.z) {
                                                                                        phi_2873_ = _e2243.z;
                                                                                    } else {
                                                                                        phi_2873_ = _e2245.z;
                                                                                    }
                                                                                    let _e2266 = phi_2873_;
                                                                                    let _e2268 = triangles.member[(0u + _e1955)].v2_;
                                                                                    if (_e2252 < _e2268.x) {
                                                                                        phi_2882_ = _e2252;
                                                                                    } else {
                                                                                        phi_2882_ = _e2268.x;
                                                                                    }
                                                                                    let _e2273 = phi_2882_;
                                                                                    if (_e2259 < _e2268.y) {
                                                                                        phi_2889_ = _e2259;
                                                                                    } else {
                                                                                        phi_2889_ = _e2268.y;
                                                                                    }
                                                                                    let _e2278 = phi_2889_;
                                                                                    if (_e2266 < _e2268.z) {
                                                                                        phi_2896_ = _e2266;
                                                                                    } else {
                                                                                        phi_2896_ = _e2268.z;
                                                                                    }
                                                                                    let _e2283 = phi_2896_;
                                                                                    let _e2285 = triangles.member[(0u + _e1955)].v0_;
                                                                                    let _e2287 = triangles.member[(0u + _e1955)].v1_;
                                                                                    if (_e2285.x > _e2287.x) {
                                                                                        phi_2909_ = _e2285.x;
                                                                                    } else {
                                                                                        phi_2909_ = _e2287.x;
                                                                                    }
                                                                                    let _e2294 = phi_2909_;
                                                                                    if (_e2285.y > _e2287.y) {
                                                                                        phi_2918_ = _e2285.y;
                                                                                    } else {
                                                                                        phi_2918_ = _e2287.y;
                                                                                    }
                                                                                    let _e2301 = phi_2918_;
                                                                                    if (_e2285.z > _e2287.z) {
                                                                                        phi_2927_ = _e2285.z;
                                                                                    } else {
                                                                                        phi_2927_ = _e2287.z;
                                                                                    }
                                                                                    let _e2308 = phi_2927_;
                                                                                    let _e2310 = triangles.member[(0u + _e1955)].v2_;
                                                                                    if (_e2294 > _e2310.x) {
                                                                                        phi_2936_ = _e2294;
                                                                                    } else {
                                                                                        phi_2936_ = _e2310.x;
                                                                                    }
                                                                                    let _e2315 = phi_2936_;
                                                                                    if (_e2301 > _e2310.y) {
                                                                                        phi_2943_ = _e2301;
                                                                                    } else {
                                                                                        phi_2943_ = _e2310.y;
                                                                                    }
                                                                                    let _e2320 = phi_2943_;
                                                                                    if (_e2308 > _e2310.z) {
                                                                                        phi_2950_ = _e2308;
                                                                                    } else {
                                                                                        phi_2950_ = _e2310.z;
                                                                                    }
                                                                                    let _e2325 = phi_2950_;
                                                                                    let _e2329 = ((_e2273 - _e1058) * _e1265);
                                                                                    let _e2330 = ((_e2278 - _e1071) * _e1275);
                                                                                    let _e2331 = ((_e2283 - _e1084) * _e1285);
                                                                                    let _e2335 = ((_e2315 - _e1058) * _e1265);
                                                                                    let _e2336 = ((_e2320 - _e1071) * _e1275);
                                                                                    let _e2337 = ((_e2325 - _e1084) * _e1285);
                                                                                    if (_e2329 < _e2335) {
                                                                                        phi_2967_ = _e2329;
                                                                                    } else {
                                                                                        phi_2967_ = _e2335;
                                                                                    }
                                                                                    let _e2340 = phi_2967_;
                                                                                    if (_e2330 < _e2336) {
                                                                                        phi_2972_ = _e2330;
                                                                                    } else {
                                                                                        phi_2972_ = _e2336;
                                                                                    }
                                                                                    let _e2343 = phi_2972_;
                                                                                    if (_e2331 < _e2337) {
                                                                                        phi_2977_ = _e2331;
                                                                                    } else {
                                                                                        phi_2977_ = _e2337;
                                                                                    }
                                                                                    let _e2346 = phi_2977_;
                                                                                    if (_e2329 > _e2335) {
                                                                                        phi_2985_ = _e2329;
                                                                                    } else {
                                                                                        phi_2985_ = _e2335;
                                                                                    }
                                                                                    let _e2352 = phi_2985_;
                                                                                    if (_e2330 > _e2336) {
                                                                                        phi_2990_ = _e2330;
                                                                                    } else {
                                                                                        phi_2990_ = _e2336;
                                                                                    }
                                                                                    let _e2355 = phi_2990_;
                                                                                    if (_e2331 > _e2337) {
                                                                                        phi_2995_ = _e2331;
                                                                                    } else {
                                                                                        phi_2995_ = _e2337;
                                                                                    }
                                                                                    let _e2358 = phi_2995_;
                                                                                    let _e2362 = core_intrinsics_maximum_number_nsz_f32_((_e2340 - _e1324), (_e2343 - _e1325));
                                                                                    let _e2363 = core_intrinsics_maximum_number_nsz_f32_(_e2362, (_e2346 - _e1326));
                                                                                    let _e2364 = core_intrinsics_minimum_number_nsz_f32_((_e2352 + _e1324), (_e2355 + _e1325));
                                                                                    let _e2365 = core_intrinsics_minimum_number_nsz_f32_(_e2364, (_e2358 + _e1326));
                                                                                    if (_e2363 > _e1033) {
                                                                                        phi_3007_ = _e2363;
                                                                                    } else {
                                                                                        phi_3007_ = _e1033;
                                                                                    }
                                                                                    let _e2368 = phi_3007_;
                                                                                    if (_e2365 < _e1035) {
                                                                                        phi_3012_ = _e2365;
                                                                                    } else {
                                                                                        phi_3012_ = _e1035;
                                                                                    }
                                                                                    let _e2371 = phi_3012_;
                                                                                    if (_e2239 < _e2368) {
                                                                                        phi_3017_ = _e2368;
                                                                                    } else {
                                                                                        phi_3017_ = _e2239;
                                                                                    }
                                                                                    let _e2374 = phi_3017_;
                                                                                    if (_e2374 > _e2371) {
                                                                                        phi_3022_ = _e2371;
                                                                                    } else {
                                                                                        phi_3022_ = _e2374;
                                                                                    }
                                                                                    let _e2377 = phi_3022_;
                                                                                    phi_3027_ = lt_bvh_triangle_Intersection(_e2377, (_e2080 / _e2139), (_e2101 / _e2139), (_e2368 <= _e2371));
                                                                                    phi_3028_ = false;
                                                                                } else {
                                                                                    phi_3027_ = lt_bvh_triangle_Intersection();
                                                                                    phi_3028_ = true;
                                                                                }
                                                                                let _e2383 = phi_3027_;
                                                                                let _e2385 = phi_3028_;
                                                                                phi_3029_ = _e2383;
                                                                                phi_3030_ = _e2385;
                                                                            } else {
                                                                                phi_3029_ = lt_bvh_triangle_Intersection();
                                                                                phi_3030_ = true;
                                                                            }
                                                                            let _e2387 = phi_3029_;
                                                                            let _e2389 = phi_3030_;
                                                                            if _e2389 {
                                                                            }
                                                                            phi_3034_ = _e2387;
                                                                            phi_3035_ = _e2389;
                                                                        }
                                                                        let _e2391 = phi_3034_;
                                                                        let _e2393 = phi_3035_;
                                                                        phi_3036_ = _e2391;
                                                                        phi_3037_ = _e2142;
                                                                        phi_3038_ = _e2393;
                                                                    } else {
                                                                        phi_3036_ = lt_bvh_triangle_Intersection();
                                                                        phi_3037_ = true;
                                                                        phi_3038_ = false;
                                                                    }
                                                                    let _e2395 = phi_3036_;
                                                                    let _e2397 = phi_3037_;
                                                                    let _e2399 = phi_3038_;
                                                                    if _e2397 {
                                                                        phi_3042_ = true;
                                                                    } else {
                                                                        phi_3042_ = _e2399;
                                                                    }
                                                                    let _e2401 = phi_3042_;
                                                                    if _e2401 {
                                                                        phi_3046_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_3046_ = _e2395;
                                                                    }
                                                                    let _e2403 = phi_3046_;
                                                                    if _e2403.is_hit {
                                                                        if (_e2403.t > _e157.tmin) {
                                                                            if (_e2403.t < _e1944.t) {
                                                                                phi_3094_ = true;
                                                                            } else {
                                                                                if (_e2403.t == _e1944.t) {
                                                                                    if (_e1944.triangle != 4294967295u) {
                                                                                        if (_e1955 < _e1944.triangle) {
                                                                                            phi_3085_ = true;
                                                                                        } else {
                                                                                            if (_e1955 == _e1944.triangle) {
                                                                                                phi_3084_ = (_e974 < _e1944.instance);
                                                                                            } else {
                                                                                                phi_3084_ = false;
                                                                                            }
                                                                                            let _e2421 = phi_3084_;
                                                                                            phi_3085_ = _e2421;
                                                                                        }
                                                                                        let _e2423 = phi_3085_;
                                                                                        phi_3086_ = _e2423;
                                                                                        phi_3087_ = false;
                                                                                    } else {
                                                                                        phi_3086_ = bool();
                                                                                        phi_3087_ = true;
                                                                                    }
                                                                                    let _e2425 = phi_3086_;
                                                                                    let _e2427 = phi_3087_;
                                                                                    phi_3088_ = _e2425;
                                                                                    phi_3089_ = _e2427;
                                                                                } else {
                                                                                    phi_3088_ = bool();
                                                                                    phi_3089_ = true;
                                                                                }
                                                                                let _e2429 = phi_3088_;
                                                                                let _e2431 = phi_3089_;
                                                                                if _e2431 {
                                                                                    phi_3093_ = false;
                                                                                } else {
                                                                                    phi_3093_ = _e2429;
                                                                                }
                                                                                let _e2433 = phi_3093_;
                                                                                phi_3094_ = _e2433;
                                                                            }
                                                                            let _e2435 = phi_3094_;
                                                                            if _e2435 {
                                                                                let _e2437 = triangles.member[(0u + _e1955)].i0_;
                                                                                if ((_e2437 & 2147483648u) == 0u) {
                                                                                    phi_3305_ = true;
                                                                                } else {
                                                                                    if (_e1955 < _e79) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2446 = triangles.member[(0u + _e1955)].i0_;
                                                                                    let _e2447 = (_e2446 & 2147483647u);
                                                                                    let _e2449 = triangles.member[(0u + _e1955)].i1_;
                                                                                    let _e2451 = triangles.member[(0u + _e1955)].i2_;
                                                                                    if (_e2447 < _e82) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2455 = vertices.member[(0u + _e2447)];
                                                                                    if (_e2449 < _e82) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2459 = vertices.member[(0u + _e2449)];
                                                                                    if (_e2451 < _e82) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2463 = vertices.member[(0u + _e2451)];
                                                                                    let _e2464 = array<abi_Vertex, 3>(_e2455, _e2459, _e2463);
                                                                                    if (_e2464[0].material < _e85) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2470 = materials.member[(0u + _e2464[0].material)];
                                                                                    if ((_e2470.flags & 0u) == 0u) {
                                                                                        let _e2475 = ((1f - _e2403.u) - _e2403.v);
                                                                                        if (_e2470.cutoff <= 0f) {
                                                                                            phi_3300_ = true;
                                                                                        } else {
                                                                                            let _e2502 = (_e2470.base_color.w * ((((f32((_e2464[0].color >> bitcast<u32>(24i))) * _e2475) + (f32((_e2464[1].color >> bitcast<u32>(24i))) * _e2403.u)) + (f32((_e2464[2].color >> bitcast<u32>(24i))) * _e2403.v)) * (1f / 255f)));
                                                                                            if (_e2470.alpha_size == 0u) {
                                                                                                phi_3297_ = _e2502;
                                                                                            } else {
                                                                                                local.offset = _e2470.alpha_offset;
                                                                                                local.size = _e2470.alpha_size;
                                                                                                local.flags = _e2470.flags;
                                                                                                let _e2533 = _lt_shaders_texture_TextureView_quad((&local), (((_e2464[0].u * _e2475) + (_e2464[1].u * _e2403.u)) + (_e2464[2].u * _e2403.v)), (((_e2464[0].v * _e2475) + (_e2464[1].v * _e2403.u)) + (_e2464[2].v * _e2403.v)));
                                                                                                let _e2537 = (_e2533.indices[0] >> bitcast<u32>(2i));
                                                                                                if (_e2537 < _e94) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2541 = alpha_texels.member[(0u + _e2537)];
                                                                                                let _e2557 = (_e2533.indices[1] >> bitcast<u32>(2i));
                                                                                                if (_e2557 < _e94) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2561 = alpha_texels.member[(0u + _e2557)];
                                                                                                let _e2578 = (_e2533.indices[2] >> bitcast<u32>(2i));
                                                                                                if (_e2578 < _e94) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2582 = alpha_texels.member[(0u + _e2578)];
                                                                                                let _e2599 = (_e2533.indices[3] >> bitcast<u32>(2i));
                                                                                                if (_e2599 < _e94) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2603 = alpha_texels.member[(0u + _e2599)];
                                                                                                phi_3297_ = (_e2502 * (((((f32(((_e2541 >> bitcast<u32>((((_e2533.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2533.weights.x) + ((f32(((_e2561 >> bitcast<u32>((((_e2533.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2533.weights.y)) + ((f32(((_e2582 >> bitcast<u32>((((_e2533.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2533.weights.z)) + ((f32(((_e2603 >> bitcast<u32>((((_e2533.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2533.weights.w)));
                                                                                            }
                                                                                            let _e2619 = phi_3297_;
                                                                                            phi_3300_ = (_e2619 >= _e2470.cutoff);
                                                                                        }
                                                                                        let _e2623 = phi_3300_;
                                                                                        phi_3301_ = _e2623;
                                                                                    } else {
                                                                                        phi_3301_ = false;
                                                                                    }
                                                                                    let _e2625 = phi_3301_;
                                                                                    if _e2625 {
                                                                                    }
                                                                                    phi_3305_ = _e2625;
                                                                                }
                                                                                let _e2627 = phi_3305_;
                                                                                if _e2627 {
                                                                                    phi_3313_ = lt_bvh_Hit(_e2403.t, _e2403.u, _e2403.v, _e1955, _e974);
                                                                                } else {
                                                                                    phi_3313_ = _e1944;
                                                                                }
                                                                                let _e2633 = phi_3313_;
                                                                                phi_3314_ = _e2633;
                                                                            } else {
                                                                                phi_3314_ = _e1944;
                                                                            }
                                                                            let _e2635 = phi_3314_;
                                                                            phi_3315_ = _e2635;
                                                                        } else {
                                                                            phi_3315_ = _e1944;
                                                                        }
                                                                        let _e2637 = phi_3315_;
                                                                        phi_3316_ = _e2637;
                                                                    } else {
                                                                        phi_3316_ = _e1944;
                                                                    }
                                                                    let _e2639 = phi_3316_;
                                                                    phi_2476_ = _e2639;
                                                                    phi_2479_ = (_e1946 & (_e1946 - 1u));
                                                                    phi_3317_ = true;
                                                                }
                                                                let _e2641 = phi_2476_;
                                                                let _e2643 = phi_2479_;
                                                                let _e2645 = phi_3317_;
                                                                continue;
                                                                continuing {
                                                                    phi_2475_ = _e2641;
                                                                    phi_2478_ = _e2643;
                                                                    break if !(_e2645);
                                                                }
                                                            }
                                                            let _e2648 = local_1.group_mask;
                                                            if ((_e2648 & 4278190080u) == 0u) {
                                                                let _e2652 = local_1.len;
                                                                if (_e2652 == 0u) {
                                                                    phi_3356_ = false;
                                                                } else {
                                                                    let _e2656 = local_1.len;
                                                                    local_1.len = (_e2656 - 1u);
                                                                    let _e2659 = local_1.len;
                                                                    if (_e2659 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2664 = local_1.first[(0u + _e2659)];
                                                                    local_1.group = _e2664;
                                                                    let _e2667 = local_1.len;
                                                                    if (_e2667 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2672 = local_1.mask[(0u + _e2667)];
                                                                    local_1.group_mask = _e2672;
                                                                    phi_3356_ = true;
                                                                }
                                                                let _e2675 = phi_3356_;
                                                                phi_3357_ = _e2675;
                                                            } else {
                                                                phi_3357_ = true;
                                                            }
                                                            let _e2677 = phi_3357_;
                                                            if _e2677 {
                                                                let _e2679 = local_1.group_mask;
                                                                let _e2685 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2679)), 32u, (_e2679 == 0u)));
                                                                let _e2689 = local_1.group_mask;
                                                                let _e2703 = local_1.group_mask;
                                                                local_1.group_mask = (_e2703 & ~((1u << bitcast<u32>((_e2685 & 31u)))));
                                                                let _e2706 = local_1.group;
                                                                phi_3388_ = (_e2706 + countOneBits(((_e2689 & ~((4294967295u << bitcast<u32>((((_e2685 - 24u) ^ _e1367) & 31u))))) & 255u)));
                                                            } else {
                                                                phi_3388_ = 4294967295u;
                                                            }
                                                            let _e2709 = phi_3388_;
                                                            let _e3694 = local_9;
                                                            phi_2143_ = _e3694;
                                                            phi_2146_ = _e2709;
                                                        } else {
                                                            phi_2143_ = lt_bvh_Hit();
                                                            phi_2146_ = u32();
                                                        }
                                                        let _e2711 = phi_2143_;
                                                        let _e2713 = phi_2146_;
                                                        continue;
                                                        continuing {
                                                            phi_2142_ = _e2711;
                                                            phi_2145_ = _e2713;
                                                            break if !(_e1508);
                                                        }
                                                    }
                                                    let _e3698 = local_10;
                                                    phi_3389_ = _e3698;
                                                }
                                                let _e2716 = phi_3389_;
                                                phi_3390_ = _e2716;
                                                phi_3391_ = _e1189;
                                            } else {
                                                phi_3390_ = lt_bvh_Hit();
                                                phi_3391_ = true;
                                            }
                                            let _e2718 = phi_3390_;
                                            let _e2720 = phi_3391_;
                                            if _e2720 {
                                                phi_3395_ = _e966;
                                            } else {
                                                phi_3395_ = _e2718;
                                            }
                                            let _e2722 = phi_3395_;
                                            phi_3396_ = _e2722;
                                        } else {
                                            phi_3396_ = _e966;
                                        }
                                        let _e2724 = phi_3396_;
                                        phi_3397_ = _e2724;
                                    } else {
                                        phi_3397_ = _e966;
                                    }
                                    let _e2726 = phi_3397_;
                                    phi_3398_ = _e2726;
                                } else {
                                    phi_3398_ = _e966;
                                }
                                let _e2728 = phi_3398_;
                                phi_1510_ = (_e964 & (_e964 - 1u));
                                phi_1513_ = _e2728;
                                phi_3399_ = true;
                            }
                            let _e2730 = phi_1510_;
                            let _e2732 = phi_1513_;
                            let _e2734 = phi_3399_;
                            continue;
                            continuing {
                                phi_1509_ = _e2730;
                                phi_1512_ = _e2732;
                                break if !(_e2734);
                            }
                        }
                        let _e2737 = local_2.group_mask;
                        if ((_e2737 & 4278190080u) == 0u) {
                            let _e2741 = local_2.len;
                            if (_e2741 == 0u) {
                                phi_3438_ = false;
                            } else {
                                let _e2745 = local_2.len;
                                local_2.len = (_e2745 - 1u);
                                let _e2748 = local_2.len;
                                if (_e2748 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2753 = local_2.first[(0u + _e2748)];
                                local_2.group = _e2753;
                                let _e2756 = local_2.len;
                                if (_e2756 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2761 = local_2.mask[(0u + _e2756)];
                                local_2.group_mask = _e2761;
                                phi_3438_ = true;
                            }
                            let _e2764 = phi_3438_;
                            phi_3439_ = _e2764;
                        } else {
                            phi_3439_ = true;
                        }
                        let _e2766 = phi_3439_;
                        if _e2766 {
                            let _e2768 = local_2.group_mask;
                            let _e2774 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2768)), 32u, (_e2768 == 0u)));
                            let _e2778 = local_2.group_mask;
                            let _e2792 = local_2.group_mask;
                            local_2.group_mask = (_e2792 & ~((1u << bitcast<u32>((_e2774 & 31u)))));
                            let _e2795 = local_2.group;
                            phi_3470_ = (_e2795 + countOneBits(((_e2778 & ~((4294967295u << bitcast<u32>((((_e2774 - 24u) ^ _e383) & 31u))))) & 255u)));
                        } else {
                            phi_3470_ = 4294967295u;
                        }
                        let _e2798 = phi_3470_;
                        phi_1173_ = _e2798;
                        let _e3714 = local_11;
                        phi_1176_ = _e3714;
                    } else {
                        phi_1173_ = u32();
                        phi_1176_ = lt_bvh_Hit();
                    }
                    let _e2800 = phi_1173_;
                    let _e2802 = phi_1176_;
                    continue;
                    continuing {
                        phi_1172_ = _e2800;
                        phi_1175_ = _e2802;
                        break if !(_e524);
                    }
                }
                let _e3717 = local_12;
                phi_3471_ = _e3717;
            }
            let _e2805 = phi_3471_;
            phi_3472_ = _e2805;
            phi_3473_ = _e221;
        } else {
            phi_3472_ = lt_bvh_Hit();
            phi_3473_ = true;
        }
        let _e2807 = phi_3472_;
        let _e2809 = phi_3473_;
        if _e2809 {
            phi_3477_ = _e159;
        } else {
            phi_3477_ = _e2807;
        }
        let _e2811 = phi_3477_;
        if (_e2811.triangle != 4294967295u) {
            let _e2817 = ((1f - _e2811.u) - _e2811.v);
            if (_e2811.triangle < _e79) {
            } else {
                return;
            }
            let _e2823 = triangles.member[(0u + _e2811.triangle)];
            if (_e2811.instance < _e91) {
            } else {
                return;
            }
            let _e2834 = instances.member[(0u + _e2811.instance)].object_to_world[0u];
            let _e2845 = ((((_e2834.x * _e2823.v0_.x) + (_e2834.y * _e2823.v0_.y)) + (_e2834.z * _e2823.v0_.z)) + (_e2834.w * 1f));
            let _e2847 = instances.member[(0u + _e2811.instance)].object_to_world[1u];
            let _e2858 = ((((_e2847.x * _e2823.v0_.x) + (_e2847.y * _e2823.v0_.y)) + (_e2847.z * _e2823.v0_.z)) + (_e2847.w * 1f));
            let _e2860 = instances.member[(0u + _e2811.instance)].object_to_world[2u];
            let _e2871 = ((((_e2860.x * _e2823.v0_.x) + (_e2860.y * _e2823.v0_.y)) + (_e2860.z * _e2823.v0_.z)) + (_e2860.w * 1f));
            let _e2878 = instances.member[(0u + _e2811.instance)].object_to_world[0u];
            let _e2889 = ((((_e2878.x * _e2823.v1_.x) + (_e2878.y * _e2823.v1_.y)) + (_e2878.z * _e2823.v1_.z)) + (_e2878.w * 1f));
            let _e2891 = instances.member[(0u + _e2811.instance)].object_to_world[1u];
            let _e2902 = ((((_e2891.x * _e2823.v1_.x) + (_e2891.y * _e2823.v1_.y)) + (_e2891.z * _e2823.v1_.z)) + (_e2891.w * 1f));
            let _e2904 = instances.member[(0u + _e2811.instance)].object_to_world[2u];
            let _e2915 = ((((_e2904.x * _e2823.v1_.x) + (_e2904.y * _e2823.v1_.y)) + (_e2904.z * _e2823.v1_.z)) + (_e2904.w * 1f));
            let _e2922 = instances.member[(0u + _e2811.instance)].object_to_world[0u];
            let _e2933 = ((((_e2922.x * _e2823.v2_.x) + (_e2922.y * _e2823.v2_.y)) + (_e2922.z * _e2823.v2_.z)) + (_e2922.w * 1f));
            let _e2935 = instances.member[(0u + _e2811.instance)].object_to_world[1u];
            let _e2946 = ((((_e2935.x * _e2823.v2_.x) + (_e2935.y * _e2823.v2_.y)) + (_e2935.z * _e2823.v2_.z)) + (_e2935.w * 1f));
            let _e2948 = instances.member[(0u + _e2811.instance)].object_to_world[2u];
            let _e2959 = ((((_e2948.x * _e2823.v2_.x) + (_e2948.y * _e2823.v2_.y)) + (_e2948.z * _e2823.v2_.z)) + (_e2948.w * 1f));
            let _e2972 = (((_e2845 * _e2817) + (_e2889 * _e2811.u)) + (_e2933 * _e2811.v));
            let _e2973 = (((_e2858 * _e2817) + (_e2902 * _e2811.u)) + (_e2946 * _e2811.v));
            let _e2974 = (((_e2871 * _e2817) + (_e2915 * _e2811.u)) + (_e2959 * _e2811.v));
            let _e2976 = abs(_e2845);
            let _e2977 = abs(_e2858);
            let _e2978 = abs(_e2871);
            let _e2979 = abs(_e2889);
            let _e2980 = abs(_e2902);
            let _e2981 = abs(_e2915);
            if (_e2976 > _e2979) {
                phi_3665_ = _e2976;
            } else {
                phi_3665_ = _e2979;
            }
            let _e2984 = phi_3665_;
            if (_e2977 > _e2980) {
                phi_3670_ = _e2977;
            } else {
                phi_3670_ = _e2980;
            }
            let _e2987 = phi_3670_;
            if (_e2978 > _e2981) {
                phi_3675_ = _e2978;
            } else {
                phi_3675_ = _e2981;
            }
            let _e2990 = phi_3675_;
            let _e2991 = abs(_e2933);
            let _e2992 = abs(_e2946);
            let _e2993 = abs(_e2959);
            if (_e2984 > _e2991) {
                phi_3683_ = _e2984;
            } else {
                phi_3683_ = _e2991;
            }
            let _e2996 = phi_3683_;
            if (_e2987 > _e2992) {
                phi_3688_ = _e2987;
            } else {
                phi_3688_ = _e2992;
            }
            let _e2999 = phi_3688_;
            if (_e2990 > _e2993) {
                phi_3693_ = _e2990;
            } else {
                phi_3693_ = _e2993;
            }
            let _e3002 = phi_3693_;
            let _e3003 = (_e2889 - _e2845);
            let _e3004 = (_e2902 - _e2858);
            let _e3005 = (_e2915 - _e2871);
            let _e3006 = (_e2933 - _e2845);
            let _e3007 = (_e2946 - _e2858);
            let _e3008 = (_e2959 - _e2871);
            let _e3012 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3004), abs(_e3005));
            let _e3013 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3003), _e3012);
            let _e3014 = (_e3003 / _e3013);
            let _e3015 = (_e3004 / _e3013);
            let _e3016 = (_e3005 / _e3013);
            let _e3020 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3007), abs(_e3008));
            let _e3021 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3006), _e3020);
            let _e3022 = (_e3006 / _e3021);
            let _e3023 = (_e3007 / _e3021);
            let _e3024 = (_e3008 / _e3021);
            let _e3027 = ((_e3015 * _e3024) - (_e3023 * _e3016));
            let _e3030 = ((_e3016 * _e3022) - (_e3024 * _e3014));
            let _e3033 = ((_e3014 * _e3023) - (_e3022 * _e3015));
            let _e3035 = p.member.eye;
            let _e3048 = (1f / sqrt((((_e3027 * _e3027) + (_e3030 * _e3030)) + (_e3033 * _e3033))));
            let _e3049 = (_e3027 * _e3048);
            let _e3050 = (_e3030 * _e3048);
            let _e3051 = (_e3033 * _e3048);
            if ((((_e3049 * (_e3035.x - _e2972)) + (_e3050 * (_e3035.y - _e2973))) + (_e3051 * (_e3035.z - _e2974))) < 0f) {
                phi_3757_ = vec3<f32>(-(_e3049), -(_e3050), -(_e3051));
            } else {
                phi_3757_ = vec3<f32>(_e3049, _e3050, _e3051);
            }
            let _e3064 = phi_3757_;
            if (_e2811.triangle < _e79) {
            } else {
                return;
            }
            let _e3069 = triangles.member[(0u + _e2811.triangle)];
            let _e3071 = (_e3069.i0_ & 2147483647u);
            if (_e3071 < _e82) {
            } else {
                return;
            }
            let _e3077 = vertices.member[(0u + _e3071)];
            if (_e3069.i1_ < _e82) {
            } else {
                return;
            }
            let _e3081 = vertices.member[(0u + _e3069.i1_)];
            if (_e3069.i2_ < _e82) {
            } else {
                return;
            }
            let _e3085 = vertices.member[(0u + _e3069.i2_)];
            let _e3086 = array<abi_Vertex, 3>(_e3077, _e3081, _e3085);
            if (_e3086[0].material < _e85) {
            } else {
                return;
            }
            let _e3092 = materials.member[(0u + _e3086[0].material)];
            let _e3109 = (1f / 255f);
            let _e3128 = (1f / 255f);
            let _e3150 = (1f / 255f);
            let _e3163 = _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(vec3<f32>(_e2817, _e2811.u, _e2811.v));
            let _e3165 = ((_e3092.base_color.x * ((((f32((_e3086[0].color & 255u)) * _e3109) * _e2817) + ((f32((_e3086[1].color & 255u)) * _e3128) * _e2811.u)) + ((f32((_e3086[2].color & 255u)) * _e3150) * _e2811.v))) * _e3163.x);
            let _e3167 = ((_e3092.base_color.y * ((((f32(((_e3086[0].color >> bitcast<u32>(8i)) & 255u)) * _e3109) * _e2817) + ((f32(((_e3086[1].color >> bitcast<u32>(8i)) & 255u)) * _e3128) * _e2811.u)) + ((f32(((_e3086[2].color >> bitcast<u32>(8i)) & 255u)) * _e3150) * _e2811.v))) * _e3163.y);
            let _e3169 = ((_e3092.base_color.z * ((((f32(((_e3086[0].color >> bitcast<u32>(16i)) & 255u)) * _e3109) * _e2817) + ((f32(((_e3086[1].color >> bitcast<u32>(16i)) & 255u)) * _e3128) * _e2811.u)) + ((f32(((_e3086[2].color >> bitcast<u32>(16i)) & 255u)) * _e3150) * _e2811.v))) * _e3163.z);
            let _e3170 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e2999, _e3002);
            let _e3171 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e2996, _e3170);
            if ((_e3092.flags & 2u) == 0u) {
                phi_3878_ = 0u;
            } else {
                phi_3878_ = 1u;
            }
            let _e3176 = phi_3878_;
            if (_e3086[0].normal == 2147516416u) {
                phi_4108_ = _e3064;
            } else {
                let _e3189 = (f32((bitcast<i32>((_e3086[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3195 = (f32((bitcast<i32>(_e3086[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3199 = ((1f - abs(_e3189)) - abs(_e3195));
                if (_e3199 < 0f) {
                    phi_3905_ = -(_e3199);
                } else {
                    phi_3905_ = 0f;
                }
                let _e3203 = phi_3905_;
                if (_e3189 < 0f) {
                    phi_3912_ = (_e3189 + _e3203);
                } else {
                    phi_3912_ = (_e3189 - _e3203);
                }
                let _e3208 = phi_3912_;
                if (_e3195 < 0f) {
                    phi_3919_ = (_e3195 + _e3203);
                } else {
                    phi_3919_ = (_e3195 - _e3203);
                }
                let _e3213 = phi_3919_;
                let _e3220 = (1f / sqrt((((_e3208 * _e3208) + (_e3213 * _e3213)) + (_e3199 * _e3199))));
                let _e3236 = (f32((bitcast<i32>((_e3086[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3242 = (f32((bitcast<i32>(_e3086[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3246 = ((1f - abs(_e3236)) - abs(_e3242));
                if (_e3246 < 0f) {
                    phi_3954_ = -(_e3246);
                } else {
                    phi_3954_ = 0f;
                }
                let _e3250 = phi_3954_;
                if (_e3236 < 0f) {
                    phi_3961_ = (_e3236 + _e3250);
                } else {
                    phi_3961_ = (_e3236 - _e3250);
                }
                let _e3255 = phi_3961_;
                if (_e3242 < 0f) {
                    phi_3968_ = (_e3242 + _e3250);
                } else {
                    phi_3968_ = (_e3242 - _e3250);
                }
                let _e3260 = phi_3968_;
                let _e3267 = (1f / sqrt((((_e3255 * _e3255) + (_e3260 * _e3260)) + (_e3246 * _e3246))));
                let _e3286 = (f32((bitcast<i32>((_e3086[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3292 = (f32((bitcast<i32>(_e3086[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3296 = ((1f - abs(_e3286)) - abs(_e3292));
                if (_e3296 < 0f) {
                    phi_4006_ = -(_e3296);
                } else {
                    phi_4006_ = 0f;
                }
                let _e3300 = phi_4006_;
                if (_e3286 < 0f) {
                    phi_4013_ = (_e3286 + _e3300);
                } else {
                    phi_4013_ = (_e3286 - _e3300);
                }
                let _e3305 = phi_4013_;
                if (_e3292 < 0f) {
                    phi_4020_ = (_e3292 + _e3300);
                } else {
                    phi_4020_ = (_e3292 - _e3300);
                }
                let _e3310 = phi_4020_;
                let _e3317 = (1f / sqrt((((_e3305 * _e3305) + (_e3310 * _e3310)) + (_e3296 * _e3296))));
                let _e3324 = ((((_e3208 * _e3220) * _e2817) + ((_e3255 * _e3267) * _e2811.u)) + ((_e3305 * _e3317) * _e2811.v));
                let _e3325 = ((((_e3213 * _e3220) * _e2817) + ((_e3260 * _e3267) * _e2811.u)) + ((_e3310 * _e3317) * _e2811.v));
                let _e3326 = ((((_e3199 * _e3220) * _e2817) + ((_e3246 * _e3267) * _e2811.u)) + ((_e3296 * _e3317) * _e2811.v));
                if (_e2811.instance < _e91) {
                } else {
                    return;
                }
                let _e3333 = instances.member[(0u + _e2811.instance)].world_to_object[0u];
                let _e3342 = instances.member[(0u + _e2811.instance)].world_to_object[1u];
                let _e3354 = instances.member[(0u + _e2811.instance)].world_to_object[2u];
                let _e3361 = (((_e3333.x * _e3324) + (_e3342.x * _e3325)) + (_e3354.x * _e3326));
                let _e3362 = (((_e3333.y * _e3324) + (_e3342.y * _e3325)) + (_e3354.y * _e3326));
                let _e3363 = (((_e3333.z * _e3324) + (_e3342.z * _e3325)) + (_e3354.z * _e3326));
                let _e3369 = sqrt((((_e3361 * _e3361) + (_e3362 * _e3362)) + (_e3363 * _e3363)));
                if (_e3369 > 0f) {
                    let _e3371 = (_e3361 / _e3369);
                    let _e3372 = (_e3362 / _e3369);
                    let _e3373 = (_e3363 / _e3369);
                    if ((((_e3371 * _e3064.x) + (_e3372 * _e3064.y)) + (_e3373 * _e3064.z)) < 0f) {
                        phi_4106_ = vec3<f32>(-(_e3371), -(_e3372), -(_e3373));
                    } else {
                        phi_4106_ = vec3<f32>(_e3371, _e3372, _e3373);
                    }
                    let _e3389 = phi_4106_;
                    phi_4107_ = _e3389;
                } else {
                    phi_4107_ = _e3064;
                }
                let _e3391 = phi_4107_;
                phi_4108_ = _e3391;
            }
            let _e3393 = phi_4108_;
            if (_e3165 > 0f) {
                if (_e3165 < 1f) {
                    phi_4117_ = _e3165;
                } else {
                    phi_4117_ = 1f;
                }
                let _e3397 = phi_4117_;
                phi_4118_ = _e3397;
            } else {
                phi_4118_ = 0f;
            }
            let _e3399 = phi_4118_;
            if (_e3167 > 0f) {
                if (_e3167 < 1f) {
                    phi_4128_ = _e3167;
                } else {
                    phi_4128_ = 1f;
                }
                let _e3404 = phi_4128_;
                phi_4129_ = _e3404;
            } else {
                phi_4129_ = 0f;
            }
            let _e3406 = phi_4129_;
            if (_e3169 > 0f) {
                if (_e3169 < 1f) {
                    phi_4139_ = _e3169;
                } else {
                    phi_4139_ = 1f;
                }
                let _e3411 = phi_4139_;
                phi_4140_ = _e3411;
            } else {
                phi_4140_ = 0f;
            }
            let _e3413 = phi_4140_;
            let _e3416 = ((sqrt(_e3399) * 255f) + 0.5f);
            let _e3425 = ((sqrt(_e3406) * 255f) + 0.5f);
            let _e3437 = ((sqrt(_e3413) * 255f) + 0.5f);
            phi_4175_ = abi_Sample(vec3<f32>(_e2972, _e2973, _e2974), _e3171, _e3064, _e3176, _e3393, ((select(select(u32(_e3416), 0u, (_e3416 < bitcast<f32>(0u))), 4294967295u, (_e3416 > bitcast<f32>(1333788671u))) | (select(select(u32(_e3425), 0u, (_e3425 < bitcast<f32>(0u))), 4294967295u, (_e3425 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e3437), 0u, (_e3437 < bitcast<f32>(0u))), 4294967295u, (_e3437 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_4175_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e3451 = phi_4175_;
        if (_e100.shift < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e100.shift)] = _e3451;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_instanced_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
