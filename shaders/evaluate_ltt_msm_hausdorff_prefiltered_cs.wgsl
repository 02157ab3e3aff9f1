struct lt_math_LightProjection {
    row_x: vec4<f32>,
    row_y: vec4<f32>,
    row_z: vec4<f32>,
    row_w: vec4<f32>,
}

struct type_8 {
    member: array<u32>,
}

struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_26 {
    member: array<abi_Sample>,
}

struct type_30 {
    member: array<f32>,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
}

struct type_40 {
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

struct type_43 {
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

struct type_51 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_26;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_43;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_30;
var<private> local_3: u32;
@group(0) @binding(4) 
var<storage, read_write> list: type_51;
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(2) 
var<storage> map: type_40;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_160_: lt_bvh_traverse_Tree;
    var phi_161_: bool;
    var phi_162_: lt_bvh_traverse_Tree;
    var phi_163_: bool;
    var phi_168_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_160_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_161_ = false;
        } else {
            phi_160_ = lt_bvh_traverse_Tree();
            phi_161_ = true;
        }
        let _e49 = phi_160_;
        let _e51 = phi_161_;
        phi_162_ = _e49;
        phi_163_ = _e51;
    } else {
        phi_162_ = lt_bvh_traverse_Tree();
        phi_163_ = true;
    }
    let _e53 = phi_162_;
    let _e55 = phi_163_;
    if _e55 {
        phi_168_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_168_ = _e53;
    }
    let _e60 = phi_168_;
    return lt_bvh_traverse_Tree(_e60.root, _e60.first_primitive);
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn lt_shaders_evaluate_to_light(param_4: vec3<f32>, param_5: vec4<f32>) -> vec3<f32> {
    return vec3<f32>((param_5.x - (param_4.x * param_5.w)), (param_5.y - (param_4.y * param_5.w)), (param_5.z - (param_4.z * param_5.w)));
}

fn lt_shaders_evaluate_quad_indices(param_6: i32, param_7: i32, param_8: u32) -> array<u32, 4> {
    var phi_202_: i32;
    var phi_207_: i32;
    var phi_212_: i32;
    var phi_217_: i32;
    var phi_226_: i32;
    var phi_231_: i32;
    var phi_236_: i32;
    var phi_241_: i32;

    let _e40 = (bitcast<i32>(param_8) - 1i);
    if (param_6 > 0i) {
        phi_202_ = param_6;
    } else {
        phi_202_ = 0i;
    }
    let _e43 = phi_202_;
    if (param_7 > 0i) {
        phi_207_ = param_7;
    } else {
        phi_207_ = 0i;
    }
    let _e46 = phi_207_;
    if (_e43 < _e40) {
        phi_212_ = _e43;
    } else {
        phi_212_ = _e40;
    }
    let _e49 = phi_212_;
    if (_e46 < _e40) {
        phi_217_ = _e46;
    } else {
        phi_217_ = _e40;
    }
    let _e52 = phi_217_;
    let _e53 = bitcast<u32>(_e49);
    let _e55 = (param_6 + 1i);
    let _e56 = (param_7 + 1i);
    if (_e55 > 0i) {
        phi_226_ = _e55;
    } else {
        phi_226_ = 0i;
    }
    let _e59 = phi_226_;
    if (_e56 > 0i) {
        phi_231_ = _e56;
    } else {
        phi_231_ = 0i;
    }
    let _e62 = phi_231_;
    if (_e59 < _e40) {
        phi_236_ = _e59;
    } else {
        phi_236_ = _e40;
    }
    let _e65 = phi_236_;
    if (_e62 < _e40) {
        phi_241_ = _e62;
    } else {
        phi_241_ = _e40;
    }
    let _e68 = phi_241_;
    let _e69 = bitcast<u32>(_e65);
    let _e71 = (bitcast<u32>(_e52) * param_8);
    let _e72 = (bitcast<u32>(_e68) * param_8);
    return array<u32, 4>((_e71 + _e53), (_e71 + _e69), (_e72 + _e53), (_e72 + _e69));
}

fn lt_math_hausdorff_cubic_mass(param_9: vec4<f32>, param_10: f32, param_11: f32, param_12: f32, param_13: f32) -> f32 {
    return ((((param_9.z - (((param_11 + param_12) + param_13) * param_9.y)) + ((((param_11 * param_12) + (param_11 * param_13)) + (param_12 * param_13)) * param_9.x)) - ((param_11 * param_12) * param_13)) / (((param_10 - param_11) * (param_10 - param_12)) * (param_10 - param_13)));
}

fn lt_math_hausdorff_endpoint_upper_bound(param_14: ptr<function, hankel_HankelFactors>, param_15: f32) -> f32 {
    var phi_574_: f32;
    var phi_575_: f32;
    var phi_576_: f32;
    var phi_602_: f32;
    var phi_603_: f32;
    var phi_604_: f32;
    var phi_605_: f32;
    var phi_606_: bool;
    var phi_607_: f32;
    var phi_608_: bool;
    var phi_636_: f32;
    var phi_637_: f32;
    var phi_638_: f32;
    var phi_639_: f32;
    var phi_640_: bool;
    var phi_641_: f32;
    var phi_642_: bool;
    var phi_649_: f32;
    var phi_650_: f32;
    var phi_651_: f32;
    var phi_652_: f32;

    let _e39 = (*param_14).moments;
    if (param_15 <= 0f) {
        phi_652_ = 1f;
    } else {
        let _e48 = ((_e39.z - ((1f + param_15) * _e39.y)) + (param_15 * _e39.x));
        let _e57 = (((_e39.w - ((1f + param_15) * _e39.z)) + (param_15 * _e39.y)) / _e48);
        if (abs(_e48) <= 0.00000047683716f) {
            let _e71 = (1f - (((_e39.y - (_e39.x * (param_15 + 1f))) + (param_15 * 1f)) / ((0f - param_15) * (0f - 1f))));
            if ((bitcast<u32>(_e71) & 2147483647u) > 2139095040u) {
                phi_576_ = _e71;
            } else {
                if (_e71 < 0f) {
                    phi_575_ = 0f;
                } else {
                    if (_e71 > 1f) {
                        phi_574_ = 1f;
                    } else {
                        phi_574_ = _e71;
                    }
                    let _e78 = phi_574_;
                    phi_575_ = _e78;
                }
                let _e80 = phi_575_;
                phi_576_ = _e80;
            }
            let _e82 = phi_576_;
            phi_651_ = _e82;
        } else {
            if (_e57 > 0f) {
                if (_e57 < param_15) {
                    let _e85 = lt_math_hausdorff_cubic_mass(_e39, param_15, 0f, _e57, 1f);
                    let _e86 = lt_math_hausdorff_cubic_mass(_e39, 1f, 0f, _e57, param_15);
                    let _e87 = (_e85 + _e86);
                    if ((bitcast<u32>(_e87) & 2147483647u) > 2139095040u) {
                        phi_604_ = _e87;
                    } else {
                        if (_e87 < 0f) {
                            phi_603_ = 0f;
                        } else {
                            if (_e87 > 1f) {
                                phi_602_ = 1f;
                            } else {
                                phi_602_ = _e87;
                            }
                            let _e94 = phi_602_;
                            phi_603_ = _e94;
                        }
                        let _e96 = phi_603_;
                        phi_604_ = _e96;
                    }
                    let _e98 = phi_604_;
                    phi_605_ = _e98;
                    phi_606_ = false;
                } else {
                    phi_605_ = f32();
                    phi_606_ = true;
                }
                let _e100 = phi_605_;
                let _e102 = phi_606_;
                phi_607_ = _e100;
                phi_608_ = _e102;
            } else {
                phi_607_ = f32();
                phi_608_ = true;
            }
            let _e104 = phi_607_;
            let _e106 = phi_608_;
            if _e106 {
                if (_e57 > param_15) {
                    if (_e57 < 1f) {
                        let _e109 = lt_math_hausdorff_cubic_mass(_e39, 0f, _e57, param_15, 1f);
                        let _e110 = (1f - _e109);
                        if ((bitcast<u32>(_e110) & 2147483647u) > 2139095040u) {
                            phi_638_ = _e110;
                        } else {
                            if (_e110 < 0f) {
                                phi_637_ = 0f;
                            } else {
                                if (_e110 > 1f) {
                                    phi_636_ = 1f;
                                } else {
                                    phi_636_ = _e110;
                                }
                                let _e117 = phi_636_;
                                phi_637_ = _e117;
                            }
                            let _e119 = phi_637_;
                            phi_638_ = _e119;
                        }
                        let _e121 = phi_638_;
                        phi_639_ = _e121;
                        phi_640_ = false;
                    } else {
                        phi_639_ = f32();
                        phi_640_ = true;
                    }
                    let _e123 = phi_639_;
                    let _e125 = phi_640_;
                    phi_641_ = _e123;
                    phi_642_ = _e125;
                } else {
                    phi_641_ = f32();
                    phi_642_ = true;
                }
                let _e127 = phi_641_;
                let _e129 = phi_642_;
                if _e129 {
                    phi_649_ = bitcast<f32>((bitcast<u32>(_e57) | 2143289344u));
                } else {
                    phi_649_ = _e127;
                }
                let _e134 = phi_649_;
                phi_650_ = _e134;
            } else {
                phi_650_ = _e104;
            }
            let _e136 = phi_650_;
            phi_651_ = _e136;
        }
        let _e138 = phi_651_;
        phi_652_ = _e138;
    }
    let _e140 = phi_652_;
    return _e140;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_16: ptr<function, f32>, param_17: vec4<f32>, param_18: f32) -> f32 {
    var local_1: hankel_HankelFactors;
    var phi_301_: f32;
    var phi_302_: f32;
    var phi_303_: f32;
    var phi_356_: vec2<f32>;
    var phi_419_: vec2<f32>;
    var phi_457_: f32;
    var phi_458_: f32;
    var phi_459_: f32;
    var phi_492_: f32;
    var phi_493_: f32;
    var phi_494_: f32;
    var phi_498_: f32;
    var phi_499_: f32;
    var phi_500_: f32;
    var phi_501_: f32;
    var phi_502_: bool;
    var phi_503_: f32;
    var phi_504_: bool;
    var phi_515_: f32;
    var phi_516_: f32;

    let _e40 = (*param_16);
    let _e41 = (1f - _e40);
    let _e50 = (0.5f * _e40);
    let _e51 = ((param_17.x * _e41) + _e50);
    let _e52 = ((param_17.y * _e41) + _e50);
    let _e53 = ((param_17.z * _e41) + _e50);
    let _e54 = ((param_17.w * _e41) + _e50);
    let _e57 = (_e52 - (_e51 * _e51));
    let _e59 = (_e53 - (_e51 * _e52));
    let _e65 = hankel_HankelFactors(vec4<f32>(_e51, _e52, _e53, _e54), _e57, _e59, (((_e54 - (_e52 * _e52)) * _e57) - (_e59 * _e59)));
    local_1 = hankel_HankelFactors(_e65.moments, _e65.d22_, _e65.l32_d22_, _e65.d33_d22_);
    if ((bitcast<u32>(param_18) & 2147483647u) > 2139095040u) {
        phi_303_ = param_18;
    } else {
        if (param_18 < 0f) {
            phi_302_ = 0f;
        } else {
            if (param_18 > 1f) {
                phi_301_ = 1f;
            } else {
                phi_301_ = param_18;
            }
            let _e77 = phi_301_;
            phi_302_ = _e77;
        }
        let _e79 = phi_302_;
        phi_303_ = _e79;
    }
    let _e81 = phi_303_;
    let _e84 = local_1.moments[0u];
    let _e87 = local_1.moments[1u];
    let _e95 = local_1.l32_d22_;
    let _e97 = local_1.d22_;
    let _e98 = (_e95 / _e97);
    let _e99 = (_e81 - _e84);
    let _e105 = local_1.d22_;
    let _e108 = local_1.d33_d22_;
    let _e109 = (((((_e81 * _e81) - _e87) - (_e98 * _e99)) * _e105) / _e108);
    let _e111 = local_1.d22_;
    let _e114 = ((_e99 / _e111) - (_e98 * _e109));
    let _e120 = ((0.5f * _e114) / _e109);
    let _e123 = ((_e120 * _e120) - (((1f - (_e114 * _e84)) - (_e109 * _e87)) / _e109));
    if (_e123 >= 0f) {
        let _e125 = sqrt(_e123);
        phi_356_ = vec2<f32>((-(_e120) - _e125), (-(_e120) + _e125));
    } else {
        phi_356_ = vec2(bitcast<f32>((bitcast<u32>(_e123) | 2143289344u)));
    }
    let _e136 = phi_356_;
    if (_e136.x >= 0f) {
        if (_e136.y <= 1f) {
            let _e143 = local_1.moments[0u];
            let _e146 = local_1.moments[1u];
            let _e154 = local_1.l32_d22_;
            let _e156 = local_1.d22_;
            let _e157 = (_e154 / _e156);
            let _e158 = (_e81 - _e143);
            let _e164 = local_1.d22_;
            let _e167 = local_1.d33_d22_;
            let _e168 = (((((_e81 * _e81) - _e146) - (_e157 * _e158)) * _e164) / _e167);
            let _e170 = local_1.d22_;
            let _e173 = ((_e158 / _e170) - (_e157 * _e168));
            let _e179 = ((0.5f * _e173) / _e168);
            let _e182 = ((_e179 * _e179) - (((1f - (_e173 * _e143)) - (_e168 * _e146)) / _e168));
            if (_e182 >= 0f) {
                let _e184 = sqrt(_e182);
                phi_419_ = vec2<f32>((-(_e179) - _e184), (-(_e179) + _e184));
            } else {
                phi_419_ = vec2(bitcast<f32>((bitcast<u32>(_e182) | 2143289344u)));
            }
            let _e195 = phi_419_;
            if (_e81 <= _e195.x) {
                phi_500_ = 1f;
            } else {
                if (_e81 > _e195.y) {
                    let _e201 = local_1.moments;
                    let _e212 = (((_e201.y - (_e201.x * (_e195.x + _e195.y))) + (_e195.x * _e195.y)) / ((_e81 - _e195.x) * (_e81 - _e195.y)));
                    if ((bitcast<u32>(_e212) & 2147483647u) > 2139095040u) {
                        phi_459_ = _e212;
                    } else {
                        if (_e212 < 0f) {
                            phi_458_ = 0f;
                        } else {
                            if (_e212 > 1f) {
                                phi_457_ = 1f;
                            } else {
                                phi_457_ = _e212;
                            }
                            let _e219 = phi_457_;
                            phi_458_ = _e219;
                        }
                        let _e221 = phi_458_;
                        phi_459_ = _e221;
                    }
                    let _e223 = phi_459_;
                    phi_499_ = _e223;
                } else {
                    if (_e81 > _e195.x) {
                        let _e226 = local_1.moments;
                        let _e238 = (1f - (((_e226.y - (_e226.x * (_e81 + _e195.y))) + (_e81 * _e195.y)) / ((_e195.x - _e81) * (_e195.x - _e195.y))));
                        if ((bitcast<u32>(_e238) & 2147483647u) > 2139095040u) {
                            phi_494_ = _e238;
                        } else {
                            if (_e238 < 0f) {
                                phi_493_ = 0f;
                            } else {
                                if (_e238 > 1f) {
                                    phi_492_ = 1f;
                                } else {
                                    phi_492_ = _e238;
                                }
                                let _e245 = phi_492_;
                                phi_493_ = _e245;
                            }
                            let _e247 = phi_493_;
                            phi_494_ = _e247;
                        }
                        let _e249 = phi_494_;
                        phi_498_ = _e249;
                    } else {
                        phi_498_ = bitcast<f32>((bitcast<u32>(_e195.x) | 2143289344u));
                    }
                    let _e254 = phi_498_;
                    phi_499_ = _e254;
                }
                let _e256 = phi_499_;
                phi_500_ = _e256;
            }
            let _e258 = phi_500_;
            phi_501_ = _e258;
            phi_502_ = false;
        } else {
            phi_501_ = f32();
            phi_502_ = true;
        }
        let _e260 = phi_501_;
        let _e262 = phi_502_;
        phi_503_ = _e260;
        phi_504_ = _e262;
    } else {
        phi_503_ = f32();
        phi_504_ = true;
    }
    let _e264 = phi_503_;
    let _e266 = phi_504_;
    if _e266 {
        if ((bitcast<u32>(_e136.x) & 2147483647u) > 2139095040u) {
            phi_515_ = _e136.x;
        } else {
            let _e270 = lt_math_hausdorff_endpoint_upper_bound((&local_1), _e81);
            phi_515_ = _e270;
        }
        let _e272 = phi_515_;
        phi_516_ = _e272;
    } else {
        phi_516_ = _e264;
    }
    let _e274 = phi_516_;
    return _e274;
}

fn function_() {
    var local_2: f32;
    var phi_735_: bool;
    var phi_736_: bool;
    var phi_737_: bool;
    var phi_738_: bool;
    var phi_742_: bool;
    var phi_777_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_781_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_874_: bool;
    var phi_875_: bool;
    var phi_876_: bool;
    var phi_877_: bool;
    var phi_878_: bool;
    var phi_879_: bool;
    var phi_880_: bool;
    var phi_881_: bool;
    var phi_882_: bool;
    var phi_883_: bool;
    var phi_884_: bool;
    var phi_885_: bool;
    var phi_889_: bool;
    var phi_1034_: bool;
    var phi_1042_: bool;
    var phi_1047_: f32;
    var phi_1050_: evaluate_Verdict;
    var phi_1051_: evaluate_Verdict;
    var phi_1055_: bool;
    var phi_1056_: u32;
    var phi_1062_: u32;

    let _e37 = id_1;
    let _e38 = local_3;
    let _e43 = arrayLength((&map.member));
    if (_e38 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    let _e50 = p.member.size[0u];
    let _e52 = p.member.size[1u];
    let _e53 = lt_shaders_entry_pixel_index(_e37, _e50, _e52);
    if (bitcast<i32>(_e53.root) != 0i) {
        let _e60 = p.member.light;
        let _e63 = samples.member[_e53.first_primitive].normal[0u];
        let _e65 = global[0u];
        if (_e63 == _e65) {
            let _e68 = samples.member[_e53.first_primitive].normal[1u];
            let _e70 = global[1u];
            if (_e68 == _e70) {
                let _e73 = samples.member[_e53.first_primitive].normal[2u];
                let _e75 = global[2u];
                phi_735_ = (_e73 == _e75);
                phi_736_ = false;
            } else {
                phi_735_ = bool();
                phi_736_ = true;
            }
            let _e78 = phi_735_;
            let _e80 = phi_736_;
            phi_737_ = _e78;
            phi_738_ = _e80;
        } else {
            phi_737_ = bool();
            phi_738_ = true;
        }
        let _e82 = phi_737_;
        let _e84 = phi_738_;
        if _e84 {
            phi_742_ = false;
        } else {
            phi_742_ = _e82;
        }
        let _e86 = phi_742_;
        if !(_e86) {
            let _e89 = samples.member[_e53.first_primitive].normal;
            let _e91 = samples.member[_e53.first_primitive].position;
            let _e92 = lt_shaders_evaluate_to_light(_e91, _e60);
            if ((((_e89.x * _e92.x) + (_e89.y * _e92.y)) + (_e89.z * _e92.z)) > 0f) {
                let _e106 = samples.member[_e53.first_primitive].flags;
                let _e114 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e120 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e114.unnamed.visibility, false), _e114.unnamed_1);
                phi_777_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e120.unnamed, ((_e106 & 1u) == 0u));
            } else {
                let _e129 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e135 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e129.unnamed.visibility, false), _e129.unnamed_1);
                phi_777_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e135.unnamed, true);
            }
            let _e140 = phi_777_;
            phi_781_ = _e140;
        } else {
            let _e146 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e152 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e146.unnamed.visibility, false), _e146.unnamed_1);
            phi_781_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e152.unnamed, true);
        }
        let _e157 = phi_781_;
        if _e157.unnamed_1 {
            phi_1051_ = evaluate_Verdict(_e157.unnamed.visibility, _e157.unnamed.is_doubted);
        } else {
            let _e165 = samples.member[_e53.first_primitive].position;
            let _e171 = p.member.projection.row_w;
            let _e182 = ((((_e171.x * _e165.x) + (_e171.y * _e165.y)) + (_e171.z * _e165.z)) + (_e171.w * 1f));
            let _e184 = p.member.projection.row_x;
            let _e196 = (((((_e184.x * _e165.x) + (_e184.y * _e165.y)) + (_e184.z * _e165.z)) + (_e184.w * 1f)) / _e182);
            let _e198 = p.member.projection.row_y;
            let _e210 = (((((_e198.x * _e165.x) + (_e198.y * _e165.y)) + (_e198.z * _e165.z)) + (_e198.w * 1f)) / _e182);
            let _e212 = p.member.projection.row_z;
            let _e223 = ((((_e212.x * _e165.x) + (_e212.y * _e165.y)) + (_e212.z * _e165.z)) + (_e212.w * 1f));
            if (_e182 > 0f) {
                if (_e196 >= 0f) {
                    if (_e196 <= 1f) {
                        if (_e210 >= 0f) {
                            if (_e210 <= 1f) {
                                if (_e223 >= 0f) {
                                    phi_874_ = (_e223 <= 1f);
                                    phi_875_ = false;
                                } else {
                                    phi_874_ = bool();
                                    phi_875_ = true;
                                }
                                let _e232 = phi_874_;
                                let _e234 = phi_875_;
                                phi_876_ = _e232;
                                phi_877_ = _e234;
                            } else {
                                phi_876_ = bool();
                                phi_877_ = true;
                            }
                            let _e236 = phi_876_;
                            let _e238 = phi_877_;
                            phi_878_ = _e236;
                            phi_879_ = _e238;
                        } else {
                            phi_878_ = bool();
                            phi_879_ = true;
                        }
                        let _e240 = phi_878_;
                        let _e242 = phi_879_;
                        phi_880_ = _e240;
                        phi_881_ = _e242;
                    } else {
                        phi_880_ = bool();
                        phi_881_ = true;
                    }
                    let _e244 = phi_880_;
                    let _e246 = phi_881_;
                    phi_882_ = _e244;
                    phi_883_ = _e246;
                } else {
                    phi_882_ = bool();
                    phi_883_ = true;
                }
                let _e248 = phi_882_;
                let _e250 = phi_883_;
                phi_884_ = _e248;
                phi_885_ = _e250;
            } else {
                phi_884_ = bool();
                phi_885_ = true;
            }
            let _e252 = phi_884_;
            let _e254 = phi_885_;
            if _e254 {
                phi_889_ = false;
            } else {
                phi_889_ = _e252;
            }
            let _e256 = phi_889_;
            if _e256 {
                let _e258 = p.member.map_size;
                let _e259 = f32(_e258);
                let _e262 = ((_e196 * _e259) - 0.5f);
                let _e263 = ((_e210 * _e259) - 0.5f);
                let _e264 = floor(_e262);
                let _e265 = floor(_e263);
                let _e266 = (_e262 - _e264);
                let _e267 = (_e263 - _e265);
                let _e288 = ((1f - _e266) * (1f - _e267));
                let _e290 = (_e266 * (1f - _e267));
                let _e292 = ((1f - _e266) * _e267);
                let _e293 = (_e266 * _e267);
                let _e295 = p.member.test;
                let _e296 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e295);
                let _e298 = p.member.map_size;
                local_2 = _e296;
                let _e299 = lt_shaders_evaluate_quad_indices(select(0i, select(select(i32(_e264), i32(-2147483648), (_e264 < bitcast<f32>(3472883712u))), 2147483647i, (_e264 > bitcast<f32>(1325400063u))), (_e264 == _e264)), select(0i, select(select(i32(_e265), i32(-2147483648), (_e265 < bitcast<f32>(3472883712u))), 2147483647i, (_e265 > bitcast<f32>(1325400063u))), (_e265 == _e265)), _e298);
                if (_e299[0] < _e43) {
                } else {
                    return;
                }
                let _e304 = map.member[(0u + _e299[0])];
                if (_e299[1] < _e43) {
                } else {
                    return;
                }
                let _e317 = map.member[(0u + _e299[1])];
                if (_e299[2] < _e43) {
                } else {
                    return;
                }
                let _e334 = map.member[(0u + _e299[2])];
                if (_e299[3] < _e43) {
                } else {
                    return;
                }
                let _e351 = map.member[(0u + _e299[3])];
                let _e365 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_2), vec4<f32>(((((_e304.x * _e288) + (_e317.x * _e290)) + (_e334.x * _e292)) + (_e351.x * _e293)), ((((_e304.y * _e288) + (_e317.y * _e290)) + (_e334.y * _e292)) + (_e351.y * _e293)), ((((_e304.z * _e288) + (_e317.z * _e290)) + (_e334.z * _e292)) + (_e351.z * _e293)), ((((_e304.w * _e288) + (_e317.w * _e290)) + (_e334.w * _e292)) + (_e351.w * _e293))), _e223);
                let _e367 = p.member.epsilon;
                if (_e365 <= _e367) {
                    phi_1034_ = true;
                } else {
                    phi_1034_ = (_e365 >= (1f - _e367));
                }
                let _e372 = phi_1034_;
                if ((bitcast<u32>(_e365) & 2147483647u) > 2139095040u) {
                    phi_1042_ = true;
                } else {
                    phi_1042_ = !(_e372);
                }
                let _e378 = phi_1042_;
                if (_e365 > 0.5f) {
                    phi_1047_ = 1f;
                } else {
                    phi_1047_ = 0f;
                }
                let _e381 = phi_1047_;
                phi_1050_ = evaluate_Verdict(_e381, _e378);
            } else {
                phi_1050_ = evaluate_Verdict(1f, true);
            }
            let _e385 = phi_1050_;
            phi_1051_ = _e385;
        }
        let _e387 = phi_1051_;
        visibility.member[_e53.first_primitive] = _e387.visibility;
        phi_1055_ = _e387.is_doubted;
        phi_1056_ = _e53.first_primitive;
    } else {
        phi_1055_ = false;
        phi_1056_ = 0u;
    }
    let _e392 = phi_1055_;
    let _e394 = phi_1056_;
    if _e392 {
        let _e396 = atomicAdd((&shared_[0u]), 1u);
        phi_1062_ = _e396;
    } else {
        phi_1062_ = 0u;
    }
    let _e398 = phi_1062_;
    workgroupBarrier();
    if (_e38 == 0u) {
        let _e402 = atomicLoad((&shared_[0u]));
        let _e403 = atomicAdd((&list.member[3u]), _e402);
        atomicStore((&shared_[1u]), _e403);
    }
    workgroupBarrier();
    if _e392 {
        let _e406 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e406) + _e398)]), _e394);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_msm_hausdorff_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_3 = local;
    function_();
}
