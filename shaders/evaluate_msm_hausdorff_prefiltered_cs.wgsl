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

struct type_28 {
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

struct type_32 {
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
var<storage> samples: type_9;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_32;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_13;
@group(0) @binding(2) 
var<storage> map: type_28;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_143_: lt_bvh_traverse_Tree;
    var phi_144_: bool;
    var phi_145_: lt_bvh_traverse_Tree;
    var phi_146_: bool;
    var phi_151_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_143_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_144_ = false;
        } else {
            phi_143_ = lt_bvh_traverse_Tree();
            phi_144_ = true;
        }
        let _e49 = phi_143_;
        let _e51 = phi_144_;
        phi_145_ = _e49;
        phi_146_ = _e51;
    } else {
        phi_145_ = lt_bvh_traverse_Tree();
        phi_146_ = true;
    }
    let _e53 = phi_145_;
    let _e55 = phi_146_;
    if _e55 {
        phi_151_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_151_ = _e53;
    }
    let _e60 = phi_151_;
    return lt_bvh_traverse_Tree(_e60.root, _e60.first_primitive);
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn lt_math_hausdorff_cubic_mass(param_4: vec4<f32>, param_5: f32, param_6: f32, param_7: f32, param_8: f32) -> f32 {
    return ((((param_4.z - (((param_6 + param_7) + param_8) * param_4.y)) + ((((param_6 * param_7) + (param_6 * param_8)) + (param_7 * param_8)) * param_4.x)) - ((param_6 * param_7) * param_8)) / (((param_5 - param_6) * (param_5 - param_7)) * (param_5 - param_8)));
}

fn lt_math_hausdorff_endpoint_upper_bound(param_9: ptr<function, hankel_HankelFactors>, param_10: f32) -> f32 {
    var phi_1493_: f32;
    var phi_1494_: f32;
    var phi_1495_: f32;
    var phi_1522_: f32;
    var phi_1523_: f32;
    var phi_1524_: f32;
    var phi_1525_: f32;
    var phi_1526_: bool;
    var phi_1527_: f32;
    var phi_1528_: bool;
    var phi_1556_: f32;
    var phi_1557_: f32;
    var phi_1558_: f32;
    var phi_1559_: f32;
    var phi_1560_: bool;
    var phi_1561_: f32;
    var phi_1562_: bool;
    var phi_1569_: f32;
    var phi_1570_: f32;
    var phi_1571_: f32;
    var phi_1572_: f32;

    let _e39 = (*param_9).moments;
    if (param_10 < 0.0001f) {
        phi_1572_ = 1f;
    } else {
        let _e48 = ((_e39.z - ((1f + param_10) * _e39.y)) + (param_10 * _e39.x));
        let _e57 = (((_e39.w - ((1f + param_10) * _e39.z)) + (param_10 * _e39.y)) / _e48);
        if (abs(_e48) <= 0.00000047683716f) {
            let _e71 = (1f - (((_e39.y - (_e39.x * (param_10 + 1f))) + (param_10 * 1f)) / ((0f - param_10) * (0f - 1f))));
            if ((bitcast<u32>(_e71) & 2147483647u) > 2139095040u) {
                phi_1495_ = _e71;
            } else {
                if (_e71 < 0f) {
                    phi_1494_ = 0f;
                } else {
                    if (_e71 > 1f) {
                        phi_1493_ = 1f;
                    } else {
                        phi_1493_ = _e71;
                    }
                    let _e78 = phi_1493_;
                    phi_1494_ = _e78;
                }
                let _e80 = phi_1494_;
                phi_1495_ = _e80;
            }
            let _e82 = phi_1495_;
            phi_1571_ = _e82;
        } else {
            if (_e57 > 0f) {
                if (_e57 < param_10) {
                    let _e85 = lt_math_hausdorff_cubic_mass(_e39, 0f, _e57, param_10, 1f);
                    let _e87 = lt_math_hausdorff_cubic_mass(_e39, _e57, 0f, param_10, 1f);
                    let _e88 = ((1f - _e85) - _e87);
                    if ((bitcast<u32>(_e88) & 2147483647u) > 2139095040u) {
                        phi_1524_ = _e88;
                    } else {
                        if (_e88 < 0f) {
                            phi_1523_ = 0f;
                        } else {
                            if (_e88 > 1f) {
                                phi_1522_ = 1f;
                            } else {
                                phi_1522_ = _e88;
                            }
                            let _e95 = phi_1522_;
                            phi_1523_ = _e95;
                        }
                        let _e97 = phi_1523_;
                        phi_1524_ = _e97;
                    }
                    let _e99 = phi_1524_;
                    phi_1525_ = _e99;
                    phi_1526_ = false;
                } else {
                    phi_1525_ = f32();
                    phi_1526_ = true;
                }
                let _e101 = phi_1525_;
                let _e103 = phi_1526_;
                phi_1527_ = _e101;
                phi_1528_ = _e103;
            } else {
                phi_1527_ = f32();
                phi_1528_ = true;
            }
            let _e105 = phi_1527_;
            let _e107 = phi_1528_;
            if _e107 {
                if (_e57 > param_10) {
                    if (_e57 < 1f) {
                        let _e110 = lt_math_hausdorff_cubic_mass(_e39, 0f, _e57, param_10, 1f);
                        let _e111 = (1f - _e110);
                        if ((bitcast<u32>(_e111) & 2147483647u) > 2139095040u) {
                            phi_1558_ = _e111;
                        } else {
                            if (_e111 < 0f) {
                                phi_1557_ = 0f;
                            } else {
                                if (_e111 > 1f) {
                                    phi_1556_ = 1f;
                                } else {
                                    phi_1556_ = _e111;
                                }
                                let _e118 = phi_1556_;
                                phi_1557_ = _e118;
                            }
                            let _e120 = phi_1557_;
                            phi_1558_ = _e120;
                        }
                        let _e122 = phi_1558_;
                        phi_1559_ = _e122;
                        phi_1560_ = false;
                    } else {
                        phi_1559_ = f32();
                        phi_1560_ = true;
                    }
                    let _e124 = phi_1559_;
                    let _e126 = phi_1560_;
                    phi_1561_ = _e124;
                    phi_1562_ = _e126;
                } else {
                    phi_1561_ = f32();
                    phi_1562_ = true;
                }
                let _e128 = phi_1561_;
                let _e130 = phi_1562_;
                if _e130 {
                    phi_1569_ = bitcast<f32>((bitcast<u32>(_e57) | 2143289344u));
                } else {
                    phi_1569_ = _e128;
                }
                let _e135 = phi_1569_;
                phi_1570_ = _e135;
            } else {
                phi_1570_ = _e105;
            }
            let _e137 = phi_1570_;
            phi_1571_ = _e137;
        }
        let _e139 = phi_1571_;
        phi_1572_ = _e139;
    }
    let _e141 = phi_1572_;
    return _e141;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_11: ptr<function, f32>, param_12: vec4<f32>, param_13: f32) -> f32 {
    var local: hankel_HankelFactors;
    var phi_780_: f32;
    var phi_781_: f32;
    var phi_782_: f32;
    var phi_794_: bool;
    var phi_809_: bool;
    var phi_834_: f32;
    var phi_835_: f32;
    var phi_836_: f32;
    var phi_837_: f32;
    var phi_838_: bool;
    var phi_839_: f32;
    var phi_840_: bool;
    var phi_896_: vec2<f32>;
    var phi_934_: f32;
    var phi_935_: f32;
    var phi_936_: f32;
    var phi_969_: f32;
    var phi_970_: f32;
    var phi_971_: f32;
    var phi_975_: f32;
    var phi_976_: f32;
    var phi_977_: f32;
    var phi_978_: f32;
    var phi_1031_: vec2<f32>;
    var phi_1053_: bool;
    var phi_1078_: f32;
    var phi_1079_: f32;
    var phi_1080_: f32;
    var phi_1081_: f32;
    var phi_1082_: bool;
    var phi_1083_: f32;
    var phi_1084_: bool;
    var phi_1140_: vec2<f32>;
    var phi_1178_: f32;
    var phi_1179_: f32;
    var phi_1180_: f32;
    var phi_1213_: f32;
    var phi_1214_: f32;
    var phi_1215_: f32;
    var phi_1219_: f32;
    var phi_1220_: f32;
    var phi_1221_: f32;
    var phi_1222_: f32;
    var phi_1223_: f32;
    var phi_1224_: bool;
    var phi_1225_: f32;
    var phi_1226_: bool;
    var phi_1248_: bool;
    var phi_1273_: f32;
    var phi_1274_: f32;
    var phi_1275_: f32;
    var phi_1276_: f32;
    var phi_1277_: bool;
    var phi_1278_: f32;
    var phi_1279_: bool;
    var phi_1335_: vec2<f32>;
    var phi_1373_: f32;
    var phi_1374_: f32;
    var phi_1375_: f32;
    var phi_1408_: f32;
    var phi_1409_: f32;
    var phi_1410_: f32;
    var phi_1414_: f32;
    var phi_1415_: f32;
    var phi_1416_: f32;
    var phi_1417_: f32;
    var phi_1428_: bool;
    var phi_1432_: f32;
    var phi_1433_: f32;
    var phi_1434_: f32;
    var phi_1435_: f32;

    let _e40 = (*param_11);
    let _e41 = (1f - _e40);
    let _e50 = (0.5f * _e40);
    let _e51 = ((param_12.x * _e41) + _e50);
    let _e52 = ((param_12.y * _e41) + _e50);
    let _e53 = ((param_12.z * _e41) + _e50);
    let _e54 = ((param_12.w * _e41) + _e50);
    let _e57 = (_e52 - (_e51 * _e51));
    let _e59 = (_e53 - (_e51 * _e52));
    let _e65 = hankel_HankelFactors(vec4<f32>(_e51, _e52, _e53, _e54), _e57, _e59, (((_e54 - (_e52 * _e52)) * _e57) - (_e59 * _e59)));
    local = hankel_HankelFactors(_e65.moments, _e65.d22_, _e65.l32_d22_, _e65.d33_d22_);
    if ((bitcast<u32>(param_13) & 2147483647u) > 2139095040u) {
        phi_782_ = param_13;
    } else {
        if (param_13 < 0f) {
            phi_781_ = 0f;
        } else {
            if (param_13 > 1f) {
                phi_780_ = 1f;
            } else {
                phi_780_ = param_13;
            }
            let _e77 = phi_780_;
            phi_781_ = _e77;
        }
        let _e79 = phi_781_;
        phi_782_ = _e79;
    }
    let _e81 = phi_782_;
    let _e84 = local.moments[0u];
    let _e87 = local.moments[3u];
    if (_e84 == _e87) {
        let _e91 = local.moments[0u];
        phi_794_ = (_e91 > 0.5f);
    } else {
        phi_794_ = false;
    }
    let _e94 = phi_794_;
    if _e94 {
        let _e97 = local.moments[0u];
        let _e100 = local.moments[3u];
        if (_e97 == _e100) {
            let _e104 = local.moments[0u];
            phi_809_ = (_e104 > 0.5f);
        } else {
            phi_809_ = false;
        }
        let _e107 = phi_809_;
        if _e107 {
            if (_e81 > 0f) {
                let _e110 = local.moments;
                if ((bitcast<u32>(_e110.x) & 2147483647u) > 2139095040u) {
                    phi_836_ = _e110.x;
                } else {
                    if (_e110.x < 0f) {
                        phi_835_ = 0f;
                    } else {
                        if (_e110.x > 1f) {
                            phi_834_ = 1f;
                        } else {
                            phi_834_ = _e110.x;
                        }
                        let _e118 = phi_834_;
                        phi_835_ = _e118;
                    }
                    let _e120 = phi_835_;
                    phi_836_ = _e120;
                }
                let _e122 = phi_836_;
                phi_837_ = _e122;
                phi_838_ = false;
            } else {
                phi_837_ = f32();
                phi_838_ = true;
            }
            let _e124 = phi_837_;
            let _e126 = phi_838_;
            phi_839_ = _e124;
            phi_840_ = _e126;
        } else {
            phi_839_ = f32();
            phi_840_ = true;
        }
        let _e128 = phi_839_;
        let _e130 = phi_840_;
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
                phi_896_ = vec2<f32>((-(_e169) - _e174), (-(_e169) + _e174));
            } else {
                phi_896_ = vec2(bitcast<f32>((bitcast<u32>(_e172) | 2143289344u)));
            }
            let _e185 = phi_896_;
            if (_e81 <= _e185.x) {
                phi_977_ = 1f;
            } else {
                if (_e81 > _e185.y) {
                    let _e191 = local.moments;
                    let _e202 = (((_e191.y - (_e191.x * (_e185.x + _e185.y))) + (_e185.x * _e185.y)) / ((_e81 - _e185.x) * (_e81 - _e185.y)));
                    if ((bitcast<u32>(_e202) & 2147483647u) > 2139095040u) {
                        phi_936_ = _e202;
                    } else {
                        if (_e202 < 0f) {
                            phi_935_ = 0f;
                        } else {
                            if (_e202 > 1f) {
                                phi_934_ = 1f;
                            } else {
                                phi_934_ = _e202;
                            }
                            let _e209 = phi_934_;
                            phi_935_ = _e209;
                        }
                        let _e211 = phi_935_;
                        phi_936_ = _e211;
                    }
                    let _e213 = phi_936_;
                    phi_976_ = _e213;
                } else {
                    if (_e81 > _e185.x) {
                        let _e216 = local.moments;
                        let _e228 = (1f - (((_e216.y - (_e216.x * (_e81 + _e185.y))) + (_e81 * _e185.y)) / ((_e185.x - _e81) * (_e185.x - _e185.y))));
                        if ((bitcast<u32>(_e228) & 2147483647u) > 2139095040u) {
                            phi_971_ = _e228;
                        } else {
                            if (_e228 < 0f) {
                                phi_970_ = 0f;
                            } else {
                                if (_e228 > 1f) {
                                    phi_969_ = 1f;
                                } else {
                                    phi_969_ = _e228;
                                }
                                let _e235 = phi_969_;
                                phi_970_ = _e235;
                            }
                            let _e237 = phi_970_;
                            phi_971_ = _e237;
                        }
                        let _e239 = phi_971_;
                        phi_975_ = _e239;
                    } else {
                        phi_975_ = bitcast<f32>((bitcast<u32>(_e185.x) | 2143289344u));
                    }
                    let _e244 = phi_975_;
                    phi_976_ = _e244;
                }
                let _e246 = phi_976_;
                phi_977_ = _e246;
            }
            let _e248 = phi_977_;
            phi_978_ = _e248;
        } else {
            phi_978_ = _e128;
        }
        let _e250 = phi_978_;
        phi_1435_ = _e250;
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
            phi_1031_ = vec2<f32>((-(_e289) - _e294), (-(_e289) + _e294));
        } else {
            phi_1031_ = vec2(bitcast<f32>((bitcast<u32>(_e292) | 2143289344u)));
        }
        let _e305 = phi_1031_;
        if (_e305.x >= 0f) {
            if (_e305.y <= 1f) {
                let _e312 = local.moments[0u];
                let _e315 = local.moments[3u];
                if (_e312 == _e315) {
                    let _e319 = local.moments[0u];
                    phi_1053_ = (_e319 > 0.5f);
                } else {
                    phi_1053_ = false;
                }
                let _e322 = phi_1053_;
                if _e322 {
                    if (_e81 > 0f) {
                        let _e325 = local.moments;
                        if ((bitcast<u32>(_e325.x) & 2147483647u) > 2139095040u) {
                            phi_1080_ = _e325.x;
                        } else {
                            if (_e325.x < 0f) {
                                phi_1079_ = 0f;
                            } else {
                                if (_e325.x > 1f) {
                                    phi_1078_ = 1f;
                                } else {
                                    phi_1078_ = _e325.x;
                                }
                                let _e333 = phi_1078_;
                                phi_1079_ = _e333;
                            }
                            let _e335 = phi_1079_;
                            phi_1080_ = _e335;
                        }
                        let _e337 = phi_1080_;
                        phi_1081_ = _e337;
                        phi_1082_ = false;
                    } else {
                        phi_1081_ = f32();
                        phi_1082_ = true;
                    }
                    let _e339 = phi_1081_;
                    let _e341 = phi_1082_;
                    phi_1083_ = _e339;
                    phi_1084_ = _e341;
                } else {
                    phi_1083_ = f32();
                    phi_1084_ = true;
                }
                let _e343 = phi_1083_;
                let _e345 = phi_1084_;
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
                        phi_1140_ = vec2<f32>((-(_e384) - _e389), (-(_e384) + _e389));
                    } else {
                        phi_1140_ = vec2(bitcast<f32>((bitcast<u32>(_e387) | 2143289344u)));
                    }
                    let _e400 = phi_1140_;
                    if (_e81 <= _e400.x) {
                        phi_1221_ = 1f;
                    } else {
                        if (_e81 > _e400.y) {
                            let _e406 = local.moments;
                            let _e417 = (((_e406.y - (_e406.x * (_e400.x + _e400.y))) + (_e400.x * _e400.y)) / ((_e81 - _e400.x) * (_e81 - _e400.y)));
                            if ((bitcast<u32>(_e417) & 2147483647u) > 2139095040u) {
                                phi_1180_ = _e417;
                            } else {
                                if (_e417 < 0f) {
                                    phi_1179_ = 0f;
                                } else {
                                    if (_e417 > 1f) {
                                        phi_1178_ = 1f;
                                    } else {
                                        phi_1178_ = _e417;
                                    }
                                    let _e424 = phi_1178_;
                                    phi_1179_ = _e424;
                                }
                                let _e426 = phi_1179_;
                                phi_1180_ = _e426;
                            }
                            let _e428 = phi_1180_;
                            phi_1220_ = _e428;
                        } else {
                            if (_e81 > _e400.x) {
                                let _e431 = local.moments;
                                let _e443 = (1f - (((_e431.y - (_e431.x * (_e81 + _e400.y))) + (_e81 * _e400.y)) / ((_e400.x - _e81) * (_e400.x - _e400.y))));
                                if ((bitcast<u32>(_e443) & 2147483647u) > 2139095040u) {
                                    phi_1215_ = _e443;
                                } else {
                                    if (_e443 < 0f) {
                                        phi_1214_ = 0f;
                                    } else {
                                        if (_e443 > 1f) {
                                            phi_1213_ = 1f;
                                        } else {
                                            phi_1213_ = _e443;
                                        }
                                        let _e450 = phi_1213_;
                                        phi_1214_ = _e450;
                                    }
                                    let _e452 = phi_1214_;
                                    phi_1215_ = _e452;
                                }
                                let _e454 = phi_1215_;
                                phi_1219_ = _e454;
                            } else {
                                phi_1219_ = bitcast<f32>((bitcast<u32>(_e400.x) | 2143289344u));
                            }
                            let _e459 = phi_1219_;
                            phi_1220_ = _e459;
                        }
                        let _e461 = phi_1220_;
                        phi_1221_ = _e461;
                    }
                    let _e463 = phi_1221_;
                    phi_1222_ = _e463;
                } else {
                    phi_1222_ = _e343;
                }
                let _e465 = phi_1222_;
                phi_1223_ = _e465;
                phi_1224_ = false;
            } else {
                phi_1223_ = f32();
                phi_1224_ = true;
            }
            let _e467 = phi_1223_;
            let _e469 = phi_1224_;
            phi_1225_ = _e467;
            phi_1226_ = _e469;
        } else {
            phi_1225_ = f32();
            phi_1226_ = true;
        }
        let _e471 = phi_1225_;
        let _e473 = phi_1226_;
        if _e473 {
            if ((bitcast<u32>(_e305.x) & 2147483647u) > 2139095040u) {
                phi_1433_ = _e305.x;
            } else {
                let _e477 = lt_math_hausdorff_endpoint_upper_bound((&local), _e81);
                let _e480 = local.moments[0u];
                let _e483 = local.moments[3u];
                if (_e480 == _e483) {
                    let _e487 = local.moments[0u];
                    phi_1248_ = (_e487 > 0.5f);
                } else {
                    phi_1248_ = false;
                }
                let _e490 = phi_1248_;
                if _e490 {
                    if (_e81 > 0f) {
                        let _e493 = local.moments;
                        if ((bitcast<u32>(_e493.x) & 2147483647u) > 2139095040u) {
                            phi_1275_ = _e493.x;
                        } else {
                            if (_e493.x < 0f) {
                                phi_1274_ = 0f;
                            } else {
                                if (_e493.x > 1f) {
                                    phi_1273_ = 1f;
                                } else {
                                    phi_1273_ = _e493.x;
                                }
                                let _e501 = phi_1273_;
                                phi_1274_ = _e501;
                            }
                            let _e503 = phi_1274_;
                            phi_1275_ = _e503;
                        }
                        let _e505 = phi_1275_;
                        phi_1276_ = _e505;
                        phi_1277_ = false;
                    } else {
                        phi_1276_ = f32();
                        phi_1277_ = true;
                    }
                    let _e507 = phi_1276_;
                    let _e509 = phi_1277_;
                    phi_1278_ = _e507;
                    phi_1279_ = _e509;
                } else {
                    phi_1278_ = f32();
                    phi_1279_ = true;
                }
                let _e511 = phi_1278_;
                let _e513 = phi_1279_;
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
                        phi_1335_ = vec2<f32>((-(_e552) - _e557), (-(_e552) + _e557));
                    } else {
                        phi_1335_ = vec2(bitcast<f32>((bitcast<u32>(_e555) | 2143289344u)));
                    }
                    let _e568 = phi_1335_;
                    if (_e81 <= _e568.x) {
                        phi_1416_ = 1f;
                    } else {
                        if (_e81 > _e568.y) {
                            let _e574 = local.moments;
                            let _e585 = (((_e574.y - (_e574.x * (_e568.x + _e568.y))) + (_e568.x * _e568.y)) / ((_e81 - _e568.x) * (_e81 - _e568.y)));
                            if ((bitcast<u32>(_e585) & 2147483647u) > 2139095040u) {
                                phi_1375_ = _e585;
                            } else {
                                if (_e585 < 0f) {
                                    phi_1374_ = 0f;
                                } else {
                                    if (_e585 > 1f) {
                                        phi_1373_ = 1f;
                                    } else {
                                        phi_1373_ = _e585;
                                    }
                                    let _e592 = phi_1373_;
                                    phi_1374_ = _e592;
                                }
                                let _e594 = phi_1374_;
                                phi_1375_ = _e594;
                            }
                            let _e596 = phi_1375_;
                            phi_1415_ = _e596;
                        } else {
                            if (_e81 > _e568.x) {
                                let _e599 = local.moments;
                                let _e611 = (1f - (((_e599.y - (_e599.x * (_e81 + _e568.y))) + (_e81 * _e568.y)) / ((_e568.x - _e81) * (_e568.x - _e568.y))));
                                if ((bitcast<u32>(_e611) & 2147483647u) > 2139095040u) {
                                    phi_1410_ = _e611;
                                } else {
                                    if (_e611 < 0f) {
                                        phi_1409_ = 0f;
                                    } else {
                                        if (_e611 > 1f) {
                                            phi_1408_ = 1f;
                                        } else {
                                            phi_1408_ = _e611;
                                        }
                                        let _e618 = phi_1408_;
                                        phi_1409_ = _e618;
                                    }
                                    let _e620 = phi_1409_;
                                    phi_1410_ = _e620;
                                }
                                let _e622 = phi_1410_;
                                phi_1414_ = _e622;
                            } else {
                                phi_1414_ = bitcast<f32>((bitcast<u32>(_e568.x) | 2143289344u));
                            }
                            let _e627 = phi_1414_;
                            phi_1415_ = _e627;
                        }
                        let _e629 = phi_1415_;
                        phi_1416_ = _e629;
                    }
                    let _e631 = phi_1416_;
                    phi_1417_ = _e631;
                } else {
                    phi_1417_ = _e511;
                }
                let _e633 = phi_1417_;
                if ((bitcast<u32>(_e633) & 2147483647u) > 2139095040u) {
                    phi_1428_ = true;
                } else {
                    let _e637 = (_e633 < _e477);
                    if _e637 {
                    }
                    phi_1428_ = _e637;
                }
                let _e639 = phi_1428_;
                if _e639 {
                    phi_1432_ = _e633;
                } else {
                    phi_1432_ = _e477;
                }
                let _e641 = phi_1432_;
                phi_1433_ = _e641;
            }
            let _e643 = phi_1433_;
            phi_1434_ = _e643;
        } else {
            phi_1434_ = _e471;
        }
        let _e645 = phi_1434_;
        phi_1435_ = _e645;
    }
    let _e647 = phi_1435_;
    return _e647;
}

fn function_() {
    var local_1: f32;
    var phi_214_: bool;
    var phi_215_: bool;
    var phi_216_: bool;
    var phi_217_: bool;
    var phi_221_: bool;
    var phi_265_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_269_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_343_: bool;
    var phi_352_: bool;
    var phi_361_: bool;
    var phi_362_: bool;
    var phi_363_: bool;
    var phi_364_: bool;
    var phi_365_: bool;
    var phi_366_: bool;
    var phi_367_: bool;
    var phi_371_: bool;
    var phi_461_: f32;
    var phi_464_: f32;
    var phi_493_: f32;
    var phi_498_: f32;
    var phi_499_: bool;
    var phi_500_: f32;
    var phi_501_: bool;
    var phi_505_: f32;
    var phi_525_: f32;
    var phi_530_: f32;
    var phi_531_: bool;
    var phi_532_: f32;
    var phi_533_: bool;
    var phi_537_: f32;
    var phi_585_: i32;
    var phi_590_: i32;
    var phi_595_: i32;
    var phi_600_: i32;
    var phi_609_: i32;
    var phi_614_: i32;
    var phi_619_: i32;
    var phi_624_: i32;
    var phi_713_: evaluate_Verdict;
    var phi_714_: evaluate_Verdict;
    var phi_715_: bool;
    var phi_716_: evaluate_Verdict;
    var phi_717_: evaluate_Verdict;
    var phi_718_: bool;
    var phi_722_: evaluate_Verdict;

    let _e37 = id_1;
    let _e44 = arrayLength((&map.member));
    let _e50 = p.member.size[0u];
    let _e52 = p.member.size[1u];
    let _e53 = lt_shaders_entry_pixel_index(_e37, _e50, _e52);
    if (bitcast<i32>(_e53.root) != 0i) {
        let _e59 = p.member.projection;
        if (_e53.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e63 = lt_math_OneLevel(_e59);
        let _e65 = p.member.light;
        let _e68 = samples.member[(0u + _e53.first_primitive)].normal[0u];
        let _e70 = global[0u];
        if (_e68 == _e70) {
            let _e73 = samples.member[(0u + _e53.first_primitive)].normal[1u];
            let _e75 = global[1u];
            if (_e73 == _e75) {
                let _e78 = samples.member[(0u + _e53.first_primitive)].normal[2u];
                let _e80 = global[2u];
                phi_214_ = (_e78 == _e80);
                phi_215_ = false;
            } else {
                phi_214_ = bool();
                phi_215_ = true;
            }
            let _e83 = phi_214_;
            let _e85 = phi_215_;
            phi_216_ = _e83;
            phi_217_ = _e85;
        } else {
            phi_216_ = bool();
            phi_217_ = true;
        }
        let _e87 = phi_216_;
        let _e89 = phi_217_;
        if _e89 {
            phi_221_ = false;
        } else {
            phi_221_ = _e87;
        }
        let _e91 = phi_221_;
        if !(_e91) {
            let _e94 = samples.member[(0u + _e53.first_primitive)].normal;
            let _e96 = samples.member[(0u + _e53.first_primitive)].position;
            if ((((_e94.x * (_e65.x - (_e96.x * _e65.w))) + (_e94.y * (_e65.y - (_e96.y * _e65.w)))) + (_e94.z * (_e65.z - (_e96.z * _e65.w)))) > 0f) {
                let _e120 = samples.member[(0u + _e53.first_primitive)].flags;
                let _e128 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e134 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e128.unnamed.visibility, false), _e128.unnamed_1);
                phi_265_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e134.unnamed, ((_e120 & 1u) == 0u));
            } else {
                let _e143 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e149 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e143.unnamed.visibility, false), _e143.unnamed_1);
                phi_265_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e149.unnamed, true);
            }
            let _e154 = phi_265_;
            phi_269_ = _e154;
        } else {
            let _e160 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e166 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e160.unnamed.visibility, false), _e160.unnamed_1);
            phi_269_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e166.unnamed, true);
        }
        let _e171 = phi_269_;
        if _e171.unnamed_1 {
            phi_716_ = evaluate_Verdict(_e171.unnamed.visibility, _e171.unnamed.is_doubted);
            phi_717_ = evaluate_Verdict();
            phi_718_ = true;
        } else {
            let _e179 = samples.member[(0u + _e53.first_primitive)].position;
            let _e197 = ((((_e63.projection.row_w.x * _e179.x) + (_e63.projection.row_w.y * _e179.y)) + (_e63.projection.row_w.z * _e179.z)) + (_e63.projection.row_w.w * 1f));
            let _e211 = (((((_e63.projection.row_x.x * _e179.x) + (_e63.projection.row_x.y * _e179.y)) + (_e63.projection.row_x.z * _e179.z)) + (_e63.projection.row_x.w * 1f)) / _e197);
            let _e225 = (((((_e63.projection.row_y.x * _e179.x) + (_e63.projection.row_y.y * _e179.y)) + (_e63.projection.row_y.z * _e179.z)) + (_e63.projection.row_y.w * 1f)) / _e197);
            let _e238 = ((((_e63.projection.row_z.x * _e179.x) + (_e63.projection.row_z.y * _e179.y)) + (_e63.projection.row_z.z * _e179.z)) + (_e63.projection.row_z.w * 1f));
            if (_e197 > 0f) {
                if (_e211 >= 0f) {
                    phi_343_ = (_e211 <= 1f);
                } else {
                    phi_343_ = false;
                }
                let _e243 = phi_343_;
                if _e243 {
                    if (_e225 >= 0f) {
                        phi_352_ = (_e225 <= 1f);
                    } else {
                        phi_352_ = false;
                    }
                    let _e247 = phi_352_;
                    if _e247 {
                        if (_e238 >= 0f) {
                            phi_361_ = (_e238 <= 1f);
                        } else {
                            phi_361_ = false;
                        }
                        let _e251 = phi_361_;
                        phi_362_ = _e251;
                        phi_363_ = false;
                    } else {
                        phi_362_ = bool();
                        phi_363_ = true;
                    }
                    let _e253 = phi_362_;
                    let _e255 = phi_363_;
                    phi_364_ = _e253;
                    phi_365_ = _e255;
                } else {
                    phi_364_ = bool();
                    phi_365_ = true;
                }
                let _e257 = phi_364_;
                let _e259 = phi_365_;
                phi_366_ = _e257;
                phi_367_ = _e259;
            } else {
                phi_366_ = bool();
                phi_367_ = true;
            }
            let _e261 = phi_366_;
            let _e263 = phi_367_;
            if _e263 {
                phi_371_ = false;
            } else {
                phi_371_ = _e261;
            }
            let _e265 = phi_371_;
            if _e265 {
                if (0f > 0f) {
                    let _e268 = samples.member[(0u + _e53.first_primitive)].normal;
                    let _e270 = p.member.map_size;
                    let _e340 = ((abs(((((_e59.row_x.x * _e268.x) + (_e59.row_x.y * _e268.y)) + (_e59.row_x.z * _e268.z)) / (((_e59.row_x.x * _e59.row_x.x) + (_e59.row_x.y * _e59.row_x.y)) + (_e59.row_x.z * _e59.row_x.z)))) + abs(((((_e59.row_y.x * _e268.x) + (_e59.row_y.y * _e268.y)) + (_e59.row_y.z * _e268.z)) / (((_e59.row_y.x * _e59.row_y.x) + (_e59.row_y.y * _e59.row_y.y)) + (_e59.row_y.z * _e59.row_y.z))))) / (abs(((((_e59.row_z.x * _e268.x) + (_e59.row_z.y * _e268.y)) + (_e59.row_z.z * _e268.z)) / (((_e59.row_z.x * _e59.row_z.x) + (_e59.row_z.y * _e59.row_z.y)) + (_e59.row_z.z * _e59.row_z.z)))) * f32(_e270)));
                    if (_e340 < 0.002f) {
                        phi_461_ = _e340;
                    } else {
                        phi_461_ = 0.002f;
                    }
                    let _e343 = phi_461_;
                    phi_464_ = (_e238 - (0f * _e343));
                } else {
                    phi_464_ = _e238;
                }
                let _e347 = phi_464_;
                let _e349 = p.member.map_size;
                let _e350 = f32(_e349);
                let _e353 = ((_e211 * _e350) - 0.5f);
                let _e354 = ((_e225 * _e350) - 0.5f);
                if (_e353 > -8388608f) {
                    let _e366 = f32(select(0i, select(select(i32(_e353), i32(-2147483648), (_e353 < bitcast<f32>(3472883712u))), 2147483647i, (_e353 > bitcast<f32>(1325400063u))), (_e353 == _e353)));
                    if (_e366 > _e353) {
                        phi_493_ = 1f;
                    } else {
                        phi_493_ = 0f;
                    }
                    let _e369 = phi_493_;
                    if (_e353 < 8388608f) {
                        phi_498_ = (_e366 - _e369);
                        phi_499_ = false;
                    } else {
                        phi_498_ = f32();
                        phi_499_ = true;
                    }
                    let _e372 = phi_498_;
                    let _e374 = phi_499_;
                    phi_500_ = _e372;
                    phi_501_ = _e374;
                } else {
                    phi_500_ = f32();
                    phi_501_ = true;
                }
                let _e376 = phi_500_;
                let _e378 = phi_501_;
                if _e378 {
                    phi_505_ = _e353;
                } else {
                    phi_505_ = _e376;
                }
                let _e380 = phi_505_;
                if (_e354 > -8388608f) {
                    let _e392 = f32(select(0i, select(select(i32(_e354), i32(-2147483648), (_e354 < bitcast<f32>(3472883712u))), 2147483647i, (_e354 > bitcast<f32>(1325400063u))), (_e354 == _e354)));
                    if (_e392 > _e354) {
                        phi_525_ = 1f;
                    } else {
                        phi_525_ = 0f;
                    }
                    let _e395 = phi_525_;
                    if (_e354 < 8388608f) {
                        phi_530_ = (_e392 - _e395);
                        phi_531_ = false;
                    } else {
                        phi_530_ = f32();
                        phi_531_ = true;
                    }
                    let _e398 = phi_530_;
                    let _e400 = phi_531_;
                    phi_532_ = _e398;
                    phi_533_ = _e400;
                } else {
                    phi_532_ = f32();
                    phi_533_ = true;
                }
                let _e402 = phi_532_;
                let _e404 = phi_533_;
                if _e404 {
                    phi_537_ = _e354;
                } else {
                    phi_537_ = _e402;
                }
                let _e406 = phi_537_;
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
                let _e441 = ((0u * _e439) * _e439);
                let _e443 = (bitcast<i32>(_e439) - 1i);
                if (_e417 > 0i) {
                    phi_585_ = _e417;
                } else {
                    phi_585_ = 0i;
                }
                let _e446 = phi_585_;
                if (_e426 > 0i) {
                    phi_590_ = _e426;
                } else {
                    phi_590_ = 0i;
                }
                let _e449 = phi_590_;
                if (_e446 < _e443) {
                    phi_595_ = _e446;
                } else {
                    phi_595_ = _e443;
                }
                let _e452 = phi_595_;
                if (_e449 < _e443) {
                    phi_600_ = _e449;
                } else {
                    phi_600_ = _e443;
                }
                let _e455 = phi_600_;
                let _e456 = bitcast<u32>(_e452);
                let _e458 = (_e417 + 1i);
                let _e459 = (_e426 + 1i);
                if (_e458 > 0i) {
                    phi_609_ = _e458;
                } else {
                    phi_609_ = 0i;
                }
                let _e462 = phi_609_;
                if (_e459 > 0i) {
                    phi_614_ = _e459;
                } else {
                    phi_614_ = 0i;
                }
                let _e465 = phi_614_;
                if (_e462 < _e443) {
                    phi_619_ = _e462;
                } else {
                    phi_619_ = _e443;
                }
                let _e468 = phi_619_;
                if (_e465 < _e443) {
                    phi_624_ = _e465;
                } else {
                    phi_624_ = _e443;
                }
                let _e471 = phi_624_;
                let _e472 = bitcast<u32>(_e468);
                let _e474 = (bitcast<u32>(_e455) * _e439);
                let _e475 = (bitcast<u32>(_e471) * _e439);
                let _e480 = ((_e474 + _e456) + _e441);
                let _e481 = ((_e474 + _e472) + _e441);
                let _e482 = ((_e475 + _e456) + _e441);
                let _e483 = ((_e475 + _e472) + _e441);
                if (_e480 < _e44) {
                } else {
                    return;
                }
                let _e487 = map.member[(0u + _e480)];
                if (_e481 < _e44) {
                } else {
                    return;
                }
                let _e499 = map.member[(0u + _e481)];
                if (_e482 < _e44) {
                } else {
                    return;
                }
                let _e515 = map.member[(0u + _e482)];
                if (_e483 < _e44) {
                } else {
                    return;
                }
                let _e531 = map.member[(0u + _e483)];
                let _e545 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_1), vec4<f32>(((((_e487.x * _e429) + (_e499.x * _e431)) + (_e515.x * _e433)) + (_e531.x * _e434)), ((((_e487.y * _e429) + (_e499.y * _e431)) + (_e515.y * _e433)) + (_e531.y * _e434)), ((((_e487.z * _e429) + (_e499.z * _e431)) + (_e515.z * _e433)) + (_e531.z * _e434)), ((((_e487.w * _e429) + (_e499.w * _e431)) + (_e515.w * _e433)) + (_e531.w * _e434))), _e347);
                phi_713_ = evaluate_Verdict(_e545, false);
                phi_714_ = evaluate_Verdict();
                phi_715_ = false;
            } else {
                phi_713_ = evaluate_Verdict();
                phi_714_ = evaluate_Verdict(1f, false);
                phi_715_ = true;
            }
            let _e549 = phi_713_;
            let _e551 = phi_714_;
            let _e553 = phi_715_;
            phi_716_ = _e551;
            phi_717_ = _e549;
            phi_718_ = _e553;
        }
        let _e555 = phi_716_;
        let _e557 = phi_717_;
        let _e559 = phi_718_;
        if _e559 {
            phi_722_ = _e555;
        } else {
            phi_722_ = _e557;
        }
        let _e561 = phi_722_;
        if (_e53.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e53.first_primitive)] = _e561.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_msm_hausdorff_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
