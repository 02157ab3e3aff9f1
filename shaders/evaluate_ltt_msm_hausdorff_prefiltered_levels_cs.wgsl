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

struct type_47 {
    member: array<lt_math_LightProjection>,
}

struct lt_math_LightPoint {
    uv: vec2<f32>,
    depth: f32,
    is_inside: bool,
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
var<storage> levels: type_47;
@group(0) @binding(2) 
var<storage> map: type_39;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_183_: lt_bvh_traverse_Tree;
    var phi_184_: bool;
    var phi_185_: lt_bvh_traverse_Tree;
    var phi_186_: bool;
    var phi_191_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_183_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_184_ = false;
        } else {
            phi_183_ = lt_bvh_traverse_Tree();
            phi_184_ = true;
        }
        let _e63 = phi_183_;
        let _e65 = phi_184_;
        phi_185_ = _e63;
        phi_186_ = _e65;
    } else {
        phi_185_ = lt_bvh_traverse_Tree();
        phi_186_ = true;
    }
    let _e67 = phi_185_;
    let _e69 = phi_186_;
    if _e69 {
        phi_191_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_191_ = _e67;
    }
    let _e74 = phi_191_;
    return lt_bvh_traverse_Tree(_e74.root, _e74.first_primitive);
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn lt_math_hausdorff_cubic_mass(param_4: vec4<f32>, param_5: f32, param_6: f32, param_7: f32, param_8: f32) -> f32 {
    return ((((param_4.z - (((param_6 + param_7) + param_8) * param_4.y)) + ((((param_6 * param_7) + (param_6 * param_8)) + (param_7 * param_8)) * param_4.x)) - ((param_6 * param_7) * param_8)) / (((param_5 - param_6) * (param_5 - param_7)) * (param_5 - param_8)));
}

fn lt_math_hausdorff_endpoint_upper_bound(param_9: ptr<function, hankel_HankelFactors>, param_10: f32) -> f32 {
    var phi_961_: f32;
    var phi_962_: f32;
    var phi_963_: f32;
    var phi_990_: f32;
    var phi_991_: f32;
    var phi_992_: f32;
    var phi_993_: f32;
    var phi_994_: bool;
    var phi_995_: f32;
    var phi_996_: bool;
    var phi_1024_: f32;
    var phi_1025_: f32;
    var phi_1026_: f32;
    var phi_1027_: f32;
    var phi_1028_: bool;
    var phi_1029_: f32;
    var phi_1030_: bool;
    var phi_1037_: f32;
    var phi_1038_: f32;
    var phi_1039_: f32;
    var phi_1040_: f32;

    let _e53 = (*param_9).moments;
    if (param_10 < 0.0001f) {
        phi_1040_ = 1f;
    } else {
        let _e62 = ((_e53.z - ((1f + param_10) * _e53.y)) + (param_10 * _e53.x));
        let _e71 = (((_e53.w - ((1f + param_10) * _e53.z)) + (param_10 * _e53.y)) / _e62);
        if (abs(_e62) <= 0.00000047683716f) {
            let _e85 = (1f - (((_e53.y - (_e53.x * (param_10 + 1f))) + (param_10 * 1f)) / ((0f - param_10) * (0f - 1f))));
            if ((bitcast<u32>(_e85) & 2147483647u) > 2139095040u) {
                phi_963_ = _e85;
            } else {
                if (_e85 < 0f) {
                    phi_962_ = 0f;
                } else {
                    if (_e85 > 1f) {
                        phi_961_ = 1f;
                    } else {
                        phi_961_ = _e85;
                    }
                    let _e92 = phi_961_;
                    phi_962_ = _e92;
                }
                let _e94 = phi_962_;
                phi_963_ = _e94;
            }
            let _e96 = phi_963_;
            phi_1039_ = _e96;
        } else {
            if (_e71 > 0f) {
                if (_e71 < param_10) {
                    let _e99 = lt_math_hausdorff_cubic_mass(_e53, 0f, _e71, param_10, 1f);
                    let _e101 = lt_math_hausdorff_cubic_mass(_e53, _e71, 0f, param_10, 1f);
                    let _e102 = ((1f - _e99) - _e101);
                    if ((bitcast<u32>(_e102) & 2147483647u) > 2139095040u) {
                        phi_992_ = _e102;
                    } else {
                        if (_e102 < 0f) {
                            phi_991_ = 0f;
                        } else {
                            if (_e102 > 1f) {
                                phi_990_ = 1f;
                            } else {
                                phi_990_ = _e102;
                            }
                            let _e109 = phi_990_;
                            phi_991_ = _e109;
                        }
                        let _e111 = phi_991_;
                        phi_992_ = _e111;
                    }
                    let _e113 = phi_992_;
                    phi_993_ = _e113;
                    phi_994_ = false;
                } else {
                    phi_993_ = f32();
                    phi_994_ = true;
                }
                let _e115 = phi_993_;
                let _e117 = phi_994_;
                phi_995_ = _e115;
                phi_996_ = _e117;
            } else {
                phi_995_ = f32();
                phi_996_ = true;
            }
            let _e119 = phi_995_;
            let _e121 = phi_996_;
            if _e121 {
                if (_e71 > param_10) {
                    if (_e71 < 1f) {
                        let _e124 = lt_math_hausdorff_cubic_mass(_e53, 0f, _e71, param_10, 1f);
                        let _e125 = (1f - _e124);
                        if ((bitcast<u32>(_e125) & 2147483647u) > 2139095040u) {
                            phi_1026_ = _e125;
                        } else {
                            if (_e125 < 0f) {
                                phi_1025_ = 0f;
                            } else {
                                if (_e125 > 1f) {
                                    phi_1024_ = 1f;
                                } else {
                                    phi_1024_ = _e125;
                                }
                                let _e132 = phi_1024_;
                                phi_1025_ = _e132;
                            }
                            let _e134 = phi_1025_;
                            phi_1026_ = _e134;
                        }
                        let _e136 = phi_1026_;
                        phi_1027_ = _e136;
                        phi_1028_ = false;
                    } else {
                        phi_1027_ = f32();
                        phi_1028_ = true;
                    }
                    let _e138 = phi_1027_;
                    let _e140 = phi_1028_;
                    phi_1029_ = _e138;
                    phi_1030_ = _e140;
                } else {
                    phi_1029_ = f32();
                    phi_1030_ = true;
                }
                let _e142 = phi_1029_;
                let _e144 = phi_1030_;
                if _e144 {
                    phi_1037_ = bitcast<f32>((bitcast<u32>(_e71) | 2143289344u));
                } else {
                    phi_1037_ = _e142;
                }
                let _e149 = phi_1037_;
                phi_1038_ = _e149;
            } else {
                phi_1038_ = _e119;
            }
            let _e151 = phi_1038_;
            phi_1039_ = _e151;
        }
        let _e153 = phi_1039_;
        phi_1040_ = _e153;
    }
    let _e155 = phi_1040_;
    return _e155;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_11: ptr<function, f32>, param_12: vec4<f32>, param_13: f32) -> f32 {
    var local_1: hankel_HankelFactors;
    var phi_248_: f32;
    var phi_249_: f32;
    var phi_250_: f32;
    var phi_262_: bool;
    var phi_277_: bool;
    var phi_302_: f32;
    var phi_303_: f32;
    var phi_304_: f32;
    var phi_305_: f32;
    var phi_306_: bool;
    var phi_307_: f32;
    var phi_308_: bool;
    var phi_364_: vec2<f32>;
    var phi_402_: f32;
    var phi_403_: f32;
    var phi_404_: f32;
    var phi_437_: f32;
    var phi_438_: f32;
    var phi_439_: f32;
    var phi_443_: f32;
    var phi_444_: f32;
    var phi_445_: f32;
    var phi_446_: f32;
    var phi_499_: vec2<f32>;
    var phi_521_: bool;
    var phi_546_: f32;
    var phi_547_: f32;
    var phi_548_: f32;
    var phi_549_: f32;
    var phi_550_: bool;
    var phi_551_: f32;
    var phi_552_: bool;
    var phi_608_: vec2<f32>;
    var phi_646_: f32;
    var phi_647_: f32;
    var phi_648_: f32;
    var phi_681_: f32;
    var phi_682_: f32;
    var phi_683_: f32;
    var phi_687_: f32;
    var phi_688_: f32;
    var phi_689_: f32;
    var phi_690_: f32;
    var phi_691_: f32;
    var phi_692_: bool;
    var phi_693_: f32;
    var phi_694_: bool;
    var phi_716_: bool;
    var phi_741_: f32;
    var phi_742_: f32;
    var phi_743_: f32;
    var phi_744_: f32;
    var phi_745_: bool;
    var phi_746_: f32;
    var phi_747_: bool;
    var phi_803_: vec2<f32>;
    var phi_841_: f32;
    var phi_842_: f32;
    var phi_843_: f32;
    var phi_876_: f32;
    var phi_877_: f32;
    var phi_878_: f32;
    var phi_882_: f32;
    var phi_883_: f32;
    var phi_884_: f32;
    var phi_885_: f32;
    var phi_896_: bool;
    var phi_900_: f32;
    var phi_901_: f32;
    var phi_902_: f32;
    var phi_903_: f32;

    let _e54 = (*param_11);
    let _e55 = (1f - _e54);
    let _e64 = (0.5f * _e54);
    let _e65 = ((param_12.x * _e55) + _e64);
    let _e66 = ((param_12.y * _e55) + _e64);
    let _e67 = ((param_12.z * _e55) + _e64);
    let _e68 = ((param_12.w * _e55) + _e64);
    let _e71 = (_e66 - (_e65 * _e65));
    let _e73 = (_e67 - (_e65 * _e66));
    let _e79 = hankel_HankelFactors(vec4<f32>(_e65, _e66, _e67, _e68), _e71, _e73, (((_e68 - (_e66 * _e66)) * _e71) - (_e73 * _e73)));
    local_1 = hankel_HankelFactors(_e79.moments, _e79.d22_, _e79.l32_d22_, _e79.d33_d22_);
    if ((bitcast<u32>(param_13) & 2147483647u) > 2139095040u) {
        phi_250_ = param_13;
    } else {
        if (param_13 < 0f) {
            phi_249_ = 0f;
        } else {
            if (param_13 > 1f) {
                phi_248_ = 1f;
            } else {
                phi_248_ = param_13;
            }
            let _e91 = phi_248_;
            phi_249_ = _e91;
        }
        let _e93 = phi_249_;
        phi_250_ = _e93;
    }
    let _e95 = phi_250_;
    let _e98 = local_1.moments[0u];
    let _e101 = local_1.moments[3u];
    if (_e98 == _e101) {
        let _e105 = local_1.moments[0u];
        phi_262_ = (_e105 > 0.5f);
    } else {
        phi_262_ = false;
    }
    let _e108 = phi_262_;
    if _e108 {
        let _e111 = local_1.moments[0u];
        let _e114 = local_1.moments[3u];
        if (_e111 == _e114) {
            let _e118 = local_1.moments[0u];
            phi_277_ = (_e118 > 0.5f);
        } else {
            phi_277_ = false;
        }
        let _e121 = phi_277_;
        if _e121 {
            if (_e95 > 0f) {
                let _e124 = local_1.moments;
                if ((bitcast<u32>(_e124.x) & 2147483647u) > 2139095040u) {
                    phi_304_ = _e124.x;
                } else {
                    if (_e124.x < 0f) {
                        phi_303_ = 0f;
                    } else {
                        if (_e124.x > 1f) {
                            phi_302_ = 1f;
                        } else {
                            phi_302_ = _e124.x;
                        }
                        let _e132 = phi_302_;
                        phi_303_ = _e132;
                    }
                    let _e134 = phi_303_;
                    phi_304_ = _e134;
                }
                let _e136 = phi_304_;
                phi_305_ = _e136;
                phi_306_ = false;
            } else {
                phi_305_ = f32();
                phi_306_ = true;
            }
            let _e138 = phi_305_;
            let _e140 = phi_306_;
            phi_307_ = _e138;
            phi_308_ = _e140;
        } else {
            phi_307_ = f32();
            phi_308_ = true;
        }
        let _e142 = phi_307_;
        let _e144 = phi_308_;
        if _e144 {
            let _e147 = local_1.moments[0u];
            let _e150 = local_1.moments[1u];
            let _e158 = local_1.l32_d22_;
            let _e160 = local_1.d22_;
            let _e161 = (_e158 / _e160);
            let _e162 = (_e95 - _e147);
            let _e168 = local_1.d22_;
            let _e171 = local_1.d33_d22_;
            let _e172 = (((((_e95 * _e95) - _e150) - (_e161 * _e162)) * _e168) / _e171);
            let _e174 = local_1.d22_;
            let _e177 = ((_e162 / _e174) - (_e161 * _e172));
            let _e183 = ((0.5f * _e177) / _e172);
            let _e186 = ((_e183 * _e183) - (((1f - (_e177 * _e147)) - (_e172 * _e150)) / _e172));
            if (_e186 >= 0f) {
                let _e188 = sqrt(_e186);
                phi_364_ = vec2<f32>((-(_e183) - _e188), (-(_e183) + _e188));
            } else {
                phi_364_ = vec2(bitcast<f32>((bitcast<u32>(_e186) | 2143289344u)));
            }
            let _e199 = phi_364_;
            if (_e95 <= _e199.x) {
                phi_445_ = 1f;
            } else {
                if (_e95 > _e199.y) {
                    let _e205 = local_1.moments;
                    let _e216 = (((_e205.y - (_e205.x * (_e199.x + _e199.y))) + (_e199.x * _e199.y)) / ((_e95 - _e199.x) * (_e95 - _e199.y)));
                    if ((bitcast<u32>(_e216) & 2147483647u) > 2139095040u) {
                        phi_404_ = _e216;
                    } else {
                        if (_e216 < 0f) {
                            phi_403_ = 0f;
                        } else {
                            if (_e216 > 1f) {
                                phi_402_ = 1f;
                            } else {
                                phi_402_ = _e216;
                            }
                            let _e223 = phi_402_;
                            phi_403_ = _e223;
                        }
                        let _e225 = phi_403_;
                        phi_404_ = _e225;
                    }
                    let _e227 = phi_404_;
                    phi_444_ = _e227;
                } else {
                    if (_e95 > _e199.x) {
                        let _e230 = local_1.moments;
                        let _e242 = (1f - (((_e230.y - (_e230.x * (_e95 + _e199.y))) + (_e95 * _e199.y)) / ((_e199.x - _e95) * (_e199.x - _e199.y))));
                        if ((bitcast<u32>(_e242) & 2147483647u) > 2139095040u) {
                            phi_439_ = _e242;
                        } else {
                            if (_e242 < 0f) {
                                phi_438_ = 0f;
                            } else {
                                if (_e242 > 1f) {
                                    phi_437_ = 1f;
                                } else {
                                    phi_437_ = _e242;
                                }
                                let _e249 = phi_437_;
                                phi_438_ = _e249;
                            }
                            let _e251 = phi_438_;
                            phi_439_ = _e251;
                        }
                        let _e253 = phi_439_;
                        phi_443_ = _e253;
                    } else {
                        phi_443_ = bitcast<f32>((bitcast<u32>(_e199.x) | 2143289344u));
                    }
                    let _e258 = phi_443_;
                    phi_444_ = _e258;
                }
                let _e260 = phi_444_;
                phi_445_ = _e260;
            }
            let _e262 = phi_445_;
            phi_446_ = _e262;
        } else {
            phi_446_ = _e142;
        }
        let _e264 = phi_446_;
        phi_903_ = _e264;
    } else {
        let _e267 = local_1.moments[0u];
        let _e270 = local_1.moments[1u];
        let _e278 = local_1.l32_d22_;
        let _e280 = local_1.d22_;
        let _e281 = (_e278 / _e280);
        let _e282 = (_e95 - _e267);
        let _e288 = local_1.d22_;
        let _e291 = local_1.d33_d22_;
        let _e292 = (((((_e95 * _e95) - _e270) - (_e281 * _e282)) * _e288) / _e291);
        let _e294 = local_1.d22_;
        let _e297 = ((_e282 / _e294) - (_e281 * _e292));
        let _e303 = ((0.5f * _e297) / _e292);
        let _e306 = ((_e303 * _e303) - (((1f - (_e297 * _e267)) - (_e292 * _e270)) / _e292));
        if (_e306 >= 0f) {
            let _e308 = sqrt(_e306);
            phi_499_ = vec2<f32>((-(_e303) - _e308), (-(_e303) + _e308));
        } else {
            phi_499_ = vec2(bitcast<f32>((bitcast<u32>(_e306) | 2143289344u)));
        }
        let _e319 = phi_499_;
        if (_e319.x >= 0f) {
            if (_e319.y <= 1f) {
                let _e326 = local_1.moments[0u];
                let _e329 = local_1.moments[3u];
                if (_e326 == _e329) {
                    let _e333 = local_1.moments[0u];
                    phi_521_ = (_e333 > 0.5f);
                } else {
                    phi_521_ = false;
                }
                let _e336 = phi_521_;
                if _e336 {
                    if (_e95 > 0f) {
                        let _e339 = local_1.moments;
                        if ((bitcast<u32>(_e339.x) & 2147483647u) > 2139095040u) {
                            phi_548_ = _e339.x;
                        } else {
                            if (_e339.x < 0f) {
                                phi_547_ = 0f;
                            } else {
                                if (_e339.x > 1f) {
                                    phi_546_ = 1f;
                                } else {
                                    phi_546_ = _e339.x;
                                }
                                let _e347 = phi_546_;
                                phi_547_ = _e347;
                            }
                            let _e349 = phi_547_;
                            phi_548_ = _e349;
                        }
                        let _e351 = phi_548_;
                        phi_549_ = _e351;
                        phi_550_ = false;
                    } else {
                        phi_549_ = f32();
                        phi_550_ = true;
                    }
                    let _e353 = phi_549_;
                    let _e355 = phi_550_;
                    phi_551_ = _e353;
                    phi_552_ = _e355;
                } else {
                    phi_551_ = f32();
                    phi_552_ = true;
                }
                let _e357 = phi_551_;
                let _e359 = phi_552_;
                if _e359 {
                    let _e362 = local_1.moments[0u];
                    let _e365 = local_1.moments[1u];
                    let _e373 = local_1.l32_d22_;
                    let _e375 = local_1.d22_;
                    let _e376 = (_e373 / _e375);
                    let _e377 = (_e95 - _e362);
                    let _e383 = local_1.d22_;
                    let _e386 = local_1.d33_d22_;
                    let _e387 = (((((_e95 * _e95) - _e365) - (_e376 * _e377)) * _e383) / _e386);
                    let _e389 = local_1.d22_;
                    let _e392 = ((_e377 / _e389) - (_e376 * _e387));
                    let _e398 = ((0.5f * _e392) / _e387);
                    let _e401 = ((_e398 * _e398) - (((1f - (_e392 * _e362)) - (_e387 * _e365)) / _e387));
                    if (_e401 >= 0f) {
                        let _e403 = sqrt(_e401);
                        phi_608_ = vec2<f32>((-(_e398) - _e403), (-(_e398) + _e403));
                    } else {
                        phi_608_ = vec2(bitcast<f32>((bitcast<u32>(_e401) | 2143289344u)));
                    }
                    let _e414 = phi_608_;
                    if (_e95 <= _e414.x) {
                        phi_689_ = 1f;
                    } else {
                        if (_e95 > _e414.y) {
                            let _e420 = local_1.moments;
                            let _e431 = (((_e420.y - (_e420.x * (_e414.x + _e414.y))) + (_e414.x * _e414.y)) / ((_e95 - _e414.x) * (_e95 - _e414.y)));
                            if ((bitcast<u32>(_e431) & 2147483647u) > 2139095040u) {
                                phi_648_ = _e431;
                            } else {
                                if (_e431 < 0f) {
                                    phi_647_ = 0f;
                                } else {
                                    if (_e431 > 1f) {
                                        phi_646_ = 1f;
                                    } else {
                                        phi_646_ = _e431;
                                    }
                                    let _e438 = phi_646_;
                                    phi_647_ = _e438;
                                }
                                let _e440 = phi_647_;
                                phi_648_ = _e440;
                            }
                            let _e442 = phi_648_;
                            phi_688_ = _e442;
                        } else {
                            if (_e95 > _e414.x) {
                                let _e445 = local_1.moments;
                                let _e457 = (1f - (((_e445.y - (_e445.x * (_e95 + _e414.y))) + (_e95 * _e414.y)) / ((_e414.x - _e95) * (_e414.x - _e414.y))));
                                if ((bitcast<u32>(_e457) & 2147483647u) > 2139095040u) {
                                    phi_683_ = _e457;
                                } else {
                                    if (_e457 < 0f) {
                                        phi_682_ = 0f;
                                    } else {
                                        if (_e457 > 1f) {
                                            phi_681_ = 1f;
                                        } else {
                                            phi_681_ = _e457;
                                        }
                                        let _e464 = phi_681_;
                                        phi_682_ = _e464;
                                    }
                                    let _e466 = phi_682_;
                                    phi_683_ = _e466;
                                }
                                let _e468 = phi_683_;
                                phi_687_ = _e468;
                            } else {
                                phi_687_ = bitcast<f32>((bitcast<u32>(_e414.x) | 2143289344u));
                            }
                            let _e473 = phi_687_;
                            phi_688_ = _e473;
                        }
                        let _e475 = phi_688_;
                        phi_689_ = _e475;
                    }
                    let _e477 = phi_689_;
                    phi_690_ = _e477;
                } else {
                    phi_690_ = _e357;
                }
                let _e479 = phi_690_;
                phi_691_ = _e479;
                phi_692_ = false;
            } else {
                phi_691_ = f32();
                phi_692_ = true;
            }
            let _e481 = phi_691_;
            let _e483 = phi_692_;
            phi_693_ = _e481;
            phi_694_ = _e483;
        } else {
            phi_693_ = f32();
            phi_694_ = true;
        }
        let _e485 = phi_693_;
        let _e487 = phi_694_;
        if _e487 {
            if ((bitcast<u32>(_e319.x) & 2147483647u) > 2139095040u) {
                phi_901_ = _e319.x;
            } else {
                let _e491 = lt_math_hausdorff_endpoint_upper_bound((&local_1), _e95);
                let _e494 = local_1.moments[0u];
                let _e497 = local_1.moments[3u];
                if (_e494 == _e497) {
                    let _e501 = local_1.moments[0u];
                    phi_716_ = (_e501 > 0.5f);
                } else {
                    phi_716_ = false;
                }
                let _e504 = phi_716_;
                if _e504 {
                    if (_e95 > 0f) {
                        let _e507 = local_1.moments;
                        if ((bitcast<u32>(_e507.x) & 2147483647u) > 2139095040u) {
                            phi_743_ = _e507.x;
                        } else {
                            if (_e507.x < 0f) {
                                phi_742_ = 0f;
                            } else {
                                if (_e507.x > 1f) {
                                    phi_741_ = 1f;
                                } else {
                                    phi_741_ = _e507.x;
                                }
                                let _e515 = phi_741_;
                                phi_742_ = _e515;
                            }
                            let _e517 = phi_742_;
                            phi_743_ = _e517;
                        }
                        let _e519 = phi_743_;
                        phi_744_ = _e519;
                        phi_745_ = false;
                    } else {
                        phi_744_ = f32();
                        phi_745_ = true;
                    }
                    let _e521 = phi_744_;
                    let _e523 = phi_745_;
                    phi_746_ = _e521;
                    phi_747_ = _e523;
                } else {
                    phi_746_ = f32();
                    phi_747_ = true;
                }
                let _e525 = phi_746_;
                let _e527 = phi_747_;
                if _e527 {
                    let _e530 = local_1.moments[0u];
                    let _e533 = local_1.moments[1u];
                    let _e541 = local_1.l32_d22_;
                    let _e543 = local_1.d22_;
                    let _e544 = (_e541 / _e543);
                    let _e545 = (_e95 - _e530);
                    let _e551 = local_1.d22_;
                    let _e554 = local_1.d33_d22_;
                    let _e555 = (((((_e95 * _e95) - _e533) - (_e544 * _e545)) * _e551) / _e554);
                    let _e557 = local_1.d22_;
                    let _e560 = ((_e545 / _e557) - (_e544 * _e555));
                    let _e566 = ((0.5f * _e560) / _e555);
                    let _e569 = ((_e566 * _e566) - (((1f - (_e560 * _e530)) - (_e555 * _e533)) / _e555));
                    if (_e569 >= 0f) {
                        let _e571 = sqrt(_e569);
                        phi_803_ = vec2<f32>((-(_e566) - _e571), (-(_e566) + _e571));
                    } else {
                        phi_803_ = vec2(bitcast<f32>((bitcast<u32>(_e569) | 2143289344u)));
                    }
                    let _e582 = phi_803_;
                    if (_e95 <= _e582.x) {
                        phi_884_ = 1f;
                    } else {
                        if (_e95 > _e582.y) {
                            let _e588 = local_1.moments;
                            let _e599 = (((_e588.y - (_e588.x * (_e582.x + _e582.y))) + (_e582.x * _e582.y)) / ((_e95 - _e582.x) * (_e95 - _e582.y)));
                            if ((bitcast<u32>(_e599) & 2147483647u) > 2139095040u) {
                                phi_843_ = _e599;
                            } else {
                                if (_e599 < 0f) {
                                    phi_842_ = 0f;
                                } else {
                                    if (_e599 > 1f) {
                                        phi_841_ = 1f;
                                    } else {
                                        phi_841_ = _e599;
                                    }
                                    let _e606 = phi_841_;
                                    phi_842_ = _e606;
                                }
                                let _e608 = phi_842_;
                                phi_843_ = _e608;
                            }
                            let _e610 = phi_843_;
                            phi_883_ = _e610;
                        } else {
                            if (_e95 > _e582.x) {
                                let _e613 = local_1.moments;
                                let _e625 = (1f - (((_e613.y - (_e613.x * (_e95 + _e582.y))) + (_e95 * _e582.y)) / ((_e582.x - _e95) * (_e582.x - _e582.y))));
                                if ((bitcast<u32>(_e625) & 2147483647u) > 2139095040u) {
                                    phi_878_ = _e625;
                                } else {
                                    if (_e625 < 0f) {
                                        phi_877_ = 0f;
                                    } else {
                                        if (_e625 > 1f) {
                                            phi_876_ = 1f;
                                        } else {
                                            phi_876_ = _e625;
                                        }
                                        let _e632 = phi_876_;
                                        phi_877_ = _e632;
                                    }
                                    let _e634 = phi_877_;
                                    phi_878_ = _e634;
                                }
                                let _e636 = phi_878_;
                                phi_882_ = _e636;
                            } else {
                                phi_882_ = bitcast<f32>((bitcast<u32>(_e582.x) | 2143289344u));
                            }
                            let _e641 = phi_882_;
                            phi_883_ = _e641;
                        }
                        let _e643 = phi_883_;
                        phi_884_ = _e643;
                    }
                    let _e645 = phi_884_;
                    phi_885_ = _e645;
                } else {
                    phi_885_ = _e525;
                }
                let _e647 = phi_885_;
                if ((bitcast<u32>(_e647) & 2147483647u) > 2139095040u) {
                    phi_896_ = true;
                } else {
                    let _e651 = (_e647 < _e491);
                    if _e651 {
                    }
                    phi_896_ = _e651;
                }
                let _e653 = phi_896_;
                if _e653 {
                    phi_900_ = _e647;
                } else {
                    phi_900_ = _e491;
                }
                let _e655 = phi_900_;
                phi_901_ = _e655;
            }
            let _e657 = phi_901_;
            phi_902_ = _e657;
        } else {
            phi_902_ = _e485;
        }
        let _e659 = phi_902_;
        phi_903_ = _e659;
    }
    let _e661 = phi_903_;
    return _e661;
}

fn function_() {
    var local_2: f32;
    var phi_1124_: bool;
    var phi_1125_: bool;
    var phi_1126_: bool;
    var phi_1127_: bool;
    var phi_1131_: bool;
    var phi_1201_: bool;
    var phi_1202_: bool;
    var phi_1213_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1214_: bool;
    var phi_1215_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1216_: bool;
    var phi_1223_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1227_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1247_: lt_math_LightPoint;
    var phi_1250_: u32;
    var phi_1252_: lt_math_LevelPoint;
    var phi_1338_: bool;
    var phi_1347_: bool;
    var phi_1356_: bool;
    var phi_1357_: bool;
    var phi_1358_: bool;
    var phi_1359_: bool;
    var phi_1360_: bool;
    var phi_1361_: bool;
    var phi_1362_: bool;
    var phi_1366_: bool;
    var phi_1393_: bool;
    var phi_1394_: bool;
    var phi_1395_: bool;
    var phi_1396_: bool;
    var phi_1397_: bool;
    var phi_1398_: bool;
    var phi_1399_: bool;
    var phi_1400_: bool;
    var phi_1404_: bool;
    var phi_1413_: lt_math_LightPoint;
    var phi_1414_: u32;
    var phi_1415_: lt_math_LevelPoint;
    var phi_1416_: bool;
    var phi_1248_: lt_math_LightPoint;
    var phi_1251_: u32;
    var phi_1253_: lt_math_LevelPoint;
    var phi_1417_: bool;
    var local_3: lt_math_LevelPoint;
    var local_4: lt_math_LevelPoint;
    var phi_1457_: bool;
    var phi_1458_: bool;
    var phi_1459_: bool;
    var phi_1460_: bool;
    var phi_1464_: bool;
    var phi_1546_: f32;
    var phi_1664_: f32;
    var phi_1665_: f32;
    var phi_1668_: f32;
    var phi_1697_: f32;
    var phi_1702_: f32;
    var phi_1703_: bool;
    var phi_1704_: f32;
    var phi_1705_: bool;
    var phi_1709_: f32;
    var phi_1729_: f32;
    var phi_1734_: f32;
    var phi_1735_: bool;
    var phi_1736_: f32;
    var phi_1737_: bool;
    var phi_1741_: f32;
    var local_5: lt_math_LevelPoint;
    var phi_1790_: i32;
    var phi_1795_: i32;
    var phi_1800_: i32;
    var phi_1805_: i32;
    var phi_1814_: i32;
    var phi_1819_: i32;
    var phi_1824_: i32;
    var phi_1829_: i32;
    var phi_1926_: bool;
    var phi_1934_: bool;
    var phi_1946_: bool;
    var phi_1947_: bool;
    var phi_1951_: f32;
    var phi_1957_: f32;
    var phi_1959_: evaluate_Verdict;
    var phi_1969_: u32;
    var phi_1978_: f32;
    var phi_1980_: evaluate_Verdict;
    var phi_1981_: bool;
    var phi_1982_: evaluate_Verdict;
    var phi_1983_: bool;
    var phi_1988_: evaluate_Verdict;
    var phi_1993_: evaluate_Verdict;
    var phi_1994_: evaluate_Verdict;
    var phi_1998_: bool;
    var phi_1999_: u32;
    var phi_2010_: u32;
    var phi_2027_: u32;

    let _e51 = id_1;
    let _e52 = local_6;
    let _e57 = arrayLength((&map.member));
    let _e62 = arrayLength((&levels.member));
    let _e65 = p.member.size[0u];
    let _e67 = p.member.size[1u];
    let _e68 = lt_shaders_entry_pixel_index(_e51, _e65, _e67);
    if (bitcast<i32>(_e68.root) != 0i) {
        let _e75 = p.member.level_count;
        let _e79 = samples.member[_e68.first_primitive].normal[0u];
        let _e81 = global[0u];
        if (_e79 == _e81) {
            let _e84 = samples.member[_e68.first_primitive].normal[1u];
            let _e86 = global[1u];
            if (_e84 == _e86) {
                let _e89 = samples.member[_e68.first_primitive].normal[2u];
                let _e91 = global[2u];
                phi_1124_ = (_e89 == _e91);
                phi_1125_ = false;
            } else {
                phi_1124_ = bool();
                phi_1125_ = true;
            }
            let _e94 = phi_1124_;
            let _e96 = phi_1125_;
            phi_1126_ = _e94;
            phi_1127_ = _e96;
        } else {
            phi_1126_ = bool();
            phi_1127_ = true;
        }
        let _e98 = phi_1126_;
        let _e100 = phi_1127_;
        if _e100 {
            phi_1131_ = false;
        } else {
            phi_1131_ = _e98;
        }
        let _e102 = phi_1131_;
        if !(_e102) {
            let _e105 = samples.member[_e68.first_primitive].position;
            let _e107 = p.member.light.place;
            let _e113 = p.member.light.place[3u];
            let _e120 = (_e107.x - (_e105.x * _e113));
            let _e121 = (_e107.y - (_e105.y * _e113));
            let _e122 = (_e107.z - (_e105.z * _e113));
            let _e124 = samples.member[_e68.first_primitive].normal;
            if ((((_e124.x * _e120) + (_e124.y * _e121)) + (_e124.z * _e122)) > 0f) {
                let _e138 = (((_e120 * _e120) + (_e121 * _e121)) + (_e122 * _e122));
                let _e140 = p.member.light.axis;
                let _e152 = p.member.light.place[3u];
                if (_e152 == 0f) {
                    phi_1202_ = true;
                } else {
                    let _e155 = p.member.light.range_squared;
                    if (_e138 <= _e155) {
                        let _e158 = p.member.light.cos_outer;
                        phi_1201_ = (-((((_e120 * _e140.x) + (_e121 * _e140.y)) + (_e122 * _e140.z))) >= (_e158 * sqrt(_e138)));
                    } else {
                        phi_1201_ = false;
                    }
                    let _e163 = phi_1201_;
                    phi_1202_ = _e163;
                }
                let _e165 = phi_1202_;
                if _e165 {
                    let _e167 = samples.member[_e68.first_primitive].flags;
                    let _e175 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e181 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e175.unnamed.visibility, false), _e175.unnamed_1);
                    phi_1213_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e181.unnamed, ((_e167 & 1u) == 0u));
                    phi_1214_ = false;
                } else {
                    phi_1213_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_1214_ = true;
                }
                let _e186 = phi_1213_;
                let _e188 = phi_1214_;
                phi_1215_ = _e186;
                phi_1216_ = _e188;
            } else {
                phi_1215_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_1216_ = true;
            }
            let _e190 = phi_1215_;
            let _e192 = phi_1216_;
            if _e192 {
                let _e198 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e204 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e198.unnamed.visibility, false), _e198.unnamed_1);
                phi_1223_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e204.unnamed, true);
            } else {
                phi_1223_ = _e190;
            }
            let _e209 = phi_1223_;
            phi_1227_ = _e209;
        } else {
            let _e215 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e221 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e215.unnamed.visibility, false), _e215.unnamed_1);
            phi_1227_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e221.unnamed, true);
        }
        let _e226 = phi_1227_;
        if _e226.unnamed_1 {
            phi_1994_ = evaluate_Verdict(_e226.unnamed.visibility, _e226.unnamed.is_doubted);
        } else {
            let _e234 = samples.member[_e68.first_primitive].position;
            let _e236 = p.member.map_size;
            let _e238 = (0.5f / f32(_e236));
            let _e245 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e252 = lt_math_LightPoint(vec2<f32>(_e245.uv.x, 0f), _e245.depth, _e245.is_inside);
            let _e256 = lt_math_LightPoint(_e252.uv, 0f, _e252.is_inside);
            phi_1247_ = lt_math_LightPoint();
            phi_1250_ = 0u;
            phi_1252_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e256.uv, _e256.depth, false));
            loop {
                let _e263 = phi_1247_;
                let _e265 = phi_1250_;
                let _e267 = phi_1252_;
                local_3 = _e267;
                local_4 = _e267;
                local_5 = _e267;
                if (_e265 < _e75) {
                    if _e267.point.is_inside {
                        phi_1413_ = lt_math_LightPoint();
                        phi_1414_ = u32();
                        phi_1415_ = lt_math_LevelPoint();
                        phi_1416_ = false;
                    } else {
                        if (_e265 < _e62) {
                        } else {
                            return;
                        }
                        let _e278 = levels.member[(0u + _e265)].row_w;
                        let _e289 = ((((_e278.x * _e234.x) + (_e278.y * _e234.y)) + (_e278.z * _e234.z)) + (_e278.w * 1f));
                        let _e291 = levels.member[(0u + _e265)].row_x;
                        let _e303 = (((((_e291.x * _e234.x) + (_e291.y * _e234.y)) + (_e291.z * _e234.z)) + (_e291.w * 1f)) / _e289);
                        let _e305 = levels.member[(0u + _e265)].row_y;
                        let _e317 = (((((_e305.x * _e234.x) + (_e305.y * _e234.y)) + (_e305.z * _e234.z)) + (_e305.w * 1f)) / _e289);
                        let _e319 = levels.member[(0u + _e265)].row_z;
                        let _e330 = ((((_e319.x * _e234.x) + (_e319.y * _e234.y)) + (_e319.z * _e234.z)) + (_e319.w * 1f));
                        if (_e289 > 0f) {
                            if (_e303 >= 0f) {
                                phi_1338_ = (_e303 <= 1f);
                            } else {
                                phi_1338_ = false;
                            }
                            let _e335 = phi_1338_;
                            if _e335 {
                                if (_e317 >= 0f) {
                                    phi_1347_ = (_e317 <= 1f);
                                } else {
                                    phi_1347_ = false;
                                }
                                let _e339 = phi_1347_;
                                if _e339 {
                                    if (_e330 >= 0f) {
                                        phi_1356_ = (_e330 <= 1f);
                                    } else {
                                        phi_1356_ = false;
                                    }
                                    let _e343 = phi_1356_;
                                    phi_1357_ = _e343;
                                    phi_1358_ = false;
                                } else {
                                    phi_1357_ = bool();
                                    phi_1358_ = true;
                                }
                                let _e345 = phi_1357_;
                                let _e347 = phi_1358_;
                                phi_1359_ = _e345;
                                phi_1360_ = _e347;
                            } else {
                                phi_1359_ = bool();
                                phi_1360_ = true;
                            }
                            let _e349 = phi_1359_;
                            let _e351 = phi_1360_;
                            phi_1361_ = _e349;
                            phi_1362_ = _e351;
                        } else {
                            phi_1361_ = bool();
                            phi_1362_ = true;
                        }
                        let _e353 = phi_1361_;
                        let _e355 = phi_1362_;
                        if _e355 {
                            phi_1366_ = false;
                        } else {
                            phi_1366_ = _e353;
                        }
                        let _e357 = phi_1366_;
                        if _e357 {
                            if (_e303 >= _e238) {
                                if (_e303 <= (1f - _e238)) {
                                    if (_e317 >= _e238) {
                                        phi_1393_ = (_e317 <= (1f - _e238));
                                        phi_1394_ = false;
                                    } else {
                                        phi_1393_ = bool();
                                        phi_1394_ = true;
                                    }
                                    let _e365 = phi_1393_;
                                    let _e367 = phi_1394_;
                                    phi_1395_ = _e365;
                                    phi_1396_ = _e367;
                                } else {
                                    phi_1395_ = bool();
                                    phi_1396_ = true;
                                }
                                let _e369 = phi_1395_;
                                let _e371 = phi_1396_;
                                phi_1397_ = _e369;
                                phi_1398_ = _e371;
                            } else {
                                phi_1397_ = bool();
                                phi_1398_ = true;
                            }
                            let _e373 = phi_1397_;
                            let _e375 = phi_1398_;
                            phi_1399_ = _e373;
                            phi_1400_ = _e375;
                        } else {
                            phi_1399_ = bool();
                            phi_1400_ = true;
                        }
                        let _e377 = phi_1399_;
                        let _e379 = phi_1400_;
                        if _e379 {
                            phi_1404_ = false;
                        } else {
                            phi_1404_ = _e377;
                        }
                        let _e381 = phi_1404_;
                        let _e388 = lt_math_LightPoint(vec2<f32>(_e303, _e263.uv.y), _e263.depth, _e263.is_inside);
                        let _e395 = lt_math_LightPoint(vec2<f32>(_e388.uv.x, _e317), _e388.depth, _e388.is_inside);
                        let _e399 = lt_math_LightPoint(_e395.uv, _e330, _e395.is_inside);
                        let _e403 = lt_math_LightPoint(_e399.uv, _e399.depth, _e381);
                        phi_1413_ = _e403;
                        phi_1414_ = (_e265 + 1u);
                        phi_1415_ = lt_math_LevelPoint(_e265, _e403);
                        phi_1416_ = true;
                    }
                    let _e407 = phi_1413_;
                    let _e409 = phi_1414_;
                    let _e411 = phi_1415_;
                    let _e413 = phi_1416_;
                    phi_1248_ = _e407;
                    phi_1251_ = _e409;
                    phi_1253_ = _e411;
                    phi_1417_ = _e413;
                } else {
                    phi_1248_ = lt_math_LightPoint();
                    phi_1251_ = u32();
                    phi_1253_ = lt_math_LevelPoint();
                    phi_1417_ = false;
                }
                let _e415 = phi_1248_;
                let _e417 = phi_1251_;
                let _e419 = phi_1253_;
                let _e421 = phi_1417_;
                continue;
                continuing {
                    phi_1247_ = _e415;
                    phi_1250_ = _e417;
                    phi_1252_ = _e419;
                    break if !(_e421);
                }
            }
            let _e424 = local_3;
            if _e424.point.is_inside {
                if (0f > 0f) {
                    let _e430 = local_4;
                    if (_e430.level < _e62) {
                    } else {
                        return;
                    }
                    let _e435 = levels.member[(0u + _e430.level)];
                    let _e441 = global[0u];
                    if (_e435.row_w.x == _e441) {
                        let _e444 = global[1u];
                        if (_e435.row_w.y == _e444) {
                            let _e447 = global[2u];
                            phi_1457_ = (_e435.row_w.z == _e447);
                            phi_1458_ = false;
                        } else {
                            phi_1457_ = bool();
                            phi_1458_ = true;
                        }
                        let _e450 = phi_1457_;
                        let _e452 = phi_1458_;
                        phi_1459_ = _e450;
                        phi_1460_ = _e452;
                    } else {
                        phi_1459_ = bool();
                        phi_1460_ = true;
                    }
                    let _e454 = phi_1459_;
                    let _e456 = phi_1460_;
                    if _e456 {
                        phi_1464_ = false;
                    } else {
                        phi_1464_ = _e454;
                    }
                    let _e458 = phi_1464_;
                    if _e458 {
                        let _e460 = samples.member[_e68.first_primitive].normal;
                        let _e462 = p.member.map_size;
                        let _e532 = ((abs(((((_e435.row_x.x * _e460.x) + (_e435.row_x.y * _e460.y)) + (_e435.row_x.z * _e460.z)) / (((_e435.row_x.x * _e435.row_x.x) + (_e435.row_x.y * _e435.row_x.y)) + (_e435.row_x.z * _e435.row_x.z)))) + abs(((((_e435.row_y.x * _e460.x) + (_e435.row_y.y * _e460.y)) + (_e435.row_y.z * _e460.z)) / (((_e435.row_y.x * _e435.row_y.x) + (_e435.row_y.y * _e435.row_y.y)) + (_e435.row_y.z * _e435.row_y.z))))) / (abs(((((_e435.row_z.x * _e460.x) + (_e435.row_z.y * _e460.y)) + (_e435.row_z.z * _e460.z)) / (((_e435.row_z.x * _e435.row_z.x) + (_e435.row_z.y * _e435.row_z.y)) + (_e435.row_z.z * _e435.row_z.z)))) * f32(_e462)));
                        if (_e532 < 0.002f) {
                            phi_1546_ = _e532;
                        } else {
                            phi_1546_ = 0.002f;
                        }
                        let _e535 = phi_1546_;
                        phi_1665_ = _e535;
                    } else {
                        let _e537 = p.member.map_size;
                        let _e543 = samples.member[_e68.first_primitive].position;
                        let _e554 = ((((_e435.row_w.x * _e543.x) + (_e435.row_w.y * _e543.y)) + (_e435.row_w.z * _e543.z)) + _e435.row_w.w);
                        let _e567 = ((_e435.row_x.x - (_e435.row_w.x * _e424.point.uv.x)) / _e554);
                        let _e568 = ((_e435.row_x.y - (_e435.row_w.y * _e424.point.uv.x)) / _e554);
                        let _e569 = ((_e435.row_x.z - (_e435.row_w.z * _e424.point.uv.x)) / _e554);
                        let _e582 = ((_e435.row_y.x - (_e435.row_w.x * _e424.point.uv.y)) / _e554);
                        let _e583 = ((_e435.row_y.y - (_e435.row_w.y * _e424.point.uv.y)) / _e554);
                        let _e584 = ((_e435.row_y.z - (_e435.row_w.z * _e424.point.uv.y)) / _e554);
                        let _e590 = samples.member[_e68.first_primitive].normal;
                        let _e595 = ((_e583 * _e590.z) - (_e590.y * _e584));
                        let _e600 = ((_e584 * _e590.x) - (_e590.z * _e582));
                        let _e605 = ((_e582 * _e590.y) - (_e590.x * _e583));
                        let _e607 = samples.member[_e68.first_primitive].normal;
                        let _e612 = ((_e568 * _e607.z) - (_e607.y * _e569));
                        let _e617 = ((_e569 * _e607.x) - (_e607.z * _e567));
                        let _e622 = ((_e567 * _e607.y) - (_e607.x * _e568));
                        let _e649 = ((abs(((((_e435.row_z.x * _e595) + (_e435.row_z.y * _e600)) + (_e435.row_z.z * _e605)) / (((_e567 * _e595) + (_e568 * _e600)) + (_e569 * _e605)))) + abs(((((_e435.row_z.x * _e612) + (_e435.row_z.y * _e617)) + (_e435.row_z.z * _e622)) / (((_e582 * _e612) + (_e583 * _e617)) + (_e584 * _e622))))) / f32(_e537));
                        let _e651 = (16f / f32(_e537));
                        if (_e649 < _e651) {
                            phi_1664_ = _e649;
                        } else {
                            phi_1664_ = _e651;
                        }
                        let _e654 = phi_1664_;
                        phi_1665_ = _e654;
                    }
                    let _e656 = phi_1665_;
                    phi_1668_ = (_e424.point.depth - (0f * _e656));
                } else {
                    phi_1668_ = _e424.point.depth;
                }
                let _e660 = phi_1668_;
                let _e666 = p.member.map_size;
                let _e667 = f32(_e666);
                let _e670 = ((_e424.point.uv.x * _e667) - 0.5f);
                let _e671 = ((_e424.point.uv.y * _e667) - 0.5f);
                if (_e670 > -8388608f) {
                    let _e683 = f32(select(0i, select(select(i32(_e670), i32(-2147483648), (_e670 < bitcast<f32>(3472883712u))), 2147483647i, (_e670 > bitcast<f32>(1325400063u))), (_e670 == _e670)));
                    if (_e683 > _e670) {
                        phi_1697_ = 1f;
                    } else {
                        phi_1697_ = 0f;
                    }
                    let _e686 = phi_1697_;
                    if (_e670 < 8388608f) {
                        phi_1702_ = (_e683 - _e686);
                        phi_1703_ = false;
                    } else {
                        phi_1702_ = f32();
                        phi_1703_ = true;
                    }
                    let _e689 = phi_1702_;
                    let _e691 = phi_1703_;
                    phi_1704_ = _e689;
                    phi_1705_ = _e691;
                } else {
                    phi_1704_ = f32();
                    phi_1705_ = true;
                }
                let _e693 = phi_1704_;
                let _e695 = phi_1705_;
                if _e695 {
                    phi_1709_ = _e670;
                } else {
                    phi_1709_ = _e693;
                }
                let _e697 = phi_1709_;
                if (_e671 > -8388608f) {
                    let _e709 = f32(select(0i, select(select(i32(_e671), i32(-2147483648), (_e671 < bitcast<f32>(3472883712u))), 2147483647i, (_e671 > bitcast<f32>(1325400063u))), (_e671 == _e671)));
                    if (_e709 > _e671) {
                        phi_1729_ = 1f;
                    } else {
                        phi_1729_ = 0f;
                    }
                    let _e712 = phi_1729_;
                    if (_e671 < 8388608f) {
                        phi_1734_ = (_e709 - _e712);
                        phi_1735_ = false;
                    } else {
                        phi_1734_ = f32();
                        phi_1735_ = true;
                    }
                    let _e715 = phi_1734_;
                    let _e717 = phi_1735_;
                    phi_1736_ = _e715;
                    phi_1737_ = _e717;
                } else {
                    phi_1736_ = f32();
                    phi_1737_ = true;
                }
                let _e719 = phi_1736_;
                let _e721 = phi_1737_;
                if _e721 {
                    phi_1741_ = _e671;
                } else {
                    phi_1741_ = _e719;
                }
                let _e723 = phi_1741_;
                let _e724 = (_e670 - _e697);
                let _e725 = (_e671 - _e723);
                let _e734 = select(0i, select(select(i32(_e697), i32(-2147483648), (_e697 < bitcast<f32>(3472883712u))), 2147483647i, (_e697 > bitcast<f32>(1325400063u))), (_e697 == _e697));
                let _e743 = select(0i, select(select(i32(_e723), i32(-2147483648), (_e723 < bitcast<f32>(3472883712u))), 2147483647i, (_e723 > bitcast<f32>(1325400063u))), (_e723 == _e723));
                let _e746 = ((1f - _e724) * (1f - _e725));
                let _e748 = (_e724 * (1f - _e725));
                let _e750 = ((1f - _e724) * _e725);
                let _e751 = (_e724 * _e725);
                let _e753 = p.member.test;
                let _e754 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e753);
                let _e756 = p.member.map_size;
                let _e758 = local_5;
                local_2 = _e754;
                let _e761 = ((_e758.level * _e756) * _e756);
                let _e763 = (bitcast<i32>(_e756) - 1i);
                if (_e734 > 0i) {
                    phi_1790_ = _e734;
                } else {
                    phi_1790_ = 0i;
                }
                let _e766 = phi_1790_;
                if (_e743 > 0i) {
                    phi_1795_ = _e743;
                } else {
                    phi_1795_ = 0i;
                }
                let _e769 = phi_1795_;
                if (_e766 < _e763) {
                    phi_1800_ = _e766;
                } else {
                    phi_1800_ = _e763;
                }
                let _e772 = phi_1800_;
                if (_e769 < _e763) {
                    phi_1805_ = _e769;
                } else {
                    phi_1805_ = _e763;
                }
                let _e775 = phi_1805_;
                let _e776 = bitcast<u32>(_e772);
                let _e778 = (_e734 + 1i);
                let _e779 = (_e743 + 1i);
                if (_e778 > 0i) {
                    phi_1814_ = _e778;
                } else {
                    phi_1814_ = 0i;
                }
                let _e782 = phi_1814_;
                if (_e779 > 0i) {
                    phi_1819_ = _e779;
                } else {
                    phi_1819_ = 0i;
                }
                let _e785 = phi_1819_;
                if (_e782 < _e763) {
                    phi_1824_ = _e782;
                } else {
                    phi_1824_ = _e763;
                }
                let _e788 = phi_1824_;
                if (_e785 < _e763) {
                    phi_1829_ = _e785;
                } else {
                    phi_1829_ = _e763;
                }
                let _e791 = phi_1829_;
                let _e792 = bitcast<u32>(_e788);
                let _e794 = (bitcast<u32>(_e775) * _e756);
                let _e795 = (bitcast<u32>(_e791) * _e756);
                let _e800 = ((_e794 + _e776) + _e761);
                let _e801 = ((_e794 + _e792) + _e761);
                let _e802 = ((_e795 + _e776) + _e761);
                let _e803 = ((_e795 + _e792) + _e761);
                if (_e800 < _e57) {
                } else {
                    return;
                }
                let _e807 = map.member[(0u + _e800)];
                if (_e801 < _e57) {
                } else {
                    return;
                }
                let _e819 = map.member[(0u + _e801)];
                if (_e802 < _e57) {
                } else {
                    return;
                }
                let _e835 = map.member[(0u + _e802)];
                if (_e803 < _e57) {
                } else {
                    return;
                }
                let _e851 = map.member[(0u + _e803)];
                let _e865 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_2), vec4<f32>(((((_e807.x * _e746) + (_e819.x * _e748)) + (_e835.x * _e750)) + (_e851.x * _e751)), ((((_e807.y * _e746) + (_e819.y * _e748)) + (_e835.y * _e750)) + (_e851.y * _e751)), ((((_e807.z * _e746) + (_e819.z * _e748)) + (_e835.z * _e750)) + (_e851.z * _e751)), ((((_e807.w * _e746) + (_e819.w * _e748)) + (_e835.w * _e750)) + (_e851.w * _e751))), _e660);
                let _e869 = p.member.epsilon;
                if (_e865 <= _e869) {
                    phi_1926_ = true;
                } else {
                    phi_1926_ = (_e865 >= (1f - _e869));
                }
                let _e874 = phi_1926_;
                if ((bitcast<u32>(_e865) & 2147483647u) > 2139095040u) {
                    phi_1934_ = true;
                } else {
                    phi_1934_ = !(_e874);
                }
                let _e880 = phi_1934_;
                if _e880 {
                    if (_e865 > 0f) {
                        if (_e865 < 1f) {
                            phi_1946_ = false;
                        } else {
                            phi_1946_ = true;
                        }
                        let _e884 = phi_1946_;
                        phi_1947_ = _e884;
                    } else {
                        phi_1947_ = true;
                    }
                    let _e886 = phi_1947_;
                    if _e886 {
                        phi_1951_ = 0.5f;
                    } else {
                        phi_1951_ = _e865;
                    }
                    let _e888 = phi_1951_;
                    phi_1959_ = evaluate_Verdict(_e888, true);
                } else {
                    if (_e865 > 0.5f) {
                        phi_1957_ = 1f;
                    } else {
                        phi_1957_ = 0f;
                    }
                    let _e892 = phi_1957_;
                    phi_1959_ = evaluate_Verdict(_e892, false);
                }
                let _e895 = phi_1959_;
                let _e898 = (_e895.visibility < 0.5f);
                if _e895.is_doubted {
                    phi_1982_ = evaluate_Verdict();
                    phi_1983_ = true;
                } else {
                    if _e898 {
                        phi_1969_ = 2u;
                    } else {
                        phi_1969_ = 1u;
                    }
                    let _e900 = phi_1969_;
                    if ((0u & _e900) != 0u) {
                        if _e898 {
                            phi_1978_ = 0.000000059604645f;
                        } else {
                            phi_1978_ = 0.99999994f;
                        }
                        let _e904 = phi_1978_;
                        phi_1980_ = evaluate_Verdict(_e904, true);
                        phi_1981_ = false;
                    } else {
                        phi_1980_ = evaluate_Verdict();
                        phi_1981_ = true;
                    }
                    let _e907 = phi_1980_;
                    let _e909 = phi_1981_;
                    phi_1982_ = _e907;
                    phi_1983_ = _e909;
                }
                let _e911 = phi_1982_;
                let _e913 = phi_1983_;
                if _e913 {
                    phi_1988_ = evaluate_Verdict(_e895.visibility, _e895.is_doubted);
                } else {
                    phi_1988_ = _e911;
                }
                let _e916 = phi_1988_;
                phi_1993_ = evaluate_Verdict(_e916.visibility, _e916.is_doubted);
            } else {
                phi_1993_ = evaluate_Verdict(0.5f, true);
            }
            let _e922 = phi_1993_;
            phi_1994_ = _e922;
        }
        let _e924 = phi_1994_;
        visibility.member[_e68.first_primitive] = _e924.visibility;
        phi_1998_ = _e924.is_doubted;
        phi_1999_ = _e68.first_primitive;
    } else {
        phi_1998_ = false;
        phi_1999_ = 0u;
    }
    let _e929 = phi_1998_;
    let _e931 = phi_1999_;
    if (_e52 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e929 {
        let _e935 = atomicAdd((&shared_[0u]), 1u);
        phi_2010_ = _e935;
    } else {
        phi_2010_ = 0u;
    }
    let _e937 = phi_2010_;
    workgroupBarrier();
    if (_e52 == 0u) {
        let _e941 = atomicLoad((&shared_[0u]));
        let _e942 = atomicAdd((&list.member[3u]), _e941);
        atomicStore((&shared_[1u]), _e942);
    }
    workgroupBarrier();
    if _e929 {
        if false {
            phi_2027_ = (_e931 | 2147483648u);
        } else {
            phi_2027_ = _e931;
        }
        let _e946 = phi_2027_;
        let _e948 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e948) + _e937)]), _e946);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_msm_hausdorff_prefiltered_levels_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_6 = local;
    function_();
}
