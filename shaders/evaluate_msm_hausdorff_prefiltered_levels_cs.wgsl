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
    fade_uv: f32,
    pad0_: u32,
}

struct type_36 {
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
var<uniform> p: type_36;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_13;
@group(0) @binding(4) 
var<storage> levels: type_41;
@group(0) @binding(2) 
var<storage> map: type_31;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_162_: lt_bvh_traverse_Tree;
    var phi_163_: bool;
    var phi_164_: lt_bvh_traverse_Tree;
    var phi_165_: bool;
    var phi_170_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_162_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_163_ = false;
        } else {
            phi_162_ = lt_bvh_traverse_Tree();
            phi_163_ = true;
        }
        let _e55 = phi_162_;
        let _e57 = phi_163_;
        phi_164_ = _e55;
        phi_165_ = _e57;
    } else {
        phi_164_ = lt_bvh_traverse_Tree();
        phi_165_ = true;
    }
    let _e59 = phi_164_;
    let _e61 = phi_165_;
    if _e61 {
        phi_170_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_170_ = _e59;
    }
    let _e66 = phi_170_;
    return lt_bvh_traverse_Tree(_e66.root, _e66.first_primitive);
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(param_4: f32, param_5: f32) -> f32 {
    var phi_184_: f32;

    if (param_4 < param_5) {
        phi_184_ = param_4;
    } else {
        phi_184_ = param_5;
    }
    let _e46 = phi_184_;
    return _e46;
}

fn lt_math_hausdorff_cubic_mass(param_6: vec4<f32>, param_7: f32, param_8: f32, param_9: f32, param_10: f32) -> f32 {
    return ((((param_6.z - (((param_8 + param_9) + param_10) * param_6.y)) + ((((param_8 * param_9) + (param_8 * param_10)) + (param_9 * param_10)) * param_6.x)) - ((param_8 * param_9) * param_10)) / (((param_7 - param_8) * (param_7 - param_9)) * (param_7 - param_10)));
}

fn lt_math_hausdorff_endpoint_upper_bound(param_11: ptr<function, hankel_HankelFactors>, param_12: f32) -> f32 {
    var phi_948_: f32;
    var phi_949_: f32;
    var phi_950_: f32;
    var phi_977_: f32;
    var phi_978_: f32;
    var phi_979_: f32;
    var phi_980_: f32;
    var phi_981_: bool;
    var phi_982_: f32;
    var phi_983_: bool;
    var phi_1011_: f32;
    var phi_1012_: f32;
    var phi_1013_: f32;
    var phi_1014_: f32;
    var phi_1015_: bool;
    var phi_1016_: f32;
    var phi_1017_: bool;
    var phi_1024_: f32;
    var phi_1025_: f32;
    var phi_1026_: f32;
    var phi_1027_: f32;

    let _e45 = (*param_11).moments;
    if (param_12 < 0.0001f) {
        phi_1027_ = 1f;
    } else {
        let _e54 = ((_e45.z - ((1f + param_12) * _e45.y)) + (param_12 * _e45.x));
        let _e63 = (((_e45.w - ((1f + param_12) * _e45.z)) + (param_12 * _e45.y)) / _e54);
        if (abs(_e54) <= 0.00000047683716f) {
            let _e77 = (1f - (((_e45.y - (_e45.x * (param_12 + 1f))) + (param_12 * 1f)) / ((0f - param_12) * (0f - 1f))));
            if ((bitcast<u32>(_e77) & 2147483647u) > 2139095040u) {
                phi_950_ = _e77;
            } else {
                if (_e77 < 0f) {
                    phi_949_ = 0f;
                } else {
                    if (_e77 > 1f) {
                        phi_948_ = 1f;
                    } else {
                        phi_948_ = _e77;
                    }
                    let _e84 = phi_948_;
                    phi_949_ = _e84;
                }
                let _e86 = phi_949_;
                phi_950_ = _e86;
            }
            let _e88 = phi_950_;
            phi_1026_ = _e88;
        } else {
            if (_e63 > 0f) {
                if (_e63 < param_12) {
                    let _e91 = lt_math_hausdorff_cubic_mass(_e45, 0f, _e63, param_12, 1f);
                    let _e93 = lt_math_hausdorff_cubic_mass(_e45, _e63, 0f, param_12, 1f);
                    let _e94 = ((1f - _e91) - _e93);
                    if ((bitcast<u32>(_e94) & 2147483647u) > 2139095040u) {
                        phi_979_ = _e94;
                    } else {
                        if (_e94 < 0f) {
                            phi_978_ = 0f;
                        } else {
                            if (_e94 > 1f) {
                                phi_977_ = 1f;
                            } else {
                                phi_977_ = _e94;
                            }
                            let _e101 = phi_977_;
                            phi_978_ = _e101;
                        }
                        let _e103 = phi_978_;
                        phi_979_ = _e103;
                    }
                    let _e105 = phi_979_;
                    phi_980_ = _e105;
                    phi_981_ = false;
                } else {
                    phi_980_ = f32();
                    phi_981_ = true;
                }
                let _e107 = phi_980_;
                let _e109 = phi_981_;
                phi_982_ = _e107;
                phi_983_ = _e109;
            } else {
                phi_982_ = f32();
                phi_983_ = true;
            }
            let _e111 = phi_982_;
            let _e113 = phi_983_;
            if _e113 {
                if (_e63 > param_12) {
                    if (_e63 < 1f) {
                        let _e116 = lt_math_hausdorff_cubic_mass(_e45, 0f, _e63, param_12, 1f);
                        let _e117 = (1f - _e116);
                        if ((bitcast<u32>(_e117) & 2147483647u) > 2139095040u) {
                            phi_1013_ = _e117;
                        } else {
                            if (_e117 < 0f) {
                                phi_1012_ = 0f;
                            } else {
                                if (_e117 > 1f) {
                                    phi_1011_ = 1f;
                                } else {
                                    phi_1011_ = _e117;
                                }
                                let _e124 = phi_1011_;
                                phi_1012_ = _e124;
                            }
                            let _e126 = phi_1012_;
                            phi_1013_ = _e126;
                        }
                        let _e128 = phi_1013_;
                        phi_1014_ = _e128;
                        phi_1015_ = false;
                    } else {
                        phi_1014_ = f32();
                        phi_1015_ = true;
                    }
                    let _e130 = phi_1014_;
                    let _e132 = phi_1015_;
                    phi_1016_ = _e130;
                    phi_1017_ = _e132;
                } else {
                    phi_1016_ = f32();
                    phi_1017_ = true;
                }
                let _e134 = phi_1016_;
                let _e136 = phi_1017_;
                if _e136 {
                    phi_1024_ = bitcast<f32>((bitcast<u32>(_e63) | 2143289344u));
                } else {
                    phi_1024_ = _e134;
                }
                let _e141 = phi_1024_;
                phi_1025_ = _e141;
            } else {
                phi_1025_ = _e111;
            }
            let _e143 = phi_1025_;
            phi_1026_ = _e143;
        }
        let _e145 = phi_1026_;
        phi_1027_ = _e145;
    }
    let _e147 = phi_1027_;
    return _e147;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_13: ptr<function, f32>, param_14: vec4<f32>, param_15: f32) -> f32 {
    var local: hankel_HankelFactors;
    var phi_235_: f32;
    var phi_236_: f32;
    var phi_237_: f32;
    var phi_249_: bool;
    var phi_264_: bool;
    var phi_289_: f32;
    var phi_290_: f32;
    var phi_291_: f32;
    var phi_292_: f32;
    var phi_293_: bool;
    var phi_294_: f32;
    var phi_295_: bool;
    var phi_351_: vec2<f32>;
    var phi_389_: f32;
    var phi_390_: f32;
    var phi_391_: f32;
    var phi_424_: f32;
    var phi_425_: f32;
    var phi_426_: f32;
    var phi_430_: f32;
    var phi_431_: f32;
    var phi_432_: f32;
    var phi_433_: f32;
    var phi_486_: vec2<f32>;
    var phi_508_: bool;
    var phi_533_: f32;
    var phi_534_: f32;
    var phi_535_: f32;
    var phi_536_: f32;
    var phi_537_: bool;
    var phi_538_: f32;
    var phi_539_: bool;
    var phi_595_: vec2<f32>;
    var phi_633_: f32;
    var phi_634_: f32;
    var phi_635_: f32;
    var phi_668_: f32;
    var phi_669_: f32;
    var phi_670_: f32;
    var phi_674_: f32;
    var phi_675_: f32;
    var phi_676_: f32;
    var phi_677_: f32;
    var phi_678_: f32;
    var phi_679_: bool;
    var phi_680_: f32;
    var phi_681_: bool;
    var phi_703_: bool;
    var phi_728_: f32;
    var phi_729_: f32;
    var phi_730_: f32;
    var phi_731_: f32;
    var phi_732_: bool;
    var phi_733_: f32;
    var phi_734_: bool;
    var phi_790_: vec2<f32>;
    var phi_828_: f32;
    var phi_829_: f32;
    var phi_830_: f32;
    var phi_863_: f32;
    var phi_864_: f32;
    var phi_865_: f32;
    var phi_869_: f32;
    var phi_870_: f32;
    var phi_871_: f32;
    var phi_872_: f32;
    var phi_883_: bool;
    var phi_887_: f32;
    var phi_888_: f32;
    var phi_889_: f32;
    var phi_890_: f32;

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
        phi_237_ = param_15;
    } else {
        if (param_15 < 0f) {
            phi_236_ = 0f;
        } else {
            if (param_15 > 1f) {
                phi_235_ = 1f;
            } else {
                phi_235_ = param_15;
            }
            let _e83 = phi_235_;
            phi_236_ = _e83;
        }
        let _e85 = phi_236_;
        phi_237_ = _e85;
    }
    let _e87 = phi_237_;
    let _e90 = local.moments[0u];
    let _e93 = local.moments[3u];
    if (_e90 == _e93) {
        let _e97 = local.moments[0u];
        phi_249_ = (_e97 > 0.5f);
    } else {
        phi_249_ = false;
    }
    let _e100 = phi_249_;
    if _e100 {
        let _e103 = local.moments[0u];
        let _e106 = local.moments[3u];
        if (_e103 == _e106) {
            let _e110 = local.moments[0u];
            phi_264_ = (_e110 > 0.5f);
        } else {
            phi_264_ = false;
        }
        let _e113 = phi_264_;
        if _e113 {
            if (_e87 > 0f) {
                let _e116 = local.moments;
                if ((bitcast<u32>(_e116.x) & 2147483647u) > 2139095040u) {
                    phi_291_ = _e116.x;
                } else {
                    if (_e116.x < 0f) {
                        phi_290_ = 0f;
                    } else {
                        if (_e116.x > 1f) {
                            phi_289_ = 1f;
                        } else {
                            phi_289_ = _e116.x;
                        }
                        let _e124 = phi_289_;
                        phi_290_ = _e124;
                    }
                    let _e126 = phi_290_;
                    phi_291_ = _e126;
                }
                let _e128 = phi_291_;
                phi_292_ = _e128;
                phi_293_ = false;
            } else {
                phi_292_ = f32();
                phi_293_ = true;
            }
            let _e130 = phi_292_;
            let _e132 = phi_293_;
            phi_294_ = _e130;
            phi_295_ = _e132;
        } else {
            phi_294_ = f32();
            phi_295_ = true;
        }
        let _e134 = phi_294_;
        let _e136 = phi_295_;
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
                phi_351_ = vec2<f32>((-(_e175) - _e180), (-(_e175) + _e180));
            } else {
                phi_351_ = vec2(bitcast<f32>((bitcast<u32>(_e178) | 2143289344u)));
            }
            let _e191 = phi_351_;
            if (_e87 <= _e191.x) {
                phi_432_ = 1f;
            } else {
                if (_e87 > _e191.y) {
                    let _e197 = local.moments;
                    let _e208 = (((_e197.y - (_e197.x * (_e191.x + _e191.y))) + (_e191.x * _e191.y)) / ((_e87 - _e191.x) * (_e87 - _e191.y)));
                    if ((bitcast<u32>(_e208) & 2147483647u) > 2139095040u) {
                        phi_391_ = _e208;
                    } else {
                        if (_e208 < 0f) {
                            phi_390_ = 0f;
                        } else {
                            if (_e208 > 1f) {
                                phi_389_ = 1f;
                            } else {
                                phi_389_ = _e208;
                            }
                            let _e215 = phi_389_;
                            phi_390_ = _e215;
                        }
                        let _e217 = phi_390_;
                        phi_391_ = _e217;
                    }
                    let _e219 = phi_391_;
                    phi_431_ = _e219;
                } else {
                    if (_e87 > _e191.x) {
                        let _e222 = local.moments;
                        let _e234 = (1f - (((_e222.y - (_e222.x * (_e87 + _e191.y))) + (_e87 * _e191.y)) / ((_e191.x - _e87) * (_e191.x - _e191.y))));
                        if ((bitcast<u32>(_e234) & 2147483647u) > 2139095040u) {
                            phi_426_ = _e234;
                        } else {
                            if (_e234 < 0f) {
                                phi_425_ = 0f;
                            } else {
                                if (_e234 > 1f) {
                                    phi_424_ = 1f;
                                } else {
                                    phi_424_ = _e234;
                                }
                                let _e241 = phi_424_;
                                phi_425_ = _e241;
                            }
                            let _e243 = phi_425_;
                            phi_426_ = _e243;
                        }
                        let _e245 = phi_426_;
                        phi_430_ = _e245;
                    } else {
                        phi_430_ = bitcast<f32>((bitcast<u32>(_e191.x) | 2143289344u));
                    }
                    let _e250 = phi_430_;
                    phi_431_ = _e250;
                }
                let _e252 = phi_431_;
                phi_432_ = _e252;
            }
            let _e254 = phi_432_;
            phi_433_ = _e254;
        } else {
            phi_433_ = _e134;
        }
        let _e256 = phi_433_;
        phi_890_ = _e256;
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
            phi_486_ = vec2<f32>((-(_e295) - _e300), (-(_e295) + _e300));
        } else {
            phi_486_ = vec2(bitcast<f32>((bitcast<u32>(_e298) | 2143289344u)));
        }
        let _e311 = phi_486_;
        if (_e311.x >= 0f) {
            if (_e311.y <= 1f) {
                let _e318 = local.moments[0u];
                let _e321 = local.moments[3u];
                if (_e318 == _e321) {
                    let _e325 = local.moments[0u];
                    phi_508_ = (_e325 > 0.5f);
                } else {
                    phi_508_ = false;
                }
                let _e328 = phi_508_;
                if _e328 {
                    if (_e87 > 0f) {
                        let _e331 = local.moments;
                        if ((bitcast<u32>(_e331.x) & 2147483647u) > 2139095040u) {
                            phi_535_ = _e331.x;
                        } else {
                            if (_e331.x < 0f) {
                                phi_534_ = 0f;
                            } else {
                                if (_e331.x > 1f) {
                                    phi_533_ = 1f;
                                } else {
                                    phi_533_ = _e331.x;
                                }
                                let _e339 = phi_533_;
                                phi_534_ = _e339;
                            }
                            let _e341 = phi_534_;
                            phi_535_ = _e341;
                        }
                        let _e343 = phi_535_;
                        phi_536_ = _e343;
                        phi_537_ = false;
                    } else {
                        phi_536_ = f32();
                        phi_537_ = true;
                    }
                    let _e345 = phi_536_;
                    let _e347 = phi_537_;
                    phi_538_ = _e345;
                    phi_539_ = _e347;
                } else {
                    phi_538_ = f32();
                    phi_539_ = true;
                }
                let _e349 = phi_538_;
                let _e351 = phi_539_;
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
                        phi_595_ = vec2<f32>((-(_e390) - _e395), (-(_e390) + _e395));
                    } else {
                        phi_595_ = vec2(bitcast<f32>((bitcast<u32>(_e393) | 2143289344u)));
                    }
                    let _e406 = phi_595_;
                    if (_e87 <= _e406.x) {
                        phi_676_ = 1f;
                    } else {
                        if (_e87 > _e406.y) {
                            let _e412 = local.moments;
                            let _e423 = (((_e412.y - (_e412.x * (_e406.x + _e406.y))) + (_e406.x * _e406.y)) / ((_e87 - _e406.x) * (_e87 - _e406.y)));
                            if ((bitcast<u32>(_e423) & 2147483647u) > 2139095040u) {
                                phi_635_ = _e423;
                            } else {
                                if (_e423 < 0f) {
                                    phi_634_ = 0f;
                                } else {
                                    if (_e423 > 1f) {
                                        phi_633_ = 1f;
                                    } else {
                                        phi_633_ = _e423;
                                    }
                                    let _e430 = phi_633_;
                                    phi_634_ = _e430;
                                }
                                let _e432 = phi_634_;
                                phi_635_ = _e432;
                            }
                            let _e434 = phi_635_;
                            phi_675_ = _e434;
                        } else {
                            if (_e87 > _e406.x) {
                                let _e437 = local.moments;
                                let _e449 = (1f - (((_e437.y - (_e437.x * (_e87 + _e406.y))) + (_e87 * _e406.y)) / ((_e406.x - _e87) * (_e406.x - _e406.y))));
                                if ((bitcast<u32>(_e449) & 2147483647u) > 2139095040u) {
                                    phi_670_ = _e449;
                                } else {
                                    if (_e449 < 0f) {
                                        phi_669_ = 0f;
                                    } else {
                                        if (_e449 > 1f) {
                                            phi_668_ = 1f;
                                        } else {
                                            phi_668_ = _e449;
                                        }
                                        let _e456 = phi_668_;
                                        phi_669_ = _e456;
                                    }
                                    let _e458 = phi_669_;
                                    phi_670_ = _e458;
                                }
                                let _e460 = phi_670_;
                                phi_674_ = _e460;
                            } else {
                                phi_674_ = bitcast<f32>((bitcast<u32>(_e406.x) | 2143289344u));
                            }
                            let _e465 = phi_674_;
                            phi_675_ = _e465;
                        }
                        let _e467 = phi_675_;
                        phi_676_ = _e467;
                    }
                    let _e469 = phi_676_;
                    phi_677_ = _e469;
                } else {
                    phi_677_ = _e349;
                }
                let _e471 = phi_677_;
                phi_678_ = _e471;
                phi_679_ = false;
            } else {
                phi_678_ = f32();
                phi_679_ = true;
            }
            let _e473 = phi_678_;
            let _e475 = phi_679_;
            phi_680_ = _e473;
            phi_681_ = _e475;
        } else {
            phi_680_ = f32();
            phi_681_ = true;
        }
        let _e477 = phi_680_;
        let _e479 = phi_681_;
        if _e479 {
            if ((bitcast<u32>(_e311.x) & 2147483647u) > 2139095040u) {
                phi_888_ = _e311.x;
            } else {
                let _e483 = lt_math_hausdorff_endpoint_upper_bound((&local), _e87);
                let _e486 = local.moments[0u];
                let _e489 = local.moments[3u];
                if (_e486 == _e489) {
                    let _e493 = local.moments[0u];
                    phi_703_ = (_e493 > 0.5f);
                } else {
                    phi_703_ = false;
                }
                let _e496 = phi_703_;
                if _e496 {
                    if (_e87 > 0f) {
                        let _e499 = local.moments;
                        if ((bitcast<u32>(_e499.x) & 2147483647u) > 2139095040u) {
                            phi_730_ = _e499.x;
                        } else {
                            if (_e499.x < 0f) {
                                phi_729_ = 0f;
                            } else {
                                if (_e499.x > 1f) {
                                    phi_728_ = 1f;
                                } else {
                                    phi_728_ = _e499.x;
                                }
                                let _e507 = phi_728_;
                                phi_729_ = _e507;
                            }
                            let _e509 = phi_729_;
                            phi_730_ = _e509;
                        }
                        let _e511 = phi_730_;
                        phi_731_ = _e511;
                        phi_732_ = false;
                    } else {
                        phi_731_ = f32();
                        phi_732_ = true;
                    }
                    let _e513 = phi_731_;
                    let _e515 = phi_732_;
                    phi_733_ = _e513;
                    phi_734_ = _e515;
                } else {
                    phi_733_ = f32();
                    phi_734_ = true;
                }
                let _e517 = phi_733_;
                let _e519 = phi_734_;
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
                        phi_790_ = vec2<f32>((-(_e558) - _e563), (-(_e558) + _e563));
                    } else {
                        phi_790_ = vec2(bitcast<f32>((bitcast<u32>(_e561) | 2143289344u)));
                    }
                    let _e574 = phi_790_;
                    if (_e87 <= _e574.x) {
                        phi_871_ = 1f;
                    } else {
                        if (_e87 > _e574.y) {
                            let _e580 = local.moments;
                            let _e591 = (((_e580.y - (_e580.x * (_e574.x + _e574.y))) + (_e574.x * _e574.y)) / ((_e87 - _e574.x) * (_e87 - _e574.y)));
                            if ((bitcast<u32>(_e591) & 2147483647u) > 2139095040u) {
                                phi_830_ = _e591;
                            } else {
                                if (_e591 < 0f) {
                                    phi_829_ = 0f;
                                } else {
                                    if (_e591 > 1f) {
                                        phi_828_ = 1f;
                                    } else {
                                        phi_828_ = _e591;
                                    }
                                    let _e598 = phi_828_;
                                    phi_829_ = _e598;
                                }
                                let _e600 = phi_829_;
                                phi_830_ = _e600;
                            }
                            let _e602 = phi_830_;
                            phi_870_ = _e602;
                        } else {
                            if (_e87 > _e574.x) {
                                let _e605 = local.moments;
                                let _e617 = (1f - (((_e605.y - (_e605.x * (_e87 + _e574.y))) + (_e87 * _e574.y)) / ((_e574.x - _e87) * (_e574.x - _e574.y))));
                                if ((bitcast<u32>(_e617) & 2147483647u) > 2139095040u) {
                                    phi_865_ = _e617;
                                } else {
                                    if (_e617 < 0f) {
                                        phi_864_ = 0f;
                                    } else {
                                        if (_e617 > 1f) {
                                            phi_863_ = 1f;
                                        } else {
                                            phi_863_ = _e617;
                                        }
                                        let _e624 = phi_863_;
                                        phi_864_ = _e624;
                                    }
                                    let _e626 = phi_864_;
                                    phi_865_ = _e626;
                                }
                                let _e628 = phi_865_;
                                phi_869_ = _e628;
                            } else {
                                phi_869_ = bitcast<f32>((bitcast<u32>(_e574.x) | 2143289344u));
                            }
                            let _e633 = phi_869_;
                            phi_870_ = _e633;
                        }
                        let _e635 = phi_870_;
                        phi_871_ = _e635;
                    }
                    let _e637 = phi_871_;
                    phi_872_ = _e637;
                } else {
                    phi_872_ = _e517;
                }
                let _e639 = phi_872_;
                if ((bitcast<u32>(_e639) & 2147483647u) > 2139095040u) {
                    phi_883_ = true;
                } else {
                    let _e643 = (_e639 < _e483);
                    if _e643 {
                    }
                    phi_883_ = _e643;
                }
                let _e645 = phi_883_;
                if _e645 {
                    phi_887_ = _e639;
                } else {
                    phi_887_ = _e483;
                }
                let _e647 = phi_887_;
                phi_888_ = _e647;
            }
            let _e649 = phi_888_;
            phi_889_ = _e649;
        } else {
            phi_889_ = _e477;
        }
        let _e651 = phi_889_;
        phi_890_ = _e651;
    }
    let _e653 = phi_890_;
    return _e653;
}

fn function_() {
    var local_1: f32;
    var phi_1116_: bool;
    var phi_1117_: bool;
    var phi_1118_: bool;
    var phi_1119_: bool;
    var phi_1123_: bool;
    var phi_1193_: bool;
    var phi_1194_: bool;
    var phi_1205_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1206_: bool;
    var phi_1207_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1208_: bool;
    var phi_1215_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1219_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1239_: lt_math_LightPoint;
    var phi_1242_: u32;
    var phi_1244_: lt_math_LevelPoint;
    var phi_1330_: bool;
    var phi_1339_: bool;
    var phi_1348_: bool;
    var phi_1349_: bool;
    var phi_1350_: bool;
    var phi_1351_: bool;
    var phi_1352_: bool;
    var phi_1353_: bool;
    var phi_1354_: bool;
    var phi_1358_: bool;
    var phi_1385_: bool;
    var phi_1386_: bool;
    var phi_1387_: bool;
    var phi_1388_: bool;
    var phi_1389_: bool;
    var phi_1390_: bool;
    var phi_1391_: bool;
    var phi_1392_: bool;
    var phi_1396_: bool;
    var phi_1405_: lt_math_LightPoint;
    var phi_1406_: u32;
    var phi_1407_: lt_math_LevelPoint;
    var phi_1408_: bool;
    var phi_1240_: lt_math_LightPoint;
    var phi_1243_: u32;
    var phi_1245_: lt_math_LevelPoint;
    var phi_1409_: bool;
    var local_2: lt_math_LevelPoint;
    var local_3: lt_math_LevelPoint;
    var phi_1449_: bool;
    var phi_1450_: bool;
    var phi_1451_: bool;
    var phi_1452_: bool;
    var phi_1456_: bool;
    var phi_1538_: f32;
    var phi_1654_: f32;
    var phi_1655_: f32;
    var phi_1658_: f32;
    var phi_1687_: f32;
    var phi_1692_: f32;
    var phi_1693_: bool;
    var phi_1694_: f32;
    var phi_1695_: bool;
    var phi_1699_: f32;
    var phi_1719_: f32;
    var phi_1724_: f32;
    var phi_1725_: bool;
    var phi_1726_: f32;
    var phi_1727_: bool;
    var phi_1731_: f32;
    var local_4: lt_math_LevelPoint;
    var phi_1780_: i32;
    var phi_1785_: i32;
    var phi_1790_: i32;
    var phi_1795_: i32;
    var phi_1804_: i32;
    var phi_1809_: i32;
    var phi_1814_: i32;
    var phi_1819_: i32;
    var local_5: lt_math_LevelPoint;
    var phi_1935_: f32;
    var phi_1937_: evaluate_Verdict;
    var phi_1938_: bool;
    var phi_1939_: evaluate_Verdict;
    var phi_1940_: bool;
    var phi_1945_: evaluate_Verdict;
    var phi_1946_: bool;
    var phi_1948_: evaluate_Verdict;
    var phi_1949_: evaluate_Verdict;
    var phi_1950_: bool;
    var phi_1954_: evaluate_Verdict;
    var phi_1955_: evaluate_Verdict;
    var phi_1956_: bool;
    var phi_1960_: evaluate_Verdict;

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
                phi_1116_ = (_e85 == _e87);
                phi_1117_ = false;
            } else {
                phi_1116_ = bool();
                phi_1117_ = true;
            }
            let _e90 = phi_1116_;
            let _e92 = phi_1117_;
            phi_1118_ = _e90;
            phi_1119_ = _e92;
        } else {
            phi_1118_ = bool();
            phi_1119_ = true;
        }
        let _e94 = phi_1118_;
        let _e96 = phi_1119_;
        if _e96 {
            phi_1123_ = false;
        } else {
            phi_1123_ = _e94;
        }
        let _e98 = phi_1123_;
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
                    phi_1194_ = true;
                } else {
                    let _e151 = p.member.light.range_squared;
                    if (_e134 <= _e151) {
                        let _e154 = p.member.light.cos_outer;
                        phi_1193_ = (-((((_e116 * _e136.x) + (_e117 * _e136.y)) + (_e118 * _e136.z))) >= (_e154 * sqrt(_e134)));
                    } else {
                        phi_1193_ = false;
                    }
                    let _e159 = phi_1193_;
                    phi_1194_ = _e159;
                }
                let _e161 = phi_1194_;
                if _e161 {
                    let _e163 = samples.member[(0u + _e62.first_primitive)].flags;
                    let _e171 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e177 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e171.unnamed.visibility, false), _e171.unnamed_1);
                    phi_1205_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e177.unnamed, ((_e163 & 1u) == 0u));
                    phi_1206_ = false;
                } else {
                    phi_1205_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_1206_ = true;
                }
                let _e182 = phi_1205_;
                let _e184 = phi_1206_;
                phi_1207_ = _e182;
                phi_1208_ = _e184;
            } else {
                phi_1207_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_1208_ = true;
            }
            let _e186 = phi_1207_;
            let _e188 = phi_1208_;
            if _e188 {
                let _e194 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e200 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e194.unnamed.visibility, false), _e194.unnamed_1);
                phi_1215_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e200.unnamed, true);
            } else {
                phi_1215_ = _e186;
            }
            let _e205 = phi_1215_;
            phi_1219_ = _e205;
        } else {
            let _e211 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e217 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e211.unnamed.visibility, false), _e211.unnamed_1);
            phi_1219_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e217.unnamed, true);
        }
        let _e222 = phi_1219_;
        if _e222.unnamed_1 {
            phi_1954_ = evaluate_Verdict(_e222.unnamed.visibility, _e222.unnamed.is_doubted);
            phi_1955_ = evaluate_Verdict();
            phi_1956_ = true;
        } else {
            let _e230 = samples.member[(0u + _e62.first_primitive)].position;
            let _e232 = p.member.map_size;
            let _e234 = (0.5f / f32(_e232));
            let _e241 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e248 = lt_math_LightPoint(vec2<f32>(_e241.uv.x, 0f), _e241.depth, _e241.is_inside);
            let _e252 = lt_math_LightPoint(_e248.uv, 0f, _e248.is_inside);
            phi_1239_ = lt_math_LightPoint();
            phi_1242_ = 0u;
            phi_1244_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e252.uv, _e252.depth, false));
            loop {
                let _e259 = phi_1239_;
                let _e261 = phi_1242_;
                let _e263 = phi_1244_;
                local_2 = _e263;
                local_3 = _e263;
                local_4 = _e263;
                local_5 = _e263;
                if (_e261 < _e68) {
                    if _e263.point.is_inside {
                        phi_1405_ = lt_math_LightPoint();
                        phi_1406_ = u32();
                        phi_1407_ = lt_math_LevelPoint();
                        phi_1408_ = false;
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
                                phi_1330_ = (_e299 <= 1f);
                            } else {
                                phi_1330_ = false;
                            }
                            let _e331 = phi_1330_;
                            if _e331 {
                                if (_e313 >= 0f) {
                                    phi_1339_ = (_e313 <= 1f);
                                } else {
                                    phi_1339_ = false;
                                }
                                let _e335 = phi_1339_;
                                if _e335 {
                                    if (_e326 >= 0f) {
                                        phi_1348_ = (_e326 <= 1f);
                                    } else {
                                        phi_1348_ = false;
                                    }
                                    let _e339 = phi_1348_;
                                    phi_1349_ = _e339;
                                    phi_1350_ = false;
                                } else {
                                    phi_1349_ = bool();
                                    phi_1350_ = true;
                                }
                                let _e341 = phi_1349_;
                                let _e343 = phi_1350_;
                                phi_1351_ = _e341;
                                phi_1352_ = _e343;
                            } else {
                                phi_1351_ = bool();
                                phi_1352_ = true;
                            }
                            let _e345 = phi_1351_;
                            let _e347 = phi_1352_;
                            phi_1353_ = _e345;
                            phi_1354_ = _e347;
                        } else {
                            phi_1353_ = bool();
                            phi_1354_ = true;
                        }
                        let _e349 = phi_1353_;
                        let _e351 = phi_1354_;
                        if _e351 {
                            phi_1358_ = false;
                        } else {
                            phi_1358_ = _e349;
                        }
                        let _e353 = phi_1358_;
                        if _e353 {
                            if (_e299 >= _e234) {
                                if (_e299 <= (1f - _e234)) {
                                    if (_e313 >= _e234) {
                                        phi_1385_ = (_e313 <= (1f - _e234));
                                        phi_1386_ = false;
                                    } else {
                                        phi_1385_ = bool();
                                        phi_1386_ = true;
                                    }
                                    let _e361 = phi_1385_;
                                    let _e363 = phi_1386_;
                                    phi_1387_ = _e361;
                                    phi_1388_ = _e363;
                                } else {
                                    phi_1387_ = bool();
                                    phi_1388_ = true;
                                }
                                let _e365 = phi_1387_;
                                let _e367 = phi_1388_;
                                phi_1389_ = _e365;
                                phi_1390_ = _e367;
                            } else {
                                phi_1389_ = bool();
                                phi_1390_ = true;
                            }
                            let _e369 = phi_1389_;
                            let _e371 = phi_1390_;
                            phi_1391_ = _e369;
                            phi_1392_ = _e371;
                        } else {
                            phi_1391_ = bool();
                            phi_1392_ = true;
                        }
                        let _e373 = phi_1391_;
                        let _e375 = phi_1392_;
                        if _e375 {
                            phi_1396_ = false;
                        } else {
                            phi_1396_ = _e373;
                        }
                        let _e377 = phi_1396_;
                        let _e384 = lt_math_LightPoint(vec2<f32>(_e299, _e259.uv.y), _e259.depth, _e259.is_inside);
                        let _e391 = lt_math_LightPoint(vec2<f32>(_e384.uv.x, _e313), _e384.depth, _e384.is_inside);
                        let _e395 = lt_math_LightPoint(_e391.uv, _e326, _e391.is_inside);
                        let _e399 = lt_math_LightPoint(_e395.uv, _e395.depth, _e377);
                        phi_1405_ = _e399;
                        phi_1406_ = (_e261 + 1u);
                        phi_1407_ = lt_math_LevelPoint(_e261, _e399);
                        phi_1408_ = true;
                    }
                    let _e403 = phi_1405_;
                    let _e405 = phi_1406_;
                    let _e407 = phi_1407_;
                    let _e409 = phi_1408_;
                    phi_1240_ = _e403;
                    phi_1243_ = _e405;
                    phi_1245_ = _e407;
                    phi_1409_ = _e409;
                } else {
                    phi_1240_ = lt_math_LightPoint();
                    phi_1243_ = u32();
                    phi_1245_ = lt_math_LevelPoint();
                    phi_1409_ = false;
                }
                let _e411 = phi_1240_;
                let _e413 = phi_1243_;
                let _e415 = phi_1245_;
                let _e417 = phi_1409_;
                continue;
                continuing {
                    phi_1239_ = _e411;
                    phi_1242_ = _e413;
                    phi_1244_ = _e415;
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
                            phi_1449_ = (_e431.row_w.z == _e443);
                            phi_1450_ = false;
                        } else {
                            phi_1449_ = bool();
                            phi_1450_ = true;
                        }
                        let _e446 = phi_1449_;
                        let _e448 = phi_1450_;
                        phi_1451_ = _e446;
                        phi_1452_ = _e448;
                    } else {
                        phi_1451_ = bool();
                        phi_1452_ = true;
                    }
                    let _e450 = phi_1451_;
                    let _e452 = phi_1452_;
                    if _e452 {
                        phi_1456_ = false;
                    } else {
                        phi_1456_ = _e450;
                    }
                    let _e454 = phi_1456_;
                    if _e454 {
                        let _e456 = samples.member[(0u + _e62.first_primitive)].normal;
                        let _e458 = p.member.map_size;
                        let _e528 = ((abs(((((_e431.row_x.x * _e456.x) + (_e431.row_x.y * _e456.y)) + (_e431.row_x.z * _e456.z)) / (((_e431.row_x.x * _e431.row_x.x) + (_e431.row_x.y * _e431.row_x.y)) + (_e431.row_x.z * _e431.row_x.z)))) + abs(((((_e431.row_y.x * _e456.x) + (_e431.row_y.y * _e456.y)) + (_e431.row_y.z * _e456.z)) / (((_e431.row_y.x * _e431.row_y.x) + (_e431.row_y.y * _e431.row_y.y)) + (_e431.row_y.z * _e431.row_y.z))))) / (abs(((((_e431.row_z.x * _e456.x) + (_e431.row_z.y * _e456.y)) + (_e431.row_z.z * _e456.z)) / (((_e431.row_z.x * _e431.row_z.x) + (_e431.row_z.y * _e431.row_z.y)) + (_e431.row_z.z * _e431.row_z.z)))) * f32(_e458)));
                        if (_e528 < 0.002f) {
                            phi_1538_ = _e528;
                        } else {
                            phi_1538_ = 0.002f;
                        }
                        let _e531 = phi_1538_;
                        phi_1655_ = _e531;
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
                        if (_e645 < 0.002f) {
                            phi_1654_ = _e645;
                        } else {
                            phi_1654_ = 0.002f;
                        }
                        let _e648 = phi_1654_;
                        phi_1655_ = _e648;
                    }
                    let _e650 = phi_1655_;
                    phi_1658_ = (_e420.point.depth - (0f * _e650));
                } else {
                    phi_1658_ = _e420.point.depth;
                }
                let _e654 = phi_1658_;
                let _e660 = p.member.map_size;
                let _e661 = f32(_e660);
                let _e664 = ((_e420.point.uv.x * _e661) - 0.5f);
                let _e665 = ((_e420.point.uv.y * _e661) - 0.5f);
                if (_e664 > -8388608f) {
                    let _e677 = f32(select(0i, select(select(i32(_e664), i32(-2147483648), (_e664 < bitcast<f32>(3472883712u))), 2147483647i, (_e664 > bitcast<f32>(1325400063u))), (_e664 == _e664)));
                    if (_e677 > _e664) {
                        phi_1687_ = 1f;
                    } else {
                        phi_1687_ = 0f;
                    }
                    let _e680 = phi_1687_;
                    if (_e664 < 8388608f) {
                        phi_1692_ = (_e677 - _e680);
                        phi_1693_ = false;
                    } else {
                        phi_1692_ = f32();
                        phi_1693_ = true;
                    }
                    let _e683 = phi_1692_;
                    let _e685 = phi_1693_;
                    phi_1694_ = _e683;
                    phi_1695_ = _e685;
                } else {
                    phi_1694_ = f32();
                    phi_1695_ = true;
                }
                let _e687 = phi_1694_;
                let _e689 = phi_1695_;
                if _e689 {
                    phi_1699_ = _e664;
                } else {
                    phi_1699_ = _e687;
                }
                let _e691 = phi_1699_;
                if (_e665 > -8388608f) {
                    let _e703 = f32(select(0i, select(select(i32(_e665), i32(-2147483648), (_e665 < bitcast<f32>(3472883712u))), 2147483647i, (_e665 > bitcast<f32>(1325400063u))), (_e665 == _e665)));
                    if (_e703 > _e665) {
                        phi_1719_ = 1f;
                    } else {
                        phi_1719_ = 0f;
                    }
                    let _e706 = phi_1719_;
                    if (_e665 < 8388608f) {
                        phi_1724_ = (_e703 - _e706);
                        phi_1725_ = false;
                    } else {
                        phi_1724_ = f32();
                        phi_1725_ = true;
                    }
                    let _e709 = phi_1724_;
                    let _e711 = phi_1725_;
                    phi_1726_ = _e709;
                    phi_1727_ = _e711;
                } else {
                    phi_1726_ = f32();
                    phi_1727_ = true;
                }
                let _e713 = phi_1726_;
                let _e715 = phi_1727_;
                if _e715 {
                    phi_1731_ = _e665;
                } else {
                    phi_1731_ = _e713;
                }
                let _e717 = phi_1731_;
                let _e718 = (_e664 - _e691);
                let _e719 = (_e665 - _e717);
                let _e728 = select(0i, select(select(i32(_e691), i32(-2147483648), (_e691 < bitcast<f32>(3472883712u))), 2147483647i, (_e691 > bitcast<f32>(1325400063u))), (_e691 == _e691));
                let _e737 = select(0i, select(select(i32(_e717), i32(-2147483648), (_e717 < bitcast<f32>(3472883712u))), 2147483647i, (_e717 > bitcast<f32>(1325400063u))), (_e717 == _e717));
                let _e740 = ((1f - _e718) * (1f - _e719));
                let _e742 = (_e718 * (1f - _e719));
                let _e744 = ((1f - _e718) * _e719);
                let _e745 = (_e718 * _e719);
                let _e747 = p.member.test;
                let _e748 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e747);
                let _e750 = p.member.map_size;
                let _e752 = local_4;
                local_1 = _e748;
                let _e755 = ((_e752.level * _e750) * _e750);
                let _e757 = (bitcast<i32>(_e750) - 1i);
                if (_e728 > 0i) {
                    phi_1780_ = _e728;
                } else {
                    phi_1780_ = 0i;
                }
                let _e760 = phi_1780_;
                if (_e737 > 0i) {
                    phi_1785_ = _e737;
                } else {
                    phi_1785_ = 0i;
                }
                let _e763 = phi_1785_;
                if (_e760 < _e757) {
                    phi_1790_ = _e760;
                } else {
                    phi_1790_ = _e757;
                }
                let _e766 = phi_1790_;
                if (_e763 < _e757) {
                    phi_1795_ = _e763;
                } else {
                    phi_1795_ = _e757;
                }
                let _e769 = phi_1795_;
                let _e770 = bitcast<u32>(_e766);
                let _e772 = (_e728 + 1i);
                let _e773 = (_e737 + 1i);
                if (_e772 > 0i) {
                    phi_1804_ = _e772;
                } else {
                    phi_1804_ = 0i;
                }
                let _e776 = phi_1804_;
                if (_e773 > 0i) {
                    phi_1809_ = _e773;
                } else {
                    phi_1809_ = 0i;
                }
                let _e779 = phi_1809_;
                if (_e776 < _e757) {
                    phi_1814_ = _e776;
                } else {
                    phi_1814_ = _e757;
                }
                let _e782 = phi_1814_;
                if (_e779 < _e757) {
                    phi_1819_ = _e779;
                } else {
                    phi_1819_ = _e757;
                }
                let _e785 = phi_1819_;
                let _e786 = bitcast<u32>(_e782);
                let _e788 = (bitcast<u32>(_e769) * _e750);
                let _e789 = (bitcast<u32>(_e785) * _e750);
                let _e794 = ((_e788 + _e770) + _e755);
                let _e795 = ((_e788 + _e786) + _e755);
                let _e796 = ((_e789 + _e770) + _e755);
                let _e797 = ((_e789 + _e786) + _e755);
                if (_e794 < _e50) {
                } else {
                    return;
                }
                let _e801 = map.member[(0u + _e794)];
                if (_e795 < _e50) {
                } else {
                    return;
                }
                let _e813 = map.member[(0u + _e795)];
                if (_e796 < _e50) {
                } else {
                    return;
                }
                let _e829 = map.member[(0u + _e796)];
                if (_e797 < _e50) {
                } else {
                    return;
                }
                let _e845 = map.member[(0u + _e797)];
                let _e859 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_1), vec4<f32>(((((_e801.x * _e740) + (_e813.x * _e742)) + (_e829.x * _e744)) + (_e845.x * _e745)), ((((_e801.y * _e740) + (_e813.y * _e742)) + (_e829.y * _e744)) + (_e845.y * _e745)), ((((_e801.z * _e740) + (_e813.z * _e742)) + (_e829.z * _e744)) + (_e845.z * _e745)), ((((_e801.w * _e740) + (_e813.w * _e742)) + (_e829.w * _e744)) + (_e845.w * _e745))), _e654);
                let _e861 = p.member.fade_uv;
                if (_e861 > 0f) {
                    let _e864 = local_5;
                    if ((_e864.level + 1u) == _e68) {
                        let _e873 = p.member.fade_uv;
                        let _e875 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e420.point.uv.x, (1f - _e420.point.uv.x));
                        let _e877 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e420.point.uv.y, (1f - _e420.point.uv.y));
                        let _e878 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e875, _e877);
                        if (_e878 < _e873) {
                            phi_1935_ = (1f - ((1f - _e859) * (_e878 / _e873)));
                        } else {
                            phi_1935_ = _e859;
                        }
                        let _e885 = phi_1935_;
                        phi_1937_ = evaluate_Verdict(_e885, false);
                        phi_1938_ = false;
                    } else {
                        phi_1937_ = evaluate_Verdict();
                        phi_1938_ = true;
                    }
                    let _e888 = phi_1937_;
                    let _e890 = phi_1938_;
                    phi_1939_ = _e888;
                    phi_1940_ = _e890;
                } else {
                    phi_1939_ = evaluate_Verdict();
                    phi_1940_ = true;
                }
                let _e892 = phi_1939_;
                let _e894 = phi_1940_;
                if _e894 {
                    phi_1945_ = evaluate_Verdict(_e859, false);
                    phi_1946_ = false;
                } else {
                    phi_1945_ = evaluate_Verdict();
                    phi_1946_ = true;
                }
                let _e897 = phi_1945_;
                let _e899 = phi_1946_;
                phi_1948_ = _e897;
                phi_1949_ = _e892;
                phi_1950_ = _e899;
            } else {
                phi_1948_ = evaluate_Verdict();
                phi_1949_ = evaluate_Verdict(1f, false);
                phi_1950_ = true;
            }
            let _e902 = phi_1948_;
            let _e904 = phi_1949_;
            let _e906 = phi_1950_;
            if _e906 {
            }
            phi_1954_ = _e904;
            phi_1955_ = _e902;
            phi_1956_ = _e906;
        }
        let _e908 = phi_1954_;
        let _e910 = phi_1955_;
        let _e912 = phi_1956_;
        if _e912 {
            phi_1960_ = _e908;
        } else {
            phi_1960_ = _e910;
        }
        let _e914 = phi_1960_;
        if (_e62.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e62.first_primitive)] = _e914.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_msm_hausdorff_prefiltered_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
