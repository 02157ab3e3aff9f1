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

struct type_37 {
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

struct type_41 {
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

struct type_51 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
var<private> local_3: u32;
@group(0) @binding(1) 
var<storage> samples: type_10;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(0) 
var<uniform> p: type_41;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_18;
@group(0) @binding(4) 
var<storage, read_write> list: type_51;
@group(0) @binding(2) 
var<storage> map: type_37;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_161_: lt_bvh_traverse_Tree;
    var phi_162_: bool;
    var phi_163_: lt_bvh_traverse_Tree;
    var phi_164_: bool;
    var phi_169_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_161_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_162_ = false;
        } else {
            phi_161_ = lt_bvh_traverse_Tree();
            phi_162_ = true;
        }
        let _e53 = phi_161_;
        let _e55 = phi_162_;
        phi_163_ = _e53;
        phi_164_ = _e55;
    } else {
        phi_163_ = lt_bvh_traverse_Tree();
        phi_164_ = true;
    }
    let _e57 = phi_163_;
    let _e59 = phi_164_;
    if _e59 {
        phi_169_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_169_ = _e57;
    }
    let _e64 = phi_169_;
    return lt_bvh_traverse_Tree(_e64.root, _e64.first_primitive);
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn lt_math_hausdorff_cubic_mass(param_4: vec4<f32>, param_5: f32, param_6: f32, param_7: f32, param_8: f32) -> f32 {
    return ((((param_4.z - (((param_6 + param_7) + param_8) * param_4.y)) + ((((param_6 * param_7) + (param_6 * param_8)) + (param_7 * param_8)) * param_4.x)) - ((param_6 * param_7) * param_8)) / (((param_5 - param_6) * (param_5 - param_7)) * (param_5 - param_8)));
}

fn lt_math_hausdorff_endpoint_upper_bound(param_9: ptr<function, hankel_HankelFactors>, param_10: f32) -> f32 {
    var phi_939_: f32;
    var phi_940_: f32;
    var phi_941_: f32;
    var phi_968_: f32;
    var phi_969_: f32;
    var phi_970_: f32;
    var phi_971_: f32;
    var phi_972_: bool;
    var phi_973_: f32;
    var phi_974_: bool;
    var phi_1002_: f32;
    var phi_1003_: f32;
    var phi_1004_: f32;
    var phi_1005_: f32;
    var phi_1006_: bool;
    var phi_1007_: f32;
    var phi_1008_: bool;
    var phi_1015_: f32;
    var phi_1016_: f32;
    var phi_1017_: f32;
    var phi_1018_: f32;

    let _e43 = (*param_9).moments;
    if (param_10 < 0.0001f) {
        phi_1018_ = 1f;
    } else {
        let _e52 = ((_e43.z - ((1f + param_10) * _e43.y)) + (param_10 * _e43.x));
        let _e61 = (((_e43.w - ((1f + param_10) * _e43.z)) + (param_10 * _e43.y)) / _e52);
        if (abs(_e52) <= 0.00000047683716f) {
            let _e75 = (1f - (((_e43.y - (_e43.x * (param_10 + 1f))) + (param_10 * 1f)) / ((0f - param_10) * (0f - 1f))));
            if ((bitcast<u32>(_e75) & 2147483647u) > 2139095040u) {
                phi_941_ = _e75;
            } else {
                if (_e75 < 0f) {
                    phi_940_ = 0f;
                } else {
                    if (_e75 > 1f) {
                        phi_939_ = 1f;
                    } else {
                        phi_939_ = _e75;
                    }
                    let _e82 = phi_939_;
                    phi_940_ = _e82;
                }
                let _e84 = phi_940_;
                phi_941_ = _e84;
            }
            let _e86 = phi_941_;
            phi_1017_ = _e86;
        } else {
            if (_e61 > 0f) {
                if (_e61 < param_10) {
                    let _e89 = lt_math_hausdorff_cubic_mass(_e43, 0f, _e61, param_10, 1f);
                    let _e91 = lt_math_hausdorff_cubic_mass(_e43, _e61, 0f, param_10, 1f);
                    let _e92 = ((1f - _e89) - _e91);
                    if ((bitcast<u32>(_e92) & 2147483647u) > 2139095040u) {
                        phi_970_ = _e92;
                    } else {
                        if (_e92 < 0f) {
                            phi_969_ = 0f;
                        } else {
                            if (_e92 > 1f) {
                                phi_968_ = 1f;
                            } else {
                                phi_968_ = _e92;
                            }
                            let _e99 = phi_968_;
                            phi_969_ = _e99;
                        }
                        let _e101 = phi_969_;
                        phi_970_ = _e101;
                    }
                    let _e103 = phi_970_;
                    phi_971_ = _e103;
                    phi_972_ = false;
                } else {
                    phi_971_ = f32();
                    phi_972_ = true;
                }
                let _e105 = phi_971_;
                let _e107 = phi_972_;
                phi_973_ = _e105;
                phi_974_ = _e107;
            } else {
                phi_973_ = f32();
                phi_974_ = true;
            }
            let _e109 = phi_973_;
            let _e111 = phi_974_;
            if _e111 {
                if (_e61 > param_10) {
                    if (_e61 < 1f) {
                        let _e114 = lt_math_hausdorff_cubic_mass(_e43, 0f, _e61, param_10, 1f);
                        let _e115 = (1f - _e114);
                        if ((bitcast<u32>(_e115) & 2147483647u) > 2139095040u) {
                            phi_1004_ = _e115;
                        } else {
                            if (_e115 < 0f) {
                                phi_1003_ = 0f;
                            } else {
                                if (_e115 > 1f) {
                                    phi_1002_ = 1f;
                                } else {
                                    phi_1002_ = _e115;
                                }
                                let _e122 = phi_1002_;
                                phi_1003_ = _e122;
                            }
                            let _e124 = phi_1003_;
                            phi_1004_ = _e124;
                        }
                        let _e126 = phi_1004_;
                        phi_1005_ = _e126;
                        phi_1006_ = false;
                    } else {
                        phi_1005_ = f32();
                        phi_1006_ = true;
                    }
                    let _e128 = phi_1005_;
                    let _e130 = phi_1006_;
                    phi_1007_ = _e128;
                    phi_1008_ = _e130;
                } else {
                    phi_1007_ = f32();
                    phi_1008_ = true;
                }
                let _e132 = phi_1007_;
                let _e134 = phi_1008_;
                if _e134 {
                    phi_1015_ = bitcast<f32>((bitcast<u32>(_e61) | 2143289344u));
                } else {
                    phi_1015_ = _e132;
                }
                let _e139 = phi_1015_;
                phi_1016_ = _e139;
            } else {
                phi_1016_ = _e109;
            }
            let _e141 = phi_1016_;
            phi_1017_ = _e141;
        }
        let _e143 = phi_1017_;
        phi_1018_ = _e143;
    }
    let _e145 = phi_1018_;
    return _e145;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_11: ptr<function, f32>, param_12: vec4<f32>, param_13: f32) -> f32 {
    var local_1: hankel_HankelFactors;
    var phi_226_: f32;
    var phi_227_: f32;
    var phi_228_: f32;
    var phi_240_: bool;
    var phi_255_: bool;
    var phi_280_: f32;
    var phi_281_: f32;
    var phi_282_: f32;
    var phi_283_: f32;
    var phi_284_: bool;
    var phi_285_: f32;
    var phi_286_: bool;
    var phi_342_: vec2<f32>;
    var phi_380_: f32;
    var phi_381_: f32;
    var phi_382_: f32;
    var phi_415_: f32;
    var phi_416_: f32;
    var phi_417_: f32;
    var phi_421_: f32;
    var phi_422_: f32;
    var phi_423_: f32;
    var phi_424_: f32;
    var phi_477_: vec2<f32>;
    var phi_499_: bool;
    var phi_524_: f32;
    var phi_525_: f32;
    var phi_526_: f32;
    var phi_527_: f32;
    var phi_528_: bool;
    var phi_529_: f32;
    var phi_530_: bool;
    var phi_586_: vec2<f32>;
    var phi_624_: f32;
    var phi_625_: f32;
    var phi_626_: f32;
    var phi_659_: f32;
    var phi_660_: f32;
    var phi_661_: f32;
    var phi_665_: f32;
    var phi_666_: f32;
    var phi_667_: f32;
    var phi_668_: f32;
    var phi_669_: f32;
    var phi_670_: bool;
    var phi_671_: f32;
    var phi_672_: bool;
    var phi_694_: bool;
    var phi_719_: f32;
    var phi_720_: f32;
    var phi_721_: f32;
    var phi_722_: f32;
    var phi_723_: bool;
    var phi_724_: f32;
    var phi_725_: bool;
    var phi_781_: vec2<f32>;
    var phi_819_: f32;
    var phi_820_: f32;
    var phi_821_: f32;
    var phi_854_: f32;
    var phi_855_: f32;
    var phi_856_: f32;
    var phi_860_: f32;
    var phi_861_: f32;
    var phi_862_: f32;
    var phi_863_: f32;
    var phi_874_: bool;
    var phi_878_: f32;
    var phi_879_: f32;
    var phi_880_: f32;
    var phi_881_: f32;

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
        phi_228_ = param_13;
    } else {
        if (param_13 < 0f) {
            phi_227_ = 0f;
        } else {
            if (param_13 > 1f) {
                phi_226_ = 1f;
            } else {
                phi_226_ = param_13;
            }
            let _e81 = phi_226_;
            phi_227_ = _e81;
        }
        let _e83 = phi_227_;
        phi_228_ = _e83;
    }
    let _e85 = phi_228_;
    let _e88 = local_1.moments[0u];
    let _e91 = local_1.moments[3u];
    if (_e88 == _e91) {
        let _e95 = local_1.moments[0u];
        phi_240_ = (_e95 > 0.5f);
    } else {
        phi_240_ = false;
    }
    let _e98 = phi_240_;
    if _e98 {
        let _e101 = local_1.moments[0u];
        let _e104 = local_1.moments[3u];
        if (_e101 == _e104) {
            let _e108 = local_1.moments[0u];
            phi_255_ = (_e108 > 0.5f);
        } else {
            phi_255_ = false;
        }
        let _e111 = phi_255_;
        if _e111 {
            if (_e85 > 0f) {
                let _e114 = local_1.moments;
                if ((bitcast<u32>(_e114.x) & 2147483647u) > 2139095040u) {
                    phi_282_ = _e114.x;
                } else {
                    if (_e114.x < 0f) {
                        phi_281_ = 0f;
                    } else {
                        if (_e114.x > 1f) {
                            phi_280_ = 1f;
                        } else {
                            phi_280_ = _e114.x;
                        }
                        let _e122 = phi_280_;
                        phi_281_ = _e122;
                    }
                    let _e124 = phi_281_;
                    phi_282_ = _e124;
                }
                let _e126 = phi_282_;
                phi_283_ = _e126;
                phi_284_ = false;
            } else {
                phi_283_ = f32();
                phi_284_ = true;
            }
            let _e128 = phi_283_;
            let _e130 = phi_284_;
            phi_285_ = _e128;
            phi_286_ = _e130;
        } else {
            phi_285_ = f32();
            phi_286_ = true;
        }
        let _e132 = phi_285_;
        let _e134 = phi_286_;
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
                phi_342_ = vec2<f32>((-(_e173) - _e178), (-(_e173) + _e178));
            } else {
                phi_342_ = vec2(bitcast<f32>((bitcast<u32>(_e176) | 2143289344u)));
            }
            let _e189 = phi_342_;
            if (_e85 <= _e189.x) {
                phi_423_ = 1f;
            } else {
                if (_e85 > _e189.y) {
                    let _e195 = local_1.moments;
                    let _e206 = (((_e195.y - (_e195.x * (_e189.x + _e189.y))) + (_e189.x * _e189.y)) / ((_e85 - _e189.x) * (_e85 - _e189.y)));
                    if ((bitcast<u32>(_e206) & 2147483647u) > 2139095040u) {
                        phi_382_ = _e206;
                    } else {
                        if (_e206 < 0f) {
                            phi_381_ = 0f;
                        } else {
                            if (_e206 > 1f) {
                                phi_380_ = 1f;
                            } else {
                                phi_380_ = _e206;
                            }
                            let _e213 = phi_380_;
                            phi_381_ = _e213;
                        }
                        let _e215 = phi_381_;
                        phi_382_ = _e215;
                    }
                    let _e217 = phi_382_;
                    phi_422_ = _e217;
                } else {
                    if (_e85 > _e189.x) {
                        let _e220 = local_1.moments;
                        let _e232 = (1f - (((_e220.y - (_e220.x * (_e85 + _e189.y))) + (_e85 * _e189.y)) / ((_e189.x - _e85) * (_e189.x - _e189.y))));
                        if ((bitcast<u32>(_e232) & 2147483647u) > 2139095040u) {
                            phi_417_ = _e232;
                        } else {
                            if (_e232 < 0f) {
                                phi_416_ = 0f;
                            } else {
                                if (_e232 > 1f) {
                                    phi_415_ = 1f;
                                } else {
                                    phi_415_ = _e232;
                                }
                                let _e239 = phi_415_;
                                phi_416_ = _e239;
                            }
                            let _e241 = phi_416_;
                            phi_417_ = _e241;
                        }
                        let _e243 = phi_417_;
                        phi_421_ = _e243;
                    } else {
                        phi_421_ = bitcast<f32>((bitcast<u32>(_e189.x) | 2143289344u));
                    }
                    let _e248 = phi_421_;
                    phi_422_ = _e248;
                }
                let _e250 = phi_422_;
                phi_423_ = _e250;
            }
            let _e252 = phi_423_;
            phi_424_ = _e252;
        } else {
            phi_424_ = _e132;
        }
        let _e254 = phi_424_;
        phi_881_ = _e254;
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
            phi_477_ = vec2<f32>((-(_e293) - _e298), (-(_e293) + _e298));
        } else {
            phi_477_ = vec2(bitcast<f32>((bitcast<u32>(_e296) | 2143289344u)));
        }
        let _e309 = phi_477_;
        if (_e309.x >= 0f) {
            if (_e309.y <= 1f) {
                let _e316 = local_1.moments[0u];
                let _e319 = local_1.moments[3u];
                if (_e316 == _e319) {
                    let _e323 = local_1.moments[0u];
                    phi_499_ = (_e323 > 0.5f);
                } else {
                    phi_499_ = false;
                }
                let _e326 = phi_499_;
                if _e326 {
                    if (_e85 > 0f) {
                        let _e329 = local_1.moments;
                        if ((bitcast<u32>(_e329.x) & 2147483647u) > 2139095040u) {
                            phi_526_ = _e329.x;
                        } else {
                            if (_e329.x < 0f) {
                                phi_525_ = 0f;
                            } else {
                                if (_e329.x > 1f) {
                                    phi_524_ = 1f;
                                } else {
                                    phi_524_ = _e329.x;
                                }
                                let _e337 = phi_524_;
                                phi_525_ = _e337;
                            }
                            let _e339 = phi_525_;
                            phi_526_ = _e339;
                        }
                        let _e341 = phi_526_;
                        phi_527_ = _e341;
                        phi_528_ = false;
                    } else {
                        phi_527_ = f32();
                        phi_528_ = true;
                    }
                    let _e343 = phi_527_;
                    let _e345 = phi_528_;
                    phi_529_ = _e343;
                    phi_530_ = _e345;
                } else {
                    phi_529_ = f32();
                    phi_530_ = true;
                }
                let _e347 = phi_529_;
                let _e349 = phi_530_;
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
                        phi_586_ = vec2<f32>((-(_e388) - _e393), (-(_e388) + _e393));
                    } else {
                        phi_586_ = vec2(bitcast<f32>((bitcast<u32>(_e391) | 2143289344u)));
                    }
                    let _e404 = phi_586_;
                    if (_e85 <= _e404.x) {
                        phi_667_ = 1f;
                    } else {
                        if (_e85 > _e404.y) {
                            let _e410 = local_1.moments;
                            let _e421 = (((_e410.y - (_e410.x * (_e404.x + _e404.y))) + (_e404.x * _e404.y)) / ((_e85 - _e404.x) * (_e85 - _e404.y)));
                            if ((bitcast<u32>(_e421) & 2147483647u) > 2139095040u) {
                                phi_626_ = _e421;
                            } else {
                                if (_e421 < 0f) {
                                    phi_625_ = 0f;
                                } else {
                                    if (_e421 > 1f) {
                                        phi_624_ = 1f;
                                    } else {
                                        phi_624_ = _e421;
                                    }
                                    let _e428 = phi_624_;
                                    phi_625_ = _e428;
                                }
                                let _e430 = phi_625_;
                                phi_626_ = _e430;
                            }
                            let _e432 = phi_626_;
                            phi_666_ = _e432;
                        } else {
                            if (_e85 > _e404.x) {
                                let _e435 = local_1.moments;
                                let _e447 = (1f - (((_e435.y - (_e435.x * (_e85 + _e404.y))) + (_e85 * _e404.y)) / ((_e404.x - _e85) * (_e404.x - _e404.y))));
                                if ((bitcast<u32>(_e447) & 2147483647u) > 2139095040u) {
                                    phi_661_ = _e447;
                                } else {
                                    if (_e447 < 0f) {
                                        phi_660_ = 0f;
                                    } else {
                                        if (_e447 > 1f) {
                                            phi_659_ = 1f;
                                        } else {
                                            phi_659_ = _e447;
                                        }
                                        let _e454 = phi_659_;
                                        phi_660_ = _e454;
                                    }
                                    let _e456 = phi_660_;
                                    phi_661_ = _e456;
                                }
                                let _e458 = phi_661_;
                                phi_665_ = _e458;
                            } else {
                                phi_665_ = bitcast<f32>((bitcast<u32>(_e404.x) | 2143289344u));
                            }
                            let _e463 = phi_665_;
                            phi_666_ = _e463;
                        }
                        let _e465 = phi_666_;
                        phi_667_ = _e465;
                    }
                    let _e467 = phi_667_;
                    phi_668_ = _e467;
                } else {
                    phi_668_ = _e347;
                }
                let _e469 = phi_668_;
                phi_669_ = _e469;
                phi_670_ = false;
            } else {
                phi_669_ = f32();
                phi_670_ = true;
            }
            let _e471 = phi_669_;
            let _e473 = phi_670_;
            phi_671_ = _e471;
            phi_672_ = _e473;
        } else {
            phi_671_ = f32();
            phi_672_ = true;
        }
        let _e475 = phi_671_;
        let _e477 = phi_672_;
        if _e477 {
            if ((bitcast<u32>(_e309.x) & 2147483647u) > 2139095040u) {
                phi_879_ = _e309.x;
            } else {
                let _e481 = lt_math_hausdorff_endpoint_upper_bound((&local_1), _e85);
                let _e484 = local_1.moments[0u];
                let _e487 = local_1.moments[3u];
                if (_e484 == _e487) {
                    let _e491 = local_1.moments[0u];
                    phi_694_ = (_e491 > 0.5f);
                } else {
                    phi_694_ = false;
                }
                let _e494 = phi_694_;
                if _e494 {
                    if (_e85 > 0f) {
                        let _e497 = local_1.moments;
                        if ((bitcast<u32>(_e497.x) & 2147483647u) > 2139095040u) {
                            phi_721_ = _e497.x;
                        } else {
                            if (_e497.x < 0f) {
                                phi_720_ = 0f;
                            } else {
                                if (_e497.x > 1f) {
                                    phi_719_ = 1f;
                                } else {
                                    phi_719_ = _e497.x;
                                }
                                let _e505 = phi_719_;
                                phi_720_ = _e505;
                            }
                            let _e507 = phi_720_;
                            phi_721_ = _e507;
                        }
                        let _e509 = phi_721_;
                        phi_722_ = _e509;
                        phi_723_ = false;
                    } else {
                        phi_722_ = f32();
                        phi_723_ = true;
                    }
                    let _e511 = phi_722_;
                    let _e513 = phi_723_;
                    phi_724_ = _e511;
                    phi_725_ = _e513;
                } else {
                    phi_724_ = f32();
                    phi_725_ = true;
                }
                let _e515 = phi_724_;
                let _e517 = phi_725_;
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
                        phi_781_ = vec2<f32>((-(_e556) - _e561), (-(_e556) + _e561));
                    } else {
                        phi_781_ = vec2(bitcast<f32>((bitcast<u32>(_e559) | 2143289344u)));
                    }
                    let _e572 = phi_781_;
                    if (_e85 <= _e572.x) {
                        phi_862_ = 1f;
                    } else {
                        if (_e85 > _e572.y) {
                            let _e578 = local_1.moments;
                            let _e589 = (((_e578.y - (_e578.x * (_e572.x + _e572.y))) + (_e572.x * _e572.y)) / ((_e85 - _e572.x) * (_e85 - _e572.y)));
                            if ((bitcast<u32>(_e589) & 2147483647u) > 2139095040u) {
                                phi_821_ = _e589;
                            } else {
                                if (_e589 < 0f) {
                                    phi_820_ = 0f;
                                } else {
                                    if (_e589 > 1f) {
                                        phi_819_ = 1f;
                                    } else {
                                        phi_819_ = _e589;
                                    }
                                    let _e596 = phi_819_;
                                    phi_820_ = _e596;
                                }
                                let _e598 = phi_820_;
                                phi_821_ = _e598;
                            }
                            let _e600 = phi_821_;
                            phi_861_ = _e600;
                        } else {
                            if (_e85 > _e572.x) {
                                let _e603 = local_1.moments;
                                let _e615 = (1f - (((_e603.y - (_e603.x * (_e85 + _e572.y))) + (_e85 * _e572.y)) / ((_e572.x - _e85) * (_e572.x - _e572.y))));
                                if ((bitcast<u32>(_e615) & 2147483647u) > 2139095040u) {
                                    phi_856_ = _e615;
                                } else {
                                    if (_e615 < 0f) {
                                        phi_855_ = 0f;
                                    } else {
                                        if (_e615 > 1f) {
                                            phi_854_ = 1f;
                                        } else {
                                            phi_854_ = _e615;
                                        }
                                        let _e622 = phi_854_;
                                        phi_855_ = _e622;
                                    }
                                    let _e624 = phi_855_;
                                    phi_856_ = _e624;
                                }
                                let _e626 = phi_856_;
                                phi_860_ = _e626;
                            } else {
                                phi_860_ = bitcast<f32>((bitcast<u32>(_e572.x) | 2143289344u));
                            }
                            let _e631 = phi_860_;
                            phi_861_ = _e631;
                        }
                        let _e633 = phi_861_;
                        phi_862_ = _e633;
                    }
                    let _e635 = phi_862_;
                    phi_863_ = _e635;
                } else {
                    phi_863_ = _e515;
                }
                let _e637 = phi_863_;
                if ((bitcast<u32>(_e637) & 2147483647u) > 2139095040u) {
                    phi_874_ = true;
                } else {
                    let _e641 = (_e637 < _e481);
                    if _e641 {
                    }
                    phi_874_ = _e641;
                }
                let _e643 = phi_874_;
                if _e643 {
                    phi_878_ = _e637;
                } else {
                    phi_878_ = _e481;
                }
                let _e645 = phi_878_;
                phi_879_ = _e645;
            }
            let _e647 = phi_879_;
            phi_880_ = _e647;
        } else {
            phi_880_ = _e475;
        }
        let _e649 = phi_880_;
        phi_881_ = _e649;
    }
    let _e651 = phi_881_;
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
    var phi_1228_: bool;
    var phi_1237_: bool;
    var phi_1246_: bool;
    var phi_1247_: bool;
    var phi_1248_: bool;
    var phi_1249_: bool;
    var phi_1250_: bool;
    var phi_1251_: bool;
    var phi_1252_: bool;
    var phi_1256_: bool;
    var phi_1346_: f32;
    var phi_1349_: f32;
    var phi_1378_: f32;
    var phi_1383_: f32;
    var phi_1384_: bool;
    var phi_1385_: f32;
    var phi_1386_: bool;
    var phi_1390_: f32;
    var phi_1410_: f32;
    var phi_1415_: f32;
    var phi_1416_: bool;
    var phi_1417_: f32;
    var phi_1418_: bool;
    var phi_1422_: f32;
    var phi_1470_: i32;
    var phi_1475_: i32;
    var phi_1480_: i32;
    var phi_1485_: i32;
    var phi_1494_: i32;
    var phi_1499_: i32;
    var phi_1504_: i32;
    var phi_1509_: i32;
    var phi_1604_: bool;
    var phi_1612_: bool;
    var phi_1624_: bool;
    var phi_1625_: bool;
    var phi_1629_: f32;
    var phi_1635_: f32;
    var phi_1637_: evaluate_Verdict;
    var phi_1642_: evaluate_Verdict;
    var phi_1643_: evaluate_Verdict;
    var phi_1647_: bool;
    var phi_1648_: u32;
    var phi_1659_: u32;

    let _e41 = id_1;
    let _e42 = local_3;
    let _e47 = arrayLength((&map.member));
    let _e52 = p.member.size[0u];
    let _e54 = p.member.size[1u];
    let _e55 = lt_shaders_entry_pixel_index(_e41, _e52, _e54);
    if (bitcast<i32>(_e55.root) != 0i) {
        let _e62 = p.member.projection;
        let _e63 = lt_math_OneLevel(_e62);
        let _e65 = p.member.light;
        let _e68 = samples.member[_e55.first_primitive].normal[0u];
        let _e70 = global[0u];
        if (_e68 == _e70) {
            let _e73 = samples.member[_e55.first_primitive].normal[1u];
            let _e75 = global[1u];
            if (_e73 == _e75) {
                let _e78 = samples.member[_e55.first_primitive].normal[2u];
                let _e80 = global[2u];
                phi_1099_ = (_e78 == _e80);
                phi_1100_ = false;
            } else {
                phi_1099_ = bool();
                phi_1100_ = true;
            }
            let _e83 = phi_1099_;
            let _e85 = phi_1100_;
            phi_1101_ = _e83;
            phi_1102_ = _e85;
        } else {
            phi_1101_ = bool();
            phi_1102_ = true;
        }
        let _e87 = phi_1101_;
        let _e89 = phi_1102_;
        if _e89 {
            phi_1106_ = false;
        } else {
            phi_1106_ = _e87;
        }
        let _e91 = phi_1106_;
        if !(_e91) {
            let _e94 = samples.member[_e55.first_primitive].normal;
            let _e96 = samples.member[_e55.first_primitive].position;
            if ((((_e94.x * (_e65.x - (_e96.x * _e65.w))) + (_e94.y * (_e65.y - (_e96.y * _e65.w)))) + (_e94.z * (_e65.z - (_e96.z * _e65.w)))) > 0f) {
                let _e120 = samples.member[_e55.first_primitive].flags;
                let _e128 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e134 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e128.unnamed.visibility, false), _e128.unnamed_1);
                phi_1150_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e134.unnamed, ((_e120 & 1u) == 0u));
            } else {
                let _e143 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e149 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e143.unnamed.visibility, false), _e143.unnamed_1);
                phi_1150_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e149.unnamed, true);
            }
            let _e154 = phi_1150_;
            phi_1154_ = _e154;
        } else {
            let _e160 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e166 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e160.unnamed.visibility, false), _e160.unnamed_1);
            phi_1154_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e166.unnamed, true);
        }
        let _e171 = phi_1154_;
        if _e171.unnamed_1 {
            phi_1643_ = evaluate_Verdict(_e171.unnamed.visibility, _e171.unnamed.is_doubted);
        } else {
            let _e179 = samples.member[_e55.first_primitive].position;
            let _e197 = ((((_e63.projection.row_w.x * _e179.x) + (_e63.projection.row_w.y * _e179.y)) + (_e63.projection.row_w.z * _e179.z)) + (_e63.projection.row_w.w * 1f));
            let _e211 = (((((_e63.projection.row_x.x * _e179.x) + (_e63.projection.row_x.y * _e179.y)) + (_e63.projection.row_x.z * _e179.z)) + (_e63.projection.row_x.w * 1f)) / _e197);
            let _e225 = (((((_e63.projection.row_y.x * _e179.x) + (_e63.projection.row_y.y * _e179.y)) + (_e63.projection.row_y.z * _e179.z)) + (_e63.projection.row_y.w * 1f)) / _e197);
            let _e238 = ((((_e63.projection.row_z.x * _e179.x) + (_e63.projection.row_z.y * _e179.y)) + (_e63.projection.row_z.z * _e179.z)) + (_e63.projection.row_z.w * 1f));
            if (_e197 > 0f) {
                if (_e211 >= 0f) {
                    phi_1228_ = (_e211 <= 1f);
                } else {
                    phi_1228_ = false;
                }
                let _e243 = phi_1228_;
                if _e243 {
                    if (_e225 >= 0f) {
                        phi_1237_ = (_e225 <= 1f);
                    } else {
                        phi_1237_ = false;
                    }
                    let _e247 = phi_1237_;
                    if _e247 {
                        if (_e238 >= 0f) {
                            phi_1246_ = (_e238 <= 1f);
                        } else {
                            phi_1246_ = false;
                        }
                        let _e251 = phi_1246_;
                        phi_1247_ = _e251;
                        phi_1248_ = false;
                    } else {
                        phi_1247_ = bool();
                        phi_1248_ = true;
                    }
                    let _e253 = phi_1247_;
                    let _e255 = phi_1248_;
                    phi_1249_ = _e253;
                    phi_1250_ = _e255;
                } else {
                    phi_1249_ = bool();
                    phi_1250_ = true;
                }
                let _e257 = phi_1249_;
                let _e259 = phi_1250_;
                phi_1251_ = _e257;
                phi_1252_ = _e259;
            } else {
                phi_1251_ = bool();
                phi_1252_ = true;
            }
            let _e261 = phi_1251_;
            let _e263 = phi_1252_;
            if _e263 {
                phi_1256_ = false;
            } else {
                phi_1256_ = _e261;
            }
            let _e265 = phi_1256_;
            if _e265 {
                if (0f > 0f) {
                    let _e268 = samples.member[_e55.first_primitive].normal;
                    let _e270 = p.member.map_size;
                    let _e340 = ((abs(((((_e62.row_x.x * _e268.x) + (_e62.row_x.y * _e268.y)) + (_e62.row_x.z * _e268.z)) / (((_e62.row_x.x * _e62.row_x.x) + (_e62.row_x.y * _e62.row_x.y)) + (_e62.row_x.z * _e62.row_x.z)))) + abs(((((_e62.row_y.x * _e268.x) + (_e62.row_y.y * _e268.y)) + (_e62.row_y.z * _e268.z)) / (((_e62.row_y.x * _e62.row_y.x) + (_e62.row_y.y * _e62.row_y.y)) + (_e62.row_y.z * _e62.row_y.z))))) / (abs(((((_e62.row_z.x * _e268.x) + (_e62.row_z.y * _e268.y)) + (_e62.row_z.z * _e268.z)) / (((_e62.row_z.x * _e62.row_z.x) + (_e62.row_z.y * _e62.row_z.y)) + (_e62.row_z.z * _e62.row_z.z)))) * f32(_e270)));
                    if (_e340 < 0.002f) {
                        phi_1346_ = _e340;
                    } else {
                        phi_1346_ = 0.002f;
                    }
                    let _e343 = phi_1346_;
                    phi_1349_ = (_e238 - (0f * _e343));
                } else {
                    phi_1349_ = _e238;
                }
                let _e347 = phi_1349_;
                let _e349 = p.member.map_size;
                let _e350 = f32(_e349);
                let _e353 = ((_e211 * _e350) - 0.5f);
                let _e354 = ((_e225 * _e350) - 0.5f);
                if (_e353 > -8388608f) {
                    let _e366 = f32(select(0i, select(select(i32(_e353), i32(-2147483648), (_e353 < bitcast<f32>(3472883712u))), 2147483647i, (_e353 > bitcast<f32>(1325400063u))), (_e353 == _e353)));
                    if (_e366 > _e353) {
                        phi_1378_ = 1f;
                    } else {
                        phi_1378_ = 0f;
                    }
                    let _e369 = phi_1378_;
                    if (_e353 < 8388608f) {
                        phi_1383_ = (_e366 - _e369);
                        phi_1384_ = false;
                    } else {
                        phi_1383_ = f32();
                        phi_1384_ = true;
                    }
                    let _e372 = phi_1383_;
                    let _e374 = phi_1384_;
                    phi_1385_ = _e372;
                    phi_1386_ = _e374;
                } else {
                    phi_1385_ = f32();
                    phi_1386_ = true;
                }
                let _e376 = phi_1385_;
                let _e378 = phi_1386_;
                if _e378 {
                    phi_1390_ = _e353;
                } else {
                    phi_1390_ = _e376;
                }
                let _e380 = phi_1390_;
                if (_e354 > -8388608f) {
                    let _e392 = f32(select(0i, select(select(i32(_e354), i32(-2147483648), (_e354 < bitcast<f32>(3472883712u))), 2147483647i, (_e354 > bitcast<f32>(1325400063u))), (_e354 == _e354)));
                    if (_e392 > _e354) {
                        phi_1410_ = 1f;
                    } else {
                        phi_1410_ = 0f;
                    }
                    let _e395 = phi_1410_;
                    if (_e354 < 8388608f) {
                        phi_1415_ = (_e392 - _e395);
                        phi_1416_ = false;
                    } else {
                        phi_1415_ = f32();
                        phi_1416_ = true;
                    }
                    let _e398 = phi_1415_;
                    let _e400 = phi_1416_;
                    phi_1417_ = _e398;
                    phi_1418_ = _e400;
                } else {
                    phi_1417_ = f32();
                    phi_1418_ = true;
                }
                let _e402 = phi_1417_;
                let _e404 = phi_1418_;
                if _e404 {
                    phi_1422_ = _e354;
                } else {
                    phi_1422_ = _e402;
                }
                let _e406 = phi_1422_;
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
                let _e441 = ((0u * _e439) * _e439);
                let _e443 = (bitcast<i32>(_e439) - 1i);
                if (_e417 > 0i) {
                    phi_1470_ = _e417;
                } else {
                    phi_1470_ = 0i;
                }
                let _e446 = phi_1470_;
                if (_e426 > 0i) {
                    phi_1475_ = _e426;
                } else {
                    phi_1475_ = 0i;
                }
                let _e449 = phi_1475_;
                if (_e446 < _e443) {
                    phi_1480_ = _e446;
                } else {
                    phi_1480_ = _e443;
                }
                let _e452 = phi_1480_;
                if (_e449 < _e443) {
                    phi_1485_ = _e449;
                } else {
                    phi_1485_ = _e443;
                }
                let _e455 = phi_1485_;
                let _e456 = bitcast<u32>(_e452);
                let _e458 = (_e417 + 1i);
                let _e459 = (_e426 + 1i);
                if (_e458 > 0i) {
                    phi_1494_ = _e458;
                } else {
                    phi_1494_ = 0i;
                }
                let _e462 = phi_1494_;
                if (_e459 > 0i) {
                    phi_1499_ = _e459;
                } else {
                    phi_1499_ = 0i;
                }
                let _e465 = phi_1499_;
                if (_e462 < _e443) {
                    phi_1504_ = _e462;
                } else {
                    phi_1504_ = _e443;
                }
                let _e468 = phi_1504_;
                if (_e465 < _e443) {
                    phi_1509_ = _e465;
                } else {
                    phi_1509_ = _e443;
                }
                let _e471 = phi_1509_;
                let _e472 = bitcast<u32>(_e468);
                let _e474 = (bitcast<u32>(_e455) * _e439);
                let _e475 = (bitcast<u32>(_e471) * _e439);
                let _e480 = ((_e474 + _e456) + _e441);
                let _e481 = ((_e474 + _e472) + _e441);
                let _e482 = ((_e475 + _e456) + _e441);
                let _e483 = ((_e475 + _e472) + _e441);
                if (_e480 < _e47) {
                } else {
                    return;
                }
                let _e487 = map.member[(0u + _e480)];
                if (_e481 < _e47) {
                } else {
                    return;
                }
                let _e499 = map.member[(0u + _e481)];
                if (_e482 < _e47) {
                } else {
                    return;
                }
                let _e515 = map.member[(0u + _e482)];
                if (_e483 < _e47) {
                } else {
                    return;
                }
                let _e531 = map.member[(0u + _e483)];
                let _e545 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_2), vec4<f32>(((((_e487.x * _e429) + (_e499.x * _e431)) + (_e515.x * _e433)) + (_e531.x * _e434)), ((((_e487.y * _e429) + (_e499.y * _e431)) + (_e515.y * _e433)) + (_e531.y * _e434)), ((((_e487.z * _e429) + (_e499.z * _e431)) + (_e515.z * _e433)) + (_e531.z * _e434)), ((((_e487.w * _e429) + (_e499.w * _e431)) + (_e515.w * _e433)) + (_e531.w * _e434))), _e347);
                let _e547 = p.member.epsilon;
                if (_e545 <= _e547) {
                    phi_1604_ = true;
                } else {
                    phi_1604_ = (_e545 >= (1f - _e547));
                }
                let _e552 = phi_1604_;
                if ((bitcast<u32>(_e545) & 2147483647u) > 2139095040u) {
                    phi_1612_ = true;
                } else {
                    phi_1612_ = !(_e552);
                }
                let _e558 = phi_1612_;
                if _e558 {
                    if (_e545 > 0f) {
                        if (_e545 < 1f) {
                            phi_1624_ = false;
                        } else {
                            phi_1624_ = true;
                        }
                        let _e562 = phi_1624_;
                        phi_1625_ = _e562;
                    } else {
                        phi_1625_ = true;
                    }
                    let _e564 = phi_1625_;
                    if _e564 {
                        phi_1629_ = 0.5f;
                    } else {
                        phi_1629_ = _e545;
                    }
                    let _e566 = phi_1629_;
                    phi_1637_ = evaluate_Verdict(_e566, true);
                } else {
                    if (_e545 > 0.5f) {
                        phi_1635_ = 1f;
                    } else {
                        phi_1635_ = 0f;
                    }
                    let _e570 = phi_1635_;
                    phi_1637_ = evaluate_Verdict(_e570, false);
                }
                let _e573 = phi_1637_;
                phi_1642_ = evaluate_Verdict(_e573.visibility, _e573.is_doubted);
            } else {
                phi_1642_ = evaluate_Verdict(0.5f, true);
            }
            let _e579 = phi_1642_;
            phi_1643_ = _e579;
        }
        let _e581 = phi_1643_;
        visibility.member[_e55.first_primitive] = _e581.visibility;
        phi_1647_ = _e581.is_doubted;
        phi_1648_ = _e55.first_primitive;
    } else {
        phi_1647_ = false;
        phi_1648_ = 0u;
    }
    let _e586 = phi_1647_;
    let _e588 = phi_1648_;
    if (_e42 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e586 {
        let _e592 = atomicAdd((&shared_[0u]), 1u);
        phi_1659_ = _e592;
    } else {
        phi_1659_ = 0u;
    }
    let _e594 = phi_1659_;
    workgroupBarrier();
    if (_e42 == 0u) {
        let _e598 = atomicLoad((&shared_[0u]));
        let _e599 = atomicAdd((&list.member[3u]), _e598);
        atomicStore((&shared_[1u]), _e599);
    }
    workgroupBarrier();
    if _e586 {
        let _e602 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e602) + _e594)]), _e588);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_msm_hausdorff_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_3 = local;
    function_();
}
