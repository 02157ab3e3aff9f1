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

struct type_27 {
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
var<uniform> p: type_27;
@group(0) @binding(2) 
var<storage> map: type_13;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_13;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_126_: lt_bvh_traverse_Tree;
    var phi_127_: bool;
    var phi_128_: lt_bvh_traverse_Tree;
    var phi_129_: bool;
    var phi_134_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_126_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_127_ = false;
        } else {
            phi_126_ = lt_bvh_traverse_Tree();
            phi_127_ = true;
        }
        let _e46 = phi_126_;
        let _e48 = phi_127_;
        phi_128_ = _e46;
        phi_129_ = _e48;
    } else {
        phi_128_ = lt_bvh_traverse_Tree();
        phi_129_ = true;
    }
    let _e50 = phi_128_;
    let _e52 = phi_129_;
    if _e52 {
        phi_134_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_134_ = _e50;
    }
    let _e57 = phi_134_;
    return lt_bvh_traverse_Tree(_e57.root, _e57.first_primitive);
}

fn _lt_math_sm_Sm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_3: ptr<function, f32>, param_4: vec4<f32>, param_5: f32) -> f32 {
    var phi_758_: f32;
    var phi_759_: f32;
    var phi_760_: f32;
    var phi_777_: f32;
    var phi_778_: f32;
    var phi_779_: f32;

    let _e37 = (*param_3);
    let _e38 = (param_4.x + _e37);
    if ((bitcast<u32>(param_5) & 2147483647u) > 2139095040u) {
        phi_760_ = param_5;
    } else {
        if (param_5 < 0f) {
            phi_759_ = 0f;
        } else {
            if (param_5 > 1f) {
                phi_758_ = 1f;
            } else {
                phi_758_ = param_5;
            }
            let _e45 = phi_758_;
            phi_759_ = _e45;
        }
        let _e47 = phi_759_;
        phi_760_ = _e47;
    }
    let _e49 = phi_760_;
    if ((bitcast<u32>(_e38) & 2147483647u) > 2139095040u) {
        phi_779_ = _e38;
    } else {
        if ((bitcast<u32>(_e49) & 2147483647u) > 2139095040u) {
            phi_778_ = _e49;
        } else {
            if (_e38 < _e49) {
                phi_777_ = 0f;
            } else {
                phi_777_ = 1f;
            }
            let _e58 = phi_777_;
            phi_778_ = _e58;
        }
        let _e60 = phi_778_;
        phi_779_ = _e60;
    }
    let _e62 = phi_779_;
    return _e62;
}

fn _lt_math_sm_Sm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_6: f32) -> vec4<f32> {
    var phi_733_: f32;
    var phi_734_: f32;
    var phi_735_: f32;

    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_735_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_734_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_733_ = 1f;
            } else {
                phi_733_ = param_6;
            }
            let _e40 = phi_733_;
            phi_734_ = _e40;
        }
        let _e42 = phi_734_;
        phi_735_ = _e42;
    }
    let _e44 = phi_735_;
    return vec4<f32>(_e44, 0f, 0f, 0f);
}

fn _lt_math_sm_Sm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_7: ptr<function, f32>, param_8: vec4<f32>, param_9: vec4<f32>, param_10: f32) -> f32 {
    var phi_696_: f32;
    var phi_697_: f32;
    var phi_705_: f32;
    var phi_706_: f32;
    var phi_713_: f32;
    var phi_716_: f32;

    let _e43 = (((param_9.x + param_9.y) + param_9.z) + param_9.w);
    if ((bitcast<u32>(_e43) & 2147483647u) > 2139095040u) {
        phi_716_ = _e43;
    } else {
        if (param_9.y > param_9.x) {
            phi_696_ = param_8.y;
            phi_697_ = param_9.y;
        } else {
            phi_696_ = param_8.x;
            phi_697_ = param_9.x;
        }
        let _e54 = phi_696_;
        let _e56 = phi_697_;
        if (param_9.z > _e56) {
            phi_705_ = param_8.z;
            phi_706_ = param_9.z;
        } else {
            phi_705_ = _e54;
            phi_706_ = _e56;
        }
        let _e62 = phi_705_;
        let _e64 = phi_706_;
        if (param_9.w > _e64) {
            phi_713_ = param_8.w;
        } else {
            phi_713_ = _e62;
        }
        let _e69 = phi_713_;
        let _e70 = _lt_math_sm_Sm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(_e69);
        let _e71 = _lt_math_sm_Sm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_7, _e70, param_10);
        phi_716_ = _e71;
    }
    let _e73 = phi_716_;
    return _e73;
}

fn _lt_math_sm_Sm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_11: vec4<f32>) -> f32 {
    return param_11.x;
}

fn function_() {
    var local: f32;
    var phi_194_: bool;
    var phi_195_: bool;
    var phi_196_: bool;
    var phi_197_: bool;
    var phi_201_: bool;
    var phi_245_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_249_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_323_: bool;
    var phi_332_: bool;
    var phi_341_: bool;
    var phi_342_: bool;
    var phi_343_: bool;
    var phi_344_: bool;
    var phi_345_: bool;
    var phi_346_: bool;
    var phi_347_: bool;
    var phi_351_: bool;
    var phi_441_: f32;
    var phi_444_: f32;
    var phi_473_: f32;
    var phi_478_: f32;
    var phi_479_: bool;
    var phi_480_: f32;
    var phi_481_: bool;
    var phi_485_: f32;
    var phi_505_: f32;
    var phi_510_: f32;
    var phi_511_: bool;
    var phi_512_: f32;
    var phi_513_: bool;
    var phi_517_: f32;
    var phi_565_: i32;
    var phi_570_: i32;
    var phi_575_: i32;
    var phi_580_: i32;
    var phi_589_: i32;
    var phi_594_: i32;
    var phi_599_: i32;
    var phi_604_: i32;
    var phi_649_: evaluate_Verdict;
    var phi_650_: evaluate_Verdict;
    var phi_651_: bool;
    var phi_652_: evaluate_Verdict;
    var phi_653_: evaluate_Verdict;
    var phi_654_: bool;
    var phi_658_: evaluate_Verdict;

    let _e34 = id_1;
    let _e41 = arrayLength((&map.member));
    let _e47 = p.member.size[0u];
    let _e49 = p.member.size[1u];
    let _e50 = lt_shaders_entry_pixel_index(_e34, _e47, _e49);
    if (bitcast<i32>(_e50.root) != 0i) {
        let _e56 = p.member.projection;
        if (_e50.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e60 = lt_math_OneLevel(_e56);
        let _e62 = p.member.light;
        let _e65 = samples.member[(0u + _e50.first_primitive)].normal[0u];
        let _e67 = global[0u];
        if (_e65 == _e67) {
            let _e70 = samples.member[(0u + _e50.first_primitive)].normal[1u];
            let _e72 = global[1u];
            if (_e70 == _e72) {
                let _e75 = samples.member[(0u + _e50.first_primitive)].normal[2u];
                let _e77 = global[2u];
                phi_194_ = (_e75 == _e77);
                phi_195_ = false;
            } else {
                phi_194_ = bool();
                phi_195_ = true;
            }
            let _e80 = phi_194_;
            let _e82 = phi_195_;
            phi_196_ = _e80;
            phi_197_ = _e82;
        } else {
            phi_196_ = bool();
            phi_197_ = true;
        }
        let _e84 = phi_196_;
        let _e86 = phi_197_;
        if _e86 {
            phi_201_ = false;
        } else {
            phi_201_ = _e84;
        }
        let _e88 = phi_201_;
        if !(_e88) {
            let _e91 = samples.member[(0u + _e50.first_primitive)].normal;
            let _e93 = samples.member[(0u + _e50.first_primitive)].position;
            if ((((_e91.x * (_e62.x - (_e93.x * _e62.w))) + (_e91.y * (_e62.y - (_e93.y * _e62.w)))) + (_e91.z * (_e62.z - (_e93.z * _e62.w)))) > 0f) {
                let _e117 = samples.member[(0u + _e50.first_primitive)].flags;
                let _e125 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e131 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e125.unnamed.visibility, false), _e125.unnamed_1);
                phi_245_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e131.unnamed, ((_e117 & 1u) == 0u));
            } else {
                let _e140 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e146 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e140.unnamed.visibility, false), _e140.unnamed_1);
                phi_245_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e146.unnamed, true);
            }
            let _e151 = phi_245_;
            phi_249_ = _e151;
        } else {
            let _e157 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e163 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e157.unnamed.visibility, false), _e157.unnamed_1);
            phi_249_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e163.unnamed, true);
        }
        let _e168 = phi_249_;
        if _e168.unnamed_1 {
            phi_652_ = evaluate_Verdict(_e168.unnamed.visibility, _e168.unnamed.is_doubted);
            phi_653_ = evaluate_Verdict();
            phi_654_ = true;
        } else {
            let _e176 = samples.member[(0u + _e50.first_primitive)].position;
            let _e194 = ((((_e60.projection.row_w.x * _e176.x) + (_e60.projection.row_w.y * _e176.y)) + (_e60.projection.row_w.z * _e176.z)) + (_e60.projection.row_w.w * 1f));
            let _e208 = (((((_e60.projection.row_x.x * _e176.x) + (_e60.projection.row_x.y * _e176.y)) + (_e60.projection.row_x.z * _e176.z)) + (_e60.projection.row_x.w * 1f)) / _e194);
            let _e222 = (((((_e60.projection.row_y.x * _e176.x) + (_e60.projection.row_y.y * _e176.y)) + (_e60.projection.row_y.z * _e176.z)) + (_e60.projection.row_y.w * 1f)) / _e194);
            let _e235 = ((((_e60.projection.row_z.x * _e176.x) + (_e60.projection.row_z.y * _e176.y)) + (_e60.projection.row_z.z * _e176.z)) + (_e60.projection.row_z.w * 1f));
            if (_e194 > 0f) {
                if (_e208 >= 0f) {
                    phi_323_ = (_e208 <= 1f);
                } else {
                    phi_323_ = false;
                }
                let _e240 = phi_323_;
                if _e240 {
                    if (_e222 >= 0f) {
                        phi_332_ = (_e222 <= 1f);
                    } else {
                        phi_332_ = false;
                    }
                    let _e244 = phi_332_;
                    if _e244 {
                        if (_e235 >= 0f) {
                            phi_341_ = (_e235 <= 1f);
                        } else {
                            phi_341_ = false;
                        }
                        let _e248 = phi_341_;
                        phi_342_ = _e248;
                        phi_343_ = false;
                    } else {
                        phi_342_ = bool();
                        phi_343_ = true;
                    }
                    let _e250 = phi_342_;
                    let _e252 = phi_343_;
                    phi_344_ = _e250;
                    phi_345_ = _e252;
                } else {
                    phi_344_ = bool();
                    phi_345_ = true;
                }
                let _e254 = phi_344_;
                let _e256 = phi_345_;
                phi_346_ = _e254;
                phi_347_ = _e256;
            } else {
                phi_346_ = bool();
                phi_347_ = true;
            }
            let _e258 = phi_346_;
            let _e260 = phi_347_;
            if _e260 {
                phi_351_ = false;
            } else {
                phi_351_ = _e258;
            }
            let _e262 = phi_351_;
            if _e262 {
                if (0.5f > 0f) {
                    let _e265 = samples.member[(0u + _e50.first_primitive)].normal;
                    let _e267 = p.member.map_size;
                    let _e337 = ((abs(((((_e56.row_x.x * _e265.x) + (_e56.row_x.y * _e265.y)) + (_e56.row_x.z * _e265.z)) / (((_e56.row_x.x * _e56.row_x.x) + (_e56.row_x.y * _e56.row_x.y)) + (_e56.row_x.z * _e56.row_x.z)))) + abs(((((_e56.row_y.x * _e265.x) + (_e56.row_y.y * _e265.y)) + (_e56.row_y.z * _e265.z)) / (((_e56.row_y.x * _e56.row_y.x) + (_e56.row_y.y * _e56.row_y.y)) + (_e56.row_y.z * _e56.row_y.z))))) / (abs(((((_e56.row_z.x * _e265.x) + (_e56.row_z.y * _e265.y)) + (_e56.row_z.z * _e265.z)) / (((_e56.row_z.x * _e56.row_z.x) + (_e56.row_z.y * _e56.row_z.y)) + (_e56.row_z.z * _e56.row_z.z)))) * f32(_e267)));
                    if (_e337 < 0.002f) {
                        phi_441_ = _e337;
                    } else {
                        phi_441_ = 0.002f;
                    }
                    let _e340 = phi_441_;
                    phi_444_ = (_e235 - (0.5f * _e340));
                } else {
                    phi_444_ = _e235;
                }
                let _e344 = phi_444_;
                let _e346 = p.member.map_size;
                let _e347 = f32(_e346);
                let _e350 = ((_e208 * _e347) - 0.5f);
                let _e351 = ((_e222 * _e347) - 0.5f);
                if (_e350 > -8388608f) {
                    let _e363 = f32(select(0i, select(select(i32(_e350), i32(-2147483648), (_e350 < bitcast<f32>(3472883712u))), 2147483647i, (_e350 > bitcast<f32>(1325400063u))), (_e350 == _e350)));
                    if (_e363 > _e350) {
                        phi_473_ = 1f;
                    } else {
                        phi_473_ = 0f;
                    }
                    let _e366 = phi_473_;
                    if (_e350 < 8388608f) {
                        phi_478_ = (_e363 - _e366);
                        phi_479_ = false;
                    } else {
                        phi_478_ = f32();
                        phi_479_ = true;
                    }
                    let _e369 = phi_478_;
                    let _e371 = phi_479_;
                    phi_480_ = _e369;
                    phi_481_ = _e371;
                } else {
                    phi_480_ = f32();
                    phi_481_ = true;
                }
                let _e373 = phi_480_;
                let _e375 = phi_481_;
                if _e375 {
                    phi_485_ = _e350;
                } else {
                    phi_485_ = _e373;
                }
                let _e377 = phi_485_;
                if (_e351 > -8388608f) {
                    let _e389 = f32(select(0i, select(select(i32(_e351), i32(-2147483648), (_e351 < bitcast<f32>(3472883712u))), 2147483647i, (_e351 > bitcast<f32>(1325400063u))), (_e351 == _e351)));
                    if (_e389 > _e351) {
                        phi_505_ = 1f;
                    } else {
                        phi_505_ = 0f;
                    }
                    let _e392 = phi_505_;
                    if (_e351 < 8388608f) {
                        phi_510_ = (_e389 - _e392);
                        phi_511_ = false;
                    } else {
                        phi_510_ = f32();
                        phi_511_ = true;
                    }
                    let _e395 = phi_510_;
                    let _e397 = phi_511_;
                    phi_512_ = _e395;
                    phi_513_ = _e397;
                } else {
                    phi_512_ = f32();
                    phi_513_ = true;
                }
                let _e399 = phi_512_;
                let _e401 = phi_513_;
                if _e401 {
                    phi_517_ = _e351;
                } else {
                    phi_517_ = _e399;
                }
                let _e403 = phi_517_;
                let _e404 = (_e350 - _e377);
                let _e405 = (_e351 - _e403);
                let _e414 = select(0i, select(select(i32(_e377), i32(-2147483648), (_e377 < bitcast<f32>(3472883712u))), 2147483647i, (_e377 > bitcast<f32>(1325400063u))), (_e377 == _e377));
                let _e423 = select(0i, select(select(i32(_e403), i32(-2147483648), (_e403 < bitcast<f32>(3472883712u))), 2147483647i, (_e403 > bitcast<f32>(1325400063u))), (_e403 == _e403));
                let _e434 = p.member.test;
                let _e435 = _lt_math_sm_Sm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e434);
                let _e437 = p.member.map_size;
                local = _e435;
                let _e439 = ((0u * _e437) * _e437);
                let _e441 = (bitcast<i32>(_e437) - 1i);
                if (_e414 > 0i) {
                    phi_565_ = _e414;
                } else {
                    phi_565_ = 0i;
                }
                let _e444 = phi_565_;
                if (_e423 > 0i) {
                    phi_570_ = _e423;
                } else {
                    phi_570_ = 0i;
                }
                let _e447 = phi_570_;
                if (_e444 < _e441) {
                    phi_575_ = _e444;
                } else {
                    phi_575_ = _e441;
                }
                let _e450 = phi_575_;
                if (_e447 < _e441) {
                    phi_580_ = _e447;
                } else {
                    phi_580_ = _e441;
                }
                let _e453 = phi_580_;
                let _e454 = bitcast<u32>(_e450);
                let _e456 = (_e414 + 1i);
                let _e457 = (_e423 + 1i);
                if (_e456 > 0i) {
                    phi_589_ = _e456;
                } else {
                    phi_589_ = 0i;
                }
                let _e460 = phi_589_;
                if (_e457 > 0i) {
                    phi_594_ = _e457;
                } else {
                    phi_594_ = 0i;
                }
                let _e463 = phi_594_;
                if (_e460 < _e441) {
                    phi_599_ = _e460;
                } else {
                    phi_599_ = _e441;
                }
                let _e466 = phi_599_;
                if (_e463 < _e441) {
                    phi_604_ = _e463;
                } else {
                    phi_604_ = _e441;
                }
                let _e469 = phi_604_;
                let _e470 = bitcast<u32>(_e466);
                let _e472 = (bitcast<u32>(_e453) * _e437);
                let _e473 = (bitcast<u32>(_e469) * _e437);
                let _e478 = ((_e472 + _e454) + _e439);
                let _e479 = ((_e472 + _e470) + _e439);
                let _e480 = ((_e473 + _e454) + _e439);
                let _e481 = ((_e473 + _e470) + _e439);
                if (_e478 < _e41) {
                } else {
                    return;
                }
                let _e485 = map.member[(0u + _e478)];
                if (_e479 < _e41) {
                } else {
                    return;
                }
                let _e489 = map.member[(0u + _e479)];
                if (_e480 < _e41) {
                } else {
                    return;
                }
                let _e493 = map.member[(0u + _e480)];
                if (_e481 < _e41) {
                } else {
                    return;
                }
                let _e497 = map.member[(0u + _e481)];
                let _e499 = _lt_math_sm_Sm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e485, _e489, _e493, _e497), vec4<f32>(((1f - _e404) * (1f - _e405)), (_e404 * (1f - _e405)), ((1f - _e404) * _e405), (_e404 * _e405)), _e344);
                phi_649_ = evaluate_Verdict(_e499, false);
                phi_650_ = evaluate_Verdict();
                phi_651_ = false;
            } else {
                phi_649_ = evaluate_Verdict();
                phi_650_ = evaluate_Verdict(1f, false);
                phi_651_ = true;
            }
            let _e503 = phi_649_;
            let _e505 = phi_650_;
            let _e507 = phi_651_;
            phi_652_ = _e505;
            phi_653_ = _e503;
            phi_654_ = _e507;
        }
        let _e509 = phi_652_;
        let _e511 = phi_653_;
        let _e513 = phi_654_;
        if _e513 {
            phi_658_ = _e509;
        } else {
            phi_658_ = _e511;
        }
        let _e515 = phi_658_;
        if (_e50.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e50.first_primitive)] = _e515.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_sm_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
