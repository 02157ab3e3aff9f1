struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_9 {
    member: array<abi_Sample>,
}

struct type_13 {
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

struct type_29 {
    member: abi_ShadowParams,
}

struct hankel_HankelFactors {
    moments: vec4<f32>,
    d22_: f32,
    l32_d22_: f32,
    d33_d22_: f32,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_29;
@group(0) @binding(2) 
var<storage> map: type_13;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_13;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_139_: lt_bvh_traverse_Tree;
    var phi_140_: bool;
    var phi_141_: lt_bvh_traverse_Tree;
    var phi_142_: bool;
    var phi_147_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_139_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_140_ = false;
        } else {
            phi_139_ = lt_bvh_traverse_Tree();
            phi_140_ = true;
        }
        let _e49 = phi_139_;
        let _e51 = phi_140_;
        phi_141_ = _e49;
        phi_142_ = _e51;
    } else {
        phi_141_ = lt_bvh_traverse_Tree();
        phi_142_ = true;
    }
    let _e53 = phi_141_;
    let _e55 = phi_142_;
    if _e55 {
        phi_147_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_147_ = _e53;
    }
    let _e60 = phi_147_;
    return lt_bvh_traverse_Tree(_e60.root, _e60.first_primitive);
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_4: f32) -> vec4<f32> {
    var phi_170_: f32;
    var phi_171_: f32;
    var phi_172_: f32;

    if ((bitcast<u32>(param_4) & 2147483647u) > 2139095040u) {
        phi_172_ = param_4;
    } else {
        if (param_4 < 0f) {
            phi_171_ = 0f;
        } else {
            if (param_4 > 1f) {
                phi_170_ = 1f;
            } else {
                phi_170_ = param_4;
            }
            let _e43 = phi_170_;
            phi_171_ = _e43;
        }
        let _e45 = phi_171_;
        phi_172_ = _e45;
    }
    let _e47 = phi_172_;
    let _e48 = (_e47 * _e47);
    return vec4<f32>(_e47, _e48, (_e48 * _e47), (_e48 * _e48));
}

fn lt_math_hausdorff_cubic_mass(param_5: vec4<f32>, param_6: f32, param_7: f32, param_8: f32, param_9: f32) -> f32 {
    return ((((param_5.z - (((param_7 + param_8) + param_9) * param_5.y)) + ((((param_7 * param_8) + (param_7 * param_9)) + (param_8 * param_9)) * param_5.x)) - ((param_7 * param_8) * param_9)) / (((param_6 - param_7) * (param_6 - param_8)) * (param_6 - param_9)));
}

fn lt_math_hausdorff_endpoint_upper_bound(param_10: ptr<function, hankel_HankelFactors>, param_11: f32) -> f32 {
    var phi_1514_: f32;
    var phi_1515_: f32;
    var phi_1516_: f32;
    var phi_1543_: f32;
    var phi_1544_: f32;
    var phi_1545_: f32;
    var phi_1546_: f32;
    var phi_1547_: bool;
    var phi_1548_: f32;
    var phi_1549_: bool;
    var phi_1577_: f32;
    var phi_1578_: f32;
    var phi_1579_: f32;
    var phi_1580_: f32;
    var phi_1581_: bool;
    var phi_1582_: f32;
    var phi_1583_: bool;
    var phi_1590_: f32;
    var phi_1591_: f32;
    var phi_1592_: f32;
    var phi_1593_: f32;

    let _e39 = (*param_10).moments;
    if (param_11 < 0.0001f) {
        phi_1593_ = 1f;
    } else {
        let _e48 = ((_e39.z - ((1f + param_11) * _e39.y)) + (param_11 * _e39.x));
        let _e57 = (((_e39.w - ((1f + param_11) * _e39.z)) + (param_11 * _e39.y)) / _e48);
        if (abs(_e48) <= 0.00000047683716f) {
            let _e71 = (1f - (((_e39.y - (_e39.x * (param_11 + 1f))) + (param_11 * 1f)) / ((0f - param_11) * (0f - 1f))));
            if ((bitcast<u32>(_e71) & 2147483647u) > 2139095040u) {
                phi_1516_ = _e71;
            } else {
                if (_e71 < 0f) {
                    phi_1515_ = 0f;
                } else {
                    if (_e71 > 1f) {
                        phi_1514_ = 1f;
                    } else {
                        phi_1514_ = _e71;
                    }
                    let _e78 = phi_1514_;
                    phi_1515_ = _e78;
                }
                let _e80 = phi_1515_;
                phi_1516_ = _e80;
            }
            let _e82 = phi_1516_;
            phi_1592_ = _e82;
        } else {
            if (_e57 > 0f) {
                if (_e57 < param_11) {
                    let _e85 = lt_math_hausdorff_cubic_mass(_e39, 0f, _e57, param_11, 1f);
                    let _e87 = lt_math_hausdorff_cubic_mass(_e39, _e57, 0f, param_11, 1f);
                    let _e88 = ((1f - _e85) - _e87);
                    if ((bitcast<u32>(_e88) & 2147483647u) > 2139095040u) {
                        phi_1545_ = _e88;
                    } else {
                        if (_e88 < 0f) {
                            phi_1544_ = 0f;
                        } else {
                            if (_e88 > 1f) {
                                phi_1543_ = 1f;
                            } else {
                                phi_1543_ = _e88;
                            }
                            let _e95 = phi_1543_;
                            phi_1544_ = _e95;
                        }
                        let _e97 = phi_1544_;
                        phi_1545_ = _e97;
                    }
                    let _e99 = phi_1545_;
                    phi_1546_ = _e99;
                    phi_1547_ = false;
                } else {
                    phi_1546_ = f32();
                    phi_1547_ = true;
                }
                let _e101 = phi_1546_;
                let _e103 = phi_1547_;
                phi_1548_ = _e101;
                phi_1549_ = _e103;
            } else {
                phi_1548_ = f32();
                phi_1549_ = true;
            }
            let _e105 = phi_1548_;
            let _e107 = phi_1549_;
            if _e107 {
                if (_e57 > param_11) {
                    if (_e57 < 1f) {
                        let _e110 = lt_math_hausdorff_cubic_mass(_e39, 0f, _e57, param_11, 1f);
                        let _e111 = (1f - _e110);
                        if ((bitcast<u32>(_e111) & 2147483647u) > 2139095040u) {
                            phi_1579_ = _e111;
                        } else {
                            if (_e111 < 0f) {
                                phi_1578_ = 0f;
                            } else {
                                if (_e111 > 1f) {
                                    phi_1577_ = 1f;
                                } else {
                                    phi_1577_ = _e111;
                                }
                                let _e118 = phi_1577_;
                                phi_1578_ = _e118;
                            }
                            let _e120 = phi_1578_;
                            phi_1579_ = _e120;
                        }
                        let _e122 = phi_1579_;
                        phi_1580_ = _e122;
                        phi_1581_ = false;
                    } else {
                        phi_1580_ = f32();
                        phi_1581_ = true;
                    }
                    let _e124 = phi_1580_;
                    let _e126 = phi_1581_;
                    phi_1582_ = _e124;
                    phi_1583_ = _e126;
                } else {
                    phi_1582_ = f32();
                    phi_1583_ = true;
                }
                let _e128 = phi_1582_;
                let _e130 = phi_1583_;
                if _e130 {
                    phi_1590_ = bitcast<f32>((bitcast<u32>(_e57) | 2143289344u));
                } else {
                    phi_1590_ = _e128;
                }
                let _e135 = phi_1590_;
                phi_1591_ = _e135;
            } else {
                phi_1591_ = _e105;
            }
            let _e137 = phi_1591_;
            phi_1592_ = _e137;
        }
        let _e139 = phi_1592_;
        phi_1593_ = _e139;
    }
    let _e141 = phi_1593_;
    return _e141;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_12: ptr<function, f32>, param_13: vec4<f32>, param_14: f32) -> f32 {
    var local: hankel_HankelFactors;
    var phi_801_: f32;
    var phi_802_: f32;
    var phi_803_: f32;
    var phi_815_: bool;
    var phi_830_: bool;
    var phi_855_: f32;
    var phi_856_: f32;
    var phi_857_: f32;
    var phi_858_: f32;
    var phi_859_: bool;
    var phi_860_: f32;
    var phi_861_: bool;
    var phi_917_: vec2<f32>;
    var phi_955_: f32;
    var phi_956_: f32;
    var phi_957_: f32;
    var phi_990_: f32;
    var phi_991_: f32;
    var phi_992_: f32;
    var phi_996_: f32;
    var phi_997_: f32;
    var phi_998_: f32;
    var phi_999_: f32;
    var phi_1052_: vec2<f32>;
    var phi_1074_: bool;
    var phi_1099_: f32;
    var phi_1100_: f32;
    var phi_1101_: f32;
    var phi_1102_: f32;
    var phi_1103_: bool;
    var phi_1104_: f32;
    var phi_1105_: bool;
    var phi_1161_: vec2<f32>;
    var phi_1199_: f32;
    var phi_1200_: f32;
    var phi_1201_: f32;
    var phi_1234_: f32;
    var phi_1235_: f32;
    var phi_1236_: f32;
    var phi_1240_: f32;
    var phi_1241_: f32;
    var phi_1242_: f32;
    var phi_1243_: f32;
    var phi_1244_: f32;
    var phi_1245_: bool;
    var phi_1246_: f32;
    var phi_1247_: bool;
    var phi_1269_: bool;
    var phi_1294_: f32;
    var phi_1295_: f32;
    var phi_1296_: f32;
    var phi_1297_: f32;
    var phi_1298_: bool;
    var phi_1299_: f32;
    var phi_1300_: bool;
    var phi_1356_: vec2<f32>;
    var phi_1394_: f32;
    var phi_1395_: f32;
    var phi_1396_: f32;
    var phi_1429_: f32;
    var phi_1430_: f32;
    var phi_1431_: f32;
    var phi_1435_: f32;
    var phi_1436_: f32;
    var phi_1437_: f32;
    var phi_1438_: f32;
    var phi_1449_: bool;
    var phi_1453_: f32;
    var phi_1454_: f32;
    var phi_1455_: f32;
    var phi_1456_: f32;

    let _e40 = (*param_12);
    let _e41 = (1f - _e40);
    let _e50 = (0.5f * _e40);
    let _e51 = ((param_13.x * _e41) + _e50);
    let _e52 = ((param_13.y * _e41) + _e50);
    let _e53 = ((param_13.z * _e41) + _e50);
    let _e54 = ((param_13.w * _e41) + _e50);
    let _e57 = (_e52 - (_e51 * _e51));
    let _e59 = (_e53 - (_e51 * _e52));
    let _e65 = hankel_HankelFactors(vec4<f32>(_e51, _e52, _e53, _e54), _e57, _e59, (((_e54 - (_e52 * _e52)) * _e57) - (_e59 * _e59)));
    local = hankel_HankelFactors(_e65.moments, _e65.d22_, _e65.l32_d22_, _e65.d33_d22_);
    if ((bitcast<u32>(param_14) & 2147483647u) > 2139095040u) {
        phi_803_ = param_14;
    } else {
        if (param_14 < 0f) {
            phi_802_ = 0f;
        } else {
            if (param_14 > 1f) {
                phi_801_ = 1f;
            } else {
                phi_801_ = param_14;
            }
            let _e77 = phi_801_;
            phi_802_ = _e77;
        }
        let _e79 = phi_802_;
        phi_803_ = _e79;
    }
    let _e81 = phi_803_;
    let _e84 = local.moments[0u];
    let _e87 = local.moments[3u];
    if (_e84 == _e87) {
        let _e91 = local.moments[0u];
        phi_815_ = (_e91 > 0.5f);
    } else {
        phi_815_ = false;
    }
    let _e94 = phi_815_;
    if _e94 {
        let _e97 = local.moments[0u];
        let _e100 = local.moments[3u];
        if (_e97 == _e100) {
            let _e104 = local.moments[0u];
            phi_830_ = (_e104 > 0.5f);
        } else {
            phi_830_ = false;
        }
        let _e107 = phi_830_;
        if _e107 {
            if (_e81 > 0f) {
                let _e110 = local.moments;
                if ((bitcast<u32>(_e110.x) & 2147483647u) > 2139095040u) {
                    phi_857_ = _e110.x;
                } else {
                    if (_e110.x < 0f) {
                        phi_856_ = 0f;
                    } else {
                        if (_e110.x > 1f) {
                            phi_855_ = 1f;
                        } else {
                            phi_855_ = _e110.x;
                        }
                        let _e118 = phi_855_;
                        phi_856_ = _e118;
                    }
                    let _e120 = phi_856_;
                    phi_857_ = _e120;
                }
                let _e122 = phi_857_;
                phi_858_ = _e122;
                phi_859_ = false;
            } else {
                phi_858_ = f32();
                phi_859_ = true;
            }
            let _e124 = phi_858_;
            let _e126 = phi_859_;
            phi_860_ = _e124;
            phi_861_ = _e126;
        } else {
            phi_860_ = f32();
            phi_861_ = true;
        }
        let _e128 = phi_860_;
        let _e130 = phi_861_;
        if _e130 {
            let _e133 = local.moments[0u];
            let _e136 = local.moments[1u];
            let _e144 = local.l32_d22_;
            let _e146 = local.d22_;
            let _e147 = (_e144 / _e146);
            let _e148 = (_e81 - _e133);
            let _e154 = local.d22_;
            let _e157 = local.d33_d22_;
            let _e158 = (((((_e81 * _e81) - _e136) - (_e147 * _e148)) * _e154) / _e157);
            let _e160 = local.d22_;
            let _e163 = ((_e148 / _e160) - (_e147 * _e158));
            let _e169 = ((0.5f * _e163) / _e158);
            let _e172 = ((_e169 * _e169) - (((1f - (_e163 * _e133)) - (_e158 * _e136)) / _e158));
            if (_e172 >= 0f) {
                let _e174 = sqrt(_e172);
                phi_917_ = vec2<f32>((-(_e169) - _e174), (-(_e169) + _e174));
            } else {
                phi_917_ = vec2(bitcast<f32>((bitcast<u32>(_e172) | 2143289344u)));
            }
            let _e185 = phi_917_;
            if (_e81 <= _e185.x) {
                phi_998_ = 1f;
            } else {
                if (_e81 > _e185.y) {
                    let _e191 = local.moments;
                    let _e202 = (((_e191.y - (_e191.x * (_e185.x + _e185.y))) + (_e185.x * _e185.y)) / ((_e81 - _e185.x) * (_e81 - _e185.y)));
                    if ((bitcast<u32>(_e202) & 2147483647u) > 2139095040u) {
                        phi_957_ = _e202;
                    } else {
                        if (_e202 < 0f) {
                            phi_956_ = 0f;
                        } else {
                            if (_e202 > 1f) {
                                phi_955_ = 1f;
                            } else {
                                phi_955_ = _e202;
                            }
                            let _e209 = phi_955_;
                            phi_956_ = _e209;
                        }
                        let _e211 = phi_956_;
                        phi_957_ = _e211;
                    }
                    let _e213 = phi_957_;
                    phi_997_ = _e213;
                } else {
                    if (_e81 > _e185.x) {
                        let _e216 = local.moments;
                        let _e228 = (1f - (((_e216.y - (_e216.x * (_e81 + _e185.y))) + (_e81 * _e185.y)) / ((_e185.x - _e81) * (_e185.x - _e185.y))));
                        if ((bitcast<u32>(_e228) & 2147483647u) > 2139095040u) {
                            phi_992_ = _e228;
                        } else {
                            if (_e228 < 0f) {
                                phi_991_ = 0f;
                            } else {
                                if (_e228 > 1f) {
                                    phi_990_ = 1f;
                                } else {
                                    phi_990_ = _e228;
                                }
                                let _e235 = phi_990_;
                                phi_991_ = _e235;
                            }
                            let _e237 = phi_991_;
                            phi_992_ = _e237;
                        }
                        let _e239 = phi_992_;
                        phi_996_ = _e239;
                    } else {
                        phi_996_ = bitcast<f32>((bitcast<u32>(_e185.x) | 2143289344u));
                    }
                    let _e244 = phi_996_;
                    phi_997_ = _e244;
                }
                let _e246 = phi_997_;
                phi_998_ = _e246;
            }
            let _e248 = phi_998_;
            phi_999_ = _e248;
        } else {
            phi_999_ = _e128;
        }
        let _e250 = phi_999_;
        phi_1456_ = _e250;
    } else {
        let _e253 = local.moments[0u];
        let _e256 = local.moments[1u];
        let _e264 = local.l32_d22_;
        let _e266 = local.d22_;
        let _e267 = (_e264 / _e266);
        let _e268 = (_e81 - _e253);
        let _e274 = local.d22_;
        let _e277 = local.d33_d22_;
        let _e278 = (((((_e81 * _e81) - _e256) - (_e267 * _e268)) * _e274) / _e277);
        let _e280 = local.d22_;
        let _e283 = ((_e268 / _e280) - (_e267 * _e278));
        let _e289 = ((0.5f * _e283) / _e278);
        let _e292 = ((_e289 * _e289) - (((1f - (_e283 * _e253)) - (_e278 * _e256)) / _e278));
        if (_e292 >= 0f) {
            let _e294 = sqrt(_e292);
            phi_1052_ = vec2<f32>((-(_e289) - _e294), (-(_e289) + _e294));
        } else {
            phi_1052_ = vec2(bitcast<f32>((bitcast<u32>(_e292) | 2143289344u)));
        }
        let _e305 = phi_1052_;
        if (_e305.x >= 0f) {
            if (_e305.y <= 1f) {
                let _e312 = local.moments[0u];
                let _e315 = local.moments[3u];
                if (_e312 == _e315) {
                    let _e319 = local.moments[0u];
                    phi_1074_ = (_e319 > 0.5f);
                } else {
                    phi_1074_ = false;
                }
                let _e322 = phi_1074_;
                if _e322 {
                    if (_e81 > 0f) {
                        let _e325 = local.moments;
                        if ((bitcast<u32>(_e325.x) & 2147483647u) > 2139095040u) {
                            phi_1101_ = _e325.x;
                        } else {
                            if (_e325.x < 0f) {
                                phi_1100_ = 0f;
                            } else {
                                if (_e325.x > 1f) {
                                    phi_1099_ = 1f;
                                } else {
                                    phi_1099_ = _e325.x;
                                }
                                let _e333 = phi_1099_;
                                phi_1100_ = _e333;
                            }
                            let _e335 = phi_1100_;
                            phi_1101_ = _e335;
                        }
                        let _e337 = phi_1101_;
                        phi_1102_ = _e337;
                        phi_1103_ = false;
                    } else {
                        phi_1102_ = f32();
                        phi_1103_ = true;
                    }
                    let _e339 = phi_1102_;
                    let _e341 = phi_1103_;
                    phi_1104_ = _e339;
                    phi_1105_ = _e341;
                } else {
                    phi_1104_ = f32();
                    phi_1105_ = true;
                }
                let _e343 = phi_1104_;
                let _e345 = phi_1105_;
                if _e345 {
                    let _e348 = local.moments[0u];
                    let _e351 = local.moments[1u];
                    let _e359 = local.l32_d22_;
                    let _e361 = local.d22_;
                    let _e362 = (_e359 / _e361);
                    let _e363 = (_e81 - _e348);
                    let _e369 = local.d22_;
                    let _e372 = local.d33_d22_;
                    let _e373 = (((((_e81 * _e81) - _e351) - (_e362 * _e363)) * _e369) / _e372);
                    let _e375 = local.d22_;
                    let _e378 = ((_e363 / _e375) - (_e362 * _e373));
                    let _e384 = ((0.5f * _e378) / _e373);
                    let _e387 = ((_e384 * _e384) - (((1f - (_e378 * _e348)) - (_e373 * _e351)) / _e373));
                    if (_e387 >= 0f) {
                        let _e389 = sqrt(_e387);
                        phi_1161_ = vec2<f32>((-(_e384) - _e389), (-(_e384) + _e389));
                    } else {
                        phi_1161_ = vec2(bitcast<f32>((bitcast<u32>(_e387) | 2143289344u)));
                    }
                    let _e400 = phi_1161_;
                    if (_e81 <= _e400.x) {
                        phi_1242_ = 1f;
                    } else {
                        if (_e81 > _e400.y) {
                            let _e406 = local.moments;
                            let _e417 = (((_e406.y - (_e406.x * (_e400.x + _e400.y))) + (_e400.x * _e400.y)) / ((_e81 - _e400.x) * (_e81 - _e400.y)));
                            if ((bitcast<u32>(_e417) & 2147483647u) > 2139095040u) {
                                phi_1201_ = _e417;
                            } else {
                                if (_e417 < 0f) {
                                    phi_1200_ = 0f;
                                } else {
                                    if (_e417 > 1f) {
                                        phi_1199_ = 1f;
                                    } else {
                                        phi_1199_ = _e417;
                                    }
                                    let _e424 = phi_1199_;
                                    phi_1200_ = _e424;
                                }
                                let _e426 = phi_1200_;
                                phi_1201_ = _e426;
                            }
                            let _e428 = phi_1201_;
                            phi_1241_ = _e428;
                        } else {
                            if (_e81 > _e400.x) {
                                let _e431 = local.moments;
                                let _e443 = (1f - (((_e431.y - (_e431.x * (_e81 + _e400.y))) + (_e81 * _e400.y)) / ((_e400.x - _e81) * (_e400.x - _e400.y))));
                                if ((bitcast<u32>(_e443) & 2147483647u) > 2139095040u) {
                                    phi_1236_ = _e443;
                                } else {
                                    if (_e443 < 0f) {
                                        phi_1235_ = 0f;
                                    } else {
                                        if (_e443 > 1f) {
                                            phi_1234_ = 1f;
                                        } else {
                                            phi_1234_ = _e443;
                                        }
                                        let _e450 = phi_1234_;
                                        phi_1235_ = _e450;
                                    }
                                    let _e452 = phi_1235_;
                                    phi_1236_ = _e452;
                                }
                                let _e454 = phi_1236_;
                                phi_1240_ = _e454;
                            } else {
                                phi_1240_ = bitcast<f32>((bitcast<u32>(_e400.x) | 2143289344u));
                            }
                            let _e459 = phi_1240_;
                            phi_1241_ = _e459;
                        }
                        let _e461 = phi_1241_;
                        phi_1242_ = _e461;
                    }
                    let _e463 = phi_1242_;
                    phi_1243_ = _e463;
                } else {
                    phi_1243_ = _e343;
                }
                let _e465 = phi_1243_;
                phi_1244_ = _e465;
                phi_1245_ = false;
            } else {
                phi_1244_ = f32();
                phi_1245_ = true;
            }
            let _e467 = phi_1244_;
            let _e469 = phi_1245_;
            phi_1246_ = _e467;
            phi_1247_ = _e469;
        } else {
            phi_1246_ = f32();
            phi_1247_ = true;
        }
        let _e471 = phi_1246_;
        let _e473 = phi_1247_;
        if _e473 {
            if ((bitcast<u32>(_e305.x) & 2147483647u) > 2139095040u) {
                phi_1454_ = _e305.x;
            } else {
                let _e477 = lt_math_hausdorff_endpoint_upper_bound((&local), _e81);
                let _e480 = local.moments[0u];
                let _e483 = local.moments[3u];
                if (_e480 == _e483) {
                    let _e487 = local.moments[0u];
                    phi_1269_ = (_e487 > 0.5f);
                } else {
                    phi_1269_ = false;
                }
                let _e490 = phi_1269_;
                if _e490 {
                    if (_e81 > 0f) {
                        let _e493 = local.moments;
                        if ((bitcast<u32>(_e493.x) & 2147483647u) > 2139095040u) {
                            phi_1296_ = _e493.x;
                        } else {
                            if (_e493.x < 0f) {
                                phi_1295_ = 0f;
                            } else {
                                if (_e493.x > 1f) {
                                    phi_1294_ = 1f;
                                } else {
                                    phi_1294_ = _e493.x;
                                }
                                let _e501 = phi_1294_;
                                phi_1295_ = _e501;
                            }
                            let _e503 = phi_1295_;
                            phi_1296_ = _e503;
                        }
                        let _e505 = phi_1296_;
                        phi_1297_ = _e505;
                        phi_1298_ = false;
                    } else {
                        phi_1297_ = f32();
                        phi_1298_ = true;
                    }
                    let _e507 = phi_1297_;
                    let _e509 = phi_1298_;
                    phi_1299_ = _e507;
                    phi_1300_ = _e509;
                } else {
                    phi_1299_ = f32();
                    phi_1300_ = true;
                }
                let _e511 = phi_1299_;
                let _e513 = phi_1300_;
                if _e513 {
                    let _e516 = local.moments[0u];
                    let _e519 = local.moments[1u];
                    let _e527 = local.l32_d22_;
                    let _e529 = local.d22_;
                    let _e530 = (_e527 / _e529);
                    let _e531 = (_e81 - _e516);
                    let _e537 = local.d22_;
                    let _e540 = local.d33_d22_;
                    let _e541 = (((((_e81 * _e81) - _e519) - (_e530 * _e531)) * _e537) / _e540);
                    let _e543 = local.d22_;
                    let _e546 = ((_e531 / _e543) - (_e530 * _e541));
                    let _e552 = ((0.5f * _e546) / _e541);
                    let _e555 = ((_e552 * _e552) - (((1f - (_e546 * _e516)) - (_e541 * _e519)) / _e541));
                    if (_e555 >= 0f) {
                        let _e557 = sqrt(_e555);
                        phi_1356_ = vec2<f32>((-(_e552) - _e557), (-(_e552) + _e557));
                    } else {
                        phi_1356_ = vec2(bitcast<f32>((bitcast<u32>(_e555) | 2143289344u)));
                    }
                    let _e568 = phi_1356_;
                    if (_e81 <= _e568.x) {
                        phi_1437_ = 1f;
                    } else {
                        if (_e81 > _e568.y) {
                            let _e574 = local.moments;
                            let _e585 = (((_e574.y - (_e574.x * (_e568.x + _e568.y))) + (_e568.x * _e568.y)) / ((_e81 - _e568.x) * (_e81 - _e568.y)));
                            if ((bitcast<u32>(_e585) & 2147483647u) > 2139095040u) {
                                phi_1396_ = _e585;
                            } else {
                                if (_e585 < 0f) {
                                    phi_1395_ = 0f;
                                } else {
                                    if (_e585 > 1f) {
                                        phi_1394_ = 1f;
                                    } else {
                                        phi_1394_ = _e585;
                                    }
                                    let _e592 = phi_1394_;
                                    phi_1395_ = _e592;
                                }
                                let _e594 = phi_1395_;
                                phi_1396_ = _e594;
                            }
                            let _e596 = phi_1396_;
                            phi_1436_ = _e596;
                        } else {
                            if (_e81 > _e568.x) {
                                let _e599 = local.moments;
                                let _e611 = (1f - (((_e599.y - (_e599.x * (_e81 + _e568.y))) + (_e81 * _e568.y)) / ((_e568.x - _e81) * (_e568.x - _e568.y))));
                                if ((bitcast<u32>(_e611) & 2147483647u) > 2139095040u) {
                                    phi_1431_ = _e611;
                                } else {
                                    if (_e611 < 0f) {
                                        phi_1430_ = 0f;
                                    } else {
                                        if (_e611 > 1f) {
                                            phi_1429_ = 1f;
                                        } else {
                                            phi_1429_ = _e611;
                                        }
                                        let _e618 = phi_1429_;
                                        phi_1430_ = _e618;
                                    }
                                    let _e620 = phi_1430_;
                                    phi_1431_ = _e620;
                                }
                                let _e622 = phi_1431_;
                                phi_1435_ = _e622;
                            } else {
                                phi_1435_ = bitcast<f32>((bitcast<u32>(_e568.x) | 2143289344u));
                            }
                            let _e627 = phi_1435_;
                            phi_1436_ = _e627;
                        }
                        let _e629 = phi_1436_;
                        phi_1437_ = _e629;
                    }
                    let _e631 = phi_1437_;
                    phi_1438_ = _e631;
                } else {
                    phi_1438_ = _e511;
                }
                let _e633 = phi_1438_;
                if ((bitcast<u32>(_e633) & 2147483647u) > 2139095040u) {
                    phi_1449_ = true;
                } else {
                    let _e637 = (_e633 < _e477);
                    if _e637 {
                    }
                    phi_1449_ = _e637;
                }
                let _e639 = phi_1449_;
                if _e639 {
                    phi_1453_ = _e633;
                } else {
                    phi_1453_ = _e477;
                }
                let _e641 = phi_1453_;
                phi_1454_ = _e641;
            }
            let _e643 = phi_1454_;
            phi_1455_ = _e643;
        } else {
            phi_1455_ = _e471;
        }
        let _e645 = phi_1455_;
        phi_1456_ = _e645;
    }
    let _e647 = phi_1456_;
    return _e647;
}

fn function_() {
    var local_1: f32;
    var phi_230_: bool;
    var phi_231_: bool;
    var phi_232_: bool;
    var phi_233_: bool;
    var phi_237_: bool;
    var phi_281_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_285_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_362_: bool;
    var phi_371_: bool;
    var phi_380_: bool;
    var phi_381_: bool;
    var phi_382_: bool;
    var phi_383_: bool;
    var phi_384_: bool;
    var phi_385_: bool;
    var phi_386_: bool;
    var phi_390_: bool;
    var phi_484_: f32;
    var phi_487_: f32;
    var phi_516_: f32;
    var phi_521_: f32;
    var phi_522_: bool;
    var phi_523_: f32;
    var phi_524_: bool;
    var phi_528_: f32;
    var phi_548_: f32;
    var phi_553_: f32;
    var phi_554_: bool;
    var phi_555_: f32;
    var phi_556_: bool;
    var phi_560_: f32;
    var phi_606_: i32;
    var phi_611_: i32;
    var phi_616_: i32;
    var phi_621_: i32;
    var phi_630_: i32;
    var phi_635_: i32;
    var phi_640_: i32;
    var phi_645_: i32;
    var phi_734_: evaluate_Verdict;
    var phi_735_: evaluate_Verdict;
    var phi_736_: bool;
    var phi_737_: evaluate_Verdict;
    var phi_738_: evaluate_Verdict;
    var phi_739_: bool;
    var phi_743_: evaluate_Verdict;

    let _e37 = id_1;
    let _e44 = arrayLength((&map.member));
    let _e50 = p.member.size[0u];
    let _e52 = p.member.size[1u];
    let _e53 = lt_shaders_entry_pixel_index(_e37, _e50, _e52);
    if (bitcast<i32>(_e53.root) != 0i) {
        if (_e53.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e62 = p.member.light;
        let _e65 = samples.member[(0u + _e53.first_primitive)].normal[0u];
        let _e67 = global[0u];
        if (_e65 == _e67) {
            let _e70 = samples.member[(0u + _e53.first_primitive)].normal[1u];
            let _e72 = global[1u];
            if (_e70 == _e72) {
                let _e75 = samples.member[(0u + _e53.first_primitive)].normal[2u];
                let _e77 = global[2u];
                phi_230_ = (_e75 == _e77);
                phi_231_ = false;
            } else {
                phi_230_ = bool();
                phi_231_ = true;
            }
            let _e80 = phi_230_;
            let _e82 = phi_231_;
            phi_232_ = _e80;
            phi_233_ = _e82;
        } else {
            phi_232_ = bool();
            phi_233_ = true;
        }
        let _e84 = phi_232_;
        let _e86 = phi_233_;
        if _e86 {
            phi_237_ = false;
        } else {
            phi_237_ = _e84;
        }
        let _e88 = phi_237_;
        if !(_e88) {
            let _e91 = samples.member[(0u + _e53.first_primitive)].normal;
            let _e93 = samples.member[(0u + _e53.first_primitive)].position;
            if ((((_e91.x * (_e62.x - (_e93.x * _e62.w))) + (_e91.y * (_e62.y - (_e93.y * _e62.w)))) + (_e91.z * (_e62.z - (_e93.z * _e62.w)))) > 0f) {
                let _e117 = samples.member[(0u + _e53.first_primitive)].flags;
                let _e125 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e131 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e125.unnamed.visibility, false), _e125.unnamed_1);
                phi_281_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e131.unnamed, ((_e117 & 1u) == 0u));
            } else {
                let _e140 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e146 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e140.unnamed.visibility, false), _e140.unnamed_1);
                phi_281_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e146.unnamed, true);
            }
            let _e151 = phi_281_;
            phi_285_ = _e151;
        } else {
            let _e157 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e163 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e157.unnamed.visibility, false), _e157.unnamed_1);
            phi_285_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e163.unnamed, true);
        }
        let _e168 = phi_285_;
        if _e168.unnamed_1 {
            phi_737_ = evaluate_Verdict(_e168.unnamed.visibility, _e168.unnamed.is_doubted);
            phi_738_ = evaluate_Verdict();
            phi_739_ = true;
        } else {
            let _e176 = samples.member[(0u + _e53.first_primitive)].position;
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
                    phi_362_ = (_e207 <= 1f);
                } else {
                    phi_362_ = false;
                }
                let _e239 = phi_362_;
                if _e239 {
                    if (_e221 >= 0f) {
                        phi_371_ = (_e221 <= 1f);
                    } else {
                        phi_371_ = false;
                    }
                    let _e243 = phi_371_;
                    if _e243 {
                        if (_e234 >= 0f) {
                            phi_380_ = (_e234 <= 1f);
                        } else {
                            phi_380_ = false;
                        }
                        let _e247 = phi_380_;
                        phi_381_ = _e247;
                        phi_382_ = false;
                    } else {
                        phi_381_ = bool();
                        phi_382_ = true;
                    }
                    let _e249 = phi_381_;
                    let _e251 = phi_382_;
                    phi_383_ = _e249;
                    phi_384_ = _e251;
                } else {
                    phi_383_ = bool();
                    phi_384_ = true;
                }
                let _e253 = phi_383_;
                let _e255 = phi_384_;
                phi_385_ = _e253;
                phi_386_ = _e255;
            } else {
                phi_385_ = bool();
                phi_386_ = true;
            }
            let _e257 = phi_385_;
            let _e259 = phi_386_;
            if _e259 {
                phi_390_ = false;
            } else {
                phi_390_ = _e257;
            }
            let _e261 = phi_390_;
            if _e261 {
                if (0f > 0f) {
                    let _e264 = samples.member[(0u + _e53.first_primitive)].normal;
                    let _e266 = p.member.map_size;
                    let _e269 = p.member.projection.row_x;
                    let _e291 = p.member.projection.row_y;
                    let _e313 = p.member.projection.row_z;
                    let _e340 = ((abs(((((_e269.x * _e264.x) + (_e269.y * _e264.y)) + (_e269.z * _e264.z)) / (((_e269.x * _e269.x) + (_e269.y * _e269.y)) + (_e269.z * _e269.z)))) + abs(((((_e291.x * _e264.x) + (_e291.y * _e264.y)) + (_e291.z * _e264.z)) / (((_e291.x * _e291.x) + (_e291.y * _e291.y)) + (_e291.z * _e291.z))))) / (abs(((((_e313.x * _e264.x) + (_e313.y * _e264.y)) + (_e313.z * _e264.z)) / (((_e313.x * _e313.x) + (_e313.y * _e313.y)) + (_e313.z * _e313.z)))) * f32(_e266)));
                    if (_e340 < 0.002f) {
                        phi_484_ = _e340;
                    } else {
                        phi_484_ = 0.002f;
                    }
                    let _e343 = phi_484_;
                    phi_487_ = (_e234 - (0f * _e343));
                } else {
                    phi_487_ = _e234;
                }
                let _e347 = phi_487_;
                let _e349 = p.member.map_size;
                let _e350 = f32(_e349);
                let _e353 = ((_e207 * _e350) - 0.5f);
                let _e354 = ((_e221 * _e350) - 0.5f);
                if (_e353 > -8388608f) {
                    let _e366 = f32(select(0i, select(select(i32(_e353), i32(-2147483648), (_e353 < bitcast<f32>(3472883712u))), 2147483647i, (_e353 > bitcast<f32>(1325400063u))), (_e353 == _e353)));
                    if (_e366 > _e353) {
                        phi_516_ = 1f;
                    } else {
                        phi_516_ = 0f;
                    }
                    let _e369 = phi_516_;
                    if (_e353 < 8388608f) {
                        phi_521_ = (_e366 - _e369);
                        phi_522_ = false;
                    } else {
                        phi_521_ = f32();
                        phi_522_ = true;
                    }
                    let _e372 = phi_521_;
                    let _e374 = phi_522_;
                    phi_523_ = _e372;
                    phi_524_ = _e374;
                } else {
                    phi_523_ = f32();
                    phi_524_ = true;
                }
                let _e376 = phi_523_;
                let _e378 = phi_524_;
                if _e378 {
                    phi_528_ = _e353;
                } else {
                    phi_528_ = _e376;
                }
                let _e380 = phi_528_;
                if (_e354 > -8388608f) {
                    let _e392 = f32(select(0i, select(select(i32(_e354), i32(-2147483648), (_e354 < bitcast<f32>(3472883712u))), 2147483647i, (_e354 > bitcast<f32>(1325400063u))), (_e354 == _e354)));
                    if (_e392 > _e354) {
                        phi_548_ = 1f;
                    } else {
                        phi_548_ = 0f;
                    }
                    let _e395 = phi_548_;
                    if (_e354 < 8388608f) {
                        phi_553_ = (_e392 - _e395);
                        phi_554_ = false;
                    } else {
                        phi_553_ = f32();
                        phi_554_ = true;
                    }
                    let _e398 = phi_553_;
                    let _e400 = phi_554_;
                    phi_555_ = _e398;
                    phi_556_ = _e400;
                } else {
                    phi_555_ = f32();
                    phi_556_ = true;
                }
                let _e402 = phi_555_;
                let _e404 = phi_556_;
                if _e404 {
                    phi_560_ = _e354;
                } else {
                    phi_560_ = _e402;
                }
                let _e406 = phi_560_;
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
                local_1 = _e437;
                let _e441 = (bitcast<i32>(_e439) - 1i);
                if (_e417 > 0i) {
                    phi_606_ = _e417;
                } else {
                    phi_606_ = 0i;
                }
                let _e444 = phi_606_;
                if (_e426 > 0i) {
                    phi_611_ = _e426;
                } else {
                    phi_611_ = 0i;
                }
                let _e447 = phi_611_;
                if (_e444 < _e441) {
                    phi_616_ = _e444;
                } else {
                    phi_616_ = _e441;
                }
                let _e450 = phi_616_;
                if (_e447 < _e441) {
                    phi_621_ = _e447;
                } else {
                    phi_621_ = _e441;
                }
                let _e453 = phi_621_;
                let _e454 = bitcast<u32>(_e450);
                let _e456 = (_e417 + 1i);
                let _e457 = (_e426 + 1i);
                if (_e456 > 0i) {
                    phi_630_ = _e456;
                } else {
                    phi_630_ = 0i;
                }
                let _e460 = phi_630_;
                if (_e457 > 0i) {
                    phi_635_ = _e457;
                } else {
                    phi_635_ = 0i;
                }
                let _e463 = phi_635_;
                if (_e460 < _e441) {
                    phi_640_ = _e460;
                } else {
                    phi_640_ = _e441;
                }
                let _e466 = phi_640_;
                if (_e463 < _e441) {
                    phi_645_ = _e463;
                } else {
                    phi_645_ = _e441;
                }
                let _e469 = phi_645_;
                let _e470 = bitcast<u32>(_e466);
                let _e472 = (bitcast<u32>(_e453) * _e439);
                let _e473 = (bitcast<u32>(_e469) * _e439);
                let _e474 = (_e472 + _e454);
                let _e475 = (_e472 + _e470);
                let _e476 = (_e473 + _e454);
                let _e477 = (_e473 + _e470);
                if (_e474 < _e44) {
                } else {
                    return;
                }
                let _e481 = map.member[(0u + _e474)];
                if (_e475 < _e44) {
                } else {
                    return;
                }
                let _e485 = map.member[(0u + _e475)];
                if (_e476 < _e44) {
                } else {
                    return;
                }
                let _e489 = map.member[(0u + _e476)];
                if (_e477 < _e44) {
                } else {
                    return;
                }
                let _e493 = map.member[(0u + _e477)];
                let _e494 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(_e481);
                let _e495 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(_e485);
                let _e496 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(_e489);
                let _e497 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(_e493);
                let _e543 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_1), vec4<f32>(((((_e494.x * _e429) + (_e495.x * _e431)) + (_e496.x * _e433)) + (_e497.x * _e434)), ((((_e494.y * _e429) + (_e495.y * _e431)) + (_e496.y * _e433)) + (_e497.y * _e434)), ((((_e494.z * _e429) + (_e495.z * _e431)) + (_e496.z * _e433)) + (_e497.z * _e434)), ((((_e494.w * _e429) + (_e495.w * _e431)) + (_e496.w * _e433)) + (_e497.w * _e434))), _e347);
                phi_734_ = evaluate_Verdict(_e543, false);
                phi_735_ = evaluate_Verdict();
                phi_736_ = false;
            } else {
                phi_734_ = evaluate_Verdict();
                phi_735_ = evaluate_Verdict(1f, false);
                phi_736_ = true;
            }
            let _e547 = phi_734_;
            let _e549 = phi_735_;
            let _e551 = phi_736_;
            phi_737_ = _e549;
            phi_738_ = _e547;
            phi_739_ = _e551;
        }
        let _e553 = phi_737_;
        let _e555 = phi_738_;
        let _e557 = phi_739_;
        if _e557 {
            phi_743_ = _e553;
        } else {
            phi_743_ = _e555;
        }
        let _e559 = phi_743_;
        if (_e53.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e53.first_primitive)] = _e559.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_msm_hausdorff_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
