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

struct type_37 {
    member: array<vec4<f32>>,
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

struct type_41 {
    member: abi_ShadowParams,
}

struct lt_math_OneLevel {
    projection: lt_math_LightProjection,
}

struct type_48 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
var<private> local_2: u32;
@group(0) @binding(1) 
var<storage> samples: type_10;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(0) 
var<uniform> p: type_41;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_18;
@group(0) @binding(4) 
var<storage, read_write> list: type_48;
@group(0) @binding(2) 
var<storage> map: type_37;

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
        let _e63 = phi_160_;
        let _e65 = phi_161_;
        phi_162_ = _e63;
        phi_163_ = _e65;
    } else {
        phi_162_ = lt_bvh_traverse_Tree();
        phi_163_ = true;
    }
    let _e67 = phi_162_;
    let _e69 = phi_163_;
    if _e69 {
        phi_168_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_168_ = _e67;
    }
    let _e74 = phi_168_;
    return lt_bvh_traverse_Tree(_e74.root, _e74.first_primitive);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_esm_Esm_clamped_exponent(param_4: ptr<function, f32>) -> f32 {
    var phi_188_: bool;
    var phi_192_: f32;

    let _e51 = (*param_4);
    if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
        phi_188_ = true;
    } else {
        let _e55 = (84f < _e51);
        if _e55 {
        }
        phi_188_ = _e55;
    }
    let _e57 = phi_188_;
    if _e57 {
        phi_192_ = 84f;
    } else {
        phi_192_ = _e51;
    }
    let _e59 = phi_192_;
    return _e59;
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_5: ptr<function, f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_211_: f32;
    var phi_212_: f32;
    var phi_213_: f32;
    var phi_228_: f32;
    var phi_233_: f32;
    var phi_255_: f32;
    var phi_260_: f32;
    var phi_261_: bool;
    var phi_262_: f32;
    var phi_263_: bool;
    var phi_267_: f32;
    var phi_305_: f32;
    var phi_321_: f32;
    var phi_322_: f32;
    var phi_323_: f32;

    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_213_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_212_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_211_ = 1f;
            } else {
                phi_211_ = param_7;
            }
            let _e59 = phi_211_;
            phi_212_ = _e59;
        }
        let _e61 = phi_212_;
        phi_213_ = _e61;
    }
    let _e63 = phi_213_;
    let _e65 = _lt_math_esm_Esm_clamped_exponent(param_5);
    let _e67 = (_e65 * (1f - _e63));
    if ((bitcast<u32>(_e67) & 2147483647u) > 2139095040u) {
        phi_305_ = _e67;
    } else {
        if (_e67 < -87f) {
            phi_228_ = -87f;
        } else {
            phi_228_ = _e67;
        }
        let _e73 = phi_228_;
        if (_e73 > 88f) {
            phi_233_ = 88f;
        } else {
            phi_233_ = _e73;
        }
        let _e76 = phi_233_;
        let _e78 = ((_e76 * 1.442695f) + 0.5f);
        if (_e78 > -8388608f) {
            let _e90 = f32(select(0i, select(select(i32(_e78), i32(-2147483648), (_e78 < bitcast<f32>(3472883712u))), 2147483647i, (_e78 > bitcast<f32>(1325400063u))), (_e78 == _e78)));
            if (_e90 > _e78) {
                phi_255_ = 1f;
            } else {
                phi_255_ = 0f;
            }
            let _e93 = phi_255_;
            if (_e78 < 8388608f) {
                phi_260_ = (_e90 - _e93);
                phi_261_ = false;
            } else {
                phi_260_ = f32();
                phi_261_ = true;
            }
            let _e96 = phi_260_;
            let _e98 = phi_261_;
            phi_262_ = _e96;
            phi_263_ = _e98;
        } else {
            phi_262_ = f32();
            phi_263_ = true;
        }
        let _e100 = phi_262_;
        let _e102 = phi_263_;
        if _e102 {
            phi_267_ = _e78;
        } else {
            phi_267_ = _e100;
        }
        let _e104 = phi_267_;
        let _e108 = ((_e76 - (_e104 * 0.69314575f)) - (_e104 * 0.0000014286068f));
        phi_305_ = ((((((((((((((((1f / 5040f) * _e108) + (1f / 720f)) * _e108) + (1f / 120f)) * _e108) + (1f / 24f)) * _e108) + (1f / 6f)) * _e108) + 0.5f) * _e108) + 1f) * _e108) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e104), i32(-2147483648), (_e104 < bitcast<f32>(3472883712u))), 2147483647i, (_e104 > bitcast<f32>(1325400063u))), (_e104 == _e104)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e144 = phi_305_;
    let _e145 = (param_6.x * _e144);
    if ((bitcast<u32>(_e145) & 2147483647u) > 2139095040u) {
        phi_323_ = _e145;
    } else {
        if (_e145 < 0f) {
            phi_322_ = 0f;
        } else {
            if (_e145 > 1f) {
                phi_321_ = 1f;
            } else {
                phi_321_ = _e145;
            }
            let _e152 = phi_321_;
            phi_322_ = _e152;
        }
        let _e154 = phi_322_;
        phi_323_ = _e154;
    }
    let _e156 = phi_323_;
    return _e156;
}

fn function_() {
    var local_1: f32;
    var phi_375_: bool;
    var phi_376_: bool;
    var phi_377_: bool;
    var phi_378_: bool;
    var phi_382_: bool;
    var phi_426_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_430_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_504_: bool;
    var phi_513_: bool;
    var phi_522_: bool;
    var phi_523_: bool;
    var phi_524_: bool;
    var phi_525_: bool;
    var phi_526_: bool;
    var phi_527_: bool;
    var phi_528_: bool;
    var phi_532_: bool;
    var phi_622_: f32;
    var phi_625_: f32;
    var phi_654_: f32;
    var phi_659_: f32;
    var phi_660_: bool;
    var phi_661_: f32;
    var phi_662_: bool;
    var phi_666_: f32;
    var phi_686_: f32;
    var phi_691_: f32;
    var phi_692_: bool;
    var phi_693_: f32;
    var phi_694_: bool;
    var phi_698_: f32;
    var phi_746_: i32;
    var phi_751_: i32;
    var phi_756_: i32;
    var phi_761_: i32;
    var phi_770_: i32;
    var phi_775_: i32;
    var phi_780_: i32;
    var phi_785_: i32;
    var phi_880_: bool;
    var phi_888_: bool;
    var phi_900_: bool;
    var phi_901_: bool;
    var phi_905_: f32;
    var phi_911_: f32;
    var phi_913_: evaluate_Verdict;
    var phi_918_: evaluate_Verdict;
    var phi_919_: evaluate_Verdict;
    var phi_923_: bool;
    var phi_924_: u32;
    var phi_935_: u32;

    let _e51 = id_1;
    let _e52 = local_2;
    let _e57 = arrayLength((&map.member));
    let _e62 = p.member.size[0u];
    let _e64 = p.member.size[1u];
    let _e65 = lt_shaders_entry_pixel_index(_e51, _e62, _e64);
    if (bitcast<i32>(_e65.root) != 0i) {
        let _e72 = p.member.projection;
        let _e73 = lt_math_OneLevel(_e72);
        let _e75 = p.member.light;
        let _e78 = samples.member[_e65.first_primitive].normal[0u];
        let _e80 = global[0u];
        if (_e78 == _e80) {
            let _e83 = samples.member[_e65.first_primitive].normal[1u];
            let _e85 = global[1u];
            if (_e83 == _e85) {
                let _e88 = samples.member[_e65.first_primitive].normal[2u];
                let _e90 = global[2u];
                phi_375_ = (_e88 == _e90);
                phi_376_ = false;
            } else {
                phi_375_ = bool();
                phi_376_ = true;
            }
            let _e93 = phi_375_;
            let _e95 = phi_376_;
            phi_377_ = _e93;
            phi_378_ = _e95;
        } else {
            phi_377_ = bool();
            phi_378_ = true;
        }
        let _e97 = phi_377_;
        let _e99 = phi_378_;
        if _e99 {
            phi_382_ = false;
        } else {
            phi_382_ = _e97;
        }
        let _e101 = phi_382_;
        if !(_e101) {
            let _e104 = samples.member[_e65.first_primitive].normal;
            let _e106 = samples.member[_e65.first_primitive].position;
            if ((((_e104.x * (_e75.x - (_e106.x * _e75.w))) + (_e104.y * (_e75.y - (_e106.y * _e75.w)))) + (_e104.z * (_e75.z - (_e106.z * _e75.w)))) > 0f) {
                let _e130 = samples.member[_e65.first_primitive].flags;
                let _e138 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e144 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e138.unnamed.visibility, false), _e138.unnamed_1);
                phi_426_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e144.unnamed, ((_e130 & 1u) == 0u));
            } else {
                let _e153 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e159 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e153.unnamed.visibility, false), _e153.unnamed_1);
                phi_426_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e159.unnamed, true);
            }
            let _e164 = phi_426_;
            phi_430_ = _e164;
        } else {
            let _e170 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e176 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e170.unnamed.visibility, false), _e170.unnamed_1);
            phi_430_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e176.unnamed, true);
        }
        let _e181 = phi_430_;
        if _e181.unnamed_1 {
            phi_919_ = evaluate_Verdict(_e181.unnamed.visibility, _e181.unnamed.is_doubted);
        } else {
            let _e189 = samples.member[_e65.first_primitive].position;
            let _e207 = ((((_e73.projection.row_w.x * _e189.x) + (_e73.projection.row_w.y * _e189.y)) + (_e73.projection.row_w.z * _e189.z)) + (_e73.projection.row_w.w * 1f));
            let _e221 = (((((_e73.projection.row_x.x * _e189.x) + (_e73.projection.row_x.y * _e189.y)) + (_e73.projection.row_x.z * _e189.z)) + (_e73.projection.row_x.w * 1f)) / _e207);
            let _e235 = (((((_e73.projection.row_y.x * _e189.x) + (_e73.projection.row_y.y * _e189.y)) + (_e73.projection.row_y.z * _e189.z)) + (_e73.projection.row_y.w * 1f)) / _e207);
            let _e248 = ((((_e73.projection.row_z.x * _e189.x) + (_e73.projection.row_z.y * _e189.y)) + (_e73.projection.row_z.z * _e189.z)) + (_e73.projection.row_z.w * 1f));
            if (_e207 > 0f) {
                if (_e221 >= 0f) {
                    phi_504_ = (_e221 <= 1f);
                } else {
                    phi_504_ = false;
                }
                let _e253 = phi_504_;
                if _e253 {
                    if (_e235 >= 0f) {
                        phi_513_ = (_e235 <= 1f);
                    } else {
                        phi_513_ = false;
                    }
                    let _e257 = phi_513_;
                    if _e257 {
                        if (_e248 >= 0f) {
                            phi_522_ = (_e248 <= 1f);
                        } else {
                            phi_522_ = false;
                        }
                        let _e261 = phi_522_;
                        phi_523_ = _e261;
                        phi_524_ = false;
                    } else {
                        phi_523_ = bool();
                        phi_524_ = true;
                    }
                    let _e263 = phi_523_;
                    let _e265 = phi_524_;
                    phi_525_ = _e263;
                    phi_526_ = _e265;
                } else {
                    phi_525_ = bool();
                    phi_526_ = true;
                }
                let _e267 = phi_525_;
                let _e269 = phi_526_;
                phi_527_ = _e267;
                phi_528_ = _e269;
            } else {
                phi_527_ = bool();
                phi_528_ = true;
            }
            let _e271 = phi_527_;
            let _e273 = phi_528_;
            if _e273 {
                phi_532_ = false;
            } else {
                phi_532_ = _e271;
            }
            let _e275 = phi_532_;
            if _e275 {
                if (0f > 0f) {
                    let _e278 = samples.member[_e65.first_primitive].normal;
                    let _e280 = p.member.map_size;
                    let _e350 = ((abs(((((_e72.row_x.x * _e278.x) + (_e72.row_x.y * _e278.y)) + (_e72.row_x.z * _e278.z)) / (((_e72.row_x.x * _e72.row_x.x) + (_e72.row_x.y * _e72.row_x.y)) + (_e72.row_x.z * _e72.row_x.z)))) + abs(((((_e72.row_y.x * _e278.x) + (_e72.row_y.y * _e278.y)) + (_e72.row_y.z * _e278.z)) / (((_e72.row_y.x * _e72.row_y.x) + (_e72.row_y.y * _e72.row_y.y)) + (_e72.row_y.z * _e72.row_y.z))))) / (abs(((((_e72.row_z.x * _e278.x) + (_e72.row_z.y * _e278.y)) + (_e72.row_z.z * _e278.z)) / (((_e72.row_z.x * _e72.row_z.x) + (_e72.row_z.y * _e72.row_z.y)) + (_e72.row_z.z * _e72.row_z.z)))) * f32(_e280)));
                    if (_e350 < 0.002f) {
                        phi_622_ = _e350;
                    } else {
                        phi_622_ = 0.002f;
                    }
                    let _e353 = phi_622_;
                    phi_625_ = (_e248 - (0f * _e353));
                } else {
                    phi_625_ = _e248;
                }
                let _e357 = phi_625_;
                let _e359 = p.member.map_size;
                let _e360 = f32(_e359);
                let _e363 = ((_e221 * _e360) - 0.5f);
                let _e364 = ((_e235 * _e360) - 0.5f);
                if (_e363 > -8388608f) {
                    let _e376 = f32(select(0i, select(select(i32(_e363), i32(-2147483648), (_e363 < bitcast<f32>(3472883712u))), 2147483647i, (_e363 > bitcast<f32>(1325400063u))), (_e363 == _e363)));
                    if (_e376 > _e363) {
                        phi_654_ = 1f;
                    } else {
                        phi_654_ = 0f;
                    }
                    let _e379 = phi_654_;
                    if (_e363 < 8388608f) {
                        phi_659_ = (_e376 - _e379);
                        phi_660_ = false;
                    } else {
                        phi_659_ = f32();
                        phi_660_ = true;
                    }
                    let _e382 = phi_659_;
                    let _e384 = phi_660_;
                    phi_661_ = _e382;
                    phi_662_ = _e384;
                } else {
                    phi_661_ = f32();
                    phi_662_ = true;
                }
                let _e386 = phi_661_;
                let _e388 = phi_662_;
                if _e388 {
                    phi_666_ = _e363;
                } else {
                    phi_666_ = _e386;
                }
                let _e390 = phi_666_;
                if (_e364 > -8388608f) {
                    let _e402 = f32(select(0i, select(select(i32(_e364), i32(-2147483648), (_e364 < bitcast<f32>(3472883712u))), 2147483647i, (_e364 > bitcast<f32>(1325400063u))), (_e364 == _e364)));
                    if (_e402 > _e364) {
                        phi_686_ = 1f;
                    } else {
                        phi_686_ = 0f;
                    }
                    let _e405 = phi_686_;
                    if (_e364 < 8388608f) {
                        phi_691_ = (_e402 - _e405);
                        phi_692_ = false;
                    } else {
                        phi_691_ = f32();
                        phi_692_ = true;
                    }
                    let _e408 = phi_691_;
                    let _e410 = phi_692_;
                    phi_693_ = _e408;
                    phi_694_ = _e410;
                } else {
                    phi_693_ = f32();
                    phi_694_ = true;
                }
                let _e412 = phi_693_;
                let _e414 = phi_694_;
                if _e414 {
                    phi_698_ = _e364;
                } else {
                    phi_698_ = _e412;
                }
                let _e416 = phi_698_;
                let _e417 = (_e363 - _e390);
                let _e418 = (_e364 - _e416);
                let _e427 = select(0i, select(select(i32(_e390), i32(-2147483648), (_e390 < bitcast<f32>(3472883712u))), 2147483647i, (_e390 > bitcast<f32>(1325400063u))), (_e390 == _e390));
                let _e436 = select(0i, select(select(i32(_e416), i32(-2147483648), (_e416 < bitcast<f32>(3472883712u))), 2147483647i, (_e416 > bitcast<f32>(1325400063u))), (_e416 == _e416));
                let _e439 = ((1f - _e417) * (1f - _e418));
                let _e441 = (_e417 * (1f - _e418));
                let _e443 = ((1f - _e417) * _e418);
                let _e444 = (_e417 * _e418);
                let _e446 = p.member.test;
                let _e447 = _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e446);
                let _e449 = p.member.map_size;
                local_1 = _e447;
                let _e451 = ((0u * _e449) * _e449);
                let _e453 = (bitcast<i32>(_e449) - 1i);
                if (_e427 > 0i) {
                    phi_746_ = _e427;
                } else {
                    phi_746_ = 0i;
                }
                let _e456 = phi_746_;
                if (_e436 > 0i) {
                    phi_751_ = _e436;
                } else {
                    phi_751_ = 0i;
                }
                let _e459 = phi_751_;
                if (_e456 < _e453) {
                    phi_756_ = _e456;
                } else {
                    phi_756_ = _e453;
                }
                let _e462 = phi_756_;
                if (_e459 < _e453) {
                    phi_761_ = _e459;
                } else {
                    phi_761_ = _e453;
                }
                let _e465 = phi_761_;
                let _e466 = bitcast<u32>(_e462);
                let _e468 = (_e427 + 1i);
                let _e469 = (_e436 + 1i);
                if (_e468 > 0i) {
                    phi_770_ = _e468;
                } else {
                    phi_770_ = 0i;
                }
                let _e472 = phi_770_;
                if (_e469 > 0i) {
                    phi_775_ = _e469;
                } else {
                    phi_775_ = 0i;
                }
                let _e475 = phi_775_;
                if (_e472 < _e453) {
                    phi_780_ = _e472;
                } else {
                    phi_780_ = _e453;
                }
                let _e478 = phi_780_;
                if (_e475 < _e453) {
                    phi_785_ = _e475;
                } else {
                    phi_785_ = _e453;
                }
                let _e481 = phi_785_;
                let _e482 = bitcast<u32>(_e478);
                let _e484 = (bitcast<u32>(_e465) * _e449);
                let _e485 = (bitcast<u32>(_e481) * _e449);
                let _e490 = ((_e484 + _e466) + _e451);
                let _e491 = ((_e484 + _e482) + _e451);
                let _e492 = ((_e485 + _e466) + _e451);
                let _e493 = ((_e485 + _e482) + _e451);
                if (_e490 < _e57) {
                } else {
                    return;
                }
                let _e497 = map.member[(0u + _e490)];
                if (_e491 < _e57) {
                } else {
                    return;
                }
                let _e509 = map.member[(0u + _e491)];
                if (_e492 < _e57) {
                } else {
                    return;
                }
                let _e525 = map.member[(0u + _e492)];
                if (_e493 < _e57) {
                } else {
                    return;
                }
                let _e541 = map.member[(0u + _e493)];
                let _e555 = _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_1), vec4<f32>(((((_e497.x * _e439) + (_e509.x * _e441)) + (_e525.x * _e443)) + (_e541.x * _e444)), ((((_e497.y * _e439) + (_e509.y * _e441)) + (_e525.y * _e443)) + (_e541.y * _e444)), ((((_e497.z * _e439) + (_e509.z * _e441)) + (_e525.z * _e443)) + (_e541.z * _e444)), ((((_e497.w * _e439) + (_e509.w * _e441)) + (_e525.w * _e443)) + (_e541.w * _e444))), _e357);
                let _e557 = p.member.epsilon;
                if (_e555 <= _e557) {
                    phi_880_ = true;
                } else {
                    phi_880_ = (_e555 >= (1f - _e557));
                }
                let _e562 = phi_880_;
                if ((bitcast<u32>(_e555) & 2147483647u) > 2139095040u) {
                    phi_888_ = true;
                } else {
                    phi_888_ = !(_e562);
                }
                let _e568 = phi_888_;
                if _e568 {
                    if (_e555 > 0f) {
                        if (_e555 < 1f) {
                            phi_900_ = false;
                        } else {
                            phi_900_ = true;
                        }
                        let _e572 = phi_900_;
                        phi_901_ = _e572;
                    } else {
                        phi_901_ = true;
                    }
                    let _e574 = phi_901_;
                    if _e574 {
                        phi_905_ = 0.5f;
                    } else {
                        phi_905_ = _e555;
                    }
                    let _e576 = phi_905_;
                    phi_913_ = evaluate_Verdict(_e576, true);
                } else {
                    if (_e555 > 0.5f) {
                        phi_911_ = 1f;
                    } else {
                        phi_911_ = 0f;
                    }
                    let _e580 = phi_911_;
                    phi_913_ = evaluate_Verdict(_e580, false);
                }
                let _e583 = phi_913_;
                phi_918_ = evaluate_Verdict(_e583.visibility, _e583.is_doubted);
            } else {
                phi_918_ = evaluate_Verdict(0.5f, true);
            }
            let _e589 = phi_918_;
            phi_919_ = _e589;
        }
        let _e591 = phi_919_;
        visibility.member[_e65.first_primitive] = _e591.visibility;
        phi_923_ = _e591.is_doubted;
        phi_924_ = _e65.first_primitive;
    } else {
        phi_923_ = false;
        phi_924_ = 0u;
    }
    let _e596 = phi_923_;
    let _e598 = phi_924_;
    if (_e52 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e596 {
        let _e602 = atomicAdd((&shared_[0u]), 1u);
        phi_935_ = _e602;
    } else {
        phi_935_ = 0u;
    }
    let _e604 = phi_935_;
    workgroupBarrier();
    if (_e52 == 0u) {
        let _e608 = atomicLoad((&shared_[0u]));
        let _e609 = atomicAdd((&list.member[3u]), _e608);
        atomicStore((&shared_[1u]), _e609);
    }
    workgroupBarrier();
    if _e596 {
        let _e612 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e612) + _e604)]), _e598);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_esm_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
