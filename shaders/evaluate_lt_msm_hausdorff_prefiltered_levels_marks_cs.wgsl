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

struct type_43 {
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
var<storage> samples: type_19;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_39;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_23;
@group(0) @binding(4) 
var<storage> marks: type_9;
@group(0) @binding(5) 
var<storage> levels: type_43;
@group(0) @binding(2) 
var<storage> map: type_35;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_179_: lt_bvh_traverse_Tree;
    var phi_180_: bool;
    var phi_181_: lt_bvh_traverse_Tree;
    var phi_182_: bool;
    var phi_187_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_179_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_180_ = false;
        } else {
            phi_179_ = lt_bvh_traverse_Tree();
            phi_180_ = true;
        }
        let _e61 = phi_179_;
        let _e63 = phi_180_;
        phi_181_ = _e61;
        phi_182_ = _e63;
    } else {
        phi_181_ = lt_bvh_traverse_Tree();
        phi_182_ = true;
    }
    let _e65 = phi_181_;
    let _e67 = phi_182_;
    if _e67 {
        phi_187_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_187_ = _e65;
    }
    let _e72 = phi_187_;
    return lt_bvh_traverse_Tree(_e72.root, _e72.first_primitive);
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn lt_math_hausdorff_cubic_mass(param_4: vec4<f32>, param_5: f32, param_6: f32, param_7: f32, param_8: f32) -> f32 {
    return ((((param_4.z - (((param_6 + param_7) + param_8) * param_4.y)) + ((((param_6 * param_7) + (param_6 * param_8)) + (param_7 * param_8)) * param_4.x)) - ((param_6 * param_7) * param_8)) / (((param_5 - param_6) * (param_5 - param_7)) * (param_5 - param_8)));
}

fn lt_math_hausdorff_endpoint_upper_bound(param_9: ptr<function, hankel_HankelFactors>, param_10: f32) -> f32 {
    var phi_957_: f32;
    var phi_958_: f32;
    var phi_959_: f32;
    var phi_986_: f32;
    var phi_987_: f32;
    var phi_988_: f32;
    var phi_989_: f32;
    var phi_990_: bool;
    var phi_991_: f32;
    var phi_992_: bool;
    var phi_1020_: f32;
    var phi_1021_: f32;
    var phi_1022_: f32;
    var phi_1023_: f32;
    var phi_1024_: bool;
    var phi_1025_: f32;
    var phi_1026_: bool;
    var phi_1033_: f32;
    var phi_1034_: f32;
    var phi_1035_: f32;
    var phi_1036_: f32;

    let _e51 = (*param_9).moments;
    if (param_10 < 0.0001f) {
        phi_1036_ = 1f;
    } else {
        let _e60 = ((_e51.z - ((1f + param_10) * _e51.y)) + (param_10 * _e51.x));
        let _e69 = (((_e51.w - ((1f + param_10) * _e51.z)) + (param_10 * _e51.y)) / _e60);
        if (abs(_e60) <= 0.00000047683716f) {
            let _e83 = (1f - (((_e51.y - (_e51.x * (param_10 + 1f))) + (param_10 * 1f)) / ((0f - param_10) * (0f - 1f))));
            if ((bitcast<u32>(_e83) & 2147483647u) > 2139095040u) {
                phi_959_ = _e83;
            } else {
                if (_e83 < 0f) {
                    phi_958_ = 0f;
                } else {
                    if (_e83 > 1f) {
                        phi_957_ = 1f;
                    } else {
                        phi_957_ = _e83;
                    }
                    let _e90 = phi_957_;
                    phi_958_ = _e90;
                }
                let _e92 = phi_958_;
                phi_959_ = _e92;
            }
            let _e94 = phi_959_;
            phi_1035_ = _e94;
        } else {
            if (_e69 > 0f) {
                if (_e69 < param_10) {
                    let _e97 = lt_math_hausdorff_cubic_mass(_e51, 0f, _e69, param_10, 1f);
                    let _e99 = lt_math_hausdorff_cubic_mass(_e51, _e69, 0f, param_10, 1f);
                    let _e100 = ((1f - _e97) - _e99);
                    if ((bitcast<u32>(_e100) & 2147483647u) > 2139095040u) {
                        phi_988_ = _e100;
                    } else {
                        if (_e100 < 0f) {
                            phi_987_ = 0f;
                        } else {
                            if (_e100 > 1f) {
                                phi_986_ = 1f;
                            } else {
                                phi_986_ = _e100;
                            }
                            let _e107 = phi_986_;
                            phi_987_ = _e107;
                        }
                        let _e109 = phi_987_;
                        phi_988_ = _e109;
                    }
                    let _e111 = phi_988_;
                    phi_989_ = _e111;
                    phi_990_ = false;
                } else {
                    phi_989_ = f32();
                    phi_990_ = true;
                }
                let _e113 = phi_989_;
                let _e115 = phi_990_;
                phi_991_ = _e113;
                phi_992_ = _e115;
            } else {
                phi_991_ = f32();
                phi_992_ = true;
            }
            let _e117 = phi_991_;
            let _e119 = phi_992_;
            if _e119 {
                if (_e69 > param_10) {
                    if (_e69 < 1f) {
                        let _e122 = lt_math_hausdorff_cubic_mass(_e51, 0f, _e69, param_10, 1f);
                        let _e123 = (1f - _e122);
                        if ((bitcast<u32>(_e123) & 2147483647u) > 2139095040u) {
                            phi_1022_ = _e123;
                        } else {
                            if (_e123 < 0f) {
                                phi_1021_ = 0f;
                            } else {
                                if (_e123 > 1f) {
                                    phi_1020_ = 1f;
                                } else {
                                    phi_1020_ = _e123;
                                }
                                let _e130 = phi_1020_;
                                phi_1021_ = _e130;
                            }
                            let _e132 = phi_1021_;
                            phi_1022_ = _e132;
                        }
                        let _e134 = phi_1022_;
                        phi_1023_ = _e134;
                        phi_1024_ = false;
                    } else {
                        phi_1023_ = f32();
                        phi_1024_ = true;
                    }
                    let _e136 = phi_1023_;
                    let _e138 = phi_1024_;
                    phi_1025_ = _e136;
                    phi_1026_ = _e138;
                } else {
                    phi_1025_ = f32();
                    phi_1026_ = true;
                }
                let _e140 = phi_1025_;
                let _e142 = phi_1026_;
                if _e142 {
                    phi_1033_ = bitcast<f32>((bitcast<u32>(_e69) | 2143289344u));
                } else {
                    phi_1033_ = _e140;
                }
                let _e147 = phi_1033_;
                phi_1034_ = _e147;
            } else {
                phi_1034_ = _e117;
            }
            let _e149 = phi_1034_;
            phi_1035_ = _e149;
        }
        let _e151 = phi_1035_;
        phi_1036_ = _e151;
    }
    let _e153 = phi_1036_;
    return _e153;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_11: ptr<function, f32>, param_12: vec4<f32>, param_13: f32) -> f32 {
    var local: hankel_HankelFactors;
    var phi_244_: f32;
    var phi_245_: f32;
    var phi_246_: f32;
    var phi_258_: bool;
    var phi_273_: bool;
    var phi_298_: f32;
    var phi_299_: f32;
    var phi_300_: f32;
    var phi_301_: f32;
    var phi_302_: bool;
    var phi_303_: f32;
    var phi_304_: bool;
    var phi_360_: vec2<f32>;
    var phi_398_: f32;
    var phi_399_: f32;
    var phi_400_: f32;
    var phi_433_: f32;
    var phi_434_: f32;
    var phi_435_: f32;
    var phi_439_: f32;
    var phi_440_: f32;
    var phi_441_: f32;
    var phi_442_: f32;
    var phi_495_: vec2<f32>;
    var phi_517_: bool;
    var phi_542_: f32;
    var phi_543_: f32;
    var phi_544_: f32;
    var phi_545_: f32;
    var phi_546_: bool;
    var phi_547_: f32;
    var phi_548_: bool;
    var phi_604_: vec2<f32>;
    var phi_642_: f32;
    var phi_643_: f32;
    var phi_644_: f32;
    var phi_677_: f32;
    var phi_678_: f32;
    var phi_679_: f32;
    var phi_683_: f32;
    var phi_684_: f32;
    var phi_685_: f32;
    var phi_686_: f32;
    var phi_687_: f32;
    var phi_688_: bool;
    var phi_689_: f32;
    var phi_690_: bool;
    var phi_712_: bool;
    var phi_737_: f32;
    var phi_738_: f32;
    var phi_739_: f32;
    var phi_740_: f32;
    var phi_741_: bool;
    var phi_742_: f32;
    var phi_743_: bool;
    var phi_799_: vec2<f32>;
    var phi_837_: f32;
    var phi_838_: f32;
    var phi_839_: f32;
    var phi_872_: f32;
    var phi_873_: f32;
    var phi_874_: f32;
    var phi_878_: f32;
    var phi_879_: f32;
    var phi_880_: f32;
    var phi_881_: f32;
    var phi_892_: bool;
    var phi_896_: f32;
    var phi_897_: f32;
    var phi_898_: f32;
    var phi_899_: f32;

    let _e52 = (*param_11);
    let _e53 = (1f - _e52);
    let _e62 = (0.5f * _e52);
    let _e63 = ((param_12.x * _e53) + _e62);
    let _e64 = ((param_12.y * _e53) + _e62);
    let _e65 = ((param_12.z * _e53) + _e62);
    let _e66 = ((param_12.w * _e53) + _e62);
    let _e69 = (_e64 - (_e63 * _e63));
    let _e71 = (_e65 - (_e63 * _e64));
    let _e77 = hankel_HankelFactors(vec4<f32>(_e63, _e64, _e65, _e66), _e69, _e71, (((_e66 - (_e64 * _e64)) * _e69) - (_e71 * _e71)));
    local = hankel_HankelFactors(_e77.moments, _e77.d22_, _e77.l32_d22_, _e77.d33_d22_);
    if ((bitcast<u32>(param_13) & 2147483647u) > 2139095040u) {
        phi_246_ = param_13;
    } else {
        if (param_13 < 0f) {
            phi_245_ = 0f;
        } else {
            if (param_13 > 1f) {
                phi_244_ = 1f;
            } else {
                phi_244_ = param_13;
            }
            let _e89 = phi_244_;
            phi_245_ = _e89;
        }
        let _e91 = phi_245_;
        phi_246_ = _e91;
    }
    let _e93 = phi_246_;
    let _e96 = local.moments[0u];
    let _e99 = local.moments[3u];
    if (_e96 == _e99) {
        let _e103 = local.moments[0u];
        phi_258_ = (_e103 > 0.5f);
    } else {
        phi_258_ = false;
    }
    let _e106 = phi_258_;
    if _e106 {
        let _e109 = local.moments[0u];
        let _e112 = local.moments[3u];
        if (_e109 == _e112) {
            let _e116 = local.moments[0u];
            phi_273_ = (_e116 > 0.5f);
        } else {
            phi_273_ = false;
        }
        let _e119 = phi_273_;
        if _e119 {
            if (_e93 > 0f) {
                let _e122 = local.moments;
                if ((bitcast<u32>(_e122.x) & 2147483647u) > 2139095040u) {
                    phi_300_ = _e122.x;
                } else {
                    if (_e122.x < 0f) {
                        phi_299_ = 0f;
                    } else {
                        if (_e122.x > 1f) {
                            phi_298_ = 1f;
                        } else {
                            phi_298_ = _e122.x;
                        }
                        let _e130 = phi_298_;
                        phi_299_ = _e130;
                    }
                    let _e132 = phi_299_;
                    phi_300_ = _e132;
                }
                let _e134 = phi_300_;
                phi_301_ = _e134;
                phi_302_ = false;
            } else {
                phi_301_ = f32();
                phi_302_ = true;
            }
            let _e136 = phi_301_;
            let _e138 = phi_302_;
            phi_303_ = _e136;
            phi_304_ = _e138;
        } else {
            phi_303_ = f32();
            phi_304_ = true;
        }
        let _e140 = phi_303_;
        let _e142 = phi_304_;
        if _e142 {
            let _e145 = local.moments[0u];
            let _e148 = local.moments[1u];
            let _e156 = local.l32_d22_;
            let _e158 = local.d22_;
            let _e159 = (_e156 / _e158);
            let _e160 = (_e93 - _e145);
            let _e166 = local.d22_;
            let _e169 = local.d33_d22_;
            let _e170 = (((((_e93 * _e93) - _e148) - (_e159 * _e160)) * _e166) / _e169);
            let _e172 = local.d22_;
            let _e175 = ((_e160 / _e172) - (_e159 * _e170));
            let _e181 = ((0.5f * _e175) / _e170);
            let _e184 = ((_e181 * _e181) - (((1f - (_e175 * _e145)) - (_e170 * _e148)) / _e170));
            if (_e184 >= 0f) {
                let _e186 = sqrt(_e184);
                phi_360_ = vec2<f32>((-(_e181) - _e186), (-(_e181) + _e186));
            } else {
                phi_360_ = vec2(bitcast<f32>((bitcast<u32>(_e184) | 2143289344u)));
            }
            let _e197 = phi_360_;
            if (_e93 <= _e197.x) {
                phi_441_ = 1f;
            } else {
                if (_e93 > _e197.y) {
                    let _e203 = local.moments;
                    let _e214 = (((_e203.y - (_e203.x * (_e197.x + _e197.y))) + (_e197.x * _e197.y)) / ((_e93 - _e197.x) * (_e93 - _e197.y)));
                    if ((bitcast<u32>(_e214) & 2147483647u) > 2139095040u) {
                        phi_400_ = _e214;
                    } else {
                        if (_e214 < 0f) {
                            phi_399_ = 0f;
                        } else {
                            if (_e214 > 1f) {
                                phi_398_ = 1f;
                            } else {
                                phi_398_ = _e214;
                            }
                            let _e221 = phi_398_;
                            phi_399_ = _e221;
                        }
                        let _e223 = phi_399_;
                        phi_400_ = _e223;
                    }
                    let _e225 = phi_400_;
                    phi_440_ = _e225;
                } else {
                    if (_e93 > _e197.x) {
                        let _e228 = local.moments;
                        let _e240 = (1f - (((_e228.y - (_e228.x * (_e93 + _e197.y))) + (_e93 * _e197.y)) / ((_e197.x - _e93) * (_e197.x - _e197.y))));
                        if ((bitcast<u32>(_e240) & 2147483647u) > 2139095040u) {
                            phi_435_ = _e240;
                        } else {
                            if (_e240 < 0f) {
                                phi_434_ = 0f;
                            } else {
                                if (_e240 > 1f) {
                                    phi_433_ = 1f;
                                } else {
                                    phi_433_ = _e240;
                                }
                                let _e247 = phi_433_;
                                phi_434_ = _e247;
                            }
                            let _e249 = phi_434_;
                            phi_435_ = _e249;
                        }
                        let _e251 = phi_435_;
                        phi_439_ = _e251;
                    } else {
                        phi_439_ = bitcast<f32>((bitcast<u32>(_e197.x) | 2143289344u));
                    }
                    let _e256 = phi_439_;
                    phi_440_ = _e256;
                }
                let _e258 = phi_440_;
                phi_441_ = _e258;
            }
            let _e260 = phi_441_;
            phi_442_ = _e260;
        } else {
            phi_442_ = _e140;
        }
        let _e262 = phi_442_;
        phi_899_ = _e262;
    } else {
        let _e265 = local.moments[0u];
        let _e268 = local.moments[1u];
        let _e276 = local.l32_d22_;
        let _e278 = local.d22_;
        let _e279 = (_e276 / _e278);
        let _e280 = (_e93 - _e265);
        let _e286 = local.d22_;
        let _e289 = local.d33_d22_;
        let _e290 = (((((_e93 * _e93) - _e268) - (_e279 * _e280)) * _e286) / _e289);
        let _e292 = local.d22_;
        let _e295 = ((_e280 / _e292) - (_e279 * _e290));
        let _e301 = ((0.5f * _e295) / _e290);
        let _e304 = ((_e301 * _e301) - (((1f - (_e295 * _e265)) - (_e290 * _e268)) / _e290));
        if (_e304 >= 0f) {
            let _e306 = sqrt(_e304);
            phi_495_ = vec2<f32>((-(_e301) - _e306), (-(_e301) + _e306));
        } else {
            phi_495_ = vec2(bitcast<f32>((bitcast<u32>(_e304) | 2143289344u)));
        }
        let _e317 = phi_495_;
        if (_e317.x >= 0f) {
            if (_e317.y <= 1f) {
                let _e324 = local.moments[0u];
                let _e327 = local.moments[3u];
                if (_e324 == _e327) {
                    let _e331 = local.moments[0u];
                    phi_517_ = (_e331 > 0.5f);
                } else {
                    phi_517_ = false;
                }
                let _e334 = phi_517_;
                if _e334 {
                    if (_e93 > 0f) {
                        let _e337 = local.moments;
                        if ((bitcast<u32>(_e337.x) & 2147483647u) > 2139095040u) {
                            phi_544_ = _e337.x;
                        } else {
                            if (_e337.x < 0f) {
                                phi_543_ = 0f;
                            } else {
                                if (_e337.x > 1f) {
                                    phi_542_ = 1f;
                                } else {
                                    phi_542_ = _e337.x;
                                }
                                let _e345 = phi_542_;
                                phi_543_ = _e345;
                            }
                            let _e347 = phi_543_;
                            phi_544_ = _e347;
                        }
                        let _e349 = phi_544_;
                        phi_545_ = _e349;
                        phi_546_ = false;
                    } else {
                        phi_545_ = f32();
                        phi_546_ = true;
                    }
                    let _e351 = phi_545_;
                    let _e353 = phi_546_;
                    phi_547_ = _e351;
                    phi_548_ = _e353;
                } else {
                    phi_547_ = f32();
                    phi_548_ = true;
                }
                let _e355 = phi_547_;
                let _e357 = phi_548_;
                if _e357 {
                    let _e360 = local.moments[0u];
                    let _e363 = local.moments[1u];
                    let _e371 = local.l32_d22_;
                    let _e373 = local.d22_;
                    let _e374 = (_e371 / _e373);
                    let _e375 = (_e93 - _e360);
                    let _e381 = local.d22_;
                    let _e384 = local.d33_d22_;
                    let _e385 = (((((_e93 * _e93) - _e363) - (_e374 * _e375)) * _e381) / _e384);
                    let _e387 = local.d22_;
                    let _e390 = ((_e375 / _e387) - (_e374 * _e385));
                    let _e396 = ((0.5f * _e390) / _e385);
                    let _e399 = ((_e396 * _e396) - (((1f - (_e390 * _e360)) - (_e385 * _e363)) / _e385));
                    if (_e399 >= 0f) {
                        let _e401 = sqrt(_e399);
                        phi_604_ = vec2<f32>((-(_e396) - _e401), (-(_e396) + _e401));
                    } else {
                        phi_604_ = vec2(bitcast<f32>((bitcast<u32>(_e399) | 2143289344u)));
                    }
                    let _e412 = phi_604_;
                    if (_e93 <= _e412.x) {
                        phi_685_ = 1f;
                    } else {
                        if (_e93 > _e412.y) {
                            let _e418 = local.moments;
                            let _e429 = (((_e418.y - (_e418.x * (_e412.x + _e412.y))) + (_e412.x * _e412.y)) / ((_e93 - _e412.x) * (_e93 - _e412.y)));
                            if ((bitcast<u32>(_e429) & 2147483647u) > 2139095040u) {
                                phi_644_ = _e429;
                            } else {
                                if (_e429 < 0f) {
                                    phi_643_ = 0f;
                                } else {
                                    if (_e429 > 1f) {
                                        phi_642_ = 1f;
                                    } else {
                                        phi_642_ = _e429;
                                    }
                                    let _e436 = phi_642_;
                                    phi_643_ = _e436;
                                }
                                let _e438 = phi_643_;
                                phi_644_ = _e438;
                            }
                            let _e440 = phi_644_;
                            phi_684_ = _e440;
                        } else {
                            if (_e93 > _e412.x) {
                                let _e443 = local.moments;
                                let _e455 = (1f - (((_e443.y - (_e443.x * (_e93 + _e412.y))) + (_e93 * _e412.y)) / ((_e412.x - _e93) * (_e412.x - _e412.y))));
                                if ((bitcast<u32>(_e455) & 2147483647u) > 2139095040u) {
                                    phi_679_ = _e455;
                                } else {
                                    if (_e455 < 0f) {
                                        phi_678_ = 0f;
                                    } else {
                                        if (_e455 > 1f) {
                                            phi_677_ = 1f;
                                        } else {
                                            phi_677_ = _e455;
                                        }
                                        let _e462 = phi_677_;
                                        phi_678_ = _e462;
                                    }
                                    let _e464 = phi_678_;
                                    phi_679_ = _e464;
                                }
                                let _e466 = phi_679_;
                                phi_683_ = _e466;
                            } else {
                                phi_683_ = bitcast<f32>((bitcast<u32>(_e412.x) | 2143289344u));
                            }
                            let _e471 = phi_683_;
                            phi_684_ = _e471;
                        }
                        let _e473 = phi_684_;
                        phi_685_ = _e473;
                    }
                    let _e475 = phi_685_;
                    phi_686_ = _e475;
                } else {
                    phi_686_ = _e355;
                }
                let _e477 = phi_686_;
                phi_687_ = _e477;
                phi_688_ = false;
            } else {
                phi_687_ = f32();
                phi_688_ = true;
            }
            let _e479 = phi_687_;
            let _e481 = phi_688_;
            phi_689_ = _e479;
            phi_690_ = _e481;
        } else {
            phi_689_ = f32();
            phi_690_ = true;
        }
        let _e483 = phi_689_;
        let _e485 = phi_690_;
        if _e485 {
            if ((bitcast<u32>(_e317.x) & 2147483647u) > 2139095040u) {
                phi_897_ = _e317.x;
            } else {
                let _e489 = lt_math_hausdorff_endpoint_upper_bound((&local), _e93);
                let _e492 = local.moments[0u];
                let _e495 = local.moments[3u];
                if (_e492 == _e495) {
                    let _e499 = local.moments[0u];
                    phi_712_ = (_e499 > 0.5f);
                } else {
                    phi_712_ = false;
                }
                let _e502 = phi_712_;
                if _e502 {
                    if (_e93 > 0f) {
                        let _e505 = local.moments;
                        if ((bitcast<u32>(_e505.x) & 2147483647u) > 2139095040u) {
                            phi_739_ = _e505.x;
                        } else {
                            if (_e505.x < 0f) {
                                phi_738_ = 0f;
                            } else {
                                if (_e505.x > 1f) {
                                    phi_737_ = 1f;
                                } else {
                                    phi_737_ = _e505.x;
                                }
                                let _e513 = phi_737_;
                                phi_738_ = _e513;
                            }
                            let _e515 = phi_738_;
                            phi_739_ = _e515;
                        }
                        let _e517 = phi_739_;
                        phi_740_ = _e517;
                        phi_741_ = false;
                    } else {
                        phi_740_ = f32();
                        phi_741_ = true;
                    }
                    let _e519 = phi_740_;
                    let _e521 = phi_741_;
                    phi_742_ = _e519;
                    phi_743_ = _e521;
                } else {
                    phi_742_ = f32();
                    phi_743_ = true;
                }
                let _e523 = phi_742_;
                let _e525 = phi_743_;
                if _e525 {
                    let _e528 = local.moments[0u];
                    let _e531 = local.moments[1u];
                    let _e539 = local.l32_d22_;
                    let _e541 = local.d22_;
                    let _e542 = (_e539 / _e541);
                    let _e543 = (_e93 - _e528);
                    let _e549 = local.d22_;
                    let _e552 = local.d33_d22_;
                    let _e553 = (((((_e93 * _e93) - _e531) - (_e542 * _e543)) * _e549) / _e552);
                    let _e555 = local.d22_;
                    let _e558 = ((_e543 / _e555) - (_e542 * _e553));
                    let _e564 = ((0.5f * _e558) / _e553);
                    let _e567 = ((_e564 * _e564) - (((1f - (_e558 * _e528)) - (_e553 * _e531)) / _e553));
                    if (_e567 >= 0f) {
                        let _e569 = sqrt(_e567);
                        phi_799_ = vec2<f32>((-(_e564) - _e569), (-(_e564) + _e569));
                    } else {
                        phi_799_ = vec2(bitcast<f32>((bitcast<u32>(_e567) | 2143289344u)));
                    }
                    let _e580 = phi_799_;
                    if (_e93 <= _e580.x) {
                        phi_880_ = 1f;
                    } else {
                        if (_e93 > _e580.y) {
                            let _e586 = local.moments;
                            let _e597 = (((_e586.y - (_e586.x * (_e580.x + _e580.y))) + (_e580.x * _e580.y)) / ((_e93 - _e580.x) * (_e93 - _e580.y)));
                            if ((bitcast<u32>(_e597) & 2147483647u) > 2139095040u) {
                                phi_839_ = _e597;
                            } else {
                                if (_e597 < 0f) {
                                    phi_838_ = 0f;
                                } else {
                                    if (_e597 > 1f) {
                                        phi_837_ = 1f;
                                    } else {
                                        phi_837_ = _e597;
                                    }
                                    let _e604 = phi_837_;
                                    phi_838_ = _e604;
                                }
                                let _e606 = phi_838_;
                                phi_839_ = _e606;
                            }
                            let _e608 = phi_839_;
                            phi_879_ = _e608;
                        } else {
                            if (_e93 > _e580.x) {
                                let _e611 = local.moments;
                                let _e623 = (1f - (((_e611.y - (_e611.x * (_e93 + _e580.y))) + (_e93 * _e580.y)) / ((_e580.x - _e93) * (_e580.x - _e580.y))));
                                if ((bitcast<u32>(_e623) & 2147483647u) > 2139095040u) {
                                    phi_874_ = _e623;
                                } else {
                                    if (_e623 < 0f) {
                                        phi_873_ = 0f;
                                    } else {
                                        if (_e623 > 1f) {
                                            phi_872_ = 1f;
                                        } else {
                                            phi_872_ = _e623;
                                        }
                                        let _e630 = phi_872_;
                                        phi_873_ = _e630;
                                    }
                                    let _e632 = phi_873_;
                                    phi_874_ = _e632;
                                }
                                let _e634 = phi_874_;
                                phi_878_ = _e634;
                            } else {
                                phi_878_ = bitcast<f32>((bitcast<u32>(_e580.x) | 2143289344u));
                            }
                            let _e639 = phi_878_;
                            phi_879_ = _e639;
                        }
                        let _e641 = phi_879_;
                        phi_880_ = _e641;
                    }
                    let _e643 = phi_880_;
                    phi_881_ = _e643;
                } else {
                    phi_881_ = _e523;
                }
                let _e645 = phi_881_;
                if ((bitcast<u32>(_e645) & 2147483647u) > 2139095040u) {
                    phi_892_ = true;
                } else {
                    let _e649 = (_e645 < _e489);
                    if _e649 {
                    }
                    phi_892_ = _e649;
                }
                let _e651 = phi_892_;
                if _e651 {
                    phi_896_ = _e645;
                } else {
                    phi_896_ = _e489;
                }
                let _e653 = phi_896_;
                phi_897_ = _e653;
            }
            let _e655 = phi_897_;
            phi_898_ = _e655;
        } else {
            phi_898_ = _e483;
        }
        let _e657 = phi_898_;
        phi_899_ = _e657;
    }
    let _e659 = phi_899_;
    return _e659;
}

fn function_() {
    var local_1: f32;
    var phi_1131_: bool;
    var phi_1132_: bool;
    var phi_1133_: bool;
    var phi_1134_: bool;
    var phi_1138_: bool;
    var phi_1208_: bool;
    var phi_1209_: bool;
    var phi_1220_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1221_: bool;
    var phi_1222_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1223_: bool;
    var phi_1230_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1234_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1254_: lt_math_LightPoint;
    var phi_1257_: u32;
    var phi_1259_: lt_math_LevelPoint;
    var phi_1345_: bool;
    var phi_1354_: bool;
    var phi_1363_: bool;
    var phi_1364_: bool;
    var phi_1365_: bool;
    var phi_1366_: bool;
    var phi_1367_: bool;
    var phi_1368_: bool;
    var phi_1369_: bool;
    var phi_1373_: bool;
    var phi_1400_: bool;
    var phi_1401_: bool;
    var phi_1402_: bool;
    var phi_1403_: bool;
    var phi_1404_: bool;
    var phi_1405_: bool;
    var phi_1406_: bool;
    var phi_1407_: bool;
    var phi_1411_: bool;
    var phi_1420_: lt_math_LightPoint;
    var phi_1421_: u32;
    var phi_1422_: lt_math_LevelPoint;
    var phi_1423_: bool;
    var phi_1255_: lt_math_LightPoint;
    var phi_1258_: u32;
    var phi_1260_: lt_math_LevelPoint;
    var phi_1424_: bool;
    var local_2: lt_math_LevelPoint;
    var local_3: lt_math_LevelPoint;
    var phi_1464_: bool;
    var phi_1465_: bool;
    var phi_1466_: bool;
    var phi_1467_: bool;
    var phi_1471_: bool;
    var phi_1553_: f32;
    var phi_1671_: f32;
    var phi_1672_: f32;
    var phi_1675_: f32;
    var phi_1704_: f32;
    var phi_1709_: f32;
    var phi_1710_: bool;
    var phi_1711_: f32;
    var phi_1712_: bool;
    var phi_1716_: f32;
    var phi_1736_: f32;
    var phi_1741_: f32;
    var phi_1742_: bool;
    var phi_1743_: f32;
    var phi_1744_: bool;
    var phi_1748_: f32;
    var local_4: lt_math_LevelPoint;
    var phi_1799_: i32;
    var phi_1804_: i32;
    var phi_1809_: i32;
    var phi_1814_: i32;
    var phi_1823_: i32;
    var phi_1828_: i32;
    var phi_1833_: i32;
    var phi_1838_: i32;
    var local_5: lt_math_LevelPoint;
    var phi_1938_: i32;
    var phi_1943_: i32;
    var phi_1948_: i32;
    var phi_1953_: i32;
    var phi_1972_: i32;
    var phi_1977_: i32;
    var phi_1982_: i32;
    var phi_1987_: i32;
    var phi_2006_: i32;
    var phi_2011_: i32;
    var phi_2016_: i32;
    var phi_2021_: i32;
    var phi_2040_: i32;
    var phi_2045_: i32;
    var phi_2050_: i32;
    var phi_2055_: i32;
    var phi_2133_: bool;
    var phi_2141_: bool;
    var phi_2153_: bool;
    var phi_2154_: bool;
    var phi_2158_: f32;
    var phi_2164_: f32;
    var phi_2166_: evaluate_Verdict;
    var phi_2176_: u32;
    var phi_2185_: f32;
    var phi_2187_: evaluate_Verdict;
    var phi_2188_: bool;
    var phi_2189_: evaluate_Verdict;
    var phi_2190_: bool;
    var phi_2195_: evaluate_Verdict;
    var phi_2200_: evaluate_Verdict;
    var phi_2201_: evaluate_Verdict;

    let _e49 = id_1;
    let _e56 = arrayLength((&map.member));
    let _e62 = arrayLength((&marks.member));
    let _e65 = arrayLength((&levels.member));
    let _e68 = p.member.size[0u];
    let _e70 = p.member.size[1u];
    let _e71 = lt_shaders_entry_pixel_index(_e49, _e68, _e70);
    if (bitcast<i32>(_e71.root) != 0i) {
        let _e77 = p.member.level_count;
        if (_e71.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e84 = samples.member[(0u + _e71.first_primitive)].normal[0u];
        let _e86 = global[0u];
        if (_e84 == _e86) {
            let _e89 = samples.member[(0u + _e71.first_primitive)].normal[1u];
            let _e91 = global[1u];
            if (_e89 == _e91) {
                let _e94 = samples.member[(0u + _e71.first_primitive)].normal[2u];
                let _e96 = global[2u];
                phi_1131_ = (_e94 == _e96);
                phi_1132_ = false;
            } else {
                phi_1131_ = bool();
                phi_1132_ = true;
            }
            let _e99 = phi_1131_;
            let _e101 = phi_1132_;
            phi_1133_ = _e99;
            phi_1134_ = _e101;
        } else {
            phi_1133_ = bool();
            phi_1134_ = true;
        }
        let _e103 = phi_1133_;
        let _e105 = phi_1134_;
        if _e105 {
            phi_1138_ = false;
        } else {
            phi_1138_ = _e103;
        }
        let _e107 = phi_1138_;
        if !(_e107) {
            let _e110 = samples.member[(0u + _e71.first_primitive)].position;
            let _e112 = p.member.light.place;
            let _e118 = p.member.light.place[3u];
            let _e125 = (_e112.x - (_e110.x * _e118));
            let _e126 = (_e112.y - (_e110.y * _e118));
            let _e127 = (_e112.z - (_e110.z * _e118));
            let _e129 = samples.member[(0u + _e71.first_primitive)].normal;
            if ((((_e129.x * _e125) + (_e129.y * _e126)) + (_e129.z * _e127)) > 0f) {
                let _e143 = (((_e125 * _e125) + (_e126 * _e126)) + (_e127 * _e127));
                let _e145 = p.member.light.axis;
                let _e157 = p.member.light.place[3u];
                if (_e157 == 0f) {
                    phi_1209_ = true;
                } else {
                    let _e160 = p.member.light.range_squared;
                    if (_e143 <= _e160) {
                        let _e163 = p.member.light.cos_outer;
                        phi_1208_ = (-((((_e125 * _e145.x) + (_e126 * _e145.y)) + (_e127 * _e145.z))) >= (_e163 * sqrt(_e143)));
                    } else {
                        phi_1208_ = false;
                    }
                    let _e168 = phi_1208_;
                    phi_1209_ = _e168;
                }
                let _e170 = phi_1209_;
                if _e170 {
                    let _e172 = samples.member[(0u + _e71.first_primitive)].flags;
                    let _e180 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e186 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e180.unnamed.visibility, false), _e180.unnamed_1);
                    phi_1220_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e186.unnamed, ((_e172 & 1u) == 0u));
                    phi_1221_ = false;
                } else {
                    phi_1220_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_1221_ = true;
                }
                let _e191 = phi_1220_;
                let _e193 = phi_1221_;
                phi_1222_ = _e191;
                phi_1223_ = _e193;
            } else {
                phi_1222_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_1223_ = true;
            }
            let _e195 = phi_1222_;
            let _e197 = phi_1223_;
            if _e197 {
                let _e203 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e209 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e203.unnamed.visibility, false), _e203.unnamed_1);
                phi_1230_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e209.unnamed, true);
            } else {
                phi_1230_ = _e195;
            }
            let _e214 = phi_1230_;
            phi_1234_ = _e214;
        } else {
            let _e220 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e226 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e220.unnamed.visibility, false), _e220.unnamed_1);
            phi_1234_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e226.unnamed, true);
        }
        let _e231 = phi_1234_;
        if _e231.unnamed_1 {
            phi_2201_ = evaluate_Verdict(_e231.unnamed.visibility, _e231.unnamed.is_doubted);
        } else {
            let _e239 = samples.member[(0u + _e71.first_primitive)].position;
            let _e241 = p.member.map_size;
            let _e243 = (0.5f / f32(_e241));
            let _e250 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e257 = lt_math_LightPoint(vec2<f32>(_e250.uv.x, 0f), _e250.depth, _e250.is_inside);
            let _e261 = lt_math_LightPoint(_e257.uv, 0f, _e257.is_inside);
            phi_1254_ = lt_math_LightPoint();
            phi_1257_ = 0u;
            phi_1259_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e261.uv, _e261.depth, false));
            loop {
                let _e268 = phi_1254_;
                let _e270 = phi_1257_;
                let _e272 = phi_1259_;
                local_2 = _e272;
                local_3 = _e272;
                local_4 = _e272;
                local_5 = _e272;
                if (_e270 < _e77) {
                    if _e272.point.is_inside {
                        phi_1420_ = lt_math_LightPoint();
                        phi_1421_ = u32();
                        phi_1422_ = lt_math_LevelPoint();
                        phi_1423_ = false;
                    } else {
                        if (_e270 < _e65) {
                        } else {
                            return;
                        }
                        let _e283 = levels.member[(0u + _e270)].row_w;
                        let _e294 = ((((_e283.x * _e239.x) + (_e283.y * _e239.y)) + (_e283.z * _e239.z)) + (_e283.w * 1f));
                        let _e296 = levels.member[(0u + _e270)].row_x;
                        let _e308 = (((((_e296.x * _e239.x) + (_e296.y * _e239.y)) + (_e296.z * _e239.z)) + (_e296.w * 1f)) / _e294);
                        let _e310 = levels.member[(0u + _e270)].row_y;
                        let _e322 = (((((_e310.x * _e239.x) + (_e310.y * _e239.y)) + (_e310.z * _e239.z)) + (_e310.w * 1f)) / _e294);
                        let _e324 = levels.member[(0u + _e270)].row_z;
                        let _e335 = ((((_e324.x * _e239.x) + (_e324.y * _e239.y)) + (_e324.z * _e239.z)) + (_e324.w * 1f));
                        if (_e294 > 0f) {
                            if (_e308 >= 0f) {
                                phi_1345_ = (_e308 <= 1f);
                            } else {
                                phi_1345_ = false;
                            }
                            let _e340 = phi_1345_;
                            if _e340 {
                                if (_e322 >= 0f) {
                                    phi_1354_ = (_e322 <= 1f);
                                } else {
                                    phi_1354_ = false;
                                }
                                let _e344 = phi_1354_;
                                if _e344 {
                                    if (_e335 >= 0f) {
                                        phi_1363_ = (_e335 <= 1f);
                                    } else {
                                        phi_1363_ = false;
                                    }
                                    let _e348 = phi_1363_;
                                    phi_1364_ = _e348;
                                    phi_1365_ = false;
                                } else {
                                    phi_1364_ = bool();
                                    phi_1365_ = true;
                                }
                                let _e350 = phi_1364_;
                                let _e352 = phi_1365_;
                                phi_1366_ = _e350;
                                phi_1367_ = _e352;
                            } else {
                                phi_1366_ = bool();
                                phi_1367_ = true;
                            }
                            let _e354 = phi_1366_;
                            let _e356 = phi_1367_;
                            phi_1368_ = _e354;
                            phi_1369_ = _e356;
                        } else {
                            phi_1368_ = bool();
                            phi_1369_ = true;
                        }
                        let _e358 = phi_1368_;
                        let _e360 = phi_1369_;
                        if _e360 {
                            phi_1373_ = false;
                        } else {
                            phi_1373_ = _e358;
                        }
                        let _e362 = phi_1373_;
                        if _e362 {
                            if (_e308 >= _e243) {
                                if (_e308 <= (1f - _e243)) {
                                    if (_e322 >= _e243) {
                                        phi_1400_ = (_e322 <= (1f - _e243));
                                        phi_1401_ = false;
                                    } else {
                                        phi_1400_ = bool();
                                        phi_1401_ = true;
                                    }
                                    let _e370 = phi_1400_;
                                    let _e372 = phi_1401_;
                                    phi_1402_ = _e370;
                                    phi_1403_ = _e372;
                                } else {
                                    phi_1402_ = bool();
                                    phi_1403_ = true;
                                }
                                let _e374 = phi_1402_;
                                let _e376 = phi_1403_;
                                phi_1404_ = _e374;
                                phi_1405_ = _e376;
                            } else {
                                phi_1404_ = bool();
                                phi_1405_ = true;
                            }
                            let _e378 = phi_1404_;
                            let _e380 = phi_1405_;
                            phi_1406_ = _e378;
                            phi_1407_ = _e380;
                        } else {
                            phi_1406_ = bool();
                            phi_1407_ = true;
                        }
                        let _e382 = phi_1406_;
                        let _e384 = phi_1407_;
                        if _e384 {
                            phi_1411_ = false;
                        } else {
                            phi_1411_ = _e382;
                        }
                        let _e386 = phi_1411_;
                        let _e393 = lt_math_LightPoint(vec2<f32>(_e308, _e268.uv.y), _e268.depth, _e268.is_inside);
                        let _e400 = lt_math_LightPoint(vec2<f32>(_e393.uv.x, _e322), _e393.depth, _e393.is_inside);
                        let _e404 = lt_math_LightPoint(_e400.uv, _e335, _e400.is_inside);
                        let _e408 = lt_math_LightPoint(_e404.uv, _e404.depth, _e386);
                        phi_1420_ = _e408;
                        phi_1421_ = (_e270 + 1u);
                        phi_1422_ = lt_math_LevelPoint(_e270, _e408);
                        phi_1423_ = true;
                    }
                    let _e412 = phi_1420_;
                    let _e414 = phi_1421_;
                    let _e416 = phi_1422_;
                    let _e418 = phi_1423_;
                    phi_1255_ = _e412;
                    phi_1258_ = _e414;
                    phi_1260_ = _e416;
                    phi_1424_ = _e418;
                } else {
                    phi_1255_ = lt_math_LightPoint();
                    phi_1258_ = u32();
                    phi_1260_ = lt_math_LevelPoint();
                    phi_1424_ = false;
                }
                let _e420 = phi_1255_;
                let _e422 = phi_1258_;
                let _e424 = phi_1260_;
                let _e426 = phi_1424_;
                continue;
                continuing {
                    phi_1254_ = _e420;
                    phi_1257_ = _e422;
                    phi_1259_ = _e424;
                    break if !(_e426);
                }
            }
            let _e429 = local_2;
            if _e429.point.is_inside {
                if (0f > 0f) {
                    let _e435 = local_3;
                    if (_e435.level < _e65) {
                    } else {
                        return;
                    }
                    let _e440 = levels.member[(0u + _e435.level)];
                    let _e446 = global[0u];
                    if (_e440.row_w.x == _e446) {
                        let _e449 = global[1u];
                        if (_e440.row_w.y == _e449) {
                            let _e452 = global[2u];
                            phi_1464_ = (_e440.row_w.z == _e452);
                            phi_1465_ = false;
                        } else {
                            phi_1464_ = bool();
                            phi_1465_ = true;
                        }
                        let _e455 = phi_1464_;
                        let _e457 = phi_1465_;
                        phi_1466_ = _e455;
                        phi_1467_ = _e457;
                    } else {
                        phi_1466_ = bool();
                        phi_1467_ = true;
                    }
                    let _e459 = phi_1466_;
                    let _e461 = phi_1467_;
                    if _e461 {
                        phi_1471_ = false;
                    } else {
                        phi_1471_ = _e459;
                    }
                    let _e463 = phi_1471_;
                    if _e463 {
                        let _e465 = samples.member[(0u + _e71.first_primitive)].normal;
                        let _e467 = p.member.map_size;
                        let _e537 = ((abs(((((_e440.row_x.x * _e465.x) + (_e440.row_x.y * _e465.y)) + (_e440.row_x.z * _e465.z)) / (((_e440.row_x.x * _e440.row_x.x) + (_e440.row_x.y * _e440.row_x.y)) + (_e440.row_x.z * _e440.row_x.z)))) + abs(((((_e440.row_y.x * _e465.x) + (_e440.row_y.y * _e465.y)) + (_e440.row_y.z * _e465.z)) / (((_e440.row_y.x * _e440.row_y.x) + (_e440.row_y.y * _e440.row_y.y)) + (_e440.row_y.z * _e440.row_y.z))))) / (abs(((((_e440.row_z.x * _e465.x) + (_e440.row_z.y * _e465.y)) + (_e440.row_z.z * _e465.z)) / (((_e440.row_z.x * _e440.row_z.x) + (_e440.row_z.y * _e440.row_z.y)) + (_e440.row_z.z * _e440.row_z.z)))) * f32(_e467)));
                        if (_e537 < 0.002f) {
                            phi_1553_ = _e537;
                        } else {
                            phi_1553_ = 0.002f;
                        }
                        let _e540 = phi_1553_;
                        phi_1672_ = _e540;
                    } else {
                        let _e542 = p.member.map_size;
                        let _e548 = samples.member[(0u + _e71.first_primitive)].position;
                        let _e559 = ((((_e440.row_w.x * _e548.x) + (_e440.row_w.y * _e548.y)) + (_e440.row_w.z * _e548.z)) + _e440.row_w.w);
                        let _e572 = ((_e440.row_x.x - (_e440.row_w.x * _e429.point.uv.x)) / _e559);
                        let _e573 = ((_e440.row_x.y - (_e440.row_w.y * _e429.point.uv.x)) / _e559);
                        let _e574 = ((_e440.row_x.z - (_e440.row_w.z * _e429.point.uv.x)) / _e559);
                        let _e587 = ((_e440.row_y.x - (_e440.row_w.x * _e429.point.uv.y)) / _e559);
                        let _e588 = ((_e440.row_y.y - (_e440.row_w.y * _e429.point.uv.y)) / _e559);
                        let _e589 = ((_e440.row_y.z - (_e440.row_w.z * _e429.point.uv.y)) / _e559);
                        let _e595 = samples.member[(0u + _e71.first_primitive)].normal;
                        let _e600 = ((_e588 * _e595.z) - (_e595.y * _e589));
                        let _e605 = ((_e589 * _e595.x) - (_e595.z * _e587));
                        let _e610 = ((_e587 * _e595.y) - (_e595.x * _e588));
                        let _e612 = samples.member[(0u + _e71.first_primitive)].normal;
                        let _e617 = ((_e573 * _e612.z) - (_e612.y * _e574));
                        let _e622 = ((_e574 * _e612.x) - (_e612.z * _e572));
                        let _e627 = ((_e572 * _e612.y) - (_e612.x * _e573));
                        let _e654 = ((abs(((((_e440.row_z.x * _e600) + (_e440.row_z.y * _e605)) + (_e440.row_z.z * _e610)) / (((_e572 * _e600) + (_e573 * _e605)) + (_e574 * _e610)))) + abs(((((_e440.row_z.x * _e617) + (_e440.row_z.y * _e622)) + (_e440.row_z.z * _e627)) / (((_e587 * _e617) + (_e588 * _e622)) + (_e589 * _e627))))) / f32(_e542));
                        let _e656 = (16f / f32(_e542));
                        if (_e654 < _e656) {
                            phi_1671_ = _e654;
                        } else {
                            phi_1671_ = _e656;
                        }
                        let _e659 = phi_1671_;
                        phi_1672_ = _e659;
                    }
                    let _e661 = phi_1672_;
                    phi_1675_ = (_e429.point.depth - (0f * _e661));
                } else {
                    phi_1675_ = _e429.point.depth;
                }
                let _e665 = phi_1675_;
                let _e671 = p.member.map_size;
                let _e672 = f32(_e671);
                let _e675 = ((_e429.point.uv.x * _e672) - 0.5f);
                let _e676 = ((_e429.point.uv.y * _e672) - 0.5f);
                if (_e675 > -8388608f) {
                    let _e688 = f32(select(0i, select(select(i32(_e675), i32(-2147483648), (_e675 < bitcast<f32>(3472883712u))), 2147483647i, (_e675 > bitcast<f32>(1325400063u))), (_e675 == _e675)));
                    if (_e688 > _e675) {
                        phi_1704_ = 1f;
                    } else {
                        phi_1704_ = 0f;
                    }
                    let _e691 = phi_1704_;
                    if (_e675 < 8388608f) {
                        phi_1709_ = (_e688 - _e691);
                        phi_1710_ = false;
                    } else {
                        phi_1709_ = f32();
                        phi_1710_ = true;
                    }
                    let _e694 = phi_1709_;
                    let _e696 = phi_1710_;
                    phi_1711_ = _e694;
                    phi_1712_ = _e696;
                } else {
                    phi_1711_ = f32();
                    phi_1712_ = true;
                }
                let _e698 = phi_1711_;
                let _e700 = phi_1712_;
                if _e700 {
                    phi_1716_ = _e675;
                } else {
                    phi_1716_ = _e698;
                }
                let _e702 = phi_1716_;
                if (_e676 > -8388608f) {
                    let _e714 = f32(select(0i, select(select(i32(_e676), i32(-2147483648), (_e676 < bitcast<f32>(3472883712u))), 2147483647i, (_e676 > bitcast<f32>(1325400063u))), (_e676 == _e676)));
                    if (_e714 > _e676) {
                        phi_1736_ = 1f;
                    } else {
                        phi_1736_ = 0f;
                    }
                    let _e717 = phi_1736_;
                    if (_e676 < 8388608f) {
                        phi_1741_ = (_e714 - _e717);
                        phi_1742_ = false;
                    } else {
                        phi_1741_ = f32();
                        phi_1742_ = true;
                    }
                    let _e720 = phi_1741_;
                    let _e722 = phi_1742_;
                    phi_1743_ = _e720;
                    phi_1744_ = _e722;
                } else {
                    phi_1743_ = f32();
                    phi_1744_ = true;
                }
                let _e724 = phi_1743_;
                let _e726 = phi_1744_;
                if _e726 {
                    phi_1748_ = _e676;
                } else {
                    phi_1748_ = _e724;
                }
                let _e728 = phi_1748_;
                let _e729 = (_e675 - _e702);
                let _e730 = (_e676 - _e728);
                let _e739 = select(0i, select(select(i32(_e702), i32(-2147483648), (_e702 < bitcast<f32>(3472883712u))), 2147483647i, (_e702 > bitcast<f32>(1325400063u))), (_e702 == _e702));
                let _e748 = select(0i, select(select(i32(_e728), i32(-2147483648), (_e728 < bitcast<f32>(3472883712u))), 2147483647i, (_e728 > bitcast<f32>(1325400063u))), (_e728 == _e728));
                let _e751 = ((1f - _e729) * (1f - _e730));
                let _e753 = (_e729 * (1f - _e730));
                let _e755 = ((1f - _e729) * _e730);
                let _e756 = (_e729 * _e730);
                let _e758 = p.member.test;
                let _e759 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e758);
                let _e761 = p.member.map_size;
                let _e763 = local_4;
                local_1 = _e759;
                let _e766 = ((_e763.level * _e761) * _e761);
                let _e768 = (bitcast<i32>(_e761) - 1i);
                if (_e739 > 0i) {
                    phi_1799_ = _e739;
                } else {
                    phi_1799_ = 0i;
                }
                let _e771 = phi_1799_;
                if (_e748 > 0i) {
                    phi_1804_ = _e748;
                } else {
                    phi_1804_ = 0i;
                }
                let _e774 = phi_1804_;
                if (_e771 < _e768) {
                    phi_1809_ = _e771;
                } else {
                    phi_1809_ = _e768;
                }
                let _e777 = phi_1809_;
                if (_e774 < _e768) {
                    phi_1814_ = _e774;
                } else {
                    phi_1814_ = _e768;
                }
                let _e780 = phi_1814_;
                let _e781 = bitcast<u32>(_e777);
                let _e783 = (_e739 + 1i);
                let _e784 = (_e748 + 1i);
                if (_e783 > 0i) {
                    phi_1823_ = _e783;
                } else {
                    phi_1823_ = 0i;
                }
                let _e787 = phi_1823_;
                if (_e784 > 0i) {
                    phi_1828_ = _e784;
                } else {
                    phi_1828_ = 0i;
                }
                let _e790 = phi_1828_;
                if (_e787 < _e768) {
                    phi_1833_ = _e787;
                } else {
                    phi_1833_ = _e768;
                }
                let _e793 = phi_1833_;
                if (_e790 < _e768) {
                    phi_1838_ = _e790;
                } else {
                    phi_1838_ = _e768;
                }
                let _e796 = phi_1838_;
                let _e797 = bitcast<u32>(_e793);
                let _e799 = (bitcast<u32>(_e780) * _e761);
                let _e800 = (bitcast<u32>(_e796) * _e761);
                let _e805 = ((_e799 + _e781) + _e766);
                let _e806 = ((_e799 + _e797) + _e766);
                let _e807 = ((_e800 + _e781) + _e766);
                let _e808 = ((_e800 + _e797) + _e766);
                if (_e805 < _e56) {
                } else {
                    return;
                }
                let _e812 = map.member[(0u + _e805)];
                if (_e806 < _e56) {
                } else {
                    return;
                }
                let _e824 = map.member[(0u + _e806)];
                if (_e807 < _e56) {
                } else {
                    return;
                }
                let _e840 = map.member[(0u + _e807)];
                if (_e808 < _e56) {
                } else {
                    return;
                }
                let _e856 = map.member[(0u + _e808)];
                let _e870 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_1), vec4<f32>(((((_e812.x * _e751) + (_e824.x * _e753)) + (_e840.x * _e755)) + (_e856.x * _e756)), ((((_e812.y * _e751) + (_e824.y * _e753)) + (_e840.y * _e755)) + (_e856.y * _e756)), ((((_e812.z * _e751) + (_e824.z * _e753)) + (_e840.z * _e755)) + (_e856.z * _e756)), ((((_e812.w * _e751) + (_e824.w * _e753)) + (_e840.w * _e755)) + (_e856.w * _e756))), _e665);
                let _e872 = p.member.map_size;
                let _e874 = local_5;
                let _e877 = (bitcast<i32>(_e872) - 1i);
                if (_e739 > 0i) {
                    phi_1938_ = _e739;
                } else {
                    phi_1938_ = 0i;
                }
                let _e880 = phi_1938_;
                if (_e748 > 0i) {
                    phi_1943_ = _e748;
                } else {
                    phi_1943_ = 0i;
                }
                let _e883 = phi_1943_;
                if (_e880 < _e877) {
                    phi_1948_ = _e880;
                } else {
                    phi_1948_ = _e877;
                }
                let _e886 = phi_1948_;
                if (_e883 < _e877) {
                    phi_1953_ = _e883;
                } else {
                    phi_1953_ = _e877;
                }
                let _e889 = phi_1953_;
                let _e890 = bitcast<u32>(_e886);
                let _e897 = ((((_e874.level * _e872) + bitcast<u32>(_e889)) * (_e872 / 16u)) + (_e890 / 16u));
                let _e900 = (_e739 + 1i);
                let _e901 = (_e748 + 0i);
                let _e903 = (bitcast<i32>(_e872) - 1i);
                if (_e900 > 0i) {
                    phi_1972_ = _e900;
                } else {
                    phi_1972_ = 0i;
                }
                let _e906 = phi_1972_;
                if (_e901 > 0i) {
                    phi_1977_ = _e901;
                } else {
                    phi_1977_ = 0i;
                }
                let _e909 = phi_1977_;
                if (_e906 < _e903) {
                    phi_1982_ = _e906;
                } else {
                    phi_1982_ = _e903;
                }
                let _e912 = phi_1982_;
                if (_e909 < _e903) {
                    phi_1987_ = _e909;
                } else {
                    phi_1987_ = _e903;
                }
                let _e915 = phi_1987_;
                let _e916 = bitcast<u32>(_e912);
                let _e923 = ((((_e874.level * _e872) + bitcast<u32>(_e915)) * (_e872 / 16u)) + (_e916 / 16u));
                let _e926 = (_e739 + 0i);
                let _e927 = (_e748 + 1i);
                let _e929 = (bitcast<i32>(_e872) - 1i);
                if (_e926 > 0i) {
                    phi_2006_ = _e926;
                } else {
                    phi_2006_ = 0i;
                }
                let _e932 = phi_2006_;
                if (_e927 > 0i) {
                    phi_2011_ = _e927;
                } else {
                    phi_2011_ = 0i;
                }
                let _e935 = phi_2011_;
                if (_e932 < _e929) {
                    phi_2016_ = _e932;
                } else {
                    phi_2016_ = _e929;
                }
                let _e938 = phi_2016_;
                if (_e935 < _e929) {
                    phi_2021_ = _e935;
                } else {
                    phi_2021_ = _e929;
                }
                let _e941 = phi_2021_;
                let _e942 = bitcast<u32>(_e938);
                let _e949 = ((((_e874.level * _e872) + bitcast<u32>(_e941)) * (_e872 / 16u)) + (_e942 / 16u));
                let _e952 = (_e739 + 1i);
                let _e953 = (_e748 + 1i);
                let _e955 = (bitcast<i32>(_e872) - 1i);
                if (_e952 > 0i) {
                    phi_2040_ = _e952;
                } else {
                    phi_2040_ = 0i;
                }
                let _e958 = phi_2040_;
                if (_e953 > 0i) {
                    phi_2045_ = _e953;
                } else {
                    phi_2045_ = 0i;
                }
                let _e961 = phi_2045_;
                if (_e958 < _e955) {
                    phi_2050_ = _e958;
                } else {
                    phi_2050_ = _e955;
                }
                let _e964 = phi_2050_;
                if (_e961 < _e955) {
                    phi_2055_ = _e961;
                } else {
                    phi_2055_ = _e955;
                }
                let _e967 = phi_2055_;
                let _e968 = bitcast<u32>(_e964);
                let _e975 = ((((_e874.level * _e872) + bitcast<u32>(_e967)) * (_e872 / 16u)) + (_e968 / 16u));
                if (_e897 < _e62) {
                } else {
                    return;
                }
                let _e981 = marks.member[(0u + _e897)];
                if (_e923 < _e62) {
                } else {
                    return;
                }
                let _e989 = marks.member[(0u + _e923)];
                if (_e949 < _e62) {
                } else {
                    return;
                }
                let _e998 = marks.member[(0u + _e949)];
                if (_e975 < _e62) {
                } else {
                    return;
                }
                let _e1006 = marks.member[(0u + _e975)];
                let _e1014 = p.member.epsilon;
                if (_e870 <= _e1014) {
                    phi_2133_ = true;
                } else {
                    phi_2133_ = (_e870 >= (1f - _e1014));
                }
                let _e1019 = phi_2133_;
                if ((bitcast<u32>(_e870) & 2147483647u) > 2139095040u) {
                    phi_2141_ = true;
                } else {
                    phi_2141_ = !(_e1019);
                }
                let _e1025 = phi_2141_;
                if _e1025 {
                    if (_e870 > 0f) {
                        if (_e870 < 1f) {
                            phi_2153_ = false;
                        } else {
                            phi_2153_ = true;
                        }
                        let _e1029 = phi_2153_;
                        phi_2154_ = _e1029;
                    } else {
                        phi_2154_ = true;
                    }
                    let _e1031 = phi_2154_;
                    if _e1031 {
                        phi_2158_ = 0.5f;
                    } else {
                        phi_2158_ = _e870;
                    }
                    let _e1033 = phi_2158_;
                    phi_2166_ = evaluate_Verdict(_e1033, true);
                } else {
                    if (_e870 > 0.5f) {
                        phi_2164_ = 1f;
                    } else {
                        phi_2164_ = 0f;
                    }
                    let _e1037 = phi_2164_;
                    phi_2166_ = evaluate_Verdict(_e1037, false);
                }
                let _e1040 = phi_2166_;
                let _e1043 = (_e1040.visibility < 0.5f);
                if _e1040.is_doubted {
                    phi_2189_ = evaluate_Verdict();
                    phi_2190_ = true;
                } else {
                    if _e1043 {
                        phi_2176_ = 2u;
                    } else {
                        phi_2176_ = 1u;
                    }
                    let _e1045 = phi_2176_;
                    if ((((((_e981 >> bitcast<u32>((((_e890 % 16u) * 2u) & 31u))) & 3u) | ((_e989 >> bitcast<u32>((((_e916 % 16u) * 2u) & 31u))) & 3u)) | (((_e998 >> bitcast<u32>((((_e942 % 16u) * 2u) & 31u))) & 3u) | ((_e1006 >> bitcast<u32>((((_e968 % 16u) * 2u) & 31u))) & 3u))) & _e1045) != 0u) {
                        if _e1043 {
                            phi_2185_ = 0.000000059604645f;
                        } else {
                            phi_2185_ = 0.99999994f;
                        }
                        let _e1049 = phi_2185_;
                        phi_2187_ = evaluate_Verdict(_e1049, true);
                        phi_2188_ = false;
                    } else {
                        phi_2187_ = evaluate_Verdict();
                        phi_2188_ = true;
                    }
                    let _e1052 = phi_2187_;
                    let _e1054 = phi_2188_;
                    phi_2189_ = _e1052;
                    phi_2190_ = _e1054;
                }
                let _e1056 = phi_2189_;
                let _e1058 = phi_2190_;
                if _e1058 {
                    phi_2195_ = evaluate_Verdict(_e1040.visibility, _e1040.is_doubted);
                } else {
                    phi_2195_ = _e1056;
                }
                let _e1061 = phi_2195_;
                phi_2200_ = evaluate_Verdict(_e1061.visibility, _e1061.is_doubted);
            } else {
                phi_2200_ = evaluate_Verdict(0.5f, true);
            }
            let _e1067 = phi_2200_;
            phi_2201_ = _e1067;
        }
        let _e1069 = phi_2201_;
        if (_e71.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e71.first_primitive)] = _e1069.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_msm_hausdorff_prefiltered_levels_marks_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
