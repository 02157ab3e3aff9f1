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

struct type_23 {
    member: array<abi_Sample>,
}

struct type_27 {
    member: array<f32>,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
}

struct type_36 {
    member: array<vec4<f32>>,
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

struct type_40 {
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

struct type_50 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_23;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_40;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_27;
var<private> local_3: u32;
@group(0) @binding(4) 
var<storage, read_write> list: type_50;
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(2) 
var<storage> map: type_36;

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
        let _e53 = phi_159_;
        let _e55 = phi_160_;
        phi_161_ = _e53;
        phi_162_ = _e55;
    } else {
        phi_161_ = lt_bvh_traverse_Tree();
        phi_162_ = true;
    }
    let _e57 = phi_161_;
    let _e59 = phi_162_;
    if _e59 {
        phi_167_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_167_ = _e57;
    }
    let _e64 = phi_167_;
    return lt_bvh_traverse_Tree(_e64.root, _e64.first_primitive);
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn lt_math_hausdorff_cubic_mass(param_4: vec4<f32>, param_5: f32, param_6: f32, param_7: f32, param_8: f32) -> f32 {
    return ((((param_4.z - (((param_6 + param_7) + param_8) * param_4.y)) + ((((param_6 * param_7) + (param_6 * param_8)) + (param_7 * param_8)) * param_4.x)) - ((param_6 * param_7) * param_8)) / (((param_5 - param_6) * (param_5 - param_7)) * (param_5 - param_8)));
}

fn lt_math_hausdorff_endpoint_upper_bound(param_9: ptr<function, hankel_HankelFactors>, param_10: f32) -> f32 {
    var phi_937_: f32;
    var phi_938_: f32;
    var phi_939_: f32;
    var phi_966_: f32;
    var phi_967_: f32;
    var phi_968_: f32;
    var phi_969_: f32;
    var phi_970_: bool;
    var phi_971_: f32;
    var phi_972_: bool;
    var phi_1000_: f32;
    var phi_1001_: f32;
    var phi_1002_: f32;
    var phi_1003_: f32;
    var phi_1004_: bool;
    var phi_1005_: f32;
    var phi_1006_: bool;
    var phi_1013_: f32;
    var phi_1014_: f32;
    var phi_1015_: f32;
    var phi_1016_: f32;

    let _e43 = (*param_9).moments;
    if (param_10 < 0.0001f) {
        phi_1016_ = 1f;
    } else {
        let _e52 = ((_e43.z - ((1f + param_10) * _e43.y)) + (param_10 * _e43.x));
        let _e61 = (((_e43.w - ((1f + param_10) * _e43.z)) + (param_10 * _e43.y)) / _e52);
        if (abs(_e52) <= 0.00000047683716f) {
            let _e75 = (1f - (((_e43.y - (_e43.x * (param_10 + 1f))) + (param_10 * 1f)) / ((0f - param_10) * (0f - 1f))));
            if ((bitcast<u32>(_e75) & 2147483647u) > 2139095040u) {
                phi_939_ = _e75;
            } else {
                if (_e75 < 0f) {
                    phi_938_ = 0f;
                } else {
                    if (_e75 > 1f) {
                        phi_937_ = 1f;
                    } else {
                        phi_937_ = _e75;
                    }
                    let _e82 = phi_937_;
                    phi_938_ = _e82;
                }
                let _e84 = phi_938_;
                phi_939_ = _e84;
            }
            let _e86 = phi_939_;
            phi_1015_ = _e86;
        } else {
            if (_e61 > 0f) {
                if (_e61 < param_10) {
                    let _e89 = lt_math_hausdorff_cubic_mass(_e43, 0f, _e61, param_10, 1f);
                    let _e91 = lt_math_hausdorff_cubic_mass(_e43, _e61, 0f, param_10, 1f);
                    let _e92 = ((1f - _e89) - _e91);
                    if ((bitcast<u32>(_e92) & 2147483647u) > 2139095040u) {
                        phi_968_ = _e92;
                    } else {
                        if (_e92 < 0f) {
                            phi_967_ = 0f;
                        } else {
                            if (_e92 > 1f) {
                                phi_966_ = 1f;
                            } else {
                                phi_966_ = _e92;
                            }
                            let _e99 = phi_966_;
                            phi_967_ = _e99;
                        }
                        let _e101 = phi_967_;
                        phi_968_ = _e101;
                    }
                    let _e103 = phi_968_;
                    phi_969_ = _e103;
                    phi_970_ = false;
                } else {
                    phi_969_ = f32();
                    phi_970_ = true;
                }
                let _e105 = phi_969_;
                let _e107 = phi_970_;
                phi_971_ = _e105;
                phi_972_ = _e107;
            } else {
                phi_971_ = f32();
                phi_972_ = true;
            }
            let _e109 = phi_971_;
            let _e111 = phi_972_;
            if _e111 {
                if (_e61 > param_10) {
                    if (_e61 < 1f) {
                        let _e114 = lt_math_hausdorff_cubic_mass(_e43, 0f, _e61, param_10, 1f);
                        let _e115 = (1f - _e114);
                        if ((bitcast<u32>(_e115) & 2147483647u) > 2139095040u) {
                            phi_1002_ = _e115;
                        } else {
                            if (_e115 < 0f) {
                                phi_1001_ = 0f;
                            } else {
                                if (_e115 > 1f) {
                                    phi_1000_ = 1f;
                                } else {
                                    phi_1000_ = _e115;
                                }
                                let _e122 = phi_1000_;
                                phi_1001_ = _e122;
                            }
                            let _e124 = phi_1001_;
                            phi_1002_ = _e124;
                        }
                        let _e126 = phi_1002_;
                        phi_1003_ = _e126;
                        phi_1004_ = false;
                    } else {
                        phi_1003_ = f32();
                        phi_1004_ = true;
                    }
                    let _e128 = phi_1003_;
                    let _e130 = phi_1004_;
                    phi_1005_ = _e128;
                    phi_1006_ = _e130;
                } else {
                    phi_1005_ = f32();
                    phi_1006_ = true;
                }
                let _e132 = phi_1005_;
                let _e134 = phi_1006_;
                if _e134 {
                    phi_1013_ = bitcast<f32>((bitcast<u32>(_e61) | 2143289344u));
                } else {
                    phi_1013_ = _e132;
                }
                let _e139 = phi_1013_;
                phi_1014_ = _e139;
            } else {
                phi_1014_ = _e109;
            }
            let _e141 = phi_1014_;
            phi_1015_ = _e141;
        }
        let _e143 = phi_1015_;
        phi_1016_ = _e143;
    }
    let _e145 = phi_1016_;
    return _e145;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_11: ptr<function, f32>, param_12: vec4<f32>, param_13: f32) -> f32 {
    var local_1: hankel_HankelFactors;
    var phi_224_: f32;
    var phi_225_: f32;
    var phi_226_: f32;
    var phi_238_: bool;
    var phi_253_: bool;
    var phi_278_: f32;
    var phi_279_: f32;
    var phi_280_: f32;
    var phi_281_: f32;
    var phi_282_: bool;
    var phi_283_: f32;
    var phi_284_: bool;
    var phi_340_: vec2<f32>;
    var phi_378_: f32;
    var phi_379_: f32;
    var phi_380_: f32;
    var phi_413_: f32;
    var phi_414_: f32;
    var phi_415_: f32;
    var phi_419_: f32;
    var phi_420_: f32;
    var phi_421_: f32;
    var phi_422_: f32;
    var phi_475_: vec2<f32>;
    var phi_497_: bool;
    var phi_522_: f32;
    var phi_523_: f32;
    var phi_524_: f32;
    var phi_525_: f32;
    var phi_526_: bool;
    var phi_527_: f32;
    var phi_528_: bool;
    var phi_584_: vec2<f32>;
    var phi_622_: f32;
    var phi_623_: f32;
    var phi_624_: f32;
    var phi_657_: f32;
    var phi_658_: f32;
    var phi_659_: f32;
    var phi_663_: f32;
    var phi_664_: f32;
    var phi_665_: f32;
    var phi_666_: f32;
    var phi_667_: f32;
    var phi_668_: bool;
    var phi_669_: f32;
    var phi_670_: bool;
    var phi_692_: bool;
    var phi_717_: f32;
    var phi_718_: f32;
    var phi_719_: f32;
    var phi_720_: f32;
    var phi_721_: bool;
    var phi_722_: f32;
    var phi_723_: bool;
    var phi_779_: vec2<f32>;
    var phi_817_: f32;
    var phi_818_: f32;
    var phi_819_: f32;
    var phi_852_: f32;
    var phi_853_: f32;
    var phi_854_: f32;
    var phi_858_: f32;
    var phi_859_: f32;
    var phi_860_: f32;
    var phi_861_: f32;
    var phi_872_: bool;
    var phi_876_: f32;
    var phi_877_: f32;
    var phi_878_: f32;
    var phi_879_: f32;

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
        phi_226_ = param_13;
    } else {
        if (param_13 < 0f) {
            phi_225_ = 0f;
        } else {
            if (param_13 > 1f) {
                phi_224_ = 1f;
            } else {
                phi_224_ = param_13;
            }
            let _e81 = phi_224_;
            phi_225_ = _e81;
        }
        let _e83 = phi_225_;
        phi_226_ = _e83;
    }
    let _e85 = phi_226_;
    let _e88 = local_1.moments[0u];
    let _e91 = local_1.moments[3u];
    if (_e88 == _e91) {
        let _e95 = local_1.moments[0u];
        phi_238_ = (_e95 > 0.5f);
    } else {
        phi_238_ = false;
    }
    let _e98 = phi_238_;
    if _e98 {
        let _e101 = local_1.moments[0u];
        let _e104 = local_1.moments[3u];
        if (_e101 == _e104) {
            let _e108 = local_1.moments[0u];
            phi_253_ = (_e108 > 0.5f);
        } else {
            phi_253_ = false;
        }
        let _e111 = phi_253_;
        if _e111 {
            if (_e85 > 0f) {
                let _e114 = local_1.moments;
                if ((bitcast<u32>(_e114.x) & 2147483647u) > 2139095040u) {
                    phi_280_ = _e114.x;
                } else {
                    if (_e114.x < 0f) {
                        phi_279_ = 0f;
                    } else {
                        if (_e114.x > 1f) {
                            phi_278_ = 1f;
                        } else {
                            phi_278_ = _e114.x;
                        }
                        let _e122 = phi_278_;
                        phi_279_ = _e122;
                    }
                    let _e124 = phi_279_;
                    phi_280_ = _e124;
                }
                let _e126 = phi_280_;
                phi_281_ = _e126;
                phi_282_ = false;
            } else {
                phi_281_ = f32();
                phi_282_ = true;
            }
            let _e128 = phi_281_;
            let _e130 = phi_282_;
            phi_283_ = _e128;
            phi_284_ = _e130;
        } else {
            phi_283_ = f32();
            phi_284_ = true;
        }
        let _e132 = phi_283_;
        let _e134 = phi_284_;
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
                phi_340_ = vec2<f32>((-(_e173) - _e178), (-(_e173) + _e178));
            } else {
                phi_340_ = vec2(bitcast<f32>((bitcast<u32>(_e176) | 2143289344u)));
            }
            let _e189 = phi_340_;
            if (_e85 <= _e189.x) {
                phi_421_ = 1f;
            } else {
                if (_e85 > _e189.y) {
                    let _e195 = local_1.moments;
                    let _e206 = (((_e195.y - (_e195.x * (_e189.x + _e189.y))) + (_e189.x * _e189.y)) / ((_e85 - _e189.x) * (_e85 - _e189.y)));
                    if ((bitcast<u32>(_e206) & 2147483647u) > 2139095040u) {
                        phi_380_ = _e206;
                    } else {
                        if (_e206 < 0f) {
                            phi_379_ = 0f;
                        } else {
                            if (_e206 > 1f) {
                                phi_378_ = 1f;
                            } else {
                                phi_378_ = _e206;
                            }
                            let _e213 = phi_378_;
                            phi_379_ = _e213;
                        }
                        let _e215 = phi_379_;
                        phi_380_ = _e215;
                    }
                    let _e217 = phi_380_;
                    phi_420_ = _e217;
                } else {
                    if (_e85 > _e189.x) {
                        let _e220 = local_1.moments;
                        let _e232 = (1f - (((_e220.y - (_e220.x * (_e85 + _e189.y))) + (_e85 * _e189.y)) / ((_e189.x - _e85) * (_e189.x - _e189.y))));
                        if ((bitcast<u32>(_e232) & 2147483647u) > 2139095040u) {
                            phi_415_ = _e232;
                        } else {
                            if (_e232 < 0f) {
                                phi_414_ = 0f;
                            } else {
                                if (_e232 > 1f) {
                                    phi_413_ = 1f;
                                } else {
                                    phi_413_ = _e232;
                                }
                                let _e239 = phi_413_;
                                phi_414_ = _e239;
                            }
                            let _e241 = phi_414_;
                            phi_415_ = _e241;
                        }
                        let _e243 = phi_415_;
                        phi_419_ = _e243;
                    } else {
                        phi_419_ = bitcast<f32>((bitcast<u32>(_e189.x) | 2143289344u));
                    }
                    let _e248 = phi_419_;
                    phi_420_ = _e248;
                }
                let _e250 = phi_420_;
                phi_421_ = _e250;
            }
            let _e252 = phi_421_;
            phi_422_ = _e252;
        } else {
            phi_422_ = _e132;
        }
        let _e254 = phi_422_;
        phi_879_ = _e254;
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
            phi_475_ = vec2<f32>((-(_e293) - _e298), (-(_e293) + _e298));
        } else {
            phi_475_ = vec2(bitcast<f32>((bitcast<u32>(_e296) | 2143289344u)));
        }
        let _e309 = phi_475_;
        if (_e309.x >= 0f) {
            if (_e309.y <= 1f) {
                let _e316 = local_1.moments[0u];
                let _e319 = local_1.moments[3u];
                if (_e316 == _e319) {
                    let _e323 = local_1.moments[0u];
                    phi_497_ = (_e323 > 0.5f);
                } else {
                    phi_497_ = false;
                }
                let _e326 = phi_497_;
                if _e326 {
                    if (_e85 > 0f) {
                        let _e329 = local_1.moments;
                        if ((bitcast<u32>(_e329.x) & 2147483647u) > 2139095040u) {
                            phi_524_ = _e329.x;
                        } else {
                            if (_e329.x < 0f) {
                                phi_523_ = 0f;
                            } else {
                                if (_e329.x > 1f) {
                                    phi_522_ = 1f;
                                } else {
                                    phi_522_ = _e329.x;
                                }
                                let _e337 = phi_522_;
                                phi_523_ = _e337;
                            }
                            let _e339 = phi_523_;
                            phi_524_ = _e339;
                        }
                        let _e341 = phi_524_;
                        phi_525_ = _e341;
                        phi_526_ = false;
                    } else {
                        phi_525_ = f32();
                        phi_526_ = true;
                    }
                    let _e343 = phi_525_;
                    let _e345 = phi_526_;
                    phi_527_ = _e343;
                    phi_528_ = _e345;
                } else {
                    phi_527_ = f32();
                    phi_528_ = true;
                }
                let _e347 = phi_527_;
                let _e349 = phi_528_;
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
                        phi_584_ = vec2<f32>((-(_e388) - _e393), (-(_e388) + _e393));
                    } else {
                        phi_584_ = vec2(bitcast<f32>((bitcast<u32>(_e391) | 2143289344u)));
                    }
                    let _e404 = phi_584_;
                    if (_e85 <= _e404.x) {
                        phi_665_ = 1f;
                    } else {
                        if (_e85 > _e404.y) {
                            let _e410 = local_1.moments;
                            let _e421 = (((_e410.y - (_e410.x * (_e404.x + _e404.y))) + (_e404.x * _e404.y)) / ((_e85 - _e404.x) * (_e85 - _e404.y)));
                            if ((bitcast<u32>(_e421) & 2147483647u) > 2139095040u) {
                                phi_624_ = _e421;
                            } else {
                                if (_e421 < 0f) {
                                    phi_623_ = 0f;
                                } else {
                                    if (_e421 > 1f) {
                                        phi_622_ = 1f;
                                    } else {
                                        phi_622_ = _e421;
                                    }
                                    let _e428 = phi_622_;
                                    phi_623_ = _e428;
                                }
                                let _e430 = phi_623_;
                                phi_624_ = _e430;
                            }
                            let _e432 = phi_624_;
                            phi_664_ = _e432;
                        } else {
                            if (_e85 > _e404.x) {
                                let _e435 = local_1.moments;
                                let _e447 = (1f - (((_e435.y - (_e435.x * (_e85 + _e404.y))) + (_e85 * _e404.y)) / ((_e404.x - _e85) * (_e404.x - _e404.y))));
                                if ((bitcast<u32>(_e447) & 2147483647u) > 2139095040u) {
                                    phi_659_ = _e447;
                                } else {
                                    if (_e447 < 0f) {
                                        phi_658_ = 0f;
                                    } else {
                                        if (_e447 > 1f) {
                                            phi_657_ = 1f;
                                        } else {
                                            phi_657_ = _e447;
                                        }
                                        let _e454 = phi_657_;
                                        phi_658_ = _e454;
                                    }
                                    let _e456 = phi_658_;
                                    phi_659_ = _e456;
                                }
                                let _e458 = phi_659_;
                                phi_663_ = _e458;
                            } else {
                                phi_663_ = bitcast<f32>((bitcast<u32>(_e404.x) | 2143289344u));
                            }
                            let _e463 = phi_663_;
                            phi_664_ = _e463;
                        }
                        let _e465 = phi_664_;
                        phi_665_ = _e465;
                    }
                    let _e467 = phi_665_;
                    phi_666_ = _e467;
                } else {
                    phi_666_ = _e347;
                }
                let _e469 = phi_666_;
                phi_667_ = _e469;
                phi_668_ = false;
            } else {
                phi_667_ = f32();
                phi_668_ = true;
            }
            let _e471 = phi_667_;
            let _e473 = phi_668_;
            phi_669_ = _e471;
            phi_670_ = _e473;
        } else {
            phi_669_ = f32();
            phi_670_ = true;
        }
        let _e475 = phi_669_;
        let _e477 = phi_670_;
        if _e477 {
            if ((bitcast<u32>(_e309.x) & 2147483647u) > 2139095040u) {
                phi_877_ = _e309.x;
            } else {
                let _e481 = lt_math_hausdorff_endpoint_upper_bound((&local_1), _e85);
                let _e484 = local_1.moments[0u];
                let _e487 = local_1.moments[3u];
                if (_e484 == _e487) {
                    let _e491 = local_1.moments[0u];
                    phi_692_ = (_e491 > 0.5f);
                } else {
                    phi_692_ = false;
                }
                let _e494 = phi_692_;
                if _e494 {
                    if (_e85 > 0f) {
                        let _e497 = local_1.moments;
                        if ((bitcast<u32>(_e497.x) & 2147483647u) > 2139095040u) {
                            phi_719_ = _e497.x;
                        } else {
                            if (_e497.x < 0f) {
                                phi_718_ = 0f;
                            } else {
                                if (_e497.x > 1f) {
                                    phi_717_ = 1f;
                                } else {
                                    phi_717_ = _e497.x;
                                }
                                let _e505 = phi_717_;
                                phi_718_ = _e505;
                            }
                            let _e507 = phi_718_;
                            phi_719_ = _e507;
                        }
                        let _e509 = phi_719_;
                        phi_720_ = _e509;
                        phi_721_ = false;
                    } else {
                        phi_720_ = f32();
                        phi_721_ = true;
                    }
                    let _e511 = phi_720_;
                    let _e513 = phi_721_;
                    phi_722_ = _e511;
                    phi_723_ = _e513;
                } else {
                    phi_722_ = f32();
                    phi_723_ = true;
                }
                let _e515 = phi_722_;
                let _e517 = phi_723_;
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
                        phi_779_ = vec2<f32>((-(_e556) - _e561), (-(_e556) + _e561));
                    } else {
                        phi_779_ = vec2(bitcast<f32>((bitcast<u32>(_e559) | 2143289344u)));
                    }
                    let _e572 = phi_779_;
                    if (_e85 <= _e572.x) {
                        phi_860_ = 1f;
                    } else {
                        if (_e85 > _e572.y) {
                            let _e578 = local_1.moments;
                            let _e589 = (((_e578.y - (_e578.x * (_e572.x + _e572.y))) + (_e572.x * _e572.y)) / ((_e85 - _e572.x) * (_e85 - _e572.y)));
                            if ((bitcast<u32>(_e589) & 2147483647u) > 2139095040u) {
                                phi_819_ = _e589;
                            } else {
                                if (_e589 < 0f) {
                                    phi_818_ = 0f;
                                } else {
                                    if (_e589 > 1f) {
                                        phi_817_ = 1f;
                                    } else {
                                        phi_817_ = _e589;
                                    }
                                    let _e596 = phi_817_;
                                    phi_818_ = _e596;
                                }
                                let _e598 = phi_818_;
                                phi_819_ = _e598;
                            }
                            let _e600 = phi_819_;
                            phi_859_ = _e600;
                        } else {
                            if (_e85 > _e572.x) {
                                let _e603 = local_1.moments;
                                let _e615 = (1f - (((_e603.y - (_e603.x * (_e85 + _e572.y))) + (_e85 * _e572.y)) / ((_e572.x - _e85) * (_e572.x - _e572.y))));
                                if ((bitcast<u32>(_e615) & 2147483647u) > 2139095040u) {
                                    phi_854_ = _e615;
                                } else {
                                    if (_e615 < 0f) {
                                        phi_853_ = 0f;
                                    } else {
                                        if (_e615 > 1f) {
                                            phi_852_ = 1f;
                                        } else {
                                            phi_852_ = _e615;
                                        }
                                        let _e622 = phi_852_;
                                        phi_853_ = _e622;
                                    }
                                    let _e624 = phi_853_;
                                    phi_854_ = _e624;
                                }
                                let _e626 = phi_854_;
                                phi_858_ = _e626;
                            } else {
                                phi_858_ = bitcast<f32>((bitcast<u32>(_e572.x) | 2143289344u));
                            }
                            let _e631 = phi_858_;
                            phi_859_ = _e631;
                        }
                        let _e633 = phi_859_;
                        phi_860_ = _e633;
                    }
                    let _e635 = phi_860_;
                    phi_861_ = _e635;
                } else {
                    phi_861_ = _e515;
                }
                let _e637 = phi_861_;
                if ((bitcast<u32>(_e637) & 2147483647u) > 2139095040u) {
                    phi_872_ = true;
                } else {
                    let _e641 = (_e637 < _e481);
                    if _e641 {
                    }
                    phi_872_ = _e641;
                }
                let _e643 = phi_872_;
                if _e643 {
                    phi_876_ = _e637;
                } else {
                    phi_876_ = _e481;
                }
                let _e645 = phi_876_;
                phi_877_ = _e645;
            }
            let _e647 = phi_877_;
            phi_878_ = _e647;
        } else {
            phi_878_ = _e475;
        }
        let _e649 = phi_878_;
        phi_879_ = _e649;
    }
    let _e651 = phi_879_;
    return _e651;
}

fn function_() {
    var local_2: f32;
    var phi_1099_: bool;
    var phi_1100_: bool;
    var phi_1101_: bool;
    var phi_1102_: bool;
    var phi_1106_: bool;
    var phi_1150_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1154_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1231_: bool;
    var phi_1240_: bool;
    var phi_1249_: bool;
    var phi_1250_: bool;
    var phi_1251_: bool;
    var phi_1252_: bool;
    var phi_1253_: bool;
    var phi_1254_: bool;
    var phi_1255_: bool;
    var phi_1259_: bool;
    var phi_1353_: f32;
    var phi_1356_: f32;
    var phi_1385_: f32;
    var phi_1390_: f32;
    var phi_1391_: bool;
    var phi_1392_: f32;
    var phi_1393_: bool;
    var phi_1397_: f32;
    var phi_1417_: f32;
    var phi_1422_: f32;
    var phi_1423_: bool;
    var phi_1424_: f32;
    var phi_1425_: bool;
    var phi_1429_: f32;
    var phi_1475_: i32;
    var phi_1480_: i32;
    var phi_1485_: i32;
    var phi_1490_: i32;
    var phi_1499_: i32;
    var phi_1504_: i32;
    var phi_1509_: i32;
    var phi_1514_: i32;
    var phi_1605_: bool;
    var phi_1613_: bool;
    var phi_1618_: f32;
    var phi_1621_: evaluate_Verdict;
    var phi_1622_: evaluate_Verdict;
    var phi_1626_: bool;
    var phi_1627_: u32;
    var phi_1633_: u32;

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
                phi_1099_ = (_e77 == _e79);
                phi_1100_ = false;
            } else {
                phi_1099_ = bool();
                phi_1100_ = true;
            }
            let _e82 = phi_1099_;
            let _e84 = phi_1100_;
            phi_1101_ = _e82;
            phi_1102_ = _e84;
        } else {
            phi_1101_ = bool();
            phi_1102_ = true;
        }
        let _e86 = phi_1101_;
        let _e88 = phi_1102_;
        if _e88 {
            phi_1106_ = false;
        } else {
            phi_1106_ = _e86;
        }
        let _e90 = phi_1106_;
        if !(_e90) {
            let _e93 = samples.member[_e57.first_primitive].normal;
            let _e95 = samples.member[_e57.first_primitive].position;
            if ((((_e93.x * (_e64.x - (_e95.x * _e64.w))) + (_e93.y * (_e64.y - (_e95.y * _e64.w)))) + (_e93.z * (_e64.z - (_e95.z * _e64.w)))) > 0f) {
                let _e119 = samples.member[_e57.first_primitive].flags;
                let _e127 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e133 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e127.unnamed.visibility, false), _e127.unnamed_1);
                phi_1150_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e133.unnamed, ((_e119 & 1u) == 0u));
            } else {
                let _e142 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e148 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e142.unnamed.visibility, false), _e142.unnamed_1);
                phi_1150_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e148.unnamed, true);
            }
            let _e153 = phi_1150_;
            phi_1154_ = _e153;
        } else {
            let _e159 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e165 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e159.unnamed.visibility, false), _e159.unnamed_1);
            phi_1154_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e165.unnamed, true);
        }
        let _e170 = phi_1154_;
        if _e170.unnamed_1 {
            phi_1622_ = evaluate_Verdict(_e170.unnamed.visibility, _e170.unnamed.is_doubted);
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
                    phi_1231_ = (_e209 <= 1f);
                } else {
                    phi_1231_ = false;
                }
                let _e241 = phi_1231_;
                if _e241 {
                    if (_e223 >= 0f) {
                        phi_1240_ = (_e223 <= 1f);
                    } else {
                        phi_1240_ = false;
                    }
                    let _e245 = phi_1240_;
                    if _e245 {
                        if (_e236 >= 0f) {
                            phi_1249_ = (_e236 <= 1f);
                        } else {
                            phi_1249_ = false;
                        }
                        let _e249 = phi_1249_;
                        phi_1250_ = _e249;
                        phi_1251_ = false;
                    } else {
                        phi_1250_ = bool();
                        phi_1251_ = true;
                    }
                    let _e251 = phi_1250_;
                    let _e253 = phi_1251_;
                    phi_1252_ = _e251;
                    phi_1253_ = _e253;
                } else {
                    phi_1252_ = bool();
                    phi_1253_ = true;
                }
                let _e255 = phi_1252_;
                let _e257 = phi_1253_;
                phi_1254_ = _e255;
                phi_1255_ = _e257;
            } else {
                phi_1254_ = bool();
                phi_1255_ = true;
            }
            let _e259 = phi_1254_;
            let _e261 = phi_1255_;
            if _e261 {
                phi_1259_ = false;
            } else {
                phi_1259_ = _e259;
            }
            let _e263 = phi_1259_;
            if _e263 {
                if (0f > 0f) {
                    let _e266 = samples.member[_e57.first_primitive].normal;
                    let _e268 = p.member.map_size;
                    let _e271 = p.member.projection.row_x;
                    let _e293 = p.member.projection.row_y;
                    let _e315 = p.member.projection.row_z;
                    let _e342 = ((abs(((((_e271.x * _e266.x) + (_e271.y * _e266.y)) + (_e271.z * _e266.z)) / (((_e271.x * _e271.x) + (_e271.y * _e271.y)) + (_e271.z * _e271.z)))) + abs(((((_e293.x * _e266.x) + (_e293.y * _e266.y)) + (_e293.z * _e266.z)) / (((_e293.x * _e293.x) + (_e293.y * _e293.y)) + (_e293.z * _e293.z))))) / (abs(((((_e315.x * _e266.x) + (_e315.y * _e266.y)) + (_e315.z * _e266.z)) / (((_e315.x * _e315.x) + (_e315.y * _e315.y)) + (_e315.z * _e315.z)))) * f32(_e268)));
                    if (_e342 < 0.002f) {
                        phi_1353_ = _e342;
                    } else {
                        phi_1353_ = 0.002f;
                    }
                    let _e345 = phi_1353_;
                    phi_1356_ = (_e236 - (0f * _e345));
                } else {
                    phi_1356_ = _e236;
                }
                let _e349 = phi_1356_;
                let _e351 = p.member.map_size;
                let _e352 = f32(_e351);
                let _e355 = ((_e209 * _e352) - 0.5f);
                let _e356 = ((_e223 * _e352) - 0.5f);
                if (_e355 > -8388608f) {
                    let _e368 = f32(select(0i, select(select(i32(_e355), i32(-2147483648), (_e355 < bitcast<f32>(3472883712u))), 2147483647i, (_e355 > bitcast<f32>(1325400063u))), (_e355 == _e355)));
                    if (_e368 > _e355) {
                        phi_1385_ = 1f;
                    } else {
                        phi_1385_ = 0f;
                    }
                    let _e371 = phi_1385_;
                    if (_e355 < 8388608f) {
                        phi_1390_ = (_e368 - _e371);
                        phi_1391_ = false;
                    } else {
                        phi_1390_ = f32();
                        phi_1391_ = true;
                    }
                    let _e374 = phi_1390_;
                    let _e376 = phi_1391_;
                    phi_1392_ = _e374;
                    phi_1393_ = _e376;
                } else {
                    phi_1392_ = f32();
                    phi_1393_ = true;
                }
                let _e378 = phi_1392_;
                let _e380 = phi_1393_;
                if _e380 {
                    phi_1397_ = _e355;
                } else {
                    phi_1397_ = _e378;
                }
                let _e382 = phi_1397_;
                if (_e356 > -8388608f) {
                    let _e394 = f32(select(0i, select(select(i32(_e356), i32(-2147483648), (_e356 < bitcast<f32>(3472883712u))), 2147483647i, (_e356 > bitcast<f32>(1325400063u))), (_e356 == _e356)));
                    if (_e394 > _e356) {
                        phi_1417_ = 1f;
                    } else {
                        phi_1417_ = 0f;
                    }
                    let _e397 = phi_1417_;
                    if (_e356 < 8388608f) {
                        phi_1422_ = (_e394 - _e397);
                        phi_1423_ = false;
                    } else {
                        phi_1422_ = f32();
                        phi_1423_ = true;
                    }
                    let _e400 = phi_1422_;
                    let _e402 = phi_1423_;
                    phi_1424_ = _e400;
                    phi_1425_ = _e402;
                } else {
                    phi_1424_ = f32();
                    phi_1425_ = true;
                }
                let _e404 = phi_1424_;
                let _e406 = phi_1425_;
                if _e406 {
                    phi_1429_ = _e356;
                } else {
                    phi_1429_ = _e404;
                }
                let _e408 = phi_1429_;
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
                    phi_1475_ = _e419;
                } else {
                    phi_1475_ = 0i;
                }
                let _e446 = phi_1475_;
                if (_e428 > 0i) {
                    phi_1480_ = _e428;
                } else {
                    phi_1480_ = 0i;
                }
                let _e449 = phi_1480_;
                if (_e446 < _e443) {
                    phi_1485_ = _e446;
                } else {
                    phi_1485_ = _e443;
                }
                let _e452 = phi_1485_;
                if (_e449 < _e443) {
                    phi_1490_ = _e449;
                } else {
                    phi_1490_ = _e443;
                }
                let _e455 = phi_1490_;
                let _e456 = bitcast<u32>(_e452);
                let _e458 = (_e419 + 1i);
                let _e459 = (_e428 + 1i);
                if (_e458 > 0i) {
                    phi_1499_ = _e458;
                } else {
                    phi_1499_ = 0i;
                }
                let _e462 = phi_1499_;
                if (_e459 > 0i) {
                    phi_1504_ = _e459;
                } else {
                    phi_1504_ = 0i;
                }
                let _e465 = phi_1504_;
                if (_e462 < _e443) {
                    phi_1509_ = _e462;
                } else {
                    phi_1509_ = _e443;
                }
                let _e468 = phi_1509_;
                if (_e465 < _e443) {
                    phi_1514_ = _e465;
                } else {
                    phi_1514_ = _e443;
                }
                let _e471 = phi_1514_;
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
                let _e495 = map.member[(0u + _e477)];
                if (_e478 < _e47) {
                } else {
                    return;
                }
                let _e511 = map.member[(0u + _e478)];
                if (_e479 < _e47) {
                } else {
                    return;
                }
                let _e527 = map.member[(0u + _e479)];
                let _e541 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_2), vec4<f32>(((((_e483.x * _e431) + (_e495.x * _e433)) + (_e511.x * _e435)) + (_e527.x * _e436)), ((((_e483.y * _e431) + (_e495.y * _e433)) + (_e511.y * _e435)) + (_e527.y * _e436)), ((((_e483.z * _e431) + (_e495.z * _e433)) + (_e511.z * _e435)) + (_e527.z * _e436)), ((((_e483.w * _e431) + (_e495.w * _e433)) + (_e511.w * _e435)) + (_e527.w * _e436))), _e349);
                let _e543 = p.member.epsilon;
                if (_e541 <= _e543) {
                    phi_1605_ = true;
                } else {
                    phi_1605_ = (_e541 >= (1f - _e543));
                }
                let _e548 = phi_1605_;
                if ((bitcast<u32>(_e541) & 2147483647u) > 2139095040u) {
                    phi_1613_ = true;
                } else {
                    phi_1613_ = !(_e548);
                }
                let _e554 = phi_1613_;
                if (_e541 > 0.5f) {
                    phi_1618_ = 1f;
                } else {
                    phi_1618_ = 0f;
                }
                let _e557 = phi_1618_;
                phi_1621_ = evaluate_Verdict(_e557, _e554);
            } else {
                phi_1621_ = evaluate_Verdict(1f, true);
            }
            let _e561 = phi_1621_;
            phi_1622_ = _e561;
        }
        let _e563 = phi_1622_;
        visibility.member[_e57.first_primitive] = _e563.visibility;
        phi_1626_ = _e563.is_doubted;
        phi_1627_ = _e57.first_primitive;
    } else {
        phi_1626_ = false;
        phi_1627_ = 0u;
    }
    let _e568 = phi_1626_;
    let _e570 = phi_1627_;
    if _e568 {
        let _e572 = atomicAdd((&shared_[0u]), 1u);
        phi_1633_ = _e572;
    } else {
        phi_1633_ = 0u;
    }
    let _e574 = phi_1633_;
    workgroupBarrier();
    if (_e42 == 0u) {
        let _e578 = atomicLoad((&shared_[0u]));
        let _e579 = atomicAdd((&list.member[3u]), _e578);
        atomicStore((&shared_[1u]), _e579);
    }
    workgroupBarrier();
    if _e568 {
        let _e582 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e582) + _e574)]), _e570);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_msm_hausdorff_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_3 = local;
    function_();
}
