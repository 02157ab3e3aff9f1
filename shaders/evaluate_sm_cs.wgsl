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

struct type_19 {
    member: array<abi_Sample>,
}

struct type_23 {
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

struct type_30 {
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
var<storage> samples: type_19;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_30;
@group(0) @binding(2) 
var<storage> map: type_23;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_23;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_128_: lt_bvh_traverse_Tree;
    var phi_129_: bool;
    var phi_130_: lt_bvh_traverse_Tree;
    var phi_131_: bool;
    var phi_136_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_128_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_129_ = false;
        } else {
            phi_128_ = lt_bvh_traverse_Tree();
            phi_129_ = true;
        }
        let _e43 = phi_128_;
        let _e45 = phi_129_;
        phi_130_ = _e43;
        phi_131_ = _e45;
    } else {
        phi_130_ = lt_bvh_traverse_Tree();
        phi_131_ = true;
    }
    let _e47 = phi_130_;
    let _e49 = phi_131_;
    if _e49 {
        phi_136_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_136_ = _e47;
    }
    let _e54 = phi_136_;
    return lt_bvh_traverse_Tree(_e54.root, _e54.first_primitive);
}

fn lt_shaders_evaluate_to_light(param_3: vec3<f32>, param_4: vec4<f32>) -> vec3<f32> {
    return vec3<f32>((param_4.x - (param_3.x * param_4.w)), (param_4.y - (param_3.y * param_4.w)), (param_4.z - (param_3.z * param_4.w)));
}

fn _lt_math_sm_Sm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_5: ptr<function, f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_713_: f32;
    var phi_714_: f32;
    var phi_715_: f32;
    var phi_732_: f32;
    var phi_733_: f32;
    var phi_734_: f32;

    let _e34 = (*param_5);
    let _e35 = (param_6.x + _e34);
    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_715_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_714_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_713_ = 1f;
            } else {
                phi_713_ = param_7;
            }
            let _e42 = phi_713_;
            phi_714_ = _e42;
        }
        let _e44 = phi_714_;
        phi_715_ = _e44;
    }
    let _e46 = phi_715_;
    if ((bitcast<u32>(_e35) & 2147483647u) > 2139095040u) {
        phi_734_ = _e35;
    } else {
        if ((bitcast<u32>(_e46) & 2147483647u) > 2139095040u) {
            phi_733_ = _e46;
        } else {
            if (_e35 < _e46) {
                phi_732_ = 0f;
            } else {
                phi_732_ = 1f;
            }
            let _e55 = phi_732_;
            phi_733_ = _e55;
        }
        let _e57 = phi_733_;
        phi_734_ = _e57;
    }
    let _e59 = phi_734_;
    return _e59;
}

fn _lt_math_sm_Sm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_8: f32) -> vec4<f32> {
    var phi_688_: f32;
    var phi_689_: f32;
    var phi_690_: f32;

    if ((bitcast<u32>(param_8) & 2147483647u) > 2139095040u) {
        phi_690_ = param_8;
    } else {
        if (param_8 < 0f) {
            phi_689_ = 0f;
        } else {
            if (param_8 > 1f) {
                phi_688_ = 1f;
            } else {
                phi_688_ = param_8;
            }
            let _e37 = phi_688_;
            phi_689_ = _e37;
        }
        let _e39 = phi_689_;
        phi_690_ = _e39;
    }
    let _e41 = phi_690_;
    return vec4<f32>(_e41, 0f, 0f, 0f);
}

fn _lt_math_sm_Sm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_9: ptr<function, f32>, param_10: vec4<f32>, param_11: vec4<f32>, param_12: f32) -> f32 {
    var phi_651_: f32;
    var phi_652_: f32;
    var phi_660_: f32;
    var phi_661_: f32;
    var phi_668_: f32;
    var phi_671_: f32;

    let _e40 = (((param_11.x + param_11.y) + param_11.z) + param_11.w);
    if ((bitcast<u32>(_e40) & 2147483647u) > 2139095040u) {
        phi_671_ = _e40;
    } else {
        if (param_11.y > param_11.x) {
            phi_651_ = param_10.y;
            phi_652_ = param_11.y;
        } else {
            phi_651_ = param_10.x;
            phi_652_ = param_11.x;
        }
        let _e51 = phi_651_;
        let _e53 = phi_652_;
        if (param_11.z > _e53) {
            phi_660_ = param_10.z;
            phi_661_ = param_11.z;
        } else {
            phi_660_ = _e51;
            phi_661_ = _e53;
        }
        let _e59 = phi_660_;
        let _e61 = phi_661_;
        if (param_11.w > _e61) {
            phi_668_ = param_10.w;
        } else {
            phi_668_ = _e59;
        }
        let _e66 = phi_668_;
        let _e67 = _lt_math_sm_Sm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(_e66);
        let _e68 = _lt_math_sm_Sm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_9, _e67, param_12);
        phi_671_ = _e68;
    }
    let _e70 = phi_671_;
    return _e70;
}

fn lt_shaders_evaluate_quad_indices(param_13: i32, param_14: i32, param_15: u32) -> array<u32, 4> {
    var phi_575_: i32;
    var phi_580_: i32;
    var phi_585_: i32;
    var phi_590_: i32;
    var phi_599_: i32;
    var phi_604_: i32;
    var phi_609_: i32;
    var phi_614_: i32;

    let _e34 = (bitcast<i32>(param_15) - 1i);
    if (param_13 > 0i) {
        phi_575_ = param_13;
    } else {
        phi_575_ = 0i;
    }
    let _e37 = phi_575_;
    if (param_14 > 0i) {
        phi_580_ = param_14;
    } else {
        phi_580_ = 0i;
    }
    let _e40 = phi_580_;
    if (_e37 < _e34) {
        phi_585_ = _e37;
    } else {
        phi_585_ = _e34;
    }
    let _e43 = phi_585_;
    if (_e40 < _e34) {
        phi_590_ = _e40;
    } else {
        phi_590_ = _e34;
    }
    let _e46 = phi_590_;
    let _e47 = bitcast<u32>(_e43);
    let _e49 = (param_13 + 1i);
    let _e50 = (param_14 + 1i);
    if (_e49 > 0i) {
        phi_599_ = _e49;
    } else {
        phi_599_ = 0i;
    }
    let _e53 = phi_599_;
    if (_e50 > 0i) {
        phi_604_ = _e50;
    } else {
        phi_604_ = 0i;
    }
    let _e56 = phi_604_;
    if (_e53 < _e34) {
        phi_609_ = _e53;
    } else {
        phi_609_ = _e34;
    }
    let _e59 = phi_609_;
    if (_e56 < _e34) {
        phi_614_ = _e56;
    } else {
        phi_614_ = _e34;
    }
    let _e62 = phi_614_;
    let _e63 = bitcast<u32>(_e59);
    let _e65 = (bitcast<u32>(_e46) * param_15);
    let _e66 = (bitcast<u32>(_e62) * param_15);
    return array<u32, 4>((_e65 + _e47), (_e65 + _e63), (_e66 + _e47), (_e66 + _e63));
}

fn _lt_math_sm_Sm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_16: vec4<f32>, param_17: f32) -> f32 {
    return (param_16.x + (0.5f * param_17));
}

fn function_() {
    var local: f32;
    var phi_210_: bool;
    var phi_211_: bool;
    var phi_212_: bool;
    var phi_213_: bool;
    var phi_217_: bool;
    var phi_252_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_256_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_349_: bool;
    var phi_350_: bool;
    var phi_351_: bool;
    var phi_352_: bool;
    var phi_353_: bool;
    var phi_354_: bool;
    var phi_355_: bool;
    var phi_356_: bool;
    var phi_357_: bool;
    var phi_358_: bool;
    var phi_359_: bool;
    var phi_360_: bool;
    var phi_364_: bool;
    var phi_454_: f32;
    var phi_542_: evaluate_Verdict;
    var phi_543_: evaluate_Verdict;
    var phi_544_: bool;
    var phi_545_: evaluate_Verdict;
    var phi_546_: evaluate_Verdict;
    var phi_547_: bool;
    var phi_551_: evaluate_Verdict;

    let _e31 = id_1;
    let _e38 = arrayLength((&map.member));
    let _e44 = p.member.size[0u];
    let _e46 = p.member.size[1u];
    let _e47 = lt_shaders_entry_pixel_index(_e31, _e44, _e46);
    if (bitcast<i32>(_e47.root) != 0i) {
        if (_e47.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e56 = p.member.light;
        let _e59 = samples.member[(0u + _e47.first_primitive)].normal[0u];
        let _e61 = global[0u];
        if (_e59 == _e61) {
            let _e64 = samples.member[(0u + _e47.first_primitive)].normal[1u];
            let _e66 = global[1u];
            if (_e64 == _e66) {
                let _e69 = samples.member[(0u + _e47.first_primitive)].normal[2u];
                let _e71 = global[2u];
                phi_210_ = (_e69 == _e71);
                phi_211_ = false;
            } else {
                phi_210_ = bool();
                phi_211_ = true;
            }
            let _e74 = phi_210_;
            let _e76 = phi_211_;
            phi_212_ = _e74;
            phi_213_ = _e76;
        } else {
            phi_212_ = bool();
            phi_213_ = true;
        }
        let _e78 = phi_212_;
        let _e80 = phi_213_;
        if _e80 {
            phi_217_ = false;
        } else {
            phi_217_ = _e78;
        }
        let _e82 = phi_217_;
        if !(_e82) {
            let _e85 = samples.member[(0u + _e47.first_primitive)].normal;
            let _e87 = samples.member[(0u + _e47.first_primitive)].position;
            let _e88 = lt_shaders_evaluate_to_light(_e87, _e56);
            if ((((_e85.x * _e88.x) + (_e85.y * _e88.y)) + (_e85.z * _e88.z)) > 0f) {
                let _e102 = samples.member[(0u + _e47.first_primitive)].flags;
                let _e110 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e116 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e110.unnamed.visibility, false), _e110.unnamed_1);
                phi_252_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e116.unnamed, ((_e102 & 1u) == 0u));
            } else {
                let _e125 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e131 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e125.unnamed.visibility, false), _e125.unnamed_1);
                phi_252_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e131.unnamed, true);
            }
            let _e136 = phi_252_;
            phi_256_ = _e136;
        } else {
            let _e142 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e148 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e142.unnamed.visibility, false), _e142.unnamed_1);
            phi_256_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e148.unnamed, true);
        }
        let _e153 = phi_256_;
        if _e153.unnamed_1 {
            phi_545_ = evaluate_Verdict(_e153.unnamed.visibility, _e153.unnamed.is_doubted);
            phi_546_ = evaluate_Verdict();
            phi_547_ = true;
        } else {
            let _e161 = samples.member[(0u + _e47.first_primitive)].position;
            let _e167 = p.member.projection.row_w;
            let _e178 = ((((_e167.x * _e161.x) + (_e167.y * _e161.y)) + (_e167.z * _e161.z)) + (_e167.w * 1f));
            let _e180 = p.member.projection.row_x;
            let _e192 = (((((_e180.x * _e161.x) + (_e180.y * _e161.y)) + (_e180.z * _e161.z)) + (_e180.w * 1f)) / _e178);
            let _e194 = p.member.projection.row_y;
            let _e206 = (((((_e194.x * _e161.x) + (_e194.y * _e161.y)) + (_e194.z * _e161.z)) + (_e194.w * 1f)) / _e178);
            let _e208 = p.member.projection.row_z;
            let _e219 = ((((_e208.x * _e161.x) + (_e208.y * _e161.y)) + (_e208.z * _e161.z)) + (_e208.w * 1f));
            if (_e178 > 0f) {
                if (_e192 >= 0f) {
                    if (_e192 <= 1f) {
                        if (_e206 >= 0f) {
                            if (_e206 <= 1f) {
                                if (_e219 >= 0f) {
                                    phi_349_ = (_e219 <= 1f);
                                    phi_350_ = false;
                                } else {
                                    phi_349_ = bool();
                                    phi_350_ = true;
                                }
                                let _e228 = phi_349_;
                                let _e230 = phi_350_;
                                phi_351_ = _e228;
                                phi_352_ = _e230;
                            } else {
                                phi_351_ = bool();
                                phi_352_ = true;
                            }
                            let _e232 = phi_351_;
                            let _e234 = phi_352_;
                            phi_353_ = _e232;
                            phi_354_ = _e234;
                        } else {
                            phi_353_ = bool();
                            phi_354_ = true;
                        }
                        let _e236 = phi_353_;
                        let _e238 = phi_354_;
                        phi_355_ = _e236;
                        phi_356_ = _e238;
                    } else {
                        phi_355_ = bool();
                        phi_356_ = true;
                    }
                    let _e240 = phi_355_;
                    let _e242 = phi_356_;
                    phi_357_ = _e240;
                    phi_358_ = _e242;
                } else {
                    phi_357_ = bool();
                    phi_358_ = true;
                }
                let _e244 = phi_357_;
                let _e246 = phi_358_;
                phi_359_ = _e244;
                phi_360_ = _e246;
            } else {
                phi_359_ = bool();
                phi_360_ = true;
            }
            let _e248 = phi_359_;
            let _e250 = phi_360_;
            if _e250 {
                phi_364_ = false;
            } else {
                phi_364_ = _e248;
            }
            let _e252 = phi_364_;
            if _e252 {
                let _e254 = samples.member[(0u + _e47.first_primitive)].normal;
                let _e256 = p.member.map_size;
                let _e259 = p.member.projection.row_x;
                let _e281 = p.member.projection.row_y;
                let _e303 = p.member.projection.row_z;
                let _e330 = ((abs(((((_e259.x * _e254.x) + (_e259.y * _e254.y)) + (_e259.z * _e254.z)) / (((_e259.x * _e259.x) + (_e259.y * _e259.y)) + (_e259.z * _e259.z)))) + abs(((((_e281.x * _e254.x) + (_e281.y * _e254.y)) + (_e281.z * _e254.z)) / (((_e281.x * _e281.x) + (_e281.y * _e281.y)) + (_e281.z * _e281.z))))) / (abs(((((_e303.x * _e254.x) + (_e303.y * _e254.y)) + (_e303.z * _e254.z)) / (((_e303.x * _e303.x) + (_e303.y * _e303.y)) + (_e303.z * _e303.z)))) * f32(_e256)));
                if (_e330 < 0.02f) {
                    phi_454_ = _e330;
                } else {
                    phi_454_ = 0.02f;
                }
                let _e333 = phi_454_;
                let _e335 = p.member.map_size;
                let _e336 = f32(_e335);
                let _e339 = ((_e192 * _e336) - 0.5f);
                let _e340 = ((_e206 * _e336) - 0.5f);
                let _e341 = floor(_e339);
                let _e342 = floor(_e340);
                let _e343 = (_e339 - _e341);
                let _e344 = (_e340 - _e342);
                let _e373 = p.member.test;
                let _e374 = _lt_math_sm_Sm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e373, _e333);
                let _e376 = p.member.map_size;
                local = _e374;
                let _e377 = lt_shaders_evaluate_quad_indices(select(0i, select(select(i32(_e341), i32(-2147483648), (_e341 < bitcast<f32>(3472883712u))), 2147483647i, (_e341 > bitcast<f32>(1325400063u))), (_e341 == _e341)), select(0i, select(select(i32(_e342), i32(-2147483648), (_e342 < bitcast<f32>(3472883712u))), 2147483647i, (_e342 > bitcast<f32>(1325400063u))), (_e342 == _e342)), _e376);
                if (_e377[0] < _e38) {
                } else {
                    return;
                }
                let _e382 = map.member[(0u + _e377[0])];
                if (_e377[1] < _e38) {
                } else {
                    return;
                }
                let _e387 = map.member[(0u + _e377[1])];
                if (_e377[2] < _e38) {
                } else {
                    return;
                }
                let _e392 = map.member[(0u + _e377[2])];
                if (_e377[3] < _e38) {
                } else {
                    return;
                }
                let _e397 = map.member[(0u + _e377[3])];
                let _e399 = _lt_math_sm_Sm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e382, _e387, _e392, _e397), vec4<f32>(((1f - _e343) * (1f - _e344)), (_e343 * (1f - _e344)), ((1f - _e343) * _e344), (_e343 * _e344)), _e219);
                phi_542_ = evaluate_Verdict(_e399, false);
                phi_543_ = evaluate_Verdict();
                phi_544_ = false;
            } else {
                phi_542_ = evaluate_Verdict();
                phi_543_ = evaluate_Verdict(1f, false);
                phi_544_ = true;
            }
            let _e403 = phi_542_;
            let _e405 = phi_543_;
            let _e407 = phi_544_;
            phi_545_ = _e405;
            phi_546_ = _e403;
            phi_547_ = _e407;
        }
        let _e409 = phi_545_;
        let _e411 = phi_546_;
        let _e413 = phi_547_;
        if _e413 {
            phi_551_ = _e409;
        } else {
            phi_551_ = _e411;
        }
        let _e415 = phi_551_;
        if (_e47.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e47.first_primitive)] = _e415.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_sm_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
