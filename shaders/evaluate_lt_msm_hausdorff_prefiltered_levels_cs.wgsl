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

struct lt_math_LightPoint {
    uv: vec2<f32>,
    depth: f32,
    is_inside: bool,
}

struct type_39 {
    member: array<lt_math_LightProjection>,
}

struct lt_math_LevelPoint {
    level: u32,
    point: lt_math_LightPoint,
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
@group(0) @binding(4) 
var<storage> levels: type_39;
@group(0) @binding(2) 
var<storage> map: type_29;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_157_: lt_bvh_traverse_Tree;
    var phi_158_: bool;
    var phi_159_: lt_bvh_traverse_Tree;
    var phi_160_: bool;
    var phi_165_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_157_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_158_ = false;
        } else {
            phi_157_ = lt_bvh_traverse_Tree();
            phi_158_ = true;
        }
        let _e54 = phi_157_;
        let _e56 = phi_158_;
        phi_159_ = _e54;
        phi_160_ = _e56;
    } else {
        phi_159_ = lt_bvh_traverse_Tree();
        phi_160_ = true;
    }
    let _e58 = phi_159_;
    let _e60 = phi_160_;
    if _e60 {
        phi_165_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_165_ = _e58;
    }
    let _e65 = phi_165_;
    return lt_bvh_traverse_Tree(_e65.root, _e65.first_primitive);
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn lt_math_hausdorff_cubic_mass(param_4: vec4<f32>, param_5: f32, param_6: f32, param_7: f32, param_8: f32) -> f32 {
    return ((((param_4.z - (((param_6 + param_7) + param_8) * param_4.y)) + ((((param_6 * param_7) + (param_6 * param_8)) + (param_7 * param_8)) * param_4.x)) - ((param_6 * param_7) * param_8)) / (((param_5 - param_6) * (param_5 - param_7)) * (param_5 - param_8)));
}

fn lt_math_hausdorff_endpoint_upper_bound(param_9: ptr<function, hankel_HankelFactors>, param_10: f32) -> f32 {
    var phi_935_: f32;
    var phi_936_: f32;
    var phi_937_: f32;
    var phi_964_: f32;
    var phi_965_: f32;
    var phi_966_: f32;
    var phi_967_: f32;
    var phi_968_: bool;
    var phi_969_: f32;
    var phi_970_: bool;
    var phi_998_: f32;
    var phi_999_: f32;
    var phi_1000_: f32;
    var phi_1001_: f32;
    var phi_1002_: bool;
    var phi_1003_: f32;
    var phi_1004_: bool;
    var phi_1011_: f32;
    var phi_1012_: f32;
    var phi_1013_: f32;
    var phi_1014_: f32;

    let _e44 = (*param_9).moments;
    if (param_10 < 0.0001f) {
        phi_1014_ = 1f;
    } else {
        let _e53 = ((_e44.z - ((1f + param_10) * _e44.y)) + (param_10 * _e44.x));
        let _e62 = (((_e44.w - ((1f + param_10) * _e44.z)) + (param_10 * _e44.y)) / _e53);
        if (abs(_e53) <= 0.00000047683716f) {
            let _e76 = (1f - (((_e44.y - (_e44.x * (param_10 + 1f))) + (param_10 * 1f)) / ((0f - param_10) * (0f - 1f))));
            if ((bitcast<u32>(_e76) & 2147483647u) > 2139095040u) {
                phi_937_ = _e76;
            } else {
                if (_e76 < 0f) {
                    phi_936_ = 0f;
                } else {
                    if (_e76 > 1f) {
                        phi_935_ = 1f;
                    } else {
                        phi_935_ = _e76;
                    }
                    let _e83 = phi_935_;
                    phi_936_ = _e83;
                }
                let _e85 = phi_936_;
                phi_937_ = _e85;
            }
            let _e87 = phi_937_;
            phi_1013_ = _e87;
        } else {
            if (_e62 > 0f) {
                if (_e62 < param_10) {
                    let _e90 = lt_math_hausdorff_cubic_mass(_e44, 0f, _e62, param_10, 1f);
                    let _e92 = lt_math_hausdorff_cubic_mass(_e44, _e62, 0f, param_10, 1f);
                    let _e93 = ((1f - _e90) - _e92);
                    if ((bitcast<u32>(_e93) & 2147483647u) > 2139095040u) {
                        phi_966_ = _e93;
                    } else {
                        if (_e93 < 0f) {
                            phi_965_ = 0f;
                        } else {
                            if (_e93 > 1f) {
                                phi_964_ = 1f;
                            } else {
                                phi_964_ = _e93;
                            }
                            let _e100 = phi_964_;
                            phi_965_ = _e100;
                        }
                        let _e102 = phi_965_;
                        phi_966_ = _e102;
                    }
                    let _e104 = phi_966_;
                    phi_967_ = _e104;
                    phi_968_ = false;
                } else {
                    phi_967_ = f32();
                    phi_968_ = true;
                }
                let _e106 = phi_967_;
                let _e108 = phi_968_;
                phi_969_ = _e106;
                phi_970_ = _e108;
            } else {
                phi_969_ = f32();
                phi_970_ = true;
            }
            let _e110 = phi_969_;
            let _e112 = phi_970_;
            if _e112 {
                if (_e62 > param_10) {
                    if (_e62 < 1f) {
                        let _e115 = lt_math_hausdorff_cubic_mass(_e44, 0f, _e62, param_10, 1f);
                        let _e116 = (1f - _e115);
                        if ((bitcast<u32>(_e116) & 2147483647u) > 2139095040u) {
                            phi_1000_ = _e116;
                        } else {
                            if (_e116 < 0f) {
                                phi_999_ = 0f;
                            } else {
                                if (_e116 > 1f) {
                                    phi_998_ = 1f;
                                } else {
                                    phi_998_ = _e116;
                                }
                                let _e123 = phi_998_;
                                phi_999_ = _e123;
                            }
                            let _e125 = phi_999_;
                            phi_1000_ = _e125;
                        }
                        let _e127 = phi_1000_;
                        phi_1001_ = _e127;
                        phi_1002_ = false;
                    } else {
                        phi_1001_ = f32();
                        phi_1002_ = true;
                    }
                    let _e129 = phi_1001_;
                    let _e131 = phi_1002_;
                    phi_1003_ = _e129;
                    phi_1004_ = _e131;
                } else {
                    phi_1003_ = f32();
                    phi_1004_ = true;
                }
                let _e133 = phi_1003_;
                let _e135 = phi_1004_;
                if _e135 {
                    phi_1011_ = bitcast<f32>((bitcast<u32>(_e62) | 2143289344u));
                } else {
                    phi_1011_ = _e133;
                }
                let _e140 = phi_1011_;
                phi_1012_ = _e140;
            } else {
                phi_1012_ = _e110;
            }
            let _e142 = phi_1012_;
            phi_1013_ = _e142;
        }
        let _e144 = phi_1013_;
        phi_1014_ = _e144;
    }
    let _e146 = phi_1014_;
    return _e146;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_11: ptr<function, f32>, param_12: vec4<f32>, param_13: f32) -> f32 {
    var local: hankel_HankelFactors;
    var phi_222_: f32;
    var phi_223_: f32;
    var phi_224_: f32;
    var phi_236_: bool;
    var phi_251_: bool;
    var phi_276_: f32;
    var phi_277_: f32;
    var phi_278_: f32;
    var phi_279_: f32;
    var phi_280_: bool;
    var phi_281_: f32;
    var phi_282_: bool;
    var phi_338_: vec2<f32>;
    var phi_376_: f32;
    var phi_377_: f32;
    var phi_378_: f32;
    var phi_411_: f32;
    var phi_412_: f32;
    var phi_413_: f32;
    var phi_417_: f32;
    var phi_418_: f32;
    var phi_419_: f32;
    var phi_420_: f32;
    var phi_473_: vec2<f32>;
    var phi_495_: bool;
    var phi_520_: f32;
    var phi_521_: f32;
    var phi_522_: f32;
    var phi_523_: f32;
    var phi_524_: bool;
    var phi_525_: f32;
    var phi_526_: bool;
    var phi_582_: vec2<f32>;
    var phi_620_: f32;
    var phi_621_: f32;
    var phi_622_: f32;
    var phi_655_: f32;
    var phi_656_: f32;
    var phi_657_: f32;
    var phi_661_: f32;
    var phi_662_: f32;
    var phi_663_: f32;
    var phi_664_: f32;
    var phi_665_: f32;
    var phi_666_: bool;
    var phi_667_: f32;
    var phi_668_: bool;
    var phi_690_: bool;
    var phi_715_: f32;
    var phi_716_: f32;
    var phi_717_: f32;
    var phi_718_: f32;
    var phi_719_: bool;
    var phi_720_: f32;
    var phi_721_: bool;
    var phi_777_: vec2<f32>;
    var phi_815_: f32;
    var phi_816_: f32;
    var phi_817_: f32;
    var phi_850_: f32;
    var phi_851_: f32;
    var phi_852_: f32;
    var phi_856_: f32;
    var phi_857_: f32;
    var phi_858_: f32;
    var phi_859_: f32;
    var phi_870_: bool;
    var phi_874_: f32;
    var phi_875_: f32;
    var phi_876_: f32;
    var phi_877_: f32;

    let _e45 = (*param_11);
    let _e46 = (1f - _e45);
    let _e55 = (0.5f * _e45);
    let _e56 = ((param_12.x * _e46) + _e55);
    let _e57 = ((param_12.y * _e46) + _e55);
    let _e58 = ((param_12.z * _e46) + _e55);
    let _e59 = ((param_12.w * _e46) + _e55);
    let _e62 = (_e57 - (_e56 * _e56));
    let _e64 = (_e58 - (_e56 * _e57));
    let _e70 = hankel_HankelFactors(vec4<f32>(_e56, _e57, _e58, _e59), _e62, _e64, (((_e59 - (_e57 * _e57)) * _e62) - (_e64 * _e64)));
    local = hankel_HankelFactors(_e70.moments, _e70.d22_, _e70.l32_d22_, _e70.d33_d22_);
    if ((bitcast<u32>(param_13) & 2147483647u) > 2139095040u) {
        phi_224_ = param_13;
    } else {
        if (param_13 < 0f) {
            phi_223_ = 0f;
        } else {
            if (param_13 > 1f) {
                phi_222_ = 1f;
            } else {
                phi_222_ = param_13;
            }
            let _e82 = phi_222_;
            phi_223_ = _e82;
        }
        let _e84 = phi_223_;
        phi_224_ = _e84;
    }
    let _e86 = phi_224_;
    let _e89 = local.moments[0u];
    let _e92 = local.moments[3u];
    if (_e89 == _e92) {
        let _e96 = local.moments[0u];
        phi_236_ = (_e96 > 0.5f);
    } else {
        phi_236_ = false;
    }
    let _e99 = phi_236_;
    if _e99 {
        let _e102 = local.moments[0u];
        let _e105 = local.moments[3u];
        if (_e102 == _e105) {
            let _e109 = local.moments[0u];
            phi_251_ = (_e109 > 0.5f);
        } else {
            phi_251_ = false;
        }
        let _e112 = phi_251_;
        if _e112 {
            if (_e86 > 0f) {
                let _e115 = local.moments;
                if ((bitcast<u32>(_e115.x) & 2147483647u) > 2139095040u) {
                    phi_278_ = _e115.x;
                } else {
                    if (_e115.x < 0f) {
                        phi_277_ = 0f;
                    } else {
                        if (_e115.x > 1f) {
                            phi_276_ = 1f;
                        } else {
                            phi_276_ = _e115.x;
                        }
                        let _e123 = phi_276_;
                        phi_277_ = _e123;
                    }
                    let _e125 = phi_277_;
                    phi_278_ = _e125;
                }
                let _e127 = phi_278_;
                phi_279_ = _e127;
                phi_280_ = false;
            } else {
                phi_279_ = f32();
                phi_280_ = true;
            }
            let _e129 = phi_279_;
            let _e131 = phi_280_;
            phi_281_ = _e129;
            phi_282_ = _e131;
        } else {
            phi_281_ = f32();
            phi_282_ = true;
        }
        let _e133 = phi_281_;
        let _e135 = phi_282_;
        if _e135 {
            let _e138 = local.moments[0u];
            let _e141 = local.moments[1u];
            let _e149 = local.l32_d22_;
            let _e151 = local.d22_;
            let _e152 = (_e149 / _e151);
            let _e153 = (_e86 - _e138);
            let _e159 = local.d22_;
            let _e162 = local.d33_d22_;
            let _e163 = (((((_e86 * _e86) - _e141) - (_e152 * _e153)) * _e159) / _e162);
            let _e165 = local.d22_;
            let _e168 = ((_e153 / _e165) - (_e152 * _e163));
            let _e174 = ((0.5f * _e168) / _e163);
            let _e177 = ((_e174 * _e174) - (((1f - (_e168 * _e138)) - (_e163 * _e141)) / _e163));
            if (_e177 >= 0f) {
                let _e179 = sqrt(_e177);
                phi_338_ = vec2<f32>((-(_e174) - _e179), (-(_e174) + _e179));
            } else {
                phi_338_ = vec2(bitcast<f32>((bitcast<u32>(_e177) | 2143289344u)));
            }
            let _e190 = phi_338_;
            if (_e86 <= _e190.x) {
                phi_419_ = 1f;
            } else {
                if (_e86 > _e190.y) {
                    let _e196 = local.moments;
                    let _e207 = (((_e196.y - (_e196.x * (_e190.x + _e190.y))) + (_e190.x * _e190.y)) / ((_e86 - _e190.x) * (_e86 - _e190.y)));
                    if ((bitcast<u32>(_e207) & 2147483647u) > 2139095040u) {
                        phi_378_ = _e207;
                    } else {
                        if (_e207 < 0f) {
                            phi_377_ = 0f;
                        } else {
                            if (_e207 > 1f) {
                                phi_376_ = 1f;
                            } else {
                                phi_376_ = _e207;
                            }
                            let _e214 = phi_376_;
                            phi_377_ = _e214;
                        }
                        let _e216 = phi_377_;
                        phi_378_ = _e216;
                    }
                    let _e218 = phi_378_;
                    phi_418_ = _e218;
                } else {
                    if (_e86 > _e190.x) {
                        let _e221 = local.moments;
                        let _e233 = (1f - (((_e221.y - (_e221.x * (_e86 + _e190.y))) + (_e86 * _e190.y)) / ((_e190.x - _e86) * (_e190.x - _e190.y))));
                        if ((bitcast<u32>(_e233) & 2147483647u) > 2139095040u) {
                            phi_413_ = _e233;
                        } else {
                            if (_e233 < 0f) {
                                phi_412_ = 0f;
                            } else {
                                if (_e233 > 1f) {
                                    phi_411_ = 1f;
                                } else {
                                    phi_411_ = _e233;
                                }
                                let _e240 = phi_411_;
                                phi_412_ = _e240;
                            }
                            let _e242 = phi_412_;
                            phi_413_ = _e242;
                        }
                        let _e244 = phi_413_;
                        phi_417_ = _e244;
                    } else {
                        phi_417_ = bitcast<f32>((bitcast<u32>(_e190.x) | 2143289344u));
                    }
                    let _e249 = phi_417_;
                    phi_418_ = _e249;
                }
                let _e251 = phi_418_;
                phi_419_ = _e251;
            }
            let _e253 = phi_419_;
            phi_420_ = _e253;
        } else {
            phi_420_ = _e133;
        }
        let _e255 = phi_420_;
        phi_877_ = _e255;
    } else {
        let _e258 = local.moments[0u];
        let _e261 = local.moments[1u];
        let _e269 = local.l32_d22_;
        let _e271 = local.d22_;
        let _e272 = (_e269 / _e271);
        let _e273 = (_e86 - _e258);
        let _e279 = local.d22_;
        let _e282 = local.d33_d22_;
        let _e283 = (((((_e86 * _e86) - _e261) - (_e272 * _e273)) * _e279) / _e282);
        let _e285 = local.d22_;
        let _e288 = ((_e273 / _e285) - (_e272 * _e283));
        let _e294 = ((0.5f * _e288) / _e283);
        let _e297 = ((_e294 * _e294) - (((1f - (_e288 * _e258)) - (_e283 * _e261)) / _e283));
        if (_e297 >= 0f) {
            let _e299 = sqrt(_e297);
            phi_473_ = vec2<f32>((-(_e294) - _e299), (-(_e294) + _e299));
        } else {
            phi_473_ = vec2(bitcast<f32>((bitcast<u32>(_e297) | 2143289344u)));
        }
        let _e310 = phi_473_;
        if (_e310.x >= 0f) {
            if (_e310.y <= 1f) {
                let _e317 = local.moments[0u];
                let _e320 = local.moments[3u];
                if (_e317 == _e320) {
                    let _e324 = local.moments[0u];
                    phi_495_ = (_e324 > 0.5f);
                } else {
                    phi_495_ = false;
                }
                let _e327 = phi_495_;
                if _e327 {
                    if (_e86 > 0f) {
                        let _e330 = local.moments;
                        if ((bitcast<u32>(_e330.x) & 2147483647u) > 2139095040u) {
                            phi_522_ = _e330.x;
                        } else {
                            if (_e330.x < 0f) {
                                phi_521_ = 0f;
                            } else {
                                if (_e330.x > 1f) {
                                    phi_520_ = 1f;
                                } else {
                                    phi_520_ = _e330.x;
                                }
                                let _e338 = phi_520_;
                                phi_521_ = _e338;
                            }
                            let _e340 = phi_521_;
                            phi_522_ = _e340;
                        }
                        let _e342 = phi_522_;
                        phi_523_ = _e342;
                        phi_524_ = false;
                    } else {
                        phi_523_ = f32();
                        phi_524_ = true;
                    }
                    let _e344 = phi_523_;
                    let _e346 = phi_524_;
                    phi_525_ = _e344;
                    phi_526_ = _e346;
                } else {
                    phi_525_ = f32();
                    phi_526_ = true;
                }
                let _e348 = phi_525_;
                let _e350 = phi_526_;
                if _e350 {
                    let _e353 = local.moments[0u];
                    let _e356 = local.moments[1u];
                    let _e364 = local.l32_d22_;
                    let _e366 = local.d22_;
                    let _e367 = (_e364 / _e366);
                    let _e368 = (_e86 - _e353);
                    let _e374 = local.d22_;
                    let _e377 = local.d33_d22_;
                    let _e378 = (((((_e86 * _e86) - _e356) - (_e367 * _e368)) * _e374) / _e377);
                    let _e380 = local.d22_;
                    let _e383 = ((_e368 / _e380) - (_e367 * _e378));
                    let _e389 = ((0.5f * _e383) / _e378);
                    let _e392 = ((_e389 * _e389) - (((1f - (_e383 * _e353)) - (_e378 * _e356)) / _e378));
                    if (_e392 >= 0f) {
                        let _e394 = sqrt(_e392);
                        phi_582_ = vec2<f32>((-(_e389) - _e394), (-(_e389) + _e394));
                    } else {
                        phi_582_ = vec2(bitcast<f32>((bitcast<u32>(_e392) | 2143289344u)));
                    }
                    let _e405 = phi_582_;
                    if (_e86 <= _e405.x) {
                        phi_663_ = 1f;
                    } else {
                        if (_e86 > _e405.y) {
                            let _e411 = local.moments;
                            let _e422 = (((_e411.y - (_e411.x * (_e405.x + _e405.y))) + (_e405.x * _e405.y)) / ((_e86 - _e405.x) * (_e86 - _e405.y)));
                            if ((bitcast<u32>(_e422) & 2147483647u) > 2139095040u) {
                                phi_622_ = _e422;
                            } else {
                                if (_e422 < 0f) {
                                    phi_621_ = 0f;
                                } else {
                                    if (_e422 > 1f) {
                                        phi_620_ = 1f;
                                    } else {
                                        phi_620_ = _e422;
                                    }
                                    let _e429 = phi_620_;
                                    phi_621_ = _e429;
                                }
                                let _e431 = phi_621_;
                                phi_622_ = _e431;
                            }
                            let _e433 = phi_622_;
                            phi_662_ = _e433;
                        } else {
                            if (_e86 > _e405.x) {
                                let _e436 = local.moments;
                                let _e448 = (1f - (((_e436.y - (_e436.x * (_e86 + _e405.y))) + (_e86 * _e405.y)) / ((_e405.x - _e86) * (_e405.x - _e405.y))));
                                if ((bitcast<u32>(_e448) & 2147483647u) > 2139095040u) {
                                    phi_657_ = _e448;
                                } else {
                                    if (_e448 < 0f) {
                                        phi_656_ = 0f;
                                    } else {
                                        if (_e448 > 1f) {
                                            phi_655_ = 1f;
                                        } else {
                                            phi_655_ = _e448;
                                        }
                                        let _e455 = phi_655_;
                                        phi_656_ = _e455;
                                    }
                                    let _e457 = phi_656_;
                                    phi_657_ = _e457;
                                }
                                let _e459 = phi_657_;
                                phi_661_ = _e459;
                            } else {
                                phi_661_ = bitcast<f32>((bitcast<u32>(_e405.x) | 2143289344u));
                            }
                            let _e464 = phi_661_;
                            phi_662_ = _e464;
                        }
                        let _e466 = phi_662_;
                        phi_663_ = _e466;
                    }
                    let _e468 = phi_663_;
                    phi_664_ = _e468;
                } else {
                    phi_664_ = _e348;
                }
                let _e470 = phi_664_;
                phi_665_ = _e470;
                phi_666_ = false;
            } else {
                phi_665_ = f32();
                phi_666_ = true;
            }
            let _e472 = phi_665_;
            let _e474 = phi_666_;
            phi_667_ = _e472;
            phi_668_ = _e474;
        } else {
            phi_667_ = f32();
            phi_668_ = true;
        }
        let _e476 = phi_667_;
        let _e478 = phi_668_;
        if _e478 {
            if ((bitcast<u32>(_e310.x) & 2147483647u) > 2139095040u) {
                phi_875_ = _e310.x;
            } else {
                let _e482 = lt_math_hausdorff_endpoint_upper_bound((&local), _e86);
                let _e485 = local.moments[0u];
                let _e488 = local.moments[3u];
                if (_e485 == _e488) {
                    let _e492 = local.moments[0u];
                    phi_690_ = (_e492 > 0.5f);
                } else {
                    phi_690_ = false;
                }
                let _e495 = phi_690_;
                if _e495 {
                    if (_e86 > 0f) {
                        let _e498 = local.moments;
                        if ((bitcast<u32>(_e498.x) & 2147483647u) > 2139095040u) {
                            phi_717_ = _e498.x;
                        } else {
                            if (_e498.x < 0f) {
                                phi_716_ = 0f;
                            } else {
                                if (_e498.x > 1f) {
                                    phi_715_ = 1f;
                                } else {
                                    phi_715_ = _e498.x;
                                }
                                let _e506 = phi_715_;
                                phi_716_ = _e506;
                            }
                            let _e508 = phi_716_;
                            phi_717_ = _e508;
                        }
                        let _e510 = phi_717_;
                        phi_718_ = _e510;
                        phi_719_ = false;
                    } else {
                        phi_718_ = f32();
                        phi_719_ = true;
                    }
                    let _e512 = phi_718_;
                    let _e514 = phi_719_;
                    phi_720_ = _e512;
                    phi_721_ = _e514;
                } else {
                    phi_720_ = f32();
                    phi_721_ = true;
                }
                let _e516 = phi_720_;
                let _e518 = phi_721_;
                if _e518 {
                    let _e521 = local.moments[0u];
                    let _e524 = local.moments[1u];
                    let _e532 = local.l32_d22_;
                    let _e534 = local.d22_;
                    let _e535 = (_e532 / _e534);
                    let _e536 = (_e86 - _e521);
                    let _e542 = local.d22_;
                    let _e545 = local.d33_d22_;
                    let _e546 = (((((_e86 * _e86) - _e524) - (_e535 * _e536)) * _e542) / _e545);
                    let _e548 = local.d22_;
                    let _e551 = ((_e536 / _e548) - (_e535 * _e546));
                    let _e557 = ((0.5f * _e551) / _e546);
                    let _e560 = ((_e557 * _e557) - (((1f - (_e551 * _e521)) - (_e546 * _e524)) / _e546));
                    if (_e560 >= 0f) {
                        let _e562 = sqrt(_e560);
                        phi_777_ = vec2<f32>((-(_e557) - _e562), (-(_e557) + _e562));
                    } else {
                        phi_777_ = vec2(bitcast<f32>((bitcast<u32>(_e560) | 2143289344u)));
                    }
                    let _e573 = phi_777_;
                    if (_e86 <= _e573.x) {
                        phi_858_ = 1f;
                    } else {
                        if (_e86 > _e573.y) {
                            let _e579 = local.moments;
                            let _e590 = (((_e579.y - (_e579.x * (_e573.x + _e573.y))) + (_e573.x * _e573.y)) / ((_e86 - _e573.x) * (_e86 - _e573.y)));
                            if ((bitcast<u32>(_e590) & 2147483647u) > 2139095040u) {
                                phi_817_ = _e590;
                            } else {
                                if (_e590 < 0f) {
                                    phi_816_ = 0f;
                                } else {
                                    if (_e590 > 1f) {
                                        phi_815_ = 1f;
                                    } else {
                                        phi_815_ = _e590;
                                    }
                                    let _e597 = phi_815_;
                                    phi_816_ = _e597;
                                }
                                let _e599 = phi_816_;
                                phi_817_ = _e599;
                            }
                            let _e601 = phi_817_;
                            phi_857_ = _e601;
                        } else {
                            if (_e86 > _e573.x) {
                                let _e604 = local.moments;
                                let _e616 = (1f - (((_e604.y - (_e604.x * (_e86 + _e573.y))) + (_e86 * _e573.y)) / ((_e573.x - _e86) * (_e573.x - _e573.y))));
                                if ((bitcast<u32>(_e616) & 2147483647u) > 2139095040u) {
                                    phi_852_ = _e616;
                                } else {
                                    if (_e616 < 0f) {
                                        phi_851_ = 0f;
                                    } else {
                                        if (_e616 > 1f) {
                                            phi_850_ = 1f;
                                        } else {
                                            phi_850_ = _e616;
                                        }
                                        let _e623 = phi_850_;
                                        phi_851_ = _e623;
                                    }
                                    let _e625 = phi_851_;
                                    phi_852_ = _e625;
                                }
                                let _e627 = phi_852_;
                                phi_856_ = _e627;
                            } else {
                                phi_856_ = bitcast<f32>((bitcast<u32>(_e573.x) | 2143289344u));
                            }
                            let _e632 = phi_856_;
                            phi_857_ = _e632;
                        }
                        let _e634 = phi_857_;
                        phi_858_ = _e634;
                    }
                    let _e636 = phi_858_;
                    phi_859_ = _e636;
                } else {
                    phi_859_ = _e516;
                }
                let _e638 = phi_859_;
                if ((bitcast<u32>(_e638) & 2147483647u) > 2139095040u) {
                    phi_870_ = true;
                } else {
                    let _e642 = (_e638 < _e482);
                    if _e642 {
                    }
                    phi_870_ = _e642;
                }
                let _e644 = phi_870_;
                if _e644 {
                    phi_874_ = _e638;
                } else {
                    phi_874_ = _e482;
                }
                let _e646 = phi_874_;
                phi_875_ = _e646;
            }
            let _e648 = phi_875_;
            phi_876_ = _e648;
        } else {
            phi_876_ = _e476;
        }
        let _e650 = phi_876_;
        phi_877_ = _e650;
    }
    let _e652 = phi_877_;
    return _e652;
}

fn function_() {
    var local_1: f32;
    var phi_1104_: bool;
    var phi_1105_: bool;
    var phi_1106_: bool;
    var phi_1107_: bool;
    var phi_1111_: bool;
    var phi_1155_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1159_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1179_: lt_math_LightPoint;
    var phi_1182_: u32;
    var phi_1184_: lt_math_LevelPoint;
    var phi_1270_: bool;
    var phi_1279_: bool;
    var phi_1288_: bool;
    var phi_1289_: bool;
    var phi_1290_: bool;
    var phi_1291_: bool;
    var phi_1292_: bool;
    var phi_1293_: bool;
    var phi_1294_: bool;
    var phi_1298_: bool;
    var phi_1325_: bool;
    var phi_1326_: bool;
    var phi_1327_: bool;
    var phi_1328_: bool;
    var phi_1329_: bool;
    var phi_1330_: bool;
    var phi_1331_: bool;
    var phi_1332_: bool;
    var phi_1336_: bool;
    var phi_1345_: lt_math_LightPoint;
    var phi_1346_: u32;
    var phi_1347_: lt_math_LevelPoint;
    var phi_1348_: bool;
    var phi_1180_: lt_math_LightPoint;
    var phi_1183_: u32;
    var phi_1185_: lt_math_LevelPoint;
    var phi_1349_: bool;
    var local_2: lt_math_LevelPoint;
    var local_3: lt_math_LevelPoint;
    var phi_1389_: bool;
    var phi_1390_: bool;
    var phi_1391_: bool;
    var phi_1392_: bool;
    var phi_1396_: bool;
    var phi_1478_: f32;
    var phi_1594_: f32;
    var phi_1595_: f32;
    var phi_1598_: f32;
    var phi_1627_: f32;
    var phi_1632_: f32;
    var phi_1633_: bool;
    var phi_1634_: f32;
    var phi_1635_: bool;
    var phi_1639_: f32;
    var phi_1659_: f32;
    var phi_1664_: f32;
    var phi_1665_: bool;
    var phi_1666_: f32;
    var phi_1667_: bool;
    var phi_1671_: f32;
    var local_4: lt_math_LevelPoint;
    var phi_1720_: i32;
    var phi_1725_: i32;
    var phi_1730_: i32;
    var phi_1735_: i32;
    var phi_1744_: i32;
    var phi_1749_: i32;
    var phi_1754_: i32;
    var phi_1759_: i32;
    var phi_1854_: bool;
    var phi_1862_: bool;
    var phi_1874_: bool;
    var phi_1875_: bool;
    var phi_1879_: f32;
    var phi_1885_: f32;
    var phi_1887_: evaluate_Verdict;
    var phi_1892_: evaluate_Verdict;
    var phi_1893_: evaluate_Verdict;

    let _e42 = id_1;
    let _e49 = arrayLength((&map.member));
    let _e55 = arrayLength((&levels.member));
    let _e58 = p.member.size[0u];
    let _e60 = p.member.size[1u];
    let _e61 = lt_shaders_entry_pixel_index(_e42, _e58, _e60);
    if (bitcast<i32>(_e61.root) != 0i) {
        let _e67 = p.member.level_count;
        if (_e61.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e72 = p.member.light;
        let _e75 = samples.member[(0u + _e61.first_primitive)].normal[0u];
        let _e77 = global[0u];
        if (_e75 == _e77) {
            let _e80 = samples.member[(0u + _e61.first_primitive)].normal[1u];
            let _e82 = global[1u];
            if (_e80 == _e82) {
                let _e85 = samples.member[(0u + _e61.first_primitive)].normal[2u];
                let _e87 = global[2u];
                phi_1104_ = (_e85 == _e87);
                phi_1105_ = false;
            } else {
                phi_1104_ = bool();
                phi_1105_ = true;
            }
            let _e90 = phi_1104_;
            let _e92 = phi_1105_;
            phi_1106_ = _e90;
            phi_1107_ = _e92;
        } else {
            phi_1106_ = bool();
            phi_1107_ = true;
        }
        let _e94 = phi_1106_;
        let _e96 = phi_1107_;
        if _e96 {
            phi_1111_ = false;
        } else {
            phi_1111_ = _e94;
        }
        let _e98 = phi_1111_;
        if !(_e98) {
            let _e101 = samples.member[(0u + _e61.first_primitive)].normal;
            let _e103 = samples.member[(0u + _e61.first_primitive)].position;
            if ((((_e101.x * (_e72.x - (_e103.x * _e72.w))) + (_e101.y * (_e72.y - (_e103.y * _e72.w)))) + (_e101.z * (_e72.z - (_e103.z * _e72.w)))) > 0f) {
                let _e127 = samples.member[(0u + _e61.first_primitive)].flags;
                let _e135 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e141 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e135.unnamed.visibility, false), _e135.unnamed_1);
                phi_1155_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e141.unnamed, ((_e127 & 1u) == 0u));
            } else {
                let _e150 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e156 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e150.unnamed.visibility, false), _e150.unnamed_1);
                phi_1155_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e156.unnamed, true);
            }
            let _e161 = phi_1155_;
            phi_1159_ = _e161;
        } else {
            let _e167 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e173 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e167.unnamed.visibility, false), _e167.unnamed_1);
            phi_1159_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e173.unnamed, true);
        }
        let _e178 = phi_1159_;
        if _e178.unnamed_1 {
            phi_1893_ = evaluate_Verdict(_e178.unnamed.visibility, _e178.unnamed.is_doubted);
        } else {
            let _e186 = samples.member[(0u + _e61.first_primitive)].position;
            let _e188 = p.member.map_size;
            let _e190 = (0.5f / f32(_e188));
            let _e197 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e204 = lt_math_LightPoint(vec2<f32>(_e197.uv.x, 0f), _e197.depth, _e197.is_inside);
            let _e208 = lt_math_LightPoint(_e204.uv, 0f, _e204.is_inside);
            phi_1179_ = lt_math_LightPoint();
            phi_1182_ = 0u;
            phi_1184_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e208.uv, _e208.depth, false));
            loop {
                let _e215 = phi_1179_;
                let _e217 = phi_1182_;
                let _e219 = phi_1184_;
                local_2 = _e219;
                local_3 = _e219;
                local_4 = _e219;
                if (_e217 < _e67) {
                    if _e219.point.is_inside {
                        phi_1345_ = lt_math_LightPoint();
                        phi_1346_ = u32();
                        phi_1347_ = lt_math_LevelPoint();
                        phi_1348_ = false;
                    } else {
                        if (_e217 < _e55) {
                        } else {
                            return;
                        }
                        let _e230 = levels.member[(0u + _e217)].row_w;
                        let _e241 = ((((_e230.x * _e186.x) + (_e230.y * _e186.y)) + (_e230.z * _e186.z)) + (_e230.w * 1f));
                        let _e243 = levels.member[(0u + _e217)].row_x;
                        let _e255 = (((((_e243.x * _e186.x) + (_e243.y * _e186.y)) + (_e243.z * _e186.z)) + (_e243.w * 1f)) / _e241);
                        let _e257 = levels.member[(0u + _e217)].row_y;
                        let _e269 = (((((_e257.x * _e186.x) + (_e257.y * _e186.y)) + (_e257.z * _e186.z)) + (_e257.w * 1f)) / _e241);
                        let _e271 = levels.member[(0u + _e217)].row_z;
                        let _e282 = ((((_e271.x * _e186.x) + (_e271.y * _e186.y)) + (_e271.z * _e186.z)) + (_e271.w * 1f));
                        if (_e241 > 0f) {
                            if (_e255 >= 0f) {
                                phi_1270_ = (_e255 <= 1f);
                            } else {
                                phi_1270_ = false;
                            }
                            let _e287 = phi_1270_;
                            if _e287 {
                                if (_e269 >= 0f) {
                                    phi_1279_ = (_e269 <= 1f);
                                } else {
                                    phi_1279_ = false;
                                }
                                let _e291 = phi_1279_;
                                if _e291 {
                                    if (_e282 >= 0f) {
                                        phi_1288_ = (_e282 <= 1f);
                                    } else {
                                        phi_1288_ = false;
                                    }
                                    let _e295 = phi_1288_;
                                    phi_1289_ = _e295;
                                    phi_1290_ = false;
                                } else {
                                    phi_1289_ = bool();
                                    phi_1290_ = true;
                                }
                                let _e297 = phi_1289_;
                                let _e299 = phi_1290_;
                                phi_1291_ = _e297;
                                phi_1292_ = _e299;
                            } else {
                                phi_1291_ = bool();
                                phi_1292_ = true;
                            }
                            let _e301 = phi_1291_;
                            let _e303 = phi_1292_;
                            phi_1293_ = _e301;
                            phi_1294_ = _e303;
                        } else {
                            phi_1293_ = bool();
                            phi_1294_ = true;
                        }
                        let _e305 = phi_1293_;
                        let _e307 = phi_1294_;
                        if _e307 {
                            phi_1298_ = false;
                        } else {
                            phi_1298_ = _e305;
                        }
                        let _e309 = phi_1298_;
                        if _e309 {
                            if (_e255 >= _e190) {
                                if (_e255 <= (1f - _e190)) {
                                    if (_e269 >= _e190) {
                                        phi_1325_ = (_e269 <= (1f - _e190));
                                        phi_1326_ = false;
                                    } else {
                                        phi_1325_ = bool();
                                        phi_1326_ = true;
                                    }
                                    let _e317 = phi_1325_;
                                    let _e319 = phi_1326_;
                                    phi_1327_ = _e317;
                                    phi_1328_ = _e319;
                                } else {
                                    phi_1327_ = bool();
                                    phi_1328_ = true;
                                }
                                let _e321 = phi_1327_;
                                let _e323 = phi_1328_;
                                phi_1329_ = _e321;
                                phi_1330_ = _e323;
                            } else {
                                phi_1329_ = bool();
                                phi_1330_ = true;
                            }
                            let _e325 = phi_1329_;
                            let _e327 = phi_1330_;
                            phi_1331_ = _e325;
                            phi_1332_ = _e327;
                        } else {
                            phi_1331_ = bool();
                            phi_1332_ = true;
                        }
                        let _e329 = phi_1331_;
                        let _e331 = phi_1332_;
                        if _e331 {
                            phi_1336_ = false;
                        } else {
                            phi_1336_ = _e329;
                        }
                        let _e333 = phi_1336_;
                        let _e340 = lt_math_LightPoint(vec2<f32>(_e255, _e215.uv.y), _e215.depth, _e215.is_inside);
                        let _e347 = lt_math_LightPoint(vec2<f32>(_e340.uv.x, _e269), _e340.depth, _e340.is_inside);
                        let _e351 = lt_math_LightPoint(_e347.uv, _e282, _e347.is_inside);
                        let _e355 = lt_math_LightPoint(_e351.uv, _e351.depth, _e333);
                        phi_1345_ = _e355;
                        phi_1346_ = (_e217 + 1u);
                        phi_1347_ = lt_math_LevelPoint(_e217, _e355);
                        phi_1348_ = true;
                    }
                    let _e359 = phi_1345_;
                    let _e361 = phi_1346_;
                    let _e363 = phi_1347_;
                    let _e365 = phi_1348_;
                    phi_1180_ = _e359;
                    phi_1183_ = _e361;
                    phi_1185_ = _e363;
                    phi_1349_ = _e365;
                } else {
                    phi_1180_ = lt_math_LightPoint();
                    phi_1183_ = u32();
                    phi_1185_ = lt_math_LevelPoint();
                    phi_1349_ = false;
                }
                let _e367 = phi_1180_;
                let _e369 = phi_1183_;
                let _e371 = phi_1185_;
                let _e373 = phi_1349_;
                continue;
                continuing {
                    phi_1179_ = _e367;
                    phi_1182_ = _e369;
                    phi_1184_ = _e371;
                    break if !(_e373);
                }
            }
            let _e376 = local_2;
            if _e376.point.is_inside {
                if (0f > 0f) {
                    let _e382 = local_3;
                    if (_e382.level < _e55) {
                    } else {
                        return;
                    }
                    let _e387 = levels.member[(0u + _e382.level)];
                    let _e393 = global[0u];
                    if (_e387.row_w.x == _e393) {
                        let _e396 = global[1u];
                        if (_e387.row_w.y == _e396) {
                            let _e399 = global[2u];
                            phi_1389_ = (_e387.row_w.z == _e399);
                            phi_1390_ = false;
                        } else {
                            phi_1389_ = bool();
                            phi_1390_ = true;
                        }
                        let _e402 = phi_1389_;
                        let _e404 = phi_1390_;
                        phi_1391_ = _e402;
                        phi_1392_ = _e404;
                    } else {
                        phi_1391_ = bool();
                        phi_1392_ = true;
                    }
                    let _e406 = phi_1391_;
                    let _e408 = phi_1392_;
                    if _e408 {
                        phi_1396_ = false;
                    } else {
                        phi_1396_ = _e406;
                    }
                    let _e410 = phi_1396_;
                    if _e410 {
                        let _e412 = samples.member[(0u + _e61.first_primitive)].normal;
                        let _e414 = p.member.map_size;
                        let _e484 = ((abs(((((_e387.row_x.x * _e412.x) + (_e387.row_x.y * _e412.y)) + (_e387.row_x.z * _e412.z)) / (((_e387.row_x.x * _e387.row_x.x) + (_e387.row_x.y * _e387.row_x.y)) + (_e387.row_x.z * _e387.row_x.z)))) + abs(((((_e387.row_y.x * _e412.x) + (_e387.row_y.y * _e412.y)) + (_e387.row_y.z * _e412.z)) / (((_e387.row_y.x * _e387.row_y.x) + (_e387.row_y.y * _e387.row_y.y)) + (_e387.row_y.z * _e387.row_y.z))))) / (abs(((((_e387.row_z.x * _e412.x) + (_e387.row_z.y * _e412.y)) + (_e387.row_z.z * _e412.z)) / (((_e387.row_z.x * _e387.row_z.x) + (_e387.row_z.y * _e387.row_z.y)) + (_e387.row_z.z * _e387.row_z.z)))) * f32(_e414)));
                        if (_e484 < 0.002f) {
                            phi_1478_ = _e484;
                        } else {
                            phi_1478_ = 0.002f;
                        }
                        let _e487 = phi_1478_;
                        phi_1595_ = _e487;
                    } else {
                        let _e489 = p.member.map_size;
                        let _e495 = samples.member[(0u + _e61.first_primitive)].position;
                        let _e506 = ((((_e387.row_w.x * _e495.x) + (_e387.row_w.y * _e495.y)) + (_e387.row_w.z * _e495.z)) + _e387.row_w.w);
                        let _e519 = ((_e387.row_x.x - (_e387.row_w.x * _e376.point.uv.x)) / _e506);
                        let _e520 = ((_e387.row_x.y - (_e387.row_w.y * _e376.point.uv.x)) / _e506);
                        let _e521 = ((_e387.row_x.z - (_e387.row_w.z * _e376.point.uv.x)) / _e506);
                        let _e534 = ((_e387.row_y.x - (_e387.row_w.x * _e376.point.uv.y)) / _e506);
                        let _e535 = ((_e387.row_y.y - (_e387.row_w.y * _e376.point.uv.y)) / _e506);
                        let _e536 = ((_e387.row_y.z - (_e387.row_w.z * _e376.point.uv.y)) / _e506);
                        let _e542 = samples.member[(0u + _e61.first_primitive)].normal;
                        let _e547 = ((_e535 * _e542.z) - (_e542.y * _e536));
                        let _e552 = ((_e536 * _e542.x) - (_e542.z * _e534));
                        let _e557 = ((_e534 * _e542.y) - (_e542.x * _e535));
                        let _e559 = samples.member[(0u + _e61.first_primitive)].normal;
                        let _e564 = ((_e520 * _e559.z) - (_e559.y * _e521));
                        let _e569 = ((_e521 * _e559.x) - (_e559.z * _e519));
                        let _e574 = ((_e519 * _e559.y) - (_e559.x * _e520));
                        let _e601 = ((abs(((((_e387.row_z.x * _e547) + (_e387.row_z.y * _e552)) + (_e387.row_z.z * _e557)) / (((_e519 * _e547) + (_e520 * _e552)) + (_e521 * _e557)))) + abs(((((_e387.row_z.x * _e564) + (_e387.row_z.y * _e569)) + (_e387.row_z.z * _e574)) / (((_e534 * _e564) + (_e535 * _e569)) + (_e536 * _e574))))) / f32(_e489));
                        if (_e601 < 0.002f) {
                            phi_1594_ = _e601;
                        } else {
                            phi_1594_ = 0.002f;
                        }
                        let _e604 = phi_1594_;
                        phi_1595_ = _e604;
                    }
                    let _e606 = phi_1595_;
                    phi_1598_ = (_e376.point.depth - (0f * _e606));
                } else {
                    phi_1598_ = _e376.point.depth;
                }
                let _e610 = phi_1598_;
                let _e616 = p.member.map_size;
                let _e617 = f32(_e616);
                let _e620 = ((_e376.point.uv.x * _e617) - 0.5f);
                let _e621 = ((_e376.point.uv.y * _e617) - 0.5f);
                if (_e620 > -8388608f) {
                    let _e633 = f32(select(0i, select(select(i32(_e620), i32(-2147483648), (_e620 < bitcast<f32>(3472883712u))), 2147483647i, (_e620 > bitcast<f32>(1325400063u))), (_e620 == _e620)));
                    if (_e633 > _e620) {
                        phi_1627_ = 1f;
                    } else {
                        phi_1627_ = 0f;
                    }
                    let _e636 = phi_1627_;
                    if (_e620 < 8388608f) {
                        phi_1632_ = (_e633 - _e636);
                        phi_1633_ = false;
                    } else {
                        phi_1632_ = f32();
                        phi_1633_ = true;
                    }
                    let _e639 = phi_1632_;
                    let _e641 = phi_1633_;
                    phi_1634_ = _e639;
                    phi_1635_ = _e641;
                } else {
                    phi_1634_ = f32();
                    phi_1635_ = true;
                }
                let _e643 = phi_1634_;
                let _e645 = phi_1635_;
                if _e645 {
                    phi_1639_ = _e620;
                } else {
                    phi_1639_ = _e643;
                }
                let _e647 = phi_1639_;
                if (_e621 > -8388608f) {
                    let _e659 = f32(select(0i, select(select(i32(_e621), i32(-2147483648), (_e621 < bitcast<f32>(3472883712u))), 2147483647i, (_e621 > bitcast<f32>(1325400063u))), (_e621 == _e621)));
                    if (_e659 > _e621) {
                        phi_1659_ = 1f;
                    } else {
                        phi_1659_ = 0f;
                    }
                    let _e662 = phi_1659_;
                    if (_e621 < 8388608f) {
                        phi_1664_ = (_e659 - _e662);
                        phi_1665_ = false;
                    } else {
                        phi_1664_ = f32();
                        phi_1665_ = true;
                    }
                    let _e665 = phi_1664_;
                    let _e667 = phi_1665_;
                    phi_1666_ = _e665;
                    phi_1667_ = _e667;
                } else {
                    phi_1666_ = f32();
                    phi_1667_ = true;
                }
                let _e669 = phi_1666_;
                let _e671 = phi_1667_;
                if _e671 {
                    phi_1671_ = _e621;
                } else {
                    phi_1671_ = _e669;
                }
                let _e673 = phi_1671_;
                let _e674 = (_e620 - _e647);
                let _e675 = (_e621 - _e673);
                let _e684 = select(0i, select(select(i32(_e647), i32(-2147483648), (_e647 < bitcast<f32>(3472883712u))), 2147483647i, (_e647 > bitcast<f32>(1325400063u))), (_e647 == _e647));
                let _e693 = select(0i, select(select(i32(_e673), i32(-2147483648), (_e673 < bitcast<f32>(3472883712u))), 2147483647i, (_e673 > bitcast<f32>(1325400063u))), (_e673 == _e673));
                let _e696 = ((1f - _e674) * (1f - _e675));
                let _e698 = (_e674 * (1f - _e675));
                let _e700 = ((1f - _e674) * _e675);
                let _e701 = (_e674 * _e675);
                let _e703 = p.member.test;
                let _e704 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e703);
                let _e706 = p.member.map_size;
                let _e708 = local_4;
                local_1 = _e704;
                let _e711 = ((_e708.level * _e706) * _e706);
                let _e713 = (bitcast<i32>(_e706) - 1i);
                if (_e684 > 0i) {
                    phi_1720_ = _e684;
                } else {
                    phi_1720_ = 0i;
                }
                let _e716 = phi_1720_;
                if (_e693 > 0i) {
                    phi_1725_ = _e693;
                } else {
                    phi_1725_ = 0i;
                }
                let _e719 = phi_1725_;
                if (_e716 < _e713) {
                    phi_1730_ = _e716;
                } else {
                    phi_1730_ = _e713;
                }
                let _e722 = phi_1730_;
                if (_e719 < _e713) {
                    phi_1735_ = _e719;
                } else {
                    phi_1735_ = _e713;
                }
                let _e725 = phi_1735_;
                let _e726 = bitcast<u32>(_e722);
                let _e728 = (_e684 + 1i);
                let _e729 = (_e693 + 1i);
                if (_e728 > 0i) {
                    phi_1744_ = _e728;
                } else {
                    phi_1744_ = 0i;
                }
                let _e732 = phi_1744_;
                if (_e729 > 0i) {
                    phi_1749_ = _e729;
                } else {
                    phi_1749_ = 0i;
                }
                let _e735 = phi_1749_;
                if (_e732 < _e713) {
                    phi_1754_ = _e732;
                } else {
                    phi_1754_ = _e713;
                }
                let _e738 = phi_1754_;
                if (_e735 < _e713) {
                    phi_1759_ = _e735;
                } else {
                    phi_1759_ = _e713;
                }
                let _e741 = phi_1759_;
                let _e742 = bitcast<u32>(_e738);
                let _e744 = (bitcast<u32>(_e725) * _e706);
                let _e745 = (bitcast<u32>(_e741) * _e706);
                let _e750 = ((_e744 + _e726) + _e711);
                let _e751 = ((_e744 + _e742) + _e711);
                let _e752 = ((_e745 + _e726) + _e711);
                let _e753 = ((_e745 + _e742) + _e711);
                if (_e750 < _e49) {
                } else {
                    return;
                }
                let _e757 = map.member[(0u + _e750)];
                if (_e751 < _e49) {
                } else {
                    return;
                }
                let _e769 = map.member[(0u + _e751)];
                if (_e752 < _e49) {
                } else {
                    return;
                }
                let _e785 = map.member[(0u + _e752)];
                if (_e753 < _e49) {
                } else {
                    return;
                }
                let _e801 = map.member[(0u + _e753)];
                let _e815 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_1), vec4<f32>(((((_e757.x * _e696) + (_e769.x * _e698)) + (_e785.x * _e700)) + (_e801.x * _e701)), ((((_e757.y * _e696) + (_e769.y * _e698)) + (_e785.y * _e700)) + (_e801.y * _e701)), ((((_e757.z * _e696) + (_e769.z * _e698)) + (_e785.z * _e700)) + (_e801.z * _e701)), ((((_e757.w * _e696) + (_e769.w * _e698)) + (_e785.w * _e700)) + (_e801.w * _e701))), _e610);
                let _e817 = p.member.epsilon;
                if (_e815 <= _e817) {
                    phi_1854_ = true;
                } else {
                    phi_1854_ = (_e815 >= (1f - _e817));
                }
                let _e822 = phi_1854_;
                if ((bitcast<u32>(_e815) & 2147483647u) > 2139095040u) {
                    phi_1862_ = true;
                } else {
                    phi_1862_ = !(_e822);
                }
                let _e828 = phi_1862_;
                if _e828 {
                    if (_e815 > 0f) {
                        if (_e815 < 1f) {
                            phi_1874_ = false;
                        } else {
                            phi_1874_ = true;
                        }
                        let _e832 = phi_1874_;
                        phi_1875_ = _e832;
                    } else {
                        phi_1875_ = true;
                    }
                    let _e834 = phi_1875_;
                    if _e834 {
                        phi_1879_ = 0.5f;
                    } else {
                        phi_1879_ = _e815;
                    }
                    let _e836 = phi_1879_;
                    phi_1887_ = evaluate_Verdict(_e836, true);
                } else {
                    if (_e815 > 0.5f) {
                        phi_1885_ = 1f;
                    } else {
                        phi_1885_ = 0f;
                    }
                    let _e840 = phi_1885_;
                    phi_1887_ = evaluate_Verdict(_e840, false);
                }
                let _e843 = phi_1887_;
                phi_1892_ = evaluate_Verdict(_e843.visibility, _e843.is_doubted);
            } else {
                phi_1892_ = evaluate_Verdict(0.5f, true);
            }
            let _e849 = phi_1892_;
            phi_1893_ = _e849;
        }
        let _e851 = phi_1893_;
        if (_e61.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e61.first_primitive)] = _e851.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_msm_hausdorff_prefiltered_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
