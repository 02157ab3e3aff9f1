struct lt_math_LightProjection {
    row_x: vec4<f32>,
    row_y: vec4<f32>,
    row_z: vec4<f32>,
    row_w: vec4<f32>,
}

struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_18 {
    member: array<abi_Sample>,
}

struct type_22 {
    member: array<f32>,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
}

struct type_30 {
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

struct type_34 {
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

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_18;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_34;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_22;
@group(0) @binding(2) 
var<storage> map: type_30;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_141_: lt_bvh_traverse_Tree;
    var phi_142_: bool;
    var phi_143_: lt_bvh_traverse_Tree;
    var phi_144_: bool;
    var phi_149_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_141_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_142_ = false;
        } else {
            phi_141_ = lt_bvh_traverse_Tree();
            phi_142_ = true;
        }
        let _e48 = phi_141_;
        let _e50 = phi_142_;
        phi_143_ = _e48;
        phi_144_ = _e50;
    } else {
        phi_143_ = lt_bvh_traverse_Tree();
        phi_144_ = true;
    }
    let _e52 = phi_143_;
    let _e54 = phi_144_;
    if _e54 {
        phi_149_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_149_ = _e52;
    }
    let _e59 = phi_149_;
    return lt_bvh_traverse_Tree(_e59.root, _e59.first_primitive);
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn lt_math_hausdorff_cubic_mass(param_4: vec4<f32>, param_5: f32, param_6: f32, param_7: f32, param_8: f32) -> f32 {
    return ((((param_4.z - (((param_6 + param_7) + param_8) * param_4.y)) + ((((param_6 * param_7) + (param_6 * param_8)) + (param_7 * param_8)) * param_4.x)) - ((param_6 * param_7) * param_8)) / (((param_5 - param_6) * (param_5 - param_7)) * (param_5 - param_8)));
}

fn lt_math_hausdorff_endpoint_upper_bound(param_9: ptr<function, hankel_HankelFactors>, param_10: f32) -> f32 {
    var phi_1399_: f32;
    var phi_1400_: f32;
    var phi_1401_: f32;
    var phi_1428_: f32;
    var phi_1429_: f32;
    var phi_1430_: f32;
    var phi_1431_: f32;
    var phi_1432_: bool;
    var phi_1433_: f32;
    var phi_1434_: bool;
    var phi_1462_: f32;
    var phi_1463_: f32;
    var phi_1464_: f32;
    var phi_1465_: f32;
    var phi_1466_: bool;
    var phi_1467_: f32;
    var phi_1468_: bool;
    var phi_1475_: f32;
    var phi_1476_: f32;
    var phi_1477_: f32;
    var phi_1478_: f32;

    let _e38 = (*param_9).moments;
    if (param_10 < 0.0001f) {
        phi_1478_ = 1f;
    } else {
        let _e47 = ((_e38.z - ((1f + param_10) * _e38.y)) + (param_10 * _e38.x));
        let _e56 = (((_e38.w - ((1f + param_10) * _e38.z)) + (param_10 * _e38.y)) / _e47);
        if (abs(_e47) <= 0.00000047683716f) {
            let _e70 = (1f - (((_e38.y - (_e38.x * (param_10 + 1f))) + (param_10 * 1f)) / ((0f - param_10) * (0f - 1f))));
            if ((bitcast<u32>(_e70) & 2147483647u) > 2139095040u) {
                phi_1401_ = _e70;
            } else {
                if (_e70 < 0f) {
                    phi_1400_ = 0f;
                } else {
                    if (_e70 > 1f) {
                        phi_1399_ = 1f;
                    } else {
                        phi_1399_ = _e70;
                    }
                    let _e77 = phi_1399_;
                    phi_1400_ = _e77;
                }
                let _e79 = phi_1400_;
                phi_1401_ = _e79;
            }
            let _e81 = phi_1401_;
            phi_1477_ = _e81;
        } else {
            if (_e56 > 0f) {
                if (_e56 < param_10) {
                    let _e84 = lt_math_hausdorff_cubic_mass(_e38, 0f, _e56, param_10, 1f);
                    let _e86 = lt_math_hausdorff_cubic_mass(_e38, _e56, 0f, param_10, 1f);
                    let _e87 = ((1f - _e84) - _e86);
                    if ((bitcast<u32>(_e87) & 2147483647u) > 2139095040u) {
                        phi_1430_ = _e87;
                    } else {
                        if (_e87 < 0f) {
                            phi_1429_ = 0f;
                        } else {
                            if (_e87 > 1f) {
                                phi_1428_ = 1f;
                            } else {
                                phi_1428_ = _e87;
                            }
                            let _e94 = phi_1428_;
                            phi_1429_ = _e94;
                        }
                        let _e96 = phi_1429_;
                        phi_1430_ = _e96;
                    }
                    let _e98 = phi_1430_;
                    phi_1431_ = _e98;
                    phi_1432_ = false;
                } else {
                    phi_1431_ = f32();
                    phi_1432_ = true;
                }
                let _e100 = phi_1431_;
                let _e102 = phi_1432_;
                phi_1433_ = _e100;
                phi_1434_ = _e102;
            } else {
                phi_1433_ = f32();
                phi_1434_ = true;
            }
            let _e104 = phi_1433_;
            let _e106 = phi_1434_;
            if _e106 {
                if (_e56 > param_10) {
                    if (_e56 < 1f) {
                        let _e109 = lt_math_hausdorff_cubic_mass(_e38, 0f, _e56, param_10, 1f);
                        let _e110 = (1f - _e109);
                        if ((bitcast<u32>(_e110) & 2147483647u) > 2139095040u) {
                            phi_1464_ = _e110;
                        } else {
                            if (_e110 < 0f) {
                                phi_1463_ = 0f;
                            } else {
                                if (_e110 > 1f) {
                                    phi_1462_ = 1f;
                                } else {
                                    phi_1462_ = _e110;
                                }
                                let _e117 = phi_1462_;
                                phi_1463_ = _e117;
                            }
                            let _e119 = phi_1463_;
                            phi_1464_ = _e119;
                        }
                        let _e121 = phi_1464_;
                        phi_1465_ = _e121;
                        phi_1466_ = false;
                    } else {
                        phi_1465_ = f32();
                        phi_1466_ = true;
                    }
                    let _e123 = phi_1465_;
                    let _e125 = phi_1466_;
                    phi_1467_ = _e123;
                    phi_1468_ = _e125;
                } else {
                    phi_1467_ = f32();
                    phi_1468_ = true;
                }
                let _e127 = phi_1467_;
                let _e129 = phi_1468_;
                if _e129 {
                    phi_1475_ = bitcast<f32>((bitcast<u32>(_e56) | 2143289344u));
                } else {
                    phi_1475_ = _e127;
                }
                let _e134 = phi_1475_;
                phi_1476_ = _e134;
            } else {
                phi_1476_ = _e104;
            }
            let _e136 = phi_1476_;
            phi_1477_ = _e136;
        }
        let _e138 = phi_1477_;
        phi_1478_ = _e138;
    }
    let _e140 = phi_1478_;
    return _e140;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_11: ptr<function, f32>, param_12: vec4<f32>, param_13: f32) -> f32 {
    var local: hankel_HankelFactors;
    var phi_686_: f32;
    var phi_687_: f32;
    var phi_688_: f32;
    var phi_700_: bool;
    var phi_715_: bool;
    var phi_740_: f32;
    var phi_741_: f32;
    var phi_742_: f32;
    var phi_743_: f32;
    var phi_744_: bool;
    var phi_745_: f32;
    var phi_746_: bool;
    var phi_802_: vec2<f32>;
    var phi_840_: f32;
    var phi_841_: f32;
    var phi_842_: f32;
    var phi_875_: f32;
    var phi_876_: f32;
    var phi_877_: f32;
    var phi_881_: f32;
    var phi_882_: f32;
    var phi_883_: f32;
    var phi_884_: f32;
    var phi_937_: vec2<f32>;
    var phi_959_: bool;
    var phi_984_: f32;
    var phi_985_: f32;
    var phi_986_: f32;
    var phi_987_: f32;
    var phi_988_: bool;
    var phi_989_: f32;
    var phi_990_: bool;
    var phi_1046_: vec2<f32>;
    var phi_1084_: f32;
    var phi_1085_: f32;
    var phi_1086_: f32;
    var phi_1119_: f32;
    var phi_1120_: f32;
    var phi_1121_: f32;
    var phi_1125_: f32;
    var phi_1126_: f32;
    var phi_1127_: f32;
    var phi_1128_: f32;
    var phi_1129_: f32;
    var phi_1130_: bool;
    var phi_1131_: f32;
    var phi_1132_: bool;
    var phi_1154_: bool;
    var phi_1179_: f32;
    var phi_1180_: f32;
    var phi_1181_: f32;
    var phi_1182_: f32;
    var phi_1183_: bool;
    var phi_1184_: f32;
    var phi_1185_: bool;
    var phi_1241_: vec2<f32>;
    var phi_1279_: f32;
    var phi_1280_: f32;
    var phi_1281_: f32;
    var phi_1314_: f32;
    var phi_1315_: f32;
    var phi_1316_: f32;
    var phi_1320_: f32;
    var phi_1321_: f32;
    var phi_1322_: f32;
    var phi_1323_: f32;
    var phi_1334_: bool;
    var phi_1338_: f32;
    var phi_1339_: f32;
    var phi_1340_: f32;
    var phi_1341_: f32;

    let _e39 = (*param_11);
    let _e40 = (1f - _e39);
    let _e49 = (0.5f * _e39);
    let _e50 = ((param_12.x * _e40) + _e49);
    let _e51 = ((param_12.y * _e40) + _e49);
    let _e52 = ((param_12.z * _e40) + _e49);
    let _e53 = ((param_12.w * _e40) + _e49);
    let _e56 = (_e51 - (_e50 * _e50));
    let _e58 = (_e52 - (_e50 * _e51));
    let _e64 = hankel_HankelFactors(vec4<f32>(_e50, _e51, _e52, _e53), _e56, _e58, (((_e53 - (_e51 * _e51)) * _e56) - (_e58 * _e58)));
    local = hankel_HankelFactors(_e64.moments, _e64.d22_, _e64.l32_d22_, _e64.d33_d22_);
    if ((bitcast<u32>(param_13) & 2147483647u) > 2139095040u) {
        phi_688_ = param_13;
    } else {
        if (param_13 < 0f) {
            phi_687_ = 0f;
        } else {
            if (param_13 > 1f) {
                phi_686_ = 1f;
            } else {
                phi_686_ = param_13;
            }
            let _e76 = phi_686_;
            phi_687_ = _e76;
        }
        let _e78 = phi_687_;
        phi_688_ = _e78;
    }
    let _e80 = phi_688_;
    let _e83 = local.moments[0u];
    let _e86 = local.moments[3u];
    if (_e83 == _e86) {
        let _e90 = local.moments[0u];
        phi_700_ = (_e90 > 0.5f);
    } else {
        phi_700_ = false;
    }
    let _e93 = phi_700_;
    if _e93 {
        let _e96 = local.moments[0u];
        let _e99 = local.moments[3u];
        if (_e96 == _e99) {
            let _e103 = local.moments[0u];
            phi_715_ = (_e103 > 0.5f);
        } else {
            phi_715_ = false;
        }
        let _e106 = phi_715_;
        if _e106 {
            if (_e80 > 0f) {
                let _e109 = local.moments;
                if ((bitcast<u32>(_e109.x) & 2147483647u) > 2139095040u) {
                    phi_742_ = _e109.x;
                } else {
                    if (_e109.x < 0f) {
                        phi_741_ = 0f;
                    } else {
                        if (_e109.x > 1f) {
                            phi_740_ = 1f;
                        } else {
                            phi_740_ = _e109.x;
                        }
                        let _e117 = phi_740_;
                        phi_741_ = _e117;
                    }
                    let _e119 = phi_741_;
                    phi_742_ = _e119;
                }
                let _e121 = phi_742_;
                phi_743_ = _e121;
                phi_744_ = false;
            } else {
                phi_743_ = f32();
                phi_744_ = true;
            }
            let _e123 = phi_743_;
            let _e125 = phi_744_;
            phi_745_ = _e123;
            phi_746_ = _e125;
        } else {
            phi_745_ = f32();
            phi_746_ = true;
        }
        let _e127 = phi_745_;
        let _e129 = phi_746_;
        if _e129 {
            let _e132 = local.moments[0u];
            let _e135 = local.moments[1u];
            let _e143 = local.l32_d22_;
            let _e145 = local.d22_;
            let _e146 = (_e143 / _e145);
            let _e147 = (_e80 - _e132);
            let _e153 = local.d22_;
            let _e156 = local.d33_d22_;
            let _e157 = (((((_e80 * _e80) - _e135) - (_e146 * _e147)) * _e153) / _e156);
            let _e159 = local.d22_;
            let _e162 = ((_e147 / _e159) - (_e146 * _e157));
            let _e168 = ((0.5f * _e162) / _e157);
            let _e171 = ((_e168 * _e168) - (((1f - (_e162 * _e132)) - (_e157 * _e135)) / _e157));
            if (_e171 >= 0f) {
                let _e173 = sqrt(_e171);
                phi_802_ = vec2<f32>((-(_e168) - _e173), (-(_e168) + _e173));
            } else {
                phi_802_ = vec2(bitcast<f32>((bitcast<u32>(_e171) | 2143289344u)));
            }
            let _e184 = phi_802_;
            if (_e80 <= _e184.x) {
                phi_883_ = 1f;
            } else {
                if (_e80 > _e184.y) {
                    let _e190 = local.moments;
                    let _e201 = (((_e190.y - (_e190.x * (_e184.x + _e184.y))) + (_e184.x * _e184.y)) / ((_e80 - _e184.x) * (_e80 - _e184.y)));
                    if ((bitcast<u32>(_e201) & 2147483647u) > 2139095040u) {
                        phi_842_ = _e201;
                    } else {
                        if (_e201 < 0f) {
                            phi_841_ = 0f;
                        } else {
                            if (_e201 > 1f) {
                                phi_840_ = 1f;
                            } else {
                                phi_840_ = _e201;
                            }
                            let _e208 = phi_840_;
                            phi_841_ = _e208;
                        }
                        let _e210 = phi_841_;
                        phi_842_ = _e210;
                    }
                    let _e212 = phi_842_;
                    phi_882_ = _e212;
                } else {
                    if (_e80 > _e184.x) {
                        let _e215 = local.moments;
                        let _e227 = (1f - (((_e215.y - (_e215.x * (_e80 + _e184.y))) + (_e80 * _e184.y)) / ((_e184.x - _e80) * (_e184.x - _e184.y))));
                        if ((bitcast<u32>(_e227) & 2147483647u) > 2139095040u) {
                            phi_877_ = _e227;
                        } else {
                            if (_e227 < 0f) {
                                phi_876_ = 0f;
                            } else {
                                if (_e227 > 1f) {
                                    phi_875_ = 1f;
                                } else {
                                    phi_875_ = _e227;
                                }
                                let _e234 = phi_875_;
                                phi_876_ = _e234;
                            }
                            let _e236 = phi_876_;
                            phi_877_ = _e236;
                        }
                        let _e238 = phi_877_;
                        phi_881_ = _e238;
                    } else {
                        phi_881_ = bitcast<f32>((bitcast<u32>(_e184.x) | 2143289344u));
                    }
                    let _e243 = phi_881_;
                    phi_882_ = _e243;
                }
                let _e245 = phi_882_;
                phi_883_ = _e245;
            }
            let _e247 = phi_883_;
            phi_884_ = _e247;
        } else {
            phi_884_ = _e127;
        }
        let _e249 = phi_884_;
        phi_1341_ = _e249;
    } else {
        let _e252 = local.moments[0u];
        let _e255 = local.moments[1u];
        let _e263 = local.l32_d22_;
        let _e265 = local.d22_;
        let _e266 = (_e263 / _e265);
        let _e267 = (_e80 - _e252);
        let _e273 = local.d22_;
        let _e276 = local.d33_d22_;
        let _e277 = (((((_e80 * _e80) - _e255) - (_e266 * _e267)) * _e273) / _e276);
        let _e279 = local.d22_;
        let _e282 = ((_e267 / _e279) - (_e266 * _e277));
        let _e288 = ((0.5f * _e282) / _e277);
        let _e291 = ((_e288 * _e288) - (((1f - (_e282 * _e252)) - (_e277 * _e255)) / _e277));
        if (_e291 >= 0f) {
            let _e293 = sqrt(_e291);
            phi_937_ = vec2<f32>((-(_e288) - _e293), (-(_e288) + _e293));
        } else {
            phi_937_ = vec2(bitcast<f32>((bitcast<u32>(_e291) | 2143289344u)));
        }
        let _e304 = phi_937_;
        if (_e304.x >= 0f) {
            if (_e304.y <= 1f) {
                let _e311 = local.moments[0u];
                let _e314 = local.moments[3u];
                if (_e311 == _e314) {
                    let _e318 = local.moments[0u];
                    phi_959_ = (_e318 > 0.5f);
                } else {
                    phi_959_ = false;
                }
                let _e321 = phi_959_;
                if _e321 {
                    if (_e80 > 0f) {
                        let _e324 = local.moments;
                        if ((bitcast<u32>(_e324.x) & 2147483647u) > 2139095040u) {
                            phi_986_ = _e324.x;
                        } else {
                            if (_e324.x < 0f) {
                                phi_985_ = 0f;
                            } else {
                                if (_e324.x > 1f) {
                                    phi_984_ = 1f;
                                } else {
                                    phi_984_ = _e324.x;
                                }
                                let _e332 = phi_984_;
                                phi_985_ = _e332;
                            }
                            let _e334 = phi_985_;
                            phi_986_ = _e334;
                        }
                        let _e336 = phi_986_;
                        phi_987_ = _e336;
                        phi_988_ = false;
                    } else {
                        phi_987_ = f32();
                        phi_988_ = true;
                    }
                    let _e338 = phi_987_;
                    let _e340 = phi_988_;
                    phi_989_ = _e338;
                    phi_990_ = _e340;
                } else {
                    phi_989_ = f32();
                    phi_990_ = true;
                }
                let _e342 = phi_989_;
                let _e344 = phi_990_;
                if _e344 {
                    let _e347 = local.moments[0u];
                    let _e350 = local.moments[1u];
                    let _e358 = local.l32_d22_;
                    let _e360 = local.d22_;
                    let _e361 = (_e358 / _e360);
                    let _e362 = (_e80 - _e347);
                    let _e368 = local.d22_;
                    let _e371 = local.d33_d22_;
                    let _e372 = (((((_e80 * _e80) - _e350) - (_e361 * _e362)) * _e368) / _e371);
                    let _e374 = local.d22_;
                    let _e377 = ((_e362 / _e374) - (_e361 * _e372));
                    let _e383 = ((0.5f * _e377) / _e372);
                    let _e386 = ((_e383 * _e383) - (((1f - (_e377 * _e347)) - (_e372 * _e350)) / _e372));
                    if (_e386 >= 0f) {
                        let _e388 = sqrt(_e386);
                        phi_1046_ = vec2<f32>((-(_e383) - _e388), (-(_e383) + _e388));
                    } else {
                        phi_1046_ = vec2(bitcast<f32>((bitcast<u32>(_e386) | 2143289344u)));
                    }
                    let _e399 = phi_1046_;
                    if (_e80 <= _e399.x) {
                        phi_1127_ = 1f;
                    } else {
                        if (_e80 > _e399.y) {
                            let _e405 = local.moments;
                            let _e416 = (((_e405.y - (_e405.x * (_e399.x + _e399.y))) + (_e399.x * _e399.y)) / ((_e80 - _e399.x) * (_e80 - _e399.y)));
                            if ((bitcast<u32>(_e416) & 2147483647u) > 2139095040u) {
                                phi_1086_ = _e416;
                            } else {
                                if (_e416 < 0f) {
                                    phi_1085_ = 0f;
                                } else {
                                    if (_e416 > 1f) {
                                        phi_1084_ = 1f;
                                    } else {
                                        phi_1084_ = _e416;
                                    }
                                    let _e423 = phi_1084_;
                                    phi_1085_ = _e423;
                                }
                                let _e425 = phi_1085_;
                                phi_1086_ = _e425;
                            }
                            let _e427 = phi_1086_;
                            phi_1126_ = _e427;
                        } else {
                            if (_e80 > _e399.x) {
                                let _e430 = local.moments;
                                let _e442 = (1f - (((_e430.y - (_e430.x * (_e80 + _e399.y))) + (_e80 * _e399.y)) / ((_e399.x - _e80) * (_e399.x - _e399.y))));
                                if ((bitcast<u32>(_e442) & 2147483647u) > 2139095040u) {
                                    phi_1121_ = _e442;
                                } else {
                                    if (_e442 < 0f) {
                                        phi_1120_ = 0f;
                                    } else {
                                        if (_e442 > 1f) {
                                            phi_1119_ = 1f;
                                        } else {
                                            phi_1119_ = _e442;
                                        }
                                        let _e449 = phi_1119_;
                                        phi_1120_ = _e449;
                                    }
                                    let _e451 = phi_1120_;
                                    phi_1121_ = _e451;
                                }
                                let _e453 = phi_1121_;
                                phi_1125_ = _e453;
                            } else {
                                phi_1125_ = bitcast<f32>((bitcast<u32>(_e399.x) | 2143289344u));
                            }
                            let _e458 = phi_1125_;
                            phi_1126_ = _e458;
                        }
                        let _e460 = phi_1126_;
                        phi_1127_ = _e460;
                    }
                    let _e462 = phi_1127_;
                    phi_1128_ = _e462;
                } else {
                    phi_1128_ = _e342;
                }
                let _e464 = phi_1128_;
                phi_1129_ = _e464;
                phi_1130_ = false;
            } else {
                phi_1129_ = f32();
                phi_1130_ = true;
            }
            let _e466 = phi_1129_;
            let _e468 = phi_1130_;
            phi_1131_ = _e466;
            phi_1132_ = _e468;
        } else {
            phi_1131_ = f32();
            phi_1132_ = true;
        }
        let _e470 = phi_1131_;
        let _e472 = phi_1132_;
        if _e472 {
            if ((bitcast<u32>(_e304.x) & 2147483647u) > 2139095040u) {
                phi_1339_ = _e304.x;
            } else {
                let _e476 = lt_math_hausdorff_endpoint_upper_bound((&local), _e80);
                let _e479 = local.moments[0u];
                let _e482 = local.moments[3u];
                if (_e479 == _e482) {
                    let _e486 = local.moments[0u];
                    phi_1154_ = (_e486 > 0.5f);
                } else {
                    phi_1154_ = false;
                }
                let _e489 = phi_1154_;
                if _e489 {
                    if (_e80 > 0f) {
                        let _e492 = local.moments;
                        if ((bitcast<u32>(_e492.x) & 2147483647u) > 2139095040u) {
                            phi_1181_ = _e492.x;
                        } else {
                            if (_e492.x < 0f) {
                                phi_1180_ = 0f;
                            } else {
                                if (_e492.x > 1f) {
                                    phi_1179_ = 1f;
                                } else {
                                    phi_1179_ = _e492.x;
                                }
                                let _e500 = phi_1179_;
                                phi_1180_ = _e500;
                            }
                            let _e502 = phi_1180_;
                            phi_1181_ = _e502;
                        }
                        let _e504 = phi_1181_;
                        phi_1182_ = _e504;
                        phi_1183_ = false;
                    } else {
                        phi_1182_ = f32();
                        phi_1183_ = true;
                    }
                    let _e506 = phi_1182_;
                    let _e508 = phi_1183_;
                    phi_1184_ = _e506;
                    phi_1185_ = _e508;
                } else {
                    phi_1184_ = f32();
                    phi_1185_ = true;
                }
                let _e510 = phi_1184_;
                let _e512 = phi_1185_;
                if _e512 {
                    let _e515 = local.moments[0u];
                    let _e518 = local.moments[1u];
                    let _e526 = local.l32_d22_;
                    let _e528 = local.d22_;
                    let _e529 = (_e526 / _e528);
                    let _e530 = (_e80 - _e515);
                    let _e536 = local.d22_;
                    let _e539 = local.d33_d22_;
                    let _e540 = (((((_e80 * _e80) - _e518) - (_e529 * _e530)) * _e536) / _e539);
                    let _e542 = local.d22_;
                    let _e545 = ((_e530 / _e542) - (_e529 * _e540));
                    let _e551 = ((0.5f * _e545) / _e540);
                    let _e554 = ((_e551 * _e551) - (((1f - (_e545 * _e515)) - (_e540 * _e518)) / _e540));
                    if (_e554 >= 0f) {
                        let _e556 = sqrt(_e554);
                        phi_1241_ = vec2<f32>((-(_e551) - _e556), (-(_e551) + _e556));
                    } else {
                        phi_1241_ = vec2(bitcast<f32>((bitcast<u32>(_e554) | 2143289344u)));
                    }
                    let _e567 = phi_1241_;
                    if (_e80 <= _e567.x) {
                        phi_1322_ = 1f;
                    } else {
                        if (_e80 > _e567.y) {
                            let _e573 = local.moments;
                            let _e584 = (((_e573.y - (_e573.x * (_e567.x + _e567.y))) + (_e567.x * _e567.y)) / ((_e80 - _e567.x) * (_e80 - _e567.y)));
                            if ((bitcast<u32>(_e584) & 2147483647u) > 2139095040u) {
                                phi_1281_ = _e584;
                            } else {
                                if (_e584 < 0f) {
                                    phi_1280_ = 0f;
                                } else {
                                    if (_e584 > 1f) {
                                        phi_1279_ = 1f;
                                    } else {
                                        phi_1279_ = _e584;
                                    }
                                    let _e591 = phi_1279_;
                                    phi_1280_ = _e591;
                                }
                                let _e593 = phi_1280_;
                                phi_1281_ = _e593;
                            }
                            let _e595 = phi_1281_;
                            phi_1321_ = _e595;
                        } else {
                            if (_e80 > _e567.x) {
                                let _e598 = local.moments;
                                let _e610 = (1f - (((_e598.y - (_e598.x * (_e80 + _e567.y))) + (_e80 * _e567.y)) / ((_e567.x - _e80) * (_e567.x - _e567.y))));
                                if ((bitcast<u32>(_e610) & 2147483647u) > 2139095040u) {
                                    phi_1316_ = _e610;
                                } else {
                                    if (_e610 < 0f) {
                                        phi_1315_ = 0f;
                                    } else {
                                        if (_e610 > 1f) {
                                            phi_1314_ = 1f;
                                        } else {
                                            phi_1314_ = _e610;
                                        }
                                        let _e617 = phi_1314_;
                                        phi_1315_ = _e617;
                                    }
                                    let _e619 = phi_1315_;
                                    phi_1316_ = _e619;
                                }
                                let _e621 = phi_1316_;
                                phi_1320_ = _e621;
                            } else {
                                phi_1320_ = bitcast<f32>((bitcast<u32>(_e567.x) | 2143289344u));
                            }
                            let _e626 = phi_1320_;
                            phi_1321_ = _e626;
                        }
                        let _e628 = phi_1321_;
                        phi_1322_ = _e628;
                    }
                    let _e630 = phi_1322_;
                    phi_1323_ = _e630;
                } else {
                    phi_1323_ = _e510;
                }
                let _e632 = phi_1323_;
                if ((bitcast<u32>(_e632) & 2147483647u) > 2139095040u) {
                    phi_1334_ = true;
                } else {
                    let _e636 = (_e632 < _e476);
                    if _e636 {
                    }
                    phi_1334_ = _e636;
                }
                let _e638 = phi_1334_;
                if _e638 {
                    phi_1338_ = _e632;
                } else {
                    phi_1338_ = _e476;
                }
                let _e640 = phi_1338_;
                phi_1339_ = _e640;
            }
            let _e642 = phi_1339_;
            phi_1340_ = _e642;
        } else {
            phi_1340_ = _e470;
        }
        let _e644 = phi_1340_;
        phi_1341_ = _e644;
    }
    let _e646 = phi_1341_;
    return _e646;
}

fn function_() {
    var local_1: f32;
    var phi_209_: bool;
    var phi_210_: bool;
    var phi_211_: bool;
    var phi_212_: bool;
    var phi_216_: bool;
    var phi_260_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_264_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_341_: bool;
    var phi_350_: bool;
    var phi_359_: bool;
    var phi_360_: bool;
    var phi_361_: bool;
    var phi_362_: bool;
    var phi_363_: bool;
    var phi_364_: bool;
    var phi_365_: bool;
    var phi_369_: bool;
    var phi_405_: f32;
    var phi_410_: f32;
    var phi_411_: bool;
    var phi_412_: f32;
    var phi_413_: bool;
    var phi_417_: f32;
    var phi_437_: f32;
    var phi_442_: f32;
    var phi_443_: bool;
    var phi_444_: f32;
    var phi_445_: bool;
    var phi_449_: f32;
    var phi_495_: i32;
    var phi_500_: i32;
    var phi_505_: i32;
    var phi_510_: i32;
    var phi_519_: i32;
    var phi_524_: i32;
    var phi_529_: i32;
    var phi_534_: i32;
    var phi_619_: evaluate_Verdict;
    var phi_620_: evaluate_Verdict;
    var phi_621_: bool;
    var phi_622_: evaluate_Verdict;
    var phi_623_: evaluate_Verdict;
    var phi_624_: bool;
    var phi_628_: evaluate_Verdict;

    let _e36 = id_1;
    let _e43 = arrayLength((&map.member));
    let _e49 = p.member.size[0u];
    let _e51 = p.member.size[1u];
    let _e52 = lt_shaders_entry_pixel_index(_e36, _e49, _e51);
    if (bitcast<i32>(_e52.root) != 0i) {
        if (_e52.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e61 = p.member.light;
        let _e64 = samples.member[(0u + _e52.first_primitive)].normal[0u];
        let _e66 = global[0u];
        if (_e64 == _e66) {
            let _e69 = samples.member[(0u + _e52.first_primitive)].normal[1u];
            let _e71 = global[1u];
            if (_e69 == _e71) {
                let _e74 = samples.member[(0u + _e52.first_primitive)].normal[2u];
                let _e76 = global[2u];
                phi_209_ = (_e74 == _e76);
                phi_210_ = false;
            } else {
                phi_209_ = bool();
                phi_210_ = true;
            }
            let _e79 = phi_209_;
            let _e81 = phi_210_;
            phi_211_ = _e79;
            phi_212_ = _e81;
        } else {
            phi_211_ = bool();
            phi_212_ = true;
        }
        let _e83 = phi_211_;
        let _e85 = phi_212_;
        if _e85 {
            phi_216_ = false;
        } else {
            phi_216_ = _e83;
        }
        let _e87 = phi_216_;
        if !(_e87) {
            let _e90 = samples.member[(0u + _e52.first_primitive)].normal;
            let _e92 = samples.member[(0u + _e52.first_primitive)].position;
            if ((((_e90.x * (_e61.x - (_e92.x * _e61.w))) + (_e90.y * (_e61.y - (_e92.y * _e61.w)))) + (_e90.z * (_e61.z - (_e92.z * _e61.w)))) > 0f) {
                let _e116 = samples.member[(0u + _e52.first_primitive)].flags;
                let _e124 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e130 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e124.unnamed.visibility, false), _e124.unnamed_1);
                phi_260_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e130.unnamed, ((_e116 & 1u) == 0u));
            } else {
                let _e139 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e145 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e139.unnamed.visibility, false), _e139.unnamed_1);
                phi_260_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e145.unnamed, true);
            }
            let _e150 = phi_260_;
            phi_264_ = _e150;
        } else {
            let _e156 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e162 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e156.unnamed.visibility, false), _e156.unnamed_1);
            phi_264_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e162.unnamed, true);
        }
        let _e167 = phi_264_;
        if _e167.unnamed_1 {
            phi_622_ = evaluate_Verdict(_e167.unnamed.visibility, _e167.unnamed.is_doubted);
            phi_623_ = evaluate_Verdict();
            phi_624_ = true;
        } else {
            let _e175 = samples.member[(0u + _e52.first_primitive)].position;
            let _e181 = p.member.projection.row_w;
            let _e192 = ((((_e181.x * _e175.x) + (_e181.y * _e175.y)) + (_e181.z * _e175.z)) + (_e181.w * 1f));
            let _e194 = p.member.projection.row_x;
            let _e206 = (((((_e194.x * _e175.x) + (_e194.y * _e175.y)) + (_e194.z * _e175.z)) + (_e194.w * 1f)) / _e192);
            let _e208 = p.member.projection.row_y;
            let _e220 = (((((_e208.x * _e175.x) + (_e208.y * _e175.y)) + (_e208.z * _e175.z)) + (_e208.w * 1f)) / _e192);
            let _e222 = p.member.projection.row_z;
            let _e233 = ((((_e222.x * _e175.x) + (_e222.y * _e175.y)) + (_e222.z * _e175.z)) + (_e222.w * 1f));
            if (_e192 > 0f) {
                if (_e206 >= 0f) {
                    phi_341_ = (_e206 <= 1f);
                } else {
                    phi_341_ = false;
                }
                let _e238 = phi_341_;
                if _e238 {
                    if (_e220 >= 0f) {
                        phi_350_ = (_e220 <= 1f);
                    } else {
                        phi_350_ = false;
                    }
                    let _e242 = phi_350_;
                    if _e242 {
                        if (_e233 >= 0f) {
                            phi_359_ = (_e233 <= 1f);
                        } else {
                            phi_359_ = false;
                        }
                        let _e246 = phi_359_;
                        phi_360_ = _e246;
                        phi_361_ = false;
                    } else {
                        phi_360_ = bool();
                        phi_361_ = true;
                    }
                    let _e248 = phi_360_;
                    let _e250 = phi_361_;
                    phi_362_ = _e248;
                    phi_363_ = _e250;
                } else {
                    phi_362_ = bool();
                    phi_363_ = true;
                }
                let _e252 = phi_362_;
                let _e254 = phi_363_;
                phi_364_ = _e252;
                phi_365_ = _e254;
            } else {
                phi_364_ = bool();
                phi_365_ = true;
            }
            let _e256 = phi_364_;
            let _e258 = phi_365_;
            if _e258 {
                phi_369_ = false;
            } else {
                phi_369_ = _e256;
            }
            let _e260 = phi_369_;
            if _e260 {
                let _e262 = p.member.map_size;
                let _e263 = f32(_e262);
                let _e266 = ((_e206 * _e263) - 0.5f);
                let _e267 = ((_e220 * _e263) - 0.5f);
                if (_e266 > -8388608f) {
                    let _e279 = f32(select(0i, select(select(i32(_e266), i32(-2147483648), (_e266 < bitcast<f32>(3472883712u))), 2147483647i, (_e266 > bitcast<f32>(1325400063u))), (_e266 == _e266)));
                    if (_e279 > _e266) {
                        phi_405_ = 1f;
                    } else {
                        phi_405_ = 0f;
                    }
                    let _e282 = phi_405_;
                    if (_e266 < 8388608f) {
                        phi_410_ = (_e279 - _e282);
                        phi_411_ = false;
                    } else {
                        phi_410_ = f32();
                        phi_411_ = true;
                    }
                    let _e285 = phi_410_;
                    let _e287 = phi_411_;
                    phi_412_ = _e285;
                    phi_413_ = _e287;
                } else {
                    phi_412_ = f32();
                    phi_413_ = true;
                }
                let _e289 = phi_412_;
                let _e291 = phi_413_;
                if _e291 {
                    phi_417_ = _e266;
                } else {
                    phi_417_ = _e289;
                }
                let _e293 = phi_417_;
                if (_e267 > -8388608f) {
                    let _e305 = f32(select(0i, select(select(i32(_e267), i32(-2147483648), (_e267 < bitcast<f32>(3472883712u))), 2147483647i, (_e267 > bitcast<f32>(1325400063u))), (_e267 == _e267)));
                    if (_e305 > _e267) {
                        phi_437_ = 1f;
                    } else {
                        phi_437_ = 0f;
                    }
                    let _e308 = phi_437_;
                    if (_e267 < 8388608f) {
                        phi_442_ = (_e305 - _e308);
                        phi_443_ = false;
                    } else {
                        phi_442_ = f32();
                        phi_443_ = true;
                    }
                    let _e311 = phi_442_;
                    let _e313 = phi_443_;
                    phi_444_ = _e311;
                    phi_445_ = _e313;
                } else {
                    phi_444_ = f32();
                    phi_445_ = true;
                }
                let _e315 = phi_444_;
                let _e317 = phi_445_;
                if _e317 {
                    phi_449_ = _e267;
                } else {
                    phi_449_ = _e315;
                }
                let _e319 = phi_449_;
                let _e320 = (_e266 - _e293);
                let _e321 = (_e267 - _e319);
                let _e330 = select(0i, select(select(i32(_e293), i32(-2147483648), (_e293 < bitcast<f32>(3472883712u))), 2147483647i, (_e293 > bitcast<f32>(1325400063u))), (_e293 == _e293));
                let _e339 = select(0i, select(select(i32(_e319), i32(-2147483648), (_e319 < bitcast<f32>(3472883712u))), 2147483647i, (_e319 > bitcast<f32>(1325400063u))), (_e319 == _e319));
                let _e342 = ((1f - _e320) * (1f - _e321));
                let _e344 = (_e320 * (1f - _e321));
                let _e346 = ((1f - _e320) * _e321);
                let _e347 = (_e320 * _e321);
                let _e349 = p.member.test;
                let _e350 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e349);
                let _e352 = p.member.map_size;
                local_1 = _e350;
                let _e354 = (bitcast<i32>(_e352) - 1i);
                if (_e330 > 0i) {
                    phi_495_ = _e330;
                } else {
                    phi_495_ = 0i;
                }
                let _e357 = phi_495_;
                if (_e339 > 0i) {
                    phi_500_ = _e339;
                } else {
                    phi_500_ = 0i;
                }
                let _e360 = phi_500_;
                if (_e357 < _e354) {
                    phi_505_ = _e357;
                } else {
                    phi_505_ = _e354;
                }
                let _e363 = phi_505_;
                if (_e360 < _e354) {
                    phi_510_ = _e360;
                } else {
                    phi_510_ = _e354;
                }
                let _e366 = phi_510_;
                let _e367 = bitcast<u32>(_e363);
                let _e369 = (_e330 + 1i);
                let _e370 = (_e339 + 1i);
                if (_e369 > 0i) {
                    phi_519_ = _e369;
                } else {
                    phi_519_ = 0i;
                }
                let _e373 = phi_519_;
                if (_e370 > 0i) {
                    phi_524_ = _e370;
                } else {
                    phi_524_ = 0i;
                }
                let _e376 = phi_524_;
                if (_e373 < _e354) {
                    phi_529_ = _e373;
                } else {
                    phi_529_ = _e354;
                }
                let _e379 = phi_529_;
                if (_e376 < _e354) {
                    phi_534_ = _e376;
                } else {
                    phi_534_ = _e354;
                }
                let _e382 = phi_534_;
                let _e383 = bitcast<u32>(_e379);
                let _e385 = (bitcast<u32>(_e366) * _e352);
                let _e386 = (bitcast<u32>(_e382) * _e352);
                let _e387 = (_e385 + _e367);
                let _e388 = (_e385 + _e383);
                let _e389 = (_e386 + _e367);
                let _e390 = (_e386 + _e383);
                if (_e387 < _e43) {
                } else {
                    return;
                }
                let _e394 = map.member[(0u + _e387)];
                if (_e388 < _e43) {
                } else {
                    return;
                }
                let _e406 = map.member[(0u + _e388)];
                if (_e389 < _e43) {
                } else {
                    return;
                }
                let _e422 = map.member[(0u + _e389)];
                if (_e390 < _e43) {
                } else {
                    return;
                }
                let _e438 = map.member[(0u + _e390)];
                let _e452 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_1), vec4<f32>(((((_e394.x * _e342) + (_e406.x * _e344)) + (_e422.x * _e346)) + (_e438.x * _e347)), ((((_e394.y * _e342) + (_e406.y * _e344)) + (_e422.y * _e346)) + (_e438.y * _e347)), ((((_e394.z * _e342) + (_e406.z * _e344)) + (_e422.z * _e346)) + (_e438.z * _e347)), ((((_e394.w * _e342) + (_e406.w * _e344)) + (_e422.w * _e346)) + (_e438.w * _e347))), _e233);
                phi_619_ = evaluate_Verdict(_e452, false);
                phi_620_ = evaluate_Verdict();
                phi_621_ = false;
            } else {
                phi_619_ = evaluate_Verdict();
                phi_620_ = evaluate_Verdict(1f, false);
                phi_621_ = true;
            }
            let _e456 = phi_619_;
            let _e458 = phi_620_;
            let _e460 = phi_621_;
            phi_622_ = _e458;
            phi_623_ = _e456;
            phi_624_ = _e460;
        }
        let _e462 = phi_622_;
        let _e464 = phi_623_;
        let _e466 = phi_624_;
        if _e466 {
            phi_628_ = _e462;
        } else {
            phi_628_ = _e464;
        }
        let _e468 = phi_628_;
        if (_e52.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e52.first_primitive)] = _e468.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_msm_hausdorff_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
