struct abi_LightParams {
    place: vec4<f32>,
    axis: vec3<f32>,
    cos_outer: f32,
    range_squared: f32,
    cos_inner: f32,
    number: u32,
    mask_words: u32,
}

struct type_9 {
    member: array<u32>,
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

struct type_19 {
    member: array<abi_Sample>,
}

struct type_23 {
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

struct type_35 {
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

struct type_39 {
    member: abi_ShadowParams,
}

struct lt_math_OneLevel {
    projection: lt_math_LightProjection,
}

struct hankel_HankelFactors {
    moments: vec4<f32>,
    d22_: f32,
    l32_d22_: f32,
    d33_d22_: f32,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_19;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_39;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_23;
@group(0) @binding(4) 
var<storage> marks: type_9;
@group(0) @binding(2) 
var<storage> map: type_35;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_166_: lt_bvh_traverse_Tree;
    var phi_167_: bool;
    var phi_168_: lt_bvh_traverse_Tree;
    var phi_169_: bool;
    var phi_174_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_166_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_167_ = false;
        } else {
            phi_166_ = lt_bvh_traverse_Tree();
            phi_167_ = true;
        }
        let _e55 = phi_166_;
        let _e57 = phi_167_;
        phi_168_ = _e55;
        phi_169_ = _e57;
    } else {
        phi_168_ = lt_bvh_traverse_Tree();
        phi_169_ = true;
    }
    let _e59 = phi_168_;
    let _e61 = phi_169_;
    if _e61 {
        phi_174_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_174_ = _e59;
    }
    let _e66 = phi_174_;
    return lt_bvh_traverse_Tree(_e66.root, _e66.first_primitive);
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn lt_math_hausdorff_cubic_mass(param_4: vec4<f32>, param_5: f32, param_6: f32, param_7: f32, param_8: f32) -> f32 {
    return ((((param_4.z - (((param_6 + param_7) + param_8) * param_4.y)) + ((((param_6 * param_7) + (param_6 * param_8)) + (param_7 * param_8)) * param_4.x)) - ((param_6 * param_7) * param_8)) / (((param_5 - param_6) * (param_5 - param_7)) * (param_5 - param_8)));
}

fn lt_math_hausdorff_endpoint_upper_bound(param_9: ptr<function, hankel_HankelFactors>, param_10: f32) -> f32 {
    var phi_944_: f32;
    var phi_945_: f32;
    var phi_946_: f32;
    var phi_973_: f32;
    var phi_974_: f32;
    var phi_975_: f32;
    var phi_976_: f32;
    var phi_977_: bool;
    var phi_978_: f32;
    var phi_979_: bool;
    var phi_1007_: f32;
    var phi_1008_: f32;
    var phi_1009_: f32;
    var phi_1010_: f32;
    var phi_1011_: bool;
    var phi_1012_: f32;
    var phi_1013_: bool;
    var phi_1020_: f32;
    var phi_1021_: f32;
    var phi_1022_: f32;
    var phi_1023_: f32;

    let _e45 = (*param_9).moments;
    if (param_10 < 0.0001f) {
        phi_1023_ = 1f;
    } else {
        let _e54 = ((_e45.z - ((1f + param_10) * _e45.y)) + (param_10 * _e45.x));
        let _e63 = (((_e45.w - ((1f + param_10) * _e45.z)) + (param_10 * _e45.y)) / _e54);
        if (abs(_e54) <= 0.00000047683716f) {
            let _e77 = (1f - (((_e45.y - (_e45.x * (param_10 + 1f))) + (param_10 * 1f)) / ((0f - param_10) * (0f - 1f))));
            if ((bitcast<u32>(_e77) & 2147483647u) > 2139095040u) {
                phi_946_ = _e77;
            } else {
                if (_e77 < 0f) {
                    phi_945_ = 0f;
                } else {
                    if (_e77 > 1f) {
                        phi_944_ = 1f;
                    } else {
                        phi_944_ = _e77;
                    }
                    let _e84 = phi_944_;
                    phi_945_ = _e84;
                }
                let _e86 = phi_945_;
                phi_946_ = _e86;
            }
            let _e88 = phi_946_;
            phi_1022_ = _e88;
        } else {
            if (_e63 > 0f) {
                if (_e63 < param_10) {
                    let _e91 = lt_math_hausdorff_cubic_mass(_e45, 0f, _e63, param_10, 1f);
                    let _e93 = lt_math_hausdorff_cubic_mass(_e45, _e63, 0f, param_10, 1f);
                    let _e94 = ((1f - _e91) - _e93);
                    if ((bitcast<u32>(_e94) & 2147483647u) > 2139095040u) {
                        phi_975_ = _e94;
                    } else {
                        if (_e94 < 0f) {
                            phi_974_ = 0f;
                        } else {
                            if (_e94 > 1f) {
                                phi_973_ = 1f;
                            } else {
                                phi_973_ = _e94;
                            }
                            let _e101 = phi_973_;
                            phi_974_ = _e101;
                        }
                        let _e103 = phi_974_;
                        phi_975_ = _e103;
                    }
                    let _e105 = phi_975_;
                    phi_976_ = _e105;
                    phi_977_ = false;
                } else {
                    phi_976_ = f32();
                    phi_977_ = true;
                }
                let _e107 = phi_976_;
                let _e109 = phi_977_;
                phi_978_ = _e107;
                phi_979_ = _e109;
            } else {
                phi_978_ = f32();
                phi_979_ = true;
            }
            let _e111 = phi_978_;
            let _e113 = phi_979_;
            if _e113 {
                if (_e63 > param_10) {
                    if (_e63 < 1f) {
                        let _e116 = lt_math_hausdorff_cubic_mass(_e45, 0f, _e63, param_10, 1f);
                        let _e117 = (1f - _e116);
                        if ((bitcast<u32>(_e117) & 2147483647u) > 2139095040u) {
                            phi_1009_ = _e117;
                        } else {
                            if (_e117 < 0f) {
                                phi_1008_ = 0f;
                            } else {
                                if (_e117 > 1f) {
                                    phi_1007_ = 1f;
                                } else {
                                    phi_1007_ = _e117;
                                }
                                let _e124 = phi_1007_;
                                phi_1008_ = _e124;
                            }
                            let _e126 = phi_1008_;
                            phi_1009_ = _e126;
                        }
                        let _e128 = phi_1009_;
                        phi_1010_ = _e128;
                        phi_1011_ = false;
                    } else {
                        phi_1010_ = f32();
                        phi_1011_ = true;
                    }
                    let _e130 = phi_1010_;
                    let _e132 = phi_1011_;
                    phi_1012_ = _e130;
                    phi_1013_ = _e132;
                } else {
                    phi_1012_ = f32();
                    phi_1013_ = true;
                }
                let _e134 = phi_1012_;
                let _e136 = phi_1013_;
                if _e136 {
                    phi_1020_ = bitcast<f32>((bitcast<u32>(_e63) | 2143289344u));
                } else {
                    phi_1020_ = _e134;
                }
                let _e141 = phi_1020_;
                phi_1021_ = _e141;
            } else {
                phi_1021_ = _e111;
            }
            let _e143 = phi_1021_;
            phi_1022_ = _e143;
        }
        let _e145 = phi_1022_;
        phi_1023_ = _e145;
    }
    let _e147 = phi_1023_;
    return _e147;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_11: ptr<function, f32>, param_12: vec4<f32>, param_13: f32) -> f32 {
    var local: hankel_HankelFactors;
    var phi_231_: f32;
    var phi_232_: f32;
    var phi_233_: f32;
    var phi_245_: bool;
    var phi_260_: bool;
    var phi_285_: f32;
    var phi_286_: f32;
    var phi_287_: f32;
    var phi_288_: f32;
    var phi_289_: bool;
    var phi_290_: f32;
    var phi_291_: bool;
    var phi_347_: vec2<f32>;
    var phi_385_: f32;
    var phi_386_: f32;
    var phi_387_: f32;
    var phi_420_: f32;
    var phi_421_: f32;
    var phi_422_: f32;
    var phi_426_: f32;
    var phi_427_: f32;
    var phi_428_: f32;
    var phi_429_: f32;
    var phi_482_: vec2<f32>;
    var phi_504_: bool;
    var phi_529_: f32;
    var phi_530_: f32;
    var phi_531_: f32;
    var phi_532_: f32;
    var phi_533_: bool;
    var phi_534_: f32;
    var phi_535_: bool;
    var phi_591_: vec2<f32>;
    var phi_629_: f32;
    var phi_630_: f32;
    var phi_631_: f32;
    var phi_664_: f32;
    var phi_665_: f32;
    var phi_666_: f32;
    var phi_670_: f32;
    var phi_671_: f32;
    var phi_672_: f32;
    var phi_673_: f32;
    var phi_674_: f32;
    var phi_675_: bool;
    var phi_676_: f32;
    var phi_677_: bool;
    var phi_699_: bool;
    var phi_724_: f32;
    var phi_725_: f32;
    var phi_726_: f32;
    var phi_727_: f32;
    var phi_728_: bool;
    var phi_729_: f32;
    var phi_730_: bool;
    var phi_786_: vec2<f32>;
    var phi_824_: f32;
    var phi_825_: f32;
    var phi_826_: f32;
    var phi_859_: f32;
    var phi_860_: f32;
    var phi_861_: f32;
    var phi_865_: f32;
    var phi_866_: f32;
    var phi_867_: f32;
    var phi_868_: f32;
    var phi_879_: bool;
    var phi_883_: f32;
    var phi_884_: f32;
    var phi_885_: f32;
    var phi_886_: f32;

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
        phi_233_ = param_13;
    } else {
        if (param_13 < 0f) {
            phi_232_ = 0f;
        } else {
            if (param_13 > 1f) {
                phi_231_ = 1f;
            } else {
                phi_231_ = param_13;
            }
            let _e83 = phi_231_;
            phi_232_ = _e83;
        }
        let _e85 = phi_232_;
        phi_233_ = _e85;
    }
    let _e87 = phi_233_;
    let _e90 = local.moments[0u];
    let _e93 = local.moments[3u];
    if (_e90 == _e93) {
        let _e97 = local.moments[0u];
        phi_245_ = (_e97 > 0.5f);
    } else {
        phi_245_ = false;
    }
    let _e100 = phi_245_;
    if _e100 {
        let _e103 = local.moments[0u];
        let _e106 = local.moments[3u];
        if (_e103 == _e106) {
            let _e110 = local.moments[0u];
            phi_260_ = (_e110 > 0.5f);
        } else {
            phi_260_ = false;
        }
        let _e113 = phi_260_;
        if _e113 {
            if (_e87 > 0f) {
                let _e116 = local.moments;
                if ((bitcast<u32>(_e116.x) & 2147483647u) > 2139095040u) {
                    phi_287_ = _e116.x;
                } else {
                    if (_e116.x < 0f) {
                        phi_286_ = 0f;
                    } else {
                        if (_e116.x > 1f) {
                            phi_285_ = 1f;
                        } else {
                            phi_285_ = _e116.x;
                        }
                        let _e124 = phi_285_;
                        phi_286_ = _e124;
                    }
                    let _e126 = phi_286_;
                    phi_287_ = _e126;
                }
                let _e128 = phi_287_;
                phi_288_ = _e128;
                phi_289_ = false;
            } else {
                phi_288_ = f32();
                phi_289_ = true;
            }
            let _e130 = phi_288_;
            let _e132 = phi_289_;
            phi_290_ = _e130;
            phi_291_ = _e132;
        } else {
            phi_290_ = f32();
            phi_291_ = true;
        }
        let _e134 = phi_290_;
        let _e136 = phi_291_;
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
                phi_347_ = vec2<f32>((-(_e175) - _e180), (-(_e175) + _e180));
            } else {
                phi_347_ = vec2(bitcast<f32>((bitcast<u32>(_e178) | 2143289344u)));
            }
            let _e191 = phi_347_;
            if (_e87 <= _e191.x) {
                phi_428_ = 1f;
            } else {
                if (_e87 > _e191.y) {
                    let _e197 = local.moments;
                    let _e208 = (((_e197.y - (_e197.x * (_e191.x + _e191.y))) + (_e191.x * _e191.y)) / ((_e87 - _e191.x) * (_e87 - _e191.y)));
                    if ((bitcast<u32>(_e208) & 2147483647u) > 2139095040u) {
                        phi_387_ = _e208;
                    } else {
                        if (_e208 < 0f) {
                            phi_386_ = 0f;
                        } else {
                            if (_e208 > 1f) {
                                phi_385_ = 1f;
                            } else {
                                phi_385_ = _e208;
                            }
                            let _e215 = phi_385_;
                            phi_386_ = _e215;
                        }
                        let _e217 = phi_386_;
                        phi_387_ = _e217;
                    }
                    let _e219 = phi_387_;
                    phi_427_ = _e219;
                } else {
                    if (_e87 > _e191.x) {
                        let _e222 = local.moments;
                        let _e234 = (1f - (((_e222.y - (_e222.x * (_e87 + _e191.y))) + (_e87 * _e191.y)) / ((_e191.x - _e87) * (_e191.x - _e191.y))));
                        if ((bitcast<u32>(_e234) & 2147483647u) > 2139095040u) {
                            phi_422_ = _e234;
                        } else {
                            if (_e234 < 0f) {
                                phi_421_ = 0f;
                            } else {
                                if (_e234 > 1f) {
                                    phi_420_ = 1f;
                                } else {
                                    phi_420_ = _e234;
                                }
                                let _e241 = phi_420_;
                                phi_421_ = _e241;
                            }
                            let _e243 = phi_421_;
                            phi_422_ = _e243;
                        }
                        let _e245 = phi_422_;
                        phi_426_ = _e245;
                    } else {
                        phi_426_ = bitcast<f32>((bitcast<u32>(_e191.x) | 2143289344u));
                    }
                    let _e250 = phi_426_;
                    phi_427_ = _e250;
                }
                let _e252 = phi_427_;
                phi_428_ = _e252;
            }
            let _e254 = phi_428_;
            phi_429_ = _e254;
        } else {
            phi_429_ = _e134;
        }
        let _e256 = phi_429_;
        phi_886_ = _e256;
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
            phi_482_ = vec2<f32>((-(_e295) - _e300), (-(_e295) + _e300));
        } else {
            phi_482_ = vec2(bitcast<f32>((bitcast<u32>(_e298) | 2143289344u)));
        }
        let _e311 = phi_482_;
        if (_e311.x >= 0f) {
            if (_e311.y <= 1f) {
                let _e318 = local.moments[0u];
                let _e321 = local.moments[3u];
                if (_e318 == _e321) {
                    let _e325 = local.moments[0u];
                    phi_504_ = (_e325 > 0.5f);
                } else {
                    phi_504_ = false;
                }
                let _e328 = phi_504_;
                if _e328 {
                    if (_e87 > 0f) {
                        let _e331 = local.moments;
                        if ((bitcast<u32>(_e331.x) & 2147483647u) > 2139095040u) {
                            phi_531_ = _e331.x;
                        } else {
                            if (_e331.x < 0f) {
                                phi_530_ = 0f;
                            } else {
                                if (_e331.x > 1f) {
                                    phi_529_ = 1f;
                                } else {
                                    phi_529_ = _e331.x;
                                }
                                let _e339 = phi_529_;
                                phi_530_ = _e339;
                            }
                            let _e341 = phi_530_;
                            phi_531_ = _e341;
                        }
                        let _e343 = phi_531_;
                        phi_532_ = _e343;
                        phi_533_ = false;
                    } else {
                        phi_532_ = f32();
                        phi_533_ = true;
                    }
                    let _e345 = phi_532_;
                    let _e347 = phi_533_;
                    phi_534_ = _e345;
                    phi_535_ = _e347;
                } else {
                    phi_534_ = f32();
                    phi_535_ = true;
                }
                let _e349 = phi_534_;
                let _e351 = phi_535_;
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
                        phi_591_ = vec2<f32>((-(_e390) - _e395), (-(_e390) + _e395));
                    } else {
                        phi_591_ = vec2(bitcast<f32>((bitcast<u32>(_e393) | 2143289344u)));
                    }
                    let _e406 = phi_591_;
                    if (_e87 <= _e406.x) {
                        phi_672_ = 1f;
                    } else {
                        if (_e87 > _e406.y) {
                            let _e412 = local.moments;
                            let _e423 = (((_e412.y - (_e412.x * (_e406.x + _e406.y))) + (_e406.x * _e406.y)) / ((_e87 - _e406.x) * (_e87 - _e406.y)));
                            if ((bitcast<u32>(_e423) & 2147483647u) > 2139095040u) {
                                phi_631_ = _e423;
                            } else {
                                if (_e423 < 0f) {
                                    phi_630_ = 0f;
                                } else {
                                    if (_e423 > 1f) {
                                        phi_629_ = 1f;
                                    } else {
                                        phi_629_ = _e423;
                                    }
                                    let _e430 = phi_629_;
                                    phi_630_ = _e430;
                                }
                                let _e432 = phi_630_;
                                phi_631_ = _e432;
                            }
                            let _e434 = phi_631_;
                            phi_671_ = _e434;
                        } else {
                            if (_e87 > _e406.x) {
                                let _e437 = local.moments;
                                let _e449 = (1f - (((_e437.y - (_e437.x * (_e87 + _e406.y))) + (_e87 * _e406.y)) / ((_e406.x - _e87) * (_e406.x - _e406.y))));
                                if ((bitcast<u32>(_e449) & 2147483647u) > 2139095040u) {
                                    phi_666_ = _e449;
                                } else {
                                    if (_e449 < 0f) {
                                        phi_665_ = 0f;
                                    } else {
                                        if (_e449 > 1f) {
                                            phi_664_ = 1f;
                                        } else {
                                            phi_664_ = _e449;
                                        }
                                        let _e456 = phi_664_;
                                        phi_665_ = _e456;
                                    }
                                    let _e458 = phi_665_;
                                    phi_666_ = _e458;
                                }
                                let _e460 = phi_666_;
                                phi_670_ = _e460;
                            } else {
                                phi_670_ = bitcast<f32>((bitcast<u32>(_e406.x) | 2143289344u));
                            }
                            let _e465 = phi_670_;
                            phi_671_ = _e465;
                        }
                        let _e467 = phi_671_;
                        phi_672_ = _e467;
                    }
                    let _e469 = phi_672_;
                    phi_673_ = _e469;
                } else {
                    phi_673_ = _e349;
                }
                let _e471 = phi_673_;
                phi_674_ = _e471;
                phi_675_ = false;
            } else {
                phi_674_ = f32();
                phi_675_ = true;
            }
            let _e473 = phi_674_;
            let _e475 = phi_675_;
            phi_676_ = _e473;
            phi_677_ = _e475;
        } else {
            phi_676_ = f32();
            phi_677_ = true;
        }
        let _e477 = phi_676_;
        let _e479 = phi_677_;
        if _e479 {
            if ((bitcast<u32>(_e311.x) & 2147483647u) > 2139095040u) {
                phi_884_ = _e311.x;
            } else {
                let _e483 = lt_math_hausdorff_endpoint_upper_bound((&local), _e87);
                let _e486 = local.moments[0u];
                let _e489 = local.moments[3u];
                if (_e486 == _e489) {
                    let _e493 = local.moments[0u];
                    phi_699_ = (_e493 > 0.5f);
                } else {
                    phi_699_ = false;
                }
                let _e496 = phi_699_;
                if _e496 {
                    if (_e87 > 0f) {
                        let _e499 = local.moments;
                        if ((bitcast<u32>(_e499.x) & 2147483647u) > 2139095040u) {
                            phi_726_ = _e499.x;
                        } else {
                            if (_e499.x < 0f) {
                                phi_725_ = 0f;
                            } else {
                                if (_e499.x > 1f) {
                                    phi_724_ = 1f;
                                } else {
                                    phi_724_ = _e499.x;
                                }
                                let _e507 = phi_724_;
                                phi_725_ = _e507;
                            }
                            let _e509 = phi_725_;
                            phi_726_ = _e509;
                        }
                        let _e511 = phi_726_;
                        phi_727_ = _e511;
                        phi_728_ = false;
                    } else {
                        phi_727_ = f32();
                        phi_728_ = true;
                    }
                    let _e513 = phi_727_;
                    let _e515 = phi_728_;
                    phi_729_ = _e513;
                    phi_730_ = _e515;
                } else {
                    phi_729_ = f32();
                    phi_730_ = true;
                }
                let _e517 = phi_729_;
                let _e519 = phi_730_;
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
                        phi_786_ = vec2<f32>((-(_e558) - _e563), (-(_e558) + _e563));
                    } else {
                        phi_786_ = vec2(bitcast<f32>((bitcast<u32>(_e561) | 2143289344u)));
                    }
                    let _e574 = phi_786_;
                    if (_e87 <= _e574.x) {
                        phi_867_ = 1f;
                    } else {
                        if (_e87 > _e574.y) {
                            let _e580 = local.moments;
                            let _e591 = (((_e580.y - (_e580.x * (_e574.x + _e574.y))) + (_e574.x * _e574.y)) / ((_e87 - _e574.x) * (_e87 - _e574.y)));
                            if ((bitcast<u32>(_e591) & 2147483647u) > 2139095040u) {
                                phi_826_ = _e591;
                            } else {
                                if (_e591 < 0f) {
                                    phi_825_ = 0f;
                                } else {
                                    if (_e591 > 1f) {
                                        phi_824_ = 1f;
                                    } else {
                                        phi_824_ = _e591;
                                    }
                                    let _e598 = phi_824_;
                                    phi_825_ = _e598;
                                }
                                let _e600 = phi_825_;
                                phi_826_ = _e600;
                            }
                            let _e602 = phi_826_;
                            phi_866_ = _e602;
                        } else {
                            if (_e87 > _e574.x) {
                                let _e605 = local.moments;
                                let _e617 = (1f - (((_e605.y - (_e605.x * (_e87 + _e574.y))) + (_e87 * _e574.y)) / ((_e574.x - _e87) * (_e574.x - _e574.y))));
                                if ((bitcast<u32>(_e617) & 2147483647u) > 2139095040u) {
                                    phi_861_ = _e617;
                                } else {
                                    if (_e617 < 0f) {
                                        phi_860_ = 0f;
                                    } else {
                                        if (_e617 > 1f) {
                                            phi_859_ = 1f;
                                        } else {
                                            phi_859_ = _e617;
                                        }
                                        let _e624 = phi_859_;
                                        phi_860_ = _e624;
                                    }
                                    let _e626 = phi_860_;
                                    phi_861_ = _e626;
                                }
                                let _e628 = phi_861_;
                                phi_865_ = _e628;
                            } else {
                                phi_865_ = bitcast<f32>((bitcast<u32>(_e574.x) | 2143289344u));
                            }
                            let _e633 = phi_865_;
                            phi_866_ = _e633;
                        }
                        let _e635 = phi_866_;
                        phi_867_ = _e635;
                    }
                    let _e637 = phi_867_;
                    phi_868_ = _e637;
                } else {
                    phi_868_ = _e517;
                }
                let _e639 = phi_868_;
                if ((bitcast<u32>(_e639) & 2147483647u) > 2139095040u) {
                    phi_879_ = true;
                } else {
                    let _e643 = (_e639 < _e483);
                    if _e643 {
                    }
                    phi_879_ = _e643;
                }
                let _e645 = phi_879_;
                if _e645 {
                    phi_883_ = _e639;
                } else {
                    phi_883_ = _e483;
                }
                let _e647 = phi_883_;
                phi_884_ = _e647;
            }
            let _e649 = phi_884_;
            phi_885_ = _e649;
        } else {
            phi_885_ = _e477;
        }
        let _e651 = phi_885_;
        phi_886_ = _e651;
    }
    let _e653 = phi_886_;
    return _e653;
}

fn function_() {
    var local_1: f32;
    var phi_1114_: bool;
    var phi_1115_: bool;
    var phi_1116_: bool;
    var phi_1117_: bool;
    var phi_1121_: bool;
    var phi_1191_: bool;
    var phi_1192_: bool;
    var phi_1203_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1204_: bool;
    var phi_1205_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1206_: bool;
    var phi_1213_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1217_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1291_: bool;
    var phi_1300_: bool;
    var phi_1309_: bool;
    var phi_1310_: bool;
    var phi_1311_: bool;
    var phi_1312_: bool;
    var phi_1313_: bool;
    var phi_1314_: bool;
    var phi_1315_: bool;
    var phi_1319_: bool;
    var phi_1409_: f32;
    var phi_1412_: f32;
    var phi_1441_: f32;
    var phi_1446_: f32;
    var phi_1447_: bool;
    var phi_1448_: f32;
    var phi_1449_: bool;
    var phi_1453_: f32;
    var phi_1473_: f32;
    var phi_1478_: f32;
    var phi_1479_: bool;
    var phi_1480_: f32;
    var phi_1481_: bool;
    var phi_1485_: f32;
    var phi_1535_: i32;
    var phi_1540_: i32;
    var phi_1545_: i32;
    var phi_1550_: i32;
    var phi_1559_: i32;
    var phi_1564_: i32;
    var phi_1569_: i32;
    var phi_1574_: i32;
    var phi_1673_: i32;
    var phi_1678_: i32;
    var phi_1683_: i32;
    var phi_1688_: i32;
    var phi_1707_: i32;
    var phi_1712_: i32;
    var phi_1717_: i32;
    var phi_1722_: i32;
    var phi_1741_: i32;
    var phi_1746_: i32;
    var phi_1751_: i32;
    var phi_1756_: i32;
    var phi_1775_: i32;
    var phi_1780_: i32;
    var phi_1785_: i32;
    var phi_1790_: i32;
    var phi_1868_: bool;
    var phi_1876_: bool;
    var phi_1888_: bool;
    var phi_1889_: bool;
    var phi_1893_: f32;
    var phi_1899_: f32;
    var phi_1901_: evaluate_Verdict;
    var phi_1911_: u32;
    var phi_1920_: f32;
    var phi_1922_: evaluate_Verdict;
    var phi_1923_: bool;
    var phi_1924_: evaluate_Verdict;
    var phi_1925_: bool;
    var phi_1930_: evaluate_Verdict;
    var phi_1935_: evaluate_Verdict;
    var phi_1936_: evaluate_Verdict;

    let _e43 = id_1;
    let _e50 = arrayLength((&map.member));
    let _e56 = arrayLength((&marks.member));
    let _e59 = p.member.size[0u];
    let _e61 = p.member.size[1u];
    let _e62 = lt_shaders_entry_pixel_index(_e43, _e59, _e61);
    if (bitcast<i32>(_e62.root) != 0i) {
        let _e68 = p.member.projection;
        if (_e62.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e72 = lt_math_OneLevel(_e68);
        let _e76 = samples.member[(0u + _e62.first_primitive)].normal[0u];
        let _e78 = global[0u];
        if (_e76 == _e78) {
            let _e81 = samples.member[(0u + _e62.first_primitive)].normal[1u];
            let _e83 = global[1u];
            if (_e81 == _e83) {
                let _e86 = samples.member[(0u + _e62.first_primitive)].normal[2u];
                let _e88 = global[2u];
                phi_1114_ = (_e86 == _e88);
                phi_1115_ = false;
            } else {
                phi_1114_ = bool();
                phi_1115_ = true;
            }
            let _e91 = phi_1114_;
            let _e93 = phi_1115_;
            phi_1116_ = _e91;
            phi_1117_ = _e93;
        } else {
            phi_1116_ = bool();
            phi_1117_ = true;
        }
        let _e95 = phi_1116_;
        let _e97 = phi_1117_;
        if _e97 {
            phi_1121_ = false;
        } else {
            phi_1121_ = _e95;
        }
        let _e99 = phi_1121_;
        if !(_e99) {
            let _e102 = samples.member[(0u + _e62.first_primitive)].position;
            let _e104 = p.member.light.place;
            let _e110 = p.member.light.place[3u];
            let _e117 = (_e104.x - (_e102.x * _e110));
            let _e118 = (_e104.y - (_e102.y * _e110));
            let _e119 = (_e104.z - (_e102.z * _e110));
            let _e121 = samples.member[(0u + _e62.first_primitive)].normal;
            if ((((_e121.x * _e117) + (_e121.y * _e118)) + (_e121.z * _e119)) > 0f) {
                let _e135 = (((_e117 * _e117) + (_e118 * _e118)) + (_e119 * _e119));
                let _e137 = p.member.light.axis;
                let _e149 = p.member.light.place[3u];
                if (_e149 == 0f) {
                    phi_1192_ = true;
                } else {
                    let _e152 = p.member.light.range_squared;
                    if (_e135 <= _e152) {
                        let _e155 = p.member.light.cos_outer;
                        phi_1191_ = (-((((_e117 * _e137.x) + (_e118 * _e137.y)) + (_e119 * _e137.z))) >= (_e155 * sqrt(_e135)));
                    } else {
                        phi_1191_ = false;
                    }
                    let _e160 = phi_1191_;
                    phi_1192_ = _e160;
                }
                let _e162 = phi_1192_;
                if _e162 {
                    let _e164 = samples.member[(0u + _e62.first_primitive)].flags;
                    let _e172 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e178 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e172.unnamed.visibility, false), _e172.unnamed_1);
                    phi_1203_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e178.unnamed, ((_e164 & 1u) == 0u));
                    phi_1204_ = false;
                } else {
                    phi_1203_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_1204_ = true;
                }
                let _e183 = phi_1203_;
                let _e185 = phi_1204_;
                phi_1205_ = _e183;
                phi_1206_ = _e185;
            } else {
                phi_1205_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_1206_ = true;
            }
            let _e187 = phi_1205_;
            let _e189 = phi_1206_;
            if _e189 {
                let _e195 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e201 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e195.unnamed.visibility, false), _e195.unnamed_1);
                phi_1213_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e201.unnamed, true);
            } else {
                phi_1213_ = _e187;
            }
            let _e206 = phi_1213_;
            phi_1217_ = _e206;
        } else {
            let _e212 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e218 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e212.unnamed.visibility, false), _e212.unnamed_1);
            phi_1217_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e218.unnamed, true);
        }
        let _e223 = phi_1217_;
        if _e223.unnamed_1 {
            phi_1936_ = evaluate_Verdict(_e223.unnamed.visibility, _e223.unnamed.is_doubted);
        } else {
            let _e231 = samples.member[(0u + _e62.first_primitive)].position;
            let _e249 = ((((_e72.projection.row_w.x * _e231.x) + (_e72.projection.row_w.y * _e231.y)) + (_e72.projection.row_w.z * _e231.z)) + (_e72.projection.row_w.w * 1f));
            let _e263 = (((((_e72.projection.row_x.x * _e231.x) + (_e72.projection.row_x.y * _e231.y)) + (_e72.projection.row_x.z * _e231.z)) + (_e72.projection.row_x.w * 1f)) / _e249);
            let _e277 = (((((_e72.projection.row_y.x * _e231.x) + (_e72.projection.row_y.y * _e231.y)) + (_e72.projection.row_y.z * _e231.z)) + (_e72.projection.row_y.w * 1f)) / _e249);
            let _e290 = ((((_e72.projection.row_z.x * _e231.x) + (_e72.projection.row_z.y * _e231.y)) + (_e72.projection.row_z.z * _e231.z)) + (_e72.projection.row_z.w * 1f));
            if (_e249 > 0f) {
                if (_e263 >= 0f) {
                    phi_1291_ = (_e263 <= 1f);
                } else {
                    phi_1291_ = false;
                }
                let _e295 = phi_1291_;
                if _e295 {
                    if (_e277 >= 0f) {
                        phi_1300_ = (_e277 <= 1f);
                    } else {
                        phi_1300_ = false;
                    }
                    let _e299 = phi_1300_;
                    if _e299 {
                        if (_e290 >= 0f) {
                            phi_1309_ = (_e290 <= 1f);
                        } else {
                            phi_1309_ = false;
                        }
                        let _e303 = phi_1309_;
                        phi_1310_ = _e303;
                        phi_1311_ = false;
                    } else {
                        phi_1310_ = bool();
                        phi_1311_ = true;
                    }
                    let _e305 = phi_1310_;
                    let _e307 = phi_1311_;
                    phi_1312_ = _e305;
                    phi_1313_ = _e307;
                } else {
                    phi_1312_ = bool();
                    phi_1313_ = true;
                }
                let _e309 = phi_1312_;
                let _e311 = phi_1313_;
                phi_1314_ = _e309;
                phi_1315_ = _e311;
            } else {
                phi_1314_ = bool();
                phi_1315_ = true;
            }
            let _e313 = phi_1314_;
            let _e315 = phi_1315_;
            if _e315 {
                phi_1319_ = false;
            } else {
                phi_1319_ = _e313;
            }
            let _e317 = phi_1319_;
            if _e317 {
                if (0f > 0f) {
                    let _e320 = samples.member[(0u + _e62.first_primitive)].normal;
                    let _e322 = p.member.map_size;
                    let _e392 = ((abs(((((_e68.row_x.x * _e320.x) + (_e68.row_x.y * _e320.y)) + (_e68.row_x.z * _e320.z)) / (((_e68.row_x.x * _e68.row_x.x) + (_e68.row_x.y * _e68.row_x.y)) + (_e68.row_x.z * _e68.row_x.z)))) + abs(((((_e68.row_y.x * _e320.x) + (_e68.row_y.y * _e320.y)) + (_e68.row_y.z * _e320.z)) / (((_e68.row_y.x * _e68.row_y.x) + (_e68.row_y.y * _e68.row_y.y)) + (_e68.row_y.z * _e68.row_y.z))))) / (abs(((((_e68.row_z.x * _e320.x) + (_e68.row_z.y * _e320.y)) + (_e68.row_z.z * _e320.z)) / (((_e68.row_z.x * _e68.row_z.x) + (_e68.row_z.y * _e68.row_z.y)) + (_e68.row_z.z * _e68.row_z.z)))) * f32(_e322)));
                    if (_e392 < 0.002f) {
                        phi_1409_ = _e392;
                    } else {
                        phi_1409_ = 0.002f;
                    }
                    let _e395 = phi_1409_;
                    phi_1412_ = (_e290 - (0f * _e395));
                } else {
                    phi_1412_ = _e290;
                }
                let _e399 = phi_1412_;
                let _e401 = p.member.map_size;
                let _e402 = f32(_e401);
                let _e405 = ((_e263 * _e402) - 0.5f);
                let _e406 = ((_e277 * _e402) - 0.5f);
                if (_e405 > -8388608f) {
                    let _e418 = f32(select(0i, select(select(i32(_e405), i32(-2147483648), (_e405 < bitcast<f32>(3472883712u))), 2147483647i, (_e405 > bitcast<f32>(1325400063u))), (_e405 == _e405)));
                    if (_e418 > _e405) {
                        phi_1441_ = 1f;
                    } else {
                        phi_1441_ = 0f;
                    }
                    let _e421 = phi_1441_;
                    if (_e405 < 8388608f) {
                        phi_1446_ = (_e418 - _e421);
                        phi_1447_ = false;
                    } else {
                        phi_1446_ = f32();
                        phi_1447_ = true;
                    }
                    let _e424 = phi_1446_;
                    let _e426 = phi_1447_;
                    phi_1448_ = _e424;
                    phi_1449_ = _e426;
                } else {
                    phi_1448_ = f32();
                    phi_1449_ = true;
                }
                let _e428 = phi_1448_;
                let _e430 = phi_1449_;
                if _e430 {
                    phi_1453_ = _e405;
                } else {
                    phi_1453_ = _e428;
                }
                let _e432 = phi_1453_;
                if (_e406 > -8388608f) {
                    let _e444 = f32(select(0i, select(select(i32(_e406), i32(-2147483648), (_e406 < bitcast<f32>(3472883712u))), 2147483647i, (_e406 > bitcast<f32>(1325400063u))), (_e406 == _e406)));
                    if (_e444 > _e406) {
                        phi_1473_ = 1f;
                    } else {
                        phi_1473_ = 0f;
                    }
                    let _e447 = phi_1473_;
                    if (_e406 < 8388608f) {
                        phi_1478_ = (_e444 - _e447);
                        phi_1479_ = false;
                    } else {
                        phi_1478_ = f32();
                        phi_1479_ = true;
                    }
                    let _e450 = phi_1478_;
                    let _e452 = phi_1479_;
                    phi_1480_ = _e450;
                    phi_1481_ = _e452;
                } else {
                    phi_1480_ = f32();
                    phi_1481_ = true;
                }
                let _e454 = phi_1480_;
                let _e456 = phi_1481_;
                if _e456 {
                    phi_1485_ = _e406;
                } else {
                    phi_1485_ = _e454;
                }
                let _e458 = phi_1485_;
                let _e459 = (_e405 - _e432);
                let _e460 = (_e406 - _e458);
                let _e469 = select(0i, select(select(i32(_e432), i32(-2147483648), (_e432 < bitcast<f32>(3472883712u))), 2147483647i, (_e432 > bitcast<f32>(1325400063u))), (_e432 == _e432));
                let _e478 = select(0i, select(select(i32(_e458), i32(-2147483648), (_e458 < bitcast<f32>(3472883712u))), 2147483647i, (_e458 > bitcast<f32>(1325400063u))), (_e458 == _e458));
                let _e481 = ((1f - _e459) * (1f - _e460));
                let _e483 = (_e459 * (1f - _e460));
                let _e485 = ((1f - _e459) * _e460);
                let _e486 = (_e459 * _e460);
                let _e488 = p.member.test;
                let _e489 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e488);
                let _e491 = p.member.map_size;
                local_1 = _e489;
                let _e493 = ((0u * _e491) * _e491);
                let _e495 = (bitcast<i32>(_e491) - 1i);
                if (_e469 > 0i) {
                    phi_1535_ = _e469;
                } else {
                    phi_1535_ = 0i;
                }
                let _e498 = phi_1535_;
                if (_e478 > 0i) {
                    phi_1540_ = _e478;
                } else {
                    phi_1540_ = 0i;
                }
                let _e501 = phi_1540_;
                if (_e498 < _e495) {
                    phi_1545_ = _e498;
                } else {
                    phi_1545_ = _e495;
                }
                let _e504 = phi_1545_;
                if (_e501 < _e495) {
                    phi_1550_ = _e501;
                } else {
                    phi_1550_ = _e495;
                }
                let _e507 = phi_1550_;
                let _e508 = bitcast<u32>(_e504);
                let _e510 = (_e469 + 1i);
                let _e511 = (_e478 + 1i);
                if (_e510 > 0i) {
                    phi_1559_ = _e510;
                } else {
                    phi_1559_ = 0i;
                }
                let _e514 = phi_1559_;
                if (_e511 > 0i) {
                    phi_1564_ = _e511;
                } else {
                    phi_1564_ = 0i;
                }
                let _e517 = phi_1564_;
                if (_e514 < _e495) {
                    phi_1569_ = _e514;
                } else {
                    phi_1569_ = _e495;
                }
                let _e520 = phi_1569_;
                if (_e517 < _e495) {
                    phi_1574_ = _e517;
                } else {
                    phi_1574_ = _e495;
                }
                let _e523 = phi_1574_;
                let _e524 = bitcast<u32>(_e520);
                let _e526 = (bitcast<u32>(_e507) * _e491);
                let _e527 = (bitcast<u32>(_e523) * _e491);
                let _e532 = ((_e526 + _e508) + _e493);
                let _e533 = ((_e526 + _e524) + _e493);
                let _e534 = ((_e527 + _e508) + _e493);
                let _e535 = ((_e527 + _e524) + _e493);
                if (_e532 < _e50) {
                } else {
                    return;
                }
                let _e539 = map.member[(0u + _e532)];
                if (_e533 < _e50) {
                } else {
                    return;
                }
                let _e551 = map.member[(0u + _e533)];
                if (_e534 < _e50) {
                } else {
                    return;
                }
                let _e567 = map.member[(0u + _e534)];
                if (_e535 < _e50) {
                } else {
                    return;
                }
                let _e583 = map.member[(0u + _e535)];
                let _e597 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_1), vec4<f32>(((((_e539.x * _e481) + (_e551.x * _e483)) + (_e567.x * _e485)) + (_e583.x * _e486)), ((((_e539.y * _e481) + (_e551.y * _e483)) + (_e567.y * _e485)) + (_e583.y * _e486)), ((((_e539.z * _e481) + (_e551.z * _e483)) + (_e567.z * _e485)) + (_e583.z * _e486)), ((((_e539.w * _e481) + (_e551.w * _e483)) + (_e567.w * _e485)) + (_e583.w * _e486))), _e399);
                let _e599 = p.member.map_size;
                let _e601 = (bitcast<i32>(_e599) - 1i);
                if (_e469 > 0i) {
                    phi_1673_ = _e469;
                } else {
                    phi_1673_ = 0i;
                }
                let _e604 = phi_1673_;
                if (_e478 > 0i) {
                    phi_1678_ = _e478;
                } else {
                    phi_1678_ = 0i;
                }
                let _e607 = phi_1678_;
                if (_e604 < _e601) {
                    phi_1683_ = _e604;
                } else {
                    phi_1683_ = _e601;
                }
                let _e610 = phi_1683_;
                if (_e607 < _e601) {
                    phi_1688_ = _e607;
                } else {
                    phi_1688_ = _e601;
                }
                let _e613 = phi_1688_;
                let _e614 = bitcast<u32>(_e610);
                let _e621 = ((((0u * _e599) + bitcast<u32>(_e613)) * (_e599 / 16u)) + (_e614 / 16u));
                let _e624 = (_e469 + 1i);
                let _e625 = (_e478 + 0i);
                let _e627 = (bitcast<i32>(_e599) - 1i);
                if (_e624 > 0i) {
                    phi_1707_ = _e624;
                } else {
                    phi_1707_ = 0i;
                }
                let _e630 = phi_1707_;
                if (_e625 > 0i) {
                    phi_1712_ = _e625;
                } else {
                    phi_1712_ = 0i;
                }
                let _e633 = phi_1712_;
                if (_e630 < _e627) {
                    phi_1717_ = _e630;
                } else {
                    phi_1717_ = _e627;
                }
                let _e636 = phi_1717_;
                if (_e633 < _e627) {
                    phi_1722_ = _e633;
                } else {
                    phi_1722_ = _e627;
                }
                let _e639 = phi_1722_;
                let _e640 = bitcast<u32>(_e636);
                let _e647 = ((((0u * _e599) + bitcast<u32>(_e639)) * (_e599 / 16u)) + (_e640 / 16u));
                let _e650 = (_e469 + 0i);
                let _e651 = (_e478 + 1i);
                let _e653 = (bitcast<i32>(_e599) - 1i);
                if (_e650 > 0i) {
                    phi_1741_ = _e650;
                } else {
                    phi_1741_ = 0i;
                }
                let _e656 = phi_1741_;
                if (_e651 > 0i) {
                    phi_1746_ = _e651;
                } else {
                    phi_1746_ = 0i;
                }
                let _e659 = phi_1746_;
                if (_e656 < _e653) {
                    phi_1751_ = _e656;
                } else {
                    phi_1751_ = _e653;
                }
                let _e662 = phi_1751_;
                if (_e659 < _e653) {
                    phi_1756_ = _e659;
                } else {
                    phi_1756_ = _e653;
                }
                let _e665 = phi_1756_;
                let _e666 = bitcast<u32>(_e662);
                let _e673 = ((((0u * _e599) + bitcast<u32>(_e665)) * (_e599 / 16u)) + (_e666 / 16u));
                let _e676 = (_e469 + 1i);
                let _e677 = (_e478 + 1i);
                let _e679 = (bitcast<i32>(_e599) - 1i);
                if (_e676 > 0i) {
                    phi_1775_ = _e676;
                } else {
                    phi_1775_ = 0i;
                }
                let _e682 = phi_1775_;
                if (_e677 > 0i) {
                    phi_1780_ = _e677;
                } else {
                    phi_1780_ = 0i;
                }
                let _e685 = phi_1780_;
                if (_e682 < _e679) {
                    phi_1785_ = _e682;
                } else {
                    phi_1785_ = _e679;
                }
                let _e688 = phi_1785_;
                if (_e685 < _e679) {
                    phi_1790_ = _e685;
                } else {
                    phi_1790_ = _e679;
                }
                let _e691 = phi_1790_;
                let _e692 = bitcast<u32>(_e688);
                let _e699 = ((((0u * _e599) + bitcast<u32>(_e691)) * (_e599 / 16u)) + (_e692 / 16u));
                if (_e621 < _e56) {
                } else {
                    return;
                }
                let _e705 = marks.member[(0u + _e621)];
                if (_e647 < _e56) {
                } else {
                    return;
                }
                let _e713 = marks.member[(0u + _e647)];
                if (_e673 < _e56) {
                } else {
                    return;
                }
                let _e722 = marks.member[(0u + _e673)];
                if (_e699 < _e56) {
                } else {
                    return;
                }
                let _e730 = marks.member[(0u + _e699)];
                let _e738 = p.member.epsilon;
                if (_e597 <= _e738) {
                    phi_1868_ = true;
                } else {
                    phi_1868_ = (_e597 >= (1f - _e738));
                }
                let _e743 = phi_1868_;
                if ((bitcast<u32>(_e597) & 2147483647u) > 2139095040u) {
                    phi_1876_ = true;
                } else {
                    phi_1876_ = !(_e743);
                }
                let _e749 = phi_1876_;
                if _e749 {
                    if (_e597 > 0f) {
                        if (_e597 < 1f) {
                            phi_1888_ = false;
                        } else {
                            phi_1888_ = true;
                        }
                        let _e753 = phi_1888_;
                        phi_1889_ = _e753;
                    } else {
                        phi_1889_ = true;
                    }
                    let _e755 = phi_1889_;
                    if _e755 {
                        phi_1893_ = 0.5f;
                    } else {
                        phi_1893_ = _e597;
                    }
                    let _e757 = phi_1893_;
                    phi_1901_ = evaluate_Verdict(_e757, true);
                } else {
                    if (_e597 > 0.5f) {
                        phi_1899_ = 1f;
                    } else {
                        phi_1899_ = 0f;
                    }
                    let _e761 = phi_1899_;
                    phi_1901_ = evaluate_Verdict(_e761, false);
                }
                let _e764 = phi_1901_;
                let _e767 = (_e764.visibility < 0.5f);
                if _e764.is_doubted {
                    phi_1924_ = evaluate_Verdict();
                    phi_1925_ = true;
                } else {
                    if _e767 {
                        phi_1911_ = 2u;
                    } else {
                        phi_1911_ = 1u;
                    }
                    let _e769 = phi_1911_;
                    if ((((((_e705 >> bitcast<u32>((((_e614 % 16u) * 2u) & 31u))) & 3u) | ((_e713 >> bitcast<u32>((((_e640 % 16u) * 2u) & 31u))) & 3u)) | (((_e722 >> bitcast<u32>((((_e666 % 16u) * 2u) & 31u))) & 3u) | ((_e730 >> bitcast<u32>((((_e692 % 16u) * 2u) & 31u))) & 3u))) & _e769) != 0u) {
                        if _e767 {
                            phi_1920_ = 0.000000059604645f;
                        } else {
                            phi_1920_ = 0.99999994f;
                        }
                        let _e773 = phi_1920_;
                        phi_1922_ = evaluate_Verdict(_e773, true);
                        phi_1923_ = false;
                    } else {
                        phi_1922_ = evaluate_Verdict();
                        phi_1923_ = true;
                    }
                    let _e776 = phi_1922_;
                    let _e778 = phi_1923_;
                    phi_1924_ = _e776;
                    phi_1925_ = _e778;
                }
                let _e780 = phi_1924_;
                let _e782 = phi_1925_;
                if _e782 {
                    phi_1930_ = evaluate_Verdict(_e764.visibility, _e764.is_doubted);
                } else {
                    phi_1930_ = _e780;
                }
                let _e785 = phi_1930_;
                phi_1935_ = evaluate_Verdict(_e785.visibility, _e785.is_doubted);
            } else {
                phi_1935_ = evaluate_Verdict(0.5f, true);
            }
            let _e791 = phi_1935_;
            phi_1936_ = _e791;
        }
        let _e793 = phi_1936_;
        if (_e62.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e62.first_primitive)] = _e793.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_msm_hausdorff_prefiltered_marks_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
