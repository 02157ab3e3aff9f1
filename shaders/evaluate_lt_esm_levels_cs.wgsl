struct abi_LightParams {
    place: vec4<f32>,
    axis: vec3<f32>,
    cos_outer: f32,
    range_squared: f32,
    cos_inner: f32,
    number: u32,
    mask_words: u32,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
}

struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_15 {
    member: array<abi_Sample>,
}

struct type_19 {
    member: array<f32>,
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

struct type_35 {
    member: array<lt_math_LightProjection>,
}

struct lt_math_LightPoint {
    uv: vec2<f32>,
    depth: f32,
    is_inside: bool,
}

struct lt_math_LevelPoint {
    level: u32,
    point: lt_math_LightPoint,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_15;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_31;
@group(0) @binding(2) 
var<storage> map: type_19;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_19;
@group(0) @binding(4) 
var<storage> levels: type_35;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_160_: lt_bvh_traverse_Tree;
    var phi_161_: bool;
    var phi_162_: lt_bvh_traverse_Tree;
    var phi_163_: bool;
    var phi_168_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_160_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_161_ = false;
        } else {
            phi_160_ = lt_bvh_traverse_Tree();
            phi_161_ = true;
        }
        let _e68 = phi_160_;
        let _e70 = phi_161_;
        phi_162_ = _e68;
        phi_163_ = _e70;
    } else {
        phi_162_ = lt_bvh_traverse_Tree();
        phi_163_ = true;
    }
    let _e72 = phi_162_;
    let _e74 = phi_163_;
    if _e74 {
        phi_168_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_168_ = _e72;
    }
    let _e79 = phi_168_;
    return lt_bvh_traverse_Tree(_e79.root, _e79.first_primitive);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_191_: bool;
    var phi_195_: f32;
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

    let _e59 = (*param_4);
    if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
        phi_191_ = true;
    } else {
        let _e63 = (84f < _e59);
        if _e63 {
        }
        phi_191_ = _e63;
    }
    let _e65 = phi_191_;
    if _e65 {
        phi_195_ = 84f;
    } else {
        phi_195_ = _e59;
    }
    let _e67 = phi_195_;
    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_212_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_211_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_210_ = 1f;
            } else {
                phi_210_ = param_7;
            }
            let _e74 = phi_210_;
            phi_211_ = _e74;
        }
        let _e76 = phi_211_;
        phi_212_ = _e76;
    }
    let _e78 = phi_212_;
    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_230_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_229_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_228_ = 1f;
            } else {
                phi_228_ = param_5.x;
            }
            let _e86 = phi_228_;
            phi_229_ = _e86;
        }
        let _e88 = phi_229_;
        phi_230_ = _e88;
    }
    let _e90 = phi_230_;
    if ((bitcast<u32>(param_5.y) & 2147483647u) > 2139095040u) {
        phi_248_ = param_5.y;
    } else {
        if (param_5.y < 0f) {
            phi_247_ = 0f;
        } else {
            if (param_5.y > 1f) {
                phi_246_ = 1f;
            } else {
                phi_246_ = param_5.y;
            }
            let _e98 = phi_246_;
            phi_247_ = _e98;
        }
        let _e100 = phi_247_;
        phi_248_ = _e100;
    }
    let _e102 = phi_248_;
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_266_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_265_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_264_ = 1f;
            } else {
                phi_264_ = param_5.z;
            }
            let _e110 = phi_264_;
            phi_265_ = _e110;
        }
        let _e112 = phi_265_;
        phi_266_ = _e112;
    }
    let _e114 = phi_266_;
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_284_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_283_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_282_ = 1f;
            } else {
                phi_282_ = param_5.w;
            }
            let _e122 = phi_282_;
            phi_283_ = _e122;
        }
        let _e124 = phi_283_;
        phi_284_ = _e124;
    }
    let _e126 = phi_284_;
    let _e131 = (_e67 * (_e90 - _e78));
    let _e132 = (_e67 * (_e102 - _e78));
    let _e133 = (_e67 * (_e114 - _e78));
    let _e134 = (_e67 * (_e126 - _e78));
    if ((bitcast<u32>(_e131) & 2147483647u) > 2139095040u) {
        phi_380_ = _e131;
    } else {
        if (_e131 < -87f) {
            phi_303_ = -87f;
        } else {
            phi_303_ = _e131;
        }
        let _e140 = phi_303_;
        if (_e140 > 88f) {
            phi_308_ = 88f;
        } else {
            phi_308_ = _e140;
        }
        let _e143 = phi_308_;
        let _e145 = ((_e143 * 1.442695f) + 0.5f);
        if (_e145 > -8388608f) {
            let _e157 = f32(select(0i, select(select(i32(_e145), i32(-2147483648), (_e145 < bitcast<f32>(3472883712u))), 2147483647i, (_e145 > bitcast<f32>(1325400063u))), (_e145 == _e145)));
            if (_e157 > _e145) {
                phi_330_ = 1f;
            } else {
                phi_330_ = 0f;
            }
            let _e160 = phi_330_;
            if (_e145 < 8388608f) {
                phi_335_ = (_e157 - _e160);
                phi_336_ = false;
            } else {
                phi_335_ = f32();
                phi_336_ = true;
            }
            let _e163 = phi_335_;
            let _e165 = phi_336_;
            phi_337_ = _e163;
            phi_338_ = _e165;
        } else {
            phi_337_ = f32();
            phi_338_ = true;
        }
        let _e167 = phi_337_;
        let _e169 = phi_338_;
        if _e169 {
            phi_342_ = _e145;
        } else {
            phi_342_ = _e167;
        }
        let _e171 = phi_342_;
        let _e175 = ((_e143 - (_e171 * 0.69314575f)) - (_e171 * 0.0000014286068f));
        phi_380_ = ((((((((((((((((1f / 5040f) * _e175) + (1f / 720f)) * _e175) + (1f / 120f)) * _e175) + (1f / 24f)) * _e175) + (1f / 6f)) * _e175) + 0.5f) * _e175) + 1f) * _e175) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e171), i32(-2147483648), (_e171 < bitcast<f32>(3472883712u))), 2147483647i, (_e171 > bitcast<f32>(1325400063u))), (_e171 == _e171)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e211 = phi_380_;
    if ((bitcast<u32>(_e132) & 2147483647u) > 2139095040u) {
        phi_468_ = _e132;
    } else {
        if (_e132 < -87f) {
            phi_391_ = -87f;
        } else {
            phi_391_ = _e132;
        }
        let _e217 = phi_391_;
        if (_e217 > 88f) {
            phi_396_ = 88f;
        } else {
            phi_396_ = _e217;
        }
        let _e220 = phi_396_;
        let _e222 = ((_e220 * 1.442695f) + 0.5f);
        if (_e222 > -8388608f) {
            let _e234 = f32(select(0i, select(select(i32(_e222), i32(-2147483648), (_e222 < bitcast<f32>(3472883712u))), 2147483647i, (_e222 > bitcast<f32>(1325400063u))), (_e222 == _e222)));
            if (_e234 > _e222) {
                phi_418_ = 1f;
            } else {
                phi_418_ = 0f;
            }
            let _e237 = phi_418_;
            if (_e222 < 8388608f) {
                phi_423_ = (_e234 - _e237);
                phi_424_ = false;
            } else {
                phi_423_ = f32();
                phi_424_ = true;
            }
            let _e240 = phi_423_;
            let _e242 = phi_424_;
            phi_425_ = _e240;
            phi_426_ = _e242;
        } else {
            phi_425_ = f32();
            phi_426_ = true;
        }
        let _e244 = phi_425_;
        let _e246 = phi_426_;
        if _e246 {
            phi_430_ = _e222;
        } else {
            phi_430_ = _e244;
        }
        let _e248 = phi_430_;
        let _e252 = ((_e220 - (_e248 * 0.69314575f)) - (_e248 * 0.0000014286068f));
        phi_468_ = ((((((((((((((((1f / 5040f) * _e252) + (1f / 720f)) * _e252) + (1f / 120f)) * _e252) + (1f / 24f)) * _e252) + (1f / 6f)) * _e252) + 0.5f) * _e252) + 1f) * _e252) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e248), i32(-2147483648), (_e248 < bitcast<f32>(3472883712u))), 2147483647i, (_e248 > bitcast<f32>(1325400063u))), (_e248 == _e248)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e288 = phi_468_;
    if ((bitcast<u32>(_e133) & 2147483647u) > 2139095040u) {
        phi_556_ = _e133;
    } else {
        if (_e133 < -87f) {
            phi_479_ = -87f;
        } else {
            phi_479_ = _e133;
        }
        let _e294 = phi_479_;
        if (_e294 > 88f) {
            phi_484_ = 88f;
        } else {
            phi_484_ = _e294;
        }
        let _e297 = phi_484_;
        let _e299 = ((_e297 * 1.442695f) + 0.5f);
        if (_e299 > -8388608f) {
            let _e311 = f32(select(0i, select(select(i32(_e299), i32(-2147483648), (_e299 < bitcast<f32>(3472883712u))), 2147483647i, (_e299 > bitcast<f32>(1325400063u))), (_e299 == _e299)));
            if (_e311 > _e299) {
                phi_506_ = 1f;
            } else {
                phi_506_ = 0f;
            }
            let _e314 = phi_506_;
            if (_e299 < 8388608f) {
                phi_511_ = (_e311 - _e314);
                phi_512_ = false;
            } else {
                phi_511_ = f32();
                phi_512_ = true;
            }
            let _e317 = phi_511_;
            let _e319 = phi_512_;
            phi_513_ = _e317;
            phi_514_ = _e319;
        } else {
            phi_513_ = f32();
            phi_514_ = true;
        }
        let _e321 = phi_513_;
        let _e323 = phi_514_;
        if _e323 {
            phi_518_ = _e299;
        } else {
            phi_518_ = _e321;
        }
        let _e325 = phi_518_;
        let _e329 = ((_e297 - (_e325 * 0.69314575f)) - (_e325 * 0.0000014286068f));
        phi_556_ = ((((((((((((((((1f / 5040f) * _e329) + (1f / 720f)) * _e329) + (1f / 120f)) * _e329) + (1f / 24f)) * _e329) + (1f / 6f)) * _e329) + 0.5f) * _e329) + 1f) * _e329) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e325), i32(-2147483648), (_e325 < bitcast<f32>(3472883712u))), 2147483647i, (_e325 > bitcast<f32>(1325400063u))), (_e325 == _e325)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e365 = phi_556_;
    if ((bitcast<u32>(_e134) & 2147483647u) > 2139095040u) {
        phi_644_ = _e134;
    } else {
        if (_e134 < -87f) {
            phi_567_ = -87f;
        } else {
            phi_567_ = _e134;
        }
        let _e371 = phi_567_;
        if (_e371 > 88f) {
            phi_572_ = 88f;
        } else {
            phi_572_ = _e371;
        }
        let _e374 = phi_572_;
        let _e376 = ((_e374 * 1.442695f) + 0.5f);
        if (_e376 > -8388608f) {
            let _e388 = f32(select(0i, select(select(i32(_e376), i32(-2147483648), (_e376 < bitcast<f32>(3472883712u))), 2147483647i, (_e376 > bitcast<f32>(1325400063u))), (_e376 == _e376)));
            if (_e388 > _e376) {
                phi_594_ = 1f;
            } else {
                phi_594_ = 0f;
            }
            let _e391 = phi_594_;
            if (_e376 < 8388608f) {
                phi_599_ = (_e388 - _e391);
                phi_600_ = false;
            } else {
                phi_599_ = f32();
                phi_600_ = true;
            }
            let _e394 = phi_599_;
            let _e396 = phi_600_;
            phi_601_ = _e394;
            phi_602_ = _e396;
        } else {
            phi_601_ = f32();
            phi_602_ = true;
        }
        let _e398 = phi_601_;
        let _e400 = phi_602_;
        if _e400 {
            phi_606_ = _e376;
        } else {
            phi_606_ = _e398;
        }
        let _e402 = phi_606_;
        let _e406 = ((_e374 - (_e402 * 0.69314575f)) - (_e402 * 0.0000014286068f));
        phi_644_ = ((((((((((((((((1f / 5040f) * _e406) + (1f / 720f)) * _e406) + (1f / 120f)) * _e406) + (1f / 24f)) * _e406) + (1f / 6f)) * _e406) + 0.5f) * _e406) + 1f) * _e406) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e402), i32(-2147483648), (_e402 < bitcast<f32>(3472883712u))), 2147483647i, (_e402 > bitcast<f32>(1325400063u))), (_e402 == _e402)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e442 = phi_644_;
    let _e453 = ((((_e211 * param_6.x) + (_e288 * param_6.y)) + (_e365 * param_6.z)) + (_e442 * param_6.w));
    if ((bitcast<u32>(_e453) & 2147483647u) > 2139095040u) {
        phi_672_ = _e453;
    } else {
        if (_e453 < 0f) {
            phi_671_ = 0f;
        } else {
            if (_e453 > 1f) {
                phi_670_ = 1f;
            } else {
                phi_670_ = _e453;
            }
            let _e460 = phi_670_;
            phi_671_ = _e460;
        }
        let _e462 = phi_671_;
        phi_672_ = _e462;
    }
    let _e464 = phi_672_;
    return _e464;
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
    var phi_1490_: bool;
    var phi_1498_: bool;
    var phi_1510_: bool;
    var phi_1511_: bool;
    var phi_1515_: f32;
    var phi_1521_: f32;
    var phi_1523_: evaluate_Verdict;
    var phi_1533_: u32;
    var phi_1542_: f32;
    var phi_1544_: evaluate_Verdict;
    var phi_1545_: bool;
    var phi_1546_: evaluate_Verdict;
    var phi_1547_: bool;
    var phi_1552_: evaluate_Verdict;
    var phi_1557_: evaluate_Verdict;
    var phi_1558_: evaluate_Verdict;

    let _e56 = id_1;
    let _e63 = arrayLength((&map.member));
    let _e69 = arrayLength((&levels.member));
    let _e72 = p.member.size[0u];
    let _e74 = p.member.size[1u];
    let _e75 = lt_shaders_entry_pixel_index(_e56, _e72, _e74);
    if (bitcast<i32>(_e75.root) != 0i) {
        let _e81 = p.member.level_count;
        if (_e75.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e88 = samples.member[(0u + _e75.first_primitive)].normal[0u];
        let _e90 = global[0u];
        if (_e88 == _e90) {
            let _e93 = samples.member[(0u + _e75.first_primitive)].normal[1u];
            let _e95 = global[1u];
            if (_e93 == _e95) {
                let _e98 = samples.member[(0u + _e75.first_primitive)].normal[2u];
                let _e100 = global[2u];
                phi_732_ = (_e98 == _e100);
                phi_733_ = false;
            } else {
                phi_732_ = bool();
                phi_733_ = true;
            }
            let _e103 = phi_732_;
            let _e105 = phi_733_;
            phi_734_ = _e103;
            phi_735_ = _e105;
        } else {
            phi_734_ = bool();
            phi_735_ = true;
        }
        let _e107 = phi_734_;
        let _e109 = phi_735_;
        if _e109 {
            phi_739_ = false;
        } else {
            phi_739_ = _e107;
        }
        let _e111 = phi_739_;
        if !(_e111) {
            let _e114 = samples.member[(0u + _e75.first_primitive)].position;
            let _e116 = p.member.light.place;
            let _e122 = p.member.light.place[3u];
            let _e129 = (_e116.x - (_e114.x * _e122));
            let _e130 = (_e116.y - (_e114.y * _e122));
            let _e131 = (_e116.z - (_e114.z * _e122));
            let _e133 = samples.member[(0u + _e75.first_primitive)].normal;
            if ((((_e133.x * _e129) + (_e133.y * _e130)) + (_e133.z * _e131)) > 0f) {
                let _e147 = (((_e129 * _e129) + (_e130 * _e130)) + (_e131 * _e131));
                let _e149 = p.member.light.axis;
                let _e161 = p.member.light.place[3u];
                if (_e161 == 0f) {
                    phi_810_ = true;
                } else {
                    let _e164 = p.member.light.range_squared;
                    if (_e147 <= _e164) {
                        let _e167 = p.member.light.cos_outer;
                        phi_809_ = (-((((_e129 * _e149.x) + (_e130 * _e149.y)) + (_e131 * _e149.z))) >= (_e167 * sqrt(_e147)));
                    } else {
                        phi_809_ = false;
                    }
                    let _e172 = phi_809_;
                    phi_810_ = _e172;
                }
                let _e174 = phi_810_;
                if _e174 {
                    let _e176 = samples.member[(0u + _e75.first_primitive)].flags;
                    let _e184 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e190 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e184.unnamed.visibility, false), _e184.unnamed_1);
                    phi_821_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e190.unnamed, ((_e176 & 1u) == 0u));
                    phi_822_ = false;
                } else {
                    phi_821_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_822_ = true;
                }
                let _e195 = phi_821_;
                let _e197 = phi_822_;
                phi_823_ = _e195;
                phi_824_ = _e197;
            } else {
                phi_823_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_824_ = true;
            }
            let _e199 = phi_823_;
            let _e201 = phi_824_;
            if _e201 {
                let _e207 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e213 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e207.unnamed.visibility, false), _e207.unnamed_1);
                phi_831_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e213.unnamed, true);
            } else {
                phi_831_ = _e199;
            }
            let _e218 = phi_831_;
            phi_835_ = _e218;
        } else {
            let _e224 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e230 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e224.unnamed.visibility, false), _e224.unnamed_1);
            phi_835_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e230.unnamed, true);
        }
        let _e235 = phi_835_;
        if _e235.unnamed_1 {
            phi_1558_ = evaluate_Verdict(_e235.unnamed.visibility, _e235.unnamed.is_doubted);
        } else {
            let _e243 = samples.member[(0u + _e75.first_primitive)].position;
            let _e245 = p.member.map_size;
            let _e247 = (0.5f / f32(_e245));
            let _e254 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e261 = lt_math_LightPoint(vec2<f32>(_e254.uv.x, 0f), _e254.depth, _e254.is_inside);
            let _e265 = lt_math_LightPoint(_e261.uv, 0f, _e261.is_inside);
            phi_855_ = lt_math_LightPoint();
            phi_858_ = 0u;
            phi_860_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e265.uv, _e265.depth, false));
            loop {
                let _e272 = phi_855_;
                let _e274 = phi_858_;
                let _e276 = phi_860_;
                local_1 = _e276;
                local_2 = _e276;
                local_3 = _e276;
                if (_e274 < _e81) {
                    if _e276.point.is_inside {
                        phi_1021_ = lt_math_LightPoint();
                        phi_1022_ = u32();
                        phi_1023_ = lt_math_LevelPoint();
                        phi_1024_ = false;
                    } else {
                        if (_e274 < _e69) {
                        } else {
                            return;
                        }
                        let _e287 = levels.member[(0u + _e274)].row_w;
                        let _e298 = ((((_e287.x * _e243.x) + (_e287.y * _e243.y)) + (_e287.z * _e243.z)) + (_e287.w * 1f));
                        let _e300 = levels.member[(0u + _e274)].row_x;
                        let _e312 = (((((_e300.x * _e243.x) + (_e300.y * _e243.y)) + (_e300.z * _e243.z)) + (_e300.w * 1f)) / _e298);
                        let _e314 = levels.member[(0u + _e274)].row_y;
                        let _e326 = (((((_e314.x * _e243.x) + (_e314.y * _e243.y)) + (_e314.z * _e243.z)) + (_e314.w * 1f)) / _e298);
                        let _e328 = levels.member[(0u + _e274)].row_z;
                        let _e339 = ((((_e328.x * _e243.x) + (_e328.y * _e243.y)) + (_e328.z * _e243.z)) + (_e328.w * 1f));
                        if (_e298 > 0f) {
                            if (_e312 >= 0f) {
                                phi_946_ = (_e312 <= 1f);
                            } else {
                                phi_946_ = false;
                            }
                            let _e344 = phi_946_;
                            if _e344 {
                                if (_e326 >= 0f) {
                                    phi_955_ = (_e326 <= 1f);
                                } else {
                                    phi_955_ = false;
                                }
                                let _e348 = phi_955_;
                                if _e348 {
                                    if (_e339 >= 0f) {
                                        phi_964_ = (_e339 <= 1f);
                                    } else {
                                        phi_964_ = false;
                                    }
                                    let _e352 = phi_964_;
                                    phi_965_ = _e352;
                                    phi_966_ = false;
                                } else {
                                    phi_965_ = bool();
                                    phi_966_ = true;
                                }
                                let _e354 = phi_965_;
                                let _e356 = phi_966_;
                                phi_967_ = _e354;
                                phi_968_ = _e356;
                            } else {
                                phi_967_ = bool();
                                phi_968_ = true;
                            }
                            let _e358 = phi_967_;
                            let _e360 = phi_968_;
                            phi_969_ = _e358;
                            phi_970_ = _e360;
                        } else {
                            phi_969_ = bool();
                            phi_970_ = true;
                        }
                        let _e362 = phi_969_;
                        let _e364 = phi_970_;
                        if _e364 {
                            phi_974_ = false;
                        } else {
                            phi_974_ = _e362;
                        }
                        let _e366 = phi_974_;
                        if _e366 {
                            if (_e312 >= _e247) {
                                if (_e312 <= (1f - _e247)) {
                                    if (_e326 >= _e247) {
                                        phi_1001_ = (_e326 <= (1f - _e247));
                                        phi_1002_ = false;
                                    } else {
                                        phi_1001_ = bool();
                                        phi_1002_ = true;
                                    }
                                    let _e374 = phi_1001_;
                                    let _e376 = phi_1002_;
                                    phi_1003_ = _e374;
                                    phi_1004_ = _e376;
                                } else {
                                    phi_1003_ = bool();
                                    phi_1004_ = true;
                                }
                                let _e378 = phi_1003_;
                                let _e380 = phi_1004_;
                                phi_1005_ = _e378;
                                phi_1006_ = _e380;
                            } else {
                                phi_1005_ = bool();
                                phi_1006_ = true;
                            }
                            let _e382 = phi_1005_;
                            let _e384 = phi_1006_;
                            phi_1007_ = _e382;
                            phi_1008_ = _e384;
                        } else {
                            phi_1007_ = bool();
                            phi_1008_ = true;
                        }
                        let _e386 = phi_1007_;
                        let _e388 = phi_1008_;
                        if _e388 {
                            phi_1012_ = false;
                        } else {
                            phi_1012_ = _e386;
                        }
                        let _e390 = phi_1012_;
                        let _e397 = lt_math_LightPoint(vec2<f32>(_e312, _e272.uv.y), _e272.depth, _e272.is_inside);
                        let _e404 = lt_math_LightPoint(vec2<f32>(_e397.uv.x, _e326), _e397.depth, _e397.is_inside);
                        let _e408 = lt_math_LightPoint(_e404.uv, _e339, _e404.is_inside);
                        let _e412 = lt_math_LightPoint(_e408.uv, _e408.depth, _e390);
                        phi_1021_ = _e412;
                        phi_1022_ = (_e274 + 1u);
                        phi_1023_ = lt_math_LevelPoint(_e274, _e412);
                        phi_1024_ = true;
                    }
                    let _e416 = phi_1021_;
                    let _e418 = phi_1022_;
                    let _e420 = phi_1023_;
                    let _e422 = phi_1024_;
                    phi_856_ = _e416;
                    phi_859_ = _e418;
                    phi_861_ = _e420;
                    phi_1025_ = _e422;
                } else {
                    phi_856_ = lt_math_LightPoint();
                    phi_859_ = u32();
                    phi_861_ = lt_math_LevelPoint();
                    phi_1025_ = false;
                }
                let _e424 = phi_856_;
                let _e426 = phi_859_;
                let _e428 = phi_861_;
                let _e430 = phi_1025_;
                continue;
                continuing {
                    phi_855_ = _e424;
                    phi_858_ = _e426;
                    phi_860_ = _e428;
                    break if !(_e430);
                }
            }
            let _e433 = local_1;
            if _e433.point.is_inside {
                if (0f > 0f) {
                    let _e439 = local_2;
                    if (_e439.level < _e69) {
                    } else {
                        return;
                    }
                    let _e444 = levels.member[(0u + _e439.level)];
                    let _e450 = global[0u];
                    if (_e444.row_w.x == _e450) {
                        let _e453 = global[1u];
                        if (_e444.row_w.y == _e453) {
                            let _e456 = global[2u];
                            phi_1065_ = (_e444.row_w.z == _e456);
                            phi_1066_ = false;
                        } else {
                            phi_1065_ = bool();
                            phi_1066_ = true;
                        }
                        let _e459 = phi_1065_;
                        let _e461 = phi_1066_;
                        phi_1067_ = _e459;
                        phi_1068_ = _e461;
                    } else {
                        phi_1067_ = bool();
                        phi_1068_ = true;
                    }
                    let _e463 = phi_1067_;
                    let _e465 = phi_1068_;
                    if _e465 {
                        phi_1072_ = false;
                    } else {
                        phi_1072_ = _e463;
                    }
                    let _e467 = phi_1072_;
                    if _e467 {
                        let _e469 = samples.member[(0u + _e75.first_primitive)].normal;
                        let _e471 = p.member.map_size;
                        let _e541 = ((abs(((((_e444.row_x.x * _e469.x) + (_e444.row_x.y * _e469.y)) + (_e444.row_x.z * _e469.z)) / (((_e444.row_x.x * _e444.row_x.x) + (_e444.row_x.y * _e444.row_x.y)) + (_e444.row_x.z * _e444.row_x.z)))) + abs(((((_e444.row_y.x * _e469.x) + (_e444.row_y.y * _e469.y)) + (_e444.row_y.z * _e469.z)) / (((_e444.row_y.x * _e444.row_y.x) + (_e444.row_y.y * _e444.row_y.y)) + (_e444.row_y.z * _e444.row_y.z))))) / (abs(((((_e444.row_z.x * _e469.x) + (_e444.row_z.y * _e469.y)) + (_e444.row_z.z * _e469.z)) / (((_e444.row_z.x * _e444.row_z.x) + (_e444.row_z.y * _e444.row_z.y)) + (_e444.row_z.z * _e444.row_z.z)))) * f32(_e471)));
                        if (_e541 < 0.002f) {
                            phi_1154_ = _e541;
                        } else {
                            phi_1154_ = 0.002f;
                        }
                        let _e544 = phi_1154_;
                        phi_1273_ = _e544;
                    } else {
                        let _e546 = p.member.map_size;
                        let _e552 = samples.member[(0u + _e75.first_primitive)].position;
                        let _e563 = ((((_e444.row_w.x * _e552.x) + (_e444.row_w.y * _e552.y)) + (_e444.row_w.z * _e552.z)) + _e444.row_w.w);
                        let _e576 = ((_e444.row_x.x - (_e444.row_w.x * _e433.point.uv.x)) / _e563);
                        let _e577 = ((_e444.row_x.y - (_e444.row_w.y * _e433.point.uv.x)) / _e563);
                        let _e578 = ((_e444.row_x.z - (_e444.row_w.z * _e433.point.uv.x)) / _e563);
                        let _e591 = ((_e444.row_y.x - (_e444.row_w.x * _e433.point.uv.y)) / _e563);
                        let _e592 = ((_e444.row_y.y - (_e444.row_w.y * _e433.point.uv.y)) / _e563);
                        let _e593 = ((_e444.row_y.z - (_e444.row_w.z * _e433.point.uv.y)) / _e563);
                        let _e599 = samples.member[(0u + _e75.first_primitive)].normal;
                        let _e604 = ((_e592 * _e599.z) - (_e599.y * _e593));
                        let _e609 = ((_e593 * _e599.x) - (_e599.z * _e591));
                        let _e614 = ((_e591 * _e599.y) - (_e599.x * _e592));
                        let _e616 = samples.member[(0u + _e75.first_primitive)].normal;
                        let _e621 = ((_e577 * _e616.z) - (_e616.y * _e578));
                        let _e626 = ((_e578 * _e616.x) - (_e616.z * _e576));
                        let _e631 = ((_e576 * _e616.y) - (_e616.x * _e577));
                        let _e658 = ((abs(((((_e444.row_z.x * _e604) + (_e444.row_z.y * _e609)) + (_e444.row_z.z * _e614)) / (((_e576 * _e604) + (_e577 * _e609)) + (_e578 * _e614)))) + abs(((((_e444.row_z.x * _e621) + (_e444.row_z.y * _e626)) + (_e444.row_z.z * _e631)) / (((_e591 * _e621) + (_e592 * _e626)) + (_e593 * _e631))))) / f32(_e546));
                        let _e660 = (16f / f32(_e546));
                        if (_e658 < _e660) {
                            phi_1272_ = _e658;
                        } else {
                            phi_1272_ = _e660;
                        }
                        let _e663 = phi_1272_;
                        phi_1273_ = _e663;
                    }
                    let _e665 = phi_1273_;
                    phi_1276_ = (_e433.point.depth - (0f * _e665));
                } else {
                    phi_1276_ = _e433.point.depth;
                }
                let _e669 = phi_1276_;
                let _e675 = p.member.map_size;
                let _e676 = f32(_e675);
                let _e679 = ((_e433.point.uv.x * _e676) - 0.5f);
                let _e680 = ((_e433.point.uv.y * _e676) - 0.5f);
                if (_e679 > -8388608f) {
                    let _e692 = f32(select(0i, select(select(i32(_e679), i32(-2147483648), (_e679 < bitcast<f32>(3472883712u))), 2147483647i, (_e679 > bitcast<f32>(1325400063u))), (_e679 == _e679)));
                    if (_e692 > _e679) {
                        phi_1305_ = 1f;
                    } else {
                        phi_1305_ = 0f;
                    }
                    let _e695 = phi_1305_;
                    if (_e679 < 8388608f) {
                        phi_1310_ = (_e692 - _e695);
                        phi_1311_ = false;
                    } else {
                        phi_1310_ = f32();
                        phi_1311_ = true;
                    }
                    let _e698 = phi_1310_;
                    let _e700 = phi_1311_;
                    phi_1312_ = _e698;
                    phi_1313_ = _e700;
                } else {
                    phi_1312_ = f32();
                    phi_1313_ = true;
                }
                let _e702 = phi_1312_;
                let _e704 = phi_1313_;
                if _e704 {
                    phi_1317_ = _e679;
                } else {
                    phi_1317_ = _e702;
                }
                let _e706 = phi_1317_;
                if (_e680 > -8388608f) {
                    let _e718 = f32(select(0i, select(select(i32(_e680), i32(-2147483648), (_e680 < bitcast<f32>(3472883712u))), 2147483647i, (_e680 > bitcast<f32>(1325400063u))), (_e680 == _e680)));
                    if (_e718 > _e680) {
                        phi_1337_ = 1f;
                    } else {
                        phi_1337_ = 0f;
                    }
                    let _e721 = phi_1337_;
                    if (_e680 < 8388608f) {
                        phi_1342_ = (_e718 - _e721);
                        phi_1343_ = false;
                    } else {
                        phi_1342_ = f32();
                        phi_1343_ = true;
                    }
                    let _e724 = phi_1342_;
                    let _e726 = phi_1343_;
                    phi_1344_ = _e724;
                    phi_1345_ = _e726;
                } else {
                    phi_1344_ = f32();
                    phi_1345_ = true;
                }
                let _e728 = phi_1344_;
                let _e730 = phi_1345_;
                if _e730 {
                    phi_1349_ = _e680;
                } else {
                    phi_1349_ = _e728;
                }
                let _e732 = phi_1349_;
                let _e733 = (_e679 - _e706);
                let _e734 = (_e680 - _e732);
                let _e743 = select(0i, select(select(i32(_e706), i32(-2147483648), (_e706 < bitcast<f32>(3472883712u))), 2147483647i, (_e706 > bitcast<f32>(1325400063u))), (_e706 == _e706));
                let _e752 = select(0i, select(select(i32(_e732), i32(-2147483648), (_e732 < bitcast<f32>(3472883712u))), 2147483647i, (_e732 > bitcast<f32>(1325400063u))), (_e732 == _e732));
                let _e763 = p.member.test;
                let _e764 = _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e763);
                let _e766 = p.member.map_size;
                let _e768 = local_3;
                local = _e764;
                let _e771 = ((_e768.level * _e766) * _e766);
                let _e773 = (bitcast<i32>(_e766) - 1i);
                if (_e743 > 0i) {
                    phi_1398_ = _e743;
                } else {
                    phi_1398_ = 0i;
                }
                let _e776 = phi_1398_;
                if (_e752 > 0i) {
                    phi_1403_ = _e752;
                } else {
                    phi_1403_ = 0i;
                }
                let _e779 = phi_1403_;
                if (_e776 < _e773) {
                    phi_1408_ = _e776;
                } else {
                    phi_1408_ = _e773;
                }
                let _e782 = phi_1408_;
                if (_e779 < _e773) {
                    phi_1413_ = _e779;
                } else {
                    phi_1413_ = _e773;
                }
                let _e785 = phi_1413_;
                let _e786 = bitcast<u32>(_e782);
                let _e788 = (_e743 + 1i);
                let _e789 = (_e752 + 1i);
                if (_e788 > 0i) {
                    phi_1422_ = _e788;
                } else {
                    phi_1422_ = 0i;
                }
                let _e792 = phi_1422_;
                if (_e789 > 0i) {
                    phi_1427_ = _e789;
                } else {
                    phi_1427_ = 0i;
                }
                let _e795 = phi_1427_;
                if (_e792 < _e773) {
                    phi_1432_ = _e792;
                } else {
                    phi_1432_ = _e773;
                }
                let _e798 = phi_1432_;
                if (_e795 < _e773) {
                    phi_1437_ = _e795;
                } else {
                    phi_1437_ = _e773;
                }
                let _e801 = phi_1437_;
                let _e802 = bitcast<u32>(_e798);
                let _e804 = (bitcast<u32>(_e785) * _e766);
                let _e805 = (bitcast<u32>(_e801) * _e766);
                let _e810 = ((_e804 + _e786) + _e771);
                let _e811 = ((_e804 + _e802) + _e771);
                let _e812 = ((_e805 + _e786) + _e771);
                let _e813 = ((_e805 + _e802) + _e771);
                if (_e810 < _e63) {
                } else {
                    return;
                }
                let _e817 = map.member[(0u + _e810)];
                if (_e811 < _e63) {
                } else {
                    return;
                }
                let _e821 = map.member[(0u + _e811)];
                if (_e812 < _e63) {
                } else {
                    return;
                }
                let _e825 = map.member[(0u + _e812)];
                if (_e813 < _e63) {
                } else {
                    return;
                }
                let _e829 = map.member[(0u + _e813)];
                let _e831 = _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e817, _e821, _e825, _e829), vec4<f32>(((1f - _e733) * (1f - _e734)), (_e733 * (1f - _e734)), ((1f - _e733) * _e734), (_e733 * _e734)), _e669);
                let _e835 = p.member.epsilon;
                if (_e831 <= _e835) {
                    phi_1490_ = true;
                } else {
                    phi_1490_ = (_e831 >= (1f - _e835));
                }
                let _e840 = phi_1490_;
                if ((bitcast<u32>(_e831) & 2147483647u) > 2139095040u) {
                    phi_1498_ = true;
                } else {
                    phi_1498_ = !(_e840);
                }
                let _e846 = phi_1498_;
                if _e846 {
                    if (_e831 > 0f) {
                        if (_e831 < 1f) {
                            phi_1510_ = false;
                        } else {
                            phi_1510_ = true;
                        }
                        let _e850 = phi_1510_;
                        phi_1511_ = _e850;
                    } else {
                        phi_1511_ = true;
                    }
                    let _e852 = phi_1511_;
                    if _e852 {
                        phi_1515_ = 0.5f;
                    } else {
                        phi_1515_ = _e831;
                    }
                    let _e854 = phi_1515_;
                    phi_1523_ = evaluate_Verdict(_e854, true);
                } else {
                    if (_e831 > 0.5f) {
                        phi_1521_ = 1f;
                    } else {
                        phi_1521_ = 0f;
                    }
                    let _e858 = phi_1521_;
                    phi_1523_ = evaluate_Verdict(_e858, false);
                }
                let _e861 = phi_1523_;
                let _e864 = (_e861.visibility < 0.5f);
                if _e861.is_doubted {
                    phi_1546_ = evaluate_Verdict();
                    phi_1547_ = true;
                } else {
                    if _e864 {
                        phi_1533_ = 2u;
                    } else {
                        phi_1533_ = 1u;
                    }
                    let _e866 = phi_1533_;
                    if ((0u & _e866) != 0u) {
                        if _e864 {
                            phi_1542_ = 0.000000059604645f;
                        } else {
                            phi_1542_ = 0.99999994f;
                        }
                        let _e870 = phi_1542_;
                        phi_1544_ = evaluate_Verdict(_e870, true);
                        phi_1545_ = false;
                    } else {
                        phi_1544_ = evaluate_Verdict();
                        phi_1545_ = true;
                    }
                    let _e873 = phi_1544_;
                    let _e875 = phi_1545_;
                    phi_1546_ = _e873;
                    phi_1547_ = _e875;
                }
                let _e877 = phi_1546_;
                let _e879 = phi_1547_;
                if _e879 {
                    phi_1552_ = evaluate_Verdict(_e861.visibility, _e861.is_doubted);
                } else {
                    phi_1552_ = _e877;
                }
                let _e882 = phi_1552_;
                phi_1557_ = evaluate_Verdict(_e882.visibility, _e882.is_doubted);
            } else {
                phi_1557_ = evaluate_Verdict(0.5f, true);
            }
            let _e888 = phi_1557_;
            phi_1558_ = _e888;
        }
        let _e890 = phi_1558_;
        if (_e75.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e75.first_primitive)] = _e890.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_esm_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
