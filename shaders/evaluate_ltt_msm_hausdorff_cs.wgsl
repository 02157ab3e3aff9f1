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

struct type_25 {
    member: array<abi_Sample>,
}

struct type_29 {
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

struct type_38 {
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

struct type_46 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_25;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_38;
@group(0) @binding(2) 
var<storage> map: type_29;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_29;
var<private> local_3: u32;
@group(0) @binding(4) 
var<storage, read_write> list: type_46;
var<workgroup> shared_: array<atomic<u32>, 2>;

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
        let _e49 = phi_160_;
        let _e51 = phi_161_;
        phi_162_ = _e49;
        phi_163_ = _e51;
    } else {
        phi_162_ = lt_bvh_traverse_Tree();
        phi_163_ = true;
    }
    let _e53 = phi_162_;
    let _e55 = phi_163_;
    if _e55 {
        phi_168_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_168_ = _e53;
    }
    let _e60 = phi_168_;
    return lt_bvh_traverse_Tree(_e60.root, _e60.first_primitive);
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_4: f32) -> vec4<f32> {
    var phi_191_: f32;
    var phi_192_: f32;
    var phi_193_: f32;

    if ((bitcast<u32>(param_4) & 2147483647u) > 2139095040u) {
        phi_193_ = param_4;
    } else {
        if (param_4 < 0f) {
            phi_192_ = 0f;
        } else {
            if (param_4 > 1f) {
                phi_191_ = 1f;
            } else {
                phi_191_ = param_4;
            }
            let _e43 = phi_191_;
            phi_192_ = _e43;
        }
        let _e45 = phi_192_;
        phi_193_ = _e45;
    }
    let _e47 = phi_193_;
    let _e48 = (_e47 * _e47);
    return vec4<f32>(_e47, _e48, (_e48 * _e47), (_e48 * _e48));
}

fn lt_shaders_evaluate_to_light(param_5: vec3<f32>, param_6: vec4<f32>) -> vec3<f32> {
    return vec3<f32>((param_6.x - (param_5.x * param_6.w)), (param_6.y - (param_5.y * param_6.w)), (param_6.z - (param_5.z * param_6.w)));
}

fn lt_shaders_evaluate_quad_indices(param_7: i32, param_8: i32, param_9: u32) -> array<u32, 4> {
    var phi_225_: i32;
    var phi_230_: i32;
    var phi_235_: i32;
    var phi_240_: i32;
    var phi_249_: i32;
    var phi_254_: i32;
    var phi_259_: i32;
    var phi_264_: i32;

    let _e40 = (bitcast<i32>(param_9) - 1i);
    if (param_7 > 0i) {
        phi_225_ = param_7;
    } else {
        phi_225_ = 0i;
    }
    let _e43 = phi_225_;
    if (param_8 > 0i) {
        phi_230_ = param_8;
    } else {
        phi_230_ = 0i;
    }
    let _e46 = phi_230_;
    if (_e43 < _e40) {
        phi_235_ = _e43;
    } else {
        phi_235_ = _e40;
    }
    let _e49 = phi_235_;
    if (_e46 < _e40) {
        phi_240_ = _e46;
    } else {
        phi_240_ = _e40;
    }
    let _e52 = phi_240_;
    let _e53 = bitcast<u32>(_e49);
    let _e55 = (param_7 + 1i);
    let _e56 = (param_8 + 1i);
    if (_e55 > 0i) {
        phi_249_ = _e55;
    } else {
        phi_249_ = 0i;
    }
    let _e59 = phi_249_;
    if (_e56 > 0i) {
        phi_254_ = _e56;
    } else {
        phi_254_ = 0i;
    }
    let _e62 = phi_254_;
    if (_e59 < _e40) {
        phi_259_ = _e59;
    } else {
        phi_259_ = _e40;
    }
    let _e65 = phi_259_;
    if (_e62 < _e40) {
        phi_264_ = _e62;
    } else {
        phi_264_ = _e40;
    }
    let _e68 = phi_264_;
    let _e69 = bitcast<u32>(_e65);
    let _e71 = (bitcast<u32>(_e52) * param_9);
    let _e72 = (bitcast<u32>(_e68) * param_9);
    return array<u32, 4>((_e71 + _e53), (_e71 + _e69), (_e72 + _e53), (_e72 + _e69));
}

fn lt_math_hausdorff_cubic_mass(param_10: vec4<f32>, param_11: f32, param_12: f32, param_13: f32, param_14: f32) -> f32 {
    return ((((param_10.z - (((param_12 + param_13) + param_14) * param_10.y)) + ((((param_12 * param_13) + (param_12 * param_14)) + (param_13 * param_14)) * param_10.x)) - ((param_12 * param_13) * param_14)) / (((param_11 - param_12) * (param_11 - param_13)) * (param_11 - param_14)));
}

fn lt_math_hausdorff_endpoint_upper_bound(param_15: ptr<function, hankel_HankelFactors>, param_16: f32) -> f32 {
    var phi_883_: f32;
    var phi_884_: f32;
    var phi_885_: f32;
    var phi_912_: f32;
    var phi_913_: f32;
    var phi_914_: f32;
    var phi_915_: f32;
    var phi_916_: bool;
    var phi_917_: f32;
    var phi_918_: bool;
    var phi_946_: f32;
    var phi_947_: f32;
    var phi_948_: f32;
    var phi_949_: f32;
    var phi_950_: bool;
    var phi_951_: f32;
    var phi_952_: bool;
    var phi_959_: f32;
    var phi_960_: f32;
    var phi_961_: f32;
    var phi_962_: f32;

    let _e39 = (*param_15).moments;
    if (param_16 <= 0f) {
        phi_962_ = 1f;
    } else {
        let _e48 = ((_e39.z - ((1f + param_16) * _e39.y)) + (param_16 * _e39.x));
        let _e57 = (((_e39.w - ((1f + param_16) * _e39.z)) + (param_16 * _e39.y)) / _e48);
        if (abs(_e48) <= 0.00000047683716f) {
            let _e71 = (1f - (((_e39.y - (_e39.x * (param_16 + 1f))) + (param_16 * 1f)) / ((0f - param_16) * (0f - 1f))));
            if ((bitcast<u32>(_e71) & 2147483647u) > 2139095040u) {
                phi_885_ = _e71;
            } else {
                if (_e71 < 0f) {
                    phi_884_ = 0f;
                } else {
                    if (_e71 > 1f) {
                        phi_883_ = 1f;
                    } else {
                        phi_883_ = _e71;
                    }
                    let _e78 = phi_883_;
                    phi_884_ = _e78;
                }
                let _e80 = phi_884_;
                phi_885_ = _e80;
            }
            let _e82 = phi_885_;
            phi_961_ = _e82;
        } else {
            if (_e57 > 0f) {
                if (_e57 < param_16) {
                    let _e85 = lt_math_hausdorff_cubic_mass(_e39, 0f, _e57, param_16, 1f);
                    let _e87 = lt_math_hausdorff_cubic_mass(_e39, _e57, 0f, param_16, 1f);
                    let _e88 = ((1f - _e85) - _e87);
                    if ((bitcast<u32>(_e88) & 2147483647u) > 2139095040u) {
                        phi_914_ = _e88;
                    } else {
                        if (_e88 < 0f) {
                            phi_913_ = 0f;
                        } else {
                            if (_e88 > 1f) {
                                phi_912_ = 1f;
                            } else {
                                phi_912_ = _e88;
                            }
                            let _e95 = phi_912_;
                            phi_913_ = _e95;
                        }
                        let _e97 = phi_913_;
                        phi_914_ = _e97;
                    }
                    let _e99 = phi_914_;
                    phi_915_ = _e99;
                    phi_916_ = false;
                } else {
                    phi_915_ = f32();
                    phi_916_ = true;
                }
                let _e101 = phi_915_;
                let _e103 = phi_916_;
                phi_917_ = _e101;
                phi_918_ = _e103;
            } else {
                phi_917_ = f32();
                phi_918_ = true;
            }
            let _e105 = phi_917_;
            let _e107 = phi_918_;
            if _e107 {
                if (_e57 > param_16) {
                    if (_e57 < 1f) {
                        let _e110 = lt_math_hausdorff_cubic_mass(_e39, 0f, _e57, param_16, 1f);
                        let _e111 = (1f - _e110);
                        if ((bitcast<u32>(_e111) & 2147483647u) > 2139095040u) {
                            phi_948_ = _e111;
                        } else {
                            if (_e111 < 0f) {
                                phi_947_ = 0f;
                            } else {
                                if (_e111 > 1f) {
                                    phi_946_ = 1f;
                                } else {
                                    phi_946_ = _e111;
                                }
                                let _e118 = phi_946_;
                                phi_947_ = _e118;
                            }
                            let _e120 = phi_947_;
                            phi_948_ = _e120;
                        }
                        let _e122 = phi_948_;
                        phi_949_ = _e122;
                        phi_950_ = false;
                    } else {
                        phi_949_ = f32();
                        phi_950_ = true;
                    }
                    let _e124 = phi_949_;
                    let _e126 = phi_950_;
                    phi_951_ = _e124;
                    phi_952_ = _e126;
                } else {
                    phi_951_ = f32();
                    phi_952_ = true;
                }
                let _e128 = phi_951_;
                let _e130 = phi_952_;
                if _e130 {
                    phi_959_ = bitcast<f32>((bitcast<u32>(_e57) | 2143289344u));
                } else {
                    phi_959_ = _e128;
                }
                let _e135 = phi_959_;
                phi_960_ = _e135;
            } else {
                phi_960_ = _e105;
            }
            let _e137 = phi_960_;
            phi_961_ = _e137;
        }
        let _e139 = phi_961_;
        phi_962_ = _e139;
    }
    let _e141 = phi_962_;
    return _e141;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_17: ptr<function, f32>, param_18: vec4<f32>, param_19: f32) -> f32 {
    var local_1: hankel_HankelFactors;
    var phi_387_: f32;
    var phi_388_: f32;
    var phi_389_: f32;
    var phi_427_: f32;
    var phi_428_: f32;
    var phi_429_: f32;
    var phi_430_: f32;
    var phi_431_: bool;
    var phi_432_: f32;
    var phi_433_: bool;
    var phi_489_: vec2<f32>;
    var phi_527_: f32;
    var phi_528_: f32;
    var phi_529_: f32;
    var phi_562_: f32;
    var phi_563_: f32;
    var phi_564_: f32;
    var phi_568_: f32;
    var phi_569_: f32;
    var phi_570_: f32;
    var phi_571_: f32;
    var phi_624_: vec2<f32>;
    var phi_664_: f32;
    var phi_665_: f32;
    var phi_666_: f32;
    var phi_667_: f32;
    var phi_668_: bool;
    var phi_669_: f32;
    var phi_670_: bool;
    var phi_726_: vec2<f32>;
    var phi_764_: f32;
    var phi_765_: f32;
    var phi_766_: f32;
    var phi_799_: f32;
    var phi_800_: f32;
    var phi_801_: f32;
    var phi_805_: f32;
    var phi_806_: f32;
    var phi_807_: f32;
    var phi_808_: f32;
    var phi_809_: f32;
    var phi_810_: bool;
    var phi_811_: f32;
    var phi_812_: bool;
    var phi_823_: f32;
    var phi_824_: f32;
    var phi_825_: f32;

    let _e40 = (*param_17);
    let _e41 = (1f - _e40);
    let _e50 = (0.5f * _e40);
    let _e51 = ((param_18.x * _e41) + _e50);
    let _e52 = ((param_18.y * _e41) + _e50);
    let _e53 = ((param_18.z * _e41) + _e50);
    let _e54 = ((param_18.w * _e41) + _e50);
    let _e57 = (_e52 - (_e51 * _e51));
    let _e59 = (_e53 - (_e51 * _e52));
    let _e65 = hankel_HankelFactors(vec4<f32>(_e51, _e52, _e53, _e54), _e57, _e59, (((_e54 - (_e52 * _e52)) * _e57) - (_e59 * _e59)));
    local_1 = hankel_HankelFactors(_e65.moments, _e65.d22_, _e65.l32_d22_, _e65.d33_d22_);
    if ((bitcast<u32>(param_19) & 2147483647u) > 2139095040u) {
        phi_389_ = param_19;
    } else {
        if (param_19 < 0f) {
            phi_388_ = 0f;
        } else {
            if (param_19 > 1f) {
                phi_387_ = 1f;
            } else {
                phi_387_ = param_19;
            }
            let _e77 = phi_387_;
            phi_388_ = _e77;
        }
        let _e79 = phi_388_;
        phi_389_ = _e79;
    }
    let _e81 = phi_389_;
    let _e84 = local_1.moments[0u];
    let _e87 = local_1.moments[3u];
    if (_e84 == _e87) {
        let _e91 = local_1.moments[0u];
        let _e94 = local_1.moments[3u];
        if (_e91 == _e94) {
            if (_e81 > 0f) {
                let _e98 = local_1.moments;
                if ((bitcast<u32>(_e98.x) & 2147483647u) > 2139095040u) {
                    phi_429_ = _e98.x;
                } else {
                    if (_e98.x < 0f) {
                        phi_428_ = 0f;
                    } else {
                        if (_e98.x > 1f) {
                            phi_427_ = 1f;
                        } else {
                            phi_427_ = _e98.x;
                        }
                        let _e106 = phi_427_;
                        phi_428_ = _e106;
                    }
                    let _e108 = phi_428_;
                    phi_429_ = _e108;
                }
                let _e110 = phi_429_;
                phi_430_ = _e110;
                phi_431_ = false;
            } else {
                phi_430_ = f32();
                phi_431_ = true;
            }
            let _e112 = phi_430_;
            let _e114 = phi_431_;
            phi_432_ = _e112;
            phi_433_ = _e114;
        } else {
            phi_432_ = f32();
            phi_433_ = true;
        }
        let _e116 = phi_432_;
        let _e118 = phi_433_;
        if _e118 {
            let _e121 = local_1.moments[0u];
            let _e124 = local_1.moments[1u];
            let _e132 = local_1.l32_d22_;
            let _e134 = local_1.d22_;
            let _e135 = (_e132 / _e134);
            let _e136 = (_e81 - _e121);
            let _e142 = local_1.d22_;
            let _e145 = local_1.d33_d22_;
            let _e146 = (((((_e81 * _e81) - _e124) - (_e135 * _e136)) * _e142) / _e145);
            let _e148 = local_1.d22_;
            let _e151 = ((_e136 / _e148) - (_e135 * _e146));
            let _e157 = ((0.5f * _e151) / _e146);
            let _e160 = ((_e157 * _e157) - (((1f - (_e151 * _e121)) - (_e146 * _e124)) / _e146));
            if (_e160 >= 0f) {
                let _e162 = sqrt(_e160);
                phi_489_ = vec2<f32>((-(_e157) - _e162), (-(_e157) + _e162));
            } else {
                phi_489_ = vec2(bitcast<f32>((bitcast<u32>(_e160) | 2143289344u)));
            }
            let _e173 = phi_489_;
            if (_e81 <= _e173.x) {
                phi_570_ = 1f;
            } else {
                if (_e81 > _e173.y) {
                    let _e179 = local_1.moments;
                    let _e190 = (((_e179.y - (_e179.x * (_e173.x + _e173.y))) + (_e173.x * _e173.y)) / ((_e81 - _e173.x) * (_e81 - _e173.y)));
                    if ((bitcast<u32>(_e190) & 2147483647u) > 2139095040u) {
                        phi_529_ = _e190;
                    } else {
                        if (_e190 < 0f) {
                            phi_528_ = 0f;
                        } else {
                            if (_e190 > 1f) {
                                phi_527_ = 1f;
                            } else {
                                phi_527_ = _e190;
                            }
                            let _e197 = phi_527_;
                            phi_528_ = _e197;
                        }
                        let _e199 = phi_528_;
                        phi_529_ = _e199;
                    }
                    let _e201 = phi_529_;
                    phi_569_ = _e201;
                } else {
                    if (_e81 > _e173.x) {
                        let _e204 = local_1.moments;
                        let _e216 = (1f - (((_e204.y - (_e204.x * (_e81 + _e173.y))) + (_e81 * _e173.y)) / ((_e173.x - _e81) * (_e173.x - _e173.y))));
                        if ((bitcast<u32>(_e216) & 2147483647u) > 2139095040u) {
                            phi_564_ = _e216;
                        } else {
                            if (_e216 < 0f) {
                                phi_563_ = 0f;
                            } else {
                                if (_e216 > 1f) {
                                    phi_562_ = 1f;
                                } else {
                                    phi_562_ = _e216;
                                }
                                let _e223 = phi_562_;
                                phi_563_ = _e223;
                            }
                            let _e225 = phi_563_;
                            phi_564_ = _e225;
                        }
                        let _e227 = phi_564_;
                        phi_568_ = _e227;
                    } else {
                        phi_568_ = bitcast<f32>((bitcast<u32>(_e173.x) | 2143289344u));
                    }
                    let _e232 = phi_568_;
                    phi_569_ = _e232;
                }
                let _e234 = phi_569_;
                phi_570_ = _e234;
            }
            let _e236 = phi_570_;
            phi_571_ = _e236;
        } else {
            phi_571_ = _e116;
        }
        let _e238 = phi_571_;
        phi_825_ = _e238;
    } else {
        let _e241 = local_1.moments[0u];
        let _e244 = local_1.moments[1u];
        let _e252 = local_1.l32_d22_;
        let _e254 = local_1.d22_;
        let _e255 = (_e252 / _e254);
        let _e256 = (_e81 - _e241);
        let _e262 = local_1.d22_;
        let _e265 = local_1.d33_d22_;
        let _e266 = (((((_e81 * _e81) - _e244) - (_e255 * _e256)) * _e262) / _e265);
        let _e268 = local_1.d22_;
        let _e271 = ((_e256 / _e268) - (_e255 * _e266));
        let _e277 = ((0.5f * _e271) / _e266);
        let _e280 = ((_e277 * _e277) - (((1f - (_e271 * _e241)) - (_e266 * _e244)) / _e266));
        if (_e280 >= 0f) {
            let _e282 = sqrt(_e280);
            phi_624_ = vec2<f32>((-(_e277) - _e282), (-(_e277) + _e282));
        } else {
            phi_624_ = vec2(bitcast<f32>((bitcast<u32>(_e280) | 2143289344u)));
        }
        let _e293 = phi_624_;
        if (_e293.x >= 0f) {
            if (_e293.y <= 1f) {
                let _e300 = local_1.moments[0u];
                let _e303 = local_1.moments[3u];
                if (_e300 == _e303) {
                    if (_e81 > 0f) {
                        let _e307 = local_1.moments;
                        if ((bitcast<u32>(_e307.x) & 2147483647u) > 2139095040u) {
                            phi_666_ = _e307.x;
                        } else {
                            if (_e307.x < 0f) {
                                phi_665_ = 0f;
                            } else {
                                if (_e307.x > 1f) {
                                    phi_664_ = 1f;
                                } else {
                                    phi_664_ = _e307.x;
                                }
                                let _e315 = phi_664_;
                                phi_665_ = _e315;
                            }
                            let _e317 = phi_665_;
                            phi_666_ = _e317;
                        }
                        let _e319 = phi_666_;
                        phi_667_ = _e319;
                        phi_668_ = false;
                    } else {
                        phi_667_ = f32();
                        phi_668_ = true;
                    }
                    let _e321 = phi_667_;
                    let _e323 = phi_668_;
                    phi_669_ = _e321;
                    phi_670_ = _e323;
                } else {
                    phi_669_ = f32();
                    phi_670_ = true;
                }
                let _e325 = phi_669_;
                let _e327 = phi_670_;
                if _e327 {
                    let _e330 = local_1.moments[0u];
                    let _e333 = local_1.moments[1u];
                    let _e341 = local_1.l32_d22_;
                    let _e343 = local_1.d22_;
                    let _e344 = (_e341 / _e343);
                    let _e345 = (_e81 - _e330);
                    let _e351 = local_1.d22_;
                    let _e354 = local_1.d33_d22_;
                    let _e355 = (((((_e81 * _e81) - _e333) - (_e344 * _e345)) * _e351) / _e354);
                    let _e357 = local_1.d22_;
                    let _e360 = ((_e345 / _e357) - (_e344 * _e355));
                    let _e366 = ((0.5f * _e360) / _e355);
                    let _e369 = ((_e366 * _e366) - (((1f - (_e360 * _e330)) - (_e355 * _e333)) / _e355));
                    if (_e369 >= 0f) {
                        let _e371 = sqrt(_e369);
                        phi_726_ = vec2<f32>((-(_e366) - _e371), (-(_e366) + _e371));
                    } else {
                        phi_726_ = vec2(bitcast<f32>((bitcast<u32>(_e369) | 2143289344u)));
                    }
                    let _e382 = phi_726_;
                    if (_e81 <= _e382.x) {
                        phi_807_ = 1f;
                    } else {
                        if (_e81 > _e382.y) {
                            let _e388 = local_1.moments;
                            let _e399 = (((_e388.y - (_e388.x * (_e382.x + _e382.y))) + (_e382.x * _e382.y)) / ((_e81 - _e382.x) * (_e81 - _e382.y)));
                            if ((bitcast<u32>(_e399) & 2147483647u) > 2139095040u) {
                                phi_766_ = _e399;
                            } else {
                                if (_e399 < 0f) {
                                    phi_765_ = 0f;
                                } else {
                                    if (_e399 > 1f) {
                                        phi_764_ = 1f;
                                    } else {
                                        phi_764_ = _e399;
                                    }
                                    let _e406 = phi_764_;
                                    phi_765_ = _e406;
                                }
                                let _e408 = phi_765_;
                                phi_766_ = _e408;
                            }
                            let _e410 = phi_766_;
                            phi_806_ = _e410;
                        } else {
                            if (_e81 > _e382.x) {
                                let _e413 = local_1.moments;
                                let _e425 = (1f - (((_e413.y - (_e413.x * (_e81 + _e382.y))) + (_e81 * _e382.y)) / ((_e382.x - _e81) * (_e382.x - _e382.y))));
                                if ((bitcast<u32>(_e425) & 2147483647u) > 2139095040u) {
                                    phi_801_ = _e425;
                                } else {
                                    if (_e425 < 0f) {
                                        phi_800_ = 0f;
                                    } else {
                                        if (_e425 > 1f) {
                                            phi_799_ = 1f;
                                        } else {
                                            phi_799_ = _e425;
                                        }
                                        let _e432 = phi_799_;
                                        phi_800_ = _e432;
                                    }
                                    let _e434 = phi_800_;
                                    phi_801_ = _e434;
                                }
                                let _e436 = phi_801_;
                                phi_805_ = _e436;
                            } else {
                                phi_805_ = bitcast<f32>((bitcast<u32>(_e382.x) | 2143289344u));
                            }
                            let _e441 = phi_805_;
                            phi_806_ = _e441;
                        }
                        let _e443 = phi_806_;
                        phi_807_ = _e443;
                    }
                    let _e445 = phi_807_;
                    phi_808_ = _e445;
                } else {
                    phi_808_ = _e325;
                }
                let _e447 = phi_808_;
                phi_809_ = _e447;
                phi_810_ = false;
            } else {
                phi_809_ = f32();
                phi_810_ = true;
            }
            let _e449 = phi_809_;
            let _e451 = phi_810_;
            phi_811_ = _e449;
            phi_812_ = _e451;
        } else {
            phi_811_ = f32();
            phi_812_ = true;
        }
        let _e453 = phi_811_;
        let _e455 = phi_812_;
        if _e455 {
            if ((bitcast<u32>(_e293.x) & 2147483647u) > 2139095040u) {
                phi_823_ = _e293.x;
            } else {
                let _e459 = lt_math_hausdorff_endpoint_upper_bound((&local_1), _e81);
                phi_823_ = _e459;
            }
            let _e461 = phi_823_;
            phi_824_ = _e461;
        } else {
            phi_824_ = _e453;
        }
        let _e463 = phi_824_;
        phi_825_ = _e463;
    }
    let _e465 = phi_825_;
    return _e465;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_20: ptr<function, f32>, param_21: vec4<f32>, param_22: vec4<f32>, param_23: f32) -> f32 {
    let _e41 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_21.x);
    let _e43 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_21.y);
    let _e45 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_21.z);
    let _e47 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_21.w);
    let _e97 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_20, vec4<f32>(((((_e41.x * param_22.x) + (_e43.x * param_22.y)) + (_e45.x * param_22.z)) + (_e47.x * param_22.w)), ((((_e41.y * param_22.x) + (_e43.y * param_22.y)) + (_e45.y * param_22.z)) + (_e47.y * param_22.w)), ((((_e41.z * param_22.x) + (_e43.z * param_22.y)) + (_e45.z * param_22.z)) + (_e47.z * param_22.w)), ((((_e41.w * param_22.x) + (_e43.w * param_22.y)) + (_e45.w * param_22.z)) + (_e47.w * param_22.w))), param_23);
    return _e97;
}

fn function_() {
    var local_2: f32;
    var phi_1045_: bool;
    var phi_1046_: bool;
    var phi_1047_: bool;
    var phi_1048_: bool;
    var phi_1052_: bool;
    var phi_1087_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1091_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1184_: bool;
    var phi_1185_: bool;
    var phi_1186_: bool;
    var phi_1187_: bool;
    var phi_1188_: bool;
    var phi_1189_: bool;
    var phi_1190_: bool;
    var phi_1191_: bool;
    var phi_1192_: bool;
    var phi_1193_: bool;
    var phi_1194_: bool;
    var phi_1195_: bool;
    var phi_1199_: bool;
    var phi_1300_: bool;
    var phi_1308_: bool;
    var phi_1313_: f32;
    var phi_1316_: evaluate_Verdict;
    var phi_1317_: evaluate_Verdict;
    var phi_1321_: bool;
    var phi_1322_: u32;
    var phi_1328_: u32;

    let _e37 = id_1;
    let _e38 = local_3;
    let _e43 = arrayLength((&map.member));
    if (_e38 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    let _e50 = p.member.size[0u];
    let _e52 = p.member.size[1u];
    let _e53 = lt_shaders_entry_pixel_index(_e37, _e50, _e52);
    if (bitcast<i32>(_e53.root) != 0i) {
        let _e60 = p.member.light;
        let _e63 = samples.member[_e53.first_primitive].normal[0u];
        let _e65 = global[0u];
        if (_e63 == _e65) {
            let _e68 = samples.member[_e53.first_primitive].normal[1u];
            let _e70 = global[1u];
            if (_e68 == _e70) {
                let _e73 = samples.member[_e53.first_primitive].normal[2u];
                let _e75 = global[2u];
                phi_1045_ = (_e73 == _e75);
                phi_1046_ = false;
            } else {
                phi_1045_ = bool();
                phi_1046_ = true;
            }
            let _e78 = phi_1045_;
            let _e80 = phi_1046_;
            phi_1047_ = _e78;
            phi_1048_ = _e80;
        } else {
            phi_1047_ = bool();
            phi_1048_ = true;
        }
        let _e82 = phi_1047_;
        let _e84 = phi_1048_;
        if _e84 {
            phi_1052_ = false;
        } else {
            phi_1052_ = _e82;
        }
        let _e86 = phi_1052_;
        if !(_e86) {
            let _e89 = samples.member[_e53.first_primitive].normal;
            let _e91 = samples.member[_e53.first_primitive].position;
            let _e92 = lt_shaders_evaluate_to_light(_e91, _e60);
            if ((((_e89.x * _e92.x) + (_e89.y * _e92.y)) + (_e89.z * _e92.z)) > 0f) {
                let _e106 = samples.member[_e53.first_primitive].flags;
                let _e114 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e120 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e114.unnamed.visibility, false), _e114.unnamed_1);
                phi_1087_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e120.unnamed, ((_e106 & 1u) == 0u));
            } else {
                let _e129 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e135 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e129.unnamed.visibility, false), _e129.unnamed_1);
                phi_1087_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e135.unnamed, true);
            }
            let _e140 = phi_1087_;
            phi_1091_ = _e140;
        } else {
            let _e146 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e152 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e146.unnamed.visibility, false), _e146.unnamed_1);
            phi_1091_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e152.unnamed, true);
        }
        let _e157 = phi_1091_;
        if _e157.unnamed_1 {
            phi_1317_ = evaluate_Verdict(_e157.unnamed.visibility, _e157.unnamed.is_doubted);
        } else {
            let _e165 = samples.member[_e53.first_primitive].position;
            let _e171 = p.member.projection.row_w;
            let _e182 = ((((_e171.x * _e165.x) + (_e171.y * _e165.y)) + (_e171.z * _e165.z)) + (_e171.w * 1f));
            let _e184 = p.member.projection.row_x;
            let _e196 = (((((_e184.x * _e165.x) + (_e184.y * _e165.y)) + (_e184.z * _e165.z)) + (_e184.w * 1f)) / _e182);
            let _e198 = p.member.projection.row_y;
            let _e210 = (((((_e198.x * _e165.x) + (_e198.y * _e165.y)) + (_e198.z * _e165.z)) + (_e198.w * 1f)) / _e182);
            let _e212 = p.member.projection.row_z;
            let _e223 = ((((_e212.x * _e165.x) + (_e212.y * _e165.y)) + (_e212.z * _e165.z)) + (_e212.w * 1f));
            if (_e182 > 0f) {
                if (_e196 >= 0f) {
                    if (_e196 <= 1f) {
                        if (_e210 >= 0f) {
                            if (_e210 <= 1f) {
                                if (_e223 >= 0f) {
                                    phi_1184_ = (_e223 <= 1f);
                                    phi_1185_ = false;
                                } else {
                                    phi_1184_ = bool();
                                    phi_1185_ = true;
                                }
                                let _e232 = phi_1184_;
                                let _e234 = phi_1185_;
                                phi_1186_ = _e232;
                                phi_1187_ = _e234;
                            } else {
                                phi_1186_ = bool();
                                phi_1187_ = true;
                            }
                            let _e236 = phi_1186_;
                            let _e238 = phi_1187_;
                            phi_1188_ = _e236;
                            phi_1189_ = _e238;
                        } else {
                            phi_1188_ = bool();
                            phi_1189_ = true;
                        }
                        let _e240 = phi_1188_;
                        let _e242 = phi_1189_;
                        phi_1190_ = _e240;
                        phi_1191_ = _e242;
                    } else {
                        phi_1190_ = bool();
                        phi_1191_ = true;
                    }
                    let _e244 = phi_1190_;
                    let _e246 = phi_1191_;
                    phi_1192_ = _e244;
                    phi_1193_ = _e246;
                } else {
                    phi_1192_ = bool();
                    phi_1193_ = true;
                }
                let _e248 = phi_1192_;
                let _e250 = phi_1193_;
                phi_1194_ = _e248;
                phi_1195_ = _e250;
            } else {
                phi_1194_ = bool();
                phi_1195_ = true;
            }
            let _e252 = phi_1194_;
            let _e254 = phi_1195_;
            if _e254 {
                phi_1199_ = false;
            } else {
                phi_1199_ = _e252;
            }
            let _e256 = phi_1199_;
            if _e256 {
                let _e258 = p.member.map_size;
                let _e259 = f32(_e258);
                let _e262 = ((_e196 * _e259) - 0.5f);
                let _e263 = ((_e210 * _e259) - 0.5f);
                let _e264 = floor(_e262);
                let _e265 = floor(_e263);
                let _e266 = (_e262 - _e264);
                let _e267 = (_e263 - _e265);
                let _e296 = p.member.test;
                let _e297 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e296);
                let _e299 = p.member.map_size;
                local_2 = _e297;
                let _e300 = lt_shaders_evaluate_quad_indices(select(0i, select(select(i32(_e264), i32(-2147483648), (_e264 < bitcast<f32>(3472883712u))), 2147483647i, (_e264 > bitcast<f32>(1325400063u))), (_e264 == _e264)), select(0i, select(select(i32(_e265), i32(-2147483648), (_e265 < bitcast<f32>(3472883712u))), 2147483647i, (_e265 > bitcast<f32>(1325400063u))), (_e265 == _e265)), _e299);
                if (_e300[0] < _e43) {
                } else {
                    return;
                }
                let _e305 = map.member[(0u + _e300[0])];
                if (_e300[1] < _e43) {
                } else {
                    return;
                }
                let _e310 = map.member[(0u + _e300[1])];
                if (_e300[2] < _e43) {
                } else {
                    return;
                }
                let _e315 = map.member[(0u + _e300[2])];
                if (_e300[3] < _e43) {
                } else {
                    return;
                }
                let _e320 = map.member[(0u + _e300[3])];
                let _e322 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local_2), vec4<f32>(_e305, _e310, _e315, _e320), vec4<f32>(((1f - _e266) * (1f - _e267)), (_e266 * (1f - _e267)), ((1f - _e266) * _e267), (_e266 * _e267)), _e223);
                let _e324 = p.member.epsilon;
                if (_e322 <= _e324) {
                    phi_1300_ = true;
                } else {
                    phi_1300_ = (_e322 >= (1f - _e324));
                }
                let _e329 = phi_1300_;
                if ((bitcast<u32>(_e322) & 2147483647u) > 2139095040u) {
                    phi_1308_ = true;
                } else {
                    phi_1308_ = !(_e329);
                }
                let _e335 = phi_1308_;
                if (_e322 > 0.5f) {
                    phi_1313_ = 1f;
                } else {
                    phi_1313_ = 0f;
                }
                let _e338 = phi_1313_;
                phi_1316_ = evaluate_Verdict(_e338, _e335);
            } else {
                phi_1316_ = evaluate_Verdict(1f, true);
            }
            let _e342 = phi_1316_;
            phi_1317_ = _e342;
        }
        let _e344 = phi_1317_;
        visibility.member[_e53.first_primitive] = _e344.visibility;
        phi_1321_ = _e344.is_doubted;
        phi_1322_ = _e53.first_primitive;
    } else {
        phi_1321_ = false;
        phi_1322_ = 0u;
    }
    let _e349 = phi_1321_;
    let _e351 = phi_1322_;
    if _e349 {
        let _e353 = atomicAdd((&shared_[0u]), 1u);
        phi_1328_ = _e353;
    } else {
        phi_1328_ = 0u;
    }
    let _e355 = phi_1328_;
    workgroupBarrier();
    if (_e38 == 0u) {
        let _e359 = atomicLoad((&shared_[0u]));
        let _e360 = atomicAdd((&list.member[3u]), _e359);
        atomicStore((&shared_[1u]), _e360);
    }
    workgroupBarrier();
    if _e349 {
        let _e363 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e363) + _e355)]), _e351);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_msm_hausdorff_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_3 = local;
    function_();
}
