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
    var phi_123_: lt_bvh_traverse_Tree;
    var phi_124_: bool;
    var phi_125_: lt_bvh_traverse_Tree;
    var phi_126_: bool;
    var phi_131_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_123_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_124_ = false;
        } else {
            phi_123_ = lt_bvh_traverse_Tree();
            phi_124_ = true;
        }
        let _e46 = phi_123_;
        let _e48 = phi_124_;
        phi_125_ = _e46;
        phi_126_ = _e48;
    } else {
        phi_125_ = lt_bvh_traverse_Tree();
        phi_126_ = true;
    }
    let _e50 = phi_125_;
    let _e52 = phi_126_;
    if _e52 {
        phi_131_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_131_ = _e50;
    }
    let _e57 = phi_131_;
    return lt_bvh_traverse_Tree(_e57.root, _e57.first_primitive);
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_683_: f32;
    var phi_684_: f32;
    var phi_685_: f32;
    var phi_701_: f32;
    var phi_702_: f32;
    var phi_703_: f32;
    var phi_719_: f32;
    var phi_720_: f32;
    var phi_721_: f32;
    var phi_737_: f32;
    var phi_738_: f32;
    var phi_739_: f32;
    var phi_755_: f32;
    var phi_756_: f32;
    var phi_757_: f32;
    var phi_803_: bool;
    var phi_807_: f32;
    var phi_819_: bool;
    var phi_826_: f32;
    var phi_841_: f32;
    var phi_842_: f32;
    var phi_843_: f32;

    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_685_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_684_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_683_ = 1f;
            } else {
                phi_683_ = param_7;
            }
            let _e43 = phi_683_;
            phi_684_ = _e43;
        }
        let _e45 = phi_684_;
        phi_685_ = _e45;
    }
    let _e47 = phi_685_;
    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_703_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_702_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_701_ = 1f;
            } else {
                phi_701_ = param_5.x;
            }
            let _e55 = phi_701_;
            phi_702_ = _e55;
        }
        let _e57 = phi_702_;
        phi_703_ = _e57;
    }
    let _e59 = phi_703_;
    if ((bitcast<u32>(param_5.y) & 2147483647u) > 2139095040u) {
        phi_721_ = param_5.y;
    } else {
        if (param_5.y < 0f) {
            phi_720_ = 0f;
        } else {
            if (param_5.y > 1f) {
                phi_719_ = 1f;
            } else {
                phi_719_ = param_5.y;
            }
            let _e67 = phi_719_;
            phi_720_ = _e67;
        }
        let _e69 = phi_720_;
        phi_721_ = _e69;
    }
    let _e71 = phi_721_;
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_739_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_738_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_737_ = 1f;
            } else {
                phi_737_ = param_5.z;
            }
            let _e79 = phi_737_;
            phi_738_ = _e79;
        }
        let _e81 = phi_738_;
        phi_739_ = _e81;
    }
    let _e83 = phi_739_;
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_757_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_756_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_755_ = 1f;
            } else {
                phi_755_ = param_5.w;
            }
            let _e91 = phi_755_;
            phi_756_ = _e91;
        }
        let _e93 = phi_756_;
        phi_757_ = _e93;
    }
    let _e95 = phi_757_;
    let _e96 = (_e59 - _e47);
    let _e97 = (_e71 - _e47);
    let _e98 = (_e83 - _e47);
    let _e99 = (_e95 - _e47);
    let _e100 = (*param_4);
    let _e111 = ((((_e96 * param_6.x) + (_e97 * param_6.y)) + (_e98 * param_6.z)) + (_e99 * param_6.w));
    let _e112 = (_e96 - _e111);
    let _e113 = (_e97 - _e111);
    let _e114 = (_e98 - _e111);
    let _e115 = (_e99 - _e111);
    let _e130 = (((((_e112 * _e112) * param_6.x) + ((_e113 * _e113) * param_6.y)) + ((_e114 * _e114) * param_6.z)) + ((_e115 * _e115) * param_6.w));
    if ((bitcast<u32>(_e100) & 2147483647u) > 2139095040u) {
        phi_803_ = true;
    } else {
        let _e134 = (_e100 > _e130);
        if _e134 {
        }
        phi_803_ = _e134;
    }
    let _e136 = phi_803_;
    if _e136 {
        phi_807_ = _e100;
    } else {
        phi_807_ = _e130;
    }
    let _e138 = phi_807_;
    let _e139 = -(_e111);
    if (_e139 <= 0f) {
        let _e143 = ((bitcast<u32>(_e138) & 2147483647u) > 2139095040u);
        if _e143 {
        }
        phi_819_ = _e143;
    } else {
        phi_819_ = true;
    }
    let _e145 = phi_819_;
    if _e145 {
        phi_826_ = (_e138 / (_e138 + (_e139 * _e139)));
    } else {
        phi_826_ = 1f;
    }
    let _e150 = phi_826_;
    if ((bitcast<u32>(_e150) & 2147483647u) > 2139095040u) {
        phi_843_ = _e150;
    } else {
        if (_e150 < 0f) {
            phi_842_ = 0f;
        } else {
            if (_e150 > 1f) {
                phi_841_ = 1f;
            } else {
                phi_841_ = _e150;
            }
            let _e157 = phi_841_;
            phi_842_ = _e157;
        }
        let _e159 = phi_842_;
        phi_843_ = _e159;
    }
    let _e161 = phi_843_;
    return _e161;
}

fn function_() {
    var local: f32;
    var phi_191_: bool;
    var phi_192_: bool;
    var phi_193_: bool;
    var phi_194_: bool;
    var phi_198_: bool;
    var phi_242_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_246_: u0028_evaluate_Verdict_u0020_bool_u0029_;
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
    var phi_445_: f32;
    var phi_448_: f32;
    var phi_477_: f32;
    var phi_482_: f32;
    var phi_483_: bool;
    var phi_484_: f32;
    var phi_485_: bool;
    var phi_489_: f32;
    var phi_509_: f32;
    var phi_514_: f32;
    var phi_515_: bool;
    var phi_516_: f32;
    var phi_517_: bool;
    var phi_521_: f32;
    var phi_567_: i32;
    var phi_572_: i32;
    var phi_577_: i32;
    var phi_582_: i32;
    var phi_591_: i32;
    var phi_596_: i32;
    var phi_601_: i32;
    var phi_606_: i32;
    var phi_647_: evaluate_Verdict;
    var phi_648_: evaluate_Verdict;
    var phi_649_: bool;
    var phi_650_: evaluate_Verdict;
    var phi_651_: evaluate_Verdict;
    var phi_652_: bool;
    var phi_656_: evaluate_Verdict;

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
                phi_191_ = (_e72 == _e74);
                phi_192_ = false;
            } else {
                phi_191_ = bool();
                phi_192_ = true;
            }
            let _e77 = phi_191_;
            let _e79 = phi_192_;
            phi_193_ = _e77;
            phi_194_ = _e79;
        } else {
            phi_193_ = bool();
            phi_194_ = true;
        }
        let _e81 = phi_193_;
        let _e83 = phi_194_;
        if _e83 {
            phi_198_ = false;
        } else {
            phi_198_ = _e81;
        }
        let _e85 = phi_198_;
        if !(_e85) {
            let _e88 = samples.member[(0u + _e50.first_primitive)].normal;
            let _e90 = samples.member[(0u + _e50.first_primitive)].position;
            if ((((_e88.x * (_e59.x - (_e90.x * _e59.w))) + (_e88.y * (_e59.y - (_e90.y * _e59.w)))) + (_e88.z * (_e59.z - (_e90.z * _e59.w)))) > 0f) {
                let _e114 = samples.member[(0u + _e50.first_primitive)].flags;
                let _e122 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e128 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e122.unnamed.visibility, false), _e122.unnamed_1);
                phi_242_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e128.unnamed, ((_e114 & 1u) == 0u));
            } else {
                let _e137 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e143 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e137.unnamed.visibility, false), _e137.unnamed_1);
                phi_242_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e143.unnamed, true);
            }
            let _e148 = phi_242_;
            phi_246_ = _e148;
        } else {
            let _e154 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e160 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e154.unnamed.visibility, false), _e154.unnamed_1);
            phi_246_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e160.unnamed, true);
        }
        let _e165 = phi_246_;
        if _e165.unnamed_1 {
            phi_650_ = evaluate_Verdict(_e165.unnamed.visibility, _e165.unnamed.is_doubted);
            phi_651_ = evaluate_Verdict();
            phi_652_ = true;
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
                    phi_323_ = (_e204 <= 1f);
                } else {
                    phi_323_ = false;
                }
                let _e236 = phi_323_;
                if _e236 {
                    if (_e218 >= 0f) {
                        phi_332_ = (_e218 <= 1f);
                    } else {
                        phi_332_ = false;
                    }
                    let _e240 = phi_332_;
                    if _e240 {
                        if (_e231 >= 0f) {
                            phi_341_ = (_e231 <= 1f);
                        } else {
                            phi_341_ = false;
                        }
                        let _e244 = phi_341_;
                        phi_342_ = _e244;
                        phi_343_ = false;
                    } else {
                        phi_342_ = bool();
                        phi_343_ = true;
                    }
                    let _e246 = phi_342_;
                    let _e248 = phi_343_;
                    phi_344_ = _e246;
                    phi_345_ = _e248;
                } else {
                    phi_344_ = bool();
                    phi_345_ = true;
                }
                let _e250 = phi_344_;
                let _e252 = phi_345_;
                phi_346_ = _e250;
                phi_347_ = _e252;
            } else {
                phi_346_ = bool();
                phi_347_ = true;
            }
            let _e254 = phi_346_;
            let _e256 = phi_347_;
            if _e256 {
                phi_351_ = false;
            } else {
                phi_351_ = _e254;
            }
            let _e258 = phi_351_;
            if _e258 {
                if (0f > 0f) {
                    let _e261 = samples.member[(0u + _e50.first_primitive)].normal;
                    let _e263 = p.member.map_size;
                    let _e266 = p.member.projection.row_x;
                    let _e288 = p.member.projection.row_y;
                    let _e310 = p.member.projection.row_z;
                    let _e337 = ((abs(((((_e266.x * _e261.x) + (_e266.y * _e261.y)) + (_e266.z * _e261.z)) / (((_e266.x * _e266.x) + (_e266.y * _e266.y)) + (_e266.z * _e266.z)))) + abs(((((_e288.x * _e261.x) + (_e288.y * _e261.y)) + (_e288.z * _e261.z)) / (((_e288.x * _e288.x) + (_e288.y * _e288.y)) + (_e288.z * _e288.z))))) / (abs(((((_e310.x * _e261.x) + (_e310.y * _e261.y)) + (_e310.z * _e261.z)) / (((_e310.x * _e310.x) + (_e310.y * _e310.y)) + (_e310.z * _e310.z)))) * f32(_e263)));
                    if (_e337 < 0.002f) {
                        phi_445_ = _e337;
                    } else {
                        phi_445_ = 0.002f;
                    }
                    let _e340 = phi_445_;
                    phi_448_ = (_e231 - (0f * _e340));
                } else {
                    phi_448_ = _e231;
                }
                let _e344 = phi_448_;
                let _e346 = p.member.map_size;
                let _e347 = f32(_e346);
                let _e350 = ((_e204 * _e347) - 0.5f);
                let _e351 = ((_e218 * _e347) - 0.5f);
                if (_e350 > -8388608f) {
                    let _e363 = f32(select(0i, select(select(i32(_e350), i32(-2147483648), (_e350 < bitcast<f32>(3472883712u))), 2147483647i, (_e350 > bitcast<f32>(1325400063u))), (_e350 == _e350)));
                    if (_e363 > _e350) {
                        phi_477_ = 1f;
                    } else {
                        phi_477_ = 0f;
                    }
                    let _e366 = phi_477_;
                    if (_e350 < 8388608f) {
                        phi_482_ = (_e363 - _e366);
                        phi_483_ = false;
                    } else {
                        phi_482_ = f32();
                        phi_483_ = true;
                    }
                    let _e369 = phi_482_;
                    let _e371 = phi_483_;
                    phi_484_ = _e369;
                    phi_485_ = _e371;
                } else {
                    phi_484_ = f32();
                    phi_485_ = true;
                }
                let _e373 = phi_484_;
                let _e375 = phi_485_;
                if _e375 {
                    phi_489_ = _e350;
                } else {
                    phi_489_ = _e373;
                }
                let _e377 = phi_489_;
                if (_e351 > -8388608f) {
                    let _e389 = f32(select(0i, select(select(i32(_e351), i32(-2147483648), (_e351 < bitcast<f32>(3472883712u))), 2147483647i, (_e351 > bitcast<f32>(1325400063u))), (_e351 == _e351)));
                    if (_e389 > _e351) {
                        phi_509_ = 1f;
                    } else {
                        phi_509_ = 0f;
                    }
                    let _e392 = phi_509_;
                    if (_e351 < 8388608f) {
                        phi_514_ = (_e389 - _e392);
                        phi_515_ = false;
                    } else {
                        phi_514_ = f32();
                        phi_515_ = true;
                    }
                    let _e395 = phi_514_;
                    let _e397 = phi_515_;
                    phi_516_ = _e395;
                    phi_517_ = _e397;
                } else {
                    phi_516_ = f32();
                    phi_517_ = true;
                }
                let _e399 = phi_516_;
                let _e401 = phi_517_;
                if _e401 {
                    phi_521_ = _e351;
                } else {
                    phi_521_ = _e399;
                }
                let _e403 = phi_521_;
                let _e404 = (_e350 - _e377);
                let _e405 = (_e351 - _e403);
                let _e414 = select(0i, select(select(i32(_e377), i32(-2147483648), (_e377 < bitcast<f32>(3472883712u))), 2147483647i, (_e377 > bitcast<f32>(1325400063u))), (_e377 == _e377));
                let _e423 = select(0i, select(select(i32(_e403), i32(-2147483648), (_e403 < bitcast<f32>(3472883712u))), 2147483647i, (_e403 > bitcast<f32>(1325400063u))), (_e403 == _e403));
                let _e434 = p.member.test;
                let _e435 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e434);
                let _e437 = p.member.map_size;
                local = _e435;
                let _e439 = (bitcast<i32>(_e437) - 1i);
                if (_e414 > 0i) {
                    phi_567_ = _e414;
                } else {
                    phi_567_ = 0i;
                }
                let _e442 = phi_567_;
                if (_e423 > 0i) {
                    phi_572_ = _e423;
                } else {
                    phi_572_ = 0i;
                }
                let _e445 = phi_572_;
                if (_e442 < _e439) {
                    phi_577_ = _e442;
                } else {
                    phi_577_ = _e439;
                }
                let _e448 = phi_577_;
                if (_e445 < _e439) {
                    phi_582_ = _e445;
                } else {
                    phi_582_ = _e439;
                }
                let _e451 = phi_582_;
                let _e452 = bitcast<u32>(_e448);
                let _e454 = (_e414 + 1i);
                let _e455 = (_e423 + 1i);
                if (_e454 > 0i) {
                    phi_591_ = _e454;
                } else {
                    phi_591_ = 0i;
                }
                let _e458 = phi_591_;
                if (_e455 > 0i) {
                    phi_596_ = _e455;
                } else {
                    phi_596_ = 0i;
                }
                let _e461 = phi_596_;
                if (_e458 < _e439) {
                    phi_601_ = _e458;
                } else {
                    phi_601_ = _e439;
                }
                let _e464 = phi_601_;
                if (_e461 < _e439) {
                    phi_606_ = _e461;
                } else {
                    phi_606_ = _e439;
                }
                let _e467 = phi_606_;
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
                let _e493 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e479, _e483, _e487, _e491), vec4<f32>(((1f - _e404) * (1f - _e405)), (_e404 * (1f - _e405)), ((1f - _e404) * _e405), (_e404 * _e405)), _e344);
                phi_647_ = evaluate_Verdict(_e493, false);
                phi_648_ = evaluate_Verdict();
                phi_649_ = false;
            } else {
                phi_647_ = evaluate_Verdict();
                phi_648_ = evaluate_Verdict(1f, false);
                phi_649_ = true;
            }
            let _e497 = phi_647_;
            let _e499 = phi_648_;
            let _e501 = phi_649_;
            phi_650_ = _e499;
            phi_651_ = _e497;
            phi_652_ = _e501;
        }
        let _e503 = phi_650_;
        let _e505 = phi_651_;
        let _e507 = phi_652_;
        if _e507 {
            phi_656_ = _e503;
        } else {
            phi_656_ = _e505;
        }
        let _e509 = phi_656_;
        if (_e50.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e50.first_primitive)] = _e509.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_vsm_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
