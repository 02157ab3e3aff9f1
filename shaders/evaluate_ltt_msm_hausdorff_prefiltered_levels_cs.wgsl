struct abi_LightParams {
    place: vec4<f32>,
    axis: vec3<f32>,
    cos_outer: f32,
    range_squared: f32,
    cos_inner: f32,
    pad: vec2<u32>,
}

struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_10 {
    member: array<abi_Sample>,
}

struct type_14 {
    member: array<u32>,
}

struct type_18 {
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
var<storage> samples: type_10;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(0) 
var<uniform> p: type_43;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_18;
@group(0) @binding(4) 
var<storage, read_write> list: type_57;
@group(0) @binding(5) 
var<storage> levels: type_49;
@group(0) @binding(2) 
var<storage> map: type_39;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_176_: lt_bvh_traverse_Tree;
    var phi_177_: bool;
    var phi_178_: lt_bvh_traverse_Tree;
    var phi_179_: bool;
    var phi_184_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_176_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_177_ = false;
        } else {
            phi_176_ = lt_bvh_traverse_Tree();
            phi_177_ = true;
        }
        let _e58 = phi_176_;
        let _e60 = phi_177_;
        phi_178_ = _e58;
        phi_179_ = _e60;
    } else {
        phi_178_ = lt_bvh_traverse_Tree();
        phi_179_ = true;
    }
    let _e62 = phi_178_;
    let _e64 = phi_179_;
    if _e64 {
        phi_184_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_184_ = _e62;
    }
    let _e69 = phi_184_;
    return lt_bvh_traverse_Tree(_e69.root, _e69.first_primitive);
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn lt_math_hausdorff_cubic_mass(param_4: vec4<f32>, param_5: f32, param_6: f32, param_7: f32, param_8: f32) -> f32 {
    return ((((param_4.z - (((param_6 + param_7) + param_8) * param_4.y)) + ((((param_6 * param_7) + (param_6 * param_8)) + (param_7 * param_8)) * param_4.x)) - ((param_6 * param_7) * param_8)) / (((param_5 - param_6) * (param_5 - param_7)) * (param_5 - param_8)));
}

fn lt_math_hausdorff_endpoint_upper_bound(param_9: ptr<function, hankel_HankelFactors>, param_10: f32) -> f32 {
    var phi_954_: f32;
    var phi_955_: f32;
    var phi_956_: f32;
    var phi_983_: f32;
    var phi_984_: f32;
    var phi_985_: f32;
    var phi_986_: f32;
    var phi_987_: bool;
    var phi_988_: f32;
    var phi_989_: bool;
    var phi_1017_: f32;
    var phi_1018_: f32;
    var phi_1019_: f32;
    var phi_1020_: f32;
    var phi_1021_: bool;
    var phi_1022_: f32;
    var phi_1023_: bool;
    var phi_1030_: f32;
    var phi_1031_: f32;
    var phi_1032_: f32;
    var phi_1033_: f32;

    let _e48 = (*param_9).moments;
    if (param_10 < 0.0001f) {
        phi_1033_ = 1f;
    } else {
        let _e57 = ((_e48.z - ((1f + param_10) * _e48.y)) + (param_10 * _e48.x));
        let _e66 = (((_e48.w - ((1f + param_10) * _e48.z)) + (param_10 * _e48.y)) / _e57);
        if (abs(_e57) <= 0.00000047683716f) {
            let _e80 = (1f - (((_e48.y - (_e48.x * (param_10 + 1f))) + (param_10 * 1f)) / ((0f - param_10) * (0f - 1f))));
            if ((bitcast<u32>(_e80) & 2147483647u) > 2139095040u) {
                phi_956_ = _e80;
            } else {
                if (_e80 < 0f) {
                    phi_955_ = 0f;
                } else {
                    if (_e80 > 1f) {
                        phi_954_ = 1f;
                    } else {
                        phi_954_ = _e80;
                    }
                    let _e87 = phi_954_;
                    phi_955_ = _e87;
                }
                let _e89 = phi_955_;
                phi_956_ = _e89;
            }
            let _e91 = phi_956_;
            phi_1032_ = _e91;
        } else {
            if (_e66 > 0f) {
                if (_e66 < param_10) {
                    let _e94 = lt_math_hausdorff_cubic_mass(_e48, 0f, _e66, param_10, 1f);
                    let _e96 = lt_math_hausdorff_cubic_mass(_e48, _e66, 0f, param_10, 1f);
                    let _e97 = ((1f - _e94) - _e96);
                    if ((bitcast<u32>(_e97) & 2147483647u) > 2139095040u) {
                        phi_985_ = _e97;
                    } else {
                        if (_e97 < 0f) {
                            phi_984_ = 0f;
                        } else {
                            if (_e97 > 1f) {
                                phi_983_ = 1f;
                            } else {
                                phi_983_ = _e97;
                            }
                            let _e104 = phi_983_;
                            phi_984_ = _e104;
                        }
                        let _e106 = phi_984_;
                        phi_985_ = _e106;
                    }
                    let _e108 = phi_985_;
                    phi_986_ = _e108;
                    phi_987_ = false;
                } else {
                    phi_986_ = f32();
                    phi_987_ = true;
                }
                let _e110 = phi_986_;
                let _e112 = phi_987_;
                phi_988_ = _e110;
                phi_989_ = _e112;
            } else {
                phi_988_ = f32();
                phi_989_ = true;
            }
            let _e114 = phi_988_;
            let _e116 = phi_989_;
            if _e116 {
                if (_e66 > param_10) {
                    if (_e66 < 1f) {
                        let _e119 = lt_math_hausdorff_cubic_mass(_e48, 0f, _e66, param_10, 1f);
                        let _e120 = (1f - _e119);
                        if ((bitcast<u32>(_e120) & 2147483647u) > 2139095040u) {
                            phi_1019_ = _e120;
                        } else {
                            if (_e120 < 0f) {
                                phi_1018_ = 0f;
                            } else {
                                if (_e120 > 1f) {
                                    phi_1017_ = 1f;
                                } else {
                                    phi_1017_ = _e120;
                                }
                                let _e127 = phi_1017_;
                                phi_1018_ = _e127;
                            }
                            let _e129 = phi_1018_;
                            phi_1019_ = _e129;
                        }
                        let _e131 = phi_1019_;
                        phi_1020_ = _e131;
                        phi_1021_ = false;
                    } else {
                        phi_1020_ = f32();
                        phi_1021_ = true;
                    }
                    let _e133 = phi_1020_;
                    let _e135 = phi_1021_;
                    phi_1022_ = _e133;
                    phi_1023_ = _e135;
                } else {
                    phi_1022_ = f32();
                    phi_1023_ = true;
                }
                let _e137 = phi_1022_;
                let _e139 = phi_1023_;
                if _e139 {
                    phi_1030_ = bitcast<f32>((bitcast<u32>(_e66) | 2143289344u));
                } else {
                    phi_1030_ = _e137;
                }
                let _e144 = phi_1030_;
                phi_1031_ = _e144;
            } else {
                phi_1031_ = _e114;
            }
            let _e146 = phi_1031_;
            phi_1032_ = _e146;
        }
        let _e148 = phi_1032_;
        phi_1033_ = _e148;
    }
    let _e150 = phi_1033_;
    return _e150;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_11: ptr<function, f32>, param_12: vec4<f32>, param_13: f32) -> f32 {
    var local_1: hankel_HankelFactors;
    var phi_241_: f32;
    var phi_242_: f32;
    var phi_243_: f32;
    var phi_255_: bool;
    var phi_270_: bool;
    var phi_295_: f32;
    var phi_296_: f32;
    var phi_297_: f32;
    var phi_298_: f32;
    var phi_299_: bool;
    var phi_300_: f32;
    var phi_301_: bool;
    var phi_357_: vec2<f32>;
    var phi_395_: f32;
    var phi_396_: f32;
    var phi_397_: f32;
    var phi_430_: f32;
    var phi_431_: f32;
    var phi_432_: f32;
    var phi_436_: f32;
    var phi_437_: f32;
    var phi_438_: f32;
    var phi_439_: f32;
    var phi_492_: vec2<f32>;
    var phi_514_: bool;
    var phi_539_: f32;
    var phi_540_: f32;
    var phi_541_: f32;
    var phi_542_: f32;
    var phi_543_: bool;
    var phi_544_: f32;
    var phi_545_: bool;
    var phi_601_: vec2<f32>;
    var phi_639_: f32;
    var phi_640_: f32;
    var phi_641_: f32;
    var phi_674_: f32;
    var phi_675_: f32;
    var phi_676_: f32;
    var phi_680_: f32;
    var phi_681_: f32;
    var phi_682_: f32;
    var phi_683_: f32;
    var phi_684_: f32;
    var phi_685_: bool;
    var phi_686_: f32;
    var phi_687_: bool;
    var phi_709_: bool;
    var phi_734_: f32;
    var phi_735_: f32;
    var phi_736_: f32;
    var phi_737_: f32;
    var phi_738_: bool;
    var phi_739_: f32;
    var phi_740_: bool;
    var phi_796_: vec2<f32>;
    var phi_834_: f32;
    var phi_835_: f32;
    var phi_836_: f32;
    var phi_869_: f32;
    var phi_870_: f32;
    var phi_871_: f32;
    var phi_875_: f32;
    var phi_876_: f32;
    var phi_877_: f32;
    var phi_878_: f32;
    var phi_889_: bool;
    var phi_893_: f32;
    var phi_894_: f32;
    var phi_895_: f32;
    var phi_896_: f32;

    let _e49 = (*param_11);
    let _e50 = (1f - _e49);
    let _e59 = (0.5f * _e49);
    let _e60 = ((param_12.x * _e50) + _e59);
    let _e61 = ((param_12.y * _e50) + _e59);
    let _e62 = ((param_12.z * _e50) + _e59);
    let _e63 = ((param_12.w * _e50) + _e59);
    let _e66 = (_e61 - (_e60 * _e60));
    let _e68 = (_e62 - (_e60 * _e61));
    let _e74 = hankel_HankelFactors(vec4<f32>(_e60, _e61, _e62, _e63), _e66, _e68, (((_e63 - (_e61 * _e61)) * _e66) - (_e68 * _e68)));
    local_1 = hankel_HankelFactors(_e74.moments, _e74.d22_, _e74.l32_d22_, _e74.d33_d22_);
    if ((bitcast<u32>(param_13) & 2147483647u) > 2139095040u) {
        phi_243_ = param_13;
    } else {
        if (param_13 < 0f) {
            phi_242_ = 0f;
        } else {
            if (param_13 > 1f) {
                phi_241_ = 1f;
            } else {
                phi_241_ = param_13;
            }
            let _e86 = phi_241_;
            phi_242_ = _e86;
        }
        let _e88 = phi_242_;
        phi_243_ = _e88;
    }
    let _e90 = phi_243_;
    let _e93 = local_1.moments[0u];
    let _e96 = local_1.moments[3u];
    if (_e93 == _e96) {
        let _e100 = local_1.moments[0u];
        phi_255_ = (_e100 > 0.5f);
    } else {
        phi_255_ = false;
    }
    let _e103 = phi_255_;
    if _e103 {
        let _e106 = local_1.moments[0u];
        let _e109 = local_1.moments[3u];
        if (_e106 == _e109) {
            let _e113 = local_1.moments[0u];
            phi_270_ = (_e113 > 0.5f);
        } else {
            phi_270_ = false;
        }
        let _e116 = phi_270_;
        if _e116 {
            if (_e90 > 0f) {
                let _e119 = local_1.moments;
                if ((bitcast<u32>(_e119.x) & 2147483647u) > 2139095040u) {
                    phi_297_ = _e119.x;
                } else {
                    if (_e119.x < 0f) {
                        phi_296_ = 0f;
                    } else {
                        if (_e119.x > 1f) {
                            phi_295_ = 1f;
                        } else {
                            phi_295_ = _e119.x;
                        }
                        let _e127 = phi_295_;
                        phi_296_ = _e127;
                    }
                    let _e129 = phi_296_;
                    phi_297_ = _e129;
                }
                let _e131 = phi_297_;
                phi_298_ = _e131;
                phi_299_ = false;
            } else {
                phi_298_ = f32();
                phi_299_ = true;
            }
            let _e133 = phi_298_;
            let _e135 = phi_299_;
            phi_300_ = _e133;
            phi_301_ = _e135;
        } else {
            phi_300_ = f32();
            phi_301_ = true;
        }
        let _e137 = phi_300_;
        let _e139 = phi_301_;
        if _e139 {
            let _e142 = local_1.moments[0u];
            let _e145 = local_1.moments[1u];
            let _e153 = local_1.l32_d22_;
            let _e155 = local_1.d22_;
            let _e156 = (_e153 / _e155);
            let _e157 = (_e90 - _e142);
            let _e163 = local_1.d22_;
            let _e166 = local_1.d33_d22_;
            let _e167 = (((((_e90 * _e90) - _e145) - (_e156 * _e157)) * _e163) / _e166);
            let _e169 = local_1.d22_;
            let _e172 = ((_e157 / _e169) - (_e156 * _e167));
            let _e178 = ((0.5f * _e172) / _e167);
            let _e181 = ((_e178 * _e178) - (((1f - (_e172 * _e142)) - (_e167 * _e145)) / _e167));
            if (_e181 >= 0f) {
                let _e183 = sqrt(_e181);
                phi_357_ = vec2<f32>((-(_e178) - _e183), (-(_e178) + _e183));
            } else {
                phi_357_ = vec2(bitcast<f32>((bitcast<u32>(_e181) | 2143289344u)));
            }
            let _e194 = phi_357_;
            if (_e90 <= _e194.x) {
                phi_438_ = 1f;
            } else {
                if (_e90 > _e194.y) {
                    let _e200 = local_1.moments;
                    let _e211 = (((_e200.y - (_e200.x * (_e194.x + _e194.y))) + (_e194.x * _e194.y)) / ((_e90 - _e194.x) * (_e90 - _e194.y)));
                    if ((bitcast<u32>(_e211) & 2147483647u) > 2139095040u) {
                        phi_397_ = _e211;
                    } else {
                        if (_e211 < 0f) {
                            phi_396_ = 0f;
                        } else {
                            if (_e211 > 1f) {
                                phi_395_ = 1f;
                            } else {
                                phi_395_ = _e211;
                            }
                            let _e218 = phi_395_;
                            phi_396_ = _e218;
                        }
                        let _e220 = phi_396_;
                        phi_397_ = _e220;
                    }
                    let _e222 = phi_397_;
                    phi_437_ = _e222;
                } else {
                    if (_e90 > _e194.x) {
                        let _e225 = local_1.moments;
                        let _e237 = (1f - (((_e225.y - (_e225.x * (_e90 + _e194.y))) + (_e90 * _e194.y)) / ((_e194.x - _e90) * (_e194.x - _e194.y))));
                        if ((bitcast<u32>(_e237) & 2147483647u) > 2139095040u) {
                            phi_432_ = _e237;
                        } else {
                            if (_e237 < 0f) {
                                phi_431_ = 0f;
                            } else {
                                if (_e237 > 1f) {
                                    phi_430_ = 1f;
                                } else {
                                    phi_430_ = _e237;
                                }
                                let _e244 = phi_430_;
                                phi_431_ = _e244;
                            }
                            let _e246 = phi_431_;
                            phi_432_ = _e246;
                        }
                        let _e248 = phi_432_;
                        phi_436_ = _e248;
                    } else {
                        phi_436_ = bitcast<f32>((bitcast<u32>(_e194.x) | 2143289344u));
                    }
                    let _e253 = phi_436_;
                    phi_437_ = _e253;
                }
                let _e255 = phi_437_;
                phi_438_ = _e255;
            }
            let _e257 = phi_438_;
            phi_439_ = _e257;
        } else {
            phi_439_ = _e137;
        }
        let _e259 = phi_439_;
        phi_896_ = _e259;
    } else {
        let _e262 = local_1.moments[0u];
        let _e265 = local_1.moments[1u];
        let _e273 = local_1.l32_d22_;
        let _e275 = local_1.d22_;
        let _e276 = (_e273 / _e275);
        let _e277 = (_e90 - _e262);
        let _e283 = local_1.d22_;
        let _e286 = local_1.d33_d22_;
        let _e287 = (((((_e90 * _e90) - _e265) - (_e276 * _e277)) * _e283) / _e286);
        let _e289 = local_1.d22_;
        let _e292 = ((_e277 / _e289) - (_e276 * _e287));
        let _e298 = ((0.5f * _e292) / _e287);
        let _e301 = ((_e298 * _e298) - (((1f - (_e292 * _e262)) - (_e287 * _e265)) / _e287));
        if (_e301 >= 0f) {
            let _e303 = sqrt(_e301);
            phi_492_ = vec2<f32>((-(_e298) - _e303), (-(_e298) + _e303));
        } else {
            phi_492_ = vec2(bitcast<f32>((bitcast<u32>(_e301) | 2143289344u)));
        }
        let _e314 = phi_492_;
        if (_e314.x >= 0f) {
            if (_e314.y <= 1f) {
                let _e321 = local_1.moments[0u];
                let _e324 = local_1.moments[3u];
                if (_e321 == _e324) {
                    let _e328 = local_1.moments[0u];
                    phi_514_ = (_e328 > 0.5f);
                } else {
                    phi_514_ = false;
                }
                let _e331 = phi_514_;
                if _e331 {
                    if (_e90 > 0f) {
                        let _e334 = local_1.moments;
                        if ((bitcast<u32>(_e334.x) & 2147483647u) > 2139095040u) {
                            phi_541_ = _e334.x;
                        } else {
                            if (_e334.x < 0f) {
                                phi_540_ = 0f;
                            } else {
                                if (_e334.x > 1f) {
                                    phi_539_ = 1f;
                                } else {
                                    phi_539_ = _e334.x;
                                }
                                let _e342 = phi_539_;
                                phi_540_ = _e342;
                            }
                            let _e344 = phi_540_;
                            phi_541_ = _e344;
                        }
                        let _e346 = phi_541_;
                        phi_542_ = _e346;
                        phi_543_ = false;
                    } else {
                        phi_542_ = f32();
                        phi_543_ = true;
                    }
                    let _e348 = phi_542_;
                    let _e350 = phi_543_;
                    phi_544_ = _e348;
                    phi_545_ = _e350;
                } else {
                    phi_544_ = f32();
                    phi_545_ = true;
                }
                let _e352 = phi_544_;
                let _e354 = phi_545_;
                if _e354 {
                    let _e357 = local_1.moments[0u];
                    let _e360 = local_1.moments[1u];
                    let _e368 = local_1.l32_d22_;
                    let _e370 = local_1.d22_;
                    let _e371 = (_e368 / _e370);
                    let _e372 = (_e90 - _e357);
                    let _e378 = local_1.d22_;
                    let _e381 = local_1.d33_d22_;
                    let _e382 = (((((_e90 * _e90) - _e360) - (_e371 * _e372)) * _e378) / _e381);
                    let _e384 = local_1.d22_;
                    let _e387 = ((_e372 / _e384) - (_e371 * _e382));
                    let _e393 = ((0.5f * _e387) / _e382);
                    let _e396 = ((_e393 * _e393) - (((1f - (_e387 * _e357)) - (_e382 * _e360)) / _e382));
                    if (_e396 >= 0f) {
                        let _e398 = sqrt(_e396);
                        phi_601_ = vec2<f32>((-(_e393) - _e398), (-(_e393) + _e398));
                    } else {
                        phi_601_ = vec2(bitcast<f32>((bitcast<u32>(_e396) | 2143289344u)));
                    }
                    let _e409 = phi_601_;
                    if (_e90 <= _e409.x) {
                        phi_682_ = 1f;
                    } else {
                        if (_e90 > _e409.y) {
                            let _e415 = local_1.moments;
                            let _e426 = (((_e415.y - (_e415.x * (_e409.x + _e409.y))) + (_e409.x * _e409.y)) / ((_e90 - _e409.x) * (_e90 - _e409.y)));
                            if ((bitcast<u32>(_e426) & 2147483647u) > 2139095040u) {
                                phi_641_ = _e426;
                            } else {
                                if (_e426 < 0f) {
                                    phi_640_ = 0f;
                                } else {
                                    if (_e426 > 1f) {
                                        phi_639_ = 1f;
                                    } else {
                                        phi_639_ = _e426;
                                    }
                                    let _e433 = phi_639_;
                                    phi_640_ = _e433;
                                }
                                let _e435 = phi_640_;
                                phi_641_ = _e435;
                            }
                            let _e437 = phi_641_;
                            phi_681_ = _e437;
                        } else {
                            if (_e90 > _e409.x) {
                                let _e440 = local_1.moments;
                                let _e452 = (1f - (((_e440.y - (_e440.x * (_e90 + _e409.y))) + (_e90 * _e409.y)) / ((_e409.x - _e90) * (_e409.x - _e409.y))));
                                if ((bitcast<u32>(_e452) & 2147483647u) > 2139095040u) {
                                    phi_676_ = _e452;
                                } else {
                                    if (_e452 < 0f) {
                                        phi_675_ = 0f;
                                    } else {
                                        if (_e452 > 1f) {
                                            phi_674_ = 1f;
                                        } else {
                                            phi_674_ = _e452;
                                        }
                                        let _e459 = phi_674_;
                                        phi_675_ = _e459;
                                    }
                                    let _e461 = phi_675_;
                                    phi_676_ = _e461;
                                }
                                let _e463 = phi_676_;
                                phi_680_ = _e463;
                            } else {
                                phi_680_ = bitcast<f32>((bitcast<u32>(_e409.x) | 2143289344u));
                            }
                            let _e468 = phi_680_;
                            phi_681_ = _e468;
                        }
                        let _e470 = phi_681_;
                        phi_682_ = _e470;
                    }
                    let _e472 = phi_682_;
                    phi_683_ = _e472;
                } else {
                    phi_683_ = _e352;
                }
                let _e474 = phi_683_;
                phi_684_ = _e474;
                phi_685_ = false;
            } else {
                phi_684_ = f32();
                phi_685_ = true;
            }
            let _e476 = phi_684_;
            let _e478 = phi_685_;
            phi_686_ = _e476;
            phi_687_ = _e478;
        } else {
            phi_686_ = f32();
            phi_687_ = true;
        }
        let _e480 = phi_686_;
        let _e482 = phi_687_;
        if _e482 {
            if ((bitcast<u32>(_e314.x) & 2147483647u) > 2139095040u) {
                phi_894_ = _e314.x;
            } else {
                let _e486 = lt_math_hausdorff_endpoint_upper_bound((&local_1), _e90);
                let _e489 = local_1.moments[0u];
                let _e492 = local_1.moments[3u];
                if (_e489 == _e492) {
                    let _e496 = local_1.moments[0u];
                    phi_709_ = (_e496 > 0.5f);
                } else {
                    phi_709_ = false;
                }
                let _e499 = phi_709_;
                if _e499 {
                    if (_e90 > 0f) {
                        let _e502 = local_1.moments;
                        if ((bitcast<u32>(_e502.x) & 2147483647u) > 2139095040u) {
                            phi_736_ = _e502.x;
                        } else {
                            if (_e502.x < 0f) {
                                phi_735_ = 0f;
                            } else {
                                if (_e502.x > 1f) {
                                    phi_734_ = 1f;
                                } else {
                                    phi_734_ = _e502.x;
                                }
                                let _e510 = phi_734_;
                                phi_735_ = _e510;
                            }
                            let _e512 = phi_735_;
                            phi_736_ = _e512;
                        }
                        let _e514 = phi_736_;
                        phi_737_ = _e514;
                        phi_738_ = false;
                    } else {
                        phi_737_ = f32();
                        phi_738_ = true;
                    }
                    let _e516 = phi_737_;
                    let _e518 = phi_738_;
                    phi_739_ = _e516;
                    phi_740_ = _e518;
                } else {
                    phi_739_ = f32();
                    phi_740_ = true;
                }
                let _e520 = phi_739_;
                let _e522 = phi_740_;
                if _e522 {
                    let _e525 = local_1.moments[0u];
                    let _e528 = local_1.moments[1u];
                    let _e536 = local_1.l32_d22_;
                    let _e538 = local_1.d22_;
                    let _e539 = (_e536 / _e538);
                    let _e540 = (_e90 - _e525);
                    let _e546 = local_1.d22_;
                    let _e549 = local_1.d33_d22_;
                    let _e550 = (((((_e90 * _e90) - _e528) - (_e539 * _e540)) * _e546) / _e549);
                    let _e552 = local_1.d22_;
                    let _e555 = ((_e540 / _e552) - (_e539 * _e550));
                    let _e561 = ((0.5f * _e555) / _e550);
                    let _e564 = ((_e561 * _e561) - (((1f - (_e555 * _e525)) - (_e550 * _e528)) / _e550));
                    if (_e564 >= 0f) {
                        let _e566 = sqrt(_e564);
                        phi_796_ = vec2<f32>((-(_e561) - _e566), (-(_e561) + _e566));
                    } else {
                        phi_796_ = vec2(bitcast<f32>((bitcast<u32>(_e564) | 2143289344u)));
                    }
                    let _e577 = phi_796_;
                    if (_e90 <= _e577.x) {
                        phi_877_ = 1f;
                    } else {
                        if (_e90 > _e577.y) {
                            let _e583 = local_1.moments;
                            let _e594 = (((_e583.y - (_e583.x * (_e577.x + _e577.y))) + (_e577.x * _e577.y)) / ((_e90 - _e577.x) * (_e90 - _e577.y)));
                            if ((bitcast<u32>(_e594) & 2147483647u) > 2139095040u) {
                                phi_836_ = _e594;
                            } else {
                                if (_e594 < 0f) {
                                    phi_835_ = 0f;
                                } else {
                                    if (_e594 > 1f) {
                                        phi_834_ = 1f;
                                    } else {
                                        phi_834_ = _e594;
                                    }
                                    let _e601 = phi_834_;
                                    phi_835_ = _e601;
                                }
                                let _e603 = phi_835_;
                                phi_836_ = _e603;
                            }
                            let _e605 = phi_836_;
                            phi_876_ = _e605;
                        } else {
                            if (_e90 > _e577.x) {
                                let _e608 = local_1.moments;
                                let _e620 = (1f - (((_e608.y - (_e608.x * (_e90 + _e577.y))) + (_e90 * _e577.y)) / ((_e577.x - _e90) * (_e577.x - _e577.y))));
                                if ((bitcast<u32>(_e620) & 2147483647u) > 2139095040u) {
                                    phi_871_ = _e620;
                                } else {
                                    if (_e620 < 0f) {
                                        phi_870_ = 0f;
                                    } else {
                                        if (_e620 > 1f) {
                                            phi_869_ = 1f;
                                        } else {
                                            phi_869_ = _e620;
                                        }
                                        let _e627 = phi_869_;
                                        phi_870_ = _e627;
                                    }
                                    let _e629 = phi_870_;
                                    phi_871_ = _e629;
                                }
                                let _e631 = phi_871_;
                                phi_875_ = _e631;
                            } else {
                                phi_875_ = bitcast<f32>((bitcast<u32>(_e577.x) | 2143289344u));
                            }
                            let _e636 = phi_875_;
                            phi_876_ = _e636;
                        }
                        let _e638 = phi_876_;
                        phi_877_ = _e638;
                    }
                    let _e640 = phi_877_;
                    phi_878_ = _e640;
                } else {
                    phi_878_ = _e520;
                }
                let _e642 = phi_878_;
                if ((bitcast<u32>(_e642) & 2147483647u) > 2139095040u) {
                    phi_889_ = true;
                } else {
                    let _e646 = (_e642 < _e486);
                    if _e646 {
                    }
                    phi_889_ = _e646;
                }
                let _e648 = phi_889_;
                if _e648 {
                    phi_893_ = _e642;
                } else {
                    phi_893_ = _e486;
                }
                let _e650 = phi_893_;
                phi_894_ = _e650;
            }
            let _e652 = phi_894_;
            phi_895_ = _e652;
        } else {
            phi_895_ = _e480;
        }
        let _e654 = phi_895_;
        phi_896_ = _e654;
    }
    let _e656 = phi_896_;
    return _e656;
}

fn function_() {
    var local_2: f32;
    var phi_1117_: bool;
    var phi_1118_: bool;
    var phi_1119_: bool;
    var phi_1120_: bool;
    var phi_1124_: bool;
    var phi_1194_: bool;
    var phi_1195_: bool;
    var phi_1206_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1207_: bool;
    var phi_1208_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1209_: bool;
    var phi_1216_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1220_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1240_: lt_math_LightPoint;
    var phi_1243_: u32;
    var phi_1245_: lt_math_LevelPoint;
    var phi_1331_: bool;
    var phi_1340_: bool;
    var phi_1349_: bool;
    var phi_1350_: bool;
    var phi_1351_: bool;
    var phi_1352_: bool;
    var phi_1353_: bool;
    var phi_1354_: bool;
    var phi_1355_: bool;
    var phi_1359_: bool;
    var phi_1386_: bool;
    var phi_1387_: bool;
    var phi_1388_: bool;
    var phi_1389_: bool;
    var phi_1390_: bool;
    var phi_1391_: bool;
    var phi_1392_: bool;
    var phi_1393_: bool;
    var phi_1397_: bool;
    var phi_1406_: lt_math_LightPoint;
    var phi_1407_: u32;
    var phi_1408_: lt_math_LevelPoint;
    var phi_1409_: bool;
    var phi_1241_: lt_math_LightPoint;
    var phi_1244_: u32;
    var phi_1246_: lt_math_LevelPoint;
    var phi_1410_: bool;
    var local_3: lt_math_LevelPoint;
    var local_4: lt_math_LevelPoint;
    var phi_1450_: bool;
    var phi_1451_: bool;
    var phi_1452_: bool;
    var phi_1453_: bool;
    var phi_1457_: bool;
    var phi_1539_: f32;
    var phi_1655_: f32;
    var phi_1656_: f32;
    var phi_1659_: f32;
    var phi_1688_: f32;
    var phi_1693_: f32;
    var phi_1694_: bool;
    var phi_1695_: f32;
    var phi_1696_: bool;
    var phi_1700_: f32;
    var phi_1720_: f32;
    var phi_1725_: f32;
    var phi_1726_: bool;
    var phi_1727_: f32;
    var phi_1728_: bool;
    var phi_1732_: f32;
    var local_5: lt_math_LevelPoint;
    var phi_1781_: i32;
    var phi_1786_: i32;
    var phi_1791_: i32;
    var phi_1796_: i32;
    var phi_1805_: i32;
    var phi_1810_: i32;
    var phi_1815_: i32;
    var phi_1820_: i32;
    var phi_1915_: bool;
    var phi_1923_: bool;
    var phi_1935_: bool;
    var phi_1936_: bool;
    var phi_1940_: f32;
    var phi_1946_: f32;
    var phi_1948_: evaluate_Verdict;
    var phi_1953_: evaluate_Verdict;
    var phi_1954_: evaluate_Verdict;
    var phi_1958_: bool;
    var phi_1959_: u32;
    var phi_1970_: u32;

    let _e46 = id_1;
    let _e47 = local_6;
    let _e52 = arrayLength((&map.member));
    let _e57 = arrayLength((&levels.member));
    let _e60 = p.member.size[0u];
    let _e62 = p.member.size[1u];
    let _e63 = lt_shaders_entry_pixel_index(_e46, _e60, _e62);
    if (bitcast<i32>(_e63.root) != 0i) {
        let _e70 = p.member.level_count;
        let _e74 = samples.member[_e63.first_primitive].normal[0u];
        let _e76 = global[0u];
        if (_e74 == _e76) {
            let _e79 = samples.member[_e63.first_primitive].normal[1u];
            let _e81 = global[1u];
            if (_e79 == _e81) {
                let _e84 = samples.member[_e63.first_primitive].normal[2u];
                let _e86 = global[2u];
                phi_1117_ = (_e84 == _e86);
                phi_1118_ = false;
            } else {
                phi_1117_ = bool();
                phi_1118_ = true;
            }
            let _e89 = phi_1117_;
            let _e91 = phi_1118_;
            phi_1119_ = _e89;
            phi_1120_ = _e91;
        } else {
            phi_1119_ = bool();
            phi_1120_ = true;
        }
        let _e93 = phi_1119_;
        let _e95 = phi_1120_;
        if _e95 {
            phi_1124_ = false;
        } else {
            phi_1124_ = _e93;
        }
        let _e97 = phi_1124_;
        if !(_e97) {
            let _e100 = samples.member[_e63.first_primitive].position;
            let _e102 = p.member.light.place;
            let _e108 = p.member.light.place[3u];
            let _e115 = (_e102.x - (_e100.x * _e108));
            let _e116 = (_e102.y - (_e100.y * _e108));
            let _e117 = (_e102.z - (_e100.z * _e108));
            let _e119 = samples.member[_e63.first_primitive].normal;
            if ((((_e119.x * _e115) + (_e119.y * _e116)) + (_e119.z * _e117)) > 0f) {
                let _e133 = (((_e115 * _e115) + (_e116 * _e116)) + (_e117 * _e117));
                let _e135 = p.member.light.axis;
                let _e147 = p.member.light.place[3u];
                if (_e147 == 0f) {
                    phi_1195_ = true;
                } else {
                    let _e150 = p.member.light.range_squared;
                    if (_e133 <= _e150) {
                        let _e153 = p.member.light.cos_outer;
                        phi_1194_ = (-((((_e115 * _e135.x) + (_e116 * _e135.y)) + (_e117 * _e135.z))) >= (_e153 * sqrt(_e133)));
                    } else {
                        phi_1194_ = false;
                    }
                    let _e158 = phi_1194_;
                    phi_1195_ = _e158;
                }
                let _e160 = phi_1195_;
                if _e160 {
                    let _e162 = samples.member[_e63.first_primitive].flags;
                    let _e170 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e176 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e170.unnamed.visibility, false), _e170.unnamed_1);
                    phi_1206_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e176.unnamed, ((_e162 & 1u) == 0u));
                    phi_1207_ = false;
                } else {
                    phi_1206_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_1207_ = true;
                }
                let _e181 = phi_1206_;
                let _e183 = phi_1207_;
                phi_1208_ = _e181;
                phi_1209_ = _e183;
            } else {
                phi_1208_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_1209_ = true;
            }
            let _e185 = phi_1208_;
            let _e187 = phi_1209_;
            if _e187 {
                let _e193 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e199 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e193.unnamed.visibility, false), _e193.unnamed_1);
                phi_1216_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e199.unnamed, true);
            } else {
                phi_1216_ = _e185;
            }
            let _e204 = phi_1216_;
            phi_1220_ = _e204;
        } else {
            let _e210 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e216 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e210.unnamed.visibility, false), _e210.unnamed_1);
            phi_1220_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e216.unnamed, true);
        }
        let _e221 = phi_1220_;
        if _e221.unnamed_1 {
            phi_1954_ = evaluate_Verdict(_e221.unnamed.visibility, _e221.unnamed.is_doubted);
        } else {
            let _e229 = samples.member[_e63.first_primitive].position;
            let _e231 = p.member.map_size;
            let _e233 = (0.5f / f32(_e231));
            let _e240 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e247 = lt_math_LightPoint(vec2<f32>(_e240.uv.x, 0f), _e240.depth, _e240.is_inside);
            let _e251 = lt_math_LightPoint(_e247.uv, 0f, _e247.is_inside);
            phi_1240_ = lt_math_LightPoint();
            phi_1243_ = 0u;
            phi_1245_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e251.uv, _e251.depth, false));
            loop {
                let _e258 = phi_1240_;
                let _e260 = phi_1243_;
                let _e262 = phi_1245_;
                local_3 = _e262;
                local_4 = _e262;
                local_5 = _e262;
                if (_e260 < _e70) {
                    if _e262.point.is_inside {
                        phi_1406_ = lt_math_LightPoint();
                        phi_1407_ = u32();
                        phi_1408_ = lt_math_LevelPoint();
                        phi_1409_ = false;
                    } else {
                        if (_e260 < _e57) {
                        } else {
                            return;
                        }
                        let _e273 = levels.member[(0u + _e260)].row_w;
                        let _e284 = ((((_e273.x * _e229.x) + (_e273.y * _e229.y)) + (_e273.z * _e229.z)) + (_e273.w * 1f));
                        let _e286 = levels.member[(0u + _e260)].row_x;
                        let _e298 = (((((_e286.x * _e229.x) + (_e286.y * _e229.y)) + (_e286.z * _e229.z)) + (_e286.w * 1f)) / _e284);
                        let _e300 = levels.member[(0u + _e260)].row_y;
                        let _e312 = (((((_e300.x * _e229.x) + (_e300.y * _e229.y)) + (_e300.z * _e229.z)) + (_e300.w * 1f)) / _e284);
                        let _e314 = levels.member[(0u + _e260)].row_z;
                        let _e325 = ((((_e314.x * _e229.x) + (_e314.y * _e229.y)) + (_e314.z * _e229.z)) + (_e314.w * 1f));
                        if (_e284 > 0f) {
                            if (_e298 >= 0f) {
                                phi_1331_ = (_e298 <= 1f);
                            } else {
                                phi_1331_ = false;
                            }
                            let _e330 = phi_1331_;
                            if _e330 {
                                if (_e312 >= 0f) {
                                    phi_1340_ = (_e312 <= 1f);
                                } else {
                                    phi_1340_ = false;
                                }
                                let _e334 = phi_1340_;
                                if _e334 {
                                    if (_e325 >= 0f) {
                                        phi_1349_ = (_e325 <= 1f);
                                    } else {
                                        phi_1349_ = false;
                                    }
                                    let _e338 = phi_1349_;
                                    phi_1350_ = _e338;
                                    phi_1351_ = false;
                                } else {
                                    phi_1350_ = bool();
                                    phi_1351_ = true;
                                }
                                let _e340 = phi_1350_;
                                let _e342 = phi_1351_;
                                phi_1352_ = _e340;
                                phi_1353_ = _e342;
                            } else {
                                phi_1352_ = bool();
                                phi_1353_ = true;
                            }
                            let _e344 = phi_1352_;
                            let _e346 = phi_1353_;
                            phi_1354_ = _e344;
                            phi_1355_ = _e346;
                        } else {
                            phi_1354_ = bool();
                            phi_1355_ = true;
                        }
                        let _e348 = phi_1354_;
                        let _e350 = phi_1355_;
                        if _e350 {
                            phi_1359_ = false;
                        } else {
                            phi_1359_ = _e348;
                        }
                        let _e352 = phi_1359_;
                        if _e352 {
                            if (_e298 >= _e233) {
                                if (_e298 <= (1f - _e233)) {
                                    if (_e312 >= _e233) {
                                        phi_1386_ = (_e312 <= (1f - _e233));
                                        phi_1387_ = false;
                                    } else {
                                        phi_1386_ = bool();
                                        phi_1387_ = true;
                                    }
                                    let _e360 = phi_1386_;
                                    let _e362 = phi_1387_;
                                    phi_1388_ = _e360;
                                    phi_1389_ = _e362;
                                } else {
                                    phi_1388_ = bool();
                                    phi_1389_ = true;
                                }
                                let _e364 = phi_1388_;
                                let _e366 = phi_1389_;
                                phi_1390_ = _e364;
                                phi_1391_ = _e366;
                            } else {
                                phi_1390_ = bool();
                                phi_1391_ = true;
                            }
                            let _e368 = phi_1390_;
                            let _e370 = phi_1391_;
                            phi_1392_ = _e368;
                            phi_1393_ = _e370;
                        } else {
                            phi_1392_ = bool();
                            phi_1393_ = true;
                        }
                        let _e372 = phi_1392_;
                        let _e374 = phi_1393_;
                        if _e374 {
                            phi_1397_ = false;
                        } else {
                            phi_1397_ = _e372;
                        }
                        let _e376 = phi_1397_;
                        let _e383 = lt_math_LightPoint(vec2<f32>(_e298, _e258.uv.y), _e258.depth, _e258.is_inside);
                        let _e390 = lt_math_LightPoint(vec2<f32>(_e383.uv.x, _e312), _e383.depth, _e383.is_inside);
                        let _e394 = lt_math_LightPoint(_e390.uv, _e325, _e390.is_inside);
                        let _e398 = lt_math_LightPoint(_e394.uv, _e394.depth, _e376);
                        phi_1406_ = _e398;
                        phi_1407_ = (_e260 + 1u);
                        phi_1408_ = lt_math_LevelPoint(_e260, _e398);
                        phi_1409_ = true;
                    }
                    let _e402 = phi_1406_;
                    let _e404 = phi_1407_;
                    let _e406 = phi_1408_;
                    let _e408 = phi_1409_;
                    phi_1241_ = _e402;
                    phi_1244_ = _e404;
                    phi_1246_ = _e406;
                    phi_1410_ = _e408;
                } else {
                    phi_1241_ = lt_math_LightPoint();
                    phi_1244_ = u32();
                    phi_1246_ = lt_math_LevelPoint();
                    phi_1410_ = false;
                }
                let _e410 = phi_1241_;
                let _e412 = phi_1244_;
                let _e414 = phi_1246_;
                let _e416 = phi_1410_;
                continue;
                continuing {
                    phi_1240_ = _e410;
                    phi_1243_ = _e412;
                    phi_1245_ = _e414;
                    break if !(_e416);
                }
            }
            let _e419 = local_3;
            if _e419.point.is_inside {
                if (0f > 0f) {
                    let _e425 = local_4;
                    if (_e425.level < _e57) {
                    } else {
                        return;
                    }
                    let _e430 = levels.member[(0u + _e425.level)];
                    let _e436 = global[0u];
                    if (_e430.row_w.x == _e436) {
                        let _e439 = global[1u];
                        if (_e430.row_w.y == _e439) {
                            let _e442 = global[2u];
                            phi_1450_ = (_e430.row_w.z == _e442);
                            phi_1451_ = false;
                        } else {
                            phi_1450_ = bool();
                            phi_1451_ = true;
                        }
                        let _e445 = phi_1450_;
                        let _e447 = phi_1451_;
                        phi_1452_ = _e445;
                        phi_1453_ = _e447;
                    } else {
                        phi_1452_ = bool();
                        phi_1453_ = true;
                    }
                    let _e449 = phi_1452_;
                    let _e451 = phi_1453_;
                    if _e451 {
                        phi_1457_ = false;
                    } else {
                        phi_1457_ = _e449;
                    }
                    let _e453 = phi_1457_;
                    if _e453 {
                        let _e455 = samples.member[_e63.first_primitive].normal;
                        let _e457 = p.member.map_size;
                        let _e527 = ((abs(((((_e430.row_x.x * _e455.x) + (_e430.row_x.y * _e455.y)) + (_e430.row_x.z * _e455.z)) / (((_e430.row_x.x * _e430.row_x.x) + (_e430.row_x.y * _e430.row_x.y)) + (_e430.row_x.z * _e430.row_x.z)))) + abs(((((_e430.row_y.x * _e455.x) + (_e430.row_y.y * _e455.y)) + (_e430.row_y.z * _e455.z)) / (((_e430.row_y.x * _e430.row_y.x) + (_e430.row_y.y * _e430.row_y.y)) + (_e430.row_y.z * _e430.row_y.z))))) / (abs(((((_e430.row_z.x * _e455.x) + (_e430.row_z.y * _e455.y)) + (_e430.row_z.z * _e455.z)) / (((_e430.row_z.x * _e430.row_z.x) + (_e430.row_z.y * _e430.row_z.y)) + (_e430.row_z.z * _e430.row_z.z)))) * f32(_e457)));
                        if (_e527 < 0.002f) {
                            phi_1539_ = _e527;
                        } else {
                            phi_1539_ = 0.002f;
                        }
                        let _e530 = phi_1539_;
                        phi_1656_ = _e530;
                    } else {
                        let _e532 = p.member.map_size;
                        let _e538 = samples.member[_e63.first_primitive].position;
                        let _e549 = ((((_e430.row_w.x * _e538.x) + (_e430.row_w.y * _e538.y)) + (_e430.row_w.z * _e538.z)) + _e430.row_w.w);
                        let _e562 = ((_e430.row_x.x - (_e430.row_w.x * _e419.point.uv.x)) / _e549);
                        let _e563 = ((_e430.row_x.y - (_e430.row_w.y * _e419.point.uv.x)) / _e549);
                        let _e564 = ((_e430.row_x.z - (_e430.row_w.z * _e419.point.uv.x)) / _e549);
                        let _e577 = ((_e430.row_y.x - (_e430.row_w.x * _e419.point.uv.y)) / _e549);
                        let _e578 = ((_e430.row_y.y - (_e430.row_w.y * _e419.point.uv.y)) / _e549);
                        let _e579 = ((_e430.row_y.z - (_e430.row_w.z * _e419.point.uv.y)) / _e549);
                        let _e585 = samples.member[_e63.first_primitive].normal;
                        let _e590 = ((_e578 * _e585.z) - (_e585.y * _e579));
                        let _e595 = ((_e579 * _e585.x) - (_e585.z * _e577));
                        let _e600 = ((_e577 * _e585.y) - (_e585.x * _e578));
                        let _e602 = samples.member[_e63.first_primitive].normal;
                        let _e607 = ((_e563 * _e602.z) - (_e602.y * _e564));
                        let _e612 = ((_e564 * _e602.x) - (_e602.z * _e562));
                        let _e617 = ((_e562 * _e602.y) - (_e602.x * _e563));
                        let _e644 = ((abs(((((_e430.row_z.x * _e590) + (_e430.row_z.y * _e595)) + (_e430.row_z.z * _e600)) / (((_e562 * _e590) + (_e563 * _e595)) + (_e564 * _e600)))) + abs(((((_e430.row_z.x * _e607) + (_e430.row_z.y * _e612)) + (_e430.row_z.z * _e617)) / (((_e577 * _e607) + (_e578 * _e612)) + (_e579 * _e617))))) / f32(_e532));
                        if (_e644 < 0.002f) {
                            phi_1655_ = _e644;
                        } else {
                            phi_1655_ = 0.002f;
                        }
                        let _e647 = phi_1655_;
                        phi_1656_ = _e647;
                    }
                    let _e649 = phi_1656_;
                    phi_1659_ = (_e419.point.depth - (0f * _e649));
                } else {
                    phi_1659_ = _e419.point.depth;
                }
                let _e653 = phi_1659_;
                let _e659 = p.member.map_size;
                let _e660 = f32(_e659);
                let _e663 = ((_e419.point.uv.x * _e660) - 0.5f);
                let _e664 = ((_e419.point.uv.y * _e660) - 0.5f);
                if (_e663 > -8388608f) {
                    let _e676 = f32(select(0i, select(select(i32(_e663), i32(-2147483648), (_e663 < bitcast<f32>(3472883712u))), 2147483647i, (_e663 > bitcast<f32>(1325400063u))), (_e663 == _e663)));
                    if (_e676 > _e663) {
                        phi_1688_ = 1f;
                    } else {
                        phi_1688_ = 0f;
                    }
                    let _e679 = phi_1688_;
                    if (_e663 < 8388608f) {
                        phi_1693_ = (_e676 - _e679);
                        phi_1694_ = false;
                    } else {
                        phi_1693_ = f32();
                        phi_1694_ = true;
                    }
                    let _e682 = phi_1693_;
                    let _e684 = phi_1694_;
                    phi_1695_ = _e682;
                    phi_1696_ = _e684;
                } else {
                    phi_1695_ = f32();
                    phi_1696_ = true;
                }
                let _e686 = phi_1695_;
                let _e688 = phi_1696_;
                if _e688 {
                    phi_1700_ = _e663;
                } else {
                    phi_1700_ = _e686;
                }
                let _e690 = phi_1700_;
                if (_e664 > -8388608f) {
                    let _e702 = f32(select(0i, select(select(i32(_e664), i32(-2147483648), (_e664 < bitcast<f32>(3472883712u))), 2147483647i, (_e664 > bitcast<f32>(1325400063u))), (_e664 == _e664)));
                    if (_e702 > _e664) {
                        phi_1720_ = 1f;
                    } else {
                        phi_1720_ = 0f;
                    }
                    let _e705 = phi_1720_;
                    if (_e664 < 8388608f) {
                        phi_1725_ = (_e702 - _e705);
                        phi_1726_ = false;
                    } else {
                        phi_1725_ = f32();
                        phi_1726_ = true;
                    }
                    let _e708 = phi_1725_;
                    let _e710 = phi_1726_;
                    phi_1727_ = _e708;
                    phi_1728_ = _e710;
                } else {
                    phi_1727_ = f32();
                    phi_1728_ = true;
                }
                let _e712 = phi_1727_;
                let _e714 = phi_1728_;
                if _e714 {
                    phi_1732_ = _e664;
                } else {
                    phi_1732_ = _e712;
                }
                let _e716 = phi_1732_;
                let _e717 = (_e663 - _e690);
                let _e718 = (_e664 - _e716);
                let _e727 = select(0i, select(select(i32(_e690), i32(-2147483648), (_e690 < bitcast<f32>(3472883712u))), 2147483647i, (_e690 > bitcast<f32>(1325400063u))), (_e690 == _e690));
                let _e736 = select(0i, select(select(i32(_e716), i32(-2147483648), (_e716 < bitcast<f32>(3472883712u))), 2147483647i, (_e716 > bitcast<f32>(1325400063u))), (_e716 == _e716));
                let _e739 = ((1f - _e717) * (1f - _e718));
                let _e741 = (_e717 * (1f - _e718));
                let _e743 = ((1f - _e717) * _e718);
                let _e744 = (_e717 * _e718);
                let _e746 = p.member.test;
                let _e747 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e746);
                let _e749 = p.member.map_size;
                let _e751 = local_5;
                local_2 = _e747;
                let _e754 = ((_e751.level * _e749) * _e749);
                let _e756 = (bitcast<i32>(_e749) - 1i);
                if (_e727 > 0i) {
                    phi_1781_ = _e727;
                } else {
                    phi_1781_ = 0i;
                }
                let _e759 = phi_1781_;
                if (_e736 > 0i) {
                    phi_1786_ = _e736;
                } else {
                    phi_1786_ = 0i;
                }
                let _e762 = phi_1786_;
                if (_e759 < _e756) {
                    phi_1791_ = _e759;
                } else {
                    phi_1791_ = _e756;
                }
                let _e765 = phi_1791_;
                if (_e762 < _e756) {
                    phi_1796_ = _e762;
                } else {
                    phi_1796_ = _e756;
                }
                let _e768 = phi_1796_;
                let _e769 = bitcast<u32>(_e765);
                let _e771 = (_e727 + 1i);
                let _e772 = (_e736 + 1i);
                if (_e771 > 0i) {
                    phi_1805_ = _e771;
                } else {
                    phi_1805_ = 0i;
                }
                let _e775 = phi_1805_;
                if (_e772 > 0i) {
                    phi_1810_ = _e772;
                } else {
                    phi_1810_ = 0i;
                }
                let _e778 = phi_1810_;
                if (_e775 < _e756) {
                    phi_1815_ = _e775;
                } else {
                    phi_1815_ = _e756;
                }
                let _e781 = phi_1815_;
                if (_e778 < _e756) {
                    phi_1820_ = _e778;
                } else {
                    phi_1820_ = _e756;
                }
                let _e784 = phi_1820_;
                let _e785 = bitcast<u32>(_e781);
                let _e787 = (bitcast<u32>(_e768) * _e749);
                let _e788 = (bitcast<u32>(_e784) * _e749);
                let _e793 = ((_e787 + _e769) + _e754);
                let _e794 = ((_e787 + _e785) + _e754);
                let _e795 = ((_e788 + _e769) + _e754);
                let _e796 = ((_e788 + _e785) + _e754);
                if (_e793 < _e52) {
                } else {
                    return;
                }
                let _e800 = map.member[(0u + _e793)];
                if (_e794 < _e52) {
                } else {
                    return;
                }
                let _e812 = map.member[(0u + _e794)];
                if (_e795 < _e52) {
                } else {
                    return;
                }
                let _e828 = map.member[(0u + _e795)];
                if (_e796 < _e52) {
                } else {
                    return;
                }
                let _e844 = map.member[(0u + _e796)];
                let _e858 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_2), vec4<f32>(((((_e800.x * _e739) + (_e812.x * _e741)) + (_e828.x * _e743)) + (_e844.x * _e744)), ((((_e800.y * _e739) + (_e812.y * _e741)) + (_e828.y * _e743)) + (_e844.y * _e744)), ((((_e800.z * _e739) + (_e812.z * _e741)) + (_e828.z * _e743)) + (_e844.z * _e744)), ((((_e800.w * _e739) + (_e812.w * _e741)) + (_e828.w * _e743)) + (_e844.w * _e744))), _e653);
                let _e860 = p.member.epsilon;
                if (_e858 <= _e860) {
                    phi_1915_ = true;
                } else {
                    phi_1915_ = (_e858 >= (1f - _e860));
                }
                let _e865 = phi_1915_;
                if ((bitcast<u32>(_e858) & 2147483647u) > 2139095040u) {
                    phi_1923_ = true;
                } else {
                    phi_1923_ = !(_e865);
                }
                let _e871 = phi_1923_;
                if _e871 {
                    if (_e858 > 0f) {
                        if (_e858 < 1f) {
                            phi_1935_ = false;
                        } else {
                            phi_1935_ = true;
                        }
                        let _e875 = phi_1935_;
                        phi_1936_ = _e875;
                    } else {
                        phi_1936_ = true;
                    }
                    let _e877 = phi_1936_;
                    if _e877 {
                        phi_1940_ = 0.5f;
                    } else {
                        phi_1940_ = _e858;
                    }
                    let _e879 = phi_1940_;
                    phi_1948_ = evaluate_Verdict(_e879, true);
                } else {
                    if (_e858 > 0.5f) {
                        phi_1946_ = 1f;
                    } else {
                        phi_1946_ = 0f;
                    }
                    let _e883 = phi_1946_;
                    phi_1948_ = evaluate_Verdict(_e883, false);
                }
                let _e886 = phi_1948_;
                phi_1953_ = evaluate_Verdict(_e886.visibility, _e886.is_doubted);
            } else {
                phi_1953_ = evaluate_Verdict(0.5f, true);
            }
            let _e892 = phi_1953_;
            phi_1954_ = _e892;
        }
        let _e894 = phi_1954_;
        visibility.member[_e63.first_primitive] = _e894.visibility;
        phi_1958_ = _e894.is_doubted;
        phi_1959_ = _e63.first_primitive;
    } else {
        phi_1958_ = false;
        phi_1959_ = 0u;
    }
    let _e899 = phi_1958_;
    let _e901 = phi_1959_;
    if (_e47 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e899 {
        let _e905 = atomicAdd((&shared_[0u]), 1u);
        phi_1970_ = _e905;
    } else {
        phi_1970_ = 0u;
    }
    let _e907 = phi_1970_;
    workgroupBarrier();
    if (_e47 == 0u) {
        let _e911 = atomicLoad((&shared_[0u]));
        let _e912 = atomicAdd((&list.member[3u]), _e911);
        atomicStore((&shared_[1u]), _e912);
    }
    workgroupBarrier();
    if _e899 {
        let _e915 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e915) + _e907)]), _e901);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_msm_hausdorff_prefiltered_levels_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_6 = local;
    function_();
}
