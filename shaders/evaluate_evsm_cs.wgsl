struct lt_math_LightProjection {
    row_x: vec4<f32>,
    row_y: vec4<f32>,
    row_z: vec4<f32>,
    row_w: vec4<f32>,
}

struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_17 {
    member: array<abi_Sample>,
}

struct type_21 {
    member: array<f32>,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
}

struct lt_math_Evsm {
    positive_exponent: f32,
    negative_exponent: f32,
    min_variance: f32,
}

struct abi_ShadowParams {
    projection: lt_math_LightProjection,
    light: vec4<f32>,
    test: vec4<f32>,
    size: vec2<u32>,
    map_size: u32,
    epsilon: f32,
    root: u32,
    pad0_: u32,
    pad1_: u32,
    pad2_: u32,
}

struct type_30 {
    member: abi_ShadowParams,
}

struct evaluate_Verdict {
    visibility: f32,
    is_doubted: bool,
}

struct u0028_evaluate_Verdict_u0020_bool_u0029_ {
    unnamed: evaluate_Verdict,
    unnamed_1: bool,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_17;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_30;
@group(0) @binding(2) 
var<storage> map: type_21;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_21;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_143_: lt_bvh_traverse_Tree;
    var phi_144_: bool;
    var phi_145_: lt_bvh_traverse_Tree;
    var phi_146_: bool;
    var phi_151_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_143_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_144_ = false;
        } else {
            phi_143_ = lt_bvh_traverse_Tree();
            phi_144_ = true;
        }
        let _e59 = phi_143_;
        let _e61 = phi_144_;
        phi_145_ = _e59;
        phi_146_ = _e61;
    } else {
        phi_145_ = lt_bvh_traverse_Tree();
        phi_146_ = true;
    }
    let _e63 = phi_145_;
    let _e65 = phi_146_;
    if _e65 {
        phi_151_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_151_ = _e63;
    }
    let _e70 = phi_151_;
    return lt_bvh_traverse_Tree(_e70.root, _e70.first_primitive);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> lt_math_Evsm {
    return lt_math_Evsm(param_3.x, param_3.y, param_3.z);
}

fn _lt_math_evsm_Evsm_positive(param_4: ptr<function, lt_math_Evsm>) -> f32 {
    var phi_175_: bool;
    var phi_179_: f32;

    let _e48 = (*param_4).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_175_ = true;
    } else {
        let _e52 = (42f < _e48);
        if _e52 {
        }
        phi_175_ = _e52;
    }
    let _e54 = phi_175_;
    if _e54 {
        phi_179_ = 42f;
    } else {
        phi_179_ = _e48;
    }
    let _e56 = phi_179_;
    return _e56;
}

fn _lt_math_evsm_Evsm_negative(param_5: ptr<function, lt_math_Evsm>) -> f32 {
    var phi_194_: bool;
    var phi_198_: f32;

    let _e48 = (*param_5).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_194_ = true;
    } else {
        let _e52 = (42f < _e48);
        if _e52 {
        }
        phi_194_ = _e52;
    }
    let _e54 = phi_194_;
    if _e54 {
        phi_198_ = 42f;
    } else {
        phi_198_ = _e48;
    }
    let _e56 = phi_198_;
    return _e56;
}

fn _lt_math_evsm_Evsm_bound_of_offsets(param_6: ptr<function, lt_math_Evsm>, param_7: vec4<f32>, param_8: vec4<f32>) -> f32 {
    var phi_816_: f32;
    var phi_821_: f32;
    var phi_843_: f32;
    var phi_848_: f32;
    var phi_849_: bool;
    var phi_850_: f32;
    var phi_851_: bool;
    var phi_855_: f32;
    var phi_893_: f32;
    var phi_904_: f32;
    var phi_909_: f32;
    var phi_931_: f32;
    var phi_936_: f32;
    var phi_937_: bool;
    var phi_938_: f32;
    var phi_939_: bool;
    var phi_943_: f32;
    var phi_981_: f32;
    var phi_992_: f32;
    var phi_997_: f32;
    var phi_1019_: f32;
    var phi_1024_: f32;
    var phi_1025_: bool;
    var phi_1026_: f32;
    var phi_1027_: bool;
    var phi_1031_: f32;
    var phi_1069_: f32;
    var phi_1080_: f32;
    var phi_1085_: f32;
    var phi_1107_: f32;
    var phi_1112_: f32;
    var phi_1113_: bool;
    var phi_1114_: f32;
    var phi_1115_: bool;
    var phi_1119_: f32;
    var phi_1157_: f32;
    var phi_1210_: bool;
    var phi_1214_: f32;
    var phi_1226_: bool;
    var phi_1233_: f32;
    var phi_1254_: f32;
    var phi_1259_: f32;
    var phi_1281_: f32;
    var phi_1286_: f32;
    var phi_1287_: bool;
    var phi_1288_: f32;
    var phi_1289_: bool;
    var phi_1293_: f32;
    var phi_1331_: f32;
    var phi_1342_: f32;
    var phi_1347_: f32;
    var phi_1369_: f32;
    var phi_1374_: f32;
    var phi_1375_: bool;
    var phi_1376_: f32;
    var phi_1377_: bool;
    var phi_1381_: f32;
    var phi_1419_: f32;
    var phi_1430_: f32;
    var phi_1435_: f32;
    var phi_1457_: f32;
    var phi_1462_: f32;
    var phi_1463_: bool;
    var phi_1464_: f32;
    var phi_1465_: bool;
    var phi_1469_: f32;
    var phi_1507_: f32;
    var phi_1518_: f32;
    var phi_1523_: f32;
    var phi_1545_: f32;
    var phi_1550_: f32;
    var phi_1551_: bool;
    var phi_1552_: f32;
    var phi_1553_: bool;
    var phi_1557_: f32;
    var phi_1595_: f32;
    var phi_1648_: bool;
    var phi_1652_: f32;
    var phi_1664_: bool;
    var phi_1671_: f32;
    var phi_1682_: bool;
    var phi_1686_: f32;
    var phi_1701_: f32;
    var phi_1702_: f32;
    var phi_1703_: f32;

    let _e49 = _lt_math_evsm_Evsm_positive(param_6);
    let _e51 = (_e49 * param_7.x);
    let _e53 = (_e49 * param_7.y);
    let _e55 = (_e49 * param_7.z);
    let _e57 = (_e49 * param_7.w);
    if ((bitcast<u32>(_e51) & 2147483647u) > 2139095040u) {
        phi_893_ = _e51;
    } else {
        if (_e51 < -87f) {
            phi_816_ = -87f;
        } else {
            phi_816_ = _e51;
        }
        let _e63 = phi_816_;
        if (_e63 > 88f) {
            phi_821_ = 88f;
        } else {
            phi_821_ = _e63;
        }
        let _e66 = phi_821_;
        let _e68 = ((_e66 * 1.442695f) + 0.5f);
        if (_e68 > -8388608f) {
            let _e80 = f32(select(0i, select(select(i32(_e68), i32(-2147483648), (_e68 < bitcast<f32>(3472883712u))), 2147483647i, (_e68 > bitcast<f32>(1325400063u))), (_e68 == _e68)));
            if (_e80 > _e68) {
                phi_843_ = 1f;
            } else {
                phi_843_ = 0f;
            }
            let _e83 = phi_843_;
            if (_e68 < 8388608f) {
                phi_848_ = (_e80 - _e83);
                phi_849_ = false;
            } else {
                phi_848_ = f32();
                phi_849_ = true;
            }
            let _e86 = phi_848_;
            let _e88 = phi_849_;
            phi_850_ = _e86;
            phi_851_ = _e88;
        } else {
            phi_850_ = f32();
            phi_851_ = true;
        }
        let _e90 = phi_850_;
        let _e92 = phi_851_;
        if _e92 {
            phi_855_ = _e68;
        } else {
            phi_855_ = _e90;
        }
        let _e94 = phi_855_;
        let _e98 = ((_e66 - (_e94 * 0.69314575f)) - (_e94 * 0.0000014286068f));
        phi_893_ = ((((((((((((((((1f / 5040f) * _e98) + (1f / 720f)) * _e98) + (1f / 120f)) * _e98) + (1f / 24f)) * _e98) + (1f / 6f)) * _e98) + 0.5f) * _e98) + 1f) * _e98) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e94), i32(-2147483648), (_e94 < bitcast<f32>(3472883712u))), 2147483647i, (_e94 > bitcast<f32>(1325400063u))), (_e94 == _e94)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e134 = phi_893_;
    if ((bitcast<u32>(_e53) & 2147483647u) > 2139095040u) {
        phi_981_ = _e53;
    } else {
        if (_e53 < -87f) {
            phi_904_ = -87f;
        } else {
            phi_904_ = _e53;
        }
        let _e140 = phi_904_;
        if (_e140 > 88f) {
            phi_909_ = 88f;
        } else {
            phi_909_ = _e140;
        }
        let _e143 = phi_909_;
        let _e145 = ((_e143 * 1.442695f) + 0.5f);
        if (_e145 > -8388608f) {
            let _e157 = f32(select(0i, select(select(i32(_e145), i32(-2147483648), (_e145 < bitcast<f32>(3472883712u))), 2147483647i, (_e145 > bitcast<f32>(1325400063u))), (_e145 == _e145)));
            if (_e157 > _e145) {
                phi_931_ = 1f;
            } else {
                phi_931_ = 0f;
            }
            let _e160 = phi_931_;
            if (_e145 < 8388608f) {
                phi_936_ = (_e157 - _e160);
                phi_937_ = false;
            } else {
                phi_936_ = f32();
                phi_937_ = true;
            }
            let _e163 = phi_936_;
            let _e165 = phi_937_;
            phi_938_ = _e163;
            phi_939_ = _e165;
        } else {
            phi_938_ = f32();
            phi_939_ = true;
        }
        let _e167 = phi_938_;
        let _e169 = phi_939_;
        if _e169 {
            phi_943_ = _e145;
        } else {
            phi_943_ = _e167;
        }
        let _e171 = phi_943_;
        let _e175 = ((_e143 - (_e171 * 0.69314575f)) - (_e171 * 0.0000014286068f));
        phi_981_ = ((((((((((((((((1f / 5040f) * _e175) + (1f / 720f)) * _e175) + (1f / 120f)) * _e175) + (1f / 24f)) * _e175) + (1f / 6f)) * _e175) + 0.5f) * _e175) + 1f) * _e175) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e171), i32(-2147483648), (_e171 < bitcast<f32>(3472883712u))), 2147483647i, (_e171 > bitcast<f32>(1325400063u))), (_e171 == _e171)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e211 = phi_981_;
    if ((bitcast<u32>(_e55) & 2147483647u) > 2139095040u) {
        phi_1069_ = _e55;
    } else {
        if (_e55 < -87f) {
            phi_992_ = -87f;
        } else {
            phi_992_ = _e55;
        }
        let _e217 = phi_992_;
        if (_e217 > 88f) {
            phi_997_ = 88f;
        } else {
            phi_997_ = _e217;
        }
        let _e220 = phi_997_;
        let _e222 = ((_e220 * 1.442695f) + 0.5f);
        if (_e222 > -8388608f) {
            let _e234 = f32(select(0i, select(select(i32(_e222), i32(-2147483648), (_e222 < bitcast<f32>(3472883712u))), 2147483647i, (_e222 > bitcast<f32>(1325400063u))), (_e222 == _e222)));
            if (_e234 > _e222) {
                phi_1019_ = 1f;
            } else {
                phi_1019_ = 0f;
            }
            let _e237 = phi_1019_;
            if (_e222 < 8388608f) {
                phi_1024_ = (_e234 - _e237);
                phi_1025_ = false;
            } else {
                phi_1024_ = f32();
                phi_1025_ = true;
            }
            let _e240 = phi_1024_;
            let _e242 = phi_1025_;
            phi_1026_ = _e240;
            phi_1027_ = _e242;
        } else {
            phi_1026_ = f32();
            phi_1027_ = true;
        }
        let _e244 = phi_1026_;
        let _e246 = phi_1027_;
        if _e246 {
            phi_1031_ = _e222;
        } else {
            phi_1031_ = _e244;
        }
        let _e248 = phi_1031_;
        let _e252 = ((_e220 - (_e248 * 0.69314575f)) - (_e248 * 0.0000014286068f));
        phi_1069_ = ((((((((((((((((1f / 5040f) * _e252) + (1f / 720f)) * _e252) + (1f / 120f)) * _e252) + (1f / 24f)) * _e252) + (1f / 6f)) * _e252) + 0.5f) * _e252) + 1f) * _e252) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e248), i32(-2147483648), (_e248 < bitcast<f32>(3472883712u))), 2147483647i, (_e248 > bitcast<f32>(1325400063u))), (_e248 == _e248)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e288 = phi_1069_;
    if ((bitcast<u32>(_e57) & 2147483647u) > 2139095040u) {
        phi_1157_ = _e57;
    } else {
        if (_e57 < -87f) {
            phi_1080_ = -87f;
        } else {
            phi_1080_ = _e57;
        }
        let _e294 = phi_1080_;
        if (_e294 > 88f) {
            phi_1085_ = 88f;
        } else {
            phi_1085_ = _e294;
        }
        let _e297 = phi_1085_;
        let _e299 = ((_e297 * 1.442695f) + 0.5f);
        if (_e299 > -8388608f) {
            let _e311 = f32(select(0i, select(select(i32(_e299), i32(-2147483648), (_e299 < bitcast<f32>(3472883712u))), 2147483647i, (_e299 > bitcast<f32>(1325400063u))), (_e299 == _e299)));
            if (_e311 > _e299) {
                phi_1107_ = 1f;
            } else {
                phi_1107_ = 0f;
            }
            let _e314 = phi_1107_;
            if (_e299 < 8388608f) {
                phi_1112_ = (_e311 - _e314);
                phi_1113_ = false;
            } else {
                phi_1112_ = f32();
                phi_1113_ = true;
            }
            let _e317 = phi_1112_;
            let _e319 = phi_1113_;
            phi_1114_ = _e317;
            phi_1115_ = _e319;
        } else {
            phi_1114_ = f32();
            phi_1115_ = true;
        }
        let _e321 = phi_1114_;
        let _e323 = phi_1115_;
        if _e323 {
            phi_1119_ = _e299;
        } else {
            phi_1119_ = _e321;
        }
        let _e325 = phi_1119_;
        let _e329 = ((_e297 - (_e325 * 0.69314575f)) - (_e325 * 0.0000014286068f));
        phi_1157_ = ((((((((((((((((1f / 5040f) * _e329) + (1f / 720f)) * _e329) + (1f / 120f)) * _e329) + (1f / 24f)) * _e329) + (1f / 6f)) * _e329) + 0.5f) * _e329) + 1f) * _e329) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e325), i32(-2147483648), (_e325 < bitcast<f32>(3472883712u))), 2147483647i, (_e325 > bitcast<f32>(1325400063u))), (_e325 == _e325)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e365 = phi_1157_;
    let _e367 = (_e134 - vec4<f32>(1f, 1f, 1f, 1f).x);
    let _e369 = (_e211 - vec4<f32>(1f, 1f, 1f, 1f).y);
    let _e371 = (_e288 - vec4<f32>(1f, 1f, 1f, 1f).z);
    let _e373 = (_e365 - vec4<f32>(1f, 1f, 1f, 1f).w);
    let _e375 = (*param_6).min_variance;
    let _e377 = ((_e375 * _e49) * _e49);
    let _e388 = ((((_e367 * param_8.x) + (_e369 * param_8.y)) + (_e371 * param_8.z)) + (_e373 * param_8.w));
    let _e389 = (_e367 - _e388);
    let _e390 = (_e369 - _e388);
    let _e391 = (_e371 - _e388);
    let _e392 = (_e373 - _e388);
    let _e407 = (((((_e389 * _e389) * param_8.x) + ((_e390 * _e390) * param_8.y)) + ((_e391 * _e391) * param_8.z)) + ((_e392 * _e392) * param_8.w));
    if ((bitcast<u32>(_e377) & 2147483647u) > 2139095040u) {
        phi_1210_ = true;
    } else {
        let _e411 = (_e377 > _e407);
        if _e411 {
        }
        phi_1210_ = _e411;
    }
    let _e413 = phi_1210_;
    if _e413 {
        phi_1214_ = _e377;
    } else {
        phi_1214_ = _e407;
    }
    let _e415 = phi_1214_;
    let _e416 = -(_e388);
    if (_e416 <= 0f) {
        let _e420 = ((bitcast<u32>(_e415) & 2147483647u) > 2139095040u);
        if _e420 {
        }
        phi_1226_ = _e420;
    } else {
        phi_1226_ = true;
    }
    let _e422 = phi_1226_;
    if _e422 {
        phi_1233_ = (_e415 / (_e415 + (_e416 * _e416)));
    } else {
        phi_1233_ = 1f;
    }
    let _e427 = phi_1233_;
    let _e428 = _lt_math_evsm_Evsm_negative(param_6);
    let _e429 = -(_e428);
    let _e431 = (_e429 * param_7.x);
    let _e433 = (_e429 * param_7.y);
    let _e435 = (_e429 * param_7.z);
    let _e437 = (_e429 * param_7.w);
    if ((bitcast<u32>(_e431) & 2147483647u) > 2139095040u) {
        phi_1331_ = _e431;
    } else {
        if (_e431 < -87f) {
            phi_1254_ = -87f;
        } else {
            phi_1254_ = _e431;
        }
        let _e443 = phi_1254_;
        if (_e443 > 88f) {
            phi_1259_ = 88f;
        } else {
            phi_1259_ = _e443;
        }
        let _e446 = phi_1259_;
        let _e448 = ((_e446 * 1.442695f) + 0.5f);
        if (_e448 > -8388608f) {
            let _e460 = f32(select(0i, select(select(i32(_e448), i32(-2147483648), (_e448 < bitcast<f32>(3472883712u))), 2147483647i, (_e448 > bitcast<f32>(1325400063u))), (_e448 == _e448)));
            if (_e460 > _e448) {
                phi_1281_ = 1f;
            } else {
                phi_1281_ = 0f;
            }
            let _e463 = phi_1281_;
            if (_e448 < 8388608f) {
                phi_1286_ = (_e460 - _e463);
                phi_1287_ = false;
            } else {
                phi_1286_ = f32();
                phi_1287_ = true;
            }
            let _e466 = phi_1286_;
            let _e468 = phi_1287_;
            phi_1288_ = _e466;
            phi_1289_ = _e468;
        } else {
            phi_1288_ = f32();
            phi_1289_ = true;
        }
        let _e470 = phi_1288_;
        let _e472 = phi_1289_;
        if _e472 {
            phi_1293_ = _e448;
        } else {
            phi_1293_ = _e470;
        }
        let _e474 = phi_1293_;
        let _e478 = ((_e446 - (_e474 * 0.69314575f)) - (_e474 * 0.0000014286068f));
        phi_1331_ = ((((((((((((((((1f / 5040f) * _e478) + (1f / 720f)) * _e478) + (1f / 120f)) * _e478) + (1f / 24f)) * _e478) + (1f / 6f)) * _e478) + 0.5f) * _e478) + 1f) * _e478) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e474), i32(-2147483648), (_e474 < bitcast<f32>(3472883712u))), 2147483647i, (_e474 > bitcast<f32>(1325400063u))), (_e474 == _e474)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e514 = phi_1331_;
    if ((bitcast<u32>(_e433) & 2147483647u) > 2139095040u) {
        phi_1419_ = _e433;
    } else {
        if (_e433 < -87f) {
            phi_1342_ = -87f;
        } else {
            phi_1342_ = _e433;
        }
        let _e520 = phi_1342_;
        if (_e520 > 88f) {
            phi_1347_ = 88f;
        } else {
            phi_1347_ = _e520;
        }
        let _e523 = phi_1347_;
        let _e525 = ((_e523 * 1.442695f) + 0.5f);
        if (_e525 > -8388608f) {
            let _e537 = f32(select(0i, select(select(i32(_e525), i32(-2147483648), (_e525 < bitcast<f32>(3472883712u))), 2147483647i, (_e525 > bitcast<f32>(1325400063u))), (_e525 == _e525)));
            if (_e537 > _e525) {
                phi_1369_ = 1f;
            } else {
                phi_1369_ = 0f;
            }
            let _e540 = phi_1369_;
            if (_e525 < 8388608f) {
                phi_1374_ = (_e537 - _e540);
                phi_1375_ = false;
            } else {
                phi_1374_ = f32();
                phi_1375_ = true;
            }
            let _e543 = phi_1374_;
            let _e545 = phi_1375_;
            phi_1376_ = _e543;
            phi_1377_ = _e545;
        } else {
            phi_1376_ = f32();
            phi_1377_ = true;
        }
        let _e547 = phi_1376_;
        let _e549 = phi_1377_;
        if _e549 {
            phi_1381_ = _e525;
        } else {
            phi_1381_ = _e547;
        }
        let _e551 = phi_1381_;
        let _e555 = ((_e523 - (_e551 * 0.69314575f)) - (_e551 * 0.0000014286068f));
        phi_1419_ = ((((((((((((((((1f / 5040f) * _e555) + (1f / 720f)) * _e555) + (1f / 120f)) * _e555) + (1f / 24f)) * _e555) + (1f / 6f)) * _e555) + 0.5f) * _e555) + 1f) * _e555) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e551), i32(-2147483648), (_e551 < bitcast<f32>(3472883712u))), 2147483647i, (_e551 > bitcast<f32>(1325400063u))), (_e551 == _e551)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e591 = phi_1419_;
    if ((bitcast<u32>(_e435) & 2147483647u) > 2139095040u) {
        phi_1507_ = _e435;
    } else {
        if (_e435 < -87f) {
            phi_1430_ = -87f;
        } else {
            phi_1430_ = _e435;
        }
        let _e597 = phi_1430_;
        if (_e597 > 88f) {
            phi_1435_ = 88f;
        } else {
            phi_1435_ = _e597;
        }
        let _e600 = phi_1435_;
        let _e602 = ((_e600 * 1.442695f) + 0.5f);
        if (_e602 > -8388608f) {
            let _e614 = f32(select(0i, select(select(i32(_e602), i32(-2147483648), (_e602 < bitcast<f32>(3472883712u))), 2147483647i, (_e602 > bitcast<f32>(1325400063u))), (_e602 == _e602)));
            if (_e614 > _e602) {
                phi_1457_ = 1f;
            } else {
                phi_1457_ = 0f;
            }
            let _e617 = phi_1457_;
            if (_e602 < 8388608f) {
                phi_1462_ = (_e614 - _e617);
                phi_1463_ = false;
            } else {
                phi_1462_ = f32();
                phi_1463_ = true;
            }
            let _e620 = phi_1462_;
            let _e622 = phi_1463_;
            phi_1464_ = _e620;
            phi_1465_ = _e622;
        } else {
            phi_1464_ = f32();
            phi_1465_ = true;
        }
        let _e624 = phi_1464_;
        let _e626 = phi_1465_;
        if _e626 {
            phi_1469_ = _e602;
        } else {
            phi_1469_ = _e624;
        }
        let _e628 = phi_1469_;
        let _e632 = ((_e600 - (_e628 * 0.69314575f)) - (_e628 * 0.0000014286068f));
        phi_1507_ = ((((((((((((((((1f / 5040f) * _e632) + (1f / 720f)) * _e632) + (1f / 120f)) * _e632) + (1f / 24f)) * _e632) + (1f / 6f)) * _e632) + 0.5f) * _e632) + 1f) * _e632) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e628), i32(-2147483648), (_e628 < bitcast<f32>(3472883712u))), 2147483647i, (_e628 > bitcast<f32>(1325400063u))), (_e628 == _e628)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e668 = phi_1507_;
    if ((bitcast<u32>(_e437) & 2147483647u) > 2139095040u) {
        phi_1595_ = _e437;
    } else {
        if (_e437 < -87f) {
            phi_1518_ = -87f;
        } else {
            phi_1518_ = _e437;
        }
        let _e674 = phi_1518_;
        if (_e674 > 88f) {
            phi_1523_ = 88f;
        } else {
            phi_1523_ = _e674;
        }
        let _e677 = phi_1523_;
        let _e679 = ((_e677 * 1.442695f) + 0.5f);
        if (_e679 > -8388608f) {
            let _e691 = f32(select(0i, select(select(i32(_e679), i32(-2147483648), (_e679 < bitcast<f32>(3472883712u))), 2147483647i, (_e679 > bitcast<f32>(1325400063u))), (_e679 == _e679)));
            if (_e691 > _e679) {
                phi_1545_ = 1f;
            } else {
                phi_1545_ = 0f;
            }
            let _e694 = phi_1545_;
            if (_e679 < 8388608f) {
                phi_1550_ = (_e691 - _e694);
                phi_1551_ = false;
            } else {
                phi_1550_ = f32();
                phi_1551_ = true;
            }
            let _e697 = phi_1550_;
            let _e699 = phi_1551_;
            phi_1552_ = _e697;
            phi_1553_ = _e699;
        } else {
            phi_1552_ = f32();
            phi_1553_ = true;
        }
        let _e701 = phi_1552_;
        let _e703 = phi_1553_;
        if _e703 {
            phi_1557_ = _e679;
        } else {
            phi_1557_ = _e701;
        }
        let _e705 = phi_1557_;
        let _e709 = ((_e677 - (_e705 * 0.69314575f)) - (_e705 * 0.0000014286068f));
        phi_1595_ = ((((((((((((((((1f / 5040f) * _e709) + (1f / 720f)) * _e709) + (1f / 120f)) * _e709) + (1f / 24f)) * _e709) + (1f / 6f)) * _e709) + 0.5f) * _e709) + 1f) * _e709) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e705), i32(-2147483648), (_e705 < bitcast<f32>(3472883712u))), 2147483647i, (_e705 > bitcast<f32>(1325400063u))), (_e705 == _e705)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e745 = phi_1595_;
    let _e747 = (vec4<f32>(1f, 1f, 1f, 1f).x - _e514);
    let _e749 = (vec4<f32>(1f, 1f, 1f, 1f).y - _e591);
    let _e751 = (vec4<f32>(1f, 1f, 1f, 1f).z - _e668);
    let _e753 = (vec4<f32>(1f, 1f, 1f, 1f).w - _e745);
    let _e755 = (*param_6).min_variance;
    let _e757 = ((_e755 * _e428) * _e428);
    let _e768 = ((((_e747 * param_8.x) + (_e749 * param_8.y)) + (_e751 * param_8.z)) + (_e753 * param_8.w));
    let _e769 = (_e747 - _e768);
    let _e770 = (_e749 - _e768);
    let _e771 = (_e751 - _e768);
    let _e772 = (_e753 - _e768);
    let _e787 = (((((_e769 * _e769) * param_8.x) + ((_e770 * _e770) * param_8.y)) + ((_e771 * _e771) * param_8.z)) + ((_e772 * _e772) * param_8.w));
    if ((bitcast<u32>(_e757) & 2147483647u) > 2139095040u) {
        phi_1648_ = true;
    } else {
        let _e791 = (_e757 > _e787);
        if _e791 {
        }
        phi_1648_ = _e791;
    }
    let _e793 = phi_1648_;
    if _e793 {
        phi_1652_ = _e757;
    } else {
        phi_1652_ = _e787;
    }
    let _e795 = phi_1652_;
    let _e796 = -(_e768);
    if (_e796 <= 0f) {
        let _e800 = ((bitcast<u32>(_e795) & 2147483647u) > 2139095040u);
        if _e800 {
        }
        phi_1664_ = _e800;
    } else {
        phi_1664_ = true;
    }
    let _e802 = phi_1664_;
    if _e802 {
        phi_1671_ = (_e795 / (_e795 + (_e796 * _e796)));
    } else {
        phi_1671_ = 1f;
    }
    let _e807 = phi_1671_;
    if ((bitcast<u32>(_e807) & 2147483647u) > 2139095040u) {
        phi_1682_ = true;
    } else {
        let _e811 = (_e807 < _e427);
        if _e811 {
        }
        phi_1682_ = _e811;
    }
    let _e813 = phi_1682_;
    if _e813 {
        phi_1686_ = _e807;
    } else {
        phi_1686_ = _e427;
    }
    let _e815 = phi_1686_;
    if ((bitcast<u32>(_e815) & 2147483647u) > 2139095040u) {
        phi_1703_ = _e815;
    } else {
        if (_e815 < 0f) {
            phi_1702_ = 0f;
        } else {
            if (_e815 > 1f) {
                phi_1701_ = 1f;
            } else {
                phi_1701_ = _e815;
            }
            let _e822 = phi_1701_;
            phi_1702_ = _e822;
        }
        let _e824 = phi_1702_;
        phi_1703_ = _e824;
    }
    let _e826 = phi_1703_;
    return _e826;
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_9: ptr<function, lt_math_Evsm>, param_10: vec4<f32>, param_11: vec4<f32>, param_12: f32) -> f32 {
    var phi_658_: f32;
    var phi_659_: f32;
    var phi_660_: f32;
    var phi_676_: f32;
    var phi_677_: f32;
    var phi_678_: f32;
    var phi_694_: f32;
    var phi_695_: f32;
    var phi_696_: f32;
    var phi_712_: f32;
    var phi_713_: f32;
    var phi_714_: f32;
    var phi_730_: f32;
    var phi_731_: f32;
    var phi_732_: f32;
    var phi_769_: bool;
    var phi_770_: bool;
    var phi_771_: bool;
    var phi_772_: bool;
    var phi_773_: bool;
    var phi_774_: bool;
    var phi_775_: bool;
    var phi_776_: bool;
    var phi_777_: bool;
    var phi_778_: bool;
    var phi_779_: bool;
    var phi_783_: bool;
    var phi_787_: bool;
    var phi_792_: f32;

    if ((bitcast<u32>(param_12) & 2147483647u) > 2139095040u) {
        phi_660_ = param_12;
    } else {
        if (param_12 < 0f) {
            phi_659_ = 0f;
        } else {
            if (param_12 > 1f) {
                phi_658_ = 1f;
            } else {
                phi_658_ = param_12;
            }
            let _e56 = phi_658_;
            phi_659_ = _e56;
        }
        let _e58 = phi_659_;
        phi_660_ = _e58;
    }
    let _e60 = phi_660_;
    if ((bitcast<u32>(param_10.x) & 2147483647u) > 2139095040u) {
        phi_678_ = param_10.x;
    } else {
        if (param_10.x < 0f) {
            phi_677_ = 0f;
        } else {
            if (param_10.x > 1f) {
                phi_676_ = 1f;
            } else {
                phi_676_ = param_10.x;
            }
            let _e68 = phi_676_;
            phi_677_ = _e68;
        }
        let _e70 = phi_677_;
        phi_678_ = _e70;
    }
    let _e72 = phi_678_;
    if ((bitcast<u32>(param_10.y) & 2147483647u) > 2139095040u) {
        phi_696_ = param_10.y;
    } else {
        if (param_10.y < 0f) {
            phi_695_ = 0f;
        } else {
            if (param_10.y > 1f) {
                phi_694_ = 1f;
            } else {
                phi_694_ = param_10.y;
            }
            let _e80 = phi_694_;
            phi_695_ = _e80;
        }
        let _e82 = phi_695_;
        phi_696_ = _e82;
    }
    let _e84 = phi_696_;
    if ((bitcast<u32>(param_10.z) & 2147483647u) > 2139095040u) {
        phi_714_ = param_10.z;
    } else {
        if (param_10.z < 0f) {
            phi_713_ = 0f;
        } else {
            if (param_10.z > 1f) {
                phi_712_ = 1f;
            } else {
                phi_712_ = param_10.z;
            }
            let _e92 = phi_712_;
            phi_713_ = _e92;
        }
        let _e94 = phi_713_;
        phi_714_ = _e94;
    }
    let _e96 = phi_714_;
    if ((bitcast<u32>(param_10.w) & 2147483647u) > 2139095040u) {
        phi_732_ = param_10.w;
    } else {
        if (param_10.w < 0f) {
            phi_731_ = 0f;
        } else {
            if (param_10.w > 1f) {
                phi_730_ = 1f;
            } else {
                phi_730_ = param_10.w;
            }
            let _e104 = phi_730_;
            phi_731_ = _e104;
        }
        let _e106 = phi_731_;
        phi_732_ = _e106;
    }
    let _e108 = phi_732_;
    let _e109 = (_e72 - _e60);
    let _e110 = (_e84 - _e60);
    let _e111 = (_e96 - _e60);
    let _e112 = (_e108 - _e60);
    if (_e109 >= 0f) {
        if (_e110 >= 0f) {
            if (_e111 >= 0f) {
                if (_e112 >= 0f) {
                    phi_769_ = !(((bitcast<u32>(((((_e109 * param_11.x) + (_e110 * param_11.y)) + (_e111 * param_11.z)) + (_e112 * param_11.w))) & 2147483647u) > 2139095040u));
                    phi_770_ = false;
                } else {
                    phi_769_ = bool();
                    phi_770_ = true;
                }
                let _e134 = phi_769_;
                let _e136 = phi_770_;
                phi_771_ = _e134;
                phi_772_ = false;
                phi_773_ = _e136;
            } else {
                phi_771_ = bool();
                phi_772_ = true;
                phi_773_ = false;
            }
            let _e138 = phi_771_;
            let _e140 = phi_772_;
            let _e142 = phi_773_;
            phi_774_ = _e138;
            phi_775_ = _e140;
            phi_776_ = _e142;
        } else {
            phi_774_ = bool();
            phi_775_ = true;
            phi_776_ = false;
        }
        let _e144 = phi_774_;
        let _e146 = phi_775_;
        let _e148 = phi_776_;
        phi_777_ = _e144;
        phi_778_ = _e146;
        phi_779_ = _e148;
    } else {
        phi_777_ = bool();
        phi_778_ = true;
        phi_779_ = false;
    }
    let _e150 = phi_777_;
    let _e152 = phi_778_;
    let _e154 = phi_779_;
    if _e152 {
        phi_783_ = true;
    } else {
        phi_783_ = _e154;
    }
    let _e156 = phi_783_;
    if _e156 {
        phi_787_ = false;
    } else {
        phi_787_ = _e150;
    }
    let _e158 = phi_787_;
    if _e158 {
        phi_792_ = 1f;
    } else {
        let _e159 = _lt_math_evsm_Evsm_bound_of_offsets(param_9, vec4<f32>(_e109, _e110, _e111, _e112), param_11);
        phi_792_ = _e159;
    }
    let _e161 = phi_792_;
    return _e161;
}

fn function_() {
    var local: lt_math_Evsm;
    var phi_252_: bool;
    var phi_253_: bool;
    var phi_254_: bool;
    var phi_255_: bool;
    var phi_259_: bool;
    var phi_303_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_307_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_384_: bool;
    var phi_393_: bool;
    var phi_402_: bool;
    var phi_403_: bool;
    var phi_404_: bool;
    var phi_405_: bool;
    var phi_406_: bool;
    var phi_407_: bool;
    var phi_408_: bool;
    var phi_412_: bool;
    var phi_448_: f32;
    var phi_453_: f32;
    var phi_454_: bool;
    var phi_455_: f32;
    var phi_456_: bool;
    var phi_460_: f32;
    var phi_480_: f32;
    var phi_485_: f32;
    var phi_486_: bool;
    var phi_487_: f32;
    var phi_488_: bool;
    var phi_492_: f32;
    var phi_542_: i32;
    var phi_547_: i32;
    var phi_552_: i32;
    var phi_557_: i32;
    var phi_566_: i32;
    var phi_571_: i32;
    var phi_576_: i32;
    var phi_581_: i32;
    var phi_622_: evaluate_Verdict;
    var phi_623_: evaluate_Verdict;
    var phi_624_: bool;
    var phi_625_: evaluate_Verdict;
    var phi_626_: evaluate_Verdict;
    var phi_627_: bool;
    var phi_631_: evaluate_Verdict;

    let _e47 = id_1;
    let _e54 = arrayLength((&map.member));
    let _e60 = p.member.size[0u];
    let _e62 = p.member.size[1u];
    let _e63 = lt_shaders_entry_pixel_index(_e47, _e60, _e62);
    if (bitcast<i32>(_e63.root) != 0i) {
        if (_e63.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e72 = p.member.light;
        let _e75 = samples.member[(0u + _e63.first_primitive)].normal[0u];
        let _e77 = global[0u];
        if (_e75 == _e77) {
            let _e80 = samples.member[(0u + _e63.first_primitive)].normal[1u];
            let _e82 = global[1u];
            if (_e80 == _e82) {
                let _e85 = samples.member[(0u + _e63.first_primitive)].normal[2u];
                let _e87 = global[2u];
                phi_252_ = (_e85 == _e87);
                phi_253_ = false;
            } else {
                phi_252_ = bool();
                phi_253_ = true;
            }
            let _e90 = phi_252_;
            let _e92 = phi_253_;
            phi_254_ = _e90;
            phi_255_ = _e92;
        } else {
            phi_254_ = bool();
            phi_255_ = true;
        }
        let _e94 = phi_254_;
        let _e96 = phi_255_;
        if _e96 {
            phi_259_ = false;
        } else {
            phi_259_ = _e94;
        }
        let _e98 = phi_259_;
        if !(_e98) {
            let _e101 = samples.member[(0u + _e63.first_primitive)].normal;
            let _e103 = samples.member[(0u + _e63.first_primitive)].position;
            if ((((_e101.x * (_e72.x - (_e103.x * _e72.w))) + (_e101.y * (_e72.y - (_e103.y * _e72.w)))) + (_e101.z * (_e72.z - (_e103.z * _e72.w)))) > 0f) {
                let _e127 = samples.member[(0u + _e63.first_primitive)].flags;
                let _e135 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e141 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e135.unnamed.visibility, false), _e135.unnamed_1);
                phi_303_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e141.unnamed, ((_e127 & 1u) == 0u));
            } else {
                let _e150 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e156 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e150.unnamed.visibility, false), _e150.unnamed_1);
                phi_303_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e156.unnamed, true);
            }
            let _e161 = phi_303_;
            phi_307_ = _e161;
        } else {
            let _e167 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e173 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e167.unnamed.visibility, false), _e167.unnamed_1);
            phi_307_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e173.unnamed, true);
        }
        let _e178 = phi_307_;
        if _e178.unnamed_1 {
            phi_625_ = evaluate_Verdict(_e178.unnamed.visibility, _e178.unnamed.is_doubted);
            phi_626_ = evaluate_Verdict();
            phi_627_ = true;
        } else {
            let _e186 = samples.member[(0u + _e63.first_primitive)].position;
            let _e192 = p.member.projection.row_w;
            let _e203 = ((((_e192.x * _e186.x) + (_e192.y * _e186.y)) + (_e192.z * _e186.z)) + (_e192.w * 1f));
            let _e205 = p.member.projection.row_x;
            let _e217 = (((((_e205.x * _e186.x) + (_e205.y * _e186.y)) + (_e205.z * _e186.z)) + (_e205.w * 1f)) / _e203);
            let _e219 = p.member.projection.row_y;
            let _e231 = (((((_e219.x * _e186.x) + (_e219.y * _e186.y)) + (_e219.z * _e186.z)) + (_e219.w * 1f)) / _e203);
            let _e233 = p.member.projection.row_z;
            let _e244 = ((((_e233.x * _e186.x) + (_e233.y * _e186.y)) + (_e233.z * _e186.z)) + (_e233.w * 1f));
            if (_e203 > 0f) {
                if (_e217 >= 0f) {
                    phi_384_ = (_e217 <= 1f);
                } else {
                    phi_384_ = false;
                }
                let _e249 = phi_384_;
                if _e249 {
                    if (_e231 >= 0f) {
                        phi_393_ = (_e231 <= 1f);
                    } else {
                        phi_393_ = false;
                    }
                    let _e253 = phi_393_;
                    if _e253 {
                        if (_e244 >= 0f) {
                            phi_402_ = (_e244 <= 1f);
                        } else {
                            phi_402_ = false;
                        }
                        let _e257 = phi_402_;
                        phi_403_ = _e257;
                        phi_404_ = false;
                    } else {
                        phi_403_ = bool();
                        phi_404_ = true;
                    }
                    let _e259 = phi_403_;
                    let _e261 = phi_404_;
                    phi_405_ = _e259;
                    phi_406_ = _e261;
                } else {
                    phi_405_ = bool();
                    phi_406_ = true;
                }
                let _e263 = phi_405_;
                let _e265 = phi_406_;
                phi_407_ = _e263;
                phi_408_ = _e265;
            } else {
                phi_407_ = bool();
                phi_408_ = true;
            }
            let _e267 = phi_407_;
            let _e269 = phi_408_;
            if _e269 {
                phi_412_ = false;
            } else {
                phi_412_ = _e267;
            }
            let _e271 = phi_412_;
            if _e271 {
                let _e273 = p.member.map_size;
                let _e274 = f32(_e273);
                let _e277 = ((_e217 * _e274) - 0.5f);
                let _e278 = ((_e231 * _e274) - 0.5f);
                if (_e277 > -8388608f) {
                    let _e290 = f32(select(0i, select(select(i32(_e277), i32(-2147483648), (_e277 < bitcast<f32>(3472883712u))), 2147483647i, (_e277 > bitcast<f32>(1325400063u))), (_e277 == _e277)));
                    if (_e290 > _e277) {
                        phi_448_ = 1f;
                    } else {
                        phi_448_ = 0f;
                    }
                    let _e293 = phi_448_;
                    if (_e277 < 8388608f) {
                        phi_453_ = (_e290 - _e293);
                        phi_454_ = false;
                    } else {
                        phi_453_ = f32();
                        phi_454_ = true;
                    }
                    let _e296 = phi_453_;
                    let _e298 = phi_454_;
                    phi_455_ = _e296;
                    phi_456_ = _e298;
                } else {
                    phi_455_ = f32();
                    phi_456_ = true;
                }
                let _e300 = phi_455_;
                let _e302 = phi_456_;
                if _e302 {
                    phi_460_ = _e277;
                } else {
                    phi_460_ = _e300;
                }
                let _e304 = phi_460_;
                if (_e278 > -8388608f) {
                    let _e316 = f32(select(0i, select(select(i32(_e278), i32(-2147483648), (_e278 < bitcast<f32>(3472883712u))), 2147483647i, (_e278 > bitcast<f32>(1325400063u))), (_e278 == _e278)));
                    if (_e316 > _e278) {
                        phi_480_ = 1f;
                    } else {
                        phi_480_ = 0f;
                    }
                    let _e319 = phi_480_;
                    if (_e278 < 8388608f) {
                        phi_485_ = (_e316 - _e319);
                        phi_486_ = false;
                    } else {
                        phi_485_ = f32();
                        phi_486_ = true;
                    }
                    let _e322 = phi_485_;
                    let _e324 = phi_486_;
                    phi_487_ = _e322;
                    phi_488_ = _e324;
                } else {
                    phi_487_ = f32();
                    phi_488_ = true;
                }
                let _e326 = phi_487_;
                let _e328 = phi_488_;
                if _e328 {
                    phi_492_ = _e278;
                } else {
                    phi_492_ = _e326;
                }
                let _e330 = phi_492_;
                let _e331 = (_e277 - _e304);
                let _e332 = (_e278 - _e330);
                let _e341 = select(0i, select(select(i32(_e304), i32(-2147483648), (_e304 < bitcast<f32>(3472883712u))), 2147483647i, (_e304 > bitcast<f32>(1325400063u))), (_e304 == _e304));
                let _e350 = select(0i, select(select(i32(_e330), i32(-2147483648), (_e330 < bitcast<f32>(3472883712u))), 2147483647i, (_e330 > bitcast<f32>(1325400063u))), (_e330 == _e330));
                let _e361 = p.member.test;
                let _e362 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e361);
                let _e364 = p.member.map_size;
                local = lt_math_Evsm(_e362.positive_exponent, _e362.negative_exponent, _e362.min_variance);
                let _e370 = (bitcast<i32>(_e364) - 1i);
                if (_e341 > 0i) {
                    phi_542_ = _e341;
                } else {
                    phi_542_ = 0i;
                }
                let _e373 = phi_542_;
                if (_e350 > 0i) {
                    phi_547_ = _e350;
                } else {
                    phi_547_ = 0i;
                }
                let _e376 = phi_547_;
                if (_e373 < _e370) {
                    phi_552_ = _e373;
                } else {
                    phi_552_ = _e370;
                }
                let _e379 = phi_552_;
                if (_e376 < _e370) {
                    phi_557_ = _e376;
                } else {
                    phi_557_ = _e370;
                }
                let _e382 = phi_557_;
                let _e383 = bitcast<u32>(_e379);
                let _e385 = (_e341 + 1i);
                let _e386 = (_e350 + 1i);
                if (_e385 > 0i) {
                    phi_566_ = _e385;
                } else {
                    phi_566_ = 0i;
                }
                let _e389 = phi_566_;
                if (_e386 > 0i) {
                    phi_571_ = _e386;
                } else {
                    phi_571_ = 0i;
                }
                let _e392 = phi_571_;
                if (_e389 < _e370) {
                    phi_576_ = _e389;
                } else {
                    phi_576_ = _e370;
                }
                let _e395 = phi_576_;
                if (_e392 < _e370) {
                    phi_581_ = _e392;
                } else {
                    phi_581_ = _e370;
                }
                let _e398 = phi_581_;
                let _e399 = bitcast<u32>(_e395);
                let _e401 = (bitcast<u32>(_e382) * _e364);
                let _e402 = (bitcast<u32>(_e398) * _e364);
                let _e403 = (_e401 + _e383);
                let _e404 = (_e401 + _e399);
                let _e405 = (_e402 + _e383);
                let _e406 = (_e402 + _e399);
                if (_e403 < _e54) {
                } else {
                    return;
                }
                let _e410 = map.member[(0u + _e403)];
                if (_e404 < _e54) {
                } else {
                    return;
                }
                let _e414 = map.member[(0u + _e404)];
                if (_e405 < _e54) {
                } else {
                    return;
                }
                let _e418 = map.member[(0u + _e405)];
                if (_e406 < _e54) {
                } else {
                    return;
                }
                let _e422 = map.member[(0u + _e406)];
                let _e424 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e410, _e414, _e418, _e422), vec4<f32>(((1f - _e331) * (1f - _e332)), (_e331 * (1f - _e332)), ((1f - _e331) * _e332), (_e331 * _e332)), _e244);
                phi_622_ = evaluate_Verdict(_e424, false);
                phi_623_ = evaluate_Verdict();
                phi_624_ = false;
            } else {
                phi_622_ = evaluate_Verdict();
                phi_623_ = evaluate_Verdict(1f, false);
                phi_624_ = true;
            }
            let _e428 = phi_622_;
            let _e430 = phi_623_;
            let _e432 = phi_624_;
            phi_625_ = _e430;
            phi_626_ = _e428;
            phi_627_ = _e432;
        }
        let _e434 = phi_625_;
        let _e436 = phi_626_;
        let _e438 = phi_627_;
        if _e438 {
            phi_631_ = _e434;
        } else {
            phi_631_ = _e436;
        }
        let _e440 = phi_631_;
        if (_e63.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e63.first_primitive)] = _e440.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_evsm_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
