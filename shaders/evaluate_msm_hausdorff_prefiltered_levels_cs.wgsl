struct abi_LightParams {
    place: vec4<f32>,
    axis: vec3<f32>,
    cos_outer: f32,
    range_squared: f32,
    cos_inner: f32,
    number: u32,
    mask_words: u32,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
}

struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_15 {
    member: array<abi_Sample>,
}

struct type_19 {
    member: array<f32>,
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

struct type_39 {
    member: array<lt_math_LightProjection>,
}

struct lt_math_LightPoint {
    uv: vec2<f32>,
    depth: f32,
    is_inside: bool,
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
var<storage> samples: type_15;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_35;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_19;
@group(0) @binding(4) 
var<storage> levels: type_39;
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
        let _e55 = phi_160_;
        let _e57 = phi_161_;
        phi_162_ = _e55;
        phi_163_ = _e57;
    } else {
        phi_162_ = lt_bvh_traverse_Tree();
        phi_163_ = true;
    }
    let _e59 = phi_162_;
    let _e61 = phi_163_;
    if _e61 {
        phi_168_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_168_ = _e59;
    }
    let _e66 = phi_168_;
    return lt_bvh_traverse_Tree(_e66.root, _e66.first_primitive);
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

    let _e45 = (*param_9).moments;
    if (param_10 < 0.0001f) {
        phi_1017_ = 1f;
    } else {
        let _e54 = ((_e45.z - ((1f + param_10) * _e45.y)) + (param_10 * _e45.x));
        let _e63 = (((_e45.w - ((1f + param_10) * _e45.z)) + (param_10 * _e45.y)) / _e54);
        if (abs(_e54) <= 0.00000047683716f) {
            let _e77 = (1f - (((_e45.y - (_e45.x * (param_10 + 1f))) + (param_10 * 1f)) / ((0f - param_10) * (0f - 1f))));
            if ((bitcast<u32>(_e77) & 2147483647u) > 2139095040u) {
                phi_940_ = _e77;
            } else {
                if (_e77 < 0f) {
                    phi_939_ = 0f;
                } else {
                    if (_e77 > 1f) {
                        phi_938_ = 1f;
                    } else {
                        phi_938_ = _e77;
                    }
                    let _e84 = phi_938_;
                    phi_939_ = _e84;
                }
                let _e86 = phi_939_;
                phi_940_ = _e86;
            }
            let _e88 = phi_940_;
            phi_1016_ = _e88;
        } else {
            if (_e63 > 0f) {
                if (_e63 < param_10) {
                    let _e91 = lt_math_hausdorff_cubic_mass(_e45, 0f, _e63, param_10, 1f);
                    let _e93 = lt_math_hausdorff_cubic_mass(_e45, _e63, 0f, param_10, 1f);
                    let _e94 = ((1f - _e91) - _e93);
                    if ((bitcast<u32>(_e94) & 2147483647u) > 2139095040u) {
                        phi_969_ = _e94;
                    } else {
                        if (_e94 < 0f) {
                            phi_968_ = 0f;
                        } else {
                            if (_e94 > 1f) {
                                phi_967_ = 1f;
                            } else {
                                phi_967_ = _e94;
                            }
                            let _e101 = phi_967_;
                            phi_968_ = _e101;
                        }
                        let _e103 = phi_968_;
                        phi_969_ = _e103;
                    }
                    let _e105 = phi_969_;
                    phi_970_ = _e105;
                    phi_971_ = false;
                } else {
                    phi_970_ = f32();
                    phi_971_ = true;
                }
                let _e107 = phi_970_;
                let _e109 = phi_971_;
                phi_972_ = _e107;
                phi_973_ = _e109;
            } else {
                phi_972_ = f32();
                phi_973_ = true;
            }
            let _e111 = phi_972_;
            let _e113 = phi_973_;
            if _e113 {
                if (_e63 > param_10) {
                    if (_e63 < 1f) {
                        let _e116 = lt_math_hausdorff_cubic_mass(_e45, 0f, _e63, param_10, 1f);
                        let _e117 = (1f - _e116);
                        if ((bitcast<u32>(_e117) & 2147483647u) > 2139095040u) {
                            phi_1003_ = _e117;
                        } else {
                            if (_e117 < 0f) {
                                phi_1002_ = 0f;
                            } else {
                                if (_e117 > 1f) {
                                    phi_1001_ = 1f;
                                } else {
                                    phi_1001_ = _e117;
                                }
                                let _e124 = phi_1001_;
                                phi_1002_ = _e124;
                            }
                            let _e126 = phi_1002_;
                            phi_1003_ = _e126;
                        }
                        let _e128 = phi_1003_;
                        phi_1004_ = _e128;
                        phi_1005_ = false;
                    } else {
                        phi_1004_ = f32();
                        phi_1005_ = true;
                    }
                    let _e130 = phi_1004_;
                    let _e132 = phi_1005_;
                    phi_1006_ = _e130;
                    phi_1007_ = _e132;
                } else {
                    phi_1006_ = f32();
                    phi_1007_ = true;
                }
                let _e134 = phi_1006_;
                let _e136 = phi_1007_;
                if _e136 {
                    phi_1014_ = bitcast<f32>((bitcast<u32>(_e63) | 2143289344u));
                } else {
                    phi_1014_ = _e134;
                }
                let _e141 = phi_1014_;
                phi_1015_ = _e141;
            } else {
                phi_1015_ = _e111;
            }
            let _e143 = phi_1015_;
            phi_1016_ = _e143;
        }
        let _e145 = phi_1016_;
        phi_1017_ = _e145;
    }
    let _e147 = phi_1017_;
    return _e147;
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

    let _e46 = (*param_11);
    let _e47 = (1f - _e46);
    let _e56 = (0.5f * _e46);
    let _e57 = ((param_12.x * _e47) + _e56);
    let _e58 = ((param_12.y * _e47) + _e56);
    let _e59 = ((param_12.z * _e47) + _e56);
    let _e60 = ((param_12.w * _e47) + _e56);
    let _e63 = (_e58 - (_e57 * _e57));
    let _e65 = (_e59 - (_e57 * _e58));
    let _e71 = hankel_HankelFactors(vec4<f32>(_e57, _e58, _e59, _e60), _e63, _e65, (((_e60 - (_e58 * _e58)) * _e63) - (_e65 * _e65)));
    local = hankel_HankelFactors(_e71.moments, _e71.d22_, _e71.l32_d22_, _e71.d33_d22_);
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
            let _e83 = phi_225_;
            phi_226_ = _e83;
        }
        let _e85 = phi_226_;
        phi_227_ = _e85;
    }
    let _e87 = phi_227_;
    let _e90 = local.moments[0u];
    let _e93 = local.moments[3u];
    if (_e90 == _e93) {
        let _e97 = local.moments[0u];
        phi_239_ = (_e97 > 0.5f);
    } else {
        phi_239_ = false;
    }
    let _e100 = phi_239_;
    if _e100 {
        let _e103 = local.moments[0u];
        let _e106 = local.moments[3u];
        if (_e103 == _e106) {
            let _e110 = local.moments[0u];
            phi_254_ = (_e110 > 0.5f);
        } else {
            phi_254_ = false;
        }
        let _e113 = phi_254_;
        if _e113 {
            if (_e87 > 0f) {
                let _e116 = local.moments;
                if ((bitcast<u32>(_e116.x) & 2147483647u) > 2139095040u) {
                    phi_281_ = _e116.x;
                } else {
                    if (_e116.x < 0f) {
                        phi_280_ = 0f;
                    } else {
                        if (_e116.x > 1f) {
                            phi_279_ = 1f;
                        } else {
                            phi_279_ = _e116.x;
                        }
                        let _e124 = phi_279_;
                        phi_280_ = _e124;
                    }
                    let _e126 = phi_280_;
                    phi_281_ = _e126;
                }
                let _e128 = phi_281_;
                phi_282_ = _e128;
                phi_283_ = false;
            } else {
                phi_282_ = f32();
                phi_283_ = true;
            }
            let _e130 = phi_282_;
            let _e132 = phi_283_;
            phi_284_ = _e130;
            phi_285_ = _e132;
        } else {
            phi_284_ = f32();
            phi_285_ = true;
        }
        let _e134 = phi_284_;
        let _e136 = phi_285_;
        if _e136 {
            let _e139 = local.moments[0u];
            let _e142 = local.moments[1u];
            let _e150 = local.l32_d22_;
            let _e152 = local.d22_;
            let _e153 = (_e150 / _e152);
            let _e154 = (_e87 - _e139);
            let _e160 = local.d22_;
            let _e163 = local.d33_d22_;
            let _e164 = (((((_e87 * _e87) - _e142) - (_e153 * _e154)) * _e160) / _e163);
            let _e166 = local.d22_;
            let _e169 = ((_e154 / _e166) - (_e153 * _e164));
            let _e175 = ((0.5f * _e169) / _e164);
            let _e178 = ((_e175 * _e175) - (((1f - (_e169 * _e139)) - (_e164 * _e142)) / _e164));
            if (_e178 >= 0f) {
                let _e180 = sqrt(_e178);
                phi_341_ = vec2<f32>((-(_e175) - _e180), (-(_e175) + _e180));
            } else {
                phi_341_ = vec2(bitcast<f32>((bitcast<u32>(_e178) | 2143289344u)));
            }
            let _e191 = phi_341_;
            if (_e87 <= _e191.x) {
                phi_422_ = 1f;
            } else {
                if (_e87 > _e191.y) {
                    let _e197 = local.moments;
                    let _e208 = (((_e197.y - (_e197.x * (_e191.x + _e191.y))) + (_e191.x * _e191.y)) / ((_e87 - _e191.x) * (_e87 - _e191.y)));
                    if ((bitcast<u32>(_e208) & 2147483647u) > 2139095040u) {
                        phi_381_ = _e208;
                    } else {
                        if (_e208 < 0f) {
                            phi_380_ = 0f;
                        } else {
                            if (_e208 > 1f) {
                                phi_379_ = 1f;
                            } else {
                                phi_379_ = _e208;
                            }
                            let _e215 = phi_379_;
                            phi_380_ = _e215;
                        }
                        let _e217 = phi_380_;
                        phi_381_ = _e217;
                    }
                    let _e219 = phi_381_;
                    phi_421_ = _e219;
                } else {
                    if (_e87 > _e191.x) {
                        let _e222 = local.moments;
                        let _e234 = (1f - (((_e222.y - (_e222.x * (_e87 + _e191.y))) + (_e87 * _e191.y)) / ((_e191.x - _e87) * (_e191.x - _e191.y))));
                        if ((bitcast<u32>(_e234) & 2147483647u) > 2139095040u) {
                            phi_416_ = _e234;
                        } else {
                            if (_e234 < 0f) {
                                phi_415_ = 0f;
                            } else {
                                if (_e234 > 1f) {
                                    phi_414_ = 1f;
                                } else {
                                    phi_414_ = _e234;
                                }
                                let _e241 = phi_414_;
                                phi_415_ = _e241;
                            }
                            let _e243 = phi_415_;
                            phi_416_ = _e243;
                        }
                        let _e245 = phi_416_;
                        phi_420_ = _e245;
                    } else {
                        phi_420_ = bitcast<f32>((bitcast<u32>(_e191.x) | 2143289344u));
                    }
                    let _e250 = phi_420_;
                    phi_421_ = _e250;
                }
                let _e252 = phi_421_;
                phi_422_ = _e252;
            }
            let _e254 = phi_422_;
            phi_423_ = _e254;
        } else {
            phi_423_ = _e134;
        }
        let _e256 = phi_423_;
        phi_880_ = _e256;
    } else {
        let _e259 = local.moments[0u];
        let _e262 = local.moments[1u];
        let _e270 = local.l32_d22_;
        let _e272 = local.d22_;
        let _e273 = (_e270 / _e272);
        let _e274 = (_e87 - _e259);
        let _e280 = local.d22_;
        let _e283 = local.d33_d22_;
        let _e284 = (((((_e87 * _e87) - _e262) - (_e273 * _e274)) * _e280) / _e283);
        let _e286 = local.d22_;
        let _e289 = ((_e274 / _e286) - (_e273 * _e284));
        let _e295 = ((0.5f * _e289) / _e284);
        let _e298 = ((_e295 * _e295) - (((1f - (_e289 * _e259)) - (_e284 * _e262)) / _e284));
        if (_e298 >= 0f) {
            let _e300 = sqrt(_e298);
            phi_476_ = vec2<f32>((-(_e295) - _e300), (-(_e295) + _e300));
        } else {
            phi_476_ = vec2(bitcast<f32>((bitcast<u32>(_e298) | 2143289344u)));
        }
        let _e311 = phi_476_;
        if (_e311.x >= 0f) {
            if (_e311.y <= 1f) {
                let _e318 = local.moments[0u];
                let _e321 = local.moments[3u];
                if (_e318 == _e321) {
                    let _e325 = local.moments[0u];
                    phi_498_ = (_e325 > 0.5f);
                } else {
                    phi_498_ = false;
                }
                let _e328 = phi_498_;
                if _e328 {
                    if (_e87 > 0f) {
                        let _e331 = local.moments;
                        if ((bitcast<u32>(_e331.x) & 2147483647u) > 2139095040u) {
                            phi_525_ = _e331.x;
                        } else {
                            if (_e331.x < 0f) {
                                phi_524_ = 0f;
                            } else {
                                if (_e331.x > 1f) {
                                    phi_523_ = 1f;
                                } else {
                                    phi_523_ = _e331.x;
                                }
                                let _e339 = phi_523_;
                                phi_524_ = _e339;
                            }
                            let _e341 = phi_524_;
                            phi_525_ = _e341;
                        }
                        let _e343 = phi_525_;
                        phi_526_ = _e343;
                        phi_527_ = false;
                    } else {
                        phi_526_ = f32();
                        phi_527_ = true;
                    }
                    let _e345 = phi_526_;
                    let _e347 = phi_527_;
                    phi_528_ = _e345;
                    phi_529_ = _e347;
                } else {
                    phi_528_ = f32();
                    phi_529_ = true;
                }
                let _e349 = phi_528_;
                let _e351 = phi_529_;
                if _e351 {
                    let _e354 = local.moments[0u];
                    let _e357 = local.moments[1u];
                    let _e365 = local.l32_d22_;
                    let _e367 = local.d22_;
                    let _e368 = (_e365 / _e367);
                    let _e369 = (_e87 - _e354);
                    let _e375 = local.d22_;
                    let _e378 = local.d33_d22_;
                    let _e379 = (((((_e87 * _e87) - _e357) - (_e368 * _e369)) * _e375) / _e378);
                    let _e381 = local.d22_;
                    let _e384 = ((_e369 / _e381) - (_e368 * _e379));
                    let _e390 = ((0.5f * _e384) / _e379);
                    let _e393 = ((_e390 * _e390) - (((1f - (_e384 * _e354)) - (_e379 * _e357)) / _e379));
                    if (_e393 >= 0f) {
                        let _e395 = sqrt(_e393);
                        phi_585_ = vec2<f32>((-(_e390) - _e395), (-(_e390) + _e395));
                    } else {
                        phi_585_ = vec2(bitcast<f32>((bitcast<u32>(_e393) | 2143289344u)));
                    }
                    let _e406 = phi_585_;
                    if (_e87 <= _e406.x) {
                        phi_666_ = 1f;
                    } else {
                        if (_e87 > _e406.y) {
                            let _e412 = local.moments;
                            let _e423 = (((_e412.y - (_e412.x * (_e406.x + _e406.y))) + (_e406.x * _e406.y)) / ((_e87 - _e406.x) * (_e87 - _e406.y)));
                            if ((bitcast<u32>(_e423) & 2147483647u) > 2139095040u) {
                                phi_625_ = _e423;
                            } else {
                                if (_e423 < 0f) {
                                    phi_624_ = 0f;
                                } else {
                                    if (_e423 > 1f) {
                                        phi_623_ = 1f;
                                    } else {
                                        phi_623_ = _e423;
                                    }
                                    let _e430 = phi_623_;
                                    phi_624_ = _e430;
                                }
                                let _e432 = phi_624_;
                                phi_625_ = _e432;
                            }
                            let _e434 = phi_625_;
                            phi_665_ = _e434;
                        } else {
                            if (_e87 > _e406.x) {
                                let _e437 = local.moments;
                                let _e449 = (1f - (((_e437.y - (_e437.x * (_e87 + _e406.y))) + (_e87 * _e406.y)) / ((_e406.x - _e87) * (_e406.x - _e406.y))));
                                if ((bitcast<u32>(_e449) & 2147483647u) > 2139095040u) {
                                    phi_660_ = _e449;
                                } else {
                                    if (_e449 < 0f) {
                                        phi_659_ = 0f;
                                    } else {
                                        if (_e449 > 1f) {
                                            phi_658_ = 1f;
                                        } else {
                                            phi_658_ = _e449;
                                        }
                                        let _e456 = phi_658_;
                                        phi_659_ = _e456;
                                    }
                                    let _e458 = phi_659_;
                                    phi_660_ = _e458;
                                }
                                let _e460 = phi_660_;
                                phi_664_ = _e460;
                            } else {
                                phi_664_ = bitcast<f32>((bitcast<u32>(_e406.x) | 2143289344u));
                            }
                            let _e465 = phi_664_;
                            phi_665_ = _e465;
                        }
                        let _e467 = phi_665_;
                        phi_666_ = _e467;
                    }
                    let _e469 = phi_666_;
                    phi_667_ = _e469;
                } else {
                    phi_667_ = _e349;
                }
                let _e471 = phi_667_;
                phi_668_ = _e471;
                phi_669_ = false;
            } else {
                phi_668_ = f32();
                phi_669_ = true;
            }
            let _e473 = phi_668_;
            let _e475 = phi_669_;
            phi_670_ = _e473;
            phi_671_ = _e475;
        } else {
            phi_670_ = f32();
            phi_671_ = true;
        }
        let _e477 = phi_670_;
        let _e479 = phi_671_;
        if _e479 {
            if ((bitcast<u32>(_e311.x) & 2147483647u) > 2139095040u) {
                phi_878_ = _e311.x;
            } else {
                let _e483 = lt_math_hausdorff_endpoint_upper_bound((&local), _e87);
                let _e486 = local.moments[0u];
                let _e489 = local.moments[3u];
                if (_e486 == _e489) {
                    let _e493 = local.moments[0u];
                    phi_693_ = (_e493 > 0.5f);
                } else {
                    phi_693_ = false;
                }
                let _e496 = phi_693_;
                if _e496 {
                    if (_e87 > 0f) {
                        let _e499 = local.moments;
                        if ((bitcast<u32>(_e499.x) & 2147483647u) > 2139095040u) {
                            phi_720_ = _e499.x;
                        } else {
                            if (_e499.x < 0f) {
                                phi_719_ = 0f;
                            } else {
                                if (_e499.x > 1f) {
                                    phi_718_ = 1f;
                                } else {
                                    phi_718_ = _e499.x;
                                }
                                let _e507 = phi_718_;
                                phi_719_ = _e507;
                            }
                            let _e509 = phi_719_;
                            phi_720_ = _e509;
                        }
                        let _e511 = phi_720_;
                        phi_721_ = _e511;
                        phi_722_ = false;
                    } else {
                        phi_721_ = f32();
                        phi_722_ = true;
                    }
                    let _e513 = phi_721_;
                    let _e515 = phi_722_;
                    phi_723_ = _e513;
                    phi_724_ = _e515;
                } else {
                    phi_723_ = f32();
                    phi_724_ = true;
                }
                let _e517 = phi_723_;
                let _e519 = phi_724_;
                if _e519 {
                    let _e522 = local.moments[0u];
                    let _e525 = local.moments[1u];
                    let _e533 = local.l32_d22_;
                    let _e535 = local.d22_;
                    let _e536 = (_e533 / _e535);
                    let _e537 = (_e87 - _e522);
                    let _e543 = local.d22_;
                    let _e546 = local.d33_d22_;
                    let _e547 = (((((_e87 * _e87) - _e525) - (_e536 * _e537)) * _e543) / _e546);
                    let _e549 = local.d22_;
                    let _e552 = ((_e537 / _e549) - (_e536 * _e547));
                    let _e558 = ((0.5f * _e552) / _e547);
                    let _e561 = ((_e558 * _e558) - (((1f - (_e552 * _e522)) - (_e547 * _e525)) / _e547));
                    if (_e561 >= 0f) {
                        let _e563 = sqrt(_e561);
                        phi_780_ = vec2<f32>((-(_e558) - _e563), (-(_e558) + _e563));
                    } else {
                        phi_780_ = vec2(bitcast<f32>((bitcast<u32>(_e561) | 2143289344u)));
                    }
                    let _e574 = phi_780_;
                    if (_e87 <= _e574.x) {
                        phi_861_ = 1f;
                    } else {
                        if (_e87 > _e574.y) {
                            let _e580 = local.moments;
                            let _e591 = (((_e580.y - (_e580.x * (_e574.x + _e574.y))) + (_e574.x * _e574.y)) / ((_e87 - _e574.x) * (_e87 - _e574.y)));
                            if ((bitcast<u32>(_e591) & 2147483647u) > 2139095040u) {
                                phi_820_ = _e591;
                            } else {
                                if (_e591 < 0f) {
                                    phi_819_ = 0f;
                                } else {
                                    if (_e591 > 1f) {
                                        phi_818_ = 1f;
                                    } else {
                                        phi_818_ = _e591;
                                    }
                                    let _e598 = phi_818_;
                                    phi_819_ = _e598;
                                }
                                let _e600 = phi_819_;
                                phi_820_ = _e600;
                            }
                            let _e602 = phi_820_;
                            phi_860_ = _e602;
                        } else {
                            if (_e87 > _e574.x) {
                                let _e605 = local.moments;
                                let _e617 = (1f - (((_e605.y - (_e605.x * (_e87 + _e574.y))) + (_e87 * _e574.y)) / ((_e574.x - _e87) * (_e574.x - _e574.y))));
                                if ((bitcast<u32>(_e617) & 2147483647u) > 2139095040u) {
                                    phi_855_ = _e617;
                                } else {
                                    if (_e617 < 0f) {
                                        phi_854_ = 0f;
                                    } else {
                                        if (_e617 > 1f) {
                                            phi_853_ = 1f;
                                        } else {
                                            phi_853_ = _e617;
                                        }
                                        let _e624 = phi_853_;
                                        phi_854_ = _e624;
                                    }
                                    let _e626 = phi_854_;
                                    phi_855_ = _e626;
                                }
                                let _e628 = phi_855_;
                                phi_859_ = _e628;
                            } else {
                                phi_859_ = bitcast<f32>((bitcast<u32>(_e574.x) | 2143289344u));
                            }
                            let _e633 = phi_859_;
                            phi_860_ = _e633;
                        }
                        let _e635 = phi_860_;
                        phi_861_ = _e635;
                    }
                    let _e637 = phi_861_;
                    phi_862_ = _e637;
                } else {
                    phi_862_ = _e517;
                }
                let _e639 = phi_862_;
                if ((bitcast<u32>(_e639) & 2147483647u) > 2139095040u) {
                    phi_873_ = true;
                } else {
                    let _e643 = (_e639 < _e483);
                    if _e643 {
                    }
                    phi_873_ = _e643;
                }
                let _e645 = phi_873_;
                if _e645 {
                    phi_877_ = _e639;
                } else {
                    phi_877_ = _e483;
                }
                let _e647 = phi_877_;
                phi_878_ = _e647;
            }
            let _e649 = phi_878_;
            phi_879_ = _e649;
        } else {
            phi_879_ = _e477;
        }
        let _e651 = phi_879_;
        phi_880_ = _e651;
    }
    let _e653 = phi_880_;
    return _e653;
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
    var phi_1646_: f32;
    var phi_1647_: f32;
    var phi_1650_: f32;
    var phi_1679_: f32;
    var phi_1684_: f32;
    var phi_1685_: bool;
    var phi_1686_: f32;
    var phi_1687_: bool;
    var phi_1691_: f32;
    var phi_1711_: f32;
    var phi_1716_: f32;
    var phi_1717_: bool;
    var phi_1718_: f32;
    var phi_1719_: bool;
    var phi_1723_: f32;
    var local_4: lt_math_LevelPoint;
    var phi_1772_: i32;
    var phi_1777_: i32;
    var phi_1782_: i32;
    var phi_1787_: i32;
    var phi_1796_: i32;
    var phi_1801_: i32;
    var phi_1806_: i32;
    var phi_1811_: i32;
    var phi_1900_: evaluate_Verdict;
    var phi_1901_: evaluate_Verdict;
    var phi_1902_: bool;
    var phi_1903_: evaluate_Verdict;
    var phi_1904_: evaluate_Verdict;
    var phi_1905_: bool;
    var phi_1909_: evaluate_Verdict;

    let _e43 = id_1;
    let _e50 = arrayLength((&map.member));
    let _e56 = arrayLength((&levels.member));
    let _e59 = p.member.size[0u];
    let _e61 = p.member.size[1u];
    let _e62 = lt_shaders_entry_pixel_index(_e43, _e59, _e61);
    if (bitcast<i32>(_e62.root) != 0i) {
        let _e68 = p.member.level_count;
        if (_e62.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e75 = samples.member[(0u + _e62.first_primitive)].normal[0u];
        let _e77 = global[0u];
        if (_e75 == _e77) {
            let _e80 = samples.member[(0u + _e62.first_primitive)].normal[1u];
            let _e82 = global[1u];
            if (_e80 == _e82) {
                let _e85 = samples.member[(0u + _e62.first_primitive)].normal[2u];
                let _e87 = global[2u];
                phi_1106_ = (_e85 == _e87);
                phi_1107_ = false;
            } else {
                phi_1106_ = bool();
                phi_1107_ = true;
            }
            let _e90 = phi_1106_;
            let _e92 = phi_1107_;
            phi_1108_ = _e90;
            phi_1109_ = _e92;
        } else {
            phi_1108_ = bool();
            phi_1109_ = true;
        }
        let _e94 = phi_1108_;
        let _e96 = phi_1109_;
        if _e96 {
            phi_1113_ = false;
        } else {
            phi_1113_ = _e94;
        }
        let _e98 = phi_1113_;
        if !(_e98) {
            let _e101 = samples.member[(0u + _e62.first_primitive)].position;
            let _e103 = p.member.light.place;
            let _e109 = p.member.light.place[3u];
            let _e116 = (_e103.x - (_e101.x * _e109));
            let _e117 = (_e103.y - (_e101.y * _e109));
            let _e118 = (_e103.z - (_e101.z * _e109));
            let _e120 = samples.member[(0u + _e62.first_primitive)].normal;
            if ((((_e120.x * _e116) + (_e120.y * _e117)) + (_e120.z * _e118)) > 0f) {
                let _e134 = (((_e116 * _e116) + (_e117 * _e117)) + (_e118 * _e118));
                let _e136 = p.member.light.axis;
                let _e148 = p.member.light.place[3u];
                if (_e148 == 0f) {
                    phi_1184_ = true;
                } else {
                    let _e151 = p.member.light.range_squared;
                    if (_e134 <= _e151) {
                        let _e154 = p.member.light.cos_outer;
                        phi_1183_ = (-((((_e116 * _e136.x) + (_e117 * _e136.y)) + (_e118 * _e136.z))) >= (_e154 * sqrt(_e134)));
                    } else {
                        phi_1183_ = false;
                    }
                    let _e159 = phi_1183_;
                    phi_1184_ = _e159;
                }
                let _e161 = phi_1184_;
                if _e161 {
                    let _e163 = samples.member[(0u + _e62.first_primitive)].flags;
                    let _e171 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e177 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e171.unnamed.visibility, false), _e171.unnamed_1);
                    phi_1195_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e177.unnamed, ((_e163 & 1u) == 0u));
                    phi_1196_ = false;
                } else {
                    phi_1195_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_1196_ = true;
                }
                let _e182 = phi_1195_;
                let _e184 = phi_1196_;
                phi_1197_ = _e182;
                phi_1198_ = _e184;
            } else {
                phi_1197_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_1198_ = true;
            }
            let _e186 = phi_1197_;
            let _e188 = phi_1198_;
            if _e188 {
                let _e194 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e200 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e194.unnamed.visibility, false), _e194.unnamed_1);
                phi_1205_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e200.unnamed, true);
            } else {
                phi_1205_ = _e186;
            }
            let _e205 = phi_1205_;
            phi_1209_ = _e205;
        } else {
            let _e211 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e217 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e211.unnamed.visibility, false), _e211.unnamed_1);
            phi_1209_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e217.unnamed, true);
        }
        let _e222 = phi_1209_;
        if _e222.unnamed_1 {
            phi_1903_ = evaluate_Verdict(_e222.unnamed.visibility, _e222.unnamed.is_doubted);
            phi_1904_ = evaluate_Verdict();
            phi_1905_ = true;
        } else {
            let _e230 = samples.member[(0u + _e62.first_primitive)].position;
            let _e232 = p.member.map_size;
            let _e234 = (0.5f / f32(_e232));
            let _e241 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e248 = lt_math_LightPoint(vec2<f32>(_e241.uv.x, 0f), _e241.depth, _e241.is_inside);
            let _e252 = lt_math_LightPoint(_e248.uv, 0f, _e248.is_inside);
            phi_1229_ = lt_math_LightPoint();
            phi_1232_ = 0u;
            phi_1234_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e252.uv, _e252.depth, false));
            loop {
                let _e259 = phi_1229_;
                let _e261 = phi_1232_;
                let _e263 = phi_1234_;
                local_2 = _e263;
                local_3 = _e263;
                local_4 = _e263;
                if (_e261 < _e68) {
                    if _e263.point.is_inside {
                        phi_1395_ = lt_math_LightPoint();
                        phi_1396_ = u32();
                        phi_1397_ = lt_math_LevelPoint();
                        phi_1398_ = false;
                    } else {
                        if (_e261 < _e56) {
                        } else {
                            return;
                        }
                        let _e274 = levels.member[(0u + _e261)].row_w;
                        let _e285 = ((((_e274.x * _e230.x) + (_e274.y * _e230.y)) + (_e274.z * _e230.z)) + (_e274.w * 1f));
                        let _e287 = levels.member[(0u + _e261)].row_x;
                        let _e299 = (((((_e287.x * _e230.x) + (_e287.y * _e230.y)) + (_e287.z * _e230.z)) + (_e287.w * 1f)) / _e285);
                        let _e301 = levels.member[(0u + _e261)].row_y;
                        let _e313 = (((((_e301.x * _e230.x) + (_e301.y * _e230.y)) + (_e301.z * _e230.z)) + (_e301.w * 1f)) / _e285);
                        let _e315 = levels.member[(0u + _e261)].row_z;
                        let _e326 = ((((_e315.x * _e230.x) + (_e315.y * _e230.y)) + (_e315.z * _e230.z)) + (_e315.w * 1f));
                        if (_e285 > 0f) {
                            if (_e299 >= 0f) {
                                phi_1320_ = (_e299 <= 1f);
                            } else {
                                phi_1320_ = false;
                            }
                            let _e331 = phi_1320_;
                            if _e331 {
                                if (_e313 >= 0f) {
                                    phi_1329_ = (_e313 <= 1f);
                                } else {
                                    phi_1329_ = false;
                                }
                                let _e335 = phi_1329_;
                                if _e335 {
                                    if (_e326 >= 0f) {
                                        phi_1338_ = (_e326 <= 1f);
                                    } else {
                                        phi_1338_ = false;
                                    }
                                    let _e339 = phi_1338_;
                                    phi_1339_ = _e339;
                                    phi_1340_ = false;
                                } else {
                                    phi_1339_ = bool();
                                    phi_1340_ = true;
                                }
                                let _e341 = phi_1339_;
                                let _e343 = phi_1340_;
                                phi_1341_ = _e341;
                                phi_1342_ = _e343;
                            } else {
                                phi_1341_ = bool();
                                phi_1342_ = true;
                            }
                            let _e345 = phi_1341_;
                            let _e347 = phi_1342_;
                            phi_1343_ = _e345;
                            phi_1344_ = _e347;
                        } else {
                            phi_1343_ = bool();
                            phi_1344_ = true;
                        }
                        let _e349 = phi_1343_;
                        let _e351 = phi_1344_;
                        if _e351 {
                            phi_1348_ = false;
                        } else {
                            phi_1348_ = _e349;
                        }
                        let _e353 = phi_1348_;
                        if _e353 {
                            if (_e299 >= _e234) {
                                if (_e299 <= (1f - _e234)) {
                                    if (_e313 >= _e234) {
                                        phi_1375_ = (_e313 <= (1f - _e234));
                                        phi_1376_ = false;
                                    } else {
                                        phi_1375_ = bool();
                                        phi_1376_ = true;
                                    }
                                    let _e361 = phi_1375_;
                                    let _e363 = phi_1376_;
                                    phi_1377_ = _e361;
                                    phi_1378_ = _e363;
                                } else {
                                    phi_1377_ = bool();
                                    phi_1378_ = true;
                                }
                                let _e365 = phi_1377_;
                                let _e367 = phi_1378_;
                                phi_1379_ = _e365;
                                phi_1380_ = _e367;
                            } else {
                                phi_1379_ = bool();
                                phi_1380_ = true;
                            }
                            let _e369 = phi_1379_;
                            let _e371 = phi_1380_;
                            phi_1381_ = _e369;
                            phi_1382_ = _e371;
                        } else {
                            phi_1381_ = bool();
                            phi_1382_ = true;
                        }
                        let _e373 = phi_1381_;
                        let _e375 = phi_1382_;
                        if _e375 {
                            phi_1386_ = false;
                        } else {
                            phi_1386_ = _e373;
                        }
                        let _e377 = phi_1386_;
                        let _e384 = lt_math_LightPoint(vec2<f32>(_e299, _e259.uv.y), _e259.depth, _e259.is_inside);
                        let _e391 = lt_math_LightPoint(vec2<f32>(_e384.uv.x, _e313), _e384.depth, _e384.is_inside);
                        let _e395 = lt_math_LightPoint(_e391.uv, _e326, _e391.is_inside);
                        let _e399 = lt_math_LightPoint(_e395.uv, _e395.depth, _e377);
                        phi_1395_ = _e399;
                        phi_1396_ = (_e261 + 1u);
                        phi_1397_ = lt_math_LevelPoint(_e261, _e399);
                        phi_1398_ = true;
                    }
                    let _e403 = phi_1395_;
                    let _e405 = phi_1396_;
                    let _e407 = phi_1397_;
                    let _e409 = phi_1398_;
                    phi_1230_ = _e403;
                    phi_1233_ = _e405;
                    phi_1235_ = _e407;
                    phi_1399_ = _e409;
                } else {
                    phi_1230_ = lt_math_LightPoint();
                    phi_1233_ = u32();
                    phi_1235_ = lt_math_LevelPoint();
                    phi_1399_ = false;
                }
                let _e411 = phi_1230_;
                let _e413 = phi_1233_;
                let _e415 = phi_1235_;
                let _e417 = phi_1399_;
                continue;
                continuing {
                    phi_1229_ = _e411;
                    phi_1232_ = _e413;
                    phi_1234_ = _e415;
                    break if !(_e417);
                }
            }
            let _e420 = local_2;
            if _e420.point.is_inside {
                if (0f > 0f) {
                    let _e426 = local_3;
                    if (_e426.level < _e56) {
                    } else {
                        return;
                    }
                    let _e431 = levels.member[(0u + _e426.level)];
                    let _e437 = global[0u];
                    if (_e431.row_w.x == _e437) {
                        let _e440 = global[1u];
                        if (_e431.row_w.y == _e440) {
                            let _e443 = global[2u];
                            phi_1439_ = (_e431.row_w.z == _e443);
                            phi_1440_ = false;
                        } else {
                            phi_1439_ = bool();
                            phi_1440_ = true;
                        }
                        let _e446 = phi_1439_;
                        let _e448 = phi_1440_;
                        phi_1441_ = _e446;
                        phi_1442_ = _e448;
                    } else {
                        phi_1441_ = bool();
                        phi_1442_ = true;
                    }
                    let _e450 = phi_1441_;
                    let _e452 = phi_1442_;
                    if _e452 {
                        phi_1446_ = false;
                    } else {
                        phi_1446_ = _e450;
                    }
                    let _e454 = phi_1446_;
                    if _e454 {
                        let _e456 = samples.member[(0u + _e62.first_primitive)].normal;
                        let _e458 = p.member.map_size;
                        let _e528 = ((abs(((((_e431.row_x.x * _e456.x) + (_e431.row_x.y * _e456.y)) + (_e431.row_x.z * _e456.z)) / (((_e431.row_x.x * _e431.row_x.x) + (_e431.row_x.y * _e431.row_x.y)) + (_e431.row_x.z * _e431.row_x.z)))) + abs(((((_e431.row_y.x * _e456.x) + (_e431.row_y.y * _e456.y)) + (_e431.row_y.z * _e456.z)) / (((_e431.row_y.x * _e431.row_y.x) + (_e431.row_y.y * _e431.row_y.y)) + (_e431.row_y.z * _e431.row_y.z))))) / (abs(((((_e431.row_z.x * _e456.x) + (_e431.row_z.y * _e456.y)) + (_e431.row_z.z * _e456.z)) / (((_e431.row_z.x * _e431.row_z.x) + (_e431.row_z.y * _e431.row_z.y)) + (_e431.row_z.z * _e431.row_z.z)))) * f32(_e458)));
                        if (_e528 < 0.002f) {
                            phi_1528_ = _e528;
                        } else {
                            phi_1528_ = 0.002f;
                        }
                        let _e531 = phi_1528_;
                        phi_1647_ = _e531;
                    } else {
                        let _e533 = p.member.map_size;
                        let _e539 = samples.member[(0u + _e62.first_primitive)].position;
                        let _e550 = ((((_e431.row_w.x * _e539.x) + (_e431.row_w.y * _e539.y)) + (_e431.row_w.z * _e539.z)) + _e431.row_w.w);
                        let _e563 = ((_e431.row_x.x - (_e431.row_w.x * _e420.point.uv.x)) / _e550);
                        let _e564 = ((_e431.row_x.y - (_e431.row_w.y * _e420.point.uv.x)) / _e550);
                        let _e565 = ((_e431.row_x.z - (_e431.row_w.z * _e420.point.uv.x)) / _e550);
                        let _e578 = ((_e431.row_y.x - (_e431.row_w.x * _e420.point.uv.y)) / _e550);
                        let _e579 = ((_e431.row_y.y - (_e431.row_w.y * _e420.point.uv.y)) / _e550);
                        let _e580 = ((_e431.row_y.z - (_e431.row_w.z * _e420.point.uv.y)) / _e550);
                        let _e586 = samples.member[(0u + _e62.first_primitive)].normal;
                        let _e591 = ((_e579 * _e586.z) - (_e586.y * _e580));
                        let _e596 = ((_e580 * _e586.x) - (_e586.z * _e578));
                        let _e601 = ((_e578 * _e586.y) - (_e586.x * _e579));
                        let _e603 = samples.member[(0u + _e62.first_primitive)].normal;
                        let _e608 = ((_e564 * _e603.z) - (_e603.y * _e565));
                        let _e613 = ((_e565 * _e603.x) - (_e603.z * _e563));
                        let _e618 = ((_e563 * _e603.y) - (_e603.x * _e564));
                        let _e645 = ((abs(((((_e431.row_z.x * _e591) + (_e431.row_z.y * _e596)) + (_e431.row_z.z * _e601)) / (((_e563 * _e591) + (_e564 * _e596)) + (_e565 * _e601)))) + abs(((((_e431.row_z.x * _e608) + (_e431.row_z.y * _e613)) + (_e431.row_z.z * _e618)) / (((_e578 * _e608) + (_e579 * _e613)) + (_e580 * _e618))))) / f32(_e533));
                        let _e647 = (16f / f32(_e533));
                        if (_e645 < _e647) {
                            phi_1646_ = _e645;
                        } else {
                            phi_1646_ = _e647;
                        }
                        let _e650 = phi_1646_;
                        phi_1647_ = _e650;
                    }
                    let _e652 = phi_1647_;
                    phi_1650_ = (_e420.point.depth - (0f * _e652));
                } else {
                    phi_1650_ = _e420.point.depth;
                }
                let _e656 = phi_1650_;
                let _e662 = p.member.map_size;
                let _e663 = f32(_e662);
                let _e666 = ((_e420.point.uv.x * _e663) - 0.5f);
                let _e667 = ((_e420.point.uv.y * _e663) - 0.5f);
                if (_e666 > -8388608f) {
                    let _e679 = f32(select(0i, select(select(i32(_e666), i32(-2147483648), (_e666 < bitcast<f32>(3472883712u))), 2147483647i, (_e666 > bitcast<f32>(1325400063u))), (_e666 == _e666)));
                    if (_e679 > _e666) {
                        phi_1679_ = 1f;
                    } else {
                        phi_1679_ = 0f;
                    }
                    let _e682 = phi_1679_;
                    if (_e666 < 8388608f) {
                        phi_1684_ = (_e679 - _e682);
                        phi_1685_ = false;
                    } else {
                        phi_1684_ = f32();
                        phi_1685_ = true;
                    }
                    let _e685 = phi_1684_;
                    let _e687 = phi_1685_;
                    phi_1686_ = _e685;
                    phi_1687_ = _e687;
                } else {
                    phi_1686_ = f32();
                    phi_1687_ = true;
                }
                let _e689 = phi_1686_;
                let _e691 = phi_1687_;
                if _e691 {
                    phi_1691_ = _e666;
                } else {
                    phi_1691_ = _e689;
                }
                let _e693 = phi_1691_;
                if (_e667 > -8388608f) {
                    let _e705 = f32(select(0i, select(select(i32(_e667), i32(-2147483648), (_e667 < bitcast<f32>(3472883712u))), 2147483647i, (_e667 > bitcast<f32>(1325400063u))), (_e667 == _e667)));
                    if (_e705 > _e667) {
                        phi_1711_ = 1f;
                    } else {
                        phi_1711_ = 0f;
                    }
                    let _e708 = phi_1711_;
                    if (_e667 < 8388608f) {
                        phi_1716_ = (_e705 - _e708);
                        phi_1717_ = false;
                    } else {
                        phi_1716_ = f32();
                        phi_1717_ = true;
                    }
                    let _e711 = phi_1716_;
                    let _e713 = phi_1717_;
                    phi_1718_ = _e711;
                    phi_1719_ = _e713;
                } else {
                    phi_1718_ = f32();
                    phi_1719_ = true;
                }
                let _e715 = phi_1718_;
                let _e717 = phi_1719_;
                if _e717 {
                    phi_1723_ = _e667;
                } else {
                    phi_1723_ = _e715;
                }
                let _e719 = phi_1723_;
                let _e720 = (_e666 - _e693);
                let _e721 = (_e667 - _e719);
                let _e730 = select(0i, select(select(i32(_e693), i32(-2147483648), (_e693 < bitcast<f32>(3472883712u))), 2147483647i, (_e693 > bitcast<f32>(1325400063u))), (_e693 == _e693));
                let _e739 = select(0i, select(select(i32(_e719), i32(-2147483648), (_e719 < bitcast<f32>(3472883712u))), 2147483647i, (_e719 > bitcast<f32>(1325400063u))), (_e719 == _e719));
                let _e742 = ((1f - _e720) * (1f - _e721));
                let _e744 = (_e720 * (1f - _e721));
                let _e746 = ((1f - _e720) * _e721);
                let _e747 = (_e720 * _e721);
                let _e749 = p.member.test;
                let _e750 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e749);
                let _e752 = p.member.map_size;
                let _e754 = local_4;
                local_1 = _e750;
                let _e757 = ((_e754.level * _e752) * _e752);
                let _e759 = (bitcast<i32>(_e752) - 1i);
                if (_e730 > 0i) {
                    phi_1772_ = _e730;
                } else {
                    phi_1772_ = 0i;
                }
                let _e762 = phi_1772_;
                if (_e739 > 0i) {
                    phi_1777_ = _e739;
                } else {
                    phi_1777_ = 0i;
                }
                let _e765 = phi_1777_;
                if (_e762 < _e759) {
                    phi_1782_ = _e762;
                } else {
                    phi_1782_ = _e759;
                }
                let _e768 = phi_1782_;
                if (_e765 < _e759) {
                    phi_1787_ = _e765;
                } else {
                    phi_1787_ = _e759;
                }
                let _e771 = phi_1787_;
                let _e772 = bitcast<u32>(_e768);
                let _e774 = (_e730 + 1i);
                let _e775 = (_e739 + 1i);
                if (_e774 > 0i) {
                    phi_1796_ = _e774;
                } else {
                    phi_1796_ = 0i;
                }
                let _e778 = phi_1796_;
                if (_e775 > 0i) {
                    phi_1801_ = _e775;
                } else {
                    phi_1801_ = 0i;
                }
                let _e781 = phi_1801_;
                if (_e778 < _e759) {
                    phi_1806_ = _e778;
                } else {
                    phi_1806_ = _e759;
                }
                let _e784 = phi_1806_;
                if (_e781 < _e759) {
                    phi_1811_ = _e781;
                } else {
                    phi_1811_ = _e759;
                }
                let _e787 = phi_1811_;
                let _e788 = bitcast<u32>(_e784);
                let _e790 = (bitcast<u32>(_e771) * _e752);
                let _e791 = (bitcast<u32>(_e787) * _e752);
                let _e796 = ((_e790 + _e772) + _e757);
                let _e797 = ((_e790 + _e788) + _e757);
                let _e798 = ((_e791 + _e772) + _e757);
                let _e799 = ((_e791 + _e788) + _e757);
                if (_e796 < _e50) {
                } else {
                    return;
                }
                let _e803 = map.member[(0u + _e796)];
                if (_e797 < _e50) {
                } else {
                    return;
                }
                let _e815 = map.member[(0u + _e797)];
                if (_e798 < _e50) {
                } else {
                    return;
                }
                let _e831 = map.member[(0u + _e798)];
                if (_e799 < _e50) {
                } else {
                    return;
                }
                let _e847 = map.member[(0u + _e799)];
                let _e861 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_1), vec4<f32>(((((_e803.x * _e742) + (_e815.x * _e744)) + (_e831.x * _e746)) + (_e847.x * _e747)), ((((_e803.y * _e742) + (_e815.y * _e744)) + (_e831.y * _e746)) + (_e847.y * _e747)), ((((_e803.z * _e742) + (_e815.z * _e744)) + (_e831.z * _e746)) + (_e847.z * _e747)), ((((_e803.w * _e742) + (_e815.w * _e744)) + (_e831.w * _e746)) + (_e847.w * _e747))), _e656);
                phi_1900_ = evaluate_Verdict(_e861, false);
                phi_1901_ = evaluate_Verdict();
                phi_1902_ = false;
            } else {
                phi_1900_ = evaluate_Verdict();
                phi_1901_ = evaluate_Verdict(1f, false);
                phi_1902_ = true;
            }
            let _e865 = phi_1900_;
            let _e867 = phi_1901_;
            let _e869 = phi_1902_;
            phi_1903_ = _e867;
            phi_1904_ = _e865;
            phi_1905_ = _e869;
        }
        let _e871 = phi_1903_;
        let _e873 = phi_1904_;
        let _e875 = phi_1905_;
        if _e875 {
            phi_1909_ = _e871;
        } else {
            phi_1909_ = _e873;
        }
        let _e877 = phi_1909_;
        if (_e62.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e62.first_primitive)] = _e877.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_msm_hausdorff_prefiltered_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
