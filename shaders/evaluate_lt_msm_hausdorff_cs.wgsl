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

struct type_30 {
    member: abi_ShadowParams,
}

struct lt_math_OneLevel {
    projection: lt_math_LightProjection,
}

struct lt_bvh_slab_Span {
    near: f32,
    far: f32,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_15;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_30;
@group(0) @binding(2) 
var<storage> map: type_19;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_19;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_138_: lt_bvh_traverse_Tree;
    var phi_139_: bool;
    var phi_140_: lt_bvh_traverse_Tree;
    var phi_141_: bool;
    var phi_146_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_138_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_139_ = false;
        } else {
            phi_138_ = lt_bvh_traverse_Tree();
            phi_139_ = true;
        }
        let _e52 = phi_138_;
        let _e54 = phi_139_;
        phi_140_ = _e52;
        phi_141_ = _e54;
    } else {
        phi_140_ = lt_bvh_traverse_Tree();
        phi_141_ = true;
    }
    let _e56 = phi_140_;
    let _e58 = phi_141_;
    if _e58 {
        phi_146_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_146_ = _e56;
    }
    let _e63 = phi_146_;
    return lt_bvh_traverse_Tree(_e63.root, _e63.first_primitive);
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_173_: f32;
    var phi_174_: f32;
    var phi_175_: f32;
    var phi_192_: f32;
    var phi_193_: f32;
    var phi_194_: f32;
    var phi_210_: f32;
    var phi_211_: f32;
    var phi_212_: f32;
    var phi_228_: f32;
    var phi_229_: f32;
    var phi_230_: f32;
    var phi_246_: f32;
    var phi_247_: f32;
    var phi_248_: f32;
    var phi_283_: bool;
    var phi_284_: bool;
    var phi_285_: bool;
    var phi_286_: bool;
    var phi_287_: bool;
    var phi_288_: bool;
    var phi_292_: bool;
    var phi_603_: f32;
    var phi_604_: f32;
    var phi_605_: f32;
    var phi_622_: f32;
    var phi_623_: f32;
    var phi_624_: f32;
    var phi_641_: f32;
    var phi_642_: f32;
    var phi_643_: f32;
    var phi_660_: f32;
    var phi_661_: f32;
    var phi_662_: f32;
    var phi_685_: f32;
    var phi_686_: f32;
    var phi_687_: f32;
    var phi_734_: f32;
    var phi_735_: f32;
    var phi_736_: f32;
    var phi_753_: f32;
    var phi_754_: f32;
    var phi_755_: f32;
    var phi_772_: f32;
    var phi_773_: f32;
    var phi_774_: f32;
    var phi_791_: f32;
    var phi_792_: f32;
    var phi_793_: f32;
    var phi_816_: f32;
    var phi_817_: f32;
    var phi_818_: f32;
    var phi_897_: bool;
    var phi_941_: f32;
    var phi_942_: f32;
    var phi_943_: bool;
    var phi_944_: f32;
    var phi_945_: bool;
    var phi_946_: f32;
    var phi_947_: bool;
    var phi_951_: f32;
    var phi_952_: f32;
    var phi_971_: f32;
    var phi_972_: f32;
    var phi_973_: f32;
    var phi_984_: f32;
    var phi_999_: f32;
    var phi_1001_: lt_bvh_slab_Span;
    var phi_1059_: f32;
    var phi_1060_: f32;
    var phi_1061_: f32;
    var phi_1062_: f32;
    var phi_1063_: f32;
    var phi_1064_: bool;
    var phi_1068_: f32;
    var phi_1083_: f32;
    var phi_1084_: f32;
    var phi_1085_: f32;
    var phi_1086_: f32;
    var phi_1087_: f32;
    var phi_1088_: f32;
    var phi_1089_: f32;
    var phi_1090_: bool;
    var phi_1094_: f32;
    var phi_1095_: f32;
    var phi_1096_: bool;
    var phi_1097_: f32;
    var phi_1098_: f32;
    var phi_1099_: bool;
    var phi_1103_: f32;

    let _e43 = (*param_4);
    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_175_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_174_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_173_ = 1f;
            } else {
                phi_173_ = param_7;
            }
            let _e50 = phi_173_;
            phi_174_ = _e50;
        }
        let _e52 = phi_174_;
        phi_175_ = _e52;
    }
    let _e54 = phi_175_;
    let _e55 = (_e54 - 0.00000047683716f);
    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_194_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_193_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_192_ = 1f;
            } else {
                phi_192_ = param_5.x;
            }
            let _e63 = phi_192_;
            phi_193_ = _e63;
        }
        let _e65 = phi_193_;
        phi_194_ = _e65;
    }
    let _e67 = phi_194_;
    if ((bitcast<u32>(param_5.y) & 2147483647u) > 2139095040u) {
        phi_212_ = param_5.y;
    } else {
        if (param_5.y < 0f) {
            phi_211_ = 0f;
        } else {
            if (param_5.y > 1f) {
                phi_210_ = 1f;
            } else {
                phi_210_ = param_5.y;
            }
            let _e75 = phi_210_;
            phi_211_ = _e75;
        }
        let _e77 = phi_211_;
        phi_212_ = _e77;
    }
    let _e79 = phi_212_;
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_230_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_229_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_228_ = 1f;
            } else {
                phi_228_ = param_5.z;
            }
            let _e87 = phi_228_;
            phi_229_ = _e87;
        }
        let _e89 = phi_229_;
        phi_230_ = _e89;
    }
    let _e91 = phi_230_;
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_248_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_247_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_246_ = 1f;
            } else {
                phi_246_ = param_5.w;
            }
            let _e99 = phi_246_;
            phi_247_ = _e99;
        }
        let _e101 = phi_247_;
        phi_248_ = _e101;
    }
    let _e103 = phi_248_;
    let _e104 = (_e67 - _e55);
    let _e105 = (_e79 - _e55);
    let _e106 = (_e91 - _e55);
    let _e107 = (_e103 - _e55);
    let _e118 = ((((_e104 * param_6.x) + (_e105 * param_6.y)) + (_e106 * param_6.z)) + (_e107 * param_6.w));
    if ((bitcast<u32>(_e118) & 2147483647u) > 2139095040u) {
        phi_1097_ = _e118;
        phi_1098_ = f32();
        phi_1099_ = true;
    } else {
        if (_e104 >= 0f) {
            if (_e105 >= 0f) {
                if (_e106 >= 0f) {
                    phi_283_ = (_e107 >= 0f);
                    phi_284_ = false;
                } else {
                    phi_283_ = bool();
                    phi_284_ = true;
                }
                let _e127 = phi_283_;
                let _e129 = phi_284_;
                phi_285_ = _e127;
                phi_286_ = _e129;
            } else {
                phi_285_ = bool();
                phi_286_ = true;
            }
            let _e131 = phi_285_;
            let _e133 = phi_286_;
            phi_287_ = _e131;
            phi_288_ = _e133;
        } else {
            phi_287_ = bool();
            phi_288_ = true;
        }
        let _e135 = phi_287_;
        let _e137 = phi_288_;
        if _e137 {
            phi_292_ = false;
        } else {
            phi_292_ = _e135;
        }
        let _e139 = phi_292_;
        if _e139 {
            phi_1094_ = 1f;
            phi_1095_ = f32();
            phi_1096_ = true;
        } else {
            let _e140 = (0.5f * _e43);
            let _e141 = (1f - _e43);
            let _e143 = (param_6.x * _e141);
            let _e145 = (param_6.y * _e141);
            let _e147 = (param_6.z * _e141);
            let _e149 = (param_6.w * _e141);
            let _e150 = -(_e55);
            let _e151 = (1f - _e55);
            let _e153 = (vec4<f32>(1f, 1f, 1f, 1f).x - _e67);
            let _e155 = (vec4<f32>(1f, 1f, 1f, 1f).y - _e79);
            let _e157 = (vec4<f32>(1f, 1f, 1f, 1f).z - _e91);
            let _e159 = (vec4<f32>(1f, 1f, 1f, 1f).w - _e103);
            let _e160 = (_e104 - _e105);
            let _e161 = (_e105 - _e106);
            let _e162 = (_e106 - _e107);
            let _e163 = (_e107 - _e104);
            let _e164 = (_e160 * _e160);
            let _e165 = (_e161 * _e161);
            let _e166 = (_e162 * _e162);
            let _e167 = (_e163 * _e163);
            let _e168 = (_e104 - _e106);
            let _e169 = (_e105 - _e107);
            let _e170 = (_e106 - _e104);
            let _e171 = (_e107 - _e105);
            let _e172 = (_e168 * _e168);
            let _e173 = (_e169 * _e169);
            let _e174 = (_e170 * _e170);
            let _e175 = (_e171 * _e171);
            let _e180 = ((_e143 * _e145) * _e164);
            let _e181 = ((_e145 * _e147) * _e165);
            let _e182 = ((_e147 * _e149) * _e166);
            let _e183 = ((_e149 * _e143) * _e167);
            let _e192 = (((0.5f * _e143) * _e147) * _e172);
            let _e193 = (((0.5f * _e145) * _e149) * _e173);
            let _e194 = (((0.5f * _e147) * _e143) * _e174);
            let _e195 = (((0.5f * _e149) * _e145) * _e175);
            let _e196 = (_e104 * _e105);
            let _e197 = (_e105 * _e106);
            let _e198 = (_e106 * _e107);
            let _e199 = (_e107 * _e104);
            let _e200 = (_e104 * _e106);
            let _e201 = (_e105 * _e107);
            let _e202 = (_e106 * _e104);
            let _e203 = (_e107 * _e105);
            let _e204 = (_e180 * _e196);
            let _e205 = (_e181 * _e197);
            let _e206 = (_e182 * _e198);
            let _e207 = (_e183 * _e199);
            let _e208 = (_e192 * _e200);
            let _e209 = (_e193 * _e201);
            let _e210 = (_e194 * _e202);
            let _e211 = (_e195 * _e203);
            let _e212 = (_e67 * _e67);
            let _e213 = (_e79 * _e79);
            let _e214 = (_e91 * _e91);
            let _e215 = (_e103 * _e103);
            let _e216 = (_e153 * _e153);
            let _e217 = (_e155 * _e155);
            let _e218 = (_e157 * _e157);
            let _e219 = (_e159 * _e159);
            let _e220 = (_e140 * _e143);
            let _e221 = (_e140 * _e145);
            let _e222 = (_e140 * _e147);
            let _e223 = (_e140 * _e149);
            let _e232 = (((_e220 * _e104) * _e212) * _e150);
            let _e233 = (((_e221 * _e105) * _e213) * _e150);
            let _e234 = (((_e222 * _e106) * _e214) * _e150);
            let _e235 = (((_e223 * _e107) * _e215) * _e150);
            let _e244 = (((_e220 * _e104) * _e216) * _e151);
            let _e245 = (((_e221 * _e105) * _e217) * _e151);
            let _e246 = (((_e222 * _e106) * _e218) * _e151);
            let _e247 = (((_e223 * _e107) * _e219) * _e151);
            let _e415 = (((((((_e180 * _e147) * _e165) * _e172) + (_e140 * (((_e180 * ((_e212 * _e213) + (_e216 * _e217))) + (_e192 * ((_e212 * _e214) + (_e216 * _e218)))) + ((_e220 * _e212) * _e216)))) + ((((_e181 * _e149) * _e166) * _e173) + (_e140 * (((_e181 * ((_e213 * _e214) + (_e217 * _e218))) + (_e193 * ((_e213 * _e215) + (_e217 * _e219)))) + ((_e221 * _e213) * _e217))))) + ((((_e182 * _e143) * _e167) * _e174) + (_e140 * (((_e182 * ((_e214 * _e215) + (_e218 * _e219))) + (_e194 * ((_e214 * _e212) + (_e218 * _e216)))) + ((_e222 * _e214) * _e218))))) + ((((_e183 * _e145) * _e164) * _e175) + (_e140 * (((_e183 * ((_e215 * _e212) + (_e219 * _e216))) + (_e195 * ((_e215 * _e213) + (_e219 * _e217)))) + ((_e223 * _e215) * _e219)))));
            let _e418 = (((_e140 * _e140) * _e150) * _e151);
            let _e421 = (((((((_e204 * _e196) + (_e208 * _e200)) + (_e104 * ((_e232 * _e150) + (_e244 * _e151)))) + (((_e205 * _e197) + (_e209 * _e201)) + (_e105 * ((_e233 * _e150) + (_e245 * _e151))))) + (((_e206 * _e198) + (_e210 * _e202)) + (_e106 * ((_e234 * _e150) + (_e246 * _e151))))) + (((_e207 * _e199) + (_e211 * _e203)) + (_e107 * ((_e235 * _e150) + (_e247 * _e151))))) + ((_e418 * _e150) * _e151));
            if (_e421 < 0.0000000000000000000000000000000001f) {
                if ((bitcast<u32>(_e104) & 2147483647u) > 2139095040u) {
                    phi_605_ = _e104;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_604_ = 0f;
                    } else {
                        if (_e104 < 0f) {
                            phi_603_ = 0f;
                        } else {
                            phi_603_ = 1f;
                        }
                        let _e436 = phi_603_;
                        phi_604_ = _e436;
                    }
                    let _e438 = phi_604_;
                    phi_605_ = _e438;
                }
                let _e440 = phi_605_;
                if ((bitcast<u32>(_e105) & 2147483647u) > 2139095040u) {
                    phi_624_ = _e105;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_623_ = 0f;
                    } else {
                        if (_e105 < 0f) {
                            phi_622_ = 0f;
                        } else {
                            phi_622_ = 1f;
                        }
                        let _e449 = phi_622_;
                        phi_623_ = _e449;
                    }
                    let _e451 = phi_623_;
                    phi_624_ = _e451;
                }
                let _e453 = phi_624_;
                if ((bitcast<u32>(_e106) & 2147483647u) > 2139095040u) {
                    phi_643_ = _e106;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_642_ = 0f;
                    } else {
                        if (_e106 < 0f) {
                            phi_641_ = 0f;
                        } else {
                            phi_641_ = 1f;
                        }
                        let _e462 = phi_641_;
                        phi_642_ = _e462;
                    }
                    let _e464 = phi_642_;
                    phi_643_ = _e464;
                }
                let _e466 = phi_643_;
                if ((bitcast<u32>(_e107) & 2147483647u) > 2139095040u) {
                    phi_662_ = _e107;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_661_ = 0f;
                    } else {
                        if (_e107 < 0f) {
                            phi_660_ = 0f;
                        } else {
                            phi_660_ = 1f;
                        }
                        let _e475 = phi_660_;
                        phi_661_ = _e475;
                    }
                    let _e477 = phi_661_;
                    phi_662_ = _e477;
                }
                let _e479 = phi_662_;
                let _e487 = (((((_e440 * _e143) + (_e453 * _e145)) + (_e466 * _e147)) + (_e479 * _e149)) + _e140);
                if ((bitcast<u32>(_e487) & 2147483647u) > 2139095040u) {
                    phi_687_ = _e487;
                } else {
                    if (_e487 < 0f) {
                        phi_686_ = 0f;
                    } else {
                        if (_e487 > 1f) {
                            phi_685_ = 1f;
                        } else {
                            phi_685_ = _e487;
                        }
                        let _e494 = phi_685_;
                        phi_686_ = _e494;
                    }
                    let _e496 = phi_686_;
                    phi_687_ = _e496;
                }
                let _e498 = phi_687_;
                phi_1088_ = _e498;
                phi_1089_ = f32();
                phi_1090_ = true;
            } else {
                let _e503 = ((_e143 * _e67) * _e153);
                let _e504 = ((_e145 * _e79) * _e155);
                let _e505 = ((_e147 * _e91) * _e157);
                let _e506 = ((_e149 * _e103) * _e159);
                let _e513 = ((((_e503 * _e104) + (_e504 * _e105)) + (_e505 * _e106)) + (_e506 * _e107));
                let _e524 = ((((_e503 * (_e104 * _e104)) + (_e504 * (_e105 * _e105))) + (_e505 * (_e106 * _e106))) + (_e506 * (_e107 * _e107)));
                if (_e524 < 0.0000000000000000000000000000000001f) {
                    if ((bitcast<u32>(_e104) & 2147483647u) > 2139095040u) {
                        phi_736_ = _e104;
                    } else {
                        if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                            phi_735_ = 0f;
                        } else {
                            if (_e104 < 0f) {
                                phi_734_ = 0f;
                            } else {
                                phi_734_ = 1f;
                            }
                            let _e534 = phi_734_;
                            phi_735_ = _e534;
                        }
                        let _e536 = phi_735_;
                        phi_736_ = _e536;
                    }
                    let _e538 = phi_736_;
                    if ((bitcast<u32>(_e105) & 2147483647u) > 2139095040u) {
                        phi_755_ = _e105;
                    } else {
                        if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                            phi_754_ = 0f;
                        } else {
                            if (_e105 < 0f) {
                                phi_753_ = 0f;
                            } else {
                                phi_753_ = 1f;
                            }
                            let _e547 = phi_753_;
                            phi_754_ = _e547;
                        }
                        let _e549 = phi_754_;
                        phi_755_ = _e549;
                    }
                    let _e551 = phi_755_;
                    if ((bitcast<u32>(_e106) & 2147483647u) > 2139095040u) {
                        phi_774_ = _e106;
                    } else {
                        if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                            phi_773_ = 0f;
                        } else {
                            if (_e106 < 0f) {
                                phi_772_ = 0f;
                            } else {
                                phi_772_ = 1f;
                            }
                            let _e560 = phi_772_;
                            phi_773_ = _e560;
                        }
                        let _e562 = phi_773_;
                        phi_774_ = _e562;
                    }
                    let _e564 = phi_774_;
                    if ((bitcast<u32>(_e107) & 2147483647u) > 2139095040u) {
                        phi_793_ = _e107;
                    } else {
                        if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                            phi_792_ = 0f;
                        } else {
                            if (_e107 < 0f) {
                                phi_791_ = 0f;
                            } else {
                                phi_791_ = 1f;
                            }
                            let _e573 = phi_791_;
                            phi_792_ = _e573;
                        }
                        let _e575 = phi_792_;
                        phi_793_ = _e575;
                    }
                    let _e577 = phi_793_;
                    let _e585 = (((((_e538 * _e143) + (_e551 * _e145)) + (_e564 * _e147)) + (_e577 * _e149)) + _e140);
                    if ((bitcast<u32>(_e585) & 2147483647u) > 2139095040u) {
                        phi_818_ = _e585;
                    } else {
                        if (_e585 < 0f) {
                            phi_817_ = 0f;
                        } else {
                            if (_e585 > 1f) {
                                phi_816_ = 1f;
                            } else {
                                phi_816_ = _e585;
                            }
                            let _e592 = phi_816_;
                            phi_817_ = _e592;
                        }
                        let _e594 = phi_817_;
                        phi_818_ = _e594;
                    }
                    let _e596 = phi_818_;
                    phi_952_ = _e596;
                } else {
                    let _e598 = (_e524 - (_e150 * _e513));
                    let _e600 = ((_e151 * _e513) - _e524);
                    let _e605 = ((_e143 * _e104) * _e153);
                    let _e606 = ((_e145 * _e105) * _e155);
                    let _e607 = ((_e147 * _e106) * _e157);
                    let _e608 = ((_e149 * _e107) * _e159);
                    let _e634 = (_e140 + (((((_e605 * ((_e606 * _e164) + ((0.5f * _e607) * _e172))) + (_e606 * ((_e607 * _e165) + ((0.5f * _e608) * _e173)))) + (_e607 * ((_e608 * _e166) + ((0.5f * _e605) * _e174)))) + (_e608 * ((_e605 * _e167) + ((0.5f * _e606) * _e175)))) / (_e150 * _e598)));
                    let _e639 = ((_e143 * _e104) * _e67);
                    let _e640 = ((_e145 * _e105) * _e79);
                    let _e641 = ((_e147 * _e106) * _e91);
                    let _e642 = ((_e149 * _e107) * _e103);
                    let _e668 = (_e140 + (((((_e639 * ((_e640 * _e164) + ((0.5f * _e641) * _e172))) + (_e640 * ((_e641 * _e165) + ((0.5f * _e642) * _e173)))) + (_e641 * ((_e642 * _e166) + ((0.5f * _e639) * _e174)))) + (_e642 * ((_e639 * _e167) + ((0.5f * _e640) * _e175)))) / (_e151 * _e600)));
                    let _e669 = (_e513 > 0f);
                    if _e669 {
                        phi_897_ = (_e600 > 0f);
                    } else {
                        phi_897_ = (_e598 < 0f);
                    }
                    let _e673 = phi_897_;
                    if _e673 {
                        if (_e634 >= 0f) {
                            if (_e668 >= 0f) {
                                if _e669 {
                                    phi_941_ = (1f - _e634);
                                } else {
                                    phi_941_ = ((((((_e503 * ((_e504 * _e164) + ((0.5f * _e505) * _e172))) + (_e504 * ((_e505 * _e165) + ((0.5f * _e506) * _e173)))) + (_e505 * ((_e506 * _e166) + ((0.5f * _e503) * _e174)))) + (_e506 * ((_e503 * _e167) + ((0.5f * _e504) * _e175)))) / (_e524 * (-(_e150) * _e151))) + _e668);
                                }
                                let _e706 = phi_941_;
                                phi_942_ = _e706;
                                phi_943_ = false;
                            } else {
                                phi_942_ = f32();
                                phi_943_ = true;
                            }
                            let _e708 = phi_942_;
                            let _e710 = phi_943_;
                            phi_944_ = _e708;
                            phi_945_ = _e710;
                        } else {
                            phi_944_ = f32();
                            phi_945_ = true;
                        }
                        let _e712 = phi_944_;
                        let _e714 = phi_945_;
                        phi_946_ = _e712;
                        phi_947_ = _e714;
                    } else {
                        phi_946_ = f32();
                        phi_947_ = true;
                    }
                    let _e716 = phi_946_;
                    let _e718 = phi_947_;
                    if _e718 {
                        phi_951_ = 1f;
                    } else {
                        phi_951_ = _e716;
                    }
                    let _e720 = phi_951_;
                    phi_952_ = _e720;
                }
                let _e722 = phi_952_;
                let _e723 = (_e722 < 1f);
                if _e723 {
                    if ((bitcast<u32>(_e722) & 2147483647u) > 2139095040u) {
                        phi_973_ = _e722;
                    } else {
                        if (_e722 < 0f) {
                            phi_972_ = 0f;
                        } else {
                            if (_e722 > 1f) {
                                phi_971_ = 1f;
                            } else {
                                phi_971_ = _e722;
                            }
                            let _e730 = phi_971_;
                            phi_972_ = _e730;
                        }
                        let _e732 = phi_972_;
                        phi_973_ = _e732;
                    }
                    let _e734 = phi_973_;
                    phi_1086_ = _e734;
                    phi_1087_ = f32();
                } else {
                    let _e736 = ((0.5f * -(((((((((_e204 * (_e104 + _e105)) + (_e208 * (_e104 + _e106))) + (_e232 * (_e104 + _e150))) + (_e244 * (_e104 + _e151))) + ((((_e205 * (_e105 + _e106)) + (_e209 * (_e105 + _e107))) + (_e233 * (_e105 + _e150))) + (_e245 * (_e105 + _e151)))) + ((((_e206 * (_e106 + _e107)) + (_e210 * (_e106 + _e104))) + (_e234 * (_e106 + _e150))) + (_e246 * (_e106 + _e151)))) + ((((_e207 * (_e107 + _e104)) + (_e211 * (_e107 + _e105))) + (_e235 * (_e107 + _e150))) + (_e247 * (_e107 + _e151)))) + (_e418 * (_e150 + _e151))))) / _e421);
                    let _e737 = ((((((((_e204 + _e208) + _e232) + _e244) + (((_e205 + _e209) + _e233) + _e245)) + (((_e206 + _e210) + _e234) + _e246)) + (((_e207 + _e211) + _e235) + _e247)) + _e418) / _e421);
                    let _e739 = ((_e736 * _e736) - _e737);
                    if (_e739 > 0f) {
                        phi_984_ = sqrt(_e739);
                    } else {
                        phi_984_ = 0f;
                    }
                    let _e743 = phi_984_;
                    if (_e736 > 0f) {
                        let _e746 = (-(_e736) - _e743);
                        phi_1001_ = lt_bvh_slab_Span(_e746, (_e737 / _e746));
                    } else {
                        let _e749 = (_e743 - _e736);
                        if (_e749 > 0f) {
                            phi_999_ = (_e737 / _e749);
                        } else {
                            phi_999_ = 0f;
                        }
                        let _e753 = phi_999_;
                        phi_1001_ = lt_bvh_slab_Span(_e753, _e749);
                    }
                    let _e756 = phi_1001_;
                    if (_e756.near >= 0f) {
                        phi_1062_ = 1f;
                        phi_1063_ = f32();
                        phi_1064_ = true;
                    } else {
                        let _e760 = (_e756.far <= 0f);
                        if _e760 {
                            phi_1060_ = (_e415 / _e421);
                            phi_1061_ = f32();
                        } else {
                            let _e771 = (((((_e143 * _e104) + (_e145 * _e105)) + (_e147 * _e106)) + (_e149 * _e107)) + (_e140 * (_e150 + _e151)));
                            let _e787 = (((((_e143 * (_e104 * _e104)) + (_e145 * (_e105 * _e105))) + (_e147 * (_e106 * _e106))) + (_e149 * (_e107 * _e107))) + (_e140 * ((_e150 * _e150) + (_e151 * _e151))));
                            if (-(_e756.near) <= _e756.far) {
                                phi_1059_ = (1f - (((_e756.near * _e756.near) * ((_e756.far * _e787) - _e771)) / (_e756.far - _e756.near)));
                            } else {
                                phi_1059_ = ((_e415 / _e421) + (((_e756.far * _e756.far) * (_e771 - (_e756.near * _e787))) / (_e756.far - _e756.near)));
                            }
                            let _e806 = phi_1059_;
                            phi_1060_ = f32();
                            phi_1061_ = _e806;
                        }
                        let _e808 = phi_1060_;
                        let _e810 = phi_1061_;
                        phi_1062_ = _e808;
                        phi_1063_ = _e810;
                        phi_1064_ = _e760;
                    }
                    let _e812 = phi_1062_;
                    let _e814 = phi_1063_;
                    let _e816 = phi_1064_;
                    if _e816 {
                        phi_1068_ = _e812;
                    } else {
                        phi_1068_ = _e814;
                    }
                    let _e818 = phi_1068_;
                    if ((bitcast<u32>(_e818) & 2147483647u) > 2139095040u) {
                        phi_1085_ = _e818;
                    } else {
                        if (_e818 < 0f) {
                            phi_1084_ = 0f;
                        } else {
                            if (_e818 > 1f) {
                                phi_1083_ = 1f;
                            } else {
                                phi_1083_ = _e818;
                            }
                            let _e825 = phi_1083_;
                            phi_1084_ = _e825;
                        }
                        let _e827 = phi_1084_;
                        phi_1085_ = _e827;
                    }
                    let _e829 = phi_1085_;
                    phi_1086_ = f32();
                    phi_1087_ = _e829;
                }
                let _e831 = phi_1086_;
                let _e833 = phi_1087_;
                phi_1088_ = _e831;
                phi_1089_ = _e833;
                phi_1090_ = _e723;
            }
            let _e835 = phi_1088_;
            let _e837 = phi_1089_;
            let _e839 = phi_1090_;
            if _e839 {
            }
            phi_1094_ = _e835;
            phi_1095_ = _e837;
            phi_1096_ = _e839;
        }
        let _e841 = phi_1094_;
        let _e843 = phi_1095_;
        let _e845 = phi_1096_;
        phi_1097_ = _e841;
        phi_1098_ = _e843;
        phi_1099_ = _e845;
    }
    let _e847 = phi_1097_;
    let _e849 = phi_1098_;
    let _e851 = phi_1099_;
    if _e851 {
        phi_1103_ = _e847;
    } else {
        phi_1103_ = _e849;
    }
    let _e853 = phi_1103_;
    return _e853;
}

fn function_() {
    var local: f32;
    var phi_1159_: bool;
    var phi_1160_: bool;
    var phi_1161_: bool;
    var phi_1162_: bool;
    var phi_1166_: bool;
    var phi_1236_: bool;
    var phi_1237_: bool;
    var phi_1248_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1249_: bool;
    var phi_1250_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1251_: bool;
    var phi_1258_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1262_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1336_: bool;
    var phi_1345_: bool;
    var phi_1354_: bool;
    var phi_1355_: bool;
    var phi_1356_: bool;
    var phi_1357_: bool;
    var phi_1358_: bool;
    var phi_1359_: bool;
    var phi_1360_: bool;
    var phi_1364_: bool;
    var phi_1454_: f32;
    var phi_1457_: f32;
    var phi_1486_: f32;
    var phi_1491_: f32;
    var phi_1492_: bool;
    var phi_1493_: f32;
    var phi_1494_: bool;
    var phi_1498_: f32;
    var phi_1518_: f32;
    var phi_1523_: f32;
    var phi_1524_: bool;
    var phi_1525_: f32;
    var phi_1526_: bool;
    var phi_1530_: f32;
    var phi_1578_: i32;
    var phi_1583_: i32;
    var phi_1588_: i32;
    var phi_1593_: i32;
    var phi_1602_: i32;
    var phi_1607_: i32;
    var phi_1612_: i32;
    var phi_1617_: i32;
    var phi_1670_: bool;
    var phi_1678_: bool;
    var phi_1690_: bool;
    var phi_1691_: bool;
    var phi_1695_: f32;
    var phi_1701_: f32;
    var phi_1703_: evaluate_Verdict;
    var phi_1713_: u32;
    var phi_1722_: f32;
    var phi_1724_: evaluate_Verdict;
    var phi_1725_: bool;
    var phi_1726_: evaluate_Verdict;
    var phi_1727_: bool;
    var phi_1732_: evaluate_Verdict;
    var phi_1737_: evaluate_Verdict;
    var phi_1738_: evaluate_Verdict;

    let _e40 = id_1;
    let _e47 = arrayLength((&map.member));
    let _e53 = p.member.size[0u];
    let _e55 = p.member.size[1u];
    let _e56 = lt_shaders_entry_pixel_index(_e40, _e53, _e55);
    if (bitcast<i32>(_e56.root) != 0i) {
        let _e62 = p.member.projection;
        if (_e56.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e66 = lt_math_OneLevel(_e62);
        let _e70 = samples.member[(0u + _e56.first_primitive)].normal[0u];
        let _e72 = global[0u];
        if (_e70 == _e72) {
            let _e75 = samples.member[(0u + _e56.first_primitive)].normal[1u];
            let _e77 = global[1u];
            if (_e75 == _e77) {
                let _e80 = samples.member[(0u + _e56.first_primitive)].normal[2u];
                let _e82 = global[2u];
                phi_1159_ = (_e80 == _e82);
                phi_1160_ = false;
            } else {
                phi_1159_ = bool();
                phi_1160_ = true;
            }
            let _e85 = phi_1159_;
            let _e87 = phi_1160_;
            phi_1161_ = _e85;
            phi_1162_ = _e87;
        } else {
            phi_1161_ = bool();
            phi_1162_ = true;
        }
        let _e89 = phi_1161_;
        let _e91 = phi_1162_;
        if _e91 {
            phi_1166_ = false;
        } else {
            phi_1166_ = _e89;
        }
        let _e93 = phi_1166_;
        if !(_e93) {
            let _e96 = samples.member[(0u + _e56.first_primitive)].position;
            let _e98 = p.member.light.place;
            let _e104 = p.member.light.place[3u];
            let _e111 = (_e98.x - (_e96.x * _e104));
            let _e112 = (_e98.y - (_e96.y * _e104));
            let _e113 = (_e98.z - (_e96.z * _e104));
            let _e115 = samples.member[(0u + _e56.first_primitive)].normal;
            if ((((_e115.x * _e111) + (_e115.y * _e112)) + (_e115.z * _e113)) > 0f) {
                let _e129 = (((_e111 * _e111) + (_e112 * _e112)) + (_e113 * _e113));
                let _e131 = p.member.light.axis;
                let _e143 = p.member.light.place[3u];
                if (_e143 == 0f) {
                    phi_1237_ = true;
                } else {
                    let _e146 = p.member.light.range_squared;
                    if (_e129 <= _e146) {
                        let _e149 = p.member.light.cos_outer;
                        phi_1236_ = (-((((_e111 * _e131.x) + (_e112 * _e131.y)) + (_e113 * _e131.z))) >= (_e149 * sqrt(_e129)));
                    } else {
                        phi_1236_ = false;
                    }
                    let _e154 = phi_1236_;
                    phi_1237_ = _e154;
                }
                let _e156 = phi_1237_;
                if _e156 {
                    let _e158 = samples.member[(0u + _e56.first_primitive)].flags;
                    let _e166 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e172 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e166.unnamed.visibility, false), _e166.unnamed_1);
                    phi_1248_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e172.unnamed, ((_e158 & 1u) == 0u));
                    phi_1249_ = false;
                } else {
                    phi_1248_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_1249_ = true;
                }
                let _e177 = phi_1248_;
                let _e179 = phi_1249_;
                phi_1250_ = _e177;
                phi_1251_ = _e179;
            } else {
                phi_1250_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_1251_ = true;
            }
            let _e181 = phi_1250_;
            let _e183 = phi_1251_;
            if _e183 {
                let _e189 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e195 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e189.unnamed.visibility, false), _e189.unnamed_1);
                phi_1258_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e195.unnamed, true);
            } else {
                phi_1258_ = _e181;
            }
            let _e200 = phi_1258_;
            phi_1262_ = _e200;
        } else {
            let _e206 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e212 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e206.unnamed.visibility, false), _e206.unnamed_1);
            phi_1262_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e212.unnamed, true);
        }
        let _e217 = phi_1262_;
        if _e217.unnamed_1 {
            phi_1738_ = evaluate_Verdict(_e217.unnamed.visibility, _e217.unnamed.is_doubted);
        } else {
            let _e225 = samples.member[(0u + _e56.first_primitive)].position;
            let _e243 = ((((_e66.projection.row_w.x * _e225.x) + (_e66.projection.row_w.y * _e225.y)) + (_e66.projection.row_w.z * _e225.z)) + (_e66.projection.row_w.w * 1f));
            let _e257 = (((((_e66.projection.row_x.x * _e225.x) + (_e66.projection.row_x.y * _e225.y)) + (_e66.projection.row_x.z * _e225.z)) + (_e66.projection.row_x.w * 1f)) / _e243);
            let _e271 = (((((_e66.projection.row_y.x * _e225.x) + (_e66.projection.row_y.y * _e225.y)) + (_e66.projection.row_y.z * _e225.z)) + (_e66.projection.row_y.w * 1f)) / _e243);
            let _e284 = ((((_e66.projection.row_z.x * _e225.x) + (_e66.projection.row_z.y * _e225.y)) + (_e66.projection.row_z.z * _e225.z)) + (_e66.projection.row_z.w * 1f));
            if (_e243 > 0f) {
                if (_e257 >= 0f) {
                    phi_1336_ = (_e257 <= 1f);
                } else {
                    phi_1336_ = false;
                }
                let _e289 = phi_1336_;
                if _e289 {
                    if (_e271 >= 0f) {
                        phi_1345_ = (_e271 <= 1f);
                    } else {
                        phi_1345_ = false;
                    }
                    let _e293 = phi_1345_;
                    if _e293 {
                        if (_e284 >= 0f) {
                            phi_1354_ = (_e284 <= 1f);
                        } else {
                            phi_1354_ = false;
                        }
                        let _e297 = phi_1354_;
                        phi_1355_ = _e297;
                        phi_1356_ = false;
                    } else {
                        phi_1355_ = bool();
                        phi_1356_ = true;
                    }
                    let _e299 = phi_1355_;
                    let _e301 = phi_1356_;
                    phi_1357_ = _e299;
                    phi_1358_ = _e301;
                } else {
                    phi_1357_ = bool();
                    phi_1358_ = true;
                }
                let _e303 = phi_1357_;
                let _e305 = phi_1358_;
                phi_1359_ = _e303;
                phi_1360_ = _e305;
            } else {
                phi_1359_ = bool();
                phi_1360_ = true;
            }
            let _e307 = phi_1359_;
            let _e309 = phi_1360_;
            if _e309 {
                phi_1364_ = false;
            } else {
                phi_1364_ = _e307;
            }
            let _e311 = phi_1364_;
            if _e311 {
                if (0f > 0f) {
                    let _e314 = samples.member[(0u + _e56.first_primitive)].normal;
                    let _e316 = p.member.map_size;
                    let _e386 = ((abs(((((_e62.row_x.x * _e314.x) + (_e62.row_x.y * _e314.y)) + (_e62.row_x.z * _e314.z)) / (((_e62.row_x.x * _e62.row_x.x) + (_e62.row_x.y * _e62.row_x.y)) + (_e62.row_x.z * _e62.row_x.z)))) + abs(((((_e62.row_y.x * _e314.x) + (_e62.row_y.y * _e314.y)) + (_e62.row_y.z * _e314.z)) / (((_e62.row_y.x * _e62.row_y.x) + (_e62.row_y.y * _e62.row_y.y)) + (_e62.row_y.z * _e62.row_y.z))))) / (abs(((((_e62.row_z.x * _e314.x) + (_e62.row_z.y * _e314.y)) + (_e62.row_z.z * _e314.z)) / (((_e62.row_z.x * _e62.row_z.x) + (_e62.row_z.y * _e62.row_z.y)) + (_e62.row_z.z * _e62.row_z.z)))) * f32(_e316)));
                    if (_e386 < 0.002f) {
                        phi_1454_ = _e386;
                    } else {
                        phi_1454_ = 0.002f;
                    }
                    let _e389 = phi_1454_;
                    phi_1457_ = (_e284 - (0f * _e389));
                } else {
                    phi_1457_ = _e284;
                }
                let _e393 = phi_1457_;
                let _e395 = p.member.map_size;
                let _e396 = f32(_e395);
                let _e399 = ((_e257 * _e396) - 0.5f);
                let _e400 = ((_e271 * _e396) - 0.5f);
                if (_e399 > -8388608f) {
                    let _e412 = f32(select(0i, select(select(i32(_e399), i32(-2147483648), (_e399 < bitcast<f32>(3472883712u))), 2147483647i, (_e399 > bitcast<f32>(1325400063u))), (_e399 == _e399)));
                    if (_e412 > _e399) {
                        phi_1486_ = 1f;
                    } else {
                        phi_1486_ = 0f;
                    }
                    let _e415 = phi_1486_;
                    if (_e399 < 8388608f) {
                        phi_1491_ = (_e412 - _e415);
                        phi_1492_ = false;
                    } else {
                        phi_1491_ = f32();
                        phi_1492_ = true;
                    }
                    let _e418 = phi_1491_;
                    let _e420 = phi_1492_;
                    phi_1493_ = _e418;
                    phi_1494_ = _e420;
                } else {
                    phi_1493_ = f32();
                    phi_1494_ = true;
                }
                let _e422 = phi_1493_;
                let _e424 = phi_1494_;
                if _e424 {
                    phi_1498_ = _e399;
                } else {
                    phi_1498_ = _e422;
                }
                let _e426 = phi_1498_;
                if (_e400 > -8388608f) {
                    let _e438 = f32(select(0i, select(select(i32(_e400), i32(-2147483648), (_e400 < bitcast<f32>(3472883712u))), 2147483647i, (_e400 > bitcast<f32>(1325400063u))), (_e400 == _e400)));
                    if (_e438 > _e400) {
                        phi_1518_ = 1f;
                    } else {
                        phi_1518_ = 0f;
                    }
                    let _e441 = phi_1518_;
                    if (_e400 < 8388608f) {
                        phi_1523_ = (_e438 - _e441);
                        phi_1524_ = false;
                    } else {
                        phi_1523_ = f32();
                        phi_1524_ = true;
                    }
                    let _e444 = phi_1523_;
                    let _e446 = phi_1524_;
                    phi_1525_ = _e444;
                    phi_1526_ = _e446;
                } else {
                    phi_1525_ = f32();
                    phi_1526_ = true;
                }
                let _e448 = phi_1525_;
                let _e450 = phi_1526_;
                if _e450 {
                    phi_1530_ = _e400;
                } else {
                    phi_1530_ = _e448;
                }
                let _e452 = phi_1530_;
                let _e453 = (_e399 - _e426);
                let _e454 = (_e400 - _e452);
                let _e463 = select(0i, select(select(i32(_e426), i32(-2147483648), (_e426 < bitcast<f32>(3472883712u))), 2147483647i, (_e426 > bitcast<f32>(1325400063u))), (_e426 == _e426));
                let _e472 = select(0i, select(select(i32(_e452), i32(-2147483648), (_e452 < bitcast<f32>(3472883712u))), 2147483647i, (_e452 > bitcast<f32>(1325400063u))), (_e452 == _e452));
                let _e483 = p.member.test;
                let _e484 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e483);
                let _e486 = p.member.map_size;
                local = _e484;
                let _e488 = ((0u * _e486) * _e486);
                let _e490 = (bitcast<i32>(_e486) - 1i);
                if (_e463 > 0i) {
                    phi_1578_ = _e463;
                } else {
                    phi_1578_ = 0i;
                }
                let _e493 = phi_1578_;
                if (_e472 > 0i) {
                    phi_1583_ = _e472;
                } else {
                    phi_1583_ = 0i;
                }
                let _e496 = phi_1583_;
                if (_e493 < _e490) {
                    phi_1588_ = _e493;
                } else {
                    phi_1588_ = _e490;
                }
                let _e499 = phi_1588_;
                if (_e496 < _e490) {
                    phi_1593_ = _e496;
                } else {
                    phi_1593_ = _e490;
                }
                let _e502 = phi_1593_;
                let _e503 = bitcast<u32>(_e499);
                let _e505 = (_e463 + 1i);
                let _e506 = (_e472 + 1i);
                if (_e505 > 0i) {
                    phi_1602_ = _e505;
                } else {
                    phi_1602_ = 0i;
                }
                let _e509 = phi_1602_;
                if (_e506 > 0i) {
                    phi_1607_ = _e506;
                } else {
                    phi_1607_ = 0i;
                }
                let _e512 = phi_1607_;
                if (_e509 < _e490) {
                    phi_1612_ = _e509;
                } else {
                    phi_1612_ = _e490;
                }
                let _e515 = phi_1612_;
                if (_e512 < _e490) {
                    phi_1617_ = _e512;
                } else {
                    phi_1617_ = _e490;
                }
                let _e518 = phi_1617_;
                let _e519 = bitcast<u32>(_e515);
                let _e521 = (bitcast<u32>(_e502) * _e486);
                let _e522 = (bitcast<u32>(_e518) * _e486);
                let _e527 = ((_e521 + _e503) + _e488);
                let _e528 = ((_e521 + _e519) + _e488);
                let _e529 = ((_e522 + _e503) + _e488);
                let _e530 = ((_e522 + _e519) + _e488);
                if (_e527 < _e47) {
                } else {
                    return;
                }
                let _e534 = map.member[(0u + _e527)];
                if (_e528 < _e47) {
                } else {
                    return;
                }
                let _e538 = map.member[(0u + _e528)];
                if (_e529 < _e47) {
                } else {
                    return;
                }
                let _e542 = map.member[(0u + _e529)];
                if (_e530 < _e47) {
                } else {
                    return;
                }
                let _e546 = map.member[(0u + _e530)];
                let _e548 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e534, _e538, _e542, _e546), vec4<f32>(((1f - _e453) * (1f - _e454)), (_e453 * (1f - _e454)), ((1f - _e453) * _e454), (_e453 * _e454)), _e393);
                let _e552 = p.member.epsilon;
                if (_e548 <= _e552) {
                    phi_1670_ = true;
                } else {
                    phi_1670_ = (_e548 >= (1f - _e552));
                }
                let _e557 = phi_1670_;
                if ((bitcast<u32>(_e548) & 2147483647u) > 2139095040u) {
                    phi_1678_ = true;
                } else {
                    phi_1678_ = !(_e557);
                }
                let _e563 = phi_1678_;
                if _e563 {
                    if (_e548 > 0f) {
                        if (_e548 < 1f) {
                            phi_1690_ = false;
                        } else {
                            phi_1690_ = true;
                        }
                        let _e567 = phi_1690_;
                        phi_1691_ = _e567;
                    } else {
                        phi_1691_ = true;
                    }
                    let _e569 = phi_1691_;
                    if _e569 {
                        phi_1695_ = 0.5f;
                    } else {
                        phi_1695_ = _e548;
                    }
                    let _e571 = phi_1695_;
                    phi_1703_ = evaluate_Verdict(_e571, true);
                } else {
                    if (_e548 > 0.5f) {
                        phi_1701_ = 1f;
                    } else {
                        phi_1701_ = 0f;
                    }
                    let _e575 = phi_1701_;
                    phi_1703_ = evaluate_Verdict(_e575, false);
                }
                let _e578 = phi_1703_;
                let _e581 = (_e578.visibility < 0.5f);
                if _e578.is_doubted {
                    phi_1726_ = evaluate_Verdict();
                    phi_1727_ = true;
                } else {
                    if _e581 {
                        phi_1713_ = 2u;
                    } else {
                        phi_1713_ = 1u;
                    }
                    let _e583 = phi_1713_;
                    if ((0u & _e583) != 0u) {
                        if _e581 {
                            phi_1722_ = 0.000000059604645f;
                        } else {
                            phi_1722_ = 0.99999994f;
                        }
                        let _e587 = phi_1722_;
                        phi_1724_ = evaluate_Verdict(_e587, true);
                        phi_1725_ = false;
                    } else {
                        phi_1724_ = evaluate_Verdict();
                        phi_1725_ = true;
                    }
                    let _e590 = phi_1724_;
                    let _e592 = phi_1725_;
                    phi_1726_ = _e590;
                    phi_1727_ = _e592;
                }
                let _e594 = phi_1726_;
                let _e596 = phi_1727_;
                if _e596 {
                    phi_1732_ = evaluate_Verdict(_e578.visibility, _e578.is_doubted);
                } else {
                    phi_1732_ = _e594;
                }
                let _e599 = phi_1732_;
                phi_1737_ = evaluate_Verdict(_e599.visibility, _e599.is_doubted);
            } else {
                phi_1737_ = evaluate_Verdict(0.5f, true);
            }
            let _e605 = phi_1737_;
            phi_1738_ = _e605;
        }
        let _e607 = phi_1738_;
        if (_e56.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e56.first_primitive)] = _e607.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_msm_hausdorff_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
