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
                let _e305 = phi_915_;
                if (_e157.direction.x < 0f) {
                    phi_922_ = (-1f / _e305);
                } else {
                    phi_922_ = (1f / _e305);
                }
                let _e310 = phi_922_;
                if (abs(_e157.direction.y) < _e299) {
                    phi_930_ = _e299;
                } else {
                    phi_930_ = abs(_e157.direction.y);
                }
                let _e316 = phi_930_;
                if (_e157.direction.y < 0f) {
                    phi_937_ = (-1f / _e316);
                } else {
                    phi_937_ = (1f / _e316);
                }
                let _e321 = phi_937_;
                if (abs(_e157.direction.z) < _e299) {
                    phi_945_ = _e299;
                } else {
                    phi_945_ = abs(_e157.direction.z);
                }
                let _e327 = phi_945_;
                if (_e157.direction.z < 0f) {
                    phi_952_ = (-1f / _e327);
                } else {
                    phi_952_ = (1f / _e327);
                }
                let _e332 = phi_952_;
                let _e340 = abs((bitcast<f32>(_e235) - _e157.origin.x));
                let _e341 = abs((bitcast<f32>(_e239) - _e157.origin.y));
                let _e342 = abs((bitcast<f32>(_e243) - _e157.origin.z));
                let _e350 = abs(((bitcast<f32>(_e247) + (bitcast<f32>((((_e259 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e157.origin.x));
                let _e351 = abs(((bitcast<f32>(_e251) + (bitcast<f32>((((_e259 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e157.origin.y));
                let _e352 = abs(((bitcast<f32>(_e255) + (bitcast<f32>((((_e259 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e157.origin.z));
                if (_e340 > _e350) {
                    phi_977_ = _e340;
                } else {
                    phi_977_ = _e350;
                }
                let _e355 = phi_977_;
                if (_e341 > _e351) {
                    phi_982_ = _e341;
                } else {
                    phi_982_ = _e351;
                }
                let _e358 = phi_982_;
                if (_e342 > _e352) {
                    phi_987_ = _e342;
                } else {
                    phi_987_ = _e352;
                }
                let _e361 = phi_987_;
                let _e362 = core_intrinsics_maximum_number_nsz_f32_(_e355, _e358);
                let _e363 = core_intrinsics_maximum_number_nsz_f32_(_e362, _e361);
                let _e368 = (_e363 * 0.0000019073486f);
                let _e369 = (abs(_e310) * _e368);
                let _e370 = (abs(_e321) * _e368);
                let _e371 = (abs(_e332) * _e368);
                let _e375 = (_e363 * 0.0000009536743f);
                let _e376 = (abs(_e310) * _e375);
                let _e377 = (abs(_e321) * _e375);
                let _e378 = (abs(_e332) * _e375);
                if (_e310 < 0f) {
                    phi_1009_ = 0u;
                } else {
                    phi_1009_ = 1u;
                }
                let _e381 = phi_1009_;
                if (_e321 < 0f) {
                    phi_1014_ = 0u;
                } else {
                    phi_1014_ = 2u;
                }
                let _e384 = phi_1014_;
                if (_e332 < 0f) {
                    phi_1019_ = 0u;
                } else {
                    phi_1019_ = 4u;
                }
                let _e387 = phi_1019_;
                let _e389 = ((_e381 | _e384) | _e387);
                let _e390 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e106, 2147483648u);
                local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e390.first[0], _e390.first[1], _e390.first[2], _e390.first[3], _e390.first[4], _e390.first[5], _e390.first[6], _e390.first[7], _e390.first[8], _e390.first[9], _e390.first[10], _e390.first[11], _e390.first[12], _e390.first[13], _e390.first[14], _e390.first[15], _e390.first[16], _e390.first[17], _e390.first[18], _e390.first[19], _e390.first[20], _e390.first[21], _e390.first[22], _e390.first[23], _e390.first[24], _e390.first[25], _e390.first[26], _e390.first[27], _e390.first[28], _e390.first[29], _e390.first[30], _e390.first[31]), array<u32, 32>(_e390.mask[0], _e390.mask[1], _e390.mask[2], _e390.mask[3], _e390.mask[4], _e390.mask[5], _e390.mask[6], _e390.mask[7], _e390.mask[8], _e390.mask[9], _e390.mask[10], _e390.mask[11], _e390.mask[12], _e390.mask[13], _e390.mask[14], _e390.mask[15], _e390.mask[16], _e390.mask[17], _e390.mask[18], _e390.mask[19], _e390.mask[20], _e390.mask[21], _e390.mask[22], _e390.mask[23], _e390.mask[24], _e390.mask[25], _e390.mask[26], _e390.mask[27], _e390.mask[28], _e390.mask[29], _e390.mask[30], _e390.mask[31]), _e390.len, _e390.group, _e390.group_mask);
                let _e464 = local_2.group_mask;
                if ((_e464 & 4278190080u) == 0u) {
                    let _e468 = local_2.len;
                    if (_e468 == 0u) {
                        phi_1133_ = false;
                    } else {
                        let _e472 = local_2.len;
                        local_2.len = (_e472 - 1u);
                        let _e475 = local_2.len;
                        if (_e475 < 32u) {
                        } else {
                            return;
                        }
                        let _e480 = local_2.first[(0u + _e475)];
                        local_2.group = _e480;
                        let _e483 = local_2.len;
                        if (_e483 < 32u) {
                        } else {
                            return;
                        }
                        let _e488 = local_2.mask[(0u + _e483)];
                        local_2.group_mask = _e488;
                        phi_1133_ = true;
                    }
                    let _e491 = phi_1133_;
                    phi_1134_ = _e491;
                } else {
                    phi_1134_ = true;
                }
                let _e493 = phi_1134_;
                if _e493 {
                    let _e495 = local_2.group_mask;
                    let _e501 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e495)), 32u, (_e495 == 0u)));
                    let _e505 = local_2.group_mask;
                    let _e519 = local_2.group_mask;
                    local_2.group_mask = (_e519 & ~((1u << bitcast<u32>((_e501 & 31u)))));
                    let _e522 = local_2.group;
                    phi_1165_ = (_e522 + countOneBits(((_e505 & ~((4294967295u << bitcast<u32>((((_e501 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1165_ = 4294967295u;
                }
                let _e525 = phi_1165_;
                phi_1167_ = _e525;
                phi_1170_ = _e159;
                loop {
                    let _e527 = phi_1167_;
                    let _e529 = phi_1170_;
                    local_12 = _e529;
                    let _e530 = (_e527 != 4294967295u);
                    if _e530 {
                        if (_e527 < _e76) {
                        } else {
                            return;
                        }
                        let _e538 = nodes.member[(0u + _e527)].frame[3u];
                        let _e563 = (bitcast<f32>((((_e538 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e310);
                        let _e564 = (bitcast<f32>((((_e538 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e321);
                        let _e565 = (bitcast<f32>((((_e538 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e332);
                        let _e568 = nodes.member[(0u + _e527)].frame[0u];
                        let _e572 = nodes.member[(0u + _e527)].frame[1u];
                        let _e576 = nodes.member[(0u + _e527)].frame[2u];
                        let _e584 = ((bitcast<f32>(_e568) - _e157.origin.x) * _e310);
                        let _e585 = ((bitcast<f32>(_e572) - _e157.origin.y) * _e321);
                        let _e586 = ((bitcast<f32>(_e576) - _e157.origin.z) * _e332);
                        let _e594 = nodes.member[(0u + _e527)].x;
                        if (_e310 < 0f) {
                            let _e605 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e594.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e611 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e605.unnamed.word, _e594.w), _e605.unnamed_1);
                            let _e617 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e611.unnamed, lt_mask_LightPlace(_e594.x, _e611.unnamed_1.shift));
                            phi_1255_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e617.unnamed, lt_mask_LightPlace(_e617.unnamed_1.word, _e594.y));
                        } else {
                            let _e633 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e594.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e639 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e633.unnamed.word, _e594.y), _e633.unnamed_1);
                            let _e645 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e639.unnamed, lt_mask_LightPlace(_e594.z, _e639.unnamed_1.shift));
                            phi_1255_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e645.unnamed, lt_mask_LightPlace(_e645.unnamed_1.word, _e594.w));
                        }
                        let _e653 = phi_1255_;
                        let _e663 = nodes.member[(0u + _e527)].y;
                        if (_e321 < 0f) {
                            let _e674 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e663.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e680 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e674.unnamed.word, _e663.w), _e674.unnamed_1);
                            let _e686 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e680.unnamed, lt_mask_LightPlace(_e663.x, _e680.unnamed_1.shift));
                            phi_1282_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e686.unnamed, lt_mask_LightPlace(_e686.unnamed_1.word, _e663.y));
                        } else {
                            let _e702 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e663.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e708 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e702.unnamed.word, _e663.y), _e702.unnamed_1);
                            let _e714 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e708.unnamed, lt_mask_LightPlace(_e663.z, _e708.unnamed_1.shift));
                            phi_1282_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e714.unnamed, lt_mask_LightPlace(_e714.unnamed_1.word, _e663.w));
                        }
                        let _e722 = phi_1282_;
                        let _e732 = nodes.member[(0u + _e527)].z;
                        if (_e332 < 0f) {
                            let _e743 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e732.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e749 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e743.unnamed.word, _e732.w), _e743.unnamed_1);
                            let _e755 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e749.unnamed, lt_mask_LightPlace(_e732.x, _e749.unnamed_1.shift));
                            phi_1309_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e755.unnamed, lt_mask_LightPlace(_e755.unnamed_1.word, _e732.y));
                        } else {
                            let _e771 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e732.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e777 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e771.unnamed.word, _e732.y), _e771.unnamed_1);
                            let _e783 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e777.unnamed, lt_mask_LightPlace(_e732.z, _e777.unnamed_1.shift));
                            phi_1309_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e783.unnamed, lt_mask_LightPlace(_e783.unnamed_1.word, _e732.w));
                        }
                        let _e791 = phi_1309_;
                        phi_1315_ = 0u;
                        phi_1318_ = 0u;
                        loop {
                            let _e801 = phi_1315_;
                            let _e803 = phi_1318_;
                            local_3 = _e803;
                            local_4 = _e803;
                            local_5 = _e803;
                            let _e804 = (_e801 < 8u);
                            if _e804 {
                                let _e806 = (_e801 >> bitcast<u32>(2i));
                                let _e807 = (_e801 & 3u);
                                if (_e806 == 0u) {
                                    phi_1332_ = _e653.unnamed.word;
                                } else {
                                    phi_1332_ = _e653.unnamed.shift;
                                }
                                let _e810 = phi_1332_;
                                if (_e806 == 0u) {
                                    phi_1342_ = _e722.unnamed.word;
                                } else {
                                    phi_1342_ = _e722.unnamed.shift;
                                }
                                let _e819 = phi_1342_;
                                if (_e806 == 0u) {
                                    phi_1352_ = _e791.unnamed.word;
                                } else {
                                    phi_1352_ = _e791.unnamed.shift;
                                }
                                let _e828 = phi_1352_;
                                let _e841 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e810 >> bitcast<u32>(((_e807 * 8u) & 31u))) & 255u)) * _e563) + (_e584 - _e369)), ((f32(((_e819 >> bitcast<u32>(((_e807 * 8u) & 31u))) & 255u)) * _e564) + (_e585 - _e370)));
                                let _e842 = core_intrinsics_maximum_number_nsz_f32_(_e841, ((f32(((_e828 >> bitcast<u32>(((_e807 * 8u) & 31u))) & 255u)) * _e565) + (_e586 - _e371)));
                                if (_e806 == 0u) {
                                    phi_1370_ = _e653.unnamed_1.word;
                                } else {
                                    phi_1370_ = _e653.unnamed_1.shift;
                                }
                                let _e845 = phi_1370_;
                                if (_e806 == 0u) {
                                    phi_1380_ = _e722.unnamed_1.word;
                                } else {
                                    phi_1380_ = _e722.unnamed_1.shift;
                                }
                                let _e854 = phi_1380_;
                                if (_e806 == 0u) {
                                    phi_1390_ = _e791.unnamed_1.word;
                                } else {
                                    phi_1390_ = _e791.unnamed_1.shift;
                                }
                                let _e863 = phi_1390_;
                                let _e876 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e845 >> bitcast<u32>(((_e807 * 8u) & 31u))) & 255u)) * _e563) + (_e584 + _e369)), ((f32(((_e854 >> bitcast<u32>(((_e807 * 8u) & 31u))) & 255u)) * _e564) + (_e585 + _e370)));
                                let _e877 = core_intrinsics_minimum_number_nsz_f32_(_e876, ((f32(((_e863 >> bitcast<u32>(((_e807 * 8u) & 31u))) & 255u)) * _e565) + (_e586 + _e371)));
                                if (_e842 <= _e877) {
                                    if (_e842 <= _e529.t) {
                                        if (_e877 >= _e157.tmin) {
                                            if (_e806 == 0u) {
                                                let _e884 = nodes.member[(0u + _e527)].links[2u];
                                                phi_1426_ = _e884;
                                            } else {
                                                let _e887 = nodes.member[(0u + _e527)].links[3u];
                                                phi_1426_ = _e887;
                                            }
                                            let _e889 = phi_1426_;
                                            let _e894 = ((_e889 >> bitcast<u32>(((_e807 * 8u) & 31u))) & 255u);
                                            let _e895 = (_e894 & 31u);
                                            if (_e895 >= 24u) {
                                                phi_1439_ = (24u + ((_e895 - 24u) ^ _e389));
                                            } else {
                                                phi_1439_ = _e895;
                                            }
                                            let _e901 = phi_1439_;
                                            phi_1444_ = (_e803 | ((_e894 >> bitcast<u32>(5i)) << bitcast<u32>((_e901 & 31u))));
                                        } else {
                                            phi_1444_ = _e803;
                                        }
                                        let _e909 = phi_1444_;
                                        phi_1445_ = _e909;
                                    } else {
                                        phi_1445_ = _e803;
                                    }
                                    let _e911 = phi_1445_;
                                    phi_1446_ = _e911;
                                } else {
                                    phi_1446_ = _e803;
                                }
                                let _e913 = phi_1446_;
                                phi_1316_ = (_e801 + 1u);
                                phi_1319_ = _e913;
                            } else {
                                phi_1316_ = u32();
                                phi_1319_ = u32();
                            }
                            let _e916 = phi_1316_;
                            let _e918 = phi_1319_;
                            continue;
                            continuing {
                                phi_1315_ = _e916;
                                phi_1318_ = _e918;
                                break if !(_e804);
                            }
                        }
                        let _e922 = nodes.member[(0u + _e527)].links[0u];
                        let _e926 = nodes.member[(0u + _e527)].frame[3u];
                        let _e930 = local_3;
                        if ((_e930 & 4278190080u) == 0u) {
                        } else {
                            let _e934 = local_2.group_mask;
                            if ((_e934 & 4278190080u) == 0u) {
                            } else {
                                let _e938 = local_2.len;
                                if (_e938 < 32u) {
                                    let _e941 = local_2.group;
                                    let _e943 = local_2.len;
                                    if (_e943 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.first[(0u + _e943)] = _e941;
                                    let _e949 = local_2.group_mask;
                                    let _e951 = local_2.len;
                                    if (_e951 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.mask[(0u + _e951)] = _e949;
                                    let _e958 = local_2.len;
                                    local_2.len = (_e958 + 1u);
                                }
                            }
                            local_2.group = (_e106 + _e922);
                            let _e962 = local_4;
                            local_2.group_mask = ((_e962 & 4278190080u) | (_e926 >> bitcast<u32>(24i)));
                        }
                        let _e967 = local_5;
                        phi_1504_ = (_e967 & 16777215u);
                        phi_1507_ = _e529;
                        loop {
                            let _e970 = phi_1504_;
                            let _e972 = phi_1507_;
                            local_11 = _e972;
                            if (_e970 == 0u) {
                                phi_1505_ = u32();
                                phi_1508_ = lt_bvh_Hit();
                                phi_3387_ = false;
                            } else {
                                let _e976 = nodes.member[(0u + _e527)].links[1u];
                                let _e980 = (_e976 + select(firstTrailingBit(_e970), 32u, (_e970 == 0u)));
                                if (_e980 < _e91) {
                                } else {
                                    return;
                                }
                                let _e987 = instances.member[(0u + _e980)].low_world;
                                let _e989 = instances.member[(0u + _e980)].high_world;
                                let _e999 = ((_e987.x - _e157.origin.x) * _e310);
                                let _e1000 = ((_e987.y - _e157.origin.y) * _e321);
                                let _e1001 = ((_e987.z - _e157.origin.z) * _e332);
                                let _e1011 = ((_e989.x - _e157.origin.x) * _e310);
                                let _e1012 = ((_e989.y - _e157.origin.y) * _e321);
                                let _e1013 = ((_e989.z - _e157.origin.z) * _e332);
                                if (_e999 < _e1011) {
                                    phi_1562_ = _e999;
                                } else {
                                    phi_1562_ = _e1011;
                                }
                                let _e1016 = phi_1562_;
                                if (_e1000 < _e1012) {
                                    phi_1567_ = _e1000;
                                } else {
                                    phi_1567_ = _e1012;
                                }
                                let _e1019 = phi_1567_;
                                if (_e1001 < _e1013) {
                                    phi_1572_ = _e1001;
                                } else {
                                    phi_1572_ = _e1013;
                                }
                                let _e1022 = phi_1572_;
                                if (_e999 > _e1011) {
                                    phi_1580_ = _e999;
                                } else {
                                    phi_1580_ = _e1011;
                                }
                                let _e1028 = phi_1580_;
                                if (_e1000 > _e1012) {
                                    phi_1585_ = _e1000;
                                } else {
                                    phi_1585_ = _e1012;
                                }
                                let _e1031 = phi_1585_;
                                if (_e1001 > _e1013) {
                                    phi_1590_ = _e1001;
                                } else {
                                    phi_1590_ = _e1013;
                                }
                                let _e1034 = phi_1590_;
                                let _e1038 = core_intrinsics_maximum_number_nsz_f32_((_e1016 - _e376), (_e1019 - _e377));
                                let _e1039 = core_intrinsics_maximum_number_nsz_f32_(_e1038, (_e1022 - _e378));
                                let _e1040 = core_intrinsics_minimum_number_nsz_f32_((_e1028 + _e376), (_e1031 + _e377));
                                let _e1041 = core_intrinsics_minimum_number_nsz_f32_(_e1040, (_e1034 + _e378));
                                if (_e1039 <= _e1041) {
                                    if (_e1039 <= _e972.t) {
                                        if (_e1041 >= _e157.tmin) {
                                            let _e1053 = instances.member[(0u + _e980)].world_to_object[0u];
                                            let _e1064 = ((((_e1053.x * _e157.origin.x) + (_e1053.y * _e157.origin.y)) + (_e1053.z * _e157.origin.z)) + (_e1053.w * 1f));
                                            let _e1066 = instances.member[(0u + _e980)].world_to_object[1u];
                                            let _e1077 = ((((_e1066.x * _e157.origin.x) + (_e1066.y * _e157.origin.y)) + (_e1066.z * _e157.origin.z)) + (_e1066.w * 1f));
                                            let _e1079 = instances.member[(0u + _e980)].world_to_object[2u];
                                            let _e1090 = ((((_e1079.x * _e157.origin.x) + (_e1079.y * _e157.origin.y)) + (_e1079.z * _e157.origin.z)) + (_e1079.w * 1f));
                                            let _e1097 = instances.member[(0u + _e980)].world_to_object[0u];
                                            let _e1108 = ((((_e1097.x * _e157.direction.x) + (_e1097.y * _e157.direction.y)) + (_e1097.z * _e157.direction.z)) + (_e1097.w * 0f));
                                            let _e1110 = instances.member[(0u + _e980)].world_to_object[1u];
                                            let _e1121 = ((((_e1110.x * _e157.direction.x) + (_e1110.y * _e157.direction.y)) + (_e1110.z * _e157.direction.z)) + (_e1110.w * 0f));
                                            let _e1123 = instances.member[(0u + _e980)].world_to_object[2u];
                                            let _e1134 = ((((_e1123.x * _e157.direction.x) + (_e1123.y * _e157.direction.y)) + (_e1123.z * _e157.direction.z)) + (_e1123.w * 0f));
                                            let _e1139 = instances.member[(0u + _e980)].root;
                                            let _e1141 = instances.member[(0u + _e980)].first_triangle;
                                            let _e1145 = abs(_e1108);
                                            let _e1146 = abs(_e1121);
                                            let _e1147 = abs(_e1134);
                                            if (abs(_e1064) < 1000000000000000f) {
                                                if (abs(_e1077) < 1000000000000000f) {
                                                    if (abs(_e1090) < 1000000000000000f) {
                                                        if (_e1145 < 1000000000000000f) {
                                                            if (_e1146 < 1000000000000000f) {
                                                                if (_e1147 < 1000000000000000f) {
                                                                    if (_e1145 > 0f) {
                                                                        phi_1747_ = bool();
                                                                        phi_1748_ = true;
                                                                    } else {
                                                                        let _e1155 = (_e1146 > 0f);
                                                                        if _e1155 {
                                                                            phi_1746_ = bool();
                                                                        } else {
                                                                            phi_1746_ = (_e1147 > 0f);
                                                                        }
                                                                        let _e1158 = phi_1746_;
                                                                        phi_1747_ = _e1158;
                                                                        phi_1748_ = _e1155;
                                                                    }
                                                                    let _e1160 = phi_1747_;
                                                                    let _e1162 = phi_1748_;
                                                                    if _e1162 {
                                                                        phi_1752_ = true;
                                                                    } else {
                                                                        phi_1752_ = _e1160;
                                                                    }
                                                                    let _e1164 = phi_1752_;
                                                                    phi_1753_ = _e1164;
                                                                    phi_1754_ = false;
                                                                } else {
                                                                    phi_1753_ = bool();
                                                                    phi_1754_ = true;
                                                                }
                                                                let _e1166 = phi_1753_;
                                                                let _e1168 = phi_1754_;
                                                                phi_1755_ = _e1166;
                                                                phi_1756_ = false;
                                                                phi_1757_ = _e1168;
                                                            } else {
                                                                phi_1755_ = bool();
                                                                phi_1756_ = true;
                                                                phi_1757_ = false;
                                                            }
                                                            let _e1170 = phi_1755_;
                                                            let _e1172 = phi_1756_;
                                                            let _e1174 = phi_1757_;
                                                            phi_1758_ = _e1170;
                                                            phi_1759_ = _e1172;
                                                            phi_1760_ = _e1174;
                                                        } else {
                                                            phi_1758_ = bool();
                                                            phi_1759_ = true;
                                                            phi_1760_ = false;
                                                        }
                                                        let _e1176 = phi_1758_;
                                                        let _e1178 = phi_1759_;
                                                        let _e1180 = phi_1760_;
                                                        phi_1761_ = _e1176;
                                                        phi_1762_ = _e1178;
                                                        phi_1763_ = _e1180;
                                                    } else {
                                                        phi_1761_ = bool();
                                                        phi_1762_ = true;
                                                        phi_1763_ = false;
                                                    }
                                                    let _e1182 = phi_1761_;
                                                    let _e1184 = phi_1762_;
                                                    let _e1186 = phi_1763_;
                                                    phi_1764_ = _e1182;
                                                    phi_1765_ = _e1184;
                                                    phi_1766_ = _e1186;
                                                } else {
                                                    phi_1764_ = bool();
                                                    phi_1765_ = true;
                                                    phi_1766_ = false;
                                                }
                                                let _e1188 = phi_1764_;
                                                let _e1190 = phi_1765_;
                                                let _e1192 = phi_1766_;
                                                phi_1767_ = _e1188;
                                                phi_1768_ = _e1190;
                                                phi_1769_ = _e1192;
                                            } else {
                                                phi_1767_ = bool();
                                                phi_1768_ = true;
                                                phi_1769_ = false;
                                            }
                                            let _e1194 = phi_1767_;
                                            let _e1196 = phi_1768_;
                                            let _e1198 = phi_1769_;
                                            if _e1196 {
                                                phi_1773_ = true;
                                            } else {
                                                phi_1773_ = _e1198;
                                            }
                                            let _e1200 = phi_1773_;
                                            if _e1200 {
                                                phi_1777_ = false;
                                            } else {
                                                phi_1777_ = _e1194;
                                            }
                                            let _e1202 = phi_1777_;
                                            if _e1202 {
                                                let _e1203 = (_e1139 >= _e76);
                                                if _e1203 {
                                                    phi_3377_ = lt_bvh_Hit();
                                                } else {
                                                    if (_e1139 < _e76) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1209 = nodes.member[(0u + _e1139)].frame[0u];
                                                    let _e1213 = nodes.member[(0u + _e1139)].frame[1u];
                                                    let _e1217 = nodes.member[(0u + _e1139)].frame[2u];
                                                    let _e1221 = nodes.member[(0u + _e1139)].frame[0u];
                                                    let _e1225 = nodes.member[(0u + _e1139)].frame[1u];
                                                    let _e1229 = nodes.member[(0u + _e1139)].frame[2u];
                                                    let _e1233 = nodes.member[(0u + _e1139)].frame[3u];
                                                    let _e1267 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1108), abs(_e1121));
                                                    let _e1268 = core_intrinsics_maximum_number_nsz_f32_(_e1267, abs(_e1134));
                                                    let _e1269 = (_e1268 * 0.0000000000009094947f);
                                                    if (abs(_e1108) < _e1269) {
                                                        phi_1847_ = _e1269;
                                                    } else {
                                                        phi_1847_ = abs(_e1108);
                                                    }
                                                    let _e1274 = phi_1847_;
                                                    if (_e1108 < 0f) {
                                                        phi_1854_ = (-1f / _e1274);
                                                    } else {
                                                        phi_1854_ = (1f / _e1274);
                                                    }
                                                    let _e1279 = phi_1854_;
                                                    if (abs(_e1121) < _e1269) {
                                                        phi_1861_ = _e1269;
                                                    } else {
                                                        phi_1861_ = abs(_e1121);
                                                    }
                                                    let _e1284 = phi_1861_;
                                                    if (_e1121 < 0f) {
                                                        phi_1868_ = (-1f / _e1284);
                                                    } else {
                                                        phi_1868_ = (1f / _e1284);
                                                    }
                                                    let _e1289 = phi_1868_;
                                                    if (abs(_e1134) < _e1269) {
                                                        phi_1875_ = _e1269;
                                                    } else {
                                                        phi_1875_ = abs(_e1134);
                                                    }
                                                    let _e1294 = phi_1875_;
                                                    if (_e1134 < 0f) {
                                                        phi_1882_ = (-1f / _e1294);
                                                    } else {
                                                        phi_1882_ = (1f / _e1294);
                                                    }
                                                    let _e1299 = phi_1882_;
                                                    let _e1303 = abs((bitcast<f32>(_e1209) - _e1064));
                                                    let _e1304 = abs((bitcast<f32>(_e1213) - _e1077));
                                                    let _e1305 = abs((bitcast<f32>(_e1217) - _e1090));
                                                    let _e1309 = abs(((bitcast<f32>(_e1221) + (bitcast<f32>((((_e1233 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1064));
                                                    let _e1310 = abs(((bitcast<f32>(_e1225) + (bitcast<f32>((((_e1233 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1077));
                                                    let _e1311 = abs(((bitcast<f32>(_e1229) + (bitcast<f32>((((_e1233 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1090));
                                                    if (_e1303 > _e1309) {
                                                        phi_1899_ = _e1303;
                                                    } else {
                                                        phi_1899_ = _e1309;
                                                    }
                                                    let _e1314 = phi_1899_;
                                                    if (_e1304 > _e1310) {
                                                        phi_1904_ = _e1304;
                                                    } else {
                                                        phi_1904_ = _e1310;
                                                    }
                                                    let _e1317 = phi_1904_;
                                                    if (_e1305 > _e1311) {
                                                        phi_1909_ = _e1305;
                                                    } else {
                                                        phi_1909_ = _e1311;
                                                    }
                                                    let _e1320 = phi_1909_;
                                                    let _e1321 = core_intrinsics_maximum_number_nsz_f32_(_e1314, _e1317);
                                                    let _e1322 = core_intrinsics_maximum_number_nsz_f32_(_e1321, _e1320);
                                                    let _e1326 = (_e1322 * 0.0000019073486f);
                                                    let _e1327 = (abs(_e1279) * _e1326);
                                                    let _e1328 = (abs(_e1289) * _e1326);
                                                    let _e1329 = (abs(_e1299) * _e1326);
                                                    let _e1333 = (_e1322 * 0.0000009536743f);
                                                    let _e1334 = (abs(_e1279) * _e1333);
                                                    let _e1335 = (abs(_e1289) * _e1333);
                                                    let _e1336 = (abs(_e1299) * _e1333);
                                                    let _e1337 = abs(_e1108);
                                                    let _e1338 = abs(_e1121);
                                                    let _e1339 = abs(_e1134);
                                                    if (_e1337 >= _e1338) {
                                                        if (_e1337 >= _e1339) {
                                                            phi_1937_ = false;
                                                        } else {
                                                            phi_1937_ = true;
                                                        }
                                                        let _e1343 = phi_1937_;
                                                        phi_1938_ = _e1343;
                                                    } else {
                                                        phi_1938_ = true;
                                                    }
                                                    let _e1345 = phi_1938_;
                                                    if _e1345 {
                                                        if (_e1338 >= _e1339) {
                                                            phi_1946_ = 1u;
                                                        } else {
                                                            phi_1946_ = 2u;
                                                        }
                                                        let _e1348 = phi_1946_;
                                                        phi_1947_ = _e1348;
                                                    } else {
                                                        phi_1947_ = 0u;
                                                    }
                                                    let _e1350 = phi_1947_;
                                                    if (_e1350 == 0u) {
                                                        phi_1959_ = vec3<f32>(_e1121, _e1134, _e1108);
                                                    } else {
                                                        if (_e1350 == 1u) {
                                                            phi_1958_ = vec3<f32>(_e1134, _e1108, _e1121);
                                                        } else {
                                                            phi_1958_ = vec3<f32>(_e1108, _e1121, _e1134);
                                                        }
                                                        let _e1356 = phi_1958_;
                                                        phi_1959_ = _e1356;
                                                    }
                                                    let _e1358 = phi_1959_;
                                                    let _e1361 = (_e1358.x / _e1358.z);
                                                    let _e1364 = (_e1358.y / _e1358.z);
                                                    if (_e1279 < 0f) {
                                                        phi_1972_ = 0u;
                                                    } else {
                                                        phi_1972_ = 1u;
                                                    }
                                                    let _e1369 = phi_1972_;
                                                    if (_e1289 < 0f) {
                                                        phi_1977_ = 0u;
                                                    } else {
                                                        phi_1977_ = 2u;
                                                    }
                                                    let _e1372 = phi_1977_;
                                                    if (_e1299 < 0f) {
                                                        phi_1982_ = 0u;
                                                    } else {
                                                        phi_1982_ = 4u;
                                                    }
                                                    let _e1375 = phi_1982_;
                                                    let _e1377 = ((_e1369 | _e1372) | _e1375);
                                                    let _e1378 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1139, 2147483648u);
                                                    local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e1378.first[0], _e1378.first[1], _e1378.first[2], _e1378.first[3], _e1378.first[4], _e1378.first[5], _e1378.first[6], _e1378.first[7], _e1378.first[8], _e1378.first[9], _e1378.first[10], _e1378.first[11], _e1378.first[12], _e1378.first[13], _e1378.first[14], _e1378.first[15], _e1378.first[16], _e1378.first[17], _e1378.first[18], _e1378.first[19], _e1378.first[20], _e1378.first[21], _e1378.first[22], _e1378.first[23], _e1378.first[24], _e1378.first[25], _e1378.first[26], _e1378.first[27], _e1378.first[28], _e1378.first[29], _e1378.first[30], _e1378.first[31]), array<u32, 32>(_e1378.mask[0], _e1378.mask[1], _e1378.mask[2], _e1378.mask[3], _e1378.mask[4], _e1378.mask[5], _e1378.mask[6], _e1378.mask[7], _e1378.mask[8], _e1378.mask[9], _e1378.mask[10], _e1378.mask[11], _e1378.mask[12], _e1378.mask[13], _e1378.mask[14], _e1378.mask[15], _e1378.mask[16], _e1378.mask[17], _e1378.mask[18], _e1378.mask[19], _e1378.mask[20], _e1378.mask[21], _e1378.mask[22], _e1378.mask[23], _e1378.mask[24], _e1378.mask[25], _e1378.mask[26], _e1378.mask[27], _e1378.mask[28], _e1378.mask[29], _e1378.mask[30], _e1378.mask[31]), _e1378.len, _e1378.group, _e1378.group_mask);
                                                    let _e1452 = local_1.group_mask;
                                                    if ((_e1452 & 4278190080u) == 0u) {
                                                        let _e1456 = local_1.len;
                                                        if (_e1456 == 0u) {
                                                            phi_2096_ = false;
                                                        } else {
                                                            let _e1460 = local_1.len;
                                                            local_1.len = (_e1460 - 1u);
                                                            let _e1463 = local_1.len;
                                                            if (_e1463 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1468 = local_1.first[(0u + _e1463)];
                                                            local_1.group = _e1468;
                                                            let _e1471 = local_1.len;
                                                            if (_e1471 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1476 = local_1.mask[(0u + _e1471)];
                                                            local_1.group_mask = _e1476;
                                                            phi_2096_ = true;
                                                        }
                                                        let _e1479 = phi_2096_;
                                                        phi_2097_ = _e1479;
                                                    } else {
                                                        phi_2097_ = true;
                                                    }
                                                    let _e1481 = phi_2097_;
                                                    if _e1481 {
                                                        let _e1483 = local_1.group_mask;
                                                        let _e1489 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1483)), 32u, (_e1483 == 0u)));
                                                        let _e1493 = local_1.group_mask;
                                                        let _e1507 = local_1.group_mask;
                                                        local_1.group_mask = (_e1507 & ~((1u << bitcast<u32>((_e1489 & 31u)))));
                                                        let _e1510 = local_1.group;
                                                        phi_2128_ = (_e1510 + countOneBits(((_e1493 & ~((4294967295u << bitcast<u32>((((_e1489 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_2128_ = 4294967295u;
                                                    }
                                                    let _e1513 = phi_2128_;
                                                    phi_2130_ = _e972;
                                                    phi_2133_ = _e1513;
                                                    loop {
                                                        let _e1515 = phi_2130_;
                                                        let _e1517 = phi_2133_;
                                                        local_10 = _e1515;
                                                        let _e1518 = (_e1517 != 4294967295u);
                                                        if _e1518 {
                                                            if (_e1517 < _e76) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1525 = nodes.member[(0u + _e1517)].frame[3u];
                                                            let _e1550 = (bitcast<f32>((((_e1525 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1279);
                                                            let _e1551 = (bitcast<f32>((((_e1525 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1289);
                                                            let _e1552 = (bitcast<f32>((((_e1525 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1299);
                                                            let _e1555 = nodes.member[(0u + _e1517)].frame[0u];
                                                            let _e1559 = nodes.member[(0u + _e1517)].frame[1u];
                                                            let _e1563 = nodes.member[(0u + _e1517)].frame[2u];
                                                            let _e1568 = ((bitcast<f32>(_e1555) - _e1064) * _e1279);
                                                            let _e1569 = ((bitcast<f32>(_e1559) - _e1077) * _e1289);
                                                            let _e1570 = ((bitcast<f32>(_e1563) - _e1090) * _e1299);
                                                            let _e1578 = nodes.member[(0u + _e1517)].x;
                                                            if (_e1279 < 0f) {
                                                                let _e1589 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1578.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1595 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1589.unnamed.word, _e1578.w), _e1589.unnamed_1);
                                                                let _e1601 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1595.unnamed, lt_mask_LightPlace(_e1578.x, _e1595.unnamed_1.shift));
                                                                phi_2214_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1601.unnamed, lt_mask_LightPlace(_e1601.unnamed_1.word, _e1578.y));
                                                            } else {
                                                                let _e1617 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1578.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1623 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1617.unnamed.word, _e1578.y), _e1617.unnamed_1);
                                                                let _e1629 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1623.unnamed, lt_mask_LightPlace(_e1578.z, _e1623.unnamed_1.shift));
                                                                phi_2214_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1629.unnamed, lt_mask_LightPlace(_e1629.unnamed_1.word, _e1578.w));
                                                            }
                                                            let _e1637 = phi_2214_;
                                                            let _e1647 = nodes.member[(0u + _e1517)].y;
                                                            if (_e1289 < 0f) {
                                                                let _e1658 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1647.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1664 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1658.unnamed.word, _e1647.w), _e1658.unnamed_1);
                                                                let _e1670 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1664.unnamed, lt_mask_LightPlace(_e1647.x, _e1664.unnamed_1.shift));
                                                                phi_2241_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1670.unnamed, lt_mask_LightPlace(_e1670.unnamed_1.word, _e1647.y));
                                                            } else {
                                                                let _e1686 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1647.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1692 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1686.unnamed.word, _e1647.y), _e1686.unnamed_1);
                                                                let _e1698 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1692.unnamed, lt_mask_LightPlace(_e1647.z, _e1692.unnamed_1.shift));
                                                                phi_2241_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1698.unnamed, lt_mask_LightPlace(_e1698.unnamed_1.word, _e1647.w));
                                                            }
                                                            let _e1706 = phi_2241_;
                                                            let _e1716 = nodes.member[(0u + _e1517)].z;
                                                            if (_e1299 < 0f) {
                                                                let _e1727 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1716.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1733 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1727.unnamed.word, _e1716.w), _e1727.unnamed_1);
                                                                let _e1739 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1733.unnamed, lt_mask_LightPlace(_e1716.x, _e1733.unnamed_1.shift));
                                                                phi_2268_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1739.unnamed, lt_mask_LightPlace(_e1739.unnamed_1.word, _e1716.y));
                                                            } else {
                                                                let _e1755 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1716.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1761 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1755.unnamed.word, _e1716.y), _e1755.unnamed_1);
                                                                let _e1767 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1761.unnamed, lt_mask_LightPlace(_e1716.z, _e1761.unnamed_1.shift));
                                                                phi_2268_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1767.unnamed, lt_mask_LightPlace(_e1767.unnamed_1.word, _e1716.w));
                                                            }
                                                            let _e1775 = phi_2268_;
                                                            phi_2274_ = 0u;
                                                            phi_2277_ = 0u;
                                                            loop {
                                                                let _e1785 = phi_2274_;
                                                                let _e1787 = phi_2277_;
                                                                local_6 = _e1787;
                                                                local_7 = _e1787;
                                                                local_8 = _e1787;
                                                                let _e1788 = (_e1785 < 8u);
                                                                if _e1788 {
                                                                    let _e1790 = (_e1785 >> bitcast<u32>(2i));
                                                                    let _e1791 = (_e1785 & 3u);
                                                                    if (_e1790 == 0u) {
                                                                        phi_2291_ = _e1637.unnamed.word;
                                                                    } else {
                                                                        phi_2291_ = _e1637.unnamed.shift;
                                                                    }
                                                                    let _e1794 = phi_2291_;
                                                                    if (_e1790 == 0u) {
                                                                        phi_2301_ = _e1706.unnamed.word;
                                                                    } else {
                                                                        phi_2301_ = _e1706.unnamed.shift;
                                                                    }
                                                                    let _e1803 = phi_2301_;
                                                                    if (_e1790 == 0u) {
                                                                        phi_2311_ = _e1775.unnamed.word;
                                                                    } else {
                                                                        phi_2311_ = _e1775.unnamed.shift;
                                                                    }
                                                                    let _e1812 = phi_2311_;
                                                                    let _e1825 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1794 >> bitcast<u32>(((_e1791 * 8u) & 31u))) & 255u)) * _e1550) + (_e1568 - _e1327)), ((f32(((_e1803 >> bitcast<u32>(((_e1791 * 8u) & 31u))) & 255u)) * _e1551) + (_e1569 - _e1328)));
                                                                    let _e1826 = core_intrinsics_maximum_number_nsz_f32_(_e1825, ((f32(((_e1812 >> bitcast<u32>(((_e1791 * 8u) & 31u))) & 255u)) * _e1552) + (_e1570 - _e1329)));
                                                                    if (_e1790 == 0u) {
                                                                        phi_2329_ = _e1637.unnamed_1.word;
                                                                    } else {
                                                                        phi_2329_ = _e1637.unnamed_1.shift;
                                                                    }
                                                                    let _e1829 = phi_2329_;
                                                                    if (_e1790 == 0u) {
                                                                        phi_2339_ = _e1706.unnamed_1.word;
                                                                    } else {
                                                                        phi_2339_ = _e1706.unnamed_1.shift;
                                                                    }
                                                                    let _e1838 = phi_2339_;
                                                                    if (_e1790 == 0u) {
                                                                        phi_2349_ = _e1775.unnamed_1.word;
                                                                    } else {
                                                                        phi_2349_ = _e1775.unnamed_1.shift;
                                                                    }
                                                                    let _e1847 = phi_2349_;
                                                                    let _e1860 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1829 >> bitcast<u32>(((_e1791 * 8u) & 31u))) & 255u)) * _e1550) + (_e1568 + _e1327)), ((f32(((_e1838 >> bitcast<u32>(((_e1791 * 8u) & 31u))) & 255u)) * _e1551) + (_e1569 + _e1328)));
                                                                    let _e1861 = core_intrinsics_minimum_number_nsz_f32_(_e1860, ((f32(((_e1847 >> bitcast<u32>(((_e1791 * 8u) & 31u))) & 255u)) * _e1552) + (_e1570 + _e1329)));
                                                                    if (_e1826 <= _e1861) {
                                                                        if (_e1826 <= _e1515.t) {
                                                                            if (_e1861 >= _e157.tmin) {
                                                                                if (_e1790 == 0u) {
                                                                                    let _e1868 = nodes.member[(0u + _e1517)].links[2u];
                                                                                    phi_2385_ = _e1868;
                                                                                } else {
                                                                                    let _e1871 = nodes.member[(0u + _e1517)].links[3u];
                                                                                    phi_2385_ = _e1871;
                                                                                }
                                                                                let _e1873 = phi_2385_;
                                                                                let _e1878 = ((_e1873 >> bitcast<u32>(((_e1791 * 8u) & 31u))) & 255u);
                                                                                let _e1879 = (_e1878 & 31u);
                                                                                if (_e1879 >= 24u) {
                                                                                    phi_2398_ = (24u + ((_e1879 - 24u) ^ _e1377));
                                                                                } else {
                                                                                    phi_2398_ = _e1879;
                                                                                }
                                                                                let _e1885 = phi_2398_;
                                                                                phi_2403_ = (_e1787 | ((_e1878 >> bitcast<u32>(5i)) << bitcast<u32>((_e1885 & 31u))));
                                                                            } else {
                                                                                phi_2403_ = _e1787;
                                                                            }
                                                                            let _e1893 = phi_2403_;
                                                                            phi_2404_ = _e1893;
                                                                        } else {
                                                                            phi_2404_ = _e1787;
                                                                        }
                                                                        let _e1895 = phi_2404_;
                                                                        phi_2405_ = _e1895;
                                                                    } else {
                                                                        phi_2405_ = _e1787;
                                                                    }
                                                                    let _e1897 = phi_2405_;
                                                                    phi_2275_ = (_e1785 + 1u);
                                                                    phi_2278_ = _e1897;
                                                                } else {
                                                                    phi_2275_ = u32();
                                                                    phi_2278_ = u32();
                                                                }
                                                                let _e1900 = phi_2275_;
                                                                let _e1902 = phi_2278_;
                                                                continue;
                                                                continuing {
                                                                    phi_2274_ = _e1900;
                                                                    phi_2277_ = _e1902;
                                                                    break if !(_e1788);
                                                                }
                                                            }
                                                            let _e1906 = nodes.member[(0u + _e1517)].links[0u];
                                                            let _e1910 = nodes.member[(0u + _e1517)].frame[3u];
                                                            let _e1914 = local_6;
                                                            if ((_e1914 & 4278190080u) == 0u) {
                                                            } else {
                                                                let _e1918 = local_1.group_mask;
                                                                if ((_e1918 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1922 = local_1.len;
                                                                    if (_e1922 < 32u) {
                                                                        let _e1925 = local_1.group;
                                                                        let _e1927 = local_1.len;
                                                                        if (_e1927 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_1.first[(0u + _e1927)] = _e1925;
                                                                        let _e1933 = local_1.group_mask;
                                                                        let _e1935 = local_1.len;
                                                                        if (_e1935 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_1.mask[(0u + _e1935)] = _e1933;
                                                                        let _e1942 = local_1.len;
                                                                        local_1.len = (_e1942 + 1u);
                                                                    }
                                                                }
                                                                local_1.group = (_e1139 + _e1906);
                                                                let _e1946 = local_7;
                                                                local_1.group_mask = ((_e1946 & 4278190080u) | (_e1910 >> bitcast<u32>(24i)));
                                                            }
                                                            let _e1951 = local_8;
                                                            phi_2463_ = _e1515;
                                                            phi_2466_ = (_e1951 & 16777215u);
                                                            loop {
                                                                let _e1954 = phi_2463_;
                                                                let _e1956 = phi_2466_;
                                                                local_9 = _e1954;
                                                                if (_e1956 == 0u) {
                                                                    phi_2464_ = lt_bvh_Hit();
                                                                    phi_2467_ = u32();
                                                                    phi_3305_ = false;
                                                                } else {
                                                                    let _e1960 = nodes.member[(0u + _e1517)].links[1u];
                                                                    let _e1965 = ((_e1141 + _e1960) + select(firstTrailingBit(_e1956), 32u, (_e1956 == 0u)));
                                                                    if (_e1965 < _e79) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1972 = triangles.member[(0u + _e1965)].v0_;
                                                                    let _e1974 = (_e1972.x - _e1064);
                                                                    let _e1976 = (_e1972.y - _e1077);
                                                                    let _e1978 = (_e1972.z - _e1090);
                                                                    if (_e1350 == 0u) {
                                                                        phi_2511_ = vec3<f32>(_e1976, _e1978, _e1974);
                                                                    } else {
                                                                        if (_e1350 == 1u) {
                                                                            phi_2510_ = vec3<f32>(_e1978, _e1974, _e1976);
                                                                        } else {
                                                                            phi_2510_ = (_e1972 - vec3<f32>(_e1064, _e1077, _e1090));
                                                                        }
                                                                        let _e1986 = phi_2510_;
                                                                        phi_2511_ = _e1986;
                                                                    }
                                                                    let _e1988 = phi_2511_;
                                                                    let _e1992 = (_e1988.x - (_e1361 * _e1988.z));
                                                                    let _e1996 = (_e1988.y - (_e1364 * _e1988.z));
                                                                    let _e1998 = triangles.member[(0u + _e1965)].v1_;
                                                                    let _e2000 = (_e1998.x - _e1064);
                                                                    let _e2002 = (_e1998.y - _e1077);
                                                                    let _e2004 = (_e1998.z - _e1090);
                                                                    if (_e1350 == 0u) {
                                                                        phi_2541_ = vec3<f32>(_e2002, _e2004, _e2000);
                                                                    } else {
                                                                        if (_e1350 == 1u) {
                                                                            phi_2540_ = vec3<f32>(_e2004, _e2000, _e2002);
                                                                        } else {
                                                                            phi_2540_ = (_e1998 - vec3<f32>(_e1064, _e1077, _e1090));
                                                                        }
                                                                        let _e2012 = phi_2540_;
                                                                        phi_2541_ = _e2012;
                                                                    }
                                                                    let _e2014 = phi_2541_;
                                                                    let _e2018 = (_e2014.x - (_e1361 * _e2014.z));
                                                                    let _e2022 = (_e2014.y - (_e1364 * _e2014.z));
                                                                    let _e2024 = triangles.member[(0u + _e1965)].v2_;
                                                                    let _e2026 = (_e2024.x - _e1064);
                                                                    let _e2028 = (_e2024.y - _e1077);
                                                                    let _e2030 = (_e2024.z - _e1090);
                                                                    if (_e1350 == 0u) {
                                                                        phi_2571_ = vec3<f32>(_e2028, _e2030, _e2026);
                                                                    } else {
                                                                        if (_e1350 == 1u) {
                                                                            phi_2570_ = vec3<f32>(_e2030, _e2026, _e2028);
                                                                        } else {
                                                                            phi_2570_ = (_e2024 - vec3<f32>(_e1064, _e1077, _e1090));
                                                                        }
                                                                        let _e2038 = phi_2570_;
                                                                        phi_2571_ = _e2038;
                                                                    }
                                                                    let _e2040 = phi_2571_;
                                                                    let _e2044 = (_e2040.x - (_e1361 * _e2040.z));
                                                                    let _e2048 = (_e2040.y - (_e1364 * _e2040.z));
                                                                    if (_e2018 < _e2044) {
                                                                        phi_2590_ = true;
                                                                    } else {
                                                                        if (_e2018 == _e2044) {
                                                                            phi_2589_ = (_e2022 < _e2048);
                                                                        } else {
                                                                            phi_2589_ = false;
                                                                        }
                                                                        let _e2053 = phi_2589_;
                                                                        phi_2590_ = _e2053;
                                                                    }
                                                                    let _e2055 = phi_2590_;
                                                                    if _e2055 {
                                                                        phi_2594_ = _e2048;
                                                                        phi_2595_ = _e2044;
                                                                        phi_2596_ = _e2022;
                                                                        phi_2597_ = _e2018;
                                                                    } else {
                                                                        phi_2594_ = _e2022;
                                                                        phi_2595_ = _e2018;
                                                                        phi_2596_ = _e2048;
                                                                        phi_2597_ = _e2044;
                                                                    }
                                                                    let _e2057 = phi_2594_;
                                                                    let _e2059 = phi_2595_;
                                                                    let _e2061 = phi_2596_;
                                                                    let _e2063 = phi_2597_;
                                                                    let _e2066 = ((_e2063 * _e2057) - (_e2061 * _e2059));
                                                                    if _e2055 {
                                                                        phi_2605_ = -(_e2066);
                                                                    } else {
                                                                        phi_2605_ = _e2066;
                                                                    }
                                                                    let _e2069 = phi_2605_;
                                                                    if (_e2044 < _e1992) {
                                                                        phi_2616_ = true;
                                                                    } else {
                                                                        if (_e2044 == _e1992) {
                                                                            phi_2615_ = (_e2048 < _e1996);
                                                                        } else {
                                                                            phi_2615_ = false;
                                                                        }
                                                                        let _e2074 = phi_2615_;
                                                                        phi_2616_ = _e2074;
                                                                    }
                                                                    let _e2076 = phi_2616_;
                                                                    if _e2076 {
                                                                        phi_2620_ = _e1996;
                                                                        phi_2621_ = _e1992;
                                                                        phi_2622_ = _e2048;
                                                                        phi_2623_ = _e2044;
                                                                    } else {
                                                                        phi_2620_ = _e2048;
                                                                        phi_2621_ = _e2044;
                                                                        phi_2622_ = _e1996;
                                                                        phi_2623_ = _e1992;
                                                                    }
                                                                    let _e2078 = phi_2620_;
                                                                    let _e2080 = phi_2621_;
                                                                    let _e2082 = phi_2622_;
                                                                    let _e2084 = phi_2623_;
                                                                    let _e2087 = ((_e2084 * _e2078) - (_e2082 * _e2080));
                                                                    if _e2076 {
                                                                        phi_2631_ = -(_e2087);
                                                                    } else {
                                                                        phi_2631_ = _e2087;
                                                                    }
                                                                    let _e2090 = phi_2631_;
                                                                    if (_e1992 < _e2018) {
                                                                        phi_2642_ = true;
                                                                    } else {
                                                                        if (_e1992 == _e2018) {
                                                                            phi_2641_ = (_e1996 < _e2022);
                                                                        } else {
                                                                            phi_2641_ = false;
                                                                        }
                                                                        let _e2095 = phi_2641_;
                                                                        phi_2642_ = _e2095;
                                                                    }
                                                                    let _e2097 = phi_2642_;
                                                                    if _e2097 {
                                                                        phi_2646_ = _e2022;
                                                                        phi_2647_ = _e2018;
                                                                        phi_2648_ = _e1996;
                                                                        phi_2649_ = _e1992;
                                                                    } else {
                                                                        phi_2646_ = _e1996;
                                                                        phi_2647_ = _e1992;
                                                                        phi_2648_ = _e2022;
                                                                        phi_2649_ = _e2018;
                                                                    }
                                                                    let _e2099 = phi_2646_;
                                                                    let _e2101 = phi_2647_;
                                                                    let _e2103 = phi_2648_;
                                                                    let _e2105 = phi_2649_;
                                                                    let _e2108 = ((_e2105 * _e2099) - (_e2103 * _e2101));
                                                                    if _e2097 {
                                                                        phi_2657_ = -(_e2108);
                                                                    } else {
                                                                        phi_2657_ = _e2108;
                                                                    }
                                                                    let _e2111 = phi_2657_;
                                                                    if (_e2069 >= 0f) {
                                                                        if (_e2090 >= 0f) {
                                                                            if (_e2111 >= 0f) {
                                                                                phi_2672_ = ((_e2069 + _e2090) + _e2111);
                                                                                phi_2673_ = false;
                                                                            } else {
                                                                                phi_2672_ = f32();
                                                                                phi_2673_ = true;
                                                                            }
                                                                            let _e2118 = phi_2672_;
                                                                            let _e2120 = phi_2673_;
                                                                            phi_2674_ = _e2118;
                                                                            phi_2675_ = _e2120;
                                                                        } else {
                                                                            phi_2674_ = f32();
                                                                            phi_2675_ = true;
                                                                        }
                                                                        let _e2122 = phi_2674_;
                                                                        let _e2124 = phi_2675_;
                                                                        phi_2676_ = _e2122;
                                                                        phi_2677_ = _e2124;
                                                                    } else {
                                                                        phi_2676_ = f32();
                                                                        phi_2677_ = true;
                                                                    }
                                                                    let _e2126 = phi_2676_;
                                                                    let _e2128 = phi_2677_;
                                                                    if _e2128 {
                                                                        if (_e2069 <= 0f) {
                                                                            if (_e2090 <= 0f) {
                                                                                let _e2131 = (_e2111 <= 0f);
                                                                                if _e2131 {
                                                                                }
                                                                                phi_2695_ = ((_e2069 + _e2090) + _e2111);
                                                                                phi_2696_ = false;
                                                                                phi_2697_ = _e2131;
                                                                            } else {
                                                                                phi_2695_ = f32();
                                                                                phi_2696_ = true;
                                                                                phi_2697_ = false;
                                                                            }
                                                                            let _e2135 = phi_2695_;
                                                                            let _e2137 = phi_2696_;
                                                                            let _e2139 = phi_2697_;
                                                                            phi_2698_ = _e2135;
                                                                            phi_2699_ = _e2137;
                                                                            phi_2700_ = _e2139;
                                                                        } else {
                                                                            phi_2698_ = f32();
                                                                            phi_2699_ = true;
                                                                            phi_2700_ = false;
                                                                        }
                                                                        let _e2141 = phi_2698_;
                                                                        let _e2143 = phi_2699_;
                                                                        let _e2145 = phi_2700_;
                                                                        if _e2143 {
                                                                            phi_2704_ = false;
                                                                        } else {
                                                                            phi_2704_ = _e2145;
                                                                        }
                                                                        let _e2147 = phi_2704_;
                                                                        phi_2705_ = _e2141;
                                                                        phi_2706_ = _e2147;
                                                                    } else {
                                                                        phi_2705_ = _e2126;
                                                                        phi_2706_ = true;
                                                                    }
                                                                    let _e2149 = phi_2705_;
                                                                    let _e2151 = phi_2706_;
                                                                    if _e2151 {
                                                                        let _e2152 = (_e2149 == 0f);
                                                                        if _e2152 {
                                                                            phi_3022_ = lt_bvh_triangle_Intersection();
                                                                            phi_3023_ = false;
                                                                        } else {
                                                                            let _e2154 = triangles.member[(0u + _e1965)].v0_;
                                                                            let _e2156 = (_e2154.x - _e1064);
                                                                            let _e2158 = (_e2154.y - _e1077);
                                                                            let _e2160 = (_e2154.z - _e1090);
                                                                            if (_e1350 == 0u) {
                                                                                phi_2735_ = vec3<f32>(_e2158, _e2160, _e2156);
                                                                            } else {
                                                                                if (_e1350 == 1u) {
                                                                                    phi_2734_ = vec3<f32>(_e2160, _e2156, _e2158);
                                                                                } else {
                                                                                    phi_2734_ = (_e2154 - vec3<f32>(_e1064, _e1077, _e1090));
                                                                                }
                                                                                let _e2168 = phi_2734_;
                                                                                phi_2735_ = _e2168;
                                                                            }
                                                                            let _e2170 = phi_2735_;
                                                                            let _e2172 = triangles.member[(0u + _e1965)].v1_;
                                                                            let _e2174 = triangles.member[(0u + _e1965)].v0_;
                                                                            let _e2177 = (_e2172.x - _e2174.x);
                                                                            let _e2180 = (_e2172.y - _e2174.y);
                                                                            let _e2183 = (_e2172.z - _e2174.z);
                                                                            if (_e1350 == 0u) {
                                                                                phi_2761_ = vec3<f32>(_e2180, _e2183, _e2177);
                                                                            } else {
                                                                                if (_e1350 == 1u) {
                                                                                    phi_2760_ = vec3<f32>(_e2183, _e2177, _e2180);
                                                                                } else {
                                                                                    phi_2760_ = (_e2172 - _e2174);
                                                                                }
                                                                                let _e2190 = phi_2760_;
                                                                                phi_2761_ = _e2190;
                                                                            }
                                                                            let _e2192 = phi_2761_;
                                                                            let _e2194 = triangles.member[(0u + _e1965)].v2_;
                                                                            let _e2196 = triangles.member[(0u + _e1965)].v0_;
                                                                            let _e2199 = (_e2194.x - _e2196.x);
                                                                            let _e2202 = (_e2194.y - _e2196.y);
                                                                            let _e2205 = (_e2194.z - _e2196.z);
                                                                            if (_e1350 == 0u) {
                                                                                phi_2787_ = vec3<f32>(_e2202, _e2205, _e2199);
                                                                            } else {
                                                                                if (_e1350 == 1u) {
                                                                                    phi_2786_ = vec3<f32>(_e2205, _e2199, _e2202);
                                                                                } else {
                                                                                    phi_2786_ = (_e2194 - _e2196);
                                                                                }
                                                                                let _e2212 = phi_2786_;
                                                                                phi_2787_ = _e2212;
                                                                            }
                                                                            let _e2214 = phi_2787_;
                                                                            let _e2221 = ((_e2192.y * _e2214.z) - (_e2192.z * _e2214.y));
                                                                            let _e2228 = ((_e2192.z * _e2214.x) - (_e2192.x * _e2214.z));
                                                                            let _e2235 = ((_e2192.x * _e2214.y) - (_e2192.y * _e2214.x));
                                                                            let _e2249 = (((1f / _e1358.z) * (((_e2221 * _e2170.x) + (_e2228 * _e2170.y)) + (_e2235 * _e2170.z))) / (((_e2221 * _e1361) + (_e2228 * _e1364)) + _e2235));
                                                                            if (_e2249 > _e157.tmin) {
                                                                                if (_e2249 < _e157.tmax) {
                                                                                    let _e2253 = triangles.member[(0u + _e1965)].v0_;
                                                                                    let _e2255 = triangles.member[(0u + _e1965)].v1_;
                                                                                    if (_e2253.x < _e2255.x) {
                                                                                        phi_2843_ = _e2253.x;
                                                                                    } else {
                                                                                        phi_2843_ = _e2255.x;
                                                                                    }
                                                                                    let _e2262 = phi_2843_;
                                                                                    if (_e2253.y < _e2255.y) {
                                                                                        phi_2852_ = _e2253.y;
                                                                                    } else {
                                                                                        phi_2852_ = _e2255.y;
                                                                                    }
                                                                                    let _e2269 = phi_2852_;
                                                                                    if (_e2253.z < _e2255.z) {
                                                                                        phi_2861_ = _e2253.z;
                                                                                    } else {
                                                                                        phi_2861_ = _e2255.z;
                                                                                    }
                                                                                    let _e2276 = phi_2861_;
                                                                                    let _e2278 = triangles.member[(0u + _e1965)].v2_;
                                                                                    if (_e2262 < _e2278.x) {
                                                                                        phi_2870_ = _e2262;
                                                                                    } else {
                                                                                        phi_2870_ = _e2278.x;
                                                                                    }
                                                                                    let _e2283 = phi_2870_;
                                                                                    if (_e2269 < _e2278.y) {
                                                                                        phi_2877_ = _e2269;
                                                                                    } else {
                                                                                        phi_2877_ = _e2278.y;
                                                                                    }
                                                                                    let _e2288 = phi_2877_;
                                                                                    if (_e2276 < _e2278.z) {
                                                                                        phi_2884_ = _e2276;
                                                                                    } else {
                                                                                        phi_2884_ = _e2278.z;
                                                                                    }
                                                                                    let _e2293 = phi_2884_;
                                                                                    let _e2295 = triangles.member[(0u + _e1965)].v0_;
                                                                                    let _e2297 = triangles.member[(0u + _e1965)].v1_;
                                                                                    if (_e2295.x > _e2297.x) {
                                                                                        phi_2897_ = _e2295.x;
                                                                                    } else {
                                                                                        phi_2897_ = _e2297.x;
                                                                                    }
                                                                                    let _e2304 = phi_2897_;
                                                                                    if (_e2295.y > _e2297.y) {
                                                                                        phi_2906_ = _e2295.y;
                                                                                    } else {
                                                                                        phi_2906_ = _e2297.y;
                                                                                    }
                                                                                    let _e2311 = phi_2906_;
                                                                                    if (_e2295.z > _e2297.z) {
                                                                                        phi_2915_ = _e2295.z;
                                                                                    } else {
                                                                                        phi_2915_ = _e2297.z;
                                                                                    }
                                                                                    let _e2318 = phi_2915_;
                                                                                    let _e2320 = triangles.member[(0u + _e1965)].v2_;
                                                                                    if (_e2304 > _e2320.x) {
                                                                                        phi_2924_ = _e2304;
                                                                                    } else {
                                                                                        phi_2924_ = _e2320.x;
                                                                                    }
                                                                                    let _e2325 = phi_2924_;
                                                                                    if (_e2311 > _e2320.y) {
                                                                                        phi_2931_ = _e2311;
                                                                                    } else {
                                                                                        phi_2931_ = _e2320.y;
                                                                                    }
                                                                                    let _e2330 = phi_2931_;
                                                                                    if (_e2318 > _e2320.z) {
                                                                                        phi_2938_ = _e2318;
                                                                                    } else {
                                                                                        phi_2938_ = _e2320.z;
                                                                                    }
                                                                                    let _e2335 = phi_2938_;
                                                                                    let _e2339 = ((_e2283 - _e1064) * _e1279);
                                                                                    let _e2340 = ((_e2288 - _e1077) * _e1289);
                                                                                    let _e2341 = ((_e2293 - _e1090) * _e1299);
                                                                                    let _e2345 = ((_e2325 - _e1064) * _e1279);
                                                                                    let _e2346 = ((_e2330 - _e1077) * _e1289);
                                                                                    let _e2347 = ((_e2335 - _e1090) * _e1299);
                                                                                    if (_e2339 < _e2345) {
                                                                                        phi_2955_ = _e2339;
                                                                                    } else {
                                                                                        phi_2955_ = _e2345;
                                                                                    }
                                                                                    let _e2350 = phi_2955_;
                                                                                    if (_e2340 < _e2346) {
                                                                                        phi_2960_ = _e2340;
                                                                                    } else {
                                                                                        phi_2960_ = _e2346;
                                                                                    }
                                                                                    let _e2353 = phi_2960_;
                                                                                    if (_e2341 < _e2347) {
                                                                                        phi_2965_ = _e2341;
                                                                                    } else {
                                                                                        phi_2965_ = _e2347;
                                                                                    }
                                                                                    let _e2356 = phi_2965_;
                                                                                    if (_e2339 > _e2345) {
                                                                                        phi_2973_ = _e2339;
                                                                                    } else {
                                                                                        phi_2973_ = _e2345;
                                                                                    }
                                                                                    let _e2362 = phi_2973_;
                                                                                    if (_e2340 > _e2346) {
                                                                                        phi_2978_ = _e2340;
                                                                                    } else {
                                                                                        phi_2978_ = _e2346;
                                                                                    }
                                                                                    let _e2365 = phi_2978_;
                                                                                    if (_e2341 > _e2347) {
                                                                                        phi_2983_ = _e2341;
                                                                                    } else {
                                                                                        phi_2983_ = _e2347;
                                                                                    }
                                                                                    let _e2368 = phi_2983_;
                                                                                    let _e2372 = core_intrinsics_maximum_number_nsz_f32_((_e2350 - _e1334), (_e2353 - _e1335));
                                                                                    let _e2373 = core_intrinsics_maximum_number_nsz_f32_(_e2372, (_e2356 - _e1336));
                                                                                    let _e2374 = core_intrinsics_minimum_number_nsz_f32_((_e2362 + _e1334), (_e2365 + _e1335));
                                                                                    let _e2375 = core_intrinsics_minimum_number_nsz_f32_(_e2374, (_e2368 + _e1336));
                                                                                    if (_e2373 > _e1039) {
                                                                                        phi_2995_ = _e2373;
                                                                                    } else {
                                                                                        phi_2995_ = _e1039;
                                                                                    }
                                                                                    let _e2378 = phi_2995_;
                                                                                    if (_e2375 < _e1041) {
                                                                                        phi_3000_ = _e2375;
                                                                                    } else {
                                                                                        phi_3000_ = _e1041;
                                                                                    }
                                                                                    let _e2381 = phi_3000_;
                                                                                    if (_e2249 < _e2378) {
                                                                                        phi_3005_ = _e2378;
                                                                                    } else {
                                                                                        phi_3005_ = _e2249;
                                                                                    }
                                                                                    let _e2384 = phi_3005_;
                                                                                    if (_e2384 > _e2381) {
                                                                                        phi_3010_ = _e2381;
                                                                                    } else {
                                                                                        phi_3010_ = _e2384;
                                                                                    }
                                                                                    let _e2387 = phi_3010_;
                                                                                    phi_3015_ = lt_bvh_triangle_Intersection(_e2387, (_e2090 / _e2149), (_e2111 / _e2149), (_e2378 <= _e2381));
                                                                                    phi_3016_ = false;
                                                                                } else {
                                                                                    phi_3015_ = lt_bvh_triangle_Intersection();
                                                                                    phi_3016_ = true;
                                                                                }
                                                                                let _e2393 = phi_3015_;
                                                                                let _e2395 = phi_3016_;
                                                                                phi_3017_ = _e2393;
                                                                                phi_3018_ = _e2395;
                                                                            } else {
                                                                                phi_3017_ = lt_bvh_triangle_Intersection();
                                                                                phi_3018_ = true;
                                                                            }
                                                                            let _e2397 = phi_3017_;
                                                                            let _e2399 = phi_3018_;
                                                                            if _e2399 {
                                                                            }
                                                                            phi_3022_ = _e2397;
                                                                            phi_3023_ = _e2399;
                                                                        }
                                                                        let _e2401 = phi_3022_;
                                                                        let _e2403 = phi_3023_;
                                                                        phi_3024_ = _e2401;
                                                                        phi_3025_ = _e2152;
                                                                        phi_3026_ = _e2403;
                                                                    } else {
                                                                        phi_3024_ = lt_bvh_triangle_Intersection();
                                                                        phi_3025_ = true;
                                                                        phi_3026_ = false;
                                                                    }
                                                                    let _e2405 = phi_3024_;
                                                                    let _e2407 = phi_3025_;
                                                                    let _e2409 = phi_3026_;
                                                                    if _e2407 {
                                                                        phi_3030_ = true;
                                                                    } else {
                                                                        phi_3030_ = _e2409;
                                                                    }
                                                                    let _e2411 = phi_3030_;
                                                                    if _e2411 {
                                                                        phi_3034_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_3034_ = _e2405;
                                                                    }
                                                                    let _e2413 = phi_3034_;
                                                                    if _e2413.is_hit {
                                                                        if (_e2413.t > _e157.tmin) {
                                                                            if (_e2413.t < _e1954.t) {
                                                                                phi_3082_ = true;
                                                                            } else {
                                                                                if (_e2413.t == _e1954.t) {
                                                                                    if (_e1954.triangle != 4294967295u) {
                                                                                        if (_e1965 < _e1954.triangle) {
                                                                                            phi_3073_ = true;
                                                                                        } else {
                                                                                            if (_e1965 == _e1954.triangle) {
                                                                                                phi_3072_ = (_e980 < _e1954.instance);
                                                                                            } else {
                                                                                                phi_3072_ = false;
                                                                                            }
                                                                                            let _e2431 = phi_3072_;
                                                                                            phi_3073_ = _e2431;
                                                                                        }
                                                                                        let _e2433 = phi_3073_;
                                                                                        phi_3074_ = _e2433;
                                                                                        phi_3075_ = false;
                                                                                    } else {
                                                                                        phi_3074_ = bool();
                                                                                        phi_3075_ = true;
                                                                                    }
                                                                                    let _e2435 = phi_3074_;
                                                                                    let _e2437 = phi_3075_;
                                                                                    phi_3076_ = _e2435;
                                                                                    phi_3077_ = _e2437;
                                                                                } else {
                                                                                    phi_3076_ = bool();
                                                                                    phi_3077_ = true;
                                                                                }
                                                                                let _e2439 = phi_3076_;
                                                                                let _e2441 = phi_3077_;
                                                                                if _e2441 {
                                                                                    phi_3081_ = false;
                                                                                } else {
                                                                                    phi_3081_ = _e2439;
                                                                                }
                                                                                let _e2443 = phi_3081_;
                                                                                phi_3082_ = _e2443;
                                                                            }
                                                                            let _e2445 = phi_3082_;
                                                                            if _e2445 {
                                                                                let _e2447 = triangles.member[(0u + _e1965)].i0_;
                                                                                if ((_e2447 & 2147483648u) == 0u) {
                                                                                    phi_3293_ = true;
                                                                                } else {
                                                                                    if (_e1965 < _e79) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2456 = triangles.member[(0u + _e1965)].i0_;
                                                                                    let _e2457 = (_e2456 & 2147483647u);
                                                                                    let _e2459 = triangles.member[(0u + _e1965)].i1_;
                                                                                    let _e2461 = triangles.member[(0u + _e1965)].i2_;
                                                                                    if (_e2457 < _e82) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2465 = vertices.member[(0u + _e2457)];
                                                                                    if (_e2459 < _e82) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2469 = vertices.member[(0u + _e2459)];
                                                                                    if (_e2461 < _e82) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2473 = vertices.member[(0u + _e2461)];
                                                                                    let _e2474 = array<abi_Vertex, 3>(_e2465, _e2469, _e2473);
                                                                                    if (_e2474[0].material < _e85) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2480 = materials.member[(0u + _e2474[0].material)];
                                                                                    if ((_e2480.flags & 0u) == 0u) {
                                                                                        let _e2485 = ((1f - _e2413.u) - _e2413.v);
                                                                                        if (_e2480.cutoff <= 0f) {
                                                                                            phi_3288_ = true;
                                                                                        } else {
                                                                                            let _e2512 = (_e2480.base_color.w * ((((f32((_e2474[0].color >> bitcast<u32>(24i))) * _e2485) + (f32((_e2474[1].color >> bitcast<u32>(24i))) * _e2413.u)) + (f32((_e2474[2].color >> bitcast<u32>(24i))) * _e2413.v)) * (1f / 255f)));
                                                                                            if (_e2480.alpha_size == 0u) {
                                                                                                phi_3285_ = _e2512;
                                                                                            } else {
                                                                                                local.offset = _e2480.alpha_offset;
                                                                                                local.size = _e2480.alpha_size;
                                                                                                local.flags = _e2480.flags;
                                                                                                let _e2543 = _lt_shaders_texture_TextureView_quad((&local), (((_e2474[0].u * _e2485) + (_e2474[1].u * _e2413.u)) + (_e2474[2].u * _e2413.v)), (((_e2474[0].v * _e2485) + (_e2474[1].v * _e2413.u)) + (_e2474[2].v * _e2413.v)));
                                                                                                let _e2547 = (_e2543.indices[0] >> bitcast<u32>(2i));
                                                                                                if (_e2547 < _e94) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2551 = alpha_texels.member[(0u + _e2547)];
                                                                                                let _e2567 = (_e2543.indices[1] >> bitcast<u32>(2i));
                                                                                                if (_e2567 < _e94) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2571 = alpha_texels.member[(0u + _e2567)];
                                                                                                let _e2588 = (_e2543.indices[2] >> bitcast<u32>(2i));
                                                                                                if (_e2588 < _e94) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2592 = alpha_texels.member[(0u + _e2588)];
                                                                                                let _e2609 = (_e2543.indices[3] >> bitcast<u32>(2i));
                                                                                                if (_e2609 < _e94) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2613 = alpha_texels.member[(0u + _e2609)];
                                                                                                phi_3285_ = (_e2512 * (((((f32(((_e2551 >> bitcast<u32>((((_e2543.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2543.weights.x) + ((f32(((_e2571 >> bitcast<u32>((((_e2543.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2543.weights.y)) + ((f32(((_e2592 >> bitcast<u32>((((_e2543.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2543.weights.z)) + ((f32(((_e2613 >> bitcast<u32>((((_e2543.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2543.weights.w)));
                                                                                            }
                                                                                            let _e2629 = phi_3285_;
                                                                                            phi_3288_ = (_e2629 >= _e2480.cutoff);
                                                                                        }
                                                                                        let _e2633 = phi_3288_;
                                                                                        phi_3289_ = _e2633;
                                                                                    } else {
                                                                                        phi_3289_ = false;
                                                                                    }
                                                                                    let _e2635 = phi_3289_;
                                                                                    if _e2635 {
                                                                                    }
                                                                                    phi_3293_ = _e2635;
                                                                                }
                                                                                let _e2637 = phi_3293_;
                                                                                if _e2637 {
                                                                                    phi_3301_ = lt_bvh_Hit(_e2413.t, _e2413.u, _e2413.v, _e1965, _e980);
                                                                                } else {
                                                                                    phi_3301_ = _e1954;
                                                                                }
                                                                                let _e2643 = phi_3301_;
                                                                                phi_3302_ = _e2643;
                                                                            } else {
                                                                                phi_3302_ = _e1954;
                                                                            }
                                                                            let _e2645 = phi_3302_;
                                                                            phi_3303_ = _e2645;
                                                                        } else {
                                                                            phi_3303_ = _e1954;
                                                                        }
                                                                        let _e2647 = phi_3303_;
                                                                        phi_3304_ = _e2647;
                                                                    } else {
                                                                        phi_3304_ = _e1954;
                                                                    }
                                                                    let _e2649 = phi_3304_;
                                                                    phi_2464_ = _e2649;
                                                                    phi_2467_ = (_e1956 & (_e1956 - 1u));
                                                                    phi_3305_ = true;
                                                                }
                                                                let _e2651 = phi_2464_;
                                                                let _e2653 = phi_2467_;
                                                                let _e2655 = phi_3305_;
                                                                continue;
                                                                continuing {
                                                                    phi_2463_ = _e2651;
                                                                    phi_2466_ = _e2653;
                                                                    break if !(_e2655);
                                                                }
                                                            }
                                                            let _e2658 = local_1.group_mask;
                                                            if ((_e2658 & 4278190080u) == 0u) {
                                                                let _e2662 = local_1.len;
                                                                if (_e2662 == 0u) {
                                                                    phi_3344_ = false;
                                                                } else {
                                                                    let _e2666 = local_1.len;
                                                                    local_1.len = (_e2666 - 1u);
                                                                    let _e2669 = local_1.len;
                                                                    if (_e2669 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2674 = local_1.first[(0u + _e2669)];
                                                                    local_1.group = _e2674;
                                                                    let _e2677 = local_1.len;
                                                                    if (_e2677 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2682 = local_1.mask[(0u + _e2677)];
                                                                    local_1.group_mask = _e2682;
                                                                    phi_3344_ = true;
                                                                }
                                                                let _e2685 = phi_3344_;
                                                                phi_3345_ = _e2685;
                                                            } else {
                                                                phi_3345_ = true;
                                                            }
                                                            let _e2687 = phi_3345_;
                                                            if _e2687 {
                                                                let _e2689 = local_1.group_mask;
                                                                let _e2695 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2689)), 32u, (_e2689 == 0u)));
                                                                let _e2699 = local_1.group_mask;
                                                                let _e2713 = local_1.group_mask;
                                                                local_1.group_mask = (_e2713 & ~((1u << bitcast<u32>((_e2695 & 31u)))));
                                                                let _e2716 = local_1.group;
                                                                phi_3376_ = (_e2716 + countOneBits(((_e2699 & ~((4294967295u << bitcast<u32>((((_e2695 - 24u) ^ _e1377) & 31u))))) & 255u)));
                                                            } else {
                                                                phi_3376_ = 4294967295u;
                                                            }
                                                            let _e2719 = phi_3376_;
                                                            let _e3708 = local_9;
                                                            phi_2131_ = _e3708;
                                                            phi_2134_ = _e2719;
                                                        } else {
                                                            phi_2131_ = lt_bvh_Hit();
                                                            phi_2134_ = u32();
                                                        }
                                                        let _e2721 = phi_2131_;
                                                        let _e2723 = phi_2134_;
                                                        continue;
                                                        continuing {
                                                            phi_2130_ = _e2721;
                                                            phi_2133_ = _e2723;
                                                            break if !(_e1518);
                                                        }
                                                    }
                                                    let _e3712 = local_10;
                                                    phi_3377_ = _e3712;
                                                }
                                                let _e2726 = phi_3377_;
                                                phi_3378_ = _e2726;
                                                phi_3379_ = _e1203;
                                            } else {
                                                phi_3378_ = lt_bvh_Hit();
                                                phi_3379_ = true;
                                            }
                                            let _e2728 = phi_3378_;
                                            let _e2730 = phi_3379_;
                                            if _e2730 {
                                                phi_3383_ = _e972;
                                            } else {
                                                phi_3383_ = _e2728;
                                            }
                                            let _e2732 = phi_3383_;
                                            phi_3384_ = _e2732;
                                        } else {
                                            phi_3384_ = _e972;
                                        }
                                        let _e2734 = phi_3384_;
                                        phi_3385_ = _e2734;
                                    } else {
                                        phi_3385_ = _e972;
                                    }
                                    let _e2736 = phi_3385_;
                                    phi_3386_ = _e2736;
                                } else {
                                    phi_3386_ = _e972;
                                }
                                let _e2738 = phi_3386_;
                                phi_1505_ = (_e970 & (_e970 - 1u));
                                phi_1508_ = _e2738;
                                phi_3387_ = true;
                            }
                            let _e2740 = phi_1505_;
                            let _e2742 = phi_1508_;
                            let _e2744 = phi_3387_;
                            continue;
                            continuing {
                                phi_1504_ = _e2740;
                                phi_1507_ = _e2742;
                                break if !(_e2744);
                            }
                        }
                        let _e2747 = local_2.group_mask;
                        if ((_e2747 & 4278190080u) == 0u) {
                            let _e2751 = local_2.len;
                            if (_e2751 == 0u) {
                                phi_3426_ = false;
                            } else {
                                let _e2755 = local_2.len;
                                local_2.len = (_e2755 - 1u);
                                let _e2758 = local_2.len;
                                if (_e2758 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2763 = local_2.first[(0u + _e2758)];
                                local_2.group = _e2763;
                                let _e2766 = local_2.len;
                                if (_e2766 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2771 = local_2.mask[(0u + _e2766)];
                                local_2.group_mask = _e2771;
                                phi_3426_ = true;
                            }
                            let _e2774 = phi_3426_;
                            phi_3427_ = _e2774;
                        } else {
                            phi_3427_ = true;
                        }
                        let _e2776 = phi_3427_;
                        if _e2776 {
                            let _e2778 = local_2.group_mask;
                            let _e2784 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2778)), 32u, (_e2778 == 0u)));
                            let _e2788 = local_2.group_mask;
                            let _e2802 = local_2.group_mask;
                            local_2.group_mask = (_e2802 & ~((1u << bitcast<u32>((_e2784 & 31u)))));
                            let _e2805 = local_2.group;
                            phi_3458_ = (_e2805 + countOneBits(((_e2788 & ~((4294967295u << bitcast<u32>((((_e2784 - 24u) ^ _e389) & 31u))))) & 255u)));
                        } else {
                            phi_3458_ = 4294967295u;
                        }
                        let _e2808 = phi_3458_;
                        phi_1168_ = _e2808;
                        let _e3728 = local_11;
                        phi_1171_ = _e3728;
                    } else {
                        phi_1168_ = u32();
                        phi_1171_ = lt_bvh_Hit();
                    }
                    let _e2810 = phi_1168_;
                    let _e2812 = phi_1171_;
                    continue;
                    continuing {
                        phi_1167_ = _e2810;
                        phi_1170_ = _e2812;
                        break if !(_e530);
                    }
                }
                let _e3731 = local_12;
                phi_3459_ = _e3731;
            }
            let _e2815 = phi_3459_;
            phi_3460_ = _e2815;
            phi_3461_ = _e229;
        } else {
            phi_3460_ = lt_bvh_Hit();
            phi_3461_ = true;
        }
        let _e2817 = phi_3460_;
        let _e2819 = phi_3461_;
        if _e2819 {
            phi_3465_ = _e159;
        } else {
            phi_3465_ = _e2817;
        }
        let _e2821 = phi_3465_;
        if (_e2821.triangle != 4294967295u) {
            let _e2827 = ((1f - _e2821.u) - _e2821.v);
            if (_e2821.triangle < _e79) {
            } else {
                return;
            }
            let _e2833 = triangles.member[(0u + _e2821.triangle)];
            if (_e2821.instance < _e91) {
            } else {
                return;
            }
            let _e2844 = instances.member[(0u + _e2821.instance)].object_to_world[0u];
            let _e2855 = ((((_e2844.x * _e2833.v0_.x) + (_e2844.y * _e2833.v0_.y)) + (_e2844.z * _e2833.v0_.z)) + (_e2844.w * 1f));
            let _e2857 = instances.member[(0u + _e2821.instance)].object_to_world[1u];
            let _e2868 = ((((_e2857.x * _e2833.v0_.x) + (_e2857.y * _e2833.v0_.y)) + (_e2857.z * _e2833.v0_.z)) + (_e2857.w * 1f));
            let _e2870 = instances.member[(0u + _e2821.instance)].object_to_world[2u];
            let _e2881 = ((((_e2870.x * _e2833.v0_.x) + (_e2870.y * _e2833.v0_.y)) + (_e2870.z * _e2833.v0_.z)) + (_e2870.w * 1f));
            let _e2888 = instances.member[(0u + _e2821.instance)].object_to_world[0u];
            let _e2899 = ((((_e2888.x * _e2833.v1_.x) + (_e2888.y * _e2833.v1_.y)) + (_e2888.z * _e2833.v1_.z)) + (_e2888.w * 1f));
            let _e2901 = instances.member[(0u + _e2821.instance)].object_to_world[1u];
            let _e2912 = ((((_e2901.x * _e2833.v1_.x) + (_e2901.y * _e2833.v1_.y)) + (_e2901.z * _e2833.v1_.z)) + (_e2901.w * 1f));
            let _e2914 = instances.member[(0u + _e2821.instance)].object_to_world[2u];
            let _e2925 = ((((_e2914.x * _e2833.v1_.x) + (_e2914.y * _e2833.v1_.y)) + (_e2914.z * _e2833.v1_.z)) + (_e2914.w * 1f));
            let _e2932 = instances.member[(0u + _e2821.instance)].object_to_world[0u];
            let _e2943 = ((((_e2932.x * _e2833.v2_.x) + (_e2932.y * _e2833.v2_.y)) + (_e2932.z * _e2833.v2_.z)) + (_e2932.w * 1f));
            let _e2945 = instances.member[(0u + _e2821.instance)].object_to_world[1u];
            let _e2956 = ((((_e2945.x * _e2833.v2_.x) + (_e2945.y * _e2833.v2_.y)) + (_e2945.z * _e2833.v2_.z)) + (_e2945.w * 1f));
            let _e2958 = instances.member[(0u + _e2821.instance)].object_to_world[2u];
            let _e2969 = ((((_e2958.x * _e2833.v2_.x) + (_e2958.y * _e2833.v2_.y)) + (_e2958.z * _e2833.v2_.z)) + (_e2958.w * 1f));
            let _e2982 = (((_e2855 * _e2827) + (_e2899 * _e2821.u)) + (_e2943 * _e2821.v));
            let _e2983 = (((_e2868 * _e2827) + (_e2912 * _e2821.u)) + (_e2956 * _e2821.v));
            let _e2984 = (((_e2881 * _e2827) + (_e2925 * _e2821.u)) + (_e2969 * _e2821.v));
            let _e2986 = abs(_e2855);
            let _e2987 = abs(_e2868);
            let _e2988 = abs(_e2881);
            let _e2989 = abs(_e2899);
            let _e2990 = abs(_e2912);
            let _e2991 = abs(_e2925);
            if (_e2986 > _e2989) {
                phi_3653_ = _e2986;
            } else {
                phi_3653_ = _e2989;
            }
            let _e2994 = phi_3653_;
            if (_e2987 > _e2990) {
                phi_3658_ = _e2987;
            } else {
                phi_3658_ = _e2990;
            }
            let _e2997 = phi_3658_;
            if (_e2988 > _e2991) {
                phi_3663_ = _e2988;
            } else {
                phi_3663_ = _e2991;
            }
            let _e3000 = phi_3663_;
            let _e3001 = abs(_e2943);
            let _e3002 = abs(_e2956);
            let _e3003 = abs(_e2969);
            if (_e2994 > _e3001) {
                phi_3671_ = _e2994;
            } else {
                phi_3671_ = _e3001;
            }
            let _e3006 = phi_3671_;
            if (_e2997 > _e3002) {
                phi_3676_ = _e2997;
            } else {
                phi_3676_ = _e3002;
            }
            let _e3009 = phi_3676_;
            if (_e3000 > _e3003) {
                phi_3681_ = _e3000;
            } else {
                phi_3681_ = _e3003;
            }
            let _e3012 = phi_3681_;
            let _e3013 = (_e2899 - _e2855);
            let _e3014 = (_e2912 - _e2868);
            let _e3015 = (_e2925 - _e2881);
            let _e3016 = (_e2943 - _e2855);
            let _e3017 = (_e2956 - _e2868);
            let _e3018 = (_e2969 - _e2881);
            let _e3022 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3014), abs(_e3015));
            let _e3023 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3013), _e3022);
            let _e3024 = (_e3013 / _e3023);
            let _e3025 = (_e3014 / _e3023);
            let _e3026 = (_e3015 / _e3023);
            let _e3030 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3017), abs(_e3018));
            let _e3031 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3016), _e3030);
            let _e3032 = (_e3016 / _e3031);
            let _e3033 = (_e3017 / _e3031);
            let _e3034 = (_e3018 / _e3031);
            let _e3037 = ((_e3025 * _e3034) - (_e3033 * _e3026));
            let _e3040 = ((_e3026 * _e3032) - (_e3034 * _e3024));
            let _e3043 = ((_e3024 * _e3033) - (_e3032 * _e3025));
            let _e3045 = p.member.eye;
            let _e3058 = (1f / sqrt((((_e3037 * _e3037) + (_e3040 * _e3040)) + (_e3043 * _e3043))));
            let _e3059 = (_e3037 * _e3058);
            let _e3060 = (_e3040 * _e3058);
            let _e3061 = (_e3043 * _e3058);
            if ((((_e3059 * (_e3045.x - _e2982)) + (_e3060 * (_e3045.y - _e2983))) + (_e3061 * (_e3045.z - _e2984))) < 0f) {
                phi_3745_ = vec3<f32>(-(_e3059), -(_e3060), -(_e3061));
            } else {
                phi_3745_ = vec3<f32>(_e3059, _e3060, _e3061);
            }
            let _e3074 = phi_3745_;
            if (_e2821.triangle < _e79) {
            } else {
                return;
            }
            let _e3079 = triangles.member[(0u + _e2821.triangle)];
            let _e3081 = (_e3079.i0_ & 2147483647u);
            if (_e3081 < _e82) {
            } else {
                return;
            }
            let _e3087 = vertices.member[(0u + _e3081)];
            if (_e3079.i1_ < _e82) {
            } else {
                return;
            }
            let _e3091 = vertices.member[(0u + _e3079.i1_)];
            if (_e3079.i2_ < _e82) {
            } else {
                return;
            }
            let _e3095 = vertices.member[(0u + _e3079.i2_)];
            let _e3096 = array<abi_Vertex, 3>(_e3087, _e3091, _e3095);
            if (_e3096[0].material < _e85) {
            } else {
                return;
            }
            let _e3102 = materials.member[(0u + _e3096[0].material)];
            let _e3119 = (1f / 255f);
            let _e3138 = (1f / 255f);
            let _e3160 = (1f / 255f);
            let _e3173 = _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(vec3<f32>(_e2827, _e2821.u, _e2821.v));
            let _e3175 = ((_e3102.base_color.x * ((((f32((_e3096[0].color & 255u)) * _e3119) * _e2827) + ((f32((_e3096[1].color & 255u)) * _e3138) * _e2821.u)) + ((f32((_e3096[2].color & 255u)) * _e3160) * _e2821.v))) * _e3173.x);
            let _e3177 = ((_e3102.base_color.y * ((((f32(((_e3096[0].color >> bitcast<u32>(8i)) & 255u)) * _e3119) * _e2827) + ((f32(((_e3096[1].color >> bitcast<u32>(8i)) & 255u)) * _e3138) * _e2821.u)) + ((f32(((_e3096[2].color >> bitcast<u32>(8i)) & 255u)) * _e3160) * _e2821.v))) * _e3173.y);
            let _e3179 = ((_e3102.base_color.z * ((((f32(((_e3096[0].color >> bitcast<u32>(16i)) & 255u)) * _e3119) * _e2827) + ((f32(((_e3096[1].color >> bitcast<u32>(16i)) & 255u)) * _e3138) * _e2821.u)) + ((f32(((_e3096[2].color >> bitcast<u32>(16i)) & 255u)) * _e3160) * _e2821.v))) * _e3173.z);
            let _e3180 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e3009, _e3012);
            let _e3181 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e3006, _e3180);
            if ((_e3102.flags & 2u) == 0u) {
                phi_3866_ = 0u;
            } else {
                phi_3866_ = 1u;
            }
            let _e3186 = phi_3866_;
            if (_e3096[0].normal == 2147516416u) {
                phi_4096_ = _e3074;
            } else {
                let _e3199 = (f32((bitcast<i32>((_e3096[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3205 = (f32((bitcast<i32>(_e3096[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3209 = ((1f - abs(_e3199)) - abs(_e3205));
                if (_e3209 < 0f) {
                    phi_3893_ = -(_e3209);
                } else {
                    phi_3893_ = 0f;
                }
                let _e3213 = phi_3893_;
                if (_e3199 < 0f) {
                    phi_3900_ = (_e3199 + _e3213);
                } else {
                    phi_3900_ = (_e3199 - _e3213);
                }
                let _e3218 = phi_3900_;
                if (_e3205 < 0f) {
                    phi_3907_ = (_e3205 + _e3213);
                } else {
                    phi_3907_ = (_e3205 - _e3213);
                }
                let _e3223 = phi_3907_;
                let _e3230 = (1f / sqrt((((_e3218 * _e3218) + (_e3223 * _e3223)) + (_e3209 * _e3209))));
                let _e3246 = (f32((bitcast<i32>((_e3096[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3252 = (f32((bitcast<i32>(_e3096[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3256 = ((1f - abs(_e3246)) - abs(_e3252));
                if (_e3256 < 0f) {
                    phi_3942_ = -(_e3256);
                } else {
                    phi_3942_ = 0f;
                }
                let _e3260 = phi_3942_;
                if (_e3246 < 0f) {
                    phi_3949_ = (_e3246 + _e3260);
                } else {
                    phi_3949_ = (_e3246 - _e3260);
                }
                let _e3265 = phi_3949_;
                if (_e3252 < 0f) {
                    phi_3956_ = (_e3252 + _e3260);
                } else {
                    phi_3956_ = (_e3252 - _e3260);
                }
                let _e3270 = phi_3956_;
                let _e3277 = (1f / sqrt((((_e3265 * _e3265) + (_e3270 * _e3270)) + (_e3256 * _e3256))));
                let _e3296 = (f32((bitcast<i32>((_e3096[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3302 = (f32((bitcast<i32>(_e3096[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3306 = ((1f - abs(_e3296)) - abs(_e3302));
                if (_e3306 < 0f) {
                    phi_3994_ = -(_e3306);
                } else {
                    phi_3994_ = 0f;
                }
                let _e3310 = phi_3994_;
                if (_e3296 < 0f) {
                    phi_4001_ = (_e3296 + _e3310);
                } else {
                    phi_4001_ = (_e3296 - _e3310);
                }
                let _e3315 = phi_4001_;
                if (_e3302 < 0f) {
                    phi_4008_ = (_e3302 + _e3310);
                } else {
                    phi_4008_ = (_e3302 - _e3310);
                }
                let _e3320 = phi_4008_;
                let _e3327 = (1f / sqrt((((_e3315 * _e3315) + (_e3320 * _e3320)) + (_e3306 * _e3306))));
                let _e3334 = ((((_e3218 * _e3230) * _e2827) + ((_e3265 * _e3277) * _e2821.u)) + ((_e3315 * _e3327) * _e2821.v));
                let _e3335 = ((((_e3223 * _e3230) * _e2827) + ((_e3270 * _e3277) * _e2821.u)) + ((_e3320 * _e3327) * _e2821.v));
                let _e3336 = ((((_e3209 * _e3230) * _e2827) + ((_e3256 * _e3277) * _e2821.u)) + ((_e3306 * _e3327) * _e2821.v));
                if (_e2821.instance < _e91) {
                } else {
                    return;
                }
                let _e3343 = instances.member[(0u + _e2821.instance)].world_to_object[0u];
                let _e3352 = instances.member[(0u + _e2821.instance)].world_to_object[1u];
                let _e3364 = instances.member[(0u + _e2821.instance)].world_to_object[2u];
                let _e3371 = (((_e3343.x * _e3334) + (_e3352.x * _e3335)) + (_e3364.x * _e3336));
                let _e3372 = (((_e3343.y * _e3334) + (_e3352.y * _e3335)) + (_e3364.y * _e3336));
                let _e3373 = (((_e3343.z * _e3334) + (_e3352.z * _e3335)) + (_e3364.z * _e3336));
                let _e3379 = sqrt((((_e3371 * _e3371) + (_e3372 * _e3372)) + (_e3373 * _e3373)));
                if (_e3379 > 0f) {
                    let _e3381 = (_e3371 / _e3379);
                    let _e3382 = (_e3372 / _e3379);
                    let _e3383 = (_e3373 / _e3379);
                    if ((((_e3381 * _e3074.x) + (_e3382 * _e3074.y)) + (_e3383 * _e3074.z)) < 0f) {
                        phi_4094_ = vec3<f32>(-(_e3381), -(_e3382), -(_e3383));
                    } else {
                        phi_4094_ = vec3<f32>(_e3381, _e3382, _e3383);
                    }
                    let _e3399 = phi_4094_;
                    phi_4095_ = _e3399;
                } else {
                    phi_4095_ = _e3074;
                }
                let _e3401 = phi_4095_;
                phi_4096_ = _e3401;
            }
            let _e3403 = phi_4096_;
            if (_e3175 > 0f) {
                if (_e3175 < 1f) {
                    phi_4105_ = _e3175;
                } else {
                    phi_4105_ = 1f;
                }
                let _e3407 = phi_4105_;
                phi_4106_ = _e3407;
            } else {
                phi_4106_ = 0f;
            }
            let _e3409 = phi_4106_;
            if (_e3177 > 0f) {
                if (_e3177 < 1f) {
                    phi_4116_ = _e3177;
                } else {
                    phi_4116_ = 1f;
                }
                let _e3414 = phi_4116_;
                phi_4117_ = _e3414;
            } else {
                phi_4117_ = 0f;
            }
            let _e3416 = phi_4117_;
            if (_e3179 > 0f) {
                if (_e3179 < 1f) {
                    phi_4127_ = _e3179;
                } else {
                    phi_4127_ = 1f;
                }
                let _e3421 = phi_4127_;
                phi_4128_ = _e3421;
            } else {
                phi_4128_ = 0f;
            }
            let _e3423 = phi_4128_;
            let _e3426 = ((sqrt(_e3409) * 255f) + 0.5f);
            let _e3435 = ((sqrt(_e3416) * 255f) + 0.5f);
            let _e3447 = ((sqrt(_e3423) * 255f) + 0.5f);
            phi_4163_ = abi_Sample(vec3<f32>(_e2982, _e2983, _e2984), _e3181, _e3074, _e3186, _e3403, ((select(select(u32(_e3426), 0u, (_e3426 < bitcast<f32>(0u))), 4294967295u, (_e3426 > bitcast<f32>(1333788671u))) | (select(select(u32(_e3435), 0u, (_e3435 < bitcast<f32>(0u))), 4294967295u, (_e3435 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e3447), 0u, (_e3447 < bitcast<f32>(0u))), 4294967295u, (_e3447 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_4163_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e3461 = phi_4163_;
        if (_e100.shift < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e100.shift)] = _e3461;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_instanced_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
