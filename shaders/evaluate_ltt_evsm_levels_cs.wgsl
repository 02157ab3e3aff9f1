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

struct type_37 {
    member: abi_ShadowParams,
}

struct lt_math_Evsm {
    positive_exponent: f32,
    negative_exponent: f32,
    min_variance: f32,
}

struct lt_math_LightPoint {
    uv: vec2<f32>,
    depth: f32,
    is_inside: bool,
}

struct type_44 {
    member: array<lt_math_LightProjection>,
}

struct lt_math_LevelPoint {
    level: u32,
    point: lt_math_LightPoint,
}

struct type_50 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
var<private> local_5: u32;
@group(0) @binding(1) 
var<storage> samples: type_10;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(0) 
var<uniform> p: type_37;
@group(0) @binding(2) 
var<storage> map: type_18;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_18;
@group(0) @binding(4) 
var<storage, read_write> list: type_50;
@group(0) @binding(5) 
var<storage> levels: type_44;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_174_: lt_bvh_traverse_Tree;
    var phi_175_: bool;
    var phi_176_: lt_bvh_traverse_Tree;
    var phi_177_: bool;
    var phi_182_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_174_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_175_ = false;
        } else {
            phi_174_ = lt_bvh_traverse_Tree();
            phi_175_ = true;
        }
        let _e69 = phi_174_;
        let _e71 = phi_175_;
        phi_176_ = _e69;
        phi_177_ = _e71;
    } else {
        phi_176_ = lt_bvh_traverse_Tree();
        phi_177_ = true;
    }
    let _e73 = phi_176_;
    let _e75 = phi_177_;
    if _e75 {
        phi_182_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_182_ = _e73;
    }
    let _e80 = phi_182_;
    return lt_bvh_traverse_Tree(_e80.root, _e80.first_primitive);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> lt_math_Evsm {
    return lt_math_Evsm(param_3.x, param_3.y, param_3.z);
}

fn _lt_math_evsm_Evsm_bound_of_offsets(param_4: ptr<function, lt_math_Evsm>, param_5: vec4<f32>, param_6: vec4<f32>) -> f32 {
    var phi_362_: bool;
    var phi_366_: f32;
    var phi_385_: f32;
    var phi_390_: f32;
    var phi_412_: f32;
    var phi_417_: f32;
    var phi_418_: bool;
    var phi_419_: f32;
    var phi_420_: bool;
    var phi_424_: f32;
    var phi_462_: f32;
    var phi_473_: f32;
    var phi_478_: f32;
    var phi_500_: f32;
    var phi_505_: f32;
    var phi_506_: bool;
    var phi_507_: f32;
    var phi_508_: bool;
    var phi_512_: f32;
    var phi_550_: f32;
    var phi_561_: f32;
    var phi_566_: f32;
    var phi_588_: f32;
    var phi_593_: f32;
    var phi_594_: bool;
    var phi_595_: f32;
    var phi_596_: bool;
    var phi_600_: f32;
    var phi_638_: f32;
    var phi_649_: f32;
    var phi_654_: f32;
    var phi_676_: f32;
    var phi_681_: f32;
    var phi_682_: bool;
    var phi_683_: f32;
    var phi_684_: bool;
    var phi_688_: f32;
    var phi_726_: f32;
    var phi_779_: bool;
    var phi_783_: f32;
    var phi_795_: bool;
    var phi_802_: f32;
    var phi_815_: bool;
    var phi_819_: f32;
    var phi_839_: f32;
    var phi_844_: f32;
    var phi_866_: f32;
    var phi_871_: f32;
    var phi_872_: bool;
    var phi_873_: f32;
    var phi_874_: bool;
    var phi_878_: f32;
    var phi_916_: f32;
    var phi_927_: f32;
    var phi_932_: f32;
    var phi_954_: f32;
    var phi_959_: f32;
    var phi_960_: bool;
    var phi_961_: f32;
    var phi_962_: bool;
    var phi_966_: f32;
    var phi_1004_: f32;
    var phi_1015_: f32;
    var phi_1020_: f32;
    var phi_1042_: f32;
    var phi_1047_: f32;
    var phi_1048_: bool;
    var phi_1049_: f32;
    var phi_1050_: bool;
    var phi_1054_: f32;
    var phi_1092_: f32;
    var phi_1103_: f32;
    var phi_1108_: f32;
    var phi_1130_: f32;
    var phi_1135_: f32;
    var phi_1136_: bool;
    var phi_1137_: f32;
    var phi_1138_: bool;
    var phi_1142_: f32;
    var phi_1180_: f32;
    var phi_1233_: bool;
    var phi_1237_: f32;
    var phi_1249_: bool;
    var phi_1256_: f32;
    var phi_1267_: bool;
    var phi_1271_: f32;
    var phi_1286_: f32;
    var phi_1287_: f32;
    var phi_1288_: f32;

    let _e60 = (*param_4).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_362_ = true;
    } else {
        let _e64 = (42f < _e60);
        if _e64 {
        }
        phi_362_ = _e64;
    }
    let _e66 = phi_362_;
    if _e66 {
        phi_366_ = 42f;
    } else {
        phi_366_ = _e60;
    }
    let _e68 = phi_366_;
    let _e70 = (_e68 * param_5.x);
    let _e72 = (_e68 * param_5.y);
    let _e74 = (_e68 * param_5.z);
    let _e76 = (_e68 * param_5.w);
    if ((bitcast<u32>(_e70) & 2147483647u) > 2139095040u) {
        phi_462_ = _e70;
    } else {
        if (_e70 < -87f) {
            phi_385_ = -87f;
        } else {
            phi_385_ = _e70;
        }
        let _e82 = phi_385_;
        if (_e82 > 88f) {
            phi_390_ = 88f;
        } else {
            phi_390_ = _e82;
        }
        let _e85 = phi_390_;
        let _e87 = ((_e85 * 1.442695f) + 0.5f);
        if (_e87 > -8388608f) {
            let _e99 = f32(select(0i, select(select(i32(_e87), i32(-2147483648), (_e87 < bitcast<f32>(3472883712u))), 2147483647i, (_e87 > bitcast<f32>(1325400063u))), (_e87 == _e87)));
            if (_e99 > _e87) {
                phi_412_ = 1f;
            } else {
                phi_412_ = 0f;
            }
            let _e102 = phi_412_;
            if (_e87 < 8388608f) {
                phi_417_ = (_e99 - _e102);
                phi_418_ = false;
            } else {
                phi_417_ = f32();
                phi_418_ = true;
            }
            let _e105 = phi_417_;
            let _e107 = phi_418_;
            phi_419_ = _e105;
            phi_420_ = _e107;
        } else {
            phi_419_ = f32();
            phi_420_ = true;
        }
        let _e109 = phi_419_;
        let _e111 = phi_420_;
        if _e111 {
            phi_424_ = _e87;
        } else {
            phi_424_ = _e109;
        }
        let _e113 = phi_424_;
        let _e117 = ((_e85 - (_e113 * 0.69314575f)) - (_e113 * 0.0000014286068f));
        phi_462_ = ((((((((((((((((1f / 5040f) * _e117) + (1f / 720f)) * _e117) + (1f / 120f)) * _e117) + (1f / 24f)) * _e117) + (1f / 6f)) * _e117) + 0.5f) * _e117) + 1f) * _e117) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e113), i32(-2147483648), (_e113 < bitcast<f32>(3472883712u))), 2147483647i, (_e113 > bitcast<f32>(1325400063u))), (_e113 == _e113)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e153 = phi_462_;
    if ((bitcast<u32>(_e72) & 2147483647u) > 2139095040u) {
        phi_550_ = _e72;
    } else {
        if (_e72 < -87f) {
            phi_473_ = -87f;
        } else {
            phi_473_ = _e72;
        }
        let _e159 = phi_473_;
        if (_e159 > 88f) {
            phi_478_ = 88f;
        } else {
            phi_478_ = _e159;
        }
        let _e162 = phi_478_;
        let _e164 = ((_e162 * 1.442695f) + 0.5f);
        if (_e164 > -8388608f) {
            let _e176 = f32(select(0i, select(select(i32(_e164), i32(-2147483648), (_e164 < bitcast<f32>(3472883712u))), 2147483647i, (_e164 > bitcast<f32>(1325400063u))), (_e164 == _e164)));
            if (_e176 > _e164) {
                phi_500_ = 1f;
            } else {
                phi_500_ = 0f;
            }
            let _e179 = phi_500_;
            if (_e164 < 8388608f) {
                phi_505_ = (_e176 - _e179);
                phi_506_ = false;
            } else {
                phi_505_ = f32();
                phi_506_ = true;
            }
            let _e182 = phi_505_;
            let _e184 = phi_506_;
            phi_507_ = _e182;
            phi_508_ = _e184;
        } else {
            phi_507_ = f32();
            phi_508_ = true;
        }
        let _e186 = phi_507_;
        let _e188 = phi_508_;
        if _e188 {
            phi_512_ = _e164;
        } else {
            phi_512_ = _e186;
        }
        let _e190 = phi_512_;
        let _e194 = ((_e162 - (_e190 * 0.69314575f)) - (_e190 * 0.0000014286068f));
        phi_550_ = ((((((((((((((((1f / 5040f) * _e194) + (1f / 720f)) * _e194) + (1f / 120f)) * _e194) + (1f / 24f)) * _e194) + (1f / 6f)) * _e194) + 0.5f) * _e194) + 1f) * _e194) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e190), i32(-2147483648), (_e190 < bitcast<f32>(3472883712u))), 2147483647i, (_e190 > bitcast<f32>(1325400063u))), (_e190 == _e190)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e230 = phi_550_;
    if ((bitcast<u32>(_e74) & 2147483647u) > 2139095040u) {
        phi_638_ = _e74;
    } else {
        if (_e74 < -87f) {
            phi_561_ = -87f;
        } else {
            phi_561_ = _e74;
        }
        let _e236 = phi_561_;
        if (_e236 > 88f) {
            phi_566_ = 88f;
        } else {
            phi_566_ = _e236;
        }
        let _e239 = phi_566_;
        let _e241 = ((_e239 * 1.442695f) + 0.5f);
        if (_e241 > -8388608f) {
            let _e253 = f32(select(0i, select(select(i32(_e241), i32(-2147483648), (_e241 < bitcast<f32>(3472883712u))), 2147483647i, (_e241 > bitcast<f32>(1325400063u))), (_e241 == _e241)));
            if (_e253 > _e241) {
                phi_588_ = 1f;
            } else {
                phi_588_ = 0f;
            }
            let _e256 = phi_588_;
            if (_e241 < 8388608f) {
                phi_593_ = (_e253 - _e256);
                phi_594_ = false;
            } else {
                phi_593_ = f32();
                phi_594_ = true;
            }
            let _e259 = phi_593_;
            let _e261 = phi_594_;
            phi_595_ = _e259;
            phi_596_ = _e261;
        } else {
            phi_595_ = f32();
            phi_596_ = true;
        }
        let _e263 = phi_595_;
        let _e265 = phi_596_;
        if _e265 {
            phi_600_ = _e241;
        } else {
            phi_600_ = _e263;
        }
        let _e267 = phi_600_;
        let _e271 = ((_e239 - (_e267 * 0.69314575f)) - (_e267 * 0.0000014286068f));
        phi_638_ = ((((((((((((((((1f / 5040f) * _e271) + (1f / 720f)) * _e271) + (1f / 120f)) * _e271) + (1f / 24f)) * _e271) + (1f / 6f)) * _e271) + 0.5f) * _e271) + 1f) * _e271) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e267), i32(-2147483648), (_e267 < bitcast<f32>(3472883712u))), 2147483647i, (_e267 > bitcast<f32>(1325400063u))), (_e267 == _e267)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e307 = phi_638_;
    if ((bitcast<u32>(_e76) & 2147483647u) > 2139095040u) {
        phi_726_ = _e76;
    } else {
        if (_e76 < -87f) {
            phi_649_ = -87f;
        } else {
            phi_649_ = _e76;
        }
        let _e313 = phi_649_;
        if (_e313 > 88f) {
            phi_654_ = 88f;
        } else {
            phi_654_ = _e313;
        }
        let _e316 = phi_654_;
        let _e318 = ((_e316 * 1.442695f) + 0.5f);
        if (_e318 > -8388608f) {
            let _e330 = f32(select(0i, select(select(i32(_e318), i32(-2147483648), (_e318 < bitcast<f32>(3472883712u))), 2147483647i, (_e318 > bitcast<f32>(1325400063u))), (_e318 == _e318)));
            if (_e330 > _e318) {
                phi_676_ = 1f;
            } else {
                phi_676_ = 0f;
            }
            let _e333 = phi_676_;
            if (_e318 < 8388608f) {
                phi_681_ = (_e330 - _e333);
                phi_682_ = false;
            } else {
                phi_681_ = f32();
                phi_682_ = true;
            }
            let _e336 = phi_681_;
            let _e338 = phi_682_;
            phi_683_ = _e336;
            phi_684_ = _e338;
        } else {
            phi_683_ = f32();
            phi_684_ = true;
        }
        let _e340 = phi_683_;
        let _e342 = phi_684_;
        if _e342 {
            phi_688_ = _e318;
        } else {
            phi_688_ = _e340;
        }
        let _e344 = phi_688_;
        let _e348 = ((_e316 - (_e344 * 0.69314575f)) - (_e344 * 0.0000014286068f));
        phi_726_ = ((((((((((((((((1f / 5040f) * _e348) + (1f / 720f)) * _e348) + (1f / 120f)) * _e348) + (1f / 24f)) * _e348) + (1f / 6f)) * _e348) + 0.5f) * _e348) + 1f) * _e348) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e344), i32(-2147483648), (_e344 < bitcast<f32>(3472883712u))), 2147483647i, (_e344 > bitcast<f32>(1325400063u))), (_e344 == _e344)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e384 = phi_726_;
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
        phi_779_ = true;
    } else {
        let _e430 = (_e396 > _e426);
        if _e430 {
        }
        phi_779_ = _e430;
    }
    let _e432 = phi_779_;
    if _e432 {
        phi_783_ = _e396;
    } else {
        phi_783_ = _e426;
    }
    let _e434 = phi_783_;
    let _e435 = -(_e407);
    if (_e435 <= 0f) {
        let _e439 = ((bitcast<u32>(_e434) & 2147483647u) > 2139095040u);
        if _e439 {
        }
        phi_795_ = _e439;
    } else {
        phi_795_ = true;
    }
    let _e441 = phi_795_;
    if _e441 {
        phi_802_ = (_e434 / (_e434 + (_e435 * _e435)));
    } else {
        phi_802_ = 1f;
    }
    let _e446 = phi_802_;
    let _e448 = (*param_4).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_815_ = true;
    } else {
        let _e452 = (42f < _e448);
        if _e452 {
        }
        phi_815_ = _e452;
    }
    let _e454 = phi_815_;
    if _e454 {
        phi_819_ = 42f;
    } else {
        phi_819_ = _e448;
    }
    let _e456 = phi_819_;
    let _e457 = -(_e456);
    let _e459 = (_e457 * param_5.x);
    let _e461 = (_e457 * param_5.y);
    let _e463 = (_e457 * param_5.z);
    let _e465 = (_e457 * param_5.w);
    if ((bitcast<u32>(_e459) & 2147483647u) > 2139095040u) {
        phi_916_ = _e459;
    } else {
        if (_e459 < -87f) {
            phi_839_ = -87f;
        } else {
            phi_839_ = _e459;
        }
        let _e471 = phi_839_;
        if (_e471 > 88f) {
            phi_844_ = 88f;
        } else {
            phi_844_ = _e471;
        }
        let _e474 = phi_844_;
        let _e476 = ((_e474 * 1.442695f) + 0.5f);
        if (_e476 > -8388608f) {
            let _e488 = f32(select(0i, select(select(i32(_e476), i32(-2147483648), (_e476 < bitcast<f32>(3472883712u))), 2147483647i, (_e476 > bitcast<f32>(1325400063u))), (_e476 == _e476)));
            if (_e488 > _e476) {
                phi_866_ = 1f;
            } else {
                phi_866_ = 0f;
            }
            let _e491 = phi_866_;
            if (_e476 < 8388608f) {
                phi_871_ = (_e488 - _e491);
                phi_872_ = false;
            } else {
                phi_871_ = f32();
                phi_872_ = true;
            }
            let _e494 = phi_871_;
            let _e496 = phi_872_;
            phi_873_ = _e494;
            phi_874_ = _e496;
        } else {
            phi_873_ = f32();
            phi_874_ = true;
        }
        let _e498 = phi_873_;
        let _e500 = phi_874_;
        if _e500 {
            phi_878_ = _e476;
        } else {
            phi_878_ = _e498;
        }
        let _e502 = phi_878_;
        let _e506 = ((_e474 - (_e502 * 0.69314575f)) - (_e502 * 0.0000014286068f));
        phi_916_ = ((((((((((((((((1f / 5040f) * _e506) + (1f / 720f)) * _e506) + (1f / 120f)) * _e506) + (1f / 24f)) * _e506) + (1f / 6f)) * _e506) + 0.5f) * _e506) + 1f) * _e506) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e502), i32(-2147483648), (_e502 < bitcast<f32>(3472883712u))), 2147483647i, (_e502 > bitcast<f32>(1325400063u))), (_e502 == _e502)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e542 = phi_916_;
    if ((bitcast<u32>(_e461) & 2147483647u) > 2139095040u) {
        phi_1004_ = _e461;
    } else {
        if (_e461 < -87f) {
            phi_927_ = -87f;
        } else {
            phi_927_ = _e461;
        }
        let _e548 = phi_927_;
        if (_e548 > 88f) {
            phi_932_ = 88f;
        } else {
            phi_932_ = _e548;
        }
        let _e551 = phi_932_;
        let _e553 = ((_e551 * 1.442695f) + 0.5f);
        if (_e553 > -8388608f) {
            let _e565 = f32(select(0i, select(select(i32(_e553), i32(-2147483648), (_e553 < bitcast<f32>(3472883712u))), 2147483647i, (_e553 > bitcast<f32>(1325400063u))), (_e553 == _e553)));
            if (_e565 > _e553) {
                phi_954_ = 1f;
            } else {
                phi_954_ = 0f;
            }
            let _e568 = phi_954_;
            if (_e553 < 8388608f) {
                phi_959_ = (_e565 - _e568);
                phi_960_ = false;
            } else {
                phi_959_ = f32();
                phi_960_ = true;
            }
            let _e571 = phi_959_;
            let _e573 = phi_960_;
            phi_961_ = _e571;
            phi_962_ = _e573;
        } else {
            phi_961_ = f32();
            phi_962_ = true;
        }
        let _e575 = phi_961_;
        let _e577 = phi_962_;
        if _e577 {
            phi_966_ = _e553;
        } else {
            phi_966_ = _e575;
        }
        let _e579 = phi_966_;
        let _e583 = ((_e551 - (_e579 * 0.69314575f)) - (_e579 * 0.0000014286068f));
        phi_1004_ = ((((((((((((((((1f / 5040f) * _e583) + (1f / 720f)) * _e583) + (1f / 120f)) * _e583) + (1f / 24f)) * _e583) + (1f / 6f)) * _e583) + 0.5f) * _e583) + 1f) * _e583) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e579), i32(-2147483648), (_e579 < bitcast<f32>(3472883712u))), 2147483647i, (_e579 > bitcast<f32>(1325400063u))), (_e579 == _e579)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e619 = phi_1004_;
    if ((bitcast<u32>(_e463) & 2147483647u) > 2139095040u) {
        phi_1092_ = _e463;
    } else {
        if (_e463 < -87f) {
            phi_1015_ = -87f;
        } else {
            phi_1015_ = _e463;
        }
        let _e625 = phi_1015_;
        if (_e625 > 88f) {
            phi_1020_ = 88f;
        } else {
            phi_1020_ = _e625;
        }
        let _e628 = phi_1020_;
        let _e630 = ((_e628 * 1.442695f) + 0.5f);
        if (_e630 > -8388608f) {
            let _e642 = f32(select(0i, select(select(i32(_e630), i32(-2147483648), (_e630 < bitcast<f32>(3472883712u))), 2147483647i, (_e630 > bitcast<f32>(1325400063u))), (_e630 == _e630)));
            if (_e642 > _e630) {
                phi_1042_ = 1f;
            } else {
                phi_1042_ = 0f;
            }
            let _e645 = phi_1042_;
            if (_e630 < 8388608f) {
                phi_1047_ = (_e642 - _e645);
                phi_1048_ = false;
            } else {
                phi_1047_ = f32();
                phi_1048_ = true;
            }
            let _e648 = phi_1047_;
            let _e650 = phi_1048_;
            phi_1049_ = _e648;
            phi_1050_ = _e650;
        } else {
            phi_1049_ = f32();
            phi_1050_ = true;
        }
        let _e652 = phi_1049_;
        let _e654 = phi_1050_;
        if _e654 {
            phi_1054_ = _e630;
        } else {
            phi_1054_ = _e652;
        }
        let _e656 = phi_1054_;
        let _e660 = ((_e628 - (_e656 * 0.69314575f)) - (_e656 * 0.0000014286068f));
        phi_1092_ = ((((((((((((((((1f / 5040f) * _e660) + (1f / 720f)) * _e660) + (1f / 120f)) * _e660) + (1f / 24f)) * _e660) + (1f / 6f)) * _e660) + 0.5f) * _e660) + 1f) * _e660) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e656), i32(-2147483648), (_e656 < bitcast<f32>(3472883712u))), 2147483647i, (_e656 > bitcast<f32>(1325400063u))), (_e656 == _e656)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e696 = phi_1092_;
    if ((bitcast<u32>(_e465) & 2147483647u) > 2139095040u) {
        phi_1180_ = _e465;
    } else {
        if (_e465 < -87f) {
            phi_1103_ = -87f;
        } else {
            phi_1103_ = _e465;
        }
        let _e702 = phi_1103_;
        if (_e702 > 88f) {
            phi_1108_ = 88f;
        } else {
            phi_1108_ = _e702;
        }
        let _e705 = phi_1108_;
        let _e707 = ((_e705 * 1.442695f) + 0.5f);
        if (_e707 > -8388608f) {
            let _e719 = f32(select(0i, select(select(i32(_e707), i32(-2147483648), (_e707 < bitcast<f32>(3472883712u))), 2147483647i, (_e707 > bitcast<f32>(1325400063u))), (_e707 == _e707)));
            if (_e719 > _e707) {
                phi_1130_ = 1f;
            } else {
                phi_1130_ = 0f;
            }
            let _e722 = phi_1130_;
            if (_e707 < 8388608f) {
                phi_1135_ = (_e719 - _e722);
                phi_1136_ = false;
            } else {
                phi_1135_ = f32();
                phi_1136_ = true;
            }
            let _e725 = phi_1135_;
            let _e727 = phi_1136_;
            phi_1137_ = _e725;
            phi_1138_ = _e727;
        } else {
            phi_1137_ = f32();
            phi_1138_ = true;
        }
        let _e729 = phi_1137_;
        let _e731 = phi_1138_;
        if _e731 {
            phi_1142_ = _e707;
        } else {
            phi_1142_ = _e729;
        }
        let _e733 = phi_1142_;
        let _e737 = ((_e705 - (_e733 * 0.69314575f)) - (_e733 * 0.0000014286068f));
        phi_1180_ = ((((((((((((((((1f / 5040f) * _e737) + (1f / 720f)) * _e737) + (1f / 120f)) * _e737) + (1f / 24f)) * _e737) + (1f / 6f)) * _e737) + 0.5f) * _e737) + 1f) * _e737) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e733), i32(-2147483648), (_e733 < bitcast<f32>(3472883712u))), 2147483647i, (_e733 > bitcast<f32>(1325400063u))), (_e733 == _e733)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e773 = phi_1180_;
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
        phi_1233_ = true;
    } else {
        let _e819 = (_e785 > _e815);
        if _e819 {
        }
        phi_1233_ = _e819;
    }
    let _e821 = phi_1233_;
    if _e821 {
        phi_1237_ = _e785;
    } else {
        phi_1237_ = _e815;
    }
    let _e823 = phi_1237_;
    let _e824 = -(_e796);
    if (_e824 <= 0f) {
        let _e828 = ((bitcast<u32>(_e823) & 2147483647u) > 2139095040u);
        if _e828 {
        }
        phi_1249_ = _e828;
    } else {
        phi_1249_ = true;
    }
    let _e830 = phi_1249_;
    if _e830 {
        phi_1256_ = (_e823 / (_e823 + (_e824 * _e824)));
    } else {
        phi_1256_ = 1f;
    }
    let _e835 = phi_1256_;
    if ((bitcast<u32>(_e835) & 2147483647u) > 2139095040u) {
        phi_1267_ = true;
    } else {
        let _e839 = (_e835 < _e446);
        if _e839 {
        }
        phi_1267_ = _e839;
    }
    let _e841 = phi_1267_;
    if _e841 {
        phi_1271_ = _e835;
    } else {
        phi_1271_ = _e446;
    }
    let _e843 = phi_1271_;
    if ((bitcast<u32>(_e843) & 2147483647u) > 2139095040u) {
        phi_1288_ = _e843;
    } else {
        if (_e843 < 0f) {
            phi_1287_ = 0f;
        } else {
            if (_e843 > 1f) {
                phi_1286_ = 1f;
            } else {
                phi_1286_ = _e843;
            }
            let _e850 = phi_1286_;
            phi_1287_ = _e850;
        }
        let _e852 = phi_1287_;
        phi_1288_ = _e852;
    }
    let _e854 = phi_1288_;
    return _e854;
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_7: ptr<function, lt_math_Evsm>, param_8: vec4<f32>, param_9: vec4<f32>, param_10: f32) -> f32 {
    var phi_211_: f32;
    var phi_212_: f32;
    var phi_213_: f32;
    var phi_229_: f32;
    var phi_230_: f32;
    var phi_231_: f32;
    var phi_247_: f32;
    var phi_248_: f32;
    var phi_249_: f32;
    var phi_265_: f32;
    var phi_266_: f32;
    var phi_267_: f32;
    var phi_283_: f32;
    var phi_284_: f32;
    var phi_285_: f32;
    var phi_322_: bool;
    var phi_323_: bool;
    var phi_324_: bool;
    var phi_325_: bool;
    var phi_326_: bool;
    var phi_327_: bool;
    var phi_328_: bool;
    var phi_329_: bool;
    var phi_330_: bool;
    var phi_331_: bool;
    var phi_332_: bool;
    var phi_336_: bool;
    var phi_340_: bool;
    var phi_345_: f32;

    if ((bitcast<u32>(param_10) & 2147483647u) > 2139095040u) {
        phi_213_ = param_10;
    } else {
        if (param_10 < 0f) {
            phi_212_ = 0f;
        } else {
            if (param_10 > 1f) {
                phi_211_ = 1f;
            } else {
                phi_211_ = param_10;
            }
            let _e66 = phi_211_;
            phi_212_ = _e66;
        }
        let _e68 = phi_212_;
        phi_213_ = _e68;
    }
    let _e70 = phi_213_;
    if ((bitcast<u32>(param_8.x) & 2147483647u) > 2139095040u) {
        phi_231_ = param_8.x;
    } else {
        if (param_8.x < 0f) {
            phi_230_ = 0f;
        } else {
            if (param_8.x > 1f) {
                phi_229_ = 1f;
            } else {
                phi_229_ = param_8.x;
            }
            let _e78 = phi_229_;
            phi_230_ = _e78;
        }
        let _e80 = phi_230_;
        phi_231_ = _e80;
    }
    let _e82 = phi_231_;
    if ((bitcast<u32>(param_8.y) & 2147483647u) > 2139095040u) {
        phi_249_ = param_8.y;
    } else {
        if (param_8.y < 0f) {
            phi_248_ = 0f;
        } else {
            if (param_8.y > 1f) {
                phi_247_ = 1f;
            } else {
                phi_247_ = param_8.y;
            }
            let _e90 = phi_247_;
            phi_248_ = _e90;
        }
        let _e92 = phi_248_;
        phi_249_ = _e92;
    }
    let _e94 = phi_249_;
    if ((bitcast<u32>(param_8.z) & 2147483647u) > 2139095040u) {
        phi_267_ = param_8.z;
    } else {
        if (param_8.z < 0f) {
            phi_266_ = 0f;
        } else {
            if (param_8.z > 1f) {
                phi_265_ = 1f;
            } else {
                phi_265_ = param_8.z;
            }
            let _e102 = phi_265_;
            phi_266_ = _e102;
        }
        let _e104 = phi_266_;
        phi_267_ = _e104;
    }
    let _e106 = phi_267_;
    if ((bitcast<u32>(param_8.w) & 2147483647u) > 2139095040u) {
        phi_285_ = param_8.w;
    } else {
        if (param_8.w < 0f) {
            phi_284_ = 0f;
        } else {
            if (param_8.w > 1f) {
                phi_283_ = 1f;
            } else {
                phi_283_ = param_8.w;
            }
            let _e114 = phi_283_;
            phi_284_ = _e114;
        }
        let _e116 = phi_284_;
        phi_285_ = _e116;
    }
    let _e118 = phi_285_;
    let _e119 = (_e82 - _e70);
    let _e120 = (_e94 - _e70);
    let _e121 = (_e106 - _e70);
    let _e122 = (_e118 - _e70);
    if (_e119 >= 0f) {
        if (_e120 >= 0f) {
            if (_e121 >= 0f) {
                if (_e122 >= 0f) {
                    phi_322_ = !(((bitcast<u32>(((((_e119 * param_9.x) + (_e120 * param_9.y)) + (_e121 * param_9.z)) + (_e122 * param_9.w))) & 2147483647u) > 2139095040u));
                    phi_323_ = false;
                } else {
                    phi_322_ = bool();
                    phi_323_ = true;
                }
                let _e144 = phi_322_;
                let _e146 = phi_323_;
                phi_324_ = _e144;
                phi_325_ = false;
                phi_326_ = _e146;
            } else {
                phi_324_ = bool();
                phi_325_ = true;
                phi_326_ = false;
            }
            let _e148 = phi_324_;
            let _e150 = phi_325_;
            let _e152 = phi_326_;
            phi_327_ = _e148;
            phi_328_ = _e150;
            phi_329_ = _e152;
        } else {
            phi_327_ = bool();
            phi_328_ = true;
            phi_329_ = false;
        }
        let _e154 = phi_327_;
        let _e156 = phi_328_;
        let _e158 = phi_329_;
        phi_330_ = _e154;
        phi_331_ = _e156;
        phi_332_ = _e158;
    } else {
        phi_330_ = bool();
        phi_331_ = true;
        phi_332_ = false;
    }
    let _e160 = phi_330_;
    let _e162 = phi_331_;
    let _e164 = phi_332_;
    if _e162 {
        phi_336_ = true;
    } else {
        phi_336_ = _e164;
    }
    let _e166 = phi_336_;
    if _e166 {
        phi_340_ = false;
    } else {
        phi_340_ = _e160;
    }
    let _e168 = phi_340_;
    if _e168 {
        phi_345_ = 1f;
    } else {
        let _e169 = _lt_math_evsm_Evsm_bound_of_offsets(param_7, vec4<f32>(_e119, _e120, _e121, _e122), param_9);
        phi_345_ = _e169;
    }
    let _e171 = phi_345_;
    return _e171;
}

fn function_() {
    var local_1: lt_math_Evsm;
    var phi_1344_: bool;
    var phi_1345_: bool;
    var phi_1346_: bool;
    var phi_1347_: bool;
    var phi_1351_: bool;
    var phi_1395_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1399_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1419_: lt_math_LightPoint;
    var phi_1422_: u32;
    var phi_1424_: lt_math_LevelPoint;
    var phi_1510_: bool;
    var phi_1519_: bool;
    var phi_1528_: bool;
    var phi_1529_: bool;
    var phi_1530_: bool;
    var phi_1531_: bool;
    var phi_1532_: bool;
    var phi_1533_: bool;
    var phi_1534_: bool;
    var phi_1538_: bool;
    var phi_1565_: bool;
    var phi_1566_: bool;
    var phi_1567_: bool;
    var phi_1568_: bool;
    var phi_1569_: bool;
    var phi_1570_: bool;
    var phi_1571_: bool;
    var phi_1572_: bool;
    var phi_1576_: bool;
    var phi_1585_: lt_math_LightPoint;
    var phi_1586_: u32;
    var phi_1587_: lt_math_LevelPoint;
    var phi_1588_: bool;
    var phi_1420_: lt_math_LightPoint;
    var phi_1423_: u32;
    var phi_1425_: lt_math_LevelPoint;
    var phi_1589_: bool;
    var local_2: lt_math_LevelPoint;
    var local_3: lt_math_LevelPoint;
    var phi_1629_: bool;
    var phi_1630_: bool;
    var phi_1631_: bool;
    var phi_1632_: bool;
    var phi_1636_: bool;
    var phi_1718_: f32;
    var phi_1834_: f32;
    var phi_1835_: f32;
    var phi_1838_: f32;
    var phi_1867_: f32;
    var phi_1872_: f32;
    var phi_1873_: bool;
    var phi_1874_: f32;
    var phi_1875_: bool;
    var phi_1879_: f32;
    var phi_1899_: f32;
    var phi_1904_: f32;
    var phi_1905_: bool;
    var phi_1906_: f32;
    var phi_1907_: bool;
    var phi_1911_: f32;
    var local_4: lt_math_LevelPoint;
    var phi_1964_: i32;
    var phi_1969_: i32;
    var phi_1974_: i32;
    var phi_1979_: i32;
    var phi_1988_: i32;
    var phi_1993_: i32;
    var phi_1998_: i32;
    var phi_2003_: i32;
    var phi_2054_: bool;
    var phi_2062_: bool;
    var phi_2074_: bool;
    var phi_2075_: bool;
    var phi_2079_: f32;
    var phi_2085_: f32;
    var phi_2087_: evaluate_Verdict;
    var phi_2092_: evaluate_Verdict;
    var phi_2093_: evaluate_Verdict;
    var phi_2097_: bool;
    var phi_2098_: u32;
    var phi_2109_: u32;

    let _e57 = id_1;
    let _e58 = local_5;
    let _e63 = arrayLength((&map.member));
    let _e68 = arrayLength((&levels.member));
    let _e71 = p.member.size[0u];
    let _e73 = p.member.size[1u];
    let _e74 = lt_shaders_entry_pixel_index(_e57, _e71, _e73);
    if (bitcast<i32>(_e74.root) != 0i) {
        let _e81 = p.member.level_count;
        let _e83 = p.member.light;
        let _e86 = samples.member[_e74.first_primitive].normal[0u];
        let _e88 = global[0u];
        if (_e86 == _e88) {
            let _e91 = samples.member[_e74.first_primitive].normal[1u];
            let _e93 = global[1u];
            if (_e91 == _e93) {
                let _e96 = samples.member[_e74.first_primitive].normal[2u];
                let _e98 = global[2u];
                phi_1344_ = (_e96 == _e98);
                phi_1345_ = false;
            } else {
                phi_1344_ = bool();
                phi_1345_ = true;
            }
            let _e101 = phi_1344_;
            let _e103 = phi_1345_;
            phi_1346_ = _e101;
            phi_1347_ = _e103;
        } else {
            phi_1346_ = bool();
            phi_1347_ = true;
        }
        let _e105 = phi_1346_;
        let _e107 = phi_1347_;
        if _e107 {
            phi_1351_ = false;
        } else {
            phi_1351_ = _e105;
        }
        let _e109 = phi_1351_;
        if !(_e109) {
            let _e112 = samples.member[_e74.first_primitive].normal;
            let _e114 = samples.member[_e74.first_primitive].position;
            if ((((_e112.x * (_e83.x - (_e114.x * _e83.w))) + (_e112.y * (_e83.y - (_e114.y * _e83.w)))) + (_e112.z * (_e83.z - (_e114.z * _e83.w)))) > 0f) {
                let _e138 = samples.member[_e74.first_primitive].flags;
                let _e146 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e152 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e146.unnamed.visibility, false), _e146.unnamed_1);
                phi_1395_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e152.unnamed, ((_e138 & 1u) == 0u));
            } else {
                let _e161 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e167 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e161.unnamed.visibility, false), _e161.unnamed_1);
                phi_1395_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e167.unnamed, true);
            }
            let _e172 = phi_1395_;
            phi_1399_ = _e172;
        } else {
            let _e178 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e184 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e178.unnamed.visibility, false), _e178.unnamed_1);
            phi_1399_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e184.unnamed, true);
        }
        let _e189 = phi_1399_;
        if _e189.unnamed_1 {
            phi_2093_ = evaluate_Verdict(_e189.unnamed.visibility, _e189.unnamed.is_doubted);
        } else {
            let _e197 = samples.member[_e74.first_primitive].position;
            let _e199 = p.member.map_size;
            let _e201 = (0.5f / f32(_e199));
            let _e208 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e215 = lt_math_LightPoint(vec2<f32>(_e208.uv.x, 0f), _e208.depth, _e208.is_inside);
            let _e219 = lt_math_LightPoint(_e215.uv, 0f, _e215.is_inside);
            phi_1419_ = lt_math_LightPoint();
            phi_1422_ = 0u;
            phi_1424_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e219.uv, _e219.depth, false));
            loop {
                let _e226 = phi_1419_;
                let _e228 = phi_1422_;
                let _e230 = phi_1424_;
                local_2 = _e230;
                local_3 = _e230;
                local_4 = _e230;
                if (_e228 < _e81) {
                    if _e230.point.is_inside {
                        phi_1585_ = lt_math_LightPoint();
                        phi_1586_ = u32();
                        phi_1587_ = lt_math_LevelPoint();
                        phi_1588_ = false;
                    } else {
                        if (_e228 < _e68) {
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
                                phi_1510_ = (_e266 <= 1f);
                            } else {
                                phi_1510_ = false;
                            }
                            let _e298 = phi_1510_;
                            if _e298 {
                                if (_e280 >= 0f) {
                                    phi_1519_ = (_e280 <= 1f);
                                } else {
                                    phi_1519_ = false;
                                }
                                let _e302 = phi_1519_;
                                if _e302 {
                                    if (_e293 >= 0f) {
                                        phi_1528_ = (_e293 <= 1f);
                                    } else {
                                        phi_1528_ = false;
                                    }
                                    let _e306 = phi_1528_;
                                    phi_1529_ = _e306;
                                    phi_1530_ = false;
                                } else {
                                    phi_1529_ = bool();
                                    phi_1530_ = true;
                                }
                                let _e308 = phi_1529_;
                                let _e310 = phi_1530_;
                                phi_1531_ = _e308;
                                phi_1532_ = _e310;
                            } else {
                                phi_1531_ = bool();
                                phi_1532_ = true;
                            }
                            let _e312 = phi_1531_;
                            let _e314 = phi_1532_;
                            phi_1533_ = _e312;
                            phi_1534_ = _e314;
                        } else {
                            phi_1533_ = bool();
                            phi_1534_ = true;
                        }
                        let _e316 = phi_1533_;
                        let _e318 = phi_1534_;
                        if _e318 {
                            phi_1538_ = false;
                        } else {
                            phi_1538_ = _e316;
                        }
                        let _e320 = phi_1538_;
                        if _e320 {
                            if (_e266 >= _e201) {
                                if (_e266 <= (1f - _e201)) {
                                    if (_e280 >= _e201) {
                                        phi_1565_ = (_e280 <= (1f - _e201));
                                        phi_1566_ = false;
                                    } else {
                                        phi_1565_ = bool();
                                        phi_1566_ = true;
                                    }
                                    let _e328 = phi_1565_;
                                    let _e330 = phi_1566_;
                                    phi_1567_ = _e328;
                                    phi_1568_ = _e330;
                                } else {
                                    phi_1567_ = bool();
                                    phi_1568_ = true;
                                }
                                let _e332 = phi_1567_;
                                let _e334 = phi_1568_;
                                phi_1569_ = _e332;
                                phi_1570_ = _e334;
                            } else {
                                phi_1569_ = bool();
                                phi_1570_ = true;
                            }
                            let _e336 = phi_1569_;
                            let _e338 = phi_1570_;
                            phi_1571_ = _e336;
                            phi_1572_ = _e338;
                        } else {
                            phi_1571_ = bool();
                            phi_1572_ = true;
                        }
                        let _e340 = phi_1571_;
                        let _e342 = phi_1572_;
                        if _e342 {
                            phi_1576_ = false;
                        } else {
                            phi_1576_ = _e340;
                        }
                        let _e344 = phi_1576_;
                        let _e351 = lt_math_LightPoint(vec2<f32>(_e266, _e226.uv.y), _e226.depth, _e226.is_inside);
                        let _e358 = lt_math_LightPoint(vec2<f32>(_e351.uv.x, _e280), _e351.depth, _e351.is_inside);
                        let _e362 = lt_math_LightPoint(_e358.uv, _e293, _e358.is_inside);
                        let _e366 = lt_math_LightPoint(_e362.uv, _e362.depth, _e344);
                        phi_1585_ = _e366;
                        phi_1586_ = (_e228 + 1u);
                        phi_1587_ = lt_math_LevelPoint(_e228, _e366);
                        phi_1588_ = true;
                    }
                    let _e370 = phi_1585_;
                    let _e372 = phi_1586_;
                    let _e374 = phi_1587_;
                    let _e376 = phi_1588_;
                    phi_1420_ = _e370;
                    phi_1423_ = _e372;
                    phi_1425_ = _e374;
                    phi_1589_ = _e376;
                } else {
                    phi_1420_ = lt_math_LightPoint();
                    phi_1423_ = u32();
                    phi_1425_ = lt_math_LevelPoint();
                    phi_1589_ = false;
                }
                let _e378 = phi_1420_;
                let _e380 = phi_1423_;
                let _e382 = phi_1425_;
                let _e384 = phi_1589_;
                continue;
                continuing {
                    phi_1419_ = _e378;
                    phi_1422_ = _e380;
                    phi_1424_ = _e382;
                    break if !(_e384);
                }
            }
            let _e387 = local_2;
            if _e387.point.is_inside {
                if (0f > 0f) {
                    let _e393 = local_3;
                    if (_e393.level < _e68) {
                    } else {
                        return;
                    }
                    let _e398 = levels.member[(0u + _e393.level)];
                    let _e404 = global[0u];
                    if (_e398.row_w.x == _e404) {
                        let _e407 = global[1u];
                        if (_e398.row_w.y == _e407) {
                            let _e410 = global[2u];
                            phi_1629_ = (_e398.row_w.z == _e410);
                            phi_1630_ = false;
                        } else {
                            phi_1629_ = bool();
                            phi_1630_ = true;
                        }
                        let _e413 = phi_1629_;
                        let _e415 = phi_1630_;
                        phi_1631_ = _e413;
                        phi_1632_ = _e415;
                    } else {
                        phi_1631_ = bool();
                        phi_1632_ = true;
                    }
                    let _e417 = phi_1631_;
                    let _e419 = phi_1632_;
                    if _e419 {
                        phi_1636_ = false;
                    } else {
                        phi_1636_ = _e417;
                    }
                    let _e421 = phi_1636_;
                    if _e421 {
                        let _e423 = samples.member[_e74.first_primitive].normal;
                        let _e425 = p.member.map_size;
                        let _e495 = ((abs(((((_e398.row_x.x * _e423.x) + (_e398.row_x.y * _e423.y)) + (_e398.row_x.z * _e423.z)) / (((_e398.row_x.x * _e398.row_x.x) + (_e398.row_x.y * _e398.row_x.y)) + (_e398.row_x.z * _e398.row_x.z)))) + abs(((((_e398.row_y.x * _e423.x) + (_e398.row_y.y * _e423.y)) + (_e398.row_y.z * _e423.z)) / (((_e398.row_y.x * _e398.row_y.x) + (_e398.row_y.y * _e398.row_y.y)) + (_e398.row_y.z * _e398.row_y.z))))) / (abs(((((_e398.row_z.x * _e423.x) + (_e398.row_z.y * _e423.y)) + (_e398.row_z.z * _e423.z)) / (((_e398.row_z.x * _e398.row_z.x) + (_e398.row_z.y * _e398.row_z.y)) + (_e398.row_z.z * _e398.row_z.z)))) * f32(_e425)));
                        if (_e495 < 0.002f) {
                            phi_1718_ = _e495;
                        } else {
                            phi_1718_ = 0.002f;
                        }
                        let _e498 = phi_1718_;
                        phi_1835_ = _e498;
                    } else {
                        let _e500 = p.member.map_size;
                        let _e506 = samples.member[_e74.first_primitive].position;
                        let _e517 = ((((_e398.row_w.x * _e506.x) + (_e398.row_w.y * _e506.y)) + (_e398.row_w.z * _e506.z)) + _e398.row_w.w);
                        let _e530 = ((_e398.row_x.x - (_e398.row_w.x * _e387.point.uv.x)) / _e517);
                        let _e531 = ((_e398.row_x.y - (_e398.row_w.y * _e387.point.uv.x)) / _e517);
                        let _e532 = ((_e398.row_x.z - (_e398.row_w.z * _e387.point.uv.x)) / _e517);
                        let _e545 = ((_e398.row_y.x - (_e398.row_w.x * _e387.point.uv.y)) / _e517);
                        let _e546 = ((_e398.row_y.y - (_e398.row_w.y * _e387.point.uv.y)) / _e517);
                        let _e547 = ((_e398.row_y.z - (_e398.row_w.z * _e387.point.uv.y)) / _e517);
                        let _e553 = samples.member[_e74.first_primitive].normal;
                        let _e558 = ((_e546 * _e553.z) - (_e553.y * _e547));
                        let _e563 = ((_e547 * _e553.x) - (_e553.z * _e545));
                        let _e568 = ((_e545 * _e553.y) - (_e553.x * _e546));
                        let _e570 = samples.member[_e74.first_primitive].normal;
                        let _e575 = ((_e531 * _e570.z) - (_e570.y * _e532));
                        let _e580 = ((_e532 * _e570.x) - (_e570.z * _e530));
                        let _e585 = ((_e530 * _e570.y) - (_e570.x * _e531));
                        let _e612 = ((abs(((((_e398.row_z.x * _e558) + (_e398.row_z.y * _e563)) + (_e398.row_z.z * _e568)) / (((_e530 * _e558) + (_e531 * _e563)) + (_e532 * _e568)))) + abs(((((_e398.row_z.x * _e575) + (_e398.row_z.y * _e580)) + (_e398.row_z.z * _e585)) / (((_e545 * _e575) + (_e546 * _e580)) + (_e547 * _e585))))) / f32(_e500));
                        if (_e612 < 0.002f) {
                            phi_1834_ = _e612;
                        } else {
                            phi_1834_ = 0.002f;
                        }
                        let _e615 = phi_1834_;
                        phi_1835_ = _e615;
                    }
                    let _e617 = phi_1835_;
                    phi_1838_ = (_e387.point.depth - (0f * _e617));
                } else {
                    phi_1838_ = _e387.point.depth;
                }
                let _e621 = phi_1838_;
                let _e627 = p.member.map_size;
                let _e628 = f32(_e627);
                let _e631 = ((_e387.point.uv.x * _e628) - 0.5f);
                let _e632 = ((_e387.point.uv.y * _e628) - 0.5f);
                if (_e631 > -8388608f) {
                    let _e644 = f32(select(0i, select(select(i32(_e631), i32(-2147483648), (_e631 < bitcast<f32>(3472883712u))), 2147483647i, (_e631 > bitcast<f32>(1325400063u))), (_e631 == _e631)));
                    if (_e644 > _e631) {
                        phi_1867_ = 1f;
                    } else {
                        phi_1867_ = 0f;
                    }
                    let _e647 = phi_1867_;
                    if (_e631 < 8388608f) {
                        phi_1872_ = (_e644 - _e647);
                        phi_1873_ = false;
                    } else {
                        phi_1872_ = f32();
                        phi_1873_ = true;
                    }
                    let _e650 = phi_1872_;
                    let _e652 = phi_1873_;
                    phi_1874_ = _e650;
                    phi_1875_ = _e652;
                } else {
                    phi_1874_ = f32();
                    phi_1875_ = true;
                }
                let _e654 = phi_1874_;
                let _e656 = phi_1875_;
                if _e656 {
                    phi_1879_ = _e631;
                } else {
                    phi_1879_ = _e654;
                }
                let _e658 = phi_1879_;
                if (_e632 > -8388608f) {
                    let _e670 = f32(select(0i, select(select(i32(_e632), i32(-2147483648), (_e632 < bitcast<f32>(3472883712u))), 2147483647i, (_e632 > bitcast<f32>(1325400063u))), (_e632 == _e632)));
                    if (_e670 > _e632) {
                        phi_1899_ = 1f;
                    } else {
                        phi_1899_ = 0f;
                    }
                    let _e673 = phi_1899_;
                    if (_e632 < 8388608f) {
                        phi_1904_ = (_e670 - _e673);
                        phi_1905_ = false;
                    } else {
                        phi_1904_ = f32();
                        phi_1905_ = true;
                    }
                    let _e676 = phi_1904_;
                    let _e678 = phi_1905_;
                    phi_1906_ = _e676;
                    phi_1907_ = _e678;
                } else {
                    phi_1906_ = f32();
                    phi_1907_ = true;
                }
                let _e680 = phi_1906_;
                let _e682 = phi_1907_;
                if _e682 {
                    phi_1911_ = _e632;
                } else {
                    phi_1911_ = _e680;
                }
                let _e684 = phi_1911_;
                let _e685 = (_e631 - _e658);
                let _e686 = (_e632 - _e684);
                let _e695 = select(0i, select(select(i32(_e658), i32(-2147483648), (_e658 < bitcast<f32>(3472883712u))), 2147483647i, (_e658 > bitcast<f32>(1325400063u))), (_e658 == _e658));
                let _e704 = select(0i, select(select(i32(_e684), i32(-2147483648), (_e684 < bitcast<f32>(3472883712u))), 2147483647i, (_e684 > bitcast<f32>(1325400063u))), (_e684 == _e684));
                let _e715 = p.member.test;
                let _e716 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e715);
                let _e718 = p.member.map_size;
                let _e720 = local_4;
                local_1 = lt_math_Evsm(_e716.positive_exponent, _e716.negative_exponent, _e716.min_variance);
                let _e727 = ((_e720.level * _e718) * _e718);
                let _e729 = (bitcast<i32>(_e718) - 1i);
                if (_e695 > 0i) {
                    phi_1964_ = _e695;
                } else {
                    phi_1964_ = 0i;
                }
                let _e732 = phi_1964_;
                if (_e704 > 0i) {
                    phi_1969_ = _e704;
                } else {
                    phi_1969_ = 0i;
                }
                let _e735 = phi_1969_;
                if (_e732 < _e729) {
                    phi_1974_ = _e732;
                } else {
                    phi_1974_ = _e729;
                }
                let _e738 = phi_1974_;
                if (_e735 < _e729) {
                    phi_1979_ = _e735;
                } else {
                    phi_1979_ = _e729;
                }
                let _e741 = phi_1979_;
                let _e742 = bitcast<u32>(_e738);
                let _e744 = (_e695 + 1i);
                let _e745 = (_e704 + 1i);
                if (_e744 > 0i) {
                    phi_1988_ = _e744;
                } else {
                    phi_1988_ = 0i;
                }
                let _e748 = phi_1988_;
                if (_e745 > 0i) {
                    phi_1993_ = _e745;
                } else {
                    phi_1993_ = 0i;
                }
                let _e751 = phi_1993_;
                if (_e748 < _e729) {
                    phi_1998_ = _e748;
                } else {
                    phi_1998_ = _e729;
                }
                let _e754 = phi_1998_;
                if (_e751 < _e729) {
                    phi_2003_ = _e751;
                } else {
                    phi_2003_ = _e729;
                }
                let _e757 = phi_2003_;
                let _e758 = bitcast<u32>(_e754);
                let _e760 = (bitcast<u32>(_e741) * _e718);
                let _e761 = (bitcast<u32>(_e757) * _e718);
                let _e766 = ((_e760 + _e742) + _e727);
                let _e767 = ((_e760 + _e758) + _e727);
                let _e768 = ((_e761 + _e742) + _e727);
                let _e769 = ((_e761 + _e758) + _e727);
                if (_e766 < _e63) {
                } else {
                    return;
                }
                let _e773 = map.member[(0u + _e766)];
                if (_e767 < _e63) {
                } else {
                    return;
                }
                let _e777 = map.member[(0u + _e767)];
                if (_e768 < _e63) {
                } else {
                    return;
                }
                let _e781 = map.member[(0u + _e768)];
                if (_e769 < _e63) {
                } else {
                    return;
                }
                let _e785 = map.member[(0u + _e769)];
                let _e787 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local_1), vec4<f32>(_e773, _e777, _e781, _e785), vec4<f32>(((1f - _e685) * (1f - _e686)), (_e685 * (1f - _e686)), ((1f - _e685) * _e686), (_e685 * _e686)), _e621);
                let _e789 = p.member.epsilon;
                if (_e787 <= _e789) {
                    phi_2054_ = true;
                } else {
                    phi_2054_ = (_e787 >= (1f - _e789));
                }
                let _e794 = phi_2054_;
                if ((bitcast<u32>(_e787) & 2147483647u) > 2139095040u) {
                    phi_2062_ = true;
                } else {
                    phi_2062_ = !(_e794);
                }
                let _e800 = phi_2062_;
                if _e800 {
                    if (_e787 > 0f) {
                        if (_e787 < 1f) {
                            phi_2074_ = false;
                        } else {
                            phi_2074_ = true;
                        }
                        let _e804 = phi_2074_;
                        phi_2075_ = _e804;
                    } else {
                        phi_2075_ = true;
                    }
                    let _e806 = phi_2075_;
                    if _e806 {
                        phi_2079_ = 0.5f;
                    } else {
                        phi_2079_ = _e787;
                    }
                    let _e808 = phi_2079_;
                    phi_2087_ = evaluate_Verdict(_e808, true);
                } else {
                    if (_e787 > 0.5f) {
                        phi_2085_ = 1f;
                    } else {
                        phi_2085_ = 0f;
                    }
                    let _e812 = phi_2085_;
                    phi_2087_ = evaluate_Verdict(_e812, false);
                }
                let _e815 = phi_2087_;
                phi_2092_ = evaluate_Verdict(_e815.visibility, _e815.is_doubted);
            } else {
                phi_2092_ = evaluate_Verdict(0.5f, true);
            }
            let _e821 = phi_2092_;
            phi_2093_ = _e821;
        }
        let _e823 = phi_2093_;
        visibility.member[_e74.first_primitive] = _e823.visibility;
        phi_2097_ = _e823.is_doubted;
        phi_2098_ = _e74.first_primitive;
    } else {
        phi_2097_ = false;
        phi_2098_ = 0u;
    }
    let _e828 = phi_2097_;
    let _e830 = phi_2098_;
    if (_e58 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e828 {
        let _e834 = atomicAdd((&shared_[0u]), 1u);
        phi_2109_ = _e834;
    } else {
        phi_2109_ = 0u;
    }
    let _e836 = phi_2109_;
    workgroupBarrier();
    if (_e58 == 0u) {
        let _e840 = atomicLoad((&shared_[0u]));
        let _e841 = atomicAdd((&list.member[3u]), _e840);
        atomicStore((&shared_[1u]), _e841);
    }
    workgroupBarrier();
    if _e828 {
        let _e844 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e844) + _e836)]), _e830);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_evsm_levels_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_5 = local;
    function_();
}
