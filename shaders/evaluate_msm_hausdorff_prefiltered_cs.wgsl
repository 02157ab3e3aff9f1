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

struct type_18 {
    member: array<abi_Sample>,
}

struct type_22 {
    member: array<f32>,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
}

struct type_30 {
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

struct type_34 {
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
var<storage> samples: type_18;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_34;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_22;
@group(0) @binding(2) 
var<storage> map: type_30;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_141_: lt_bvh_traverse_Tree;
    var phi_142_: bool;
    var phi_143_: lt_bvh_traverse_Tree;
    var phi_144_: bool;
    var phi_149_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_141_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_142_ = false;
        } else {
            phi_141_ = lt_bvh_traverse_Tree();
            phi_142_ = true;
        }
        let _e48 = phi_141_;
        let _e50 = phi_142_;
        phi_143_ = _e48;
        phi_144_ = _e50;
    } else {
        phi_143_ = lt_bvh_traverse_Tree();
        phi_144_ = true;
    }
    let _e52 = phi_143_;
    let _e54 = phi_144_;
    if _e54 {
        phi_149_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_149_ = _e52;
    }
    let _e59 = phi_149_;
    return lt_bvh_traverse_Tree(_e59.root, _e59.first_primitive);
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn lt_math_hausdorff_cubic_mass(param_4: vec4<f32>, param_5: f32, param_6: f32, param_7: f32, param_8: f32) -> f32 {
    return ((((param_4.z - (((param_6 + param_7) + param_8) * param_4.y)) + ((((param_6 * param_7) + (param_6 * param_8)) + (param_7 * param_8)) * param_4.x)) - ((param_6 * param_7) * param_8)) / (((param_5 - param_6) * (param_5 - param_7)) * (param_5 - param_8)));
}

fn lt_math_hausdorff_endpoint_upper_bound(param_9: ptr<function, hankel_HankelFactors>, param_10: f32) -> f32 {
    var phi_926_: f32;
    var phi_927_: f32;
    var phi_928_: f32;
    var phi_955_: f32;
    var phi_956_: f32;
    var phi_957_: f32;
    var phi_958_: f32;
    var phi_959_: bool;
    var phi_960_: f32;
    var phi_961_: bool;
    var phi_989_: f32;
    var phi_990_: f32;
    var phi_991_: f32;
    var phi_992_: f32;
    var phi_993_: bool;
    var phi_994_: f32;
    var phi_995_: bool;
    var phi_1002_: f32;
    var phi_1003_: f32;
    var phi_1004_: f32;
    var phi_1005_: f32;

    let _e38 = (*param_9).moments;
    if (param_10 < 0.0001f) {
        phi_1005_ = 1f;
    } else {
        let _e47 = ((_e38.z - ((1f + param_10) * _e38.y)) + (param_10 * _e38.x));
        let _e56 = (((_e38.w - ((1f + param_10) * _e38.z)) + (param_10 * _e38.y)) / _e47);
        if (abs(_e47) <= 0.00000047683716f) {
            let _e70 = (1f - (((_e38.y - (_e38.x * (param_10 + 1f))) + (param_10 * 1f)) / ((0f - param_10) * (0f - 1f))));
            if ((bitcast<u32>(_e70) & 2147483647u) > 2139095040u) {
                phi_928_ = _e70;
            } else {
                if (_e70 < 0f) {
                    phi_927_ = 0f;
                } else {
                    if (_e70 > 1f) {
                        phi_926_ = 1f;
                    } else {
                        phi_926_ = _e70;
                    }
                    let _e77 = phi_926_;
                    phi_927_ = _e77;
                }
                let _e79 = phi_927_;
                phi_928_ = _e79;
            }
            let _e81 = phi_928_;
            phi_1004_ = _e81;
        } else {
            if (_e56 > 0f) {
                if (_e56 < param_10) {
                    let _e84 = lt_math_hausdorff_cubic_mass(_e38, 0f, _e56, param_10, 1f);
                    let _e86 = lt_math_hausdorff_cubic_mass(_e38, _e56, 0f, param_10, 1f);
                    let _e87 = ((1f - _e84) - _e86);
                    if ((bitcast<u32>(_e87) & 2147483647u) > 2139095040u) {
                        phi_957_ = _e87;
                    } else {
                        if (_e87 < 0f) {
                            phi_956_ = 0f;
                        } else {
                            if (_e87 > 1f) {
                                phi_955_ = 1f;
                            } else {
                                phi_955_ = _e87;
                            }
                            let _e94 = phi_955_;
                            phi_956_ = _e94;
                        }
                        let _e96 = phi_956_;
                        phi_957_ = _e96;
                    }
                    let _e98 = phi_957_;
                    phi_958_ = _e98;
                    phi_959_ = false;
                } else {
                    phi_958_ = f32();
                    phi_959_ = true;
                }
                let _e100 = phi_958_;
                let _e102 = phi_959_;
                phi_960_ = _e100;
                phi_961_ = _e102;
            } else {
                phi_960_ = f32();
                phi_961_ = true;
            }
            let _e104 = phi_960_;
            let _e106 = phi_961_;
            if _e106 {
                if (_e56 > param_10) {
                    if (_e56 < 1f) {
                        let _e109 = lt_math_hausdorff_cubic_mass(_e38, 0f, _e56, param_10, 1f);
                        let _e110 = (1f - _e109);
                        if ((bitcast<u32>(_e110) & 2147483647u) > 2139095040u) {
                            phi_991_ = _e110;
                        } else {
                            if (_e110 < 0f) {
                                phi_990_ = 0f;
                            } else {
                                if (_e110 > 1f) {
                                    phi_989_ = 1f;
                                } else {
                                    phi_989_ = _e110;
                                }
                                let _e117 = phi_989_;
                                phi_990_ = _e117;
                            }
                            let _e119 = phi_990_;
                            phi_991_ = _e119;
                        }
                        let _e121 = phi_991_;
                        phi_992_ = _e121;
                        phi_993_ = false;
                    } else {
                        phi_992_ = f32();
                        phi_993_ = true;
                    }
                    let _e123 = phi_992_;
                    let _e125 = phi_993_;
                    phi_994_ = _e123;
                    phi_995_ = _e125;
                } else {
                    phi_994_ = f32();
                    phi_995_ = true;
                }
                let _e127 = phi_994_;
                let _e129 = phi_995_;
                if _e129 {
                    phi_1002_ = bitcast<f32>((bitcast<u32>(_e56) | 2143289344u));
                } else {
                    phi_1002_ = _e127;
                }
                let _e134 = phi_1002_;
                phi_1003_ = _e134;
            } else {
                phi_1003_ = _e104;
            }
            let _e136 = phi_1003_;
            phi_1004_ = _e136;
        }
        let _e138 = phi_1004_;
        phi_1005_ = _e138;
    }
    let _e140 = phi_1005_;
    return _e140;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_11: ptr<function, f32>, param_12: vec4<f32>, param_13: f32) -> f32 {
    var local: hankel_HankelFactors;
    var phi_206_: f32;
    var phi_207_: f32;
    var phi_208_: f32;
    var phi_220_: bool;
    var phi_235_: bool;
    var phi_260_: f32;
    var phi_261_: f32;
    var phi_262_: f32;
    var phi_263_: f32;
    var phi_264_: bool;
    var phi_265_: f32;
    var phi_266_: bool;
    var phi_322_: vec2<f32>;
    var phi_360_: f32;
    var phi_361_: f32;
    var phi_362_: f32;
    var phi_395_: f32;
    var phi_396_: f32;
    var phi_397_: f32;
    var phi_401_: f32;
    var phi_402_: f32;
    var phi_403_: f32;
    var phi_404_: f32;
    var phi_457_: vec2<f32>;
    var phi_479_: bool;
    var phi_504_: f32;
    var phi_505_: f32;
    var phi_506_: f32;
    var phi_507_: f32;
    var phi_508_: bool;
    var phi_509_: f32;
    var phi_510_: bool;
    var phi_566_: vec2<f32>;
    var phi_604_: f32;
    var phi_605_: f32;
    var phi_606_: f32;
    var phi_639_: f32;
    var phi_640_: f32;
    var phi_641_: f32;
    var phi_645_: f32;
    var phi_646_: f32;
    var phi_647_: f32;
    var phi_648_: f32;
    var phi_649_: f32;
    var phi_650_: bool;
    var phi_651_: f32;
    var phi_652_: bool;
    var phi_674_: bool;
    var phi_699_: f32;
    var phi_700_: f32;
    var phi_701_: f32;
    var phi_702_: f32;
    var phi_703_: bool;
    var phi_704_: f32;
    var phi_705_: bool;
    var phi_761_: vec2<f32>;
    var phi_799_: f32;
    var phi_800_: f32;
    var phi_801_: f32;
    var phi_834_: f32;
    var phi_835_: f32;
    var phi_836_: f32;
    var phi_840_: f32;
    var phi_841_: f32;
    var phi_842_: f32;
    var phi_843_: f32;
    var phi_860_: bool;
    var phi_864_: f32;
    var phi_865_: f32;
    var phi_866_: f32;
    var phi_867_: f32;
    var phi_868_: f32;

    let _e39 = (*param_11);
    let _e40 = (1f - _e39);
    let _e49 = (0.5f * _e39);
    let _e50 = ((param_12.x * _e40) + _e49);
    let _e51 = ((param_12.y * _e40) + _e49);
    let _e52 = ((param_12.z * _e40) + _e49);
    let _e53 = ((param_12.w * _e40) + _e49);
    let _e56 = (_e51 - (_e50 * _e50));
    let _e58 = (_e52 - (_e50 * _e51));
    let _e64 = hankel_HankelFactors(vec4<f32>(_e50, _e51, _e52, _e53), _e56, _e58, (((_e53 - (_e51 * _e51)) * _e56) - (_e58 * _e58)));
    local = hankel_HankelFactors(_e64.moments, _e64.d22_, _e64.l32_d22_, _e64.d33_d22_);
    if ((bitcast<u32>(param_13) & 2147483647u) > 2139095040u) {
        phi_208_ = param_13;
    } else {
        if (param_13 < 0f) {
            phi_207_ = 0f;
        } else {
            if (param_13 > 1f) {
                phi_206_ = 1f;
            } else {
                phi_206_ = param_13;
            }
            let _e76 = phi_206_;
            phi_207_ = _e76;
        }
        let _e78 = phi_207_;
        phi_208_ = _e78;
    }
    let _e80 = phi_208_;
    let _e83 = local.moments[0u];
    let _e86 = local.moments[3u];
    if (_e83 == _e86) {
        let _e90 = local.moments[0u];
        phi_220_ = (_e90 > 0.5f);
    } else {
        phi_220_ = false;
    }
    let _e93 = phi_220_;
    if _e93 {
        let _e96 = local.moments[0u];
        let _e99 = local.moments[3u];
        if (_e96 == _e99) {
            let _e103 = local.moments[0u];
            phi_235_ = (_e103 > 0.5f);
        } else {
            phi_235_ = false;
        }
        let _e106 = phi_235_;
        if _e106 {
            if (_e80 > 0f) {
                let _e109 = local.moments;
                if ((bitcast<u32>(_e109.x) & 2147483647u) > 2139095040u) {
                    phi_262_ = _e109.x;
                } else {
                    if (_e109.x < 0f) {
                        phi_261_ = 0f;
                    } else {
                        if (_e109.x > 1f) {
                            phi_260_ = 1f;
                        } else {
                            phi_260_ = _e109.x;
                        }
                        let _e117 = phi_260_;
                        phi_261_ = _e117;
                    }
                    let _e119 = phi_261_;
                    phi_262_ = _e119;
                }
                let _e121 = phi_262_;
                phi_263_ = _e121;
                phi_264_ = false;
            } else {
                phi_263_ = f32();
                phi_264_ = true;
            }
            let _e123 = phi_263_;
            let _e125 = phi_264_;
            phi_265_ = _e123;
            phi_266_ = _e125;
        } else {
            phi_265_ = f32();
            phi_266_ = true;
        }
        let _e127 = phi_265_;
        let _e129 = phi_266_;
        if _e129 {
            let _e132 = local.moments[0u];
            let _e135 = local.moments[1u];
            let _e143 = local.l32_d22_;
            let _e145 = local.d22_;
            let _e146 = (_e143 / _e145);
            let _e147 = (_e80 - _e132);
            let _e153 = local.d22_;
            let _e156 = local.d33_d22_;
            let _e157 = (((((_e80 * _e80) - _e135) - (_e146 * _e147)) * _e153) / _e156);
            let _e159 = local.d22_;
            let _e162 = ((_e147 / _e159) - (_e146 * _e157));
            let _e168 = ((0.5f * _e162) / _e157);
            let _e171 = ((_e168 * _e168) - (((1f - (_e162 * _e132)) - (_e157 * _e135)) / _e157));
            if (_e171 >= 0f) {
                let _e173 = sqrt(_e171);
                phi_322_ = vec2<f32>((-(_e168) - _e173), (-(_e168) + _e173));
            } else {
                phi_322_ = vec2(bitcast<f32>((bitcast<u32>(_e171) | 2143289344u)));
            }
            let _e184 = phi_322_;
            if (_e80 <= _e184.x) {
                phi_403_ = 1f;
            } else {
                if (_e80 > _e184.y) {
                    let _e190 = local.moments;
                    let _e201 = (((_e190.y - (_e190.x * (_e184.x + _e184.y))) + (_e184.x * _e184.y)) / ((_e80 - _e184.x) * (_e80 - _e184.y)));
                    if ((bitcast<u32>(_e201) & 2147483647u) > 2139095040u) {
                        phi_362_ = _e201;
                    } else {
                        if (_e201 < 0f) {
                            phi_361_ = 0f;
                        } else {
                            if (_e201 > 1f) {
                                phi_360_ = 1f;
                            } else {
                                phi_360_ = _e201;
                            }
                            let _e208 = phi_360_;
                            phi_361_ = _e208;
                        }
                        let _e210 = phi_361_;
                        phi_362_ = _e210;
                    }
                    let _e212 = phi_362_;
                    phi_402_ = _e212;
                } else {
                    if (_e80 > _e184.x) {
                        let _e215 = local.moments;
                        let _e227 = (1f - (((_e215.y - (_e215.x * (_e80 + _e184.y))) + (_e80 * _e184.y)) / ((_e184.x - _e80) * (_e184.x - _e184.y))));
                        if ((bitcast<u32>(_e227) & 2147483647u) > 2139095040u) {
                            phi_397_ = _e227;
                        } else {
                            if (_e227 < 0f) {
                                phi_396_ = 0f;
                            } else {
                                if (_e227 > 1f) {
                                    phi_395_ = 1f;
                                } else {
                                    phi_395_ = _e227;
                                }
                                let _e234 = phi_395_;
                                phi_396_ = _e234;
                            }
                            let _e236 = phi_396_;
                            phi_397_ = _e236;
                        }
                        let _e238 = phi_397_;
                        phi_401_ = _e238;
                    } else {
                        phi_401_ = bitcast<f32>((bitcast<u32>(_e184.x) | 2143289344u));
                    }
                    let _e243 = phi_401_;
                    phi_402_ = _e243;
                }
                let _e245 = phi_402_;
                phi_403_ = _e245;
            }
            let _e247 = phi_403_;
            phi_404_ = _e247;
        } else {
            phi_404_ = _e127;
        }
        let _e249 = phi_404_;
        phi_868_ = _e249;
    } else {
        let _e252 = local.moments[0u];
        let _e255 = local.moments[1u];
        let _e263 = local.l32_d22_;
        let _e265 = local.d22_;
        let _e266 = (_e263 / _e265);
        let _e267 = (_e80 - _e252);
        let _e273 = local.d22_;
        let _e276 = local.d33_d22_;
        let _e277 = (((((_e80 * _e80) - _e255) - (_e266 * _e267)) * _e273) / _e276);
        let _e279 = local.d22_;
        let _e282 = ((_e267 / _e279) - (_e266 * _e277));
        let _e288 = ((0.5f * _e282) / _e277);
        let _e291 = ((_e288 * _e288) - (((1f - (_e282 * _e252)) - (_e277 * _e255)) / _e277));
        if (_e291 >= 0f) {
            let _e293 = sqrt(_e291);
            phi_457_ = vec2<f32>((-(_e288) - _e293), (-(_e288) + _e293));
        } else {
            phi_457_ = vec2(bitcast<f32>((bitcast<u32>(_e291) | 2143289344u)));
        }
        let _e304 = phi_457_;
        if (_e304.x >= 0f) {
            if (_e304.y <= 1f) {
                let _e311 = local.moments[0u];
                let _e314 = local.moments[3u];
                if (_e311 == _e314) {
                    let _e318 = local.moments[0u];
                    phi_479_ = (_e318 > 0.5f);
                } else {
                    phi_479_ = false;
                }
                let _e321 = phi_479_;
                if _e321 {
                    if (_e80 > 0f) {
                        let _e324 = local.moments;
                        if ((bitcast<u32>(_e324.x) & 2147483647u) > 2139095040u) {
                            phi_506_ = _e324.x;
                        } else {
                            if (_e324.x < 0f) {
                                phi_505_ = 0f;
                            } else {
                                if (_e324.x > 1f) {
                                    phi_504_ = 1f;
                                } else {
                                    phi_504_ = _e324.x;
                                }
                                let _e332 = phi_504_;
                                phi_505_ = _e332;
                            }
                            let _e334 = phi_505_;
                            phi_506_ = _e334;
                        }
                        let _e336 = phi_506_;
                        phi_507_ = _e336;
                        phi_508_ = false;
                    } else {
                        phi_507_ = f32();
                        phi_508_ = true;
                    }
                    let _e338 = phi_507_;
                    let _e340 = phi_508_;
                    phi_509_ = _e338;
                    phi_510_ = _e340;
                } else {
                    phi_509_ = f32();
                    phi_510_ = true;
                }
                let _e342 = phi_509_;
                let _e344 = phi_510_;
                if _e344 {
                    let _e347 = local.moments[0u];
                    let _e350 = local.moments[1u];
                    let _e358 = local.l32_d22_;
                    let _e360 = local.d22_;
                    let _e361 = (_e358 / _e360);
                    let _e362 = (_e80 - _e347);
                    let _e368 = local.d22_;
                    let _e371 = local.d33_d22_;
                    let _e372 = (((((_e80 * _e80) - _e350) - (_e361 * _e362)) * _e368) / _e371);
                    let _e374 = local.d22_;
                    let _e377 = ((_e362 / _e374) - (_e361 * _e372));
                    let _e383 = ((0.5f * _e377) / _e372);
                    let _e386 = ((_e383 * _e383) - (((1f - (_e377 * _e347)) - (_e372 * _e350)) / _e372));
                    if (_e386 >= 0f) {
                        let _e388 = sqrt(_e386);
                        phi_566_ = vec2<f32>((-(_e383) - _e388), (-(_e383) + _e388));
                    } else {
                        phi_566_ = vec2(bitcast<f32>((bitcast<u32>(_e386) | 2143289344u)));
                    }
                    let _e399 = phi_566_;
                    if (_e80 <= _e399.x) {
                        phi_647_ = 1f;
                    } else {
                        if (_e80 > _e399.y) {
                            let _e405 = local.moments;
                            let _e416 = (((_e405.y - (_e405.x * (_e399.x + _e399.y))) + (_e399.x * _e399.y)) / ((_e80 - _e399.x) * (_e80 - _e399.y)));
                            if ((bitcast<u32>(_e416) & 2147483647u) > 2139095040u) {
                                phi_606_ = _e416;
                            } else {
                                if (_e416 < 0f) {
                                    phi_605_ = 0f;
                                } else {
                                    if (_e416 > 1f) {
                                        phi_604_ = 1f;
                                    } else {
                                        phi_604_ = _e416;
                                    }
                                    let _e423 = phi_604_;
                                    phi_605_ = _e423;
                                }
                                let _e425 = phi_605_;
                                phi_606_ = _e425;
                            }
                            let _e427 = phi_606_;
                            phi_646_ = _e427;
                        } else {
                            if (_e80 > _e399.x) {
                                let _e430 = local.moments;
                                let _e442 = (1f - (((_e430.y - (_e430.x * (_e80 + _e399.y))) + (_e80 * _e399.y)) / ((_e399.x - _e80) * (_e399.x - _e399.y))));
                                if ((bitcast<u32>(_e442) & 2147483647u) > 2139095040u) {
                                    phi_641_ = _e442;
                                } else {
                                    if (_e442 < 0f) {
                                        phi_640_ = 0f;
                                    } else {
                                        if (_e442 > 1f) {
                                            phi_639_ = 1f;
                                        } else {
                                            phi_639_ = _e442;
                                        }
                                        let _e449 = phi_639_;
                                        phi_640_ = _e449;
                                    }
                                    let _e451 = phi_640_;
                                    phi_641_ = _e451;
                                }
                                let _e453 = phi_641_;
                                phi_645_ = _e453;
                            } else {
                                phi_645_ = bitcast<f32>((bitcast<u32>(_e399.x) | 2143289344u));
                            }
                            let _e458 = phi_645_;
                            phi_646_ = _e458;
                        }
                        let _e460 = phi_646_;
                        phi_647_ = _e460;
                    }
                    let _e462 = phi_647_;
                    phi_648_ = _e462;
                } else {
                    phi_648_ = _e342;
                }
                let _e464 = phi_648_;
                phi_649_ = _e464;
                phi_650_ = false;
            } else {
                phi_649_ = f32();
                phi_650_ = true;
            }
            let _e466 = phi_649_;
            let _e468 = phi_650_;
            phi_651_ = _e466;
            phi_652_ = _e468;
        } else {
            phi_651_ = f32();
            phi_652_ = true;
        }
        let _e470 = phi_651_;
        let _e472 = phi_652_;
        if _e472 {
            if ((bitcast<u32>(_e304.x) & 2147483647u) > 2139095040u) {
                phi_866_ = _e304.x;
            } else {
                let _e476 = lt_math_hausdorff_endpoint_upper_bound((&local), _e80);
                let _e479 = local.moments[0u];
                let _e482 = local.moments[3u];
                if (_e479 == _e482) {
                    let _e486 = local.moments[0u];
                    phi_674_ = (_e486 > 0.5f);
                } else {
                    phi_674_ = false;
                }
                let _e489 = phi_674_;
                if _e489 {
                    if (_e80 > 0f) {
                        let _e492 = local.moments;
                        if ((bitcast<u32>(_e492.x) & 2147483647u) > 2139095040u) {
                            phi_701_ = _e492.x;
                        } else {
                            if (_e492.x < 0f) {
                                phi_700_ = 0f;
                            } else {
                                if (_e492.x > 1f) {
                                    phi_699_ = 1f;
                                } else {
                                    phi_699_ = _e492.x;
                                }
                                let _e500 = phi_699_;
                                phi_700_ = _e500;
                            }
                            let _e502 = phi_700_;
                            phi_701_ = _e502;
                        }
                        let _e504 = phi_701_;
                        phi_702_ = _e504;
                        phi_703_ = false;
                    } else {
                        phi_702_ = f32();
                        phi_703_ = true;
                    }
                    let _e506 = phi_702_;
                    let _e508 = phi_703_;
                    phi_704_ = _e506;
                    phi_705_ = _e508;
                } else {
                    phi_704_ = f32();
                    phi_705_ = true;
                }
                let _e510 = phi_704_;
                let _e512 = phi_705_;
                if _e512 {
                    let _e515 = local.moments[0u];
                    let _e518 = local.moments[1u];
                    let _e526 = local.l32_d22_;
                    let _e528 = local.d22_;
                    let _e529 = (_e526 / _e528);
                    let _e530 = (_e80 - _e515);
                    let _e536 = local.d22_;
                    let _e539 = local.d33_d22_;
                    let _e540 = (((((_e80 * _e80) - _e518) - (_e529 * _e530)) * _e536) / _e539);
                    let _e542 = local.d22_;
                    let _e545 = ((_e530 / _e542) - (_e529 * _e540));
                    let _e551 = ((0.5f * _e545) / _e540);
                    let _e554 = ((_e551 * _e551) - (((1f - (_e545 * _e515)) - (_e540 * _e518)) / _e540));
                    if (_e554 >= 0f) {
                        let _e556 = sqrt(_e554);
                        phi_761_ = vec2<f32>((-(_e551) - _e556), (-(_e551) + _e556));
                    } else {
                        phi_761_ = vec2(bitcast<f32>((bitcast<u32>(_e554) | 2143289344u)));
                    }
                    let _e567 = phi_761_;
                    if (_e80 <= _e567.x) {
                        phi_842_ = 1f;
                    } else {
                        if (_e80 > _e567.y) {
                            let _e573 = local.moments;
                            let _e584 = (((_e573.y - (_e573.x * (_e567.x + _e567.y))) + (_e567.x * _e567.y)) / ((_e80 - _e567.x) * (_e80 - _e567.y)));
                            if ((bitcast<u32>(_e584) & 2147483647u) > 2139095040u) {
                                phi_801_ = _e584;
                            } else {
                                if (_e584 < 0f) {
                                    phi_800_ = 0f;
                                } else {
                                    if (_e584 > 1f) {
                                        phi_799_ = 1f;
                                    } else {
                                        phi_799_ = _e584;
                                    }
                                    let _e591 = phi_799_;
                                    phi_800_ = _e591;
                                }
                                let _e593 = phi_800_;
                                phi_801_ = _e593;
                            }
                            let _e595 = phi_801_;
                            phi_841_ = _e595;
                        } else {
                            if (_e80 > _e567.x) {
                                let _e598 = local.moments;
                                let _e610 = (1f - (((_e598.y - (_e598.x * (_e80 + _e567.y))) + (_e80 * _e567.y)) / ((_e567.x - _e80) * (_e567.x - _e567.y))));
                                if ((bitcast<u32>(_e610) & 2147483647u) > 2139095040u) {
                                    phi_836_ = _e610;
                                } else {
                                    if (_e610 < 0f) {
                                        phi_835_ = 0f;
                                    } else {
                                        if (_e610 > 1f) {
                                            phi_834_ = 1f;
                                        } else {
                                            phi_834_ = _e610;
                                        }
                                        let _e617 = phi_834_;
                                        phi_835_ = _e617;
                                    }
                                    let _e619 = phi_835_;
                                    phi_836_ = _e619;
                                }
                                let _e621 = phi_836_;
                                phi_840_ = _e621;
                            } else {
                                phi_840_ = bitcast<f32>((bitcast<u32>(_e567.x) | 2143289344u));
                            }
                            let _e626 = phi_840_;
                            phi_841_ = _e626;
                        }
                        let _e628 = phi_841_;
                        phi_842_ = _e628;
                    }
                    let _e630 = phi_842_;
                    phi_843_ = _e630;
                } else {
                    phi_843_ = _e510;
                }
                let _e632 = phi_843_;
                if ((bitcast<u32>(_e476) & 2147483647u) > 2139095040u) {
                    phi_865_ = _e476;
                } else {
                    if ((bitcast<u32>(_e632) & 2147483647u) > 2139095040u) {
                        phi_860_ = true;
                    } else {
                        let _e639 = (_e632 < _e476);
                        if _e639 {
                        }
                        phi_860_ = _e639;
                    }
                    let _e641 = phi_860_;
                    if _e641 {
                        phi_864_ = _e632;
                    } else {
                        phi_864_ = _e476;
                    }
                    let _e643 = phi_864_;
                    phi_865_ = _e643;
                }
                let _e645 = phi_865_;
                phi_866_ = _e645;
            }
            let _e647 = phi_866_;
            phi_867_ = _e647;
        } else {
            phi_867_ = _e470;
        }
        let _e649 = phi_867_;
        phi_868_ = _e649;
    }
    let _e651 = phi_868_;
    return _e651;
}

fn function_() {
    var local_1: f32;
    var phi_1088_: bool;
    var phi_1089_: bool;
    var phi_1090_: bool;
    var phi_1091_: bool;
    var phi_1095_: bool;
    var phi_1139_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1143_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1220_: bool;
    var phi_1229_: bool;
    var phi_1238_: bool;
    var phi_1239_: bool;
    var phi_1240_: bool;
    var phi_1241_: bool;
    var phi_1242_: bool;
    var phi_1243_: bool;
    var phi_1244_: bool;
    var phi_1248_: bool;
    var phi_1284_: f32;
    var phi_1289_: f32;
    var phi_1290_: bool;
    var phi_1291_: f32;
    var phi_1292_: bool;
    var phi_1296_: f32;
    var phi_1316_: f32;
    var phi_1321_: f32;
    var phi_1322_: bool;
    var phi_1323_: f32;
    var phi_1324_: bool;
    var phi_1328_: f32;
    var phi_1374_: i32;
    var phi_1379_: i32;
    var phi_1384_: i32;
    var phi_1389_: i32;
    var phi_1398_: i32;
    var phi_1403_: i32;
    var phi_1408_: i32;
    var phi_1413_: i32;
    var phi_1498_: evaluate_Verdict;
    var phi_1499_: evaluate_Verdict;
    var phi_1500_: bool;
    var phi_1501_: evaluate_Verdict;
    var phi_1502_: evaluate_Verdict;
    var phi_1503_: bool;
    var phi_1507_: evaluate_Verdict;

    let _e36 = id_1;
    let _e43 = arrayLength((&map.member));
    let _e49 = p.member.size[0u];
    let _e51 = p.member.size[1u];
    let _e52 = lt_shaders_entry_pixel_index(_e36, _e49, _e51);
    if (bitcast<i32>(_e52.root) != 0i) {
        if (_e52.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e61 = p.member.light;
        let _e64 = samples.member[(0u + _e52.first_primitive)].normal[0u];
        let _e66 = global[0u];
        if (_e64 == _e66) {
            let _e69 = samples.member[(0u + _e52.first_primitive)].normal[1u];
            let _e71 = global[1u];
            if (_e69 == _e71) {
                let _e74 = samples.member[(0u + _e52.first_primitive)].normal[2u];
                let _e76 = global[2u];
                phi_1088_ = (_e74 == _e76);
                phi_1089_ = false;
            } else {
                phi_1088_ = bool();
                phi_1089_ = true;
            }
            let _e79 = phi_1088_;
            let _e81 = phi_1089_;
            phi_1090_ = _e79;
            phi_1091_ = _e81;
        } else {
            phi_1090_ = bool();
            phi_1091_ = true;
        }
        let _e83 = phi_1090_;
        let _e85 = phi_1091_;
        if _e85 {
            phi_1095_ = false;
        } else {
            phi_1095_ = _e83;
        }
        let _e87 = phi_1095_;
        if !(_e87) {
            let _e90 = samples.member[(0u + _e52.first_primitive)].normal;
            let _e92 = samples.member[(0u + _e52.first_primitive)].position;
            if ((((_e90.x * (_e61.x - (_e92.x * _e61.w))) + (_e90.y * (_e61.y - (_e92.y * _e61.w)))) + (_e90.z * (_e61.z - (_e92.z * _e61.w)))) > 0f) {
                let _e116 = samples.member[(0u + _e52.first_primitive)].flags;
                let _e124 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e130 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e124.unnamed.visibility, false), _e124.unnamed_1);
                phi_1139_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e130.unnamed, ((_e116 & 1u) == 0u));
            } else {
                let _e139 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e145 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e139.unnamed.visibility, false), _e139.unnamed_1);
                phi_1139_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e145.unnamed, true);
            }
            let _e150 = phi_1139_;
            phi_1143_ = _e150;
        } else {
            let _e156 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e162 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e156.unnamed.visibility, false), _e156.unnamed_1);
            phi_1143_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e162.unnamed, true);
        }
        let _e167 = phi_1143_;
        if _e167.unnamed_1 {
            phi_1501_ = evaluate_Verdict(_e167.unnamed.visibility, _e167.unnamed.is_doubted);
            phi_1502_ = evaluate_Verdict();
            phi_1503_ = true;
        } else {
            let _e175 = samples.member[(0u + _e52.first_primitive)].position;
            let _e181 = p.member.projection.row_w;
            let _e192 = ((((_e181.x * _e175.x) + (_e181.y * _e175.y)) + (_e181.z * _e175.z)) + (_e181.w * 1f));
            let _e194 = p.member.projection.row_x;
            let _e206 = (((((_e194.x * _e175.x) + (_e194.y * _e175.y)) + (_e194.z * _e175.z)) + (_e194.w * 1f)) / _e192);
            let _e208 = p.member.projection.row_y;
            let _e220 = (((((_e208.x * _e175.x) + (_e208.y * _e175.y)) + (_e208.z * _e175.z)) + (_e208.w * 1f)) / _e192);
            let _e222 = p.member.projection.row_z;
            let _e233 = ((((_e222.x * _e175.x) + (_e222.y * _e175.y)) + (_e222.z * _e175.z)) + (_e222.w * 1f));
            if (_e192 > 0f) {
                if (_e206 >= 0f) {
                    phi_1220_ = (_e206 <= 1f);
                } else {
                    phi_1220_ = false;
                }
                let _e238 = phi_1220_;
                if _e238 {
                    if (_e220 >= 0f) {
                        phi_1229_ = (_e220 <= 1f);
                    } else {
                        phi_1229_ = false;
                    }
                    let _e242 = phi_1229_;
                    if _e242 {
                        if (_e233 >= 0f) {
                            phi_1238_ = (_e233 <= 1f);
                        } else {
                            phi_1238_ = false;
                        }
                        let _e246 = phi_1238_;
                        phi_1239_ = _e246;
                        phi_1240_ = false;
                    } else {
                        phi_1239_ = bool();
                        phi_1240_ = true;
                    }
                    let _e248 = phi_1239_;
                    let _e250 = phi_1240_;
                    phi_1241_ = _e248;
                    phi_1242_ = _e250;
                } else {
                    phi_1241_ = bool();
                    phi_1242_ = true;
                }
                let _e252 = phi_1241_;
                let _e254 = phi_1242_;
                phi_1243_ = _e252;
                phi_1244_ = _e254;
            } else {
                phi_1243_ = bool();
                phi_1244_ = true;
            }
            let _e256 = phi_1243_;
            let _e258 = phi_1244_;
            if _e258 {
                phi_1248_ = false;
            } else {
                phi_1248_ = _e256;
            }
            let _e260 = phi_1248_;
            if _e260 {
                let _e262 = p.member.map_size;
                let _e263 = f32(_e262);
                let _e266 = ((_e206 * _e263) - 0.5f);
                let _e267 = ((_e220 * _e263) - 0.5f);
                if (_e266 > -8388608f) {
                    let _e279 = f32(select(0i, select(select(i32(_e266), i32(-2147483648), (_e266 < bitcast<f32>(3472883712u))), 2147483647i, (_e266 > bitcast<f32>(1325400063u))), (_e266 == _e266)));
                    if (_e279 > _e266) {
                        phi_1284_ = 1f;
                    } else {
                        phi_1284_ = 0f;
                    }
                    let _e282 = phi_1284_;
                    if (_e266 < 8388608f) {
                        phi_1289_ = (_e279 - _e282);
                        phi_1290_ = false;
                    } else {
                        phi_1289_ = f32();
                        phi_1290_ = true;
                    }
                    let _e285 = phi_1289_;
                    let _e287 = phi_1290_;
                    phi_1291_ = _e285;
                    phi_1292_ = _e287;
                } else {
                    phi_1291_ = f32();
                    phi_1292_ = true;
                }
                let _e289 = phi_1291_;
                let _e291 = phi_1292_;
                if _e291 {
                    phi_1296_ = _e266;
                } else {
                    phi_1296_ = _e289;
                }
                let _e293 = phi_1296_;
                if (_e267 > -8388608f) {
                    let _e305 = f32(select(0i, select(select(i32(_e267), i32(-2147483648), (_e267 < bitcast<f32>(3472883712u))), 2147483647i, (_e267 > bitcast<f32>(1325400063u))), (_e267 == _e267)));
                    if (_e305 > _e267) {
                        phi_1316_ = 1f;
                    } else {
                        phi_1316_ = 0f;
                    }
                    let _e308 = phi_1316_;
                    if (_e267 < 8388608f) {
                        phi_1321_ = (_e305 - _e308);
                        phi_1322_ = false;
                    } else {
                        phi_1321_ = f32();
                        phi_1322_ = true;
                    }
                    let _e311 = phi_1321_;
                    let _e313 = phi_1322_;
                    phi_1323_ = _e311;
                    phi_1324_ = _e313;
                } else {
                    phi_1323_ = f32();
                    phi_1324_ = true;
                }
                let _e315 = phi_1323_;
                let _e317 = phi_1324_;
                if _e317 {
                    phi_1328_ = _e267;
                } else {
                    phi_1328_ = _e315;
                }
                let _e319 = phi_1328_;
                let _e320 = (_e266 - _e293);
                let _e321 = (_e267 - _e319);
                let _e330 = select(0i, select(select(i32(_e293), i32(-2147483648), (_e293 < bitcast<f32>(3472883712u))), 2147483647i, (_e293 > bitcast<f32>(1325400063u))), (_e293 == _e293));
                let _e339 = select(0i, select(select(i32(_e319), i32(-2147483648), (_e319 < bitcast<f32>(3472883712u))), 2147483647i, (_e319 > bitcast<f32>(1325400063u))), (_e319 == _e319));
                let _e342 = ((1f - _e320) * (1f - _e321));
                let _e344 = (_e320 * (1f - _e321));
                let _e346 = ((1f - _e320) * _e321);
                let _e347 = (_e320 * _e321);
                let _e349 = p.member.test;
                let _e350 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e349);
                let _e352 = p.member.map_size;
                local_1 = _e350;
                let _e354 = (bitcast<i32>(_e352) - 1i);
                if (_e330 > 0i) {
                    phi_1374_ = _e330;
                } else {
                    phi_1374_ = 0i;
                }
                let _e357 = phi_1374_;
                if (_e339 > 0i) {
                    phi_1379_ = _e339;
                } else {
                    phi_1379_ = 0i;
                }
                let _e360 = phi_1379_;
                if (_e357 < _e354) {
                    phi_1384_ = _e357;
                } else {
                    phi_1384_ = _e354;
                }
                let _e363 = phi_1384_;
                if (_e360 < _e354) {
                    phi_1389_ = _e360;
                } else {
                    phi_1389_ = _e354;
                }
                let _e366 = phi_1389_;
                let _e367 = bitcast<u32>(_e363);
                let _e369 = (_e330 + 1i);
                let _e370 = (_e339 + 1i);
                if (_e369 > 0i) {
                    phi_1398_ = _e369;
                } else {
                    phi_1398_ = 0i;
                }
                let _e373 = phi_1398_;
                if (_e370 > 0i) {
                    phi_1403_ = _e370;
                } else {
                    phi_1403_ = 0i;
                }
                let _e376 = phi_1403_;
                if (_e373 < _e354) {
                    phi_1408_ = _e373;
                } else {
                    phi_1408_ = _e354;
                }
                let _e379 = phi_1408_;
                if (_e376 < _e354) {
                    phi_1413_ = _e376;
                } else {
                    phi_1413_ = _e354;
                }
                let _e382 = phi_1413_;
                let _e383 = bitcast<u32>(_e379);
                let _e385 = (bitcast<u32>(_e366) * _e352);
                let _e386 = (bitcast<u32>(_e382) * _e352);
                let _e387 = (_e385 + _e367);
                let _e388 = (_e385 + _e383);
                let _e389 = (_e386 + _e367);
                let _e390 = (_e386 + _e383);
                if (_e387 < _e43) {
                } else {
                    return;
                }
                let _e394 = map.member[(0u + _e387)];
                if (_e388 < _e43) {
                } else {
                    return;
                }
                let _e406 = map.member[(0u + _e388)];
                if (_e389 < _e43) {
                } else {
                    return;
                }
                let _e422 = map.member[(0u + _e389)];
                if (_e390 < _e43) {
                } else {
                    return;
                }
                let _e438 = map.member[(0u + _e390)];
                let _e452 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_1), vec4<f32>(((((_e394.x * _e342) + (_e406.x * _e344)) + (_e422.x * _e346)) + (_e438.x * _e347)), ((((_e394.y * _e342) + (_e406.y * _e344)) + (_e422.y * _e346)) + (_e438.y * _e347)), ((((_e394.z * _e342) + (_e406.z * _e344)) + (_e422.z * _e346)) + (_e438.z * _e347)), ((((_e394.w * _e342) + (_e406.w * _e344)) + (_e422.w * _e346)) + (_e438.w * _e347))), _e233);
                phi_1498_ = evaluate_Verdict(_e452, false);
                phi_1499_ = evaluate_Verdict();
                phi_1500_ = false;
            } else {
                phi_1498_ = evaluate_Verdict();
                phi_1499_ = evaluate_Verdict(1f, false);
                phi_1500_ = true;
            }
            let _e456 = phi_1498_;
            let _e458 = phi_1499_;
            let _e460 = phi_1500_;
            phi_1501_ = _e458;
            phi_1502_ = _e456;
            phi_1503_ = _e460;
        }
        let _e462 = phi_1501_;
        let _e464 = phi_1502_;
        let _e466 = phi_1503_;
        if _e466 {
            phi_1507_ = _e462;
        } else {
            phi_1507_ = _e464;
        }
        let _e468 = phi_1507_;
        if (_e52.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e52.first_primitive)] = _e468.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_msm_hausdorff_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
