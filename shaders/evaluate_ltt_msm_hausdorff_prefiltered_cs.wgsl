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
    var phi_164_: lt_bvh_traverse_Tree;
    var phi_165_: bool;
    var phi_166_: lt_bvh_traverse_Tree;
    var phi_167_: bool;
    var phi_172_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_164_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_165_ = false;
        } else {
            phi_164_ = lt_bvh_traverse_Tree();
            phi_165_ = true;
        }
        let _e53 = phi_164_;
        let _e55 = phi_165_;
        phi_166_ = _e53;
        phi_167_ = _e55;
    } else {
        phi_166_ = lt_bvh_traverse_Tree();
        phi_167_ = true;
    }
    let _e57 = phi_166_;
    let _e59 = phi_167_;
    if _e59 {
        phi_172_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_172_ = _e57;
    }
    let _e64 = phi_172_;
    return lt_bvh_traverse_Tree(_e64.root, _e64.first_primitive);
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn lt_math_hausdorff_cubic_mass(param_4: vec4<f32>, param_5: f32, param_6: f32, param_7: f32, param_8: f32) -> f32 {
    return ((((param_4.z - (((param_6 + param_7) + param_8) * param_4.y)) + ((((param_6 * param_7) + (param_6 * param_8)) + (param_7 * param_8)) * param_4.x)) - ((param_6 * param_7) * param_8)) / (((param_5 - param_6) * (param_5 - param_7)) * (param_5 - param_8)));
}

fn lt_math_hausdorff_endpoint_upper_bound(param_9: ptr<function, hankel_HankelFactors>, param_10: f32) -> f32 {
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

    let _e43 = (*param_9).moments;
    if (param_10 < 0.0001f) {
        phi_1021_ = 1f;
    } else {
        let _e52 = ((_e43.z - ((1f + param_10) * _e43.y)) + (param_10 * _e43.x));
        let _e61 = (((_e43.w - ((1f + param_10) * _e43.z)) + (param_10 * _e43.y)) / _e52);
        if (abs(_e52) <= 0.00000047683716f) {
            let _e75 = (1f - (((_e43.y - (_e43.x * (param_10 + 1f))) + (param_10 * 1f)) / ((0f - param_10) * (0f - 1f))));
            if ((bitcast<u32>(_e75) & 2147483647u) > 2139095040u) {
                phi_944_ = _e75;
            } else {
                if (_e75 < 0f) {
                    phi_943_ = 0f;
                } else {
                    if (_e75 > 1f) {
                        phi_942_ = 1f;
                    } else {
                        phi_942_ = _e75;
                    }
                    let _e82 = phi_942_;
                    phi_943_ = _e82;
                }
                let _e84 = phi_943_;
                phi_944_ = _e84;
            }
            let _e86 = phi_944_;
            phi_1020_ = _e86;
        } else {
            if (_e61 > 0f) {
                if (_e61 < param_10) {
                    let _e89 = lt_math_hausdorff_cubic_mass(_e43, 0f, _e61, param_10, 1f);
                    let _e91 = lt_math_hausdorff_cubic_mass(_e43, _e61, 0f, param_10, 1f);
                    let _e92 = ((1f - _e89) - _e91);
                    if ((bitcast<u32>(_e92) & 2147483647u) > 2139095040u) {
                        phi_973_ = _e92;
                    } else {
                        if (_e92 < 0f) {
                            phi_972_ = 0f;
                        } else {
                            if (_e92 > 1f) {
                                phi_971_ = 1f;
                            } else {
                                phi_971_ = _e92;
                            }
                            let _e99 = phi_971_;
                            phi_972_ = _e99;
                        }
                        let _e101 = phi_972_;
                        phi_973_ = _e101;
                    }
                    let _e103 = phi_973_;
                    phi_974_ = _e103;
                    phi_975_ = false;
                } else {
                    phi_974_ = f32();
                    phi_975_ = true;
                }
                let _e105 = phi_974_;
                let _e107 = phi_975_;
                phi_976_ = _e105;
                phi_977_ = _e107;
            } else {
                phi_976_ = f32();
                phi_977_ = true;
            }
            let _e109 = phi_976_;
            let _e111 = phi_977_;
            if _e111 {
                if (_e61 > param_10) {
                    if (_e61 < 1f) {
                        let _e114 = lt_math_hausdorff_cubic_mass(_e43, 0f, _e61, param_10, 1f);
                        let _e115 = (1f - _e114);
                        if ((bitcast<u32>(_e115) & 2147483647u) > 2139095040u) {
                            phi_1007_ = _e115;
                        } else {
                            if (_e115 < 0f) {
                                phi_1006_ = 0f;
                            } else {
                                if (_e115 > 1f) {
                                    phi_1005_ = 1f;
                                } else {
                                    phi_1005_ = _e115;
                                }
                                let _e122 = phi_1005_;
                                phi_1006_ = _e122;
                            }
                            let _e124 = phi_1006_;
                            phi_1007_ = _e124;
                        }
                        let _e126 = phi_1007_;
                        phi_1008_ = _e126;
                        phi_1009_ = false;
                    } else {
                        phi_1008_ = f32();
                        phi_1009_ = true;
                    }
                    let _e128 = phi_1008_;
                    let _e130 = phi_1009_;
                    phi_1010_ = _e128;
                    phi_1011_ = _e130;
                } else {
                    phi_1010_ = f32();
                    phi_1011_ = true;
                }
                let _e132 = phi_1010_;
                let _e134 = phi_1011_;
                if _e134 {
                    phi_1018_ = bitcast<f32>((bitcast<u32>(_e61) | 2143289344u));
                } else {
                    phi_1018_ = _e132;
                }
                let _e139 = phi_1018_;
                phi_1019_ = _e139;
            } else {
                phi_1019_ = _e109;
            }
            let _e141 = phi_1019_;
            phi_1020_ = _e141;
        }
        let _e143 = phi_1020_;
        phi_1021_ = _e143;
    }
    let _e145 = phi_1021_;
    return _e145;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_11: ptr<function, f32>, param_12: vec4<f32>, param_13: f32) -> f32 {
    var local_1: hankel_HankelFactors;
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

    let _e44 = (*param_11);
    let _e45 = (1f - _e44);
    let _e54 = (0.5f * _e44);
    let _e55 = ((param_12.x * _e45) + _e54);
    let _e56 = ((param_12.y * _e45) + _e54);
    let _e57 = ((param_12.z * _e45) + _e54);
    let _e58 = ((param_12.w * _e45) + _e54);
    let _e61 = (_e56 - (_e55 * _e55));
    let _e63 = (_e57 - (_e55 * _e56));
    let _e69 = hankel_HankelFactors(vec4<f32>(_e55, _e56, _e57, _e58), _e61, _e63, (((_e58 - (_e56 * _e56)) * _e61) - (_e63 * _e63)));
    local_1 = hankel_HankelFactors(_e69.moments, _e69.d22_, _e69.l32_d22_, _e69.d33_d22_);
    if ((bitcast<u32>(param_13) & 2147483647u) > 2139095040u) {
        phi_231_ = param_13;
    } else {
        if (param_13 < 0f) {
            phi_230_ = 0f;
        } else {
            if (param_13 > 1f) {
                phi_229_ = 1f;
            } else {
                phi_229_ = param_13;
            }
            let _e81 = phi_229_;
            phi_230_ = _e81;
        }
        let _e83 = phi_230_;
        phi_231_ = _e83;
    }
    let _e85 = phi_231_;
    let _e88 = local_1.moments[0u];
    let _e91 = local_1.moments[3u];
    if (_e88 == _e91) {
        let _e95 = local_1.moments[0u];
        phi_243_ = (_e95 > 0.5f);
    } else {
        phi_243_ = false;
    }
    let _e98 = phi_243_;
    if _e98 {
        let _e101 = local_1.moments[0u];
        let _e104 = local_1.moments[3u];
        if (_e101 == _e104) {
            let _e108 = local_1.moments[0u];
            phi_258_ = (_e108 > 0.5f);
        } else {
            phi_258_ = false;
        }
        let _e111 = phi_258_;
        if _e111 {
            if (_e85 > 0f) {
                let _e114 = local_1.moments;
                if ((bitcast<u32>(_e114.x) & 2147483647u) > 2139095040u) {
                    phi_285_ = _e114.x;
                } else {
                    if (_e114.x < 0f) {
                        phi_284_ = 0f;
                    } else {
                        if (_e114.x > 1f) {
                            phi_283_ = 1f;
                        } else {
                            phi_283_ = _e114.x;
                        }
                        let _e122 = phi_283_;
                        phi_284_ = _e122;
                    }
                    let _e124 = phi_284_;
                    phi_285_ = _e124;
                }
                let _e126 = phi_285_;
                phi_286_ = _e126;
                phi_287_ = false;
            } else {
                phi_286_ = f32();
                phi_287_ = true;
            }
            let _e128 = phi_286_;
            let _e130 = phi_287_;
            phi_288_ = _e128;
            phi_289_ = _e130;
        } else {
            phi_288_ = f32();
            phi_289_ = true;
        }
        let _e132 = phi_288_;
        let _e134 = phi_289_;
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
                phi_345_ = vec2<f32>((-(_e173) - _e178), (-(_e173) + _e178));
            } else {
                phi_345_ = vec2(bitcast<f32>((bitcast<u32>(_e176) | 2143289344u)));
            }
            let _e189 = phi_345_;
            if (_e85 <= _e189.x) {
                phi_426_ = 1f;
            } else {
                if (_e85 > _e189.y) {
                    let _e195 = local_1.moments;
                    let _e206 = (((_e195.y - (_e195.x * (_e189.x + _e189.y))) + (_e189.x * _e189.y)) / ((_e85 - _e189.x) * (_e85 - _e189.y)));
                    if ((bitcast<u32>(_e206) & 2147483647u) > 2139095040u) {
                        phi_385_ = _e206;
                    } else {
                        if (_e206 < 0f) {
                            phi_384_ = 0f;
                        } else {
                            if (_e206 > 1f) {
                                phi_383_ = 1f;
                            } else {
                                phi_383_ = _e206;
                            }
                            let _e213 = phi_383_;
                            phi_384_ = _e213;
                        }
                        let _e215 = phi_384_;
                        phi_385_ = _e215;
                    }
                    let _e217 = phi_385_;
                    phi_425_ = _e217;
                } else {
                    if (_e85 > _e189.x) {
                        let _e220 = local_1.moments;
                        let _e232 = (1f - (((_e220.y - (_e220.x * (_e85 + _e189.y))) + (_e85 * _e189.y)) / ((_e189.x - _e85) * (_e189.x - _e189.y))));
                        if ((bitcast<u32>(_e232) & 2147483647u) > 2139095040u) {
                            phi_420_ = _e232;
                        } else {
                            if (_e232 < 0f) {
                                phi_419_ = 0f;
                            } else {
                                if (_e232 > 1f) {
                                    phi_418_ = 1f;
                                } else {
                                    phi_418_ = _e232;
                                }
                                let _e239 = phi_418_;
                                phi_419_ = _e239;
                            }
                            let _e241 = phi_419_;
                            phi_420_ = _e241;
                        }
                        let _e243 = phi_420_;
                        phi_424_ = _e243;
                    } else {
                        phi_424_ = bitcast<f32>((bitcast<u32>(_e189.x) | 2143289344u));
                    }
                    let _e248 = phi_424_;
                    phi_425_ = _e248;
                }
                let _e250 = phi_425_;
                phi_426_ = _e250;
            }
            let _e252 = phi_426_;
            phi_427_ = _e252;
        } else {
            phi_427_ = _e132;
        }
        let _e254 = phi_427_;
        phi_884_ = _e254;
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
            phi_480_ = vec2<f32>((-(_e293) - _e298), (-(_e293) + _e298));
        } else {
            phi_480_ = vec2(bitcast<f32>((bitcast<u32>(_e296) | 2143289344u)));
        }
        let _e309 = phi_480_;
        if (_e309.x >= 0f) {
            if (_e309.y <= 1f) {
                let _e316 = local_1.moments[0u];
                let _e319 = local_1.moments[3u];
                if (_e316 == _e319) {
                    let _e323 = local_1.moments[0u];
                    phi_502_ = (_e323 > 0.5f);
                } else {
                    phi_502_ = false;
                }
                let _e326 = phi_502_;
                if _e326 {
                    if (_e85 > 0f) {
                        let _e329 = local_1.moments;
                        if ((bitcast<u32>(_e329.x) & 2147483647u) > 2139095040u) {
                            phi_529_ = _e329.x;
                        } else {
                            if (_e329.x < 0f) {
                                phi_528_ = 0f;
                            } else {
                                if (_e329.x > 1f) {
                                    phi_527_ = 1f;
                                } else {
                                    phi_527_ = _e329.x;
                                }
                                let _e337 = phi_527_;
                                phi_528_ = _e337;
                            }
                            let _e339 = phi_528_;
                            phi_529_ = _e339;
                        }
                        let _e341 = phi_529_;
                        phi_530_ = _e341;
                        phi_531_ = false;
                    } else {
                        phi_530_ = f32();
                        phi_531_ = true;
                    }
                    let _e343 = phi_530_;
                    let _e345 = phi_531_;
                    phi_532_ = _e343;
                    phi_533_ = _e345;
                } else {
                    phi_532_ = f32();
                    phi_533_ = true;
                }
                let _e347 = phi_532_;
                let _e349 = phi_533_;
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
                        phi_589_ = vec2<f32>((-(_e388) - _e393), (-(_e388) + _e393));
                    } else {
                        phi_589_ = vec2(bitcast<f32>((bitcast<u32>(_e391) | 2143289344u)));
                    }
                    let _e404 = phi_589_;
                    if (_e85 <= _e404.x) {
                        phi_670_ = 1f;
                    } else {
                        if (_e85 > _e404.y) {
                            let _e410 = local_1.moments;
                            let _e421 = (((_e410.y - (_e410.x * (_e404.x + _e404.y))) + (_e404.x * _e404.y)) / ((_e85 - _e404.x) * (_e85 - _e404.y)));
                            if ((bitcast<u32>(_e421) & 2147483647u) > 2139095040u) {
                                phi_629_ = _e421;
                            } else {
                                if (_e421 < 0f) {
                                    phi_628_ = 0f;
                                } else {
                                    if (_e421 > 1f) {
                                        phi_627_ = 1f;
                                    } else {
                                        phi_627_ = _e421;
                                    }
                                    let _e428 = phi_627_;
                                    phi_628_ = _e428;
                                }
                                let _e430 = phi_628_;
                                phi_629_ = _e430;
                            }
                            let _e432 = phi_629_;
                            phi_669_ = _e432;
                        } else {
                            if (_e85 > _e404.x) {
                                let _e435 = local_1.moments;
                                let _e447 = (1f - (((_e435.y - (_e435.x * (_e85 + _e404.y))) + (_e85 * _e404.y)) / ((_e404.x - _e85) * (_e404.x - _e404.y))));
                                if ((bitcast<u32>(_e447) & 2147483647u) > 2139095040u) {
                                    phi_664_ = _e447;
                                } else {
                                    if (_e447 < 0f) {
                                        phi_663_ = 0f;
                                    } else {
                                        if (_e447 > 1f) {
                                            phi_662_ = 1f;
                                        } else {
                                            phi_662_ = _e447;
                                        }
                                        let _e454 = phi_662_;
                                        phi_663_ = _e454;
                                    }
                                    let _e456 = phi_663_;
                                    phi_664_ = _e456;
                                }
                                let _e458 = phi_664_;
                                phi_668_ = _e458;
                            } else {
                                phi_668_ = bitcast<f32>((bitcast<u32>(_e404.x) | 2143289344u));
                            }
                            let _e463 = phi_668_;
                            phi_669_ = _e463;
                        }
                        let _e465 = phi_669_;
                        phi_670_ = _e465;
                    }
                    let _e467 = phi_670_;
                    phi_671_ = _e467;
                } else {
                    phi_671_ = _e347;
                }
                let _e469 = phi_671_;
                phi_672_ = _e469;
                phi_673_ = false;
            } else {
                phi_672_ = f32();
                phi_673_ = true;
            }
            let _e471 = phi_672_;
            let _e473 = phi_673_;
            phi_674_ = _e471;
            phi_675_ = _e473;
        } else {
            phi_674_ = f32();
            phi_675_ = true;
        }
        let _e475 = phi_674_;
        let _e477 = phi_675_;
        if _e477 {
            if ((bitcast<u32>(_e309.x) & 2147483647u) > 2139095040u) {
                phi_882_ = _e309.x;
            } else {
                let _e481 = lt_math_hausdorff_endpoint_upper_bound((&local_1), _e85);
                let _e484 = local_1.moments[0u];
                let _e487 = local_1.moments[3u];
                if (_e484 == _e487) {
                    let _e491 = local_1.moments[0u];
                    phi_697_ = (_e491 > 0.5f);
                } else {
                    phi_697_ = false;
                }
                let _e494 = phi_697_;
                if _e494 {
                    if (_e85 > 0f) {
                        let _e497 = local_1.moments;
                        if ((bitcast<u32>(_e497.x) & 2147483647u) > 2139095040u) {
                            phi_724_ = _e497.x;
                        } else {
                            if (_e497.x < 0f) {
                                phi_723_ = 0f;
                            } else {
                                if (_e497.x > 1f) {
                                    phi_722_ = 1f;
                                } else {
                                    phi_722_ = _e497.x;
                                }
                                let _e505 = phi_722_;
                                phi_723_ = _e505;
                            }
                            let _e507 = phi_723_;
                            phi_724_ = _e507;
                        }
                        let _e509 = phi_724_;
                        phi_725_ = _e509;
                        phi_726_ = false;
                    } else {
                        phi_725_ = f32();
                        phi_726_ = true;
                    }
                    let _e511 = phi_725_;
                    let _e513 = phi_726_;
                    phi_727_ = _e511;
                    phi_728_ = _e513;
                } else {
                    phi_727_ = f32();
                    phi_728_ = true;
                }
                let _e515 = phi_727_;
                let _e517 = phi_728_;
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
                        phi_784_ = vec2<f32>((-(_e556) - _e561), (-(_e556) + _e561));
                    } else {
                        phi_784_ = vec2(bitcast<f32>((bitcast<u32>(_e559) | 2143289344u)));
                    }
                    let _e572 = phi_784_;
                    if (_e85 <= _e572.x) {
                        phi_865_ = 1f;
                    } else {
                        if (_e85 > _e572.y) {
                            let _e578 = local_1.moments;
                            let _e589 = (((_e578.y - (_e578.x * (_e572.x + _e572.y))) + (_e572.x * _e572.y)) / ((_e85 - _e572.x) * (_e85 - _e572.y)));
                            if ((bitcast<u32>(_e589) & 2147483647u) > 2139095040u) {
                                phi_824_ = _e589;
                            } else {
                                if (_e589 < 0f) {
                                    phi_823_ = 0f;
                                } else {
                                    if (_e589 > 1f) {
                                        phi_822_ = 1f;
                                    } else {
                                        phi_822_ = _e589;
                                    }
                                    let _e596 = phi_822_;
                                    phi_823_ = _e596;
                                }
                                let _e598 = phi_823_;
                                phi_824_ = _e598;
                            }
                            let _e600 = phi_824_;
                            phi_864_ = _e600;
                        } else {
                            if (_e85 > _e572.x) {
                                let _e603 = local_1.moments;
                                let _e615 = (1f - (((_e603.y - (_e603.x * (_e85 + _e572.y))) + (_e85 * _e572.y)) / ((_e572.x - _e85) * (_e572.x - _e572.y))));
                                if ((bitcast<u32>(_e615) & 2147483647u) > 2139095040u) {
                                    phi_859_ = _e615;
                                } else {
                                    if (_e615 < 0f) {
                                        phi_858_ = 0f;
                                    } else {
                                        if (_e615 > 1f) {
                                            phi_857_ = 1f;
                                        } else {
                                            phi_857_ = _e615;
                                        }
                                        let _e622 = phi_857_;
                                        phi_858_ = _e622;
                                    }
                                    let _e624 = phi_858_;
                                    phi_859_ = _e624;
                                }
                                let _e626 = phi_859_;
                                phi_863_ = _e626;
                            } else {
                                phi_863_ = bitcast<f32>((bitcast<u32>(_e572.x) | 2143289344u));
                            }
                            let _e631 = phi_863_;
                            phi_864_ = _e631;
                        }
                        let _e633 = phi_864_;
                        phi_865_ = _e633;
                    }
                    let _e635 = phi_865_;
                    phi_866_ = _e635;
                } else {
                    phi_866_ = _e515;
                }
                let _e637 = phi_866_;
                if ((bitcast<u32>(_e637) & 2147483647u) > 2139095040u) {
                    phi_877_ = true;
                } else {
                    let _e641 = (_e637 < _e481);
                    if _e641 {
                    }
                    phi_877_ = _e641;
                }
                let _e643 = phi_877_;
                if _e643 {
                    phi_881_ = _e637;
                } else {
                    phi_881_ = _e481;
                }
                let _e645 = phi_881_;
                phi_882_ = _e645;
            }
            let _e647 = phi_882_;
            phi_883_ = _e647;
        } else {
            phi_883_ = _e475;
        }
        let _e649 = phi_883_;
        phi_884_ = _e649;
    }
    let _e651 = phi_884_;
    return _e651;
}

fn function_() {
    var local_2: f32;
    var phi_1101_: bool;
    var phi_1102_: bool;
    var phi_1103_: bool;
    var phi_1104_: bool;
    var phi_1108_: bool;
    var phi_1178_: bool;
    var phi_1179_: bool;
    var phi_1190_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1191_: bool;
    var phi_1192_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1193_: bool;
    var phi_1200_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1204_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1278_: bool;
    var phi_1287_: bool;
    var phi_1296_: bool;
    var phi_1297_: bool;
    var phi_1298_: bool;
    var phi_1299_: bool;
    var phi_1300_: bool;
    var phi_1301_: bool;
    var phi_1302_: bool;
    var phi_1306_: bool;
    var phi_1396_: f32;
    var phi_1399_: f32;
    var phi_1428_: f32;
    var phi_1433_: f32;
    var phi_1434_: bool;
    var phi_1435_: f32;
    var phi_1436_: bool;
    var phi_1440_: f32;
    var phi_1460_: f32;
    var phi_1465_: f32;
    var phi_1466_: bool;
    var phi_1467_: f32;
    var phi_1468_: bool;
    var phi_1472_: f32;
    var phi_1520_: i32;
    var phi_1525_: i32;
    var phi_1530_: i32;
    var phi_1535_: i32;
    var phi_1544_: i32;
    var phi_1549_: i32;
    var phi_1554_: i32;
    var phi_1559_: i32;
    var phi_1654_: bool;
    var phi_1662_: bool;
    var phi_1674_: bool;
    var phi_1675_: bool;
    var phi_1679_: f32;
    var phi_1685_: f32;
    var phi_1687_: evaluate_Verdict;
    var phi_1692_: evaluate_Verdict;
    var phi_1693_: evaluate_Verdict;
    var phi_1697_: bool;
    var phi_1698_: u32;
    var phi_1709_: u32;

    let _e41 = id_1;
    let _e42 = local_3;
    let _e47 = arrayLength((&map.member));
    let _e52 = p.member.size[0u];
    let _e54 = p.member.size[1u];
    let _e55 = lt_shaders_entry_pixel_index(_e41, _e52, _e54);
    if (bitcast<i32>(_e55.root) != 0i) {
        let _e62 = p.member.projection;
        let _e63 = lt_math_OneLevel(_e62);
        let _e67 = samples.member[_e55.first_primitive].normal[0u];
        let _e69 = global[0u];
        if (_e67 == _e69) {
            let _e72 = samples.member[_e55.first_primitive].normal[1u];
            let _e74 = global[1u];
            if (_e72 == _e74) {
                let _e77 = samples.member[_e55.first_primitive].normal[2u];
                let _e79 = global[2u];
                phi_1101_ = (_e77 == _e79);
                phi_1102_ = false;
            } else {
                phi_1101_ = bool();
                phi_1102_ = true;
            }
            let _e82 = phi_1101_;
            let _e84 = phi_1102_;
            phi_1103_ = _e82;
            phi_1104_ = _e84;
        } else {
            phi_1103_ = bool();
            phi_1104_ = true;
        }
        let _e86 = phi_1103_;
        let _e88 = phi_1104_;
        if _e88 {
            phi_1108_ = false;
        } else {
            phi_1108_ = _e86;
        }
        let _e90 = phi_1108_;
        if !(_e90) {
            let _e93 = samples.member[_e55.first_primitive].position;
            let _e95 = p.member.light.place;
            let _e101 = p.member.light.place[3u];
            let _e108 = (_e95.x - (_e93.x * _e101));
            let _e109 = (_e95.y - (_e93.y * _e101));
            let _e110 = (_e95.z - (_e93.z * _e101));
            let _e112 = samples.member[_e55.first_primitive].normal;
            if ((((_e112.x * _e108) + (_e112.y * _e109)) + (_e112.z * _e110)) > 0f) {
                let _e126 = (((_e108 * _e108) + (_e109 * _e109)) + (_e110 * _e110));
                let _e128 = p.member.light.axis;
                let _e140 = p.member.light.place[3u];
                if (_e140 == 0f) {
                    phi_1179_ = true;
                } else {
                    let _e143 = p.member.light.range_squared;
                    if (_e126 <= _e143) {
                        let _e146 = p.member.light.cos_outer;
                        phi_1178_ = (-((((_e108 * _e128.x) + (_e109 * _e128.y)) + (_e110 * _e128.z))) >= (_e146 * sqrt(_e126)));
                    } else {
                        phi_1178_ = false;
                    }
                    let _e151 = phi_1178_;
                    phi_1179_ = _e151;
                }
                let _e153 = phi_1179_;
                if _e153 {
                    let _e155 = samples.member[_e55.first_primitive].flags;
                    let _e163 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e169 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e163.unnamed.visibility, false), _e163.unnamed_1);
                    phi_1190_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e169.unnamed, ((_e155 & 1u) == 0u));
                    phi_1191_ = false;
                } else {
                    phi_1190_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_1191_ = true;
                }
                let _e174 = phi_1190_;
                let _e176 = phi_1191_;
                phi_1192_ = _e174;
                phi_1193_ = _e176;
            } else {
                phi_1192_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_1193_ = true;
            }
            let _e178 = phi_1192_;
            let _e180 = phi_1193_;
            if _e180 {
                let _e186 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e192 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e186.unnamed.visibility, false), _e186.unnamed_1);
                phi_1200_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e192.unnamed, true);
            } else {
                phi_1200_ = _e178;
            }
            let _e197 = phi_1200_;
            phi_1204_ = _e197;
        } else {
            let _e203 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e209 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e203.unnamed.visibility, false), _e203.unnamed_1);
            phi_1204_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e209.unnamed, true);
        }
        let _e214 = phi_1204_;
        if _e214.unnamed_1 {
            phi_1693_ = evaluate_Verdict(_e214.unnamed.visibility, _e214.unnamed.is_doubted);
        } else {
            let _e222 = samples.member[_e55.first_primitive].position;
            let _e240 = ((((_e63.projection.row_w.x * _e222.x) + (_e63.projection.row_w.y * _e222.y)) + (_e63.projection.row_w.z * _e222.z)) + (_e63.projection.row_w.w * 1f));
            let _e254 = (((((_e63.projection.row_x.x * _e222.x) + (_e63.projection.row_x.y * _e222.y)) + (_e63.projection.row_x.z * _e222.z)) + (_e63.projection.row_x.w * 1f)) / _e240);
            let _e268 = (((((_e63.projection.row_y.x * _e222.x) + (_e63.projection.row_y.y * _e222.y)) + (_e63.projection.row_y.z * _e222.z)) + (_e63.projection.row_y.w * 1f)) / _e240);
            let _e281 = ((((_e63.projection.row_z.x * _e222.x) + (_e63.projection.row_z.y * _e222.y)) + (_e63.projection.row_z.z * _e222.z)) + (_e63.projection.row_z.w * 1f));
            if (_e240 > 0f) {
                if (_e254 >= 0f) {
                    phi_1278_ = (_e254 <= 1f);
                } else {
                    phi_1278_ = false;
                }
                let _e286 = phi_1278_;
                if _e286 {
                    if (_e268 >= 0f) {
                        phi_1287_ = (_e268 <= 1f);
                    } else {
                        phi_1287_ = false;
                    }
                    let _e290 = phi_1287_;
                    if _e290 {
                        if (_e281 >= 0f) {
                            phi_1296_ = (_e281 <= 1f);
                        } else {
                            phi_1296_ = false;
                        }
                        let _e294 = phi_1296_;
                        phi_1297_ = _e294;
                        phi_1298_ = false;
                    } else {
                        phi_1297_ = bool();
                        phi_1298_ = true;
                    }
                    let _e296 = phi_1297_;
                    let _e298 = phi_1298_;
                    phi_1299_ = _e296;
                    phi_1300_ = _e298;
                } else {
                    phi_1299_ = bool();
                    phi_1300_ = true;
                }
                let _e300 = phi_1299_;
                let _e302 = phi_1300_;
                phi_1301_ = _e300;
                phi_1302_ = _e302;
            } else {
                phi_1301_ = bool();
                phi_1302_ = true;
            }
            let _e304 = phi_1301_;
            let _e306 = phi_1302_;
            if _e306 {
                phi_1306_ = false;
            } else {
                phi_1306_ = _e304;
            }
            let _e308 = phi_1306_;
            if _e308 {
                if (0f > 0f) {
                    let _e311 = samples.member[_e55.first_primitive].normal;
                    let _e313 = p.member.map_size;
                    let _e383 = ((abs(((((_e62.row_x.x * _e311.x) + (_e62.row_x.y * _e311.y)) + (_e62.row_x.z * _e311.z)) / (((_e62.row_x.x * _e62.row_x.x) + (_e62.row_x.y * _e62.row_x.y)) + (_e62.row_x.z * _e62.row_x.z)))) + abs(((((_e62.row_y.x * _e311.x) + (_e62.row_y.y * _e311.y)) + (_e62.row_y.z * _e311.z)) / (((_e62.row_y.x * _e62.row_y.x) + (_e62.row_y.y * _e62.row_y.y)) + (_e62.row_y.z * _e62.row_y.z))))) / (abs(((((_e62.row_z.x * _e311.x) + (_e62.row_z.y * _e311.y)) + (_e62.row_z.z * _e311.z)) / (((_e62.row_z.x * _e62.row_z.x) + (_e62.row_z.y * _e62.row_z.y)) + (_e62.row_z.z * _e62.row_z.z)))) * f32(_e313)));
                    if (_e383 < 0.002f) {
                        phi_1396_ = _e383;
                    } else {
                        phi_1396_ = 0.002f;
                    }
                    let _e386 = phi_1396_;
                    phi_1399_ = (_e281 - (0f * _e386));
                } else {
                    phi_1399_ = _e281;
                }
                let _e390 = phi_1399_;
                let _e392 = p.member.map_size;
                let _e393 = f32(_e392);
                let _e396 = ((_e254 * _e393) - 0.5f);
                let _e397 = ((_e268 * _e393) - 0.5f);
                if (_e396 > -8388608f) {
                    let _e409 = f32(select(0i, select(select(i32(_e396), i32(-2147483648), (_e396 < bitcast<f32>(3472883712u))), 2147483647i, (_e396 > bitcast<f32>(1325400063u))), (_e396 == _e396)));
                    if (_e409 > _e396) {
                        phi_1428_ = 1f;
                    } else {
                        phi_1428_ = 0f;
                    }
                    let _e412 = phi_1428_;
                    if (_e396 < 8388608f) {
                        phi_1433_ = (_e409 - _e412);
                        phi_1434_ = false;
                    } else {
                        phi_1433_ = f32();
                        phi_1434_ = true;
                    }
                    let _e415 = phi_1433_;
                    let _e417 = phi_1434_;
                    phi_1435_ = _e415;
                    phi_1436_ = _e417;
                } else {
                    phi_1435_ = f32();
                    phi_1436_ = true;
                }
                let _e419 = phi_1435_;
                let _e421 = phi_1436_;
                if _e421 {
                    phi_1440_ = _e396;
                } else {
                    phi_1440_ = _e419;
                }
                let _e423 = phi_1440_;
                if (_e397 > -8388608f) {
                    let _e435 = f32(select(0i, select(select(i32(_e397), i32(-2147483648), (_e397 < bitcast<f32>(3472883712u))), 2147483647i, (_e397 > bitcast<f32>(1325400063u))), (_e397 == _e397)));
                    if (_e435 > _e397) {
                        phi_1460_ = 1f;
                    } else {
                        phi_1460_ = 0f;
                    }
                    let _e438 = phi_1460_;
                    if (_e397 < 8388608f) {
                        phi_1465_ = (_e435 - _e438);
                        phi_1466_ = false;
                    } else {
                        phi_1465_ = f32();
                        phi_1466_ = true;
                    }
                    let _e441 = phi_1465_;
                    let _e443 = phi_1466_;
                    phi_1467_ = _e441;
                    phi_1468_ = _e443;
                } else {
                    phi_1467_ = f32();
                    phi_1468_ = true;
                }
                let _e445 = phi_1467_;
                let _e447 = phi_1468_;
                if _e447 {
                    phi_1472_ = _e397;
                } else {
                    phi_1472_ = _e445;
                }
                let _e449 = phi_1472_;
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
                local_2 = _e480;
                let _e484 = ((0u * _e482) * _e482);
                let _e486 = (bitcast<i32>(_e482) - 1i);
                if (_e460 > 0i) {
                    phi_1520_ = _e460;
                } else {
                    phi_1520_ = 0i;
                }
                let _e489 = phi_1520_;
                if (_e469 > 0i) {
                    phi_1525_ = _e469;
                } else {
                    phi_1525_ = 0i;
                }
                let _e492 = phi_1525_;
                if (_e489 < _e486) {
                    phi_1530_ = _e489;
                } else {
                    phi_1530_ = _e486;
                }
                let _e495 = phi_1530_;
                if (_e492 < _e486) {
                    phi_1535_ = _e492;
                } else {
                    phi_1535_ = _e486;
                }
                let _e498 = phi_1535_;
                let _e499 = bitcast<u32>(_e495);
                let _e501 = (_e460 + 1i);
                let _e502 = (_e469 + 1i);
                if (_e501 > 0i) {
                    phi_1544_ = _e501;
                } else {
                    phi_1544_ = 0i;
                }
                let _e505 = phi_1544_;
                if (_e502 > 0i) {
                    phi_1549_ = _e502;
                } else {
                    phi_1549_ = 0i;
                }
                let _e508 = phi_1549_;
                if (_e505 < _e486) {
                    phi_1554_ = _e505;
                } else {
                    phi_1554_ = _e486;
                }
                let _e511 = phi_1554_;
                if (_e508 < _e486) {
                    phi_1559_ = _e508;
                } else {
                    phi_1559_ = _e486;
                }
                let _e514 = phi_1559_;
                let _e515 = bitcast<u32>(_e511);
                let _e517 = (bitcast<u32>(_e498) * _e482);
                let _e518 = (bitcast<u32>(_e514) * _e482);
                let _e523 = ((_e517 + _e499) + _e484);
                let _e524 = ((_e517 + _e515) + _e484);
                let _e525 = ((_e518 + _e499) + _e484);
                let _e526 = ((_e518 + _e515) + _e484);
                if (_e523 < _e47) {
                } else {
                    return;
                }
                let _e530 = map.member[(0u + _e523)];
                if (_e524 < _e47) {
                } else {
                    return;
                }
                let _e542 = map.member[(0u + _e524)];
                if (_e525 < _e47) {
                } else {
                    return;
                }
                let _e558 = map.member[(0u + _e525)];
                if (_e526 < _e47) {
                } else {
                    return;
                }
                let _e574 = map.member[(0u + _e526)];
                let _e588 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_2), vec4<f32>(((((_e530.x * _e472) + (_e542.x * _e474)) + (_e558.x * _e476)) + (_e574.x * _e477)), ((((_e530.y * _e472) + (_e542.y * _e474)) + (_e558.y * _e476)) + (_e574.y * _e477)), ((((_e530.z * _e472) + (_e542.z * _e474)) + (_e558.z * _e476)) + (_e574.z * _e477)), ((((_e530.w * _e472) + (_e542.w * _e474)) + (_e558.w * _e476)) + (_e574.w * _e477))), _e390);
                let _e590 = p.member.epsilon;
                if (_e588 <= _e590) {
                    phi_1654_ = true;
                } else {
                    phi_1654_ = (_e588 >= (1f - _e590));
                }
                let _e595 = phi_1654_;
                if ((bitcast<u32>(_e588) & 2147483647u) > 2139095040u) {
                    phi_1662_ = true;
                } else {
                    phi_1662_ = !(_e595);
                }
                let _e601 = phi_1662_;
                if _e601 {
                    if (_e588 > 0f) {
                        if (_e588 < 1f) {
                            phi_1674_ = false;
                        } else {
                            phi_1674_ = true;
                        }
                        let _e605 = phi_1674_;
                        phi_1675_ = _e605;
                    } else {
                        phi_1675_ = true;
                    }
                    let _e607 = phi_1675_;
                    if _e607 {
                        phi_1679_ = 0.5f;
                    } else {
                        phi_1679_ = _e588;
                    }
                    let _e609 = phi_1679_;
                    phi_1687_ = evaluate_Verdict(_e609, true);
                } else {
                    if (_e588 > 0.5f) {
                        phi_1685_ = 1f;
                    } else {
                        phi_1685_ = 0f;
                    }
                    let _e613 = phi_1685_;
                    phi_1687_ = evaluate_Verdict(_e613, false);
                }
                let _e616 = phi_1687_;
                phi_1692_ = evaluate_Verdict(_e616.visibility, _e616.is_doubted);
            } else {
                phi_1692_ = evaluate_Verdict(0.5f, true);
            }
            let _e622 = phi_1692_;
            phi_1693_ = _e622;
        }
        let _e624 = phi_1693_;
        visibility.member[_e55.first_primitive] = _e624.visibility;
        phi_1697_ = _e624.is_doubted;
        phi_1698_ = _e55.first_primitive;
    } else {
        phi_1697_ = false;
        phi_1698_ = 0u;
    }
    let _e629 = phi_1697_;
    let _e631 = phi_1698_;
    if (_e42 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e629 {
        let _e635 = atomicAdd((&shared_[0u]), 1u);
        phi_1709_ = _e635;
    } else {
        phi_1709_ = 0u;
    }
    let _e637 = phi_1709_;
    workgroupBarrier();
    if (_e42 == 0u) {
        let _e641 = atomicLoad((&shared_[0u]));
        let _e642 = atomicAdd((&list.member[3u]), _e641);
        atomicStore((&shared_[1u]), _e642);
    }
    workgroupBarrier();
    if _e629 {
        let _e645 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e645) + _e637)]), _e631);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_msm_hausdorff_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_3 = local;
    function_();
}
