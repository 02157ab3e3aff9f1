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

struct type_39 {
    member: abi_ShadowParams,
}

struct lt_math_LightPoint {
    uv: vec2<f32>,
    depth: f32,
    is_inside: bool,
}

struct type_45 {
    member: array<lt_math_LightProjection>,
}

struct lt_math_LevelPoint {
    level: u32,
    point: lt_math_LightPoint,
}

struct type_51 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
var<private> local_5: u32;
@group(0) @binding(1) 
var<storage> samples: type_10;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(0) 
var<uniform> p: type_39;
@group(0) @binding(2) 
var<storage> map: type_18;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_18;
@group(0) @binding(4) 
var<storage, read_write> list: type_51;
@group(0) @binding(5) 
var<storage> levels: type_45;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_mask_LightPlace {
    var phi_174_: lt_mask_LightPlace;
    var phi_175_: bool;
    var phi_176_: lt_mask_LightPlace;
    var phi_177_: bool;
    var phi_182_: lt_mask_LightPlace;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_174_ = lt_mask_LightPlace(1u, ((param.y * param_1) + param.x));
            phi_175_ = false;
        } else {
            phi_174_ = lt_mask_LightPlace();
            phi_175_ = true;
        }
        let _e69 = phi_174_;
        let _e71 = phi_175_;
        phi_176_ = _e69;
        phi_177_ = _e71;
    } else {
        phi_176_ = lt_mask_LightPlace();
        phi_177_ = true;
    }
    let _e73 = phi_176_;
    let _e75 = phi_177_;
    if _e75 {
        phi_182_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_182_ = _e73;
    }
    let _e80 = phi_182_;
    return lt_mask_LightPlace(_e80.word, _e80.shift);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_esm_Esm_clamped_exponent(param_4: ptr<function, f32>) -> f32 {
    var phi_202_: bool;
    var phi_206_: f32;

    let _e57 = (*param_4);
    if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
        phi_202_ = true;
    } else {
        let _e61 = (84f < _e57);
        if _e61 {
        }
        phi_202_ = _e61;
    }
    let _e63 = phi_202_;
    if _e63 {
        phi_206_ = 84f;
    } else {
        phi_206_ = _e57;
    }
    let _e65 = phi_206_;
    return _e65;
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_5: ptr<function, f32>, param_6: vec4<f32>, param_7: vec4<f32>, param_8: f32) -> f32 {
    var phi_227_: f32;
    var phi_228_: f32;
    var phi_229_: f32;
    var phi_245_: f32;
    var phi_246_: f32;
    var phi_247_: f32;
    var phi_263_: f32;
    var phi_264_: f32;
    var phi_265_: f32;
    var phi_281_: f32;
    var phi_282_: f32;
    var phi_283_: f32;
    var phi_299_: f32;
    var phi_300_: f32;
    var phi_301_: f32;
    var phi_320_: f32;
    var phi_325_: f32;
    var phi_347_: f32;
    var phi_352_: f32;
    var phi_353_: bool;
    var phi_354_: f32;
    var phi_355_: bool;
    var phi_359_: f32;
    var phi_397_: f32;
    var phi_408_: f32;
    var phi_413_: f32;
    var phi_435_: f32;
    var phi_440_: f32;
    var phi_441_: bool;
    var phi_442_: f32;
    var phi_443_: bool;
    var phi_447_: f32;
    var phi_485_: f32;
    var phi_496_: f32;
    var phi_501_: f32;
    var phi_523_: f32;
    var phi_528_: f32;
    var phi_529_: bool;
    var phi_530_: f32;
    var phi_531_: bool;
    var phi_535_: f32;
    var phi_573_: f32;
    var phi_584_: f32;
    var phi_589_: f32;
    var phi_611_: f32;
    var phi_616_: f32;
    var phi_617_: bool;
    var phi_618_: f32;
    var phi_619_: bool;
    var phi_623_: f32;
    var phi_661_: f32;
    var phi_687_: f32;
    var phi_688_: f32;
    var phi_689_: f32;

    let _e60 = _lt_math_esm_Esm_clamped_exponent(param_5);
    if ((bitcast<u32>(param_8) & 2147483647u) > 2139095040u) {
        phi_229_ = param_8;
    } else {
        if (param_8 < 0f) {
            phi_228_ = 0f;
        } else {
            if (param_8 > 1f) {
                phi_227_ = 1f;
            } else {
                phi_227_ = param_8;
            }
            let _e67 = phi_227_;
            phi_228_ = _e67;
        }
        let _e69 = phi_228_;
        phi_229_ = _e69;
    }
    let _e71 = phi_229_;
    if ((bitcast<u32>(param_6.x) & 2147483647u) > 2139095040u) {
        phi_247_ = param_6.x;
    } else {
        if (param_6.x < 0f) {
            phi_246_ = 0f;
        } else {
            if (param_6.x > 1f) {
                phi_245_ = 1f;
            } else {
                phi_245_ = param_6.x;
            }
            let _e79 = phi_245_;
            phi_246_ = _e79;
        }
        let _e81 = phi_246_;
        phi_247_ = _e81;
    }
    let _e83 = phi_247_;
    if ((bitcast<u32>(param_6.y) & 2147483647u) > 2139095040u) {
        phi_265_ = param_6.y;
    } else {
        if (param_6.y < 0f) {
            phi_264_ = 0f;
        } else {
            if (param_6.y > 1f) {
                phi_263_ = 1f;
            } else {
                phi_263_ = param_6.y;
            }
            let _e91 = phi_263_;
            phi_264_ = _e91;
        }
        let _e93 = phi_264_;
        phi_265_ = _e93;
    }
    let _e95 = phi_265_;
    if ((bitcast<u32>(param_6.z) & 2147483647u) > 2139095040u) {
        phi_283_ = param_6.z;
    } else {
        if (param_6.z < 0f) {
            phi_282_ = 0f;
        } else {
            if (param_6.z > 1f) {
                phi_281_ = 1f;
            } else {
                phi_281_ = param_6.z;
            }
            let _e103 = phi_281_;
            phi_282_ = _e103;
        }
        let _e105 = phi_282_;
        phi_283_ = _e105;
    }
    let _e107 = phi_283_;
    if ((bitcast<u32>(param_6.w) & 2147483647u) > 2139095040u) {
        phi_301_ = param_6.w;
    } else {
        if (param_6.w < 0f) {
            phi_300_ = 0f;
        } else {
            if (param_6.w > 1f) {
                phi_299_ = 1f;
            } else {
                phi_299_ = param_6.w;
            }
            let _e115 = phi_299_;
            phi_300_ = _e115;
        }
        let _e117 = phi_300_;
        phi_301_ = _e117;
    }
    let _e119 = phi_301_;
    let _e124 = (_e60 * (_e83 - _e71));
    let _e125 = (_e60 * (_e95 - _e71));
    let _e126 = (_e60 * (_e107 - _e71));
    let _e127 = (_e60 * (_e119 - _e71));
    if ((bitcast<u32>(_e124) & 2147483647u) > 2139095040u) {
        phi_397_ = _e124;
    } else {
        if (_e124 < -87f) {
            phi_320_ = -87f;
        } else {
            phi_320_ = _e124;
        }
        let _e133 = phi_320_;
        if (_e133 > 88f) {
            phi_325_ = 88f;
        } else {
            phi_325_ = _e133;
        }
        let _e136 = phi_325_;
        let _e138 = ((_e136 * 1.442695f) + 0.5f);
        if (_e138 > -8388608f) {
            let _e150 = f32(select(0i, select(select(i32(_e138), i32(-2147483648), (_e138 < bitcast<f32>(3472883712u))), 2147483647i, (_e138 > bitcast<f32>(1325400063u))), (_e138 == _e138)));
            if (_e150 > _e138) {
                phi_347_ = 1f;
            } else {
                phi_347_ = 0f;
            }
            let _e153 = phi_347_;
            if (_e138 < 8388608f) {
                phi_352_ = (_e150 - _e153);
                phi_353_ = false;
            } else {
                phi_352_ = f32();
                phi_353_ = true;
            }
            let _e156 = phi_352_;
            let _e158 = phi_353_;
            phi_354_ = _e156;
            phi_355_ = _e158;
        } else {
            phi_354_ = f32();
            phi_355_ = true;
        }
        let _e160 = phi_354_;
        let _e162 = phi_355_;
        if _e162 {
            phi_359_ = _e138;
        } else {
            phi_359_ = _e160;
        }
        let _e164 = phi_359_;
        let _e168 = ((_e136 - (_e164 * 0.69314575f)) - (_e164 * 0.0000014286068f));
        phi_397_ = ((((((((((((((((1f / 5040f) * _e168) + (1f / 720f)) * _e168) + (1f / 120f)) * _e168) + (1f / 24f)) * _e168) + (1f / 6f)) * _e168) + 0.5f) * _e168) + 1f) * _e168) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e164), i32(-2147483648), (_e164 < bitcast<f32>(3472883712u))), 2147483647i, (_e164 > bitcast<f32>(1325400063u))), (_e164 == _e164)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e204 = phi_397_;
    if ((bitcast<u32>(_e125) & 2147483647u) > 2139095040u) {
        phi_485_ = _e125;
    } else {
        if (_e125 < -87f) {
            phi_408_ = -87f;
        } else {
            phi_408_ = _e125;
        }
        let _e210 = phi_408_;
        if (_e210 > 88f) {
            phi_413_ = 88f;
        } else {
            phi_413_ = _e210;
        }
        let _e213 = phi_413_;
        let _e215 = ((_e213 * 1.442695f) + 0.5f);
        if (_e215 > -8388608f) {
            let _e227 = f32(select(0i, select(select(i32(_e215), i32(-2147483648), (_e215 < bitcast<f32>(3472883712u))), 2147483647i, (_e215 > bitcast<f32>(1325400063u))), (_e215 == _e215)));
            if (_e227 > _e215) {
                phi_435_ = 1f;
            } else {
                phi_435_ = 0f;
            }
            let _e230 = phi_435_;
            if (_e215 < 8388608f) {
                phi_440_ = (_e227 - _e230);
                phi_441_ = false;
            } else {
                phi_440_ = f32();
                phi_441_ = true;
            }
            let _e233 = phi_440_;
            let _e235 = phi_441_;
            phi_442_ = _e233;
            phi_443_ = _e235;
        } else {
            phi_442_ = f32();
            phi_443_ = true;
        }
        let _e237 = phi_442_;
        let _e239 = phi_443_;
        if _e239 {
            phi_447_ = _e215;
        } else {
            phi_447_ = _e237;
        }
        let _e241 = phi_447_;
        let _e245 = ((_e213 - (_e241 * 0.69314575f)) - (_e241 * 0.0000014286068f));
        phi_485_ = ((((((((((((((((1f / 5040f) * _e245) + (1f / 720f)) * _e245) + (1f / 120f)) * _e245) + (1f / 24f)) * _e245) + (1f / 6f)) * _e245) + 0.5f) * _e245) + 1f) * _e245) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e241), i32(-2147483648), (_e241 < bitcast<f32>(3472883712u))), 2147483647i, (_e241 > bitcast<f32>(1325400063u))), (_e241 == _e241)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e281 = phi_485_;
    if ((bitcast<u32>(_e126) & 2147483647u) > 2139095040u) {
        phi_573_ = _e126;
    } else {
        if (_e126 < -87f) {
            phi_496_ = -87f;
        } else {
            phi_496_ = _e126;
        }
        let _e287 = phi_496_;
        if (_e287 > 88f) {
            phi_501_ = 88f;
        } else {
            phi_501_ = _e287;
        }
        let _e290 = phi_501_;
        let _e292 = ((_e290 * 1.442695f) + 0.5f);
        if (_e292 > -8388608f) {
            let _e304 = f32(select(0i, select(select(i32(_e292), i32(-2147483648), (_e292 < bitcast<f32>(3472883712u))), 2147483647i, (_e292 > bitcast<f32>(1325400063u))), (_e292 == _e292)));
            if (_e304 > _e292) {
                phi_523_ = 1f;
            } else {
                phi_523_ = 0f;
            }
            let _e307 = phi_523_;
            if (_e292 < 8388608f) {
                phi_528_ = (_e304 - _e307);
                phi_529_ = false;
            } else {
                phi_528_ = f32();
                phi_529_ = true;
            }
            let _e310 = phi_528_;
            let _e312 = phi_529_;
            phi_530_ = _e310;
            phi_531_ = _e312;
        } else {
            phi_530_ = f32();
            phi_531_ = true;
        }
        let _e314 = phi_530_;
        let _e316 = phi_531_;
        if _e316 {
            phi_535_ = _e292;
        } else {
            phi_535_ = _e314;
        }
        let _e318 = phi_535_;
        let _e322 = ((_e290 - (_e318 * 0.69314575f)) - (_e318 * 0.0000014286068f));
        phi_573_ = ((((((((((((((((1f / 5040f) * _e322) + (1f / 720f)) * _e322) + (1f / 120f)) * _e322) + (1f / 24f)) * _e322) + (1f / 6f)) * _e322) + 0.5f) * _e322) + 1f) * _e322) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e318), i32(-2147483648), (_e318 < bitcast<f32>(3472883712u))), 2147483647i, (_e318 > bitcast<f32>(1325400063u))), (_e318 == _e318)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e358 = phi_573_;
    if ((bitcast<u32>(_e127) & 2147483647u) > 2139095040u) {
        phi_661_ = _e127;
    } else {
        if (_e127 < -87f) {
            phi_584_ = -87f;
        } else {
            phi_584_ = _e127;
        }
        let _e364 = phi_584_;
        if (_e364 > 88f) {
            phi_589_ = 88f;
        } else {
            phi_589_ = _e364;
        }
        let _e367 = phi_589_;
        let _e369 = ((_e367 * 1.442695f) + 0.5f);
        if (_e369 > -8388608f) {
            let _e381 = f32(select(0i, select(select(i32(_e369), i32(-2147483648), (_e369 < bitcast<f32>(3472883712u))), 2147483647i, (_e369 > bitcast<f32>(1325400063u))), (_e369 == _e369)));
            if (_e381 > _e369) {
                phi_611_ = 1f;
            } else {
                phi_611_ = 0f;
            }
            let _e384 = phi_611_;
            if (_e369 < 8388608f) {
                phi_616_ = (_e381 - _e384);
                phi_617_ = false;
            } else {
                phi_616_ = f32();
                phi_617_ = true;
            }
            let _e387 = phi_616_;
            let _e389 = phi_617_;
            phi_618_ = _e387;
            phi_619_ = _e389;
        } else {
            phi_618_ = f32();
            phi_619_ = true;
        }
        let _e391 = phi_618_;
        let _e393 = phi_619_;
        if _e393 {
            phi_623_ = _e369;
        } else {
            phi_623_ = _e391;
        }
        let _e395 = phi_623_;
        let _e399 = ((_e367 - (_e395 * 0.69314575f)) - (_e395 * 0.0000014286068f));
        phi_661_ = ((((((((((((((((1f / 5040f) * _e399) + (1f / 720f)) * _e399) + (1f / 120f)) * _e399) + (1f / 24f)) * _e399) + (1f / 6f)) * _e399) + 0.5f) * _e399) + 1f) * _e399) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e395), i32(-2147483648), (_e395 < bitcast<f32>(3472883712u))), 2147483647i, (_e395 > bitcast<f32>(1325400063u))), (_e395 == _e395)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e435 = phi_661_;
    let _e446 = ((((_e204 * param_7.x) + (_e281 * param_7.y)) + (_e358 * param_7.z)) + (_e435 * param_7.w));
    if ((bitcast<u32>(_e446) & 2147483647u) > 2139095040u) {
        phi_689_ = _e446;
    } else {
        if (_e446 < 0f) {
            phi_688_ = 0f;
        } else {
            if (_e446 > 1f) {
                phi_687_ = 1f;
            } else {
                phi_687_ = _e446;
            }
            let _e453 = phi_687_;
            phi_688_ = _e453;
        }
        let _e455 = phi_688_;
        phi_689_ = _e455;
    }
    let _e457 = phi_689_;
    return _e457;
}

fn function_() {
    var local_1: f32;
    var phi_744_: bool;
    var phi_745_: bool;
    var phi_746_: bool;
    var phi_747_: bool;
    var phi_751_: bool;
    var phi_821_: bool;
    var phi_822_: bool;
    var phi_833_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_834_: bool;
    var phi_835_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_836_: bool;
    var phi_843_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_847_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_867_: lt_math_LightPoint;
    var phi_870_: u32;
    var phi_872_: lt_math_LevelPoint;
    var phi_958_: bool;
    var phi_967_: bool;
    var phi_976_: bool;
    var phi_977_: bool;
    var phi_978_: bool;
    var phi_979_: bool;
    var phi_980_: bool;
    var phi_981_: bool;
    var phi_982_: bool;
    var phi_986_: bool;
    var phi_1013_: bool;
    var phi_1014_: bool;
    var phi_1015_: bool;
    var phi_1016_: bool;
    var phi_1017_: bool;
    var phi_1018_: bool;
    var phi_1019_: bool;
    var phi_1020_: bool;
    var phi_1024_: bool;
    var phi_1033_: lt_math_LightPoint;
    var phi_1034_: u32;
    var phi_1035_: lt_math_LevelPoint;
    var phi_1036_: bool;
    var phi_868_: lt_math_LightPoint;
    var phi_871_: u32;
    var phi_873_: lt_math_LevelPoint;
    var phi_1037_: bool;
    var local_2: lt_math_LevelPoint;
    var local_3: lt_math_LevelPoint;
    var phi_1077_: bool;
    var phi_1078_: bool;
    var phi_1079_: bool;
    var phi_1080_: bool;
    var phi_1084_: bool;
    var phi_1166_: f32;
    var phi_1284_: f32;
    var phi_1285_: f32;
    var phi_1288_: f32;
    var phi_1317_: f32;
    var phi_1322_: f32;
    var phi_1323_: bool;
    var phi_1324_: f32;
    var phi_1325_: bool;
    var phi_1329_: f32;
    var phi_1349_: f32;
    var phi_1354_: f32;
    var phi_1355_: bool;
    var phi_1356_: f32;
    var phi_1357_: bool;
    var phi_1361_: f32;
    var local_4: lt_math_LevelPoint;
    var phi_1410_: i32;
    var phi_1415_: i32;
    var phi_1420_: i32;
    var phi_1425_: i32;
    var phi_1434_: i32;
    var phi_1439_: i32;
    var phi_1444_: i32;
    var phi_1449_: i32;
    var phi_1500_: bool;
    var phi_1508_: bool;
    var phi_1520_: bool;
    var phi_1521_: bool;
    var phi_1525_: f32;
    var phi_1531_: f32;
    var phi_1533_: evaluate_Verdict;
    var phi_1538_: evaluate_Verdict;
    var phi_1539_: evaluate_Verdict;
    var phi_1543_: bool;
    var phi_1544_: u32;
    var phi_1555_: u32;

    let _e57 = id_1;
    let _e58 = local_5;
    let _e63 = arrayLength((&map.member));
    let _e68 = arrayLength((&levels.member));
    let _e71 = p.member.size[0u];
    let _e73 = p.member.size[1u];
    let _e74 = lt_shaders_entry_pixel_index(_e57, _e71, _e73);
    if (bitcast<i32>(_e74.word) != 0i) {
        let _e81 = p.member.level_count;
        let _e85 = samples.member[_e74.shift].normal[0u];
        let _e87 = global[0u];
        if (_e85 == _e87) {
            let _e90 = samples.member[_e74.shift].normal[1u];
            let _e92 = global[1u];
            if (_e90 == _e92) {
                let _e95 = samples.member[_e74.shift].normal[2u];
                let _e97 = global[2u];
                phi_744_ = (_e95 == _e97);
                phi_745_ = false;
            } else {
                phi_744_ = bool();
                phi_745_ = true;
            }
            let _e100 = phi_744_;
            let _e102 = phi_745_;
            phi_746_ = _e100;
            phi_747_ = _e102;
        } else {
            phi_746_ = bool();
            phi_747_ = true;
        }
        let _e104 = phi_746_;
        let _e106 = phi_747_;
        if _e106 {
            phi_751_ = false;
        } else {
            phi_751_ = _e104;
        }
        let _e108 = phi_751_;
        if !(_e108) {
            let _e111 = samples.member[_e74.shift].position;
            let _e113 = p.member.light.place;
            let _e119 = p.member.light.place[3u];
            let _e126 = (_e113.x - (_e111.x * _e119));
            let _e127 = (_e113.y - (_e111.y * _e119));
            let _e128 = (_e113.z - (_e111.z * _e119));
            let _e130 = samples.member[_e74.shift].normal;
            if ((((_e130.x * _e126) + (_e130.y * _e127)) + (_e130.z * _e128)) > 0f) {
                let _e144 = (((_e126 * _e126) + (_e127 * _e127)) + (_e128 * _e128));
                let _e146 = p.member.light.axis;
                let _e158 = p.member.light.place[3u];
                if (_e158 == 0f) {
                    phi_822_ = true;
                } else {
                    let _e161 = p.member.light.range_squared;
                    if (_e144 <= _e161) {
                        let _e164 = p.member.light.cos_outer;
                        phi_821_ = (-((((_e126 * _e146.x) + (_e127 * _e146.y)) + (_e128 * _e146.z))) >= (_e164 * sqrt(_e144)));
                    } else {
                        phi_821_ = false;
                    }
                    let _e169 = phi_821_;
                    phi_822_ = _e169;
                }
                let _e171 = phi_822_;
                if _e171 {
                    let _e173 = samples.member[_e74.shift].flags;
                    let _e181 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e187 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e181.unnamed.visibility, false), _e181.unnamed_1);
                    phi_833_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e187.unnamed, ((_e173 & 1u) == 0u));
                    phi_834_ = false;
                } else {
                    phi_833_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_834_ = true;
                }
                let _e192 = phi_833_;
                let _e194 = phi_834_;
                phi_835_ = _e192;
                phi_836_ = _e194;
            } else {
                phi_835_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_836_ = true;
            }
            let _e196 = phi_835_;
            let _e198 = phi_836_;
            if _e198 {
                let _e204 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e210 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e204.unnamed.visibility, false), _e204.unnamed_1);
                phi_843_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e210.unnamed, true);
            } else {
                phi_843_ = _e196;
            }
            let _e215 = phi_843_;
            phi_847_ = _e215;
        } else {
            let _e221 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e227 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e221.unnamed.visibility, false), _e221.unnamed_1);
            phi_847_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e227.unnamed, true);
        }
        let _e232 = phi_847_;
        if _e232.unnamed_1 {
            phi_1539_ = evaluate_Verdict(_e232.unnamed.visibility, _e232.unnamed.is_doubted);
        } else {
            let _e240 = samples.member[_e74.shift].position;
            let _e242 = p.member.map_size;
            let _e244 = (0.5f / f32(_e242));
            let _e251 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e258 = lt_math_LightPoint(vec2<f32>(_e251.uv.x, 0f), _e251.depth, _e251.is_inside);
            let _e262 = lt_math_LightPoint(_e258.uv, 0f, _e258.is_inside);
            phi_867_ = lt_math_LightPoint();
            phi_870_ = 0u;
            phi_872_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e262.uv, _e262.depth, false));
            loop {
                let _e269 = phi_867_;
                let _e271 = phi_870_;
                let _e273 = phi_872_;
                local_2 = _e273;
                local_3 = _e273;
                local_4 = _e273;
                if (_e271 < _e81) {
                    if _e273.point.is_inside {
                        phi_1033_ = lt_math_LightPoint();
                        phi_1034_ = u32();
                        phi_1035_ = lt_math_LevelPoint();
                        phi_1036_ = false;
                    } else {
                        if (_e271 < _e68) {
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
                                phi_958_ = (_e309 <= 1f);
                            } else {
                                phi_958_ = false;
                            }
                            let _e341 = phi_958_;
                            if _e341 {
                                if (_e323 >= 0f) {
                                    phi_967_ = (_e323 <= 1f);
                                } else {
                                    phi_967_ = false;
                                }
                                let _e345 = phi_967_;
                                if _e345 {
                                    if (_e336 >= 0f) {
                                        phi_976_ = (_e336 <= 1f);
                                    } else {
                                        phi_976_ = false;
                                    }
                                    let _e349 = phi_976_;
                                    phi_977_ = _e349;
                                    phi_978_ = false;
                                } else {
                                    phi_977_ = bool();
                                    phi_978_ = true;
                                }
                                let _e351 = phi_977_;
                                let _e353 = phi_978_;
                                phi_979_ = _e351;
                                phi_980_ = _e353;
                            } else {
                                phi_979_ = bool();
                                phi_980_ = true;
                            }
                            let _e355 = phi_979_;
                            let _e357 = phi_980_;
                            phi_981_ = _e355;
                            phi_982_ = _e357;
                        } else {
                            phi_981_ = bool();
                            phi_982_ = true;
                        }
                        let _e359 = phi_981_;
                        let _e361 = phi_982_;
                        if _e361 {
                            phi_986_ = false;
                        } else {
                            phi_986_ = _e359;
                        }
                        let _e363 = phi_986_;
                        if _e363 {
                            if (_e309 >= _e244) {
                                if (_e309 <= (1f - _e244)) {
                                    if (_e323 >= _e244) {
                                        phi_1013_ = (_e323 <= (1f - _e244));
                                        phi_1014_ = false;
                                    } else {
                                        phi_1013_ = bool();
                                        phi_1014_ = true;
                                    }
                                    let _e371 = phi_1013_;
                                    let _e373 = phi_1014_;
                                    phi_1015_ = _e371;
                                    phi_1016_ = _e373;
                                } else {
                                    phi_1015_ = bool();
                                    phi_1016_ = true;
                                }
                                let _e375 = phi_1015_;
                                let _e377 = phi_1016_;
                                phi_1017_ = _e375;
                                phi_1018_ = _e377;
                            } else {
                                phi_1017_ = bool();
                                phi_1018_ = true;
                            }
                            let _e379 = phi_1017_;
                            let _e381 = phi_1018_;
                            phi_1019_ = _e379;
                            phi_1020_ = _e381;
                        } else {
                            phi_1019_ = bool();
                            phi_1020_ = true;
                        }
                        let _e383 = phi_1019_;
                        let _e385 = phi_1020_;
                        if _e385 {
                            phi_1024_ = false;
                        } else {
                            phi_1024_ = _e383;
                        }
                        let _e387 = phi_1024_;
                        let _e394 = lt_math_LightPoint(vec2<f32>(_e309, _e269.uv.y), _e269.depth, _e269.is_inside);
                        let _e401 = lt_math_LightPoint(vec2<f32>(_e394.uv.x, _e323), _e394.depth, _e394.is_inside);
                        let _e405 = lt_math_LightPoint(_e401.uv, _e336, _e401.is_inside);
                        let _e409 = lt_math_LightPoint(_e405.uv, _e405.depth, _e387);
                        phi_1033_ = _e409;
                        phi_1034_ = (_e271 + 1u);
                        phi_1035_ = lt_math_LevelPoint(_e271, _e409);
                        phi_1036_ = true;
                    }
                    let _e413 = phi_1033_;
                    let _e415 = phi_1034_;
                    let _e417 = phi_1035_;
                    let _e419 = phi_1036_;
                    phi_868_ = _e413;
                    phi_871_ = _e415;
                    phi_873_ = _e417;
                    phi_1037_ = _e419;
                } else {
                    phi_868_ = lt_math_LightPoint();
                    phi_871_ = u32();
                    phi_873_ = lt_math_LevelPoint();
                    phi_1037_ = false;
                }
                let _e421 = phi_868_;
                let _e423 = phi_871_;
                let _e425 = phi_873_;
                let _e427 = phi_1037_;
                continue;
                continuing {
                    phi_867_ = _e421;
                    phi_870_ = _e423;
                    phi_872_ = _e425;
                    break if !(_e427);
                }
            }
            let _e430 = local_2;
            if _e430.point.is_inside {
                if (0f > 0f) {
                    let _e436 = local_3;
                    if (_e436.level < _e68) {
                    } else {
                        return;
                    }
                    let _e441 = levels.member[(0u + _e436.level)];
                    let _e447 = global[0u];
                    if (_e441.row_w.x == _e447) {
                        let _e450 = global[1u];
                        if (_e441.row_w.y == _e450) {
                            let _e453 = global[2u];
                            phi_1077_ = (_e441.row_w.z == _e453);
                            phi_1078_ = false;
                        } else {
                            phi_1077_ = bool();
                            phi_1078_ = true;
                        }
                        let _e456 = phi_1077_;
                        let _e458 = phi_1078_;
                        phi_1079_ = _e456;
                        phi_1080_ = _e458;
                    } else {
                        phi_1079_ = bool();
                        phi_1080_ = true;
                    }
                    let _e460 = phi_1079_;
                    let _e462 = phi_1080_;
                    if _e462 {
                        phi_1084_ = false;
                    } else {
                        phi_1084_ = _e460;
                    }
                    let _e464 = phi_1084_;
                    if _e464 {
                        let _e466 = samples.member[_e74.shift].normal;
                        let _e468 = p.member.map_size;
                        let _e538 = ((abs(((((_e441.row_x.x * _e466.x) + (_e441.row_x.y * _e466.y)) + (_e441.row_x.z * _e466.z)) / (((_e441.row_x.x * _e441.row_x.x) + (_e441.row_x.y * _e441.row_x.y)) + (_e441.row_x.z * _e441.row_x.z)))) + abs(((((_e441.row_y.x * _e466.x) + (_e441.row_y.y * _e466.y)) + (_e441.row_y.z * _e466.z)) / (((_e441.row_y.x * _e441.row_y.x) + (_e441.row_y.y * _e441.row_y.y)) + (_e441.row_y.z * _e441.row_y.z))))) / (abs(((((_e441.row_z.x * _e466.x) + (_e441.row_z.y * _e466.y)) + (_e441.row_z.z * _e466.z)) / (((_e441.row_z.x * _e441.row_z.x) + (_e441.row_z.y * _e441.row_z.y)) + (_e441.row_z.z * _e441.row_z.z)))) * f32(_e468)));
                        if (_e538 < 0.002f) {
                            phi_1166_ = _e538;
                        } else {
                            phi_1166_ = 0.002f;
                        }
                        let _e541 = phi_1166_;
                        phi_1285_ = _e541;
                    } else {
                        let _e543 = p.member.map_size;
                        let _e549 = samples.member[_e74.shift].position;
                        let _e560 = ((((_e441.row_w.x * _e549.x) + (_e441.row_w.y * _e549.y)) + (_e441.row_w.z * _e549.z)) + _e441.row_w.w);
                        let _e573 = ((_e441.row_x.x - (_e441.row_w.x * _e430.point.uv.x)) / _e560);
                        let _e574 = ((_e441.row_x.y - (_e441.row_w.y * _e430.point.uv.x)) / _e560);
                        let _e575 = ((_e441.row_x.z - (_e441.row_w.z * _e430.point.uv.x)) / _e560);
                        let _e588 = ((_e441.row_y.x - (_e441.row_w.x * _e430.point.uv.y)) / _e560);
                        let _e589 = ((_e441.row_y.y - (_e441.row_w.y * _e430.point.uv.y)) / _e560);
                        let _e590 = ((_e441.row_y.z - (_e441.row_w.z * _e430.point.uv.y)) / _e560);
                        let _e596 = samples.member[_e74.shift].normal;
                        let _e601 = ((_e589 * _e596.z) - (_e596.y * _e590));
                        let _e606 = ((_e590 * _e596.x) - (_e596.z * _e588));
                        let _e611 = ((_e588 * _e596.y) - (_e596.x * _e589));
                        let _e613 = samples.member[_e74.shift].normal;
                        let _e618 = ((_e574 * _e613.z) - (_e613.y * _e575));
                        let _e623 = ((_e575 * _e613.x) - (_e613.z * _e573));
                        let _e628 = ((_e573 * _e613.y) - (_e613.x * _e574));
                        let _e655 = ((abs(((((_e441.row_z.x * _e601) + (_e441.row_z.y * _e606)) + (_e441.row_z.z * _e611)) / (((_e573 * _e601) + (_e574 * _e606)) + (_e575 * _e611)))) + abs(((((_e441.row_z.x * _e618) + (_e441.row_z.y * _e623)) + (_e441.row_z.z * _e628)) / (((_e588 * _e618) + (_e589 * _e623)) + (_e590 * _e628))))) / f32(_e543));
                        let _e657 = (16f / f32(_e543));
                        if (_e655 < _e657) {
                            phi_1284_ = _e655;
                        } else {
                            phi_1284_ = _e657;
                        }
                        let _e660 = phi_1284_;
                        phi_1285_ = _e660;
                    }
                    let _e662 = phi_1285_;
                    phi_1288_ = (_e430.point.depth - (0f * _e662));
                } else {
                    phi_1288_ = _e430.point.depth;
                }
                let _e666 = phi_1288_;
                let _e672 = p.member.map_size;
                let _e673 = f32(_e672);
                let _e676 = ((_e430.point.uv.x * _e673) - 0.5f);
                let _e677 = ((_e430.point.uv.y * _e673) - 0.5f);
                if (_e676 > -8388608f) {
                    let _e689 = f32(select(0i, select(select(i32(_e676), i32(-2147483648), (_e676 < bitcast<f32>(3472883712u))), 2147483647i, (_e676 > bitcast<f32>(1325400063u))), (_e676 == _e676)));
                    if (_e689 > _e676) {
                        phi_1317_ = 1f;
                    } else {
                        phi_1317_ = 0f;
                    }
                    let _e692 = phi_1317_;
                    if (_e676 < 8388608f) {
                        phi_1322_ = (_e689 - _e692);
                        phi_1323_ = false;
                    } else {
                        phi_1322_ = f32();
                        phi_1323_ = true;
                    }
                    let _e695 = phi_1322_;
                    let _e697 = phi_1323_;
                    phi_1324_ = _e695;
                    phi_1325_ = _e697;
                } else {
                    phi_1324_ = f32();
                    phi_1325_ = true;
                }
                let _e699 = phi_1324_;
                let _e701 = phi_1325_;
                if _e701 {
                    phi_1329_ = _e676;
                } else {
                    phi_1329_ = _e699;
                }
                let _e703 = phi_1329_;
                if (_e677 > -8388608f) {
                    let _e715 = f32(select(0i, select(select(i32(_e677), i32(-2147483648), (_e677 < bitcast<f32>(3472883712u))), 2147483647i, (_e677 > bitcast<f32>(1325400063u))), (_e677 == _e677)));
                    if (_e715 > _e677) {
                        phi_1349_ = 1f;
                    } else {
                        phi_1349_ = 0f;
                    }
                    let _e718 = phi_1349_;
                    if (_e677 < 8388608f) {
                        phi_1354_ = (_e715 - _e718);
                        phi_1355_ = false;
                    } else {
                        phi_1354_ = f32();
                        phi_1355_ = true;
                    }
                    let _e721 = phi_1354_;
                    let _e723 = phi_1355_;
                    phi_1356_ = _e721;
                    phi_1357_ = _e723;
                } else {
                    phi_1356_ = f32();
                    phi_1357_ = true;
                }
                let _e725 = phi_1356_;
                let _e727 = phi_1357_;
                if _e727 {
                    phi_1361_ = _e677;
                } else {
                    phi_1361_ = _e725;
                }
                let _e729 = phi_1361_;
                let _e730 = (_e676 - _e703);
                let _e731 = (_e677 - _e729);
                let _e740 = select(0i, select(select(i32(_e703), i32(-2147483648), (_e703 < bitcast<f32>(3472883712u))), 2147483647i, (_e703 > bitcast<f32>(1325400063u))), (_e703 == _e703));
                let _e749 = select(0i, select(select(i32(_e729), i32(-2147483648), (_e729 < bitcast<f32>(3472883712u))), 2147483647i, (_e729 > bitcast<f32>(1325400063u))), (_e729 == _e729));
                let _e760 = p.member.test;
                let _e761 = _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e760);
                let _e763 = p.member.map_size;
                let _e765 = local_4;
                local_1 = _e761;
                let _e768 = ((_e765.level * _e763) * _e763);
                let _e770 = (bitcast<i32>(_e763) - 1i);
                if (_e740 > 0i) {
                    phi_1410_ = _e740;
                } else {
                    phi_1410_ = 0i;
                }
                let _e773 = phi_1410_;
                if (_e749 > 0i) {
                    phi_1415_ = _e749;
                } else {
                    phi_1415_ = 0i;
                }
                let _e776 = phi_1415_;
                if (_e773 < _e770) {
                    phi_1420_ = _e773;
                } else {
                    phi_1420_ = _e770;
                }
                let _e779 = phi_1420_;
                if (_e776 < _e770) {
                    phi_1425_ = _e776;
                } else {
                    phi_1425_ = _e770;
                }
                let _e782 = phi_1425_;
                let _e783 = bitcast<u32>(_e779);
                let _e785 = (_e740 + 1i);
                let _e786 = (_e749 + 1i);
                if (_e785 > 0i) {
                    phi_1434_ = _e785;
                } else {
                    phi_1434_ = 0i;
                }
                let _e789 = phi_1434_;
                if (_e786 > 0i) {
                    phi_1439_ = _e786;
                } else {
                    phi_1439_ = 0i;
                }
                let _e792 = phi_1439_;
                if (_e789 < _e770) {
                    phi_1444_ = _e789;
                } else {
                    phi_1444_ = _e770;
                }
                let _e795 = phi_1444_;
                if (_e792 < _e770) {
                    phi_1449_ = _e792;
                } else {
                    phi_1449_ = _e770;
                }
                let _e798 = phi_1449_;
                let _e799 = bitcast<u32>(_e795);
                let _e801 = (bitcast<u32>(_e782) * _e763);
                let _e802 = (bitcast<u32>(_e798) * _e763);
                let _e807 = ((_e801 + _e783) + _e768);
                let _e808 = ((_e801 + _e799) + _e768);
                let _e809 = ((_e802 + _e783) + _e768);
                let _e810 = ((_e802 + _e799) + _e768);
                if (_e807 < _e63) {
                } else {
                    return;
                }
                let _e814 = map.member[(0u + _e807)];
                if (_e808 < _e63) {
                } else {
                    return;
                }
                let _e818 = map.member[(0u + _e808)];
                if (_e809 < _e63) {
                } else {
                    return;
                }
                let _e822 = map.member[(0u + _e809)];
                if (_e810 < _e63) {
                } else {
                    return;
                }
                let _e826 = map.member[(0u + _e810)];
                let _e828 = _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local_1), vec4<f32>(_e814, _e818, _e822, _e826), vec4<f32>(((1f - _e730) * (1f - _e731)), (_e730 * (1f - _e731)), ((1f - _e730) * _e731), (_e730 * _e731)), _e666);
                let _e830 = p.member.epsilon;
                if (_e828 <= _e830) {
                    phi_1500_ = true;
                } else {
                    phi_1500_ = (_e828 >= (1f - _e830));
                }
                let _e835 = phi_1500_;
                if ((bitcast<u32>(_e828) & 2147483647u) > 2139095040u) {
                    phi_1508_ = true;
                } else {
                    phi_1508_ = !(_e835);
                }
                let _e841 = phi_1508_;
                if _e841 {
                    if (_e828 > 0f) {
                        if (_e828 < 1f) {
                            phi_1520_ = false;
                        } else {
                            phi_1520_ = true;
                        }
                        let _e845 = phi_1520_;
                        phi_1521_ = _e845;
                    } else {
                        phi_1521_ = true;
                    }
                    let _e847 = phi_1521_;
                    if _e847 {
                        phi_1525_ = 0.5f;
                    } else {
                        phi_1525_ = _e828;
                    }
                    let _e849 = phi_1525_;
                    phi_1533_ = evaluate_Verdict(_e849, true);
                } else {
                    if (_e828 > 0.5f) {
                        phi_1531_ = 1f;
                    } else {
                        phi_1531_ = 0f;
                    }
                    let _e853 = phi_1531_;
                    phi_1533_ = evaluate_Verdict(_e853, false);
                }
                let _e856 = phi_1533_;
                phi_1538_ = evaluate_Verdict(_e856.visibility, _e856.is_doubted);
            } else {
                phi_1538_ = evaluate_Verdict(0.5f, true);
            }
            let _e862 = phi_1538_;
            phi_1539_ = _e862;
        }
        let _e864 = phi_1539_;
        visibility.member[_e74.shift] = _e864.visibility;
        phi_1543_ = _e864.is_doubted;
        phi_1544_ = _e74.shift;
    } else {
        phi_1543_ = false;
        phi_1544_ = 0u;
    }
    let _e869 = phi_1543_;
    let _e871 = phi_1544_;
    if (_e58 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e869 {
        let _e875 = atomicAdd((&shared_[0u]), 1u);
        phi_1555_ = _e875;
    } else {
        phi_1555_ = 0u;
    }
    let _e877 = phi_1555_;
    workgroupBarrier();
    if (_e58 == 0u) {
        let _e881 = atomicLoad((&shared_[0u]));
        let _e882 = atomicAdd((&list.member[3u]), _e881);
        atomicStore((&shared_[1u]), _e882);
    }
    workgroupBarrier();
    if _e869 {
        let _e885 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e885) + _e877)]), _e871);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_esm_levels_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_5 = local;
    function_();
}
