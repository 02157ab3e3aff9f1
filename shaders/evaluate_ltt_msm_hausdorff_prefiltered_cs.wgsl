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

fn lt_math_hausdorff_cubic_mass(param_4: vec4<f32>, param_5: f32, param_6: f32, param_7: f32, param_8: f32) -> f32 {
    return ((((param_4.z - (((param_6 + param_7) + param_8) * param_4.y)) + ((((param_6 * param_7) + (param_6 * param_8)) + (param_7 * param_8)) * param_4.x)) - ((param_6 * param_7) * param_8)) / (((param_5 - param_6) * (param_5 - param_7)) * (param_5 - param_8)));
}

fn lt_math_hausdorff_endpoint_upper_bound(param_9: ptr<function, hankel_HankelFactors>, param_10: f32) -> f32 {
    var phi_936_: f32;
    var phi_937_: f32;
    var phi_938_: f32;
    var phi_965_: f32;
    var phi_966_: f32;
    var phi_967_: f32;
    var phi_968_: f32;
    var phi_969_: bool;
    var phi_970_: f32;
    var phi_971_: bool;
    var phi_999_: f32;
    var phi_1000_: f32;
    var phi_1001_: f32;
    var phi_1002_: f32;
    var phi_1003_: bool;
    var phi_1004_: f32;
    var phi_1005_: bool;
    var phi_1012_: f32;
    var phi_1013_: f32;
    var phi_1014_: f32;
    var phi_1015_: f32;

    let _e42 = (*param_9).moments;
    if (param_10 < 0.0001f) {
        phi_1015_ = 1f;
    } else {
        let _e51 = ((_e42.z - ((1f + param_10) * _e42.y)) + (param_10 * _e42.x));
        let _e60 = (((_e42.w - ((1f + param_10) * _e42.z)) + (param_10 * _e42.y)) / _e51);
        if (abs(_e51) <= 0.00000047683716f) {
            let _e74 = (1f - (((_e42.y - (_e42.x * (param_10 + 1f))) + (param_10 * 1f)) / ((0f - param_10) * (0f - 1f))));
            if ((bitcast<u32>(_e74) & 2147483647u) > 2139095040u) {
                phi_938_ = _e74;
            } else {
                if (_e74 < 0f) {
                    phi_937_ = 0f;
                } else {
                    if (_e74 > 1f) {
                        phi_936_ = 1f;
                    } else {
                        phi_936_ = _e74;
                    }
                    let _e81 = phi_936_;
                    phi_937_ = _e81;
                }
                let _e83 = phi_937_;
                phi_938_ = _e83;
            }
            let _e85 = phi_938_;
            phi_1014_ = _e85;
        } else {
            if (_e60 > 0f) {
                if (_e60 < param_10) {
                    let _e88 = lt_math_hausdorff_cubic_mass(_e42, 0f, _e60, param_10, 1f);
                    let _e90 = lt_math_hausdorff_cubic_mass(_e42, _e60, 0f, param_10, 1f);
                    let _e91 = ((1f - _e88) - _e90);
                    if ((bitcast<u32>(_e91) & 2147483647u) > 2139095040u) {
                        phi_967_ = _e91;
                    } else {
                        if (_e91 < 0f) {
                            phi_966_ = 0f;
                        } else {
                            if (_e91 > 1f) {
                                phi_965_ = 1f;
                            } else {
                                phi_965_ = _e91;
                            }
                            let _e98 = phi_965_;
                            phi_966_ = _e98;
                        }
                        let _e100 = phi_966_;
                        phi_967_ = _e100;
                    }
                    let _e102 = phi_967_;
                    phi_968_ = _e102;
                    phi_969_ = false;
                } else {
                    phi_968_ = f32();
                    phi_969_ = true;
                }
                let _e104 = phi_968_;
                let _e106 = phi_969_;
                phi_970_ = _e104;
                phi_971_ = _e106;
            } else {
                phi_970_ = f32();
                phi_971_ = true;
            }
            let _e108 = phi_970_;
            let _e110 = phi_971_;
            if _e110 {
                if (_e60 > param_10) {
                    if (_e60 < 1f) {
                        let _e113 = lt_math_hausdorff_cubic_mass(_e42, 0f, _e60, param_10, 1f);
                        let _e114 = (1f - _e113);
                        if ((bitcast<u32>(_e114) & 2147483647u) > 2139095040u) {
                            phi_1001_ = _e114;
                        } else {
                            if (_e114 < 0f) {
                                phi_1000_ = 0f;
                            } else {
                                if (_e114 > 1f) {
                                    phi_999_ = 1f;
                                } else {
                                    phi_999_ = _e114;
                                }
                                let _e121 = phi_999_;
                                phi_1000_ = _e121;
                            }
                            let _e123 = phi_1000_;
                            phi_1001_ = _e123;
                        }
                        let _e125 = phi_1001_;
                        phi_1002_ = _e125;
                        phi_1003_ = false;
                    } else {
                        phi_1002_ = f32();
                        phi_1003_ = true;
                    }
                    let _e127 = phi_1002_;
                    let _e129 = phi_1003_;
                    phi_1004_ = _e127;
                    phi_1005_ = _e129;
                } else {
                    phi_1004_ = f32();
                    phi_1005_ = true;
                }
                let _e131 = phi_1004_;
                let _e133 = phi_1005_;
                if _e133 {
                    phi_1012_ = bitcast<f32>((bitcast<u32>(_e60) | 2143289344u));
                } else {
                    phi_1012_ = _e131;
                }
                let _e138 = phi_1012_;
                phi_1013_ = _e138;
            } else {
                phi_1013_ = _e108;
            }
            let _e140 = phi_1013_;
            phi_1014_ = _e140;
        }
        let _e142 = phi_1014_;
        phi_1015_ = _e142;
    }
    let _e144 = phi_1015_;
    return _e144;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_11: ptr<function, f32>, param_12: vec4<f32>, param_13: f32) -> f32 {
    var local_1: hankel_HankelFactors;
    var phi_223_: f32;
    var phi_224_: f32;
    var phi_225_: f32;
    var phi_237_: bool;
    var phi_252_: bool;
    var phi_277_: f32;
    var phi_278_: f32;
    var phi_279_: f32;
    var phi_280_: f32;
    var phi_281_: bool;
    var phi_282_: f32;
    var phi_283_: bool;
    var phi_339_: vec2<f32>;
    var phi_377_: f32;
    var phi_378_: f32;
    var phi_379_: f32;
    var phi_412_: f32;
    var phi_413_: f32;
    var phi_414_: f32;
    var phi_418_: f32;
    var phi_419_: f32;
    var phi_420_: f32;
    var phi_421_: f32;
    var phi_474_: vec2<f32>;
    var phi_496_: bool;
    var phi_521_: f32;
    var phi_522_: f32;
    var phi_523_: f32;
    var phi_524_: f32;
    var phi_525_: bool;
    var phi_526_: f32;
    var phi_527_: bool;
    var phi_583_: vec2<f32>;
    var phi_621_: f32;
    var phi_622_: f32;
    var phi_623_: f32;
    var phi_656_: f32;
    var phi_657_: f32;
    var phi_658_: f32;
    var phi_662_: f32;
    var phi_663_: f32;
    var phi_664_: f32;
    var phi_665_: f32;
    var phi_666_: f32;
    var phi_667_: bool;
    var phi_668_: f32;
    var phi_669_: bool;
    var phi_691_: bool;
    var phi_716_: f32;
    var phi_717_: f32;
    var phi_718_: f32;
    var phi_719_: f32;
    var phi_720_: bool;
    var phi_721_: f32;
    var phi_722_: bool;
    var phi_778_: vec2<f32>;
    var phi_816_: f32;
    var phi_817_: f32;
    var phi_818_: f32;
    var phi_851_: f32;
    var phi_852_: f32;
    var phi_853_: f32;
    var phi_857_: f32;
    var phi_858_: f32;
    var phi_859_: f32;
    var phi_860_: f32;
    var phi_871_: bool;
    var phi_875_: f32;
    var phi_876_: f32;
    var phi_877_: f32;
    var phi_878_: f32;

    let _e43 = (*param_11);
    let _e44 = (1f - _e43);
    let _e53 = (0.5f * _e43);
    let _e54 = ((param_12.x * _e44) + _e53);
    let _e55 = ((param_12.y * _e44) + _e53);
    let _e56 = ((param_12.z * _e44) + _e53);
    let _e57 = ((param_12.w * _e44) + _e53);
    let _e60 = (_e55 - (_e54 * _e54));
    let _e62 = (_e56 - (_e54 * _e55));
    let _e68 = hankel_HankelFactors(vec4<f32>(_e54, _e55, _e56, _e57), _e60, _e62, (((_e57 - (_e55 * _e55)) * _e60) - (_e62 * _e62)));
    local_1 = hankel_HankelFactors(_e68.moments, _e68.d22_, _e68.l32_d22_, _e68.d33_d22_);
    if ((bitcast<u32>(param_13) & 2147483647u) > 2139095040u) {
        phi_225_ = param_13;
    } else {
        if (param_13 < 0f) {
            phi_224_ = 0f;
        } else {
            if (param_13 > 1f) {
                phi_223_ = 1f;
            } else {
                phi_223_ = param_13;
            }
            let _e80 = phi_223_;
            phi_224_ = _e80;
        }
        let _e82 = phi_224_;
        phi_225_ = _e82;
    }
    let _e84 = phi_225_;
    let _e87 = local_1.moments[0u];
    let _e90 = local_1.moments[3u];
    if (_e87 == _e90) {
        let _e94 = local_1.moments[0u];
        phi_237_ = (_e94 > 0.5f);
    } else {
        phi_237_ = false;
    }
    let _e97 = phi_237_;
    if _e97 {
        let _e100 = local_1.moments[0u];
        let _e103 = local_1.moments[3u];
        if (_e100 == _e103) {
            let _e107 = local_1.moments[0u];
            phi_252_ = (_e107 > 0.5f);
        } else {
            phi_252_ = false;
        }
        let _e110 = phi_252_;
        if _e110 {
            if (_e84 > 0f) {
                let _e113 = local_1.moments;
                if ((bitcast<u32>(_e113.x) & 2147483647u) > 2139095040u) {
                    phi_279_ = _e113.x;
                } else {
                    if (_e113.x < 0f) {
                        phi_278_ = 0f;
                    } else {
                        if (_e113.x > 1f) {
                            phi_277_ = 1f;
                        } else {
                            phi_277_ = _e113.x;
                        }
                        let _e121 = phi_277_;
                        phi_278_ = _e121;
                    }
                    let _e123 = phi_278_;
                    phi_279_ = _e123;
                }
                let _e125 = phi_279_;
                phi_280_ = _e125;
                phi_281_ = false;
            } else {
                phi_280_ = f32();
                phi_281_ = true;
            }
            let _e127 = phi_280_;
            let _e129 = phi_281_;
            phi_282_ = _e127;
            phi_283_ = _e129;
        } else {
            phi_282_ = f32();
            phi_283_ = true;
        }
        let _e131 = phi_282_;
        let _e133 = phi_283_;
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
                phi_339_ = vec2<f32>((-(_e172) - _e177), (-(_e172) + _e177));
            } else {
                phi_339_ = vec2(bitcast<f32>((bitcast<u32>(_e175) | 2143289344u)));
            }
            let _e188 = phi_339_;
            if (_e84 <= _e188.x) {
                phi_420_ = 1f;
            } else {
                if (_e84 > _e188.y) {
                    let _e194 = local_1.moments;
                    let _e205 = (((_e194.y - (_e194.x * (_e188.x + _e188.y))) + (_e188.x * _e188.y)) / ((_e84 - _e188.x) * (_e84 - _e188.y)));
                    if ((bitcast<u32>(_e205) & 2147483647u) > 2139095040u) {
                        phi_379_ = _e205;
                    } else {
                        if (_e205 < 0f) {
                            phi_378_ = 0f;
                        } else {
                            if (_e205 > 1f) {
                                phi_377_ = 1f;
                            } else {
                                phi_377_ = _e205;
                            }
                            let _e212 = phi_377_;
                            phi_378_ = _e212;
                        }
                        let _e214 = phi_378_;
                        phi_379_ = _e214;
                    }
                    let _e216 = phi_379_;
                    phi_419_ = _e216;
                } else {
                    if (_e84 > _e188.x) {
                        let _e219 = local_1.moments;
                        let _e231 = (1f - (((_e219.y - (_e219.x * (_e84 + _e188.y))) + (_e84 * _e188.y)) / ((_e188.x - _e84) * (_e188.x - _e188.y))));
                        if ((bitcast<u32>(_e231) & 2147483647u) > 2139095040u) {
                            phi_414_ = _e231;
                        } else {
                            if (_e231 < 0f) {
                                phi_413_ = 0f;
                            } else {
                                if (_e231 > 1f) {
                                    phi_412_ = 1f;
                                } else {
                                    phi_412_ = _e231;
                                }
                                let _e238 = phi_412_;
                                phi_413_ = _e238;
                            }
                            let _e240 = phi_413_;
                            phi_414_ = _e240;
                        }
                        let _e242 = phi_414_;
                        phi_418_ = _e242;
                    } else {
                        phi_418_ = bitcast<f32>((bitcast<u32>(_e188.x) | 2143289344u));
                    }
                    let _e247 = phi_418_;
                    phi_419_ = _e247;
                }
                let _e249 = phi_419_;
                phi_420_ = _e249;
            }
            let _e251 = phi_420_;
            phi_421_ = _e251;
        } else {
            phi_421_ = _e131;
        }
        let _e253 = phi_421_;
        phi_878_ = _e253;
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
            phi_474_ = vec2<f32>((-(_e292) - _e297), (-(_e292) + _e297));
        } else {
            phi_474_ = vec2(bitcast<f32>((bitcast<u32>(_e295) | 2143289344u)));
        }
        let _e308 = phi_474_;
        if (_e308.x >= 0f) {
            if (_e308.y <= 1f) {
                let _e315 = local_1.moments[0u];
                let _e318 = local_1.moments[3u];
                if (_e315 == _e318) {
                    let _e322 = local_1.moments[0u];
                    phi_496_ = (_e322 > 0.5f);
                } else {
                    phi_496_ = false;
                }
                let _e325 = phi_496_;
                if _e325 {
                    if (_e84 > 0f) {
                        let _e328 = local_1.moments;
                        if ((bitcast<u32>(_e328.x) & 2147483647u) > 2139095040u) {
                            phi_523_ = _e328.x;
                        } else {
                            if (_e328.x < 0f) {
                                phi_522_ = 0f;
                            } else {
                                if (_e328.x > 1f) {
                                    phi_521_ = 1f;
                                } else {
                                    phi_521_ = _e328.x;
                                }
                                let _e336 = phi_521_;
                                phi_522_ = _e336;
                            }
                            let _e338 = phi_522_;
                            phi_523_ = _e338;
                        }
                        let _e340 = phi_523_;
                        phi_524_ = _e340;
                        phi_525_ = false;
                    } else {
                        phi_524_ = f32();
                        phi_525_ = true;
                    }
                    let _e342 = phi_524_;
                    let _e344 = phi_525_;
                    phi_526_ = _e342;
                    phi_527_ = _e344;
                } else {
                    phi_526_ = f32();
                    phi_527_ = true;
                }
                let _e346 = phi_526_;
                let _e348 = phi_527_;
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
                        phi_583_ = vec2<f32>((-(_e387) - _e392), (-(_e387) + _e392));
                    } else {
                        phi_583_ = vec2(bitcast<f32>((bitcast<u32>(_e390) | 2143289344u)));
                    }
                    let _e403 = phi_583_;
                    if (_e84 <= _e403.x) {
                        phi_664_ = 1f;
                    } else {
                        if (_e84 > _e403.y) {
                            let _e409 = local_1.moments;
                            let _e420 = (((_e409.y - (_e409.x * (_e403.x + _e403.y))) + (_e403.x * _e403.y)) / ((_e84 - _e403.x) * (_e84 - _e403.y)));
                            if ((bitcast<u32>(_e420) & 2147483647u) > 2139095040u) {
                                phi_623_ = _e420;
                            } else {
                                if (_e420 < 0f) {
                                    phi_622_ = 0f;
                                } else {
                                    if (_e420 > 1f) {
                                        phi_621_ = 1f;
                                    } else {
                                        phi_621_ = _e420;
                                    }
                                    let _e427 = phi_621_;
                                    phi_622_ = _e427;
                                }
                                let _e429 = phi_622_;
                                phi_623_ = _e429;
                            }
                            let _e431 = phi_623_;
                            phi_663_ = _e431;
                        } else {
                            if (_e84 > _e403.x) {
                                let _e434 = local_1.moments;
                                let _e446 = (1f - (((_e434.y - (_e434.x * (_e84 + _e403.y))) + (_e84 * _e403.y)) / ((_e403.x - _e84) * (_e403.x - _e403.y))));
                                if ((bitcast<u32>(_e446) & 2147483647u) > 2139095040u) {
                                    phi_658_ = _e446;
                                } else {
                                    if (_e446 < 0f) {
                                        phi_657_ = 0f;
                                    } else {
                                        if (_e446 > 1f) {
                                            phi_656_ = 1f;
                                        } else {
                                            phi_656_ = _e446;
                                        }
                                        let _e453 = phi_656_;
                                        phi_657_ = _e453;
                                    }
                                    let _e455 = phi_657_;
                                    phi_658_ = _e455;
                                }
                                let _e457 = phi_658_;
                                phi_662_ = _e457;
                            } else {
                                phi_662_ = bitcast<f32>((bitcast<u32>(_e403.x) | 2143289344u));
                            }
                            let _e462 = phi_662_;
                            phi_663_ = _e462;
                        }
                        let _e464 = phi_663_;
                        phi_664_ = _e464;
                    }
                    let _e466 = phi_664_;
                    phi_665_ = _e466;
                } else {
                    phi_665_ = _e346;
                }
                let _e468 = phi_665_;
                phi_666_ = _e468;
                phi_667_ = false;
            } else {
                phi_666_ = f32();
                phi_667_ = true;
            }
            let _e470 = phi_666_;
            let _e472 = phi_667_;
            phi_668_ = _e470;
            phi_669_ = _e472;
        } else {
            phi_668_ = f32();
            phi_669_ = true;
        }
        let _e474 = phi_668_;
        let _e476 = phi_669_;
        if _e476 {
            if ((bitcast<u32>(_e308.x) & 2147483647u) > 2139095040u) {
                phi_876_ = _e308.x;
            } else {
                let _e480 = lt_math_hausdorff_endpoint_upper_bound((&local_1), _e84);
                let _e483 = local_1.moments[0u];
                let _e486 = local_1.moments[3u];
                if (_e483 == _e486) {
                    let _e490 = local_1.moments[0u];
                    phi_691_ = (_e490 > 0.5f);
                } else {
                    phi_691_ = false;
                }
                let _e493 = phi_691_;
                if _e493 {
                    if (_e84 > 0f) {
                        let _e496 = local_1.moments;
                        if ((bitcast<u32>(_e496.x) & 2147483647u) > 2139095040u) {
                            phi_718_ = _e496.x;
                        } else {
                            if (_e496.x < 0f) {
                                phi_717_ = 0f;
                            } else {
                                if (_e496.x > 1f) {
                                    phi_716_ = 1f;
                                } else {
                                    phi_716_ = _e496.x;
                                }
                                let _e504 = phi_716_;
                                phi_717_ = _e504;
                            }
                            let _e506 = phi_717_;
                            phi_718_ = _e506;
                        }
                        let _e508 = phi_718_;
                        phi_719_ = _e508;
                        phi_720_ = false;
                    } else {
                        phi_719_ = f32();
                        phi_720_ = true;
                    }
                    let _e510 = phi_719_;
                    let _e512 = phi_720_;
                    phi_721_ = _e510;
                    phi_722_ = _e512;
                } else {
                    phi_721_ = f32();
                    phi_722_ = true;
                }
                let _e514 = phi_721_;
                let _e516 = phi_722_;
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
                        phi_778_ = vec2<f32>((-(_e555) - _e560), (-(_e555) + _e560));
                    } else {
                        phi_778_ = vec2(bitcast<f32>((bitcast<u32>(_e558) | 2143289344u)));
                    }
                    let _e571 = phi_778_;
                    if (_e84 <= _e571.x) {
                        phi_859_ = 1f;
                    } else {
                        if (_e84 > _e571.y) {
                            let _e577 = local_1.moments;
                            let _e588 = (((_e577.y - (_e577.x * (_e571.x + _e571.y))) + (_e571.x * _e571.y)) / ((_e84 - _e571.x) * (_e84 - _e571.y)));
                            if ((bitcast<u32>(_e588) & 2147483647u) > 2139095040u) {
                                phi_818_ = _e588;
                            } else {
                                if (_e588 < 0f) {
                                    phi_817_ = 0f;
                                } else {
                                    if (_e588 > 1f) {
                                        phi_816_ = 1f;
                                    } else {
                                        phi_816_ = _e588;
                                    }
                                    let _e595 = phi_816_;
                                    phi_817_ = _e595;
                                }
                                let _e597 = phi_817_;
                                phi_818_ = _e597;
                            }
                            let _e599 = phi_818_;
                            phi_858_ = _e599;
                        } else {
                            if (_e84 > _e571.x) {
                                let _e602 = local_1.moments;
                                let _e614 = (1f - (((_e602.y - (_e602.x * (_e84 + _e571.y))) + (_e84 * _e571.y)) / ((_e571.x - _e84) * (_e571.x - _e571.y))));
                                if ((bitcast<u32>(_e614) & 2147483647u) > 2139095040u) {
                                    phi_853_ = _e614;
                                } else {
                                    if (_e614 < 0f) {
                                        phi_852_ = 0f;
                                    } else {
                                        if (_e614 > 1f) {
                                            phi_851_ = 1f;
                                        } else {
                                            phi_851_ = _e614;
                                        }
                                        let _e621 = phi_851_;
                                        phi_852_ = _e621;
                                    }
                                    let _e623 = phi_852_;
                                    phi_853_ = _e623;
                                }
                                let _e625 = phi_853_;
                                phi_857_ = _e625;
                            } else {
                                phi_857_ = bitcast<f32>((bitcast<u32>(_e571.x) | 2143289344u));
                            }
                            let _e630 = phi_857_;
                            phi_858_ = _e630;
                        }
                        let _e632 = phi_858_;
                        phi_859_ = _e632;
                    }
                    let _e634 = phi_859_;
                    phi_860_ = _e634;
                } else {
                    phi_860_ = _e514;
                }
                let _e636 = phi_860_;
                if ((bitcast<u32>(_e636) & 2147483647u) > 2139095040u) {
                    phi_871_ = true;
                } else {
                    let _e640 = (_e636 < _e480);
                    if _e640 {
                    }
                    phi_871_ = _e640;
                }
                let _e642 = phi_871_;
                if _e642 {
                    phi_875_ = _e636;
                } else {
                    phi_875_ = _e480;
                }
                let _e644 = phi_875_;
                phi_876_ = _e644;
            }
            let _e646 = phi_876_;
            phi_877_ = _e646;
        } else {
            phi_877_ = _e474;
        }
        let _e648 = phi_877_;
        phi_878_ = _e648;
    }
    let _e650 = phi_878_;
    return _e650;
}

fn function_() {
    var local_2: f32;
    var phi_1098_: bool;
    var phi_1099_: bool;
    var phi_1100_: bool;
    var phi_1101_: bool;
    var phi_1105_: bool;
    var phi_1149_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1153_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1230_: bool;
    var phi_1239_: bool;
    var phi_1248_: bool;
    var phi_1249_: bool;
    var phi_1250_: bool;
    var phi_1251_: bool;
    var phi_1252_: bool;
    var phi_1253_: bool;
    var phi_1254_: bool;
    var phi_1258_: bool;
    var phi_1294_: f32;
    var phi_1299_: f32;
    var phi_1300_: bool;
    var phi_1301_: f32;
    var phi_1302_: bool;
    var phi_1306_: f32;
    var phi_1326_: f32;
    var phi_1331_: f32;
    var phi_1332_: bool;
    var phi_1333_: f32;
    var phi_1334_: bool;
    var phi_1338_: f32;
    var phi_1384_: i32;
    var phi_1389_: i32;
    var phi_1394_: i32;
    var phi_1399_: i32;
    var phi_1408_: i32;
    var phi_1413_: i32;
    var phi_1418_: i32;
    var phi_1423_: i32;
    var phi_1514_: bool;
    var phi_1522_: bool;
    var phi_1527_: f32;
    var phi_1530_: evaluate_Verdict;
    var phi_1531_: evaluate_Verdict;
    var phi_1535_: bool;
    var phi_1536_: u32;
    var phi_1542_: u32;

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
                phi_1098_ = (_e76 == _e78);
                phi_1099_ = false;
            } else {
                phi_1098_ = bool();
                phi_1099_ = true;
            }
            let _e81 = phi_1098_;
            let _e83 = phi_1099_;
            phi_1100_ = _e81;
            phi_1101_ = _e83;
        } else {
            phi_1100_ = bool();
            phi_1101_ = true;
        }
        let _e85 = phi_1100_;
        let _e87 = phi_1101_;
        if _e87 {
            phi_1105_ = false;
        } else {
            phi_1105_ = _e85;
        }
        let _e89 = phi_1105_;
        if !(_e89) {
            let _e92 = samples.member[_e56.first_primitive].normal;
            let _e94 = samples.member[_e56.first_primitive].position;
            if ((((_e92.x * (_e63.x - (_e94.x * _e63.w))) + (_e92.y * (_e63.y - (_e94.y * _e63.w)))) + (_e92.z * (_e63.z - (_e94.z * _e63.w)))) > 0f) {
                let _e118 = samples.member[_e56.first_primitive].flags;
                let _e126 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e132 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e126.unnamed.visibility, false), _e126.unnamed_1);
                phi_1149_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e132.unnamed, ((_e118 & 1u) == 0u));
            } else {
                let _e141 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e147 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e141.unnamed.visibility, false), _e141.unnamed_1);
                phi_1149_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e147.unnamed, true);
            }
            let _e152 = phi_1149_;
            phi_1153_ = _e152;
        } else {
            let _e158 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e164 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e158.unnamed.visibility, false), _e158.unnamed_1);
            phi_1153_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e164.unnamed, true);
        }
        let _e169 = phi_1153_;
        if _e169.unnamed_1 {
            phi_1531_ = evaluate_Verdict(_e169.unnamed.visibility, _e169.unnamed.is_doubted);
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
                    phi_1230_ = (_e208 <= 1f);
                } else {
                    phi_1230_ = false;
                }
                let _e240 = phi_1230_;
                if _e240 {
                    if (_e222 >= 0f) {
                        phi_1239_ = (_e222 <= 1f);
                    } else {
                        phi_1239_ = false;
                    }
                    let _e244 = phi_1239_;
                    if _e244 {
                        if (_e235 >= 0f) {
                            phi_1248_ = (_e235 <= 1f);
                        } else {
                            phi_1248_ = false;
                        }
                        let _e248 = phi_1248_;
                        phi_1249_ = _e248;
                        phi_1250_ = false;
                    } else {
                        phi_1249_ = bool();
                        phi_1250_ = true;
                    }
                    let _e250 = phi_1249_;
                    let _e252 = phi_1250_;
                    phi_1251_ = _e250;
                    phi_1252_ = _e252;
                } else {
                    phi_1251_ = bool();
                    phi_1252_ = true;
                }
                let _e254 = phi_1251_;
                let _e256 = phi_1252_;
                phi_1253_ = _e254;
                phi_1254_ = _e256;
            } else {
                phi_1253_ = bool();
                phi_1254_ = true;
            }
            let _e258 = phi_1253_;
            let _e260 = phi_1254_;
            if _e260 {
                phi_1258_ = false;
            } else {
                phi_1258_ = _e258;
            }
            let _e262 = phi_1258_;
            if _e262 {
                let _e264 = p.member.map_size;
                let _e265 = f32(_e264);
                let _e268 = ((_e208 * _e265) - 0.5f);
                let _e269 = ((_e222 * _e265) - 0.5f);
                if (_e268 > -8388608f) {
                    let _e281 = f32(select(0i, select(select(i32(_e268), i32(-2147483648), (_e268 < bitcast<f32>(3472883712u))), 2147483647i, (_e268 > bitcast<f32>(1325400063u))), (_e268 == _e268)));
                    if (_e281 > _e268) {
                        phi_1294_ = 1f;
                    } else {
                        phi_1294_ = 0f;
                    }
                    let _e284 = phi_1294_;
                    if (_e268 < 8388608f) {
                        phi_1299_ = (_e281 - _e284);
                        phi_1300_ = false;
                    } else {
                        phi_1299_ = f32();
                        phi_1300_ = true;
                    }
                    let _e287 = phi_1299_;
                    let _e289 = phi_1300_;
                    phi_1301_ = _e287;
                    phi_1302_ = _e289;
                } else {
                    phi_1301_ = f32();
                    phi_1302_ = true;
                }
                let _e291 = phi_1301_;
                let _e293 = phi_1302_;
                if _e293 {
                    phi_1306_ = _e268;
                } else {
                    phi_1306_ = _e291;
                }
                let _e295 = phi_1306_;
                if (_e269 > -8388608f) {
                    let _e307 = f32(select(0i, select(select(i32(_e269), i32(-2147483648), (_e269 < bitcast<f32>(3472883712u))), 2147483647i, (_e269 > bitcast<f32>(1325400063u))), (_e269 == _e269)));
                    if (_e307 > _e269) {
                        phi_1326_ = 1f;
                    } else {
                        phi_1326_ = 0f;
                    }
                    let _e310 = phi_1326_;
                    if (_e269 < 8388608f) {
                        phi_1331_ = (_e307 - _e310);
                        phi_1332_ = false;
                    } else {
                        phi_1331_ = f32();
                        phi_1332_ = true;
                    }
                    let _e313 = phi_1331_;
                    let _e315 = phi_1332_;
                    phi_1333_ = _e313;
                    phi_1334_ = _e315;
                } else {
                    phi_1333_ = f32();
                    phi_1334_ = true;
                }
                let _e317 = phi_1333_;
                let _e319 = phi_1334_;
                if _e319 {
                    phi_1338_ = _e269;
                } else {
                    phi_1338_ = _e317;
                }
                let _e321 = phi_1338_;
                let _e322 = (_e268 - _e295);
                let _e323 = (_e269 - _e321);
                let _e332 = select(0i, select(select(i32(_e295), i32(-2147483648), (_e295 < bitcast<f32>(3472883712u))), 2147483647i, (_e295 > bitcast<f32>(1325400063u))), (_e295 == _e295));
                let _e341 = select(0i, select(select(i32(_e321), i32(-2147483648), (_e321 < bitcast<f32>(3472883712u))), 2147483647i, (_e321 > bitcast<f32>(1325400063u))), (_e321 == _e321));
                let _e344 = ((1f - _e322) * (1f - _e323));
                let _e346 = (_e322 * (1f - _e323));
                let _e348 = ((1f - _e322) * _e323);
                let _e349 = (_e322 * _e323);
                let _e351 = p.member.test;
                let _e352 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e351);
                let _e354 = p.member.map_size;
                local_2 = _e352;
                let _e356 = (bitcast<i32>(_e354) - 1i);
                if (_e332 > 0i) {
                    phi_1384_ = _e332;
                } else {
                    phi_1384_ = 0i;
                }
                let _e359 = phi_1384_;
                if (_e341 > 0i) {
                    phi_1389_ = _e341;
                } else {
                    phi_1389_ = 0i;
                }
                let _e362 = phi_1389_;
                if (_e359 < _e356) {
                    phi_1394_ = _e359;
                } else {
                    phi_1394_ = _e356;
                }
                let _e365 = phi_1394_;
                if (_e362 < _e356) {
                    phi_1399_ = _e362;
                } else {
                    phi_1399_ = _e356;
                }
                let _e368 = phi_1399_;
                let _e369 = bitcast<u32>(_e365);
                let _e371 = (_e332 + 1i);
                let _e372 = (_e341 + 1i);
                if (_e371 > 0i) {
                    phi_1408_ = _e371;
                } else {
                    phi_1408_ = 0i;
                }
                let _e375 = phi_1408_;
                if (_e372 > 0i) {
                    phi_1413_ = _e372;
                } else {
                    phi_1413_ = 0i;
                }
                let _e378 = phi_1413_;
                if (_e375 < _e356) {
                    phi_1418_ = _e375;
                } else {
                    phi_1418_ = _e356;
                }
                let _e381 = phi_1418_;
                if (_e378 < _e356) {
                    phi_1423_ = _e378;
                } else {
                    phi_1423_ = _e356;
                }
                let _e384 = phi_1423_;
                let _e385 = bitcast<u32>(_e381);
                let _e387 = (bitcast<u32>(_e368) * _e354);
                let _e388 = (bitcast<u32>(_e384) * _e354);
                let _e389 = (_e387 + _e369);
                let _e390 = (_e387 + _e385);
                let _e391 = (_e388 + _e369);
                let _e392 = (_e388 + _e385);
                if (_e389 < _e46) {
                } else {
                    return;
                }
                let _e396 = map.member[(0u + _e389)];
                if (_e390 < _e46) {
                } else {
                    return;
                }
                let _e408 = map.member[(0u + _e390)];
                if (_e391 < _e46) {
                } else {
                    return;
                }
                let _e424 = map.member[(0u + _e391)];
                if (_e392 < _e46) {
                } else {
                    return;
                }
                let _e440 = map.member[(0u + _e392)];
                let _e454 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_2), vec4<f32>(((((_e396.x * _e344) + (_e408.x * _e346)) + (_e424.x * _e348)) + (_e440.x * _e349)), ((((_e396.y * _e344) + (_e408.y * _e346)) + (_e424.y * _e348)) + (_e440.y * _e349)), ((((_e396.z * _e344) + (_e408.z * _e346)) + (_e424.z * _e348)) + (_e440.z * _e349)), ((((_e396.w * _e344) + (_e408.w * _e346)) + (_e424.w * _e348)) + (_e440.w * _e349))), _e235);
                let _e456 = p.member.epsilon;
                if (_e454 <= _e456) {
                    phi_1514_ = true;
                } else {
                    phi_1514_ = (_e454 >= (1f - _e456));
                }
                let _e461 = phi_1514_;
                if ((bitcast<u32>(_e454) & 2147483647u) > 2139095040u) {
                    phi_1522_ = true;
                } else {
                    phi_1522_ = !(_e461);
                }
                let _e467 = phi_1522_;
                if (_e454 > 0.5f) {
                    phi_1527_ = 1f;
                } else {
                    phi_1527_ = 0f;
                }
                let _e470 = phi_1527_;
                phi_1530_ = evaluate_Verdict(_e470, _e467);
            } else {
                phi_1530_ = evaluate_Verdict(1f, true);
            }
            let _e474 = phi_1530_;
            phi_1531_ = _e474;
        }
        let _e476 = phi_1531_;
        visibility.member[_e56.first_primitive] = _e476.visibility;
        phi_1535_ = _e476.is_doubted;
        phi_1536_ = _e56.first_primitive;
    } else {
        phi_1535_ = false;
        phi_1536_ = 0u;
    }
    let _e481 = phi_1535_;
    let _e483 = phi_1536_;
    if _e481 {
        let _e485 = atomicAdd((&shared_[0u]), 1u);
        phi_1542_ = _e485;
    } else {
        phi_1542_ = 0u;
    }
    let _e487 = phi_1542_;
    workgroupBarrier();
    if (_e41 == 0u) {
        let _e491 = atomicLoad((&shared_[0u]));
        let _e492 = atomicAdd((&list.member[3u]), _e491);
        atomicStore((&shared_[1u]), _e492);
    }
    workgroupBarrier();
    if _e481 {
        let _e495 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e495) + _e487)]), _e483);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_msm_hausdorff_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_3 = local;
    function_();
}
