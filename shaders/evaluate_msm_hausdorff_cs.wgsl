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
    var phi_1185_: f32;
    var phi_1186_: f32;
    var phi_1187_: f32;
    var phi_1214_: f32;
    var phi_1215_: f32;
    var phi_1216_: f32;
    var phi_1217_: f32;
    var phi_1218_: bool;
    var phi_1219_: f32;
    var phi_1220_: bool;
    var phi_1248_: f32;
    var phi_1249_: f32;
    var phi_1250_: f32;
    var phi_1251_: f32;
    var phi_1252_: bool;
    var phi_1253_: f32;
    var phi_1254_: bool;
    var phi_1261_: f32;
    var phi_1262_: f32;
    var phi_1263_: f32;
    var phi_1264_: f32;

    let _e35 = (*param_15).moments;
    if (param_16 <= 0f) {
        phi_1264_ = 1f;
    } else {
        let _e44 = ((_e35.z - ((1f + param_16) * _e35.y)) + (param_16 * _e35.x));
        let _e53 = (((_e35.w - ((1f + param_16) * _e35.z)) + (param_16 * _e35.y)) / _e44);
        if (abs(_e44) <= 0.00000047683716f) {
            let _e67 = (1f - (((_e35.y - (_e35.x * (param_16 + 1f))) + (param_16 * 1f)) / ((0f - param_16) * (0f - 1f))));
            if ((bitcast<u32>(_e67) & 2147483647u) > 2139095040u) {
                phi_1187_ = _e67;
            } else {
                if (_e67 < 0f) {
                    phi_1186_ = 0f;
                } else {
                    if (_e67 > 1f) {
                        phi_1185_ = 1f;
                    } else {
                        phi_1185_ = _e67;
                    }
                    let _e74 = phi_1185_;
                    phi_1186_ = _e74;
                }
                let _e76 = phi_1186_;
                phi_1187_ = _e76;
            }
            let _e78 = phi_1187_;
            phi_1263_ = _e78;
        } else {
            if (_e53 > 0f) {
                if (_e53 < param_16) {
                    let _e81 = lt_math_hausdorff_cubic_mass(_e35, 0f, _e53, param_16, 1f);
                    let _e83 = lt_math_hausdorff_cubic_mass(_e35, _e53, 0f, param_16, 1f);
                    let _e84 = ((1f - _e81) - _e83);
                    if ((bitcast<u32>(_e84) & 2147483647u) > 2139095040u) {
                        phi_1216_ = _e84;
                    } else {
                        if (_e84 < 0f) {
                            phi_1215_ = 0f;
                        } else {
                            if (_e84 > 1f) {
                                phi_1214_ = 1f;
                            } else {
                                phi_1214_ = _e84;
                            }
                            let _e91 = phi_1214_;
                            phi_1215_ = _e91;
                        }
                        let _e93 = phi_1215_;
                        phi_1216_ = _e93;
                    }
                    let _e95 = phi_1216_;
                    phi_1217_ = _e95;
                    phi_1218_ = false;
                } else {
                    phi_1217_ = f32();
                    phi_1218_ = true;
                }
                let _e97 = phi_1217_;
                let _e99 = phi_1218_;
                phi_1219_ = _e97;
                phi_1220_ = _e99;
            } else {
                phi_1219_ = f32();
                phi_1220_ = true;
            }
            let _e101 = phi_1219_;
            let _e103 = phi_1220_;
            if _e103 {
                if (_e53 > param_16) {
                    if (_e53 < 1f) {
                        let _e106 = lt_math_hausdorff_cubic_mass(_e35, 0f, _e53, param_16, 1f);
                        let _e107 = (1f - _e106);
                        if ((bitcast<u32>(_e107) & 2147483647u) > 2139095040u) {
                            phi_1250_ = _e107;
                        } else {
                            if (_e107 < 0f) {
                                phi_1249_ = 0f;
                            } else {
                                if (_e107 > 1f) {
                                    phi_1248_ = 1f;
                                } else {
                                    phi_1248_ = _e107;
                                }
                                let _e114 = phi_1248_;
                                phi_1249_ = _e114;
                            }
                            let _e116 = phi_1249_;
                            phi_1250_ = _e116;
                        }
                        let _e118 = phi_1250_;
                        phi_1251_ = _e118;
                        phi_1252_ = false;
                    } else {
                        phi_1251_ = f32();
                        phi_1252_ = true;
                    }
                    let _e120 = phi_1251_;
                    let _e122 = phi_1252_;
                    phi_1253_ = _e120;
                    phi_1254_ = _e122;
                } else {
                    phi_1253_ = f32();
                    phi_1254_ = true;
                }
                let _e124 = phi_1253_;
                let _e126 = phi_1254_;
                if _e126 {
                    phi_1261_ = bitcast<f32>((bitcast<u32>(_e53) | 2143289344u));
                } else {
                    phi_1261_ = _e124;
                }
                let _e131 = phi_1261_;
                phi_1262_ = _e131;
            } else {
                phi_1262_ = _e101;
            }
            let _e133 = phi_1262_;
            phi_1263_ = _e133;
        }
        let _e135 = phi_1263_;
        phi_1264_ = _e135;
    }
    let _e137 = phi_1264_;
    return _e137;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_17: ptr<function, f32>, param_18: vec4<f32>, param_19: f32) -> f32 {
    var local: hankel_HankelFactors;
    var phi_689_: f32;
    var phi_690_: f32;
    var phi_691_: f32;
    var phi_729_: f32;
    var phi_730_: f32;
    var phi_731_: f32;
    var phi_732_: f32;
    var phi_733_: bool;
    var phi_734_: f32;
    var phi_735_: bool;
    var phi_791_: vec2<f32>;
    var phi_829_: f32;
    var phi_830_: f32;
    var phi_831_: f32;
    var phi_864_: f32;
    var phi_865_: f32;
    var phi_866_: f32;
    var phi_870_: f32;
    var phi_871_: f32;
    var phi_872_: f32;
    var phi_873_: f32;
    var phi_926_: vec2<f32>;
    var phi_966_: f32;
    var phi_967_: f32;
    var phi_968_: f32;
    var phi_969_: f32;
    var phi_970_: bool;
    var phi_971_: f32;
    var phi_972_: bool;
    var phi_1028_: vec2<f32>;
    var phi_1066_: f32;
    var phi_1067_: f32;
    var phi_1068_: f32;
    var phi_1101_: f32;
    var phi_1102_: f32;
    var phi_1103_: f32;
    var phi_1107_: f32;
    var phi_1108_: f32;
    var phi_1109_: f32;
    var phi_1110_: f32;
    var phi_1111_: f32;
    var phi_1112_: bool;
    var phi_1113_: f32;
    var phi_1114_: bool;
    var phi_1125_: f32;
    var phi_1126_: f32;
    var phi_1127_: f32;

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
    let _e83 = local.moments[3u];
    if (_e80 == _e83) {
        let _e87 = local.moments[0u];
        let _e90 = local.moments[3u];
        if (_e87 == _e90) {
            if (_e77 > 0f) {
                let _e94 = local.moments;
                if ((bitcast<u32>(_e94.x) & 2147483647u) > 2139095040u) {
                    phi_731_ = _e94.x;
                } else {
                    if (_e94.x < 0f) {
                        phi_730_ = 0f;
                    } else {
                        if (_e94.x > 1f) {
                            phi_729_ = 1f;
                        } else {
                            phi_729_ = _e94.x;
                        }
                        let _e102 = phi_729_;
                        phi_730_ = _e102;
                    }
                    let _e104 = phi_730_;
                    phi_731_ = _e104;
                }
                let _e106 = phi_731_;
                phi_732_ = _e106;
                phi_733_ = false;
            } else {
                phi_732_ = f32();
                phi_733_ = true;
            }
            let _e108 = phi_732_;
            let _e110 = phi_733_;
            phi_734_ = _e108;
            phi_735_ = _e110;
        } else {
            phi_734_ = f32();
            phi_735_ = true;
        }
        let _e112 = phi_734_;
        let _e114 = phi_735_;
        if _e114 {
            let _e117 = local.moments[0u];
            let _e120 = local.moments[1u];
            let _e128 = local.l32_d22_;
            let _e130 = local.d22_;
            let _e131 = (_e128 / _e130);
            let _e132 = (_e77 - _e117);
            let _e138 = local.d22_;
            let _e141 = local.d33_d22_;
            let _e142 = (((((_e77 * _e77) - _e120) - (_e131 * _e132)) * _e138) / _e141);
            let _e144 = local.d22_;
            let _e147 = ((_e132 / _e144) - (_e131 * _e142));
            let _e153 = ((0.5f * _e147) / _e142);
            let _e156 = ((_e153 * _e153) - (((1f - (_e147 * _e117)) - (_e142 * _e120)) / _e142));
            if (_e156 >= 0f) {
                let _e158 = sqrt(_e156);
                phi_791_ = vec2<f32>((-(_e153) - _e158), (-(_e153) + _e158));
            } else {
                phi_791_ = vec2(bitcast<f32>((bitcast<u32>(_e156) | 2143289344u)));
            }
            let _e169 = phi_791_;
            if (_e77 <= _e169.x) {
                phi_872_ = 1f;
            } else {
                if (_e77 > _e169.y) {
                    let _e175 = local.moments;
                    let _e186 = (((_e175.y - (_e175.x * (_e169.x + _e169.y))) + (_e169.x * _e169.y)) / ((_e77 - _e169.x) * (_e77 - _e169.y)));
                    if ((bitcast<u32>(_e186) & 2147483647u) > 2139095040u) {
                        phi_831_ = _e186;
                    } else {
                        if (_e186 < 0f) {
                            phi_830_ = 0f;
                        } else {
                            if (_e186 > 1f) {
                                phi_829_ = 1f;
                            } else {
                                phi_829_ = _e186;
                            }
                            let _e193 = phi_829_;
                            phi_830_ = _e193;
                        }
                        let _e195 = phi_830_;
                        phi_831_ = _e195;
                    }
                    let _e197 = phi_831_;
                    phi_871_ = _e197;
                } else {
                    if (_e77 > _e169.x) {
                        let _e200 = local.moments;
                        let _e212 = (1f - (((_e200.y - (_e200.x * (_e77 + _e169.y))) + (_e77 * _e169.y)) / ((_e169.x - _e77) * (_e169.x - _e169.y))));
                        if ((bitcast<u32>(_e212) & 2147483647u) > 2139095040u) {
                            phi_866_ = _e212;
                        } else {
                            if (_e212 < 0f) {
                                phi_865_ = 0f;
                            } else {
                                if (_e212 > 1f) {
                                    phi_864_ = 1f;
                                } else {
                                    phi_864_ = _e212;
                                }
                                let _e219 = phi_864_;
                                phi_865_ = _e219;
                            }
                            let _e221 = phi_865_;
                            phi_866_ = _e221;
                        }
                        let _e223 = phi_866_;
                        phi_870_ = _e223;
                    } else {
                        phi_870_ = bitcast<f32>((bitcast<u32>(_e169.x) | 2143289344u));
                    }
                    let _e228 = phi_870_;
                    phi_871_ = _e228;
                }
                let _e230 = phi_871_;
                phi_872_ = _e230;
            }
            let _e232 = phi_872_;
            phi_873_ = _e232;
        } else {
            phi_873_ = _e112;
        }
        let _e234 = phi_873_;
        phi_1127_ = _e234;
    } else {
        let _e237 = local.moments[0u];
        let _e240 = local.moments[1u];
        let _e248 = local.l32_d22_;
        let _e250 = local.d22_;
        let _e251 = (_e248 / _e250);
        let _e252 = (_e77 - _e237);
        let _e258 = local.d22_;
        let _e261 = local.d33_d22_;
        let _e262 = (((((_e77 * _e77) - _e240) - (_e251 * _e252)) * _e258) / _e261);
        let _e264 = local.d22_;
        let _e267 = ((_e252 / _e264) - (_e251 * _e262));
        let _e273 = ((0.5f * _e267) / _e262);
        let _e276 = ((_e273 * _e273) - (((1f - (_e267 * _e237)) - (_e262 * _e240)) / _e262));
        if (_e276 >= 0f) {
            let _e278 = sqrt(_e276);
            phi_926_ = vec2<f32>((-(_e273) - _e278), (-(_e273) + _e278));
        } else {
            phi_926_ = vec2(bitcast<f32>((bitcast<u32>(_e276) | 2143289344u)));
        }
        let _e289 = phi_926_;
        if (_e289.x >= 0f) {
            if (_e289.y <= 1f) {
                let _e296 = local.moments[0u];
                let _e299 = local.moments[3u];
                if (_e296 == _e299) {
                    if (_e77 > 0f) {
                        let _e303 = local.moments;
                        if ((bitcast<u32>(_e303.x) & 2147483647u) > 2139095040u) {
                            phi_968_ = _e303.x;
                        } else {
                            if (_e303.x < 0f) {
                                phi_967_ = 0f;
                            } else {
                                if (_e303.x > 1f) {
                                    phi_966_ = 1f;
                                } else {
                                    phi_966_ = _e303.x;
                                }
                                let _e311 = phi_966_;
                                phi_967_ = _e311;
                            }
                            let _e313 = phi_967_;
                            phi_968_ = _e313;
                        }
                        let _e315 = phi_968_;
                        phi_969_ = _e315;
                        phi_970_ = false;
                    } else {
                        phi_969_ = f32();
                        phi_970_ = true;
                    }
                    let _e317 = phi_969_;
                    let _e319 = phi_970_;
                    phi_971_ = _e317;
                    phi_972_ = _e319;
                } else {
                    phi_971_ = f32();
                    phi_972_ = true;
                }
                let _e321 = phi_971_;
                let _e323 = phi_972_;
                if _e323 {
                    let _e326 = local.moments[0u];
                    let _e329 = local.moments[1u];
                    let _e337 = local.l32_d22_;
                    let _e339 = local.d22_;
                    let _e340 = (_e337 / _e339);
                    let _e341 = (_e77 - _e326);
                    let _e347 = local.d22_;
                    let _e350 = local.d33_d22_;
                    let _e351 = (((((_e77 * _e77) - _e329) - (_e340 * _e341)) * _e347) / _e350);
                    let _e353 = local.d22_;
                    let _e356 = ((_e341 / _e353) - (_e340 * _e351));
                    let _e362 = ((0.5f * _e356) / _e351);
                    let _e365 = ((_e362 * _e362) - (((1f - (_e356 * _e326)) - (_e351 * _e329)) / _e351));
                    if (_e365 >= 0f) {
                        let _e367 = sqrt(_e365);
                        phi_1028_ = vec2<f32>((-(_e362) - _e367), (-(_e362) + _e367));
                    } else {
                        phi_1028_ = vec2(bitcast<f32>((bitcast<u32>(_e365) | 2143289344u)));
                    }
                    let _e378 = phi_1028_;
                    if (_e77 <= _e378.x) {
                        phi_1109_ = 1f;
                    } else {
                        if (_e77 > _e378.y) {
                            let _e384 = local.moments;
                            let _e395 = (((_e384.y - (_e384.x * (_e378.x + _e378.y))) + (_e378.x * _e378.y)) / ((_e77 - _e378.x) * (_e77 - _e378.y)));
                            if ((bitcast<u32>(_e395) & 2147483647u) > 2139095040u) {
                                phi_1068_ = _e395;
                            } else {
                                if (_e395 < 0f) {
                                    phi_1067_ = 0f;
                                } else {
                                    if (_e395 > 1f) {
                                        phi_1066_ = 1f;
                                    } else {
                                        phi_1066_ = _e395;
                                    }
                                    let _e402 = phi_1066_;
                                    phi_1067_ = _e402;
                                }
                                let _e404 = phi_1067_;
                                phi_1068_ = _e404;
                            }
                            let _e406 = phi_1068_;
                            phi_1108_ = _e406;
                        } else {
                            if (_e77 > _e378.x) {
                                let _e409 = local.moments;
                                let _e421 = (1f - (((_e409.y - (_e409.x * (_e77 + _e378.y))) + (_e77 * _e378.y)) / ((_e378.x - _e77) * (_e378.x - _e378.y))));
                                if ((bitcast<u32>(_e421) & 2147483647u) > 2139095040u) {
                                    phi_1103_ = _e421;
                                } else {
                                    if (_e421 < 0f) {
                                        phi_1102_ = 0f;
                                    } else {
                                        if (_e421 > 1f) {
                                            phi_1101_ = 1f;
                                        } else {
                                            phi_1101_ = _e421;
                                        }
                                        let _e428 = phi_1101_;
                                        phi_1102_ = _e428;
                                    }
                                    let _e430 = phi_1102_;
                                    phi_1103_ = _e430;
                                }
                                let _e432 = phi_1103_;
                                phi_1107_ = _e432;
                            } else {
                                phi_1107_ = bitcast<f32>((bitcast<u32>(_e378.x) | 2143289344u));
                            }
                            let _e437 = phi_1107_;
                            phi_1108_ = _e437;
                        }
                        let _e439 = phi_1108_;
                        phi_1109_ = _e439;
                    }
                    let _e441 = phi_1109_;
                    phi_1110_ = _e441;
                } else {
                    phi_1110_ = _e321;
                }
                let _e443 = phi_1110_;
                phi_1111_ = _e443;
                phi_1112_ = false;
            } else {
                phi_1111_ = f32();
                phi_1112_ = true;
            }
            let _e445 = phi_1111_;
            let _e447 = phi_1112_;
            phi_1113_ = _e445;
            phi_1114_ = _e447;
        } else {
            phi_1113_ = f32();
            phi_1114_ = true;
        }
        let _e449 = phi_1113_;
        let _e451 = phi_1114_;
        if _e451 {
            if ((bitcast<u32>(_e289.x) & 2147483647u) > 2139095040u) {
                phi_1125_ = _e289.x;
            } else {
                let _e455 = lt_math_hausdorff_endpoint_upper_bound((&local), _e77);
                phi_1125_ = _e455;
            }
            let _e457 = phi_1125_;
            phi_1126_ = _e457;
        } else {
            phi_1126_ = _e449;
        }
        let _e459 = phi_1126_;
        phi_1127_ = _e459;
    }
    let _e461 = phi_1127_;
    return _e461;
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
