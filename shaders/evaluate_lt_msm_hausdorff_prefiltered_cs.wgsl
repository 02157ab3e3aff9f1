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
    var phi_152_: lt_bvh_traverse_Tree;
    var phi_153_: bool;
    var phi_154_: lt_bvh_traverse_Tree;
    var phi_155_: bool;
    var phi_160_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_152_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_153_ = false;
        } else {
            phi_152_ = lt_bvh_traverse_Tree();
            phi_153_ = true;
        }
        let _e52 = phi_152_;
        let _e54 = phi_153_;
        phi_154_ = _e52;
        phi_155_ = _e54;
    } else {
        phi_154_ = lt_bvh_traverse_Tree();
        phi_155_ = true;
    }
    let _e56 = phi_154_;
    let _e58 = phi_155_;
    if _e58 {
        phi_160_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_160_ = _e56;
    }
    let _e63 = phi_160_;
    return lt_bvh_traverse_Tree(_e63.root, _e63.first_primitive);
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn lt_math_hausdorff_cubic_mass(param_4: vec4<f32>, param_5: f32, param_6: f32, param_7: f32, param_8: f32) -> f32 {
    return ((((param_4.z - (((param_6 + param_7) + param_8) * param_4.y)) + ((((param_6 * param_7) + (param_6 * param_8)) + (param_7 * param_8)) * param_4.x)) - ((param_6 * param_7) * param_8)) / (((param_5 - param_6) * (param_5 - param_7)) * (param_5 - param_8)));
}

fn lt_math_hausdorff_endpoint_upper_bound(param_9: ptr<function, hankel_HankelFactors>, param_10: f32) -> f32 {
    var phi_930_: f32;
    var phi_931_: f32;
    var phi_932_: f32;
    var phi_959_: f32;
    var phi_960_: f32;
    var phi_961_: f32;
    var phi_962_: f32;
    var phi_963_: bool;
    var phi_964_: f32;
    var phi_965_: bool;
    var phi_993_: f32;
    var phi_994_: f32;
    var phi_995_: f32;
    var phi_996_: f32;
    var phi_997_: bool;
    var phi_998_: f32;
    var phi_999_: bool;
    var phi_1006_: f32;
    var phi_1007_: f32;
    var phi_1008_: f32;
    var phi_1009_: f32;

    let _e42 = (*param_9).moments;
    if (param_10 < 0.0001f) {
        phi_1009_ = 1f;
    } else {
        let _e51 = ((_e42.z - ((1f + param_10) * _e42.y)) + (param_10 * _e42.x));
        let _e60 = (((_e42.w - ((1f + param_10) * _e42.z)) + (param_10 * _e42.y)) / _e51);
        if (abs(_e51) <= 0.00000047683716f) {
            let _e74 = (1f - (((_e42.y - (_e42.x * (param_10 + 1f))) + (param_10 * 1f)) / ((0f - param_10) * (0f - 1f))));
            if ((bitcast<u32>(_e74) & 2147483647u) > 2139095040u) {
                phi_932_ = _e74;
            } else {
                if (_e74 < 0f) {
                    phi_931_ = 0f;
                } else {
                    if (_e74 > 1f) {
                        phi_930_ = 1f;
                    } else {
                        phi_930_ = _e74;
                    }
                    let _e81 = phi_930_;
                    phi_931_ = _e81;
                }
                let _e83 = phi_931_;
                phi_932_ = _e83;
            }
            let _e85 = phi_932_;
            phi_1008_ = _e85;
        } else {
            if (_e60 > 0f) {
                if (_e60 < param_10) {
                    let _e88 = lt_math_hausdorff_cubic_mass(_e42, 0f, _e60, param_10, 1f);
                    let _e90 = lt_math_hausdorff_cubic_mass(_e42, _e60, 0f, param_10, 1f);
                    let _e91 = ((1f - _e88) - _e90);
                    if ((bitcast<u32>(_e91) & 2147483647u) > 2139095040u) {
                        phi_961_ = _e91;
                    } else {
                        if (_e91 < 0f) {
                            phi_960_ = 0f;
                        } else {
                            if (_e91 > 1f) {
                                phi_959_ = 1f;
                            } else {
                                phi_959_ = _e91;
                            }
                            let _e98 = phi_959_;
                            phi_960_ = _e98;
                        }
                        let _e100 = phi_960_;
                        phi_961_ = _e100;
                    }
                    let _e102 = phi_961_;
                    phi_962_ = _e102;
                    phi_963_ = false;
                } else {
                    phi_962_ = f32();
                    phi_963_ = true;
                }
                let _e104 = phi_962_;
                let _e106 = phi_963_;
                phi_964_ = _e104;
                phi_965_ = _e106;
            } else {
                phi_964_ = f32();
                phi_965_ = true;
            }
            let _e108 = phi_964_;
            let _e110 = phi_965_;
            if _e110 {
                if (_e60 > param_10) {
                    if (_e60 < 1f) {
                        let _e113 = lt_math_hausdorff_cubic_mass(_e42, 0f, _e60, param_10, 1f);
                        let _e114 = (1f - _e113);
                        if ((bitcast<u32>(_e114) & 2147483647u) > 2139095040u) {
                            phi_995_ = _e114;
                        } else {
                            if (_e114 < 0f) {
                                phi_994_ = 0f;
                            } else {
                                if (_e114 > 1f) {
                                    phi_993_ = 1f;
                                } else {
                                    phi_993_ = _e114;
                                }
                                let _e121 = phi_993_;
                                phi_994_ = _e121;
                            }
                            let _e123 = phi_994_;
                            phi_995_ = _e123;
                        }
                        let _e125 = phi_995_;
                        phi_996_ = _e125;
                        phi_997_ = false;
                    } else {
                        phi_996_ = f32();
                        phi_997_ = true;
                    }
                    let _e127 = phi_996_;
                    let _e129 = phi_997_;
                    phi_998_ = _e127;
                    phi_999_ = _e129;
                } else {
                    phi_998_ = f32();
                    phi_999_ = true;
                }
                let _e131 = phi_998_;
                let _e133 = phi_999_;
                if _e133 {
                    phi_1006_ = bitcast<f32>((bitcast<u32>(_e60) | 2143289344u));
                } else {
                    phi_1006_ = _e131;
                }
                let _e138 = phi_1006_;
                phi_1007_ = _e138;
            } else {
                phi_1007_ = _e108;
            }
            let _e140 = phi_1007_;
            phi_1008_ = _e140;
        }
        let _e142 = phi_1008_;
        phi_1009_ = _e142;
    }
    let _e144 = phi_1009_;
    return _e144;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_11: ptr<function, f32>, param_12: vec4<f32>, param_13: f32) -> f32 {
    var local: hankel_HankelFactors;
    var phi_217_: f32;
    var phi_218_: f32;
    var phi_219_: f32;
    var phi_231_: bool;
    var phi_246_: bool;
    var phi_271_: f32;
    var phi_272_: f32;
    var phi_273_: f32;
    var phi_274_: f32;
    var phi_275_: bool;
    var phi_276_: f32;
    var phi_277_: bool;
    var phi_333_: vec2<f32>;
    var phi_371_: f32;
    var phi_372_: f32;
    var phi_373_: f32;
    var phi_406_: f32;
    var phi_407_: f32;
    var phi_408_: f32;
    var phi_412_: f32;
    var phi_413_: f32;
    var phi_414_: f32;
    var phi_415_: f32;
    var phi_468_: vec2<f32>;
    var phi_490_: bool;
    var phi_515_: f32;
    var phi_516_: f32;
    var phi_517_: f32;
    var phi_518_: f32;
    var phi_519_: bool;
    var phi_520_: f32;
    var phi_521_: bool;
    var phi_577_: vec2<f32>;
    var phi_615_: f32;
    var phi_616_: f32;
    var phi_617_: f32;
    var phi_650_: f32;
    var phi_651_: f32;
    var phi_652_: f32;
    var phi_656_: f32;
    var phi_657_: f32;
    var phi_658_: f32;
    var phi_659_: f32;
    var phi_660_: f32;
    var phi_661_: bool;
    var phi_662_: f32;
    var phi_663_: bool;
    var phi_685_: bool;
    var phi_710_: f32;
    var phi_711_: f32;
    var phi_712_: f32;
    var phi_713_: f32;
    var phi_714_: bool;
    var phi_715_: f32;
    var phi_716_: bool;
    var phi_772_: vec2<f32>;
    var phi_810_: f32;
    var phi_811_: f32;
    var phi_812_: f32;
    var phi_845_: f32;
    var phi_846_: f32;
    var phi_847_: f32;
    var phi_851_: f32;
    var phi_852_: f32;
    var phi_853_: f32;
    var phi_854_: f32;
    var phi_865_: bool;
    var phi_869_: f32;
    var phi_870_: f32;
    var phi_871_: f32;
    var phi_872_: f32;

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
    local = hankel_HankelFactors(_e68.moments, _e68.d22_, _e68.l32_d22_, _e68.d33_d22_);
    if ((bitcast<u32>(param_13) & 2147483647u) > 2139095040u) {
        phi_219_ = param_13;
    } else {
        if (param_13 < 0f) {
            phi_218_ = 0f;
        } else {
            if (param_13 > 1f) {
                phi_217_ = 1f;
            } else {
                phi_217_ = param_13;
            }
            let _e80 = phi_217_;
            phi_218_ = _e80;
        }
        let _e82 = phi_218_;
        phi_219_ = _e82;
    }
    let _e84 = phi_219_;
    let _e87 = local.moments[0u];
    let _e90 = local.moments[3u];
    if (_e87 == _e90) {
        let _e94 = local.moments[0u];
        phi_231_ = (_e94 > 0.5f);
    } else {
        phi_231_ = false;
    }
    let _e97 = phi_231_;
    if _e97 {
        let _e100 = local.moments[0u];
        let _e103 = local.moments[3u];
        if (_e100 == _e103) {
            let _e107 = local.moments[0u];
            phi_246_ = (_e107 > 0.5f);
        } else {
            phi_246_ = false;
        }
        let _e110 = phi_246_;
        if _e110 {
            if (_e84 > 0f) {
                let _e113 = local.moments;
                if ((bitcast<u32>(_e113.x) & 2147483647u) > 2139095040u) {
                    phi_273_ = _e113.x;
                } else {
                    if (_e113.x < 0f) {
                        phi_272_ = 0f;
                    } else {
                        if (_e113.x > 1f) {
                            phi_271_ = 1f;
                        } else {
                            phi_271_ = _e113.x;
                        }
                        let _e121 = phi_271_;
                        phi_272_ = _e121;
                    }
                    let _e123 = phi_272_;
                    phi_273_ = _e123;
                }
                let _e125 = phi_273_;
                phi_274_ = _e125;
                phi_275_ = false;
            } else {
                phi_274_ = f32();
                phi_275_ = true;
            }
            let _e127 = phi_274_;
            let _e129 = phi_275_;
            phi_276_ = _e127;
            phi_277_ = _e129;
        } else {
            phi_276_ = f32();
            phi_277_ = true;
        }
        let _e131 = phi_276_;
        let _e133 = phi_277_;
        if _e133 {
            let _e136 = local.moments[0u];
            let _e139 = local.moments[1u];
            let _e147 = local.l32_d22_;
            let _e149 = local.d22_;
            let _e150 = (_e147 / _e149);
            let _e151 = (_e84 - _e136);
            let _e157 = local.d22_;
            let _e160 = local.d33_d22_;
            let _e161 = (((((_e84 * _e84) - _e139) - (_e150 * _e151)) * _e157) / _e160);
            let _e163 = local.d22_;
            let _e166 = ((_e151 / _e163) - (_e150 * _e161));
            let _e172 = ((0.5f * _e166) / _e161);
            let _e175 = ((_e172 * _e172) - (((1f - (_e166 * _e136)) - (_e161 * _e139)) / _e161));
            if (_e175 >= 0f) {
                let _e177 = sqrt(_e175);
                phi_333_ = vec2<f32>((-(_e172) - _e177), (-(_e172) + _e177));
            } else {
                phi_333_ = vec2(bitcast<f32>((bitcast<u32>(_e175) | 2143289344u)));
            }
            let _e188 = phi_333_;
            if (_e84 <= _e188.x) {
                phi_414_ = 1f;
            } else {
                if (_e84 > _e188.y) {
                    let _e194 = local.moments;
                    let _e205 = (((_e194.y - (_e194.x * (_e188.x + _e188.y))) + (_e188.x * _e188.y)) / ((_e84 - _e188.x) * (_e84 - _e188.y)));
                    if ((bitcast<u32>(_e205) & 2147483647u) > 2139095040u) {
                        phi_373_ = _e205;
                    } else {
                        if (_e205 < 0f) {
                            phi_372_ = 0f;
                        } else {
                            if (_e205 > 1f) {
                                phi_371_ = 1f;
                            } else {
                                phi_371_ = _e205;
                            }
                            let _e212 = phi_371_;
                            phi_372_ = _e212;
                        }
                        let _e214 = phi_372_;
                        phi_373_ = _e214;
                    }
                    let _e216 = phi_373_;
                    phi_413_ = _e216;
                } else {
                    if (_e84 > _e188.x) {
                        let _e219 = local.moments;
                        let _e231 = (1f - (((_e219.y - (_e219.x * (_e84 + _e188.y))) + (_e84 * _e188.y)) / ((_e188.x - _e84) * (_e188.x - _e188.y))));
                        if ((bitcast<u32>(_e231) & 2147483647u) > 2139095040u) {
                            phi_408_ = _e231;
                        } else {
                            if (_e231 < 0f) {
                                phi_407_ = 0f;
                            } else {
                                if (_e231 > 1f) {
                                    phi_406_ = 1f;
                                } else {
                                    phi_406_ = _e231;
                                }
                                let _e238 = phi_406_;
                                phi_407_ = _e238;
                            }
                            let _e240 = phi_407_;
                            phi_408_ = _e240;
                        }
                        let _e242 = phi_408_;
                        phi_412_ = _e242;
                    } else {
                        phi_412_ = bitcast<f32>((bitcast<u32>(_e188.x) | 2143289344u));
                    }
                    let _e247 = phi_412_;
                    phi_413_ = _e247;
                }
                let _e249 = phi_413_;
                phi_414_ = _e249;
            }
            let _e251 = phi_414_;
            phi_415_ = _e251;
        } else {
            phi_415_ = _e131;
        }
        let _e253 = phi_415_;
        phi_872_ = _e253;
    } else {
        let _e256 = local.moments[0u];
        let _e259 = local.moments[1u];
        let _e267 = local.l32_d22_;
        let _e269 = local.d22_;
        let _e270 = (_e267 / _e269);
        let _e271 = (_e84 - _e256);
        let _e277 = local.d22_;
        let _e280 = local.d33_d22_;
        let _e281 = (((((_e84 * _e84) - _e259) - (_e270 * _e271)) * _e277) / _e280);
        let _e283 = local.d22_;
        let _e286 = ((_e271 / _e283) - (_e270 * _e281));
        let _e292 = ((0.5f * _e286) / _e281);
        let _e295 = ((_e292 * _e292) - (((1f - (_e286 * _e256)) - (_e281 * _e259)) / _e281));
        if (_e295 >= 0f) {
            let _e297 = sqrt(_e295);
            phi_468_ = vec2<f32>((-(_e292) - _e297), (-(_e292) + _e297));
        } else {
            phi_468_ = vec2(bitcast<f32>((bitcast<u32>(_e295) | 2143289344u)));
        }
        let _e308 = phi_468_;
        if (_e308.x >= 0f) {
            if (_e308.y <= 1f) {
                let _e315 = local.moments[0u];
                let _e318 = local.moments[3u];
                if (_e315 == _e318) {
                    let _e322 = local.moments[0u];
                    phi_490_ = (_e322 > 0.5f);
                } else {
                    phi_490_ = false;
                }
                let _e325 = phi_490_;
                if _e325 {
                    if (_e84 > 0f) {
                        let _e328 = local.moments;
                        if ((bitcast<u32>(_e328.x) & 2147483647u) > 2139095040u) {
                            phi_517_ = _e328.x;
                        } else {
                            if (_e328.x < 0f) {
                                phi_516_ = 0f;
                            } else {
                                if (_e328.x > 1f) {
                                    phi_515_ = 1f;
                                } else {
                                    phi_515_ = _e328.x;
                                }
                                let _e336 = phi_515_;
                                phi_516_ = _e336;
                            }
                            let _e338 = phi_516_;
                            phi_517_ = _e338;
                        }
                        let _e340 = phi_517_;
                        phi_518_ = _e340;
                        phi_519_ = false;
                    } else {
                        phi_518_ = f32();
                        phi_519_ = true;
                    }
                    let _e342 = phi_518_;
                    let _e344 = phi_519_;
                    phi_520_ = _e342;
                    phi_521_ = _e344;
                } else {
                    phi_520_ = f32();
                    phi_521_ = true;
                }
                let _e346 = phi_520_;
                let _e348 = phi_521_;
                if _e348 {
                    let _e351 = local.moments[0u];
                    let _e354 = local.moments[1u];
                    let _e362 = local.l32_d22_;
                    let _e364 = local.d22_;
                    let _e365 = (_e362 / _e364);
                    let _e366 = (_e84 - _e351);
                    let _e372 = local.d22_;
                    let _e375 = local.d33_d22_;
                    let _e376 = (((((_e84 * _e84) - _e354) - (_e365 * _e366)) * _e372) / _e375);
                    let _e378 = local.d22_;
                    let _e381 = ((_e366 / _e378) - (_e365 * _e376));
                    let _e387 = ((0.5f * _e381) / _e376);
                    let _e390 = ((_e387 * _e387) - (((1f - (_e381 * _e351)) - (_e376 * _e354)) / _e376));
                    if (_e390 >= 0f) {
                        let _e392 = sqrt(_e390);
                        phi_577_ = vec2<f32>((-(_e387) - _e392), (-(_e387) + _e392));
                    } else {
                        phi_577_ = vec2(bitcast<f32>((bitcast<u32>(_e390) | 2143289344u)));
                    }
                    let _e403 = phi_577_;
                    if (_e84 <= _e403.x) {
                        phi_658_ = 1f;
                    } else {
                        if (_e84 > _e403.y) {
                            let _e409 = local.moments;
                            let _e420 = (((_e409.y - (_e409.x * (_e403.x + _e403.y))) + (_e403.x * _e403.y)) / ((_e84 - _e403.x) * (_e84 - _e403.y)));
                            if ((bitcast<u32>(_e420) & 2147483647u) > 2139095040u) {
                                phi_617_ = _e420;
                            } else {
                                if (_e420 < 0f) {
                                    phi_616_ = 0f;
                                } else {
                                    if (_e420 > 1f) {
                                        phi_615_ = 1f;
                                    } else {
                                        phi_615_ = _e420;
                                    }
                                    let _e427 = phi_615_;
                                    phi_616_ = _e427;
                                }
                                let _e429 = phi_616_;
                                phi_617_ = _e429;
                            }
                            let _e431 = phi_617_;
                            phi_657_ = _e431;
                        } else {
                            if (_e84 > _e403.x) {
                                let _e434 = local.moments;
                                let _e446 = (1f - (((_e434.y - (_e434.x * (_e84 + _e403.y))) + (_e84 * _e403.y)) / ((_e403.x - _e84) * (_e403.x - _e403.y))));
                                if ((bitcast<u32>(_e446) & 2147483647u) > 2139095040u) {
                                    phi_652_ = _e446;
                                } else {
                                    if (_e446 < 0f) {
                                        phi_651_ = 0f;
                                    } else {
                                        if (_e446 > 1f) {
                                            phi_650_ = 1f;
                                        } else {
                                            phi_650_ = _e446;
                                        }
                                        let _e453 = phi_650_;
                                        phi_651_ = _e453;
                                    }
                                    let _e455 = phi_651_;
                                    phi_652_ = _e455;
                                }
                                let _e457 = phi_652_;
                                phi_656_ = _e457;
                            } else {
                                phi_656_ = bitcast<f32>((bitcast<u32>(_e403.x) | 2143289344u));
                            }
                            let _e462 = phi_656_;
                            phi_657_ = _e462;
                        }
                        let _e464 = phi_657_;
                        phi_658_ = _e464;
                    }
                    let _e466 = phi_658_;
                    phi_659_ = _e466;
                } else {
                    phi_659_ = _e346;
                }
                let _e468 = phi_659_;
                phi_660_ = _e468;
                phi_661_ = false;
            } else {
                phi_660_ = f32();
                phi_661_ = true;
            }
            let _e470 = phi_660_;
            let _e472 = phi_661_;
            phi_662_ = _e470;
            phi_663_ = _e472;
        } else {
            phi_662_ = f32();
            phi_663_ = true;
        }
        let _e474 = phi_662_;
        let _e476 = phi_663_;
        if _e476 {
            if ((bitcast<u32>(_e308.x) & 2147483647u) > 2139095040u) {
                phi_870_ = _e308.x;
            } else {
                let _e480 = lt_math_hausdorff_endpoint_upper_bound((&local), _e84);
                let _e483 = local.moments[0u];
                let _e486 = local.moments[3u];
                if (_e483 == _e486) {
                    let _e490 = local.moments[0u];
                    phi_685_ = (_e490 > 0.5f);
                } else {
                    phi_685_ = false;
                }
                let _e493 = phi_685_;
                if _e493 {
                    if (_e84 > 0f) {
                        let _e496 = local.moments;
                        if ((bitcast<u32>(_e496.x) & 2147483647u) > 2139095040u) {
                            phi_712_ = _e496.x;
                        } else {
                            if (_e496.x < 0f) {
                                phi_711_ = 0f;
                            } else {
                                if (_e496.x > 1f) {
                                    phi_710_ = 1f;
                                } else {
                                    phi_710_ = _e496.x;
                                }
                                let _e504 = phi_710_;
                                phi_711_ = _e504;
                            }
                            let _e506 = phi_711_;
                            phi_712_ = _e506;
                        }
                        let _e508 = phi_712_;
                        phi_713_ = _e508;
                        phi_714_ = false;
                    } else {
                        phi_713_ = f32();
                        phi_714_ = true;
                    }
                    let _e510 = phi_713_;
                    let _e512 = phi_714_;
                    phi_715_ = _e510;
                    phi_716_ = _e512;
                } else {
                    phi_715_ = f32();
                    phi_716_ = true;
                }
                let _e514 = phi_715_;
                let _e516 = phi_716_;
                if _e516 {
                    let _e519 = local.moments[0u];
                    let _e522 = local.moments[1u];
                    let _e530 = local.l32_d22_;
                    let _e532 = local.d22_;
                    let _e533 = (_e530 / _e532);
                    let _e534 = (_e84 - _e519);
                    let _e540 = local.d22_;
                    let _e543 = local.d33_d22_;
                    let _e544 = (((((_e84 * _e84) - _e522) - (_e533 * _e534)) * _e540) / _e543);
                    let _e546 = local.d22_;
                    let _e549 = ((_e534 / _e546) - (_e533 * _e544));
                    let _e555 = ((0.5f * _e549) / _e544);
                    let _e558 = ((_e555 * _e555) - (((1f - (_e549 * _e519)) - (_e544 * _e522)) / _e544));
                    if (_e558 >= 0f) {
                        let _e560 = sqrt(_e558);
                        phi_772_ = vec2<f32>((-(_e555) - _e560), (-(_e555) + _e560));
                    } else {
                        phi_772_ = vec2(bitcast<f32>((bitcast<u32>(_e558) | 2143289344u)));
                    }
                    let _e571 = phi_772_;
                    if (_e84 <= _e571.x) {
                        phi_853_ = 1f;
                    } else {
                        if (_e84 > _e571.y) {
                            let _e577 = local.moments;
                            let _e588 = (((_e577.y - (_e577.x * (_e571.x + _e571.y))) + (_e571.x * _e571.y)) / ((_e84 - _e571.x) * (_e84 - _e571.y)));
                            if ((bitcast<u32>(_e588) & 2147483647u) > 2139095040u) {
                                phi_812_ = _e588;
                            } else {
                                if (_e588 < 0f) {
                                    phi_811_ = 0f;
                                } else {
                                    if (_e588 > 1f) {
                                        phi_810_ = 1f;
                                    } else {
                                        phi_810_ = _e588;
                                    }
                                    let _e595 = phi_810_;
                                    phi_811_ = _e595;
                                }
                                let _e597 = phi_811_;
                                phi_812_ = _e597;
                            }
                            let _e599 = phi_812_;
                            phi_852_ = _e599;
                        } else {
                            if (_e84 > _e571.x) {
                                let _e602 = local.moments;
                                let _e614 = (1f - (((_e602.y - (_e602.x * (_e84 + _e571.y))) + (_e84 * _e571.y)) / ((_e571.x - _e84) * (_e571.x - _e571.y))));
                                if ((bitcast<u32>(_e614) & 2147483647u) > 2139095040u) {
                                    phi_847_ = _e614;
                                } else {
                                    if (_e614 < 0f) {
                                        phi_846_ = 0f;
                                    } else {
                                        if (_e614 > 1f) {
                                            phi_845_ = 1f;
                                        } else {
                                            phi_845_ = _e614;
                                        }
                                        let _e621 = phi_845_;
                                        phi_846_ = _e621;
                                    }
                                    let _e623 = phi_846_;
                                    phi_847_ = _e623;
                                }
                                let _e625 = phi_847_;
                                phi_851_ = _e625;
                            } else {
                                phi_851_ = bitcast<f32>((bitcast<u32>(_e571.x) | 2143289344u));
                            }
                            let _e630 = phi_851_;
                            phi_852_ = _e630;
                        }
                        let _e632 = phi_852_;
                        phi_853_ = _e632;
                    }
                    let _e634 = phi_853_;
                    phi_854_ = _e634;
                } else {
                    phi_854_ = _e514;
                }
                let _e636 = phi_854_;
                if ((bitcast<u32>(_e636) & 2147483647u) > 2139095040u) {
                    phi_865_ = true;
                } else {
                    let _e640 = (_e636 < _e480);
                    if _e640 {
                    }
                    phi_865_ = _e640;
                }
                let _e642 = phi_865_;
                if _e642 {
                    phi_869_ = _e636;
                } else {
                    phi_869_ = _e480;
                }
                let _e644 = phi_869_;
                phi_870_ = _e644;
            }
            let _e646 = phi_870_;
            phi_871_ = _e646;
        } else {
            phi_871_ = _e474;
        }
        let _e648 = phi_871_;
        phi_872_ = _e648;
    }
    let _e650 = phi_872_;
    return _e650;
}

fn function_() {
    var local_1: f32;
    var phi_1094_: bool;
    var phi_1095_: bool;
    var phi_1096_: bool;
    var phi_1097_: bool;
    var phi_1101_: bool;
    var phi_1171_: bool;
    var phi_1172_: bool;
    var phi_1183_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1184_: bool;
    var phi_1185_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1186_: bool;
    var phi_1193_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1197_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1271_: bool;
    var phi_1280_: bool;
    var phi_1289_: bool;
    var phi_1290_: bool;
    var phi_1291_: bool;
    var phi_1292_: bool;
    var phi_1293_: bool;
    var phi_1294_: bool;
    var phi_1295_: bool;
    var phi_1299_: bool;
    var phi_1389_: f32;
    var phi_1392_: f32;
    var phi_1421_: f32;
    var phi_1426_: f32;
    var phi_1427_: bool;
    var phi_1428_: f32;
    var phi_1429_: bool;
    var phi_1433_: f32;
    var phi_1453_: f32;
    var phi_1458_: f32;
    var phi_1459_: bool;
    var phi_1460_: f32;
    var phi_1461_: bool;
    var phi_1465_: f32;
    var phi_1513_: i32;
    var phi_1518_: i32;
    var phi_1523_: i32;
    var phi_1528_: i32;
    var phi_1537_: i32;
    var phi_1542_: i32;
    var phi_1547_: i32;
    var phi_1552_: i32;
    var phi_1649_: bool;
    var phi_1657_: bool;
    var phi_1669_: bool;
    var phi_1670_: bool;
    var phi_1674_: f32;
    var phi_1680_: f32;
    var phi_1682_: evaluate_Verdict;
    var phi_1692_: u32;
    var phi_1701_: f32;
    var phi_1703_: evaluate_Verdict;
    var phi_1704_: bool;
    var phi_1705_: evaluate_Verdict;
    var phi_1706_: bool;
    var phi_1711_: evaluate_Verdict;
    var phi_1716_: evaluate_Verdict;
    var phi_1717_: evaluate_Verdict;

    let _e40 = id_1;
    let _e47 = arrayLength((&map.member));
    let _e53 = p.member.size[0u];
    let _e55 = p.member.size[1u];
    let _e56 = lt_shaders_entry_pixel_index(_e40, _e53, _e55);
    if (bitcast<i32>(_e56.root) != 0i) {
        let _e62 = p.member.projection;
        if (_e56.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e66 = lt_math_OneLevel(_e62);
        let _e70 = samples.member[(0u + _e56.first_primitive)].normal[0u];
        let _e72 = global[0u];
        if (_e70 == _e72) {
            let _e75 = samples.member[(0u + _e56.first_primitive)].normal[1u];
            let _e77 = global[1u];
            if (_e75 == _e77) {
                let _e80 = samples.member[(0u + _e56.first_primitive)].normal[2u];
                let _e82 = global[2u];
                phi_1094_ = (_e80 == _e82);
                phi_1095_ = false;
            } else {
                phi_1094_ = bool();
                phi_1095_ = true;
            }
            let _e85 = phi_1094_;
            let _e87 = phi_1095_;
            phi_1096_ = _e85;
            phi_1097_ = _e87;
        } else {
            phi_1096_ = bool();
            phi_1097_ = true;
        }
        let _e89 = phi_1096_;
        let _e91 = phi_1097_;
        if _e91 {
            phi_1101_ = false;
        } else {
            phi_1101_ = _e89;
        }
        let _e93 = phi_1101_;
        if !(_e93) {
            let _e96 = samples.member[(0u + _e56.first_primitive)].position;
            let _e98 = p.member.light.place;
            let _e104 = p.member.light.place[3u];
            let _e111 = (_e98.x - (_e96.x * _e104));
            let _e112 = (_e98.y - (_e96.y * _e104));
            let _e113 = (_e98.z - (_e96.z * _e104));
            let _e115 = samples.member[(0u + _e56.first_primitive)].normal;
            if ((((_e115.x * _e111) + (_e115.y * _e112)) + (_e115.z * _e113)) > 0f) {
                let _e129 = (((_e111 * _e111) + (_e112 * _e112)) + (_e113 * _e113));
                let _e131 = p.member.light.axis;
                let _e143 = p.member.light.place[3u];
                if (_e143 == 0f) {
                    phi_1172_ = true;
                } else {
                    let _e146 = p.member.light.range_squared;
                    if (_e129 <= _e146) {
                        let _e149 = p.member.light.cos_outer;
                        phi_1171_ = (-((((_e111 * _e131.x) + (_e112 * _e131.y)) + (_e113 * _e131.z))) >= (_e149 * sqrt(_e129)));
                    } else {
                        phi_1171_ = false;
                    }
                    let _e154 = phi_1171_;
                    phi_1172_ = _e154;
                }
                let _e156 = phi_1172_;
                if _e156 {
                    let _e158 = samples.member[(0u + _e56.first_primitive)].flags;
                    let _e166 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e172 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e166.unnamed.visibility, false), _e166.unnamed_1);
                    phi_1183_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e172.unnamed, ((_e158 & 1u) == 0u));
                    phi_1184_ = false;
                } else {
                    phi_1183_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_1184_ = true;
                }
                let _e177 = phi_1183_;
                let _e179 = phi_1184_;
                phi_1185_ = _e177;
                phi_1186_ = _e179;
            } else {
                phi_1185_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_1186_ = true;
            }
            let _e181 = phi_1185_;
            let _e183 = phi_1186_;
            if _e183 {
                let _e189 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e195 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e189.unnamed.visibility, false), _e189.unnamed_1);
                phi_1193_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e195.unnamed, true);
            } else {
                phi_1193_ = _e181;
            }
            let _e200 = phi_1193_;
            phi_1197_ = _e200;
        } else {
            let _e206 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e212 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e206.unnamed.visibility, false), _e206.unnamed_1);
            phi_1197_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e212.unnamed, true);
        }
        let _e217 = phi_1197_;
        if _e217.unnamed_1 {
            phi_1717_ = evaluate_Verdict(_e217.unnamed.visibility, _e217.unnamed.is_doubted);
        } else {
            let _e225 = samples.member[(0u + _e56.first_primitive)].position;
            let _e243 = ((((_e66.projection.row_w.x * _e225.x) + (_e66.projection.row_w.y * _e225.y)) + (_e66.projection.row_w.z * _e225.z)) + (_e66.projection.row_w.w * 1f));
            let _e257 = (((((_e66.projection.row_x.x * _e225.x) + (_e66.projection.row_x.y * _e225.y)) + (_e66.projection.row_x.z * _e225.z)) + (_e66.projection.row_x.w * 1f)) / _e243);
            let _e271 = (((((_e66.projection.row_y.x * _e225.x) + (_e66.projection.row_y.y * _e225.y)) + (_e66.projection.row_y.z * _e225.z)) + (_e66.projection.row_y.w * 1f)) / _e243);
            let _e284 = ((((_e66.projection.row_z.x * _e225.x) + (_e66.projection.row_z.y * _e225.y)) + (_e66.projection.row_z.z * _e225.z)) + (_e66.projection.row_z.w * 1f));
            if (_e243 > 0f) {
                if (_e257 >= 0f) {
                    phi_1271_ = (_e257 <= 1f);
                } else {
                    phi_1271_ = false;
                }
                let _e289 = phi_1271_;
                if _e289 {
                    if (_e271 >= 0f) {
                        phi_1280_ = (_e271 <= 1f);
                    } else {
                        phi_1280_ = false;
                    }
                    let _e293 = phi_1280_;
                    if _e293 {
                        if (_e284 >= 0f) {
                            phi_1289_ = (_e284 <= 1f);
                        } else {
                            phi_1289_ = false;
                        }
                        let _e297 = phi_1289_;
                        phi_1290_ = _e297;
                        phi_1291_ = false;
                    } else {
                        phi_1290_ = bool();
                        phi_1291_ = true;
                    }
                    let _e299 = phi_1290_;
                    let _e301 = phi_1291_;
                    phi_1292_ = _e299;
                    phi_1293_ = _e301;
                } else {
                    phi_1292_ = bool();
                    phi_1293_ = true;
                }
                let _e303 = phi_1292_;
                let _e305 = phi_1293_;
                phi_1294_ = _e303;
                phi_1295_ = _e305;
            } else {
                phi_1294_ = bool();
                phi_1295_ = true;
            }
            let _e307 = phi_1294_;
            let _e309 = phi_1295_;
            if _e309 {
                phi_1299_ = false;
            } else {
                phi_1299_ = _e307;
            }
            let _e311 = phi_1299_;
            if _e311 {
                if (0f > 0f) {
                    let _e314 = samples.member[(0u + _e56.first_primitive)].normal;
                    let _e316 = p.member.map_size;
                    let _e386 = ((abs(((((_e62.row_x.x * _e314.x) + (_e62.row_x.y * _e314.y)) + (_e62.row_x.z * _e314.z)) / (((_e62.row_x.x * _e62.row_x.x) + (_e62.row_x.y * _e62.row_x.y)) + (_e62.row_x.z * _e62.row_x.z)))) + abs(((((_e62.row_y.x * _e314.x) + (_e62.row_y.y * _e314.y)) + (_e62.row_y.z * _e314.z)) / (((_e62.row_y.x * _e62.row_y.x) + (_e62.row_y.y * _e62.row_y.y)) + (_e62.row_y.z * _e62.row_y.z))))) / (abs(((((_e62.row_z.x * _e314.x) + (_e62.row_z.y * _e314.y)) + (_e62.row_z.z * _e314.z)) / (((_e62.row_z.x * _e62.row_z.x) + (_e62.row_z.y * _e62.row_z.y)) + (_e62.row_z.z * _e62.row_z.z)))) * f32(_e316)));
                    if (_e386 < 0.002f) {
                        phi_1389_ = _e386;
                    } else {
                        phi_1389_ = 0.002f;
                    }
                    let _e389 = phi_1389_;
                    phi_1392_ = (_e284 - (0f * _e389));
                } else {
                    phi_1392_ = _e284;
                }
                let _e393 = phi_1392_;
                let _e395 = p.member.map_size;
                let _e396 = f32(_e395);
                let _e399 = ((_e257 * _e396) - 0.5f);
                let _e400 = ((_e271 * _e396) - 0.5f);
                if (_e399 > -8388608f) {
                    let _e412 = f32(select(0i, select(select(i32(_e399), i32(-2147483648), (_e399 < bitcast<f32>(3472883712u))), 2147483647i, (_e399 > bitcast<f32>(1325400063u))), (_e399 == _e399)));
                    if (_e412 > _e399) {
                        phi_1421_ = 1f;
                    } else {
                        phi_1421_ = 0f;
                    }
                    let _e415 = phi_1421_;
                    if (_e399 < 8388608f) {
                        phi_1426_ = (_e412 - _e415);
                        phi_1427_ = false;
                    } else {
                        phi_1426_ = f32();
                        phi_1427_ = true;
                    }
                    let _e418 = phi_1426_;
                    let _e420 = phi_1427_;
                    phi_1428_ = _e418;
                    phi_1429_ = _e420;
                } else {
                    phi_1428_ = f32();
                    phi_1429_ = true;
                }
                let _e422 = phi_1428_;
                let _e424 = phi_1429_;
                if _e424 {
                    phi_1433_ = _e399;
                } else {
                    phi_1433_ = _e422;
                }
                let _e426 = phi_1433_;
                if (_e400 > -8388608f) {
                    let _e438 = f32(select(0i, select(select(i32(_e400), i32(-2147483648), (_e400 < bitcast<f32>(3472883712u))), 2147483647i, (_e400 > bitcast<f32>(1325400063u))), (_e400 == _e400)));
                    if (_e438 > _e400) {
                        phi_1453_ = 1f;
                    } else {
                        phi_1453_ = 0f;
                    }
                    let _e441 = phi_1453_;
                    if (_e400 < 8388608f) {
                        phi_1458_ = (_e438 - _e441);
                        phi_1459_ = false;
                    } else {
                        phi_1458_ = f32();
                        phi_1459_ = true;
                    }
                    let _e444 = phi_1458_;
                    let _e446 = phi_1459_;
                    phi_1460_ = _e444;
                    phi_1461_ = _e446;
                } else {
                    phi_1460_ = f32();
                    phi_1461_ = true;
                }
                let _e448 = phi_1460_;
                let _e450 = phi_1461_;
                if _e450 {
                    phi_1465_ = _e400;
                } else {
                    phi_1465_ = _e448;
                }
                let _e452 = phi_1465_;
                let _e453 = (_e399 - _e426);
                let _e454 = (_e400 - _e452);
                let _e463 = select(0i, select(select(i32(_e426), i32(-2147483648), (_e426 < bitcast<f32>(3472883712u))), 2147483647i, (_e426 > bitcast<f32>(1325400063u))), (_e426 == _e426));
                let _e472 = select(0i, select(select(i32(_e452), i32(-2147483648), (_e452 < bitcast<f32>(3472883712u))), 2147483647i, (_e452 > bitcast<f32>(1325400063u))), (_e452 == _e452));
                let _e475 = ((1f - _e453) * (1f - _e454));
                let _e477 = (_e453 * (1f - _e454));
                let _e479 = ((1f - _e453) * _e454);
                let _e480 = (_e453 * _e454);
                let _e482 = p.member.test;
                let _e483 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e482);
                let _e485 = p.member.map_size;
                local_1 = _e483;
                let _e487 = ((0u * _e485) * _e485);
                let _e489 = (bitcast<i32>(_e485) - 1i);
                if (_e463 > 0i) {
                    phi_1513_ = _e463;
                } else {
                    phi_1513_ = 0i;
                }
                let _e492 = phi_1513_;
                if (_e472 > 0i) {
                    phi_1518_ = _e472;
                } else {
                    phi_1518_ = 0i;
                }
                let _e495 = phi_1518_;
                if (_e492 < _e489) {
                    phi_1523_ = _e492;
                } else {
                    phi_1523_ = _e489;
                }
                let _e498 = phi_1523_;
                if (_e495 < _e489) {
                    phi_1528_ = _e495;
                } else {
                    phi_1528_ = _e489;
                }
                let _e501 = phi_1528_;
                let _e502 = bitcast<u32>(_e498);
                let _e504 = (_e463 + 1i);
                let _e505 = (_e472 + 1i);
                if (_e504 > 0i) {
                    phi_1537_ = _e504;
                } else {
                    phi_1537_ = 0i;
                }
                let _e508 = phi_1537_;
                if (_e505 > 0i) {
                    phi_1542_ = _e505;
                } else {
                    phi_1542_ = 0i;
                }
                let _e511 = phi_1542_;
                if (_e508 < _e489) {
                    phi_1547_ = _e508;
                } else {
                    phi_1547_ = _e489;
                }
                let _e514 = phi_1547_;
                if (_e511 < _e489) {
                    phi_1552_ = _e511;
                } else {
                    phi_1552_ = _e489;
                }
                let _e517 = phi_1552_;
                let _e518 = bitcast<u32>(_e514);
                let _e520 = (bitcast<u32>(_e501) * _e485);
                let _e521 = (bitcast<u32>(_e517) * _e485);
                let _e526 = ((_e520 + _e502) + _e487);
                let _e527 = ((_e520 + _e518) + _e487);
                let _e528 = ((_e521 + _e502) + _e487);
                let _e529 = ((_e521 + _e518) + _e487);
                if (_e526 < _e47) {
                } else {
                    return;
                }
                let _e533 = map.member[(0u + _e526)];
                if (_e527 < _e47) {
                } else {
                    return;
                }
                let _e545 = map.member[(0u + _e527)];
                if (_e528 < _e47) {
                } else {
                    return;
                }
                let _e561 = map.member[(0u + _e528)];
                if (_e529 < _e47) {
                } else {
                    return;
                }
                let _e577 = map.member[(0u + _e529)];
                let _e591 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_1), vec4<f32>(((((_e533.x * _e475) + (_e545.x * _e477)) + (_e561.x * _e479)) + (_e577.x * _e480)), ((((_e533.y * _e475) + (_e545.y * _e477)) + (_e561.y * _e479)) + (_e577.y * _e480)), ((((_e533.z * _e475) + (_e545.z * _e477)) + (_e561.z * _e479)) + (_e577.z * _e480)), ((((_e533.w * _e475) + (_e545.w * _e477)) + (_e561.w * _e479)) + (_e577.w * _e480))), _e393);
                let _e595 = p.member.epsilon;
                if (_e591 <= _e595) {
                    phi_1649_ = true;
                } else {
                    phi_1649_ = (_e591 >= (1f - _e595));
                }
                let _e600 = phi_1649_;
                if ((bitcast<u32>(_e591) & 2147483647u) > 2139095040u) {
                    phi_1657_ = true;
                } else {
                    phi_1657_ = !(_e600);
                }
                let _e606 = phi_1657_;
                if _e606 {
                    if (_e591 > 0f) {
                        if (_e591 < 1f) {
                            phi_1669_ = false;
                        } else {
                            phi_1669_ = true;
                        }
                        let _e610 = phi_1669_;
                        phi_1670_ = _e610;
                    } else {
                        phi_1670_ = true;
                    }
                    let _e612 = phi_1670_;
                    if _e612 {
                        phi_1674_ = 0.5f;
                    } else {
                        phi_1674_ = _e591;
                    }
                    let _e614 = phi_1674_;
                    phi_1682_ = evaluate_Verdict(_e614, true);
                } else {
                    if (_e591 > 0.5f) {
                        phi_1680_ = 1f;
                    } else {
                        phi_1680_ = 0f;
                    }
                    let _e618 = phi_1680_;
                    phi_1682_ = evaluate_Verdict(_e618, false);
                }
                let _e621 = phi_1682_;
                let _e624 = (_e621.visibility < 0.5f);
                if _e621.is_doubted {
                    phi_1705_ = evaluate_Verdict();
                    phi_1706_ = true;
                } else {
                    if _e624 {
                        phi_1692_ = 2u;
                    } else {
                        phi_1692_ = 1u;
                    }
                    let _e626 = phi_1692_;
                    if ((0u & _e626) != 0u) {
                        if _e624 {
                            phi_1701_ = 0.000000059604645f;
                        } else {
                            phi_1701_ = 0.99999994f;
                        }
                        let _e630 = phi_1701_;
                        phi_1703_ = evaluate_Verdict(_e630, true);
                        phi_1704_ = false;
                    } else {
                        phi_1703_ = evaluate_Verdict();
                        phi_1704_ = true;
                    }
                    let _e633 = phi_1703_;
                    let _e635 = phi_1704_;
                    phi_1705_ = _e633;
                    phi_1706_ = _e635;
                }
                let _e637 = phi_1705_;
                let _e639 = phi_1706_;
                if _e639 {
                    phi_1711_ = evaluate_Verdict(_e621.visibility, _e621.is_doubted);
                } else {
                    phi_1711_ = _e637;
                }
                let _e642 = phi_1711_;
                phi_1716_ = evaluate_Verdict(_e642.visibility, _e642.is_doubted);
            } else {
                phi_1716_ = evaluate_Verdict(0.5f, true);
            }
            let _e648 = phi_1716_;
            phi_1717_ = _e648;
        }
        let _e650 = phi_1717_;
        if (_e56.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e56.first_primitive)] = _e650.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_msm_hausdorff_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
