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

struct type_29 {
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

struct type_36 {
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
var<uniform> p: type_29;
@group(0) @binding(2) 
var<storage> map: type_13;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_13;
@group(0) @binding(4) 
var<storage> levels: type_36;

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
        let _e66 = phi_160_;
        let _e68 = phi_161_;
        phi_162_ = _e66;
        phi_163_ = _e68;
    } else {
        phi_162_ = lt_bvh_traverse_Tree();
        phi_163_ = true;
    }
    let _e70 = phi_162_;
    let _e72 = phi_163_;
    if _e72 {
        phi_168_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_168_ = _e70;
    }
    let _e77 = phi_168_;
    return lt_bvh_traverse_Tree(_e77.root, _e77.first_primitive);
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

    let _e57 = (*param_4).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_348_ = true;
    } else {
        let _e61 = (42f < _e57);
        if _e61 {
        }
        phi_348_ = _e61;
    }
    let _e63 = phi_348_;
    if _e63 {
        phi_352_ = 42f;
    } else {
        phi_352_ = _e57;
    }
    let _e65 = phi_352_;
    let _e67 = (_e65 * param_5.x);
    let _e69 = (_e65 * param_5.y);
    let _e71 = (_e65 * param_5.z);
    let _e73 = (_e65 * param_5.w);
    if ((bitcast<u32>(_e67) & 2147483647u) > 2139095040u) {
        phi_448_ = _e67;
    } else {
        if (_e67 < -87f) {
            phi_371_ = -87f;
        } else {
            phi_371_ = _e67;
        }
        let _e79 = phi_371_;
        if (_e79 > 88f) {
            phi_376_ = 88f;
        } else {
            phi_376_ = _e79;
        }
        let _e82 = phi_376_;
        let _e84 = ((_e82 * 1.442695f) + 0.5f);
        if (_e84 > -8388608f) {
            let _e96 = f32(select(0i, select(select(i32(_e84), i32(-2147483648), (_e84 < bitcast<f32>(3472883712u))), 2147483647i, (_e84 > bitcast<f32>(1325400063u))), (_e84 == _e84)));
            if (_e96 > _e84) {
                phi_398_ = 1f;
            } else {
                phi_398_ = 0f;
            }
            let _e99 = phi_398_;
            if (_e84 < 8388608f) {
                phi_403_ = (_e96 - _e99);
                phi_404_ = false;
            } else {
                phi_403_ = f32();
                phi_404_ = true;
            }
            let _e102 = phi_403_;
            let _e104 = phi_404_;
            phi_405_ = _e102;
            phi_406_ = _e104;
        } else {
            phi_405_ = f32();
            phi_406_ = true;
        }
        let _e106 = phi_405_;
        let _e108 = phi_406_;
        if _e108 {
            phi_410_ = _e84;
        } else {
            phi_410_ = _e106;
        }
        let _e110 = phi_410_;
        let _e114 = ((_e82 - (_e110 * 0.69314575f)) - (_e110 * 0.0000014286068f));
        phi_448_ = ((((((((((((((((1f / 5040f) * _e114) + (1f / 720f)) * _e114) + (1f / 120f)) * _e114) + (1f / 24f)) * _e114) + (1f / 6f)) * _e114) + 0.5f) * _e114) + 1f) * _e114) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e110), i32(-2147483648), (_e110 < bitcast<f32>(3472883712u))), 2147483647i, (_e110 > bitcast<f32>(1325400063u))), (_e110 == _e110)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e150 = phi_448_;
    if ((bitcast<u32>(_e69) & 2147483647u) > 2139095040u) {
        phi_536_ = _e69;
    } else {
        if (_e69 < -87f) {
            phi_459_ = -87f;
        } else {
            phi_459_ = _e69;
        }
        let _e156 = phi_459_;
        if (_e156 > 88f) {
            phi_464_ = 88f;
        } else {
            phi_464_ = _e156;
        }
        let _e159 = phi_464_;
        let _e161 = ((_e159 * 1.442695f) + 0.5f);
        if (_e161 > -8388608f) {
            let _e173 = f32(select(0i, select(select(i32(_e161), i32(-2147483648), (_e161 < bitcast<f32>(3472883712u))), 2147483647i, (_e161 > bitcast<f32>(1325400063u))), (_e161 == _e161)));
            if (_e173 > _e161) {
                phi_486_ = 1f;
            } else {
                phi_486_ = 0f;
            }
            let _e176 = phi_486_;
            if (_e161 < 8388608f) {
                phi_491_ = (_e173 - _e176);
                phi_492_ = false;
            } else {
                phi_491_ = f32();
                phi_492_ = true;
            }
            let _e179 = phi_491_;
            let _e181 = phi_492_;
            phi_493_ = _e179;
            phi_494_ = _e181;
        } else {
            phi_493_ = f32();
            phi_494_ = true;
        }
        let _e183 = phi_493_;
        let _e185 = phi_494_;
        if _e185 {
            phi_498_ = _e161;
        } else {
            phi_498_ = _e183;
        }
        let _e187 = phi_498_;
        let _e191 = ((_e159 - (_e187 * 0.69314575f)) - (_e187 * 0.0000014286068f));
        phi_536_ = ((((((((((((((((1f / 5040f) * _e191) + (1f / 720f)) * _e191) + (1f / 120f)) * _e191) + (1f / 24f)) * _e191) + (1f / 6f)) * _e191) + 0.5f) * _e191) + 1f) * _e191) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e187), i32(-2147483648), (_e187 < bitcast<f32>(3472883712u))), 2147483647i, (_e187 > bitcast<f32>(1325400063u))), (_e187 == _e187)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e227 = phi_536_;
    if ((bitcast<u32>(_e71) & 2147483647u) > 2139095040u) {
        phi_624_ = _e71;
    } else {
        if (_e71 < -87f) {
            phi_547_ = -87f;
        } else {
            phi_547_ = _e71;
        }
        let _e233 = phi_547_;
        if (_e233 > 88f) {
            phi_552_ = 88f;
        } else {
            phi_552_ = _e233;
        }
        let _e236 = phi_552_;
        let _e238 = ((_e236 * 1.442695f) + 0.5f);
        if (_e238 > -8388608f) {
            let _e250 = f32(select(0i, select(select(i32(_e238), i32(-2147483648), (_e238 < bitcast<f32>(3472883712u))), 2147483647i, (_e238 > bitcast<f32>(1325400063u))), (_e238 == _e238)));
            if (_e250 > _e238) {
                phi_574_ = 1f;
            } else {
                phi_574_ = 0f;
            }
            let _e253 = phi_574_;
            if (_e238 < 8388608f) {
                phi_579_ = (_e250 - _e253);
                phi_580_ = false;
            } else {
                phi_579_ = f32();
                phi_580_ = true;
            }
            let _e256 = phi_579_;
            let _e258 = phi_580_;
            phi_581_ = _e256;
            phi_582_ = _e258;
        } else {
            phi_581_ = f32();
            phi_582_ = true;
        }
        let _e260 = phi_581_;
        let _e262 = phi_582_;
        if _e262 {
            phi_586_ = _e238;
        } else {
            phi_586_ = _e260;
        }
        let _e264 = phi_586_;
        let _e268 = ((_e236 - (_e264 * 0.69314575f)) - (_e264 * 0.0000014286068f));
        phi_624_ = ((((((((((((((((1f / 5040f) * _e268) + (1f / 720f)) * _e268) + (1f / 120f)) * _e268) + (1f / 24f)) * _e268) + (1f / 6f)) * _e268) + 0.5f) * _e268) + 1f) * _e268) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e264), i32(-2147483648), (_e264 < bitcast<f32>(3472883712u))), 2147483647i, (_e264 > bitcast<f32>(1325400063u))), (_e264 == _e264)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e304 = phi_624_;
    if ((bitcast<u32>(_e73) & 2147483647u) > 2139095040u) {
        phi_712_ = _e73;
    } else {
        if (_e73 < -87f) {
            phi_635_ = -87f;
        } else {
            phi_635_ = _e73;
        }
        let _e310 = phi_635_;
        if (_e310 > 88f) {
            phi_640_ = 88f;
        } else {
            phi_640_ = _e310;
        }
        let _e313 = phi_640_;
        let _e315 = ((_e313 * 1.442695f) + 0.5f);
        if (_e315 > -8388608f) {
            let _e327 = f32(select(0i, select(select(i32(_e315), i32(-2147483648), (_e315 < bitcast<f32>(3472883712u))), 2147483647i, (_e315 > bitcast<f32>(1325400063u))), (_e315 == _e315)));
            if (_e327 > _e315) {
                phi_662_ = 1f;
            } else {
                phi_662_ = 0f;
            }
            let _e330 = phi_662_;
            if (_e315 < 8388608f) {
                phi_667_ = (_e327 - _e330);
                phi_668_ = false;
            } else {
                phi_667_ = f32();
                phi_668_ = true;
            }
            let _e333 = phi_667_;
            let _e335 = phi_668_;
            phi_669_ = _e333;
            phi_670_ = _e335;
        } else {
            phi_669_ = f32();
            phi_670_ = true;
        }
        let _e337 = phi_669_;
        let _e339 = phi_670_;
        if _e339 {
            phi_674_ = _e315;
        } else {
            phi_674_ = _e337;
        }
        let _e341 = phi_674_;
        let _e345 = ((_e313 - (_e341 * 0.69314575f)) - (_e341 * 0.0000014286068f));
        phi_712_ = ((((((((((((((((1f / 5040f) * _e345) + (1f / 720f)) * _e345) + (1f / 120f)) * _e345) + (1f / 24f)) * _e345) + (1f / 6f)) * _e345) + 0.5f) * _e345) + 1f) * _e345) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e341), i32(-2147483648), (_e341 < bitcast<f32>(3472883712u))), 2147483647i, (_e341 > bitcast<f32>(1325400063u))), (_e341 == _e341)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e381 = phi_712_;
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
        phi_765_ = true;
    } else {
        let _e427 = (_e393 > _e423);
        if _e427 {
        }
        phi_765_ = _e427;
    }
    let _e429 = phi_765_;
    if _e429 {
        phi_769_ = _e393;
    } else {
        phi_769_ = _e423;
    }
    let _e431 = phi_769_;
    let _e432 = -(_e404);
    if (_e432 <= 0f) {
        let _e436 = ((bitcast<u32>(_e431) & 2147483647u) > 2139095040u);
        if _e436 {
        }
        phi_781_ = _e436;
    } else {
        phi_781_ = true;
    }
    let _e438 = phi_781_;
    if _e438 {
        phi_788_ = (_e431 / (_e431 + (_e432 * _e432)));
    } else {
        phi_788_ = 1f;
    }
    let _e443 = phi_788_;
    let _e445 = (*param_4).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_801_ = true;
    } else {
        let _e449 = (42f < _e445);
        if _e449 {
        }
        phi_801_ = _e449;
    }
    let _e451 = phi_801_;
    if _e451 {
        phi_805_ = 42f;
    } else {
        phi_805_ = _e445;
    }
    let _e453 = phi_805_;
    let _e454 = -(_e453);
    let _e456 = (_e454 * param_5.x);
    let _e458 = (_e454 * param_5.y);
    let _e460 = (_e454 * param_5.z);
    let _e462 = (_e454 * param_5.w);
    if ((bitcast<u32>(_e456) & 2147483647u) > 2139095040u) {
        phi_902_ = _e456;
    } else {
        if (_e456 < -87f) {
            phi_825_ = -87f;
        } else {
            phi_825_ = _e456;
        }
        let _e468 = phi_825_;
        if (_e468 > 88f) {
            phi_830_ = 88f;
        } else {
            phi_830_ = _e468;
        }
        let _e471 = phi_830_;
        let _e473 = ((_e471 * 1.442695f) + 0.5f);
        if (_e473 > -8388608f) {
            let _e485 = f32(select(0i, select(select(i32(_e473), i32(-2147483648), (_e473 < bitcast<f32>(3472883712u))), 2147483647i, (_e473 > bitcast<f32>(1325400063u))), (_e473 == _e473)));
            if (_e485 > _e473) {
                phi_852_ = 1f;
            } else {
                phi_852_ = 0f;
            }
            let _e488 = phi_852_;
            if (_e473 < 8388608f) {
                phi_857_ = (_e485 - _e488);
                phi_858_ = false;
            } else {
                phi_857_ = f32();
                phi_858_ = true;
            }
            let _e491 = phi_857_;
            let _e493 = phi_858_;
            phi_859_ = _e491;
            phi_860_ = _e493;
        } else {
            phi_859_ = f32();
            phi_860_ = true;
        }
        let _e495 = phi_859_;
        let _e497 = phi_860_;
        if _e497 {
            phi_864_ = _e473;
        } else {
            phi_864_ = _e495;
        }
        let _e499 = phi_864_;
        let _e503 = ((_e471 - (_e499 * 0.69314575f)) - (_e499 * 0.0000014286068f));
        phi_902_ = ((((((((((((((((1f / 5040f) * _e503) + (1f / 720f)) * _e503) + (1f / 120f)) * _e503) + (1f / 24f)) * _e503) + (1f / 6f)) * _e503) + 0.5f) * _e503) + 1f) * _e503) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e499), i32(-2147483648), (_e499 < bitcast<f32>(3472883712u))), 2147483647i, (_e499 > bitcast<f32>(1325400063u))), (_e499 == _e499)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e539 = phi_902_;
    if ((bitcast<u32>(_e458) & 2147483647u) > 2139095040u) {
        phi_990_ = _e458;
    } else {
        if (_e458 < -87f) {
            phi_913_ = -87f;
        } else {
            phi_913_ = _e458;
        }
        let _e545 = phi_913_;
        if (_e545 > 88f) {
            phi_918_ = 88f;
        } else {
            phi_918_ = _e545;
        }
        let _e548 = phi_918_;
        let _e550 = ((_e548 * 1.442695f) + 0.5f);
        if (_e550 > -8388608f) {
            let _e562 = f32(select(0i, select(select(i32(_e550), i32(-2147483648), (_e550 < bitcast<f32>(3472883712u))), 2147483647i, (_e550 > bitcast<f32>(1325400063u))), (_e550 == _e550)));
            if (_e562 > _e550) {
                phi_940_ = 1f;
            } else {
                phi_940_ = 0f;
            }
            let _e565 = phi_940_;
            if (_e550 < 8388608f) {
                phi_945_ = (_e562 - _e565);
                phi_946_ = false;
            } else {
                phi_945_ = f32();
                phi_946_ = true;
            }
            let _e568 = phi_945_;
            let _e570 = phi_946_;
            phi_947_ = _e568;
            phi_948_ = _e570;
        } else {
            phi_947_ = f32();
            phi_948_ = true;
        }
        let _e572 = phi_947_;
        let _e574 = phi_948_;
        if _e574 {
            phi_952_ = _e550;
        } else {
            phi_952_ = _e572;
        }
        let _e576 = phi_952_;
        let _e580 = ((_e548 - (_e576 * 0.69314575f)) - (_e576 * 0.0000014286068f));
        phi_990_ = ((((((((((((((((1f / 5040f) * _e580) + (1f / 720f)) * _e580) + (1f / 120f)) * _e580) + (1f / 24f)) * _e580) + (1f / 6f)) * _e580) + 0.5f) * _e580) + 1f) * _e580) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e576), i32(-2147483648), (_e576 < bitcast<f32>(3472883712u))), 2147483647i, (_e576 > bitcast<f32>(1325400063u))), (_e576 == _e576)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e616 = phi_990_;
    if ((bitcast<u32>(_e460) & 2147483647u) > 2139095040u) {
        phi_1078_ = _e460;
    } else {
        if (_e460 < -87f) {
            phi_1001_ = -87f;
        } else {
            phi_1001_ = _e460;
        }
        let _e622 = phi_1001_;
        if (_e622 > 88f) {
            phi_1006_ = 88f;
        } else {
            phi_1006_ = _e622;
        }
        let _e625 = phi_1006_;
        let _e627 = ((_e625 * 1.442695f) + 0.5f);
        if (_e627 > -8388608f) {
            let _e639 = f32(select(0i, select(select(i32(_e627), i32(-2147483648), (_e627 < bitcast<f32>(3472883712u))), 2147483647i, (_e627 > bitcast<f32>(1325400063u))), (_e627 == _e627)));
            if (_e639 > _e627) {
                phi_1028_ = 1f;
            } else {
                phi_1028_ = 0f;
            }
            let _e642 = phi_1028_;
            if (_e627 < 8388608f) {
                phi_1033_ = (_e639 - _e642);
                phi_1034_ = false;
            } else {
                phi_1033_ = f32();
                phi_1034_ = true;
            }
            let _e645 = phi_1033_;
            let _e647 = phi_1034_;
            phi_1035_ = _e645;
            phi_1036_ = _e647;
        } else {
            phi_1035_ = f32();
            phi_1036_ = true;
        }
        let _e649 = phi_1035_;
        let _e651 = phi_1036_;
        if _e651 {
            phi_1040_ = _e627;
        } else {
            phi_1040_ = _e649;
        }
        let _e653 = phi_1040_;
        let _e657 = ((_e625 - (_e653 * 0.69314575f)) - (_e653 * 0.0000014286068f));
        phi_1078_ = ((((((((((((((((1f / 5040f) * _e657) + (1f / 720f)) * _e657) + (1f / 120f)) * _e657) + (1f / 24f)) * _e657) + (1f / 6f)) * _e657) + 0.5f) * _e657) + 1f) * _e657) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e653), i32(-2147483648), (_e653 < bitcast<f32>(3472883712u))), 2147483647i, (_e653 > bitcast<f32>(1325400063u))), (_e653 == _e653)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e693 = phi_1078_;
    if ((bitcast<u32>(_e462) & 2147483647u) > 2139095040u) {
        phi_1166_ = _e462;
    } else {
        if (_e462 < -87f) {
            phi_1089_ = -87f;
        } else {
            phi_1089_ = _e462;
        }
        let _e699 = phi_1089_;
        if (_e699 > 88f) {
            phi_1094_ = 88f;
        } else {
            phi_1094_ = _e699;
        }
        let _e702 = phi_1094_;
        let _e704 = ((_e702 * 1.442695f) + 0.5f);
        if (_e704 > -8388608f) {
            let _e716 = f32(select(0i, select(select(i32(_e704), i32(-2147483648), (_e704 < bitcast<f32>(3472883712u))), 2147483647i, (_e704 > bitcast<f32>(1325400063u))), (_e704 == _e704)));
            if (_e716 > _e704) {
                phi_1116_ = 1f;
            } else {
                phi_1116_ = 0f;
            }
            let _e719 = phi_1116_;
            if (_e704 < 8388608f) {
                phi_1121_ = (_e716 - _e719);
                phi_1122_ = false;
            } else {
                phi_1121_ = f32();
                phi_1122_ = true;
            }
            let _e722 = phi_1121_;
            let _e724 = phi_1122_;
            phi_1123_ = _e722;
            phi_1124_ = _e724;
        } else {
            phi_1123_ = f32();
            phi_1124_ = true;
        }
        let _e726 = phi_1123_;
        let _e728 = phi_1124_;
        if _e728 {
            phi_1128_ = _e704;
        } else {
            phi_1128_ = _e726;
        }
        let _e730 = phi_1128_;
        let _e734 = ((_e702 - (_e730 * 0.69314575f)) - (_e730 * 0.0000014286068f));
        phi_1166_ = ((((((((((((((((1f / 5040f) * _e734) + (1f / 720f)) * _e734) + (1f / 120f)) * _e734) + (1f / 24f)) * _e734) + (1f / 6f)) * _e734) + 0.5f) * _e734) + 1f) * _e734) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e730), i32(-2147483648), (_e730 < bitcast<f32>(3472883712u))), 2147483647i, (_e730 > bitcast<f32>(1325400063u))), (_e730 == _e730)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e770 = phi_1166_;
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
        phi_1219_ = true;
    } else {
        let _e816 = (_e782 > _e812);
        if _e816 {
        }
        phi_1219_ = _e816;
    }
    let _e818 = phi_1219_;
    if _e818 {
        phi_1223_ = _e782;
    } else {
        phi_1223_ = _e812;
    }
    let _e820 = phi_1223_;
    let _e821 = -(_e793);
    if (_e821 <= 0f) {
        let _e825 = ((bitcast<u32>(_e820) & 2147483647u) > 2139095040u);
        if _e825 {
        }
        phi_1235_ = _e825;
    } else {
        phi_1235_ = true;
    }
    let _e827 = phi_1235_;
    if _e827 {
        phi_1242_ = (_e820 / (_e820 + (_e821 * _e821)));
    } else {
        phi_1242_ = 1f;
    }
    let _e832 = phi_1242_;
    if ((bitcast<u32>(_e832) & 2147483647u) > 2139095040u) {
        phi_1253_ = true;
    } else {
        let _e836 = (_e832 < _e443);
        if _e836 {
        }
        phi_1253_ = _e836;
    }
    let _e838 = phi_1253_;
    if _e838 {
        phi_1257_ = _e832;
    } else {
        phi_1257_ = _e443;
    }
    let _e840 = phi_1257_;
    if ((bitcast<u32>(_e840) & 2147483647u) > 2139095040u) {
        phi_1274_ = _e840;
    } else {
        if (_e840 < 0f) {
            phi_1273_ = 0f;
        } else {
            if (_e840 > 1f) {
                phi_1272_ = 1f;
            } else {
                phi_1272_ = _e840;
            }
            let _e847 = phi_1272_;
            phi_1273_ = _e847;
        }
        let _e849 = phi_1273_;
        phi_1274_ = _e849;
    }
    let _e851 = phi_1274_;
    return _e851;
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
            let _e63 = phi_197_;
            phi_198_ = _e63;
        }
        let _e65 = phi_198_;
        phi_199_ = _e65;
    }
    let _e67 = phi_199_;
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
            let _e75 = phi_215_;
            phi_216_ = _e75;
        }
        let _e77 = phi_216_;
        phi_217_ = _e77;
    }
    let _e79 = phi_217_;
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
            let _e87 = phi_233_;
            phi_234_ = _e87;
        }
        let _e89 = phi_234_;
        phi_235_ = _e89;
    }
    let _e91 = phi_235_;
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
            let _e99 = phi_251_;
            phi_252_ = _e99;
        }
        let _e101 = phi_252_;
        phi_253_ = _e101;
    }
    let _e103 = phi_253_;
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
            let _e111 = phi_269_;
            phi_270_ = _e111;
        }
        let _e113 = phi_270_;
        phi_271_ = _e113;
    }
    let _e115 = phi_271_;
    let _e116 = (_e79 - _e67);
    let _e117 = (_e91 - _e67);
    let _e118 = (_e103 - _e67);
    let _e119 = (_e115 - _e67);
    if (_e116 >= 0f) {
        if (_e117 >= 0f) {
            if (_e118 >= 0f) {
                if (_e119 >= 0f) {
                    phi_308_ = !(((bitcast<u32>(((((_e116 * param_9.x) + (_e117 * param_9.y)) + (_e118 * param_9.z)) + (_e119 * param_9.w))) & 2147483647u) > 2139095040u));
                    phi_309_ = false;
                } else {
                    phi_308_ = bool();
                    phi_309_ = true;
                }
                let _e141 = phi_308_;
                let _e143 = phi_309_;
                phi_310_ = _e141;
                phi_311_ = false;
                phi_312_ = _e143;
            } else {
                phi_310_ = bool();
                phi_311_ = true;
                phi_312_ = false;
            }
            let _e145 = phi_310_;
            let _e147 = phi_311_;
            let _e149 = phi_312_;
            phi_313_ = _e145;
            phi_314_ = _e147;
            phi_315_ = _e149;
        } else {
            phi_313_ = bool();
            phi_314_ = true;
            phi_315_ = false;
        }
        let _e151 = phi_313_;
        let _e153 = phi_314_;
        let _e155 = phi_315_;
        phi_316_ = _e151;
        phi_317_ = _e153;
        phi_318_ = _e155;
    } else {
        phi_316_ = bool();
        phi_317_ = true;
        phi_318_ = false;
    }
    let _e157 = phi_316_;
    let _e159 = phi_317_;
    let _e161 = phi_318_;
    if _e159 {
        phi_322_ = true;
    } else {
        phi_322_ = _e161;
    }
    let _e163 = phi_322_;
    if _e163 {
        phi_326_ = false;
    } else {
        phi_326_ = _e157;
    }
    let _e165 = phi_326_;
    if _e165 {
        phi_331_ = 1f;
    } else {
        let _e166 = _lt_math_evsm_Evsm_bound_of_offsets(param_7, vec4<f32>(_e116, _e117, _e118, _e119), param_9);
        phi_331_ = _e166;
    }
    let _e168 = phi_331_;
    return _e168;
}

fn lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(param_11: f32, param_12: f32) -> f32 {
    var phi_1282_: f32;

    if (param_11 < param_12) {
        phi_1282_ = param_11;
    } else {
        phi_1282_ = param_12;
    }
    let _e57 = phi_1282_;
    return _e57;
}

fn function_() {
    var local: lt_math_Evsm;
    var phi_1343_: bool;
    var phi_1344_: bool;
    var phi_1345_: bool;
    var phi_1346_: bool;
    var phi_1350_: bool;
    var phi_1394_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1398_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1418_: lt_math_LightPoint;
    var phi_1421_: u32;
    var phi_1423_: lt_math_LevelPoint;
    var phi_1509_: bool;
    var phi_1518_: bool;
    var phi_1527_: bool;
    var phi_1528_: bool;
    var phi_1529_: bool;
    var phi_1530_: bool;
    var phi_1531_: bool;
    var phi_1532_: bool;
    var phi_1533_: bool;
    var phi_1537_: bool;
    var phi_1564_: bool;
    var phi_1565_: bool;
    var phi_1566_: bool;
    var phi_1567_: bool;
    var phi_1568_: bool;
    var phi_1569_: bool;
    var phi_1570_: bool;
    var phi_1571_: bool;
    var phi_1575_: bool;
    var phi_1584_: lt_math_LightPoint;
    var phi_1585_: u32;
    var phi_1586_: lt_math_LevelPoint;
    var phi_1587_: bool;
    var phi_1419_: lt_math_LightPoint;
    var phi_1422_: u32;
    var phi_1424_: lt_math_LevelPoint;
    var phi_1588_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_1628_: bool;
    var phi_1629_: bool;
    var phi_1630_: bool;
    var phi_1631_: bool;
    var phi_1635_: bool;
    var phi_1717_: f32;
    var phi_1833_: f32;
    var phi_1834_: f32;
    var phi_1837_: f32;
    var phi_1866_: f32;
    var phi_1871_: f32;
    var phi_1872_: bool;
    var phi_1873_: f32;
    var phi_1874_: bool;
    var phi_1878_: f32;
    var phi_1898_: f32;
    var phi_1903_: f32;
    var phi_1904_: bool;
    var phi_1905_: f32;
    var phi_1906_: bool;
    var phi_1910_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_1963_: i32;
    var phi_1968_: i32;
    var phi_1973_: i32;
    var phi_1978_: i32;
    var phi_1987_: i32;
    var phi_1992_: i32;
    var phi_1997_: i32;
    var phi_2002_: i32;
    var local_4: lt_math_LevelPoint;
    var phi_2074_: f32;
    var phi_2076_: evaluate_Verdict;
    var phi_2077_: bool;
    var phi_2078_: evaluate_Verdict;
    var phi_2079_: bool;
    var phi_2084_: evaluate_Verdict;
    var phi_2085_: bool;
    var phi_2087_: evaluate_Verdict;
    var phi_2088_: evaluate_Verdict;
    var phi_2089_: bool;
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
        let _e84 = p.member.light;
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
            let _e113 = samples.member[(0u + _e73.first_primitive)].normal;
            let _e115 = samples.member[(0u + _e73.first_primitive)].position;
            if ((((_e113.x * (_e84.x - (_e115.x * _e84.w))) + (_e113.y * (_e84.y - (_e115.y * _e84.w)))) + (_e113.z * (_e84.z - (_e115.z * _e84.w)))) > 0f) {
                let _e139 = samples.member[(0u + _e73.first_primitive)].flags;
                let _e147 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e153 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e147.unnamed.visibility, false), _e147.unnamed_1);
                phi_1394_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e153.unnamed, ((_e139 & 1u) == 0u));
            } else {
                let _e162 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e168 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e162.unnamed.visibility, false), _e162.unnamed_1);
                phi_1394_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e168.unnamed, true);
            }
            let _e173 = phi_1394_;
            phi_1398_ = _e173;
        } else {
            let _e179 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e185 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e179.unnamed.visibility, false), _e179.unnamed_1);
            phi_1398_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e185.unnamed, true);
        }
        let _e190 = phi_1398_;
        if _e190.unnamed_1 {
            phi_2093_ = evaluate_Verdict(_e190.unnamed.visibility, _e190.unnamed.is_doubted);
            phi_2094_ = evaluate_Verdict();
            phi_2095_ = true;
        } else {
            let _e198 = samples.member[(0u + _e73.first_primitive)].position;
            let _e200 = p.member.map_size;
            let _e202 = (0.5f / f32(_e200));
            let _e209 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e216 = lt_math_LightPoint(vec2<f32>(_e209.uv.x, 0f), _e209.depth, _e209.is_inside);
            let _e220 = lt_math_LightPoint(_e216.uv, 0f, _e216.is_inside);
            phi_1418_ = lt_math_LightPoint();
            phi_1421_ = 0u;
            phi_1423_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e220.uv, _e220.depth, false));
            loop {
                let _e227 = phi_1418_;
                let _e229 = phi_1421_;
                let _e231 = phi_1423_;
                local_1 = _e231;
                local_2 = _e231;
                local_3 = _e231;
                local_4 = _e231;
                if (_e229 < _e79) {
                    if _e231.point.is_inside {
                        phi_1584_ = lt_math_LightPoint();
                        phi_1585_ = u32();
                        phi_1586_ = lt_math_LevelPoint();
                        phi_1587_ = false;
                    } else {
                        if (_e229 < _e67) {
                        } else {
                            return;
                        }
                        let _e242 = levels.member[(0u + _e229)].row_w;
                        let _e253 = ((((_e242.x * _e198.x) + (_e242.y * _e198.y)) + (_e242.z * _e198.z)) + (_e242.w * 1f));
                        let _e255 = levels.member[(0u + _e229)].row_x;
                        let _e267 = (((((_e255.x * _e198.x) + (_e255.y * _e198.y)) + (_e255.z * _e198.z)) + (_e255.w * 1f)) / _e253);
                        let _e269 = levels.member[(0u + _e229)].row_y;
                        let _e281 = (((((_e269.x * _e198.x) + (_e269.y * _e198.y)) + (_e269.z * _e198.z)) + (_e269.w * 1f)) / _e253);
                        let _e283 = levels.member[(0u + _e229)].row_z;
                        let _e294 = ((((_e283.x * _e198.x) + (_e283.y * _e198.y)) + (_e283.z * _e198.z)) + (_e283.w * 1f));
                        if (_e253 > 0f) {
                            if (_e267 >= 0f) {
                                phi_1509_ = (_e267 <= 1f);
                            } else {
                                phi_1509_ = false;
                            }
                            let _e299 = phi_1509_;
                            if _e299 {
                                if (_e281 >= 0f) {
                                    phi_1518_ = (_e281 <= 1f);
                                } else {
                                    phi_1518_ = false;
                                }
                                let _e303 = phi_1518_;
                                if _e303 {
                                    if (_e294 >= 0f) {
                                        phi_1527_ = (_e294 <= 1f);
                                    } else {
                                        phi_1527_ = false;
                                    }
                                    let _e307 = phi_1527_;
                                    phi_1528_ = _e307;
                                    phi_1529_ = false;
                                } else {
                                    phi_1528_ = bool();
                                    phi_1529_ = true;
                                }
                                let _e309 = phi_1528_;
                                let _e311 = phi_1529_;
                                phi_1530_ = _e309;
                                phi_1531_ = _e311;
                            } else {
                                phi_1530_ = bool();
                                phi_1531_ = true;
                            }
                            let _e313 = phi_1530_;
                            let _e315 = phi_1531_;
                            phi_1532_ = _e313;
                            phi_1533_ = _e315;
                        } else {
                            phi_1532_ = bool();
                            phi_1533_ = true;
                        }
                        let _e317 = phi_1532_;
                        let _e319 = phi_1533_;
                        if _e319 {
                            phi_1537_ = false;
                        } else {
                            phi_1537_ = _e317;
                        }
                        let _e321 = phi_1537_;
                        if _e321 {
                            if (_e267 >= _e202) {
                                if (_e267 <= (1f - _e202)) {
                                    if (_e281 >= _e202) {
                                        phi_1564_ = (_e281 <= (1f - _e202));
                                        phi_1565_ = false;
                                    } else {
                                        phi_1564_ = bool();
                                        phi_1565_ = true;
                                    }
                                    let _e329 = phi_1564_;
                                    let _e331 = phi_1565_;
                                    phi_1566_ = _e329;
                                    phi_1567_ = _e331;
                                } else {
                                    phi_1566_ = bool();
                                    phi_1567_ = true;
                                }
                                let _e333 = phi_1566_;
                                let _e335 = phi_1567_;
                                phi_1568_ = _e333;
                                phi_1569_ = _e335;
                            } else {
                                phi_1568_ = bool();
                                phi_1569_ = true;
                            }
                            let _e337 = phi_1568_;
                            let _e339 = phi_1569_;
                            phi_1570_ = _e337;
                            phi_1571_ = _e339;
                        } else {
                            phi_1570_ = bool();
                            phi_1571_ = true;
                        }
                        let _e341 = phi_1570_;
                        let _e343 = phi_1571_;
                        if _e343 {
                            phi_1575_ = false;
                        } else {
                            phi_1575_ = _e341;
                        }
                        let _e345 = phi_1575_;
                        let _e352 = lt_math_LightPoint(vec2<f32>(_e267, _e227.uv.y), _e227.depth, _e227.is_inside);
                        let _e359 = lt_math_LightPoint(vec2<f32>(_e352.uv.x, _e281), _e352.depth, _e352.is_inside);
                        let _e363 = lt_math_LightPoint(_e359.uv, _e294, _e359.is_inside);
                        let _e367 = lt_math_LightPoint(_e363.uv, _e363.depth, _e345);
                        phi_1584_ = _e367;
                        phi_1585_ = (_e229 + 1u);
                        phi_1586_ = lt_math_LevelPoint(_e229, _e367);
                        phi_1587_ = true;
                    }
                    let _e371 = phi_1584_;
                    let _e373 = phi_1585_;
                    let _e375 = phi_1586_;
                    let _e377 = phi_1587_;
                    phi_1419_ = _e371;
                    phi_1422_ = _e373;
                    phi_1424_ = _e375;
                    phi_1588_ = _e377;
                } else {
                    phi_1419_ = lt_math_LightPoint();
                    phi_1422_ = u32();
                    phi_1424_ = lt_math_LevelPoint();
                    phi_1588_ = false;
                }
                let _e379 = phi_1419_;
                let _e381 = phi_1422_;
                let _e383 = phi_1424_;
                let _e385 = phi_1588_;
                continue;
                continuing {
                    phi_1418_ = _e379;
                    phi_1421_ = _e381;
                    phi_1423_ = _e383;
                    break if !(_e385);
                }
            }
            let _e388 = local_1;
            if _e388.point.is_inside {
                if (0f > 0f) {
                    let _e394 = local_2;
                    if (_e394.level < _e67) {
                    } else {
                        return;
                    }
                    let _e399 = levels.member[(0u + _e394.level)];
                    let _e405 = global[0u];
                    if (_e399.row_w.x == _e405) {
                        let _e408 = global[1u];
                        if (_e399.row_w.y == _e408) {
                            let _e411 = global[2u];
                            phi_1628_ = (_e399.row_w.z == _e411);
                            phi_1629_ = false;
                        } else {
                            phi_1628_ = bool();
                            phi_1629_ = true;
                        }
                        let _e414 = phi_1628_;
                        let _e416 = phi_1629_;
                        phi_1630_ = _e414;
                        phi_1631_ = _e416;
                    } else {
                        phi_1630_ = bool();
                        phi_1631_ = true;
                    }
                    let _e418 = phi_1630_;
                    let _e420 = phi_1631_;
                    if _e420 {
                        phi_1635_ = false;
                    } else {
                        phi_1635_ = _e418;
                    }
                    let _e422 = phi_1635_;
                    if _e422 {
                        let _e424 = samples.member[(0u + _e73.first_primitive)].normal;
                        let _e426 = p.member.map_size;
                        let _e496 = ((abs(((((_e399.row_x.x * _e424.x) + (_e399.row_x.y * _e424.y)) + (_e399.row_x.z * _e424.z)) / (((_e399.row_x.x * _e399.row_x.x) + (_e399.row_x.y * _e399.row_x.y)) + (_e399.row_x.z * _e399.row_x.z)))) + abs(((((_e399.row_y.x * _e424.x) + (_e399.row_y.y * _e424.y)) + (_e399.row_y.z * _e424.z)) / (((_e399.row_y.x * _e399.row_y.x) + (_e399.row_y.y * _e399.row_y.y)) + (_e399.row_y.z * _e399.row_y.z))))) / (abs(((((_e399.row_z.x * _e424.x) + (_e399.row_z.y * _e424.y)) + (_e399.row_z.z * _e424.z)) / (((_e399.row_z.x * _e399.row_z.x) + (_e399.row_z.y * _e399.row_z.y)) + (_e399.row_z.z * _e399.row_z.z)))) * f32(_e426)));
                        if (_e496 < 0.002f) {
                            phi_1717_ = _e496;
                        } else {
                            phi_1717_ = 0.002f;
                        }
                        let _e499 = phi_1717_;
                        phi_1834_ = _e499;
                    } else {
                        let _e501 = p.member.map_size;
                        let _e507 = samples.member[(0u + _e73.first_primitive)].position;
                        let _e518 = ((((_e399.row_w.x * _e507.x) + (_e399.row_w.y * _e507.y)) + (_e399.row_w.z * _e507.z)) + _e399.row_w.w);
                        let _e531 = ((_e399.row_x.x - (_e399.row_w.x * _e388.point.uv.x)) / _e518);
                        let _e532 = ((_e399.row_x.y - (_e399.row_w.y * _e388.point.uv.x)) / _e518);
                        let _e533 = ((_e399.row_x.z - (_e399.row_w.z * _e388.point.uv.x)) / _e518);
                        let _e546 = ((_e399.row_y.x - (_e399.row_w.x * _e388.point.uv.y)) / _e518);
                        let _e547 = ((_e399.row_y.y - (_e399.row_w.y * _e388.point.uv.y)) / _e518);
                        let _e548 = ((_e399.row_y.z - (_e399.row_w.z * _e388.point.uv.y)) / _e518);
                        let _e554 = samples.member[(0u + _e73.first_primitive)].normal;
                        let _e559 = ((_e547 * _e554.z) - (_e554.y * _e548));
                        let _e564 = ((_e548 * _e554.x) - (_e554.z * _e546));
                        let _e569 = ((_e546 * _e554.y) - (_e554.x * _e547));
                        let _e571 = samples.member[(0u + _e73.first_primitive)].normal;
                        let _e576 = ((_e532 * _e571.z) - (_e571.y * _e533));
                        let _e581 = ((_e533 * _e571.x) - (_e571.z * _e531));
                        let _e586 = ((_e531 * _e571.y) - (_e571.x * _e532));
                        let _e613 = ((abs(((((_e399.row_z.x * _e559) + (_e399.row_z.y * _e564)) + (_e399.row_z.z * _e569)) / (((_e531 * _e559) + (_e532 * _e564)) + (_e533 * _e569)))) + abs(((((_e399.row_z.x * _e576) + (_e399.row_z.y * _e581)) + (_e399.row_z.z * _e586)) / (((_e546 * _e576) + (_e547 * _e581)) + (_e548 * _e586))))) / f32(_e501));
                        if (_e613 < 0.002f) {
                            phi_1833_ = _e613;
                        } else {
                            phi_1833_ = 0.002f;
                        }
                        let _e616 = phi_1833_;
                        phi_1834_ = _e616;
                    }
                    let _e618 = phi_1834_;
                    phi_1837_ = (_e388.point.depth - (0f * _e618));
                } else {
                    phi_1837_ = _e388.point.depth;
                }
                let _e622 = phi_1837_;
                let _e628 = p.member.map_size;
                let _e629 = f32(_e628);
                let _e632 = ((_e388.point.uv.x * _e629) - 0.5f);
                let _e633 = ((_e388.point.uv.y * _e629) - 0.5f);
                if (_e632 > -8388608f) {
                    let _e645 = f32(select(0i, select(select(i32(_e632), i32(-2147483648), (_e632 < bitcast<f32>(3472883712u))), 2147483647i, (_e632 > bitcast<f32>(1325400063u))), (_e632 == _e632)));
                    if (_e645 > _e632) {
                        phi_1866_ = 1f;
                    } else {
                        phi_1866_ = 0f;
                    }
                    let _e648 = phi_1866_;
                    if (_e632 < 8388608f) {
                        phi_1871_ = (_e645 - _e648);
                        phi_1872_ = false;
                    } else {
                        phi_1871_ = f32();
                        phi_1872_ = true;
                    }
                    let _e651 = phi_1871_;
                    let _e653 = phi_1872_;
                    phi_1873_ = _e651;
                    phi_1874_ = _e653;
                } else {
                    phi_1873_ = f32();
                    phi_1874_ = true;
                }
                let _e655 = phi_1873_;
                let _e657 = phi_1874_;
                if _e657 {
                    phi_1878_ = _e632;
                } else {
                    phi_1878_ = _e655;
                }
                let _e659 = phi_1878_;
                if (_e633 > -8388608f) {
                    let _e671 = f32(select(0i, select(select(i32(_e633), i32(-2147483648), (_e633 < bitcast<f32>(3472883712u))), 2147483647i, (_e633 > bitcast<f32>(1325400063u))), (_e633 == _e633)));
                    if (_e671 > _e633) {
                        phi_1898_ = 1f;
                    } else {
                        phi_1898_ = 0f;
                    }
                    let _e674 = phi_1898_;
                    if (_e633 < 8388608f) {
                        phi_1903_ = (_e671 - _e674);
                        phi_1904_ = false;
                    } else {
                        phi_1903_ = f32();
                        phi_1904_ = true;
                    }
                    let _e677 = phi_1903_;
                    let _e679 = phi_1904_;
                    phi_1905_ = _e677;
                    phi_1906_ = _e679;
                } else {
                    phi_1905_ = f32();
                    phi_1906_ = true;
                }
                let _e681 = phi_1905_;
                let _e683 = phi_1906_;
                if _e683 {
                    phi_1910_ = _e633;
                } else {
                    phi_1910_ = _e681;
                }
                let _e685 = phi_1910_;
                let _e686 = (_e632 - _e659);
                let _e687 = (_e633 - _e685);
                let _e696 = select(0i, select(select(i32(_e659), i32(-2147483648), (_e659 < bitcast<f32>(3472883712u))), 2147483647i, (_e659 > bitcast<f32>(1325400063u))), (_e659 == _e659));
                let _e705 = select(0i, select(select(i32(_e685), i32(-2147483648), (_e685 < bitcast<f32>(3472883712u))), 2147483647i, (_e685 > bitcast<f32>(1325400063u))), (_e685 == _e685));
                let _e716 = p.member.test;
                let _e717 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e716);
                let _e719 = p.member.map_size;
                let _e721 = local_3;
                local = lt_math_Evsm(_e717.positive_exponent, _e717.negative_exponent, _e717.min_variance);
                let _e728 = ((_e721.level * _e719) * _e719);
                let _e730 = (bitcast<i32>(_e719) - 1i);
                if (_e696 > 0i) {
                    phi_1963_ = _e696;
                } else {
                    phi_1963_ = 0i;
                }
                let _e733 = phi_1963_;
                if (_e705 > 0i) {
                    phi_1968_ = _e705;
                } else {
                    phi_1968_ = 0i;
                }
                let _e736 = phi_1968_;
                if (_e733 < _e730) {
                    phi_1973_ = _e733;
                } else {
                    phi_1973_ = _e730;
                }
                let _e739 = phi_1973_;
                if (_e736 < _e730) {
                    phi_1978_ = _e736;
                } else {
                    phi_1978_ = _e730;
                }
                let _e742 = phi_1978_;
                let _e743 = bitcast<u32>(_e739);
                let _e745 = (_e696 + 1i);
                let _e746 = (_e705 + 1i);
                if (_e745 > 0i) {
                    phi_1987_ = _e745;
                } else {
                    phi_1987_ = 0i;
                }
                let _e749 = phi_1987_;
                if (_e746 > 0i) {
                    phi_1992_ = _e746;
                } else {
                    phi_1992_ = 0i;
                }
                let _e752 = phi_1992_;
                if (_e749 < _e730) {
                    phi_1997_ = _e749;
                } else {
                    phi_1997_ = _e730;
                }
                let _e755 = phi_1997_;
                if (_e752 < _e730) {
                    phi_2002_ = _e752;
                } else {
                    phi_2002_ = _e730;
                }
                let _e758 = phi_2002_;
                let _e759 = bitcast<u32>(_e755);
                let _e761 = (bitcast<u32>(_e742) * _e719);
                let _e762 = (bitcast<u32>(_e758) * _e719);
                let _e767 = ((_e761 + _e743) + _e728);
                let _e768 = ((_e761 + _e759) + _e728);
                let _e769 = ((_e762 + _e743) + _e728);
                let _e770 = ((_e762 + _e759) + _e728);
                if (_e767 < _e61) {
                } else {
                    return;
                }
                let _e774 = map.member[(0u + _e767)];
                if (_e768 < _e61) {
                } else {
                    return;
                }
                let _e778 = map.member[(0u + _e768)];
                if (_e769 < _e61) {
                } else {
                    return;
                }
                let _e782 = map.member[(0u + _e769)];
                if (_e770 < _e61) {
                } else {
                    return;
                }
                let _e786 = map.member[(0u + _e770)];
                let _e788 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e774, _e778, _e782, _e786), vec4<f32>(((1f - _e686) * (1f - _e687)), (_e686 * (1f - _e687)), ((1f - _e686) * _e687), (_e686 * _e687)), _e622);
                let _e790 = p.member.fade_uv;
                if (_e790 > 0f) {
                    let _e793 = local_4;
                    if ((_e793.level + 1u) == _e79) {
                        let _e802 = p.member.fade_uv;
                        let _e804 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e388.point.uv.x, (1f - _e388.point.uv.x));
                        let _e806 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e388.point.uv.y, (1f - _e388.point.uv.y));
                        let _e807 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e804, _e806);
                        if (_e807 < _e802) {
                            phi_2074_ = (1f - ((1f - _e788) * (_e807 / _e802)));
                        } else {
                            phi_2074_ = _e788;
                        }
                        let _e814 = phi_2074_;
                        phi_2076_ = evaluate_Verdict(_e814, false);
                        phi_2077_ = false;
                    } else {
                        phi_2076_ = evaluate_Verdict();
                        phi_2077_ = true;
                    }
                    let _e817 = phi_2076_;
                    let _e819 = phi_2077_;
                    phi_2078_ = _e817;
                    phi_2079_ = _e819;
                } else {
                    phi_2078_ = evaluate_Verdict();
                    phi_2079_ = true;
                }
                let _e821 = phi_2078_;
                let _e823 = phi_2079_;
                if _e823 {
                    phi_2084_ = evaluate_Verdict(_e788, false);
                    phi_2085_ = false;
                } else {
                    phi_2084_ = evaluate_Verdict();
                    phi_2085_ = true;
                }
                let _e826 = phi_2084_;
                let _e828 = phi_2085_;
                phi_2087_ = _e826;
                phi_2088_ = _e821;
                phi_2089_ = _e828;
            } else {
                phi_2087_ = evaluate_Verdict();
                phi_2088_ = evaluate_Verdict(1f, false);
                phi_2089_ = true;
            }
            let _e831 = phi_2087_;
            let _e833 = phi_2088_;
            let _e835 = phi_2089_;
            if _e835 {
            }
            phi_2093_ = _e833;
            phi_2094_ = _e831;
            phi_2095_ = _e835;
        }
        let _e837 = phi_2093_;
        let _e839 = phi_2094_;
        let _e841 = phi_2095_;
        if _e841 {
            phi_2099_ = _e837;
        } else {
            phi_2099_ = _e839;
        }
        let _e843 = phi_2099_;
        if (_e73.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e73.first_primitive)] = _e843.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_evsm_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
