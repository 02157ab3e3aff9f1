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

struct type_37 {
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

struct type_41 {
    member: abi_ShadowParams,
}

struct lt_math_LightPoint {
    uv: vec2<f32>,
    depth: f32,
    is_inside: bool,
}

struct type_47 {
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

struct type_55 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
var<private> local_6: u32;
@group(0) @binding(1) 
var<storage> samples: type_10;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(0) 
var<uniform> p: type_41;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_18;
@group(0) @binding(4) 
var<storage, read_write> list: type_55;
@group(0) @binding(5) 
var<storage> levels: type_47;
@group(0) @binding(2) 
var<storage> map: type_37;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_173_: lt_bvh_traverse_Tree;
    var phi_174_: bool;
    var phi_175_: lt_bvh_traverse_Tree;
    var phi_176_: bool;
    var phi_181_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_173_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_174_ = false;
        } else {
            phi_173_ = lt_bvh_traverse_Tree();
            phi_174_ = true;
        }
        let _e58 = phi_173_;
        let _e60 = phi_174_;
        phi_175_ = _e58;
        phi_176_ = _e60;
    } else {
        phi_175_ = lt_bvh_traverse_Tree();
        phi_176_ = true;
    }
    let _e62 = phi_175_;
    let _e64 = phi_176_;
    if _e64 {
        phi_181_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_181_ = _e62;
    }
    let _e69 = phi_181_;
    return lt_bvh_traverse_Tree(_e69.root, _e69.first_primitive);
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn lt_math_hausdorff_cubic_mass(param_4: vec4<f32>, param_5: f32, param_6: f32, param_7: f32, param_8: f32) -> f32 {
    return ((((param_4.z - (((param_6 + param_7) + param_8) * param_4.y)) + ((((param_6 * param_7) + (param_6 * param_8)) + (param_7 * param_8)) * param_4.x)) - ((param_6 * param_7) * param_8)) / (((param_5 - param_6) * (param_5 - param_7)) * (param_5 - param_8)));
}

fn lt_math_hausdorff_endpoint_upper_bound(param_9: ptr<function, hankel_HankelFactors>, param_10: f32) -> f32 {
    var phi_951_: f32;
    var phi_952_: f32;
    var phi_953_: f32;
    var phi_980_: f32;
    var phi_981_: f32;
    var phi_982_: f32;
    var phi_983_: f32;
    var phi_984_: bool;
    var phi_985_: f32;
    var phi_986_: bool;
    var phi_1014_: f32;
    var phi_1015_: f32;
    var phi_1016_: f32;
    var phi_1017_: f32;
    var phi_1018_: bool;
    var phi_1019_: f32;
    var phi_1020_: bool;
    var phi_1027_: f32;
    var phi_1028_: f32;
    var phi_1029_: f32;
    var phi_1030_: f32;

    let _e48 = (*param_9).moments;
    if (param_10 < 0.0001f) {
        phi_1030_ = 1f;
    } else {
        let _e57 = ((_e48.z - ((1f + param_10) * _e48.y)) + (param_10 * _e48.x));
        let _e66 = (((_e48.w - ((1f + param_10) * _e48.z)) + (param_10 * _e48.y)) / _e57);
        if (abs(_e57) <= 0.00000047683716f) {
            let _e80 = (1f - (((_e48.y - (_e48.x * (param_10 + 1f))) + (param_10 * 1f)) / ((0f - param_10) * (0f - 1f))));
            if ((bitcast<u32>(_e80) & 2147483647u) > 2139095040u) {
                phi_953_ = _e80;
            } else {
                if (_e80 < 0f) {
                    phi_952_ = 0f;
                } else {
                    if (_e80 > 1f) {
                        phi_951_ = 1f;
                    } else {
                        phi_951_ = _e80;
                    }
                    let _e87 = phi_951_;
                    phi_952_ = _e87;
                }
                let _e89 = phi_952_;
                phi_953_ = _e89;
            }
            let _e91 = phi_953_;
            phi_1029_ = _e91;
        } else {
            if (_e66 > 0f) {
                if (_e66 < param_10) {
                    let _e94 = lt_math_hausdorff_cubic_mass(_e48, 0f, _e66, param_10, 1f);
                    let _e96 = lt_math_hausdorff_cubic_mass(_e48, _e66, 0f, param_10, 1f);
                    let _e97 = ((1f - _e94) - _e96);
                    if ((bitcast<u32>(_e97) & 2147483647u) > 2139095040u) {
                        phi_982_ = _e97;
                    } else {
                        if (_e97 < 0f) {
                            phi_981_ = 0f;
                        } else {
                            if (_e97 > 1f) {
                                phi_980_ = 1f;
                            } else {
                                phi_980_ = _e97;
                            }
                            let _e104 = phi_980_;
                            phi_981_ = _e104;
                        }
                        let _e106 = phi_981_;
                        phi_982_ = _e106;
                    }
                    let _e108 = phi_982_;
                    phi_983_ = _e108;
                    phi_984_ = false;
                } else {
                    phi_983_ = f32();
                    phi_984_ = true;
                }
                let _e110 = phi_983_;
                let _e112 = phi_984_;
                phi_985_ = _e110;
                phi_986_ = _e112;
            } else {
                phi_985_ = f32();
                phi_986_ = true;
            }
            let _e114 = phi_985_;
            let _e116 = phi_986_;
            if _e116 {
                if (_e66 > param_10) {
                    if (_e66 < 1f) {
                        let _e119 = lt_math_hausdorff_cubic_mass(_e48, 0f, _e66, param_10, 1f);
                        let _e120 = (1f - _e119);
                        if ((bitcast<u32>(_e120) & 2147483647u) > 2139095040u) {
                            phi_1016_ = _e120;
                        } else {
                            if (_e120 < 0f) {
                                phi_1015_ = 0f;
                            } else {
                                if (_e120 > 1f) {
                                    phi_1014_ = 1f;
                                } else {
                                    phi_1014_ = _e120;
                                }
                                let _e127 = phi_1014_;
                                phi_1015_ = _e127;
                            }
                            let _e129 = phi_1015_;
                            phi_1016_ = _e129;
                        }
                        let _e131 = phi_1016_;
                        phi_1017_ = _e131;
                        phi_1018_ = false;
                    } else {
                        phi_1017_ = f32();
                        phi_1018_ = true;
                    }
                    let _e133 = phi_1017_;
                    let _e135 = phi_1018_;
                    phi_1019_ = _e133;
                    phi_1020_ = _e135;
                } else {
                    phi_1019_ = f32();
                    phi_1020_ = true;
                }
                let _e137 = phi_1019_;
                let _e139 = phi_1020_;
                if _e139 {
                    phi_1027_ = bitcast<f32>((bitcast<u32>(_e66) | 2143289344u));
                } else {
                    phi_1027_ = _e137;
                }
                let _e144 = phi_1027_;
                phi_1028_ = _e144;
            } else {
                phi_1028_ = _e114;
            }
            let _e146 = phi_1028_;
            phi_1029_ = _e146;
        }
        let _e148 = phi_1029_;
        phi_1030_ = _e148;
    }
    let _e150 = phi_1030_;
    return _e150;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_11: ptr<function, f32>, param_12: vec4<f32>, param_13: f32) -> f32 {
    var local_1: hankel_HankelFactors;
    var phi_238_: f32;
    var phi_239_: f32;
    var phi_240_: f32;
    var phi_252_: bool;
    var phi_267_: bool;
    var phi_292_: f32;
    var phi_293_: f32;
    var phi_294_: f32;
    var phi_295_: f32;
    var phi_296_: bool;
    var phi_297_: f32;
    var phi_298_: bool;
    var phi_354_: vec2<f32>;
    var phi_392_: f32;
    var phi_393_: f32;
    var phi_394_: f32;
    var phi_427_: f32;
    var phi_428_: f32;
    var phi_429_: f32;
    var phi_433_: f32;
    var phi_434_: f32;
    var phi_435_: f32;
    var phi_436_: f32;
    var phi_489_: vec2<f32>;
    var phi_511_: bool;
    var phi_536_: f32;
    var phi_537_: f32;
    var phi_538_: f32;
    var phi_539_: f32;
    var phi_540_: bool;
    var phi_541_: f32;
    var phi_542_: bool;
    var phi_598_: vec2<f32>;
    var phi_636_: f32;
    var phi_637_: f32;
    var phi_638_: f32;
    var phi_671_: f32;
    var phi_672_: f32;
    var phi_673_: f32;
    var phi_677_: f32;
    var phi_678_: f32;
    var phi_679_: f32;
    var phi_680_: f32;
    var phi_681_: f32;
    var phi_682_: bool;
    var phi_683_: f32;
    var phi_684_: bool;
    var phi_706_: bool;
    var phi_731_: f32;
    var phi_732_: f32;
    var phi_733_: f32;
    var phi_734_: f32;
    var phi_735_: bool;
    var phi_736_: f32;
    var phi_737_: bool;
    var phi_793_: vec2<f32>;
    var phi_831_: f32;
    var phi_832_: f32;
    var phi_833_: f32;
    var phi_866_: f32;
    var phi_867_: f32;
    var phi_868_: f32;
    var phi_872_: f32;
    var phi_873_: f32;
    var phi_874_: f32;
    var phi_875_: f32;
    var phi_886_: bool;
    var phi_890_: f32;
    var phi_891_: f32;
    var phi_892_: f32;
    var phi_893_: f32;

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
        phi_240_ = param_13;
    } else {
        if (param_13 < 0f) {
            phi_239_ = 0f;
        } else {
            if (param_13 > 1f) {
                phi_238_ = 1f;
            } else {
                phi_238_ = param_13;
            }
            let _e86 = phi_238_;
            phi_239_ = _e86;
        }
        let _e88 = phi_239_;
        phi_240_ = _e88;
    }
    let _e90 = phi_240_;
    let _e93 = local_1.moments[0u];
    let _e96 = local_1.moments[3u];
    if (_e93 == _e96) {
        let _e100 = local_1.moments[0u];
        phi_252_ = (_e100 > 0.5f);
    } else {
        phi_252_ = false;
    }
    let _e103 = phi_252_;
    if _e103 {
        let _e106 = local_1.moments[0u];
        let _e109 = local_1.moments[3u];
        if (_e106 == _e109) {
            let _e113 = local_1.moments[0u];
            phi_267_ = (_e113 > 0.5f);
        } else {
            phi_267_ = false;
        }
        let _e116 = phi_267_;
        if _e116 {
            if (_e90 > 0f) {
                let _e119 = local_1.moments;
                if ((bitcast<u32>(_e119.x) & 2147483647u) > 2139095040u) {
                    phi_294_ = _e119.x;
                } else {
                    if (_e119.x < 0f) {
                        phi_293_ = 0f;
                    } else {
                        if (_e119.x > 1f) {
                            phi_292_ = 1f;
                        } else {
                            phi_292_ = _e119.x;
                        }
                        let _e127 = phi_292_;
                        phi_293_ = _e127;
                    }
                    let _e129 = phi_293_;
                    phi_294_ = _e129;
                }
                let _e131 = phi_294_;
                phi_295_ = _e131;
                phi_296_ = false;
            } else {
                phi_295_ = f32();
                phi_296_ = true;
            }
            let _e133 = phi_295_;
            let _e135 = phi_296_;
            phi_297_ = _e133;
            phi_298_ = _e135;
        } else {
            phi_297_ = f32();
            phi_298_ = true;
        }
        let _e137 = phi_297_;
        let _e139 = phi_298_;
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
                phi_354_ = vec2<f32>((-(_e178) - _e183), (-(_e178) + _e183));
            } else {
                phi_354_ = vec2(bitcast<f32>((bitcast<u32>(_e181) | 2143289344u)));
            }
            let _e194 = phi_354_;
            if (_e90 <= _e194.x) {
                phi_435_ = 1f;
            } else {
                if (_e90 > _e194.y) {
                    let _e200 = local_1.moments;
                    let _e211 = (((_e200.y - (_e200.x * (_e194.x + _e194.y))) + (_e194.x * _e194.y)) / ((_e90 - _e194.x) * (_e90 - _e194.y)));
                    if ((bitcast<u32>(_e211) & 2147483647u) > 2139095040u) {
                        phi_394_ = _e211;
                    } else {
                        if (_e211 < 0f) {
                            phi_393_ = 0f;
                        } else {
                            if (_e211 > 1f) {
                                phi_392_ = 1f;
                            } else {
                                phi_392_ = _e211;
                            }
                            let _e218 = phi_392_;
                            phi_393_ = _e218;
                        }
                        let _e220 = phi_393_;
                        phi_394_ = _e220;
                    }
                    let _e222 = phi_394_;
                    phi_434_ = _e222;
                } else {
                    if (_e90 > _e194.x) {
                        let _e225 = local_1.moments;
                        let _e237 = (1f - (((_e225.y - (_e225.x * (_e90 + _e194.y))) + (_e90 * _e194.y)) / ((_e194.x - _e90) * (_e194.x - _e194.y))));
                        if ((bitcast<u32>(_e237) & 2147483647u) > 2139095040u) {
                            phi_429_ = _e237;
                        } else {
                            if (_e237 < 0f) {
                                phi_428_ = 0f;
                            } else {
                                if (_e237 > 1f) {
                                    phi_427_ = 1f;
                                } else {
                                    phi_427_ = _e237;
                                }
                                let _e244 = phi_427_;
                                phi_428_ = _e244;
                            }
                            let _e246 = phi_428_;
                            phi_429_ = _e246;
                        }
                        let _e248 = phi_429_;
                        phi_433_ = _e248;
                    } else {
                        phi_433_ = bitcast<f32>((bitcast<u32>(_e194.x) | 2143289344u));
                    }
                    let _e253 = phi_433_;
                    phi_434_ = _e253;
                }
                let _e255 = phi_434_;
                phi_435_ = _e255;
            }
            let _e257 = phi_435_;
            phi_436_ = _e257;
        } else {
            phi_436_ = _e137;
        }
        let _e259 = phi_436_;
        phi_893_ = _e259;
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
            phi_489_ = vec2<f32>((-(_e298) - _e303), (-(_e298) + _e303));
        } else {
            phi_489_ = vec2(bitcast<f32>((bitcast<u32>(_e301) | 2143289344u)));
        }
        let _e314 = phi_489_;
        if (_e314.x >= 0f) {
            if (_e314.y <= 1f) {
                let _e321 = local_1.moments[0u];
                let _e324 = local_1.moments[3u];
                if (_e321 == _e324) {
                    let _e328 = local_1.moments[0u];
                    phi_511_ = (_e328 > 0.5f);
                } else {
                    phi_511_ = false;
                }
                let _e331 = phi_511_;
                if _e331 {
                    if (_e90 > 0f) {
                        let _e334 = local_1.moments;
                        if ((bitcast<u32>(_e334.x) & 2147483647u) > 2139095040u) {
                            phi_538_ = _e334.x;
                        } else {
                            if (_e334.x < 0f) {
                                phi_537_ = 0f;
                            } else {
                                if (_e334.x > 1f) {
                                    phi_536_ = 1f;
                                } else {
                                    phi_536_ = _e334.x;
                                }
                                let _e342 = phi_536_;
                                phi_537_ = _e342;
                            }
                            let _e344 = phi_537_;
                            phi_538_ = _e344;
                        }
                        let _e346 = phi_538_;
                        phi_539_ = _e346;
                        phi_540_ = false;
                    } else {
                        phi_539_ = f32();
                        phi_540_ = true;
                    }
                    let _e348 = phi_539_;
                    let _e350 = phi_540_;
                    phi_541_ = _e348;
                    phi_542_ = _e350;
                } else {
                    phi_541_ = f32();
                    phi_542_ = true;
                }
                let _e352 = phi_541_;
                let _e354 = phi_542_;
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
                        phi_598_ = vec2<f32>((-(_e393) - _e398), (-(_e393) + _e398));
                    } else {
                        phi_598_ = vec2(bitcast<f32>((bitcast<u32>(_e396) | 2143289344u)));
                    }
                    let _e409 = phi_598_;
                    if (_e90 <= _e409.x) {
                        phi_679_ = 1f;
                    } else {
                        if (_e90 > _e409.y) {
                            let _e415 = local_1.moments;
                            let _e426 = (((_e415.y - (_e415.x * (_e409.x + _e409.y))) + (_e409.x * _e409.y)) / ((_e90 - _e409.x) * (_e90 - _e409.y)));
                            if ((bitcast<u32>(_e426) & 2147483647u) > 2139095040u) {
                                phi_638_ = _e426;
                            } else {
                                if (_e426 < 0f) {
                                    phi_637_ = 0f;
                                } else {
                                    if (_e426 > 1f) {
                                        phi_636_ = 1f;
                                    } else {
                                        phi_636_ = _e426;
                                    }
                                    let _e433 = phi_636_;
                                    phi_637_ = _e433;
                                }
                                let _e435 = phi_637_;
                                phi_638_ = _e435;
                            }
                            let _e437 = phi_638_;
                            phi_678_ = _e437;
                        } else {
                            if (_e90 > _e409.x) {
                                let _e440 = local_1.moments;
                                let _e452 = (1f - (((_e440.y - (_e440.x * (_e90 + _e409.y))) + (_e90 * _e409.y)) / ((_e409.x - _e90) * (_e409.x - _e409.y))));
                                if ((bitcast<u32>(_e452) & 2147483647u) > 2139095040u) {
                                    phi_673_ = _e452;
                                } else {
                                    if (_e452 < 0f) {
                                        phi_672_ = 0f;
                                    } else {
                                        if (_e452 > 1f) {
                                            phi_671_ = 1f;
                                        } else {
                                            phi_671_ = _e452;
                                        }
                                        let _e459 = phi_671_;
                                        phi_672_ = _e459;
                                    }
                                    let _e461 = phi_672_;
                                    phi_673_ = _e461;
                                }
                                let _e463 = phi_673_;
                                phi_677_ = _e463;
                            } else {
                                phi_677_ = bitcast<f32>((bitcast<u32>(_e409.x) | 2143289344u));
                            }
                            let _e468 = phi_677_;
                            phi_678_ = _e468;
                        }
                        let _e470 = phi_678_;
                        phi_679_ = _e470;
                    }
                    let _e472 = phi_679_;
                    phi_680_ = _e472;
                } else {
                    phi_680_ = _e352;
                }
                let _e474 = phi_680_;
                phi_681_ = _e474;
                phi_682_ = false;
            } else {
                phi_681_ = f32();
                phi_682_ = true;
            }
            let _e476 = phi_681_;
            let _e478 = phi_682_;
            phi_683_ = _e476;
            phi_684_ = _e478;
        } else {
            phi_683_ = f32();
            phi_684_ = true;
        }
        let _e480 = phi_683_;
        let _e482 = phi_684_;
        if _e482 {
            if ((bitcast<u32>(_e314.x) & 2147483647u) > 2139095040u) {
                phi_891_ = _e314.x;
            } else {
                let _e486 = lt_math_hausdorff_endpoint_upper_bound((&local_1), _e90);
                let _e489 = local_1.moments[0u];
                let _e492 = local_1.moments[3u];
                if (_e489 == _e492) {
                    let _e496 = local_1.moments[0u];
                    phi_706_ = (_e496 > 0.5f);
                } else {
                    phi_706_ = false;
                }
                let _e499 = phi_706_;
                if _e499 {
                    if (_e90 > 0f) {
                        let _e502 = local_1.moments;
                        if ((bitcast<u32>(_e502.x) & 2147483647u) > 2139095040u) {
                            phi_733_ = _e502.x;
                        } else {
                            if (_e502.x < 0f) {
                                phi_732_ = 0f;
                            } else {
                                if (_e502.x > 1f) {
                                    phi_731_ = 1f;
                                } else {
                                    phi_731_ = _e502.x;
                                }
                                let _e510 = phi_731_;
                                phi_732_ = _e510;
                            }
                            let _e512 = phi_732_;
                            phi_733_ = _e512;
                        }
                        let _e514 = phi_733_;
                        phi_734_ = _e514;
                        phi_735_ = false;
                    } else {
                        phi_734_ = f32();
                        phi_735_ = true;
                    }
                    let _e516 = phi_734_;
                    let _e518 = phi_735_;
                    phi_736_ = _e516;
                    phi_737_ = _e518;
                } else {
                    phi_736_ = f32();
                    phi_737_ = true;
                }
                let _e520 = phi_736_;
                let _e522 = phi_737_;
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
                        phi_793_ = vec2<f32>((-(_e561) - _e566), (-(_e561) + _e566));
                    } else {
                        phi_793_ = vec2(bitcast<f32>((bitcast<u32>(_e564) | 2143289344u)));
                    }
                    let _e577 = phi_793_;
                    if (_e90 <= _e577.x) {
                        phi_874_ = 1f;
                    } else {
                        if (_e90 > _e577.y) {
                            let _e583 = local_1.moments;
                            let _e594 = (((_e583.y - (_e583.x * (_e577.x + _e577.y))) + (_e577.x * _e577.y)) / ((_e90 - _e577.x) * (_e90 - _e577.y)));
                            if ((bitcast<u32>(_e594) & 2147483647u) > 2139095040u) {
                                phi_833_ = _e594;
                            } else {
                                if (_e594 < 0f) {
                                    phi_832_ = 0f;
                                } else {
                                    if (_e594 > 1f) {
                                        phi_831_ = 1f;
                                    } else {
                                        phi_831_ = _e594;
                                    }
                                    let _e601 = phi_831_;
                                    phi_832_ = _e601;
                                }
                                let _e603 = phi_832_;
                                phi_833_ = _e603;
                            }
                            let _e605 = phi_833_;
                            phi_873_ = _e605;
                        } else {
                            if (_e90 > _e577.x) {
                                let _e608 = local_1.moments;
                                let _e620 = (1f - (((_e608.y - (_e608.x * (_e90 + _e577.y))) + (_e90 * _e577.y)) / ((_e577.x - _e90) * (_e577.x - _e577.y))));
                                if ((bitcast<u32>(_e620) & 2147483647u) > 2139095040u) {
                                    phi_868_ = _e620;
                                } else {
                                    if (_e620 < 0f) {
                                        phi_867_ = 0f;
                                    } else {
                                        if (_e620 > 1f) {
                                            phi_866_ = 1f;
                                        } else {
                                            phi_866_ = _e620;
                                        }
                                        let _e627 = phi_866_;
                                        phi_867_ = _e627;
                                    }
                                    let _e629 = phi_867_;
                                    phi_868_ = _e629;
                                }
                                let _e631 = phi_868_;
                                phi_872_ = _e631;
                            } else {
                                phi_872_ = bitcast<f32>((bitcast<u32>(_e577.x) | 2143289344u));
                            }
                            let _e636 = phi_872_;
                            phi_873_ = _e636;
                        }
                        let _e638 = phi_873_;
                        phi_874_ = _e638;
                    }
                    let _e640 = phi_874_;
                    phi_875_ = _e640;
                } else {
                    phi_875_ = _e520;
                }
                let _e642 = phi_875_;
                if ((bitcast<u32>(_e642) & 2147483647u) > 2139095040u) {
                    phi_886_ = true;
                } else {
                    let _e646 = (_e642 < _e486);
                    if _e646 {
                    }
                    phi_886_ = _e646;
                }
                let _e648 = phi_886_;
                if _e648 {
                    phi_890_ = _e642;
                } else {
                    phi_890_ = _e486;
                }
                let _e650 = phi_890_;
                phi_891_ = _e650;
            }
            let _e652 = phi_891_;
            phi_892_ = _e652;
        } else {
            phi_892_ = _e480;
        }
        let _e654 = phi_892_;
        phi_893_ = _e654;
    }
    let _e656 = phi_893_;
    return _e656;
}

fn function_() {
    var local_2: f32;
    var phi_1115_: bool;
    var phi_1116_: bool;
    var phi_1117_: bool;
    var phi_1118_: bool;
    var phi_1122_: bool;
    var phi_1166_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1170_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1190_: lt_math_LightPoint;
    var phi_1193_: u32;
    var phi_1195_: lt_math_LevelPoint;
    var phi_1281_: bool;
    var phi_1290_: bool;
    var phi_1299_: bool;
    var phi_1300_: bool;
    var phi_1301_: bool;
    var phi_1302_: bool;
    var phi_1303_: bool;
    var phi_1304_: bool;
    var phi_1305_: bool;
    var phi_1309_: bool;
    var phi_1336_: bool;
    var phi_1337_: bool;
    var phi_1338_: bool;
    var phi_1339_: bool;
    var phi_1340_: bool;
    var phi_1341_: bool;
    var phi_1342_: bool;
    var phi_1343_: bool;
    var phi_1347_: bool;
    var phi_1356_: lt_math_LightPoint;
    var phi_1357_: u32;
    var phi_1358_: lt_math_LevelPoint;
    var phi_1359_: bool;
    var phi_1191_: lt_math_LightPoint;
    var phi_1194_: u32;
    var phi_1196_: lt_math_LevelPoint;
    var phi_1360_: bool;
    var local_3: lt_math_LevelPoint;
    var local_4: lt_math_LevelPoint;
    var phi_1400_: bool;
    var phi_1401_: bool;
    var phi_1402_: bool;
    var phi_1403_: bool;
    var phi_1407_: bool;
    var phi_1489_: f32;
    var phi_1605_: f32;
    var phi_1606_: f32;
    var phi_1609_: f32;
    var phi_1638_: f32;
    var phi_1643_: f32;
    var phi_1644_: bool;
    var phi_1645_: f32;
    var phi_1646_: bool;
    var phi_1650_: f32;
    var phi_1670_: f32;
    var phi_1675_: f32;
    var phi_1676_: bool;
    var phi_1677_: f32;
    var phi_1678_: bool;
    var phi_1682_: f32;
    var local_5: lt_math_LevelPoint;
    var phi_1731_: i32;
    var phi_1736_: i32;
    var phi_1741_: i32;
    var phi_1746_: i32;
    var phi_1755_: i32;
    var phi_1760_: i32;
    var phi_1765_: i32;
    var phi_1770_: i32;
    var phi_1865_: bool;
    var phi_1873_: bool;
    var phi_1885_: bool;
    var phi_1886_: bool;
    var phi_1890_: f32;
    var phi_1896_: f32;
    var phi_1898_: evaluate_Verdict;
    var phi_1903_: evaluate_Verdict;
    var phi_1904_: evaluate_Verdict;
    var phi_1908_: bool;
    var phi_1909_: u32;
    var phi_1920_: u32;

    let _e46 = id_1;
    let _e47 = local_6;
    let _e52 = arrayLength((&map.member));
    let _e57 = arrayLength((&levels.member));
    let _e60 = p.member.size[0u];
    let _e62 = p.member.size[1u];
    let _e63 = lt_shaders_entry_pixel_index(_e46, _e60, _e62);
    if (bitcast<i32>(_e63.root) != 0i) {
        let _e70 = p.member.level_count;
        let _e72 = p.member.light;
        let _e75 = samples.member[_e63.first_primitive].normal[0u];
        let _e77 = global[0u];
        if (_e75 == _e77) {
            let _e80 = samples.member[_e63.first_primitive].normal[1u];
            let _e82 = global[1u];
            if (_e80 == _e82) {
                let _e85 = samples.member[_e63.first_primitive].normal[2u];
                let _e87 = global[2u];
                phi_1115_ = (_e85 == _e87);
                phi_1116_ = false;
            } else {
                phi_1115_ = bool();
                phi_1116_ = true;
            }
            let _e90 = phi_1115_;
            let _e92 = phi_1116_;
            phi_1117_ = _e90;
            phi_1118_ = _e92;
        } else {
            phi_1117_ = bool();
            phi_1118_ = true;
        }
        let _e94 = phi_1117_;
        let _e96 = phi_1118_;
        if _e96 {
            phi_1122_ = false;
        } else {
            phi_1122_ = _e94;
        }
        let _e98 = phi_1122_;
        if !(_e98) {
            let _e101 = samples.member[_e63.first_primitive].normal;
            let _e103 = samples.member[_e63.first_primitive].position;
            if ((((_e101.x * (_e72.x - (_e103.x * _e72.w))) + (_e101.y * (_e72.y - (_e103.y * _e72.w)))) + (_e101.z * (_e72.z - (_e103.z * _e72.w)))) > 0f) {
                let _e127 = samples.member[_e63.first_primitive].flags;
                let _e135 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e141 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e135.unnamed.visibility, false), _e135.unnamed_1);
                phi_1166_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e141.unnamed, ((_e127 & 1u) == 0u));
            } else {
                let _e150 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e156 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e150.unnamed.visibility, false), _e150.unnamed_1);
                phi_1166_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e156.unnamed, true);
            }
            let _e161 = phi_1166_;
            phi_1170_ = _e161;
        } else {
            let _e167 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e173 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e167.unnamed.visibility, false), _e167.unnamed_1);
            phi_1170_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e173.unnamed, true);
        }
        let _e178 = phi_1170_;
        if _e178.unnamed_1 {
            phi_1904_ = evaluate_Verdict(_e178.unnamed.visibility, _e178.unnamed.is_doubted);
        } else {
            let _e186 = samples.member[_e63.first_primitive].position;
            let _e188 = p.member.map_size;
            let _e190 = (0.5f / f32(_e188));
            let _e197 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e204 = lt_math_LightPoint(vec2<f32>(_e197.uv.x, 0f), _e197.depth, _e197.is_inside);
            let _e208 = lt_math_LightPoint(_e204.uv, 0f, _e204.is_inside);
            phi_1190_ = lt_math_LightPoint();
            phi_1193_ = 0u;
            phi_1195_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e208.uv, _e208.depth, false));
            loop {
                let _e215 = phi_1190_;
                let _e217 = phi_1193_;
                let _e219 = phi_1195_;
                local_3 = _e219;
                local_4 = _e219;
                local_5 = _e219;
                if (_e217 < _e70) {
                    if _e219.point.is_inside {
                        phi_1356_ = lt_math_LightPoint();
                        phi_1357_ = u32();
                        phi_1358_ = lt_math_LevelPoint();
                        phi_1359_ = false;
                    } else {
                        if (_e217 < _e57) {
                        } else {
                            return;
                        }
                        let _e230 = levels.member[(0u + _e217)].row_w;
                        let _e241 = ((((_e230.x * _e186.x) + (_e230.y * _e186.y)) + (_e230.z * _e186.z)) + (_e230.w * 1f));
                        let _e243 = levels.member[(0u + _e217)].row_x;
                        let _e255 = (((((_e243.x * _e186.x) + (_e243.y * _e186.y)) + (_e243.z * _e186.z)) + (_e243.w * 1f)) / _e241);
                        let _e257 = levels.member[(0u + _e217)].row_y;
                        let _e269 = (((((_e257.x * _e186.x) + (_e257.y * _e186.y)) + (_e257.z * _e186.z)) + (_e257.w * 1f)) / _e241);
                        let _e271 = levels.member[(0u + _e217)].row_z;
                        let _e282 = ((((_e271.x * _e186.x) + (_e271.y * _e186.y)) + (_e271.z * _e186.z)) + (_e271.w * 1f));
                        if (_e241 > 0f) {
                            if (_e255 >= 0f) {
                                phi_1281_ = (_e255 <= 1f);
                            } else {
                                phi_1281_ = false;
                            }
                            let _e287 = phi_1281_;
                            if _e287 {
                                if (_e269 >= 0f) {
                                    phi_1290_ = (_e269 <= 1f);
                                } else {
                                    phi_1290_ = false;
                                }
                                let _e291 = phi_1290_;
                                if _e291 {
                                    if (_e282 >= 0f) {
                                        phi_1299_ = (_e282 <= 1f);
                                    } else {
                                        phi_1299_ = false;
                                    }
                                    let _e295 = phi_1299_;
                                    phi_1300_ = _e295;
                                    phi_1301_ = false;
                                } else {
                                    phi_1300_ = bool();
                                    phi_1301_ = true;
                                }
                                let _e297 = phi_1300_;
                                let _e299 = phi_1301_;
                                phi_1302_ = _e297;
                                phi_1303_ = _e299;
                            } else {
                                phi_1302_ = bool();
                                phi_1303_ = true;
                            }
                            let _e301 = phi_1302_;
                            let _e303 = phi_1303_;
                            phi_1304_ = _e301;
                            phi_1305_ = _e303;
                        } else {
                            phi_1304_ = bool();
                            phi_1305_ = true;
                        }
                        let _e305 = phi_1304_;
                        let _e307 = phi_1305_;
                        if _e307 {
                            phi_1309_ = false;
                        } else {
                            phi_1309_ = _e305;
                        }
                        let _e309 = phi_1309_;
                        if _e309 {
                            if (_e255 >= _e190) {
                                if (_e255 <= (1f - _e190)) {
                                    if (_e269 >= _e190) {
                                        phi_1336_ = (_e269 <= (1f - _e190));
                                        phi_1337_ = false;
                                    } else {
                                        phi_1336_ = bool();
                                        phi_1337_ = true;
                                    }
                                    let _e317 = phi_1336_;
                                    let _e319 = phi_1337_;
                                    phi_1338_ = _e317;
                                    phi_1339_ = _e319;
                                } else {
                                    phi_1338_ = bool();
                                    phi_1339_ = true;
                                }
                                let _e321 = phi_1338_;
                                let _e323 = phi_1339_;
                                phi_1340_ = _e321;
                                phi_1341_ = _e323;
                            } else {
                                phi_1340_ = bool();
                                phi_1341_ = true;
                            }
                            let _e325 = phi_1340_;
                            let _e327 = phi_1341_;
                            phi_1342_ = _e325;
                            phi_1343_ = _e327;
                        } else {
                            phi_1342_ = bool();
                            phi_1343_ = true;
                        }
                        let _e329 = phi_1342_;
                        let _e331 = phi_1343_;
                        if _e331 {
                            phi_1347_ = false;
                        } else {
                            phi_1347_ = _e329;
                        }
                        let _e333 = phi_1347_;
                        let _e340 = lt_math_LightPoint(vec2<f32>(_e255, _e215.uv.y), _e215.depth, _e215.is_inside);
                        let _e347 = lt_math_LightPoint(vec2<f32>(_e340.uv.x, _e269), _e340.depth, _e340.is_inside);
                        let _e351 = lt_math_LightPoint(_e347.uv, _e282, _e347.is_inside);
                        let _e355 = lt_math_LightPoint(_e351.uv, _e351.depth, _e333);
                        phi_1356_ = _e355;
                        phi_1357_ = (_e217 + 1u);
                        phi_1358_ = lt_math_LevelPoint(_e217, _e355);
                        phi_1359_ = true;
                    }
                    let _e359 = phi_1356_;
                    let _e361 = phi_1357_;
                    let _e363 = phi_1358_;
                    let _e365 = phi_1359_;
                    phi_1191_ = _e359;
                    phi_1194_ = _e361;
                    phi_1196_ = _e363;
                    phi_1360_ = _e365;
                } else {
                    phi_1191_ = lt_math_LightPoint();
                    phi_1194_ = u32();
                    phi_1196_ = lt_math_LevelPoint();
                    phi_1360_ = false;
                }
                let _e367 = phi_1191_;
                let _e369 = phi_1194_;
                let _e371 = phi_1196_;
                let _e373 = phi_1360_;
                continue;
                continuing {
                    phi_1190_ = _e367;
                    phi_1193_ = _e369;
                    phi_1195_ = _e371;
                    break if !(_e373);
                }
            }
            let _e376 = local_3;
            if _e376.point.is_inside {
                if (0f > 0f) {
                    let _e382 = local_4;
                    if (_e382.level < _e57) {
                    } else {
                        return;
                    }
                    let _e387 = levels.member[(0u + _e382.level)];
                    let _e393 = global[0u];
                    if (_e387.row_w.x == _e393) {
                        let _e396 = global[1u];
                        if (_e387.row_w.y == _e396) {
                            let _e399 = global[2u];
                            phi_1400_ = (_e387.row_w.z == _e399);
                            phi_1401_ = false;
                        } else {
                            phi_1400_ = bool();
                            phi_1401_ = true;
                        }
                        let _e402 = phi_1400_;
                        let _e404 = phi_1401_;
                        phi_1402_ = _e402;
                        phi_1403_ = _e404;
                    } else {
                        phi_1402_ = bool();
                        phi_1403_ = true;
                    }
                    let _e406 = phi_1402_;
                    let _e408 = phi_1403_;
                    if _e408 {
                        phi_1407_ = false;
                    } else {
                        phi_1407_ = _e406;
                    }
                    let _e410 = phi_1407_;
                    if _e410 {
                        let _e412 = samples.member[_e63.first_primitive].normal;
                        let _e414 = p.member.map_size;
                        let _e484 = ((abs(((((_e387.row_x.x * _e412.x) + (_e387.row_x.y * _e412.y)) + (_e387.row_x.z * _e412.z)) / (((_e387.row_x.x * _e387.row_x.x) + (_e387.row_x.y * _e387.row_x.y)) + (_e387.row_x.z * _e387.row_x.z)))) + abs(((((_e387.row_y.x * _e412.x) + (_e387.row_y.y * _e412.y)) + (_e387.row_y.z * _e412.z)) / (((_e387.row_y.x * _e387.row_y.x) + (_e387.row_y.y * _e387.row_y.y)) + (_e387.row_y.z * _e387.row_y.z))))) / (abs(((((_e387.row_z.x * _e412.x) + (_e387.row_z.y * _e412.y)) + (_e387.row_z.z * _e412.z)) / (((_e387.row_z.x * _e387.row_z.x) + (_e387.row_z.y * _e387.row_z.y)) + (_e387.row_z.z * _e387.row_z.z)))) * f32(_e414)));
                        if (_e484 < 0.002f) {
                            phi_1489_ = _e484;
                        } else {
                            phi_1489_ = 0.002f;
                        }
                        let _e487 = phi_1489_;
                        phi_1606_ = _e487;
                    } else {
                        let _e489 = p.member.map_size;
                        let _e495 = samples.member[_e63.first_primitive].position;
                        let _e506 = ((((_e387.row_w.x * _e495.x) + (_e387.row_w.y * _e495.y)) + (_e387.row_w.z * _e495.z)) + _e387.row_w.w);
                        let _e519 = ((_e387.row_x.x - (_e387.row_w.x * _e376.point.uv.x)) / _e506);
                        let _e520 = ((_e387.row_x.y - (_e387.row_w.y * _e376.point.uv.x)) / _e506);
                        let _e521 = ((_e387.row_x.z - (_e387.row_w.z * _e376.point.uv.x)) / _e506);
                        let _e534 = ((_e387.row_y.x - (_e387.row_w.x * _e376.point.uv.y)) / _e506);
                        let _e535 = ((_e387.row_y.y - (_e387.row_w.y * _e376.point.uv.y)) / _e506);
                        let _e536 = ((_e387.row_y.z - (_e387.row_w.z * _e376.point.uv.y)) / _e506);
                        let _e542 = samples.member[_e63.first_primitive].normal;
                        let _e547 = ((_e535 * _e542.z) - (_e542.y * _e536));
                        let _e552 = ((_e536 * _e542.x) - (_e542.z * _e534));
                        let _e557 = ((_e534 * _e542.y) - (_e542.x * _e535));
                        let _e559 = samples.member[_e63.first_primitive].normal;
                        let _e564 = ((_e520 * _e559.z) - (_e559.y * _e521));
                        let _e569 = ((_e521 * _e559.x) - (_e559.z * _e519));
                        let _e574 = ((_e519 * _e559.y) - (_e559.x * _e520));
                        let _e601 = ((abs(((((_e387.row_z.x * _e547) + (_e387.row_z.y * _e552)) + (_e387.row_z.z * _e557)) / (((_e519 * _e547) + (_e520 * _e552)) + (_e521 * _e557)))) + abs(((((_e387.row_z.x * _e564) + (_e387.row_z.y * _e569)) + (_e387.row_z.z * _e574)) / (((_e534 * _e564) + (_e535 * _e569)) + (_e536 * _e574))))) / f32(_e489));
                        if (_e601 < 0.002f) {
                            phi_1605_ = _e601;
                        } else {
                            phi_1605_ = 0.002f;
                        }
                        let _e604 = phi_1605_;
                        phi_1606_ = _e604;
                    }
                    let _e606 = phi_1606_;
                    phi_1609_ = (_e376.point.depth - (0f * _e606));
                } else {
                    phi_1609_ = _e376.point.depth;
                }
                let _e610 = phi_1609_;
                let _e616 = p.member.map_size;
                let _e617 = f32(_e616);
                let _e620 = ((_e376.point.uv.x * _e617) - 0.5f);
                let _e621 = ((_e376.point.uv.y * _e617) - 0.5f);
                if (_e620 > -8388608f) {
                    let _e633 = f32(select(0i, select(select(i32(_e620), i32(-2147483648), (_e620 < bitcast<f32>(3472883712u))), 2147483647i, (_e620 > bitcast<f32>(1325400063u))), (_e620 == _e620)));
                    if (_e633 > _e620) {
                        phi_1638_ = 1f;
                    } else {
                        phi_1638_ = 0f;
                    }
                    let _e636 = phi_1638_;
                    if (_e620 < 8388608f) {
                        phi_1643_ = (_e633 - _e636);
                        phi_1644_ = false;
                    } else {
                        phi_1643_ = f32();
                        phi_1644_ = true;
                    }
                    let _e639 = phi_1643_;
                    let _e641 = phi_1644_;
                    phi_1645_ = _e639;
                    phi_1646_ = _e641;
                } else {
                    phi_1645_ = f32();
                    phi_1646_ = true;
                }
                let _e643 = phi_1645_;
                let _e645 = phi_1646_;
                if _e645 {
                    phi_1650_ = _e620;
                } else {
                    phi_1650_ = _e643;
                }
                let _e647 = phi_1650_;
                if (_e621 > -8388608f) {
                    let _e659 = f32(select(0i, select(select(i32(_e621), i32(-2147483648), (_e621 < bitcast<f32>(3472883712u))), 2147483647i, (_e621 > bitcast<f32>(1325400063u))), (_e621 == _e621)));
                    if (_e659 > _e621) {
                        phi_1670_ = 1f;
                    } else {
                        phi_1670_ = 0f;
                    }
                    let _e662 = phi_1670_;
                    if (_e621 < 8388608f) {
                        phi_1675_ = (_e659 - _e662);
                        phi_1676_ = false;
                    } else {
                        phi_1675_ = f32();
                        phi_1676_ = true;
                    }
                    let _e665 = phi_1675_;
                    let _e667 = phi_1676_;
                    phi_1677_ = _e665;
                    phi_1678_ = _e667;
                } else {
                    phi_1677_ = f32();
                    phi_1678_ = true;
                }
                let _e669 = phi_1677_;
                let _e671 = phi_1678_;
                if _e671 {
                    phi_1682_ = _e621;
                } else {
                    phi_1682_ = _e669;
                }
                let _e673 = phi_1682_;
                let _e674 = (_e620 - _e647);
                let _e675 = (_e621 - _e673);
                let _e684 = select(0i, select(select(i32(_e647), i32(-2147483648), (_e647 < bitcast<f32>(3472883712u))), 2147483647i, (_e647 > bitcast<f32>(1325400063u))), (_e647 == _e647));
                let _e693 = select(0i, select(select(i32(_e673), i32(-2147483648), (_e673 < bitcast<f32>(3472883712u))), 2147483647i, (_e673 > bitcast<f32>(1325400063u))), (_e673 == _e673));
                let _e696 = ((1f - _e674) * (1f - _e675));
                let _e698 = (_e674 * (1f - _e675));
                let _e700 = ((1f - _e674) * _e675);
                let _e701 = (_e674 * _e675);
                let _e703 = p.member.test;
                let _e704 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e703);
                let _e706 = p.member.map_size;
                let _e708 = local_5;
                local_2 = _e704;
                let _e711 = ((_e708.level * _e706) * _e706);
                let _e713 = (bitcast<i32>(_e706) - 1i);
                if (_e684 > 0i) {
                    phi_1731_ = _e684;
                } else {
                    phi_1731_ = 0i;
                }
                let _e716 = phi_1731_;
                if (_e693 > 0i) {
                    phi_1736_ = _e693;
                } else {
                    phi_1736_ = 0i;
                }
                let _e719 = phi_1736_;
                if (_e716 < _e713) {
                    phi_1741_ = _e716;
                } else {
                    phi_1741_ = _e713;
                }
                let _e722 = phi_1741_;
                if (_e719 < _e713) {
                    phi_1746_ = _e719;
                } else {
                    phi_1746_ = _e713;
                }
                let _e725 = phi_1746_;
                let _e726 = bitcast<u32>(_e722);
                let _e728 = (_e684 + 1i);
                let _e729 = (_e693 + 1i);
                if (_e728 > 0i) {
                    phi_1755_ = _e728;
                } else {
                    phi_1755_ = 0i;
                }
                let _e732 = phi_1755_;
                if (_e729 > 0i) {
                    phi_1760_ = _e729;
                } else {
                    phi_1760_ = 0i;
                }
                let _e735 = phi_1760_;
                if (_e732 < _e713) {
                    phi_1765_ = _e732;
                } else {
                    phi_1765_ = _e713;
                }
                let _e738 = phi_1765_;
                if (_e735 < _e713) {
                    phi_1770_ = _e735;
                } else {
                    phi_1770_ = _e713;
                }
                let _e741 = phi_1770_;
                let _e742 = bitcast<u32>(_e738);
                let _e744 = (bitcast<u32>(_e725) * _e706);
                let _e745 = (bitcast<u32>(_e741) * _e706);
                let _e750 = ((_e744 + _e726) + _e711);
                let _e751 = ((_e744 + _e742) + _e711);
                let _e752 = ((_e745 + _e726) + _e711);
                let _e753 = ((_e745 + _e742) + _e711);
                if (_e750 < _e52) {
                } else {
                    return;
                }
                let _e757 = map.member[(0u + _e750)];
                if (_e751 < _e52) {
                } else {
                    return;
                }
                let _e769 = map.member[(0u + _e751)];
                if (_e752 < _e52) {
                } else {
                    return;
                }
                let _e785 = map.member[(0u + _e752)];
                if (_e753 < _e52) {
                } else {
                    return;
                }
                let _e801 = map.member[(0u + _e753)];
                let _e815 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_2), vec4<f32>(((((_e757.x * _e696) + (_e769.x * _e698)) + (_e785.x * _e700)) + (_e801.x * _e701)), ((((_e757.y * _e696) + (_e769.y * _e698)) + (_e785.y * _e700)) + (_e801.y * _e701)), ((((_e757.z * _e696) + (_e769.z * _e698)) + (_e785.z * _e700)) + (_e801.z * _e701)), ((((_e757.w * _e696) + (_e769.w * _e698)) + (_e785.w * _e700)) + (_e801.w * _e701))), _e610);
                let _e817 = p.member.epsilon;
                if (_e815 <= _e817) {
                    phi_1865_ = true;
                } else {
                    phi_1865_ = (_e815 >= (1f - _e817));
                }
                let _e822 = phi_1865_;
                if ((bitcast<u32>(_e815) & 2147483647u) > 2139095040u) {
                    phi_1873_ = true;
                } else {
                    phi_1873_ = !(_e822);
                }
                let _e828 = phi_1873_;
                if _e828 {
                    if (_e815 > 0f) {
                        if (_e815 < 1f) {
                            phi_1885_ = false;
                        } else {
                            phi_1885_ = true;
                        }
                        let _e832 = phi_1885_;
                        phi_1886_ = _e832;
                    } else {
                        phi_1886_ = true;
                    }
                    let _e834 = phi_1886_;
                    if _e834 {
                        phi_1890_ = 0.5f;
                    } else {
                        phi_1890_ = _e815;
                    }
                    let _e836 = phi_1890_;
                    phi_1898_ = evaluate_Verdict(_e836, true);
                } else {
                    if (_e815 > 0.5f) {
                        phi_1896_ = 1f;
                    } else {
                        phi_1896_ = 0f;
                    }
                    let _e840 = phi_1896_;
                    phi_1898_ = evaluate_Verdict(_e840, false);
                }
                let _e843 = phi_1898_;
                phi_1903_ = evaluate_Verdict(_e843.visibility, _e843.is_doubted);
            } else {
                phi_1903_ = evaluate_Verdict(0.5f, true);
            }
            let _e849 = phi_1903_;
            phi_1904_ = _e849;
        }
        let _e851 = phi_1904_;
        visibility.member[_e63.first_primitive] = _e851.visibility;
        phi_1908_ = _e851.is_doubted;
        phi_1909_ = _e63.first_primitive;
    } else {
        phi_1908_ = false;
        phi_1909_ = 0u;
    }
    let _e856 = phi_1908_;
    let _e858 = phi_1909_;
    if (_e47 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e856 {
        let _e862 = atomicAdd((&shared_[0u]), 1u);
        phi_1920_ = _e862;
    } else {
        phi_1920_ = 0u;
    }
    let _e864 = phi_1920_;
    workgroupBarrier();
    if (_e47 == 0u) {
        let _e868 = atomicLoad((&shared_[0u]));
        let _e869 = atomicAdd((&list.member[3u]), _e868);
        atomicStore((&shared_[1u]), _e869);
    }
    workgroupBarrier();
    if _e856 {
        let _e872 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e872) + _e864)]), _e858);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_msm_hausdorff_prefiltered_levels_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_6 = local;
    function_();
}
