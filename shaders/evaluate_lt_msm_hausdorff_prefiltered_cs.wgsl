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
    level_count: u32,
    fade_uv: f32,
    pad0_: u32,
}

struct type_33 {
    member: abi_ShadowParams,
}

struct lt_math_OneLevel {
    projection: lt_math_LightProjection,
}

struct lt_math_LightPoint {
    uv: vec2<f32>,
    depth: f32,
    is_inside: bool,
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
    var phi_145_: lt_bvh_traverse_Tree;
    var phi_146_: bool;
    var phi_147_: lt_bvh_traverse_Tree;
    var phi_148_: bool;
    var phi_153_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_145_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_146_ = false;
        } else {
            phi_145_ = lt_bvh_traverse_Tree();
            phi_146_ = true;
        }
        let _e50 = phi_145_;
        let _e52 = phi_146_;
        phi_147_ = _e50;
        phi_148_ = _e52;
    } else {
        phi_147_ = lt_bvh_traverse_Tree();
        phi_148_ = true;
    }
    let _e54 = phi_147_;
    let _e56 = phi_148_;
    if _e56 {
        phi_153_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_153_ = _e54;
    }
    let _e61 = phi_153_;
    return lt_bvh_traverse_Tree(_e61.root, _e61.first_primitive);
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn lt_math_hausdorff_cubic_mass(param_4: vec4<f32>, param_5: f32, param_6: f32, param_7: f32, param_8: f32) -> f32 {
    return ((((param_4.z - (((param_6 + param_7) + param_8) * param_4.y)) + ((((param_6 * param_7) + (param_6 * param_8)) + (param_7 * param_8)) * param_4.x)) - ((param_6 * param_7) * param_8)) / (((param_5 - param_6) * (param_5 - param_7)) * (param_5 - param_8)));
}

fn lt_math_hausdorff_endpoint_upper_bound(param_9: ptr<function, hankel_HankelFactors>, param_10: f32) -> f32 {
    var phi_923_: f32;
    var phi_924_: f32;
    var phi_925_: f32;
    var phi_952_: f32;
    var phi_953_: f32;
    var phi_954_: f32;
    var phi_955_: f32;
    var phi_956_: bool;
    var phi_957_: f32;
    var phi_958_: bool;
    var phi_986_: f32;
    var phi_987_: f32;
    var phi_988_: f32;
    var phi_989_: f32;
    var phi_990_: bool;
    var phi_991_: f32;
    var phi_992_: bool;
    var phi_999_: f32;
    var phi_1000_: f32;
    var phi_1001_: f32;
    var phi_1002_: f32;

    let _e40 = (*param_9).moments;
    if (param_10 < 0.0001f) {
        phi_1002_ = 1f;
    } else {
        let _e49 = ((_e40.z - ((1f + param_10) * _e40.y)) + (param_10 * _e40.x));
        let _e58 = (((_e40.w - ((1f + param_10) * _e40.z)) + (param_10 * _e40.y)) / _e49);
        if (abs(_e49) <= 0.00000047683716f) {
            let _e72 = (1f - (((_e40.y - (_e40.x * (param_10 + 1f))) + (param_10 * 1f)) / ((0f - param_10) * (0f - 1f))));
            if ((bitcast<u32>(_e72) & 2147483647u) > 2139095040u) {
                phi_925_ = _e72;
            } else {
                if (_e72 < 0f) {
                    phi_924_ = 0f;
                } else {
                    if (_e72 > 1f) {
                        phi_923_ = 1f;
                    } else {
                        phi_923_ = _e72;
                    }
                    let _e79 = phi_923_;
                    phi_924_ = _e79;
                }
                let _e81 = phi_924_;
                phi_925_ = _e81;
            }
            let _e83 = phi_925_;
            phi_1001_ = _e83;
        } else {
            if (_e58 > 0f) {
                if (_e58 < param_10) {
                    let _e86 = lt_math_hausdorff_cubic_mass(_e40, 0f, _e58, param_10, 1f);
                    let _e88 = lt_math_hausdorff_cubic_mass(_e40, _e58, 0f, param_10, 1f);
                    let _e89 = ((1f - _e86) - _e88);
                    if ((bitcast<u32>(_e89) & 2147483647u) > 2139095040u) {
                        phi_954_ = _e89;
                    } else {
                        if (_e89 < 0f) {
                            phi_953_ = 0f;
                        } else {
                            if (_e89 > 1f) {
                                phi_952_ = 1f;
                            } else {
                                phi_952_ = _e89;
                            }
                            let _e96 = phi_952_;
                            phi_953_ = _e96;
                        }
                        let _e98 = phi_953_;
                        phi_954_ = _e98;
                    }
                    let _e100 = phi_954_;
                    phi_955_ = _e100;
                    phi_956_ = false;
                } else {
                    phi_955_ = f32();
                    phi_956_ = true;
                }
                let _e102 = phi_955_;
                let _e104 = phi_956_;
                phi_957_ = _e102;
                phi_958_ = _e104;
            } else {
                phi_957_ = f32();
                phi_958_ = true;
            }
            let _e106 = phi_957_;
            let _e108 = phi_958_;
            if _e108 {
                if (_e58 > param_10) {
                    if (_e58 < 1f) {
                        let _e111 = lt_math_hausdorff_cubic_mass(_e40, 0f, _e58, param_10, 1f);
                        let _e112 = (1f - _e111);
                        if ((bitcast<u32>(_e112) & 2147483647u) > 2139095040u) {
                            phi_988_ = _e112;
                        } else {
                            if (_e112 < 0f) {
                                phi_987_ = 0f;
                            } else {
                                if (_e112 > 1f) {
                                    phi_986_ = 1f;
                                } else {
                                    phi_986_ = _e112;
                                }
                                let _e119 = phi_986_;
                                phi_987_ = _e119;
                            }
                            let _e121 = phi_987_;
                            phi_988_ = _e121;
                        }
                        let _e123 = phi_988_;
                        phi_989_ = _e123;
                        phi_990_ = false;
                    } else {
                        phi_989_ = f32();
                        phi_990_ = true;
                    }
                    let _e125 = phi_989_;
                    let _e127 = phi_990_;
                    phi_991_ = _e125;
                    phi_992_ = _e127;
                } else {
                    phi_991_ = f32();
                    phi_992_ = true;
                }
                let _e129 = phi_991_;
                let _e131 = phi_992_;
                if _e131 {
                    phi_999_ = bitcast<f32>((bitcast<u32>(_e58) | 2143289344u));
                } else {
                    phi_999_ = _e129;
                }
                let _e136 = phi_999_;
                phi_1000_ = _e136;
            } else {
                phi_1000_ = _e106;
            }
            let _e138 = phi_1000_;
            phi_1001_ = _e138;
        }
        let _e140 = phi_1001_;
        phi_1002_ = _e140;
    }
    let _e142 = phi_1002_;
    return _e142;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_11: ptr<function, f32>, param_12: vec4<f32>, param_13: f32) -> f32 {
    var local: hankel_HankelFactors;
    var phi_210_: f32;
    var phi_211_: f32;
    var phi_212_: f32;
    var phi_224_: bool;
    var phi_239_: bool;
    var phi_264_: f32;
    var phi_265_: f32;
    var phi_266_: f32;
    var phi_267_: f32;
    var phi_268_: bool;
    var phi_269_: f32;
    var phi_270_: bool;
    var phi_326_: vec2<f32>;
    var phi_364_: f32;
    var phi_365_: f32;
    var phi_366_: f32;
    var phi_399_: f32;
    var phi_400_: f32;
    var phi_401_: f32;
    var phi_405_: f32;
    var phi_406_: f32;
    var phi_407_: f32;
    var phi_408_: f32;
    var phi_461_: vec2<f32>;
    var phi_483_: bool;
    var phi_508_: f32;
    var phi_509_: f32;
    var phi_510_: f32;
    var phi_511_: f32;
    var phi_512_: bool;
    var phi_513_: f32;
    var phi_514_: bool;
    var phi_570_: vec2<f32>;
    var phi_608_: f32;
    var phi_609_: f32;
    var phi_610_: f32;
    var phi_643_: f32;
    var phi_644_: f32;
    var phi_645_: f32;
    var phi_649_: f32;
    var phi_650_: f32;
    var phi_651_: f32;
    var phi_652_: f32;
    var phi_653_: f32;
    var phi_654_: bool;
    var phi_655_: f32;
    var phi_656_: bool;
    var phi_678_: bool;
    var phi_703_: f32;
    var phi_704_: f32;
    var phi_705_: f32;
    var phi_706_: f32;
    var phi_707_: bool;
    var phi_708_: f32;
    var phi_709_: bool;
    var phi_765_: vec2<f32>;
    var phi_803_: f32;
    var phi_804_: f32;
    var phi_805_: f32;
    var phi_838_: f32;
    var phi_839_: f32;
    var phi_840_: f32;
    var phi_844_: f32;
    var phi_845_: f32;
    var phi_846_: f32;
    var phi_847_: f32;
    var phi_858_: bool;
    var phi_862_: f32;
    var phi_863_: f32;
    var phi_864_: f32;
    var phi_865_: f32;

    let _e41 = (*param_11);
    let _e42 = (1f - _e41);
    let _e51 = (0.5f * _e41);
    let _e52 = ((param_12.x * _e42) + _e51);
    let _e53 = ((param_12.y * _e42) + _e51);
    let _e54 = ((param_12.z * _e42) + _e51);
    let _e55 = ((param_12.w * _e42) + _e51);
    let _e58 = (_e53 - (_e52 * _e52));
    let _e60 = (_e54 - (_e52 * _e53));
    let _e66 = hankel_HankelFactors(vec4<f32>(_e52, _e53, _e54, _e55), _e58, _e60, (((_e55 - (_e53 * _e53)) * _e58) - (_e60 * _e60)));
    local = hankel_HankelFactors(_e66.moments, _e66.d22_, _e66.l32_d22_, _e66.d33_d22_);
    if ((bitcast<u32>(param_13) & 2147483647u) > 2139095040u) {
        phi_212_ = param_13;
    } else {
        if (param_13 < 0f) {
            phi_211_ = 0f;
        } else {
            if (param_13 > 1f) {
                phi_210_ = 1f;
            } else {
                phi_210_ = param_13;
            }
            let _e78 = phi_210_;
            phi_211_ = _e78;
        }
        let _e80 = phi_211_;
        phi_212_ = _e80;
    }
    let _e82 = phi_212_;
    let _e85 = local.moments[0u];
    let _e88 = local.moments[3u];
    if (_e85 == _e88) {
        let _e92 = local.moments[0u];
        phi_224_ = (_e92 > 0.5f);
    } else {
        phi_224_ = false;
    }
    let _e95 = phi_224_;
    if _e95 {
        let _e98 = local.moments[0u];
        let _e101 = local.moments[3u];
        if (_e98 == _e101) {
            let _e105 = local.moments[0u];
            phi_239_ = (_e105 > 0.5f);
        } else {
            phi_239_ = false;
        }
        let _e108 = phi_239_;
        if _e108 {
            if (_e82 > 0f) {
                let _e111 = local.moments;
                if ((bitcast<u32>(_e111.x) & 2147483647u) > 2139095040u) {
                    phi_266_ = _e111.x;
                } else {
                    if (_e111.x < 0f) {
                        phi_265_ = 0f;
                    } else {
                        if (_e111.x > 1f) {
                            phi_264_ = 1f;
                        } else {
                            phi_264_ = _e111.x;
                        }
                        let _e119 = phi_264_;
                        phi_265_ = _e119;
                    }
                    let _e121 = phi_265_;
                    phi_266_ = _e121;
                }
                let _e123 = phi_266_;
                phi_267_ = _e123;
                phi_268_ = false;
            } else {
                phi_267_ = f32();
                phi_268_ = true;
            }
            let _e125 = phi_267_;
            let _e127 = phi_268_;
            phi_269_ = _e125;
            phi_270_ = _e127;
        } else {
            phi_269_ = f32();
            phi_270_ = true;
        }
        let _e129 = phi_269_;
        let _e131 = phi_270_;
        if _e131 {
            let _e134 = local.moments[0u];
            let _e137 = local.moments[1u];
            let _e145 = local.l32_d22_;
            let _e147 = local.d22_;
            let _e148 = (_e145 / _e147);
            let _e149 = (_e82 - _e134);
            let _e155 = local.d22_;
            let _e158 = local.d33_d22_;
            let _e159 = (((((_e82 * _e82) - _e137) - (_e148 * _e149)) * _e155) / _e158);
            let _e161 = local.d22_;
            let _e164 = ((_e149 / _e161) - (_e148 * _e159));
            let _e170 = ((0.5f * _e164) / _e159);
            let _e173 = ((_e170 * _e170) - (((1f - (_e164 * _e134)) - (_e159 * _e137)) / _e159));
            if (_e173 >= 0f) {
                let _e175 = sqrt(_e173);
                phi_326_ = vec2<f32>((-(_e170) - _e175), (-(_e170) + _e175));
            } else {
                phi_326_ = vec2(bitcast<f32>((bitcast<u32>(_e173) | 2143289344u)));
            }
            let _e186 = phi_326_;
            if (_e82 <= _e186.x) {
                phi_407_ = 1f;
            } else {
                if (_e82 > _e186.y) {
                    let _e192 = local.moments;
                    let _e203 = (((_e192.y - (_e192.x * (_e186.x + _e186.y))) + (_e186.x * _e186.y)) / ((_e82 - _e186.x) * (_e82 - _e186.y)));
                    if ((bitcast<u32>(_e203) & 2147483647u) > 2139095040u) {
                        phi_366_ = _e203;
                    } else {
                        if (_e203 < 0f) {
                            phi_365_ = 0f;
                        } else {
                            if (_e203 > 1f) {
                                phi_364_ = 1f;
                            } else {
                                phi_364_ = _e203;
                            }
                            let _e210 = phi_364_;
                            phi_365_ = _e210;
                        }
                        let _e212 = phi_365_;
                        phi_366_ = _e212;
                    }
                    let _e214 = phi_366_;
                    phi_406_ = _e214;
                } else {
                    if (_e82 > _e186.x) {
                        let _e217 = local.moments;
                        let _e229 = (1f - (((_e217.y - (_e217.x * (_e82 + _e186.y))) + (_e82 * _e186.y)) / ((_e186.x - _e82) * (_e186.x - _e186.y))));
                        if ((bitcast<u32>(_e229) & 2147483647u) > 2139095040u) {
                            phi_401_ = _e229;
                        } else {
                            if (_e229 < 0f) {
                                phi_400_ = 0f;
                            } else {
                                if (_e229 > 1f) {
                                    phi_399_ = 1f;
                                } else {
                                    phi_399_ = _e229;
                                }
                                let _e236 = phi_399_;
                                phi_400_ = _e236;
                            }
                            let _e238 = phi_400_;
                            phi_401_ = _e238;
                        }
                        let _e240 = phi_401_;
                        phi_405_ = _e240;
                    } else {
                        phi_405_ = bitcast<f32>((bitcast<u32>(_e186.x) | 2143289344u));
                    }
                    let _e245 = phi_405_;
                    phi_406_ = _e245;
                }
                let _e247 = phi_406_;
                phi_407_ = _e247;
            }
            let _e249 = phi_407_;
            phi_408_ = _e249;
        } else {
            phi_408_ = _e129;
        }
        let _e251 = phi_408_;
        phi_865_ = _e251;
    } else {
        let _e254 = local.moments[0u];
        let _e257 = local.moments[1u];
        let _e265 = local.l32_d22_;
        let _e267 = local.d22_;
        let _e268 = (_e265 / _e267);
        let _e269 = (_e82 - _e254);
        let _e275 = local.d22_;
        let _e278 = local.d33_d22_;
        let _e279 = (((((_e82 * _e82) - _e257) - (_e268 * _e269)) * _e275) / _e278);
        let _e281 = local.d22_;
        let _e284 = ((_e269 / _e281) - (_e268 * _e279));
        let _e290 = ((0.5f * _e284) / _e279);
        let _e293 = ((_e290 * _e290) - (((1f - (_e284 * _e254)) - (_e279 * _e257)) / _e279));
        if (_e293 >= 0f) {
            let _e295 = sqrt(_e293);
            phi_461_ = vec2<f32>((-(_e290) - _e295), (-(_e290) + _e295));
        } else {
            phi_461_ = vec2(bitcast<f32>((bitcast<u32>(_e293) | 2143289344u)));
        }
        let _e306 = phi_461_;
        if (_e306.x >= 0f) {
            if (_e306.y <= 1f) {
                let _e313 = local.moments[0u];
                let _e316 = local.moments[3u];
                if (_e313 == _e316) {
                    let _e320 = local.moments[0u];
                    phi_483_ = (_e320 > 0.5f);
                } else {
                    phi_483_ = false;
                }
                let _e323 = phi_483_;
                if _e323 {
                    if (_e82 > 0f) {
                        let _e326 = local.moments;
                        if ((bitcast<u32>(_e326.x) & 2147483647u) > 2139095040u) {
                            phi_510_ = _e326.x;
                        } else {
                            if (_e326.x < 0f) {
                                phi_509_ = 0f;
                            } else {
                                if (_e326.x > 1f) {
                                    phi_508_ = 1f;
                                } else {
                                    phi_508_ = _e326.x;
                                }
                                let _e334 = phi_508_;
                                phi_509_ = _e334;
                            }
                            let _e336 = phi_509_;
                            phi_510_ = _e336;
                        }
                        let _e338 = phi_510_;
                        phi_511_ = _e338;
                        phi_512_ = false;
                    } else {
                        phi_511_ = f32();
                        phi_512_ = true;
                    }
                    let _e340 = phi_511_;
                    let _e342 = phi_512_;
                    phi_513_ = _e340;
                    phi_514_ = _e342;
                } else {
                    phi_513_ = f32();
                    phi_514_ = true;
                }
                let _e344 = phi_513_;
                let _e346 = phi_514_;
                if _e346 {
                    let _e349 = local.moments[0u];
                    let _e352 = local.moments[1u];
                    let _e360 = local.l32_d22_;
                    let _e362 = local.d22_;
                    let _e363 = (_e360 / _e362);
                    let _e364 = (_e82 - _e349);
                    let _e370 = local.d22_;
                    let _e373 = local.d33_d22_;
                    let _e374 = (((((_e82 * _e82) - _e352) - (_e363 * _e364)) * _e370) / _e373);
                    let _e376 = local.d22_;
                    let _e379 = ((_e364 / _e376) - (_e363 * _e374));
                    let _e385 = ((0.5f * _e379) / _e374);
                    let _e388 = ((_e385 * _e385) - (((1f - (_e379 * _e349)) - (_e374 * _e352)) / _e374));
                    if (_e388 >= 0f) {
                        let _e390 = sqrt(_e388);
                        phi_570_ = vec2<f32>((-(_e385) - _e390), (-(_e385) + _e390));
                    } else {
                        phi_570_ = vec2(bitcast<f32>((bitcast<u32>(_e388) | 2143289344u)));
                    }
                    let _e401 = phi_570_;
                    if (_e82 <= _e401.x) {
                        phi_651_ = 1f;
                    } else {
                        if (_e82 > _e401.y) {
                            let _e407 = local.moments;
                            let _e418 = (((_e407.y - (_e407.x * (_e401.x + _e401.y))) + (_e401.x * _e401.y)) / ((_e82 - _e401.x) * (_e82 - _e401.y)));
                            if ((bitcast<u32>(_e418) & 2147483647u) > 2139095040u) {
                                phi_610_ = _e418;
                            } else {
                                if (_e418 < 0f) {
                                    phi_609_ = 0f;
                                } else {
                                    if (_e418 > 1f) {
                                        phi_608_ = 1f;
                                    } else {
                                        phi_608_ = _e418;
                                    }
                                    let _e425 = phi_608_;
                                    phi_609_ = _e425;
                                }
                                let _e427 = phi_609_;
                                phi_610_ = _e427;
                            }
                            let _e429 = phi_610_;
                            phi_650_ = _e429;
                        } else {
                            if (_e82 > _e401.x) {
                                let _e432 = local.moments;
                                let _e444 = (1f - (((_e432.y - (_e432.x * (_e82 + _e401.y))) + (_e82 * _e401.y)) / ((_e401.x - _e82) * (_e401.x - _e401.y))));
                                if ((bitcast<u32>(_e444) & 2147483647u) > 2139095040u) {
                                    phi_645_ = _e444;
                                } else {
                                    if (_e444 < 0f) {
                                        phi_644_ = 0f;
                                    } else {
                                        if (_e444 > 1f) {
                                            phi_643_ = 1f;
                                        } else {
                                            phi_643_ = _e444;
                                        }
                                        let _e451 = phi_643_;
                                        phi_644_ = _e451;
                                    }
                                    let _e453 = phi_644_;
                                    phi_645_ = _e453;
                                }
                                let _e455 = phi_645_;
                                phi_649_ = _e455;
                            } else {
                                phi_649_ = bitcast<f32>((bitcast<u32>(_e401.x) | 2143289344u));
                            }
                            let _e460 = phi_649_;
                            phi_650_ = _e460;
                        }
                        let _e462 = phi_650_;
                        phi_651_ = _e462;
                    }
                    let _e464 = phi_651_;
                    phi_652_ = _e464;
                } else {
                    phi_652_ = _e344;
                }
                let _e466 = phi_652_;
                phi_653_ = _e466;
                phi_654_ = false;
            } else {
                phi_653_ = f32();
                phi_654_ = true;
            }
            let _e468 = phi_653_;
            let _e470 = phi_654_;
            phi_655_ = _e468;
            phi_656_ = _e470;
        } else {
            phi_655_ = f32();
            phi_656_ = true;
        }
        let _e472 = phi_655_;
        let _e474 = phi_656_;
        if _e474 {
            if ((bitcast<u32>(_e306.x) & 2147483647u) > 2139095040u) {
                phi_863_ = _e306.x;
            } else {
                let _e478 = lt_math_hausdorff_endpoint_upper_bound((&local), _e82);
                let _e481 = local.moments[0u];
                let _e484 = local.moments[3u];
                if (_e481 == _e484) {
                    let _e488 = local.moments[0u];
                    phi_678_ = (_e488 > 0.5f);
                } else {
                    phi_678_ = false;
                }
                let _e491 = phi_678_;
                if _e491 {
                    if (_e82 > 0f) {
                        let _e494 = local.moments;
                        if ((bitcast<u32>(_e494.x) & 2147483647u) > 2139095040u) {
                            phi_705_ = _e494.x;
                        } else {
                            if (_e494.x < 0f) {
                                phi_704_ = 0f;
                            } else {
                                if (_e494.x > 1f) {
                                    phi_703_ = 1f;
                                } else {
                                    phi_703_ = _e494.x;
                                }
                                let _e502 = phi_703_;
                                phi_704_ = _e502;
                            }
                            let _e504 = phi_704_;
                            phi_705_ = _e504;
                        }
                        let _e506 = phi_705_;
                        phi_706_ = _e506;
                        phi_707_ = false;
                    } else {
                        phi_706_ = f32();
                        phi_707_ = true;
                    }
                    let _e508 = phi_706_;
                    let _e510 = phi_707_;
                    phi_708_ = _e508;
                    phi_709_ = _e510;
                } else {
                    phi_708_ = f32();
                    phi_709_ = true;
                }
                let _e512 = phi_708_;
                let _e514 = phi_709_;
                if _e514 {
                    let _e517 = local.moments[0u];
                    let _e520 = local.moments[1u];
                    let _e528 = local.l32_d22_;
                    let _e530 = local.d22_;
                    let _e531 = (_e528 / _e530);
                    let _e532 = (_e82 - _e517);
                    let _e538 = local.d22_;
                    let _e541 = local.d33_d22_;
                    let _e542 = (((((_e82 * _e82) - _e520) - (_e531 * _e532)) * _e538) / _e541);
                    let _e544 = local.d22_;
                    let _e547 = ((_e532 / _e544) - (_e531 * _e542));
                    let _e553 = ((0.5f * _e547) / _e542);
                    let _e556 = ((_e553 * _e553) - (((1f - (_e547 * _e517)) - (_e542 * _e520)) / _e542));
                    if (_e556 >= 0f) {
                        let _e558 = sqrt(_e556);
                        phi_765_ = vec2<f32>((-(_e553) - _e558), (-(_e553) + _e558));
                    } else {
                        phi_765_ = vec2(bitcast<f32>((bitcast<u32>(_e556) | 2143289344u)));
                    }
                    let _e569 = phi_765_;
                    if (_e82 <= _e569.x) {
                        phi_846_ = 1f;
                    } else {
                        if (_e82 > _e569.y) {
                            let _e575 = local.moments;
                            let _e586 = (((_e575.y - (_e575.x * (_e569.x + _e569.y))) + (_e569.x * _e569.y)) / ((_e82 - _e569.x) * (_e82 - _e569.y)));
                            if ((bitcast<u32>(_e586) & 2147483647u) > 2139095040u) {
                                phi_805_ = _e586;
                            } else {
                                if (_e586 < 0f) {
                                    phi_804_ = 0f;
                                } else {
                                    if (_e586 > 1f) {
                                        phi_803_ = 1f;
                                    } else {
                                        phi_803_ = _e586;
                                    }
                                    let _e593 = phi_803_;
                                    phi_804_ = _e593;
                                }
                                let _e595 = phi_804_;
                                phi_805_ = _e595;
                            }
                            let _e597 = phi_805_;
                            phi_845_ = _e597;
                        } else {
                            if (_e82 > _e569.x) {
                                let _e600 = local.moments;
                                let _e612 = (1f - (((_e600.y - (_e600.x * (_e82 + _e569.y))) + (_e82 * _e569.y)) / ((_e569.x - _e82) * (_e569.x - _e569.y))));
                                if ((bitcast<u32>(_e612) & 2147483647u) > 2139095040u) {
                                    phi_840_ = _e612;
                                } else {
                                    if (_e612 < 0f) {
                                        phi_839_ = 0f;
                                    } else {
                                        if (_e612 > 1f) {
                                            phi_838_ = 1f;
                                        } else {
                                            phi_838_ = _e612;
                                        }
                                        let _e619 = phi_838_;
                                        phi_839_ = _e619;
                                    }
                                    let _e621 = phi_839_;
                                    phi_840_ = _e621;
                                }
                                let _e623 = phi_840_;
                                phi_844_ = _e623;
                            } else {
                                phi_844_ = bitcast<f32>((bitcast<u32>(_e569.x) | 2143289344u));
                            }
                            let _e628 = phi_844_;
                            phi_845_ = _e628;
                        }
                        let _e630 = phi_845_;
                        phi_846_ = _e630;
                    }
                    let _e632 = phi_846_;
                    phi_847_ = _e632;
                } else {
                    phi_847_ = _e512;
                }
                let _e634 = phi_847_;
                if ((bitcast<u32>(_e634) & 2147483647u) > 2139095040u) {
                    phi_858_ = true;
                } else {
                    let _e638 = (_e634 < _e478);
                    if _e638 {
                    }
                    phi_858_ = _e638;
                }
                let _e640 = phi_858_;
                if _e640 {
                    phi_862_ = _e634;
                } else {
                    phi_862_ = _e478;
                }
                let _e642 = phi_862_;
                phi_863_ = _e642;
            }
            let _e644 = phi_863_;
            phi_864_ = _e644;
        } else {
            phi_864_ = _e472;
        }
        let _e646 = phi_864_;
        phi_865_ = _e646;
    }
    let _e648 = phi_865_;
    return _e648;
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
    var phi_1217_: bool;
    var phi_1226_: bool;
    var phi_1235_: bool;
    var phi_1236_: bool;
    var phi_1237_: bool;
    var phi_1238_: bool;
    var phi_1239_: bool;
    var phi_1240_: bool;
    var phi_1241_: bool;
    var phi_1245_: bool;
    var phi_1335_: f32;
    var phi_1338_: f32;
    var phi_1367_: f32;
    var phi_1372_: f32;
    var phi_1373_: bool;
    var phi_1374_: f32;
    var phi_1375_: bool;
    var phi_1379_: f32;
    var phi_1399_: f32;
    var phi_1404_: f32;
    var phi_1405_: bool;
    var phi_1406_: f32;
    var phi_1407_: bool;
    var phi_1411_: f32;
    var phi_1459_: i32;
    var phi_1464_: i32;
    var phi_1469_: i32;
    var phi_1474_: i32;
    var phi_1483_: i32;
    var phi_1488_: i32;
    var phi_1493_: i32;
    var phi_1498_: i32;
    var phi_1593_: bool;
    var phi_1601_: bool;
    var phi_1613_: bool;
    var phi_1614_: bool;
    var phi_1618_: f32;
    var phi_1624_: f32;
    var phi_1626_: evaluate_Verdict;
    var phi_1631_: evaluate_Verdict;
    var phi_1632_: evaluate_Verdict;

    let _e38 = id_1;
    let _e45 = arrayLength((&map.member));
    let _e51 = p.member.size[0u];
    let _e53 = p.member.size[1u];
    let _e54 = lt_shaders_entry_pixel_index(_e38, _e51, _e53);
    if (bitcast<i32>(_e54.root) != 0i) {
        let _e60 = p.member.projection;
        if (_e54.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e64 = lt_math_OneLevel(_e60);
        let _e66 = p.member.light;
        let _e69 = samples.member[(0u + _e54.first_primitive)].normal[0u];
        let _e71 = global[0u];
        if (_e69 == _e71) {
            let _e74 = samples.member[(0u + _e54.first_primitive)].normal[1u];
            let _e76 = global[1u];
            if (_e74 == _e76) {
                let _e79 = samples.member[(0u + _e54.first_primitive)].normal[2u];
                let _e81 = global[2u];
                phi_1088_ = (_e79 == _e81);
                phi_1089_ = false;
            } else {
                phi_1088_ = bool();
                phi_1089_ = true;
            }
            let _e84 = phi_1088_;
            let _e86 = phi_1089_;
            phi_1090_ = _e84;
            phi_1091_ = _e86;
        } else {
            phi_1090_ = bool();
            phi_1091_ = true;
        }
        let _e88 = phi_1090_;
        let _e90 = phi_1091_;
        if _e90 {
            phi_1095_ = false;
        } else {
            phi_1095_ = _e88;
        }
        let _e92 = phi_1095_;
        if !(_e92) {
            let _e95 = samples.member[(0u + _e54.first_primitive)].normal;
            let _e97 = samples.member[(0u + _e54.first_primitive)].position;
            if ((((_e95.x * (_e66.x - (_e97.x * _e66.w))) + (_e95.y * (_e66.y - (_e97.y * _e66.w)))) + (_e95.z * (_e66.z - (_e97.z * _e66.w)))) > 0f) {
                let _e121 = samples.member[(0u + _e54.first_primitive)].flags;
                let _e129 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e135 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e129.unnamed.visibility, false), _e129.unnamed_1);
                phi_1139_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e135.unnamed, ((_e121 & 1u) == 0u));
            } else {
                let _e144 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e150 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e144.unnamed.visibility, false), _e144.unnamed_1);
                phi_1139_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e150.unnamed, true);
            }
            let _e155 = phi_1139_;
            phi_1143_ = _e155;
        } else {
            let _e161 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e167 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e161.unnamed.visibility, false), _e161.unnamed_1);
            phi_1143_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e167.unnamed, true);
        }
        let _e172 = phi_1143_;
        if _e172.unnamed_1 {
            phi_1632_ = evaluate_Verdict(_e172.unnamed.visibility, _e172.unnamed.is_doubted);
        } else {
            let _e180 = samples.member[(0u + _e54.first_primitive)].position;
            let _e198 = ((((_e64.projection.row_w.x * _e180.x) + (_e64.projection.row_w.y * _e180.y)) + (_e64.projection.row_w.z * _e180.z)) + (_e64.projection.row_w.w * 1f));
            let _e212 = (((((_e64.projection.row_x.x * _e180.x) + (_e64.projection.row_x.y * _e180.y)) + (_e64.projection.row_x.z * _e180.z)) + (_e64.projection.row_x.w * 1f)) / _e198);
            let _e226 = (((((_e64.projection.row_y.x * _e180.x) + (_e64.projection.row_y.y * _e180.y)) + (_e64.projection.row_y.z * _e180.z)) + (_e64.projection.row_y.w * 1f)) / _e198);
            let _e239 = ((((_e64.projection.row_z.x * _e180.x) + (_e64.projection.row_z.y * _e180.y)) + (_e64.projection.row_z.z * _e180.z)) + (_e64.projection.row_z.w * 1f));
            if (_e198 > 0f) {
                if (_e212 >= 0f) {
                    phi_1217_ = (_e212 <= 1f);
                } else {
                    phi_1217_ = false;
                }
                let _e244 = phi_1217_;
                if _e244 {
                    if (_e226 >= 0f) {
                        phi_1226_ = (_e226 <= 1f);
                    } else {
                        phi_1226_ = false;
                    }
                    let _e248 = phi_1226_;
                    if _e248 {
                        if (_e239 >= 0f) {
                            phi_1235_ = (_e239 <= 1f);
                        } else {
                            phi_1235_ = false;
                        }
                        let _e252 = phi_1235_;
                        phi_1236_ = _e252;
                        phi_1237_ = false;
                    } else {
                        phi_1236_ = bool();
                        phi_1237_ = true;
                    }
                    let _e254 = phi_1236_;
                    let _e256 = phi_1237_;
                    phi_1238_ = _e254;
                    phi_1239_ = _e256;
                } else {
                    phi_1238_ = bool();
                    phi_1239_ = true;
                }
                let _e258 = phi_1238_;
                let _e260 = phi_1239_;
                phi_1240_ = _e258;
                phi_1241_ = _e260;
            } else {
                phi_1240_ = bool();
                phi_1241_ = true;
            }
            let _e262 = phi_1240_;
            let _e264 = phi_1241_;
            if _e264 {
                phi_1245_ = false;
            } else {
                phi_1245_ = _e262;
            }
            let _e266 = phi_1245_;
            if _e266 {
                if (0f > 0f) {
                    let _e269 = samples.member[(0u + _e54.first_primitive)].normal;
                    let _e271 = p.member.map_size;
                    let _e341 = ((abs(((((_e60.row_x.x * _e269.x) + (_e60.row_x.y * _e269.y)) + (_e60.row_x.z * _e269.z)) / (((_e60.row_x.x * _e60.row_x.x) + (_e60.row_x.y * _e60.row_x.y)) + (_e60.row_x.z * _e60.row_x.z)))) + abs(((((_e60.row_y.x * _e269.x) + (_e60.row_y.y * _e269.y)) + (_e60.row_y.z * _e269.z)) / (((_e60.row_y.x * _e60.row_y.x) + (_e60.row_y.y * _e60.row_y.y)) + (_e60.row_y.z * _e60.row_y.z))))) / (abs(((((_e60.row_z.x * _e269.x) + (_e60.row_z.y * _e269.y)) + (_e60.row_z.z * _e269.z)) / (((_e60.row_z.x * _e60.row_z.x) + (_e60.row_z.y * _e60.row_z.y)) + (_e60.row_z.z * _e60.row_z.z)))) * f32(_e271)));
                    if (_e341 < 0.002f) {
                        phi_1335_ = _e341;
                    } else {
                        phi_1335_ = 0.002f;
                    }
                    let _e344 = phi_1335_;
                    phi_1338_ = (_e239 - (0f * _e344));
                } else {
                    phi_1338_ = _e239;
                }
                let _e348 = phi_1338_;
                let _e350 = p.member.map_size;
                let _e351 = f32(_e350);
                let _e354 = ((_e212 * _e351) - 0.5f);
                let _e355 = ((_e226 * _e351) - 0.5f);
                if (_e354 > -8388608f) {
                    let _e367 = f32(select(0i, select(select(i32(_e354), i32(-2147483648), (_e354 < bitcast<f32>(3472883712u))), 2147483647i, (_e354 > bitcast<f32>(1325400063u))), (_e354 == _e354)));
                    if (_e367 > _e354) {
                        phi_1367_ = 1f;
                    } else {
                        phi_1367_ = 0f;
                    }
                    let _e370 = phi_1367_;
                    if (_e354 < 8388608f) {
                        phi_1372_ = (_e367 - _e370);
                        phi_1373_ = false;
                    } else {
                        phi_1372_ = f32();
                        phi_1373_ = true;
                    }
                    let _e373 = phi_1372_;
                    let _e375 = phi_1373_;
                    phi_1374_ = _e373;
                    phi_1375_ = _e375;
                } else {
                    phi_1374_ = f32();
                    phi_1375_ = true;
                }
                let _e377 = phi_1374_;
                let _e379 = phi_1375_;
                if _e379 {
                    phi_1379_ = _e354;
                } else {
                    phi_1379_ = _e377;
                }
                let _e381 = phi_1379_;
                if (_e355 > -8388608f) {
                    let _e393 = f32(select(0i, select(select(i32(_e355), i32(-2147483648), (_e355 < bitcast<f32>(3472883712u))), 2147483647i, (_e355 > bitcast<f32>(1325400063u))), (_e355 == _e355)));
                    if (_e393 > _e355) {
                        phi_1399_ = 1f;
                    } else {
                        phi_1399_ = 0f;
                    }
                    let _e396 = phi_1399_;
                    if (_e355 < 8388608f) {
                        phi_1404_ = (_e393 - _e396);
                        phi_1405_ = false;
                    } else {
                        phi_1404_ = f32();
                        phi_1405_ = true;
                    }
                    let _e399 = phi_1404_;
                    let _e401 = phi_1405_;
                    phi_1406_ = _e399;
                    phi_1407_ = _e401;
                } else {
                    phi_1406_ = f32();
                    phi_1407_ = true;
                }
                let _e403 = phi_1406_;
                let _e405 = phi_1407_;
                if _e405 {
                    phi_1411_ = _e355;
                } else {
                    phi_1411_ = _e403;
                }
                let _e407 = phi_1411_;
                let _e408 = (_e354 - _e381);
                let _e409 = (_e355 - _e407);
                let _e418 = select(0i, select(select(i32(_e381), i32(-2147483648), (_e381 < bitcast<f32>(3472883712u))), 2147483647i, (_e381 > bitcast<f32>(1325400063u))), (_e381 == _e381));
                let _e427 = select(0i, select(select(i32(_e407), i32(-2147483648), (_e407 < bitcast<f32>(3472883712u))), 2147483647i, (_e407 > bitcast<f32>(1325400063u))), (_e407 == _e407));
                let _e430 = ((1f - _e408) * (1f - _e409));
                let _e432 = (_e408 * (1f - _e409));
                let _e434 = ((1f - _e408) * _e409);
                let _e435 = (_e408 * _e409);
                let _e437 = p.member.test;
                let _e438 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e437);
                let _e440 = p.member.map_size;
                local_1 = _e438;
                let _e442 = ((0u * _e440) * _e440);
                let _e444 = (bitcast<i32>(_e440) - 1i);
                if (_e418 > 0i) {
                    phi_1459_ = _e418;
                } else {
                    phi_1459_ = 0i;
                }
                let _e447 = phi_1459_;
                if (_e427 > 0i) {
                    phi_1464_ = _e427;
                } else {
                    phi_1464_ = 0i;
                }
                let _e450 = phi_1464_;
                if (_e447 < _e444) {
                    phi_1469_ = _e447;
                } else {
                    phi_1469_ = _e444;
                }
                let _e453 = phi_1469_;
                if (_e450 < _e444) {
                    phi_1474_ = _e450;
                } else {
                    phi_1474_ = _e444;
                }
                let _e456 = phi_1474_;
                let _e457 = bitcast<u32>(_e453);
                let _e459 = (_e418 + 1i);
                let _e460 = (_e427 + 1i);
                if (_e459 > 0i) {
                    phi_1483_ = _e459;
                } else {
                    phi_1483_ = 0i;
                }
                let _e463 = phi_1483_;
                if (_e460 > 0i) {
                    phi_1488_ = _e460;
                } else {
                    phi_1488_ = 0i;
                }
                let _e466 = phi_1488_;
                if (_e463 < _e444) {
                    phi_1493_ = _e463;
                } else {
                    phi_1493_ = _e444;
                }
                let _e469 = phi_1493_;
                if (_e466 < _e444) {
                    phi_1498_ = _e466;
                } else {
                    phi_1498_ = _e444;
                }
                let _e472 = phi_1498_;
                let _e473 = bitcast<u32>(_e469);
                let _e475 = (bitcast<u32>(_e456) * _e440);
                let _e476 = (bitcast<u32>(_e472) * _e440);
                let _e481 = ((_e475 + _e457) + _e442);
                let _e482 = ((_e475 + _e473) + _e442);
                let _e483 = ((_e476 + _e457) + _e442);
                let _e484 = ((_e476 + _e473) + _e442);
                if (_e481 < _e45) {
                } else {
                    return;
                }
                let _e488 = map.member[(0u + _e481)];
                if (_e482 < _e45) {
                } else {
                    return;
                }
                let _e500 = map.member[(0u + _e482)];
                if (_e483 < _e45) {
                } else {
                    return;
                }
                let _e516 = map.member[(0u + _e483)];
                if (_e484 < _e45) {
                } else {
                    return;
                }
                let _e532 = map.member[(0u + _e484)];
                let _e546 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_1), vec4<f32>(((((_e488.x * _e430) + (_e500.x * _e432)) + (_e516.x * _e434)) + (_e532.x * _e435)), ((((_e488.y * _e430) + (_e500.y * _e432)) + (_e516.y * _e434)) + (_e532.y * _e435)), ((((_e488.z * _e430) + (_e500.z * _e432)) + (_e516.z * _e434)) + (_e532.z * _e435)), ((((_e488.w * _e430) + (_e500.w * _e432)) + (_e516.w * _e434)) + (_e532.w * _e435))), _e348);
                let _e548 = p.member.epsilon;
                if (_e546 <= _e548) {
                    phi_1593_ = true;
                } else {
                    phi_1593_ = (_e546 >= (1f - _e548));
                }
                let _e553 = phi_1593_;
                if ((bitcast<u32>(_e546) & 2147483647u) > 2139095040u) {
                    phi_1601_ = true;
                } else {
                    phi_1601_ = !(_e553);
                }
                let _e559 = phi_1601_;
                if _e559 {
                    if (_e546 > 0f) {
                        if (_e546 < 1f) {
                            phi_1613_ = false;
                        } else {
                            phi_1613_ = true;
                        }
                        let _e563 = phi_1613_;
                        phi_1614_ = _e563;
                    } else {
                        phi_1614_ = true;
                    }
                    let _e565 = phi_1614_;
                    if _e565 {
                        phi_1618_ = 0.5f;
                    } else {
                        phi_1618_ = _e546;
                    }
                    let _e567 = phi_1618_;
                    phi_1626_ = evaluate_Verdict(_e567, true);
                } else {
                    if (_e546 > 0.5f) {
                        phi_1624_ = 1f;
                    } else {
                        phi_1624_ = 0f;
                    }
                    let _e571 = phi_1624_;
                    phi_1626_ = evaluate_Verdict(_e571, false);
                }
                let _e574 = phi_1626_;
                phi_1631_ = evaluate_Verdict(_e574.visibility, _e574.is_doubted);
            } else {
                phi_1631_ = evaluate_Verdict(0.5f, true);
            }
            let _e580 = phi_1631_;
            phi_1632_ = _e580;
        }
        let _e582 = phi_1632_;
        if (_e54.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e54.first_primitive)] = _e582.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_msm_hausdorff_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
