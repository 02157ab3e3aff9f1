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
    var phi_159_: lt_bvh_traverse_Tree;
    var phi_160_: bool;
    var phi_161_: lt_bvh_traverse_Tree;
    var phi_162_: bool;
    var phi_167_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_159_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_160_ = false;
        } else {
            phi_159_ = lt_bvh_traverse_Tree();
            phi_160_ = true;
        }
        let _e55 = phi_159_;
        let _e57 = phi_160_;
        phi_161_ = _e55;
        phi_162_ = _e57;
    } else {
        phi_161_ = lt_bvh_traverse_Tree();
        phi_162_ = true;
    }
    let _e59 = phi_161_;
    let _e61 = phi_162_;
    if _e61 {
        phi_167_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_167_ = _e59;
    }
    let _e66 = phi_167_;
    return lt_bvh_traverse_Tree(_e66.root, _e66.first_primitive);
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(param_4: f32, param_5: f32) -> f32 {
    var phi_181_: f32;

    if (param_4 < param_5) {
        phi_181_ = param_4;
    } else {
        phi_181_ = param_5;
    }
    let _e46 = phi_181_;
    return _e46;
}

fn lt_math_hausdorff_cubic_mass(param_6: vec4<f32>, param_7: f32, param_8: f32, param_9: f32, param_10: f32) -> f32 {
    return ((((param_6.z - (((param_8 + param_9) + param_10) * param_6.y)) + ((((param_8 * param_9) + (param_8 * param_10)) + (param_9 * param_10)) * param_6.x)) - ((param_8 * param_9) * param_10)) / (((param_7 - param_8) * (param_7 - param_9)) * (param_7 - param_10)));
}

fn lt_math_hausdorff_endpoint_upper_bound(param_11: ptr<function, hankel_HankelFactors>, param_12: f32) -> f32 {
    var phi_945_: f32;
    var phi_946_: f32;
    var phi_947_: f32;
    var phi_974_: f32;
    var phi_975_: f32;
    var phi_976_: f32;
    var phi_977_: f32;
    var phi_978_: bool;
    var phi_979_: f32;
    var phi_980_: bool;
    var phi_1008_: f32;
    var phi_1009_: f32;
    var phi_1010_: f32;
    var phi_1011_: f32;
    var phi_1012_: bool;
    var phi_1013_: f32;
    var phi_1014_: bool;
    var phi_1021_: f32;
    var phi_1022_: f32;
    var phi_1023_: f32;
    var phi_1024_: f32;

    let _e45 = (*param_11).moments;
    if (param_12 < 0.0001f) {
        phi_1024_ = 1f;
    } else {
        let _e54 = ((_e45.z - ((1f + param_12) * _e45.y)) + (param_12 * _e45.x));
        let _e63 = (((_e45.w - ((1f + param_12) * _e45.z)) + (param_12 * _e45.y)) / _e54);
        if (abs(_e54) <= 0.00000047683716f) {
            let _e77 = (1f - (((_e45.y - (_e45.x * (param_12 + 1f))) + (param_12 * 1f)) / ((0f - param_12) * (0f - 1f))));
            if ((bitcast<u32>(_e77) & 2147483647u) > 2139095040u) {
                phi_947_ = _e77;
            } else {
                if (_e77 < 0f) {
                    phi_946_ = 0f;
                } else {
                    if (_e77 > 1f) {
                        phi_945_ = 1f;
                    } else {
                        phi_945_ = _e77;
                    }
                    let _e84 = phi_945_;
                    phi_946_ = _e84;
                }
                let _e86 = phi_946_;
                phi_947_ = _e86;
            }
            let _e88 = phi_947_;
            phi_1023_ = _e88;
        } else {
            if (_e63 > 0f) {
                if (_e63 < param_12) {
                    let _e91 = lt_math_hausdorff_cubic_mass(_e45, 0f, _e63, param_12, 1f);
                    let _e93 = lt_math_hausdorff_cubic_mass(_e45, _e63, 0f, param_12, 1f);
                    let _e94 = ((1f - _e91) - _e93);
                    if ((bitcast<u32>(_e94) & 2147483647u) > 2139095040u) {
                        phi_976_ = _e94;
                    } else {
                        if (_e94 < 0f) {
                            phi_975_ = 0f;
                        } else {
                            if (_e94 > 1f) {
                                phi_974_ = 1f;
                            } else {
                                phi_974_ = _e94;
                            }
                            let _e101 = phi_974_;
                            phi_975_ = _e101;
                        }
                        let _e103 = phi_975_;
                        phi_976_ = _e103;
                    }
                    let _e105 = phi_976_;
                    phi_977_ = _e105;
                    phi_978_ = false;
                } else {
                    phi_977_ = f32();
                    phi_978_ = true;
                }
                let _e107 = phi_977_;
                let _e109 = phi_978_;
                phi_979_ = _e107;
                phi_980_ = _e109;
            } else {
                phi_979_ = f32();
                phi_980_ = true;
            }
            let _e111 = phi_979_;
            let _e113 = phi_980_;
            if _e113 {
                if (_e63 > param_12) {
                    if (_e63 < 1f) {
                        let _e116 = lt_math_hausdorff_cubic_mass(_e45, 0f, _e63, param_12, 1f);
                        let _e117 = (1f - _e116);
                        if ((bitcast<u32>(_e117) & 2147483647u) > 2139095040u) {
                            phi_1010_ = _e117;
                        } else {
                            if (_e117 < 0f) {
                                phi_1009_ = 0f;
                            } else {
                                if (_e117 > 1f) {
                                    phi_1008_ = 1f;
                                } else {
                                    phi_1008_ = _e117;
                                }
                                let _e124 = phi_1008_;
                                phi_1009_ = _e124;
                            }
                            let _e126 = phi_1009_;
                            phi_1010_ = _e126;
                        }
                        let _e128 = phi_1010_;
                        phi_1011_ = _e128;
                        phi_1012_ = false;
                    } else {
                        phi_1011_ = f32();
                        phi_1012_ = true;
                    }
                    let _e130 = phi_1011_;
                    let _e132 = phi_1012_;
                    phi_1013_ = _e130;
                    phi_1014_ = _e132;
                } else {
                    phi_1013_ = f32();
                    phi_1014_ = true;
                }
                let _e134 = phi_1013_;
                let _e136 = phi_1014_;
                if _e136 {
                    phi_1021_ = bitcast<f32>((bitcast<u32>(_e63) | 2143289344u));
                } else {
                    phi_1021_ = _e134;
                }
                let _e141 = phi_1021_;
                phi_1022_ = _e141;
            } else {
                phi_1022_ = _e111;
            }
            let _e143 = phi_1022_;
            phi_1023_ = _e143;
        }
        let _e145 = phi_1023_;
        phi_1024_ = _e145;
    }
    let _e147 = phi_1024_;
    return _e147;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_13: ptr<function, f32>, param_14: vec4<f32>, param_15: f32) -> f32 {
    var local: hankel_HankelFactors;
    var phi_232_: f32;
    var phi_233_: f32;
    var phi_234_: f32;
    var phi_246_: bool;
    var phi_261_: bool;
    var phi_286_: f32;
    var phi_287_: f32;
    var phi_288_: f32;
    var phi_289_: f32;
    var phi_290_: bool;
    var phi_291_: f32;
    var phi_292_: bool;
    var phi_348_: vec2<f32>;
    var phi_386_: f32;
    var phi_387_: f32;
    var phi_388_: f32;
    var phi_421_: f32;
    var phi_422_: f32;
    var phi_423_: f32;
    var phi_427_: f32;
    var phi_428_: f32;
    var phi_429_: f32;
    var phi_430_: f32;
    var phi_483_: vec2<f32>;
    var phi_505_: bool;
    var phi_530_: f32;
    var phi_531_: f32;
    var phi_532_: f32;
    var phi_533_: f32;
    var phi_534_: bool;
    var phi_535_: f32;
    var phi_536_: bool;
    var phi_592_: vec2<f32>;
    var phi_630_: f32;
    var phi_631_: f32;
    var phi_632_: f32;
    var phi_665_: f32;
    var phi_666_: f32;
    var phi_667_: f32;
    var phi_671_: f32;
    var phi_672_: f32;
    var phi_673_: f32;
    var phi_674_: f32;
    var phi_675_: f32;
    var phi_676_: bool;
    var phi_677_: f32;
    var phi_678_: bool;
    var phi_700_: bool;
    var phi_725_: f32;
    var phi_726_: f32;
    var phi_727_: f32;
    var phi_728_: f32;
    var phi_729_: bool;
    var phi_730_: f32;
    var phi_731_: bool;
    var phi_787_: vec2<f32>;
    var phi_825_: f32;
    var phi_826_: f32;
    var phi_827_: f32;
    var phi_860_: f32;
    var phi_861_: f32;
    var phi_862_: f32;
    var phi_866_: f32;
    var phi_867_: f32;
    var phi_868_: f32;
    var phi_869_: f32;
    var phi_880_: bool;
    var phi_884_: f32;
    var phi_885_: f32;
    var phi_886_: f32;
    var phi_887_: f32;

    let _e46 = (*param_13);
    let _e47 = (1f - _e46);
    let _e56 = (0.5f * _e46);
    let _e57 = ((param_14.x * _e47) + _e56);
    let _e58 = ((param_14.y * _e47) + _e56);
    let _e59 = ((param_14.z * _e47) + _e56);
    let _e60 = ((param_14.w * _e47) + _e56);
    let _e63 = (_e58 - (_e57 * _e57));
    let _e65 = (_e59 - (_e57 * _e58));
    let _e71 = hankel_HankelFactors(vec4<f32>(_e57, _e58, _e59, _e60), _e63, _e65, (((_e60 - (_e58 * _e58)) * _e63) - (_e65 * _e65)));
    local = hankel_HankelFactors(_e71.moments, _e71.d22_, _e71.l32_d22_, _e71.d33_d22_);
    if ((bitcast<u32>(param_15) & 2147483647u) > 2139095040u) {
        phi_234_ = param_15;
    } else {
        if (param_15 < 0f) {
            phi_233_ = 0f;
        } else {
            if (param_15 > 1f) {
                phi_232_ = 1f;
            } else {
                phi_232_ = param_15;
            }
            let _e83 = phi_232_;
            phi_233_ = _e83;
        }
        let _e85 = phi_233_;
        phi_234_ = _e85;
    }
    let _e87 = phi_234_;
    let _e90 = local.moments[0u];
    let _e93 = local.moments[3u];
    if (_e90 == _e93) {
        let _e97 = local.moments[0u];
        phi_246_ = (_e97 > 0.5f);
    } else {
        phi_246_ = false;
    }
    let _e100 = phi_246_;
    if _e100 {
        let _e103 = local.moments[0u];
        let _e106 = local.moments[3u];
        if (_e103 == _e106) {
            let _e110 = local.moments[0u];
            phi_261_ = (_e110 > 0.5f);
        } else {
            phi_261_ = false;
        }
        let _e113 = phi_261_;
        if _e113 {
            if (_e87 > 0f) {
                let _e116 = local.moments;
                if ((bitcast<u32>(_e116.x) & 2147483647u) > 2139095040u) {
                    phi_288_ = _e116.x;
                } else {
                    if (_e116.x < 0f) {
                        phi_287_ = 0f;
                    } else {
                        if (_e116.x > 1f) {
                            phi_286_ = 1f;
                        } else {
                            phi_286_ = _e116.x;
                        }
                        let _e124 = phi_286_;
                        phi_287_ = _e124;
                    }
                    let _e126 = phi_287_;
                    phi_288_ = _e126;
                }
                let _e128 = phi_288_;
                phi_289_ = _e128;
                phi_290_ = false;
            } else {
                phi_289_ = f32();
                phi_290_ = true;
            }
            let _e130 = phi_289_;
            let _e132 = phi_290_;
            phi_291_ = _e130;
            phi_292_ = _e132;
        } else {
            phi_291_ = f32();
            phi_292_ = true;
        }
        let _e134 = phi_291_;
        let _e136 = phi_292_;
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
                phi_348_ = vec2<f32>((-(_e175) - _e180), (-(_e175) + _e180));
            } else {
                phi_348_ = vec2(bitcast<f32>((bitcast<u32>(_e178) | 2143289344u)));
            }
            let _e191 = phi_348_;
            if (_e87 <= _e191.x) {
                phi_429_ = 1f;
            } else {
                if (_e87 > _e191.y) {
                    let _e197 = local.moments;
                    let _e208 = (((_e197.y - (_e197.x * (_e191.x + _e191.y))) + (_e191.x * _e191.y)) / ((_e87 - _e191.x) * (_e87 - _e191.y)));
                    if ((bitcast<u32>(_e208) & 2147483647u) > 2139095040u) {
                        phi_388_ = _e208;
                    } else {
                        if (_e208 < 0f) {
                            phi_387_ = 0f;
                        } else {
                            if (_e208 > 1f) {
                                phi_386_ = 1f;
                            } else {
                                phi_386_ = _e208;
                            }
                            let _e215 = phi_386_;
                            phi_387_ = _e215;
                        }
                        let _e217 = phi_387_;
                        phi_388_ = _e217;
                    }
                    let _e219 = phi_388_;
                    phi_428_ = _e219;
                } else {
                    if (_e87 > _e191.x) {
                        let _e222 = local.moments;
                        let _e234 = (1f - (((_e222.y - (_e222.x * (_e87 + _e191.y))) + (_e87 * _e191.y)) / ((_e191.x - _e87) * (_e191.x - _e191.y))));
                        if ((bitcast<u32>(_e234) & 2147483647u) > 2139095040u) {
                            phi_423_ = _e234;
                        } else {
                            if (_e234 < 0f) {
                                phi_422_ = 0f;
                            } else {
                                if (_e234 > 1f) {
                                    phi_421_ = 1f;
                                } else {
                                    phi_421_ = _e234;
                                }
                                let _e241 = phi_421_;
                                phi_422_ = _e241;
                            }
                            let _e243 = phi_422_;
                            phi_423_ = _e243;
                        }
                        let _e245 = phi_423_;
                        phi_427_ = _e245;
                    } else {
                        phi_427_ = bitcast<f32>((bitcast<u32>(_e191.x) | 2143289344u));
                    }
                    let _e250 = phi_427_;
                    phi_428_ = _e250;
                }
                let _e252 = phi_428_;
                phi_429_ = _e252;
            }
            let _e254 = phi_429_;
            phi_430_ = _e254;
        } else {
            phi_430_ = _e134;
        }
        let _e256 = phi_430_;
        phi_887_ = _e256;
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
            phi_483_ = vec2<f32>((-(_e295) - _e300), (-(_e295) + _e300));
        } else {
            phi_483_ = vec2(bitcast<f32>((bitcast<u32>(_e298) | 2143289344u)));
        }
        let _e311 = phi_483_;
        if (_e311.x >= 0f) {
            if (_e311.y <= 1f) {
                let _e318 = local.moments[0u];
                let _e321 = local.moments[3u];
                if (_e318 == _e321) {
                    let _e325 = local.moments[0u];
                    phi_505_ = (_e325 > 0.5f);
                } else {
                    phi_505_ = false;
                }
                let _e328 = phi_505_;
                if _e328 {
                    if (_e87 > 0f) {
                        let _e331 = local.moments;
                        if ((bitcast<u32>(_e331.x) & 2147483647u) > 2139095040u) {
                            phi_532_ = _e331.x;
                        } else {
                            if (_e331.x < 0f) {
                                phi_531_ = 0f;
                            } else {
                                if (_e331.x > 1f) {
                                    phi_530_ = 1f;
                                } else {
                                    phi_530_ = _e331.x;
                                }
                                let _e339 = phi_530_;
                                phi_531_ = _e339;
                            }
                            let _e341 = phi_531_;
                            phi_532_ = _e341;
                        }
                        let _e343 = phi_532_;
                        phi_533_ = _e343;
                        phi_534_ = false;
                    } else {
                        phi_533_ = f32();
                        phi_534_ = true;
                    }
                    let _e345 = phi_533_;
                    let _e347 = phi_534_;
                    phi_535_ = _e345;
                    phi_536_ = _e347;
                } else {
                    phi_535_ = f32();
                    phi_536_ = true;
                }
                let _e349 = phi_535_;
                let _e351 = phi_536_;
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
                        phi_592_ = vec2<f32>((-(_e390) - _e395), (-(_e390) + _e395));
                    } else {
                        phi_592_ = vec2(bitcast<f32>((bitcast<u32>(_e393) | 2143289344u)));
                    }
                    let _e406 = phi_592_;
                    if (_e87 <= _e406.x) {
                        phi_673_ = 1f;
                    } else {
                        if (_e87 > _e406.y) {
                            let _e412 = local.moments;
                            let _e423 = (((_e412.y - (_e412.x * (_e406.x + _e406.y))) + (_e406.x * _e406.y)) / ((_e87 - _e406.x) * (_e87 - _e406.y)));
                            if ((bitcast<u32>(_e423) & 2147483647u) > 2139095040u) {
                                phi_632_ = _e423;
                            } else {
                                if (_e423 < 0f) {
                                    phi_631_ = 0f;
                                } else {
                                    if (_e423 > 1f) {
                                        phi_630_ = 1f;
                                    } else {
                                        phi_630_ = _e423;
                                    }
                                    let _e430 = phi_630_;
                                    phi_631_ = _e430;
                                }
                                let _e432 = phi_631_;
                                phi_632_ = _e432;
                            }
                            let _e434 = phi_632_;
                            phi_672_ = _e434;
                        } else {
                            if (_e87 > _e406.x) {
                                let _e437 = local.moments;
                                let _e449 = (1f - (((_e437.y - (_e437.x * (_e87 + _e406.y))) + (_e87 * _e406.y)) / ((_e406.x - _e87) * (_e406.x - _e406.y))));
                                if ((bitcast<u32>(_e449) & 2147483647u) > 2139095040u) {
                                    phi_667_ = _e449;
                                } else {
                                    if (_e449 < 0f) {
                                        phi_666_ = 0f;
                                    } else {
                                        if (_e449 > 1f) {
                                            phi_665_ = 1f;
                                        } else {
                                            phi_665_ = _e449;
                                        }
                                        let _e456 = phi_665_;
                                        phi_666_ = _e456;
                                    }
                                    let _e458 = phi_666_;
                                    phi_667_ = _e458;
                                }
                                let _e460 = phi_667_;
                                phi_671_ = _e460;
                            } else {
                                phi_671_ = bitcast<f32>((bitcast<u32>(_e406.x) | 2143289344u));
                            }
                            let _e465 = phi_671_;
                            phi_672_ = _e465;
                        }
                        let _e467 = phi_672_;
                        phi_673_ = _e467;
                    }
                    let _e469 = phi_673_;
                    phi_674_ = _e469;
                } else {
                    phi_674_ = _e349;
                }
                let _e471 = phi_674_;
                phi_675_ = _e471;
                phi_676_ = false;
            } else {
                phi_675_ = f32();
                phi_676_ = true;
            }
            let _e473 = phi_675_;
            let _e475 = phi_676_;
            phi_677_ = _e473;
            phi_678_ = _e475;
        } else {
            phi_677_ = f32();
            phi_678_ = true;
        }
        let _e477 = phi_677_;
        let _e479 = phi_678_;
        if _e479 {
            if ((bitcast<u32>(_e311.x) & 2147483647u) > 2139095040u) {
                phi_885_ = _e311.x;
            } else {
                let _e483 = lt_math_hausdorff_endpoint_upper_bound((&local), _e87);
                let _e486 = local.moments[0u];
                let _e489 = local.moments[3u];
                if (_e486 == _e489) {
                    let _e493 = local.moments[0u];
                    phi_700_ = (_e493 > 0.5f);
                } else {
                    phi_700_ = false;
                }
                let _e496 = phi_700_;
                if _e496 {
                    if (_e87 > 0f) {
                        let _e499 = local.moments;
                        if ((bitcast<u32>(_e499.x) & 2147483647u) > 2139095040u) {
                            phi_727_ = _e499.x;
                        } else {
                            if (_e499.x < 0f) {
                                phi_726_ = 0f;
                            } else {
                                if (_e499.x > 1f) {
                                    phi_725_ = 1f;
                                } else {
                                    phi_725_ = _e499.x;
                                }
                                let _e507 = phi_725_;
                                phi_726_ = _e507;
                            }
                            let _e509 = phi_726_;
                            phi_727_ = _e509;
                        }
                        let _e511 = phi_727_;
                        phi_728_ = _e511;
                        phi_729_ = false;
                    } else {
                        phi_728_ = f32();
                        phi_729_ = true;
                    }
                    let _e513 = phi_728_;
                    let _e515 = phi_729_;
                    phi_730_ = _e513;
                    phi_731_ = _e515;
                } else {
                    phi_730_ = f32();
                    phi_731_ = true;
                }
                let _e517 = phi_730_;
                let _e519 = phi_731_;
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
                        phi_787_ = vec2<f32>((-(_e558) - _e563), (-(_e558) + _e563));
                    } else {
                        phi_787_ = vec2(bitcast<f32>((bitcast<u32>(_e561) | 2143289344u)));
                    }
                    let _e574 = phi_787_;
                    if (_e87 <= _e574.x) {
                        phi_868_ = 1f;
                    } else {
                        if (_e87 > _e574.y) {
                            let _e580 = local.moments;
                            let _e591 = (((_e580.y - (_e580.x * (_e574.x + _e574.y))) + (_e574.x * _e574.y)) / ((_e87 - _e574.x) * (_e87 - _e574.y)));
                            if ((bitcast<u32>(_e591) & 2147483647u) > 2139095040u) {
                                phi_827_ = _e591;
                            } else {
                                if (_e591 < 0f) {
                                    phi_826_ = 0f;
                                } else {
                                    if (_e591 > 1f) {
                                        phi_825_ = 1f;
                                    } else {
                                        phi_825_ = _e591;
                                    }
                                    let _e598 = phi_825_;
                                    phi_826_ = _e598;
                                }
                                let _e600 = phi_826_;
                                phi_827_ = _e600;
                            }
                            let _e602 = phi_827_;
                            phi_867_ = _e602;
                        } else {
                            if (_e87 > _e574.x) {
                                let _e605 = local.moments;
                                let _e617 = (1f - (((_e605.y - (_e605.x * (_e87 + _e574.y))) + (_e87 * _e574.y)) / ((_e574.x - _e87) * (_e574.x - _e574.y))));
                                if ((bitcast<u32>(_e617) & 2147483647u) > 2139095040u) {
                                    phi_862_ = _e617;
                                } else {
                                    if (_e617 < 0f) {
                                        phi_861_ = 0f;
                                    } else {
                                        if (_e617 > 1f) {
                                            phi_860_ = 1f;
                                        } else {
                                            phi_860_ = _e617;
                                        }
                                        let _e624 = phi_860_;
                                        phi_861_ = _e624;
                                    }
                                    let _e626 = phi_861_;
                                    phi_862_ = _e626;
                                }
                                let _e628 = phi_862_;
                                phi_866_ = _e628;
                            } else {
                                phi_866_ = bitcast<f32>((bitcast<u32>(_e574.x) | 2143289344u));
                            }
                            let _e633 = phi_866_;
                            phi_867_ = _e633;
                        }
                        let _e635 = phi_867_;
                        phi_868_ = _e635;
                    }
                    let _e637 = phi_868_;
                    phi_869_ = _e637;
                } else {
                    phi_869_ = _e517;
                }
                let _e639 = phi_869_;
                if ((bitcast<u32>(_e639) & 2147483647u) > 2139095040u) {
                    phi_880_ = true;
                } else {
                    let _e643 = (_e639 < _e483);
                    if _e643 {
                    }
                    phi_880_ = _e643;
                }
                let _e645 = phi_880_;
                if _e645 {
                    phi_884_ = _e639;
                } else {
                    phi_884_ = _e483;
                }
                let _e647 = phi_884_;
                phi_885_ = _e647;
            }
            let _e649 = phi_885_;
            phi_886_ = _e649;
        } else {
            phi_886_ = _e477;
        }
        let _e651 = phi_886_;
        phi_887_ = _e651;
    }
    let _e653 = phi_887_;
    return _e653;
}

fn function_() {
    var local_1: f32;
    var phi_1114_: bool;
    var phi_1115_: bool;
    var phi_1116_: bool;
    var phi_1117_: bool;
    var phi_1121_: bool;
    var phi_1165_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1169_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1189_: lt_math_LightPoint;
    var phi_1192_: u32;
    var phi_1194_: lt_math_LevelPoint;
    var phi_1280_: bool;
    var phi_1289_: bool;
    var phi_1298_: bool;
    var phi_1299_: bool;
    var phi_1300_: bool;
    var phi_1301_: bool;
    var phi_1302_: bool;
    var phi_1303_: bool;
    var phi_1304_: bool;
    var phi_1308_: bool;
    var phi_1335_: bool;
    var phi_1336_: bool;
    var phi_1337_: bool;
    var phi_1338_: bool;
    var phi_1339_: bool;
    var phi_1340_: bool;
    var phi_1341_: bool;
    var phi_1342_: bool;
    var phi_1346_: bool;
    var phi_1355_: lt_math_LightPoint;
    var phi_1356_: u32;
    var phi_1357_: lt_math_LevelPoint;
    var phi_1358_: bool;
    var phi_1190_: lt_math_LightPoint;
    var phi_1193_: u32;
    var phi_1195_: lt_math_LevelPoint;
    var phi_1359_: bool;
    var local_2: lt_math_LevelPoint;
    var local_3: lt_math_LevelPoint;
    var phi_1399_: bool;
    var phi_1400_: bool;
    var phi_1401_: bool;
    var phi_1402_: bool;
    var phi_1406_: bool;
    var phi_1488_: f32;
    var phi_1604_: f32;
    var phi_1605_: f32;
    var phi_1608_: f32;
    var phi_1637_: f32;
    var phi_1642_: f32;
    var phi_1643_: bool;
    var phi_1644_: f32;
    var phi_1645_: bool;
    var phi_1649_: f32;
    var phi_1669_: f32;
    var phi_1674_: f32;
    var phi_1675_: bool;
    var phi_1676_: f32;
    var phi_1677_: bool;
    var phi_1681_: f32;
    var local_4: lt_math_LevelPoint;
    var phi_1730_: i32;
    var phi_1735_: i32;
    var phi_1740_: i32;
    var phi_1745_: i32;
    var phi_1754_: i32;
    var phi_1759_: i32;
    var phi_1764_: i32;
    var phi_1769_: i32;
    var local_5: lt_math_LevelPoint;
    var phi_1885_: f32;
    var phi_1887_: evaluate_Verdict;
    var phi_1888_: bool;
    var phi_1889_: evaluate_Verdict;
    var phi_1890_: bool;
    var phi_1895_: evaluate_Verdict;
    var phi_1896_: bool;
    var phi_1898_: evaluate_Verdict;
    var phi_1899_: evaluate_Verdict;
    var phi_1900_: bool;
    var phi_1904_: evaluate_Verdict;
    var phi_1905_: evaluate_Verdict;
    var phi_1906_: bool;
    var phi_1910_: evaluate_Verdict;

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
        let _e73 = p.member.light;
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
            let _e102 = samples.member[(0u + _e62.first_primitive)].normal;
            let _e104 = samples.member[(0u + _e62.first_primitive)].position;
            if ((((_e102.x * (_e73.x - (_e104.x * _e73.w))) + (_e102.y * (_e73.y - (_e104.y * _e73.w)))) + (_e102.z * (_e73.z - (_e104.z * _e73.w)))) > 0f) {
                let _e128 = samples.member[(0u + _e62.first_primitive)].flags;
                let _e136 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e142 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e136.unnamed.visibility, false), _e136.unnamed_1);
                phi_1165_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e142.unnamed, ((_e128 & 1u) == 0u));
            } else {
                let _e151 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e157 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e151.unnamed.visibility, false), _e151.unnamed_1);
                phi_1165_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e157.unnamed, true);
            }
            let _e162 = phi_1165_;
            phi_1169_ = _e162;
        } else {
            let _e168 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e174 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e168.unnamed.visibility, false), _e168.unnamed_1);
            phi_1169_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e174.unnamed, true);
        }
        let _e179 = phi_1169_;
        if _e179.unnamed_1 {
            phi_1904_ = evaluate_Verdict(_e179.unnamed.visibility, _e179.unnamed.is_doubted);
            phi_1905_ = evaluate_Verdict();
            phi_1906_ = true;
        } else {
            let _e187 = samples.member[(0u + _e62.first_primitive)].position;
            let _e189 = p.member.map_size;
            let _e191 = (0.5f / f32(_e189));
            let _e198 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e205 = lt_math_LightPoint(vec2<f32>(_e198.uv.x, 0f), _e198.depth, _e198.is_inside);
            let _e209 = lt_math_LightPoint(_e205.uv, 0f, _e205.is_inside);
            phi_1189_ = lt_math_LightPoint();
            phi_1192_ = 0u;
            phi_1194_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e209.uv, _e209.depth, false));
            loop {
                let _e216 = phi_1189_;
                let _e218 = phi_1192_;
                let _e220 = phi_1194_;
                local_2 = _e220;
                local_3 = _e220;
                local_4 = _e220;
                local_5 = _e220;
                if (_e218 < _e68) {
                    if _e220.point.is_inside {
                        phi_1355_ = lt_math_LightPoint();
                        phi_1356_ = u32();
                        phi_1357_ = lt_math_LevelPoint();
                        phi_1358_ = false;
                    } else {
                        if (_e218 < _e56) {
                        } else {
                            return;
                        }
                        let _e231 = levels.member[(0u + _e218)].row_w;
                        let _e242 = ((((_e231.x * _e187.x) + (_e231.y * _e187.y)) + (_e231.z * _e187.z)) + (_e231.w * 1f));
                        let _e244 = levels.member[(0u + _e218)].row_x;
                        let _e256 = (((((_e244.x * _e187.x) + (_e244.y * _e187.y)) + (_e244.z * _e187.z)) + (_e244.w * 1f)) / _e242);
                        let _e258 = levels.member[(0u + _e218)].row_y;
                        let _e270 = (((((_e258.x * _e187.x) + (_e258.y * _e187.y)) + (_e258.z * _e187.z)) + (_e258.w * 1f)) / _e242);
                        let _e272 = levels.member[(0u + _e218)].row_z;
                        let _e283 = ((((_e272.x * _e187.x) + (_e272.y * _e187.y)) + (_e272.z * _e187.z)) + (_e272.w * 1f));
                        if (_e242 > 0f) {
                            if (_e256 >= 0f) {
                                phi_1280_ = (_e256 <= 1f);
                            } else {
                                phi_1280_ = false;
                            }
                            let _e288 = phi_1280_;
                            if _e288 {
                                if (_e270 >= 0f) {
                                    phi_1289_ = (_e270 <= 1f);
                                } else {
                                    phi_1289_ = false;
                                }
                                let _e292 = phi_1289_;
                                if _e292 {
                                    if (_e283 >= 0f) {
                                        phi_1298_ = (_e283 <= 1f);
                                    } else {
                                        phi_1298_ = false;
                                    }
                                    let _e296 = phi_1298_;
                                    phi_1299_ = _e296;
                                    phi_1300_ = false;
                                } else {
                                    phi_1299_ = bool();
                                    phi_1300_ = true;
                                }
                                let _e298 = phi_1299_;
                                let _e300 = phi_1300_;
                                phi_1301_ = _e298;
                                phi_1302_ = _e300;
                            } else {
                                phi_1301_ = bool();
                                phi_1302_ = true;
                            }
                            let _e302 = phi_1301_;
                            let _e304 = phi_1302_;
                            phi_1303_ = _e302;
                            phi_1304_ = _e304;
                        } else {
                            phi_1303_ = bool();
                            phi_1304_ = true;
                        }
                        let _e306 = phi_1303_;
                        let _e308 = phi_1304_;
                        if _e308 {
                            phi_1308_ = false;
                        } else {
                            phi_1308_ = _e306;
                        }
                        let _e310 = phi_1308_;
                        if _e310 {
                            if (_e256 >= _e191) {
                                if (_e256 <= (1f - _e191)) {
                                    if (_e270 >= _e191) {
                                        phi_1335_ = (_e270 <= (1f - _e191));
                                        phi_1336_ = false;
                                    } else {
                                        phi_1335_ = bool();
                                        phi_1336_ = true;
                                    }
                                    let _e318 = phi_1335_;
                                    let _e320 = phi_1336_;
                                    phi_1337_ = _e318;
                                    phi_1338_ = _e320;
                                } else {
                                    phi_1337_ = bool();
                                    phi_1338_ = true;
                                }
                                let _e322 = phi_1337_;
                                let _e324 = phi_1338_;
                                phi_1339_ = _e322;
                                phi_1340_ = _e324;
                            } else {
                                phi_1339_ = bool();
                                phi_1340_ = true;
                            }
                            let _e326 = phi_1339_;
                            let _e328 = phi_1340_;
                            phi_1341_ = _e326;
                            phi_1342_ = _e328;
                        } else {
                            phi_1341_ = bool();
                            phi_1342_ = true;
                        }
                        let _e330 = phi_1341_;
                        let _e332 = phi_1342_;
                        if _e332 {
                            phi_1346_ = false;
                        } else {
                            phi_1346_ = _e330;
                        }
                        let _e334 = phi_1346_;
                        let _e341 = lt_math_LightPoint(vec2<f32>(_e256, _e216.uv.y), _e216.depth, _e216.is_inside);
                        let _e348 = lt_math_LightPoint(vec2<f32>(_e341.uv.x, _e270), _e341.depth, _e341.is_inside);
                        let _e352 = lt_math_LightPoint(_e348.uv, _e283, _e348.is_inside);
                        let _e356 = lt_math_LightPoint(_e352.uv, _e352.depth, _e334);
                        phi_1355_ = _e356;
                        phi_1356_ = (_e218 + 1u);
                        phi_1357_ = lt_math_LevelPoint(_e218, _e356);
                        phi_1358_ = true;
                    }
                    let _e360 = phi_1355_;
                    let _e362 = phi_1356_;
                    let _e364 = phi_1357_;
                    let _e366 = phi_1358_;
                    phi_1190_ = _e360;
                    phi_1193_ = _e362;
                    phi_1195_ = _e364;
                    phi_1359_ = _e366;
                } else {
                    phi_1190_ = lt_math_LightPoint();
                    phi_1193_ = u32();
                    phi_1195_ = lt_math_LevelPoint();
                    phi_1359_ = false;
                }
                let _e368 = phi_1190_;
                let _e370 = phi_1193_;
                let _e372 = phi_1195_;
                let _e374 = phi_1359_;
                continue;
                continuing {
                    phi_1189_ = _e368;
                    phi_1192_ = _e370;
                    phi_1194_ = _e372;
                    break if !(_e374);
                }
            }
            let _e377 = local_2;
            if _e377.point.is_inside {
                if (0f > 0f) {
                    let _e383 = local_3;
                    if (_e383.level < _e56) {
                    } else {
                        return;
                    }
                    let _e388 = levels.member[(0u + _e383.level)];
                    let _e394 = global[0u];
                    if (_e388.row_w.x == _e394) {
                        let _e397 = global[1u];
                        if (_e388.row_w.y == _e397) {
                            let _e400 = global[2u];
                            phi_1399_ = (_e388.row_w.z == _e400);
                            phi_1400_ = false;
                        } else {
                            phi_1399_ = bool();
                            phi_1400_ = true;
                        }
                        let _e403 = phi_1399_;
                        let _e405 = phi_1400_;
                        phi_1401_ = _e403;
                        phi_1402_ = _e405;
                    } else {
                        phi_1401_ = bool();
                        phi_1402_ = true;
                    }
                    let _e407 = phi_1401_;
                    let _e409 = phi_1402_;
                    if _e409 {
                        phi_1406_ = false;
                    } else {
                        phi_1406_ = _e407;
                    }
                    let _e411 = phi_1406_;
                    if _e411 {
                        let _e413 = samples.member[(0u + _e62.first_primitive)].normal;
                        let _e415 = p.member.map_size;
                        let _e485 = ((abs(((((_e388.row_x.x * _e413.x) + (_e388.row_x.y * _e413.y)) + (_e388.row_x.z * _e413.z)) / (((_e388.row_x.x * _e388.row_x.x) + (_e388.row_x.y * _e388.row_x.y)) + (_e388.row_x.z * _e388.row_x.z)))) + abs(((((_e388.row_y.x * _e413.x) + (_e388.row_y.y * _e413.y)) + (_e388.row_y.z * _e413.z)) / (((_e388.row_y.x * _e388.row_y.x) + (_e388.row_y.y * _e388.row_y.y)) + (_e388.row_y.z * _e388.row_y.z))))) / (abs(((((_e388.row_z.x * _e413.x) + (_e388.row_z.y * _e413.y)) + (_e388.row_z.z * _e413.z)) / (((_e388.row_z.x * _e388.row_z.x) + (_e388.row_z.y * _e388.row_z.y)) + (_e388.row_z.z * _e388.row_z.z)))) * f32(_e415)));
                        if (_e485 < 0.002f) {
                            phi_1488_ = _e485;
                        } else {
                            phi_1488_ = 0.002f;
                        }
                        let _e488 = phi_1488_;
                        phi_1605_ = _e488;
                    } else {
                        let _e490 = p.member.map_size;
                        let _e496 = samples.member[(0u + _e62.first_primitive)].position;
                        let _e507 = ((((_e388.row_w.x * _e496.x) + (_e388.row_w.y * _e496.y)) + (_e388.row_w.z * _e496.z)) + _e388.row_w.w);
                        let _e520 = ((_e388.row_x.x - (_e388.row_w.x * _e377.point.uv.x)) / _e507);
                        let _e521 = ((_e388.row_x.y - (_e388.row_w.y * _e377.point.uv.x)) / _e507);
                        let _e522 = ((_e388.row_x.z - (_e388.row_w.z * _e377.point.uv.x)) / _e507);
                        let _e535 = ((_e388.row_y.x - (_e388.row_w.x * _e377.point.uv.y)) / _e507);
                        let _e536 = ((_e388.row_y.y - (_e388.row_w.y * _e377.point.uv.y)) / _e507);
                        let _e537 = ((_e388.row_y.z - (_e388.row_w.z * _e377.point.uv.y)) / _e507);
                        let _e543 = samples.member[(0u + _e62.first_primitive)].normal;
                        let _e548 = ((_e536 * _e543.z) - (_e543.y * _e537));
                        let _e553 = ((_e537 * _e543.x) - (_e543.z * _e535));
                        let _e558 = ((_e535 * _e543.y) - (_e543.x * _e536));
                        let _e560 = samples.member[(0u + _e62.first_primitive)].normal;
                        let _e565 = ((_e521 * _e560.z) - (_e560.y * _e522));
                        let _e570 = ((_e522 * _e560.x) - (_e560.z * _e520));
                        let _e575 = ((_e520 * _e560.y) - (_e560.x * _e521));
                        let _e602 = ((abs(((((_e388.row_z.x * _e548) + (_e388.row_z.y * _e553)) + (_e388.row_z.z * _e558)) / (((_e520 * _e548) + (_e521 * _e553)) + (_e522 * _e558)))) + abs(((((_e388.row_z.x * _e565) + (_e388.row_z.y * _e570)) + (_e388.row_z.z * _e575)) / (((_e535 * _e565) + (_e536 * _e570)) + (_e537 * _e575))))) / f32(_e490));
                        if (_e602 < 0.002f) {
                            phi_1604_ = _e602;
                        } else {
                            phi_1604_ = 0.002f;
                        }
                        let _e605 = phi_1604_;
                        phi_1605_ = _e605;
                    }
                    let _e607 = phi_1605_;
                    phi_1608_ = (_e377.point.depth - (0f * _e607));
                } else {
                    phi_1608_ = _e377.point.depth;
                }
                let _e611 = phi_1608_;
                let _e617 = p.member.map_size;
                let _e618 = f32(_e617);
                let _e621 = ((_e377.point.uv.x * _e618) - 0.5f);
                let _e622 = ((_e377.point.uv.y * _e618) - 0.5f);
                if (_e621 > -8388608f) {
                    let _e634 = f32(select(0i, select(select(i32(_e621), i32(-2147483648), (_e621 < bitcast<f32>(3472883712u))), 2147483647i, (_e621 > bitcast<f32>(1325400063u))), (_e621 == _e621)));
                    if (_e634 > _e621) {
                        phi_1637_ = 1f;
                    } else {
                        phi_1637_ = 0f;
                    }
                    let _e637 = phi_1637_;
                    if (_e621 < 8388608f) {
                        phi_1642_ = (_e634 - _e637);
                        phi_1643_ = false;
                    } else {
                        phi_1642_ = f32();
                        phi_1643_ = true;
                    }
                    let _e640 = phi_1642_;
                    let _e642 = phi_1643_;
                    phi_1644_ = _e640;
                    phi_1645_ = _e642;
                } else {
                    phi_1644_ = f32();
                    phi_1645_ = true;
                }
                let _e644 = phi_1644_;
                let _e646 = phi_1645_;
                if _e646 {
                    phi_1649_ = _e621;
                } else {
                    phi_1649_ = _e644;
                }
                let _e648 = phi_1649_;
                if (_e622 > -8388608f) {
                    let _e660 = f32(select(0i, select(select(i32(_e622), i32(-2147483648), (_e622 < bitcast<f32>(3472883712u))), 2147483647i, (_e622 > bitcast<f32>(1325400063u))), (_e622 == _e622)));
                    if (_e660 > _e622) {
                        phi_1669_ = 1f;
                    } else {
                        phi_1669_ = 0f;
                    }
                    let _e663 = phi_1669_;
                    if (_e622 < 8388608f) {
                        phi_1674_ = (_e660 - _e663);
                        phi_1675_ = false;
                    } else {
                        phi_1674_ = f32();
                        phi_1675_ = true;
                    }
                    let _e666 = phi_1674_;
                    let _e668 = phi_1675_;
                    phi_1676_ = _e666;
                    phi_1677_ = _e668;
                } else {
                    phi_1676_ = f32();
                    phi_1677_ = true;
                }
                let _e670 = phi_1676_;
                let _e672 = phi_1677_;
                if _e672 {
                    phi_1681_ = _e622;
                } else {
                    phi_1681_ = _e670;
                }
                let _e674 = phi_1681_;
                let _e675 = (_e621 - _e648);
                let _e676 = (_e622 - _e674);
                let _e685 = select(0i, select(select(i32(_e648), i32(-2147483648), (_e648 < bitcast<f32>(3472883712u))), 2147483647i, (_e648 > bitcast<f32>(1325400063u))), (_e648 == _e648));
                let _e694 = select(0i, select(select(i32(_e674), i32(-2147483648), (_e674 < bitcast<f32>(3472883712u))), 2147483647i, (_e674 > bitcast<f32>(1325400063u))), (_e674 == _e674));
                let _e697 = ((1f - _e675) * (1f - _e676));
                let _e699 = (_e675 * (1f - _e676));
                let _e701 = ((1f - _e675) * _e676);
                let _e702 = (_e675 * _e676);
                let _e704 = p.member.test;
                let _e705 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e704);
                let _e707 = p.member.map_size;
                let _e709 = local_4;
                local_1 = _e705;
                let _e712 = ((_e709.level * _e707) * _e707);
                let _e714 = (bitcast<i32>(_e707) - 1i);
                if (_e685 > 0i) {
                    phi_1730_ = _e685;
                } else {
                    phi_1730_ = 0i;
                }
                let _e717 = phi_1730_;
                if (_e694 > 0i) {
                    phi_1735_ = _e694;
                } else {
                    phi_1735_ = 0i;
                }
                let _e720 = phi_1735_;
                if (_e717 < _e714) {
                    phi_1740_ = _e717;
                } else {
                    phi_1740_ = _e714;
                }
                let _e723 = phi_1740_;
                if (_e720 < _e714) {
                    phi_1745_ = _e720;
                } else {
                    phi_1745_ = _e714;
                }
                let _e726 = phi_1745_;
                let _e727 = bitcast<u32>(_e723);
                let _e729 = (_e685 + 1i);
                let _e730 = (_e694 + 1i);
                if (_e729 > 0i) {
                    phi_1754_ = _e729;
                } else {
                    phi_1754_ = 0i;
                }
                let _e733 = phi_1754_;
                if (_e730 > 0i) {
                    phi_1759_ = _e730;
                } else {
                    phi_1759_ = 0i;
                }
                let _e736 = phi_1759_;
                if (_e733 < _e714) {
                    phi_1764_ = _e733;
                } else {
                    phi_1764_ = _e714;
                }
                let _e739 = phi_1764_;
                if (_e736 < _e714) {
                    phi_1769_ = _e736;
                } else {
                    phi_1769_ = _e714;
                }
                let _e742 = phi_1769_;
                let _e743 = bitcast<u32>(_e739);
                let _e745 = (bitcast<u32>(_e726) * _e707);
                let _e746 = (bitcast<u32>(_e742) * _e707);
                let _e751 = ((_e745 + _e727) + _e712);
                let _e752 = ((_e745 + _e743) + _e712);
                let _e753 = ((_e746 + _e727) + _e712);
                let _e754 = ((_e746 + _e743) + _e712);
                if (_e751 < _e50) {
                } else {
                    return;
                }
                let _e758 = map.member[(0u + _e751)];
                if (_e752 < _e50) {
                } else {
                    return;
                }
                let _e770 = map.member[(0u + _e752)];
                if (_e753 < _e50) {
                } else {
                    return;
                }
                let _e786 = map.member[(0u + _e753)];
                if (_e754 < _e50) {
                } else {
                    return;
                }
                let _e802 = map.member[(0u + _e754)];
                let _e816 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_1), vec4<f32>(((((_e758.x * _e697) + (_e770.x * _e699)) + (_e786.x * _e701)) + (_e802.x * _e702)), ((((_e758.y * _e697) + (_e770.y * _e699)) + (_e786.y * _e701)) + (_e802.y * _e702)), ((((_e758.z * _e697) + (_e770.z * _e699)) + (_e786.z * _e701)) + (_e802.z * _e702)), ((((_e758.w * _e697) + (_e770.w * _e699)) + (_e786.w * _e701)) + (_e802.w * _e702))), _e611);
                let _e818 = p.member.fade_uv;
                if (_e818 > 0f) {
                    let _e821 = local_5;
                    if ((_e821.level + 1u) == _e68) {
                        let _e830 = p.member.fade_uv;
                        let _e832 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e377.point.uv.x, (1f - _e377.point.uv.x));
                        let _e834 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e377.point.uv.y, (1f - _e377.point.uv.y));
                        let _e835 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e832, _e834);
                        if (_e835 < _e830) {
                            phi_1885_ = (1f - ((1f - _e816) * (_e835 / _e830)));
                        } else {
                            phi_1885_ = _e816;
                        }
                        let _e842 = phi_1885_;
                        phi_1887_ = evaluate_Verdict(_e842, false);
                        phi_1888_ = false;
                    } else {
                        phi_1887_ = evaluate_Verdict();
                        phi_1888_ = true;
                    }
                    let _e845 = phi_1887_;
                    let _e847 = phi_1888_;
                    phi_1889_ = _e845;
                    phi_1890_ = _e847;
                } else {
                    phi_1889_ = evaluate_Verdict();
                    phi_1890_ = true;
                }
                let _e849 = phi_1889_;
                let _e851 = phi_1890_;
                if _e851 {
                    phi_1895_ = evaluate_Verdict(_e816, false);
                    phi_1896_ = false;
                } else {
                    phi_1895_ = evaluate_Verdict();
                    phi_1896_ = true;
                }
                let _e854 = phi_1895_;
                let _e856 = phi_1896_;
                phi_1898_ = _e854;
                phi_1899_ = _e849;
                phi_1900_ = _e856;
            } else {
                phi_1898_ = evaluate_Verdict();
                phi_1899_ = evaluate_Verdict(1f, false);
                phi_1900_ = true;
            }
            let _e859 = phi_1898_;
            let _e861 = phi_1899_;
            let _e863 = phi_1900_;
            if _e863 {
            }
            phi_1904_ = _e861;
            phi_1905_ = _e859;
            phi_1906_ = _e863;
        }
        let _e865 = phi_1904_;
        let _e867 = phi_1905_;
        let _e869 = phi_1906_;
        if _e869 {
            phi_1910_ = _e865;
        } else {
            phi_1910_ = _e867;
        }
        let _e871 = phi_1910_;
        if (_e62.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e62.first_primitive)] = _e871.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_msm_hausdorff_prefiltered_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
