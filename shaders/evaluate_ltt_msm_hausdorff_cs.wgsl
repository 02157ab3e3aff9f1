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
    var phi_158_: lt_bvh_traverse_Tree;
    var phi_159_: bool;
    var phi_160_: lt_bvh_traverse_Tree;
    var phi_161_: bool;
    var phi_166_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_158_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_159_ = false;
        } else {
            phi_158_ = lt_bvh_traverse_Tree();
            phi_159_ = true;
        }
        let _e52 = phi_158_;
        let _e54 = phi_159_;
        phi_160_ = _e52;
        phi_161_ = _e54;
    } else {
        phi_160_ = lt_bvh_traverse_Tree();
        phi_161_ = true;
    }
    let _e56 = phi_160_;
    let _e58 = phi_161_;
    if _e58 {
        phi_166_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_166_ = _e56;
    }
    let _e63 = phi_166_;
    return lt_bvh_traverse_Tree(_e63.root, _e63.first_primitive);
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_4: f32) -> vec4<f32> {
    var phi_189_: f32;
    var phi_190_: f32;
    var phi_191_: f32;

    if ((bitcast<u32>(param_4) & 2147483647u) > 2139095040u) {
        phi_191_ = param_4;
    } else {
        if (param_4 < 0f) {
            phi_190_ = 0f;
        } else {
            if (param_4 > 1f) {
                phi_189_ = 1f;
            } else {
                phi_189_ = param_4;
            }
            let _e46 = phi_189_;
            phi_190_ = _e46;
        }
        let _e48 = phi_190_;
        phi_191_ = _e48;
    }
    let _e50 = phi_191_;
    let _e51 = (_e50 * _e50);
    return vec4<f32>(_e50, _e51, (_e51 * _e50), (_e51 * _e51));
}

fn lt_math_hausdorff_cubic_mass(param_5: vec4<f32>, param_6: f32, param_7: f32, param_8: f32, param_9: f32) -> f32 {
    return ((((param_5.z - (((param_7 + param_8) + param_9) * param_5.y)) + ((((param_7 * param_8) + (param_7 * param_9)) + (param_8 * param_9)) * param_5.x)) - ((param_7 * param_8) * param_9)) / (((param_6 - param_7) * (param_6 - param_8)) * (param_6 - param_9)));
}

fn lt_math_hausdorff_endpoint_upper_bound(param_10: ptr<function, hankel_HankelFactors>, param_11: f32) -> f32 {
    var phi_1029_: f32;
    var phi_1030_: f32;
    var phi_1031_: f32;
    var phi_1058_: f32;
    var phi_1059_: f32;
    var phi_1060_: f32;
    var phi_1061_: f32;
    var phi_1062_: bool;
    var phi_1063_: f32;
    var phi_1064_: bool;
    var phi_1092_: f32;
    var phi_1093_: f32;
    var phi_1094_: f32;
    var phi_1095_: f32;
    var phi_1096_: bool;
    var phi_1097_: f32;
    var phi_1098_: bool;
    var phi_1105_: f32;
    var phi_1106_: f32;
    var phi_1107_: f32;
    var phi_1108_: f32;

    let _e42 = (*param_10).moments;
    if (param_11 < 0.0001f) {
        phi_1108_ = 1f;
    } else {
        let _e51 = ((_e42.z - ((1f + param_11) * _e42.y)) + (param_11 * _e42.x));
        let _e60 = (((_e42.w - ((1f + param_11) * _e42.z)) + (param_11 * _e42.y)) / _e51);
        if (abs(_e51) <= 0.00000047683716f) {
            let _e74 = (1f - (((_e42.y - (_e42.x * (param_11 + 1f))) + (param_11 * 1f)) / ((0f - param_11) * (0f - 1f))));
            if ((bitcast<u32>(_e74) & 2147483647u) > 2139095040u) {
                phi_1031_ = _e74;
            } else {
                if (_e74 < 0f) {
                    phi_1030_ = 0f;
                } else {
                    if (_e74 > 1f) {
                        phi_1029_ = 1f;
                    } else {
                        phi_1029_ = _e74;
                    }
                    let _e81 = phi_1029_;
                    phi_1030_ = _e81;
                }
                let _e83 = phi_1030_;
                phi_1031_ = _e83;
            }
            let _e85 = phi_1031_;
            phi_1107_ = _e85;
        } else {
            if (_e60 > 0f) {
                if (_e60 < param_11) {
                    let _e88 = lt_math_hausdorff_cubic_mass(_e42, 0f, _e60, param_11, 1f);
                    let _e90 = lt_math_hausdorff_cubic_mass(_e42, _e60, 0f, param_11, 1f);
                    let _e91 = ((1f - _e88) - _e90);
                    if ((bitcast<u32>(_e91) & 2147483647u) > 2139095040u) {
                        phi_1060_ = _e91;
                    } else {
                        if (_e91 < 0f) {
                            phi_1059_ = 0f;
                        } else {
                            if (_e91 > 1f) {
                                phi_1058_ = 1f;
                            } else {
                                phi_1058_ = _e91;
                            }
                            let _e98 = phi_1058_;
                            phi_1059_ = _e98;
                        }
                        let _e100 = phi_1059_;
                        phi_1060_ = _e100;
                    }
                    let _e102 = phi_1060_;
                    phi_1061_ = _e102;
                    phi_1062_ = false;
                } else {
                    phi_1061_ = f32();
                    phi_1062_ = true;
                }
                let _e104 = phi_1061_;
                let _e106 = phi_1062_;
                phi_1063_ = _e104;
                phi_1064_ = _e106;
            } else {
                phi_1063_ = f32();
                phi_1064_ = true;
            }
            let _e108 = phi_1063_;
            let _e110 = phi_1064_;
            if _e110 {
                if (_e60 > param_11) {
                    if (_e60 < 1f) {
                        let _e113 = lt_math_hausdorff_cubic_mass(_e42, 0f, _e60, param_11, 1f);
                        let _e114 = (1f - _e113);
                        if ((bitcast<u32>(_e114) & 2147483647u) > 2139095040u) {
                            phi_1094_ = _e114;
                        } else {
                            if (_e114 < 0f) {
                                phi_1093_ = 0f;
                            } else {
                                if (_e114 > 1f) {
                                    phi_1092_ = 1f;
                                } else {
                                    phi_1092_ = _e114;
                                }
                                let _e121 = phi_1092_;
                                phi_1093_ = _e121;
                            }
                            let _e123 = phi_1093_;
                            phi_1094_ = _e123;
                        }
                        let _e125 = phi_1094_;
                        phi_1095_ = _e125;
                        phi_1096_ = false;
                    } else {
                        phi_1095_ = f32();
                        phi_1096_ = true;
                    }
                    let _e127 = phi_1095_;
                    let _e129 = phi_1096_;
                    phi_1097_ = _e127;
                    phi_1098_ = _e129;
                } else {
                    phi_1097_ = f32();
                    phi_1098_ = true;
                }
                let _e131 = phi_1097_;
                let _e133 = phi_1098_;
                if _e133 {
                    phi_1105_ = bitcast<f32>((bitcast<u32>(_e60) | 2143289344u));
                } else {
                    phi_1105_ = _e131;
                }
                let _e138 = phi_1105_;
                phi_1106_ = _e138;
            } else {
                phi_1106_ = _e108;
            }
            let _e140 = phi_1106_;
            phi_1107_ = _e140;
        }
        let _e142 = phi_1107_;
        phi_1108_ = _e142;
    }
    let _e144 = phi_1108_;
    return _e144;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_12: ptr<function, f32>, param_13: vec4<f32>, param_14: f32) -> f32 {
    var local_1: hankel_HankelFactors;
    var phi_309_: f32;
    var phi_310_: f32;
    var phi_311_: f32;
    var phi_323_: bool;
    var phi_338_: bool;
    var phi_363_: f32;
    var phi_364_: f32;
    var phi_365_: f32;
    var phi_366_: f32;
    var phi_367_: bool;
    var phi_368_: f32;
    var phi_369_: bool;
    var phi_425_: vec2<f32>;
    var phi_463_: f32;
    var phi_464_: f32;
    var phi_465_: f32;
    var phi_498_: f32;
    var phi_499_: f32;
    var phi_500_: f32;
    var phi_504_: f32;
    var phi_505_: f32;
    var phi_506_: f32;
    var phi_507_: f32;
    var phi_560_: vec2<f32>;
    var phi_582_: bool;
    var phi_607_: f32;
    var phi_608_: f32;
    var phi_609_: f32;
    var phi_610_: f32;
    var phi_611_: bool;
    var phi_612_: f32;
    var phi_613_: bool;
    var phi_669_: vec2<f32>;
    var phi_707_: f32;
    var phi_708_: f32;
    var phi_709_: f32;
    var phi_742_: f32;
    var phi_743_: f32;
    var phi_744_: f32;
    var phi_748_: f32;
    var phi_749_: f32;
    var phi_750_: f32;
    var phi_751_: f32;
    var phi_752_: f32;
    var phi_753_: bool;
    var phi_754_: f32;
    var phi_755_: bool;
    var phi_777_: bool;
    var phi_802_: f32;
    var phi_803_: f32;
    var phi_804_: f32;
    var phi_805_: f32;
    var phi_806_: bool;
    var phi_807_: f32;
    var phi_808_: bool;
    var phi_864_: vec2<f32>;
    var phi_902_: f32;
    var phi_903_: f32;
    var phi_904_: f32;
    var phi_937_: f32;
    var phi_938_: f32;
    var phi_939_: f32;
    var phi_943_: f32;
    var phi_944_: f32;
    var phi_945_: f32;
    var phi_946_: f32;
    var phi_963_: bool;
    var phi_967_: f32;
    var phi_968_: f32;
    var phi_969_: f32;
    var phi_970_: f32;
    var phi_971_: f32;

    let _e43 = (*param_12);
    let _e44 = (1f - _e43);
    let _e53 = (0.5f * _e43);
    let _e54 = ((param_13.x * _e44) + _e53);
    let _e55 = ((param_13.y * _e44) + _e53);
    let _e56 = ((param_13.z * _e44) + _e53);
    let _e57 = ((param_13.w * _e44) + _e53);
    let _e60 = (_e55 - (_e54 * _e54));
    let _e62 = (_e56 - (_e54 * _e55));
    let _e68 = hankel_HankelFactors(vec4<f32>(_e54, _e55, _e56, _e57), _e60, _e62, (((_e57 - (_e55 * _e55)) * _e60) - (_e62 * _e62)));
    local_1 = hankel_HankelFactors(_e68.moments, _e68.d22_, _e68.l32_d22_, _e68.d33_d22_);
    if ((bitcast<u32>(param_14) & 2147483647u) > 2139095040u) {
        phi_311_ = param_14;
    } else {
        if (param_14 < 0f) {
            phi_310_ = 0f;
        } else {
            if (param_14 > 1f) {
                phi_309_ = 1f;
            } else {
                phi_309_ = param_14;
            }
            let _e80 = phi_309_;
            phi_310_ = _e80;
        }
        let _e82 = phi_310_;
        phi_311_ = _e82;
    }
    let _e84 = phi_311_;
    let _e87 = local_1.moments[0u];
    let _e90 = local_1.moments[3u];
    if (_e87 == _e90) {
        let _e94 = local_1.moments[0u];
        phi_323_ = (_e94 > 0.5f);
    } else {
        phi_323_ = false;
    }
    let _e97 = phi_323_;
    if _e97 {
        let _e100 = local_1.moments[0u];
        let _e103 = local_1.moments[3u];
        if (_e100 == _e103) {
            let _e107 = local_1.moments[0u];
            phi_338_ = (_e107 > 0.5f);
        } else {
            phi_338_ = false;
        }
        let _e110 = phi_338_;
        if _e110 {
            if (_e84 > 0f) {
                let _e113 = local_1.moments;
                if ((bitcast<u32>(_e113.x) & 2147483647u) > 2139095040u) {
                    phi_365_ = _e113.x;
                } else {
                    if (_e113.x < 0f) {
                        phi_364_ = 0f;
                    } else {
                        if (_e113.x > 1f) {
                            phi_363_ = 1f;
                        } else {
                            phi_363_ = _e113.x;
                        }
                        let _e121 = phi_363_;
                        phi_364_ = _e121;
                    }
                    let _e123 = phi_364_;
                    phi_365_ = _e123;
                }
                let _e125 = phi_365_;
                phi_366_ = _e125;
                phi_367_ = false;
            } else {
                phi_366_ = f32();
                phi_367_ = true;
            }
            let _e127 = phi_366_;
            let _e129 = phi_367_;
            phi_368_ = _e127;
            phi_369_ = _e129;
        } else {
            phi_368_ = f32();
            phi_369_ = true;
        }
        let _e131 = phi_368_;
        let _e133 = phi_369_;
        if _e133 {
            let _e136 = local_1.moments[0u];
            let _e139 = local_1.moments[1u];
            let _e147 = local_1.l32_d22_;
            let _e149 = local_1.d22_;
            let _e150 = (_e147 / _e149);
            let _e151 = (_e84 - _e136);
            let _e157 = local_1.d22_;
            let _e160 = local_1.d33_d22_;
            let _e161 = (((((_e84 * _e84) - _e139) - (_e150 * _e151)) * _e157) / _e160);
            let _e163 = local_1.d22_;
            let _e166 = ((_e151 / _e163) - (_e150 * _e161));
            let _e172 = ((0.5f * _e166) / _e161);
            let _e175 = ((_e172 * _e172) - (((1f - (_e166 * _e136)) - (_e161 * _e139)) / _e161));
            if (_e175 >= 0f) {
                let _e177 = sqrt(_e175);
                phi_425_ = vec2<f32>((-(_e172) - _e177), (-(_e172) + _e177));
            } else {
                phi_425_ = vec2(bitcast<f32>((bitcast<u32>(_e175) | 2143289344u)));
            }
            let _e188 = phi_425_;
            if (_e84 <= _e188.x) {
                phi_506_ = 1f;
            } else {
                if (_e84 > _e188.y) {
                    let _e194 = local_1.moments;
                    let _e205 = (((_e194.y - (_e194.x * (_e188.x + _e188.y))) + (_e188.x * _e188.y)) / ((_e84 - _e188.x) * (_e84 - _e188.y)));
                    if ((bitcast<u32>(_e205) & 2147483647u) > 2139095040u) {
                        phi_465_ = _e205;
                    } else {
                        if (_e205 < 0f) {
                            phi_464_ = 0f;
                        } else {
                            if (_e205 > 1f) {
                                phi_463_ = 1f;
                            } else {
                                phi_463_ = _e205;
                            }
                            let _e212 = phi_463_;
                            phi_464_ = _e212;
                        }
                        let _e214 = phi_464_;
                        phi_465_ = _e214;
                    }
                    let _e216 = phi_465_;
                    phi_505_ = _e216;
                } else {
                    if (_e84 > _e188.x) {
                        let _e219 = local_1.moments;
                        let _e231 = (1f - (((_e219.y - (_e219.x * (_e84 + _e188.y))) + (_e84 * _e188.y)) / ((_e188.x - _e84) * (_e188.x - _e188.y))));
                        if ((bitcast<u32>(_e231) & 2147483647u) > 2139095040u) {
                            phi_500_ = _e231;
                        } else {
                            if (_e231 < 0f) {
                                phi_499_ = 0f;
                            } else {
                                if (_e231 > 1f) {
                                    phi_498_ = 1f;
                                } else {
                                    phi_498_ = _e231;
                                }
                                let _e238 = phi_498_;
                                phi_499_ = _e238;
                            }
                            let _e240 = phi_499_;
                            phi_500_ = _e240;
                        }
                        let _e242 = phi_500_;
                        phi_504_ = _e242;
                    } else {
                        phi_504_ = bitcast<f32>((bitcast<u32>(_e188.x) | 2143289344u));
                    }
                    let _e247 = phi_504_;
                    phi_505_ = _e247;
                }
                let _e249 = phi_505_;
                phi_506_ = _e249;
            }
            let _e251 = phi_506_;
            phi_507_ = _e251;
        } else {
            phi_507_ = _e131;
        }
        let _e253 = phi_507_;
        phi_971_ = _e253;
    } else {
        let _e256 = local_1.moments[0u];
        let _e259 = local_1.moments[1u];
        let _e267 = local_1.l32_d22_;
        let _e269 = local_1.d22_;
        let _e270 = (_e267 / _e269);
        let _e271 = (_e84 - _e256);
        let _e277 = local_1.d22_;
        let _e280 = local_1.d33_d22_;
        let _e281 = (((((_e84 * _e84) - _e259) - (_e270 * _e271)) * _e277) / _e280);
        let _e283 = local_1.d22_;
        let _e286 = ((_e271 / _e283) - (_e270 * _e281));
        let _e292 = ((0.5f * _e286) / _e281);
        let _e295 = ((_e292 * _e292) - (((1f - (_e286 * _e256)) - (_e281 * _e259)) / _e281));
        if (_e295 >= 0f) {
            let _e297 = sqrt(_e295);
            phi_560_ = vec2<f32>((-(_e292) - _e297), (-(_e292) + _e297));
        } else {
            phi_560_ = vec2(bitcast<f32>((bitcast<u32>(_e295) | 2143289344u)));
        }
        let _e308 = phi_560_;
        if (_e308.x >= 0f) {
            if (_e308.y <= 1f) {
                let _e315 = local_1.moments[0u];
                let _e318 = local_1.moments[3u];
                if (_e315 == _e318) {
                    let _e322 = local_1.moments[0u];
                    phi_582_ = (_e322 > 0.5f);
                } else {
                    phi_582_ = false;
                }
                let _e325 = phi_582_;
                if _e325 {
                    if (_e84 > 0f) {
                        let _e328 = local_1.moments;
                        if ((bitcast<u32>(_e328.x) & 2147483647u) > 2139095040u) {
                            phi_609_ = _e328.x;
                        } else {
                            if (_e328.x < 0f) {
                                phi_608_ = 0f;
                            } else {
                                if (_e328.x > 1f) {
                                    phi_607_ = 1f;
                                } else {
                                    phi_607_ = _e328.x;
                                }
                                let _e336 = phi_607_;
                                phi_608_ = _e336;
                            }
                            let _e338 = phi_608_;
                            phi_609_ = _e338;
                        }
                        let _e340 = phi_609_;
                        phi_610_ = _e340;
                        phi_611_ = false;
                    } else {
                        phi_610_ = f32();
                        phi_611_ = true;
                    }
                    let _e342 = phi_610_;
                    let _e344 = phi_611_;
                    phi_612_ = _e342;
                    phi_613_ = _e344;
                } else {
                    phi_612_ = f32();
                    phi_613_ = true;
                }
                let _e346 = phi_612_;
                let _e348 = phi_613_;
                if _e348 {
                    let _e351 = local_1.moments[0u];
                    let _e354 = local_1.moments[1u];
                    let _e362 = local_1.l32_d22_;
                    let _e364 = local_1.d22_;
                    let _e365 = (_e362 / _e364);
                    let _e366 = (_e84 - _e351);
                    let _e372 = local_1.d22_;
                    let _e375 = local_1.d33_d22_;
                    let _e376 = (((((_e84 * _e84) - _e354) - (_e365 * _e366)) * _e372) / _e375);
                    let _e378 = local_1.d22_;
                    let _e381 = ((_e366 / _e378) - (_e365 * _e376));
                    let _e387 = ((0.5f * _e381) / _e376);
                    let _e390 = ((_e387 * _e387) - (((1f - (_e381 * _e351)) - (_e376 * _e354)) / _e376));
                    if (_e390 >= 0f) {
                        let _e392 = sqrt(_e390);
                        phi_669_ = vec2<f32>((-(_e387) - _e392), (-(_e387) + _e392));
                    } else {
                        phi_669_ = vec2(bitcast<f32>((bitcast<u32>(_e390) | 2143289344u)));
                    }
                    let _e403 = phi_669_;
                    if (_e84 <= _e403.x) {
                        phi_750_ = 1f;
                    } else {
                        if (_e84 > _e403.y) {
                            let _e409 = local_1.moments;
                            let _e420 = (((_e409.y - (_e409.x * (_e403.x + _e403.y))) + (_e403.x * _e403.y)) / ((_e84 - _e403.x) * (_e84 - _e403.y)));
                            if ((bitcast<u32>(_e420) & 2147483647u) > 2139095040u) {
                                phi_709_ = _e420;
                            } else {
                                if (_e420 < 0f) {
                                    phi_708_ = 0f;
                                } else {
                                    if (_e420 > 1f) {
                                        phi_707_ = 1f;
                                    } else {
                                        phi_707_ = _e420;
                                    }
                                    let _e427 = phi_707_;
                                    phi_708_ = _e427;
                                }
                                let _e429 = phi_708_;
                                phi_709_ = _e429;
                            }
                            let _e431 = phi_709_;
                            phi_749_ = _e431;
                        } else {
                            if (_e84 > _e403.x) {
                                let _e434 = local_1.moments;
                                let _e446 = (1f - (((_e434.y - (_e434.x * (_e84 + _e403.y))) + (_e84 * _e403.y)) / ((_e403.x - _e84) * (_e403.x - _e403.y))));
                                if ((bitcast<u32>(_e446) & 2147483647u) > 2139095040u) {
                                    phi_744_ = _e446;
                                } else {
                                    if (_e446 < 0f) {
                                        phi_743_ = 0f;
                                    } else {
                                        if (_e446 > 1f) {
                                            phi_742_ = 1f;
                                        } else {
                                            phi_742_ = _e446;
                                        }
                                        let _e453 = phi_742_;
                                        phi_743_ = _e453;
                                    }
                                    let _e455 = phi_743_;
                                    phi_744_ = _e455;
                                }
                                let _e457 = phi_744_;
                                phi_748_ = _e457;
                            } else {
                                phi_748_ = bitcast<f32>((bitcast<u32>(_e403.x) | 2143289344u));
                            }
                            let _e462 = phi_748_;
                            phi_749_ = _e462;
                        }
                        let _e464 = phi_749_;
                        phi_750_ = _e464;
                    }
                    let _e466 = phi_750_;
                    phi_751_ = _e466;
                } else {
                    phi_751_ = _e346;
                }
                let _e468 = phi_751_;
                phi_752_ = _e468;
                phi_753_ = false;
            } else {
                phi_752_ = f32();
                phi_753_ = true;
            }
            let _e470 = phi_752_;
            let _e472 = phi_753_;
            phi_754_ = _e470;
            phi_755_ = _e472;
        } else {
            phi_754_ = f32();
            phi_755_ = true;
        }
        let _e474 = phi_754_;
        let _e476 = phi_755_;
        if _e476 {
            if ((bitcast<u32>(_e308.x) & 2147483647u) > 2139095040u) {
                phi_969_ = _e308.x;
            } else {
                let _e480 = lt_math_hausdorff_endpoint_upper_bound((&local_1), _e84);
                let _e483 = local_1.moments[0u];
                let _e486 = local_1.moments[3u];
                if (_e483 == _e486) {
                    let _e490 = local_1.moments[0u];
                    phi_777_ = (_e490 > 0.5f);
                } else {
                    phi_777_ = false;
                }
                let _e493 = phi_777_;
                if _e493 {
                    if (_e84 > 0f) {
                        let _e496 = local_1.moments;
                        if ((bitcast<u32>(_e496.x) & 2147483647u) > 2139095040u) {
                            phi_804_ = _e496.x;
                        } else {
                            if (_e496.x < 0f) {
                                phi_803_ = 0f;
                            } else {
                                if (_e496.x > 1f) {
                                    phi_802_ = 1f;
                                } else {
                                    phi_802_ = _e496.x;
                                }
                                let _e504 = phi_802_;
                                phi_803_ = _e504;
                            }
                            let _e506 = phi_803_;
                            phi_804_ = _e506;
                        }
                        let _e508 = phi_804_;
                        phi_805_ = _e508;
                        phi_806_ = false;
                    } else {
                        phi_805_ = f32();
                        phi_806_ = true;
                    }
                    let _e510 = phi_805_;
                    let _e512 = phi_806_;
                    phi_807_ = _e510;
                    phi_808_ = _e512;
                } else {
                    phi_807_ = f32();
                    phi_808_ = true;
                }
                let _e514 = phi_807_;
                let _e516 = phi_808_;
                if _e516 {
                    let _e519 = local_1.moments[0u];
                    let _e522 = local_1.moments[1u];
                    let _e530 = local_1.l32_d22_;
                    let _e532 = local_1.d22_;
                    let _e533 = (_e530 / _e532);
                    let _e534 = (_e84 - _e519);
                    let _e540 = local_1.d22_;
                    let _e543 = local_1.d33_d22_;
                    let _e544 = (((((_e84 * _e84) - _e522) - (_e533 * _e534)) * _e540) / _e543);
                    let _e546 = local_1.d22_;
                    let _e549 = ((_e534 / _e546) - (_e533 * _e544));
                    let _e555 = ((0.5f * _e549) / _e544);
                    let _e558 = ((_e555 * _e555) - (((1f - (_e549 * _e519)) - (_e544 * _e522)) / _e544));
                    if (_e558 >= 0f) {
                        let _e560 = sqrt(_e558);
                        phi_864_ = vec2<f32>((-(_e555) - _e560), (-(_e555) + _e560));
                    } else {
                        phi_864_ = vec2(bitcast<f32>((bitcast<u32>(_e558) | 2143289344u)));
                    }
                    let _e571 = phi_864_;
                    if (_e84 <= _e571.x) {
                        phi_945_ = 1f;
                    } else {
                        if (_e84 > _e571.y) {
                            let _e577 = local_1.moments;
                            let _e588 = (((_e577.y - (_e577.x * (_e571.x + _e571.y))) + (_e571.x * _e571.y)) / ((_e84 - _e571.x) * (_e84 - _e571.y)));
                            if ((bitcast<u32>(_e588) & 2147483647u) > 2139095040u) {
                                phi_904_ = _e588;
                            } else {
                                if (_e588 < 0f) {
                                    phi_903_ = 0f;
                                } else {
                                    if (_e588 > 1f) {
                                        phi_902_ = 1f;
                                    } else {
                                        phi_902_ = _e588;
                                    }
                                    let _e595 = phi_902_;
                                    phi_903_ = _e595;
                                }
                                let _e597 = phi_903_;
                                phi_904_ = _e597;
                            }
                            let _e599 = phi_904_;
                            phi_944_ = _e599;
                        } else {
                            if (_e84 > _e571.x) {
                                let _e602 = local_1.moments;
                                let _e614 = (1f - (((_e602.y - (_e602.x * (_e84 + _e571.y))) + (_e84 * _e571.y)) / ((_e571.x - _e84) * (_e571.x - _e571.y))));
                                if ((bitcast<u32>(_e614) & 2147483647u) > 2139095040u) {
                                    phi_939_ = _e614;
                                } else {
                                    if (_e614 < 0f) {
                                        phi_938_ = 0f;
                                    } else {
                                        if (_e614 > 1f) {
                                            phi_937_ = 1f;
                                        } else {
                                            phi_937_ = _e614;
                                        }
                                        let _e621 = phi_937_;
                                        phi_938_ = _e621;
                                    }
                                    let _e623 = phi_938_;
                                    phi_939_ = _e623;
                                }
                                let _e625 = phi_939_;
                                phi_943_ = _e625;
                            } else {
                                phi_943_ = bitcast<f32>((bitcast<u32>(_e571.x) | 2143289344u));
                            }
                            let _e630 = phi_943_;
                            phi_944_ = _e630;
                        }
                        let _e632 = phi_944_;
                        phi_945_ = _e632;
                    }
                    let _e634 = phi_945_;
                    phi_946_ = _e634;
                } else {
                    phi_946_ = _e514;
                }
                let _e636 = phi_946_;
                if ((bitcast<u32>(_e480) & 2147483647u) > 2139095040u) {
                    phi_968_ = _e480;
                } else {
                    if ((bitcast<u32>(_e636) & 2147483647u) > 2139095040u) {
                        phi_963_ = true;
                    } else {
                        let _e643 = (_e636 < _e480);
                        if _e643 {
                        }
                        phi_963_ = _e643;
                    }
                    let _e645 = phi_963_;
                    if _e645 {
                        phi_967_ = _e636;
                    } else {
                        phi_967_ = _e480;
                    }
                    let _e647 = phi_967_;
                    phi_968_ = _e647;
                }
                let _e649 = phi_968_;
                phi_969_ = _e649;
            }
            let _e651 = phi_969_;
            phi_970_ = _e651;
        } else {
            phi_970_ = _e474;
        }
        let _e653 = phi_970_;
        phi_971_ = _e653;
    }
    let _e655 = phi_971_;
    return _e655;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_15: ptr<function, f32>, param_16: vec4<f32>, param_17: vec4<f32>, param_18: f32) -> f32 {
    let _e44 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_16.x);
    let _e46 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_16.y);
    let _e48 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_16.z);
    let _e50 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_16.w);
    let _e100 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_15, vec4<f32>(((((_e44.x * param_17.x) + (_e46.x * param_17.y)) + (_e48.x * param_17.z)) + (_e50.x * param_17.w)), ((((_e44.y * param_17.x) + (_e46.y * param_17.y)) + (_e48.y * param_17.z)) + (_e50.y * param_17.w)), ((((_e44.z * param_17.x) + (_e46.z * param_17.y)) + (_e48.z * param_17.z)) + (_e50.z * param_17.w)), ((((_e44.w * param_17.x) + (_e46.w * param_17.y)) + (_e48.w * param_17.z)) + (_e50.w * param_17.w))), param_18);
    return _e100;
}

fn function_() {
    var local_2: f32;
    var phi_1191_: bool;
    var phi_1192_: bool;
    var phi_1193_: bool;
    var phi_1194_: bool;
    var phi_1198_: bool;
    var phi_1242_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1246_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1323_: bool;
    var phi_1332_: bool;
    var phi_1341_: bool;
    var phi_1342_: bool;
    var phi_1343_: bool;
    var phi_1344_: bool;
    var phi_1345_: bool;
    var phi_1346_: bool;
    var phi_1347_: bool;
    var phi_1351_: bool;
    var phi_1387_: f32;
    var phi_1392_: f32;
    var phi_1393_: bool;
    var phi_1394_: f32;
    var phi_1395_: bool;
    var phi_1399_: f32;
    var phi_1419_: f32;
    var phi_1424_: f32;
    var phi_1425_: bool;
    var phi_1426_: f32;
    var phi_1427_: bool;
    var phi_1431_: f32;
    var phi_1477_: i32;
    var phi_1482_: i32;
    var phi_1487_: i32;
    var phi_1492_: i32;
    var phi_1501_: i32;
    var phi_1506_: i32;
    var phi_1511_: i32;
    var phi_1516_: i32;
    var phi_1563_: bool;
    var phi_1571_: bool;
    var phi_1576_: f32;
    var phi_1579_: evaluate_Verdict;
    var phi_1580_: evaluate_Verdict;
    var phi_1584_: bool;
    var phi_1585_: u32;
    var phi_1591_: u32;

    let _e40 = id_1;
    let _e41 = local_3;
    let _e46 = arrayLength((&map.member));
    if (_e41 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    let _e53 = p.member.size[0u];
    let _e55 = p.member.size[1u];
    let _e56 = lt_shaders_entry_pixel_index(_e40, _e53, _e55);
    if (bitcast<i32>(_e56.root) != 0i) {
        let _e63 = p.member.light;
        let _e66 = samples.member[_e56.first_primitive].normal[0u];
        let _e68 = global[0u];
        if (_e66 == _e68) {
            let _e71 = samples.member[_e56.first_primitive].normal[1u];
            let _e73 = global[1u];
            if (_e71 == _e73) {
                let _e76 = samples.member[_e56.first_primitive].normal[2u];
                let _e78 = global[2u];
                phi_1191_ = (_e76 == _e78);
                phi_1192_ = false;
            } else {
                phi_1191_ = bool();
                phi_1192_ = true;
            }
            let _e81 = phi_1191_;
            let _e83 = phi_1192_;
            phi_1193_ = _e81;
            phi_1194_ = _e83;
        } else {
            phi_1193_ = bool();
            phi_1194_ = true;
        }
        let _e85 = phi_1193_;
        let _e87 = phi_1194_;
        if _e87 {
            phi_1198_ = false;
        } else {
            phi_1198_ = _e85;
        }
        let _e89 = phi_1198_;
        if !(_e89) {
            let _e92 = samples.member[_e56.first_primitive].normal;
            let _e94 = samples.member[_e56.first_primitive].position;
            if ((((_e92.x * (_e63.x - (_e94.x * _e63.w))) + (_e92.y * (_e63.y - (_e94.y * _e63.w)))) + (_e92.z * (_e63.z - (_e94.z * _e63.w)))) > 0f) {
                let _e118 = samples.member[_e56.first_primitive].flags;
                let _e126 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e132 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e126.unnamed.visibility, false), _e126.unnamed_1);
                phi_1242_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e132.unnamed, ((_e118 & 1u) == 0u));
            } else {
                let _e141 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e147 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e141.unnamed.visibility, false), _e141.unnamed_1);
                phi_1242_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e147.unnamed, true);
            }
            let _e152 = phi_1242_;
            phi_1246_ = _e152;
        } else {
            let _e158 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e164 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e158.unnamed.visibility, false), _e158.unnamed_1);
            phi_1246_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e164.unnamed, true);
        }
        let _e169 = phi_1246_;
        if _e169.unnamed_1 {
            phi_1580_ = evaluate_Verdict(_e169.unnamed.visibility, _e169.unnamed.is_doubted);
        } else {
            let _e177 = samples.member[_e56.first_primitive].position;
            let _e183 = p.member.projection.row_w;
            let _e194 = ((((_e183.x * _e177.x) + (_e183.y * _e177.y)) + (_e183.z * _e177.z)) + (_e183.w * 1f));
            let _e196 = p.member.projection.row_x;
            let _e208 = (((((_e196.x * _e177.x) + (_e196.y * _e177.y)) + (_e196.z * _e177.z)) + (_e196.w * 1f)) / _e194);
            let _e210 = p.member.projection.row_y;
            let _e222 = (((((_e210.x * _e177.x) + (_e210.y * _e177.y)) + (_e210.z * _e177.z)) + (_e210.w * 1f)) / _e194);
            let _e224 = p.member.projection.row_z;
            let _e235 = ((((_e224.x * _e177.x) + (_e224.y * _e177.y)) + (_e224.z * _e177.z)) + (_e224.w * 1f));
            if (_e194 > 0f) {
                if (_e208 >= 0f) {
                    phi_1323_ = (_e208 <= 1f);
                } else {
                    phi_1323_ = false;
                }
                let _e240 = phi_1323_;
                if _e240 {
                    if (_e222 >= 0f) {
                        phi_1332_ = (_e222 <= 1f);
                    } else {
                        phi_1332_ = false;
                    }
                    let _e244 = phi_1332_;
                    if _e244 {
                        if (_e235 >= 0f) {
                            phi_1341_ = (_e235 <= 1f);
                        } else {
                            phi_1341_ = false;
                        }
                        let _e248 = phi_1341_;
                        phi_1342_ = _e248;
                        phi_1343_ = false;
                    } else {
                        phi_1342_ = bool();
                        phi_1343_ = true;
                    }
                    let _e250 = phi_1342_;
                    let _e252 = phi_1343_;
                    phi_1344_ = _e250;
                    phi_1345_ = _e252;
                } else {
                    phi_1344_ = bool();
                    phi_1345_ = true;
                }
                let _e254 = phi_1344_;
                let _e256 = phi_1345_;
                phi_1346_ = _e254;
                phi_1347_ = _e256;
            } else {
                phi_1346_ = bool();
                phi_1347_ = true;
            }
            let _e258 = phi_1346_;
            let _e260 = phi_1347_;
            if _e260 {
                phi_1351_ = false;
            } else {
                phi_1351_ = _e258;
            }
            let _e262 = phi_1351_;
            if _e262 {
                let _e264 = p.member.map_size;
                let _e265 = f32(_e264);
                let _e268 = ((_e208 * _e265) - 0.5f);
                let _e269 = ((_e222 * _e265) - 0.5f);
                if (_e268 > -8388608f) {
                    let _e281 = f32(select(0i, select(select(i32(_e268), i32(-2147483648), (_e268 < bitcast<f32>(3472883712u))), 2147483647i, (_e268 > bitcast<f32>(1325400063u))), (_e268 == _e268)));
                    if (_e281 > _e268) {
                        phi_1387_ = 1f;
                    } else {
                        phi_1387_ = 0f;
                    }
                    let _e284 = phi_1387_;
                    if (_e268 < 8388608f) {
                        phi_1392_ = (_e281 - _e284);
                        phi_1393_ = false;
                    } else {
                        phi_1392_ = f32();
                        phi_1393_ = true;
                    }
                    let _e287 = phi_1392_;
                    let _e289 = phi_1393_;
                    phi_1394_ = _e287;
                    phi_1395_ = _e289;
                } else {
                    phi_1394_ = f32();
                    phi_1395_ = true;
                }
                let _e291 = phi_1394_;
                let _e293 = phi_1395_;
                if _e293 {
                    phi_1399_ = _e268;
                } else {
                    phi_1399_ = _e291;
                }
                let _e295 = phi_1399_;
                if (_e269 > -8388608f) {
                    let _e307 = f32(select(0i, select(select(i32(_e269), i32(-2147483648), (_e269 < bitcast<f32>(3472883712u))), 2147483647i, (_e269 > bitcast<f32>(1325400063u))), (_e269 == _e269)));
                    if (_e307 > _e269) {
                        phi_1419_ = 1f;
                    } else {
                        phi_1419_ = 0f;
                    }
                    let _e310 = phi_1419_;
                    if (_e269 < 8388608f) {
                        phi_1424_ = (_e307 - _e310);
                        phi_1425_ = false;
                    } else {
                        phi_1424_ = f32();
                        phi_1425_ = true;
                    }
                    let _e313 = phi_1424_;
                    let _e315 = phi_1425_;
                    phi_1426_ = _e313;
                    phi_1427_ = _e315;
                } else {
                    phi_1426_ = f32();
                    phi_1427_ = true;
                }
                let _e317 = phi_1426_;
                let _e319 = phi_1427_;
                if _e319 {
                    phi_1431_ = _e269;
                } else {
                    phi_1431_ = _e317;
                }
                let _e321 = phi_1431_;
                let _e322 = (_e268 - _e295);
                let _e323 = (_e269 - _e321);
                let _e332 = select(0i, select(select(i32(_e295), i32(-2147483648), (_e295 < bitcast<f32>(3472883712u))), 2147483647i, (_e295 > bitcast<f32>(1325400063u))), (_e295 == _e295));
                let _e341 = select(0i, select(select(i32(_e321), i32(-2147483648), (_e321 < bitcast<f32>(3472883712u))), 2147483647i, (_e321 > bitcast<f32>(1325400063u))), (_e321 == _e321));
                let _e352 = p.member.test;
                let _e353 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e352);
                let _e355 = p.member.map_size;
                local_2 = _e353;
                let _e357 = (bitcast<i32>(_e355) - 1i);
                if (_e332 > 0i) {
                    phi_1477_ = _e332;
                } else {
                    phi_1477_ = 0i;
                }
                let _e360 = phi_1477_;
                if (_e341 > 0i) {
                    phi_1482_ = _e341;
                } else {
                    phi_1482_ = 0i;
                }
                let _e363 = phi_1482_;
                if (_e360 < _e357) {
                    phi_1487_ = _e360;
                } else {
                    phi_1487_ = _e357;
                }
                let _e366 = phi_1487_;
                if (_e363 < _e357) {
                    phi_1492_ = _e363;
                } else {
                    phi_1492_ = _e357;
                }
                let _e369 = phi_1492_;
                let _e370 = bitcast<u32>(_e366);
                let _e372 = (_e332 + 1i);
                let _e373 = (_e341 + 1i);
                if (_e372 > 0i) {
                    phi_1501_ = _e372;
                } else {
                    phi_1501_ = 0i;
                }
                let _e376 = phi_1501_;
                if (_e373 > 0i) {
                    phi_1506_ = _e373;
                } else {
                    phi_1506_ = 0i;
                }
                let _e379 = phi_1506_;
                if (_e376 < _e357) {
                    phi_1511_ = _e376;
                } else {
                    phi_1511_ = _e357;
                }
                let _e382 = phi_1511_;
                if (_e379 < _e357) {
                    phi_1516_ = _e379;
                } else {
                    phi_1516_ = _e357;
                }
                let _e385 = phi_1516_;
                let _e386 = bitcast<u32>(_e382);
                let _e388 = (bitcast<u32>(_e369) * _e355);
                let _e389 = (bitcast<u32>(_e385) * _e355);
                let _e390 = (_e388 + _e370);
                let _e391 = (_e388 + _e386);
                let _e392 = (_e389 + _e370);
                let _e393 = (_e389 + _e386);
                if (_e390 < _e46) {
                } else {
                    return;
                }
                let _e397 = map.member[(0u + _e390)];
                if (_e391 < _e46) {
                } else {
                    return;
                }
                let _e401 = map.member[(0u + _e391)];
                if (_e392 < _e46) {
                } else {
                    return;
                }
                let _e405 = map.member[(0u + _e392)];
                if (_e393 < _e46) {
                } else {
                    return;
                }
                let _e409 = map.member[(0u + _e393)];
                let _e411 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local_2), vec4<f32>(_e397, _e401, _e405, _e409), vec4<f32>(((1f - _e322) * (1f - _e323)), (_e322 * (1f - _e323)), ((1f - _e322) * _e323), (_e322 * _e323)), _e235);
                let _e413 = p.member.epsilon;
                if (_e411 <= _e413) {
                    phi_1563_ = true;
                } else {
                    phi_1563_ = (_e411 >= (1f - _e413));
                }
                let _e418 = phi_1563_;
                if ((bitcast<u32>(_e411) & 2147483647u) > 2139095040u) {
                    phi_1571_ = true;
                } else {
                    phi_1571_ = !(_e418);
                }
                let _e424 = phi_1571_;
                if (_e411 > 0.5f) {
                    phi_1576_ = 1f;
                } else {
                    phi_1576_ = 0f;
                }
                let _e427 = phi_1576_;
                phi_1579_ = evaluate_Verdict(_e427, _e424);
            } else {
                phi_1579_ = evaluate_Verdict(1f, true);
            }
            let _e431 = phi_1579_;
            phi_1580_ = _e431;
        }
        let _e433 = phi_1580_;
        visibility.member[_e56.first_primitive] = _e433.visibility;
        phi_1584_ = _e433.is_doubted;
        phi_1585_ = _e56.first_primitive;
    } else {
        phi_1584_ = false;
        phi_1585_ = 0u;
    }
    let _e438 = phi_1584_;
    let _e440 = phi_1585_;
    if _e438 {
        let _e442 = atomicAdd((&shared_[0u]), 1u);
        phi_1591_ = _e442;
    } else {
        phi_1591_ = 0u;
    }
    let _e444 = phi_1591_;
    workgroupBarrier();
    if (_e41 == 0u) {
        let _e448 = atomicLoad((&shared_[0u]));
        let _e449 = atomicAdd((&list.member[3u]), _e448);
        atomicStore((&shared_[1u]), _e449);
    }
    workgroupBarrier();
    if _e438 {
        let _e452 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e452) + _e444)]), _e440);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_msm_hausdorff_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_3 = local;
    function_();
}
