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
        let _e66 = phi_162_;
        let _e68 = phi_163_;
        phi_164_ = _e66;
        phi_165_ = _e68;
    } else {
        phi_164_ = lt_bvh_traverse_Tree();
        phi_165_ = true;
    }
    let _e70 = phi_164_;
    let _e72 = phi_165_;
    if _e72 {
        phi_170_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_170_ = _e70;
    }
    let _e77 = phi_170_;
    return lt_bvh_traverse_Tree(_e77.root, _e77.first_primitive);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> lt_math_Evsm {
    return lt_math_Evsm(param_3.x, param_3.y, param_3.z);
}

fn _lt_math_evsm_Evsm_bound_of_offsets(param_4: ptr<function, lt_math_Evsm>, param_5: vec4<f32>, param_6: vec4<f32>) -> f32 {
    var phi_350_: bool;
    var phi_354_: f32;
    var phi_373_: f32;
    var phi_378_: f32;
    var phi_400_: f32;
    var phi_405_: f32;
    var phi_406_: bool;
    var phi_407_: f32;
    var phi_408_: bool;
    var phi_412_: f32;
    var phi_450_: f32;
    var phi_461_: f32;
    var phi_466_: f32;
    var phi_488_: f32;
    var phi_493_: f32;
    var phi_494_: bool;
    var phi_495_: f32;
    var phi_496_: bool;
    var phi_500_: f32;
    var phi_538_: f32;
    var phi_549_: f32;
    var phi_554_: f32;
    var phi_576_: f32;
    var phi_581_: f32;
    var phi_582_: bool;
    var phi_583_: f32;
    var phi_584_: bool;
    var phi_588_: f32;
    var phi_626_: f32;
    var phi_637_: f32;
    var phi_642_: f32;
    var phi_664_: f32;
    var phi_669_: f32;
    var phi_670_: bool;
    var phi_671_: f32;
    var phi_672_: bool;
    var phi_676_: f32;
    var phi_714_: f32;
    var phi_767_: bool;
    var phi_771_: f32;
    var phi_783_: bool;
    var phi_790_: f32;
    var phi_803_: bool;
    var phi_807_: f32;
    var phi_827_: f32;
    var phi_832_: f32;
    var phi_854_: f32;
    var phi_859_: f32;
    var phi_860_: bool;
    var phi_861_: f32;
    var phi_862_: bool;
    var phi_866_: f32;
    var phi_904_: f32;
    var phi_915_: f32;
    var phi_920_: f32;
    var phi_942_: f32;
    var phi_947_: f32;
    var phi_948_: bool;
    var phi_949_: f32;
    var phi_950_: bool;
    var phi_954_: f32;
    var phi_992_: f32;
    var phi_1003_: f32;
    var phi_1008_: f32;
    var phi_1030_: f32;
    var phi_1035_: f32;
    var phi_1036_: bool;
    var phi_1037_: f32;
    var phi_1038_: bool;
    var phi_1042_: f32;
    var phi_1080_: f32;
    var phi_1091_: f32;
    var phi_1096_: f32;
    var phi_1118_: f32;
    var phi_1123_: f32;
    var phi_1124_: bool;
    var phi_1125_: f32;
    var phi_1126_: bool;
    var phi_1130_: f32;
    var phi_1168_: f32;
    var phi_1221_: bool;
    var phi_1225_: f32;
    var phi_1237_: bool;
    var phi_1244_: f32;
    var phi_1255_: bool;
    var phi_1259_: f32;
    var phi_1274_: f32;
    var phi_1275_: f32;
    var phi_1276_: f32;

    let _e57 = (*param_4).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_350_ = true;
    } else {
        let _e61 = (42f < _e57);
        if _e61 {
        }
        phi_350_ = _e61;
    }
    let _e63 = phi_350_;
    if _e63 {
        phi_354_ = 42f;
    } else {
        phi_354_ = _e57;
    }
    let _e65 = phi_354_;
    let _e67 = (_e65 * param_5.x);
    let _e69 = (_e65 * param_5.y);
    let _e71 = (_e65 * param_5.z);
    let _e73 = (_e65 * param_5.w);
    if ((bitcast<u32>(_e67) & 2147483647u) > 2139095040u) {
        phi_450_ = _e67;
    } else {
        if (_e67 < -87f) {
            phi_373_ = -87f;
        } else {
            phi_373_ = _e67;
        }
        let _e79 = phi_373_;
        if (_e79 > 88f) {
            phi_378_ = 88f;
        } else {
            phi_378_ = _e79;
        }
        let _e82 = phi_378_;
        let _e84 = ((_e82 * 1.442695f) + 0.5f);
        if (_e84 > -8388608f) {
            let _e96 = f32(select(0i, select(select(i32(_e84), i32(-2147483648), (_e84 < bitcast<f32>(3472883712u))), 2147483647i, (_e84 > bitcast<f32>(1325400063u))), (_e84 == _e84)));
            if (_e96 > _e84) {
                phi_400_ = 1f;
            } else {
                phi_400_ = 0f;
            }
            let _e99 = phi_400_;
            if (_e84 < 8388608f) {
                phi_405_ = (_e96 - _e99);
                phi_406_ = false;
            } else {
                phi_405_ = f32();
                phi_406_ = true;
            }
            let _e102 = phi_405_;
            let _e104 = phi_406_;
            phi_407_ = _e102;
            phi_408_ = _e104;
        } else {
            phi_407_ = f32();
            phi_408_ = true;
        }
        let _e106 = phi_407_;
        let _e108 = phi_408_;
        if _e108 {
            phi_412_ = _e84;
        } else {
            phi_412_ = _e106;
        }
        let _e110 = phi_412_;
        let _e114 = ((_e82 - (_e110 * 0.69314575f)) - (_e110 * 0.0000014286068f));
        phi_450_ = ((((((((((((((((1f / 5040f) * _e114) + (1f / 720f)) * _e114) + (1f / 120f)) * _e114) + (1f / 24f)) * _e114) + (1f / 6f)) * _e114) + 0.5f) * _e114) + 1f) * _e114) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e110), i32(-2147483648), (_e110 < bitcast<f32>(3472883712u))), 2147483647i, (_e110 > bitcast<f32>(1325400063u))), (_e110 == _e110)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e150 = phi_450_;
    if ((bitcast<u32>(_e69) & 2147483647u) > 2139095040u) {
        phi_538_ = _e69;
    } else {
        if (_e69 < -87f) {
            phi_461_ = -87f;
        } else {
            phi_461_ = _e69;
        }
        let _e156 = phi_461_;
        if (_e156 > 88f) {
            phi_466_ = 88f;
        } else {
            phi_466_ = _e156;
        }
        let _e159 = phi_466_;
        let _e161 = ((_e159 * 1.442695f) + 0.5f);
        if (_e161 > -8388608f) {
            let _e173 = f32(select(0i, select(select(i32(_e161), i32(-2147483648), (_e161 < bitcast<f32>(3472883712u))), 2147483647i, (_e161 > bitcast<f32>(1325400063u))), (_e161 == _e161)));
            if (_e173 > _e161) {
                phi_488_ = 1f;
            } else {
                phi_488_ = 0f;
            }
            let _e176 = phi_488_;
            if (_e161 < 8388608f) {
                phi_493_ = (_e173 - _e176);
                phi_494_ = false;
            } else {
                phi_493_ = f32();
                phi_494_ = true;
            }
            let _e179 = phi_493_;
            let _e181 = phi_494_;
            phi_495_ = _e179;
            phi_496_ = _e181;
        } else {
            phi_495_ = f32();
            phi_496_ = true;
        }
        let _e183 = phi_495_;
        let _e185 = phi_496_;
        if _e185 {
            phi_500_ = _e161;
        } else {
            phi_500_ = _e183;
        }
        let _e187 = phi_500_;
        let _e191 = ((_e159 - (_e187 * 0.69314575f)) - (_e187 * 0.0000014286068f));
        phi_538_ = ((((((((((((((((1f / 5040f) * _e191) + (1f / 720f)) * _e191) + (1f / 120f)) * _e191) + (1f / 24f)) * _e191) + (1f / 6f)) * _e191) + 0.5f) * _e191) + 1f) * _e191) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e187), i32(-2147483648), (_e187 < bitcast<f32>(3472883712u))), 2147483647i, (_e187 > bitcast<f32>(1325400063u))), (_e187 == _e187)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e227 = phi_538_;
    if ((bitcast<u32>(_e71) & 2147483647u) > 2139095040u) {
        phi_626_ = _e71;
    } else {
        if (_e71 < -87f) {
            phi_549_ = -87f;
        } else {
            phi_549_ = _e71;
        }
        let _e233 = phi_549_;
        if (_e233 > 88f) {
            phi_554_ = 88f;
        } else {
            phi_554_ = _e233;
        }
        let _e236 = phi_554_;
        let _e238 = ((_e236 * 1.442695f) + 0.5f);
        if (_e238 > -8388608f) {
            let _e250 = f32(select(0i, select(select(i32(_e238), i32(-2147483648), (_e238 < bitcast<f32>(3472883712u))), 2147483647i, (_e238 > bitcast<f32>(1325400063u))), (_e238 == _e238)));
            if (_e250 > _e238) {
                phi_576_ = 1f;
            } else {
                phi_576_ = 0f;
            }
            let _e253 = phi_576_;
            if (_e238 < 8388608f) {
                phi_581_ = (_e250 - _e253);
                phi_582_ = false;
            } else {
                phi_581_ = f32();
                phi_582_ = true;
            }
            let _e256 = phi_581_;
            let _e258 = phi_582_;
            phi_583_ = _e256;
            phi_584_ = _e258;
        } else {
            phi_583_ = f32();
            phi_584_ = true;
        }
        let _e260 = phi_583_;
        let _e262 = phi_584_;
        if _e262 {
            phi_588_ = _e238;
        } else {
            phi_588_ = _e260;
        }
        let _e264 = phi_588_;
        let _e268 = ((_e236 - (_e264 * 0.69314575f)) - (_e264 * 0.0000014286068f));
        phi_626_ = ((((((((((((((((1f / 5040f) * _e268) + (1f / 720f)) * _e268) + (1f / 120f)) * _e268) + (1f / 24f)) * _e268) + (1f / 6f)) * _e268) + 0.5f) * _e268) + 1f) * _e268) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e264), i32(-2147483648), (_e264 < bitcast<f32>(3472883712u))), 2147483647i, (_e264 > bitcast<f32>(1325400063u))), (_e264 == _e264)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e304 = phi_626_;
    if ((bitcast<u32>(_e73) & 2147483647u) > 2139095040u) {
        phi_714_ = _e73;
    } else {
        if (_e73 < -87f) {
            phi_637_ = -87f;
        } else {
            phi_637_ = _e73;
        }
        let _e310 = phi_637_;
        if (_e310 > 88f) {
            phi_642_ = 88f;
        } else {
            phi_642_ = _e310;
        }
        let _e313 = phi_642_;
        let _e315 = ((_e313 * 1.442695f) + 0.5f);
        if (_e315 > -8388608f) {
            let _e327 = f32(select(0i, select(select(i32(_e315), i32(-2147483648), (_e315 < bitcast<f32>(3472883712u))), 2147483647i, (_e315 > bitcast<f32>(1325400063u))), (_e315 == _e315)));
            if (_e327 > _e315) {
                phi_664_ = 1f;
            } else {
                phi_664_ = 0f;
            }
            let _e330 = phi_664_;
            if (_e315 < 8388608f) {
                phi_669_ = (_e327 - _e330);
                phi_670_ = false;
            } else {
                phi_669_ = f32();
                phi_670_ = true;
            }
            let _e333 = phi_669_;
            let _e335 = phi_670_;
            phi_671_ = _e333;
            phi_672_ = _e335;
        } else {
            phi_671_ = f32();
            phi_672_ = true;
        }
        let _e337 = phi_671_;
        let _e339 = phi_672_;
        if _e339 {
            phi_676_ = _e315;
        } else {
            phi_676_ = _e337;
        }
        let _e341 = phi_676_;
        let _e345 = ((_e313 - (_e341 * 0.69314575f)) - (_e341 * 0.0000014286068f));
        phi_714_ = ((((((((((((((((1f / 5040f) * _e345) + (1f / 720f)) * _e345) + (1f / 120f)) * _e345) + (1f / 24f)) * _e345) + (1f / 6f)) * _e345) + 0.5f) * _e345) + 1f) * _e345) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e341), i32(-2147483648), (_e341 < bitcast<f32>(3472883712u))), 2147483647i, (_e341 > bitcast<f32>(1325400063u))), (_e341 == _e341)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e381 = phi_714_;
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
        phi_767_ = true;
    } else {
        let _e427 = (_e393 > _e423);
        if _e427 {
        }
        phi_767_ = _e427;
    }
    let _e429 = phi_767_;
    if _e429 {
        phi_771_ = _e393;
    } else {
        phi_771_ = _e423;
    }
    let _e431 = phi_771_;
    let _e432 = -(_e404);
    if (_e432 <= 0f) {
        let _e436 = ((bitcast<u32>(_e431) & 2147483647u) > 2139095040u);
        if _e436 {
        }
        phi_783_ = _e436;
    } else {
        phi_783_ = true;
    }
    let _e438 = phi_783_;
    if _e438 {
        phi_790_ = (_e431 / (_e431 + (_e432 * _e432)));
    } else {
        phi_790_ = 1f;
    }
    let _e443 = phi_790_;
    let _e445 = (*param_4).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_803_ = true;
    } else {
        let _e449 = (42f < _e445);
        if _e449 {
        }
        phi_803_ = _e449;
    }
    let _e451 = phi_803_;
    if _e451 {
        phi_807_ = 42f;
    } else {
        phi_807_ = _e445;
    }
    let _e453 = phi_807_;
    let _e454 = -(_e453);
    let _e456 = (_e454 * param_5.x);
    let _e458 = (_e454 * param_5.y);
    let _e460 = (_e454 * param_5.z);
    let _e462 = (_e454 * param_5.w);
    if ((bitcast<u32>(_e456) & 2147483647u) > 2139095040u) {
        phi_904_ = _e456;
    } else {
        if (_e456 < -87f) {
            phi_827_ = -87f;
        } else {
            phi_827_ = _e456;
        }
        let _e468 = phi_827_;
        if (_e468 > 88f) {
            phi_832_ = 88f;
        } else {
            phi_832_ = _e468;
        }
        let _e471 = phi_832_;
        let _e473 = ((_e471 * 1.442695f) + 0.5f);
        if (_e473 > -8388608f) {
            let _e485 = f32(select(0i, select(select(i32(_e473), i32(-2147483648), (_e473 < bitcast<f32>(3472883712u))), 2147483647i, (_e473 > bitcast<f32>(1325400063u))), (_e473 == _e473)));
            if (_e485 > _e473) {
                phi_854_ = 1f;
            } else {
                phi_854_ = 0f;
            }
            let _e488 = phi_854_;
            if (_e473 < 8388608f) {
                phi_859_ = (_e485 - _e488);
                phi_860_ = false;
            } else {
                phi_859_ = f32();
                phi_860_ = true;
            }
            let _e491 = phi_859_;
            let _e493 = phi_860_;
            phi_861_ = _e491;
            phi_862_ = _e493;
        } else {
            phi_861_ = f32();
            phi_862_ = true;
        }
        let _e495 = phi_861_;
        let _e497 = phi_862_;
        if _e497 {
            phi_866_ = _e473;
        } else {
            phi_866_ = _e495;
        }
        let _e499 = phi_866_;
        let _e503 = ((_e471 - (_e499 * 0.69314575f)) - (_e499 * 0.0000014286068f));
        phi_904_ = ((((((((((((((((1f / 5040f) * _e503) + (1f / 720f)) * _e503) + (1f / 120f)) * _e503) + (1f / 24f)) * _e503) + (1f / 6f)) * _e503) + 0.5f) * _e503) + 1f) * _e503) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e499), i32(-2147483648), (_e499 < bitcast<f32>(3472883712u))), 2147483647i, (_e499 > bitcast<f32>(1325400063u))), (_e499 == _e499)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e539 = phi_904_;
    if ((bitcast<u32>(_e458) & 2147483647u) > 2139095040u) {
        phi_992_ = _e458;
    } else {
        if (_e458 < -87f) {
            phi_915_ = -87f;
        } else {
            phi_915_ = _e458;
        }
        let _e545 = phi_915_;
        if (_e545 > 88f) {
            phi_920_ = 88f;
        } else {
            phi_920_ = _e545;
        }
        let _e548 = phi_920_;
        let _e550 = ((_e548 * 1.442695f) + 0.5f);
        if (_e550 > -8388608f) {
            let _e562 = f32(select(0i, select(select(i32(_e550), i32(-2147483648), (_e550 < bitcast<f32>(3472883712u))), 2147483647i, (_e550 > bitcast<f32>(1325400063u))), (_e550 == _e550)));
            if (_e562 > _e550) {
                phi_942_ = 1f;
            } else {
                phi_942_ = 0f;
            }
            let _e565 = phi_942_;
            if (_e550 < 8388608f) {
                phi_947_ = (_e562 - _e565);
                phi_948_ = false;
            } else {
                phi_947_ = f32();
                phi_948_ = true;
            }
            let _e568 = phi_947_;
            let _e570 = phi_948_;
            phi_949_ = _e568;
            phi_950_ = _e570;
        } else {
            phi_949_ = f32();
            phi_950_ = true;
        }
        let _e572 = phi_949_;
        let _e574 = phi_950_;
        if _e574 {
            phi_954_ = _e550;
        } else {
            phi_954_ = _e572;
        }
        let _e576 = phi_954_;
        let _e580 = ((_e548 - (_e576 * 0.69314575f)) - (_e576 * 0.0000014286068f));
        phi_992_ = ((((((((((((((((1f / 5040f) * _e580) + (1f / 720f)) * _e580) + (1f / 120f)) * _e580) + (1f / 24f)) * _e580) + (1f / 6f)) * _e580) + 0.5f) * _e580) + 1f) * _e580) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e576), i32(-2147483648), (_e576 < bitcast<f32>(3472883712u))), 2147483647i, (_e576 > bitcast<f32>(1325400063u))), (_e576 == _e576)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e616 = phi_992_;
    if ((bitcast<u32>(_e460) & 2147483647u) > 2139095040u) {
        phi_1080_ = _e460;
    } else {
        if (_e460 < -87f) {
            phi_1003_ = -87f;
        } else {
            phi_1003_ = _e460;
        }
        let _e622 = phi_1003_;
        if (_e622 > 88f) {
            phi_1008_ = 88f;
        } else {
            phi_1008_ = _e622;
        }
        let _e625 = phi_1008_;
        let _e627 = ((_e625 * 1.442695f) + 0.5f);
        if (_e627 > -8388608f) {
            let _e639 = f32(select(0i, select(select(i32(_e627), i32(-2147483648), (_e627 < bitcast<f32>(3472883712u))), 2147483647i, (_e627 > bitcast<f32>(1325400063u))), (_e627 == _e627)));
            if (_e639 > _e627) {
                phi_1030_ = 1f;
            } else {
                phi_1030_ = 0f;
            }
            let _e642 = phi_1030_;
            if (_e627 < 8388608f) {
                phi_1035_ = (_e639 - _e642);
                phi_1036_ = false;
            } else {
                phi_1035_ = f32();
                phi_1036_ = true;
            }
            let _e645 = phi_1035_;
            let _e647 = phi_1036_;
            phi_1037_ = _e645;
            phi_1038_ = _e647;
        } else {
            phi_1037_ = f32();
            phi_1038_ = true;
        }
        let _e649 = phi_1037_;
        let _e651 = phi_1038_;
        if _e651 {
            phi_1042_ = _e627;
        } else {
            phi_1042_ = _e649;
        }
        let _e653 = phi_1042_;
        let _e657 = ((_e625 - (_e653 * 0.69314575f)) - (_e653 * 0.0000014286068f));
        phi_1080_ = ((((((((((((((((1f / 5040f) * _e657) + (1f / 720f)) * _e657) + (1f / 120f)) * _e657) + (1f / 24f)) * _e657) + (1f / 6f)) * _e657) + 0.5f) * _e657) + 1f) * _e657) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e653), i32(-2147483648), (_e653 < bitcast<f32>(3472883712u))), 2147483647i, (_e653 > bitcast<f32>(1325400063u))), (_e653 == _e653)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e693 = phi_1080_;
    if ((bitcast<u32>(_e462) & 2147483647u) > 2139095040u) {
        phi_1168_ = _e462;
    } else {
        if (_e462 < -87f) {
            phi_1091_ = -87f;
        } else {
            phi_1091_ = _e462;
        }
        let _e699 = phi_1091_;
        if (_e699 > 88f) {
            phi_1096_ = 88f;
        } else {
            phi_1096_ = _e699;
        }
        let _e702 = phi_1096_;
        let _e704 = ((_e702 * 1.442695f) + 0.5f);
        if (_e704 > -8388608f) {
            let _e716 = f32(select(0i, select(select(i32(_e704), i32(-2147483648), (_e704 < bitcast<f32>(3472883712u))), 2147483647i, (_e704 > bitcast<f32>(1325400063u))), (_e704 == _e704)));
            if (_e716 > _e704) {
                phi_1118_ = 1f;
            } else {
                phi_1118_ = 0f;
            }
            let _e719 = phi_1118_;
            if (_e704 < 8388608f) {
                phi_1123_ = (_e716 - _e719);
                phi_1124_ = false;
            } else {
                phi_1123_ = f32();
                phi_1124_ = true;
            }
            let _e722 = phi_1123_;
            let _e724 = phi_1124_;
            phi_1125_ = _e722;
            phi_1126_ = _e724;
        } else {
            phi_1125_ = f32();
            phi_1126_ = true;
        }
        let _e726 = phi_1125_;
        let _e728 = phi_1126_;
        if _e728 {
            phi_1130_ = _e704;
        } else {
            phi_1130_ = _e726;
        }
        let _e730 = phi_1130_;
        let _e734 = ((_e702 - (_e730 * 0.69314575f)) - (_e730 * 0.0000014286068f));
        phi_1168_ = ((((((((((((((((1f / 5040f) * _e734) + (1f / 720f)) * _e734) + (1f / 120f)) * _e734) + (1f / 24f)) * _e734) + (1f / 6f)) * _e734) + 0.5f) * _e734) + 1f) * _e734) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e730), i32(-2147483648), (_e730 < bitcast<f32>(3472883712u))), 2147483647i, (_e730 > bitcast<f32>(1325400063u))), (_e730 == _e730)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e770 = phi_1168_;
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
        phi_1221_ = true;
    } else {
        let _e816 = (_e782 > _e812);
        if _e816 {
        }
        phi_1221_ = _e816;
    }
    let _e818 = phi_1221_;
    if _e818 {
        phi_1225_ = _e782;
    } else {
        phi_1225_ = _e812;
    }
    let _e820 = phi_1225_;
    let _e821 = -(_e793);
    if (_e821 <= 0f) {
        let _e825 = ((bitcast<u32>(_e820) & 2147483647u) > 2139095040u);
        if _e825 {
        }
        phi_1237_ = _e825;
    } else {
        phi_1237_ = true;
    }
    let _e827 = phi_1237_;
    if _e827 {
        phi_1244_ = (_e820 / (_e820 + (_e821 * _e821)));
    } else {
        phi_1244_ = 1f;
    }
    let _e832 = phi_1244_;
    if ((bitcast<u32>(_e832) & 2147483647u) > 2139095040u) {
        phi_1255_ = true;
    } else {
        let _e836 = (_e832 < _e443);
        if _e836 {
        }
        phi_1255_ = _e836;
    }
    let _e838 = phi_1255_;
    if _e838 {
        phi_1259_ = _e832;
    } else {
        phi_1259_ = _e443;
    }
    let _e840 = phi_1259_;
    if ((bitcast<u32>(_e840) & 2147483647u) > 2139095040u) {
        phi_1276_ = _e840;
    } else {
        if (_e840 < 0f) {
            phi_1275_ = 0f;
        } else {
            if (_e840 > 1f) {
                phi_1274_ = 1f;
            } else {
                phi_1274_ = _e840;
            }
            let _e847 = phi_1274_;
            phi_1275_ = _e847;
        }
        let _e849 = phi_1275_;
        phi_1276_ = _e849;
    }
    let _e851 = phi_1276_;
    return _e851;
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_7: ptr<function, lt_math_Evsm>, param_8: vec4<f32>, param_9: vec4<f32>, param_10: f32) -> f32 {
    var phi_199_: f32;
    var phi_200_: f32;
    var phi_201_: f32;
    var phi_217_: f32;
    var phi_218_: f32;
    var phi_219_: f32;
    var phi_235_: f32;
    var phi_236_: f32;
    var phi_237_: f32;
    var phi_253_: f32;
    var phi_254_: f32;
    var phi_255_: f32;
    var phi_271_: f32;
    var phi_272_: f32;
    var phi_273_: f32;
    var phi_310_: bool;
    var phi_311_: bool;
    var phi_312_: bool;
    var phi_313_: bool;
    var phi_314_: bool;
    var phi_315_: bool;
    var phi_316_: bool;
    var phi_317_: bool;
    var phi_318_: bool;
    var phi_319_: bool;
    var phi_320_: bool;
    var phi_324_: bool;
    var phi_328_: bool;
    var phi_333_: f32;

    if ((bitcast<u32>(param_10) & 2147483647u) > 2139095040u) {
        phi_201_ = param_10;
    } else {
        if (param_10 < 0f) {
            phi_200_ = 0f;
        } else {
            if (param_10 > 1f) {
                phi_199_ = 1f;
            } else {
                phi_199_ = param_10;
            }
            let _e63 = phi_199_;
            phi_200_ = _e63;
        }
        let _e65 = phi_200_;
        phi_201_ = _e65;
    }
    let _e67 = phi_201_;
    if ((bitcast<u32>(param_8.x) & 2147483647u) > 2139095040u) {
        phi_219_ = param_8.x;
    } else {
        if (param_8.x < 0f) {
            phi_218_ = 0f;
        } else {
            if (param_8.x > 1f) {
                phi_217_ = 1f;
            } else {
                phi_217_ = param_8.x;
            }
            let _e75 = phi_217_;
            phi_218_ = _e75;
        }
        let _e77 = phi_218_;
        phi_219_ = _e77;
    }
    let _e79 = phi_219_;
    if ((bitcast<u32>(param_8.y) & 2147483647u) > 2139095040u) {
        phi_237_ = param_8.y;
    } else {
        if (param_8.y < 0f) {
            phi_236_ = 0f;
        } else {
            if (param_8.y > 1f) {
                phi_235_ = 1f;
            } else {
                phi_235_ = param_8.y;
            }
            let _e87 = phi_235_;
            phi_236_ = _e87;
        }
        let _e89 = phi_236_;
        phi_237_ = _e89;
    }
    let _e91 = phi_237_;
    if ((bitcast<u32>(param_8.z) & 2147483647u) > 2139095040u) {
        phi_255_ = param_8.z;
    } else {
        if (param_8.z < 0f) {
            phi_254_ = 0f;
        } else {
            if (param_8.z > 1f) {
                phi_253_ = 1f;
            } else {
                phi_253_ = param_8.z;
            }
            let _e99 = phi_253_;
            phi_254_ = _e99;
        }
        let _e101 = phi_254_;
        phi_255_ = _e101;
    }
    let _e103 = phi_255_;
    if ((bitcast<u32>(param_8.w) & 2147483647u) > 2139095040u) {
        phi_273_ = param_8.w;
    } else {
        if (param_8.w < 0f) {
            phi_272_ = 0f;
        } else {
            if (param_8.w > 1f) {
                phi_271_ = 1f;
            } else {
                phi_271_ = param_8.w;
            }
            let _e111 = phi_271_;
            phi_272_ = _e111;
        }
        let _e113 = phi_272_;
        phi_273_ = _e113;
    }
    let _e115 = phi_273_;
    let _e116 = (_e79 - _e67);
    let _e117 = (_e91 - _e67);
    let _e118 = (_e103 - _e67);
    let _e119 = (_e115 - _e67);
    if (_e116 >= 0f) {
        if (_e117 >= 0f) {
            if (_e118 >= 0f) {
                if (_e119 >= 0f) {
                    phi_310_ = !(((bitcast<u32>(((((_e116 * param_9.x) + (_e117 * param_9.y)) + (_e118 * param_9.z)) + (_e119 * param_9.w))) & 2147483647u) > 2139095040u));
                    phi_311_ = false;
                } else {
                    phi_310_ = bool();
                    phi_311_ = true;
                }
                let _e141 = phi_310_;
                let _e143 = phi_311_;
                phi_312_ = _e141;
                phi_313_ = false;
                phi_314_ = _e143;
            } else {
                phi_312_ = bool();
                phi_313_ = true;
                phi_314_ = false;
            }
            let _e145 = phi_312_;
            let _e147 = phi_313_;
            let _e149 = phi_314_;
            phi_315_ = _e145;
            phi_316_ = _e147;
            phi_317_ = _e149;
        } else {
            phi_315_ = bool();
            phi_316_ = true;
            phi_317_ = false;
        }
        let _e151 = phi_315_;
        let _e153 = phi_316_;
        let _e155 = phi_317_;
        phi_318_ = _e151;
        phi_319_ = _e153;
        phi_320_ = _e155;
    } else {
        phi_318_ = bool();
        phi_319_ = true;
        phi_320_ = false;
    }
    let _e157 = phi_318_;
    let _e159 = phi_319_;
    let _e161 = phi_320_;
    if _e159 {
        phi_324_ = true;
    } else {
        phi_324_ = _e161;
    }
    let _e163 = phi_324_;
    if _e163 {
        phi_328_ = false;
    } else {
        phi_328_ = _e157;
    }
    let _e165 = phi_328_;
    if _e165 {
        phi_333_ = 1f;
    } else {
        let _e166 = _lt_math_evsm_Evsm_bound_of_offsets(param_7, vec4<f32>(_e116, _e117, _e118, _e119), param_9);
        phi_333_ = _e166;
    }
    let _e168 = phi_333_;
    return _e168;
}

fn function_() {
    var local: lt_math_Evsm;
    var phi_1336_: bool;
    var phi_1337_: bool;
    var phi_1338_: bool;
    var phi_1339_: bool;
    var phi_1343_: bool;
    var phi_1413_: bool;
    var phi_1414_: bool;
    var phi_1425_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1426_: bool;
    var phi_1427_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1428_: bool;
    var phi_1435_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1439_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1459_: lt_math_LightPoint;
    var phi_1462_: u32;
    var phi_1464_: lt_math_LevelPoint;
    var phi_1550_: bool;
    var phi_1559_: bool;
    var phi_1568_: bool;
    var phi_1569_: bool;
    var phi_1570_: bool;
    var phi_1571_: bool;
    var phi_1572_: bool;
    var phi_1573_: bool;
    var phi_1574_: bool;
    var phi_1578_: bool;
    var phi_1605_: bool;
    var phi_1606_: bool;
    var phi_1607_: bool;
    var phi_1608_: bool;
    var phi_1609_: bool;
    var phi_1610_: bool;
    var phi_1611_: bool;
    var phi_1612_: bool;
    var phi_1616_: bool;
    var phi_1625_: lt_math_LightPoint;
    var phi_1626_: u32;
    var phi_1627_: lt_math_LevelPoint;
    var phi_1628_: bool;
    var phi_1460_: lt_math_LightPoint;
    var phi_1463_: u32;
    var phi_1465_: lt_math_LevelPoint;
    var phi_1629_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_1669_: bool;
    var phi_1670_: bool;
    var phi_1671_: bool;
    var phi_1672_: bool;
    var phi_1676_: bool;
    var phi_1758_: f32;
    var phi_1876_: f32;
    var phi_1877_: f32;
    var phi_1880_: f32;
    var phi_1909_: f32;
    var phi_1914_: f32;
    var phi_1915_: bool;
    var phi_1916_: f32;
    var phi_1917_: bool;
    var phi_1921_: f32;
    var phi_1941_: f32;
    var phi_1946_: f32;
    var phi_1947_: bool;
    var phi_1948_: f32;
    var phi_1949_: bool;
    var phi_1953_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_2006_: i32;
    var phi_2011_: i32;
    var phi_2016_: i32;
    var phi_2021_: i32;
    var phi_2030_: i32;
    var phi_2035_: i32;
    var phi_2040_: i32;
    var phi_2045_: i32;
    var phi_2090_: evaluate_Verdict;
    var phi_2091_: evaluate_Verdict;
    var phi_2092_: bool;
    var phi_2093_: evaluate_Verdict;
    var phi_2094_: evaluate_Verdict;
    var phi_2095_: bool;
    var phi_2099_: evaluate_Verdict;

    let _e54 = id_1;
    let _e61 = arrayLength((&map.member));
    let _e67 = arrayLength((&levels.member));
    let _e70 = p.member.size[0u];
    let _e72 = p.member.size[1u];
    let _e73 = lt_shaders_entry_pixel_index(_e54, _e70, _e72);
    if (bitcast<i32>(_e73.root) != 0i) {
        let _e79 = p.member.level_count;
        if (_e73.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e86 = samples.member[(0u + _e73.first_primitive)].normal[0u];
        let _e88 = global[0u];
        if (_e86 == _e88) {
            let _e91 = samples.member[(0u + _e73.first_primitive)].normal[1u];
            let _e93 = global[1u];
            if (_e91 == _e93) {
                let _e96 = samples.member[(0u + _e73.first_primitive)].normal[2u];
                let _e98 = global[2u];
                phi_1336_ = (_e96 == _e98);
                phi_1337_ = false;
            } else {
                phi_1336_ = bool();
                phi_1337_ = true;
            }
            let _e101 = phi_1336_;
            let _e103 = phi_1337_;
            phi_1338_ = _e101;
            phi_1339_ = _e103;
        } else {
            phi_1338_ = bool();
            phi_1339_ = true;
        }
        let _e105 = phi_1338_;
        let _e107 = phi_1339_;
        if _e107 {
            phi_1343_ = false;
        } else {
            phi_1343_ = _e105;
        }
        let _e109 = phi_1343_;
        if !(_e109) {
            let _e112 = samples.member[(0u + _e73.first_primitive)].position;
            let _e114 = p.member.light.place;
            let _e120 = p.member.light.place[3u];
            let _e127 = (_e114.x - (_e112.x * _e120));
            let _e128 = (_e114.y - (_e112.y * _e120));
            let _e129 = (_e114.z - (_e112.z * _e120));
            let _e131 = samples.member[(0u + _e73.first_primitive)].normal;
            if ((((_e131.x * _e127) + (_e131.y * _e128)) + (_e131.z * _e129)) > 0f) {
                let _e145 = (((_e127 * _e127) + (_e128 * _e128)) + (_e129 * _e129));
                let _e147 = p.member.light.axis;
                let _e159 = p.member.light.place[3u];
                if (_e159 == 0f) {
                    phi_1414_ = true;
                } else {
                    let _e162 = p.member.light.range_squared;
                    if (_e145 <= _e162) {
                        let _e165 = p.member.light.cos_outer;
                        phi_1413_ = (-((((_e127 * _e147.x) + (_e128 * _e147.y)) + (_e129 * _e147.z))) >= (_e165 * sqrt(_e145)));
                    } else {
                        phi_1413_ = false;
                    }
                    let _e170 = phi_1413_;
                    phi_1414_ = _e170;
                }
                let _e172 = phi_1414_;
                if _e172 {
                    let _e174 = samples.member[(0u + _e73.first_primitive)].flags;
                    let _e182 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e188 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e182.unnamed.visibility, false), _e182.unnamed_1);
                    phi_1425_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e188.unnamed, ((_e174 & 1u) == 0u));
                    phi_1426_ = false;
                } else {
                    phi_1425_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_1426_ = true;
                }
                let _e193 = phi_1425_;
                let _e195 = phi_1426_;
                phi_1427_ = _e193;
                phi_1428_ = _e195;
            } else {
                phi_1427_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_1428_ = true;
            }
            let _e197 = phi_1427_;
            let _e199 = phi_1428_;
            if _e199 {
                let _e205 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e211 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e205.unnamed.visibility, false), _e205.unnamed_1);
                phi_1435_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e211.unnamed, true);
            } else {
                phi_1435_ = _e197;
            }
            let _e216 = phi_1435_;
            phi_1439_ = _e216;
        } else {
            let _e222 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e228 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e222.unnamed.visibility, false), _e222.unnamed_1);
            phi_1439_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e228.unnamed, true);
        }
        let _e233 = phi_1439_;
        if _e233.unnamed_1 {
            phi_2093_ = evaluate_Verdict(_e233.unnamed.visibility, _e233.unnamed.is_doubted);
            phi_2094_ = evaluate_Verdict();
            phi_2095_ = true;
        } else {
            let _e241 = samples.member[(0u + _e73.first_primitive)].position;
            let _e243 = p.member.map_size;
            let _e245 = (0.5f / f32(_e243));
            let _e252 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e259 = lt_math_LightPoint(vec2<f32>(_e252.uv.x, 0f), _e252.depth, _e252.is_inside);
            let _e263 = lt_math_LightPoint(_e259.uv, 0f, _e259.is_inside);
            phi_1459_ = lt_math_LightPoint();
            phi_1462_ = 0u;
            phi_1464_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e263.uv, _e263.depth, false));
            loop {
                let _e270 = phi_1459_;
                let _e272 = phi_1462_;
                let _e274 = phi_1464_;
                local_1 = _e274;
                local_2 = _e274;
                local_3 = _e274;
                if (_e272 < _e79) {
                    if _e274.point.is_inside {
                        phi_1625_ = lt_math_LightPoint();
                        phi_1626_ = u32();
                        phi_1627_ = lt_math_LevelPoint();
                        phi_1628_ = false;
                    } else {
                        if (_e272 < _e67) {
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
                                phi_1550_ = (_e310 <= 1f);
                            } else {
                                phi_1550_ = false;
                            }
                            let _e342 = phi_1550_;
                            if _e342 {
                                if (_e324 >= 0f) {
                                    phi_1559_ = (_e324 <= 1f);
                                } else {
                                    phi_1559_ = false;
                                }
                                let _e346 = phi_1559_;
                                if _e346 {
                                    if (_e337 >= 0f) {
                                        phi_1568_ = (_e337 <= 1f);
                                    } else {
                                        phi_1568_ = false;
                                    }
                                    let _e350 = phi_1568_;
                                    phi_1569_ = _e350;
                                    phi_1570_ = false;
                                } else {
                                    phi_1569_ = bool();
                                    phi_1570_ = true;
                                }
                                let _e352 = phi_1569_;
                                let _e354 = phi_1570_;
                                phi_1571_ = _e352;
                                phi_1572_ = _e354;
                            } else {
                                phi_1571_ = bool();
                                phi_1572_ = true;
                            }
                            let _e356 = phi_1571_;
                            let _e358 = phi_1572_;
                            phi_1573_ = _e356;
                            phi_1574_ = _e358;
                        } else {
                            phi_1573_ = bool();
                            phi_1574_ = true;
                        }
                        let _e360 = phi_1573_;
                        let _e362 = phi_1574_;
                        if _e362 {
                            phi_1578_ = false;
                        } else {
                            phi_1578_ = _e360;
                        }
                        let _e364 = phi_1578_;
                        if _e364 {
                            if (_e310 >= _e245) {
                                if (_e310 <= (1f - _e245)) {
                                    if (_e324 >= _e245) {
                                        phi_1605_ = (_e324 <= (1f - _e245));
                                        phi_1606_ = false;
                                    } else {
                                        phi_1605_ = bool();
                                        phi_1606_ = true;
                                    }
                                    let _e372 = phi_1605_;
                                    let _e374 = phi_1606_;
                                    phi_1607_ = _e372;
                                    phi_1608_ = _e374;
                                } else {
                                    phi_1607_ = bool();
                                    phi_1608_ = true;
                                }
                                let _e376 = phi_1607_;
                                let _e378 = phi_1608_;
                                phi_1609_ = _e376;
                                phi_1610_ = _e378;
                            } else {
                                phi_1609_ = bool();
                                phi_1610_ = true;
                            }
                            let _e380 = phi_1609_;
                            let _e382 = phi_1610_;
                            phi_1611_ = _e380;
                            phi_1612_ = _e382;
                        } else {
                            phi_1611_ = bool();
                            phi_1612_ = true;
                        }
                        let _e384 = phi_1611_;
                        let _e386 = phi_1612_;
                        if _e386 {
                            phi_1616_ = false;
                        } else {
                            phi_1616_ = _e384;
                        }
                        let _e388 = phi_1616_;
                        let _e395 = lt_math_LightPoint(vec2<f32>(_e310, _e270.uv.y), _e270.depth, _e270.is_inside);
                        let _e402 = lt_math_LightPoint(vec2<f32>(_e395.uv.x, _e324), _e395.depth, _e395.is_inside);
                        let _e406 = lt_math_LightPoint(_e402.uv, _e337, _e402.is_inside);
                        let _e410 = lt_math_LightPoint(_e406.uv, _e406.depth, _e388);
                        phi_1625_ = _e410;
                        phi_1626_ = (_e272 + 1u);
                        phi_1627_ = lt_math_LevelPoint(_e272, _e410);
                        phi_1628_ = true;
                    }
                    let _e414 = phi_1625_;
                    let _e416 = phi_1626_;
                    let _e418 = phi_1627_;
                    let _e420 = phi_1628_;
                    phi_1460_ = _e414;
                    phi_1463_ = _e416;
                    phi_1465_ = _e418;
                    phi_1629_ = _e420;
                } else {
                    phi_1460_ = lt_math_LightPoint();
                    phi_1463_ = u32();
                    phi_1465_ = lt_math_LevelPoint();
                    phi_1629_ = false;
                }
                let _e422 = phi_1460_;
                let _e424 = phi_1463_;
                let _e426 = phi_1465_;
                let _e428 = phi_1629_;
                continue;
                continuing {
                    phi_1459_ = _e422;
                    phi_1462_ = _e424;
                    phi_1464_ = _e426;
                    break if !(_e428);
                }
            }
            let _e431 = local_1;
            if _e431.point.is_inside {
                if (0f > 0f) {
                    let _e437 = local_2;
                    if (_e437.level < _e67) {
                    } else {
                        return;
                    }
                    let _e442 = levels.member[(0u + _e437.level)];
                    let _e448 = global[0u];
                    if (_e442.row_w.x == _e448) {
                        let _e451 = global[1u];
                        if (_e442.row_w.y == _e451) {
                            let _e454 = global[2u];
                            phi_1669_ = (_e442.row_w.z == _e454);
                            phi_1670_ = false;
                        } else {
                            phi_1669_ = bool();
                            phi_1670_ = true;
                        }
                        let _e457 = phi_1669_;
                        let _e459 = phi_1670_;
                        phi_1671_ = _e457;
                        phi_1672_ = _e459;
                    } else {
                        phi_1671_ = bool();
                        phi_1672_ = true;
                    }
                    let _e461 = phi_1671_;
                    let _e463 = phi_1672_;
                    if _e463 {
                        phi_1676_ = false;
                    } else {
                        phi_1676_ = _e461;
                    }
                    let _e465 = phi_1676_;
                    if _e465 {
                        let _e467 = samples.member[(0u + _e73.first_primitive)].normal;
                        let _e469 = p.member.map_size;
                        let _e539 = ((abs(((((_e442.row_x.x * _e467.x) + (_e442.row_x.y * _e467.y)) + (_e442.row_x.z * _e467.z)) / (((_e442.row_x.x * _e442.row_x.x) + (_e442.row_x.y * _e442.row_x.y)) + (_e442.row_x.z * _e442.row_x.z)))) + abs(((((_e442.row_y.x * _e467.x) + (_e442.row_y.y * _e467.y)) + (_e442.row_y.z * _e467.z)) / (((_e442.row_y.x * _e442.row_y.x) + (_e442.row_y.y * _e442.row_y.y)) + (_e442.row_y.z * _e442.row_y.z))))) / (abs(((((_e442.row_z.x * _e467.x) + (_e442.row_z.y * _e467.y)) + (_e442.row_z.z * _e467.z)) / (((_e442.row_z.x * _e442.row_z.x) + (_e442.row_z.y * _e442.row_z.y)) + (_e442.row_z.z * _e442.row_z.z)))) * f32(_e469)));
                        if (_e539 < 0.002f) {
                            phi_1758_ = _e539;
                        } else {
                            phi_1758_ = 0.002f;
                        }
                        let _e542 = phi_1758_;
                        phi_1877_ = _e542;
                    } else {
                        let _e544 = p.member.map_size;
                        let _e550 = samples.member[(0u + _e73.first_primitive)].position;
                        let _e561 = ((((_e442.row_w.x * _e550.x) + (_e442.row_w.y * _e550.y)) + (_e442.row_w.z * _e550.z)) + _e442.row_w.w);
                        let _e574 = ((_e442.row_x.x - (_e442.row_w.x * _e431.point.uv.x)) / _e561);
                        let _e575 = ((_e442.row_x.y - (_e442.row_w.y * _e431.point.uv.x)) / _e561);
                        let _e576 = ((_e442.row_x.z - (_e442.row_w.z * _e431.point.uv.x)) / _e561);
                        let _e589 = ((_e442.row_y.x - (_e442.row_w.x * _e431.point.uv.y)) / _e561);
                        let _e590 = ((_e442.row_y.y - (_e442.row_w.y * _e431.point.uv.y)) / _e561);
                        let _e591 = ((_e442.row_y.z - (_e442.row_w.z * _e431.point.uv.y)) / _e561);
                        let _e597 = samples.member[(0u + _e73.first_primitive)].normal;
                        let _e602 = ((_e590 * _e597.z) - (_e597.y * _e591));
                        let _e607 = ((_e591 * _e597.x) - (_e597.z * _e589));
                        let _e612 = ((_e589 * _e597.y) - (_e597.x * _e590));
                        let _e614 = samples.member[(0u + _e73.first_primitive)].normal;
                        let _e619 = ((_e575 * _e614.z) - (_e614.y * _e576));
                        let _e624 = ((_e576 * _e614.x) - (_e614.z * _e574));
                        let _e629 = ((_e574 * _e614.y) - (_e614.x * _e575));
                        let _e656 = ((abs(((((_e442.row_z.x * _e602) + (_e442.row_z.y * _e607)) + (_e442.row_z.z * _e612)) / (((_e574 * _e602) + (_e575 * _e607)) + (_e576 * _e612)))) + abs(((((_e442.row_z.x * _e619) + (_e442.row_z.y * _e624)) + (_e442.row_z.z * _e629)) / (((_e589 * _e619) + (_e590 * _e624)) + (_e591 * _e629))))) / f32(_e544));
                        let _e658 = (16f / f32(_e544));
                        if (_e656 < _e658) {
                            phi_1876_ = _e656;
                        } else {
                            phi_1876_ = _e658;
                        }
                        let _e661 = phi_1876_;
                        phi_1877_ = _e661;
                    }
                    let _e663 = phi_1877_;
                    phi_1880_ = (_e431.point.depth - (0f * _e663));
                } else {
                    phi_1880_ = _e431.point.depth;
                }
                let _e667 = phi_1880_;
                let _e673 = p.member.map_size;
                let _e674 = f32(_e673);
                let _e677 = ((_e431.point.uv.x * _e674) - 0.5f);
                let _e678 = ((_e431.point.uv.y * _e674) - 0.5f);
                if (_e677 > -8388608f) {
                    let _e690 = f32(select(0i, select(select(i32(_e677), i32(-2147483648), (_e677 < bitcast<f32>(3472883712u))), 2147483647i, (_e677 > bitcast<f32>(1325400063u))), (_e677 == _e677)));
                    if (_e690 > _e677) {
                        phi_1909_ = 1f;
                    } else {
                        phi_1909_ = 0f;
                    }
                    let _e693 = phi_1909_;
                    if (_e677 < 8388608f) {
                        phi_1914_ = (_e690 - _e693);
                        phi_1915_ = false;
                    } else {
                        phi_1914_ = f32();
                        phi_1915_ = true;
                    }
                    let _e696 = phi_1914_;
                    let _e698 = phi_1915_;
                    phi_1916_ = _e696;
                    phi_1917_ = _e698;
                } else {
                    phi_1916_ = f32();
                    phi_1917_ = true;
                }
                let _e700 = phi_1916_;
                let _e702 = phi_1917_;
                if _e702 {
                    phi_1921_ = _e677;
                } else {
                    phi_1921_ = _e700;
                }
                let _e704 = phi_1921_;
                if (_e678 > -8388608f) {
                    let _e716 = f32(select(0i, select(select(i32(_e678), i32(-2147483648), (_e678 < bitcast<f32>(3472883712u))), 2147483647i, (_e678 > bitcast<f32>(1325400063u))), (_e678 == _e678)));
                    if (_e716 > _e678) {
                        phi_1941_ = 1f;
                    } else {
                        phi_1941_ = 0f;
                    }
                    let _e719 = phi_1941_;
                    if (_e678 < 8388608f) {
                        phi_1946_ = (_e716 - _e719);
                        phi_1947_ = false;
                    } else {
                        phi_1946_ = f32();
                        phi_1947_ = true;
                    }
                    let _e722 = phi_1946_;
                    let _e724 = phi_1947_;
                    phi_1948_ = _e722;
                    phi_1949_ = _e724;
                } else {
                    phi_1948_ = f32();
                    phi_1949_ = true;
                }
                let _e726 = phi_1948_;
                let _e728 = phi_1949_;
                if _e728 {
                    phi_1953_ = _e678;
                } else {
                    phi_1953_ = _e726;
                }
                let _e730 = phi_1953_;
                let _e731 = (_e677 - _e704);
                let _e732 = (_e678 - _e730);
                let _e741 = select(0i, select(select(i32(_e704), i32(-2147483648), (_e704 < bitcast<f32>(3472883712u))), 2147483647i, (_e704 > bitcast<f32>(1325400063u))), (_e704 == _e704));
                let _e750 = select(0i, select(select(i32(_e730), i32(-2147483648), (_e730 < bitcast<f32>(3472883712u))), 2147483647i, (_e730 > bitcast<f32>(1325400063u))), (_e730 == _e730));
                let _e761 = p.member.test;
                let _e762 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e761);
                let _e764 = p.member.map_size;
                let _e766 = local_3;
                local = lt_math_Evsm(_e762.positive_exponent, _e762.negative_exponent, _e762.min_variance);
                let _e773 = ((_e766.level * _e764) * _e764);
                let _e775 = (bitcast<i32>(_e764) - 1i);
                if (_e741 > 0i) {
                    phi_2006_ = _e741;
                } else {
                    phi_2006_ = 0i;
                }
                let _e778 = phi_2006_;
                if (_e750 > 0i) {
                    phi_2011_ = _e750;
                } else {
                    phi_2011_ = 0i;
                }
                let _e781 = phi_2011_;
                if (_e778 < _e775) {
                    phi_2016_ = _e778;
                } else {
                    phi_2016_ = _e775;
                }
                let _e784 = phi_2016_;
                if (_e781 < _e775) {
                    phi_2021_ = _e781;
                } else {
                    phi_2021_ = _e775;
                }
                let _e787 = phi_2021_;
                let _e788 = bitcast<u32>(_e784);
                let _e790 = (_e741 + 1i);
                let _e791 = (_e750 + 1i);
                if (_e790 > 0i) {
                    phi_2030_ = _e790;
                } else {
                    phi_2030_ = 0i;
                }
                let _e794 = phi_2030_;
                if (_e791 > 0i) {
                    phi_2035_ = _e791;
                } else {
                    phi_2035_ = 0i;
                }
                let _e797 = phi_2035_;
                if (_e794 < _e775) {
                    phi_2040_ = _e794;
                } else {
                    phi_2040_ = _e775;
                }
                let _e800 = phi_2040_;
                if (_e797 < _e775) {
                    phi_2045_ = _e797;
                } else {
                    phi_2045_ = _e775;
                }
                let _e803 = phi_2045_;
                let _e804 = bitcast<u32>(_e800);
                let _e806 = (bitcast<u32>(_e787) * _e764);
                let _e807 = (bitcast<u32>(_e803) * _e764);
                let _e812 = ((_e806 + _e788) + _e773);
                let _e813 = ((_e806 + _e804) + _e773);
                let _e814 = ((_e807 + _e788) + _e773);
                let _e815 = ((_e807 + _e804) + _e773);
                if (_e812 < _e61) {
                } else {
                    return;
                }
                let _e819 = map.member[(0u + _e812)];
                if (_e813 < _e61) {
                } else {
                    return;
                }
                let _e823 = map.member[(0u + _e813)];
                if (_e814 < _e61) {
                } else {
                    return;
                }
                let _e827 = map.member[(0u + _e814)];
                if (_e815 < _e61) {
                } else {
                    return;
                }
                let _e831 = map.member[(0u + _e815)];
                let _e833 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e819, _e823, _e827, _e831), vec4<f32>(((1f - _e731) * (1f - _e732)), (_e731 * (1f - _e732)), ((1f - _e731) * _e732), (_e731 * _e732)), _e667);
                phi_2090_ = evaluate_Verdict(_e833, false);
                phi_2091_ = evaluate_Verdict();
                phi_2092_ = false;
            } else {
                phi_2090_ = evaluate_Verdict();
                phi_2091_ = evaluate_Verdict(1f, false);
                phi_2092_ = true;
            }
            let _e837 = phi_2090_;
            let _e839 = phi_2091_;
            let _e841 = phi_2092_;
            phi_2093_ = _e839;
            phi_2094_ = _e837;
            phi_2095_ = _e841;
        }
        let _e843 = phi_2093_;
        let _e845 = phi_2094_;
        let _e847 = phi_2095_;
        if _e847 {
            phi_2099_ = _e843;
        } else {
            phi_2099_ = _e845;
        }
        let _e849 = phi_2099_;
        if (_e73.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e73.first_primitive)] = _e849.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_evsm_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
