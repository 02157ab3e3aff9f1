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

struct type_38 {
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
var<storage> levels: type_38;

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
        let _e65 = phi_162_;
        let _e67 = phi_163_;
        phi_164_ = _e65;
        phi_165_ = _e67;
    } else {
        phi_164_ = lt_bvh_traverse_Tree();
        phi_165_ = true;
    }
    let _e69 = phi_164_;
    let _e71 = phi_165_;
    if _e71 {
        phi_170_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_170_ = _e69;
    }
    let _e76 = phi_170_;
    return lt_bvh_traverse_Tree(_e76.root, _e76.first_primitive);
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

    let _e56 = (*param_4).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_350_ = true;
    } else {
        let _e60 = (42f < _e56);
        if _e60 {
        }
        phi_350_ = _e60;
    }
    let _e62 = phi_350_;
    if _e62 {
        phi_354_ = 42f;
    } else {
        phi_354_ = _e56;
    }
    let _e64 = phi_354_;
    let _e66 = (_e64 * param_5.x);
    let _e68 = (_e64 * param_5.y);
    let _e70 = (_e64 * param_5.z);
    let _e72 = (_e64 * param_5.w);
    if ((bitcast<u32>(_e66) & 2147483647u) > 2139095040u) {
        phi_450_ = _e66;
    } else {
        if (_e66 < -87f) {
            phi_373_ = -87f;
        } else {
            phi_373_ = _e66;
        }
        let _e78 = phi_373_;
        if (_e78 > 88f) {
            phi_378_ = 88f;
        } else {
            phi_378_ = _e78;
        }
        let _e81 = phi_378_;
        let _e83 = ((_e81 * 1.442695f) + 0.5f);
        if (_e83 > -8388608f) {
            let _e95 = f32(select(0i, select(select(i32(_e83), i32(-2147483648), (_e83 < bitcast<f32>(3472883712u))), 2147483647i, (_e83 > bitcast<f32>(1325400063u))), (_e83 == _e83)));
            if (_e95 > _e83) {
                phi_400_ = 1f;
            } else {
                phi_400_ = 0f;
            }
            let _e98 = phi_400_;
            if (_e83 < 8388608f) {
                phi_405_ = (_e95 - _e98);
                phi_406_ = false;
            } else {
                phi_405_ = f32();
                phi_406_ = true;
            }
            let _e101 = phi_405_;
            let _e103 = phi_406_;
            phi_407_ = _e101;
            phi_408_ = _e103;
        } else {
            phi_407_ = f32();
            phi_408_ = true;
        }
        let _e105 = phi_407_;
        let _e107 = phi_408_;
        if _e107 {
            phi_412_ = _e83;
        } else {
            phi_412_ = _e105;
        }
        let _e109 = phi_412_;
        let _e113 = ((_e81 - (_e109 * 0.69314575f)) - (_e109 * 0.0000014286068f));
        phi_450_ = ((((((((((((((((1f / 5040f) * _e113) + (1f / 720f)) * _e113) + (1f / 120f)) * _e113) + (1f / 24f)) * _e113) + (1f / 6f)) * _e113) + 0.5f) * _e113) + 1f) * _e113) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e109), i32(-2147483648), (_e109 < bitcast<f32>(3472883712u))), 2147483647i, (_e109 > bitcast<f32>(1325400063u))), (_e109 == _e109)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e149 = phi_450_;
    if ((bitcast<u32>(_e68) & 2147483647u) > 2139095040u) {
        phi_538_ = _e68;
    } else {
        if (_e68 < -87f) {
            phi_461_ = -87f;
        } else {
            phi_461_ = _e68;
        }
        let _e155 = phi_461_;
        if (_e155 > 88f) {
            phi_466_ = 88f;
        } else {
            phi_466_ = _e155;
        }
        let _e158 = phi_466_;
        let _e160 = ((_e158 * 1.442695f) + 0.5f);
        if (_e160 > -8388608f) {
            let _e172 = f32(select(0i, select(select(i32(_e160), i32(-2147483648), (_e160 < bitcast<f32>(3472883712u))), 2147483647i, (_e160 > bitcast<f32>(1325400063u))), (_e160 == _e160)));
            if (_e172 > _e160) {
                phi_488_ = 1f;
            } else {
                phi_488_ = 0f;
            }
            let _e175 = phi_488_;
            if (_e160 < 8388608f) {
                phi_493_ = (_e172 - _e175);
                phi_494_ = false;
            } else {
                phi_493_ = f32();
                phi_494_ = true;
            }
            let _e178 = phi_493_;
            let _e180 = phi_494_;
            phi_495_ = _e178;
            phi_496_ = _e180;
        } else {
            phi_495_ = f32();
            phi_496_ = true;
        }
        let _e182 = phi_495_;
        let _e184 = phi_496_;
        if _e184 {
            phi_500_ = _e160;
        } else {
            phi_500_ = _e182;
        }
        let _e186 = phi_500_;
        let _e190 = ((_e158 - (_e186 * 0.69314575f)) - (_e186 * 0.0000014286068f));
        phi_538_ = ((((((((((((((((1f / 5040f) * _e190) + (1f / 720f)) * _e190) + (1f / 120f)) * _e190) + (1f / 24f)) * _e190) + (1f / 6f)) * _e190) + 0.5f) * _e190) + 1f) * _e190) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e186), i32(-2147483648), (_e186 < bitcast<f32>(3472883712u))), 2147483647i, (_e186 > bitcast<f32>(1325400063u))), (_e186 == _e186)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e226 = phi_538_;
    if ((bitcast<u32>(_e70) & 2147483647u) > 2139095040u) {
        phi_626_ = _e70;
    } else {
        if (_e70 < -87f) {
            phi_549_ = -87f;
        } else {
            phi_549_ = _e70;
        }
        let _e232 = phi_549_;
        if (_e232 > 88f) {
            phi_554_ = 88f;
        } else {
            phi_554_ = _e232;
        }
        let _e235 = phi_554_;
        let _e237 = ((_e235 * 1.442695f) + 0.5f);
        if (_e237 > -8388608f) {
            let _e249 = f32(select(0i, select(select(i32(_e237), i32(-2147483648), (_e237 < bitcast<f32>(3472883712u))), 2147483647i, (_e237 > bitcast<f32>(1325400063u))), (_e237 == _e237)));
            if (_e249 > _e237) {
                phi_576_ = 1f;
            } else {
                phi_576_ = 0f;
            }
            let _e252 = phi_576_;
            if (_e237 < 8388608f) {
                phi_581_ = (_e249 - _e252);
                phi_582_ = false;
            } else {
                phi_581_ = f32();
                phi_582_ = true;
            }
            let _e255 = phi_581_;
            let _e257 = phi_582_;
            phi_583_ = _e255;
            phi_584_ = _e257;
        } else {
            phi_583_ = f32();
            phi_584_ = true;
        }
        let _e259 = phi_583_;
        let _e261 = phi_584_;
        if _e261 {
            phi_588_ = _e237;
        } else {
            phi_588_ = _e259;
        }
        let _e263 = phi_588_;
        let _e267 = ((_e235 - (_e263 * 0.69314575f)) - (_e263 * 0.0000014286068f));
        phi_626_ = ((((((((((((((((1f / 5040f) * _e267) + (1f / 720f)) * _e267) + (1f / 120f)) * _e267) + (1f / 24f)) * _e267) + (1f / 6f)) * _e267) + 0.5f) * _e267) + 1f) * _e267) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e263), i32(-2147483648), (_e263 < bitcast<f32>(3472883712u))), 2147483647i, (_e263 > bitcast<f32>(1325400063u))), (_e263 == _e263)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e303 = phi_626_;
    if ((bitcast<u32>(_e72) & 2147483647u) > 2139095040u) {
        phi_714_ = _e72;
    } else {
        if (_e72 < -87f) {
            phi_637_ = -87f;
        } else {
            phi_637_ = _e72;
        }
        let _e309 = phi_637_;
        if (_e309 > 88f) {
            phi_642_ = 88f;
        } else {
            phi_642_ = _e309;
        }
        let _e312 = phi_642_;
        let _e314 = ((_e312 * 1.442695f) + 0.5f);
        if (_e314 > -8388608f) {
            let _e326 = f32(select(0i, select(select(i32(_e314), i32(-2147483648), (_e314 < bitcast<f32>(3472883712u))), 2147483647i, (_e314 > bitcast<f32>(1325400063u))), (_e314 == _e314)));
            if (_e326 > _e314) {
                phi_664_ = 1f;
            } else {
                phi_664_ = 0f;
            }
            let _e329 = phi_664_;
            if (_e314 < 8388608f) {
                phi_669_ = (_e326 - _e329);
                phi_670_ = false;
            } else {
                phi_669_ = f32();
                phi_670_ = true;
            }
            let _e332 = phi_669_;
            let _e334 = phi_670_;
            phi_671_ = _e332;
            phi_672_ = _e334;
        } else {
            phi_671_ = f32();
            phi_672_ = true;
        }
        let _e336 = phi_671_;
        let _e338 = phi_672_;
        if _e338 {
            phi_676_ = _e314;
        } else {
            phi_676_ = _e336;
        }
        let _e340 = phi_676_;
        let _e344 = ((_e312 - (_e340 * 0.69314575f)) - (_e340 * 0.0000014286068f));
        phi_714_ = ((((((((((((((((1f / 5040f) * _e344) + (1f / 720f)) * _e344) + (1f / 120f)) * _e344) + (1f / 24f)) * _e344) + (1f / 6f)) * _e344) + 0.5f) * _e344) + 1f) * _e344) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e340), i32(-2147483648), (_e340 < bitcast<f32>(3472883712u))), 2147483647i, (_e340 > bitcast<f32>(1325400063u))), (_e340 == _e340)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e380 = phi_714_;
    let _e382 = (_e149 - vec4<f32>(1f, 1f, 1f, 1f).x);
    let _e384 = (_e226 - vec4<f32>(1f, 1f, 1f, 1f).y);
    let _e386 = (_e303 - vec4<f32>(1f, 1f, 1f, 1f).z);
    let _e388 = (_e380 - vec4<f32>(1f, 1f, 1f, 1f).w);
    let _e390 = (*param_4).min_variance;
    let _e392 = ((_e390 * _e64) * _e64);
    let _e403 = ((((_e382 * param_6.x) + (_e384 * param_6.y)) + (_e386 * param_6.z)) + (_e388 * param_6.w));
    let _e404 = (_e382 - _e403);
    let _e405 = (_e384 - _e403);
    let _e406 = (_e386 - _e403);
    let _e407 = (_e388 - _e403);
    let _e422 = (((((_e404 * _e404) * param_6.x) + ((_e405 * _e405) * param_6.y)) + ((_e406 * _e406) * param_6.z)) + ((_e407 * _e407) * param_6.w));
    if ((bitcast<u32>(_e392) & 2147483647u) > 2139095040u) {
        phi_767_ = true;
    } else {
        let _e426 = (_e392 > _e422);
        if _e426 {
        }
        phi_767_ = _e426;
    }
    let _e428 = phi_767_;
    if _e428 {
        phi_771_ = _e392;
    } else {
        phi_771_ = _e422;
    }
    let _e430 = phi_771_;
    let _e431 = -(_e403);
    if (_e431 <= 0f) {
        let _e435 = ((bitcast<u32>(_e430) & 2147483647u) > 2139095040u);
        if _e435 {
        }
        phi_783_ = _e435;
    } else {
        phi_783_ = true;
    }
    let _e437 = phi_783_;
    if _e437 {
        phi_790_ = (_e430 / (_e430 + (_e431 * _e431)));
    } else {
        phi_790_ = 1f;
    }
    let _e442 = phi_790_;
    let _e444 = (*param_4).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_803_ = true;
    } else {
        let _e448 = (42f < _e444);
        if _e448 {
        }
        phi_803_ = _e448;
    }
    let _e450 = phi_803_;
    if _e450 {
        phi_807_ = 42f;
    } else {
        phi_807_ = _e444;
    }
    let _e452 = phi_807_;
    let _e453 = -(_e452);
    let _e455 = (_e453 * param_5.x);
    let _e457 = (_e453 * param_5.y);
    let _e459 = (_e453 * param_5.z);
    let _e461 = (_e453 * param_5.w);
    if ((bitcast<u32>(_e455) & 2147483647u) > 2139095040u) {
        phi_904_ = _e455;
    } else {
        if (_e455 < -87f) {
            phi_827_ = -87f;
        } else {
            phi_827_ = _e455;
        }
        let _e467 = phi_827_;
        if (_e467 > 88f) {
            phi_832_ = 88f;
        } else {
            phi_832_ = _e467;
        }
        let _e470 = phi_832_;
        let _e472 = ((_e470 * 1.442695f) + 0.5f);
        if (_e472 > -8388608f) {
            let _e484 = f32(select(0i, select(select(i32(_e472), i32(-2147483648), (_e472 < bitcast<f32>(3472883712u))), 2147483647i, (_e472 > bitcast<f32>(1325400063u))), (_e472 == _e472)));
            if (_e484 > _e472) {
                phi_854_ = 1f;
            } else {
                phi_854_ = 0f;
            }
            let _e487 = phi_854_;
            if (_e472 < 8388608f) {
                phi_859_ = (_e484 - _e487);
                phi_860_ = false;
            } else {
                phi_859_ = f32();
                phi_860_ = true;
            }
            let _e490 = phi_859_;
            let _e492 = phi_860_;
            phi_861_ = _e490;
            phi_862_ = _e492;
        } else {
            phi_861_ = f32();
            phi_862_ = true;
        }
        let _e494 = phi_861_;
        let _e496 = phi_862_;
        if _e496 {
            phi_866_ = _e472;
        } else {
            phi_866_ = _e494;
        }
        let _e498 = phi_866_;
        let _e502 = ((_e470 - (_e498 * 0.69314575f)) - (_e498 * 0.0000014286068f));
        phi_904_ = ((((((((((((((((1f / 5040f) * _e502) + (1f / 720f)) * _e502) + (1f / 120f)) * _e502) + (1f / 24f)) * _e502) + (1f / 6f)) * _e502) + 0.5f) * _e502) + 1f) * _e502) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e498), i32(-2147483648), (_e498 < bitcast<f32>(3472883712u))), 2147483647i, (_e498 > bitcast<f32>(1325400063u))), (_e498 == _e498)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e538 = phi_904_;
    if ((bitcast<u32>(_e457) & 2147483647u) > 2139095040u) {
        phi_992_ = _e457;
    } else {
        if (_e457 < -87f) {
            phi_915_ = -87f;
        } else {
            phi_915_ = _e457;
        }
        let _e544 = phi_915_;
        if (_e544 > 88f) {
            phi_920_ = 88f;
        } else {
            phi_920_ = _e544;
        }
        let _e547 = phi_920_;
        let _e549 = ((_e547 * 1.442695f) + 0.5f);
        if (_e549 > -8388608f) {
            let _e561 = f32(select(0i, select(select(i32(_e549), i32(-2147483648), (_e549 < bitcast<f32>(3472883712u))), 2147483647i, (_e549 > bitcast<f32>(1325400063u))), (_e549 == _e549)));
            if (_e561 > _e549) {
                phi_942_ = 1f;
            } else {
                phi_942_ = 0f;
            }
            let _e564 = phi_942_;
            if (_e549 < 8388608f) {
                phi_947_ = (_e561 - _e564);
                phi_948_ = false;
            } else {
                phi_947_ = f32();
                phi_948_ = true;
            }
            let _e567 = phi_947_;
            let _e569 = phi_948_;
            phi_949_ = _e567;
            phi_950_ = _e569;
        } else {
            phi_949_ = f32();
            phi_950_ = true;
        }
        let _e571 = phi_949_;
        let _e573 = phi_950_;
        if _e573 {
            phi_954_ = _e549;
        } else {
            phi_954_ = _e571;
        }
        let _e575 = phi_954_;
        let _e579 = ((_e547 - (_e575 * 0.69314575f)) - (_e575 * 0.0000014286068f));
        phi_992_ = ((((((((((((((((1f / 5040f) * _e579) + (1f / 720f)) * _e579) + (1f / 120f)) * _e579) + (1f / 24f)) * _e579) + (1f / 6f)) * _e579) + 0.5f) * _e579) + 1f) * _e579) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e575), i32(-2147483648), (_e575 < bitcast<f32>(3472883712u))), 2147483647i, (_e575 > bitcast<f32>(1325400063u))), (_e575 == _e575)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e615 = phi_992_;
    if ((bitcast<u32>(_e459) & 2147483647u) > 2139095040u) {
        phi_1080_ = _e459;
    } else {
        if (_e459 < -87f) {
            phi_1003_ = -87f;
        } else {
            phi_1003_ = _e459;
        }
        let _e621 = phi_1003_;
        if (_e621 > 88f) {
            phi_1008_ = 88f;
        } else {
            phi_1008_ = _e621;
        }
        let _e624 = phi_1008_;
        let _e626 = ((_e624 * 1.442695f) + 0.5f);
        if (_e626 > -8388608f) {
            let _e638 = f32(select(0i, select(select(i32(_e626), i32(-2147483648), (_e626 < bitcast<f32>(3472883712u))), 2147483647i, (_e626 > bitcast<f32>(1325400063u))), (_e626 == _e626)));
            if (_e638 > _e626) {
                phi_1030_ = 1f;
            } else {
                phi_1030_ = 0f;
            }
            let _e641 = phi_1030_;
            if (_e626 < 8388608f) {
                phi_1035_ = (_e638 - _e641);
                phi_1036_ = false;
            } else {
                phi_1035_ = f32();
                phi_1036_ = true;
            }
            let _e644 = phi_1035_;
            let _e646 = phi_1036_;
            phi_1037_ = _e644;
            phi_1038_ = _e646;
        } else {
            phi_1037_ = f32();
            phi_1038_ = true;
        }
        let _e648 = phi_1037_;
        let _e650 = phi_1038_;
        if _e650 {
            phi_1042_ = _e626;
        } else {
            phi_1042_ = _e648;
        }
        let _e652 = phi_1042_;
        let _e656 = ((_e624 - (_e652 * 0.69314575f)) - (_e652 * 0.0000014286068f));
        phi_1080_ = ((((((((((((((((1f / 5040f) * _e656) + (1f / 720f)) * _e656) + (1f / 120f)) * _e656) + (1f / 24f)) * _e656) + (1f / 6f)) * _e656) + 0.5f) * _e656) + 1f) * _e656) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e652), i32(-2147483648), (_e652 < bitcast<f32>(3472883712u))), 2147483647i, (_e652 > bitcast<f32>(1325400063u))), (_e652 == _e652)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e692 = phi_1080_;
    if ((bitcast<u32>(_e461) & 2147483647u) > 2139095040u) {
        phi_1168_ = _e461;
    } else {
        if (_e461 < -87f) {
            phi_1091_ = -87f;
        } else {
            phi_1091_ = _e461;
        }
        let _e698 = phi_1091_;
        if (_e698 > 88f) {
            phi_1096_ = 88f;
        } else {
            phi_1096_ = _e698;
        }
        let _e701 = phi_1096_;
        let _e703 = ((_e701 * 1.442695f) + 0.5f);
        if (_e703 > -8388608f) {
            let _e715 = f32(select(0i, select(select(i32(_e703), i32(-2147483648), (_e703 < bitcast<f32>(3472883712u))), 2147483647i, (_e703 > bitcast<f32>(1325400063u))), (_e703 == _e703)));
            if (_e715 > _e703) {
                phi_1118_ = 1f;
            } else {
                phi_1118_ = 0f;
            }
            let _e718 = phi_1118_;
            if (_e703 < 8388608f) {
                phi_1123_ = (_e715 - _e718);
                phi_1124_ = false;
            } else {
                phi_1123_ = f32();
                phi_1124_ = true;
            }
            let _e721 = phi_1123_;
            let _e723 = phi_1124_;
            phi_1125_ = _e721;
            phi_1126_ = _e723;
        } else {
            phi_1125_ = f32();
            phi_1126_ = true;
        }
        let _e725 = phi_1125_;
        let _e727 = phi_1126_;
        if _e727 {
            phi_1130_ = _e703;
        } else {
            phi_1130_ = _e725;
        }
        let _e729 = phi_1130_;
        let _e733 = ((_e701 - (_e729 * 0.69314575f)) - (_e729 * 0.0000014286068f));
        phi_1168_ = ((((((((((((((((1f / 5040f) * _e733) + (1f / 720f)) * _e733) + (1f / 120f)) * _e733) + (1f / 24f)) * _e733) + (1f / 6f)) * _e733) + 0.5f) * _e733) + 1f) * _e733) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e729), i32(-2147483648), (_e729 < bitcast<f32>(3472883712u))), 2147483647i, (_e729 > bitcast<f32>(1325400063u))), (_e729 == _e729)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e769 = phi_1168_;
    let _e771 = (vec4<f32>(1f, 1f, 1f, 1f).x - _e538);
    let _e773 = (vec4<f32>(1f, 1f, 1f, 1f).y - _e615);
    let _e775 = (vec4<f32>(1f, 1f, 1f, 1f).z - _e692);
    let _e777 = (vec4<f32>(1f, 1f, 1f, 1f).w - _e769);
    let _e779 = (*param_4).min_variance;
    let _e781 = ((_e779 * _e452) * _e452);
    let _e792 = ((((_e771 * param_6.x) + (_e773 * param_6.y)) + (_e775 * param_6.z)) + (_e777 * param_6.w));
    let _e793 = (_e771 - _e792);
    let _e794 = (_e773 - _e792);
    let _e795 = (_e775 - _e792);
    let _e796 = (_e777 - _e792);
    let _e811 = (((((_e793 * _e793) * param_6.x) + ((_e794 * _e794) * param_6.y)) + ((_e795 * _e795) * param_6.z)) + ((_e796 * _e796) * param_6.w));
    if ((bitcast<u32>(_e781) & 2147483647u) > 2139095040u) {
        phi_1221_ = true;
    } else {
        let _e815 = (_e781 > _e811);
        if _e815 {
        }
        phi_1221_ = _e815;
    }
    let _e817 = phi_1221_;
    if _e817 {
        phi_1225_ = _e781;
    } else {
        phi_1225_ = _e811;
    }
    let _e819 = phi_1225_;
    let _e820 = -(_e792);
    if (_e820 <= 0f) {
        let _e824 = ((bitcast<u32>(_e819) & 2147483647u) > 2139095040u);
        if _e824 {
        }
        phi_1237_ = _e824;
    } else {
        phi_1237_ = true;
    }
    let _e826 = phi_1237_;
    if _e826 {
        phi_1244_ = (_e819 / (_e819 + (_e820 * _e820)));
    } else {
        phi_1244_ = 1f;
    }
    let _e831 = phi_1244_;
    if ((bitcast<u32>(_e831) & 2147483647u) > 2139095040u) {
        phi_1255_ = true;
    } else {
        let _e835 = (_e831 < _e442);
        if _e835 {
        }
        phi_1255_ = _e835;
    }
    let _e837 = phi_1255_;
    if _e837 {
        phi_1259_ = _e831;
    } else {
        phi_1259_ = _e442;
    }
    let _e839 = phi_1259_;
    if ((bitcast<u32>(_e839) & 2147483647u) > 2139095040u) {
        phi_1276_ = _e839;
    } else {
        if (_e839 < 0f) {
            phi_1275_ = 0f;
        } else {
            if (_e839 > 1f) {
                phi_1274_ = 1f;
            } else {
                phi_1274_ = _e839;
            }
            let _e846 = phi_1274_;
            phi_1275_ = _e846;
        }
        let _e848 = phi_1275_;
        phi_1276_ = _e848;
    }
    let _e850 = phi_1276_;
    return _e850;
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
            let _e62 = phi_199_;
            phi_200_ = _e62;
        }
        let _e64 = phi_200_;
        phi_201_ = _e64;
    }
    let _e66 = phi_201_;
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
            let _e74 = phi_217_;
            phi_218_ = _e74;
        }
        let _e76 = phi_218_;
        phi_219_ = _e76;
    }
    let _e78 = phi_219_;
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
            let _e86 = phi_235_;
            phi_236_ = _e86;
        }
        let _e88 = phi_236_;
        phi_237_ = _e88;
    }
    let _e90 = phi_237_;
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
            let _e98 = phi_253_;
            phi_254_ = _e98;
        }
        let _e100 = phi_254_;
        phi_255_ = _e100;
    }
    let _e102 = phi_255_;
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
            let _e110 = phi_271_;
            phi_272_ = _e110;
        }
        let _e112 = phi_272_;
        phi_273_ = _e112;
    }
    let _e114 = phi_273_;
    let _e115 = (_e78 - _e66);
    let _e116 = (_e90 - _e66);
    let _e117 = (_e102 - _e66);
    let _e118 = (_e114 - _e66);
    if (_e115 >= 0f) {
        if (_e116 >= 0f) {
            if (_e117 >= 0f) {
                if (_e118 >= 0f) {
                    phi_310_ = !(((bitcast<u32>(((((_e115 * param_9.x) + (_e116 * param_9.y)) + (_e117 * param_9.z)) + (_e118 * param_9.w))) & 2147483647u) > 2139095040u));
                    phi_311_ = false;
                } else {
                    phi_310_ = bool();
                    phi_311_ = true;
                }
                let _e140 = phi_310_;
                let _e142 = phi_311_;
                phi_312_ = _e140;
                phi_313_ = false;
                phi_314_ = _e142;
            } else {
                phi_312_ = bool();
                phi_313_ = true;
                phi_314_ = false;
            }
            let _e144 = phi_312_;
            let _e146 = phi_313_;
            let _e148 = phi_314_;
            phi_315_ = _e144;
            phi_316_ = _e146;
            phi_317_ = _e148;
        } else {
            phi_315_ = bool();
            phi_316_ = true;
            phi_317_ = false;
        }
        let _e150 = phi_315_;
        let _e152 = phi_316_;
        let _e154 = phi_317_;
        phi_318_ = _e150;
        phi_319_ = _e152;
        phi_320_ = _e154;
    } else {
        phi_318_ = bool();
        phi_319_ = true;
        phi_320_ = false;
    }
    let _e156 = phi_318_;
    let _e158 = phi_319_;
    let _e160 = phi_320_;
    if _e158 {
        phi_324_ = true;
    } else {
        phi_324_ = _e160;
    }
    let _e162 = phi_324_;
    if _e162 {
        phi_328_ = false;
    } else {
        phi_328_ = _e156;
    }
    let _e164 = phi_328_;
    if _e164 {
        phi_333_ = 1f;
    } else {
        let _e165 = _lt_math_evsm_Evsm_bound_of_offsets(param_7, vec4<f32>(_e115, _e116, _e117, _e118), param_9);
        phi_333_ = _e165;
    }
    let _e167 = phi_333_;
    return _e167;
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
    var phi_1874_: f32;
    var phi_1875_: f32;
    var phi_1878_: f32;
    var phi_1907_: f32;
    var phi_1912_: f32;
    var phi_1913_: bool;
    var phi_1914_: f32;
    var phi_1915_: bool;
    var phi_1919_: f32;
    var phi_1939_: f32;
    var phi_1944_: f32;
    var phi_1945_: bool;
    var phi_1946_: f32;
    var phi_1947_: bool;
    var phi_1951_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_2004_: i32;
    var phi_2009_: i32;
    var phi_2014_: i32;
    var phi_2019_: i32;
    var phi_2028_: i32;
    var phi_2033_: i32;
    var phi_2038_: i32;
    var phi_2043_: i32;
    var phi_2094_: bool;
    var phi_2102_: bool;
    var phi_2114_: bool;
    var phi_2115_: bool;
    var phi_2119_: f32;
    var phi_2125_: f32;
    var phi_2127_: evaluate_Verdict;
    var phi_2132_: evaluate_Verdict;
    var phi_2133_: evaluate_Verdict;

    let _e53 = id_1;
    let _e60 = arrayLength((&map.member));
    let _e66 = arrayLength((&levels.member));
    let _e69 = p.member.size[0u];
    let _e71 = p.member.size[1u];
    let _e72 = lt_shaders_entry_pixel_index(_e53, _e69, _e71);
    if (bitcast<i32>(_e72.root) != 0i) {
        let _e78 = p.member.level_count;
        if (_e72.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e85 = samples.member[(0u + _e72.first_primitive)].normal[0u];
        let _e87 = global[0u];
        if (_e85 == _e87) {
            let _e90 = samples.member[(0u + _e72.first_primitive)].normal[1u];
            let _e92 = global[1u];
            if (_e90 == _e92) {
                let _e95 = samples.member[(0u + _e72.first_primitive)].normal[2u];
                let _e97 = global[2u];
                phi_1336_ = (_e95 == _e97);
                phi_1337_ = false;
            } else {
                phi_1336_ = bool();
                phi_1337_ = true;
            }
            let _e100 = phi_1336_;
            let _e102 = phi_1337_;
            phi_1338_ = _e100;
            phi_1339_ = _e102;
        } else {
            phi_1338_ = bool();
            phi_1339_ = true;
        }
        let _e104 = phi_1338_;
        let _e106 = phi_1339_;
        if _e106 {
            phi_1343_ = false;
        } else {
            phi_1343_ = _e104;
        }
        let _e108 = phi_1343_;
        if !(_e108) {
            let _e111 = samples.member[(0u + _e72.first_primitive)].position;
            let _e113 = p.member.light.place;
            let _e119 = p.member.light.place[3u];
            let _e126 = (_e113.x - (_e111.x * _e119));
            let _e127 = (_e113.y - (_e111.y * _e119));
            let _e128 = (_e113.z - (_e111.z * _e119));
            let _e130 = samples.member[(0u + _e72.first_primitive)].normal;
            if ((((_e130.x * _e126) + (_e130.y * _e127)) + (_e130.z * _e128)) > 0f) {
                let _e144 = (((_e126 * _e126) + (_e127 * _e127)) + (_e128 * _e128));
                let _e146 = p.member.light.axis;
                let _e158 = p.member.light.place[3u];
                if (_e158 == 0f) {
                    phi_1414_ = true;
                } else {
                    let _e161 = p.member.light.range_squared;
                    if (_e144 <= _e161) {
                        let _e164 = p.member.light.cos_outer;
                        phi_1413_ = (-((((_e126 * _e146.x) + (_e127 * _e146.y)) + (_e128 * _e146.z))) >= (_e164 * sqrt(_e144)));
                    } else {
                        phi_1413_ = false;
                    }
                    let _e169 = phi_1413_;
                    phi_1414_ = _e169;
                }
                let _e171 = phi_1414_;
                if _e171 {
                    let _e173 = samples.member[(0u + _e72.first_primitive)].flags;
                    let _e181 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e187 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e181.unnamed.visibility, false), _e181.unnamed_1);
                    phi_1425_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e187.unnamed, ((_e173 & 1u) == 0u));
                    phi_1426_ = false;
                } else {
                    phi_1425_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_1426_ = true;
                }
                let _e192 = phi_1425_;
                let _e194 = phi_1426_;
                phi_1427_ = _e192;
                phi_1428_ = _e194;
            } else {
                phi_1427_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_1428_ = true;
            }
            let _e196 = phi_1427_;
            let _e198 = phi_1428_;
            if _e198 {
                let _e204 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e210 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e204.unnamed.visibility, false), _e204.unnamed_1);
                phi_1435_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e210.unnamed, true);
            } else {
                phi_1435_ = _e196;
            }
            let _e215 = phi_1435_;
            phi_1439_ = _e215;
        } else {
            let _e221 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e227 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e221.unnamed.visibility, false), _e221.unnamed_1);
            phi_1439_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e227.unnamed, true);
        }
        let _e232 = phi_1439_;
        if _e232.unnamed_1 {
            phi_2133_ = evaluate_Verdict(_e232.unnamed.visibility, _e232.unnamed.is_doubted);
        } else {
            let _e240 = samples.member[(0u + _e72.first_primitive)].position;
            let _e242 = p.member.map_size;
            let _e244 = (0.5f / f32(_e242));
            let _e251 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e258 = lt_math_LightPoint(vec2<f32>(_e251.uv.x, 0f), _e251.depth, _e251.is_inside);
            let _e262 = lt_math_LightPoint(_e258.uv, 0f, _e258.is_inside);
            phi_1459_ = lt_math_LightPoint();
            phi_1462_ = 0u;
            phi_1464_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e262.uv, _e262.depth, false));
            loop {
                let _e269 = phi_1459_;
                let _e271 = phi_1462_;
                let _e273 = phi_1464_;
                local_1 = _e273;
                local_2 = _e273;
                local_3 = _e273;
                if (_e271 < _e78) {
                    if _e273.point.is_inside {
                        phi_1625_ = lt_math_LightPoint();
                        phi_1626_ = u32();
                        phi_1627_ = lt_math_LevelPoint();
                        phi_1628_ = false;
                    } else {
                        if (_e271 < _e66) {
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
                                phi_1550_ = (_e309 <= 1f);
                            } else {
                                phi_1550_ = false;
                            }
                            let _e341 = phi_1550_;
                            if _e341 {
                                if (_e323 >= 0f) {
                                    phi_1559_ = (_e323 <= 1f);
                                } else {
                                    phi_1559_ = false;
                                }
                                let _e345 = phi_1559_;
                                if _e345 {
                                    if (_e336 >= 0f) {
                                        phi_1568_ = (_e336 <= 1f);
                                    } else {
                                        phi_1568_ = false;
                                    }
                                    let _e349 = phi_1568_;
                                    phi_1569_ = _e349;
                                    phi_1570_ = false;
                                } else {
                                    phi_1569_ = bool();
                                    phi_1570_ = true;
                                }
                                let _e351 = phi_1569_;
                                let _e353 = phi_1570_;
                                phi_1571_ = _e351;
                                phi_1572_ = _e353;
                            } else {
                                phi_1571_ = bool();
                                phi_1572_ = true;
                            }
                            let _e355 = phi_1571_;
                            let _e357 = phi_1572_;
                            phi_1573_ = _e355;
                            phi_1574_ = _e357;
                        } else {
                            phi_1573_ = bool();
                            phi_1574_ = true;
                        }
                        let _e359 = phi_1573_;
                        let _e361 = phi_1574_;
                        if _e361 {
                            phi_1578_ = false;
                        } else {
                            phi_1578_ = _e359;
                        }
                        let _e363 = phi_1578_;
                        if _e363 {
                            if (_e309 >= _e244) {
                                if (_e309 <= (1f - _e244)) {
                                    if (_e323 >= _e244) {
                                        phi_1605_ = (_e323 <= (1f - _e244));
                                        phi_1606_ = false;
                                    } else {
                                        phi_1605_ = bool();
                                        phi_1606_ = true;
                                    }
                                    let _e371 = phi_1605_;
                                    let _e373 = phi_1606_;
                                    phi_1607_ = _e371;
                                    phi_1608_ = _e373;
                                } else {
                                    phi_1607_ = bool();
                                    phi_1608_ = true;
                                }
                                let _e375 = phi_1607_;
                                let _e377 = phi_1608_;
                                phi_1609_ = _e375;
                                phi_1610_ = _e377;
                            } else {
                                phi_1609_ = bool();
                                phi_1610_ = true;
                            }
                            let _e379 = phi_1609_;
                            let _e381 = phi_1610_;
                            phi_1611_ = _e379;
                            phi_1612_ = _e381;
                        } else {
                            phi_1611_ = bool();
                            phi_1612_ = true;
                        }
                        let _e383 = phi_1611_;
                        let _e385 = phi_1612_;
                        if _e385 {
                            phi_1616_ = false;
                        } else {
                            phi_1616_ = _e383;
                        }
                        let _e387 = phi_1616_;
                        let _e394 = lt_math_LightPoint(vec2<f32>(_e309, _e269.uv.y), _e269.depth, _e269.is_inside);
                        let _e401 = lt_math_LightPoint(vec2<f32>(_e394.uv.x, _e323), _e394.depth, _e394.is_inside);
                        let _e405 = lt_math_LightPoint(_e401.uv, _e336, _e401.is_inside);
                        let _e409 = lt_math_LightPoint(_e405.uv, _e405.depth, _e387);
                        phi_1625_ = _e409;
                        phi_1626_ = (_e271 + 1u);
                        phi_1627_ = lt_math_LevelPoint(_e271, _e409);
                        phi_1628_ = true;
                    }
                    let _e413 = phi_1625_;
                    let _e415 = phi_1626_;
                    let _e417 = phi_1627_;
                    let _e419 = phi_1628_;
                    phi_1460_ = _e413;
                    phi_1463_ = _e415;
                    phi_1465_ = _e417;
                    phi_1629_ = _e419;
                } else {
                    phi_1460_ = lt_math_LightPoint();
                    phi_1463_ = u32();
                    phi_1465_ = lt_math_LevelPoint();
                    phi_1629_ = false;
                }
                let _e421 = phi_1460_;
                let _e423 = phi_1463_;
                let _e425 = phi_1465_;
                let _e427 = phi_1629_;
                continue;
                continuing {
                    phi_1459_ = _e421;
                    phi_1462_ = _e423;
                    phi_1464_ = _e425;
                    break if !(_e427);
                }
            }
            let _e430 = local_1;
            if _e430.point.is_inside {
                if (0f > 0f) {
                    let _e436 = local_2;
                    if (_e436.level < _e66) {
                    } else {
                        return;
                    }
                    let _e441 = levels.member[(0u + _e436.level)];
                    let _e447 = global[0u];
                    if (_e441.row_w.x == _e447) {
                        let _e450 = global[1u];
                        if (_e441.row_w.y == _e450) {
                            let _e453 = global[2u];
                            phi_1669_ = (_e441.row_w.z == _e453);
                            phi_1670_ = false;
                        } else {
                            phi_1669_ = bool();
                            phi_1670_ = true;
                        }
                        let _e456 = phi_1669_;
                        let _e458 = phi_1670_;
                        phi_1671_ = _e456;
                        phi_1672_ = _e458;
                    } else {
                        phi_1671_ = bool();
                        phi_1672_ = true;
                    }
                    let _e460 = phi_1671_;
                    let _e462 = phi_1672_;
                    if _e462 {
                        phi_1676_ = false;
                    } else {
                        phi_1676_ = _e460;
                    }
                    let _e464 = phi_1676_;
                    if _e464 {
                        let _e466 = samples.member[(0u + _e72.first_primitive)].normal;
                        let _e468 = p.member.map_size;
                        let _e538 = ((abs(((((_e441.row_x.x * _e466.x) + (_e441.row_x.y * _e466.y)) + (_e441.row_x.z * _e466.z)) / (((_e441.row_x.x * _e441.row_x.x) + (_e441.row_x.y * _e441.row_x.y)) + (_e441.row_x.z * _e441.row_x.z)))) + abs(((((_e441.row_y.x * _e466.x) + (_e441.row_y.y * _e466.y)) + (_e441.row_y.z * _e466.z)) / (((_e441.row_y.x * _e441.row_y.x) + (_e441.row_y.y * _e441.row_y.y)) + (_e441.row_y.z * _e441.row_y.z))))) / (abs(((((_e441.row_z.x * _e466.x) + (_e441.row_z.y * _e466.y)) + (_e441.row_z.z * _e466.z)) / (((_e441.row_z.x * _e441.row_z.x) + (_e441.row_z.y * _e441.row_z.y)) + (_e441.row_z.z * _e441.row_z.z)))) * f32(_e468)));
                        if (_e538 < 0.002f) {
                            phi_1758_ = _e538;
                        } else {
                            phi_1758_ = 0.002f;
                        }
                        let _e541 = phi_1758_;
                        phi_1875_ = _e541;
                    } else {
                        let _e543 = p.member.map_size;
                        let _e549 = samples.member[(0u + _e72.first_primitive)].position;
                        let _e560 = ((((_e441.row_w.x * _e549.x) + (_e441.row_w.y * _e549.y)) + (_e441.row_w.z * _e549.z)) + _e441.row_w.w);
                        let _e573 = ((_e441.row_x.x - (_e441.row_w.x * _e430.point.uv.x)) / _e560);
                        let _e574 = ((_e441.row_x.y - (_e441.row_w.y * _e430.point.uv.x)) / _e560);
                        let _e575 = ((_e441.row_x.z - (_e441.row_w.z * _e430.point.uv.x)) / _e560);
                        let _e588 = ((_e441.row_y.x - (_e441.row_w.x * _e430.point.uv.y)) / _e560);
                        let _e589 = ((_e441.row_y.y - (_e441.row_w.y * _e430.point.uv.y)) / _e560);
                        let _e590 = ((_e441.row_y.z - (_e441.row_w.z * _e430.point.uv.y)) / _e560);
                        let _e596 = samples.member[(0u + _e72.first_primitive)].normal;
                        let _e601 = ((_e589 * _e596.z) - (_e596.y * _e590));
                        let _e606 = ((_e590 * _e596.x) - (_e596.z * _e588));
                        let _e611 = ((_e588 * _e596.y) - (_e596.x * _e589));
                        let _e613 = samples.member[(0u + _e72.first_primitive)].normal;
                        let _e618 = ((_e574 * _e613.z) - (_e613.y * _e575));
                        let _e623 = ((_e575 * _e613.x) - (_e613.z * _e573));
                        let _e628 = ((_e573 * _e613.y) - (_e613.x * _e574));
                        let _e655 = ((abs(((((_e441.row_z.x * _e601) + (_e441.row_z.y * _e606)) + (_e441.row_z.z * _e611)) / (((_e573 * _e601) + (_e574 * _e606)) + (_e575 * _e611)))) + abs(((((_e441.row_z.x * _e618) + (_e441.row_z.y * _e623)) + (_e441.row_z.z * _e628)) / (((_e588 * _e618) + (_e589 * _e623)) + (_e590 * _e628))))) / f32(_e543));
                        if (_e655 < 0.002f) {
                            phi_1874_ = _e655;
                        } else {
                            phi_1874_ = 0.002f;
                        }
                        let _e658 = phi_1874_;
                        phi_1875_ = _e658;
                    }
                    let _e660 = phi_1875_;
                    phi_1878_ = (_e430.point.depth - (0f * _e660));
                } else {
                    phi_1878_ = _e430.point.depth;
                }
                let _e664 = phi_1878_;
                let _e670 = p.member.map_size;
                let _e671 = f32(_e670);
                let _e674 = ((_e430.point.uv.x * _e671) - 0.5f);
                let _e675 = ((_e430.point.uv.y * _e671) - 0.5f);
                if (_e674 > -8388608f) {
                    let _e687 = f32(select(0i, select(select(i32(_e674), i32(-2147483648), (_e674 < bitcast<f32>(3472883712u))), 2147483647i, (_e674 > bitcast<f32>(1325400063u))), (_e674 == _e674)));
                    if (_e687 > _e674) {
                        phi_1907_ = 1f;
                    } else {
                        phi_1907_ = 0f;
                    }
                    let _e690 = phi_1907_;
                    if (_e674 < 8388608f) {
                        phi_1912_ = (_e687 - _e690);
                        phi_1913_ = false;
                    } else {
                        phi_1912_ = f32();
                        phi_1913_ = true;
                    }
                    let _e693 = phi_1912_;
                    let _e695 = phi_1913_;
                    phi_1914_ = _e693;
                    phi_1915_ = _e695;
                } else {
                    phi_1914_ = f32();
                    phi_1915_ = true;
                }
                let _e697 = phi_1914_;
                let _e699 = phi_1915_;
                if _e699 {
                    phi_1919_ = _e674;
                } else {
                    phi_1919_ = _e697;
                }
                let _e701 = phi_1919_;
                if (_e675 > -8388608f) {
                    let _e713 = f32(select(0i, select(select(i32(_e675), i32(-2147483648), (_e675 < bitcast<f32>(3472883712u))), 2147483647i, (_e675 > bitcast<f32>(1325400063u))), (_e675 == _e675)));
                    if (_e713 > _e675) {
                        phi_1939_ = 1f;
                    } else {
                        phi_1939_ = 0f;
                    }
                    let _e716 = phi_1939_;
                    if (_e675 < 8388608f) {
                        phi_1944_ = (_e713 - _e716);
                        phi_1945_ = false;
                    } else {
                        phi_1944_ = f32();
                        phi_1945_ = true;
                    }
                    let _e719 = phi_1944_;
                    let _e721 = phi_1945_;
                    phi_1946_ = _e719;
                    phi_1947_ = _e721;
                } else {
                    phi_1946_ = f32();
                    phi_1947_ = true;
                }
                let _e723 = phi_1946_;
                let _e725 = phi_1947_;
                if _e725 {
                    phi_1951_ = _e675;
                } else {
                    phi_1951_ = _e723;
                }
                let _e727 = phi_1951_;
                let _e728 = (_e674 - _e701);
                let _e729 = (_e675 - _e727);
                let _e738 = select(0i, select(select(i32(_e701), i32(-2147483648), (_e701 < bitcast<f32>(3472883712u))), 2147483647i, (_e701 > bitcast<f32>(1325400063u))), (_e701 == _e701));
                let _e747 = select(0i, select(select(i32(_e727), i32(-2147483648), (_e727 < bitcast<f32>(3472883712u))), 2147483647i, (_e727 > bitcast<f32>(1325400063u))), (_e727 == _e727));
                let _e758 = p.member.test;
                let _e759 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e758);
                let _e761 = p.member.map_size;
                let _e763 = local_3;
                local = lt_math_Evsm(_e759.positive_exponent, _e759.negative_exponent, _e759.min_variance);
                let _e770 = ((_e763.level * _e761) * _e761);
                let _e772 = (bitcast<i32>(_e761) - 1i);
                if (_e738 > 0i) {
                    phi_2004_ = _e738;
                } else {
                    phi_2004_ = 0i;
                }
                let _e775 = phi_2004_;
                if (_e747 > 0i) {
                    phi_2009_ = _e747;
                } else {
                    phi_2009_ = 0i;
                }
                let _e778 = phi_2009_;
                if (_e775 < _e772) {
                    phi_2014_ = _e775;
                } else {
                    phi_2014_ = _e772;
                }
                let _e781 = phi_2014_;
                if (_e778 < _e772) {
                    phi_2019_ = _e778;
                } else {
                    phi_2019_ = _e772;
                }
                let _e784 = phi_2019_;
                let _e785 = bitcast<u32>(_e781);
                let _e787 = (_e738 + 1i);
                let _e788 = (_e747 + 1i);
                if (_e787 > 0i) {
                    phi_2028_ = _e787;
                } else {
                    phi_2028_ = 0i;
                }
                let _e791 = phi_2028_;
                if (_e788 > 0i) {
                    phi_2033_ = _e788;
                } else {
                    phi_2033_ = 0i;
                }
                let _e794 = phi_2033_;
                if (_e791 < _e772) {
                    phi_2038_ = _e791;
                } else {
                    phi_2038_ = _e772;
                }
                let _e797 = phi_2038_;
                if (_e794 < _e772) {
                    phi_2043_ = _e794;
                } else {
                    phi_2043_ = _e772;
                }
                let _e800 = phi_2043_;
                let _e801 = bitcast<u32>(_e797);
                let _e803 = (bitcast<u32>(_e784) * _e761);
                let _e804 = (bitcast<u32>(_e800) * _e761);
                let _e809 = ((_e803 + _e785) + _e770);
                let _e810 = ((_e803 + _e801) + _e770);
                let _e811 = ((_e804 + _e785) + _e770);
                let _e812 = ((_e804 + _e801) + _e770);
                if (_e809 < _e60) {
                } else {
                    return;
                }
                let _e816 = map.member[(0u + _e809)];
                if (_e810 < _e60) {
                } else {
                    return;
                }
                let _e820 = map.member[(0u + _e810)];
                if (_e811 < _e60) {
                } else {
                    return;
                }
                let _e824 = map.member[(0u + _e811)];
                if (_e812 < _e60) {
                } else {
                    return;
                }
                let _e828 = map.member[(0u + _e812)];
                let _e830 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e816, _e820, _e824, _e828), vec4<f32>(((1f - _e728) * (1f - _e729)), (_e728 * (1f - _e729)), ((1f - _e728) * _e729), (_e728 * _e729)), _e664);
                let _e832 = p.member.epsilon;
                if (_e830 <= _e832) {
                    phi_2094_ = true;
                } else {
                    phi_2094_ = (_e830 >= (1f - _e832));
                }
                let _e837 = phi_2094_;
                if ((bitcast<u32>(_e830) & 2147483647u) > 2139095040u) {
                    phi_2102_ = true;
                } else {
                    phi_2102_ = !(_e837);
                }
                let _e843 = phi_2102_;
                if _e843 {
                    if (_e830 > 0f) {
                        if (_e830 < 1f) {
                            phi_2114_ = false;
                        } else {
                            phi_2114_ = true;
                        }
                        let _e847 = phi_2114_;
                        phi_2115_ = _e847;
                    } else {
                        phi_2115_ = true;
                    }
                    let _e849 = phi_2115_;
                    if _e849 {
                        phi_2119_ = 0.5f;
                    } else {
                        phi_2119_ = _e830;
                    }
                    let _e851 = phi_2119_;
                    phi_2127_ = evaluate_Verdict(_e851, true);
                } else {
                    if (_e830 > 0.5f) {
                        phi_2125_ = 1f;
                    } else {
                        phi_2125_ = 0f;
                    }
                    let _e855 = phi_2125_;
                    phi_2127_ = evaluate_Verdict(_e855, false);
                }
                let _e858 = phi_2127_;
                phi_2132_ = evaluate_Verdict(_e858.visibility, _e858.is_doubted);
            } else {
                phi_2132_ = evaluate_Verdict(0.5f, true);
            }
            let _e864 = phi_2132_;
            phi_2133_ = _e864;
        }
        let _e866 = phi_2133_;
        if (_e72.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e72.first_primitive)] = _e866.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_evsm_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
