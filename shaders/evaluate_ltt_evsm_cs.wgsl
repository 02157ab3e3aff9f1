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
    pad0_: u32,
    pad1_: u32,
    pad2_: u32,
}

struct type_36 {
    member: abi_ShadowParams,
}

struct lt_math_Evsm {
    positive_exponent: f32,
    negative_exponent: f32,
    min_variance: f32,
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
    var phi_160_: lt_bvh_traverse_Tree;
    var phi_161_: bool;
    var phi_162_: lt_bvh_traverse_Tree;
    var phi_163_: bool;
    var phi_168_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_160_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_161_ = false;
        } else {
            phi_160_ = lt_bvh_traverse_Tree();
            phi_161_ = true;
        }
        let _e64 = phi_160_;
        let _e66 = phi_161_;
        phi_162_ = _e64;
        phi_163_ = _e66;
    } else {
        phi_162_ = lt_bvh_traverse_Tree();
        phi_163_ = true;
    }
    let _e68 = phi_162_;
    let _e70 = phi_163_;
    if _e70 {
        phi_168_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_168_ = _e68;
    }
    let _e75 = phi_168_;
    return lt_bvh_traverse_Tree(_e75.root, _e75.first_primitive);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> lt_math_Evsm {
    return lt_math_Evsm(param_3.x, param_3.y, param_3.z);
}

fn _lt_math_evsm_Evsm_bound_of_offsets(param_4: ptr<function, lt_math_Evsm>, param_5: vec4<f32>, param_6: vec4<f32>) -> f32 {
    var phi_348_: bool;
    var phi_352_: f32;
    var phi_371_: f32;
    var phi_376_: f32;
    var phi_398_: f32;
    var phi_403_: f32;
    var phi_404_: bool;
    var phi_405_: f32;
    var phi_406_: bool;
    var phi_410_: f32;
    var phi_448_: f32;
    var phi_459_: f32;
    var phi_464_: f32;
    var phi_486_: f32;
    var phi_491_: f32;
    var phi_492_: bool;
    var phi_493_: f32;
    var phi_494_: bool;
    var phi_498_: f32;
    var phi_536_: f32;
    var phi_547_: f32;
    var phi_552_: f32;
    var phi_574_: f32;
    var phi_579_: f32;
    var phi_580_: bool;
    var phi_581_: f32;
    var phi_582_: bool;
    var phi_586_: f32;
    var phi_624_: f32;
    var phi_635_: f32;
    var phi_640_: f32;
    var phi_662_: f32;
    var phi_667_: f32;
    var phi_668_: bool;
    var phi_669_: f32;
    var phi_670_: bool;
    var phi_674_: f32;
    var phi_712_: f32;
    var phi_765_: bool;
    var phi_769_: f32;
    var phi_781_: bool;
    var phi_788_: f32;
    var phi_801_: bool;
    var phi_805_: f32;
    var phi_825_: f32;
    var phi_830_: f32;
    var phi_852_: f32;
    var phi_857_: f32;
    var phi_858_: bool;
    var phi_859_: f32;
    var phi_860_: bool;
    var phi_864_: f32;
    var phi_902_: f32;
    var phi_913_: f32;
    var phi_918_: f32;
    var phi_940_: f32;
    var phi_945_: f32;
    var phi_946_: bool;
    var phi_947_: f32;
    var phi_948_: bool;
    var phi_952_: f32;
    var phi_990_: f32;
    var phi_1001_: f32;
    var phi_1006_: f32;
    var phi_1028_: f32;
    var phi_1033_: f32;
    var phi_1034_: bool;
    var phi_1035_: f32;
    var phi_1036_: bool;
    var phi_1040_: f32;
    var phi_1078_: f32;
    var phi_1089_: f32;
    var phi_1094_: f32;
    var phi_1116_: f32;
    var phi_1121_: f32;
    var phi_1122_: bool;
    var phi_1123_: f32;
    var phi_1124_: bool;
    var phi_1128_: f32;
    var phi_1166_: f32;
    var phi_1219_: bool;
    var phi_1223_: f32;
    var phi_1235_: bool;
    var phi_1242_: f32;
    var phi_1253_: bool;
    var phi_1257_: f32;
    var phi_1272_: f32;
    var phi_1273_: f32;
    var phi_1274_: f32;

    let _e55 = (*param_4).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_348_ = true;
    } else {
        let _e59 = (42f < _e55);
        if _e59 {
        }
        phi_348_ = _e59;
    }
    let _e61 = phi_348_;
    if _e61 {
        phi_352_ = 42f;
    } else {
        phi_352_ = _e55;
    }
    let _e63 = phi_352_;
    let _e65 = (_e63 * param_5.x);
    let _e67 = (_e63 * param_5.y);
    let _e69 = (_e63 * param_5.z);
    let _e71 = (_e63 * param_5.w);
    if ((bitcast<u32>(_e65) & 2147483647u) > 2139095040u) {
        phi_448_ = _e65;
    } else {
        if (_e65 < -87f) {
            phi_371_ = -87f;
        } else {
            phi_371_ = _e65;
        }
        let _e77 = phi_371_;
        if (_e77 > 88f) {
            phi_376_ = 88f;
        } else {
            phi_376_ = _e77;
        }
        let _e80 = phi_376_;
        let _e82 = ((_e80 * 1.442695f) + 0.5f);
        if (_e82 > -8388608f) {
            let _e94 = f32(select(0i, select(select(i32(_e82), i32(-2147483648), (_e82 < bitcast<f32>(3472883712u))), 2147483647i, (_e82 > bitcast<f32>(1325400063u))), (_e82 == _e82)));
            if (_e94 > _e82) {
                phi_398_ = 1f;
            } else {
                phi_398_ = 0f;
            }
            let _e97 = phi_398_;
            if (_e82 < 8388608f) {
                phi_403_ = (_e94 - _e97);
                phi_404_ = false;
            } else {
                phi_403_ = f32();
                phi_404_ = true;
            }
            let _e100 = phi_403_;
            let _e102 = phi_404_;
            phi_405_ = _e100;
            phi_406_ = _e102;
        } else {
            phi_405_ = f32();
            phi_406_ = true;
        }
        let _e104 = phi_405_;
        let _e106 = phi_406_;
        if _e106 {
            phi_410_ = _e82;
        } else {
            phi_410_ = _e104;
        }
        let _e108 = phi_410_;
        let _e112 = ((_e80 - (_e108 * 0.69314575f)) - (_e108 * 0.0000014286068f));
        phi_448_ = ((((((((((((((((1f / 5040f) * _e112) + (1f / 720f)) * _e112) + (1f / 120f)) * _e112) + (1f / 24f)) * _e112) + (1f / 6f)) * _e112) + 0.5f) * _e112) + 1f) * _e112) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e108), i32(-2147483648), (_e108 < bitcast<f32>(3472883712u))), 2147483647i, (_e108 > bitcast<f32>(1325400063u))), (_e108 == _e108)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e148 = phi_448_;
    if ((bitcast<u32>(_e67) & 2147483647u) > 2139095040u) {
        phi_536_ = _e67;
    } else {
        if (_e67 < -87f) {
            phi_459_ = -87f;
        } else {
            phi_459_ = _e67;
        }
        let _e154 = phi_459_;
        if (_e154 > 88f) {
            phi_464_ = 88f;
        } else {
            phi_464_ = _e154;
        }
        let _e157 = phi_464_;
        let _e159 = ((_e157 * 1.442695f) + 0.5f);
        if (_e159 > -8388608f) {
            let _e171 = f32(select(0i, select(select(i32(_e159), i32(-2147483648), (_e159 < bitcast<f32>(3472883712u))), 2147483647i, (_e159 > bitcast<f32>(1325400063u))), (_e159 == _e159)));
            if (_e171 > _e159) {
                phi_486_ = 1f;
            } else {
                phi_486_ = 0f;
            }
            let _e174 = phi_486_;
            if (_e159 < 8388608f) {
                phi_491_ = (_e171 - _e174);
                phi_492_ = false;
            } else {
                phi_491_ = f32();
                phi_492_ = true;
            }
            let _e177 = phi_491_;
            let _e179 = phi_492_;
            phi_493_ = _e177;
            phi_494_ = _e179;
        } else {
            phi_493_ = f32();
            phi_494_ = true;
        }
        let _e181 = phi_493_;
        let _e183 = phi_494_;
        if _e183 {
            phi_498_ = _e159;
        } else {
            phi_498_ = _e181;
        }
        let _e185 = phi_498_;
        let _e189 = ((_e157 - (_e185 * 0.69314575f)) - (_e185 * 0.0000014286068f));
        phi_536_ = ((((((((((((((((1f / 5040f) * _e189) + (1f / 720f)) * _e189) + (1f / 120f)) * _e189) + (1f / 24f)) * _e189) + (1f / 6f)) * _e189) + 0.5f) * _e189) + 1f) * _e189) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e185), i32(-2147483648), (_e185 < bitcast<f32>(3472883712u))), 2147483647i, (_e185 > bitcast<f32>(1325400063u))), (_e185 == _e185)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e225 = phi_536_;
    if ((bitcast<u32>(_e69) & 2147483647u) > 2139095040u) {
        phi_624_ = _e69;
    } else {
        if (_e69 < -87f) {
            phi_547_ = -87f;
        } else {
            phi_547_ = _e69;
        }
        let _e231 = phi_547_;
        if (_e231 > 88f) {
            phi_552_ = 88f;
        } else {
            phi_552_ = _e231;
        }
        let _e234 = phi_552_;
        let _e236 = ((_e234 * 1.442695f) + 0.5f);
        if (_e236 > -8388608f) {
            let _e248 = f32(select(0i, select(select(i32(_e236), i32(-2147483648), (_e236 < bitcast<f32>(3472883712u))), 2147483647i, (_e236 > bitcast<f32>(1325400063u))), (_e236 == _e236)));
            if (_e248 > _e236) {
                phi_574_ = 1f;
            } else {
                phi_574_ = 0f;
            }
            let _e251 = phi_574_;
            if (_e236 < 8388608f) {
                phi_579_ = (_e248 - _e251);
                phi_580_ = false;
            } else {
                phi_579_ = f32();
                phi_580_ = true;
            }
            let _e254 = phi_579_;
            let _e256 = phi_580_;
            phi_581_ = _e254;
            phi_582_ = _e256;
        } else {
            phi_581_ = f32();
            phi_582_ = true;
        }
        let _e258 = phi_581_;
        let _e260 = phi_582_;
        if _e260 {
            phi_586_ = _e236;
        } else {
            phi_586_ = _e258;
        }
        let _e262 = phi_586_;
        let _e266 = ((_e234 - (_e262 * 0.69314575f)) - (_e262 * 0.0000014286068f));
        phi_624_ = ((((((((((((((((1f / 5040f) * _e266) + (1f / 720f)) * _e266) + (1f / 120f)) * _e266) + (1f / 24f)) * _e266) + (1f / 6f)) * _e266) + 0.5f) * _e266) + 1f) * _e266) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e262), i32(-2147483648), (_e262 < bitcast<f32>(3472883712u))), 2147483647i, (_e262 > bitcast<f32>(1325400063u))), (_e262 == _e262)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e302 = phi_624_;
    if ((bitcast<u32>(_e71) & 2147483647u) > 2139095040u) {
        phi_712_ = _e71;
    } else {
        if (_e71 < -87f) {
            phi_635_ = -87f;
        } else {
            phi_635_ = _e71;
        }
        let _e308 = phi_635_;
        if (_e308 > 88f) {
            phi_640_ = 88f;
        } else {
            phi_640_ = _e308;
        }
        let _e311 = phi_640_;
        let _e313 = ((_e311 * 1.442695f) + 0.5f);
        if (_e313 > -8388608f) {
            let _e325 = f32(select(0i, select(select(i32(_e313), i32(-2147483648), (_e313 < bitcast<f32>(3472883712u))), 2147483647i, (_e313 > bitcast<f32>(1325400063u))), (_e313 == _e313)));
            if (_e325 > _e313) {
                phi_662_ = 1f;
            } else {
                phi_662_ = 0f;
            }
            let _e328 = phi_662_;
            if (_e313 < 8388608f) {
                phi_667_ = (_e325 - _e328);
                phi_668_ = false;
            } else {
                phi_667_ = f32();
                phi_668_ = true;
            }
            let _e331 = phi_667_;
            let _e333 = phi_668_;
            phi_669_ = _e331;
            phi_670_ = _e333;
        } else {
            phi_669_ = f32();
            phi_670_ = true;
        }
        let _e335 = phi_669_;
        let _e337 = phi_670_;
        if _e337 {
            phi_674_ = _e313;
        } else {
            phi_674_ = _e335;
        }
        let _e339 = phi_674_;
        let _e343 = ((_e311 - (_e339 * 0.69314575f)) - (_e339 * 0.0000014286068f));
        phi_712_ = ((((((((((((((((1f / 5040f) * _e343) + (1f / 720f)) * _e343) + (1f / 120f)) * _e343) + (1f / 24f)) * _e343) + (1f / 6f)) * _e343) + 0.5f) * _e343) + 1f) * _e343) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e339), i32(-2147483648), (_e339 < bitcast<f32>(3472883712u))), 2147483647i, (_e339 > bitcast<f32>(1325400063u))), (_e339 == _e339)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e379 = phi_712_;
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
        phi_765_ = true;
    } else {
        let _e425 = (_e391 > _e421);
        if _e425 {
        }
        phi_765_ = _e425;
    }
    let _e427 = phi_765_;
    if _e427 {
        phi_769_ = _e391;
    } else {
        phi_769_ = _e421;
    }
    let _e429 = phi_769_;
    let _e430 = -(_e402);
    if (_e430 <= 0f) {
        let _e434 = ((bitcast<u32>(_e429) & 2147483647u) > 2139095040u);
        if _e434 {
        }
        phi_781_ = _e434;
    } else {
        phi_781_ = true;
    }
    let _e436 = phi_781_;
    if _e436 {
        phi_788_ = (_e429 / (_e429 + (_e430 * _e430)));
    } else {
        phi_788_ = 1f;
    }
    let _e441 = phi_788_;
    let _e443 = (*param_4).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_801_ = true;
    } else {
        let _e447 = (42f < _e443);
        if _e447 {
        }
        phi_801_ = _e447;
    }
    let _e449 = phi_801_;
    if _e449 {
        phi_805_ = 42f;
    } else {
        phi_805_ = _e443;
    }
    let _e451 = phi_805_;
    let _e452 = -(_e451);
    let _e454 = (_e452 * param_5.x);
    let _e456 = (_e452 * param_5.y);
    let _e458 = (_e452 * param_5.z);
    let _e460 = (_e452 * param_5.w);
    if ((bitcast<u32>(_e454) & 2147483647u) > 2139095040u) {
        phi_902_ = _e454;
    } else {
        if (_e454 < -87f) {
            phi_825_ = -87f;
        } else {
            phi_825_ = _e454;
        }
        let _e466 = phi_825_;
        if (_e466 > 88f) {
            phi_830_ = 88f;
        } else {
            phi_830_ = _e466;
        }
        let _e469 = phi_830_;
        let _e471 = ((_e469 * 1.442695f) + 0.5f);
        if (_e471 > -8388608f) {
            let _e483 = f32(select(0i, select(select(i32(_e471), i32(-2147483648), (_e471 < bitcast<f32>(3472883712u))), 2147483647i, (_e471 > bitcast<f32>(1325400063u))), (_e471 == _e471)));
            if (_e483 > _e471) {
                phi_852_ = 1f;
            } else {
                phi_852_ = 0f;
            }
            let _e486 = phi_852_;
            if (_e471 < 8388608f) {
                phi_857_ = (_e483 - _e486);
                phi_858_ = false;
            } else {
                phi_857_ = f32();
                phi_858_ = true;
            }
            let _e489 = phi_857_;
            let _e491 = phi_858_;
            phi_859_ = _e489;
            phi_860_ = _e491;
        } else {
            phi_859_ = f32();
            phi_860_ = true;
        }
        let _e493 = phi_859_;
        let _e495 = phi_860_;
        if _e495 {
            phi_864_ = _e471;
        } else {
            phi_864_ = _e493;
        }
        let _e497 = phi_864_;
        let _e501 = ((_e469 - (_e497 * 0.69314575f)) - (_e497 * 0.0000014286068f));
        phi_902_ = ((((((((((((((((1f / 5040f) * _e501) + (1f / 720f)) * _e501) + (1f / 120f)) * _e501) + (1f / 24f)) * _e501) + (1f / 6f)) * _e501) + 0.5f) * _e501) + 1f) * _e501) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e497), i32(-2147483648), (_e497 < bitcast<f32>(3472883712u))), 2147483647i, (_e497 > bitcast<f32>(1325400063u))), (_e497 == _e497)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e537 = phi_902_;
    if ((bitcast<u32>(_e456) & 2147483647u) > 2139095040u) {
        phi_990_ = _e456;
    } else {
        if (_e456 < -87f) {
            phi_913_ = -87f;
        } else {
            phi_913_ = _e456;
        }
        let _e543 = phi_913_;
        if (_e543 > 88f) {
            phi_918_ = 88f;
        } else {
            phi_918_ = _e543;
        }
        let _e546 = phi_918_;
        let _e548 = ((_e546 * 1.442695f) + 0.5f);
        if (_e548 > -8388608f) {
            let _e560 = f32(select(0i, select(select(i32(_e548), i32(-2147483648), (_e548 < bitcast<f32>(3472883712u))), 2147483647i, (_e548 > bitcast<f32>(1325400063u))), (_e548 == _e548)));
            if (_e560 > _e548) {
                phi_940_ = 1f;
            } else {
                phi_940_ = 0f;
            }
            let _e563 = phi_940_;
            if (_e548 < 8388608f) {
                phi_945_ = (_e560 - _e563);
                phi_946_ = false;
            } else {
                phi_945_ = f32();
                phi_946_ = true;
            }
            let _e566 = phi_945_;
            let _e568 = phi_946_;
            phi_947_ = _e566;
            phi_948_ = _e568;
        } else {
            phi_947_ = f32();
            phi_948_ = true;
        }
        let _e570 = phi_947_;
        let _e572 = phi_948_;
        if _e572 {
            phi_952_ = _e548;
        } else {
            phi_952_ = _e570;
        }
        let _e574 = phi_952_;
        let _e578 = ((_e546 - (_e574 * 0.69314575f)) - (_e574 * 0.0000014286068f));
        phi_990_ = ((((((((((((((((1f / 5040f) * _e578) + (1f / 720f)) * _e578) + (1f / 120f)) * _e578) + (1f / 24f)) * _e578) + (1f / 6f)) * _e578) + 0.5f) * _e578) + 1f) * _e578) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e574), i32(-2147483648), (_e574 < bitcast<f32>(3472883712u))), 2147483647i, (_e574 > bitcast<f32>(1325400063u))), (_e574 == _e574)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e614 = phi_990_;
    if ((bitcast<u32>(_e458) & 2147483647u) > 2139095040u) {
        phi_1078_ = _e458;
    } else {
        if (_e458 < -87f) {
            phi_1001_ = -87f;
        } else {
            phi_1001_ = _e458;
        }
        let _e620 = phi_1001_;
        if (_e620 > 88f) {
            phi_1006_ = 88f;
        } else {
            phi_1006_ = _e620;
        }
        let _e623 = phi_1006_;
        let _e625 = ((_e623 * 1.442695f) + 0.5f);
        if (_e625 > -8388608f) {
            let _e637 = f32(select(0i, select(select(i32(_e625), i32(-2147483648), (_e625 < bitcast<f32>(3472883712u))), 2147483647i, (_e625 > bitcast<f32>(1325400063u))), (_e625 == _e625)));
            if (_e637 > _e625) {
                phi_1028_ = 1f;
            } else {
                phi_1028_ = 0f;
            }
            let _e640 = phi_1028_;
            if (_e625 < 8388608f) {
                phi_1033_ = (_e637 - _e640);
                phi_1034_ = false;
            } else {
                phi_1033_ = f32();
                phi_1034_ = true;
            }
            let _e643 = phi_1033_;
            let _e645 = phi_1034_;
            phi_1035_ = _e643;
            phi_1036_ = _e645;
        } else {
            phi_1035_ = f32();
            phi_1036_ = true;
        }
        let _e647 = phi_1035_;
        let _e649 = phi_1036_;
        if _e649 {
            phi_1040_ = _e625;
        } else {
            phi_1040_ = _e647;
        }
        let _e651 = phi_1040_;
        let _e655 = ((_e623 - (_e651 * 0.69314575f)) - (_e651 * 0.0000014286068f));
        phi_1078_ = ((((((((((((((((1f / 5040f) * _e655) + (1f / 720f)) * _e655) + (1f / 120f)) * _e655) + (1f / 24f)) * _e655) + (1f / 6f)) * _e655) + 0.5f) * _e655) + 1f) * _e655) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e651), i32(-2147483648), (_e651 < bitcast<f32>(3472883712u))), 2147483647i, (_e651 > bitcast<f32>(1325400063u))), (_e651 == _e651)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e691 = phi_1078_;
    if ((bitcast<u32>(_e460) & 2147483647u) > 2139095040u) {
        phi_1166_ = _e460;
    } else {
        if (_e460 < -87f) {
            phi_1089_ = -87f;
        } else {
            phi_1089_ = _e460;
        }
        let _e697 = phi_1089_;
        if (_e697 > 88f) {
            phi_1094_ = 88f;
        } else {
            phi_1094_ = _e697;
        }
        let _e700 = phi_1094_;
        let _e702 = ((_e700 * 1.442695f) + 0.5f);
        if (_e702 > -8388608f) {
            let _e714 = f32(select(0i, select(select(i32(_e702), i32(-2147483648), (_e702 < bitcast<f32>(3472883712u))), 2147483647i, (_e702 > bitcast<f32>(1325400063u))), (_e702 == _e702)));
            if (_e714 > _e702) {
                phi_1116_ = 1f;
            } else {
                phi_1116_ = 0f;
            }
            let _e717 = phi_1116_;
            if (_e702 < 8388608f) {
                phi_1121_ = (_e714 - _e717);
                phi_1122_ = false;
            } else {
                phi_1121_ = f32();
                phi_1122_ = true;
            }
            let _e720 = phi_1121_;
            let _e722 = phi_1122_;
            phi_1123_ = _e720;
            phi_1124_ = _e722;
        } else {
            phi_1123_ = f32();
            phi_1124_ = true;
        }
        let _e724 = phi_1123_;
        let _e726 = phi_1124_;
        if _e726 {
            phi_1128_ = _e702;
        } else {
            phi_1128_ = _e724;
        }
        let _e728 = phi_1128_;
        let _e732 = ((_e700 - (_e728 * 0.69314575f)) - (_e728 * 0.0000014286068f));
        phi_1166_ = ((((((((((((((((1f / 5040f) * _e732) + (1f / 720f)) * _e732) + (1f / 120f)) * _e732) + (1f / 24f)) * _e732) + (1f / 6f)) * _e732) + 0.5f) * _e732) + 1f) * _e732) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e728), i32(-2147483648), (_e728 < bitcast<f32>(3472883712u))), 2147483647i, (_e728 > bitcast<f32>(1325400063u))), (_e728 == _e728)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e768 = phi_1166_;
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
        phi_1219_ = true;
    } else {
        let _e814 = (_e780 > _e810);
        if _e814 {
        }
        phi_1219_ = _e814;
    }
    let _e816 = phi_1219_;
    if _e816 {
        phi_1223_ = _e780;
    } else {
        phi_1223_ = _e810;
    }
    let _e818 = phi_1223_;
    let _e819 = -(_e791);
    if (_e819 <= 0f) {
        let _e823 = ((bitcast<u32>(_e818) & 2147483647u) > 2139095040u);
        if _e823 {
        }
        phi_1235_ = _e823;
    } else {
        phi_1235_ = true;
    }
    let _e825 = phi_1235_;
    if _e825 {
        phi_1242_ = (_e818 / (_e818 + (_e819 * _e819)));
    } else {
        phi_1242_ = 1f;
    }
    let _e830 = phi_1242_;
    if ((bitcast<u32>(_e830) & 2147483647u) > 2139095040u) {
        phi_1253_ = true;
    } else {
        let _e834 = (_e830 < _e441);
        if _e834 {
        }
        phi_1253_ = _e834;
    }
    let _e836 = phi_1253_;
    if _e836 {
        phi_1257_ = _e830;
    } else {
        phi_1257_ = _e441;
    }
    let _e838 = phi_1257_;
    if ((bitcast<u32>(_e838) & 2147483647u) > 2139095040u) {
        phi_1274_ = _e838;
    } else {
        if (_e838 < 0f) {
            phi_1273_ = 0f;
        } else {
            if (_e838 > 1f) {
                phi_1272_ = 1f;
            } else {
                phi_1272_ = _e838;
            }
            let _e845 = phi_1272_;
            phi_1273_ = _e845;
        }
        let _e847 = phi_1273_;
        phi_1274_ = _e847;
    }
    let _e849 = phi_1274_;
    return _e849;
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_7: ptr<function, lt_math_Evsm>, param_8: vec4<f32>, param_9: vec4<f32>, param_10: f32) -> f32 {
    var phi_197_: f32;
    var phi_198_: f32;
    var phi_199_: f32;
    var phi_215_: f32;
    var phi_216_: f32;
    var phi_217_: f32;
    var phi_233_: f32;
    var phi_234_: f32;
    var phi_235_: f32;
    var phi_251_: f32;
    var phi_252_: f32;
    var phi_253_: f32;
    var phi_269_: f32;
    var phi_270_: f32;
    var phi_271_: f32;
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
    var phi_318_: bool;
    var phi_322_: bool;
    var phi_326_: bool;
    var phi_331_: f32;

    if ((bitcast<u32>(param_10) & 2147483647u) > 2139095040u) {
        phi_199_ = param_10;
    } else {
        if (param_10 < 0f) {
            phi_198_ = 0f;
        } else {
            if (param_10 > 1f) {
                phi_197_ = 1f;
            } else {
                phi_197_ = param_10;
            }
            let _e61 = phi_197_;
            phi_198_ = _e61;
        }
        let _e63 = phi_198_;
        phi_199_ = _e63;
    }
    let _e65 = phi_199_;
    if ((bitcast<u32>(param_8.x) & 2147483647u) > 2139095040u) {
        phi_217_ = param_8.x;
    } else {
        if (param_8.x < 0f) {
            phi_216_ = 0f;
        } else {
            if (param_8.x > 1f) {
                phi_215_ = 1f;
            } else {
                phi_215_ = param_8.x;
            }
            let _e73 = phi_215_;
            phi_216_ = _e73;
        }
        let _e75 = phi_216_;
        phi_217_ = _e75;
    }
    let _e77 = phi_217_;
    if ((bitcast<u32>(param_8.y) & 2147483647u) > 2139095040u) {
        phi_235_ = param_8.y;
    } else {
        if (param_8.y < 0f) {
            phi_234_ = 0f;
        } else {
            if (param_8.y > 1f) {
                phi_233_ = 1f;
            } else {
                phi_233_ = param_8.y;
            }
            let _e85 = phi_233_;
            phi_234_ = _e85;
        }
        let _e87 = phi_234_;
        phi_235_ = _e87;
    }
    let _e89 = phi_235_;
    if ((bitcast<u32>(param_8.z) & 2147483647u) > 2139095040u) {
        phi_253_ = param_8.z;
    } else {
        if (param_8.z < 0f) {
            phi_252_ = 0f;
        } else {
            if (param_8.z > 1f) {
                phi_251_ = 1f;
            } else {
                phi_251_ = param_8.z;
            }
            let _e97 = phi_251_;
            phi_252_ = _e97;
        }
        let _e99 = phi_252_;
        phi_253_ = _e99;
    }
    let _e101 = phi_253_;
    if ((bitcast<u32>(param_8.w) & 2147483647u) > 2139095040u) {
        phi_271_ = param_8.w;
    } else {
        if (param_8.w < 0f) {
            phi_270_ = 0f;
        } else {
            if (param_8.w > 1f) {
                phi_269_ = 1f;
            } else {
                phi_269_ = param_8.w;
            }
            let _e109 = phi_269_;
            phi_270_ = _e109;
        }
        let _e111 = phi_270_;
        phi_271_ = _e111;
    }
    let _e113 = phi_271_;
    let _e114 = (_e77 - _e65);
    let _e115 = (_e89 - _e65);
    let _e116 = (_e101 - _e65);
    let _e117 = (_e113 - _e65);
    if (_e114 >= 0f) {
        if (_e115 >= 0f) {
            if (_e116 >= 0f) {
                if (_e117 >= 0f) {
                    phi_308_ = !(((bitcast<u32>(((((_e114 * param_9.x) + (_e115 * param_9.y)) + (_e116 * param_9.z)) + (_e117 * param_9.w))) & 2147483647u) > 2139095040u));
                    phi_309_ = false;
                } else {
                    phi_308_ = bool();
                    phi_309_ = true;
                }
                let _e139 = phi_308_;
                let _e141 = phi_309_;
                phi_310_ = _e139;
                phi_311_ = false;
                phi_312_ = _e141;
            } else {
                phi_310_ = bool();
                phi_311_ = true;
                phi_312_ = false;
            }
            let _e143 = phi_310_;
            let _e145 = phi_311_;
            let _e147 = phi_312_;
            phi_313_ = _e143;
            phi_314_ = _e145;
            phi_315_ = _e147;
        } else {
            phi_313_ = bool();
            phi_314_ = true;
            phi_315_ = false;
        }
        let _e149 = phi_313_;
        let _e151 = phi_314_;
        let _e153 = phi_315_;
        phi_316_ = _e149;
        phi_317_ = _e151;
        phi_318_ = _e153;
    } else {
        phi_316_ = bool();
        phi_317_ = true;
        phi_318_ = false;
    }
    let _e155 = phi_316_;
    let _e157 = phi_317_;
    let _e159 = phi_318_;
    if _e157 {
        phi_322_ = true;
    } else {
        phi_322_ = _e159;
    }
    let _e161 = phi_322_;
    if _e161 {
        phi_326_ = false;
    } else {
        phi_326_ = _e155;
    }
    let _e163 = phi_326_;
    if _e163 {
        phi_331_ = 1f;
    } else {
        let _e164 = _lt_math_evsm_Evsm_bound_of_offsets(param_7, vec4<f32>(_e114, _e115, _e116, _e117), param_9);
        phi_331_ = _e164;
    }
    let _e166 = phi_331_;
    return _e166;
}

fn function_() {
    var local_1: lt_math_Evsm;
    var phi_1323_: bool;
    var phi_1324_: bool;
    var phi_1325_: bool;
    var phi_1326_: bool;
    var phi_1330_: bool;
    var phi_1374_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1378_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1455_: bool;
    var phi_1464_: bool;
    var phi_1473_: bool;
    var phi_1474_: bool;
    var phi_1475_: bool;
    var phi_1476_: bool;
    var phi_1477_: bool;
    var phi_1478_: bool;
    var phi_1479_: bool;
    var phi_1483_: bool;
    var phi_1577_: f32;
    var phi_1580_: f32;
    var phi_1609_: f32;
    var phi_1614_: f32;
    var phi_1615_: bool;
    var phi_1616_: f32;
    var phi_1617_: bool;
    var phi_1621_: f32;
    var phi_1641_: f32;
    var phi_1646_: f32;
    var phi_1647_: bool;
    var phi_1648_: f32;
    var phi_1649_: bool;
    var phi_1653_: f32;
    var phi_1703_: i32;
    var phi_1708_: i32;
    var phi_1713_: i32;
    var phi_1718_: i32;
    var phi_1727_: i32;
    var phi_1732_: i32;
    var phi_1737_: i32;
    var phi_1742_: i32;
    var phi_1789_: bool;
    var phi_1797_: bool;
    var phi_1809_: bool;
    var phi_1810_: bool;
    var phi_1814_: f32;
    var phi_1820_: f32;
    var phi_1822_: evaluate_Verdict;
    var phi_1827_: evaluate_Verdict;
    var phi_1828_: evaluate_Verdict;
    var phi_1832_: bool;
    var phi_1833_: u32;
    var phi_1844_: u32;

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
                phi_1323_ = (_e86 == _e88);
                phi_1324_ = false;
            } else {
                phi_1323_ = bool();
                phi_1324_ = true;
            }
            let _e91 = phi_1323_;
            let _e93 = phi_1324_;
            phi_1325_ = _e91;
            phi_1326_ = _e93;
        } else {
            phi_1325_ = bool();
            phi_1326_ = true;
        }
        let _e95 = phi_1325_;
        let _e97 = phi_1326_;
        if _e97 {
            phi_1330_ = false;
        } else {
            phi_1330_ = _e95;
        }
        let _e99 = phi_1330_;
        if !(_e99) {
            let _e102 = samples.member[_e66.first_primitive].normal;
            let _e104 = samples.member[_e66.first_primitive].position;
            if ((((_e102.x * (_e73.x - (_e104.x * _e73.w))) + (_e102.y * (_e73.y - (_e104.y * _e73.w)))) + (_e102.z * (_e73.z - (_e104.z * _e73.w)))) > 0f) {
                let _e128 = samples.member[_e66.first_primitive].flags;
                let _e136 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e142 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e136.unnamed.visibility, false), _e136.unnamed_1);
                phi_1374_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e142.unnamed, ((_e128 & 1u) == 0u));
            } else {
                let _e151 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e157 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e151.unnamed.visibility, false), _e151.unnamed_1);
                phi_1374_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e157.unnamed, true);
            }
            let _e162 = phi_1374_;
            phi_1378_ = _e162;
        } else {
            let _e168 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e174 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e168.unnamed.visibility, false), _e168.unnamed_1);
            phi_1378_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e174.unnamed, true);
        }
        let _e179 = phi_1378_;
        if _e179.unnamed_1 {
            phi_1828_ = evaluate_Verdict(_e179.unnamed.visibility, _e179.unnamed.is_doubted);
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
                    phi_1455_ = (_e218 <= 1f);
                } else {
                    phi_1455_ = false;
                }
                let _e250 = phi_1455_;
                if _e250 {
                    if (_e232 >= 0f) {
                        phi_1464_ = (_e232 <= 1f);
                    } else {
                        phi_1464_ = false;
                    }
                    let _e254 = phi_1464_;
                    if _e254 {
                        if (_e245 >= 0f) {
                            phi_1473_ = (_e245 <= 1f);
                        } else {
                            phi_1473_ = false;
                        }
                        let _e258 = phi_1473_;
                        phi_1474_ = _e258;
                        phi_1475_ = false;
                    } else {
                        phi_1474_ = bool();
                        phi_1475_ = true;
                    }
                    let _e260 = phi_1474_;
                    let _e262 = phi_1475_;
                    phi_1476_ = _e260;
                    phi_1477_ = _e262;
                } else {
                    phi_1476_ = bool();
                    phi_1477_ = true;
                }
                let _e264 = phi_1476_;
                let _e266 = phi_1477_;
                phi_1478_ = _e264;
                phi_1479_ = _e266;
            } else {
                phi_1478_ = bool();
                phi_1479_ = true;
            }
            let _e268 = phi_1478_;
            let _e270 = phi_1479_;
            if _e270 {
                phi_1483_ = false;
            } else {
                phi_1483_ = _e268;
            }
            let _e272 = phi_1483_;
            if _e272 {
                if (0f > 0f) {
                    let _e275 = samples.member[_e66.first_primitive].normal;
                    let _e277 = p.member.map_size;
                    let _e280 = p.member.projection.row_x;
                    let _e302 = p.member.projection.row_y;
                    let _e324 = p.member.projection.row_z;
                    let _e351 = ((abs(((((_e280.x * _e275.x) + (_e280.y * _e275.y)) + (_e280.z * _e275.z)) / (((_e280.x * _e280.x) + (_e280.y * _e280.y)) + (_e280.z * _e280.z)))) + abs(((((_e302.x * _e275.x) + (_e302.y * _e275.y)) + (_e302.z * _e275.z)) / (((_e302.x * _e302.x) + (_e302.y * _e302.y)) + (_e302.z * _e302.z))))) / (abs(((((_e324.x * _e275.x) + (_e324.y * _e275.y)) + (_e324.z * _e275.z)) / (((_e324.x * _e324.x) + (_e324.y * _e324.y)) + (_e324.z * _e324.z)))) * f32(_e277)));
                    if (_e351 < 0.002f) {
                        phi_1577_ = _e351;
                    } else {
                        phi_1577_ = 0.002f;
                    }
                    let _e354 = phi_1577_;
                    phi_1580_ = (_e245 - (0f * _e354));
                } else {
                    phi_1580_ = _e245;
                }
                let _e358 = phi_1580_;
                let _e360 = p.member.map_size;
                let _e361 = f32(_e360);
                let _e364 = ((_e218 * _e361) - 0.5f);
                let _e365 = ((_e232 * _e361) - 0.5f);
                if (_e364 > -8388608f) {
                    let _e377 = f32(select(0i, select(select(i32(_e364), i32(-2147483648), (_e364 < bitcast<f32>(3472883712u))), 2147483647i, (_e364 > bitcast<f32>(1325400063u))), (_e364 == _e364)));
                    if (_e377 > _e364) {
                        phi_1609_ = 1f;
                    } else {
                        phi_1609_ = 0f;
                    }
                    let _e380 = phi_1609_;
                    if (_e364 < 8388608f) {
                        phi_1614_ = (_e377 - _e380);
                        phi_1615_ = false;
                    } else {
                        phi_1614_ = f32();
                        phi_1615_ = true;
                    }
                    let _e383 = phi_1614_;
                    let _e385 = phi_1615_;
                    phi_1616_ = _e383;
                    phi_1617_ = _e385;
                } else {
                    phi_1616_ = f32();
                    phi_1617_ = true;
                }
                let _e387 = phi_1616_;
                let _e389 = phi_1617_;
                if _e389 {
                    phi_1621_ = _e364;
                } else {
                    phi_1621_ = _e387;
                }
                let _e391 = phi_1621_;
                if (_e365 > -8388608f) {
                    let _e403 = f32(select(0i, select(select(i32(_e365), i32(-2147483648), (_e365 < bitcast<f32>(3472883712u))), 2147483647i, (_e365 > bitcast<f32>(1325400063u))), (_e365 == _e365)));
                    if (_e403 > _e365) {
                        phi_1641_ = 1f;
                    } else {
                        phi_1641_ = 0f;
                    }
                    let _e406 = phi_1641_;
                    if (_e365 < 8388608f) {
                        phi_1646_ = (_e403 - _e406);
                        phi_1647_ = false;
                    } else {
                        phi_1646_ = f32();
                        phi_1647_ = true;
                    }
                    let _e409 = phi_1646_;
                    let _e411 = phi_1647_;
                    phi_1648_ = _e409;
                    phi_1649_ = _e411;
                } else {
                    phi_1648_ = f32();
                    phi_1649_ = true;
                }
                let _e413 = phi_1648_;
                let _e415 = phi_1649_;
                if _e415 {
                    phi_1653_ = _e365;
                } else {
                    phi_1653_ = _e413;
                }
                let _e417 = phi_1653_;
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
                    phi_1703_ = _e428;
                } else {
                    phi_1703_ = 0i;
                }
                let _e460 = phi_1703_;
                if (_e437 > 0i) {
                    phi_1708_ = _e437;
                } else {
                    phi_1708_ = 0i;
                }
                let _e463 = phi_1708_;
                if (_e460 < _e457) {
                    phi_1713_ = _e460;
                } else {
                    phi_1713_ = _e457;
                }
                let _e466 = phi_1713_;
                if (_e463 < _e457) {
                    phi_1718_ = _e463;
                } else {
                    phi_1718_ = _e457;
                }
                let _e469 = phi_1718_;
                let _e470 = bitcast<u32>(_e466);
                let _e472 = (_e428 + 1i);
                let _e473 = (_e437 + 1i);
                if (_e472 > 0i) {
                    phi_1727_ = _e472;
                } else {
                    phi_1727_ = 0i;
                }
                let _e476 = phi_1727_;
                if (_e473 > 0i) {
                    phi_1732_ = _e473;
                } else {
                    phi_1732_ = 0i;
                }
                let _e479 = phi_1732_;
                if (_e476 < _e457) {
                    phi_1737_ = _e476;
                } else {
                    phi_1737_ = _e457;
                }
                let _e482 = phi_1737_;
                if (_e479 < _e457) {
                    phi_1742_ = _e479;
                } else {
                    phi_1742_ = _e457;
                }
                let _e485 = phi_1742_;
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
                    phi_1789_ = true;
                } else {
                    phi_1789_ = (_e511 >= (1f - _e513));
                }
                let _e518 = phi_1789_;
                if ((bitcast<u32>(_e511) & 2147483647u) > 2139095040u) {
                    phi_1797_ = true;
                } else {
                    phi_1797_ = !(_e518);
                }
                let _e524 = phi_1797_;
                if _e524 {
                    if (_e511 > 0f) {
                        if (_e511 < 1f) {
                            phi_1809_ = false;
                        } else {
                            phi_1809_ = true;
                        }
                        let _e528 = phi_1809_;
                        phi_1810_ = _e528;
                    } else {
                        phi_1810_ = true;
                    }
                    let _e530 = phi_1810_;
                    if _e530 {
                        phi_1814_ = 0.5f;
                    } else {
                        phi_1814_ = _e511;
                    }
                    let _e532 = phi_1814_;
                    phi_1822_ = evaluate_Verdict(_e532, true);
                } else {
                    if (_e511 > 0.5f) {
                        phi_1820_ = 1f;
                    } else {
                        phi_1820_ = 0f;
                    }
                    let _e536 = phi_1820_;
                    phi_1822_ = evaluate_Verdict(_e536, false);
                }
                let _e539 = phi_1822_;
                phi_1827_ = evaluate_Verdict(_e539.visibility, _e539.is_doubted);
            } else {
                phi_1827_ = evaluate_Verdict(0.5f, true);
            }
            let _e545 = phi_1827_;
            phi_1828_ = _e545;
        }
        let _e547 = phi_1828_;
        visibility.member[_e66.first_primitive] = _e547.visibility;
        phi_1832_ = _e547.is_doubted;
        phi_1833_ = _e66.first_primitive;
    } else {
        phi_1832_ = false;
        phi_1833_ = 0u;
    }
    let _e552 = phi_1832_;
    let _e554 = phi_1833_;
    if (_e53 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e552 {
        let _e558 = atomicAdd((&shared_[0u]), 1u);
        phi_1844_ = _e558;
    } else {
        phi_1844_ = 0u;
    }
    let _e560 = phi_1844_;
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
