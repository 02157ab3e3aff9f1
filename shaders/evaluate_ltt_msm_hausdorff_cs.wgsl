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

struct type_38 {
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

struct type_46 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_25;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_38;
@group(0) @binding(2) 
var<storage> map: type_29;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_29;
var<private> local_3: u32;
@group(0) @binding(4) 
var<storage, read_write> list: type_46;
var<workgroup> shared_: array<atomic<u32>, 2>;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_160_: lt_bvh_traverse_Tree;
    var phi_161_: bool;
    var phi_162_: lt_bvh_traverse_Tree;
    var phi_163_: bool;
    var phi_168_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_160_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_161_ = false;
        } else {
            phi_160_ = lt_bvh_traverse_Tree();
            phi_161_ = true;
        }
        let _e49 = phi_160_;
        let _e51 = phi_161_;
        phi_162_ = _e49;
        phi_163_ = _e51;
    } else {
        phi_162_ = lt_bvh_traverse_Tree();
        phi_163_ = true;
    }
    let _e53 = phi_162_;
    let _e55 = phi_163_;
    if _e55 {
        phi_168_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_168_ = _e53;
    }
    let _e60 = phi_168_;
    return lt_bvh_traverse_Tree(_e60.root, _e60.first_primitive);
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_4: f32) -> vec4<f32> {
    var phi_191_: f32;
    var phi_192_: f32;
    var phi_193_: f32;

    if ((bitcast<u32>(param_4) & 2147483647u) > 2139095040u) {
        phi_193_ = param_4;
    } else {
        if (param_4 < 0f) {
            phi_192_ = 0f;
        } else {
            if (param_4 > 1f) {
                phi_191_ = 1f;
            } else {
                phi_191_ = param_4;
            }
            let _e43 = phi_191_;
            phi_192_ = _e43;
        }
        let _e45 = phi_192_;
        phi_193_ = _e45;
    }
    let _e47 = phi_193_;
    let _e48 = (_e47 * _e47);
    return vec4<f32>(_e47, _e48, (_e48 * _e47), (_e48 * _e48));
}

fn lt_shaders_evaluate_to_light(param_5: vec3<f32>, param_6: vec4<f32>) -> vec3<f32> {
    return vec3<f32>((param_6.x - (param_5.x * param_6.w)), (param_6.y - (param_5.y * param_6.w)), (param_6.z - (param_5.z * param_6.w)));
}

fn lt_shaders_evaluate_quad_indices(param_7: i32, param_8: i32, param_9: u32) -> array<u32, 4> {
    var phi_225_: i32;
    var phi_230_: i32;
    var phi_235_: i32;
    var phi_240_: i32;
    var phi_249_: i32;
    var phi_254_: i32;
    var phi_259_: i32;
    var phi_264_: i32;

    let _e40 = (bitcast<i32>(param_9) - 1i);
    if (param_7 > 0i) {
        phi_225_ = param_7;
    } else {
        phi_225_ = 0i;
    }
    let _e43 = phi_225_;
    if (param_8 > 0i) {
        phi_230_ = param_8;
    } else {
        phi_230_ = 0i;
    }
    let _e46 = phi_230_;
    if (_e43 < _e40) {
        phi_235_ = _e43;
    } else {
        phi_235_ = _e40;
    }
    let _e49 = phi_235_;
    if (_e46 < _e40) {
        phi_240_ = _e46;
    } else {
        phi_240_ = _e40;
    }
    let _e52 = phi_240_;
    let _e53 = bitcast<u32>(_e49);
    let _e55 = (param_7 + 1i);
    let _e56 = (param_8 + 1i);
    if (_e55 > 0i) {
        phi_249_ = _e55;
    } else {
        phi_249_ = 0i;
    }
    let _e59 = phi_249_;
    if (_e56 > 0i) {
        phi_254_ = _e56;
    } else {
        phi_254_ = 0i;
    }
    let _e62 = phi_254_;
    if (_e59 < _e40) {
        phi_259_ = _e59;
    } else {
        phi_259_ = _e40;
    }
    let _e65 = phi_259_;
    if (_e62 < _e40) {
        phi_264_ = _e62;
    } else {
        phi_264_ = _e40;
    }
    let _e68 = phi_264_;
    let _e69 = bitcast<u32>(_e65);
    let _e71 = (bitcast<u32>(_e52) * param_9);
    let _e72 = (bitcast<u32>(_e68) * param_9);
    return array<u32, 4>((_e71 + _e53), (_e71 + _e69), (_e72 + _e53), (_e72 + _e69));
}

fn lt_math_hausdorff_cubic_mass(param_10: vec4<f32>, param_11: f32, param_12: f32, param_13: f32, param_14: f32) -> f32 {
    return ((((param_10.z - (((param_12 + param_13) + param_14) * param_10.y)) + ((((param_12 * param_13) + (param_12 * param_14)) + (param_13 * param_14)) * param_10.x)) - ((param_12 * param_13) * param_14)) / (((param_11 - param_12) * (param_11 - param_13)) * (param_11 - param_14)));
}

fn lt_math_hausdorff_endpoint_upper_bound(param_15: ptr<function, hankel_HankelFactors>, param_16: f32) -> f32 {
    var phi_660_: f32;
    var phi_661_: f32;
    var phi_662_: f32;
    var phi_688_: f32;
    var phi_689_: f32;
    var phi_690_: f32;
    var phi_691_: f32;
    var phi_692_: bool;
    var phi_693_: f32;
    var phi_694_: bool;
    var phi_722_: f32;
    var phi_723_: f32;
    var phi_724_: f32;
    var phi_725_: f32;
    var phi_726_: bool;
    var phi_727_: f32;
    var phi_728_: bool;
    var phi_735_: f32;
    var phi_736_: f32;
    var phi_737_: f32;
    var phi_738_: f32;

    let _e39 = (*param_15).moments;
    if (param_16 <= 0f) {
        phi_738_ = 1f;
    } else {
        let _e48 = ((_e39.z - ((1f + param_16) * _e39.y)) + (param_16 * _e39.x));
        let _e57 = (((_e39.w - ((1f + param_16) * _e39.z)) + (param_16 * _e39.y)) / _e48);
        if (abs(_e48) <= 0.00000047683716f) {
            let _e71 = (1f - (((_e39.y - (_e39.x * (param_16 + 1f))) + (param_16 * 1f)) / ((0f - param_16) * (0f - 1f))));
            if ((bitcast<u32>(_e71) & 2147483647u) > 2139095040u) {
                phi_662_ = _e71;
            } else {
                if (_e71 < 0f) {
                    phi_661_ = 0f;
                } else {
                    if (_e71 > 1f) {
                        phi_660_ = 1f;
                    } else {
                        phi_660_ = _e71;
                    }
                    let _e78 = phi_660_;
                    phi_661_ = _e78;
                }
                let _e80 = phi_661_;
                phi_662_ = _e80;
            }
            let _e82 = phi_662_;
            phi_737_ = _e82;
        } else {
            if (_e57 > 0f) {
                if (_e57 < param_16) {
                    let _e85 = lt_math_hausdorff_cubic_mass(_e39, param_16, 0f, _e57, 1f);
                    let _e86 = lt_math_hausdorff_cubic_mass(_e39, 1f, 0f, _e57, param_16);
                    let _e87 = (_e85 + _e86);
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
                    phi_691_ = _e98;
                    phi_692_ = false;
                } else {
                    phi_691_ = f32();
                    phi_692_ = true;
                }
                let _e100 = phi_691_;
                let _e102 = phi_692_;
                phi_693_ = _e100;
                phi_694_ = _e102;
            } else {
                phi_693_ = f32();
                phi_694_ = true;
            }
            let _e104 = phi_693_;
            let _e106 = phi_694_;
            if _e106 {
                if (_e57 > param_16) {
                    if (_e57 < 1f) {
                        let _e109 = lt_math_hausdorff_cubic_mass(_e39, 0f, _e57, param_16, 1f);
                        let _e110 = (1f - _e109);
                        if ((bitcast<u32>(_e110) & 2147483647u) > 2139095040u) {
                            phi_724_ = _e110;
                        } else {
                            if (_e110 < 0f) {
                                phi_723_ = 0f;
                            } else {
                                if (_e110 > 1f) {
                                    phi_722_ = 1f;
                                } else {
                                    phi_722_ = _e110;
                                }
                                let _e117 = phi_722_;
                                phi_723_ = _e117;
                            }
                            let _e119 = phi_723_;
                            phi_724_ = _e119;
                        }
                        let _e121 = phi_724_;
                        phi_725_ = _e121;
                        phi_726_ = false;
                    } else {
                        phi_725_ = f32();
                        phi_726_ = true;
                    }
                    let _e123 = phi_725_;
                    let _e125 = phi_726_;
                    phi_727_ = _e123;
                    phi_728_ = _e125;
                } else {
                    phi_727_ = f32();
                    phi_728_ = true;
                }
                let _e127 = phi_727_;
                let _e129 = phi_728_;
                if _e129 {
                    phi_735_ = bitcast<f32>((bitcast<u32>(_e57) | 2143289344u));
                } else {
                    phi_735_ = _e127;
                }
                let _e134 = phi_735_;
                phi_736_ = _e134;
            } else {
                phi_736_ = _e104;
            }
            let _e136 = phi_736_;
            phi_737_ = _e136;
        }
        let _e138 = phi_737_;
        phi_738_ = _e138;
    }
    let _e140 = phi_738_;
    return _e140;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_17: ptr<function, f32>, param_18: vec4<f32>, param_19: f32) -> f32 {
    var local_1: hankel_HankelFactors;
    var phi_387_: f32;
    var phi_388_: f32;
    var phi_389_: f32;
    var phi_442_: vec2<f32>;
    var phi_505_: vec2<f32>;
    var phi_543_: f32;
    var phi_544_: f32;
    var phi_545_: f32;
    var phi_578_: f32;
    var phi_579_: f32;
    var phi_580_: f32;
    var phi_584_: f32;
    var phi_585_: f32;
    var phi_586_: f32;
    var phi_587_: f32;
    var phi_588_: bool;
    var phi_589_: f32;
    var phi_590_: bool;
    var phi_601_: f32;
    var phi_602_: f32;

    let _e40 = (*param_17);
    let _e41 = (1f - _e40);
    let _e50 = (0.5f * _e40);
    let _e51 = ((param_18.x * _e41) + _e50);
    let _e52 = ((param_18.y * _e41) + _e50);
    let _e53 = ((param_18.z * _e41) + _e50);
    let _e54 = ((param_18.w * _e41) + _e50);
    let _e57 = (_e52 - (_e51 * _e51));
    let _e59 = (_e53 - (_e51 * _e52));
    let _e65 = hankel_HankelFactors(vec4<f32>(_e51, _e52, _e53, _e54), _e57, _e59, (((_e54 - (_e52 * _e52)) * _e57) - (_e59 * _e59)));
    local_1 = hankel_HankelFactors(_e65.moments, _e65.d22_, _e65.l32_d22_, _e65.d33_d22_);
    if ((bitcast<u32>(param_19) & 2147483647u) > 2139095040u) {
        phi_389_ = param_19;
    } else {
        if (param_19 < 0f) {
            phi_388_ = 0f;
        } else {
            if (param_19 > 1f) {
                phi_387_ = 1f;
            } else {
                phi_387_ = param_19;
            }
            let _e77 = phi_387_;
            phi_388_ = _e77;
        }
        let _e79 = phi_388_;
        phi_389_ = _e79;
    }
    let _e81 = phi_389_;
    let _e84 = local_1.moments[0u];
    let _e87 = local_1.moments[1u];
    let _e95 = local_1.l32_d22_;
    let _e97 = local_1.d22_;
    let _e98 = (_e95 / _e97);
    let _e99 = (_e81 - _e84);
    let _e105 = local_1.d22_;
    let _e108 = local_1.d33_d22_;
    let _e109 = (((((_e81 * _e81) - _e87) - (_e98 * _e99)) * _e105) / _e108);
    let _e111 = local_1.d22_;
    let _e114 = ((_e99 / _e111) - (_e98 * _e109));
    let _e120 = ((0.5f * _e114) / _e109);
    let _e123 = ((_e120 * _e120) - (((1f - (_e114 * _e84)) - (_e109 * _e87)) / _e109));
    if (_e123 >= 0f) {
        let _e125 = sqrt(_e123);
        phi_442_ = vec2<f32>((-(_e120) - _e125), (-(_e120) + _e125));
    } else {
        phi_442_ = vec2(bitcast<f32>((bitcast<u32>(_e123) | 2143289344u)));
    }
    let _e136 = phi_442_;
    if (_e136.x >= 0f) {
        if (_e136.y <= 1f) {
            let _e143 = local_1.moments[0u];
            let _e146 = local_1.moments[1u];
            let _e154 = local_1.l32_d22_;
            let _e156 = local_1.d22_;
            let _e157 = (_e154 / _e156);
            let _e158 = (_e81 - _e143);
            let _e164 = local_1.d22_;
            let _e167 = local_1.d33_d22_;
            let _e168 = (((((_e81 * _e81) - _e146) - (_e157 * _e158)) * _e164) / _e167);
            let _e170 = local_1.d22_;
            let _e173 = ((_e158 / _e170) - (_e157 * _e168));
            let _e179 = ((0.5f * _e173) / _e168);
            let _e182 = ((_e179 * _e179) - (((1f - (_e173 * _e143)) - (_e168 * _e146)) / _e168));
            if (_e182 >= 0f) {
                let _e184 = sqrt(_e182);
                phi_505_ = vec2<f32>((-(_e179) - _e184), (-(_e179) + _e184));
            } else {
                phi_505_ = vec2(bitcast<f32>((bitcast<u32>(_e182) | 2143289344u)));
            }
            let _e195 = phi_505_;
            if (_e81 <= _e195.x) {
                phi_586_ = 1f;
            } else {
                if (_e81 > _e195.y) {
                    let _e201 = local_1.moments;
                    let _e212 = (((_e201.y - (_e201.x * (_e195.x + _e195.y))) + (_e195.x * _e195.y)) / ((_e81 - _e195.x) * (_e81 - _e195.y)));
                    if ((bitcast<u32>(_e212) & 2147483647u) > 2139095040u) {
                        phi_545_ = _e212;
                    } else {
                        if (_e212 < 0f) {
                            phi_544_ = 0f;
                        } else {
                            if (_e212 > 1f) {
                                phi_543_ = 1f;
                            } else {
                                phi_543_ = _e212;
                            }
                            let _e219 = phi_543_;
                            phi_544_ = _e219;
                        }
                        let _e221 = phi_544_;
                        phi_545_ = _e221;
                    }
                    let _e223 = phi_545_;
                    phi_585_ = _e223;
                } else {
                    if (_e81 > _e195.x) {
                        let _e226 = local_1.moments;
                        let _e238 = (1f - (((_e226.y - (_e226.x * (_e81 + _e195.y))) + (_e81 * _e195.y)) / ((_e195.x - _e81) * (_e195.x - _e195.y))));
                        if ((bitcast<u32>(_e238) & 2147483647u) > 2139095040u) {
                            phi_580_ = _e238;
                        } else {
                            if (_e238 < 0f) {
                                phi_579_ = 0f;
                            } else {
                                if (_e238 > 1f) {
                                    phi_578_ = 1f;
                                } else {
                                    phi_578_ = _e238;
                                }
                                let _e245 = phi_578_;
                                phi_579_ = _e245;
                            }
                            let _e247 = phi_579_;
                            phi_580_ = _e247;
                        }
                        let _e249 = phi_580_;
                        phi_584_ = _e249;
                    } else {
                        phi_584_ = bitcast<f32>((bitcast<u32>(_e195.x) | 2143289344u));
                    }
                    let _e254 = phi_584_;
                    phi_585_ = _e254;
                }
                let _e256 = phi_585_;
                phi_586_ = _e256;
            }
            let _e258 = phi_586_;
            phi_587_ = _e258;
            phi_588_ = false;
        } else {
            phi_587_ = f32();
            phi_588_ = true;
        }
        let _e260 = phi_587_;
        let _e262 = phi_588_;
        phi_589_ = _e260;
        phi_590_ = _e262;
    } else {
        phi_589_ = f32();
        phi_590_ = true;
    }
    let _e264 = phi_589_;
    let _e266 = phi_590_;
    if _e266 {
        if ((bitcast<u32>(_e136.x) & 2147483647u) > 2139095040u) {
            phi_601_ = _e136.x;
        } else {
            let _e270 = lt_math_hausdorff_endpoint_upper_bound((&local_1), _e81);
            phi_601_ = _e270;
        }
        let _e272 = phi_601_;
        phi_602_ = _e272;
    } else {
        phi_602_ = _e264;
    }
    let _e274 = phi_602_;
    return _e274;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_20: ptr<function, f32>, param_21: vec4<f32>, param_22: vec4<f32>, param_23: f32) -> f32 {
    let _e41 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_21.x);
    let _e43 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_21.y);
    let _e45 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_21.z);
    let _e47 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_21.w);
    let _e97 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_20, vec4<f32>(((((_e41.x * param_22.x) + (_e43.x * param_22.y)) + (_e45.x * param_22.z)) + (_e47.x * param_22.w)), ((((_e41.y * param_22.x) + (_e43.y * param_22.y)) + (_e45.y * param_22.z)) + (_e47.y * param_22.w)), ((((_e41.z * param_22.x) + (_e43.z * param_22.y)) + (_e45.z * param_22.z)) + (_e47.z * param_22.w)), ((((_e41.w * param_22.x) + (_e43.w * param_22.y)) + (_e45.w * param_22.z)) + (_e47.w * param_22.w))), param_23);
    return _e97;
}

fn function_() {
    var local_2: f32;
    var phi_821_: bool;
    var phi_822_: bool;
    var phi_823_: bool;
    var phi_824_: bool;
    var phi_828_: bool;
    var phi_863_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_867_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_960_: bool;
    var phi_961_: bool;
    var phi_962_: bool;
    var phi_963_: bool;
    var phi_964_: bool;
    var phi_965_: bool;
    var phi_966_: bool;
    var phi_967_: bool;
    var phi_968_: bool;
    var phi_969_: bool;
    var phi_970_: bool;
    var phi_971_: bool;
    var phi_975_: bool;
    var phi_1076_: bool;
    var phi_1084_: bool;
    var phi_1089_: f32;
    var phi_1092_: evaluate_Verdict;
    var phi_1093_: evaluate_Verdict;
    var phi_1097_: bool;
    var phi_1098_: u32;
    var phi_1104_: u32;

    let _e37 = id_1;
    let _e38 = local_3;
    let _e43 = arrayLength((&map.member));
    if (_e38 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    let _e50 = p.member.size[0u];
    let _e52 = p.member.size[1u];
    let _e53 = lt_shaders_entry_pixel_index(_e37, _e50, _e52);
    if (bitcast<i32>(_e53.root) != 0i) {
        let _e60 = p.member.light;
        let _e63 = samples.member[_e53.first_primitive].normal[0u];
        let _e65 = global[0u];
        if (_e63 == _e65) {
            let _e68 = samples.member[_e53.first_primitive].normal[1u];
            let _e70 = global[1u];
            if (_e68 == _e70) {
                let _e73 = samples.member[_e53.first_primitive].normal[2u];
                let _e75 = global[2u];
                phi_821_ = (_e73 == _e75);
                phi_822_ = false;
            } else {
                phi_821_ = bool();
                phi_822_ = true;
            }
            let _e78 = phi_821_;
            let _e80 = phi_822_;
            phi_823_ = _e78;
            phi_824_ = _e80;
        } else {
            phi_823_ = bool();
            phi_824_ = true;
        }
        let _e82 = phi_823_;
        let _e84 = phi_824_;
        if _e84 {
            phi_828_ = false;
        } else {
            phi_828_ = _e82;
        }
        let _e86 = phi_828_;
        if !(_e86) {
            let _e89 = samples.member[_e53.first_primitive].normal;
            let _e91 = samples.member[_e53.first_primitive].position;
            let _e92 = lt_shaders_evaluate_to_light(_e91, _e60);
            if ((((_e89.x * _e92.x) + (_e89.y * _e92.y)) + (_e89.z * _e92.z)) > 0f) {
                let _e106 = samples.member[_e53.first_primitive].flags;
                let _e114 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e120 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e114.unnamed.visibility, false), _e114.unnamed_1);
                phi_863_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e120.unnamed, ((_e106 & 1u) == 0u));
            } else {
                let _e129 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e135 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e129.unnamed.visibility, false), _e129.unnamed_1);
                phi_863_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e135.unnamed, true);
            }
            let _e140 = phi_863_;
            phi_867_ = _e140;
        } else {
            let _e146 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e152 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e146.unnamed.visibility, false), _e146.unnamed_1);
            phi_867_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e152.unnamed, true);
        }
        let _e157 = phi_867_;
        if _e157.unnamed_1 {
            phi_1093_ = evaluate_Verdict(_e157.unnamed.visibility, _e157.unnamed.is_doubted);
        } else {
            let _e165 = samples.member[_e53.first_primitive].position;
            let _e171 = p.member.projection.row_w;
            let _e182 = ((((_e171.x * _e165.x) + (_e171.y * _e165.y)) + (_e171.z * _e165.z)) + (_e171.w * 1f));
            let _e184 = p.member.projection.row_x;
            let _e196 = (((((_e184.x * _e165.x) + (_e184.y * _e165.y)) + (_e184.z * _e165.z)) + (_e184.w * 1f)) / _e182);
            let _e198 = p.member.projection.row_y;
            let _e210 = (((((_e198.x * _e165.x) + (_e198.y * _e165.y)) + (_e198.z * _e165.z)) + (_e198.w * 1f)) / _e182);
            let _e212 = p.member.projection.row_z;
            let _e223 = ((((_e212.x * _e165.x) + (_e212.y * _e165.y)) + (_e212.z * _e165.z)) + (_e212.w * 1f));
            if (_e182 > 0f) {
                if (_e196 >= 0f) {
                    if (_e196 <= 1f) {
                        if (_e210 >= 0f) {
                            if (_e210 <= 1f) {
                                if (_e223 >= 0f) {
                                    phi_960_ = (_e223 <= 1f);
                                    phi_961_ = false;
                                } else {
                                    phi_960_ = bool();
                                    phi_961_ = true;
                                }
                                let _e232 = phi_960_;
                                let _e234 = phi_961_;
                                phi_962_ = _e232;
                                phi_963_ = _e234;
                            } else {
                                phi_962_ = bool();
                                phi_963_ = true;
                            }
                            let _e236 = phi_962_;
                            let _e238 = phi_963_;
                            phi_964_ = _e236;
                            phi_965_ = _e238;
                        } else {
                            phi_964_ = bool();
                            phi_965_ = true;
                        }
                        let _e240 = phi_964_;
                        let _e242 = phi_965_;
                        phi_966_ = _e240;
                        phi_967_ = _e242;
                    } else {
                        phi_966_ = bool();
                        phi_967_ = true;
                    }
                    let _e244 = phi_966_;
                    let _e246 = phi_967_;
                    phi_968_ = _e244;
                    phi_969_ = _e246;
                } else {
                    phi_968_ = bool();
                    phi_969_ = true;
                }
                let _e248 = phi_968_;
                let _e250 = phi_969_;
                phi_970_ = _e248;
                phi_971_ = _e250;
            } else {
                phi_970_ = bool();
                phi_971_ = true;
            }
            let _e252 = phi_970_;
            let _e254 = phi_971_;
            if _e254 {
                phi_975_ = false;
            } else {
                phi_975_ = _e252;
            }
            let _e256 = phi_975_;
            if _e256 {
                let _e258 = p.member.map_size;
                let _e259 = f32(_e258);
                let _e262 = ((_e196 * _e259) - 0.5f);
                let _e263 = ((_e210 * _e259) - 0.5f);
                let _e264 = floor(_e262);
                let _e265 = floor(_e263);
                let _e266 = (_e262 - _e264);
                let _e267 = (_e263 - _e265);
                let _e296 = p.member.test;
                let _e297 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e296);
                let _e299 = p.member.map_size;
                local_2 = _e297;
                let _e300 = lt_shaders_evaluate_quad_indices(select(0i, select(select(i32(_e264), i32(-2147483648), (_e264 < bitcast<f32>(3472883712u))), 2147483647i, (_e264 > bitcast<f32>(1325400063u))), (_e264 == _e264)), select(0i, select(select(i32(_e265), i32(-2147483648), (_e265 < bitcast<f32>(3472883712u))), 2147483647i, (_e265 > bitcast<f32>(1325400063u))), (_e265 == _e265)), _e299);
                if (_e300[0] < _e43) {
                } else {
                    return;
                }
                let _e305 = map.member[(0u + _e300[0])];
                if (_e300[1] < _e43) {
                } else {
                    return;
                }
                let _e310 = map.member[(0u + _e300[1])];
                if (_e300[2] < _e43) {
                } else {
                    return;
                }
                let _e315 = map.member[(0u + _e300[2])];
                if (_e300[3] < _e43) {
                } else {
                    return;
                }
                let _e320 = map.member[(0u + _e300[3])];
                let _e322 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local_2), vec4<f32>(_e305, _e310, _e315, _e320), vec4<f32>(((1f - _e266) * (1f - _e267)), (_e266 * (1f - _e267)), ((1f - _e266) * _e267), (_e266 * _e267)), _e223);
                let _e324 = p.member.epsilon;
                if (_e322 <= _e324) {
                    phi_1076_ = true;
                } else {
                    phi_1076_ = (_e322 >= (1f - _e324));
                }
                let _e329 = phi_1076_;
                if ((bitcast<u32>(_e322) & 2147483647u) > 2139095040u) {
                    phi_1084_ = true;
                } else {
                    phi_1084_ = !(_e329);
                }
                let _e335 = phi_1084_;
                if (_e322 > 0.5f) {
                    phi_1089_ = 1f;
                } else {
                    phi_1089_ = 0f;
                }
                let _e338 = phi_1089_;
                phi_1092_ = evaluate_Verdict(_e338, _e335);
            } else {
                phi_1092_ = evaluate_Verdict(1f, true);
            }
            let _e342 = phi_1092_;
            phi_1093_ = _e342;
        }
        let _e344 = phi_1093_;
        visibility.member[_e53.first_primitive] = _e344.visibility;
        phi_1097_ = _e344.is_doubted;
        phi_1098_ = _e53.first_primitive;
    } else {
        phi_1097_ = false;
        phi_1098_ = 0u;
    }
    let _e349 = phi_1097_;
    let _e351 = phi_1098_;
    if _e349 {
        let _e353 = atomicAdd((&shared_[0u]), 1u);
        phi_1104_ = _e353;
    } else {
        phi_1104_ = 0u;
    }
    let _e355 = phi_1104_;
    workgroupBarrier();
    if (_e38 == 0u) {
        let _e359 = atomicLoad((&shared_[0u]));
        let _e360 = atomicAdd((&list.member[3u]), _e359);
        atomicStore((&shared_[1u]), _e360);
    }
    workgroupBarrier();
    if _e349 {
        let _e363 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e363) + _e355)]), _e351);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_msm_hausdorff_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_3 = local;
    function_();
}
