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

struct type_21 {
    member: array<abi_Sample>,
}

struct type_25 {
    member: array<f32>,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
}

struct type_34 {
    member: array<vec4<f32>>,
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

struct type_37 {
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
var<storage> samples: type_21;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_37;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_25;
@group(0) @binding(2) 
var<storage> map: type_34;

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
        let _e45 = phi_143_;
        let _e47 = phi_144_;
        phi_145_ = _e45;
        phi_146_ = _e47;
    } else {
        phi_145_ = lt_bvh_traverse_Tree();
        phi_146_ = true;
    }
    let _e49 = phi_145_;
    let _e51 = phi_146_;
    if _e51 {
        phi_151_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_151_ = _e49;
    }
    let _e56 = phi_151_;
    return lt_bvh_traverse_Tree(_e56.root, _e56.first_primitive);
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn lt_shaders_evaluate_to_light(param_4: vec3<f32>, param_5: vec4<f32>) -> vec3<f32> {
    return vec3<f32>((param_5.x - (param_4.x * param_5.w)), (param_5.y - (param_4.y * param_5.w)), (param_5.z - (param_4.z * param_5.w)));
}

fn lt_shaders_evaluate_quad_indices(param_6: i32, param_7: i32, param_8: u32) -> array<u32, 4> {
    var phi_185_: i32;
    var phi_190_: i32;
    var phi_195_: i32;
    var phi_200_: i32;
    var phi_209_: i32;
    var phi_214_: i32;
    var phi_219_: i32;
    var phi_224_: i32;

    let _e36 = (bitcast<i32>(param_8) - 1i);
    if (param_6 > 0i) {
        phi_185_ = param_6;
    } else {
        phi_185_ = 0i;
    }
    let _e39 = phi_185_;
    if (param_7 > 0i) {
        phi_190_ = param_7;
    } else {
        phi_190_ = 0i;
    }
    let _e42 = phi_190_;
    if (_e39 < _e36) {
        phi_195_ = _e39;
    } else {
        phi_195_ = _e36;
    }
    let _e45 = phi_195_;
    if (_e42 < _e36) {
        phi_200_ = _e42;
    } else {
        phi_200_ = _e36;
    }
    let _e48 = phi_200_;
    let _e49 = bitcast<u32>(_e45);
    let _e51 = (param_6 + 1i);
    let _e52 = (param_7 + 1i);
    if (_e51 > 0i) {
        phi_209_ = _e51;
    } else {
        phi_209_ = 0i;
    }
    let _e55 = phi_209_;
    if (_e52 > 0i) {
        phi_214_ = _e52;
    } else {
        phi_214_ = 0i;
    }
    let _e58 = phi_214_;
    if (_e55 < _e36) {
        phi_219_ = _e55;
    } else {
        phi_219_ = _e36;
    }
    let _e61 = phi_219_;
    if (_e58 < _e36) {
        phi_224_ = _e58;
    } else {
        phi_224_ = _e36;
    }
    let _e64 = phi_224_;
    let _e65 = bitcast<u32>(_e61);
    let _e67 = (bitcast<u32>(_e48) * param_8);
    let _e68 = (bitcast<u32>(_e64) * param_8);
    return array<u32, 4>((_e67 + _e49), (_e67 + _e65), (_e68 + _e49), (_e68 + _e65));
}

fn lt_math_hausdorff_cubic_mass(param_9: vec4<f32>, param_10: f32, param_11: f32, param_12: f32, param_13: f32) -> f32 {
    return ((((param_9.z - (((param_11 + param_12) + param_13) * param_9.y)) + ((((param_11 * param_12) + (param_11 * param_13)) + (param_12 * param_13)) * param_9.x)) - ((param_11 * param_12) * param_13)) / (((param_10 - param_11) * (param_10 - param_12)) * (param_10 - param_13)));
}

fn lt_math_hausdorff_endpoint_upper_bound(param_14: ptr<function, hankel_HankelFactors>, param_15: f32) -> f32 {
    var phi_557_: f32;
    var phi_558_: f32;
    var phi_559_: f32;
    var phi_585_: f32;
    var phi_586_: f32;
    var phi_587_: f32;
    var phi_588_: f32;
    var phi_589_: bool;
    var phi_590_: f32;
    var phi_591_: bool;
    var phi_619_: f32;
    var phi_620_: f32;
    var phi_621_: f32;
    var phi_622_: f32;
    var phi_623_: bool;
    var phi_624_: f32;
    var phi_625_: bool;
    var phi_632_: f32;
    var phi_633_: f32;
    var phi_634_: f32;
    var phi_635_: f32;

    let _e35 = (*param_14).moments;
    if (param_15 <= 0f) {
        phi_635_ = 1f;
    } else {
        let _e44 = ((_e35.z - ((1f + param_15) * _e35.y)) + (param_15 * _e35.x));
        let _e53 = (((_e35.w - ((1f + param_15) * _e35.z)) + (param_15 * _e35.y)) / _e44);
        if (abs(_e44) <= 0.00000047683716f) {
            let _e67 = (1f - (((_e35.y - (_e35.x * (param_15 + 1f))) + (param_15 * 1f)) / ((0f - param_15) * (0f - 1f))));
            if ((bitcast<u32>(_e67) & 2147483647u) > 2139095040u) {
                phi_559_ = _e67;
            } else {
                if (_e67 < 0f) {
                    phi_558_ = 0f;
                } else {
                    if (_e67 > 1f) {
                        phi_557_ = 1f;
                    } else {
                        phi_557_ = _e67;
                    }
                    let _e74 = phi_557_;
                    phi_558_ = _e74;
                }
                let _e76 = phi_558_;
                phi_559_ = _e76;
            }
            let _e78 = phi_559_;
            phi_634_ = _e78;
        } else {
            if (_e53 > 0f) {
                if (_e53 < param_15) {
                    let _e81 = lt_math_hausdorff_cubic_mass(_e35, param_15, 0f, _e53, 1f);
                    let _e82 = lt_math_hausdorff_cubic_mass(_e35, 1f, 0f, _e53, param_15);
                    let _e83 = (_e81 + _e82);
                    if ((bitcast<u32>(_e83) & 2147483647u) > 2139095040u) {
                        phi_587_ = _e83;
                    } else {
                        if (_e83 < 0f) {
                            phi_586_ = 0f;
                        } else {
                            if (_e83 > 1f) {
                                phi_585_ = 1f;
                            } else {
                                phi_585_ = _e83;
                            }
                            let _e90 = phi_585_;
                            phi_586_ = _e90;
                        }
                        let _e92 = phi_586_;
                        phi_587_ = _e92;
                    }
                    let _e94 = phi_587_;
                    phi_588_ = _e94;
                    phi_589_ = false;
                } else {
                    phi_588_ = f32();
                    phi_589_ = true;
                }
                let _e96 = phi_588_;
                let _e98 = phi_589_;
                phi_590_ = _e96;
                phi_591_ = _e98;
            } else {
                phi_590_ = f32();
                phi_591_ = true;
            }
            let _e100 = phi_590_;
            let _e102 = phi_591_;
            if _e102 {
                if (_e53 > param_15) {
                    if (_e53 < 1f) {
                        let _e105 = lt_math_hausdorff_cubic_mass(_e35, 0f, _e53, param_15, 1f);
                        let _e106 = (1f - _e105);
                        if ((bitcast<u32>(_e106) & 2147483647u) > 2139095040u) {
                            phi_621_ = _e106;
                        } else {
                            if (_e106 < 0f) {
                                phi_620_ = 0f;
                            } else {
                                if (_e106 > 1f) {
                                    phi_619_ = 1f;
                                } else {
                                    phi_619_ = _e106;
                                }
                                let _e113 = phi_619_;
                                phi_620_ = _e113;
                            }
                            let _e115 = phi_620_;
                            phi_621_ = _e115;
                        }
                        let _e117 = phi_621_;
                        phi_622_ = _e117;
                        phi_623_ = false;
                    } else {
                        phi_622_ = f32();
                        phi_623_ = true;
                    }
                    let _e119 = phi_622_;
                    let _e121 = phi_623_;
                    phi_624_ = _e119;
                    phi_625_ = _e121;
                } else {
                    phi_624_ = f32();
                    phi_625_ = true;
                }
                let _e123 = phi_624_;
                let _e125 = phi_625_;
                if _e125 {
                    phi_632_ = bitcast<f32>((bitcast<u32>(_e53) | 2143289344u));
                } else {
                    phi_632_ = _e123;
                }
                let _e130 = phi_632_;
                phi_633_ = _e130;
            } else {
                phi_633_ = _e100;
            }
            let _e132 = phi_633_;
            phi_634_ = _e132;
        }
        let _e134 = phi_634_;
        phi_635_ = _e134;
    }
    let _e136 = phi_635_;
    return _e136;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_16: ptr<function, f32>, param_17: vec4<f32>, param_18: f32) -> f32 {
    var local: hankel_HankelFactors;
    var phi_284_: f32;
    var phi_285_: f32;
    var phi_286_: f32;
    var phi_339_: vec2<f32>;
    var phi_402_: vec2<f32>;
    var phi_440_: f32;
    var phi_441_: f32;
    var phi_442_: f32;
    var phi_475_: f32;
    var phi_476_: f32;
    var phi_477_: f32;
    var phi_481_: f32;
    var phi_482_: f32;
    var phi_483_: f32;
    var phi_484_: f32;
    var phi_485_: bool;
    var phi_486_: f32;
    var phi_487_: bool;
    var phi_498_: f32;
    var phi_499_: f32;

    let _e36 = (*param_16);
    let _e37 = (1f - _e36);
    let _e46 = (0.5f * _e36);
    let _e47 = ((param_17.x * _e37) + _e46);
    let _e48 = ((param_17.y * _e37) + _e46);
    let _e49 = ((param_17.z * _e37) + _e46);
    let _e50 = ((param_17.w * _e37) + _e46);
    let _e53 = (_e48 - (_e47 * _e47));
    let _e55 = (_e49 - (_e47 * _e48));
    let _e61 = hankel_HankelFactors(vec4<f32>(_e47, _e48, _e49, _e50), _e53, _e55, (((_e50 - (_e48 * _e48)) * _e53) - (_e55 * _e55)));
    local = hankel_HankelFactors(_e61.moments, _e61.d22_, _e61.l32_d22_, _e61.d33_d22_);
    if ((bitcast<u32>(param_18) & 2147483647u) > 2139095040u) {
        phi_286_ = param_18;
    } else {
        if (param_18 < 0f) {
            phi_285_ = 0f;
        } else {
            if (param_18 > 1f) {
                phi_284_ = 1f;
            } else {
                phi_284_ = param_18;
            }
            let _e73 = phi_284_;
            phi_285_ = _e73;
        }
        let _e75 = phi_285_;
        phi_286_ = _e75;
    }
    let _e77 = phi_286_;
    let _e80 = local.moments[0u];
    let _e83 = local.moments[1u];
    let _e91 = local.l32_d22_;
    let _e93 = local.d22_;
    let _e94 = (_e91 / _e93);
    let _e95 = (_e77 - _e80);
    let _e101 = local.d22_;
    let _e104 = local.d33_d22_;
    let _e105 = (((((_e77 * _e77) - _e83) - (_e94 * _e95)) * _e101) / _e104);
    let _e107 = local.d22_;
    let _e110 = ((_e95 / _e107) - (_e94 * _e105));
    let _e116 = ((0.5f * _e110) / _e105);
    let _e119 = ((_e116 * _e116) - (((1f - (_e110 * _e80)) - (_e105 * _e83)) / _e105));
    if (_e119 >= 0f) {
        let _e121 = sqrt(_e119);
        phi_339_ = vec2<f32>((-(_e116) - _e121), (-(_e116) + _e121));
    } else {
        phi_339_ = vec2(bitcast<f32>((bitcast<u32>(_e119) | 2143289344u)));
    }
    let _e132 = phi_339_;
    if (_e132.x >= 0f) {
        if (_e132.y <= 1f) {
            let _e139 = local.moments[0u];
            let _e142 = local.moments[1u];
            let _e150 = local.l32_d22_;
            let _e152 = local.d22_;
            let _e153 = (_e150 / _e152);
            let _e154 = (_e77 - _e139);
            let _e160 = local.d22_;
            let _e163 = local.d33_d22_;
            let _e164 = (((((_e77 * _e77) - _e142) - (_e153 * _e154)) * _e160) / _e163);
            let _e166 = local.d22_;
            let _e169 = ((_e154 / _e166) - (_e153 * _e164));
            let _e175 = ((0.5f * _e169) / _e164);
            let _e178 = ((_e175 * _e175) - (((1f - (_e169 * _e139)) - (_e164 * _e142)) / _e164));
            if (_e178 >= 0f) {
                let _e180 = sqrt(_e178);
                phi_402_ = vec2<f32>((-(_e175) - _e180), (-(_e175) + _e180));
            } else {
                phi_402_ = vec2(bitcast<f32>((bitcast<u32>(_e178) | 2143289344u)));
            }
            let _e191 = phi_402_;
            if (_e77 <= _e191.x) {
                phi_483_ = 1f;
            } else {
                if (_e77 > _e191.y) {
                    let _e197 = local.moments;
                    let _e208 = (((_e197.y - (_e197.x * (_e191.x + _e191.y))) + (_e191.x * _e191.y)) / ((_e77 - _e191.x) * (_e77 - _e191.y)));
                    if ((bitcast<u32>(_e208) & 2147483647u) > 2139095040u) {
                        phi_442_ = _e208;
                    } else {
                        if (_e208 < 0f) {
                            phi_441_ = 0f;
                        } else {
                            if (_e208 > 1f) {
                                phi_440_ = 1f;
                            } else {
                                phi_440_ = _e208;
                            }
                            let _e215 = phi_440_;
                            phi_441_ = _e215;
                        }
                        let _e217 = phi_441_;
                        phi_442_ = _e217;
                    }
                    let _e219 = phi_442_;
                    phi_482_ = _e219;
                } else {
                    if (_e77 > _e191.x) {
                        let _e222 = local.moments;
                        let _e234 = (1f - (((_e222.y - (_e222.x * (_e77 + _e191.y))) + (_e77 * _e191.y)) / ((_e191.x - _e77) * (_e191.x - _e191.y))));
                        if ((bitcast<u32>(_e234) & 2147483647u) > 2139095040u) {
                            phi_477_ = _e234;
                        } else {
                            if (_e234 < 0f) {
                                phi_476_ = 0f;
                            } else {
                                if (_e234 > 1f) {
                                    phi_475_ = 1f;
                                } else {
                                    phi_475_ = _e234;
                                }
                                let _e241 = phi_475_;
                                phi_476_ = _e241;
                            }
                            let _e243 = phi_476_;
                            phi_477_ = _e243;
                        }
                        let _e245 = phi_477_;
                        phi_481_ = _e245;
                    } else {
                        phi_481_ = bitcast<f32>((bitcast<u32>(_e191.x) | 2143289344u));
                    }
                    let _e250 = phi_481_;
                    phi_482_ = _e250;
                }
                let _e252 = phi_482_;
                phi_483_ = _e252;
            }
            let _e254 = phi_483_;
            phi_484_ = _e254;
            phi_485_ = false;
        } else {
            phi_484_ = f32();
            phi_485_ = true;
        }
        let _e256 = phi_484_;
        let _e258 = phi_485_;
        phi_486_ = _e256;
        phi_487_ = _e258;
    } else {
        phi_486_ = f32();
        phi_487_ = true;
    }
    let _e260 = phi_486_;
    let _e262 = phi_487_;
    if _e262 {
        if ((bitcast<u32>(_e132.x) & 2147483647u) > 2139095040u) {
            phi_498_ = _e132.x;
        } else {
            let _e266 = lt_math_hausdorff_endpoint_upper_bound((&local), _e77);
            phi_498_ = _e266;
        }
        let _e268 = phi_498_;
        phi_499_ = _e268;
    } else {
        phi_499_ = _e260;
    }
    let _e270 = phi_499_;
    return _e270;
}

fn function_() {
    var local_1: f32;
    var phi_718_: bool;
    var phi_719_: bool;
    var phi_720_: bool;
    var phi_721_: bool;
    var phi_725_: bool;
    var phi_760_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_764_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_857_: bool;
    var phi_858_: bool;
    var phi_859_: bool;
    var phi_860_: bool;
    var phi_861_: bool;
    var phi_862_: bool;
    var phi_863_: bool;
    var phi_864_: bool;
    var phi_865_: bool;
    var phi_866_: bool;
    var phi_867_: bool;
    var phi_868_: bool;
    var phi_872_: bool;
    var phi_1011_: evaluate_Verdict;
    var phi_1012_: evaluate_Verdict;
    var phi_1013_: bool;
    var phi_1014_: evaluate_Verdict;
    var phi_1015_: evaluate_Verdict;
    var phi_1016_: bool;
    var phi_1020_: evaluate_Verdict;

    let _e33 = id_1;
    let _e40 = arrayLength((&map.member));
    let _e46 = p.member.size[0u];
    let _e48 = p.member.size[1u];
    let _e49 = lt_shaders_entry_pixel_index(_e33, _e46, _e48);
    if (bitcast<i32>(_e49.root) != 0i) {
        if (_e49.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e58 = p.member.light;
        let _e61 = samples.member[(0u + _e49.first_primitive)].normal[0u];
        let _e63 = global[0u];
        if (_e61 == _e63) {
            let _e66 = samples.member[(0u + _e49.first_primitive)].normal[1u];
            let _e68 = global[1u];
            if (_e66 == _e68) {
                let _e71 = samples.member[(0u + _e49.first_primitive)].normal[2u];
                let _e73 = global[2u];
                phi_718_ = (_e71 == _e73);
                phi_719_ = false;
            } else {
                phi_718_ = bool();
                phi_719_ = true;
            }
            let _e76 = phi_718_;
            let _e78 = phi_719_;
            phi_720_ = _e76;
            phi_721_ = _e78;
        } else {
            phi_720_ = bool();
            phi_721_ = true;
        }
        let _e80 = phi_720_;
        let _e82 = phi_721_;
        if _e82 {
            phi_725_ = false;
        } else {
            phi_725_ = _e80;
        }
        let _e84 = phi_725_;
        if !(_e84) {
            let _e87 = samples.member[(0u + _e49.first_primitive)].normal;
            let _e89 = samples.member[(0u + _e49.first_primitive)].position;
            let _e90 = lt_shaders_evaluate_to_light(_e89, _e58);
            if ((((_e87.x * _e90.x) + (_e87.y * _e90.y)) + (_e87.z * _e90.z)) > 0f) {
                let _e104 = samples.member[(0u + _e49.first_primitive)].flags;
                let _e112 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e118 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e112.unnamed.visibility, false), _e112.unnamed_1);
                phi_760_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e118.unnamed, ((_e104 & 1u) == 0u));
            } else {
                let _e127 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e133 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e127.unnamed.visibility, false), _e127.unnamed_1);
                phi_760_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e133.unnamed, true);
            }
            let _e138 = phi_760_;
            phi_764_ = _e138;
        } else {
            let _e144 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e150 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e144.unnamed.visibility, false), _e144.unnamed_1);
            phi_764_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e150.unnamed, true);
        }
        let _e155 = phi_764_;
        if _e155.unnamed_1 {
            phi_1014_ = evaluate_Verdict(_e155.unnamed.visibility, _e155.unnamed.is_doubted);
            phi_1015_ = evaluate_Verdict();
            phi_1016_ = true;
        } else {
            let _e163 = samples.member[(0u + _e49.first_primitive)].position;
            let _e169 = p.member.projection.row_w;
            let _e180 = ((((_e169.x * _e163.x) + (_e169.y * _e163.y)) + (_e169.z * _e163.z)) + (_e169.w * 1f));
            let _e182 = p.member.projection.row_x;
            let _e194 = (((((_e182.x * _e163.x) + (_e182.y * _e163.y)) + (_e182.z * _e163.z)) + (_e182.w * 1f)) / _e180);
            let _e196 = p.member.projection.row_y;
            let _e208 = (((((_e196.x * _e163.x) + (_e196.y * _e163.y)) + (_e196.z * _e163.z)) + (_e196.w * 1f)) / _e180);
            let _e210 = p.member.projection.row_z;
            let _e221 = ((((_e210.x * _e163.x) + (_e210.y * _e163.y)) + (_e210.z * _e163.z)) + (_e210.w * 1f));
            if (_e180 > 0f) {
                if (_e194 >= 0f) {
                    if (_e194 <= 1f) {
                        if (_e208 >= 0f) {
                            if (_e208 <= 1f) {
                                if (_e221 >= 0f) {
                                    phi_857_ = (_e221 <= 1f);
                                    phi_858_ = false;
                                } else {
                                    phi_857_ = bool();
                                    phi_858_ = true;
                                }
                                let _e230 = phi_857_;
                                let _e232 = phi_858_;
                                phi_859_ = _e230;
                                phi_860_ = _e232;
                            } else {
                                phi_859_ = bool();
                                phi_860_ = true;
                            }
                            let _e234 = phi_859_;
                            let _e236 = phi_860_;
                            phi_861_ = _e234;
                            phi_862_ = _e236;
                        } else {
                            phi_861_ = bool();
                            phi_862_ = true;
                        }
                        let _e238 = phi_861_;
                        let _e240 = phi_862_;
                        phi_863_ = _e238;
                        phi_864_ = _e240;
                    } else {
                        phi_863_ = bool();
                        phi_864_ = true;
                    }
                    let _e242 = phi_863_;
                    let _e244 = phi_864_;
                    phi_865_ = _e242;
                    phi_866_ = _e244;
                } else {
                    phi_865_ = bool();
                    phi_866_ = true;
                }
                let _e246 = phi_865_;
                let _e248 = phi_866_;
                phi_867_ = _e246;
                phi_868_ = _e248;
            } else {
                phi_867_ = bool();
                phi_868_ = true;
            }
            let _e250 = phi_867_;
            let _e252 = phi_868_;
            if _e252 {
                phi_872_ = false;
            } else {
                phi_872_ = _e250;
            }
            let _e254 = phi_872_;
            if _e254 {
                let _e256 = p.member.map_size;
                let _e257 = f32(_e256);
                let _e260 = ((_e194 * _e257) - 0.5f);
                let _e261 = ((_e208 * _e257) - 0.5f);
                let _e262 = floor(_e260);
                let _e263 = floor(_e261);
                let _e264 = (_e260 - _e262);
                let _e265 = (_e261 - _e263);
                let _e286 = ((1f - _e264) * (1f - _e265));
                let _e288 = (_e264 * (1f - _e265));
                let _e290 = ((1f - _e264) * _e265);
                let _e291 = (_e264 * _e265);
                let _e293 = p.member.test;
                let _e294 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e293);
                let _e296 = p.member.map_size;
                local_1 = _e294;
                let _e297 = lt_shaders_evaluate_quad_indices(select(0i, select(select(i32(_e262), i32(-2147483648), (_e262 < bitcast<f32>(3472883712u))), 2147483647i, (_e262 > bitcast<f32>(1325400063u))), (_e262 == _e262)), select(0i, select(select(i32(_e263), i32(-2147483648), (_e263 < bitcast<f32>(3472883712u))), 2147483647i, (_e263 > bitcast<f32>(1325400063u))), (_e263 == _e263)), _e296);
                if (_e297[0] < _e40) {
                } else {
                    return;
                }
                let _e302 = map.member[(0u + _e297[0])];
                if (_e297[1] < _e40) {
                } else {
                    return;
                }
                let _e315 = map.member[(0u + _e297[1])];
                if (_e297[2] < _e40) {
                } else {
                    return;
                }
                let _e332 = map.member[(0u + _e297[2])];
                if (_e297[3] < _e40) {
                } else {
                    return;
                }
                let _e349 = map.member[(0u + _e297[3])];
                let _e363 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_1), vec4<f32>(((((_e302.x * _e286) + (_e315.x * _e288)) + (_e332.x * _e290)) + (_e349.x * _e291)), ((((_e302.y * _e286) + (_e315.y * _e288)) + (_e332.y * _e290)) + (_e349.y * _e291)), ((((_e302.z * _e286) + (_e315.z * _e288)) + (_e332.z * _e290)) + (_e349.z * _e291)), ((((_e302.w * _e286) + (_e315.w * _e288)) + (_e332.w * _e290)) + (_e349.w * _e291))), _e221);
                phi_1011_ = evaluate_Verdict(_e363, false);
                phi_1012_ = evaluate_Verdict();
                phi_1013_ = false;
            } else {
                phi_1011_ = evaluate_Verdict();
                phi_1012_ = evaluate_Verdict(1f, false);
                phi_1013_ = true;
            }
            let _e367 = phi_1011_;
            let _e369 = phi_1012_;
            let _e371 = phi_1013_;
            phi_1014_ = _e369;
            phi_1015_ = _e367;
            phi_1016_ = _e371;
        }
        let _e373 = phi_1014_;
        let _e375 = phi_1015_;
        let _e377 = phi_1016_;
        if _e377 {
            phi_1020_ = _e373;
        } else {
            phi_1020_ = _e375;
        }
        let _e379 = phi_1020_;
        if (_e49.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e49.first_primitive)] = _e379.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_msm_hausdorff_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
