struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_9 {
    member: array<abi_Sample>,
}

struct type_13 {
    member: array<f32>,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
}

struct evaluate_Verdict {
    visibility: f32,
    is_doubted: bool,
}

struct u0028_evaluate_Verdict_u0020_bool_u0029_ {
    unnamed: evaluate_Verdict,
    unnamed_1: bool,
}

struct type_29 {
    member: array<vec4<f32>>,
}

struct lt_math_LightProjection {
    row_x: vec4<f32>,
    row_y: vec4<f32>,
    row_z: vec4<f32>,
    row_w: vec4<f32>,
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

struct type_33 {
    member: abi_ShadowParams,
}

struct hankel_HankelFactors {
    moments: vec4<f32>,
    d22_: f32,
    l32_d22_: f32,
    d33_d22_: f32,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_33;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_13;
@group(0) @binding(2) 
var<storage> map: type_29;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_144_: lt_bvh_traverse_Tree;
    var phi_145_: bool;
    var phi_146_: lt_bvh_traverse_Tree;
    var phi_147_: bool;
    var phi_152_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_144_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_145_ = false;
        } else {
            phi_144_ = lt_bvh_traverse_Tree();
            phi_145_ = true;
        }
        let _e49 = phi_144_;
        let _e51 = phi_145_;
        phi_146_ = _e49;
        phi_147_ = _e51;
    } else {
        phi_146_ = lt_bvh_traverse_Tree();
        phi_147_ = true;
    }
    let _e53 = phi_146_;
    let _e55 = phi_147_;
    if _e55 {
        phi_152_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_152_ = _e53;
    }
    let _e60 = phi_152_;
    return lt_bvh_traverse_Tree(_e60.root, _e60.first_primitive);
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn lt_math_hausdorff_cubic_mass(param_4: vec4<f32>, param_5: f32, param_6: f32, param_7: f32, param_8: f32) -> f32 {
    return ((((param_4.z - (((param_6 + param_7) + param_8) * param_4.y)) + ((((param_6 * param_7) + (param_6 * param_8)) + (param_7 * param_8)) * param_4.x)) - ((param_6 * param_7) * param_8)) / (((param_5 - param_6) * (param_5 - param_7)) * (param_5 - param_8)));
}

fn lt_math_hausdorff_endpoint_upper_bound(param_9: ptr<function, hankel_HankelFactors>, param_10: f32) -> f32 {
    var phi_922_: f32;
    var phi_923_: f32;
    var phi_924_: f32;
    var phi_951_: f32;
    var phi_952_: f32;
    var phi_953_: f32;
    var phi_954_: f32;
    var phi_955_: bool;
    var phi_956_: f32;
    var phi_957_: bool;
    var phi_985_: f32;
    var phi_986_: f32;
    var phi_987_: f32;
    var phi_988_: f32;
    var phi_989_: bool;
    var phi_990_: f32;
    var phi_991_: bool;
    var phi_998_: f32;
    var phi_999_: f32;
    var phi_1000_: f32;
    var phi_1001_: f32;

    let _e39 = (*param_9).moments;
    if (param_10 < 0.0001f) {
        phi_1001_ = 1f;
    } else {
        let _e48 = ((_e39.z - ((1f + param_10) * _e39.y)) + (param_10 * _e39.x));
        let _e57 = (((_e39.w - ((1f + param_10) * _e39.z)) + (param_10 * _e39.y)) / _e48);
        if (abs(_e48) <= 0.00000047683716f) {
            let _e71 = (1f - (((_e39.y - (_e39.x * (param_10 + 1f))) + (param_10 * 1f)) / ((0f - param_10) * (0f - 1f))));
            if ((bitcast<u32>(_e71) & 2147483647u) > 2139095040u) {
                phi_924_ = _e71;
            } else {
                if (_e71 < 0f) {
                    phi_923_ = 0f;
                } else {
                    if (_e71 > 1f) {
                        phi_922_ = 1f;
                    } else {
                        phi_922_ = _e71;
                    }
                    let _e78 = phi_922_;
                    phi_923_ = _e78;
                }
                let _e80 = phi_923_;
                phi_924_ = _e80;
            }
            let _e82 = phi_924_;
            phi_1000_ = _e82;
        } else {
            if (_e57 > 0f) {
                if (_e57 < param_10) {
                    let _e85 = lt_math_hausdorff_cubic_mass(_e39, 0f, _e57, param_10, 1f);
                    let _e87 = lt_math_hausdorff_cubic_mass(_e39, _e57, 0f, param_10, 1f);
                    let _e88 = ((1f - _e85) - _e87);
                    if ((bitcast<u32>(_e88) & 2147483647u) > 2139095040u) {
                        phi_953_ = _e88;
                    } else {
                        if (_e88 < 0f) {
                            phi_952_ = 0f;
                        } else {
                            if (_e88 > 1f) {
                                phi_951_ = 1f;
                            } else {
                                phi_951_ = _e88;
                            }
                            let _e95 = phi_951_;
                            phi_952_ = _e95;
                        }
                        let _e97 = phi_952_;
                        phi_953_ = _e97;
                    }
                    let _e99 = phi_953_;
                    phi_954_ = _e99;
                    phi_955_ = false;
                } else {
                    phi_954_ = f32();
                    phi_955_ = true;
                }
                let _e101 = phi_954_;
                let _e103 = phi_955_;
                phi_956_ = _e101;
                phi_957_ = _e103;
            } else {
                phi_956_ = f32();
                phi_957_ = true;
            }
            let _e105 = phi_956_;
            let _e107 = phi_957_;
            if _e107 {
                if (_e57 > param_10) {
                    if (_e57 < 1f) {
                        let _e110 = lt_math_hausdorff_cubic_mass(_e39, 0f, _e57, param_10, 1f);
                        let _e111 = (1f - _e110);
                        if ((bitcast<u32>(_e111) & 2147483647u) > 2139095040u) {
                            phi_987_ = _e111;
                        } else {
                            if (_e111 < 0f) {
                                phi_986_ = 0f;
                            } else {
                                if (_e111 > 1f) {
                                    phi_985_ = 1f;
                                } else {
                                    phi_985_ = _e111;
                                }
                                let _e118 = phi_985_;
                                phi_986_ = _e118;
                            }
                            let _e120 = phi_986_;
                            phi_987_ = _e120;
                        }
                        let _e122 = phi_987_;
                        phi_988_ = _e122;
                        phi_989_ = false;
                    } else {
                        phi_988_ = f32();
                        phi_989_ = true;
                    }
                    let _e124 = phi_988_;
                    let _e126 = phi_989_;
                    phi_990_ = _e124;
                    phi_991_ = _e126;
                } else {
                    phi_990_ = f32();
                    phi_991_ = true;
                }
                let _e128 = phi_990_;
                let _e130 = phi_991_;
                if _e130 {
                    phi_998_ = bitcast<f32>((bitcast<u32>(_e57) | 2143289344u));
                } else {
                    phi_998_ = _e128;
                }
                let _e135 = phi_998_;
                phi_999_ = _e135;
            } else {
                phi_999_ = _e105;
            }
            let _e137 = phi_999_;
            phi_1000_ = _e137;
        }
        let _e139 = phi_1000_;
        phi_1001_ = _e139;
    }
    let _e141 = phi_1001_;
    return _e141;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_11: ptr<function, f32>, param_12: vec4<f32>, param_13: f32) -> f32 {
    var local: hankel_HankelFactors;
    var phi_209_: f32;
    var phi_210_: f32;
    var phi_211_: f32;
    var phi_223_: bool;
    var phi_238_: bool;
    var phi_263_: f32;
    var phi_264_: f32;
    var phi_265_: f32;
    var phi_266_: f32;
    var phi_267_: bool;
    var phi_268_: f32;
    var phi_269_: bool;
    var phi_325_: vec2<f32>;
    var phi_363_: f32;
    var phi_364_: f32;
    var phi_365_: f32;
    var phi_398_: f32;
    var phi_399_: f32;
    var phi_400_: f32;
    var phi_404_: f32;
    var phi_405_: f32;
    var phi_406_: f32;
    var phi_407_: f32;
    var phi_460_: vec2<f32>;
    var phi_482_: bool;
    var phi_507_: f32;
    var phi_508_: f32;
    var phi_509_: f32;
    var phi_510_: f32;
    var phi_511_: bool;
    var phi_512_: f32;
    var phi_513_: bool;
    var phi_569_: vec2<f32>;
    var phi_607_: f32;
    var phi_608_: f32;
    var phi_609_: f32;
    var phi_642_: f32;
    var phi_643_: f32;
    var phi_644_: f32;
    var phi_648_: f32;
    var phi_649_: f32;
    var phi_650_: f32;
    var phi_651_: f32;
    var phi_652_: f32;
    var phi_653_: bool;
    var phi_654_: f32;
    var phi_655_: bool;
    var phi_677_: bool;
    var phi_702_: f32;
    var phi_703_: f32;
    var phi_704_: f32;
    var phi_705_: f32;
    var phi_706_: bool;
    var phi_707_: f32;
    var phi_708_: bool;
    var phi_764_: vec2<f32>;
    var phi_802_: f32;
    var phi_803_: f32;
    var phi_804_: f32;
    var phi_837_: f32;
    var phi_838_: f32;
    var phi_839_: f32;
    var phi_843_: f32;
    var phi_844_: f32;
    var phi_845_: f32;
    var phi_846_: f32;
    var phi_857_: bool;
    var phi_861_: f32;
    var phi_862_: f32;
    var phi_863_: f32;
    var phi_864_: f32;

    let _e40 = (*param_11);
    let _e41 = (1f - _e40);
    let _e50 = (0.5f * _e40);
    let _e51 = ((param_12.x * _e41) + _e50);
    let _e52 = ((param_12.y * _e41) + _e50);
    let _e53 = ((param_12.z * _e41) + _e50);
    let _e54 = ((param_12.w * _e41) + _e50);
    let _e57 = (_e52 - (_e51 * _e51));
    let _e59 = (_e53 - (_e51 * _e52));
    let _e65 = hankel_HankelFactors(vec4<f32>(_e51, _e52, _e53, _e54), _e57, _e59, (((_e54 - (_e52 * _e52)) * _e57) - (_e59 * _e59)));
    local = hankel_HankelFactors(_e65.moments, _e65.d22_, _e65.l32_d22_, _e65.d33_d22_);
    if ((bitcast<u32>(param_13) & 2147483647u) > 2139095040u) {
        phi_211_ = param_13;
    } else {
        if (param_13 < 0f) {
            phi_210_ = 0f;
        } else {
            if (param_13 > 1f) {
                phi_209_ = 1f;
            } else {
                phi_209_ = param_13;
            }
            let _e77 = phi_209_;
            phi_210_ = _e77;
        }
        let _e79 = phi_210_;
        phi_211_ = _e79;
    }
    let _e81 = phi_211_;
    let _e84 = local.moments[0u];
    let _e87 = local.moments[3u];
    if (_e84 == _e87) {
        let _e91 = local.moments[0u];
        phi_223_ = (_e91 > 0.5f);
    } else {
        phi_223_ = false;
    }
    let _e94 = phi_223_;
    if _e94 {
        let _e97 = local.moments[0u];
        let _e100 = local.moments[3u];
        if (_e97 == _e100) {
            let _e104 = local.moments[0u];
            phi_238_ = (_e104 > 0.5f);
        } else {
            phi_238_ = false;
        }
        let _e107 = phi_238_;
        if _e107 {
            if (_e81 > 0f) {
                let _e110 = local.moments;
                if ((bitcast<u32>(_e110.x) & 2147483647u) > 2139095040u) {
                    phi_265_ = _e110.x;
                } else {
                    if (_e110.x < 0f) {
                        phi_264_ = 0f;
                    } else {
                        if (_e110.x > 1f) {
                            phi_263_ = 1f;
                        } else {
                            phi_263_ = _e110.x;
                        }
                        let _e118 = phi_263_;
                        phi_264_ = _e118;
                    }
                    let _e120 = phi_264_;
                    phi_265_ = _e120;
                }
                let _e122 = phi_265_;
                phi_266_ = _e122;
                phi_267_ = false;
            } else {
                phi_266_ = f32();
                phi_267_ = true;
            }
            let _e124 = phi_266_;
            let _e126 = phi_267_;
            phi_268_ = _e124;
            phi_269_ = _e126;
        } else {
            phi_268_ = f32();
            phi_269_ = true;
        }
        let _e128 = phi_268_;
        let _e130 = phi_269_;
        if _e130 {
            let _e133 = local.moments[0u];
            let _e136 = local.moments[1u];
            let _e144 = local.l32_d22_;
            let _e146 = local.d22_;
            let _e147 = (_e144 / _e146);
            let _e148 = (_e81 - _e133);
            let _e154 = local.d22_;
            let _e157 = local.d33_d22_;
            let _e158 = (((((_e81 * _e81) - _e136) - (_e147 * _e148)) * _e154) / _e157);
            let _e160 = local.d22_;
            let _e163 = ((_e148 / _e160) - (_e147 * _e158));
            let _e169 = ((0.5f * _e163) / _e158);
            let _e172 = ((_e169 * _e169) - (((1f - (_e163 * _e133)) - (_e158 * _e136)) / _e158));
            if (_e172 >= 0f) {
                let _e174 = sqrt(_e172);
                phi_325_ = vec2<f32>((-(_e169) - _e174), (-(_e169) + _e174));
            } else {
                phi_325_ = vec2(bitcast<f32>((bitcast<u32>(_e172) | 2143289344u)));
            }
            let _e185 = phi_325_;
            if (_e81 <= _e185.x) {
                phi_406_ = 1f;
            } else {
                if (_e81 > _e185.y) {
                    let _e191 = local.moments;
                    let _e202 = (((_e191.y - (_e191.x * (_e185.x + _e185.y))) + (_e185.x * _e185.y)) / ((_e81 - _e185.x) * (_e81 - _e185.y)));
                    if ((bitcast<u32>(_e202) & 2147483647u) > 2139095040u) {
                        phi_365_ = _e202;
                    } else {
                        if (_e202 < 0f) {
                            phi_364_ = 0f;
                        } else {
                            if (_e202 > 1f) {
                                phi_363_ = 1f;
                            } else {
                                phi_363_ = _e202;
                            }
                            let _e209 = phi_363_;
                            phi_364_ = _e209;
                        }
                        let _e211 = phi_364_;
                        phi_365_ = _e211;
                    }
                    let _e213 = phi_365_;
                    phi_405_ = _e213;
                } else {
                    if (_e81 > _e185.x) {
                        let _e216 = local.moments;
                        let _e228 = (1f - (((_e216.y - (_e216.x * (_e81 + _e185.y))) + (_e81 * _e185.y)) / ((_e185.x - _e81) * (_e185.x - _e185.y))));
                        if ((bitcast<u32>(_e228) & 2147483647u) > 2139095040u) {
                            phi_400_ = _e228;
                        } else {
                            if (_e228 < 0f) {
                                phi_399_ = 0f;
                            } else {
                                if (_e228 > 1f) {
                                    phi_398_ = 1f;
                                } else {
                                    phi_398_ = _e228;
                                }
                                let _e235 = phi_398_;
                                phi_399_ = _e235;
                            }
                            let _e237 = phi_399_;
                            phi_400_ = _e237;
                        }
                        let _e239 = phi_400_;
                        phi_404_ = _e239;
                    } else {
                        phi_404_ = bitcast<f32>((bitcast<u32>(_e185.x) | 2143289344u));
                    }
                    let _e244 = phi_404_;
                    phi_405_ = _e244;
                }
                let _e246 = phi_405_;
                phi_406_ = _e246;
            }
            let _e248 = phi_406_;
            phi_407_ = _e248;
        } else {
            phi_407_ = _e128;
        }
        let _e250 = phi_407_;
        phi_864_ = _e250;
    } else {
        let _e253 = local.moments[0u];
        let _e256 = local.moments[1u];
        let _e264 = local.l32_d22_;
        let _e266 = local.d22_;
        let _e267 = (_e264 / _e266);
        let _e268 = (_e81 - _e253);
        let _e274 = local.d22_;
        let _e277 = local.d33_d22_;
        let _e278 = (((((_e81 * _e81) - _e256) - (_e267 * _e268)) * _e274) / _e277);
        let _e280 = local.d22_;
        let _e283 = ((_e268 / _e280) - (_e267 * _e278));
        let _e289 = ((0.5f * _e283) / _e278);
        let _e292 = ((_e289 * _e289) - (((1f - (_e283 * _e253)) - (_e278 * _e256)) / _e278));
        if (_e292 >= 0f) {
            let _e294 = sqrt(_e292);
            phi_460_ = vec2<f32>((-(_e289) - _e294), (-(_e289) + _e294));
        } else {
            phi_460_ = vec2(bitcast<f32>((bitcast<u32>(_e292) | 2143289344u)));
        }
        let _e305 = phi_460_;
        if (_e305.x >= 0f) {
            if (_e305.y <= 1f) {
                let _e312 = local.moments[0u];
                let _e315 = local.moments[3u];
                if (_e312 == _e315) {
                    let _e319 = local.moments[0u];
                    phi_482_ = (_e319 > 0.5f);
                } else {
                    phi_482_ = false;
                }
                let _e322 = phi_482_;
                if _e322 {
                    if (_e81 > 0f) {
                        let _e325 = local.moments;
                        if ((bitcast<u32>(_e325.x) & 2147483647u) > 2139095040u) {
                            phi_509_ = _e325.x;
                        } else {
                            if (_e325.x < 0f) {
                                phi_508_ = 0f;
                            } else {
                                if (_e325.x > 1f) {
                                    phi_507_ = 1f;
                                } else {
                                    phi_507_ = _e325.x;
                                }
                                let _e333 = phi_507_;
                                phi_508_ = _e333;
                            }
                            let _e335 = phi_508_;
                            phi_509_ = _e335;
                        }
                        let _e337 = phi_509_;
                        phi_510_ = _e337;
                        phi_511_ = false;
                    } else {
                        phi_510_ = f32();
                        phi_511_ = true;
                    }
                    let _e339 = phi_510_;
                    let _e341 = phi_511_;
                    phi_512_ = _e339;
                    phi_513_ = _e341;
                } else {
                    phi_512_ = f32();
                    phi_513_ = true;
                }
                let _e343 = phi_512_;
                let _e345 = phi_513_;
                if _e345 {
                    let _e348 = local.moments[0u];
                    let _e351 = local.moments[1u];
                    let _e359 = local.l32_d22_;
                    let _e361 = local.d22_;
                    let _e362 = (_e359 / _e361);
                    let _e363 = (_e81 - _e348);
                    let _e369 = local.d22_;
                    let _e372 = local.d33_d22_;
                    let _e373 = (((((_e81 * _e81) - _e351) - (_e362 * _e363)) * _e369) / _e372);
                    let _e375 = local.d22_;
                    let _e378 = ((_e363 / _e375) - (_e362 * _e373));
                    let _e384 = ((0.5f * _e378) / _e373);
                    let _e387 = ((_e384 * _e384) - (((1f - (_e378 * _e348)) - (_e373 * _e351)) / _e373));
                    if (_e387 >= 0f) {
                        let _e389 = sqrt(_e387);
                        phi_569_ = vec2<f32>((-(_e384) - _e389), (-(_e384) + _e389));
                    } else {
                        phi_569_ = vec2(bitcast<f32>((bitcast<u32>(_e387) | 2143289344u)));
                    }
                    let _e400 = phi_569_;
                    if (_e81 <= _e400.x) {
                        phi_650_ = 1f;
                    } else {
                        if (_e81 > _e400.y) {
                            let _e406 = local.moments;
                            let _e417 = (((_e406.y - (_e406.x * (_e400.x + _e400.y))) + (_e400.x * _e400.y)) / ((_e81 - _e400.x) * (_e81 - _e400.y)));
                            if ((bitcast<u32>(_e417) & 2147483647u) > 2139095040u) {
                                phi_609_ = _e417;
                            } else {
                                if (_e417 < 0f) {
                                    phi_608_ = 0f;
                                } else {
                                    if (_e417 > 1f) {
                                        phi_607_ = 1f;
                                    } else {
                                        phi_607_ = _e417;
                                    }
                                    let _e424 = phi_607_;
                                    phi_608_ = _e424;
                                }
                                let _e426 = phi_608_;
                                phi_609_ = _e426;
                            }
                            let _e428 = phi_609_;
                            phi_649_ = _e428;
                        } else {
                            if (_e81 > _e400.x) {
                                let _e431 = local.moments;
                                let _e443 = (1f - (((_e431.y - (_e431.x * (_e81 + _e400.y))) + (_e81 * _e400.y)) / ((_e400.x - _e81) * (_e400.x - _e400.y))));
                                if ((bitcast<u32>(_e443) & 2147483647u) > 2139095040u) {
                                    phi_644_ = _e443;
                                } else {
                                    if (_e443 < 0f) {
                                        phi_643_ = 0f;
                                    } else {
                                        if (_e443 > 1f) {
                                            phi_642_ = 1f;
                                        } else {
                                            phi_642_ = _e443;
                                        }
                                        let _e450 = phi_642_;
                                        phi_643_ = _e450;
                                    }
                                    let _e452 = phi_643_;
                                    phi_644_ = _e452;
                                }
                                let _e454 = phi_644_;
                                phi_648_ = _e454;
                            } else {
                                phi_648_ = bitcast<f32>((bitcast<u32>(_e400.x) | 2143289344u));
                            }
                            let _e459 = phi_648_;
                            phi_649_ = _e459;
                        }
                        let _e461 = phi_649_;
                        phi_650_ = _e461;
                    }
                    let _e463 = phi_650_;
                    phi_651_ = _e463;
                } else {
                    phi_651_ = _e343;
                }
                let _e465 = phi_651_;
                phi_652_ = _e465;
                phi_653_ = false;
            } else {
                phi_652_ = f32();
                phi_653_ = true;
            }
            let _e467 = phi_652_;
            let _e469 = phi_653_;
            phi_654_ = _e467;
            phi_655_ = _e469;
        } else {
            phi_654_ = f32();
            phi_655_ = true;
        }
        let _e471 = phi_654_;
        let _e473 = phi_655_;
        if _e473 {
            if ((bitcast<u32>(_e305.x) & 2147483647u) > 2139095040u) {
                phi_862_ = _e305.x;
            } else {
                let _e477 = lt_math_hausdorff_endpoint_upper_bound((&local), _e81);
                let _e480 = local.moments[0u];
                let _e483 = local.moments[3u];
                if (_e480 == _e483) {
                    let _e487 = local.moments[0u];
                    phi_677_ = (_e487 > 0.5f);
                } else {
                    phi_677_ = false;
                }
                let _e490 = phi_677_;
                if _e490 {
                    if (_e81 > 0f) {
                        let _e493 = local.moments;
                        if ((bitcast<u32>(_e493.x) & 2147483647u) > 2139095040u) {
                            phi_704_ = _e493.x;
                        } else {
                            if (_e493.x < 0f) {
                                phi_703_ = 0f;
                            } else {
                                if (_e493.x > 1f) {
                                    phi_702_ = 1f;
                                } else {
                                    phi_702_ = _e493.x;
                                }
                                let _e501 = phi_702_;
                                phi_703_ = _e501;
                            }
                            let _e503 = phi_703_;
                            phi_704_ = _e503;
                        }
                        let _e505 = phi_704_;
                        phi_705_ = _e505;
                        phi_706_ = false;
                    } else {
                        phi_705_ = f32();
                        phi_706_ = true;
                    }
                    let _e507 = phi_705_;
                    let _e509 = phi_706_;
                    phi_707_ = _e507;
                    phi_708_ = _e509;
                } else {
                    phi_707_ = f32();
                    phi_708_ = true;
                }
                let _e511 = phi_707_;
                let _e513 = phi_708_;
                if _e513 {
                    let _e516 = local.moments[0u];
                    let _e519 = local.moments[1u];
                    let _e527 = local.l32_d22_;
                    let _e529 = local.d22_;
                    let _e530 = (_e527 / _e529);
                    let _e531 = (_e81 - _e516);
                    let _e537 = local.d22_;
                    let _e540 = local.d33_d22_;
                    let _e541 = (((((_e81 * _e81) - _e519) - (_e530 * _e531)) * _e537) / _e540);
                    let _e543 = local.d22_;
                    let _e546 = ((_e531 / _e543) - (_e530 * _e541));
                    let _e552 = ((0.5f * _e546) / _e541);
                    let _e555 = ((_e552 * _e552) - (((1f - (_e546 * _e516)) - (_e541 * _e519)) / _e541));
                    if (_e555 >= 0f) {
                        let _e557 = sqrt(_e555);
                        phi_764_ = vec2<f32>((-(_e552) - _e557), (-(_e552) + _e557));
                    } else {
                        phi_764_ = vec2(bitcast<f32>((bitcast<u32>(_e555) | 2143289344u)));
                    }
                    let _e568 = phi_764_;
                    if (_e81 <= _e568.x) {
                        phi_845_ = 1f;
                    } else {
                        if (_e81 > _e568.y) {
                            let _e574 = local.moments;
                            let _e585 = (((_e574.y - (_e574.x * (_e568.x + _e568.y))) + (_e568.x * _e568.y)) / ((_e81 - _e568.x) * (_e81 - _e568.y)));
                            if ((bitcast<u32>(_e585) & 2147483647u) > 2139095040u) {
                                phi_804_ = _e585;
                            } else {
                                if (_e585 < 0f) {
                                    phi_803_ = 0f;
                                } else {
                                    if (_e585 > 1f) {
                                        phi_802_ = 1f;
                                    } else {
                                        phi_802_ = _e585;
                                    }
                                    let _e592 = phi_802_;
                                    phi_803_ = _e592;
                                }
                                let _e594 = phi_803_;
                                phi_804_ = _e594;
                            }
                            let _e596 = phi_804_;
                            phi_844_ = _e596;
                        } else {
                            if (_e81 > _e568.x) {
                                let _e599 = local.moments;
                                let _e611 = (1f - (((_e599.y - (_e599.x * (_e81 + _e568.y))) + (_e81 * _e568.y)) / ((_e568.x - _e81) * (_e568.x - _e568.y))));
                                if ((bitcast<u32>(_e611) & 2147483647u) > 2139095040u) {
                                    phi_839_ = _e611;
                                } else {
                                    if (_e611 < 0f) {
                                        phi_838_ = 0f;
                                    } else {
                                        if (_e611 > 1f) {
                                            phi_837_ = 1f;
                                        } else {
                                            phi_837_ = _e611;
                                        }
                                        let _e618 = phi_837_;
                                        phi_838_ = _e618;
                                    }
                                    let _e620 = phi_838_;
                                    phi_839_ = _e620;
                                }
                                let _e622 = phi_839_;
                                phi_843_ = _e622;
                            } else {
                                phi_843_ = bitcast<f32>((bitcast<u32>(_e568.x) | 2143289344u));
                            }
                            let _e627 = phi_843_;
                            phi_844_ = _e627;
                        }
                        let _e629 = phi_844_;
                        phi_845_ = _e629;
                    }
                    let _e631 = phi_845_;
                    phi_846_ = _e631;
                } else {
                    phi_846_ = _e511;
                }
                let _e633 = phi_846_;
                if ((bitcast<u32>(_e633) & 2147483647u) > 2139095040u) {
                    phi_857_ = true;
                } else {
                    let _e637 = (_e633 < _e477);
                    if _e637 {
                    }
                    phi_857_ = _e637;
                }
                let _e639 = phi_857_;
                if _e639 {
                    phi_861_ = _e633;
                } else {
                    phi_861_ = _e477;
                }
                let _e641 = phi_861_;
                phi_862_ = _e641;
            }
            let _e643 = phi_862_;
            phi_863_ = _e643;
        } else {
            phi_863_ = _e471;
        }
        let _e645 = phi_863_;
        phi_864_ = _e645;
    }
    let _e647 = phi_864_;
    return _e647;
}

fn function_() {
    var local_1: f32;
    var phi_1084_: bool;
    var phi_1085_: bool;
    var phi_1086_: bool;
    var phi_1087_: bool;
    var phi_1091_: bool;
    var phi_1135_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1139_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1216_: bool;
    var phi_1225_: bool;
    var phi_1234_: bool;
    var phi_1235_: bool;
    var phi_1236_: bool;
    var phi_1237_: bool;
    var phi_1238_: bool;
    var phi_1239_: bool;
    var phi_1240_: bool;
    var phi_1244_: bool;
    var phi_1338_: f32;
    var phi_1341_: f32;
    var phi_1370_: f32;
    var phi_1375_: f32;
    var phi_1376_: bool;
    var phi_1377_: f32;
    var phi_1378_: bool;
    var phi_1382_: f32;
    var phi_1402_: f32;
    var phi_1407_: f32;
    var phi_1408_: bool;
    var phi_1409_: f32;
    var phi_1410_: bool;
    var phi_1414_: f32;
    var phi_1460_: i32;
    var phi_1465_: i32;
    var phi_1470_: i32;
    var phi_1475_: i32;
    var phi_1484_: i32;
    var phi_1489_: i32;
    var phi_1494_: i32;
    var phi_1499_: i32;
    var phi_1590_: bool;
    var phi_1598_: bool;
    var phi_1610_: bool;
    var phi_1611_: bool;
    var phi_1615_: f32;
    var phi_1621_: f32;
    var phi_1623_: evaluate_Verdict;
    var phi_1628_: evaluate_Verdict;
    var phi_1629_: evaluate_Verdict;

    let _e37 = id_1;
    let _e44 = arrayLength((&map.member));
    let _e50 = p.member.size[0u];
    let _e52 = p.member.size[1u];
    let _e53 = lt_shaders_entry_pixel_index(_e37, _e50, _e52);
    if (bitcast<i32>(_e53.root) != 0i) {
        if (_e53.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e62 = p.member.light;
        let _e65 = samples.member[(0u + _e53.first_primitive)].normal[0u];
        let _e67 = global[0u];
        if (_e65 == _e67) {
            let _e70 = samples.member[(0u + _e53.first_primitive)].normal[1u];
            let _e72 = global[1u];
            if (_e70 == _e72) {
                let _e75 = samples.member[(0u + _e53.first_primitive)].normal[2u];
                let _e77 = global[2u];
                phi_1084_ = (_e75 == _e77);
                phi_1085_ = false;
            } else {
                phi_1084_ = bool();
                phi_1085_ = true;
            }
            let _e80 = phi_1084_;
            let _e82 = phi_1085_;
            phi_1086_ = _e80;
            phi_1087_ = _e82;
        } else {
            phi_1086_ = bool();
            phi_1087_ = true;
        }
        let _e84 = phi_1086_;
        let _e86 = phi_1087_;
        if _e86 {
            phi_1091_ = false;
        } else {
            phi_1091_ = _e84;
        }
        let _e88 = phi_1091_;
        if !(_e88) {
            let _e91 = samples.member[(0u + _e53.first_primitive)].normal;
            let _e93 = samples.member[(0u + _e53.first_primitive)].position;
            if ((((_e91.x * (_e62.x - (_e93.x * _e62.w))) + (_e91.y * (_e62.y - (_e93.y * _e62.w)))) + (_e91.z * (_e62.z - (_e93.z * _e62.w)))) > 0f) {
                let _e117 = samples.member[(0u + _e53.first_primitive)].flags;
                let _e125 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e131 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e125.unnamed.visibility, false), _e125.unnamed_1);
                phi_1135_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e131.unnamed, ((_e117 & 1u) == 0u));
            } else {
                let _e140 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e146 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e140.unnamed.visibility, false), _e140.unnamed_1);
                phi_1135_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e146.unnamed, true);
            }
            let _e151 = phi_1135_;
            phi_1139_ = _e151;
        } else {
            let _e157 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e163 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e157.unnamed.visibility, false), _e157.unnamed_1);
            phi_1139_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e163.unnamed, true);
        }
        let _e168 = phi_1139_;
        if _e168.unnamed_1 {
            phi_1629_ = evaluate_Verdict(_e168.unnamed.visibility, _e168.unnamed.is_doubted);
        } else {
            let _e176 = samples.member[(0u + _e53.first_primitive)].position;
            let _e182 = p.member.projection.row_w;
            let _e193 = ((((_e182.x * _e176.x) + (_e182.y * _e176.y)) + (_e182.z * _e176.z)) + (_e182.w * 1f));
            let _e195 = p.member.projection.row_x;
            let _e207 = (((((_e195.x * _e176.x) + (_e195.y * _e176.y)) + (_e195.z * _e176.z)) + (_e195.w * 1f)) / _e193);
            let _e209 = p.member.projection.row_y;
            let _e221 = (((((_e209.x * _e176.x) + (_e209.y * _e176.y)) + (_e209.z * _e176.z)) + (_e209.w * 1f)) / _e193);
            let _e223 = p.member.projection.row_z;
            let _e234 = ((((_e223.x * _e176.x) + (_e223.y * _e176.y)) + (_e223.z * _e176.z)) + (_e223.w * 1f));
            if (_e193 > 0f) {
                if (_e207 >= 0f) {
                    phi_1216_ = (_e207 <= 1f);
                } else {
                    phi_1216_ = false;
                }
                let _e239 = phi_1216_;
                if _e239 {
                    if (_e221 >= 0f) {
                        phi_1225_ = (_e221 <= 1f);
                    } else {
                        phi_1225_ = false;
                    }
                    let _e243 = phi_1225_;
                    if _e243 {
                        if (_e234 >= 0f) {
                            phi_1234_ = (_e234 <= 1f);
                        } else {
                            phi_1234_ = false;
                        }
                        let _e247 = phi_1234_;
                        phi_1235_ = _e247;
                        phi_1236_ = false;
                    } else {
                        phi_1235_ = bool();
                        phi_1236_ = true;
                    }
                    let _e249 = phi_1235_;
                    let _e251 = phi_1236_;
                    phi_1237_ = _e249;
                    phi_1238_ = _e251;
                } else {
                    phi_1237_ = bool();
                    phi_1238_ = true;
                }
                let _e253 = phi_1237_;
                let _e255 = phi_1238_;
                phi_1239_ = _e253;
                phi_1240_ = _e255;
            } else {
                phi_1239_ = bool();
                phi_1240_ = true;
            }
            let _e257 = phi_1239_;
            let _e259 = phi_1240_;
            if _e259 {
                phi_1244_ = false;
            } else {
                phi_1244_ = _e257;
            }
            let _e261 = phi_1244_;
            if _e261 {
                if (0f > 0f) {
                    let _e264 = samples.member[(0u + _e53.first_primitive)].normal;
                    let _e266 = p.member.map_size;
                    let _e269 = p.member.projection.row_x;
                    let _e291 = p.member.projection.row_y;
                    let _e313 = p.member.projection.row_z;
                    let _e340 = ((abs(((((_e269.x * _e264.x) + (_e269.y * _e264.y)) + (_e269.z * _e264.z)) / (((_e269.x * _e269.x) + (_e269.y * _e269.y)) + (_e269.z * _e269.z)))) + abs(((((_e291.x * _e264.x) + (_e291.y * _e264.y)) + (_e291.z * _e264.z)) / (((_e291.x * _e291.x) + (_e291.y * _e291.y)) + (_e291.z * _e291.z))))) / (abs(((((_e313.x * _e264.x) + (_e313.y * _e264.y)) + (_e313.z * _e264.z)) / (((_e313.x * _e313.x) + (_e313.y * _e313.y)) + (_e313.z * _e313.z)))) * f32(_e266)));
                    if (_e340 < 0.002f) {
                        phi_1338_ = _e340;
                    } else {
                        phi_1338_ = 0.002f;
                    }
                    let _e343 = phi_1338_;
                    phi_1341_ = (_e234 - (0f * _e343));
                } else {
                    phi_1341_ = _e234;
                }
                let _e347 = phi_1341_;
                let _e349 = p.member.map_size;
                let _e350 = f32(_e349);
                let _e353 = ((_e207 * _e350) - 0.5f);
                let _e354 = ((_e221 * _e350) - 0.5f);
                if (_e353 > -8388608f) {
                    let _e366 = f32(select(0i, select(select(i32(_e353), i32(-2147483648), (_e353 < bitcast<f32>(3472883712u))), 2147483647i, (_e353 > bitcast<f32>(1325400063u))), (_e353 == _e353)));
                    if (_e366 > _e353) {
                        phi_1370_ = 1f;
                    } else {
                        phi_1370_ = 0f;
                    }
                    let _e369 = phi_1370_;
                    if (_e353 < 8388608f) {
                        phi_1375_ = (_e366 - _e369);
                        phi_1376_ = false;
                    } else {
                        phi_1375_ = f32();
                        phi_1376_ = true;
                    }
                    let _e372 = phi_1375_;
                    let _e374 = phi_1376_;
                    phi_1377_ = _e372;
                    phi_1378_ = _e374;
                } else {
                    phi_1377_ = f32();
                    phi_1378_ = true;
                }
                let _e376 = phi_1377_;
                let _e378 = phi_1378_;
                if _e378 {
                    phi_1382_ = _e353;
                } else {
                    phi_1382_ = _e376;
                }
                let _e380 = phi_1382_;
                if (_e354 > -8388608f) {
                    let _e392 = f32(select(0i, select(select(i32(_e354), i32(-2147483648), (_e354 < bitcast<f32>(3472883712u))), 2147483647i, (_e354 > bitcast<f32>(1325400063u))), (_e354 == _e354)));
                    if (_e392 > _e354) {
                        phi_1402_ = 1f;
                    } else {
                        phi_1402_ = 0f;
                    }
                    let _e395 = phi_1402_;
                    if (_e354 < 8388608f) {
                        phi_1407_ = (_e392 - _e395);
                        phi_1408_ = false;
                    } else {
                        phi_1407_ = f32();
                        phi_1408_ = true;
                    }
                    let _e398 = phi_1407_;
                    let _e400 = phi_1408_;
                    phi_1409_ = _e398;
                    phi_1410_ = _e400;
                } else {
                    phi_1409_ = f32();
                    phi_1410_ = true;
                }
                let _e402 = phi_1409_;
                let _e404 = phi_1410_;
                if _e404 {
                    phi_1414_ = _e354;
                } else {
                    phi_1414_ = _e402;
                }
                let _e406 = phi_1414_;
                let _e407 = (_e353 - _e380);
                let _e408 = (_e354 - _e406);
                let _e417 = select(0i, select(select(i32(_e380), i32(-2147483648), (_e380 < bitcast<f32>(3472883712u))), 2147483647i, (_e380 > bitcast<f32>(1325400063u))), (_e380 == _e380));
                let _e426 = select(0i, select(select(i32(_e406), i32(-2147483648), (_e406 < bitcast<f32>(3472883712u))), 2147483647i, (_e406 > bitcast<f32>(1325400063u))), (_e406 == _e406));
                let _e429 = ((1f - _e407) * (1f - _e408));
                let _e431 = (_e407 * (1f - _e408));
                let _e433 = ((1f - _e407) * _e408);
                let _e434 = (_e407 * _e408);
                let _e436 = p.member.test;
                let _e437 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e436);
                let _e439 = p.member.map_size;
                local_1 = _e437;
                let _e441 = (bitcast<i32>(_e439) - 1i);
                if (_e417 > 0i) {
                    phi_1460_ = _e417;
                } else {
                    phi_1460_ = 0i;
                }
                let _e444 = phi_1460_;
                if (_e426 > 0i) {
                    phi_1465_ = _e426;
                } else {
                    phi_1465_ = 0i;
                }
                let _e447 = phi_1465_;
                if (_e444 < _e441) {
                    phi_1470_ = _e444;
                } else {
                    phi_1470_ = _e441;
                }
                let _e450 = phi_1470_;
                if (_e447 < _e441) {
                    phi_1475_ = _e447;
                } else {
                    phi_1475_ = _e441;
                }
                let _e453 = phi_1475_;
                let _e454 = bitcast<u32>(_e450);
                let _e456 = (_e417 + 1i);
                let _e457 = (_e426 + 1i);
                if (_e456 > 0i) {
                    phi_1484_ = _e456;
                } else {
                    phi_1484_ = 0i;
                }
                let _e460 = phi_1484_;
                if (_e457 > 0i) {
                    phi_1489_ = _e457;
                } else {
                    phi_1489_ = 0i;
                }
                let _e463 = phi_1489_;
                if (_e460 < _e441) {
                    phi_1494_ = _e460;
                } else {
                    phi_1494_ = _e441;
                }
                let _e466 = phi_1494_;
                if (_e463 < _e441) {
                    phi_1499_ = _e463;
                } else {
                    phi_1499_ = _e441;
                }
                let _e469 = phi_1499_;
                let _e470 = bitcast<u32>(_e466);
                let _e472 = (bitcast<u32>(_e453) * _e439);
                let _e473 = (bitcast<u32>(_e469) * _e439);
                let _e474 = (_e472 + _e454);
                let _e475 = (_e472 + _e470);
                let _e476 = (_e473 + _e454);
                let _e477 = (_e473 + _e470);
                if (_e474 < _e44) {
                } else {
                    return;
                }
                let _e481 = map.member[(0u + _e474)];
                if (_e475 < _e44) {
                } else {
                    return;
                }
                let _e493 = map.member[(0u + _e475)];
                if (_e476 < _e44) {
                } else {
                    return;
                }
                let _e509 = map.member[(0u + _e476)];
                if (_e477 < _e44) {
                } else {
                    return;
                }
                let _e525 = map.member[(0u + _e477)];
                let _e539 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_1), vec4<f32>(((((_e481.x * _e429) + (_e493.x * _e431)) + (_e509.x * _e433)) + (_e525.x * _e434)), ((((_e481.y * _e429) + (_e493.y * _e431)) + (_e509.y * _e433)) + (_e525.y * _e434)), ((((_e481.z * _e429) + (_e493.z * _e431)) + (_e509.z * _e433)) + (_e525.z * _e434)), ((((_e481.w * _e429) + (_e493.w * _e431)) + (_e509.w * _e433)) + (_e525.w * _e434))), _e347);
                let _e541 = p.member.epsilon;
                if (_e539 <= _e541) {
                    phi_1590_ = true;
                } else {
                    phi_1590_ = (_e539 >= (1f - _e541));
                }
                let _e546 = phi_1590_;
                if ((bitcast<u32>(_e539) & 2147483647u) > 2139095040u) {
                    phi_1598_ = true;
                } else {
                    phi_1598_ = !(_e546);
                }
                let _e552 = phi_1598_;
                if _e552 {
                    if (_e539 > 0f) {
                        if (_e539 < 1f) {
                            phi_1610_ = false;
                        } else {
                            phi_1610_ = true;
                        }
                        let _e556 = phi_1610_;
                        phi_1611_ = _e556;
                    } else {
                        phi_1611_ = true;
                    }
                    let _e558 = phi_1611_;
                    if _e558 {
                        phi_1615_ = 0.5f;
                    } else {
                        phi_1615_ = _e539;
                    }
                    let _e560 = phi_1615_;
                    phi_1623_ = evaluate_Verdict(_e560, true);
                } else {
                    if (_e539 > 0.5f) {
                        phi_1621_ = 1f;
                    } else {
                        phi_1621_ = 0f;
                    }
                    let _e564 = phi_1621_;
                    phi_1623_ = evaluate_Verdict(_e564, false);
                }
                let _e567 = phi_1623_;
                phi_1628_ = evaluate_Verdict(_e567.visibility, _e567.is_doubted);
            } else {
                phi_1628_ = evaluate_Verdict(0.5f, true);
            }
            let _e573 = phi_1628_;
            phi_1629_ = _e573;
        }
        let _e575 = phi_1629_;
        if (_e53.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e53.first_primitive)] = _e575.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_msm_hausdorff_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
