struct lt_math_LightProjection {
    row_x: vec4<f32>,
    row_y: vec4<f32>,
    row_z: vec4<f32>,
    row_w: vec4<f32>,
}

struct type_8 {
    member: array<u32>,
}

struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_25 {
    member: array<abi_Sample>,
}

struct type_29 {
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

struct type_37 {
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

struct type_44 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_25;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_37;
@group(0) @binding(2) 
var<storage> map: type_29;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_29;
var<private> local_2: u32;
@group(0) @binding(4) 
var<storage, read_write> list: type_44;
var<workgroup> shared_: array<atomic<u32>, 2>;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_150_: lt_bvh_traverse_Tree;
    var phi_151_: bool;
    var phi_152_: lt_bvh_traverse_Tree;
    var phi_153_: bool;
    var phi_158_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_150_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_151_ = false;
        } else {
            phi_150_ = lt_bvh_traverse_Tree();
            phi_151_ = true;
        }
        let _e48 = phi_150_;
        let _e50 = phi_151_;
        phi_152_ = _e48;
        phi_153_ = _e50;
    } else {
        phi_152_ = lt_bvh_traverse_Tree();
        phi_153_ = true;
    }
    let _e52 = phi_152_;
    let _e54 = phi_153_;
    if _e54 {
        phi_158_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_158_ = _e52;
    }
    let _e59 = phi_158_;
    return lt_bvh_traverse_Tree(_e59.root, _e59.first_primitive);
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_4: f32) -> vec4<f32> {
    var phi_181_: f32;
    var phi_182_: f32;
    var phi_183_: f32;

    if ((bitcast<u32>(param_4) & 2147483647u) > 2139095040u) {
        phi_183_ = param_4;
    } else {
        if (param_4 < 0f) {
            phi_182_ = 0f;
        } else {
            if (param_4 > 1f) {
                phi_181_ = 1f;
            } else {
                phi_181_ = param_4;
            }
            let _e42 = phi_181_;
            phi_182_ = _e42;
        }
        let _e44 = phi_182_;
        phi_183_ = _e44;
    }
    let _e46 = phi_183_;
    let _e47 = (_e46 * _e46);
    return vec4<f32>(_e46, _e47, (_e47 * _e46), (_e47 * _e47));
}

fn lt_shaders_evaluate_to_light(param_5: vec3<f32>, param_6: vec4<f32>) -> vec3<f32> {
    return vec3<f32>((param_6.x - (param_5.x * param_6.w)), (param_6.y - (param_5.y * param_6.w)), (param_6.z - (param_5.z * param_6.w)));
}

fn lt_shaders_evaluate_quad_indices(param_7: i32, param_8: i32, param_9: u32) -> array<u32, 4> {
    var phi_215_: i32;
    var phi_220_: i32;
    var phi_225_: i32;
    var phi_230_: i32;
    var phi_239_: i32;
    var phi_244_: i32;
    var phi_249_: i32;
    var phi_254_: i32;

    let _e39 = (bitcast<i32>(param_9) - 1i);
    if (param_7 > 0i) {
        phi_215_ = param_7;
    } else {
        phi_215_ = 0i;
    }
    let _e42 = phi_215_;
    if (param_8 > 0i) {
        phi_220_ = param_8;
    } else {
        phi_220_ = 0i;
    }
    let _e45 = phi_220_;
    if (_e42 < _e39) {
        phi_225_ = _e42;
    } else {
        phi_225_ = _e39;
    }
    let _e48 = phi_225_;
    if (_e45 < _e39) {
        phi_230_ = _e45;
    } else {
        phi_230_ = _e39;
    }
    let _e51 = phi_230_;
    let _e52 = bitcast<u32>(_e48);
    let _e54 = (param_7 + 1i);
    let _e55 = (param_8 + 1i);
    if (_e54 > 0i) {
        phi_239_ = _e54;
    } else {
        phi_239_ = 0i;
    }
    let _e58 = phi_239_;
    if (_e55 > 0i) {
        phi_244_ = _e55;
    } else {
        phi_244_ = 0i;
    }
    let _e61 = phi_244_;
    if (_e58 < _e39) {
        phi_249_ = _e58;
    } else {
        phi_249_ = _e39;
    }
    let _e64 = phi_249_;
    if (_e61 < _e39) {
        phi_254_ = _e61;
    } else {
        phi_254_ = _e39;
    }
    let _e67 = phi_254_;
    let _e68 = bitcast<u32>(_e64);
    let _e70 = (bitcast<u32>(_e51) * param_9);
    let _e71 = (bitcast<u32>(_e67) * param_9);
    return array<u32, 4>((_e70 + _e52), (_e70 + _e68), (_e71 + _e52), (_e71 + _e68));
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_10: ptr<function, f32>, param_11: vec4<f32>, param_12: f32) -> f32 {
    var phi_369_: f32;
    var phi_370_: f32;
    var phi_371_: f32;
    var phi_394_: f32;
    var phi_395_: f32;
    var phi_396_: f32;
    var phi_397_: f32;
    var phi_398_: bool;
    var phi_399_: f32;
    var phi_400_: bool;
    var phi_438_: vec2<f32>;
    var phi_472_: f32;
    var phi_473_: f32;
    var phi_474_: f32;
    var phi_503_: f32;
    var phi_504_: f32;
    var phi_505_: f32;
    var phi_509_: f32;
    var phi_510_: f32;
    var phi_511_: f32;
    var phi_512_: f32;

    let _e38 = (*param_10);
    let _e39 = (1f - _e38);
    let _e48 = (0.5f * _e38);
    let _e49 = ((param_11.x * _e39) + _e48);
    let _e50 = ((param_11.y * _e39) + _e48);
    let _e52 = ((param_11.w * _e39) + _e48);
    let _e54 = (_e50 - (_e49 * _e49));
    let _e56 = (((param_11.z * _e39) + _e48) - (_e49 * _e50));
    if ((bitcast<u32>(param_12) & 2147483647u) > 2139095040u) {
        phi_371_ = param_12;
    } else {
        if (param_12 < 0f) {
            phi_370_ = 0f;
        } else {
            if (param_12 > 1f) {
                phi_369_ = 1f;
            } else {
                phi_369_ = param_12;
            }
            let _e68 = phi_369_;
            phi_370_ = _e68;
        }
        let _e70 = phi_370_;
        phi_371_ = _e70;
    }
    let _e72 = phi_371_;
    if (_e49 == _e52) {
        if (_e72 > 0f) {
            if ((bitcast<u32>(_e49) & 2147483647u) > 2139095040u) {
                phi_396_ = _e49;
            } else {
                if (_e49 < 0f) {
                    phi_395_ = 0f;
                } else {
                    if (_e49 > 1f) {
                        phi_394_ = 1f;
                    } else {
                        phi_394_ = _e49;
                    }
                    let _e81 = phi_394_;
                    phi_395_ = _e81;
                }
                let _e83 = phi_395_;
                phi_396_ = _e83;
            }
            let _e85 = phi_396_;
            phi_397_ = _e85;
            phi_398_ = false;
        } else {
            phi_397_ = f32();
            phi_398_ = true;
        }
        let _e87 = phi_397_;
        let _e89 = phi_398_;
        phi_399_ = _e87;
        phi_400_ = _e89;
    } else {
        phi_399_ = f32();
        phi_400_ = true;
    }
    let _e91 = phi_399_;
    let _e93 = phi_400_;
    if _e93 {
        let _e94 = (_e56 / _e54);
        let _e95 = (_e72 - _e49);
        let _e101 = (((((_e72 * _e72) - _e50) - (_e94 * _e95)) * _e54) / (((_e52 - (_e50 * _e50)) * _e54) - (_e56 * _e56)));
        let _e104 = ((_e95 / _e54) - (_e94 * _e101));
        let _e110 = ((0.5f * _e104) / _e101);
        let _e113 = ((_e110 * _e110) - (((1f - (_e104 * _e49)) - (_e101 * _e50)) / _e101));
        if (_e113 >= 0f) {
            let _e115 = sqrt(_e113);
            phi_438_ = vec2<f32>((-(_e110) - _e115), (-(_e110) + _e115));
        } else {
            phi_438_ = vec2(bitcast<f32>((bitcast<u32>(_e113) | 2143289344u)));
        }
        let _e126 = phi_438_;
        if (_e72 <= _e126.x) {
            phi_511_ = 1f;
        } else {
            if (_e72 > _e126.y) {
                let _e139 = (((_e50 - (_e49 * (_e126.x + _e126.y))) + (_e126.x * _e126.y)) / ((_e72 - _e126.x) * (_e72 - _e126.y)));
                if ((bitcast<u32>(_e139) & 2147483647u) > 2139095040u) {
                    phi_474_ = _e139;
                } else {
                    if (_e139 < 0f) {
                        phi_473_ = 0f;
                    } else {
                        if (_e139 > 1f) {
                            phi_472_ = 1f;
                        } else {
                            phi_472_ = _e139;
                        }
                        let _e146 = phi_472_;
                        phi_473_ = _e146;
                    }
                    let _e148 = phi_473_;
                    phi_474_ = _e148;
                }
                let _e150 = phi_474_;
                phi_510_ = _e150;
            } else {
                if (_e72 > _e126.x) {
                    let _e161 = (1f - (((_e50 - (_e49 * (_e72 + _e126.y))) + (_e72 * _e126.y)) / ((_e126.x - _e72) * (_e126.x - _e126.y))));
                    if ((bitcast<u32>(_e161) & 2147483647u) > 2139095040u) {
                        phi_505_ = _e161;
                    } else {
                        if (_e161 < 0f) {
                            phi_504_ = 0f;
                        } else {
                            if (_e161 > 1f) {
                                phi_503_ = 1f;
                            } else {
                                phi_503_ = _e161;
                            }
                            let _e168 = phi_503_;
                            phi_504_ = _e168;
                        }
                        let _e170 = phi_504_;
                        phi_505_ = _e170;
                    }
                    let _e172 = phi_505_;
                    phi_509_ = _e172;
                } else {
                    phi_509_ = bitcast<f32>((bitcast<u32>(_e126.x) | 2143289344u));
                }
                let _e177 = phi_509_;
                phi_510_ = _e177;
            }
            let _e179 = phi_510_;
            phi_511_ = _e179;
        }
        let _e181 = phi_511_;
        phi_512_ = _e181;
    } else {
        phi_512_ = _e91;
    }
    let _e183 = phi_512_;
    return _e183;
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_13: ptr<function, f32>, param_14: vec4<f32>, param_15: vec4<f32>, param_16: f32) -> f32 {
    let _e40 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_14.x);
    let _e42 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_14.y);
    let _e44 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_14.z);
    let _e46 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_14.w);
    let _e96 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_13, vec4<f32>(((((_e40.x * param_15.x) + (_e42.x * param_15.y)) + (_e44.x * param_15.z)) + (_e46.x * param_15.w)), ((((_e40.y * param_15.x) + (_e42.y * param_15.y)) + (_e44.y * param_15.z)) + (_e46.y * param_15.w)), ((((_e40.z * param_15.x) + (_e42.z * param_15.y)) + (_e44.z * param_15.z)) + (_e46.z * param_15.w)), ((((_e40.w * param_15.x) + (_e42.w * param_15.y)) + (_e44.w * param_15.z)) + (_e46.w * param_15.w))), param_16);
    return _e96;
}

fn function_() {
    var local_1: f32;
    var phi_566_: bool;
    var phi_567_: bool;
    var phi_568_: bool;
    var phi_569_: bool;
    var phi_573_: bool;
    var phi_608_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_612_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_705_: bool;
    var phi_706_: bool;
    var phi_707_: bool;
    var phi_708_: bool;
    var phi_709_: bool;
    var phi_710_: bool;
    var phi_711_: bool;
    var phi_712_: bool;
    var phi_713_: bool;
    var phi_714_: bool;
    var phi_715_: bool;
    var phi_716_: bool;
    var phi_720_: bool;
    var phi_821_: bool;
    var phi_829_: bool;
    var phi_834_: f32;
    var phi_837_: evaluate_Verdict;
    var phi_838_: evaluate_Verdict;
    var phi_842_: bool;
    var phi_843_: u32;
    var phi_849_: u32;

    let _e36 = id_1;
    let _e37 = local_2;
    let _e42 = arrayLength((&map.member));
    if (_e37 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    let _e49 = p.member.size[0u];
    let _e51 = p.member.size[1u];
    let _e52 = lt_shaders_entry_pixel_index(_e36, _e49, _e51);
    if (bitcast<i32>(_e52.root) != 0i) {
        let _e59 = p.member.light;
        let _e62 = samples.member[_e52.first_primitive].normal[0u];
        let _e64 = global[0u];
        if (_e62 == _e64) {
            let _e67 = samples.member[_e52.first_primitive].normal[1u];
            let _e69 = global[1u];
            if (_e67 == _e69) {
                let _e72 = samples.member[_e52.first_primitive].normal[2u];
                let _e74 = global[2u];
                phi_566_ = (_e72 == _e74);
                phi_567_ = false;
            } else {
                phi_566_ = bool();
                phi_567_ = true;
            }
            let _e77 = phi_566_;
            let _e79 = phi_567_;
            phi_568_ = _e77;
            phi_569_ = _e79;
        } else {
            phi_568_ = bool();
            phi_569_ = true;
        }
        let _e81 = phi_568_;
        let _e83 = phi_569_;
        if _e83 {
            phi_573_ = false;
        } else {
            phi_573_ = _e81;
        }
        let _e85 = phi_573_;
        if !(_e85) {
            let _e88 = samples.member[_e52.first_primitive].normal;
            let _e90 = samples.member[_e52.first_primitive].position;
            let _e91 = lt_shaders_evaluate_to_light(_e90, _e59);
            if ((((_e88.x * _e91.x) + (_e88.y * _e91.y)) + (_e88.z * _e91.z)) > 0f) {
                let _e105 = samples.member[_e52.first_primitive].flags;
                let _e113 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e119 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e113.unnamed.visibility, false), _e113.unnamed_1);
                phi_608_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e119.unnamed, ((_e105 & 1u) == 0u));
            } else {
                let _e128 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e134 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e128.unnamed.visibility, false), _e128.unnamed_1);
                phi_608_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e134.unnamed, true);
            }
            let _e139 = phi_608_;
            phi_612_ = _e139;
        } else {
            let _e145 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e151 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e145.unnamed.visibility, false), _e145.unnamed_1);
            phi_612_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e151.unnamed, true);
        }
        let _e156 = phi_612_;
        if _e156.unnamed_1 {
            phi_838_ = evaluate_Verdict(_e156.unnamed.visibility, _e156.unnamed.is_doubted);
        } else {
            let _e164 = samples.member[_e52.first_primitive].position;
            let _e170 = p.member.projection.row_w;
            let _e181 = ((((_e170.x * _e164.x) + (_e170.y * _e164.y)) + (_e170.z * _e164.z)) + (_e170.w * 1f));
            let _e183 = p.member.projection.row_x;
            let _e195 = (((((_e183.x * _e164.x) + (_e183.y * _e164.y)) + (_e183.z * _e164.z)) + (_e183.w * 1f)) / _e181);
            let _e197 = p.member.projection.row_y;
            let _e209 = (((((_e197.x * _e164.x) + (_e197.y * _e164.y)) + (_e197.z * _e164.z)) + (_e197.w * 1f)) / _e181);
            let _e211 = p.member.projection.row_z;
            let _e222 = ((((_e211.x * _e164.x) + (_e211.y * _e164.y)) + (_e211.z * _e164.z)) + (_e211.w * 1f));
            if (_e181 > 0f) {
                if (_e195 >= 0f) {
                    if (_e195 <= 1f) {
                        if (_e209 >= 0f) {
                            if (_e209 <= 1f) {
                                if (_e222 >= 0f) {
                                    phi_705_ = (_e222 <= 1f);
                                    phi_706_ = false;
                                } else {
                                    phi_705_ = bool();
                                    phi_706_ = true;
                                }
                                let _e231 = phi_705_;
                                let _e233 = phi_706_;
                                phi_707_ = _e231;
                                phi_708_ = _e233;
                            } else {
                                phi_707_ = bool();
                                phi_708_ = true;
                            }
                            let _e235 = phi_707_;
                            let _e237 = phi_708_;
                            phi_709_ = _e235;
                            phi_710_ = _e237;
                        } else {
                            phi_709_ = bool();
                            phi_710_ = true;
                        }
                        let _e239 = phi_709_;
                        let _e241 = phi_710_;
                        phi_711_ = _e239;
                        phi_712_ = _e241;
                    } else {
                        phi_711_ = bool();
                        phi_712_ = true;
                    }
                    let _e243 = phi_711_;
                    let _e245 = phi_712_;
                    phi_713_ = _e243;
                    phi_714_ = _e245;
                } else {
                    phi_713_ = bool();
                    phi_714_ = true;
                }
                let _e247 = phi_713_;
                let _e249 = phi_714_;
                phi_715_ = _e247;
                phi_716_ = _e249;
            } else {
                phi_715_ = bool();
                phi_716_ = true;
            }
            let _e251 = phi_715_;
            let _e253 = phi_716_;
            if _e253 {
                phi_720_ = false;
            } else {
                phi_720_ = _e251;
            }
            let _e255 = phi_720_;
            if _e255 {
                let _e257 = p.member.map_size;
                let _e258 = f32(_e257);
                let _e261 = ((_e195 * _e258) - 0.5f);
                let _e262 = ((_e209 * _e258) - 0.5f);
                let _e263 = floor(_e261);
                let _e264 = floor(_e262);
                let _e265 = (_e261 - _e263);
                let _e266 = (_e262 - _e264);
                let _e295 = p.member.test;
                let _e296 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e295);
                let _e298 = p.member.map_size;
                local_1 = _e296;
                let _e299 = lt_shaders_evaluate_quad_indices(select(0i, select(select(i32(_e263), i32(-2147483648), (_e263 < bitcast<f32>(3472883712u))), 2147483647i, (_e263 > bitcast<f32>(1325400063u))), (_e263 == _e263)), select(0i, select(select(i32(_e264), i32(-2147483648), (_e264 < bitcast<f32>(3472883712u))), 2147483647i, (_e264 > bitcast<f32>(1325400063u))), (_e264 == _e264)), _e298);
                if (_e299[0] < _e42) {
                } else {
                    return;
                }
                let _e304 = map.member[(0u + _e299[0])];
                if (_e299[1] < _e42) {
                } else {
                    return;
                }
                let _e309 = map.member[(0u + _e299[1])];
                if (_e299[2] < _e42) {
                } else {
                    return;
                }
                let _e314 = map.member[(0u + _e299[2])];
                if (_e299[3] < _e42) {
                } else {
                    return;
                }
                let _e319 = map.member[(0u + _e299[3])];
                let _e321 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local_1), vec4<f32>(_e304, _e309, _e314, _e319), vec4<f32>(((1f - _e265) * (1f - _e266)), (_e265 * (1f - _e266)), ((1f - _e265) * _e266), (_e265 * _e266)), _e222);
                let _e323 = p.member.epsilon;
                if (_e321 <= _e323) {
                    phi_821_ = true;
                } else {
                    phi_821_ = (_e321 >= (1f - _e323));
                }
                let _e328 = phi_821_;
                if ((bitcast<u32>(_e321) & 2147483647u) > 2139095040u) {
                    phi_829_ = true;
                } else {
                    phi_829_ = !(_e328);
                }
                let _e334 = phi_829_;
                if (_e321 > 0.5f) {
                    phi_834_ = 1f;
                } else {
                    phi_834_ = 0f;
                }
                let _e337 = phi_834_;
                phi_837_ = evaluate_Verdict(_e337, _e334);
            } else {
                phi_837_ = evaluate_Verdict(1f, true);
            }
            let _e341 = phi_837_;
            phi_838_ = _e341;
        }
        let _e343 = phi_838_;
        visibility.member[_e52.first_primitive] = _e343.visibility;
        phi_842_ = _e343.is_doubted;
        phi_843_ = _e52.first_primitive;
    } else {
        phi_842_ = false;
        phi_843_ = 0u;
    }
    let _e348 = phi_842_;
    let _e350 = phi_843_;
    if _e348 {
        let _e352 = atomicAdd((&shared_[0u]), 1u);
        phi_849_ = _e352;
    } else {
        phi_849_ = 0u;
    }
    let _e354 = phi_849_;
    workgroupBarrier();
    if (_e37 == 0u) {
        let _e358 = atomicLoad((&shared_[0u]));
        let _e359 = atomicAdd((&list.member[3u]), _e358);
        atomicStore((&shared_[1u]), _e359);
    }
    workgroupBarrier();
    if _e348 {
        let _e362 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e362) + _e354)]), _e350);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_msm_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
