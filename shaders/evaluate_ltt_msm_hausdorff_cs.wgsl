struct lt_math_LightProjection {
    row_x: vec4<f32>,
    row_y: vec4<f32>,
    row_z: vec4<f32>,
    row_w: vec4<f32>,
}

struct type_8 {
    member: array<u32>,
}

struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_22 {
    member: array<abi_Sample>,
}

struct type_26 {
    member: array<f32>,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
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

struct type_35 {
    member: abi_ShadowParams,
}

struct evaluate_Verdict {
    visibility: f32,
    is_doubted: bool,
}

struct u0028_evaluate_Verdict_u0020_bool_u0029_ {
    unnamed: evaluate_Verdict,
    unnamed_1: bool,
}

struct hankel_HankelFactors {
    moments: vec4<f32>,
    d22_: f32,
    l32_d22_: f32,
    d33_d22_: f32,
}

struct type_45 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_22;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_35;
@group(0) @binding(2) 
var<storage> map: type_26;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_26;
var<private> local_3: u32;
@group(0) @binding(4) 
var<storage, read_write> list: type_45;
var<workgroup> shared_: array<atomic<u32>, 2>;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_156_: lt_bvh_traverse_Tree;
    var phi_157_: bool;
    var phi_158_: lt_bvh_traverse_Tree;
    var phi_159_: bool;
    var phi_164_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_156_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_157_ = false;
        } else {
            phi_156_ = lt_bvh_traverse_Tree();
            phi_157_ = true;
        }
        let _e53 = phi_156_;
        let _e55 = phi_157_;
        phi_158_ = _e53;
        phi_159_ = _e55;
    } else {
        phi_158_ = lt_bvh_traverse_Tree();
        phi_159_ = true;
    }
    let _e57 = phi_158_;
    let _e59 = phi_159_;
    if _e59 {
        phi_164_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_164_ = _e57;
    }
    let _e64 = phi_164_;
    return lt_bvh_traverse_Tree(_e64.root, _e64.first_primitive);
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_4: f32) -> vec4<f32> {
    var phi_187_: f32;
    var phi_188_: f32;
    var phi_189_: f32;

    if ((bitcast<u32>(param_4) & 2147483647u) > 2139095040u) {
        phi_189_ = param_4;
    } else {
        if (param_4 < 0f) {
            phi_188_ = 0f;
        } else {
            if (param_4 > 1f) {
                phi_187_ = 1f;
            } else {
                phi_187_ = param_4;
            }
            let _e47 = phi_187_;
            phi_188_ = _e47;
        }
        let _e49 = phi_188_;
        phi_189_ = _e49;
    }
    let _e51 = phi_189_;
    let _e52 = (_e51 * _e51);
    return vec4<f32>(_e51, _e52, (_e52 * _e51), (_e52 * _e52));
}

fn lt_math_hausdorff_cubic_mass(param_5: vec4<f32>, param_6: f32, param_7: f32, param_8: f32, param_9: f32) -> f32 {
    return ((((param_5.z - (((param_7 + param_8) + param_9) * param_5.y)) + ((((param_7 * param_8) + (param_7 * param_9)) + (param_8 * param_9)) * param_5.x)) - ((param_7 * param_8) * param_9)) / (((param_6 - param_7) * (param_6 - param_8)) * (param_6 - param_9)));
}

fn lt_math_hausdorff_endpoint_upper_bound(param_10: ptr<function, hankel_HankelFactors>, param_11: f32) -> f32 {
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

    let _e43 = (*param_10).moments;
    if (param_11 < 0.0001f) {
        phi_1036_ = 1f;
    } else {
        let _e52 = ((_e43.z - ((1f + param_11) * _e43.y)) + (param_11 * _e43.x));
        let _e61 = (((_e43.w - ((1f + param_11) * _e43.z)) + (param_11 * _e43.y)) / _e52);
        if (abs(_e52) <= 0.00000047683716f) {
            let _e75 = (1f - (((_e43.y - (_e43.x * (param_11 + 1f))) + (param_11 * 1f)) / ((0f - param_11) * (0f - 1f))));
            if ((bitcast<u32>(_e75) & 2147483647u) > 2139095040u) {
                phi_959_ = _e75;
            } else {
                if (_e75 < 0f) {
                    phi_958_ = 0f;
                } else {
                    if (_e75 > 1f) {
                        phi_957_ = 1f;
                    } else {
                        phi_957_ = _e75;
                    }
                    let _e82 = phi_957_;
                    phi_958_ = _e82;
                }
                let _e84 = phi_958_;
                phi_959_ = _e84;
            }
            let _e86 = phi_959_;
            phi_1035_ = _e86;
        } else {
            if (_e61 > 0f) {
                if (_e61 < param_11) {
                    let _e89 = lt_math_hausdorff_cubic_mass(_e43, 0f, _e61, param_11, 1f);
                    let _e91 = lt_math_hausdorff_cubic_mass(_e43, _e61, 0f, param_11, 1f);
                    let _e92 = ((1f - _e89) - _e91);
                    if ((bitcast<u32>(_e92) & 2147483647u) > 2139095040u) {
                        phi_988_ = _e92;
                    } else {
                        if (_e92 < 0f) {
                            phi_987_ = 0f;
                        } else {
                            if (_e92 > 1f) {
                                phi_986_ = 1f;
                            } else {
                                phi_986_ = _e92;
                            }
                            let _e99 = phi_986_;
                            phi_987_ = _e99;
                        }
                        let _e101 = phi_987_;
                        phi_988_ = _e101;
                    }
                    let _e103 = phi_988_;
                    phi_989_ = _e103;
                    phi_990_ = false;
                } else {
                    phi_989_ = f32();
                    phi_990_ = true;
                }
                let _e105 = phi_989_;
                let _e107 = phi_990_;
                phi_991_ = _e105;
                phi_992_ = _e107;
            } else {
                phi_991_ = f32();
                phi_992_ = true;
            }
            let _e109 = phi_991_;
            let _e111 = phi_992_;
            if _e111 {
                if (_e61 > param_11) {
                    if (_e61 < 1f) {
                        let _e114 = lt_math_hausdorff_cubic_mass(_e43, 0f, _e61, param_11, 1f);
                        let _e115 = (1f - _e114);
                        if ((bitcast<u32>(_e115) & 2147483647u) > 2139095040u) {
                            phi_1022_ = _e115;
                        } else {
                            if (_e115 < 0f) {
                                phi_1021_ = 0f;
                            } else {
                                if (_e115 > 1f) {
                                    phi_1020_ = 1f;
                                } else {
                                    phi_1020_ = _e115;
                                }
                                let _e122 = phi_1020_;
                                phi_1021_ = _e122;
                            }
                            let _e124 = phi_1021_;
                            phi_1022_ = _e124;
                        }
                        let _e126 = phi_1022_;
                        phi_1023_ = _e126;
                        phi_1024_ = false;
                    } else {
                        phi_1023_ = f32();
                        phi_1024_ = true;
                    }
                    let _e128 = phi_1023_;
                    let _e130 = phi_1024_;
                    phi_1025_ = _e128;
                    phi_1026_ = _e130;
                } else {
                    phi_1025_ = f32();
                    phi_1026_ = true;
                }
                let _e132 = phi_1025_;
                let _e134 = phi_1026_;
                if _e134 {
                    phi_1033_ = bitcast<f32>((bitcast<u32>(_e61) | 2143289344u));
                } else {
                    phi_1033_ = _e132;
                }
                let _e139 = phi_1033_;
                phi_1034_ = _e139;
            } else {
                phi_1034_ = _e109;
            }
            let _e141 = phi_1034_;
            phi_1035_ = _e141;
        }
        let _e143 = phi_1035_;
        phi_1036_ = _e143;
    }
    let _e145 = phi_1036_;
    return _e145;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_12: ptr<function, f32>, param_13: vec4<f32>, param_14: f32) -> f32 {
    var local_1: hankel_HankelFactors;
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

    let _e44 = (*param_12);
    let _e45 = (1f - _e44);
    let _e54 = (0.5f * _e44);
    let _e55 = ((param_13.x * _e45) + _e54);
    let _e56 = ((param_13.y * _e45) + _e54);
    let _e57 = ((param_13.z * _e45) + _e54);
    let _e58 = ((param_13.w * _e45) + _e54);
    let _e61 = (_e56 - (_e55 * _e55));
    let _e63 = (_e57 - (_e55 * _e56));
    let _e69 = hankel_HankelFactors(vec4<f32>(_e55, _e56, _e57, _e58), _e61, _e63, (((_e58 - (_e56 * _e56)) * _e61) - (_e63 * _e63)));
    local_1 = hankel_HankelFactors(_e69.moments, _e69.d22_, _e69.l32_d22_, _e69.d33_d22_);
    if ((bitcast<u32>(param_14) & 2147483647u) > 2139095040u) {
        phi_246_ = param_14;
    } else {
        if (param_14 < 0f) {
            phi_245_ = 0f;
        } else {
            if (param_14 > 1f) {
                phi_244_ = 1f;
            } else {
                phi_244_ = param_14;
            }
            let _e81 = phi_244_;
            phi_245_ = _e81;
        }
        let _e83 = phi_245_;
        phi_246_ = _e83;
    }
    let _e85 = phi_246_;
    let _e88 = local_1.moments[0u];
    let _e91 = local_1.moments[3u];
    if (_e88 == _e91) {
        let _e95 = local_1.moments[0u];
        phi_258_ = (_e95 > 0.5f);
    } else {
        phi_258_ = false;
    }
    let _e98 = phi_258_;
    if _e98 {
        let _e101 = local_1.moments[0u];
        let _e104 = local_1.moments[3u];
        if (_e101 == _e104) {
            let _e108 = local_1.moments[0u];
            phi_273_ = (_e108 > 0.5f);
        } else {
            phi_273_ = false;
        }
        let _e111 = phi_273_;
        if _e111 {
            if (_e85 > 0f) {
                let _e114 = local_1.moments;
                if ((bitcast<u32>(_e114.x) & 2147483647u) > 2139095040u) {
                    phi_300_ = _e114.x;
                } else {
                    if (_e114.x < 0f) {
                        phi_299_ = 0f;
                    } else {
                        if (_e114.x > 1f) {
                            phi_298_ = 1f;
                        } else {
                            phi_298_ = _e114.x;
                        }
                        let _e122 = phi_298_;
                        phi_299_ = _e122;
                    }
                    let _e124 = phi_299_;
                    phi_300_ = _e124;
                }
                let _e126 = phi_300_;
                phi_301_ = _e126;
                phi_302_ = false;
            } else {
                phi_301_ = f32();
                phi_302_ = true;
            }
            let _e128 = phi_301_;
            let _e130 = phi_302_;
            phi_303_ = _e128;
            phi_304_ = _e130;
        } else {
            phi_303_ = f32();
            phi_304_ = true;
        }
        let _e132 = phi_303_;
        let _e134 = phi_304_;
        if _e134 {
            let _e137 = local_1.moments[0u];
            let _e140 = local_1.moments[1u];
            let _e148 = local_1.l32_d22_;
            let _e150 = local_1.d22_;
            let _e151 = (_e148 / _e150);
            let _e152 = (_e85 - _e137);
            let _e158 = local_1.d22_;
            let _e161 = local_1.d33_d22_;
            let _e162 = (((((_e85 * _e85) - _e140) - (_e151 * _e152)) * _e158) / _e161);
            let _e164 = local_1.d22_;
            let _e167 = ((_e152 / _e164) - (_e151 * _e162));
            let _e173 = ((0.5f * _e167) / _e162);
            let _e176 = ((_e173 * _e173) - (((1f - (_e167 * _e137)) - (_e162 * _e140)) / _e162));
            if (_e176 >= 0f) {
                let _e178 = sqrt(_e176);
                phi_360_ = vec2<f32>((-(_e173) - _e178), (-(_e173) + _e178));
            } else {
                phi_360_ = vec2(bitcast<f32>((bitcast<u32>(_e176) | 2143289344u)));
            }
            let _e189 = phi_360_;
            if (_e85 <= _e189.x) {
                phi_441_ = 1f;
            } else {
                if (_e85 > _e189.y) {
                    let _e195 = local_1.moments;
                    let _e206 = (((_e195.y - (_e195.x * (_e189.x + _e189.y))) + (_e189.x * _e189.y)) / ((_e85 - _e189.x) * (_e85 - _e189.y)));
                    if ((bitcast<u32>(_e206) & 2147483647u) > 2139095040u) {
                        phi_400_ = _e206;
                    } else {
                        if (_e206 < 0f) {
                            phi_399_ = 0f;
                        } else {
                            if (_e206 > 1f) {
                                phi_398_ = 1f;
                            } else {
                                phi_398_ = _e206;
                            }
                            let _e213 = phi_398_;
                            phi_399_ = _e213;
                        }
                        let _e215 = phi_399_;
                        phi_400_ = _e215;
                    }
                    let _e217 = phi_400_;
                    phi_440_ = _e217;
                } else {
                    if (_e85 > _e189.x) {
                        let _e220 = local_1.moments;
                        let _e232 = (1f - (((_e220.y - (_e220.x * (_e85 + _e189.y))) + (_e85 * _e189.y)) / ((_e189.x - _e85) * (_e189.x - _e189.y))));
                        if ((bitcast<u32>(_e232) & 2147483647u) > 2139095040u) {
                            phi_435_ = _e232;
                        } else {
                            if (_e232 < 0f) {
                                phi_434_ = 0f;
                            } else {
                                if (_e232 > 1f) {
                                    phi_433_ = 1f;
                                } else {
                                    phi_433_ = _e232;
                                }
                                let _e239 = phi_433_;
                                phi_434_ = _e239;
                            }
                            let _e241 = phi_434_;
                            phi_435_ = _e241;
                        }
                        let _e243 = phi_435_;
                        phi_439_ = _e243;
                    } else {
                        phi_439_ = bitcast<f32>((bitcast<u32>(_e189.x) | 2143289344u));
                    }
                    let _e248 = phi_439_;
                    phi_440_ = _e248;
                }
                let _e250 = phi_440_;
                phi_441_ = _e250;
            }
            let _e252 = phi_441_;
            phi_442_ = _e252;
        } else {
            phi_442_ = _e132;
        }
        let _e254 = phi_442_;
        phi_899_ = _e254;
    } else {
        let _e257 = local_1.moments[0u];
        let _e260 = local_1.moments[1u];
        let _e268 = local_1.l32_d22_;
        let _e270 = local_1.d22_;
        let _e271 = (_e268 / _e270);
        let _e272 = (_e85 - _e257);
        let _e278 = local_1.d22_;
        let _e281 = local_1.d33_d22_;
        let _e282 = (((((_e85 * _e85) - _e260) - (_e271 * _e272)) * _e278) / _e281);
        let _e284 = local_1.d22_;
        let _e287 = ((_e272 / _e284) - (_e271 * _e282));
        let _e293 = ((0.5f * _e287) / _e282);
        let _e296 = ((_e293 * _e293) - (((1f - (_e287 * _e257)) - (_e282 * _e260)) / _e282));
        if (_e296 >= 0f) {
            let _e298 = sqrt(_e296);
            phi_495_ = vec2<f32>((-(_e293) - _e298), (-(_e293) + _e298));
        } else {
            phi_495_ = vec2(bitcast<f32>((bitcast<u32>(_e296) | 2143289344u)));
        }
        let _e309 = phi_495_;
        if (_e309.x >= 0f) {
            if (_e309.y <= 1f) {
                let _e316 = local_1.moments[0u];
                let _e319 = local_1.moments[3u];
                if (_e316 == _e319) {
                    let _e323 = local_1.moments[0u];
                    phi_517_ = (_e323 > 0.5f);
                } else {
                    phi_517_ = false;
                }
                let _e326 = phi_517_;
                if _e326 {
                    if (_e85 > 0f) {
                        let _e329 = local_1.moments;
                        if ((bitcast<u32>(_e329.x) & 2147483647u) > 2139095040u) {
                            phi_544_ = _e329.x;
                        } else {
                            if (_e329.x < 0f) {
                                phi_543_ = 0f;
                            } else {
                                if (_e329.x > 1f) {
                                    phi_542_ = 1f;
                                } else {
                                    phi_542_ = _e329.x;
                                }
                                let _e337 = phi_542_;
                                phi_543_ = _e337;
                            }
                            let _e339 = phi_543_;
                            phi_544_ = _e339;
                        }
                        let _e341 = phi_544_;
                        phi_545_ = _e341;
                        phi_546_ = false;
                    } else {
                        phi_545_ = f32();
                        phi_546_ = true;
                    }
                    let _e343 = phi_545_;
                    let _e345 = phi_546_;
                    phi_547_ = _e343;
                    phi_548_ = _e345;
                } else {
                    phi_547_ = f32();
                    phi_548_ = true;
                }
                let _e347 = phi_547_;
                let _e349 = phi_548_;
                if _e349 {
                    let _e352 = local_1.moments[0u];
                    let _e355 = local_1.moments[1u];
                    let _e363 = local_1.l32_d22_;
                    let _e365 = local_1.d22_;
                    let _e366 = (_e363 / _e365);
                    let _e367 = (_e85 - _e352);
                    let _e373 = local_1.d22_;
                    let _e376 = local_1.d33_d22_;
                    let _e377 = (((((_e85 * _e85) - _e355) - (_e366 * _e367)) * _e373) / _e376);
                    let _e379 = local_1.d22_;
                    let _e382 = ((_e367 / _e379) - (_e366 * _e377));
                    let _e388 = ((0.5f * _e382) / _e377);
                    let _e391 = ((_e388 * _e388) - (((1f - (_e382 * _e352)) - (_e377 * _e355)) / _e377));
                    if (_e391 >= 0f) {
                        let _e393 = sqrt(_e391);
                        phi_604_ = vec2<f32>((-(_e388) - _e393), (-(_e388) + _e393));
                    } else {
                        phi_604_ = vec2(bitcast<f32>((bitcast<u32>(_e391) | 2143289344u)));
                    }
                    let _e404 = phi_604_;
                    if (_e85 <= _e404.x) {
                        phi_685_ = 1f;
                    } else {
                        if (_e85 > _e404.y) {
                            let _e410 = local_1.moments;
                            let _e421 = (((_e410.y - (_e410.x * (_e404.x + _e404.y))) + (_e404.x * _e404.y)) / ((_e85 - _e404.x) * (_e85 - _e404.y)));
                            if ((bitcast<u32>(_e421) & 2147483647u) > 2139095040u) {
                                phi_644_ = _e421;
                            } else {
                                if (_e421 < 0f) {
                                    phi_643_ = 0f;
                                } else {
                                    if (_e421 > 1f) {
                                        phi_642_ = 1f;
                                    } else {
                                        phi_642_ = _e421;
                                    }
                                    let _e428 = phi_642_;
                                    phi_643_ = _e428;
                                }
                                let _e430 = phi_643_;
                                phi_644_ = _e430;
                            }
                            let _e432 = phi_644_;
                            phi_684_ = _e432;
                        } else {
                            if (_e85 > _e404.x) {
                                let _e435 = local_1.moments;
                                let _e447 = (1f - (((_e435.y - (_e435.x * (_e85 + _e404.y))) + (_e85 * _e404.y)) / ((_e404.x - _e85) * (_e404.x - _e404.y))));
                                if ((bitcast<u32>(_e447) & 2147483647u) > 2139095040u) {
                                    phi_679_ = _e447;
                                } else {
                                    if (_e447 < 0f) {
                                        phi_678_ = 0f;
                                    } else {
                                        if (_e447 > 1f) {
                                            phi_677_ = 1f;
                                        } else {
                                            phi_677_ = _e447;
                                        }
                                        let _e454 = phi_677_;
                                        phi_678_ = _e454;
                                    }
                                    let _e456 = phi_678_;
                                    phi_679_ = _e456;
                                }
                                let _e458 = phi_679_;
                                phi_683_ = _e458;
                            } else {
                                phi_683_ = bitcast<f32>((bitcast<u32>(_e404.x) | 2143289344u));
                            }
                            let _e463 = phi_683_;
                            phi_684_ = _e463;
                        }
                        let _e465 = phi_684_;
                        phi_685_ = _e465;
                    }
                    let _e467 = phi_685_;
                    phi_686_ = _e467;
                } else {
                    phi_686_ = _e347;
                }
                let _e469 = phi_686_;
                phi_687_ = _e469;
                phi_688_ = false;
            } else {
                phi_687_ = f32();
                phi_688_ = true;
            }
            let _e471 = phi_687_;
            let _e473 = phi_688_;
            phi_689_ = _e471;
            phi_690_ = _e473;
        } else {
            phi_689_ = f32();
            phi_690_ = true;
        }
        let _e475 = phi_689_;
        let _e477 = phi_690_;
        if _e477 {
            if ((bitcast<u32>(_e309.x) & 2147483647u) > 2139095040u) {
                phi_897_ = _e309.x;
            } else {
                let _e481 = lt_math_hausdorff_endpoint_upper_bound((&local_1), _e85);
                let _e484 = local_1.moments[0u];
                let _e487 = local_1.moments[3u];
                if (_e484 == _e487) {
                    let _e491 = local_1.moments[0u];
                    phi_712_ = (_e491 > 0.5f);
                } else {
                    phi_712_ = false;
                }
                let _e494 = phi_712_;
                if _e494 {
                    if (_e85 > 0f) {
                        let _e497 = local_1.moments;
                        if ((bitcast<u32>(_e497.x) & 2147483647u) > 2139095040u) {
                            phi_739_ = _e497.x;
                        } else {
                            if (_e497.x < 0f) {
                                phi_738_ = 0f;
                            } else {
                                if (_e497.x > 1f) {
                                    phi_737_ = 1f;
                                } else {
                                    phi_737_ = _e497.x;
                                }
                                let _e505 = phi_737_;
                                phi_738_ = _e505;
                            }
                            let _e507 = phi_738_;
                            phi_739_ = _e507;
                        }
                        let _e509 = phi_739_;
                        phi_740_ = _e509;
                        phi_741_ = false;
                    } else {
                        phi_740_ = f32();
                        phi_741_ = true;
                    }
                    let _e511 = phi_740_;
                    let _e513 = phi_741_;
                    phi_742_ = _e511;
                    phi_743_ = _e513;
                } else {
                    phi_742_ = f32();
                    phi_743_ = true;
                }
                let _e515 = phi_742_;
                let _e517 = phi_743_;
                if _e517 {
                    let _e520 = local_1.moments[0u];
                    let _e523 = local_1.moments[1u];
                    let _e531 = local_1.l32_d22_;
                    let _e533 = local_1.d22_;
                    let _e534 = (_e531 / _e533);
                    let _e535 = (_e85 - _e520);
                    let _e541 = local_1.d22_;
                    let _e544 = local_1.d33_d22_;
                    let _e545 = (((((_e85 * _e85) - _e523) - (_e534 * _e535)) * _e541) / _e544);
                    let _e547 = local_1.d22_;
                    let _e550 = ((_e535 / _e547) - (_e534 * _e545));
                    let _e556 = ((0.5f * _e550) / _e545);
                    let _e559 = ((_e556 * _e556) - (((1f - (_e550 * _e520)) - (_e545 * _e523)) / _e545));
                    if (_e559 >= 0f) {
                        let _e561 = sqrt(_e559);
                        phi_799_ = vec2<f32>((-(_e556) - _e561), (-(_e556) + _e561));
                    } else {
                        phi_799_ = vec2(bitcast<f32>((bitcast<u32>(_e559) | 2143289344u)));
                    }
                    let _e572 = phi_799_;
                    if (_e85 <= _e572.x) {
                        phi_880_ = 1f;
                    } else {
                        if (_e85 > _e572.y) {
                            let _e578 = local_1.moments;
                            let _e589 = (((_e578.y - (_e578.x * (_e572.x + _e572.y))) + (_e572.x * _e572.y)) / ((_e85 - _e572.x) * (_e85 - _e572.y)));
                            if ((bitcast<u32>(_e589) & 2147483647u) > 2139095040u) {
                                phi_839_ = _e589;
                            } else {
                                if (_e589 < 0f) {
                                    phi_838_ = 0f;
                                } else {
                                    if (_e589 > 1f) {
                                        phi_837_ = 1f;
                                    } else {
                                        phi_837_ = _e589;
                                    }
                                    let _e596 = phi_837_;
                                    phi_838_ = _e596;
                                }
                                let _e598 = phi_838_;
                                phi_839_ = _e598;
                            }
                            let _e600 = phi_839_;
                            phi_879_ = _e600;
                        } else {
                            if (_e85 > _e572.x) {
                                let _e603 = local_1.moments;
                                let _e615 = (1f - (((_e603.y - (_e603.x * (_e85 + _e572.y))) + (_e85 * _e572.y)) / ((_e572.x - _e85) * (_e572.x - _e572.y))));
                                if ((bitcast<u32>(_e615) & 2147483647u) > 2139095040u) {
                                    phi_874_ = _e615;
                                } else {
                                    if (_e615 < 0f) {
                                        phi_873_ = 0f;
                                    } else {
                                        if (_e615 > 1f) {
                                            phi_872_ = 1f;
                                        } else {
                                            phi_872_ = _e615;
                                        }
                                        let _e622 = phi_872_;
                                        phi_873_ = _e622;
                                    }
                                    let _e624 = phi_873_;
                                    phi_874_ = _e624;
                                }
                                let _e626 = phi_874_;
                                phi_878_ = _e626;
                            } else {
                                phi_878_ = bitcast<f32>((bitcast<u32>(_e572.x) | 2143289344u));
                            }
                            let _e631 = phi_878_;
                            phi_879_ = _e631;
                        }
                        let _e633 = phi_879_;
                        phi_880_ = _e633;
                    }
                    let _e635 = phi_880_;
                    phi_881_ = _e635;
                } else {
                    phi_881_ = _e515;
                }
                let _e637 = phi_881_;
                if ((bitcast<u32>(_e637) & 2147483647u) > 2139095040u) {
                    phi_892_ = true;
                } else {
                    let _e641 = (_e637 < _e481);
                    if _e641 {
                    }
                    phi_892_ = _e641;
                }
                let _e643 = phi_892_;
                if _e643 {
                    phi_896_ = _e637;
                } else {
                    phi_896_ = _e481;
                }
                let _e645 = phi_896_;
                phi_897_ = _e645;
            }
            let _e647 = phi_897_;
            phi_898_ = _e647;
        } else {
            phi_898_ = _e475;
        }
        let _e649 = phi_898_;
        phi_899_ = _e649;
    }
    let _e651 = phi_899_;
    return _e651;
}

fn function_() {
    var local_2: f32;
    var phi_1119_: bool;
    var phi_1120_: bool;
    var phi_1121_: bool;
    var phi_1122_: bool;
    var phi_1126_: bool;
    var phi_1170_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1174_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1251_: bool;
    var phi_1260_: bool;
    var phi_1269_: bool;
    var phi_1270_: bool;
    var phi_1271_: bool;
    var phi_1272_: bool;
    var phi_1273_: bool;
    var phi_1274_: bool;
    var phi_1275_: bool;
    var phi_1279_: bool;
    var phi_1373_: f32;
    var phi_1376_: f32;
    var phi_1405_: f32;
    var phi_1410_: f32;
    var phi_1411_: bool;
    var phi_1412_: f32;
    var phi_1413_: bool;
    var phi_1417_: f32;
    var phi_1437_: f32;
    var phi_1442_: f32;
    var phi_1443_: bool;
    var phi_1444_: f32;
    var phi_1445_: bool;
    var phi_1449_: f32;
    var phi_1495_: i32;
    var phi_1500_: i32;
    var phi_1505_: i32;
    var phi_1510_: i32;
    var phi_1519_: i32;
    var phi_1524_: i32;
    var phi_1529_: i32;
    var phi_1534_: i32;
    var phi_1629_: bool;
    var phi_1637_: bool;
    var phi_1642_: f32;
    var phi_1645_: evaluate_Verdict;
    var phi_1646_: evaluate_Verdict;
    var phi_1650_: bool;
    var phi_1651_: u32;
    var phi_1657_: u32;

    let _e41 = id_1;
    let _e42 = local_3;
    let _e47 = arrayLength((&map.member));
    if (_e42 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    let _e54 = p.member.size[0u];
    let _e56 = p.member.size[1u];
    let _e57 = lt_shaders_entry_pixel_index(_e41, _e54, _e56);
    if (bitcast<i32>(_e57.root) != 0i) {
        let _e64 = p.member.light;
        let _e67 = samples.member[_e57.first_primitive].normal[0u];
        let _e69 = global[0u];
        if (_e67 == _e69) {
            let _e72 = samples.member[_e57.first_primitive].normal[1u];
            let _e74 = global[1u];
            if (_e72 == _e74) {
                let _e77 = samples.member[_e57.first_primitive].normal[2u];
                let _e79 = global[2u];
                phi_1119_ = (_e77 == _e79);
                phi_1120_ = false;
            } else {
                phi_1119_ = bool();
                phi_1120_ = true;
            }
            let _e82 = phi_1119_;
            let _e84 = phi_1120_;
            phi_1121_ = _e82;
            phi_1122_ = _e84;
        } else {
            phi_1121_ = bool();
            phi_1122_ = true;
        }
        let _e86 = phi_1121_;
        let _e88 = phi_1122_;
        if _e88 {
            phi_1126_ = false;
        } else {
            phi_1126_ = _e86;
        }
        let _e90 = phi_1126_;
        if !(_e90) {
            let _e93 = samples.member[_e57.first_primitive].normal;
            let _e95 = samples.member[_e57.first_primitive].position;
            if ((((_e93.x * (_e64.x - (_e95.x * _e64.w))) + (_e93.y * (_e64.y - (_e95.y * _e64.w)))) + (_e93.z * (_e64.z - (_e95.z * _e64.w)))) > 0f) {
                let _e119 = samples.member[_e57.first_primitive].flags;
                let _e127 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e133 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e127.unnamed.visibility, false), _e127.unnamed_1);
                phi_1170_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e133.unnamed, ((_e119 & 1u) == 0u));
            } else {
                let _e142 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e148 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e142.unnamed.visibility, false), _e142.unnamed_1);
                phi_1170_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e148.unnamed, true);
            }
            let _e153 = phi_1170_;
            phi_1174_ = _e153;
        } else {
            let _e159 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e165 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e159.unnamed.visibility, false), _e159.unnamed_1);
            phi_1174_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e165.unnamed, true);
        }
        let _e170 = phi_1174_;
        if _e170.unnamed_1 {
            phi_1646_ = evaluate_Verdict(_e170.unnamed.visibility, _e170.unnamed.is_doubted);
        } else {
            let _e178 = samples.member[_e57.first_primitive].position;
            let _e184 = p.member.projection.row_w;
            let _e195 = ((((_e184.x * _e178.x) + (_e184.y * _e178.y)) + (_e184.z * _e178.z)) + (_e184.w * 1f));
            let _e197 = p.member.projection.row_x;
            let _e209 = (((((_e197.x * _e178.x) + (_e197.y * _e178.y)) + (_e197.z * _e178.z)) + (_e197.w * 1f)) / _e195);
            let _e211 = p.member.projection.row_y;
            let _e223 = (((((_e211.x * _e178.x) + (_e211.y * _e178.y)) + (_e211.z * _e178.z)) + (_e211.w * 1f)) / _e195);
            let _e225 = p.member.projection.row_z;
            let _e236 = ((((_e225.x * _e178.x) + (_e225.y * _e178.y)) + (_e225.z * _e178.z)) + (_e225.w * 1f));
            if (_e195 > 0f) {
                if (_e209 >= 0f) {
                    phi_1251_ = (_e209 <= 1f);
                } else {
                    phi_1251_ = false;
                }
                let _e241 = phi_1251_;
                if _e241 {
                    if (_e223 >= 0f) {
                        phi_1260_ = (_e223 <= 1f);
                    } else {
                        phi_1260_ = false;
                    }
                    let _e245 = phi_1260_;
                    if _e245 {
                        if (_e236 >= 0f) {
                            phi_1269_ = (_e236 <= 1f);
                        } else {
                            phi_1269_ = false;
                        }
                        let _e249 = phi_1269_;
                        phi_1270_ = _e249;
                        phi_1271_ = false;
                    } else {
                        phi_1270_ = bool();
                        phi_1271_ = true;
                    }
                    let _e251 = phi_1270_;
                    let _e253 = phi_1271_;
                    phi_1272_ = _e251;
                    phi_1273_ = _e253;
                } else {
                    phi_1272_ = bool();
                    phi_1273_ = true;
                }
                let _e255 = phi_1272_;
                let _e257 = phi_1273_;
                phi_1274_ = _e255;
                phi_1275_ = _e257;
            } else {
                phi_1274_ = bool();
                phi_1275_ = true;
            }
            let _e259 = phi_1274_;
            let _e261 = phi_1275_;
            if _e261 {
                phi_1279_ = false;
            } else {
                phi_1279_ = _e259;
            }
            let _e263 = phi_1279_;
            if _e263 {
                if (0f > 0f) {
                    let _e266 = samples.member[_e57.first_primitive].normal;
                    let _e268 = p.member.map_size;
                    let _e271 = p.member.projection.row_x;
                    let _e293 = p.member.projection.row_y;
                    let _e315 = p.member.projection.row_z;
                    let _e342 = ((abs(((((_e271.x * _e266.x) + (_e271.y * _e266.y)) + (_e271.z * _e266.z)) / (((_e271.x * _e271.x) + (_e271.y * _e271.y)) + (_e271.z * _e271.z)))) + abs(((((_e293.x * _e266.x) + (_e293.y * _e266.y)) + (_e293.z * _e266.z)) / (((_e293.x * _e293.x) + (_e293.y * _e293.y)) + (_e293.z * _e293.z))))) / (abs(((((_e315.x * _e266.x) + (_e315.y * _e266.y)) + (_e315.z * _e266.z)) / (((_e315.x * _e315.x) + (_e315.y * _e315.y)) + (_e315.z * _e315.z)))) * f32(_e268)));
                    if (_e342 < 0.002f) {
                        phi_1373_ = _e342;
                    } else {
                        phi_1373_ = 0.002f;
                    }
                    let _e345 = phi_1373_;
                    phi_1376_ = (_e236 - (0f * _e345));
                } else {
                    phi_1376_ = _e236;
                }
                let _e349 = phi_1376_;
                let _e351 = p.member.map_size;
                let _e352 = f32(_e351);
                let _e355 = ((_e209 * _e352) - 0.5f);
                let _e356 = ((_e223 * _e352) - 0.5f);
                if (_e355 > -8388608f) {
                    let _e368 = f32(select(0i, select(select(i32(_e355), i32(-2147483648), (_e355 < bitcast<f32>(3472883712u))), 2147483647i, (_e355 > bitcast<f32>(1325400063u))), (_e355 == _e355)));
                    if (_e368 > _e355) {
                        phi_1405_ = 1f;
                    } else {
                        phi_1405_ = 0f;
                    }
                    let _e371 = phi_1405_;
                    if (_e355 < 8388608f) {
                        phi_1410_ = (_e368 - _e371);
                        phi_1411_ = false;
                    } else {
                        phi_1410_ = f32();
                        phi_1411_ = true;
                    }
                    let _e374 = phi_1410_;
                    let _e376 = phi_1411_;
                    phi_1412_ = _e374;
                    phi_1413_ = _e376;
                } else {
                    phi_1412_ = f32();
                    phi_1413_ = true;
                }
                let _e378 = phi_1412_;
                let _e380 = phi_1413_;
                if _e380 {
                    phi_1417_ = _e355;
                } else {
                    phi_1417_ = _e378;
                }
                let _e382 = phi_1417_;
                if (_e356 > -8388608f) {
                    let _e394 = f32(select(0i, select(select(i32(_e356), i32(-2147483648), (_e356 < bitcast<f32>(3472883712u))), 2147483647i, (_e356 > bitcast<f32>(1325400063u))), (_e356 == _e356)));
                    if (_e394 > _e356) {
                        phi_1437_ = 1f;
                    } else {
                        phi_1437_ = 0f;
                    }
                    let _e397 = phi_1437_;
                    if (_e356 < 8388608f) {
                        phi_1442_ = (_e394 - _e397);
                        phi_1443_ = false;
                    } else {
                        phi_1442_ = f32();
                        phi_1443_ = true;
                    }
                    let _e400 = phi_1442_;
                    let _e402 = phi_1443_;
                    phi_1444_ = _e400;
                    phi_1445_ = _e402;
                } else {
                    phi_1444_ = f32();
                    phi_1445_ = true;
                }
                let _e404 = phi_1444_;
                let _e406 = phi_1445_;
                if _e406 {
                    phi_1449_ = _e356;
                } else {
                    phi_1449_ = _e404;
                }
                let _e408 = phi_1449_;
                let _e409 = (_e355 - _e382);
                let _e410 = (_e356 - _e408);
                let _e419 = select(0i, select(select(i32(_e382), i32(-2147483648), (_e382 < bitcast<f32>(3472883712u))), 2147483647i, (_e382 > bitcast<f32>(1325400063u))), (_e382 == _e382));
                let _e428 = select(0i, select(select(i32(_e408), i32(-2147483648), (_e408 < bitcast<f32>(3472883712u))), 2147483647i, (_e408 > bitcast<f32>(1325400063u))), (_e408 == _e408));
                let _e431 = ((1f - _e409) * (1f - _e410));
                let _e433 = (_e409 * (1f - _e410));
                let _e435 = ((1f - _e409) * _e410);
                let _e436 = (_e409 * _e410);
                let _e438 = p.member.test;
                let _e439 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e438);
                let _e441 = p.member.map_size;
                local_2 = _e439;
                let _e443 = (bitcast<i32>(_e441) - 1i);
                if (_e419 > 0i) {
                    phi_1495_ = _e419;
                } else {
                    phi_1495_ = 0i;
                }
                let _e446 = phi_1495_;
                if (_e428 > 0i) {
                    phi_1500_ = _e428;
                } else {
                    phi_1500_ = 0i;
                }
                let _e449 = phi_1500_;
                if (_e446 < _e443) {
                    phi_1505_ = _e446;
                } else {
                    phi_1505_ = _e443;
                }
                let _e452 = phi_1505_;
                if (_e449 < _e443) {
                    phi_1510_ = _e449;
                } else {
                    phi_1510_ = _e443;
                }
                let _e455 = phi_1510_;
                let _e456 = bitcast<u32>(_e452);
                let _e458 = (_e419 + 1i);
                let _e459 = (_e428 + 1i);
                if (_e458 > 0i) {
                    phi_1519_ = _e458;
                } else {
                    phi_1519_ = 0i;
                }
                let _e462 = phi_1519_;
                if (_e459 > 0i) {
                    phi_1524_ = _e459;
                } else {
                    phi_1524_ = 0i;
                }
                let _e465 = phi_1524_;
                if (_e462 < _e443) {
                    phi_1529_ = _e462;
                } else {
                    phi_1529_ = _e443;
                }
                let _e468 = phi_1529_;
                if (_e465 < _e443) {
                    phi_1534_ = _e465;
                } else {
                    phi_1534_ = _e443;
                }
                let _e471 = phi_1534_;
                let _e472 = bitcast<u32>(_e468);
                let _e474 = (bitcast<u32>(_e455) * _e441);
                let _e475 = (bitcast<u32>(_e471) * _e441);
                let _e476 = (_e474 + _e456);
                let _e477 = (_e474 + _e472);
                let _e478 = (_e475 + _e456);
                let _e479 = (_e475 + _e472);
                if (_e476 < _e47) {
                } else {
                    return;
                }
                let _e483 = map.member[(0u + _e476)];
                if (_e477 < _e47) {
                } else {
                    return;
                }
                let _e487 = map.member[(0u + _e477)];
                if (_e478 < _e47) {
                } else {
                    return;
                }
                let _e491 = map.member[(0u + _e478)];
                if (_e479 < _e47) {
                } else {
                    return;
                }
                let _e495 = map.member[(0u + _e479)];
                let _e496 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(_e483);
                let _e497 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(_e487);
                let _e498 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(_e491);
                let _e499 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(_e495);
                let _e545 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_2), vec4<f32>(((((_e496.x * _e431) + (_e497.x * _e433)) + (_e498.x * _e435)) + (_e499.x * _e436)), ((((_e496.y * _e431) + (_e497.y * _e433)) + (_e498.y * _e435)) + (_e499.y * _e436)), ((((_e496.z * _e431) + (_e497.z * _e433)) + (_e498.z * _e435)) + (_e499.z * _e436)), ((((_e496.w * _e431) + (_e497.w * _e433)) + (_e498.w * _e435)) + (_e499.w * _e436))), _e349);
                let _e547 = p.member.epsilon;
                if (_e545 <= _e547) {
                    phi_1629_ = true;
                } else {
                    phi_1629_ = (_e545 >= (1f - _e547));
                }
                let _e552 = phi_1629_;
                if ((bitcast<u32>(_e545) & 2147483647u) > 2139095040u) {
                    phi_1637_ = true;
                } else {
                    phi_1637_ = !(_e552);
                }
                let _e558 = phi_1637_;
                if (_e545 > 0.5f) {
                    phi_1642_ = 1f;
                } else {
                    phi_1642_ = 0f;
                }
                let _e561 = phi_1642_;
                phi_1645_ = evaluate_Verdict(_e561, _e558);
            } else {
                phi_1645_ = evaluate_Verdict(1f, true);
            }
            let _e565 = phi_1645_;
            phi_1646_ = _e565;
        }
        let _e567 = phi_1646_;
        visibility.member[_e57.first_primitive] = _e567.visibility;
        phi_1650_ = _e567.is_doubted;
        phi_1651_ = _e57.first_primitive;
    } else {
        phi_1650_ = false;
        phi_1651_ = 0u;
    }
    let _e572 = phi_1650_;
    let _e574 = phi_1651_;
    if _e572 {
        let _e576 = atomicAdd((&shared_[0u]), 1u);
        phi_1657_ = _e576;
    } else {
        phi_1657_ = 0u;
    }
    let _e578 = phi_1657_;
    workgroupBarrier();
    if (_e42 == 0u) {
        let _e582 = atomicLoad((&shared_[0u]));
        let _e583 = atomicAdd((&list.member[3u]), _e582);
        atomicStore((&shared_[1u]), _e583);
    }
    workgroupBarrier();
    if _e572 {
        let _e586 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e586) + _e578)]), _e574);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_msm_hausdorff_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_3 = local;
    function_();
}
