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
    var phi_809_: bool;
    var phi_810_: bool;
    var phi_811_: bool;
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
    var phi_829_: bool;
    var phi_830_: bool;
    var phi_831_: bool;
    var phi_832_: bool;
    var phi_836_: bool;
    var phi_840_: bool;
    var phi_915_: f32;
    var phi_922_: f32;
    var phi_930_: f32;
    var phi_937_: f32;
    var phi_945_: f32;
    var phi_952_: f32;
    var phi_977_: f32;
    var phi_982_: f32;
    var phi_987_: f32;
    var phi_1009_: u32;
    var phi_1014_: u32;
    var phi_1019_: u32;
    var phi_1133_: bool;
    var phi_1134_: bool;
    var phi_1165_: u32;
    var phi_1167_: u32;
    var phi_1170_: lt_bvh_Hit;
    var phi_1255_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1282_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1309_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1315_: u32;
    var phi_1318_: u32;
    var phi_1332_: u32;
    var phi_1342_: u32;
    var phi_1352_: u32;
    var phi_1370_: u32;
    var phi_1380_: u32;
    var phi_1390_: u32;
    var phi_1426_: u32;
    var phi_1439_: u32;
    var phi_1444_: u32;
    var phi_1445_: u32;
    var phi_1446_: u32;
    var phi_1316_: u32;
    var phi_1319_: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_1504_: u32;
    var phi_1507_: lt_bvh_Hit;
    var phi_1562_: f32;
    var phi_1567_: f32;
    var phi_1572_: f32;
    var phi_1580_: f32;
    var phi_1585_: f32;
    var phi_1590_: f32;
    var phi_1746_: bool;
    var phi_1747_: bool;
    var phi_1748_: bool;
    var phi_1752_: bool;
    var phi_1753_: bool;
    var phi_1754_: bool;
    var phi_1755_: bool;
    var phi_1756_: bool;
    var phi_1757_: bool;
    var phi_1758_: bool;
    var phi_1759_: bool;
    var phi_1760_: bool;
    var phi_1761_: bool;
    var phi_1762_: bool;
    var phi_1763_: bool;
    var phi_1764_: bool;
    var phi_1765_: bool;
    var phi_1766_: bool;
    var phi_1767_: bool;
    var phi_1768_: bool;
    var phi_1769_: bool;
    var phi_1773_: bool;
    var phi_1777_: bool;
    var phi_1847_: f32;
    var phi_1854_: f32;
    var phi_1861_: f32;
    var phi_1868_: f32;
    var phi_1875_: f32;
    var phi_1882_: f32;
    var phi_1899_: f32;
    var phi_1904_: f32;
    var phi_1909_: f32;
    var phi_1937_: bool;
    var phi_1938_: bool;
    var phi_1946_: u32;
    var phi_1947_: u32;
    var phi_1958_: vec3<f32>;
    var phi_1959_: vec3<f32>;
    var phi_1972_: u32;
    var phi_1977_: u32;
    var phi_1982_: u32;
    var phi_2096_: bool;
    var phi_2097_: bool;
    var phi_2128_: u32;
    var phi_2130_: lt_bvh_Hit;
    var phi_2133_: u32;
    var phi_2214_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2241_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2268_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2274_: u32;
    var phi_2277_: u32;
    var phi_2291_: u32;
    var phi_2301_: u32;
    var phi_2311_: u32;
    var phi_2329_: u32;
    var phi_2339_: u32;
    var phi_2349_: u32;
    var phi_2385_: u32;
    var phi_2398_: u32;
    var phi_2403_: u32;
    var phi_2404_: u32;
    var phi_2405_: u32;
    var phi_2275_: u32;
    var phi_2278_: u32;
    var local_6: u32;
    var local_7: u32;
    var local_8: u32;
    var phi_2463_: lt_bvh_Hit;
    var phi_2466_: u32;
    var phi_2510_: vec3<f32>;
    var phi_2511_: vec3<f32>;
    var phi_2540_: vec3<f32>;
    var phi_2541_: vec3<f32>;
    var phi_2570_: vec3<f32>;
    var phi_2571_: vec3<f32>;
    var phi_2589_: bool;
    var phi_2590_: bool;
    var phi_2594_: f32;
    var phi_2595_: f32;
    var phi_2596_: f32;
    var phi_2597_: f32;
    var phi_2605_: f32;
    var phi_2615_: bool;
    var phi_2616_: bool;
    var phi_2620_: f32;
    var phi_2621_: f32;
    var phi_2622_: f32;
    var phi_2623_: f32;
    var phi_2631_: f32;
    var phi_2641_: bool;
    var phi_2642_: bool;
    var phi_2646_: f32;
    var phi_2647_: f32;
    var phi_2648_: f32;
    var phi_2649_: f32;
    var phi_2657_: f32;
    var phi_2672_: f32;
    var phi_2673_: bool;
    var phi_2674_: f32;
    var phi_2675_: bool;
    var phi_2676_: f32;
    var phi_2677_: bool;
    var phi_2695_: f32;
    var phi_2696_: bool;
    var phi_2697_: bool;
    var phi_2698_: f32;
    var phi_2699_: bool;
    var phi_2700_: bool;
    var phi_2704_: bool;
    var phi_2705_: f32;
    var phi_2706_: bool;
    var phi_2734_: vec3<f32>;
    var phi_2735_: vec3<f32>;
    var phi_2760_: vec3<f32>;
    var phi_2761_: vec3<f32>;
    var phi_2786_: vec3<f32>;
    var phi_2787_: vec3<f32>;
    var phi_2843_: f32;
    var phi_2852_: f32;
    var phi_2861_: f32;
    var phi_2870_: f32;
    var phi_2877_: f32;
    var phi_2884_: f32;
    var phi_2897_: f32;
    var phi_2906_: f32;
    var phi_2915_: f32;
    var phi_2924_: f32;
    var phi_2931_: f32;
    var phi_2938_: f32;
    var phi_2955_: f32;
    var phi_2960_: f32;
    var phi_2965_: f32;
    var phi_2973_: f32;
    var phi_2978_: f32;
    var phi_2983_: f32;
    var phi_2995_: f32;
    var phi_3000_: f32;
    var phi_3005_: f32;
    var phi_3010_: f32;
    var phi_3015_: lt_bvh_triangle_Intersection;
    var phi_3016_: bool;
    var phi_3017_: lt_bvh_triangle_Intersection;
    var phi_3018_: bool;
    var phi_3022_: lt_bvh_triangle_Intersection;
    var phi_3023_: bool;
    var phi_3024_: lt_bvh_triangle_Intersection;
    var phi_3025_: bool;
    var phi_3026_: bool;
    var phi_3030_: bool;
    var phi_3034_: lt_bvh_triangle_Intersection;
    var phi_3072_: bool;
    var phi_3073_: bool;
    var phi_3074_: bool;
    var phi_3075_: bool;
    var phi_3076_: bool;
    var phi_3077_: bool;
    var phi_3081_: bool;
    var phi_3082_: bool;
    var phi_3285_: f32;
    var phi_3288_: bool;
    var phi_3289_: bool;
    var phi_3293_: bool;
    var phi_3301_: lt_bvh_Hit;
    var phi_3302_: lt_bvh_Hit;
    var phi_3303_: lt_bvh_Hit;
    var phi_3304_: lt_bvh_Hit;
    var phi_2464_: lt_bvh_Hit;
    var phi_2467_: u32;
    var phi_3305_: bool;
    var phi_3344_: bool;
    var phi_3345_: bool;
    var phi_3376_: u32;
    var phi_2131_: lt_bvh_Hit;
    var phi_2134_: u32;
    var phi_3377_: lt_bvh_Hit;
    var phi_3378_: lt_bvh_Hit;
    var phi_3379_: bool;
    var phi_3383_: lt_bvh_Hit;
    var phi_3384_: lt_bvh_Hit;
    var phi_3385_: lt_bvh_Hit;
    var phi_3386_: lt_bvh_Hit;
    var phi_1505_: u32;
    var phi_1508_: lt_bvh_Hit;
    var phi_3387_: bool;
    var phi_3426_: bool;
    var phi_3427_: bool;
    var phi_3458_: u32;
    var phi_1168_: u32;
    var phi_1171_: lt_bvh_Hit;
    var phi_3459_: lt_bvh_Hit;
    var phi_3460_: lt_bvh_Hit;
    var phi_3461_: bool;
    var phi_3465_: lt_bvh_Hit;
    var phi_3653_: f32;
    var phi_3658_: f32;
    var phi_3663_: f32;
    var phi_3671_: f32;
    var phi_3676_: f32;
    var phi_3681_: f32;
    var phi_3745_: vec3<f32>;
    var phi_3866_: u32;
    var phi_3893_: f32;
    var phi_3900_: f32;
    var phi_3907_: f32;
    var phi_3942_: f32;
    var phi_3949_: f32;
    var phi_3956_: f32;
    var phi_3994_: f32;
    var phi_4001_: f32;
    var phi_4008_: f32;
    var phi_4094_: vec3<f32>;
    var phi_4095_: vec3<f32>;
    var phi_4096_: vec3<f32>;
    var phi_4105_: f32;
    var phi_4106_: f32;
    var phi_4116_: f32;
    var phi_4117_: f32;
    var phi_4127_: f32;
    var phi_4128_: f32;
    var phi_4163_: abi_Sample;
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
        let _e169 = abs(_e157.direction.x);
        let _e171 = abs(_e157.direction.y);
        let _e173 = abs(_e157.direction.z);
        if (abs(_e157.origin.x) < 1000000000000000f) {
            if (abs(_e157.origin.y) < 1000000000000000f) {
                if (abs(_e157.origin.z) < 1000000000000000f) {
                    if (_e169 < 1000000000000000f) {
                        if (_e171 < 1000000000000000f) {
                            if (_e173 < 1000000000000000f) {
                                if (_e169 > 0f) {
                                    phi_810_ = bool();
                                    phi_811_ = true;
                                } else {
                                    let _e181 = (_e171 > 0f);
                                    if _e181 {
                                        phi_809_ = bool();
                                    } else {
                                        phi_809_ = (_e173 > 0f);
                                    }
                                    let _e184 = phi_809_;
                                    phi_810_ = _e184;
                                    phi_811_ = _e181;
                                }
                                let _e186 = phi_810_;
                                let _e188 = phi_811_;
                                if _e188 {
                                    phi_815_ = true;
                                } else {
                                    phi_815_ = _e186;
                                }
                                let _e190 = phi_815_;
                                phi_816_ = _e190;
                                phi_817_ = false;
                            } else {
                                phi_816_ = bool();
                                phi_817_ = true;
                            }
                            let _e192 = phi_816_;
                            let _e194 = phi_817_;
                            phi_818_ = _e192;
                            phi_819_ = false;
                            phi_820_ = _e194;
                        } else {
                            phi_818_ = bool();
                            phi_819_ = true;
                            phi_820_ = false;
                        }
                        let _e196 = phi_818_;
                        let _e198 = phi_819_;
                        let _e200 = phi_820_;
                        phi_821_ = _e196;
                        phi_822_ = _e198;
                        phi_823_ = _e200;
                    } else {
                        phi_821_ = bool();
                        phi_822_ = true;
                        phi_823_ = false;
                    }
                    let _e202 = phi_821_;
                    let _e204 = phi_822_;
                    let _e206 = phi_823_;
                    phi_824_ = _e202;
                    phi_825_ = _e204;
                    phi_826_ = _e206;
                } else {
                    phi_824_ = bool();
                    phi_825_ = true;
                    phi_826_ = false;
                }
                let _e208 = phi_824_;
                let _e210 = phi_825_;
                let _e212 = phi_826_;
                phi_827_ = _e208;
                phi_828_ = _e210;
                phi_829_ = _e212;
            } else {
                phi_827_ = bool();
                phi_828_ = true;
                phi_829_ = false;
            }
            let _e214 = phi_827_;
            let _e216 = phi_828_;
            let _e218 = phi_829_;
            phi_830_ = _e214;
            phi_831_ = _e216;
            phi_832_ = _e218;
        } else {
            phi_830_ = bool();
            phi_831_ = true;
            phi_832_ = false;
        }
        let _e220 = phi_830_;
        let _e222 = phi_831_;
        let _e224 = phi_832_;
        if _e222 {
            phi_836_ = true;
        } else {
            phi_836_ = _e224;
        }
        let _e226 = phi_836_;
        if _e226 {
            phi_840_ = false;
        } else {
            phi_840_ = _e220;
        }
        let _e228 = phi_840_;
        if _e228 {
            let _e229 = (_e106 >= _e76);
            if _e229 {
                phi_3459_ = lt_bvh_Hit();
            } else {
                if (_e106 < _e76) {
                } else {
                    return;
                }
                let _e235 = nodes.member[(0u + _e106)].frame[0u];
                let _e239 = nodes.member[(0u + _e106)].frame[1u];
                let _e243 = nodes.member[(0u + _e106)].frame[2u];
                let _e247 = nodes.member[(0u + _e106)].frame[0u];
                let _e251 = nodes.member[(0u + _e106)].frame[1u];
                let _e255 = nodes.member[(0u + _e106)].frame[2u];
                let _e259 = nodes.member[(0u + _e106)].frame[3u];
                let _e297 = core_intrinsics_maximum_number_nsz_f32_(abs(_e157.direction.x), abs(_e157.direction.y));
                let _e298 = core_intrinsics_maximum_number_nsz_f32_(_e297, abs(_e157.direction.z));
                let _e299 = (_e298 * 0.0000000000009094947f);
                if (abs(_e157.direction.x) < _e299) {
                    phi_915_ = _e299;
                } else {
                    phi_915_ = abs(_e157.direction.x);
                }
                let _e306 = phi_915_;
                if (_e157.direction.x < 0f) {
                    phi_922_ = (-1f / _e306);
                } else {
                    phi_922_ = (1f / _e306);
                }
                let _e311 = phi_922_;
                if (abs(_e157.direction.y) < _e299) {
                    phi_930_ = _e299;
                } else {
                    phi_930_ = abs(_e157.direction.y);
                }
                let _e318 = phi_930_;
                if (_e157.direction.y < 0f) {
                    phi_937_ = (-1f / _e318);
                } else {
                    phi_937_ = (1f / _e318);
                }
                let _e323 = phi_937_;
                if (abs(_e157.direction.z) < _e299) {
                    phi_945_ = _e299;
                } else {
                    phi_945_ = abs(_e157.direction.z);
                }
                let _e330 = phi_945_;
                if (_e157.direction.z < 0f) {
                    phi_952_ = (-1f / _e330);
                } else {
                    phi_952_ = (1f / _e330);
                }
                let _e335 = phi_952_;
                let _e343 = abs((bitcast<f32>(_e235) - _e157.origin.x));
                let _e344 = abs((bitcast<f32>(_e239) - _e157.origin.y));
                let _e345 = abs((bitcast<f32>(_e243) - _e157.origin.z));
                let _e353 = abs(((bitcast<f32>(_e247) + (bitcast<f32>((((_e259 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e157.origin.x));
                let _e354 = abs(((bitcast<f32>(_e251) + (bitcast<f32>((((_e259 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e157.origin.y));
                let _e355 = abs(((bitcast<f32>(_e255) + (bitcast<f32>((((_e259 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e157.origin.z));
                if (_e343 > _e353) {
                    phi_977_ = _e343;
                } else {
                    phi_977_ = _e353;
                }
                let _e358 = phi_977_;
                if (_e344 > _e354) {
                    phi_982_ = _e344;
                } else {
                    phi_982_ = _e354;
                }
                let _e361 = phi_982_;
                if (_e345 > _e355) {
                    phi_987_ = _e345;
                } else {
                    phi_987_ = _e355;
                }
                let _e364 = phi_987_;
                let _e365 = core_intrinsics_maximum_number_nsz_f32_(_e358, _e361);
                let _e366 = core_intrinsics_maximum_number_nsz_f32_(_e365, _e364);
                let _e371 = (_e366 * 0.0000019073486f);
                let _e372 = (abs(_e311) * _e371);
                let _e373 = (abs(_e323) * _e371);
                let _e374 = (abs(_e335) * _e371);
                let _e378 = (_e366 * 0.0000009536743f);
                let _e379 = (abs(_e311) * _e378);
                let _e380 = (abs(_e323) * _e378);
                let _e381 = (abs(_e335) * _e378);
                if (_e311 < 0f) {
                    phi_1009_ = 0u;
                } else {
                    phi_1009_ = 1u;
                }
                let _e384 = phi_1009_;
                if (_e323 < 0f) {
                    phi_1014_ = 0u;
                } else {
                    phi_1014_ = 2u;
                }
                let _e387 = phi_1014_;
                if (_e335 < 0f) {
                    phi_1019_ = 0u;
                } else {
                    phi_1019_ = 4u;
                }
                let _e390 = phi_1019_;
                let _e392 = ((_e384 | _e387) | _e390);
                let _e393 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e106, 2147483648u);
                local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e393.first[0], _e393.first[1], _e393.first[2], _e393.first[3], _e393.first[4], _e393.first[5], _e393.first[6], _e393.first[7], _e393.first[8], _e393.first[9], _e393.first[10], _e393.first[11], _e393.first[12], _e393.first[13], _e393.first[14], _e393.first[15], _e393.first[16], _e393.first[17], _e393.first[18], _e393.first[19], _e393.first[20], _e393.first[21], _e393.first[22], _e393.first[23], _e393.first[24], _e393.first[25], _e393.first[26], _e393.first[27], _e393.first[28], _e393.first[29], _e393.first[30], _e393.first[31]), array<u32, 32>(_e393.mask[0], _e393.mask[1], _e393.mask[2], _e393.mask[3], _e393.mask[4], _e393.mask[5], _e393.mask[6], _e393.mask[7], _e393.mask[8], _e393.mask[9], _e393.mask[10], _e393.mask[11], _e393.mask[12], _e393.mask[13], _e393.mask[14], _e393.mask[15], _e393.mask[16], _e393.mask[17], _e393.mask[18], _e393.mask[19], _e393.mask[20], _e393.mask[21], _e393.mask[22], _e393.mask[23], _e393.mask[24], _e393.mask[25], _e393.mask[26], _e393.mask[27], _e393.mask[28], _e393.mask[29], _e393.mask[30], _e393.mask[31]), _e393.len, _e393.group, _e393.group_mask);
                let _e467 = local_2.group_mask;
                if ((_e467 & 4278190080u) == 0u) {
                    let _e471 = local_2.len;
                    if (_e471 == 0u) {
                        phi_1133_ = false;
                    } else {
                        let _e475 = local_2.len;
                        local_2.len = (_e475 - 1u);
                        let _e478 = local_2.len;
                        if (_e478 < 32u) {
                        } else {
                            return;
                        }
                        let _e483 = local_2.first[(0u + _e478)];
                        local_2.group = _e483;
                        let _e486 = local_2.len;
                        if (_e486 < 32u) {
                        } else {
                            return;
                        }
                        let _e491 = local_2.mask[(0u + _e486)];
                        local_2.group_mask = _e491;
                        phi_1133_ = true;
                    }
                    let _e494 = phi_1133_;
                    phi_1134_ = _e494;
                } else {
                    phi_1134_ = true;
                }
                let _e496 = phi_1134_;
                if _e496 {
                    let _e498 = local_2.group_mask;
                    let _e504 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e498)), 32u, (_e498 == 0u)));
                    let _e508 = local_2.group_mask;
                    let _e522 = local_2.group_mask;
                    local_2.group_mask = (_e522 & ~((1u << bitcast<u32>((_e504 & 31u)))));
                    let _e525 = local_2.group;
                    phi_1165_ = (_e525 + countOneBits(((_e508 & ~((4294967295u << bitcast<u32>((((_e504 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1165_ = 4294967295u;
                }
                let _e528 = phi_1165_;
                phi_1167_ = _e528;
                phi_1170_ = _e159;
                loop {
                    let _e530 = phi_1167_;
                    let _e532 = phi_1170_;
                    local_12 = _e532;
                    let _e533 = (_e530 != 4294967295u);
                    if _e533 {
                        if (_e530 < _e76) {
                        } else {
                            return;
                        }
                        let _e541 = nodes.member[(0u + _e530)].frame[3u];
                        let _e566 = (bitcast<f32>((((_e541 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e311);
                        let _e567 = (bitcast<f32>((((_e541 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e323);
                        let _e568 = (bitcast<f32>((((_e541 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e335);
                        let _e571 = nodes.member[(0u + _e530)].frame[0u];
                        let _e575 = nodes.member[(0u + _e530)].frame[1u];
                        let _e579 = nodes.member[(0u + _e530)].frame[2u];
                        let _e587 = ((bitcast<f32>(_e571) - _e157.origin.x) * _e311);
                        let _e588 = ((bitcast<f32>(_e575) - _e157.origin.y) * _e323);
                        let _e589 = ((bitcast<f32>(_e579) - _e157.origin.z) * _e335);
                        let _e597 = nodes.member[(0u + _e530)].x;
                        if (_e311 < 0f) {
                            let _e608 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e597.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e614 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e608.unnamed.word, _e597.w), _e608.unnamed_1);
                            let _e620 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e614.unnamed, lt_mask_LightPlace(_e597.x, _e614.unnamed_1.shift));
                            phi_1255_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e620.unnamed, lt_mask_LightPlace(_e620.unnamed_1.word, _e597.y));
                        } else {
                            let _e636 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e597.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e642 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e636.unnamed.word, _e597.y), _e636.unnamed_1);
                            let _e648 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e642.unnamed, lt_mask_LightPlace(_e597.z, _e642.unnamed_1.shift));
                            phi_1255_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e648.unnamed, lt_mask_LightPlace(_e648.unnamed_1.word, _e597.w));
                        }
                        let _e656 = phi_1255_;
                        let _e666 = nodes.member[(0u + _e530)].y;
                        if (_e323 < 0f) {
                            let _e677 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e666.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e683 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e677.unnamed.word, _e666.w), _e677.unnamed_1);
                            let _e689 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e683.unnamed, lt_mask_LightPlace(_e666.x, _e683.unnamed_1.shift));
                            phi_1282_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e689.unnamed, lt_mask_LightPlace(_e689.unnamed_1.word, _e666.y));
                        } else {
                            let _e705 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e666.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e711 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e705.unnamed.word, _e666.y), _e705.unnamed_1);
                            let _e717 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e711.unnamed, lt_mask_LightPlace(_e666.z, _e711.unnamed_1.shift));
                            phi_1282_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e717.unnamed, lt_mask_LightPlace(_e717.unnamed_1.word, _e666.w));
                        }
                        let _e725 = phi_1282_;
                        let _e735 = nodes.member[(0u + _e530)].z;
                        if (_e335 < 0f) {
                            let _e746 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e735.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e752 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e746.unnamed.word, _e735.w), _e746.unnamed_1);
                            let _e758 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e752.unnamed, lt_mask_LightPlace(_e735.x, _e752.unnamed_1.shift));
                            phi_1309_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e758.unnamed, lt_mask_LightPlace(_e758.unnamed_1.word, _e735.y));
                        } else {
                            let _e774 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e735.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e780 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e774.unnamed.word, _e735.y), _e774.unnamed_1);
                            let _e786 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e780.unnamed, lt_mask_LightPlace(_e735.z, _e780.unnamed_1.shift));
                            phi_1309_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e786.unnamed, lt_mask_LightPlace(_e786.unnamed_1.word, _e735.w));
                        }
                        let _e794 = phi_1309_;
                        phi_1315_ = 0u;
                        phi_1318_ = 0u;
                        loop {
                            let _e804 = phi_1315_;
                            let _e806 = phi_1318_;
                            local_3 = _e806;
                            local_4 = _e806;
                            local_5 = _e806;
                            let _e807 = (_e804 < 8u);
                            if _e807 {
                                let _e809 = (_e804 >> bitcast<u32>(2i));
                                let _e810 = (_e804 & 3u);
                                if (_e809 == 0u) {
                                    phi_1332_ = _e656.unnamed.word;
                                } else {
                                    phi_1332_ = _e656.unnamed.shift;
                                }
                                let _e813 = phi_1332_;
                                if (_e809 == 0u) {
                                    phi_1342_ = _e725.unnamed.word;
                                } else {
                                    phi_1342_ = _e725.unnamed.shift;
                                }
                                let _e822 = phi_1342_;
                                if (_e809 == 0u) {
                                    phi_1352_ = _e794.unnamed.word;
                                } else {
                                    phi_1352_ = _e794.unnamed.shift;
                                }
                                let _e831 = phi_1352_;
                                let _e844 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e813 >> bitcast<u32>(((_e810 * 8u) & 31u))) & 255u)) * _e566) + (_e587 - _e372)), ((f32(((_e822 >> bitcast<u32>(((_e810 * 8u) & 31u))) & 255u)) * _e567) + (_e588 - _e373)));
                                let _e845 = core_intrinsics_maximum_number_nsz_f32_(_e844, ((f32(((_e831 >> bitcast<u32>(((_e810 * 8u) & 31u))) & 255u)) * _e568) + (_e589 - _e374)));
                                if (_e809 == 0u) {
                                    phi_1370_ = _e656.unnamed_1.word;
                                } else {
                                    phi_1370_ = _e656.unnamed_1.shift;
                                }
                                let _e848 = phi_1370_;
                                if (_e809 == 0u) {
                                    phi_1380_ = _e725.unnamed_1.word;
                                } else {
                                    phi_1380_ = _e725.unnamed_1.shift;
                                }
                                let _e857 = phi_1380_;
                                if (_e809 == 0u) {
                                    phi_1390_ = _e794.unnamed_1.word;
                                } else {
                                    phi_1390_ = _e794.unnamed_1.shift;
                                }
                                let _e866 = phi_1390_;
                                let _e879 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e848 >> bitcast<u32>(((_e810 * 8u) & 31u))) & 255u)) * _e566) + (_e587 + _e372)), ((f32(((_e857 >> bitcast<u32>(((_e810 * 8u) & 31u))) & 255u)) * _e567) + (_e588 + _e373)));
                                let _e880 = core_intrinsics_minimum_number_nsz_f32_(_e879, ((f32(((_e866 >> bitcast<u32>(((_e810 * 8u) & 31u))) & 255u)) * _e568) + (_e589 + _e374)));
                                if (_e845 <= _e880) {
                                    if (_e845 <= _e532.t) {
                                        if (_e880 >= _e157.tmin) {
                                            if (_e809 == 0u) {
                                                let _e887 = nodes.member[(0u + _e530)].links[2u];
                                                phi_1426_ = _e887;
                                            } else {
                                                let _e890 = nodes.member[(0u + _e530)].links[3u];
                                                phi_1426_ = _e890;
                                            }
                                            let _e892 = phi_1426_;
                                            let _e897 = ((_e892 >> bitcast<u32>(((_e810 * 8u) & 31u))) & 255u);
                                            let _e898 = (_e897 & 31u);
                                            if (_e898 >= 24u) {
                                                phi_1439_ = (24u + ((_e898 - 24u) ^ _e392));
                                            } else {
                                                phi_1439_ = _e898;
                                            }
                                            let _e904 = phi_1439_;
                                            phi_1444_ = (_e806 | ((_e897 >> bitcast<u32>(5i)) << bitcast<u32>((_e904 & 31u))));
                                        } else {
                                            phi_1444_ = _e806;
                                        }
                                        let _e912 = phi_1444_;
                                        phi_1445_ = _e912;
                                    } else {
                                        phi_1445_ = _e806;
                                    }
                                    let _e914 = phi_1445_;
                                    phi_1446_ = _e914;
                                } else {
                                    phi_1446_ = _e806;
                                }
                                let _e916 = phi_1446_;
                                phi_1316_ = (_e804 + 1u);
                                phi_1319_ = _e916;
                            } else {
                                phi_1316_ = u32();
                                phi_1319_ = u32();
                            }
                            let _e919 = phi_1316_;
                            let _e921 = phi_1319_;
                            continue;
                            continuing {
                                phi_1315_ = _e919;
                                phi_1318_ = _e921;
                                break if !(_e807);
                            }
                        }
                        let _e925 = nodes.member[(0u + _e530)].links[0u];
                        let _e929 = nodes.member[(0u + _e530)].frame[3u];
                        let _e933 = local_3;
                        if ((_e933 & 4278190080u) == 0u) {
                        } else {
                            let _e937 = local_2.group_mask;
                            if ((_e937 & 4278190080u) == 0u) {
                            } else {
                                let _e941 = local_2.len;
                                if (_e941 < 32u) {
                                    let _e944 = local_2.group;
                                    let _e946 = local_2.len;
                                    if (_e946 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.first[(0u + _e946)] = _e944;
                                    let _e952 = local_2.group_mask;
                                    let _e954 = local_2.len;
                                    if (_e954 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.mask[(0u + _e954)] = _e952;
                                    let _e961 = local_2.len;
                                    local_2.len = (_e961 + 1u);
                                }
                            }
                            local_2.group = (_e106 + _e925);
                            let _e965 = local_4;
                            local_2.group_mask = ((_e965 & 4278190080u) | (_e929 >> bitcast<u32>(24i)));
                        }
                        let _e970 = local_5;
                        phi_1504_ = (_e970 & 16777215u);
                        phi_1507_ = _e532;
                        loop {
                            let _e973 = phi_1504_;
                            let _e975 = phi_1507_;
                            local_11 = _e975;
                            if (_e973 == 0u) {
                                phi_1505_ = u32();
                                phi_1508_ = lt_bvh_Hit();
                                phi_3387_ = false;
                            } else {
                                let _e979 = nodes.member[(0u + _e530)].links[1u];
                                let _e983 = (_e979 + select(firstTrailingBit(_e973), 32u, (_e973 == 0u)));
                                if (_e983 < _e91) {
                                } else {
                                    return;
                                }
                                let _e990 = instances.member[(0u + _e983)].low_world;
                                let _e992 = instances.member[(0u + _e983)].high_world;
                                let _e1002 = ((_e990.x - _e157.origin.x) * _e311);
                                let _e1003 = ((_e990.y - _e157.origin.y) * _e323);
                                let _e1004 = ((_e990.z - _e157.origin.z) * _e335);
                                let _e1014 = ((_e992.x - _e157.origin.x) * _e311);
                                let _e1015 = ((_e992.y - _e157.origin.y) * _e323);
                                let _e1016 = ((_e992.z - _e157.origin.z) * _e335);
                                if (_e1002 < _e1014) {
                                    phi_1562_ = _e1002;
                                } else {
                                    phi_1562_ = _e1014;
                                }
                                let _e1019 = phi_1562_;
                                if (_e1003 < _e1015) {
                                    phi_1567_ = _e1003;
                                } else {
                                    phi_1567_ = _e1015;
                                }
                                let _e1022 = phi_1567_;
                                if (_e1004 < _e1016) {
                                    phi_1572_ = _e1004;
                                } else {
                                    phi_1572_ = _e1016;
                                }
                                let _e1025 = phi_1572_;
                                if (_e1002 > _e1014) {
                                    phi_1580_ = _e1002;
                                } else {
                                    phi_1580_ = _e1014;
                                }
                                let _e1031 = phi_1580_;
                                if (_e1003 > _e1015) {
                                    phi_1585_ = _e1003;
                                } else {
                                    phi_1585_ = _e1015;
                                }
                                let _e1034 = phi_1585_;
                                if (_e1004 > _e1016) {
                                    phi_1590_ = _e1004;
                                } else {
                                    phi_1590_ = _e1016;
                                }
                                let _e1037 = phi_1590_;
                                let _e1041 = core_intrinsics_maximum_number_nsz_f32_((_e1019 - _e379), (_e1022 - _e380));
                                let _e1042 = core_intrinsics_maximum_number_nsz_f32_(_e1041, (_e1025 - _e381));
                                let _e1043 = core_intrinsics_minimum_number_nsz_f32_((_e1031 + _e379), (_e1034 + _e380));
                                let _e1044 = core_intrinsics_minimum_number_nsz_f32_(_e1043, (_e1037 + _e381));
                                if (_e1042 <= _e1044) {
                                    if (_e1042 <= _e975.t) {
                                        if (_e1044 >= _e157.tmin) {
                                            let _e1056 = instances.member[(0u + _e983)].world_to_object[0u];
                                            let _e1067 = ((((_e1056.x * _e157.origin.x) + (_e1056.y * _e157.origin.y)) + (_e1056.z * _e157.origin.z)) + (_e1056.w * 1f));
                                            let _e1069 = instances.member[(0u + _e983)].world_to_object[1u];
                                            let _e1080 = ((((_e1069.x * _e157.origin.x) + (_e1069.y * _e157.origin.y)) + (_e1069.z * _e157.origin.z)) + (_e1069.w * 1f));
                                            let _e1082 = instances.member[(0u + _e983)].world_to_object[2u];
                                            let _e1093 = ((((_e1082.x * _e157.origin.x) + (_e1082.y * _e157.origin.y)) + (_e1082.z * _e157.origin.z)) + (_e1082.w * 1f));
                                            let _e1100 = instances.member[(0u + _e983)].world_to_object[0u];
                                            let _e1111 = ((((_e1100.x * _e157.direction.x) + (_e1100.y * _e157.direction.y)) + (_e1100.z * _e157.direction.z)) + (_e1100.w * 0f));
                                            let _e1113 = instances.member[(0u + _e983)].world_to_object[1u];
                                            let _e1124 = ((((_e1113.x * _e157.direction.x) + (_e1113.y * _e157.direction.y)) + (_e1113.z * _e157.direction.z)) + (_e1113.w * 0f));
                                            let _e1126 = instances.member[(0u + _e983)].world_to_object[2u];
                                            let _e1137 = ((((_e1126.x * _e157.direction.x) + (_e1126.y * _e157.direction.y)) + (_e1126.z * _e157.direction.z)) + (_e1126.w * 0f));
                                            let _e1142 = instances.member[(0u + _e983)].root;
                                            let _e1144 = instances.member[(0u + _e983)].first_triangle;
                                            let _e1148 = abs(_e1111);
                                            let _e1149 = abs(_e1124);
                                            let _e1150 = abs(_e1137);
                                            if (abs(_e1067) < 1000000000000000f) {
                                                if (abs(_e1080) < 1000000000000000f) {
                                                    if (abs(_e1093) < 1000000000000000f) {
                                                        if (_e1148 < 1000000000000000f) {
                                                            if (_e1149 < 1000000000000000f) {
                                                                if (_e1150 < 1000000000000000f) {
                                                                    if (_e1148 > 0f) {
                                                                        phi_1747_ = bool();
                                                                        phi_1748_ = true;
                                                                    } else {
                                                                        let _e1158 = (_e1149 > 0f);
                                                                        if _e1158 {
                                                                            phi_1746_ = bool();
                                                                        } else {
                                                                            phi_1746_ = (_e1150 > 0f);
                                                                        }
                                                                        let _e1161 = phi_1746_;
                                                                        phi_1747_ = _e1161;
                                                                        phi_1748_ = _e1158;
                                                                    }
                                                                    let _e1163 = phi_1747_;
                                                                    let _e1165 = phi_1748_;
                                                                    if _e1165 {
                                                                        phi_1752_ = true;
                                                                    } else {
                                                                        phi_1752_ = _e1163;
                                                                    }
                                                                    let _e1167 = phi_1752_;
                                                                    phi_1753_ = _e1167;
                                                                    phi_1754_ = false;
                                                                } else {
                                                                    phi_1753_ = bool();
                                                                    phi_1754_ = true;
                                                                }
                                                                let _e1169 = phi_1753_;
                                                                let _e1171 = phi_1754_;
                                                                phi_1755_ = _e1169;
                                                                phi_1756_ = false;
                                                                phi_1757_ = _e1171;
                                                            } else {
                                                                phi_1755_ = bool();
                                                                phi_1756_ = true;
                                                                phi_1757_ = false;
                                                            }
                                                            let _e1173 = phi_1755_;
                                                            let _e1175 = phi_1756_;
                                                            let _e1177 = phi_1757_;
                                                            phi_1758_ = _e1173;
                                                            phi_1759_ = _e1175;
                                                            phi_1760_ = _e1177;
                                                        } else {
                                                            phi_1758_ = bool();
                                                            phi_1759_ = true;
                                                            phi_1760_ = false;
                                                        }
                                                        let _e1179 = phi_1758_;
                                                        let _e1181 = phi_1759_;
                                                        let _e1183 = phi_1760_;
                                                        phi_1761_ = _e1179;
                                                        phi_1762_ = _e1181;
                                                        phi_1763_ = _e1183;
                                                    } else {
                                                        phi_1761_ = bool();
                                                        phi_1762_ = true;
                                                        phi_1763_ = false;
                                                    }
                                                    let _e1185 = phi_1761_;
                                                    let _e1187 = phi_1762_;
                                                    let _e1189 = phi_1763_;
                                                    phi_1764_ = _e1185;
                                                    phi_1765_ = _e1187;
                                                    phi_1766_ = _e1189;
                                                } else {
                                                    phi_1764_ = bool();
                                                    phi_1765_ = true;
                                                    phi_1766_ = false;
                                                }
                                                let _e1191 = phi_1764_;
                                                let _e1193 = phi_1765_;
                                                let _e1195 = phi_1766_;
                                                phi_1767_ = _e1191;
                                                phi_1768_ = _e1193;
                                                phi_1769_ = _e1195;
                                            } else {
                                                phi_1767_ = bool();
                                                phi_1768_ = true;
                                                phi_1769_ = false;
                                            }
                                            let _e1197 = phi_1767_;
                                            let _e1199 = phi_1768_;
                                            let _e1201 = phi_1769_;
                                            if _e1199 {
                                                phi_1773_ = true;
                                            } else {
                                                phi_1773_ = _e1201;
                                            }
                                            let _e1203 = phi_1773_;
                                            if _e1203 {
                                                phi_1777_ = false;
                                            } else {
                                                phi_1777_ = _e1197;
                                            }
                                            let _e1205 = phi_1777_;
                                            if _e1205 {
                                                let _e1206 = (_e1142 >= _e76);
                                                if _e1206 {
                                                    phi_3377_ = lt_bvh_Hit();
                                                } else {
                                                    if (_e1142 < _e76) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1212 = nodes.member[(0u + _e1142)].frame[0u];
                                                    let _e1216 = nodes.member[(0u + _e1142)].frame[1u];
                                                    let _e1220 = nodes.member[(0u + _e1142)].frame[2u];
                                                    let _e1224 = nodes.member[(0u + _e1142)].frame[0u];
                                                    let _e1228 = nodes.member[(0u + _e1142)].frame[1u];
                                                    let _e1232 = nodes.member[(0u + _e1142)].frame[2u];
                                                    let _e1236 = nodes.member[(0u + _e1142)].frame[3u];
                                                    let _e1270 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1111), abs(_e1124));
                                                    let _e1271 = core_intrinsics_maximum_number_nsz_f32_(_e1270, abs(_e1137));
                                                    let _e1272 = (_e1271 * 0.0000000000009094947f);
                                                    if (abs(_e1111) < _e1272) {
                                                        phi_1847_ = _e1272;
                                                    } else {
                                                        phi_1847_ = abs(_e1111);
                                                    }
                                                    let _e1277 = phi_1847_;
                                                    if (_e1111 < 0f) {
                                                        phi_1854_ = (-1f / _e1277);
                                                    } else {
                                                        phi_1854_ = (1f / _e1277);
                                                    }
                                                    let _e1282 = phi_1854_;
                                                    if (abs(_e1124) < _e1272) {
                                                        phi_1861_ = _e1272;
                                                    } else {
                                                        phi_1861_ = abs(_e1124);
                                                    }
                                                    let _e1287 = phi_1861_;
                                                    if (_e1124 < 0f) {
                                                        phi_1868_ = (-1f / _e1287);
                                                    } else {
                                                        phi_1868_ = (1f / _e1287);
                                                    }
                                                    let _e1292 = phi_1868_;
                                                    if (abs(_e1137) < _e1272) {
                                                        phi_1875_ = _e1272;
                                                    } else {
                                                        phi_1875_ = abs(_e1137);
                                                    }
                                                    let _e1297 = phi_1875_;
                                                    if (_e1137 < 0f) {
                                                        phi_1882_ = (-1f / _e1297);
                                                    } else {
                                                        phi_1882_ = (1f / _e1297);
                                                    }
                                                    let _e1302 = phi_1882_;
                                                    let _e1306 = abs((bitcast<f32>(_e1212) - _e1067));
                                                    let _e1307 = abs((bitcast<f32>(_e1216) - _e1080));
                                                    let _e1308 = abs((bitcast<f32>(_e1220) - _e1093));
                                                    let _e1312 = abs(((bitcast<f32>(_e1224) + (bitcast<f32>((((_e1236 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1067));
                                                    let _e1313 = abs(((bitcast<f32>(_e1228) + (bitcast<f32>((((_e1236 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1080));
                                                    let _e1314 = abs(((bitcast<f32>(_e1232) + (bitcast<f32>((((_e1236 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1093));
                                                    if (_e1306 > _e1312) {
                                                        phi_1899_ = _e1306;
                                                    } else {
                                                        phi_1899_ = _e1312;
                                                    }
                                                    let _e1317 = phi_1899_;
                                                    if (_e1307 > _e1313) {
                                                        phi_1904_ = _e1307;
                                                    } else {
                                                        phi_1904_ = _e1313;
                                                    }
                                                    let _e1320 = phi_1904_;
                                                    if (_e1308 > _e1314) {
                                                        phi_1909_ = _e1308;
                                                    } else {
                                                        phi_1909_ = _e1314;
                                                    }
                                                    let _e1323 = phi_1909_;
                                                    let _e1324 = core_intrinsics_maximum_number_nsz_f32_(_e1317, _e1320);
                                                    let _e1325 = core_intrinsics_maximum_number_nsz_f32_(_e1324, _e1323);
                                                    let _e1329 = (_e1325 * 0.0000019073486f);
                                                    let _e1330 = (abs(_e1282) * _e1329);
                                                    let _e1331 = (abs(_e1292) * _e1329);
                                                    let _e1332 = (abs(_e1302) * _e1329);
                                                    let _e1336 = (_e1325 * 0.0000009536743f);
                                                    let _e1337 = (abs(_e1282) * _e1336);
                                                    let _e1338 = (abs(_e1292) * _e1336);
                                                    let _e1339 = (abs(_e1302) * _e1336);
                                                    let _e1340 = abs(_e1111);
                                                    let _e1341 = abs(_e1124);
                                                    let _e1342 = abs(_e1137);
                                                    if (_e1340 >= _e1341) {
                                                        if (_e1340 >= _e1342) {
                                                            phi_1937_ = false;
                                                        } else {
                                                            phi_1937_ = true;
                                                        }
                                                        let _e1346 = phi_1937_;
                                                        phi_1938_ = _e1346;
                                                    } else {
                                                        phi_1938_ = true;
                                                    }
                                                    let _e1348 = phi_1938_;
                                                    if _e1348 {
                                                        if (_e1341 >= _e1342) {
                                                            phi_1946_ = 1u;
                                                        } else {
                                                            phi_1946_ = 2u;
                                                        }
                                                        let _e1351 = phi_1946_;
                                                        phi_1947_ = _e1351;
                                                    } else {
                                                        phi_1947_ = 0u;
                                                    }
                                                    let _e1353 = phi_1947_;
                                                    if (_e1353 == 0u) {
                                                        phi_1959_ = vec3<f32>(_e1124, _e1137, _e1111);
                                                    } else {
                                                        if (_e1353 == 1u) {
                                                            phi_1958_ = vec3<f32>(_e1137, _e1111, _e1124);
                                                        } else {
                                                            phi_1958_ = vec3<f32>(_e1111, _e1124, _e1137);
                                                        }
                                                        let _e1359 = phi_1958_;
                                                        phi_1959_ = _e1359;
                                                    }
                                                    let _e1361 = phi_1959_;
                                                    let _e1364 = (_e1361.x / _e1361.z);
                                                    let _e1367 = (_e1361.y / _e1361.z);
                                                    if (_e1282 < 0f) {
                                                        phi_1972_ = 0u;
                                                    } else {
                                                        phi_1972_ = 1u;
                                                    }
                                                    let _e1372 = phi_1972_;
                                                    if (_e1292 < 0f) {
                                                        phi_1977_ = 0u;
                                                    } else {
                                                        phi_1977_ = 2u;
                                                    }
                                                    let _e1375 = phi_1977_;
                                                    if (_e1302 < 0f) {
                                                        phi_1982_ = 0u;
                                                    } else {
                                                        phi_1982_ = 4u;
                                                    }
                                                    let _e1378 = phi_1982_;
                                                    let _e1380 = ((_e1372 | _e1375) | _e1378);
                                                    let _e1381 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1142, 2147483648u);
                                                    local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e1381.first[0], _e1381.first[1], _e1381.first[2], _e1381.first[3], _e1381.first[4], _e1381.first[5], _e1381.first[6], _e1381.first[7], _e1381.first[8], _e1381.first[9], _e1381.first[10], _e1381.first[11], _e1381.first[12], _e1381.first[13], _e1381.first[14], _e1381.first[15], _e1381.first[16], _e1381.first[17], _e1381.first[18], _e1381.first[19], _e1381.first[20], _e1381.first[21], _e1381.first[22], _e1381.first[23], _e1381.first[24], _e1381.first[25], _e1381.first[26], _e1381.first[27], _e1381.first[28], _e1381.first[29], _e1381.first[30], _e1381.first[31]), array<u32, 32>(_e1381.mask[0], _e1381.mask[1], _e1381.mask[2], _e1381.mask[3], _e1381.mask[4], _e1381.mask[5], _e1381.mask[6], _e1381.mask[7], _e1381.mask[8], _e1381.mask[9], _e1381.mask[10], _e1381.mask[11], _e1381.mask[12], _e1381.mask[13], _e1381.mask[14], _e1381.mask[15], _e1381.mask[16], _e1381.mask[17], _e1381.mask[18], _e1381.mask[19], _e1381.mask[20], _e1381.mask[21], _e1381.mask[22], _e1381.mask[23], _e1381.mask[24], _e1381.mask[25], _e1381.mask[26], _e1381.mask[27], _e1381.mask[28], _e1381.mask[29], _e1381.mask[30], _e1381.mask[31]), _e1381.len, _e1381.group, _e1381.group_mask);
                                                    let _e1455 = local_1.group_mask;
                                                    if ((_e1455 & 4278190080u) == 0u) {
                                                        let _e1459 = local_1.len;
                                                        if (_e1459 == 0u) {
                                                            phi_2096_ = false;
                                                        } else {
                                                            let _e1463 = local_1.len;
                                                            local_1.len = (_e1463 - 1u);
                                                            let _e1466 = local_1.len;
                                                            if (_e1466 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1471 = local_1.first[(0u + _e1466)];
                                                            local_1.group = _e1471;
                                                            let _e1474 = local_1.len;
                                                            if (_e1474 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1479 = local_1.mask[(0u + _e1474)];
                                                            local_1.group_mask = _e1479;
                                                            phi_2096_ = true;
                                                        }
                                                        let _e1482 = phi_2096_;
                                                        phi_2097_ = _e1482;
                                                    } else {
                                                        phi_2097_ = true;
                                                    }
                                                    let _e1484 = phi_2097_;
                                                    if _e1484 {
                                                        let _e1486 = local_1.group_mask;
                                                        let _e1492 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1486)), 32u, (_e1486 == 0u)));
                                                        let _e1496 = local_1.group_mask;
                                                        let _e1510 = local_1.group_mask;
                                                        local_1.group_mask = (_e1510 & ~((1u << bitcast<u32>((_e1492 & 31u)))));
                                                        let _e1513 = local_1.group;
                                                        phi_2128_ = (_e1513 + countOneBits(((_e1496 & ~((4294967295u << bitcast<u32>((((_e1492 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_2128_ = 4294967295u;
                                                    }
                                                    let _e1516 = phi_2128_;
                                                    phi_2130_ = _e975;
                                                    phi_2133_ = _e1516;
                                                    loop {
                                                        let _e1518 = phi_2130_;
                                                        let _e1520 = phi_2133_;
                                                        local_10 = _e1518;
                                                        let _e1521 = (_e1520 != 4294967295u);
                                                        if _e1521 {
                                                            if (_e1520 < _e76) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1528 = nodes.member[(0u + _e1520)].frame[3u];
                                                            let _e1553 = (bitcast<f32>((((_e1528 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1282);
                                                            let _e1554 = (bitcast<f32>((((_e1528 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1292);
                                                            let _e1555 = (bitcast<f32>((((_e1528 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1302);
                                                            let _e1558 = nodes.member[(0u + _e1520)].frame[0u];
                                                            let _e1562 = nodes.member[(0u + _e1520)].frame[1u];
                                                            let _e1566 = nodes.member[(0u + _e1520)].frame[2u];
                                                            let _e1571 = ((bitcast<f32>(_e1558) - _e1067) * _e1282);
                                                            let _e1572 = ((bitcast<f32>(_e1562) - _e1080) * _e1292);
                                                            let _e1573 = ((bitcast<f32>(_e1566) - _e1093) * _e1302);
                                                            let _e1581 = nodes.member[(0u + _e1520)].x;
                                                            if (_e1282 < 0f) {
                                                                let _e1592 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1581.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1598 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1592.unnamed.word, _e1581.w), _e1592.unnamed_1);
                                                                let _e1604 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1598.unnamed, lt_mask_LightPlace(_e1581.x, _e1598.unnamed_1.shift));
                                                                phi_2214_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1604.unnamed, lt_mask_LightPlace(_e1604.unnamed_1.word, _e1581.y));
                                                            } else {
                                                                let _e1620 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1581.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1626 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1620.unnamed.word, _e1581.y), _e1620.unnamed_1);
                                                                let _e1632 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1626.unnamed, lt_mask_LightPlace(_e1581.z, _e1626.unnamed_1.shift));
                                                                phi_2214_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1632.unnamed, lt_mask_LightPlace(_e1632.unnamed_1.word, _e1581.w));
                                                            }
                                                            let _e1640 = phi_2214_;
                                                            let _e1650 = nodes.member[(0u + _e1520)].y;
                                                            if (_e1292 < 0f) {
                                                                let _e1661 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1650.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1667 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1661.unnamed.word, _e1650.w), _e1661.unnamed_1);
                                                                let _e1673 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1667.unnamed, lt_mask_LightPlace(_e1650.x, _e1667.unnamed_1.shift));
                                                                phi_2241_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1673.unnamed, lt_mask_LightPlace(_e1673.unnamed_1.word, _e1650.y));
                                                            } else {
                                                                let _e1689 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1650.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1695 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1689.unnamed.word, _e1650.y), _e1689.unnamed_1);
                                                                let _e1701 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1695.unnamed, lt_mask_LightPlace(_e1650.z, _e1695.unnamed_1.shift));
                                                                phi_2241_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1701.unnamed, lt_mask_LightPlace(_e1701.unnamed_1.word, _e1650.w));
                                                            }
                                                            let _e1709 = phi_2241_;
                                                            let _e1719 = nodes.member[(0u + _e1520)].z;
                                                            if (_e1302 < 0f) {
                                                                let _e1730 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1719.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1736 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1730.unnamed.word, _e1719.w), _e1730.unnamed_1);
                                                                let _e1742 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1736.unnamed, lt_mask_LightPlace(_e1719.x, _e1736.unnamed_1.shift));
                                                                phi_2268_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1742.unnamed, lt_mask_LightPlace(_e1742.unnamed_1.word, _e1719.y));
                                                            } else {
                                                                let _e1758 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1719.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1764 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1758.unnamed.word, _e1719.y), _e1758.unnamed_1);
                                                                let _e1770 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1764.unnamed, lt_mask_LightPlace(_e1719.z, _e1764.unnamed_1.shift));
                                                                phi_2268_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1770.unnamed, lt_mask_LightPlace(_e1770.unnamed_1.word, _e1719.w));
                                                            }
                                                            let _e1778 = phi_2268_;
                                                            phi_2274_ = 0u;
                                                            phi_2277_ = 0u;
                                                            loop {
                                                                let _e1788 = phi_2274_;
                                                                let _e1790 = phi_2277_;
                                                                local_6 = _e1790;
                                                                local_7 = _e1790;
                                                                local_8 = _e1790;
                                                                let _e1791 = (_e1788 < 8u);
                                                                if _e1791 {
                                                                    let _e1793 = (_e1788 >> bitcast<u32>(2i));
                                                                    let _e1794 = (_e1788 & 3u);
                                                                    if (_e1793 == 0u) {
                                                                        phi_2291_ = _e1640.unnamed.word;
                                                                    } else {
                                                                        phi_2291_ = _e1640.unnamed.shift;
                                                                    }
                                                                    let _e1797 = phi_2291_;
                                                                    if (_e1793 == 0u) {
                                                                        phi_2301_ = _e1709.unnamed.word;
                                                                    } else {
                                                                        phi_2301_ = _e1709.unnamed.shift;
                                                                    }
                                                                    let _e1806 = phi_2301_;
                                                                    if (_e1793 == 0u) {
                                                                        phi_2311_ = _e1778.unnamed.word;
                                                                    } else {
                                                                        phi_2311_ = _e1778.unnamed.shift;
                                                                    }
                                                                    let _e1815 = phi_2311_;
                                                                    let _e1828 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1797 >> bitcast<u32>(((_e1794 * 8u) & 31u))) & 255u)) * _e1553) + (_e1571 - _e1330)), ((f32(((_e1806 >> bitcast<u32>(((_e1794 * 8u) & 31u))) & 255u)) * _e1554) + (_e1572 - _e1331)));
                                                                    let _e1829 = core_intrinsics_maximum_number_nsz_f32_(_e1828, ((f32(((_e1815 >> bitcast<u32>(((_e1794 * 8u) & 31u))) & 255u)) * _e1555) + (_e1573 - _e1332)));
                                                                    if (_e1793 == 0u) {
                                                                        phi_2329_ = _e1640.unnamed_1.word;
                                                                    } else {
                                                                        phi_2329_ = _e1640.unnamed_1.shift;
                                                                    }
                                                                    let _e1832 = phi_2329_;
                                                                    if (_e1793 == 0u) {
                                                                        phi_2339_ = _e1709.unnamed_1.word;
                                                                    } else {
                                                                        phi_2339_ = _e1709.unnamed_1.shift;
                                                                    }
                                                                    let _e1841 = phi_2339_;
                                                                    if (_e1793 == 0u) {
                                                                        phi_2349_ = _e1778.unnamed_1.word;
                                                                    } else {
                                                                        phi_2349_ = _e1778.unnamed_1.shift;
                                                                    }
                                                                    let _e1850 = phi_2349_;
                                                                    let _e1863 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1832 >> bitcast<u32>(((_e1794 * 8u) & 31u))) & 255u)) * _e1553) + (_e1571 + _e1330)), ((f32(((_e1841 >> bitcast<u32>(((_e1794 * 8u) & 31u))) & 255u)) * _e1554) + (_e1572 + _e1331)));
                                                                    let _e1864 = core_intrinsics_minimum_number_nsz_f32_(_e1863, ((f32(((_e1850 >> bitcast<u32>(((_e1794 * 8u) & 31u))) & 255u)) * _e1555) + (_e1573 + _e1332)));
                                                                    if (_e1829 <= _e1864) {
                                                                        if (_e1829 <= _e1518.t) {
                                                                            if (_e1864 >= _e157.tmin) {
                                                                                if (_e1793 == 0u) {
                                                                                    let _e1871 = nodes.member[(0u + _e1520)].links[2u];
                                                                                    phi_2385_ = _e1871;
                                                                                } else {
                                                                                    let _e1874 = nodes.member[(0u + _e1520)].links[3u];
                                                                                    phi_2385_ = _e1874;
                                                                                }
                                                                                let _e1876 = phi_2385_;
                                                                                let _e1881 = ((_e1876 >> bitcast<u32>(((_e1794 * 8u) & 31u))) & 255u);
                                                                                let _e1882 = (_e1881 & 31u);
                                                                                if (_e1882 >= 24u) {
                                                                                    phi_2398_ = (24u + ((_e1882 - 24u) ^ _e1380));
                                                                                } else {
                                                                                    phi_2398_ = _e1882;
                                                                                }
                                                                                let _e1888 = phi_2398_;
                                                                                phi_2403_ = (_e1790 | ((_e1881 >> bitcast<u32>(5i)) << bitcast<u32>((_e1888 & 31u))));
                                                                            } else {
                                                                                phi_2403_ = _e1790;
                                                                            }
                                                                            let _e1896 = phi_2403_;
                                                                            phi_2404_ = _e1896;
                                                                        } else {
                                                                            phi_2404_ = _e1790;
                                                                        }
                                                                        let _e1898 = phi_2404_;
                                                                        phi_2405_ = _e1898;
                                                                    } else {
                                                                        phi_2405_ = _e1790;
                                                                    }
                                                                    let _e1900 = phi_2405_;
                                                                    phi_2275_ = (_e1788 + 1u);
                                                                    phi_2278_ = _e1900;
                                                                } else {
                                                                    phi_2275_ = u32();
                                                                    phi_2278_ = u32();
                                                                }
                                                                let _e1903 = phi_2275_;
                                                                let _e1905 = phi_2278_;
                                                                continue;
                                                                continuing {
                                                                    phi_2274_ = _e1903;
                                                                    phi_2277_ = _e1905;
                                                                    break if !(_e1791);
                                                                }
                                                            }
                                                            let _e1909 = nodes.member[(0u + _e1520)].links[0u];
                                                            let _e1913 = nodes.member[(0u + _e1520)].frame[3u];
                                                            let _e1917 = local_6;
                                                            if ((_e1917 & 4278190080u) == 0u) {
                                                            } else {
                                                                let _e1921 = local_1.group_mask;
                                                                if ((_e1921 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1925 = local_1.len;
                                                                    if (_e1925 < 32u) {
                                                                        let _e1928 = local_1.group;
                                                                        let _e1930 = local_1.len;
                                                                        if (_e1930 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_1.first[(0u + _e1930)] = _e1928;
                                                                        let _e1936 = local_1.group_mask;
                                                                        let _e1938 = local_1.len;
                                                                        if (_e1938 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_1.mask[(0u + _e1938)] = _e1936;
                                                                        let _e1945 = local_1.len;
                                                                        local_1.len = (_e1945 + 1u);
                                                                    }
                                                                }
                                                                local_1.group = (_e1142 + _e1909);
                                                                let _e1949 = local_7;
                                                                local_1.group_mask = ((_e1949 & 4278190080u) | (_e1913 >> bitcast<u32>(24i)));
                                                            }
                                                            let _e1954 = local_8;
                                                            phi_2463_ = _e1518;
                                                            phi_2466_ = (_e1954 & 16777215u);
                                                            loop {
                                                                let _e1957 = phi_2463_;
                                                                let _e1959 = phi_2466_;
                                                                local_9 = _e1957;
                                                                if (_e1959 == 0u) {
                                                                    phi_2464_ = lt_bvh_Hit();
                                                                    phi_2467_ = u32();
                                                                    phi_3305_ = false;
                                                                } else {
                                                                    let _e1963 = nodes.member[(0u + _e1520)].links[1u];
                                                                    let _e1968 = ((_e1144 + _e1963) + select(firstTrailingBit(_e1959), 32u, (_e1959 == 0u)));
                                                                    if (_e1968 < _e79) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1975 = triangles.member[(0u + _e1968)].v0_;
                                                                    let _e1977 = (_e1975.x - _e1067);
                                                                    let _e1979 = (_e1975.y - _e1080);
                                                                    let _e1981 = (_e1975.z - _e1093);
                                                                    if (_e1353 == 0u) {
                                                                        phi_2511_ = vec3<f32>(_e1979, _e1981, _e1977);
                                                                    } else {
                                                                        if (_e1353 == 1u) {
                                                                            phi_2510_ = vec3<f32>(_e1981, _e1977, _e1979);
                                                                        } else {
                                                                            phi_2510_ = (_e1975 - vec3<f32>(_e1067, _e1080, _e1093));
                                                                        }
                                                                        let _e1989 = phi_2510_;
                                                                        phi_2511_ = _e1989;
                                                                    }
                                                                    let _e1991 = phi_2511_;
                                                                    let _e1995 = (_e1991.x - (_e1364 * _e1991.z));
                                                                    let _e1999 = (_e1991.y - (_e1367 * _e1991.z));
                                                                    let _e2001 = triangles.member[(0u + _e1968)].v1_;
                                                                    let _e2003 = (_e2001.x - _e1067);
                                                                    let _e2005 = (_e2001.y - _e1080);
                                                                    let _e2007 = (_e2001.z - _e1093);
                                                                    if (_e1353 == 0u) {
                                                                        phi_2541_ = vec3<f32>(_e2005, _e2007, _e2003);
                                                                    } else {
                                                                        if (_e1353 == 1u) {
                                                                            phi_2540_ = vec3<f32>(_e2007, _e2003, _e2005);
                                                                        } else {
                                                                            phi_2540_ = (_e2001 - vec3<f32>(_e1067, _e1080, _e1093));
                                                                        }
                                                                        let _e2015 = phi_2540_;
                                                                        phi_2541_ = _e2015;
                                                                    }
                                                                    let _e2017 = phi_2541_;
                                                                    let _e2021 = (_e2017.x - (_e1364 * _e2017.z));
                                                                    let _e2025 = (_e2017.y - (_e1367 * _e2017.z));
                                                                    let _e2027 = triangles.member[(0u + _e1968)].v2_;
                                                                    let _e2029 = (_e2027.x - _e1067);
                                                                    let _e2031 = (_e2027.y - _e1080);
                                                                    let _e2033 = (_e2027.z - _e1093);
                                                                    if (_e1353 == 0u) {
                                                                        phi_2571_ = vec3<f32>(_e2031, _e2033, _e2029);
                                                                    } else {
                                                                        if (_e1353 == 1u) {
                                                                            phi_2570_ = vec3<f32>(_e2033, _e2029, _e2031);
                                                                        } else {
                                                                            phi_2570_ = (_e2027 - vec3<f32>(_e1067, _e1080, _e1093));
                                                                        }
                                                                        let _e2041 = phi_2570_;
                                                                        phi_2571_ = _e2041;
                                                                    }
                                                                    let _e2043 = phi_2571_;
                                                                    let _e2047 = (_e2043.x - (_e1364 * _e2043.z));
                                                                    let _e2051 = (_e2043.y - (_e1367 * _e2043.z));
                                                                    if (_e2021 < _e2047) {
                                                                        phi_2590_ = true;
                                                                    } else {
                                                                        if (_e2021 == _e2047) {
                                                                            phi_2589_ = (_e2025 < _e2051);
                                                                        } else {
                                                                            phi_2589_ = false;
                                                                        }
                                                                        let _e2056 = phi_2589_;
                                                                        phi_2590_ = _e2056;
                                                                    }
                                                                    let _e2058 = phi_2590_;
                                                                    if _e2058 {
                                                                        phi_2594_ = _e2051;
                                                                        phi_2595_ = _e2047;
                                                                        phi_2596_ = _e2025;
                                                                        phi_2597_ = _e2021;
                                                                    } else {
                                                                        phi_2594_ = _e2025;
                                                                        phi_2595_ = _e2021;
                                                                        phi_2596_ = _e2051;
                                                                        phi_2597_ = _e2047;
                                                                    }
                                                                    let _e2060 = phi_2594_;
                                                                    let _e2062 = phi_2595_;
                                                                    let _e2064 = phi_2596_;
                                                                    let _e2066 = phi_2597_;
                                                                    let _e2069 = ((_e2066 * _e2060) - (_e2064 * _e2062));
                                                                    if _e2058 {
                                                                        phi_2605_ = -(_e2069);
                                                                    } else {
                                                                        phi_2605_ = _e2069;
                                                                    }
                                                                    let _e2072 = phi_2605_;
                                                                    if (_e2047 < _e1995) {
                                                                        phi_2616_ = true;
                                                                    } else {
                                                                        if (_e2047 == _e1995) {
                                                                            phi_2615_ = (_e2051 < _e1999);
                                                                        } else {
                                                                            phi_2615_ = false;
                                                                        }
                                                                        let _e2077 = phi_2615_;
                                                                        phi_2616_ = _e2077;
                                                                    }
                                                                    let _e2079 = phi_2616_;
                                                                    if _e2079 {
                                                                        phi_2620_ = _e1999;
                                                                        phi_2621_ = _e1995;
                                                                        phi_2622_ = _e2051;
                                                                        phi_2623_ = _e2047;
                                                                    } else {
                                                                        phi_2620_ = _e2051;
                                                                        phi_2621_ = _e2047;
                                                                        phi_2622_ = _e1999;
                                                                        phi_2623_ = _e1995;
                                                                    }
                                                                    let _e2081 = phi_2620_;
                                                                    let _e2083 = phi_2621_;
                                                                    let _e2085 = phi_2622_;
                                                                    let _e2087 = phi_2623_;
                                                                    let _e2090 = ((_e2087 * _e2081) - (_e2085 * _e2083));
                                                                    if _e2079 {
                                                                        phi_2631_ = -(_e2090);
                                                                    } else {
                                                                        phi_2631_ = _e2090;
                                                                    }
                                                                    let _e2093 = phi_2631_;
                                                                    if (_e1995 < _e2021) {
                                                                        phi_2642_ = true;
                                                                    } else {
                                                                        if (_e1995 == _e2021) {
                                                                            phi_2641_ = (_e1999 < _e2025);
                                                                        } else {
                                                                            phi_2641_ = false;
                                                                        }
                                                                        let _e2098 = phi_2641_;
                                                                        phi_2642_ = _e2098;
                                                                    }
                                                                    let _e2100 = phi_2642_;
                                                                    if _e2100 {
                                                                        phi_2646_ = _e2025;
                                                                        phi_2647_ = _e2021;
                                                                        phi_2648_ = _e1999;
                                                                        phi_2649_ = _e1995;
                                                                    } else {
                                                                        phi_2646_ = _e1999;
                                                                        phi_2647_ = _e1995;
                                                                        phi_2648_ = _e2025;
                                                                        phi_2649_ = _e2021;
                                                                    }
                                                                    let _e2102 = phi_2646_;
                                                                    let _e2104 = phi_2647_;
                                                                    let _e2106 = phi_2648_;
                                                                    let _e2108 = phi_2649_;
                                                                    let _e2111 = ((_e2108 * _e2102) - (_e2106 * _e2104));
                                                                    if _e2100 {
                                                                        phi_2657_ = -(_e2111);
                                                                    } else {
                                                                        phi_2657_ = _e2111;
                                                                    }
                                                                    let _e2114 = phi_2657_;
                                                                    if (_e2072 >= 0f) {
                                                                        if (_e2093 >= 0f) {
                                                                            if (_e2114 >= 0f) {
                                                                                phi_2672_ = ((_e2072 + _e2093) + _e2114);
                                                                                phi_2673_ = false;
                                                                            } else {
                                                                                phi_2672_ = f32();
                                                                                phi_2673_ = true;
                                                                            }
                                                                            let _e2121 = phi_2672_;
                                                                            let _e2123 = phi_2673_;
                                                                            phi_2674_ = _e2121;
                                                                            phi_2675_ = _e2123;
                                                                        } else {
                                                                            phi_2674_ = f32();
                                                                            phi_2675_ = true;
                                                                        }
                                                                        let _e2125 = phi_2674_;
                                                                        let _e2127 = phi_2675_;
                                                                        phi_2676_ = _e2125;
                                                                        phi_2677_ = _e2127;
                                                                    } else {
                                                                        phi_2676_ = f32();
                                                                        phi_2677_ = true;
                                                                    }
                                                                    let _e2129 = phi_2676_;
                                                                    let _e2131 = phi_2677_;
                                                                    if _e2131 {
                                                                        if (_e2072 <= 0f) {
                                                                            if (_e2093 <= 0f) {
                                                                                let _e2134 = (_e2114 <= 0f);
                                                                                if _e2134 {
                                                                                }
                                                                                phi_2695_ = ((_e2072 + _e2093) + _e2114);
                                                                                phi_2696_ = false;
                                                                                phi_2697_ = _e2134;
                                                                            } else {
                                                                                phi_2695_ = f32();
                                                                                phi_2696_ = true;
                                                                                phi_2697_ = false;
                                                                            }
                                                                            let _e2138 = phi_2695_;
                                                                            let _e2140 = phi_2696_;
                                                                            let _e2142 = phi_2697_;
                                                                            phi_2698_ = _e2138;
                                                                            phi_2699_ = _e2140;
                                                                            phi_2700_ = _e2142;
                                                                        } else {
                                                                            phi_2698_ = f32();
                                                                            phi_2699_ = true;
                                                                            phi_2700_ = false;
                                                                        }
                                                                        let _e2144 = phi_2698_;
                                                                        let _e2146 = phi_2699_;
                                                                        let _e2148 = phi_2700_;
                                                                        if _e2146 {
                                                                            phi_2704_ = false;
                                                                        } else {
                                                                            phi_2704_ = _e2148;
                                                                        }
                                                                        let _e2150 = phi_2704_;
                                                                        phi_2705_ = _e2144;
                                                                        phi_2706_ = _e2150;
                                                                    } else {
                                                                        phi_2705_ = _e2129;
                                                                        phi_2706_ = true;
                                                                    }
                                                                    let _e2152 = phi_2705_;
                                                                    let _e2154 = phi_2706_;
                                                                    if _e2154 {
                                                                        let _e2155 = (_e2152 == 0f);
                                                                        if _e2155 {
                                                                            phi_3022_ = lt_bvh_triangle_Intersection();
                                                                            phi_3023_ = false;
                                                                        } else {
                                                                            let _e2157 = triangles.member[(0u + _e1968)].v0_;
                                                                            let _e2159 = (_e2157.x - _e1067);
                                                                            let _e2161 = (_e2157.y - _e1080);
                                                                            let _e2163 = (_e2157.z - _e1093);
                                                                            if (_e1353 == 0u) {
                                                                                phi_2735_ = vec3<f32>(_e2161, _e2163, _e2159);
                                                                            } else {
                                                                                if (_e1353 == 1u) {
                                                                                    phi_2734_ = vec3<f32>(_e2163, _e2159, _e2161);
                                                                                } else {
                                                                                    phi_2734_ = (_e2157 - vec3<f32>(_e1067, _e1080, _e1093));
                                                                                }
                                                                                let _e2171 = phi_2734_;
                                                                                phi_2735_ = _e2171;
                                                                            }
                                                                            let _e2173 = phi_2735_;
                                                                            let _e2175 = triangles.member[(0u + _e1968)].v1_;
                                                                            let _e2177 = triangles.member[(0u + _e1968)].v0_;
                                                                            let _e2180 = (_e2175.x - _e2177.x);
                                                                            let _e2183 = (_e2175.y - _e2177.y);
                                                                            let _e2186 = (_e2175.z - _e2177.z);
                                                                            if (_e1353 == 0u) {
                                                                                phi_2761_ = vec3<f32>(_e2183, _e2186, _e2180);
                                                                            } else {
                                                                                if (_e1353 == 1u) {
                                                                                    phi_2760_ = vec3<f32>(_e2186, _e2180, _e2183);
                                                                                } else {
                                                                                    phi_2760_ = (_e2175 - _e2177);
                                                                                }
                                                                                let _e2193 = phi_2760_;
                                                                                phi_2761_ = _e2193;
                                                                            }
                                                                            let _e2195 = phi_2761_;
                                                                            let _e2197 = triangles.member[(0u + _e1968)].v2_;
                                                                            let _e2199 = triangles.member[(0u + _e1968)].v0_;
                                                                            let _e2202 = (_e2197.x - _e2199.x);
                                                                            let _e2205 = (_e2197.y - _e2199.y);
                                                                            let _e2208 = (_e2197.z - _e2199.z);
                                                                            if (_e1353 == 0u) {
                                                                                phi_2787_ = vec3<f32>(_e2205, _e2208, _e2202);
                                                                            } else {
                                                                                if (_e1353 == 1u) {
                                                                                    phi_2786_ = vec3<f32>(_e2208, _e2202, _e2205);
                                                                                } else {
                                                                                    phi_2786_ = (_e2197 - _e2199);
                                                                                }
                                                                                let _e2215 = phi_2786_;
                                                                                phi_2787_ = _e2215;
                                                                            }
                                                                            let _e2217 = phi_2787_;
                                                                            let _e2224 = ((_e2195.y * _e2217.z) - (_e2195.z * _e2217.y));
                                                                            let _e2231 = ((_e2195.z * _e2217.x) - (_e2195.x * _e2217.z));
                                                                            let _e2238 = ((_e2195.x * _e2217.y) - (_e2195.y * _e2217.x));
                                                                            let _e2252 = (((1f / _e1361.z) * (((_e2224 * _e2173.x) + (_e2231 * _e2173.y)) + (_e2238 * _e2173.z))) / (((_e2224 * _e1364) + (_e2231 * _e1367)) + _e2238));
                                                                            if (_e2252 > _e157.tmin) {
                                                                                if (_e2252 < _e157.tmax) {
                                                                                    let _e2256 = triangles.member[(0u + _e1968)].v0_;
                                                                                    let _e2258 = triangles.member[(0u + _e1968)].v1_;
                                                                                    if (_e2256.x < _e2258.x) {
                                                                                        phi_2843_ = _e2256.x;
                                                                                    } else {
                                                                                        phi_2843_ = _e2258.x;
                                                                                    }
                                                                                    let _e2265 = phi_2843_;
                                                                                    if (_e2256.y < _e2258.y) {
                                                                                        phi_2852_ = _e2256.y;
                                                                                    } else {
                                                                                        phi_2852_ = _e2258.y;
                                                                                    }
                                                                                    let _e2272 = phi_2852_;
                                                                                    if (_e2256.z < _e2258.z) {
                                                                                        phi_2861_ = _e2256.z;
                                                                                    } else {
                                                                                        phi_2861_ = _e2258.z;
                                                                                    }
                                                                                    let _e2279 = phi_2861_;
                                                                                    let _e2281 = triangles.member[(0u + _e1968)].v2_;
                                                                                    if (_e2265 < _e2281.x) {
                                                                                        phi_2870_ = _e2265;
                                                                                    } else {
                                                                                        phi_2870_ = _e2281.x;
                                                                                    }
                                                                                    let _e2286 = phi_2870_;
                                                                                    if (_e2272 < _e2281.y) {
                                                                                        phi_2877_ = _e2272;
                                                                                    } else {
                                                                                        phi_2877_ = _e2281.y;
                                                                                    }
                                                                                    let _e2291 = phi_2877_;
                                                                                    if (_e2279 < _e2281.z) {
                                                                                        phi_2884_ = _e2279;
                                                                                    } else {
                                                                                        phi_2884_ = _e2281.z;
                                                                                    }
                                                                                    let _e2296 = phi_2884_;
                                                                                    let _e2298 = triangles.member[(0u + _e1968)].v0_;
                                                                                    let _e2300 = triangles.member[(0u + _e1968)].v1_;
                                                                                    if (_e2298.x > _e2300.x) {
                                                                                        phi_2897_ = _e2298.x;
                                                                                    } else {
                                                                                        phi_2897_ = _e2300.x;
                                                                                    }
                                                                                    let _e2307 = phi_2897_;
                                                                                    if (_e2298.y > _e2300.y) {
                                                                                        phi_2906_ = _e2298.y;
                                                                                    } else {
                                                                                        phi_2906_ = _e2300.y;
                                                                                    }
                                                                                    let _e2314 = phi_2906_;
                                                                                    if (_e2298.z > _e2300.z) {
                                                                                        phi_2915_ = _e2298.z;
                                                                                    } else {
                                                                                        phi_2915_ = _e2300.z;
                                                                                    }
                                                                                    let _e2321 = phi_2915_;
                                                                                    let _e2323 = triangles.member[(0u + _e1968)].v2_;
                                                                                    if (_e2307 > _e2323.x) {
                                                                                        phi_2924_ = _e2307;
                                                                                    } else {
                                                                                        phi_2924_ = _e2323.x;
                                                                                    }
                                                                                    let _e2328 = phi_2924_;
                                                                                    if (_e2314 > _e2323.y) {
                                                                                        phi_2931_ = _e2314;
                                                                                    } else {
                                                                                        phi_2931_ = _e2323.y;
                                                                                    }
                                                                                    let _e2333 = phi_2931_;
                                                                                    if (_e2321 > _e2323.z) {
                                                                                        phi_2938_ = _e2321;
                                                                                    } else {
                                                                                        phi_2938_ = _e2323.z;
                                                                                    }
                                                                                    let _e2338 = phi_2938_;
                                                                                    let _e2342 = ((_e2286 - _e1067) * _e1282);
                                                                                    let _e2343 = ((_e2291 - _e1080) * _e1292);
                                                                                    let _e2344 = ((_e2296 - _e1093) * _e1302);
                                                                                    let _e2348 = ((_e2328 - _e1067) * _e1282);
                                                                                    let _e2349 = ((_e2333 - _e1080) * _e1292);
                                                                                    let _e2350 = ((_e2338 - _e1093) * _e1302);
                                                                                    if (_e2342 < _e2348) {
                                                                                        phi_2955_ = _e2342;
                                                                                    } else {
                                                                                        phi_2955_ = _e2348;
                                                                                    }
                                                                                    let _e2353 = phi_2955_;
                                                                                    if (_e2343 < _e2349) {
                                                                                        phi_2960_ = _e2343;
                                                                                    } else {
                                                                                        phi_2960_ = _e2349;
                                                                                    }
                                                                                    let _e2356 = phi_2960_;
                                                                                    if (_e2344 < _e2350) {
                                                                                        phi_2965_ = _e2344;
                                                                                    } else {
                                                                                        phi_2965_ = _e2350;
                                                                                    }
                                                                                    let _e2359 = phi_2965_;
                                                                                    if (_e2342 > _e2348) {
                                                                                        phi_2973_ = _e2342;
                                                                                    } else {
                                                                                        phi_2973_ = _e2348;
                                                                                    }
                                                                                    let _e2365 = phi_2973_;
                                                                                    if (_e2343 > _e2349) {
                                                                                        phi_2978_ = _e2343;
                                                                                    } else {
                                                                                        phi_2978_ = _e2349;
                                                                                    }
                                                                                    let _e2368 = phi_2978_;
                                                                                    if (_e2344 > _e2350) {
                                                                                        phi_2983_ = _e2344;
                                                                                    } else {
                                                                                        phi_2983_ = _e2350;
                                                                                    }
                                                                                    let _e2371 = phi_2983_;
                                                                                    let _e2375 = core_intrinsics_maximum_number_nsz_f32_((_e2353 - _e1337), (_e2356 - _e1338));
                                                                                    let _e2376 = core_intrinsics_maximum_number_nsz_f32_(_e2375, (_e2359 - _e1339));
                                                                                    let _e2377 = core_intrinsics_minimum_number_nsz_f32_((_e2365 + _e1337), (_e2368 + _e1338));
                                                                                    let _e2378 = core_intrinsics_minimum_number_nsz_f32_(_e2377, (_e2371 + _e1339));
                                                                                    if (_e2376 > _e1042) {
                                                                                        phi_2995_ = _e2376;
                                                                                    } else {
                                                                                        phi_2995_ = _e1042;
                                                                                    }
                                                                                    let _e2381 = phi_2995_;
                                                                                    if (_e2378 < _e1044) {
                                                                                        phi_3000_ = _e2378;
                                                                                    } else {
                                                                                        phi_3000_ = _e1044;
                                                                                    }
                                                                                    let _e2384 = phi_3000_;
                                                                                    if (_e2252 < _e2381) {
                                                                                        phi_3005_ = _e2381;
                                                                                    } else {
                                                                                        phi_3005_ = _e2252;
                                                                                    }
                                                                                    let _e2387 = phi_3005_;
                                                                                    if (_e2387 > _e2384) {
                                                                                        phi_3010_ = _e2384;
                                                                                    } else {
                                                                                        phi_3010_ = _e2387;
                                                                                    }
                                                                                    let _e2390 = phi_3010_;
                                                                                    phi_3015_ = lt_bvh_triangle_Intersection(_e2390, (_e2093 / _e2152), (_e2114 / _e2152), (_e2381 <= _e2384));
                                                                                    phi_3016_ = false;
                                                                                } else {
                                                                                    phi_3015_ = lt_bvh_triangle_Intersection();
                                                                                    phi_3016_ = true;
                                                                                }
                                                                                let _e2396 = phi_3015_;
                                                                                let _e2398 = phi_3016_;
                                                                                phi_3017_ = _e2396;
                                                                                phi_3018_ = _e2398;
                                                                            } else {
                                                                                phi_3017_ = lt_bvh_triangle_Intersection();
                                                                                phi_3018_ = true;
                                                                            }
                                                                            let _e2400 = phi_3017_;
                                                                            let _e2402 = phi_3018_;
                                                                            if _e2402 {
                                                                            }
                                                                            phi_3022_ = _e2400;
                                                                            phi_3023_ = _e2402;
                                                                        }
                                                                        let _e2404 = phi_3022_;
                                                                        let _e2406 = phi_3023_;
                                                                        phi_3024_ = _e2404;
                                                                        phi_3025_ = _e2155;
                                                                        phi_3026_ = _e2406;
                                                                    } else {
                                                                        phi_3024_ = lt_bvh_triangle_Intersection();
                                                                        phi_3025_ = true;
                                                                        phi_3026_ = false;
                                                                    }
                                                                    let _e2408 = phi_3024_;
                                                                    let _e2410 = phi_3025_;
                                                                    let _e2412 = phi_3026_;
                                                                    if _e2410 {
                                                                        phi_3030_ = true;
                                                                    } else {
                                                                        phi_3030_ = _e2412;
                                                                    }
                                                                    let _e2414 = phi_3030_;
                                                                    if _e2414 {
                                                                        phi_3034_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_3034_ = _e2408;
                                                                    }
                                                                    let _e2416 = phi_3034_;
                                                                    if _e2416.is_hit {
                                                                        if (_e2416.t > _e157.tmin) {
                                                                            if (_e2416.t < _e1957.t) {
                                                                                phi_3082_ = true;
                                                                            } else {
                                                                                if (_e2416.t == _e1957.t) {
                                                                                    if (_e1957.triangle != 4294967295u) {
                                                                                        if (_e1968 < _e1957.triangle) {
                                                                                            phi_3073_ = true;
                                                                                        } else {
                                                                                            if (_e1968 == _e1957.triangle) {
                                                                                                phi_3072_ = (_e983 < _e1957.instance);
                                                                                            } else {
                                                                                                phi_3072_ = false;
                                                                                            }
                                                                                            let _e2434 = phi_3072_;
                                                                                            phi_3073_ = _e2434;
                                                                                        }
                                                                                        let _e2436 = phi_3073_;
                                                                                        phi_3074_ = _e2436;
                                                                                        phi_3075_ = false;
                                                                                    } else {
                                                                                        phi_3074_ = bool();
                                                                                        phi_3075_ = true;
                                                                                    }
                                                                                    let _e2438 = phi_3074_;
                                                                                    let _e2440 = phi_3075_;
                                                                                    phi_3076_ = _e2438;
                                                                                    phi_3077_ = _e2440;
                                                                                } else {
                                                                                    phi_3076_ = bool();
                                                                                    phi_3077_ = true;
                                                                                }
                                                                                let _e2442 = phi_3076_;
                                                                                let _e2444 = phi_3077_;
                                                                                if _e2444 {
                                                                                    phi_3081_ = false;
                                                                                } else {
                                                                                    phi_3081_ = _e2442;
                                                                                }
                                                                                let _e2446 = phi_3081_;
                                                                                phi_3082_ = _e2446;
                                                                            }
                                                                            let _e2448 = phi_3082_;
                                                                            if _e2448 {
                                                                                let _e2450 = triangles.member[(0u + _e1968)].i0_;
                                                                                if ((_e2450 & 2147483648u) == 0u) {
                                                                                    phi_3293_ = true;
                                                                                } else {
                                                                                    if (_e1968 < _e79) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2459 = triangles.member[(0u + _e1968)].i0_;
                                                                                    let _e2460 = (_e2459 & 2147483647u);
                                                                                    let _e2462 = triangles.member[(0u + _e1968)].i1_;
                                                                                    let _e2464 = triangles.member[(0u + _e1968)].i2_;
                                                                                    if (_e2460 < _e82) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2468 = vertices.member[(0u + _e2460)];
                                                                                    if (_e2462 < _e82) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2472 = vertices.member[(0u + _e2462)];
                                                                                    if (_e2464 < _e82) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2476 = vertices.member[(0u + _e2464)];
                                                                                    let _e2477 = array<abi_Vertex, 3>(_e2468, _e2472, _e2476);
                                                                                    if (_e2477[0].material < _e85) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2483 = materials.member[(0u + _e2477[0].material)];
                                                                                    if ((_e2483.flags & 0u) == 0u) {
                                                                                        let _e2488 = ((1f - _e2416.u) - _e2416.v);
                                                                                        if (_e2483.cutoff <= 0f) {
                                                                                            phi_3288_ = true;
                                                                                        } else {
                                                                                            let _e2515 = (_e2483.base_color.w * ((((f32((_e2477[0].color >> bitcast<u32>(24i))) * _e2488) + (f32((_e2477[1].color >> bitcast<u32>(24i))) * _e2416.u)) + (f32((_e2477[2].color >> bitcast<u32>(24i))) * _e2416.v)) * (1f / 255f)));
                                                                                            if (_e2483.alpha_size == 0u) {
                                                                                                phi_3285_ = _e2515;
                                                                                            } else {
                                                                                                local.offset = _e2483.alpha_offset;
                                                                                                local.size = _e2483.alpha_size;
                                                                                                local.flags = _e2483.flags;
                                                                                                let _e2546 = _lt_shaders_texture_TextureView_quad((&local), (((_e2477[0].u * _e2488) + (_e2477[1].u * _e2416.u)) + (_e2477[2].u * _e2416.v)), (((_e2477[0].v * _e2488) + (_e2477[1].v * _e2416.u)) + (_e2477[2].v * _e2416.v)));
                                                                                                let _e2550 = (_e2546.indices[0] >> bitcast<u32>(2i));
                                                                                                if (_e2550 < _e94) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2554 = alpha_texels.member[(0u + _e2550)];
                                                                                                let _e2570 = (_e2546.indices[1] >> bitcast<u32>(2i));
                                                                                                if (_e2570 < _e94) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2574 = alpha_texels.member[(0u + _e2570)];
                                                                                                let _e2591 = (_e2546.indices[2] >> bitcast<u32>(2i));
                                                                                                if (_e2591 < _e94) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2595 = alpha_texels.member[(0u + _e2591)];
                                                                                                let _e2612 = (_e2546.indices[3] >> bitcast<u32>(2i));
                                                                                                if (_e2612 < _e94) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2616 = alpha_texels.member[(0u + _e2612)];
                                                                                                phi_3285_ = (_e2515 * (((((f32(((_e2554 >> bitcast<u32>((((_e2546.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2546.weights.x) + ((f32(((_e2574 >> bitcast<u32>((((_e2546.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2546.weights.y)) + ((f32(((_e2595 >> bitcast<u32>((((_e2546.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2546.weights.z)) + ((f32(((_e2616 >> bitcast<u32>((((_e2546.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2546.weights.w)));
                                                                                            }
                                                                                            let _e2632 = phi_3285_;
                                                                                            phi_3288_ = (_e2632 >= _e2483.cutoff);
                                                                                        }
                                                                                        let _e2636 = phi_3288_;
                                                                                        phi_3289_ = _e2636;
                                                                                    } else {
                                                                                        phi_3289_ = false;
                                                                                    }
                                                                                    let _e2638 = phi_3289_;
                                                                                    if _e2638 {
                                                                                    }
                                                                                    phi_3293_ = _e2638;
                                                                                }
                                                                                let _e2640 = phi_3293_;
                                                                                if _e2640 {
                                                                                    phi_3301_ = lt_bvh_Hit(_e2416.t, _e2416.u, _e2416.v, _e1968, _e983);
                                                                                } else {
                                                                                    phi_3301_ = _e1957;
                                                                                }
                                                                                let _e2646 = phi_3301_;
                                                                                phi_3302_ = _e2646;
                                                                            } else {
                                                                                phi_3302_ = _e1957;
                                                                            }
                                                                            let _e2648 = phi_3302_;
                                                                            phi_3303_ = _e2648;
                                                                        } else {
                                                                            phi_3303_ = _e1957;
                                                                        }
                                                                        let _e2650 = phi_3303_;
                                                                        phi_3304_ = _e2650;
                                                                    } else {
                                                                        phi_3304_ = _e1957;
                                                                    }
                                                                    let _e2652 = phi_3304_;
                                                                    phi_2464_ = _e2652;
                                                                    phi_2467_ = (_e1959 & (_e1959 - 1u));
                                                                    phi_3305_ = true;
                                                                }
                                                                let _e2654 = phi_2464_;
                                                                let _e2656 = phi_2467_;
                                                                let _e2658 = phi_3305_;
                                                                continue;
                                                                continuing {
                                                                    phi_2463_ = _e2654;
                                                                    phi_2466_ = _e2656;
                                                                    break if !(_e2658);
                                                                }
                                                            }
                                                            let _e2661 = local_1.group_mask;
                                                            if ((_e2661 & 4278190080u) == 0u) {
                                                                let _e2665 = local_1.len;
                                                                if (_e2665 == 0u) {
                                                                    phi_3344_ = false;
                                                                } else {
                                                                    let _e2669 = local_1.len;
                                                                    local_1.len = (_e2669 - 1u);
                                                                    let _e2672 = local_1.len;
                                                                    if (_e2672 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2677 = local_1.first[(0u + _e2672)];
                                                                    local_1.group = _e2677;
                                                                    let _e2680 = local_1.len;
                                                                    if (_e2680 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2685 = local_1.mask[(0u + _e2680)];
                                                                    local_1.group_mask = _e2685;
                                                                    phi_3344_ = true;
                                                                }
                                                                let _e2688 = phi_3344_;
                                                                phi_3345_ = _e2688;
                                                            } else {
                                                                phi_3345_ = true;
                                                            }
                                                            let _e2690 = phi_3345_;
                                                            if _e2690 {
                                                                let _e2692 = local_1.group_mask;
                                                                let _e2698 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2692)), 32u, (_e2692 == 0u)));
                                                                let _e2702 = local_1.group_mask;
                                                                let _e2716 = local_1.group_mask;
                                                                local_1.group_mask = (_e2716 & ~((1u << bitcast<u32>((_e2698 & 31u)))));
                                                                let _e2719 = local_1.group;
                                                                phi_3376_ = (_e2719 + countOneBits(((_e2702 & ~((4294967295u << bitcast<u32>((((_e2698 - 24u) ^ _e1380) & 31u))))) & 255u)));
                                                            } else {
                                                                phi_3376_ = 4294967295u;
                                                            }
                                                            let _e2722 = phi_3376_;
                                                            let _e3711 = local_9;
                                                            phi_2131_ = _e3711;
                                                            phi_2134_ = _e2722;
                                                        } else {
                                                            phi_2131_ = lt_bvh_Hit();
                                                            phi_2134_ = u32();
                                                        }
                                                        let _e2724 = phi_2131_;
                                                        let _e2726 = phi_2134_;
                                                        continue;
                                                        continuing {
                                                            phi_2130_ = _e2724;
                                                            phi_2133_ = _e2726;
                                                            break if !(_e1521);
                                                        }
                                                    }
                                                    let _e3715 = local_10;
                                                    phi_3377_ = _e3715;
                                                }
                                                let _e2729 = phi_3377_;
                                                phi_3378_ = _e2729;
                                                phi_3379_ = _e1206;
                                            } else {
                                                phi_3378_ = lt_bvh_Hit();
                                                phi_3379_ = true;
                                            }
                                            let _e2731 = phi_3378_;
                                            let _e2733 = phi_3379_;
                                            if _e2733 {
                                                phi_3383_ = _e975;
                                            } else {
                                                phi_3383_ = _e2731;
                                            }
                                            let _e2735 = phi_3383_;
                                            phi_3384_ = _e2735;
                                        } else {
                                            phi_3384_ = _e975;
                                        }
                                        let _e2737 = phi_3384_;
                                        phi_3385_ = _e2737;
                                    } else {
                                        phi_3385_ = _e975;
                                    }
                                    let _e2739 = phi_3385_;
                                    phi_3386_ = _e2739;
                                } else {
                                    phi_3386_ = _e975;
                                }
                                let _e2741 = phi_3386_;
                                phi_1505_ = (_e973 & (_e973 - 1u));
                                phi_1508_ = _e2741;
                                phi_3387_ = true;
                            }
                            let _e2743 = phi_1505_;
                            let _e2745 = phi_1508_;
                            let _e2747 = phi_3387_;
                            continue;
                            continuing {
                                phi_1504_ = _e2743;
                                phi_1507_ = _e2745;
                                break if !(_e2747);
                            }
                        }
                        let _e2750 = local_2.group_mask;
                        if ((_e2750 & 4278190080u) == 0u) {
                            let _e2754 = local_2.len;
                            if (_e2754 == 0u) {
                                phi_3426_ = false;
                            } else {
                                let _e2758 = local_2.len;
                                local_2.len = (_e2758 - 1u);
                                let _e2761 = local_2.len;
                                if (_e2761 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2766 = local_2.first[(0u + _e2761)];
                                local_2.group = _e2766;
                                let _e2769 = local_2.len;
                                if (_e2769 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2774 = local_2.mask[(0u + _e2769)];
                                local_2.group_mask = _e2774;
                                phi_3426_ = true;
                            }
                            let _e2777 = phi_3426_;
                            phi_3427_ = _e2777;
                        } else {
                            phi_3427_ = true;
                        }
                        let _e2779 = phi_3427_;
                        if _e2779 {
                            let _e2781 = local_2.group_mask;
                            let _e2787 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2781)), 32u, (_e2781 == 0u)));
                            let _e2791 = local_2.group_mask;
                            let _e2805 = local_2.group_mask;
                            local_2.group_mask = (_e2805 & ~((1u << bitcast<u32>((_e2787 & 31u)))));
                            let _e2808 = local_2.group;
                            phi_3458_ = (_e2808 + countOneBits(((_e2791 & ~((4294967295u << bitcast<u32>((((_e2787 - 24u) ^ _e392) & 31u))))) & 255u)));
                        } else {
                            phi_3458_ = 4294967295u;
                        }
                        let _e2811 = phi_3458_;
                        phi_1168_ = _e2811;
                        let _e3731 = local_11;
                        phi_1171_ = _e3731;
                    } else {
                        phi_1168_ = u32();
                        phi_1171_ = lt_bvh_Hit();
                    }
                    let _e2813 = phi_1168_;
                    let _e2815 = phi_1171_;
                    continue;
                    continuing {
                        phi_1167_ = _e2813;
                        phi_1170_ = _e2815;
                        break if !(_e533);
                    }
                }
                let _e3734 = local_12;
                phi_3459_ = _e3734;
            }
            let _e2818 = phi_3459_;
            phi_3460_ = _e2818;
            phi_3461_ = _e229;
        } else {
            phi_3460_ = lt_bvh_Hit();
            phi_3461_ = true;
        }
        let _e2820 = phi_3460_;
        let _e2822 = phi_3461_;
        if _e2822 {
            phi_3465_ = _e159;
        } else {
            phi_3465_ = _e2820;
        }
        let _e2824 = phi_3465_;
        if (_e2824.triangle != 4294967295u) {
            let _e2830 = ((1f - _e2824.u) - _e2824.v);
            if (_e2824.triangle < _e79) {
            } else {
                return;
            }
            let _e2836 = triangles.member[(0u + _e2824.triangle)];
            if (_e2824.instance < _e91) {
            } else {
                return;
            }
            let _e2847 = instances.member[(0u + _e2824.instance)].object_to_world[0u];
            let _e2858 = ((((_e2847.x * _e2836.v0_.x) + (_e2847.y * _e2836.v0_.y)) + (_e2847.z * _e2836.v0_.z)) + (_e2847.w * 1f));
            let _e2860 = instances.member[(0u + _e2824.instance)].object_to_world[1u];
            let _e2871 = ((((_e2860.x * _e2836.v0_.x) + (_e2860.y * _e2836.v0_.y)) + (_e2860.z * _e2836.v0_.z)) + (_e2860.w * 1f));
            let _e2873 = instances.member[(0u + _e2824.instance)].object_to_world[2u];
            let _e2884 = ((((_e2873.x * _e2836.v0_.x) + (_e2873.y * _e2836.v0_.y)) + (_e2873.z * _e2836.v0_.z)) + (_e2873.w * 1f));
            let _e2891 = instances.member[(0u + _e2824.instance)].object_to_world[0u];
            let _e2902 = ((((_e2891.x * _e2836.v1_.x) + (_e2891.y * _e2836.v1_.y)) + (_e2891.z * _e2836.v1_.z)) + (_e2891.w * 1f));
            let _e2904 = instances.member[(0u + _e2824.instance)].object_to_world[1u];
            let _e2915 = ((((_e2904.x * _e2836.v1_.x) + (_e2904.y * _e2836.v1_.y)) + (_e2904.z * _e2836.v1_.z)) + (_e2904.w * 1f));
            let _e2917 = instances.member[(0u + _e2824.instance)].object_to_world[2u];
            let _e2928 = ((((_e2917.x * _e2836.v1_.x) + (_e2917.y * _e2836.v1_.y)) + (_e2917.z * _e2836.v1_.z)) + (_e2917.w * 1f));
            let _e2935 = instances.member[(0u + _e2824.instance)].object_to_world[0u];
            let _e2946 = ((((_e2935.x * _e2836.v2_.x) + (_e2935.y * _e2836.v2_.y)) + (_e2935.z * _e2836.v2_.z)) + (_e2935.w * 1f));
            let _e2948 = instances.member[(0u + _e2824.instance)].object_to_world[1u];
            let _e2959 = ((((_e2948.x * _e2836.v2_.x) + (_e2948.y * _e2836.v2_.y)) + (_e2948.z * _e2836.v2_.z)) + (_e2948.w * 1f));
            let _e2961 = instances.member[(0u + _e2824.instance)].object_to_world[2u];
            let _e2972 = ((((_e2961.x * _e2836.v2_.x) + (_e2961.y * _e2836.v2_.y)) + (_e2961.z * _e2836.v2_.z)) + (_e2961.w * 1f));
            let _e2985 = (((_e2858 * _e2830) + (_e2902 * _e2824.u)) + (_e2946 * _e2824.v));
            let _e2986 = (((_e2871 * _e2830) + (_e2915 * _e2824.u)) + (_e2959 * _e2824.v));
            let _e2987 = (((_e2884 * _e2830) + (_e2928 * _e2824.u)) + (_e2972 * _e2824.v));
            let _e2989 = abs(_e2858);
            let _e2990 = abs(_e2871);
            let _e2991 = abs(_e2884);
            let _e2992 = abs(_e2902);
            let _e2993 = abs(_e2915);
            let _e2994 = abs(_e2928);
            if (_e2989 > _e2992) {
                phi_3653_ = _e2989;
            } else {
                phi_3653_ = _e2992;
            }
            let _e2997 = phi_3653_;
            if (_e2990 > _e2993) {
                phi_3658_ = _e2990;
            } else {
                phi_3658_ = _e2993;
            }
            let _e3000 = phi_3658_;
            if (_e2991 > _e2994) {
                phi_3663_ = _e2991;
            } else {
                phi_3663_ = _e2994;
            }
            let _e3003 = phi_3663_;
            let _e3004 = abs(_e2946);
            let _e3005 = abs(_e2959);
            let _e3006 = abs(_e2972);
            if (_e2997 > _e3004) {
                phi_3671_ = _e2997;
            } else {
                phi_3671_ = _e3004;
            }
            let _e3009 = phi_3671_;
            if (_e3000 > _e3005) {
                phi_3676_ = _e3000;
            } else {
                phi_3676_ = _e3005;
            }
            let _e3012 = phi_3676_;
            if (_e3003 > _e3006) {
                phi_3681_ = _e3003;
            } else {
                phi_3681_ = _e3006;
            }
            let _e3015 = phi_3681_;
            let _e3016 = (_e2902 - _e2858);
            let _e3017 = (_e2915 - _e2871);
            let _e3018 = (_e2928 - _e2884);
            let _e3019 = (_e2946 - _e2858);
            let _e3020 = (_e2959 - _e2871);
            let _e3021 = (_e2972 - _e2884);
            let _e3025 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3017), abs(_e3018));
            let _e3026 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3016), _e3025);
            let _e3027 = (_e3016 / _e3026);
            let _e3028 = (_e3017 / _e3026);
            let _e3029 = (_e3018 / _e3026);
            let _e3033 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3020), abs(_e3021));
            let _e3034 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3019), _e3033);
            let _e3035 = (_e3019 / _e3034);
            let _e3036 = (_e3020 / _e3034);
            let _e3037 = (_e3021 / _e3034);
            let _e3040 = ((_e3028 * _e3037) - (_e3036 * _e3029));
            let _e3043 = ((_e3029 * _e3035) - (_e3037 * _e3027));
            let _e3046 = ((_e3027 * _e3036) - (_e3035 * _e3028));
            let _e3048 = p.member.eye;
            let _e3061 = (1f / sqrt((((_e3040 * _e3040) + (_e3043 * _e3043)) + (_e3046 * _e3046))));
            let _e3062 = (_e3040 * _e3061);
            let _e3063 = (_e3043 * _e3061);
            let _e3064 = (_e3046 * _e3061);
            if ((((_e3062 * (_e3048.x - _e2985)) + (_e3063 * (_e3048.y - _e2986))) + (_e3064 * (_e3048.z - _e2987))) < 0f) {
                phi_3745_ = vec3<f32>(-(_e3062), -(_e3063), -(_e3064));
            } else {
                phi_3745_ = vec3<f32>(_e3062, _e3063, _e3064);
            }
            let _e3077 = phi_3745_;
            if (_e2824.triangle < _e79) {
            } else {
                return;
            }
            let _e3082 = triangles.member[(0u + _e2824.triangle)];
            let _e3084 = (_e3082.i0_ & 2147483647u);
            if (_e3084 < _e82) {
            } else {
                return;
            }
            let _e3090 = vertices.member[(0u + _e3084)];
            if (_e3082.i1_ < _e82) {
            } else {
                return;
            }
            let _e3094 = vertices.member[(0u + _e3082.i1_)];
            if (_e3082.i2_ < _e82) {
            } else {
                return;
            }
            let _e3098 = vertices.member[(0u + _e3082.i2_)];
            let _e3099 = array<abi_Vertex, 3>(_e3090, _e3094, _e3098);
            if (_e3099[0].material < _e85) {
            } else {
                return;
            }
            let _e3105 = materials.member[(0u + _e3099[0].material)];
            let _e3122 = (1f / 255f);
            let _e3141 = (1f / 255f);
            let _e3163 = (1f / 255f);
            let _e3176 = _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(vec3<f32>(_e2830, _e2824.u, _e2824.v));
            let _e3178 = ((_e3105.base_color.x * ((((f32((_e3099[0].color & 255u)) * _e3122) * _e2830) + ((f32((_e3099[1].color & 255u)) * _e3141) * _e2824.u)) + ((f32((_e3099[2].color & 255u)) * _e3163) * _e2824.v))) * _e3176.x);
            let _e3180 = ((_e3105.base_color.y * ((((f32(((_e3099[0].color >> bitcast<u32>(8i)) & 255u)) * _e3122) * _e2830) + ((f32(((_e3099[1].color >> bitcast<u32>(8i)) & 255u)) * _e3141) * _e2824.u)) + ((f32(((_e3099[2].color >> bitcast<u32>(8i)) & 255u)) * _e3163) * _e2824.v))) * _e3176.y);
            let _e3182 = ((_e3105.base_color.z * ((((f32(((_e3099[0].color >> bitcast<u32>(16i)) & 255u)) * _e3122) * _e2830) + ((f32(((_e3099[1].color >> bitcast<u32>(16i)) & 255u)) * _e3141) * _e2824.u)) + ((f32(((_e3099[2].color >> bitcast<u32>(16i)) & 255u)) * _e3163) * _e2824.v))) * _e3176.z);
            let _e3183 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e3012, _e3015);
            let _e3184 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e3009, _e3183);
            if ((_e3105.flags & 2u) == 0u) {
                phi_3866_ = 0u;
            } else {
                phi_3866_ = 1u;
            }
            let _e3189 = phi_3866_;
            if (_e3099[0].normal == 2147516416u) {
                phi_4096_ = _e3077;
            } else {
                let _e3202 = (f32((bitcast<i32>((_e3099[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3208 = (f32((bitcast<i32>(_e3099[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3212 = ((1f - abs(_e3202)) - abs(_e3208));
                if (_e3212 < 0f) {
                    phi_3893_ = -(_e3212);
                } else {
                    phi_3893_ = 0f;
                }
                let _e3216 = phi_3893_;
                if (_e3202 < 0f) {
                    phi_3900_ = (_e3202 + _e3216);
                } else {
                    phi_3900_ = (_e3202 - _e3216);
                }
                let _e3221 = phi_3900_;
                if (_e3208 < 0f) {
                    phi_3907_ = (_e3208 + _e3216);
                } else {
                    phi_3907_ = (_e3208 - _e3216);
                }
                let _e3226 = phi_3907_;
                let _e3233 = (1f / sqrt((((_e3221 * _e3221) + (_e3226 * _e3226)) + (_e3212 * _e3212))));
                let _e3249 = (f32((bitcast<i32>((_e3099[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3255 = (f32((bitcast<i32>(_e3099[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3259 = ((1f - abs(_e3249)) - abs(_e3255));
                if (_e3259 < 0f) {
                    phi_3942_ = -(_e3259);
                } else {
                    phi_3942_ = 0f;
                }
                let _e3263 = phi_3942_;
                if (_e3249 < 0f) {
                    phi_3949_ = (_e3249 + _e3263);
                } else {
                    phi_3949_ = (_e3249 - _e3263);
                }
                let _e3268 = phi_3949_;
                if (_e3255 < 0f) {
                    phi_3956_ = (_e3255 + _e3263);
                } else {
                    phi_3956_ = (_e3255 - _e3263);
                }
                let _e3273 = phi_3956_;
                let _e3280 = (1f / sqrt((((_e3268 * _e3268) + (_e3273 * _e3273)) + (_e3259 * _e3259))));
                let _e3299 = (f32((bitcast<i32>((_e3099[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3305 = (f32((bitcast<i32>(_e3099[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3309 = ((1f - abs(_e3299)) - abs(_e3305));
                if (_e3309 < 0f) {
                    phi_3994_ = -(_e3309);
                } else {
                    phi_3994_ = 0f;
                }
                let _e3313 = phi_3994_;
                if (_e3299 < 0f) {
                    phi_4001_ = (_e3299 + _e3313);
                } else {
                    phi_4001_ = (_e3299 - _e3313);
                }
                let _e3318 = phi_4001_;
                if (_e3305 < 0f) {
                    phi_4008_ = (_e3305 + _e3313);
                } else {
                    phi_4008_ = (_e3305 - _e3313);
                }
                let _e3323 = phi_4008_;
                let _e3330 = (1f / sqrt((((_e3318 * _e3318) + (_e3323 * _e3323)) + (_e3309 * _e3309))));
                let _e3337 = ((((_e3221 * _e3233) * _e2830) + ((_e3268 * _e3280) * _e2824.u)) + ((_e3318 * _e3330) * _e2824.v));
                let _e3338 = ((((_e3226 * _e3233) * _e2830) + ((_e3273 * _e3280) * _e2824.u)) + ((_e3323 * _e3330) * _e2824.v));
                let _e3339 = ((((_e3212 * _e3233) * _e2830) + ((_e3259 * _e3280) * _e2824.u)) + ((_e3309 * _e3330) * _e2824.v));
                if (_e2824.instance < _e91) {
                } else {
                    return;
                }
                let _e3346 = instances.member[(0u + _e2824.instance)].world_to_object[0u];
                let _e3355 = instances.member[(0u + _e2824.instance)].world_to_object[1u];
                let _e3367 = instances.member[(0u + _e2824.instance)].world_to_object[2u];
                let _e3374 = (((_e3346.x * _e3337) + (_e3355.x * _e3338)) + (_e3367.x * _e3339));
                let _e3375 = (((_e3346.y * _e3337) + (_e3355.y * _e3338)) + (_e3367.y * _e3339));
                let _e3376 = (((_e3346.z * _e3337) + (_e3355.z * _e3338)) + (_e3367.z * _e3339));
                let _e3382 = sqrt((((_e3374 * _e3374) + (_e3375 * _e3375)) + (_e3376 * _e3376)));
                if (_e3382 > 0f) {
                    let _e3384 = (_e3374 / _e3382);
                    let _e3385 = (_e3375 / _e3382);
                    let _e3386 = (_e3376 / _e3382);
                    if ((((_e3384 * _e3077.x) + (_e3385 * _e3077.y)) + (_e3386 * _e3077.z)) < 0f) {
                        phi_4094_ = vec3<f32>(-(_e3384), -(_e3385), -(_e3386));
                    } else {
                        phi_4094_ = vec3<f32>(_e3384, _e3385, _e3386);
                    }
                    let _e3402 = phi_4094_;
                    phi_4095_ = _e3402;
                } else {
                    phi_4095_ = _e3077;
                }
                let _e3404 = phi_4095_;
                phi_4096_ = _e3404;
            }
            let _e3406 = phi_4096_;
            if (_e3178 > 0f) {
                if (_e3178 < 1f) {
                    phi_4105_ = _e3178;
                } else {
                    phi_4105_ = 1f;
                }
                let _e3410 = phi_4105_;
                phi_4106_ = _e3410;
            } else {
                phi_4106_ = 0f;
            }
            let _e3412 = phi_4106_;
            if (_e3180 > 0f) {
                if (_e3180 < 1f) {
                    phi_4116_ = _e3180;
                } else {
                    phi_4116_ = 1f;
                }
                let _e3417 = phi_4116_;
                phi_4117_ = _e3417;
            } else {
                phi_4117_ = 0f;
            }
            let _e3419 = phi_4117_;
            if (_e3182 > 0f) {
                if (_e3182 < 1f) {
                    phi_4127_ = _e3182;
                } else {
                    phi_4127_ = 1f;
                }
                let _e3424 = phi_4127_;
                phi_4128_ = _e3424;
            } else {
                phi_4128_ = 0f;
            }
            let _e3426 = phi_4128_;
            let _e3429 = ((sqrt(_e3412) * 255f) + 0.5f);
            let _e3438 = ((sqrt(_e3419) * 255f) + 0.5f);
            let _e3450 = ((sqrt(_e3426) * 255f) + 0.5f);
            phi_4163_ = abi_Sample(vec3<f32>(_e2985, _e2986, _e2987), _e3184, _e3077, _e3189, _e3406, ((select(select(u32(_e3429), 0u, (_e3429 < bitcast<f32>(0u))), 4294967295u, (_e3429 > bitcast<f32>(1333788671u))) | (select(select(u32(_e3438), 0u, (_e3438 < bitcast<f32>(0u))), 4294967295u, (_e3438 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e3450), 0u, (_e3450 < bitcast<f32>(0u))), 4294967295u, (_e3450 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_4163_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e3464 = phi_4163_;
        if (_e100.shift < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e100.shift)] = _e3464;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_instanced_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
