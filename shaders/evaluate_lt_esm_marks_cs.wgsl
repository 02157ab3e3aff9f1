struct abi_LightParams {
    place: vec4<f32>,
    axis: vec3<f32>,
    cos_outer: f32,
    range_squared: f32,
    cos_inner: f32,
    number: u32,
    mask_words: u32,
}

struct type_9 {
    member: array<u32>,
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

struct type_19 {
    member: array<abi_Sample>,
}

struct type_23 {
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

struct type_34 {
    member: abi_ShadowParams,
}

struct lt_math_OneLevel {
    projection: lt_math_LightProjection,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_19;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_34;
@group(0) @binding(2) 
var<storage> map: type_23;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_23;
@group(0) @binding(4) 
var<storage> marks: type_9;

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
        let _e65 = phi_160_;
        let _e67 = phi_161_;
        phi_162_ = _e65;
        phi_163_ = _e67;
    } else {
        phi_162_ = lt_bvh_traverse_Tree();
        phi_163_ = true;
    }
    let _e69 = phi_162_;
    let _e71 = phi_163_;
    if _e71 {
        phi_168_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_168_ = _e69;
    }
    let _e76 = phi_168_;
    return lt_bvh_traverse_Tree(_e76.root, _e76.first_primitive);
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

    let _e56 = (*param_4);
    if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
        phi_191_ = true;
    } else {
        let _e60 = (84f < _e56);
        if _e60 {
        }
        phi_191_ = _e60;
    }
    let _e62 = phi_191_;
    if _e62 {
        phi_195_ = 84f;
    } else {
        phi_195_ = _e56;
    }
    let _e64 = phi_195_;
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
            let _e71 = phi_210_;
            phi_211_ = _e71;
        }
        let _e73 = phi_211_;
        phi_212_ = _e73;
    }
    let _e75 = phi_212_;
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
            let _e83 = phi_228_;
            phi_229_ = _e83;
        }
        let _e85 = phi_229_;
        phi_230_ = _e85;
    }
    let _e87 = phi_230_;
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
            let _e95 = phi_246_;
            phi_247_ = _e95;
        }
        let _e97 = phi_247_;
        phi_248_ = _e97;
    }
    let _e99 = phi_248_;
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
            let _e107 = phi_264_;
            phi_265_ = _e107;
        }
        let _e109 = phi_265_;
        phi_266_ = _e109;
    }
    let _e111 = phi_266_;
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
            let _e119 = phi_282_;
            phi_283_ = _e119;
        }
        let _e121 = phi_283_;
        phi_284_ = _e121;
    }
    let _e123 = phi_284_;
    let _e128 = (_e64 * (_e87 - _e75));
    let _e129 = (_e64 * (_e99 - _e75));
    let _e130 = (_e64 * (_e111 - _e75));
    let _e131 = (_e64 * (_e123 - _e75));
    if ((bitcast<u32>(_e128) & 2147483647u) > 2139095040u) {
        phi_380_ = _e128;
    } else {
        if (_e128 < -87f) {
            phi_303_ = -87f;
        } else {
            phi_303_ = _e128;
        }
        let _e137 = phi_303_;
        if (_e137 > 88f) {
            phi_308_ = 88f;
        } else {
            phi_308_ = _e137;
        }
        let _e140 = phi_308_;
        let _e142 = ((_e140 * 1.442695f) + 0.5f);
        if (_e142 > -8388608f) {
            let _e154 = f32(select(0i, select(select(i32(_e142), i32(-2147483648), (_e142 < bitcast<f32>(3472883712u))), 2147483647i, (_e142 > bitcast<f32>(1325400063u))), (_e142 == _e142)));
            if (_e154 > _e142) {
                phi_330_ = 1f;
            } else {
                phi_330_ = 0f;
            }
            let _e157 = phi_330_;
            if (_e142 < 8388608f) {
                phi_335_ = (_e154 - _e157);
                phi_336_ = false;
            } else {
                phi_335_ = f32();
                phi_336_ = true;
            }
            let _e160 = phi_335_;
            let _e162 = phi_336_;
            phi_337_ = _e160;
            phi_338_ = _e162;
        } else {
            phi_337_ = f32();
            phi_338_ = true;
        }
        let _e164 = phi_337_;
        let _e166 = phi_338_;
        if _e166 {
            phi_342_ = _e142;
        } else {
            phi_342_ = _e164;
        }
        let _e168 = phi_342_;
        let _e172 = ((_e140 - (_e168 * 0.69314575f)) - (_e168 * 0.0000014286068f));
        phi_380_ = ((((((((((((((((1f / 5040f) * _e172) + (1f / 720f)) * _e172) + (1f / 120f)) * _e172) + (1f / 24f)) * _e172) + (1f / 6f)) * _e172) + 0.5f) * _e172) + 1f) * _e172) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e168), i32(-2147483648), (_e168 < bitcast<f32>(3472883712u))), 2147483647i, (_e168 > bitcast<f32>(1325400063u))), (_e168 == _e168)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e208 = phi_380_;
    if ((bitcast<u32>(_e129) & 2147483647u) > 2139095040u) {
        phi_468_ = _e129;
    } else {
        if (_e129 < -87f) {
            phi_391_ = -87f;
        } else {
            phi_391_ = _e129;
        }
        let _e214 = phi_391_;
        if (_e214 > 88f) {
            phi_396_ = 88f;
        } else {
            phi_396_ = _e214;
        }
        let _e217 = phi_396_;
        let _e219 = ((_e217 * 1.442695f) + 0.5f);
        if (_e219 > -8388608f) {
            let _e231 = f32(select(0i, select(select(i32(_e219), i32(-2147483648), (_e219 < bitcast<f32>(3472883712u))), 2147483647i, (_e219 > bitcast<f32>(1325400063u))), (_e219 == _e219)));
            if (_e231 > _e219) {
                phi_418_ = 1f;
            } else {
                phi_418_ = 0f;
            }
            let _e234 = phi_418_;
            if (_e219 < 8388608f) {
                phi_423_ = (_e231 - _e234);
                phi_424_ = false;
            } else {
                phi_423_ = f32();
                phi_424_ = true;
            }
            let _e237 = phi_423_;
            let _e239 = phi_424_;
            phi_425_ = _e237;
            phi_426_ = _e239;
        } else {
            phi_425_ = f32();
            phi_426_ = true;
        }
        let _e241 = phi_425_;
        let _e243 = phi_426_;
        if _e243 {
            phi_430_ = _e219;
        } else {
            phi_430_ = _e241;
        }
        let _e245 = phi_430_;
        let _e249 = ((_e217 - (_e245 * 0.69314575f)) - (_e245 * 0.0000014286068f));
        phi_468_ = ((((((((((((((((1f / 5040f) * _e249) + (1f / 720f)) * _e249) + (1f / 120f)) * _e249) + (1f / 24f)) * _e249) + (1f / 6f)) * _e249) + 0.5f) * _e249) + 1f) * _e249) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e245), i32(-2147483648), (_e245 < bitcast<f32>(3472883712u))), 2147483647i, (_e245 > bitcast<f32>(1325400063u))), (_e245 == _e245)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e285 = phi_468_;
    if ((bitcast<u32>(_e130) & 2147483647u) > 2139095040u) {
        phi_556_ = _e130;
    } else {
        if (_e130 < -87f) {
            phi_479_ = -87f;
        } else {
            phi_479_ = _e130;
        }
        let _e291 = phi_479_;
        if (_e291 > 88f) {
            phi_484_ = 88f;
        } else {
            phi_484_ = _e291;
        }
        let _e294 = phi_484_;
        let _e296 = ((_e294 * 1.442695f) + 0.5f);
        if (_e296 > -8388608f) {
            let _e308 = f32(select(0i, select(select(i32(_e296), i32(-2147483648), (_e296 < bitcast<f32>(3472883712u))), 2147483647i, (_e296 > bitcast<f32>(1325400063u))), (_e296 == _e296)));
            if (_e308 > _e296) {
                phi_506_ = 1f;
            } else {
                phi_506_ = 0f;
            }
            let _e311 = phi_506_;
            if (_e296 < 8388608f) {
                phi_511_ = (_e308 - _e311);
                phi_512_ = false;
            } else {
                phi_511_ = f32();
                phi_512_ = true;
            }
            let _e314 = phi_511_;
            let _e316 = phi_512_;
            phi_513_ = _e314;
            phi_514_ = _e316;
        } else {
            phi_513_ = f32();
            phi_514_ = true;
        }
        let _e318 = phi_513_;
        let _e320 = phi_514_;
        if _e320 {
            phi_518_ = _e296;
        } else {
            phi_518_ = _e318;
        }
        let _e322 = phi_518_;
        let _e326 = ((_e294 - (_e322 * 0.69314575f)) - (_e322 * 0.0000014286068f));
        phi_556_ = ((((((((((((((((1f / 5040f) * _e326) + (1f / 720f)) * _e326) + (1f / 120f)) * _e326) + (1f / 24f)) * _e326) + (1f / 6f)) * _e326) + 0.5f) * _e326) + 1f) * _e326) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e322), i32(-2147483648), (_e322 < bitcast<f32>(3472883712u))), 2147483647i, (_e322 > bitcast<f32>(1325400063u))), (_e322 == _e322)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e362 = phi_556_;
    if ((bitcast<u32>(_e131) & 2147483647u) > 2139095040u) {
        phi_644_ = _e131;
    } else {
        if (_e131 < -87f) {
            phi_567_ = -87f;
        } else {
            phi_567_ = _e131;
        }
        let _e368 = phi_567_;
        if (_e368 > 88f) {
            phi_572_ = 88f;
        } else {
            phi_572_ = _e368;
        }
        let _e371 = phi_572_;
        let _e373 = ((_e371 * 1.442695f) + 0.5f);
        if (_e373 > -8388608f) {
            let _e385 = f32(select(0i, select(select(i32(_e373), i32(-2147483648), (_e373 < bitcast<f32>(3472883712u))), 2147483647i, (_e373 > bitcast<f32>(1325400063u))), (_e373 == _e373)));
            if (_e385 > _e373) {
                phi_594_ = 1f;
            } else {
                phi_594_ = 0f;
            }
            let _e388 = phi_594_;
            if (_e373 < 8388608f) {
                phi_599_ = (_e385 - _e388);
                phi_600_ = false;
            } else {
                phi_599_ = f32();
                phi_600_ = true;
            }
            let _e391 = phi_599_;
            let _e393 = phi_600_;
            phi_601_ = _e391;
            phi_602_ = _e393;
        } else {
            phi_601_ = f32();
            phi_602_ = true;
        }
        let _e395 = phi_601_;
        let _e397 = phi_602_;
        if _e397 {
            phi_606_ = _e373;
        } else {
            phi_606_ = _e395;
        }
        let _e399 = phi_606_;
        let _e403 = ((_e371 - (_e399 * 0.69314575f)) - (_e399 * 0.0000014286068f));
        phi_644_ = ((((((((((((((((1f / 5040f) * _e403) + (1f / 720f)) * _e403) + (1f / 120f)) * _e403) + (1f / 24f)) * _e403) + (1f / 6f)) * _e403) + 0.5f) * _e403) + 1f) * _e403) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e399), i32(-2147483648), (_e399 < bitcast<f32>(3472883712u))), 2147483647i, (_e399 > bitcast<f32>(1325400063u))), (_e399 == _e399)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e439 = phi_644_;
    let _e450 = ((((_e208 * param_6.x) + (_e285 * param_6.y)) + (_e362 * param_6.z)) + (_e439 * param_6.w));
    if ((bitcast<u32>(_e450) & 2147483647u) > 2139095040u) {
        phi_672_ = _e450;
    } else {
        if (_e450 < 0f) {
            phi_671_ = 0f;
        } else {
            if (_e450 > 1f) {
                phi_670_ = 1f;
            } else {
                phi_670_ = _e450;
            }
            let _e457 = phi_670_;
            phi_671_ = _e457;
        }
        let _e459 = phi_671_;
        phi_672_ = _e459;
    }
    let _e461 = phi_672_;
    return _e461;
}

fn function_() {
    var local: f32;
    var phi_734_: bool;
    var phi_735_: bool;
    var phi_736_: bool;
    var phi_737_: bool;
    var phi_741_: bool;
    var phi_811_: bool;
    var phi_812_: bool;
    var phi_823_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_824_: bool;
    var phi_825_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_826_: bool;
    var phi_833_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_837_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_911_: bool;
    var phi_920_: bool;
    var phi_929_: bool;
    var phi_930_: bool;
    var phi_931_: bool;
    var phi_932_: bool;
    var phi_933_: bool;
    var phi_934_: bool;
    var phi_935_: bool;
    var phi_939_: bool;
    var phi_1029_: f32;
    var phi_1032_: f32;
    var phi_1061_: f32;
    var phi_1066_: f32;
    var phi_1067_: bool;
    var phi_1068_: f32;
    var phi_1069_: bool;
    var phi_1073_: f32;
    var phi_1093_: f32;
    var phi_1098_: f32;
    var phi_1099_: bool;
    var phi_1100_: f32;
    var phi_1101_: bool;
    var phi_1105_: f32;
    var phi_1155_: i32;
    var phi_1160_: i32;
    var phi_1165_: i32;
    var phi_1170_: i32;
    var phi_1179_: i32;
    var phi_1184_: i32;
    var phi_1189_: i32;
    var phi_1194_: i32;
    var phi_1249_: i32;
    var phi_1254_: i32;
    var phi_1259_: i32;
    var phi_1264_: i32;
    var phi_1283_: i32;
    var phi_1288_: i32;
    var phi_1293_: i32;
    var phi_1298_: i32;
    var phi_1317_: i32;
    var phi_1322_: i32;
    var phi_1327_: i32;
    var phi_1332_: i32;
    var phi_1351_: i32;
    var phi_1356_: i32;
    var phi_1361_: i32;
    var phi_1366_: i32;
    var phi_1444_: bool;
    var phi_1452_: bool;
    var phi_1464_: bool;
    var phi_1465_: bool;
    var phi_1469_: f32;
    var phi_1475_: f32;
    var phi_1477_: evaluate_Verdict;
    var phi_1487_: u32;
    var phi_1496_: f32;
    var phi_1498_: evaluate_Verdict;
    var phi_1499_: bool;
    var phi_1500_: evaluate_Verdict;
    var phi_1501_: bool;
    var phi_1506_: evaluate_Verdict;
    var phi_1511_: evaluate_Verdict;
    var phi_1512_: evaluate_Verdict;

    let _e53 = id_1;
    let _e60 = arrayLength((&map.member));
    let _e66 = arrayLength((&marks.member));
    let _e69 = p.member.size[0u];
    let _e71 = p.member.size[1u];
    let _e72 = lt_shaders_entry_pixel_index(_e53, _e69, _e71);
    if (bitcast<i32>(_e72.root) != 0i) {
        let _e78 = p.member.projection;
        if (_e72.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e82 = lt_math_OneLevel(_e78);
        let _e86 = samples.member[(0u + _e72.first_primitive)].normal[0u];
        let _e88 = global[0u];
        if (_e86 == _e88) {
            let _e91 = samples.member[(0u + _e72.first_primitive)].normal[1u];
            let _e93 = global[1u];
            if (_e91 == _e93) {
                let _e96 = samples.member[(0u + _e72.first_primitive)].normal[2u];
                let _e98 = global[2u];
                phi_734_ = (_e96 == _e98);
                phi_735_ = false;
            } else {
                phi_734_ = bool();
                phi_735_ = true;
            }
            let _e101 = phi_734_;
            let _e103 = phi_735_;
            phi_736_ = _e101;
            phi_737_ = _e103;
        } else {
            phi_736_ = bool();
            phi_737_ = true;
        }
        let _e105 = phi_736_;
        let _e107 = phi_737_;
        if _e107 {
            phi_741_ = false;
        } else {
            phi_741_ = _e105;
        }
        let _e109 = phi_741_;
        if !(_e109) {
            let _e112 = samples.member[(0u + _e72.first_primitive)].position;
            let _e114 = p.member.light.place;
            let _e120 = p.member.light.place[3u];
            let _e127 = (_e114.x - (_e112.x * _e120));
            let _e128 = (_e114.y - (_e112.y * _e120));
            let _e129 = (_e114.z - (_e112.z * _e120));
            let _e131 = samples.member[(0u + _e72.first_primitive)].normal;
            if ((((_e131.x * _e127) + (_e131.y * _e128)) + (_e131.z * _e129)) > 0f) {
                let _e145 = (((_e127 * _e127) + (_e128 * _e128)) + (_e129 * _e129));
                let _e147 = p.member.light.axis;
                let _e159 = p.member.light.place[3u];
                if (_e159 == 0f) {
                    phi_812_ = true;
                } else {
                    let _e162 = p.member.light.range_squared;
                    if (_e145 <= _e162) {
                        let _e165 = p.member.light.cos_outer;
                        phi_811_ = (-((((_e127 * _e147.x) + (_e128 * _e147.y)) + (_e129 * _e147.z))) >= (_e165 * sqrt(_e145)));
                    } else {
                        phi_811_ = false;
                    }
                    let _e170 = phi_811_;
                    phi_812_ = _e170;
                }
                let _e172 = phi_812_;
                if _e172 {
                    let _e174 = samples.member[(0u + _e72.first_primitive)].flags;
                    let _e182 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e188 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e182.unnamed.visibility, false), _e182.unnamed_1);
                    phi_823_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e188.unnamed, ((_e174 & 1u) == 0u));
                    phi_824_ = false;
                } else {
                    phi_823_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_824_ = true;
                }
                let _e193 = phi_823_;
                let _e195 = phi_824_;
                phi_825_ = _e193;
                phi_826_ = _e195;
            } else {
                phi_825_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_826_ = true;
            }
            let _e197 = phi_825_;
            let _e199 = phi_826_;
            if _e199 {
                let _e205 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e211 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e205.unnamed.visibility, false), _e205.unnamed_1);
                phi_833_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e211.unnamed, true);
            } else {
                phi_833_ = _e197;
            }
            let _e216 = phi_833_;
            phi_837_ = _e216;
        } else {
            let _e222 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e228 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e222.unnamed.visibility, false), _e222.unnamed_1);
            phi_837_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e228.unnamed, true);
        }
        let _e233 = phi_837_;
        if _e233.unnamed_1 {
            phi_1512_ = evaluate_Verdict(_e233.unnamed.visibility, _e233.unnamed.is_doubted);
        } else {
            let _e241 = samples.member[(0u + _e72.first_primitive)].position;
            let _e259 = ((((_e82.projection.row_w.x * _e241.x) + (_e82.projection.row_w.y * _e241.y)) + (_e82.projection.row_w.z * _e241.z)) + (_e82.projection.row_w.w * 1f));
            let _e273 = (((((_e82.projection.row_x.x * _e241.x) + (_e82.projection.row_x.y * _e241.y)) + (_e82.projection.row_x.z * _e241.z)) + (_e82.projection.row_x.w * 1f)) / _e259);
            let _e287 = (((((_e82.projection.row_y.x * _e241.x) + (_e82.projection.row_y.y * _e241.y)) + (_e82.projection.row_y.z * _e241.z)) + (_e82.projection.row_y.w * 1f)) / _e259);
            let _e300 = ((((_e82.projection.row_z.x * _e241.x) + (_e82.projection.row_z.y * _e241.y)) + (_e82.projection.row_z.z * _e241.z)) + (_e82.projection.row_z.w * 1f));
            if (_e259 > 0f) {
                if (_e273 >= 0f) {
                    phi_911_ = (_e273 <= 1f);
                } else {
                    phi_911_ = false;
                }
                let _e305 = phi_911_;
                if _e305 {
                    if (_e287 >= 0f) {
                        phi_920_ = (_e287 <= 1f);
                    } else {
                        phi_920_ = false;
                    }
                    let _e309 = phi_920_;
                    if _e309 {
                        if (_e300 >= 0f) {
                            phi_929_ = (_e300 <= 1f);
                        } else {
                            phi_929_ = false;
                        }
                        let _e313 = phi_929_;
                        phi_930_ = _e313;
                        phi_931_ = false;
                    } else {
                        phi_930_ = bool();
                        phi_931_ = true;
                    }
                    let _e315 = phi_930_;
                    let _e317 = phi_931_;
                    phi_932_ = _e315;
                    phi_933_ = _e317;
                } else {
                    phi_932_ = bool();
                    phi_933_ = true;
                }
                let _e319 = phi_932_;
                let _e321 = phi_933_;
                phi_934_ = _e319;
                phi_935_ = _e321;
            } else {
                phi_934_ = bool();
                phi_935_ = true;
            }
            let _e323 = phi_934_;
            let _e325 = phi_935_;
            if _e325 {
                phi_939_ = false;
            } else {
                phi_939_ = _e323;
            }
            let _e327 = phi_939_;
            if _e327 {
                if (0f > 0f) {
                    let _e330 = samples.member[(0u + _e72.first_primitive)].normal;
                    let _e332 = p.member.map_size;
                    let _e402 = ((abs(((((_e78.row_x.x * _e330.x) + (_e78.row_x.y * _e330.y)) + (_e78.row_x.z * _e330.z)) / (((_e78.row_x.x * _e78.row_x.x) + (_e78.row_x.y * _e78.row_x.y)) + (_e78.row_x.z * _e78.row_x.z)))) + abs(((((_e78.row_y.x * _e330.x) + (_e78.row_y.y * _e330.y)) + (_e78.row_y.z * _e330.z)) / (((_e78.row_y.x * _e78.row_y.x) + (_e78.row_y.y * _e78.row_y.y)) + (_e78.row_y.z * _e78.row_y.z))))) / (abs(((((_e78.row_z.x * _e330.x) + (_e78.row_z.y * _e330.y)) + (_e78.row_z.z * _e330.z)) / (((_e78.row_z.x * _e78.row_z.x) + (_e78.row_z.y * _e78.row_z.y)) + (_e78.row_z.z * _e78.row_z.z)))) * f32(_e332)));
                    if (_e402 < 0.002f) {
                        phi_1029_ = _e402;
                    } else {
                        phi_1029_ = 0.002f;
                    }
                    let _e405 = phi_1029_;
                    phi_1032_ = (_e300 - (0f * _e405));
                } else {
                    phi_1032_ = _e300;
                }
                let _e409 = phi_1032_;
                let _e411 = p.member.map_size;
                let _e412 = f32(_e411);
                let _e415 = ((_e273 * _e412) - 0.5f);
                let _e416 = ((_e287 * _e412) - 0.5f);
                if (_e415 > -8388608f) {
                    let _e428 = f32(select(0i, select(select(i32(_e415), i32(-2147483648), (_e415 < bitcast<f32>(3472883712u))), 2147483647i, (_e415 > bitcast<f32>(1325400063u))), (_e415 == _e415)));
                    if (_e428 > _e415) {
                        phi_1061_ = 1f;
                    } else {
                        phi_1061_ = 0f;
                    }
                    let _e431 = phi_1061_;
                    if (_e415 < 8388608f) {
                        phi_1066_ = (_e428 - _e431);
                        phi_1067_ = false;
                    } else {
                        phi_1066_ = f32();
                        phi_1067_ = true;
                    }
                    let _e434 = phi_1066_;
                    let _e436 = phi_1067_;
                    phi_1068_ = _e434;
                    phi_1069_ = _e436;
                } else {
                    phi_1068_ = f32();
                    phi_1069_ = true;
                }
                let _e438 = phi_1068_;
                let _e440 = phi_1069_;
                if _e440 {
                    phi_1073_ = _e415;
                } else {
                    phi_1073_ = _e438;
                }
                let _e442 = phi_1073_;
                if (_e416 > -8388608f) {
                    let _e454 = f32(select(0i, select(select(i32(_e416), i32(-2147483648), (_e416 < bitcast<f32>(3472883712u))), 2147483647i, (_e416 > bitcast<f32>(1325400063u))), (_e416 == _e416)));
                    if (_e454 > _e416) {
                        phi_1093_ = 1f;
                    } else {
                        phi_1093_ = 0f;
                    }
                    let _e457 = phi_1093_;
                    if (_e416 < 8388608f) {
                        phi_1098_ = (_e454 - _e457);
                        phi_1099_ = false;
                    } else {
                        phi_1098_ = f32();
                        phi_1099_ = true;
                    }
                    let _e460 = phi_1098_;
                    let _e462 = phi_1099_;
                    phi_1100_ = _e460;
                    phi_1101_ = _e462;
                } else {
                    phi_1100_ = f32();
                    phi_1101_ = true;
                }
                let _e464 = phi_1100_;
                let _e466 = phi_1101_;
                if _e466 {
                    phi_1105_ = _e416;
                } else {
                    phi_1105_ = _e464;
                }
                let _e468 = phi_1105_;
                let _e469 = (_e415 - _e442);
                let _e470 = (_e416 - _e468);
                let _e479 = select(0i, select(select(i32(_e442), i32(-2147483648), (_e442 < bitcast<f32>(3472883712u))), 2147483647i, (_e442 > bitcast<f32>(1325400063u))), (_e442 == _e442));
                let _e488 = select(0i, select(select(i32(_e468), i32(-2147483648), (_e468 < bitcast<f32>(3472883712u))), 2147483647i, (_e468 > bitcast<f32>(1325400063u))), (_e468 == _e468));
                let _e499 = p.member.test;
                let _e500 = _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e499);
                let _e502 = p.member.map_size;
                local = _e500;
                let _e504 = ((0u * _e502) * _e502);
                let _e506 = (bitcast<i32>(_e502) - 1i);
                if (_e479 > 0i) {
                    phi_1155_ = _e479;
                } else {
                    phi_1155_ = 0i;
                }
                let _e509 = phi_1155_;
                if (_e488 > 0i) {
                    phi_1160_ = _e488;
                } else {
                    phi_1160_ = 0i;
                }
                let _e512 = phi_1160_;
                if (_e509 < _e506) {
                    phi_1165_ = _e509;
                } else {
                    phi_1165_ = _e506;
                }
                let _e515 = phi_1165_;
                if (_e512 < _e506) {
                    phi_1170_ = _e512;
                } else {
                    phi_1170_ = _e506;
                }
                let _e518 = phi_1170_;
                let _e519 = bitcast<u32>(_e515);
                let _e521 = (_e479 + 1i);
                let _e522 = (_e488 + 1i);
                if (_e521 > 0i) {
                    phi_1179_ = _e521;
                } else {
                    phi_1179_ = 0i;
                }
                let _e525 = phi_1179_;
                if (_e522 > 0i) {
                    phi_1184_ = _e522;
                } else {
                    phi_1184_ = 0i;
                }
                let _e528 = phi_1184_;
                if (_e525 < _e506) {
                    phi_1189_ = _e525;
                } else {
                    phi_1189_ = _e506;
                }
                let _e531 = phi_1189_;
                if (_e528 < _e506) {
                    phi_1194_ = _e528;
                } else {
                    phi_1194_ = _e506;
                }
                let _e534 = phi_1194_;
                let _e535 = bitcast<u32>(_e531);
                let _e537 = (bitcast<u32>(_e518) * _e502);
                let _e538 = (bitcast<u32>(_e534) * _e502);
                let _e543 = ((_e537 + _e519) + _e504);
                let _e544 = ((_e537 + _e535) + _e504);
                let _e545 = ((_e538 + _e519) + _e504);
                let _e546 = ((_e538 + _e535) + _e504);
                if (_e543 < _e60) {
                } else {
                    return;
                }
                let _e550 = map.member[(0u + _e543)];
                if (_e544 < _e60) {
                } else {
                    return;
                }
                let _e554 = map.member[(0u + _e544)];
                if (_e545 < _e60) {
                } else {
                    return;
                }
                let _e558 = map.member[(0u + _e545)];
                if (_e546 < _e60) {
                } else {
                    return;
                }
                let _e562 = map.member[(0u + _e546)];
                let _e564 = _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e550, _e554, _e558, _e562), vec4<f32>(((1f - _e469) * (1f - _e470)), (_e469 * (1f - _e470)), ((1f - _e469) * _e470), (_e469 * _e470)), _e409);
                let _e566 = p.member.map_size;
                let _e568 = (bitcast<i32>(_e566) - 1i);
                if (_e479 > 0i) {
                    phi_1249_ = _e479;
                } else {
                    phi_1249_ = 0i;
                }
                let _e571 = phi_1249_;
                if (_e488 > 0i) {
                    phi_1254_ = _e488;
                } else {
                    phi_1254_ = 0i;
                }
                let _e574 = phi_1254_;
                if (_e571 < _e568) {
                    phi_1259_ = _e571;
                } else {
                    phi_1259_ = _e568;
                }
                let _e577 = phi_1259_;
                if (_e574 < _e568) {
                    phi_1264_ = _e574;
                } else {
                    phi_1264_ = _e568;
                }
                let _e580 = phi_1264_;
                let _e581 = bitcast<u32>(_e577);
                let _e588 = ((((0u * _e566) + bitcast<u32>(_e580)) * (_e566 / 16u)) + (_e581 / 16u));
                let _e591 = (_e479 + 1i);
                let _e592 = (_e488 + 0i);
                let _e594 = (bitcast<i32>(_e566) - 1i);
                if (_e591 > 0i) {
                    phi_1283_ = _e591;
                } else {
                    phi_1283_ = 0i;
                }
                let _e597 = phi_1283_;
                if (_e592 > 0i) {
                    phi_1288_ = _e592;
                } else {
                    phi_1288_ = 0i;
                }
                let _e600 = phi_1288_;
                if (_e597 < _e594) {
                    phi_1293_ = _e597;
                } else {
                    phi_1293_ = _e594;
                }
                let _e603 = phi_1293_;
                if (_e600 < _e594) {
                    phi_1298_ = _e600;
                } else {
                    phi_1298_ = _e594;
                }
                let _e606 = phi_1298_;
                let _e607 = bitcast<u32>(_e603);
                let _e614 = ((((0u * _e566) + bitcast<u32>(_e606)) * (_e566 / 16u)) + (_e607 / 16u));
                let _e617 = (_e479 + 0i);
                let _e618 = (_e488 + 1i);
                let _e620 = (bitcast<i32>(_e566) - 1i);
                if (_e617 > 0i) {
                    phi_1317_ = _e617;
                } else {
                    phi_1317_ = 0i;
                }
                let _e623 = phi_1317_;
                if (_e618 > 0i) {
                    phi_1322_ = _e618;
                } else {
                    phi_1322_ = 0i;
                }
                let _e626 = phi_1322_;
                if (_e623 < _e620) {
                    phi_1327_ = _e623;
                } else {
                    phi_1327_ = _e620;
                }
                let _e629 = phi_1327_;
                if (_e626 < _e620) {
                    phi_1332_ = _e626;
                } else {
                    phi_1332_ = _e620;
                }
                let _e632 = phi_1332_;
                let _e633 = bitcast<u32>(_e629);
                let _e640 = ((((0u * _e566) + bitcast<u32>(_e632)) * (_e566 / 16u)) + (_e633 / 16u));
                let _e643 = (_e479 + 1i);
                let _e644 = (_e488 + 1i);
                let _e646 = (bitcast<i32>(_e566) - 1i);
                if (_e643 > 0i) {
                    phi_1351_ = _e643;
                } else {
                    phi_1351_ = 0i;
                }
                let _e649 = phi_1351_;
                if (_e644 > 0i) {
                    phi_1356_ = _e644;
                } else {
                    phi_1356_ = 0i;
                }
                let _e652 = phi_1356_;
                if (_e649 < _e646) {
                    phi_1361_ = _e649;
                } else {
                    phi_1361_ = _e646;
                }
                let _e655 = phi_1361_;
                if (_e652 < _e646) {
                    phi_1366_ = _e652;
                } else {
                    phi_1366_ = _e646;
                }
                let _e658 = phi_1366_;
                let _e659 = bitcast<u32>(_e655);
                let _e666 = ((((0u * _e566) + bitcast<u32>(_e658)) * (_e566 / 16u)) + (_e659 / 16u));
                if (_e588 < _e66) {
                } else {
                    return;
                }
                let _e672 = marks.member[(0u + _e588)];
                if (_e614 < _e66) {
                } else {
                    return;
                }
                let _e680 = marks.member[(0u + _e614)];
                if (_e640 < _e66) {
                } else {
                    return;
                }
                let _e689 = marks.member[(0u + _e640)];
                if (_e666 < _e66) {
                } else {
                    return;
                }
                let _e697 = marks.member[(0u + _e666)];
                let _e705 = p.member.epsilon;
                if (_e564 <= _e705) {
                    phi_1444_ = true;
                } else {
                    phi_1444_ = (_e564 >= (1f - _e705));
                }
                let _e710 = phi_1444_;
                if ((bitcast<u32>(_e564) & 2147483647u) > 2139095040u) {
                    phi_1452_ = true;
                } else {
                    phi_1452_ = !(_e710);
                }
                let _e716 = phi_1452_;
                if _e716 {
                    if (_e564 > 0f) {
                        if (_e564 < 1f) {
                            phi_1464_ = false;
                        } else {
                            phi_1464_ = true;
                        }
                        let _e720 = phi_1464_;
                        phi_1465_ = _e720;
                    } else {
                        phi_1465_ = true;
                    }
                    let _e722 = phi_1465_;
                    if _e722 {
                        phi_1469_ = 0.5f;
                    } else {
                        phi_1469_ = _e564;
                    }
                    let _e724 = phi_1469_;
                    phi_1477_ = evaluate_Verdict(_e724, true);
                } else {
                    if (_e564 > 0.5f) {
                        phi_1475_ = 1f;
                    } else {
                        phi_1475_ = 0f;
                    }
                    let _e728 = phi_1475_;
                    phi_1477_ = evaluate_Verdict(_e728, false);
                }
                let _e731 = phi_1477_;
                let _e734 = (_e731.visibility < 0.5f);
                if _e731.is_doubted {
                    phi_1500_ = evaluate_Verdict();
                    phi_1501_ = true;
                } else {
                    if _e734 {
                        phi_1487_ = 2u;
                    } else {
                        phi_1487_ = 1u;
                    }
                    let _e736 = phi_1487_;
                    if ((((((_e672 >> bitcast<u32>((((_e581 % 16u) * 2u) & 31u))) & 3u) | ((_e680 >> bitcast<u32>((((_e607 % 16u) * 2u) & 31u))) & 3u)) | (((_e689 >> bitcast<u32>((((_e633 % 16u) * 2u) & 31u))) & 3u) | ((_e697 >> bitcast<u32>((((_e659 % 16u) * 2u) & 31u))) & 3u))) & _e736) != 0u) {
                        if _e734 {
                            phi_1496_ = 0.000000059604645f;
                        } else {
                            phi_1496_ = 0.99999994f;
                        }
                        let _e740 = phi_1496_;
                        phi_1498_ = evaluate_Verdict(_e740, true);
                        phi_1499_ = false;
                    } else {
                        phi_1498_ = evaluate_Verdict();
                        phi_1499_ = true;
                    }
                    let _e743 = phi_1498_;
                    let _e745 = phi_1499_;
                    phi_1500_ = _e743;
                    phi_1501_ = _e745;
                }
                let _e747 = phi_1500_;
                let _e749 = phi_1501_;
                if _e749 {
                    phi_1506_ = evaluate_Verdict(_e731.visibility, _e731.is_doubted);
                } else {
                    phi_1506_ = _e747;
                }
                let _e752 = phi_1506_;
                phi_1511_ = evaluate_Verdict(_e752.visibility, _e752.is_doubted);
            } else {
                phi_1511_ = evaluate_Verdict(0.5f, true);
            }
            let _e758 = phi_1511_;
            phi_1512_ = _e758;
        }
        let _e760 = phi_1512_;
        if (_e72.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e72.first_primitive)] = _e760.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_esm_marks_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
