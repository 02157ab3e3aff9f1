struct lt_math_LightProjection {
    row_x: vec4<f32>,
    row_y: vec4<f32>,
    row_z: vec4<f32>,
    row_w: vec4<f32>,
}

struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_17 {
    member: array<abi_Sample>,
}

struct type_21 {
    member: array<f32>,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
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

struct type_29 {
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

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_17;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_29;
@group(0) @binding(2) 
var<storage> map: type_21;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_21;

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
    var phi_751_: f32;
    var phi_752_: f32;
    var phi_753_: f32;
    var phi_770_: f32;
    var phi_771_: f32;
    var phi_772_: f32;

    let _e37 = (*param_3);
    let _e38 = (param_4.x + _e37);
    if ((bitcast<u32>(param_5) & 2147483647u) > 2139095040u) {
        phi_753_ = param_5;
    } else {
        if (param_5 < 0f) {
            phi_752_ = 0f;
        } else {
            if (param_5 > 1f) {
                phi_751_ = 1f;
            } else {
                phi_751_ = param_5;
            }
            let _e45 = phi_751_;
            phi_752_ = _e45;
        }
        let _e47 = phi_752_;
        phi_753_ = _e47;
    }
    let _e49 = phi_753_;
    if ((bitcast<u32>(_e38) & 2147483647u) > 2139095040u) {
        phi_772_ = _e38;
    } else {
        if ((bitcast<u32>(_e49) & 2147483647u) > 2139095040u) {
            phi_771_ = _e49;
        } else {
            if (_e38 < _e49) {
                phi_770_ = 0f;
            } else {
                phi_770_ = 1f;
            }
            let _e58 = phi_770_;
            phi_771_ = _e58;
        }
        let _e60 = phi_771_;
        phi_772_ = _e60;
    }
    let _e62 = phi_772_;
    return _e62;
}

fn _lt_math_sm_Sm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_6: f32) -> vec4<f32> {
    var phi_726_: f32;
    var phi_727_: f32;
    var phi_728_: f32;

    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_728_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_727_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_726_ = 1f;
            } else {
                phi_726_ = param_6;
            }
            let _e40 = phi_726_;
            phi_727_ = _e40;
        }
        let _e42 = phi_727_;
        phi_728_ = _e42;
    }
    let _e44 = phi_728_;
    return vec4<f32>(_e44, 0f, 0f, 0f);
}

fn _lt_math_sm_Sm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_7: ptr<function, f32>, param_8: vec4<f32>, param_9: vec4<f32>, param_10: f32) -> f32 {
    var phi_689_: f32;
    var phi_690_: f32;
    var phi_698_: f32;
    var phi_699_: f32;
    var phi_706_: f32;
    var phi_709_: f32;

    let _e43 = (((param_9.x + param_9.y) + param_9.z) + param_9.w);
    if ((bitcast<u32>(_e43) & 2147483647u) > 2139095040u) {
        phi_709_ = _e43;
    } else {
        if (param_9.y > param_9.x) {
            phi_689_ = param_8.y;
            phi_690_ = param_9.y;
        } else {
            phi_689_ = param_8.x;
            phi_690_ = param_9.x;
        }
        let _e54 = phi_689_;
        let _e56 = phi_690_;
        if (param_9.z > _e56) {
            phi_698_ = param_8.z;
            phi_699_ = param_9.z;
        } else {
            phi_698_ = _e54;
            phi_699_ = _e56;
        }
        let _e62 = phi_698_;
        let _e64 = phi_699_;
        if (param_9.w > _e64) {
            phi_706_ = param_8.w;
        } else {
            phi_706_ = _e62;
        }
        let _e69 = phi_706_;
        let _e70 = _lt_math_sm_Sm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(_e69);
        let _e71 = _lt_math_sm_Sm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_7, _e70, param_10);
        phi_709_ = _e71;
    }
    let _e73 = phi_709_;
    return _e73;
}

fn _lt_math_sm_Sm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_11: vec4<f32>, param_12: f32) -> f32 {
    return (param_11.x + (0.5f * param_12));
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
    var phi_440_: f32;
    var phi_469_: f32;
    var phi_474_: f32;
    var phi_475_: bool;
    var phi_476_: f32;
    var phi_477_: bool;
    var phi_481_: f32;
    var phi_501_: f32;
    var phi_506_: f32;
    var phi_507_: bool;
    var phi_508_: f32;
    var phi_509_: bool;
    var phi_513_: f32;
    var phi_559_: i32;
    var phi_564_: i32;
    var phi_569_: i32;
    var phi_574_: i32;
    var phi_583_: i32;
    var phi_588_: i32;
    var phi_593_: i32;
    var phi_598_: i32;
    var phi_639_: evaluate_Verdict;
    var phi_640_: evaluate_Verdict;
    var phi_641_: bool;
    var phi_642_: evaluate_Verdict;
    var phi_643_: evaluate_Verdict;
    var phi_644_: bool;
    var phi_648_: evaluate_Verdict;

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
            phi_642_ = evaluate_Verdict(_e165.unnamed.visibility, _e165.unnamed.is_doubted);
            phi_643_ = evaluate_Verdict();
            phi_644_ = true;
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
                let _e260 = samples.member[(0u + _e50.first_primitive)].normal;
                let _e262 = p.member.map_size;
                let _e265 = p.member.projection.row_x;
                let _e287 = p.member.projection.row_y;
                let _e309 = p.member.projection.row_z;
                let _e336 = ((abs(((((_e265.x * _e260.x) + (_e265.y * _e260.y)) + (_e265.z * _e260.z)) / (((_e265.x * _e265.x) + (_e265.y * _e265.y)) + (_e265.z * _e265.z)))) + abs(((((_e287.x * _e260.x) + (_e287.y * _e260.y)) + (_e287.z * _e260.z)) / (((_e287.x * _e287.x) + (_e287.y * _e287.y)) + (_e287.z * _e287.z))))) / (abs(((((_e309.x * _e260.x) + (_e309.y * _e260.y)) + (_e309.z * _e260.z)) / (((_e309.x * _e309.x) + (_e309.y * _e309.y)) + (_e309.z * _e309.z)))) * f32(_e262)));
                if (_e336 < 0.002f) {
                    phi_440_ = _e336;
                } else {
                    phi_440_ = 0.002f;
                }
                let _e339 = phi_440_;
                let _e341 = p.member.map_size;
                let _e342 = f32(_e341);
                let _e345 = ((_e204 * _e342) - 0.5f);
                let _e346 = ((_e218 * _e342) - 0.5f);
                if (_e345 > -8388608f) {
                    let _e358 = f32(select(0i, select(select(i32(_e345), i32(-2147483648), (_e345 < bitcast<f32>(3472883712u))), 2147483647i, (_e345 > bitcast<f32>(1325400063u))), (_e345 == _e345)));
                    if (_e358 > _e345) {
                        phi_469_ = 1f;
                    } else {
                        phi_469_ = 0f;
                    }
                    let _e361 = phi_469_;
                    if (_e345 < 8388608f) {
                        phi_474_ = (_e358 - _e361);
                        phi_475_ = false;
                    } else {
                        phi_474_ = f32();
                        phi_475_ = true;
                    }
                    let _e364 = phi_474_;
                    let _e366 = phi_475_;
                    phi_476_ = _e364;
                    phi_477_ = _e366;
                } else {
                    phi_476_ = f32();
                    phi_477_ = true;
                }
                let _e368 = phi_476_;
                let _e370 = phi_477_;
                if _e370 {
                    phi_481_ = _e345;
                } else {
                    phi_481_ = _e368;
                }
                let _e372 = phi_481_;
                if (_e346 > -8388608f) {
                    let _e384 = f32(select(0i, select(select(i32(_e346), i32(-2147483648), (_e346 < bitcast<f32>(3472883712u))), 2147483647i, (_e346 > bitcast<f32>(1325400063u))), (_e346 == _e346)));
                    if (_e384 > _e346) {
                        phi_501_ = 1f;
                    } else {
                        phi_501_ = 0f;
                    }
                    let _e387 = phi_501_;
                    if (_e346 < 8388608f) {
                        phi_506_ = (_e384 - _e387);
                        phi_507_ = false;
                    } else {
                        phi_506_ = f32();
                        phi_507_ = true;
                    }
                    let _e390 = phi_506_;
                    let _e392 = phi_507_;
                    phi_508_ = _e390;
                    phi_509_ = _e392;
                } else {
                    phi_508_ = f32();
                    phi_509_ = true;
                }
                let _e394 = phi_508_;
                let _e396 = phi_509_;
                if _e396 {
                    phi_513_ = _e346;
                } else {
                    phi_513_ = _e394;
                }
                let _e398 = phi_513_;
                let _e399 = (_e345 - _e372);
                let _e400 = (_e346 - _e398);
                let _e409 = select(0i, select(select(i32(_e372), i32(-2147483648), (_e372 < bitcast<f32>(3472883712u))), 2147483647i, (_e372 > bitcast<f32>(1325400063u))), (_e372 == _e372));
                let _e418 = select(0i, select(select(i32(_e398), i32(-2147483648), (_e398 < bitcast<f32>(3472883712u))), 2147483647i, (_e398 > bitcast<f32>(1325400063u))), (_e398 == _e398));
                let _e429 = p.member.test;
                let _e430 = _lt_math_sm_Sm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e429, _e339);
                let _e432 = p.member.map_size;
                local = _e430;
                let _e434 = (bitcast<i32>(_e432) - 1i);
                if (_e409 > 0i) {
                    phi_559_ = _e409;
                } else {
                    phi_559_ = 0i;
                }
                let _e437 = phi_559_;
                if (_e418 > 0i) {
                    phi_564_ = _e418;
                } else {
                    phi_564_ = 0i;
                }
                let _e440 = phi_564_;
                if (_e437 < _e434) {
                    phi_569_ = _e437;
                } else {
                    phi_569_ = _e434;
                }
                let _e443 = phi_569_;
                if (_e440 < _e434) {
                    phi_574_ = _e440;
                } else {
                    phi_574_ = _e434;
                }
                let _e446 = phi_574_;
                let _e447 = bitcast<u32>(_e443);
                let _e449 = (_e409 + 1i);
                let _e450 = (_e418 + 1i);
                if (_e449 > 0i) {
                    phi_583_ = _e449;
                } else {
                    phi_583_ = 0i;
                }
                let _e453 = phi_583_;
                if (_e450 > 0i) {
                    phi_588_ = _e450;
                } else {
                    phi_588_ = 0i;
                }
                let _e456 = phi_588_;
                if (_e453 < _e434) {
                    phi_593_ = _e453;
                } else {
                    phi_593_ = _e434;
                }
                let _e459 = phi_593_;
                if (_e456 < _e434) {
                    phi_598_ = _e456;
                } else {
                    phi_598_ = _e434;
                }
                let _e462 = phi_598_;
                let _e463 = bitcast<u32>(_e459);
                let _e465 = (bitcast<u32>(_e446) * _e432);
                let _e466 = (bitcast<u32>(_e462) * _e432);
                let _e467 = (_e465 + _e447);
                let _e468 = (_e465 + _e463);
                let _e469 = (_e466 + _e447);
                let _e470 = (_e466 + _e463);
                if (_e467 < _e41) {
                } else {
                    return;
                }
                let _e474 = map.member[(0u + _e467)];
                if (_e468 < _e41) {
                } else {
                    return;
                }
                let _e478 = map.member[(0u + _e468)];
                if (_e469 < _e41) {
                } else {
                    return;
                }
                let _e482 = map.member[(0u + _e469)];
                if (_e470 < _e41) {
                } else {
                    return;
                }
                let _e486 = map.member[(0u + _e470)];
                let _e488 = _lt_math_sm_Sm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e474, _e478, _e482, _e486), vec4<f32>(((1f - _e399) * (1f - _e400)), (_e399 * (1f - _e400)), ((1f - _e399) * _e400), (_e399 * _e400)), _e231);
                phi_639_ = evaluate_Verdict(_e488, false);
                phi_640_ = evaluate_Verdict();
                phi_641_ = false;
            } else {
                phi_639_ = evaluate_Verdict();
                phi_640_ = evaluate_Verdict(1f, false);
                phi_641_ = true;
            }
            let _e492 = phi_639_;
            let _e494 = phi_640_;
            let _e496 = phi_641_;
            phi_642_ = _e494;
            phi_643_ = _e492;
            phi_644_ = _e496;
        }
        let _e498 = phi_642_;
        let _e500 = phi_643_;
        let _e502 = phi_644_;
        if _e502 {
            phi_648_ = _e498;
        } else {
            phi_648_ = _e500;
        }
        let _e504 = phi_648_;
        if (_e50.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e50.first_primitive)] = _e504.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_sm_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
