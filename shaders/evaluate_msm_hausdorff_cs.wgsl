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

struct type_32 {
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

struct hankel_HankelFactors {
    moments: vec4<f32>,
    d22_: f32,
    l32_d22_: f32,
    d33_d22_: f32,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_20;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_32;
@group(0) @binding(2) 
var<storage> map: type_24;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_24;

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
        let _e45 = phi_143_;
        let _e47 = phi_144_;
        phi_145_ = _e45;
        phi_146_ = _e47;
    } else {
        phi_145_ = lt_bvh_traverse_Tree();
        phi_146_ = true;
    }
    let _e49 = phi_145_;
    let _e51 = phi_146_;
    if _e51 {
        phi_151_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_151_ = _e49;
    }
    let _e56 = phi_151_;
    return lt_bvh_traverse_Tree(_e56.root, _e56.first_primitive);
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_4: f32) -> vec4<f32> {
    var phi_174_: f32;
    var phi_175_: f32;
    var phi_176_: f32;

    if ((bitcast<u32>(param_4) & 2147483647u) > 2139095040u) {
        phi_176_ = param_4;
    } else {
        if (param_4 < 0f) {
            phi_175_ = 0f;
        } else {
            if (param_4 > 1f) {
                phi_174_ = 1f;
            } else {
                phi_174_ = param_4;
            }
            let _e39 = phi_174_;
            phi_175_ = _e39;
        }
        let _e41 = phi_175_;
        phi_176_ = _e41;
    }
    let _e43 = phi_176_;
    let _e44 = (_e43 * _e43);
    return vec4<f32>(_e43, _e44, (_e44 * _e43), (_e44 * _e44));
}

fn lt_shaders_evaluate_to_light(param_5: vec3<f32>, param_6: vec4<f32>) -> vec3<f32> {
    return vec3<f32>((param_6.x - (param_5.x * param_6.w)), (param_6.y - (param_5.y * param_6.w)), (param_6.z - (param_5.z * param_6.w)));
}

fn lt_shaders_evaluate_quad_indices(param_7: i32, param_8: i32, param_9: u32) -> array<u32, 4> {
    var phi_208_: i32;
    var phi_213_: i32;
    var phi_218_: i32;
    var phi_223_: i32;
    var phi_232_: i32;
    var phi_237_: i32;
    var phi_242_: i32;
    var phi_247_: i32;

    let _e36 = (bitcast<i32>(param_9) - 1i);
    if (param_7 > 0i) {
        phi_208_ = param_7;
    } else {
        phi_208_ = 0i;
    }
    let _e39 = phi_208_;
    if (param_8 > 0i) {
        phi_213_ = param_8;
    } else {
        phi_213_ = 0i;
    }
    let _e42 = phi_213_;
    if (_e39 < _e36) {
        phi_218_ = _e39;
    } else {
        phi_218_ = _e36;
    }
    let _e45 = phi_218_;
    if (_e42 < _e36) {
        phi_223_ = _e42;
    } else {
        phi_223_ = _e36;
    }
    let _e48 = phi_223_;
    let _e49 = bitcast<u32>(_e45);
    let _e51 = (param_7 + 1i);
    let _e52 = (param_8 + 1i);
    if (_e51 > 0i) {
        phi_232_ = _e51;
    } else {
        phi_232_ = 0i;
    }
    let _e55 = phi_232_;
    if (_e52 > 0i) {
        phi_237_ = _e52;
    } else {
        phi_237_ = 0i;
    }
    let _e58 = phi_237_;
    if (_e55 < _e36) {
        phi_242_ = _e55;
    } else {
        phi_242_ = _e36;
    }
    let _e61 = phi_242_;
    if (_e58 < _e36) {
        phi_247_ = _e58;
    } else {
        phi_247_ = _e36;
    }
    let _e64 = phi_247_;
    let _e65 = bitcast<u32>(_e61);
    let _e67 = (bitcast<u32>(_e48) * param_9);
    let _e68 = (bitcast<u32>(_e64) * param_9);
    return array<u32, 4>((_e67 + _e49), (_e67 + _e65), (_e68 + _e49), (_e68 + _e65));
}

fn lt_math_hausdorff_cubic_mass(param_10: vec4<f32>, param_11: f32, param_12: f32, param_13: f32, param_14: f32) -> f32 {
    return ((((param_10.z - (((param_12 + param_13) + param_14) * param_10.y)) + ((((param_12 * param_13) + (param_12 * param_14)) + (param_13 * param_14)) * param_10.x)) - ((param_12 * param_13) * param_14)) / (((param_11 - param_12) * (param_11 - param_13)) * (param_11 - param_14)));
}

fn lt_math_hausdorff_endpoint_upper_bound(param_15: ptr<function, hankel_HankelFactors>, param_16: f32) -> f32 {
    var phi_962_: f32;
    var phi_963_: f32;
    var phi_964_: f32;
    var phi_990_: f32;
    var phi_991_: f32;
    var phi_992_: f32;
    var phi_993_: f32;
    var phi_994_: bool;
    var phi_995_: f32;
    var phi_996_: bool;
    var phi_1024_: f32;
    var phi_1025_: f32;
    var phi_1026_: f32;
    var phi_1027_: f32;
    var phi_1028_: bool;
    var phi_1029_: f32;
    var phi_1030_: bool;
    var phi_1037_: f32;
    var phi_1038_: f32;
    var phi_1039_: f32;
    var phi_1040_: f32;

    let _e35 = (*param_15).moments;
    if (param_16 <= 0f) {
        phi_1040_ = 1f;
    } else {
        let _e44 = ((_e35.z - ((1f + param_16) * _e35.y)) + (param_16 * _e35.x));
        let _e53 = (((_e35.w - ((1f + param_16) * _e35.z)) + (param_16 * _e35.y)) / _e44);
        if (abs(_e44) <= 0.00000047683716f) {
            let _e67 = (1f - (((_e35.y - (_e35.x * (param_16 + 1f))) + (param_16 * 1f)) / ((0f - param_16) * (0f - 1f))));
            if ((bitcast<u32>(_e67) & 2147483647u) > 2139095040u) {
                phi_964_ = _e67;
            } else {
                if (_e67 < 0f) {
                    phi_963_ = 0f;
                } else {
                    if (_e67 > 1f) {
                        phi_962_ = 1f;
                    } else {
                        phi_962_ = _e67;
                    }
                    let _e74 = phi_962_;
                    phi_963_ = _e74;
                }
                let _e76 = phi_963_;
                phi_964_ = _e76;
            }
            let _e78 = phi_964_;
            phi_1039_ = _e78;
        } else {
            if (_e53 > 0f) {
                if (_e53 < param_16) {
                    let _e81 = lt_math_hausdorff_cubic_mass(_e35, param_16, 0f, _e53, 1f);
                    let _e82 = lt_math_hausdorff_cubic_mass(_e35, 1f, 0f, _e53, param_16);
                    let _e83 = (_e81 + _e82);
                    if ((bitcast<u32>(_e83) & 2147483647u) > 2139095040u) {
                        phi_992_ = _e83;
                    } else {
                        if (_e83 < 0f) {
                            phi_991_ = 0f;
                        } else {
                            if (_e83 > 1f) {
                                phi_990_ = 1f;
                            } else {
                                phi_990_ = _e83;
                            }
                            let _e90 = phi_990_;
                            phi_991_ = _e90;
                        }
                        let _e92 = phi_991_;
                        phi_992_ = _e92;
                    }
                    let _e94 = phi_992_;
                    phi_993_ = _e94;
                    phi_994_ = false;
                } else {
                    phi_993_ = f32();
                    phi_994_ = true;
                }
                let _e96 = phi_993_;
                let _e98 = phi_994_;
                phi_995_ = _e96;
                phi_996_ = _e98;
            } else {
                phi_995_ = f32();
                phi_996_ = true;
            }
            let _e100 = phi_995_;
            let _e102 = phi_996_;
            if _e102 {
                if (_e53 > param_16) {
                    if (_e53 < 1f) {
                        let _e105 = lt_math_hausdorff_cubic_mass(_e35, 0f, _e53, param_16, 1f);
                        let _e106 = (1f - _e105);
                        if ((bitcast<u32>(_e106) & 2147483647u) > 2139095040u) {
                            phi_1026_ = _e106;
                        } else {
                            if (_e106 < 0f) {
                                phi_1025_ = 0f;
                            } else {
                                if (_e106 > 1f) {
                                    phi_1024_ = 1f;
                                } else {
                                    phi_1024_ = _e106;
                                }
                                let _e113 = phi_1024_;
                                phi_1025_ = _e113;
                            }
                            let _e115 = phi_1025_;
                            phi_1026_ = _e115;
                        }
                        let _e117 = phi_1026_;
                        phi_1027_ = _e117;
                        phi_1028_ = false;
                    } else {
                        phi_1027_ = f32();
                        phi_1028_ = true;
                    }
                    let _e119 = phi_1027_;
                    let _e121 = phi_1028_;
                    phi_1029_ = _e119;
                    phi_1030_ = _e121;
                } else {
                    phi_1029_ = f32();
                    phi_1030_ = true;
                }
                let _e123 = phi_1029_;
                let _e125 = phi_1030_;
                if _e125 {
                    phi_1037_ = bitcast<f32>((bitcast<u32>(_e53) | 2143289344u));
                } else {
                    phi_1037_ = _e123;
                }
                let _e130 = phi_1037_;
                phi_1038_ = _e130;
            } else {
                phi_1038_ = _e100;
            }
            let _e132 = phi_1038_;
            phi_1039_ = _e132;
        }
        let _e134 = phi_1039_;
        phi_1040_ = _e134;
    }
    let _e136 = phi_1040_;
    return _e136;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_17: ptr<function, f32>, param_18: vec4<f32>, param_19: f32) -> f32 {
    var local: hankel_HankelFactors;
    var phi_689_: f32;
    var phi_690_: f32;
    var phi_691_: f32;
    var phi_744_: vec2<f32>;
    var phi_807_: vec2<f32>;
    var phi_845_: f32;
    var phi_846_: f32;
    var phi_847_: f32;
    var phi_880_: f32;
    var phi_881_: f32;
    var phi_882_: f32;
    var phi_886_: f32;
    var phi_887_: f32;
    var phi_888_: f32;
    var phi_889_: f32;
    var phi_890_: bool;
    var phi_891_: f32;
    var phi_892_: bool;
    var phi_903_: f32;
    var phi_904_: f32;

    let _e36 = (*param_17);
    let _e37 = (1f - _e36);
    let _e46 = (0.5f * _e36);
    let _e47 = ((param_18.x * _e37) + _e46);
    let _e48 = ((param_18.y * _e37) + _e46);
    let _e49 = ((param_18.z * _e37) + _e46);
    let _e50 = ((param_18.w * _e37) + _e46);
    let _e53 = (_e48 - (_e47 * _e47));
    let _e55 = (_e49 - (_e47 * _e48));
    let _e61 = hankel_HankelFactors(vec4<f32>(_e47, _e48, _e49, _e50), _e53, _e55, (((_e50 - (_e48 * _e48)) * _e53) - (_e55 * _e55)));
    local = hankel_HankelFactors(_e61.moments, _e61.d22_, _e61.l32_d22_, _e61.d33_d22_);
    if ((bitcast<u32>(param_19) & 2147483647u) > 2139095040u) {
        phi_691_ = param_19;
    } else {
        if (param_19 < 0f) {
            phi_690_ = 0f;
        } else {
            if (param_19 > 1f) {
                phi_689_ = 1f;
            } else {
                phi_689_ = param_19;
            }
            let _e73 = phi_689_;
            phi_690_ = _e73;
        }
        let _e75 = phi_690_;
        phi_691_ = _e75;
    }
    let _e77 = phi_691_;
    let _e80 = local.moments[0u];
    let _e83 = local.moments[1u];
    let _e91 = local.l32_d22_;
    let _e93 = local.d22_;
    let _e94 = (_e91 / _e93);
    let _e95 = (_e77 - _e80);
    let _e101 = local.d22_;
    let _e104 = local.d33_d22_;
    let _e105 = (((((_e77 * _e77) - _e83) - (_e94 * _e95)) * _e101) / _e104);
    let _e107 = local.d22_;
    let _e110 = ((_e95 / _e107) - (_e94 * _e105));
    let _e116 = ((0.5f * _e110) / _e105);
    let _e119 = ((_e116 * _e116) - (((1f - (_e110 * _e80)) - (_e105 * _e83)) / _e105));
    if (_e119 >= 0f) {
        let _e121 = sqrt(_e119);
        phi_744_ = vec2<f32>((-(_e116) - _e121), (-(_e116) + _e121));
    } else {
        phi_744_ = vec2(bitcast<f32>((bitcast<u32>(_e119) | 2143289344u)));
    }
    let _e132 = phi_744_;
    if (_e132.x >= 0f) {
        if (_e132.y <= 1f) {
            let _e139 = local.moments[0u];
            let _e142 = local.moments[1u];
            let _e150 = local.l32_d22_;
            let _e152 = local.d22_;
            let _e153 = (_e150 / _e152);
            let _e154 = (_e77 - _e139);
            let _e160 = local.d22_;
            let _e163 = local.d33_d22_;
            let _e164 = (((((_e77 * _e77) - _e142) - (_e153 * _e154)) * _e160) / _e163);
            let _e166 = local.d22_;
            let _e169 = ((_e154 / _e166) - (_e153 * _e164));
            let _e175 = ((0.5f * _e169) / _e164);
            let _e178 = ((_e175 * _e175) - (((1f - (_e169 * _e139)) - (_e164 * _e142)) / _e164));
            if (_e178 >= 0f) {
                let _e180 = sqrt(_e178);
                phi_807_ = vec2<f32>((-(_e175) - _e180), (-(_e175) + _e180));
            } else {
                phi_807_ = vec2(bitcast<f32>((bitcast<u32>(_e178) | 2143289344u)));
            }
            let _e191 = phi_807_;
            if (_e77 <= _e191.x) {
                phi_888_ = 1f;
            } else {
                if (_e77 > _e191.y) {
                    let _e197 = local.moments;
                    let _e208 = (((_e197.y - (_e197.x * (_e191.x + _e191.y))) + (_e191.x * _e191.y)) / ((_e77 - _e191.x) * (_e77 - _e191.y)));
                    if ((bitcast<u32>(_e208) & 2147483647u) > 2139095040u) {
                        phi_847_ = _e208;
                    } else {
                        if (_e208 < 0f) {
                            phi_846_ = 0f;
                        } else {
                            if (_e208 > 1f) {
                                phi_845_ = 1f;
                            } else {
                                phi_845_ = _e208;
                            }
                            let _e215 = phi_845_;
                            phi_846_ = _e215;
                        }
                        let _e217 = phi_846_;
                        phi_847_ = _e217;
                    }
                    let _e219 = phi_847_;
                    phi_887_ = _e219;
                } else {
                    if (_e77 > _e191.x) {
                        let _e222 = local.moments;
                        let _e234 = (1f - (((_e222.y - (_e222.x * (_e77 + _e191.y))) + (_e77 * _e191.y)) / ((_e191.x - _e77) * (_e191.x - _e191.y))));
                        if ((bitcast<u32>(_e234) & 2147483647u) > 2139095040u) {
                            phi_882_ = _e234;
                        } else {
                            if (_e234 < 0f) {
                                phi_881_ = 0f;
                            } else {
                                if (_e234 > 1f) {
                                    phi_880_ = 1f;
                                } else {
                                    phi_880_ = _e234;
                                }
                                let _e241 = phi_880_;
                                phi_881_ = _e241;
                            }
                            let _e243 = phi_881_;
                            phi_882_ = _e243;
                        }
                        let _e245 = phi_882_;
                        phi_886_ = _e245;
                    } else {
                        phi_886_ = bitcast<f32>((bitcast<u32>(_e191.x) | 2143289344u));
                    }
                    let _e250 = phi_886_;
                    phi_887_ = _e250;
                }
                let _e252 = phi_887_;
                phi_888_ = _e252;
            }
            let _e254 = phi_888_;
            phi_889_ = _e254;
            phi_890_ = false;
        } else {
            phi_889_ = f32();
            phi_890_ = true;
        }
        let _e256 = phi_889_;
        let _e258 = phi_890_;
        phi_891_ = _e256;
        phi_892_ = _e258;
    } else {
        phi_891_ = f32();
        phi_892_ = true;
    }
    let _e260 = phi_891_;
    let _e262 = phi_892_;
    if _e262 {
        if ((bitcast<u32>(_e132.x) & 2147483647u) > 2139095040u) {
            phi_903_ = _e132.x;
        } else {
            let _e266 = lt_math_hausdorff_endpoint_upper_bound((&local), _e77);
            phi_903_ = _e266;
        }
        let _e268 = phi_903_;
        phi_904_ = _e268;
    } else {
        phi_904_ = _e260;
    }
    let _e270 = phi_904_;
    return _e270;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_20: ptr<function, f32>, param_21: vec4<f32>, param_22: vec4<f32>, param_23: f32) -> f32 {
    let _e37 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_21.x);
    let _e39 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_21.y);
    let _e41 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_21.z);
    let _e43 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_21.w);
    let _e93 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_20, vec4<f32>(((((_e37.x * param_22.x) + (_e39.x * param_22.y)) + (_e41.x * param_22.z)) + (_e43.x * param_22.w)), ((((_e37.y * param_22.x) + (_e39.y * param_22.y)) + (_e41.y * param_22.z)) + (_e43.y * param_22.w)), ((((_e37.z * param_22.x) + (_e39.z * param_22.y)) + (_e41.z * param_22.z)) + (_e43.z * param_22.w)), ((((_e37.w * param_22.x) + (_e39.w * param_22.y)) + (_e41.w * param_22.z)) + (_e43.w * param_22.w))), param_23);
    return _e93;
}

fn function_() {
    var local_1: f32;
    var phi_310_: bool;
    var phi_311_: bool;
    var phi_312_: bool;
    var phi_313_: bool;
    var phi_317_: bool;
    var phi_352_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_356_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_449_: bool;
    var phi_450_: bool;
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
    var phi_464_: bool;
    var phi_559_: evaluate_Verdict;
    var phi_560_: evaluate_Verdict;
    var phi_561_: bool;
    var phi_562_: evaluate_Verdict;
    var phi_563_: evaluate_Verdict;
    var phi_564_: bool;
    var phi_568_: evaluate_Verdict;

    let _e33 = id_1;
    let _e40 = arrayLength((&map.member));
    let _e46 = p.member.size[0u];
    let _e48 = p.member.size[1u];
    let _e49 = lt_shaders_entry_pixel_index(_e33, _e46, _e48);
    if (bitcast<i32>(_e49.root) != 0i) {
        if (_e49.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e58 = p.member.light;
        let _e61 = samples.member[(0u + _e49.first_primitive)].normal[0u];
        let _e63 = global[0u];
        if (_e61 == _e63) {
            let _e66 = samples.member[(0u + _e49.first_primitive)].normal[1u];
            let _e68 = global[1u];
            if (_e66 == _e68) {
                let _e71 = samples.member[(0u + _e49.first_primitive)].normal[2u];
                let _e73 = global[2u];
                phi_310_ = (_e71 == _e73);
                phi_311_ = false;
            } else {
                phi_310_ = bool();
                phi_311_ = true;
            }
            let _e76 = phi_310_;
            let _e78 = phi_311_;
            phi_312_ = _e76;
            phi_313_ = _e78;
        } else {
            phi_312_ = bool();
            phi_313_ = true;
        }
        let _e80 = phi_312_;
        let _e82 = phi_313_;
        if _e82 {
            phi_317_ = false;
        } else {
            phi_317_ = _e80;
        }
        let _e84 = phi_317_;
        if !(_e84) {
            let _e87 = samples.member[(0u + _e49.first_primitive)].normal;
            let _e89 = samples.member[(0u + _e49.first_primitive)].position;
            let _e90 = lt_shaders_evaluate_to_light(_e89, _e58);
            if ((((_e87.x * _e90.x) + (_e87.y * _e90.y)) + (_e87.z * _e90.z)) > 0f) {
                let _e104 = samples.member[(0u + _e49.first_primitive)].flags;
                let _e112 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e118 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e112.unnamed.visibility, false), _e112.unnamed_1);
                phi_352_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e118.unnamed, ((_e104 & 1u) == 0u));
            } else {
                let _e127 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e133 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e127.unnamed.visibility, false), _e127.unnamed_1);
                phi_352_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e133.unnamed, true);
            }
            let _e138 = phi_352_;
            phi_356_ = _e138;
        } else {
            let _e144 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e150 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e144.unnamed.visibility, false), _e144.unnamed_1);
            phi_356_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e150.unnamed, true);
        }
        let _e155 = phi_356_;
        if _e155.unnamed_1 {
            phi_562_ = evaluate_Verdict(_e155.unnamed.visibility, _e155.unnamed.is_doubted);
            phi_563_ = evaluate_Verdict();
            phi_564_ = true;
        } else {
            let _e163 = samples.member[(0u + _e49.first_primitive)].position;
            let _e169 = p.member.projection.row_w;
            let _e180 = ((((_e169.x * _e163.x) + (_e169.y * _e163.y)) + (_e169.z * _e163.z)) + (_e169.w * 1f));
            let _e182 = p.member.projection.row_x;
            let _e194 = (((((_e182.x * _e163.x) + (_e182.y * _e163.y)) + (_e182.z * _e163.z)) + (_e182.w * 1f)) / _e180);
            let _e196 = p.member.projection.row_y;
            let _e208 = (((((_e196.x * _e163.x) + (_e196.y * _e163.y)) + (_e196.z * _e163.z)) + (_e196.w * 1f)) / _e180);
            let _e210 = p.member.projection.row_z;
            let _e221 = ((((_e210.x * _e163.x) + (_e210.y * _e163.y)) + (_e210.z * _e163.z)) + (_e210.w * 1f));
            if (_e180 > 0f) {
                if (_e194 >= 0f) {
                    if (_e194 <= 1f) {
                        if (_e208 >= 0f) {
                            if (_e208 <= 1f) {
                                if (_e221 >= 0f) {
                                    phi_449_ = (_e221 <= 1f);
                                    phi_450_ = false;
                                } else {
                                    phi_449_ = bool();
                                    phi_450_ = true;
                                }
                                let _e230 = phi_449_;
                                let _e232 = phi_450_;
                                phi_451_ = _e230;
                                phi_452_ = _e232;
                            } else {
                                phi_451_ = bool();
                                phi_452_ = true;
                            }
                            let _e234 = phi_451_;
                            let _e236 = phi_452_;
                            phi_453_ = _e234;
                            phi_454_ = _e236;
                        } else {
                            phi_453_ = bool();
                            phi_454_ = true;
                        }
                        let _e238 = phi_453_;
                        let _e240 = phi_454_;
                        phi_455_ = _e238;
                        phi_456_ = _e240;
                    } else {
                        phi_455_ = bool();
                        phi_456_ = true;
                    }
                    let _e242 = phi_455_;
                    let _e244 = phi_456_;
                    phi_457_ = _e242;
                    phi_458_ = _e244;
                } else {
                    phi_457_ = bool();
                    phi_458_ = true;
                }
                let _e246 = phi_457_;
                let _e248 = phi_458_;
                phi_459_ = _e246;
                phi_460_ = _e248;
            } else {
                phi_459_ = bool();
                phi_460_ = true;
            }
            let _e250 = phi_459_;
            let _e252 = phi_460_;
            if _e252 {
                phi_464_ = false;
            } else {
                phi_464_ = _e250;
            }
            let _e254 = phi_464_;
            if _e254 {
                let _e256 = p.member.map_size;
                let _e257 = f32(_e256);
                let _e260 = ((_e194 * _e257) - 0.5f);
                let _e261 = ((_e208 * _e257) - 0.5f);
                let _e262 = floor(_e260);
                let _e263 = floor(_e261);
                let _e264 = (_e260 - _e262);
                let _e265 = (_e261 - _e263);
                let _e294 = p.member.test;
                let _e295 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e294);
                let _e297 = p.member.map_size;
                local_1 = _e295;
                let _e298 = lt_shaders_evaluate_quad_indices(select(0i, select(select(i32(_e262), i32(-2147483648), (_e262 < bitcast<f32>(3472883712u))), 2147483647i, (_e262 > bitcast<f32>(1325400063u))), (_e262 == _e262)), select(0i, select(select(i32(_e263), i32(-2147483648), (_e263 < bitcast<f32>(3472883712u))), 2147483647i, (_e263 > bitcast<f32>(1325400063u))), (_e263 == _e263)), _e297);
                if (_e298[0] < _e40) {
                } else {
                    return;
                }
                let _e303 = map.member[(0u + _e298[0])];
                if (_e298[1] < _e40) {
                } else {
                    return;
                }
                let _e308 = map.member[(0u + _e298[1])];
                if (_e298[2] < _e40) {
                } else {
                    return;
                }
                let _e313 = map.member[(0u + _e298[2])];
                if (_e298[3] < _e40) {
                } else {
                    return;
                }
                let _e318 = map.member[(0u + _e298[3])];
                let _e320 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local_1), vec4<f32>(_e303, _e308, _e313, _e318), vec4<f32>(((1f - _e264) * (1f - _e265)), (_e264 * (1f - _e265)), ((1f - _e264) * _e265), (_e264 * _e265)), _e221);
                phi_559_ = evaluate_Verdict(_e320, false);
                phi_560_ = evaluate_Verdict();
                phi_561_ = false;
            } else {
                phi_559_ = evaluate_Verdict();
                phi_560_ = evaluate_Verdict(1f, false);
                phi_561_ = true;
            }
            let _e324 = phi_559_;
            let _e326 = phi_560_;
            let _e328 = phi_561_;
            phi_562_ = _e326;
            phi_563_ = _e324;
            phi_564_ = _e328;
        }
        let _e330 = phi_562_;
        let _e332 = phi_563_;
        let _e334 = phi_564_;
        if _e334 {
            phi_568_ = _e330;
        } else {
            phi_568_ = _e332;
        }
        let _e336 = phi_568_;
        if (_e49.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e49.first_primitive)] = _e336.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_msm_hausdorff_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
