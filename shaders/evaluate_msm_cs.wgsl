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

struct type_31 {
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
var<uniform> p: type_31;
@group(0) @binding(2) 
var<storage> map: type_24;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_24;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_132_: lt_bvh_traverse_Tree;
    var phi_133_: bool;
    var phi_134_: lt_bvh_traverse_Tree;
    var phi_135_: bool;
    var phi_140_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_132_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_133_ = false;
        } else {
            phi_132_ = lt_bvh_traverse_Tree();
            phi_133_ = true;
        }
        let _e43 = phi_132_;
        let _e45 = phi_133_;
        phi_134_ = _e43;
        phi_135_ = _e45;
    } else {
        phi_134_ = lt_bvh_traverse_Tree();
        phi_135_ = true;
    }
    let _e47 = phi_134_;
    let _e49 = phi_135_;
    if _e49 {
        phi_140_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_140_ = _e47;
    }
    let _e54 = phi_140_;
    return lt_bvh_traverse_Tree(_e54.root, _e54.first_primitive);
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_4: f32) -> vec4<f32> {
    var phi_163_: f32;
    var phi_164_: f32;
    var phi_165_: f32;

    if ((bitcast<u32>(param_4) & 2147483647u) > 2139095040u) {
        phi_165_ = param_4;
    } else {
        if (param_4 < 0f) {
            phi_164_ = 0f;
        } else {
            if (param_4 > 1f) {
                phi_163_ = 1f;
            } else {
                phi_163_ = param_4;
            }
            let _e37 = phi_163_;
            phi_164_ = _e37;
        }
        let _e39 = phi_164_;
        phi_165_ = _e39;
    }
    let _e41 = phi_165_;
    let _e42 = (_e41 * _e41);
    return vec4<f32>(_e41, _e42, (_e42 * _e41), (_e42 * _e42));
}

fn lt_shaders_evaluate_to_light(param_5: vec3<f32>, param_6: vec4<f32>) -> vec3<f32> {
    return vec3<f32>((param_6.x - (param_5.x * param_6.w)), (param_6.y - (param_5.y * param_6.w)), (param_6.z - (param_5.z * param_6.w)));
}

fn lt_shaders_evaluate_quad_indices(param_7: i32, param_8: i32, param_9: u32) -> array<u32, 4> {
    var phi_197_: i32;
    var phi_202_: i32;
    var phi_207_: i32;
    var phi_212_: i32;
    var phi_221_: i32;
    var phi_226_: i32;
    var phi_231_: i32;
    var phi_236_: i32;

    let _e34 = (bitcast<i32>(param_9) - 1i);
    if (param_7 > 0i) {
        phi_197_ = param_7;
    } else {
        phi_197_ = 0i;
    }
    let _e37 = phi_197_;
    if (param_8 > 0i) {
        phi_202_ = param_8;
    } else {
        phi_202_ = 0i;
    }
    let _e40 = phi_202_;
    if (_e37 < _e34) {
        phi_207_ = _e37;
    } else {
        phi_207_ = _e34;
    }
    let _e43 = phi_207_;
    if (_e40 < _e34) {
        phi_212_ = _e40;
    } else {
        phi_212_ = _e34;
    }
    let _e46 = phi_212_;
    let _e47 = bitcast<u32>(_e43);
    let _e49 = (param_7 + 1i);
    let _e50 = (param_8 + 1i);
    if (_e49 > 0i) {
        phi_221_ = _e49;
    } else {
        phi_221_ = 0i;
    }
    let _e53 = phi_221_;
    if (_e50 > 0i) {
        phi_226_ = _e50;
    } else {
        phi_226_ = 0i;
    }
    let _e56 = phi_226_;
    if (_e53 < _e34) {
        phi_231_ = _e53;
    } else {
        phi_231_ = _e34;
    }
    let _e59 = phi_231_;
    if (_e56 < _e34) {
        phi_236_ = _e56;
    } else {
        phi_236_ = _e34;
    }
    let _e62 = phi_236_;
    let _e63 = bitcast<u32>(_e59);
    let _e65 = (bitcast<u32>(_e46) * param_9);
    let _e66 = (bitcast<u32>(_e62) * param_9);
    return array<u32, 4>((_e65 + _e47), (_e65 + _e63), (_e66 + _e47), (_e66 + _e63));
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_10: ptr<function, f32>, param_11: vec4<f32>, param_12: f32) -> f32 {
    var phi_670_: f32;
    var phi_671_: f32;
    var phi_672_: f32;
    var phi_707_: vec2<f32>;
    var phi_741_: f32;
    var phi_742_: f32;
    var phi_743_: f32;
    var phi_772_: f32;
    var phi_773_: f32;
    var phi_774_: f32;
    var phi_778_: f32;
    var phi_779_: f32;
    var phi_780_: f32;

    let _e33 = (*param_10);
    let _e34 = (1f - _e33);
    let _e43 = (0.5f * _e33);
    let _e44 = ((param_11.x * _e34) + _e43);
    let _e45 = ((param_11.y * _e34) + _e43);
    let _e49 = (_e45 - (_e44 * _e44));
    let _e51 = (((param_11.z * _e34) + _e43) - (_e44 * _e45));
    if ((bitcast<u32>(param_12) & 2147483647u) > 2139095040u) {
        phi_672_ = param_12;
    } else {
        if (param_12 < 0f) {
            phi_671_ = 0f;
        } else {
            if (param_12 > 1f) {
                phi_670_ = 1f;
            } else {
                phi_670_ = param_12;
            }
            let _e63 = phi_670_;
            phi_671_ = _e63;
        }
        let _e65 = phi_671_;
        phi_672_ = _e65;
    }
    let _e67 = phi_672_;
    let _e68 = (_e51 / _e49);
    let _e69 = (_e67 - _e44);
    let _e75 = (((((_e67 * _e67) - _e45) - (_e68 * _e69)) * _e49) / (((((param_11.w * _e34) + _e43) - (_e45 * _e45)) * _e49) - (_e51 * _e51)));
    let _e78 = ((_e69 / _e49) - (_e68 * _e75));
    let _e84 = ((0.5f * _e78) / _e75);
    let _e87 = ((_e84 * _e84) - (((1f - (_e78 * _e44)) - (_e75 * _e45)) / _e75));
    if (_e87 >= 0f) {
        let _e89 = sqrt(_e87);
        phi_707_ = vec2<f32>((-(_e84) - _e89), (-(_e84) + _e89));
    } else {
        phi_707_ = vec2(bitcast<f32>((bitcast<u32>(_e87) | 2143289344u)));
    }
    let _e100 = phi_707_;
    if (_e67 <= _e100.x) {
        phi_780_ = 1f;
    } else {
        if (_e67 > _e100.y) {
            let _e113 = (((_e45 - (_e44 * (_e100.x + _e100.y))) + (_e100.x * _e100.y)) / ((_e67 - _e100.x) * (_e67 - _e100.y)));
            if ((bitcast<u32>(_e113) & 2147483647u) > 2139095040u) {
                phi_743_ = _e113;
            } else {
                if (_e113 < 0f) {
                    phi_742_ = 0f;
                } else {
                    if (_e113 > 1f) {
                        phi_741_ = 1f;
                    } else {
                        phi_741_ = _e113;
                    }
                    let _e120 = phi_741_;
                    phi_742_ = _e120;
                }
                let _e122 = phi_742_;
                phi_743_ = _e122;
            }
            let _e124 = phi_743_;
            phi_779_ = _e124;
        } else {
            if (_e67 > _e100.x) {
                let _e135 = (1f - (((_e45 - (_e44 * (_e67 + _e100.y))) + (_e67 * _e100.y)) / ((_e100.x - _e67) * (_e100.x - _e100.y))));
                if ((bitcast<u32>(_e135) & 2147483647u) > 2139095040u) {
                    phi_774_ = _e135;
                } else {
                    if (_e135 < 0f) {
                        phi_773_ = 0f;
                    } else {
                        if (_e135 > 1f) {
                            phi_772_ = 1f;
                        } else {
                            phi_772_ = _e135;
                        }
                        let _e142 = phi_772_;
                        phi_773_ = _e142;
                    }
                    let _e144 = phi_773_;
                    phi_774_ = _e144;
                }
                let _e146 = phi_774_;
                phi_778_ = _e146;
            } else {
                phi_778_ = bitcast<f32>((bitcast<u32>(_e100.x) | 2143289344u));
            }
            let _e151 = phi_778_;
            phi_779_ = _e151;
        }
        let _e153 = phi_779_;
        phi_780_ = _e153;
    }
    let _e155 = phi_780_;
    return _e155;
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_13: ptr<function, f32>, param_14: vec4<f32>, param_15: vec4<f32>, param_16: f32) -> f32 {
    let _e35 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_14.x);
    let _e37 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_14.y);
    let _e39 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_14.z);
    let _e41 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_14.w);
    let _e91 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_13, vec4<f32>(((((_e35.x * param_15.x) + (_e37.x * param_15.y)) + (_e39.x * param_15.z)) + (_e41.x * param_15.w)), ((((_e35.y * param_15.x) + (_e37.y * param_15.y)) + (_e39.y * param_15.z)) + (_e41.y * param_15.w)), ((((_e35.z * param_15.x) + (_e37.z * param_15.y)) + (_e39.z * param_15.z)) + (_e41.z * param_15.w)), ((((_e35.w * param_15.x) + (_e37.w * param_15.y)) + (_e39.w * param_15.z)) + (_e41.w * param_15.w))), param_16);
    return _e91;
}

fn function_() {
    var local: f32;
    var phi_299_: bool;
    var phi_300_: bool;
    var phi_301_: bool;
    var phi_302_: bool;
    var phi_306_: bool;
    var phi_341_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_345_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_438_: bool;
    var phi_439_: bool;
    var phi_440_: bool;
    var phi_441_: bool;
    var phi_442_: bool;
    var phi_443_: bool;
    var phi_444_: bool;
    var phi_445_: bool;
    var phi_446_: bool;
    var phi_447_: bool;
    var phi_448_: bool;
    var phi_449_: bool;
    var phi_453_: bool;
    var phi_548_: evaluate_Verdict;
    var phi_549_: evaluate_Verdict;
    var phi_550_: bool;
    var phi_551_: evaluate_Verdict;
    var phi_552_: evaluate_Verdict;
    var phi_553_: bool;
    var phi_557_: evaluate_Verdict;

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
                phi_299_ = (_e69 == _e71);
                phi_300_ = false;
            } else {
                phi_299_ = bool();
                phi_300_ = true;
            }
            let _e74 = phi_299_;
            let _e76 = phi_300_;
            phi_301_ = _e74;
            phi_302_ = _e76;
        } else {
            phi_301_ = bool();
            phi_302_ = true;
        }
        let _e78 = phi_301_;
        let _e80 = phi_302_;
        if _e80 {
            phi_306_ = false;
        } else {
            phi_306_ = _e78;
        }
        let _e82 = phi_306_;
        if !(_e82) {
            let _e85 = samples.member[(0u + _e47.first_primitive)].normal;
            let _e87 = samples.member[(0u + _e47.first_primitive)].position;
            let _e88 = lt_shaders_evaluate_to_light(_e87, _e56);
            if ((((_e85.x * _e88.x) + (_e85.y * _e88.y)) + (_e85.z * _e88.z)) > 0f) {
                let _e102 = samples.member[(0u + _e47.first_primitive)].flags;
                let _e110 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e116 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e110.unnamed.visibility, false), _e110.unnamed_1);
                phi_341_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e116.unnamed, ((_e102 & 1u) == 0u));
            } else {
                let _e125 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e131 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e125.unnamed.visibility, false), _e125.unnamed_1);
                phi_341_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e131.unnamed, true);
            }
            let _e136 = phi_341_;
            phi_345_ = _e136;
        } else {
            let _e142 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e148 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e142.unnamed.visibility, false), _e142.unnamed_1);
            phi_345_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e148.unnamed, true);
        }
        let _e153 = phi_345_;
        if _e153.unnamed_1 {
            phi_551_ = evaluate_Verdict(_e153.unnamed.visibility, _e153.unnamed.is_doubted);
            phi_552_ = evaluate_Verdict();
            phi_553_ = true;
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
                                    phi_438_ = (_e219 <= 1f);
                                    phi_439_ = false;
                                } else {
                                    phi_438_ = bool();
                                    phi_439_ = true;
                                }
                                let _e228 = phi_438_;
                                let _e230 = phi_439_;
                                phi_440_ = _e228;
                                phi_441_ = _e230;
                            } else {
                                phi_440_ = bool();
                                phi_441_ = true;
                            }
                            let _e232 = phi_440_;
                            let _e234 = phi_441_;
                            phi_442_ = _e232;
                            phi_443_ = _e234;
                        } else {
                            phi_442_ = bool();
                            phi_443_ = true;
                        }
                        let _e236 = phi_442_;
                        let _e238 = phi_443_;
                        phi_444_ = _e236;
                        phi_445_ = _e238;
                    } else {
                        phi_444_ = bool();
                        phi_445_ = true;
                    }
                    let _e240 = phi_444_;
                    let _e242 = phi_445_;
                    phi_446_ = _e240;
                    phi_447_ = _e242;
                } else {
                    phi_446_ = bool();
                    phi_447_ = true;
                }
                let _e244 = phi_446_;
                let _e246 = phi_447_;
                phi_448_ = _e244;
                phi_449_ = _e246;
            } else {
                phi_448_ = bool();
                phi_449_ = true;
            }
            let _e248 = phi_448_;
            let _e250 = phi_449_;
            if _e250 {
                phi_453_ = false;
            } else {
                phi_453_ = _e248;
            }
            let _e252 = phi_453_;
            if _e252 {
                let _e254 = p.member.map_size;
                let _e255 = f32(_e254);
                let _e258 = ((_e192 * _e255) - 0.5f);
                let _e259 = ((_e206 * _e255) - 0.5f);
                let _e260 = floor(_e258);
                let _e261 = floor(_e259);
                let _e262 = (_e258 - _e260);
                let _e263 = (_e259 - _e261);
                let _e292 = p.member.test;
                let _e293 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e292);
                let _e295 = p.member.map_size;
                local = _e293;
                let _e296 = lt_shaders_evaluate_quad_indices(select(0i, select(select(i32(_e260), i32(-2147483648), (_e260 < bitcast<f32>(3472883712u))), 2147483647i, (_e260 > bitcast<f32>(1325400063u))), (_e260 == _e260)), select(0i, select(select(i32(_e261), i32(-2147483648), (_e261 < bitcast<f32>(3472883712u))), 2147483647i, (_e261 > bitcast<f32>(1325400063u))), (_e261 == _e261)), _e295);
                if (_e296[0] < _e38) {
                } else {
                    return;
                }
                let _e301 = map.member[(0u + _e296[0])];
                if (_e296[1] < _e38) {
                } else {
                    return;
                }
                let _e306 = map.member[(0u + _e296[1])];
                if (_e296[2] < _e38) {
                } else {
                    return;
                }
                let _e311 = map.member[(0u + _e296[2])];
                if (_e296[3] < _e38) {
                } else {
                    return;
                }
                let _e316 = map.member[(0u + _e296[3])];
                let _e318 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e301, _e306, _e311, _e316), vec4<f32>(((1f - _e262) * (1f - _e263)), (_e262 * (1f - _e263)), ((1f - _e262) * _e263), (_e262 * _e263)), _e219);
                phi_548_ = evaluate_Verdict(_e318, false);
                phi_549_ = evaluate_Verdict();
                phi_550_ = false;
            } else {
                phi_548_ = evaluate_Verdict();
                phi_549_ = evaluate_Verdict(1f, false);
                phi_550_ = true;
            }
            let _e322 = phi_548_;
            let _e324 = phi_549_;
            let _e326 = phi_550_;
            phi_551_ = _e324;
            phi_552_ = _e322;
            phi_553_ = _e326;
        }
        let _e328 = phi_551_;
        let _e330 = phi_552_;
        let _e332 = phi_553_;
        if _e332 {
            phi_557_ = _e328;
        } else {
            phi_557_ = _e330;
        }
        let _e334 = phi_557_;
        if (_e47.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e47.first_primitive)] = _e334.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_msm_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
