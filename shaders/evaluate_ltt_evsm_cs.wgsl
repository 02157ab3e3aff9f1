struct lt_math_LightProjection {
    row_x: vec4<f32>,
    row_y: vec4<f32>,
    row_z: vec4<f32>,
    row_w: vec4<f32>,
}

struct type_8 {
    member: array<u32>,
}

struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_22 {
    member: array<abi_Sample>,
}

struct type_26 {
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

struct type_36 {
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

struct type_43 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_22;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_36;
@group(0) @binding(2) 
var<storage> map: type_26;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_26;
var<private> local_2: u32;
@group(0) @binding(4) 
var<storage, read_write> list: type_43;
var<workgroup> shared_: array<atomic<u32>, 2>;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_162_: lt_bvh_traverse_Tree;
    var phi_163_: bool;
    var phi_164_: lt_bvh_traverse_Tree;
    var phi_165_: bool;
    var phi_170_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_162_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_163_ = false;
        } else {
            phi_162_ = lt_bvh_traverse_Tree();
            phi_163_ = true;
        }
        let _e64 = phi_162_;
        let _e66 = phi_163_;
        phi_164_ = _e64;
        phi_165_ = _e66;
    } else {
        phi_164_ = lt_bvh_traverse_Tree();
        phi_165_ = true;
    }
    let _e68 = phi_164_;
    let _e70 = phi_165_;
    if _e70 {
        phi_170_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_170_ = _e68;
    }
    let _e75 = phi_170_;
    return lt_bvh_traverse_Tree(_e75.root, _e75.first_primitive);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> lt_math_Evsm {
    return lt_math_Evsm(param_3.x, param_3.y, param_3.z);
}

fn _lt_math_evsm_Evsm_positive(param_4: ptr<function, lt_math_Evsm>) -> f32 {
    var phi_194_: bool;
    var phi_198_: f32;

    let _e53 = (*param_4).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_194_ = true;
    } else {
        let _e57 = (42f < _e53);
        if _e57 {
        }
        phi_194_ = _e57;
    }
    let _e59 = phi_194_;
    if _e59 {
        phi_198_ = 42f;
    } else {
        phi_198_ = _e53;
    }
    let _e61 = phi_198_;
    return _e61;
}

fn _lt_math_evsm_Evsm_negative(param_5: ptr<function, lt_math_Evsm>) -> f32 {
    var phi_213_: bool;
    var phi_217_: f32;

    let _e53 = (*param_5).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_213_ = true;
    } else {
        let _e57 = (42f < _e53);
        if _e57 {
        }
        phi_213_ = _e57;
    }
    let _e59 = phi_213_;
    if _e59 {
        phi_217_ = 42f;
    } else {
        phi_217_ = _e53;
    }
    let _e61 = phi_217_;
    return _e61;
}

fn _lt_math_evsm_Evsm_bound_of_offsets(param_6: ptr<function, lt_math_Evsm>, param_7: vec4<f32>, param_8: vec4<f32>) -> f32 {
    var phi_395_: f32;
    var phi_400_: f32;
    var phi_422_: f32;
    var phi_427_: f32;
    var phi_428_: bool;
    var phi_429_: f32;
    var phi_430_: bool;
    var phi_434_: f32;
    var phi_472_: f32;
    var phi_483_: f32;
    var phi_488_: f32;
    var phi_510_: f32;
    var phi_515_: f32;
    var phi_516_: bool;
    var phi_517_: f32;
    var phi_518_: bool;
    var phi_522_: f32;
    var phi_560_: f32;
    var phi_571_: f32;
    var phi_576_: f32;
    var phi_598_: f32;
    var phi_603_: f32;
    var phi_604_: bool;
    var phi_605_: f32;
    var phi_606_: bool;
    var phi_610_: f32;
    var phi_648_: f32;
    var phi_659_: f32;
    var phi_664_: f32;
    var phi_686_: f32;
    var phi_691_: f32;
    var phi_692_: bool;
    var phi_693_: f32;
    var phi_694_: bool;
    var phi_698_: f32;
    var phi_736_: f32;
    var phi_789_: bool;
    var phi_793_: f32;
    var phi_805_: bool;
    var phi_812_: f32;
    var phi_833_: f32;
    var phi_838_: f32;
    var phi_860_: f32;
    var phi_865_: f32;
    var phi_866_: bool;
    var phi_867_: f32;
    var phi_868_: bool;
    var phi_872_: f32;
    var phi_910_: f32;
    var phi_921_: f32;
    var phi_926_: f32;
    var phi_948_: f32;
    var phi_953_: f32;
    var phi_954_: bool;
    var phi_955_: f32;
    var phi_956_: bool;
    var phi_960_: f32;
    var phi_998_: f32;
    var phi_1009_: f32;
    var phi_1014_: f32;
    var phi_1036_: f32;
    var phi_1041_: f32;
    var phi_1042_: bool;
    var phi_1043_: f32;
    var phi_1044_: bool;
    var phi_1048_: f32;
    var phi_1086_: f32;
    var phi_1097_: f32;
    var phi_1102_: f32;
    var phi_1124_: f32;
    var phi_1129_: f32;
    var phi_1130_: bool;
    var phi_1131_: f32;
    var phi_1132_: bool;
    var phi_1136_: f32;
    var phi_1174_: f32;
    var phi_1227_: bool;
    var phi_1231_: f32;
    var phi_1243_: bool;
    var phi_1250_: f32;
    var phi_1261_: bool;
    var phi_1265_: f32;
    var phi_1280_: f32;
    var phi_1281_: f32;
    var phi_1282_: f32;

    let _e54 = _lt_math_evsm_Evsm_positive(param_6);
    let _e56 = (_e54 * param_7.x);
    let _e58 = (_e54 * param_7.y);
    let _e60 = (_e54 * param_7.z);
    let _e62 = (_e54 * param_7.w);
    if ((bitcast<u32>(_e56) & 2147483647u) > 2139095040u) {
        phi_472_ = _e56;
    } else {
        if (_e56 < -87f) {
            phi_395_ = -87f;
        } else {
            phi_395_ = _e56;
        }
        let _e68 = phi_395_;
        if (_e68 > 88f) {
            phi_400_ = 88f;
        } else {
            phi_400_ = _e68;
        }
        let _e71 = phi_400_;
        let _e73 = ((_e71 * 1.442695f) + 0.5f);
        if (_e73 > -8388608f) {
            let _e85 = f32(select(0i, select(select(i32(_e73), i32(-2147483648), (_e73 < bitcast<f32>(3472883712u))), 2147483647i, (_e73 > bitcast<f32>(1325400063u))), (_e73 == _e73)));
            if (_e85 > _e73) {
                phi_422_ = 1f;
            } else {
                phi_422_ = 0f;
            }
            let _e88 = phi_422_;
            if (_e73 < 8388608f) {
                phi_427_ = (_e85 - _e88);
                phi_428_ = false;
            } else {
                phi_427_ = f32();
                phi_428_ = true;
            }
            let _e91 = phi_427_;
            let _e93 = phi_428_;
            phi_429_ = _e91;
            phi_430_ = _e93;
        } else {
            phi_429_ = f32();
            phi_430_ = true;
        }
        let _e95 = phi_429_;
        let _e97 = phi_430_;
        if _e97 {
            phi_434_ = _e73;
        } else {
            phi_434_ = _e95;
        }
        let _e99 = phi_434_;
        let _e103 = ((_e71 - (_e99 * 0.69314575f)) - (_e99 * 0.0000014286068f));
        phi_472_ = ((((((((((((((((1f / 5040f) * _e103) + (1f / 720f)) * _e103) + (1f / 120f)) * _e103) + (1f / 24f)) * _e103) + (1f / 6f)) * _e103) + 0.5f) * _e103) + 1f) * _e103) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e99), i32(-2147483648), (_e99 < bitcast<f32>(3472883712u))), 2147483647i, (_e99 > bitcast<f32>(1325400063u))), (_e99 == _e99)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e139 = phi_472_;
    if ((bitcast<u32>(_e58) & 2147483647u) > 2139095040u) {
        phi_560_ = _e58;
    } else {
        if (_e58 < -87f) {
            phi_483_ = -87f;
        } else {
            phi_483_ = _e58;
        }
        let _e145 = phi_483_;
        if (_e145 > 88f) {
            phi_488_ = 88f;
        } else {
            phi_488_ = _e145;
        }
        let _e148 = phi_488_;
        let _e150 = ((_e148 * 1.442695f) + 0.5f);
        if (_e150 > -8388608f) {
            let _e162 = f32(select(0i, select(select(i32(_e150), i32(-2147483648), (_e150 < bitcast<f32>(3472883712u))), 2147483647i, (_e150 > bitcast<f32>(1325400063u))), (_e150 == _e150)));
            if (_e162 > _e150) {
                phi_510_ = 1f;
            } else {
                phi_510_ = 0f;
            }
            let _e165 = phi_510_;
            if (_e150 < 8388608f) {
                phi_515_ = (_e162 - _e165);
                phi_516_ = false;
            } else {
                phi_515_ = f32();
                phi_516_ = true;
            }
            let _e168 = phi_515_;
            let _e170 = phi_516_;
            phi_517_ = _e168;
            phi_518_ = _e170;
        } else {
            phi_517_ = f32();
            phi_518_ = true;
        }
        let _e172 = phi_517_;
        let _e174 = phi_518_;
        if _e174 {
            phi_522_ = _e150;
        } else {
            phi_522_ = _e172;
        }
        let _e176 = phi_522_;
        let _e180 = ((_e148 - (_e176 * 0.69314575f)) - (_e176 * 0.0000014286068f));
        phi_560_ = ((((((((((((((((1f / 5040f) * _e180) + (1f / 720f)) * _e180) + (1f / 120f)) * _e180) + (1f / 24f)) * _e180) + (1f / 6f)) * _e180) + 0.5f) * _e180) + 1f) * _e180) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e176), i32(-2147483648), (_e176 < bitcast<f32>(3472883712u))), 2147483647i, (_e176 > bitcast<f32>(1325400063u))), (_e176 == _e176)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e216 = phi_560_;
    if ((bitcast<u32>(_e60) & 2147483647u) > 2139095040u) {
        phi_648_ = _e60;
    } else {
        if (_e60 < -87f) {
            phi_571_ = -87f;
        } else {
            phi_571_ = _e60;
        }
        let _e222 = phi_571_;
        if (_e222 > 88f) {
            phi_576_ = 88f;
        } else {
            phi_576_ = _e222;
        }
        let _e225 = phi_576_;
        let _e227 = ((_e225 * 1.442695f) + 0.5f);
        if (_e227 > -8388608f) {
            let _e239 = f32(select(0i, select(select(i32(_e227), i32(-2147483648), (_e227 < bitcast<f32>(3472883712u))), 2147483647i, (_e227 > bitcast<f32>(1325400063u))), (_e227 == _e227)));
            if (_e239 > _e227) {
                phi_598_ = 1f;
            } else {
                phi_598_ = 0f;
            }
            let _e242 = phi_598_;
            if (_e227 < 8388608f) {
                phi_603_ = (_e239 - _e242);
                phi_604_ = false;
            } else {
                phi_603_ = f32();
                phi_604_ = true;
            }
            let _e245 = phi_603_;
            let _e247 = phi_604_;
            phi_605_ = _e245;
            phi_606_ = _e247;
        } else {
            phi_605_ = f32();
            phi_606_ = true;
        }
        let _e249 = phi_605_;
        let _e251 = phi_606_;
        if _e251 {
            phi_610_ = _e227;
        } else {
            phi_610_ = _e249;
        }
        let _e253 = phi_610_;
        let _e257 = ((_e225 - (_e253 * 0.69314575f)) - (_e253 * 0.0000014286068f));
        phi_648_ = ((((((((((((((((1f / 5040f) * _e257) + (1f / 720f)) * _e257) + (1f / 120f)) * _e257) + (1f / 24f)) * _e257) + (1f / 6f)) * _e257) + 0.5f) * _e257) + 1f) * _e257) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e253), i32(-2147483648), (_e253 < bitcast<f32>(3472883712u))), 2147483647i, (_e253 > bitcast<f32>(1325400063u))), (_e253 == _e253)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e293 = phi_648_;
    if ((bitcast<u32>(_e62) & 2147483647u) > 2139095040u) {
        phi_736_ = _e62;
    } else {
        if (_e62 < -87f) {
            phi_659_ = -87f;
        } else {
            phi_659_ = _e62;
        }
        let _e299 = phi_659_;
        if (_e299 > 88f) {
            phi_664_ = 88f;
        } else {
            phi_664_ = _e299;
        }
        let _e302 = phi_664_;
        let _e304 = ((_e302 * 1.442695f) + 0.5f);
        if (_e304 > -8388608f) {
            let _e316 = f32(select(0i, select(select(i32(_e304), i32(-2147483648), (_e304 < bitcast<f32>(3472883712u))), 2147483647i, (_e304 > bitcast<f32>(1325400063u))), (_e304 == _e304)));
            if (_e316 > _e304) {
                phi_686_ = 1f;
            } else {
                phi_686_ = 0f;
            }
            let _e319 = phi_686_;
            if (_e304 < 8388608f) {
                phi_691_ = (_e316 - _e319);
                phi_692_ = false;
            } else {
                phi_691_ = f32();
                phi_692_ = true;
            }
            let _e322 = phi_691_;
            let _e324 = phi_692_;
            phi_693_ = _e322;
            phi_694_ = _e324;
        } else {
            phi_693_ = f32();
            phi_694_ = true;
        }
        let _e326 = phi_693_;
        let _e328 = phi_694_;
        if _e328 {
            phi_698_ = _e304;
        } else {
            phi_698_ = _e326;
        }
        let _e330 = phi_698_;
        let _e334 = ((_e302 - (_e330 * 0.69314575f)) - (_e330 * 0.0000014286068f));
        phi_736_ = ((((((((((((((((1f / 5040f) * _e334) + (1f / 720f)) * _e334) + (1f / 120f)) * _e334) + (1f / 24f)) * _e334) + (1f / 6f)) * _e334) + 0.5f) * _e334) + 1f) * _e334) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e330), i32(-2147483648), (_e330 < bitcast<f32>(3472883712u))), 2147483647i, (_e330 > bitcast<f32>(1325400063u))), (_e330 == _e330)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e370 = phi_736_;
    let _e372 = (_e139 - vec4<f32>(1f, 1f, 1f, 1f).x);
    let _e374 = (_e216 - vec4<f32>(1f, 1f, 1f, 1f).y);
    let _e376 = (_e293 - vec4<f32>(1f, 1f, 1f, 1f).z);
    let _e378 = (_e370 - vec4<f32>(1f, 1f, 1f, 1f).w);
    let _e380 = (*param_6).min_variance;
    let _e382 = ((_e380 * _e54) * _e54);
    let _e393 = ((((_e372 * param_8.x) + (_e374 * param_8.y)) + (_e376 * param_8.z)) + (_e378 * param_8.w));
    let _e394 = (_e372 - _e393);
    let _e395 = (_e374 - _e393);
    let _e396 = (_e376 - _e393);
    let _e397 = (_e378 - _e393);
    let _e412 = (((((_e394 * _e394) * param_8.x) + ((_e395 * _e395) * param_8.y)) + ((_e396 * _e396) * param_8.z)) + ((_e397 * _e397) * param_8.w));
    if ((bitcast<u32>(_e382) & 2147483647u) > 2139095040u) {
        phi_789_ = true;
    } else {
        let _e416 = (_e382 > _e412);
        if _e416 {
        }
        phi_789_ = _e416;
    }
    let _e418 = phi_789_;
    if _e418 {
        phi_793_ = _e382;
    } else {
        phi_793_ = _e412;
    }
    let _e420 = phi_793_;
    let _e421 = -(_e393);
    if (_e421 <= 0f) {
        let _e425 = ((bitcast<u32>(_e420) & 2147483647u) > 2139095040u);
        if _e425 {
        }
        phi_805_ = _e425;
    } else {
        phi_805_ = true;
    }
    let _e427 = phi_805_;
    if _e427 {
        phi_812_ = (_e420 / (_e420 + (_e421 * _e421)));
    } else {
        phi_812_ = 1f;
    }
    let _e432 = phi_812_;
    let _e433 = _lt_math_evsm_Evsm_negative(param_6);
    let _e434 = -(_e433);
    let _e436 = (_e434 * param_7.x);
    let _e438 = (_e434 * param_7.y);
    let _e440 = (_e434 * param_7.z);
    let _e442 = (_e434 * param_7.w);
    if ((bitcast<u32>(_e436) & 2147483647u) > 2139095040u) {
        phi_910_ = _e436;
    } else {
        if (_e436 < -87f) {
            phi_833_ = -87f;
        } else {
            phi_833_ = _e436;
        }
        let _e448 = phi_833_;
        if (_e448 > 88f) {
            phi_838_ = 88f;
        } else {
            phi_838_ = _e448;
        }
        let _e451 = phi_838_;
        let _e453 = ((_e451 * 1.442695f) + 0.5f);
        if (_e453 > -8388608f) {
            let _e465 = f32(select(0i, select(select(i32(_e453), i32(-2147483648), (_e453 < bitcast<f32>(3472883712u))), 2147483647i, (_e453 > bitcast<f32>(1325400063u))), (_e453 == _e453)));
            if (_e465 > _e453) {
                phi_860_ = 1f;
            } else {
                phi_860_ = 0f;
            }
            let _e468 = phi_860_;
            if (_e453 < 8388608f) {
                phi_865_ = (_e465 - _e468);
                phi_866_ = false;
            } else {
                phi_865_ = f32();
                phi_866_ = true;
            }
            let _e471 = phi_865_;
            let _e473 = phi_866_;
            phi_867_ = _e471;
            phi_868_ = _e473;
        } else {
            phi_867_ = f32();
            phi_868_ = true;
        }
        let _e475 = phi_867_;
        let _e477 = phi_868_;
        if _e477 {
            phi_872_ = _e453;
        } else {
            phi_872_ = _e475;
        }
        let _e479 = phi_872_;
        let _e483 = ((_e451 - (_e479 * 0.69314575f)) - (_e479 * 0.0000014286068f));
        phi_910_ = ((((((((((((((((1f / 5040f) * _e483) + (1f / 720f)) * _e483) + (1f / 120f)) * _e483) + (1f / 24f)) * _e483) + (1f / 6f)) * _e483) + 0.5f) * _e483) + 1f) * _e483) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e479), i32(-2147483648), (_e479 < bitcast<f32>(3472883712u))), 2147483647i, (_e479 > bitcast<f32>(1325400063u))), (_e479 == _e479)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e519 = phi_910_;
    if ((bitcast<u32>(_e438) & 2147483647u) > 2139095040u) {
        phi_998_ = _e438;
    } else {
        if (_e438 < -87f) {
            phi_921_ = -87f;
        } else {
            phi_921_ = _e438;
        }
        let _e525 = phi_921_;
        if (_e525 > 88f) {
            phi_926_ = 88f;
        } else {
            phi_926_ = _e525;
        }
        let _e528 = phi_926_;
        let _e530 = ((_e528 * 1.442695f) + 0.5f);
        if (_e530 > -8388608f) {
            let _e542 = f32(select(0i, select(select(i32(_e530), i32(-2147483648), (_e530 < bitcast<f32>(3472883712u))), 2147483647i, (_e530 > bitcast<f32>(1325400063u))), (_e530 == _e530)));
            if (_e542 > _e530) {
                phi_948_ = 1f;
            } else {
                phi_948_ = 0f;
            }
            let _e545 = phi_948_;
            if (_e530 < 8388608f) {
                phi_953_ = (_e542 - _e545);
                phi_954_ = false;
            } else {
                phi_953_ = f32();
                phi_954_ = true;
            }
            let _e548 = phi_953_;
            let _e550 = phi_954_;
            phi_955_ = _e548;
            phi_956_ = _e550;
        } else {
            phi_955_ = f32();
            phi_956_ = true;
        }
        let _e552 = phi_955_;
        let _e554 = phi_956_;
        if _e554 {
            phi_960_ = _e530;
        } else {
            phi_960_ = _e552;
        }
        let _e556 = phi_960_;
        let _e560 = ((_e528 - (_e556 * 0.69314575f)) - (_e556 * 0.0000014286068f));
        phi_998_ = ((((((((((((((((1f / 5040f) * _e560) + (1f / 720f)) * _e560) + (1f / 120f)) * _e560) + (1f / 24f)) * _e560) + (1f / 6f)) * _e560) + 0.5f) * _e560) + 1f) * _e560) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e556), i32(-2147483648), (_e556 < bitcast<f32>(3472883712u))), 2147483647i, (_e556 > bitcast<f32>(1325400063u))), (_e556 == _e556)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e596 = phi_998_;
    if ((bitcast<u32>(_e440) & 2147483647u) > 2139095040u) {
        phi_1086_ = _e440;
    } else {
        if (_e440 < -87f) {
            phi_1009_ = -87f;
        } else {
            phi_1009_ = _e440;
        }
        let _e602 = phi_1009_;
        if (_e602 > 88f) {
            phi_1014_ = 88f;
        } else {
            phi_1014_ = _e602;
        }
        let _e605 = phi_1014_;
        let _e607 = ((_e605 * 1.442695f) + 0.5f);
        if (_e607 > -8388608f) {
            let _e619 = f32(select(0i, select(select(i32(_e607), i32(-2147483648), (_e607 < bitcast<f32>(3472883712u))), 2147483647i, (_e607 > bitcast<f32>(1325400063u))), (_e607 == _e607)));
            if (_e619 > _e607) {
                phi_1036_ = 1f;
            } else {
                phi_1036_ = 0f;
            }
            let _e622 = phi_1036_;
            if (_e607 < 8388608f) {
                phi_1041_ = (_e619 - _e622);
                phi_1042_ = false;
            } else {
                phi_1041_ = f32();
                phi_1042_ = true;
            }
            let _e625 = phi_1041_;
            let _e627 = phi_1042_;
            phi_1043_ = _e625;
            phi_1044_ = _e627;
        } else {
            phi_1043_ = f32();
            phi_1044_ = true;
        }
        let _e629 = phi_1043_;
        let _e631 = phi_1044_;
        if _e631 {
            phi_1048_ = _e607;
        } else {
            phi_1048_ = _e629;
        }
        let _e633 = phi_1048_;
        let _e637 = ((_e605 - (_e633 * 0.69314575f)) - (_e633 * 0.0000014286068f));
        phi_1086_ = ((((((((((((((((1f / 5040f) * _e637) + (1f / 720f)) * _e637) + (1f / 120f)) * _e637) + (1f / 24f)) * _e637) + (1f / 6f)) * _e637) + 0.5f) * _e637) + 1f) * _e637) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e633), i32(-2147483648), (_e633 < bitcast<f32>(3472883712u))), 2147483647i, (_e633 > bitcast<f32>(1325400063u))), (_e633 == _e633)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e673 = phi_1086_;
    if ((bitcast<u32>(_e442) & 2147483647u) > 2139095040u) {
        phi_1174_ = _e442;
    } else {
        if (_e442 < -87f) {
            phi_1097_ = -87f;
        } else {
            phi_1097_ = _e442;
        }
        let _e679 = phi_1097_;
        if (_e679 > 88f) {
            phi_1102_ = 88f;
        } else {
            phi_1102_ = _e679;
        }
        let _e682 = phi_1102_;
        let _e684 = ((_e682 * 1.442695f) + 0.5f);
        if (_e684 > -8388608f) {
            let _e696 = f32(select(0i, select(select(i32(_e684), i32(-2147483648), (_e684 < bitcast<f32>(3472883712u))), 2147483647i, (_e684 > bitcast<f32>(1325400063u))), (_e684 == _e684)));
            if (_e696 > _e684) {
                phi_1124_ = 1f;
            } else {
                phi_1124_ = 0f;
            }
            let _e699 = phi_1124_;
            if (_e684 < 8388608f) {
                phi_1129_ = (_e696 - _e699);
                phi_1130_ = false;
            } else {
                phi_1129_ = f32();
                phi_1130_ = true;
            }
            let _e702 = phi_1129_;
            let _e704 = phi_1130_;
            phi_1131_ = _e702;
            phi_1132_ = _e704;
        } else {
            phi_1131_ = f32();
            phi_1132_ = true;
        }
        let _e706 = phi_1131_;
        let _e708 = phi_1132_;
        if _e708 {
            phi_1136_ = _e684;
        } else {
            phi_1136_ = _e706;
        }
        let _e710 = phi_1136_;
        let _e714 = ((_e682 - (_e710 * 0.69314575f)) - (_e710 * 0.0000014286068f));
        phi_1174_ = ((((((((((((((((1f / 5040f) * _e714) + (1f / 720f)) * _e714) + (1f / 120f)) * _e714) + (1f / 24f)) * _e714) + (1f / 6f)) * _e714) + 0.5f) * _e714) + 1f) * _e714) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e710), i32(-2147483648), (_e710 < bitcast<f32>(3472883712u))), 2147483647i, (_e710 > bitcast<f32>(1325400063u))), (_e710 == _e710)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e750 = phi_1174_;
    let _e752 = (vec4<f32>(1f, 1f, 1f, 1f).x - _e519);
    let _e754 = (vec4<f32>(1f, 1f, 1f, 1f).y - _e596);
    let _e756 = (vec4<f32>(1f, 1f, 1f, 1f).z - _e673);
    let _e758 = (vec4<f32>(1f, 1f, 1f, 1f).w - _e750);
    let _e760 = (*param_6).min_variance;
    let _e762 = ((_e760 * _e433) * _e433);
    let _e773 = ((((_e752 * param_8.x) + (_e754 * param_8.y)) + (_e756 * param_8.z)) + (_e758 * param_8.w));
    let _e774 = (_e752 - _e773);
    let _e775 = (_e754 - _e773);
    let _e776 = (_e756 - _e773);
    let _e777 = (_e758 - _e773);
    let _e792 = (((((_e774 * _e774) * param_8.x) + ((_e775 * _e775) * param_8.y)) + ((_e776 * _e776) * param_8.z)) + ((_e777 * _e777) * param_8.w));
    if ((bitcast<u32>(_e762) & 2147483647u) > 2139095040u) {
        phi_1227_ = true;
    } else {
        let _e796 = (_e762 > _e792);
        if _e796 {
        }
        phi_1227_ = _e796;
    }
    let _e798 = phi_1227_;
    if _e798 {
        phi_1231_ = _e762;
    } else {
        phi_1231_ = _e792;
    }
    let _e800 = phi_1231_;
    let _e801 = -(_e773);
    if (_e801 <= 0f) {
        let _e805 = ((bitcast<u32>(_e800) & 2147483647u) > 2139095040u);
        if _e805 {
        }
        phi_1243_ = _e805;
    } else {
        phi_1243_ = true;
    }
    let _e807 = phi_1243_;
    if _e807 {
        phi_1250_ = (_e800 / (_e800 + (_e801 * _e801)));
    } else {
        phi_1250_ = 1f;
    }
    let _e812 = phi_1250_;
    if ((bitcast<u32>(_e812) & 2147483647u) > 2139095040u) {
        phi_1261_ = true;
    } else {
        let _e816 = (_e812 < _e432);
        if _e816 {
        }
        phi_1261_ = _e816;
    }
    let _e818 = phi_1261_;
    if _e818 {
        phi_1265_ = _e812;
    } else {
        phi_1265_ = _e432;
    }
    let _e820 = phi_1265_;
    if ((bitcast<u32>(_e820) & 2147483647u) > 2139095040u) {
        phi_1282_ = _e820;
    } else {
        if (_e820 < 0f) {
            phi_1281_ = 0f;
        } else {
            if (_e820 > 1f) {
                phi_1280_ = 1f;
            } else {
                phi_1280_ = _e820;
            }
            let _e827 = phi_1280_;
            phi_1281_ = _e827;
        }
        let _e829 = phi_1281_;
        phi_1282_ = _e829;
    }
    let _e831 = phi_1282_;
    return _e831;
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_9: ptr<function, lt_math_Evsm>, param_10: vec4<f32>, param_11: vec4<f32>, param_12: f32) -> f32 {
    var phi_237_: f32;
    var phi_238_: f32;
    var phi_239_: f32;
    var phi_255_: f32;
    var phi_256_: f32;
    var phi_257_: f32;
    var phi_273_: f32;
    var phi_274_: f32;
    var phi_275_: f32;
    var phi_291_: f32;
    var phi_292_: f32;
    var phi_293_: f32;
    var phi_309_: f32;
    var phi_310_: f32;
    var phi_311_: f32;
    var phi_348_: bool;
    var phi_349_: bool;
    var phi_350_: bool;
    var phi_351_: bool;
    var phi_352_: bool;
    var phi_353_: bool;
    var phi_354_: bool;
    var phi_355_: bool;
    var phi_356_: bool;
    var phi_357_: bool;
    var phi_358_: bool;
    var phi_362_: bool;
    var phi_366_: bool;
    var phi_371_: f32;

    if ((bitcast<u32>(param_12) & 2147483647u) > 2139095040u) {
        phi_239_ = param_12;
    } else {
        if (param_12 < 0f) {
            phi_238_ = 0f;
        } else {
            if (param_12 > 1f) {
                phi_237_ = 1f;
            } else {
                phi_237_ = param_12;
            }
            let _e61 = phi_237_;
            phi_238_ = _e61;
        }
        let _e63 = phi_238_;
        phi_239_ = _e63;
    }
    let _e65 = phi_239_;
    if ((bitcast<u32>(param_10.x) & 2147483647u) > 2139095040u) {
        phi_257_ = param_10.x;
    } else {
        if (param_10.x < 0f) {
            phi_256_ = 0f;
        } else {
            if (param_10.x > 1f) {
                phi_255_ = 1f;
            } else {
                phi_255_ = param_10.x;
            }
            let _e73 = phi_255_;
            phi_256_ = _e73;
        }
        let _e75 = phi_256_;
        phi_257_ = _e75;
    }
    let _e77 = phi_257_;
    if ((bitcast<u32>(param_10.y) & 2147483647u) > 2139095040u) {
        phi_275_ = param_10.y;
    } else {
        if (param_10.y < 0f) {
            phi_274_ = 0f;
        } else {
            if (param_10.y > 1f) {
                phi_273_ = 1f;
            } else {
                phi_273_ = param_10.y;
            }
            let _e85 = phi_273_;
            phi_274_ = _e85;
        }
        let _e87 = phi_274_;
        phi_275_ = _e87;
    }
    let _e89 = phi_275_;
    if ((bitcast<u32>(param_10.z) & 2147483647u) > 2139095040u) {
        phi_293_ = param_10.z;
    } else {
        if (param_10.z < 0f) {
            phi_292_ = 0f;
        } else {
            if (param_10.z > 1f) {
                phi_291_ = 1f;
            } else {
                phi_291_ = param_10.z;
            }
            let _e97 = phi_291_;
            phi_292_ = _e97;
        }
        let _e99 = phi_292_;
        phi_293_ = _e99;
    }
    let _e101 = phi_293_;
    if ((bitcast<u32>(param_10.w) & 2147483647u) > 2139095040u) {
        phi_311_ = param_10.w;
    } else {
        if (param_10.w < 0f) {
            phi_310_ = 0f;
        } else {
            if (param_10.w > 1f) {
                phi_309_ = 1f;
            } else {
                phi_309_ = param_10.w;
            }
            let _e109 = phi_309_;
            phi_310_ = _e109;
        }
        let _e111 = phi_310_;
        phi_311_ = _e111;
    }
    let _e113 = phi_311_;
    let _e114 = (_e77 - _e65);
    let _e115 = (_e89 - _e65);
    let _e116 = (_e101 - _e65);
    let _e117 = (_e113 - _e65);
    if (_e114 >= 0f) {
        if (_e115 >= 0f) {
            if (_e116 >= 0f) {
                if (_e117 >= 0f) {
                    phi_348_ = !(((bitcast<u32>(((((_e114 * param_11.x) + (_e115 * param_11.y)) + (_e116 * param_11.z)) + (_e117 * param_11.w))) & 2147483647u) > 2139095040u));
                    phi_349_ = false;
                } else {
                    phi_348_ = bool();
                    phi_349_ = true;
                }
                let _e139 = phi_348_;
                let _e141 = phi_349_;
                phi_350_ = _e139;
                phi_351_ = false;
                phi_352_ = _e141;
            } else {
                phi_350_ = bool();
                phi_351_ = true;
                phi_352_ = false;
            }
            let _e143 = phi_350_;
            let _e145 = phi_351_;
            let _e147 = phi_352_;
            phi_353_ = _e143;
            phi_354_ = _e145;
            phi_355_ = _e147;
        } else {
            phi_353_ = bool();
            phi_354_ = true;
            phi_355_ = false;
        }
        let _e149 = phi_353_;
        let _e151 = phi_354_;
        let _e153 = phi_355_;
        phi_356_ = _e149;
        phi_357_ = _e151;
        phi_358_ = _e153;
    } else {
        phi_356_ = bool();
        phi_357_ = true;
        phi_358_ = false;
    }
    let _e155 = phi_356_;
    let _e157 = phi_357_;
    let _e159 = phi_358_;
    if _e157 {
        phi_362_ = true;
    } else {
        phi_362_ = _e159;
    }
    let _e161 = phi_362_;
    if _e161 {
        phi_366_ = false;
    } else {
        phi_366_ = _e155;
    }
    let _e163 = phi_366_;
    if _e163 {
        phi_371_ = 1f;
    } else {
        let _e164 = _lt_math_evsm_Evsm_bound_of_offsets(param_9, vec4<f32>(_e114, _e115, _e116, _e117), param_11);
        phi_371_ = _e164;
    }
    let _e166 = phi_371_;
    return _e166;
}

fn function_() {
    var local_1: lt_math_Evsm;
    var phi_1336_: bool;
    var phi_1337_: bool;
    var phi_1338_: bool;
    var phi_1339_: bool;
    var phi_1343_: bool;
    var phi_1387_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1391_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1468_: bool;
    var phi_1477_: bool;
    var phi_1486_: bool;
    var phi_1487_: bool;
    var phi_1488_: bool;
    var phi_1489_: bool;
    var phi_1490_: bool;
    var phi_1491_: bool;
    var phi_1492_: bool;
    var phi_1496_: bool;
    var phi_1590_: f32;
    var phi_1593_: f32;
    var phi_1622_: f32;
    var phi_1627_: f32;
    var phi_1628_: bool;
    var phi_1629_: f32;
    var phi_1630_: bool;
    var phi_1634_: f32;
    var phi_1654_: f32;
    var phi_1659_: f32;
    var phi_1660_: bool;
    var phi_1661_: f32;
    var phi_1662_: bool;
    var phi_1666_: f32;
    var phi_1716_: i32;
    var phi_1721_: i32;
    var phi_1726_: i32;
    var phi_1731_: i32;
    var phi_1740_: i32;
    var phi_1745_: i32;
    var phi_1750_: i32;
    var phi_1755_: i32;
    var phi_1802_: bool;
    var phi_1810_: bool;
    var phi_1815_: f32;
    var phi_1818_: evaluate_Verdict;
    var phi_1819_: evaluate_Verdict;
    var phi_1823_: bool;
    var phi_1824_: u32;
    var phi_1830_: u32;

    let _e52 = id_1;
    let _e53 = local_2;
    let _e58 = arrayLength((&map.member));
    if (_e53 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    let _e65 = p.member.size[0u];
    let _e67 = p.member.size[1u];
    let _e68 = lt_shaders_entry_pixel_index(_e52, _e65, _e67);
    if (bitcast<i32>(_e68.root) != 0i) {
        let _e75 = p.member.light;
        let _e78 = samples.member[_e68.first_primitive].normal[0u];
        let _e80 = global[0u];
        if (_e78 == _e80) {
            let _e83 = samples.member[_e68.first_primitive].normal[1u];
            let _e85 = global[1u];
            if (_e83 == _e85) {
                let _e88 = samples.member[_e68.first_primitive].normal[2u];
                let _e90 = global[2u];
                phi_1336_ = (_e88 == _e90);
                phi_1337_ = false;
            } else {
                phi_1336_ = bool();
                phi_1337_ = true;
            }
            let _e93 = phi_1336_;
            let _e95 = phi_1337_;
            phi_1338_ = _e93;
            phi_1339_ = _e95;
        } else {
            phi_1338_ = bool();
            phi_1339_ = true;
        }
        let _e97 = phi_1338_;
        let _e99 = phi_1339_;
        if _e99 {
            phi_1343_ = false;
        } else {
            phi_1343_ = _e97;
        }
        let _e101 = phi_1343_;
        if !(_e101) {
            let _e104 = samples.member[_e68.first_primitive].normal;
            let _e106 = samples.member[_e68.first_primitive].position;
            if ((((_e104.x * (_e75.x - (_e106.x * _e75.w))) + (_e104.y * (_e75.y - (_e106.y * _e75.w)))) + (_e104.z * (_e75.z - (_e106.z * _e75.w)))) > 0f) {
                let _e130 = samples.member[_e68.first_primitive].flags;
                let _e138 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e144 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e138.unnamed.visibility, false), _e138.unnamed_1);
                phi_1387_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e144.unnamed, ((_e130 & 1u) == 0u));
            } else {
                let _e153 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e159 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e153.unnamed.visibility, false), _e153.unnamed_1);
                phi_1387_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e159.unnamed, true);
            }
            let _e164 = phi_1387_;
            phi_1391_ = _e164;
        } else {
            let _e170 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e176 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e170.unnamed.visibility, false), _e170.unnamed_1);
            phi_1391_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e176.unnamed, true);
        }
        let _e181 = phi_1391_;
        if _e181.unnamed_1 {
            phi_1819_ = evaluate_Verdict(_e181.unnamed.visibility, _e181.unnamed.is_doubted);
        } else {
            let _e189 = samples.member[_e68.first_primitive].position;
            let _e195 = p.member.projection.row_w;
            let _e206 = ((((_e195.x * _e189.x) + (_e195.y * _e189.y)) + (_e195.z * _e189.z)) + (_e195.w * 1f));
            let _e208 = p.member.projection.row_x;
            let _e220 = (((((_e208.x * _e189.x) + (_e208.y * _e189.y)) + (_e208.z * _e189.z)) + (_e208.w * 1f)) / _e206);
            let _e222 = p.member.projection.row_y;
            let _e234 = (((((_e222.x * _e189.x) + (_e222.y * _e189.y)) + (_e222.z * _e189.z)) + (_e222.w * 1f)) / _e206);
            let _e236 = p.member.projection.row_z;
            let _e247 = ((((_e236.x * _e189.x) + (_e236.y * _e189.y)) + (_e236.z * _e189.z)) + (_e236.w * 1f));
            if (_e206 > 0f) {
                if (_e220 >= 0f) {
                    phi_1468_ = (_e220 <= 1f);
                } else {
                    phi_1468_ = false;
                }
                let _e252 = phi_1468_;
                if _e252 {
                    if (_e234 >= 0f) {
                        phi_1477_ = (_e234 <= 1f);
                    } else {
                        phi_1477_ = false;
                    }
                    let _e256 = phi_1477_;
                    if _e256 {
                        if (_e247 >= 0f) {
                            phi_1486_ = (_e247 <= 1f);
                        } else {
                            phi_1486_ = false;
                        }
                        let _e260 = phi_1486_;
                        phi_1487_ = _e260;
                        phi_1488_ = false;
                    } else {
                        phi_1487_ = bool();
                        phi_1488_ = true;
                    }
                    let _e262 = phi_1487_;
                    let _e264 = phi_1488_;
                    phi_1489_ = _e262;
                    phi_1490_ = _e264;
                } else {
                    phi_1489_ = bool();
                    phi_1490_ = true;
                }
                let _e266 = phi_1489_;
                let _e268 = phi_1490_;
                phi_1491_ = _e266;
                phi_1492_ = _e268;
            } else {
                phi_1491_ = bool();
                phi_1492_ = true;
            }
            let _e270 = phi_1491_;
            let _e272 = phi_1492_;
            if _e272 {
                phi_1496_ = false;
            } else {
                phi_1496_ = _e270;
            }
            let _e274 = phi_1496_;
            if _e274 {
                if (0f > 0f) {
                    let _e277 = samples.member[_e68.first_primitive].normal;
                    let _e279 = p.member.map_size;
                    let _e282 = p.member.projection.row_x;
                    let _e304 = p.member.projection.row_y;
                    let _e326 = p.member.projection.row_z;
                    let _e353 = ((abs(((((_e282.x * _e277.x) + (_e282.y * _e277.y)) + (_e282.z * _e277.z)) / (((_e282.x * _e282.x) + (_e282.y * _e282.y)) + (_e282.z * _e282.z)))) + abs(((((_e304.x * _e277.x) + (_e304.y * _e277.y)) + (_e304.z * _e277.z)) / (((_e304.x * _e304.x) + (_e304.y * _e304.y)) + (_e304.z * _e304.z))))) / (abs(((((_e326.x * _e277.x) + (_e326.y * _e277.y)) + (_e326.z * _e277.z)) / (((_e326.x * _e326.x) + (_e326.y * _e326.y)) + (_e326.z * _e326.z)))) * f32(_e279)));
                    if (_e353 < 0.002f) {
                        phi_1590_ = _e353;
                    } else {
                        phi_1590_ = 0.002f;
                    }
                    let _e356 = phi_1590_;
                    phi_1593_ = (_e247 - (0f * _e356));
                } else {
                    phi_1593_ = _e247;
                }
                let _e360 = phi_1593_;
                let _e362 = p.member.map_size;
                let _e363 = f32(_e362);
                let _e366 = ((_e220 * _e363) - 0.5f);
                let _e367 = ((_e234 * _e363) - 0.5f);
                if (_e366 > -8388608f) {
                    let _e379 = f32(select(0i, select(select(i32(_e366), i32(-2147483648), (_e366 < bitcast<f32>(3472883712u))), 2147483647i, (_e366 > bitcast<f32>(1325400063u))), (_e366 == _e366)));
                    if (_e379 > _e366) {
                        phi_1622_ = 1f;
                    } else {
                        phi_1622_ = 0f;
                    }
                    let _e382 = phi_1622_;
                    if (_e366 < 8388608f) {
                        phi_1627_ = (_e379 - _e382);
                        phi_1628_ = false;
                    } else {
                        phi_1627_ = f32();
                        phi_1628_ = true;
                    }
                    let _e385 = phi_1627_;
                    let _e387 = phi_1628_;
                    phi_1629_ = _e385;
                    phi_1630_ = _e387;
                } else {
                    phi_1629_ = f32();
                    phi_1630_ = true;
                }
                let _e389 = phi_1629_;
                let _e391 = phi_1630_;
                if _e391 {
                    phi_1634_ = _e366;
                } else {
                    phi_1634_ = _e389;
                }
                let _e393 = phi_1634_;
                if (_e367 > -8388608f) {
                    let _e405 = f32(select(0i, select(select(i32(_e367), i32(-2147483648), (_e367 < bitcast<f32>(3472883712u))), 2147483647i, (_e367 > bitcast<f32>(1325400063u))), (_e367 == _e367)));
                    if (_e405 > _e367) {
                        phi_1654_ = 1f;
                    } else {
                        phi_1654_ = 0f;
                    }
                    let _e408 = phi_1654_;
                    if (_e367 < 8388608f) {
                        phi_1659_ = (_e405 - _e408);
                        phi_1660_ = false;
                    } else {
                        phi_1659_ = f32();
                        phi_1660_ = true;
                    }
                    let _e411 = phi_1659_;
                    let _e413 = phi_1660_;
                    phi_1661_ = _e411;
                    phi_1662_ = _e413;
                } else {
                    phi_1661_ = f32();
                    phi_1662_ = true;
                }
                let _e415 = phi_1661_;
                let _e417 = phi_1662_;
                if _e417 {
                    phi_1666_ = _e367;
                } else {
                    phi_1666_ = _e415;
                }
                let _e419 = phi_1666_;
                let _e420 = (_e366 - _e393);
                let _e421 = (_e367 - _e419);
                let _e430 = select(0i, select(select(i32(_e393), i32(-2147483648), (_e393 < bitcast<f32>(3472883712u))), 2147483647i, (_e393 > bitcast<f32>(1325400063u))), (_e393 == _e393));
                let _e439 = select(0i, select(select(i32(_e419), i32(-2147483648), (_e419 < bitcast<f32>(3472883712u))), 2147483647i, (_e419 > bitcast<f32>(1325400063u))), (_e419 == _e419));
                let _e450 = p.member.test;
                let _e451 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e450);
                let _e453 = p.member.map_size;
                local_1 = lt_math_Evsm(_e451.positive_exponent, _e451.negative_exponent, _e451.min_variance);
                let _e459 = (bitcast<i32>(_e453) - 1i);
                if (_e430 > 0i) {
                    phi_1716_ = _e430;
                } else {
                    phi_1716_ = 0i;
                }
                let _e462 = phi_1716_;
                if (_e439 > 0i) {
                    phi_1721_ = _e439;
                } else {
                    phi_1721_ = 0i;
                }
                let _e465 = phi_1721_;
                if (_e462 < _e459) {
                    phi_1726_ = _e462;
                } else {
                    phi_1726_ = _e459;
                }
                let _e468 = phi_1726_;
                if (_e465 < _e459) {
                    phi_1731_ = _e465;
                } else {
                    phi_1731_ = _e459;
                }
                let _e471 = phi_1731_;
                let _e472 = bitcast<u32>(_e468);
                let _e474 = (_e430 + 1i);
                let _e475 = (_e439 + 1i);
                if (_e474 > 0i) {
                    phi_1740_ = _e474;
                } else {
                    phi_1740_ = 0i;
                }
                let _e478 = phi_1740_;
                if (_e475 > 0i) {
                    phi_1745_ = _e475;
                } else {
                    phi_1745_ = 0i;
                }
                let _e481 = phi_1745_;
                if (_e478 < _e459) {
                    phi_1750_ = _e478;
                } else {
                    phi_1750_ = _e459;
                }
                let _e484 = phi_1750_;
                if (_e481 < _e459) {
                    phi_1755_ = _e481;
                } else {
                    phi_1755_ = _e459;
                }
                let _e487 = phi_1755_;
                let _e488 = bitcast<u32>(_e484);
                let _e490 = (bitcast<u32>(_e471) * _e453);
                let _e491 = (bitcast<u32>(_e487) * _e453);
                let _e492 = (_e490 + _e472);
                let _e493 = (_e490 + _e488);
                let _e494 = (_e491 + _e472);
                let _e495 = (_e491 + _e488);
                if (_e492 < _e58) {
                } else {
                    return;
                }
                let _e499 = map.member[(0u + _e492)];
                if (_e493 < _e58) {
                } else {
                    return;
                }
                let _e503 = map.member[(0u + _e493)];
                if (_e494 < _e58) {
                } else {
                    return;
                }
                let _e507 = map.member[(0u + _e494)];
                if (_e495 < _e58) {
                } else {
                    return;
                }
                let _e511 = map.member[(0u + _e495)];
                let _e513 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local_1), vec4<f32>(_e499, _e503, _e507, _e511), vec4<f32>(((1f - _e420) * (1f - _e421)), (_e420 * (1f - _e421)), ((1f - _e420) * _e421), (_e420 * _e421)), _e360);
                let _e515 = p.member.epsilon;
                if (_e513 <= _e515) {
                    phi_1802_ = true;
                } else {
                    phi_1802_ = (_e513 >= (1f - _e515));
                }
                let _e520 = phi_1802_;
                if ((bitcast<u32>(_e513) & 2147483647u) > 2139095040u) {
                    phi_1810_ = true;
                } else {
                    phi_1810_ = !(_e520);
                }
                let _e526 = phi_1810_;
                if (_e513 > 0.5f) {
                    phi_1815_ = 1f;
                } else {
                    phi_1815_ = 0f;
                }
                let _e529 = phi_1815_;
                phi_1818_ = evaluate_Verdict(_e529, _e526);
            } else {
                phi_1818_ = evaluate_Verdict(1f, true);
            }
            let _e533 = phi_1818_;
            phi_1819_ = _e533;
        }
        let _e535 = phi_1819_;
        visibility.member[_e68.first_primitive] = _e535.visibility;
        phi_1823_ = _e535.is_doubted;
        phi_1824_ = _e68.first_primitive;
    } else {
        phi_1823_ = false;
        phi_1824_ = 0u;
    }
    let _e540 = phi_1823_;
    let _e542 = phi_1824_;
    if _e540 {
        let _e544 = atomicAdd((&shared_[0u]), 1u);
        phi_1830_ = _e544;
    } else {
        phi_1830_ = 0u;
    }
    let _e546 = phi_1830_;
    workgroupBarrier();
    if (_e53 == 0u) {
        let _e550 = atomicLoad((&shared_[0u]));
        let _e551 = atomicAdd((&list.member[3u]), _e550);
        atomicStore((&shared_[1u]), _e551);
    }
    workgroupBarrier();
    if _e540 {
        let _e554 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e554) + _e546)]), _e542);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_evsm_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
