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

struct type_26 {
    member: array<abi_Sample>,
}

struct type_30 {
    member: array<f32>,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
}

struct type_40 {
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

struct type_43 {
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

struct type_51 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_26;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_43;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_30;
var<private> local_3: u32;
@group(0) @binding(4) 
var<storage, read_write> list: type_51;
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(2) 
var<storage> map: type_40;

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

fn lt_shaders_evaluate_to_light(param_4: vec3<f32>, param_5: vec4<f32>) -> vec3<f32> {
    return vec3<f32>((param_5.x - (param_4.x * param_5.w)), (param_5.y - (param_4.y * param_5.w)), (param_5.z - (param_4.z * param_5.w)));
}

fn lt_shaders_evaluate_quad_indices(param_6: i32, param_7: i32, param_8: u32) -> array<u32, 4> {
    var phi_202_: i32;
    var phi_207_: i32;
    var phi_212_: i32;
    var phi_217_: i32;
    var phi_226_: i32;
    var phi_231_: i32;
    var phi_236_: i32;
    var phi_241_: i32;

    let _e40 = (bitcast<i32>(param_8) - 1i);
    if (param_6 > 0i) {
        phi_202_ = param_6;
    } else {
        phi_202_ = 0i;
    }
    let _e43 = phi_202_;
    if (param_7 > 0i) {
        phi_207_ = param_7;
    } else {
        phi_207_ = 0i;
    }
    let _e46 = phi_207_;
    if (_e43 < _e40) {
        phi_212_ = _e43;
    } else {
        phi_212_ = _e40;
    }
    let _e49 = phi_212_;
    if (_e46 < _e40) {
        phi_217_ = _e46;
    } else {
        phi_217_ = _e40;
    }
    let _e52 = phi_217_;
    let _e53 = bitcast<u32>(_e49);
    let _e55 = (param_6 + 1i);
    let _e56 = (param_7 + 1i);
    if (_e55 > 0i) {
        phi_226_ = _e55;
    } else {
        phi_226_ = 0i;
    }
    let _e59 = phi_226_;
    if (_e56 > 0i) {
        phi_231_ = _e56;
    } else {
        phi_231_ = 0i;
    }
    let _e62 = phi_231_;
    if (_e59 < _e40) {
        phi_236_ = _e59;
    } else {
        phi_236_ = _e40;
    }
    let _e65 = phi_236_;
    if (_e62 < _e40) {
        phi_241_ = _e62;
    } else {
        phi_241_ = _e40;
    }
    let _e68 = phi_241_;
    let _e69 = bitcast<u32>(_e65);
    let _e71 = (bitcast<u32>(_e52) * param_8);
    let _e72 = (bitcast<u32>(_e68) * param_8);
    return array<u32, 4>((_e71 + _e53), (_e71 + _e69), (_e72 + _e53), (_e72 + _e69));
}

fn lt_math_hausdorff_cubic_mass(param_9: vec4<f32>, param_10: f32, param_11: f32, param_12: f32, param_13: f32) -> f32 {
    return ((((param_9.z - (((param_11 + param_12) + param_13) * param_9.y)) + ((((param_11 * param_12) + (param_11 * param_13)) + (param_12 * param_13)) * param_9.x)) - ((param_11 * param_12) * param_13)) / (((param_10 - param_11) * (param_10 - param_12)) * (param_10 - param_13)));
}

fn lt_math_hausdorff_endpoint_upper_bound(param_14: ptr<function, hankel_HankelFactors>, param_15: f32) -> f32 {
    var phi_797_: f32;
    var phi_798_: f32;
    var phi_799_: f32;
    var phi_826_: f32;
    var phi_827_: f32;
    var phi_828_: f32;
    var phi_829_: f32;
    var phi_830_: bool;
    var phi_831_: f32;
    var phi_832_: bool;
    var phi_860_: f32;
    var phi_861_: f32;
    var phi_862_: f32;
    var phi_863_: f32;
    var phi_864_: bool;
    var phi_865_: f32;
    var phi_866_: bool;
    var phi_873_: f32;
    var phi_874_: f32;
    var phi_875_: f32;
    var phi_876_: f32;

    let _e39 = (*param_14).moments;
    if (param_15 <= 0f) {
        phi_876_ = 1f;
    } else {
        let _e48 = ((_e39.z - ((1f + param_15) * _e39.y)) + (param_15 * _e39.x));
        let _e57 = (((_e39.w - ((1f + param_15) * _e39.z)) + (param_15 * _e39.y)) / _e48);
        if (abs(_e48) <= 0.00000047683716f) {
            let _e71 = (1f - (((_e39.y - (_e39.x * (param_15 + 1f))) + (param_15 * 1f)) / ((0f - param_15) * (0f - 1f))));
            if ((bitcast<u32>(_e71) & 2147483647u) > 2139095040u) {
                phi_799_ = _e71;
            } else {
                if (_e71 < 0f) {
                    phi_798_ = 0f;
                } else {
                    if (_e71 > 1f) {
                        phi_797_ = 1f;
                    } else {
                        phi_797_ = _e71;
                    }
                    let _e78 = phi_797_;
                    phi_798_ = _e78;
                }
                let _e80 = phi_798_;
                phi_799_ = _e80;
            }
            let _e82 = phi_799_;
            phi_875_ = _e82;
        } else {
            if (_e57 > 0f) {
                if (_e57 < param_15) {
                    let _e85 = lt_math_hausdorff_cubic_mass(_e39, 0f, _e57, param_15, 1f);
                    let _e87 = lt_math_hausdorff_cubic_mass(_e39, _e57, 0f, param_15, 1f);
                    let _e88 = ((1f - _e85) - _e87);
                    if ((bitcast<u32>(_e88) & 2147483647u) > 2139095040u) {
                        phi_828_ = _e88;
                    } else {
                        if (_e88 < 0f) {
                            phi_827_ = 0f;
                        } else {
                            if (_e88 > 1f) {
                                phi_826_ = 1f;
                            } else {
                                phi_826_ = _e88;
                            }
                            let _e95 = phi_826_;
                            phi_827_ = _e95;
                        }
                        let _e97 = phi_827_;
                        phi_828_ = _e97;
                    }
                    let _e99 = phi_828_;
                    phi_829_ = _e99;
                    phi_830_ = false;
                } else {
                    phi_829_ = f32();
                    phi_830_ = true;
                }
                let _e101 = phi_829_;
                let _e103 = phi_830_;
                phi_831_ = _e101;
                phi_832_ = _e103;
            } else {
                phi_831_ = f32();
                phi_832_ = true;
            }
            let _e105 = phi_831_;
            let _e107 = phi_832_;
            if _e107 {
                if (_e57 > param_15) {
                    if (_e57 < 1f) {
                        let _e110 = lt_math_hausdorff_cubic_mass(_e39, 0f, _e57, param_15, 1f);
                        let _e111 = (1f - _e110);
                        if ((bitcast<u32>(_e111) & 2147483647u) > 2139095040u) {
                            phi_862_ = _e111;
                        } else {
                            if (_e111 < 0f) {
                                phi_861_ = 0f;
                            } else {
                                if (_e111 > 1f) {
                                    phi_860_ = 1f;
                                } else {
                                    phi_860_ = _e111;
                                }
                                let _e118 = phi_860_;
                                phi_861_ = _e118;
                            }
                            let _e120 = phi_861_;
                            phi_862_ = _e120;
                        }
                        let _e122 = phi_862_;
                        phi_863_ = _e122;
                        phi_864_ = false;
                    } else {
                        phi_863_ = f32();
                        phi_864_ = true;
                    }
                    let _e124 = phi_863_;
                    let _e126 = phi_864_;
                    phi_865_ = _e124;
                    phi_866_ = _e126;
                } else {
                    phi_865_ = f32();
                    phi_866_ = true;
                }
                let _e128 = phi_865_;
                let _e130 = phi_866_;
                if _e130 {
                    phi_873_ = bitcast<f32>((bitcast<u32>(_e57) | 2143289344u));
                } else {
                    phi_873_ = _e128;
                }
                let _e135 = phi_873_;
                phi_874_ = _e135;
            } else {
                phi_874_ = _e105;
            }
            let _e137 = phi_874_;
            phi_875_ = _e137;
        }
        let _e139 = phi_875_;
        phi_876_ = _e139;
    }
    let _e141 = phi_876_;
    return _e141;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_16: ptr<function, f32>, param_17: vec4<f32>, param_18: f32) -> f32 {
    var local_1: hankel_HankelFactors;
    var phi_301_: f32;
    var phi_302_: f32;
    var phi_303_: f32;
    var phi_341_: f32;
    var phi_342_: f32;
    var phi_343_: f32;
    var phi_344_: f32;
    var phi_345_: bool;
    var phi_346_: f32;
    var phi_347_: bool;
    var phi_403_: vec2<f32>;
    var phi_441_: f32;
    var phi_442_: f32;
    var phi_443_: f32;
    var phi_476_: f32;
    var phi_477_: f32;
    var phi_478_: f32;
    var phi_482_: f32;
    var phi_483_: f32;
    var phi_484_: f32;
    var phi_485_: f32;
    var phi_538_: vec2<f32>;
    var phi_578_: f32;
    var phi_579_: f32;
    var phi_580_: f32;
    var phi_581_: f32;
    var phi_582_: bool;
    var phi_583_: f32;
    var phi_584_: bool;
    var phi_640_: vec2<f32>;
    var phi_678_: f32;
    var phi_679_: f32;
    var phi_680_: f32;
    var phi_713_: f32;
    var phi_714_: f32;
    var phi_715_: f32;
    var phi_719_: f32;
    var phi_720_: f32;
    var phi_721_: f32;
    var phi_722_: f32;
    var phi_723_: f32;
    var phi_724_: bool;
    var phi_725_: f32;
    var phi_726_: bool;
    var phi_737_: f32;
    var phi_738_: f32;
    var phi_739_: f32;

    let _e40 = (*param_16);
    let _e41 = (1f - _e40);
    let _e50 = (0.5f * _e40);
    let _e51 = ((param_17.x * _e41) + _e50);
    let _e52 = ((param_17.y * _e41) + _e50);
    let _e53 = ((param_17.z * _e41) + _e50);
    let _e54 = ((param_17.w * _e41) + _e50);
    let _e57 = (_e52 - (_e51 * _e51));
    let _e59 = (_e53 - (_e51 * _e52));
    let _e65 = hankel_HankelFactors(vec4<f32>(_e51, _e52, _e53, _e54), _e57, _e59, (((_e54 - (_e52 * _e52)) * _e57) - (_e59 * _e59)));
    local_1 = hankel_HankelFactors(_e65.moments, _e65.d22_, _e65.l32_d22_, _e65.d33_d22_);
    if ((bitcast<u32>(param_18) & 2147483647u) > 2139095040u) {
        phi_303_ = param_18;
    } else {
        if (param_18 < 0f) {
            phi_302_ = 0f;
        } else {
            if (param_18 > 1f) {
                phi_301_ = 1f;
            } else {
                phi_301_ = param_18;
            }
            let _e77 = phi_301_;
            phi_302_ = _e77;
        }
        let _e79 = phi_302_;
        phi_303_ = _e79;
    }
    let _e81 = phi_303_;
    let _e84 = local_1.moments[0u];
    let _e87 = local_1.moments[3u];
    if (_e84 == _e87) {
        let _e91 = local_1.moments[0u];
        let _e94 = local_1.moments[3u];
        if (_e91 == _e94) {
            if (_e81 > 0f) {
                let _e98 = local_1.moments;
                if ((bitcast<u32>(_e98.x) & 2147483647u) > 2139095040u) {
                    phi_343_ = _e98.x;
                } else {
                    if (_e98.x < 0f) {
                        phi_342_ = 0f;
                    } else {
                        if (_e98.x > 1f) {
                            phi_341_ = 1f;
                        } else {
                            phi_341_ = _e98.x;
                        }
                        let _e106 = phi_341_;
                        phi_342_ = _e106;
                    }
                    let _e108 = phi_342_;
                    phi_343_ = _e108;
                }
                let _e110 = phi_343_;
                phi_344_ = _e110;
                phi_345_ = false;
            } else {
                phi_344_ = f32();
                phi_345_ = true;
            }
            let _e112 = phi_344_;
            let _e114 = phi_345_;
            phi_346_ = _e112;
            phi_347_ = _e114;
        } else {
            phi_346_ = f32();
            phi_347_ = true;
        }
        let _e116 = phi_346_;
        let _e118 = phi_347_;
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
                phi_403_ = vec2<f32>((-(_e157) - _e162), (-(_e157) + _e162));
            } else {
                phi_403_ = vec2(bitcast<f32>((bitcast<u32>(_e160) | 2143289344u)));
            }
            let _e173 = phi_403_;
            if (_e81 <= _e173.x) {
                phi_484_ = 1f;
            } else {
                if (_e81 > _e173.y) {
                    let _e179 = local_1.moments;
                    let _e190 = (((_e179.y - (_e179.x * (_e173.x + _e173.y))) + (_e173.x * _e173.y)) / ((_e81 - _e173.x) * (_e81 - _e173.y)));
                    if ((bitcast<u32>(_e190) & 2147483647u) > 2139095040u) {
                        phi_443_ = _e190;
                    } else {
                        if (_e190 < 0f) {
                            phi_442_ = 0f;
                        } else {
                            if (_e190 > 1f) {
                                phi_441_ = 1f;
                            } else {
                                phi_441_ = _e190;
                            }
                            let _e197 = phi_441_;
                            phi_442_ = _e197;
                        }
                        let _e199 = phi_442_;
                        phi_443_ = _e199;
                    }
                    let _e201 = phi_443_;
                    phi_483_ = _e201;
                } else {
                    if (_e81 > _e173.x) {
                        let _e204 = local_1.moments;
                        let _e216 = (1f - (((_e204.y - (_e204.x * (_e81 + _e173.y))) + (_e81 * _e173.y)) / ((_e173.x - _e81) * (_e173.x - _e173.y))));
                        if ((bitcast<u32>(_e216) & 2147483647u) > 2139095040u) {
                            phi_478_ = _e216;
                        } else {
                            if (_e216 < 0f) {
                                phi_477_ = 0f;
                            } else {
                                if (_e216 > 1f) {
                                    phi_476_ = 1f;
                                } else {
                                    phi_476_ = _e216;
                                }
                                let _e223 = phi_476_;
                                phi_477_ = _e223;
                            }
                            let _e225 = phi_477_;
                            phi_478_ = _e225;
                        }
                        let _e227 = phi_478_;
                        phi_482_ = _e227;
                    } else {
                        phi_482_ = bitcast<f32>((bitcast<u32>(_e173.x) | 2143289344u));
                    }
                    let _e232 = phi_482_;
                    phi_483_ = _e232;
                }
                let _e234 = phi_483_;
                phi_484_ = _e234;
            }
            let _e236 = phi_484_;
            phi_485_ = _e236;
        } else {
            phi_485_ = _e116;
        }
        let _e238 = phi_485_;
        phi_739_ = _e238;
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
            phi_538_ = vec2<f32>((-(_e277) - _e282), (-(_e277) + _e282));
        } else {
            phi_538_ = vec2(bitcast<f32>((bitcast<u32>(_e280) | 2143289344u)));
        }
        let _e293 = phi_538_;
        if (_e293.x >= 0f) {
            if (_e293.y <= 1f) {
                let _e300 = local_1.moments[0u];
                let _e303 = local_1.moments[3u];
                if (_e300 == _e303) {
                    if (_e81 > 0f) {
                        let _e307 = local_1.moments;
                        if ((bitcast<u32>(_e307.x) & 2147483647u) > 2139095040u) {
                            phi_580_ = _e307.x;
                        } else {
                            if (_e307.x < 0f) {
                                phi_579_ = 0f;
                            } else {
                                if (_e307.x > 1f) {
                                    phi_578_ = 1f;
                                } else {
                                    phi_578_ = _e307.x;
                                }
                                let _e315 = phi_578_;
                                phi_579_ = _e315;
                            }
                            let _e317 = phi_579_;
                            phi_580_ = _e317;
                        }
                        let _e319 = phi_580_;
                        phi_581_ = _e319;
                        phi_582_ = false;
                    } else {
                        phi_581_ = f32();
                        phi_582_ = true;
                    }
                    let _e321 = phi_581_;
                    let _e323 = phi_582_;
                    phi_583_ = _e321;
                    phi_584_ = _e323;
                } else {
                    phi_583_ = f32();
                    phi_584_ = true;
                }
                let _e325 = phi_583_;
                let _e327 = phi_584_;
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
                        phi_640_ = vec2<f32>((-(_e366) - _e371), (-(_e366) + _e371));
                    } else {
                        phi_640_ = vec2(bitcast<f32>((bitcast<u32>(_e369) | 2143289344u)));
                    }
                    let _e382 = phi_640_;
                    if (_e81 <= _e382.x) {
                        phi_721_ = 1f;
                    } else {
                        if (_e81 > _e382.y) {
                            let _e388 = local_1.moments;
                            let _e399 = (((_e388.y - (_e388.x * (_e382.x + _e382.y))) + (_e382.x * _e382.y)) / ((_e81 - _e382.x) * (_e81 - _e382.y)));
                            if ((bitcast<u32>(_e399) & 2147483647u) > 2139095040u) {
                                phi_680_ = _e399;
                            } else {
                                if (_e399 < 0f) {
                                    phi_679_ = 0f;
                                } else {
                                    if (_e399 > 1f) {
                                        phi_678_ = 1f;
                                    } else {
                                        phi_678_ = _e399;
                                    }
                                    let _e406 = phi_678_;
                                    phi_679_ = _e406;
                                }
                                let _e408 = phi_679_;
                                phi_680_ = _e408;
                            }
                            let _e410 = phi_680_;
                            phi_720_ = _e410;
                        } else {
                            if (_e81 > _e382.x) {
                                let _e413 = local_1.moments;
                                let _e425 = (1f - (((_e413.y - (_e413.x * (_e81 + _e382.y))) + (_e81 * _e382.y)) / ((_e382.x - _e81) * (_e382.x - _e382.y))));
                                if ((bitcast<u32>(_e425) & 2147483647u) > 2139095040u) {
                                    phi_715_ = _e425;
                                } else {
                                    if (_e425 < 0f) {
                                        phi_714_ = 0f;
                                    } else {
                                        if (_e425 > 1f) {
                                            phi_713_ = 1f;
                                        } else {
                                            phi_713_ = _e425;
                                        }
                                        let _e432 = phi_713_;
                                        phi_714_ = _e432;
                                    }
                                    let _e434 = phi_714_;
                                    phi_715_ = _e434;
                                }
                                let _e436 = phi_715_;
                                phi_719_ = _e436;
                            } else {
                                phi_719_ = bitcast<f32>((bitcast<u32>(_e382.x) | 2143289344u));
                            }
                            let _e441 = phi_719_;
                            phi_720_ = _e441;
                        }
                        let _e443 = phi_720_;
                        phi_721_ = _e443;
                    }
                    let _e445 = phi_721_;
                    phi_722_ = _e445;
                } else {
                    phi_722_ = _e325;
                }
                let _e447 = phi_722_;
                phi_723_ = _e447;
                phi_724_ = false;
            } else {
                phi_723_ = f32();
                phi_724_ = true;
            }
            let _e449 = phi_723_;
            let _e451 = phi_724_;
            phi_725_ = _e449;
            phi_726_ = _e451;
        } else {
            phi_725_ = f32();
            phi_726_ = true;
        }
        let _e453 = phi_725_;
        let _e455 = phi_726_;
        if _e455 {
            if ((bitcast<u32>(_e293.x) & 2147483647u) > 2139095040u) {
                phi_737_ = _e293.x;
            } else {
                let _e459 = lt_math_hausdorff_endpoint_upper_bound((&local_1), _e81);
                phi_737_ = _e459;
            }
            let _e461 = phi_737_;
            phi_738_ = _e461;
        } else {
            phi_738_ = _e453;
        }
        let _e463 = phi_738_;
        phi_739_ = _e463;
    }
    let _e465 = phi_739_;
    return _e465;
}

fn function_() {
    var local_2: f32;
    var phi_959_: bool;
    var phi_960_: bool;
    var phi_961_: bool;
    var phi_962_: bool;
    var phi_966_: bool;
    var phi_1001_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1005_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1098_: bool;
    var phi_1099_: bool;
    var phi_1100_: bool;
    var phi_1101_: bool;
    var phi_1102_: bool;
    var phi_1103_: bool;
    var phi_1104_: bool;
    var phi_1105_: bool;
    var phi_1106_: bool;
    var phi_1107_: bool;
    var phi_1108_: bool;
    var phi_1109_: bool;
    var phi_1113_: bool;
    var phi_1258_: bool;
    var phi_1266_: bool;
    var phi_1271_: f32;
    var phi_1274_: evaluate_Verdict;
    var phi_1275_: evaluate_Verdict;
    var phi_1279_: bool;
    var phi_1280_: u32;
    var phi_1286_: u32;

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
                phi_959_ = (_e73 == _e75);
                phi_960_ = false;
            } else {
                phi_959_ = bool();
                phi_960_ = true;
            }
            let _e78 = phi_959_;
            let _e80 = phi_960_;
            phi_961_ = _e78;
            phi_962_ = _e80;
        } else {
            phi_961_ = bool();
            phi_962_ = true;
        }
        let _e82 = phi_961_;
        let _e84 = phi_962_;
        if _e84 {
            phi_966_ = false;
        } else {
            phi_966_ = _e82;
        }
        let _e86 = phi_966_;
        if !(_e86) {
            let _e89 = samples.member[_e53.first_primitive].normal;
            let _e91 = samples.member[_e53.first_primitive].position;
            let _e92 = lt_shaders_evaluate_to_light(_e91, _e60);
            if ((((_e89.x * _e92.x) + (_e89.y * _e92.y)) + (_e89.z * _e92.z)) > 0f) {
                let _e106 = samples.member[_e53.first_primitive].flags;
                let _e114 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e120 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e114.unnamed.visibility, false), _e114.unnamed_1);
                phi_1001_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e120.unnamed, ((_e106 & 1u) == 0u));
            } else {
                let _e129 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e135 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e129.unnamed.visibility, false), _e129.unnamed_1);
                phi_1001_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e135.unnamed, true);
            }
            let _e140 = phi_1001_;
            phi_1005_ = _e140;
        } else {
            let _e146 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e152 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e146.unnamed.visibility, false), _e146.unnamed_1);
            phi_1005_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e152.unnamed, true);
        }
        let _e157 = phi_1005_;
        if _e157.unnamed_1 {
            phi_1275_ = evaluate_Verdict(_e157.unnamed.visibility, _e157.unnamed.is_doubted);
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
                                    phi_1098_ = (_e223 <= 1f);
                                    phi_1099_ = false;
                                } else {
                                    phi_1098_ = bool();
                                    phi_1099_ = true;
                                }
                                let _e232 = phi_1098_;
                                let _e234 = phi_1099_;
                                phi_1100_ = _e232;
                                phi_1101_ = _e234;
                            } else {
                                phi_1100_ = bool();
                                phi_1101_ = true;
                            }
                            let _e236 = phi_1100_;
                            let _e238 = phi_1101_;
                            phi_1102_ = _e236;
                            phi_1103_ = _e238;
                        } else {
                            phi_1102_ = bool();
                            phi_1103_ = true;
                        }
                        let _e240 = phi_1102_;
                        let _e242 = phi_1103_;
                        phi_1104_ = _e240;
                        phi_1105_ = _e242;
                    } else {
                        phi_1104_ = bool();
                        phi_1105_ = true;
                    }
                    let _e244 = phi_1104_;
                    let _e246 = phi_1105_;
                    phi_1106_ = _e244;
                    phi_1107_ = _e246;
                } else {
                    phi_1106_ = bool();
                    phi_1107_ = true;
                }
                let _e248 = phi_1106_;
                let _e250 = phi_1107_;
                phi_1108_ = _e248;
                phi_1109_ = _e250;
            } else {
                phi_1108_ = bool();
                phi_1109_ = true;
            }
            let _e252 = phi_1108_;
            let _e254 = phi_1109_;
            if _e254 {
                phi_1113_ = false;
            } else {
                phi_1113_ = _e252;
            }
            let _e256 = phi_1113_;
            if _e256 {
                let _e258 = p.member.map_size;
                let _e259 = f32(_e258);
                let _e262 = ((_e196 * _e259) - 0.5f);
                let _e263 = ((_e210 * _e259) - 0.5f);
                let _e264 = floor(_e262);
                let _e265 = floor(_e263);
                let _e266 = (_e262 - _e264);
                let _e267 = (_e263 - _e265);
                let _e288 = ((1f - _e266) * (1f - _e267));
                let _e290 = (_e266 * (1f - _e267));
                let _e292 = ((1f - _e266) * _e267);
                let _e293 = (_e266 * _e267);
                let _e295 = p.member.test;
                let _e296 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e295);
                let _e298 = p.member.map_size;
                local_2 = _e296;
                let _e299 = lt_shaders_evaluate_quad_indices(select(0i, select(select(i32(_e264), i32(-2147483648), (_e264 < bitcast<f32>(3472883712u))), 2147483647i, (_e264 > bitcast<f32>(1325400063u))), (_e264 == _e264)), select(0i, select(select(i32(_e265), i32(-2147483648), (_e265 < bitcast<f32>(3472883712u))), 2147483647i, (_e265 > bitcast<f32>(1325400063u))), (_e265 == _e265)), _e298);
                if (_e299[0] < _e43) {
                } else {
                    return;
                }
                let _e304 = map.member[(0u + _e299[0])];
                if (_e299[1] < _e43) {
                } else {
                    return;
                }
                let _e317 = map.member[(0u + _e299[1])];
                if (_e299[2] < _e43) {
                } else {
                    return;
                }
                let _e334 = map.member[(0u + _e299[2])];
                if (_e299[3] < _e43) {
                } else {
                    return;
                }
                let _e351 = map.member[(0u + _e299[3])];
                let _e365 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_2), vec4<f32>(((((_e304.x * _e288) + (_e317.x * _e290)) + (_e334.x * _e292)) + (_e351.x * _e293)), ((((_e304.y * _e288) + (_e317.y * _e290)) + (_e334.y * _e292)) + (_e351.y * _e293)), ((((_e304.z * _e288) + (_e317.z * _e290)) + (_e334.z * _e292)) + (_e351.z * _e293)), ((((_e304.w * _e288) + (_e317.w * _e290)) + (_e334.w * _e292)) + (_e351.w * _e293))), _e223);
                let _e367 = p.member.epsilon;
                if (_e365 <= _e367) {
                    phi_1258_ = true;
                } else {
                    phi_1258_ = (_e365 >= (1f - _e367));
                }
                let _e372 = phi_1258_;
                if ((bitcast<u32>(_e365) & 2147483647u) > 2139095040u) {
                    phi_1266_ = true;
                } else {
                    phi_1266_ = !(_e372);
                }
                let _e378 = phi_1266_;
                if (_e365 > 0.5f) {
                    phi_1271_ = 1f;
                } else {
                    phi_1271_ = 0f;
                }
                let _e381 = phi_1271_;
                phi_1274_ = evaluate_Verdict(_e381, _e378);
            } else {
                phi_1274_ = evaluate_Verdict(1f, true);
            }
            let _e385 = phi_1274_;
            phi_1275_ = _e385;
        }
        let _e387 = phi_1275_;
        visibility.member[_e53.first_primitive] = _e387.visibility;
        phi_1279_ = _e387.is_doubted;
        phi_1280_ = _e53.first_primitive;
    } else {
        phi_1279_ = false;
        phi_1280_ = 0u;
    }
    let _e392 = phi_1279_;
    let _e394 = phi_1280_;
    if _e392 {
        let _e396 = atomicAdd((&shared_[0u]), 1u);
        phi_1286_ = _e396;
    } else {
        phi_1286_ = 0u;
    }
    let _e398 = phi_1286_;
    workgroupBarrier();
    if (_e38 == 0u) {
        let _e402 = atomicLoad((&shared_[0u]));
        let _e403 = atomicAdd((&list.member[3u]), _e402);
        atomicStore((&shared_[1u]), _e403);
    }
    workgroupBarrier();
    if _e392 {
        let _e406 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e406) + _e398)]), _e394);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_msm_hausdorff_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_3 = local;
    function_();
}
