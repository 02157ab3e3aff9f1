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

struct lt_math_Evsm {
    positive_exponent: f32,
    negative_exponent: f32,
    min_variance: f32,
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
    var phi_167_: lt_bvh_traverse_Tree;
    var phi_168_: bool;
    var phi_169_: lt_bvh_traverse_Tree;
    var phi_170_: bool;
    var phi_175_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_167_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_168_ = false;
        } else {
            phi_167_ = lt_bvh_traverse_Tree();
            phi_168_ = true;
        }
        let _e66 = phi_167_;
        let _e68 = phi_168_;
        phi_169_ = _e66;
        phi_170_ = _e68;
    } else {
        phi_169_ = lt_bvh_traverse_Tree();
        phi_170_ = true;
    }
    let _e70 = phi_169_;
    let _e72 = phi_170_;
    if _e72 {
        phi_175_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_175_ = _e70;
    }
    let _e77 = phi_175_;
    return lt_bvh_traverse_Tree(_e77.root, _e77.first_primitive);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> lt_math_Evsm {
    return lt_math_Evsm(param_3.x, param_3.y, param_3.z);
}

fn _lt_math_evsm_Evsm_bound_of_offsets(param_4: ptr<function, lt_math_Evsm>, param_5: vec4<f32>, param_6: vec4<f32>) -> f32 {
    var phi_355_: bool;
    var phi_359_: f32;
    var phi_378_: f32;
    var phi_383_: f32;
    var phi_405_: f32;
    var phi_410_: f32;
    var phi_411_: bool;
    var phi_412_: f32;
    var phi_413_: bool;
    var phi_417_: f32;
    var phi_455_: f32;
    var phi_466_: f32;
    var phi_471_: f32;
    var phi_493_: f32;
    var phi_498_: f32;
    var phi_499_: bool;
    var phi_500_: f32;
    var phi_501_: bool;
    var phi_505_: f32;
    var phi_543_: f32;
    var phi_554_: f32;
    var phi_559_: f32;
    var phi_581_: f32;
    var phi_586_: f32;
    var phi_587_: bool;
    var phi_588_: f32;
    var phi_589_: bool;
    var phi_593_: f32;
    var phi_631_: f32;
    var phi_642_: f32;
    var phi_647_: f32;
    var phi_669_: f32;
    var phi_674_: f32;
    var phi_675_: bool;
    var phi_676_: f32;
    var phi_677_: bool;
    var phi_681_: f32;
    var phi_719_: f32;
    var phi_772_: bool;
    var phi_776_: f32;
    var phi_788_: bool;
    var phi_795_: f32;
    var phi_808_: bool;
    var phi_812_: f32;
    var phi_832_: f32;
    var phi_837_: f32;
    var phi_859_: f32;
    var phi_864_: f32;
    var phi_865_: bool;
    var phi_866_: f32;
    var phi_867_: bool;
    var phi_871_: f32;
    var phi_909_: f32;
    var phi_920_: f32;
    var phi_925_: f32;
    var phi_947_: f32;
    var phi_952_: f32;
    var phi_953_: bool;
    var phi_954_: f32;
    var phi_955_: bool;
    var phi_959_: f32;
    var phi_997_: f32;
    var phi_1008_: f32;
    var phi_1013_: f32;
    var phi_1035_: f32;
    var phi_1040_: f32;
    var phi_1041_: bool;
    var phi_1042_: f32;
    var phi_1043_: bool;
    var phi_1047_: f32;
    var phi_1085_: f32;
    var phi_1096_: f32;
    var phi_1101_: f32;
    var phi_1123_: f32;
    var phi_1128_: f32;
    var phi_1129_: bool;
    var phi_1130_: f32;
    var phi_1131_: bool;
    var phi_1135_: f32;
    var phi_1173_: f32;
    var phi_1226_: bool;
    var phi_1230_: f32;
    var phi_1242_: bool;
    var phi_1249_: f32;
    var phi_1260_: bool;
    var phi_1264_: f32;
    var phi_1279_: f32;
    var phi_1280_: f32;
    var phi_1281_: f32;

    let _e57 = (*param_4).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_355_ = true;
    } else {
        let _e61 = (42f < _e57);
        if _e61 {
        }
        phi_355_ = _e61;
    }
    let _e63 = phi_355_;
    if _e63 {
        phi_359_ = 42f;
    } else {
        phi_359_ = _e57;
    }
    let _e65 = phi_359_;
    let _e67 = (_e65 * param_5.x);
    let _e69 = (_e65 * param_5.y);
    let _e71 = (_e65 * param_5.z);
    let _e73 = (_e65 * param_5.w);
    if ((bitcast<u32>(_e67) & 2147483647u) > 2139095040u) {
        phi_455_ = _e67;
    } else {
        if (_e67 < -87f) {
            phi_378_ = -87f;
        } else {
            phi_378_ = _e67;
        }
        let _e79 = phi_378_;
        if (_e79 > 88f) {
            phi_383_ = 88f;
        } else {
            phi_383_ = _e79;
        }
        let _e82 = phi_383_;
        let _e84 = ((_e82 * 1.442695f) + 0.5f);
        if (_e84 > -8388608f) {
            let _e96 = f32(select(0i, select(select(i32(_e84), i32(-2147483648), (_e84 < bitcast<f32>(3472883712u))), 2147483647i, (_e84 > bitcast<f32>(1325400063u))), (_e84 == _e84)));
            if (_e96 > _e84) {
                phi_405_ = 1f;
            } else {
                phi_405_ = 0f;
            }
            let _e99 = phi_405_;
            if (_e84 < 8388608f) {
                phi_410_ = (_e96 - _e99);
                phi_411_ = false;
            } else {
                phi_410_ = f32();
                phi_411_ = true;
            }
            let _e102 = phi_410_;
            let _e104 = phi_411_;
            phi_412_ = _e102;
            phi_413_ = _e104;
        } else {
            phi_412_ = f32();
            phi_413_ = true;
        }
        let _e106 = phi_412_;
        let _e108 = phi_413_;
        if _e108 {
            phi_417_ = _e84;
        } else {
            phi_417_ = _e106;
        }
        let _e110 = phi_417_;
        let _e114 = ((_e82 - (_e110 * 0.69314575f)) - (_e110 * 0.0000014286068f));
        phi_455_ = ((((((((((((((((1f / 5040f) * _e114) + (1f / 720f)) * _e114) + (1f / 120f)) * _e114) + (1f / 24f)) * _e114) + (1f / 6f)) * _e114) + 0.5f) * _e114) + 1f) * _e114) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e110), i32(-2147483648), (_e110 < bitcast<f32>(3472883712u))), 2147483647i, (_e110 > bitcast<f32>(1325400063u))), (_e110 == _e110)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e150 = phi_455_;
    if ((bitcast<u32>(_e69) & 2147483647u) > 2139095040u) {
        phi_543_ = _e69;
    } else {
        if (_e69 < -87f) {
            phi_466_ = -87f;
        } else {
            phi_466_ = _e69;
        }
        let _e156 = phi_466_;
        if (_e156 > 88f) {
            phi_471_ = 88f;
        } else {
            phi_471_ = _e156;
        }
        let _e159 = phi_471_;
        let _e161 = ((_e159 * 1.442695f) + 0.5f);
        if (_e161 > -8388608f) {
            let _e173 = f32(select(0i, select(select(i32(_e161), i32(-2147483648), (_e161 < bitcast<f32>(3472883712u))), 2147483647i, (_e161 > bitcast<f32>(1325400063u))), (_e161 == _e161)));
            if (_e173 > _e161) {
                phi_493_ = 1f;
            } else {
                phi_493_ = 0f;
            }
            let _e176 = phi_493_;
            if (_e161 < 8388608f) {
                phi_498_ = (_e173 - _e176);
                phi_499_ = false;
            } else {
                phi_498_ = f32();
                phi_499_ = true;
            }
            let _e179 = phi_498_;
            let _e181 = phi_499_;
            phi_500_ = _e179;
            phi_501_ = _e181;
        } else {
            phi_500_ = f32();
            phi_501_ = true;
        }
        let _e183 = phi_500_;
        let _e185 = phi_501_;
        if _e185 {
            phi_505_ = _e161;
        } else {
            phi_505_ = _e183;
        }
        let _e187 = phi_505_;
        let _e191 = ((_e159 - (_e187 * 0.69314575f)) - (_e187 * 0.0000014286068f));
        phi_543_ = ((((((((((((((((1f / 5040f) * _e191) + (1f / 720f)) * _e191) + (1f / 120f)) * _e191) + (1f / 24f)) * _e191) + (1f / 6f)) * _e191) + 0.5f) * _e191) + 1f) * _e191) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e187), i32(-2147483648), (_e187 < bitcast<f32>(3472883712u))), 2147483647i, (_e187 > bitcast<f32>(1325400063u))), (_e187 == _e187)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e227 = phi_543_;
    if ((bitcast<u32>(_e71) & 2147483647u) > 2139095040u) {
        phi_631_ = _e71;
    } else {
        if (_e71 < -87f) {
            phi_554_ = -87f;
        } else {
            phi_554_ = _e71;
        }
        let _e233 = phi_554_;
        if (_e233 > 88f) {
            phi_559_ = 88f;
        } else {
            phi_559_ = _e233;
        }
        let _e236 = phi_559_;
        let _e238 = ((_e236 * 1.442695f) + 0.5f);
        if (_e238 > -8388608f) {
            let _e250 = f32(select(0i, select(select(i32(_e238), i32(-2147483648), (_e238 < bitcast<f32>(3472883712u))), 2147483647i, (_e238 > bitcast<f32>(1325400063u))), (_e238 == _e238)));
            if (_e250 > _e238) {
                phi_581_ = 1f;
            } else {
                phi_581_ = 0f;
            }
            let _e253 = phi_581_;
            if (_e238 < 8388608f) {
                phi_586_ = (_e250 - _e253);
                phi_587_ = false;
            } else {
                phi_586_ = f32();
                phi_587_ = true;
            }
            let _e256 = phi_586_;
            let _e258 = phi_587_;
            phi_588_ = _e256;
            phi_589_ = _e258;
        } else {
            phi_588_ = f32();
            phi_589_ = true;
        }
        let _e260 = phi_588_;
        let _e262 = phi_589_;
        if _e262 {
            phi_593_ = _e238;
        } else {
            phi_593_ = _e260;
        }
        let _e264 = phi_593_;
        let _e268 = ((_e236 - (_e264 * 0.69314575f)) - (_e264 * 0.0000014286068f));
        phi_631_ = ((((((((((((((((1f / 5040f) * _e268) + (1f / 720f)) * _e268) + (1f / 120f)) * _e268) + (1f / 24f)) * _e268) + (1f / 6f)) * _e268) + 0.5f) * _e268) + 1f) * _e268) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e264), i32(-2147483648), (_e264 < bitcast<f32>(3472883712u))), 2147483647i, (_e264 > bitcast<f32>(1325400063u))), (_e264 == _e264)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e304 = phi_631_;
    if ((bitcast<u32>(_e73) & 2147483647u) > 2139095040u) {
        phi_719_ = _e73;
    } else {
        if (_e73 < -87f) {
            phi_642_ = -87f;
        } else {
            phi_642_ = _e73;
        }
        let _e310 = phi_642_;
        if (_e310 > 88f) {
            phi_647_ = 88f;
        } else {
            phi_647_ = _e310;
        }
        let _e313 = phi_647_;
        let _e315 = ((_e313 * 1.442695f) + 0.5f);
        if (_e315 > -8388608f) {
            let _e327 = f32(select(0i, select(select(i32(_e315), i32(-2147483648), (_e315 < bitcast<f32>(3472883712u))), 2147483647i, (_e315 > bitcast<f32>(1325400063u))), (_e315 == _e315)));
            if (_e327 > _e315) {
                phi_669_ = 1f;
            } else {
                phi_669_ = 0f;
            }
            let _e330 = phi_669_;
            if (_e315 < 8388608f) {
                phi_674_ = (_e327 - _e330);
                phi_675_ = false;
            } else {
                phi_674_ = f32();
                phi_675_ = true;
            }
            let _e333 = phi_674_;
            let _e335 = phi_675_;
            phi_676_ = _e333;
            phi_677_ = _e335;
        } else {
            phi_676_ = f32();
            phi_677_ = true;
        }
        let _e337 = phi_676_;
        let _e339 = phi_677_;
        if _e339 {
            phi_681_ = _e315;
        } else {
            phi_681_ = _e337;
        }
        let _e341 = phi_681_;
        let _e345 = ((_e313 - (_e341 * 0.69314575f)) - (_e341 * 0.0000014286068f));
        phi_719_ = ((((((((((((((((1f / 5040f) * _e345) + (1f / 720f)) * _e345) + (1f / 120f)) * _e345) + (1f / 24f)) * _e345) + (1f / 6f)) * _e345) + 0.5f) * _e345) + 1f) * _e345) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e341), i32(-2147483648), (_e341 < bitcast<f32>(3472883712u))), 2147483647i, (_e341 > bitcast<f32>(1325400063u))), (_e341 == _e341)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e381 = phi_719_;
    let _e383 = (_e150 - vec4<f32>(1f, 1f, 1f, 1f).x);
    let _e385 = (_e227 - vec4<f32>(1f, 1f, 1f, 1f).y);
    let _e387 = (_e304 - vec4<f32>(1f, 1f, 1f, 1f).z);
    let _e389 = (_e381 - vec4<f32>(1f, 1f, 1f, 1f).w);
    let _e391 = (*param_4).min_variance;
    let _e393 = ((_e391 * _e65) * _e65);
    let _e404 = ((((_e383 * param_6.x) + (_e385 * param_6.y)) + (_e387 * param_6.z)) + (_e389 * param_6.w));
    let _e405 = (_e383 - _e404);
    let _e406 = (_e385 - _e404);
    let _e407 = (_e387 - _e404);
    let _e408 = (_e389 - _e404);
    let _e423 = (((((_e405 * _e405) * param_6.x) + ((_e406 * _e406) * param_6.y)) + ((_e407 * _e407) * param_6.z)) + ((_e408 * _e408) * param_6.w));
    if ((bitcast<u32>(_e393) & 2147483647u) > 2139095040u) {
        phi_772_ = true;
    } else {
        let _e427 = (_e393 > _e423);
        if _e427 {
        }
        phi_772_ = _e427;
    }
    let _e429 = phi_772_;
    if _e429 {
        phi_776_ = _e393;
    } else {
        phi_776_ = _e423;
    }
    let _e431 = phi_776_;
    let _e432 = -(_e404);
    if (_e432 <= 0f) {
        let _e436 = ((bitcast<u32>(_e431) & 2147483647u) > 2139095040u);
        if _e436 {
        }
        phi_788_ = _e436;
    } else {
        phi_788_ = true;
    }
    let _e438 = phi_788_;
    if _e438 {
        phi_795_ = (_e431 / (_e431 + (_e432 * _e432)));
    } else {
        phi_795_ = 1f;
    }
    let _e443 = phi_795_;
    let _e445 = (*param_4).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_808_ = true;
    } else {
        let _e449 = (42f < _e445);
        if _e449 {
        }
        phi_808_ = _e449;
    }
    let _e451 = phi_808_;
    if _e451 {
        phi_812_ = 42f;
    } else {
        phi_812_ = _e445;
    }
    let _e453 = phi_812_;
    let _e454 = -(_e453);
    let _e456 = (_e454 * param_5.x);
    let _e458 = (_e454 * param_5.y);
    let _e460 = (_e454 * param_5.z);
    let _e462 = (_e454 * param_5.w);
    if ((bitcast<u32>(_e456) & 2147483647u) > 2139095040u) {
        phi_909_ = _e456;
    } else {
        if (_e456 < -87f) {
            phi_832_ = -87f;
        } else {
            phi_832_ = _e456;
        }
        let _e468 = phi_832_;
        if (_e468 > 88f) {
            phi_837_ = 88f;
        } else {
            phi_837_ = _e468;
        }
        let _e471 = phi_837_;
        let _e473 = ((_e471 * 1.442695f) + 0.5f);
        if (_e473 > -8388608f) {
            let _e485 = f32(select(0i, select(select(i32(_e473), i32(-2147483648), (_e473 < bitcast<f32>(3472883712u))), 2147483647i, (_e473 > bitcast<f32>(1325400063u))), (_e473 == _e473)));
            if (_e485 > _e473) {
                phi_859_ = 1f;
            } else {
                phi_859_ = 0f;
            }
            let _e488 = phi_859_;
            if (_e473 < 8388608f) {
                phi_864_ = (_e485 - _e488);
                phi_865_ = false;
            } else {
                phi_864_ = f32();
                phi_865_ = true;
            }
            let _e491 = phi_864_;
            let _e493 = phi_865_;
            phi_866_ = _e491;
            phi_867_ = _e493;
        } else {
            phi_866_ = f32();
            phi_867_ = true;
        }
        let _e495 = phi_866_;
        let _e497 = phi_867_;
        if _e497 {
            phi_871_ = _e473;
        } else {
            phi_871_ = _e495;
        }
        let _e499 = phi_871_;
        let _e503 = ((_e471 - (_e499 * 0.69314575f)) - (_e499 * 0.0000014286068f));
        phi_909_ = ((((((((((((((((1f / 5040f) * _e503) + (1f / 720f)) * _e503) + (1f / 120f)) * _e503) + (1f / 24f)) * _e503) + (1f / 6f)) * _e503) + 0.5f) * _e503) + 1f) * _e503) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e499), i32(-2147483648), (_e499 < bitcast<f32>(3472883712u))), 2147483647i, (_e499 > bitcast<f32>(1325400063u))), (_e499 == _e499)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e539 = phi_909_;
    if ((bitcast<u32>(_e458) & 2147483647u) > 2139095040u) {
        phi_997_ = _e458;
    } else {
        if (_e458 < -87f) {
            phi_920_ = -87f;
        } else {
            phi_920_ = _e458;
        }
        let _e545 = phi_920_;
        if (_e545 > 88f) {
            phi_925_ = 88f;
        } else {
            phi_925_ = _e545;
        }
        let _e548 = phi_925_;
        let _e550 = ((_e548 * 1.442695f) + 0.5f);
        if (_e550 > -8388608f) {
            let _e562 = f32(select(0i, select(select(i32(_e550), i32(-2147483648), (_e550 < bitcast<f32>(3472883712u))), 2147483647i, (_e550 > bitcast<f32>(1325400063u))), (_e550 == _e550)));
            if (_e562 > _e550) {
                phi_947_ = 1f;
            } else {
                phi_947_ = 0f;
            }
            let _e565 = phi_947_;
            if (_e550 < 8388608f) {
                phi_952_ = (_e562 - _e565);
                phi_953_ = false;
            } else {
                phi_952_ = f32();
                phi_953_ = true;
            }
            let _e568 = phi_952_;
            let _e570 = phi_953_;
            phi_954_ = _e568;
            phi_955_ = _e570;
        } else {
            phi_954_ = f32();
            phi_955_ = true;
        }
        let _e572 = phi_954_;
        let _e574 = phi_955_;
        if _e574 {
            phi_959_ = _e550;
        } else {
            phi_959_ = _e572;
        }
        let _e576 = phi_959_;
        let _e580 = ((_e548 - (_e576 * 0.69314575f)) - (_e576 * 0.0000014286068f));
        phi_997_ = ((((((((((((((((1f / 5040f) * _e580) + (1f / 720f)) * _e580) + (1f / 120f)) * _e580) + (1f / 24f)) * _e580) + (1f / 6f)) * _e580) + 0.5f) * _e580) + 1f) * _e580) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e576), i32(-2147483648), (_e576 < bitcast<f32>(3472883712u))), 2147483647i, (_e576 > bitcast<f32>(1325400063u))), (_e576 == _e576)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e616 = phi_997_;
    if ((bitcast<u32>(_e460) & 2147483647u) > 2139095040u) {
        phi_1085_ = _e460;
    } else {
        if (_e460 < -87f) {
            phi_1008_ = -87f;
        } else {
            phi_1008_ = _e460;
        }
        let _e622 = phi_1008_;
        if (_e622 > 88f) {
            phi_1013_ = 88f;
        } else {
            phi_1013_ = _e622;
        }
        let _e625 = phi_1013_;
        let _e627 = ((_e625 * 1.442695f) + 0.5f);
        if (_e627 > -8388608f) {
            let _e639 = f32(select(0i, select(select(i32(_e627), i32(-2147483648), (_e627 < bitcast<f32>(3472883712u))), 2147483647i, (_e627 > bitcast<f32>(1325400063u))), (_e627 == _e627)));
            if (_e639 > _e627) {
                phi_1035_ = 1f;
            } else {
                phi_1035_ = 0f;
            }
            let _e642 = phi_1035_;
            if (_e627 < 8388608f) {
                phi_1040_ = (_e639 - _e642);
                phi_1041_ = false;
            } else {
                phi_1040_ = f32();
                phi_1041_ = true;
            }
            let _e645 = phi_1040_;
            let _e647 = phi_1041_;
            phi_1042_ = _e645;
            phi_1043_ = _e647;
        } else {
            phi_1042_ = f32();
            phi_1043_ = true;
        }
        let _e649 = phi_1042_;
        let _e651 = phi_1043_;
        if _e651 {
            phi_1047_ = _e627;
        } else {
            phi_1047_ = _e649;
        }
        let _e653 = phi_1047_;
        let _e657 = ((_e625 - (_e653 * 0.69314575f)) - (_e653 * 0.0000014286068f));
        phi_1085_ = ((((((((((((((((1f / 5040f) * _e657) + (1f / 720f)) * _e657) + (1f / 120f)) * _e657) + (1f / 24f)) * _e657) + (1f / 6f)) * _e657) + 0.5f) * _e657) + 1f) * _e657) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e653), i32(-2147483648), (_e653 < bitcast<f32>(3472883712u))), 2147483647i, (_e653 > bitcast<f32>(1325400063u))), (_e653 == _e653)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e693 = phi_1085_;
    if ((bitcast<u32>(_e462) & 2147483647u) > 2139095040u) {
        phi_1173_ = _e462;
    } else {
        if (_e462 < -87f) {
            phi_1096_ = -87f;
        } else {
            phi_1096_ = _e462;
        }
        let _e699 = phi_1096_;
        if (_e699 > 88f) {
            phi_1101_ = 88f;
        } else {
            phi_1101_ = _e699;
        }
        let _e702 = phi_1101_;
        let _e704 = ((_e702 * 1.442695f) + 0.5f);
        if (_e704 > -8388608f) {
            let _e716 = f32(select(0i, select(select(i32(_e704), i32(-2147483648), (_e704 < bitcast<f32>(3472883712u))), 2147483647i, (_e704 > bitcast<f32>(1325400063u))), (_e704 == _e704)));
            if (_e716 > _e704) {
                phi_1123_ = 1f;
            } else {
                phi_1123_ = 0f;
            }
            let _e719 = phi_1123_;
            if (_e704 < 8388608f) {
                phi_1128_ = (_e716 - _e719);
                phi_1129_ = false;
            } else {
                phi_1128_ = f32();
                phi_1129_ = true;
            }
            let _e722 = phi_1128_;
            let _e724 = phi_1129_;
            phi_1130_ = _e722;
            phi_1131_ = _e724;
        } else {
            phi_1130_ = f32();
            phi_1131_ = true;
        }
        let _e726 = phi_1130_;
        let _e728 = phi_1131_;
        if _e728 {
            phi_1135_ = _e704;
        } else {
            phi_1135_ = _e726;
        }
        let _e730 = phi_1135_;
        let _e734 = ((_e702 - (_e730 * 0.69314575f)) - (_e730 * 0.0000014286068f));
        phi_1173_ = ((((((((((((((((1f / 5040f) * _e734) + (1f / 720f)) * _e734) + (1f / 120f)) * _e734) + (1f / 24f)) * _e734) + (1f / 6f)) * _e734) + 0.5f) * _e734) + 1f) * _e734) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e730), i32(-2147483648), (_e730 < bitcast<f32>(3472883712u))), 2147483647i, (_e730 > bitcast<f32>(1325400063u))), (_e730 == _e730)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e770 = phi_1173_;
    let _e772 = (vec4<f32>(1f, 1f, 1f, 1f).x - _e539);
    let _e774 = (vec4<f32>(1f, 1f, 1f, 1f).y - _e616);
    let _e776 = (vec4<f32>(1f, 1f, 1f, 1f).z - _e693);
    let _e778 = (vec4<f32>(1f, 1f, 1f, 1f).w - _e770);
    let _e780 = (*param_4).min_variance;
    let _e782 = ((_e780 * _e453) * _e453);
    let _e793 = ((((_e772 * param_6.x) + (_e774 * param_6.y)) + (_e776 * param_6.z)) + (_e778 * param_6.w));
    let _e794 = (_e772 - _e793);
    let _e795 = (_e774 - _e793);
    let _e796 = (_e776 - _e793);
    let _e797 = (_e778 - _e793);
    let _e812 = (((((_e794 * _e794) * param_6.x) + ((_e795 * _e795) * param_6.y)) + ((_e796 * _e796) * param_6.z)) + ((_e797 * _e797) * param_6.w));
    if ((bitcast<u32>(_e782) & 2147483647u) > 2139095040u) {
        phi_1226_ = true;
    } else {
        let _e816 = (_e782 > _e812);
        if _e816 {
        }
        phi_1226_ = _e816;
    }
    let _e818 = phi_1226_;
    if _e818 {
        phi_1230_ = _e782;
    } else {
        phi_1230_ = _e812;
    }
    let _e820 = phi_1230_;
    let _e821 = -(_e793);
    if (_e821 <= 0f) {
        let _e825 = ((bitcast<u32>(_e820) & 2147483647u) > 2139095040u);
        if _e825 {
        }
        phi_1242_ = _e825;
    } else {
        phi_1242_ = true;
    }
    let _e827 = phi_1242_;
    if _e827 {
        phi_1249_ = (_e820 / (_e820 + (_e821 * _e821)));
    } else {
        phi_1249_ = 1f;
    }
    let _e832 = phi_1249_;
    if ((bitcast<u32>(_e832) & 2147483647u) > 2139095040u) {
        phi_1260_ = true;
    } else {
        let _e836 = (_e832 < _e443);
        if _e836 {
        }
        phi_1260_ = _e836;
    }
    let _e838 = phi_1260_;
    if _e838 {
        phi_1264_ = _e832;
    } else {
        phi_1264_ = _e443;
    }
    let _e840 = phi_1264_;
    if ((bitcast<u32>(_e840) & 2147483647u) > 2139095040u) {
        phi_1281_ = _e840;
    } else {
        if (_e840 < 0f) {
            phi_1280_ = 0f;
        } else {
            if (_e840 > 1f) {
                phi_1279_ = 1f;
            } else {
                phi_1279_ = _e840;
            }
            let _e847 = phi_1279_;
            phi_1280_ = _e847;
        }
        let _e849 = phi_1280_;
        phi_1281_ = _e849;
    }
    let _e851 = phi_1281_;
    return _e851;
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_7: ptr<function, lt_math_Evsm>, param_8: vec4<f32>, param_9: vec4<f32>, param_10: f32) -> f32 {
    var phi_204_: f32;
    var phi_205_: f32;
    var phi_206_: f32;
    var phi_222_: f32;
    var phi_223_: f32;
    var phi_224_: f32;
    var phi_240_: f32;
    var phi_241_: f32;
    var phi_242_: f32;
    var phi_258_: f32;
    var phi_259_: f32;
    var phi_260_: f32;
    var phi_276_: f32;
    var phi_277_: f32;
    var phi_278_: f32;
    var phi_315_: bool;
    var phi_316_: bool;
    var phi_317_: bool;
    var phi_318_: bool;
    var phi_319_: bool;
    var phi_320_: bool;
    var phi_321_: bool;
    var phi_322_: bool;
    var phi_323_: bool;
    var phi_324_: bool;
    var phi_325_: bool;
    var phi_329_: bool;
    var phi_333_: bool;
    var phi_338_: f32;

    if ((bitcast<u32>(param_10) & 2147483647u) > 2139095040u) {
        phi_206_ = param_10;
    } else {
        if (param_10 < 0f) {
            phi_205_ = 0f;
        } else {
            if (param_10 > 1f) {
                phi_204_ = 1f;
            } else {
                phi_204_ = param_10;
            }
            let _e63 = phi_204_;
            phi_205_ = _e63;
        }
        let _e65 = phi_205_;
        phi_206_ = _e65;
    }
    let _e67 = phi_206_;
    if ((bitcast<u32>(param_8.x) & 2147483647u) > 2139095040u) {
        phi_224_ = param_8.x;
    } else {
        if (param_8.x < 0f) {
            phi_223_ = 0f;
        } else {
            if (param_8.x > 1f) {
                phi_222_ = 1f;
            } else {
                phi_222_ = param_8.x;
            }
            let _e75 = phi_222_;
            phi_223_ = _e75;
        }
        let _e77 = phi_223_;
        phi_224_ = _e77;
    }
    let _e79 = phi_224_;
    if ((bitcast<u32>(param_8.y) & 2147483647u) > 2139095040u) {
        phi_242_ = param_8.y;
    } else {
        if (param_8.y < 0f) {
            phi_241_ = 0f;
        } else {
            if (param_8.y > 1f) {
                phi_240_ = 1f;
            } else {
                phi_240_ = param_8.y;
            }
            let _e87 = phi_240_;
            phi_241_ = _e87;
        }
        let _e89 = phi_241_;
        phi_242_ = _e89;
    }
    let _e91 = phi_242_;
    if ((bitcast<u32>(param_8.z) & 2147483647u) > 2139095040u) {
        phi_260_ = param_8.z;
    } else {
        if (param_8.z < 0f) {
            phi_259_ = 0f;
        } else {
            if (param_8.z > 1f) {
                phi_258_ = 1f;
            } else {
                phi_258_ = param_8.z;
            }
            let _e99 = phi_258_;
            phi_259_ = _e99;
        }
        let _e101 = phi_259_;
        phi_260_ = _e101;
    }
    let _e103 = phi_260_;
    if ((bitcast<u32>(param_8.w) & 2147483647u) > 2139095040u) {
        phi_278_ = param_8.w;
    } else {
        if (param_8.w < 0f) {
            phi_277_ = 0f;
        } else {
            if (param_8.w > 1f) {
                phi_276_ = 1f;
            } else {
                phi_276_ = param_8.w;
            }
            let _e111 = phi_276_;
            phi_277_ = _e111;
        }
        let _e113 = phi_277_;
        phi_278_ = _e113;
    }
    let _e115 = phi_278_;
    let _e116 = (_e79 - _e67);
    let _e117 = (_e91 - _e67);
    let _e118 = (_e103 - _e67);
    let _e119 = (_e115 - _e67);
    if (_e116 >= 0f) {
        if (_e117 >= 0f) {
            if (_e118 >= 0f) {
                if (_e119 >= 0f) {
                    phi_315_ = !(((bitcast<u32>(((((_e116 * param_9.x) + (_e117 * param_9.y)) + (_e118 * param_9.z)) + (_e119 * param_9.w))) & 2147483647u) > 2139095040u));
                    phi_316_ = false;
                } else {
                    phi_315_ = bool();
                    phi_316_ = true;
                }
                let _e141 = phi_315_;
                let _e143 = phi_316_;
                phi_317_ = _e141;
                phi_318_ = false;
                phi_319_ = _e143;
            } else {
                phi_317_ = bool();
                phi_318_ = true;
                phi_319_ = false;
            }
            let _e145 = phi_317_;
            let _e147 = phi_318_;
            let _e149 = phi_319_;
            phi_320_ = _e145;
            phi_321_ = _e147;
            phi_322_ = _e149;
        } else {
            phi_320_ = bool();
            phi_321_ = true;
            phi_322_ = false;
        }
        let _e151 = phi_320_;
        let _e153 = phi_321_;
        let _e155 = phi_322_;
        phi_323_ = _e151;
        phi_324_ = _e153;
        phi_325_ = _e155;
    } else {
        phi_323_ = bool();
        phi_324_ = true;
        phi_325_ = false;
    }
    let _e157 = phi_323_;
    let _e159 = phi_324_;
    let _e161 = phi_325_;
    if _e159 {
        phi_329_ = true;
    } else {
        phi_329_ = _e161;
    }
    let _e163 = phi_329_;
    if _e163 {
        phi_333_ = false;
    } else {
        phi_333_ = _e157;
    }
    let _e165 = phi_333_;
    if _e165 {
        phi_338_ = 1f;
    } else {
        let _e166 = _lt_math_evsm_Evsm_bound_of_offsets(param_7, vec4<f32>(_e116, _e117, _e118, _e119), param_9);
        phi_338_ = _e166;
    }
    let _e168 = phi_338_;
    return _e168;
}

fn function_() {
    var local: lt_math_Evsm;
    var phi_1343_: bool;
    var phi_1344_: bool;
    var phi_1345_: bool;
    var phi_1346_: bool;
    var phi_1350_: bool;
    var phi_1420_: bool;
    var phi_1421_: bool;
    var phi_1432_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1433_: bool;
    var phi_1434_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1435_: bool;
    var phi_1442_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1446_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1520_: bool;
    var phi_1529_: bool;
    var phi_1538_: bool;
    var phi_1539_: bool;
    var phi_1540_: bool;
    var phi_1541_: bool;
    var phi_1542_: bool;
    var phi_1543_: bool;
    var phi_1544_: bool;
    var phi_1548_: bool;
    var phi_1638_: f32;
    var phi_1641_: f32;
    var phi_1670_: f32;
    var phi_1675_: f32;
    var phi_1676_: bool;
    var phi_1677_: f32;
    var phi_1678_: bool;
    var phi_1682_: f32;
    var phi_1702_: f32;
    var phi_1707_: f32;
    var phi_1708_: bool;
    var phi_1709_: f32;
    var phi_1710_: bool;
    var phi_1714_: f32;
    var phi_1768_: i32;
    var phi_1773_: i32;
    var phi_1778_: i32;
    var phi_1783_: i32;
    var phi_1792_: i32;
    var phi_1797_: i32;
    var phi_1802_: i32;
    var phi_1807_: i32;
    var phi_1862_: i32;
    var phi_1867_: i32;
    var phi_1872_: i32;
    var phi_1877_: i32;
    var phi_1896_: i32;
    var phi_1901_: i32;
    var phi_1906_: i32;
    var phi_1911_: i32;
    var phi_1930_: i32;
    var phi_1935_: i32;
    var phi_1940_: i32;
    var phi_1945_: i32;
    var phi_1964_: i32;
    var phi_1969_: i32;
    var phi_1974_: i32;
    var phi_1979_: i32;
    var phi_2057_: bool;
    var phi_2065_: bool;
    var phi_2077_: bool;
    var phi_2078_: bool;
    var phi_2082_: f32;
    var phi_2088_: f32;
    var phi_2090_: evaluate_Verdict;
    var phi_2100_: u32;
    var phi_2109_: f32;
    var phi_2111_: evaluate_Verdict;
    var phi_2112_: bool;
    var phi_2113_: evaluate_Verdict;
    var phi_2114_: bool;
    var phi_2119_: evaluate_Verdict;
    var phi_2124_: evaluate_Verdict;
    var phi_2125_: evaluate_Verdict;

    let _e54 = id_1;
    let _e61 = arrayLength((&map.member));
    let _e67 = arrayLength((&marks.member));
    let _e70 = p.member.size[0u];
    let _e72 = p.member.size[1u];
    let _e73 = lt_shaders_entry_pixel_index(_e54, _e70, _e72);
    if (bitcast<i32>(_e73.root) != 0i) {
        let _e79 = p.member.projection;
        if (_e73.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e83 = lt_math_OneLevel(_e79);
        let _e87 = samples.member[(0u + _e73.first_primitive)].normal[0u];
        let _e89 = global[0u];
        if (_e87 == _e89) {
            let _e92 = samples.member[(0u + _e73.first_primitive)].normal[1u];
            let _e94 = global[1u];
            if (_e92 == _e94) {
                let _e97 = samples.member[(0u + _e73.first_primitive)].normal[2u];
                let _e99 = global[2u];
                phi_1343_ = (_e97 == _e99);
                phi_1344_ = false;
            } else {
                phi_1343_ = bool();
                phi_1344_ = true;
            }
            let _e102 = phi_1343_;
            let _e104 = phi_1344_;
            phi_1345_ = _e102;
            phi_1346_ = _e104;
        } else {
            phi_1345_ = bool();
            phi_1346_ = true;
        }
        let _e106 = phi_1345_;
        let _e108 = phi_1346_;
        if _e108 {
            phi_1350_ = false;
        } else {
            phi_1350_ = _e106;
        }
        let _e110 = phi_1350_;
        if !(_e110) {
            let _e113 = samples.member[(0u + _e73.first_primitive)].position;
            let _e115 = p.member.light.place;
            let _e121 = p.member.light.place[3u];
            let _e128 = (_e115.x - (_e113.x * _e121));
            let _e129 = (_e115.y - (_e113.y * _e121));
            let _e130 = (_e115.z - (_e113.z * _e121));
            let _e132 = samples.member[(0u + _e73.first_primitive)].normal;
            if ((((_e132.x * _e128) + (_e132.y * _e129)) + (_e132.z * _e130)) > 0f) {
                let _e146 = (((_e128 * _e128) + (_e129 * _e129)) + (_e130 * _e130));
                let _e148 = p.member.light.axis;
                let _e160 = p.member.light.place[3u];
                if (_e160 == 0f) {
                    phi_1421_ = true;
                } else {
                    let _e163 = p.member.light.range_squared;
                    if (_e146 <= _e163) {
                        let _e166 = p.member.light.cos_outer;
                        phi_1420_ = (-((((_e128 * _e148.x) + (_e129 * _e148.y)) + (_e130 * _e148.z))) >= (_e166 * sqrt(_e146)));
                    } else {
                        phi_1420_ = false;
                    }
                    let _e171 = phi_1420_;
                    phi_1421_ = _e171;
                }
                let _e173 = phi_1421_;
                if _e173 {
                    let _e175 = samples.member[(0u + _e73.first_primitive)].flags;
                    let _e183 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e189 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e183.unnamed.visibility, false), _e183.unnamed_1);
                    phi_1432_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e189.unnamed, ((_e175 & 1u) == 0u));
                    phi_1433_ = false;
                } else {
                    phi_1432_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_1433_ = true;
                }
                let _e194 = phi_1432_;
                let _e196 = phi_1433_;
                phi_1434_ = _e194;
                phi_1435_ = _e196;
            } else {
                phi_1434_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_1435_ = true;
            }
            let _e198 = phi_1434_;
            let _e200 = phi_1435_;
            if _e200 {
                let _e206 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e212 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e206.unnamed.visibility, false), _e206.unnamed_1);
                phi_1442_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e212.unnamed, true);
            } else {
                phi_1442_ = _e198;
            }
            let _e217 = phi_1442_;
            phi_1446_ = _e217;
        } else {
            let _e223 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e229 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e223.unnamed.visibility, false), _e223.unnamed_1);
            phi_1446_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e229.unnamed, true);
        }
        let _e234 = phi_1446_;
        if _e234.unnamed_1 {
            phi_2125_ = evaluate_Verdict(_e234.unnamed.visibility, _e234.unnamed.is_doubted);
        } else {
            let _e242 = samples.member[(0u + _e73.first_primitive)].position;
            let _e260 = ((((_e83.projection.row_w.x * _e242.x) + (_e83.projection.row_w.y * _e242.y)) + (_e83.projection.row_w.z * _e242.z)) + (_e83.projection.row_w.w * 1f));
            let _e274 = (((((_e83.projection.row_x.x * _e242.x) + (_e83.projection.row_x.y * _e242.y)) + (_e83.projection.row_x.z * _e242.z)) + (_e83.projection.row_x.w * 1f)) / _e260);
            let _e288 = (((((_e83.projection.row_y.x * _e242.x) + (_e83.projection.row_y.y * _e242.y)) + (_e83.projection.row_y.z * _e242.z)) + (_e83.projection.row_y.w * 1f)) / _e260);
            let _e301 = ((((_e83.projection.row_z.x * _e242.x) + (_e83.projection.row_z.y * _e242.y)) + (_e83.projection.row_z.z * _e242.z)) + (_e83.projection.row_z.w * 1f));
            if (_e260 > 0f) {
                if (_e274 >= 0f) {
                    phi_1520_ = (_e274 <= 1f);
                } else {
                    phi_1520_ = false;
                }
                let _e306 = phi_1520_;
                if _e306 {
                    if (_e288 >= 0f) {
                        phi_1529_ = (_e288 <= 1f);
                    } else {
                        phi_1529_ = false;
                    }
                    let _e310 = phi_1529_;
                    if _e310 {
                        if (_e301 >= 0f) {
                            phi_1538_ = (_e301 <= 1f);
                        } else {
                            phi_1538_ = false;
                        }
                        let _e314 = phi_1538_;
                        phi_1539_ = _e314;
                        phi_1540_ = false;
                    } else {
                        phi_1539_ = bool();
                        phi_1540_ = true;
                    }
                    let _e316 = phi_1539_;
                    let _e318 = phi_1540_;
                    phi_1541_ = _e316;
                    phi_1542_ = _e318;
                } else {
                    phi_1541_ = bool();
                    phi_1542_ = true;
                }
                let _e320 = phi_1541_;
                let _e322 = phi_1542_;
                phi_1543_ = _e320;
                phi_1544_ = _e322;
            } else {
                phi_1543_ = bool();
                phi_1544_ = true;
            }
            let _e324 = phi_1543_;
            let _e326 = phi_1544_;
            if _e326 {
                phi_1548_ = false;
            } else {
                phi_1548_ = _e324;
            }
            let _e328 = phi_1548_;
            if _e328 {
                if (0f > 0f) {
                    let _e331 = samples.member[(0u + _e73.first_primitive)].normal;
                    let _e333 = p.member.map_size;
                    let _e403 = ((abs(((((_e79.row_x.x * _e331.x) + (_e79.row_x.y * _e331.y)) + (_e79.row_x.z * _e331.z)) / (((_e79.row_x.x * _e79.row_x.x) + (_e79.row_x.y * _e79.row_x.y)) + (_e79.row_x.z * _e79.row_x.z)))) + abs(((((_e79.row_y.x * _e331.x) + (_e79.row_y.y * _e331.y)) + (_e79.row_y.z * _e331.z)) / (((_e79.row_y.x * _e79.row_y.x) + (_e79.row_y.y * _e79.row_y.y)) + (_e79.row_y.z * _e79.row_y.z))))) / (abs(((((_e79.row_z.x * _e331.x) + (_e79.row_z.y * _e331.y)) + (_e79.row_z.z * _e331.z)) / (((_e79.row_z.x * _e79.row_z.x) + (_e79.row_z.y * _e79.row_z.y)) + (_e79.row_z.z * _e79.row_z.z)))) * f32(_e333)));
                    if (_e403 < 0.002f) {
                        phi_1638_ = _e403;
                    } else {
                        phi_1638_ = 0.002f;
                    }
                    let _e406 = phi_1638_;
                    phi_1641_ = (_e301 - (0f * _e406));
                } else {
                    phi_1641_ = _e301;
                }
                let _e410 = phi_1641_;
                let _e412 = p.member.map_size;
                let _e413 = f32(_e412);
                let _e416 = ((_e274 * _e413) - 0.5f);
                let _e417 = ((_e288 * _e413) - 0.5f);
                if (_e416 > -8388608f) {
                    let _e429 = f32(select(0i, select(select(i32(_e416), i32(-2147483648), (_e416 < bitcast<f32>(3472883712u))), 2147483647i, (_e416 > bitcast<f32>(1325400063u))), (_e416 == _e416)));
                    if (_e429 > _e416) {
                        phi_1670_ = 1f;
                    } else {
                        phi_1670_ = 0f;
                    }
                    let _e432 = phi_1670_;
                    if (_e416 < 8388608f) {
                        phi_1675_ = (_e429 - _e432);
                        phi_1676_ = false;
                    } else {
                        phi_1675_ = f32();
                        phi_1676_ = true;
                    }
                    let _e435 = phi_1675_;
                    let _e437 = phi_1676_;
                    phi_1677_ = _e435;
                    phi_1678_ = _e437;
                } else {
                    phi_1677_ = f32();
                    phi_1678_ = true;
                }
                let _e439 = phi_1677_;
                let _e441 = phi_1678_;
                if _e441 {
                    phi_1682_ = _e416;
                } else {
                    phi_1682_ = _e439;
                }
                let _e443 = phi_1682_;
                if (_e417 > -8388608f) {
                    let _e455 = f32(select(0i, select(select(i32(_e417), i32(-2147483648), (_e417 < bitcast<f32>(3472883712u))), 2147483647i, (_e417 > bitcast<f32>(1325400063u))), (_e417 == _e417)));
                    if (_e455 > _e417) {
                        phi_1702_ = 1f;
                    } else {
                        phi_1702_ = 0f;
                    }
                    let _e458 = phi_1702_;
                    if (_e417 < 8388608f) {
                        phi_1707_ = (_e455 - _e458);
                        phi_1708_ = false;
                    } else {
                        phi_1707_ = f32();
                        phi_1708_ = true;
                    }
                    let _e461 = phi_1707_;
                    let _e463 = phi_1708_;
                    phi_1709_ = _e461;
                    phi_1710_ = _e463;
                } else {
                    phi_1709_ = f32();
                    phi_1710_ = true;
                }
                let _e465 = phi_1709_;
                let _e467 = phi_1710_;
                if _e467 {
                    phi_1714_ = _e417;
                } else {
                    phi_1714_ = _e465;
                }
                let _e469 = phi_1714_;
                let _e470 = (_e416 - _e443);
                let _e471 = (_e417 - _e469);
                let _e480 = select(0i, select(select(i32(_e443), i32(-2147483648), (_e443 < bitcast<f32>(3472883712u))), 2147483647i, (_e443 > bitcast<f32>(1325400063u))), (_e443 == _e443));
                let _e489 = select(0i, select(select(i32(_e469), i32(-2147483648), (_e469 < bitcast<f32>(3472883712u))), 2147483647i, (_e469 > bitcast<f32>(1325400063u))), (_e469 == _e469));
                let _e500 = p.member.test;
                let _e501 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e500);
                let _e503 = p.member.map_size;
                local = lt_math_Evsm(_e501.positive_exponent, _e501.negative_exponent, _e501.min_variance);
                let _e509 = ((0u * _e503) * _e503);
                let _e511 = (bitcast<i32>(_e503) - 1i);
                if (_e480 > 0i) {
                    phi_1768_ = _e480;
                } else {
                    phi_1768_ = 0i;
                }
                let _e514 = phi_1768_;
                if (_e489 > 0i) {
                    phi_1773_ = _e489;
                } else {
                    phi_1773_ = 0i;
                }
                let _e517 = phi_1773_;
                if (_e514 < _e511) {
                    phi_1778_ = _e514;
                } else {
                    phi_1778_ = _e511;
                }
                let _e520 = phi_1778_;
                if (_e517 < _e511) {
                    phi_1783_ = _e517;
                } else {
                    phi_1783_ = _e511;
                }
                let _e523 = phi_1783_;
                let _e524 = bitcast<u32>(_e520);
                let _e526 = (_e480 + 1i);
                let _e527 = (_e489 + 1i);
                if (_e526 > 0i) {
                    phi_1792_ = _e526;
                } else {
                    phi_1792_ = 0i;
                }
                let _e530 = phi_1792_;
                if (_e527 > 0i) {
                    phi_1797_ = _e527;
                } else {
                    phi_1797_ = 0i;
                }
                let _e533 = phi_1797_;
                if (_e530 < _e511) {
                    phi_1802_ = _e530;
                } else {
                    phi_1802_ = _e511;
                }
                let _e536 = phi_1802_;
                if (_e533 < _e511) {
                    phi_1807_ = _e533;
                } else {
                    phi_1807_ = _e511;
                }
                let _e539 = phi_1807_;
                let _e540 = bitcast<u32>(_e536);
                let _e542 = (bitcast<u32>(_e523) * _e503);
                let _e543 = (bitcast<u32>(_e539) * _e503);
                let _e548 = ((_e542 + _e524) + _e509);
                let _e549 = ((_e542 + _e540) + _e509);
                let _e550 = ((_e543 + _e524) + _e509);
                let _e551 = ((_e543 + _e540) + _e509);
                if (_e548 < _e61) {
                } else {
                    return;
                }
                let _e555 = map.member[(0u + _e548)];
                if (_e549 < _e61) {
                } else {
                    return;
                }
                let _e559 = map.member[(0u + _e549)];
                if (_e550 < _e61) {
                } else {
                    return;
                }
                let _e563 = map.member[(0u + _e550)];
                if (_e551 < _e61) {
                } else {
                    return;
                }
                let _e567 = map.member[(0u + _e551)];
                let _e569 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e555, _e559, _e563, _e567), vec4<f32>(((1f - _e470) * (1f - _e471)), (_e470 * (1f - _e471)), ((1f - _e470) * _e471), (_e470 * _e471)), _e410);
                let _e571 = p.member.map_size;
                let _e573 = (bitcast<i32>(_e571) - 1i);
                if (_e480 > 0i) {
                    phi_1862_ = _e480;
                } else {
                    phi_1862_ = 0i;
                }
                let _e576 = phi_1862_;
                if (_e489 > 0i) {
                    phi_1867_ = _e489;
                } else {
                    phi_1867_ = 0i;
                }
                let _e579 = phi_1867_;
                if (_e576 < _e573) {
                    phi_1872_ = _e576;
                } else {
                    phi_1872_ = _e573;
                }
                let _e582 = phi_1872_;
                if (_e579 < _e573) {
                    phi_1877_ = _e579;
                } else {
                    phi_1877_ = _e573;
                }
                let _e585 = phi_1877_;
                let _e586 = bitcast<u32>(_e582);
                let _e593 = ((((0u * _e571) + bitcast<u32>(_e585)) * (_e571 / 16u)) + (_e586 / 16u));
                let _e596 = (_e480 + 1i);
                let _e597 = (_e489 + 0i);
                let _e599 = (bitcast<i32>(_e571) - 1i);
                if (_e596 > 0i) {
                    phi_1896_ = _e596;
                } else {
                    phi_1896_ = 0i;
                }
                let _e602 = phi_1896_;
                if (_e597 > 0i) {
                    phi_1901_ = _e597;
                } else {
                    phi_1901_ = 0i;
                }
                let _e605 = phi_1901_;
                if (_e602 < _e599) {
                    phi_1906_ = _e602;
                } else {
                    phi_1906_ = _e599;
                }
                let _e608 = phi_1906_;
                if (_e605 < _e599) {
                    phi_1911_ = _e605;
                } else {
                    phi_1911_ = _e599;
                }
                let _e611 = phi_1911_;
                let _e612 = bitcast<u32>(_e608);
                let _e619 = ((((0u * _e571) + bitcast<u32>(_e611)) * (_e571 / 16u)) + (_e612 / 16u));
                let _e622 = (_e480 + 0i);
                let _e623 = (_e489 + 1i);
                let _e625 = (bitcast<i32>(_e571) - 1i);
                if (_e622 > 0i) {
                    phi_1930_ = _e622;
                } else {
                    phi_1930_ = 0i;
                }
                let _e628 = phi_1930_;
                if (_e623 > 0i) {
                    phi_1935_ = _e623;
                } else {
                    phi_1935_ = 0i;
                }
                let _e631 = phi_1935_;
                if (_e628 < _e625) {
                    phi_1940_ = _e628;
                } else {
                    phi_1940_ = _e625;
                }
                let _e634 = phi_1940_;
                if (_e631 < _e625) {
                    phi_1945_ = _e631;
                } else {
                    phi_1945_ = _e625;
                }
                let _e637 = phi_1945_;
                let _e638 = bitcast<u32>(_e634);
                let _e645 = ((((0u * _e571) + bitcast<u32>(_e637)) * (_e571 / 16u)) + (_e638 / 16u));
                let _e648 = (_e480 + 1i);
                let _e649 = (_e489 + 1i);
                let _e651 = (bitcast<i32>(_e571) - 1i);
                if (_e648 > 0i) {
                    phi_1964_ = _e648;
                } else {
                    phi_1964_ = 0i;
                }
                let _e654 = phi_1964_;
                if (_e649 > 0i) {
                    phi_1969_ = _e649;
                } else {
                    phi_1969_ = 0i;
                }
                let _e657 = phi_1969_;
                if (_e654 < _e651) {
                    phi_1974_ = _e654;
                } else {
                    phi_1974_ = _e651;
                }
                let _e660 = phi_1974_;
                if (_e657 < _e651) {
                    phi_1979_ = _e657;
                } else {
                    phi_1979_ = _e651;
                }
                let _e663 = phi_1979_;
                let _e664 = bitcast<u32>(_e660);
                let _e671 = ((((0u * _e571) + bitcast<u32>(_e663)) * (_e571 / 16u)) + (_e664 / 16u));
                if (_e593 < _e67) {
                } else {
                    return;
                }
                let _e677 = marks.member[(0u + _e593)];
                if (_e619 < _e67) {
                } else {
                    return;
                }
                let _e685 = marks.member[(0u + _e619)];
                if (_e645 < _e67) {
                } else {
                    return;
                }
                let _e694 = marks.member[(0u + _e645)];
                if (_e671 < _e67) {
                } else {
                    return;
                }
                let _e702 = marks.member[(0u + _e671)];
                let _e710 = p.member.epsilon;
                if (_e569 <= _e710) {
                    phi_2057_ = true;
                } else {
                    phi_2057_ = (_e569 >= (1f - _e710));
                }
                let _e715 = phi_2057_;
                if ((bitcast<u32>(_e569) & 2147483647u) > 2139095040u) {
                    phi_2065_ = true;
                } else {
                    phi_2065_ = !(_e715);
                }
                let _e721 = phi_2065_;
                if _e721 {
                    if (_e569 > 0f) {
                        if (_e569 < 1f) {
                            phi_2077_ = false;
                        } else {
                            phi_2077_ = true;
                        }
                        let _e725 = phi_2077_;
                        phi_2078_ = _e725;
                    } else {
                        phi_2078_ = true;
                    }
                    let _e727 = phi_2078_;
                    if _e727 {
                        phi_2082_ = 0.5f;
                    } else {
                        phi_2082_ = _e569;
                    }
                    let _e729 = phi_2082_;
                    phi_2090_ = evaluate_Verdict(_e729, true);
                } else {
                    if (_e569 > 0.5f) {
                        phi_2088_ = 1f;
                    } else {
                        phi_2088_ = 0f;
                    }
                    let _e733 = phi_2088_;
                    phi_2090_ = evaluate_Verdict(_e733, false);
                }
                let _e736 = phi_2090_;
                let _e739 = (_e736.visibility < 0.5f);
                if _e736.is_doubted {
                    phi_2113_ = evaluate_Verdict();
                    phi_2114_ = true;
                } else {
                    if _e739 {
                        phi_2100_ = 2u;
                    } else {
                        phi_2100_ = 1u;
                    }
                    let _e741 = phi_2100_;
                    if ((((((_e677 >> bitcast<u32>((((_e586 % 16u) * 2u) & 31u))) & 3u) | ((_e685 >> bitcast<u32>((((_e612 % 16u) * 2u) & 31u))) & 3u)) | (((_e694 >> bitcast<u32>((((_e638 % 16u) * 2u) & 31u))) & 3u) | ((_e702 >> bitcast<u32>((((_e664 % 16u) * 2u) & 31u))) & 3u))) & _e741) != 0u) {
                        if _e739 {
                            phi_2109_ = 0.000000059604645f;
                        } else {
                            phi_2109_ = 0.99999994f;
                        }
                        let _e745 = phi_2109_;
                        phi_2111_ = evaluate_Verdict(_e745, true);
                        phi_2112_ = false;
                    } else {
                        phi_2111_ = evaluate_Verdict();
                        phi_2112_ = true;
                    }
                    let _e748 = phi_2111_;
                    let _e750 = phi_2112_;
                    phi_2113_ = _e748;
                    phi_2114_ = _e750;
                }
                let _e752 = phi_2113_;
                let _e754 = phi_2114_;
                if _e754 {
                    phi_2119_ = evaluate_Verdict(_e736.visibility, _e736.is_doubted);
                } else {
                    phi_2119_ = _e752;
                }
                let _e757 = phi_2119_;
                phi_2124_ = evaluate_Verdict(_e757.visibility, _e757.is_doubted);
            } else {
                phi_2124_ = evaluate_Verdict(0.5f, true);
            }
            let _e763 = phi_2124_;
            phi_2125_ = _e763;
        }
        let _e765 = phi_2125_;
        if (_e73.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e73.first_primitive)] = _e765.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_evsm_marks_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
