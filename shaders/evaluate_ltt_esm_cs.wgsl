struct abi_LightParams {
    place: vec4<f32>,
    axis: vec3<f32>,
    cos_outer: f32,
    range_squared: f32,
    cos_inner: f32,
    number: u32,
    mask_words: u32,
}

struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_10 {
    member: array<abi_Sample>,
}

struct type_14 {
    member: array<u32>,
}

struct type_18 {
    member: array<f32>,
}

struct lt_mask_LightPlace {
    word: u32,
    shift: u32,
}

struct evaluate_Verdict {
    visibility: f32,
    is_doubted: bool,
}

struct u0028_evaluate_Verdict_u0020_bool_u0029_ {
    unnamed: evaluate_Verdict,
    unnamed_1: bool,
}

struct lt_math_LightProjection {
    row_x: vec4<f32>,
    row_y: vec4<f32>,
    row_z: vec4<f32>,
    row_w: vec4<f32>,
}

struct abi_ShadowParams {
    projection: lt_math_LightProjection,
    light: abi_LightParams,
    test: vec4<f32>,
    size: vec2<u32>,
    map_size: u32,
    epsilon: f32,
    root: u32,
    level_count: u32,
    pad0_: u32,
    pad1_: u32,
}

struct type_38 {
    member: abi_ShadowParams,
}

struct lt_math_OneLevel {
    projection: lt_math_LightProjection,
}

struct type_45 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
var<private> local_2: u32;
@group(0) @binding(1) 
var<storage> samples: type_10;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(0) 
var<uniform> p: type_38;
@group(0) @binding(2) 
var<storage> map: type_18;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_18;
@group(0) @binding(4) 
var<storage, read_write> list: type_45;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_mask_LightPlace {
    var phi_160_: lt_mask_LightPlace;
    var phi_161_: bool;
    var phi_162_: lt_mask_LightPlace;
    var phi_163_: bool;
    var phi_168_: lt_mask_LightPlace;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_160_ = lt_mask_LightPlace(1u, ((param.y * param_1) + param.x));
            phi_161_ = false;
        } else {
            phi_160_ = lt_mask_LightPlace();
            phi_161_ = true;
        }
        let _e63 = phi_160_;
        let _e65 = phi_161_;
        phi_162_ = _e63;
        phi_163_ = _e65;
    } else {
        phi_162_ = lt_mask_LightPlace();
        phi_163_ = true;
    }
    let _e67 = phi_162_;
    let _e69 = phi_163_;
    if _e69 {
        phi_168_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_168_ = _e67;
    }
    let _e74 = phi_168_;
    return lt_mask_LightPlace(_e74.word, _e74.shift);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_esm_Esm_clamped_exponent(param_4: ptr<function, f32>) -> f32 {
    var phi_188_: bool;
    var phi_192_: f32;

    let _e51 = (*param_4);
    if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
        phi_188_ = true;
    } else {
        let _e55 = (84f < _e51);
        if _e55 {
        }
        phi_188_ = _e55;
    }
    let _e57 = phi_188_;
    if _e57 {
        phi_192_ = 84f;
    } else {
        phi_192_ = _e51;
    }
    let _e59 = phi_192_;
    return _e59;
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_5: ptr<function, f32>, param_6: vec4<f32>, param_7: vec4<f32>, param_8: f32) -> f32 {
    var phi_213_: f32;
    var phi_214_: f32;
    var phi_215_: f32;
    var phi_231_: f32;
    var phi_232_: f32;
    var phi_233_: f32;
    var phi_249_: f32;
    var phi_250_: f32;
    var phi_251_: f32;
    var phi_267_: f32;
    var phi_268_: f32;
    var phi_269_: f32;
    var phi_285_: f32;
    var phi_286_: f32;
    var phi_287_: f32;
    var phi_306_: f32;
    var phi_311_: f32;
    var phi_333_: f32;
    var phi_338_: f32;
    var phi_339_: bool;
    var phi_340_: f32;
    var phi_341_: bool;
    var phi_345_: f32;
    var phi_383_: f32;
    var phi_394_: f32;
    var phi_399_: f32;
    var phi_421_: f32;
    var phi_426_: f32;
    var phi_427_: bool;
    var phi_428_: f32;
    var phi_429_: bool;
    var phi_433_: f32;
    var phi_471_: f32;
    var phi_482_: f32;
    var phi_487_: f32;
    var phi_509_: f32;
    var phi_514_: f32;
    var phi_515_: bool;
    var phi_516_: f32;
    var phi_517_: bool;
    var phi_521_: f32;
    var phi_559_: f32;
    var phi_570_: f32;
    var phi_575_: f32;
    var phi_597_: f32;
    var phi_602_: f32;
    var phi_603_: bool;
    var phi_604_: f32;
    var phi_605_: bool;
    var phi_609_: f32;
    var phi_647_: f32;
    var phi_673_: f32;
    var phi_674_: f32;
    var phi_675_: f32;

    let _e54 = _lt_math_esm_Esm_clamped_exponent(param_5);
    if ((bitcast<u32>(param_8) & 2147483647u) > 2139095040u) {
        phi_215_ = param_8;
    } else {
        if (param_8 < 0f) {
            phi_214_ = 0f;
        } else {
            if (param_8 > 1f) {
                phi_213_ = 1f;
            } else {
                phi_213_ = param_8;
            }
            let _e61 = phi_213_;
            phi_214_ = _e61;
        }
        let _e63 = phi_214_;
        phi_215_ = _e63;
    }
    let _e65 = phi_215_;
    if ((bitcast<u32>(param_6.x) & 2147483647u) > 2139095040u) {
        phi_233_ = param_6.x;
    } else {
        if (param_6.x < 0f) {
            phi_232_ = 0f;
        } else {
            if (param_6.x > 1f) {
                phi_231_ = 1f;
            } else {
                phi_231_ = param_6.x;
            }
            let _e73 = phi_231_;
            phi_232_ = _e73;
        }
        let _e75 = phi_232_;
        phi_233_ = _e75;
    }
    let _e77 = phi_233_;
    if ((bitcast<u32>(param_6.y) & 2147483647u) > 2139095040u) {
        phi_251_ = param_6.y;
    } else {
        if (param_6.y < 0f) {
            phi_250_ = 0f;
        } else {
            if (param_6.y > 1f) {
                phi_249_ = 1f;
            } else {
                phi_249_ = param_6.y;
            }
            let _e85 = phi_249_;
            phi_250_ = _e85;
        }
        let _e87 = phi_250_;
        phi_251_ = _e87;
    }
    let _e89 = phi_251_;
    if ((bitcast<u32>(param_6.z) & 2147483647u) > 2139095040u) {
        phi_269_ = param_6.z;
    } else {
        if (param_6.z < 0f) {
            phi_268_ = 0f;
        } else {
            if (param_6.z > 1f) {
                phi_267_ = 1f;
            } else {
                phi_267_ = param_6.z;
            }
            let _e97 = phi_267_;
            phi_268_ = _e97;
        }
        let _e99 = phi_268_;
        phi_269_ = _e99;
    }
    let _e101 = phi_269_;
    if ((bitcast<u32>(param_6.w) & 2147483647u) > 2139095040u) {
        phi_287_ = param_6.w;
    } else {
        if (param_6.w < 0f) {
            phi_286_ = 0f;
        } else {
            if (param_6.w > 1f) {
                phi_285_ = 1f;
            } else {
                phi_285_ = param_6.w;
            }
            let _e109 = phi_285_;
            phi_286_ = _e109;
        }
        let _e111 = phi_286_;
        phi_287_ = _e111;
    }
    let _e113 = phi_287_;
    let _e118 = (_e54 * (_e77 - _e65));
    let _e119 = (_e54 * (_e89 - _e65));
    let _e120 = (_e54 * (_e101 - _e65));
    let _e121 = (_e54 * (_e113 - _e65));
    if ((bitcast<u32>(_e118) & 2147483647u) > 2139095040u) {
        phi_383_ = _e118;
    } else {
        if (_e118 < -87f) {
            phi_306_ = -87f;
        } else {
            phi_306_ = _e118;
        }
        let _e127 = phi_306_;
        if (_e127 > 88f) {
            phi_311_ = 88f;
        } else {
            phi_311_ = _e127;
        }
        let _e130 = phi_311_;
        let _e132 = ((_e130 * 1.442695f) + 0.5f);
        if (_e132 > -8388608f) {
            let _e144 = f32(select(0i, select(select(i32(_e132), i32(-2147483648), (_e132 < bitcast<f32>(3472883712u))), 2147483647i, (_e132 > bitcast<f32>(1325400063u))), (_e132 == _e132)));
            if (_e144 > _e132) {
                phi_333_ = 1f;
            } else {
                phi_333_ = 0f;
            }
            let _e147 = phi_333_;
            if (_e132 < 8388608f) {
                phi_338_ = (_e144 - _e147);
                phi_339_ = false;
            } else {
                phi_338_ = f32();
                phi_339_ = true;
            }
            let _e150 = phi_338_;
            let _e152 = phi_339_;
            phi_340_ = _e150;
            phi_341_ = _e152;
        } else {
            phi_340_ = f32();
            phi_341_ = true;
        }
        let _e154 = phi_340_;
        let _e156 = phi_341_;
        if _e156 {
            phi_345_ = _e132;
        } else {
            phi_345_ = _e154;
        }
        let _e158 = phi_345_;
        let _e162 = ((_e130 - (_e158 * 0.69314575f)) - (_e158 * 0.0000014286068f));
        phi_383_ = ((((((((((((((((1f / 5040f) * _e162) + (1f / 720f)) * _e162) + (1f / 120f)) * _e162) + (1f / 24f)) * _e162) + (1f / 6f)) * _e162) + 0.5f) * _e162) + 1f) * _e162) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e158), i32(-2147483648), (_e158 < bitcast<f32>(3472883712u))), 2147483647i, (_e158 > bitcast<f32>(1325400063u))), (_e158 == _e158)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e198 = phi_383_;
    if ((bitcast<u32>(_e119) & 2147483647u) > 2139095040u) {
        phi_471_ = _e119;
    } else {
        if (_e119 < -87f) {
            phi_394_ = -87f;
        } else {
            phi_394_ = _e119;
        }
        let _e204 = phi_394_;
        if (_e204 > 88f) {
            phi_399_ = 88f;
        } else {
            phi_399_ = _e204;
        }
        let _e207 = phi_399_;
        let _e209 = ((_e207 * 1.442695f) + 0.5f);
        if (_e209 > -8388608f) {
            let _e221 = f32(select(0i, select(select(i32(_e209), i32(-2147483648), (_e209 < bitcast<f32>(3472883712u))), 2147483647i, (_e209 > bitcast<f32>(1325400063u))), (_e209 == _e209)));
            if (_e221 > _e209) {
                phi_421_ = 1f;
            } else {
                phi_421_ = 0f;
            }
            let _e224 = phi_421_;
            if (_e209 < 8388608f) {
                phi_426_ = (_e221 - _e224);
                phi_427_ = false;
            } else {
                phi_426_ = f32();
                phi_427_ = true;
            }
            let _e227 = phi_426_;
            let _e229 = phi_427_;
            phi_428_ = _e227;
            phi_429_ = _e229;
        } else {
            phi_428_ = f32();
            phi_429_ = true;
        }
        let _e231 = phi_428_;
        let _e233 = phi_429_;
        if _e233 {
            phi_433_ = _e209;
        } else {
            phi_433_ = _e231;
        }
        let _e235 = phi_433_;
        let _e239 = ((_e207 - (_e235 * 0.69314575f)) - (_e235 * 0.0000014286068f));
        phi_471_ = ((((((((((((((((1f / 5040f) * _e239) + (1f / 720f)) * _e239) + (1f / 120f)) * _e239) + (1f / 24f)) * _e239) + (1f / 6f)) * _e239) + 0.5f) * _e239) + 1f) * _e239) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e235), i32(-2147483648), (_e235 < bitcast<f32>(3472883712u))), 2147483647i, (_e235 > bitcast<f32>(1325400063u))), (_e235 == _e235)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e275 = phi_471_;
    if ((bitcast<u32>(_e120) & 2147483647u) > 2139095040u) {
        phi_559_ = _e120;
    } else {
        if (_e120 < -87f) {
            phi_482_ = -87f;
        } else {
            phi_482_ = _e120;
        }
        let _e281 = phi_482_;
        if (_e281 > 88f) {
            phi_487_ = 88f;
        } else {
            phi_487_ = _e281;
        }
        let _e284 = phi_487_;
        let _e286 = ((_e284 * 1.442695f) + 0.5f);
        if (_e286 > -8388608f) {
            let _e298 = f32(select(0i, select(select(i32(_e286), i32(-2147483648), (_e286 < bitcast<f32>(3472883712u))), 2147483647i, (_e286 > bitcast<f32>(1325400063u))), (_e286 == _e286)));
            if (_e298 > _e286) {
                phi_509_ = 1f;
            } else {
                phi_509_ = 0f;
            }
            let _e301 = phi_509_;
            if (_e286 < 8388608f) {
                phi_514_ = (_e298 - _e301);
                phi_515_ = false;
            } else {
                phi_514_ = f32();
                phi_515_ = true;
            }
            let _e304 = phi_514_;
            let _e306 = phi_515_;
            phi_516_ = _e304;
            phi_517_ = _e306;
        } else {
            phi_516_ = f32();
            phi_517_ = true;
        }
        let _e308 = phi_516_;
        let _e310 = phi_517_;
        if _e310 {
            phi_521_ = _e286;
        } else {
            phi_521_ = _e308;
        }
        let _e312 = phi_521_;
        let _e316 = ((_e284 - (_e312 * 0.69314575f)) - (_e312 * 0.0000014286068f));
        phi_559_ = ((((((((((((((((1f / 5040f) * _e316) + (1f / 720f)) * _e316) + (1f / 120f)) * _e316) + (1f / 24f)) * _e316) + (1f / 6f)) * _e316) + 0.5f) * _e316) + 1f) * _e316) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e312), i32(-2147483648), (_e312 < bitcast<f32>(3472883712u))), 2147483647i, (_e312 > bitcast<f32>(1325400063u))), (_e312 == _e312)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e352 = phi_559_;
    if ((bitcast<u32>(_e121) & 2147483647u) > 2139095040u) {
        phi_647_ = _e121;
    } else {
        if (_e121 < -87f) {
            phi_570_ = -87f;
        } else {
            phi_570_ = _e121;
        }
        let _e358 = phi_570_;
        if (_e358 > 88f) {
            phi_575_ = 88f;
        } else {
            phi_575_ = _e358;
        }
        let _e361 = phi_575_;
        let _e363 = ((_e361 * 1.442695f) + 0.5f);
        if (_e363 > -8388608f) {
            let _e375 = f32(select(0i, select(select(i32(_e363), i32(-2147483648), (_e363 < bitcast<f32>(3472883712u))), 2147483647i, (_e363 > bitcast<f32>(1325400063u))), (_e363 == _e363)));
            if (_e375 > _e363) {
                phi_597_ = 1f;
            } else {
                phi_597_ = 0f;
            }
            let _e378 = phi_597_;
            if (_e363 < 8388608f) {
                phi_602_ = (_e375 - _e378);
                phi_603_ = false;
            } else {
                phi_602_ = f32();
                phi_603_ = true;
            }
            let _e381 = phi_602_;
            let _e383 = phi_603_;
            phi_604_ = _e381;
            phi_605_ = _e383;
        } else {
            phi_604_ = f32();
            phi_605_ = true;
        }
        let _e385 = phi_604_;
        let _e387 = phi_605_;
        if _e387 {
            phi_609_ = _e363;
        } else {
            phi_609_ = _e385;
        }
        let _e389 = phi_609_;
        let _e393 = ((_e361 - (_e389 * 0.69314575f)) - (_e389 * 0.0000014286068f));
        phi_647_ = ((((((((((((((((1f / 5040f) * _e393) + (1f / 720f)) * _e393) + (1f / 120f)) * _e393) + (1f / 24f)) * _e393) + (1f / 6f)) * _e393) + 0.5f) * _e393) + 1f) * _e393) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e389), i32(-2147483648), (_e389 < bitcast<f32>(3472883712u))), 2147483647i, (_e389 > bitcast<f32>(1325400063u))), (_e389 == _e389)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e429 = phi_647_;
    let _e440 = ((((_e198 * param_7.x) + (_e275 * param_7.y)) + (_e352 * param_7.z)) + (_e429 * param_7.w));
    if ((bitcast<u32>(_e440) & 2147483647u) > 2139095040u) {
        phi_675_ = _e440;
    } else {
        if (_e440 < 0f) {
            phi_674_ = 0f;
        } else {
            if (_e440 > 1f) {
                phi_673_ = 1f;
            } else {
                phi_673_ = _e440;
            }
            let _e447 = phi_673_;
            phi_674_ = _e447;
        }
        let _e449 = phi_674_;
        phi_675_ = _e449;
    }
    let _e451 = phi_675_;
    return _e451;
}

fn function_() {
    var local_1: f32;
    var phi_726_: bool;
    var phi_727_: bool;
    var phi_728_: bool;
    var phi_729_: bool;
    var phi_733_: bool;
    var phi_803_: bool;
    var phi_804_: bool;
    var phi_815_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_816_: bool;
    var phi_817_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_818_: bool;
    var phi_825_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_829_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_903_: bool;
    var phi_912_: bool;
    var phi_921_: bool;
    var phi_922_: bool;
    var phi_923_: bool;
    var phi_924_: bool;
    var phi_925_: bool;
    var phi_926_: bool;
    var phi_927_: bool;
    var phi_931_: bool;
    var phi_1021_: f32;
    var phi_1024_: f32;
    var phi_1053_: f32;
    var phi_1058_: f32;
    var phi_1059_: bool;
    var phi_1060_: f32;
    var phi_1061_: bool;
    var phi_1065_: f32;
    var phi_1085_: f32;
    var phi_1090_: f32;
    var phi_1091_: bool;
    var phi_1092_: f32;
    var phi_1093_: bool;
    var phi_1097_: f32;
    var phi_1145_: i32;
    var phi_1150_: i32;
    var phi_1155_: i32;
    var phi_1160_: i32;
    var phi_1169_: i32;
    var phi_1174_: i32;
    var phi_1179_: i32;
    var phi_1184_: i32;
    var phi_1235_: bool;
    var phi_1243_: bool;
    var phi_1255_: bool;
    var phi_1256_: bool;
    var phi_1260_: f32;
    var phi_1266_: f32;
    var phi_1268_: evaluate_Verdict;
    var phi_1273_: evaluate_Verdict;
    var phi_1274_: evaluate_Verdict;
    var phi_1278_: bool;
    var phi_1279_: u32;
    var phi_1290_: u32;

    let _e51 = id_1;
    let _e52 = local_2;
    let _e57 = arrayLength((&map.member));
    let _e62 = p.member.size[0u];
    let _e64 = p.member.size[1u];
    let _e65 = lt_shaders_entry_pixel_index(_e51, _e62, _e64);
    if (bitcast<i32>(_e65.word) != 0i) {
        let _e72 = p.member.projection;
        let _e73 = lt_math_OneLevel(_e72);
        let _e77 = samples.member[_e65.shift].normal[0u];
        let _e79 = global[0u];
        if (_e77 == _e79) {
            let _e82 = samples.member[_e65.shift].normal[1u];
            let _e84 = global[1u];
            if (_e82 == _e84) {
                let _e87 = samples.member[_e65.shift].normal[2u];
                let _e89 = global[2u];
                phi_726_ = (_e87 == _e89);
                phi_727_ = false;
            } else {
                phi_726_ = bool();
                phi_727_ = true;
            }
            let _e92 = phi_726_;
            let _e94 = phi_727_;
            phi_728_ = _e92;
            phi_729_ = _e94;
        } else {
            phi_728_ = bool();
            phi_729_ = true;
        }
        let _e96 = phi_728_;
        let _e98 = phi_729_;
        if _e98 {
            phi_733_ = false;
        } else {
            phi_733_ = _e96;
        }
        let _e100 = phi_733_;
        if !(_e100) {
            let _e103 = samples.member[_e65.shift].position;
            let _e105 = p.member.light.place;
            let _e111 = p.member.light.place[3u];
            let _e118 = (_e105.x - (_e103.x * _e111));
            let _e119 = (_e105.y - (_e103.y * _e111));
            let _e120 = (_e105.z - (_e103.z * _e111));
            let _e122 = samples.member[_e65.shift].normal;
            if ((((_e122.x * _e118) + (_e122.y * _e119)) + (_e122.z * _e120)) > 0f) {
                let _e136 = (((_e118 * _e118) + (_e119 * _e119)) + (_e120 * _e120));
                let _e138 = p.member.light.axis;
                let _e150 = p.member.light.place[3u];
                if (_e150 == 0f) {
                    phi_804_ = true;
                } else {
                    let _e153 = p.member.light.range_squared;
                    if (_e136 <= _e153) {
                        let _e156 = p.member.light.cos_outer;
                        phi_803_ = (-((((_e118 * _e138.x) + (_e119 * _e138.y)) + (_e120 * _e138.z))) >= (_e156 * sqrt(_e136)));
                    } else {
                        phi_803_ = false;
                    }
                    let _e161 = phi_803_;
                    phi_804_ = _e161;
                }
                let _e163 = phi_804_;
                if _e163 {
                    let _e165 = samples.member[_e65.shift].flags;
                    let _e173 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e179 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e173.unnamed.visibility, false), _e173.unnamed_1);
                    phi_815_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e179.unnamed, ((_e165 & 1u) == 0u));
                    phi_816_ = false;
                } else {
                    phi_815_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_816_ = true;
                }
                let _e184 = phi_815_;
                let _e186 = phi_816_;
                phi_817_ = _e184;
                phi_818_ = _e186;
            } else {
                phi_817_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_818_ = true;
            }
            let _e188 = phi_817_;
            let _e190 = phi_818_;
            if _e190 {
                let _e196 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e202 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e196.unnamed.visibility, false), _e196.unnamed_1);
                phi_825_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e202.unnamed, true);
            } else {
                phi_825_ = _e188;
            }
            let _e207 = phi_825_;
            phi_829_ = _e207;
        } else {
            let _e213 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e219 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e213.unnamed.visibility, false), _e213.unnamed_1);
            phi_829_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e219.unnamed, true);
        }
        let _e224 = phi_829_;
        if _e224.unnamed_1 {
            phi_1274_ = evaluate_Verdict(_e224.unnamed.visibility, _e224.unnamed.is_doubted);
        } else {
            let _e232 = samples.member[_e65.shift].position;
            let _e250 = ((((_e73.projection.row_w.x * _e232.x) + (_e73.projection.row_w.y * _e232.y)) + (_e73.projection.row_w.z * _e232.z)) + (_e73.projection.row_w.w * 1f));
            let _e264 = (((((_e73.projection.row_x.x * _e232.x) + (_e73.projection.row_x.y * _e232.y)) + (_e73.projection.row_x.z * _e232.z)) + (_e73.projection.row_x.w * 1f)) / _e250);
            let _e278 = (((((_e73.projection.row_y.x * _e232.x) + (_e73.projection.row_y.y * _e232.y)) + (_e73.projection.row_y.z * _e232.z)) + (_e73.projection.row_y.w * 1f)) / _e250);
            let _e291 = ((((_e73.projection.row_z.x * _e232.x) + (_e73.projection.row_z.y * _e232.y)) + (_e73.projection.row_z.z * _e232.z)) + (_e73.projection.row_z.w * 1f));
            if (_e250 > 0f) {
                if (_e264 >= 0f) {
                    phi_903_ = (_e264 <= 1f);
                } else {
                    phi_903_ = false;
                }
                let _e296 = phi_903_;
                if _e296 {
                    if (_e278 >= 0f) {
                        phi_912_ = (_e278 <= 1f);
                    } else {
                        phi_912_ = false;
                    }
                    let _e300 = phi_912_;
                    if _e300 {
                        if (_e291 >= 0f) {
                            phi_921_ = (_e291 <= 1f);
                        } else {
                            phi_921_ = false;
                        }
                        let _e304 = phi_921_;
                        phi_922_ = _e304;
                        phi_923_ = false;
                    } else {
                        phi_922_ = bool();
                        phi_923_ = true;
                    }
                    let _e306 = phi_922_;
                    let _e308 = phi_923_;
                    phi_924_ = _e306;
                    phi_925_ = _e308;
                } else {
                    phi_924_ = bool();
                    phi_925_ = true;
                }
                let _e310 = phi_924_;
                let _e312 = phi_925_;
                phi_926_ = _e310;
                phi_927_ = _e312;
            } else {
                phi_926_ = bool();
                phi_927_ = true;
            }
            let _e314 = phi_926_;
            let _e316 = phi_927_;
            if _e316 {
                phi_931_ = false;
            } else {
                phi_931_ = _e314;
            }
            let _e318 = phi_931_;
            if _e318 {
                if (0f > 0f) {
                    let _e321 = samples.member[_e65.shift].normal;
                    let _e323 = p.member.map_size;
                    let _e393 = ((abs(((((_e72.row_x.x * _e321.x) + (_e72.row_x.y * _e321.y)) + (_e72.row_x.z * _e321.z)) / (((_e72.row_x.x * _e72.row_x.x) + (_e72.row_x.y * _e72.row_x.y)) + (_e72.row_x.z * _e72.row_x.z)))) + abs(((((_e72.row_y.x * _e321.x) + (_e72.row_y.y * _e321.y)) + (_e72.row_y.z * _e321.z)) / (((_e72.row_y.x * _e72.row_y.x) + (_e72.row_y.y * _e72.row_y.y)) + (_e72.row_y.z * _e72.row_y.z))))) / (abs(((((_e72.row_z.x * _e321.x) + (_e72.row_z.y * _e321.y)) + (_e72.row_z.z * _e321.z)) / (((_e72.row_z.x * _e72.row_z.x) + (_e72.row_z.y * _e72.row_z.y)) + (_e72.row_z.z * _e72.row_z.z)))) * f32(_e323)));
                    if (_e393 < 0.002f) {
                        phi_1021_ = _e393;
                    } else {
                        phi_1021_ = 0.002f;
                    }
                    let _e396 = phi_1021_;
                    phi_1024_ = (_e291 - (0f * _e396));
                } else {
                    phi_1024_ = _e291;
                }
                let _e400 = phi_1024_;
                let _e402 = p.member.map_size;
                let _e403 = f32(_e402);
                let _e406 = ((_e264 * _e403) - 0.5f);
                let _e407 = ((_e278 * _e403) - 0.5f);
                if (_e406 > -8388608f) {
                    let _e419 = f32(select(0i, select(select(i32(_e406), i32(-2147483648), (_e406 < bitcast<f32>(3472883712u))), 2147483647i, (_e406 > bitcast<f32>(1325400063u))), (_e406 == _e406)));
                    if (_e419 > _e406) {
                        phi_1053_ = 1f;
                    } else {
                        phi_1053_ = 0f;
                    }
                    let _e422 = phi_1053_;
                    if (_e406 < 8388608f) {
                        phi_1058_ = (_e419 - _e422);
                        phi_1059_ = false;
                    } else {
                        phi_1058_ = f32();
                        phi_1059_ = true;
                    }
                    let _e425 = phi_1058_;
                    let _e427 = phi_1059_;
                    phi_1060_ = _e425;
                    phi_1061_ = _e427;
                } else {
                    phi_1060_ = f32();
                    phi_1061_ = true;
                }
                let _e429 = phi_1060_;
                let _e431 = phi_1061_;
                if _e431 {
                    phi_1065_ = _e406;
                } else {
                    phi_1065_ = _e429;
                }
                let _e433 = phi_1065_;
                if (_e407 > -8388608f) {
                    let _e445 = f32(select(0i, select(select(i32(_e407), i32(-2147483648), (_e407 < bitcast<f32>(3472883712u))), 2147483647i, (_e407 > bitcast<f32>(1325400063u))), (_e407 == _e407)));
                    if (_e445 > _e407) {
                        phi_1085_ = 1f;
                    } else {
                        phi_1085_ = 0f;
                    }
                    let _e448 = phi_1085_;
                    if (_e407 < 8388608f) {
                        phi_1090_ = (_e445 - _e448);
                        phi_1091_ = false;
                    } else {
                        phi_1090_ = f32();
                        phi_1091_ = true;
                    }
                    let _e451 = phi_1090_;
                    let _e453 = phi_1091_;
                    phi_1092_ = _e451;
                    phi_1093_ = _e453;
                } else {
                    phi_1092_ = f32();
                    phi_1093_ = true;
                }
                let _e455 = phi_1092_;
                let _e457 = phi_1093_;
                if _e457 {
                    phi_1097_ = _e407;
                } else {
                    phi_1097_ = _e455;
                }
                let _e459 = phi_1097_;
                let _e460 = (_e406 - _e433);
                let _e461 = (_e407 - _e459);
                let _e470 = select(0i, select(select(i32(_e433), i32(-2147483648), (_e433 < bitcast<f32>(3472883712u))), 2147483647i, (_e433 > bitcast<f32>(1325400063u))), (_e433 == _e433));
                let _e479 = select(0i, select(select(i32(_e459), i32(-2147483648), (_e459 < bitcast<f32>(3472883712u))), 2147483647i, (_e459 > bitcast<f32>(1325400063u))), (_e459 == _e459));
                let _e490 = p.member.test;
                let _e491 = _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e490);
                let _e493 = p.member.map_size;
                local_1 = _e491;
                let _e495 = ((0u * _e493) * _e493);
                let _e497 = (bitcast<i32>(_e493) - 1i);
                if (_e470 > 0i) {
                    phi_1145_ = _e470;
                } else {
                    phi_1145_ = 0i;
                }
                let _e500 = phi_1145_;
                if (_e479 > 0i) {
                    phi_1150_ = _e479;
                } else {
                    phi_1150_ = 0i;
                }
                let _e503 = phi_1150_;
                if (_e500 < _e497) {
                    phi_1155_ = _e500;
                } else {
                    phi_1155_ = _e497;
                }
                let _e506 = phi_1155_;
                if (_e503 < _e497) {
                    phi_1160_ = _e503;
                } else {
                    phi_1160_ = _e497;
                }
                let _e509 = phi_1160_;
                let _e510 = bitcast<u32>(_e506);
                let _e512 = (_e470 + 1i);
                let _e513 = (_e479 + 1i);
                if (_e512 > 0i) {
                    phi_1169_ = _e512;
                } else {
                    phi_1169_ = 0i;
                }
                let _e516 = phi_1169_;
                if (_e513 > 0i) {
                    phi_1174_ = _e513;
                } else {
                    phi_1174_ = 0i;
                }
                let _e519 = phi_1174_;
                if (_e516 < _e497) {
                    phi_1179_ = _e516;
                } else {
                    phi_1179_ = _e497;
                }
                let _e522 = phi_1179_;
                if (_e519 < _e497) {
                    phi_1184_ = _e519;
                } else {
                    phi_1184_ = _e497;
                }
                let _e525 = phi_1184_;
                let _e526 = bitcast<u32>(_e522);
                let _e528 = (bitcast<u32>(_e509) * _e493);
                let _e529 = (bitcast<u32>(_e525) * _e493);
                let _e534 = ((_e528 + _e510) + _e495);
                let _e535 = ((_e528 + _e526) + _e495);
                let _e536 = ((_e529 + _e510) + _e495);
                let _e537 = ((_e529 + _e526) + _e495);
                if (_e534 < _e57) {
                } else {
                    return;
                }
                let _e541 = map.member[(0u + _e534)];
                if (_e535 < _e57) {
                } else {
                    return;
                }
                let _e545 = map.member[(0u + _e535)];
                if (_e536 < _e57) {
                } else {
                    return;
                }
                let _e549 = map.member[(0u + _e536)];
                if (_e537 < _e57) {
                } else {
                    return;
                }
                let _e553 = map.member[(0u + _e537)];
                let _e555 = _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local_1), vec4<f32>(_e541, _e545, _e549, _e553), vec4<f32>(((1f - _e460) * (1f - _e461)), (_e460 * (1f - _e461)), ((1f - _e460) * _e461), (_e460 * _e461)), _e400);
                let _e557 = p.member.epsilon;
                if (_e555 <= _e557) {
                    phi_1235_ = true;
                } else {
                    phi_1235_ = (_e555 >= (1f - _e557));
                }
                let _e562 = phi_1235_;
                if ((bitcast<u32>(_e555) & 2147483647u) > 2139095040u) {
                    phi_1243_ = true;
                } else {
                    phi_1243_ = !(_e562);
                }
                let _e568 = phi_1243_;
                if _e568 {
                    if (_e555 > 0f) {
                        if (_e555 < 1f) {
                            phi_1255_ = false;
                        } else {
                            phi_1255_ = true;
                        }
                        let _e572 = phi_1255_;
                        phi_1256_ = _e572;
                    } else {
                        phi_1256_ = true;
                    }
                    let _e574 = phi_1256_;
                    if _e574 {
                        phi_1260_ = 0.5f;
                    } else {
                        phi_1260_ = _e555;
                    }
                    let _e576 = phi_1260_;
                    phi_1268_ = evaluate_Verdict(_e576, true);
                } else {
                    if (_e555 > 0.5f) {
                        phi_1266_ = 1f;
                    } else {
                        phi_1266_ = 0f;
                    }
                    let _e580 = phi_1266_;
                    phi_1268_ = evaluate_Verdict(_e580, false);
                }
                let _e583 = phi_1268_;
                phi_1273_ = evaluate_Verdict(_e583.visibility, _e583.is_doubted);
            } else {
                phi_1273_ = evaluate_Verdict(0.5f, true);
            }
            let _e589 = phi_1273_;
            phi_1274_ = _e589;
        }
        let _e591 = phi_1274_;
        visibility.member[_e65.shift] = _e591.visibility;
        phi_1278_ = _e591.is_doubted;
        phi_1279_ = _e65.shift;
    } else {
        phi_1278_ = false;
        phi_1279_ = 0u;
    }
    let _e596 = phi_1278_;
    let _e598 = phi_1279_;
    if (_e52 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e596 {
        let _e602 = atomicAdd((&shared_[0u]), 1u);
        phi_1290_ = _e602;
    } else {
        phi_1290_ = 0u;
    }
    let _e604 = phi_1290_;
    workgroupBarrier();
    if (_e52 == 0u) {
        let _e608 = atomicLoad((&shared_[0u]));
        let _e609 = atomicAdd((&list.member[3u]), _e608);
        atomicStore((&shared_[1u]), _e609);
    }
    workgroupBarrier();
    if _e596 {
        let _e612 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e612) + _e604)]), _e598);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_esm_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
