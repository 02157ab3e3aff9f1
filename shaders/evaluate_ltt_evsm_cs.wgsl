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

struct type_36 {
    member: abi_ShadowParams,
}

struct lt_math_Evsm {
    positive_exponent: f32,
    negative_exponent: f32,
    min_variance: f32,
}

struct lt_math_OneLevel {
    projection: lt_math_LightProjection,
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
var<uniform> p: type_36;
@group(0) @binding(2) 
var<storage> map: type_18;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_18;
@group(0) @binding(4) 
var<storage, read_write> list: type_44;

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
        let _e64 = phi_161_;
        let _e66 = phi_162_;
        phi_163_ = _e64;
        phi_164_ = _e66;
    } else {
        phi_163_ = lt_bvh_traverse_Tree();
        phi_164_ = true;
    }
    let _e68 = phi_163_;
    let _e70 = phi_164_;
    if _e70 {
        phi_169_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_169_ = _e68;
    }
    let _e75 = phi_169_;
    return lt_bvh_traverse_Tree(_e75.root, _e75.first_primitive);
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

    let _e55 = (*param_4).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_349_ = true;
    } else {
        let _e59 = (42f < _e55);
        if _e59 {
        }
        phi_349_ = _e59;
    }
    let _e61 = phi_349_;
    if _e61 {
        phi_353_ = 42f;
    } else {
        phi_353_ = _e55;
    }
    let _e63 = phi_353_;
    let _e65 = (_e63 * param_5.x);
    let _e67 = (_e63 * param_5.y);
    let _e69 = (_e63 * param_5.z);
    let _e71 = (_e63 * param_5.w);
    if ((bitcast<u32>(_e65) & 2147483647u) > 2139095040u) {
        phi_449_ = _e65;
    } else {
        if (_e65 < -87f) {
            phi_372_ = -87f;
        } else {
            phi_372_ = _e65;
        }
        let _e77 = phi_372_;
        if (_e77 > 88f) {
            phi_377_ = 88f;
        } else {
            phi_377_ = _e77;
        }
        let _e80 = phi_377_;
        let _e82 = ((_e80 * 1.442695f) + 0.5f);
        if (_e82 > -8388608f) {
            let _e94 = f32(select(0i, select(select(i32(_e82), i32(-2147483648), (_e82 < bitcast<f32>(3472883712u))), 2147483647i, (_e82 > bitcast<f32>(1325400063u))), (_e82 == _e82)));
            if (_e94 > _e82) {
                phi_399_ = 1f;
            } else {
                phi_399_ = 0f;
            }
            let _e97 = phi_399_;
            if (_e82 < 8388608f) {
                phi_404_ = (_e94 - _e97);
                phi_405_ = false;
            } else {
                phi_404_ = f32();
                phi_405_ = true;
            }
            let _e100 = phi_404_;
            let _e102 = phi_405_;
            phi_406_ = _e100;
            phi_407_ = _e102;
        } else {
            phi_406_ = f32();
            phi_407_ = true;
        }
        let _e104 = phi_406_;
        let _e106 = phi_407_;
        if _e106 {
            phi_411_ = _e82;
        } else {
            phi_411_ = _e104;
        }
        let _e108 = phi_411_;
        let _e112 = ((_e80 - (_e108 * 0.69314575f)) - (_e108 * 0.0000014286068f));
        phi_449_ = ((((((((((((((((1f / 5040f) * _e112) + (1f / 720f)) * _e112) + (1f / 120f)) * _e112) + (1f / 24f)) * _e112) + (1f / 6f)) * _e112) + 0.5f) * _e112) + 1f) * _e112) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e108), i32(-2147483648), (_e108 < bitcast<f32>(3472883712u))), 2147483647i, (_e108 > bitcast<f32>(1325400063u))), (_e108 == _e108)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e148 = phi_449_;
    if ((bitcast<u32>(_e67) & 2147483647u) > 2139095040u) {
        phi_537_ = _e67;
    } else {
        if (_e67 < -87f) {
            phi_460_ = -87f;
        } else {
            phi_460_ = _e67;
        }
        let _e154 = phi_460_;
        if (_e154 > 88f) {
            phi_465_ = 88f;
        } else {
            phi_465_ = _e154;
        }
        let _e157 = phi_465_;
        let _e159 = ((_e157 * 1.442695f) + 0.5f);
        if (_e159 > -8388608f) {
            let _e171 = f32(select(0i, select(select(i32(_e159), i32(-2147483648), (_e159 < bitcast<f32>(3472883712u))), 2147483647i, (_e159 > bitcast<f32>(1325400063u))), (_e159 == _e159)));
            if (_e171 > _e159) {
                phi_487_ = 1f;
            } else {
                phi_487_ = 0f;
            }
            let _e174 = phi_487_;
            if (_e159 < 8388608f) {
                phi_492_ = (_e171 - _e174);
                phi_493_ = false;
            } else {
                phi_492_ = f32();
                phi_493_ = true;
            }
            let _e177 = phi_492_;
            let _e179 = phi_493_;
            phi_494_ = _e177;
            phi_495_ = _e179;
        } else {
            phi_494_ = f32();
            phi_495_ = true;
        }
        let _e181 = phi_494_;
        let _e183 = phi_495_;
        if _e183 {
            phi_499_ = _e159;
        } else {
            phi_499_ = _e181;
        }
        let _e185 = phi_499_;
        let _e189 = ((_e157 - (_e185 * 0.69314575f)) - (_e185 * 0.0000014286068f));
        phi_537_ = ((((((((((((((((1f / 5040f) * _e189) + (1f / 720f)) * _e189) + (1f / 120f)) * _e189) + (1f / 24f)) * _e189) + (1f / 6f)) * _e189) + 0.5f) * _e189) + 1f) * _e189) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e185), i32(-2147483648), (_e185 < bitcast<f32>(3472883712u))), 2147483647i, (_e185 > bitcast<f32>(1325400063u))), (_e185 == _e185)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e225 = phi_537_;
    if ((bitcast<u32>(_e69) & 2147483647u) > 2139095040u) {
        phi_625_ = _e69;
    } else {
        if (_e69 < -87f) {
            phi_548_ = -87f;
        } else {
            phi_548_ = _e69;
        }
        let _e231 = phi_548_;
        if (_e231 > 88f) {
            phi_553_ = 88f;
        } else {
            phi_553_ = _e231;
        }
        let _e234 = phi_553_;
        let _e236 = ((_e234 * 1.442695f) + 0.5f);
        if (_e236 > -8388608f) {
            let _e248 = f32(select(0i, select(select(i32(_e236), i32(-2147483648), (_e236 < bitcast<f32>(3472883712u))), 2147483647i, (_e236 > bitcast<f32>(1325400063u))), (_e236 == _e236)));
            if (_e248 > _e236) {
                phi_575_ = 1f;
            } else {
                phi_575_ = 0f;
            }
            let _e251 = phi_575_;
            if (_e236 < 8388608f) {
                phi_580_ = (_e248 - _e251);
                phi_581_ = false;
            } else {
                phi_580_ = f32();
                phi_581_ = true;
            }
            let _e254 = phi_580_;
            let _e256 = phi_581_;
            phi_582_ = _e254;
            phi_583_ = _e256;
        } else {
            phi_582_ = f32();
            phi_583_ = true;
        }
        let _e258 = phi_582_;
        let _e260 = phi_583_;
        if _e260 {
            phi_587_ = _e236;
        } else {
            phi_587_ = _e258;
        }
        let _e262 = phi_587_;
        let _e266 = ((_e234 - (_e262 * 0.69314575f)) - (_e262 * 0.0000014286068f));
        phi_625_ = ((((((((((((((((1f / 5040f) * _e266) + (1f / 720f)) * _e266) + (1f / 120f)) * _e266) + (1f / 24f)) * _e266) + (1f / 6f)) * _e266) + 0.5f) * _e266) + 1f) * _e266) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e262), i32(-2147483648), (_e262 < bitcast<f32>(3472883712u))), 2147483647i, (_e262 > bitcast<f32>(1325400063u))), (_e262 == _e262)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e302 = phi_625_;
    if ((bitcast<u32>(_e71) & 2147483647u) > 2139095040u) {
        phi_713_ = _e71;
    } else {
        if (_e71 < -87f) {
            phi_636_ = -87f;
        } else {
            phi_636_ = _e71;
        }
        let _e308 = phi_636_;
        if (_e308 > 88f) {
            phi_641_ = 88f;
        } else {
            phi_641_ = _e308;
        }
        let _e311 = phi_641_;
        let _e313 = ((_e311 * 1.442695f) + 0.5f);
        if (_e313 > -8388608f) {
            let _e325 = f32(select(0i, select(select(i32(_e313), i32(-2147483648), (_e313 < bitcast<f32>(3472883712u))), 2147483647i, (_e313 > bitcast<f32>(1325400063u))), (_e313 == _e313)));
            if (_e325 > _e313) {
                phi_663_ = 1f;
            } else {
                phi_663_ = 0f;
            }
            let _e328 = phi_663_;
            if (_e313 < 8388608f) {
                phi_668_ = (_e325 - _e328);
                phi_669_ = false;
            } else {
                phi_668_ = f32();
                phi_669_ = true;
            }
            let _e331 = phi_668_;
            let _e333 = phi_669_;
            phi_670_ = _e331;
            phi_671_ = _e333;
        } else {
            phi_670_ = f32();
            phi_671_ = true;
        }
        let _e335 = phi_670_;
        let _e337 = phi_671_;
        if _e337 {
            phi_675_ = _e313;
        } else {
            phi_675_ = _e335;
        }
        let _e339 = phi_675_;
        let _e343 = ((_e311 - (_e339 * 0.69314575f)) - (_e339 * 0.0000014286068f));
        phi_713_ = ((((((((((((((((1f / 5040f) * _e343) + (1f / 720f)) * _e343) + (1f / 120f)) * _e343) + (1f / 24f)) * _e343) + (1f / 6f)) * _e343) + 0.5f) * _e343) + 1f) * _e343) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e339), i32(-2147483648), (_e339 < bitcast<f32>(3472883712u))), 2147483647i, (_e339 > bitcast<f32>(1325400063u))), (_e339 == _e339)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e379 = phi_713_;
    let _e381 = (_e148 - vec4<f32>(1f, 1f, 1f, 1f).x);
    let _e383 = (_e225 - vec4<f32>(1f, 1f, 1f, 1f).y);
    let _e385 = (_e302 - vec4<f32>(1f, 1f, 1f, 1f).z);
    let _e387 = (_e379 - vec4<f32>(1f, 1f, 1f, 1f).w);
    let _e389 = (*param_4).min_variance;
    let _e391 = ((_e389 * _e63) * _e63);
    let _e402 = ((((_e381 * param_6.x) + (_e383 * param_6.y)) + (_e385 * param_6.z)) + (_e387 * param_6.w));
    let _e403 = (_e381 - _e402);
    let _e404 = (_e383 - _e402);
    let _e405 = (_e385 - _e402);
    let _e406 = (_e387 - _e402);
    let _e421 = (((((_e403 * _e403) * param_6.x) + ((_e404 * _e404) * param_6.y)) + ((_e405 * _e405) * param_6.z)) + ((_e406 * _e406) * param_6.w));
    if ((bitcast<u32>(_e391) & 2147483647u) > 2139095040u) {
        phi_766_ = true;
    } else {
        let _e425 = (_e391 > _e421);
        if _e425 {
        }
        phi_766_ = _e425;
    }
    let _e427 = phi_766_;
    if _e427 {
        phi_770_ = _e391;
    } else {
        phi_770_ = _e421;
    }
    let _e429 = phi_770_;
    let _e430 = -(_e402);
    if (_e430 <= 0f) {
        let _e434 = ((bitcast<u32>(_e429) & 2147483647u) > 2139095040u);
        if _e434 {
        }
        phi_782_ = _e434;
    } else {
        phi_782_ = true;
    }
    let _e436 = phi_782_;
    if _e436 {
        phi_789_ = (_e429 / (_e429 + (_e430 * _e430)));
    } else {
        phi_789_ = 1f;
    }
    let _e441 = phi_789_;
    let _e443 = (*param_4).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_802_ = true;
    } else {
        let _e447 = (42f < _e443);
        if _e447 {
        }
        phi_802_ = _e447;
    }
    let _e449 = phi_802_;
    if _e449 {
        phi_806_ = 42f;
    } else {
        phi_806_ = _e443;
    }
    let _e451 = phi_806_;
    let _e452 = -(_e451);
    let _e454 = (_e452 * param_5.x);
    let _e456 = (_e452 * param_5.y);
    let _e458 = (_e452 * param_5.z);
    let _e460 = (_e452 * param_5.w);
    if ((bitcast<u32>(_e454) & 2147483647u) > 2139095040u) {
        phi_903_ = _e454;
    } else {
        if (_e454 < -87f) {
            phi_826_ = -87f;
        } else {
            phi_826_ = _e454;
        }
        let _e466 = phi_826_;
        if (_e466 > 88f) {
            phi_831_ = 88f;
        } else {
            phi_831_ = _e466;
        }
        let _e469 = phi_831_;
        let _e471 = ((_e469 * 1.442695f) + 0.5f);
        if (_e471 > -8388608f) {
            let _e483 = f32(select(0i, select(select(i32(_e471), i32(-2147483648), (_e471 < bitcast<f32>(3472883712u))), 2147483647i, (_e471 > bitcast<f32>(1325400063u))), (_e471 == _e471)));
            if (_e483 > _e471) {
                phi_853_ = 1f;
            } else {
                phi_853_ = 0f;
            }
            let _e486 = phi_853_;
            if (_e471 < 8388608f) {
                phi_858_ = (_e483 - _e486);
                phi_859_ = false;
            } else {
                phi_858_ = f32();
                phi_859_ = true;
            }
            let _e489 = phi_858_;
            let _e491 = phi_859_;
            phi_860_ = _e489;
            phi_861_ = _e491;
        } else {
            phi_860_ = f32();
            phi_861_ = true;
        }
        let _e493 = phi_860_;
        let _e495 = phi_861_;
        if _e495 {
            phi_865_ = _e471;
        } else {
            phi_865_ = _e493;
        }
        let _e497 = phi_865_;
        let _e501 = ((_e469 - (_e497 * 0.69314575f)) - (_e497 * 0.0000014286068f));
        phi_903_ = ((((((((((((((((1f / 5040f) * _e501) + (1f / 720f)) * _e501) + (1f / 120f)) * _e501) + (1f / 24f)) * _e501) + (1f / 6f)) * _e501) + 0.5f) * _e501) + 1f) * _e501) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e497), i32(-2147483648), (_e497 < bitcast<f32>(3472883712u))), 2147483647i, (_e497 > bitcast<f32>(1325400063u))), (_e497 == _e497)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e537 = phi_903_;
    if ((bitcast<u32>(_e456) & 2147483647u) > 2139095040u) {
        phi_991_ = _e456;
    } else {
        if (_e456 < -87f) {
            phi_914_ = -87f;
        } else {
            phi_914_ = _e456;
        }
        let _e543 = phi_914_;
        if (_e543 > 88f) {
            phi_919_ = 88f;
        } else {
            phi_919_ = _e543;
        }
        let _e546 = phi_919_;
        let _e548 = ((_e546 * 1.442695f) + 0.5f);
        if (_e548 > -8388608f) {
            let _e560 = f32(select(0i, select(select(i32(_e548), i32(-2147483648), (_e548 < bitcast<f32>(3472883712u))), 2147483647i, (_e548 > bitcast<f32>(1325400063u))), (_e548 == _e548)));
            if (_e560 > _e548) {
                phi_941_ = 1f;
            } else {
                phi_941_ = 0f;
            }
            let _e563 = phi_941_;
            if (_e548 < 8388608f) {
                phi_946_ = (_e560 - _e563);
                phi_947_ = false;
            } else {
                phi_946_ = f32();
                phi_947_ = true;
            }
            let _e566 = phi_946_;
            let _e568 = phi_947_;
            phi_948_ = _e566;
            phi_949_ = _e568;
        } else {
            phi_948_ = f32();
            phi_949_ = true;
        }
        let _e570 = phi_948_;
        let _e572 = phi_949_;
        if _e572 {
            phi_953_ = _e548;
        } else {
            phi_953_ = _e570;
        }
        let _e574 = phi_953_;
        let _e578 = ((_e546 - (_e574 * 0.69314575f)) - (_e574 * 0.0000014286068f));
        phi_991_ = ((((((((((((((((1f / 5040f) * _e578) + (1f / 720f)) * _e578) + (1f / 120f)) * _e578) + (1f / 24f)) * _e578) + (1f / 6f)) * _e578) + 0.5f) * _e578) + 1f) * _e578) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e574), i32(-2147483648), (_e574 < bitcast<f32>(3472883712u))), 2147483647i, (_e574 > bitcast<f32>(1325400063u))), (_e574 == _e574)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e614 = phi_991_;
    if ((bitcast<u32>(_e458) & 2147483647u) > 2139095040u) {
        phi_1079_ = _e458;
    } else {
        if (_e458 < -87f) {
            phi_1002_ = -87f;
        } else {
            phi_1002_ = _e458;
        }
        let _e620 = phi_1002_;
        if (_e620 > 88f) {
            phi_1007_ = 88f;
        } else {
            phi_1007_ = _e620;
        }
        let _e623 = phi_1007_;
        let _e625 = ((_e623 * 1.442695f) + 0.5f);
        if (_e625 > -8388608f) {
            let _e637 = f32(select(0i, select(select(i32(_e625), i32(-2147483648), (_e625 < bitcast<f32>(3472883712u))), 2147483647i, (_e625 > bitcast<f32>(1325400063u))), (_e625 == _e625)));
            if (_e637 > _e625) {
                phi_1029_ = 1f;
            } else {
                phi_1029_ = 0f;
            }
            let _e640 = phi_1029_;
            if (_e625 < 8388608f) {
                phi_1034_ = (_e637 - _e640);
                phi_1035_ = false;
            } else {
                phi_1034_ = f32();
                phi_1035_ = true;
            }
            let _e643 = phi_1034_;
            let _e645 = phi_1035_;
            phi_1036_ = _e643;
            phi_1037_ = _e645;
        } else {
            phi_1036_ = f32();
            phi_1037_ = true;
        }
        let _e647 = phi_1036_;
        let _e649 = phi_1037_;
        if _e649 {
            phi_1041_ = _e625;
        } else {
            phi_1041_ = _e647;
        }
        let _e651 = phi_1041_;
        let _e655 = ((_e623 - (_e651 * 0.69314575f)) - (_e651 * 0.0000014286068f));
        phi_1079_ = ((((((((((((((((1f / 5040f) * _e655) + (1f / 720f)) * _e655) + (1f / 120f)) * _e655) + (1f / 24f)) * _e655) + (1f / 6f)) * _e655) + 0.5f) * _e655) + 1f) * _e655) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e651), i32(-2147483648), (_e651 < bitcast<f32>(3472883712u))), 2147483647i, (_e651 > bitcast<f32>(1325400063u))), (_e651 == _e651)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e691 = phi_1079_;
    if ((bitcast<u32>(_e460) & 2147483647u) > 2139095040u) {
        phi_1167_ = _e460;
    } else {
        if (_e460 < -87f) {
            phi_1090_ = -87f;
        } else {
            phi_1090_ = _e460;
        }
        let _e697 = phi_1090_;
        if (_e697 > 88f) {
            phi_1095_ = 88f;
        } else {
            phi_1095_ = _e697;
        }
        let _e700 = phi_1095_;
        let _e702 = ((_e700 * 1.442695f) + 0.5f);
        if (_e702 > -8388608f) {
            let _e714 = f32(select(0i, select(select(i32(_e702), i32(-2147483648), (_e702 < bitcast<f32>(3472883712u))), 2147483647i, (_e702 > bitcast<f32>(1325400063u))), (_e702 == _e702)));
            if (_e714 > _e702) {
                phi_1117_ = 1f;
            } else {
                phi_1117_ = 0f;
            }
            let _e717 = phi_1117_;
            if (_e702 < 8388608f) {
                phi_1122_ = (_e714 - _e717);
                phi_1123_ = false;
            } else {
                phi_1122_ = f32();
                phi_1123_ = true;
            }
            let _e720 = phi_1122_;
            let _e722 = phi_1123_;
            phi_1124_ = _e720;
            phi_1125_ = _e722;
        } else {
            phi_1124_ = f32();
            phi_1125_ = true;
        }
        let _e724 = phi_1124_;
        let _e726 = phi_1125_;
        if _e726 {
            phi_1129_ = _e702;
        } else {
            phi_1129_ = _e724;
        }
        let _e728 = phi_1129_;
        let _e732 = ((_e700 - (_e728 * 0.69314575f)) - (_e728 * 0.0000014286068f));
        phi_1167_ = ((((((((((((((((1f / 5040f) * _e732) + (1f / 720f)) * _e732) + (1f / 120f)) * _e732) + (1f / 24f)) * _e732) + (1f / 6f)) * _e732) + 0.5f) * _e732) + 1f) * _e732) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e728), i32(-2147483648), (_e728 < bitcast<f32>(3472883712u))), 2147483647i, (_e728 > bitcast<f32>(1325400063u))), (_e728 == _e728)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e768 = phi_1167_;
    let _e770 = (vec4<f32>(1f, 1f, 1f, 1f).x - _e537);
    let _e772 = (vec4<f32>(1f, 1f, 1f, 1f).y - _e614);
    let _e774 = (vec4<f32>(1f, 1f, 1f, 1f).z - _e691);
    let _e776 = (vec4<f32>(1f, 1f, 1f, 1f).w - _e768);
    let _e778 = (*param_4).min_variance;
    let _e780 = ((_e778 * _e451) * _e451);
    let _e791 = ((((_e770 * param_6.x) + (_e772 * param_6.y)) + (_e774 * param_6.z)) + (_e776 * param_6.w));
    let _e792 = (_e770 - _e791);
    let _e793 = (_e772 - _e791);
    let _e794 = (_e774 - _e791);
    let _e795 = (_e776 - _e791);
    let _e810 = (((((_e792 * _e792) * param_6.x) + ((_e793 * _e793) * param_6.y)) + ((_e794 * _e794) * param_6.z)) + ((_e795 * _e795) * param_6.w));
    if ((bitcast<u32>(_e780) & 2147483647u) > 2139095040u) {
        phi_1220_ = true;
    } else {
        let _e814 = (_e780 > _e810);
        if _e814 {
        }
        phi_1220_ = _e814;
    }
    let _e816 = phi_1220_;
    if _e816 {
        phi_1224_ = _e780;
    } else {
        phi_1224_ = _e810;
    }
    let _e818 = phi_1224_;
    let _e819 = -(_e791);
    if (_e819 <= 0f) {
        let _e823 = ((bitcast<u32>(_e818) & 2147483647u) > 2139095040u);
        if _e823 {
        }
        phi_1236_ = _e823;
    } else {
        phi_1236_ = true;
    }
    let _e825 = phi_1236_;
    if _e825 {
        phi_1243_ = (_e818 / (_e818 + (_e819 * _e819)));
    } else {
        phi_1243_ = 1f;
    }
    let _e830 = phi_1243_;
    if ((bitcast<u32>(_e830) & 2147483647u) > 2139095040u) {
        phi_1254_ = true;
    } else {
        let _e834 = (_e830 < _e441);
        if _e834 {
        }
        phi_1254_ = _e834;
    }
    let _e836 = phi_1254_;
    if _e836 {
        phi_1258_ = _e830;
    } else {
        phi_1258_ = _e441;
    }
    let _e838 = phi_1258_;
    if ((bitcast<u32>(_e838) & 2147483647u) > 2139095040u) {
        phi_1275_ = _e838;
    } else {
        if (_e838 < 0f) {
            phi_1274_ = 0f;
        } else {
            if (_e838 > 1f) {
                phi_1273_ = 1f;
            } else {
                phi_1273_ = _e838;
            }
            let _e845 = phi_1273_;
            phi_1274_ = _e845;
        }
        let _e847 = phi_1274_;
        phi_1275_ = _e847;
    }
    let _e849 = phi_1275_;
    return _e849;
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
            let _e61 = phi_198_;
            phi_199_ = _e61;
        }
        let _e63 = phi_199_;
        phi_200_ = _e63;
    }
    let _e65 = phi_200_;
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
            let _e73 = phi_216_;
            phi_217_ = _e73;
        }
        let _e75 = phi_217_;
        phi_218_ = _e75;
    }
    let _e77 = phi_218_;
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
            let _e85 = phi_234_;
            phi_235_ = _e85;
        }
        let _e87 = phi_235_;
        phi_236_ = _e87;
    }
    let _e89 = phi_236_;
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
            let _e97 = phi_252_;
            phi_253_ = _e97;
        }
        let _e99 = phi_253_;
        phi_254_ = _e99;
    }
    let _e101 = phi_254_;
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
            let _e109 = phi_270_;
            phi_271_ = _e109;
        }
        let _e111 = phi_271_;
        phi_272_ = _e111;
    }
    let _e113 = phi_272_;
    let _e114 = (_e77 - _e65);
    let _e115 = (_e89 - _e65);
    let _e116 = (_e101 - _e65);
    let _e117 = (_e113 - _e65);
    if (_e114 >= 0f) {
        if (_e115 >= 0f) {
            if (_e116 >= 0f) {
                if (_e117 >= 0f) {
                    phi_309_ = !(((bitcast<u32>(((((_e114 * param_9.x) + (_e115 * param_9.y)) + (_e116 * param_9.z)) + (_e117 * param_9.w))) & 2147483647u) > 2139095040u));
                    phi_310_ = false;
                } else {
                    phi_309_ = bool();
                    phi_310_ = true;
                }
                let _e139 = phi_309_;
                let _e141 = phi_310_;
                phi_311_ = _e139;
                phi_312_ = false;
                phi_313_ = _e141;
            } else {
                phi_311_ = bool();
                phi_312_ = true;
                phi_313_ = false;
            }
            let _e143 = phi_311_;
            let _e145 = phi_312_;
            let _e147 = phi_313_;
            phi_314_ = _e143;
            phi_315_ = _e145;
            phi_316_ = _e147;
        } else {
            phi_314_ = bool();
            phi_315_ = true;
            phi_316_ = false;
        }
        let _e149 = phi_314_;
        let _e151 = phi_315_;
        let _e153 = phi_316_;
        phi_317_ = _e149;
        phi_318_ = _e151;
        phi_319_ = _e153;
    } else {
        phi_317_ = bool();
        phi_318_ = true;
        phi_319_ = false;
    }
    let _e155 = phi_317_;
    let _e157 = phi_318_;
    let _e159 = phi_319_;
    if _e157 {
        phi_323_ = true;
    } else {
        phi_323_ = _e159;
    }
    let _e161 = phi_323_;
    if _e161 {
        phi_327_ = false;
    } else {
        phi_327_ = _e155;
    }
    let _e163 = phi_327_;
    if _e163 {
        phi_332_ = 1f;
    } else {
        let _e164 = _lt_math_evsm_Evsm_bound_of_offsets(param_7, vec4<f32>(_e114, _e115, _e116, _e117), param_9);
        phi_332_ = _e164;
    }
    let _e166 = phi_332_;
    return _e166;
}

fn function_() {
    var local_1: lt_math_Evsm;
    var phi_1327_: bool;
    var phi_1328_: bool;
    var phi_1329_: bool;
    var phi_1330_: bool;
    var phi_1334_: bool;
    var phi_1378_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1382_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1456_: bool;
    var phi_1465_: bool;
    var phi_1474_: bool;
    var phi_1475_: bool;
    var phi_1476_: bool;
    var phi_1477_: bool;
    var phi_1478_: bool;
    var phi_1479_: bool;
    var phi_1480_: bool;
    var phi_1484_: bool;
    var phi_1574_: f32;
    var phi_1577_: f32;
    var phi_1606_: f32;
    var phi_1611_: f32;
    var phi_1612_: bool;
    var phi_1613_: f32;
    var phi_1614_: bool;
    var phi_1618_: f32;
    var phi_1638_: f32;
    var phi_1643_: f32;
    var phi_1644_: bool;
    var phi_1645_: f32;
    var phi_1646_: bool;
    var phi_1650_: f32;
    var phi_1702_: i32;
    var phi_1707_: i32;
    var phi_1712_: i32;
    var phi_1717_: i32;
    var phi_1726_: i32;
    var phi_1731_: i32;
    var phi_1736_: i32;
    var phi_1741_: i32;
    var phi_1792_: bool;
    var phi_1800_: bool;
    var phi_1812_: bool;
    var phi_1813_: bool;
    var phi_1817_: f32;
    var phi_1823_: f32;
    var phi_1825_: evaluate_Verdict;
    var phi_1830_: evaluate_Verdict;
    var phi_1831_: evaluate_Verdict;
    var phi_1835_: bool;
    var phi_1836_: u32;
    var phi_1847_: u32;

    let _e52 = id_1;
    let _e53 = local_2;
    let _e58 = arrayLength((&map.member));
    let _e63 = p.member.size[0u];
    let _e65 = p.member.size[1u];
    let _e66 = lt_shaders_entry_pixel_index(_e52, _e63, _e65);
    if (bitcast<i32>(_e66.root) != 0i) {
        let _e73 = p.member.projection;
        let _e74 = lt_math_OneLevel(_e73);
        let _e76 = p.member.light;
        let _e79 = samples.member[_e66.first_primitive].normal[0u];
        let _e81 = global[0u];
        if (_e79 == _e81) {
            let _e84 = samples.member[_e66.first_primitive].normal[1u];
            let _e86 = global[1u];
            if (_e84 == _e86) {
                let _e89 = samples.member[_e66.first_primitive].normal[2u];
                let _e91 = global[2u];
                phi_1327_ = (_e89 == _e91);
                phi_1328_ = false;
            } else {
                phi_1327_ = bool();
                phi_1328_ = true;
            }
            let _e94 = phi_1327_;
            let _e96 = phi_1328_;
            phi_1329_ = _e94;
            phi_1330_ = _e96;
        } else {
            phi_1329_ = bool();
            phi_1330_ = true;
        }
        let _e98 = phi_1329_;
        let _e100 = phi_1330_;
        if _e100 {
            phi_1334_ = false;
        } else {
            phi_1334_ = _e98;
        }
        let _e102 = phi_1334_;
        if !(_e102) {
            let _e105 = samples.member[_e66.first_primitive].normal;
            let _e107 = samples.member[_e66.first_primitive].position;
            if ((((_e105.x * (_e76.x - (_e107.x * _e76.w))) + (_e105.y * (_e76.y - (_e107.y * _e76.w)))) + (_e105.z * (_e76.z - (_e107.z * _e76.w)))) > 0f) {
                let _e131 = samples.member[_e66.first_primitive].flags;
                let _e139 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e145 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e139.unnamed.visibility, false), _e139.unnamed_1);
                phi_1378_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e145.unnamed, ((_e131 & 1u) == 0u));
            } else {
                let _e154 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e160 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e154.unnamed.visibility, false), _e154.unnamed_1);
                phi_1378_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e160.unnamed, true);
            }
            let _e165 = phi_1378_;
            phi_1382_ = _e165;
        } else {
            let _e171 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e177 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e171.unnamed.visibility, false), _e171.unnamed_1);
            phi_1382_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e177.unnamed, true);
        }
        let _e182 = phi_1382_;
        if _e182.unnamed_1 {
            phi_1831_ = evaluate_Verdict(_e182.unnamed.visibility, _e182.unnamed.is_doubted);
        } else {
            let _e190 = samples.member[_e66.first_primitive].position;
            let _e208 = ((((_e74.projection.row_w.x * _e190.x) + (_e74.projection.row_w.y * _e190.y)) + (_e74.projection.row_w.z * _e190.z)) + (_e74.projection.row_w.w * 1f));
            let _e222 = (((((_e74.projection.row_x.x * _e190.x) + (_e74.projection.row_x.y * _e190.y)) + (_e74.projection.row_x.z * _e190.z)) + (_e74.projection.row_x.w * 1f)) / _e208);
            let _e236 = (((((_e74.projection.row_y.x * _e190.x) + (_e74.projection.row_y.y * _e190.y)) + (_e74.projection.row_y.z * _e190.z)) + (_e74.projection.row_y.w * 1f)) / _e208);
            let _e249 = ((((_e74.projection.row_z.x * _e190.x) + (_e74.projection.row_z.y * _e190.y)) + (_e74.projection.row_z.z * _e190.z)) + (_e74.projection.row_z.w * 1f));
            if (_e208 > 0f) {
                if (_e222 >= 0f) {
                    phi_1456_ = (_e222 <= 1f);
                } else {
                    phi_1456_ = false;
                }
                let _e254 = phi_1456_;
                if _e254 {
                    if (_e236 >= 0f) {
                        phi_1465_ = (_e236 <= 1f);
                    } else {
                        phi_1465_ = false;
                    }
                    let _e258 = phi_1465_;
                    if _e258 {
                        if (_e249 >= 0f) {
                            phi_1474_ = (_e249 <= 1f);
                        } else {
                            phi_1474_ = false;
                        }
                        let _e262 = phi_1474_;
                        phi_1475_ = _e262;
                        phi_1476_ = false;
                    } else {
                        phi_1475_ = bool();
                        phi_1476_ = true;
                    }
                    let _e264 = phi_1475_;
                    let _e266 = phi_1476_;
                    phi_1477_ = _e264;
                    phi_1478_ = _e266;
                } else {
                    phi_1477_ = bool();
                    phi_1478_ = true;
                }
                let _e268 = phi_1477_;
                let _e270 = phi_1478_;
                phi_1479_ = _e268;
                phi_1480_ = _e270;
            } else {
                phi_1479_ = bool();
                phi_1480_ = true;
            }
            let _e272 = phi_1479_;
            let _e274 = phi_1480_;
            if _e274 {
                phi_1484_ = false;
            } else {
                phi_1484_ = _e272;
            }
            let _e276 = phi_1484_;
            if _e276 {
                if (0f > 0f) {
                    let _e279 = samples.member[_e66.first_primitive].normal;
                    let _e281 = p.member.map_size;
                    let _e351 = ((abs(((((_e73.row_x.x * _e279.x) + (_e73.row_x.y * _e279.y)) + (_e73.row_x.z * _e279.z)) / (((_e73.row_x.x * _e73.row_x.x) + (_e73.row_x.y * _e73.row_x.y)) + (_e73.row_x.z * _e73.row_x.z)))) + abs(((((_e73.row_y.x * _e279.x) + (_e73.row_y.y * _e279.y)) + (_e73.row_y.z * _e279.z)) / (((_e73.row_y.x * _e73.row_y.x) + (_e73.row_y.y * _e73.row_y.y)) + (_e73.row_y.z * _e73.row_y.z))))) / (abs(((((_e73.row_z.x * _e279.x) + (_e73.row_z.y * _e279.y)) + (_e73.row_z.z * _e279.z)) / (((_e73.row_z.x * _e73.row_z.x) + (_e73.row_z.y * _e73.row_z.y)) + (_e73.row_z.z * _e73.row_z.z)))) * f32(_e281)));
                    if (_e351 < 0.002f) {
                        phi_1574_ = _e351;
                    } else {
                        phi_1574_ = 0.002f;
                    }
                    let _e354 = phi_1574_;
                    phi_1577_ = (_e249 - (0f * _e354));
                } else {
                    phi_1577_ = _e249;
                }
                let _e358 = phi_1577_;
                let _e360 = p.member.map_size;
                let _e361 = f32(_e360);
                let _e364 = ((_e222 * _e361) - 0.5f);
                let _e365 = ((_e236 * _e361) - 0.5f);
                if (_e364 > -8388608f) {
                    let _e377 = f32(select(0i, select(select(i32(_e364), i32(-2147483648), (_e364 < bitcast<f32>(3472883712u))), 2147483647i, (_e364 > bitcast<f32>(1325400063u))), (_e364 == _e364)));
                    if (_e377 > _e364) {
                        phi_1606_ = 1f;
                    } else {
                        phi_1606_ = 0f;
                    }
                    let _e380 = phi_1606_;
                    if (_e364 < 8388608f) {
                        phi_1611_ = (_e377 - _e380);
                        phi_1612_ = false;
                    } else {
                        phi_1611_ = f32();
                        phi_1612_ = true;
                    }
                    let _e383 = phi_1611_;
                    let _e385 = phi_1612_;
                    phi_1613_ = _e383;
                    phi_1614_ = _e385;
                } else {
                    phi_1613_ = f32();
                    phi_1614_ = true;
                }
                let _e387 = phi_1613_;
                let _e389 = phi_1614_;
                if _e389 {
                    phi_1618_ = _e364;
                } else {
                    phi_1618_ = _e387;
                }
                let _e391 = phi_1618_;
                if (_e365 > -8388608f) {
                    let _e403 = f32(select(0i, select(select(i32(_e365), i32(-2147483648), (_e365 < bitcast<f32>(3472883712u))), 2147483647i, (_e365 > bitcast<f32>(1325400063u))), (_e365 == _e365)));
                    if (_e403 > _e365) {
                        phi_1638_ = 1f;
                    } else {
                        phi_1638_ = 0f;
                    }
                    let _e406 = phi_1638_;
                    if (_e365 < 8388608f) {
                        phi_1643_ = (_e403 - _e406);
                        phi_1644_ = false;
                    } else {
                        phi_1643_ = f32();
                        phi_1644_ = true;
                    }
                    let _e409 = phi_1643_;
                    let _e411 = phi_1644_;
                    phi_1645_ = _e409;
                    phi_1646_ = _e411;
                } else {
                    phi_1645_ = f32();
                    phi_1646_ = true;
                }
                let _e413 = phi_1645_;
                let _e415 = phi_1646_;
                if _e415 {
                    phi_1650_ = _e365;
                } else {
                    phi_1650_ = _e413;
                }
                let _e417 = phi_1650_;
                let _e418 = (_e364 - _e391);
                let _e419 = (_e365 - _e417);
                let _e428 = select(0i, select(select(i32(_e391), i32(-2147483648), (_e391 < bitcast<f32>(3472883712u))), 2147483647i, (_e391 > bitcast<f32>(1325400063u))), (_e391 == _e391));
                let _e437 = select(0i, select(select(i32(_e417), i32(-2147483648), (_e417 < bitcast<f32>(3472883712u))), 2147483647i, (_e417 > bitcast<f32>(1325400063u))), (_e417 == _e417));
                let _e448 = p.member.test;
                let _e449 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e448);
                let _e451 = p.member.map_size;
                local_1 = lt_math_Evsm(_e449.positive_exponent, _e449.negative_exponent, _e449.min_variance);
                let _e457 = ((0u * _e451) * _e451);
                let _e459 = (bitcast<i32>(_e451) - 1i);
                if (_e428 > 0i) {
                    phi_1702_ = _e428;
                } else {
                    phi_1702_ = 0i;
                }
                let _e462 = phi_1702_;
                if (_e437 > 0i) {
                    phi_1707_ = _e437;
                } else {
                    phi_1707_ = 0i;
                }
                let _e465 = phi_1707_;
                if (_e462 < _e459) {
                    phi_1712_ = _e462;
                } else {
                    phi_1712_ = _e459;
                }
                let _e468 = phi_1712_;
                if (_e465 < _e459) {
                    phi_1717_ = _e465;
                } else {
                    phi_1717_ = _e459;
                }
                let _e471 = phi_1717_;
                let _e472 = bitcast<u32>(_e468);
                let _e474 = (_e428 + 1i);
                let _e475 = (_e437 + 1i);
                if (_e474 > 0i) {
                    phi_1726_ = _e474;
                } else {
                    phi_1726_ = 0i;
                }
                let _e478 = phi_1726_;
                if (_e475 > 0i) {
                    phi_1731_ = _e475;
                } else {
                    phi_1731_ = 0i;
                }
                let _e481 = phi_1731_;
                if (_e478 < _e459) {
                    phi_1736_ = _e478;
                } else {
                    phi_1736_ = _e459;
                }
                let _e484 = phi_1736_;
                if (_e481 < _e459) {
                    phi_1741_ = _e481;
                } else {
                    phi_1741_ = _e459;
                }
                let _e487 = phi_1741_;
                let _e488 = bitcast<u32>(_e484);
                let _e490 = (bitcast<u32>(_e471) * _e451);
                let _e491 = (bitcast<u32>(_e487) * _e451);
                let _e496 = ((_e490 + _e472) + _e457);
                let _e497 = ((_e490 + _e488) + _e457);
                let _e498 = ((_e491 + _e472) + _e457);
                let _e499 = ((_e491 + _e488) + _e457);
                if (_e496 < _e58) {
                } else {
                    return;
                }
                let _e503 = map.member[(0u + _e496)];
                if (_e497 < _e58) {
                } else {
                    return;
                }
                let _e507 = map.member[(0u + _e497)];
                if (_e498 < _e58) {
                } else {
                    return;
                }
                let _e511 = map.member[(0u + _e498)];
                if (_e499 < _e58) {
                } else {
                    return;
                }
                let _e515 = map.member[(0u + _e499)];
                let _e517 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local_1), vec4<f32>(_e503, _e507, _e511, _e515), vec4<f32>(((1f - _e418) * (1f - _e419)), (_e418 * (1f - _e419)), ((1f - _e418) * _e419), (_e418 * _e419)), _e358);
                let _e519 = p.member.epsilon;
                if (_e517 <= _e519) {
                    phi_1792_ = true;
                } else {
                    phi_1792_ = (_e517 >= (1f - _e519));
                }
                let _e524 = phi_1792_;
                if ((bitcast<u32>(_e517) & 2147483647u) > 2139095040u) {
                    phi_1800_ = true;
                } else {
                    phi_1800_ = !(_e524);
                }
                let _e530 = phi_1800_;
                if _e530 {
                    if (_e517 > 0f) {
                        if (_e517 < 1f) {
                            phi_1812_ = false;
                        } else {
                            phi_1812_ = true;
                        }
                        let _e534 = phi_1812_;
                        phi_1813_ = _e534;
                    } else {
                        phi_1813_ = true;
                    }
                    let _e536 = phi_1813_;
                    if _e536 {
                        phi_1817_ = 0.5f;
                    } else {
                        phi_1817_ = _e517;
                    }
                    let _e538 = phi_1817_;
                    phi_1825_ = evaluate_Verdict(_e538, true);
                } else {
                    if (_e517 > 0.5f) {
                        phi_1823_ = 1f;
                    } else {
                        phi_1823_ = 0f;
                    }
                    let _e542 = phi_1823_;
                    phi_1825_ = evaluate_Verdict(_e542, false);
                }
                let _e545 = phi_1825_;
                phi_1830_ = evaluate_Verdict(_e545.visibility, _e545.is_doubted);
            } else {
                phi_1830_ = evaluate_Verdict(0.5f, true);
            }
            let _e551 = phi_1830_;
            phi_1831_ = _e551;
        }
        let _e553 = phi_1831_;
        visibility.member[_e66.first_primitive] = _e553.visibility;
        phi_1835_ = _e553.is_doubted;
        phi_1836_ = _e66.first_primitive;
    } else {
        phi_1835_ = false;
        phi_1836_ = 0u;
    }
    let _e558 = phi_1835_;
    let _e560 = phi_1836_;
    if (_e53 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e558 {
        let _e564 = atomicAdd((&shared_[0u]), 1u);
        phi_1847_ = _e564;
    } else {
        phi_1847_ = 0u;
    }
    let _e566 = phi_1847_;
    workgroupBarrier();
    if (_e53 == 0u) {
        let _e570 = atomicLoad((&shared_[0u]));
        let _e571 = atomicAdd((&list.member[3u]), _e570);
        atomicStore((&shared_[1u]), _e571);
    }
    workgroupBarrier();
    if _e558 {
        let _e574 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e574) + _e566)]), _e560);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_evsm_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
