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

struct type_17 {
    member: array<abi_Sample>,
}

struct type_21 {
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

struct type_29 {
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
var<storage> samples: type_17;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_29;
@group(0) @binding(2) 
var<storage> map: type_21;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_21;

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

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_4: f32) -> vec4<f32> {
    var phi_172_: f32;
    var phi_173_: f32;
    var phi_174_: f32;

    if ((bitcast<u32>(param_4) & 2147483647u) > 2139095040u) {
        phi_174_ = param_4;
    } else {
        if (param_4 < 0f) {
            phi_173_ = 0f;
        } else {
            if (param_4 > 1f) {
                phi_172_ = 1f;
            } else {
                phi_172_ = param_4;
            }
            let _e42 = phi_172_;
            phi_173_ = _e42;
        }
        let _e44 = phi_173_;
        phi_174_ = _e44;
    }
    let _e46 = phi_174_;
    let _e47 = (_e46 * _e46);
    return vec4<f32>(_e46, _e47, (_e47 * _e46), (_e47 * _e47));
}

fn lt_math_hausdorff_cubic_mass(param_5: vec4<f32>, param_6: f32, param_7: f32, param_8: f32, param_9: f32) -> f32 {
    return ((((param_5.z - (((param_7 + param_8) + param_9) * param_5.y)) + ((((param_7 * param_8) + (param_7 * param_9)) + (param_8 * param_9)) * param_5.x)) - ((param_7 * param_8) * param_9)) / (((param_6 - param_7) * (param_6 - param_8)) * (param_6 - param_9)));
}

fn lt_math_hausdorff_endpoint_upper_bound(param_10: ptr<function, hankel_HankelFactors>, param_11: f32) -> f32 {
    var phi_1448_: f32;
    var phi_1449_: f32;
    var phi_1450_: f32;
    var phi_1477_: f32;
    var phi_1478_: f32;
    var phi_1479_: f32;
    var phi_1480_: f32;
    var phi_1481_: bool;
    var phi_1482_: f32;
    var phi_1483_: bool;
    var phi_1511_: f32;
    var phi_1512_: f32;
    var phi_1513_: f32;
    var phi_1514_: f32;
    var phi_1515_: bool;
    var phi_1516_: f32;
    var phi_1517_: bool;
    var phi_1524_: f32;
    var phi_1525_: f32;
    var phi_1526_: f32;
    var phi_1527_: f32;

    let _e38 = (*param_10).moments;
    if (param_11 < 0.0001f) {
        phi_1527_ = 1f;
    } else {
        let _e47 = ((_e38.z - ((1f + param_11) * _e38.y)) + (param_11 * _e38.x));
        let _e56 = (((_e38.w - ((1f + param_11) * _e38.z)) + (param_11 * _e38.y)) / _e47);
        if (abs(_e47) <= 0.00000047683716f) {
            let _e70 = (1f - (((_e38.y - (_e38.x * (param_11 + 1f))) + (param_11 * 1f)) / ((0f - param_11) * (0f - 1f))));
            if ((bitcast<u32>(_e70) & 2147483647u) > 2139095040u) {
                phi_1450_ = _e70;
            } else {
                if (_e70 < 0f) {
                    phi_1449_ = 0f;
                } else {
                    if (_e70 > 1f) {
                        phi_1448_ = 1f;
                    } else {
                        phi_1448_ = _e70;
                    }
                    let _e77 = phi_1448_;
                    phi_1449_ = _e77;
                }
                let _e79 = phi_1449_;
                phi_1450_ = _e79;
            }
            let _e81 = phi_1450_;
            phi_1526_ = _e81;
        } else {
            if (_e56 > 0f) {
                if (_e56 < param_11) {
                    let _e84 = lt_math_hausdorff_cubic_mass(_e38, 0f, _e56, param_11, 1f);
                    let _e86 = lt_math_hausdorff_cubic_mass(_e38, _e56, 0f, param_11, 1f);
                    let _e87 = ((1f - _e84) - _e86);
                    if ((bitcast<u32>(_e87) & 2147483647u) > 2139095040u) {
                        phi_1479_ = _e87;
                    } else {
                        if (_e87 < 0f) {
                            phi_1478_ = 0f;
                        } else {
                            if (_e87 > 1f) {
                                phi_1477_ = 1f;
                            } else {
                                phi_1477_ = _e87;
                            }
                            let _e94 = phi_1477_;
                            phi_1478_ = _e94;
                        }
                        let _e96 = phi_1478_;
                        phi_1479_ = _e96;
                    }
                    let _e98 = phi_1479_;
                    phi_1480_ = _e98;
                    phi_1481_ = false;
                } else {
                    phi_1480_ = f32();
                    phi_1481_ = true;
                }
                let _e100 = phi_1480_;
                let _e102 = phi_1481_;
                phi_1482_ = _e100;
                phi_1483_ = _e102;
            } else {
                phi_1482_ = f32();
                phi_1483_ = true;
            }
            let _e104 = phi_1482_;
            let _e106 = phi_1483_;
            if _e106 {
                if (_e56 > param_11) {
                    if (_e56 < 1f) {
                        let _e109 = lt_math_hausdorff_cubic_mass(_e38, 0f, _e56, param_11, 1f);
                        let _e110 = (1f - _e109);
                        if ((bitcast<u32>(_e110) & 2147483647u) > 2139095040u) {
                            phi_1513_ = _e110;
                        } else {
                            if (_e110 < 0f) {
                                phi_1512_ = 0f;
                            } else {
                                if (_e110 > 1f) {
                                    phi_1511_ = 1f;
                                } else {
                                    phi_1511_ = _e110;
                                }
                                let _e117 = phi_1511_;
                                phi_1512_ = _e117;
                            }
                            let _e119 = phi_1512_;
                            phi_1513_ = _e119;
                        }
                        let _e121 = phi_1513_;
                        phi_1514_ = _e121;
                        phi_1515_ = false;
                    } else {
                        phi_1514_ = f32();
                        phi_1515_ = true;
                    }
                    let _e123 = phi_1514_;
                    let _e125 = phi_1515_;
                    phi_1516_ = _e123;
                    phi_1517_ = _e125;
                } else {
                    phi_1516_ = f32();
                    phi_1517_ = true;
                }
                let _e127 = phi_1516_;
                let _e129 = phi_1517_;
                if _e129 {
                    phi_1524_ = bitcast<f32>((bitcast<u32>(_e56) | 2143289344u));
                } else {
                    phi_1524_ = _e127;
                }
                let _e134 = phi_1524_;
                phi_1525_ = _e134;
            } else {
                phi_1525_ = _e104;
            }
            let _e136 = phi_1525_;
            phi_1526_ = _e136;
        }
        let _e138 = phi_1526_;
        phi_1527_ = _e138;
    }
    let _e140 = phi_1527_;
    return _e140;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_12: ptr<function, f32>, param_13: vec4<f32>, param_14: f32) -> f32 {
    var local: hankel_HankelFactors;
    var phi_728_: f32;
    var phi_729_: f32;
    var phi_730_: f32;
    var phi_742_: bool;
    var phi_757_: bool;
    var phi_782_: f32;
    var phi_783_: f32;
    var phi_784_: f32;
    var phi_785_: f32;
    var phi_786_: bool;
    var phi_787_: f32;
    var phi_788_: bool;
    var phi_844_: vec2<f32>;
    var phi_882_: f32;
    var phi_883_: f32;
    var phi_884_: f32;
    var phi_917_: f32;
    var phi_918_: f32;
    var phi_919_: f32;
    var phi_923_: f32;
    var phi_924_: f32;
    var phi_925_: f32;
    var phi_926_: f32;
    var phi_979_: vec2<f32>;
    var phi_1001_: bool;
    var phi_1026_: f32;
    var phi_1027_: f32;
    var phi_1028_: f32;
    var phi_1029_: f32;
    var phi_1030_: bool;
    var phi_1031_: f32;
    var phi_1032_: bool;
    var phi_1088_: vec2<f32>;
    var phi_1126_: f32;
    var phi_1127_: f32;
    var phi_1128_: f32;
    var phi_1161_: f32;
    var phi_1162_: f32;
    var phi_1163_: f32;
    var phi_1167_: f32;
    var phi_1168_: f32;
    var phi_1169_: f32;
    var phi_1170_: f32;
    var phi_1171_: f32;
    var phi_1172_: bool;
    var phi_1173_: f32;
    var phi_1174_: bool;
    var phi_1196_: bool;
    var phi_1221_: f32;
    var phi_1222_: f32;
    var phi_1223_: f32;
    var phi_1224_: f32;
    var phi_1225_: bool;
    var phi_1226_: f32;
    var phi_1227_: bool;
    var phi_1283_: vec2<f32>;
    var phi_1321_: f32;
    var phi_1322_: f32;
    var phi_1323_: f32;
    var phi_1356_: f32;
    var phi_1357_: f32;
    var phi_1358_: f32;
    var phi_1362_: f32;
    var phi_1363_: f32;
    var phi_1364_: f32;
    var phi_1365_: f32;
    var phi_1382_: bool;
    var phi_1386_: f32;
    var phi_1387_: f32;
    var phi_1388_: f32;
    var phi_1389_: f32;
    var phi_1390_: f32;

    let _e39 = (*param_12);
    let _e40 = (1f - _e39);
    let _e49 = (0.5f * _e39);
    let _e50 = ((param_13.x * _e40) + _e49);
    let _e51 = ((param_13.y * _e40) + _e49);
    let _e52 = ((param_13.z * _e40) + _e49);
    let _e53 = ((param_13.w * _e40) + _e49);
    let _e56 = (_e51 - (_e50 * _e50));
    let _e58 = (_e52 - (_e50 * _e51));
    let _e64 = hankel_HankelFactors(vec4<f32>(_e50, _e51, _e52, _e53), _e56, _e58, (((_e53 - (_e51 * _e51)) * _e56) - (_e58 * _e58)));
    local = hankel_HankelFactors(_e64.moments, _e64.d22_, _e64.l32_d22_, _e64.d33_d22_);
    if ((bitcast<u32>(param_14) & 2147483647u) > 2139095040u) {
        phi_730_ = param_14;
    } else {
        if (param_14 < 0f) {
            phi_729_ = 0f;
        } else {
            if (param_14 > 1f) {
                phi_728_ = 1f;
            } else {
                phi_728_ = param_14;
            }
            let _e76 = phi_728_;
            phi_729_ = _e76;
        }
        let _e78 = phi_729_;
        phi_730_ = _e78;
    }
    let _e80 = phi_730_;
    let _e83 = local.moments[0u];
    let _e86 = local.moments[3u];
    if (_e83 == _e86) {
        let _e90 = local.moments[0u];
        phi_742_ = (_e90 > 0.5f);
    } else {
        phi_742_ = false;
    }
    let _e93 = phi_742_;
    if _e93 {
        let _e96 = local.moments[0u];
        let _e99 = local.moments[3u];
        if (_e96 == _e99) {
            let _e103 = local.moments[0u];
            phi_757_ = (_e103 > 0.5f);
        } else {
            phi_757_ = false;
        }
        let _e106 = phi_757_;
        if _e106 {
            if (_e80 > 0f) {
                let _e109 = local.moments;
                if ((bitcast<u32>(_e109.x) & 2147483647u) > 2139095040u) {
                    phi_784_ = _e109.x;
                } else {
                    if (_e109.x < 0f) {
                        phi_783_ = 0f;
                    } else {
                        if (_e109.x > 1f) {
                            phi_782_ = 1f;
                        } else {
                            phi_782_ = _e109.x;
                        }
                        let _e117 = phi_782_;
                        phi_783_ = _e117;
                    }
                    let _e119 = phi_783_;
                    phi_784_ = _e119;
                }
                let _e121 = phi_784_;
                phi_785_ = _e121;
                phi_786_ = false;
            } else {
                phi_785_ = f32();
                phi_786_ = true;
            }
            let _e123 = phi_785_;
            let _e125 = phi_786_;
            phi_787_ = _e123;
            phi_788_ = _e125;
        } else {
            phi_787_ = f32();
            phi_788_ = true;
        }
        let _e127 = phi_787_;
        let _e129 = phi_788_;
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
                phi_844_ = vec2<f32>((-(_e168) - _e173), (-(_e168) + _e173));
            } else {
                phi_844_ = vec2(bitcast<f32>((bitcast<u32>(_e171) | 2143289344u)));
            }
            let _e184 = phi_844_;
            if (_e80 <= _e184.x) {
                phi_925_ = 1f;
            } else {
                if (_e80 > _e184.y) {
                    let _e190 = local.moments;
                    let _e201 = (((_e190.y - (_e190.x * (_e184.x + _e184.y))) + (_e184.x * _e184.y)) / ((_e80 - _e184.x) * (_e80 - _e184.y)));
                    if ((bitcast<u32>(_e201) & 2147483647u) > 2139095040u) {
                        phi_884_ = _e201;
                    } else {
                        if (_e201 < 0f) {
                            phi_883_ = 0f;
                        } else {
                            if (_e201 > 1f) {
                                phi_882_ = 1f;
                            } else {
                                phi_882_ = _e201;
                            }
                            let _e208 = phi_882_;
                            phi_883_ = _e208;
                        }
                        let _e210 = phi_883_;
                        phi_884_ = _e210;
                    }
                    let _e212 = phi_884_;
                    phi_924_ = _e212;
                } else {
                    if (_e80 > _e184.x) {
                        let _e215 = local.moments;
                        let _e227 = (1f - (((_e215.y - (_e215.x * (_e80 + _e184.y))) + (_e80 * _e184.y)) / ((_e184.x - _e80) * (_e184.x - _e184.y))));
                        if ((bitcast<u32>(_e227) & 2147483647u) > 2139095040u) {
                            phi_919_ = _e227;
                        } else {
                            if (_e227 < 0f) {
                                phi_918_ = 0f;
                            } else {
                                if (_e227 > 1f) {
                                    phi_917_ = 1f;
                                } else {
                                    phi_917_ = _e227;
                                }
                                let _e234 = phi_917_;
                                phi_918_ = _e234;
                            }
                            let _e236 = phi_918_;
                            phi_919_ = _e236;
                        }
                        let _e238 = phi_919_;
                        phi_923_ = _e238;
                    } else {
                        phi_923_ = bitcast<f32>((bitcast<u32>(_e184.x) | 2143289344u));
                    }
                    let _e243 = phi_923_;
                    phi_924_ = _e243;
                }
                let _e245 = phi_924_;
                phi_925_ = _e245;
            }
            let _e247 = phi_925_;
            phi_926_ = _e247;
        } else {
            phi_926_ = _e127;
        }
        let _e249 = phi_926_;
        phi_1390_ = _e249;
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
            phi_979_ = vec2<f32>((-(_e288) - _e293), (-(_e288) + _e293));
        } else {
            phi_979_ = vec2(bitcast<f32>((bitcast<u32>(_e291) | 2143289344u)));
        }
        let _e304 = phi_979_;
        if (_e304.x >= 0f) {
            if (_e304.y <= 1f) {
                let _e311 = local.moments[0u];
                let _e314 = local.moments[3u];
                if (_e311 == _e314) {
                    let _e318 = local.moments[0u];
                    phi_1001_ = (_e318 > 0.5f);
                } else {
                    phi_1001_ = false;
                }
                let _e321 = phi_1001_;
                if _e321 {
                    if (_e80 > 0f) {
                        let _e324 = local.moments;
                        if ((bitcast<u32>(_e324.x) & 2147483647u) > 2139095040u) {
                            phi_1028_ = _e324.x;
                        } else {
                            if (_e324.x < 0f) {
                                phi_1027_ = 0f;
                            } else {
                                if (_e324.x > 1f) {
                                    phi_1026_ = 1f;
                                } else {
                                    phi_1026_ = _e324.x;
                                }
                                let _e332 = phi_1026_;
                                phi_1027_ = _e332;
                            }
                            let _e334 = phi_1027_;
                            phi_1028_ = _e334;
                        }
                        let _e336 = phi_1028_;
                        phi_1029_ = _e336;
                        phi_1030_ = false;
                    } else {
                        phi_1029_ = f32();
                        phi_1030_ = true;
                    }
                    let _e338 = phi_1029_;
                    let _e340 = phi_1030_;
                    phi_1031_ = _e338;
                    phi_1032_ = _e340;
                } else {
                    phi_1031_ = f32();
                    phi_1032_ = true;
                }
                let _e342 = phi_1031_;
                let _e344 = phi_1032_;
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
                        phi_1088_ = vec2<f32>((-(_e383) - _e388), (-(_e383) + _e388));
                    } else {
                        phi_1088_ = vec2(bitcast<f32>((bitcast<u32>(_e386) | 2143289344u)));
                    }
                    let _e399 = phi_1088_;
                    if (_e80 <= _e399.x) {
                        phi_1169_ = 1f;
                    } else {
                        if (_e80 > _e399.y) {
                            let _e405 = local.moments;
                            let _e416 = (((_e405.y - (_e405.x * (_e399.x + _e399.y))) + (_e399.x * _e399.y)) / ((_e80 - _e399.x) * (_e80 - _e399.y)));
                            if ((bitcast<u32>(_e416) & 2147483647u) > 2139095040u) {
                                phi_1128_ = _e416;
                            } else {
                                if (_e416 < 0f) {
                                    phi_1127_ = 0f;
                                } else {
                                    if (_e416 > 1f) {
                                        phi_1126_ = 1f;
                                    } else {
                                        phi_1126_ = _e416;
                                    }
                                    let _e423 = phi_1126_;
                                    phi_1127_ = _e423;
                                }
                                let _e425 = phi_1127_;
                                phi_1128_ = _e425;
                            }
                            let _e427 = phi_1128_;
                            phi_1168_ = _e427;
                        } else {
                            if (_e80 > _e399.x) {
                                let _e430 = local.moments;
                                let _e442 = (1f - (((_e430.y - (_e430.x * (_e80 + _e399.y))) + (_e80 * _e399.y)) / ((_e399.x - _e80) * (_e399.x - _e399.y))));
                                if ((bitcast<u32>(_e442) & 2147483647u) > 2139095040u) {
                                    phi_1163_ = _e442;
                                } else {
                                    if (_e442 < 0f) {
                                        phi_1162_ = 0f;
                                    } else {
                                        if (_e442 > 1f) {
                                            phi_1161_ = 1f;
                                        } else {
                                            phi_1161_ = _e442;
                                        }
                                        let _e449 = phi_1161_;
                                        phi_1162_ = _e449;
                                    }
                                    let _e451 = phi_1162_;
                                    phi_1163_ = _e451;
                                }
                                let _e453 = phi_1163_;
                                phi_1167_ = _e453;
                            } else {
                                phi_1167_ = bitcast<f32>((bitcast<u32>(_e399.x) | 2143289344u));
                            }
                            let _e458 = phi_1167_;
                            phi_1168_ = _e458;
                        }
                        let _e460 = phi_1168_;
                        phi_1169_ = _e460;
                    }
                    let _e462 = phi_1169_;
                    phi_1170_ = _e462;
                } else {
                    phi_1170_ = _e342;
                }
                let _e464 = phi_1170_;
                phi_1171_ = _e464;
                phi_1172_ = false;
            } else {
                phi_1171_ = f32();
                phi_1172_ = true;
            }
            let _e466 = phi_1171_;
            let _e468 = phi_1172_;
            phi_1173_ = _e466;
            phi_1174_ = _e468;
        } else {
            phi_1173_ = f32();
            phi_1174_ = true;
        }
        let _e470 = phi_1173_;
        let _e472 = phi_1174_;
        if _e472 {
            if ((bitcast<u32>(_e304.x) & 2147483647u) > 2139095040u) {
                phi_1388_ = _e304.x;
            } else {
                let _e476 = lt_math_hausdorff_endpoint_upper_bound((&local), _e80);
                let _e479 = local.moments[0u];
                let _e482 = local.moments[3u];
                if (_e479 == _e482) {
                    let _e486 = local.moments[0u];
                    phi_1196_ = (_e486 > 0.5f);
                } else {
                    phi_1196_ = false;
                }
                let _e489 = phi_1196_;
                if _e489 {
                    if (_e80 > 0f) {
                        let _e492 = local.moments;
                        if ((bitcast<u32>(_e492.x) & 2147483647u) > 2139095040u) {
                            phi_1223_ = _e492.x;
                        } else {
                            if (_e492.x < 0f) {
                                phi_1222_ = 0f;
                            } else {
                                if (_e492.x > 1f) {
                                    phi_1221_ = 1f;
                                } else {
                                    phi_1221_ = _e492.x;
                                }
                                let _e500 = phi_1221_;
                                phi_1222_ = _e500;
                            }
                            let _e502 = phi_1222_;
                            phi_1223_ = _e502;
                        }
                        let _e504 = phi_1223_;
                        phi_1224_ = _e504;
                        phi_1225_ = false;
                    } else {
                        phi_1224_ = f32();
                        phi_1225_ = true;
                    }
                    let _e506 = phi_1224_;
                    let _e508 = phi_1225_;
                    phi_1226_ = _e506;
                    phi_1227_ = _e508;
                } else {
                    phi_1226_ = f32();
                    phi_1227_ = true;
                }
                let _e510 = phi_1226_;
                let _e512 = phi_1227_;
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
                        phi_1283_ = vec2<f32>((-(_e551) - _e556), (-(_e551) + _e556));
                    } else {
                        phi_1283_ = vec2(bitcast<f32>((bitcast<u32>(_e554) | 2143289344u)));
                    }
                    let _e567 = phi_1283_;
                    if (_e80 <= _e567.x) {
                        phi_1364_ = 1f;
                    } else {
                        if (_e80 > _e567.y) {
                            let _e573 = local.moments;
                            let _e584 = (((_e573.y - (_e573.x * (_e567.x + _e567.y))) + (_e567.x * _e567.y)) / ((_e80 - _e567.x) * (_e80 - _e567.y)));
                            if ((bitcast<u32>(_e584) & 2147483647u) > 2139095040u) {
                                phi_1323_ = _e584;
                            } else {
                                if (_e584 < 0f) {
                                    phi_1322_ = 0f;
                                } else {
                                    if (_e584 > 1f) {
                                        phi_1321_ = 1f;
                                    } else {
                                        phi_1321_ = _e584;
                                    }
                                    let _e591 = phi_1321_;
                                    phi_1322_ = _e591;
                                }
                                let _e593 = phi_1322_;
                                phi_1323_ = _e593;
                            }
                            let _e595 = phi_1323_;
                            phi_1363_ = _e595;
                        } else {
                            if (_e80 > _e567.x) {
                                let _e598 = local.moments;
                                let _e610 = (1f - (((_e598.y - (_e598.x * (_e80 + _e567.y))) + (_e80 * _e567.y)) / ((_e567.x - _e80) * (_e567.x - _e567.y))));
                                if ((bitcast<u32>(_e610) & 2147483647u) > 2139095040u) {
                                    phi_1358_ = _e610;
                                } else {
                                    if (_e610 < 0f) {
                                        phi_1357_ = 0f;
                                    } else {
                                        if (_e610 > 1f) {
                                            phi_1356_ = 1f;
                                        } else {
                                            phi_1356_ = _e610;
                                        }
                                        let _e617 = phi_1356_;
                                        phi_1357_ = _e617;
                                    }
                                    let _e619 = phi_1357_;
                                    phi_1358_ = _e619;
                                }
                                let _e621 = phi_1358_;
                                phi_1362_ = _e621;
                            } else {
                                phi_1362_ = bitcast<f32>((bitcast<u32>(_e567.x) | 2143289344u));
                            }
                            let _e626 = phi_1362_;
                            phi_1363_ = _e626;
                        }
                        let _e628 = phi_1363_;
                        phi_1364_ = _e628;
                    }
                    let _e630 = phi_1364_;
                    phi_1365_ = _e630;
                } else {
                    phi_1365_ = _e510;
                }
                let _e632 = phi_1365_;
                if ((bitcast<u32>(_e476) & 2147483647u) > 2139095040u) {
                    phi_1387_ = _e476;
                } else {
                    if ((bitcast<u32>(_e632) & 2147483647u) > 2139095040u) {
                        phi_1382_ = true;
                    } else {
                        let _e639 = (_e632 < _e476);
                        if _e639 {
                        }
                        phi_1382_ = _e639;
                    }
                    let _e641 = phi_1382_;
                    if _e641 {
                        phi_1386_ = _e632;
                    } else {
                        phi_1386_ = _e476;
                    }
                    let _e643 = phi_1386_;
                    phi_1387_ = _e643;
                }
                let _e645 = phi_1387_;
                phi_1388_ = _e645;
            }
            let _e647 = phi_1388_;
            phi_1389_ = _e647;
        } else {
            phi_1389_ = _e470;
        }
        let _e649 = phi_1389_;
        phi_1390_ = _e649;
    }
    let _e651 = phi_1390_;
    return _e651;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_15: ptr<function, f32>, param_16: vec4<f32>, param_17: vec4<f32>, param_18: f32) -> f32 {
    let _e40 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_16.x);
    let _e42 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_16.y);
    let _e44 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_16.z);
    let _e46 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_16.w);
    let _e96 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_15, vec4<f32>(((((_e40.x * param_17.x) + (_e42.x * param_17.y)) + (_e44.x * param_17.z)) + (_e46.x * param_17.w)), ((((_e40.y * param_17.x) + (_e42.y * param_17.y)) + (_e44.y * param_17.z)) + (_e46.y * param_17.w)), ((((_e40.z * param_17.x) + (_e42.z * param_17.y)) + (_e44.z * param_17.z)) + (_e46.z * param_17.w)), ((((_e40.w * param_17.x) + (_e42.w * param_17.y)) + (_e44.w * param_17.z)) + (_e46.w * param_17.w))), param_18);
    return _e96;
}

fn function_() {
    var local_1: f32;
    var phi_232_: bool;
    var phi_233_: bool;
    var phi_234_: bool;
    var phi_235_: bool;
    var phi_239_: bool;
    var phi_283_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_287_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_364_: bool;
    var phi_373_: bool;
    var phi_382_: bool;
    var phi_383_: bool;
    var phi_384_: bool;
    var phi_385_: bool;
    var phi_386_: bool;
    var phi_387_: bool;
    var phi_388_: bool;
    var phi_392_: bool;
    var phi_428_: f32;
    var phi_433_: f32;
    var phi_434_: bool;
    var phi_435_: f32;
    var phi_436_: bool;
    var phi_440_: f32;
    var phi_460_: f32;
    var phi_465_: f32;
    var phi_466_: bool;
    var phi_467_: f32;
    var phi_468_: bool;
    var phi_472_: f32;
    var phi_518_: i32;
    var phi_523_: i32;
    var phi_528_: i32;
    var phi_533_: i32;
    var phi_542_: i32;
    var phi_547_: i32;
    var phi_552_: i32;
    var phi_557_: i32;
    var phi_598_: evaluate_Verdict;
    var phi_599_: evaluate_Verdict;
    var phi_600_: bool;
    var phi_601_: evaluate_Verdict;
    var phi_602_: evaluate_Verdict;
    var phi_603_: bool;
    var phi_607_: evaluate_Verdict;

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
                phi_232_ = (_e74 == _e76);
                phi_233_ = false;
            } else {
                phi_232_ = bool();
                phi_233_ = true;
            }
            let _e79 = phi_232_;
            let _e81 = phi_233_;
            phi_234_ = _e79;
            phi_235_ = _e81;
        } else {
            phi_234_ = bool();
            phi_235_ = true;
        }
        let _e83 = phi_234_;
        let _e85 = phi_235_;
        if _e85 {
            phi_239_ = false;
        } else {
            phi_239_ = _e83;
        }
        let _e87 = phi_239_;
        if !(_e87) {
            let _e90 = samples.member[(0u + _e52.first_primitive)].normal;
            let _e92 = samples.member[(0u + _e52.first_primitive)].position;
            if ((((_e90.x * (_e61.x - (_e92.x * _e61.w))) + (_e90.y * (_e61.y - (_e92.y * _e61.w)))) + (_e90.z * (_e61.z - (_e92.z * _e61.w)))) > 0f) {
                let _e116 = samples.member[(0u + _e52.first_primitive)].flags;
                let _e124 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e130 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e124.unnamed.visibility, false), _e124.unnamed_1);
                phi_283_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e130.unnamed, ((_e116 & 1u) == 0u));
            } else {
                let _e139 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e145 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e139.unnamed.visibility, false), _e139.unnamed_1);
                phi_283_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e145.unnamed, true);
            }
            let _e150 = phi_283_;
            phi_287_ = _e150;
        } else {
            let _e156 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e162 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e156.unnamed.visibility, false), _e156.unnamed_1);
            phi_287_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e162.unnamed, true);
        }
        let _e167 = phi_287_;
        if _e167.unnamed_1 {
            phi_601_ = evaluate_Verdict(_e167.unnamed.visibility, _e167.unnamed.is_doubted);
            phi_602_ = evaluate_Verdict();
            phi_603_ = true;
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
                    phi_364_ = (_e206 <= 1f);
                } else {
                    phi_364_ = false;
                }
                let _e238 = phi_364_;
                if _e238 {
                    if (_e220 >= 0f) {
                        phi_373_ = (_e220 <= 1f);
                    } else {
                        phi_373_ = false;
                    }
                    let _e242 = phi_373_;
                    if _e242 {
                        if (_e233 >= 0f) {
                            phi_382_ = (_e233 <= 1f);
                        } else {
                            phi_382_ = false;
                        }
                        let _e246 = phi_382_;
                        phi_383_ = _e246;
                        phi_384_ = false;
                    } else {
                        phi_383_ = bool();
                        phi_384_ = true;
                    }
                    let _e248 = phi_383_;
                    let _e250 = phi_384_;
                    phi_385_ = _e248;
                    phi_386_ = _e250;
                } else {
                    phi_385_ = bool();
                    phi_386_ = true;
                }
                let _e252 = phi_385_;
                let _e254 = phi_386_;
                phi_387_ = _e252;
                phi_388_ = _e254;
            } else {
                phi_387_ = bool();
                phi_388_ = true;
            }
            let _e256 = phi_387_;
            let _e258 = phi_388_;
            if _e258 {
                phi_392_ = false;
            } else {
                phi_392_ = _e256;
            }
            let _e260 = phi_392_;
            if _e260 {
                let _e262 = p.member.map_size;
                let _e263 = f32(_e262);
                let _e266 = ((_e206 * _e263) - 0.5f);
                let _e267 = ((_e220 * _e263) - 0.5f);
                if (_e266 > -8388608f) {
                    let _e279 = f32(select(0i, select(select(i32(_e266), i32(-2147483648), (_e266 < bitcast<f32>(3472883712u))), 2147483647i, (_e266 > bitcast<f32>(1325400063u))), (_e266 == _e266)));
                    if (_e279 > _e266) {
                        phi_428_ = 1f;
                    } else {
                        phi_428_ = 0f;
                    }
                    let _e282 = phi_428_;
                    if (_e266 < 8388608f) {
                        phi_433_ = (_e279 - _e282);
                        phi_434_ = false;
                    } else {
                        phi_433_ = f32();
                        phi_434_ = true;
                    }
                    let _e285 = phi_433_;
                    let _e287 = phi_434_;
                    phi_435_ = _e285;
                    phi_436_ = _e287;
                } else {
                    phi_435_ = f32();
                    phi_436_ = true;
                }
                let _e289 = phi_435_;
                let _e291 = phi_436_;
                if _e291 {
                    phi_440_ = _e266;
                } else {
                    phi_440_ = _e289;
                }
                let _e293 = phi_440_;
                if (_e267 > -8388608f) {
                    let _e305 = f32(select(0i, select(select(i32(_e267), i32(-2147483648), (_e267 < bitcast<f32>(3472883712u))), 2147483647i, (_e267 > bitcast<f32>(1325400063u))), (_e267 == _e267)));
                    if (_e305 > _e267) {
                        phi_460_ = 1f;
                    } else {
                        phi_460_ = 0f;
                    }
                    let _e308 = phi_460_;
                    if (_e267 < 8388608f) {
                        phi_465_ = (_e305 - _e308);
                        phi_466_ = false;
                    } else {
                        phi_465_ = f32();
                        phi_466_ = true;
                    }
                    let _e311 = phi_465_;
                    let _e313 = phi_466_;
                    phi_467_ = _e311;
                    phi_468_ = _e313;
                } else {
                    phi_467_ = f32();
                    phi_468_ = true;
                }
                let _e315 = phi_467_;
                let _e317 = phi_468_;
                if _e317 {
                    phi_472_ = _e267;
                } else {
                    phi_472_ = _e315;
                }
                let _e319 = phi_472_;
                let _e320 = (_e266 - _e293);
                let _e321 = (_e267 - _e319);
                let _e330 = select(0i, select(select(i32(_e293), i32(-2147483648), (_e293 < bitcast<f32>(3472883712u))), 2147483647i, (_e293 > bitcast<f32>(1325400063u))), (_e293 == _e293));
                let _e339 = select(0i, select(select(i32(_e319), i32(-2147483648), (_e319 < bitcast<f32>(3472883712u))), 2147483647i, (_e319 > bitcast<f32>(1325400063u))), (_e319 == _e319));
                let _e350 = p.member.test;
                let _e351 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e350);
                let _e353 = p.member.map_size;
                local_1 = _e351;
                let _e355 = (bitcast<i32>(_e353) - 1i);
                if (_e330 > 0i) {
                    phi_518_ = _e330;
                } else {
                    phi_518_ = 0i;
                }
                let _e358 = phi_518_;
                if (_e339 > 0i) {
                    phi_523_ = _e339;
                } else {
                    phi_523_ = 0i;
                }
                let _e361 = phi_523_;
                if (_e358 < _e355) {
                    phi_528_ = _e358;
                } else {
                    phi_528_ = _e355;
                }
                let _e364 = phi_528_;
                if (_e361 < _e355) {
                    phi_533_ = _e361;
                } else {
                    phi_533_ = _e355;
                }
                let _e367 = phi_533_;
                let _e368 = bitcast<u32>(_e364);
                let _e370 = (_e330 + 1i);
                let _e371 = (_e339 + 1i);
                if (_e370 > 0i) {
                    phi_542_ = _e370;
                } else {
                    phi_542_ = 0i;
                }
                let _e374 = phi_542_;
                if (_e371 > 0i) {
                    phi_547_ = _e371;
                } else {
                    phi_547_ = 0i;
                }
                let _e377 = phi_547_;
                if (_e374 < _e355) {
                    phi_552_ = _e374;
                } else {
                    phi_552_ = _e355;
                }
                let _e380 = phi_552_;
                if (_e377 < _e355) {
                    phi_557_ = _e377;
                } else {
                    phi_557_ = _e355;
                }
                let _e383 = phi_557_;
                let _e384 = bitcast<u32>(_e380);
                let _e386 = (bitcast<u32>(_e367) * _e353);
                let _e387 = (bitcast<u32>(_e383) * _e353);
                let _e388 = (_e386 + _e368);
                let _e389 = (_e386 + _e384);
                let _e390 = (_e387 + _e368);
                let _e391 = (_e387 + _e384);
                if (_e388 < _e43) {
                } else {
                    return;
                }
                let _e395 = map.member[(0u + _e388)];
                if (_e389 < _e43) {
                } else {
                    return;
                }
                let _e399 = map.member[(0u + _e389)];
                if (_e390 < _e43) {
                } else {
                    return;
                }
                let _e403 = map.member[(0u + _e390)];
                if (_e391 < _e43) {
                } else {
                    return;
                }
                let _e407 = map.member[(0u + _e391)];
                let _e409 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local_1), vec4<f32>(_e395, _e399, _e403, _e407), vec4<f32>(((1f - _e320) * (1f - _e321)), (_e320 * (1f - _e321)), ((1f - _e320) * _e321), (_e320 * _e321)), _e233);
                phi_598_ = evaluate_Verdict(_e409, false);
                phi_599_ = evaluate_Verdict();
                phi_600_ = false;
            } else {
                phi_598_ = evaluate_Verdict();
                phi_599_ = evaluate_Verdict(1f, false);
                phi_600_ = true;
            }
            let _e413 = phi_598_;
            let _e415 = phi_599_;
            let _e417 = phi_600_;
            phi_601_ = _e415;
            phi_602_ = _e413;
            phi_603_ = _e417;
        }
        let _e419 = phi_601_;
        let _e421 = phi_602_;
        let _e423 = phi_603_;
        if _e423 {
            phi_607_ = _e419;
        } else {
            phi_607_ = _e421;
        }
        let _e425 = phi_607_;
        if (_e52.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e52.first_primitive)] = _e425.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_msm_hausdorff_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
