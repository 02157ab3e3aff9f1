struct abi_LightParams {
    place: vec4<f32>,
    axis: vec3<f32>,
    cos_outer: f32,
    range_squared: f32,
    cos_inner: f32,
    number: u32,
    mask_words: u32,
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

struct type_15 {
    member: array<abi_Sample>,
}

struct type_19 {
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

struct type_31 {
    member: abi_ShadowParams,
}

struct type_35 {
    member: array<lt_math_LightProjection>,
}

struct lt_math_LightPoint {
    uv: vec2<f32>,
    depth: f32,
    is_inside: bool,
}

struct lt_math_LevelPoint {
    level: u32,
    point: lt_math_LightPoint,
}

struct lt_math_Evsm {
    positive_exponent: f32,
    negative_exponent: f32,
    min_variance: f32,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_15;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_31;
@group(0) @binding(2) 
var<storage> map: type_19;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_19;
@group(0) @binding(4) 
var<storage> levels: type_35;

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
        let _e69 = phi_167_;
        let _e71 = phi_168_;
        phi_169_ = _e69;
        phi_170_ = _e71;
    } else {
        phi_169_ = lt_bvh_traverse_Tree();
        phi_170_ = true;
    }
    let _e73 = phi_169_;
    let _e75 = phi_170_;
    if _e75 {
        phi_175_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_175_ = _e73;
    }
    let _e80 = phi_175_;
    return lt_bvh_traverse_Tree(_e80.root, _e80.first_primitive);
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

    let _e60 = (*param_4).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_355_ = true;
    } else {
        let _e64 = (42f < _e60);
        if _e64 {
        }
        phi_355_ = _e64;
    }
    let _e66 = phi_355_;
    if _e66 {
        phi_359_ = 42f;
    } else {
        phi_359_ = _e60;
    }
    let _e68 = phi_359_;
    let _e70 = (_e68 * param_5.x);
    let _e72 = (_e68 * param_5.y);
    let _e74 = (_e68 * param_5.z);
    let _e76 = (_e68 * param_5.w);
    if ((bitcast<u32>(_e70) & 2147483647u) > 2139095040u) {
        phi_455_ = _e70;
    } else {
        if (_e70 < -87f) {
            phi_378_ = -87f;
        } else {
            phi_378_ = _e70;
        }
        let _e82 = phi_378_;
        if (_e82 > 88f) {
            phi_383_ = 88f;
        } else {
            phi_383_ = _e82;
        }
        let _e85 = phi_383_;
        let _e87 = ((_e85 * 1.442695f) + 0.5f);
        if (_e87 > -8388608f) {
            let _e99 = f32(select(0i, select(select(i32(_e87), i32(-2147483648), (_e87 < bitcast<f32>(3472883712u))), 2147483647i, (_e87 > bitcast<f32>(1325400063u))), (_e87 == _e87)));
            if (_e99 > _e87) {
                phi_405_ = 1f;
            } else {
                phi_405_ = 0f;
            }
            let _e102 = phi_405_;
            if (_e87 < 8388608f) {
                phi_410_ = (_e99 - _e102);
                phi_411_ = false;
            } else {
                phi_410_ = f32();
                phi_411_ = true;
            }
            let _e105 = phi_410_;
            let _e107 = phi_411_;
            phi_412_ = _e105;
            phi_413_ = _e107;
        } else {
            phi_412_ = f32();
            phi_413_ = true;
        }
        let _e109 = phi_412_;
        let _e111 = phi_413_;
        if _e111 {
            phi_417_ = _e87;
        } else {
            phi_417_ = _e109;
        }
        let _e113 = phi_417_;
        let _e117 = ((_e85 - (_e113 * 0.69314575f)) - (_e113 * 0.0000014286068f));
        phi_455_ = ((((((((((((((((1f / 5040f) * _e117) + (1f / 720f)) * _e117) + (1f / 120f)) * _e117) + (1f / 24f)) * _e117) + (1f / 6f)) * _e117) + 0.5f) * _e117) + 1f) * _e117) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e113), i32(-2147483648), (_e113 < bitcast<f32>(3472883712u))), 2147483647i, (_e113 > bitcast<f32>(1325400063u))), (_e113 == _e113)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e153 = phi_455_;
    if ((bitcast<u32>(_e72) & 2147483647u) > 2139095040u) {
        phi_543_ = _e72;
    } else {
        if (_e72 < -87f) {
            phi_466_ = -87f;
        } else {
            phi_466_ = _e72;
        }
        let _e159 = phi_466_;
        if (_e159 > 88f) {
            phi_471_ = 88f;
        } else {
            phi_471_ = _e159;
        }
        let _e162 = phi_471_;
        let _e164 = ((_e162 * 1.442695f) + 0.5f);
        if (_e164 > -8388608f) {
            let _e176 = f32(select(0i, select(select(i32(_e164), i32(-2147483648), (_e164 < bitcast<f32>(3472883712u))), 2147483647i, (_e164 > bitcast<f32>(1325400063u))), (_e164 == _e164)));
            if (_e176 > _e164) {
                phi_493_ = 1f;
            } else {
                phi_493_ = 0f;
            }
            let _e179 = phi_493_;
            if (_e164 < 8388608f) {
                phi_498_ = (_e176 - _e179);
                phi_499_ = false;
            } else {
                phi_498_ = f32();
                phi_499_ = true;
            }
            let _e182 = phi_498_;
            let _e184 = phi_499_;
            phi_500_ = _e182;
            phi_501_ = _e184;
        } else {
            phi_500_ = f32();
            phi_501_ = true;
        }
        let _e186 = phi_500_;
        let _e188 = phi_501_;
        if _e188 {
            phi_505_ = _e164;
        } else {
            phi_505_ = _e186;
        }
        let _e190 = phi_505_;
        let _e194 = ((_e162 - (_e190 * 0.69314575f)) - (_e190 * 0.0000014286068f));
        phi_543_ = ((((((((((((((((1f / 5040f) * _e194) + (1f / 720f)) * _e194) + (1f / 120f)) * _e194) + (1f / 24f)) * _e194) + (1f / 6f)) * _e194) + 0.5f) * _e194) + 1f) * _e194) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e190), i32(-2147483648), (_e190 < bitcast<f32>(3472883712u))), 2147483647i, (_e190 > bitcast<f32>(1325400063u))), (_e190 == _e190)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e230 = phi_543_;
    if ((bitcast<u32>(_e74) & 2147483647u) > 2139095040u) {
        phi_631_ = _e74;
    } else {
        if (_e74 < -87f) {
            phi_554_ = -87f;
        } else {
            phi_554_ = _e74;
        }
        let _e236 = phi_554_;
        if (_e236 > 88f) {
            phi_559_ = 88f;
        } else {
            phi_559_ = _e236;
        }
        let _e239 = phi_559_;
        let _e241 = ((_e239 * 1.442695f) + 0.5f);
        if (_e241 > -8388608f) {
            let _e253 = f32(select(0i, select(select(i32(_e241), i32(-2147483648), (_e241 < bitcast<f32>(3472883712u))), 2147483647i, (_e241 > bitcast<f32>(1325400063u))), (_e241 == _e241)));
            if (_e253 > _e241) {
                phi_581_ = 1f;
            } else {
                phi_581_ = 0f;
            }
            let _e256 = phi_581_;
            if (_e241 < 8388608f) {
                phi_586_ = (_e253 - _e256);
                phi_587_ = false;
            } else {
                phi_586_ = f32();
                phi_587_ = true;
            }
            let _e259 = phi_586_;
            let _e261 = phi_587_;
            phi_588_ = _e259;
            phi_589_ = _e261;
        } else {
            phi_588_ = f32();
            phi_589_ = true;
        }
        let _e263 = phi_588_;
        let _e265 = phi_589_;
        if _e265 {
            phi_593_ = _e241;
        } else {
            phi_593_ = _e263;
        }
        let _e267 = phi_593_;
        let _e271 = ((_e239 - (_e267 * 0.69314575f)) - (_e267 * 0.0000014286068f));
        phi_631_ = ((((((((((((((((1f / 5040f) * _e271) + (1f / 720f)) * _e271) + (1f / 120f)) * _e271) + (1f / 24f)) * _e271) + (1f / 6f)) * _e271) + 0.5f) * _e271) + 1f) * _e271) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e267), i32(-2147483648), (_e267 < bitcast<f32>(3472883712u))), 2147483647i, (_e267 > bitcast<f32>(1325400063u))), (_e267 == _e267)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e307 = phi_631_;
    if ((bitcast<u32>(_e76) & 2147483647u) > 2139095040u) {
        phi_719_ = _e76;
    } else {
        if (_e76 < -87f) {
            phi_642_ = -87f;
        } else {
            phi_642_ = _e76;
        }
        let _e313 = phi_642_;
        if (_e313 > 88f) {
            phi_647_ = 88f;
        } else {
            phi_647_ = _e313;
        }
        let _e316 = phi_647_;
        let _e318 = ((_e316 * 1.442695f) + 0.5f);
        if (_e318 > -8388608f) {
            let _e330 = f32(select(0i, select(select(i32(_e318), i32(-2147483648), (_e318 < bitcast<f32>(3472883712u))), 2147483647i, (_e318 > bitcast<f32>(1325400063u))), (_e318 == _e318)));
            if (_e330 > _e318) {
                phi_669_ = 1f;
            } else {
                phi_669_ = 0f;
            }
            let _e333 = phi_669_;
            if (_e318 < 8388608f) {
                phi_674_ = (_e330 - _e333);
                phi_675_ = false;
            } else {
                phi_674_ = f32();
                phi_675_ = true;
            }
            let _e336 = phi_674_;
            let _e338 = phi_675_;
            phi_676_ = _e336;
            phi_677_ = _e338;
        } else {
            phi_676_ = f32();
            phi_677_ = true;
        }
        let _e340 = phi_676_;
        let _e342 = phi_677_;
        if _e342 {
            phi_681_ = _e318;
        } else {
            phi_681_ = _e340;
        }
        let _e344 = phi_681_;
        let _e348 = ((_e316 - (_e344 * 0.69314575f)) - (_e344 * 0.0000014286068f));
        phi_719_ = ((((((((((((((((1f / 5040f) * _e348) + (1f / 720f)) * _e348) + (1f / 120f)) * _e348) + (1f / 24f)) * _e348) + (1f / 6f)) * _e348) + 0.5f) * _e348) + 1f) * _e348) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e344), i32(-2147483648), (_e344 < bitcast<f32>(3472883712u))), 2147483647i, (_e344 > bitcast<f32>(1325400063u))), (_e344 == _e344)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e384 = phi_719_;
    let _e386 = (_e153 - vec4<f32>(1f, 1f, 1f, 1f).x);
    let _e388 = (_e230 - vec4<f32>(1f, 1f, 1f, 1f).y);
    let _e390 = (_e307 - vec4<f32>(1f, 1f, 1f, 1f).z);
    let _e392 = (_e384 - vec4<f32>(1f, 1f, 1f, 1f).w);
    let _e394 = (*param_4).min_variance;
    let _e396 = ((_e394 * _e68) * _e68);
    let _e407 = ((((_e386 * param_6.x) + (_e388 * param_6.y)) + (_e390 * param_6.z)) + (_e392 * param_6.w));
    let _e408 = (_e386 - _e407);
    let _e409 = (_e388 - _e407);
    let _e410 = (_e390 - _e407);
    let _e411 = (_e392 - _e407);
    let _e426 = (((((_e408 * _e408) * param_6.x) + ((_e409 * _e409) * param_6.y)) + ((_e410 * _e410) * param_6.z)) + ((_e411 * _e411) * param_6.w));
    if ((bitcast<u32>(_e396) & 2147483647u) > 2139095040u) {
        phi_772_ = true;
    } else {
        let _e430 = (_e396 > _e426);
        if _e430 {
        }
        phi_772_ = _e430;
    }
    let _e432 = phi_772_;
    if _e432 {
        phi_776_ = _e396;
    } else {
        phi_776_ = _e426;
    }
    let _e434 = phi_776_;
    let _e435 = -(_e407);
    if (_e435 <= 0f) {
        let _e439 = ((bitcast<u32>(_e434) & 2147483647u) > 2139095040u);
        if _e439 {
        }
        phi_788_ = _e439;
    } else {
        phi_788_ = true;
    }
    let _e441 = phi_788_;
    if _e441 {
        phi_795_ = (_e434 / (_e434 + (_e435 * _e435)));
    } else {
        phi_795_ = 1f;
    }
    let _e446 = phi_795_;
    let _e448 = (*param_4).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_808_ = true;
    } else {
        let _e452 = (42f < _e448);
        if _e452 {
        }
        phi_808_ = _e452;
    }
    let _e454 = phi_808_;
    if _e454 {
        phi_812_ = 42f;
    } else {
        phi_812_ = _e448;
    }
    let _e456 = phi_812_;
    let _e457 = -(_e456);
    let _e459 = (_e457 * param_5.x);
    let _e461 = (_e457 * param_5.y);
    let _e463 = (_e457 * param_5.z);
    let _e465 = (_e457 * param_5.w);
    if ((bitcast<u32>(_e459) & 2147483647u) > 2139095040u) {
        phi_909_ = _e459;
    } else {
        if (_e459 < -87f) {
            phi_832_ = -87f;
        } else {
            phi_832_ = _e459;
        }
        let _e471 = phi_832_;
        if (_e471 > 88f) {
            phi_837_ = 88f;
        } else {
            phi_837_ = _e471;
        }
        let _e474 = phi_837_;
        let _e476 = ((_e474 * 1.442695f) + 0.5f);
        if (_e476 > -8388608f) {
            let _e488 = f32(select(0i, select(select(i32(_e476), i32(-2147483648), (_e476 < bitcast<f32>(3472883712u))), 2147483647i, (_e476 > bitcast<f32>(1325400063u))), (_e476 == _e476)));
            if (_e488 > _e476) {
                phi_859_ = 1f;
            } else {
                phi_859_ = 0f;
            }
            let _e491 = phi_859_;
            if (_e476 < 8388608f) {
                phi_864_ = (_e488 - _e491);
                phi_865_ = false;
            } else {
                phi_864_ = f32();
                phi_865_ = true;
            }
            let _e494 = phi_864_;
            let _e496 = phi_865_;
            phi_866_ = _e494;
            phi_867_ = _e496;
        } else {
            phi_866_ = f32();
            phi_867_ = true;
        }
        let _e498 = phi_866_;
        let _e500 = phi_867_;
        if _e500 {
            phi_871_ = _e476;
        } else {
            phi_871_ = _e498;
        }
        let _e502 = phi_871_;
        let _e506 = ((_e474 - (_e502 * 0.69314575f)) - (_e502 * 0.0000014286068f));
        phi_909_ = ((((((((((((((((1f / 5040f) * _e506) + (1f / 720f)) * _e506) + (1f / 120f)) * _e506) + (1f / 24f)) * _e506) + (1f / 6f)) * _e506) + 0.5f) * _e506) + 1f) * _e506) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e502), i32(-2147483648), (_e502 < bitcast<f32>(3472883712u))), 2147483647i, (_e502 > bitcast<f32>(1325400063u))), (_e502 == _e502)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e542 = phi_909_;
    if ((bitcast<u32>(_e461) & 2147483647u) > 2139095040u) {
        phi_997_ = _e461;
    } else {
        if (_e461 < -87f) {
            phi_920_ = -87f;
        } else {
            phi_920_ = _e461;
        }
        let _e548 = phi_920_;
        if (_e548 > 88f) {
            phi_925_ = 88f;
        } else {
            phi_925_ = _e548;
        }
        let _e551 = phi_925_;
        let _e553 = ((_e551 * 1.442695f) + 0.5f);
        if (_e553 > -8388608f) {
            let _e565 = f32(select(0i, select(select(i32(_e553), i32(-2147483648), (_e553 < bitcast<f32>(3472883712u))), 2147483647i, (_e553 > bitcast<f32>(1325400063u))), (_e553 == _e553)));
            if (_e565 > _e553) {
                phi_947_ = 1f;
            } else {
                phi_947_ = 0f;
            }
            let _e568 = phi_947_;
            if (_e553 < 8388608f) {
                phi_952_ = (_e565 - _e568);
                phi_953_ = false;
            } else {
                phi_952_ = f32();
                phi_953_ = true;
            }
            let _e571 = phi_952_;
            let _e573 = phi_953_;
            phi_954_ = _e571;
            phi_955_ = _e573;
        } else {
            phi_954_ = f32();
            phi_955_ = true;
        }
        let _e575 = phi_954_;
        let _e577 = phi_955_;
        if _e577 {
            phi_959_ = _e553;
        } else {
            phi_959_ = _e575;
        }
        let _e579 = phi_959_;
        let _e583 = ((_e551 - (_e579 * 0.69314575f)) - (_e579 * 0.0000014286068f));
        phi_997_ = ((((((((((((((((1f / 5040f) * _e583) + (1f / 720f)) * _e583) + (1f / 120f)) * _e583) + (1f / 24f)) * _e583) + (1f / 6f)) * _e583) + 0.5f) * _e583) + 1f) * _e583) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e579), i32(-2147483648), (_e579 < bitcast<f32>(3472883712u))), 2147483647i, (_e579 > bitcast<f32>(1325400063u))), (_e579 == _e579)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e619 = phi_997_;
    if ((bitcast<u32>(_e463) & 2147483647u) > 2139095040u) {
        phi_1085_ = _e463;
    } else {
        if (_e463 < -87f) {
            phi_1008_ = -87f;
        } else {
            phi_1008_ = _e463;
        }
        let _e625 = phi_1008_;
        if (_e625 > 88f) {
            phi_1013_ = 88f;
        } else {
            phi_1013_ = _e625;
        }
        let _e628 = phi_1013_;
        let _e630 = ((_e628 * 1.442695f) + 0.5f);
        if (_e630 > -8388608f) {
            let _e642 = f32(select(0i, select(select(i32(_e630), i32(-2147483648), (_e630 < bitcast<f32>(3472883712u))), 2147483647i, (_e630 > bitcast<f32>(1325400063u))), (_e630 == _e630)));
            if (_e642 > _e630) {
                phi_1035_ = 1f;
            } else {
                phi_1035_ = 0f;
            }
            let _e645 = phi_1035_;
            if (_e630 < 8388608f) {
                phi_1040_ = (_e642 - _e645);
                phi_1041_ = false;
            } else {
                phi_1040_ = f32();
                phi_1041_ = true;
            }
            let _e648 = phi_1040_;
            let _e650 = phi_1041_;
            phi_1042_ = _e648;
            phi_1043_ = _e650;
        } else {
            phi_1042_ = f32();
            phi_1043_ = true;
        }
        let _e652 = phi_1042_;
        let _e654 = phi_1043_;
        if _e654 {
            phi_1047_ = _e630;
        } else {
            phi_1047_ = _e652;
        }
        let _e656 = phi_1047_;
        let _e660 = ((_e628 - (_e656 * 0.69314575f)) - (_e656 * 0.0000014286068f));
        phi_1085_ = ((((((((((((((((1f / 5040f) * _e660) + (1f / 720f)) * _e660) + (1f / 120f)) * _e660) + (1f / 24f)) * _e660) + (1f / 6f)) * _e660) + 0.5f) * _e660) + 1f) * _e660) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e656), i32(-2147483648), (_e656 < bitcast<f32>(3472883712u))), 2147483647i, (_e656 > bitcast<f32>(1325400063u))), (_e656 == _e656)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e696 = phi_1085_;
    if ((bitcast<u32>(_e465) & 2147483647u) > 2139095040u) {
        phi_1173_ = _e465;
    } else {
        if (_e465 < -87f) {
            phi_1096_ = -87f;
        } else {
            phi_1096_ = _e465;
        }
        let _e702 = phi_1096_;
        if (_e702 > 88f) {
            phi_1101_ = 88f;
        } else {
            phi_1101_ = _e702;
        }
        let _e705 = phi_1101_;
        let _e707 = ((_e705 * 1.442695f) + 0.5f);
        if (_e707 > -8388608f) {
            let _e719 = f32(select(0i, select(select(i32(_e707), i32(-2147483648), (_e707 < bitcast<f32>(3472883712u))), 2147483647i, (_e707 > bitcast<f32>(1325400063u))), (_e707 == _e707)));
            if (_e719 > _e707) {
                phi_1123_ = 1f;
            } else {
                phi_1123_ = 0f;
            }
            let _e722 = phi_1123_;
            if (_e707 < 8388608f) {
                phi_1128_ = (_e719 - _e722);
                phi_1129_ = false;
            } else {
                phi_1128_ = f32();
                phi_1129_ = true;
            }
            let _e725 = phi_1128_;
            let _e727 = phi_1129_;
            phi_1130_ = _e725;
            phi_1131_ = _e727;
        } else {
            phi_1130_ = f32();
            phi_1131_ = true;
        }
        let _e729 = phi_1130_;
        let _e731 = phi_1131_;
        if _e731 {
            phi_1135_ = _e707;
        } else {
            phi_1135_ = _e729;
        }
        let _e733 = phi_1135_;
        let _e737 = ((_e705 - (_e733 * 0.69314575f)) - (_e733 * 0.0000014286068f));
        phi_1173_ = ((((((((((((((((1f / 5040f) * _e737) + (1f / 720f)) * _e737) + (1f / 120f)) * _e737) + (1f / 24f)) * _e737) + (1f / 6f)) * _e737) + 0.5f) * _e737) + 1f) * _e737) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e733), i32(-2147483648), (_e733 < bitcast<f32>(3472883712u))), 2147483647i, (_e733 > bitcast<f32>(1325400063u))), (_e733 == _e733)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e773 = phi_1173_;
    let _e775 = (vec4<f32>(1f, 1f, 1f, 1f).x - _e542);
    let _e777 = (vec4<f32>(1f, 1f, 1f, 1f).y - _e619);
    let _e779 = (vec4<f32>(1f, 1f, 1f, 1f).z - _e696);
    let _e781 = (vec4<f32>(1f, 1f, 1f, 1f).w - _e773);
    let _e783 = (*param_4).min_variance;
    let _e785 = ((_e783 * _e456) * _e456);
    let _e796 = ((((_e775 * param_6.x) + (_e777 * param_6.y)) + (_e779 * param_6.z)) + (_e781 * param_6.w));
    let _e797 = (_e775 - _e796);
    let _e798 = (_e777 - _e796);
    let _e799 = (_e779 - _e796);
    let _e800 = (_e781 - _e796);
    let _e815 = (((((_e797 * _e797) * param_6.x) + ((_e798 * _e798) * param_6.y)) + ((_e799 * _e799) * param_6.z)) + ((_e800 * _e800) * param_6.w));
    if ((bitcast<u32>(_e785) & 2147483647u) > 2139095040u) {
        phi_1226_ = true;
    } else {
        let _e819 = (_e785 > _e815);
        if _e819 {
        }
        phi_1226_ = _e819;
    }
    let _e821 = phi_1226_;
    if _e821 {
        phi_1230_ = _e785;
    } else {
        phi_1230_ = _e815;
    }
    let _e823 = phi_1230_;
    let _e824 = -(_e796);
    if (_e824 <= 0f) {
        let _e828 = ((bitcast<u32>(_e823) & 2147483647u) > 2139095040u);
        if _e828 {
        }
        phi_1242_ = _e828;
    } else {
        phi_1242_ = true;
    }
    let _e830 = phi_1242_;
    if _e830 {
        phi_1249_ = (_e823 / (_e823 + (_e824 * _e824)));
    } else {
        phi_1249_ = 1f;
    }
    let _e835 = phi_1249_;
    if ((bitcast<u32>(_e835) & 2147483647u) > 2139095040u) {
        phi_1260_ = true;
    } else {
        let _e839 = (_e835 < _e446);
        if _e839 {
        }
        phi_1260_ = _e839;
    }
    let _e841 = phi_1260_;
    if _e841 {
        phi_1264_ = _e835;
    } else {
        phi_1264_ = _e446;
    }
    let _e843 = phi_1264_;
    if ((bitcast<u32>(_e843) & 2147483647u) > 2139095040u) {
        phi_1281_ = _e843;
    } else {
        if (_e843 < 0f) {
            phi_1280_ = 0f;
        } else {
            if (_e843 > 1f) {
                phi_1279_ = 1f;
            } else {
                phi_1279_ = _e843;
            }
            let _e850 = phi_1279_;
            phi_1280_ = _e850;
        }
        let _e852 = phi_1280_;
        phi_1281_ = _e852;
    }
    let _e854 = phi_1281_;
    return _e854;
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
            let _e66 = phi_204_;
            phi_205_ = _e66;
        }
        let _e68 = phi_205_;
        phi_206_ = _e68;
    }
    let _e70 = phi_206_;
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
            let _e78 = phi_222_;
            phi_223_ = _e78;
        }
        let _e80 = phi_223_;
        phi_224_ = _e80;
    }
    let _e82 = phi_224_;
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
            let _e90 = phi_240_;
            phi_241_ = _e90;
        }
        let _e92 = phi_241_;
        phi_242_ = _e92;
    }
    let _e94 = phi_242_;
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
            let _e102 = phi_258_;
            phi_259_ = _e102;
        }
        let _e104 = phi_259_;
        phi_260_ = _e104;
    }
    let _e106 = phi_260_;
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
            let _e114 = phi_276_;
            phi_277_ = _e114;
        }
        let _e116 = phi_277_;
        phi_278_ = _e116;
    }
    let _e118 = phi_278_;
    let _e119 = (_e82 - _e70);
    let _e120 = (_e94 - _e70);
    let _e121 = (_e106 - _e70);
    let _e122 = (_e118 - _e70);
    if (_e119 >= 0f) {
        if (_e120 >= 0f) {
            if (_e121 >= 0f) {
                if (_e122 >= 0f) {
                    phi_315_ = !(((bitcast<u32>(((((_e119 * param_9.x) + (_e120 * param_9.y)) + (_e121 * param_9.z)) + (_e122 * param_9.w))) & 2147483647u) > 2139095040u));
                    phi_316_ = false;
                } else {
                    phi_315_ = bool();
                    phi_316_ = true;
                }
                let _e144 = phi_315_;
                let _e146 = phi_316_;
                phi_317_ = _e144;
                phi_318_ = false;
                phi_319_ = _e146;
            } else {
                phi_317_ = bool();
                phi_318_ = true;
                phi_319_ = false;
            }
            let _e148 = phi_317_;
            let _e150 = phi_318_;
            let _e152 = phi_319_;
            phi_320_ = _e148;
            phi_321_ = _e150;
            phi_322_ = _e152;
        } else {
            phi_320_ = bool();
            phi_321_ = true;
            phi_322_ = false;
        }
        let _e154 = phi_320_;
        let _e156 = phi_321_;
        let _e158 = phi_322_;
        phi_323_ = _e154;
        phi_324_ = _e156;
        phi_325_ = _e158;
    } else {
        phi_323_ = bool();
        phi_324_ = true;
        phi_325_ = false;
    }
    let _e160 = phi_323_;
    let _e162 = phi_324_;
    let _e164 = phi_325_;
    if _e162 {
        phi_329_ = true;
    } else {
        phi_329_ = _e164;
    }
    let _e166 = phi_329_;
    if _e166 {
        phi_333_ = false;
    } else {
        phi_333_ = _e160;
    }
    let _e168 = phi_333_;
    if _e168 {
        phi_338_ = 1f;
    } else {
        let _e169 = _lt_math_evsm_Evsm_bound_of_offsets(param_7, vec4<f32>(_e119, _e120, _e121, _e122), param_9);
        phi_338_ = _e169;
    }
    let _e171 = phi_338_;
    return _e171;
}

fn function_() {
    var local: lt_math_Evsm;
    var phi_1341_: bool;
    var phi_1342_: bool;
    var phi_1343_: bool;
    var phi_1344_: bool;
    var phi_1348_: bool;
    var phi_1418_: bool;
    var phi_1419_: bool;
    var phi_1430_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1431_: bool;
    var phi_1432_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1433_: bool;
    var phi_1440_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1444_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1464_: lt_math_LightPoint;
    var phi_1467_: u32;
    var phi_1469_: lt_math_LevelPoint;
    var phi_1555_: bool;
    var phi_1564_: bool;
    var phi_1573_: bool;
    var phi_1574_: bool;
    var phi_1575_: bool;
    var phi_1576_: bool;
    var phi_1577_: bool;
    var phi_1578_: bool;
    var phi_1579_: bool;
    var phi_1583_: bool;
    var phi_1610_: bool;
    var phi_1611_: bool;
    var phi_1612_: bool;
    var phi_1613_: bool;
    var phi_1614_: bool;
    var phi_1615_: bool;
    var phi_1616_: bool;
    var phi_1617_: bool;
    var phi_1621_: bool;
    var phi_1630_: lt_math_LightPoint;
    var phi_1631_: u32;
    var phi_1632_: lt_math_LevelPoint;
    var phi_1633_: bool;
    var phi_1465_: lt_math_LightPoint;
    var phi_1468_: u32;
    var phi_1470_: lt_math_LevelPoint;
    var phi_1634_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_1674_: bool;
    var phi_1675_: bool;
    var phi_1676_: bool;
    var phi_1677_: bool;
    var phi_1681_: bool;
    var phi_1763_: f32;
    var phi_1881_: f32;
    var phi_1882_: f32;
    var phi_1885_: f32;
    var phi_1914_: f32;
    var phi_1919_: f32;
    var phi_1920_: bool;
    var phi_1921_: f32;
    var phi_1922_: bool;
    var phi_1926_: f32;
    var phi_1946_: f32;
    var phi_1951_: f32;
    var phi_1952_: bool;
    var phi_1953_: f32;
    var phi_1954_: bool;
    var phi_1958_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_2011_: i32;
    var phi_2016_: i32;
    var phi_2021_: i32;
    var phi_2026_: i32;
    var phi_2035_: i32;
    var phi_2040_: i32;
    var phi_2045_: i32;
    var phi_2050_: i32;
    var phi_2103_: bool;
    var phi_2111_: bool;
    var phi_2123_: bool;
    var phi_2124_: bool;
    var phi_2128_: f32;
    var phi_2134_: f32;
    var phi_2136_: evaluate_Verdict;
    var phi_2146_: u32;
    var phi_2155_: f32;
    var phi_2157_: evaluate_Verdict;
    var phi_2158_: bool;
    var phi_2159_: evaluate_Verdict;
    var phi_2160_: bool;
    var phi_2165_: evaluate_Verdict;
    var phi_2170_: evaluate_Verdict;
    var phi_2171_: evaluate_Verdict;

    let _e57 = id_1;
    let _e64 = arrayLength((&map.member));
    let _e70 = arrayLength((&levels.member));
    let _e73 = p.member.size[0u];
    let _e75 = p.member.size[1u];
    let _e76 = lt_shaders_entry_pixel_index(_e57, _e73, _e75);
    if (bitcast<i32>(_e76.root) != 0i) {
        let _e82 = p.member.level_count;
        if (_e76.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e89 = samples.member[(0u + _e76.first_primitive)].normal[0u];
        let _e91 = global[0u];
        if (_e89 == _e91) {
            let _e94 = samples.member[(0u + _e76.first_primitive)].normal[1u];
            let _e96 = global[1u];
            if (_e94 == _e96) {
                let _e99 = samples.member[(0u + _e76.first_primitive)].normal[2u];
                let _e101 = global[2u];
                phi_1341_ = (_e99 == _e101);
                phi_1342_ = false;
            } else {
                phi_1341_ = bool();
                phi_1342_ = true;
            }
            let _e104 = phi_1341_;
            let _e106 = phi_1342_;
            phi_1343_ = _e104;
            phi_1344_ = _e106;
        } else {
            phi_1343_ = bool();
            phi_1344_ = true;
        }
        let _e108 = phi_1343_;
        let _e110 = phi_1344_;
        if _e110 {
            phi_1348_ = false;
        } else {
            phi_1348_ = _e108;
        }
        let _e112 = phi_1348_;
        if !(_e112) {
            let _e115 = samples.member[(0u + _e76.first_primitive)].position;
            let _e117 = p.member.light.place;
            let _e123 = p.member.light.place[3u];
            let _e130 = (_e117.x - (_e115.x * _e123));
            let _e131 = (_e117.y - (_e115.y * _e123));
            let _e132 = (_e117.z - (_e115.z * _e123));
            let _e134 = samples.member[(0u + _e76.first_primitive)].normal;
            if ((((_e134.x * _e130) + (_e134.y * _e131)) + (_e134.z * _e132)) > 0f) {
                let _e148 = (((_e130 * _e130) + (_e131 * _e131)) + (_e132 * _e132));
                let _e150 = p.member.light.axis;
                let _e162 = p.member.light.place[3u];
                if (_e162 == 0f) {
                    phi_1419_ = true;
                } else {
                    let _e165 = p.member.light.range_squared;
                    if (_e148 <= _e165) {
                        let _e168 = p.member.light.cos_outer;
                        phi_1418_ = (-((((_e130 * _e150.x) + (_e131 * _e150.y)) + (_e132 * _e150.z))) >= (_e168 * sqrt(_e148)));
                    } else {
                        phi_1418_ = false;
                    }
                    let _e173 = phi_1418_;
                    phi_1419_ = _e173;
                }
                let _e175 = phi_1419_;
                if _e175 {
                    let _e177 = samples.member[(0u + _e76.first_primitive)].flags;
                    let _e185 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e191 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e185.unnamed.visibility, false), _e185.unnamed_1);
                    phi_1430_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e191.unnamed, ((_e177 & 1u) == 0u));
                    phi_1431_ = false;
                } else {
                    phi_1430_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_1431_ = true;
                }
                let _e196 = phi_1430_;
                let _e198 = phi_1431_;
                phi_1432_ = _e196;
                phi_1433_ = _e198;
            } else {
                phi_1432_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_1433_ = true;
            }
            let _e200 = phi_1432_;
            let _e202 = phi_1433_;
            if _e202 {
                let _e208 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e214 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e208.unnamed.visibility, false), _e208.unnamed_1);
                phi_1440_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e214.unnamed, true);
            } else {
                phi_1440_ = _e200;
            }
            let _e219 = phi_1440_;
            phi_1444_ = _e219;
        } else {
            let _e225 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e231 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e225.unnamed.visibility, false), _e225.unnamed_1);
            phi_1444_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e231.unnamed, true);
        }
        let _e236 = phi_1444_;
        if _e236.unnamed_1 {
            phi_2171_ = evaluate_Verdict(_e236.unnamed.visibility, _e236.unnamed.is_doubted);
        } else {
            let _e244 = samples.member[(0u + _e76.first_primitive)].position;
            let _e246 = p.member.map_size;
            let _e248 = (0.5f / f32(_e246));
            let _e255 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e262 = lt_math_LightPoint(vec2<f32>(_e255.uv.x, 0f), _e255.depth, _e255.is_inside);
            let _e266 = lt_math_LightPoint(_e262.uv, 0f, _e262.is_inside);
            phi_1464_ = lt_math_LightPoint();
            phi_1467_ = 0u;
            phi_1469_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e266.uv, _e266.depth, false));
            loop {
                let _e273 = phi_1464_;
                let _e275 = phi_1467_;
                let _e277 = phi_1469_;
                local_1 = _e277;
                local_2 = _e277;
                local_3 = _e277;
                if (_e275 < _e82) {
                    if _e277.point.is_inside {
                        phi_1630_ = lt_math_LightPoint();
                        phi_1631_ = u32();
                        phi_1632_ = lt_math_LevelPoint();
                        phi_1633_ = false;
                    } else {
                        if (_e275 < _e70) {
                        } else {
                            return;
                        }
                        let _e288 = levels.member[(0u + _e275)].row_w;
                        let _e299 = ((((_e288.x * _e244.x) + (_e288.y * _e244.y)) + (_e288.z * _e244.z)) + (_e288.w * 1f));
                        let _e301 = levels.member[(0u + _e275)].row_x;
                        let _e313 = (((((_e301.x * _e244.x) + (_e301.y * _e244.y)) + (_e301.z * _e244.z)) + (_e301.w * 1f)) / _e299);
                        let _e315 = levels.member[(0u + _e275)].row_y;
                        let _e327 = (((((_e315.x * _e244.x) + (_e315.y * _e244.y)) + (_e315.z * _e244.z)) + (_e315.w * 1f)) / _e299);
                        let _e329 = levels.member[(0u + _e275)].row_z;
                        let _e340 = ((((_e329.x * _e244.x) + (_e329.y * _e244.y)) + (_e329.z * _e244.z)) + (_e329.w * 1f));
                        if (_e299 > 0f) {
                            if (_e313 >= 0f) {
                                phi_1555_ = (_e313 <= 1f);
                            } else {
                                phi_1555_ = false;
                            }
                            let _e345 = phi_1555_;
                            if _e345 {
                                if (_e327 >= 0f) {
                                    phi_1564_ = (_e327 <= 1f);
                                } else {
                                    phi_1564_ = false;
                                }
                                let _e349 = phi_1564_;
                                if _e349 {
                                    if (_e340 >= 0f) {
                                        phi_1573_ = (_e340 <= 1f);
                                    } else {
                                        phi_1573_ = false;
                                    }
                                    let _e353 = phi_1573_;
                                    phi_1574_ = _e353;
                                    phi_1575_ = false;
                                } else {
                                    phi_1574_ = bool();
                                    phi_1575_ = true;
                                }
                                let _e355 = phi_1574_;
                                let _e357 = phi_1575_;
                                phi_1576_ = _e355;
                                phi_1577_ = _e357;
                            } else {
                                phi_1576_ = bool();
                                phi_1577_ = true;
                            }
                            let _e359 = phi_1576_;
                            let _e361 = phi_1577_;
                            phi_1578_ = _e359;
                            phi_1579_ = _e361;
                        } else {
                            phi_1578_ = bool();
                            phi_1579_ = true;
                        }
                        let _e363 = phi_1578_;
                        let _e365 = phi_1579_;
                        if _e365 {
                            phi_1583_ = false;
                        } else {
                            phi_1583_ = _e363;
                        }
                        let _e367 = phi_1583_;
                        if _e367 {
                            if (_e313 >= _e248) {
                                if (_e313 <= (1f - _e248)) {
                                    if (_e327 >= _e248) {
                                        phi_1610_ = (_e327 <= (1f - _e248));
                                        phi_1611_ = false;
                                    } else {
                                        phi_1610_ = bool();
                                        phi_1611_ = true;
                                    }
                                    let _e375 = phi_1610_;
                                    let _e377 = phi_1611_;
                                    phi_1612_ = _e375;
                                    phi_1613_ = _e377;
                                } else {
                                    phi_1612_ = bool();
                                    phi_1613_ = true;
                                }
                                let _e379 = phi_1612_;
                                let _e381 = phi_1613_;
                                phi_1614_ = _e379;
                                phi_1615_ = _e381;
                            } else {
                                phi_1614_ = bool();
                                phi_1615_ = true;
                            }
                            let _e383 = phi_1614_;
                            let _e385 = phi_1615_;
                            phi_1616_ = _e383;
                            phi_1617_ = _e385;
                        } else {
                            phi_1616_ = bool();
                            phi_1617_ = true;
                        }
                        let _e387 = phi_1616_;
                        let _e389 = phi_1617_;
                        if _e389 {
                            phi_1621_ = false;
                        } else {
                            phi_1621_ = _e387;
                        }
                        let _e391 = phi_1621_;
                        let _e398 = lt_math_LightPoint(vec2<f32>(_e313, _e273.uv.y), _e273.depth, _e273.is_inside);
                        let _e405 = lt_math_LightPoint(vec2<f32>(_e398.uv.x, _e327), _e398.depth, _e398.is_inside);
                        let _e409 = lt_math_LightPoint(_e405.uv, _e340, _e405.is_inside);
                        let _e413 = lt_math_LightPoint(_e409.uv, _e409.depth, _e391);
                        phi_1630_ = _e413;
                        phi_1631_ = (_e275 + 1u);
                        phi_1632_ = lt_math_LevelPoint(_e275, _e413);
                        phi_1633_ = true;
                    }
                    let _e417 = phi_1630_;
                    let _e419 = phi_1631_;
                    let _e421 = phi_1632_;
                    let _e423 = phi_1633_;
                    phi_1465_ = _e417;
                    phi_1468_ = _e419;
                    phi_1470_ = _e421;
                    phi_1634_ = _e423;
                } else {
                    phi_1465_ = lt_math_LightPoint();
                    phi_1468_ = u32();
                    phi_1470_ = lt_math_LevelPoint();
                    phi_1634_ = false;
                }
                let _e425 = phi_1465_;
                let _e427 = phi_1468_;
                let _e429 = phi_1470_;
                let _e431 = phi_1634_;
                continue;
                continuing {
                    phi_1464_ = _e425;
                    phi_1467_ = _e427;
                    phi_1469_ = _e429;
                    break if !(_e431);
                }
            }
            let _e434 = local_1;
            if _e434.point.is_inside {
                if (0f > 0f) {
                    let _e440 = local_2;
                    if (_e440.level < _e70) {
                    } else {
                        return;
                    }
                    let _e445 = levels.member[(0u + _e440.level)];
                    let _e451 = global[0u];
                    if (_e445.row_w.x == _e451) {
                        let _e454 = global[1u];
                        if (_e445.row_w.y == _e454) {
                            let _e457 = global[2u];
                            phi_1674_ = (_e445.row_w.z == _e457);
                            phi_1675_ = false;
                        } else {
                            phi_1674_ = bool();
                            phi_1675_ = true;
                        }
                        let _e460 = phi_1674_;
                        let _e462 = phi_1675_;
                        phi_1676_ = _e460;
                        phi_1677_ = _e462;
                    } else {
                        phi_1676_ = bool();
                        phi_1677_ = true;
                    }
                    let _e464 = phi_1676_;
                    let _e466 = phi_1677_;
                    if _e466 {
                        phi_1681_ = false;
                    } else {
                        phi_1681_ = _e464;
                    }
                    let _e468 = phi_1681_;
                    if _e468 {
                        let _e470 = samples.member[(0u + _e76.first_primitive)].normal;
                        let _e472 = p.member.map_size;
                        let _e542 = ((abs(((((_e445.row_x.x * _e470.x) + (_e445.row_x.y * _e470.y)) + (_e445.row_x.z * _e470.z)) / (((_e445.row_x.x * _e445.row_x.x) + (_e445.row_x.y * _e445.row_x.y)) + (_e445.row_x.z * _e445.row_x.z)))) + abs(((((_e445.row_y.x * _e470.x) + (_e445.row_y.y * _e470.y)) + (_e445.row_y.z * _e470.z)) / (((_e445.row_y.x * _e445.row_y.x) + (_e445.row_y.y * _e445.row_y.y)) + (_e445.row_y.z * _e445.row_y.z))))) / (abs(((((_e445.row_z.x * _e470.x) + (_e445.row_z.y * _e470.y)) + (_e445.row_z.z * _e470.z)) / (((_e445.row_z.x * _e445.row_z.x) + (_e445.row_z.y * _e445.row_z.y)) + (_e445.row_z.z * _e445.row_z.z)))) * f32(_e472)));
                        if (_e542 < 0.002f) {
                            phi_1763_ = _e542;
                        } else {
                            phi_1763_ = 0.002f;
                        }
                        let _e545 = phi_1763_;
                        phi_1882_ = _e545;
                    } else {
                        let _e547 = p.member.map_size;
                        let _e553 = samples.member[(0u + _e76.first_primitive)].position;
                        let _e564 = ((((_e445.row_w.x * _e553.x) + (_e445.row_w.y * _e553.y)) + (_e445.row_w.z * _e553.z)) + _e445.row_w.w);
                        let _e577 = ((_e445.row_x.x - (_e445.row_w.x * _e434.point.uv.x)) / _e564);
                        let _e578 = ((_e445.row_x.y - (_e445.row_w.y * _e434.point.uv.x)) / _e564);
                        let _e579 = ((_e445.row_x.z - (_e445.row_w.z * _e434.point.uv.x)) / _e564);
                        let _e592 = ((_e445.row_y.x - (_e445.row_w.x * _e434.point.uv.y)) / _e564);
                        let _e593 = ((_e445.row_y.y - (_e445.row_w.y * _e434.point.uv.y)) / _e564);
                        let _e594 = ((_e445.row_y.z - (_e445.row_w.z * _e434.point.uv.y)) / _e564);
                        let _e600 = samples.member[(0u + _e76.first_primitive)].normal;
                        let _e605 = ((_e593 * _e600.z) - (_e600.y * _e594));
                        let _e610 = ((_e594 * _e600.x) - (_e600.z * _e592));
                        let _e615 = ((_e592 * _e600.y) - (_e600.x * _e593));
                        let _e617 = samples.member[(0u + _e76.first_primitive)].normal;
                        let _e622 = ((_e578 * _e617.z) - (_e617.y * _e579));
                        let _e627 = ((_e579 * _e617.x) - (_e617.z * _e577));
                        let _e632 = ((_e577 * _e617.y) - (_e617.x * _e578));
                        let _e659 = ((abs(((((_e445.row_z.x * _e605) + (_e445.row_z.y * _e610)) + (_e445.row_z.z * _e615)) / (((_e577 * _e605) + (_e578 * _e610)) + (_e579 * _e615)))) + abs(((((_e445.row_z.x * _e622) + (_e445.row_z.y * _e627)) + (_e445.row_z.z * _e632)) / (((_e592 * _e622) + (_e593 * _e627)) + (_e594 * _e632))))) / f32(_e547));
                        let _e661 = (16f / f32(_e547));
                        if (_e659 < _e661) {
                            phi_1881_ = _e659;
                        } else {
                            phi_1881_ = _e661;
                        }
                        let _e664 = phi_1881_;
                        phi_1882_ = _e664;
                    }
                    let _e666 = phi_1882_;
                    phi_1885_ = (_e434.point.depth - (0f * _e666));
                } else {
                    phi_1885_ = _e434.point.depth;
                }
                let _e670 = phi_1885_;
                let _e676 = p.member.map_size;
                let _e677 = f32(_e676);
                let _e680 = ((_e434.point.uv.x * _e677) - 0.5f);
                let _e681 = ((_e434.point.uv.y * _e677) - 0.5f);
                if (_e680 > -8388608f) {
                    let _e693 = f32(select(0i, select(select(i32(_e680), i32(-2147483648), (_e680 < bitcast<f32>(3472883712u))), 2147483647i, (_e680 > bitcast<f32>(1325400063u))), (_e680 == _e680)));
                    if (_e693 > _e680) {
                        phi_1914_ = 1f;
                    } else {
                        phi_1914_ = 0f;
                    }
                    let _e696 = phi_1914_;
                    if (_e680 < 8388608f) {
                        phi_1919_ = (_e693 - _e696);
                        phi_1920_ = false;
                    } else {
                        phi_1919_ = f32();
                        phi_1920_ = true;
                    }
                    let _e699 = phi_1919_;
                    let _e701 = phi_1920_;
                    phi_1921_ = _e699;
                    phi_1922_ = _e701;
                } else {
                    phi_1921_ = f32();
                    phi_1922_ = true;
                }
                let _e703 = phi_1921_;
                let _e705 = phi_1922_;
                if _e705 {
                    phi_1926_ = _e680;
                } else {
                    phi_1926_ = _e703;
                }
                let _e707 = phi_1926_;
                if (_e681 > -8388608f) {
                    let _e719 = f32(select(0i, select(select(i32(_e681), i32(-2147483648), (_e681 < bitcast<f32>(3472883712u))), 2147483647i, (_e681 > bitcast<f32>(1325400063u))), (_e681 == _e681)));
                    if (_e719 > _e681) {
                        phi_1946_ = 1f;
                    } else {
                        phi_1946_ = 0f;
                    }
                    let _e722 = phi_1946_;
                    if (_e681 < 8388608f) {
                        phi_1951_ = (_e719 - _e722);
                        phi_1952_ = false;
                    } else {
                        phi_1951_ = f32();
                        phi_1952_ = true;
                    }
                    let _e725 = phi_1951_;
                    let _e727 = phi_1952_;
                    phi_1953_ = _e725;
                    phi_1954_ = _e727;
                } else {
                    phi_1953_ = f32();
                    phi_1954_ = true;
                }
                let _e729 = phi_1953_;
                let _e731 = phi_1954_;
                if _e731 {
                    phi_1958_ = _e681;
                } else {
                    phi_1958_ = _e729;
                }
                let _e733 = phi_1958_;
                let _e734 = (_e680 - _e707);
                let _e735 = (_e681 - _e733);
                let _e744 = select(0i, select(select(i32(_e707), i32(-2147483648), (_e707 < bitcast<f32>(3472883712u))), 2147483647i, (_e707 > bitcast<f32>(1325400063u))), (_e707 == _e707));
                let _e753 = select(0i, select(select(i32(_e733), i32(-2147483648), (_e733 < bitcast<f32>(3472883712u))), 2147483647i, (_e733 > bitcast<f32>(1325400063u))), (_e733 == _e733));
                let _e764 = p.member.test;
                let _e765 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e764);
                let _e767 = p.member.map_size;
                let _e769 = local_3;
                local = lt_math_Evsm(_e765.positive_exponent, _e765.negative_exponent, _e765.min_variance);
                let _e776 = ((_e769.level * _e767) * _e767);
                let _e778 = (bitcast<i32>(_e767) - 1i);
                if (_e744 > 0i) {
                    phi_2011_ = _e744;
                } else {
                    phi_2011_ = 0i;
                }
                let _e781 = phi_2011_;
                if (_e753 > 0i) {
                    phi_2016_ = _e753;
                } else {
                    phi_2016_ = 0i;
                }
                let _e784 = phi_2016_;
                if (_e781 < _e778) {
                    phi_2021_ = _e781;
                } else {
                    phi_2021_ = _e778;
                }
                let _e787 = phi_2021_;
                if (_e784 < _e778) {
                    phi_2026_ = _e784;
                } else {
                    phi_2026_ = _e778;
                }
                let _e790 = phi_2026_;
                let _e791 = bitcast<u32>(_e787);
                let _e793 = (_e744 + 1i);
                let _e794 = (_e753 + 1i);
                if (_e793 > 0i) {
                    phi_2035_ = _e793;
                } else {
                    phi_2035_ = 0i;
                }
                let _e797 = phi_2035_;
                if (_e794 > 0i) {
                    phi_2040_ = _e794;
                } else {
                    phi_2040_ = 0i;
                }
                let _e800 = phi_2040_;
                if (_e797 < _e778) {
                    phi_2045_ = _e797;
                } else {
                    phi_2045_ = _e778;
                }
                let _e803 = phi_2045_;
                if (_e800 < _e778) {
                    phi_2050_ = _e800;
                } else {
                    phi_2050_ = _e778;
                }
                let _e806 = phi_2050_;
                let _e807 = bitcast<u32>(_e803);
                let _e809 = (bitcast<u32>(_e790) * _e767);
                let _e810 = (bitcast<u32>(_e806) * _e767);
                let _e815 = ((_e809 + _e791) + _e776);
                let _e816 = ((_e809 + _e807) + _e776);
                let _e817 = ((_e810 + _e791) + _e776);
                let _e818 = ((_e810 + _e807) + _e776);
                if (_e815 < _e64) {
                } else {
                    return;
                }
                let _e822 = map.member[(0u + _e815)];
                if (_e816 < _e64) {
                } else {
                    return;
                }
                let _e826 = map.member[(0u + _e816)];
                if (_e817 < _e64) {
                } else {
                    return;
                }
                let _e830 = map.member[(0u + _e817)];
                if (_e818 < _e64) {
                } else {
                    return;
                }
                let _e834 = map.member[(0u + _e818)];
                let _e836 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e822, _e826, _e830, _e834), vec4<f32>(((1f - _e734) * (1f - _e735)), (_e734 * (1f - _e735)), ((1f - _e734) * _e735), (_e734 * _e735)), _e670);
                let _e840 = p.member.epsilon;
                if (_e836 <= _e840) {
                    phi_2103_ = true;
                } else {
                    phi_2103_ = (_e836 >= (1f - _e840));
                }
                let _e845 = phi_2103_;
                if ((bitcast<u32>(_e836) & 2147483647u) > 2139095040u) {
                    phi_2111_ = true;
                } else {
                    phi_2111_ = !(_e845);
                }
                let _e851 = phi_2111_;
                if _e851 {
                    if (_e836 > 0f) {
                        if (_e836 < 1f) {
                            phi_2123_ = false;
                        } else {
                            phi_2123_ = true;
                        }
                        let _e855 = phi_2123_;
                        phi_2124_ = _e855;
                    } else {
                        phi_2124_ = true;
                    }
                    let _e857 = phi_2124_;
                    if _e857 {
                        phi_2128_ = 0.5f;
                    } else {
                        phi_2128_ = _e836;
                    }
                    let _e859 = phi_2128_;
                    phi_2136_ = evaluate_Verdict(_e859, true);
                } else {
                    if (_e836 > 0.5f) {
                        phi_2134_ = 1f;
                    } else {
                        phi_2134_ = 0f;
                    }
                    let _e863 = phi_2134_;
                    phi_2136_ = evaluate_Verdict(_e863, false);
                }
                let _e866 = phi_2136_;
                let _e869 = (_e866.visibility < 0.5f);
                if _e866.is_doubted {
                    phi_2159_ = evaluate_Verdict();
                    phi_2160_ = true;
                } else {
                    if _e869 {
                        phi_2146_ = 2u;
                    } else {
                        phi_2146_ = 1u;
                    }
                    let _e871 = phi_2146_;
                    if ((0u & _e871) != 0u) {
                        if _e869 {
                            phi_2155_ = 0.000000059604645f;
                        } else {
                            phi_2155_ = 0.99999994f;
                        }
                        let _e875 = phi_2155_;
                        phi_2157_ = evaluate_Verdict(_e875, true);
                        phi_2158_ = false;
                    } else {
                        phi_2157_ = evaluate_Verdict();
                        phi_2158_ = true;
                    }
                    let _e878 = phi_2157_;
                    let _e880 = phi_2158_;
                    phi_2159_ = _e878;
                    phi_2160_ = _e880;
                }
                let _e882 = phi_2159_;
                let _e884 = phi_2160_;
                if _e884 {
                    phi_2165_ = evaluate_Verdict(_e866.visibility, _e866.is_doubted);
                } else {
                    phi_2165_ = _e882;
                }
                let _e887 = phi_2165_;
                phi_2170_ = evaluate_Verdict(_e887.visibility, _e887.is_doubted);
            } else {
                phi_2170_ = evaluate_Verdict(0.5f, true);
            }
            let _e893 = phi_2170_;
            phi_2171_ = _e893;
        }
        let _e895 = phi_2171_;
        if (_e76.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e76.first_primitive)] = _e895.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_evsm_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
