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
var<storage> samples: type_15;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_35;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_19;
@group(0) @binding(2) 
var<storage> map: type_31;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_148_: lt_bvh_traverse_Tree;
    var phi_149_: bool;
    var phi_150_: lt_bvh_traverse_Tree;
    var phi_151_: bool;
    var phi_156_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_148_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_149_ = false;
        } else {
            phi_148_ = lt_bvh_traverse_Tree();
            phi_149_ = true;
        }
        let _e49 = phi_148_;
        let _e51 = phi_149_;
        phi_150_ = _e49;
        phi_151_ = _e51;
    } else {
        phi_150_ = lt_bvh_traverse_Tree();
        phi_151_ = true;
    }
    let _e53 = phi_150_;
    let _e55 = phi_151_;
    if _e55 {
        phi_156_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_156_ = _e53;
    }
    let _e60 = phi_156_;
    return lt_bvh_traverse_Tree(_e60.root, _e60.first_primitive);
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn lt_math_hausdorff_cubic_mass(param_4: vec4<f32>, param_5: f32, param_6: f32, param_7: f32, param_8: f32) -> f32 {
    return ((((param_4.z - (((param_6 + param_7) + param_8) * param_4.y)) + ((((param_6 * param_7) + (param_6 * param_8)) + (param_7 * param_8)) * param_4.x)) - ((param_6 * param_7) * param_8)) / (((param_5 - param_6) * (param_5 - param_7)) * (param_5 - param_8)));
}

fn lt_math_hausdorff_endpoint_upper_bound(param_9: ptr<function, hankel_HankelFactors>, param_10: f32) -> f32 {
    var phi_926_: f32;
    var phi_927_: f32;
    var phi_928_: f32;
    var phi_955_: f32;
    var phi_956_: f32;
    var phi_957_: f32;
    var phi_958_: f32;
    var phi_959_: bool;
    var phi_960_: f32;
    var phi_961_: bool;
    var phi_989_: f32;
    var phi_990_: f32;
    var phi_991_: f32;
    var phi_992_: f32;
    var phi_993_: bool;
    var phi_994_: f32;
    var phi_995_: bool;
    var phi_1002_: f32;
    var phi_1003_: f32;
    var phi_1004_: f32;
    var phi_1005_: f32;

    let _e39 = (*param_9).moments;
    if (param_10 < 0.0001f) {
        phi_1005_ = 1f;
    } else {
        let _e48 = ((_e39.z - ((1f + param_10) * _e39.y)) + (param_10 * _e39.x));
        let _e57 = (((_e39.w - ((1f + param_10) * _e39.z)) + (param_10 * _e39.y)) / _e48);
        if (abs(_e48) <= 0.00000047683716f) {
            let _e71 = (1f - (((_e39.y - (_e39.x * (param_10 + 1f))) + (param_10 * 1f)) / ((0f - param_10) * (0f - 1f))));
            if ((bitcast<u32>(_e71) & 2147483647u) > 2139095040u) {
                phi_928_ = _e71;
            } else {
                if (_e71 < 0f) {
                    phi_927_ = 0f;
                } else {
                    if (_e71 > 1f) {
                        phi_926_ = 1f;
                    } else {
                        phi_926_ = _e71;
                    }
                    let _e78 = phi_926_;
                    phi_927_ = _e78;
                }
                let _e80 = phi_927_;
                phi_928_ = _e80;
            }
            let _e82 = phi_928_;
            phi_1004_ = _e82;
        } else {
            if (_e57 > 0f) {
                if (_e57 < param_10) {
                    let _e85 = lt_math_hausdorff_cubic_mass(_e39, 0f, _e57, param_10, 1f);
                    let _e87 = lt_math_hausdorff_cubic_mass(_e39, _e57, 0f, param_10, 1f);
                    let _e88 = ((1f - _e85) - _e87);
                    if ((bitcast<u32>(_e88) & 2147483647u) > 2139095040u) {
                        phi_957_ = _e88;
                    } else {
                        if (_e88 < 0f) {
                            phi_956_ = 0f;
                        } else {
                            if (_e88 > 1f) {
                                phi_955_ = 1f;
                            } else {
                                phi_955_ = _e88;
                            }
                            let _e95 = phi_955_;
                            phi_956_ = _e95;
                        }
                        let _e97 = phi_956_;
                        phi_957_ = _e97;
                    }
                    let _e99 = phi_957_;
                    phi_958_ = _e99;
                    phi_959_ = false;
                } else {
                    phi_958_ = f32();
                    phi_959_ = true;
                }
                let _e101 = phi_958_;
                let _e103 = phi_959_;
                phi_960_ = _e101;
                phi_961_ = _e103;
            } else {
                phi_960_ = f32();
                phi_961_ = true;
            }
            let _e105 = phi_960_;
            let _e107 = phi_961_;
            if _e107 {
                if (_e57 > param_10) {
                    if (_e57 < 1f) {
                        let _e110 = lt_math_hausdorff_cubic_mass(_e39, 0f, _e57, param_10, 1f);
                        let _e111 = (1f - _e110);
                        if ((bitcast<u32>(_e111) & 2147483647u) > 2139095040u) {
                            phi_991_ = _e111;
                        } else {
                            if (_e111 < 0f) {
                                phi_990_ = 0f;
                            } else {
                                if (_e111 > 1f) {
                                    phi_989_ = 1f;
                                } else {
                                    phi_989_ = _e111;
                                }
                                let _e118 = phi_989_;
                                phi_990_ = _e118;
                            }
                            let _e120 = phi_990_;
                            phi_991_ = _e120;
                        }
                        let _e122 = phi_991_;
                        phi_992_ = _e122;
                        phi_993_ = false;
                    } else {
                        phi_992_ = f32();
                        phi_993_ = true;
                    }
                    let _e124 = phi_992_;
                    let _e126 = phi_993_;
                    phi_994_ = _e124;
                    phi_995_ = _e126;
                } else {
                    phi_994_ = f32();
                    phi_995_ = true;
                }
                let _e128 = phi_994_;
                let _e130 = phi_995_;
                if _e130 {
                    phi_1002_ = bitcast<f32>((bitcast<u32>(_e57) | 2143289344u));
                } else {
                    phi_1002_ = _e128;
                }
                let _e135 = phi_1002_;
                phi_1003_ = _e135;
            } else {
                phi_1003_ = _e105;
            }
            let _e137 = phi_1003_;
            phi_1004_ = _e137;
        }
        let _e139 = phi_1004_;
        phi_1005_ = _e139;
    }
    let _e141 = phi_1005_;
    return _e141;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_11: ptr<function, f32>, param_12: vec4<f32>, param_13: f32) -> f32 {
    var local: hankel_HankelFactors;
    var phi_213_: f32;
    var phi_214_: f32;
    var phi_215_: f32;
    var phi_227_: bool;
    var phi_242_: bool;
    var phi_267_: f32;
    var phi_268_: f32;
    var phi_269_: f32;
    var phi_270_: f32;
    var phi_271_: bool;
    var phi_272_: f32;
    var phi_273_: bool;
    var phi_329_: vec2<f32>;
    var phi_367_: f32;
    var phi_368_: f32;
    var phi_369_: f32;
    var phi_402_: f32;
    var phi_403_: f32;
    var phi_404_: f32;
    var phi_408_: f32;
    var phi_409_: f32;
    var phi_410_: f32;
    var phi_411_: f32;
    var phi_464_: vec2<f32>;
    var phi_486_: bool;
    var phi_511_: f32;
    var phi_512_: f32;
    var phi_513_: f32;
    var phi_514_: f32;
    var phi_515_: bool;
    var phi_516_: f32;
    var phi_517_: bool;
    var phi_573_: vec2<f32>;
    var phi_611_: f32;
    var phi_612_: f32;
    var phi_613_: f32;
    var phi_646_: f32;
    var phi_647_: f32;
    var phi_648_: f32;
    var phi_652_: f32;
    var phi_653_: f32;
    var phi_654_: f32;
    var phi_655_: f32;
    var phi_656_: f32;
    var phi_657_: bool;
    var phi_658_: f32;
    var phi_659_: bool;
    var phi_681_: bool;
    var phi_706_: f32;
    var phi_707_: f32;
    var phi_708_: f32;
    var phi_709_: f32;
    var phi_710_: bool;
    var phi_711_: f32;
    var phi_712_: bool;
    var phi_768_: vec2<f32>;
    var phi_806_: f32;
    var phi_807_: f32;
    var phi_808_: f32;
    var phi_841_: f32;
    var phi_842_: f32;
    var phi_843_: f32;
    var phi_847_: f32;
    var phi_848_: f32;
    var phi_849_: f32;
    var phi_850_: f32;
    var phi_861_: bool;
    var phi_865_: f32;
    var phi_866_: f32;
    var phi_867_: f32;
    var phi_868_: f32;

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
        phi_215_ = param_13;
    } else {
        if (param_13 < 0f) {
            phi_214_ = 0f;
        } else {
            if (param_13 > 1f) {
                phi_213_ = 1f;
            } else {
                phi_213_ = param_13;
            }
            let _e77 = phi_213_;
            phi_214_ = _e77;
        }
        let _e79 = phi_214_;
        phi_215_ = _e79;
    }
    let _e81 = phi_215_;
    let _e84 = local.moments[0u];
    let _e87 = local.moments[3u];
    if (_e84 == _e87) {
        let _e91 = local.moments[0u];
        phi_227_ = (_e91 > 0.5f);
    } else {
        phi_227_ = false;
    }
    let _e94 = phi_227_;
    if _e94 {
        let _e97 = local.moments[0u];
        let _e100 = local.moments[3u];
        if (_e97 == _e100) {
            let _e104 = local.moments[0u];
            phi_242_ = (_e104 > 0.5f);
        } else {
            phi_242_ = false;
        }
        let _e107 = phi_242_;
        if _e107 {
            if (_e81 > 0f) {
                let _e110 = local.moments;
                if ((bitcast<u32>(_e110.x) & 2147483647u) > 2139095040u) {
                    phi_269_ = _e110.x;
                } else {
                    if (_e110.x < 0f) {
                        phi_268_ = 0f;
                    } else {
                        if (_e110.x > 1f) {
                            phi_267_ = 1f;
                        } else {
                            phi_267_ = _e110.x;
                        }
                        let _e118 = phi_267_;
                        phi_268_ = _e118;
                    }
                    let _e120 = phi_268_;
                    phi_269_ = _e120;
                }
                let _e122 = phi_269_;
                phi_270_ = _e122;
                phi_271_ = false;
            } else {
                phi_270_ = f32();
                phi_271_ = true;
            }
            let _e124 = phi_270_;
            let _e126 = phi_271_;
            phi_272_ = _e124;
            phi_273_ = _e126;
        } else {
            phi_272_ = f32();
            phi_273_ = true;
        }
        let _e128 = phi_272_;
        let _e130 = phi_273_;
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
                phi_329_ = vec2<f32>((-(_e169) - _e174), (-(_e169) + _e174));
            } else {
                phi_329_ = vec2(bitcast<f32>((bitcast<u32>(_e172) | 2143289344u)));
            }
            let _e185 = phi_329_;
            if (_e81 <= _e185.x) {
                phi_410_ = 1f;
            } else {
                if (_e81 > _e185.y) {
                    let _e191 = local.moments;
                    let _e202 = (((_e191.y - (_e191.x * (_e185.x + _e185.y))) + (_e185.x * _e185.y)) / ((_e81 - _e185.x) * (_e81 - _e185.y)));
                    if ((bitcast<u32>(_e202) & 2147483647u) > 2139095040u) {
                        phi_369_ = _e202;
                    } else {
                        if (_e202 < 0f) {
                            phi_368_ = 0f;
                        } else {
                            if (_e202 > 1f) {
                                phi_367_ = 1f;
                            } else {
                                phi_367_ = _e202;
                            }
                            let _e209 = phi_367_;
                            phi_368_ = _e209;
                        }
                        let _e211 = phi_368_;
                        phi_369_ = _e211;
                    }
                    let _e213 = phi_369_;
                    phi_409_ = _e213;
                } else {
                    if (_e81 > _e185.x) {
                        let _e216 = local.moments;
                        let _e228 = (1f - (((_e216.y - (_e216.x * (_e81 + _e185.y))) + (_e81 * _e185.y)) / ((_e185.x - _e81) * (_e185.x - _e185.y))));
                        if ((bitcast<u32>(_e228) & 2147483647u) > 2139095040u) {
                            phi_404_ = _e228;
                        } else {
                            if (_e228 < 0f) {
                                phi_403_ = 0f;
                            } else {
                                if (_e228 > 1f) {
                                    phi_402_ = 1f;
                                } else {
                                    phi_402_ = _e228;
                                }
                                let _e235 = phi_402_;
                                phi_403_ = _e235;
                            }
                            let _e237 = phi_403_;
                            phi_404_ = _e237;
                        }
                        let _e239 = phi_404_;
                        phi_408_ = _e239;
                    } else {
                        phi_408_ = bitcast<f32>((bitcast<u32>(_e185.x) | 2143289344u));
                    }
                    let _e244 = phi_408_;
                    phi_409_ = _e244;
                }
                let _e246 = phi_409_;
                phi_410_ = _e246;
            }
            let _e248 = phi_410_;
            phi_411_ = _e248;
        } else {
            phi_411_ = _e128;
        }
        let _e250 = phi_411_;
        phi_868_ = _e250;
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
            phi_464_ = vec2<f32>((-(_e289) - _e294), (-(_e289) + _e294));
        } else {
            phi_464_ = vec2(bitcast<f32>((bitcast<u32>(_e292) | 2143289344u)));
        }
        let _e305 = phi_464_;
        if (_e305.x >= 0f) {
            if (_e305.y <= 1f) {
                let _e312 = local.moments[0u];
                let _e315 = local.moments[3u];
                if (_e312 == _e315) {
                    let _e319 = local.moments[0u];
                    phi_486_ = (_e319 > 0.5f);
                } else {
                    phi_486_ = false;
                }
                let _e322 = phi_486_;
                if _e322 {
                    if (_e81 > 0f) {
                        let _e325 = local.moments;
                        if ((bitcast<u32>(_e325.x) & 2147483647u) > 2139095040u) {
                            phi_513_ = _e325.x;
                        } else {
                            if (_e325.x < 0f) {
                                phi_512_ = 0f;
                            } else {
                                if (_e325.x > 1f) {
                                    phi_511_ = 1f;
                                } else {
                                    phi_511_ = _e325.x;
                                }
                                let _e333 = phi_511_;
                                phi_512_ = _e333;
                            }
                            let _e335 = phi_512_;
                            phi_513_ = _e335;
                        }
                        let _e337 = phi_513_;
                        phi_514_ = _e337;
                        phi_515_ = false;
                    } else {
                        phi_514_ = f32();
                        phi_515_ = true;
                    }
                    let _e339 = phi_514_;
                    let _e341 = phi_515_;
                    phi_516_ = _e339;
                    phi_517_ = _e341;
                } else {
                    phi_516_ = f32();
                    phi_517_ = true;
                }
                let _e343 = phi_516_;
                let _e345 = phi_517_;
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
                        phi_573_ = vec2<f32>((-(_e384) - _e389), (-(_e384) + _e389));
                    } else {
                        phi_573_ = vec2(bitcast<f32>((bitcast<u32>(_e387) | 2143289344u)));
                    }
                    let _e400 = phi_573_;
                    if (_e81 <= _e400.x) {
                        phi_654_ = 1f;
                    } else {
                        if (_e81 > _e400.y) {
                            let _e406 = local.moments;
                            let _e417 = (((_e406.y - (_e406.x * (_e400.x + _e400.y))) + (_e400.x * _e400.y)) / ((_e81 - _e400.x) * (_e81 - _e400.y)));
                            if ((bitcast<u32>(_e417) & 2147483647u) > 2139095040u) {
                                phi_613_ = _e417;
                            } else {
                                if (_e417 < 0f) {
                                    phi_612_ = 0f;
                                } else {
                                    if (_e417 > 1f) {
                                        phi_611_ = 1f;
                                    } else {
                                        phi_611_ = _e417;
                                    }
                                    let _e424 = phi_611_;
                                    phi_612_ = _e424;
                                }
                                let _e426 = phi_612_;
                                phi_613_ = _e426;
                            }
                            let _e428 = phi_613_;
                            phi_653_ = _e428;
                        } else {
                            if (_e81 > _e400.x) {
                                let _e431 = local.moments;
                                let _e443 = (1f - (((_e431.y - (_e431.x * (_e81 + _e400.y))) + (_e81 * _e400.y)) / ((_e400.x - _e81) * (_e400.x - _e400.y))));
                                if ((bitcast<u32>(_e443) & 2147483647u) > 2139095040u) {
                                    phi_648_ = _e443;
                                } else {
                                    if (_e443 < 0f) {
                                        phi_647_ = 0f;
                                    } else {
                                        if (_e443 > 1f) {
                                            phi_646_ = 1f;
                                        } else {
                                            phi_646_ = _e443;
                                        }
                                        let _e450 = phi_646_;
                                        phi_647_ = _e450;
                                    }
                                    let _e452 = phi_647_;
                                    phi_648_ = _e452;
                                }
                                let _e454 = phi_648_;
                                phi_652_ = _e454;
                            } else {
                                phi_652_ = bitcast<f32>((bitcast<u32>(_e400.x) | 2143289344u));
                            }
                            let _e459 = phi_652_;
                            phi_653_ = _e459;
                        }
                        let _e461 = phi_653_;
                        phi_654_ = _e461;
                    }
                    let _e463 = phi_654_;
                    phi_655_ = _e463;
                } else {
                    phi_655_ = _e343;
                }
                let _e465 = phi_655_;
                phi_656_ = _e465;
                phi_657_ = false;
            } else {
                phi_656_ = f32();
                phi_657_ = true;
            }
            let _e467 = phi_656_;
            let _e469 = phi_657_;
            phi_658_ = _e467;
            phi_659_ = _e469;
        } else {
            phi_658_ = f32();
            phi_659_ = true;
        }
        let _e471 = phi_658_;
        let _e473 = phi_659_;
        if _e473 {
            if ((bitcast<u32>(_e305.x) & 2147483647u) > 2139095040u) {
                phi_866_ = _e305.x;
            } else {
                let _e477 = lt_math_hausdorff_endpoint_upper_bound((&local), _e81);
                let _e480 = local.moments[0u];
                let _e483 = local.moments[3u];
                if (_e480 == _e483) {
                    let _e487 = local.moments[0u];
                    phi_681_ = (_e487 > 0.5f);
                } else {
                    phi_681_ = false;
                }
                let _e490 = phi_681_;
                if _e490 {
                    if (_e81 > 0f) {
                        let _e493 = local.moments;
                        if ((bitcast<u32>(_e493.x) & 2147483647u) > 2139095040u) {
                            phi_708_ = _e493.x;
                        } else {
                            if (_e493.x < 0f) {
                                phi_707_ = 0f;
                            } else {
                                if (_e493.x > 1f) {
                                    phi_706_ = 1f;
                                } else {
                                    phi_706_ = _e493.x;
                                }
                                let _e501 = phi_706_;
                                phi_707_ = _e501;
                            }
                            let _e503 = phi_707_;
                            phi_708_ = _e503;
                        }
                        let _e505 = phi_708_;
                        phi_709_ = _e505;
                        phi_710_ = false;
                    } else {
                        phi_709_ = f32();
                        phi_710_ = true;
                    }
                    let _e507 = phi_709_;
                    let _e509 = phi_710_;
                    phi_711_ = _e507;
                    phi_712_ = _e509;
                } else {
                    phi_711_ = f32();
                    phi_712_ = true;
                }
                let _e511 = phi_711_;
                let _e513 = phi_712_;
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
                        phi_768_ = vec2<f32>((-(_e552) - _e557), (-(_e552) + _e557));
                    } else {
                        phi_768_ = vec2(bitcast<f32>((bitcast<u32>(_e555) | 2143289344u)));
                    }
                    let _e568 = phi_768_;
                    if (_e81 <= _e568.x) {
                        phi_849_ = 1f;
                    } else {
                        if (_e81 > _e568.y) {
                            let _e574 = local.moments;
                            let _e585 = (((_e574.y - (_e574.x * (_e568.x + _e568.y))) + (_e568.x * _e568.y)) / ((_e81 - _e568.x) * (_e81 - _e568.y)));
                            if ((bitcast<u32>(_e585) & 2147483647u) > 2139095040u) {
                                phi_808_ = _e585;
                            } else {
                                if (_e585 < 0f) {
                                    phi_807_ = 0f;
                                } else {
                                    if (_e585 > 1f) {
                                        phi_806_ = 1f;
                                    } else {
                                        phi_806_ = _e585;
                                    }
                                    let _e592 = phi_806_;
                                    phi_807_ = _e592;
                                }
                                let _e594 = phi_807_;
                                phi_808_ = _e594;
                            }
                            let _e596 = phi_808_;
                            phi_848_ = _e596;
                        } else {
                            if (_e81 > _e568.x) {
                                let _e599 = local.moments;
                                let _e611 = (1f - (((_e599.y - (_e599.x * (_e81 + _e568.y))) + (_e81 * _e568.y)) / ((_e568.x - _e81) * (_e568.x - _e568.y))));
                                if ((bitcast<u32>(_e611) & 2147483647u) > 2139095040u) {
                                    phi_843_ = _e611;
                                } else {
                                    if (_e611 < 0f) {
                                        phi_842_ = 0f;
                                    } else {
                                        if (_e611 > 1f) {
                                            phi_841_ = 1f;
                                        } else {
                                            phi_841_ = _e611;
                                        }
                                        let _e618 = phi_841_;
                                        phi_842_ = _e618;
                                    }
                                    let _e620 = phi_842_;
                                    phi_843_ = _e620;
                                }
                                let _e622 = phi_843_;
                                phi_847_ = _e622;
                            } else {
                                phi_847_ = bitcast<f32>((bitcast<u32>(_e568.x) | 2143289344u));
                            }
                            let _e627 = phi_847_;
                            phi_848_ = _e627;
                        }
                        let _e629 = phi_848_;
                        phi_849_ = _e629;
                    }
                    let _e631 = phi_849_;
                    phi_850_ = _e631;
                } else {
                    phi_850_ = _e511;
                }
                let _e633 = phi_850_;
                if ((bitcast<u32>(_e633) & 2147483647u) > 2139095040u) {
                    phi_861_ = true;
                } else {
                    let _e637 = (_e633 < _e477);
                    if _e637 {
                    }
                    phi_861_ = _e637;
                }
                let _e639 = phi_861_;
                if _e639 {
                    phi_865_ = _e633;
                } else {
                    phi_865_ = _e477;
                }
                let _e641 = phi_865_;
                phi_866_ = _e641;
            }
            let _e643 = phi_866_;
            phi_867_ = _e643;
        } else {
            phi_867_ = _e471;
        }
        let _e645 = phi_867_;
        phi_868_ = _e645;
    }
    let _e647 = phi_868_;
    return _e647;
}

fn function_() {
    var local_1: f32;
    var phi_1090_: bool;
    var phi_1091_: bool;
    var phi_1092_: bool;
    var phi_1093_: bool;
    var phi_1097_: bool;
    var phi_1167_: bool;
    var phi_1168_: bool;
    var phi_1179_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1180_: bool;
    var phi_1181_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1182_: bool;
    var phi_1189_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1193_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1267_: bool;
    var phi_1276_: bool;
    var phi_1285_: bool;
    var phi_1286_: bool;
    var phi_1287_: bool;
    var phi_1288_: bool;
    var phi_1289_: bool;
    var phi_1290_: bool;
    var phi_1291_: bool;
    var phi_1295_: bool;
    var phi_1385_: f32;
    var phi_1388_: f32;
    var phi_1417_: f32;
    var phi_1422_: f32;
    var phi_1423_: bool;
    var phi_1424_: f32;
    var phi_1425_: bool;
    var phi_1429_: f32;
    var phi_1449_: f32;
    var phi_1454_: f32;
    var phi_1455_: bool;
    var phi_1456_: f32;
    var phi_1457_: bool;
    var phi_1461_: f32;
    var phi_1509_: i32;
    var phi_1514_: i32;
    var phi_1519_: i32;
    var phi_1524_: i32;
    var phi_1533_: i32;
    var phi_1538_: i32;
    var phi_1543_: i32;
    var phi_1548_: i32;
    var phi_1643_: bool;
    var phi_1651_: bool;
    var phi_1663_: bool;
    var phi_1664_: bool;
    var phi_1668_: f32;
    var phi_1674_: f32;
    var phi_1676_: evaluate_Verdict;
    var phi_1681_: evaluate_Verdict;
    var phi_1682_: evaluate_Verdict;

    let _e37 = id_1;
    let _e44 = arrayLength((&map.member));
    let _e50 = p.member.size[0u];
    let _e52 = p.member.size[1u];
    let _e53 = lt_shaders_entry_pixel_index(_e37, _e50, _e52);
    if (bitcast<i32>(_e53.root) != 0i) {
        let _e59 = p.member.projection;
        if (_e53.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e63 = lt_math_OneLevel(_e59);
        let _e67 = samples.member[(0u + _e53.first_primitive)].normal[0u];
        let _e69 = global[0u];
        if (_e67 == _e69) {
            let _e72 = samples.member[(0u + _e53.first_primitive)].normal[1u];
            let _e74 = global[1u];
            if (_e72 == _e74) {
                let _e77 = samples.member[(0u + _e53.first_primitive)].normal[2u];
                let _e79 = global[2u];
                phi_1090_ = (_e77 == _e79);
                phi_1091_ = false;
            } else {
                phi_1090_ = bool();
                phi_1091_ = true;
            }
            let _e82 = phi_1090_;
            let _e84 = phi_1091_;
            phi_1092_ = _e82;
            phi_1093_ = _e84;
        } else {
            phi_1092_ = bool();
            phi_1093_ = true;
        }
        let _e86 = phi_1092_;
        let _e88 = phi_1093_;
        if _e88 {
            phi_1097_ = false;
        } else {
            phi_1097_ = _e86;
        }
        let _e90 = phi_1097_;
        if !(_e90) {
            let _e93 = samples.member[(0u + _e53.first_primitive)].position;
            let _e95 = p.member.light.place;
            let _e101 = p.member.light.place[3u];
            let _e108 = (_e95.x - (_e93.x * _e101));
            let _e109 = (_e95.y - (_e93.y * _e101));
            let _e110 = (_e95.z - (_e93.z * _e101));
            let _e112 = samples.member[(0u + _e53.first_primitive)].normal;
            if ((((_e112.x * _e108) + (_e112.y * _e109)) + (_e112.z * _e110)) > 0f) {
                let _e126 = (((_e108 * _e108) + (_e109 * _e109)) + (_e110 * _e110));
                let _e128 = p.member.light.axis;
                let _e140 = p.member.light.place[3u];
                if (_e140 == 0f) {
                    phi_1168_ = true;
                } else {
                    let _e143 = p.member.light.range_squared;
                    if (_e126 <= _e143) {
                        let _e146 = p.member.light.cos_outer;
                        phi_1167_ = (-((((_e108 * _e128.x) + (_e109 * _e128.y)) + (_e110 * _e128.z))) >= (_e146 * sqrt(_e126)));
                    } else {
                        phi_1167_ = false;
                    }
                    let _e151 = phi_1167_;
                    phi_1168_ = _e151;
                }
                let _e153 = phi_1168_;
                if _e153 {
                    let _e155 = samples.member[(0u + _e53.first_primitive)].flags;
                    let _e163 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e169 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e163.unnamed.visibility, false), _e163.unnamed_1);
                    phi_1179_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e169.unnamed, ((_e155 & 1u) == 0u));
                    phi_1180_ = false;
                } else {
                    phi_1179_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_1180_ = true;
                }
                let _e174 = phi_1179_;
                let _e176 = phi_1180_;
                phi_1181_ = _e174;
                phi_1182_ = _e176;
            } else {
                phi_1181_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_1182_ = true;
            }
            let _e178 = phi_1181_;
            let _e180 = phi_1182_;
            if _e180 {
                let _e186 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e192 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e186.unnamed.visibility, false), _e186.unnamed_1);
                phi_1189_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e192.unnamed, true);
            } else {
                phi_1189_ = _e178;
            }
            let _e197 = phi_1189_;
            phi_1193_ = _e197;
        } else {
            let _e203 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e209 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e203.unnamed.visibility, false), _e203.unnamed_1);
            phi_1193_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e209.unnamed, true);
        }
        let _e214 = phi_1193_;
        if _e214.unnamed_1 {
            phi_1682_ = evaluate_Verdict(_e214.unnamed.visibility, _e214.unnamed.is_doubted);
        } else {
            let _e222 = samples.member[(0u + _e53.first_primitive)].position;
            let _e240 = ((((_e63.projection.row_w.x * _e222.x) + (_e63.projection.row_w.y * _e222.y)) + (_e63.projection.row_w.z * _e222.z)) + (_e63.projection.row_w.w * 1f));
            let _e254 = (((((_e63.projection.row_x.x * _e222.x) + (_e63.projection.row_x.y * _e222.y)) + (_e63.projection.row_x.z * _e222.z)) + (_e63.projection.row_x.w * 1f)) / _e240);
            let _e268 = (((((_e63.projection.row_y.x * _e222.x) + (_e63.projection.row_y.y * _e222.y)) + (_e63.projection.row_y.z * _e222.z)) + (_e63.projection.row_y.w * 1f)) / _e240);
            let _e281 = ((((_e63.projection.row_z.x * _e222.x) + (_e63.projection.row_z.y * _e222.y)) + (_e63.projection.row_z.z * _e222.z)) + (_e63.projection.row_z.w * 1f));
            if (_e240 > 0f) {
                if (_e254 >= 0f) {
                    phi_1267_ = (_e254 <= 1f);
                } else {
                    phi_1267_ = false;
                }
                let _e286 = phi_1267_;
                if _e286 {
                    if (_e268 >= 0f) {
                        phi_1276_ = (_e268 <= 1f);
                    } else {
                        phi_1276_ = false;
                    }
                    let _e290 = phi_1276_;
                    if _e290 {
                        if (_e281 >= 0f) {
                            phi_1285_ = (_e281 <= 1f);
                        } else {
                            phi_1285_ = false;
                        }
                        let _e294 = phi_1285_;
                        phi_1286_ = _e294;
                        phi_1287_ = false;
                    } else {
                        phi_1286_ = bool();
                        phi_1287_ = true;
                    }
                    let _e296 = phi_1286_;
                    let _e298 = phi_1287_;
                    phi_1288_ = _e296;
                    phi_1289_ = _e298;
                } else {
                    phi_1288_ = bool();
                    phi_1289_ = true;
                }
                let _e300 = phi_1288_;
                let _e302 = phi_1289_;
                phi_1290_ = _e300;
                phi_1291_ = _e302;
            } else {
                phi_1290_ = bool();
                phi_1291_ = true;
            }
            let _e304 = phi_1290_;
            let _e306 = phi_1291_;
            if _e306 {
                phi_1295_ = false;
            } else {
                phi_1295_ = _e304;
            }
            let _e308 = phi_1295_;
            if _e308 {
                if (0f > 0f) {
                    let _e311 = samples.member[(0u + _e53.first_primitive)].normal;
                    let _e313 = p.member.map_size;
                    let _e383 = ((abs(((((_e59.row_x.x * _e311.x) + (_e59.row_x.y * _e311.y)) + (_e59.row_x.z * _e311.z)) / (((_e59.row_x.x * _e59.row_x.x) + (_e59.row_x.y * _e59.row_x.y)) + (_e59.row_x.z * _e59.row_x.z)))) + abs(((((_e59.row_y.x * _e311.x) + (_e59.row_y.y * _e311.y)) + (_e59.row_y.z * _e311.z)) / (((_e59.row_y.x * _e59.row_y.x) + (_e59.row_y.y * _e59.row_y.y)) + (_e59.row_y.z * _e59.row_y.z))))) / (abs(((((_e59.row_z.x * _e311.x) + (_e59.row_z.y * _e311.y)) + (_e59.row_z.z * _e311.z)) / (((_e59.row_z.x * _e59.row_z.x) + (_e59.row_z.y * _e59.row_z.y)) + (_e59.row_z.z * _e59.row_z.z)))) * f32(_e313)));
                    if (_e383 < 0.002f) {
                        phi_1385_ = _e383;
                    } else {
                        phi_1385_ = 0.002f;
                    }
                    let _e386 = phi_1385_;
                    phi_1388_ = (_e281 - (0f * _e386));
                } else {
                    phi_1388_ = _e281;
                }
                let _e390 = phi_1388_;
                let _e392 = p.member.map_size;
                let _e393 = f32(_e392);
                let _e396 = ((_e254 * _e393) - 0.5f);
                let _e397 = ((_e268 * _e393) - 0.5f);
                if (_e396 > -8388608f) {
                    let _e409 = f32(select(0i, select(select(i32(_e396), i32(-2147483648), (_e396 < bitcast<f32>(3472883712u))), 2147483647i, (_e396 > bitcast<f32>(1325400063u))), (_e396 == _e396)));
                    if (_e409 > _e396) {
                        phi_1417_ = 1f;
                    } else {
                        phi_1417_ = 0f;
                    }
                    let _e412 = phi_1417_;
                    if (_e396 < 8388608f) {
                        phi_1422_ = (_e409 - _e412);
                        phi_1423_ = false;
                    } else {
                        phi_1422_ = f32();
                        phi_1423_ = true;
                    }
                    let _e415 = phi_1422_;
                    let _e417 = phi_1423_;
                    phi_1424_ = _e415;
                    phi_1425_ = _e417;
                } else {
                    phi_1424_ = f32();
                    phi_1425_ = true;
                }
                let _e419 = phi_1424_;
                let _e421 = phi_1425_;
                if _e421 {
                    phi_1429_ = _e396;
                } else {
                    phi_1429_ = _e419;
                }
                let _e423 = phi_1429_;
                if (_e397 > -8388608f) {
                    let _e435 = f32(select(0i, select(select(i32(_e397), i32(-2147483648), (_e397 < bitcast<f32>(3472883712u))), 2147483647i, (_e397 > bitcast<f32>(1325400063u))), (_e397 == _e397)));
                    if (_e435 > _e397) {
                        phi_1449_ = 1f;
                    } else {
                        phi_1449_ = 0f;
                    }
                    let _e438 = phi_1449_;
                    if (_e397 < 8388608f) {
                        phi_1454_ = (_e435 - _e438);
                        phi_1455_ = false;
                    } else {
                        phi_1454_ = f32();
                        phi_1455_ = true;
                    }
                    let _e441 = phi_1454_;
                    let _e443 = phi_1455_;
                    phi_1456_ = _e441;
                    phi_1457_ = _e443;
                } else {
                    phi_1456_ = f32();
                    phi_1457_ = true;
                }
                let _e445 = phi_1456_;
                let _e447 = phi_1457_;
                if _e447 {
                    phi_1461_ = _e397;
                } else {
                    phi_1461_ = _e445;
                }
                let _e449 = phi_1461_;
                let _e450 = (_e396 - _e423);
                let _e451 = (_e397 - _e449);
                let _e460 = select(0i, select(select(i32(_e423), i32(-2147483648), (_e423 < bitcast<f32>(3472883712u))), 2147483647i, (_e423 > bitcast<f32>(1325400063u))), (_e423 == _e423));
                let _e469 = select(0i, select(select(i32(_e449), i32(-2147483648), (_e449 < bitcast<f32>(3472883712u))), 2147483647i, (_e449 > bitcast<f32>(1325400063u))), (_e449 == _e449));
                let _e472 = ((1f - _e450) * (1f - _e451));
                let _e474 = (_e450 * (1f - _e451));
                let _e476 = ((1f - _e450) * _e451);
                let _e477 = (_e450 * _e451);
                let _e479 = p.member.test;
                let _e480 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e479);
                let _e482 = p.member.map_size;
                local_1 = _e480;
                let _e484 = ((0u * _e482) * _e482);
                let _e486 = (bitcast<i32>(_e482) - 1i);
                if (_e460 > 0i) {
                    phi_1509_ = _e460;
                } else {
                    phi_1509_ = 0i;
                }
                let _e489 = phi_1509_;
                if (_e469 > 0i) {
                    phi_1514_ = _e469;
                } else {
                    phi_1514_ = 0i;
                }
                let _e492 = phi_1514_;
                if (_e489 < _e486) {
                    phi_1519_ = _e489;
                } else {
                    phi_1519_ = _e486;
                }
                let _e495 = phi_1519_;
                if (_e492 < _e486) {
                    phi_1524_ = _e492;
                } else {
                    phi_1524_ = _e486;
                }
                let _e498 = phi_1524_;
                let _e499 = bitcast<u32>(_e495);
                let _e501 = (_e460 + 1i);
                let _e502 = (_e469 + 1i);
                if (_e501 > 0i) {
                    phi_1533_ = _e501;
                } else {
                    phi_1533_ = 0i;
                }
                let _e505 = phi_1533_;
                if (_e502 > 0i) {
                    phi_1538_ = _e502;
                } else {
                    phi_1538_ = 0i;
                }
                let _e508 = phi_1538_;
                if (_e505 < _e486) {
                    phi_1543_ = _e505;
                } else {
                    phi_1543_ = _e486;
                }
                let _e511 = phi_1543_;
                if (_e508 < _e486) {
                    phi_1548_ = _e508;
                } else {
                    phi_1548_ = _e486;
                }
                let _e514 = phi_1548_;
                let _e515 = bitcast<u32>(_e511);
                let _e517 = (bitcast<u32>(_e498) * _e482);
                let _e518 = (bitcast<u32>(_e514) * _e482);
                let _e523 = ((_e517 + _e499) + _e484);
                let _e524 = ((_e517 + _e515) + _e484);
                let _e525 = ((_e518 + _e499) + _e484);
                let _e526 = ((_e518 + _e515) + _e484);
                if (_e523 < _e44) {
                } else {
                    return;
                }
                let _e530 = map.member[(0u + _e523)];
                if (_e524 < _e44) {
                } else {
                    return;
                }
                let _e542 = map.member[(0u + _e524)];
                if (_e525 < _e44) {
                } else {
                    return;
                }
                let _e558 = map.member[(0u + _e525)];
                if (_e526 < _e44) {
                } else {
                    return;
                }
                let _e574 = map.member[(0u + _e526)];
                let _e588 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_1), vec4<f32>(((((_e530.x * _e472) + (_e542.x * _e474)) + (_e558.x * _e476)) + (_e574.x * _e477)), ((((_e530.y * _e472) + (_e542.y * _e474)) + (_e558.y * _e476)) + (_e574.y * _e477)), ((((_e530.z * _e472) + (_e542.z * _e474)) + (_e558.z * _e476)) + (_e574.z * _e477)), ((((_e530.w * _e472) + (_e542.w * _e474)) + (_e558.w * _e476)) + (_e574.w * _e477))), _e390);
                let _e590 = p.member.epsilon;
                if (_e588 <= _e590) {
                    phi_1643_ = true;
                } else {
                    phi_1643_ = (_e588 >= (1f - _e590));
                }
                let _e595 = phi_1643_;
                if ((bitcast<u32>(_e588) & 2147483647u) > 2139095040u) {
                    phi_1651_ = true;
                } else {
                    phi_1651_ = !(_e595);
                }
                let _e601 = phi_1651_;
                if _e601 {
                    if (_e588 > 0f) {
                        if (_e588 < 1f) {
                            phi_1663_ = false;
                        } else {
                            phi_1663_ = true;
                        }
                        let _e605 = phi_1663_;
                        phi_1664_ = _e605;
                    } else {
                        phi_1664_ = true;
                    }
                    let _e607 = phi_1664_;
                    if _e607 {
                        phi_1668_ = 0.5f;
                    } else {
                        phi_1668_ = _e588;
                    }
                    let _e609 = phi_1668_;
                    phi_1676_ = evaluate_Verdict(_e609, true);
                } else {
                    if (_e588 > 0.5f) {
                        phi_1674_ = 1f;
                    } else {
                        phi_1674_ = 0f;
                    }
                    let _e613 = phi_1674_;
                    phi_1676_ = evaluate_Verdict(_e613, false);
                }
                let _e616 = phi_1676_;
                phi_1681_ = evaluate_Verdict(_e616.visibility, _e616.is_doubted);
            } else {
                phi_1681_ = evaluate_Verdict(0.5f, true);
            }
            let _e622 = phi_1681_;
            phi_1682_ = _e622;
        }
        let _e624 = phi_1682_;
        if (_e53.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e53.first_primitive)] = _e624.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_msm_hausdorff_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
