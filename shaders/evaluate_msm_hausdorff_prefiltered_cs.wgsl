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
    var phi_147_: lt_bvh_traverse_Tree;
    var phi_148_: bool;
    var phi_149_: lt_bvh_traverse_Tree;
    var phi_150_: bool;
    var phi_155_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_147_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_148_ = false;
        } else {
            phi_147_ = lt_bvh_traverse_Tree();
            phi_148_ = true;
        }
        let _e49 = phi_147_;
        let _e51 = phi_148_;
        phi_149_ = _e49;
        phi_150_ = _e51;
    } else {
        phi_149_ = lt_bvh_traverse_Tree();
        phi_150_ = true;
    }
    let _e53 = phi_149_;
    let _e55 = phi_150_;
    if _e55 {
        phi_155_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_155_ = _e53;
    }
    let _e60 = phi_155_;
    return lt_bvh_traverse_Tree(_e60.root, _e60.first_primitive);
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn lt_math_hausdorff_cubic_mass(param_4: vec4<f32>, param_5: f32, param_6: f32, param_7: f32, param_8: f32) -> f32 {
    return ((((param_4.z - (((param_6 + param_7) + param_8) * param_4.y)) + ((((param_6 * param_7) + (param_6 * param_8)) + (param_7 * param_8)) * param_4.x)) - ((param_6 * param_7) * param_8)) / (((param_5 - param_6) * (param_5 - param_7)) * (param_5 - param_8)));
}

fn lt_math_hausdorff_endpoint_upper_bound(param_9: ptr<function, hankel_HankelFactors>, param_10: f32) -> f32 {
    var phi_1544_: f32;
    var phi_1545_: f32;
    var phi_1546_: f32;
    var phi_1573_: f32;
    var phi_1574_: f32;
    var phi_1575_: f32;
    var phi_1576_: f32;
    var phi_1577_: bool;
    var phi_1578_: f32;
    var phi_1579_: bool;
    var phi_1607_: f32;
    var phi_1608_: f32;
    var phi_1609_: f32;
    var phi_1610_: f32;
    var phi_1611_: bool;
    var phi_1612_: f32;
    var phi_1613_: bool;
    var phi_1620_: f32;
    var phi_1621_: f32;
    var phi_1622_: f32;
    var phi_1623_: f32;

    let _e39 = (*param_9).moments;
    if (param_10 < 0.0001f) {
        phi_1623_ = 1f;
    } else {
        let _e48 = ((_e39.z - ((1f + param_10) * _e39.y)) + (param_10 * _e39.x));
        let _e57 = (((_e39.w - ((1f + param_10) * _e39.z)) + (param_10 * _e39.y)) / _e48);
        if (abs(_e48) <= 0.00000047683716f) {
            let _e71 = (1f - (((_e39.y - (_e39.x * (param_10 + 1f))) + (param_10 * 1f)) / ((0f - param_10) * (0f - 1f))));
            if ((bitcast<u32>(_e71) & 2147483647u) > 2139095040u) {
                phi_1546_ = _e71;
            } else {
                if (_e71 < 0f) {
                    phi_1545_ = 0f;
                } else {
                    if (_e71 > 1f) {
                        phi_1544_ = 1f;
                    } else {
                        phi_1544_ = _e71;
                    }
                    let _e78 = phi_1544_;
                    phi_1545_ = _e78;
                }
                let _e80 = phi_1545_;
                phi_1546_ = _e80;
            }
            let _e82 = phi_1546_;
            phi_1622_ = _e82;
        } else {
            if (_e57 > 0f) {
                if (_e57 < param_10) {
                    let _e85 = lt_math_hausdorff_cubic_mass(_e39, 0f, _e57, param_10, 1f);
                    let _e87 = lt_math_hausdorff_cubic_mass(_e39, _e57, 0f, param_10, 1f);
                    let _e88 = ((1f - _e85) - _e87);
                    if ((bitcast<u32>(_e88) & 2147483647u) > 2139095040u) {
                        phi_1575_ = _e88;
                    } else {
                        if (_e88 < 0f) {
                            phi_1574_ = 0f;
                        } else {
                            if (_e88 > 1f) {
                                phi_1573_ = 1f;
                            } else {
                                phi_1573_ = _e88;
                            }
                            let _e95 = phi_1573_;
                            phi_1574_ = _e95;
                        }
                        let _e97 = phi_1574_;
                        phi_1575_ = _e97;
                    }
                    let _e99 = phi_1575_;
                    phi_1576_ = _e99;
                    phi_1577_ = false;
                } else {
                    phi_1576_ = f32();
                    phi_1577_ = true;
                }
                let _e101 = phi_1576_;
                let _e103 = phi_1577_;
                phi_1578_ = _e101;
                phi_1579_ = _e103;
            } else {
                phi_1578_ = f32();
                phi_1579_ = true;
            }
            let _e105 = phi_1578_;
            let _e107 = phi_1579_;
            if _e107 {
                if (_e57 > param_10) {
                    if (_e57 < 1f) {
                        let _e110 = lt_math_hausdorff_cubic_mass(_e39, 0f, _e57, param_10, 1f);
                        let _e111 = (1f - _e110);
                        if ((bitcast<u32>(_e111) & 2147483647u) > 2139095040u) {
                            phi_1609_ = _e111;
                        } else {
                            if (_e111 < 0f) {
                                phi_1608_ = 0f;
                            } else {
                                if (_e111 > 1f) {
                                    phi_1607_ = 1f;
                                } else {
                                    phi_1607_ = _e111;
                                }
                                let _e118 = phi_1607_;
                                phi_1608_ = _e118;
                            }
                            let _e120 = phi_1608_;
                            phi_1609_ = _e120;
                        }
                        let _e122 = phi_1609_;
                        phi_1610_ = _e122;
                        phi_1611_ = false;
                    } else {
                        phi_1610_ = f32();
                        phi_1611_ = true;
                    }
                    let _e124 = phi_1610_;
                    let _e126 = phi_1611_;
                    phi_1612_ = _e124;
                    phi_1613_ = _e126;
                } else {
                    phi_1612_ = f32();
                    phi_1613_ = true;
                }
                let _e128 = phi_1612_;
                let _e130 = phi_1613_;
                if _e130 {
                    phi_1620_ = bitcast<f32>((bitcast<u32>(_e57) | 2143289344u));
                } else {
                    phi_1620_ = _e128;
                }
                let _e135 = phi_1620_;
                phi_1621_ = _e135;
            } else {
                phi_1621_ = _e105;
            }
            let _e137 = phi_1621_;
            phi_1622_ = _e137;
        }
        let _e139 = phi_1622_;
        phi_1623_ = _e139;
    }
    let _e141 = phi_1623_;
    return _e141;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_11: ptr<function, f32>, param_12: vec4<f32>, param_13: f32) -> f32 {
    var local: hankel_HankelFactors;
    var phi_831_: f32;
    var phi_832_: f32;
    var phi_833_: f32;
    var phi_845_: bool;
    var phi_860_: bool;
    var phi_885_: f32;
    var phi_886_: f32;
    var phi_887_: f32;
    var phi_888_: f32;
    var phi_889_: bool;
    var phi_890_: f32;
    var phi_891_: bool;
    var phi_947_: vec2<f32>;
    var phi_985_: f32;
    var phi_986_: f32;
    var phi_987_: f32;
    var phi_1020_: f32;
    var phi_1021_: f32;
    var phi_1022_: f32;
    var phi_1026_: f32;
    var phi_1027_: f32;
    var phi_1028_: f32;
    var phi_1029_: f32;
    var phi_1082_: vec2<f32>;
    var phi_1104_: bool;
    var phi_1129_: f32;
    var phi_1130_: f32;
    var phi_1131_: f32;
    var phi_1132_: f32;
    var phi_1133_: bool;
    var phi_1134_: f32;
    var phi_1135_: bool;
    var phi_1191_: vec2<f32>;
    var phi_1229_: f32;
    var phi_1230_: f32;
    var phi_1231_: f32;
    var phi_1264_: f32;
    var phi_1265_: f32;
    var phi_1266_: f32;
    var phi_1270_: f32;
    var phi_1271_: f32;
    var phi_1272_: f32;
    var phi_1273_: f32;
    var phi_1274_: f32;
    var phi_1275_: bool;
    var phi_1276_: f32;
    var phi_1277_: bool;
    var phi_1299_: bool;
    var phi_1324_: f32;
    var phi_1325_: f32;
    var phi_1326_: f32;
    var phi_1327_: f32;
    var phi_1328_: bool;
    var phi_1329_: f32;
    var phi_1330_: bool;
    var phi_1386_: vec2<f32>;
    var phi_1424_: f32;
    var phi_1425_: f32;
    var phi_1426_: f32;
    var phi_1459_: f32;
    var phi_1460_: f32;
    var phi_1461_: f32;
    var phi_1465_: f32;
    var phi_1466_: f32;
    var phi_1467_: f32;
    var phi_1468_: f32;
    var phi_1479_: bool;
    var phi_1483_: f32;
    var phi_1484_: f32;
    var phi_1485_: f32;
    var phi_1486_: f32;

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
        phi_833_ = param_13;
    } else {
        if (param_13 < 0f) {
            phi_832_ = 0f;
        } else {
            if (param_13 > 1f) {
                phi_831_ = 1f;
            } else {
                phi_831_ = param_13;
            }
            let _e77 = phi_831_;
            phi_832_ = _e77;
        }
        let _e79 = phi_832_;
        phi_833_ = _e79;
    }
    let _e81 = phi_833_;
    let _e84 = local.moments[0u];
    let _e87 = local.moments[3u];
    if (_e84 == _e87) {
        let _e91 = local.moments[0u];
        phi_845_ = (_e91 > 0.5f);
    } else {
        phi_845_ = false;
    }
    let _e94 = phi_845_;
    if _e94 {
        let _e97 = local.moments[0u];
        let _e100 = local.moments[3u];
        if (_e97 == _e100) {
            let _e104 = local.moments[0u];
            phi_860_ = (_e104 > 0.5f);
        } else {
            phi_860_ = false;
        }
        let _e107 = phi_860_;
        if _e107 {
            if (_e81 > 0f) {
                let _e110 = local.moments;
                if ((bitcast<u32>(_e110.x) & 2147483647u) > 2139095040u) {
                    phi_887_ = _e110.x;
                } else {
                    if (_e110.x < 0f) {
                        phi_886_ = 0f;
                    } else {
                        if (_e110.x > 1f) {
                            phi_885_ = 1f;
                        } else {
                            phi_885_ = _e110.x;
                        }
                        let _e118 = phi_885_;
                        phi_886_ = _e118;
                    }
                    let _e120 = phi_886_;
                    phi_887_ = _e120;
                }
                let _e122 = phi_887_;
                phi_888_ = _e122;
                phi_889_ = false;
            } else {
                phi_888_ = f32();
                phi_889_ = true;
            }
            let _e124 = phi_888_;
            let _e126 = phi_889_;
            phi_890_ = _e124;
            phi_891_ = _e126;
        } else {
            phi_890_ = f32();
            phi_891_ = true;
        }
        let _e128 = phi_890_;
        let _e130 = phi_891_;
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
                phi_947_ = vec2<f32>((-(_e169) - _e174), (-(_e169) + _e174));
            } else {
                phi_947_ = vec2(bitcast<f32>((bitcast<u32>(_e172) | 2143289344u)));
            }
            let _e185 = phi_947_;
            if (_e81 <= _e185.x) {
                phi_1028_ = 1f;
            } else {
                if (_e81 > _e185.y) {
                    let _e191 = local.moments;
                    let _e202 = (((_e191.y - (_e191.x * (_e185.x + _e185.y))) + (_e185.x * _e185.y)) / ((_e81 - _e185.x) * (_e81 - _e185.y)));
                    if ((bitcast<u32>(_e202) & 2147483647u) > 2139095040u) {
                        phi_987_ = _e202;
                    } else {
                        if (_e202 < 0f) {
                            phi_986_ = 0f;
                        } else {
                            if (_e202 > 1f) {
                                phi_985_ = 1f;
                            } else {
                                phi_985_ = _e202;
                            }
                            let _e209 = phi_985_;
                            phi_986_ = _e209;
                        }
                        let _e211 = phi_986_;
                        phi_987_ = _e211;
                    }
                    let _e213 = phi_987_;
                    phi_1027_ = _e213;
                } else {
                    if (_e81 > _e185.x) {
                        let _e216 = local.moments;
                        let _e228 = (1f - (((_e216.y - (_e216.x * (_e81 + _e185.y))) + (_e81 * _e185.y)) / ((_e185.x - _e81) * (_e185.x - _e185.y))));
                        if ((bitcast<u32>(_e228) & 2147483647u) > 2139095040u) {
                            phi_1022_ = _e228;
                        } else {
                            if (_e228 < 0f) {
                                phi_1021_ = 0f;
                            } else {
                                if (_e228 > 1f) {
                                    phi_1020_ = 1f;
                                } else {
                                    phi_1020_ = _e228;
                                }
                                let _e235 = phi_1020_;
                                phi_1021_ = _e235;
                            }
                            let _e237 = phi_1021_;
                            phi_1022_ = _e237;
                        }
                        let _e239 = phi_1022_;
                        phi_1026_ = _e239;
                    } else {
                        phi_1026_ = bitcast<f32>((bitcast<u32>(_e185.x) | 2143289344u));
                    }
                    let _e244 = phi_1026_;
                    phi_1027_ = _e244;
                }
                let _e246 = phi_1027_;
                phi_1028_ = _e246;
            }
            let _e248 = phi_1028_;
            phi_1029_ = _e248;
        } else {
            phi_1029_ = _e128;
        }
        let _e250 = phi_1029_;
        phi_1486_ = _e250;
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
            phi_1082_ = vec2<f32>((-(_e289) - _e294), (-(_e289) + _e294));
        } else {
            phi_1082_ = vec2(bitcast<f32>((bitcast<u32>(_e292) | 2143289344u)));
        }
        let _e305 = phi_1082_;
        if (_e305.x >= 0f) {
            if (_e305.y <= 1f) {
                let _e312 = local.moments[0u];
                let _e315 = local.moments[3u];
                if (_e312 == _e315) {
                    let _e319 = local.moments[0u];
                    phi_1104_ = (_e319 > 0.5f);
                } else {
                    phi_1104_ = false;
                }
                let _e322 = phi_1104_;
                if _e322 {
                    if (_e81 > 0f) {
                        let _e325 = local.moments;
                        if ((bitcast<u32>(_e325.x) & 2147483647u) > 2139095040u) {
                            phi_1131_ = _e325.x;
                        } else {
                            if (_e325.x < 0f) {
                                phi_1130_ = 0f;
                            } else {
                                if (_e325.x > 1f) {
                                    phi_1129_ = 1f;
                                } else {
                                    phi_1129_ = _e325.x;
                                }
                                let _e333 = phi_1129_;
                                phi_1130_ = _e333;
                            }
                            let _e335 = phi_1130_;
                            phi_1131_ = _e335;
                        }
                        let _e337 = phi_1131_;
                        phi_1132_ = _e337;
                        phi_1133_ = false;
                    } else {
                        phi_1132_ = f32();
                        phi_1133_ = true;
                    }
                    let _e339 = phi_1132_;
                    let _e341 = phi_1133_;
                    phi_1134_ = _e339;
                    phi_1135_ = _e341;
                } else {
                    phi_1134_ = f32();
                    phi_1135_ = true;
                }
                let _e343 = phi_1134_;
                let _e345 = phi_1135_;
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
                        phi_1191_ = vec2<f32>((-(_e384) - _e389), (-(_e384) + _e389));
                    } else {
                        phi_1191_ = vec2(bitcast<f32>((bitcast<u32>(_e387) | 2143289344u)));
                    }
                    let _e400 = phi_1191_;
                    if (_e81 <= _e400.x) {
                        phi_1272_ = 1f;
                    } else {
                        if (_e81 > _e400.y) {
                            let _e406 = local.moments;
                            let _e417 = (((_e406.y - (_e406.x * (_e400.x + _e400.y))) + (_e400.x * _e400.y)) / ((_e81 - _e400.x) * (_e81 - _e400.y)));
                            if ((bitcast<u32>(_e417) & 2147483647u) > 2139095040u) {
                                phi_1231_ = _e417;
                            } else {
                                if (_e417 < 0f) {
                                    phi_1230_ = 0f;
                                } else {
                                    if (_e417 > 1f) {
                                        phi_1229_ = 1f;
                                    } else {
                                        phi_1229_ = _e417;
                                    }
                                    let _e424 = phi_1229_;
                                    phi_1230_ = _e424;
                                }
                                let _e426 = phi_1230_;
                                phi_1231_ = _e426;
                            }
                            let _e428 = phi_1231_;
                            phi_1271_ = _e428;
                        } else {
                            if (_e81 > _e400.x) {
                                let _e431 = local.moments;
                                let _e443 = (1f - (((_e431.y - (_e431.x * (_e81 + _e400.y))) + (_e81 * _e400.y)) / ((_e400.x - _e81) * (_e400.x - _e400.y))));
                                if ((bitcast<u32>(_e443) & 2147483647u) > 2139095040u) {
                                    phi_1266_ = _e443;
                                } else {
                                    if (_e443 < 0f) {
                                        phi_1265_ = 0f;
                                    } else {
                                        if (_e443 > 1f) {
                                            phi_1264_ = 1f;
                                        } else {
                                            phi_1264_ = _e443;
                                        }
                                        let _e450 = phi_1264_;
                                        phi_1265_ = _e450;
                                    }
                                    let _e452 = phi_1265_;
                                    phi_1266_ = _e452;
                                }
                                let _e454 = phi_1266_;
                                phi_1270_ = _e454;
                            } else {
                                phi_1270_ = bitcast<f32>((bitcast<u32>(_e400.x) | 2143289344u));
                            }
                            let _e459 = phi_1270_;
                            phi_1271_ = _e459;
                        }
                        let _e461 = phi_1271_;
                        phi_1272_ = _e461;
                    }
                    let _e463 = phi_1272_;
                    phi_1273_ = _e463;
                } else {
                    phi_1273_ = _e343;
                }
                let _e465 = phi_1273_;
                phi_1274_ = _e465;
                phi_1275_ = false;
            } else {
                phi_1274_ = f32();
                phi_1275_ = true;
            }
            let _e467 = phi_1274_;
            let _e469 = phi_1275_;
            phi_1276_ = _e467;
            phi_1277_ = _e469;
        } else {
            phi_1276_ = f32();
            phi_1277_ = true;
        }
        let _e471 = phi_1276_;
        let _e473 = phi_1277_;
        if _e473 {
            if ((bitcast<u32>(_e305.x) & 2147483647u) > 2139095040u) {
                phi_1484_ = _e305.x;
            } else {
                let _e477 = lt_math_hausdorff_endpoint_upper_bound((&local), _e81);
                let _e480 = local.moments[0u];
                let _e483 = local.moments[3u];
                if (_e480 == _e483) {
                    let _e487 = local.moments[0u];
                    phi_1299_ = (_e487 > 0.5f);
                } else {
                    phi_1299_ = false;
                }
                let _e490 = phi_1299_;
                if _e490 {
                    if (_e81 > 0f) {
                        let _e493 = local.moments;
                        if ((bitcast<u32>(_e493.x) & 2147483647u) > 2139095040u) {
                            phi_1326_ = _e493.x;
                        } else {
                            if (_e493.x < 0f) {
                                phi_1325_ = 0f;
                            } else {
                                if (_e493.x > 1f) {
                                    phi_1324_ = 1f;
                                } else {
                                    phi_1324_ = _e493.x;
                                }
                                let _e501 = phi_1324_;
                                phi_1325_ = _e501;
                            }
                            let _e503 = phi_1325_;
                            phi_1326_ = _e503;
                        }
                        let _e505 = phi_1326_;
                        phi_1327_ = _e505;
                        phi_1328_ = false;
                    } else {
                        phi_1327_ = f32();
                        phi_1328_ = true;
                    }
                    let _e507 = phi_1327_;
                    let _e509 = phi_1328_;
                    phi_1329_ = _e507;
                    phi_1330_ = _e509;
                } else {
                    phi_1329_ = f32();
                    phi_1330_ = true;
                }
                let _e511 = phi_1329_;
                let _e513 = phi_1330_;
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
                        phi_1386_ = vec2<f32>((-(_e552) - _e557), (-(_e552) + _e557));
                    } else {
                        phi_1386_ = vec2(bitcast<f32>((bitcast<u32>(_e555) | 2143289344u)));
                    }
                    let _e568 = phi_1386_;
                    if (_e81 <= _e568.x) {
                        phi_1467_ = 1f;
                    } else {
                        if (_e81 > _e568.y) {
                            let _e574 = local.moments;
                            let _e585 = (((_e574.y - (_e574.x * (_e568.x + _e568.y))) + (_e568.x * _e568.y)) / ((_e81 - _e568.x) * (_e81 - _e568.y)));
                            if ((bitcast<u32>(_e585) & 2147483647u) > 2139095040u) {
                                phi_1426_ = _e585;
                            } else {
                                if (_e585 < 0f) {
                                    phi_1425_ = 0f;
                                } else {
                                    if (_e585 > 1f) {
                                        phi_1424_ = 1f;
                                    } else {
                                        phi_1424_ = _e585;
                                    }
                                    let _e592 = phi_1424_;
                                    phi_1425_ = _e592;
                                }
                                let _e594 = phi_1425_;
                                phi_1426_ = _e594;
                            }
                            let _e596 = phi_1426_;
                            phi_1466_ = _e596;
                        } else {
                            if (_e81 > _e568.x) {
                                let _e599 = local.moments;
                                let _e611 = (1f - (((_e599.y - (_e599.x * (_e81 + _e568.y))) + (_e81 * _e568.y)) / ((_e568.x - _e81) * (_e568.x - _e568.y))));
                                if ((bitcast<u32>(_e611) & 2147483647u) > 2139095040u) {
                                    phi_1461_ = _e611;
                                } else {
                                    if (_e611 < 0f) {
                                        phi_1460_ = 0f;
                                    } else {
                                        if (_e611 > 1f) {
                                            phi_1459_ = 1f;
                                        } else {
                                            phi_1459_ = _e611;
                                        }
                                        let _e618 = phi_1459_;
                                        phi_1460_ = _e618;
                                    }
                                    let _e620 = phi_1460_;
                                    phi_1461_ = _e620;
                                }
                                let _e622 = phi_1461_;
                                phi_1465_ = _e622;
                            } else {
                                phi_1465_ = bitcast<f32>((bitcast<u32>(_e568.x) | 2143289344u));
                            }
                            let _e627 = phi_1465_;
                            phi_1466_ = _e627;
                        }
                        let _e629 = phi_1466_;
                        phi_1467_ = _e629;
                    }
                    let _e631 = phi_1467_;
                    phi_1468_ = _e631;
                } else {
                    phi_1468_ = _e511;
                }
                let _e633 = phi_1468_;
                if ((bitcast<u32>(_e633) & 2147483647u) > 2139095040u) {
                    phi_1479_ = true;
                } else {
                    let _e637 = (_e633 < _e477);
                    if _e637 {
                    }
                    phi_1479_ = _e637;
                }
                let _e639 = phi_1479_;
                if _e639 {
                    phi_1483_ = _e633;
                } else {
                    phi_1483_ = _e477;
                }
                let _e641 = phi_1483_;
                phi_1484_ = _e641;
            }
            let _e643 = phi_1484_;
            phi_1485_ = _e643;
        } else {
            phi_1485_ = _e471;
        }
        let _e645 = phi_1485_;
        phi_1486_ = _e645;
    }
    let _e647 = phi_1486_;
    return _e647;
}

fn function_() {
    var local_1: f32;
    var phi_217_: bool;
    var phi_218_: bool;
    var phi_219_: bool;
    var phi_220_: bool;
    var phi_224_: bool;
    var phi_294_: bool;
    var phi_295_: bool;
    var phi_306_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_307_: bool;
    var phi_308_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_309_: bool;
    var phi_316_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_320_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_394_: bool;
    var phi_403_: bool;
    var phi_412_: bool;
    var phi_413_: bool;
    var phi_414_: bool;
    var phi_415_: bool;
    var phi_416_: bool;
    var phi_417_: bool;
    var phi_418_: bool;
    var phi_422_: bool;
    var phi_512_: f32;
    var phi_515_: f32;
    var phi_544_: f32;
    var phi_549_: f32;
    var phi_550_: bool;
    var phi_551_: f32;
    var phi_552_: bool;
    var phi_556_: f32;
    var phi_576_: f32;
    var phi_581_: f32;
    var phi_582_: bool;
    var phi_583_: f32;
    var phi_584_: bool;
    var phi_588_: f32;
    var phi_636_: i32;
    var phi_641_: i32;
    var phi_646_: i32;
    var phi_651_: i32;
    var phi_660_: i32;
    var phi_665_: i32;
    var phi_670_: i32;
    var phi_675_: i32;
    var phi_764_: evaluate_Verdict;
    var phi_765_: evaluate_Verdict;
    var phi_766_: bool;
    var phi_767_: evaluate_Verdict;
    var phi_768_: evaluate_Verdict;
    var phi_769_: bool;
    var phi_773_: evaluate_Verdict;

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
        let _e67 = samples.member[(0u + _e53.first_primitive)].normal[0u];
        let _e69 = global[0u];
        if (_e67 == _e69) {
            let _e72 = samples.member[(0u + _e53.first_primitive)].normal[1u];
            let _e74 = global[1u];
            if (_e72 == _e74) {
                let _e77 = samples.member[(0u + _e53.first_primitive)].normal[2u];
                let _e79 = global[2u];
                phi_217_ = (_e77 == _e79);
                phi_218_ = false;
            } else {
                phi_217_ = bool();
                phi_218_ = true;
            }
            let _e82 = phi_217_;
            let _e84 = phi_218_;
            phi_219_ = _e82;
            phi_220_ = _e84;
        } else {
            phi_219_ = bool();
            phi_220_ = true;
        }
        let _e86 = phi_219_;
        let _e88 = phi_220_;
        if _e88 {
            phi_224_ = false;
        } else {
            phi_224_ = _e86;
        }
        let _e90 = phi_224_;
        if !(_e90) {
            let _e93 = samples.member[(0u + _e53.first_primitive)].position;
            let _e95 = p.member.light.place;
            let _e101 = p.member.light.place[3u];
            let _e108 = (_e95.x - (_e93.x * _e101));
            let _e109 = (_e95.y - (_e93.y * _e101));
            let _e110 = (_e95.z - (_e93.z * _e101));
            let _e112 = samples.member[(0u + _e53.first_primitive)].normal;
            if ((((_e112.x * _e108) + (_e112.y * _e109)) + (_e112.z * _e110)) > 0f) {
                let _e126 = (((_e108 * _e108) + (_e109 * _e109)) + (_e110 * _e110));
                let _e128 = p.member.light.axis;
                let _e140 = p.member.light.place[3u];
                if (_e140 == 0f) {
                    phi_295_ = true;
                } else {
                    let _e143 = p.member.light.range_squared;
                    if (_e126 <= _e143) {
                        let _e146 = p.member.light.cos_outer;
                        phi_294_ = (-((((_e108 * _e128.x) + (_e109 * _e128.y)) + (_e110 * _e128.z))) >= (_e146 * sqrt(_e126)));
                    } else {
                        phi_294_ = false;
                    }
                    let _e151 = phi_294_;
                    phi_295_ = _e151;
                }
                let _e153 = phi_295_;
                if _e153 {
                    let _e155 = samples.member[(0u + _e53.first_primitive)].flags;
                    let _e163 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e169 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e163.unnamed.visibility, false), _e163.unnamed_1);
                    phi_306_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e169.unnamed, ((_e155 & 1u) == 0u));
                    phi_307_ = false;
                } else {
                    phi_306_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_307_ = true;
                }
                let _e174 = phi_306_;
                let _e176 = phi_307_;
                phi_308_ = _e174;
                phi_309_ = _e176;
            } else {
                phi_308_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_309_ = true;
            }
            let _e178 = phi_308_;
            let _e180 = phi_309_;
            if _e180 {
                let _e186 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e192 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e186.unnamed.visibility, false), _e186.unnamed_1);
                phi_316_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e192.unnamed, true);
            } else {
                phi_316_ = _e178;
            }
            let _e197 = phi_316_;
            phi_320_ = _e197;
        } else {
            let _e203 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e209 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e203.unnamed.visibility, false), _e203.unnamed_1);
            phi_320_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e209.unnamed, true);
        }
        let _e214 = phi_320_;
        if _e214.unnamed_1 {
            phi_767_ = evaluate_Verdict(_e214.unnamed.visibility, _e214.unnamed.is_doubted);
            phi_768_ = evaluate_Verdict();
            phi_769_ = true;
        } else {
            let _e222 = samples.member[(0u + _e53.first_primitive)].position;
            let _e240 = ((((_e63.projection.row_w.x * _e222.x) + (_e63.projection.row_w.y * _e222.y)) + (_e63.projection.row_w.z * _e222.z)) + (_e63.projection.row_w.w * 1f));
            let _e254 = (((((_e63.projection.row_x.x * _e222.x) + (_e63.projection.row_x.y * _e222.y)) + (_e63.projection.row_x.z * _e222.z)) + (_e63.projection.row_x.w * 1f)) / _e240);
            let _e268 = (((((_e63.projection.row_y.x * _e222.x) + (_e63.projection.row_y.y * _e222.y)) + (_e63.projection.row_y.z * _e222.z)) + (_e63.projection.row_y.w * 1f)) / _e240);
            let _e281 = ((((_e63.projection.row_z.x * _e222.x) + (_e63.projection.row_z.y * _e222.y)) + (_e63.projection.row_z.z * _e222.z)) + (_e63.projection.row_z.w * 1f));
            if (_e240 > 0f) {
                if (_e254 >= 0f) {
                    phi_394_ = (_e254 <= 1f);
                } else {
                    phi_394_ = false;
                }
                let _e286 = phi_394_;
                if _e286 {
                    if (_e268 >= 0f) {
                        phi_403_ = (_e268 <= 1f);
                    } else {
                        phi_403_ = false;
                    }
                    let _e290 = phi_403_;
                    if _e290 {
                        if (_e281 >= 0f) {
                            phi_412_ = (_e281 <= 1f);
                        } else {
                            phi_412_ = false;
                        }
                        let _e294 = phi_412_;
                        phi_413_ = _e294;
                        phi_414_ = false;
                    } else {
                        phi_413_ = bool();
                        phi_414_ = true;
                    }
                    let _e296 = phi_413_;
                    let _e298 = phi_414_;
                    phi_415_ = _e296;
                    phi_416_ = _e298;
                } else {
                    phi_415_ = bool();
                    phi_416_ = true;
                }
                let _e300 = phi_415_;
                let _e302 = phi_416_;
                phi_417_ = _e300;
                phi_418_ = _e302;
            } else {
                phi_417_ = bool();
                phi_418_ = true;
            }
            let _e304 = phi_417_;
            let _e306 = phi_418_;
            if _e306 {
                phi_422_ = false;
            } else {
                phi_422_ = _e304;
            }
            let _e308 = phi_422_;
            if _e308 {
                if (0f > 0f) {
                    let _e311 = samples.member[(0u + _e53.first_primitive)].normal;
                    let _e313 = p.member.map_size;
                    let _e383 = ((abs(((((_e59.row_x.x * _e311.x) + (_e59.row_x.y * _e311.y)) + (_e59.row_x.z * _e311.z)) / (((_e59.row_x.x * _e59.row_x.x) + (_e59.row_x.y * _e59.row_x.y)) + (_e59.row_x.z * _e59.row_x.z)))) + abs(((((_e59.row_y.x * _e311.x) + (_e59.row_y.y * _e311.y)) + (_e59.row_y.z * _e311.z)) / (((_e59.row_y.x * _e59.row_y.x) + (_e59.row_y.y * _e59.row_y.y)) + (_e59.row_y.z * _e59.row_y.z))))) / (abs(((((_e59.row_z.x * _e311.x) + (_e59.row_z.y * _e311.y)) + (_e59.row_z.z * _e311.z)) / (((_e59.row_z.x * _e59.row_z.x) + (_e59.row_z.y * _e59.row_z.y)) + (_e59.row_z.z * _e59.row_z.z)))) * f32(_e313)));
                    if (_e383 < 0.002f) {
                        phi_512_ = _e383;
                    } else {
                        phi_512_ = 0.002f;
                    }
                    let _e386 = phi_512_;
                    phi_515_ = (_e281 - (0f * _e386));
                } else {
                    phi_515_ = _e281;
                }
                let _e390 = phi_515_;
                let _e392 = p.member.map_size;
                let _e393 = f32(_e392);
                let _e396 = ((_e254 * _e393) - 0.5f);
                let _e397 = ((_e268 * _e393) - 0.5f);
                if (_e396 > -8388608f) {
                    let _e409 = f32(select(0i, select(select(i32(_e396), i32(-2147483648), (_e396 < bitcast<f32>(3472883712u))), 2147483647i, (_e396 > bitcast<f32>(1325400063u))), (_e396 == _e396)));
                    if (_e409 > _e396) {
                        phi_544_ = 1f;
                    } else {
                        phi_544_ = 0f;
                    }
                    let _e412 = phi_544_;
                    if (_e396 < 8388608f) {
                        phi_549_ = (_e409 - _e412);
                        phi_550_ = false;
                    } else {
                        phi_549_ = f32();
                        phi_550_ = true;
                    }
                    let _e415 = phi_549_;
                    let _e417 = phi_550_;
                    phi_551_ = _e415;
                    phi_552_ = _e417;
                } else {
                    phi_551_ = f32();
                    phi_552_ = true;
                }
                let _e419 = phi_551_;
                let _e421 = phi_552_;
                if _e421 {
                    phi_556_ = _e396;
                } else {
                    phi_556_ = _e419;
                }
                let _e423 = phi_556_;
                if (_e397 > -8388608f) {
                    let _e435 = f32(select(0i, select(select(i32(_e397), i32(-2147483648), (_e397 < bitcast<f32>(3472883712u))), 2147483647i, (_e397 > bitcast<f32>(1325400063u))), (_e397 == _e397)));
                    if (_e435 > _e397) {
                        phi_576_ = 1f;
                    } else {
                        phi_576_ = 0f;
                    }
                    let _e438 = phi_576_;
                    if (_e397 < 8388608f) {
                        phi_581_ = (_e435 - _e438);
                        phi_582_ = false;
                    } else {
                        phi_581_ = f32();
                        phi_582_ = true;
                    }
                    let _e441 = phi_581_;
                    let _e443 = phi_582_;
                    phi_583_ = _e441;
                    phi_584_ = _e443;
                } else {
                    phi_583_ = f32();
                    phi_584_ = true;
                }
                let _e445 = phi_583_;
                let _e447 = phi_584_;
                if _e447 {
                    phi_588_ = _e397;
                } else {
                    phi_588_ = _e445;
                }
                let _e449 = phi_588_;
                let _e450 = (_e396 - _e423);
                let _e451 = (_e397 - _e449);
                let _e460 = select(0i, select(select(i32(_e423), i32(-2147483648), (_e423 < bitcast<f32>(3472883712u))), 2147483647i, (_e423 > bitcast<f32>(1325400063u))), (_e423 == _e423));
                let _e469 = select(0i, select(select(i32(_e449), i32(-2147483648), (_e449 < bitcast<f32>(3472883712u))), 2147483647i, (_e449 > bitcast<f32>(1325400063u))), (_e449 == _e449));
                let _e472 = ((1f - _e450) * (1f - _e451));
                let _e474 = (_e450 * (1f - _e451));
                let _e476 = ((1f - _e450) * _e451);
                let _e477 = (_e450 * _e451);
                let _e479 = p.member.test;
                let _e480 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e479);
                let _e482 = p.member.map_size;
                local_1 = _e480;
                let _e484 = ((0u * _e482) * _e482);
                let _e486 = (bitcast<i32>(_e482) - 1i);
                if (_e460 > 0i) {
                    phi_636_ = _e460;
                } else {
                    phi_636_ = 0i;
                }
                let _e489 = phi_636_;
                if (_e469 > 0i) {
                    phi_641_ = _e469;
                } else {
                    phi_641_ = 0i;
                }
                let _e492 = phi_641_;
                if (_e489 < _e486) {
                    phi_646_ = _e489;
                } else {
                    phi_646_ = _e486;
                }
                let _e495 = phi_646_;
                if (_e492 < _e486) {
                    phi_651_ = _e492;
                } else {
                    phi_651_ = _e486;
                }
                let _e498 = phi_651_;
                let _e499 = bitcast<u32>(_e495);
                let _e501 = (_e460 + 1i);
                let _e502 = (_e469 + 1i);
                if (_e501 > 0i) {
                    phi_660_ = _e501;
                } else {
                    phi_660_ = 0i;
                }
                let _e505 = phi_660_;
                if (_e502 > 0i) {
                    phi_665_ = _e502;
                } else {
                    phi_665_ = 0i;
                }
                let _e508 = phi_665_;
                if (_e505 < _e486) {
                    phi_670_ = _e505;
                } else {
                    phi_670_ = _e486;
                }
                let _e511 = phi_670_;
                if (_e508 < _e486) {
                    phi_675_ = _e508;
                } else {
                    phi_675_ = _e486;
                }
                let _e514 = phi_675_;
                let _e515 = bitcast<u32>(_e511);
                let _e517 = (bitcast<u32>(_e498) * _e482);
                let _e518 = (bitcast<u32>(_e514) * _e482);
                let _e523 = ((_e517 + _e499) + _e484);
                let _e524 = ((_e517 + _e515) + _e484);
                let _e525 = ((_e518 + _e499) + _e484);
                let _e526 = ((_e518 + _e515) + _e484);
                if (_e523 < _e44) {
                } else {
                    return;
                }
                let _e530 = map.member[(0u + _e523)];
                if (_e524 < _e44) {
                } else {
                    return;
                }
                let _e542 = map.member[(0u + _e524)];
                if (_e525 < _e44) {
                } else {
                    return;
                }
                let _e558 = map.member[(0u + _e525)];
                if (_e526 < _e44) {
                } else {
                    return;
                }
                let _e574 = map.member[(0u + _e526)];
                let _e588 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_1), vec4<f32>(((((_e530.x * _e472) + (_e542.x * _e474)) + (_e558.x * _e476)) + (_e574.x * _e477)), ((((_e530.y * _e472) + (_e542.y * _e474)) + (_e558.y * _e476)) + (_e574.y * _e477)), ((((_e530.z * _e472) + (_e542.z * _e474)) + (_e558.z * _e476)) + (_e574.z * _e477)), ((((_e530.w * _e472) + (_e542.w * _e474)) + (_e558.w * _e476)) + (_e574.w * _e477))), _e390);
                phi_764_ = evaluate_Verdict(_e588, false);
                phi_765_ = evaluate_Verdict();
                phi_766_ = false;
            } else {
                phi_764_ = evaluate_Verdict();
                phi_765_ = evaluate_Verdict(1f, false);
                phi_766_ = true;
            }
            let _e592 = phi_764_;
            let _e594 = phi_765_;
            let _e596 = phi_766_;
            phi_767_ = _e594;
            phi_768_ = _e592;
            phi_769_ = _e596;
        }
        let _e598 = phi_767_;
        let _e600 = phi_768_;
        let _e602 = phi_769_;
        if _e602 {
            phi_773_ = _e598;
        } else {
            phi_773_ = _e600;
        }
        let _e604 = phi_773_;
        if (_e53.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e53.first_primitive)] = _e604.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_msm_hausdorff_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
