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
    var phi_159_: lt_bvh_traverse_Tree;
    var phi_160_: bool;
    var phi_161_: lt_bvh_traverse_Tree;
    var phi_162_: bool;
    var phi_167_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_159_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_160_ = false;
        } else {
            phi_159_ = lt_bvh_traverse_Tree();
            phi_160_ = true;
        }
        let _e64 = phi_159_;
        let _e66 = phi_160_;
        phi_161_ = _e64;
        phi_162_ = _e66;
    } else {
        phi_161_ = lt_bvh_traverse_Tree();
        phi_162_ = true;
    }
    let _e68 = phi_161_;
    let _e70 = phi_162_;
    if _e70 {
        phi_167_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_167_ = _e68;
    }
    let _e75 = phi_167_;
    return lt_bvh_traverse_Tree(_e75.root, _e75.first_primitive);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> lt_math_Evsm {
    return lt_math_Evsm(param_3.x, param_3.y, param_3.z);
}

fn _lt_math_evsm_Evsm_bound_of_offsets(param_4: ptr<function, lt_math_Evsm>, param_5: vec4<f32>, param_6: vec4<f32>) -> f32 {
    var phi_347_: bool;
    var phi_351_: f32;
    var phi_370_: f32;
    var phi_375_: f32;
    var phi_397_: f32;
    var phi_402_: f32;
    var phi_403_: bool;
    var phi_404_: f32;
    var phi_405_: bool;
    var phi_409_: f32;
    var phi_447_: f32;
    var phi_458_: f32;
    var phi_463_: f32;
    var phi_485_: f32;
    var phi_490_: f32;
    var phi_491_: bool;
    var phi_492_: f32;
    var phi_493_: bool;
    var phi_497_: f32;
    var phi_535_: f32;
    var phi_546_: f32;
    var phi_551_: f32;
    var phi_573_: f32;
    var phi_578_: f32;
    var phi_579_: bool;
    var phi_580_: f32;
    var phi_581_: bool;
    var phi_585_: f32;
    var phi_623_: f32;
    var phi_634_: f32;
    var phi_639_: f32;
    var phi_661_: f32;
    var phi_666_: f32;
    var phi_667_: bool;
    var phi_668_: f32;
    var phi_669_: bool;
    var phi_673_: f32;
    var phi_711_: f32;
    var phi_764_: bool;
    var phi_768_: f32;
    var phi_780_: bool;
    var phi_787_: f32;
    var phi_800_: bool;
    var phi_804_: f32;
    var phi_824_: f32;
    var phi_829_: f32;
    var phi_851_: f32;
    var phi_856_: f32;
    var phi_857_: bool;
    var phi_858_: f32;
    var phi_859_: bool;
    var phi_863_: f32;
    var phi_901_: f32;
    var phi_912_: f32;
    var phi_917_: f32;
    var phi_939_: f32;
    var phi_944_: f32;
    var phi_945_: bool;
    var phi_946_: f32;
    var phi_947_: bool;
    var phi_951_: f32;
    var phi_989_: f32;
    var phi_1000_: f32;
    var phi_1005_: f32;
    var phi_1027_: f32;
    var phi_1032_: f32;
    var phi_1033_: bool;
    var phi_1034_: f32;
    var phi_1035_: bool;
    var phi_1039_: f32;
    var phi_1077_: f32;
    var phi_1088_: f32;
    var phi_1093_: f32;
    var phi_1115_: f32;
    var phi_1120_: f32;
    var phi_1121_: bool;
    var phi_1122_: f32;
    var phi_1123_: bool;
    var phi_1127_: f32;
    var phi_1165_: f32;
    var phi_1218_: bool;
    var phi_1222_: f32;
    var phi_1234_: bool;
    var phi_1241_: f32;
    var phi_1252_: bool;
    var phi_1256_: f32;
    var phi_1271_: f32;
    var phi_1272_: f32;
    var phi_1273_: f32;

    let _e55 = (*param_4).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_347_ = true;
    } else {
        let _e59 = (42f < _e55);
        if _e59 {
        }
        phi_347_ = _e59;
    }
    let _e61 = phi_347_;
    if _e61 {
        phi_351_ = 42f;
    } else {
        phi_351_ = _e55;
    }
    let _e63 = phi_351_;
    let _e65 = (_e63 * param_5.x);
    let _e67 = (_e63 * param_5.y);
    let _e69 = (_e63 * param_5.z);
    let _e71 = (_e63 * param_5.w);
    if ((bitcast<u32>(_e65) & 2147483647u) > 2139095040u) {
        phi_447_ = _e65;
    } else {
        if (_e65 < -87f) {
            phi_370_ = -87f;
        } else {
            phi_370_ = _e65;
        }
        let _e77 = phi_370_;
        if (_e77 > 88f) {
            phi_375_ = 88f;
        } else {
            phi_375_ = _e77;
        }
        let _e80 = phi_375_;
        let _e82 = ((_e80 * 1.442695f) + 0.5f);
        if (_e82 > -8388608f) {
            let _e94 = f32(select(0i, select(select(i32(_e82), i32(-2147483648), (_e82 < bitcast<f32>(3472883712u))), 2147483647i, (_e82 > bitcast<f32>(1325400063u))), (_e82 == _e82)));
            if (_e94 > _e82) {
                phi_397_ = 1f;
            } else {
                phi_397_ = 0f;
            }
            let _e97 = phi_397_;
            if (_e82 < 8388608f) {
                phi_402_ = (_e94 - _e97);
                phi_403_ = false;
            } else {
                phi_402_ = f32();
                phi_403_ = true;
            }
            let _e100 = phi_402_;
            let _e102 = phi_403_;
            phi_404_ = _e100;
            phi_405_ = _e102;
        } else {
            phi_404_ = f32();
            phi_405_ = true;
        }
        let _e104 = phi_404_;
        let _e106 = phi_405_;
        if _e106 {
            phi_409_ = _e82;
        } else {
            phi_409_ = _e104;
        }
        let _e108 = phi_409_;
        let _e112 = ((_e80 - (_e108 * 0.69314575f)) - (_e108 * 0.0000014286068f));
        phi_447_ = ((((((((((((((((1f / 5040f) * _e112) + (1f / 720f)) * _e112) + (1f / 120f)) * _e112) + (1f / 24f)) * _e112) + (1f / 6f)) * _e112) + 0.5f) * _e112) + 1f) * _e112) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e108), i32(-2147483648), (_e108 < bitcast<f32>(3472883712u))), 2147483647i, (_e108 > bitcast<f32>(1325400063u))), (_e108 == _e108)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e148 = phi_447_;
    if ((bitcast<u32>(_e67) & 2147483647u) > 2139095040u) {
        phi_535_ = _e67;
    } else {
        if (_e67 < -87f) {
            phi_458_ = -87f;
        } else {
            phi_458_ = _e67;
        }
        let _e154 = phi_458_;
        if (_e154 > 88f) {
            phi_463_ = 88f;
        } else {
            phi_463_ = _e154;
        }
        let _e157 = phi_463_;
        let _e159 = ((_e157 * 1.442695f) + 0.5f);
        if (_e159 > -8388608f) {
            let _e171 = f32(select(0i, select(select(i32(_e159), i32(-2147483648), (_e159 < bitcast<f32>(3472883712u))), 2147483647i, (_e159 > bitcast<f32>(1325400063u))), (_e159 == _e159)));
            if (_e171 > _e159) {
                phi_485_ = 1f;
            } else {
                phi_485_ = 0f;
            }
            let _e174 = phi_485_;
            if (_e159 < 8388608f) {
                phi_490_ = (_e171 - _e174);
                phi_491_ = false;
            } else {
                phi_490_ = f32();
                phi_491_ = true;
            }
            let _e177 = phi_490_;
            let _e179 = phi_491_;
            phi_492_ = _e177;
            phi_493_ = _e179;
        } else {
            phi_492_ = f32();
            phi_493_ = true;
        }
        let _e181 = phi_492_;
        let _e183 = phi_493_;
        if _e183 {
            phi_497_ = _e159;
        } else {
            phi_497_ = _e181;
        }
        let _e185 = phi_497_;
        let _e189 = ((_e157 - (_e185 * 0.69314575f)) - (_e185 * 0.0000014286068f));
        phi_535_ = ((((((((((((((((1f / 5040f) * _e189) + (1f / 720f)) * _e189) + (1f / 120f)) * _e189) + (1f / 24f)) * _e189) + (1f / 6f)) * _e189) + 0.5f) * _e189) + 1f) * _e189) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e185), i32(-2147483648), (_e185 < bitcast<f32>(3472883712u))), 2147483647i, (_e185 > bitcast<f32>(1325400063u))), (_e185 == _e185)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e225 = phi_535_;
    if ((bitcast<u32>(_e69) & 2147483647u) > 2139095040u) {
        phi_623_ = _e69;
    } else {
        if (_e69 < -87f) {
            phi_546_ = -87f;
        } else {
            phi_546_ = _e69;
        }
        let _e231 = phi_546_;
        if (_e231 > 88f) {
            phi_551_ = 88f;
        } else {
            phi_551_ = _e231;
        }
        let _e234 = phi_551_;
        let _e236 = ((_e234 * 1.442695f) + 0.5f);
        if (_e236 > -8388608f) {
            let _e248 = f32(select(0i, select(select(i32(_e236), i32(-2147483648), (_e236 < bitcast<f32>(3472883712u))), 2147483647i, (_e236 > bitcast<f32>(1325400063u))), (_e236 == _e236)));
            if (_e248 > _e236) {
                phi_573_ = 1f;
            } else {
                phi_573_ = 0f;
            }
            let _e251 = phi_573_;
            if (_e236 < 8388608f) {
                phi_578_ = (_e248 - _e251);
                phi_579_ = false;
            } else {
                phi_578_ = f32();
                phi_579_ = true;
            }
            let _e254 = phi_578_;
            let _e256 = phi_579_;
            phi_580_ = _e254;
            phi_581_ = _e256;
        } else {
            phi_580_ = f32();
            phi_581_ = true;
        }
        let _e258 = phi_580_;
        let _e260 = phi_581_;
        if _e260 {
            phi_585_ = _e236;
        } else {
            phi_585_ = _e258;
        }
        let _e262 = phi_585_;
        let _e266 = ((_e234 - (_e262 * 0.69314575f)) - (_e262 * 0.0000014286068f));
        phi_623_ = ((((((((((((((((1f / 5040f) * _e266) + (1f / 720f)) * _e266) + (1f / 120f)) * _e266) + (1f / 24f)) * _e266) + (1f / 6f)) * _e266) + 0.5f) * _e266) + 1f) * _e266) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e262), i32(-2147483648), (_e262 < bitcast<f32>(3472883712u))), 2147483647i, (_e262 > bitcast<f32>(1325400063u))), (_e262 == _e262)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e302 = phi_623_;
    if ((bitcast<u32>(_e71) & 2147483647u) > 2139095040u) {
        phi_711_ = _e71;
    } else {
        if (_e71 < -87f) {
            phi_634_ = -87f;
        } else {
            phi_634_ = _e71;
        }
        let _e308 = phi_634_;
        if (_e308 > 88f) {
            phi_639_ = 88f;
        } else {
            phi_639_ = _e308;
        }
        let _e311 = phi_639_;
        let _e313 = ((_e311 * 1.442695f) + 0.5f);
        if (_e313 > -8388608f) {
            let _e325 = f32(select(0i, select(select(i32(_e313), i32(-2147483648), (_e313 < bitcast<f32>(3472883712u))), 2147483647i, (_e313 > bitcast<f32>(1325400063u))), (_e313 == _e313)));
            if (_e325 > _e313) {
                phi_661_ = 1f;
            } else {
                phi_661_ = 0f;
            }
            let _e328 = phi_661_;
            if (_e313 < 8388608f) {
                phi_666_ = (_e325 - _e328);
                phi_667_ = false;
            } else {
                phi_666_ = f32();
                phi_667_ = true;
            }
            let _e331 = phi_666_;
            let _e333 = phi_667_;
            phi_668_ = _e331;
            phi_669_ = _e333;
        } else {
            phi_668_ = f32();
            phi_669_ = true;
        }
        let _e335 = phi_668_;
        let _e337 = phi_669_;
        if _e337 {
            phi_673_ = _e313;
        } else {
            phi_673_ = _e335;
        }
        let _e339 = phi_673_;
        let _e343 = ((_e311 - (_e339 * 0.69314575f)) - (_e339 * 0.0000014286068f));
        phi_711_ = ((((((((((((((((1f / 5040f) * _e343) + (1f / 720f)) * _e343) + (1f / 120f)) * _e343) + (1f / 24f)) * _e343) + (1f / 6f)) * _e343) + 0.5f) * _e343) + 1f) * _e343) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e339), i32(-2147483648), (_e339 < bitcast<f32>(3472883712u))), 2147483647i, (_e339 > bitcast<f32>(1325400063u))), (_e339 == _e339)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e379 = phi_711_;
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
        phi_764_ = true;
    } else {
        let _e425 = (_e391 > _e421);
        if _e425 {
        }
        phi_764_ = _e425;
    }
    let _e427 = phi_764_;
    if _e427 {
        phi_768_ = _e391;
    } else {
        phi_768_ = _e421;
    }
    let _e429 = phi_768_;
    let _e430 = -(_e402);
    if (_e430 <= 0f) {
        let _e434 = ((bitcast<u32>(_e429) & 2147483647u) > 2139095040u);
        if _e434 {
        }
        phi_780_ = _e434;
    } else {
        phi_780_ = true;
    }
    let _e436 = phi_780_;
    if _e436 {
        phi_787_ = (_e429 / (_e429 + (_e430 * _e430)));
    } else {
        phi_787_ = 1f;
    }
    let _e441 = phi_787_;
    let _e443 = (*param_4).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_800_ = true;
    } else {
        let _e447 = (42f < _e443);
        if _e447 {
        }
        phi_800_ = _e447;
    }
    let _e449 = phi_800_;
    if _e449 {
        phi_804_ = 42f;
    } else {
        phi_804_ = _e443;
    }
    let _e451 = phi_804_;
    let _e452 = -(_e451);
    let _e454 = (_e452 * param_5.x);
    let _e456 = (_e452 * param_5.y);
    let _e458 = (_e452 * param_5.z);
    let _e460 = (_e452 * param_5.w);
    if ((bitcast<u32>(_e454) & 2147483647u) > 2139095040u) {
        phi_901_ = _e454;
    } else {
        if (_e454 < -87f) {
            phi_824_ = -87f;
        } else {
            phi_824_ = _e454;
        }
        let _e466 = phi_824_;
        if (_e466 > 88f) {
            phi_829_ = 88f;
        } else {
            phi_829_ = _e466;
        }
        let _e469 = phi_829_;
        let _e471 = ((_e469 * 1.442695f) + 0.5f);
        if (_e471 > -8388608f) {
            let _e483 = f32(select(0i, select(select(i32(_e471), i32(-2147483648), (_e471 < bitcast<f32>(3472883712u))), 2147483647i, (_e471 > bitcast<f32>(1325400063u))), (_e471 == _e471)));
            if (_e483 > _e471) {
                phi_851_ = 1f;
            } else {
                phi_851_ = 0f;
            }
            let _e486 = phi_851_;
            if (_e471 < 8388608f) {
                phi_856_ = (_e483 - _e486);
                phi_857_ = false;
            } else {
                phi_856_ = f32();
                phi_857_ = true;
            }
            let _e489 = phi_856_;
            let _e491 = phi_857_;
            phi_858_ = _e489;
            phi_859_ = _e491;
        } else {
            phi_858_ = f32();
            phi_859_ = true;
        }
        let _e493 = phi_858_;
        let _e495 = phi_859_;
        if _e495 {
            phi_863_ = _e471;
        } else {
            phi_863_ = _e493;
        }
        let _e497 = phi_863_;
        let _e501 = ((_e469 - (_e497 * 0.69314575f)) - (_e497 * 0.0000014286068f));
        phi_901_ = ((((((((((((((((1f / 5040f) * _e501) + (1f / 720f)) * _e501) + (1f / 120f)) * _e501) + (1f / 24f)) * _e501) + (1f / 6f)) * _e501) + 0.5f) * _e501) + 1f) * _e501) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e497), i32(-2147483648), (_e497 < bitcast<f32>(3472883712u))), 2147483647i, (_e497 > bitcast<f32>(1325400063u))), (_e497 == _e497)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e537 = phi_901_;
    if ((bitcast<u32>(_e456) & 2147483647u) > 2139095040u) {
        phi_989_ = _e456;
    } else {
        if (_e456 < -87f) {
            phi_912_ = -87f;
        } else {
            phi_912_ = _e456;
        }
        let _e543 = phi_912_;
        if (_e543 > 88f) {
            phi_917_ = 88f;
        } else {
            phi_917_ = _e543;
        }
        let _e546 = phi_917_;
        let _e548 = ((_e546 * 1.442695f) + 0.5f);
        if (_e548 > -8388608f) {
            let _e560 = f32(select(0i, select(select(i32(_e548), i32(-2147483648), (_e548 < bitcast<f32>(3472883712u))), 2147483647i, (_e548 > bitcast<f32>(1325400063u))), (_e548 == _e548)));
            if (_e560 > _e548) {
                phi_939_ = 1f;
            } else {
                phi_939_ = 0f;
            }
            let _e563 = phi_939_;
            if (_e548 < 8388608f) {
                phi_944_ = (_e560 - _e563);
                phi_945_ = false;
            } else {
                phi_944_ = f32();
                phi_945_ = true;
            }
            let _e566 = phi_944_;
            let _e568 = phi_945_;
            phi_946_ = _e566;
            phi_947_ = _e568;
        } else {
            phi_946_ = f32();
            phi_947_ = true;
        }
        let _e570 = phi_946_;
        let _e572 = phi_947_;
        if _e572 {
            phi_951_ = _e548;
        } else {
            phi_951_ = _e570;
        }
        let _e574 = phi_951_;
        let _e578 = ((_e546 - (_e574 * 0.69314575f)) - (_e574 * 0.0000014286068f));
        phi_989_ = ((((((((((((((((1f / 5040f) * _e578) + (1f / 720f)) * _e578) + (1f / 120f)) * _e578) + (1f / 24f)) * _e578) + (1f / 6f)) * _e578) + 0.5f) * _e578) + 1f) * _e578) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e574), i32(-2147483648), (_e574 < bitcast<f32>(3472883712u))), 2147483647i, (_e574 > bitcast<f32>(1325400063u))), (_e574 == _e574)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e614 = phi_989_;
    if ((bitcast<u32>(_e458) & 2147483647u) > 2139095040u) {
        phi_1077_ = _e458;
    } else {
        if (_e458 < -87f) {
            phi_1000_ = -87f;
        } else {
            phi_1000_ = _e458;
        }
        let _e620 = phi_1000_;
        if (_e620 > 88f) {
            phi_1005_ = 88f;
        } else {
            phi_1005_ = _e620;
        }
        let _e623 = phi_1005_;
        let _e625 = ((_e623 * 1.442695f) + 0.5f);
        if (_e625 > -8388608f) {
            let _e637 = f32(select(0i, select(select(i32(_e625), i32(-2147483648), (_e625 < bitcast<f32>(3472883712u))), 2147483647i, (_e625 > bitcast<f32>(1325400063u))), (_e625 == _e625)));
            if (_e637 > _e625) {
                phi_1027_ = 1f;
            } else {
                phi_1027_ = 0f;
            }
            let _e640 = phi_1027_;
            if (_e625 < 8388608f) {
                phi_1032_ = (_e637 - _e640);
                phi_1033_ = false;
            } else {
                phi_1032_ = f32();
                phi_1033_ = true;
            }
            let _e643 = phi_1032_;
            let _e645 = phi_1033_;
            phi_1034_ = _e643;
            phi_1035_ = _e645;
        } else {
            phi_1034_ = f32();
            phi_1035_ = true;
        }
        let _e647 = phi_1034_;
        let _e649 = phi_1035_;
        if _e649 {
            phi_1039_ = _e625;
        } else {
            phi_1039_ = _e647;
        }
        let _e651 = phi_1039_;
        let _e655 = ((_e623 - (_e651 * 0.69314575f)) - (_e651 * 0.0000014286068f));
        phi_1077_ = ((((((((((((((((1f / 5040f) * _e655) + (1f / 720f)) * _e655) + (1f / 120f)) * _e655) + (1f / 24f)) * _e655) + (1f / 6f)) * _e655) + 0.5f) * _e655) + 1f) * _e655) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e651), i32(-2147483648), (_e651 < bitcast<f32>(3472883712u))), 2147483647i, (_e651 > bitcast<f32>(1325400063u))), (_e651 == _e651)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e691 = phi_1077_;
    if ((bitcast<u32>(_e460) & 2147483647u) > 2139095040u) {
        phi_1165_ = _e460;
    } else {
        if (_e460 < -87f) {
            phi_1088_ = -87f;
        } else {
            phi_1088_ = _e460;
        }
        let _e697 = phi_1088_;
        if (_e697 > 88f) {
            phi_1093_ = 88f;
        } else {
            phi_1093_ = _e697;
        }
        let _e700 = phi_1093_;
        let _e702 = ((_e700 * 1.442695f) + 0.5f);
        if (_e702 > -8388608f) {
            let _e714 = f32(select(0i, select(select(i32(_e702), i32(-2147483648), (_e702 < bitcast<f32>(3472883712u))), 2147483647i, (_e702 > bitcast<f32>(1325400063u))), (_e702 == _e702)));
            if (_e714 > _e702) {
                phi_1115_ = 1f;
            } else {
                phi_1115_ = 0f;
            }
            let _e717 = phi_1115_;
            if (_e702 < 8388608f) {
                phi_1120_ = (_e714 - _e717);
                phi_1121_ = false;
            } else {
                phi_1120_ = f32();
                phi_1121_ = true;
            }
            let _e720 = phi_1120_;
            let _e722 = phi_1121_;
            phi_1122_ = _e720;
            phi_1123_ = _e722;
        } else {
            phi_1122_ = f32();
            phi_1123_ = true;
        }
        let _e724 = phi_1122_;
        let _e726 = phi_1123_;
        if _e726 {
            phi_1127_ = _e702;
        } else {
            phi_1127_ = _e724;
        }
        let _e728 = phi_1127_;
        let _e732 = ((_e700 - (_e728 * 0.69314575f)) - (_e728 * 0.0000014286068f));
        phi_1165_ = ((((((((((((((((1f / 5040f) * _e732) + (1f / 720f)) * _e732) + (1f / 120f)) * _e732) + (1f / 24f)) * _e732) + (1f / 6f)) * _e732) + 0.5f) * _e732) + 1f) * _e732) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e728), i32(-2147483648), (_e728 < bitcast<f32>(3472883712u))), 2147483647i, (_e728 > bitcast<f32>(1325400063u))), (_e728 == _e728)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e768 = phi_1165_;
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
        phi_1218_ = true;
    } else {
        let _e814 = (_e780 > _e810);
        if _e814 {
        }
        phi_1218_ = _e814;
    }
    let _e816 = phi_1218_;
    if _e816 {
        phi_1222_ = _e780;
    } else {
        phi_1222_ = _e810;
    }
    let _e818 = phi_1222_;
    let _e819 = -(_e791);
    if (_e819 <= 0f) {
        let _e823 = ((bitcast<u32>(_e818) & 2147483647u) > 2139095040u);
        if _e823 {
        }
        phi_1234_ = _e823;
    } else {
        phi_1234_ = true;
    }
    let _e825 = phi_1234_;
    if _e825 {
        phi_1241_ = (_e818 / (_e818 + (_e819 * _e819)));
    } else {
        phi_1241_ = 1f;
    }
    let _e830 = phi_1241_;
    if ((bitcast<u32>(_e830) & 2147483647u) > 2139095040u) {
        phi_1252_ = true;
    } else {
        let _e834 = (_e830 < _e441);
        if _e834 {
        }
        phi_1252_ = _e834;
    }
    let _e836 = phi_1252_;
    if _e836 {
        phi_1256_ = _e830;
    } else {
        phi_1256_ = _e441;
    }
    let _e838 = phi_1256_;
    if ((bitcast<u32>(_e838) & 2147483647u) > 2139095040u) {
        phi_1273_ = _e838;
    } else {
        if (_e838 < 0f) {
            phi_1272_ = 0f;
        } else {
            if (_e838 > 1f) {
                phi_1271_ = 1f;
            } else {
                phi_1271_ = _e838;
            }
            let _e845 = phi_1271_;
            phi_1272_ = _e845;
        }
        let _e847 = phi_1272_;
        phi_1273_ = _e847;
    }
    let _e849 = phi_1273_;
    return _e849;
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_7: ptr<function, lt_math_Evsm>, param_8: vec4<f32>, param_9: vec4<f32>, param_10: f32) -> f32 {
    var phi_196_: f32;
    var phi_197_: f32;
    var phi_198_: f32;
    var phi_214_: f32;
    var phi_215_: f32;
    var phi_216_: f32;
    var phi_232_: f32;
    var phi_233_: f32;
    var phi_234_: f32;
    var phi_250_: f32;
    var phi_251_: f32;
    var phi_252_: f32;
    var phi_268_: f32;
    var phi_269_: f32;
    var phi_270_: f32;
    var phi_307_: bool;
    var phi_308_: bool;
    var phi_309_: bool;
    var phi_310_: bool;
    var phi_311_: bool;
    var phi_312_: bool;
    var phi_313_: bool;
    var phi_314_: bool;
    var phi_315_: bool;
    var phi_316_: bool;
    var phi_317_: bool;
    var phi_321_: bool;
    var phi_325_: bool;
    var phi_330_: f32;

    if ((bitcast<u32>(param_10) & 2147483647u) > 2139095040u) {
        phi_198_ = param_10;
    } else {
        if (param_10 < 0f) {
            phi_197_ = 0f;
        } else {
            if (param_10 > 1f) {
                phi_196_ = 1f;
            } else {
                phi_196_ = param_10;
            }
            let _e61 = phi_196_;
            phi_197_ = _e61;
        }
        let _e63 = phi_197_;
        phi_198_ = _e63;
    }
    let _e65 = phi_198_;
    if ((bitcast<u32>(param_8.x) & 2147483647u) > 2139095040u) {
        phi_216_ = param_8.x;
    } else {
        if (param_8.x < 0f) {
            phi_215_ = 0f;
        } else {
            if (param_8.x > 1f) {
                phi_214_ = 1f;
            } else {
                phi_214_ = param_8.x;
            }
            let _e73 = phi_214_;
            phi_215_ = _e73;
        }
        let _e75 = phi_215_;
        phi_216_ = _e75;
    }
    let _e77 = phi_216_;
    if ((bitcast<u32>(param_8.y) & 2147483647u) > 2139095040u) {
        phi_234_ = param_8.y;
    } else {
        if (param_8.y < 0f) {
            phi_233_ = 0f;
        } else {
            if (param_8.y > 1f) {
                phi_232_ = 1f;
            } else {
                phi_232_ = param_8.y;
            }
            let _e85 = phi_232_;
            phi_233_ = _e85;
        }
        let _e87 = phi_233_;
        phi_234_ = _e87;
    }
    let _e89 = phi_234_;
    if ((bitcast<u32>(param_8.z) & 2147483647u) > 2139095040u) {
        phi_252_ = param_8.z;
    } else {
        if (param_8.z < 0f) {
            phi_251_ = 0f;
        } else {
            if (param_8.z > 1f) {
                phi_250_ = 1f;
            } else {
                phi_250_ = param_8.z;
            }
            let _e97 = phi_250_;
            phi_251_ = _e97;
        }
        let _e99 = phi_251_;
        phi_252_ = _e99;
    }
    let _e101 = phi_252_;
    if ((bitcast<u32>(param_8.w) & 2147483647u) > 2139095040u) {
        phi_270_ = param_8.w;
    } else {
        if (param_8.w < 0f) {
            phi_269_ = 0f;
        } else {
            if (param_8.w > 1f) {
                phi_268_ = 1f;
            } else {
                phi_268_ = param_8.w;
            }
            let _e109 = phi_268_;
            phi_269_ = _e109;
        }
        let _e111 = phi_269_;
        phi_270_ = _e111;
    }
    let _e113 = phi_270_;
    let _e114 = (_e77 - _e65);
    let _e115 = (_e89 - _e65);
    let _e116 = (_e101 - _e65);
    let _e117 = (_e113 - _e65);
    if (_e114 >= 0f) {
        if (_e115 >= 0f) {
            if (_e116 >= 0f) {
                if (_e117 >= 0f) {
                    phi_307_ = !(((bitcast<u32>(((((_e114 * param_9.x) + (_e115 * param_9.y)) + (_e116 * param_9.z)) + (_e117 * param_9.w))) & 2147483647u) > 2139095040u));
                    phi_308_ = false;
                } else {
                    phi_307_ = bool();
                    phi_308_ = true;
                }
                let _e139 = phi_307_;
                let _e141 = phi_308_;
                phi_309_ = _e139;
                phi_310_ = false;
                phi_311_ = _e141;
            } else {
                phi_309_ = bool();
                phi_310_ = true;
                phi_311_ = false;
            }
            let _e143 = phi_309_;
            let _e145 = phi_310_;
            let _e147 = phi_311_;
            phi_312_ = _e143;
            phi_313_ = _e145;
            phi_314_ = _e147;
        } else {
            phi_312_ = bool();
            phi_313_ = true;
            phi_314_ = false;
        }
        let _e149 = phi_312_;
        let _e151 = phi_313_;
        let _e153 = phi_314_;
        phi_315_ = _e149;
        phi_316_ = _e151;
        phi_317_ = _e153;
    } else {
        phi_315_ = bool();
        phi_316_ = true;
        phi_317_ = false;
    }
    let _e155 = phi_315_;
    let _e157 = phi_316_;
    let _e159 = phi_317_;
    if _e157 {
        phi_321_ = true;
    } else {
        phi_321_ = _e159;
    }
    let _e161 = phi_321_;
    if _e161 {
        phi_325_ = false;
    } else {
        phi_325_ = _e155;
    }
    let _e163 = phi_325_;
    if _e163 {
        phi_330_ = 1f;
    } else {
        let _e164 = _lt_math_evsm_Evsm_bound_of_offsets(param_7, vec4<f32>(_e114, _e115, _e116, _e117), param_9);
        phi_330_ = _e164;
    }
    let _e166 = phi_330_;
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
    var phi_1459_: bool;
    var phi_1468_: bool;
    var phi_1477_: bool;
    var phi_1478_: bool;
    var phi_1479_: bool;
    var phi_1480_: bool;
    var phi_1481_: bool;
    var phi_1482_: bool;
    var phi_1483_: bool;
    var phi_1487_: bool;
    var phi_1581_: f32;
    var phi_1584_: f32;
    var phi_1613_: f32;
    var phi_1618_: f32;
    var phi_1619_: bool;
    var phi_1620_: f32;
    var phi_1621_: bool;
    var phi_1625_: f32;
    var phi_1645_: f32;
    var phi_1650_: f32;
    var phi_1651_: bool;
    var phi_1652_: f32;
    var phi_1653_: bool;
    var phi_1657_: f32;
    var phi_1707_: i32;
    var phi_1712_: i32;
    var phi_1717_: i32;
    var phi_1722_: i32;
    var phi_1731_: i32;
    var phi_1736_: i32;
    var phi_1741_: i32;
    var phi_1746_: i32;
    var phi_1793_: bool;
    var phi_1801_: bool;
    var phi_1806_: f32;
    var phi_1809_: evaluate_Verdict;
    var phi_1810_: evaluate_Verdict;
    var phi_1814_: bool;
    var phi_1815_: u32;
    var phi_1821_: u32;

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
                phi_1327_ = (_e88 == _e90);
                phi_1328_ = false;
            } else {
                phi_1327_ = bool();
                phi_1328_ = true;
            }
            let _e93 = phi_1327_;
            let _e95 = phi_1328_;
            phi_1329_ = _e93;
            phi_1330_ = _e95;
        } else {
            phi_1329_ = bool();
            phi_1330_ = true;
        }
        let _e97 = phi_1329_;
        let _e99 = phi_1330_;
        if _e99 {
            phi_1334_ = false;
        } else {
            phi_1334_ = _e97;
        }
        let _e101 = phi_1334_;
        if !(_e101) {
            let _e104 = samples.member[_e68.first_primitive].normal;
            let _e106 = samples.member[_e68.first_primitive].position;
            if ((((_e104.x * (_e75.x - (_e106.x * _e75.w))) + (_e104.y * (_e75.y - (_e106.y * _e75.w)))) + (_e104.z * (_e75.z - (_e106.z * _e75.w)))) > 0f) {
                let _e130 = samples.member[_e68.first_primitive].flags;
                let _e138 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e144 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e138.unnamed.visibility, false), _e138.unnamed_1);
                phi_1378_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e144.unnamed, ((_e130 & 1u) == 0u));
            } else {
                let _e153 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e159 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e153.unnamed.visibility, false), _e153.unnamed_1);
                phi_1378_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e159.unnamed, true);
            }
            let _e164 = phi_1378_;
            phi_1382_ = _e164;
        } else {
            let _e170 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e176 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e170.unnamed.visibility, false), _e170.unnamed_1);
            phi_1382_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e176.unnamed, true);
        }
        let _e181 = phi_1382_;
        if _e181.unnamed_1 {
            phi_1810_ = evaluate_Verdict(_e181.unnamed.visibility, _e181.unnamed.is_doubted);
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
                    phi_1459_ = (_e220 <= 1f);
                } else {
                    phi_1459_ = false;
                }
                let _e252 = phi_1459_;
                if _e252 {
                    if (_e234 >= 0f) {
                        phi_1468_ = (_e234 <= 1f);
                    } else {
                        phi_1468_ = false;
                    }
                    let _e256 = phi_1468_;
                    if _e256 {
                        if (_e247 >= 0f) {
                            phi_1477_ = (_e247 <= 1f);
                        } else {
                            phi_1477_ = false;
                        }
                        let _e260 = phi_1477_;
                        phi_1478_ = _e260;
                        phi_1479_ = false;
                    } else {
                        phi_1478_ = bool();
                        phi_1479_ = true;
                    }
                    let _e262 = phi_1478_;
                    let _e264 = phi_1479_;
                    phi_1480_ = _e262;
                    phi_1481_ = _e264;
                } else {
                    phi_1480_ = bool();
                    phi_1481_ = true;
                }
                let _e266 = phi_1480_;
                let _e268 = phi_1481_;
                phi_1482_ = _e266;
                phi_1483_ = _e268;
            } else {
                phi_1482_ = bool();
                phi_1483_ = true;
            }
            let _e270 = phi_1482_;
            let _e272 = phi_1483_;
            if _e272 {
                phi_1487_ = false;
            } else {
                phi_1487_ = _e270;
            }
            let _e274 = phi_1487_;
            if _e274 {
                if (0f > 0f) {
                    let _e277 = samples.member[_e68.first_primitive].normal;
                    let _e279 = p.member.map_size;
                    let _e282 = p.member.projection.row_x;
                    let _e304 = p.member.projection.row_y;
                    let _e326 = p.member.projection.row_z;
                    let _e353 = ((abs(((((_e282.x * _e277.x) + (_e282.y * _e277.y)) + (_e282.z * _e277.z)) / (((_e282.x * _e282.x) + (_e282.y * _e282.y)) + (_e282.z * _e282.z)))) + abs(((((_e304.x * _e277.x) + (_e304.y * _e277.y)) + (_e304.z * _e277.z)) / (((_e304.x * _e304.x) + (_e304.y * _e304.y)) + (_e304.z * _e304.z))))) / (abs(((((_e326.x * _e277.x) + (_e326.y * _e277.y)) + (_e326.z * _e277.z)) / (((_e326.x * _e326.x) + (_e326.y * _e326.y)) + (_e326.z * _e326.z)))) * f32(_e279)));
                    if (_e353 < 0.002f) {
                        phi_1581_ = _e353;
                    } else {
                        phi_1581_ = 0.002f;
                    }
                    let _e356 = phi_1581_;
                    phi_1584_ = (_e247 - (0f * _e356));
                } else {
                    phi_1584_ = _e247;
                }
                let _e360 = phi_1584_;
                let _e362 = p.member.map_size;
                let _e363 = f32(_e362);
                let _e366 = ((_e220 * _e363) - 0.5f);
                let _e367 = ((_e234 * _e363) - 0.5f);
                if (_e366 > -8388608f) {
                    let _e379 = f32(select(0i, select(select(i32(_e366), i32(-2147483648), (_e366 < bitcast<f32>(3472883712u))), 2147483647i, (_e366 > bitcast<f32>(1325400063u))), (_e366 == _e366)));
                    if (_e379 > _e366) {
                        phi_1613_ = 1f;
                    } else {
                        phi_1613_ = 0f;
                    }
                    let _e382 = phi_1613_;
                    if (_e366 < 8388608f) {
                        phi_1618_ = (_e379 - _e382);
                        phi_1619_ = false;
                    } else {
                        phi_1618_ = f32();
                        phi_1619_ = true;
                    }
                    let _e385 = phi_1618_;
                    let _e387 = phi_1619_;
                    phi_1620_ = _e385;
                    phi_1621_ = _e387;
                } else {
                    phi_1620_ = f32();
                    phi_1621_ = true;
                }
                let _e389 = phi_1620_;
                let _e391 = phi_1621_;
                if _e391 {
                    phi_1625_ = _e366;
                } else {
                    phi_1625_ = _e389;
                }
                let _e393 = phi_1625_;
                if (_e367 > -8388608f) {
                    let _e405 = f32(select(0i, select(select(i32(_e367), i32(-2147483648), (_e367 < bitcast<f32>(3472883712u))), 2147483647i, (_e367 > bitcast<f32>(1325400063u))), (_e367 == _e367)));
                    if (_e405 > _e367) {
                        phi_1645_ = 1f;
                    } else {
                        phi_1645_ = 0f;
                    }
                    let _e408 = phi_1645_;
                    if (_e367 < 8388608f) {
                        phi_1650_ = (_e405 - _e408);
                        phi_1651_ = false;
                    } else {
                        phi_1650_ = f32();
                        phi_1651_ = true;
                    }
                    let _e411 = phi_1650_;
                    let _e413 = phi_1651_;
                    phi_1652_ = _e411;
                    phi_1653_ = _e413;
                } else {
                    phi_1652_ = f32();
                    phi_1653_ = true;
                }
                let _e415 = phi_1652_;
                let _e417 = phi_1653_;
                if _e417 {
                    phi_1657_ = _e367;
                } else {
                    phi_1657_ = _e415;
                }
                let _e419 = phi_1657_;
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
                    phi_1707_ = _e430;
                } else {
                    phi_1707_ = 0i;
                }
                let _e462 = phi_1707_;
                if (_e439 > 0i) {
                    phi_1712_ = _e439;
                } else {
                    phi_1712_ = 0i;
                }
                let _e465 = phi_1712_;
                if (_e462 < _e459) {
                    phi_1717_ = _e462;
                } else {
                    phi_1717_ = _e459;
                }
                let _e468 = phi_1717_;
                if (_e465 < _e459) {
                    phi_1722_ = _e465;
                } else {
                    phi_1722_ = _e459;
                }
                let _e471 = phi_1722_;
                let _e472 = bitcast<u32>(_e468);
                let _e474 = (_e430 + 1i);
                let _e475 = (_e439 + 1i);
                if (_e474 > 0i) {
                    phi_1731_ = _e474;
                } else {
                    phi_1731_ = 0i;
                }
                let _e478 = phi_1731_;
                if (_e475 > 0i) {
                    phi_1736_ = _e475;
                } else {
                    phi_1736_ = 0i;
                }
                let _e481 = phi_1736_;
                if (_e478 < _e459) {
                    phi_1741_ = _e478;
                } else {
                    phi_1741_ = _e459;
                }
                let _e484 = phi_1741_;
                if (_e481 < _e459) {
                    phi_1746_ = _e481;
                } else {
                    phi_1746_ = _e459;
                }
                let _e487 = phi_1746_;
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
                    phi_1793_ = true;
                } else {
                    phi_1793_ = (_e513 >= (1f - _e515));
                }
                let _e520 = phi_1793_;
                if ((bitcast<u32>(_e513) & 2147483647u) > 2139095040u) {
                    phi_1801_ = true;
                } else {
                    phi_1801_ = !(_e520);
                }
                let _e526 = phi_1801_;
                if (_e513 > 0.5f) {
                    phi_1806_ = 1f;
                } else {
                    phi_1806_ = 0f;
                }
                let _e529 = phi_1806_;
                phi_1809_ = evaluate_Verdict(_e529, _e526);
            } else {
                phi_1809_ = evaluate_Verdict(1f, true);
            }
            let _e533 = phi_1809_;
            phi_1810_ = _e533;
        }
        let _e535 = phi_1810_;
        visibility.member[_e68.first_primitive] = _e535.visibility;
        phi_1814_ = _e535.is_doubted;
        phi_1815_ = _e68.first_primitive;
    } else {
        phi_1814_ = false;
        phi_1815_ = 0u;
    }
    let _e540 = phi_1814_;
    let _e542 = phi_1815_;
    if _e540 {
        let _e544 = atomicAdd((&shared_[0u]), 1u);
        phi_1821_ = _e544;
    } else {
        phi_1821_ = 0u;
    }
    let _e546 = phi_1821_;
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
