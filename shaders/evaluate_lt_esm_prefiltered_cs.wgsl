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

struct type_29 {
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

struct type_33 {
    member: abi_ShadowParams,
}

struct lt_math_OneLevel {
    projection: lt_math_LightProjection,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_33;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_13;
@group(0) @binding(2) 
var<storage> map: type_29;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_144_: lt_bvh_traverse_Tree;
    var phi_145_: bool;
    var phi_146_: lt_bvh_traverse_Tree;
    var phi_147_: bool;
    var phi_152_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_144_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_145_ = false;
        } else {
            phi_144_ = lt_bvh_traverse_Tree();
            phi_145_ = true;
        }
        let _e59 = phi_144_;
        let _e61 = phi_145_;
        phi_146_ = _e59;
        phi_147_ = _e61;
    } else {
        phi_146_ = lt_bvh_traverse_Tree();
        phi_147_ = true;
    }
    let _e63 = phi_146_;
    let _e65 = phi_147_;
    if _e65 {
        phi_152_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_152_ = _e63;
    }
    let _e70 = phi_152_;
    return lt_bvh_traverse_Tree(_e70.root, _e70.first_primitive);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_esm_Esm_clamped_exponent(param_4: ptr<function, f32>) -> f32 {
    var phi_172_: bool;
    var phi_176_: f32;

    let _e47 = (*param_4);
    if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
        phi_172_ = true;
    } else {
        let _e51 = (84f < _e47);
        if _e51 {
        }
        phi_172_ = _e51;
    }
    let _e53 = phi_172_;
    if _e53 {
        phi_176_ = 84f;
    } else {
        phi_176_ = _e47;
    }
    let _e55 = phi_176_;
    return _e55;
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_5: ptr<function, f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_195_: f32;
    var phi_196_: f32;
    var phi_197_: f32;
    var phi_212_: f32;
    var phi_217_: f32;
    var phi_239_: f32;
    var phi_244_: f32;
    var phi_245_: bool;
    var phi_246_: f32;
    var phi_247_: bool;
    var phi_251_: f32;
    var phi_289_: f32;
    var phi_305_: f32;
    var phi_306_: f32;
    var phi_307_: f32;

    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_197_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_196_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_195_ = 1f;
            } else {
                phi_195_ = param_7;
            }
            let _e55 = phi_195_;
            phi_196_ = _e55;
        }
        let _e57 = phi_196_;
        phi_197_ = _e57;
    }
    let _e59 = phi_197_;
    let _e61 = _lt_math_esm_Esm_clamped_exponent(param_5);
    let _e63 = (_e61 * (1f - _e59));
    if ((bitcast<u32>(_e63) & 2147483647u) > 2139095040u) {
        phi_289_ = _e63;
    } else {
        if (_e63 < -87f) {
            phi_212_ = -87f;
        } else {
            phi_212_ = _e63;
        }
        let _e69 = phi_212_;
        if (_e69 > 88f) {
            phi_217_ = 88f;
        } else {
            phi_217_ = _e69;
        }
        let _e72 = phi_217_;
        let _e74 = ((_e72 * 1.442695f) + 0.5f);
        if (_e74 > -8388608f) {
            let _e86 = f32(select(0i, select(select(i32(_e74), i32(-2147483648), (_e74 < bitcast<f32>(3472883712u))), 2147483647i, (_e74 > bitcast<f32>(1325400063u))), (_e74 == _e74)));
            if (_e86 > _e74) {
                phi_239_ = 1f;
            } else {
                phi_239_ = 0f;
            }
            let _e89 = phi_239_;
            if (_e74 < 8388608f) {
                phi_244_ = (_e86 - _e89);
                phi_245_ = false;
            } else {
                phi_244_ = f32();
                phi_245_ = true;
            }
            let _e92 = phi_244_;
            let _e94 = phi_245_;
            phi_246_ = _e92;
            phi_247_ = _e94;
        } else {
            phi_246_ = f32();
            phi_247_ = true;
        }
        let _e96 = phi_246_;
        let _e98 = phi_247_;
        if _e98 {
            phi_251_ = _e74;
        } else {
            phi_251_ = _e96;
        }
        let _e100 = phi_251_;
        let _e104 = ((_e72 - (_e100 * 0.69314575f)) - (_e100 * 0.0000014286068f));
        phi_289_ = ((((((((((((((((1f / 5040f) * _e104) + (1f / 720f)) * _e104) + (1f / 120f)) * _e104) + (1f / 24f)) * _e104) + (1f / 6f)) * _e104) + 0.5f) * _e104) + 1f) * _e104) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e100), i32(-2147483648), (_e100 < bitcast<f32>(3472883712u))), 2147483647i, (_e100 > bitcast<f32>(1325400063u))), (_e100 == _e100)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e140 = phi_289_;
    let _e141 = (param_6.x * _e140);
    if ((bitcast<u32>(_e141) & 2147483647u) > 2139095040u) {
        phi_307_ = _e141;
    } else {
        if (_e141 < 0f) {
            phi_306_ = 0f;
        } else {
            if (_e141 > 1f) {
                phi_305_ = 1f;
            } else {
                phi_305_ = _e141;
            }
            let _e148 = phi_305_;
            phi_306_ = _e148;
        }
        let _e150 = phi_306_;
        phi_307_ = _e150;
    }
    let _e152 = phi_307_;
    return _e152;
}

fn function_() {
    var local: f32;
    var phi_364_: bool;
    var phi_365_: bool;
    var phi_366_: bool;
    var phi_367_: bool;
    var phi_371_: bool;
    var phi_415_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_419_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_493_: bool;
    var phi_502_: bool;
    var phi_511_: bool;
    var phi_512_: bool;
    var phi_513_: bool;
    var phi_514_: bool;
    var phi_515_: bool;
    var phi_516_: bool;
    var phi_517_: bool;
    var phi_521_: bool;
    var phi_611_: f32;
    var phi_614_: f32;
    var phi_643_: f32;
    var phi_648_: f32;
    var phi_649_: bool;
    var phi_650_: f32;
    var phi_651_: bool;
    var phi_655_: f32;
    var phi_675_: f32;
    var phi_680_: f32;
    var phi_681_: bool;
    var phi_682_: f32;
    var phi_683_: bool;
    var phi_687_: f32;
    var phi_735_: i32;
    var phi_740_: i32;
    var phi_745_: i32;
    var phi_750_: i32;
    var phi_759_: i32;
    var phi_764_: i32;
    var phi_769_: i32;
    var phi_774_: i32;
    var phi_869_: bool;
    var phi_877_: bool;
    var phi_889_: bool;
    var phi_890_: bool;
    var phi_894_: f32;
    var phi_900_: f32;
    var phi_902_: evaluate_Verdict;
    var phi_907_: evaluate_Verdict;
    var phi_908_: evaluate_Verdict;

    let _e47 = id_1;
    let _e54 = arrayLength((&map.member));
    let _e60 = p.member.size[0u];
    let _e62 = p.member.size[1u];
    let _e63 = lt_shaders_entry_pixel_index(_e47, _e60, _e62);
    if (bitcast<i32>(_e63.root) != 0i) {
        let _e69 = p.member.projection;
        if (_e63.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e73 = lt_math_OneLevel(_e69);
        let _e75 = p.member.light;
        let _e78 = samples.member[(0u + _e63.first_primitive)].normal[0u];
        let _e80 = global[0u];
        if (_e78 == _e80) {
            let _e83 = samples.member[(0u + _e63.first_primitive)].normal[1u];
            let _e85 = global[1u];
            if (_e83 == _e85) {
                let _e88 = samples.member[(0u + _e63.first_primitive)].normal[2u];
                let _e90 = global[2u];
                phi_364_ = (_e88 == _e90);
                phi_365_ = false;
            } else {
                phi_364_ = bool();
                phi_365_ = true;
            }
            let _e93 = phi_364_;
            let _e95 = phi_365_;
            phi_366_ = _e93;
            phi_367_ = _e95;
        } else {
            phi_366_ = bool();
            phi_367_ = true;
        }
        let _e97 = phi_366_;
        let _e99 = phi_367_;
        if _e99 {
            phi_371_ = false;
        } else {
            phi_371_ = _e97;
        }
        let _e101 = phi_371_;
        if !(_e101) {
            let _e104 = samples.member[(0u + _e63.first_primitive)].normal;
            let _e106 = samples.member[(0u + _e63.first_primitive)].position;
            if ((((_e104.x * (_e75.x - (_e106.x * _e75.w))) + (_e104.y * (_e75.y - (_e106.y * _e75.w)))) + (_e104.z * (_e75.z - (_e106.z * _e75.w)))) > 0f) {
                let _e130 = samples.member[(0u + _e63.first_primitive)].flags;
                let _e138 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e144 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e138.unnamed.visibility, false), _e138.unnamed_1);
                phi_415_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e144.unnamed, ((_e130 & 1u) == 0u));
            } else {
                let _e153 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e159 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e153.unnamed.visibility, false), _e153.unnamed_1);
                phi_415_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e159.unnamed, true);
            }
            let _e164 = phi_415_;
            phi_419_ = _e164;
        } else {
            let _e170 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e176 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e170.unnamed.visibility, false), _e170.unnamed_1);
            phi_419_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e176.unnamed, true);
        }
        let _e181 = phi_419_;
        if _e181.unnamed_1 {
            phi_908_ = evaluate_Verdict(_e181.unnamed.visibility, _e181.unnamed.is_doubted);
        } else {
            let _e189 = samples.member[(0u + _e63.first_primitive)].position;
            let _e207 = ((((_e73.projection.row_w.x * _e189.x) + (_e73.projection.row_w.y * _e189.y)) + (_e73.projection.row_w.z * _e189.z)) + (_e73.projection.row_w.w * 1f));
            let _e221 = (((((_e73.projection.row_x.x * _e189.x) + (_e73.projection.row_x.y * _e189.y)) + (_e73.projection.row_x.z * _e189.z)) + (_e73.projection.row_x.w * 1f)) / _e207);
            let _e235 = (((((_e73.projection.row_y.x * _e189.x) + (_e73.projection.row_y.y * _e189.y)) + (_e73.projection.row_y.z * _e189.z)) + (_e73.projection.row_y.w * 1f)) / _e207);
            let _e248 = ((((_e73.projection.row_z.x * _e189.x) + (_e73.projection.row_z.y * _e189.y)) + (_e73.projection.row_z.z * _e189.z)) + (_e73.projection.row_z.w * 1f));
            if (_e207 > 0f) {
                if (_e221 >= 0f) {
                    phi_493_ = (_e221 <= 1f);
                } else {
                    phi_493_ = false;
                }
                let _e253 = phi_493_;
                if _e253 {
                    if (_e235 >= 0f) {
                        phi_502_ = (_e235 <= 1f);
                    } else {
                        phi_502_ = false;
                    }
                    let _e257 = phi_502_;
                    if _e257 {
                        if (_e248 >= 0f) {
                            phi_511_ = (_e248 <= 1f);
                        } else {
                            phi_511_ = false;
                        }
                        let _e261 = phi_511_;
                        phi_512_ = _e261;
                        phi_513_ = false;
                    } else {
                        phi_512_ = bool();
                        phi_513_ = true;
                    }
                    let _e263 = phi_512_;
                    let _e265 = phi_513_;
                    phi_514_ = _e263;
                    phi_515_ = _e265;
                } else {
                    phi_514_ = bool();
                    phi_515_ = true;
                }
                let _e267 = phi_514_;
                let _e269 = phi_515_;
                phi_516_ = _e267;
                phi_517_ = _e269;
            } else {
                phi_516_ = bool();
                phi_517_ = true;
            }
            let _e271 = phi_516_;
            let _e273 = phi_517_;
            if _e273 {
                phi_521_ = false;
            } else {
                phi_521_ = _e271;
            }
            let _e275 = phi_521_;
            if _e275 {
                if (0f > 0f) {
                    let _e278 = samples.member[(0u + _e63.first_primitive)].normal;
                    let _e280 = p.member.map_size;
                    let _e350 = ((abs(((((_e69.row_x.x * _e278.x) + (_e69.row_x.y * _e278.y)) + (_e69.row_x.z * _e278.z)) / (((_e69.row_x.x * _e69.row_x.x) + (_e69.row_x.y * _e69.row_x.y)) + (_e69.row_x.z * _e69.row_x.z)))) + abs(((((_e69.row_y.x * _e278.x) + (_e69.row_y.y * _e278.y)) + (_e69.row_y.z * _e278.z)) / (((_e69.row_y.x * _e69.row_y.x) + (_e69.row_y.y * _e69.row_y.y)) + (_e69.row_y.z * _e69.row_y.z))))) / (abs(((((_e69.row_z.x * _e278.x) + (_e69.row_z.y * _e278.y)) + (_e69.row_z.z * _e278.z)) / (((_e69.row_z.x * _e69.row_z.x) + (_e69.row_z.y * _e69.row_z.y)) + (_e69.row_z.z * _e69.row_z.z)))) * f32(_e280)));
                    if (_e350 < 0.002f) {
                        phi_611_ = _e350;
                    } else {
                        phi_611_ = 0.002f;
                    }
                    let _e353 = phi_611_;
                    phi_614_ = (_e248 - (0f * _e353));
                } else {
                    phi_614_ = _e248;
                }
                let _e357 = phi_614_;
                let _e359 = p.member.map_size;
                let _e360 = f32(_e359);
                let _e363 = ((_e221 * _e360) - 0.5f);
                let _e364 = ((_e235 * _e360) - 0.5f);
                if (_e363 > -8388608f) {
                    let _e376 = f32(select(0i, select(select(i32(_e363), i32(-2147483648), (_e363 < bitcast<f32>(3472883712u))), 2147483647i, (_e363 > bitcast<f32>(1325400063u))), (_e363 == _e363)));
                    if (_e376 > _e363) {
                        phi_643_ = 1f;
                    } else {
                        phi_643_ = 0f;
                    }
                    let _e379 = phi_643_;
                    if (_e363 < 8388608f) {
                        phi_648_ = (_e376 - _e379);
                        phi_649_ = false;
                    } else {
                        phi_648_ = f32();
                        phi_649_ = true;
                    }
                    let _e382 = phi_648_;
                    let _e384 = phi_649_;
                    phi_650_ = _e382;
                    phi_651_ = _e384;
                } else {
                    phi_650_ = f32();
                    phi_651_ = true;
                }
                let _e386 = phi_650_;
                let _e388 = phi_651_;
                if _e388 {
                    phi_655_ = _e363;
                } else {
                    phi_655_ = _e386;
                }
                let _e390 = phi_655_;
                if (_e364 > -8388608f) {
                    let _e402 = f32(select(0i, select(select(i32(_e364), i32(-2147483648), (_e364 < bitcast<f32>(3472883712u))), 2147483647i, (_e364 > bitcast<f32>(1325400063u))), (_e364 == _e364)));
                    if (_e402 > _e364) {
                        phi_675_ = 1f;
                    } else {
                        phi_675_ = 0f;
                    }
                    let _e405 = phi_675_;
                    if (_e364 < 8388608f) {
                        phi_680_ = (_e402 - _e405);
                        phi_681_ = false;
                    } else {
                        phi_680_ = f32();
                        phi_681_ = true;
                    }
                    let _e408 = phi_680_;
                    let _e410 = phi_681_;
                    phi_682_ = _e408;
                    phi_683_ = _e410;
                } else {
                    phi_682_ = f32();
                    phi_683_ = true;
                }
                let _e412 = phi_682_;
                let _e414 = phi_683_;
                if _e414 {
                    phi_687_ = _e364;
                } else {
                    phi_687_ = _e412;
                }
                let _e416 = phi_687_;
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
                let _e451 = ((0u * _e449) * _e449);
                let _e453 = (bitcast<i32>(_e449) - 1i);
                if (_e427 > 0i) {
                    phi_735_ = _e427;
                } else {
                    phi_735_ = 0i;
                }
                let _e456 = phi_735_;
                if (_e436 > 0i) {
                    phi_740_ = _e436;
                } else {
                    phi_740_ = 0i;
                }
                let _e459 = phi_740_;
                if (_e456 < _e453) {
                    phi_745_ = _e456;
                } else {
                    phi_745_ = _e453;
                }
                let _e462 = phi_745_;
                if (_e459 < _e453) {
                    phi_750_ = _e459;
                } else {
                    phi_750_ = _e453;
                }
                let _e465 = phi_750_;
                let _e466 = bitcast<u32>(_e462);
                let _e468 = (_e427 + 1i);
                let _e469 = (_e436 + 1i);
                if (_e468 > 0i) {
                    phi_759_ = _e468;
                } else {
                    phi_759_ = 0i;
                }
                let _e472 = phi_759_;
                if (_e469 > 0i) {
                    phi_764_ = _e469;
                } else {
                    phi_764_ = 0i;
                }
                let _e475 = phi_764_;
                if (_e472 < _e453) {
                    phi_769_ = _e472;
                } else {
                    phi_769_ = _e453;
                }
                let _e478 = phi_769_;
                if (_e475 < _e453) {
                    phi_774_ = _e475;
                } else {
                    phi_774_ = _e453;
                }
                let _e481 = phi_774_;
                let _e482 = bitcast<u32>(_e478);
                let _e484 = (bitcast<u32>(_e465) * _e449);
                let _e485 = (bitcast<u32>(_e481) * _e449);
                let _e490 = ((_e484 + _e466) + _e451);
                let _e491 = ((_e484 + _e482) + _e451);
                let _e492 = ((_e485 + _e466) + _e451);
                let _e493 = ((_e485 + _e482) + _e451);
                if (_e490 < _e54) {
                } else {
                    return;
                }
                let _e497 = map.member[(0u + _e490)];
                if (_e491 < _e54) {
                } else {
                    return;
                }
                let _e509 = map.member[(0u + _e491)];
                if (_e492 < _e54) {
                } else {
                    return;
                }
                let _e525 = map.member[(0u + _e492)];
                if (_e493 < _e54) {
                } else {
                    return;
                }
                let _e541 = map.member[(0u + _e493)];
                let _e555 = _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local), vec4<f32>(((((_e497.x * _e439) + (_e509.x * _e441)) + (_e525.x * _e443)) + (_e541.x * _e444)), ((((_e497.y * _e439) + (_e509.y * _e441)) + (_e525.y * _e443)) + (_e541.y * _e444)), ((((_e497.z * _e439) + (_e509.z * _e441)) + (_e525.z * _e443)) + (_e541.z * _e444)), ((((_e497.w * _e439) + (_e509.w * _e441)) + (_e525.w * _e443)) + (_e541.w * _e444))), _e357);
                let _e557 = p.member.epsilon;
                if (_e555 <= _e557) {
                    phi_869_ = true;
                } else {
                    phi_869_ = (_e555 >= (1f - _e557));
                }
                let _e562 = phi_869_;
                if ((bitcast<u32>(_e555) & 2147483647u) > 2139095040u) {
                    phi_877_ = true;
                } else {
                    phi_877_ = !(_e562);
                }
                let _e568 = phi_877_;
                if _e568 {
                    if (_e555 > 0f) {
                        if (_e555 < 1f) {
                            phi_889_ = false;
                        } else {
                            phi_889_ = true;
                        }
                        let _e572 = phi_889_;
                        phi_890_ = _e572;
                    } else {
                        phi_890_ = true;
                    }
                    let _e574 = phi_890_;
                    if _e574 {
                        phi_894_ = 0.5f;
                    } else {
                        phi_894_ = _e555;
                    }
                    let _e576 = phi_894_;
                    phi_902_ = evaluate_Verdict(_e576, true);
                } else {
                    if (_e555 > 0.5f) {
                        phi_900_ = 1f;
                    } else {
                        phi_900_ = 0f;
                    }
                    let _e580 = phi_900_;
                    phi_902_ = evaluate_Verdict(_e580, false);
                }
                let _e583 = phi_902_;
                phi_907_ = evaluate_Verdict(_e583.visibility, _e583.is_doubted);
            } else {
                phi_907_ = evaluate_Verdict(0.5f, true);
            }
            let _e589 = phi_907_;
            phi_908_ = _e589;
        }
        let _e591 = phi_908_;
        if (_e63.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e63.first_primitive)] = _e591.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_esm_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
