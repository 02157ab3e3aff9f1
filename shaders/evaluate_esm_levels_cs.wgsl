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
    light: vec4<f32>,
    test: vec4<f32>,
    size: vec2<u32>,
    map_size: u32,
    epsilon: f32,
    root: u32,
    level_count: u32,
    fade_uv: f32,
    pad0_: u32,
}

struct type_29 {
    member: abi_ShadowParams,
}

struct lt_math_LightPoint {
    uv: vec2<f32>,
    depth: f32,
    is_inside: bool,
}

struct type_35 {
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
var<uniform> p: type_29;
@group(0) @binding(2) 
var<storage> map: type_13;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_13;
@group(0) @binding(4) 
var<storage> levels: type_35;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_155_: lt_bvh_traverse_Tree;
    var phi_156_: bool;
    var phi_157_: lt_bvh_traverse_Tree;
    var phi_158_: bool;
    var phi_163_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_155_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_156_ = false;
        } else {
            phi_155_ = lt_bvh_traverse_Tree();
            phi_156_ = true;
        }
        let _e65 = phi_155_;
        let _e67 = phi_156_;
        phi_157_ = _e65;
        phi_158_ = _e67;
    } else {
        phi_157_ = lt_bvh_traverse_Tree();
        phi_158_ = true;
    }
    let _e69 = phi_157_;
    let _e71 = phi_158_;
    if _e71 {
        phi_163_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_163_ = _e69;
    }
    let _e76 = phi_163_;
    return lt_bvh_traverse_Tree(_e76.root, _e76.first_primitive);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_esm_Esm_clamped_exponent(param_4: ptr<function, f32>) -> f32 {
    var phi_183_: bool;
    var phi_187_: f32;

    let _e53 = (*param_4);
    if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
        phi_183_ = true;
    } else {
        let _e57 = (84f < _e53);
        if _e57 {
        }
        phi_183_ = _e57;
    }
    let _e59 = phi_183_;
    if _e59 {
        phi_187_ = 84f;
    } else {
        phi_187_ = _e53;
    }
    let _e61 = phi_187_;
    return _e61;
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_5: ptr<function, f32>, param_6: vec4<f32>, param_7: vec4<f32>, param_8: f32) -> f32 {
    var phi_208_: f32;
    var phi_209_: f32;
    var phi_210_: f32;
    var phi_226_: f32;
    var phi_227_: f32;
    var phi_228_: f32;
    var phi_244_: f32;
    var phi_245_: f32;
    var phi_246_: f32;
    var phi_262_: f32;
    var phi_263_: f32;
    var phi_264_: f32;
    var phi_280_: f32;
    var phi_281_: f32;
    var phi_282_: f32;
    var phi_301_: f32;
    var phi_306_: f32;
    var phi_328_: f32;
    var phi_333_: f32;
    var phi_334_: bool;
    var phi_335_: f32;
    var phi_336_: bool;
    var phi_340_: f32;
    var phi_378_: f32;
    var phi_389_: f32;
    var phi_394_: f32;
    var phi_416_: f32;
    var phi_421_: f32;
    var phi_422_: bool;
    var phi_423_: f32;
    var phi_424_: bool;
    var phi_428_: f32;
    var phi_466_: f32;
    var phi_477_: f32;
    var phi_482_: f32;
    var phi_504_: f32;
    var phi_509_: f32;
    var phi_510_: bool;
    var phi_511_: f32;
    var phi_512_: bool;
    var phi_516_: f32;
    var phi_554_: f32;
    var phi_565_: f32;
    var phi_570_: f32;
    var phi_592_: f32;
    var phi_597_: f32;
    var phi_598_: bool;
    var phi_599_: f32;
    var phi_600_: bool;
    var phi_604_: f32;
    var phi_642_: f32;
    var phi_668_: f32;
    var phi_669_: f32;
    var phi_670_: f32;

    let _e56 = _lt_math_esm_Esm_clamped_exponent(param_5);
    if ((bitcast<u32>(param_8) & 2147483647u) > 2139095040u) {
        phi_210_ = param_8;
    } else {
        if (param_8 < 0f) {
            phi_209_ = 0f;
        } else {
            if (param_8 > 1f) {
                phi_208_ = 1f;
            } else {
                phi_208_ = param_8;
            }
            let _e63 = phi_208_;
            phi_209_ = _e63;
        }
        let _e65 = phi_209_;
        phi_210_ = _e65;
    }
    let _e67 = phi_210_;
    if ((bitcast<u32>(param_6.x) & 2147483647u) > 2139095040u) {
        phi_228_ = param_6.x;
    } else {
        if (param_6.x < 0f) {
            phi_227_ = 0f;
        } else {
            if (param_6.x > 1f) {
                phi_226_ = 1f;
            } else {
                phi_226_ = param_6.x;
            }
            let _e75 = phi_226_;
            phi_227_ = _e75;
        }
        let _e77 = phi_227_;
        phi_228_ = _e77;
    }
    let _e79 = phi_228_;
    if ((bitcast<u32>(param_6.y) & 2147483647u) > 2139095040u) {
        phi_246_ = param_6.y;
    } else {
        if (param_6.y < 0f) {
            phi_245_ = 0f;
        } else {
            if (param_6.y > 1f) {
                phi_244_ = 1f;
            } else {
                phi_244_ = param_6.y;
            }
            let _e87 = phi_244_;
            phi_245_ = _e87;
        }
        let _e89 = phi_245_;
        phi_246_ = _e89;
    }
    let _e91 = phi_246_;
    if ((bitcast<u32>(param_6.z) & 2147483647u) > 2139095040u) {
        phi_264_ = param_6.z;
    } else {
        if (param_6.z < 0f) {
            phi_263_ = 0f;
        } else {
            if (param_6.z > 1f) {
                phi_262_ = 1f;
            } else {
                phi_262_ = param_6.z;
            }
            let _e99 = phi_262_;
            phi_263_ = _e99;
        }
        let _e101 = phi_263_;
        phi_264_ = _e101;
    }
    let _e103 = phi_264_;
    if ((bitcast<u32>(param_6.w) & 2147483647u) > 2139095040u) {
        phi_282_ = param_6.w;
    } else {
        if (param_6.w < 0f) {
            phi_281_ = 0f;
        } else {
            if (param_6.w > 1f) {
                phi_280_ = 1f;
            } else {
                phi_280_ = param_6.w;
            }
            let _e111 = phi_280_;
            phi_281_ = _e111;
        }
        let _e113 = phi_281_;
        phi_282_ = _e113;
    }
    let _e115 = phi_282_;
    let _e120 = (_e56 * (_e79 - _e67));
    let _e121 = (_e56 * (_e91 - _e67));
    let _e122 = (_e56 * (_e103 - _e67));
    let _e123 = (_e56 * (_e115 - _e67));
    if ((bitcast<u32>(_e120) & 2147483647u) > 2139095040u) {
        phi_378_ = _e120;
    } else {
        if (_e120 < -87f) {
            phi_301_ = -87f;
        } else {
            phi_301_ = _e120;
        }
        let _e129 = phi_301_;
        if (_e129 > 88f) {
            phi_306_ = 88f;
        } else {
            phi_306_ = _e129;
        }
        let _e132 = phi_306_;
        let _e134 = ((_e132 * 1.442695f) + 0.5f);
        if (_e134 > -8388608f) {
            let _e146 = f32(select(0i, select(select(i32(_e134), i32(-2147483648), (_e134 < bitcast<f32>(3472883712u))), 2147483647i, (_e134 > bitcast<f32>(1325400063u))), (_e134 == _e134)));
            if (_e146 > _e134) {
                phi_328_ = 1f;
            } else {
                phi_328_ = 0f;
            }
            let _e149 = phi_328_;
            if (_e134 < 8388608f) {
                phi_333_ = (_e146 - _e149);
                phi_334_ = false;
            } else {
                phi_333_ = f32();
                phi_334_ = true;
            }
            let _e152 = phi_333_;
            let _e154 = phi_334_;
            phi_335_ = _e152;
            phi_336_ = _e154;
        } else {
            phi_335_ = f32();
            phi_336_ = true;
        }
        let _e156 = phi_335_;
        let _e158 = phi_336_;
        if _e158 {
            phi_340_ = _e134;
        } else {
            phi_340_ = _e156;
        }
        let _e160 = phi_340_;
        let _e164 = ((_e132 - (_e160 * 0.69314575f)) - (_e160 * 0.0000014286068f));
        phi_378_ = ((((((((((((((((1f / 5040f) * _e164) + (1f / 720f)) * _e164) + (1f / 120f)) * _e164) + (1f / 24f)) * _e164) + (1f / 6f)) * _e164) + 0.5f) * _e164) + 1f) * _e164) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e160), i32(-2147483648), (_e160 < bitcast<f32>(3472883712u))), 2147483647i, (_e160 > bitcast<f32>(1325400063u))), (_e160 == _e160)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e200 = phi_378_;
    if ((bitcast<u32>(_e121) & 2147483647u) > 2139095040u) {
        phi_466_ = _e121;
    } else {
        if (_e121 < -87f) {
            phi_389_ = -87f;
        } else {
            phi_389_ = _e121;
        }
        let _e206 = phi_389_;
        if (_e206 > 88f) {
            phi_394_ = 88f;
        } else {
            phi_394_ = _e206;
        }
        let _e209 = phi_394_;
        let _e211 = ((_e209 * 1.442695f) + 0.5f);
        if (_e211 > -8388608f) {
            let _e223 = f32(select(0i, select(select(i32(_e211), i32(-2147483648), (_e211 < bitcast<f32>(3472883712u))), 2147483647i, (_e211 > bitcast<f32>(1325400063u))), (_e211 == _e211)));
            if (_e223 > _e211) {
                phi_416_ = 1f;
            } else {
                phi_416_ = 0f;
            }
            let _e226 = phi_416_;
            if (_e211 < 8388608f) {
                phi_421_ = (_e223 - _e226);
                phi_422_ = false;
            } else {
                phi_421_ = f32();
                phi_422_ = true;
            }
            let _e229 = phi_421_;
            let _e231 = phi_422_;
            phi_423_ = _e229;
            phi_424_ = _e231;
        } else {
            phi_423_ = f32();
            phi_424_ = true;
        }
        let _e233 = phi_423_;
        let _e235 = phi_424_;
        if _e235 {
            phi_428_ = _e211;
        } else {
            phi_428_ = _e233;
        }
        let _e237 = phi_428_;
        let _e241 = ((_e209 - (_e237 * 0.69314575f)) - (_e237 * 0.0000014286068f));
        phi_466_ = ((((((((((((((((1f / 5040f) * _e241) + (1f / 720f)) * _e241) + (1f / 120f)) * _e241) + (1f / 24f)) * _e241) + (1f / 6f)) * _e241) + 0.5f) * _e241) + 1f) * _e241) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e237), i32(-2147483648), (_e237 < bitcast<f32>(3472883712u))), 2147483647i, (_e237 > bitcast<f32>(1325400063u))), (_e237 == _e237)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e277 = phi_466_;
    if ((bitcast<u32>(_e122) & 2147483647u) > 2139095040u) {
        phi_554_ = _e122;
    } else {
        if (_e122 < -87f) {
            phi_477_ = -87f;
        } else {
            phi_477_ = _e122;
        }
        let _e283 = phi_477_;
        if (_e283 > 88f) {
            phi_482_ = 88f;
        } else {
            phi_482_ = _e283;
        }
        let _e286 = phi_482_;
        let _e288 = ((_e286 * 1.442695f) + 0.5f);
        if (_e288 > -8388608f) {
            let _e300 = f32(select(0i, select(select(i32(_e288), i32(-2147483648), (_e288 < bitcast<f32>(3472883712u))), 2147483647i, (_e288 > bitcast<f32>(1325400063u))), (_e288 == _e288)));
            if (_e300 > _e288) {
                phi_504_ = 1f;
            } else {
                phi_504_ = 0f;
            }
            let _e303 = phi_504_;
            if (_e288 < 8388608f) {
                phi_509_ = (_e300 - _e303);
                phi_510_ = false;
            } else {
                phi_509_ = f32();
                phi_510_ = true;
            }
            let _e306 = phi_509_;
            let _e308 = phi_510_;
            phi_511_ = _e306;
            phi_512_ = _e308;
        } else {
            phi_511_ = f32();
            phi_512_ = true;
        }
        let _e310 = phi_511_;
        let _e312 = phi_512_;
        if _e312 {
            phi_516_ = _e288;
        } else {
            phi_516_ = _e310;
        }
        let _e314 = phi_516_;
        let _e318 = ((_e286 - (_e314 * 0.69314575f)) - (_e314 * 0.0000014286068f));
        phi_554_ = ((((((((((((((((1f / 5040f) * _e318) + (1f / 720f)) * _e318) + (1f / 120f)) * _e318) + (1f / 24f)) * _e318) + (1f / 6f)) * _e318) + 0.5f) * _e318) + 1f) * _e318) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e314), i32(-2147483648), (_e314 < bitcast<f32>(3472883712u))), 2147483647i, (_e314 > bitcast<f32>(1325400063u))), (_e314 == _e314)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e354 = phi_554_;
    if ((bitcast<u32>(_e123) & 2147483647u) > 2139095040u) {
        phi_642_ = _e123;
    } else {
        if (_e123 < -87f) {
            phi_565_ = -87f;
        } else {
            phi_565_ = _e123;
        }
        let _e360 = phi_565_;
        if (_e360 > 88f) {
            phi_570_ = 88f;
        } else {
            phi_570_ = _e360;
        }
        let _e363 = phi_570_;
        let _e365 = ((_e363 * 1.442695f) + 0.5f);
        if (_e365 > -8388608f) {
            let _e377 = f32(select(0i, select(select(i32(_e365), i32(-2147483648), (_e365 < bitcast<f32>(3472883712u))), 2147483647i, (_e365 > bitcast<f32>(1325400063u))), (_e365 == _e365)));
            if (_e377 > _e365) {
                phi_592_ = 1f;
            } else {
                phi_592_ = 0f;
            }
            let _e380 = phi_592_;
            if (_e365 < 8388608f) {
                phi_597_ = (_e377 - _e380);
                phi_598_ = false;
            } else {
                phi_597_ = f32();
                phi_598_ = true;
            }
            let _e383 = phi_597_;
            let _e385 = phi_598_;
            phi_599_ = _e383;
            phi_600_ = _e385;
        } else {
            phi_599_ = f32();
            phi_600_ = true;
        }
        let _e387 = phi_599_;
        let _e389 = phi_600_;
        if _e389 {
            phi_604_ = _e365;
        } else {
            phi_604_ = _e387;
        }
        let _e391 = phi_604_;
        let _e395 = ((_e363 - (_e391 * 0.69314575f)) - (_e391 * 0.0000014286068f));
        phi_642_ = ((((((((((((((((1f / 5040f) * _e395) + (1f / 720f)) * _e395) + (1f / 120f)) * _e395) + (1f / 24f)) * _e395) + (1f / 6f)) * _e395) + 0.5f) * _e395) + 1f) * _e395) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e391), i32(-2147483648), (_e391 < bitcast<f32>(3472883712u))), 2147483647i, (_e391 > bitcast<f32>(1325400063u))), (_e391 == _e391)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e431 = phi_642_;
    let _e442 = ((((_e200 * param_7.x) + (_e277 * param_7.y)) + (_e354 * param_7.z)) + (_e431 * param_7.w));
    if ((bitcast<u32>(_e442) & 2147483647u) > 2139095040u) {
        phi_670_ = _e442;
    } else {
        if (_e442 < 0f) {
            phi_669_ = 0f;
        } else {
            if (_e442 > 1f) {
                phi_668_ = 1f;
            } else {
                phi_668_ = _e442;
            }
            let _e449 = phi_668_;
            phi_669_ = _e449;
        }
        let _e451 = phi_669_;
        phi_670_ = _e451;
    }
    let _e453 = phi_670_;
    return _e453;
}

fn lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(param_9: f32, param_10: f32) -> f32 {
    var phi_678_: f32;

    if (param_9 < param_10) {
        phi_678_ = param_9;
    } else {
        phi_678_ = param_10;
    }
    let _e56 = phi_678_;
    return _e56;
}

fn function_() {
    var local: f32;
    var phi_739_: bool;
    var phi_740_: bool;
    var phi_741_: bool;
    var phi_742_: bool;
    var phi_746_: bool;
    var phi_790_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_794_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_814_: lt_math_LightPoint;
    var phi_817_: u32;
    var phi_819_: lt_math_LevelPoint;
    var phi_905_: bool;
    var phi_914_: bool;
    var phi_923_: bool;
    var phi_924_: bool;
    var phi_925_: bool;
    var phi_926_: bool;
    var phi_927_: bool;
    var phi_928_: bool;
    var phi_929_: bool;
    var phi_933_: bool;
    var phi_960_: bool;
    var phi_961_: bool;
    var phi_962_: bool;
    var phi_963_: bool;
    var phi_964_: bool;
    var phi_965_: bool;
    var phi_966_: bool;
    var phi_967_: bool;
    var phi_971_: bool;
    var phi_980_: lt_math_LightPoint;
    var phi_981_: u32;
    var phi_982_: lt_math_LevelPoint;
    var phi_983_: bool;
    var phi_815_: lt_math_LightPoint;
    var phi_818_: u32;
    var phi_820_: lt_math_LevelPoint;
    var phi_984_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_1024_: bool;
    var phi_1025_: bool;
    var phi_1026_: bool;
    var phi_1027_: bool;
    var phi_1031_: bool;
    var phi_1113_: f32;
    var phi_1229_: f32;
    var phi_1230_: f32;
    var phi_1233_: f32;
    var phi_1262_: f32;
    var phi_1267_: f32;
    var phi_1268_: bool;
    var phi_1269_: f32;
    var phi_1270_: bool;
    var phi_1274_: f32;
    var phi_1294_: f32;
    var phi_1299_: f32;
    var phi_1300_: bool;
    var phi_1301_: f32;
    var phi_1302_: bool;
    var phi_1306_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_1355_: i32;
    var phi_1360_: i32;
    var phi_1365_: i32;
    var phi_1370_: i32;
    var phi_1379_: i32;
    var phi_1384_: i32;
    var phi_1389_: i32;
    var phi_1394_: i32;
    var local_4: lt_math_LevelPoint;
    var phi_1466_: f32;
    var phi_1468_: evaluate_Verdict;
    var phi_1469_: bool;
    var phi_1470_: evaluate_Verdict;
    var phi_1471_: bool;
    var phi_1476_: evaluate_Verdict;
    var phi_1477_: bool;
    var phi_1479_: evaluate_Verdict;
    var phi_1480_: evaluate_Verdict;
    var phi_1481_: bool;
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
    if (bitcast<i32>(_e72.root) != 0i) {
        let _e78 = p.member.level_count;
        if (_e72.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e83 = p.member.light;
        let _e86 = samples.member[(0u + _e72.first_primitive)].normal[0u];
        let _e88 = global[0u];
        if (_e86 == _e88) {
            let _e91 = samples.member[(0u + _e72.first_primitive)].normal[1u];
            let _e93 = global[1u];
            if (_e91 == _e93) {
                let _e96 = samples.member[(0u + _e72.first_primitive)].normal[2u];
                let _e98 = global[2u];
                phi_739_ = (_e96 == _e98);
                phi_740_ = false;
            } else {
                phi_739_ = bool();
                phi_740_ = true;
            }
            let _e101 = phi_739_;
            let _e103 = phi_740_;
            phi_741_ = _e101;
            phi_742_ = _e103;
        } else {
            phi_741_ = bool();
            phi_742_ = true;
        }
        let _e105 = phi_741_;
        let _e107 = phi_742_;
        if _e107 {
            phi_746_ = false;
        } else {
            phi_746_ = _e105;
        }
        let _e109 = phi_746_;
        if !(_e109) {
            let _e112 = samples.member[(0u + _e72.first_primitive)].normal;
            let _e114 = samples.member[(0u + _e72.first_primitive)].position;
            if ((((_e112.x * (_e83.x - (_e114.x * _e83.w))) + (_e112.y * (_e83.y - (_e114.y * _e83.w)))) + (_e112.z * (_e83.z - (_e114.z * _e83.w)))) > 0f) {
                let _e138 = samples.member[(0u + _e72.first_primitive)].flags;
                let _e146 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e152 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e146.unnamed.visibility, false), _e146.unnamed_1);
                phi_790_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e152.unnamed, ((_e138 & 1u) == 0u));
            } else {
                let _e161 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e167 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e161.unnamed.visibility, false), _e161.unnamed_1);
                phi_790_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e167.unnamed, true);
            }
            let _e172 = phi_790_;
            phi_794_ = _e172;
        } else {
            let _e178 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e184 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e178.unnamed.visibility, false), _e178.unnamed_1);
            phi_794_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e184.unnamed, true);
        }
        let _e189 = phi_794_;
        if _e189.unnamed_1 {
            phi_1485_ = evaluate_Verdict(_e189.unnamed.visibility, _e189.unnamed.is_doubted);
            phi_1486_ = evaluate_Verdict();
            phi_1487_ = true;
        } else {
            let _e197 = samples.member[(0u + _e72.first_primitive)].position;
            let _e199 = p.member.map_size;
            let _e201 = (0.5f / f32(_e199));
            let _e208 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e215 = lt_math_LightPoint(vec2<f32>(_e208.uv.x, 0f), _e208.depth, _e208.is_inside);
            let _e219 = lt_math_LightPoint(_e215.uv, 0f, _e215.is_inside);
            phi_814_ = lt_math_LightPoint();
            phi_817_ = 0u;
            phi_819_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e219.uv, _e219.depth, false));
            loop {
                let _e226 = phi_814_;
                let _e228 = phi_817_;
                let _e230 = phi_819_;
                local_1 = _e230;
                local_2 = _e230;
                local_3 = _e230;
                local_4 = _e230;
                if (_e228 < _e78) {
                    if _e230.point.is_inside {
                        phi_980_ = lt_math_LightPoint();
                        phi_981_ = u32();
                        phi_982_ = lt_math_LevelPoint();
                        phi_983_ = false;
                    } else {
                        if (_e228 < _e66) {
                        } else {
                            return;
                        }
                        let _e241 = levels.member[(0u + _e228)].row_w;
                        let _e252 = ((((_e241.x * _e197.x) + (_e241.y * _e197.y)) + (_e241.z * _e197.z)) + (_e241.w * 1f));
                        let _e254 = levels.member[(0u + _e228)].row_x;
                        let _e266 = (((((_e254.x * _e197.x) + (_e254.y * _e197.y)) + (_e254.z * _e197.z)) + (_e254.w * 1f)) / _e252);
                        let _e268 = levels.member[(0u + _e228)].row_y;
                        let _e280 = (((((_e268.x * _e197.x) + (_e268.y * _e197.y)) + (_e268.z * _e197.z)) + (_e268.w * 1f)) / _e252);
                        let _e282 = levels.member[(0u + _e228)].row_z;
                        let _e293 = ((((_e282.x * _e197.x) + (_e282.y * _e197.y)) + (_e282.z * _e197.z)) + (_e282.w * 1f));
                        if (_e252 > 0f) {
                            if (_e266 >= 0f) {
                                phi_905_ = (_e266 <= 1f);
                            } else {
                                phi_905_ = false;
                            }
                            let _e298 = phi_905_;
                            if _e298 {
                                if (_e280 >= 0f) {
                                    phi_914_ = (_e280 <= 1f);
                                } else {
                                    phi_914_ = false;
                                }
                                let _e302 = phi_914_;
                                if _e302 {
                                    if (_e293 >= 0f) {
                                        phi_923_ = (_e293 <= 1f);
                                    } else {
                                        phi_923_ = false;
                                    }
                                    let _e306 = phi_923_;
                                    phi_924_ = _e306;
                                    phi_925_ = false;
                                } else {
                                    phi_924_ = bool();
                                    phi_925_ = true;
                                }
                                let _e308 = phi_924_;
                                let _e310 = phi_925_;
                                phi_926_ = _e308;
                                phi_927_ = _e310;
                            } else {
                                phi_926_ = bool();
                                phi_927_ = true;
                            }
                            let _e312 = phi_926_;
                            let _e314 = phi_927_;
                            phi_928_ = _e312;
                            phi_929_ = _e314;
                        } else {
                            phi_928_ = bool();
                            phi_929_ = true;
                        }
                        let _e316 = phi_928_;
                        let _e318 = phi_929_;
                        if _e318 {
                            phi_933_ = false;
                        } else {
                            phi_933_ = _e316;
                        }
                        let _e320 = phi_933_;
                        if _e320 {
                            if (_e266 >= _e201) {
                                if (_e266 <= (1f - _e201)) {
                                    if (_e280 >= _e201) {
                                        phi_960_ = (_e280 <= (1f - _e201));
                                        phi_961_ = false;
                                    } else {
                                        phi_960_ = bool();
                                        phi_961_ = true;
                                    }
                                    let _e328 = phi_960_;
                                    let _e330 = phi_961_;
                                    phi_962_ = _e328;
                                    phi_963_ = _e330;
                                } else {
                                    phi_962_ = bool();
                                    phi_963_ = true;
                                }
                                let _e332 = phi_962_;
                                let _e334 = phi_963_;
                                phi_964_ = _e332;
                                phi_965_ = _e334;
                            } else {
                                phi_964_ = bool();
                                phi_965_ = true;
                            }
                            let _e336 = phi_964_;
                            let _e338 = phi_965_;
                            phi_966_ = _e336;
                            phi_967_ = _e338;
                        } else {
                            phi_966_ = bool();
                            phi_967_ = true;
                        }
                        let _e340 = phi_966_;
                        let _e342 = phi_967_;
                        if _e342 {
                            phi_971_ = false;
                        } else {
                            phi_971_ = _e340;
                        }
                        let _e344 = phi_971_;
                        let _e351 = lt_math_LightPoint(vec2<f32>(_e266, _e226.uv.y), _e226.depth, _e226.is_inside);
                        let _e358 = lt_math_LightPoint(vec2<f32>(_e351.uv.x, _e280), _e351.depth, _e351.is_inside);
                        let _e362 = lt_math_LightPoint(_e358.uv, _e293, _e358.is_inside);
                        let _e366 = lt_math_LightPoint(_e362.uv, _e362.depth, _e344);
                        phi_980_ = _e366;
                        phi_981_ = (_e228 + 1u);
                        phi_982_ = lt_math_LevelPoint(_e228, _e366);
                        phi_983_ = true;
                    }
                    let _e370 = phi_980_;
                    let _e372 = phi_981_;
                    let _e374 = phi_982_;
                    let _e376 = phi_983_;
                    phi_815_ = _e370;
                    phi_818_ = _e372;
                    phi_820_ = _e374;
                    phi_984_ = _e376;
                } else {
                    phi_815_ = lt_math_LightPoint();
                    phi_818_ = u32();
                    phi_820_ = lt_math_LevelPoint();
                    phi_984_ = false;
                }
                let _e378 = phi_815_;
                let _e380 = phi_818_;
                let _e382 = phi_820_;
                let _e384 = phi_984_;
                continue;
                continuing {
                    phi_814_ = _e378;
                    phi_817_ = _e380;
                    phi_819_ = _e382;
                    break if !(_e384);
                }
            }
            let _e387 = local_1;
            if _e387.point.is_inside {
                if (0f > 0f) {
                    let _e393 = local_2;
                    if (_e393.level < _e66) {
                    } else {
                        return;
                    }
                    let _e398 = levels.member[(0u + _e393.level)];
                    let _e404 = global[0u];
                    if (_e398.row_w.x == _e404) {
                        let _e407 = global[1u];
                        if (_e398.row_w.y == _e407) {
                            let _e410 = global[2u];
                            phi_1024_ = (_e398.row_w.z == _e410);
                            phi_1025_ = false;
                        } else {
                            phi_1024_ = bool();
                            phi_1025_ = true;
                        }
                        let _e413 = phi_1024_;
                        let _e415 = phi_1025_;
                        phi_1026_ = _e413;
                        phi_1027_ = _e415;
                    } else {
                        phi_1026_ = bool();
                        phi_1027_ = true;
                    }
                    let _e417 = phi_1026_;
                    let _e419 = phi_1027_;
                    if _e419 {
                        phi_1031_ = false;
                    } else {
                        phi_1031_ = _e417;
                    }
                    let _e421 = phi_1031_;
                    if _e421 {
                        let _e423 = samples.member[(0u + _e72.first_primitive)].normal;
                        let _e425 = p.member.map_size;
                        let _e495 = ((abs(((((_e398.row_x.x * _e423.x) + (_e398.row_x.y * _e423.y)) + (_e398.row_x.z * _e423.z)) / (((_e398.row_x.x * _e398.row_x.x) + (_e398.row_x.y * _e398.row_x.y)) + (_e398.row_x.z * _e398.row_x.z)))) + abs(((((_e398.row_y.x * _e423.x) + (_e398.row_y.y * _e423.y)) + (_e398.row_y.z * _e423.z)) / (((_e398.row_y.x * _e398.row_y.x) + (_e398.row_y.y * _e398.row_y.y)) + (_e398.row_y.z * _e398.row_y.z))))) / (abs(((((_e398.row_z.x * _e423.x) + (_e398.row_z.y * _e423.y)) + (_e398.row_z.z * _e423.z)) / (((_e398.row_z.x * _e398.row_z.x) + (_e398.row_z.y * _e398.row_z.y)) + (_e398.row_z.z * _e398.row_z.z)))) * f32(_e425)));
                        if (_e495 < 0.002f) {
                            phi_1113_ = _e495;
                        } else {
                            phi_1113_ = 0.002f;
                        }
                        let _e498 = phi_1113_;
                        phi_1230_ = _e498;
                    } else {
                        let _e500 = p.member.map_size;
                        let _e506 = samples.member[(0u + _e72.first_primitive)].position;
                        let _e517 = ((((_e398.row_w.x * _e506.x) + (_e398.row_w.y * _e506.y)) + (_e398.row_w.z * _e506.z)) + _e398.row_w.w);
                        let _e530 = ((_e398.row_x.x - (_e398.row_w.x * _e387.point.uv.x)) / _e517);
                        let _e531 = ((_e398.row_x.y - (_e398.row_w.y * _e387.point.uv.x)) / _e517);
                        let _e532 = ((_e398.row_x.z - (_e398.row_w.z * _e387.point.uv.x)) / _e517);
                        let _e545 = ((_e398.row_y.x - (_e398.row_w.x * _e387.point.uv.y)) / _e517);
                        let _e546 = ((_e398.row_y.y - (_e398.row_w.y * _e387.point.uv.y)) / _e517);
                        let _e547 = ((_e398.row_y.z - (_e398.row_w.z * _e387.point.uv.y)) / _e517);
                        let _e553 = samples.member[(0u + _e72.first_primitive)].normal;
                        let _e558 = ((_e546 * _e553.z) - (_e553.y * _e547));
                        let _e563 = ((_e547 * _e553.x) - (_e553.z * _e545));
                        let _e568 = ((_e545 * _e553.y) - (_e553.x * _e546));
                        let _e570 = samples.member[(0u + _e72.first_primitive)].normal;
                        let _e575 = ((_e531 * _e570.z) - (_e570.y * _e532));
                        let _e580 = ((_e532 * _e570.x) - (_e570.z * _e530));
                        let _e585 = ((_e530 * _e570.y) - (_e570.x * _e531));
                        let _e612 = ((abs(((((_e398.row_z.x * _e558) + (_e398.row_z.y * _e563)) + (_e398.row_z.z * _e568)) / (((_e530 * _e558) + (_e531 * _e563)) + (_e532 * _e568)))) + abs(((((_e398.row_z.x * _e575) + (_e398.row_z.y * _e580)) + (_e398.row_z.z * _e585)) / (((_e545 * _e575) + (_e546 * _e580)) + (_e547 * _e585))))) / f32(_e500));
                        if (_e612 < 0.002f) {
                            phi_1229_ = _e612;
                        } else {
                            phi_1229_ = 0.002f;
                        }
                        let _e615 = phi_1229_;
                        phi_1230_ = _e615;
                    }
                    let _e617 = phi_1230_;
                    phi_1233_ = (_e387.point.depth - (0f * _e617));
                } else {
                    phi_1233_ = _e387.point.depth;
                }
                let _e621 = phi_1233_;
                let _e627 = p.member.map_size;
                let _e628 = f32(_e627);
                let _e631 = ((_e387.point.uv.x * _e628) - 0.5f);
                let _e632 = ((_e387.point.uv.y * _e628) - 0.5f);
                if (_e631 > -8388608f) {
                    let _e644 = f32(select(0i, select(select(i32(_e631), i32(-2147483648), (_e631 < bitcast<f32>(3472883712u))), 2147483647i, (_e631 > bitcast<f32>(1325400063u))), (_e631 == _e631)));
                    if (_e644 > _e631) {
                        phi_1262_ = 1f;
                    } else {
                        phi_1262_ = 0f;
                    }
                    let _e647 = phi_1262_;
                    if (_e631 < 8388608f) {
                        phi_1267_ = (_e644 - _e647);
                        phi_1268_ = false;
                    } else {
                        phi_1267_ = f32();
                        phi_1268_ = true;
                    }
                    let _e650 = phi_1267_;
                    let _e652 = phi_1268_;
                    phi_1269_ = _e650;
                    phi_1270_ = _e652;
                } else {
                    phi_1269_ = f32();
                    phi_1270_ = true;
                }
                let _e654 = phi_1269_;
                let _e656 = phi_1270_;
                if _e656 {
                    phi_1274_ = _e631;
                } else {
                    phi_1274_ = _e654;
                }
                let _e658 = phi_1274_;
                if (_e632 > -8388608f) {
                    let _e670 = f32(select(0i, select(select(i32(_e632), i32(-2147483648), (_e632 < bitcast<f32>(3472883712u))), 2147483647i, (_e632 > bitcast<f32>(1325400063u))), (_e632 == _e632)));
                    if (_e670 > _e632) {
                        phi_1294_ = 1f;
                    } else {
                        phi_1294_ = 0f;
                    }
                    let _e673 = phi_1294_;
                    if (_e632 < 8388608f) {
                        phi_1299_ = (_e670 - _e673);
                        phi_1300_ = false;
                    } else {
                        phi_1299_ = f32();
                        phi_1300_ = true;
                    }
                    let _e676 = phi_1299_;
                    let _e678 = phi_1300_;
                    phi_1301_ = _e676;
                    phi_1302_ = _e678;
                } else {
                    phi_1301_ = f32();
                    phi_1302_ = true;
                }
                let _e680 = phi_1301_;
                let _e682 = phi_1302_;
                if _e682 {
                    phi_1306_ = _e632;
                } else {
                    phi_1306_ = _e680;
                }
                let _e684 = phi_1306_;
                let _e685 = (_e631 - _e658);
                let _e686 = (_e632 - _e684);
                let _e695 = select(0i, select(select(i32(_e658), i32(-2147483648), (_e658 < bitcast<f32>(3472883712u))), 2147483647i, (_e658 > bitcast<f32>(1325400063u))), (_e658 == _e658));
                let _e704 = select(0i, select(select(i32(_e684), i32(-2147483648), (_e684 < bitcast<f32>(3472883712u))), 2147483647i, (_e684 > bitcast<f32>(1325400063u))), (_e684 == _e684));
                let _e715 = p.member.test;
                let _e716 = _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e715);
                let _e718 = p.member.map_size;
                let _e720 = local_3;
                local = _e716;
                let _e723 = ((_e720.level * _e718) * _e718);
                let _e725 = (bitcast<i32>(_e718) - 1i);
                if (_e695 > 0i) {
                    phi_1355_ = _e695;
                } else {
                    phi_1355_ = 0i;
                }
                let _e728 = phi_1355_;
                if (_e704 > 0i) {
                    phi_1360_ = _e704;
                } else {
                    phi_1360_ = 0i;
                }
                let _e731 = phi_1360_;
                if (_e728 < _e725) {
                    phi_1365_ = _e728;
                } else {
                    phi_1365_ = _e725;
                }
                let _e734 = phi_1365_;
                if (_e731 < _e725) {
                    phi_1370_ = _e731;
                } else {
                    phi_1370_ = _e725;
                }
                let _e737 = phi_1370_;
                let _e738 = bitcast<u32>(_e734);
                let _e740 = (_e695 + 1i);
                let _e741 = (_e704 + 1i);
                if (_e740 > 0i) {
                    phi_1379_ = _e740;
                } else {
                    phi_1379_ = 0i;
                }
                let _e744 = phi_1379_;
                if (_e741 > 0i) {
                    phi_1384_ = _e741;
                } else {
                    phi_1384_ = 0i;
                }
                let _e747 = phi_1384_;
                if (_e744 < _e725) {
                    phi_1389_ = _e744;
                } else {
                    phi_1389_ = _e725;
                }
                let _e750 = phi_1389_;
                if (_e747 < _e725) {
                    phi_1394_ = _e747;
                } else {
                    phi_1394_ = _e725;
                }
                let _e753 = phi_1394_;
                let _e754 = bitcast<u32>(_e750);
                let _e756 = (bitcast<u32>(_e737) * _e718);
                let _e757 = (bitcast<u32>(_e753) * _e718);
                let _e762 = ((_e756 + _e738) + _e723);
                let _e763 = ((_e756 + _e754) + _e723);
                let _e764 = ((_e757 + _e738) + _e723);
                let _e765 = ((_e757 + _e754) + _e723);
                if (_e762 < _e60) {
                } else {
                    return;
                }
                let _e769 = map.member[(0u + _e762)];
                if (_e763 < _e60) {
                } else {
                    return;
                }
                let _e773 = map.member[(0u + _e763)];
                if (_e764 < _e60) {
                } else {
                    return;
                }
                let _e777 = map.member[(0u + _e764)];
                if (_e765 < _e60) {
                } else {
                    return;
                }
                let _e781 = map.member[(0u + _e765)];
                let _e783 = _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e769, _e773, _e777, _e781), vec4<f32>(((1f - _e685) * (1f - _e686)), (_e685 * (1f - _e686)), ((1f - _e685) * _e686), (_e685 * _e686)), _e621);
                let _e785 = p.member.fade_uv;
                if (_e785 > 0f) {
                    let _e788 = local_4;
                    if ((_e788.level + 1u) == _e78) {
                        let _e797 = p.member.fade_uv;
                        let _e799 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e387.point.uv.x, (1f - _e387.point.uv.x));
                        let _e801 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e387.point.uv.y, (1f - _e387.point.uv.y));
                        let _e802 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e799, _e801);
                        if (_e802 < _e797) {
                            phi_1466_ = (1f - ((1f - _e783) * (_e802 / _e797)));
                        } else {
                            phi_1466_ = _e783;
                        }
                        let _e809 = phi_1466_;
                        phi_1468_ = evaluate_Verdict(_e809, false);
                        phi_1469_ = false;
                    } else {
                        phi_1468_ = evaluate_Verdict();
                        phi_1469_ = true;
                    }
                    let _e812 = phi_1468_;
                    let _e814 = phi_1469_;
                    phi_1470_ = _e812;
                    phi_1471_ = _e814;
                } else {
                    phi_1470_ = evaluate_Verdict();
                    phi_1471_ = true;
                }
                let _e816 = phi_1470_;
                let _e818 = phi_1471_;
                if _e818 {
                    phi_1476_ = evaluate_Verdict(_e783, false);
                    phi_1477_ = false;
                } else {
                    phi_1476_ = evaluate_Verdict();
                    phi_1477_ = true;
                }
                let _e821 = phi_1476_;
                let _e823 = phi_1477_;
                phi_1479_ = _e821;
                phi_1480_ = _e816;
                phi_1481_ = _e823;
            } else {
                phi_1479_ = evaluate_Verdict();
                phi_1480_ = evaluate_Verdict(1f, false);
                phi_1481_ = true;
            }
            let _e826 = phi_1479_;
            let _e828 = phi_1480_;
            let _e830 = phi_1481_;
            if _e830 {
            }
            phi_1485_ = _e828;
            phi_1486_ = _e826;
            phi_1487_ = _e830;
        }
        let _e832 = phi_1485_;
        let _e834 = phi_1486_;
        let _e836 = phi_1487_;
        if _e836 {
            phi_1491_ = _e832;
        } else {
            phi_1491_ = _e834;
        }
        let _e838 = phi_1491_;
        if (_e72.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e72.first_primitive)] = _e838.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_esm_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
