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

struct type_20 {
    member: array<abi_Sample>,
}

struct type_24 {
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

struct type_39 {
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

struct type_43 {
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

struct type_53 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
var<private> local_3: u32;
@group(0) @binding(1) 
var<storage> samples: type_20;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(0) 
var<uniform> p: type_43;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_24;
@group(0) @binding(4) 
var<storage, read_write> list: type_53;
@group(0) @binding(2) 
var<storage> map: type_39;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_170_: lt_bvh_traverse_Tree;
    var phi_171_: bool;
    var phi_172_: lt_bvh_traverse_Tree;
    var phi_173_: bool;
    var phi_178_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_170_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_171_ = false;
        } else {
            phi_170_ = lt_bvh_traverse_Tree();
            phi_171_ = true;
        }
        let _e57 = phi_170_;
        let _e59 = phi_171_;
        phi_172_ = _e57;
        phi_173_ = _e59;
    } else {
        phi_172_ = lt_bvh_traverse_Tree();
        phi_173_ = true;
    }
    let _e61 = phi_172_;
    let _e63 = phi_173_;
    if _e63 {
        phi_178_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_178_ = _e61;
    }
    let _e68 = phi_178_;
    return lt_bvh_traverse_Tree(_e68.root, _e68.first_primitive);
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn lt_math_hausdorff_cubic_mass(param_4: vec4<f32>, param_5: f32, param_6: f32, param_7: f32, param_8: f32) -> f32 {
    return ((((param_4.z - (((param_6 + param_7) + param_8) * param_4.y)) + ((((param_6 * param_7) + (param_6 * param_8)) + (param_7 * param_8)) * param_4.x)) - ((param_6 * param_7) * param_8)) / (((param_5 - param_6) * (param_5 - param_7)) * (param_5 - param_8)));
}

fn lt_math_hausdorff_endpoint_upper_bound(param_9: ptr<function, hankel_HankelFactors>, param_10: f32) -> f32 {
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

    let _e47 = (*param_9).moments;
    if (param_10 < 0.0001f) {
        phi_1027_ = 1f;
    } else {
        let _e56 = ((_e47.z - ((1f + param_10) * _e47.y)) + (param_10 * _e47.x));
        let _e65 = (((_e47.w - ((1f + param_10) * _e47.z)) + (param_10 * _e47.y)) / _e56);
        if (abs(_e56) <= 0.00000047683716f) {
            let _e79 = (1f - (((_e47.y - (_e47.x * (param_10 + 1f))) + (param_10 * 1f)) / ((0f - param_10) * (0f - 1f))));
            if ((bitcast<u32>(_e79) & 2147483647u) > 2139095040u) {
                phi_950_ = _e79;
            } else {
                if (_e79 < 0f) {
                    phi_949_ = 0f;
                } else {
                    if (_e79 > 1f) {
                        phi_948_ = 1f;
                    } else {
                        phi_948_ = _e79;
                    }
                    let _e86 = phi_948_;
                    phi_949_ = _e86;
                }
                let _e88 = phi_949_;
                phi_950_ = _e88;
            }
            let _e90 = phi_950_;
            phi_1026_ = _e90;
        } else {
            if (_e65 > 0f) {
                if (_e65 < param_10) {
                    let _e93 = lt_math_hausdorff_cubic_mass(_e47, 0f, _e65, param_10, 1f);
                    let _e95 = lt_math_hausdorff_cubic_mass(_e47, _e65, 0f, param_10, 1f);
                    let _e96 = ((1f - _e93) - _e95);
                    if ((bitcast<u32>(_e96) & 2147483647u) > 2139095040u) {
                        phi_979_ = _e96;
                    } else {
                        if (_e96 < 0f) {
                            phi_978_ = 0f;
                        } else {
                            if (_e96 > 1f) {
                                phi_977_ = 1f;
                            } else {
                                phi_977_ = _e96;
                            }
                            let _e103 = phi_977_;
                            phi_978_ = _e103;
                        }
                        let _e105 = phi_978_;
                        phi_979_ = _e105;
                    }
                    let _e107 = phi_979_;
                    phi_980_ = _e107;
                    phi_981_ = false;
                } else {
                    phi_980_ = f32();
                    phi_981_ = true;
                }
                let _e109 = phi_980_;
                let _e111 = phi_981_;
                phi_982_ = _e109;
                phi_983_ = _e111;
            } else {
                phi_982_ = f32();
                phi_983_ = true;
            }
            let _e113 = phi_982_;
            let _e115 = phi_983_;
            if _e115 {
                if (_e65 > param_10) {
                    if (_e65 < 1f) {
                        let _e118 = lt_math_hausdorff_cubic_mass(_e47, 0f, _e65, param_10, 1f);
                        let _e119 = (1f - _e118);
                        if ((bitcast<u32>(_e119) & 2147483647u) > 2139095040u) {
                            phi_1013_ = _e119;
                        } else {
                            if (_e119 < 0f) {
                                phi_1012_ = 0f;
                            } else {
                                if (_e119 > 1f) {
                                    phi_1011_ = 1f;
                                } else {
                                    phi_1011_ = _e119;
                                }
                                let _e126 = phi_1011_;
                                phi_1012_ = _e126;
                            }
                            let _e128 = phi_1012_;
                            phi_1013_ = _e128;
                        }
                        let _e130 = phi_1013_;
                        phi_1014_ = _e130;
                        phi_1015_ = false;
                    } else {
                        phi_1014_ = f32();
                        phi_1015_ = true;
                    }
                    let _e132 = phi_1014_;
                    let _e134 = phi_1015_;
                    phi_1016_ = _e132;
                    phi_1017_ = _e134;
                } else {
                    phi_1016_ = f32();
                    phi_1017_ = true;
                }
                let _e136 = phi_1016_;
                let _e138 = phi_1017_;
                if _e138 {
                    phi_1024_ = bitcast<f32>((bitcast<u32>(_e65) | 2143289344u));
                } else {
                    phi_1024_ = _e136;
                }
                let _e143 = phi_1024_;
                phi_1025_ = _e143;
            } else {
                phi_1025_ = _e113;
            }
            let _e145 = phi_1025_;
            phi_1026_ = _e145;
        }
        let _e147 = phi_1026_;
        phi_1027_ = _e147;
    }
    let _e149 = phi_1027_;
    return _e149;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_11: ptr<function, f32>, param_12: vec4<f32>, param_13: f32) -> f32 {
    var local_1: hankel_HankelFactors;
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

    let _e48 = (*param_11);
    let _e49 = (1f - _e48);
    let _e58 = (0.5f * _e48);
    let _e59 = ((param_12.x * _e49) + _e58);
    let _e60 = ((param_12.y * _e49) + _e58);
    let _e61 = ((param_12.z * _e49) + _e58);
    let _e62 = ((param_12.w * _e49) + _e58);
    let _e65 = (_e60 - (_e59 * _e59));
    let _e67 = (_e61 - (_e59 * _e60));
    let _e73 = hankel_HankelFactors(vec4<f32>(_e59, _e60, _e61, _e62), _e65, _e67, (((_e62 - (_e60 * _e60)) * _e65) - (_e67 * _e67)));
    local_1 = hankel_HankelFactors(_e73.moments, _e73.d22_, _e73.l32_d22_, _e73.d33_d22_);
    if ((bitcast<u32>(param_13) & 2147483647u) > 2139095040u) {
        phi_237_ = param_13;
    } else {
        if (param_13 < 0f) {
            phi_236_ = 0f;
        } else {
            if (param_13 > 1f) {
                phi_235_ = 1f;
            } else {
                phi_235_ = param_13;
            }
            let _e85 = phi_235_;
            phi_236_ = _e85;
        }
        let _e87 = phi_236_;
        phi_237_ = _e87;
    }
    let _e89 = phi_237_;
    let _e92 = local_1.moments[0u];
    let _e95 = local_1.moments[3u];
    if (_e92 == _e95) {
        let _e99 = local_1.moments[0u];
        phi_249_ = (_e99 > 0.5f);
    } else {
        phi_249_ = false;
    }
    let _e102 = phi_249_;
    if _e102 {
        let _e105 = local_1.moments[0u];
        let _e108 = local_1.moments[3u];
        if (_e105 == _e108) {
            let _e112 = local_1.moments[0u];
            phi_264_ = (_e112 > 0.5f);
        } else {
            phi_264_ = false;
        }
        let _e115 = phi_264_;
        if _e115 {
            if (_e89 > 0f) {
                let _e118 = local_1.moments;
                if ((bitcast<u32>(_e118.x) & 2147483647u) > 2139095040u) {
                    phi_291_ = _e118.x;
                } else {
                    if (_e118.x < 0f) {
                        phi_290_ = 0f;
                    } else {
                        if (_e118.x > 1f) {
                            phi_289_ = 1f;
                        } else {
                            phi_289_ = _e118.x;
                        }
                        let _e126 = phi_289_;
                        phi_290_ = _e126;
                    }
                    let _e128 = phi_290_;
                    phi_291_ = _e128;
                }
                let _e130 = phi_291_;
                phi_292_ = _e130;
                phi_293_ = false;
            } else {
                phi_292_ = f32();
                phi_293_ = true;
            }
            let _e132 = phi_292_;
            let _e134 = phi_293_;
            phi_294_ = _e132;
            phi_295_ = _e134;
        } else {
            phi_294_ = f32();
            phi_295_ = true;
        }
        let _e136 = phi_294_;
        let _e138 = phi_295_;
        if _e138 {
            let _e141 = local_1.moments[0u];
            let _e144 = local_1.moments[1u];
            let _e152 = local_1.l32_d22_;
            let _e154 = local_1.d22_;
            let _e155 = (_e152 / _e154);
            let _e156 = (_e89 - _e141);
            let _e162 = local_1.d22_;
            let _e165 = local_1.d33_d22_;
            let _e166 = (((((_e89 * _e89) - _e144) - (_e155 * _e156)) * _e162) / _e165);
            let _e168 = local_1.d22_;
            let _e171 = ((_e156 / _e168) - (_e155 * _e166));
            let _e177 = ((0.5f * _e171) / _e166);
            let _e180 = ((_e177 * _e177) - (((1f - (_e171 * _e141)) - (_e166 * _e144)) / _e166));
            if (_e180 >= 0f) {
                let _e182 = sqrt(_e180);
                phi_351_ = vec2<f32>((-(_e177) - _e182), (-(_e177) + _e182));
            } else {
                phi_351_ = vec2(bitcast<f32>((bitcast<u32>(_e180) | 2143289344u)));
            }
            let _e193 = phi_351_;
            if (_e89 <= _e193.x) {
                phi_432_ = 1f;
            } else {
                if (_e89 > _e193.y) {
                    let _e199 = local_1.moments;
                    let _e210 = (((_e199.y - (_e199.x * (_e193.x + _e193.y))) + (_e193.x * _e193.y)) / ((_e89 - _e193.x) * (_e89 - _e193.y)));
                    if ((bitcast<u32>(_e210) & 2147483647u) > 2139095040u) {
                        phi_391_ = _e210;
                    } else {
                        if (_e210 < 0f) {
                            phi_390_ = 0f;
                        } else {
                            if (_e210 > 1f) {
                                phi_389_ = 1f;
                            } else {
                                phi_389_ = _e210;
                            }
                            let _e217 = phi_389_;
                            phi_390_ = _e217;
                        }
                        let _e219 = phi_390_;
                        phi_391_ = _e219;
                    }
                    let _e221 = phi_391_;
                    phi_431_ = _e221;
                } else {
                    if (_e89 > _e193.x) {
                        let _e224 = local_1.moments;
                        let _e236 = (1f - (((_e224.y - (_e224.x * (_e89 + _e193.y))) + (_e89 * _e193.y)) / ((_e193.x - _e89) * (_e193.x - _e193.y))));
                        if ((bitcast<u32>(_e236) & 2147483647u) > 2139095040u) {
                            phi_426_ = _e236;
                        } else {
                            if (_e236 < 0f) {
                                phi_425_ = 0f;
                            } else {
                                if (_e236 > 1f) {
                                    phi_424_ = 1f;
                                } else {
                                    phi_424_ = _e236;
                                }
                                let _e243 = phi_424_;
                                phi_425_ = _e243;
                            }
                            let _e245 = phi_425_;
                            phi_426_ = _e245;
                        }
                        let _e247 = phi_426_;
                        phi_430_ = _e247;
                    } else {
                        phi_430_ = bitcast<f32>((bitcast<u32>(_e193.x) | 2143289344u));
                    }
                    let _e252 = phi_430_;
                    phi_431_ = _e252;
                }
                let _e254 = phi_431_;
                phi_432_ = _e254;
            }
            let _e256 = phi_432_;
            phi_433_ = _e256;
        } else {
            phi_433_ = _e136;
        }
        let _e258 = phi_433_;
        phi_890_ = _e258;
    } else {
        let _e261 = local_1.moments[0u];
        let _e264 = local_1.moments[1u];
        let _e272 = local_1.l32_d22_;
        let _e274 = local_1.d22_;
        let _e275 = (_e272 / _e274);
        let _e276 = (_e89 - _e261);
        let _e282 = local_1.d22_;
        let _e285 = local_1.d33_d22_;
        let _e286 = (((((_e89 * _e89) - _e264) - (_e275 * _e276)) * _e282) / _e285);
        let _e288 = local_1.d22_;
        let _e291 = ((_e276 / _e288) - (_e275 * _e286));
        let _e297 = ((0.5f * _e291) / _e286);
        let _e300 = ((_e297 * _e297) - (((1f - (_e291 * _e261)) - (_e286 * _e264)) / _e286));
        if (_e300 >= 0f) {
            let _e302 = sqrt(_e300);
            phi_486_ = vec2<f32>((-(_e297) - _e302), (-(_e297) + _e302));
        } else {
            phi_486_ = vec2(bitcast<f32>((bitcast<u32>(_e300) | 2143289344u)));
        }
        let _e313 = phi_486_;
        if (_e313.x >= 0f) {
            if (_e313.y <= 1f) {
                let _e320 = local_1.moments[0u];
                let _e323 = local_1.moments[3u];
                if (_e320 == _e323) {
                    let _e327 = local_1.moments[0u];
                    phi_508_ = (_e327 > 0.5f);
                } else {
                    phi_508_ = false;
                }
                let _e330 = phi_508_;
                if _e330 {
                    if (_e89 > 0f) {
                        let _e333 = local_1.moments;
                        if ((bitcast<u32>(_e333.x) & 2147483647u) > 2139095040u) {
                            phi_535_ = _e333.x;
                        } else {
                            if (_e333.x < 0f) {
                                phi_534_ = 0f;
                            } else {
                                if (_e333.x > 1f) {
                                    phi_533_ = 1f;
                                } else {
                                    phi_533_ = _e333.x;
                                }
                                let _e341 = phi_533_;
                                phi_534_ = _e341;
                            }
                            let _e343 = phi_534_;
                            phi_535_ = _e343;
                        }
                        let _e345 = phi_535_;
                        phi_536_ = _e345;
                        phi_537_ = false;
                    } else {
                        phi_536_ = f32();
                        phi_537_ = true;
                    }
                    let _e347 = phi_536_;
                    let _e349 = phi_537_;
                    phi_538_ = _e347;
                    phi_539_ = _e349;
                } else {
                    phi_538_ = f32();
                    phi_539_ = true;
                }
                let _e351 = phi_538_;
                let _e353 = phi_539_;
                if _e353 {
                    let _e356 = local_1.moments[0u];
                    let _e359 = local_1.moments[1u];
                    let _e367 = local_1.l32_d22_;
                    let _e369 = local_1.d22_;
                    let _e370 = (_e367 / _e369);
                    let _e371 = (_e89 - _e356);
                    let _e377 = local_1.d22_;
                    let _e380 = local_1.d33_d22_;
                    let _e381 = (((((_e89 * _e89) - _e359) - (_e370 * _e371)) * _e377) / _e380);
                    let _e383 = local_1.d22_;
                    let _e386 = ((_e371 / _e383) - (_e370 * _e381));
                    let _e392 = ((0.5f * _e386) / _e381);
                    let _e395 = ((_e392 * _e392) - (((1f - (_e386 * _e356)) - (_e381 * _e359)) / _e381));
                    if (_e395 >= 0f) {
                        let _e397 = sqrt(_e395);
                        phi_595_ = vec2<f32>((-(_e392) - _e397), (-(_e392) + _e397));
                    } else {
                        phi_595_ = vec2(bitcast<f32>((bitcast<u32>(_e395) | 2143289344u)));
                    }
                    let _e408 = phi_595_;
                    if (_e89 <= _e408.x) {
                        phi_676_ = 1f;
                    } else {
                        if (_e89 > _e408.y) {
                            let _e414 = local_1.moments;
                            let _e425 = (((_e414.y - (_e414.x * (_e408.x + _e408.y))) + (_e408.x * _e408.y)) / ((_e89 - _e408.x) * (_e89 - _e408.y)));
                            if ((bitcast<u32>(_e425) & 2147483647u) > 2139095040u) {
                                phi_635_ = _e425;
                            } else {
                                if (_e425 < 0f) {
                                    phi_634_ = 0f;
                                } else {
                                    if (_e425 > 1f) {
                                        phi_633_ = 1f;
                                    } else {
                                        phi_633_ = _e425;
                                    }
                                    let _e432 = phi_633_;
                                    phi_634_ = _e432;
                                }
                                let _e434 = phi_634_;
                                phi_635_ = _e434;
                            }
                            let _e436 = phi_635_;
                            phi_675_ = _e436;
                        } else {
                            if (_e89 > _e408.x) {
                                let _e439 = local_1.moments;
                                let _e451 = (1f - (((_e439.y - (_e439.x * (_e89 + _e408.y))) + (_e89 * _e408.y)) / ((_e408.x - _e89) * (_e408.x - _e408.y))));
                                if ((bitcast<u32>(_e451) & 2147483647u) > 2139095040u) {
                                    phi_670_ = _e451;
                                } else {
                                    if (_e451 < 0f) {
                                        phi_669_ = 0f;
                                    } else {
                                        if (_e451 > 1f) {
                                            phi_668_ = 1f;
                                        } else {
                                            phi_668_ = _e451;
                                        }
                                        let _e458 = phi_668_;
                                        phi_669_ = _e458;
                                    }
                                    let _e460 = phi_669_;
                                    phi_670_ = _e460;
                                }
                                let _e462 = phi_670_;
                                phi_674_ = _e462;
                            } else {
                                phi_674_ = bitcast<f32>((bitcast<u32>(_e408.x) | 2143289344u));
                            }
                            let _e467 = phi_674_;
                            phi_675_ = _e467;
                        }
                        let _e469 = phi_675_;
                        phi_676_ = _e469;
                    }
                    let _e471 = phi_676_;
                    phi_677_ = _e471;
                } else {
                    phi_677_ = _e351;
                }
                let _e473 = phi_677_;
                phi_678_ = _e473;
                phi_679_ = false;
            } else {
                phi_678_ = f32();
                phi_679_ = true;
            }
            let _e475 = phi_678_;
            let _e477 = phi_679_;
            phi_680_ = _e475;
            phi_681_ = _e477;
        } else {
            phi_680_ = f32();
            phi_681_ = true;
        }
        let _e479 = phi_680_;
        let _e481 = phi_681_;
        if _e481 {
            if ((bitcast<u32>(_e313.x) & 2147483647u) > 2139095040u) {
                phi_888_ = _e313.x;
            } else {
                let _e485 = lt_math_hausdorff_endpoint_upper_bound((&local_1), _e89);
                let _e488 = local_1.moments[0u];
                let _e491 = local_1.moments[3u];
                if (_e488 == _e491) {
                    let _e495 = local_1.moments[0u];
                    phi_703_ = (_e495 > 0.5f);
                } else {
                    phi_703_ = false;
                }
                let _e498 = phi_703_;
                if _e498 {
                    if (_e89 > 0f) {
                        let _e501 = local_1.moments;
                        if ((bitcast<u32>(_e501.x) & 2147483647u) > 2139095040u) {
                            phi_730_ = _e501.x;
                        } else {
                            if (_e501.x < 0f) {
                                phi_729_ = 0f;
                            } else {
                                if (_e501.x > 1f) {
                                    phi_728_ = 1f;
                                } else {
                                    phi_728_ = _e501.x;
                                }
                                let _e509 = phi_728_;
                                phi_729_ = _e509;
                            }
                            let _e511 = phi_729_;
                            phi_730_ = _e511;
                        }
                        let _e513 = phi_730_;
                        phi_731_ = _e513;
                        phi_732_ = false;
                    } else {
                        phi_731_ = f32();
                        phi_732_ = true;
                    }
                    let _e515 = phi_731_;
                    let _e517 = phi_732_;
                    phi_733_ = _e515;
                    phi_734_ = _e517;
                } else {
                    phi_733_ = f32();
                    phi_734_ = true;
                }
                let _e519 = phi_733_;
                let _e521 = phi_734_;
                if _e521 {
                    let _e524 = local_1.moments[0u];
                    let _e527 = local_1.moments[1u];
                    let _e535 = local_1.l32_d22_;
                    let _e537 = local_1.d22_;
                    let _e538 = (_e535 / _e537);
                    let _e539 = (_e89 - _e524);
                    let _e545 = local_1.d22_;
                    let _e548 = local_1.d33_d22_;
                    let _e549 = (((((_e89 * _e89) - _e527) - (_e538 * _e539)) * _e545) / _e548);
                    let _e551 = local_1.d22_;
                    let _e554 = ((_e539 / _e551) - (_e538 * _e549));
                    let _e560 = ((0.5f * _e554) / _e549);
                    let _e563 = ((_e560 * _e560) - (((1f - (_e554 * _e524)) - (_e549 * _e527)) / _e549));
                    if (_e563 >= 0f) {
                        let _e565 = sqrt(_e563);
                        phi_790_ = vec2<f32>((-(_e560) - _e565), (-(_e560) + _e565));
                    } else {
                        phi_790_ = vec2(bitcast<f32>((bitcast<u32>(_e563) | 2143289344u)));
                    }
                    let _e576 = phi_790_;
                    if (_e89 <= _e576.x) {
                        phi_871_ = 1f;
                    } else {
                        if (_e89 > _e576.y) {
                            let _e582 = local_1.moments;
                            let _e593 = (((_e582.y - (_e582.x * (_e576.x + _e576.y))) + (_e576.x * _e576.y)) / ((_e89 - _e576.x) * (_e89 - _e576.y)));
                            if ((bitcast<u32>(_e593) & 2147483647u) > 2139095040u) {
                                phi_830_ = _e593;
                            } else {
                                if (_e593 < 0f) {
                                    phi_829_ = 0f;
                                } else {
                                    if (_e593 > 1f) {
                                        phi_828_ = 1f;
                                    } else {
                                        phi_828_ = _e593;
                                    }
                                    let _e600 = phi_828_;
                                    phi_829_ = _e600;
                                }
                                let _e602 = phi_829_;
                                phi_830_ = _e602;
                            }
                            let _e604 = phi_830_;
                            phi_870_ = _e604;
                        } else {
                            if (_e89 > _e576.x) {
                                let _e607 = local_1.moments;
                                let _e619 = (1f - (((_e607.y - (_e607.x * (_e89 + _e576.y))) + (_e89 * _e576.y)) / ((_e576.x - _e89) * (_e576.x - _e576.y))));
                                if ((bitcast<u32>(_e619) & 2147483647u) > 2139095040u) {
                                    phi_865_ = _e619;
                                } else {
                                    if (_e619 < 0f) {
                                        phi_864_ = 0f;
                                    } else {
                                        if (_e619 > 1f) {
                                            phi_863_ = 1f;
                                        } else {
                                            phi_863_ = _e619;
                                        }
                                        let _e626 = phi_863_;
                                        phi_864_ = _e626;
                                    }
                                    let _e628 = phi_864_;
                                    phi_865_ = _e628;
                                }
                                let _e630 = phi_865_;
                                phi_869_ = _e630;
                            } else {
                                phi_869_ = bitcast<f32>((bitcast<u32>(_e576.x) | 2143289344u));
                            }
                            let _e635 = phi_869_;
                            phi_870_ = _e635;
                        }
                        let _e637 = phi_870_;
                        phi_871_ = _e637;
                    }
                    let _e639 = phi_871_;
                    phi_872_ = _e639;
                } else {
                    phi_872_ = _e519;
                }
                let _e641 = phi_872_;
                if ((bitcast<u32>(_e641) & 2147483647u) > 2139095040u) {
                    phi_883_ = true;
                } else {
                    let _e645 = (_e641 < _e485);
                    if _e645 {
                    }
                    phi_883_ = _e645;
                }
                let _e647 = phi_883_;
                if _e647 {
                    phi_887_ = _e641;
                } else {
                    phi_887_ = _e485;
                }
                let _e649 = phi_887_;
                phi_888_ = _e649;
            }
            let _e651 = phi_888_;
            phi_889_ = _e651;
        } else {
            phi_889_ = _e479;
        }
        let _e653 = phi_889_;
        phi_890_ = _e653;
    }
    let _e655 = phi_890_;
    return _e655;
}

fn function_() {
    var local_2: f32;
    var phi_1107_: bool;
    var phi_1108_: bool;
    var phi_1109_: bool;
    var phi_1110_: bool;
    var phi_1114_: bool;
    var phi_1184_: bool;
    var phi_1185_: bool;
    var phi_1196_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1197_: bool;
    var phi_1198_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1199_: bool;
    var phi_1206_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1210_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1284_: bool;
    var phi_1293_: bool;
    var phi_1302_: bool;
    var phi_1303_: bool;
    var phi_1304_: bool;
    var phi_1305_: bool;
    var phi_1306_: bool;
    var phi_1307_: bool;
    var phi_1308_: bool;
    var phi_1312_: bool;
    var phi_1402_: f32;
    var phi_1405_: f32;
    var phi_1434_: f32;
    var phi_1439_: f32;
    var phi_1440_: bool;
    var phi_1441_: f32;
    var phi_1442_: bool;
    var phi_1446_: f32;
    var phi_1466_: f32;
    var phi_1471_: f32;
    var phi_1472_: bool;
    var phi_1473_: f32;
    var phi_1474_: bool;
    var phi_1478_: f32;
    var phi_1526_: i32;
    var phi_1531_: i32;
    var phi_1536_: i32;
    var phi_1541_: i32;
    var phi_1550_: i32;
    var phi_1555_: i32;
    var phi_1560_: i32;
    var phi_1565_: i32;
    var phi_1662_: bool;
    var phi_1670_: bool;
    var phi_1682_: bool;
    var phi_1683_: bool;
    var phi_1687_: f32;
    var phi_1693_: f32;
    var phi_1695_: evaluate_Verdict;
    var phi_1705_: u32;
    var phi_1714_: f32;
    var phi_1716_: evaluate_Verdict;
    var phi_1717_: bool;
    var phi_1718_: evaluate_Verdict;
    var phi_1719_: bool;
    var phi_1724_: evaluate_Verdict;
    var phi_1729_: evaluate_Verdict;
    var phi_1730_: evaluate_Verdict;
    var phi_1734_: bool;
    var phi_1735_: u32;
    var phi_1746_: u32;
    var phi_1763_: u32;

    let _e45 = id_1;
    let _e46 = local_3;
    let _e51 = arrayLength((&map.member));
    let _e56 = p.member.size[0u];
    let _e58 = p.member.size[1u];
    let _e59 = lt_shaders_entry_pixel_index(_e45, _e56, _e58);
    if (bitcast<i32>(_e59.root) != 0i) {
        let _e66 = p.member.projection;
        let _e67 = lt_math_OneLevel(_e66);
        let _e71 = samples.member[_e59.first_primitive].normal[0u];
        let _e73 = global[0u];
        if (_e71 == _e73) {
            let _e76 = samples.member[_e59.first_primitive].normal[1u];
            let _e78 = global[1u];
            if (_e76 == _e78) {
                let _e81 = samples.member[_e59.first_primitive].normal[2u];
                let _e83 = global[2u];
                phi_1107_ = (_e81 == _e83);
                phi_1108_ = false;
            } else {
                phi_1107_ = bool();
                phi_1108_ = true;
            }
            let _e86 = phi_1107_;
            let _e88 = phi_1108_;
            phi_1109_ = _e86;
            phi_1110_ = _e88;
        } else {
            phi_1109_ = bool();
            phi_1110_ = true;
        }
        let _e90 = phi_1109_;
        let _e92 = phi_1110_;
        if _e92 {
            phi_1114_ = false;
        } else {
            phi_1114_ = _e90;
        }
        let _e94 = phi_1114_;
        if !(_e94) {
            let _e97 = samples.member[_e59.first_primitive].position;
            let _e99 = p.member.light.place;
            let _e105 = p.member.light.place[3u];
            let _e112 = (_e99.x - (_e97.x * _e105));
            let _e113 = (_e99.y - (_e97.y * _e105));
            let _e114 = (_e99.z - (_e97.z * _e105));
            let _e116 = samples.member[_e59.first_primitive].normal;
            if ((((_e116.x * _e112) + (_e116.y * _e113)) + (_e116.z * _e114)) > 0f) {
                let _e130 = (((_e112 * _e112) + (_e113 * _e113)) + (_e114 * _e114));
                let _e132 = p.member.light.axis;
                let _e144 = p.member.light.place[3u];
                if (_e144 == 0f) {
                    phi_1185_ = true;
                } else {
                    let _e147 = p.member.light.range_squared;
                    if (_e130 <= _e147) {
                        let _e150 = p.member.light.cos_outer;
                        phi_1184_ = (-((((_e112 * _e132.x) + (_e113 * _e132.y)) + (_e114 * _e132.z))) >= (_e150 * sqrt(_e130)));
                    } else {
                        phi_1184_ = false;
                    }
                    let _e155 = phi_1184_;
                    phi_1185_ = _e155;
                }
                let _e157 = phi_1185_;
                if _e157 {
                    let _e159 = samples.member[_e59.first_primitive].flags;
                    let _e167 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e173 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e167.unnamed.visibility, false), _e167.unnamed_1);
                    phi_1196_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e173.unnamed, ((_e159 & 1u) == 0u));
                    phi_1197_ = false;
                } else {
                    phi_1196_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_1197_ = true;
                }
                let _e178 = phi_1196_;
                let _e180 = phi_1197_;
                phi_1198_ = _e178;
                phi_1199_ = _e180;
            } else {
                phi_1198_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_1199_ = true;
            }
            let _e182 = phi_1198_;
            let _e184 = phi_1199_;
            if _e184 {
                let _e190 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e196 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e190.unnamed.visibility, false), _e190.unnamed_1);
                phi_1206_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e196.unnamed, true);
            } else {
                phi_1206_ = _e182;
            }
            let _e201 = phi_1206_;
            phi_1210_ = _e201;
        } else {
            let _e207 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e213 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e207.unnamed.visibility, false), _e207.unnamed_1);
            phi_1210_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e213.unnamed, true);
        }
        let _e218 = phi_1210_;
        if _e218.unnamed_1 {
            phi_1730_ = evaluate_Verdict(_e218.unnamed.visibility, _e218.unnamed.is_doubted);
        } else {
            let _e226 = samples.member[_e59.first_primitive].position;
            let _e244 = ((((_e67.projection.row_w.x * _e226.x) + (_e67.projection.row_w.y * _e226.y)) + (_e67.projection.row_w.z * _e226.z)) + (_e67.projection.row_w.w * 1f));
            let _e258 = (((((_e67.projection.row_x.x * _e226.x) + (_e67.projection.row_x.y * _e226.y)) + (_e67.projection.row_x.z * _e226.z)) + (_e67.projection.row_x.w * 1f)) / _e244);
            let _e272 = (((((_e67.projection.row_y.x * _e226.x) + (_e67.projection.row_y.y * _e226.y)) + (_e67.projection.row_y.z * _e226.z)) + (_e67.projection.row_y.w * 1f)) / _e244);
            let _e285 = ((((_e67.projection.row_z.x * _e226.x) + (_e67.projection.row_z.y * _e226.y)) + (_e67.projection.row_z.z * _e226.z)) + (_e67.projection.row_z.w * 1f));
            if (_e244 > 0f) {
                if (_e258 >= 0f) {
                    phi_1284_ = (_e258 <= 1f);
                } else {
                    phi_1284_ = false;
                }
                let _e290 = phi_1284_;
                if _e290 {
                    if (_e272 >= 0f) {
                        phi_1293_ = (_e272 <= 1f);
                    } else {
                        phi_1293_ = false;
                    }
                    let _e294 = phi_1293_;
                    if _e294 {
                        if (_e285 >= 0f) {
                            phi_1302_ = (_e285 <= 1f);
                        } else {
                            phi_1302_ = false;
                        }
                        let _e298 = phi_1302_;
                        phi_1303_ = _e298;
                        phi_1304_ = false;
                    } else {
                        phi_1303_ = bool();
                        phi_1304_ = true;
                    }
                    let _e300 = phi_1303_;
                    let _e302 = phi_1304_;
                    phi_1305_ = _e300;
                    phi_1306_ = _e302;
                } else {
                    phi_1305_ = bool();
                    phi_1306_ = true;
                }
                let _e304 = phi_1305_;
                let _e306 = phi_1306_;
                phi_1307_ = _e304;
                phi_1308_ = _e306;
            } else {
                phi_1307_ = bool();
                phi_1308_ = true;
            }
            let _e308 = phi_1307_;
            let _e310 = phi_1308_;
            if _e310 {
                phi_1312_ = false;
            } else {
                phi_1312_ = _e308;
            }
            let _e312 = phi_1312_;
            if _e312 {
                if (0f > 0f) {
                    let _e315 = samples.member[_e59.first_primitive].normal;
                    let _e317 = p.member.map_size;
                    let _e387 = ((abs(((((_e66.row_x.x * _e315.x) + (_e66.row_x.y * _e315.y)) + (_e66.row_x.z * _e315.z)) / (((_e66.row_x.x * _e66.row_x.x) + (_e66.row_x.y * _e66.row_x.y)) + (_e66.row_x.z * _e66.row_x.z)))) + abs(((((_e66.row_y.x * _e315.x) + (_e66.row_y.y * _e315.y)) + (_e66.row_y.z * _e315.z)) / (((_e66.row_y.x * _e66.row_y.x) + (_e66.row_y.y * _e66.row_y.y)) + (_e66.row_y.z * _e66.row_y.z))))) / (abs(((((_e66.row_z.x * _e315.x) + (_e66.row_z.y * _e315.y)) + (_e66.row_z.z * _e315.z)) / (((_e66.row_z.x * _e66.row_z.x) + (_e66.row_z.y * _e66.row_z.y)) + (_e66.row_z.z * _e66.row_z.z)))) * f32(_e317)));
                    if (_e387 < 0.002f) {
                        phi_1402_ = _e387;
                    } else {
                        phi_1402_ = 0.002f;
                    }
                    let _e390 = phi_1402_;
                    phi_1405_ = (_e285 - (0f * _e390));
                } else {
                    phi_1405_ = _e285;
                }
                let _e394 = phi_1405_;
                let _e396 = p.member.map_size;
                let _e397 = f32(_e396);
                let _e400 = ((_e258 * _e397) - 0.5f);
                let _e401 = ((_e272 * _e397) - 0.5f);
                if (_e400 > -8388608f) {
                    let _e413 = f32(select(0i, select(select(i32(_e400), i32(-2147483648), (_e400 < bitcast<f32>(3472883712u))), 2147483647i, (_e400 > bitcast<f32>(1325400063u))), (_e400 == _e400)));
                    if (_e413 > _e400) {
                        phi_1434_ = 1f;
                    } else {
                        phi_1434_ = 0f;
                    }
                    let _e416 = phi_1434_;
                    if (_e400 < 8388608f) {
                        phi_1439_ = (_e413 - _e416);
                        phi_1440_ = false;
                    } else {
                        phi_1439_ = f32();
                        phi_1440_ = true;
                    }
                    let _e419 = phi_1439_;
                    let _e421 = phi_1440_;
                    phi_1441_ = _e419;
                    phi_1442_ = _e421;
                } else {
                    phi_1441_ = f32();
                    phi_1442_ = true;
                }
                let _e423 = phi_1441_;
                let _e425 = phi_1442_;
                if _e425 {
                    phi_1446_ = _e400;
                } else {
                    phi_1446_ = _e423;
                }
                let _e427 = phi_1446_;
                if (_e401 > -8388608f) {
                    let _e439 = f32(select(0i, select(select(i32(_e401), i32(-2147483648), (_e401 < bitcast<f32>(3472883712u))), 2147483647i, (_e401 > bitcast<f32>(1325400063u))), (_e401 == _e401)));
                    if (_e439 > _e401) {
                        phi_1466_ = 1f;
                    } else {
                        phi_1466_ = 0f;
                    }
                    let _e442 = phi_1466_;
                    if (_e401 < 8388608f) {
                        phi_1471_ = (_e439 - _e442);
                        phi_1472_ = false;
                    } else {
                        phi_1471_ = f32();
                        phi_1472_ = true;
                    }
                    let _e445 = phi_1471_;
                    let _e447 = phi_1472_;
                    phi_1473_ = _e445;
                    phi_1474_ = _e447;
                } else {
                    phi_1473_ = f32();
                    phi_1474_ = true;
                }
                let _e449 = phi_1473_;
                let _e451 = phi_1474_;
                if _e451 {
                    phi_1478_ = _e401;
                } else {
                    phi_1478_ = _e449;
                }
                let _e453 = phi_1478_;
                let _e454 = (_e400 - _e427);
                let _e455 = (_e401 - _e453);
                let _e464 = select(0i, select(select(i32(_e427), i32(-2147483648), (_e427 < bitcast<f32>(3472883712u))), 2147483647i, (_e427 > bitcast<f32>(1325400063u))), (_e427 == _e427));
                let _e473 = select(0i, select(select(i32(_e453), i32(-2147483648), (_e453 < bitcast<f32>(3472883712u))), 2147483647i, (_e453 > bitcast<f32>(1325400063u))), (_e453 == _e453));
                let _e476 = ((1f - _e454) * (1f - _e455));
                let _e478 = (_e454 * (1f - _e455));
                let _e480 = ((1f - _e454) * _e455);
                let _e481 = (_e454 * _e455);
                let _e483 = p.member.test;
                let _e484 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e483);
                let _e486 = p.member.map_size;
                local_2 = _e484;
                let _e488 = ((0u * _e486) * _e486);
                let _e490 = (bitcast<i32>(_e486) - 1i);
                if (_e464 > 0i) {
                    phi_1526_ = _e464;
                } else {
                    phi_1526_ = 0i;
                }
                let _e493 = phi_1526_;
                if (_e473 > 0i) {
                    phi_1531_ = _e473;
                } else {
                    phi_1531_ = 0i;
                }
                let _e496 = phi_1531_;
                if (_e493 < _e490) {
                    phi_1536_ = _e493;
                } else {
                    phi_1536_ = _e490;
                }
                let _e499 = phi_1536_;
                if (_e496 < _e490) {
                    phi_1541_ = _e496;
                } else {
                    phi_1541_ = _e490;
                }
                let _e502 = phi_1541_;
                let _e503 = bitcast<u32>(_e499);
                let _e505 = (_e464 + 1i);
                let _e506 = (_e473 + 1i);
                if (_e505 > 0i) {
                    phi_1550_ = _e505;
                } else {
                    phi_1550_ = 0i;
                }
                let _e509 = phi_1550_;
                if (_e506 > 0i) {
                    phi_1555_ = _e506;
                } else {
                    phi_1555_ = 0i;
                }
                let _e512 = phi_1555_;
                if (_e509 < _e490) {
                    phi_1560_ = _e509;
                } else {
                    phi_1560_ = _e490;
                }
                let _e515 = phi_1560_;
                if (_e512 < _e490) {
                    phi_1565_ = _e512;
                } else {
                    phi_1565_ = _e490;
                }
                let _e518 = phi_1565_;
                let _e519 = bitcast<u32>(_e515);
                let _e521 = (bitcast<u32>(_e502) * _e486);
                let _e522 = (bitcast<u32>(_e518) * _e486);
                let _e527 = ((_e521 + _e503) + _e488);
                let _e528 = ((_e521 + _e519) + _e488);
                let _e529 = ((_e522 + _e503) + _e488);
                let _e530 = ((_e522 + _e519) + _e488);
                if (_e527 < _e51) {
                } else {
                    return;
                }
                let _e534 = map.member[(0u + _e527)];
                if (_e528 < _e51) {
                } else {
                    return;
                }
                let _e546 = map.member[(0u + _e528)];
                if (_e529 < _e51) {
                } else {
                    return;
                }
                let _e562 = map.member[(0u + _e529)];
                if (_e530 < _e51) {
                } else {
                    return;
                }
                let _e578 = map.member[(0u + _e530)];
                let _e592 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_2), vec4<f32>(((((_e534.x * _e476) + (_e546.x * _e478)) + (_e562.x * _e480)) + (_e578.x * _e481)), ((((_e534.y * _e476) + (_e546.y * _e478)) + (_e562.y * _e480)) + (_e578.y * _e481)), ((((_e534.z * _e476) + (_e546.z * _e478)) + (_e562.z * _e480)) + (_e578.z * _e481)), ((((_e534.w * _e476) + (_e546.w * _e478)) + (_e562.w * _e480)) + (_e578.w * _e481))), _e394);
                let _e596 = p.member.epsilon;
                if (_e592 <= _e596) {
                    phi_1662_ = true;
                } else {
                    phi_1662_ = (_e592 >= (1f - _e596));
                }
                let _e601 = phi_1662_;
                if ((bitcast<u32>(_e592) & 2147483647u) > 2139095040u) {
                    phi_1670_ = true;
                } else {
                    phi_1670_ = !(_e601);
                }
                let _e607 = phi_1670_;
                if _e607 {
                    if (_e592 > 0f) {
                        if (_e592 < 1f) {
                            phi_1682_ = false;
                        } else {
                            phi_1682_ = true;
                        }
                        let _e611 = phi_1682_;
                        phi_1683_ = _e611;
                    } else {
                        phi_1683_ = true;
                    }
                    let _e613 = phi_1683_;
                    if _e613 {
                        phi_1687_ = 0.5f;
                    } else {
                        phi_1687_ = _e592;
                    }
                    let _e615 = phi_1687_;
                    phi_1695_ = evaluate_Verdict(_e615, true);
                } else {
                    if (_e592 > 0.5f) {
                        phi_1693_ = 1f;
                    } else {
                        phi_1693_ = 0f;
                    }
                    let _e619 = phi_1693_;
                    phi_1695_ = evaluate_Verdict(_e619, false);
                }
                let _e622 = phi_1695_;
                let _e625 = (_e622.visibility < 0.5f);
                if _e622.is_doubted {
                    phi_1718_ = evaluate_Verdict();
                    phi_1719_ = true;
                } else {
                    if _e625 {
                        phi_1705_ = 2u;
                    } else {
                        phi_1705_ = 1u;
                    }
                    let _e627 = phi_1705_;
                    if ((0u & _e627) != 0u) {
                        if _e625 {
                            phi_1714_ = 0.000000059604645f;
                        } else {
                            phi_1714_ = 0.99999994f;
                        }
                        let _e631 = phi_1714_;
                        phi_1716_ = evaluate_Verdict(_e631, true);
                        phi_1717_ = false;
                    } else {
                        phi_1716_ = evaluate_Verdict();
                        phi_1717_ = true;
                    }
                    let _e634 = phi_1716_;
                    let _e636 = phi_1717_;
                    phi_1718_ = _e634;
                    phi_1719_ = _e636;
                }
                let _e638 = phi_1718_;
                let _e640 = phi_1719_;
                if _e640 {
                    phi_1724_ = evaluate_Verdict(_e622.visibility, _e622.is_doubted);
                } else {
                    phi_1724_ = _e638;
                }
                let _e643 = phi_1724_;
                phi_1729_ = evaluate_Verdict(_e643.visibility, _e643.is_doubted);
            } else {
                phi_1729_ = evaluate_Verdict(0.5f, true);
            }
            let _e649 = phi_1729_;
            phi_1730_ = _e649;
        }
        let _e651 = phi_1730_;
        visibility.member[_e59.first_primitive] = _e651.visibility;
        phi_1734_ = _e651.is_doubted;
        phi_1735_ = _e59.first_primitive;
    } else {
        phi_1734_ = false;
        phi_1735_ = 0u;
    }
    let _e656 = phi_1734_;
    let _e658 = phi_1735_;
    if (_e46 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e656 {
        let _e662 = atomicAdd((&shared_[0u]), 1u);
        phi_1746_ = _e662;
    } else {
        phi_1746_ = 0u;
    }
    let _e664 = phi_1746_;
    workgroupBarrier();
    if (_e46 == 0u) {
        let _e668 = atomicLoad((&shared_[0u]));
        let _e669 = atomicAdd((&list.member[3u]), _e668);
        atomicStore((&shared_[1u]), _e669);
    }
    workgroupBarrier();
    if _e656 {
        if false {
            phi_1763_ = (_e658 | 2147483648u);
        } else {
            phi_1763_ = _e658;
        }
        let _e673 = phi_1763_;
        let _e675 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e675) + _e664)]), _e673);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_msm_hausdorff_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_3 = local;
    function_();
}
