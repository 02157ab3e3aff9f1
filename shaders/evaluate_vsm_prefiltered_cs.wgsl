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

struct type_20 {
    member: array<abi_Sample>,
}

struct type_24 {
    member: array<f32>,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
}

struct type_32 {
    member: array<vec4<f32>>,
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

struct type_35 {
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
var<storage> samples: type_20;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_35;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_24;
@group(0) @binding(2) 
var<storage> map: type_32;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_130_: lt_bvh_traverse_Tree;
    var phi_131_: bool;
    var phi_132_: lt_bvh_traverse_Tree;
    var phi_133_: bool;
    var phi_138_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_130_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_131_ = false;
        } else {
            phi_130_ = lt_bvh_traverse_Tree();
            phi_131_ = true;
        }
        let _e43 = phi_130_;
        let _e45 = phi_131_;
        phi_132_ = _e43;
        phi_133_ = _e45;
    } else {
        phi_132_ = lt_bvh_traverse_Tree();
        phi_133_ = true;
    }
    let _e47 = phi_132_;
    let _e49 = phi_133_;
    if _e49 {
        phi_138_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_138_ = _e47;
    }
    let _e54 = phi_138_;
    return lt_bvh_traverse_Tree(_e54.root, _e54.first_primitive);
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn lt_shaders_evaluate_to_light(param_4: vec3<f32>, param_5: vec4<f32>) -> vec3<f32> {
    return vec3<f32>((param_5.x - (param_4.x * param_5.w)), (param_5.y - (param_4.y * param_5.w)), (param_5.z - (param_4.z * param_5.w)));
}

fn lt_shaders_evaluate_quad_indices(param_6: i32, param_7: i32, param_8: u32) -> array<u32, 4> {
    var phi_172_: i32;
    var phi_177_: i32;
    var phi_182_: i32;
    var phi_187_: i32;
    var phi_196_: i32;
    var phi_201_: i32;
    var phi_206_: i32;
    var phi_211_: i32;

    let _e34 = (bitcast<i32>(param_8) - 1i);
    if (param_6 > 0i) {
        phi_172_ = param_6;
    } else {
        phi_172_ = 0i;
    }
    let _e37 = phi_172_;
    if (param_7 > 0i) {
        phi_177_ = param_7;
    } else {
        phi_177_ = 0i;
    }
    let _e40 = phi_177_;
    if (_e37 < _e34) {
        phi_182_ = _e37;
    } else {
        phi_182_ = _e34;
    }
    let _e43 = phi_182_;
    if (_e40 < _e34) {
        phi_187_ = _e40;
    } else {
        phi_187_ = _e34;
    }
    let _e46 = phi_187_;
    let _e47 = bitcast<u32>(_e43);
    let _e49 = (param_6 + 1i);
    let _e50 = (param_7 + 1i);
    if (_e49 > 0i) {
        phi_196_ = _e49;
    } else {
        phi_196_ = 0i;
    }
    let _e53 = phi_196_;
    if (_e50 > 0i) {
        phi_201_ = _e50;
    } else {
        phi_201_ = 0i;
    }
    let _e56 = phi_201_;
    if (_e53 < _e34) {
        phi_206_ = _e53;
    } else {
        phi_206_ = _e34;
    }
    let _e59 = phi_206_;
    if (_e56 < _e34) {
        phi_211_ = _e56;
    } else {
        phi_211_ = _e34;
    }
    let _e62 = phi_211_;
    let _e63 = bitcast<u32>(_e59);
    let _e65 = (bitcast<u32>(_e46) * param_8);
    let _e66 = (bitcast<u32>(_e62) * param_8);
    return array<u32, 4>((_e65 + _e47), (_e65 + _e63), (_e66 + _e47), (_e66 + _e63));
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_9: ptr<function, f32>, param_10: vec4<f32>, param_11: f32) -> f32 {
    var phi_602_: f32;
    var phi_603_: f32;
    var phi_604_: f32;
    var phi_627_: bool;
    var phi_631_: f32;
    var phi_632_: f32;
    var phi_649_: bool;
    var phi_653_: f32;
    var phi_654_: f32;
    var phi_666_: bool;
    var phi_673_: f32;
    var phi_688_: f32;
    var phi_689_: f32;
    var phi_690_: f32;

    if ((bitcast<u32>(param_11) & 2147483647u) > 2139095040u) {
        phi_604_ = param_11;
    } else {
        if (param_11 < 0f) {
            phi_603_ = 0f;
        } else {
            if (param_11 > 1f) {
                phi_602_ = 1f;
            } else {
                phi_602_ = param_11;
            }
            let _e39 = phi_602_;
            phi_603_ = _e39;
        }
        let _e41 = phi_603_;
        phi_604_ = _e41;
    }
    let _e43 = phi_604_;
    let _e46 = (*param_9);
    let _e48 = (param_10.y - (param_10.x * param_10.x));
    let _e49 = (0.00000047683716f * param_10.y);
    if ((bitcast<u32>(_e46) & 2147483647u) > 2139095040u) {
        phi_632_ = _e46;
    } else {
        if ((bitcast<u32>(_e49) & 2147483647u) > 2139095040u) {
            phi_627_ = true;
        } else {
            let _e56 = (_e49 > _e46);
            if _e56 {
            }
            phi_627_ = _e56;
        }
        let _e58 = phi_627_;
        if _e58 {
            phi_631_ = _e49;
        } else {
            phi_631_ = _e46;
        }
        let _e60 = phi_631_;
        phi_632_ = _e60;
    }
    let _e62 = phi_632_;
    if ((bitcast<u32>(_e48) & 2147483647u) > 2139095040u) {
        phi_654_ = _e48;
    } else {
        if ((bitcast<u32>(_e62) & 2147483647u) > 2139095040u) {
            phi_649_ = true;
        } else {
            let _e69 = (_e62 > _e48);
            if _e69 {
            }
            phi_649_ = _e69;
        }
        let _e71 = phi_649_;
        if _e71 {
            phi_653_ = _e62;
        } else {
            phi_653_ = _e48;
        }
        let _e73 = phi_653_;
        phi_654_ = _e73;
    }
    let _e75 = phi_654_;
    let _e76 = (_e43 - param_10.x);
    if (_e76 <= 0f) {
        let _e80 = ((bitcast<u32>(_e75) & 2147483647u) > 2139095040u);
        if _e80 {
        }
        phi_666_ = _e80;
    } else {
        phi_666_ = true;
    }
    let _e82 = phi_666_;
    if _e82 {
        phi_673_ = (_e75 / (_e75 + (_e76 * _e76)));
    } else {
        phi_673_ = 1f;
    }
    let _e87 = phi_673_;
    if ((bitcast<u32>(_e87) & 2147483647u) > 2139095040u) {
        phi_690_ = _e87;
    } else {
        if (_e87 < 0f) {
            phi_689_ = 0f;
        } else {
            if (_e87 > 1f) {
                phi_688_ = 1f;
            } else {
                phi_688_ = _e87;
            }
            let _e94 = phi_688_;
            phi_689_ = _e94;
        }
        let _e96 = phi_689_;
        phi_690_ = _e96;
    }
    let _e98 = phi_690_;
    return _e98;
}

fn function_() {
    var local: f32;
    var phi_274_: bool;
    var phi_275_: bool;
    var phi_276_: bool;
    var phi_277_: bool;
    var phi_281_: bool;
    var phi_316_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_320_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_413_: bool;
    var phi_414_: bool;
    var phi_415_: bool;
    var phi_416_: bool;
    var phi_417_: bool;
    var phi_418_: bool;
    var phi_419_: bool;
    var phi_420_: bool;
    var phi_421_: bool;
    var phi_422_: bool;
    var phi_423_: bool;
    var phi_424_: bool;
    var phi_428_: bool;
    var phi_567_: evaluate_Verdict;
    var phi_568_: evaluate_Verdict;
    var phi_569_: bool;
    var phi_570_: evaluate_Verdict;
    var phi_571_: evaluate_Verdict;
    var phi_572_: bool;
    var phi_576_: evaluate_Verdict;

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
                phi_274_ = (_e69 == _e71);
                phi_275_ = false;
            } else {
                phi_274_ = bool();
                phi_275_ = true;
            }
            let _e74 = phi_274_;
            let _e76 = phi_275_;
            phi_276_ = _e74;
            phi_277_ = _e76;
        } else {
            phi_276_ = bool();
            phi_277_ = true;
        }
        let _e78 = phi_276_;
        let _e80 = phi_277_;
        if _e80 {
            phi_281_ = false;
        } else {
            phi_281_ = _e78;
        }
        let _e82 = phi_281_;
        if !(_e82) {
            let _e85 = samples.member[(0u + _e47.first_primitive)].normal;
            let _e87 = samples.member[(0u + _e47.first_primitive)].position;
            let _e88 = lt_shaders_evaluate_to_light(_e87, _e56);
            if ((((_e85.x * _e88.x) + (_e85.y * _e88.y)) + (_e85.z * _e88.z)) > 0f) {
                let _e102 = samples.member[(0u + _e47.first_primitive)].flags;
                let _e110 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e116 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e110.unnamed.visibility, false), _e110.unnamed_1);
                phi_316_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e116.unnamed, ((_e102 & 1u) == 0u));
            } else {
                let _e125 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e131 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e125.unnamed.visibility, false), _e125.unnamed_1);
                phi_316_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e131.unnamed, true);
            }
            let _e136 = phi_316_;
            phi_320_ = _e136;
        } else {
            let _e142 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e148 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e142.unnamed.visibility, false), _e142.unnamed_1);
            phi_320_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e148.unnamed, true);
        }
        let _e153 = phi_320_;
        if _e153.unnamed_1 {
            phi_570_ = evaluate_Verdict(_e153.unnamed.visibility, _e153.unnamed.is_doubted);
            phi_571_ = evaluate_Verdict();
            phi_572_ = true;
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
                                    phi_413_ = (_e219 <= 1f);
                                    phi_414_ = false;
                                } else {
                                    phi_413_ = bool();
                                    phi_414_ = true;
                                }
                                let _e228 = phi_413_;
                                let _e230 = phi_414_;
                                phi_415_ = _e228;
                                phi_416_ = _e230;
                            } else {
                                phi_415_ = bool();
                                phi_416_ = true;
                            }
                            let _e232 = phi_415_;
                            let _e234 = phi_416_;
                            phi_417_ = _e232;
                            phi_418_ = _e234;
                        } else {
                            phi_417_ = bool();
                            phi_418_ = true;
                        }
                        let _e236 = phi_417_;
                        let _e238 = phi_418_;
                        phi_419_ = _e236;
                        phi_420_ = _e238;
                    } else {
                        phi_419_ = bool();
                        phi_420_ = true;
                    }
                    let _e240 = phi_419_;
                    let _e242 = phi_420_;
                    phi_421_ = _e240;
                    phi_422_ = _e242;
                } else {
                    phi_421_ = bool();
                    phi_422_ = true;
                }
                let _e244 = phi_421_;
                let _e246 = phi_422_;
                phi_423_ = _e244;
                phi_424_ = _e246;
            } else {
                phi_423_ = bool();
                phi_424_ = true;
            }
            let _e248 = phi_423_;
            let _e250 = phi_424_;
            if _e250 {
                phi_428_ = false;
            } else {
                phi_428_ = _e248;
            }
            let _e252 = phi_428_;
            if _e252 {
                let _e254 = p.member.map_size;
                let _e255 = f32(_e254);
                let _e258 = ((_e192 * _e255) - 0.5f);
                let _e259 = ((_e206 * _e255) - 0.5f);
                let _e260 = floor(_e258);
                let _e261 = floor(_e259);
                let _e262 = (_e258 - _e260);
                let _e263 = (_e259 - _e261);
                let _e284 = ((1f - _e262) * (1f - _e263));
                let _e286 = (_e262 * (1f - _e263));
                let _e288 = ((1f - _e262) * _e263);
                let _e289 = (_e262 * _e263);
                let _e291 = p.member.test;
                let _e292 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e291);
                let _e294 = p.member.map_size;
                local = _e292;
                let _e295 = lt_shaders_evaluate_quad_indices(select(0i, select(select(i32(_e260), i32(-2147483648), (_e260 < bitcast<f32>(3472883712u))), 2147483647i, (_e260 > bitcast<f32>(1325400063u))), (_e260 == _e260)), select(0i, select(select(i32(_e261), i32(-2147483648), (_e261 < bitcast<f32>(3472883712u))), 2147483647i, (_e261 > bitcast<f32>(1325400063u))), (_e261 == _e261)), _e294);
                if (_e295[0] < _e38) {
                } else {
                    return;
                }
                let _e300 = map.member[(0u + _e295[0])];
                if (_e295[1] < _e38) {
                } else {
                    return;
                }
                let _e313 = map.member[(0u + _e295[1])];
                if (_e295[2] < _e38) {
                } else {
                    return;
                }
                let _e330 = map.member[(0u + _e295[2])];
                if (_e295[3] < _e38) {
                } else {
                    return;
                }
                let _e347 = map.member[(0u + _e295[3])];
                let _e361 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local), vec4<f32>(((((_e300.x * _e284) + (_e313.x * _e286)) + (_e330.x * _e288)) + (_e347.x * _e289)), ((((_e300.y * _e284) + (_e313.y * _e286)) + (_e330.y * _e288)) + (_e347.y * _e289)), ((((_e300.z * _e284) + (_e313.z * _e286)) + (_e330.z * _e288)) + (_e347.z * _e289)), ((((_e300.w * _e284) + (_e313.w * _e286)) + (_e330.w * _e288)) + (_e347.w * _e289))), _e219);
                phi_567_ = evaluate_Verdict(_e361, false);
                phi_568_ = evaluate_Verdict();
                phi_569_ = false;
            } else {
                phi_567_ = evaluate_Verdict();
                phi_568_ = evaluate_Verdict(1f, false);
                phi_569_ = true;
            }
            let _e365 = phi_567_;
            let _e367 = phi_568_;
            let _e369 = phi_569_;
            phi_570_ = _e367;
            phi_571_ = _e365;
            phi_572_ = _e369;
        }
        let _e371 = phi_570_;
        let _e373 = phi_571_;
        let _e375 = phi_572_;
        if _e375 {
            phi_576_ = _e371;
        } else {
            phi_576_ = _e373;
        }
        let _e377 = phi_576_;
        if (_e47.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e47.first_primitive)] = _e377.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_vsm_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
