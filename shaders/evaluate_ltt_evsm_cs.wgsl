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

struct type_39 {
    member: abi_ShadowParams,
}

struct type_44 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
var<private> local_2: u32;
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
var<storage, read_write> list: type_44;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_163_: lt_bvh_traverse_Tree;
    var phi_164_: bool;
    var phi_165_: lt_bvh_traverse_Tree;
    var phi_166_: bool;
    var phi_171_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_163_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_164_ = false;
        } else {
            phi_163_ = lt_bvh_traverse_Tree();
            phi_164_ = true;
        }
        let _e64 = phi_163_;
        let _e66 = phi_164_;
        phi_165_ = _e64;
        phi_166_ = _e66;
    } else {
        phi_165_ = lt_bvh_traverse_Tree();
        phi_166_ = true;
    }
    let _e68 = phi_165_;
    let _e70 = phi_166_;
    if _e70 {
        phi_171_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_171_ = _e68;
    }
    let _e75 = phi_171_;
    return lt_bvh_traverse_Tree(_e75.root, _e75.first_primitive);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> lt_math_Evsm {
    return lt_math_Evsm(param_3.x, param_3.y, param_3.z);
}

fn _lt_math_evsm_Evsm_positive(param_4: ptr<function, lt_math_Evsm>) -> f32 {
    var phi_195_: bool;
    var phi_199_: f32;

    let _e53 = (*param_4).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_195_ = true;
    } else {
        let _e57 = (42f < _e53);
        if _e57 {
        }
        phi_195_ = _e57;
    }
    let _e59 = phi_195_;
    if _e59 {
        phi_199_ = 42f;
    } else {
        phi_199_ = _e53;
    }
    let _e61 = phi_199_;
    return _e61;
}

fn _lt_math_evsm_Evsm_negative(param_5: ptr<function, lt_math_Evsm>) -> f32 {
    var phi_214_: bool;
    var phi_218_: f32;

    let _e53 = (*param_5).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_214_ = true;
    } else {
        let _e57 = (42f < _e53);
        if _e57 {
        }
        phi_214_ = _e57;
    }
    let _e59 = phi_214_;
    if _e59 {
        phi_218_ = 42f;
    } else {
        phi_218_ = _e53;
    }
    let _e61 = phi_218_;
    return _e61;
}

fn _lt_math_evsm_Evsm_bound_of_offsets(param_6: ptr<function, lt_math_Evsm>, param_7: vec4<f32>, param_8: vec4<f32>) -> f32 {
    var phi_396_: f32;
    var phi_401_: f32;
    var phi_423_: f32;
    var phi_428_: f32;
    var phi_429_: bool;
    var phi_430_: f32;
    var phi_431_: bool;
    var phi_435_: f32;
    var phi_473_: f32;
    var phi_484_: f32;
    var phi_489_: f32;
    var phi_511_: f32;
    var phi_516_: f32;
    var phi_517_: bool;
    var phi_518_: f32;
    var phi_519_: bool;
    var phi_523_: f32;
    var phi_561_: f32;
    var phi_572_: f32;
    var phi_577_: f32;
    var phi_599_: f32;
    var phi_604_: f32;
    var phi_605_: bool;
    var phi_606_: f32;
    var phi_607_: bool;
    var phi_611_: f32;
    var phi_649_: f32;
    var phi_660_: f32;
    var phi_665_: f32;
    var phi_687_: f32;
    var phi_692_: f32;
    var phi_693_: bool;
    var phi_694_: f32;
    var phi_695_: bool;
    var phi_699_: f32;
    var phi_737_: f32;
    var phi_790_: bool;
    var phi_794_: f32;
    var phi_806_: bool;
    var phi_813_: f32;
    var phi_834_: f32;
    var phi_839_: f32;
    var phi_861_: f32;
    var phi_866_: f32;
    var phi_867_: bool;
    var phi_868_: f32;
    var phi_869_: bool;
    var phi_873_: f32;
    var phi_911_: f32;
    var phi_922_: f32;
    var phi_927_: f32;
    var phi_949_: f32;
    var phi_954_: f32;
    var phi_955_: bool;
    var phi_956_: f32;
    var phi_957_: bool;
    var phi_961_: f32;
    var phi_999_: f32;
    var phi_1010_: f32;
    var phi_1015_: f32;
    var phi_1037_: f32;
    var phi_1042_: f32;
    var phi_1043_: bool;
    var phi_1044_: f32;
    var phi_1045_: bool;
    var phi_1049_: f32;
    var phi_1087_: f32;
    var phi_1098_: f32;
    var phi_1103_: f32;
    var phi_1125_: f32;
    var phi_1130_: f32;
    var phi_1131_: bool;
    var phi_1132_: f32;
    var phi_1133_: bool;
    var phi_1137_: f32;
    var phi_1175_: f32;
    var phi_1228_: bool;
    var phi_1232_: f32;
    var phi_1244_: bool;
    var phi_1251_: f32;
    var phi_1262_: bool;
    var phi_1266_: f32;
    var phi_1281_: f32;
    var phi_1282_: f32;
    var phi_1283_: f32;

    let _e54 = _lt_math_evsm_Evsm_positive(param_6);
    let _e56 = (_e54 * param_7.x);
    let _e58 = (_e54 * param_7.y);
    let _e60 = (_e54 * param_7.z);
    let _e62 = (_e54 * param_7.w);
    if ((bitcast<u32>(_e56) & 2147483647u) > 2139095040u) {
        phi_473_ = _e56;
    } else {
        if (_e56 < -87f) {
            phi_396_ = -87f;
        } else {
            phi_396_ = _e56;
        }
        let _e68 = phi_396_;
        if (_e68 > 88f) {
            phi_401_ = 88f;
        } else {
            phi_401_ = _e68;
        }
        let _e71 = phi_401_;
        let _e73 = ((_e71 * 1.442695f) + 0.5f);
        if (_e73 > -8388608f) {
            let _e85 = f32(select(0i, select(select(i32(_e73), i32(-2147483648), (_e73 < bitcast<f32>(3472883712u))), 2147483647i, (_e73 > bitcast<f32>(1325400063u))), (_e73 == _e73)));
            if (_e85 > _e73) {
                phi_423_ = 1f;
            } else {
                phi_423_ = 0f;
            }
            let _e88 = phi_423_;
            if (_e73 < 8388608f) {
                phi_428_ = (_e85 - _e88);
                phi_429_ = false;
            } else {
                phi_428_ = f32();
                phi_429_ = true;
            }
            let _e91 = phi_428_;
            let _e93 = phi_429_;
            phi_430_ = _e91;
            phi_431_ = _e93;
        } else {
            phi_430_ = f32();
            phi_431_ = true;
        }
        let _e95 = phi_430_;
        let _e97 = phi_431_;
        if _e97 {
            phi_435_ = _e73;
        } else {
            phi_435_ = _e95;
        }
        let _e99 = phi_435_;
        let _e103 = ((_e71 - (_e99 * 0.69314575f)) - (_e99 * 0.0000014286068f));
        phi_473_ = ((((((((((((((((1f / 5040f) * _e103) + (1f / 720f)) * _e103) + (1f / 120f)) * _e103) + (1f / 24f)) * _e103) + (1f / 6f)) * _e103) + 0.5f) * _e103) + 1f) * _e103) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e99), i32(-2147483648), (_e99 < bitcast<f32>(3472883712u))), 2147483647i, (_e99 > bitcast<f32>(1325400063u))), (_e99 == _e99)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e139 = phi_473_;
    if ((bitcast<u32>(_e58) & 2147483647u) > 2139095040u) {
        phi_561_ = _e58;
    } else {
        if (_e58 < -87f) {
            phi_484_ = -87f;
        } else {
            phi_484_ = _e58;
        }
        let _e145 = phi_484_;
        if (_e145 > 88f) {
            phi_489_ = 88f;
        } else {
            phi_489_ = _e145;
        }
        let _e148 = phi_489_;
        let _e150 = ((_e148 * 1.442695f) + 0.5f);
        if (_e150 > -8388608f) {
            let _e162 = f32(select(0i, select(select(i32(_e150), i32(-2147483648), (_e150 < bitcast<f32>(3472883712u))), 2147483647i, (_e150 > bitcast<f32>(1325400063u))), (_e150 == _e150)));
            if (_e162 > _e150) {
                phi_511_ = 1f;
            } else {
                phi_511_ = 0f;
            }
            let _e165 = phi_511_;
            if (_e150 < 8388608f) {
                phi_516_ = (_e162 - _e165);
                phi_517_ = false;
            } else {
                phi_516_ = f32();
                phi_517_ = true;
            }
            let _e168 = phi_516_;
            let _e170 = phi_517_;
            phi_518_ = _e168;
            phi_519_ = _e170;
        } else {
            phi_518_ = f32();
            phi_519_ = true;
        }
        let _e172 = phi_518_;
        let _e174 = phi_519_;
        if _e174 {
            phi_523_ = _e150;
        } else {
            phi_523_ = _e172;
        }
        let _e176 = phi_523_;
        let _e180 = ((_e148 - (_e176 * 0.69314575f)) - (_e176 * 0.0000014286068f));
        phi_561_ = ((((((((((((((((1f / 5040f) * _e180) + (1f / 720f)) * _e180) + (1f / 120f)) * _e180) + (1f / 24f)) * _e180) + (1f / 6f)) * _e180) + 0.5f) * _e180) + 1f) * _e180) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e176), i32(-2147483648), (_e176 < bitcast<f32>(3472883712u))), 2147483647i, (_e176 > bitcast<f32>(1325400063u))), (_e176 == _e176)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e216 = phi_561_;
    if ((bitcast<u32>(_e60) & 2147483647u) > 2139095040u) {
        phi_649_ = _e60;
    } else {
        if (_e60 < -87f) {
            phi_572_ = -87f;
        } else {
            phi_572_ = _e60;
        }
        let _e222 = phi_572_;
        if (_e222 > 88f) {
            phi_577_ = 88f;
        } else {
            phi_577_ = _e222;
        }
        let _e225 = phi_577_;
        let _e227 = ((_e225 * 1.442695f) + 0.5f);
        if (_e227 > -8388608f) {
            let _e239 = f32(select(0i, select(select(i32(_e227), i32(-2147483648), (_e227 < bitcast<f32>(3472883712u))), 2147483647i, (_e227 > bitcast<f32>(1325400063u))), (_e227 == _e227)));
            if (_e239 > _e227) {
                phi_599_ = 1f;
            } else {
                phi_599_ = 0f;
            }
            let _e242 = phi_599_;
            if (_e227 < 8388608f) {
                phi_604_ = (_e239 - _e242);
                phi_605_ = false;
            } else {
                phi_604_ = f32();
                phi_605_ = true;
            }
            let _e245 = phi_604_;
            let _e247 = phi_605_;
            phi_606_ = _e245;
            phi_607_ = _e247;
        } else {
            phi_606_ = f32();
            phi_607_ = true;
        }
        let _e249 = phi_606_;
        let _e251 = phi_607_;
        if _e251 {
            phi_611_ = _e227;
        } else {
            phi_611_ = _e249;
        }
        let _e253 = phi_611_;
        let _e257 = ((_e225 - (_e253 * 0.69314575f)) - (_e253 * 0.0000014286068f));
        phi_649_ = ((((((((((((((((1f / 5040f) * _e257) + (1f / 720f)) * _e257) + (1f / 120f)) * _e257) + (1f / 24f)) * _e257) + (1f / 6f)) * _e257) + 0.5f) * _e257) + 1f) * _e257) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e253), i32(-2147483648), (_e253 < bitcast<f32>(3472883712u))), 2147483647i, (_e253 > bitcast<f32>(1325400063u))), (_e253 == _e253)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e293 = phi_649_;
    if ((bitcast<u32>(_e62) & 2147483647u) > 2139095040u) {
        phi_737_ = _e62;
    } else {
        if (_e62 < -87f) {
            phi_660_ = -87f;
        } else {
            phi_660_ = _e62;
        }
        let _e299 = phi_660_;
        if (_e299 > 88f) {
            phi_665_ = 88f;
        } else {
            phi_665_ = _e299;
        }
        let _e302 = phi_665_;
        let _e304 = ((_e302 * 1.442695f) + 0.5f);
        if (_e304 > -8388608f) {
            let _e316 = f32(select(0i, select(select(i32(_e304), i32(-2147483648), (_e304 < bitcast<f32>(3472883712u))), 2147483647i, (_e304 > bitcast<f32>(1325400063u))), (_e304 == _e304)));
            if (_e316 > _e304) {
                phi_687_ = 1f;
            } else {
                phi_687_ = 0f;
            }
            let _e319 = phi_687_;
            if (_e304 < 8388608f) {
                phi_692_ = (_e316 - _e319);
                phi_693_ = false;
            } else {
                phi_692_ = f32();
                phi_693_ = true;
            }
            let _e322 = phi_692_;
            let _e324 = phi_693_;
            phi_694_ = _e322;
            phi_695_ = _e324;
        } else {
            phi_694_ = f32();
            phi_695_ = true;
        }
        let _e326 = phi_694_;
        let _e328 = phi_695_;
        if _e328 {
            phi_699_ = _e304;
        } else {
            phi_699_ = _e326;
        }
        let _e330 = phi_699_;
        let _e334 = ((_e302 - (_e330 * 0.69314575f)) - (_e330 * 0.0000014286068f));
        phi_737_ = ((((((((((((((((1f / 5040f) * _e334) + (1f / 720f)) * _e334) + (1f / 120f)) * _e334) + (1f / 24f)) * _e334) + (1f / 6f)) * _e334) + 0.5f) * _e334) + 1f) * _e334) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e330), i32(-2147483648), (_e330 < bitcast<f32>(3472883712u))), 2147483647i, (_e330 > bitcast<f32>(1325400063u))), (_e330 == _e330)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e370 = phi_737_;
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
        phi_790_ = true;
    } else {
        let _e416 = (_e382 > _e412);
        if _e416 {
        }
        phi_790_ = _e416;
    }
    let _e418 = phi_790_;
    if _e418 {
        phi_794_ = _e382;
    } else {
        phi_794_ = _e412;
    }
    let _e420 = phi_794_;
    let _e421 = -(_e393);
    if (_e421 <= 0f) {
        let _e425 = ((bitcast<u32>(_e420) & 2147483647u) > 2139095040u);
        if _e425 {
        }
        phi_806_ = _e425;
    } else {
        phi_806_ = true;
    }
    let _e427 = phi_806_;
    if _e427 {
        phi_813_ = (_e420 / (_e420 + (_e421 * _e421)));
    } else {
        phi_813_ = 1f;
    }
    let _e432 = phi_813_;
    let _e433 = _lt_math_evsm_Evsm_negative(param_6);
    let _e434 = -(_e433);
    let _e436 = (_e434 * param_7.x);
    let _e438 = (_e434 * param_7.y);
    let _e440 = (_e434 * param_7.z);
    let _e442 = (_e434 * param_7.w);
    if ((bitcast<u32>(_e436) & 2147483647u) > 2139095040u) {
        phi_911_ = _e436;
    } else {
        if (_e436 < -87f) {
            phi_834_ = -87f;
        } else {
            phi_834_ = _e436;
        }
        let _e448 = phi_834_;
        if (_e448 > 88f) {
            phi_839_ = 88f;
        } else {
            phi_839_ = _e448;
        }
        let _e451 = phi_839_;
        let _e453 = ((_e451 * 1.442695f) + 0.5f);
        if (_e453 > -8388608f) {
            let _e465 = f32(select(0i, select(select(i32(_e453), i32(-2147483648), (_e453 < bitcast<f32>(3472883712u))), 2147483647i, (_e453 > bitcast<f32>(1325400063u))), (_e453 == _e453)));
            if (_e465 > _e453) {
                phi_861_ = 1f;
            } else {
                phi_861_ = 0f;
            }
            let _e468 = phi_861_;
            if (_e453 < 8388608f) {
                phi_866_ = (_e465 - _e468);
                phi_867_ = false;
            } else {
                phi_866_ = f32();
                phi_867_ = true;
            }
            let _e471 = phi_866_;
            let _e473 = phi_867_;
            phi_868_ = _e471;
            phi_869_ = _e473;
        } else {
            phi_868_ = f32();
            phi_869_ = true;
        }
        let _e475 = phi_868_;
        let _e477 = phi_869_;
        if _e477 {
            phi_873_ = _e453;
        } else {
            phi_873_ = _e475;
        }
        let _e479 = phi_873_;
        let _e483 = ((_e451 - (_e479 * 0.69314575f)) - (_e479 * 0.0000014286068f));
        phi_911_ = ((((((((((((((((1f / 5040f) * _e483) + (1f / 720f)) * _e483) + (1f / 120f)) * _e483) + (1f / 24f)) * _e483) + (1f / 6f)) * _e483) + 0.5f) * _e483) + 1f) * _e483) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e479), i32(-2147483648), (_e479 < bitcast<f32>(3472883712u))), 2147483647i, (_e479 > bitcast<f32>(1325400063u))), (_e479 == _e479)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e519 = phi_911_;
    if ((bitcast<u32>(_e438) & 2147483647u) > 2139095040u) {
        phi_999_ = _e438;
    } else {
        if (_e438 < -87f) {
            phi_922_ = -87f;
        } else {
            phi_922_ = _e438;
        }
        let _e525 = phi_922_;
        if (_e525 > 88f) {
            phi_927_ = 88f;
        } else {
            phi_927_ = _e525;
        }
        let _e528 = phi_927_;
        let _e530 = ((_e528 * 1.442695f) + 0.5f);
        if (_e530 > -8388608f) {
            let _e542 = f32(select(0i, select(select(i32(_e530), i32(-2147483648), (_e530 < bitcast<f32>(3472883712u))), 2147483647i, (_e530 > bitcast<f32>(1325400063u))), (_e530 == _e530)));
            if (_e542 > _e530) {
                phi_949_ = 1f;
            } else {
                phi_949_ = 0f;
            }
            let _e545 = phi_949_;
            if (_e530 < 8388608f) {
                phi_954_ = (_e542 - _e545);
                phi_955_ = false;
            } else {
                phi_954_ = f32();
                phi_955_ = true;
            }
            let _e548 = phi_954_;
            let _e550 = phi_955_;
            phi_956_ = _e548;
            phi_957_ = _e550;
        } else {
            phi_956_ = f32();
            phi_957_ = true;
        }
        let _e552 = phi_956_;
        let _e554 = phi_957_;
        if _e554 {
            phi_961_ = _e530;
        } else {
            phi_961_ = _e552;
        }
        let _e556 = phi_961_;
        let _e560 = ((_e528 - (_e556 * 0.69314575f)) - (_e556 * 0.0000014286068f));
        phi_999_ = ((((((((((((((((1f / 5040f) * _e560) + (1f / 720f)) * _e560) + (1f / 120f)) * _e560) + (1f / 24f)) * _e560) + (1f / 6f)) * _e560) + 0.5f) * _e560) + 1f) * _e560) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e556), i32(-2147483648), (_e556 < bitcast<f32>(3472883712u))), 2147483647i, (_e556 > bitcast<f32>(1325400063u))), (_e556 == _e556)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e596 = phi_999_;
    if ((bitcast<u32>(_e440) & 2147483647u) > 2139095040u) {
        phi_1087_ = _e440;
    } else {
        if (_e440 < -87f) {
            phi_1010_ = -87f;
        } else {
            phi_1010_ = _e440;
        }
        let _e602 = phi_1010_;
        if (_e602 > 88f) {
            phi_1015_ = 88f;
        } else {
            phi_1015_ = _e602;
        }
        let _e605 = phi_1015_;
        let _e607 = ((_e605 * 1.442695f) + 0.5f);
        if (_e607 > -8388608f) {
            let _e619 = f32(select(0i, select(select(i32(_e607), i32(-2147483648), (_e607 < bitcast<f32>(3472883712u))), 2147483647i, (_e607 > bitcast<f32>(1325400063u))), (_e607 == _e607)));
            if (_e619 > _e607) {
                phi_1037_ = 1f;
            } else {
                phi_1037_ = 0f;
            }
            let _e622 = phi_1037_;
            if (_e607 < 8388608f) {
                phi_1042_ = (_e619 - _e622);
                phi_1043_ = false;
            } else {
                phi_1042_ = f32();
                phi_1043_ = true;
            }
            let _e625 = phi_1042_;
            let _e627 = phi_1043_;
            phi_1044_ = _e625;
            phi_1045_ = _e627;
        } else {
            phi_1044_ = f32();
            phi_1045_ = true;
        }
        let _e629 = phi_1044_;
        let _e631 = phi_1045_;
        if _e631 {
            phi_1049_ = _e607;
        } else {
            phi_1049_ = _e629;
        }
        let _e633 = phi_1049_;
        let _e637 = ((_e605 - (_e633 * 0.69314575f)) - (_e633 * 0.0000014286068f));
        phi_1087_ = ((((((((((((((((1f / 5040f) * _e637) + (1f / 720f)) * _e637) + (1f / 120f)) * _e637) + (1f / 24f)) * _e637) + (1f / 6f)) * _e637) + 0.5f) * _e637) + 1f) * _e637) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e633), i32(-2147483648), (_e633 < bitcast<f32>(3472883712u))), 2147483647i, (_e633 > bitcast<f32>(1325400063u))), (_e633 == _e633)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e673 = phi_1087_;
    if ((bitcast<u32>(_e442) & 2147483647u) > 2139095040u) {
        phi_1175_ = _e442;
    } else {
        if (_e442 < -87f) {
            phi_1098_ = -87f;
        } else {
            phi_1098_ = _e442;
        }
        let _e679 = phi_1098_;
        if (_e679 > 88f) {
            phi_1103_ = 88f;
        } else {
            phi_1103_ = _e679;
        }
        let _e682 = phi_1103_;
        let _e684 = ((_e682 * 1.442695f) + 0.5f);
        if (_e684 > -8388608f) {
            let _e696 = f32(select(0i, select(select(i32(_e684), i32(-2147483648), (_e684 < bitcast<f32>(3472883712u))), 2147483647i, (_e684 > bitcast<f32>(1325400063u))), (_e684 == _e684)));
            if (_e696 > _e684) {
                phi_1125_ = 1f;
            } else {
                phi_1125_ = 0f;
            }
            let _e699 = phi_1125_;
            if (_e684 < 8388608f) {
                phi_1130_ = (_e696 - _e699);
                phi_1131_ = false;
            } else {
                phi_1130_ = f32();
                phi_1131_ = true;
            }
            let _e702 = phi_1130_;
            let _e704 = phi_1131_;
            phi_1132_ = _e702;
            phi_1133_ = _e704;
        } else {
            phi_1132_ = f32();
            phi_1133_ = true;
        }
        let _e706 = phi_1132_;
        let _e708 = phi_1133_;
        if _e708 {
            phi_1137_ = _e684;
        } else {
            phi_1137_ = _e706;
        }
        let _e710 = phi_1137_;
        let _e714 = ((_e682 - (_e710 * 0.69314575f)) - (_e710 * 0.0000014286068f));
        phi_1175_ = ((((((((((((((((1f / 5040f) * _e714) + (1f / 720f)) * _e714) + (1f / 120f)) * _e714) + (1f / 24f)) * _e714) + (1f / 6f)) * _e714) + 0.5f) * _e714) + 1f) * _e714) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e710), i32(-2147483648), (_e710 < bitcast<f32>(3472883712u))), 2147483647i, (_e710 > bitcast<f32>(1325400063u))), (_e710 == _e710)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e750 = phi_1175_;
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
        phi_1228_ = true;
    } else {
        let _e796 = (_e762 > _e792);
        if _e796 {
        }
        phi_1228_ = _e796;
    }
    let _e798 = phi_1228_;
    if _e798 {
        phi_1232_ = _e762;
    } else {
        phi_1232_ = _e792;
    }
    let _e800 = phi_1232_;
    let _e801 = -(_e773);
    if (_e801 <= 0f) {
        let _e805 = ((bitcast<u32>(_e800) & 2147483647u) > 2139095040u);
        if _e805 {
        }
        phi_1244_ = _e805;
    } else {
        phi_1244_ = true;
    }
    let _e807 = phi_1244_;
    if _e807 {
        phi_1251_ = (_e800 / (_e800 + (_e801 * _e801)));
    } else {
        phi_1251_ = 1f;
    }
    let _e812 = phi_1251_;
    if ((bitcast<u32>(_e812) & 2147483647u) > 2139095040u) {
        phi_1262_ = true;
    } else {
        let _e816 = (_e812 < _e432);
        if _e816 {
        }
        phi_1262_ = _e816;
    }
    let _e818 = phi_1262_;
    if _e818 {
        phi_1266_ = _e812;
    } else {
        phi_1266_ = _e432;
    }
    let _e820 = phi_1266_;
    if ((bitcast<u32>(_e820) & 2147483647u) > 2139095040u) {
        phi_1283_ = _e820;
    } else {
        if (_e820 < 0f) {
            phi_1282_ = 0f;
        } else {
            if (_e820 > 1f) {
                phi_1281_ = 1f;
            } else {
                phi_1281_ = _e820;
            }
            let _e827 = phi_1281_;
            phi_1282_ = _e827;
        }
        let _e829 = phi_1282_;
        phi_1283_ = _e829;
    }
    let _e831 = phi_1283_;
    return _e831;
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_9: ptr<function, lt_math_Evsm>, param_10: vec4<f32>, param_11: vec4<f32>, param_12: f32) -> f32 {
    var phi_238_: f32;
    var phi_239_: f32;
    var phi_240_: f32;
    var phi_256_: f32;
    var phi_257_: f32;
    var phi_258_: f32;
    var phi_274_: f32;
    var phi_275_: f32;
    var phi_276_: f32;
    var phi_292_: f32;
    var phi_293_: f32;
    var phi_294_: f32;
    var phi_310_: f32;
    var phi_311_: f32;
    var phi_312_: f32;
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
    var phi_359_: bool;
    var phi_363_: bool;
    var phi_367_: bool;
    var phi_372_: f32;

    if ((bitcast<u32>(param_12) & 2147483647u) > 2139095040u) {
        phi_240_ = param_12;
    } else {
        if (param_12 < 0f) {
            phi_239_ = 0f;
        } else {
            if (param_12 > 1f) {
                phi_238_ = 1f;
            } else {
                phi_238_ = param_12;
            }
            let _e61 = phi_238_;
            phi_239_ = _e61;
        }
        let _e63 = phi_239_;
        phi_240_ = _e63;
    }
    let _e65 = phi_240_;
    if ((bitcast<u32>(param_10.x) & 2147483647u) > 2139095040u) {
        phi_258_ = param_10.x;
    } else {
        if (param_10.x < 0f) {
            phi_257_ = 0f;
        } else {
            if (param_10.x > 1f) {
                phi_256_ = 1f;
            } else {
                phi_256_ = param_10.x;
            }
            let _e73 = phi_256_;
            phi_257_ = _e73;
        }
        let _e75 = phi_257_;
        phi_258_ = _e75;
    }
    let _e77 = phi_258_;
    if ((bitcast<u32>(param_10.y) & 2147483647u) > 2139095040u) {
        phi_276_ = param_10.y;
    } else {
        if (param_10.y < 0f) {
            phi_275_ = 0f;
        } else {
            if (param_10.y > 1f) {
                phi_274_ = 1f;
            } else {
                phi_274_ = param_10.y;
            }
            let _e85 = phi_274_;
            phi_275_ = _e85;
        }
        let _e87 = phi_275_;
        phi_276_ = _e87;
    }
    let _e89 = phi_276_;
    if ((bitcast<u32>(param_10.z) & 2147483647u) > 2139095040u) {
        phi_294_ = param_10.z;
    } else {
        if (param_10.z < 0f) {
            phi_293_ = 0f;
        } else {
            if (param_10.z > 1f) {
                phi_292_ = 1f;
            } else {
                phi_292_ = param_10.z;
            }
            let _e97 = phi_292_;
            phi_293_ = _e97;
        }
        let _e99 = phi_293_;
        phi_294_ = _e99;
    }
    let _e101 = phi_294_;
    if ((bitcast<u32>(param_10.w) & 2147483647u) > 2139095040u) {
        phi_312_ = param_10.w;
    } else {
        if (param_10.w < 0f) {
            phi_311_ = 0f;
        } else {
            if (param_10.w > 1f) {
                phi_310_ = 1f;
            } else {
                phi_310_ = param_10.w;
            }
            let _e109 = phi_310_;
            phi_311_ = _e109;
        }
        let _e111 = phi_311_;
        phi_312_ = _e111;
    }
    let _e113 = phi_312_;
    let _e114 = (_e77 - _e65);
    let _e115 = (_e89 - _e65);
    let _e116 = (_e101 - _e65);
    let _e117 = (_e113 - _e65);
    if (_e114 >= 0f) {
        if (_e115 >= 0f) {
            if (_e116 >= 0f) {
                if (_e117 >= 0f) {
                    phi_349_ = !(((bitcast<u32>(((((_e114 * param_11.x) + (_e115 * param_11.y)) + (_e116 * param_11.z)) + (_e117 * param_11.w))) & 2147483647u) > 2139095040u));
                    phi_350_ = false;
                } else {
                    phi_349_ = bool();
                    phi_350_ = true;
                }
                let _e139 = phi_349_;
                let _e141 = phi_350_;
                phi_351_ = _e139;
                phi_352_ = false;
                phi_353_ = _e141;
            } else {
                phi_351_ = bool();
                phi_352_ = true;
                phi_353_ = false;
            }
            let _e143 = phi_351_;
            let _e145 = phi_352_;
            let _e147 = phi_353_;
            phi_354_ = _e143;
            phi_355_ = _e145;
            phi_356_ = _e147;
        } else {
            phi_354_ = bool();
            phi_355_ = true;
            phi_356_ = false;
        }
        let _e149 = phi_354_;
        let _e151 = phi_355_;
        let _e153 = phi_356_;
        phi_357_ = _e149;
        phi_358_ = _e151;
        phi_359_ = _e153;
    } else {
        phi_357_ = bool();
        phi_358_ = true;
        phi_359_ = false;
    }
    let _e155 = phi_357_;
    let _e157 = phi_358_;
    let _e159 = phi_359_;
    if _e157 {
        phi_363_ = true;
    } else {
        phi_363_ = _e159;
    }
    let _e161 = phi_363_;
    if _e161 {
        phi_367_ = false;
    } else {
        phi_367_ = _e155;
    }
    let _e163 = phi_367_;
    if _e163 {
        phi_372_ = 1f;
    } else {
        let _e164 = _lt_math_evsm_Evsm_bound_of_offsets(param_9, vec4<f32>(_e114, _e115, _e116, _e117), param_11);
        phi_372_ = _e164;
    }
    let _e166 = phi_372_;
    return _e166;
}

fn function_() {
    var local_1: lt_math_Evsm;
    var phi_1332_: bool;
    var phi_1333_: bool;
    var phi_1334_: bool;
    var phi_1335_: bool;
    var phi_1339_: bool;
    var phi_1383_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1387_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1464_: bool;
    var phi_1473_: bool;
    var phi_1482_: bool;
    var phi_1483_: bool;
    var phi_1484_: bool;
    var phi_1485_: bool;
    var phi_1486_: bool;
    var phi_1487_: bool;
    var phi_1488_: bool;
    var phi_1492_: bool;
    var phi_1586_: f32;
    var phi_1589_: f32;
    var phi_1618_: f32;
    var phi_1623_: f32;
    var phi_1624_: bool;
    var phi_1625_: f32;
    var phi_1626_: bool;
    var phi_1630_: f32;
    var phi_1650_: f32;
    var phi_1655_: f32;
    var phi_1656_: bool;
    var phi_1657_: f32;
    var phi_1658_: bool;
    var phi_1662_: f32;
    var phi_1712_: i32;
    var phi_1717_: i32;
    var phi_1722_: i32;
    var phi_1727_: i32;
    var phi_1736_: i32;
    var phi_1741_: i32;
    var phi_1746_: i32;
    var phi_1751_: i32;
    var phi_1798_: bool;
    var phi_1806_: bool;
    var phi_1818_: bool;
    var phi_1819_: bool;
    var phi_1823_: f32;
    var phi_1829_: f32;
    var phi_1831_: evaluate_Verdict;
    var phi_1836_: evaluate_Verdict;
    var phi_1837_: evaluate_Verdict;
    var phi_1841_: bool;
    var phi_1842_: u32;
    var phi_1853_: u32;

    let _e52 = id_1;
    let _e53 = local_2;
    let _e58 = arrayLength((&map.member));
    let _e63 = p.member.size[0u];
    let _e65 = p.member.size[1u];
    let _e66 = lt_shaders_entry_pixel_index(_e52, _e63, _e65);
    if (bitcast<i32>(_e66.root) != 0i) {
        let _e73 = p.member.light;
        let _e76 = samples.member[_e66.first_primitive].normal[0u];
        let _e78 = global[0u];
        if (_e76 == _e78) {
            let _e81 = samples.member[_e66.first_primitive].normal[1u];
            let _e83 = global[1u];
            if (_e81 == _e83) {
                let _e86 = samples.member[_e66.first_primitive].normal[2u];
                let _e88 = global[2u];
                phi_1332_ = (_e86 == _e88);
                phi_1333_ = false;
            } else {
                phi_1332_ = bool();
                phi_1333_ = true;
            }
            let _e91 = phi_1332_;
            let _e93 = phi_1333_;
            phi_1334_ = _e91;
            phi_1335_ = _e93;
        } else {
            phi_1334_ = bool();
            phi_1335_ = true;
        }
        let _e95 = phi_1334_;
        let _e97 = phi_1335_;
        if _e97 {
            phi_1339_ = false;
        } else {
            phi_1339_ = _e95;
        }
        let _e99 = phi_1339_;
        if !(_e99) {
            let _e102 = samples.member[_e66.first_primitive].normal;
            let _e104 = samples.member[_e66.first_primitive].position;
            if ((((_e102.x * (_e73.x - (_e104.x * _e73.w))) + (_e102.y * (_e73.y - (_e104.y * _e73.w)))) + (_e102.z * (_e73.z - (_e104.z * _e73.w)))) > 0f) {
                let _e128 = samples.member[_e66.first_primitive].flags;
                let _e136 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e142 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e136.unnamed.visibility, false), _e136.unnamed_1);
                phi_1383_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e142.unnamed, ((_e128 & 1u) == 0u));
            } else {
                let _e151 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e157 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e151.unnamed.visibility, false), _e151.unnamed_1);
                phi_1383_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e157.unnamed, true);
            }
            let _e162 = phi_1383_;
            phi_1387_ = _e162;
        } else {
            let _e168 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e174 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e168.unnamed.visibility, false), _e168.unnamed_1);
            phi_1387_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e174.unnamed, true);
        }
        let _e179 = phi_1387_;
        if _e179.unnamed_1 {
            phi_1837_ = evaluate_Verdict(_e179.unnamed.visibility, _e179.unnamed.is_doubted);
        } else {
            let _e187 = samples.member[_e66.first_primitive].position;
            let _e193 = p.member.projection.row_w;
            let _e204 = ((((_e193.x * _e187.x) + (_e193.y * _e187.y)) + (_e193.z * _e187.z)) + (_e193.w * 1f));
            let _e206 = p.member.projection.row_x;
            let _e218 = (((((_e206.x * _e187.x) + (_e206.y * _e187.y)) + (_e206.z * _e187.z)) + (_e206.w * 1f)) / _e204);
            let _e220 = p.member.projection.row_y;
            let _e232 = (((((_e220.x * _e187.x) + (_e220.y * _e187.y)) + (_e220.z * _e187.z)) + (_e220.w * 1f)) / _e204);
            let _e234 = p.member.projection.row_z;
            let _e245 = ((((_e234.x * _e187.x) + (_e234.y * _e187.y)) + (_e234.z * _e187.z)) + (_e234.w * 1f));
            if (_e204 > 0f) {
                if (_e218 >= 0f) {
                    phi_1464_ = (_e218 <= 1f);
                } else {
                    phi_1464_ = false;
                }
                let _e250 = phi_1464_;
                if _e250 {
                    if (_e232 >= 0f) {
                        phi_1473_ = (_e232 <= 1f);
                    } else {
                        phi_1473_ = false;
                    }
                    let _e254 = phi_1473_;
                    if _e254 {
                        if (_e245 >= 0f) {
                            phi_1482_ = (_e245 <= 1f);
                        } else {
                            phi_1482_ = false;
                        }
                        let _e258 = phi_1482_;
                        phi_1483_ = _e258;
                        phi_1484_ = false;
                    } else {
                        phi_1483_ = bool();
                        phi_1484_ = true;
                    }
                    let _e260 = phi_1483_;
                    let _e262 = phi_1484_;
                    phi_1485_ = _e260;
                    phi_1486_ = _e262;
                } else {
                    phi_1485_ = bool();
                    phi_1486_ = true;
                }
                let _e264 = phi_1485_;
                let _e266 = phi_1486_;
                phi_1487_ = _e264;
                phi_1488_ = _e266;
            } else {
                phi_1487_ = bool();
                phi_1488_ = true;
            }
            let _e268 = phi_1487_;
            let _e270 = phi_1488_;
            if _e270 {
                phi_1492_ = false;
            } else {
                phi_1492_ = _e268;
            }
            let _e272 = phi_1492_;
            if _e272 {
                if (0f > 0f) {
                    let _e275 = samples.member[_e66.first_primitive].normal;
                    let _e277 = p.member.map_size;
                    let _e280 = p.member.projection.row_x;
                    let _e302 = p.member.projection.row_y;
                    let _e324 = p.member.projection.row_z;
                    let _e351 = ((abs(((((_e280.x * _e275.x) + (_e280.y * _e275.y)) + (_e280.z * _e275.z)) / (((_e280.x * _e280.x) + (_e280.y * _e280.y)) + (_e280.z * _e280.z)))) + abs(((((_e302.x * _e275.x) + (_e302.y * _e275.y)) + (_e302.z * _e275.z)) / (((_e302.x * _e302.x) + (_e302.y * _e302.y)) + (_e302.z * _e302.z))))) / (abs(((((_e324.x * _e275.x) + (_e324.y * _e275.y)) + (_e324.z * _e275.z)) / (((_e324.x * _e324.x) + (_e324.y * _e324.y)) + (_e324.z * _e324.z)))) * f32(_e277)));
                    if (_e351 < 0.002f) {
                        phi_1586_ = _e351;
                    } else {
                        phi_1586_ = 0.002f;
                    }
                    let _e354 = phi_1586_;
                    phi_1589_ = (_e245 - (0f * _e354));
                } else {
                    phi_1589_ = _e245;
                }
                let _e358 = phi_1589_;
                let _e360 = p.member.map_size;
                let _e361 = f32(_e360);
                let _e364 = ((_e218 * _e361) - 0.5f);
                let _e365 = ((_e232 * _e361) - 0.5f);
                if (_e364 > -8388608f) {
                    let _e377 = f32(select(0i, select(select(i32(_e364), i32(-2147483648), (_e364 < bitcast<f32>(3472883712u))), 2147483647i, (_e364 > bitcast<f32>(1325400063u))), (_e364 == _e364)));
                    if (_e377 > _e364) {
                        phi_1618_ = 1f;
                    } else {
                        phi_1618_ = 0f;
                    }
                    let _e380 = phi_1618_;
                    if (_e364 < 8388608f) {
                        phi_1623_ = (_e377 - _e380);
                        phi_1624_ = false;
                    } else {
                        phi_1623_ = f32();
                        phi_1624_ = true;
                    }
                    let _e383 = phi_1623_;
                    let _e385 = phi_1624_;
                    phi_1625_ = _e383;
                    phi_1626_ = _e385;
                } else {
                    phi_1625_ = f32();
                    phi_1626_ = true;
                }
                let _e387 = phi_1625_;
                let _e389 = phi_1626_;
                if _e389 {
                    phi_1630_ = _e364;
                } else {
                    phi_1630_ = _e387;
                }
                let _e391 = phi_1630_;
                if (_e365 > -8388608f) {
                    let _e403 = f32(select(0i, select(select(i32(_e365), i32(-2147483648), (_e365 < bitcast<f32>(3472883712u))), 2147483647i, (_e365 > bitcast<f32>(1325400063u))), (_e365 == _e365)));
                    if (_e403 > _e365) {
                        phi_1650_ = 1f;
                    } else {
                        phi_1650_ = 0f;
                    }
                    let _e406 = phi_1650_;
                    if (_e365 < 8388608f) {
                        phi_1655_ = (_e403 - _e406);
                        phi_1656_ = false;
                    } else {
                        phi_1655_ = f32();
                        phi_1656_ = true;
                    }
                    let _e409 = phi_1655_;
                    let _e411 = phi_1656_;
                    phi_1657_ = _e409;
                    phi_1658_ = _e411;
                } else {
                    phi_1657_ = f32();
                    phi_1658_ = true;
                }
                let _e413 = phi_1657_;
                let _e415 = phi_1658_;
                if _e415 {
                    phi_1662_ = _e365;
                } else {
                    phi_1662_ = _e413;
                }
                let _e417 = phi_1662_;
                let _e418 = (_e364 - _e391);
                let _e419 = (_e365 - _e417);
                let _e428 = select(0i, select(select(i32(_e391), i32(-2147483648), (_e391 < bitcast<f32>(3472883712u))), 2147483647i, (_e391 > bitcast<f32>(1325400063u))), (_e391 == _e391));
                let _e437 = select(0i, select(select(i32(_e417), i32(-2147483648), (_e417 < bitcast<f32>(3472883712u))), 2147483647i, (_e417 > bitcast<f32>(1325400063u))), (_e417 == _e417));
                let _e448 = p.member.test;
                let _e449 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e448);
                let _e451 = p.member.map_size;
                local_1 = lt_math_Evsm(_e449.positive_exponent, _e449.negative_exponent, _e449.min_variance);
                let _e457 = (bitcast<i32>(_e451) - 1i);
                if (_e428 > 0i) {
                    phi_1712_ = _e428;
                } else {
                    phi_1712_ = 0i;
                }
                let _e460 = phi_1712_;
                if (_e437 > 0i) {
                    phi_1717_ = _e437;
                } else {
                    phi_1717_ = 0i;
                }
                let _e463 = phi_1717_;
                if (_e460 < _e457) {
                    phi_1722_ = _e460;
                } else {
                    phi_1722_ = _e457;
                }
                let _e466 = phi_1722_;
                if (_e463 < _e457) {
                    phi_1727_ = _e463;
                } else {
                    phi_1727_ = _e457;
                }
                let _e469 = phi_1727_;
                let _e470 = bitcast<u32>(_e466);
                let _e472 = (_e428 + 1i);
                let _e473 = (_e437 + 1i);
                if (_e472 > 0i) {
                    phi_1736_ = _e472;
                } else {
                    phi_1736_ = 0i;
                }
                let _e476 = phi_1736_;
                if (_e473 > 0i) {
                    phi_1741_ = _e473;
                } else {
                    phi_1741_ = 0i;
                }
                let _e479 = phi_1741_;
                if (_e476 < _e457) {
                    phi_1746_ = _e476;
                } else {
                    phi_1746_ = _e457;
                }
                let _e482 = phi_1746_;
                if (_e479 < _e457) {
                    phi_1751_ = _e479;
                } else {
                    phi_1751_ = _e457;
                }
                let _e485 = phi_1751_;
                let _e486 = bitcast<u32>(_e482);
                let _e488 = (bitcast<u32>(_e469) * _e451);
                let _e489 = (bitcast<u32>(_e485) * _e451);
                let _e490 = (_e488 + _e470);
                let _e491 = (_e488 + _e486);
                let _e492 = (_e489 + _e470);
                let _e493 = (_e489 + _e486);
                if (_e490 < _e58) {
                } else {
                    return;
                }
                let _e497 = map.member[(0u + _e490)];
                if (_e491 < _e58) {
                } else {
                    return;
                }
                let _e501 = map.member[(0u + _e491)];
                if (_e492 < _e58) {
                } else {
                    return;
                }
                let _e505 = map.member[(0u + _e492)];
                if (_e493 < _e58) {
                } else {
                    return;
                }
                let _e509 = map.member[(0u + _e493)];
                let _e511 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local_1), vec4<f32>(_e497, _e501, _e505, _e509), vec4<f32>(((1f - _e418) * (1f - _e419)), (_e418 * (1f - _e419)), ((1f - _e418) * _e419), (_e418 * _e419)), _e358);
                let _e513 = p.member.epsilon;
                if (_e511 <= _e513) {
                    phi_1798_ = true;
                } else {
                    phi_1798_ = (_e511 >= (1f - _e513));
                }
                let _e518 = phi_1798_;
                if ((bitcast<u32>(_e511) & 2147483647u) > 2139095040u) {
                    phi_1806_ = true;
                } else {
                    phi_1806_ = !(_e518);
                }
                let _e524 = phi_1806_;
                if _e524 {
                    if (_e511 > 0f) {
                        if (_e511 < 1f) {
                            phi_1818_ = false;
                        } else {
                            phi_1818_ = true;
                        }
                        let _e528 = phi_1818_;
                        phi_1819_ = _e528;
                    } else {
                        phi_1819_ = true;
                    }
                    let _e530 = phi_1819_;
                    if _e530 {
                        phi_1823_ = 0.5f;
                    } else {
                        phi_1823_ = _e511;
                    }
                    let _e532 = phi_1823_;
                    phi_1831_ = evaluate_Verdict(_e532, true);
                } else {
                    if (_e511 > 0.5f) {
                        phi_1829_ = 1f;
                    } else {
                        phi_1829_ = 0f;
                    }
                    let _e536 = phi_1829_;
                    phi_1831_ = evaluate_Verdict(_e536, false);
                }
                let _e539 = phi_1831_;
                phi_1836_ = evaluate_Verdict(_e539.visibility, _e539.is_doubted);
            } else {
                phi_1836_ = evaluate_Verdict(0.5f, true);
            }
            let _e545 = phi_1836_;
            phi_1837_ = _e545;
        }
        let _e547 = phi_1837_;
        visibility.member[_e66.first_primitive] = _e547.visibility;
        phi_1841_ = _e547.is_doubted;
        phi_1842_ = _e66.first_primitive;
    } else {
        phi_1841_ = false;
        phi_1842_ = 0u;
    }
    let _e552 = phi_1841_;
    let _e554 = phi_1842_;
    if (_e53 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e552 {
        let _e558 = atomicAdd((&shared_[0u]), 1u);
        phi_1853_ = _e558;
    } else {
        phi_1853_ = 0u;
    }
    let _e560 = phi_1853_;
    workgroupBarrier();
    if (_e53 == 0u) {
        let _e564 = atomicLoad((&shared_[0u]));
        let _e565 = atomicAdd((&list.member[3u]), _e564);
        atomicStore((&shared_[1u]), _e565);
    }
    workgroupBarrier();
    if _e552 {
        let _e568 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e568) + _e560)]), _e554);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_evsm_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
