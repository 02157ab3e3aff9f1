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

struct type_20 {
    member: array<abi_Sample>,
}

struct type_24 {
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

struct type_39 {
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

struct type_46 {
    member: array<lt_math_LightProjection>,
}

struct lt_math_LevelPoint {
    level: u32,
    point: lt_math_LightPoint,
}

struct type_52 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
var<private> local_5: u32;
@group(0) @binding(1) 
var<storage> samples: type_20;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(0) 
var<uniform> p: type_39;
@group(0) @binding(2) 
var<storage> map: type_24;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_24;
@group(0) @binding(4) 
var<storage, read_write> list: type_52;
@group(0) @binding(5) 
var<storage> levels: type_46;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_179_: lt_bvh_traverse_Tree;
    var phi_180_: bool;
    var phi_181_: lt_bvh_traverse_Tree;
    var phi_182_: bool;
    var phi_187_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_179_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_180_ = false;
        } else {
            phi_179_ = lt_bvh_traverse_Tree();
            phi_180_ = true;
        }
        let _e70 = phi_179_;
        let _e72 = phi_180_;
        phi_181_ = _e70;
        phi_182_ = _e72;
    } else {
        phi_181_ = lt_bvh_traverse_Tree();
        phi_182_ = true;
    }
    let _e74 = phi_181_;
    let _e76 = phi_182_;
    if _e76 {
        phi_187_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_187_ = _e74;
    }
    let _e81 = phi_187_;
    return lt_bvh_traverse_Tree(_e81.root, _e81.first_primitive);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> lt_math_Evsm {
    return lt_math_Evsm(param_3.x, param_3.y, param_3.z);
}

fn _lt_math_evsm_Evsm_bound_of_offsets(param_4: ptr<function, lt_math_Evsm>, param_5: vec4<f32>, param_6: vec4<f32>) -> f32 {
    var phi_367_: bool;
    var phi_371_: f32;
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
    var phi_654_: f32;
    var phi_659_: f32;
    var phi_681_: f32;
    var phi_686_: f32;
    var phi_687_: bool;
    var phi_688_: f32;
    var phi_689_: bool;
    var phi_693_: f32;
    var phi_731_: f32;
    var phi_784_: bool;
    var phi_788_: f32;
    var phi_800_: bool;
    var phi_807_: f32;
    var phi_820_: bool;
    var phi_824_: f32;
    var phi_844_: f32;
    var phi_849_: f32;
    var phi_871_: f32;
    var phi_876_: f32;
    var phi_877_: bool;
    var phi_878_: f32;
    var phi_879_: bool;
    var phi_883_: f32;
    var phi_921_: f32;
    var phi_932_: f32;
    var phi_937_: f32;
    var phi_959_: f32;
    var phi_964_: f32;
    var phi_965_: bool;
    var phi_966_: f32;
    var phi_967_: bool;
    var phi_971_: f32;
    var phi_1009_: f32;
    var phi_1020_: f32;
    var phi_1025_: f32;
    var phi_1047_: f32;
    var phi_1052_: f32;
    var phi_1053_: bool;
    var phi_1054_: f32;
    var phi_1055_: bool;
    var phi_1059_: f32;
    var phi_1097_: f32;
    var phi_1108_: f32;
    var phi_1113_: f32;
    var phi_1135_: f32;
    var phi_1140_: f32;
    var phi_1141_: bool;
    var phi_1142_: f32;
    var phi_1143_: bool;
    var phi_1147_: f32;
    var phi_1185_: f32;
    var phi_1238_: bool;
    var phi_1242_: f32;
    var phi_1254_: bool;
    var phi_1261_: f32;
    var phi_1272_: bool;
    var phi_1276_: f32;
    var phi_1291_: f32;
    var phi_1292_: f32;
    var phi_1293_: f32;

    let _e61 = (*param_4).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_367_ = true;
    } else {
        let _e65 = (42f < _e61);
        if _e65 {
        }
        phi_367_ = _e65;
    }
    let _e67 = phi_367_;
    if _e67 {
        phi_371_ = 42f;
    } else {
        phi_371_ = _e61;
    }
    let _e69 = phi_371_;
    let _e71 = (_e69 * param_5.x);
    let _e73 = (_e69 * param_5.y);
    let _e75 = (_e69 * param_5.z);
    let _e77 = (_e69 * param_5.w);
    if ((bitcast<u32>(_e71) & 2147483647u) > 2139095040u) {
        phi_467_ = _e71;
    } else {
        if (_e71 < -87f) {
            phi_390_ = -87f;
        } else {
            phi_390_ = _e71;
        }
        let _e83 = phi_390_;
        if (_e83 > 88f) {
            phi_395_ = 88f;
        } else {
            phi_395_ = _e83;
        }
        let _e86 = phi_395_;
        let _e88 = ((_e86 * 1.442695f) + 0.5f);
        if (_e88 > -8388608f) {
            let _e100 = f32(select(0i, select(select(i32(_e88), i32(-2147483648), (_e88 < bitcast<f32>(3472883712u))), 2147483647i, (_e88 > bitcast<f32>(1325400063u))), (_e88 == _e88)));
            if (_e100 > _e88) {
                phi_417_ = 1f;
            } else {
                phi_417_ = 0f;
            }
            let _e103 = phi_417_;
            if (_e88 < 8388608f) {
                phi_422_ = (_e100 - _e103);
                phi_423_ = false;
            } else {
                phi_422_ = f32();
                phi_423_ = true;
            }
            let _e106 = phi_422_;
            let _e108 = phi_423_;
            phi_424_ = _e106;
            phi_425_ = _e108;
        } else {
            phi_424_ = f32();
            phi_425_ = true;
        }
        let _e110 = phi_424_;
        let _e112 = phi_425_;
        if _e112 {
            phi_429_ = _e88;
        } else {
            phi_429_ = _e110;
        }
        let _e114 = phi_429_;
        let _e118 = ((_e86 - (_e114 * 0.69314575f)) - (_e114 * 0.0000014286068f));
        phi_467_ = ((((((((((((((((1f / 5040f) * _e118) + (1f / 720f)) * _e118) + (1f / 120f)) * _e118) + (1f / 24f)) * _e118) + (1f / 6f)) * _e118) + 0.5f) * _e118) + 1f) * _e118) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e114), i32(-2147483648), (_e114 < bitcast<f32>(3472883712u))), 2147483647i, (_e114 > bitcast<f32>(1325400063u))), (_e114 == _e114)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e154 = phi_467_;
    if ((bitcast<u32>(_e73) & 2147483647u) > 2139095040u) {
        phi_555_ = _e73;
    } else {
        if (_e73 < -87f) {
            phi_478_ = -87f;
        } else {
            phi_478_ = _e73;
        }
        let _e160 = phi_478_;
        if (_e160 > 88f) {
            phi_483_ = 88f;
        } else {
            phi_483_ = _e160;
        }
        let _e163 = phi_483_;
        let _e165 = ((_e163 * 1.442695f) + 0.5f);
        if (_e165 > -8388608f) {
            let _e177 = f32(select(0i, select(select(i32(_e165), i32(-2147483648), (_e165 < bitcast<f32>(3472883712u))), 2147483647i, (_e165 > bitcast<f32>(1325400063u))), (_e165 == _e165)));
            if (_e177 > _e165) {
                phi_505_ = 1f;
            } else {
                phi_505_ = 0f;
            }
            let _e180 = phi_505_;
            if (_e165 < 8388608f) {
                phi_510_ = (_e177 - _e180);
                phi_511_ = false;
            } else {
                phi_510_ = f32();
                phi_511_ = true;
            }
            let _e183 = phi_510_;
            let _e185 = phi_511_;
            phi_512_ = _e183;
            phi_513_ = _e185;
        } else {
            phi_512_ = f32();
            phi_513_ = true;
        }
        let _e187 = phi_512_;
        let _e189 = phi_513_;
        if _e189 {
            phi_517_ = _e165;
        } else {
            phi_517_ = _e187;
        }
        let _e191 = phi_517_;
        let _e195 = ((_e163 - (_e191 * 0.69314575f)) - (_e191 * 0.0000014286068f));
        phi_555_ = ((((((((((((((((1f / 5040f) * _e195) + (1f / 720f)) * _e195) + (1f / 120f)) * _e195) + (1f / 24f)) * _e195) + (1f / 6f)) * _e195) + 0.5f) * _e195) + 1f) * _e195) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e191), i32(-2147483648), (_e191 < bitcast<f32>(3472883712u))), 2147483647i, (_e191 > bitcast<f32>(1325400063u))), (_e191 == _e191)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e231 = phi_555_;
    if ((bitcast<u32>(_e75) & 2147483647u) > 2139095040u) {
        phi_643_ = _e75;
    } else {
        if (_e75 < -87f) {
            phi_566_ = -87f;
        } else {
            phi_566_ = _e75;
        }
        let _e237 = phi_566_;
        if (_e237 > 88f) {
            phi_571_ = 88f;
        } else {
            phi_571_ = _e237;
        }
        let _e240 = phi_571_;
        let _e242 = ((_e240 * 1.442695f) + 0.5f);
        if (_e242 > -8388608f) {
            let _e254 = f32(select(0i, select(select(i32(_e242), i32(-2147483648), (_e242 < bitcast<f32>(3472883712u))), 2147483647i, (_e242 > bitcast<f32>(1325400063u))), (_e242 == _e242)));
            if (_e254 > _e242) {
                phi_593_ = 1f;
            } else {
                phi_593_ = 0f;
            }
            let _e257 = phi_593_;
            if (_e242 < 8388608f) {
                phi_598_ = (_e254 - _e257);
                phi_599_ = false;
            } else {
                phi_598_ = f32();
                phi_599_ = true;
            }
            let _e260 = phi_598_;
            let _e262 = phi_599_;
            phi_600_ = _e260;
            phi_601_ = _e262;
        } else {
            phi_600_ = f32();
            phi_601_ = true;
        }
        let _e264 = phi_600_;
        let _e266 = phi_601_;
        if _e266 {
            phi_605_ = _e242;
        } else {
            phi_605_ = _e264;
        }
        let _e268 = phi_605_;
        let _e272 = ((_e240 - (_e268 * 0.69314575f)) - (_e268 * 0.0000014286068f));
        phi_643_ = ((((((((((((((((1f / 5040f) * _e272) + (1f / 720f)) * _e272) + (1f / 120f)) * _e272) + (1f / 24f)) * _e272) + (1f / 6f)) * _e272) + 0.5f) * _e272) + 1f) * _e272) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e268), i32(-2147483648), (_e268 < bitcast<f32>(3472883712u))), 2147483647i, (_e268 > bitcast<f32>(1325400063u))), (_e268 == _e268)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e308 = phi_643_;
    if ((bitcast<u32>(_e77) & 2147483647u) > 2139095040u) {
        phi_731_ = _e77;
    } else {
        if (_e77 < -87f) {
            phi_654_ = -87f;
        } else {
            phi_654_ = _e77;
        }
        let _e314 = phi_654_;
        if (_e314 > 88f) {
            phi_659_ = 88f;
        } else {
            phi_659_ = _e314;
        }
        let _e317 = phi_659_;
        let _e319 = ((_e317 * 1.442695f) + 0.5f);
        if (_e319 > -8388608f) {
            let _e331 = f32(select(0i, select(select(i32(_e319), i32(-2147483648), (_e319 < bitcast<f32>(3472883712u))), 2147483647i, (_e319 > bitcast<f32>(1325400063u))), (_e319 == _e319)));
            if (_e331 > _e319) {
                phi_681_ = 1f;
            } else {
                phi_681_ = 0f;
            }
            let _e334 = phi_681_;
            if (_e319 < 8388608f) {
                phi_686_ = (_e331 - _e334);
                phi_687_ = false;
            } else {
                phi_686_ = f32();
                phi_687_ = true;
            }
            let _e337 = phi_686_;
            let _e339 = phi_687_;
            phi_688_ = _e337;
            phi_689_ = _e339;
        } else {
            phi_688_ = f32();
            phi_689_ = true;
        }
        let _e341 = phi_688_;
        let _e343 = phi_689_;
        if _e343 {
            phi_693_ = _e319;
        } else {
            phi_693_ = _e341;
        }
        let _e345 = phi_693_;
        let _e349 = ((_e317 - (_e345 * 0.69314575f)) - (_e345 * 0.0000014286068f));
        phi_731_ = ((((((((((((((((1f / 5040f) * _e349) + (1f / 720f)) * _e349) + (1f / 120f)) * _e349) + (1f / 24f)) * _e349) + (1f / 6f)) * _e349) + 0.5f) * _e349) + 1f) * _e349) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e345), i32(-2147483648), (_e345 < bitcast<f32>(3472883712u))), 2147483647i, (_e345 > bitcast<f32>(1325400063u))), (_e345 == _e345)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e385 = phi_731_;
    let _e387 = (_e154 - vec4<f32>(1f, 1f, 1f, 1f).x);
    let _e389 = (_e231 - vec4<f32>(1f, 1f, 1f, 1f).y);
    let _e391 = (_e308 - vec4<f32>(1f, 1f, 1f, 1f).z);
    let _e393 = (_e385 - vec4<f32>(1f, 1f, 1f, 1f).w);
    let _e395 = (*param_4).min_variance;
    let _e397 = ((_e395 * _e69) * _e69);
    let _e408 = ((((_e387 * param_6.x) + (_e389 * param_6.y)) + (_e391 * param_6.z)) + (_e393 * param_6.w));
    let _e409 = (_e387 - _e408);
    let _e410 = (_e389 - _e408);
    let _e411 = (_e391 - _e408);
    let _e412 = (_e393 - _e408);
    let _e427 = (((((_e409 * _e409) * param_6.x) + ((_e410 * _e410) * param_6.y)) + ((_e411 * _e411) * param_6.z)) + ((_e412 * _e412) * param_6.w));
    if ((bitcast<u32>(_e397) & 2147483647u) > 2139095040u) {
        phi_784_ = true;
    } else {
        let _e431 = (_e397 > _e427);
        if _e431 {
        }
        phi_784_ = _e431;
    }
    let _e433 = phi_784_;
    if _e433 {
        phi_788_ = _e397;
    } else {
        phi_788_ = _e427;
    }
    let _e435 = phi_788_;
    let _e436 = -(_e408);
    if (_e436 <= 0f) {
        let _e440 = ((bitcast<u32>(_e435) & 2147483647u) > 2139095040u);
        if _e440 {
        }
        phi_800_ = _e440;
    } else {
        phi_800_ = true;
    }
    let _e442 = phi_800_;
    if _e442 {
        phi_807_ = (_e435 / (_e435 + (_e436 * _e436)));
    } else {
        phi_807_ = 1f;
    }
    let _e447 = phi_807_;
    let _e449 = (*param_4).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_820_ = true;
    } else {
        let _e453 = (42f < _e449);
        if _e453 {
        }
        phi_820_ = _e453;
    }
    let _e455 = phi_820_;
    if _e455 {
        phi_824_ = 42f;
    } else {
        phi_824_ = _e449;
    }
    let _e457 = phi_824_;
    let _e458 = -(_e457);
    let _e460 = (_e458 * param_5.x);
    let _e462 = (_e458 * param_5.y);
    let _e464 = (_e458 * param_5.z);
    let _e466 = (_e458 * param_5.w);
    if ((bitcast<u32>(_e460) & 2147483647u) > 2139095040u) {
        phi_921_ = _e460;
    } else {
        if (_e460 < -87f) {
            phi_844_ = -87f;
        } else {
            phi_844_ = _e460;
        }
        let _e472 = phi_844_;
        if (_e472 > 88f) {
            phi_849_ = 88f;
        } else {
            phi_849_ = _e472;
        }
        let _e475 = phi_849_;
        let _e477 = ((_e475 * 1.442695f) + 0.5f);
        if (_e477 > -8388608f) {
            let _e489 = f32(select(0i, select(select(i32(_e477), i32(-2147483648), (_e477 < bitcast<f32>(3472883712u))), 2147483647i, (_e477 > bitcast<f32>(1325400063u))), (_e477 == _e477)));
            if (_e489 > _e477) {
                phi_871_ = 1f;
            } else {
                phi_871_ = 0f;
            }
            let _e492 = phi_871_;
            if (_e477 < 8388608f) {
                phi_876_ = (_e489 - _e492);
                phi_877_ = false;
            } else {
                phi_876_ = f32();
                phi_877_ = true;
            }
            let _e495 = phi_876_;
            let _e497 = phi_877_;
            phi_878_ = _e495;
            phi_879_ = _e497;
        } else {
            phi_878_ = f32();
            phi_879_ = true;
        }
        let _e499 = phi_878_;
        let _e501 = phi_879_;
        if _e501 {
            phi_883_ = _e477;
        } else {
            phi_883_ = _e499;
        }
        let _e503 = phi_883_;
        let _e507 = ((_e475 - (_e503 * 0.69314575f)) - (_e503 * 0.0000014286068f));
        phi_921_ = ((((((((((((((((1f / 5040f) * _e507) + (1f / 720f)) * _e507) + (1f / 120f)) * _e507) + (1f / 24f)) * _e507) + (1f / 6f)) * _e507) + 0.5f) * _e507) + 1f) * _e507) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e503), i32(-2147483648), (_e503 < bitcast<f32>(3472883712u))), 2147483647i, (_e503 > bitcast<f32>(1325400063u))), (_e503 == _e503)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e543 = phi_921_;
    if ((bitcast<u32>(_e462) & 2147483647u) > 2139095040u) {
        phi_1009_ = _e462;
    } else {
        if (_e462 < -87f) {
            phi_932_ = -87f;
        } else {
            phi_932_ = _e462;
        }
        let _e549 = phi_932_;
        if (_e549 > 88f) {
            phi_937_ = 88f;
        } else {
            phi_937_ = _e549;
        }
        let _e552 = phi_937_;
        let _e554 = ((_e552 * 1.442695f) + 0.5f);
        if (_e554 > -8388608f) {
            let _e566 = f32(select(0i, select(select(i32(_e554), i32(-2147483648), (_e554 < bitcast<f32>(3472883712u))), 2147483647i, (_e554 > bitcast<f32>(1325400063u))), (_e554 == _e554)));
            if (_e566 > _e554) {
                phi_959_ = 1f;
            } else {
                phi_959_ = 0f;
            }
            let _e569 = phi_959_;
            if (_e554 < 8388608f) {
                phi_964_ = (_e566 - _e569);
                phi_965_ = false;
            } else {
                phi_964_ = f32();
                phi_965_ = true;
            }
            let _e572 = phi_964_;
            let _e574 = phi_965_;
            phi_966_ = _e572;
            phi_967_ = _e574;
        } else {
            phi_966_ = f32();
            phi_967_ = true;
        }
        let _e576 = phi_966_;
        let _e578 = phi_967_;
        if _e578 {
            phi_971_ = _e554;
        } else {
            phi_971_ = _e576;
        }
        let _e580 = phi_971_;
        let _e584 = ((_e552 - (_e580 * 0.69314575f)) - (_e580 * 0.0000014286068f));
        phi_1009_ = ((((((((((((((((1f / 5040f) * _e584) + (1f / 720f)) * _e584) + (1f / 120f)) * _e584) + (1f / 24f)) * _e584) + (1f / 6f)) * _e584) + 0.5f) * _e584) + 1f) * _e584) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e580), i32(-2147483648), (_e580 < bitcast<f32>(3472883712u))), 2147483647i, (_e580 > bitcast<f32>(1325400063u))), (_e580 == _e580)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e620 = phi_1009_;
    if ((bitcast<u32>(_e464) & 2147483647u) > 2139095040u) {
        phi_1097_ = _e464;
    } else {
        if (_e464 < -87f) {
            phi_1020_ = -87f;
        } else {
            phi_1020_ = _e464;
        }
        let _e626 = phi_1020_;
        if (_e626 > 88f) {
            phi_1025_ = 88f;
        } else {
            phi_1025_ = _e626;
        }
        let _e629 = phi_1025_;
        let _e631 = ((_e629 * 1.442695f) + 0.5f);
        if (_e631 > -8388608f) {
            let _e643 = f32(select(0i, select(select(i32(_e631), i32(-2147483648), (_e631 < bitcast<f32>(3472883712u))), 2147483647i, (_e631 > bitcast<f32>(1325400063u))), (_e631 == _e631)));
            if (_e643 > _e631) {
                phi_1047_ = 1f;
            } else {
                phi_1047_ = 0f;
            }
            let _e646 = phi_1047_;
            if (_e631 < 8388608f) {
                phi_1052_ = (_e643 - _e646);
                phi_1053_ = false;
            } else {
                phi_1052_ = f32();
                phi_1053_ = true;
            }
            let _e649 = phi_1052_;
            let _e651 = phi_1053_;
            phi_1054_ = _e649;
            phi_1055_ = _e651;
        } else {
            phi_1054_ = f32();
            phi_1055_ = true;
        }
        let _e653 = phi_1054_;
        let _e655 = phi_1055_;
        if _e655 {
            phi_1059_ = _e631;
        } else {
            phi_1059_ = _e653;
        }
        let _e657 = phi_1059_;
        let _e661 = ((_e629 - (_e657 * 0.69314575f)) - (_e657 * 0.0000014286068f));
        phi_1097_ = ((((((((((((((((1f / 5040f) * _e661) + (1f / 720f)) * _e661) + (1f / 120f)) * _e661) + (1f / 24f)) * _e661) + (1f / 6f)) * _e661) + 0.5f) * _e661) + 1f) * _e661) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e657), i32(-2147483648), (_e657 < bitcast<f32>(3472883712u))), 2147483647i, (_e657 > bitcast<f32>(1325400063u))), (_e657 == _e657)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e697 = phi_1097_;
    if ((bitcast<u32>(_e466) & 2147483647u) > 2139095040u) {
        phi_1185_ = _e466;
    } else {
        if (_e466 < -87f) {
            phi_1108_ = -87f;
        } else {
            phi_1108_ = _e466;
        }
        let _e703 = phi_1108_;
        if (_e703 > 88f) {
            phi_1113_ = 88f;
        } else {
            phi_1113_ = _e703;
        }
        let _e706 = phi_1113_;
        let _e708 = ((_e706 * 1.442695f) + 0.5f);
        if (_e708 > -8388608f) {
            let _e720 = f32(select(0i, select(select(i32(_e708), i32(-2147483648), (_e708 < bitcast<f32>(3472883712u))), 2147483647i, (_e708 > bitcast<f32>(1325400063u))), (_e708 == _e708)));
            if (_e720 > _e708) {
                phi_1135_ = 1f;
            } else {
                phi_1135_ = 0f;
            }
            let _e723 = phi_1135_;
            if (_e708 < 8388608f) {
                phi_1140_ = (_e720 - _e723);
                phi_1141_ = false;
            } else {
                phi_1140_ = f32();
                phi_1141_ = true;
            }
            let _e726 = phi_1140_;
            let _e728 = phi_1141_;
            phi_1142_ = _e726;
            phi_1143_ = _e728;
        } else {
            phi_1142_ = f32();
            phi_1143_ = true;
        }
        let _e730 = phi_1142_;
        let _e732 = phi_1143_;
        if _e732 {
            phi_1147_ = _e708;
        } else {
            phi_1147_ = _e730;
        }
        let _e734 = phi_1147_;
        let _e738 = ((_e706 - (_e734 * 0.69314575f)) - (_e734 * 0.0000014286068f));
        phi_1185_ = ((((((((((((((((1f / 5040f) * _e738) + (1f / 720f)) * _e738) + (1f / 120f)) * _e738) + (1f / 24f)) * _e738) + (1f / 6f)) * _e738) + 0.5f) * _e738) + 1f) * _e738) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e734), i32(-2147483648), (_e734 < bitcast<f32>(3472883712u))), 2147483647i, (_e734 > bitcast<f32>(1325400063u))), (_e734 == _e734)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e774 = phi_1185_;
    let _e776 = (vec4<f32>(1f, 1f, 1f, 1f).x - _e543);
    let _e778 = (vec4<f32>(1f, 1f, 1f, 1f).y - _e620);
    let _e780 = (vec4<f32>(1f, 1f, 1f, 1f).z - _e697);
    let _e782 = (vec4<f32>(1f, 1f, 1f, 1f).w - _e774);
    let _e784 = (*param_4).min_variance;
    let _e786 = ((_e784 * _e457) * _e457);
    let _e797 = ((((_e776 * param_6.x) + (_e778 * param_6.y)) + (_e780 * param_6.z)) + (_e782 * param_6.w));
    let _e798 = (_e776 - _e797);
    let _e799 = (_e778 - _e797);
    let _e800 = (_e780 - _e797);
    let _e801 = (_e782 - _e797);
    let _e816 = (((((_e798 * _e798) * param_6.x) + ((_e799 * _e799) * param_6.y)) + ((_e800 * _e800) * param_6.z)) + ((_e801 * _e801) * param_6.w));
    if ((bitcast<u32>(_e786) & 2147483647u) > 2139095040u) {
        phi_1238_ = true;
    } else {
        let _e820 = (_e786 > _e816);
        if _e820 {
        }
        phi_1238_ = _e820;
    }
    let _e822 = phi_1238_;
    if _e822 {
        phi_1242_ = _e786;
    } else {
        phi_1242_ = _e816;
    }
    let _e824 = phi_1242_;
    let _e825 = -(_e797);
    if (_e825 <= 0f) {
        let _e829 = ((bitcast<u32>(_e824) & 2147483647u) > 2139095040u);
        if _e829 {
        }
        phi_1254_ = _e829;
    } else {
        phi_1254_ = true;
    }
    let _e831 = phi_1254_;
    if _e831 {
        phi_1261_ = (_e824 / (_e824 + (_e825 * _e825)));
    } else {
        phi_1261_ = 1f;
    }
    let _e836 = phi_1261_;
    if ((bitcast<u32>(_e836) & 2147483647u) > 2139095040u) {
        phi_1272_ = true;
    } else {
        let _e840 = (_e836 < _e447);
        if _e840 {
        }
        phi_1272_ = _e840;
    }
    let _e842 = phi_1272_;
    if _e842 {
        phi_1276_ = _e836;
    } else {
        phi_1276_ = _e447;
    }
    let _e844 = phi_1276_;
    if ((bitcast<u32>(_e844) & 2147483647u) > 2139095040u) {
        phi_1293_ = _e844;
    } else {
        if (_e844 < 0f) {
            phi_1292_ = 0f;
        } else {
            if (_e844 > 1f) {
                phi_1291_ = 1f;
            } else {
                phi_1291_ = _e844;
            }
            let _e851 = phi_1291_;
            phi_1292_ = _e851;
        }
        let _e853 = phi_1292_;
        phi_1293_ = _e853;
    }
    let _e855 = phi_1293_;
    return _e855;
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_7: ptr<function, lt_math_Evsm>, param_8: vec4<f32>, param_9: vec4<f32>, param_10: f32) -> f32 {
    var phi_216_: f32;
    var phi_217_: f32;
    var phi_218_: f32;
    var phi_234_: f32;
    var phi_235_: f32;
    var phi_236_: f32;
    var phi_252_: f32;
    var phi_253_: f32;
    var phi_254_: f32;
    var phi_270_: f32;
    var phi_271_: f32;
    var phi_272_: f32;
    var phi_288_: f32;
    var phi_289_: f32;
    var phi_290_: f32;
    var phi_327_: bool;
    var phi_328_: bool;
    var phi_329_: bool;
    var phi_330_: bool;
    var phi_331_: bool;
    var phi_332_: bool;
    var phi_333_: bool;
    var phi_334_: bool;
    var phi_335_: bool;
    var phi_336_: bool;
    var phi_337_: bool;
    var phi_341_: bool;
    var phi_345_: bool;
    var phi_350_: f32;

    if ((bitcast<u32>(param_10) & 2147483647u) > 2139095040u) {
        phi_218_ = param_10;
    } else {
        if (param_10 < 0f) {
            phi_217_ = 0f;
        } else {
            if (param_10 > 1f) {
                phi_216_ = 1f;
            } else {
                phi_216_ = param_10;
            }
            let _e67 = phi_216_;
            phi_217_ = _e67;
        }
        let _e69 = phi_217_;
        phi_218_ = _e69;
    }
    let _e71 = phi_218_;
    if ((bitcast<u32>(param_8.x) & 2147483647u) > 2139095040u) {
        phi_236_ = param_8.x;
    } else {
        if (param_8.x < 0f) {
            phi_235_ = 0f;
        } else {
            if (param_8.x > 1f) {
                phi_234_ = 1f;
            } else {
                phi_234_ = param_8.x;
            }
            let _e79 = phi_234_;
            phi_235_ = _e79;
        }
        let _e81 = phi_235_;
        phi_236_ = _e81;
    }
    let _e83 = phi_236_;
    if ((bitcast<u32>(param_8.y) & 2147483647u) > 2139095040u) {
        phi_254_ = param_8.y;
    } else {
        if (param_8.y < 0f) {
            phi_253_ = 0f;
        } else {
            if (param_8.y > 1f) {
                phi_252_ = 1f;
            } else {
                phi_252_ = param_8.y;
            }
            let _e91 = phi_252_;
            phi_253_ = _e91;
        }
        let _e93 = phi_253_;
        phi_254_ = _e93;
    }
    let _e95 = phi_254_;
    if ((bitcast<u32>(param_8.z) & 2147483647u) > 2139095040u) {
        phi_272_ = param_8.z;
    } else {
        if (param_8.z < 0f) {
            phi_271_ = 0f;
        } else {
            if (param_8.z > 1f) {
                phi_270_ = 1f;
            } else {
                phi_270_ = param_8.z;
            }
            let _e103 = phi_270_;
            phi_271_ = _e103;
        }
        let _e105 = phi_271_;
        phi_272_ = _e105;
    }
    let _e107 = phi_272_;
    if ((bitcast<u32>(param_8.w) & 2147483647u) > 2139095040u) {
        phi_290_ = param_8.w;
    } else {
        if (param_8.w < 0f) {
            phi_289_ = 0f;
        } else {
            if (param_8.w > 1f) {
                phi_288_ = 1f;
            } else {
                phi_288_ = param_8.w;
            }
            let _e115 = phi_288_;
            phi_289_ = _e115;
        }
        let _e117 = phi_289_;
        phi_290_ = _e117;
    }
    let _e119 = phi_290_;
    let _e120 = (_e83 - _e71);
    let _e121 = (_e95 - _e71);
    let _e122 = (_e107 - _e71);
    let _e123 = (_e119 - _e71);
    if (_e120 >= 0f) {
        if (_e121 >= 0f) {
            if (_e122 >= 0f) {
                if (_e123 >= 0f) {
                    phi_327_ = !(((bitcast<u32>(((((_e120 * param_9.x) + (_e121 * param_9.y)) + (_e122 * param_9.z)) + (_e123 * param_9.w))) & 2147483647u) > 2139095040u));
                    phi_328_ = false;
                } else {
                    phi_327_ = bool();
                    phi_328_ = true;
                }
                let _e145 = phi_327_;
                let _e147 = phi_328_;
                phi_329_ = _e145;
                phi_330_ = false;
                phi_331_ = _e147;
            } else {
                phi_329_ = bool();
                phi_330_ = true;
                phi_331_ = false;
            }
            let _e149 = phi_329_;
            let _e151 = phi_330_;
            let _e153 = phi_331_;
            phi_332_ = _e149;
            phi_333_ = _e151;
            phi_334_ = _e153;
        } else {
            phi_332_ = bool();
            phi_333_ = true;
            phi_334_ = false;
        }
        let _e155 = phi_332_;
        let _e157 = phi_333_;
        let _e159 = phi_334_;
        phi_335_ = _e155;
        phi_336_ = _e157;
        phi_337_ = _e159;
    } else {
        phi_335_ = bool();
        phi_336_ = true;
        phi_337_ = false;
    }
    let _e161 = phi_335_;
    let _e163 = phi_336_;
    let _e165 = phi_337_;
    if _e163 {
        phi_341_ = true;
    } else {
        phi_341_ = _e165;
    }
    let _e167 = phi_341_;
    if _e167 {
        phi_345_ = false;
    } else {
        phi_345_ = _e161;
    }
    let _e169 = phi_345_;
    if _e169 {
        phi_350_ = 1f;
    } else {
        let _e170 = _lt_math_evsm_Evsm_bound_of_offsets(param_7, vec4<f32>(_e120, _e121, _e122, _e123), param_9);
        phi_350_ = _e170;
    }
    let _e172 = phi_350_;
    return _e172;
}

fn function_() {
    var local_1: lt_math_Evsm;
    var phi_1348_: bool;
    var phi_1349_: bool;
    var phi_1350_: bool;
    var phi_1351_: bool;
    var phi_1355_: bool;
    var phi_1425_: bool;
    var phi_1426_: bool;
    var phi_1437_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1438_: bool;
    var phi_1439_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1440_: bool;
    var phi_1447_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1451_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1471_: lt_math_LightPoint;
    var phi_1474_: u32;
    var phi_1476_: lt_math_LevelPoint;
    var phi_1562_: bool;
    var phi_1571_: bool;
    var phi_1580_: bool;
    var phi_1581_: bool;
    var phi_1582_: bool;
    var phi_1583_: bool;
    var phi_1584_: bool;
    var phi_1585_: bool;
    var phi_1586_: bool;
    var phi_1590_: bool;
    var phi_1617_: bool;
    var phi_1618_: bool;
    var phi_1619_: bool;
    var phi_1620_: bool;
    var phi_1621_: bool;
    var phi_1622_: bool;
    var phi_1623_: bool;
    var phi_1624_: bool;
    var phi_1628_: bool;
    var phi_1637_: lt_math_LightPoint;
    var phi_1638_: u32;
    var phi_1639_: lt_math_LevelPoint;
    var phi_1640_: bool;
    var phi_1472_: lt_math_LightPoint;
    var phi_1475_: u32;
    var phi_1477_: lt_math_LevelPoint;
    var phi_1641_: bool;
    var local_2: lt_math_LevelPoint;
    var local_3: lt_math_LevelPoint;
    var phi_1681_: bool;
    var phi_1682_: bool;
    var phi_1683_: bool;
    var phi_1684_: bool;
    var phi_1688_: bool;
    var phi_1770_: f32;
    var phi_1888_: f32;
    var phi_1889_: f32;
    var phi_1892_: f32;
    var phi_1921_: f32;
    var phi_1926_: f32;
    var phi_1927_: bool;
    var phi_1928_: f32;
    var phi_1929_: bool;
    var phi_1933_: f32;
    var phi_1953_: f32;
    var phi_1958_: f32;
    var phi_1959_: bool;
    var phi_1960_: f32;
    var phi_1961_: bool;
    var phi_1965_: f32;
    var local_4: lt_math_LevelPoint;
    var phi_2018_: i32;
    var phi_2023_: i32;
    var phi_2028_: i32;
    var phi_2033_: i32;
    var phi_2042_: i32;
    var phi_2047_: i32;
    var phi_2052_: i32;
    var phi_2057_: i32;
    var phi_2108_: bool;
    var phi_2116_: bool;
    var phi_2128_: bool;
    var phi_2129_: bool;
    var phi_2133_: f32;
    var phi_2139_: f32;
    var phi_2141_: evaluate_Verdict;
    var phi_2146_: evaluate_Verdict;
    var phi_2147_: evaluate_Verdict;
    var phi_2151_: bool;
    var phi_2152_: u32;
    var phi_2163_: u32;

    let _e58 = id_1;
    let _e59 = local_5;
    let _e64 = arrayLength((&map.member));
    let _e69 = arrayLength((&levels.member));
    let _e72 = p.member.size[0u];
    let _e74 = p.member.size[1u];
    let _e75 = lt_shaders_entry_pixel_index(_e58, _e72, _e74);
    if (bitcast<i32>(_e75.root) != 0i) {
        let _e82 = p.member.level_count;
        let _e86 = samples.member[_e75.first_primitive].normal[0u];
        let _e88 = global[0u];
        if (_e86 == _e88) {
            let _e91 = samples.member[_e75.first_primitive].normal[1u];
            let _e93 = global[1u];
            if (_e91 == _e93) {
                let _e96 = samples.member[_e75.first_primitive].normal[2u];
                let _e98 = global[2u];
                phi_1348_ = (_e96 == _e98);
                phi_1349_ = false;
            } else {
                phi_1348_ = bool();
                phi_1349_ = true;
            }
            let _e101 = phi_1348_;
            let _e103 = phi_1349_;
            phi_1350_ = _e101;
            phi_1351_ = _e103;
        } else {
            phi_1350_ = bool();
            phi_1351_ = true;
        }
        let _e105 = phi_1350_;
        let _e107 = phi_1351_;
        if _e107 {
            phi_1355_ = false;
        } else {
            phi_1355_ = _e105;
        }
        let _e109 = phi_1355_;
        if !(_e109) {
            let _e112 = samples.member[_e75.first_primitive].position;
            let _e114 = p.member.light.place;
            let _e120 = p.member.light.place[3u];
            let _e127 = (_e114.x - (_e112.x * _e120));
            let _e128 = (_e114.y - (_e112.y * _e120));
            let _e129 = (_e114.z - (_e112.z * _e120));
            let _e131 = samples.member[_e75.first_primitive].normal;
            if ((((_e131.x * _e127) + (_e131.y * _e128)) + (_e131.z * _e129)) > 0f) {
                let _e145 = (((_e127 * _e127) + (_e128 * _e128)) + (_e129 * _e129));
                let _e147 = p.member.light.axis;
                let _e159 = p.member.light.place[3u];
                if (_e159 == 0f) {
                    phi_1426_ = true;
                } else {
                    let _e162 = p.member.light.range_squared;
                    if (_e145 <= _e162) {
                        let _e165 = p.member.light.cos_outer;
                        phi_1425_ = (-((((_e127 * _e147.x) + (_e128 * _e147.y)) + (_e129 * _e147.z))) >= (_e165 * sqrt(_e145)));
                    } else {
                        phi_1425_ = false;
                    }
                    let _e170 = phi_1425_;
                    phi_1426_ = _e170;
                }
                let _e172 = phi_1426_;
                if _e172 {
                    let _e174 = samples.member[_e75.first_primitive].flags;
                    let _e182 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e188 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e182.unnamed.visibility, false), _e182.unnamed_1);
                    phi_1437_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e188.unnamed, ((_e174 & 1u) == 0u));
                    phi_1438_ = false;
                } else {
                    phi_1437_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_1438_ = true;
                }
                let _e193 = phi_1437_;
                let _e195 = phi_1438_;
                phi_1439_ = _e193;
                phi_1440_ = _e195;
            } else {
                phi_1439_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_1440_ = true;
            }
            let _e197 = phi_1439_;
            let _e199 = phi_1440_;
            if _e199 {
                let _e205 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e211 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e205.unnamed.visibility, false), _e205.unnamed_1);
                phi_1447_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e211.unnamed, true);
            } else {
                phi_1447_ = _e197;
            }
            let _e216 = phi_1447_;
            phi_1451_ = _e216;
        } else {
            let _e222 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e228 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e222.unnamed.visibility, false), _e222.unnamed_1);
            phi_1451_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e228.unnamed, true);
        }
        let _e233 = phi_1451_;
        if _e233.unnamed_1 {
            phi_2147_ = evaluate_Verdict(_e233.unnamed.visibility, _e233.unnamed.is_doubted);
        } else {
            let _e241 = samples.member[_e75.first_primitive].position;
            let _e243 = p.member.map_size;
            let _e245 = (0.5f / f32(_e243));
            let _e252 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e259 = lt_math_LightPoint(vec2<f32>(_e252.uv.x, 0f), _e252.depth, _e252.is_inside);
            let _e263 = lt_math_LightPoint(_e259.uv, 0f, _e259.is_inside);
            phi_1471_ = lt_math_LightPoint();
            phi_1474_ = 0u;
            phi_1476_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e263.uv, _e263.depth, false));
            loop {
                let _e270 = phi_1471_;
                let _e272 = phi_1474_;
                let _e274 = phi_1476_;
                local_2 = _e274;
                local_3 = _e274;
                local_4 = _e274;
                if (_e272 < _e82) {
                    if _e274.point.is_inside {
                        phi_1637_ = lt_math_LightPoint();
                        phi_1638_ = u32();
                        phi_1639_ = lt_math_LevelPoint();
                        phi_1640_ = false;
                    } else {
                        if (_e272 < _e69) {
                        } else {
                            return;
                        }
                        let _e285 = levels.member[(0u + _e272)].row_w;
                        let _e296 = ((((_e285.x * _e241.x) + (_e285.y * _e241.y)) + (_e285.z * _e241.z)) + (_e285.w * 1f));
                        let _e298 = levels.member[(0u + _e272)].row_x;
                        let _e310 = (((((_e298.x * _e241.x) + (_e298.y * _e241.y)) + (_e298.z * _e241.z)) + (_e298.w * 1f)) / _e296);
                        let _e312 = levels.member[(0u + _e272)].row_y;
                        let _e324 = (((((_e312.x * _e241.x) + (_e312.y * _e241.y)) + (_e312.z * _e241.z)) + (_e312.w * 1f)) / _e296);
                        let _e326 = levels.member[(0u + _e272)].row_z;
                        let _e337 = ((((_e326.x * _e241.x) + (_e326.y * _e241.y)) + (_e326.z * _e241.z)) + (_e326.w * 1f));
                        if (_e296 > 0f) {
                            if (_e310 >= 0f) {
                                phi_1562_ = (_e310 <= 1f);
                            } else {
                                phi_1562_ = false;
                            }
                            let _e342 = phi_1562_;
                            if _e342 {
                                if (_e324 >= 0f) {
                                    phi_1571_ = (_e324 <= 1f);
                                } else {
                                    phi_1571_ = false;
                                }
                                let _e346 = phi_1571_;
                                if _e346 {
                                    if (_e337 >= 0f) {
                                        phi_1580_ = (_e337 <= 1f);
                                    } else {
                                        phi_1580_ = false;
                                    }
                                    let _e350 = phi_1580_;
                                    phi_1581_ = _e350;
                                    phi_1582_ = false;
                                } else {
                                    phi_1581_ = bool();
                                    phi_1582_ = true;
                                }
                                let _e352 = phi_1581_;
                                let _e354 = phi_1582_;
                                phi_1583_ = _e352;
                                phi_1584_ = _e354;
                            } else {
                                phi_1583_ = bool();
                                phi_1584_ = true;
                            }
                            let _e356 = phi_1583_;
                            let _e358 = phi_1584_;
                            phi_1585_ = _e356;
                            phi_1586_ = _e358;
                        } else {
                            phi_1585_ = bool();
                            phi_1586_ = true;
                        }
                        let _e360 = phi_1585_;
                        let _e362 = phi_1586_;
                        if _e362 {
                            phi_1590_ = false;
                        } else {
                            phi_1590_ = _e360;
                        }
                        let _e364 = phi_1590_;
                        if _e364 {
                            if (_e310 >= _e245) {
                                if (_e310 <= (1f - _e245)) {
                                    if (_e324 >= _e245) {
                                        phi_1617_ = (_e324 <= (1f - _e245));
                                        phi_1618_ = false;
                                    } else {
                                        phi_1617_ = bool();
                                        phi_1618_ = true;
                                    }
                                    let _e372 = phi_1617_;
                                    let _e374 = phi_1618_;
                                    phi_1619_ = _e372;
                                    phi_1620_ = _e374;
                                } else {
                                    phi_1619_ = bool();
                                    phi_1620_ = true;
                                }
                                let _e376 = phi_1619_;
                                let _e378 = phi_1620_;
                                phi_1621_ = _e376;
                                phi_1622_ = _e378;
                            } else {
                                phi_1621_ = bool();
                                phi_1622_ = true;
                            }
                            let _e380 = phi_1621_;
                            let _e382 = phi_1622_;
                            phi_1623_ = _e380;
                            phi_1624_ = _e382;
                        } else {
                            phi_1623_ = bool();
                            phi_1624_ = true;
                        }
                        let _e384 = phi_1623_;
                        let _e386 = phi_1624_;
                        if _e386 {
                            phi_1628_ = false;
                        } else {
                            phi_1628_ = _e384;
                        }
                        let _e388 = phi_1628_;
                        let _e395 = lt_math_LightPoint(vec2<f32>(_e310, _e270.uv.y), _e270.depth, _e270.is_inside);
                        let _e402 = lt_math_LightPoint(vec2<f32>(_e395.uv.x, _e324), _e395.depth, _e395.is_inside);
                        let _e406 = lt_math_LightPoint(_e402.uv, _e337, _e402.is_inside);
                        let _e410 = lt_math_LightPoint(_e406.uv, _e406.depth, _e388);
                        phi_1637_ = _e410;
                        phi_1638_ = (_e272 + 1u);
                        phi_1639_ = lt_math_LevelPoint(_e272, _e410);
                        phi_1640_ = true;
                    }
                    let _e414 = phi_1637_;
                    let _e416 = phi_1638_;
                    let _e418 = phi_1639_;
                    let _e420 = phi_1640_;
                    phi_1472_ = _e414;
                    phi_1475_ = _e416;
                    phi_1477_ = _e418;
                    phi_1641_ = _e420;
                } else {
                    phi_1472_ = lt_math_LightPoint();
                    phi_1475_ = u32();
                    phi_1477_ = lt_math_LevelPoint();
                    phi_1641_ = false;
                }
                let _e422 = phi_1472_;
                let _e424 = phi_1475_;
                let _e426 = phi_1477_;
                let _e428 = phi_1641_;
                continue;
                continuing {
                    phi_1471_ = _e422;
                    phi_1474_ = _e424;
                    phi_1476_ = _e426;
                    break if !(_e428);
                }
            }
            let _e431 = local_2;
            if _e431.point.is_inside {
                if (0f > 0f) {
                    let _e437 = local_3;
                    if (_e437.level < _e69) {
                    } else {
                        return;
                    }
                    let _e442 = levels.member[(0u + _e437.level)];
                    let _e448 = global[0u];
                    if (_e442.row_w.x == _e448) {
                        let _e451 = global[1u];
                        if (_e442.row_w.y == _e451) {
                            let _e454 = global[2u];
                            phi_1681_ = (_e442.row_w.z == _e454);
                            phi_1682_ = false;
                        } else {
                            phi_1681_ = bool();
                            phi_1682_ = true;
                        }
                        let _e457 = phi_1681_;
                        let _e459 = phi_1682_;
                        phi_1683_ = _e457;
                        phi_1684_ = _e459;
                    } else {
                        phi_1683_ = bool();
                        phi_1684_ = true;
                    }
                    let _e461 = phi_1683_;
                    let _e463 = phi_1684_;
                    if _e463 {
                        phi_1688_ = false;
                    } else {
                        phi_1688_ = _e461;
                    }
                    let _e465 = phi_1688_;
                    if _e465 {
                        let _e467 = samples.member[_e75.first_primitive].normal;
                        let _e469 = p.member.map_size;
                        let _e539 = ((abs(((((_e442.row_x.x * _e467.x) + (_e442.row_x.y * _e467.y)) + (_e442.row_x.z * _e467.z)) / (((_e442.row_x.x * _e442.row_x.x) + (_e442.row_x.y * _e442.row_x.y)) + (_e442.row_x.z * _e442.row_x.z)))) + abs(((((_e442.row_y.x * _e467.x) + (_e442.row_y.y * _e467.y)) + (_e442.row_y.z * _e467.z)) / (((_e442.row_y.x * _e442.row_y.x) + (_e442.row_y.y * _e442.row_y.y)) + (_e442.row_y.z * _e442.row_y.z))))) / (abs(((((_e442.row_z.x * _e467.x) + (_e442.row_z.y * _e467.y)) + (_e442.row_z.z * _e467.z)) / (((_e442.row_z.x * _e442.row_z.x) + (_e442.row_z.y * _e442.row_z.y)) + (_e442.row_z.z * _e442.row_z.z)))) * f32(_e469)));
                        if (_e539 < 0.002f) {
                            phi_1770_ = _e539;
                        } else {
                            phi_1770_ = 0.002f;
                        }
                        let _e542 = phi_1770_;
                        phi_1889_ = _e542;
                    } else {
                        let _e544 = p.member.map_size;
                        let _e550 = samples.member[_e75.first_primitive].position;
                        let _e561 = ((((_e442.row_w.x * _e550.x) + (_e442.row_w.y * _e550.y)) + (_e442.row_w.z * _e550.z)) + _e442.row_w.w);
                        let _e574 = ((_e442.row_x.x - (_e442.row_w.x * _e431.point.uv.x)) / _e561);
                        let _e575 = ((_e442.row_x.y - (_e442.row_w.y * _e431.point.uv.x)) / _e561);
                        let _e576 = ((_e442.row_x.z - (_e442.row_w.z * _e431.point.uv.x)) / _e561);
                        let _e589 = ((_e442.row_y.x - (_e442.row_w.x * _e431.point.uv.y)) / _e561);
                        let _e590 = ((_e442.row_y.y - (_e442.row_w.y * _e431.point.uv.y)) / _e561);
                        let _e591 = ((_e442.row_y.z - (_e442.row_w.z * _e431.point.uv.y)) / _e561);
                        let _e597 = samples.member[_e75.first_primitive].normal;
                        let _e602 = ((_e590 * _e597.z) - (_e597.y * _e591));
                        let _e607 = ((_e591 * _e597.x) - (_e597.z * _e589));
                        let _e612 = ((_e589 * _e597.y) - (_e597.x * _e590));
                        let _e614 = samples.member[_e75.first_primitive].normal;
                        let _e619 = ((_e575 * _e614.z) - (_e614.y * _e576));
                        let _e624 = ((_e576 * _e614.x) - (_e614.z * _e574));
                        let _e629 = ((_e574 * _e614.y) - (_e614.x * _e575));
                        let _e656 = ((abs(((((_e442.row_z.x * _e602) + (_e442.row_z.y * _e607)) + (_e442.row_z.z * _e612)) / (((_e574 * _e602) + (_e575 * _e607)) + (_e576 * _e612)))) + abs(((((_e442.row_z.x * _e619) + (_e442.row_z.y * _e624)) + (_e442.row_z.z * _e629)) / (((_e589 * _e619) + (_e590 * _e624)) + (_e591 * _e629))))) / f32(_e544));
                        let _e658 = (16f / f32(_e544));
                        if (_e656 < _e658) {
                            phi_1888_ = _e656;
                        } else {
                            phi_1888_ = _e658;
                        }
                        let _e661 = phi_1888_;
                        phi_1889_ = _e661;
                    }
                    let _e663 = phi_1889_;
                    phi_1892_ = (_e431.point.depth - (0f * _e663));
                } else {
                    phi_1892_ = _e431.point.depth;
                }
                let _e667 = phi_1892_;
                let _e673 = p.member.map_size;
                let _e674 = f32(_e673);
                let _e677 = ((_e431.point.uv.x * _e674) - 0.5f);
                let _e678 = ((_e431.point.uv.y * _e674) - 0.5f);
                if (_e677 > -8388608f) {
                    let _e690 = f32(select(0i, select(select(i32(_e677), i32(-2147483648), (_e677 < bitcast<f32>(3472883712u))), 2147483647i, (_e677 > bitcast<f32>(1325400063u))), (_e677 == _e677)));
                    if (_e690 > _e677) {
                        phi_1921_ = 1f;
                    } else {
                        phi_1921_ = 0f;
                    }
                    let _e693 = phi_1921_;
                    if (_e677 < 8388608f) {
                        phi_1926_ = (_e690 - _e693);
                        phi_1927_ = false;
                    } else {
                        phi_1926_ = f32();
                        phi_1927_ = true;
                    }
                    let _e696 = phi_1926_;
                    let _e698 = phi_1927_;
                    phi_1928_ = _e696;
                    phi_1929_ = _e698;
                } else {
                    phi_1928_ = f32();
                    phi_1929_ = true;
                }
                let _e700 = phi_1928_;
                let _e702 = phi_1929_;
                if _e702 {
                    phi_1933_ = _e677;
                } else {
                    phi_1933_ = _e700;
                }
                let _e704 = phi_1933_;
                if (_e678 > -8388608f) {
                    let _e716 = f32(select(0i, select(select(i32(_e678), i32(-2147483648), (_e678 < bitcast<f32>(3472883712u))), 2147483647i, (_e678 > bitcast<f32>(1325400063u))), (_e678 == _e678)));
                    if (_e716 > _e678) {
                        phi_1953_ = 1f;
                    } else {
                        phi_1953_ = 0f;
                    }
                    let _e719 = phi_1953_;
                    if (_e678 < 8388608f) {
                        phi_1958_ = (_e716 - _e719);
                        phi_1959_ = false;
                    } else {
                        phi_1958_ = f32();
                        phi_1959_ = true;
                    }
                    let _e722 = phi_1958_;
                    let _e724 = phi_1959_;
                    phi_1960_ = _e722;
                    phi_1961_ = _e724;
                } else {
                    phi_1960_ = f32();
                    phi_1961_ = true;
                }
                let _e726 = phi_1960_;
                let _e728 = phi_1961_;
                if _e728 {
                    phi_1965_ = _e678;
                } else {
                    phi_1965_ = _e726;
                }
                let _e730 = phi_1965_;
                let _e731 = (_e677 - _e704);
                let _e732 = (_e678 - _e730);
                let _e741 = select(0i, select(select(i32(_e704), i32(-2147483648), (_e704 < bitcast<f32>(3472883712u))), 2147483647i, (_e704 > bitcast<f32>(1325400063u))), (_e704 == _e704));
                let _e750 = select(0i, select(select(i32(_e730), i32(-2147483648), (_e730 < bitcast<f32>(3472883712u))), 2147483647i, (_e730 > bitcast<f32>(1325400063u))), (_e730 == _e730));
                let _e761 = p.member.test;
                let _e762 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e761);
                let _e764 = p.member.map_size;
                let _e766 = local_4;
                local_1 = lt_math_Evsm(_e762.positive_exponent, _e762.negative_exponent, _e762.min_variance);
                let _e773 = ((_e766.level * _e764) * _e764);
                let _e775 = (bitcast<i32>(_e764) - 1i);
                if (_e741 > 0i) {
                    phi_2018_ = _e741;
                } else {
                    phi_2018_ = 0i;
                }
                let _e778 = phi_2018_;
                if (_e750 > 0i) {
                    phi_2023_ = _e750;
                } else {
                    phi_2023_ = 0i;
                }
                let _e781 = phi_2023_;
                if (_e778 < _e775) {
                    phi_2028_ = _e778;
                } else {
                    phi_2028_ = _e775;
                }
                let _e784 = phi_2028_;
                if (_e781 < _e775) {
                    phi_2033_ = _e781;
                } else {
                    phi_2033_ = _e775;
                }
                let _e787 = phi_2033_;
                let _e788 = bitcast<u32>(_e784);
                let _e790 = (_e741 + 1i);
                let _e791 = (_e750 + 1i);
                if (_e790 > 0i) {
                    phi_2042_ = _e790;
                } else {
                    phi_2042_ = 0i;
                }
                let _e794 = phi_2042_;
                if (_e791 > 0i) {
                    phi_2047_ = _e791;
                } else {
                    phi_2047_ = 0i;
                }
                let _e797 = phi_2047_;
                if (_e794 < _e775) {
                    phi_2052_ = _e794;
                } else {
                    phi_2052_ = _e775;
                }
                let _e800 = phi_2052_;
                if (_e797 < _e775) {
                    phi_2057_ = _e797;
                } else {
                    phi_2057_ = _e775;
                }
                let _e803 = phi_2057_;
                let _e804 = bitcast<u32>(_e800);
                let _e806 = (bitcast<u32>(_e787) * _e764);
                let _e807 = (bitcast<u32>(_e803) * _e764);
                let _e812 = ((_e806 + _e788) + _e773);
                let _e813 = ((_e806 + _e804) + _e773);
                let _e814 = ((_e807 + _e788) + _e773);
                let _e815 = ((_e807 + _e804) + _e773);
                if (_e812 < _e64) {
                } else {
                    return;
                }
                let _e819 = map.member[(0u + _e812)];
                if (_e813 < _e64) {
                } else {
                    return;
                }
                let _e823 = map.member[(0u + _e813)];
                if (_e814 < _e64) {
                } else {
                    return;
                }
                let _e827 = map.member[(0u + _e814)];
                if (_e815 < _e64) {
                } else {
                    return;
                }
                let _e831 = map.member[(0u + _e815)];
                let _e833 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local_1), vec4<f32>(_e819, _e823, _e827, _e831), vec4<f32>(((1f - _e731) * (1f - _e732)), (_e731 * (1f - _e732)), ((1f - _e731) * _e732), (_e731 * _e732)), _e667);
                let _e835 = p.member.epsilon;
                if (_e833 <= _e835) {
                    phi_2108_ = true;
                } else {
                    phi_2108_ = (_e833 >= (1f - _e835));
                }
                let _e840 = phi_2108_;
                if ((bitcast<u32>(_e833) & 2147483647u) > 2139095040u) {
                    phi_2116_ = true;
                } else {
                    phi_2116_ = !(_e840);
                }
                let _e846 = phi_2116_;
                if _e846 {
                    if (_e833 > 0f) {
                        if (_e833 < 1f) {
                            phi_2128_ = false;
                        } else {
                            phi_2128_ = true;
                        }
                        let _e850 = phi_2128_;
                        phi_2129_ = _e850;
                    } else {
                        phi_2129_ = true;
                    }
                    let _e852 = phi_2129_;
                    if _e852 {
                        phi_2133_ = 0.5f;
                    } else {
                        phi_2133_ = _e833;
                    }
                    let _e854 = phi_2133_;
                    phi_2141_ = evaluate_Verdict(_e854, true);
                } else {
                    if (_e833 > 0.5f) {
                        phi_2139_ = 1f;
                    } else {
                        phi_2139_ = 0f;
                    }
                    let _e858 = phi_2139_;
                    phi_2141_ = evaluate_Verdict(_e858, false);
                }
                let _e861 = phi_2141_;
                phi_2146_ = evaluate_Verdict(_e861.visibility, _e861.is_doubted);
            } else {
                phi_2146_ = evaluate_Verdict(0.5f, true);
            }
            let _e867 = phi_2146_;
            phi_2147_ = _e867;
        }
        let _e869 = phi_2147_;
        visibility.member[_e75.first_primitive] = _e869.visibility;
        phi_2151_ = _e869.is_doubted;
        phi_2152_ = _e75.first_primitive;
    } else {
        phi_2151_ = false;
        phi_2152_ = 0u;
    }
    let _e874 = phi_2151_;
    let _e876 = phi_2152_;
    if (_e59 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e874 {
        let _e880 = atomicAdd((&shared_[0u]), 1u);
        phi_2163_ = _e880;
    } else {
        phi_2163_ = 0u;
    }
    let _e882 = phi_2163_;
    workgroupBarrier();
    if (_e59 == 0u) {
        let _e886 = atomicLoad((&shared_[0u]));
        let _e887 = atomicAdd((&list.member[3u]), _e886);
        atomicStore((&shared_[1u]), _e887);
    }
    workgroupBarrier();
    if _e874 {
        let _e890 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e890) + _e882)]), _e876);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_evsm_levels_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_5 = local;
    function_();
}
