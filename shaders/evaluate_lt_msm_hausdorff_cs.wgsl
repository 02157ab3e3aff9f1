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

struct type_30 {
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
var<uniform> p: type_30;
@group(0) @binding(2) 
var<storage> map: type_13;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_13;

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
        let _e49 = phi_141_;
        let _e51 = phi_142_;
        phi_143_ = _e49;
        phi_144_ = _e51;
    } else {
        phi_143_ = lt_bvh_traverse_Tree();
        phi_144_ = true;
    }
    let _e53 = phi_143_;
    let _e55 = phi_144_;
    if _e55 {
        phi_149_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_149_ = _e53;
    }
    let _e60 = phi_149_;
    return lt_bvh_traverse_Tree(_e60.root, _e60.first_primitive);
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_4: f32) -> vec4<f32> {
    var phi_172_: f32;
    var phi_173_: f32;
    var phi_174_: f32;

    if ((bitcast<u32>(param_4) & 2147483647u) > 2139095040u) {
        phi_174_ = param_4;
    } else {
        if (param_4 < 0f) {
            phi_173_ = 0f;
        } else {
            if (param_4 > 1f) {
                phi_172_ = 1f;
            } else {
                phi_172_ = param_4;
            }
            let _e43 = phi_172_;
            phi_173_ = _e43;
        }
        let _e45 = phi_173_;
        phi_174_ = _e45;
    }
    let _e47 = phi_174_;
    let _e48 = (_e47 * _e47);
    return vec4<f32>(_e47, _e48, (_e48 * _e47), (_e48 * _e48));
}

fn lt_math_hausdorff_cubic_mass(param_5: vec4<f32>, param_6: f32, param_7: f32, param_8: f32, param_9: f32) -> f32 {
    return ((((param_5.z - (((param_7 + param_8) + param_9) * param_5.y)) + ((((param_7 * param_8) + (param_7 * param_9)) + (param_8 * param_9)) * param_5.x)) - ((param_7 * param_8) * param_9)) / (((param_6 - param_7) * (param_6 - param_8)) * (param_6 - param_9)));
}

fn lt_math_hausdorff_endpoint_upper_bound(param_10: ptr<function, hankel_HankelFactors>, param_11: f32) -> f32 {
    var phi_942_: f32;
    var phi_943_: f32;
    var phi_944_: f32;
    var phi_971_: f32;
    var phi_972_: f32;
    var phi_973_: f32;
    var phi_974_: f32;
    var phi_975_: bool;
    var phi_976_: f32;
    var phi_977_: bool;
    var phi_1005_: f32;
    var phi_1006_: f32;
    var phi_1007_: f32;
    var phi_1008_: f32;
    var phi_1009_: bool;
    var phi_1010_: f32;
    var phi_1011_: bool;
    var phi_1018_: f32;
    var phi_1019_: f32;
    var phi_1020_: f32;
    var phi_1021_: f32;

    let _e39 = (*param_10).moments;
    if (param_11 < 0.0001f) {
        phi_1021_ = 1f;
    } else {
        let _e48 = ((_e39.z - ((1f + param_11) * _e39.y)) + (param_11 * _e39.x));
        let _e57 = (((_e39.w - ((1f + param_11) * _e39.z)) + (param_11 * _e39.y)) / _e48);
        if (abs(_e48) <= 0.00000047683716f) {
            let _e71 = (1f - (((_e39.y - (_e39.x * (param_11 + 1f))) + (param_11 * 1f)) / ((0f - param_11) * (0f - 1f))));
            if ((bitcast<u32>(_e71) & 2147483647u) > 2139095040u) {
                phi_944_ = _e71;
            } else {
                if (_e71 < 0f) {
                    phi_943_ = 0f;
                } else {
                    if (_e71 > 1f) {
                        phi_942_ = 1f;
                    } else {
                        phi_942_ = _e71;
                    }
                    let _e78 = phi_942_;
                    phi_943_ = _e78;
                }
                let _e80 = phi_943_;
                phi_944_ = _e80;
            }
            let _e82 = phi_944_;
            phi_1020_ = _e82;
        } else {
            if (_e57 > 0f) {
                if (_e57 < param_11) {
                    let _e85 = lt_math_hausdorff_cubic_mass(_e39, 0f, _e57, param_11, 1f);
                    let _e87 = lt_math_hausdorff_cubic_mass(_e39, _e57, 0f, param_11, 1f);
                    let _e88 = ((1f - _e85) - _e87);
                    if ((bitcast<u32>(_e88) & 2147483647u) > 2139095040u) {
                        phi_973_ = _e88;
                    } else {
                        if (_e88 < 0f) {
                            phi_972_ = 0f;
                        } else {
                            if (_e88 > 1f) {
                                phi_971_ = 1f;
                            } else {
                                phi_971_ = _e88;
                            }
                            let _e95 = phi_971_;
                            phi_972_ = _e95;
                        }
                        let _e97 = phi_972_;
                        phi_973_ = _e97;
                    }
                    let _e99 = phi_973_;
                    phi_974_ = _e99;
                    phi_975_ = false;
                } else {
                    phi_974_ = f32();
                    phi_975_ = true;
                }
                let _e101 = phi_974_;
                let _e103 = phi_975_;
                phi_976_ = _e101;
                phi_977_ = _e103;
            } else {
                phi_976_ = f32();
                phi_977_ = true;
            }
            let _e105 = phi_976_;
            let _e107 = phi_977_;
            if _e107 {
                if (_e57 > param_11) {
                    if (_e57 < 1f) {
                        let _e110 = lt_math_hausdorff_cubic_mass(_e39, 0f, _e57, param_11, 1f);
                        let _e111 = (1f - _e110);
                        if ((bitcast<u32>(_e111) & 2147483647u) > 2139095040u) {
                            phi_1007_ = _e111;
                        } else {
                            if (_e111 < 0f) {
                                phi_1006_ = 0f;
                            } else {
                                if (_e111 > 1f) {
                                    phi_1005_ = 1f;
                                } else {
                                    phi_1005_ = _e111;
                                }
                                let _e118 = phi_1005_;
                                phi_1006_ = _e118;
                            }
                            let _e120 = phi_1006_;
                            phi_1007_ = _e120;
                        }
                        let _e122 = phi_1007_;
                        phi_1008_ = _e122;
                        phi_1009_ = false;
                    } else {
                        phi_1008_ = f32();
                        phi_1009_ = true;
                    }
                    let _e124 = phi_1008_;
                    let _e126 = phi_1009_;
                    phi_1010_ = _e124;
                    phi_1011_ = _e126;
                } else {
                    phi_1010_ = f32();
                    phi_1011_ = true;
                }
                let _e128 = phi_1010_;
                let _e130 = phi_1011_;
                if _e130 {
                    phi_1018_ = bitcast<f32>((bitcast<u32>(_e57) | 2143289344u));
                } else {
                    phi_1018_ = _e128;
                }
                let _e135 = phi_1018_;
                phi_1019_ = _e135;
            } else {
                phi_1019_ = _e105;
            }
            let _e137 = phi_1019_;
            phi_1020_ = _e137;
        }
        let _e139 = phi_1020_;
        phi_1021_ = _e139;
    }
    let _e141 = phi_1021_;
    return _e141;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_12: ptr<function, f32>, param_13: vec4<f32>, param_14: f32) -> f32 {
    var local: hankel_HankelFactors;
    var phi_229_: f32;
    var phi_230_: f32;
    var phi_231_: f32;
    var phi_243_: bool;
    var phi_258_: bool;
    var phi_283_: f32;
    var phi_284_: f32;
    var phi_285_: f32;
    var phi_286_: f32;
    var phi_287_: bool;
    var phi_288_: f32;
    var phi_289_: bool;
    var phi_345_: vec2<f32>;
    var phi_383_: f32;
    var phi_384_: f32;
    var phi_385_: f32;
    var phi_418_: f32;
    var phi_419_: f32;
    var phi_420_: f32;
    var phi_424_: f32;
    var phi_425_: f32;
    var phi_426_: f32;
    var phi_427_: f32;
    var phi_480_: vec2<f32>;
    var phi_502_: bool;
    var phi_527_: f32;
    var phi_528_: f32;
    var phi_529_: f32;
    var phi_530_: f32;
    var phi_531_: bool;
    var phi_532_: f32;
    var phi_533_: bool;
    var phi_589_: vec2<f32>;
    var phi_627_: f32;
    var phi_628_: f32;
    var phi_629_: f32;
    var phi_662_: f32;
    var phi_663_: f32;
    var phi_664_: f32;
    var phi_668_: f32;
    var phi_669_: f32;
    var phi_670_: f32;
    var phi_671_: f32;
    var phi_672_: f32;
    var phi_673_: bool;
    var phi_674_: f32;
    var phi_675_: bool;
    var phi_697_: bool;
    var phi_722_: f32;
    var phi_723_: f32;
    var phi_724_: f32;
    var phi_725_: f32;
    var phi_726_: bool;
    var phi_727_: f32;
    var phi_728_: bool;
    var phi_784_: vec2<f32>;
    var phi_822_: f32;
    var phi_823_: f32;
    var phi_824_: f32;
    var phi_857_: f32;
    var phi_858_: f32;
    var phi_859_: f32;
    var phi_863_: f32;
    var phi_864_: f32;
    var phi_865_: f32;
    var phi_866_: f32;
    var phi_877_: bool;
    var phi_881_: f32;
    var phi_882_: f32;
    var phi_883_: f32;
    var phi_884_: f32;

    let _e40 = (*param_12);
    let _e41 = (1f - _e40);
    let _e50 = (0.5f * _e40);
    let _e51 = ((param_13.x * _e41) + _e50);
    let _e52 = ((param_13.y * _e41) + _e50);
    let _e53 = ((param_13.z * _e41) + _e50);
    let _e54 = ((param_13.w * _e41) + _e50);
    let _e57 = (_e52 - (_e51 * _e51));
    let _e59 = (_e53 - (_e51 * _e52));
    let _e65 = hankel_HankelFactors(vec4<f32>(_e51, _e52, _e53, _e54), _e57, _e59, (((_e54 - (_e52 * _e52)) * _e57) - (_e59 * _e59)));
    local = hankel_HankelFactors(_e65.moments, _e65.d22_, _e65.l32_d22_, _e65.d33_d22_);
    if ((bitcast<u32>(param_14) & 2147483647u) > 2139095040u) {
        phi_231_ = param_14;
    } else {
        if (param_14 < 0f) {
            phi_230_ = 0f;
        } else {
            if (param_14 > 1f) {
                phi_229_ = 1f;
            } else {
                phi_229_ = param_14;
            }
            let _e77 = phi_229_;
            phi_230_ = _e77;
        }
        let _e79 = phi_230_;
        phi_231_ = _e79;
    }
    let _e81 = phi_231_;
    let _e84 = local.moments[0u];
    let _e87 = local.moments[3u];
    if (_e84 == _e87) {
        let _e91 = local.moments[0u];
        phi_243_ = (_e91 > 0.5f);
    } else {
        phi_243_ = false;
    }
    let _e94 = phi_243_;
    if _e94 {
        let _e97 = local.moments[0u];
        let _e100 = local.moments[3u];
        if (_e97 == _e100) {
            let _e104 = local.moments[0u];
            phi_258_ = (_e104 > 0.5f);
        } else {
            phi_258_ = false;
        }
        let _e107 = phi_258_;
        if _e107 {
            if (_e81 > 0f) {
                let _e110 = local.moments;
                if ((bitcast<u32>(_e110.x) & 2147483647u) > 2139095040u) {
                    phi_285_ = _e110.x;
                } else {
                    if (_e110.x < 0f) {
                        phi_284_ = 0f;
                    } else {
                        if (_e110.x > 1f) {
                            phi_283_ = 1f;
                        } else {
                            phi_283_ = _e110.x;
                        }
                        let _e118 = phi_283_;
                        phi_284_ = _e118;
                    }
                    let _e120 = phi_284_;
                    phi_285_ = _e120;
                }
                let _e122 = phi_285_;
                phi_286_ = _e122;
                phi_287_ = false;
            } else {
                phi_286_ = f32();
                phi_287_ = true;
            }
            let _e124 = phi_286_;
            let _e126 = phi_287_;
            phi_288_ = _e124;
            phi_289_ = _e126;
        } else {
            phi_288_ = f32();
            phi_289_ = true;
        }
        let _e128 = phi_288_;
        let _e130 = phi_289_;
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
                phi_345_ = vec2<f32>((-(_e169) - _e174), (-(_e169) + _e174));
            } else {
                phi_345_ = vec2(bitcast<f32>((bitcast<u32>(_e172) | 2143289344u)));
            }
            let _e185 = phi_345_;
            if (_e81 <= _e185.x) {
                phi_426_ = 1f;
            } else {
                if (_e81 > _e185.y) {
                    let _e191 = local.moments;
                    let _e202 = (((_e191.y - (_e191.x * (_e185.x + _e185.y))) + (_e185.x * _e185.y)) / ((_e81 - _e185.x) * (_e81 - _e185.y)));
                    if ((bitcast<u32>(_e202) & 2147483647u) > 2139095040u) {
                        phi_385_ = _e202;
                    } else {
                        if (_e202 < 0f) {
                            phi_384_ = 0f;
                        } else {
                            if (_e202 > 1f) {
                                phi_383_ = 1f;
                            } else {
                                phi_383_ = _e202;
                            }
                            let _e209 = phi_383_;
                            phi_384_ = _e209;
                        }
                        let _e211 = phi_384_;
                        phi_385_ = _e211;
                    }
                    let _e213 = phi_385_;
                    phi_425_ = _e213;
                } else {
                    if (_e81 > _e185.x) {
                        let _e216 = local.moments;
                        let _e228 = (1f - (((_e216.y - (_e216.x * (_e81 + _e185.y))) + (_e81 * _e185.y)) / ((_e185.x - _e81) * (_e185.x - _e185.y))));
                        if ((bitcast<u32>(_e228) & 2147483647u) > 2139095040u) {
                            phi_420_ = _e228;
                        } else {
                            if (_e228 < 0f) {
                                phi_419_ = 0f;
                            } else {
                                if (_e228 > 1f) {
                                    phi_418_ = 1f;
                                } else {
                                    phi_418_ = _e228;
                                }
                                let _e235 = phi_418_;
                                phi_419_ = _e235;
                            }
                            let _e237 = phi_419_;
                            phi_420_ = _e237;
                        }
                        let _e239 = phi_420_;
                        phi_424_ = _e239;
                    } else {
                        phi_424_ = bitcast<f32>((bitcast<u32>(_e185.x) | 2143289344u));
                    }
                    let _e244 = phi_424_;
                    phi_425_ = _e244;
                }
                let _e246 = phi_425_;
                phi_426_ = _e246;
            }
            let _e248 = phi_426_;
            phi_427_ = _e248;
        } else {
            phi_427_ = _e128;
        }
        let _e250 = phi_427_;
        phi_884_ = _e250;
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
            phi_480_ = vec2<f32>((-(_e289) - _e294), (-(_e289) + _e294));
        } else {
            phi_480_ = vec2(bitcast<f32>((bitcast<u32>(_e292) | 2143289344u)));
        }
        let _e305 = phi_480_;
        if (_e305.x >= 0f) {
            if (_e305.y <= 1f) {
                let _e312 = local.moments[0u];
                let _e315 = local.moments[3u];
                if (_e312 == _e315) {
                    let _e319 = local.moments[0u];
                    phi_502_ = (_e319 > 0.5f);
                } else {
                    phi_502_ = false;
                }
                let _e322 = phi_502_;
                if _e322 {
                    if (_e81 > 0f) {
                        let _e325 = local.moments;
                        if ((bitcast<u32>(_e325.x) & 2147483647u) > 2139095040u) {
                            phi_529_ = _e325.x;
                        } else {
                            if (_e325.x < 0f) {
                                phi_528_ = 0f;
                            } else {
                                if (_e325.x > 1f) {
                                    phi_527_ = 1f;
                                } else {
                                    phi_527_ = _e325.x;
                                }
                                let _e333 = phi_527_;
                                phi_528_ = _e333;
                            }
                            let _e335 = phi_528_;
                            phi_529_ = _e335;
                        }
                        let _e337 = phi_529_;
                        phi_530_ = _e337;
                        phi_531_ = false;
                    } else {
                        phi_530_ = f32();
                        phi_531_ = true;
                    }
                    let _e339 = phi_530_;
                    let _e341 = phi_531_;
                    phi_532_ = _e339;
                    phi_533_ = _e341;
                } else {
                    phi_532_ = f32();
                    phi_533_ = true;
                }
                let _e343 = phi_532_;
                let _e345 = phi_533_;
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
                        phi_589_ = vec2<f32>((-(_e384) - _e389), (-(_e384) + _e389));
                    } else {
                        phi_589_ = vec2(bitcast<f32>((bitcast<u32>(_e387) | 2143289344u)));
                    }
                    let _e400 = phi_589_;
                    if (_e81 <= _e400.x) {
                        phi_670_ = 1f;
                    } else {
                        if (_e81 > _e400.y) {
                            let _e406 = local.moments;
                            let _e417 = (((_e406.y - (_e406.x * (_e400.x + _e400.y))) + (_e400.x * _e400.y)) / ((_e81 - _e400.x) * (_e81 - _e400.y)));
                            if ((bitcast<u32>(_e417) & 2147483647u) > 2139095040u) {
                                phi_629_ = _e417;
                            } else {
                                if (_e417 < 0f) {
                                    phi_628_ = 0f;
                                } else {
                                    if (_e417 > 1f) {
                                        phi_627_ = 1f;
                                    } else {
                                        phi_627_ = _e417;
                                    }
                                    let _e424 = phi_627_;
                                    phi_628_ = _e424;
                                }
                                let _e426 = phi_628_;
                                phi_629_ = _e426;
                            }
                            let _e428 = phi_629_;
                            phi_669_ = _e428;
                        } else {
                            if (_e81 > _e400.x) {
                                let _e431 = local.moments;
                                let _e443 = (1f - (((_e431.y - (_e431.x * (_e81 + _e400.y))) + (_e81 * _e400.y)) / ((_e400.x - _e81) * (_e400.x - _e400.y))));
                                if ((bitcast<u32>(_e443) & 2147483647u) > 2139095040u) {
                                    phi_664_ = _e443;
                                } else {
                                    if (_e443 < 0f) {
                                        phi_663_ = 0f;
                                    } else {
                                        if (_e443 > 1f) {
                                            phi_662_ = 1f;
                                        } else {
                                            phi_662_ = _e443;
                                        }
                                        let _e450 = phi_662_;
                                        phi_663_ = _e450;
                                    }
                                    let _e452 = phi_663_;
                                    phi_664_ = _e452;
                                }
                                let _e454 = phi_664_;
                                phi_668_ = _e454;
                            } else {
                                phi_668_ = bitcast<f32>((bitcast<u32>(_e400.x) | 2143289344u));
                            }
                            let _e459 = phi_668_;
                            phi_669_ = _e459;
                        }
                        let _e461 = phi_669_;
                        phi_670_ = _e461;
                    }
                    let _e463 = phi_670_;
                    phi_671_ = _e463;
                } else {
                    phi_671_ = _e343;
                }
                let _e465 = phi_671_;
                phi_672_ = _e465;
                phi_673_ = false;
            } else {
                phi_672_ = f32();
                phi_673_ = true;
            }
            let _e467 = phi_672_;
            let _e469 = phi_673_;
            phi_674_ = _e467;
            phi_675_ = _e469;
        } else {
            phi_674_ = f32();
            phi_675_ = true;
        }
        let _e471 = phi_674_;
        let _e473 = phi_675_;
        if _e473 {
            if ((bitcast<u32>(_e305.x) & 2147483647u) > 2139095040u) {
                phi_882_ = _e305.x;
            } else {
                let _e477 = lt_math_hausdorff_endpoint_upper_bound((&local), _e81);
                let _e480 = local.moments[0u];
                let _e483 = local.moments[3u];
                if (_e480 == _e483) {
                    let _e487 = local.moments[0u];
                    phi_697_ = (_e487 > 0.5f);
                } else {
                    phi_697_ = false;
                }
                let _e490 = phi_697_;
                if _e490 {
                    if (_e81 > 0f) {
                        let _e493 = local.moments;
                        if ((bitcast<u32>(_e493.x) & 2147483647u) > 2139095040u) {
                            phi_724_ = _e493.x;
                        } else {
                            if (_e493.x < 0f) {
                                phi_723_ = 0f;
                            } else {
                                if (_e493.x > 1f) {
                                    phi_722_ = 1f;
                                } else {
                                    phi_722_ = _e493.x;
                                }
                                let _e501 = phi_722_;
                                phi_723_ = _e501;
                            }
                            let _e503 = phi_723_;
                            phi_724_ = _e503;
                        }
                        let _e505 = phi_724_;
                        phi_725_ = _e505;
                        phi_726_ = false;
                    } else {
                        phi_725_ = f32();
                        phi_726_ = true;
                    }
                    let _e507 = phi_725_;
                    let _e509 = phi_726_;
                    phi_727_ = _e507;
                    phi_728_ = _e509;
                } else {
                    phi_727_ = f32();
                    phi_728_ = true;
                }
                let _e511 = phi_727_;
                let _e513 = phi_728_;
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
                        phi_784_ = vec2<f32>((-(_e552) - _e557), (-(_e552) + _e557));
                    } else {
                        phi_784_ = vec2(bitcast<f32>((bitcast<u32>(_e555) | 2143289344u)));
                    }
                    let _e568 = phi_784_;
                    if (_e81 <= _e568.x) {
                        phi_865_ = 1f;
                    } else {
                        if (_e81 > _e568.y) {
                            let _e574 = local.moments;
                            let _e585 = (((_e574.y - (_e574.x * (_e568.x + _e568.y))) + (_e568.x * _e568.y)) / ((_e81 - _e568.x) * (_e81 - _e568.y)));
                            if ((bitcast<u32>(_e585) & 2147483647u) > 2139095040u) {
                                phi_824_ = _e585;
                            } else {
                                if (_e585 < 0f) {
                                    phi_823_ = 0f;
                                } else {
                                    if (_e585 > 1f) {
                                        phi_822_ = 1f;
                                    } else {
                                        phi_822_ = _e585;
                                    }
                                    let _e592 = phi_822_;
                                    phi_823_ = _e592;
                                }
                                let _e594 = phi_823_;
                                phi_824_ = _e594;
                            }
                            let _e596 = phi_824_;
                            phi_864_ = _e596;
                        } else {
                            if (_e81 > _e568.x) {
                                let _e599 = local.moments;
                                let _e611 = (1f - (((_e599.y - (_e599.x * (_e81 + _e568.y))) + (_e81 * _e568.y)) / ((_e568.x - _e81) * (_e568.x - _e568.y))));
                                if ((bitcast<u32>(_e611) & 2147483647u) > 2139095040u) {
                                    phi_859_ = _e611;
                                } else {
                                    if (_e611 < 0f) {
                                        phi_858_ = 0f;
                                    } else {
                                        if (_e611 > 1f) {
                                            phi_857_ = 1f;
                                        } else {
                                            phi_857_ = _e611;
                                        }
                                        let _e618 = phi_857_;
                                        phi_858_ = _e618;
                                    }
                                    let _e620 = phi_858_;
                                    phi_859_ = _e620;
                                }
                                let _e622 = phi_859_;
                                phi_863_ = _e622;
                            } else {
                                phi_863_ = bitcast<f32>((bitcast<u32>(_e568.x) | 2143289344u));
                            }
                            let _e627 = phi_863_;
                            phi_864_ = _e627;
                        }
                        let _e629 = phi_864_;
                        phi_865_ = _e629;
                    }
                    let _e631 = phi_865_;
                    phi_866_ = _e631;
                } else {
                    phi_866_ = _e511;
                }
                let _e633 = phi_866_;
                if ((bitcast<u32>(_e633) & 2147483647u) > 2139095040u) {
                    phi_877_ = true;
                } else {
                    let _e637 = (_e633 < _e477);
                    if _e637 {
                    }
                    phi_877_ = _e637;
                }
                let _e639 = phi_877_;
                if _e639 {
                    phi_881_ = _e633;
                } else {
                    phi_881_ = _e477;
                }
                let _e641 = phi_881_;
                phi_882_ = _e641;
            }
            let _e643 = phi_882_;
            phi_883_ = _e643;
        } else {
            phi_883_ = _e471;
        }
        let _e645 = phi_883_;
        phi_884_ = _e645;
    }
    let _e647 = phi_884_;
    return _e647;
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
    var phi_1236_: bool;
    var phi_1245_: bool;
    var phi_1254_: bool;
    var phi_1255_: bool;
    var phi_1256_: bool;
    var phi_1257_: bool;
    var phi_1258_: bool;
    var phi_1259_: bool;
    var phi_1260_: bool;
    var phi_1264_: bool;
    var phi_1358_: f32;
    var phi_1361_: f32;
    var phi_1390_: f32;
    var phi_1395_: f32;
    var phi_1396_: bool;
    var phi_1397_: f32;
    var phi_1398_: bool;
    var phi_1402_: f32;
    var phi_1422_: f32;
    var phi_1427_: f32;
    var phi_1428_: bool;
    var phi_1429_: f32;
    var phi_1430_: bool;
    var phi_1434_: f32;
    var phi_1480_: i32;
    var phi_1485_: i32;
    var phi_1490_: i32;
    var phi_1495_: i32;
    var phi_1504_: i32;
    var phi_1509_: i32;
    var phi_1514_: i32;
    var phi_1519_: i32;
    var phi_1614_: bool;
    var phi_1622_: bool;
    var phi_1634_: bool;
    var phi_1635_: bool;
    var phi_1639_: f32;
    var phi_1645_: f32;
    var phi_1647_: evaluate_Verdict;
    var phi_1652_: evaluate_Verdict;
    var phi_1653_: evaluate_Verdict;

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
                phi_1104_ = (_e75 == _e77);
                phi_1105_ = false;
            } else {
                phi_1104_ = bool();
                phi_1105_ = true;
            }
            let _e80 = phi_1104_;
            let _e82 = phi_1105_;
            phi_1106_ = _e80;
            phi_1107_ = _e82;
        } else {
            phi_1106_ = bool();
            phi_1107_ = true;
        }
        let _e84 = phi_1106_;
        let _e86 = phi_1107_;
        if _e86 {
            phi_1111_ = false;
        } else {
            phi_1111_ = _e84;
        }
        let _e88 = phi_1111_;
        if !(_e88) {
            let _e91 = samples.member[(0u + _e53.first_primitive)].normal;
            let _e93 = samples.member[(0u + _e53.first_primitive)].position;
            if ((((_e91.x * (_e62.x - (_e93.x * _e62.w))) + (_e91.y * (_e62.y - (_e93.y * _e62.w)))) + (_e91.z * (_e62.z - (_e93.z * _e62.w)))) > 0f) {
                let _e117 = samples.member[(0u + _e53.first_primitive)].flags;
                let _e125 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e131 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e125.unnamed.visibility, false), _e125.unnamed_1);
                phi_1155_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e131.unnamed, ((_e117 & 1u) == 0u));
            } else {
                let _e140 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e146 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e140.unnamed.visibility, false), _e140.unnamed_1);
                phi_1155_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e146.unnamed, true);
            }
            let _e151 = phi_1155_;
            phi_1159_ = _e151;
        } else {
            let _e157 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e163 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e157.unnamed.visibility, false), _e157.unnamed_1);
            phi_1159_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e163.unnamed, true);
        }
        let _e168 = phi_1159_;
        if _e168.unnamed_1 {
            phi_1653_ = evaluate_Verdict(_e168.unnamed.visibility, _e168.unnamed.is_doubted);
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
                    phi_1236_ = (_e207 <= 1f);
                } else {
                    phi_1236_ = false;
                }
                let _e239 = phi_1236_;
                if _e239 {
                    if (_e221 >= 0f) {
                        phi_1245_ = (_e221 <= 1f);
                    } else {
                        phi_1245_ = false;
                    }
                    let _e243 = phi_1245_;
                    if _e243 {
                        if (_e234 >= 0f) {
                            phi_1254_ = (_e234 <= 1f);
                        } else {
                            phi_1254_ = false;
                        }
                        let _e247 = phi_1254_;
                        phi_1255_ = _e247;
                        phi_1256_ = false;
                    } else {
                        phi_1255_ = bool();
                        phi_1256_ = true;
                    }
                    let _e249 = phi_1255_;
                    let _e251 = phi_1256_;
                    phi_1257_ = _e249;
                    phi_1258_ = _e251;
                } else {
                    phi_1257_ = bool();
                    phi_1258_ = true;
                }
                let _e253 = phi_1257_;
                let _e255 = phi_1258_;
                phi_1259_ = _e253;
                phi_1260_ = _e255;
            } else {
                phi_1259_ = bool();
                phi_1260_ = true;
            }
            let _e257 = phi_1259_;
            let _e259 = phi_1260_;
            if _e259 {
                phi_1264_ = false;
            } else {
                phi_1264_ = _e257;
            }
            let _e261 = phi_1264_;
            if _e261 {
                if (0f > 0f) {
                    let _e264 = samples.member[(0u + _e53.first_primitive)].normal;
                    let _e266 = p.member.map_size;
                    let _e269 = p.member.projection.row_x;
                    let _e291 = p.member.projection.row_y;
                    let _e313 = p.member.projection.row_z;
                    let _e340 = ((abs(((((_e269.x * _e264.x) + (_e269.y * _e264.y)) + (_e269.z * _e264.z)) / (((_e269.x * _e269.x) + (_e269.y * _e269.y)) + (_e269.z * _e269.z)))) + abs(((((_e291.x * _e264.x) + (_e291.y * _e264.y)) + (_e291.z * _e264.z)) / (((_e291.x * _e291.x) + (_e291.y * _e291.y)) + (_e291.z * _e291.z))))) / (abs(((((_e313.x * _e264.x) + (_e313.y * _e264.y)) + (_e313.z * _e264.z)) / (((_e313.x * _e313.x) + (_e313.y * _e313.y)) + (_e313.z * _e313.z)))) * f32(_e266)));
                    if (_e340 < 0.002f) {
                        phi_1358_ = _e340;
                    } else {
                        phi_1358_ = 0.002f;
                    }
                    let _e343 = phi_1358_;
                    phi_1361_ = (_e234 - (0f * _e343));
                } else {
                    phi_1361_ = _e234;
                }
                let _e347 = phi_1361_;
                let _e349 = p.member.map_size;
                let _e350 = f32(_e349);
                let _e353 = ((_e207 * _e350) - 0.5f);
                let _e354 = ((_e221 * _e350) - 0.5f);
                if (_e353 > -8388608f) {
                    let _e366 = f32(select(0i, select(select(i32(_e353), i32(-2147483648), (_e353 < bitcast<f32>(3472883712u))), 2147483647i, (_e353 > bitcast<f32>(1325400063u))), (_e353 == _e353)));
                    if (_e366 > _e353) {
                        phi_1390_ = 1f;
                    } else {
                        phi_1390_ = 0f;
                    }
                    let _e369 = phi_1390_;
                    if (_e353 < 8388608f) {
                        phi_1395_ = (_e366 - _e369);
                        phi_1396_ = false;
                    } else {
                        phi_1395_ = f32();
                        phi_1396_ = true;
                    }
                    let _e372 = phi_1395_;
                    let _e374 = phi_1396_;
                    phi_1397_ = _e372;
                    phi_1398_ = _e374;
                } else {
                    phi_1397_ = f32();
                    phi_1398_ = true;
                }
                let _e376 = phi_1397_;
                let _e378 = phi_1398_;
                if _e378 {
                    phi_1402_ = _e353;
                } else {
                    phi_1402_ = _e376;
                }
                let _e380 = phi_1402_;
                if (_e354 > -8388608f) {
                    let _e392 = f32(select(0i, select(select(i32(_e354), i32(-2147483648), (_e354 < bitcast<f32>(3472883712u))), 2147483647i, (_e354 > bitcast<f32>(1325400063u))), (_e354 == _e354)));
                    if (_e392 > _e354) {
                        phi_1422_ = 1f;
                    } else {
                        phi_1422_ = 0f;
                    }
                    let _e395 = phi_1422_;
                    if (_e354 < 8388608f) {
                        phi_1427_ = (_e392 - _e395);
                        phi_1428_ = false;
                    } else {
                        phi_1427_ = f32();
                        phi_1428_ = true;
                    }
                    let _e398 = phi_1427_;
                    let _e400 = phi_1428_;
                    phi_1429_ = _e398;
                    phi_1430_ = _e400;
                } else {
                    phi_1429_ = f32();
                    phi_1430_ = true;
                }
                let _e402 = phi_1429_;
                let _e404 = phi_1430_;
                if _e404 {
                    phi_1434_ = _e354;
                } else {
                    phi_1434_ = _e402;
                }
                let _e406 = phi_1434_;
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
                    phi_1480_ = _e417;
                } else {
                    phi_1480_ = 0i;
                }
                let _e444 = phi_1480_;
                if (_e426 > 0i) {
                    phi_1485_ = _e426;
                } else {
                    phi_1485_ = 0i;
                }
                let _e447 = phi_1485_;
                if (_e444 < _e441) {
                    phi_1490_ = _e444;
                } else {
                    phi_1490_ = _e441;
                }
                let _e450 = phi_1490_;
                if (_e447 < _e441) {
                    phi_1495_ = _e447;
                } else {
                    phi_1495_ = _e441;
                }
                let _e453 = phi_1495_;
                let _e454 = bitcast<u32>(_e450);
                let _e456 = (_e417 + 1i);
                let _e457 = (_e426 + 1i);
                if (_e456 > 0i) {
                    phi_1504_ = _e456;
                } else {
                    phi_1504_ = 0i;
                }
                let _e460 = phi_1504_;
                if (_e457 > 0i) {
                    phi_1509_ = _e457;
                } else {
                    phi_1509_ = 0i;
                }
                let _e463 = phi_1509_;
                if (_e460 < _e441) {
                    phi_1514_ = _e460;
                } else {
                    phi_1514_ = _e441;
                }
                let _e466 = phi_1514_;
                if (_e463 < _e441) {
                    phi_1519_ = _e463;
                } else {
                    phi_1519_ = _e441;
                }
                let _e469 = phi_1519_;
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
                let _e485 = map.member[(0u + _e475)];
                if (_e476 < _e44) {
                } else {
                    return;
                }
                let _e489 = map.member[(0u + _e476)];
                if (_e477 < _e44) {
                } else {
                    return;
                }
                let _e493 = map.member[(0u + _e477)];
                let _e494 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(_e481);
                let _e495 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(_e485);
                let _e496 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(_e489);
                let _e497 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(_e493);
                let _e543 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_1), vec4<f32>(((((_e494.x * _e429) + (_e495.x * _e431)) + (_e496.x * _e433)) + (_e497.x * _e434)), ((((_e494.y * _e429) + (_e495.y * _e431)) + (_e496.y * _e433)) + (_e497.y * _e434)), ((((_e494.z * _e429) + (_e495.z * _e431)) + (_e496.z * _e433)) + (_e497.z * _e434)), ((((_e494.w * _e429) + (_e495.w * _e431)) + (_e496.w * _e433)) + (_e497.w * _e434))), _e347);
                let _e545 = p.member.epsilon;
                if (_e543 <= _e545) {
                    phi_1614_ = true;
                } else {
                    phi_1614_ = (_e543 >= (1f - _e545));
                }
                let _e550 = phi_1614_;
                if ((bitcast<u32>(_e543) & 2147483647u) > 2139095040u) {
                    phi_1622_ = true;
                } else {
                    phi_1622_ = !(_e550);
                }
                let _e556 = phi_1622_;
                if _e556 {
                    if (_e543 > 0f) {
                        if (_e543 < 1f) {
                            phi_1634_ = false;
                        } else {
                            phi_1634_ = true;
                        }
                        let _e560 = phi_1634_;
                        phi_1635_ = _e560;
                    } else {
                        phi_1635_ = true;
                    }
                    let _e562 = phi_1635_;
                    if _e562 {
                        phi_1639_ = 0.5f;
                    } else {
                        phi_1639_ = _e543;
                    }
                    let _e564 = phi_1639_;
                    phi_1647_ = evaluate_Verdict(_e564, true);
                } else {
                    if (_e543 > 0.5f) {
                        phi_1645_ = 1f;
                    } else {
                        phi_1645_ = 0f;
                    }
                    let _e568 = phi_1645_;
                    phi_1647_ = evaluate_Verdict(_e568, false);
                }
                let _e571 = phi_1647_;
                phi_1652_ = evaluate_Verdict(_e571.visibility, _e571.is_doubted);
            } else {
                phi_1652_ = evaluate_Verdict(0.5f, true);
            }
            let _e577 = phi_1652_;
            phi_1653_ = _e577;
        }
        let _e579 = phi_1653_;
        if (_e53.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e53.first_primitive)] = _e579.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_msm_hausdorff_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
