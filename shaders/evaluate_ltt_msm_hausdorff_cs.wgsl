struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_10 {
    member: array<abi_Sample>,
}

struct type_14 {
    member: array<u32>,
}

struct type_18 {
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

struct type_38 {
    member: abi_ShadowParams,
}

struct hankel_HankelFactors {
    moments: vec4<f32>,
    d22_: f32,
    l32_d22_: f32,
    d33_d22_: f32,
}

struct type_46 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
var<private> local_3: u32;
@group(0) @binding(1) 
var<storage> samples: type_10;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(0) 
var<uniform> p: type_38;
@group(0) @binding(2) 
var<storage> map: type_18;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_18;
@group(0) @binding(4) 
var<storage, read_write> list: type_46;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_157_: lt_bvh_traverse_Tree;
    var phi_158_: bool;
    var phi_159_: lt_bvh_traverse_Tree;
    var phi_160_: bool;
    var phi_165_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_157_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_158_ = false;
        } else {
            phi_157_ = lt_bvh_traverse_Tree();
            phi_158_ = true;
        }
        let _e53 = phi_157_;
        let _e55 = phi_158_;
        phi_159_ = _e53;
        phi_160_ = _e55;
    } else {
        phi_159_ = lt_bvh_traverse_Tree();
        phi_160_ = true;
    }
    let _e57 = phi_159_;
    let _e59 = phi_160_;
    if _e59 {
        phi_165_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_165_ = _e57;
    }
    let _e64 = phi_165_;
    return lt_bvh_traverse_Tree(_e64.root, _e64.first_primitive);
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_4: f32) -> vec4<f32> {
    var phi_188_: f32;
    var phi_189_: f32;
    var phi_190_: f32;

    if ((bitcast<u32>(param_4) & 2147483647u) > 2139095040u) {
        phi_190_ = param_4;
    } else {
        if (param_4 < 0f) {
            phi_189_ = 0f;
        } else {
            if (param_4 > 1f) {
                phi_188_ = 1f;
            } else {
                phi_188_ = param_4;
            }
            let _e47 = phi_188_;
            phi_189_ = _e47;
        }
        let _e49 = phi_189_;
        phi_190_ = _e49;
    }
    let _e51 = phi_190_;
    let _e52 = (_e51 * _e51);
    return vec4<f32>(_e51, _e52, (_e52 * _e51), (_e52 * _e52));
}

fn lt_math_hausdorff_cubic_mass(param_5: vec4<f32>, param_6: f32, param_7: f32, param_8: f32, param_9: f32) -> f32 {
    return ((((param_5.z - (((param_7 + param_8) + param_9) * param_5.y)) + ((((param_7 * param_8) + (param_7 * param_9)) + (param_8 * param_9)) * param_5.x)) - ((param_7 * param_8) * param_9)) / (((param_6 - param_7) * (param_6 - param_8)) * (param_6 - param_9)));
}

fn lt_math_hausdorff_endpoint_upper_bound(param_10: ptr<function, hankel_HankelFactors>, param_11: f32) -> f32 {
    var phi_958_: f32;
    var phi_959_: f32;
    var phi_960_: f32;
    var phi_987_: f32;
    var phi_988_: f32;
    var phi_989_: f32;
    var phi_990_: f32;
    var phi_991_: bool;
    var phi_992_: f32;
    var phi_993_: bool;
    var phi_1021_: f32;
    var phi_1022_: f32;
    var phi_1023_: f32;
    var phi_1024_: f32;
    var phi_1025_: bool;
    var phi_1026_: f32;
    var phi_1027_: bool;
    var phi_1034_: f32;
    var phi_1035_: f32;
    var phi_1036_: f32;
    var phi_1037_: f32;

    let _e43 = (*param_10).moments;
    if (param_11 < 0.0001f) {
        phi_1037_ = 1f;
    } else {
        let _e52 = ((_e43.z - ((1f + param_11) * _e43.y)) + (param_11 * _e43.x));
        let _e61 = (((_e43.w - ((1f + param_11) * _e43.z)) + (param_11 * _e43.y)) / _e52);
        if (abs(_e52) <= 0.00000047683716f) {
            let _e75 = (1f - (((_e43.y - (_e43.x * (param_11 + 1f))) + (param_11 * 1f)) / ((0f - param_11) * (0f - 1f))));
            if ((bitcast<u32>(_e75) & 2147483647u) > 2139095040u) {
                phi_960_ = _e75;
            } else {
                if (_e75 < 0f) {
                    phi_959_ = 0f;
                } else {
                    if (_e75 > 1f) {
                        phi_958_ = 1f;
                    } else {
                        phi_958_ = _e75;
                    }
                    let _e82 = phi_958_;
                    phi_959_ = _e82;
                }
                let _e84 = phi_959_;
                phi_960_ = _e84;
            }
            let _e86 = phi_960_;
            phi_1036_ = _e86;
        } else {
            if (_e61 > 0f) {
                if (_e61 < param_11) {
                    let _e89 = lt_math_hausdorff_cubic_mass(_e43, 0f, _e61, param_11, 1f);
                    let _e91 = lt_math_hausdorff_cubic_mass(_e43, _e61, 0f, param_11, 1f);
                    let _e92 = ((1f - _e89) - _e91);
                    if ((bitcast<u32>(_e92) & 2147483647u) > 2139095040u) {
                        phi_989_ = _e92;
                    } else {
                        if (_e92 < 0f) {
                            phi_988_ = 0f;
                        } else {
                            if (_e92 > 1f) {
                                phi_987_ = 1f;
                            } else {
                                phi_987_ = _e92;
                            }
                            let _e99 = phi_987_;
                            phi_988_ = _e99;
                        }
                        let _e101 = phi_988_;
                        phi_989_ = _e101;
                    }
                    let _e103 = phi_989_;
                    phi_990_ = _e103;
                    phi_991_ = false;
                } else {
                    phi_990_ = f32();
                    phi_991_ = true;
                }
                let _e105 = phi_990_;
                let _e107 = phi_991_;
                phi_992_ = _e105;
                phi_993_ = _e107;
            } else {
                phi_992_ = f32();
                phi_993_ = true;
            }
            let _e109 = phi_992_;
            let _e111 = phi_993_;
            if _e111 {
                if (_e61 > param_11) {
                    if (_e61 < 1f) {
                        let _e114 = lt_math_hausdorff_cubic_mass(_e43, 0f, _e61, param_11, 1f);
                        let _e115 = (1f - _e114);
                        if ((bitcast<u32>(_e115) & 2147483647u) > 2139095040u) {
                            phi_1023_ = _e115;
                        } else {
                            if (_e115 < 0f) {
                                phi_1022_ = 0f;
                            } else {
                                if (_e115 > 1f) {
                                    phi_1021_ = 1f;
                                } else {
                                    phi_1021_ = _e115;
                                }
                                let _e122 = phi_1021_;
                                phi_1022_ = _e122;
                            }
                            let _e124 = phi_1022_;
                            phi_1023_ = _e124;
                        }
                        let _e126 = phi_1023_;
                        phi_1024_ = _e126;
                        phi_1025_ = false;
                    } else {
                        phi_1024_ = f32();
                        phi_1025_ = true;
                    }
                    let _e128 = phi_1024_;
                    let _e130 = phi_1025_;
                    phi_1026_ = _e128;
                    phi_1027_ = _e130;
                } else {
                    phi_1026_ = f32();
                    phi_1027_ = true;
                }
                let _e132 = phi_1026_;
                let _e134 = phi_1027_;
                if _e134 {
                    phi_1034_ = bitcast<f32>((bitcast<u32>(_e61) | 2143289344u));
                } else {
                    phi_1034_ = _e132;
                }
                let _e139 = phi_1034_;
                phi_1035_ = _e139;
            } else {
                phi_1035_ = _e109;
            }
            let _e141 = phi_1035_;
            phi_1036_ = _e141;
        }
        let _e143 = phi_1036_;
        phi_1037_ = _e143;
    }
    let _e145 = phi_1037_;
    return _e145;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_12: ptr<function, f32>, param_13: vec4<f32>, param_14: f32) -> f32 {
    var local_1: hankel_HankelFactors;
    var phi_245_: f32;
    var phi_246_: f32;
    var phi_247_: f32;
    var phi_259_: bool;
    var phi_274_: bool;
    var phi_299_: f32;
    var phi_300_: f32;
    var phi_301_: f32;
    var phi_302_: f32;
    var phi_303_: bool;
    var phi_304_: f32;
    var phi_305_: bool;
    var phi_361_: vec2<f32>;
    var phi_399_: f32;
    var phi_400_: f32;
    var phi_401_: f32;
    var phi_434_: f32;
    var phi_435_: f32;
    var phi_436_: f32;
    var phi_440_: f32;
    var phi_441_: f32;
    var phi_442_: f32;
    var phi_443_: f32;
    var phi_496_: vec2<f32>;
    var phi_518_: bool;
    var phi_543_: f32;
    var phi_544_: f32;
    var phi_545_: f32;
    var phi_546_: f32;
    var phi_547_: bool;
    var phi_548_: f32;
    var phi_549_: bool;
    var phi_605_: vec2<f32>;
    var phi_643_: f32;
    var phi_644_: f32;
    var phi_645_: f32;
    var phi_678_: f32;
    var phi_679_: f32;
    var phi_680_: f32;
    var phi_684_: f32;
    var phi_685_: f32;
    var phi_686_: f32;
    var phi_687_: f32;
    var phi_688_: f32;
    var phi_689_: bool;
    var phi_690_: f32;
    var phi_691_: bool;
    var phi_713_: bool;
    var phi_738_: f32;
    var phi_739_: f32;
    var phi_740_: f32;
    var phi_741_: f32;
    var phi_742_: bool;
    var phi_743_: f32;
    var phi_744_: bool;
    var phi_800_: vec2<f32>;
    var phi_838_: f32;
    var phi_839_: f32;
    var phi_840_: f32;
    var phi_873_: f32;
    var phi_874_: f32;
    var phi_875_: f32;
    var phi_879_: f32;
    var phi_880_: f32;
    var phi_881_: f32;
    var phi_882_: f32;
    var phi_893_: bool;
    var phi_897_: f32;
    var phi_898_: f32;
    var phi_899_: f32;
    var phi_900_: f32;

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
        phi_247_ = param_14;
    } else {
        if (param_14 < 0f) {
            phi_246_ = 0f;
        } else {
            if (param_14 > 1f) {
                phi_245_ = 1f;
            } else {
                phi_245_ = param_14;
            }
            let _e81 = phi_245_;
            phi_246_ = _e81;
        }
        let _e83 = phi_246_;
        phi_247_ = _e83;
    }
    let _e85 = phi_247_;
    let _e88 = local_1.moments[0u];
    let _e91 = local_1.moments[3u];
    if (_e88 == _e91) {
        let _e95 = local_1.moments[0u];
        phi_259_ = (_e95 > 0.5f);
    } else {
        phi_259_ = false;
    }
    let _e98 = phi_259_;
    if _e98 {
        let _e101 = local_1.moments[0u];
        let _e104 = local_1.moments[3u];
        if (_e101 == _e104) {
            let _e108 = local_1.moments[0u];
            phi_274_ = (_e108 > 0.5f);
        } else {
            phi_274_ = false;
        }
        let _e111 = phi_274_;
        if _e111 {
            if (_e85 > 0f) {
                let _e114 = local_1.moments;
                if ((bitcast<u32>(_e114.x) & 2147483647u) > 2139095040u) {
                    phi_301_ = _e114.x;
                } else {
                    if (_e114.x < 0f) {
                        phi_300_ = 0f;
                    } else {
                        if (_e114.x > 1f) {
                            phi_299_ = 1f;
                        } else {
                            phi_299_ = _e114.x;
                        }
                        let _e122 = phi_299_;
                        phi_300_ = _e122;
                    }
                    let _e124 = phi_300_;
                    phi_301_ = _e124;
                }
                let _e126 = phi_301_;
                phi_302_ = _e126;
                phi_303_ = false;
            } else {
                phi_302_ = f32();
                phi_303_ = true;
            }
            let _e128 = phi_302_;
            let _e130 = phi_303_;
            phi_304_ = _e128;
            phi_305_ = _e130;
        } else {
            phi_304_ = f32();
            phi_305_ = true;
        }
        let _e132 = phi_304_;
        let _e134 = phi_305_;
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
                phi_361_ = vec2<f32>((-(_e173) - _e178), (-(_e173) + _e178));
            } else {
                phi_361_ = vec2(bitcast<f32>((bitcast<u32>(_e176) | 2143289344u)));
            }
            let _e189 = phi_361_;
            if (_e85 <= _e189.x) {
                phi_442_ = 1f;
            } else {
                if (_e85 > _e189.y) {
                    let _e195 = local_1.moments;
                    let _e206 = (((_e195.y - (_e195.x * (_e189.x + _e189.y))) + (_e189.x * _e189.y)) / ((_e85 - _e189.x) * (_e85 - _e189.y)));
                    if ((bitcast<u32>(_e206) & 2147483647u) > 2139095040u) {
                        phi_401_ = _e206;
                    } else {
                        if (_e206 < 0f) {
                            phi_400_ = 0f;
                        } else {
                            if (_e206 > 1f) {
                                phi_399_ = 1f;
                            } else {
                                phi_399_ = _e206;
                            }
                            let _e213 = phi_399_;
                            phi_400_ = _e213;
                        }
                        let _e215 = phi_400_;
                        phi_401_ = _e215;
                    }
                    let _e217 = phi_401_;
                    phi_441_ = _e217;
                } else {
                    if (_e85 > _e189.x) {
                        let _e220 = local_1.moments;
                        let _e232 = (1f - (((_e220.y - (_e220.x * (_e85 + _e189.y))) + (_e85 * _e189.y)) / ((_e189.x - _e85) * (_e189.x - _e189.y))));
                        if ((bitcast<u32>(_e232) & 2147483647u) > 2139095040u) {
                            phi_436_ = _e232;
                        } else {
                            if (_e232 < 0f) {
                                phi_435_ = 0f;
                            } else {
                                if (_e232 > 1f) {
                                    phi_434_ = 1f;
                                } else {
                                    phi_434_ = _e232;
                                }
                                let _e239 = phi_434_;
                                phi_435_ = _e239;
                            }
                            let _e241 = phi_435_;
                            phi_436_ = _e241;
                        }
                        let _e243 = phi_436_;
                        phi_440_ = _e243;
                    } else {
                        phi_440_ = bitcast<f32>((bitcast<u32>(_e189.x) | 2143289344u));
                    }
                    let _e248 = phi_440_;
                    phi_441_ = _e248;
                }
                let _e250 = phi_441_;
                phi_442_ = _e250;
            }
            let _e252 = phi_442_;
            phi_443_ = _e252;
        } else {
            phi_443_ = _e132;
        }
        let _e254 = phi_443_;
        phi_900_ = _e254;
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
            phi_496_ = vec2<f32>((-(_e293) - _e298), (-(_e293) + _e298));
        } else {
            phi_496_ = vec2(bitcast<f32>((bitcast<u32>(_e296) | 2143289344u)));
        }
        let _e309 = phi_496_;
        if (_e309.x >= 0f) {
            if (_e309.y <= 1f) {
                let _e316 = local_1.moments[0u];
                let _e319 = local_1.moments[3u];
                if (_e316 == _e319) {
                    let _e323 = local_1.moments[0u];
                    phi_518_ = (_e323 > 0.5f);
                } else {
                    phi_518_ = false;
                }
                let _e326 = phi_518_;
                if _e326 {
                    if (_e85 > 0f) {
                        let _e329 = local_1.moments;
                        if ((bitcast<u32>(_e329.x) & 2147483647u) > 2139095040u) {
                            phi_545_ = _e329.x;
                        } else {
                            if (_e329.x < 0f) {
                                phi_544_ = 0f;
                            } else {
                                if (_e329.x > 1f) {
                                    phi_543_ = 1f;
                                } else {
                                    phi_543_ = _e329.x;
                                }
                                let _e337 = phi_543_;
                                phi_544_ = _e337;
                            }
                            let _e339 = phi_544_;
                            phi_545_ = _e339;
                        }
                        let _e341 = phi_545_;
                        phi_546_ = _e341;
                        phi_547_ = false;
                    } else {
                        phi_546_ = f32();
                        phi_547_ = true;
                    }
                    let _e343 = phi_546_;
                    let _e345 = phi_547_;
                    phi_548_ = _e343;
                    phi_549_ = _e345;
                } else {
                    phi_548_ = f32();
                    phi_549_ = true;
                }
                let _e347 = phi_548_;
                let _e349 = phi_549_;
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
                        phi_605_ = vec2<f32>((-(_e388) - _e393), (-(_e388) + _e393));
                    } else {
                        phi_605_ = vec2(bitcast<f32>((bitcast<u32>(_e391) | 2143289344u)));
                    }
                    let _e404 = phi_605_;
                    if (_e85 <= _e404.x) {
                        phi_686_ = 1f;
                    } else {
                        if (_e85 > _e404.y) {
                            let _e410 = local_1.moments;
                            let _e421 = (((_e410.y - (_e410.x * (_e404.x + _e404.y))) + (_e404.x * _e404.y)) / ((_e85 - _e404.x) * (_e85 - _e404.y)));
                            if ((bitcast<u32>(_e421) & 2147483647u) > 2139095040u) {
                                phi_645_ = _e421;
                            } else {
                                if (_e421 < 0f) {
                                    phi_644_ = 0f;
                                } else {
                                    if (_e421 > 1f) {
                                        phi_643_ = 1f;
                                    } else {
                                        phi_643_ = _e421;
                                    }
                                    let _e428 = phi_643_;
                                    phi_644_ = _e428;
                                }
                                let _e430 = phi_644_;
                                phi_645_ = _e430;
                            }
                            let _e432 = phi_645_;
                            phi_685_ = _e432;
                        } else {
                            if (_e85 > _e404.x) {
                                let _e435 = local_1.moments;
                                let _e447 = (1f - (((_e435.y - (_e435.x * (_e85 + _e404.y))) + (_e85 * _e404.y)) / ((_e404.x - _e85) * (_e404.x - _e404.y))));
                                if ((bitcast<u32>(_e447) & 2147483647u) > 2139095040u) {
                                    phi_680_ = _e447;
                                } else {
                                    if (_e447 < 0f) {
                                        phi_679_ = 0f;
                                    } else {
                                        if (_e447 > 1f) {
                                            phi_678_ = 1f;
                                        } else {
                                            phi_678_ = _e447;
                                        }
                                        let _e454 = phi_678_;
                                        phi_679_ = _e454;
                                    }
                                    let _e456 = phi_679_;
                                    phi_680_ = _e456;
                                }
                                let _e458 = phi_680_;
                                phi_684_ = _e458;
                            } else {
                                phi_684_ = bitcast<f32>((bitcast<u32>(_e404.x) | 2143289344u));
                            }
                            let _e463 = phi_684_;
                            phi_685_ = _e463;
                        }
                        let _e465 = phi_685_;
                        phi_686_ = _e465;
                    }
                    let _e467 = phi_686_;
                    phi_687_ = _e467;
                } else {
                    phi_687_ = _e347;
                }
                let _e469 = phi_687_;
                phi_688_ = _e469;
                phi_689_ = false;
            } else {
                phi_688_ = f32();
                phi_689_ = true;
            }
            let _e471 = phi_688_;
            let _e473 = phi_689_;
            phi_690_ = _e471;
            phi_691_ = _e473;
        } else {
            phi_690_ = f32();
            phi_691_ = true;
        }
        let _e475 = phi_690_;
        let _e477 = phi_691_;
        if _e477 {
            if ((bitcast<u32>(_e309.x) & 2147483647u) > 2139095040u) {
                phi_898_ = _e309.x;
            } else {
                let _e481 = lt_math_hausdorff_endpoint_upper_bound((&local_1), _e85);
                let _e484 = local_1.moments[0u];
                let _e487 = local_1.moments[3u];
                if (_e484 == _e487) {
                    let _e491 = local_1.moments[0u];
                    phi_713_ = (_e491 > 0.5f);
                } else {
                    phi_713_ = false;
                }
                let _e494 = phi_713_;
                if _e494 {
                    if (_e85 > 0f) {
                        let _e497 = local_1.moments;
                        if ((bitcast<u32>(_e497.x) & 2147483647u) > 2139095040u) {
                            phi_740_ = _e497.x;
                        } else {
                            if (_e497.x < 0f) {
                                phi_739_ = 0f;
                            } else {
                                if (_e497.x > 1f) {
                                    phi_738_ = 1f;
                                } else {
                                    phi_738_ = _e497.x;
                                }
                                let _e505 = phi_738_;
                                phi_739_ = _e505;
                            }
                            let _e507 = phi_739_;
                            phi_740_ = _e507;
                        }
                        let _e509 = phi_740_;
                        phi_741_ = _e509;
                        phi_742_ = false;
                    } else {
                        phi_741_ = f32();
                        phi_742_ = true;
                    }
                    let _e511 = phi_741_;
                    let _e513 = phi_742_;
                    phi_743_ = _e511;
                    phi_744_ = _e513;
                } else {
                    phi_743_ = f32();
                    phi_744_ = true;
                }
                let _e515 = phi_743_;
                let _e517 = phi_744_;
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
                        phi_800_ = vec2<f32>((-(_e556) - _e561), (-(_e556) + _e561));
                    } else {
                        phi_800_ = vec2(bitcast<f32>((bitcast<u32>(_e559) | 2143289344u)));
                    }
                    let _e572 = phi_800_;
                    if (_e85 <= _e572.x) {
                        phi_881_ = 1f;
                    } else {
                        if (_e85 > _e572.y) {
                            let _e578 = local_1.moments;
                            let _e589 = (((_e578.y - (_e578.x * (_e572.x + _e572.y))) + (_e572.x * _e572.y)) / ((_e85 - _e572.x) * (_e85 - _e572.y)));
                            if ((bitcast<u32>(_e589) & 2147483647u) > 2139095040u) {
                                phi_840_ = _e589;
                            } else {
                                if (_e589 < 0f) {
                                    phi_839_ = 0f;
                                } else {
                                    if (_e589 > 1f) {
                                        phi_838_ = 1f;
                                    } else {
                                        phi_838_ = _e589;
                                    }
                                    let _e596 = phi_838_;
                                    phi_839_ = _e596;
                                }
                                let _e598 = phi_839_;
                                phi_840_ = _e598;
                            }
                            let _e600 = phi_840_;
                            phi_880_ = _e600;
                        } else {
                            if (_e85 > _e572.x) {
                                let _e603 = local_1.moments;
                                let _e615 = (1f - (((_e603.y - (_e603.x * (_e85 + _e572.y))) + (_e85 * _e572.y)) / ((_e572.x - _e85) * (_e572.x - _e572.y))));
                                if ((bitcast<u32>(_e615) & 2147483647u) > 2139095040u) {
                                    phi_875_ = _e615;
                                } else {
                                    if (_e615 < 0f) {
                                        phi_874_ = 0f;
                                    } else {
                                        if (_e615 > 1f) {
                                            phi_873_ = 1f;
                                        } else {
                                            phi_873_ = _e615;
                                        }
                                        let _e622 = phi_873_;
                                        phi_874_ = _e622;
                                    }
                                    let _e624 = phi_874_;
                                    phi_875_ = _e624;
                                }
                                let _e626 = phi_875_;
                                phi_879_ = _e626;
                            } else {
                                phi_879_ = bitcast<f32>((bitcast<u32>(_e572.x) | 2143289344u));
                            }
                            let _e631 = phi_879_;
                            phi_880_ = _e631;
                        }
                        let _e633 = phi_880_;
                        phi_881_ = _e633;
                    }
                    let _e635 = phi_881_;
                    phi_882_ = _e635;
                } else {
                    phi_882_ = _e515;
                }
                let _e637 = phi_882_;
                if ((bitcast<u32>(_e637) & 2147483647u) > 2139095040u) {
                    phi_893_ = true;
                } else {
                    let _e641 = (_e637 < _e481);
                    if _e641 {
                    }
                    phi_893_ = _e641;
                }
                let _e643 = phi_893_;
                if _e643 {
                    phi_897_ = _e637;
                } else {
                    phi_897_ = _e481;
                }
                let _e645 = phi_897_;
                phi_898_ = _e645;
            }
            let _e647 = phi_898_;
            phi_899_ = _e647;
        } else {
            phi_899_ = _e475;
        }
        let _e649 = phi_899_;
        phi_900_ = _e649;
    }
    let _e651 = phi_900_;
    return _e651;
}

fn function_() {
    var local_2: f32;
    var phi_1115_: bool;
    var phi_1116_: bool;
    var phi_1117_: bool;
    var phi_1118_: bool;
    var phi_1122_: bool;
    var phi_1166_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1170_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1247_: bool;
    var phi_1256_: bool;
    var phi_1265_: bool;
    var phi_1266_: bool;
    var phi_1267_: bool;
    var phi_1268_: bool;
    var phi_1269_: bool;
    var phi_1270_: bool;
    var phi_1271_: bool;
    var phi_1275_: bool;
    var phi_1369_: f32;
    var phi_1372_: f32;
    var phi_1401_: f32;
    var phi_1406_: f32;
    var phi_1407_: bool;
    var phi_1408_: f32;
    var phi_1409_: bool;
    var phi_1413_: f32;
    var phi_1433_: f32;
    var phi_1438_: f32;
    var phi_1439_: bool;
    var phi_1440_: f32;
    var phi_1441_: bool;
    var phi_1445_: f32;
    var phi_1491_: i32;
    var phi_1496_: i32;
    var phi_1501_: i32;
    var phi_1506_: i32;
    var phi_1515_: i32;
    var phi_1520_: i32;
    var phi_1525_: i32;
    var phi_1530_: i32;
    var phi_1625_: bool;
    var phi_1633_: bool;
    var phi_1645_: bool;
    var phi_1646_: bool;
    var phi_1650_: f32;
    var phi_1656_: f32;
    var phi_1658_: evaluate_Verdict;
    var phi_1663_: evaluate_Verdict;
    var phi_1664_: evaluate_Verdict;
    var phi_1668_: bool;
    var phi_1669_: u32;
    var phi_1680_: u32;

    let _e41 = id_1;
    let _e42 = local_3;
    let _e47 = arrayLength((&map.member));
    let _e52 = p.member.size[0u];
    let _e54 = p.member.size[1u];
    let _e55 = lt_shaders_entry_pixel_index(_e41, _e52, _e54);
    if (bitcast<i32>(_e55.root) != 0i) {
        let _e62 = p.member.light;
        let _e65 = samples.member[_e55.first_primitive].normal[0u];
        let _e67 = global[0u];
        if (_e65 == _e67) {
            let _e70 = samples.member[_e55.first_primitive].normal[1u];
            let _e72 = global[1u];
            if (_e70 == _e72) {
                let _e75 = samples.member[_e55.first_primitive].normal[2u];
                let _e77 = global[2u];
                phi_1115_ = (_e75 == _e77);
                phi_1116_ = false;
            } else {
                phi_1115_ = bool();
                phi_1116_ = true;
            }
            let _e80 = phi_1115_;
            let _e82 = phi_1116_;
            phi_1117_ = _e80;
            phi_1118_ = _e82;
        } else {
            phi_1117_ = bool();
            phi_1118_ = true;
        }
        let _e84 = phi_1117_;
        let _e86 = phi_1118_;
        if _e86 {
            phi_1122_ = false;
        } else {
            phi_1122_ = _e84;
        }
        let _e88 = phi_1122_;
        if !(_e88) {
            let _e91 = samples.member[_e55.first_primitive].normal;
            let _e93 = samples.member[_e55.first_primitive].position;
            if ((((_e91.x * (_e62.x - (_e93.x * _e62.w))) + (_e91.y * (_e62.y - (_e93.y * _e62.w)))) + (_e91.z * (_e62.z - (_e93.z * _e62.w)))) > 0f) {
                let _e117 = samples.member[_e55.first_primitive].flags;
                let _e125 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e131 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e125.unnamed.visibility, false), _e125.unnamed_1);
                phi_1166_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e131.unnamed, ((_e117 & 1u) == 0u));
            } else {
                let _e140 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e146 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e140.unnamed.visibility, false), _e140.unnamed_1);
                phi_1166_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e146.unnamed, true);
            }
            let _e151 = phi_1166_;
            phi_1170_ = _e151;
        } else {
            let _e157 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e163 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e157.unnamed.visibility, false), _e157.unnamed_1);
            phi_1170_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e163.unnamed, true);
        }
        let _e168 = phi_1170_;
        if _e168.unnamed_1 {
            phi_1664_ = evaluate_Verdict(_e168.unnamed.visibility, _e168.unnamed.is_doubted);
        } else {
            let _e176 = samples.member[_e55.first_primitive].position;
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
                    phi_1247_ = (_e207 <= 1f);
                } else {
                    phi_1247_ = false;
                }
                let _e239 = phi_1247_;
                if _e239 {
                    if (_e221 >= 0f) {
                        phi_1256_ = (_e221 <= 1f);
                    } else {
                        phi_1256_ = false;
                    }
                    let _e243 = phi_1256_;
                    if _e243 {
                        if (_e234 >= 0f) {
                            phi_1265_ = (_e234 <= 1f);
                        } else {
                            phi_1265_ = false;
                        }
                        let _e247 = phi_1265_;
                        phi_1266_ = _e247;
                        phi_1267_ = false;
                    } else {
                        phi_1266_ = bool();
                        phi_1267_ = true;
                    }
                    let _e249 = phi_1266_;
                    let _e251 = phi_1267_;
                    phi_1268_ = _e249;
                    phi_1269_ = _e251;
                } else {
                    phi_1268_ = bool();
                    phi_1269_ = true;
                }
                let _e253 = phi_1268_;
                let _e255 = phi_1269_;
                phi_1270_ = _e253;
                phi_1271_ = _e255;
            } else {
                phi_1270_ = bool();
                phi_1271_ = true;
            }
            let _e257 = phi_1270_;
            let _e259 = phi_1271_;
            if _e259 {
                phi_1275_ = false;
            } else {
                phi_1275_ = _e257;
            }
            let _e261 = phi_1275_;
            if _e261 {
                if (0f > 0f) {
                    let _e264 = samples.member[_e55.first_primitive].normal;
                    let _e266 = p.member.map_size;
                    let _e269 = p.member.projection.row_x;
                    let _e291 = p.member.projection.row_y;
                    let _e313 = p.member.projection.row_z;
                    let _e340 = ((abs(((((_e269.x * _e264.x) + (_e269.y * _e264.y)) + (_e269.z * _e264.z)) / (((_e269.x * _e269.x) + (_e269.y * _e269.y)) + (_e269.z * _e269.z)))) + abs(((((_e291.x * _e264.x) + (_e291.y * _e264.y)) + (_e291.z * _e264.z)) / (((_e291.x * _e291.x) + (_e291.y * _e291.y)) + (_e291.z * _e291.z))))) / (abs(((((_e313.x * _e264.x) + (_e313.y * _e264.y)) + (_e313.z * _e264.z)) / (((_e313.x * _e313.x) + (_e313.y * _e313.y)) + (_e313.z * _e313.z)))) * f32(_e266)));
                    if (_e340 < 0.002f) {
                        phi_1369_ = _e340;
                    } else {
                        phi_1369_ = 0.002f;
                    }
                    let _e343 = phi_1369_;
                    phi_1372_ = (_e234 - (0f * _e343));
                } else {
                    phi_1372_ = _e234;
                }
                let _e347 = phi_1372_;
                let _e349 = p.member.map_size;
                let _e350 = f32(_e349);
                let _e353 = ((_e207 * _e350) - 0.5f);
                let _e354 = ((_e221 * _e350) - 0.5f);
                if (_e353 > -8388608f) {
                    let _e366 = f32(select(0i, select(select(i32(_e353), i32(-2147483648), (_e353 < bitcast<f32>(3472883712u))), 2147483647i, (_e353 > bitcast<f32>(1325400063u))), (_e353 == _e353)));
                    if (_e366 > _e353) {
                        phi_1401_ = 1f;
                    } else {
                        phi_1401_ = 0f;
                    }
                    let _e369 = phi_1401_;
                    if (_e353 < 8388608f) {
                        phi_1406_ = (_e366 - _e369);
                        phi_1407_ = false;
                    } else {
                        phi_1406_ = f32();
                        phi_1407_ = true;
                    }
                    let _e372 = phi_1406_;
                    let _e374 = phi_1407_;
                    phi_1408_ = _e372;
                    phi_1409_ = _e374;
                } else {
                    phi_1408_ = f32();
                    phi_1409_ = true;
                }
                let _e376 = phi_1408_;
                let _e378 = phi_1409_;
                if _e378 {
                    phi_1413_ = _e353;
                } else {
                    phi_1413_ = _e376;
                }
                let _e380 = phi_1413_;
                if (_e354 > -8388608f) {
                    let _e392 = f32(select(0i, select(select(i32(_e354), i32(-2147483648), (_e354 < bitcast<f32>(3472883712u))), 2147483647i, (_e354 > bitcast<f32>(1325400063u))), (_e354 == _e354)));
                    if (_e392 > _e354) {
                        phi_1433_ = 1f;
                    } else {
                        phi_1433_ = 0f;
                    }
                    let _e395 = phi_1433_;
                    if (_e354 < 8388608f) {
                        phi_1438_ = (_e392 - _e395);
                        phi_1439_ = false;
                    } else {
                        phi_1438_ = f32();
                        phi_1439_ = true;
                    }
                    let _e398 = phi_1438_;
                    let _e400 = phi_1439_;
                    phi_1440_ = _e398;
                    phi_1441_ = _e400;
                } else {
                    phi_1440_ = f32();
                    phi_1441_ = true;
                }
                let _e402 = phi_1440_;
                let _e404 = phi_1441_;
                if _e404 {
                    phi_1445_ = _e354;
                } else {
                    phi_1445_ = _e402;
                }
                let _e406 = phi_1445_;
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
                local_2 = _e437;
                let _e441 = (bitcast<i32>(_e439) - 1i);
                if (_e417 > 0i) {
                    phi_1491_ = _e417;
                } else {
                    phi_1491_ = 0i;
                }
                let _e444 = phi_1491_;
                if (_e426 > 0i) {
                    phi_1496_ = _e426;
                } else {
                    phi_1496_ = 0i;
                }
                let _e447 = phi_1496_;
                if (_e444 < _e441) {
                    phi_1501_ = _e444;
                } else {
                    phi_1501_ = _e441;
                }
                let _e450 = phi_1501_;
                if (_e447 < _e441) {
                    phi_1506_ = _e447;
                } else {
                    phi_1506_ = _e441;
                }
                let _e453 = phi_1506_;
                let _e454 = bitcast<u32>(_e450);
                let _e456 = (_e417 + 1i);
                let _e457 = (_e426 + 1i);
                if (_e456 > 0i) {
                    phi_1515_ = _e456;
                } else {
                    phi_1515_ = 0i;
                }
                let _e460 = phi_1515_;
                if (_e457 > 0i) {
                    phi_1520_ = _e457;
                } else {
                    phi_1520_ = 0i;
                }
                let _e463 = phi_1520_;
                if (_e460 < _e441) {
                    phi_1525_ = _e460;
                } else {
                    phi_1525_ = _e441;
                }
                let _e466 = phi_1525_;
                if (_e463 < _e441) {
                    phi_1530_ = _e463;
                } else {
                    phi_1530_ = _e441;
                }
                let _e469 = phi_1530_;
                let _e470 = bitcast<u32>(_e466);
                let _e472 = (bitcast<u32>(_e453) * _e439);
                let _e473 = (bitcast<u32>(_e469) * _e439);
                let _e474 = (_e472 + _e454);
                let _e475 = (_e472 + _e470);
                let _e476 = (_e473 + _e454);
                let _e477 = (_e473 + _e470);
                if (_e474 < _e47) {
                } else {
                    return;
                }
                let _e481 = map.member[(0u + _e474)];
                if (_e475 < _e47) {
                } else {
                    return;
                }
                let _e485 = map.member[(0u + _e475)];
                if (_e476 < _e47) {
                } else {
                    return;
                }
                let _e489 = map.member[(0u + _e476)];
                if (_e477 < _e47) {
                } else {
                    return;
                }
                let _e493 = map.member[(0u + _e477)];
                let _e494 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(_e481);
                let _e495 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(_e485);
                let _e496 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(_e489);
                let _e497 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(_e493);
                let _e543 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_2), vec4<f32>(((((_e494.x * _e429) + (_e495.x * _e431)) + (_e496.x * _e433)) + (_e497.x * _e434)), ((((_e494.y * _e429) + (_e495.y * _e431)) + (_e496.y * _e433)) + (_e497.y * _e434)), ((((_e494.z * _e429) + (_e495.z * _e431)) + (_e496.z * _e433)) + (_e497.z * _e434)), ((((_e494.w * _e429) + (_e495.w * _e431)) + (_e496.w * _e433)) + (_e497.w * _e434))), _e347);
                let _e545 = p.member.epsilon;
                if (_e543 <= _e545) {
                    phi_1625_ = true;
                } else {
                    phi_1625_ = (_e543 >= (1f - _e545));
                }
                let _e550 = phi_1625_;
                if ((bitcast<u32>(_e543) & 2147483647u) > 2139095040u) {
                    phi_1633_ = true;
                } else {
                    phi_1633_ = !(_e550);
                }
                let _e556 = phi_1633_;
                if _e556 {
                    if (_e543 > 0f) {
                        if (_e543 < 1f) {
                            phi_1645_ = false;
                        } else {
                            phi_1645_ = true;
                        }
                        let _e560 = phi_1645_;
                        phi_1646_ = _e560;
                    } else {
                        phi_1646_ = true;
                    }
                    let _e562 = phi_1646_;
                    if _e562 {
                        phi_1650_ = 0.5f;
                    } else {
                        phi_1650_ = _e543;
                    }
                    let _e564 = phi_1650_;
                    phi_1658_ = evaluate_Verdict(_e564, true);
                } else {
                    if (_e543 > 0.5f) {
                        phi_1656_ = 1f;
                    } else {
                        phi_1656_ = 0f;
                    }
                    let _e568 = phi_1656_;
                    phi_1658_ = evaluate_Verdict(_e568, false);
                }
                let _e571 = phi_1658_;
                phi_1663_ = evaluate_Verdict(_e571.visibility, _e571.is_doubted);
            } else {
                phi_1663_ = evaluate_Verdict(0.5f, true);
            }
            let _e577 = phi_1663_;
            phi_1664_ = _e577;
        }
        let _e579 = phi_1664_;
        visibility.member[_e55.first_primitive] = _e579.visibility;
        phi_1668_ = _e579.is_doubted;
        phi_1669_ = _e55.first_primitive;
    } else {
        phi_1668_ = false;
        phi_1669_ = 0u;
    }
    let _e584 = phi_1668_;
    let _e586 = phi_1669_;
    if (_e42 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e584 {
        let _e590 = atomicAdd((&shared_[0u]), 1u);
        phi_1680_ = _e590;
    } else {
        phi_1680_ = 0u;
    }
    let _e592 = phi_1680_;
    workgroupBarrier();
    if (_e42 == 0u) {
        let _e596 = atomicLoad((&shared_[0u]));
        let _e597 = atomicAdd((&list.member[3u]), _e596);
        atomicStore((&shared_[1u]), _e597);
    }
    workgroupBarrier();
    if _e584 {
        let _e600 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e600) + _e592)]), _e586);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_msm_hausdorff_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_3 = local;
    function_();
}
