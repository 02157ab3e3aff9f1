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
    var phi_158_: lt_mask_LightPlace;
    var phi_159_: bool;
    var phi_160_: lt_mask_LightPlace;
    var phi_161_: bool;
    var phi_166_: lt_mask_LightPlace;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_158_ = lt_mask_LightPlace(1u, ((param.y * param_1) + param.x));
            phi_159_ = false;
        } else {
            phi_158_ = lt_mask_LightPlace();
            phi_159_ = true;
        }
        let _e65 = phi_158_;
        let _e67 = phi_159_;
        phi_160_ = _e65;
        phi_161_ = _e67;
    } else {
        phi_160_ = lt_mask_LightPlace();
        phi_161_ = true;
    }
    let _e69 = phi_160_;
    let _e71 = phi_161_;
    if _e71 {
        phi_166_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_166_ = _e69;
    }
    let _e76 = phi_166_;
    return lt_mask_LightPlace(_e76.word, _e76.shift);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_esm_Esm_clamped_exponent(param_4: ptr<function, f32>) -> f32 {
    var phi_186_: bool;
    var phi_190_: f32;

    let _e53 = (*param_4);
    if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
        phi_186_ = true;
    } else {
        let _e57 = (84f < _e53);
        if _e57 {
        }
        phi_186_ = _e57;
    }
    let _e59 = phi_186_;
    if _e59 {
        phi_190_ = 84f;
    } else {
        phi_190_ = _e53;
    }
    let _e61 = phi_190_;
    return _e61;
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_5: ptr<function, f32>, param_6: vec4<f32>, param_7: vec4<f32>, param_8: f32) -> f32 {
    var phi_211_: f32;
    var phi_212_: f32;
    var phi_213_: f32;
    var phi_229_: f32;
    var phi_230_: f32;
    var phi_231_: f32;
    var phi_247_: f32;
    var phi_248_: f32;
    var phi_249_: f32;
    var phi_265_: f32;
    var phi_266_: f32;
    var phi_267_: f32;
    var phi_283_: f32;
    var phi_284_: f32;
    var phi_285_: f32;
    var phi_304_: f32;
    var phi_309_: f32;
    var phi_331_: f32;
    var phi_336_: f32;
    var phi_337_: bool;
    var phi_338_: f32;
    var phi_339_: bool;
    var phi_343_: f32;
    var phi_381_: f32;
    var phi_392_: f32;
    var phi_397_: f32;
    var phi_419_: f32;
    var phi_424_: f32;
    var phi_425_: bool;
    var phi_426_: f32;
    var phi_427_: bool;
    var phi_431_: f32;
    var phi_469_: f32;
    var phi_480_: f32;
    var phi_485_: f32;
    var phi_507_: f32;
    var phi_512_: f32;
    var phi_513_: bool;
    var phi_514_: f32;
    var phi_515_: bool;
    var phi_519_: f32;
    var phi_557_: f32;
    var phi_568_: f32;
    var phi_573_: f32;
    var phi_595_: f32;
    var phi_600_: f32;
    var phi_601_: bool;
    var phi_602_: f32;
    var phi_603_: bool;
    var phi_607_: f32;
    var phi_645_: f32;
    var phi_671_: f32;
    var phi_672_: f32;
    var phi_673_: f32;

    let _e56 = _lt_math_esm_Esm_clamped_exponent(param_5);
    if ((bitcast<u32>(param_8) & 2147483647u) > 2139095040u) {
        phi_213_ = param_8;
    } else {
        if (param_8 < 0f) {
            phi_212_ = 0f;
        } else {
            if (param_8 > 1f) {
                phi_211_ = 1f;
            } else {
                phi_211_ = param_8;
            }
            let _e63 = phi_211_;
            phi_212_ = _e63;
        }
        let _e65 = phi_212_;
        phi_213_ = _e65;
    }
    let _e67 = phi_213_;
    if ((bitcast<u32>(param_6.x) & 2147483647u) > 2139095040u) {
        phi_231_ = param_6.x;
    } else {
        if (param_6.x < 0f) {
            phi_230_ = 0f;
        } else {
            if (param_6.x > 1f) {
                phi_229_ = 1f;
            } else {
                phi_229_ = param_6.x;
            }
            let _e75 = phi_229_;
            phi_230_ = _e75;
        }
        let _e77 = phi_230_;
        phi_231_ = _e77;
    }
    let _e79 = phi_231_;
    if ((bitcast<u32>(param_6.y) & 2147483647u) > 2139095040u) {
        phi_249_ = param_6.y;
    } else {
        if (param_6.y < 0f) {
            phi_248_ = 0f;
        } else {
            if (param_6.y > 1f) {
                phi_247_ = 1f;
            } else {
                phi_247_ = param_6.y;
            }
            let _e87 = phi_247_;
            phi_248_ = _e87;
        }
        let _e89 = phi_248_;
        phi_249_ = _e89;
    }
    let _e91 = phi_249_;
    if ((bitcast<u32>(param_6.z) & 2147483647u) > 2139095040u) {
        phi_267_ = param_6.z;
    } else {
        if (param_6.z < 0f) {
            phi_266_ = 0f;
        } else {
            if (param_6.z > 1f) {
                phi_265_ = 1f;
            } else {
                phi_265_ = param_6.z;
            }
            let _e99 = phi_265_;
            phi_266_ = _e99;
        }
        let _e101 = phi_266_;
        phi_267_ = _e101;
    }
    let _e103 = phi_267_;
    if ((bitcast<u32>(param_6.w) & 2147483647u) > 2139095040u) {
        phi_285_ = param_6.w;
    } else {
        if (param_6.w < 0f) {
            phi_284_ = 0f;
        } else {
            if (param_6.w > 1f) {
                phi_283_ = 1f;
            } else {
                phi_283_ = param_6.w;
            }
            let _e111 = phi_283_;
            phi_284_ = _e111;
        }
        let _e113 = phi_284_;
        phi_285_ = _e113;
    }
    let _e115 = phi_285_;
    let _e120 = (_e56 * (_e79 - _e67));
    let _e121 = (_e56 * (_e91 - _e67));
    let _e122 = (_e56 * (_e103 - _e67));
    let _e123 = (_e56 * (_e115 - _e67));
    if ((bitcast<u32>(_e120) & 2147483647u) > 2139095040u) {
        phi_381_ = _e120;
    } else {
        if (_e120 < -87f) {
            phi_304_ = -87f;
        } else {
            phi_304_ = _e120;
        }
        let _e129 = phi_304_;
        if (_e129 > 88f) {
            phi_309_ = 88f;
        } else {
            phi_309_ = _e129;
        }
        let _e132 = phi_309_;
        let _e134 = ((_e132 * 1.442695f) + 0.5f);
        if (_e134 > -8388608f) {
            let _e146 = f32(select(0i, select(select(i32(_e134), i32(-2147483648), (_e134 < bitcast<f32>(3472883712u))), 2147483647i, (_e134 > bitcast<f32>(1325400063u))), (_e134 == _e134)));
            if (_e146 > _e134) {
                phi_331_ = 1f;
            } else {
                phi_331_ = 0f;
            }
            let _e149 = phi_331_;
            if (_e134 < 8388608f) {
                phi_336_ = (_e146 - _e149);
                phi_337_ = false;
            } else {
                phi_336_ = f32();
                phi_337_ = true;
            }
            let _e152 = phi_336_;
            let _e154 = phi_337_;
            phi_338_ = _e152;
            phi_339_ = _e154;
        } else {
            phi_338_ = f32();
            phi_339_ = true;
        }
        let _e156 = phi_338_;
        let _e158 = phi_339_;
        if _e158 {
            phi_343_ = _e134;
        } else {
            phi_343_ = _e156;
        }
        let _e160 = phi_343_;
        let _e164 = ((_e132 - (_e160 * 0.69314575f)) - (_e160 * 0.0000014286068f));
        phi_381_ = ((((((((((((((((1f / 5040f) * _e164) + (1f / 720f)) * _e164) + (1f / 120f)) * _e164) + (1f / 24f)) * _e164) + (1f / 6f)) * _e164) + 0.5f) * _e164) + 1f) * _e164) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e160), i32(-2147483648), (_e160 < bitcast<f32>(3472883712u))), 2147483647i, (_e160 > bitcast<f32>(1325400063u))), (_e160 == _e160)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e200 = phi_381_;
    if ((bitcast<u32>(_e121) & 2147483647u) > 2139095040u) {
        phi_469_ = _e121;
    } else {
        if (_e121 < -87f) {
            phi_392_ = -87f;
        } else {
            phi_392_ = _e121;
        }
        let _e206 = phi_392_;
        if (_e206 > 88f) {
            phi_397_ = 88f;
        } else {
            phi_397_ = _e206;
        }
        let _e209 = phi_397_;
        let _e211 = ((_e209 * 1.442695f) + 0.5f);
        if (_e211 > -8388608f) {
            let _e223 = f32(select(0i, select(select(i32(_e211), i32(-2147483648), (_e211 < bitcast<f32>(3472883712u))), 2147483647i, (_e211 > bitcast<f32>(1325400063u))), (_e211 == _e211)));
            if (_e223 > _e211) {
                phi_419_ = 1f;
            } else {
                phi_419_ = 0f;
            }
            let _e226 = phi_419_;
            if (_e211 < 8388608f) {
                phi_424_ = (_e223 - _e226);
                phi_425_ = false;
            } else {
                phi_424_ = f32();
                phi_425_ = true;
            }
            let _e229 = phi_424_;
            let _e231 = phi_425_;
            phi_426_ = _e229;
            phi_427_ = _e231;
        } else {
            phi_426_ = f32();
            phi_427_ = true;
        }
        let _e233 = phi_426_;
        let _e235 = phi_427_;
        if _e235 {
            phi_431_ = _e211;
        } else {
            phi_431_ = _e233;
        }
        let _e237 = phi_431_;
        let _e241 = ((_e209 - (_e237 * 0.69314575f)) - (_e237 * 0.0000014286068f));
        phi_469_ = ((((((((((((((((1f / 5040f) * _e241) + (1f / 720f)) * _e241) + (1f / 120f)) * _e241) + (1f / 24f)) * _e241) + (1f / 6f)) * _e241) + 0.5f) * _e241) + 1f) * _e241) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e237), i32(-2147483648), (_e237 < bitcast<f32>(3472883712u))), 2147483647i, (_e237 > bitcast<f32>(1325400063u))), (_e237 == _e237)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e277 = phi_469_;
    if ((bitcast<u32>(_e122) & 2147483647u) > 2139095040u) {
        phi_557_ = _e122;
    } else {
        if (_e122 < -87f) {
            phi_480_ = -87f;
        } else {
            phi_480_ = _e122;
        }
        let _e283 = phi_480_;
        if (_e283 > 88f) {
            phi_485_ = 88f;
        } else {
            phi_485_ = _e283;
        }
        let _e286 = phi_485_;
        let _e288 = ((_e286 * 1.442695f) + 0.5f);
        if (_e288 > -8388608f) {
            let _e300 = f32(select(0i, select(select(i32(_e288), i32(-2147483648), (_e288 < bitcast<f32>(3472883712u))), 2147483647i, (_e288 > bitcast<f32>(1325400063u))), (_e288 == _e288)));
            if (_e300 > _e288) {
                phi_507_ = 1f;
            } else {
                phi_507_ = 0f;
            }
            let _e303 = phi_507_;
            if (_e288 < 8388608f) {
                phi_512_ = (_e300 - _e303);
                phi_513_ = false;
            } else {
                phi_512_ = f32();
                phi_513_ = true;
            }
            let _e306 = phi_512_;
            let _e308 = phi_513_;
            phi_514_ = _e306;
            phi_515_ = _e308;
        } else {
            phi_514_ = f32();
            phi_515_ = true;
        }
        let _e310 = phi_514_;
        let _e312 = phi_515_;
        if _e312 {
            phi_519_ = _e288;
        } else {
            phi_519_ = _e310;
        }
        let _e314 = phi_519_;
        let _e318 = ((_e286 - (_e314 * 0.69314575f)) - (_e314 * 0.0000014286068f));
        phi_557_ = ((((((((((((((((1f / 5040f) * _e318) + (1f / 720f)) * _e318) + (1f / 120f)) * _e318) + (1f / 24f)) * _e318) + (1f / 6f)) * _e318) + 0.5f) * _e318) + 1f) * _e318) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e314), i32(-2147483648), (_e314 < bitcast<f32>(3472883712u))), 2147483647i, (_e314 > bitcast<f32>(1325400063u))), (_e314 == _e314)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e354 = phi_557_;
    if ((bitcast<u32>(_e123) & 2147483647u) > 2139095040u) {
        phi_645_ = _e123;
    } else {
        if (_e123 < -87f) {
            phi_568_ = -87f;
        } else {
            phi_568_ = _e123;
        }
        let _e360 = phi_568_;
        if (_e360 > 88f) {
            phi_573_ = 88f;
        } else {
            phi_573_ = _e360;
        }
        let _e363 = phi_573_;
        let _e365 = ((_e363 * 1.442695f) + 0.5f);
        if (_e365 > -8388608f) {
            let _e377 = f32(select(0i, select(select(i32(_e365), i32(-2147483648), (_e365 < bitcast<f32>(3472883712u))), 2147483647i, (_e365 > bitcast<f32>(1325400063u))), (_e365 == _e365)));
            if (_e377 > _e365) {
                phi_595_ = 1f;
            } else {
                phi_595_ = 0f;
            }
            let _e380 = phi_595_;
            if (_e365 < 8388608f) {
                phi_600_ = (_e377 - _e380);
                phi_601_ = false;
            } else {
                phi_600_ = f32();
                phi_601_ = true;
            }
            let _e383 = phi_600_;
            let _e385 = phi_601_;
            phi_602_ = _e383;
            phi_603_ = _e385;
        } else {
            phi_602_ = f32();
            phi_603_ = true;
        }
        let _e387 = phi_602_;
        let _e389 = phi_603_;
        if _e389 {
            phi_607_ = _e365;
        } else {
            phi_607_ = _e387;
        }
        let _e391 = phi_607_;
        let _e395 = ((_e363 - (_e391 * 0.69314575f)) - (_e391 * 0.0000014286068f));
        phi_645_ = ((((((((((((((((1f / 5040f) * _e395) + (1f / 720f)) * _e395) + (1f / 120f)) * _e395) + (1f / 24f)) * _e395) + (1f / 6f)) * _e395) + 0.5f) * _e395) + 1f) * _e395) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e391), i32(-2147483648), (_e391 < bitcast<f32>(3472883712u))), 2147483647i, (_e391 > bitcast<f32>(1325400063u))), (_e391 == _e391)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e431 = phi_645_;
    let _e442 = ((((_e200 * param_7.x) + (_e277 * param_7.y)) + (_e354 * param_7.z)) + (_e431 * param_7.w));
    if ((bitcast<u32>(_e442) & 2147483647u) > 2139095040u) {
        phi_673_ = _e442;
    } else {
        if (_e442 < 0f) {
            phi_672_ = 0f;
        } else {
            if (_e442 > 1f) {
                phi_671_ = 1f;
            } else {
                phi_671_ = _e442;
            }
            let _e449 = phi_671_;
            phi_672_ = _e449;
        }
        let _e451 = phi_672_;
        phi_673_ = _e451;
    }
    let _e453 = phi_673_;
    return _e453;
}

fn function_() {
    var local: f32;
    var phi_733_: bool;
    var phi_734_: bool;
    var phi_735_: bool;
    var phi_736_: bool;
    var phi_740_: bool;
    var phi_810_: bool;
    var phi_811_: bool;
    var phi_822_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_823_: bool;
    var phi_824_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_825_: bool;
    var phi_832_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_836_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_856_: lt_math_LightPoint;
    var phi_859_: u32;
    var phi_861_: lt_math_LevelPoint;
    var phi_947_: bool;
    var phi_956_: bool;
    var phi_965_: bool;
    var phi_966_: bool;
    var phi_967_: bool;
    var phi_968_: bool;
    var phi_969_: bool;
    var phi_970_: bool;
    var phi_971_: bool;
    var phi_975_: bool;
    var phi_1002_: bool;
    var phi_1003_: bool;
    var phi_1004_: bool;
    var phi_1005_: bool;
    var phi_1006_: bool;
    var phi_1007_: bool;
    var phi_1008_: bool;
    var phi_1009_: bool;
    var phi_1013_: bool;
    var phi_1022_: lt_math_LightPoint;
    var phi_1023_: u32;
    var phi_1024_: lt_math_LevelPoint;
    var phi_1025_: bool;
    var phi_857_: lt_math_LightPoint;
    var phi_860_: u32;
    var phi_862_: lt_math_LevelPoint;
    var phi_1026_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_1066_: bool;
    var phi_1067_: bool;
    var phi_1068_: bool;
    var phi_1069_: bool;
    var phi_1073_: bool;
    var phi_1155_: f32;
    var phi_1273_: f32;
    var phi_1274_: f32;
    var phi_1277_: f32;
    var phi_1306_: f32;
    var phi_1311_: f32;
    var phi_1312_: bool;
    var phi_1313_: f32;
    var phi_1314_: bool;
    var phi_1318_: f32;
    var phi_1338_: f32;
    var phi_1343_: f32;
    var phi_1344_: bool;
    var phi_1345_: f32;
    var phi_1346_: bool;
    var phi_1350_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_1399_: i32;
    var phi_1404_: i32;
    var phi_1409_: i32;
    var phi_1414_: i32;
    var phi_1423_: i32;
    var phi_1428_: i32;
    var phi_1433_: i32;
    var phi_1438_: i32;
    var phi_1489_: bool;
    var phi_1497_: bool;
    var phi_1509_: bool;
    var phi_1510_: bool;
    var phi_1514_: f32;
    var phi_1520_: f32;
    var phi_1522_: evaluate_Verdict;
    var phi_1527_: evaluate_Verdict;
    var phi_1528_: evaluate_Verdict;

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
                phi_733_ = (_e95 == _e97);
                phi_734_ = false;
            } else {
                phi_733_ = bool();
                phi_734_ = true;
            }
            let _e100 = phi_733_;
            let _e102 = phi_734_;
            phi_735_ = _e100;
            phi_736_ = _e102;
        } else {
            phi_735_ = bool();
            phi_736_ = true;
        }
        let _e104 = phi_735_;
        let _e106 = phi_736_;
        if _e106 {
            phi_740_ = false;
        } else {
            phi_740_ = _e104;
        }
        let _e108 = phi_740_;
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
                    phi_811_ = true;
                } else {
                    let _e161 = p.member.light.range_squared;
                    if (_e144 <= _e161) {
                        let _e164 = p.member.light.cos_outer;
                        phi_810_ = (-((((_e126 * _e146.x) + (_e127 * _e146.y)) + (_e128 * _e146.z))) >= (_e164 * sqrt(_e144)));
                    } else {
                        phi_810_ = false;
                    }
                    let _e169 = phi_810_;
                    phi_811_ = _e169;
                }
                let _e171 = phi_811_;
                if _e171 {
                    let _e173 = samples.member[(0u + _e72.shift)].flags;
                    let _e181 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e187 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e181.unnamed.visibility, false), _e181.unnamed_1);
                    phi_822_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e187.unnamed, ((_e173 & 1u) == 0u));
                    phi_823_ = false;
                } else {
                    phi_822_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_823_ = true;
                }
                let _e192 = phi_822_;
                let _e194 = phi_823_;
                phi_824_ = _e192;
                phi_825_ = _e194;
            } else {
                phi_824_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_825_ = true;
            }
            let _e196 = phi_824_;
            let _e198 = phi_825_;
            if _e198 {
                let _e204 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e210 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e204.unnamed.visibility, false), _e204.unnamed_1);
                phi_832_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e210.unnamed, true);
            } else {
                phi_832_ = _e196;
            }
            let _e215 = phi_832_;
            phi_836_ = _e215;
        } else {
            let _e221 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e227 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e221.unnamed.visibility, false), _e221.unnamed_1);
            phi_836_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e227.unnamed, true);
        }
        let _e232 = phi_836_;
        if _e232.unnamed_1 {
            phi_1528_ = evaluate_Verdict(_e232.unnamed.visibility, _e232.unnamed.is_doubted);
        } else {
            let _e240 = samples.member[(0u + _e72.shift)].position;
            let _e242 = p.member.map_size;
            let _e244 = (0.5f / f32(_e242));
            let _e251 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e258 = lt_math_LightPoint(vec2<f32>(_e251.uv.x, 0f), _e251.depth, _e251.is_inside);
            let _e262 = lt_math_LightPoint(_e258.uv, 0f, _e258.is_inside);
            phi_856_ = lt_math_LightPoint();
            phi_859_ = 0u;
            phi_861_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e262.uv, _e262.depth, false));
            loop {
                let _e269 = phi_856_;
                let _e271 = phi_859_;
                let _e273 = phi_861_;
                local_1 = _e273;
                local_2 = _e273;
                local_3 = _e273;
                if (_e271 < _e78) {
                    if _e273.point.is_inside {
                        phi_1022_ = lt_math_LightPoint();
                        phi_1023_ = u32();
                        phi_1024_ = lt_math_LevelPoint();
                        phi_1025_ = false;
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
                                phi_947_ = (_e309 <= 1f);
                            } else {
                                phi_947_ = false;
                            }
                            let _e341 = phi_947_;
                            if _e341 {
                                if (_e323 >= 0f) {
                                    phi_956_ = (_e323 <= 1f);
                                } else {
                                    phi_956_ = false;
                                }
                                let _e345 = phi_956_;
                                if _e345 {
                                    if (_e336 >= 0f) {
                                        phi_965_ = (_e336 <= 1f);
                                    } else {
                                        phi_965_ = false;
                                    }
                                    let _e349 = phi_965_;
                                    phi_966_ = _e349;
                                    phi_967_ = false;
                                } else {
                                    phi_966_ = bool();
                                    phi_967_ = true;
                                }
                                let _e351 = phi_966_;
                                let _e353 = phi_967_;
                                phi_968_ = _e351;
                                phi_969_ = _e353;
                            } else {
                                phi_968_ = bool();
                                phi_969_ = true;
                            }
                            let _e355 = phi_968_;
                            let _e357 = phi_969_;
                            phi_970_ = _e355;
                            phi_971_ = _e357;
                        } else {
                            phi_970_ = bool();
                            phi_971_ = true;
                        }
                        let _e359 = phi_970_;
                        let _e361 = phi_971_;
                        if _e361 {
                            phi_975_ = false;
                        } else {
                            phi_975_ = _e359;
                        }
                        let _e363 = phi_975_;
                        if _e363 {
                            if (_e309 >= _e244) {
                                if (_e309 <= (1f - _e244)) {
                                    if (_e323 >= _e244) {
                                        phi_1002_ = (_e323 <= (1f - _e244));
                                        phi_1003_ = false;
                                    } else {
                                        phi_1002_ = bool();
                                        phi_1003_ = true;
                                    }
                                    let _e371 = phi_1002_;
                                    let _e373 = phi_1003_;
                                    phi_1004_ = _e371;
                                    phi_1005_ = _e373;
                                } else {
                                    phi_1004_ = bool();
                                    phi_1005_ = true;
                                }
                                let _e375 = phi_1004_;
                                let _e377 = phi_1005_;
                                phi_1006_ = _e375;
                                phi_1007_ = _e377;
                            } else {
                                phi_1006_ = bool();
                                phi_1007_ = true;
                            }
                            let _e379 = phi_1006_;
                            let _e381 = phi_1007_;
                            phi_1008_ = _e379;
                            phi_1009_ = _e381;
                        } else {
                            phi_1008_ = bool();
                            phi_1009_ = true;
                        }
                        let _e383 = phi_1008_;
                        let _e385 = phi_1009_;
                        if _e385 {
                            phi_1013_ = false;
                        } else {
                            phi_1013_ = _e383;
                        }
                        let _e387 = phi_1013_;
                        let _e394 = lt_math_LightPoint(vec2<f32>(_e309, _e269.uv.y), _e269.depth, _e269.is_inside);
                        let _e401 = lt_math_LightPoint(vec2<f32>(_e394.uv.x, _e323), _e394.depth, _e394.is_inside);
                        let _e405 = lt_math_LightPoint(_e401.uv, _e336, _e401.is_inside);
                        let _e409 = lt_math_LightPoint(_e405.uv, _e405.depth, _e387);
                        phi_1022_ = _e409;
                        phi_1023_ = (_e271 + 1u);
                        phi_1024_ = lt_math_LevelPoint(_e271, _e409);
                        phi_1025_ = true;
                    }
                    let _e413 = phi_1022_;
                    let _e415 = phi_1023_;
                    let _e417 = phi_1024_;
                    let _e419 = phi_1025_;
                    phi_857_ = _e413;
                    phi_860_ = _e415;
                    phi_862_ = _e417;
                    phi_1026_ = _e419;
                } else {
                    phi_857_ = lt_math_LightPoint();
                    phi_860_ = u32();
                    phi_862_ = lt_math_LevelPoint();
                    phi_1026_ = false;
                }
                let _e421 = phi_857_;
                let _e423 = phi_860_;
                let _e425 = phi_862_;
                let _e427 = phi_1026_;
                continue;
                continuing {
                    phi_856_ = _e421;
                    phi_859_ = _e423;
                    phi_861_ = _e425;
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
                            phi_1066_ = (_e441.row_w.z == _e453);
                            phi_1067_ = false;
                        } else {
                            phi_1066_ = bool();
                            phi_1067_ = true;
                        }
                        let _e456 = phi_1066_;
                        let _e458 = phi_1067_;
                        phi_1068_ = _e456;
                        phi_1069_ = _e458;
                    } else {
                        phi_1068_ = bool();
                        phi_1069_ = true;
                    }
                    let _e460 = phi_1068_;
                    let _e462 = phi_1069_;
                    if _e462 {
                        phi_1073_ = false;
                    } else {
                        phi_1073_ = _e460;
                    }
                    let _e464 = phi_1073_;
                    if _e464 {
                        let _e466 = samples.member[(0u + _e72.shift)].normal;
                        let _e468 = p.member.map_size;
                        let _e538 = ((abs(((((_e441.row_x.x * _e466.x) + (_e441.row_x.y * _e466.y)) + (_e441.row_x.z * _e466.z)) / (((_e441.row_x.x * _e441.row_x.x) + (_e441.row_x.y * _e441.row_x.y)) + (_e441.row_x.z * _e441.row_x.z)))) + abs(((((_e441.row_y.x * _e466.x) + (_e441.row_y.y * _e466.y)) + (_e441.row_y.z * _e466.z)) / (((_e441.row_y.x * _e441.row_y.x) + (_e441.row_y.y * _e441.row_y.y)) + (_e441.row_y.z * _e441.row_y.z))))) / (abs(((((_e441.row_z.x * _e466.x) + (_e441.row_z.y * _e466.y)) + (_e441.row_z.z * _e466.z)) / (((_e441.row_z.x * _e441.row_z.x) + (_e441.row_z.y * _e441.row_z.y)) + (_e441.row_z.z * _e441.row_z.z)))) * f32(_e468)));
                        if (_e538 < 0.002f) {
                            phi_1155_ = _e538;
                        } else {
                            phi_1155_ = 0.002f;
                        }
                        let _e541 = phi_1155_;
                        phi_1274_ = _e541;
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
                            phi_1273_ = _e655;
                        } else {
                            phi_1273_ = _e657;
                        }
                        let _e660 = phi_1273_;
                        phi_1274_ = _e660;
                    }
                    let _e662 = phi_1274_;
                    phi_1277_ = (_e430.point.depth - (0f * _e662));
                } else {
                    phi_1277_ = _e430.point.depth;
                }
                let _e666 = phi_1277_;
                let _e672 = p.member.map_size;
                let _e673 = f32(_e672);
                let _e676 = ((_e430.point.uv.x * _e673) - 0.5f);
                let _e677 = ((_e430.point.uv.y * _e673) - 0.5f);
                if (_e676 > -8388608f) {
                    let _e689 = f32(select(0i, select(select(i32(_e676), i32(-2147483648), (_e676 < bitcast<f32>(3472883712u))), 2147483647i, (_e676 > bitcast<f32>(1325400063u))), (_e676 == _e676)));
                    if (_e689 > _e676) {
                        phi_1306_ = 1f;
                    } else {
                        phi_1306_ = 0f;
                    }
                    let _e692 = phi_1306_;
                    if (_e676 < 8388608f) {
                        phi_1311_ = (_e689 - _e692);
                        phi_1312_ = false;
                    } else {
                        phi_1311_ = f32();
                        phi_1312_ = true;
                    }
                    let _e695 = phi_1311_;
                    let _e697 = phi_1312_;
                    phi_1313_ = _e695;
                    phi_1314_ = _e697;
                } else {
                    phi_1313_ = f32();
                    phi_1314_ = true;
                }
                let _e699 = phi_1313_;
                let _e701 = phi_1314_;
                if _e701 {
                    phi_1318_ = _e676;
                } else {
                    phi_1318_ = _e699;
                }
                let _e703 = phi_1318_;
                if (_e677 > -8388608f) {
                    let _e715 = f32(select(0i, select(select(i32(_e677), i32(-2147483648), (_e677 < bitcast<f32>(3472883712u))), 2147483647i, (_e677 > bitcast<f32>(1325400063u))), (_e677 == _e677)));
                    if (_e715 > _e677) {
                        phi_1338_ = 1f;
                    } else {
                        phi_1338_ = 0f;
                    }
                    let _e718 = phi_1338_;
                    if (_e677 < 8388608f) {
                        phi_1343_ = (_e715 - _e718);
                        phi_1344_ = false;
                    } else {
                        phi_1343_ = f32();
                        phi_1344_ = true;
                    }
                    let _e721 = phi_1343_;
                    let _e723 = phi_1344_;
                    phi_1345_ = _e721;
                    phi_1346_ = _e723;
                } else {
                    phi_1345_ = f32();
                    phi_1346_ = true;
                }
                let _e725 = phi_1345_;
                let _e727 = phi_1346_;
                if _e727 {
                    phi_1350_ = _e677;
                } else {
                    phi_1350_ = _e725;
                }
                let _e729 = phi_1350_;
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
                    phi_1399_ = _e740;
                } else {
                    phi_1399_ = 0i;
                }
                let _e773 = phi_1399_;
                if (_e749 > 0i) {
                    phi_1404_ = _e749;
                } else {
                    phi_1404_ = 0i;
                }
                let _e776 = phi_1404_;
                if (_e773 < _e770) {
                    phi_1409_ = _e773;
                } else {
                    phi_1409_ = _e770;
                }
                let _e779 = phi_1409_;
                if (_e776 < _e770) {
                    phi_1414_ = _e776;
                } else {
                    phi_1414_ = _e770;
                }
                let _e782 = phi_1414_;
                let _e783 = bitcast<u32>(_e779);
                let _e785 = (_e740 + 1i);
                let _e786 = (_e749 + 1i);
                if (_e785 > 0i) {
                    phi_1423_ = _e785;
                } else {
                    phi_1423_ = 0i;
                }
                let _e789 = phi_1423_;
                if (_e786 > 0i) {
                    phi_1428_ = _e786;
                } else {
                    phi_1428_ = 0i;
                }
                let _e792 = phi_1428_;
                if (_e789 < _e770) {
                    phi_1433_ = _e789;
                } else {
                    phi_1433_ = _e770;
                }
                let _e795 = phi_1433_;
                if (_e792 < _e770) {
                    phi_1438_ = _e792;
                } else {
                    phi_1438_ = _e770;
                }
                let _e798 = phi_1438_;
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
                let _e830 = p.member.epsilon;
                if (_e828 <= _e830) {
                    phi_1489_ = true;
                } else {
                    phi_1489_ = (_e828 >= (1f - _e830));
                }
                let _e835 = phi_1489_;
                if ((bitcast<u32>(_e828) & 2147483647u) > 2139095040u) {
                    phi_1497_ = true;
                } else {
                    phi_1497_ = !(_e835);
                }
                let _e841 = phi_1497_;
                if _e841 {
                    if (_e828 > 0f) {
                        if (_e828 < 1f) {
                            phi_1509_ = false;
                        } else {
                            phi_1509_ = true;
                        }
                        let _e845 = phi_1509_;
                        phi_1510_ = _e845;
                    } else {
                        phi_1510_ = true;
                    }
                    let _e847 = phi_1510_;
                    if _e847 {
                        phi_1514_ = 0.5f;
                    } else {
                        phi_1514_ = _e828;
                    }
                    let _e849 = phi_1514_;
                    phi_1522_ = evaluate_Verdict(_e849, true);
                } else {
                    if (_e828 > 0.5f) {
                        phi_1520_ = 1f;
                    } else {
                        phi_1520_ = 0f;
                    }
                    let _e853 = phi_1520_;
                    phi_1522_ = evaluate_Verdict(_e853, false);
                }
                let _e856 = phi_1522_;
                phi_1527_ = evaluate_Verdict(_e856.visibility, _e856.is_doubted);
            } else {
                phi_1527_ = evaluate_Verdict(0.5f, true);
            }
            let _e862 = phi_1527_;
            phi_1528_ = _e862;
        }
        let _e864 = phi_1528_;
        if (_e72.shift < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e72.shift)] = _e864.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_esm_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
