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

struct type_28 {
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
    pad0_: u32,
    pad1_: u32,
    pad2_: u32,
}

struct type_32 {
    member: abi_ShadowParams,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_32;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_13;
@group(0) @binding(2) 
var<storage> map: type_28;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_141_: lt_bvh_traverse_Tree;
    var phi_142_: bool;
    var phi_143_: lt_bvh_traverse_Tree;
    var phi_144_: bool;
    var phi_149_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_141_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_142_ = false;
        } else {
            phi_141_ = lt_bvh_traverse_Tree();
            phi_142_ = true;
        }
        let _e59 = phi_141_;
        let _e61 = phi_142_;
        phi_143_ = _e59;
        phi_144_ = _e61;
    } else {
        phi_143_ = lt_bvh_traverse_Tree();
        phi_144_ = true;
    }
    let _e63 = phi_143_;
    let _e65 = phi_144_;
    if _e65 {
        phi_149_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_149_ = _e63;
    }
    let _e70 = phi_149_;
    return lt_bvh_traverse_Tree(_e70.root, _e70.first_primitive);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_esm_Esm_clamped_exponent(param_4: ptr<function, f32>) -> f32 {
    var phi_169_: bool;
    var phi_173_: f32;

    let _e47 = (*param_4);
    if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
        phi_169_ = true;
    } else {
        let _e51 = (84f < _e47);
        if _e51 {
        }
        phi_169_ = _e51;
    }
    let _e53 = phi_169_;
    if _e53 {
        phi_173_ = 84f;
    } else {
        phi_173_ = _e47;
    }
    let _e55 = phi_173_;
    return _e55;
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_5: ptr<function, f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_762_: f32;
    var phi_763_: f32;
    var phi_764_: f32;
    var phi_779_: f32;
    var phi_784_: f32;
    var phi_806_: f32;
    var phi_811_: f32;
    var phi_812_: bool;
    var phi_813_: f32;
    var phi_814_: bool;
    var phi_818_: f32;
    var phi_856_: f32;
    var phi_872_: f32;
    var phi_873_: f32;
    var phi_874_: f32;

    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_764_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_763_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_762_ = 1f;
            } else {
                phi_762_ = param_7;
            }
            let _e55 = phi_762_;
            phi_763_ = _e55;
        }
        let _e57 = phi_763_;
        phi_764_ = _e57;
    }
    let _e59 = phi_764_;
    let _e61 = _lt_math_esm_Esm_clamped_exponent(param_5);
    let _e63 = (_e61 * (1f - _e59));
    if ((bitcast<u32>(_e63) & 2147483647u) > 2139095040u) {
        phi_856_ = _e63;
    } else {
        if (_e63 < -87f) {
            phi_779_ = -87f;
        } else {
            phi_779_ = _e63;
        }
        let _e69 = phi_779_;
        if (_e69 > 88f) {
            phi_784_ = 88f;
        } else {
            phi_784_ = _e69;
        }
        let _e72 = phi_784_;
        let _e74 = ((_e72 * 1.442695f) + 0.5f);
        if (_e74 > -8388608f) {
            let _e86 = f32(select(0i, select(select(i32(_e74), i32(-2147483648), (_e74 < bitcast<f32>(3472883712u))), 2147483647i, (_e74 > bitcast<f32>(1325400063u))), (_e74 == _e74)));
            if (_e86 > _e74) {
                phi_806_ = 1f;
            } else {
                phi_806_ = 0f;
            }
            let _e89 = phi_806_;
            if (_e74 < 8388608f) {
                phi_811_ = (_e86 - _e89);
                phi_812_ = false;
            } else {
                phi_811_ = f32();
                phi_812_ = true;
            }
            let _e92 = phi_811_;
            let _e94 = phi_812_;
            phi_813_ = _e92;
            phi_814_ = _e94;
        } else {
            phi_813_ = f32();
            phi_814_ = true;
        }
        let _e96 = phi_813_;
        let _e98 = phi_814_;
        if _e98 {
            phi_818_ = _e74;
        } else {
            phi_818_ = _e96;
        }
        let _e100 = phi_818_;
        let _e104 = ((_e72 - (_e100 * 0.69314575f)) - (_e100 * 0.0000014286068f));
        phi_856_ = ((((((((((((((((1f / 5040f) * _e104) + (1f / 720f)) * _e104) + (1f / 120f)) * _e104) + (1f / 24f)) * _e104) + (1f / 6f)) * _e104) + 0.5f) * _e104) + 1f) * _e104) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e100), i32(-2147483648), (_e100 < bitcast<f32>(3472883712u))), 2147483647i, (_e100 > bitcast<f32>(1325400063u))), (_e100 == _e100)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e140 = phi_856_;
    let _e141 = (param_6.x * _e140);
    if ((bitcast<u32>(_e141) & 2147483647u) > 2139095040u) {
        phi_874_ = _e141;
    } else {
        if (_e141 < 0f) {
            phi_873_ = 0f;
        } else {
            if (_e141 > 1f) {
                phi_872_ = 1f;
            } else {
                phi_872_ = _e141;
            }
            let _e148 = phi_872_;
            phi_873_ = _e148;
        }
        let _e150 = phi_873_;
        phi_874_ = _e150;
    }
    let _e152 = phi_874_;
    return _e152;
}

fn function_() {
    var local: f32;
    var phi_227_: bool;
    var phi_228_: bool;
    var phi_229_: bool;
    var phi_230_: bool;
    var phi_234_: bool;
    var phi_278_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_282_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_359_: bool;
    var phi_368_: bool;
    var phi_377_: bool;
    var phi_378_: bool;
    var phi_379_: bool;
    var phi_380_: bool;
    var phi_381_: bool;
    var phi_382_: bool;
    var phi_383_: bool;
    var phi_387_: bool;
    var phi_481_: f32;
    var phi_484_: f32;
    var phi_513_: f32;
    var phi_518_: f32;
    var phi_519_: bool;
    var phi_520_: f32;
    var phi_521_: bool;
    var phi_525_: f32;
    var phi_545_: f32;
    var phi_550_: f32;
    var phi_551_: bool;
    var phi_552_: f32;
    var phi_553_: bool;
    var phi_557_: f32;
    var phi_603_: i32;
    var phi_608_: i32;
    var phi_613_: i32;
    var phi_618_: i32;
    var phi_627_: i32;
    var phi_632_: i32;
    var phi_637_: i32;
    var phi_642_: i32;
    var phi_727_: evaluate_Verdict;
    var phi_728_: evaluate_Verdict;
    var phi_729_: bool;
    var phi_730_: evaluate_Verdict;
    var phi_731_: evaluate_Verdict;
    var phi_732_: bool;
    var phi_736_: evaluate_Verdict;

    let _e47 = id_1;
    let _e54 = arrayLength((&map.member));
    let _e60 = p.member.size[0u];
    let _e62 = p.member.size[1u];
    let _e63 = lt_shaders_entry_pixel_index(_e47, _e60, _e62);
    if (bitcast<i32>(_e63.root) != 0i) {
        if (_e63.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e72 = p.member.light;
        let _e75 = samples.member[(0u + _e63.first_primitive)].normal[0u];
        let _e77 = global[0u];
        if (_e75 == _e77) {
            let _e80 = samples.member[(0u + _e63.first_primitive)].normal[1u];
            let _e82 = global[1u];
            if (_e80 == _e82) {
                let _e85 = samples.member[(0u + _e63.first_primitive)].normal[2u];
                let _e87 = global[2u];
                phi_227_ = (_e85 == _e87);
                phi_228_ = false;
            } else {
                phi_227_ = bool();
                phi_228_ = true;
            }
            let _e90 = phi_227_;
            let _e92 = phi_228_;
            phi_229_ = _e90;
            phi_230_ = _e92;
        } else {
            phi_229_ = bool();
            phi_230_ = true;
        }
        let _e94 = phi_229_;
        let _e96 = phi_230_;
        if _e96 {
            phi_234_ = false;
        } else {
            phi_234_ = _e94;
        }
        let _e98 = phi_234_;
        if !(_e98) {
            let _e101 = samples.member[(0u + _e63.first_primitive)].normal;
            let _e103 = samples.member[(0u + _e63.first_primitive)].position;
            if ((((_e101.x * (_e72.x - (_e103.x * _e72.w))) + (_e101.y * (_e72.y - (_e103.y * _e72.w)))) + (_e101.z * (_e72.z - (_e103.z * _e72.w)))) > 0f) {
                let _e127 = samples.member[(0u + _e63.first_primitive)].flags;
                let _e135 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e141 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e135.unnamed.visibility, false), _e135.unnamed_1);
                phi_278_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e141.unnamed, ((_e127 & 1u) == 0u));
            } else {
                let _e150 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e156 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e150.unnamed.visibility, false), _e150.unnamed_1);
                phi_278_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e156.unnamed, true);
            }
            let _e161 = phi_278_;
            phi_282_ = _e161;
        } else {
            let _e167 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e173 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e167.unnamed.visibility, false), _e167.unnamed_1);
            phi_282_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e173.unnamed, true);
        }
        let _e178 = phi_282_;
        if _e178.unnamed_1 {
            phi_730_ = evaluate_Verdict(_e178.unnamed.visibility, _e178.unnamed.is_doubted);
            phi_731_ = evaluate_Verdict();
            phi_732_ = true;
        } else {
            let _e186 = samples.member[(0u + _e63.first_primitive)].position;
            let _e192 = p.member.projection.row_w;
            let _e203 = ((((_e192.x * _e186.x) + (_e192.y * _e186.y)) + (_e192.z * _e186.z)) + (_e192.w * 1f));
            let _e205 = p.member.projection.row_x;
            let _e217 = (((((_e205.x * _e186.x) + (_e205.y * _e186.y)) + (_e205.z * _e186.z)) + (_e205.w * 1f)) / _e203);
            let _e219 = p.member.projection.row_y;
            let _e231 = (((((_e219.x * _e186.x) + (_e219.y * _e186.y)) + (_e219.z * _e186.z)) + (_e219.w * 1f)) / _e203);
            let _e233 = p.member.projection.row_z;
            let _e244 = ((((_e233.x * _e186.x) + (_e233.y * _e186.y)) + (_e233.z * _e186.z)) + (_e233.w * 1f));
            if (_e203 > 0f) {
                if (_e217 >= 0f) {
                    phi_359_ = (_e217 <= 1f);
                } else {
                    phi_359_ = false;
                }
                let _e249 = phi_359_;
                if _e249 {
                    if (_e231 >= 0f) {
                        phi_368_ = (_e231 <= 1f);
                    } else {
                        phi_368_ = false;
                    }
                    let _e253 = phi_368_;
                    if _e253 {
                        if (_e244 >= 0f) {
                            phi_377_ = (_e244 <= 1f);
                        } else {
                            phi_377_ = false;
                        }
                        let _e257 = phi_377_;
                        phi_378_ = _e257;
                        phi_379_ = false;
                    } else {
                        phi_378_ = bool();
                        phi_379_ = true;
                    }
                    let _e259 = phi_378_;
                    let _e261 = phi_379_;
                    phi_380_ = _e259;
                    phi_381_ = _e261;
                } else {
                    phi_380_ = bool();
                    phi_381_ = true;
                }
                let _e263 = phi_380_;
                let _e265 = phi_381_;
                phi_382_ = _e263;
                phi_383_ = _e265;
            } else {
                phi_382_ = bool();
                phi_383_ = true;
            }
            let _e267 = phi_382_;
            let _e269 = phi_383_;
            if _e269 {
                phi_387_ = false;
            } else {
                phi_387_ = _e267;
            }
            let _e271 = phi_387_;
            if _e271 {
                if (0f > 0f) {
                    let _e274 = samples.member[(0u + _e63.first_primitive)].normal;
                    let _e276 = p.member.map_size;
                    let _e279 = p.member.projection.row_x;
                    let _e301 = p.member.projection.row_y;
                    let _e323 = p.member.projection.row_z;
                    let _e350 = ((abs(((((_e279.x * _e274.x) + (_e279.y * _e274.y)) + (_e279.z * _e274.z)) / (((_e279.x * _e279.x) + (_e279.y * _e279.y)) + (_e279.z * _e279.z)))) + abs(((((_e301.x * _e274.x) + (_e301.y * _e274.y)) + (_e301.z * _e274.z)) / (((_e301.x * _e301.x) + (_e301.y * _e301.y)) + (_e301.z * _e301.z))))) / (abs(((((_e323.x * _e274.x) + (_e323.y * _e274.y)) + (_e323.z * _e274.z)) / (((_e323.x * _e323.x) + (_e323.y * _e323.y)) + (_e323.z * _e323.z)))) * f32(_e276)));
                    if (_e350 < 0.002f) {
                        phi_481_ = _e350;
                    } else {
                        phi_481_ = 0.002f;
                    }
                    let _e353 = phi_481_;
                    phi_484_ = (_e244 - (0f * _e353));
                } else {
                    phi_484_ = _e244;
                }
                let _e357 = phi_484_;
                let _e359 = p.member.map_size;
                let _e360 = f32(_e359);
                let _e363 = ((_e217 * _e360) - 0.5f);
                let _e364 = ((_e231 * _e360) - 0.5f);
                if (_e363 > -8388608f) {
                    let _e376 = f32(select(0i, select(select(i32(_e363), i32(-2147483648), (_e363 < bitcast<f32>(3472883712u))), 2147483647i, (_e363 > bitcast<f32>(1325400063u))), (_e363 == _e363)));
                    if (_e376 > _e363) {
                        phi_513_ = 1f;
                    } else {
                        phi_513_ = 0f;
                    }
                    let _e379 = phi_513_;
                    if (_e363 < 8388608f) {
                        phi_518_ = (_e376 - _e379);
                        phi_519_ = false;
                    } else {
                        phi_518_ = f32();
                        phi_519_ = true;
                    }
                    let _e382 = phi_518_;
                    let _e384 = phi_519_;
                    phi_520_ = _e382;
                    phi_521_ = _e384;
                } else {
                    phi_520_ = f32();
                    phi_521_ = true;
                }
                let _e386 = phi_520_;
                let _e388 = phi_521_;
                if _e388 {
                    phi_525_ = _e363;
                } else {
                    phi_525_ = _e386;
                }
                let _e390 = phi_525_;
                if (_e364 > -8388608f) {
                    let _e402 = f32(select(0i, select(select(i32(_e364), i32(-2147483648), (_e364 < bitcast<f32>(3472883712u))), 2147483647i, (_e364 > bitcast<f32>(1325400063u))), (_e364 == _e364)));
                    if (_e402 > _e364) {
                        phi_545_ = 1f;
                    } else {
                        phi_545_ = 0f;
                    }
                    let _e405 = phi_545_;
                    if (_e364 < 8388608f) {
                        phi_550_ = (_e402 - _e405);
                        phi_551_ = false;
                    } else {
                        phi_550_ = f32();
                        phi_551_ = true;
                    }
                    let _e408 = phi_550_;
                    let _e410 = phi_551_;
                    phi_552_ = _e408;
                    phi_553_ = _e410;
                } else {
                    phi_552_ = f32();
                    phi_553_ = true;
                }
                let _e412 = phi_552_;
                let _e414 = phi_553_;
                if _e414 {
                    phi_557_ = _e364;
                } else {
                    phi_557_ = _e412;
                }
                let _e416 = phi_557_;
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
                local = _e447;
                let _e451 = (bitcast<i32>(_e449) - 1i);
                if (_e427 > 0i) {
                    phi_603_ = _e427;
                } else {
                    phi_603_ = 0i;
                }
                let _e454 = phi_603_;
                if (_e436 > 0i) {
                    phi_608_ = _e436;
                } else {
                    phi_608_ = 0i;
                }
                let _e457 = phi_608_;
                if (_e454 < _e451) {
                    phi_613_ = _e454;
                } else {
                    phi_613_ = _e451;
                }
                let _e460 = phi_613_;
                if (_e457 < _e451) {
                    phi_618_ = _e457;
                } else {
                    phi_618_ = _e451;
                }
                let _e463 = phi_618_;
                let _e464 = bitcast<u32>(_e460);
                let _e466 = (_e427 + 1i);
                let _e467 = (_e436 + 1i);
                if (_e466 > 0i) {
                    phi_627_ = _e466;
                } else {
                    phi_627_ = 0i;
                }
                let _e470 = phi_627_;
                if (_e467 > 0i) {
                    phi_632_ = _e467;
                } else {
                    phi_632_ = 0i;
                }
                let _e473 = phi_632_;
                if (_e470 < _e451) {
                    phi_637_ = _e470;
                } else {
                    phi_637_ = _e451;
                }
                let _e476 = phi_637_;
                if (_e473 < _e451) {
                    phi_642_ = _e473;
                } else {
                    phi_642_ = _e451;
                }
                let _e479 = phi_642_;
                let _e480 = bitcast<u32>(_e476);
                let _e482 = (bitcast<u32>(_e463) * _e449);
                let _e483 = (bitcast<u32>(_e479) * _e449);
                let _e484 = (_e482 + _e464);
                let _e485 = (_e482 + _e480);
                let _e486 = (_e483 + _e464);
                let _e487 = (_e483 + _e480);
                if (_e484 < _e54) {
                } else {
                    return;
                }
                let _e491 = map.member[(0u + _e484)];
                if (_e485 < _e54) {
                } else {
                    return;
                }
                let _e503 = map.member[(0u + _e485)];
                if (_e486 < _e54) {
                } else {
                    return;
                }
                let _e519 = map.member[(0u + _e486)];
                if (_e487 < _e54) {
                } else {
                    return;
                }
                let _e535 = map.member[(0u + _e487)];
                let _e549 = _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local), vec4<f32>(((((_e491.x * _e439) + (_e503.x * _e441)) + (_e519.x * _e443)) + (_e535.x * _e444)), ((((_e491.y * _e439) + (_e503.y * _e441)) + (_e519.y * _e443)) + (_e535.y * _e444)), ((((_e491.z * _e439) + (_e503.z * _e441)) + (_e519.z * _e443)) + (_e535.z * _e444)), ((((_e491.w * _e439) + (_e503.w * _e441)) + (_e519.w * _e443)) + (_e535.w * _e444))), _e357);
                phi_727_ = evaluate_Verdict(_e549, false);
                phi_728_ = evaluate_Verdict();
                phi_729_ = false;
            } else {
                phi_727_ = evaluate_Verdict();
                phi_728_ = evaluate_Verdict(1f, false);
                phi_729_ = true;
            }
            let _e553 = phi_727_;
            let _e555 = phi_728_;
            let _e557 = phi_729_;
            phi_730_ = _e555;
            phi_731_ = _e553;
            phi_732_ = _e557;
        }
        let _e559 = phi_730_;
        let _e561 = phi_731_;
        let _e563 = phi_732_;
        if _e563 {
            phi_736_ = _e559;
        } else {
            phi_736_ = _e561;
        }
        let _e565 = phi_736_;
        if (_e63.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e63.first_primitive)] = _e565.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_esm_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
