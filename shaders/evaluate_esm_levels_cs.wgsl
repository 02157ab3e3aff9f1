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

struct type_9 {
    member: array<abi_Sample>,
}

struct type_13 {
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

struct type_31 {
    member: abi_ShadowParams,
}

struct lt_math_LightPoint {
    uv: vec2<f32>,
    depth: f32,
    is_inside: bool,
}

struct type_37 {
    member: array<lt_math_LightProjection>,
}

struct lt_math_LevelPoint {
    level: u32,
    point: lt_math_LightPoint,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_31;
@group(0) @binding(2) 
var<storage> map: type_13;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_13;
@group(0) @binding(4) 
var<storage> levels: type_37;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_mask_LightPlace {
    var phi_157_: lt_mask_LightPlace;
    var phi_158_: bool;
    var phi_159_: lt_mask_LightPlace;
    var phi_160_: bool;
    var phi_165_: lt_mask_LightPlace;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_157_ = lt_mask_LightPlace(1u, ((param.y * param_1) + param.x));
            phi_158_ = false;
        } else {
            phi_157_ = lt_mask_LightPlace();
            phi_158_ = true;
        }
        let _e65 = phi_157_;
        let _e67 = phi_158_;
        phi_159_ = _e65;
        phi_160_ = _e67;
    } else {
        phi_159_ = lt_mask_LightPlace();
        phi_160_ = true;
    }
    let _e69 = phi_159_;
    let _e71 = phi_160_;
    if _e71 {
        phi_165_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_165_ = _e69;
    }
    let _e76 = phi_165_;
    return lt_mask_LightPlace(_e76.word, _e76.shift);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_esm_Esm_clamped_exponent(param_4: ptr<function, f32>) -> f32 {
    var phi_185_: bool;
    var phi_189_: f32;

    let _e53 = (*param_4);
    if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
        phi_185_ = true;
    } else {
        let _e57 = (84f < _e53);
        if _e57 {
        }
        phi_185_ = _e57;
    }
    let _e59 = phi_185_;
    if _e59 {
        phi_189_ = 84f;
    } else {
        phi_189_ = _e53;
    }
    let _e61 = phi_189_;
    return _e61;
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_5: ptr<function, f32>, param_6: vec4<f32>, param_7: vec4<f32>, param_8: f32) -> f32 {
    var phi_210_: f32;
    var phi_211_: f32;
    var phi_212_: f32;
    var phi_228_: f32;
    var phi_229_: f32;
    var phi_230_: f32;
    var phi_246_: f32;
    var phi_247_: f32;
    var phi_248_: f32;
    var phi_264_: f32;
    var phi_265_: f32;
    var phi_266_: f32;
    var phi_282_: f32;
    var phi_283_: f32;
    var phi_284_: f32;
    var phi_303_: f32;
    var phi_308_: f32;
    var phi_330_: f32;
    var phi_335_: f32;
    var phi_336_: bool;
    var phi_337_: f32;
    var phi_338_: bool;
    var phi_342_: f32;
    var phi_380_: f32;
    var phi_391_: f32;
    var phi_396_: f32;
    var phi_418_: f32;
    var phi_423_: f32;
    var phi_424_: bool;
    var phi_425_: f32;
    var phi_426_: bool;
    var phi_430_: f32;
    var phi_468_: f32;
    var phi_479_: f32;
    var phi_484_: f32;
    var phi_506_: f32;
    var phi_511_: f32;
    var phi_512_: bool;
    var phi_513_: f32;
    var phi_514_: bool;
    var phi_518_: f32;
    var phi_556_: f32;
    var phi_567_: f32;
    var phi_572_: f32;
    var phi_594_: f32;
    var phi_599_: f32;
    var phi_600_: bool;
    var phi_601_: f32;
    var phi_602_: bool;
    var phi_606_: f32;
    var phi_644_: f32;
    var phi_670_: f32;
    var phi_671_: f32;
    var phi_672_: f32;

    let _e56 = _lt_math_esm_Esm_clamped_exponent(param_5);
    if ((bitcast<u32>(param_8) & 2147483647u) > 2139095040u) {
        phi_212_ = param_8;
    } else {
        if (param_8 < 0f) {
            phi_211_ = 0f;
        } else {
            if (param_8 > 1f) {
                phi_210_ = 1f;
            } else {
                phi_210_ = param_8;
            }
            let _e63 = phi_210_;
            phi_211_ = _e63;
        }
        let _e65 = phi_211_;
        phi_212_ = _e65;
    }
    let _e67 = phi_212_;
    if ((bitcast<u32>(param_6.x) & 2147483647u) > 2139095040u) {
        phi_230_ = param_6.x;
    } else {
        if (param_6.x < 0f) {
            phi_229_ = 0f;
        } else {
            if (param_6.x > 1f) {
                phi_228_ = 1f;
            } else {
                phi_228_ = param_6.x;
            }
            let _e75 = phi_228_;
            phi_229_ = _e75;
        }
        let _e77 = phi_229_;
        phi_230_ = _e77;
    }
    let _e79 = phi_230_;
    if ((bitcast<u32>(param_6.y) & 2147483647u) > 2139095040u) {
        phi_248_ = param_6.y;
    } else {
        if (param_6.y < 0f) {
            phi_247_ = 0f;
        } else {
            if (param_6.y > 1f) {
                phi_246_ = 1f;
            } else {
                phi_246_ = param_6.y;
            }
            let _e87 = phi_246_;
            phi_247_ = _e87;
        }
        let _e89 = phi_247_;
        phi_248_ = _e89;
    }
    let _e91 = phi_248_;
    if ((bitcast<u32>(param_6.z) & 2147483647u) > 2139095040u) {
        phi_266_ = param_6.z;
    } else {
        if (param_6.z < 0f) {
            phi_265_ = 0f;
        } else {
            if (param_6.z > 1f) {
                phi_264_ = 1f;
            } else {
                phi_264_ = param_6.z;
            }
            let _e99 = phi_264_;
            phi_265_ = _e99;
        }
        let _e101 = phi_265_;
        phi_266_ = _e101;
    }
    let _e103 = phi_266_;
    if ((bitcast<u32>(param_6.w) & 2147483647u) > 2139095040u) {
        phi_284_ = param_6.w;
    } else {
        if (param_6.w < 0f) {
            phi_283_ = 0f;
        } else {
            if (param_6.w > 1f) {
                phi_282_ = 1f;
            } else {
                phi_282_ = param_6.w;
            }
            let _e111 = phi_282_;
            phi_283_ = _e111;
        }
        let _e113 = phi_283_;
        phi_284_ = _e113;
    }
    let _e115 = phi_284_;
    let _e120 = (_e56 * (_e79 - _e67));
    let _e121 = (_e56 * (_e91 - _e67));
    let _e122 = (_e56 * (_e103 - _e67));
    let _e123 = (_e56 * (_e115 - _e67));
    if ((bitcast<u32>(_e120) & 2147483647u) > 2139095040u) {
        phi_380_ = _e120;
    } else {
        if (_e120 < -87f) {
            phi_303_ = -87f;
        } else {
            phi_303_ = _e120;
        }
        let _e129 = phi_303_;
        if (_e129 > 88f) {
            phi_308_ = 88f;
        } else {
            phi_308_ = _e129;
        }
        let _e132 = phi_308_;
        let _e134 = ((_e132 * 1.442695f) + 0.5f);
        if (_e134 > -8388608f) {
            let _e146 = f32(select(0i, select(select(i32(_e134), i32(-2147483648), (_e134 < bitcast<f32>(3472883712u))), 2147483647i, (_e134 > bitcast<f32>(1325400063u))), (_e134 == _e134)));
            if (_e146 > _e134) {
                phi_330_ = 1f;
            } else {
                phi_330_ = 0f;
            }
            let _e149 = phi_330_;
            if (_e134 < 8388608f) {
                phi_335_ = (_e146 - _e149);
                phi_336_ = false;
            } else {
                phi_335_ = f32();
                phi_336_ = true;
            }
            let _e152 = phi_335_;
            let _e154 = phi_336_;
            phi_337_ = _e152;
            phi_338_ = _e154;
        } else {
            phi_337_ = f32();
            phi_338_ = true;
        }
        let _e156 = phi_337_;
        let _e158 = phi_338_;
        if _e158 {
            phi_342_ = _e134;
        } else {
            phi_342_ = _e156;
        }
        let _e160 = phi_342_;
        let _e164 = ((_e132 - (_e160 * 0.69314575f)) - (_e160 * 0.0000014286068f));
        phi_380_ = ((((((((((((((((1f / 5040f) * _e164) + (1f / 720f)) * _e164) + (1f / 120f)) * _e164) + (1f / 24f)) * _e164) + (1f / 6f)) * _e164) + 0.5f) * _e164) + 1f) * _e164) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e160), i32(-2147483648), (_e160 < bitcast<f32>(3472883712u))), 2147483647i, (_e160 > bitcast<f32>(1325400063u))), (_e160 == _e160)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e200 = phi_380_;
    if ((bitcast<u32>(_e121) & 2147483647u) > 2139095040u) {
        phi_468_ = _e121;
    } else {
        if (_e121 < -87f) {
            phi_391_ = -87f;
        } else {
            phi_391_ = _e121;
        }
        let _e206 = phi_391_;
        if (_e206 > 88f) {
            phi_396_ = 88f;
        } else {
            phi_396_ = _e206;
        }
        let _e209 = phi_396_;
        let _e211 = ((_e209 * 1.442695f) + 0.5f);
        if (_e211 > -8388608f) {
            let _e223 = f32(select(0i, select(select(i32(_e211), i32(-2147483648), (_e211 < bitcast<f32>(3472883712u))), 2147483647i, (_e211 > bitcast<f32>(1325400063u))), (_e211 == _e211)));
            if (_e223 > _e211) {
                phi_418_ = 1f;
            } else {
                phi_418_ = 0f;
            }
            let _e226 = phi_418_;
            if (_e211 < 8388608f) {
                phi_423_ = (_e223 - _e226);
                phi_424_ = false;
            } else {
                phi_423_ = f32();
                phi_424_ = true;
            }
            let _e229 = phi_423_;
            let _e231 = phi_424_;
            phi_425_ = _e229;
            phi_426_ = _e231;
        } else {
            phi_425_ = f32();
            phi_426_ = true;
        }
        let _e233 = phi_425_;
        let _e235 = phi_426_;
        if _e235 {
            phi_430_ = _e211;
        } else {
            phi_430_ = _e233;
        }
        let _e237 = phi_430_;
        let _e241 = ((_e209 - (_e237 * 0.69314575f)) - (_e237 * 0.0000014286068f));
        phi_468_ = ((((((((((((((((1f / 5040f) * _e241) + (1f / 720f)) * _e241) + (1f / 120f)) * _e241) + (1f / 24f)) * _e241) + (1f / 6f)) * _e241) + 0.5f) * _e241) + 1f) * _e241) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e237), i32(-2147483648), (_e237 < bitcast<f32>(3472883712u))), 2147483647i, (_e237 > bitcast<f32>(1325400063u))), (_e237 == _e237)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e277 = phi_468_;
    if ((bitcast<u32>(_e122) & 2147483647u) > 2139095040u) {
        phi_556_ = _e122;
    } else {
        if (_e122 < -87f) {
            phi_479_ = -87f;
        } else {
            phi_479_ = _e122;
        }
        let _e283 = phi_479_;
        if (_e283 > 88f) {
            phi_484_ = 88f;
        } else {
            phi_484_ = _e283;
        }
        let _e286 = phi_484_;
        let _e288 = ((_e286 * 1.442695f) + 0.5f);
        if (_e288 > -8388608f) {
            let _e300 = f32(select(0i, select(select(i32(_e288), i32(-2147483648), (_e288 < bitcast<f32>(3472883712u))), 2147483647i, (_e288 > bitcast<f32>(1325400063u))), (_e288 == _e288)));
            if (_e300 > _e288) {
                phi_506_ = 1f;
            } else {
                phi_506_ = 0f;
            }
            let _e303 = phi_506_;
            if (_e288 < 8388608f) {
                phi_511_ = (_e300 - _e303);
                phi_512_ = false;
            } else {
                phi_511_ = f32();
                phi_512_ = true;
            }
            let _e306 = phi_511_;
            let _e308 = phi_512_;
            phi_513_ = _e306;
            phi_514_ = _e308;
        } else {
            phi_513_ = f32();
            phi_514_ = true;
        }
        let _e310 = phi_513_;
        let _e312 = phi_514_;
        if _e312 {
            phi_518_ = _e288;
        } else {
            phi_518_ = _e310;
        }
        let _e314 = phi_518_;
        let _e318 = ((_e286 - (_e314 * 0.69314575f)) - (_e314 * 0.0000014286068f));
        phi_556_ = ((((((((((((((((1f / 5040f) * _e318) + (1f / 720f)) * _e318) + (1f / 120f)) * _e318) + (1f / 24f)) * _e318) + (1f / 6f)) * _e318) + 0.5f) * _e318) + 1f) * _e318) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e314), i32(-2147483648), (_e314 < bitcast<f32>(3472883712u))), 2147483647i, (_e314 > bitcast<f32>(1325400063u))), (_e314 == _e314)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e354 = phi_556_;
    if ((bitcast<u32>(_e123) & 2147483647u) > 2139095040u) {
        phi_644_ = _e123;
    } else {
        if (_e123 < -87f) {
            phi_567_ = -87f;
        } else {
            phi_567_ = _e123;
        }
        let _e360 = phi_567_;
        if (_e360 > 88f) {
            phi_572_ = 88f;
        } else {
            phi_572_ = _e360;
        }
        let _e363 = phi_572_;
        let _e365 = ((_e363 * 1.442695f) + 0.5f);
        if (_e365 > -8388608f) {
            let _e377 = f32(select(0i, select(select(i32(_e365), i32(-2147483648), (_e365 < bitcast<f32>(3472883712u))), 2147483647i, (_e365 > bitcast<f32>(1325400063u))), (_e365 == _e365)));
            if (_e377 > _e365) {
                phi_594_ = 1f;
            } else {
                phi_594_ = 0f;
            }
            let _e380 = phi_594_;
            if (_e365 < 8388608f) {
                phi_599_ = (_e377 - _e380);
                phi_600_ = false;
            } else {
                phi_599_ = f32();
                phi_600_ = true;
            }
            let _e383 = phi_599_;
            let _e385 = phi_600_;
            phi_601_ = _e383;
            phi_602_ = _e385;
        } else {
            phi_601_ = f32();
            phi_602_ = true;
        }
        let _e387 = phi_601_;
        let _e389 = phi_602_;
        if _e389 {
            phi_606_ = _e365;
        } else {
            phi_606_ = _e387;
        }
        let _e391 = phi_606_;
        let _e395 = ((_e363 - (_e391 * 0.69314575f)) - (_e391 * 0.0000014286068f));
        phi_644_ = ((((((((((((((((1f / 5040f) * _e395) + (1f / 720f)) * _e395) + (1f / 120f)) * _e395) + (1f / 24f)) * _e395) + (1f / 6f)) * _e395) + 0.5f) * _e395) + 1f) * _e395) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e391), i32(-2147483648), (_e391 < bitcast<f32>(3472883712u))), 2147483647i, (_e391 > bitcast<f32>(1325400063u))), (_e391 == _e391)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e431 = phi_644_;
    let _e442 = ((((_e200 * param_7.x) + (_e277 * param_7.y)) + (_e354 * param_7.z)) + (_e431 * param_7.w));
    if ((bitcast<u32>(_e442) & 2147483647u) > 2139095040u) {
        phi_672_ = _e442;
    } else {
        if (_e442 < 0f) {
            phi_671_ = 0f;
        } else {
            if (_e442 > 1f) {
                phi_670_ = 1f;
            } else {
                phi_670_ = _e442;
            }
            let _e449 = phi_670_;
            phi_671_ = _e449;
        }
        let _e451 = phi_671_;
        phi_672_ = _e451;
    }
    let _e453 = phi_672_;
    return _e453;
}

fn function_() {
    var local: f32;
    var phi_732_: bool;
    var phi_733_: bool;
    var phi_734_: bool;
    var phi_735_: bool;
    var phi_739_: bool;
    var phi_809_: bool;
    var phi_810_: bool;
    var phi_821_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_822_: bool;
    var phi_823_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_824_: bool;
    var phi_831_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_835_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_855_: lt_math_LightPoint;
    var phi_858_: u32;
    var phi_860_: lt_math_LevelPoint;
    var phi_946_: bool;
    var phi_955_: bool;
    var phi_964_: bool;
    var phi_965_: bool;
    var phi_966_: bool;
    var phi_967_: bool;
    var phi_968_: bool;
    var phi_969_: bool;
    var phi_970_: bool;
    var phi_974_: bool;
    var phi_1001_: bool;
    var phi_1002_: bool;
    var phi_1003_: bool;
    var phi_1004_: bool;
    var phi_1005_: bool;
    var phi_1006_: bool;
    var phi_1007_: bool;
    var phi_1008_: bool;
    var phi_1012_: bool;
    var phi_1021_: lt_math_LightPoint;
    var phi_1022_: u32;
    var phi_1023_: lt_math_LevelPoint;
    var phi_1024_: bool;
    var phi_856_: lt_math_LightPoint;
    var phi_859_: u32;
    var phi_861_: lt_math_LevelPoint;
    var phi_1025_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_1065_: bool;
    var phi_1066_: bool;
    var phi_1067_: bool;
    var phi_1068_: bool;
    var phi_1072_: bool;
    var phi_1154_: f32;
    var phi_1272_: f32;
    var phi_1273_: f32;
    var phi_1276_: f32;
    var phi_1305_: f32;
    var phi_1310_: f32;
    var phi_1311_: bool;
    var phi_1312_: f32;
    var phi_1313_: bool;
    var phi_1317_: f32;
    var phi_1337_: f32;
    var phi_1342_: f32;
    var phi_1343_: bool;
    var phi_1344_: f32;
    var phi_1345_: bool;
    var phi_1349_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_1398_: i32;
    var phi_1403_: i32;
    var phi_1408_: i32;
    var phi_1413_: i32;
    var phi_1422_: i32;
    var phi_1427_: i32;
    var phi_1432_: i32;
    var phi_1437_: i32;
    var phi_1482_: evaluate_Verdict;
    var phi_1483_: evaluate_Verdict;
    var phi_1484_: bool;
    var phi_1485_: evaluate_Verdict;
    var phi_1486_: evaluate_Verdict;
    var phi_1487_: bool;
    var phi_1491_: evaluate_Verdict;

    let _e53 = id_1;
    let _e60 = arrayLength((&map.member));
    let _e66 = arrayLength((&levels.member));
    let _e69 = p.member.size[0u];
    let _e71 = p.member.size[1u];
    let _e72 = lt_shaders_entry_pixel_index(_e53, _e69, _e71);
    if (bitcast<i32>(_e72.word) != 0i) {
        let _e78 = p.member.level_count;
        if (_e72.shift < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e85 = samples.member[(0u + _e72.shift)].normal[0u];
        let _e87 = global[0u];
        if (_e85 == _e87) {
            let _e90 = samples.member[(0u + _e72.shift)].normal[1u];
            let _e92 = global[1u];
            if (_e90 == _e92) {
                let _e95 = samples.member[(0u + _e72.shift)].normal[2u];
                let _e97 = global[2u];
                phi_732_ = (_e95 == _e97);
                phi_733_ = false;
            } else {
                phi_732_ = bool();
                phi_733_ = true;
            }
            let _e100 = phi_732_;
            let _e102 = phi_733_;
            phi_734_ = _e100;
            phi_735_ = _e102;
        } else {
            phi_734_ = bool();
            phi_735_ = true;
        }
        let _e104 = phi_734_;
        let _e106 = phi_735_;
        if _e106 {
            phi_739_ = false;
        } else {
            phi_739_ = _e104;
        }
        let _e108 = phi_739_;
        if !(_e108) {
            let _e111 = samples.member[(0u + _e72.shift)].position;
            let _e113 = p.member.light.place;
            let _e119 = p.member.light.place[3u];
            let _e126 = (_e113.x - (_e111.x * _e119));
            let _e127 = (_e113.y - (_e111.y * _e119));
            let _e128 = (_e113.z - (_e111.z * _e119));
            let _e130 = samples.member[(0u + _e72.shift)].normal;
            if ((((_e130.x * _e126) + (_e130.y * _e127)) + (_e130.z * _e128)) > 0f) {
                let _e144 = (((_e126 * _e126) + (_e127 * _e127)) + (_e128 * _e128));
                let _e146 = p.member.light.axis;
                let _e158 = p.member.light.place[3u];
                if (_e158 == 0f) {
                    phi_810_ = true;
                } else {
                    let _e161 = p.member.light.range_squared;
                    if (_e144 <= _e161) {
                        let _e164 = p.member.light.cos_outer;
                        phi_809_ = (-((((_e126 * _e146.x) + (_e127 * _e146.y)) + (_e128 * _e146.z))) >= (_e164 * sqrt(_e144)));
                    } else {
                        phi_809_ = false;
                    }
                    let _e169 = phi_809_;
                    phi_810_ = _e169;
                }
                let _e171 = phi_810_;
                if _e171 {
                    let _e173 = samples.member[(0u + _e72.shift)].flags;
                    let _e181 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e187 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e181.unnamed.visibility, false), _e181.unnamed_1);
                    phi_821_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e187.unnamed, ((_e173 & 1u) == 0u));
                    phi_822_ = false;
                } else {
                    phi_821_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_822_ = true;
                }
                let _e192 = phi_821_;
                let _e194 = phi_822_;
                phi_823_ = _e192;
                phi_824_ = _e194;
            } else {
                phi_823_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_824_ = true;
            }
            let _e196 = phi_823_;
            let _e198 = phi_824_;
            if _e198 {
                let _e204 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e210 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e204.unnamed.visibility, false), _e204.unnamed_1);
                phi_831_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e210.unnamed, true);
            } else {
                phi_831_ = _e196;
            }
            let _e215 = phi_831_;
            phi_835_ = _e215;
        } else {
            let _e221 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e227 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e221.unnamed.visibility, false), _e221.unnamed_1);
            phi_835_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e227.unnamed, true);
        }
        let _e232 = phi_835_;
        if _e232.unnamed_1 {
            phi_1485_ = evaluate_Verdict(_e232.unnamed.visibility, _e232.unnamed.is_doubted);
            phi_1486_ = evaluate_Verdict();
            phi_1487_ = true;
        } else {
            let _e240 = samples.member[(0u + _e72.shift)].position;
            let _e242 = p.member.map_size;
            let _e244 = (0.5f / f32(_e242));
            let _e251 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e258 = lt_math_LightPoint(vec2<f32>(_e251.uv.x, 0f), _e251.depth, _e251.is_inside);
            let _e262 = lt_math_LightPoint(_e258.uv, 0f, _e258.is_inside);
            phi_855_ = lt_math_LightPoint();
            phi_858_ = 0u;
            phi_860_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e262.uv, _e262.depth, false));
            loop {
                let _e269 = phi_855_;
                let _e271 = phi_858_;
                let _e273 = phi_860_;
                local_1 = _e273;
                local_2 = _e273;
                local_3 = _e273;
                if (_e271 < _e78) {
                    if _e273.point.is_inside {
                        phi_1021_ = lt_math_LightPoint();
                        phi_1022_ = u32();
                        phi_1023_ = lt_math_LevelPoint();
                        phi_1024_ = false;
                    } else {
                        if (_e271 < _e66) {
                        } else {
                            return;
                        }
                        let _e284 = levels.member[(0u + _e271)].row_w;
                        let _e295 = ((((_e284.x * _e240.x) + (_e284.y * _e240.y)) + (_e284.z * _e240.z)) + (_e284.w * 1f));
                        let _e297 = levels.member[(0u + _e271)].row_x;
                        let _e309 = (((((_e297.x * _e240.x) + (_e297.y * _e240.y)) + (_e297.z * _e240.z)) + (_e297.w * 1f)) / _e295);
                        let _e311 = levels.member[(0u + _e271)].row_y;
                        let _e323 = (((((_e311.x * _e240.x) + (_e311.y * _e240.y)) + (_e311.z * _e240.z)) + (_e311.w * 1f)) / _e295);
                        let _e325 = levels.member[(0u + _e271)].row_z;
                        let _e336 = ((((_e325.x * _e240.x) + (_e325.y * _e240.y)) + (_e325.z * _e240.z)) + (_e325.w * 1f));
                        if (_e295 > 0f) {
                            if (_e309 >= 0f) {
                                phi_946_ = (_e309 <= 1f);
                            } else {
                                phi_946_ = false;
                            }
                            let _e341 = phi_946_;
                            if _e341 {
                                if (_e323 >= 0f) {
                                    phi_955_ = (_e323 <= 1f);
                                } else {
                                    phi_955_ = false;
                                }
                                let _e345 = phi_955_;
                                if _e345 {
                                    if (_e336 >= 0f) {
                                        phi_964_ = (_e336 <= 1f);
                                    } else {
                                        phi_964_ = false;
                                    }
                                    let _e349 = phi_964_;
                                    phi_965_ = _e349;
                                    phi_966_ = false;
                                } else {
                                    phi_965_ = bool();
                                    phi_966_ = true;
                                }
                                let _e351 = phi_965_;
                                let _e353 = phi_966_;
                                phi_967_ = _e351;
                                phi_968_ = _e353;
                            } else {
                                phi_967_ = bool();
                                phi_968_ = true;
                            }
                            let _e355 = phi_967_;
                            let _e357 = phi_968_;
                            phi_969_ = _e355;
                            phi_970_ = _e357;
                        } else {
                            phi_969_ = bool();
                            phi_970_ = true;
                        }
                        let _e359 = phi_969_;
                        let _e361 = phi_970_;
                        if _e361 {
                            phi_974_ = false;
                        } else {
                            phi_974_ = _e359;
                        }
                        let _e363 = phi_974_;
                        if _e363 {
                            if (_e309 >= _e244) {
                                if (_e309 <= (1f - _e244)) {
                                    if (_e323 >= _e244) {
                                        phi_1001_ = (_e323 <= (1f - _e244));
                                        phi_1002_ = false;
                                    } else {
                                        phi_1001_ = bool();
                                        phi_1002_ = true;
                                    }
                                    let _e371 = phi_1001_;
                                    let _e373 = phi_1002_;
                                    phi_1003_ = _e371;
                                    phi_1004_ = _e373;
                                } else {
                                    phi_1003_ = bool();
                                    phi_1004_ = true;
                                }
                                let _e375 = phi_1003_;
                                let _e377 = phi_1004_;
                                phi_1005_ = _e375;
                                phi_1006_ = _e377;
                            } else {
                                phi_1005_ = bool();
                                phi_1006_ = true;
                            }
                            let _e379 = phi_1005_;
                            let _e381 = phi_1006_;
                            phi_1007_ = _e379;
                            phi_1008_ = _e381;
                        } else {
                            phi_1007_ = bool();
                            phi_1008_ = true;
                        }
                        let _e383 = phi_1007_;
                        let _e385 = phi_1008_;
                        if _e385 {
                            phi_1012_ = false;
                        } else {
                            phi_1012_ = _e383;
                        }
                        let _e387 = phi_1012_;
                        let _e394 = lt_math_LightPoint(vec2<f32>(_e309, _e269.uv.y), _e269.depth, _e269.is_inside);
                        let _e401 = lt_math_LightPoint(vec2<f32>(_e394.uv.x, _e323), _e394.depth, _e394.is_inside);
                        let _e405 = lt_math_LightPoint(_e401.uv, _e336, _e401.is_inside);
                        let _e409 = lt_math_LightPoint(_e405.uv, _e405.depth, _e387);
                        phi_1021_ = _e409;
                        phi_1022_ = (_e271 + 1u);
                        phi_1023_ = lt_math_LevelPoint(_e271, _e409);
                        phi_1024_ = true;
                    }
                    let _e413 = phi_1021_;
                    let _e415 = phi_1022_;
                    let _e417 = phi_1023_;
                    let _e419 = phi_1024_;
                    phi_856_ = _e413;
                    phi_859_ = _e415;
                    phi_861_ = _e417;
                    phi_1025_ = _e419;
                } else {
                    phi_856_ = lt_math_LightPoint();
                    phi_859_ = u32();
                    phi_861_ = lt_math_LevelPoint();
                    phi_1025_ = false;
                }
                let _e421 = phi_856_;
                let _e423 = phi_859_;
                let _e425 = phi_861_;
                let _e427 = phi_1025_;
                continue;
                continuing {
                    phi_855_ = _e421;
                    phi_858_ = _e423;
                    phi_860_ = _e425;
                    break if !(_e427);
                }
            }
            let _e430 = local_1;
            if _e430.point.is_inside {
                if (0f > 0f) {
                    let _e436 = local_2;
                    if (_e436.level < _e66) {
                    } else {
                        return;
                    }
                    let _e441 = levels.member[(0u + _e436.level)];
                    let _e447 = global[0u];
                    if (_e441.row_w.x == _e447) {
                        let _e450 = global[1u];
                        if (_e441.row_w.y == _e450) {
                            let _e453 = global[2u];
                            phi_1065_ = (_e441.row_w.z == _e453);
                            phi_1066_ = false;
                        } else {
                            phi_1065_ = bool();
                            phi_1066_ = true;
                        }
                        let _e456 = phi_1065_;
                        let _e458 = phi_1066_;
                        phi_1067_ = _e456;
                        phi_1068_ = _e458;
                    } else {
                        phi_1067_ = bool();
                        phi_1068_ = true;
                    }
                    let _e460 = phi_1067_;
                    let _e462 = phi_1068_;
                    if _e462 {
                        phi_1072_ = false;
                    } else {
                        phi_1072_ = _e460;
                    }
                    let _e464 = phi_1072_;
                    if _e464 {
                        let _e466 = samples.member[(0u + _e72.shift)].normal;
                        let _e468 = p.member.map_size;
                        let _e538 = ((abs(((((_e441.row_x.x * _e466.x) + (_e441.row_x.y * _e466.y)) + (_e441.row_x.z * _e466.z)) / (((_e441.row_x.x * _e441.row_x.x) + (_e441.row_x.y * _e441.row_x.y)) + (_e441.row_x.z * _e441.row_x.z)))) + abs(((((_e441.row_y.x * _e466.x) + (_e441.row_y.y * _e466.y)) + (_e441.row_y.z * _e466.z)) / (((_e441.row_y.x * _e441.row_y.x) + (_e441.row_y.y * _e441.row_y.y)) + (_e441.row_y.z * _e441.row_y.z))))) / (abs(((((_e441.row_z.x * _e466.x) + (_e441.row_z.y * _e466.y)) + (_e441.row_z.z * _e466.z)) / (((_e441.row_z.x * _e441.row_z.x) + (_e441.row_z.y * _e441.row_z.y)) + (_e441.row_z.z * _e441.row_z.z)))) * f32(_e468)));
                        if (_e538 < 0.002f) {
                            phi_1154_ = _e538;
                        } else {
                            phi_1154_ = 0.002f;
                        }
                        let _e541 = phi_1154_;
                        phi_1273_ = _e541;
                    } else {
                        let _e543 = p.member.map_size;
                        let _e549 = samples.member[(0u + _e72.shift)].position;
                        let _e560 = ((((_e441.row_w.x * _e549.x) + (_e441.row_w.y * _e549.y)) + (_e441.row_w.z * _e549.z)) + _e441.row_w.w);
                        let _e573 = ((_e441.row_x.x - (_e441.row_w.x * _e430.point.uv.x)) / _e560);
                        let _e574 = ((_e441.row_x.y - (_e441.row_w.y * _e430.point.uv.x)) / _e560);
                        let _e575 = ((_e441.row_x.z - (_e441.row_w.z * _e430.point.uv.x)) / _e560);
                        let _e588 = ((_e441.row_y.x - (_e441.row_w.x * _e430.point.uv.y)) / _e560);
                        let _e589 = ((_e441.row_y.y - (_e441.row_w.y * _e430.point.uv.y)) / _e560);
                        let _e590 = ((_e441.row_y.z - (_e441.row_w.z * _e430.point.uv.y)) / _e560);
                        let _e596 = samples.member[(0u + _e72.shift)].normal;
                        let _e601 = ((_e589 * _e596.z) - (_e596.y * _e590));
                        let _e606 = ((_e590 * _e596.x) - (_e596.z * _e588));
                        let _e611 = ((_e588 * _e596.y) - (_e596.x * _e589));
                        let _e613 = samples.member[(0u + _e72.shift)].normal;
                        let _e618 = ((_e574 * _e613.z) - (_e613.y * _e575));
                        let _e623 = ((_e575 * _e613.x) - (_e613.z * _e573));
                        let _e628 = ((_e573 * _e613.y) - (_e613.x * _e574));
                        let _e655 = ((abs(((((_e441.row_z.x * _e601) + (_e441.row_z.y * _e606)) + (_e441.row_z.z * _e611)) / (((_e573 * _e601) + (_e574 * _e606)) + (_e575 * _e611)))) + abs(((((_e441.row_z.x * _e618) + (_e441.row_z.y * _e623)) + (_e441.row_z.z * _e628)) / (((_e588 * _e618) + (_e589 * _e623)) + (_e590 * _e628))))) / f32(_e543));
                        let _e657 = (16f / f32(_e543));
                        if (_e655 < _e657) {
                            phi_1272_ = _e655;
                        } else {
                            phi_1272_ = _e657;
                        }
                        let _e660 = phi_1272_;
                        phi_1273_ = _e660;
                    }
                    let _e662 = phi_1273_;
                    phi_1276_ = (_e430.point.depth - (0f * _e662));
                } else {
                    phi_1276_ = _e430.point.depth;
                }
                let _e666 = phi_1276_;
                let _e672 = p.member.map_size;
                let _e673 = f32(_e672);
                let _e676 = ((_e430.point.uv.x * _e673) - 0.5f);
                let _e677 = ((_e430.point.uv.y * _e673) - 0.5f);
                if (_e676 > -8388608f) {
                    let _e689 = f32(select(0i, select(select(i32(_e676), i32(-2147483648), (_e676 < bitcast<f32>(3472883712u))), 2147483647i, (_e676 > bitcast<f32>(1325400063u))), (_e676 == _e676)));
                    if (_e689 > _e676) {
                        phi_1305_ = 1f;
                    } else {
                        phi_1305_ = 0f;
                    }
                    let _e692 = phi_1305_;
                    if (_e676 < 8388608f) {
                        phi_1310_ = (_e689 - _e692);
                        phi_1311_ = false;
                    } else {
                        phi_1310_ = f32();
                        phi_1311_ = true;
                    }
                    let _e695 = phi_1310_;
                    let _e697 = phi_1311_;
                    phi_1312_ = _e695;
                    phi_1313_ = _e697;
                } else {
                    phi_1312_ = f32();
                    phi_1313_ = true;
                }
                let _e699 = phi_1312_;
                let _e701 = phi_1313_;
                if _e701 {
                    phi_1317_ = _e676;
                } else {
                    phi_1317_ = _e699;
                }
                let _e703 = phi_1317_;
                if (_e677 > -8388608f) {
                    let _e715 = f32(select(0i, select(select(i32(_e677), i32(-2147483648), (_e677 < bitcast<f32>(3472883712u))), 2147483647i, (_e677 > bitcast<f32>(1325400063u))), (_e677 == _e677)));
                    if (_e715 > _e677) {
                        phi_1337_ = 1f;
                    } else {
                        phi_1337_ = 0f;
                    }
                    let _e718 = phi_1337_;
                    if (_e677 < 8388608f) {
                        phi_1342_ = (_e715 - _e718);
                        phi_1343_ = false;
                    } else {
                        phi_1342_ = f32();
                        phi_1343_ = true;
                    }
                    let _e721 = phi_1342_;
                    let _e723 = phi_1343_;
                    phi_1344_ = _e721;
                    phi_1345_ = _e723;
                } else {
                    phi_1344_ = f32();
                    phi_1345_ = true;
                }
                let _e725 = phi_1344_;
                let _e727 = phi_1345_;
                if _e727 {
                    phi_1349_ = _e677;
                } else {
                    phi_1349_ = _e725;
                }
                let _e729 = phi_1349_;
                let _e730 = (_e676 - _e703);
                let _e731 = (_e677 - _e729);
                let _e740 = select(0i, select(select(i32(_e703), i32(-2147483648), (_e703 < bitcast<f32>(3472883712u))), 2147483647i, (_e703 > bitcast<f32>(1325400063u))), (_e703 == _e703));
                let _e749 = select(0i, select(select(i32(_e729), i32(-2147483648), (_e729 < bitcast<f32>(3472883712u))), 2147483647i, (_e729 > bitcast<f32>(1325400063u))), (_e729 == _e729));
                let _e760 = p.member.test;
                let _e761 = _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e760);
                let _e763 = p.member.map_size;
                let _e765 = local_3;
                local = _e761;
                let _e768 = ((_e765.level * _e763) * _e763);
                let _e770 = (bitcast<i32>(_e763) - 1i);
                if (_e740 > 0i) {
                    phi_1398_ = _e740;
                } else {
                    phi_1398_ = 0i;
                }
                let _e773 = phi_1398_;
                if (_e749 > 0i) {
                    phi_1403_ = _e749;
                } else {
                    phi_1403_ = 0i;
                }
                let _e776 = phi_1403_;
                if (_e773 < _e770) {
                    phi_1408_ = _e773;
                } else {
                    phi_1408_ = _e770;
                }
                let _e779 = phi_1408_;
                if (_e776 < _e770) {
                    phi_1413_ = _e776;
                } else {
                    phi_1413_ = _e770;
                }
                let _e782 = phi_1413_;
                let _e783 = bitcast<u32>(_e779);
                let _e785 = (_e740 + 1i);
                let _e786 = (_e749 + 1i);
                if (_e785 > 0i) {
                    phi_1422_ = _e785;
                } else {
                    phi_1422_ = 0i;
                }
                let _e789 = phi_1422_;
                if (_e786 > 0i) {
                    phi_1427_ = _e786;
                } else {
                    phi_1427_ = 0i;
                }
                let _e792 = phi_1427_;
                if (_e789 < _e770) {
                    phi_1432_ = _e789;
                } else {
                    phi_1432_ = _e770;
                }
                let _e795 = phi_1432_;
                if (_e792 < _e770) {
                    phi_1437_ = _e792;
                } else {
                    phi_1437_ = _e770;
                }
                let _e798 = phi_1437_;
                let _e799 = bitcast<u32>(_e795);
                let _e801 = (bitcast<u32>(_e782) * _e763);
                let _e802 = (bitcast<u32>(_e798) * _e763);
                let _e807 = ((_e801 + _e783) + _e768);
                let _e808 = ((_e801 + _e799) + _e768);
                let _e809 = ((_e802 + _e783) + _e768);
                let _e810 = ((_e802 + _e799) + _e768);
                if (_e807 < _e60) {
                } else {
                    return;
                }
                let _e814 = map.member[(0u + _e807)];
                if (_e808 < _e60) {
                } else {
                    return;
                }
                let _e818 = map.member[(0u + _e808)];
                if (_e809 < _e60) {
                } else {
                    return;
                }
                let _e822 = map.member[(0u + _e809)];
                if (_e810 < _e60) {
                } else {
                    return;
                }
                let _e826 = map.member[(0u + _e810)];
                let _e828 = _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e814, _e818, _e822, _e826), vec4<f32>(((1f - _e730) * (1f - _e731)), (_e730 * (1f - _e731)), ((1f - _e730) * _e731), (_e730 * _e731)), _e666);
                phi_1482_ = evaluate_Verdict(_e828, false);
                phi_1483_ = evaluate_Verdict();
                phi_1484_ = false;
            } else {
                phi_1482_ = evaluate_Verdict();
                phi_1483_ = evaluate_Verdict(1f, false);
                phi_1484_ = true;
            }
            let _e832 = phi_1482_;
            let _e834 = phi_1483_;
            let _e836 = phi_1484_;
            phi_1485_ = _e834;
            phi_1486_ = _e832;
            phi_1487_ = _e836;
        }
        let _e838 = phi_1485_;
        let _e840 = phi_1486_;
        let _e842 = phi_1487_;
        if _e842 {
            phi_1491_ = _e838;
        } else {
            phi_1491_ = _e840;
        }
        let _e844 = phi_1491_;
        if (_e72.shift < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e72.shift)] = _e844.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_esm_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
