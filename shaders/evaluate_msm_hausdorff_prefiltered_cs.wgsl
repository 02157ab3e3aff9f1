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

struct type_21 {
    member: array<abi_Sample>,
}

struct type_25 {
    member: array<f32>,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
}

struct type_34 {
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

struct hankel_HankelFactors {
    moments: vec4<f32>,
    d22_: f32,
    l32_d22_: f32,
    d33_d22_: f32,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_21;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_37;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_25;
@group(0) @binding(2) 
var<storage> map: type_34;

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

fn lt_shaders_evaluate_to_light(param_4: vec3<f32>, param_5: vec4<f32>) -> vec3<f32> {
    return vec3<f32>((param_5.x - (param_4.x * param_5.w)), (param_5.y - (param_4.y * param_5.w)), (param_5.z - (param_4.z * param_5.w)));
}

fn lt_shaders_evaluate_quad_indices(param_6: i32, param_7: i32, param_8: u32) -> array<u32, 4> {
    var phi_185_: i32;
    var phi_190_: i32;
    var phi_195_: i32;
    var phi_200_: i32;
    var phi_209_: i32;
    var phi_214_: i32;
    var phi_219_: i32;
    var phi_224_: i32;

    let _e36 = (bitcast<i32>(param_8) - 1i);
    if (param_6 > 0i) {
        phi_185_ = param_6;
    } else {
        phi_185_ = 0i;
    }
    let _e39 = phi_185_;
    if (param_7 > 0i) {
        phi_190_ = param_7;
    } else {
        phi_190_ = 0i;
    }
    let _e42 = phi_190_;
    if (_e39 < _e36) {
        phi_195_ = _e39;
    } else {
        phi_195_ = _e36;
    }
    let _e45 = phi_195_;
    if (_e42 < _e36) {
        phi_200_ = _e42;
    } else {
        phi_200_ = _e36;
    }
    let _e48 = phi_200_;
    let _e49 = bitcast<u32>(_e45);
    let _e51 = (param_6 + 1i);
    let _e52 = (param_7 + 1i);
    if (_e51 > 0i) {
        phi_209_ = _e51;
    } else {
        phi_209_ = 0i;
    }
    let _e55 = phi_209_;
    if (_e52 > 0i) {
        phi_214_ = _e52;
    } else {
        phi_214_ = 0i;
    }
    let _e58 = phi_214_;
    if (_e55 < _e36) {
        phi_219_ = _e55;
    } else {
        phi_219_ = _e36;
    }
    let _e61 = phi_219_;
    if (_e58 < _e36) {
        phi_224_ = _e58;
    } else {
        phi_224_ = _e36;
    }
    let _e64 = phi_224_;
    let _e65 = bitcast<u32>(_e61);
    let _e67 = (bitcast<u32>(_e48) * param_8);
    let _e68 = (bitcast<u32>(_e64) * param_8);
    return array<u32, 4>((_e67 + _e49), (_e67 + _e65), (_e68 + _e49), (_e68 + _e65));
}

fn lt_math_hausdorff_cubic_mass(param_9: vec4<f32>, param_10: f32, param_11: f32, param_12: f32, param_13: f32) -> f32 {
    return ((((param_9.z - (((param_11 + param_12) + param_13) * param_9.y)) + ((((param_11 * param_12) + (param_11 * param_13)) + (param_12 * param_13)) * param_9.x)) - ((param_11 * param_12) * param_13)) / (((param_10 - param_11) * (param_10 - param_12)) * (param_10 - param_13)));
}

fn lt_math_hausdorff_endpoint_upper_bound(param_14: ptr<function, hankel_HankelFactors>, param_15: f32) -> f32 {
    var phi_780_: f32;
    var phi_781_: f32;
    var phi_782_: f32;
    var phi_809_: f32;
    var phi_810_: f32;
    var phi_811_: f32;
    var phi_812_: f32;
    var phi_813_: bool;
    var phi_814_: f32;
    var phi_815_: bool;
    var phi_843_: f32;
    var phi_844_: f32;
    var phi_845_: f32;
    var phi_846_: f32;
    var phi_847_: bool;
    var phi_848_: f32;
    var phi_849_: bool;
    var phi_856_: f32;
    var phi_857_: f32;
    var phi_858_: f32;
    var phi_859_: f32;

    let _e35 = (*param_14).moments;
    if (param_15 <= 0f) {
        phi_859_ = 1f;
    } else {
        let _e44 = ((_e35.z - ((1f + param_15) * _e35.y)) + (param_15 * _e35.x));
        let _e53 = (((_e35.w - ((1f + param_15) * _e35.z)) + (param_15 * _e35.y)) / _e44);
        if (abs(_e44) <= 0.00000047683716f) {
            let _e67 = (1f - (((_e35.y - (_e35.x * (param_15 + 1f))) + (param_15 * 1f)) / ((0f - param_15) * (0f - 1f))));
            if ((bitcast<u32>(_e67) & 2147483647u) > 2139095040u) {
                phi_782_ = _e67;
            } else {
                if (_e67 < 0f) {
                    phi_781_ = 0f;
                } else {
                    if (_e67 > 1f) {
                        phi_780_ = 1f;
                    } else {
                        phi_780_ = _e67;
                    }
                    let _e74 = phi_780_;
                    phi_781_ = _e74;
                }
                let _e76 = phi_781_;
                phi_782_ = _e76;
            }
            let _e78 = phi_782_;
            phi_858_ = _e78;
        } else {
            if (_e53 > 0f) {
                if (_e53 < param_15) {
                    let _e81 = lt_math_hausdorff_cubic_mass(_e35, 0f, _e53, param_15, 1f);
                    let _e83 = lt_math_hausdorff_cubic_mass(_e35, _e53, 0f, param_15, 1f);
                    let _e84 = ((1f - _e81) - _e83);
                    if ((bitcast<u32>(_e84) & 2147483647u) > 2139095040u) {
                        phi_811_ = _e84;
                    } else {
                        if (_e84 < 0f) {
                            phi_810_ = 0f;
                        } else {
                            if (_e84 > 1f) {
                                phi_809_ = 1f;
                            } else {
                                phi_809_ = _e84;
                            }
                            let _e91 = phi_809_;
                            phi_810_ = _e91;
                        }
                        let _e93 = phi_810_;
                        phi_811_ = _e93;
                    }
                    let _e95 = phi_811_;
                    phi_812_ = _e95;
                    phi_813_ = false;
                } else {
                    phi_812_ = f32();
                    phi_813_ = true;
                }
                let _e97 = phi_812_;
                let _e99 = phi_813_;
                phi_814_ = _e97;
                phi_815_ = _e99;
            } else {
                phi_814_ = f32();
                phi_815_ = true;
            }
            let _e101 = phi_814_;
            let _e103 = phi_815_;
            if _e103 {
                if (_e53 > param_15) {
                    if (_e53 < 1f) {
                        let _e106 = lt_math_hausdorff_cubic_mass(_e35, 0f, _e53, param_15, 1f);
                        let _e107 = (1f - _e106);
                        if ((bitcast<u32>(_e107) & 2147483647u) > 2139095040u) {
                            phi_845_ = _e107;
                        } else {
                            if (_e107 < 0f) {
                                phi_844_ = 0f;
                            } else {
                                if (_e107 > 1f) {
                                    phi_843_ = 1f;
                                } else {
                                    phi_843_ = _e107;
                                }
                                let _e114 = phi_843_;
                                phi_844_ = _e114;
                            }
                            let _e116 = phi_844_;
                            phi_845_ = _e116;
                        }
                        let _e118 = phi_845_;
                        phi_846_ = _e118;
                        phi_847_ = false;
                    } else {
                        phi_846_ = f32();
                        phi_847_ = true;
                    }
                    let _e120 = phi_846_;
                    let _e122 = phi_847_;
                    phi_848_ = _e120;
                    phi_849_ = _e122;
                } else {
                    phi_848_ = f32();
                    phi_849_ = true;
                }
                let _e124 = phi_848_;
                let _e126 = phi_849_;
                if _e126 {
                    phi_856_ = bitcast<f32>((bitcast<u32>(_e53) | 2143289344u));
                } else {
                    phi_856_ = _e124;
                }
                let _e131 = phi_856_;
                phi_857_ = _e131;
            } else {
                phi_857_ = _e101;
            }
            let _e133 = phi_857_;
            phi_858_ = _e133;
        }
        let _e135 = phi_858_;
        phi_859_ = _e135;
    }
    let _e137 = phi_859_;
    return _e137;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_16: ptr<function, f32>, param_17: vec4<f32>, param_18: f32) -> f32 {
    var local: hankel_HankelFactors;
    var phi_284_: f32;
    var phi_285_: f32;
    var phi_286_: f32;
    var phi_324_: f32;
    var phi_325_: f32;
    var phi_326_: f32;
    var phi_327_: f32;
    var phi_328_: bool;
    var phi_329_: f32;
    var phi_330_: bool;
    var phi_386_: vec2<f32>;
    var phi_424_: f32;
    var phi_425_: f32;
    var phi_426_: f32;
    var phi_459_: f32;
    var phi_460_: f32;
    var phi_461_: f32;
    var phi_465_: f32;
    var phi_466_: f32;
    var phi_467_: f32;
    var phi_468_: f32;
    var phi_521_: vec2<f32>;
    var phi_561_: f32;
    var phi_562_: f32;
    var phi_563_: f32;
    var phi_564_: f32;
    var phi_565_: bool;
    var phi_566_: f32;
    var phi_567_: bool;
    var phi_623_: vec2<f32>;
    var phi_661_: f32;
    var phi_662_: f32;
    var phi_663_: f32;
    var phi_696_: f32;
    var phi_697_: f32;
    var phi_698_: f32;
    var phi_702_: f32;
    var phi_703_: f32;
    var phi_704_: f32;
    var phi_705_: f32;
    var phi_706_: f32;
    var phi_707_: bool;
    var phi_708_: f32;
    var phi_709_: bool;
    var phi_720_: f32;
    var phi_721_: f32;
    var phi_722_: f32;

    let _e36 = (*param_16);
    let _e37 = (1f - _e36);
    let _e46 = (0.5f * _e36);
    let _e47 = ((param_17.x * _e37) + _e46);
    let _e48 = ((param_17.y * _e37) + _e46);
    let _e49 = ((param_17.z * _e37) + _e46);
    let _e50 = ((param_17.w * _e37) + _e46);
    let _e53 = (_e48 - (_e47 * _e47));
    let _e55 = (_e49 - (_e47 * _e48));
    let _e61 = hankel_HankelFactors(vec4<f32>(_e47, _e48, _e49, _e50), _e53, _e55, (((_e50 - (_e48 * _e48)) * _e53) - (_e55 * _e55)));
    local = hankel_HankelFactors(_e61.moments, _e61.d22_, _e61.l32_d22_, _e61.d33_d22_);
    if ((bitcast<u32>(param_18) & 2147483647u) > 2139095040u) {
        phi_286_ = param_18;
    } else {
        if (param_18 < 0f) {
            phi_285_ = 0f;
        } else {
            if (param_18 > 1f) {
                phi_284_ = 1f;
            } else {
                phi_284_ = param_18;
            }
            let _e73 = phi_284_;
            phi_285_ = _e73;
        }
        let _e75 = phi_285_;
        phi_286_ = _e75;
    }
    let _e77 = phi_286_;
    let _e80 = local.moments[0u];
    let _e83 = local.moments[3u];
    if (_e80 == _e83) {
        let _e87 = local.moments[0u];
        let _e90 = local.moments[3u];
        if (_e87 == _e90) {
            if (_e77 > 0f) {
                let _e94 = local.moments;
                if ((bitcast<u32>(_e94.x) & 2147483647u) > 2139095040u) {
                    phi_326_ = _e94.x;
                } else {
                    if (_e94.x < 0f) {
                        phi_325_ = 0f;
                    } else {
                        if (_e94.x > 1f) {
                            phi_324_ = 1f;
                        } else {
                            phi_324_ = _e94.x;
                        }
                        let _e102 = phi_324_;
                        phi_325_ = _e102;
                    }
                    let _e104 = phi_325_;
                    phi_326_ = _e104;
                }
                let _e106 = phi_326_;
                phi_327_ = _e106;
                phi_328_ = false;
            } else {
                phi_327_ = f32();
                phi_328_ = true;
            }
            let _e108 = phi_327_;
            let _e110 = phi_328_;
            phi_329_ = _e108;
            phi_330_ = _e110;
        } else {
            phi_329_ = f32();
            phi_330_ = true;
        }
        let _e112 = phi_329_;
        let _e114 = phi_330_;
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
                phi_386_ = vec2<f32>((-(_e153) - _e158), (-(_e153) + _e158));
            } else {
                phi_386_ = vec2(bitcast<f32>((bitcast<u32>(_e156) | 2143289344u)));
            }
            let _e169 = phi_386_;
            if (_e77 <= _e169.x) {
                phi_467_ = 1f;
            } else {
                if (_e77 > _e169.y) {
                    let _e175 = local.moments;
                    let _e186 = (((_e175.y - (_e175.x * (_e169.x + _e169.y))) + (_e169.x * _e169.y)) / ((_e77 - _e169.x) * (_e77 - _e169.y)));
                    if ((bitcast<u32>(_e186) & 2147483647u) > 2139095040u) {
                        phi_426_ = _e186;
                    } else {
                        if (_e186 < 0f) {
                            phi_425_ = 0f;
                        } else {
                            if (_e186 > 1f) {
                                phi_424_ = 1f;
                            } else {
                                phi_424_ = _e186;
                            }
                            let _e193 = phi_424_;
                            phi_425_ = _e193;
                        }
                        let _e195 = phi_425_;
                        phi_426_ = _e195;
                    }
                    let _e197 = phi_426_;
                    phi_466_ = _e197;
                } else {
                    if (_e77 > _e169.x) {
                        let _e200 = local.moments;
                        let _e212 = (1f - (((_e200.y - (_e200.x * (_e77 + _e169.y))) + (_e77 * _e169.y)) / ((_e169.x - _e77) * (_e169.x - _e169.y))));
                        if ((bitcast<u32>(_e212) & 2147483647u) > 2139095040u) {
                            phi_461_ = _e212;
                        } else {
                            if (_e212 < 0f) {
                                phi_460_ = 0f;
                            } else {
                                if (_e212 > 1f) {
                                    phi_459_ = 1f;
                                } else {
                                    phi_459_ = _e212;
                                }
                                let _e219 = phi_459_;
                                phi_460_ = _e219;
                            }
                            let _e221 = phi_460_;
                            phi_461_ = _e221;
                        }
                        let _e223 = phi_461_;
                        phi_465_ = _e223;
                    } else {
                        phi_465_ = bitcast<f32>((bitcast<u32>(_e169.x) | 2143289344u));
                    }
                    let _e228 = phi_465_;
                    phi_466_ = _e228;
                }
                let _e230 = phi_466_;
                phi_467_ = _e230;
            }
            let _e232 = phi_467_;
            phi_468_ = _e232;
        } else {
            phi_468_ = _e112;
        }
        let _e234 = phi_468_;
        phi_722_ = _e234;
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
            phi_521_ = vec2<f32>((-(_e273) - _e278), (-(_e273) + _e278));
        } else {
            phi_521_ = vec2(bitcast<f32>((bitcast<u32>(_e276) | 2143289344u)));
        }
        let _e289 = phi_521_;
        if (_e289.x >= 0f) {
            if (_e289.y <= 1f) {
                let _e296 = local.moments[0u];
                let _e299 = local.moments[3u];
                if (_e296 == _e299) {
                    if (_e77 > 0f) {
                        let _e303 = local.moments;
                        if ((bitcast<u32>(_e303.x) & 2147483647u) > 2139095040u) {
                            phi_563_ = _e303.x;
                        } else {
                            if (_e303.x < 0f) {
                                phi_562_ = 0f;
                            } else {
                                if (_e303.x > 1f) {
                                    phi_561_ = 1f;
                                } else {
                                    phi_561_ = _e303.x;
                                }
                                let _e311 = phi_561_;
                                phi_562_ = _e311;
                            }
                            let _e313 = phi_562_;
                            phi_563_ = _e313;
                        }
                        let _e315 = phi_563_;
                        phi_564_ = _e315;
                        phi_565_ = false;
                    } else {
                        phi_564_ = f32();
                        phi_565_ = true;
                    }
                    let _e317 = phi_564_;
                    let _e319 = phi_565_;
                    phi_566_ = _e317;
                    phi_567_ = _e319;
                } else {
                    phi_566_ = f32();
                    phi_567_ = true;
                }
                let _e321 = phi_566_;
                let _e323 = phi_567_;
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
                        phi_623_ = vec2<f32>((-(_e362) - _e367), (-(_e362) + _e367));
                    } else {
                        phi_623_ = vec2(bitcast<f32>((bitcast<u32>(_e365) | 2143289344u)));
                    }
                    let _e378 = phi_623_;
                    if (_e77 <= _e378.x) {
                        phi_704_ = 1f;
                    } else {
                        if (_e77 > _e378.y) {
                            let _e384 = local.moments;
                            let _e395 = (((_e384.y - (_e384.x * (_e378.x + _e378.y))) + (_e378.x * _e378.y)) / ((_e77 - _e378.x) * (_e77 - _e378.y)));
                            if ((bitcast<u32>(_e395) & 2147483647u) > 2139095040u) {
                                phi_663_ = _e395;
                            } else {
                                if (_e395 < 0f) {
                                    phi_662_ = 0f;
                                } else {
                                    if (_e395 > 1f) {
                                        phi_661_ = 1f;
                                    } else {
                                        phi_661_ = _e395;
                                    }
                                    let _e402 = phi_661_;
                                    phi_662_ = _e402;
                                }
                                let _e404 = phi_662_;
                                phi_663_ = _e404;
                            }
                            let _e406 = phi_663_;
                            phi_703_ = _e406;
                        } else {
                            if (_e77 > _e378.x) {
                                let _e409 = local.moments;
                                let _e421 = (1f - (((_e409.y - (_e409.x * (_e77 + _e378.y))) + (_e77 * _e378.y)) / ((_e378.x - _e77) * (_e378.x - _e378.y))));
                                if ((bitcast<u32>(_e421) & 2147483647u) > 2139095040u) {
                                    phi_698_ = _e421;
                                } else {
                                    if (_e421 < 0f) {
                                        phi_697_ = 0f;
                                    } else {
                                        if (_e421 > 1f) {
                                            phi_696_ = 1f;
                                        } else {
                                            phi_696_ = _e421;
                                        }
                                        let _e428 = phi_696_;
                                        phi_697_ = _e428;
                                    }
                                    let _e430 = phi_697_;
                                    phi_698_ = _e430;
                                }
                                let _e432 = phi_698_;
                                phi_702_ = _e432;
                            } else {
                                phi_702_ = bitcast<f32>((bitcast<u32>(_e378.x) | 2143289344u));
                            }
                            let _e437 = phi_702_;
                            phi_703_ = _e437;
                        }
                        let _e439 = phi_703_;
                        phi_704_ = _e439;
                    }
                    let _e441 = phi_704_;
                    phi_705_ = _e441;
                } else {
                    phi_705_ = _e321;
                }
                let _e443 = phi_705_;
                phi_706_ = _e443;
                phi_707_ = false;
            } else {
                phi_706_ = f32();
                phi_707_ = true;
            }
            let _e445 = phi_706_;
            let _e447 = phi_707_;
            phi_708_ = _e445;
            phi_709_ = _e447;
        } else {
            phi_708_ = f32();
            phi_709_ = true;
        }
        let _e449 = phi_708_;
        let _e451 = phi_709_;
        if _e451 {
            if ((bitcast<u32>(_e289.x) & 2147483647u) > 2139095040u) {
                phi_720_ = _e289.x;
            } else {
                let _e455 = lt_math_hausdorff_endpoint_upper_bound((&local), _e77);
                phi_720_ = _e455;
            }
            let _e457 = phi_720_;
            phi_721_ = _e457;
        } else {
            phi_721_ = _e449;
        }
        let _e459 = phi_721_;
        phi_722_ = _e459;
    }
    let _e461 = phi_722_;
    return _e461;
}

fn function_() {
    var local_1: f32;
    var phi_942_: bool;
    var phi_943_: bool;
    var phi_944_: bool;
    var phi_945_: bool;
    var phi_949_: bool;
    var phi_984_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_988_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1081_: bool;
    var phi_1082_: bool;
    var phi_1083_: bool;
    var phi_1084_: bool;
    var phi_1085_: bool;
    var phi_1086_: bool;
    var phi_1087_: bool;
    var phi_1088_: bool;
    var phi_1089_: bool;
    var phi_1090_: bool;
    var phi_1091_: bool;
    var phi_1092_: bool;
    var phi_1096_: bool;
    var phi_1235_: evaluate_Verdict;
    var phi_1236_: evaluate_Verdict;
    var phi_1237_: bool;
    var phi_1238_: evaluate_Verdict;
    var phi_1239_: evaluate_Verdict;
    var phi_1240_: bool;
    var phi_1244_: evaluate_Verdict;

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
                phi_942_ = (_e71 == _e73);
                phi_943_ = false;
            } else {
                phi_942_ = bool();
                phi_943_ = true;
            }
            let _e76 = phi_942_;
            let _e78 = phi_943_;
            phi_944_ = _e76;
            phi_945_ = _e78;
        } else {
            phi_944_ = bool();
            phi_945_ = true;
        }
        let _e80 = phi_944_;
        let _e82 = phi_945_;
        if _e82 {
            phi_949_ = false;
        } else {
            phi_949_ = _e80;
        }
        let _e84 = phi_949_;
        if !(_e84) {
            let _e87 = samples.member[(0u + _e49.first_primitive)].normal;
            let _e89 = samples.member[(0u + _e49.first_primitive)].position;
            let _e90 = lt_shaders_evaluate_to_light(_e89, _e58);
            if ((((_e87.x * _e90.x) + (_e87.y * _e90.y)) + (_e87.z * _e90.z)) > 0f) {
                let _e104 = samples.member[(0u + _e49.first_primitive)].flags;
                let _e112 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e118 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e112.unnamed.visibility, false), _e112.unnamed_1);
                phi_984_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e118.unnamed, ((_e104 & 1u) == 0u));
            } else {
                let _e127 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e133 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e127.unnamed.visibility, false), _e127.unnamed_1);
                phi_984_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e133.unnamed, true);
            }
            let _e138 = phi_984_;
            phi_988_ = _e138;
        } else {
            let _e144 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e150 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e144.unnamed.visibility, false), _e144.unnamed_1);
            phi_988_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e150.unnamed, true);
        }
        let _e155 = phi_988_;
        if _e155.unnamed_1 {
            phi_1238_ = evaluate_Verdict(_e155.unnamed.visibility, _e155.unnamed.is_doubted);
            phi_1239_ = evaluate_Verdict();
            phi_1240_ = true;
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
                                    phi_1081_ = (_e221 <= 1f);
                                    phi_1082_ = false;
                                } else {
                                    phi_1081_ = bool();
                                    phi_1082_ = true;
                                }
                                let _e230 = phi_1081_;
                                let _e232 = phi_1082_;
                                phi_1083_ = _e230;
                                phi_1084_ = _e232;
                            } else {
                                phi_1083_ = bool();
                                phi_1084_ = true;
                            }
                            let _e234 = phi_1083_;
                            let _e236 = phi_1084_;
                            phi_1085_ = _e234;
                            phi_1086_ = _e236;
                        } else {
                            phi_1085_ = bool();
                            phi_1086_ = true;
                        }
                        let _e238 = phi_1085_;
                        let _e240 = phi_1086_;
                        phi_1087_ = _e238;
                        phi_1088_ = _e240;
                    } else {
                        phi_1087_ = bool();
                        phi_1088_ = true;
                    }
                    let _e242 = phi_1087_;
                    let _e244 = phi_1088_;
                    phi_1089_ = _e242;
                    phi_1090_ = _e244;
                } else {
                    phi_1089_ = bool();
                    phi_1090_ = true;
                }
                let _e246 = phi_1089_;
                let _e248 = phi_1090_;
                phi_1091_ = _e246;
                phi_1092_ = _e248;
            } else {
                phi_1091_ = bool();
                phi_1092_ = true;
            }
            let _e250 = phi_1091_;
            let _e252 = phi_1092_;
            if _e252 {
                phi_1096_ = false;
            } else {
                phi_1096_ = _e250;
            }
            let _e254 = phi_1096_;
            if _e254 {
                let _e256 = p.member.map_size;
                let _e257 = f32(_e256);
                let _e260 = ((_e194 * _e257) - 0.5f);
                let _e261 = ((_e208 * _e257) - 0.5f);
                let _e262 = floor(_e260);
                let _e263 = floor(_e261);
                let _e264 = (_e260 - _e262);
                let _e265 = (_e261 - _e263);
                let _e286 = ((1f - _e264) * (1f - _e265));
                let _e288 = (_e264 * (1f - _e265));
                let _e290 = ((1f - _e264) * _e265);
                let _e291 = (_e264 * _e265);
                let _e293 = p.member.test;
                let _e294 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e293);
                let _e296 = p.member.map_size;
                local_1 = _e294;
                let _e297 = lt_shaders_evaluate_quad_indices(select(0i, select(select(i32(_e262), i32(-2147483648), (_e262 < bitcast<f32>(3472883712u))), 2147483647i, (_e262 > bitcast<f32>(1325400063u))), (_e262 == _e262)), select(0i, select(select(i32(_e263), i32(-2147483648), (_e263 < bitcast<f32>(3472883712u))), 2147483647i, (_e263 > bitcast<f32>(1325400063u))), (_e263 == _e263)), _e296);
                if (_e297[0] < _e40) {
                } else {
                    return;
                }
                let _e302 = map.member[(0u + _e297[0])];
                if (_e297[1] < _e40) {
                } else {
                    return;
                }
                let _e315 = map.member[(0u + _e297[1])];
                if (_e297[2] < _e40) {
                } else {
                    return;
                }
                let _e332 = map.member[(0u + _e297[2])];
                if (_e297[3] < _e40) {
                } else {
                    return;
                }
                let _e349 = map.member[(0u + _e297[3])];
                let _e363 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_1), vec4<f32>(((((_e302.x * _e286) + (_e315.x * _e288)) + (_e332.x * _e290)) + (_e349.x * _e291)), ((((_e302.y * _e286) + (_e315.y * _e288)) + (_e332.y * _e290)) + (_e349.y * _e291)), ((((_e302.z * _e286) + (_e315.z * _e288)) + (_e332.z * _e290)) + (_e349.z * _e291)), ((((_e302.w * _e286) + (_e315.w * _e288)) + (_e332.w * _e290)) + (_e349.w * _e291))), _e221);
                phi_1235_ = evaluate_Verdict(_e363, false);
                phi_1236_ = evaluate_Verdict();
                phi_1237_ = false;
            } else {
                phi_1235_ = evaluate_Verdict();
                phi_1236_ = evaluate_Verdict(1f, false);
                phi_1237_ = true;
            }
            let _e367 = phi_1235_;
            let _e369 = phi_1236_;
            let _e371 = phi_1237_;
            phi_1238_ = _e369;
            phi_1239_ = _e367;
            phi_1240_ = _e371;
        }
        let _e373 = phi_1238_;
        let _e375 = phi_1239_;
        let _e377 = phi_1240_;
        if _e377 {
            phi_1244_ = _e373;
        } else {
            phi_1244_ = _e375;
        }
        let _e379 = phi_1244_;
        if (_e49.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e49.first_primitive)] = _e379.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_msm_hausdorff_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
