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

struct type_39 {
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

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_15;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_35;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_19;
@group(0) @binding(4) 
var<storage> levels: type_39;
@group(0) @binding(2) 
var<storage> map: type_31;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_165_: lt_bvh_traverse_Tree;
    var phi_166_: bool;
    var phi_167_: lt_bvh_traverse_Tree;
    var phi_168_: bool;
    var phi_173_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_165_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_166_ = false;
        } else {
            phi_165_ = lt_bvh_traverse_Tree();
            phi_166_ = true;
        }
        let _e58 = phi_165_;
        let _e60 = phi_166_;
        phi_167_ = _e58;
        phi_168_ = _e60;
    } else {
        phi_167_ = lt_bvh_traverse_Tree();
        phi_168_ = true;
    }
    let _e62 = phi_167_;
    let _e64 = phi_168_;
    if _e64 {
        phi_173_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_173_ = _e62;
    }
    let _e69 = phi_173_;
    return lt_bvh_traverse_Tree(_e69.root, _e69.first_primitive);
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn lt_math_hausdorff_cubic_mass(param_4: vec4<f32>, param_5: f32, param_6: f32, param_7: f32, param_8: f32) -> f32 {
    return ((((param_4.z - (((param_6 + param_7) + param_8) * param_4.y)) + ((((param_6 * param_7) + (param_6 * param_8)) + (param_7 * param_8)) * param_4.x)) - ((param_6 * param_7) * param_8)) / (((param_5 - param_6) * (param_5 - param_7)) * (param_5 - param_8)));
}

fn lt_math_hausdorff_endpoint_upper_bound(param_9: ptr<function, hankel_HankelFactors>, param_10: f32) -> f32 {
    var phi_943_: f32;
    var phi_944_: f32;
    var phi_945_: f32;
    var phi_972_: f32;
    var phi_973_: f32;
    var phi_974_: f32;
    var phi_975_: f32;
    var phi_976_: bool;
    var phi_977_: f32;
    var phi_978_: bool;
    var phi_1006_: f32;
    var phi_1007_: f32;
    var phi_1008_: f32;
    var phi_1009_: f32;
    var phi_1010_: bool;
    var phi_1011_: f32;
    var phi_1012_: bool;
    var phi_1019_: f32;
    var phi_1020_: f32;
    var phi_1021_: f32;
    var phi_1022_: f32;

    let _e48 = (*param_9).moments;
    if (param_10 < 0.0001f) {
        phi_1022_ = 1f;
    } else {
        let _e57 = ((_e48.z - ((1f + param_10) * _e48.y)) + (param_10 * _e48.x));
        let _e66 = (((_e48.w - ((1f + param_10) * _e48.z)) + (param_10 * _e48.y)) / _e57);
        if (abs(_e57) <= 0.00000047683716f) {
            let _e80 = (1f - (((_e48.y - (_e48.x * (param_10 + 1f))) + (param_10 * 1f)) / ((0f - param_10) * (0f - 1f))));
            if ((bitcast<u32>(_e80) & 2147483647u) > 2139095040u) {
                phi_945_ = _e80;
            } else {
                if (_e80 < 0f) {
                    phi_944_ = 0f;
                } else {
                    if (_e80 > 1f) {
                        phi_943_ = 1f;
                    } else {
                        phi_943_ = _e80;
                    }
                    let _e87 = phi_943_;
                    phi_944_ = _e87;
                }
                let _e89 = phi_944_;
                phi_945_ = _e89;
            }
            let _e91 = phi_945_;
            phi_1021_ = _e91;
        } else {
            if (_e66 > 0f) {
                if (_e66 < param_10) {
                    let _e94 = lt_math_hausdorff_cubic_mass(_e48, 0f, _e66, param_10, 1f);
                    let _e96 = lt_math_hausdorff_cubic_mass(_e48, _e66, 0f, param_10, 1f);
                    let _e97 = ((1f - _e94) - _e96);
                    if ((bitcast<u32>(_e97) & 2147483647u) > 2139095040u) {
                        phi_974_ = _e97;
                    } else {
                        if (_e97 < 0f) {
                            phi_973_ = 0f;
                        } else {
                            if (_e97 > 1f) {
                                phi_972_ = 1f;
                            } else {
                                phi_972_ = _e97;
                            }
                            let _e104 = phi_972_;
                            phi_973_ = _e104;
                        }
                        let _e106 = phi_973_;
                        phi_974_ = _e106;
                    }
                    let _e108 = phi_974_;
                    phi_975_ = _e108;
                    phi_976_ = false;
                } else {
                    phi_975_ = f32();
                    phi_976_ = true;
                }
                let _e110 = phi_975_;
                let _e112 = phi_976_;
                phi_977_ = _e110;
                phi_978_ = _e112;
            } else {
                phi_977_ = f32();
                phi_978_ = true;
            }
            let _e114 = phi_977_;
            let _e116 = phi_978_;
            if _e116 {
                if (_e66 > param_10) {
                    if (_e66 < 1f) {
                        let _e119 = lt_math_hausdorff_cubic_mass(_e48, 0f, _e66, param_10, 1f);
                        let _e120 = (1f - _e119);
                        if ((bitcast<u32>(_e120) & 2147483647u) > 2139095040u) {
                            phi_1008_ = _e120;
                        } else {
                            if (_e120 < 0f) {
                                phi_1007_ = 0f;
                            } else {
                                if (_e120 > 1f) {
                                    phi_1006_ = 1f;
                                } else {
                                    phi_1006_ = _e120;
                                }
                                let _e127 = phi_1006_;
                                phi_1007_ = _e127;
                            }
                            let _e129 = phi_1007_;
                            phi_1008_ = _e129;
                        }
                        let _e131 = phi_1008_;
                        phi_1009_ = _e131;
                        phi_1010_ = false;
                    } else {
                        phi_1009_ = f32();
                        phi_1010_ = true;
                    }
                    let _e133 = phi_1009_;
                    let _e135 = phi_1010_;
                    phi_1011_ = _e133;
                    phi_1012_ = _e135;
                } else {
                    phi_1011_ = f32();
                    phi_1012_ = true;
                }
                let _e137 = phi_1011_;
                let _e139 = phi_1012_;
                if _e139 {
                    phi_1019_ = bitcast<f32>((bitcast<u32>(_e66) | 2143289344u));
                } else {
                    phi_1019_ = _e137;
                }
                let _e144 = phi_1019_;
                phi_1020_ = _e144;
            } else {
                phi_1020_ = _e114;
            }
            let _e146 = phi_1020_;
            phi_1021_ = _e146;
        }
        let _e148 = phi_1021_;
        phi_1022_ = _e148;
    }
    let _e150 = phi_1022_;
    return _e150;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_11: ptr<function, f32>, param_12: vec4<f32>, param_13: f32) -> f32 {
    var local: hankel_HankelFactors;
    var phi_230_: f32;
    var phi_231_: f32;
    var phi_232_: f32;
    var phi_244_: bool;
    var phi_259_: bool;
    var phi_284_: f32;
    var phi_285_: f32;
    var phi_286_: f32;
    var phi_287_: f32;
    var phi_288_: bool;
    var phi_289_: f32;
    var phi_290_: bool;
    var phi_346_: vec2<f32>;
    var phi_384_: f32;
    var phi_385_: f32;
    var phi_386_: f32;
    var phi_419_: f32;
    var phi_420_: f32;
    var phi_421_: f32;
    var phi_425_: f32;
    var phi_426_: f32;
    var phi_427_: f32;
    var phi_428_: f32;
    var phi_481_: vec2<f32>;
    var phi_503_: bool;
    var phi_528_: f32;
    var phi_529_: f32;
    var phi_530_: f32;
    var phi_531_: f32;
    var phi_532_: bool;
    var phi_533_: f32;
    var phi_534_: bool;
    var phi_590_: vec2<f32>;
    var phi_628_: f32;
    var phi_629_: f32;
    var phi_630_: f32;
    var phi_663_: f32;
    var phi_664_: f32;
    var phi_665_: f32;
    var phi_669_: f32;
    var phi_670_: f32;
    var phi_671_: f32;
    var phi_672_: f32;
    var phi_673_: f32;
    var phi_674_: bool;
    var phi_675_: f32;
    var phi_676_: bool;
    var phi_698_: bool;
    var phi_723_: f32;
    var phi_724_: f32;
    var phi_725_: f32;
    var phi_726_: f32;
    var phi_727_: bool;
    var phi_728_: f32;
    var phi_729_: bool;
    var phi_785_: vec2<f32>;
    var phi_823_: f32;
    var phi_824_: f32;
    var phi_825_: f32;
    var phi_858_: f32;
    var phi_859_: f32;
    var phi_860_: f32;
    var phi_864_: f32;
    var phi_865_: f32;
    var phi_866_: f32;
    var phi_867_: f32;
    var phi_878_: bool;
    var phi_882_: f32;
    var phi_883_: f32;
    var phi_884_: f32;
    var phi_885_: f32;

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
    local = hankel_HankelFactors(_e74.moments, _e74.d22_, _e74.l32_d22_, _e74.d33_d22_);
    if ((bitcast<u32>(param_13) & 2147483647u) > 2139095040u) {
        phi_232_ = param_13;
    } else {
        if (param_13 < 0f) {
            phi_231_ = 0f;
        } else {
            if (param_13 > 1f) {
                phi_230_ = 1f;
            } else {
                phi_230_ = param_13;
            }
            let _e86 = phi_230_;
            phi_231_ = _e86;
        }
        let _e88 = phi_231_;
        phi_232_ = _e88;
    }
    let _e90 = phi_232_;
    let _e93 = local.moments[0u];
    let _e96 = local.moments[3u];
    if (_e93 == _e96) {
        let _e100 = local.moments[0u];
        phi_244_ = (_e100 > 0.5f);
    } else {
        phi_244_ = false;
    }
    let _e103 = phi_244_;
    if _e103 {
        let _e106 = local.moments[0u];
        let _e109 = local.moments[3u];
        if (_e106 == _e109) {
            let _e113 = local.moments[0u];
            phi_259_ = (_e113 > 0.5f);
        } else {
            phi_259_ = false;
        }
        let _e116 = phi_259_;
        if _e116 {
            if (_e90 > 0f) {
                let _e119 = local.moments;
                if ((bitcast<u32>(_e119.x) & 2147483647u) > 2139095040u) {
                    phi_286_ = _e119.x;
                } else {
                    if (_e119.x < 0f) {
                        phi_285_ = 0f;
                    } else {
                        if (_e119.x > 1f) {
                            phi_284_ = 1f;
                        } else {
                            phi_284_ = _e119.x;
                        }
                        let _e127 = phi_284_;
                        phi_285_ = _e127;
                    }
                    let _e129 = phi_285_;
                    phi_286_ = _e129;
                }
                let _e131 = phi_286_;
                phi_287_ = _e131;
                phi_288_ = false;
            } else {
                phi_287_ = f32();
                phi_288_ = true;
            }
            let _e133 = phi_287_;
            let _e135 = phi_288_;
            phi_289_ = _e133;
            phi_290_ = _e135;
        } else {
            phi_289_ = f32();
            phi_290_ = true;
        }
        let _e137 = phi_289_;
        let _e139 = phi_290_;
        if _e139 {
            let _e142 = local.moments[0u];
            let _e145 = local.moments[1u];
            let _e153 = local.l32_d22_;
            let _e155 = local.d22_;
            let _e156 = (_e153 / _e155);
            let _e157 = (_e90 - _e142);
            let _e163 = local.d22_;
            let _e166 = local.d33_d22_;
            let _e167 = (((((_e90 * _e90) - _e145) - (_e156 * _e157)) * _e163) / _e166);
            let _e169 = local.d22_;
            let _e172 = ((_e157 / _e169) - (_e156 * _e167));
            let _e178 = ((0.5f * _e172) / _e167);
            let _e181 = ((_e178 * _e178) - (((1f - (_e172 * _e142)) - (_e167 * _e145)) / _e167));
            if (_e181 >= 0f) {
                let _e183 = sqrt(_e181);
                phi_346_ = vec2<f32>((-(_e178) - _e183), (-(_e178) + _e183));
            } else {
                phi_346_ = vec2(bitcast<f32>((bitcast<u32>(_e181) | 2143289344u)));
            }
            let _e194 = phi_346_;
            if (_e90 <= _e194.x) {
                phi_427_ = 1f;
            } else {
                if (_e90 > _e194.y) {
                    let _e200 = local.moments;
                    let _e211 = (((_e200.y - (_e200.x * (_e194.x + _e194.y))) + (_e194.x * _e194.y)) / ((_e90 - _e194.x) * (_e90 - _e194.y)));
                    if ((bitcast<u32>(_e211) & 2147483647u) > 2139095040u) {
                        phi_386_ = _e211;
                    } else {
                        if (_e211 < 0f) {
                            phi_385_ = 0f;
                        } else {
                            if (_e211 > 1f) {
                                phi_384_ = 1f;
                            } else {
                                phi_384_ = _e211;
                            }
                            let _e218 = phi_384_;
                            phi_385_ = _e218;
                        }
                        let _e220 = phi_385_;
                        phi_386_ = _e220;
                    }
                    let _e222 = phi_386_;
                    phi_426_ = _e222;
                } else {
                    if (_e90 > _e194.x) {
                        let _e225 = local.moments;
                        let _e237 = (1f - (((_e225.y - (_e225.x * (_e90 + _e194.y))) + (_e90 * _e194.y)) / ((_e194.x - _e90) * (_e194.x - _e194.y))));
                        if ((bitcast<u32>(_e237) & 2147483647u) > 2139095040u) {
                            phi_421_ = _e237;
                        } else {
                            if (_e237 < 0f) {
                                phi_420_ = 0f;
                            } else {
                                if (_e237 > 1f) {
                                    phi_419_ = 1f;
                                } else {
                                    phi_419_ = _e237;
                                }
                                let _e244 = phi_419_;
                                phi_420_ = _e244;
                            }
                            let _e246 = phi_420_;
                            phi_421_ = _e246;
                        }
                        let _e248 = phi_421_;
                        phi_425_ = _e248;
                    } else {
                        phi_425_ = bitcast<f32>((bitcast<u32>(_e194.x) | 2143289344u));
                    }
                    let _e253 = phi_425_;
                    phi_426_ = _e253;
                }
                let _e255 = phi_426_;
                phi_427_ = _e255;
            }
            let _e257 = phi_427_;
            phi_428_ = _e257;
        } else {
            phi_428_ = _e137;
        }
        let _e259 = phi_428_;
        phi_885_ = _e259;
    } else {
        let _e262 = local.moments[0u];
        let _e265 = local.moments[1u];
        let _e273 = local.l32_d22_;
        let _e275 = local.d22_;
        let _e276 = (_e273 / _e275);
        let _e277 = (_e90 - _e262);
        let _e283 = local.d22_;
        let _e286 = local.d33_d22_;
        let _e287 = (((((_e90 * _e90) - _e265) - (_e276 * _e277)) * _e283) / _e286);
        let _e289 = local.d22_;
        let _e292 = ((_e277 / _e289) - (_e276 * _e287));
        let _e298 = ((0.5f * _e292) / _e287);
        let _e301 = ((_e298 * _e298) - (((1f - (_e292 * _e262)) - (_e287 * _e265)) / _e287));
        if (_e301 >= 0f) {
            let _e303 = sqrt(_e301);
            phi_481_ = vec2<f32>((-(_e298) - _e303), (-(_e298) + _e303));
        } else {
            phi_481_ = vec2(bitcast<f32>((bitcast<u32>(_e301) | 2143289344u)));
        }
        let _e314 = phi_481_;
        if (_e314.x >= 0f) {
            if (_e314.y <= 1f) {
                let _e321 = local.moments[0u];
                let _e324 = local.moments[3u];
                if (_e321 == _e324) {
                    let _e328 = local.moments[0u];
                    phi_503_ = (_e328 > 0.5f);
                } else {
                    phi_503_ = false;
                }
                let _e331 = phi_503_;
                if _e331 {
                    if (_e90 > 0f) {
                        let _e334 = local.moments;
                        if ((bitcast<u32>(_e334.x) & 2147483647u) > 2139095040u) {
                            phi_530_ = _e334.x;
                        } else {
                            if (_e334.x < 0f) {
                                phi_529_ = 0f;
                            } else {
                                if (_e334.x > 1f) {
                                    phi_528_ = 1f;
                                } else {
                                    phi_528_ = _e334.x;
                                }
                                let _e342 = phi_528_;
                                phi_529_ = _e342;
                            }
                            let _e344 = phi_529_;
                            phi_530_ = _e344;
                        }
                        let _e346 = phi_530_;
                        phi_531_ = _e346;
                        phi_532_ = false;
                    } else {
                        phi_531_ = f32();
                        phi_532_ = true;
                    }
                    let _e348 = phi_531_;
                    let _e350 = phi_532_;
                    phi_533_ = _e348;
                    phi_534_ = _e350;
                } else {
                    phi_533_ = f32();
                    phi_534_ = true;
                }
                let _e352 = phi_533_;
                let _e354 = phi_534_;
                if _e354 {
                    let _e357 = local.moments[0u];
                    let _e360 = local.moments[1u];
                    let _e368 = local.l32_d22_;
                    let _e370 = local.d22_;
                    let _e371 = (_e368 / _e370);
                    let _e372 = (_e90 - _e357);
                    let _e378 = local.d22_;
                    let _e381 = local.d33_d22_;
                    let _e382 = (((((_e90 * _e90) - _e360) - (_e371 * _e372)) * _e378) / _e381);
                    let _e384 = local.d22_;
                    let _e387 = ((_e372 / _e384) - (_e371 * _e382));
                    let _e393 = ((0.5f * _e387) / _e382);
                    let _e396 = ((_e393 * _e393) - (((1f - (_e387 * _e357)) - (_e382 * _e360)) / _e382));
                    if (_e396 >= 0f) {
                        let _e398 = sqrt(_e396);
                        phi_590_ = vec2<f32>((-(_e393) - _e398), (-(_e393) + _e398));
                    } else {
                        phi_590_ = vec2(bitcast<f32>((bitcast<u32>(_e396) | 2143289344u)));
                    }
                    let _e409 = phi_590_;
                    if (_e90 <= _e409.x) {
                        phi_671_ = 1f;
                    } else {
                        if (_e90 > _e409.y) {
                            let _e415 = local.moments;
                            let _e426 = (((_e415.y - (_e415.x * (_e409.x + _e409.y))) + (_e409.x * _e409.y)) / ((_e90 - _e409.x) * (_e90 - _e409.y)));
                            if ((bitcast<u32>(_e426) & 2147483647u) > 2139095040u) {
                                phi_630_ = _e426;
                            } else {
                                if (_e426 < 0f) {
                                    phi_629_ = 0f;
                                } else {
                                    if (_e426 > 1f) {
                                        phi_628_ = 1f;
                                    } else {
                                        phi_628_ = _e426;
                                    }
                                    let _e433 = phi_628_;
                                    phi_629_ = _e433;
                                }
                                let _e435 = phi_629_;
                                phi_630_ = _e435;
                            }
                            let _e437 = phi_630_;
                            phi_670_ = _e437;
                        } else {
                            if (_e90 > _e409.x) {
                                let _e440 = local.moments;
                                let _e452 = (1f - (((_e440.y - (_e440.x * (_e90 + _e409.y))) + (_e90 * _e409.y)) / ((_e409.x - _e90) * (_e409.x - _e409.y))));
                                if ((bitcast<u32>(_e452) & 2147483647u) > 2139095040u) {
                                    phi_665_ = _e452;
                                } else {
                                    if (_e452 < 0f) {
                                        phi_664_ = 0f;
                                    } else {
                                        if (_e452 > 1f) {
                                            phi_663_ = 1f;
                                        } else {
                                            phi_663_ = _e452;
                                        }
                                        let _e459 = phi_663_;
                                        phi_664_ = _e459;
                                    }
                                    let _e461 = phi_664_;
                                    phi_665_ = _e461;
                                }
                                let _e463 = phi_665_;
                                phi_669_ = _e463;
                            } else {
                                phi_669_ = bitcast<f32>((bitcast<u32>(_e409.x) | 2143289344u));
                            }
                            let _e468 = phi_669_;
                            phi_670_ = _e468;
                        }
                        let _e470 = phi_670_;
                        phi_671_ = _e470;
                    }
                    let _e472 = phi_671_;
                    phi_672_ = _e472;
                } else {
                    phi_672_ = _e352;
                }
                let _e474 = phi_672_;
                phi_673_ = _e474;
                phi_674_ = false;
            } else {
                phi_673_ = f32();
                phi_674_ = true;
            }
            let _e476 = phi_673_;
            let _e478 = phi_674_;
            phi_675_ = _e476;
            phi_676_ = _e478;
        } else {
            phi_675_ = f32();
            phi_676_ = true;
        }
        let _e480 = phi_675_;
        let _e482 = phi_676_;
        if _e482 {
            if ((bitcast<u32>(_e314.x) & 2147483647u) > 2139095040u) {
                phi_883_ = _e314.x;
            } else {
                let _e486 = lt_math_hausdorff_endpoint_upper_bound((&local), _e90);
                let _e489 = local.moments[0u];
                let _e492 = local.moments[3u];
                if (_e489 == _e492) {
                    let _e496 = local.moments[0u];
                    phi_698_ = (_e496 > 0.5f);
                } else {
                    phi_698_ = false;
                }
                let _e499 = phi_698_;
                if _e499 {
                    if (_e90 > 0f) {
                        let _e502 = local.moments;
                        if ((bitcast<u32>(_e502.x) & 2147483647u) > 2139095040u) {
                            phi_725_ = _e502.x;
                        } else {
                            if (_e502.x < 0f) {
                                phi_724_ = 0f;
                            } else {
                                if (_e502.x > 1f) {
                                    phi_723_ = 1f;
                                } else {
                                    phi_723_ = _e502.x;
                                }
                                let _e510 = phi_723_;
                                phi_724_ = _e510;
                            }
                            let _e512 = phi_724_;
                            phi_725_ = _e512;
                        }
                        let _e514 = phi_725_;
                        phi_726_ = _e514;
                        phi_727_ = false;
                    } else {
                        phi_726_ = f32();
                        phi_727_ = true;
                    }
                    let _e516 = phi_726_;
                    let _e518 = phi_727_;
                    phi_728_ = _e516;
                    phi_729_ = _e518;
                } else {
                    phi_728_ = f32();
                    phi_729_ = true;
                }
                let _e520 = phi_728_;
                let _e522 = phi_729_;
                if _e522 {
                    let _e525 = local.moments[0u];
                    let _e528 = local.moments[1u];
                    let _e536 = local.l32_d22_;
                    let _e538 = local.d22_;
                    let _e539 = (_e536 / _e538);
                    let _e540 = (_e90 - _e525);
                    let _e546 = local.d22_;
                    let _e549 = local.d33_d22_;
                    let _e550 = (((((_e90 * _e90) - _e528) - (_e539 * _e540)) * _e546) / _e549);
                    let _e552 = local.d22_;
                    let _e555 = ((_e540 / _e552) - (_e539 * _e550));
                    let _e561 = ((0.5f * _e555) / _e550);
                    let _e564 = ((_e561 * _e561) - (((1f - (_e555 * _e525)) - (_e550 * _e528)) / _e550));
                    if (_e564 >= 0f) {
                        let _e566 = sqrt(_e564);
                        phi_785_ = vec2<f32>((-(_e561) - _e566), (-(_e561) + _e566));
                    } else {
                        phi_785_ = vec2(bitcast<f32>((bitcast<u32>(_e564) | 2143289344u)));
                    }
                    let _e577 = phi_785_;
                    if (_e90 <= _e577.x) {
                        phi_866_ = 1f;
                    } else {
                        if (_e90 > _e577.y) {
                            let _e583 = local.moments;
                            let _e594 = (((_e583.y - (_e583.x * (_e577.x + _e577.y))) + (_e577.x * _e577.y)) / ((_e90 - _e577.x) * (_e90 - _e577.y)));
                            if ((bitcast<u32>(_e594) & 2147483647u) > 2139095040u) {
                                phi_825_ = _e594;
                            } else {
                                if (_e594 < 0f) {
                                    phi_824_ = 0f;
                                } else {
                                    if (_e594 > 1f) {
                                        phi_823_ = 1f;
                                    } else {
                                        phi_823_ = _e594;
                                    }
                                    let _e601 = phi_823_;
                                    phi_824_ = _e601;
                                }
                                let _e603 = phi_824_;
                                phi_825_ = _e603;
                            }
                            let _e605 = phi_825_;
                            phi_865_ = _e605;
                        } else {
                            if (_e90 > _e577.x) {
                                let _e608 = local.moments;
                                let _e620 = (1f - (((_e608.y - (_e608.x * (_e90 + _e577.y))) + (_e90 * _e577.y)) / ((_e577.x - _e90) * (_e577.x - _e577.y))));
                                if ((bitcast<u32>(_e620) & 2147483647u) > 2139095040u) {
                                    phi_860_ = _e620;
                                } else {
                                    if (_e620 < 0f) {
                                        phi_859_ = 0f;
                                    } else {
                                        if (_e620 > 1f) {
                                            phi_858_ = 1f;
                                        } else {
                                            phi_858_ = _e620;
                                        }
                                        let _e627 = phi_858_;
                                        phi_859_ = _e627;
                                    }
                                    let _e629 = phi_859_;
                                    phi_860_ = _e629;
                                }
                                let _e631 = phi_860_;
                                phi_864_ = _e631;
                            } else {
                                phi_864_ = bitcast<f32>((bitcast<u32>(_e577.x) | 2143289344u));
                            }
                            let _e636 = phi_864_;
                            phi_865_ = _e636;
                        }
                        let _e638 = phi_865_;
                        phi_866_ = _e638;
                    }
                    let _e640 = phi_866_;
                    phi_867_ = _e640;
                } else {
                    phi_867_ = _e520;
                }
                let _e642 = phi_867_;
                if ((bitcast<u32>(_e642) & 2147483647u) > 2139095040u) {
                    phi_878_ = true;
                } else {
                    let _e646 = (_e642 < _e486);
                    if _e646 {
                    }
                    phi_878_ = _e646;
                }
                let _e648 = phi_878_;
                if _e648 {
                    phi_882_ = _e642;
                } else {
                    phi_882_ = _e486;
                }
                let _e650 = phi_882_;
                phi_883_ = _e650;
            }
            let _e652 = phi_883_;
            phi_884_ = _e652;
        } else {
            phi_884_ = _e480;
        }
        let _e654 = phi_884_;
        phi_885_ = _e654;
    }
    let _e656 = phi_885_;
    return _e656;
}

fn function_() {
    var local_1: f32;
    var phi_1111_: bool;
    var phi_1112_: bool;
    var phi_1113_: bool;
    var phi_1114_: bool;
    var phi_1118_: bool;
    var phi_1188_: bool;
    var phi_1189_: bool;
    var phi_1200_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1201_: bool;
    var phi_1202_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1203_: bool;
    var phi_1210_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1214_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1234_: lt_math_LightPoint;
    var phi_1237_: u32;
    var phi_1239_: lt_math_LevelPoint;
    var phi_1325_: bool;
    var phi_1334_: bool;
    var phi_1343_: bool;
    var phi_1344_: bool;
    var phi_1345_: bool;
    var phi_1346_: bool;
    var phi_1347_: bool;
    var phi_1348_: bool;
    var phi_1349_: bool;
    var phi_1353_: bool;
    var phi_1380_: bool;
    var phi_1381_: bool;
    var phi_1382_: bool;
    var phi_1383_: bool;
    var phi_1384_: bool;
    var phi_1385_: bool;
    var phi_1386_: bool;
    var phi_1387_: bool;
    var phi_1391_: bool;
    var phi_1400_: lt_math_LightPoint;
    var phi_1401_: u32;
    var phi_1402_: lt_math_LevelPoint;
    var phi_1403_: bool;
    var phi_1235_: lt_math_LightPoint;
    var phi_1238_: u32;
    var phi_1240_: lt_math_LevelPoint;
    var phi_1404_: bool;
    var local_2: lt_math_LevelPoint;
    var local_3: lt_math_LevelPoint;
    var phi_1444_: bool;
    var phi_1445_: bool;
    var phi_1446_: bool;
    var phi_1447_: bool;
    var phi_1451_: bool;
    var phi_1533_: f32;
    var phi_1651_: f32;
    var phi_1652_: f32;
    var phi_1655_: f32;
    var phi_1684_: f32;
    var phi_1689_: f32;
    var phi_1690_: bool;
    var phi_1691_: f32;
    var phi_1692_: bool;
    var phi_1696_: f32;
    var phi_1716_: f32;
    var phi_1721_: f32;
    var phi_1722_: bool;
    var phi_1723_: f32;
    var phi_1724_: bool;
    var phi_1728_: f32;
    var local_4: lt_math_LevelPoint;
    var phi_1777_: i32;
    var phi_1782_: i32;
    var phi_1787_: i32;
    var phi_1792_: i32;
    var phi_1801_: i32;
    var phi_1806_: i32;
    var phi_1811_: i32;
    var phi_1816_: i32;
    var phi_1913_: bool;
    var phi_1921_: bool;
    var phi_1933_: bool;
    var phi_1934_: bool;
    var phi_1938_: f32;
    var phi_1944_: f32;
    var phi_1946_: evaluate_Verdict;
    var phi_1956_: u32;
    var phi_1965_: f32;
    var phi_1967_: evaluate_Verdict;
    var phi_1968_: bool;
    var phi_1969_: evaluate_Verdict;
    var phi_1970_: bool;
    var phi_1975_: evaluate_Verdict;
    var phi_1980_: evaluate_Verdict;
    var phi_1981_: evaluate_Verdict;

    let _e46 = id_1;
    let _e53 = arrayLength((&map.member));
    let _e59 = arrayLength((&levels.member));
    let _e62 = p.member.size[0u];
    let _e64 = p.member.size[1u];
    let _e65 = lt_shaders_entry_pixel_index(_e46, _e62, _e64);
    if (bitcast<i32>(_e65.root) != 0i) {
        let _e71 = p.member.level_count;
        if (_e65.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e78 = samples.member[(0u + _e65.first_primitive)].normal[0u];
        let _e80 = global[0u];
        if (_e78 == _e80) {
            let _e83 = samples.member[(0u + _e65.first_primitive)].normal[1u];
            let _e85 = global[1u];
            if (_e83 == _e85) {
                let _e88 = samples.member[(0u + _e65.first_primitive)].normal[2u];
                let _e90 = global[2u];
                phi_1111_ = (_e88 == _e90);
                phi_1112_ = false;
            } else {
                phi_1111_ = bool();
                phi_1112_ = true;
            }
            let _e93 = phi_1111_;
            let _e95 = phi_1112_;
            phi_1113_ = _e93;
            phi_1114_ = _e95;
        } else {
            phi_1113_ = bool();
            phi_1114_ = true;
        }
        let _e97 = phi_1113_;
        let _e99 = phi_1114_;
        if _e99 {
            phi_1118_ = false;
        } else {
            phi_1118_ = _e97;
        }
        let _e101 = phi_1118_;
        if !(_e101) {
            let _e104 = samples.member[(0u + _e65.first_primitive)].position;
            let _e106 = p.member.light.place;
            let _e112 = p.member.light.place[3u];
            let _e119 = (_e106.x - (_e104.x * _e112));
            let _e120 = (_e106.y - (_e104.y * _e112));
            let _e121 = (_e106.z - (_e104.z * _e112));
            let _e123 = samples.member[(0u + _e65.first_primitive)].normal;
            if ((((_e123.x * _e119) + (_e123.y * _e120)) + (_e123.z * _e121)) > 0f) {
                let _e137 = (((_e119 * _e119) + (_e120 * _e120)) + (_e121 * _e121));
                let _e139 = p.member.light.axis;
                let _e151 = p.member.light.place[3u];
                if (_e151 == 0f) {
                    phi_1189_ = true;
                } else {
                    let _e154 = p.member.light.range_squared;
                    if (_e137 <= _e154) {
                        let _e157 = p.member.light.cos_outer;
                        phi_1188_ = (-((((_e119 * _e139.x) + (_e120 * _e139.y)) + (_e121 * _e139.z))) >= (_e157 * sqrt(_e137)));
                    } else {
                        phi_1188_ = false;
                    }
                    let _e162 = phi_1188_;
                    phi_1189_ = _e162;
                }
                let _e164 = phi_1189_;
                if _e164 {
                    let _e166 = samples.member[(0u + _e65.first_primitive)].flags;
                    let _e174 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e180 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e174.unnamed.visibility, false), _e174.unnamed_1);
                    phi_1200_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e180.unnamed, ((_e166 & 1u) == 0u));
                    phi_1201_ = false;
                } else {
                    phi_1200_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_1201_ = true;
                }
                let _e185 = phi_1200_;
                let _e187 = phi_1201_;
                phi_1202_ = _e185;
                phi_1203_ = _e187;
            } else {
                phi_1202_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_1203_ = true;
            }
            let _e189 = phi_1202_;
            let _e191 = phi_1203_;
            if _e191 {
                let _e197 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e203 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e197.unnamed.visibility, false), _e197.unnamed_1);
                phi_1210_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e203.unnamed, true);
            } else {
                phi_1210_ = _e189;
            }
            let _e208 = phi_1210_;
            phi_1214_ = _e208;
        } else {
            let _e214 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e220 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e214.unnamed.visibility, false), _e214.unnamed_1);
            phi_1214_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e220.unnamed, true);
        }
        let _e225 = phi_1214_;
        if _e225.unnamed_1 {
            phi_1981_ = evaluate_Verdict(_e225.unnamed.visibility, _e225.unnamed.is_doubted);
        } else {
            let _e233 = samples.member[(0u + _e65.first_primitive)].position;
            let _e235 = p.member.map_size;
            let _e237 = (0.5f / f32(_e235));
            let _e244 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e251 = lt_math_LightPoint(vec2<f32>(_e244.uv.x, 0f), _e244.depth, _e244.is_inside);
            let _e255 = lt_math_LightPoint(_e251.uv, 0f, _e251.is_inside);
            phi_1234_ = lt_math_LightPoint();
            phi_1237_ = 0u;
            phi_1239_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e255.uv, _e255.depth, false));
            loop {
                let _e262 = phi_1234_;
                let _e264 = phi_1237_;
                let _e266 = phi_1239_;
                local_2 = _e266;
                local_3 = _e266;
                local_4 = _e266;
                if (_e264 < _e71) {
                    if _e266.point.is_inside {
                        phi_1400_ = lt_math_LightPoint();
                        phi_1401_ = u32();
                        phi_1402_ = lt_math_LevelPoint();
                        phi_1403_ = false;
                    } else {
                        if (_e264 < _e59) {
                        } else {
                            return;
                        }
                        let _e277 = levels.member[(0u + _e264)].row_w;
                        let _e288 = ((((_e277.x * _e233.x) + (_e277.y * _e233.y)) + (_e277.z * _e233.z)) + (_e277.w * 1f));
                        let _e290 = levels.member[(0u + _e264)].row_x;
                        let _e302 = (((((_e290.x * _e233.x) + (_e290.y * _e233.y)) + (_e290.z * _e233.z)) + (_e290.w * 1f)) / _e288);
                        let _e304 = levels.member[(0u + _e264)].row_y;
                        let _e316 = (((((_e304.x * _e233.x) + (_e304.y * _e233.y)) + (_e304.z * _e233.z)) + (_e304.w * 1f)) / _e288);
                        let _e318 = levels.member[(0u + _e264)].row_z;
                        let _e329 = ((((_e318.x * _e233.x) + (_e318.y * _e233.y)) + (_e318.z * _e233.z)) + (_e318.w * 1f));
                        if (_e288 > 0f) {
                            if (_e302 >= 0f) {
                                phi_1325_ = (_e302 <= 1f);
                            } else {
                                phi_1325_ = false;
                            }
                            let _e334 = phi_1325_;
                            if _e334 {
                                if (_e316 >= 0f) {
                                    phi_1334_ = (_e316 <= 1f);
                                } else {
                                    phi_1334_ = false;
                                }
                                let _e338 = phi_1334_;
                                if _e338 {
                                    if (_e329 >= 0f) {
                                        phi_1343_ = (_e329 <= 1f);
                                    } else {
                                        phi_1343_ = false;
                                    }
                                    let _e342 = phi_1343_;
                                    phi_1344_ = _e342;
                                    phi_1345_ = false;
                                } else {
                                    phi_1344_ = bool();
                                    phi_1345_ = true;
                                }
                                let _e344 = phi_1344_;
                                let _e346 = phi_1345_;
                                phi_1346_ = _e344;
                                phi_1347_ = _e346;
                            } else {
                                phi_1346_ = bool();
                                phi_1347_ = true;
                            }
                            let _e348 = phi_1346_;
                            let _e350 = phi_1347_;
                            phi_1348_ = _e348;
                            phi_1349_ = _e350;
                        } else {
                            phi_1348_ = bool();
                            phi_1349_ = true;
                        }
                        let _e352 = phi_1348_;
                        let _e354 = phi_1349_;
                        if _e354 {
                            phi_1353_ = false;
                        } else {
                            phi_1353_ = _e352;
                        }
                        let _e356 = phi_1353_;
                        if _e356 {
                            if (_e302 >= _e237) {
                                if (_e302 <= (1f - _e237)) {
                                    if (_e316 >= _e237) {
                                        phi_1380_ = (_e316 <= (1f - _e237));
                                        phi_1381_ = false;
                                    } else {
                                        phi_1380_ = bool();
                                        phi_1381_ = true;
                                    }
                                    let _e364 = phi_1380_;
                                    let _e366 = phi_1381_;
                                    phi_1382_ = _e364;
                                    phi_1383_ = _e366;
                                } else {
                                    phi_1382_ = bool();
                                    phi_1383_ = true;
                                }
                                let _e368 = phi_1382_;
                                let _e370 = phi_1383_;
                                phi_1384_ = _e368;
                                phi_1385_ = _e370;
                            } else {
                                phi_1384_ = bool();
                                phi_1385_ = true;
                            }
                            let _e372 = phi_1384_;
                            let _e374 = phi_1385_;
                            phi_1386_ = _e372;
                            phi_1387_ = _e374;
                        } else {
                            phi_1386_ = bool();
                            phi_1387_ = true;
                        }
                        let _e376 = phi_1386_;
                        let _e378 = phi_1387_;
                        if _e378 {
                            phi_1391_ = false;
                        } else {
                            phi_1391_ = _e376;
                        }
                        let _e380 = phi_1391_;
                        let _e387 = lt_math_LightPoint(vec2<f32>(_e302, _e262.uv.y), _e262.depth, _e262.is_inside);
                        let _e394 = lt_math_LightPoint(vec2<f32>(_e387.uv.x, _e316), _e387.depth, _e387.is_inside);
                        let _e398 = lt_math_LightPoint(_e394.uv, _e329, _e394.is_inside);
                        let _e402 = lt_math_LightPoint(_e398.uv, _e398.depth, _e380);
                        phi_1400_ = _e402;
                        phi_1401_ = (_e264 + 1u);
                        phi_1402_ = lt_math_LevelPoint(_e264, _e402);
                        phi_1403_ = true;
                    }
                    let _e406 = phi_1400_;
                    let _e408 = phi_1401_;
                    let _e410 = phi_1402_;
                    let _e412 = phi_1403_;
                    phi_1235_ = _e406;
                    phi_1238_ = _e408;
                    phi_1240_ = _e410;
                    phi_1404_ = _e412;
                } else {
                    phi_1235_ = lt_math_LightPoint();
                    phi_1238_ = u32();
                    phi_1240_ = lt_math_LevelPoint();
                    phi_1404_ = false;
                }
                let _e414 = phi_1235_;
                let _e416 = phi_1238_;
                let _e418 = phi_1240_;
                let _e420 = phi_1404_;
                continue;
                continuing {
                    phi_1234_ = _e414;
                    phi_1237_ = _e416;
                    phi_1239_ = _e418;
                    break if !(_e420);
                }
            }
            let _e423 = local_2;
            if _e423.point.is_inside {
                if (0f > 0f) {
                    let _e429 = local_3;
                    if (_e429.level < _e59) {
                    } else {
                        return;
                    }
                    let _e434 = levels.member[(0u + _e429.level)];
                    let _e440 = global[0u];
                    if (_e434.row_w.x == _e440) {
                        let _e443 = global[1u];
                        if (_e434.row_w.y == _e443) {
                            let _e446 = global[2u];
                            phi_1444_ = (_e434.row_w.z == _e446);
                            phi_1445_ = false;
                        } else {
                            phi_1444_ = bool();
                            phi_1445_ = true;
                        }
                        let _e449 = phi_1444_;
                        let _e451 = phi_1445_;
                        phi_1446_ = _e449;
                        phi_1447_ = _e451;
                    } else {
                        phi_1446_ = bool();
                        phi_1447_ = true;
                    }
                    let _e453 = phi_1446_;
                    let _e455 = phi_1447_;
                    if _e455 {
                        phi_1451_ = false;
                    } else {
                        phi_1451_ = _e453;
                    }
                    let _e457 = phi_1451_;
                    if _e457 {
                        let _e459 = samples.member[(0u + _e65.first_primitive)].normal;
                        let _e461 = p.member.map_size;
                        let _e531 = ((abs(((((_e434.row_x.x * _e459.x) + (_e434.row_x.y * _e459.y)) + (_e434.row_x.z * _e459.z)) / (((_e434.row_x.x * _e434.row_x.x) + (_e434.row_x.y * _e434.row_x.y)) + (_e434.row_x.z * _e434.row_x.z)))) + abs(((((_e434.row_y.x * _e459.x) + (_e434.row_y.y * _e459.y)) + (_e434.row_y.z * _e459.z)) / (((_e434.row_y.x * _e434.row_y.x) + (_e434.row_y.y * _e434.row_y.y)) + (_e434.row_y.z * _e434.row_y.z))))) / (abs(((((_e434.row_z.x * _e459.x) + (_e434.row_z.y * _e459.y)) + (_e434.row_z.z * _e459.z)) / (((_e434.row_z.x * _e434.row_z.x) + (_e434.row_z.y * _e434.row_z.y)) + (_e434.row_z.z * _e434.row_z.z)))) * f32(_e461)));
                        if (_e531 < 0.002f) {
                            phi_1533_ = _e531;
                        } else {
                            phi_1533_ = 0.002f;
                        }
                        let _e534 = phi_1533_;
                        phi_1652_ = _e534;
                    } else {
                        let _e536 = p.member.map_size;
                        let _e542 = samples.member[(0u + _e65.first_primitive)].position;
                        let _e553 = ((((_e434.row_w.x * _e542.x) + (_e434.row_w.y * _e542.y)) + (_e434.row_w.z * _e542.z)) + _e434.row_w.w);
                        let _e566 = ((_e434.row_x.x - (_e434.row_w.x * _e423.point.uv.x)) / _e553);
                        let _e567 = ((_e434.row_x.y - (_e434.row_w.y * _e423.point.uv.x)) / _e553);
                        let _e568 = ((_e434.row_x.z - (_e434.row_w.z * _e423.point.uv.x)) / _e553);
                        let _e581 = ((_e434.row_y.x - (_e434.row_w.x * _e423.point.uv.y)) / _e553);
                        let _e582 = ((_e434.row_y.y - (_e434.row_w.y * _e423.point.uv.y)) / _e553);
                        let _e583 = ((_e434.row_y.z - (_e434.row_w.z * _e423.point.uv.y)) / _e553);
                        let _e589 = samples.member[(0u + _e65.first_primitive)].normal;
                        let _e594 = ((_e582 * _e589.z) - (_e589.y * _e583));
                        let _e599 = ((_e583 * _e589.x) - (_e589.z * _e581));
                        let _e604 = ((_e581 * _e589.y) - (_e589.x * _e582));
                        let _e606 = samples.member[(0u + _e65.first_primitive)].normal;
                        let _e611 = ((_e567 * _e606.z) - (_e606.y * _e568));
                        let _e616 = ((_e568 * _e606.x) - (_e606.z * _e566));
                        let _e621 = ((_e566 * _e606.y) - (_e606.x * _e567));
                        let _e648 = ((abs(((((_e434.row_z.x * _e594) + (_e434.row_z.y * _e599)) + (_e434.row_z.z * _e604)) / (((_e566 * _e594) + (_e567 * _e599)) + (_e568 * _e604)))) + abs(((((_e434.row_z.x * _e611) + (_e434.row_z.y * _e616)) + (_e434.row_z.z * _e621)) / (((_e581 * _e611) + (_e582 * _e616)) + (_e583 * _e621))))) / f32(_e536));
                        let _e650 = (16f / f32(_e536));
                        if (_e648 < _e650) {
                            phi_1651_ = _e648;
                        } else {
                            phi_1651_ = _e650;
                        }
                        let _e653 = phi_1651_;
                        phi_1652_ = _e653;
                    }
                    let _e655 = phi_1652_;
                    phi_1655_ = (_e423.point.depth - (0f * _e655));
                } else {
                    phi_1655_ = _e423.point.depth;
                }
                let _e659 = phi_1655_;
                let _e665 = p.member.map_size;
                let _e666 = f32(_e665);
                let _e669 = ((_e423.point.uv.x * _e666) - 0.5f);
                let _e670 = ((_e423.point.uv.y * _e666) - 0.5f);
                if (_e669 > -8388608f) {
                    let _e682 = f32(select(0i, select(select(i32(_e669), i32(-2147483648), (_e669 < bitcast<f32>(3472883712u))), 2147483647i, (_e669 > bitcast<f32>(1325400063u))), (_e669 == _e669)));
                    if (_e682 > _e669) {
                        phi_1684_ = 1f;
                    } else {
                        phi_1684_ = 0f;
                    }
                    let _e685 = phi_1684_;
                    if (_e669 < 8388608f) {
                        phi_1689_ = (_e682 - _e685);
                        phi_1690_ = false;
                    } else {
                        phi_1689_ = f32();
                        phi_1690_ = true;
                    }
                    let _e688 = phi_1689_;
                    let _e690 = phi_1690_;
                    phi_1691_ = _e688;
                    phi_1692_ = _e690;
                } else {
                    phi_1691_ = f32();
                    phi_1692_ = true;
                }
                let _e692 = phi_1691_;
                let _e694 = phi_1692_;
                if _e694 {
                    phi_1696_ = _e669;
                } else {
                    phi_1696_ = _e692;
                }
                let _e696 = phi_1696_;
                if (_e670 > -8388608f) {
                    let _e708 = f32(select(0i, select(select(i32(_e670), i32(-2147483648), (_e670 < bitcast<f32>(3472883712u))), 2147483647i, (_e670 > bitcast<f32>(1325400063u))), (_e670 == _e670)));
                    if (_e708 > _e670) {
                        phi_1716_ = 1f;
                    } else {
                        phi_1716_ = 0f;
                    }
                    let _e711 = phi_1716_;
                    if (_e670 < 8388608f) {
                        phi_1721_ = (_e708 - _e711);
                        phi_1722_ = false;
                    } else {
                        phi_1721_ = f32();
                        phi_1722_ = true;
                    }
                    let _e714 = phi_1721_;
                    let _e716 = phi_1722_;
                    phi_1723_ = _e714;
                    phi_1724_ = _e716;
                } else {
                    phi_1723_ = f32();
                    phi_1724_ = true;
                }
                let _e718 = phi_1723_;
                let _e720 = phi_1724_;
                if _e720 {
                    phi_1728_ = _e670;
                } else {
                    phi_1728_ = _e718;
                }
                let _e722 = phi_1728_;
                let _e723 = (_e669 - _e696);
                let _e724 = (_e670 - _e722);
                let _e733 = select(0i, select(select(i32(_e696), i32(-2147483648), (_e696 < bitcast<f32>(3472883712u))), 2147483647i, (_e696 > bitcast<f32>(1325400063u))), (_e696 == _e696));
                let _e742 = select(0i, select(select(i32(_e722), i32(-2147483648), (_e722 < bitcast<f32>(3472883712u))), 2147483647i, (_e722 > bitcast<f32>(1325400063u))), (_e722 == _e722));
                let _e745 = ((1f - _e723) * (1f - _e724));
                let _e747 = (_e723 * (1f - _e724));
                let _e749 = ((1f - _e723) * _e724);
                let _e750 = (_e723 * _e724);
                let _e752 = p.member.test;
                let _e753 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e752);
                let _e755 = p.member.map_size;
                let _e757 = local_4;
                local_1 = _e753;
                let _e760 = ((_e757.level * _e755) * _e755);
                let _e762 = (bitcast<i32>(_e755) - 1i);
                if (_e733 > 0i) {
                    phi_1777_ = _e733;
                } else {
                    phi_1777_ = 0i;
                }
                let _e765 = phi_1777_;
                if (_e742 > 0i) {
                    phi_1782_ = _e742;
                } else {
                    phi_1782_ = 0i;
                }
                let _e768 = phi_1782_;
                if (_e765 < _e762) {
                    phi_1787_ = _e765;
                } else {
                    phi_1787_ = _e762;
                }
                let _e771 = phi_1787_;
                if (_e768 < _e762) {
                    phi_1792_ = _e768;
                } else {
                    phi_1792_ = _e762;
                }
                let _e774 = phi_1792_;
                let _e775 = bitcast<u32>(_e771);
                let _e777 = (_e733 + 1i);
                let _e778 = (_e742 + 1i);
                if (_e777 > 0i) {
                    phi_1801_ = _e777;
                } else {
                    phi_1801_ = 0i;
                }
                let _e781 = phi_1801_;
                if (_e778 > 0i) {
                    phi_1806_ = _e778;
                } else {
                    phi_1806_ = 0i;
                }
                let _e784 = phi_1806_;
                if (_e781 < _e762) {
                    phi_1811_ = _e781;
                } else {
                    phi_1811_ = _e762;
                }
                let _e787 = phi_1811_;
                if (_e784 < _e762) {
                    phi_1816_ = _e784;
                } else {
                    phi_1816_ = _e762;
                }
                let _e790 = phi_1816_;
                let _e791 = bitcast<u32>(_e787);
                let _e793 = (bitcast<u32>(_e774) * _e755);
                let _e794 = (bitcast<u32>(_e790) * _e755);
                let _e799 = ((_e793 + _e775) + _e760);
                let _e800 = ((_e793 + _e791) + _e760);
                let _e801 = ((_e794 + _e775) + _e760);
                let _e802 = ((_e794 + _e791) + _e760);
                if (_e799 < _e53) {
                } else {
                    return;
                }
                let _e806 = map.member[(0u + _e799)];
                if (_e800 < _e53) {
                } else {
                    return;
                }
                let _e818 = map.member[(0u + _e800)];
                if (_e801 < _e53) {
                } else {
                    return;
                }
                let _e834 = map.member[(0u + _e801)];
                if (_e802 < _e53) {
                } else {
                    return;
                }
                let _e850 = map.member[(0u + _e802)];
                let _e864 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_1), vec4<f32>(((((_e806.x * _e745) + (_e818.x * _e747)) + (_e834.x * _e749)) + (_e850.x * _e750)), ((((_e806.y * _e745) + (_e818.y * _e747)) + (_e834.y * _e749)) + (_e850.y * _e750)), ((((_e806.z * _e745) + (_e818.z * _e747)) + (_e834.z * _e749)) + (_e850.z * _e750)), ((((_e806.w * _e745) + (_e818.w * _e747)) + (_e834.w * _e749)) + (_e850.w * _e750))), _e659);
                let _e868 = p.member.epsilon;
                if (_e864 <= _e868) {
                    phi_1913_ = true;
                } else {
                    phi_1913_ = (_e864 >= (1f - _e868));
                }
                let _e873 = phi_1913_;
                if ((bitcast<u32>(_e864) & 2147483647u) > 2139095040u) {
                    phi_1921_ = true;
                } else {
                    phi_1921_ = !(_e873);
                }
                let _e879 = phi_1921_;
                if _e879 {
                    if (_e864 > 0f) {
                        if (_e864 < 1f) {
                            phi_1933_ = false;
                        } else {
                            phi_1933_ = true;
                        }
                        let _e883 = phi_1933_;
                        phi_1934_ = _e883;
                    } else {
                        phi_1934_ = true;
                    }
                    let _e885 = phi_1934_;
                    if _e885 {
                        phi_1938_ = 0.5f;
                    } else {
                        phi_1938_ = _e864;
                    }
                    let _e887 = phi_1938_;
                    phi_1946_ = evaluate_Verdict(_e887, true);
                } else {
                    if (_e864 > 0.5f) {
                        phi_1944_ = 1f;
                    } else {
                        phi_1944_ = 0f;
                    }
                    let _e891 = phi_1944_;
                    phi_1946_ = evaluate_Verdict(_e891, false);
                }
                let _e894 = phi_1946_;
                let _e897 = (_e894.visibility < 0.5f);
                if _e894.is_doubted {
                    phi_1969_ = evaluate_Verdict();
                    phi_1970_ = true;
                } else {
                    if _e897 {
                        phi_1956_ = 2u;
                    } else {
                        phi_1956_ = 1u;
                    }
                    let _e899 = phi_1956_;
                    if ((0u & _e899) != 0u) {
                        if _e897 {
                            phi_1965_ = 0.000000059604645f;
                        } else {
                            phi_1965_ = 0.99999994f;
                        }
                        let _e903 = phi_1965_;
                        phi_1967_ = evaluate_Verdict(_e903, true);
                        phi_1968_ = false;
                    } else {
                        phi_1967_ = evaluate_Verdict();
                        phi_1968_ = true;
                    }
                    let _e906 = phi_1967_;
                    let _e908 = phi_1968_;
                    phi_1969_ = _e906;
                    phi_1970_ = _e908;
                }
                let _e910 = phi_1969_;
                let _e912 = phi_1970_;
                if _e912 {
                    phi_1975_ = evaluate_Verdict(_e894.visibility, _e894.is_doubted);
                } else {
                    phi_1975_ = _e910;
                }
                let _e915 = phi_1975_;
                phi_1980_ = evaluate_Verdict(_e915.visibility, _e915.is_doubted);
            } else {
                phi_1980_ = evaluate_Verdict(0.5f, true);
            }
            let _e921 = phi_1980_;
            phi_1981_ = _e921;
        }
        let _e923 = phi_1981_;
        if (_e65.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e65.first_primitive)] = _e923.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_msm_hausdorff_prefiltered_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
