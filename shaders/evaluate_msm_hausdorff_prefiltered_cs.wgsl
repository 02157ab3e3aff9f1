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
    pad0_: u32,
    pad1_: u32,
    pad2_: u32,
}

struct type_32 {
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
var<uniform> p: type_32;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_13;
@group(0) @binding(2) 
var<storage> map: type_28;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_142_: lt_bvh_traverse_Tree;
    var phi_143_: bool;
    var phi_144_: lt_bvh_traverse_Tree;
    var phi_145_: bool;
    var phi_150_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_142_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_143_ = false;
        } else {
            phi_142_ = lt_bvh_traverse_Tree();
            phi_143_ = true;
        }
        let _e49 = phi_142_;
        let _e51 = phi_143_;
        phi_144_ = _e49;
        phi_145_ = _e51;
    } else {
        phi_144_ = lt_bvh_traverse_Tree();
        phi_145_ = true;
    }
    let _e53 = phi_144_;
    let _e55 = phi_145_;
    if _e55 {
        phi_150_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_150_ = _e53;
    }
    let _e60 = phi_150_;
    return lt_bvh_traverse_Tree(_e60.root, _e60.first_primitive);
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn lt_math_hausdorff_cubic_mass(param_4: vec4<f32>, param_5: f32, param_6: f32, param_7: f32, param_8: f32) -> f32 {
    return ((((param_4.z - (((param_6 + param_7) + param_8) * param_4.y)) + ((((param_6 * param_7) + (param_6 * param_8)) + (param_7 * param_8)) * param_4.x)) - ((param_6 * param_7) * param_8)) / (((param_5 - param_6) * (param_5 - param_7)) * (param_5 - param_8)));
}

fn lt_math_hausdorff_endpoint_upper_bound(param_9: ptr<function, hankel_HankelFactors>, param_10: f32) -> f32 {
    var phi_1490_: f32;
    var phi_1491_: f32;
    var phi_1492_: f32;
    var phi_1519_: f32;
    var phi_1520_: f32;
    var phi_1521_: f32;
    var phi_1522_: f32;
    var phi_1523_: bool;
    var phi_1524_: f32;
    var phi_1525_: bool;
    var phi_1553_: f32;
    var phi_1554_: f32;
    var phi_1555_: f32;
    var phi_1556_: f32;
    var phi_1557_: bool;
    var phi_1558_: f32;
    var phi_1559_: bool;
    var phi_1566_: f32;
    var phi_1567_: f32;
    var phi_1568_: f32;
    var phi_1569_: f32;

    let _e39 = (*param_9).moments;
    if (param_10 < 0.0001f) {
        phi_1569_ = 1f;
    } else {
        let _e48 = ((_e39.z - ((1f + param_10) * _e39.y)) + (param_10 * _e39.x));
        let _e57 = (((_e39.w - ((1f + param_10) * _e39.z)) + (param_10 * _e39.y)) / _e48);
        if (abs(_e48) <= 0.00000047683716f) {
            let _e71 = (1f - (((_e39.y - (_e39.x * (param_10 + 1f))) + (param_10 * 1f)) / ((0f - param_10) * (0f - 1f))));
            if ((bitcast<u32>(_e71) & 2147483647u) > 2139095040u) {
                phi_1492_ = _e71;
            } else {
                if (_e71 < 0f) {
                    phi_1491_ = 0f;
                } else {
                    if (_e71 > 1f) {
                        phi_1490_ = 1f;
                    } else {
                        phi_1490_ = _e71;
                    }
                    let _e78 = phi_1490_;
                    phi_1491_ = _e78;
                }
                let _e80 = phi_1491_;
                phi_1492_ = _e80;
            }
            let _e82 = phi_1492_;
            phi_1568_ = _e82;
        } else {
            if (_e57 > 0f) {
                if (_e57 < param_10) {
                    let _e85 = lt_math_hausdorff_cubic_mass(_e39, 0f, _e57, param_10, 1f);
                    let _e87 = lt_math_hausdorff_cubic_mass(_e39, _e57, 0f, param_10, 1f);
                    let _e88 = ((1f - _e85) - _e87);
                    if ((bitcast<u32>(_e88) & 2147483647u) > 2139095040u) {
                        phi_1521_ = _e88;
                    } else {
                        if (_e88 < 0f) {
                            phi_1520_ = 0f;
                        } else {
                            if (_e88 > 1f) {
                                phi_1519_ = 1f;
                            } else {
                                phi_1519_ = _e88;
                            }
                            let _e95 = phi_1519_;
                            phi_1520_ = _e95;
                        }
                        let _e97 = phi_1520_;
                        phi_1521_ = _e97;
                    }
                    let _e99 = phi_1521_;
                    phi_1522_ = _e99;
                    phi_1523_ = false;
                } else {
                    phi_1522_ = f32();
                    phi_1523_ = true;
                }
                let _e101 = phi_1522_;
                let _e103 = phi_1523_;
                phi_1524_ = _e101;
                phi_1525_ = _e103;
            } else {
                phi_1524_ = f32();
                phi_1525_ = true;
            }
            let _e105 = phi_1524_;
            let _e107 = phi_1525_;
            if _e107 {
                if (_e57 > param_10) {
                    if (_e57 < 1f) {
                        let _e110 = lt_math_hausdorff_cubic_mass(_e39, 0f, _e57, param_10, 1f);
                        let _e111 = (1f - _e110);
                        if ((bitcast<u32>(_e111) & 2147483647u) > 2139095040u) {
                            phi_1555_ = _e111;
                        } else {
                            if (_e111 < 0f) {
                                phi_1554_ = 0f;
                            } else {
                                if (_e111 > 1f) {
                                    phi_1553_ = 1f;
                                } else {
                                    phi_1553_ = _e111;
                                }
                                let _e118 = phi_1553_;
                                phi_1554_ = _e118;
                            }
                            let _e120 = phi_1554_;
                            phi_1555_ = _e120;
                        }
                        let _e122 = phi_1555_;
                        phi_1556_ = _e122;
                        phi_1557_ = false;
                    } else {
                        phi_1556_ = f32();
                        phi_1557_ = true;
                    }
                    let _e124 = phi_1556_;
                    let _e126 = phi_1557_;
                    phi_1558_ = _e124;
                    phi_1559_ = _e126;
                } else {
                    phi_1558_ = f32();
                    phi_1559_ = true;
                }
                let _e128 = phi_1558_;
                let _e130 = phi_1559_;
                if _e130 {
                    phi_1566_ = bitcast<f32>((bitcast<u32>(_e57) | 2143289344u));
                } else {
                    phi_1566_ = _e128;
                }
                let _e135 = phi_1566_;
                phi_1567_ = _e135;
            } else {
                phi_1567_ = _e105;
            }
            let _e137 = phi_1567_;
            phi_1568_ = _e137;
        }
        let _e139 = phi_1568_;
        phi_1569_ = _e139;
    }
    let _e141 = phi_1569_;
    return _e141;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_11: ptr<function, f32>, param_12: vec4<f32>, param_13: f32) -> f32 {
    var local: hankel_HankelFactors;
    var phi_777_: f32;
    var phi_778_: f32;
    var phi_779_: f32;
    var phi_791_: bool;
    var phi_806_: bool;
    var phi_831_: f32;
    var phi_832_: f32;
    var phi_833_: f32;
    var phi_834_: f32;
    var phi_835_: bool;
    var phi_836_: f32;
    var phi_837_: bool;
    var phi_893_: vec2<f32>;
    var phi_931_: f32;
    var phi_932_: f32;
    var phi_933_: f32;
    var phi_966_: f32;
    var phi_967_: f32;
    var phi_968_: f32;
    var phi_972_: f32;
    var phi_973_: f32;
    var phi_974_: f32;
    var phi_975_: f32;
    var phi_1028_: vec2<f32>;
    var phi_1050_: bool;
    var phi_1075_: f32;
    var phi_1076_: f32;
    var phi_1077_: f32;
    var phi_1078_: f32;
    var phi_1079_: bool;
    var phi_1080_: f32;
    var phi_1081_: bool;
    var phi_1137_: vec2<f32>;
    var phi_1175_: f32;
    var phi_1176_: f32;
    var phi_1177_: f32;
    var phi_1210_: f32;
    var phi_1211_: f32;
    var phi_1212_: f32;
    var phi_1216_: f32;
    var phi_1217_: f32;
    var phi_1218_: f32;
    var phi_1219_: f32;
    var phi_1220_: f32;
    var phi_1221_: bool;
    var phi_1222_: f32;
    var phi_1223_: bool;
    var phi_1245_: bool;
    var phi_1270_: f32;
    var phi_1271_: f32;
    var phi_1272_: f32;
    var phi_1273_: f32;
    var phi_1274_: bool;
    var phi_1275_: f32;
    var phi_1276_: bool;
    var phi_1332_: vec2<f32>;
    var phi_1370_: f32;
    var phi_1371_: f32;
    var phi_1372_: f32;
    var phi_1405_: f32;
    var phi_1406_: f32;
    var phi_1407_: f32;
    var phi_1411_: f32;
    var phi_1412_: f32;
    var phi_1413_: f32;
    var phi_1414_: f32;
    var phi_1425_: bool;
    var phi_1429_: f32;
    var phi_1430_: f32;
    var phi_1431_: f32;
    var phi_1432_: f32;

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
        phi_779_ = param_13;
    } else {
        if (param_13 < 0f) {
            phi_778_ = 0f;
        } else {
            if (param_13 > 1f) {
                phi_777_ = 1f;
            } else {
                phi_777_ = param_13;
            }
            let _e77 = phi_777_;
            phi_778_ = _e77;
        }
        let _e79 = phi_778_;
        phi_779_ = _e79;
    }
    let _e81 = phi_779_;
    let _e84 = local.moments[0u];
    let _e87 = local.moments[3u];
    if (_e84 == _e87) {
        let _e91 = local.moments[0u];
        phi_791_ = (_e91 > 0.5f);
    } else {
        phi_791_ = false;
    }
    let _e94 = phi_791_;
    if _e94 {
        let _e97 = local.moments[0u];
        let _e100 = local.moments[3u];
        if (_e97 == _e100) {
            let _e104 = local.moments[0u];
            phi_806_ = (_e104 > 0.5f);
        } else {
            phi_806_ = false;
        }
        let _e107 = phi_806_;
        if _e107 {
            if (_e81 > 0f) {
                let _e110 = local.moments;
                if ((bitcast<u32>(_e110.x) & 2147483647u) > 2139095040u) {
                    phi_833_ = _e110.x;
                } else {
                    if (_e110.x < 0f) {
                        phi_832_ = 0f;
                    } else {
                        if (_e110.x > 1f) {
                            phi_831_ = 1f;
                        } else {
                            phi_831_ = _e110.x;
                        }
                        let _e118 = phi_831_;
                        phi_832_ = _e118;
                    }
                    let _e120 = phi_832_;
                    phi_833_ = _e120;
                }
                let _e122 = phi_833_;
                phi_834_ = _e122;
                phi_835_ = false;
            } else {
                phi_834_ = f32();
                phi_835_ = true;
            }
            let _e124 = phi_834_;
            let _e126 = phi_835_;
            phi_836_ = _e124;
            phi_837_ = _e126;
        } else {
            phi_836_ = f32();
            phi_837_ = true;
        }
        let _e128 = phi_836_;
        let _e130 = phi_837_;
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
                phi_893_ = vec2<f32>((-(_e169) - _e174), (-(_e169) + _e174));
            } else {
                phi_893_ = vec2(bitcast<f32>((bitcast<u32>(_e172) | 2143289344u)));
            }
            let _e185 = phi_893_;
            if (_e81 <= _e185.x) {
                phi_974_ = 1f;
            } else {
                if (_e81 > _e185.y) {
                    let _e191 = local.moments;
                    let _e202 = (((_e191.y - (_e191.x * (_e185.x + _e185.y))) + (_e185.x * _e185.y)) / ((_e81 - _e185.x) * (_e81 - _e185.y)));
                    if ((bitcast<u32>(_e202) & 2147483647u) > 2139095040u) {
                        phi_933_ = _e202;
                    } else {
                        if (_e202 < 0f) {
                            phi_932_ = 0f;
                        } else {
                            if (_e202 > 1f) {
                                phi_931_ = 1f;
                            } else {
                                phi_931_ = _e202;
                            }
                            let _e209 = phi_931_;
                            phi_932_ = _e209;
                        }
                        let _e211 = phi_932_;
                        phi_933_ = _e211;
                    }
                    let _e213 = phi_933_;
                    phi_973_ = _e213;
                } else {
                    if (_e81 > _e185.x) {
                        let _e216 = local.moments;
                        let _e228 = (1f - (((_e216.y - (_e216.x * (_e81 + _e185.y))) + (_e81 * _e185.y)) / ((_e185.x - _e81) * (_e185.x - _e185.y))));
                        if ((bitcast<u32>(_e228) & 2147483647u) > 2139095040u) {
                            phi_968_ = _e228;
                        } else {
                            if (_e228 < 0f) {
                                phi_967_ = 0f;
                            } else {
                                if (_e228 > 1f) {
                                    phi_966_ = 1f;
                                } else {
                                    phi_966_ = _e228;
                                }
                                let _e235 = phi_966_;
                                phi_967_ = _e235;
                            }
                            let _e237 = phi_967_;
                            phi_968_ = _e237;
                        }
                        let _e239 = phi_968_;
                        phi_972_ = _e239;
                    } else {
                        phi_972_ = bitcast<f32>((bitcast<u32>(_e185.x) | 2143289344u));
                    }
                    let _e244 = phi_972_;
                    phi_973_ = _e244;
                }
                let _e246 = phi_973_;
                phi_974_ = _e246;
            }
            let _e248 = phi_974_;
            phi_975_ = _e248;
        } else {
            phi_975_ = _e128;
        }
        let _e250 = phi_975_;
        phi_1432_ = _e250;
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
            phi_1028_ = vec2<f32>((-(_e289) - _e294), (-(_e289) + _e294));
        } else {
            phi_1028_ = vec2(bitcast<f32>((bitcast<u32>(_e292) | 2143289344u)));
        }
        let _e305 = phi_1028_;
        if (_e305.x >= 0f) {
            if (_e305.y <= 1f) {
                let _e312 = local.moments[0u];
                let _e315 = local.moments[3u];
                if (_e312 == _e315) {
                    let _e319 = local.moments[0u];
                    phi_1050_ = (_e319 > 0.5f);
                } else {
                    phi_1050_ = false;
                }
                let _e322 = phi_1050_;
                if _e322 {
                    if (_e81 > 0f) {
                        let _e325 = local.moments;
                        if ((bitcast<u32>(_e325.x) & 2147483647u) > 2139095040u) {
                            phi_1077_ = _e325.x;
                        } else {
                            if (_e325.x < 0f) {
                                phi_1076_ = 0f;
                            } else {
                                if (_e325.x > 1f) {
                                    phi_1075_ = 1f;
                                } else {
                                    phi_1075_ = _e325.x;
                                }
                                let _e333 = phi_1075_;
                                phi_1076_ = _e333;
                            }
                            let _e335 = phi_1076_;
                            phi_1077_ = _e335;
                        }
                        let _e337 = phi_1077_;
                        phi_1078_ = _e337;
                        phi_1079_ = false;
                    } else {
                        phi_1078_ = f32();
                        phi_1079_ = true;
                    }
                    let _e339 = phi_1078_;
                    let _e341 = phi_1079_;
                    phi_1080_ = _e339;
                    phi_1081_ = _e341;
                } else {
                    phi_1080_ = f32();
                    phi_1081_ = true;
                }
                let _e343 = phi_1080_;
                let _e345 = phi_1081_;
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
                        phi_1137_ = vec2<f32>((-(_e384) - _e389), (-(_e384) + _e389));
                    } else {
                        phi_1137_ = vec2(bitcast<f32>((bitcast<u32>(_e387) | 2143289344u)));
                    }
                    let _e400 = phi_1137_;
                    if (_e81 <= _e400.x) {
                        phi_1218_ = 1f;
                    } else {
                        if (_e81 > _e400.y) {
                            let _e406 = local.moments;
                            let _e417 = (((_e406.y - (_e406.x * (_e400.x + _e400.y))) + (_e400.x * _e400.y)) / ((_e81 - _e400.x) * (_e81 - _e400.y)));
                            if ((bitcast<u32>(_e417) & 2147483647u) > 2139095040u) {
                                phi_1177_ = _e417;
                            } else {
                                if (_e417 < 0f) {
                                    phi_1176_ = 0f;
                                } else {
                                    if (_e417 > 1f) {
                                        phi_1175_ = 1f;
                                    } else {
                                        phi_1175_ = _e417;
                                    }
                                    let _e424 = phi_1175_;
                                    phi_1176_ = _e424;
                                }
                                let _e426 = phi_1176_;
                                phi_1177_ = _e426;
                            }
                            let _e428 = phi_1177_;
                            phi_1217_ = _e428;
                        } else {
                            if (_e81 > _e400.x) {
                                let _e431 = local.moments;
                                let _e443 = (1f - (((_e431.y - (_e431.x * (_e81 + _e400.y))) + (_e81 * _e400.y)) / ((_e400.x - _e81) * (_e400.x - _e400.y))));
                                if ((bitcast<u32>(_e443) & 2147483647u) > 2139095040u) {
                                    phi_1212_ = _e443;
                                } else {
                                    if (_e443 < 0f) {
                                        phi_1211_ = 0f;
                                    } else {
                                        if (_e443 > 1f) {
                                            phi_1210_ = 1f;
                                        } else {
                                            phi_1210_ = _e443;
                                        }
                                        let _e450 = phi_1210_;
                                        phi_1211_ = _e450;
                                    }
                                    let _e452 = phi_1211_;
                                    phi_1212_ = _e452;
                                }
                                let _e454 = phi_1212_;
                                phi_1216_ = _e454;
                            } else {
                                phi_1216_ = bitcast<f32>((bitcast<u32>(_e400.x) | 2143289344u));
                            }
                            let _e459 = phi_1216_;
                            phi_1217_ = _e459;
                        }
                        let _e461 = phi_1217_;
                        phi_1218_ = _e461;
                    }
                    let _e463 = phi_1218_;
                    phi_1219_ = _e463;
                } else {
                    phi_1219_ = _e343;
                }
                let _e465 = phi_1219_;
                phi_1220_ = _e465;
                phi_1221_ = false;
            } else {
                phi_1220_ = f32();
                phi_1221_ = true;
            }
            let _e467 = phi_1220_;
            let _e469 = phi_1221_;
            phi_1222_ = _e467;
            phi_1223_ = _e469;
        } else {
            phi_1222_ = f32();
            phi_1223_ = true;
        }
        let _e471 = phi_1222_;
        let _e473 = phi_1223_;
        if _e473 {
            if ((bitcast<u32>(_e305.x) & 2147483647u) > 2139095040u) {
                phi_1430_ = _e305.x;
            } else {
                let _e477 = lt_math_hausdorff_endpoint_upper_bound((&local), _e81);
                let _e480 = local.moments[0u];
                let _e483 = local.moments[3u];
                if (_e480 == _e483) {
                    let _e487 = local.moments[0u];
                    phi_1245_ = (_e487 > 0.5f);
                } else {
                    phi_1245_ = false;
                }
                let _e490 = phi_1245_;
                if _e490 {
                    if (_e81 > 0f) {
                        let _e493 = local.moments;
                        if ((bitcast<u32>(_e493.x) & 2147483647u) > 2139095040u) {
                            phi_1272_ = _e493.x;
                        } else {
                            if (_e493.x < 0f) {
                                phi_1271_ = 0f;
                            } else {
                                if (_e493.x > 1f) {
                                    phi_1270_ = 1f;
                                } else {
                                    phi_1270_ = _e493.x;
                                }
                                let _e501 = phi_1270_;
                                phi_1271_ = _e501;
                            }
                            let _e503 = phi_1271_;
                            phi_1272_ = _e503;
                        }
                        let _e505 = phi_1272_;
                        phi_1273_ = _e505;
                        phi_1274_ = false;
                    } else {
                        phi_1273_ = f32();
                        phi_1274_ = true;
                    }
                    let _e507 = phi_1273_;
                    let _e509 = phi_1274_;
                    phi_1275_ = _e507;
                    phi_1276_ = _e509;
                } else {
                    phi_1275_ = f32();
                    phi_1276_ = true;
                }
                let _e511 = phi_1275_;
                let _e513 = phi_1276_;
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
                        phi_1332_ = vec2<f32>((-(_e552) - _e557), (-(_e552) + _e557));
                    } else {
                        phi_1332_ = vec2(bitcast<f32>((bitcast<u32>(_e555) | 2143289344u)));
                    }
                    let _e568 = phi_1332_;
                    if (_e81 <= _e568.x) {
                        phi_1413_ = 1f;
                    } else {
                        if (_e81 > _e568.y) {
                            let _e574 = local.moments;
                            let _e585 = (((_e574.y - (_e574.x * (_e568.x + _e568.y))) + (_e568.x * _e568.y)) / ((_e81 - _e568.x) * (_e81 - _e568.y)));
                            if ((bitcast<u32>(_e585) & 2147483647u) > 2139095040u) {
                                phi_1372_ = _e585;
                            } else {
                                if (_e585 < 0f) {
                                    phi_1371_ = 0f;
                                } else {
                                    if (_e585 > 1f) {
                                        phi_1370_ = 1f;
                                    } else {
                                        phi_1370_ = _e585;
                                    }
                                    let _e592 = phi_1370_;
                                    phi_1371_ = _e592;
                                }
                                let _e594 = phi_1371_;
                                phi_1372_ = _e594;
                            }
                            let _e596 = phi_1372_;
                            phi_1412_ = _e596;
                        } else {
                            if (_e81 > _e568.x) {
                                let _e599 = local.moments;
                                let _e611 = (1f - (((_e599.y - (_e599.x * (_e81 + _e568.y))) + (_e81 * _e568.y)) / ((_e568.x - _e81) * (_e568.x - _e568.y))));
                                if ((bitcast<u32>(_e611) & 2147483647u) > 2139095040u) {
                                    phi_1407_ = _e611;
                                } else {
                                    if (_e611 < 0f) {
                                        phi_1406_ = 0f;
                                    } else {
                                        if (_e611 > 1f) {
                                            phi_1405_ = 1f;
                                        } else {
                                            phi_1405_ = _e611;
                                        }
                                        let _e618 = phi_1405_;
                                        phi_1406_ = _e618;
                                    }
                                    let _e620 = phi_1406_;
                                    phi_1407_ = _e620;
                                }
                                let _e622 = phi_1407_;
                                phi_1411_ = _e622;
                            } else {
                                phi_1411_ = bitcast<f32>((bitcast<u32>(_e568.x) | 2143289344u));
                            }
                            let _e627 = phi_1411_;
                            phi_1412_ = _e627;
                        }
                        let _e629 = phi_1412_;
                        phi_1413_ = _e629;
                    }
                    let _e631 = phi_1413_;
                    phi_1414_ = _e631;
                } else {
                    phi_1414_ = _e511;
                }
                let _e633 = phi_1414_;
                if ((bitcast<u32>(_e633) & 2147483647u) > 2139095040u) {
                    phi_1425_ = true;
                } else {
                    let _e637 = (_e633 < _e477);
                    if _e637 {
                    }
                    phi_1425_ = _e637;
                }
                let _e639 = phi_1425_;
                if _e639 {
                    phi_1429_ = _e633;
                } else {
                    phi_1429_ = _e477;
                }
                let _e641 = phi_1429_;
                phi_1430_ = _e641;
            }
            let _e643 = phi_1430_;
            phi_1431_ = _e643;
        } else {
            phi_1431_ = _e471;
        }
        let _e645 = phi_1431_;
        phi_1432_ = _e645;
    }
    let _e647 = phi_1432_;
    return _e647;
}

fn function_() {
    var local_1: f32;
    var phi_210_: bool;
    var phi_211_: bool;
    var phi_212_: bool;
    var phi_213_: bool;
    var phi_217_: bool;
    var phi_261_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_265_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_342_: bool;
    var phi_351_: bool;
    var phi_360_: bool;
    var phi_361_: bool;
    var phi_362_: bool;
    var phi_363_: bool;
    var phi_364_: bool;
    var phi_365_: bool;
    var phi_366_: bool;
    var phi_370_: bool;
    var phi_464_: f32;
    var phi_467_: f32;
    var phi_496_: f32;
    var phi_501_: f32;
    var phi_502_: bool;
    var phi_503_: f32;
    var phi_504_: bool;
    var phi_508_: f32;
    var phi_528_: f32;
    var phi_533_: f32;
    var phi_534_: bool;
    var phi_535_: f32;
    var phi_536_: bool;
    var phi_540_: f32;
    var phi_586_: i32;
    var phi_591_: i32;
    var phi_596_: i32;
    var phi_601_: i32;
    var phi_610_: i32;
    var phi_615_: i32;
    var phi_620_: i32;
    var phi_625_: i32;
    var phi_710_: evaluate_Verdict;
    var phi_711_: evaluate_Verdict;
    var phi_712_: bool;
    var phi_713_: evaluate_Verdict;
    var phi_714_: evaluate_Verdict;
    var phi_715_: bool;
    var phi_719_: evaluate_Verdict;

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
                phi_210_ = (_e75 == _e77);
                phi_211_ = false;
            } else {
                phi_210_ = bool();
                phi_211_ = true;
            }
            let _e80 = phi_210_;
            let _e82 = phi_211_;
            phi_212_ = _e80;
            phi_213_ = _e82;
        } else {
            phi_212_ = bool();
            phi_213_ = true;
        }
        let _e84 = phi_212_;
        let _e86 = phi_213_;
        if _e86 {
            phi_217_ = false;
        } else {
            phi_217_ = _e84;
        }
        let _e88 = phi_217_;
        if !(_e88) {
            let _e91 = samples.member[(0u + _e53.first_primitive)].normal;
            let _e93 = samples.member[(0u + _e53.first_primitive)].position;
            if ((((_e91.x * (_e62.x - (_e93.x * _e62.w))) + (_e91.y * (_e62.y - (_e93.y * _e62.w)))) + (_e91.z * (_e62.z - (_e93.z * _e62.w)))) > 0f) {
                let _e117 = samples.member[(0u + _e53.first_primitive)].flags;
                let _e125 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e131 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e125.unnamed.visibility, false), _e125.unnamed_1);
                phi_261_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e131.unnamed, ((_e117 & 1u) == 0u));
            } else {
                let _e140 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e146 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e140.unnamed.visibility, false), _e140.unnamed_1);
                phi_261_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e146.unnamed, true);
            }
            let _e151 = phi_261_;
            phi_265_ = _e151;
        } else {
            let _e157 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e163 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e157.unnamed.visibility, false), _e157.unnamed_1);
            phi_265_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e163.unnamed, true);
        }
        let _e168 = phi_265_;
        if _e168.unnamed_1 {
            phi_713_ = evaluate_Verdict(_e168.unnamed.visibility, _e168.unnamed.is_doubted);
            phi_714_ = evaluate_Verdict();
            phi_715_ = true;
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
                    phi_342_ = (_e207 <= 1f);
                } else {
                    phi_342_ = false;
                }
                let _e239 = phi_342_;
                if _e239 {
                    if (_e221 >= 0f) {
                        phi_351_ = (_e221 <= 1f);
                    } else {
                        phi_351_ = false;
                    }
                    let _e243 = phi_351_;
                    if _e243 {
                        if (_e234 >= 0f) {
                            phi_360_ = (_e234 <= 1f);
                        } else {
                            phi_360_ = false;
                        }
                        let _e247 = phi_360_;
                        phi_361_ = _e247;
                        phi_362_ = false;
                    } else {
                        phi_361_ = bool();
                        phi_362_ = true;
                    }
                    let _e249 = phi_361_;
                    let _e251 = phi_362_;
                    phi_363_ = _e249;
                    phi_364_ = _e251;
                } else {
                    phi_363_ = bool();
                    phi_364_ = true;
                }
                let _e253 = phi_363_;
                let _e255 = phi_364_;
                phi_365_ = _e253;
                phi_366_ = _e255;
            } else {
                phi_365_ = bool();
                phi_366_ = true;
            }
            let _e257 = phi_365_;
            let _e259 = phi_366_;
            if _e259 {
                phi_370_ = false;
            } else {
                phi_370_ = _e257;
            }
            let _e261 = phi_370_;
            if _e261 {
                if (0f > 0f) {
                    let _e264 = samples.member[(0u + _e53.first_primitive)].normal;
                    let _e266 = p.member.map_size;
                    let _e269 = p.member.projection.row_x;
                    let _e291 = p.member.projection.row_y;
                    let _e313 = p.member.projection.row_z;
                    let _e340 = ((abs(((((_e269.x * _e264.x) + (_e269.y * _e264.y)) + (_e269.z * _e264.z)) / (((_e269.x * _e269.x) + (_e269.y * _e269.y)) + (_e269.z * _e269.z)))) + abs(((((_e291.x * _e264.x) + (_e291.y * _e264.y)) + (_e291.z * _e264.z)) / (((_e291.x * _e291.x) + (_e291.y * _e291.y)) + (_e291.z * _e291.z))))) / (abs(((((_e313.x * _e264.x) + (_e313.y * _e264.y)) + (_e313.z * _e264.z)) / (((_e313.x * _e313.x) + (_e313.y * _e313.y)) + (_e313.z * _e313.z)))) * f32(_e266)));
                    if (_e340 < 0.002f) {
                        phi_464_ = _e340;
                    } else {
                        phi_464_ = 0.002f;
                    }
                    let _e343 = phi_464_;
                    phi_467_ = (_e234 - (0f * _e343));
                } else {
                    phi_467_ = _e234;
                }
                let _e347 = phi_467_;
                let _e349 = p.member.map_size;
                let _e350 = f32(_e349);
                let _e353 = ((_e207 * _e350) - 0.5f);
                let _e354 = ((_e221 * _e350) - 0.5f);
                if (_e353 > -8388608f) {
                    let _e366 = f32(select(0i, select(select(i32(_e353), i32(-2147483648), (_e353 < bitcast<f32>(3472883712u))), 2147483647i, (_e353 > bitcast<f32>(1325400063u))), (_e353 == _e353)));
                    if (_e366 > _e353) {
                        phi_496_ = 1f;
                    } else {
                        phi_496_ = 0f;
                    }
                    let _e369 = phi_496_;
                    if (_e353 < 8388608f) {
                        phi_501_ = (_e366 - _e369);
                        phi_502_ = false;
                    } else {
                        phi_501_ = f32();
                        phi_502_ = true;
                    }
                    let _e372 = phi_501_;
                    let _e374 = phi_502_;
                    phi_503_ = _e372;
                    phi_504_ = _e374;
                } else {
                    phi_503_ = f32();
                    phi_504_ = true;
                }
                let _e376 = phi_503_;
                let _e378 = phi_504_;
                if _e378 {
                    phi_508_ = _e353;
                } else {
                    phi_508_ = _e376;
                }
                let _e380 = phi_508_;
                if (_e354 > -8388608f) {
                    let _e392 = f32(select(0i, select(select(i32(_e354), i32(-2147483648), (_e354 < bitcast<f32>(3472883712u))), 2147483647i, (_e354 > bitcast<f32>(1325400063u))), (_e354 == _e354)));
                    if (_e392 > _e354) {
                        phi_528_ = 1f;
                    } else {
                        phi_528_ = 0f;
                    }
                    let _e395 = phi_528_;
                    if (_e354 < 8388608f) {
                        phi_533_ = (_e392 - _e395);
                        phi_534_ = false;
                    } else {
                        phi_533_ = f32();
                        phi_534_ = true;
                    }
                    let _e398 = phi_533_;
                    let _e400 = phi_534_;
                    phi_535_ = _e398;
                    phi_536_ = _e400;
                } else {
                    phi_535_ = f32();
                    phi_536_ = true;
                }
                let _e402 = phi_535_;
                let _e404 = phi_536_;
                if _e404 {
                    phi_540_ = _e354;
                } else {
                    phi_540_ = _e402;
                }
                let _e406 = phi_540_;
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
                    phi_586_ = _e417;
                } else {
                    phi_586_ = 0i;
                }
                let _e444 = phi_586_;
                if (_e426 > 0i) {
                    phi_591_ = _e426;
                } else {
                    phi_591_ = 0i;
                }
                let _e447 = phi_591_;
                if (_e444 < _e441) {
                    phi_596_ = _e444;
                } else {
                    phi_596_ = _e441;
                }
                let _e450 = phi_596_;
                if (_e447 < _e441) {
                    phi_601_ = _e447;
                } else {
                    phi_601_ = _e441;
                }
                let _e453 = phi_601_;
                let _e454 = bitcast<u32>(_e450);
                let _e456 = (_e417 + 1i);
                let _e457 = (_e426 + 1i);
                if (_e456 > 0i) {
                    phi_610_ = _e456;
                } else {
                    phi_610_ = 0i;
                }
                let _e460 = phi_610_;
                if (_e457 > 0i) {
                    phi_615_ = _e457;
                } else {
                    phi_615_ = 0i;
                }
                let _e463 = phi_615_;
                if (_e460 < _e441) {
                    phi_620_ = _e460;
                } else {
                    phi_620_ = _e441;
                }
                let _e466 = phi_620_;
                if (_e463 < _e441) {
                    phi_625_ = _e463;
                } else {
                    phi_625_ = _e441;
                }
                let _e469 = phi_625_;
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
                let _e493 = map.member[(0u + _e475)];
                if (_e476 < _e44) {
                } else {
                    return;
                }
                let _e509 = map.member[(0u + _e476)];
                if (_e477 < _e44) {
                } else {
                    return;
                }
                let _e525 = map.member[(0u + _e477)];
                let _e539 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_1), vec4<f32>(((((_e481.x * _e429) + (_e493.x * _e431)) + (_e509.x * _e433)) + (_e525.x * _e434)), ((((_e481.y * _e429) + (_e493.y * _e431)) + (_e509.y * _e433)) + (_e525.y * _e434)), ((((_e481.z * _e429) + (_e493.z * _e431)) + (_e509.z * _e433)) + (_e525.z * _e434)), ((((_e481.w * _e429) + (_e493.w * _e431)) + (_e509.w * _e433)) + (_e525.w * _e434))), _e347);
                phi_710_ = evaluate_Verdict(_e539, false);
                phi_711_ = evaluate_Verdict();
                phi_712_ = false;
            } else {
                phi_710_ = evaluate_Verdict();
                phi_711_ = evaluate_Verdict(1f, false);
                phi_712_ = true;
            }
            let _e543 = phi_710_;
            let _e545 = phi_711_;
            let _e547 = phi_712_;
            phi_713_ = _e545;
            phi_714_ = _e543;
            phi_715_ = _e547;
        }
        let _e549 = phi_713_;
        let _e551 = phi_714_;
        let _e553 = phi_715_;
        if _e553 {
            phi_719_ = _e549;
        } else {
            phi_719_ = _e551;
        }
        let _e555 = phi_719_;
        if (_e53.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e53.first_primitive)] = _e555.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_msm_hausdorff_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
