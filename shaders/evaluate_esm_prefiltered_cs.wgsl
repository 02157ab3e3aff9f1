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
    var phi_143_: lt_bvh_traverse_Tree;
    var phi_144_: bool;
    var phi_145_: lt_bvh_traverse_Tree;
    var phi_146_: bool;
    var phi_151_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_143_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_144_ = false;
        } else {
            phi_143_ = lt_bvh_traverse_Tree();
            phi_144_ = true;
        }
        let _e55 = phi_143_;
        let _e57 = phi_144_;
        phi_145_ = _e55;
        phi_146_ = _e57;
    } else {
        phi_145_ = lt_bvh_traverse_Tree();
        phi_146_ = true;
    }
    let _e59 = phi_145_;
    let _e61 = phi_146_;
    if _e61 {
        phi_151_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_151_ = _e59;
    }
    let _e66 = phi_151_;
    return lt_bvh_traverse_Tree(_e66.root, _e66.first_primitive);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_esm_Esm_clamped_exponent(param_4: ptr<function, f32>) -> f32 {
    var phi_177_: bool;
    var phi_181_: f32;
    var phi_182_: f32;

    let _e43 = (*param_4);
    if ((bitcast<u32>(_e43) & 2147483647u) > 2139095040u) {
        phi_182_ = _e43;
    } else {
        if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
            phi_177_ = true;
        } else {
            let _e50 = (84f < _e43);
            if _e50 {
            }
            phi_177_ = _e50;
        }
        let _e52 = phi_177_;
        if _e52 {
            phi_181_ = 84f;
        } else {
            phi_181_ = _e43;
        }
        let _e54 = phi_181_;
        phi_182_ = _e54;
    }
    let _e56 = phi_182_;
    return _e56;
}

fn lt_shaders_evaluate_to_light(param_5: vec3<f32>, param_6: vec4<f32>) -> vec3<f32> {
    return vec3<f32>((param_6.x - (param_5.x * param_6.w)), (param_6.y - (param_5.y * param_6.w)), (param_6.z - (param_5.z * param_6.w)));
}

fn lt_shaders_evaluate_quad_indices(param_7: i32, param_8: i32, param_9: u32) -> array<u32, 4> {
    var phi_210_: i32;
    var phi_215_: i32;
    var phi_220_: i32;
    var phi_225_: i32;
    var phi_234_: i32;
    var phi_239_: i32;
    var phi_244_: i32;
    var phi_249_: i32;

    let _e46 = (bitcast<i32>(param_9) - 1i);
    if (param_7 > 0i) {
        phi_210_ = param_7;
    } else {
        phi_210_ = 0i;
    }
    let _e49 = phi_210_;
    if (param_8 > 0i) {
        phi_215_ = param_8;
    } else {
        phi_215_ = 0i;
    }
    let _e52 = phi_215_;
    if (_e49 < _e46) {
        phi_220_ = _e49;
    } else {
        phi_220_ = _e46;
    }
    let _e55 = phi_220_;
    if (_e52 < _e46) {
        phi_225_ = _e52;
    } else {
        phi_225_ = _e46;
    }
    let _e58 = phi_225_;
    let _e59 = bitcast<u32>(_e55);
    let _e61 = (param_7 + 1i);
    let _e62 = (param_8 + 1i);
    if (_e61 > 0i) {
        phi_234_ = _e61;
    } else {
        phi_234_ = 0i;
    }
    let _e65 = phi_234_;
    if (_e62 > 0i) {
        phi_239_ = _e62;
    } else {
        phi_239_ = 0i;
    }
    let _e68 = phi_239_;
    if (_e65 < _e46) {
        phi_244_ = _e65;
    } else {
        phi_244_ = _e46;
    }
    let _e71 = phi_244_;
    if (_e68 < _e46) {
        phi_249_ = _e68;
    } else {
        phi_249_ = _e46;
    }
    let _e74 = phi_249_;
    let _e75 = bitcast<u32>(_e71);
    let _e77 = (bitcast<u32>(_e58) * param_9);
    let _e78 = (bitcast<u32>(_e74) * param_9);
    return array<u32, 4>((_e77 + _e59), (_e77 + _e75), (_e78 + _e59), (_e78 + _e75));
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_10: ptr<function, f32>, param_11: vec4<f32>, param_12: f32) -> f32 {
    var phi_640_: f32;
    var phi_641_: f32;
    var phi_642_: f32;
    var phi_669_: bool;
    var phi_673_: f32;
    var phi_674_: f32;
    var phi_691_: bool;
    var phi_695_: f32;
    var phi_696_: f32;
    var phi_737_: f32;
    var phi_753_: f32;
    var phi_754_: f32;
    var phi_755_: f32;

    if ((bitcast<u32>(param_12) & 2147483647u) > 2139095040u) {
        phi_642_ = param_12;
    } else {
        if (param_12 < 0f) {
            phi_641_ = 0f;
        } else {
            if (param_12 > 1f) {
                phi_640_ = 1f;
            } else {
                phi_640_ = param_12;
            }
            let _e51 = phi_640_;
            phi_641_ = _e51;
        }
        let _e53 = phi_641_;
        phi_642_ = _e53;
    }
    let _e55 = phi_642_;
    let _e57 = _lt_math_esm_Esm_clamped_exponent(param_10);
    let _e59 = (_e57 * (1f - _e55));
    if ((bitcast<u32>(_e59) & 2147483647u) > 2139095040u) {
        phi_737_ = _e59;
    } else {
        if ((bitcast<u32>(_e59) & 2147483647u) > 2139095040u) {
            phi_674_ = _e59;
        } else {
            if ((bitcast<u32>(-87f) & 2147483647u) > 2139095040u) {
                phi_669_ = true;
            } else {
                let _e69 = (-87f > _e59);
                if _e69 {
                }
                phi_669_ = _e69;
            }
            let _e71 = phi_669_;
            if _e71 {
                phi_673_ = -87f;
            } else {
                phi_673_ = _e59;
            }
            let _e73 = phi_673_;
            phi_674_ = _e73;
        }
        let _e75 = phi_674_;
        if ((bitcast<u32>(_e75) & 2147483647u) > 2139095040u) {
            phi_696_ = _e75;
        } else {
            if ((bitcast<u32>(88f) & 2147483647u) > 2139095040u) {
                phi_691_ = true;
            } else {
                let _e82 = (88f < _e75);
                if _e82 {
                }
                phi_691_ = _e82;
            }
            let _e84 = phi_691_;
            if _e84 {
                phi_695_ = 88f;
            } else {
                phi_695_ = _e75;
            }
            let _e86 = phi_695_;
            phi_696_ = _e86;
        }
        let _e88 = phi_696_;
        let _e91 = floor(((_e88 * 1.442695f) + 0.5f));
        let _e95 = ((_e88 - (_e91 * 0.69314575f)) - (_e91 * 0.0000014286068f));
        phi_737_ = ((((((((((((((((1f / 5040f) * _e95) + (1f / 720f)) * _e95) + (1f / 120f)) * _e95) + (1f / 24f)) * _e95) + (1f / 6f)) * _e95) + 0.5f) * _e95) + 1f) * _e95) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e91), i32(-2147483648), (_e91 < bitcast<f32>(3472883712u))), 2147483647i, (_e91 > bitcast<f32>(1325400063u))), (_e91 == _e91)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e131 = phi_737_;
    let _e132 = (param_11.x * _e131);
    if ((bitcast<u32>(_e132) & 2147483647u) > 2139095040u) {
        phi_755_ = _e132;
    } else {
        if (_e132 < 0f) {
            phi_754_ = 0f;
        } else {
            if (_e132 > 1f) {
                phi_753_ = 1f;
            } else {
                phi_753_ = _e132;
            }
            let _e139 = phi_753_;
            phi_754_ = _e139;
        }
        let _e141 = phi_754_;
        phi_755_ = _e141;
    }
    let _e143 = phi_755_;
    return _e143;
}

fn function_() {
    var local: f32;
    var phi_312_: bool;
    var phi_313_: bool;
    var phi_314_: bool;
    var phi_315_: bool;
    var phi_319_: bool;
    var phi_354_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_358_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_451_: bool;
    var phi_452_: bool;
    var phi_453_: bool;
    var phi_454_: bool;
    var phi_455_: bool;
    var phi_456_: bool;
    var phi_457_: bool;
    var phi_458_: bool;
    var phi_459_: bool;
    var phi_460_: bool;
    var phi_461_: bool;
    var phi_462_: bool;
    var phi_466_: bool;
    var phi_605_: evaluate_Verdict;
    var phi_606_: evaluate_Verdict;
    var phi_607_: bool;
    var phi_608_: evaluate_Verdict;
    var phi_609_: evaluate_Verdict;
    var phi_610_: bool;
    var phi_614_: evaluate_Verdict;

    let _e43 = id_1;
    let _e50 = arrayLength((&map.member));
    let _e56 = p.member.size[0u];
    let _e58 = p.member.size[1u];
    let _e59 = lt_shaders_entry_pixel_index(_e43, _e56, _e58);
    if (bitcast<i32>(_e59.root) != 0i) {
        if (_e59.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e68 = p.member.light;
        let _e71 = samples.member[(0u + _e59.first_primitive)].normal[0u];
        let _e73 = global[0u];
        if (_e71 == _e73) {
            let _e76 = samples.member[(0u + _e59.first_primitive)].normal[1u];
            let _e78 = global[1u];
            if (_e76 == _e78) {
                let _e81 = samples.member[(0u + _e59.first_primitive)].normal[2u];
                let _e83 = global[2u];
                phi_312_ = (_e81 == _e83);
                phi_313_ = false;
            } else {
                phi_312_ = bool();
                phi_313_ = true;
            }
            let _e86 = phi_312_;
            let _e88 = phi_313_;
            phi_314_ = _e86;
            phi_315_ = _e88;
        } else {
            phi_314_ = bool();
            phi_315_ = true;
        }
        let _e90 = phi_314_;
        let _e92 = phi_315_;
        if _e92 {
            phi_319_ = false;
        } else {
            phi_319_ = _e90;
        }
        let _e94 = phi_319_;
        if !(_e94) {
            let _e97 = samples.member[(0u + _e59.first_primitive)].normal;
            let _e99 = samples.member[(0u + _e59.first_primitive)].position;
            let _e100 = lt_shaders_evaluate_to_light(_e99, _e68);
            if ((((_e97.x * _e100.x) + (_e97.y * _e100.y)) + (_e97.z * _e100.z)) > 0f) {
                let _e114 = samples.member[(0u + _e59.first_primitive)].flags;
                let _e122 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e128 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e122.unnamed.visibility, false), _e122.unnamed_1);
                phi_354_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e128.unnamed, ((_e114 & 1u) == 0u));
            } else {
                let _e137 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e143 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e137.unnamed.visibility, false), _e137.unnamed_1);
                phi_354_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e143.unnamed, true);
            }
            let _e148 = phi_354_;
            phi_358_ = _e148;
        } else {
            let _e154 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e160 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e154.unnamed.visibility, false), _e154.unnamed_1);
            phi_358_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e160.unnamed, true);
        }
        let _e165 = phi_358_;
        if _e165.unnamed_1 {
            phi_608_ = evaluate_Verdict(_e165.unnamed.visibility, _e165.unnamed.is_doubted);
            phi_609_ = evaluate_Verdict();
            phi_610_ = true;
        } else {
            let _e173 = samples.member[(0u + _e59.first_primitive)].position;
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
                    if (_e204 <= 1f) {
                        if (_e218 >= 0f) {
                            if (_e218 <= 1f) {
                                if (_e231 >= 0f) {
                                    phi_451_ = (_e231 <= 1f);
                                    phi_452_ = false;
                                } else {
                                    phi_451_ = bool();
                                    phi_452_ = true;
                                }
                                let _e240 = phi_451_;
                                let _e242 = phi_452_;
                                phi_453_ = _e240;
                                phi_454_ = _e242;
                            } else {
                                phi_453_ = bool();
                                phi_454_ = true;
                            }
                            let _e244 = phi_453_;
                            let _e246 = phi_454_;
                            phi_455_ = _e244;
                            phi_456_ = _e246;
                        } else {
                            phi_455_ = bool();
                            phi_456_ = true;
                        }
                        let _e248 = phi_455_;
                        let _e250 = phi_456_;
                        phi_457_ = _e248;
                        phi_458_ = _e250;
                    } else {
                        phi_457_ = bool();
                        phi_458_ = true;
                    }
                    let _e252 = phi_457_;
                    let _e254 = phi_458_;
                    phi_459_ = _e252;
                    phi_460_ = _e254;
                } else {
                    phi_459_ = bool();
                    phi_460_ = true;
                }
                let _e256 = phi_459_;
                let _e258 = phi_460_;
                phi_461_ = _e256;
                phi_462_ = _e258;
            } else {
                phi_461_ = bool();
                phi_462_ = true;
            }
            let _e260 = phi_461_;
            let _e262 = phi_462_;
            if _e262 {
                phi_466_ = false;
            } else {
                phi_466_ = _e260;
            }
            let _e264 = phi_466_;
            if _e264 {
                let _e266 = p.member.map_size;
                let _e267 = f32(_e266);
                let _e270 = ((_e204 * _e267) - 0.5f);
                let _e271 = ((_e218 * _e267) - 0.5f);
                let _e272 = floor(_e270);
                let _e273 = floor(_e271);
                let _e274 = (_e270 - _e272);
                let _e275 = (_e271 - _e273);
                let _e296 = ((1f - _e274) * (1f - _e275));
                let _e298 = (_e274 * (1f - _e275));
                let _e300 = ((1f - _e274) * _e275);
                let _e301 = (_e274 * _e275);
                let _e303 = p.member.test;
                let _e304 = _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e303);
                let _e306 = p.member.map_size;
                local = _e304;
                let _e307 = lt_shaders_evaluate_quad_indices(select(0i, select(select(i32(_e272), i32(-2147483648), (_e272 < bitcast<f32>(3472883712u))), 2147483647i, (_e272 > bitcast<f32>(1325400063u))), (_e272 == _e272)), select(0i, select(select(i32(_e273), i32(-2147483648), (_e273 < bitcast<f32>(3472883712u))), 2147483647i, (_e273 > bitcast<f32>(1325400063u))), (_e273 == _e273)), _e306);
                if (_e307[0] < _e50) {
                } else {
                    return;
                }
                let _e312 = map.member[(0u + _e307[0])];
                if (_e307[1] < _e50) {
                } else {
                    return;
                }
                let _e325 = map.member[(0u + _e307[1])];
                if (_e307[2] < _e50) {
                } else {
                    return;
                }
                let _e342 = map.member[(0u + _e307[2])];
                if (_e307[3] < _e50) {
                } else {
                    return;
                }
                let _e359 = map.member[(0u + _e307[3])];
                let _e373 = _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local), vec4<f32>(((((_e312.x * _e296) + (_e325.x * _e298)) + (_e342.x * _e300)) + (_e359.x * _e301)), ((((_e312.y * _e296) + (_e325.y * _e298)) + (_e342.y * _e300)) + (_e359.y * _e301)), ((((_e312.z * _e296) + (_e325.z * _e298)) + (_e342.z * _e300)) + (_e359.z * _e301)), ((((_e312.w * _e296) + (_e325.w * _e298)) + (_e342.w * _e300)) + (_e359.w * _e301))), _e231);
                phi_605_ = evaluate_Verdict(_e373, false);
                phi_606_ = evaluate_Verdict();
                phi_607_ = false;
            } else {
                phi_605_ = evaluate_Verdict();
                phi_606_ = evaluate_Verdict(1f, false);
                phi_607_ = true;
            }
            let _e377 = phi_605_;
            let _e379 = phi_606_;
            let _e381 = phi_607_;
            phi_608_ = _e379;
            phi_609_ = _e377;
            phi_610_ = _e381;
        }
        let _e383 = phi_608_;
        let _e385 = phi_609_;
        let _e387 = phi_610_;
        if _e387 {
            phi_614_ = _e383;
        } else {
            phi_614_ = _e385;
        }
        let _e389 = phi_614_;
        if (_e59.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e59.first_primitive)] = _e389.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_esm_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
