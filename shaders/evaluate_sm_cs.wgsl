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
    pad0_: u32,
    pad1_: u32,
    pad2_: u32,
}

struct type_27 {
    member: abi_ShadowParams,
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
    var phi_125_: lt_bvh_traverse_Tree;
    var phi_126_: bool;
    var phi_127_: lt_bvh_traverse_Tree;
    var phi_128_: bool;
    var phi_133_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_125_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_126_ = false;
        } else {
            phi_125_ = lt_bvh_traverse_Tree();
            phi_126_ = true;
        }
        let _e46 = phi_125_;
        let _e48 = phi_126_;
        phi_127_ = _e46;
        phi_128_ = _e48;
    } else {
        phi_127_ = lt_bvh_traverse_Tree();
        phi_128_ = true;
    }
    let _e50 = phi_127_;
    let _e52 = phi_128_;
    if _e52 {
        phi_133_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_133_ = _e50;
    }
    let _e57 = phi_133_;
    return lt_bvh_traverse_Tree(_e57.root, _e57.first_primitive);
}

fn _lt_math_sm_Sm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_3: ptr<function, f32>, param_4: vec4<f32>, param_5: f32) -> f32 {
    var phi_755_: f32;
    var phi_756_: f32;
    var phi_757_: f32;
    var phi_774_: f32;
    var phi_775_: f32;
    var phi_776_: f32;

    let _e37 = (*param_3);
    let _e38 = (param_4.x + _e37);
    if ((bitcast<u32>(param_5) & 2147483647u) > 2139095040u) {
        phi_757_ = param_5;
    } else {
        if (param_5 < 0f) {
            phi_756_ = 0f;
        } else {
            if (param_5 > 1f) {
                phi_755_ = 1f;
            } else {
                phi_755_ = param_5;
            }
            let _e45 = phi_755_;
            phi_756_ = _e45;
        }
        let _e47 = phi_756_;
        phi_757_ = _e47;
    }
    let _e49 = phi_757_;
    if ((bitcast<u32>(_e38) & 2147483647u) > 2139095040u) {
        phi_776_ = _e38;
    } else {
        if ((bitcast<u32>(_e49) & 2147483647u) > 2139095040u) {
            phi_775_ = _e49;
        } else {
            if (_e38 < _e49) {
                phi_774_ = 0f;
            } else {
                phi_774_ = 1f;
            }
            let _e58 = phi_774_;
            phi_775_ = _e58;
        }
        let _e60 = phi_775_;
        phi_776_ = _e60;
    }
    let _e62 = phi_776_;
    return _e62;
}

fn _lt_math_sm_Sm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_6: f32) -> vec4<f32> {
    var phi_730_: f32;
    var phi_731_: f32;
    var phi_732_: f32;

    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_732_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_731_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_730_ = 1f;
            } else {
                phi_730_ = param_6;
            }
            let _e40 = phi_730_;
            phi_731_ = _e40;
        }
        let _e42 = phi_731_;
        phi_732_ = _e42;
    }
    let _e44 = phi_732_;
    return vec4<f32>(_e44, 0f, 0f, 0f);
}

fn _lt_math_sm_Sm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_7: ptr<function, f32>, param_8: vec4<f32>, param_9: vec4<f32>, param_10: f32) -> f32 {
    var phi_693_: f32;
    var phi_694_: f32;
    var phi_702_: f32;
    var phi_703_: f32;
    var phi_710_: f32;
    var phi_713_: f32;

    let _e43 = (((param_9.x + param_9.y) + param_9.z) + param_9.w);
    if ((bitcast<u32>(_e43) & 2147483647u) > 2139095040u) {
        phi_713_ = _e43;
    } else {
        if (param_9.y > param_9.x) {
            phi_693_ = param_8.y;
            phi_694_ = param_9.y;
        } else {
            phi_693_ = param_8.x;
            phi_694_ = param_9.x;
        }
        let _e54 = phi_693_;
        let _e56 = phi_694_;
        if (param_9.z > _e56) {
            phi_702_ = param_8.z;
            phi_703_ = param_9.z;
        } else {
            phi_702_ = _e54;
            phi_703_ = _e56;
        }
        let _e62 = phi_702_;
        let _e64 = phi_703_;
        if (param_9.w > _e64) {
            phi_710_ = param_8.w;
        } else {
            phi_710_ = _e62;
        }
        let _e69 = phi_710_;
        let _e70 = _lt_math_sm_Sm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(_e69);
        let _e71 = _lt_math_sm_Sm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_7, _e70, param_10);
        phi_713_ = _e71;
    }
    let _e73 = phi_713_;
    return _e73;
}

fn _lt_math_sm_Sm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_11: vec4<f32>) -> f32 {
    return param_11.x;
}

fn function_() {
    var local: f32;
    var phi_190_: bool;
    var phi_191_: bool;
    var phi_192_: bool;
    var phi_193_: bool;
    var phi_197_: bool;
    var phi_241_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_245_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_322_: bool;
    var phi_331_: bool;
    var phi_340_: bool;
    var phi_341_: bool;
    var phi_342_: bool;
    var phi_343_: bool;
    var phi_344_: bool;
    var phi_345_: bool;
    var phi_346_: bool;
    var phi_350_: bool;
    var phi_444_: f32;
    var phi_447_: f32;
    var phi_476_: f32;
    var phi_481_: f32;
    var phi_482_: bool;
    var phi_483_: f32;
    var phi_484_: bool;
    var phi_488_: f32;
    var phi_508_: f32;
    var phi_513_: f32;
    var phi_514_: bool;
    var phi_515_: f32;
    var phi_516_: bool;
    var phi_520_: f32;
    var phi_566_: i32;
    var phi_571_: i32;
    var phi_576_: i32;
    var phi_581_: i32;
    var phi_590_: i32;
    var phi_595_: i32;
    var phi_600_: i32;
    var phi_605_: i32;
    var phi_646_: evaluate_Verdict;
    var phi_647_: evaluate_Verdict;
    var phi_648_: bool;
    var phi_649_: evaluate_Verdict;
    var phi_650_: evaluate_Verdict;
    var phi_651_: bool;
    var phi_655_: evaluate_Verdict;

    let _e34 = id_1;
    let _e41 = arrayLength((&map.member));
    let _e47 = p.member.size[0u];
    let _e49 = p.member.size[1u];
    let _e50 = lt_shaders_entry_pixel_index(_e34, _e47, _e49);
    if (bitcast<i32>(_e50.root) != 0i) {
        if (_e50.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e59 = p.member.light;
        let _e62 = samples.member[(0u + _e50.first_primitive)].normal[0u];
        let _e64 = global[0u];
        if (_e62 == _e64) {
            let _e67 = samples.member[(0u + _e50.first_primitive)].normal[1u];
            let _e69 = global[1u];
            if (_e67 == _e69) {
                let _e72 = samples.member[(0u + _e50.first_primitive)].normal[2u];
                let _e74 = global[2u];
                phi_190_ = (_e72 == _e74);
                phi_191_ = false;
            } else {
                phi_190_ = bool();
                phi_191_ = true;
            }
            let _e77 = phi_190_;
            let _e79 = phi_191_;
            phi_192_ = _e77;
            phi_193_ = _e79;
        } else {
            phi_192_ = bool();
            phi_193_ = true;
        }
        let _e81 = phi_192_;
        let _e83 = phi_193_;
        if _e83 {
            phi_197_ = false;
        } else {
            phi_197_ = _e81;
        }
        let _e85 = phi_197_;
        if !(_e85) {
            let _e88 = samples.member[(0u + _e50.first_primitive)].normal;
            let _e90 = samples.member[(0u + _e50.first_primitive)].position;
            if ((((_e88.x * (_e59.x - (_e90.x * _e59.w))) + (_e88.y * (_e59.y - (_e90.y * _e59.w)))) + (_e88.z * (_e59.z - (_e90.z * _e59.w)))) > 0f) {
                let _e114 = samples.member[(0u + _e50.first_primitive)].flags;
                let _e122 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e128 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e122.unnamed.visibility, false), _e122.unnamed_1);
                phi_241_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e128.unnamed, ((_e114 & 1u) == 0u));
            } else {
                let _e137 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e143 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e137.unnamed.visibility, false), _e137.unnamed_1);
                phi_241_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e143.unnamed, true);
            }
            let _e148 = phi_241_;
            phi_245_ = _e148;
        } else {
            let _e154 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e160 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e154.unnamed.visibility, false), _e154.unnamed_1);
            phi_245_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e160.unnamed, true);
        }
        let _e165 = phi_245_;
        if _e165.unnamed_1 {
            phi_649_ = evaluate_Verdict(_e165.unnamed.visibility, _e165.unnamed.is_doubted);
            phi_650_ = evaluate_Verdict();
            phi_651_ = true;
        } else {
            let _e173 = samples.member[(0u + _e50.first_primitive)].position;
            let _e179 = p.member.projection.row_w;
            let _e190 = ((((_e179.x * _e173.x) + (_e179.y * _e173.y)) + (_e179.z * _e173.z)) + (_e179.w * 1f));
            let _e192 = p.member.projection.row_x;
            let _e204 = (((((_e192.x * _e173.x) + (_e192.y * _e173.y)) + (_e192.z * _e173.z)) + (_e192.w * 1f)) / _e190);
            let _e206 = p.member.projection.row_y;
            let _e218 = (((((_e206.x * _e173.x) + (_e206.y * _e173.y)) + (_e206.z * _e173.z)) + (_e206.w * 1f)) / _e190);
            let _e220 = p.member.projection.row_z;
            let _e231 = ((((_e220.x * _e173.x) + (_e220.y * _e173.y)) + (_e220.z * _e173.z)) + (_e220.w * 1f));
            if (_e190 > 0f) {
                if (_e204 >= 0f) {
                    phi_322_ = (_e204 <= 1f);
                } else {
                    phi_322_ = false;
                }
                let _e236 = phi_322_;
                if _e236 {
                    if (_e218 >= 0f) {
                        phi_331_ = (_e218 <= 1f);
                    } else {
                        phi_331_ = false;
                    }
                    let _e240 = phi_331_;
                    if _e240 {
                        if (_e231 >= 0f) {
                            phi_340_ = (_e231 <= 1f);
                        } else {
                            phi_340_ = false;
                        }
                        let _e244 = phi_340_;
                        phi_341_ = _e244;
                        phi_342_ = false;
                    } else {
                        phi_341_ = bool();
                        phi_342_ = true;
                    }
                    let _e246 = phi_341_;
                    let _e248 = phi_342_;
                    phi_343_ = _e246;
                    phi_344_ = _e248;
                } else {
                    phi_343_ = bool();
                    phi_344_ = true;
                }
                let _e250 = phi_343_;
                let _e252 = phi_344_;
                phi_345_ = _e250;
                phi_346_ = _e252;
            } else {
                phi_345_ = bool();
                phi_346_ = true;
            }
            let _e254 = phi_345_;
            let _e256 = phi_346_;
            if _e256 {
                phi_350_ = false;
            } else {
                phi_350_ = _e254;
            }
            let _e258 = phi_350_;
            if _e258 {
                if (0.5f > 0f) {
                    let _e261 = samples.member[(0u + _e50.first_primitive)].normal;
                    let _e263 = p.member.map_size;
                    let _e266 = p.member.projection.row_x;
                    let _e288 = p.member.projection.row_y;
                    let _e310 = p.member.projection.row_z;
                    let _e337 = ((abs(((((_e266.x * _e261.x) + (_e266.y * _e261.y)) + (_e266.z * _e261.z)) / (((_e266.x * _e266.x) + (_e266.y * _e266.y)) + (_e266.z * _e266.z)))) + abs(((((_e288.x * _e261.x) + (_e288.y * _e261.y)) + (_e288.z * _e261.z)) / (((_e288.x * _e288.x) + (_e288.y * _e288.y)) + (_e288.z * _e288.z))))) / (abs(((((_e310.x * _e261.x) + (_e310.y * _e261.y)) + (_e310.z * _e261.z)) / (((_e310.x * _e310.x) + (_e310.y * _e310.y)) + (_e310.z * _e310.z)))) * f32(_e263)));
                    if (_e337 < 0.002f) {
                        phi_444_ = _e337;
                    } else {
                        phi_444_ = 0.002f;
                    }
                    let _e340 = phi_444_;
                    phi_447_ = (_e231 - (0.5f * _e340));
                } else {
                    phi_447_ = _e231;
                }
                let _e344 = phi_447_;
                let _e346 = p.member.map_size;
                let _e347 = f32(_e346);
                let _e350 = ((_e204 * _e347) - 0.5f);
                let _e351 = ((_e218 * _e347) - 0.5f);
                if (_e350 > -8388608f) {
                    let _e363 = f32(select(0i, select(select(i32(_e350), i32(-2147483648), (_e350 < bitcast<f32>(3472883712u))), 2147483647i, (_e350 > bitcast<f32>(1325400063u))), (_e350 == _e350)));
                    if (_e363 > _e350) {
                        phi_476_ = 1f;
                    } else {
                        phi_476_ = 0f;
                    }
                    let _e366 = phi_476_;
                    if (_e350 < 8388608f) {
                        phi_481_ = (_e363 - _e366);
                        phi_482_ = false;
                    } else {
                        phi_481_ = f32();
                        phi_482_ = true;
                    }
                    let _e369 = phi_481_;
                    let _e371 = phi_482_;
                    phi_483_ = _e369;
                    phi_484_ = _e371;
                } else {
                    phi_483_ = f32();
                    phi_484_ = true;
                }
                let _e373 = phi_483_;
                let _e375 = phi_484_;
                if _e375 {
                    phi_488_ = _e350;
                } else {
                    phi_488_ = _e373;
                }
                let _e377 = phi_488_;
                if (_e351 > -8388608f) {
                    let _e389 = f32(select(0i, select(select(i32(_e351), i32(-2147483648), (_e351 < bitcast<f32>(3472883712u))), 2147483647i, (_e351 > bitcast<f32>(1325400063u))), (_e351 == _e351)));
                    if (_e389 > _e351) {
                        phi_508_ = 1f;
                    } else {
                        phi_508_ = 0f;
                    }
                    let _e392 = phi_508_;
                    if (_e351 < 8388608f) {
                        phi_513_ = (_e389 - _e392);
                        phi_514_ = false;
                    } else {
                        phi_513_ = f32();
                        phi_514_ = true;
                    }
                    let _e395 = phi_513_;
                    let _e397 = phi_514_;
                    phi_515_ = _e395;
                    phi_516_ = _e397;
                } else {
                    phi_515_ = f32();
                    phi_516_ = true;
                }
                let _e399 = phi_515_;
                let _e401 = phi_516_;
                if _e401 {
                    phi_520_ = _e351;
                } else {
                    phi_520_ = _e399;
                }
                let _e403 = phi_520_;
                let _e404 = (_e350 - _e377);
                let _e405 = (_e351 - _e403);
                let _e414 = select(0i, select(select(i32(_e377), i32(-2147483648), (_e377 < bitcast<f32>(3472883712u))), 2147483647i, (_e377 > bitcast<f32>(1325400063u))), (_e377 == _e377));
                let _e423 = select(0i, select(select(i32(_e403), i32(-2147483648), (_e403 < bitcast<f32>(3472883712u))), 2147483647i, (_e403 > bitcast<f32>(1325400063u))), (_e403 == _e403));
                let _e434 = p.member.test;
                let _e435 = _lt_math_sm_Sm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e434);
                let _e437 = p.member.map_size;
                local = _e435;
                let _e439 = (bitcast<i32>(_e437) - 1i);
                if (_e414 > 0i) {
                    phi_566_ = _e414;
                } else {
                    phi_566_ = 0i;
                }
                let _e442 = phi_566_;
                if (_e423 > 0i) {
                    phi_571_ = _e423;
                } else {
                    phi_571_ = 0i;
                }
                let _e445 = phi_571_;
                if (_e442 < _e439) {
                    phi_576_ = _e442;
                } else {
                    phi_576_ = _e439;
                }
                let _e448 = phi_576_;
                if (_e445 < _e439) {
                    phi_581_ = _e445;
                } else {
                    phi_581_ = _e439;
                }
                let _e451 = phi_581_;
                let _e452 = bitcast<u32>(_e448);
                let _e454 = (_e414 + 1i);
                let _e455 = (_e423 + 1i);
                if (_e454 > 0i) {
                    phi_590_ = _e454;
                } else {
                    phi_590_ = 0i;
                }
                let _e458 = phi_590_;
                if (_e455 > 0i) {
                    phi_595_ = _e455;
                } else {
                    phi_595_ = 0i;
                }
                let _e461 = phi_595_;
                if (_e458 < _e439) {
                    phi_600_ = _e458;
                } else {
                    phi_600_ = _e439;
                }
                let _e464 = phi_600_;
                if (_e461 < _e439) {
                    phi_605_ = _e461;
                } else {
                    phi_605_ = _e439;
                }
                let _e467 = phi_605_;
                let _e468 = bitcast<u32>(_e464);
                let _e470 = (bitcast<u32>(_e451) * _e437);
                let _e471 = (bitcast<u32>(_e467) * _e437);
                let _e472 = (_e470 + _e452);
                let _e473 = (_e470 + _e468);
                let _e474 = (_e471 + _e452);
                let _e475 = (_e471 + _e468);
                if (_e472 < _e41) {
                } else {
                    return;
                }
                let _e479 = map.member[(0u + _e472)];
                if (_e473 < _e41) {
                } else {
                    return;
                }
                let _e483 = map.member[(0u + _e473)];
                if (_e474 < _e41) {
                } else {
                    return;
                }
                let _e487 = map.member[(0u + _e474)];
                if (_e475 < _e41) {
                } else {
                    return;
                }
                let _e491 = map.member[(0u + _e475)];
                let _e493 = _lt_math_sm_Sm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e479, _e483, _e487, _e491), vec4<f32>(((1f - _e404) * (1f - _e405)), (_e404 * (1f - _e405)), ((1f - _e404) * _e405), (_e404 * _e405)), _e344);
                phi_646_ = evaluate_Verdict(_e493, false);
                phi_647_ = evaluate_Verdict();
                phi_648_ = false;
            } else {
                phi_646_ = evaluate_Verdict();
                phi_647_ = evaluate_Verdict(1f, false);
                phi_648_ = true;
            }
            let _e497 = phi_646_;
            let _e499 = phi_647_;
            let _e501 = phi_648_;
            phi_649_ = _e499;
            phi_650_ = _e497;
            phi_651_ = _e501;
        }
        let _e503 = phi_649_;
        let _e505 = phi_650_;
        let _e507 = phi_651_;
        if _e507 {
            phi_655_ = _e503;
        } else {
            phi_655_ = _e505;
        }
        let _e509 = phi_655_;
        if (_e50.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e50.first_primitive)] = _e509.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_sm_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
