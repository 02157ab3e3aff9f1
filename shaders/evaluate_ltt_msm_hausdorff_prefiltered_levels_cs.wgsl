struct abi_LightParams {
    place: vec4<f32>,
    axis: vec3<f32>,
    cos_outer: f32,
    range_squared: f32,
    cos_inner: f32,
    number: u32,
    mask_words: u32,
}

struct type_9 {
    member: array<u32>,
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

struct type_20 {
    member: array<abi_Sample>,
}

struct type_24 {
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

struct type_39 {
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

struct type_43 {
    member: abi_ShadowParams,
}

struct lt_math_LightPoint {
    uv: vec2<f32>,
    depth: f32,
    is_inside: bool,
}

struct type_49 {
    member: array<lt_math_LightProjection>,
}

struct lt_math_LevelPoint {
    level: u32,
    point: lt_math_LightPoint,
}

struct hankel_HankelFactors {
    moments: vec4<f32>,
    d22_: f32,
    l32_d22_: f32,
    d33_d22_: f32,
}

struct type_57 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
var<private> local_6: u32;
@group(0) @binding(1) 
var<storage> samples: type_20;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(0) 
var<uniform> p: type_43;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_24;
@group(0) @binding(4) 
var<storage, read_write> list: type_57;
@group(0) @binding(5) 
var<storage> levels: type_49;
@group(0) @binding(2) 
var<storage> map: type_39;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_177_: lt_bvh_traverse_Tree;
    var phi_178_: bool;
    var phi_179_: lt_bvh_traverse_Tree;
    var phi_180_: bool;
    var phi_185_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_177_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_178_ = false;
        } else {
            phi_177_ = lt_bvh_traverse_Tree();
            phi_178_ = true;
        }
        let _e59 = phi_177_;
        let _e61 = phi_178_;
        phi_179_ = _e59;
        phi_180_ = _e61;
    } else {
        phi_179_ = lt_bvh_traverse_Tree();
        phi_180_ = true;
    }
    let _e63 = phi_179_;
    let _e65 = phi_180_;
    if _e65 {
        phi_185_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_185_ = _e63;
    }
    let _e70 = phi_185_;
    return lt_bvh_traverse_Tree(_e70.root, _e70.first_primitive);
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn lt_math_hausdorff_cubic_mass(param_4: vec4<f32>, param_5: f32, param_6: f32, param_7: f32, param_8: f32) -> f32 {
    return ((((param_4.z - (((param_6 + param_7) + param_8) * param_4.y)) + ((((param_6 * param_7) + (param_6 * param_8)) + (param_7 * param_8)) * param_4.x)) - ((param_6 * param_7) * param_8)) / (((param_5 - param_6) * (param_5 - param_7)) * (param_5 - param_8)));
}

fn lt_math_hausdorff_endpoint_upper_bound(param_9: ptr<function, hankel_HankelFactors>, param_10: f32) -> f32 {
    var phi_955_: f32;
    var phi_956_: f32;
    var phi_957_: f32;
    var phi_984_: f32;
    var phi_985_: f32;
    var phi_986_: f32;
    var phi_987_: f32;
    var phi_988_: bool;
    var phi_989_: f32;
    var phi_990_: bool;
    var phi_1018_: f32;
    var phi_1019_: f32;
    var phi_1020_: f32;
    var phi_1021_: f32;
    var phi_1022_: bool;
    var phi_1023_: f32;
    var phi_1024_: bool;
    var phi_1031_: f32;
    var phi_1032_: f32;
    var phi_1033_: f32;
    var phi_1034_: f32;

    let _e49 = (*param_9).moments;
    if (param_10 < 0.0001f) {
        phi_1034_ = 1f;
    } else {
        let _e58 = ((_e49.z - ((1f + param_10) * _e49.y)) + (param_10 * _e49.x));
        let _e67 = (((_e49.w - ((1f + param_10) * _e49.z)) + (param_10 * _e49.y)) / _e58);
        if (abs(_e58) <= 0.00000047683716f) {
            let _e81 = (1f - (((_e49.y - (_e49.x * (param_10 + 1f))) + (param_10 * 1f)) / ((0f - param_10) * (0f - 1f))));
            if ((bitcast<u32>(_e81) & 2147483647u) > 2139095040u) {
                phi_957_ = _e81;
            } else {
                if (_e81 < 0f) {
                    phi_956_ = 0f;
                } else {
                    if (_e81 > 1f) {
                        phi_955_ = 1f;
                    } else {
                        phi_955_ = _e81;
                    }
                    let _e88 = phi_955_;
                    phi_956_ = _e88;
                }
                let _e90 = phi_956_;
                phi_957_ = _e90;
            }
            let _e92 = phi_957_;
            phi_1033_ = _e92;
        } else {
            if (_e67 > 0f) {
                if (_e67 < param_10) {
                    let _e95 = lt_math_hausdorff_cubic_mass(_e49, 0f, _e67, param_10, 1f);
                    let _e97 = lt_math_hausdorff_cubic_mass(_e49, _e67, 0f, param_10, 1f);
                    let _e98 = ((1f - _e95) - _e97);
                    if ((bitcast<u32>(_e98) & 2147483647u) > 2139095040u) {
                        phi_986_ = _e98;
                    } else {
                        if (_e98 < 0f) {
                            phi_985_ = 0f;
                        } else {
                            if (_e98 > 1f) {
                                phi_984_ = 1f;
                            } else {
                                phi_984_ = _e98;
                            }
                            let _e105 = phi_984_;
                            phi_985_ = _e105;
                        }
                        let _e107 = phi_985_;
                        phi_986_ = _e107;
                    }
                    let _e109 = phi_986_;
                    phi_987_ = _e109;
                    phi_988_ = false;
                } else {
                    phi_987_ = f32();
                    phi_988_ = true;
                }
                let _e111 = phi_987_;
                let _e113 = phi_988_;
                phi_989_ = _e111;
                phi_990_ = _e113;
            } else {
                phi_989_ = f32();
                phi_990_ = true;
            }
            let _e115 = phi_989_;
            let _e117 = phi_990_;
            if _e117 {
                if (_e67 > param_10) {
                    if (_e67 < 1f) {
                        let _e120 = lt_math_hausdorff_cubic_mass(_e49, 0f, _e67, param_10, 1f);
                        let _e121 = (1f - _e120);
                        if ((bitcast<u32>(_e121) & 2147483647u) > 2139095040u) {
                            phi_1020_ = _e121;
                        } else {
                            if (_e121 < 0f) {
                                phi_1019_ = 0f;
                            } else {
                                if (_e121 > 1f) {
                                    phi_1018_ = 1f;
                                } else {
                                    phi_1018_ = _e121;
                                }
                                let _e128 = phi_1018_;
                                phi_1019_ = _e128;
                            }
                            let _e130 = phi_1019_;
                            phi_1020_ = _e130;
                        }
                        let _e132 = phi_1020_;
                        phi_1021_ = _e132;
                        phi_1022_ = false;
                    } else {
                        phi_1021_ = f32();
                        phi_1022_ = true;
                    }
                    let _e134 = phi_1021_;
                    let _e136 = phi_1022_;
                    phi_1023_ = _e134;
                    phi_1024_ = _e136;
                } else {
                    phi_1023_ = f32();
                    phi_1024_ = true;
                }
                let _e138 = phi_1023_;
                let _e140 = phi_1024_;
                if _e140 {
                    phi_1031_ = bitcast<f32>((bitcast<u32>(_e67) | 2143289344u));
                } else {
                    phi_1031_ = _e138;
                }
                let _e145 = phi_1031_;
                phi_1032_ = _e145;
            } else {
                phi_1032_ = _e115;
            }
            let _e147 = phi_1032_;
            phi_1033_ = _e147;
        }
        let _e149 = phi_1033_;
        phi_1034_ = _e149;
    }
    let _e151 = phi_1034_;
    return _e151;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_11: ptr<function, f32>, param_12: vec4<f32>, param_13: f32) -> f32 {
    var local_1: hankel_HankelFactors;
    var phi_242_: f32;
    var phi_243_: f32;
    var phi_244_: f32;
    var phi_256_: bool;
    var phi_271_: bool;
    var phi_296_: f32;
    var phi_297_: f32;
    var phi_298_: f32;
    var phi_299_: f32;
    var phi_300_: bool;
    var phi_301_: f32;
    var phi_302_: bool;
    var phi_358_: vec2<f32>;
    var phi_396_: f32;
    var phi_397_: f32;
    var phi_398_: f32;
    var phi_431_: f32;
    var phi_432_: f32;
    var phi_433_: f32;
    var phi_437_: f32;
    var phi_438_: f32;
    var phi_439_: f32;
    var phi_440_: f32;
    var phi_493_: vec2<f32>;
    var phi_515_: bool;
    var phi_540_: f32;
    var phi_541_: f32;
    var phi_542_: f32;
    var phi_543_: f32;
    var phi_544_: bool;
    var phi_545_: f32;
    var phi_546_: bool;
    var phi_602_: vec2<f32>;
    var phi_640_: f32;
    var phi_641_: f32;
    var phi_642_: f32;
    var phi_675_: f32;
    var phi_676_: f32;
    var phi_677_: f32;
    var phi_681_: f32;
    var phi_682_: f32;
    var phi_683_: f32;
    var phi_684_: f32;
    var phi_685_: f32;
    var phi_686_: bool;
    var phi_687_: f32;
    var phi_688_: bool;
    var phi_710_: bool;
    var phi_735_: f32;
    var phi_736_: f32;
    var phi_737_: f32;
    var phi_738_: f32;
    var phi_739_: bool;
    var phi_740_: f32;
    var phi_741_: bool;
    var phi_797_: vec2<f32>;
    var phi_835_: f32;
    var phi_836_: f32;
    var phi_837_: f32;
    var phi_870_: f32;
    var phi_871_: f32;
    var phi_872_: f32;
    var phi_876_: f32;
    var phi_877_: f32;
    var phi_878_: f32;
    var phi_879_: f32;
    var phi_890_: bool;
    var phi_894_: f32;
    var phi_895_: f32;
    var phi_896_: f32;
    var phi_897_: f32;

    let _e50 = (*param_11);
    let _e51 = (1f - _e50);
    let _e60 = (0.5f * _e50);
    let _e61 = ((param_12.x * _e51) + _e60);
    let _e62 = ((param_12.y * _e51) + _e60);
    let _e63 = ((param_12.z * _e51) + _e60);
    let _e64 = ((param_12.w * _e51) + _e60);
    let _e67 = (_e62 - (_e61 * _e61));
    let _e69 = (_e63 - (_e61 * _e62));
    let _e75 = hankel_HankelFactors(vec4<f32>(_e61, _e62, _e63, _e64), _e67, _e69, (((_e64 - (_e62 * _e62)) * _e67) - (_e69 * _e69)));
    local_1 = hankel_HankelFactors(_e75.moments, _e75.d22_, _e75.l32_d22_, _e75.d33_d22_);
    if ((bitcast<u32>(param_13) & 2147483647u) > 2139095040u) {
        phi_244_ = param_13;
    } else {
        if (param_13 < 0f) {
            phi_243_ = 0f;
        } else {
            if (param_13 > 1f) {
                phi_242_ = 1f;
            } else {
                phi_242_ = param_13;
            }
            let _e87 = phi_242_;
            phi_243_ = _e87;
        }
        let _e89 = phi_243_;
        phi_244_ = _e89;
    }
    let _e91 = phi_244_;
    let _e94 = local_1.moments[0u];
    let _e97 = local_1.moments[3u];
    if (_e94 == _e97) {
        let _e101 = local_1.moments[0u];
        phi_256_ = (_e101 > 0.5f);
    } else {
        phi_256_ = false;
    }
    let _e104 = phi_256_;
    if _e104 {
        let _e107 = local_1.moments[0u];
        let _e110 = local_1.moments[3u];
        if (_e107 == _e110) {
            let _e114 = local_1.moments[0u];
            phi_271_ = (_e114 > 0.5f);
        } else {
            phi_271_ = false;
        }
        let _e117 = phi_271_;
        if _e117 {
            if (_e91 > 0f) {
                let _e120 = local_1.moments;
                if ((bitcast<u32>(_e120.x) & 2147483647u) > 2139095040u) {
                    phi_298_ = _e120.x;
                } else {
                    if (_e120.x < 0f) {
                        phi_297_ = 0f;
                    } else {
                        if (_e120.x > 1f) {
                            phi_296_ = 1f;
                        } else {
                            phi_296_ = _e120.x;
                        }
                        let _e128 = phi_296_;
                        phi_297_ = _e128;
                    }
                    let _e130 = phi_297_;
                    phi_298_ = _e130;
                }
                let _e132 = phi_298_;
                phi_299_ = _e132;
                phi_300_ = false;
            } else {
                phi_299_ = f32();
                phi_300_ = true;
            }
            let _e134 = phi_299_;
            let _e136 = phi_300_;
            phi_301_ = _e134;
            phi_302_ = _e136;
        } else {
            phi_301_ = f32();
            phi_302_ = true;
        }
        let _e138 = phi_301_;
        let _e140 = phi_302_;
        if _e140 {
            let _e143 = local_1.moments[0u];
            let _e146 = local_1.moments[1u];
            let _e154 = local_1.l32_d22_;
            let _e156 = local_1.d22_;
            let _e157 = (_e154 / _e156);
            let _e158 = (_e91 - _e143);
            let _e164 = local_1.d22_;
            let _e167 = local_1.d33_d22_;
            let _e168 = (((((_e91 * _e91) - _e146) - (_e157 * _e158)) * _e164) / _e167);
            let _e170 = local_1.d22_;
            let _e173 = ((_e158 / _e170) - (_e157 * _e168));
            let _e179 = ((0.5f * _e173) / _e168);
            let _e182 = ((_e179 * _e179) - (((1f - (_e173 * _e143)) - (_e168 * _e146)) / _e168));
            if (_e182 >= 0f) {
                let _e184 = sqrt(_e182);
                phi_358_ = vec2<f32>((-(_e179) - _e184), (-(_e179) + _e184));
            } else {
                phi_358_ = vec2(bitcast<f32>((bitcast<u32>(_e182) | 2143289344u)));
            }
            let _e195 = phi_358_;
            if (_e91 <= _e195.x) {
                phi_439_ = 1f;
            } else {
                if (_e91 > _e195.y) {
                    let _e201 = local_1.moments;
                    let _e212 = (((_e201.y - (_e201.x * (_e195.x + _e195.y))) + (_e195.x * _e195.y)) / ((_e91 - _e195.x) * (_e91 - _e195.y)));
                    if ((bitcast<u32>(_e212) & 2147483647u) > 2139095040u) {
                        phi_398_ = _e212;
                    } else {
                        if (_e212 < 0f) {
                            phi_397_ = 0f;
                        } else {
                            if (_e212 > 1f) {
                                phi_396_ = 1f;
                            } else {
                                phi_396_ = _e212;
                            }
                            let _e219 = phi_396_;
                            phi_397_ = _e219;
                        }
                        let _e221 = phi_397_;
                        phi_398_ = _e221;
                    }
                    let _e223 = phi_398_;
                    phi_438_ = _e223;
                } else {
                    if (_e91 > _e195.x) {
                        let _e226 = local_1.moments;
                        let _e238 = (1f - (((_e226.y - (_e226.x * (_e91 + _e195.y))) + (_e91 * _e195.y)) / ((_e195.x - _e91) * (_e195.x - _e195.y))));
                        if ((bitcast<u32>(_e238) & 2147483647u) > 2139095040u) {
                            phi_433_ = _e238;
                        } else {
                            if (_e238 < 0f) {
                                phi_432_ = 0f;
                            } else {
                                if (_e238 > 1f) {
                                    phi_431_ = 1f;
                                } else {
                                    phi_431_ = _e238;
                                }
                                let _e245 = phi_431_;
                                phi_432_ = _e245;
                            }
                            let _e247 = phi_432_;
                            phi_433_ = _e247;
                        }
                        let _e249 = phi_433_;
                        phi_437_ = _e249;
                    } else {
                        phi_437_ = bitcast<f32>((bitcast<u32>(_e195.x) | 2143289344u));
                    }
                    let _e254 = phi_437_;
                    phi_438_ = _e254;
                }
                let _e256 = phi_438_;
                phi_439_ = _e256;
            }
            let _e258 = phi_439_;
            phi_440_ = _e258;
        } else {
            phi_440_ = _e138;
        }
        let _e260 = phi_440_;
        phi_897_ = _e260;
    } else {
        let _e263 = local_1.moments[0u];
        let _e266 = local_1.moments[1u];
        let _e274 = local_1.l32_d22_;
        let _e276 = local_1.d22_;
        let _e277 = (_e274 / _e276);
        let _e278 = (_e91 - _e263);
        let _e284 = local_1.d22_;
        let _e287 = local_1.d33_d22_;
        let _e288 = (((((_e91 * _e91) - _e266) - (_e277 * _e278)) * _e284) / _e287);
        let _e290 = local_1.d22_;
        let _e293 = ((_e278 / _e290) - (_e277 * _e288));
        let _e299 = ((0.5f * _e293) / _e288);
        let _e302 = ((_e299 * _e299) - (((1f - (_e293 * _e263)) - (_e288 * _e266)) / _e288));
        if (_e302 >= 0f) {
            let _e304 = sqrt(_e302);
            phi_493_ = vec2<f32>((-(_e299) - _e304), (-(_e299) + _e304));
        } else {
            phi_493_ = vec2(bitcast<f32>((bitcast<u32>(_e302) | 2143289344u)));
        }
        let _e315 = phi_493_;
        if (_e315.x >= 0f) {
            if (_e315.y <= 1f) {
                let _e322 = local_1.moments[0u];
                let _e325 = local_1.moments[3u];
                if (_e322 == _e325) {
                    let _e329 = local_1.moments[0u];
                    phi_515_ = (_e329 > 0.5f);
                } else {
                    phi_515_ = false;
                }
                let _e332 = phi_515_;
                if _e332 {
                    if (_e91 > 0f) {
                        let _e335 = local_1.moments;
                        if ((bitcast<u32>(_e335.x) & 2147483647u) > 2139095040u) {
                            phi_542_ = _e335.x;
                        } else {
                            if (_e335.x < 0f) {
                                phi_541_ = 0f;
                            } else {
                                if (_e335.x > 1f) {
                                    phi_540_ = 1f;
                                } else {
                                    phi_540_ = _e335.x;
                                }
                                let _e343 = phi_540_;
                                phi_541_ = _e343;
                            }
                            let _e345 = phi_541_;
                            phi_542_ = _e345;
                        }
                        let _e347 = phi_542_;
                        phi_543_ = _e347;
                        phi_544_ = false;
                    } else {
                        phi_543_ = f32();
                        phi_544_ = true;
                    }
                    let _e349 = phi_543_;
                    let _e351 = phi_544_;
                    phi_545_ = _e349;
                    phi_546_ = _e351;
                } else {
                    phi_545_ = f32();
                    phi_546_ = true;
                }
                let _e353 = phi_545_;
                let _e355 = phi_546_;
                if _e355 {
                    let _e358 = local_1.moments[0u];
                    let _e361 = local_1.moments[1u];
                    let _e369 = local_1.l32_d22_;
                    let _e371 = local_1.d22_;
                    let _e372 = (_e369 / _e371);
                    let _e373 = (_e91 - _e358);
                    let _e379 = local_1.d22_;
                    let _e382 = local_1.d33_d22_;
                    let _e383 = (((((_e91 * _e91) - _e361) - (_e372 * _e373)) * _e379) / _e382);
                    let _e385 = local_1.d22_;
                    let _e388 = ((_e373 / _e385) - (_e372 * _e383));
                    let _e394 = ((0.5f * _e388) / _e383);
                    let _e397 = ((_e394 * _e394) - (((1f - (_e388 * _e358)) - (_e383 * _e361)) / _e383));
                    if (_e397 >= 0f) {
                        let _e399 = sqrt(_e397);
                        phi_602_ = vec2<f32>((-(_e394) - _e399), (-(_e394) + _e399));
                    } else {
                        phi_602_ = vec2(bitcast<f32>((bitcast<u32>(_e397) | 2143289344u)));
                    }
                    let _e410 = phi_602_;
                    if (_e91 <= _e410.x) {
                        phi_683_ = 1f;
                    } else {
                        if (_e91 > _e410.y) {
                            let _e416 = local_1.moments;
                            let _e427 = (((_e416.y - (_e416.x * (_e410.x + _e410.y))) + (_e410.x * _e410.y)) / ((_e91 - _e410.x) * (_e91 - _e410.y)));
                            if ((bitcast<u32>(_e427) & 2147483647u) > 2139095040u) {
                                phi_642_ = _e427;
                            } else {
                                if (_e427 < 0f) {
                                    phi_641_ = 0f;
                                } else {
                                    if (_e427 > 1f) {
                                        phi_640_ = 1f;
                                    } else {
                                        phi_640_ = _e427;
                                    }
                                    let _e434 = phi_640_;
                                    phi_641_ = _e434;
                                }
                                let _e436 = phi_641_;
                                phi_642_ = _e436;
                            }
                            let _e438 = phi_642_;
                            phi_682_ = _e438;
                        } else {
                            if (_e91 > _e410.x) {
                                let _e441 = local_1.moments;
                                let _e453 = (1f - (((_e441.y - (_e441.x * (_e91 + _e410.y))) + (_e91 * _e410.y)) / ((_e410.x - _e91) * (_e410.x - _e410.y))));
                                if ((bitcast<u32>(_e453) & 2147483647u) > 2139095040u) {
                                    phi_677_ = _e453;
                                } else {
                                    if (_e453 < 0f) {
                                        phi_676_ = 0f;
                                    } else {
                                        if (_e453 > 1f) {
                                            phi_675_ = 1f;
                                        } else {
                                            phi_675_ = _e453;
                                        }
                                        let _e460 = phi_675_;
                                        phi_676_ = _e460;
                                    }
                                    let _e462 = phi_676_;
                                    phi_677_ = _e462;
                                }
                                let _e464 = phi_677_;
                                phi_681_ = _e464;
                            } else {
                                phi_681_ = bitcast<f32>((bitcast<u32>(_e410.x) | 2143289344u));
                            }
                            let _e469 = phi_681_;
                            phi_682_ = _e469;
                        }
                        let _e471 = phi_682_;
                        phi_683_ = _e471;
                    }
                    let _e473 = phi_683_;
                    phi_684_ = _e473;
                } else {
                    phi_684_ = _e353;
                }
                let _e475 = phi_684_;
                phi_685_ = _e475;
                phi_686_ = false;
            } else {
                phi_685_ = f32();
                phi_686_ = true;
            }
            let _e477 = phi_685_;
            let _e479 = phi_686_;
            phi_687_ = _e477;
            phi_688_ = _e479;
        } else {
            phi_687_ = f32();
            phi_688_ = true;
        }
        let _e481 = phi_687_;
        let _e483 = phi_688_;
        if _e483 {
            if ((bitcast<u32>(_e315.x) & 2147483647u) > 2139095040u) {
                phi_895_ = _e315.x;
            } else {
                let _e487 = lt_math_hausdorff_endpoint_upper_bound((&local_1), _e91);
                let _e490 = local_1.moments[0u];
                let _e493 = local_1.moments[3u];
                if (_e490 == _e493) {
                    let _e497 = local_1.moments[0u];
                    phi_710_ = (_e497 > 0.5f);
                } else {
                    phi_710_ = false;
                }
                let _e500 = phi_710_;
                if _e500 {
                    if (_e91 > 0f) {
                        let _e503 = local_1.moments;
                        if ((bitcast<u32>(_e503.x) & 2147483647u) > 2139095040u) {
                            phi_737_ = _e503.x;
                        } else {
                            if (_e503.x < 0f) {
                                phi_736_ = 0f;
                            } else {
                                if (_e503.x > 1f) {
                                    phi_735_ = 1f;
                                } else {
                                    phi_735_ = _e503.x;
                                }
                                let _e511 = phi_735_;
                                phi_736_ = _e511;
                            }
                            let _e513 = phi_736_;
                            phi_737_ = _e513;
                        }
                        let _e515 = phi_737_;
                        phi_738_ = _e515;
                        phi_739_ = false;
                    } else {
                        phi_738_ = f32();
                        phi_739_ = true;
                    }
                    let _e517 = phi_738_;
                    let _e519 = phi_739_;
                    phi_740_ = _e517;
                    phi_741_ = _e519;
                } else {
                    phi_740_ = f32();
                    phi_741_ = true;
                }
                let _e521 = phi_740_;
                let _e523 = phi_741_;
                if _e523 {
                    let _e526 = local_1.moments[0u];
                    let _e529 = local_1.moments[1u];
                    let _e537 = local_1.l32_d22_;
                    let _e539 = local_1.d22_;
                    let _e540 = (_e537 / _e539);
                    let _e541 = (_e91 - _e526);
                    let _e547 = local_1.d22_;
                    let _e550 = local_1.d33_d22_;
                    let _e551 = (((((_e91 * _e91) - _e529) - (_e540 * _e541)) * _e547) / _e550);
                    let _e553 = local_1.d22_;
                    let _e556 = ((_e541 / _e553) - (_e540 * _e551));
                    let _e562 = ((0.5f * _e556) / _e551);
                    let _e565 = ((_e562 * _e562) - (((1f - (_e556 * _e526)) - (_e551 * _e529)) / _e551));
                    if (_e565 >= 0f) {
                        let _e567 = sqrt(_e565);
                        phi_797_ = vec2<f32>((-(_e562) - _e567), (-(_e562) + _e567));
                    } else {
                        phi_797_ = vec2(bitcast<f32>((bitcast<u32>(_e565) | 2143289344u)));
                    }
                    let _e578 = phi_797_;
                    if (_e91 <= _e578.x) {
                        phi_878_ = 1f;
                    } else {
                        if (_e91 > _e578.y) {
                            let _e584 = local_1.moments;
                            let _e595 = (((_e584.y - (_e584.x * (_e578.x + _e578.y))) + (_e578.x * _e578.y)) / ((_e91 - _e578.x) * (_e91 - _e578.y)));
                            if ((bitcast<u32>(_e595) & 2147483647u) > 2139095040u) {
                                phi_837_ = _e595;
                            } else {
                                if (_e595 < 0f) {
                                    phi_836_ = 0f;
                                } else {
                                    if (_e595 > 1f) {
                                        phi_835_ = 1f;
                                    } else {
                                        phi_835_ = _e595;
                                    }
                                    let _e602 = phi_835_;
                                    phi_836_ = _e602;
                                }
                                let _e604 = phi_836_;
                                phi_837_ = _e604;
                            }
                            let _e606 = phi_837_;
                            phi_877_ = _e606;
                        } else {
                            if (_e91 > _e578.x) {
                                let _e609 = local_1.moments;
                                let _e621 = (1f - (((_e609.y - (_e609.x * (_e91 + _e578.y))) + (_e91 * _e578.y)) / ((_e578.x - _e91) * (_e578.x - _e578.y))));
                                if ((bitcast<u32>(_e621) & 2147483647u) > 2139095040u) {
                                    phi_872_ = _e621;
                                } else {
                                    if (_e621 < 0f) {
                                        phi_871_ = 0f;
                                    } else {
                                        if (_e621 > 1f) {
                                            phi_870_ = 1f;
                                        } else {
                                            phi_870_ = _e621;
                                        }
                                        let _e628 = phi_870_;
                                        phi_871_ = _e628;
                                    }
                                    let _e630 = phi_871_;
                                    phi_872_ = _e630;
                                }
                                let _e632 = phi_872_;
                                phi_876_ = _e632;
                            } else {
                                phi_876_ = bitcast<f32>((bitcast<u32>(_e578.x) | 2143289344u));
                            }
                            let _e637 = phi_876_;
                            phi_877_ = _e637;
                        }
                        let _e639 = phi_877_;
                        phi_878_ = _e639;
                    }
                    let _e641 = phi_878_;
                    phi_879_ = _e641;
                } else {
                    phi_879_ = _e521;
                }
                let _e643 = phi_879_;
                if ((bitcast<u32>(_e643) & 2147483647u) > 2139095040u) {
                    phi_890_ = true;
                } else {
                    let _e647 = (_e643 < _e487);
                    if _e647 {
                    }
                    phi_890_ = _e647;
                }
                let _e649 = phi_890_;
                if _e649 {
                    phi_894_ = _e643;
                } else {
                    phi_894_ = _e487;
                }
                let _e651 = phi_894_;
                phi_895_ = _e651;
            }
            let _e653 = phi_895_;
            phi_896_ = _e653;
        } else {
            phi_896_ = _e481;
        }
        let _e655 = phi_896_;
        phi_897_ = _e655;
    }
    let _e657 = phi_897_;
    return _e657;
}

fn function_() {
    var local_2: f32;
    var phi_1118_: bool;
    var phi_1119_: bool;
    var phi_1120_: bool;
    var phi_1121_: bool;
    var phi_1125_: bool;
    var phi_1195_: bool;
    var phi_1196_: bool;
    var phi_1207_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1208_: bool;
    var phi_1209_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1210_: bool;
    var phi_1217_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1221_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1241_: lt_math_LightPoint;
    var phi_1244_: u32;
    var phi_1246_: lt_math_LevelPoint;
    var phi_1332_: bool;
    var phi_1341_: bool;
    var phi_1350_: bool;
    var phi_1351_: bool;
    var phi_1352_: bool;
    var phi_1353_: bool;
    var phi_1354_: bool;
    var phi_1355_: bool;
    var phi_1356_: bool;
    var phi_1360_: bool;
    var phi_1387_: bool;
    var phi_1388_: bool;
    var phi_1389_: bool;
    var phi_1390_: bool;
    var phi_1391_: bool;
    var phi_1392_: bool;
    var phi_1393_: bool;
    var phi_1394_: bool;
    var phi_1398_: bool;
    var phi_1407_: lt_math_LightPoint;
    var phi_1408_: u32;
    var phi_1409_: lt_math_LevelPoint;
    var phi_1410_: bool;
    var phi_1242_: lt_math_LightPoint;
    var phi_1245_: u32;
    var phi_1247_: lt_math_LevelPoint;
    var phi_1411_: bool;
    var local_3: lt_math_LevelPoint;
    var local_4: lt_math_LevelPoint;
    var phi_1451_: bool;
    var phi_1452_: bool;
    var phi_1453_: bool;
    var phi_1454_: bool;
    var phi_1458_: bool;
    var phi_1540_: f32;
    var phi_1658_: f32;
    var phi_1659_: f32;
    var phi_1662_: f32;
    var phi_1691_: f32;
    var phi_1696_: f32;
    var phi_1697_: bool;
    var phi_1698_: f32;
    var phi_1699_: bool;
    var phi_1703_: f32;
    var phi_1723_: f32;
    var phi_1728_: f32;
    var phi_1729_: bool;
    var phi_1730_: f32;
    var phi_1731_: bool;
    var phi_1735_: f32;
    var local_5: lt_math_LevelPoint;
    var phi_1784_: i32;
    var phi_1789_: i32;
    var phi_1794_: i32;
    var phi_1799_: i32;
    var phi_1808_: i32;
    var phi_1813_: i32;
    var phi_1818_: i32;
    var phi_1823_: i32;
    var phi_1918_: bool;
    var phi_1926_: bool;
    var phi_1938_: bool;
    var phi_1939_: bool;
    var phi_1943_: f32;
    var phi_1949_: f32;
    var phi_1951_: evaluate_Verdict;
    var phi_1956_: evaluate_Verdict;
    var phi_1957_: evaluate_Verdict;
    var phi_1961_: bool;
    var phi_1962_: u32;
    var phi_1973_: u32;

    let _e47 = id_1;
    let _e48 = local_6;
    let _e53 = arrayLength((&map.member));
    let _e58 = arrayLength((&levels.member));
    let _e61 = p.member.size[0u];
    let _e63 = p.member.size[1u];
    let _e64 = lt_shaders_entry_pixel_index(_e47, _e61, _e63);
    if (bitcast<i32>(_e64.root) != 0i) {
        let _e71 = p.member.level_count;
        let _e75 = samples.member[_e64.first_primitive].normal[0u];
        let _e77 = global[0u];
        if (_e75 == _e77) {
            let _e80 = samples.member[_e64.first_primitive].normal[1u];
            let _e82 = global[1u];
            if (_e80 == _e82) {
                let _e85 = samples.member[_e64.first_primitive].normal[2u];
                let _e87 = global[2u];
                phi_1118_ = (_e85 == _e87);
                phi_1119_ = false;
            } else {
                phi_1118_ = bool();
                phi_1119_ = true;
            }
            let _e90 = phi_1118_;
            let _e92 = phi_1119_;
            phi_1120_ = _e90;
            phi_1121_ = _e92;
        } else {
            phi_1120_ = bool();
            phi_1121_ = true;
        }
        let _e94 = phi_1120_;
        let _e96 = phi_1121_;
        if _e96 {
            phi_1125_ = false;
        } else {
            phi_1125_ = _e94;
        }
        let _e98 = phi_1125_;
        if !(_e98) {
            let _e101 = samples.member[_e64.first_primitive].position;
            let _e103 = p.member.light.place;
            let _e109 = p.member.light.place[3u];
            let _e116 = (_e103.x - (_e101.x * _e109));
            let _e117 = (_e103.y - (_e101.y * _e109));
            let _e118 = (_e103.z - (_e101.z * _e109));
            let _e120 = samples.member[_e64.first_primitive].normal;
            if ((((_e120.x * _e116) + (_e120.y * _e117)) + (_e120.z * _e118)) > 0f) {
                let _e134 = (((_e116 * _e116) + (_e117 * _e117)) + (_e118 * _e118));
                let _e136 = p.member.light.axis;
                let _e148 = p.member.light.place[3u];
                if (_e148 == 0f) {
                    phi_1196_ = true;
                } else {
                    let _e151 = p.member.light.range_squared;
                    if (_e134 <= _e151) {
                        let _e154 = p.member.light.cos_outer;
                        phi_1195_ = (-((((_e116 * _e136.x) + (_e117 * _e136.y)) + (_e118 * _e136.z))) >= (_e154 * sqrt(_e134)));
                    } else {
                        phi_1195_ = false;
                    }
                    let _e159 = phi_1195_;
                    phi_1196_ = _e159;
                }
                let _e161 = phi_1196_;
                if _e161 {
                    let _e163 = samples.member[_e64.first_primitive].flags;
                    let _e171 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e177 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e171.unnamed.visibility, false), _e171.unnamed_1);
                    phi_1207_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e177.unnamed, ((_e163 & 1u) == 0u));
                    phi_1208_ = false;
                } else {
                    phi_1207_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_1208_ = true;
                }
                let _e182 = phi_1207_;
                let _e184 = phi_1208_;
                phi_1209_ = _e182;
                phi_1210_ = _e184;
            } else {
                phi_1209_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_1210_ = true;
            }
            let _e186 = phi_1209_;
            let _e188 = phi_1210_;
            if _e188 {
                let _e194 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e200 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e194.unnamed.visibility, false), _e194.unnamed_1);
                phi_1217_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e200.unnamed, true);
            } else {
                phi_1217_ = _e186;
            }
            let _e205 = phi_1217_;
            phi_1221_ = _e205;
        } else {
            let _e211 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e217 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e211.unnamed.visibility, false), _e211.unnamed_1);
            phi_1221_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e217.unnamed, true);
        }
        let _e222 = phi_1221_;
        if _e222.unnamed_1 {
            phi_1957_ = evaluate_Verdict(_e222.unnamed.visibility, _e222.unnamed.is_doubted);
        } else {
            let _e230 = samples.member[_e64.first_primitive].position;
            let _e232 = p.member.map_size;
            let _e234 = (0.5f / f32(_e232));
            let _e241 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e248 = lt_math_LightPoint(vec2<f32>(_e241.uv.x, 0f), _e241.depth, _e241.is_inside);
            let _e252 = lt_math_LightPoint(_e248.uv, 0f, _e248.is_inside);
            phi_1241_ = lt_math_LightPoint();
            phi_1244_ = 0u;
            phi_1246_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e252.uv, _e252.depth, false));
            loop {
                let _e259 = phi_1241_;
                let _e261 = phi_1244_;
                let _e263 = phi_1246_;
                local_3 = _e263;
                local_4 = _e263;
                local_5 = _e263;
                if (_e261 < _e71) {
                    if _e263.point.is_inside {
                        phi_1407_ = lt_math_LightPoint();
                        phi_1408_ = u32();
                        phi_1409_ = lt_math_LevelPoint();
                        phi_1410_ = false;
                    } else {
                        if (_e261 < _e58) {
                        } else {
                            return;
                        }
                        let _e274 = levels.member[(0u + _e261)].row_w;
                        let _e285 = ((((_e274.x * _e230.x) + (_e274.y * _e230.y)) + (_e274.z * _e230.z)) + (_e274.w * 1f));
                        let _e287 = levels.member[(0u + _e261)].row_x;
                        let _e299 = (((((_e287.x * _e230.x) + (_e287.y * _e230.y)) + (_e287.z * _e230.z)) + (_e287.w * 1f)) / _e285);
                        let _e301 = levels.member[(0u + _e261)].row_y;
                        let _e313 = (((((_e301.x * _e230.x) + (_e301.y * _e230.y)) + (_e301.z * _e230.z)) + (_e301.w * 1f)) / _e285);
                        let _e315 = levels.member[(0u + _e261)].row_z;
                        let _e326 = ((((_e315.x * _e230.x) + (_e315.y * _e230.y)) + (_e315.z * _e230.z)) + (_e315.w * 1f));
                        if (_e285 > 0f) {
                            if (_e299 >= 0f) {
                                phi_1332_ = (_e299 <= 1f);
                            } else {
                                phi_1332_ = false;
                            }
                            let _e331 = phi_1332_;
                            if _e331 {
                                if (_e313 >= 0f) {
                                    phi_1341_ = (_e313 <= 1f);
                                } else {
                                    phi_1341_ = false;
                                }
                                let _e335 = phi_1341_;
                                if _e335 {
                                    if (_e326 >= 0f) {
                                        phi_1350_ = (_e326 <= 1f);
                                    } else {
                                        phi_1350_ = false;
                                    }
                                    let _e339 = phi_1350_;
                                    phi_1351_ = _e339;
                                    phi_1352_ = false;
                                } else {
                                    phi_1351_ = bool();
                                    phi_1352_ = true;
                                }
                                let _e341 = phi_1351_;
                                let _e343 = phi_1352_;
                                phi_1353_ = _e341;
                                phi_1354_ = _e343;
                            } else {
                                phi_1353_ = bool();
                                phi_1354_ = true;
                            }
                            let _e345 = phi_1353_;
                            let _e347 = phi_1354_;
                            phi_1355_ = _e345;
                            phi_1356_ = _e347;
                        } else {
                            phi_1355_ = bool();
                            phi_1356_ = true;
                        }
                        let _e349 = phi_1355_;
                        let _e351 = phi_1356_;
                        if _e351 {
                            phi_1360_ = false;
                        } else {
                            phi_1360_ = _e349;
                        }
                        let _e353 = phi_1360_;
                        if _e353 {
                            if (_e299 >= _e234) {
                                if (_e299 <= (1f - _e234)) {
                                    if (_e313 >= _e234) {
                                        phi_1387_ = (_e313 <= (1f - _e234));
                                        phi_1388_ = false;
                                    } else {
                                        phi_1387_ = bool();
                                        phi_1388_ = true;
                                    }
                                    let _e361 = phi_1387_;
                                    let _e363 = phi_1388_;
                                    phi_1389_ = _e361;
                                    phi_1390_ = _e363;
                                } else {
                                    phi_1389_ = bool();
                                    phi_1390_ = true;
                                }
                                let _e365 = phi_1389_;
                                let _e367 = phi_1390_;
                                phi_1391_ = _e365;
                                phi_1392_ = _e367;
                            } else {
                                phi_1391_ = bool();
                                phi_1392_ = true;
                            }
                            let _e369 = phi_1391_;
                            let _e371 = phi_1392_;
                            phi_1393_ = _e369;
                            phi_1394_ = _e371;
                        } else {
                            phi_1393_ = bool();
                            phi_1394_ = true;
                        }
                        let _e373 = phi_1393_;
                        let _e375 = phi_1394_;
                        if _e375 {
                            phi_1398_ = false;
                        } else {
                            phi_1398_ = _e373;
                        }
                        let _e377 = phi_1398_;
                        let _e384 = lt_math_LightPoint(vec2<f32>(_e299, _e259.uv.y), _e259.depth, _e259.is_inside);
                        let _e391 = lt_math_LightPoint(vec2<f32>(_e384.uv.x, _e313), _e384.depth, _e384.is_inside);
                        let _e395 = lt_math_LightPoint(_e391.uv, _e326, _e391.is_inside);
                        let _e399 = lt_math_LightPoint(_e395.uv, _e395.depth, _e377);
                        phi_1407_ = _e399;
                        phi_1408_ = (_e261 + 1u);
                        phi_1409_ = lt_math_LevelPoint(_e261, _e399);
                        phi_1410_ = true;
                    }
                    let _e403 = phi_1407_;
                    let _e405 = phi_1408_;
                    let _e407 = phi_1409_;
                    let _e409 = phi_1410_;
                    phi_1242_ = _e403;
                    phi_1245_ = _e405;
                    phi_1247_ = _e407;
                    phi_1411_ = _e409;
                } else {
                    phi_1242_ = lt_math_LightPoint();
                    phi_1245_ = u32();
                    phi_1247_ = lt_math_LevelPoint();
                    phi_1411_ = false;
                }
                let _e411 = phi_1242_;
                let _e413 = phi_1245_;
                let _e415 = phi_1247_;
                let _e417 = phi_1411_;
                continue;
                continuing {
                    phi_1241_ = _e411;
                    phi_1244_ = _e413;
                    phi_1246_ = _e415;
                    break if !(_e417);
                }
            }
            let _e420 = local_3;
            if _e420.point.is_inside {
                if (0f > 0f) {
                    let _e426 = local_4;
                    if (_e426.level < _e58) {
                    } else {
                        return;
                    }
                    let _e431 = levels.member[(0u + _e426.level)];
                    let _e437 = global[0u];
                    if (_e431.row_w.x == _e437) {
                        let _e440 = global[1u];
                        if (_e431.row_w.y == _e440) {
                            let _e443 = global[2u];
                            phi_1451_ = (_e431.row_w.z == _e443);
                            phi_1452_ = false;
                        } else {
                            phi_1451_ = bool();
                            phi_1452_ = true;
                        }
                        let _e446 = phi_1451_;
                        let _e448 = phi_1452_;
                        phi_1453_ = _e446;
                        phi_1454_ = _e448;
                    } else {
                        phi_1453_ = bool();
                        phi_1454_ = true;
                    }
                    let _e450 = phi_1453_;
                    let _e452 = phi_1454_;
                    if _e452 {
                        phi_1458_ = false;
                    } else {
                        phi_1458_ = _e450;
                    }
                    let _e454 = phi_1458_;
                    if _e454 {
                        let _e456 = samples.member[_e64.first_primitive].normal;
                        let _e458 = p.member.map_size;
                        let _e528 = ((abs(((((_e431.row_x.x * _e456.x) + (_e431.row_x.y * _e456.y)) + (_e431.row_x.z * _e456.z)) / (((_e431.row_x.x * _e431.row_x.x) + (_e431.row_x.y * _e431.row_x.y)) + (_e431.row_x.z * _e431.row_x.z)))) + abs(((((_e431.row_y.x * _e456.x) + (_e431.row_y.y * _e456.y)) + (_e431.row_y.z * _e456.z)) / (((_e431.row_y.x * _e431.row_y.x) + (_e431.row_y.y * _e431.row_y.y)) + (_e431.row_y.z * _e431.row_y.z))))) / (abs(((((_e431.row_z.x * _e456.x) + (_e431.row_z.y * _e456.y)) + (_e431.row_z.z * _e456.z)) / (((_e431.row_z.x * _e431.row_z.x) + (_e431.row_z.y * _e431.row_z.y)) + (_e431.row_z.z * _e431.row_z.z)))) * f32(_e458)));
                        if (_e528 < 0.002f) {
                            phi_1540_ = _e528;
                        } else {
                            phi_1540_ = 0.002f;
                        }
                        let _e531 = phi_1540_;
                        phi_1659_ = _e531;
                    } else {
                        let _e533 = p.member.map_size;
                        let _e539 = samples.member[_e64.first_primitive].position;
                        let _e550 = ((((_e431.row_w.x * _e539.x) + (_e431.row_w.y * _e539.y)) + (_e431.row_w.z * _e539.z)) + _e431.row_w.w);
                        let _e563 = ((_e431.row_x.x - (_e431.row_w.x * _e420.point.uv.x)) / _e550);
                        let _e564 = ((_e431.row_x.y - (_e431.row_w.y * _e420.point.uv.x)) / _e550);
                        let _e565 = ((_e431.row_x.z - (_e431.row_w.z * _e420.point.uv.x)) / _e550);
                        let _e578 = ((_e431.row_y.x - (_e431.row_w.x * _e420.point.uv.y)) / _e550);
                        let _e579 = ((_e431.row_y.y - (_e431.row_w.y * _e420.point.uv.y)) / _e550);
                        let _e580 = ((_e431.row_y.z - (_e431.row_w.z * _e420.point.uv.y)) / _e550);
                        let _e586 = samples.member[_e64.first_primitive].normal;
                        let _e591 = ((_e579 * _e586.z) - (_e586.y * _e580));
                        let _e596 = ((_e580 * _e586.x) - (_e586.z * _e578));
                        let _e601 = ((_e578 * _e586.y) - (_e586.x * _e579));
                        let _e603 = samples.member[_e64.first_primitive].normal;
                        let _e608 = ((_e564 * _e603.z) - (_e603.y * _e565));
                        let _e613 = ((_e565 * _e603.x) - (_e603.z * _e563));
                        let _e618 = ((_e563 * _e603.y) - (_e603.x * _e564));
                        let _e645 = ((abs(((((_e431.row_z.x * _e591) + (_e431.row_z.y * _e596)) + (_e431.row_z.z * _e601)) / (((_e563 * _e591) + (_e564 * _e596)) + (_e565 * _e601)))) + abs(((((_e431.row_z.x * _e608) + (_e431.row_z.y * _e613)) + (_e431.row_z.z * _e618)) / (((_e578 * _e608) + (_e579 * _e613)) + (_e580 * _e618))))) / f32(_e533));
                        let _e647 = (16f / f32(_e533));
                        if (_e645 < _e647) {
                            phi_1658_ = _e645;
                        } else {
                            phi_1658_ = _e647;
                        }
                        let _e650 = phi_1658_;
                        phi_1659_ = _e650;
                    }
                    let _e652 = phi_1659_;
                    phi_1662_ = (_e420.point.depth - (0f * _e652));
                } else {
                    phi_1662_ = _e420.point.depth;
                }
                let _e656 = phi_1662_;
                let _e662 = p.member.map_size;
                let _e663 = f32(_e662);
                let _e666 = ((_e420.point.uv.x * _e663) - 0.5f);
                let _e667 = ((_e420.point.uv.y * _e663) - 0.5f);
                if (_e666 > -8388608f) {
                    let _e679 = f32(select(0i, select(select(i32(_e666), i32(-2147483648), (_e666 < bitcast<f32>(3472883712u))), 2147483647i, (_e666 > bitcast<f32>(1325400063u))), (_e666 == _e666)));
                    if (_e679 > _e666) {
                        phi_1691_ = 1f;
                    } else {
                        phi_1691_ = 0f;
                    }
                    let _e682 = phi_1691_;
                    if (_e666 < 8388608f) {
                        phi_1696_ = (_e679 - _e682);
                        phi_1697_ = false;
                    } else {
                        phi_1696_ = f32();
                        phi_1697_ = true;
                    }
                    let _e685 = phi_1696_;
                    let _e687 = phi_1697_;
                    phi_1698_ = _e685;
                    phi_1699_ = _e687;
                } else {
                    phi_1698_ = f32();
                    phi_1699_ = true;
                }
                let _e689 = phi_1698_;
                let _e691 = phi_1699_;
                if _e691 {
                    phi_1703_ = _e666;
                } else {
                    phi_1703_ = _e689;
                }
                let _e693 = phi_1703_;
                if (_e667 > -8388608f) {
                    let _e705 = f32(select(0i, select(select(i32(_e667), i32(-2147483648), (_e667 < bitcast<f32>(3472883712u))), 2147483647i, (_e667 > bitcast<f32>(1325400063u))), (_e667 == _e667)));
                    if (_e705 > _e667) {
                        phi_1723_ = 1f;
                    } else {
                        phi_1723_ = 0f;
                    }
                    let _e708 = phi_1723_;
                    if (_e667 < 8388608f) {
                        phi_1728_ = (_e705 - _e708);
                        phi_1729_ = false;
                    } else {
                        phi_1728_ = f32();
                        phi_1729_ = true;
                    }
                    let _e711 = phi_1728_;
                    let _e713 = phi_1729_;
                    phi_1730_ = _e711;
                    phi_1731_ = _e713;
                } else {
                    phi_1730_ = f32();
                    phi_1731_ = true;
                }
                let _e715 = phi_1730_;
                let _e717 = phi_1731_;
                if _e717 {
                    phi_1735_ = _e667;
                } else {
                    phi_1735_ = _e715;
                }
                let _e719 = phi_1735_;
                let _e720 = (_e666 - _e693);
                let _e721 = (_e667 - _e719);
                let _e730 = select(0i, select(select(i32(_e693), i32(-2147483648), (_e693 < bitcast<f32>(3472883712u))), 2147483647i, (_e693 > bitcast<f32>(1325400063u))), (_e693 == _e693));
                let _e739 = select(0i, select(select(i32(_e719), i32(-2147483648), (_e719 < bitcast<f32>(3472883712u))), 2147483647i, (_e719 > bitcast<f32>(1325400063u))), (_e719 == _e719));
                let _e742 = ((1f - _e720) * (1f - _e721));
                let _e744 = (_e720 * (1f - _e721));
                let _e746 = ((1f - _e720) * _e721);
                let _e747 = (_e720 * _e721);
                let _e749 = p.member.test;
                let _e750 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e749);
                let _e752 = p.member.map_size;
                let _e754 = local_5;
                local_2 = _e750;
                let _e757 = ((_e754.level * _e752) * _e752);
                let _e759 = (bitcast<i32>(_e752) - 1i);
                if (_e730 > 0i) {
                    phi_1784_ = _e730;
                } else {
                    phi_1784_ = 0i;
                }
                let _e762 = phi_1784_;
                if (_e739 > 0i) {
                    phi_1789_ = _e739;
                } else {
                    phi_1789_ = 0i;
                }
                let _e765 = phi_1789_;
                if (_e762 < _e759) {
                    phi_1794_ = _e762;
                } else {
                    phi_1794_ = _e759;
                }
                let _e768 = phi_1794_;
                if (_e765 < _e759) {
                    phi_1799_ = _e765;
                } else {
                    phi_1799_ = _e759;
                }
                let _e771 = phi_1799_;
                let _e772 = bitcast<u32>(_e768);
                let _e774 = (_e730 + 1i);
                let _e775 = (_e739 + 1i);
                if (_e774 > 0i) {
                    phi_1808_ = _e774;
                } else {
                    phi_1808_ = 0i;
                }
                let _e778 = phi_1808_;
                if (_e775 > 0i) {
                    phi_1813_ = _e775;
                } else {
                    phi_1813_ = 0i;
                }
                let _e781 = phi_1813_;
                if (_e778 < _e759) {
                    phi_1818_ = _e778;
                } else {
                    phi_1818_ = _e759;
                }
                let _e784 = phi_1818_;
                if (_e781 < _e759) {
                    phi_1823_ = _e781;
                } else {
                    phi_1823_ = _e759;
                }
                let _e787 = phi_1823_;
                let _e788 = bitcast<u32>(_e784);
                let _e790 = (bitcast<u32>(_e771) * _e752);
                let _e791 = (bitcast<u32>(_e787) * _e752);
                let _e796 = ((_e790 + _e772) + _e757);
                let _e797 = ((_e790 + _e788) + _e757);
                let _e798 = ((_e791 + _e772) + _e757);
                let _e799 = ((_e791 + _e788) + _e757);
                if (_e796 < _e53) {
                } else {
                    return;
                }
                let _e803 = map.member[(0u + _e796)];
                if (_e797 < _e53) {
                } else {
                    return;
                }
                let _e815 = map.member[(0u + _e797)];
                if (_e798 < _e53) {
                } else {
                    return;
                }
                let _e831 = map.member[(0u + _e798)];
                if (_e799 < _e53) {
                } else {
                    return;
                }
                let _e847 = map.member[(0u + _e799)];
                let _e861 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_2), vec4<f32>(((((_e803.x * _e742) + (_e815.x * _e744)) + (_e831.x * _e746)) + (_e847.x * _e747)), ((((_e803.y * _e742) + (_e815.y * _e744)) + (_e831.y * _e746)) + (_e847.y * _e747)), ((((_e803.z * _e742) + (_e815.z * _e744)) + (_e831.z * _e746)) + (_e847.z * _e747)), ((((_e803.w * _e742) + (_e815.w * _e744)) + (_e831.w * _e746)) + (_e847.w * _e747))), _e656);
                let _e863 = p.member.epsilon;
                if (_e861 <= _e863) {
                    phi_1918_ = true;
                } else {
                    phi_1918_ = (_e861 >= (1f - _e863));
                }
                let _e868 = phi_1918_;
                if ((bitcast<u32>(_e861) & 2147483647u) > 2139095040u) {
                    phi_1926_ = true;
                } else {
                    phi_1926_ = !(_e868);
                }
                let _e874 = phi_1926_;
                if _e874 {
                    if (_e861 > 0f) {
                        if (_e861 < 1f) {
                            phi_1938_ = false;
                        } else {
                            phi_1938_ = true;
                        }
                        let _e878 = phi_1938_;
                        phi_1939_ = _e878;
                    } else {
                        phi_1939_ = true;
                    }
                    let _e880 = phi_1939_;
                    if _e880 {
                        phi_1943_ = 0.5f;
                    } else {
                        phi_1943_ = _e861;
                    }
                    let _e882 = phi_1943_;
                    phi_1951_ = evaluate_Verdict(_e882, true);
                } else {
                    if (_e861 > 0.5f) {
                        phi_1949_ = 1f;
                    } else {
                        phi_1949_ = 0f;
                    }
                    let _e886 = phi_1949_;
                    phi_1951_ = evaluate_Verdict(_e886, false);
                }
                let _e889 = phi_1951_;
                phi_1956_ = evaluate_Verdict(_e889.visibility, _e889.is_doubted);
            } else {
                phi_1956_ = evaluate_Verdict(0.5f, true);
            }
            let _e895 = phi_1956_;
            phi_1957_ = _e895;
        }
        let _e897 = phi_1957_;
        visibility.member[_e64.first_primitive] = _e897.visibility;
        phi_1961_ = _e897.is_doubted;
        phi_1962_ = _e64.first_primitive;
    } else {
        phi_1961_ = false;
        phi_1962_ = 0u;
    }
    let _e902 = phi_1961_;
    let _e904 = phi_1962_;
    if (_e48 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e902 {
        let _e908 = atomicAdd((&shared_[0u]), 1u);
        phi_1973_ = _e908;
    } else {
        phi_1973_ = 0u;
    }
    let _e910 = phi_1973_;
    workgroupBarrier();
    if (_e48 == 0u) {
        let _e914 = atomicLoad((&shared_[0u]));
        let _e915 = atomicAdd((&list.member[3u]), _e914);
        atomicStore((&shared_[1u]), _e915);
    }
    workgroupBarrier();
    if _e902 {
        let _e918 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e918) + _e910)]), _e904);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_msm_hausdorff_prefiltered_levels_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_6 = local;
    function_();
}
