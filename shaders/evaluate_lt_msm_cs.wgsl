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

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
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
    var phi_698_: f32;
    var phi_713_: f32;
    var phi_715_: lt_bvh_slab_Span;
    var phi_773_: f32;
    var phi_774_: f32;
    var phi_775_: f32;
    var phi_776_: f32;
    var phi_777_: f32;
    var phi_778_: bool;
    var phi_782_: f32;
    var phi_797_: f32;
    var phi_798_: f32;
    var phi_799_: f32;
    var phi_800_: f32;
    var phi_801_: f32;
    var phi_802_: f32;
    var phi_803_: f32;
    var phi_804_: bool;
    var phi_805_: f32;
    var phi_806_: f32;
    var phi_807_: bool;
    var phi_811_: f32;

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
        phi_805_ = _e118;
        phi_806_ = f32();
        phi_807_ = true;
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
            phi_802_ = 1f;
            phi_803_ = f32();
            phi_804_ = true;
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
            let _e427 = (_e421 < 0.0000000000000000000000000000000001f);
            if _e427 {
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
                phi_800_ = _e498;
                phi_801_ = f32();
            } else {
                let _e500 = ((0.5f * -(((((((((_e204 * (_e104 + _e105)) + (_e208 * (_e104 + _e106))) + (_e232 * (_e104 + _e150))) + (_e244 * (_e104 + _e151))) + ((((_e205 * (_e105 + _e106)) + (_e209 * (_e105 + _e107))) + (_e233 * (_e105 + _e150))) + (_e245 * (_e105 + _e151)))) + ((((_e206 * (_e106 + _e107)) + (_e210 * (_e106 + _e104))) + (_e234 * (_e106 + _e150))) + (_e246 * (_e106 + _e151)))) + ((((_e207 * (_e107 + _e104)) + (_e211 * (_e107 + _e105))) + (_e235 * (_e107 + _e150))) + (_e247 * (_e107 + _e151)))) + (_e418 * (_e150 + _e151))))) / _e421);
                let _e501 = ((((((((_e204 + _e208) + _e232) + _e244) + (((_e205 + _e209) + _e233) + _e245)) + (((_e206 + _e210) + _e234) + _e246)) + (((_e207 + _e211) + _e235) + _e247)) + _e418) / _e421);
                let _e503 = ((_e500 * _e500) - _e501);
                if (_e503 > 0f) {
                    phi_698_ = sqrt(_e503);
                } else {
                    phi_698_ = 0f;
                }
                let _e507 = phi_698_;
                if (_e500 > 0f) {
                    let _e510 = (-(_e500) - _e507);
                    phi_715_ = lt_bvh_slab_Span(_e510, (_e501 / _e510));
                } else {
                    let _e513 = (_e507 - _e500);
                    if (_e513 > 0f) {
                        phi_713_ = (_e501 / _e513);
                    } else {
                        phi_713_ = 0f;
                    }
                    let _e517 = phi_713_;
                    phi_715_ = lt_bvh_slab_Span(_e517, _e513);
                }
                let _e520 = phi_715_;
                if (_e520.near >= 0f) {
                    phi_776_ = 1f;
                    phi_777_ = f32();
                    phi_778_ = true;
                } else {
                    let _e524 = (_e520.far <= 0f);
                    if _e524 {
                        phi_774_ = (_e415 / _e421);
                        phi_775_ = f32();
                    } else {
                        let _e535 = (((((_e143 * _e104) + (_e145 * _e105)) + (_e147 * _e106)) + (_e149 * _e107)) + (_e140 * (_e150 + _e151)));
                        let _e551 = (((((_e143 * (_e104 * _e104)) + (_e145 * (_e105 * _e105))) + (_e147 * (_e106 * _e106))) + (_e149 * (_e107 * _e107))) + (_e140 * ((_e150 * _e150) + (_e151 * _e151))));
                        if (-(_e520.near) <= _e520.far) {
                            phi_773_ = (1f - (((_e520.near * _e520.near) * ((_e520.far * _e551) - _e535)) / (_e520.far - _e520.near)));
                        } else {
                            phi_773_ = ((_e415 / _e421) + (((_e520.far * _e520.far) * (_e535 - (_e520.near * _e551))) / (_e520.far - _e520.near)));
                        }
                        let _e570 = phi_773_;
                        phi_774_ = f32();
                        phi_775_ = _e570;
                    }
                    let _e572 = phi_774_;
                    let _e574 = phi_775_;
                    phi_776_ = _e572;
                    phi_777_ = _e574;
                    phi_778_ = _e524;
                }
                let _e576 = phi_776_;
                let _e578 = phi_777_;
                let _e580 = phi_778_;
                if _e580 {
                    phi_782_ = _e576;
                } else {
                    phi_782_ = _e578;
                }
                let _e582 = phi_782_;
                if ((bitcast<u32>(_e582) & 2147483647u) > 2139095040u) {
                    phi_799_ = _e582;
                } else {
                    if (_e582 < 0f) {
                        phi_798_ = 0f;
                    } else {
                        if (_e582 > 1f) {
                            phi_797_ = 1f;
                        } else {
                            phi_797_ = _e582;
                        }
                        let _e589 = phi_797_;
                        phi_798_ = _e589;
                    }
                    let _e591 = phi_798_;
                    phi_799_ = _e591;
                }
                let _e593 = phi_799_;
                phi_800_ = f32();
                phi_801_ = _e593;
            }
            let _e595 = phi_800_;
            let _e597 = phi_801_;
            phi_802_ = _e595;
            phi_803_ = _e597;
            phi_804_ = _e427;
        }
        let _e599 = phi_802_;
        let _e601 = phi_803_;
        let _e603 = phi_804_;
        phi_805_ = _e599;
        phi_806_ = _e601;
        phi_807_ = _e603;
    }
    let _e605 = phi_805_;
    let _e607 = phi_806_;
    let _e609 = phi_807_;
    if _e609 {
        phi_811_ = _e605;
    } else {
        phi_811_ = _e607;
    }
    let _e611 = phi_811_;
    return _e611;
}

fn function_() {
    var local: f32;
    var phi_867_: bool;
    var phi_868_: bool;
    var phi_869_: bool;
    var phi_870_: bool;
    var phi_874_: bool;
    var phi_944_: bool;
    var phi_945_: bool;
    var phi_956_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_957_: bool;
    var phi_958_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_959_: bool;
    var phi_966_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_970_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1044_: bool;
    var phi_1053_: bool;
    var phi_1062_: bool;
    var phi_1063_: bool;
    var phi_1064_: bool;
    var phi_1065_: bool;
    var phi_1066_: bool;
    var phi_1067_: bool;
    var phi_1068_: bool;
    var phi_1072_: bool;
    var phi_1162_: f32;
    var phi_1165_: f32;
    var phi_1194_: f32;
    var phi_1199_: f32;
    var phi_1200_: bool;
    var phi_1201_: f32;
    var phi_1202_: bool;
    var phi_1206_: f32;
    var phi_1226_: f32;
    var phi_1231_: f32;
    var phi_1232_: bool;
    var phi_1233_: f32;
    var phi_1234_: bool;
    var phi_1238_: f32;
    var phi_1286_: i32;
    var phi_1291_: i32;
    var phi_1296_: i32;
    var phi_1301_: i32;
    var phi_1310_: i32;
    var phi_1315_: i32;
    var phi_1320_: i32;
    var phi_1325_: i32;
    var phi_1378_: bool;
    var phi_1386_: bool;
    var phi_1398_: bool;
    var phi_1399_: bool;
    var phi_1403_: f32;
    var phi_1409_: f32;
    var phi_1411_: evaluate_Verdict;
    var phi_1421_: u32;
    var phi_1430_: f32;
    var phi_1432_: evaluate_Verdict;
    var phi_1433_: bool;
    var phi_1434_: evaluate_Verdict;
    var phi_1435_: bool;
    var phi_1440_: evaluate_Verdict;
    var phi_1445_: evaluate_Verdict;
    var phi_1446_: evaluate_Verdict;

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
                phi_867_ = (_e80 == _e82);
                phi_868_ = false;
            } else {
                phi_867_ = bool();
                phi_868_ = true;
            }
            let _e85 = phi_867_;
            let _e87 = phi_868_;
            phi_869_ = _e85;
            phi_870_ = _e87;
        } else {
            phi_869_ = bool();
            phi_870_ = true;
        }
        let _e89 = phi_869_;
        let _e91 = phi_870_;
        if _e91 {
            phi_874_ = false;
        } else {
            phi_874_ = _e89;
        }
        let _e93 = phi_874_;
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
                    phi_945_ = true;
                } else {
                    let _e146 = p.member.light.range_squared;
                    if (_e129 <= _e146) {
                        let _e149 = p.member.light.cos_outer;
                        phi_944_ = (-((((_e111 * _e131.x) + (_e112 * _e131.y)) + (_e113 * _e131.z))) >= (_e149 * sqrt(_e129)));
                    } else {
                        phi_944_ = false;
                    }
                    let _e154 = phi_944_;
                    phi_945_ = _e154;
                }
                let _e156 = phi_945_;
                if _e156 {
                    let _e158 = samples.member[(0u + _e56.first_primitive)].flags;
                    let _e166 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e172 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e166.unnamed.visibility, false), _e166.unnamed_1);
                    phi_956_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e172.unnamed, ((_e158 & 1u) == 0u));
                    phi_957_ = false;
                } else {
                    phi_956_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_957_ = true;
                }
                let _e177 = phi_956_;
                let _e179 = phi_957_;
                phi_958_ = _e177;
                phi_959_ = _e179;
            } else {
                phi_958_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_959_ = true;
            }
            let _e181 = phi_958_;
            let _e183 = phi_959_;
            if _e183 {
                let _e189 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e195 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e189.unnamed.visibility, false), _e189.unnamed_1);
                phi_966_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e195.unnamed, true);
            } else {
                phi_966_ = _e181;
            }
            let _e200 = phi_966_;
            phi_970_ = _e200;
        } else {
            let _e206 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e212 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e206.unnamed.visibility, false), _e206.unnamed_1);
            phi_970_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e212.unnamed, true);
        }
        let _e217 = phi_970_;
        if _e217.unnamed_1 {
            phi_1446_ = evaluate_Verdict(_e217.unnamed.visibility, _e217.unnamed.is_doubted);
        } else {
            let _e225 = samples.member[(0u + _e56.first_primitive)].position;
            let _e243 = ((((_e66.projection.row_w.x * _e225.x) + (_e66.projection.row_w.y * _e225.y)) + (_e66.projection.row_w.z * _e225.z)) + (_e66.projection.row_w.w * 1f));
            let _e257 = (((((_e66.projection.row_x.x * _e225.x) + (_e66.projection.row_x.y * _e225.y)) + (_e66.projection.row_x.z * _e225.z)) + (_e66.projection.row_x.w * 1f)) / _e243);
            let _e271 = (((((_e66.projection.row_y.x * _e225.x) + (_e66.projection.row_y.y * _e225.y)) + (_e66.projection.row_y.z * _e225.z)) + (_e66.projection.row_y.w * 1f)) / _e243);
            let _e284 = ((((_e66.projection.row_z.x * _e225.x) + (_e66.projection.row_z.y * _e225.y)) + (_e66.projection.row_z.z * _e225.z)) + (_e66.projection.row_z.w * 1f));
            if (_e243 > 0f) {
                if (_e257 >= 0f) {
                    phi_1044_ = (_e257 <= 1f);
                } else {
                    phi_1044_ = false;
                }
                let _e289 = phi_1044_;
                if _e289 {
                    if (_e271 >= 0f) {
                        phi_1053_ = (_e271 <= 1f);
                    } else {
                        phi_1053_ = false;
                    }
                    let _e293 = phi_1053_;
                    if _e293 {
                        if (_e284 >= 0f) {
                            phi_1062_ = (_e284 <= 1f);
                        } else {
                            phi_1062_ = false;
                        }
                        let _e297 = phi_1062_;
                        phi_1063_ = _e297;
                        phi_1064_ = false;
                    } else {
                        phi_1063_ = bool();
                        phi_1064_ = true;
                    }
                    let _e299 = phi_1063_;
                    let _e301 = phi_1064_;
                    phi_1065_ = _e299;
                    phi_1066_ = _e301;
                } else {
                    phi_1065_ = bool();
                    phi_1066_ = true;
                }
                let _e303 = phi_1065_;
                let _e305 = phi_1066_;
                phi_1067_ = _e303;
                phi_1068_ = _e305;
            } else {
                phi_1067_ = bool();
                phi_1068_ = true;
            }
            let _e307 = phi_1067_;
            let _e309 = phi_1068_;
            if _e309 {
                phi_1072_ = false;
            } else {
                phi_1072_ = _e307;
            }
            let _e311 = phi_1072_;
            if _e311 {
                if (0f > 0f) {
                    let _e314 = samples.member[(0u + _e56.first_primitive)].normal;
                    let _e316 = p.member.map_size;
                    let _e386 = ((abs(((((_e62.row_x.x * _e314.x) + (_e62.row_x.y * _e314.y)) + (_e62.row_x.z * _e314.z)) / (((_e62.row_x.x * _e62.row_x.x) + (_e62.row_x.y * _e62.row_x.y)) + (_e62.row_x.z * _e62.row_x.z)))) + abs(((((_e62.row_y.x * _e314.x) + (_e62.row_y.y * _e314.y)) + (_e62.row_y.z * _e314.z)) / (((_e62.row_y.x * _e62.row_y.x) + (_e62.row_y.y * _e62.row_y.y)) + (_e62.row_y.z * _e62.row_y.z))))) / (abs(((((_e62.row_z.x * _e314.x) + (_e62.row_z.y * _e314.y)) + (_e62.row_z.z * _e314.z)) / (((_e62.row_z.x * _e62.row_z.x) + (_e62.row_z.y * _e62.row_z.y)) + (_e62.row_z.z * _e62.row_z.z)))) * f32(_e316)));
                    if (_e386 < 0.002f) {
                        phi_1162_ = _e386;
                    } else {
                        phi_1162_ = 0.002f;
                    }
                    let _e389 = phi_1162_;
                    phi_1165_ = (_e284 - (0f * _e389));
                } else {
                    phi_1165_ = _e284;
                }
                let _e393 = phi_1165_;
                let _e395 = p.member.map_size;
                let _e396 = f32(_e395);
                let _e399 = ((_e257 * _e396) - 0.5f);
                let _e400 = ((_e271 * _e396) - 0.5f);
                if (_e399 > -8388608f) {
                    let _e412 = f32(select(0i, select(select(i32(_e399), i32(-2147483648), (_e399 < bitcast<f32>(3472883712u))), 2147483647i, (_e399 > bitcast<f32>(1325400063u))), (_e399 == _e399)));
                    if (_e412 > _e399) {
                        phi_1194_ = 1f;
                    } else {
                        phi_1194_ = 0f;
                    }
                    let _e415 = phi_1194_;
                    if (_e399 < 8388608f) {
                        phi_1199_ = (_e412 - _e415);
                        phi_1200_ = false;
                    } else {
                        phi_1199_ = f32();
                        phi_1200_ = true;
                    }
                    let _e418 = phi_1199_;
                    let _e420 = phi_1200_;
                    phi_1201_ = _e418;
                    phi_1202_ = _e420;
                } else {
                    phi_1201_ = f32();
                    phi_1202_ = true;
                }
                let _e422 = phi_1201_;
                let _e424 = phi_1202_;
                if _e424 {
                    phi_1206_ = _e399;
                } else {
                    phi_1206_ = _e422;
                }
                let _e426 = phi_1206_;
                if (_e400 > -8388608f) {
                    let _e438 = f32(select(0i, select(select(i32(_e400), i32(-2147483648), (_e400 < bitcast<f32>(3472883712u))), 2147483647i, (_e400 > bitcast<f32>(1325400063u))), (_e400 == _e400)));
                    if (_e438 > _e400) {
                        phi_1226_ = 1f;
                    } else {
                        phi_1226_ = 0f;
                    }
                    let _e441 = phi_1226_;
                    if (_e400 < 8388608f) {
                        phi_1231_ = (_e438 - _e441);
                        phi_1232_ = false;
                    } else {
                        phi_1231_ = f32();
                        phi_1232_ = true;
                    }
                    let _e444 = phi_1231_;
                    let _e446 = phi_1232_;
                    phi_1233_ = _e444;
                    phi_1234_ = _e446;
                } else {
                    phi_1233_ = f32();
                    phi_1234_ = true;
                }
                let _e448 = phi_1233_;
                let _e450 = phi_1234_;
                if _e450 {
                    phi_1238_ = _e400;
                } else {
                    phi_1238_ = _e448;
                }
                let _e452 = phi_1238_;
                let _e453 = (_e399 - _e426);
                let _e454 = (_e400 - _e452);
                let _e463 = select(0i, select(select(i32(_e426), i32(-2147483648), (_e426 < bitcast<f32>(3472883712u))), 2147483647i, (_e426 > bitcast<f32>(1325400063u))), (_e426 == _e426));
                let _e472 = select(0i, select(select(i32(_e452), i32(-2147483648), (_e452 < bitcast<f32>(3472883712u))), 2147483647i, (_e452 > bitcast<f32>(1325400063u))), (_e452 == _e452));
                let _e483 = p.member.test;
                let _e484 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e483);
                let _e486 = p.member.map_size;
                local = _e484;
                let _e488 = ((0u * _e486) * _e486);
                let _e490 = (bitcast<i32>(_e486) - 1i);
                if (_e463 > 0i) {
                    phi_1286_ = _e463;
                } else {
                    phi_1286_ = 0i;
                }
                let _e493 = phi_1286_;
                if (_e472 > 0i) {
                    phi_1291_ = _e472;
                } else {
                    phi_1291_ = 0i;
                }
                let _e496 = phi_1291_;
                if (_e493 < _e490) {
                    phi_1296_ = _e493;
                } else {
                    phi_1296_ = _e490;
                }
                let _e499 = phi_1296_;
                if (_e496 < _e490) {
                    phi_1301_ = _e496;
                } else {
                    phi_1301_ = _e490;
                }
                let _e502 = phi_1301_;
                let _e503 = bitcast<u32>(_e499);
                let _e505 = (_e463 + 1i);
                let _e506 = (_e472 + 1i);
                if (_e505 > 0i) {
                    phi_1310_ = _e505;
                } else {
                    phi_1310_ = 0i;
                }
                let _e509 = phi_1310_;
                if (_e506 > 0i) {
                    phi_1315_ = _e506;
                } else {
                    phi_1315_ = 0i;
                }
                let _e512 = phi_1315_;
                if (_e509 < _e490) {
                    phi_1320_ = _e509;
                } else {
                    phi_1320_ = _e490;
                }
                let _e515 = phi_1320_;
                if (_e512 < _e490) {
                    phi_1325_ = _e512;
                } else {
                    phi_1325_ = _e490;
                }
                let _e518 = phi_1325_;
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
                let _e548 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e534, _e538, _e542, _e546), vec4<f32>(((1f - _e453) * (1f - _e454)), (_e453 * (1f - _e454)), ((1f - _e453) * _e454), (_e453 * _e454)), _e393);
                let _e552 = p.member.epsilon;
                if (_e548 <= _e552) {
                    phi_1378_ = true;
                } else {
                    phi_1378_ = (_e548 >= (1f - _e552));
                }
                let _e557 = phi_1378_;
                if ((bitcast<u32>(_e548) & 2147483647u) > 2139095040u) {
                    phi_1386_ = true;
                } else {
                    phi_1386_ = !(_e557);
                }
                let _e563 = phi_1386_;
                if _e563 {
                    if (_e548 > 0f) {
                        if (_e548 < 1f) {
                            phi_1398_ = false;
                        } else {
                            phi_1398_ = true;
                        }
                        let _e567 = phi_1398_;
                        phi_1399_ = _e567;
                    } else {
                        phi_1399_ = true;
                    }
                    let _e569 = phi_1399_;
                    if _e569 {
                        phi_1403_ = 0.5f;
                    } else {
                        phi_1403_ = _e548;
                    }
                    let _e571 = phi_1403_;
                    phi_1411_ = evaluate_Verdict(_e571, true);
                } else {
                    if (_e548 > 0.5f) {
                        phi_1409_ = 1f;
                    } else {
                        phi_1409_ = 0f;
                    }
                    let _e575 = phi_1409_;
                    phi_1411_ = evaluate_Verdict(_e575, false);
                }
                let _e578 = phi_1411_;
                let _e581 = (_e578.visibility < 0.5f);
                if _e578.is_doubted {
                    phi_1434_ = evaluate_Verdict();
                    phi_1435_ = true;
                } else {
                    if _e581 {
                        phi_1421_ = 2u;
                    } else {
                        phi_1421_ = 1u;
                    }
                    let _e583 = phi_1421_;
                    if ((0u & _e583) != 0u) {
                        if _e581 {
                            phi_1430_ = 0.000000059604645f;
                        } else {
                            phi_1430_ = 0.99999994f;
                        }
                        let _e587 = phi_1430_;
                        phi_1432_ = evaluate_Verdict(_e587, true);
                        phi_1433_ = false;
                    } else {
                        phi_1432_ = evaluate_Verdict();
                        phi_1433_ = true;
                    }
                    let _e590 = phi_1432_;
                    let _e592 = phi_1433_;
                    phi_1434_ = _e590;
                    phi_1435_ = _e592;
                }
                let _e594 = phi_1434_;
                let _e596 = phi_1435_;
                if _e596 {
                    phi_1440_ = evaluate_Verdict(_e578.visibility, _e578.is_doubted);
                } else {
                    phi_1440_ = _e594;
                }
                let _e599 = phi_1440_;
                phi_1445_ = evaluate_Verdict(_e599.visibility, _e599.is_doubted);
            } else {
                phi_1445_ = evaluate_Verdict(0.5f, true);
            }
            let _e605 = phi_1445_;
            phi_1446_ = _e605;
        }
        let _e607 = phi_1446_;
        if (_e56.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e56.first_primitive)] = _e607.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_msm_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
