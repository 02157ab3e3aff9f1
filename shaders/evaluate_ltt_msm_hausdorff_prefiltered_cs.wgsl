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
    pad0_: u32,
    pad1_: u32,
    pad2_: u32,
}

struct type_41 {
    member: abi_ShadowParams,
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
    var phi_160_: lt_bvh_traverse_Tree;
    var phi_161_: bool;
    var phi_162_: lt_bvh_traverse_Tree;
    var phi_163_: bool;
    var phi_168_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_160_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_161_ = false;
        } else {
            phi_160_ = lt_bvh_traverse_Tree();
            phi_161_ = true;
        }
        let _e53 = phi_160_;
        let _e55 = phi_161_;
        phi_162_ = _e53;
        phi_163_ = _e55;
    } else {
        phi_162_ = lt_bvh_traverse_Tree();
        phi_163_ = true;
    }
    let _e57 = phi_162_;
    let _e59 = phi_163_;
    if _e59 {
        phi_168_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_168_ = _e57;
    }
    let _e64 = phi_168_;
    return lt_bvh_traverse_Tree(_e64.root, _e64.first_primitive);
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn lt_math_hausdorff_cubic_mass(param_4: vec4<f32>, param_5: f32, param_6: f32, param_7: f32, param_8: f32) -> f32 {
    return ((((param_4.z - (((param_6 + param_7) + param_8) * param_4.y)) + ((((param_6 * param_7) + (param_6 * param_8)) + (param_7 * param_8)) * param_4.x)) - ((param_6 * param_7) * param_8)) / (((param_5 - param_6) * (param_5 - param_7)) * (param_5 - param_8)));
}

fn lt_math_hausdorff_endpoint_upper_bound(param_9: ptr<function, hankel_HankelFactors>, param_10: f32) -> f32 {
    var phi_938_: f32;
    var phi_939_: f32;
    var phi_940_: f32;
    var phi_967_: f32;
    var phi_968_: f32;
    var phi_969_: f32;
    var phi_970_: f32;
    var phi_971_: bool;
    var phi_972_: f32;
    var phi_973_: bool;
    var phi_1001_: f32;
    var phi_1002_: f32;
    var phi_1003_: f32;
    var phi_1004_: f32;
    var phi_1005_: bool;
    var phi_1006_: f32;
    var phi_1007_: bool;
    var phi_1014_: f32;
    var phi_1015_: f32;
    var phi_1016_: f32;
    var phi_1017_: f32;

    let _e43 = (*param_9).moments;
    if (param_10 < 0.0001f) {
        phi_1017_ = 1f;
    } else {
        let _e52 = ((_e43.z - ((1f + param_10) * _e43.y)) + (param_10 * _e43.x));
        let _e61 = (((_e43.w - ((1f + param_10) * _e43.z)) + (param_10 * _e43.y)) / _e52);
        if (abs(_e52) <= 0.00000047683716f) {
            let _e75 = (1f - (((_e43.y - (_e43.x * (param_10 + 1f))) + (param_10 * 1f)) / ((0f - param_10) * (0f - 1f))));
            if ((bitcast<u32>(_e75) & 2147483647u) > 2139095040u) {
                phi_940_ = _e75;
            } else {
                if (_e75 < 0f) {
                    phi_939_ = 0f;
                } else {
                    if (_e75 > 1f) {
                        phi_938_ = 1f;
                    } else {
                        phi_938_ = _e75;
                    }
                    let _e82 = phi_938_;
                    phi_939_ = _e82;
                }
                let _e84 = phi_939_;
                phi_940_ = _e84;
            }
            let _e86 = phi_940_;
            phi_1016_ = _e86;
        } else {
            if (_e61 > 0f) {
                if (_e61 < param_10) {
                    let _e89 = lt_math_hausdorff_cubic_mass(_e43, 0f, _e61, param_10, 1f);
                    let _e91 = lt_math_hausdorff_cubic_mass(_e43, _e61, 0f, param_10, 1f);
                    let _e92 = ((1f - _e89) - _e91);
                    if ((bitcast<u32>(_e92) & 2147483647u) > 2139095040u) {
                        phi_969_ = _e92;
                    } else {
                        if (_e92 < 0f) {
                            phi_968_ = 0f;
                        } else {
                            if (_e92 > 1f) {
                                phi_967_ = 1f;
                            } else {
                                phi_967_ = _e92;
                            }
                            let _e99 = phi_967_;
                            phi_968_ = _e99;
                        }
                        let _e101 = phi_968_;
                        phi_969_ = _e101;
                    }
                    let _e103 = phi_969_;
                    phi_970_ = _e103;
                    phi_971_ = false;
                } else {
                    phi_970_ = f32();
                    phi_971_ = true;
                }
                let _e105 = phi_970_;
                let _e107 = phi_971_;
                phi_972_ = _e105;
                phi_973_ = _e107;
            } else {
                phi_972_ = f32();
                phi_973_ = true;
            }
            let _e109 = phi_972_;
            let _e111 = phi_973_;
            if _e111 {
                if (_e61 > param_10) {
                    if (_e61 < 1f) {
                        let _e114 = lt_math_hausdorff_cubic_mass(_e43, 0f, _e61, param_10, 1f);
                        let _e115 = (1f - _e114);
                        if ((bitcast<u32>(_e115) & 2147483647u) > 2139095040u) {
                            phi_1003_ = _e115;
                        } else {
                            if (_e115 < 0f) {
                                phi_1002_ = 0f;
                            } else {
                                if (_e115 > 1f) {
                                    phi_1001_ = 1f;
                                } else {
                                    phi_1001_ = _e115;
                                }
                                let _e122 = phi_1001_;
                                phi_1002_ = _e122;
                            }
                            let _e124 = phi_1002_;
                            phi_1003_ = _e124;
                        }
                        let _e126 = phi_1003_;
                        phi_1004_ = _e126;
                        phi_1005_ = false;
                    } else {
                        phi_1004_ = f32();
                        phi_1005_ = true;
                    }
                    let _e128 = phi_1004_;
                    let _e130 = phi_1005_;
                    phi_1006_ = _e128;
                    phi_1007_ = _e130;
                } else {
                    phi_1006_ = f32();
                    phi_1007_ = true;
                }
                let _e132 = phi_1006_;
                let _e134 = phi_1007_;
                if _e134 {
                    phi_1014_ = bitcast<f32>((bitcast<u32>(_e61) | 2143289344u));
                } else {
                    phi_1014_ = _e132;
                }
                let _e139 = phi_1014_;
                phi_1015_ = _e139;
            } else {
                phi_1015_ = _e109;
            }
            let _e141 = phi_1015_;
            phi_1016_ = _e141;
        }
        let _e143 = phi_1016_;
        phi_1017_ = _e143;
    }
    let _e145 = phi_1017_;
    return _e145;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_11: ptr<function, f32>, param_12: vec4<f32>, param_13: f32) -> f32 {
    var local_1: hankel_HankelFactors;
    var phi_225_: f32;
    var phi_226_: f32;
    var phi_227_: f32;
    var phi_239_: bool;
    var phi_254_: bool;
    var phi_279_: f32;
    var phi_280_: f32;
    var phi_281_: f32;
    var phi_282_: f32;
    var phi_283_: bool;
    var phi_284_: f32;
    var phi_285_: bool;
    var phi_341_: vec2<f32>;
    var phi_379_: f32;
    var phi_380_: f32;
    var phi_381_: f32;
    var phi_414_: f32;
    var phi_415_: f32;
    var phi_416_: f32;
    var phi_420_: f32;
    var phi_421_: f32;
    var phi_422_: f32;
    var phi_423_: f32;
    var phi_476_: vec2<f32>;
    var phi_498_: bool;
    var phi_523_: f32;
    var phi_524_: f32;
    var phi_525_: f32;
    var phi_526_: f32;
    var phi_527_: bool;
    var phi_528_: f32;
    var phi_529_: bool;
    var phi_585_: vec2<f32>;
    var phi_623_: f32;
    var phi_624_: f32;
    var phi_625_: f32;
    var phi_658_: f32;
    var phi_659_: f32;
    var phi_660_: f32;
    var phi_664_: f32;
    var phi_665_: f32;
    var phi_666_: f32;
    var phi_667_: f32;
    var phi_668_: f32;
    var phi_669_: bool;
    var phi_670_: f32;
    var phi_671_: bool;
    var phi_693_: bool;
    var phi_718_: f32;
    var phi_719_: f32;
    var phi_720_: f32;
    var phi_721_: f32;
    var phi_722_: bool;
    var phi_723_: f32;
    var phi_724_: bool;
    var phi_780_: vec2<f32>;
    var phi_818_: f32;
    var phi_819_: f32;
    var phi_820_: f32;
    var phi_853_: f32;
    var phi_854_: f32;
    var phi_855_: f32;
    var phi_859_: f32;
    var phi_860_: f32;
    var phi_861_: f32;
    var phi_862_: f32;
    var phi_873_: bool;
    var phi_877_: f32;
    var phi_878_: f32;
    var phi_879_: f32;
    var phi_880_: f32;

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
        phi_227_ = param_13;
    } else {
        if (param_13 < 0f) {
            phi_226_ = 0f;
        } else {
            if (param_13 > 1f) {
                phi_225_ = 1f;
            } else {
                phi_225_ = param_13;
            }
            let _e81 = phi_225_;
            phi_226_ = _e81;
        }
        let _e83 = phi_226_;
        phi_227_ = _e83;
    }
    let _e85 = phi_227_;
    let _e88 = local_1.moments[0u];
    let _e91 = local_1.moments[3u];
    if (_e88 == _e91) {
        let _e95 = local_1.moments[0u];
        phi_239_ = (_e95 > 0.5f);
    } else {
        phi_239_ = false;
    }
    let _e98 = phi_239_;
    if _e98 {
        let _e101 = local_1.moments[0u];
        let _e104 = local_1.moments[3u];
        if (_e101 == _e104) {
            let _e108 = local_1.moments[0u];
            phi_254_ = (_e108 > 0.5f);
        } else {
            phi_254_ = false;
        }
        let _e111 = phi_254_;
        if _e111 {
            if (_e85 > 0f) {
                let _e114 = local_1.moments;
                if ((bitcast<u32>(_e114.x) & 2147483647u) > 2139095040u) {
                    phi_281_ = _e114.x;
                } else {
                    if (_e114.x < 0f) {
                        phi_280_ = 0f;
                    } else {
                        if (_e114.x > 1f) {
                            phi_279_ = 1f;
                        } else {
                            phi_279_ = _e114.x;
                        }
                        let _e122 = phi_279_;
                        phi_280_ = _e122;
                    }
                    let _e124 = phi_280_;
                    phi_281_ = _e124;
                }
                let _e126 = phi_281_;
                phi_282_ = _e126;
                phi_283_ = false;
            } else {
                phi_282_ = f32();
                phi_283_ = true;
            }
            let _e128 = phi_282_;
            let _e130 = phi_283_;
            phi_284_ = _e128;
            phi_285_ = _e130;
        } else {
            phi_284_ = f32();
            phi_285_ = true;
        }
        let _e132 = phi_284_;
        let _e134 = phi_285_;
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
                phi_341_ = vec2<f32>((-(_e173) - _e178), (-(_e173) + _e178));
            } else {
                phi_341_ = vec2(bitcast<f32>((bitcast<u32>(_e176) | 2143289344u)));
            }
            let _e189 = phi_341_;
            if (_e85 <= _e189.x) {
                phi_422_ = 1f;
            } else {
                if (_e85 > _e189.y) {
                    let _e195 = local_1.moments;
                    let _e206 = (((_e195.y - (_e195.x * (_e189.x + _e189.y))) + (_e189.x * _e189.y)) / ((_e85 - _e189.x) * (_e85 - _e189.y)));
                    if ((bitcast<u32>(_e206) & 2147483647u) > 2139095040u) {
                        phi_381_ = _e206;
                    } else {
                        if (_e206 < 0f) {
                            phi_380_ = 0f;
                        } else {
                            if (_e206 > 1f) {
                                phi_379_ = 1f;
                            } else {
                                phi_379_ = _e206;
                            }
                            let _e213 = phi_379_;
                            phi_380_ = _e213;
                        }
                        let _e215 = phi_380_;
                        phi_381_ = _e215;
                    }
                    let _e217 = phi_381_;
                    phi_421_ = _e217;
                } else {
                    if (_e85 > _e189.x) {
                        let _e220 = local_1.moments;
                        let _e232 = (1f - (((_e220.y - (_e220.x * (_e85 + _e189.y))) + (_e85 * _e189.y)) / ((_e189.x - _e85) * (_e189.x - _e189.y))));
                        if ((bitcast<u32>(_e232) & 2147483647u) > 2139095040u) {
                            phi_416_ = _e232;
                        } else {
                            if (_e232 < 0f) {
                                phi_415_ = 0f;
                            } else {
                                if (_e232 > 1f) {
                                    phi_414_ = 1f;
                                } else {
                                    phi_414_ = _e232;
                                }
                                let _e239 = phi_414_;
                                phi_415_ = _e239;
                            }
                            let _e241 = phi_415_;
                            phi_416_ = _e241;
                        }
                        let _e243 = phi_416_;
                        phi_420_ = _e243;
                    } else {
                        phi_420_ = bitcast<f32>((bitcast<u32>(_e189.x) | 2143289344u));
                    }
                    let _e248 = phi_420_;
                    phi_421_ = _e248;
                }
                let _e250 = phi_421_;
                phi_422_ = _e250;
            }
            let _e252 = phi_422_;
            phi_423_ = _e252;
        } else {
            phi_423_ = _e132;
        }
        let _e254 = phi_423_;
        phi_880_ = _e254;
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
            phi_476_ = vec2<f32>((-(_e293) - _e298), (-(_e293) + _e298));
        } else {
            phi_476_ = vec2(bitcast<f32>((bitcast<u32>(_e296) | 2143289344u)));
        }
        let _e309 = phi_476_;
        if (_e309.x >= 0f) {
            if (_e309.y <= 1f) {
                let _e316 = local_1.moments[0u];
                let _e319 = local_1.moments[3u];
                if (_e316 == _e319) {
                    let _e323 = local_1.moments[0u];
                    phi_498_ = (_e323 > 0.5f);
                } else {
                    phi_498_ = false;
                }
                let _e326 = phi_498_;
                if _e326 {
                    if (_e85 > 0f) {
                        let _e329 = local_1.moments;
                        if ((bitcast<u32>(_e329.x) & 2147483647u) > 2139095040u) {
                            phi_525_ = _e329.x;
                        } else {
                            if (_e329.x < 0f) {
                                phi_524_ = 0f;
                            } else {
                                if (_e329.x > 1f) {
                                    phi_523_ = 1f;
                                } else {
                                    phi_523_ = _e329.x;
                                }
                                let _e337 = phi_523_;
                                phi_524_ = _e337;
                            }
                            let _e339 = phi_524_;
                            phi_525_ = _e339;
                        }
                        let _e341 = phi_525_;
                        phi_526_ = _e341;
                        phi_527_ = false;
                    } else {
                        phi_526_ = f32();
                        phi_527_ = true;
                    }
                    let _e343 = phi_526_;
                    let _e345 = phi_527_;
                    phi_528_ = _e343;
                    phi_529_ = _e345;
                } else {
                    phi_528_ = f32();
                    phi_529_ = true;
                }
                let _e347 = phi_528_;
                let _e349 = phi_529_;
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
                        phi_585_ = vec2<f32>((-(_e388) - _e393), (-(_e388) + _e393));
                    } else {
                        phi_585_ = vec2(bitcast<f32>((bitcast<u32>(_e391) | 2143289344u)));
                    }
                    let _e404 = phi_585_;
                    if (_e85 <= _e404.x) {
                        phi_666_ = 1f;
                    } else {
                        if (_e85 > _e404.y) {
                            let _e410 = local_1.moments;
                            let _e421 = (((_e410.y - (_e410.x * (_e404.x + _e404.y))) + (_e404.x * _e404.y)) / ((_e85 - _e404.x) * (_e85 - _e404.y)));
                            if ((bitcast<u32>(_e421) & 2147483647u) > 2139095040u) {
                                phi_625_ = _e421;
                            } else {
                                if (_e421 < 0f) {
                                    phi_624_ = 0f;
                                } else {
                                    if (_e421 > 1f) {
                                        phi_623_ = 1f;
                                    } else {
                                        phi_623_ = _e421;
                                    }
                                    let _e428 = phi_623_;
                                    phi_624_ = _e428;
                                }
                                let _e430 = phi_624_;
                                phi_625_ = _e430;
                            }
                            let _e432 = phi_625_;
                            phi_665_ = _e432;
                        } else {
                            if (_e85 > _e404.x) {
                                let _e435 = local_1.moments;
                                let _e447 = (1f - (((_e435.y - (_e435.x * (_e85 + _e404.y))) + (_e85 * _e404.y)) / ((_e404.x - _e85) * (_e404.x - _e404.y))));
                                if ((bitcast<u32>(_e447) & 2147483647u) > 2139095040u) {
                                    phi_660_ = _e447;
                                } else {
                                    if (_e447 < 0f) {
                                        phi_659_ = 0f;
                                    } else {
                                        if (_e447 > 1f) {
                                            phi_658_ = 1f;
                                        } else {
                                            phi_658_ = _e447;
                                        }
                                        let _e454 = phi_658_;
                                        phi_659_ = _e454;
                                    }
                                    let _e456 = phi_659_;
                                    phi_660_ = _e456;
                                }
                                let _e458 = phi_660_;
                                phi_664_ = _e458;
                            } else {
                                phi_664_ = bitcast<f32>((bitcast<u32>(_e404.x) | 2143289344u));
                            }
                            let _e463 = phi_664_;
                            phi_665_ = _e463;
                        }
                        let _e465 = phi_665_;
                        phi_666_ = _e465;
                    }
                    let _e467 = phi_666_;
                    phi_667_ = _e467;
                } else {
                    phi_667_ = _e347;
                }
                let _e469 = phi_667_;
                phi_668_ = _e469;
                phi_669_ = false;
            } else {
                phi_668_ = f32();
                phi_669_ = true;
            }
            let _e471 = phi_668_;
            let _e473 = phi_669_;
            phi_670_ = _e471;
            phi_671_ = _e473;
        } else {
            phi_670_ = f32();
            phi_671_ = true;
        }
        let _e475 = phi_670_;
        let _e477 = phi_671_;
        if _e477 {
            if ((bitcast<u32>(_e309.x) & 2147483647u) > 2139095040u) {
                phi_878_ = _e309.x;
            } else {
                let _e481 = lt_math_hausdorff_endpoint_upper_bound((&local_1), _e85);
                let _e484 = local_1.moments[0u];
                let _e487 = local_1.moments[3u];
                if (_e484 == _e487) {
                    let _e491 = local_1.moments[0u];
                    phi_693_ = (_e491 > 0.5f);
                } else {
                    phi_693_ = false;
                }
                let _e494 = phi_693_;
                if _e494 {
                    if (_e85 > 0f) {
                        let _e497 = local_1.moments;
                        if ((bitcast<u32>(_e497.x) & 2147483647u) > 2139095040u) {
                            phi_720_ = _e497.x;
                        } else {
                            if (_e497.x < 0f) {
                                phi_719_ = 0f;
                            } else {
                                if (_e497.x > 1f) {
                                    phi_718_ = 1f;
                                } else {
                                    phi_718_ = _e497.x;
                                }
                                let _e505 = phi_718_;
                                phi_719_ = _e505;
                            }
                            let _e507 = phi_719_;
                            phi_720_ = _e507;
                        }
                        let _e509 = phi_720_;
                        phi_721_ = _e509;
                        phi_722_ = false;
                    } else {
                        phi_721_ = f32();
                        phi_722_ = true;
                    }
                    let _e511 = phi_721_;
                    let _e513 = phi_722_;
                    phi_723_ = _e511;
                    phi_724_ = _e513;
                } else {
                    phi_723_ = f32();
                    phi_724_ = true;
                }
                let _e515 = phi_723_;
                let _e517 = phi_724_;
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
                        phi_780_ = vec2<f32>((-(_e556) - _e561), (-(_e556) + _e561));
                    } else {
                        phi_780_ = vec2(bitcast<f32>((bitcast<u32>(_e559) | 2143289344u)));
                    }
                    let _e572 = phi_780_;
                    if (_e85 <= _e572.x) {
                        phi_861_ = 1f;
                    } else {
                        if (_e85 > _e572.y) {
                            let _e578 = local_1.moments;
                            let _e589 = (((_e578.y - (_e578.x * (_e572.x + _e572.y))) + (_e572.x * _e572.y)) / ((_e85 - _e572.x) * (_e85 - _e572.y)));
                            if ((bitcast<u32>(_e589) & 2147483647u) > 2139095040u) {
                                phi_820_ = _e589;
                            } else {
                                if (_e589 < 0f) {
                                    phi_819_ = 0f;
                                } else {
                                    if (_e589 > 1f) {
                                        phi_818_ = 1f;
                                    } else {
                                        phi_818_ = _e589;
                                    }
                                    let _e596 = phi_818_;
                                    phi_819_ = _e596;
                                }
                                let _e598 = phi_819_;
                                phi_820_ = _e598;
                            }
                            let _e600 = phi_820_;
                            phi_860_ = _e600;
                        } else {
                            if (_e85 > _e572.x) {
                                let _e603 = local_1.moments;
                                let _e615 = (1f - (((_e603.y - (_e603.x * (_e85 + _e572.y))) + (_e85 * _e572.y)) / ((_e572.x - _e85) * (_e572.x - _e572.y))));
                                if ((bitcast<u32>(_e615) & 2147483647u) > 2139095040u) {
                                    phi_855_ = _e615;
                                } else {
                                    if (_e615 < 0f) {
                                        phi_854_ = 0f;
                                    } else {
                                        if (_e615 > 1f) {
                                            phi_853_ = 1f;
                                        } else {
                                            phi_853_ = _e615;
                                        }
                                        let _e622 = phi_853_;
                                        phi_854_ = _e622;
                                    }
                                    let _e624 = phi_854_;
                                    phi_855_ = _e624;
                                }
                                let _e626 = phi_855_;
                                phi_859_ = _e626;
                            } else {
                                phi_859_ = bitcast<f32>((bitcast<u32>(_e572.x) | 2143289344u));
                            }
                            let _e631 = phi_859_;
                            phi_860_ = _e631;
                        }
                        let _e633 = phi_860_;
                        phi_861_ = _e633;
                    }
                    let _e635 = phi_861_;
                    phi_862_ = _e635;
                } else {
                    phi_862_ = _e515;
                }
                let _e637 = phi_862_;
                if ((bitcast<u32>(_e637) & 2147483647u) > 2139095040u) {
                    phi_873_ = true;
                } else {
                    let _e641 = (_e637 < _e481);
                    if _e641 {
                    }
                    phi_873_ = _e641;
                }
                let _e643 = phi_873_;
                if _e643 {
                    phi_877_ = _e637;
                } else {
                    phi_877_ = _e481;
                }
                let _e645 = phi_877_;
                phi_878_ = _e645;
            }
            let _e647 = phi_878_;
            phi_879_ = _e647;
        } else {
            phi_879_ = _e475;
        }
        let _e649 = phi_879_;
        phi_880_ = _e649;
    }
    let _e651 = phi_880_;
    return _e651;
}

fn function_() {
    var local_2: f32;
    var phi_1095_: bool;
    var phi_1096_: bool;
    var phi_1097_: bool;
    var phi_1098_: bool;
    var phi_1102_: bool;
    var phi_1146_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1150_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1227_: bool;
    var phi_1236_: bool;
    var phi_1245_: bool;
    var phi_1246_: bool;
    var phi_1247_: bool;
    var phi_1248_: bool;
    var phi_1249_: bool;
    var phi_1250_: bool;
    var phi_1251_: bool;
    var phi_1255_: bool;
    var phi_1349_: f32;
    var phi_1352_: f32;
    var phi_1381_: f32;
    var phi_1386_: f32;
    var phi_1387_: bool;
    var phi_1388_: f32;
    var phi_1389_: bool;
    var phi_1393_: f32;
    var phi_1413_: f32;
    var phi_1418_: f32;
    var phi_1419_: bool;
    var phi_1420_: f32;
    var phi_1421_: bool;
    var phi_1425_: f32;
    var phi_1471_: i32;
    var phi_1476_: i32;
    var phi_1481_: i32;
    var phi_1486_: i32;
    var phi_1495_: i32;
    var phi_1500_: i32;
    var phi_1505_: i32;
    var phi_1510_: i32;
    var phi_1601_: bool;
    var phi_1609_: bool;
    var phi_1621_: bool;
    var phi_1622_: bool;
    var phi_1626_: f32;
    var phi_1632_: f32;
    var phi_1634_: evaluate_Verdict;
    var phi_1639_: evaluate_Verdict;
    var phi_1640_: evaluate_Verdict;
    var phi_1644_: bool;
    var phi_1645_: u32;
    var phi_1656_: u32;

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
                phi_1095_ = (_e75 == _e77);
                phi_1096_ = false;
            } else {
                phi_1095_ = bool();
                phi_1096_ = true;
            }
            let _e80 = phi_1095_;
            let _e82 = phi_1096_;
            phi_1097_ = _e80;
            phi_1098_ = _e82;
        } else {
            phi_1097_ = bool();
            phi_1098_ = true;
        }
        let _e84 = phi_1097_;
        let _e86 = phi_1098_;
        if _e86 {
            phi_1102_ = false;
        } else {
            phi_1102_ = _e84;
        }
        let _e88 = phi_1102_;
        if !(_e88) {
            let _e91 = samples.member[_e55.first_primitive].normal;
            let _e93 = samples.member[_e55.first_primitive].position;
            if ((((_e91.x * (_e62.x - (_e93.x * _e62.w))) + (_e91.y * (_e62.y - (_e93.y * _e62.w)))) + (_e91.z * (_e62.z - (_e93.z * _e62.w)))) > 0f) {
                let _e117 = samples.member[_e55.first_primitive].flags;
                let _e125 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e131 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e125.unnamed.visibility, false), _e125.unnamed_1);
                phi_1146_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e131.unnamed, ((_e117 & 1u) == 0u));
            } else {
                let _e140 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e146 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e140.unnamed.visibility, false), _e140.unnamed_1);
                phi_1146_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e146.unnamed, true);
            }
            let _e151 = phi_1146_;
            phi_1150_ = _e151;
        } else {
            let _e157 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e163 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e157.unnamed.visibility, false), _e157.unnamed_1);
            phi_1150_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e163.unnamed, true);
        }
        let _e168 = phi_1150_;
        if _e168.unnamed_1 {
            phi_1640_ = evaluate_Verdict(_e168.unnamed.visibility, _e168.unnamed.is_doubted);
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
                    phi_1227_ = (_e207 <= 1f);
                } else {
                    phi_1227_ = false;
                }
                let _e239 = phi_1227_;
                if _e239 {
                    if (_e221 >= 0f) {
                        phi_1236_ = (_e221 <= 1f);
                    } else {
                        phi_1236_ = false;
                    }
                    let _e243 = phi_1236_;
                    if _e243 {
                        if (_e234 >= 0f) {
                            phi_1245_ = (_e234 <= 1f);
                        } else {
                            phi_1245_ = false;
                        }
                        let _e247 = phi_1245_;
                        phi_1246_ = _e247;
                        phi_1247_ = false;
                    } else {
                        phi_1246_ = bool();
                        phi_1247_ = true;
                    }
                    let _e249 = phi_1246_;
                    let _e251 = phi_1247_;
                    phi_1248_ = _e249;
                    phi_1249_ = _e251;
                } else {
                    phi_1248_ = bool();
                    phi_1249_ = true;
                }
                let _e253 = phi_1248_;
                let _e255 = phi_1249_;
                phi_1250_ = _e253;
                phi_1251_ = _e255;
            } else {
                phi_1250_ = bool();
                phi_1251_ = true;
            }
            let _e257 = phi_1250_;
            let _e259 = phi_1251_;
            if _e259 {
                phi_1255_ = false;
            } else {
                phi_1255_ = _e257;
            }
            let _e261 = phi_1255_;
            if _e261 {
                if (0f > 0f) {
                    let _e264 = samples.member[_e55.first_primitive].normal;
                    let _e266 = p.member.map_size;
                    let _e269 = p.member.projection.row_x;
                    let _e291 = p.member.projection.row_y;
                    let _e313 = p.member.projection.row_z;
                    let _e340 = ((abs(((((_e269.x * _e264.x) + (_e269.y * _e264.y)) + (_e269.z * _e264.z)) / (((_e269.x * _e269.x) + (_e269.y * _e269.y)) + (_e269.z * _e269.z)))) + abs(((((_e291.x * _e264.x) + (_e291.y * _e264.y)) + (_e291.z * _e264.z)) / (((_e291.x * _e291.x) + (_e291.y * _e291.y)) + (_e291.z * _e291.z))))) / (abs(((((_e313.x * _e264.x) + (_e313.y * _e264.y)) + (_e313.z * _e264.z)) / (((_e313.x * _e313.x) + (_e313.y * _e313.y)) + (_e313.z * _e313.z)))) * f32(_e266)));
                    if (_e340 < 0.002f) {
                        phi_1349_ = _e340;
                    } else {
                        phi_1349_ = 0.002f;
                    }
                    let _e343 = phi_1349_;
                    phi_1352_ = (_e234 - (0f * _e343));
                } else {
                    phi_1352_ = _e234;
                }
                let _e347 = phi_1352_;
                let _e349 = p.member.map_size;
                let _e350 = f32(_e349);
                let _e353 = ((_e207 * _e350) - 0.5f);
                let _e354 = ((_e221 * _e350) - 0.5f);
                if (_e353 > -8388608f) {
                    let _e366 = f32(select(0i, select(select(i32(_e353), i32(-2147483648), (_e353 < bitcast<f32>(3472883712u))), 2147483647i, (_e353 > bitcast<f32>(1325400063u))), (_e353 == _e353)));
                    if (_e366 > _e353) {
                        phi_1381_ = 1f;
                    } else {
                        phi_1381_ = 0f;
                    }
                    let _e369 = phi_1381_;
                    if (_e353 < 8388608f) {
                        phi_1386_ = (_e366 - _e369);
                        phi_1387_ = false;
                    } else {
                        phi_1386_ = f32();
                        phi_1387_ = true;
                    }
                    let _e372 = phi_1386_;
                    let _e374 = phi_1387_;
                    phi_1388_ = _e372;
                    phi_1389_ = _e374;
                } else {
                    phi_1388_ = f32();
                    phi_1389_ = true;
                }
                let _e376 = phi_1388_;
                let _e378 = phi_1389_;
                if _e378 {
                    phi_1393_ = _e353;
                } else {
                    phi_1393_ = _e376;
                }
                let _e380 = phi_1393_;
                if (_e354 > -8388608f) {
                    let _e392 = f32(select(0i, select(select(i32(_e354), i32(-2147483648), (_e354 < bitcast<f32>(3472883712u))), 2147483647i, (_e354 > bitcast<f32>(1325400063u))), (_e354 == _e354)));
                    if (_e392 > _e354) {
                        phi_1413_ = 1f;
                    } else {
                        phi_1413_ = 0f;
                    }
                    let _e395 = phi_1413_;
                    if (_e354 < 8388608f) {
                        phi_1418_ = (_e392 - _e395);
                        phi_1419_ = false;
                    } else {
                        phi_1418_ = f32();
                        phi_1419_ = true;
                    }
                    let _e398 = phi_1418_;
                    let _e400 = phi_1419_;
                    phi_1420_ = _e398;
                    phi_1421_ = _e400;
                } else {
                    phi_1420_ = f32();
                    phi_1421_ = true;
                }
                let _e402 = phi_1420_;
                let _e404 = phi_1421_;
                if _e404 {
                    phi_1425_ = _e354;
                } else {
                    phi_1425_ = _e402;
                }
                let _e406 = phi_1425_;
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
                    phi_1471_ = _e417;
                } else {
                    phi_1471_ = 0i;
                }
                let _e444 = phi_1471_;
                if (_e426 > 0i) {
                    phi_1476_ = _e426;
                } else {
                    phi_1476_ = 0i;
                }
                let _e447 = phi_1476_;
                if (_e444 < _e441) {
                    phi_1481_ = _e444;
                } else {
                    phi_1481_ = _e441;
                }
                let _e450 = phi_1481_;
                if (_e447 < _e441) {
                    phi_1486_ = _e447;
                } else {
                    phi_1486_ = _e441;
                }
                let _e453 = phi_1486_;
                let _e454 = bitcast<u32>(_e450);
                let _e456 = (_e417 + 1i);
                let _e457 = (_e426 + 1i);
                if (_e456 > 0i) {
                    phi_1495_ = _e456;
                } else {
                    phi_1495_ = 0i;
                }
                let _e460 = phi_1495_;
                if (_e457 > 0i) {
                    phi_1500_ = _e457;
                } else {
                    phi_1500_ = 0i;
                }
                let _e463 = phi_1500_;
                if (_e460 < _e441) {
                    phi_1505_ = _e460;
                } else {
                    phi_1505_ = _e441;
                }
                let _e466 = phi_1505_;
                if (_e463 < _e441) {
                    phi_1510_ = _e463;
                } else {
                    phi_1510_ = _e441;
                }
                let _e469 = phi_1510_;
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
                let _e493 = map.member[(0u + _e475)];
                if (_e476 < _e47) {
                } else {
                    return;
                }
                let _e509 = map.member[(0u + _e476)];
                if (_e477 < _e47) {
                } else {
                    return;
                }
                let _e525 = map.member[(0u + _e477)];
                let _e539 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_2), vec4<f32>(((((_e481.x * _e429) + (_e493.x * _e431)) + (_e509.x * _e433)) + (_e525.x * _e434)), ((((_e481.y * _e429) + (_e493.y * _e431)) + (_e509.y * _e433)) + (_e525.y * _e434)), ((((_e481.z * _e429) + (_e493.z * _e431)) + (_e509.z * _e433)) + (_e525.z * _e434)), ((((_e481.w * _e429) + (_e493.w * _e431)) + (_e509.w * _e433)) + (_e525.w * _e434))), _e347);
                let _e541 = p.member.epsilon;
                if (_e539 <= _e541) {
                    phi_1601_ = true;
                } else {
                    phi_1601_ = (_e539 >= (1f - _e541));
                }
                let _e546 = phi_1601_;
                if ((bitcast<u32>(_e539) & 2147483647u) > 2139095040u) {
                    phi_1609_ = true;
                } else {
                    phi_1609_ = !(_e546);
                }
                let _e552 = phi_1609_;
                if _e552 {
                    if (_e539 > 0f) {
                        if (_e539 < 1f) {
                            phi_1621_ = false;
                        } else {
                            phi_1621_ = true;
                        }
                        let _e556 = phi_1621_;
                        phi_1622_ = _e556;
                    } else {
                        phi_1622_ = true;
                    }
                    let _e558 = phi_1622_;
                    if _e558 {
                        phi_1626_ = 0.5f;
                    } else {
                        phi_1626_ = _e539;
                    }
                    let _e560 = phi_1626_;
                    phi_1634_ = evaluate_Verdict(_e560, true);
                } else {
                    if (_e539 > 0.5f) {
                        phi_1632_ = 1f;
                    } else {
                        phi_1632_ = 0f;
                    }
                    let _e564 = phi_1632_;
                    phi_1634_ = evaluate_Verdict(_e564, false);
                }
                let _e567 = phi_1634_;
                phi_1639_ = evaluate_Verdict(_e567.visibility, _e567.is_doubted);
            } else {
                phi_1639_ = evaluate_Verdict(0.5f, true);
            }
            let _e573 = phi_1639_;
            phi_1640_ = _e573;
        }
        let _e575 = phi_1640_;
        visibility.member[_e55.first_primitive] = _e575.visibility;
        phi_1644_ = _e575.is_doubted;
        phi_1645_ = _e55.first_primitive;
    } else {
        phi_1644_ = false;
        phi_1645_ = 0u;
    }
    let _e580 = phi_1644_;
    let _e582 = phi_1645_;
    if (_e42 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e580 {
        let _e586 = atomicAdd((&shared_[0u]), 1u);
        phi_1656_ = _e586;
    } else {
        phi_1656_ = 0u;
    }
    let _e588 = phi_1656_;
    workgroupBarrier();
    if (_e42 == 0u) {
        let _e592 = atomicLoad((&shared_[0u]));
        let _e593 = atomicAdd((&list.member[3u]), _e592);
        atomicStore((&shared_[1u]), _e593);
    }
    workgroupBarrier();
    if _e580 {
        let _e596 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e596) + _e588)]), _e582);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_msm_hausdorff_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_3 = local;
    function_();
}
