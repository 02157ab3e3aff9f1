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
    var phi_161_: lt_bvh_traverse_Tree;
    var phi_162_: bool;
    var phi_163_: lt_bvh_traverse_Tree;
    var phi_164_: bool;
    var phi_169_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_161_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_162_ = false;
        } else {
            phi_161_ = lt_bvh_traverse_Tree();
            phi_162_ = true;
        }
        let _e65 = phi_161_;
        let _e67 = phi_162_;
        phi_163_ = _e65;
        phi_164_ = _e67;
    } else {
        phi_163_ = lt_bvh_traverse_Tree();
        phi_164_ = true;
    }
    let _e69 = phi_163_;
    let _e71 = phi_164_;
    if _e71 {
        phi_169_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_169_ = _e69;
    }
    let _e76 = phi_169_;
    return lt_bvh_traverse_Tree(_e76.root, _e76.first_primitive);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> lt_math_Evsm {
    return lt_math_Evsm(param_3.x, param_3.y, param_3.z);
}

fn _lt_math_evsm_Evsm_bound_of_offsets(param_4: ptr<function, lt_math_Evsm>, param_5: vec4<f32>, param_6: vec4<f32>) -> f32 {
    var phi_349_: bool;
    var phi_353_: f32;
    var phi_372_: f32;
    var phi_377_: f32;
    var phi_399_: f32;
    var phi_404_: f32;
    var phi_405_: bool;
    var phi_406_: f32;
    var phi_407_: bool;
    var phi_411_: f32;
    var phi_449_: f32;
    var phi_460_: f32;
    var phi_465_: f32;
    var phi_487_: f32;
    var phi_492_: f32;
    var phi_493_: bool;
    var phi_494_: f32;
    var phi_495_: bool;
    var phi_499_: f32;
    var phi_537_: f32;
    var phi_548_: f32;
    var phi_553_: f32;
    var phi_575_: f32;
    var phi_580_: f32;
    var phi_581_: bool;
    var phi_582_: f32;
    var phi_583_: bool;
    var phi_587_: f32;
    var phi_625_: f32;
    var phi_636_: f32;
    var phi_641_: f32;
    var phi_663_: f32;
    var phi_668_: f32;
    var phi_669_: bool;
    var phi_670_: f32;
    var phi_671_: bool;
    var phi_675_: f32;
    var phi_713_: f32;
    var phi_766_: bool;
    var phi_770_: f32;
    var phi_782_: bool;
    var phi_789_: f32;
    var phi_802_: bool;
    var phi_806_: f32;
    var phi_826_: f32;
    var phi_831_: f32;
    var phi_853_: f32;
    var phi_858_: f32;
    var phi_859_: bool;
    var phi_860_: f32;
    var phi_861_: bool;
    var phi_865_: f32;
    var phi_903_: f32;
    var phi_914_: f32;
    var phi_919_: f32;
    var phi_941_: f32;
    var phi_946_: f32;
    var phi_947_: bool;
    var phi_948_: f32;
    var phi_949_: bool;
    var phi_953_: f32;
    var phi_991_: f32;
    var phi_1002_: f32;
    var phi_1007_: f32;
    var phi_1029_: f32;
    var phi_1034_: f32;
    var phi_1035_: bool;
    var phi_1036_: f32;
    var phi_1037_: bool;
    var phi_1041_: f32;
    var phi_1079_: f32;
    var phi_1090_: f32;
    var phi_1095_: f32;
    var phi_1117_: f32;
    var phi_1122_: f32;
    var phi_1123_: bool;
    var phi_1124_: f32;
    var phi_1125_: bool;
    var phi_1129_: f32;
    var phi_1167_: f32;
    var phi_1220_: bool;
    var phi_1224_: f32;
    var phi_1236_: bool;
    var phi_1243_: f32;
    var phi_1254_: bool;
    var phi_1258_: f32;
    var phi_1273_: f32;
    var phi_1274_: f32;
    var phi_1275_: f32;

    let _e56 = (*param_4).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_349_ = true;
    } else {
        let _e60 = (42f < _e56);
        if _e60 {
        }
        phi_349_ = _e60;
    }
    let _e62 = phi_349_;
    if _e62 {
        phi_353_ = 42f;
    } else {
        phi_353_ = _e56;
    }
    let _e64 = phi_353_;
    let _e66 = (_e64 * param_5.x);
    let _e68 = (_e64 * param_5.y);
    let _e70 = (_e64 * param_5.z);
    let _e72 = (_e64 * param_5.w);
    if ((bitcast<u32>(_e66) & 2147483647u) > 2139095040u) {
        phi_449_ = _e66;
    } else {
        if (_e66 < -87f) {
            phi_372_ = -87f;
        } else {
            phi_372_ = _e66;
        }
        let _e78 = phi_372_;
        if (_e78 > 88f) {
            phi_377_ = 88f;
        } else {
            phi_377_ = _e78;
        }
        let _e81 = phi_377_;
        let _e83 = ((_e81 * 1.442695f) + 0.5f);
        if (_e83 > -8388608f) {
            let _e95 = f32(select(0i, select(select(i32(_e83), i32(-2147483648), (_e83 < bitcast<f32>(3472883712u))), 2147483647i, (_e83 > bitcast<f32>(1325400063u))), (_e83 == _e83)));
            if (_e95 > _e83) {
                phi_399_ = 1f;
            } else {
                phi_399_ = 0f;
            }
            let _e98 = phi_399_;
            if (_e83 < 8388608f) {
                phi_404_ = (_e95 - _e98);
                phi_405_ = false;
            } else {
                phi_404_ = f32();
                phi_405_ = true;
            }
            let _e101 = phi_404_;
            let _e103 = phi_405_;
            phi_406_ = _e101;
            phi_407_ = _e103;
        } else {
            phi_406_ = f32();
            phi_407_ = true;
        }
        let _e105 = phi_406_;
        let _e107 = phi_407_;
        if _e107 {
            phi_411_ = _e83;
        } else {
            phi_411_ = _e105;
        }
        let _e109 = phi_411_;
        let _e113 = ((_e81 - (_e109 * 0.69314575f)) - (_e109 * 0.0000014286068f));
        phi_449_ = ((((((((((((((((1f / 5040f) * _e113) + (1f / 720f)) * _e113) + (1f / 120f)) * _e113) + (1f / 24f)) * _e113) + (1f / 6f)) * _e113) + 0.5f) * _e113) + 1f) * _e113) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e109), i32(-2147483648), (_e109 < bitcast<f32>(3472883712u))), 2147483647i, (_e109 > bitcast<f32>(1325400063u))), (_e109 == _e109)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e149 = phi_449_;
    if ((bitcast<u32>(_e68) & 2147483647u) > 2139095040u) {
        phi_537_ = _e68;
    } else {
        if (_e68 < -87f) {
            phi_460_ = -87f;
        } else {
            phi_460_ = _e68;
        }
        let _e155 = phi_460_;
        if (_e155 > 88f) {
            phi_465_ = 88f;
        } else {
            phi_465_ = _e155;
        }
        let _e158 = phi_465_;
        let _e160 = ((_e158 * 1.442695f) + 0.5f);
        if (_e160 > -8388608f) {
            let _e172 = f32(select(0i, select(select(i32(_e160), i32(-2147483648), (_e160 < bitcast<f32>(3472883712u))), 2147483647i, (_e160 > bitcast<f32>(1325400063u))), (_e160 == _e160)));
            if (_e172 > _e160) {
                phi_487_ = 1f;
            } else {
                phi_487_ = 0f;
            }
            let _e175 = phi_487_;
            if (_e160 < 8388608f) {
                phi_492_ = (_e172 - _e175);
                phi_493_ = false;
            } else {
                phi_492_ = f32();
                phi_493_ = true;
            }
            let _e178 = phi_492_;
            let _e180 = phi_493_;
            phi_494_ = _e178;
            phi_495_ = _e180;
        } else {
            phi_494_ = f32();
            phi_495_ = true;
        }
        let _e182 = phi_494_;
        let _e184 = phi_495_;
        if _e184 {
            phi_499_ = _e160;
        } else {
            phi_499_ = _e182;
        }
        let _e186 = phi_499_;
        let _e190 = ((_e158 - (_e186 * 0.69314575f)) - (_e186 * 0.0000014286068f));
        phi_537_ = ((((((((((((((((1f / 5040f) * _e190) + (1f / 720f)) * _e190) + (1f / 120f)) * _e190) + (1f / 24f)) * _e190) + (1f / 6f)) * _e190) + 0.5f) * _e190) + 1f) * _e190) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e186), i32(-2147483648), (_e186 < bitcast<f32>(3472883712u))), 2147483647i, (_e186 > bitcast<f32>(1325400063u))), (_e186 == _e186)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e226 = phi_537_;
    if ((bitcast<u32>(_e70) & 2147483647u) > 2139095040u) {
        phi_625_ = _e70;
    } else {
        if (_e70 < -87f) {
            phi_548_ = -87f;
        } else {
            phi_548_ = _e70;
        }
        let _e232 = phi_548_;
        if (_e232 > 88f) {
            phi_553_ = 88f;
        } else {
            phi_553_ = _e232;
        }
        let _e235 = phi_553_;
        let _e237 = ((_e235 * 1.442695f) + 0.5f);
        if (_e237 > -8388608f) {
            let _e249 = f32(select(0i, select(select(i32(_e237), i32(-2147483648), (_e237 < bitcast<f32>(3472883712u))), 2147483647i, (_e237 > bitcast<f32>(1325400063u))), (_e237 == _e237)));
            if (_e249 > _e237) {
                phi_575_ = 1f;
            } else {
                phi_575_ = 0f;
            }
            let _e252 = phi_575_;
            if (_e237 < 8388608f) {
                phi_580_ = (_e249 - _e252);
                phi_581_ = false;
            } else {
                phi_580_ = f32();
                phi_581_ = true;
            }
            let _e255 = phi_580_;
            let _e257 = phi_581_;
            phi_582_ = _e255;
            phi_583_ = _e257;
        } else {
            phi_582_ = f32();
            phi_583_ = true;
        }
        let _e259 = phi_582_;
        let _e261 = phi_583_;
        if _e261 {
            phi_587_ = _e237;
        } else {
            phi_587_ = _e259;
        }
        let _e263 = phi_587_;
        let _e267 = ((_e235 - (_e263 * 0.69314575f)) - (_e263 * 0.0000014286068f));
        phi_625_ = ((((((((((((((((1f / 5040f) * _e267) + (1f / 720f)) * _e267) + (1f / 120f)) * _e267) + (1f / 24f)) * _e267) + (1f / 6f)) * _e267) + 0.5f) * _e267) + 1f) * _e267) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e263), i32(-2147483648), (_e263 < bitcast<f32>(3472883712u))), 2147483647i, (_e263 > bitcast<f32>(1325400063u))), (_e263 == _e263)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e303 = phi_625_;
    if ((bitcast<u32>(_e72) & 2147483647u) > 2139095040u) {
        phi_713_ = _e72;
    } else {
        if (_e72 < -87f) {
            phi_636_ = -87f;
        } else {
            phi_636_ = _e72;
        }
        let _e309 = phi_636_;
        if (_e309 > 88f) {
            phi_641_ = 88f;
        } else {
            phi_641_ = _e309;
        }
        let _e312 = phi_641_;
        let _e314 = ((_e312 * 1.442695f) + 0.5f);
        if (_e314 > -8388608f) {
            let _e326 = f32(select(0i, select(select(i32(_e314), i32(-2147483648), (_e314 < bitcast<f32>(3472883712u))), 2147483647i, (_e314 > bitcast<f32>(1325400063u))), (_e314 == _e314)));
            if (_e326 > _e314) {
                phi_663_ = 1f;
            } else {
                phi_663_ = 0f;
            }
            let _e329 = phi_663_;
            if (_e314 < 8388608f) {
                phi_668_ = (_e326 - _e329);
                phi_669_ = false;
            } else {
                phi_668_ = f32();
                phi_669_ = true;
            }
            let _e332 = phi_668_;
            let _e334 = phi_669_;
            phi_670_ = _e332;
            phi_671_ = _e334;
        } else {
            phi_670_ = f32();
            phi_671_ = true;
        }
        let _e336 = phi_670_;
        let _e338 = phi_671_;
        if _e338 {
            phi_675_ = _e314;
        } else {
            phi_675_ = _e336;
        }
        let _e340 = phi_675_;
        let _e344 = ((_e312 - (_e340 * 0.69314575f)) - (_e340 * 0.0000014286068f));
        phi_713_ = ((((((((((((((((1f / 5040f) * _e344) + (1f / 720f)) * _e344) + (1f / 120f)) * _e344) + (1f / 24f)) * _e344) + (1f / 6f)) * _e344) + 0.5f) * _e344) + 1f) * _e344) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e340), i32(-2147483648), (_e340 < bitcast<f32>(3472883712u))), 2147483647i, (_e340 > bitcast<f32>(1325400063u))), (_e340 == _e340)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e380 = phi_713_;
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
        phi_766_ = true;
    } else {
        let _e426 = (_e392 > _e422);
        if _e426 {
        }
        phi_766_ = _e426;
    }
    let _e428 = phi_766_;
    if _e428 {
        phi_770_ = _e392;
    } else {
        phi_770_ = _e422;
    }
    let _e430 = phi_770_;
    let _e431 = -(_e403);
    if (_e431 <= 0f) {
        let _e435 = ((bitcast<u32>(_e430) & 2147483647u) > 2139095040u);
        if _e435 {
        }
        phi_782_ = _e435;
    } else {
        phi_782_ = true;
    }
    let _e437 = phi_782_;
    if _e437 {
        phi_789_ = (_e430 / (_e430 + (_e431 * _e431)));
    } else {
        phi_789_ = 1f;
    }
    let _e442 = phi_789_;
    let _e444 = (*param_4).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_802_ = true;
    } else {
        let _e448 = (42f < _e444);
        if _e448 {
        }
        phi_802_ = _e448;
    }
    let _e450 = phi_802_;
    if _e450 {
        phi_806_ = 42f;
    } else {
        phi_806_ = _e444;
    }
    let _e452 = phi_806_;
    let _e453 = -(_e452);
    let _e455 = (_e453 * param_5.x);
    let _e457 = (_e453 * param_5.y);
    let _e459 = (_e453 * param_5.z);
    let _e461 = (_e453 * param_5.w);
    if ((bitcast<u32>(_e455) & 2147483647u) > 2139095040u) {
        phi_903_ = _e455;
    } else {
        if (_e455 < -87f) {
            phi_826_ = -87f;
        } else {
            phi_826_ = _e455;
        }
        let _e467 = phi_826_;
        if (_e467 > 88f) {
            phi_831_ = 88f;
        } else {
            phi_831_ = _e467;
        }
        let _e470 = phi_831_;
        let _e472 = ((_e470 * 1.442695f) + 0.5f);
        if (_e472 > -8388608f) {
            let _e484 = f32(select(0i, select(select(i32(_e472), i32(-2147483648), (_e472 < bitcast<f32>(3472883712u))), 2147483647i, (_e472 > bitcast<f32>(1325400063u))), (_e472 == _e472)));
            if (_e484 > _e472) {
                phi_853_ = 1f;
            } else {
                phi_853_ = 0f;
            }
            let _e487 = phi_853_;
            if (_e472 < 8388608f) {
                phi_858_ = (_e484 - _e487);
                phi_859_ = false;
            } else {
                phi_858_ = f32();
                phi_859_ = true;
            }
            let _e490 = phi_858_;
            let _e492 = phi_859_;
            phi_860_ = _e490;
            phi_861_ = _e492;
        } else {
            phi_860_ = f32();
            phi_861_ = true;
        }
        let _e494 = phi_860_;
        let _e496 = phi_861_;
        if _e496 {
            phi_865_ = _e472;
        } else {
            phi_865_ = _e494;
        }
        let _e498 = phi_865_;
        let _e502 = ((_e470 - (_e498 * 0.69314575f)) - (_e498 * 0.0000014286068f));
        phi_903_ = ((((((((((((((((1f / 5040f) * _e502) + (1f / 720f)) * _e502) + (1f / 120f)) * _e502) + (1f / 24f)) * _e502) + (1f / 6f)) * _e502) + 0.5f) * _e502) + 1f) * _e502) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e498), i32(-2147483648), (_e498 < bitcast<f32>(3472883712u))), 2147483647i, (_e498 > bitcast<f32>(1325400063u))), (_e498 == _e498)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e538 = phi_903_;
    if ((bitcast<u32>(_e457) & 2147483647u) > 2139095040u) {
        phi_991_ = _e457;
    } else {
        if (_e457 < -87f) {
            phi_914_ = -87f;
        } else {
            phi_914_ = _e457;
        }
        let _e544 = phi_914_;
        if (_e544 > 88f) {
            phi_919_ = 88f;
        } else {
            phi_919_ = _e544;
        }
        let _e547 = phi_919_;
        let _e549 = ((_e547 * 1.442695f) + 0.5f);
        if (_e549 > -8388608f) {
            let _e561 = f32(select(0i, select(select(i32(_e549), i32(-2147483648), (_e549 < bitcast<f32>(3472883712u))), 2147483647i, (_e549 > bitcast<f32>(1325400063u))), (_e549 == _e549)));
            if (_e561 > _e549) {
                phi_941_ = 1f;
            } else {
                phi_941_ = 0f;
            }
            let _e564 = phi_941_;
            if (_e549 < 8388608f) {
                phi_946_ = (_e561 - _e564);
                phi_947_ = false;
            } else {
                phi_946_ = f32();
                phi_947_ = true;
            }
            let _e567 = phi_946_;
            let _e569 = phi_947_;
            phi_948_ = _e567;
            phi_949_ = _e569;
        } else {
            phi_948_ = f32();
            phi_949_ = true;
        }
        let _e571 = phi_948_;
        let _e573 = phi_949_;
        if _e573 {
            phi_953_ = _e549;
        } else {
            phi_953_ = _e571;
        }
        let _e575 = phi_953_;
        let _e579 = ((_e547 - (_e575 * 0.69314575f)) - (_e575 * 0.0000014286068f));
        phi_991_ = ((((((((((((((((1f / 5040f) * _e579) + (1f / 720f)) * _e579) + (1f / 120f)) * _e579) + (1f / 24f)) * _e579) + (1f / 6f)) * _e579) + 0.5f) * _e579) + 1f) * _e579) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e575), i32(-2147483648), (_e575 < bitcast<f32>(3472883712u))), 2147483647i, (_e575 > bitcast<f32>(1325400063u))), (_e575 == _e575)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e615 = phi_991_;
    if ((bitcast<u32>(_e459) & 2147483647u) > 2139095040u) {
        phi_1079_ = _e459;
    } else {
        if (_e459 < -87f) {
            phi_1002_ = -87f;
        } else {
            phi_1002_ = _e459;
        }
        let _e621 = phi_1002_;
        if (_e621 > 88f) {
            phi_1007_ = 88f;
        } else {
            phi_1007_ = _e621;
        }
        let _e624 = phi_1007_;
        let _e626 = ((_e624 * 1.442695f) + 0.5f);
        if (_e626 > -8388608f) {
            let _e638 = f32(select(0i, select(select(i32(_e626), i32(-2147483648), (_e626 < bitcast<f32>(3472883712u))), 2147483647i, (_e626 > bitcast<f32>(1325400063u))), (_e626 == _e626)));
            if (_e638 > _e626) {
                phi_1029_ = 1f;
            } else {
                phi_1029_ = 0f;
            }
            let _e641 = phi_1029_;
            if (_e626 < 8388608f) {
                phi_1034_ = (_e638 - _e641);
                phi_1035_ = false;
            } else {
                phi_1034_ = f32();
                phi_1035_ = true;
            }
            let _e644 = phi_1034_;
            let _e646 = phi_1035_;
            phi_1036_ = _e644;
            phi_1037_ = _e646;
        } else {
            phi_1036_ = f32();
            phi_1037_ = true;
        }
        let _e648 = phi_1036_;
        let _e650 = phi_1037_;
        if _e650 {
            phi_1041_ = _e626;
        } else {
            phi_1041_ = _e648;
        }
        let _e652 = phi_1041_;
        let _e656 = ((_e624 - (_e652 * 0.69314575f)) - (_e652 * 0.0000014286068f));
        phi_1079_ = ((((((((((((((((1f / 5040f) * _e656) + (1f / 720f)) * _e656) + (1f / 120f)) * _e656) + (1f / 24f)) * _e656) + (1f / 6f)) * _e656) + 0.5f) * _e656) + 1f) * _e656) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e652), i32(-2147483648), (_e652 < bitcast<f32>(3472883712u))), 2147483647i, (_e652 > bitcast<f32>(1325400063u))), (_e652 == _e652)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e692 = phi_1079_;
    if ((bitcast<u32>(_e461) & 2147483647u) > 2139095040u) {
        phi_1167_ = _e461;
    } else {
        if (_e461 < -87f) {
            phi_1090_ = -87f;
        } else {
            phi_1090_ = _e461;
        }
        let _e698 = phi_1090_;
        if (_e698 > 88f) {
            phi_1095_ = 88f;
        } else {
            phi_1095_ = _e698;
        }
        let _e701 = phi_1095_;
        let _e703 = ((_e701 * 1.442695f) + 0.5f);
        if (_e703 > -8388608f) {
            let _e715 = f32(select(0i, select(select(i32(_e703), i32(-2147483648), (_e703 < bitcast<f32>(3472883712u))), 2147483647i, (_e703 > bitcast<f32>(1325400063u))), (_e703 == _e703)));
            if (_e715 > _e703) {
                phi_1117_ = 1f;
            } else {
                phi_1117_ = 0f;
            }
            let _e718 = phi_1117_;
            if (_e703 < 8388608f) {
                phi_1122_ = (_e715 - _e718);
                phi_1123_ = false;
            } else {
                phi_1122_ = f32();
                phi_1123_ = true;
            }
            let _e721 = phi_1122_;
            let _e723 = phi_1123_;
            phi_1124_ = _e721;
            phi_1125_ = _e723;
        } else {
            phi_1124_ = f32();
            phi_1125_ = true;
        }
        let _e725 = phi_1124_;
        let _e727 = phi_1125_;
        if _e727 {
            phi_1129_ = _e703;
        } else {
            phi_1129_ = _e725;
        }
        let _e729 = phi_1129_;
        let _e733 = ((_e701 - (_e729 * 0.69314575f)) - (_e729 * 0.0000014286068f));
        phi_1167_ = ((((((((((((((((1f / 5040f) * _e733) + (1f / 720f)) * _e733) + (1f / 120f)) * _e733) + (1f / 24f)) * _e733) + (1f / 6f)) * _e733) + 0.5f) * _e733) + 1f) * _e733) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e729), i32(-2147483648), (_e729 < bitcast<f32>(3472883712u))), 2147483647i, (_e729 > bitcast<f32>(1325400063u))), (_e729 == _e729)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e769 = phi_1167_;
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
        phi_1220_ = true;
    } else {
        let _e815 = (_e781 > _e811);
        if _e815 {
        }
        phi_1220_ = _e815;
    }
    let _e817 = phi_1220_;
    if _e817 {
        phi_1224_ = _e781;
    } else {
        phi_1224_ = _e811;
    }
    let _e819 = phi_1224_;
    let _e820 = -(_e792);
    if (_e820 <= 0f) {
        let _e824 = ((bitcast<u32>(_e819) & 2147483647u) > 2139095040u);
        if _e824 {
        }
        phi_1236_ = _e824;
    } else {
        phi_1236_ = true;
    }
    let _e826 = phi_1236_;
    if _e826 {
        phi_1243_ = (_e819 / (_e819 + (_e820 * _e820)));
    } else {
        phi_1243_ = 1f;
    }
    let _e831 = phi_1243_;
    if ((bitcast<u32>(_e831) & 2147483647u) > 2139095040u) {
        phi_1254_ = true;
    } else {
        let _e835 = (_e831 < _e442);
        if _e835 {
        }
        phi_1254_ = _e835;
    }
    let _e837 = phi_1254_;
    if _e837 {
        phi_1258_ = _e831;
    } else {
        phi_1258_ = _e442;
    }
    let _e839 = phi_1258_;
    if ((bitcast<u32>(_e839) & 2147483647u) > 2139095040u) {
        phi_1275_ = _e839;
    } else {
        if (_e839 < 0f) {
            phi_1274_ = 0f;
        } else {
            if (_e839 > 1f) {
                phi_1273_ = 1f;
            } else {
                phi_1273_ = _e839;
            }
            let _e846 = phi_1273_;
            phi_1274_ = _e846;
        }
        let _e848 = phi_1274_;
        phi_1275_ = _e848;
    }
    let _e850 = phi_1275_;
    return _e850;
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_7: ptr<function, lt_math_Evsm>, param_8: vec4<f32>, param_9: vec4<f32>, param_10: f32) -> f32 {
    var phi_198_: f32;
    var phi_199_: f32;
    var phi_200_: f32;
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
    var phi_309_: bool;
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
    var phi_323_: bool;
    var phi_327_: bool;
    var phi_332_: f32;

    if ((bitcast<u32>(param_10) & 2147483647u) > 2139095040u) {
        phi_200_ = param_10;
    } else {
        if (param_10 < 0f) {
            phi_199_ = 0f;
        } else {
            if (param_10 > 1f) {
                phi_198_ = 1f;
            } else {
                phi_198_ = param_10;
            }
            let _e62 = phi_198_;
            phi_199_ = _e62;
        }
        let _e64 = phi_199_;
        phi_200_ = _e64;
    }
    let _e66 = phi_200_;
    if ((bitcast<u32>(param_8.x) & 2147483647u) > 2139095040u) {
        phi_218_ = param_8.x;
    } else {
        if (param_8.x < 0f) {
            phi_217_ = 0f;
        } else {
            if (param_8.x > 1f) {
                phi_216_ = 1f;
            } else {
                phi_216_ = param_8.x;
            }
            let _e74 = phi_216_;
            phi_217_ = _e74;
        }
        let _e76 = phi_217_;
        phi_218_ = _e76;
    }
    let _e78 = phi_218_;
    if ((bitcast<u32>(param_8.y) & 2147483647u) > 2139095040u) {
        phi_236_ = param_8.y;
    } else {
        if (param_8.y < 0f) {
            phi_235_ = 0f;
        } else {
            if (param_8.y > 1f) {
                phi_234_ = 1f;
            } else {
                phi_234_ = param_8.y;
            }
            let _e86 = phi_234_;
            phi_235_ = _e86;
        }
        let _e88 = phi_235_;
        phi_236_ = _e88;
    }
    let _e90 = phi_236_;
    if ((bitcast<u32>(param_8.z) & 2147483647u) > 2139095040u) {
        phi_254_ = param_8.z;
    } else {
        if (param_8.z < 0f) {
            phi_253_ = 0f;
        } else {
            if (param_8.z > 1f) {
                phi_252_ = 1f;
            } else {
                phi_252_ = param_8.z;
            }
            let _e98 = phi_252_;
            phi_253_ = _e98;
        }
        let _e100 = phi_253_;
        phi_254_ = _e100;
    }
    let _e102 = phi_254_;
    if ((bitcast<u32>(param_8.w) & 2147483647u) > 2139095040u) {
        phi_272_ = param_8.w;
    } else {
        if (param_8.w < 0f) {
            phi_271_ = 0f;
        } else {
            if (param_8.w > 1f) {
                phi_270_ = 1f;
            } else {
                phi_270_ = param_8.w;
            }
            let _e110 = phi_270_;
            phi_271_ = _e110;
        }
        let _e112 = phi_271_;
        phi_272_ = _e112;
    }
    let _e114 = phi_272_;
    let _e115 = (_e78 - _e66);
    let _e116 = (_e90 - _e66);
    let _e117 = (_e102 - _e66);
    let _e118 = (_e114 - _e66);
    if (_e115 >= 0f) {
        if (_e116 >= 0f) {
            if (_e117 >= 0f) {
                if (_e118 >= 0f) {
                    phi_309_ = !(((bitcast<u32>(((((_e115 * param_9.x) + (_e116 * param_9.y)) + (_e117 * param_9.z)) + (_e118 * param_9.w))) & 2147483647u) > 2139095040u));
                    phi_310_ = false;
                } else {
                    phi_309_ = bool();
                    phi_310_ = true;
                }
                let _e140 = phi_309_;
                let _e142 = phi_310_;
                phi_311_ = _e140;
                phi_312_ = false;
                phi_313_ = _e142;
            } else {
                phi_311_ = bool();
                phi_312_ = true;
                phi_313_ = false;
            }
            let _e144 = phi_311_;
            let _e146 = phi_312_;
            let _e148 = phi_313_;
            phi_314_ = _e144;
            phi_315_ = _e146;
            phi_316_ = _e148;
        } else {
            phi_314_ = bool();
            phi_315_ = true;
            phi_316_ = false;
        }
        let _e150 = phi_314_;
        let _e152 = phi_315_;
        let _e154 = phi_316_;
        phi_317_ = _e150;
        phi_318_ = _e152;
        phi_319_ = _e154;
    } else {
        phi_317_ = bool();
        phi_318_ = true;
        phi_319_ = false;
    }
    let _e156 = phi_317_;
    let _e158 = phi_318_;
    let _e160 = phi_319_;
    if _e158 {
        phi_323_ = true;
    } else {
        phi_323_ = _e160;
    }
    let _e162 = phi_323_;
    if _e162 {
        phi_327_ = false;
    } else {
        phi_327_ = _e156;
    }
    let _e164 = phi_327_;
    if _e164 {
        phi_332_ = 1f;
    } else {
        let _e165 = _lt_math_evsm_Evsm_bound_of_offsets(param_7, vec4<f32>(_e115, _e116, _e117, _e118), param_9);
        phi_332_ = _e165;
    }
    let _e167 = phi_332_;
    return _e167;
}

fn function_() {
    var local: lt_math_Evsm;
    var phi_1335_: bool;
    var phi_1336_: bool;
    var phi_1337_: bool;
    var phi_1338_: bool;
    var phi_1342_: bool;
    var phi_1412_: bool;
    var phi_1413_: bool;
    var phi_1424_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1425_: bool;
    var phi_1426_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1427_: bool;
    var phi_1434_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1438_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1458_: lt_math_LightPoint;
    var phi_1461_: u32;
    var phi_1463_: lt_math_LevelPoint;
    var phi_1549_: bool;
    var phi_1558_: bool;
    var phi_1567_: bool;
    var phi_1568_: bool;
    var phi_1569_: bool;
    var phi_1570_: bool;
    var phi_1571_: bool;
    var phi_1572_: bool;
    var phi_1573_: bool;
    var phi_1577_: bool;
    var phi_1604_: bool;
    var phi_1605_: bool;
    var phi_1606_: bool;
    var phi_1607_: bool;
    var phi_1608_: bool;
    var phi_1609_: bool;
    var phi_1610_: bool;
    var phi_1611_: bool;
    var phi_1615_: bool;
    var phi_1624_: lt_math_LightPoint;
    var phi_1625_: u32;
    var phi_1626_: lt_math_LevelPoint;
    var phi_1627_: bool;
    var phi_1459_: lt_math_LightPoint;
    var phi_1462_: u32;
    var phi_1464_: lt_math_LevelPoint;
    var phi_1628_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_1668_: bool;
    var phi_1669_: bool;
    var phi_1670_: bool;
    var phi_1671_: bool;
    var phi_1675_: bool;
    var phi_1757_: f32;
    var phi_1873_: f32;
    var phi_1874_: f32;
    var phi_1877_: f32;
    var phi_1906_: f32;
    var phi_1911_: f32;
    var phi_1912_: bool;
    var phi_1913_: f32;
    var phi_1914_: bool;
    var phi_1918_: f32;
    var phi_1938_: f32;
    var phi_1943_: f32;
    var phi_1944_: bool;
    var phi_1945_: f32;
    var phi_1946_: bool;
    var phi_1950_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_2003_: i32;
    var phi_2008_: i32;
    var phi_2013_: i32;
    var phi_2018_: i32;
    var phi_2027_: i32;
    var phi_2032_: i32;
    var phi_2037_: i32;
    var phi_2042_: i32;
    var phi_2087_: evaluate_Verdict;
    var phi_2088_: evaluate_Verdict;
    var phi_2089_: bool;
    var phi_2090_: evaluate_Verdict;
    var phi_2091_: evaluate_Verdict;
    var phi_2092_: bool;
    var phi_2096_: evaluate_Verdict;

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
                phi_1335_ = (_e95 == _e97);
                phi_1336_ = false;
            } else {
                phi_1335_ = bool();
                phi_1336_ = true;
            }
            let _e100 = phi_1335_;
            let _e102 = phi_1336_;
            phi_1337_ = _e100;
            phi_1338_ = _e102;
        } else {
            phi_1337_ = bool();
            phi_1338_ = true;
        }
        let _e104 = phi_1337_;
        let _e106 = phi_1338_;
        if _e106 {
            phi_1342_ = false;
        } else {
            phi_1342_ = _e104;
        }
        let _e108 = phi_1342_;
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
                    phi_1413_ = true;
                } else {
                    let _e161 = p.member.light.range_squared;
                    if (_e144 <= _e161) {
                        let _e164 = p.member.light.cos_outer;
                        phi_1412_ = (-((((_e126 * _e146.x) + (_e127 * _e146.y)) + (_e128 * _e146.z))) >= (_e164 * sqrt(_e144)));
                    } else {
                        phi_1412_ = false;
                    }
                    let _e169 = phi_1412_;
                    phi_1413_ = _e169;
                }
                let _e171 = phi_1413_;
                if _e171 {
                    let _e173 = samples.member[(0u + _e72.first_primitive)].flags;
                    let _e181 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e187 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e181.unnamed.visibility, false), _e181.unnamed_1);
                    phi_1424_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e187.unnamed, ((_e173 & 1u) == 0u));
                    phi_1425_ = false;
                } else {
                    phi_1424_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_1425_ = true;
                }
                let _e192 = phi_1424_;
                let _e194 = phi_1425_;
                phi_1426_ = _e192;
                phi_1427_ = _e194;
            } else {
                phi_1426_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_1427_ = true;
            }
            let _e196 = phi_1426_;
            let _e198 = phi_1427_;
            if _e198 {
                let _e204 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e210 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e204.unnamed.visibility, false), _e204.unnamed_1);
                phi_1434_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e210.unnamed, true);
            } else {
                phi_1434_ = _e196;
            }
            let _e215 = phi_1434_;
            phi_1438_ = _e215;
        } else {
            let _e221 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e227 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e221.unnamed.visibility, false), _e221.unnamed_1);
            phi_1438_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e227.unnamed, true);
        }
        let _e232 = phi_1438_;
        if _e232.unnamed_1 {
            phi_2090_ = evaluate_Verdict(_e232.unnamed.visibility, _e232.unnamed.is_doubted);
            phi_2091_ = evaluate_Verdict();
            phi_2092_ = true;
        } else {
            let _e240 = samples.member[(0u + _e72.first_primitive)].position;
            let _e242 = p.member.map_size;
            let _e244 = (0.5f / f32(_e242));
            let _e251 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e258 = lt_math_LightPoint(vec2<f32>(_e251.uv.x, 0f), _e251.depth, _e251.is_inside);
            let _e262 = lt_math_LightPoint(_e258.uv, 0f, _e258.is_inside);
            phi_1458_ = lt_math_LightPoint();
            phi_1461_ = 0u;
            phi_1463_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e262.uv, _e262.depth, false));
            loop {
                let _e269 = phi_1458_;
                let _e271 = phi_1461_;
                let _e273 = phi_1463_;
                local_1 = _e273;
                local_2 = _e273;
                local_3 = _e273;
                if (_e271 < _e78) {
                    if _e273.point.is_inside {
                        phi_1624_ = lt_math_LightPoint();
                        phi_1625_ = u32();
                        phi_1626_ = lt_math_LevelPoint();
                        phi_1627_ = false;
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
                                phi_1549_ = (_e309 <= 1f);
                            } else {
                                phi_1549_ = false;
                            }
                            let _e341 = phi_1549_;
                            if _e341 {
                                if (_e323 >= 0f) {
                                    phi_1558_ = (_e323 <= 1f);
                                } else {
                                    phi_1558_ = false;
                                }
                                let _e345 = phi_1558_;
                                if _e345 {
                                    if (_e336 >= 0f) {
                                        phi_1567_ = (_e336 <= 1f);
                                    } else {
                                        phi_1567_ = false;
                                    }
                                    let _e349 = phi_1567_;
                                    phi_1568_ = _e349;
                                    phi_1569_ = false;
                                } else {
                                    phi_1568_ = bool();
                                    phi_1569_ = true;
                                }
                                let _e351 = phi_1568_;
                                let _e353 = phi_1569_;
                                phi_1570_ = _e351;
                                phi_1571_ = _e353;
                            } else {
                                phi_1570_ = bool();
                                phi_1571_ = true;
                            }
                            let _e355 = phi_1570_;
                            let _e357 = phi_1571_;
                            phi_1572_ = _e355;
                            phi_1573_ = _e357;
                        } else {
                            phi_1572_ = bool();
                            phi_1573_ = true;
                        }
                        let _e359 = phi_1572_;
                        let _e361 = phi_1573_;
                        if _e361 {
                            phi_1577_ = false;
                        } else {
                            phi_1577_ = _e359;
                        }
                        let _e363 = phi_1577_;
                        if _e363 {
                            if (_e309 >= _e244) {
                                if (_e309 <= (1f - _e244)) {
                                    if (_e323 >= _e244) {
                                        phi_1604_ = (_e323 <= (1f - _e244));
                                        phi_1605_ = false;
                                    } else {
                                        phi_1604_ = bool();
                                        phi_1605_ = true;
                                    }
                                    let _e371 = phi_1604_;
                                    let _e373 = phi_1605_;
                                    phi_1606_ = _e371;
                                    phi_1607_ = _e373;
                                } else {
                                    phi_1606_ = bool();
                                    phi_1607_ = true;
                                }
                                let _e375 = phi_1606_;
                                let _e377 = phi_1607_;
                                phi_1608_ = _e375;
                                phi_1609_ = _e377;
                            } else {
                                phi_1608_ = bool();
                                phi_1609_ = true;
                            }
                            let _e379 = phi_1608_;
                            let _e381 = phi_1609_;
                            phi_1610_ = _e379;
                            phi_1611_ = _e381;
                        } else {
                            phi_1610_ = bool();
                            phi_1611_ = true;
                        }
                        let _e383 = phi_1610_;
                        let _e385 = phi_1611_;
                        if _e385 {
                            phi_1615_ = false;
                        } else {
                            phi_1615_ = _e383;
                        }
                        let _e387 = phi_1615_;
                        let _e394 = lt_math_LightPoint(vec2<f32>(_e309, _e269.uv.y), _e269.depth, _e269.is_inside);
                        let _e401 = lt_math_LightPoint(vec2<f32>(_e394.uv.x, _e323), _e394.depth, _e394.is_inside);
                        let _e405 = lt_math_LightPoint(_e401.uv, _e336, _e401.is_inside);
                        let _e409 = lt_math_LightPoint(_e405.uv, _e405.depth, _e387);
                        phi_1624_ = _e409;
                        phi_1625_ = (_e271 + 1u);
                        phi_1626_ = lt_math_LevelPoint(_e271, _e409);
                        phi_1627_ = true;
                    }
                    let _e413 = phi_1624_;
                    let _e415 = phi_1625_;
                    let _e417 = phi_1626_;
                    let _e419 = phi_1627_;
                    phi_1459_ = _e413;
                    phi_1462_ = _e415;
                    phi_1464_ = _e417;
                    phi_1628_ = _e419;
                } else {
                    phi_1459_ = lt_math_LightPoint();
                    phi_1462_ = u32();
                    phi_1464_ = lt_math_LevelPoint();
                    phi_1628_ = false;
                }
                let _e421 = phi_1459_;
                let _e423 = phi_1462_;
                let _e425 = phi_1464_;
                let _e427 = phi_1628_;
                continue;
                continuing {
                    phi_1458_ = _e421;
                    phi_1461_ = _e423;
                    phi_1463_ = _e425;
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
                            phi_1668_ = (_e441.row_w.z == _e453);
                            phi_1669_ = false;
                        } else {
                            phi_1668_ = bool();
                            phi_1669_ = true;
                        }
                        let _e456 = phi_1668_;
                        let _e458 = phi_1669_;
                        phi_1670_ = _e456;
                        phi_1671_ = _e458;
                    } else {
                        phi_1670_ = bool();
                        phi_1671_ = true;
                    }
                    let _e460 = phi_1670_;
                    let _e462 = phi_1671_;
                    if _e462 {
                        phi_1675_ = false;
                    } else {
                        phi_1675_ = _e460;
                    }
                    let _e464 = phi_1675_;
                    if _e464 {
                        let _e466 = samples.member[(0u + _e72.first_primitive)].normal;
                        let _e468 = p.member.map_size;
                        let _e538 = ((abs(((((_e441.row_x.x * _e466.x) + (_e441.row_x.y * _e466.y)) + (_e441.row_x.z * _e466.z)) / (((_e441.row_x.x * _e441.row_x.x) + (_e441.row_x.y * _e441.row_x.y)) + (_e441.row_x.z * _e441.row_x.z)))) + abs(((((_e441.row_y.x * _e466.x) + (_e441.row_y.y * _e466.y)) + (_e441.row_y.z * _e466.z)) / (((_e441.row_y.x * _e441.row_y.x) + (_e441.row_y.y * _e441.row_y.y)) + (_e441.row_y.z * _e441.row_y.z))))) / (abs(((((_e441.row_z.x * _e466.x) + (_e441.row_z.y * _e466.y)) + (_e441.row_z.z * _e466.z)) / (((_e441.row_z.x * _e441.row_z.x) + (_e441.row_z.y * _e441.row_z.y)) + (_e441.row_z.z * _e441.row_z.z)))) * f32(_e468)));
                        if (_e538 < 0.002f) {
                            phi_1757_ = _e538;
                        } else {
                            phi_1757_ = 0.002f;
                        }
                        let _e541 = phi_1757_;
                        phi_1874_ = _e541;
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
                            phi_1873_ = _e655;
                        } else {
                            phi_1873_ = 0.002f;
                        }
                        let _e658 = phi_1873_;
                        phi_1874_ = _e658;
                    }
                    let _e660 = phi_1874_;
                    phi_1877_ = (_e430.point.depth - (0f * _e660));
                } else {
                    phi_1877_ = _e430.point.depth;
                }
                let _e664 = phi_1877_;
                let _e670 = p.member.map_size;
                let _e671 = f32(_e670);
                let _e674 = ((_e430.point.uv.x * _e671) - 0.5f);
                let _e675 = ((_e430.point.uv.y * _e671) - 0.5f);
                if (_e674 > -8388608f) {
                    let _e687 = f32(select(0i, select(select(i32(_e674), i32(-2147483648), (_e674 < bitcast<f32>(3472883712u))), 2147483647i, (_e674 > bitcast<f32>(1325400063u))), (_e674 == _e674)));
                    if (_e687 > _e674) {
                        phi_1906_ = 1f;
                    } else {
                        phi_1906_ = 0f;
                    }
                    let _e690 = phi_1906_;
                    if (_e674 < 8388608f) {
                        phi_1911_ = (_e687 - _e690);
                        phi_1912_ = false;
                    } else {
                        phi_1911_ = f32();
                        phi_1912_ = true;
                    }
                    let _e693 = phi_1911_;
                    let _e695 = phi_1912_;
                    phi_1913_ = _e693;
                    phi_1914_ = _e695;
                } else {
                    phi_1913_ = f32();
                    phi_1914_ = true;
                }
                let _e697 = phi_1913_;
                let _e699 = phi_1914_;
                if _e699 {
                    phi_1918_ = _e674;
                } else {
                    phi_1918_ = _e697;
                }
                let _e701 = phi_1918_;
                if (_e675 > -8388608f) {
                    let _e713 = f32(select(0i, select(select(i32(_e675), i32(-2147483648), (_e675 < bitcast<f32>(3472883712u))), 2147483647i, (_e675 > bitcast<f32>(1325400063u))), (_e675 == _e675)));
                    if (_e713 > _e675) {
                        phi_1938_ = 1f;
                    } else {
                        phi_1938_ = 0f;
                    }
                    let _e716 = phi_1938_;
                    if (_e675 < 8388608f) {
                        phi_1943_ = (_e713 - _e716);
                        phi_1944_ = false;
                    } else {
                        phi_1943_ = f32();
                        phi_1944_ = true;
                    }
                    let _e719 = phi_1943_;
                    let _e721 = phi_1944_;
                    phi_1945_ = _e719;
                    phi_1946_ = _e721;
                } else {
                    phi_1945_ = f32();
                    phi_1946_ = true;
                }
                let _e723 = phi_1945_;
                let _e725 = phi_1946_;
                if _e725 {
                    phi_1950_ = _e675;
                } else {
                    phi_1950_ = _e723;
                }
                let _e727 = phi_1950_;
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
                    phi_2003_ = _e738;
                } else {
                    phi_2003_ = 0i;
                }
                let _e775 = phi_2003_;
                if (_e747 > 0i) {
                    phi_2008_ = _e747;
                } else {
                    phi_2008_ = 0i;
                }
                let _e778 = phi_2008_;
                if (_e775 < _e772) {
                    phi_2013_ = _e775;
                } else {
                    phi_2013_ = _e772;
                }
                let _e781 = phi_2013_;
                if (_e778 < _e772) {
                    phi_2018_ = _e778;
                } else {
                    phi_2018_ = _e772;
                }
                let _e784 = phi_2018_;
                let _e785 = bitcast<u32>(_e781);
                let _e787 = (_e738 + 1i);
                let _e788 = (_e747 + 1i);
                if (_e787 > 0i) {
                    phi_2027_ = _e787;
                } else {
                    phi_2027_ = 0i;
                }
                let _e791 = phi_2027_;
                if (_e788 > 0i) {
                    phi_2032_ = _e788;
                } else {
                    phi_2032_ = 0i;
                }
                let _e794 = phi_2032_;
                if (_e791 < _e772) {
                    phi_2037_ = _e791;
                } else {
                    phi_2037_ = _e772;
                }
                let _e797 = phi_2037_;
                if (_e794 < _e772) {
                    phi_2042_ = _e794;
                } else {
                    phi_2042_ = _e772;
                }
                let _e800 = phi_2042_;
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
                phi_2087_ = evaluate_Verdict(_e830, false);
                phi_2088_ = evaluate_Verdict();
                phi_2089_ = false;
            } else {
                phi_2087_ = evaluate_Verdict();
                phi_2088_ = evaluate_Verdict(1f, false);
                phi_2089_ = true;
            }
            let _e834 = phi_2087_;
            let _e836 = phi_2088_;
            let _e838 = phi_2089_;
            phi_2090_ = _e836;
            phi_2091_ = _e834;
            phi_2092_ = _e838;
        }
        let _e840 = phi_2090_;
        let _e842 = phi_2091_;
        let _e844 = phi_2092_;
        if _e844 {
            phi_2096_ = _e840;
        } else {
            phi_2096_ = _e842;
        }
        let _e846 = phi_2096_;
        if (_e72.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e72.first_primitive)] = _e846.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_evsm_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
