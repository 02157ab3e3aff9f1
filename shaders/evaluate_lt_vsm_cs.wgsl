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

struct type_28 {
    member: abi_ShadowParams,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_28;
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

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_159_: f32;
    var phi_160_: f32;
    var phi_161_: f32;
    var phi_177_: f32;
    var phi_178_: f32;
    var phi_179_: f32;
    var phi_195_: f32;
    var phi_196_: f32;
    var phi_197_: f32;
    var phi_213_: f32;
    var phi_214_: f32;
    var phi_215_: f32;
    var phi_231_: f32;
    var phi_232_: f32;
    var phi_233_: f32;
    var phi_279_: bool;
    var phi_283_: f32;
    var phi_295_: bool;
    var phi_302_: f32;
    var phi_317_: f32;
    var phi_318_: f32;
    var phi_319_: f32;

    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_161_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_160_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_159_ = 1f;
            } else {
                phi_159_ = param_7;
            }
            let _e43 = phi_159_;
            phi_160_ = _e43;
        }
        let _e45 = phi_160_;
        phi_161_ = _e45;
    }
    let _e47 = phi_161_;
    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_179_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_178_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_177_ = 1f;
            } else {
                phi_177_ = param_5.x;
            }
            let _e55 = phi_177_;
            phi_178_ = _e55;
        }
        let _e57 = phi_178_;
        phi_179_ = _e57;
    }
    let _e59 = phi_179_;
    if ((bitcast<u32>(param_5.y) & 2147483647u) > 2139095040u) {
        phi_197_ = param_5.y;
    } else {
        if (param_5.y < 0f) {
            phi_196_ = 0f;
        } else {
            if (param_5.y > 1f) {
                phi_195_ = 1f;
            } else {
                phi_195_ = param_5.y;
            }
            let _e67 = phi_195_;
            phi_196_ = _e67;
        }
        let _e69 = phi_196_;
        phi_197_ = _e69;
    }
    let _e71 = phi_197_;
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_215_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_214_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_213_ = 1f;
            } else {
                phi_213_ = param_5.z;
            }
            let _e79 = phi_213_;
            phi_214_ = _e79;
        }
        let _e81 = phi_214_;
        phi_215_ = _e81;
    }
    let _e83 = phi_215_;
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_233_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_232_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_231_ = 1f;
            } else {
                phi_231_ = param_5.w;
            }
            let _e91 = phi_231_;
            phi_232_ = _e91;
        }
        let _e93 = phi_232_;
        phi_233_ = _e93;
    }
    let _e95 = phi_233_;
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
        phi_279_ = true;
    } else {
        let _e134 = (_e100 > _e130);
        if _e134 {
        }
        phi_279_ = _e134;
    }
    let _e136 = phi_279_;
    if _e136 {
        phi_283_ = _e100;
    } else {
        phi_283_ = _e130;
    }
    let _e138 = phi_283_;
    let _e139 = -(_e111);
    if (_e139 <= 0f) {
        let _e143 = ((bitcast<u32>(_e138) & 2147483647u) > 2139095040u);
        if _e143 {
        }
        phi_295_ = _e143;
    } else {
        phi_295_ = true;
    }
    let _e145 = phi_295_;
    if _e145 {
        phi_302_ = (_e138 / (_e138 + (_e139 * _e139)));
    } else {
        phi_302_ = 1f;
    }
    let _e150 = phi_302_;
    if ((bitcast<u32>(_e150) & 2147483647u) > 2139095040u) {
        phi_319_ = _e150;
    } else {
        if (_e150 < 0f) {
            phi_318_ = 0f;
        } else {
            if (_e150 > 1f) {
                phi_317_ = 1f;
            } else {
                phi_317_ = _e150;
            }
            let _e157 = phi_317_;
            phi_318_ = _e157;
        }
        let _e159 = phi_318_;
        phi_319_ = _e159;
    }
    let _e161 = phi_319_;
    return _e161;
}

fn function_() {
    var local: f32;
    var phi_373_: bool;
    var phi_374_: bool;
    var phi_375_: bool;
    var phi_376_: bool;
    var phi_380_: bool;
    var phi_424_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_428_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_505_: bool;
    var phi_514_: bool;
    var phi_523_: bool;
    var phi_524_: bool;
    var phi_525_: bool;
    var phi_526_: bool;
    var phi_527_: bool;
    var phi_528_: bool;
    var phi_529_: bool;
    var phi_533_: bool;
    var phi_627_: f32;
    var phi_630_: f32;
    var phi_659_: f32;
    var phi_664_: f32;
    var phi_665_: bool;
    var phi_666_: f32;
    var phi_667_: bool;
    var phi_671_: f32;
    var phi_691_: f32;
    var phi_696_: f32;
    var phi_697_: bool;
    var phi_698_: f32;
    var phi_699_: bool;
    var phi_703_: f32;
    var phi_749_: i32;
    var phi_754_: i32;
    var phi_759_: i32;
    var phi_764_: i32;
    var phi_773_: i32;
    var phi_778_: i32;
    var phi_783_: i32;
    var phi_788_: i32;
    var phi_835_: bool;
    var phi_843_: bool;
    var phi_855_: bool;
    var phi_856_: bool;
    var phi_860_: f32;
    var phi_866_: f32;
    var phi_868_: evaluate_Verdict;
    var phi_873_: evaluate_Verdict;
    var phi_874_: evaluate_Verdict;

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
                phi_373_ = (_e72 == _e74);
                phi_374_ = false;
            } else {
                phi_373_ = bool();
                phi_374_ = true;
            }
            let _e77 = phi_373_;
            let _e79 = phi_374_;
            phi_375_ = _e77;
            phi_376_ = _e79;
        } else {
            phi_375_ = bool();
            phi_376_ = true;
        }
        let _e81 = phi_375_;
        let _e83 = phi_376_;
        if _e83 {
            phi_380_ = false;
        } else {
            phi_380_ = _e81;
        }
        let _e85 = phi_380_;
        if !(_e85) {
            let _e88 = samples.member[(0u + _e50.first_primitive)].normal;
            let _e90 = samples.member[(0u + _e50.first_primitive)].position;
            if ((((_e88.x * (_e59.x - (_e90.x * _e59.w))) + (_e88.y * (_e59.y - (_e90.y * _e59.w)))) + (_e88.z * (_e59.z - (_e90.z * _e59.w)))) > 0f) {
                let _e114 = samples.member[(0u + _e50.first_primitive)].flags;
                let _e122 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e128 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e122.unnamed.visibility, false), _e122.unnamed_1);
                phi_424_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e128.unnamed, ((_e114 & 1u) == 0u));
            } else {
                let _e137 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e143 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e137.unnamed.visibility, false), _e137.unnamed_1);
                phi_424_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e143.unnamed, true);
            }
            let _e148 = phi_424_;
            phi_428_ = _e148;
        } else {
            let _e154 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e160 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e154.unnamed.visibility, false), _e154.unnamed_1);
            phi_428_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e160.unnamed, true);
        }
        let _e165 = phi_428_;
        if _e165.unnamed_1 {
            phi_874_ = evaluate_Verdict(_e165.unnamed.visibility, _e165.unnamed.is_doubted);
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
                    phi_505_ = (_e204 <= 1f);
                } else {
                    phi_505_ = false;
                }
                let _e236 = phi_505_;
                if _e236 {
                    if (_e218 >= 0f) {
                        phi_514_ = (_e218 <= 1f);
                    } else {
                        phi_514_ = false;
                    }
                    let _e240 = phi_514_;
                    if _e240 {
                        if (_e231 >= 0f) {
                            phi_523_ = (_e231 <= 1f);
                        } else {
                            phi_523_ = false;
                        }
                        let _e244 = phi_523_;
                        phi_524_ = _e244;
                        phi_525_ = false;
                    } else {
                        phi_524_ = bool();
                        phi_525_ = true;
                    }
                    let _e246 = phi_524_;
                    let _e248 = phi_525_;
                    phi_526_ = _e246;
                    phi_527_ = _e248;
                } else {
                    phi_526_ = bool();
                    phi_527_ = true;
                }
                let _e250 = phi_526_;
                let _e252 = phi_527_;
                phi_528_ = _e250;
                phi_529_ = _e252;
            } else {
                phi_528_ = bool();
                phi_529_ = true;
            }
            let _e254 = phi_528_;
            let _e256 = phi_529_;
            if _e256 {
                phi_533_ = false;
            } else {
                phi_533_ = _e254;
            }
            let _e258 = phi_533_;
            if _e258 {
                if (0f > 0f) {
                    let _e261 = samples.member[(0u + _e50.first_primitive)].normal;
                    let _e263 = p.member.map_size;
                    let _e266 = p.member.projection.row_x;
                    let _e288 = p.member.projection.row_y;
                    let _e310 = p.member.projection.row_z;
                    let _e337 = ((abs(((((_e266.x * _e261.x) + (_e266.y * _e261.y)) + (_e266.z * _e261.z)) / (((_e266.x * _e266.x) + (_e266.y * _e266.y)) + (_e266.z * _e266.z)))) + abs(((((_e288.x * _e261.x) + (_e288.y * _e261.y)) + (_e288.z * _e261.z)) / (((_e288.x * _e288.x) + (_e288.y * _e288.y)) + (_e288.z * _e288.z))))) / (abs(((((_e310.x * _e261.x) + (_e310.y * _e261.y)) + (_e310.z * _e261.z)) / (((_e310.x * _e310.x) + (_e310.y * _e310.y)) + (_e310.z * _e310.z)))) * f32(_e263)));
                    if (_e337 < 0.002f) {
                        phi_627_ = _e337;
                    } else {
                        phi_627_ = 0.002f;
                    }
                    let _e340 = phi_627_;
                    phi_630_ = (_e231 - (0f * _e340));
                } else {
                    phi_630_ = _e231;
                }
                let _e344 = phi_630_;
                let _e346 = p.member.map_size;
                let _e347 = f32(_e346);
                let _e350 = ((_e204 * _e347) - 0.5f);
                let _e351 = ((_e218 * _e347) - 0.5f);
                if (_e350 > -8388608f) {
                    let _e363 = f32(select(0i, select(select(i32(_e350), i32(-2147483648), (_e350 < bitcast<f32>(3472883712u))), 2147483647i, (_e350 > bitcast<f32>(1325400063u))), (_e350 == _e350)));
                    if (_e363 > _e350) {
                        phi_659_ = 1f;
                    } else {
                        phi_659_ = 0f;
                    }
                    let _e366 = phi_659_;
                    if (_e350 < 8388608f) {
                        phi_664_ = (_e363 - _e366);
                        phi_665_ = false;
                    } else {
                        phi_664_ = f32();
                        phi_665_ = true;
                    }
                    let _e369 = phi_664_;
                    let _e371 = phi_665_;
                    phi_666_ = _e369;
                    phi_667_ = _e371;
                } else {
                    phi_666_ = f32();
                    phi_667_ = true;
                }
                let _e373 = phi_666_;
                let _e375 = phi_667_;
                if _e375 {
                    phi_671_ = _e350;
                } else {
                    phi_671_ = _e373;
                }
                let _e377 = phi_671_;
                if (_e351 > -8388608f) {
                    let _e389 = f32(select(0i, select(select(i32(_e351), i32(-2147483648), (_e351 < bitcast<f32>(3472883712u))), 2147483647i, (_e351 > bitcast<f32>(1325400063u))), (_e351 == _e351)));
                    if (_e389 > _e351) {
                        phi_691_ = 1f;
                    } else {
                        phi_691_ = 0f;
                    }
                    let _e392 = phi_691_;
                    if (_e351 < 8388608f) {
                        phi_696_ = (_e389 - _e392);
                        phi_697_ = false;
                    } else {
                        phi_696_ = f32();
                        phi_697_ = true;
                    }
                    let _e395 = phi_696_;
                    let _e397 = phi_697_;
                    phi_698_ = _e395;
                    phi_699_ = _e397;
                } else {
                    phi_698_ = f32();
                    phi_699_ = true;
                }
                let _e399 = phi_698_;
                let _e401 = phi_699_;
                if _e401 {
                    phi_703_ = _e351;
                } else {
                    phi_703_ = _e399;
                }
                let _e403 = phi_703_;
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
                    phi_749_ = _e414;
                } else {
                    phi_749_ = 0i;
                }
                let _e442 = phi_749_;
                if (_e423 > 0i) {
                    phi_754_ = _e423;
                } else {
                    phi_754_ = 0i;
                }
                let _e445 = phi_754_;
                if (_e442 < _e439) {
                    phi_759_ = _e442;
                } else {
                    phi_759_ = _e439;
                }
                let _e448 = phi_759_;
                if (_e445 < _e439) {
                    phi_764_ = _e445;
                } else {
                    phi_764_ = _e439;
                }
                let _e451 = phi_764_;
                let _e452 = bitcast<u32>(_e448);
                let _e454 = (_e414 + 1i);
                let _e455 = (_e423 + 1i);
                if (_e454 > 0i) {
                    phi_773_ = _e454;
                } else {
                    phi_773_ = 0i;
                }
                let _e458 = phi_773_;
                if (_e455 > 0i) {
                    phi_778_ = _e455;
                } else {
                    phi_778_ = 0i;
                }
                let _e461 = phi_778_;
                if (_e458 < _e439) {
                    phi_783_ = _e458;
                } else {
                    phi_783_ = _e439;
                }
                let _e464 = phi_783_;
                if (_e461 < _e439) {
                    phi_788_ = _e461;
                } else {
                    phi_788_ = _e439;
                }
                let _e467 = phi_788_;
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
                let _e495 = p.member.epsilon;
                if (_e493 <= _e495) {
                    phi_835_ = true;
                } else {
                    phi_835_ = (_e493 >= (1f - _e495));
                }
                let _e500 = phi_835_;
                if ((bitcast<u32>(_e493) & 2147483647u) > 2139095040u) {
                    phi_843_ = true;
                } else {
                    phi_843_ = !(_e500);
                }
                let _e506 = phi_843_;
                if _e506 {
                    if (_e493 > 0f) {
                        if (_e493 < 1f) {
                            phi_855_ = false;
                        } else {
                            phi_855_ = true;
                        }
                        let _e510 = phi_855_;
                        phi_856_ = _e510;
                    } else {
                        phi_856_ = true;
                    }
                    let _e512 = phi_856_;
                    if _e512 {
                        phi_860_ = 0.5f;
                    } else {
                        phi_860_ = _e493;
                    }
                    let _e514 = phi_860_;
                    phi_868_ = evaluate_Verdict(_e514, true);
                } else {
                    if (_e493 > 0.5f) {
                        phi_866_ = 1f;
                    } else {
                        phi_866_ = 0f;
                    }
                    let _e518 = phi_866_;
                    phi_868_ = evaluate_Verdict(_e518, false);
                }
                let _e521 = phi_868_;
                phi_873_ = evaluate_Verdict(_e521.visibility, _e521.is_doubted);
            } else {
                phi_873_ = evaluate_Verdict(0.5f, true);
            }
            let _e527 = phi_873_;
            phi_874_ = _e527;
        }
        let _e529 = phi_874_;
        if (_e50.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e50.first_primitive)] = _e529.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_vsm_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
