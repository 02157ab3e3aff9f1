struct abi_LightParams {
    place: vec4<f32>,
    axis: vec3<f32>,
    cos_outer: f32,
    range_squared: f32,
    cos_inner: f32,
    pad: vec2<u32>,
}

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

struct type_31 {
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
    light: abi_LightParams,
    test: vec4<f32>,
    size: vec2<u32>,
    map_size: u32,
    epsilon: f32,
    root: u32,
    level_count: u32,
    pad0_: u32,
    pad1_: u32,
}

struct type_35 {
    member: abi_ShadowParams,
}

struct lt_math_LightPoint {
    uv: vec2<f32>,
    depth: f32,
    is_inside: bool,
}

struct type_41 {
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
var<uniform> p: type_35;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_13;
@group(0) @binding(4) 
var<storage> levels: type_41;
@group(0) @binding(2) 
var<storage> map: type_31;

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
        let _e54 = phi_160_;
        let _e56 = phi_161_;
        phi_162_ = _e54;
        phi_163_ = _e56;
    } else {
        phi_162_ = lt_bvh_traverse_Tree();
        phi_163_ = true;
    }
    let _e58 = phi_162_;
    let _e60 = phi_163_;
    if _e60 {
        phi_168_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_168_ = _e58;
    }
    let _e65 = phi_168_;
    return lt_bvh_traverse_Tree(_e65.root, _e65.first_primitive);
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn lt_math_hausdorff_cubic_mass(param_4: vec4<f32>, param_5: f32, param_6: f32, param_7: f32, param_8: f32) -> f32 {
    return ((((param_4.z - (((param_6 + param_7) + param_8) * param_4.y)) + ((((param_6 * param_7) + (param_6 * param_8)) + (param_7 * param_8)) * param_4.x)) - ((param_6 * param_7) * param_8)) / (((param_5 - param_6) * (param_5 - param_7)) * (param_5 - param_8)));
}

fn lt_math_hausdorff_endpoint_upper_bound(param_9: ptr<function, hankel_HankelFactors>, param_10: f32) -> f32 {
    var phi_938_: f32;
    var phi_939_: f32;
    var phi_940_: f32;
    var phi_967_: f32;
    var phi_968_: f32;
    var phi_969_: f32;
    var phi_970_: f32;
    var phi_971_: bool;
    var phi_972_: f32;
    var phi_973_: bool;
    var phi_1001_: f32;
    var phi_1002_: f32;
    var phi_1003_: f32;
    var phi_1004_: f32;
    var phi_1005_: bool;
    var phi_1006_: f32;
    var phi_1007_: bool;
    var phi_1014_: f32;
    var phi_1015_: f32;
    var phi_1016_: f32;
    var phi_1017_: f32;

    let _e44 = (*param_9).moments;
    if (param_10 < 0.0001f) {
        phi_1017_ = 1f;
    } else {
        let _e53 = ((_e44.z - ((1f + param_10) * _e44.y)) + (param_10 * _e44.x));
        let _e62 = (((_e44.w - ((1f + param_10) * _e44.z)) + (param_10 * _e44.y)) / _e53);
        if (abs(_e53) <= 0.00000047683716f) {
            let _e76 = (1f - (((_e44.y - (_e44.x * (param_10 + 1f))) + (param_10 * 1f)) / ((0f - param_10) * (0f - 1f))));
            if ((bitcast<u32>(_e76) & 2147483647u) > 2139095040u) {
                phi_940_ = _e76;
            } else {
                if (_e76 < 0f) {
                    phi_939_ = 0f;
                } else {
                    if (_e76 > 1f) {
                        phi_938_ = 1f;
                    } else {
                        phi_938_ = _e76;
                    }
                    let _e83 = phi_938_;
                    phi_939_ = _e83;
                }
                let _e85 = phi_939_;
                phi_940_ = _e85;
            }
            let _e87 = phi_940_;
            phi_1016_ = _e87;
        } else {
            if (_e62 > 0f) {
                if (_e62 < param_10) {
                    let _e90 = lt_math_hausdorff_cubic_mass(_e44, 0f, _e62, param_10, 1f);
                    let _e92 = lt_math_hausdorff_cubic_mass(_e44, _e62, 0f, param_10, 1f);
                    let _e93 = ((1f - _e90) - _e92);
                    if ((bitcast<u32>(_e93) & 2147483647u) > 2139095040u) {
                        phi_969_ = _e93;
                    } else {
                        if (_e93 < 0f) {
                            phi_968_ = 0f;
                        } else {
                            if (_e93 > 1f) {
                                phi_967_ = 1f;
                            } else {
                                phi_967_ = _e93;
                            }
                            let _e100 = phi_967_;
                            phi_968_ = _e100;
                        }
                        let _e102 = phi_968_;
                        phi_969_ = _e102;
                    }
                    let _e104 = phi_969_;
                    phi_970_ = _e104;
                    phi_971_ = false;
                } else {
                    phi_970_ = f32();
                    phi_971_ = true;
                }
                let _e106 = phi_970_;
                let _e108 = phi_971_;
                phi_972_ = _e106;
                phi_973_ = _e108;
            } else {
                phi_972_ = f32();
                phi_973_ = true;
            }
            let _e110 = phi_972_;
            let _e112 = phi_973_;
            if _e112 {
                if (_e62 > param_10) {
                    if (_e62 < 1f) {
                        let _e115 = lt_math_hausdorff_cubic_mass(_e44, 0f, _e62, param_10, 1f);
                        let _e116 = (1f - _e115);
                        if ((bitcast<u32>(_e116) & 2147483647u) > 2139095040u) {
                            phi_1003_ = _e116;
                        } else {
                            if (_e116 < 0f) {
                                phi_1002_ = 0f;
                            } else {
                                if (_e116 > 1f) {
                                    phi_1001_ = 1f;
                                } else {
                                    phi_1001_ = _e116;
                                }
                                let _e123 = phi_1001_;
                                phi_1002_ = _e123;
                            }
                            let _e125 = phi_1002_;
                            phi_1003_ = _e125;
                        }
                        let _e127 = phi_1003_;
                        phi_1004_ = _e127;
                        phi_1005_ = false;
                    } else {
                        phi_1004_ = f32();
                        phi_1005_ = true;
                    }
                    let _e129 = phi_1004_;
                    let _e131 = phi_1005_;
                    phi_1006_ = _e129;
                    phi_1007_ = _e131;
                } else {
                    phi_1006_ = f32();
                    phi_1007_ = true;
                }
                let _e133 = phi_1006_;
                let _e135 = phi_1007_;
                if _e135 {
                    phi_1014_ = bitcast<f32>((bitcast<u32>(_e62) | 2143289344u));
                } else {
                    phi_1014_ = _e133;
                }
                let _e140 = phi_1014_;
                phi_1015_ = _e140;
            } else {
                phi_1015_ = _e110;
            }
            let _e142 = phi_1015_;
            phi_1016_ = _e142;
        }
        let _e144 = phi_1016_;
        phi_1017_ = _e144;
    }
    let _e146 = phi_1017_;
    return _e146;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_11: ptr<function, f32>, param_12: vec4<f32>, param_13: f32) -> f32 {
    var local: hankel_HankelFactors;
    var phi_225_: f32;
    var phi_226_: f32;
    var phi_227_: f32;
    var phi_239_: bool;
    var phi_254_: bool;
    var phi_279_: f32;
    var phi_280_: f32;
    var phi_281_: f32;
    var phi_282_: f32;
    var phi_283_: bool;
    var phi_284_: f32;
    var phi_285_: bool;
    var phi_341_: vec2<f32>;
    var phi_379_: f32;
    var phi_380_: f32;
    var phi_381_: f32;
    var phi_414_: f32;
    var phi_415_: f32;
    var phi_416_: f32;
    var phi_420_: f32;
    var phi_421_: f32;
    var phi_422_: f32;
    var phi_423_: f32;
    var phi_476_: vec2<f32>;
    var phi_498_: bool;
    var phi_523_: f32;
    var phi_524_: f32;
    var phi_525_: f32;
    var phi_526_: f32;
    var phi_527_: bool;
    var phi_528_: f32;
    var phi_529_: bool;
    var phi_585_: vec2<f32>;
    var phi_623_: f32;
    var phi_624_: f32;
    var phi_625_: f32;
    var phi_658_: f32;
    var phi_659_: f32;
    var phi_660_: f32;
    var phi_664_: f32;
    var phi_665_: f32;
    var phi_666_: f32;
    var phi_667_: f32;
    var phi_668_: f32;
    var phi_669_: bool;
    var phi_670_: f32;
    var phi_671_: bool;
    var phi_693_: bool;
    var phi_718_: f32;
    var phi_719_: f32;
    var phi_720_: f32;
    var phi_721_: f32;
    var phi_722_: bool;
    var phi_723_: f32;
    var phi_724_: bool;
    var phi_780_: vec2<f32>;
    var phi_818_: f32;
    var phi_819_: f32;
    var phi_820_: f32;
    var phi_853_: f32;
    var phi_854_: f32;
    var phi_855_: f32;
    var phi_859_: f32;
    var phi_860_: f32;
    var phi_861_: f32;
    var phi_862_: f32;
    var phi_873_: bool;
    var phi_877_: f32;
    var phi_878_: f32;
    var phi_879_: f32;
    var phi_880_: f32;

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
        phi_227_ = param_13;
    } else {
        if (param_13 < 0f) {
            phi_226_ = 0f;
        } else {
            if (param_13 > 1f) {
                phi_225_ = 1f;
            } else {
                phi_225_ = param_13;
            }
            let _e82 = phi_225_;
            phi_226_ = _e82;
        }
        let _e84 = phi_226_;
        phi_227_ = _e84;
    }
    let _e86 = phi_227_;
    let _e89 = local.moments[0u];
    let _e92 = local.moments[3u];
    if (_e89 == _e92) {
        let _e96 = local.moments[0u];
        phi_239_ = (_e96 > 0.5f);
    } else {
        phi_239_ = false;
    }
    let _e99 = phi_239_;
    if _e99 {
        let _e102 = local.moments[0u];
        let _e105 = local.moments[3u];
        if (_e102 == _e105) {
            let _e109 = local.moments[0u];
            phi_254_ = (_e109 > 0.5f);
        } else {
            phi_254_ = false;
        }
        let _e112 = phi_254_;
        if _e112 {
            if (_e86 > 0f) {
                let _e115 = local.moments;
                if ((bitcast<u32>(_e115.x) & 2147483647u) > 2139095040u) {
                    phi_281_ = _e115.x;
                } else {
                    if (_e115.x < 0f) {
                        phi_280_ = 0f;
                    } else {
                        if (_e115.x > 1f) {
                            phi_279_ = 1f;
                        } else {
                            phi_279_ = _e115.x;
                        }
                        let _e123 = phi_279_;
                        phi_280_ = _e123;
                    }
                    let _e125 = phi_280_;
                    phi_281_ = _e125;
                }
                let _e127 = phi_281_;
                phi_282_ = _e127;
                phi_283_ = false;
            } else {
                phi_282_ = f32();
                phi_283_ = true;
            }
            let _e129 = phi_282_;
            let _e131 = phi_283_;
            phi_284_ = _e129;
            phi_285_ = _e131;
        } else {
            phi_284_ = f32();
            phi_285_ = true;
        }
        let _e133 = phi_284_;
        let _e135 = phi_285_;
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
                phi_341_ = vec2<f32>((-(_e174) - _e179), (-(_e174) + _e179));
            } else {
                phi_341_ = vec2(bitcast<f32>((bitcast<u32>(_e177) | 2143289344u)));
            }
            let _e190 = phi_341_;
            if (_e86 <= _e190.x) {
                phi_422_ = 1f;
            } else {
                if (_e86 > _e190.y) {
                    let _e196 = local.moments;
                    let _e207 = (((_e196.y - (_e196.x * (_e190.x + _e190.y))) + (_e190.x * _e190.y)) / ((_e86 - _e190.x) * (_e86 - _e190.y)));
                    if ((bitcast<u32>(_e207) & 2147483647u) > 2139095040u) {
                        phi_381_ = _e207;
                    } else {
                        if (_e207 < 0f) {
                            phi_380_ = 0f;
                        } else {
                            if (_e207 > 1f) {
                                phi_379_ = 1f;
                            } else {
                                phi_379_ = _e207;
                            }
                            let _e214 = phi_379_;
                            phi_380_ = _e214;
                        }
                        let _e216 = phi_380_;
                        phi_381_ = _e216;
                    }
                    let _e218 = phi_381_;
                    phi_421_ = _e218;
                } else {
                    if (_e86 > _e190.x) {
                        let _e221 = local.moments;
                        let _e233 = (1f - (((_e221.y - (_e221.x * (_e86 + _e190.y))) + (_e86 * _e190.y)) / ((_e190.x - _e86) * (_e190.x - _e190.y))));
                        if ((bitcast<u32>(_e233) & 2147483647u) > 2139095040u) {
                            phi_416_ = _e233;
                        } else {
                            if (_e233 < 0f) {
                                phi_415_ = 0f;
                            } else {
                                if (_e233 > 1f) {
                                    phi_414_ = 1f;
                                } else {
                                    phi_414_ = _e233;
                                }
                                let _e240 = phi_414_;
                                phi_415_ = _e240;
                            }
                            let _e242 = phi_415_;
                            phi_416_ = _e242;
                        }
                        let _e244 = phi_416_;
                        phi_420_ = _e244;
                    } else {
                        phi_420_ = bitcast<f32>((bitcast<u32>(_e190.x) | 2143289344u));
                    }
                    let _e249 = phi_420_;
                    phi_421_ = _e249;
                }
                let _e251 = phi_421_;
                phi_422_ = _e251;
            }
            let _e253 = phi_422_;
            phi_423_ = _e253;
        } else {
            phi_423_ = _e133;
        }
        let _e255 = phi_423_;
        phi_880_ = _e255;
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
            phi_476_ = vec2<f32>((-(_e294) - _e299), (-(_e294) + _e299));
        } else {
            phi_476_ = vec2(bitcast<f32>((bitcast<u32>(_e297) | 2143289344u)));
        }
        let _e310 = phi_476_;
        if (_e310.x >= 0f) {
            if (_e310.y <= 1f) {
                let _e317 = local.moments[0u];
                let _e320 = local.moments[3u];
                if (_e317 == _e320) {
                    let _e324 = local.moments[0u];
                    phi_498_ = (_e324 > 0.5f);
                } else {
                    phi_498_ = false;
                }
                let _e327 = phi_498_;
                if _e327 {
                    if (_e86 > 0f) {
                        let _e330 = local.moments;
                        if ((bitcast<u32>(_e330.x) & 2147483647u) > 2139095040u) {
                            phi_525_ = _e330.x;
                        } else {
                            if (_e330.x < 0f) {
                                phi_524_ = 0f;
                            } else {
                                if (_e330.x > 1f) {
                                    phi_523_ = 1f;
                                } else {
                                    phi_523_ = _e330.x;
                                }
                                let _e338 = phi_523_;
                                phi_524_ = _e338;
                            }
                            let _e340 = phi_524_;
                            phi_525_ = _e340;
                        }
                        let _e342 = phi_525_;
                        phi_526_ = _e342;
                        phi_527_ = false;
                    } else {
                        phi_526_ = f32();
                        phi_527_ = true;
                    }
                    let _e344 = phi_526_;
                    let _e346 = phi_527_;
                    phi_528_ = _e344;
                    phi_529_ = _e346;
                } else {
                    phi_528_ = f32();
                    phi_529_ = true;
                }
                let _e348 = phi_528_;
                let _e350 = phi_529_;
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
                        phi_585_ = vec2<f32>((-(_e389) - _e394), (-(_e389) + _e394));
                    } else {
                        phi_585_ = vec2(bitcast<f32>((bitcast<u32>(_e392) | 2143289344u)));
                    }
                    let _e405 = phi_585_;
                    if (_e86 <= _e405.x) {
                        phi_666_ = 1f;
                    } else {
                        if (_e86 > _e405.y) {
                            let _e411 = local.moments;
                            let _e422 = (((_e411.y - (_e411.x * (_e405.x + _e405.y))) + (_e405.x * _e405.y)) / ((_e86 - _e405.x) * (_e86 - _e405.y)));
                            if ((bitcast<u32>(_e422) & 2147483647u) > 2139095040u) {
                                phi_625_ = _e422;
                            } else {
                                if (_e422 < 0f) {
                                    phi_624_ = 0f;
                                } else {
                                    if (_e422 > 1f) {
                                        phi_623_ = 1f;
                                    } else {
                                        phi_623_ = _e422;
                                    }
                                    let _e429 = phi_623_;
                                    phi_624_ = _e429;
                                }
                                let _e431 = phi_624_;
                                phi_625_ = _e431;
                            }
                            let _e433 = phi_625_;
                            phi_665_ = _e433;
                        } else {
                            if (_e86 > _e405.x) {
                                let _e436 = local.moments;
                                let _e448 = (1f - (((_e436.y - (_e436.x * (_e86 + _e405.y))) + (_e86 * _e405.y)) / ((_e405.x - _e86) * (_e405.x - _e405.y))));
                                if ((bitcast<u32>(_e448) & 2147483647u) > 2139095040u) {
                                    phi_660_ = _e448;
                                } else {
                                    if (_e448 < 0f) {
                                        phi_659_ = 0f;
                                    } else {
                                        if (_e448 > 1f) {
                                            phi_658_ = 1f;
                                        } else {
                                            phi_658_ = _e448;
                                        }
                                        let _e455 = phi_658_;
                                        phi_659_ = _e455;
                                    }
                                    let _e457 = phi_659_;
                                    phi_660_ = _e457;
                                }
                                let _e459 = phi_660_;
                                phi_664_ = _e459;
                            } else {
                                phi_664_ = bitcast<f32>((bitcast<u32>(_e405.x) | 2143289344u));
                            }
                            let _e464 = phi_664_;
                            phi_665_ = _e464;
                        }
                        let _e466 = phi_665_;
                        phi_666_ = _e466;
                    }
                    let _e468 = phi_666_;
                    phi_667_ = _e468;
                } else {
                    phi_667_ = _e348;
                }
                let _e470 = phi_667_;
                phi_668_ = _e470;
                phi_669_ = false;
            } else {
                phi_668_ = f32();
                phi_669_ = true;
            }
            let _e472 = phi_668_;
            let _e474 = phi_669_;
            phi_670_ = _e472;
            phi_671_ = _e474;
        } else {
            phi_670_ = f32();
            phi_671_ = true;
        }
        let _e476 = phi_670_;
        let _e478 = phi_671_;
        if _e478 {
            if ((bitcast<u32>(_e310.x) & 2147483647u) > 2139095040u) {
                phi_878_ = _e310.x;
            } else {
                let _e482 = lt_math_hausdorff_endpoint_upper_bound((&local), _e86);
                let _e485 = local.moments[0u];
                let _e488 = local.moments[3u];
                if (_e485 == _e488) {
                    let _e492 = local.moments[0u];
                    phi_693_ = (_e492 > 0.5f);
                } else {
                    phi_693_ = false;
                }
                let _e495 = phi_693_;
                if _e495 {
                    if (_e86 > 0f) {
                        let _e498 = local.moments;
                        if ((bitcast<u32>(_e498.x) & 2147483647u) > 2139095040u) {
                            phi_720_ = _e498.x;
                        } else {
                            if (_e498.x < 0f) {
                                phi_719_ = 0f;
                            } else {
                                if (_e498.x > 1f) {
                                    phi_718_ = 1f;
                                } else {
                                    phi_718_ = _e498.x;
                                }
                                let _e506 = phi_718_;
                                phi_719_ = _e506;
                            }
                            let _e508 = phi_719_;
                            phi_720_ = _e508;
                        }
                        let _e510 = phi_720_;
                        phi_721_ = _e510;
                        phi_722_ = false;
                    } else {
                        phi_721_ = f32();
                        phi_722_ = true;
                    }
                    let _e512 = phi_721_;
                    let _e514 = phi_722_;
                    phi_723_ = _e512;
                    phi_724_ = _e514;
                } else {
                    phi_723_ = f32();
                    phi_724_ = true;
                }
                let _e516 = phi_723_;
                let _e518 = phi_724_;
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
                        phi_780_ = vec2<f32>((-(_e557) - _e562), (-(_e557) + _e562));
                    } else {
                        phi_780_ = vec2(bitcast<f32>((bitcast<u32>(_e560) | 2143289344u)));
                    }
                    let _e573 = phi_780_;
                    if (_e86 <= _e573.x) {
                        phi_861_ = 1f;
                    } else {
                        if (_e86 > _e573.y) {
                            let _e579 = local.moments;
                            let _e590 = (((_e579.y - (_e579.x * (_e573.x + _e573.y))) + (_e573.x * _e573.y)) / ((_e86 - _e573.x) * (_e86 - _e573.y)));
                            if ((bitcast<u32>(_e590) & 2147483647u) > 2139095040u) {
                                phi_820_ = _e590;
                            } else {
                                if (_e590 < 0f) {
                                    phi_819_ = 0f;
                                } else {
                                    if (_e590 > 1f) {
                                        phi_818_ = 1f;
                                    } else {
                                        phi_818_ = _e590;
                                    }
                                    let _e597 = phi_818_;
                                    phi_819_ = _e597;
                                }
                                let _e599 = phi_819_;
                                phi_820_ = _e599;
                            }
                            let _e601 = phi_820_;
                            phi_860_ = _e601;
                        } else {
                            if (_e86 > _e573.x) {
                                let _e604 = local.moments;
                                let _e616 = (1f - (((_e604.y - (_e604.x * (_e86 + _e573.y))) + (_e86 * _e573.y)) / ((_e573.x - _e86) * (_e573.x - _e573.y))));
                                if ((bitcast<u32>(_e616) & 2147483647u) > 2139095040u) {
                                    phi_855_ = _e616;
                                } else {
                                    if (_e616 < 0f) {
                                        phi_854_ = 0f;
                                    } else {
                                        if (_e616 > 1f) {
                                            phi_853_ = 1f;
                                        } else {
                                            phi_853_ = _e616;
                                        }
                                        let _e623 = phi_853_;
                                        phi_854_ = _e623;
                                    }
                                    let _e625 = phi_854_;
                                    phi_855_ = _e625;
                                }
                                let _e627 = phi_855_;
                                phi_859_ = _e627;
                            } else {
                                phi_859_ = bitcast<f32>((bitcast<u32>(_e573.x) | 2143289344u));
                            }
                            let _e632 = phi_859_;
                            phi_860_ = _e632;
                        }
                        let _e634 = phi_860_;
                        phi_861_ = _e634;
                    }
                    let _e636 = phi_861_;
                    phi_862_ = _e636;
                } else {
                    phi_862_ = _e516;
                }
                let _e638 = phi_862_;
                if ((bitcast<u32>(_e638) & 2147483647u) > 2139095040u) {
                    phi_873_ = true;
                } else {
                    let _e642 = (_e638 < _e482);
                    if _e642 {
                    }
                    phi_873_ = _e642;
                }
                let _e644 = phi_873_;
                if _e644 {
                    phi_877_ = _e638;
                } else {
                    phi_877_ = _e482;
                }
                let _e646 = phi_877_;
                phi_878_ = _e646;
            }
            let _e648 = phi_878_;
            phi_879_ = _e648;
        } else {
            phi_879_ = _e476;
        }
        let _e650 = phi_879_;
        phi_880_ = _e650;
    }
    let _e652 = phi_880_;
    return _e652;
}

fn function_() {
    var local_1: f32;
    var phi_1106_: bool;
    var phi_1107_: bool;
    var phi_1108_: bool;
    var phi_1109_: bool;
    var phi_1113_: bool;
    var phi_1183_: bool;
    var phi_1184_: bool;
    var phi_1195_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1196_: bool;
    var phi_1197_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1198_: bool;
    var phi_1205_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1209_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1229_: lt_math_LightPoint;
    var phi_1232_: u32;
    var phi_1234_: lt_math_LevelPoint;
    var phi_1320_: bool;
    var phi_1329_: bool;
    var phi_1338_: bool;
    var phi_1339_: bool;
    var phi_1340_: bool;
    var phi_1341_: bool;
    var phi_1342_: bool;
    var phi_1343_: bool;
    var phi_1344_: bool;
    var phi_1348_: bool;
    var phi_1375_: bool;
    var phi_1376_: bool;
    var phi_1377_: bool;
    var phi_1378_: bool;
    var phi_1379_: bool;
    var phi_1380_: bool;
    var phi_1381_: bool;
    var phi_1382_: bool;
    var phi_1386_: bool;
    var phi_1395_: lt_math_LightPoint;
    var phi_1396_: u32;
    var phi_1397_: lt_math_LevelPoint;
    var phi_1398_: bool;
    var phi_1230_: lt_math_LightPoint;
    var phi_1233_: u32;
    var phi_1235_: lt_math_LevelPoint;
    var phi_1399_: bool;
    var local_2: lt_math_LevelPoint;
    var local_3: lt_math_LevelPoint;
    var phi_1439_: bool;
    var phi_1440_: bool;
    var phi_1441_: bool;
    var phi_1442_: bool;
    var phi_1446_: bool;
    var phi_1528_: f32;
    var phi_1644_: f32;
    var phi_1645_: f32;
    var phi_1648_: f32;
    var phi_1677_: f32;
    var phi_1682_: f32;
    var phi_1683_: bool;
    var phi_1684_: f32;
    var phi_1685_: bool;
    var phi_1689_: f32;
    var phi_1709_: f32;
    var phi_1714_: f32;
    var phi_1715_: bool;
    var phi_1716_: f32;
    var phi_1717_: bool;
    var phi_1721_: f32;
    var local_4: lt_math_LevelPoint;
    var phi_1770_: i32;
    var phi_1775_: i32;
    var phi_1780_: i32;
    var phi_1785_: i32;
    var phi_1794_: i32;
    var phi_1799_: i32;
    var phi_1804_: i32;
    var phi_1809_: i32;
    var phi_1904_: bool;
    var phi_1912_: bool;
    var phi_1924_: bool;
    var phi_1925_: bool;
    var phi_1929_: f32;
    var phi_1935_: f32;
    var phi_1937_: evaluate_Verdict;
    var phi_1942_: evaluate_Verdict;
    var phi_1943_: evaluate_Verdict;

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
        let _e74 = samples.member[(0u + _e61.first_primitive)].normal[0u];
        let _e76 = global[0u];
        if (_e74 == _e76) {
            let _e79 = samples.member[(0u + _e61.first_primitive)].normal[1u];
            let _e81 = global[1u];
            if (_e79 == _e81) {
                let _e84 = samples.member[(0u + _e61.first_primitive)].normal[2u];
                let _e86 = global[2u];
                phi_1106_ = (_e84 == _e86);
                phi_1107_ = false;
            } else {
                phi_1106_ = bool();
                phi_1107_ = true;
            }
            let _e89 = phi_1106_;
            let _e91 = phi_1107_;
            phi_1108_ = _e89;
            phi_1109_ = _e91;
        } else {
            phi_1108_ = bool();
            phi_1109_ = true;
        }
        let _e93 = phi_1108_;
        let _e95 = phi_1109_;
        if _e95 {
            phi_1113_ = false;
        } else {
            phi_1113_ = _e93;
        }
        let _e97 = phi_1113_;
        if !(_e97) {
            let _e100 = samples.member[(0u + _e61.first_primitive)].position;
            let _e102 = p.member.light.place;
            let _e108 = p.member.light.place[3u];
            let _e115 = (_e102.x - (_e100.x * _e108));
            let _e116 = (_e102.y - (_e100.y * _e108));
            let _e117 = (_e102.z - (_e100.z * _e108));
            let _e119 = samples.member[(0u + _e61.first_primitive)].normal;
            if ((((_e119.x * _e115) + (_e119.y * _e116)) + (_e119.z * _e117)) > 0f) {
                let _e133 = (((_e115 * _e115) + (_e116 * _e116)) + (_e117 * _e117));
                let _e135 = p.member.light.axis;
                let _e147 = p.member.light.place[3u];
                if (_e147 == 0f) {
                    phi_1184_ = true;
                } else {
                    let _e150 = p.member.light.range_squared;
                    if (_e133 <= _e150) {
                        let _e153 = p.member.light.cos_outer;
                        phi_1183_ = (-((((_e115 * _e135.x) + (_e116 * _e135.y)) + (_e117 * _e135.z))) >= (_e153 * sqrt(_e133)));
                    } else {
                        phi_1183_ = false;
                    }
                    let _e158 = phi_1183_;
                    phi_1184_ = _e158;
                }
                let _e160 = phi_1184_;
                if _e160 {
                    let _e162 = samples.member[(0u + _e61.first_primitive)].flags;
                    let _e170 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e176 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e170.unnamed.visibility, false), _e170.unnamed_1);
                    phi_1195_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e176.unnamed, ((_e162 & 1u) == 0u));
                    phi_1196_ = false;
                } else {
                    phi_1195_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_1196_ = true;
                }
                let _e181 = phi_1195_;
                let _e183 = phi_1196_;
                phi_1197_ = _e181;
                phi_1198_ = _e183;
            } else {
                phi_1197_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_1198_ = true;
            }
            let _e185 = phi_1197_;
            let _e187 = phi_1198_;
            if _e187 {
                let _e193 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e199 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e193.unnamed.visibility, false), _e193.unnamed_1);
                phi_1205_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e199.unnamed, true);
            } else {
                phi_1205_ = _e185;
            }
            let _e204 = phi_1205_;
            phi_1209_ = _e204;
        } else {
            let _e210 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e216 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e210.unnamed.visibility, false), _e210.unnamed_1);
            phi_1209_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e216.unnamed, true);
        }
        let _e221 = phi_1209_;
        if _e221.unnamed_1 {
            phi_1943_ = evaluate_Verdict(_e221.unnamed.visibility, _e221.unnamed.is_doubted);
        } else {
            let _e229 = samples.member[(0u + _e61.first_primitive)].position;
            let _e231 = p.member.map_size;
            let _e233 = (0.5f / f32(_e231));
            let _e240 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e247 = lt_math_LightPoint(vec2<f32>(_e240.uv.x, 0f), _e240.depth, _e240.is_inside);
            let _e251 = lt_math_LightPoint(_e247.uv, 0f, _e247.is_inside);
            phi_1229_ = lt_math_LightPoint();
            phi_1232_ = 0u;
            phi_1234_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e251.uv, _e251.depth, false));
            loop {
                let _e258 = phi_1229_;
                let _e260 = phi_1232_;
                let _e262 = phi_1234_;
                local_2 = _e262;
                local_3 = _e262;
                local_4 = _e262;
                if (_e260 < _e67) {
                    if _e262.point.is_inside {
                        phi_1395_ = lt_math_LightPoint();
                        phi_1396_ = u32();
                        phi_1397_ = lt_math_LevelPoint();
                        phi_1398_ = false;
                    } else {
                        if (_e260 < _e55) {
                        } else {
                            return;
                        }
                        let _e273 = levels.member[(0u + _e260)].row_w;
                        let _e284 = ((((_e273.x * _e229.x) + (_e273.y * _e229.y)) + (_e273.z * _e229.z)) + (_e273.w * 1f));
                        let _e286 = levels.member[(0u + _e260)].row_x;
                        let _e298 = (((((_e286.x * _e229.x) + (_e286.y * _e229.y)) + (_e286.z * _e229.z)) + (_e286.w * 1f)) / _e284);
                        let _e300 = levels.member[(0u + _e260)].row_y;
                        let _e312 = (((((_e300.x * _e229.x) + (_e300.y * _e229.y)) + (_e300.z * _e229.z)) + (_e300.w * 1f)) / _e284);
                        let _e314 = levels.member[(0u + _e260)].row_z;
                        let _e325 = ((((_e314.x * _e229.x) + (_e314.y * _e229.y)) + (_e314.z * _e229.z)) + (_e314.w * 1f));
                        if (_e284 > 0f) {
                            if (_e298 >= 0f) {
                                phi_1320_ = (_e298 <= 1f);
                            } else {
                                phi_1320_ = false;
                            }
                            let _e330 = phi_1320_;
                            if _e330 {
                                if (_e312 >= 0f) {
                                    phi_1329_ = (_e312 <= 1f);
                                } else {
                                    phi_1329_ = false;
                                }
                                let _e334 = phi_1329_;
                                if _e334 {
                                    if (_e325 >= 0f) {
                                        phi_1338_ = (_e325 <= 1f);
                                    } else {
                                        phi_1338_ = false;
                                    }
                                    let _e338 = phi_1338_;
                                    phi_1339_ = _e338;
                                    phi_1340_ = false;
                                } else {
                                    phi_1339_ = bool();
                                    phi_1340_ = true;
                                }
                                let _e340 = phi_1339_;
                                let _e342 = phi_1340_;
                                phi_1341_ = _e340;
                                phi_1342_ = _e342;
                            } else {
                                phi_1341_ = bool();
                                phi_1342_ = true;
                            }
                            let _e344 = phi_1341_;
                            let _e346 = phi_1342_;
                            phi_1343_ = _e344;
                            phi_1344_ = _e346;
                        } else {
                            phi_1343_ = bool();
                            phi_1344_ = true;
                        }
                        let _e348 = phi_1343_;
                        let _e350 = phi_1344_;
                        if _e350 {
                            phi_1348_ = false;
                        } else {
                            phi_1348_ = _e348;
                        }
                        let _e352 = phi_1348_;
                        if _e352 {
                            if (_e298 >= _e233) {
                                if (_e298 <= (1f - _e233)) {
                                    if (_e312 >= _e233) {
                                        phi_1375_ = (_e312 <= (1f - _e233));
                                        phi_1376_ = false;
                                    } else {
                                        phi_1375_ = bool();
                                        phi_1376_ = true;
                                    }
                                    let _e360 = phi_1375_;
                                    let _e362 = phi_1376_;
                                    phi_1377_ = _e360;
                                    phi_1378_ = _e362;
                                } else {
                                    phi_1377_ = bool();
                                    phi_1378_ = true;
                                }
                                let _e364 = phi_1377_;
                                let _e366 = phi_1378_;
                                phi_1379_ = _e364;
                                phi_1380_ = _e366;
                            } else {
                                phi_1379_ = bool();
                                phi_1380_ = true;
                            }
                            let _e368 = phi_1379_;
                            let _e370 = phi_1380_;
                            phi_1381_ = _e368;
                            phi_1382_ = _e370;
                        } else {
                            phi_1381_ = bool();
                            phi_1382_ = true;
                        }
                        let _e372 = phi_1381_;
                        let _e374 = phi_1382_;
                        if _e374 {
                            phi_1386_ = false;
                        } else {
                            phi_1386_ = _e372;
                        }
                        let _e376 = phi_1386_;
                        let _e383 = lt_math_LightPoint(vec2<f32>(_e298, _e258.uv.y), _e258.depth, _e258.is_inside);
                        let _e390 = lt_math_LightPoint(vec2<f32>(_e383.uv.x, _e312), _e383.depth, _e383.is_inside);
                        let _e394 = lt_math_LightPoint(_e390.uv, _e325, _e390.is_inside);
                        let _e398 = lt_math_LightPoint(_e394.uv, _e394.depth, _e376);
                        phi_1395_ = _e398;
                        phi_1396_ = (_e260 + 1u);
                        phi_1397_ = lt_math_LevelPoint(_e260, _e398);
                        phi_1398_ = true;
                    }
                    let _e402 = phi_1395_;
                    let _e404 = phi_1396_;
                    let _e406 = phi_1397_;
                    let _e408 = phi_1398_;
                    phi_1230_ = _e402;
                    phi_1233_ = _e404;
                    phi_1235_ = _e406;
                    phi_1399_ = _e408;
                } else {
                    phi_1230_ = lt_math_LightPoint();
                    phi_1233_ = u32();
                    phi_1235_ = lt_math_LevelPoint();
                    phi_1399_ = false;
                }
                let _e410 = phi_1230_;
                let _e412 = phi_1233_;
                let _e414 = phi_1235_;
                let _e416 = phi_1399_;
                continue;
                continuing {
                    phi_1229_ = _e410;
                    phi_1232_ = _e412;
                    phi_1234_ = _e414;
                    break if !(_e416);
                }
            }
            let _e419 = local_2;
            if _e419.point.is_inside {
                if (0f > 0f) {
                    let _e425 = local_3;
                    if (_e425.level < _e55) {
                    } else {
                        return;
                    }
                    let _e430 = levels.member[(0u + _e425.level)];
                    let _e436 = global[0u];
                    if (_e430.row_w.x == _e436) {
                        let _e439 = global[1u];
                        if (_e430.row_w.y == _e439) {
                            let _e442 = global[2u];
                            phi_1439_ = (_e430.row_w.z == _e442);
                            phi_1440_ = false;
                        } else {
                            phi_1439_ = bool();
                            phi_1440_ = true;
                        }
                        let _e445 = phi_1439_;
                        let _e447 = phi_1440_;
                        phi_1441_ = _e445;
                        phi_1442_ = _e447;
                    } else {
                        phi_1441_ = bool();
                        phi_1442_ = true;
                    }
                    let _e449 = phi_1441_;
                    let _e451 = phi_1442_;
                    if _e451 {
                        phi_1446_ = false;
                    } else {
                        phi_1446_ = _e449;
                    }
                    let _e453 = phi_1446_;
                    if _e453 {
                        let _e455 = samples.member[(0u + _e61.first_primitive)].normal;
                        let _e457 = p.member.map_size;
                        let _e527 = ((abs(((((_e430.row_x.x * _e455.x) + (_e430.row_x.y * _e455.y)) + (_e430.row_x.z * _e455.z)) / (((_e430.row_x.x * _e430.row_x.x) + (_e430.row_x.y * _e430.row_x.y)) + (_e430.row_x.z * _e430.row_x.z)))) + abs(((((_e430.row_y.x * _e455.x) + (_e430.row_y.y * _e455.y)) + (_e430.row_y.z * _e455.z)) / (((_e430.row_y.x * _e430.row_y.x) + (_e430.row_y.y * _e430.row_y.y)) + (_e430.row_y.z * _e430.row_y.z))))) / (abs(((((_e430.row_z.x * _e455.x) + (_e430.row_z.y * _e455.y)) + (_e430.row_z.z * _e455.z)) / (((_e430.row_z.x * _e430.row_z.x) + (_e430.row_z.y * _e430.row_z.y)) + (_e430.row_z.z * _e430.row_z.z)))) * f32(_e457)));
                        if (_e527 < 0.002f) {
                            phi_1528_ = _e527;
                        } else {
                            phi_1528_ = 0.002f;
                        }
                        let _e530 = phi_1528_;
                        phi_1645_ = _e530;
                    } else {
                        let _e532 = p.member.map_size;
                        let _e538 = samples.member[(0u + _e61.first_primitive)].position;
                        let _e549 = ((((_e430.row_w.x * _e538.x) + (_e430.row_w.y * _e538.y)) + (_e430.row_w.z * _e538.z)) + _e430.row_w.w);
                        let _e562 = ((_e430.row_x.x - (_e430.row_w.x * _e419.point.uv.x)) / _e549);
                        let _e563 = ((_e430.row_x.y - (_e430.row_w.y * _e419.point.uv.x)) / _e549);
                        let _e564 = ((_e430.row_x.z - (_e430.row_w.z * _e419.point.uv.x)) / _e549);
                        let _e577 = ((_e430.row_y.x - (_e430.row_w.x * _e419.point.uv.y)) / _e549);
                        let _e578 = ((_e430.row_y.y - (_e430.row_w.y * _e419.point.uv.y)) / _e549);
                        let _e579 = ((_e430.row_y.z - (_e430.row_w.z * _e419.point.uv.y)) / _e549);
                        let _e585 = samples.member[(0u + _e61.first_primitive)].normal;
                        let _e590 = ((_e578 * _e585.z) - (_e585.y * _e579));
                        let _e595 = ((_e579 * _e585.x) - (_e585.z * _e577));
                        let _e600 = ((_e577 * _e585.y) - (_e585.x * _e578));
                        let _e602 = samples.member[(0u + _e61.first_primitive)].normal;
                        let _e607 = ((_e563 * _e602.z) - (_e602.y * _e564));
                        let _e612 = ((_e564 * _e602.x) - (_e602.z * _e562));
                        let _e617 = ((_e562 * _e602.y) - (_e602.x * _e563));
                        let _e644 = ((abs(((((_e430.row_z.x * _e590) + (_e430.row_z.y * _e595)) + (_e430.row_z.z * _e600)) / (((_e562 * _e590) + (_e563 * _e595)) + (_e564 * _e600)))) + abs(((((_e430.row_z.x * _e607) + (_e430.row_z.y * _e612)) + (_e430.row_z.z * _e617)) / (((_e577 * _e607) + (_e578 * _e612)) + (_e579 * _e617))))) / f32(_e532));
                        if (_e644 < 0.002f) {
                            phi_1644_ = _e644;
                        } else {
                            phi_1644_ = 0.002f;
                        }
                        let _e647 = phi_1644_;
                        phi_1645_ = _e647;
                    }
                    let _e649 = phi_1645_;
                    phi_1648_ = (_e419.point.depth - (0f * _e649));
                } else {
                    phi_1648_ = _e419.point.depth;
                }
                let _e653 = phi_1648_;
                let _e659 = p.member.map_size;
                let _e660 = f32(_e659);
                let _e663 = ((_e419.point.uv.x * _e660) - 0.5f);
                let _e664 = ((_e419.point.uv.y * _e660) - 0.5f);
                if (_e663 > -8388608f) {
                    let _e676 = f32(select(0i, select(select(i32(_e663), i32(-2147483648), (_e663 < bitcast<f32>(3472883712u))), 2147483647i, (_e663 > bitcast<f32>(1325400063u))), (_e663 == _e663)));
                    if (_e676 > _e663) {
                        phi_1677_ = 1f;
                    } else {
                        phi_1677_ = 0f;
                    }
                    let _e679 = phi_1677_;
                    if (_e663 < 8388608f) {
                        phi_1682_ = (_e676 - _e679);
                        phi_1683_ = false;
                    } else {
                        phi_1682_ = f32();
                        phi_1683_ = true;
                    }
                    let _e682 = phi_1682_;
                    let _e684 = phi_1683_;
                    phi_1684_ = _e682;
                    phi_1685_ = _e684;
                } else {
                    phi_1684_ = f32();
                    phi_1685_ = true;
                }
                let _e686 = phi_1684_;
                let _e688 = phi_1685_;
                if _e688 {
                    phi_1689_ = _e663;
                } else {
                    phi_1689_ = _e686;
                }
                let _e690 = phi_1689_;
                if (_e664 > -8388608f) {
                    let _e702 = f32(select(0i, select(select(i32(_e664), i32(-2147483648), (_e664 < bitcast<f32>(3472883712u))), 2147483647i, (_e664 > bitcast<f32>(1325400063u))), (_e664 == _e664)));
                    if (_e702 > _e664) {
                        phi_1709_ = 1f;
                    } else {
                        phi_1709_ = 0f;
                    }
                    let _e705 = phi_1709_;
                    if (_e664 < 8388608f) {
                        phi_1714_ = (_e702 - _e705);
                        phi_1715_ = false;
                    } else {
                        phi_1714_ = f32();
                        phi_1715_ = true;
                    }
                    let _e708 = phi_1714_;
                    let _e710 = phi_1715_;
                    phi_1716_ = _e708;
                    phi_1717_ = _e710;
                } else {
                    phi_1716_ = f32();
                    phi_1717_ = true;
                }
                let _e712 = phi_1716_;
                let _e714 = phi_1717_;
                if _e714 {
                    phi_1721_ = _e664;
                } else {
                    phi_1721_ = _e712;
                }
                let _e716 = phi_1721_;
                let _e717 = (_e663 - _e690);
                let _e718 = (_e664 - _e716);
                let _e727 = select(0i, select(select(i32(_e690), i32(-2147483648), (_e690 < bitcast<f32>(3472883712u))), 2147483647i, (_e690 > bitcast<f32>(1325400063u))), (_e690 == _e690));
                let _e736 = select(0i, select(select(i32(_e716), i32(-2147483648), (_e716 < bitcast<f32>(3472883712u))), 2147483647i, (_e716 > bitcast<f32>(1325400063u))), (_e716 == _e716));
                let _e739 = ((1f - _e717) * (1f - _e718));
                let _e741 = (_e717 * (1f - _e718));
                let _e743 = ((1f - _e717) * _e718);
                let _e744 = (_e717 * _e718);
                let _e746 = p.member.test;
                let _e747 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e746);
                let _e749 = p.member.map_size;
                let _e751 = local_4;
                local_1 = _e747;
                let _e754 = ((_e751.level * _e749) * _e749);
                let _e756 = (bitcast<i32>(_e749) - 1i);
                if (_e727 > 0i) {
                    phi_1770_ = _e727;
                } else {
                    phi_1770_ = 0i;
                }
                let _e759 = phi_1770_;
                if (_e736 > 0i) {
                    phi_1775_ = _e736;
                } else {
                    phi_1775_ = 0i;
                }
                let _e762 = phi_1775_;
                if (_e759 < _e756) {
                    phi_1780_ = _e759;
                } else {
                    phi_1780_ = _e756;
                }
                let _e765 = phi_1780_;
                if (_e762 < _e756) {
                    phi_1785_ = _e762;
                } else {
                    phi_1785_ = _e756;
                }
                let _e768 = phi_1785_;
                let _e769 = bitcast<u32>(_e765);
                let _e771 = (_e727 + 1i);
                let _e772 = (_e736 + 1i);
                if (_e771 > 0i) {
                    phi_1794_ = _e771;
                } else {
                    phi_1794_ = 0i;
                }
                let _e775 = phi_1794_;
                if (_e772 > 0i) {
                    phi_1799_ = _e772;
                } else {
                    phi_1799_ = 0i;
                }
                let _e778 = phi_1799_;
                if (_e775 < _e756) {
                    phi_1804_ = _e775;
                } else {
                    phi_1804_ = _e756;
                }
                let _e781 = phi_1804_;
                if (_e778 < _e756) {
                    phi_1809_ = _e778;
                } else {
                    phi_1809_ = _e756;
                }
                let _e784 = phi_1809_;
                let _e785 = bitcast<u32>(_e781);
                let _e787 = (bitcast<u32>(_e768) * _e749);
                let _e788 = (bitcast<u32>(_e784) * _e749);
                let _e793 = ((_e787 + _e769) + _e754);
                let _e794 = ((_e787 + _e785) + _e754);
                let _e795 = ((_e788 + _e769) + _e754);
                let _e796 = ((_e788 + _e785) + _e754);
                if (_e793 < _e49) {
                } else {
                    return;
                }
                let _e800 = map.member[(0u + _e793)];
                if (_e794 < _e49) {
                } else {
                    return;
                }
                let _e812 = map.member[(0u + _e794)];
                if (_e795 < _e49) {
                } else {
                    return;
                }
                let _e828 = map.member[(0u + _e795)];
                if (_e796 < _e49) {
                } else {
                    return;
                }
                let _e844 = map.member[(0u + _e796)];
                let _e858 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_1), vec4<f32>(((((_e800.x * _e739) + (_e812.x * _e741)) + (_e828.x * _e743)) + (_e844.x * _e744)), ((((_e800.y * _e739) + (_e812.y * _e741)) + (_e828.y * _e743)) + (_e844.y * _e744)), ((((_e800.z * _e739) + (_e812.z * _e741)) + (_e828.z * _e743)) + (_e844.z * _e744)), ((((_e800.w * _e739) + (_e812.w * _e741)) + (_e828.w * _e743)) + (_e844.w * _e744))), _e653);
                let _e860 = p.member.epsilon;
                if (_e858 <= _e860) {
                    phi_1904_ = true;
                } else {
                    phi_1904_ = (_e858 >= (1f - _e860));
                }
                let _e865 = phi_1904_;
                if ((bitcast<u32>(_e858) & 2147483647u) > 2139095040u) {
                    phi_1912_ = true;
                } else {
                    phi_1912_ = !(_e865);
                }
                let _e871 = phi_1912_;
                if _e871 {
                    if (_e858 > 0f) {
                        if (_e858 < 1f) {
                            phi_1924_ = false;
                        } else {
                            phi_1924_ = true;
                        }
                        let _e875 = phi_1924_;
                        phi_1925_ = _e875;
                    } else {
                        phi_1925_ = true;
                    }
                    let _e877 = phi_1925_;
                    if _e877 {
                        phi_1929_ = 0.5f;
                    } else {
                        phi_1929_ = _e858;
                    }
                    let _e879 = phi_1929_;
                    phi_1937_ = evaluate_Verdict(_e879, true);
                } else {
                    if (_e858 > 0.5f) {
                        phi_1935_ = 1f;
                    } else {
                        phi_1935_ = 0f;
                    }
                    let _e883 = phi_1935_;
                    phi_1937_ = evaluate_Verdict(_e883, false);
                }
                let _e886 = phi_1937_;
                phi_1942_ = evaluate_Verdict(_e886.visibility, _e886.is_doubted);
            } else {
                phi_1942_ = evaluate_Verdict(0.5f, true);
            }
            let _e892 = phi_1942_;
            phi_1943_ = _e892;
        }
        let _e894 = phi_1943_;
        if (_e61.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e61.first_primitive)] = _e894.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_msm_hausdorff_prefiltered_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
