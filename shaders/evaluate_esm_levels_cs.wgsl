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
    var phi_156_: lt_bvh_traverse_Tree;
    var phi_157_: bool;
    var phi_158_: lt_bvh_traverse_Tree;
    var phi_159_: bool;
    var phi_164_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_156_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_157_ = false;
        } else {
            phi_156_ = lt_bvh_traverse_Tree();
            phi_157_ = true;
        }
        let _e64 = phi_156_;
        let _e66 = phi_157_;
        phi_158_ = _e64;
        phi_159_ = _e66;
    } else {
        phi_158_ = lt_bvh_traverse_Tree();
        phi_159_ = true;
    }
    let _e68 = phi_158_;
    let _e70 = phi_159_;
    if _e70 {
        phi_164_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_164_ = _e68;
    }
    let _e75 = phi_164_;
    return lt_bvh_traverse_Tree(_e75.root, _e75.first_primitive);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_esm_Esm_clamped_exponent(param_4: ptr<function, f32>) -> f32 {
    var phi_184_: bool;
    var phi_188_: f32;

    let _e52 = (*param_4);
    if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
        phi_184_ = true;
    } else {
        let _e56 = (84f < _e52);
        if _e56 {
        }
        phi_184_ = _e56;
    }
    let _e58 = phi_184_;
    if _e58 {
        phi_188_ = 84f;
    } else {
        phi_188_ = _e52;
    }
    let _e60 = phi_188_;
    return _e60;
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_5: ptr<function, f32>, param_6: vec4<f32>, param_7: vec4<f32>, param_8: f32) -> f32 {
    var phi_209_: f32;
    var phi_210_: f32;
    var phi_211_: f32;
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
    var phi_302_: f32;
    var phi_307_: f32;
    var phi_329_: f32;
    var phi_334_: f32;
    var phi_335_: bool;
    var phi_336_: f32;
    var phi_337_: bool;
    var phi_341_: f32;
    var phi_379_: f32;
    var phi_390_: f32;
    var phi_395_: f32;
    var phi_417_: f32;
    var phi_422_: f32;
    var phi_423_: bool;
    var phi_424_: f32;
    var phi_425_: bool;
    var phi_429_: f32;
    var phi_467_: f32;
    var phi_478_: f32;
    var phi_483_: f32;
    var phi_505_: f32;
    var phi_510_: f32;
    var phi_511_: bool;
    var phi_512_: f32;
    var phi_513_: bool;
    var phi_517_: f32;
    var phi_555_: f32;
    var phi_566_: f32;
    var phi_571_: f32;
    var phi_593_: f32;
    var phi_598_: f32;
    var phi_599_: bool;
    var phi_600_: f32;
    var phi_601_: bool;
    var phi_605_: f32;
    var phi_643_: f32;
    var phi_669_: f32;
    var phi_670_: f32;
    var phi_671_: f32;

    let _e55 = _lt_math_esm_Esm_clamped_exponent(param_5);
    if ((bitcast<u32>(param_8) & 2147483647u) > 2139095040u) {
        phi_211_ = param_8;
    } else {
        if (param_8 < 0f) {
            phi_210_ = 0f;
        } else {
            if (param_8 > 1f) {
                phi_209_ = 1f;
            } else {
                phi_209_ = param_8;
            }
            let _e62 = phi_209_;
            phi_210_ = _e62;
        }
        let _e64 = phi_210_;
        phi_211_ = _e64;
    }
    let _e66 = phi_211_;
    if ((bitcast<u32>(param_6.x) & 2147483647u) > 2139095040u) {
        phi_229_ = param_6.x;
    } else {
        if (param_6.x < 0f) {
            phi_228_ = 0f;
        } else {
            if (param_6.x > 1f) {
                phi_227_ = 1f;
            } else {
                phi_227_ = param_6.x;
            }
            let _e74 = phi_227_;
            phi_228_ = _e74;
        }
        let _e76 = phi_228_;
        phi_229_ = _e76;
    }
    let _e78 = phi_229_;
    if ((bitcast<u32>(param_6.y) & 2147483647u) > 2139095040u) {
        phi_247_ = param_6.y;
    } else {
        if (param_6.y < 0f) {
            phi_246_ = 0f;
        } else {
            if (param_6.y > 1f) {
                phi_245_ = 1f;
            } else {
                phi_245_ = param_6.y;
            }
            let _e86 = phi_245_;
            phi_246_ = _e86;
        }
        let _e88 = phi_246_;
        phi_247_ = _e88;
    }
    let _e90 = phi_247_;
    if ((bitcast<u32>(param_6.z) & 2147483647u) > 2139095040u) {
        phi_265_ = param_6.z;
    } else {
        if (param_6.z < 0f) {
            phi_264_ = 0f;
        } else {
            if (param_6.z > 1f) {
                phi_263_ = 1f;
            } else {
                phi_263_ = param_6.z;
            }
            let _e98 = phi_263_;
            phi_264_ = _e98;
        }
        let _e100 = phi_264_;
        phi_265_ = _e100;
    }
    let _e102 = phi_265_;
    if ((bitcast<u32>(param_6.w) & 2147483647u) > 2139095040u) {
        phi_283_ = param_6.w;
    } else {
        if (param_6.w < 0f) {
            phi_282_ = 0f;
        } else {
            if (param_6.w > 1f) {
                phi_281_ = 1f;
            } else {
                phi_281_ = param_6.w;
            }
            let _e110 = phi_281_;
            phi_282_ = _e110;
        }
        let _e112 = phi_282_;
        phi_283_ = _e112;
    }
    let _e114 = phi_283_;
    let _e119 = (_e55 * (_e78 - _e66));
    let _e120 = (_e55 * (_e90 - _e66));
    let _e121 = (_e55 * (_e102 - _e66));
    let _e122 = (_e55 * (_e114 - _e66));
    if ((bitcast<u32>(_e119) & 2147483647u) > 2139095040u) {
        phi_379_ = _e119;
    } else {
        if (_e119 < -87f) {
            phi_302_ = -87f;
        } else {
            phi_302_ = _e119;
        }
        let _e128 = phi_302_;
        if (_e128 > 88f) {
            phi_307_ = 88f;
        } else {
            phi_307_ = _e128;
        }
        let _e131 = phi_307_;
        let _e133 = ((_e131 * 1.442695f) + 0.5f);
        if (_e133 > -8388608f) {
            let _e145 = f32(select(0i, select(select(i32(_e133), i32(-2147483648), (_e133 < bitcast<f32>(3472883712u))), 2147483647i, (_e133 > bitcast<f32>(1325400063u))), (_e133 == _e133)));
            if (_e145 > _e133) {
                phi_329_ = 1f;
            } else {
                phi_329_ = 0f;
            }
            let _e148 = phi_329_;
            if (_e133 < 8388608f) {
                phi_334_ = (_e145 - _e148);
                phi_335_ = false;
            } else {
                phi_334_ = f32();
                phi_335_ = true;
            }
            let _e151 = phi_334_;
            let _e153 = phi_335_;
            phi_336_ = _e151;
            phi_337_ = _e153;
        } else {
            phi_336_ = f32();
            phi_337_ = true;
        }
        let _e155 = phi_336_;
        let _e157 = phi_337_;
        if _e157 {
            phi_341_ = _e133;
        } else {
            phi_341_ = _e155;
        }
        let _e159 = phi_341_;
        let _e163 = ((_e131 - (_e159 * 0.69314575f)) - (_e159 * 0.0000014286068f));
        phi_379_ = ((((((((((((((((1f / 5040f) * _e163) + (1f / 720f)) * _e163) + (1f / 120f)) * _e163) + (1f / 24f)) * _e163) + (1f / 6f)) * _e163) + 0.5f) * _e163) + 1f) * _e163) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e159), i32(-2147483648), (_e159 < bitcast<f32>(3472883712u))), 2147483647i, (_e159 > bitcast<f32>(1325400063u))), (_e159 == _e159)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e199 = phi_379_;
    if ((bitcast<u32>(_e120) & 2147483647u) > 2139095040u) {
        phi_467_ = _e120;
    } else {
        if (_e120 < -87f) {
            phi_390_ = -87f;
        } else {
            phi_390_ = _e120;
        }
        let _e205 = phi_390_;
        if (_e205 > 88f) {
            phi_395_ = 88f;
        } else {
            phi_395_ = _e205;
        }
        let _e208 = phi_395_;
        let _e210 = ((_e208 * 1.442695f) + 0.5f);
        if (_e210 > -8388608f) {
            let _e222 = f32(select(0i, select(select(i32(_e210), i32(-2147483648), (_e210 < bitcast<f32>(3472883712u))), 2147483647i, (_e210 > bitcast<f32>(1325400063u))), (_e210 == _e210)));
            if (_e222 > _e210) {
                phi_417_ = 1f;
            } else {
                phi_417_ = 0f;
            }
            let _e225 = phi_417_;
            if (_e210 < 8388608f) {
                phi_422_ = (_e222 - _e225);
                phi_423_ = false;
            } else {
                phi_422_ = f32();
                phi_423_ = true;
            }
            let _e228 = phi_422_;
            let _e230 = phi_423_;
            phi_424_ = _e228;
            phi_425_ = _e230;
        } else {
            phi_424_ = f32();
            phi_425_ = true;
        }
        let _e232 = phi_424_;
        let _e234 = phi_425_;
        if _e234 {
            phi_429_ = _e210;
        } else {
            phi_429_ = _e232;
        }
        let _e236 = phi_429_;
        let _e240 = ((_e208 - (_e236 * 0.69314575f)) - (_e236 * 0.0000014286068f));
        phi_467_ = ((((((((((((((((1f / 5040f) * _e240) + (1f / 720f)) * _e240) + (1f / 120f)) * _e240) + (1f / 24f)) * _e240) + (1f / 6f)) * _e240) + 0.5f) * _e240) + 1f) * _e240) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e236), i32(-2147483648), (_e236 < bitcast<f32>(3472883712u))), 2147483647i, (_e236 > bitcast<f32>(1325400063u))), (_e236 == _e236)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e276 = phi_467_;
    if ((bitcast<u32>(_e121) & 2147483647u) > 2139095040u) {
        phi_555_ = _e121;
    } else {
        if (_e121 < -87f) {
            phi_478_ = -87f;
        } else {
            phi_478_ = _e121;
        }
        let _e282 = phi_478_;
        if (_e282 > 88f) {
            phi_483_ = 88f;
        } else {
            phi_483_ = _e282;
        }
        let _e285 = phi_483_;
        let _e287 = ((_e285 * 1.442695f) + 0.5f);
        if (_e287 > -8388608f) {
            let _e299 = f32(select(0i, select(select(i32(_e287), i32(-2147483648), (_e287 < bitcast<f32>(3472883712u))), 2147483647i, (_e287 > bitcast<f32>(1325400063u))), (_e287 == _e287)));
            if (_e299 > _e287) {
                phi_505_ = 1f;
            } else {
                phi_505_ = 0f;
            }
            let _e302 = phi_505_;
            if (_e287 < 8388608f) {
                phi_510_ = (_e299 - _e302);
                phi_511_ = false;
            } else {
                phi_510_ = f32();
                phi_511_ = true;
            }
            let _e305 = phi_510_;
            let _e307 = phi_511_;
            phi_512_ = _e305;
            phi_513_ = _e307;
        } else {
            phi_512_ = f32();
            phi_513_ = true;
        }
        let _e309 = phi_512_;
        let _e311 = phi_513_;
        if _e311 {
            phi_517_ = _e287;
        } else {
            phi_517_ = _e309;
        }
        let _e313 = phi_517_;
        let _e317 = ((_e285 - (_e313 * 0.69314575f)) - (_e313 * 0.0000014286068f));
        phi_555_ = ((((((((((((((((1f / 5040f) * _e317) + (1f / 720f)) * _e317) + (1f / 120f)) * _e317) + (1f / 24f)) * _e317) + (1f / 6f)) * _e317) + 0.5f) * _e317) + 1f) * _e317) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e313), i32(-2147483648), (_e313 < bitcast<f32>(3472883712u))), 2147483647i, (_e313 > bitcast<f32>(1325400063u))), (_e313 == _e313)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e353 = phi_555_;
    if ((bitcast<u32>(_e122) & 2147483647u) > 2139095040u) {
        phi_643_ = _e122;
    } else {
        if (_e122 < -87f) {
            phi_566_ = -87f;
        } else {
            phi_566_ = _e122;
        }
        let _e359 = phi_566_;
        if (_e359 > 88f) {
            phi_571_ = 88f;
        } else {
            phi_571_ = _e359;
        }
        let _e362 = phi_571_;
        let _e364 = ((_e362 * 1.442695f) + 0.5f);
        if (_e364 > -8388608f) {
            let _e376 = f32(select(0i, select(select(i32(_e364), i32(-2147483648), (_e364 < bitcast<f32>(3472883712u))), 2147483647i, (_e364 > bitcast<f32>(1325400063u))), (_e364 == _e364)));
            if (_e376 > _e364) {
                phi_593_ = 1f;
            } else {
                phi_593_ = 0f;
            }
            let _e379 = phi_593_;
            if (_e364 < 8388608f) {
                phi_598_ = (_e376 - _e379);
                phi_599_ = false;
            } else {
                phi_598_ = f32();
                phi_599_ = true;
            }
            let _e382 = phi_598_;
            let _e384 = phi_599_;
            phi_600_ = _e382;
            phi_601_ = _e384;
        } else {
            phi_600_ = f32();
            phi_601_ = true;
        }
        let _e386 = phi_600_;
        let _e388 = phi_601_;
        if _e388 {
            phi_605_ = _e364;
        } else {
            phi_605_ = _e386;
        }
        let _e390 = phi_605_;
        let _e394 = ((_e362 - (_e390 * 0.69314575f)) - (_e390 * 0.0000014286068f));
        phi_643_ = ((((((((((((((((1f / 5040f) * _e394) + (1f / 720f)) * _e394) + (1f / 120f)) * _e394) + (1f / 24f)) * _e394) + (1f / 6f)) * _e394) + 0.5f) * _e394) + 1f) * _e394) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e390), i32(-2147483648), (_e390 < bitcast<f32>(3472883712u))), 2147483647i, (_e390 > bitcast<f32>(1325400063u))), (_e390 == _e390)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e430 = phi_643_;
    let _e441 = ((((_e199 * param_7.x) + (_e276 * param_7.y)) + (_e353 * param_7.z)) + (_e430 * param_7.w));
    if ((bitcast<u32>(_e441) & 2147483647u) > 2139095040u) {
        phi_671_ = _e441;
    } else {
        if (_e441 < 0f) {
            phi_670_ = 0f;
        } else {
            if (_e441 > 1f) {
                phi_669_ = 1f;
            } else {
                phi_669_ = _e441;
            }
            let _e448 = phi_669_;
            phi_670_ = _e448;
        }
        let _e450 = phi_670_;
        phi_671_ = _e450;
    }
    let _e452 = phi_671_;
    return _e452;
}

fn function_() {
    var local: f32;
    var phi_731_: bool;
    var phi_732_: bool;
    var phi_733_: bool;
    var phi_734_: bool;
    var phi_738_: bool;
    var phi_808_: bool;
    var phi_809_: bool;
    var phi_820_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_821_: bool;
    var phi_822_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_823_: bool;
    var phi_830_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_834_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_854_: lt_math_LightPoint;
    var phi_857_: u32;
    var phi_859_: lt_math_LevelPoint;
    var phi_945_: bool;
    var phi_954_: bool;
    var phi_963_: bool;
    var phi_964_: bool;
    var phi_965_: bool;
    var phi_966_: bool;
    var phi_967_: bool;
    var phi_968_: bool;
    var phi_969_: bool;
    var phi_973_: bool;
    var phi_1000_: bool;
    var phi_1001_: bool;
    var phi_1002_: bool;
    var phi_1003_: bool;
    var phi_1004_: bool;
    var phi_1005_: bool;
    var phi_1006_: bool;
    var phi_1007_: bool;
    var phi_1011_: bool;
    var phi_1020_: lt_math_LightPoint;
    var phi_1021_: u32;
    var phi_1022_: lt_math_LevelPoint;
    var phi_1023_: bool;
    var phi_855_: lt_math_LightPoint;
    var phi_858_: u32;
    var phi_860_: lt_math_LevelPoint;
    var phi_1024_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_1064_: bool;
    var phi_1065_: bool;
    var phi_1066_: bool;
    var phi_1067_: bool;
    var phi_1071_: bool;
    var phi_1153_: f32;
    var phi_1269_: f32;
    var phi_1270_: f32;
    var phi_1273_: f32;
    var phi_1302_: f32;
    var phi_1307_: f32;
    var phi_1308_: bool;
    var phi_1309_: f32;
    var phi_1310_: bool;
    var phi_1314_: f32;
    var phi_1334_: f32;
    var phi_1339_: f32;
    var phi_1340_: bool;
    var phi_1341_: f32;
    var phi_1342_: bool;
    var phi_1346_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_1395_: i32;
    var phi_1400_: i32;
    var phi_1405_: i32;
    var phi_1410_: i32;
    var phi_1419_: i32;
    var phi_1424_: i32;
    var phi_1429_: i32;
    var phi_1434_: i32;
    var phi_1479_: evaluate_Verdict;
    var phi_1480_: evaluate_Verdict;
    var phi_1481_: bool;
    var phi_1482_: evaluate_Verdict;
    var phi_1483_: evaluate_Verdict;
    var phi_1484_: bool;
    var phi_1488_: evaluate_Verdict;

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
                phi_731_ = (_e94 == _e96);
                phi_732_ = false;
            } else {
                phi_731_ = bool();
                phi_732_ = true;
            }
            let _e99 = phi_731_;
            let _e101 = phi_732_;
            phi_733_ = _e99;
            phi_734_ = _e101;
        } else {
            phi_733_ = bool();
            phi_734_ = true;
        }
        let _e103 = phi_733_;
        let _e105 = phi_734_;
        if _e105 {
            phi_738_ = false;
        } else {
            phi_738_ = _e103;
        }
        let _e107 = phi_738_;
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
                    phi_809_ = true;
                } else {
                    let _e160 = p.member.light.range_squared;
                    if (_e143 <= _e160) {
                        let _e163 = p.member.light.cos_outer;
                        phi_808_ = (-((((_e125 * _e145.x) + (_e126 * _e145.y)) + (_e127 * _e145.z))) >= (_e163 * sqrt(_e143)));
                    } else {
                        phi_808_ = false;
                    }
                    let _e168 = phi_808_;
                    phi_809_ = _e168;
                }
                let _e170 = phi_809_;
                if _e170 {
                    let _e172 = samples.member[(0u + _e71.first_primitive)].flags;
                    let _e180 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e186 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e180.unnamed.visibility, false), _e180.unnamed_1);
                    phi_820_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e186.unnamed, ((_e172 & 1u) == 0u));
                    phi_821_ = false;
                } else {
                    phi_820_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_821_ = true;
                }
                let _e191 = phi_820_;
                let _e193 = phi_821_;
                phi_822_ = _e191;
                phi_823_ = _e193;
            } else {
                phi_822_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_823_ = true;
            }
            let _e195 = phi_822_;
            let _e197 = phi_823_;
            if _e197 {
                let _e203 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e209 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e203.unnamed.visibility, false), _e203.unnamed_1);
                phi_830_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e209.unnamed, true);
            } else {
                phi_830_ = _e195;
            }
            let _e214 = phi_830_;
            phi_834_ = _e214;
        } else {
            let _e220 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e226 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e220.unnamed.visibility, false), _e220.unnamed_1);
            phi_834_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e226.unnamed, true);
        }
        let _e231 = phi_834_;
        if _e231.unnamed_1 {
            phi_1482_ = evaluate_Verdict(_e231.unnamed.visibility, _e231.unnamed.is_doubted);
            phi_1483_ = evaluate_Verdict();
            phi_1484_ = true;
        } else {
            let _e239 = samples.member[(0u + _e71.first_primitive)].position;
            let _e241 = p.member.map_size;
            let _e243 = (0.5f / f32(_e241));
            let _e250 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e257 = lt_math_LightPoint(vec2<f32>(_e250.uv.x, 0f), _e250.depth, _e250.is_inside);
            let _e261 = lt_math_LightPoint(_e257.uv, 0f, _e257.is_inside);
            phi_854_ = lt_math_LightPoint();
            phi_857_ = 0u;
            phi_859_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e261.uv, _e261.depth, false));
            loop {
                let _e268 = phi_854_;
                let _e270 = phi_857_;
                let _e272 = phi_859_;
                local_1 = _e272;
                local_2 = _e272;
                local_3 = _e272;
                if (_e270 < _e77) {
                    if _e272.point.is_inside {
                        phi_1020_ = lt_math_LightPoint();
                        phi_1021_ = u32();
                        phi_1022_ = lt_math_LevelPoint();
                        phi_1023_ = false;
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
                                phi_945_ = (_e308 <= 1f);
                            } else {
                                phi_945_ = false;
                            }
                            let _e340 = phi_945_;
                            if _e340 {
                                if (_e322 >= 0f) {
                                    phi_954_ = (_e322 <= 1f);
                                } else {
                                    phi_954_ = false;
                                }
                                let _e344 = phi_954_;
                                if _e344 {
                                    if (_e335 >= 0f) {
                                        phi_963_ = (_e335 <= 1f);
                                    } else {
                                        phi_963_ = false;
                                    }
                                    let _e348 = phi_963_;
                                    phi_964_ = _e348;
                                    phi_965_ = false;
                                } else {
                                    phi_964_ = bool();
                                    phi_965_ = true;
                                }
                                let _e350 = phi_964_;
                                let _e352 = phi_965_;
                                phi_966_ = _e350;
                                phi_967_ = _e352;
                            } else {
                                phi_966_ = bool();
                                phi_967_ = true;
                            }
                            let _e354 = phi_966_;
                            let _e356 = phi_967_;
                            phi_968_ = _e354;
                            phi_969_ = _e356;
                        } else {
                            phi_968_ = bool();
                            phi_969_ = true;
                        }
                        let _e358 = phi_968_;
                        let _e360 = phi_969_;
                        if _e360 {
                            phi_973_ = false;
                        } else {
                            phi_973_ = _e358;
                        }
                        let _e362 = phi_973_;
                        if _e362 {
                            if (_e308 >= _e243) {
                                if (_e308 <= (1f - _e243)) {
                                    if (_e322 >= _e243) {
                                        phi_1000_ = (_e322 <= (1f - _e243));
                                        phi_1001_ = false;
                                    } else {
                                        phi_1000_ = bool();
                                        phi_1001_ = true;
                                    }
                                    let _e370 = phi_1000_;
                                    let _e372 = phi_1001_;
                                    phi_1002_ = _e370;
                                    phi_1003_ = _e372;
                                } else {
                                    phi_1002_ = bool();
                                    phi_1003_ = true;
                                }
                                let _e374 = phi_1002_;
                                let _e376 = phi_1003_;
                                phi_1004_ = _e374;
                                phi_1005_ = _e376;
                            } else {
                                phi_1004_ = bool();
                                phi_1005_ = true;
                            }
                            let _e378 = phi_1004_;
                            let _e380 = phi_1005_;
                            phi_1006_ = _e378;
                            phi_1007_ = _e380;
                        } else {
                            phi_1006_ = bool();
                            phi_1007_ = true;
                        }
                        let _e382 = phi_1006_;
                        let _e384 = phi_1007_;
                        if _e384 {
                            phi_1011_ = false;
                        } else {
                            phi_1011_ = _e382;
                        }
                        let _e386 = phi_1011_;
                        let _e393 = lt_math_LightPoint(vec2<f32>(_e308, _e268.uv.y), _e268.depth, _e268.is_inside);
                        let _e400 = lt_math_LightPoint(vec2<f32>(_e393.uv.x, _e322), _e393.depth, _e393.is_inside);
                        let _e404 = lt_math_LightPoint(_e400.uv, _e335, _e400.is_inside);
                        let _e408 = lt_math_LightPoint(_e404.uv, _e404.depth, _e386);
                        phi_1020_ = _e408;
                        phi_1021_ = (_e270 + 1u);
                        phi_1022_ = lt_math_LevelPoint(_e270, _e408);
                        phi_1023_ = true;
                    }
                    let _e412 = phi_1020_;
                    let _e414 = phi_1021_;
                    let _e416 = phi_1022_;
                    let _e418 = phi_1023_;
                    phi_855_ = _e412;
                    phi_858_ = _e414;
                    phi_860_ = _e416;
                    phi_1024_ = _e418;
                } else {
                    phi_855_ = lt_math_LightPoint();
                    phi_858_ = u32();
                    phi_860_ = lt_math_LevelPoint();
                    phi_1024_ = false;
                }
                let _e420 = phi_855_;
                let _e422 = phi_858_;
                let _e424 = phi_860_;
                let _e426 = phi_1024_;
                continue;
                continuing {
                    phi_854_ = _e420;
                    phi_857_ = _e422;
                    phi_859_ = _e424;
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
                            phi_1064_ = (_e440.row_w.z == _e452);
                            phi_1065_ = false;
                        } else {
                            phi_1064_ = bool();
                            phi_1065_ = true;
                        }
                        let _e455 = phi_1064_;
                        let _e457 = phi_1065_;
                        phi_1066_ = _e455;
                        phi_1067_ = _e457;
                    } else {
                        phi_1066_ = bool();
                        phi_1067_ = true;
                    }
                    let _e459 = phi_1066_;
                    let _e461 = phi_1067_;
                    if _e461 {
                        phi_1071_ = false;
                    } else {
                        phi_1071_ = _e459;
                    }
                    let _e463 = phi_1071_;
                    if _e463 {
                        let _e465 = samples.member[(0u + _e71.first_primitive)].normal;
                        let _e467 = p.member.map_size;
                        let _e537 = ((abs(((((_e440.row_x.x * _e465.x) + (_e440.row_x.y * _e465.y)) + (_e440.row_x.z * _e465.z)) / (((_e440.row_x.x * _e440.row_x.x) + (_e440.row_x.y * _e440.row_x.y)) + (_e440.row_x.z * _e440.row_x.z)))) + abs(((((_e440.row_y.x * _e465.x) + (_e440.row_y.y * _e465.y)) + (_e440.row_y.z * _e465.z)) / (((_e440.row_y.x * _e440.row_y.x) + (_e440.row_y.y * _e440.row_y.y)) + (_e440.row_y.z * _e440.row_y.z))))) / (abs(((((_e440.row_z.x * _e465.x) + (_e440.row_z.y * _e465.y)) + (_e440.row_z.z * _e465.z)) / (((_e440.row_z.x * _e440.row_z.x) + (_e440.row_z.y * _e440.row_z.y)) + (_e440.row_z.z * _e440.row_z.z)))) * f32(_e467)));
                        if (_e537 < 0.002f) {
                            phi_1153_ = _e537;
                        } else {
                            phi_1153_ = 0.002f;
                        }
                        let _e540 = phi_1153_;
                        phi_1270_ = _e540;
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
                            phi_1269_ = _e654;
                        } else {
                            phi_1269_ = 0.002f;
                        }
                        let _e657 = phi_1269_;
                        phi_1270_ = _e657;
                    }
                    let _e659 = phi_1270_;
                    phi_1273_ = (_e429.point.depth - (0f * _e659));
                } else {
                    phi_1273_ = _e429.point.depth;
                }
                let _e663 = phi_1273_;
                let _e669 = p.member.map_size;
                let _e670 = f32(_e669);
                let _e673 = ((_e429.point.uv.x * _e670) - 0.5f);
                let _e674 = ((_e429.point.uv.y * _e670) - 0.5f);
                if (_e673 > -8388608f) {
                    let _e686 = f32(select(0i, select(select(i32(_e673), i32(-2147483648), (_e673 < bitcast<f32>(3472883712u))), 2147483647i, (_e673 > bitcast<f32>(1325400063u))), (_e673 == _e673)));
                    if (_e686 > _e673) {
                        phi_1302_ = 1f;
                    } else {
                        phi_1302_ = 0f;
                    }
                    let _e689 = phi_1302_;
                    if (_e673 < 8388608f) {
                        phi_1307_ = (_e686 - _e689);
                        phi_1308_ = false;
                    } else {
                        phi_1307_ = f32();
                        phi_1308_ = true;
                    }
                    let _e692 = phi_1307_;
                    let _e694 = phi_1308_;
                    phi_1309_ = _e692;
                    phi_1310_ = _e694;
                } else {
                    phi_1309_ = f32();
                    phi_1310_ = true;
                }
                let _e696 = phi_1309_;
                let _e698 = phi_1310_;
                if _e698 {
                    phi_1314_ = _e673;
                } else {
                    phi_1314_ = _e696;
                }
                let _e700 = phi_1314_;
                if (_e674 > -8388608f) {
                    let _e712 = f32(select(0i, select(select(i32(_e674), i32(-2147483648), (_e674 < bitcast<f32>(3472883712u))), 2147483647i, (_e674 > bitcast<f32>(1325400063u))), (_e674 == _e674)));
                    if (_e712 > _e674) {
                        phi_1334_ = 1f;
                    } else {
                        phi_1334_ = 0f;
                    }
                    let _e715 = phi_1334_;
                    if (_e674 < 8388608f) {
                        phi_1339_ = (_e712 - _e715);
                        phi_1340_ = false;
                    } else {
                        phi_1339_ = f32();
                        phi_1340_ = true;
                    }
                    let _e718 = phi_1339_;
                    let _e720 = phi_1340_;
                    phi_1341_ = _e718;
                    phi_1342_ = _e720;
                } else {
                    phi_1341_ = f32();
                    phi_1342_ = true;
                }
                let _e722 = phi_1341_;
                let _e724 = phi_1342_;
                if _e724 {
                    phi_1346_ = _e674;
                } else {
                    phi_1346_ = _e722;
                }
                let _e726 = phi_1346_;
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
                    phi_1395_ = _e737;
                } else {
                    phi_1395_ = 0i;
                }
                let _e770 = phi_1395_;
                if (_e746 > 0i) {
                    phi_1400_ = _e746;
                } else {
                    phi_1400_ = 0i;
                }
                let _e773 = phi_1400_;
                if (_e770 < _e767) {
                    phi_1405_ = _e770;
                } else {
                    phi_1405_ = _e767;
                }
                let _e776 = phi_1405_;
                if (_e773 < _e767) {
                    phi_1410_ = _e773;
                } else {
                    phi_1410_ = _e767;
                }
                let _e779 = phi_1410_;
                let _e780 = bitcast<u32>(_e776);
                let _e782 = (_e737 + 1i);
                let _e783 = (_e746 + 1i);
                if (_e782 > 0i) {
                    phi_1419_ = _e782;
                } else {
                    phi_1419_ = 0i;
                }
                let _e786 = phi_1419_;
                if (_e783 > 0i) {
                    phi_1424_ = _e783;
                } else {
                    phi_1424_ = 0i;
                }
                let _e789 = phi_1424_;
                if (_e786 < _e767) {
                    phi_1429_ = _e786;
                } else {
                    phi_1429_ = _e767;
                }
                let _e792 = phi_1429_;
                if (_e789 < _e767) {
                    phi_1434_ = _e789;
                } else {
                    phi_1434_ = _e767;
                }
                let _e795 = phi_1434_;
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
                phi_1479_ = evaluate_Verdict(_e825, false);
                phi_1480_ = evaluate_Verdict();
                phi_1481_ = false;
            } else {
                phi_1479_ = evaluate_Verdict();
                phi_1480_ = evaluate_Verdict(1f, false);
                phi_1481_ = true;
            }
            let _e829 = phi_1479_;
            let _e831 = phi_1480_;
            let _e833 = phi_1481_;
            phi_1482_ = _e831;
            phi_1483_ = _e829;
            phi_1484_ = _e833;
        }
        let _e835 = phi_1482_;
        let _e837 = phi_1483_;
        let _e839 = phi_1484_;
        if _e839 {
            phi_1488_ = _e835;
        } else {
            phi_1488_ = _e837;
        }
        let _e841 = phi_1488_;
        if (_e71.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e71.first_primitive)] = _e841.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_esm_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
