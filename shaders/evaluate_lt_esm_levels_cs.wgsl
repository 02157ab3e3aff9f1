struct abi_LightParams {
    place: vec4<f32>,
    axis: vec3<f32>,
    cos_outer: f32,
    range_squared: f32,
    cos_inner: f32,
    pad: vec2<u32>,
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

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
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

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_157_: lt_bvh_traverse_Tree;
    var phi_158_: bool;
    var phi_159_: lt_bvh_traverse_Tree;
    var phi_160_: bool;
    var phi_165_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_157_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_158_ = false;
        } else {
            phi_157_ = lt_bvh_traverse_Tree();
            phi_158_ = true;
        }
        let _e64 = phi_157_;
        let _e66 = phi_158_;
        phi_159_ = _e64;
        phi_160_ = _e66;
    } else {
        phi_159_ = lt_bvh_traverse_Tree();
        phi_160_ = true;
    }
    let _e68 = phi_159_;
    let _e70 = phi_160_;
    if _e70 {
        phi_165_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_165_ = _e68;
    }
    let _e75 = phi_165_;
    return lt_bvh_traverse_Tree(_e75.root, _e75.first_primitive);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_esm_Esm_clamped_exponent(param_4: ptr<function, f32>) -> f32 {
    var phi_185_: bool;
    var phi_189_: f32;

    let _e52 = (*param_4);
    if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
        phi_185_ = true;
    } else {
        let _e56 = (84f < _e52);
        if _e56 {
        }
        phi_185_ = _e56;
    }
    let _e58 = phi_185_;
    if _e58 {
        phi_189_ = 84f;
    } else {
        phi_189_ = _e52;
    }
    let _e60 = phi_189_;
    return _e60;
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

    let _e55 = _lt_math_esm_Esm_clamped_exponent(param_5);
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
            let _e62 = phi_210_;
            phi_211_ = _e62;
        }
        let _e64 = phi_211_;
        phi_212_ = _e64;
    }
    let _e66 = phi_212_;
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
            let _e74 = phi_228_;
            phi_229_ = _e74;
        }
        let _e76 = phi_229_;
        phi_230_ = _e76;
    }
    let _e78 = phi_230_;
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
            let _e86 = phi_246_;
            phi_247_ = _e86;
        }
        let _e88 = phi_247_;
        phi_248_ = _e88;
    }
    let _e90 = phi_248_;
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
            let _e98 = phi_264_;
            phi_265_ = _e98;
        }
        let _e100 = phi_265_;
        phi_266_ = _e100;
    }
    let _e102 = phi_266_;
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
            let _e110 = phi_282_;
            phi_283_ = _e110;
        }
        let _e112 = phi_283_;
        phi_284_ = _e112;
    }
    let _e114 = phi_284_;
    let _e119 = (_e55 * (_e78 - _e66));
    let _e120 = (_e55 * (_e90 - _e66));
    let _e121 = (_e55 * (_e102 - _e66));
    let _e122 = (_e55 * (_e114 - _e66));
    if ((bitcast<u32>(_e119) & 2147483647u) > 2139095040u) {
        phi_380_ = _e119;
    } else {
        if (_e119 < -87f) {
            phi_303_ = -87f;
        } else {
            phi_303_ = _e119;
        }
        let _e128 = phi_303_;
        if (_e128 > 88f) {
            phi_308_ = 88f;
        } else {
            phi_308_ = _e128;
        }
        let _e131 = phi_308_;
        let _e133 = ((_e131 * 1.442695f) + 0.5f);
        if (_e133 > -8388608f) {
            let _e145 = f32(select(0i, select(select(i32(_e133), i32(-2147483648), (_e133 < bitcast<f32>(3472883712u))), 2147483647i, (_e133 > bitcast<f32>(1325400063u))), (_e133 == _e133)));
            if (_e145 > _e133) {
                phi_330_ = 1f;
            } else {
                phi_330_ = 0f;
            }
            let _e148 = phi_330_;
            if (_e133 < 8388608f) {
                phi_335_ = (_e145 - _e148);
                phi_336_ = false;
            } else {
                phi_335_ = f32();
                phi_336_ = true;
            }
            let _e151 = phi_335_;
            let _e153 = phi_336_;
            phi_337_ = _e151;
            phi_338_ = _e153;
        } else {
            phi_337_ = f32();
            phi_338_ = true;
        }
        let _e155 = phi_337_;
        let _e157 = phi_338_;
        if _e157 {
            phi_342_ = _e133;
        } else {
            phi_342_ = _e155;
        }
        let _e159 = phi_342_;
        let _e163 = ((_e131 - (_e159 * 0.69314575f)) - (_e159 * 0.0000014286068f));
        phi_380_ = ((((((((((((((((1f / 5040f) * _e163) + (1f / 720f)) * _e163) + (1f / 120f)) * _e163) + (1f / 24f)) * _e163) + (1f / 6f)) * _e163) + 0.5f) * _e163) + 1f) * _e163) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e159), i32(-2147483648), (_e159 < bitcast<f32>(3472883712u))), 2147483647i, (_e159 > bitcast<f32>(1325400063u))), (_e159 == _e159)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e199 = phi_380_;
    if ((bitcast<u32>(_e120) & 2147483647u) > 2139095040u) {
        phi_468_ = _e120;
    } else {
        if (_e120 < -87f) {
            phi_391_ = -87f;
        } else {
            phi_391_ = _e120;
        }
        let _e205 = phi_391_;
        if (_e205 > 88f) {
            phi_396_ = 88f;
        } else {
            phi_396_ = _e205;
        }
        let _e208 = phi_396_;
        let _e210 = ((_e208 * 1.442695f) + 0.5f);
        if (_e210 > -8388608f) {
            let _e222 = f32(select(0i, select(select(i32(_e210), i32(-2147483648), (_e210 < bitcast<f32>(3472883712u))), 2147483647i, (_e210 > bitcast<f32>(1325400063u))), (_e210 == _e210)));
            if (_e222 > _e210) {
                phi_418_ = 1f;
            } else {
                phi_418_ = 0f;
            }
            let _e225 = phi_418_;
            if (_e210 < 8388608f) {
                phi_423_ = (_e222 - _e225);
                phi_424_ = false;
            } else {
                phi_423_ = f32();
                phi_424_ = true;
            }
            let _e228 = phi_423_;
            let _e230 = phi_424_;
            phi_425_ = _e228;
            phi_426_ = _e230;
        } else {
            phi_425_ = f32();
            phi_426_ = true;
        }
        let _e232 = phi_425_;
        let _e234 = phi_426_;
        if _e234 {
            phi_430_ = _e210;
        } else {
            phi_430_ = _e232;
        }
        let _e236 = phi_430_;
        let _e240 = ((_e208 - (_e236 * 0.69314575f)) - (_e236 * 0.0000014286068f));
        phi_468_ = ((((((((((((((((1f / 5040f) * _e240) + (1f / 720f)) * _e240) + (1f / 120f)) * _e240) + (1f / 24f)) * _e240) + (1f / 6f)) * _e240) + 0.5f) * _e240) + 1f) * _e240) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e236), i32(-2147483648), (_e236 < bitcast<f32>(3472883712u))), 2147483647i, (_e236 > bitcast<f32>(1325400063u))), (_e236 == _e236)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e276 = phi_468_;
    if ((bitcast<u32>(_e121) & 2147483647u) > 2139095040u) {
        phi_556_ = _e121;
    } else {
        if (_e121 < -87f) {
            phi_479_ = -87f;
        } else {
            phi_479_ = _e121;
        }
        let _e282 = phi_479_;
        if (_e282 > 88f) {
            phi_484_ = 88f;
        } else {
            phi_484_ = _e282;
        }
        let _e285 = phi_484_;
        let _e287 = ((_e285 * 1.442695f) + 0.5f);
        if (_e287 > -8388608f) {
            let _e299 = f32(select(0i, select(select(i32(_e287), i32(-2147483648), (_e287 < bitcast<f32>(3472883712u))), 2147483647i, (_e287 > bitcast<f32>(1325400063u))), (_e287 == _e287)));
            if (_e299 > _e287) {
                phi_506_ = 1f;
            } else {
                phi_506_ = 0f;
            }
            let _e302 = phi_506_;
            if (_e287 < 8388608f) {
                phi_511_ = (_e299 - _e302);
                phi_512_ = false;
            } else {
                phi_511_ = f32();
                phi_512_ = true;
            }
            let _e305 = phi_511_;
            let _e307 = phi_512_;
            phi_513_ = _e305;
            phi_514_ = _e307;
        } else {
            phi_513_ = f32();
            phi_514_ = true;
        }
        let _e309 = phi_513_;
        let _e311 = phi_514_;
        if _e311 {
            phi_518_ = _e287;
        } else {
            phi_518_ = _e309;
        }
        let _e313 = phi_518_;
        let _e317 = ((_e285 - (_e313 * 0.69314575f)) - (_e313 * 0.0000014286068f));
        phi_556_ = ((((((((((((((((1f / 5040f) * _e317) + (1f / 720f)) * _e317) + (1f / 120f)) * _e317) + (1f / 24f)) * _e317) + (1f / 6f)) * _e317) + 0.5f) * _e317) + 1f) * _e317) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e313), i32(-2147483648), (_e313 < bitcast<f32>(3472883712u))), 2147483647i, (_e313 > bitcast<f32>(1325400063u))), (_e313 == _e313)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e353 = phi_556_;
    if ((bitcast<u32>(_e122) & 2147483647u) > 2139095040u) {
        phi_644_ = _e122;
    } else {
        if (_e122 < -87f) {
            phi_567_ = -87f;
        } else {
            phi_567_ = _e122;
        }
        let _e359 = phi_567_;
        if (_e359 > 88f) {
            phi_572_ = 88f;
        } else {
            phi_572_ = _e359;
        }
        let _e362 = phi_572_;
        let _e364 = ((_e362 * 1.442695f) + 0.5f);
        if (_e364 > -8388608f) {
            let _e376 = f32(select(0i, select(select(i32(_e364), i32(-2147483648), (_e364 < bitcast<f32>(3472883712u))), 2147483647i, (_e364 > bitcast<f32>(1325400063u))), (_e364 == _e364)));
            if (_e376 > _e364) {
                phi_594_ = 1f;
            } else {
                phi_594_ = 0f;
            }
            let _e379 = phi_594_;
            if (_e364 < 8388608f) {
                phi_599_ = (_e376 - _e379);
                phi_600_ = false;
            } else {
                phi_599_ = f32();
                phi_600_ = true;
            }
            let _e382 = phi_599_;
            let _e384 = phi_600_;
            phi_601_ = _e382;
            phi_602_ = _e384;
        } else {
            phi_601_ = f32();
            phi_602_ = true;
        }
        let _e386 = phi_601_;
        let _e388 = phi_602_;
        if _e388 {
            phi_606_ = _e364;
        } else {
            phi_606_ = _e386;
        }
        let _e390 = phi_606_;
        let _e394 = ((_e362 - (_e390 * 0.69314575f)) - (_e390 * 0.0000014286068f));
        phi_644_ = ((((((((((((((((1f / 5040f) * _e394) + (1f / 720f)) * _e394) + (1f / 120f)) * _e394) + (1f / 24f)) * _e394) + (1f / 6f)) * _e394) + 0.5f) * _e394) + 1f) * _e394) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e390), i32(-2147483648), (_e390 < bitcast<f32>(3472883712u))), 2147483647i, (_e390 > bitcast<f32>(1325400063u))), (_e390 == _e390)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e430 = phi_644_;
    let _e441 = ((((_e199 * param_7.x) + (_e276 * param_7.y)) + (_e353 * param_7.z)) + (_e430 * param_7.w));
    if ((bitcast<u32>(_e441) & 2147483647u) > 2139095040u) {
        phi_672_ = _e441;
    } else {
        if (_e441 < 0f) {
            phi_671_ = 0f;
        } else {
            if (_e441 > 1f) {
                phi_670_ = 1f;
            } else {
                phi_670_ = _e441;
            }
            let _e448 = phi_670_;
            phi_671_ = _e448;
        }
        let _e450 = phi_671_;
        phi_672_ = _e450;
    }
    let _e452 = phi_672_;
    return _e452;
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
    var phi_1270_: f32;
    var phi_1271_: f32;
    var phi_1274_: f32;
    var phi_1303_: f32;
    var phi_1308_: f32;
    var phi_1309_: bool;
    var phi_1310_: f32;
    var phi_1311_: bool;
    var phi_1315_: f32;
    var phi_1335_: f32;
    var phi_1340_: f32;
    var phi_1341_: bool;
    var phi_1342_: f32;
    var phi_1343_: bool;
    var phi_1347_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_1396_: i32;
    var phi_1401_: i32;
    var phi_1406_: i32;
    var phi_1411_: i32;
    var phi_1420_: i32;
    var phi_1425_: i32;
    var phi_1430_: i32;
    var phi_1435_: i32;
    var phi_1486_: bool;
    var phi_1494_: bool;
    var phi_1506_: bool;
    var phi_1507_: bool;
    var phi_1511_: f32;
    var phi_1517_: f32;
    var phi_1519_: evaluate_Verdict;
    var phi_1524_: evaluate_Verdict;
    var phi_1525_: evaluate_Verdict;

    let _e52 = id_1;
    let _e59 = arrayLength((&map.member));
    let _e65 = arrayLength((&levels.member));
    let _e68 = p.member.size[0u];
    let _e70 = p.member.size[1u];
    let _e71 = lt_shaders_entry_pixel_index(_e52, _e68, _e70);
    if (bitcast<i32>(_e71.root) != 0i) {
        let _e77 = p.member.level_count;
        if (_e71.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e84 = samples.member[(0u + _e71.first_primitive)].normal[0u];
        let _e86 = global[0u];
        if (_e84 == _e86) {
            let _e89 = samples.member[(0u + _e71.first_primitive)].normal[1u];
            let _e91 = global[1u];
            if (_e89 == _e91) {
                let _e94 = samples.member[(0u + _e71.first_primitive)].normal[2u];
                let _e96 = global[2u];
                phi_732_ = (_e94 == _e96);
                phi_733_ = false;
            } else {
                phi_732_ = bool();
                phi_733_ = true;
            }
            let _e99 = phi_732_;
            let _e101 = phi_733_;
            phi_734_ = _e99;
            phi_735_ = _e101;
        } else {
            phi_734_ = bool();
            phi_735_ = true;
        }
        let _e103 = phi_734_;
        let _e105 = phi_735_;
        if _e105 {
            phi_739_ = false;
        } else {
            phi_739_ = _e103;
        }
        let _e107 = phi_739_;
        if !(_e107) {
            let _e110 = samples.member[(0u + _e71.first_primitive)].position;
            let _e112 = p.member.light.place;
            let _e118 = p.member.light.place[3u];
            let _e125 = (_e112.x - (_e110.x * _e118));
            let _e126 = (_e112.y - (_e110.y * _e118));
            let _e127 = (_e112.z - (_e110.z * _e118));
            let _e129 = samples.member[(0u + _e71.first_primitive)].normal;
            if ((((_e129.x * _e125) + (_e129.y * _e126)) + (_e129.z * _e127)) > 0f) {
                let _e143 = (((_e125 * _e125) + (_e126 * _e126)) + (_e127 * _e127));
                let _e145 = p.member.light.axis;
                let _e157 = p.member.light.place[3u];
                if (_e157 == 0f) {
                    phi_810_ = true;
                } else {
                    let _e160 = p.member.light.range_squared;
                    if (_e143 <= _e160) {
                        let _e163 = p.member.light.cos_outer;
                        phi_809_ = (-((((_e125 * _e145.x) + (_e126 * _e145.y)) + (_e127 * _e145.z))) >= (_e163 * sqrt(_e143)));
                    } else {
                        phi_809_ = false;
                    }
                    let _e168 = phi_809_;
                    phi_810_ = _e168;
                }
                let _e170 = phi_810_;
                if _e170 {
                    let _e172 = samples.member[(0u + _e71.first_primitive)].flags;
                    let _e180 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e186 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e180.unnamed.visibility, false), _e180.unnamed_1);
                    phi_821_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e186.unnamed, ((_e172 & 1u) == 0u));
                    phi_822_ = false;
                } else {
                    phi_821_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_822_ = true;
                }
                let _e191 = phi_821_;
                let _e193 = phi_822_;
                phi_823_ = _e191;
                phi_824_ = _e193;
            } else {
                phi_823_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_824_ = true;
            }
            let _e195 = phi_823_;
            let _e197 = phi_824_;
            if _e197 {
                let _e203 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e209 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e203.unnamed.visibility, false), _e203.unnamed_1);
                phi_831_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e209.unnamed, true);
            } else {
                phi_831_ = _e195;
            }
            let _e214 = phi_831_;
            phi_835_ = _e214;
        } else {
            let _e220 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e226 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e220.unnamed.visibility, false), _e220.unnamed_1);
            phi_835_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e226.unnamed, true);
        }
        let _e231 = phi_835_;
        if _e231.unnamed_1 {
            phi_1525_ = evaluate_Verdict(_e231.unnamed.visibility, _e231.unnamed.is_doubted);
        } else {
            let _e239 = samples.member[(0u + _e71.first_primitive)].position;
            let _e241 = p.member.map_size;
            let _e243 = (0.5f / f32(_e241));
            let _e250 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e257 = lt_math_LightPoint(vec2<f32>(_e250.uv.x, 0f), _e250.depth, _e250.is_inside);
            let _e261 = lt_math_LightPoint(_e257.uv, 0f, _e257.is_inside);
            phi_855_ = lt_math_LightPoint();
            phi_858_ = 0u;
            phi_860_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e261.uv, _e261.depth, false));
            loop {
                let _e268 = phi_855_;
                let _e270 = phi_858_;
                let _e272 = phi_860_;
                local_1 = _e272;
                local_2 = _e272;
                local_3 = _e272;
                if (_e270 < _e77) {
                    if _e272.point.is_inside {
                        phi_1021_ = lt_math_LightPoint();
                        phi_1022_ = u32();
                        phi_1023_ = lt_math_LevelPoint();
                        phi_1024_ = false;
                    } else {
                        if (_e270 < _e65) {
                        } else {
                            return;
                        }
                        let _e283 = levels.member[(0u + _e270)].row_w;
                        let _e294 = ((((_e283.x * _e239.x) + (_e283.y * _e239.y)) + (_e283.z * _e239.z)) + (_e283.w * 1f));
                        let _e296 = levels.member[(0u + _e270)].row_x;
                        let _e308 = (((((_e296.x * _e239.x) + (_e296.y * _e239.y)) + (_e296.z * _e239.z)) + (_e296.w * 1f)) / _e294);
                        let _e310 = levels.member[(0u + _e270)].row_y;
                        let _e322 = (((((_e310.x * _e239.x) + (_e310.y * _e239.y)) + (_e310.z * _e239.z)) + (_e310.w * 1f)) / _e294);
                        let _e324 = levels.member[(0u + _e270)].row_z;
                        let _e335 = ((((_e324.x * _e239.x) + (_e324.y * _e239.y)) + (_e324.z * _e239.z)) + (_e324.w * 1f));
                        if (_e294 > 0f) {
                            if (_e308 >= 0f) {
                                phi_946_ = (_e308 <= 1f);
                            } else {
                                phi_946_ = false;
                            }
                            let _e340 = phi_946_;
                            if _e340 {
                                if (_e322 >= 0f) {
                                    phi_955_ = (_e322 <= 1f);
                                } else {
                                    phi_955_ = false;
                                }
                                let _e344 = phi_955_;
                                if _e344 {
                                    if (_e335 >= 0f) {
                                        phi_964_ = (_e335 <= 1f);
                                    } else {
                                        phi_964_ = false;
                                    }
                                    let _e348 = phi_964_;
                                    phi_965_ = _e348;
                                    phi_966_ = false;
                                } else {
                                    phi_965_ = bool();
                                    phi_966_ = true;
                                }
                                let _e350 = phi_965_;
                                let _e352 = phi_966_;
                                phi_967_ = _e350;
                                phi_968_ = _e352;
                            } else {
                                phi_967_ = bool();
                                phi_968_ = true;
                            }
                            let _e354 = phi_967_;
                            let _e356 = phi_968_;
                            phi_969_ = _e354;
                            phi_970_ = _e356;
                        } else {
                            phi_969_ = bool();
                            phi_970_ = true;
                        }
                        let _e358 = phi_969_;
                        let _e360 = phi_970_;
                        if _e360 {
                            phi_974_ = false;
                        } else {
                            phi_974_ = _e358;
                        }
                        let _e362 = phi_974_;
                        if _e362 {
                            if (_e308 >= _e243) {
                                if (_e308 <= (1f - _e243)) {
                                    if (_e322 >= _e243) {
                                        phi_1001_ = (_e322 <= (1f - _e243));
                                        phi_1002_ = false;
                                    } else {
                                        phi_1001_ = bool();
                                        phi_1002_ = true;
                                    }
                                    let _e370 = phi_1001_;
                                    let _e372 = phi_1002_;
                                    phi_1003_ = _e370;
                                    phi_1004_ = _e372;
                                } else {
                                    phi_1003_ = bool();
                                    phi_1004_ = true;
                                }
                                let _e374 = phi_1003_;
                                let _e376 = phi_1004_;
                                phi_1005_ = _e374;
                                phi_1006_ = _e376;
                            } else {
                                phi_1005_ = bool();
                                phi_1006_ = true;
                            }
                            let _e378 = phi_1005_;
                            let _e380 = phi_1006_;
                            phi_1007_ = _e378;
                            phi_1008_ = _e380;
                        } else {
                            phi_1007_ = bool();
                            phi_1008_ = true;
                        }
                        let _e382 = phi_1007_;
                        let _e384 = phi_1008_;
                        if _e384 {
                            phi_1012_ = false;
                        } else {
                            phi_1012_ = _e382;
                        }
                        let _e386 = phi_1012_;
                        let _e393 = lt_math_LightPoint(vec2<f32>(_e308, _e268.uv.y), _e268.depth, _e268.is_inside);
                        let _e400 = lt_math_LightPoint(vec2<f32>(_e393.uv.x, _e322), _e393.depth, _e393.is_inside);
                        let _e404 = lt_math_LightPoint(_e400.uv, _e335, _e400.is_inside);
                        let _e408 = lt_math_LightPoint(_e404.uv, _e404.depth, _e386);
                        phi_1021_ = _e408;
                        phi_1022_ = (_e270 + 1u);
                        phi_1023_ = lt_math_LevelPoint(_e270, _e408);
                        phi_1024_ = true;
                    }
                    let _e412 = phi_1021_;
                    let _e414 = phi_1022_;
                    let _e416 = phi_1023_;
                    let _e418 = phi_1024_;
                    phi_856_ = _e412;
                    phi_859_ = _e414;
                    phi_861_ = _e416;
                    phi_1025_ = _e418;
                } else {
                    phi_856_ = lt_math_LightPoint();
                    phi_859_ = u32();
                    phi_861_ = lt_math_LevelPoint();
                    phi_1025_ = false;
                }
                let _e420 = phi_856_;
                let _e422 = phi_859_;
                let _e424 = phi_861_;
                let _e426 = phi_1025_;
                continue;
                continuing {
                    phi_855_ = _e420;
                    phi_858_ = _e422;
                    phi_860_ = _e424;
                    break if !(_e426);
                }
            }
            let _e429 = local_1;
            if _e429.point.is_inside {
                if (0f > 0f) {
                    let _e435 = local_2;
                    if (_e435.level < _e65) {
                    } else {
                        return;
                    }
                    let _e440 = levels.member[(0u + _e435.level)];
                    let _e446 = global[0u];
                    if (_e440.row_w.x == _e446) {
                        let _e449 = global[1u];
                        if (_e440.row_w.y == _e449) {
                            let _e452 = global[2u];
                            phi_1065_ = (_e440.row_w.z == _e452);
                            phi_1066_ = false;
                        } else {
                            phi_1065_ = bool();
                            phi_1066_ = true;
                        }
                        let _e455 = phi_1065_;
                        let _e457 = phi_1066_;
                        phi_1067_ = _e455;
                        phi_1068_ = _e457;
                    } else {
                        phi_1067_ = bool();
                        phi_1068_ = true;
                    }
                    let _e459 = phi_1067_;
                    let _e461 = phi_1068_;
                    if _e461 {
                        phi_1072_ = false;
                    } else {
                        phi_1072_ = _e459;
                    }
                    let _e463 = phi_1072_;
                    if _e463 {
                        let _e465 = samples.member[(0u + _e71.first_primitive)].normal;
                        let _e467 = p.member.map_size;
                        let _e537 = ((abs(((((_e440.row_x.x * _e465.x) + (_e440.row_x.y * _e465.y)) + (_e440.row_x.z * _e465.z)) / (((_e440.row_x.x * _e440.row_x.x) + (_e440.row_x.y * _e440.row_x.y)) + (_e440.row_x.z * _e440.row_x.z)))) + abs(((((_e440.row_y.x * _e465.x) + (_e440.row_y.y * _e465.y)) + (_e440.row_y.z * _e465.z)) / (((_e440.row_y.x * _e440.row_y.x) + (_e440.row_y.y * _e440.row_y.y)) + (_e440.row_y.z * _e440.row_y.z))))) / (abs(((((_e440.row_z.x * _e465.x) + (_e440.row_z.y * _e465.y)) + (_e440.row_z.z * _e465.z)) / (((_e440.row_z.x * _e440.row_z.x) + (_e440.row_z.y * _e440.row_z.y)) + (_e440.row_z.z * _e440.row_z.z)))) * f32(_e467)));
                        if (_e537 < 0.002f) {
                            phi_1154_ = _e537;
                        } else {
                            phi_1154_ = 0.002f;
                        }
                        let _e540 = phi_1154_;
                        phi_1271_ = _e540;
                    } else {
                        let _e542 = p.member.map_size;
                        let _e548 = samples.member[(0u + _e71.first_primitive)].position;
                        let _e559 = ((((_e440.row_w.x * _e548.x) + (_e440.row_w.y * _e548.y)) + (_e440.row_w.z * _e548.z)) + _e440.row_w.w);
                        let _e572 = ((_e440.row_x.x - (_e440.row_w.x * _e429.point.uv.x)) / _e559);
                        let _e573 = ((_e440.row_x.y - (_e440.row_w.y * _e429.point.uv.x)) / _e559);
                        let _e574 = ((_e440.row_x.z - (_e440.row_w.z * _e429.point.uv.x)) / _e559);
                        let _e587 = ((_e440.row_y.x - (_e440.row_w.x * _e429.point.uv.y)) / _e559);
                        let _e588 = ((_e440.row_y.y - (_e440.row_w.y * _e429.point.uv.y)) / _e559);
                        let _e589 = ((_e440.row_y.z - (_e440.row_w.z * _e429.point.uv.y)) / _e559);
                        let _e595 = samples.member[(0u + _e71.first_primitive)].normal;
                        let _e600 = ((_e588 * _e595.z) - (_e595.y * _e589));
                        let _e605 = ((_e589 * _e595.x) - (_e595.z * _e587));
                        let _e610 = ((_e587 * _e595.y) - (_e595.x * _e588));
                        let _e612 = samples.member[(0u + _e71.first_primitive)].normal;
                        let _e617 = ((_e573 * _e612.z) - (_e612.y * _e574));
                        let _e622 = ((_e574 * _e612.x) - (_e612.z * _e572));
                        let _e627 = ((_e572 * _e612.y) - (_e612.x * _e573));
                        let _e654 = ((abs(((((_e440.row_z.x * _e600) + (_e440.row_z.y * _e605)) + (_e440.row_z.z * _e610)) / (((_e572 * _e600) + (_e573 * _e605)) + (_e574 * _e610)))) + abs(((((_e440.row_z.x * _e617) + (_e440.row_z.y * _e622)) + (_e440.row_z.z * _e627)) / (((_e587 * _e617) + (_e588 * _e622)) + (_e589 * _e627))))) / f32(_e542));
                        if (_e654 < 0.002f) {
                            phi_1270_ = _e654;
                        } else {
                            phi_1270_ = 0.002f;
                        }
                        let _e657 = phi_1270_;
                        phi_1271_ = _e657;
                    }
                    let _e659 = phi_1271_;
                    phi_1274_ = (_e429.point.depth - (0f * _e659));
                } else {
                    phi_1274_ = _e429.point.depth;
                }
                let _e663 = phi_1274_;
                let _e669 = p.member.map_size;
                let _e670 = f32(_e669);
                let _e673 = ((_e429.point.uv.x * _e670) - 0.5f);
                let _e674 = ((_e429.point.uv.y * _e670) - 0.5f);
                if (_e673 > -8388608f) {
                    let _e686 = f32(select(0i, select(select(i32(_e673), i32(-2147483648), (_e673 < bitcast<f32>(3472883712u))), 2147483647i, (_e673 > bitcast<f32>(1325400063u))), (_e673 == _e673)));
                    if (_e686 > _e673) {
                        phi_1303_ = 1f;
                    } else {
                        phi_1303_ = 0f;
                    }
                    let _e689 = phi_1303_;
                    if (_e673 < 8388608f) {
                        phi_1308_ = (_e686 - _e689);
                        phi_1309_ = false;
                    } else {
                        phi_1308_ = f32();
                        phi_1309_ = true;
                    }
                    let _e692 = phi_1308_;
                    let _e694 = phi_1309_;
                    phi_1310_ = _e692;
                    phi_1311_ = _e694;
                } else {
                    phi_1310_ = f32();
                    phi_1311_ = true;
                }
                let _e696 = phi_1310_;
                let _e698 = phi_1311_;
                if _e698 {
                    phi_1315_ = _e673;
                } else {
                    phi_1315_ = _e696;
                }
                let _e700 = phi_1315_;
                if (_e674 > -8388608f) {
                    let _e712 = f32(select(0i, select(select(i32(_e674), i32(-2147483648), (_e674 < bitcast<f32>(3472883712u))), 2147483647i, (_e674 > bitcast<f32>(1325400063u))), (_e674 == _e674)));
                    if (_e712 > _e674) {
                        phi_1335_ = 1f;
                    } else {
                        phi_1335_ = 0f;
                    }
                    let _e715 = phi_1335_;
                    if (_e674 < 8388608f) {
                        phi_1340_ = (_e712 - _e715);
                        phi_1341_ = false;
                    } else {
                        phi_1340_ = f32();
                        phi_1341_ = true;
                    }
                    let _e718 = phi_1340_;
                    let _e720 = phi_1341_;
                    phi_1342_ = _e718;
                    phi_1343_ = _e720;
                } else {
                    phi_1342_ = f32();
                    phi_1343_ = true;
                }
                let _e722 = phi_1342_;
                let _e724 = phi_1343_;
                if _e724 {
                    phi_1347_ = _e674;
                } else {
                    phi_1347_ = _e722;
                }
                let _e726 = phi_1347_;
                let _e727 = (_e673 - _e700);
                let _e728 = (_e674 - _e726);
                let _e737 = select(0i, select(select(i32(_e700), i32(-2147483648), (_e700 < bitcast<f32>(3472883712u))), 2147483647i, (_e700 > bitcast<f32>(1325400063u))), (_e700 == _e700));
                let _e746 = select(0i, select(select(i32(_e726), i32(-2147483648), (_e726 < bitcast<f32>(3472883712u))), 2147483647i, (_e726 > bitcast<f32>(1325400063u))), (_e726 == _e726));
                let _e757 = p.member.test;
                let _e758 = _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e757);
                let _e760 = p.member.map_size;
                let _e762 = local_3;
                local = _e758;
                let _e765 = ((_e762.level * _e760) * _e760);
                let _e767 = (bitcast<i32>(_e760) - 1i);
                if (_e737 > 0i) {
                    phi_1396_ = _e737;
                } else {
                    phi_1396_ = 0i;
                }
                let _e770 = phi_1396_;
                if (_e746 > 0i) {
                    phi_1401_ = _e746;
                } else {
                    phi_1401_ = 0i;
                }
                let _e773 = phi_1401_;
                if (_e770 < _e767) {
                    phi_1406_ = _e770;
                } else {
                    phi_1406_ = _e767;
                }
                let _e776 = phi_1406_;
                if (_e773 < _e767) {
                    phi_1411_ = _e773;
                } else {
                    phi_1411_ = _e767;
                }
                let _e779 = phi_1411_;
                let _e780 = bitcast<u32>(_e776);
                let _e782 = (_e737 + 1i);
                let _e783 = (_e746 + 1i);
                if (_e782 > 0i) {
                    phi_1420_ = _e782;
                } else {
                    phi_1420_ = 0i;
                }
                let _e786 = phi_1420_;
                if (_e783 > 0i) {
                    phi_1425_ = _e783;
                } else {
                    phi_1425_ = 0i;
                }
                let _e789 = phi_1425_;
                if (_e786 < _e767) {
                    phi_1430_ = _e786;
                } else {
                    phi_1430_ = _e767;
                }
                let _e792 = phi_1430_;
                if (_e789 < _e767) {
                    phi_1435_ = _e789;
                } else {
                    phi_1435_ = _e767;
                }
                let _e795 = phi_1435_;
                let _e796 = bitcast<u32>(_e792);
                let _e798 = (bitcast<u32>(_e779) * _e760);
                let _e799 = (bitcast<u32>(_e795) * _e760);
                let _e804 = ((_e798 + _e780) + _e765);
                let _e805 = ((_e798 + _e796) + _e765);
                let _e806 = ((_e799 + _e780) + _e765);
                let _e807 = ((_e799 + _e796) + _e765);
                if (_e804 < _e59) {
                } else {
                    return;
                }
                let _e811 = map.member[(0u + _e804)];
                if (_e805 < _e59) {
                } else {
                    return;
                }
                let _e815 = map.member[(0u + _e805)];
                if (_e806 < _e59) {
                } else {
                    return;
                }
                let _e819 = map.member[(0u + _e806)];
                if (_e807 < _e59) {
                } else {
                    return;
                }
                let _e823 = map.member[(0u + _e807)];
                let _e825 = _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e811, _e815, _e819, _e823), vec4<f32>(((1f - _e727) * (1f - _e728)), (_e727 * (1f - _e728)), ((1f - _e727) * _e728), (_e727 * _e728)), _e663);
                let _e827 = p.member.epsilon;
                if (_e825 <= _e827) {
                    phi_1486_ = true;
                } else {
                    phi_1486_ = (_e825 >= (1f - _e827));
                }
                let _e832 = phi_1486_;
                if ((bitcast<u32>(_e825) & 2147483647u) > 2139095040u) {
                    phi_1494_ = true;
                } else {
                    phi_1494_ = !(_e832);
                }
                let _e838 = phi_1494_;
                if _e838 {
                    if (_e825 > 0f) {
                        if (_e825 < 1f) {
                            phi_1506_ = false;
                        } else {
                            phi_1506_ = true;
                        }
                        let _e842 = phi_1506_;
                        phi_1507_ = _e842;
                    } else {
                        phi_1507_ = true;
                    }
                    let _e844 = phi_1507_;
                    if _e844 {
                        phi_1511_ = 0.5f;
                    } else {
                        phi_1511_ = _e825;
                    }
                    let _e846 = phi_1511_;
                    phi_1519_ = evaluate_Verdict(_e846, true);
                } else {
                    if (_e825 > 0.5f) {
                        phi_1517_ = 1f;
                    } else {
                        phi_1517_ = 0f;
                    }
                    let _e850 = phi_1517_;
                    phi_1519_ = evaluate_Verdict(_e850, false);
                }
                let _e853 = phi_1519_;
                phi_1524_ = evaluate_Verdict(_e853.visibility, _e853.is_doubted);
            } else {
                phi_1524_ = evaluate_Verdict(0.5f, true);
            }
            let _e859 = phi_1524_;
            phi_1525_ = _e859;
        }
        let _e861 = phi_1525_;
        if (_e71.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e71.first_primitive)] = _e861.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_esm_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
