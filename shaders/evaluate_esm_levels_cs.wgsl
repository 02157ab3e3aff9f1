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
    fade_uv: f32,
    pad0_: u32,
}

struct type_32 {
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
var<uniform> p: type_32;
@group(0) @binding(2) 
var<storage> map: type_13;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_13;
@group(0) @binding(4) 
var<storage> levels: type_37;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_159_: lt_bvh_traverse_Tree;
    var phi_160_: bool;
    var phi_161_: lt_bvh_traverse_Tree;
    var phi_162_: bool;
    var phi_167_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_159_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_160_ = false;
        } else {
            phi_159_ = lt_bvh_traverse_Tree();
            phi_160_ = true;
        }
        let _e65 = phi_159_;
        let _e67 = phi_160_;
        phi_161_ = _e65;
        phi_162_ = _e67;
    } else {
        phi_161_ = lt_bvh_traverse_Tree();
        phi_162_ = true;
    }
    let _e69 = phi_161_;
    let _e71 = phi_162_;
    if _e71 {
        phi_167_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_167_ = _e69;
    }
    let _e76 = phi_167_;
    return lt_bvh_traverse_Tree(_e76.root, _e76.first_primitive);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_esm_Esm_clamped_exponent(param_4: ptr<function, f32>) -> f32 {
    var phi_187_: bool;
    var phi_191_: f32;

    let _e53 = (*param_4);
    if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
        phi_187_ = true;
    } else {
        let _e57 = (84f < _e53);
        if _e57 {
        }
        phi_187_ = _e57;
    }
    let _e59 = phi_187_;
    if _e59 {
        phi_191_ = 84f;
    } else {
        phi_191_ = _e53;
    }
    let _e61 = phi_191_;
    return _e61;
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_5: ptr<function, f32>, param_6: vec4<f32>, param_7: vec4<f32>, param_8: f32) -> f32 {
    var phi_212_: f32;
    var phi_213_: f32;
    var phi_214_: f32;
    var phi_230_: f32;
    var phi_231_: f32;
    var phi_232_: f32;
    var phi_248_: f32;
    var phi_249_: f32;
    var phi_250_: f32;
    var phi_266_: f32;
    var phi_267_: f32;
    var phi_268_: f32;
    var phi_284_: f32;
    var phi_285_: f32;
    var phi_286_: f32;
    var phi_305_: f32;
    var phi_310_: f32;
    var phi_332_: f32;
    var phi_337_: f32;
    var phi_338_: bool;
    var phi_339_: f32;
    var phi_340_: bool;
    var phi_344_: f32;
    var phi_382_: f32;
    var phi_393_: f32;
    var phi_398_: f32;
    var phi_420_: f32;
    var phi_425_: f32;
    var phi_426_: bool;
    var phi_427_: f32;
    var phi_428_: bool;
    var phi_432_: f32;
    var phi_470_: f32;
    var phi_481_: f32;
    var phi_486_: f32;
    var phi_508_: f32;
    var phi_513_: f32;
    var phi_514_: bool;
    var phi_515_: f32;
    var phi_516_: bool;
    var phi_520_: f32;
    var phi_558_: f32;
    var phi_569_: f32;
    var phi_574_: f32;
    var phi_596_: f32;
    var phi_601_: f32;
    var phi_602_: bool;
    var phi_603_: f32;
    var phi_604_: bool;
    var phi_608_: f32;
    var phi_646_: f32;
    var phi_672_: f32;
    var phi_673_: f32;
    var phi_674_: f32;

    let _e56 = _lt_math_esm_Esm_clamped_exponent(param_5);
    if ((bitcast<u32>(param_8) & 2147483647u) > 2139095040u) {
        phi_214_ = param_8;
    } else {
        if (param_8 < 0f) {
            phi_213_ = 0f;
        } else {
            if (param_8 > 1f) {
                phi_212_ = 1f;
            } else {
                phi_212_ = param_8;
            }
            let _e63 = phi_212_;
            phi_213_ = _e63;
        }
        let _e65 = phi_213_;
        phi_214_ = _e65;
    }
    let _e67 = phi_214_;
    if ((bitcast<u32>(param_6.x) & 2147483647u) > 2139095040u) {
        phi_232_ = param_6.x;
    } else {
        if (param_6.x < 0f) {
            phi_231_ = 0f;
        } else {
            if (param_6.x > 1f) {
                phi_230_ = 1f;
            } else {
                phi_230_ = param_6.x;
            }
            let _e75 = phi_230_;
            phi_231_ = _e75;
        }
        let _e77 = phi_231_;
        phi_232_ = _e77;
    }
    let _e79 = phi_232_;
    if ((bitcast<u32>(param_6.y) & 2147483647u) > 2139095040u) {
        phi_250_ = param_6.y;
    } else {
        if (param_6.y < 0f) {
            phi_249_ = 0f;
        } else {
            if (param_6.y > 1f) {
                phi_248_ = 1f;
            } else {
                phi_248_ = param_6.y;
            }
            let _e87 = phi_248_;
            phi_249_ = _e87;
        }
        let _e89 = phi_249_;
        phi_250_ = _e89;
    }
    let _e91 = phi_250_;
    if ((bitcast<u32>(param_6.z) & 2147483647u) > 2139095040u) {
        phi_268_ = param_6.z;
    } else {
        if (param_6.z < 0f) {
            phi_267_ = 0f;
        } else {
            if (param_6.z > 1f) {
                phi_266_ = 1f;
            } else {
                phi_266_ = param_6.z;
            }
            let _e99 = phi_266_;
            phi_267_ = _e99;
        }
        let _e101 = phi_267_;
        phi_268_ = _e101;
    }
    let _e103 = phi_268_;
    if ((bitcast<u32>(param_6.w) & 2147483647u) > 2139095040u) {
        phi_286_ = param_6.w;
    } else {
        if (param_6.w < 0f) {
            phi_285_ = 0f;
        } else {
            if (param_6.w > 1f) {
                phi_284_ = 1f;
            } else {
                phi_284_ = param_6.w;
            }
            let _e111 = phi_284_;
            phi_285_ = _e111;
        }
        let _e113 = phi_285_;
        phi_286_ = _e113;
    }
    let _e115 = phi_286_;
    let _e120 = (_e56 * (_e79 - _e67));
    let _e121 = (_e56 * (_e91 - _e67));
    let _e122 = (_e56 * (_e103 - _e67));
    let _e123 = (_e56 * (_e115 - _e67));
    if ((bitcast<u32>(_e120) & 2147483647u) > 2139095040u) {
        phi_382_ = _e120;
    } else {
        if (_e120 < -87f) {
            phi_305_ = -87f;
        } else {
            phi_305_ = _e120;
        }
        let _e129 = phi_305_;
        if (_e129 > 88f) {
            phi_310_ = 88f;
        } else {
            phi_310_ = _e129;
        }
        let _e132 = phi_310_;
        let _e134 = ((_e132 * 1.442695f) + 0.5f);
        if (_e134 > -8388608f) {
            let _e146 = f32(select(0i, select(select(i32(_e134), i32(-2147483648), (_e134 < bitcast<f32>(3472883712u))), 2147483647i, (_e134 > bitcast<f32>(1325400063u))), (_e134 == _e134)));
            if (_e146 > _e134) {
                phi_332_ = 1f;
            } else {
                phi_332_ = 0f;
            }
            let _e149 = phi_332_;
            if (_e134 < 8388608f) {
                phi_337_ = (_e146 - _e149);
                phi_338_ = false;
            } else {
                phi_337_ = f32();
                phi_338_ = true;
            }
            let _e152 = phi_337_;
            let _e154 = phi_338_;
            phi_339_ = _e152;
            phi_340_ = _e154;
        } else {
            phi_339_ = f32();
            phi_340_ = true;
        }
        let _e156 = phi_339_;
        let _e158 = phi_340_;
        if _e158 {
            phi_344_ = _e134;
        } else {
            phi_344_ = _e156;
        }
        let _e160 = phi_344_;
        let _e164 = ((_e132 - (_e160 * 0.69314575f)) - (_e160 * 0.0000014286068f));
        phi_382_ = ((((((((((((((((1f / 5040f) * _e164) + (1f / 720f)) * _e164) + (1f / 120f)) * _e164) + (1f / 24f)) * _e164) + (1f / 6f)) * _e164) + 0.5f) * _e164) + 1f) * _e164) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e160), i32(-2147483648), (_e160 < bitcast<f32>(3472883712u))), 2147483647i, (_e160 > bitcast<f32>(1325400063u))), (_e160 == _e160)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e200 = phi_382_;
    if ((bitcast<u32>(_e121) & 2147483647u) > 2139095040u) {
        phi_470_ = _e121;
    } else {
        if (_e121 < -87f) {
            phi_393_ = -87f;
        } else {
            phi_393_ = _e121;
        }
        let _e206 = phi_393_;
        if (_e206 > 88f) {
            phi_398_ = 88f;
        } else {
            phi_398_ = _e206;
        }
        let _e209 = phi_398_;
        let _e211 = ((_e209 * 1.442695f) + 0.5f);
        if (_e211 > -8388608f) {
            let _e223 = f32(select(0i, select(select(i32(_e211), i32(-2147483648), (_e211 < bitcast<f32>(3472883712u))), 2147483647i, (_e211 > bitcast<f32>(1325400063u))), (_e211 == _e211)));
            if (_e223 > _e211) {
                phi_420_ = 1f;
            } else {
                phi_420_ = 0f;
            }
            let _e226 = phi_420_;
            if (_e211 < 8388608f) {
                phi_425_ = (_e223 - _e226);
                phi_426_ = false;
            } else {
                phi_425_ = f32();
                phi_426_ = true;
            }
            let _e229 = phi_425_;
            let _e231 = phi_426_;
            phi_427_ = _e229;
            phi_428_ = _e231;
        } else {
            phi_427_ = f32();
            phi_428_ = true;
        }
        let _e233 = phi_427_;
        let _e235 = phi_428_;
        if _e235 {
            phi_432_ = _e211;
        } else {
            phi_432_ = _e233;
        }
        let _e237 = phi_432_;
        let _e241 = ((_e209 - (_e237 * 0.69314575f)) - (_e237 * 0.0000014286068f));
        phi_470_ = ((((((((((((((((1f / 5040f) * _e241) + (1f / 720f)) * _e241) + (1f / 120f)) * _e241) + (1f / 24f)) * _e241) + (1f / 6f)) * _e241) + 0.5f) * _e241) + 1f) * _e241) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e237), i32(-2147483648), (_e237 < bitcast<f32>(3472883712u))), 2147483647i, (_e237 > bitcast<f32>(1325400063u))), (_e237 == _e237)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e277 = phi_470_;
    if ((bitcast<u32>(_e122) & 2147483647u) > 2139095040u) {
        phi_558_ = _e122;
    } else {
        if (_e122 < -87f) {
            phi_481_ = -87f;
        } else {
            phi_481_ = _e122;
        }
        let _e283 = phi_481_;
        if (_e283 > 88f) {
            phi_486_ = 88f;
        } else {
            phi_486_ = _e283;
        }
        let _e286 = phi_486_;
        let _e288 = ((_e286 * 1.442695f) + 0.5f);
        if (_e288 > -8388608f) {
            let _e300 = f32(select(0i, select(select(i32(_e288), i32(-2147483648), (_e288 < bitcast<f32>(3472883712u))), 2147483647i, (_e288 > bitcast<f32>(1325400063u))), (_e288 == _e288)));
            if (_e300 > _e288) {
                phi_508_ = 1f;
            } else {
                phi_508_ = 0f;
            }
            let _e303 = phi_508_;
            if (_e288 < 8388608f) {
                phi_513_ = (_e300 - _e303);
                phi_514_ = false;
            } else {
                phi_513_ = f32();
                phi_514_ = true;
            }
            let _e306 = phi_513_;
            let _e308 = phi_514_;
            phi_515_ = _e306;
            phi_516_ = _e308;
        } else {
            phi_515_ = f32();
            phi_516_ = true;
        }
        let _e310 = phi_515_;
        let _e312 = phi_516_;
        if _e312 {
            phi_520_ = _e288;
        } else {
            phi_520_ = _e310;
        }
        let _e314 = phi_520_;
        let _e318 = ((_e286 - (_e314 * 0.69314575f)) - (_e314 * 0.0000014286068f));
        phi_558_ = ((((((((((((((((1f / 5040f) * _e318) + (1f / 720f)) * _e318) + (1f / 120f)) * _e318) + (1f / 24f)) * _e318) + (1f / 6f)) * _e318) + 0.5f) * _e318) + 1f) * _e318) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e314), i32(-2147483648), (_e314 < bitcast<f32>(3472883712u))), 2147483647i, (_e314 > bitcast<f32>(1325400063u))), (_e314 == _e314)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e354 = phi_558_;
    if ((bitcast<u32>(_e123) & 2147483647u) > 2139095040u) {
        phi_646_ = _e123;
    } else {
        if (_e123 < -87f) {
            phi_569_ = -87f;
        } else {
            phi_569_ = _e123;
        }
        let _e360 = phi_569_;
        if (_e360 > 88f) {
            phi_574_ = 88f;
        } else {
            phi_574_ = _e360;
        }
        let _e363 = phi_574_;
        let _e365 = ((_e363 * 1.442695f) + 0.5f);
        if (_e365 > -8388608f) {
            let _e377 = f32(select(0i, select(select(i32(_e365), i32(-2147483648), (_e365 < bitcast<f32>(3472883712u))), 2147483647i, (_e365 > bitcast<f32>(1325400063u))), (_e365 == _e365)));
            if (_e377 > _e365) {
                phi_596_ = 1f;
            } else {
                phi_596_ = 0f;
            }
            let _e380 = phi_596_;
            if (_e365 < 8388608f) {
                phi_601_ = (_e377 - _e380);
                phi_602_ = false;
            } else {
                phi_601_ = f32();
                phi_602_ = true;
            }
            let _e383 = phi_601_;
            let _e385 = phi_602_;
            phi_603_ = _e383;
            phi_604_ = _e385;
        } else {
            phi_603_ = f32();
            phi_604_ = true;
        }
        let _e387 = phi_603_;
        let _e389 = phi_604_;
        if _e389 {
            phi_608_ = _e365;
        } else {
            phi_608_ = _e387;
        }
        let _e391 = phi_608_;
        let _e395 = ((_e363 - (_e391 * 0.69314575f)) - (_e391 * 0.0000014286068f));
        phi_646_ = ((((((((((((((((1f / 5040f) * _e395) + (1f / 720f)) * _e395) + (1f / 120f)) * _e395) + (1f / 24f)) * _e395) + (1f / 6f)) * _e395) + 0.5f) * _e395) + 1f) * _e395) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e391), i32(-2147483648), (_e391 < bitcast<f32>(3472883712u))), 2147483647i, (_e391 > bitcast<f32>(1325400063u))), (_e391 == _e391)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e431 = phi_646_;
    let _e442 = ((((_e200 * param_7.x) + (_e277 * param_7.y)) + (_e354 * param_7.z)) + (_e431 * param_7.w));
    if ((bitcast<u32>(_e442) & 2147483647u) > 2139095040u) {
        phi_674_ = _e442;
    } else {
        if (_e442 < 0f) {
            phi_673_ = 0f;
        } else {
            if (_e442 > 1f) {
                phi_672_ = 1f;
            } else {
                phi_672_ = _e442;
            }
            let _e449 = phi_672_;
            phi_673_ = _e449;
        }
        let _e451 = phi_673_;
        phi_674_ = _e451;
    }
    let _e453 = phi_674_;
    return _e453;
}

fn lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(param_9: f32, param_10: f32) -> f32 {
    var phi_682_: f32;

    if (param_9 < param_10) {
        phi_682_ = param_9;
    } else {
        phi_682_ = param_10;
    }
    let _e56 = phi_682_;
    return _e56;
}

fn function_() {
    var local: f32;
    var phi_742_: bool;
    var phi_743_: bool;
    var phi_744_: bool;
    var phi_745_: bool;
    var phi_749_: bool;
    var phi_819_: bool;
    var phi_820_: bool;
    var phi_831_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_832_: bool;
    var phi_833_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_834_: bool;
    var phi_841_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_845_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_865_: lt_math_LightPoint;
    var phi_868_: u32;
    var phi_870_: lt_math_LevelPoint;
    var phi_956_: bool;
    var phi_965_: bool;
    var phi_974_: bool;
    var phi_975_: bool;
    var phi_976_: bool;
    var phi_977_: bool;
    var phi_978_: bool;
    var phi_979_: bool;
    var phi_980_: bool;
    var phi_984_: bool;
    var phi_1011_: bool;
    var phi_1012_: bool;
    var phi_1013_: bool;
    var phi_1014_: bool;
    var phi_1015_: bool;
    var phi_1016_: bool;
    var phi_1017_: bool;
    var phi_1018_: bool;
    var phi_1022_: bool;
    var phi_1031_: lt_math_LightPoint;
    var phi_1032_: u32;
    var phi_1033_: lt_math_LevelPoint;
    var phi_1034_: bool;
    var phi_866_: lt_math_LightPoint;
    var phi_869_: u32;
    var phi_871_: lt_math_LevelPoint;
    var phi_1035_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_1075_: bool;
    var phi_1076_: bool;
    var phi_1077_: bool;
    var phi_1078_: bool;
    var phi_1082_: bool;
    var phi_1164_: f32;
    var phi_1280_: f32;
    var phi_1281_: f32;
    var phi_1284_: f32;
    var phi_1313_: f32;
    var phi_1318_: f32;
    var phi_1319_: bool;
    var phi_1320_: f32;
    var phi_1321_: bool;
    var phi_1325_: f32;
    var phi_1345_: f32;
    var phi_1350_: f32;
    var phi_1351_: bool;
    var phi_1352_: f32;
    var phi_1353_: bool;
    var phi_1357_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_1406_: i32;
    var phi_1411_: i32;
    var phi_1416_: i32;
    var phi_1421_: i32;
    var phi_1430_: i32;
    var phi_1435_: i32;
    var phi_1440_: i32;
    var phi_1445_: i32;
    var local_4: lt_math_LevelPoint;
    var phi_1517_: f32;
    var phi_1519_: evaluate_Verdict;
    var phi_1520_: bool;
    var phi_1521_: evaluate_Verdict;
    var phi_1522_: bool;
    var phi_1527_: evaluate_Verdict;
    var phi_1528_: bool;
    var phi_1530_: evaluate_Verdict;
    var phi_1531_: evaluate_Verdict;
    var phi_1532_: bool;
    var phi_1536_: evaluate_Verdict;
    var phi_1537_: evaluate_Verdict;
    var phi_1538_: bool;
    var phi_1542_: evaluate_Verdict;

    let _e53 = id_1;
    let _e60 = arrayLength((&map.member));
    let _e66 = arrayLength((&levels.member));
    let _e69 = p.member.size[0u];
    let _e71 = p.member.size[1u];
    let _e72 = lt_shaders_entry_pixel_index(_e53, _e69, _e71);
    if (bitcast<i32>(_e72.root) != 0i) {
        let _e78 = p.member.level_count;
        if (_e72.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e85 = samples.member[(0u + _e72.first_primitive)].normal[0u];
        let _e87 = global[0u];
        if (_e85 == _e87) {
            let _e90 = samples.member[(0u + _e72.first_primitive)].normal[1u];
            let _e92 = global[1u];
            if (_e90 == _e92) {
                let _e95 = samples.member[(0u + _e72.first_primitive)].normal[2u];
                let _e97 = global[2u];
                phi_742_ = (_e95 == _e97);
                phi_743_ = false;
            } else {
                phi_742_ = bool();
                phi_743_ = true;
            }
            let _e100 = phi_742_;
            let _e102 = phi_743_;
            phi_744_ = _e100;
            phi_745_ = _e102;
        } else {
            phi_744_ = bool();
            phi_745_ = true;
        }
        let _e104 = phi_744_;
        let _e106 = phi_745_;
        if _e106 {
            phi_749_ = false;
        } else {
            phi_749_ = _e104;
        }
        let _e108 = phi_749_;
        if !(_e108) {
            let _e111 = samples.member[(0u + _e72.first_primitive)].position;
            let _e113 = p.member.light.place;
            let _e119 = p.member.light.place[3u];
            let _e126 = (_e113.x - (_e111.x * _e119));
            let _e127 = (_e113.y - (_e111.y * _e119));
            let _e128 = (_e113.z - (_e111.z * _e119));
            let _e130 = samples.member[(0u + _e72.first_primitive)].normal;
            if ((((_e130.x * _e126) + (_e130.y * _e127)) + (_e130.z * _e128)) > 0f) {
                let _e144 = (((_e126 * _e126) + (_e127 * _e127)) + (_e128 * _e128));
                let _e146 = p.member.light.axis;
                let _e158 = p.member.light.place[3u];
                if (_e158 == 0f) {
                    phi_820_ = true;
                } else {
                    let _e161 = p.member.light.range_squared;
                    if (_e144 <= _e161) {
                        let _e164 = p.member.light.cos_outer;
                        phi_819_ = (-((((_e126 * _e146.x) + (_e127 * _e146.y)) + (_e128 * _e146.z))) >= (_e164 * sqrt(_e144)));
                    } else {
                        phi_819_ = false;
                    }
                    let _e169 = phi_819_;
                    phi_820_ = _e169;
                }
                let _e171 = phi_820_;
                if _e171 {
                    let _e173 = samples.member[(0u + _e72.first_primitive)].flags;
                    let _e181 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e187 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e181.unnamed.visibility, false), _e181.unnamed_1);
                    phi_831_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e187.unnamed, ((_e173 & 1u) == 0u));
                    phi_832_ = false;
                } else {
                    phi_831_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_832_ = true;
                }
                let _e192 = phi_831_;
                let _e194 = phi_832_;
                phi_833_ = _e192;
                phi_834_ = _e194;
            } else {
                phi_833_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_834_ = true;
            }
            let _e196 = phi_833_;
            let _e198 = phi_834_;
            if _e198 {
                let _e204 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e210 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e204.unnamed.visibility, false), _e204.unnamed_1);
                phi_841_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e210.unnamed, true);
            } else {
                phi_841_ = _e196;
            }
            let _e215 = phi_841_;
            phi_845_ = _e215;
        } else {
            let _e221 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e227 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e221.unnamed.visibility, false), _e221.unnamed_1);
            phi_845_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e227.unnamed, true);
        }
        let _e232 = phi_845_;
        if _e232.unnamed_1 {
            phi_1536_ = evaluate_Verdict(_e232.unnamed.visibility, _e232.unnamed.is_doubted);
            phi_1537_ = evaluate_Verdict();
            phi_1538_ = true;
        } else {
            let _e240 = samples.member[(0u + _e72.first_primitive)].position;
            let _e242 = p.member.map_size;
            let _e244 = (0.5f / f32(_e242));
            let _e251 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e258 = lt_math_LightPoint(vec2<f32>(_e251.uv.x, 0f), _e251.depth, _e251.is_inside);
            let _e262 = lt_math_LightPoint(_e258.uv, 0f, _e258.is_inside);
            phi_865_ = lt_math_LightPoint();
            phi_868_ = 0u;
            phi_870_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e262.uv, _e262.depth, false));
            loop {
                let _e269 = phi_865_;
                let _e271 = phi_868_;
                let _e273 = phi_870_;
                local_1 = _e273;
                local_2 = _e273;
                local_3 = _e273;
                local_4 = _e273;
                if (_e271 < _e78) {
                    if _e273.point.is_inside {
                        phi_1031_ = lt_math_LightPoint();
                        phi_1032_ = u32();
                        phi_1033_ = lt_math_LevelPoint();
                        phi_1034_ = false;
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
                                phi_956_ = (_e309 <= 1f);
                            } else {
                                phi_956_ = false;
                            }
                            let _e341 = phi_956_;
                            if _e341 {
                                if (_e323 >= 0f) {
                                    phi_965_ = (_e323 <= 1f);
                                } else {
                                    phi_965_ = false;
                                }
                                let _e345 = phi_965_;
                                if _e345 {
                                    if (_e336 >= 0f) {
                                        phi_974_ = (_e336 <= 1f);
                                    } else {
                                        phi_974_ = false;
                                    }
                                    let _e349 = phi_974_;
                                    phi_975_ = _e349;
                                    phi_976_ = false;
                                } else {
                                    phi_975_ = bool();
                                    phi_976_ = true;
                                }
                                let _e351 = phi_975_;
                                let _e353 = phi_976_;
                                phi_977_ = _e351;
                                phi_978_ = _e353;
                            } else {
                                phi_977_ = bool();
                                phi_978_ = true;
                            }
                            let _e355 = phi_977_;
                            let _e357 = phi_978_;
                            phi_979_ = _e355;
                            phi_980_ = _e357;
                        } else {
                            phi_979_ = bool();
                            phi_980_ = true;
                        }
                        let _e359 = phi_979_;
                        let _e361 = phi_980_;
                        if _e361 {
                            phi_984_ = false;
                        } else {
                            phi_984_ = _e359;
                        }
                        let _e363 = phi_984_;
                        if _e363 {
                            if (_e309 >= _e244) {
                                if (_e309 <= (1f - _e244)) {
                                    if (_e323 >= _e244) {
                                        phi_1011_ = (_e323 <= (1f - _e244));
                                        phi_1012_ = false;
                                    } else {
                                        phi_1011_ = bool();
                                        phi_1012_ = true;
                                    }
                                    let _e371 = phi_1011_;
                                    let _e373 = phi_1012_;
                                    phi_1013_ = _e371;
                                    phi_1014_ = _e373;
                                } else {
                                    phi_1013_ = bool();
                                    phi_1014_ = true;
                                }
                                let _e375 = phi_1013_;
                                let _e377 = phi_1014_;
                                phi_1015_ = _e375;
                                phi_1016_ = _e377;
                            } else {
                                phi_1015_ = bool();
                                phi_1016_ = true;
                            }
                            let _e379 = phi_1015_;
                            let _e381 = phi_1016_;
                            phi_1017_ = _e379;
                            phi_1018_ = _e381;
                        } else {
                            phi_1017_ = bool();
                            phi_1018_ = true;
                        }
                        let _e383 = phi_1017_;
                        let _e385 = phi_1018_;
                        if _e385 {
                            phi_1022_ = false;
                        } else {
                            phi_1022_ = _e383;
                        }
                        let _e387 = phi_1022_;
                        let _e394 = lt_math_LightPoint(vec2<f32>(_e309, _e269.uv.y), _e269.depth, _e269.is_inside);
                        let _e401 = lt_math_LightPoint(vec2<f32>(_e394.uv.x, _e323), _e394.depth, _e394.is_inside);
                        let _e405 = lt_math_LightPoint(_e401.uv, _e336, _e401.is_inside);
                        let _e409 = lt_math_LightPoint(_e405.uv, _e405.depth, _e387);
                        phi_1031_ = _e409;
                        phi_1032_ = (_e271 + 1u);
                        phi_1033_ = lt_math_LevelPoint(_e271, _e409);
                        phi_1034_ = true;
                    }
                    let _e413 = phi_1031_;
                    let _e415 = phi_1032_;
                    let _e417 = phi_1033_;
                    let _e419 = phi_1034_;
                    phi_866_ = _e413;
                    phi_869_ = _e415;
                    phi_871_ = _e417;
                    phi_1035_ = _e419;
                } else {
                    phi_866_ = lt_math_LightPoint();
                    phi_869_ = u32();
                    phi_871_ = lt_math_LevelPoint();
                    phi_1035_ = false;
                }
                let _e421 = phi_866_;
                let _e423 = phi_869_;
                let _e425 = phi_871_;
                let _e427 = phi_1035_;
                continue;
                continuing {
                    phi_865_ = _e421;
                    phi_868_ = _e423;
                    phi_870_ = _e425;
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
                            phi_1075_ = (_e441.row_w.z == _e453);
                            phi_1076_ = false;
                        } else {
                            phi_1075_ = bool();
                            phi_1076_ = true;
                        }
                        let _e456 = phi_1075_;
                        let _e458 = phi_1076_;
                        phi_1077_ = _e456;
                        phi_1078_ = _e458;
                    } else {
                        phi_1077_ = bool();
                        phi_1078_ = true;
                    }
                    let _e460 = phi_1077_;
                    let _e462 = phi_1078_;
                    if _e462 {
                        phi_1082_ = false;
                    } else {
                        phi_1082_ = _e460;
                    }
                    let _e464 = phi_1082_;
                    if _e464 {
                        let _e466 = samples.member[(0u + _e72.first_primitive)].normal;
                        let _e468 = p.member.map_size;
                        let _e538 = ((abs(((((_e441.row_x.x * _e466.x) + (_e441.row_x.y * _e466.y)) + (_e441.row_x.z * _e466.z)) / (((_e441.row_x.x * _e441.row_x.x) + (_e441.row_x.y * _e441.row_x.y)) + (_e441.row_x.z * _e441.row_x.z)))) + abs(((((_e441.row_y.x * _e466.x) + (_e441.row_y.y * _e466.y)) + (_e441.row_y.z * _e466.z)) / (((_e441.row_y.x * _e441.row_y.x) + (_e441.row_y.y * _e441.row_y.y)) + (_e441.row_y.z * _e441.row_y.z))))) / (abs(((((_e441.row_z.x * _e466.x) + (_e441.row_z.y * _e466.y)) + (_e441.row_z.z * _e466.z)) / (((_e441.row_z.x * _e441.row_z.x) + (_e441.row_z.y * _e441.row_z.y)) + (_e441.row_z.z * _e441.row_z.z)))) * f32(_e468)));
                        if (_e538 < 0.002f) {
                            phi_1164_ = _e538;
                        } else {
                            phi_1164_ = 0.002f;
                        }
                        let _e541 = phi_1164_;
                        phi_1281_ = _e541;
                    } else {
                        let _e543 = p.member.map_size;
                        let _e549 = samples.member[(0u + _e72.first_primitive)].position;
                        let _e560 = ((((_e441.row_w.x * _e549.x) + (_e441.row_w.y * _e549.y)) + (_e441.row_w.z * _e549.z)) + _e441.row_w.w);
                        let _e573 = ((_e441.row_x.x - (_e441.row_w.x * _e430.point.uv.x)) / _e560);
                        let _e574 = ((_e441.row_x.y - (_e441.row_w.y * _e430.point.uv.x)) / _e560);
                        let _e575 = ((_e441.row_x.z - (_e441.row_w.z * _e430.point.uv.x)) / _e560);
                        let _e588 = ((_e441.row_y.x - (_e441.row_w.x * _e430.point.uv.y)) / _e560);
                        let _e589 = ((_e441.row_y.y - (_e441.row_w.y * _e430.point.uv.y)) / _e560);
                        let _e590 = ((_e441.row_y.z - (_e441.row_w.z * _e430.point.uv.y)) / _e560);
                        let _e596 = samples.member[(0u + _e72.first_primitive)].normal;
                        let _e601 = ((_e589 * _e596.z) - (_e596.y * _e590));
                        let _e606 = ((_e590 * _e596.x) - (_e596.z * _e588));
                        let _e611 = ((_e588 * _e596.y) - (_e596.x * _e589));
                        let _e613 = samples.member[(0u + _e72.first_primitive)].normal;
                        let _e618 = ((_e574 * _e613.z) - (_e613.y * _e575));
                        let _e623 = ((_e575 * _e613.x) - (_e613.z * _e573));
                        let _e628 = ((_e573 * _e613.y) - (_e613.x * _e574));
                        let _e655 = ((abs(((((_e441.row_z.x * _e601) + (_e441.row_z.y * _e606)) + (_e441.row_z.z * _e611)) / (((_e573 * _e601) + (_e574 * _e606)) + (_e575 * _e611)))) + abs(((((_e441.row_z.x * _e618) + (_e441.row_z.y * _e623)) + (_e441.row_z.z * _e628)) / (((_e588 * _e618) + (_e589 * _e623)) + (_e590 * _e628))))) / f32(_e543));
                        if (_e655 < 0.002f) {
                            phi_1280_ = _e655;
                        } else {
                            phi_1280_ = 0.002f;
                        }
                        let _e658 = phi_1280_;
                        phi_1281_ = _e658;
                    }
                    let _e660 = phi_1281_;
                    phi_1284_ = (_e430.point.depth - (0f * _e660));
                } else {
                    phi_1284_ = _e430.point.depth;
                }
                let _e664 = phi_1284_;
                let _e670 = p.member.map_size;
                let _e671 = f32(_e670);
                let _e674 = ((_e430.point.uv.x * _e671) - 0.5f);
                let _e675 = ((_e430.point.uv.y * _e671) - 0.5f);
                if (_e674 > -8388608f) {
                    let _e687 = f32(select(0i, select(select(i32(_e674), i32(-2147483648), (_e674 < bitcast<f32>(3472883712u))), 2147483647i, (_e674 > bitcast<f32>(1325400063u))), (_e674 == _e674)));
                    if (_e687 > _e674) {
                        phi_1313_ = 1f;
                    } else {
                        phi_1313_ = 0f;
                    }
                    let _e690 = phi_1313_;
                    if (_e674 < 8388608f) {
                        phi_1318_ = (_e687 - _e690);
                        phi_1319_ = false;
                    } else {
                        phi_1318_ = f32();
                        phi_1319_ = true;
                    }
                    let _e693 = phi_1318_;
                    let _e695 = phi_1319_;
                    phi_1320_ = _e693;
                    phi_1321_ = _e695;
                } else {
                    phi_1320_ = f32();
                    phi_1321_ = true;
                }
                let _e697 = phi_1320_;
                let _e699 = phi_1321_;
                if _e699 {
                    phi_1325_ = _e674;
                } else {
                    phi_1325_ = _e697;
                }
                let _e701 = phi_1325_;
                if (_e675 > -8388608f) {
                    let _e713 = f32(select(0i, select(select(i32(_e675), i32(-2147483648), (_e675 < bitcast<f32>(3472883712u))), 2147483647i, (_e675 > bitcast<f32>(1325400063u))), (_e675 == _e675)));
                    if (_e713 > _e675) {
                        phi_1345_ = 1f;
                    } else {
                        phi_1345_ = 0f;
                    }
                    let _e716 = phi_1345_;
                    if (_e675 < 8388608f) {
                        phi_1350_ = (_e713 - _e716);
                        phi_1351_ = false;
                    } else {
                        phi_1350_ = f32();
                        phi_1351_ = true;
                    }
                    let _e719 = phi_1350_;
                    let _e721 = phi_1351_;
                    phi_1352_ = _e719;
                    phi_1353_ = _e721;
                } else {
                    phi_1352_ = f32();
                    phi_1353_ = true;
                }
                let _e723 = phi_1352_;
                let _e725 = phi_1353_;
                if _e725 {
                    phi_1357_ = _e675;
                } else {
                    phi_1357_ = _e723;
                }
                let _e727 = phi_1357_;
                let _e728 = (_e674 - _e701);
                let _e729 = (_e675 - _e727);
                let _e738 = select(0i, select(select(i32(_e701), i32(-2147483648), (_e701 < bitcast<f32>(3472883712u))), 2147483647i, (_e701 > bitcast<f32>(1325400063u))), (_e701 == _e701));
                let _e747 = select(0i, select(select(i32(_e727), i32(-2147483648), (_e727 < bitcast<f32>(3472883712u))), 2147483647i, (_e727 > bitcast<f32>(1325400063u))), (_e727 == _e727));
                let _e758 = p.member.test;
                let _e759 = _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e758);
                let _e761 = p.member.map_size;
                let _e763 = local_3;
                local = _e759;
                let _e766 = ((_e763.level * _e761) * _e761);
                let _e768 = (bitcast<i32>(_e761) - 1i);
                if (_e738 > 0i) {
                    phi_1406_ = _e738;
                } else {
                    phi_1406_ = 0i;
                }
                let _e771 = phi_1406_;
                if (_e747 > 0i) {
                    phi_1411_ = _e747;
                } else {
                    phi_1411_ = 0i;
                }
                let _e774 = phi_1411_;
                if (_e771 < _e768) {
                    phi_1416_ = _e771;
                } else {
                    phi_1416_ = _e768;
                }
                let _e777 = phi_1416_;
                if (_e774 < _e768) {
                    phi_1421_ = _e774;
                } else {
                    phi_1421_ = _e768;
                }
                let _e780 = phi_1421_;
                let _e781 = bitcast<u32>(_e777);
                let _e783 = (_e738 + 1i);
                let _e784 = (_e747 + 1i);
                if (_e783 > 0i) {
                    phi_1430_ = _e783;
                } else {
                    phi_1430_ = 0i;
                }
                let _e787 = phi_1430_;
                if (_e784 > 0i) {
                    phi_1435_ = _e784;
                } else {
                    phi_1435_ = 0i;
                }
                let _e790 = phi_1435_;
                if (_e787 < _e768) {
                    phi_1440_ = _e787;
                } else {
                    phi_1440_ = _e768;
                }
                let _e793 = phi_1440_;
                if (_e790 < _e768) {
                    phi_1445_ = _e790;
                } else {
                    phi_1445_ = _e768;
                }
                let _e796 = phi_1445_;
                let _e797 = bitcast<u32>(_e793);
                let _e799 = (bitcast<u32>(_e780) * _e761);
                let _e800 = (bitcast<u32>(_e796) * _e761);
                let _e805 = ((_e799 + _e781) + _e766);
                let _e806 = ((_e799 + _e797) + _e766);
                let _e807 = ((_e800 + _e781) + _e766);
                let _e808 = ((_e800 + _e797) + _e766);
                if (_e805 < _e60) {
                } else {
                    return;
                }
                let _e812 = map.member[(0u + _e805)];
                if (_e806 < _e60) {
                } else {
                    return;
                }
                let _e816 = map.member[(0u + _e806)];
                if (_e807 < _e60) {
                } else {
                    return;
                }
                let _e820 = map.member[(0u + _e807)];
                if (_e808 < _e60) {
                } else {
                    return;
                }
                let _e824 = map.member[(0u + _e808)];
                let _e826 = _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e812, _e816, _e820, _e824), vec4<f32>(((1f - _e728) * (1f - _e729)), (_e728 * (1f - _e729)), ((1f - _e728) * _e729), (_e728 * _e729)), _e664);
                let _e828 = p.member.fade_uv;
                if (_e828 > 0f) {
                    let _e831 = local_4;
                    if ((_e831.level + 1u) == _e78) {
                        let _e840 = p.member.fade_uv;
                        let _e842 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e430.point.uv.x, (1f - _e430.point.uv.x));
                        let _e844 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e430.point.uv.y, (1f - _e430.point.uv.y));
                        let _e845 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e842, _e844);
                        if (_e845 < _e840) {
                            phi_1517_ = (1f - ((1f - _e826) * (_e845 / _e840)));
                        } else {
                            phi_1517_ = _e826;
                        }
                        let _e852 = phi_1517_;
                        phi_1519_ = evaluate_Verdict(_e852, false);
                        phi_1520_ = false;
                    } else {
                        phi_1519_ = evaluate_Verdict();
                        phi_1520_ = true;
                    }
                    let _e855 = phi_1519_;
                    let _e857 = phi_1520_;
                    phi_1521_ = _e855;
                    phi_1522_ = _e857;
                } else {
                    phi_1521_ = evaluate_Verdict();
                    phi_1522_ = true;
                }
                let _e859 = phi_1521_;
                let _e861 = phi_1522_;
                if _e861 {
                    phi_1527_ = evaluate_Verdict(_e826, false);
                    phi_1528_ = false;
                } else {
                    phi_1527_ = evaluate_Verdict();
                    phi_1528_ = true;
                }
                let _e864 = phi_1527_;
                let _e866 = phi_1528_;
                phi_1530_ = _e864;
                phi_1531_ = _e859;
                phi_1532_ = _e866;
            } else {
                phi_1530_ = evaluate_Verdict();
                phi_1531_ = evaluate_Verdict(1f, false);
                phi_1532_ = true;
            }
            let _e869 = phi_1530_;
            let _e871 = phi_1531_;
            let _e873 = phi_1532_;
            if _e873 {
            }
            phi_1536_ = _e871;
            phi_1537_ = _e869;
            phi_1538_ = _e873;
        }
        let _e875 = phi_1536_;
        let _e877 = phi_1537_;
        let _e879 = phi_1538_;
        if _e879 {
            phi_1542_ = _e875;
        } else {
            phi_1542_ = _e877;
        }
        let _e881 = phi_1542_;
        if (_e72.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e72.first_primitive)] = _e881.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_esm_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
