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

struct type_39 {
    member: abi_ShadowParams,
}

struct lt_math_LightPoint {
    uv: vec2<f32>,
    depth: f32,
    is_inside: bool,
}

struct lt_bvh_slab_Span {
    near: f32,
    far: f32,
}

struct type_45 {
    member: array<lt_math_LightProjection>,
}

struct lt_math_LevelPoint {
    level: u32,
    point: lt_math_LightPoint,
}

struct type_51 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
var<private> local_5: u32;
@group(0) @binding(1) 
var<storage> samples: type_20;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(0) 
var<uniform> p: type_39;
@group(0) @binding(2) 
var<storage> map: type_24;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_24;
@group(0) @binding(4) 
var<storage, read_write> list: type_51;
@group(0) @binding(5) 
var<storage> levels: type_45;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_164_: lt_bvh_traverse_Tree;
    var phi_165_: bool;
    var phi_166_: lt_bvh_traverse_Tree;
    var phi_167_: bool;
    var phi_172_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_164_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_165_ = false;
        } else {
            phi_164_ = lt_bvh_traverse_Tree();
            phi_165_ = true;
        }
        let _e59 = phi_164_;
        let _e61 = phi_165_;
        phi_166_ = _e59;
        phi_167_ = _e61;
    } else {
        phi_166_ = lt_bvh_traverse_Tree();
        phi_167_ = true;
    }
    let _e63 = phi_166_;
    let _e65 = phi_167_;
    if _e65 {
        phi_172_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_172_ = _e63;
    }
    let _e70 = phi_172_;
    return lt_bvh_traverse_Tree(_e70.root, _e70.first_primitive);
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_199_: f32;
    var phi_200_: f32;
    var phi_201_: f32;
    var phi_218_: f32;
    var phi_219_: f32;
    var phi_220_: f32;
    var phi_236_: f32;
    var phi_237_: f32;
    var phi_238_: f32;
    var phi_254_: f32;
    var phi_255_: f32;
    var phi_256_: f32;
    var phi_272_: f32;
    var phi_273_: f32;
    var phi_274_: f32;
    var phi_309_: bool;
    var phi_310_: bool;
    var phi_311_: bool;
    var phi_312_: bool;
    var phi_313_: bool;
    var phi_314_: bool;
    var phi_318_: bool;
    var phi_629_: f32;
    var phi_630_: f32;
    var phi_631_: f32;
    var phi_648_: f32;
    var phi_649_: f32;
    var phi_650_: f32;
    var phi_667_: f32;
    var phi_668_: f32;
    var phi_669_: f32;
    var phi_686_: f32;
    var phi_687_: f32;
    var phi_688_: f32;
    var phi_711_: f32;
    var phi_712_: f32;
    var phi_713_: f32;
    var phi_760_: f32;
    var phi_761_: f32;
    var phi_762_: f32;
    var phi_779_: f32;
    var phi_780_: f32;
    var phi_781_: f32;
    var phi_798_: f32;
    var phi_799_: f32;
    var phi_800_: f32;
    var phi_817_: f32;
    var phi_818_: f32;
    var phi_819_: f32;
    var phi_842_: f32;
    var phi_843_: f32;
    var phi_844_: f32;
    var phi_923_: bool;
    var phi_967_: f32;
    var phi_968_: f32;
    var phi_969_: bool;
    var phi_970_: f32;
    var phi_971_: bool;
    var phi_972_: f32;
    var phi_973_: bool;
    var phi_977_: f32;
    var phi_978_: f32;
    var phi_997_: f32;
    var phi_998_: f32;
    var phi_999_: f32;
    var phi_1010_: f32;
    var phi_1025_: f32;
    var phi_1027_: lt_bvh_slab_Span;
    var phi_1085_: f32;
    var phi_1086_: f32;
    var phi_1087_: f32;
    var phi_1088_: f32;
    var phi_1089_: f32;
    var phi_1090_: bool;
    var phi_1094_: f32;
    var phi_1109_: f32;
    var phi_1110_: f32;
    var phi_1111_: f32;
    var phi_1112_: f32;
    var phi_1113_: f32;
    var phi_1114_: f32;
    var phi_1115_: f32;
    var phi_1116_: bool;
    var phi_1120_: f32;
    var phi_1121_: f32;
    var phi_1122_: bool;
    var phi_1123_: f32;
    var phi_1124_: f32;
    var phi_1125_: bool;
    var phi_1129_: f32;

    let _e50 = (*param_4);
    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_201_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_200_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_199_ = 1f;
            } else {
                phi_199_ = param_7;
            }
            let _e57 = phi_199_;
            phi_200_ = _e57;
        }
        let _e59 = phi_200_;
        phi_201_ = _e59;
    }
    let _e61 = phi_201_;
    let _e62 = (_e61 - 0.00000047683716f);
    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_220_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_219_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_218_ = 1f;
            } else {
                phi_218_ = param_5.x;
            }
            let _e70 = phi_218_;
            phi_219_ = _e70;
        }
        let _e72 = phi_219_;
        phi_220_ = _e72;
    }
    let _e74 = phi_220_;
    if ((bitcast<u32>(param_5.y) & 2147483647u) > 2139095040u) {
        phi_238_ = param_5.y;
    } else {
        if (param_5.y < 0f) {
            phi_237_ = 0f;
        } else {
            if (param_5.y > 1f) {
                phi_236_ = 1f;
            } else {
                phi_236_ = param_5.y;
            }
            let _e82 = phi_236_;
            phi_237_ = _e82;
        }
        let _e84 = phi_237_;
        phi_238_ = _e84;
    }
    let _e86 = phi_238_;
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_256_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_255_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_254_ = 1f;
            } else {
                phi_254_ = param_5.z;
            }
            let _e94 = phi_254_;
            phi_255_ = _e94;
        }
        let _e96 = phi_255_;
        phi_256_ = _e96;
    }
    let _e98 = phi_256_;
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_274_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_273_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_272_ = 1f;
            } else {
                phi_272_ = param_5.w;
            }
            let _e106 = phi_272_;
            phi_273_ = _e106;
        }
        let _e108 = phi_273_;
        phi_274_ = _e108;
    }
    let _e110 = phi_274_;
    let _e111 = (_e74 - _e62);
    let _e112 = (_e86 - _e62);
    let _e113 = (_e98 - _e62);
    let _e114 = (_e110 - _e62);
    let _e125 = ((((_e111 * param_6.x) + (_e112 * param_6.y)) + (_e113 * param_6.z)) + (_e114 * param_6.w));
    if ((bitcast<u32>(_e125) & 2147483647u) > 2139095040u) {
        phi_1123_ = _e125;
        phi_1124_ = f32();
        phi_1125_ = true;
    } else {
        if (_e111 >= 0f) {
            if (_e112 >= 0f) {
                if (_e113 >= 0f) {
                    phi_309_ = (_e114 >= 0f);
                    phi_310_ = false;
                } else {
                    phi_309_ = bool();
                    phi_310_ = true;
                }
                let _e134 = phi_309_;
                let _e136 = phi_310_;
                phi_311_ = _e134;
                phi_312_ = _e136;
            } else {
                phi_311_ = bool();
                phi_312_ = true;
            }
            let _e138 = phi_311_;
            let _e140 = phi_312_;
            phi_313_ = _e138;
            phi_314_ = _e140;
        } else {
            phi_313_ = bool();
            phi_314_ = true;
        }
        let _e142 = phi_313_;
        let _e144 = phi_314_;
        if _e144 {
            phi_318_ = false;
        } else {
            phi_318_ = _e142;
        }
        let _e146 = phi_318_;
        if _e146 {
            phi_1120_ = 1f;
            phi_1121_ = f32();
            phi_1122_ = true;
        } else {
            let _e147 = (0.5f * _e50);
            let _e148 = (1f - _e50);
            let _e150 = (param_6.x * _e148);
            let _e152 = (param_6.y * _e148);
            let _e154 = (param_6.z * _e148);
            let _e156 = (param_6.w * _e148);
            let _e157 = -(_e62);
            let _e158 = (1f - _e62);
            let _e160 = (vec4<f32>(1f, 1f, 1f, 1f).x - _e74);
            let _e162 = (vec4<f32>(1f, 1f, 1f, 1f).y - _e86);
            let _e164 = (vec4<f32>(1f, 1f, 1f, 1f).z - _e98);
            let _e166 = (vec4<f32>(1f, 1f, 1f, 1f).w - _e110);
            let _e167 = (_e111 - _e112);
            let _e168 = (_e112 - _e113);
            let _e169 = (_e113 - _e114);
            let _e170 = (_e114 - _e111);
            let _e171 = (_e167 * _e167);
            let _e172 = (_e168 * _e168);
            let _e173 = (_e169 * _e169);
            let _e174 = (_e170 * _e170);
            let _e175 = (_e111 - _e113);
            let _e176 = (_e112 - _e114);
            let _e177 = (_e113 - _e111);
            let _e178 = (_e114 - _e112);
            let _e179 = (_e175 * _e175);
            let _e180 = (_e176 * _e176);
            let _e181 = (_e177 * _e177);
            let _e182 = (_e178 * _e178);
            let _e187 = ((_e150 * _e152) * _e171);
            let _e188 = ((_e152 * _e154) * _e172);
            let _e189 = ((_e154 * _e156) * _e173);
            let _e190 = ((_e156 * _e150) * _e174);
            let _e199 = (((0.5f * _e150) * _e154) * _e179);
            let _e200 = (((0.5f * _e152) * _e156) * _e180);
            let _e201 = (((0.5f * _e154) * _e150) * _e181);
            let _e202 = (((0.5f * _e156) * _e152) * _e182);
            let _e203 = (_e111 * _e112);
            let _e204 = (_e112 * _e113);
            let _e205 = (_e113 * _e114);
            let _e206 = (_e114 * _e111);
            let _e207 = (_e111 * _e113);
            let _e208 = (_e112 * _e114);
            let _e209 = (_e113 * _e111);
            let _e210 = (_e114 * _e112);
            let _e211 = (_e187 * _e203);
            let _e212 = (_e188 * _e204);
            let _e213 = (_e189 * _e205);
            let _e214 = (_e190 * _e206);
            let _e215 = (_e199 * _e207);
            let _e216 = (_e200 * _e208);
            let _e217 = (_e201 * _e209);
            let _e218 = (_e202 * _e210);
            let _e219 = (_e74 * _e74);
            let _e220 = (_e86 * _e86);
            let _e221 = (_e98 * _e98);
            let _e222 = (_e110 * _e110);
            let _e223 = (_e160 * _e160);
            let _e224 = (_e162 * _e162);
            let _e225 = (_e164 * _e164);
            let _e226 = (_e166 * _e166);
            let _e227 = (_e147 * _e150);
            let _e228 = (_e147 * _e152);
            let _e229 = (_e147 * _e154);
            let _e230 = (_e147 * _e156);
            let _e239 = (((_e227 * _e111) * _e219) * _e157);
            let _e240 = (((_e228 * _e112) * _e220) * _e157);
            let _e241 = (((_e229 * _e113) * _e221) * _e157);
            let _e242 = (((_e230 * _e114) * _e222) * _e157);
            let _e251 = (((_e227 * _e111) * _e223) * _e158);
            let _e252 = (((_e228 * _e112) * _e224) * _e158);
            let _e253 = (((_e229 * _e113) * _e225) * _e158);
            let _e254 = (((_e230 * _e114) * _e226) * _e158);
            let _e422 = (((((((_e187 * _e154) * _e172) * _e179) + (_e147 * (((_e187 * ((_e219 * _e220) + (_e223 * _e224))) + (_e199 * ((_e219 * _e221) + (_e223 * _e225)))) + ((_e227 * _e219) * _e223)))) + ((((_e188 * _e156) * _e173) * _e180) + (_e147 * (((_e188 * ((_e220 * _e221) + (_e224 * _e225))) + (_e200 * ((_e220 * _e222) + (_e224 * _e226)))) + ((_e228 * _e220) * _e224))))) + ((((_e189 * _e150) * _e174) * _e181) + (_e147 * (((_e189 * ((_e221 * _e222) + (_e225 * _e226))) + (_e201 * ((_e221 * _e219) + (_e225 * _e223)))) + ((_e229 * _e221) * _e225))))) + ((((_e190 * _e152) * _e171) * _e182) + (_e147 * (((_e190 * ((_e222 * _e219) + (_e226 * _e223))) + (_e202 * ((_e222 * _e220) + (_e226 * _e224)))) + ((_e230 * _e222) * _e226)))));
            let _e425 = (((_e147 * _e147) * _e157) * _e158);
            let _e428 = (((((((_e211 * _e203) + (_e215 * _e207)) + (_e111 * ((_e239 * _e157) + (_e251 * _e158)))) + (((_e212 * _e204) + (_e216 * _e208)) + (_e112 * ((_e240 * _e157) + (_e252 * _e158))))) + (((_e213 * _e205) + (_e217 * _e209)) + (_e113 * ((_e241 * _e157) + (_e253 * _e158))))) + (((_e214 * _e206) + (_e218 * _e210)) + (_e114 * ((_e242 * _e157) + (_e254 * _e158))))) + ((_e425 * _e157) * _e158));
            if (_e428 < 0.0000000000000000000000000000000001f) {
                if ((bitcast<u32>(_e111) & 2147483647u) > 2139095040u) {
                    phi_631_ = _e111;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_630_ = 0f;
                    } else {
                        if (_e111 < 0f) {
                            phi_629_ = 0f;
                        } else {
                            phi_629_ = 1f;
                        }
                        let _e443 = phi_629_;
                        phi_630_ = _e443;
                    }
                    let _e445 = phi_630_;
                    phi_631_ = _e445;
                }
                let _e447 = phi_631_;
                if ((bitcast<u32>(_e112) & 2147483647u) > 2139095040u) {
                    phi_650_ = _e112;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_649_ = 0f;
                    } else {
                        if (_e112 < 0f) {
                            phi_648_ = 0f;
                        } else {
                            phi_648_ = 1f;
                        }
                        let _e456 = phi_648_;
                        phi_649_ = _e456;
                    }
                    let _e458 = phi_649_;
                    phi_650_ = _e458;
                }
                let _e460 = phi_650_;
                if ((bitcast<u32>(_e113) & 2147483647u) > 2139095040u) {
                    phi_669_ = _e113;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_668_ = 0f;
                    } else {
                        if (_e113 < 0f) {
                            phi_667_ = 0f;
                        } else {
                            phi_667_ = 1f;
                        }
                        let _e469 = phi_667_;
                        phi_668_ = _e469;
                    }
                    let _e471 = phi_668_;
                    phi_669_ = _e471;
                }
                let _e473 = phi_669_;
                if ((bitcast<u32>(_e114) & 2147483647u) > 2139095040u) {
                    phi_688_ = _e114;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_687_ = 0f;
                    } else {
                        if (_e114 < 0f) {
                            phi_686_ = 0f;
                        } else {
                            phi_686_ = 1f;
                        }
                        let _e482 = phi_686_;
                        phi_687_ = _e482;
                    }
                    let _e484 = phi_687_;
                    phi_688_ = _e484;
                }
                let _e486 = phi_688_;
                let _e494 = (((((_e447 * _e150) + (_e460 * _e152)) + (_e473 * _e154)) + (_e486 * _e156)) + _e147);
                if ((bitcast<u32>(_e494) & 2147483647u) > 2139095040u) {
                    phi_713_ = _e494;
                } else {
                    if (_e494 < 0f) {
                        phi_712_ = 0f;
                    } else {
                        if (_e494 > 1f) {
                            phi_711_ = 1f;
                        } else {
                            phi_711_ = _e494;
                        }
                        let _e501 = phi_711_;
                        phi_712_ = _e501;
                    }
                    let _e503 = phi_712_;
                    phi_713_ = _e503;
                }
                let _e505 = phi_713_;
                phi_1114_ = _e505;
                phi_1115_ = f32();
                phi_1116_ = true;
            } else {
                let _e510 = ((_e150 * _e74) * _e160);
                let _e511 = ((_e152 * _e86) * _e162);
                let _e512 = ((_e154 * _e98) * _e164);
                let _e513 = ((_e156 * _e110) * _e166);
                let _e520 = ((((_e510 * _e111) + (_e511 * _e112)) + (_e512 * _e113)) + (_e513 * _e114));
                let _e531 = ((((_e510 * (_e111 * _e111)) + (_e511 * (_e112 * _e112))) + (_e512 * (_e113 * _e113))) + (_e513 * (_e114 * _e114)));
                if (_e531 < 0.0000000000000000000000000000000001f) {
                    if ((bitcast<u32>(_e111) & 2147483647u) > 2139095040u) {
                        phi_762_ = _e111;
                    } else {
                        if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                            phi_761_ = 0f;
                        } else {
                            if (_e111 < 0f) {
                                phi_760_ = 0f;
                            } else {
                                phi_760_ = 1f;
                            }
                            let _e541 = phi_760_;
                            phi_761_ = _e541;
                        }
                        let _e543 = phi_761_;
                        phi_762_ = _e543;
                    }
                    let _e545 = phi_762_;
                    if ((bitcast<u32>(_e112) & 2147483647u) > 2139095040u) {
                        phi_781_ = _e112;
                    } else {
                        if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                            phi_780_ = 0f;
                        } else {
                            if (_e112 < 0f) {
                                phi_779_ = 0f;
                            } else {
                                phi_779_ = 1f;
                            }
                            let _e554 = phi_779_;
                            phi_780_ = _e554;
                        }
                        let _e556 = phi_780_;
                        phi_781_ = _e556;
                    }
                    let _e558 = phi_781_;
                    if ((bitcast<u32>(_e113) & 2147483647u) > 2139095040u) {
                        phi_800_ = _e113;
                    } else {
                        if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                            phi_799_ = 0f;
                        } else {
                            if (_e113 < 0f) {
                                phi_798_ = 0f;
                            } else {
                                phi_798_ = 1f;
                            }
                            let _e567 = phi_798_;
                            phi_799_ = _e567;
                        }
                        let _e569 = phi_799_;
                        phi_800_ = _e569;
                    }
                    let _e571 = phi_800_;
                    if ((bitcast<u32>(_e114) & 2147483647u) > 2139095040u) {
                        phi_819_ = _e114;
                    } else {
                        if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                            phi_818_ = 0f;
                        } else {
                            if (_e114 < 0f) {
                                phi_817_ = 0f;
                            } else {
                                phi_817_ = 1f;
                            }
                            let _e580 = phi_817_;
                            phi_818_ = _e580;
                        }
                        let _e582 = phi_818_;
                        phi_819_ = _e582;
                    }
                    let _e584 = phi_819_;
                    let _e592 = (((((_e545 * _e150) + (_e558 * _e152)) + (_e571 * _e154)) + (_e584 * _e156)) + _e147);
                    if ((bitcast<u32>(_e592) & 2147483647u) > 2139095040u) {
                        phi_844_ = _e592;
                    } else {
                        if (_e592 < 0f) {
                            phi_843_ = 0f;
                        } else {
                            if (_e592 > 1f) {
                                phi_842_ = 1f;
                            } else {
                                phi_842_ = _e592;
                            }
                            let _e599 = phi_842_;
                            phi_843_ = _e599;
                        }
                        let _e601 = phi_843_;
                        phi_844_ = _e601;
                    }
                    let _e603 = phi_844_;
                    phi_978_ = _e603;
                } else {
                    let _e605 = (_e531 - (_e157 * _e520));
                    let _e607 = ((_e158 * _e520) - _e531);
                    let _e612 = ((_e150 * _e111) * _e160);
                    let _e613 = ((_e152 * _e112) * _e162);
                    let _e614 = ((_e154 * _e113) * _e164);
                    let _e615 = ((_e156 * _e114) * _e166);
                    let _e641 = (_e147 + (((((_e612 * ((_e613 * _e171) + ((0.5f * _e614) * _e179))) + (_e613 * ((_e614 * _e172) + ((0.5f * _e615) * _e180)))) + (_e614 * ((_e615 * _e173) + ((0.5f * _e612) * _e181)))) + (_e615 * ((_e612 * _e174) + ((0.5f * _e613) * _e182)))) / (_e157 * _e605)));
                    let _e646 = ((_e150 * _e111) * _e74);
                    let _e647 = ((_e152 * _e112) * _e86);
                    let _e648 = ((_e154 * _e113) * _e98);
                    let _e649 = ((_e156 * _e114) * _e110);
                    let _e675 = (_e147 + (((((_e646 * ((_e647 * _e171) + ((0.5f * _e648) * _e179))) + (_e647 * ((_e648 * _e172) + ((0.5f * _e649) * _e180)))) + (_e648 * ((_e649 * _e173) + ((0.5f * _e646) * _e181)))) + (_e649 * ((_e646 * _e174) + ((0.5f * _e647) * _e182)))) / (_e158 * _e607)));
                    let _e676 = (_e520 > 0f);
                    if _e676 {
                        phi_923_ = (_e607 > 0f);
                    } else {
                        phi_923_ = (_e605 < 0f);
                    }
                    let _e680 = phi_923_;
                    if _e680 {
                        if (_e641 >= 0f) {
                            if (_e675 >= 0f) {
                                if _e676 {
                                    phi_967_ = (1f - _e641);
                                } else {
                                    phi_967_ = ((((((_e510 * ((_e511 * _e171) + ((0.5f * _e512) * _e179))) + (_e511 * ((_e512 * _e172) + ((0.5f * _e513) * _e180)))) + (_e512 * ((_e513 * _e173) + ((0.5f * _e510) * _e181)))) + (_e513 * ((_e510 * _e174) + ((0.5f * _e511) * _e182)))) / (_e531 * (-(_e157) * _e158))) + _e675);
                                }
                                let _e713 = phi_967_;
                                phi_968_ = _e713;
                                phi_969_ = false;
                            } else {
                                phi_968_ = f32();
                                phi_969_ = true;
                            }
                            let _e715 = phi_968_;
                            let _e717 = phi_969_;
                            phi_970_ = _e715;
                            phi_971_ = _e717;
                        } else {
                            phi_970_ = f32();
                            phi_971_ = true;
                        }
                        let _e719 = phi_970_;
                        let _e721 = phi_971_;
                        phi_972_ = _e719;
                        phi_973_ = _e721;
                    } else {
                        phi_972_ = f32();
                        phi_973_ = true;
                    }
                    let _e723 = phi_972_;
                    let _e725 = phi_973_;
                    if _e725 {
                        phi_977_ = 1f;
                    } else {
                        phi_977_ = _e723;
                    }
                    let _e727 = phi_977_;
                    phi_978_ = _e727;
                }
                let _e729 = phi_978_;
                let _e730 = (_e729 < 1f);
                if _e730 {
                    if ((bitcast<u32>(_e729) & 2147483647u) > 2139095040u) {
                        phi_999_ = _e729;
                    } else {
                        if (_e729 < 0f) {
                            phi_998_ = 0f;
                        } else {
                            if (_e729 > 1f) {
                                phi_997_ = 1f;
                            } else {
                                phi_997_ = _e729;
                            }
                            let _e737 = phi_997_;
                            phi_998_ = _e737;
                        }
                        let _e739 = phi_998_;
                        phi_999_ = _e739;
                    }
                    let _e741 = phi_999_;
                    phi_1112_ = _e741;
                    phi_1113_ = f32();
                } else {
                    let _e743 = ((0.5f * -(((((((((_e211 * (_e111 + _e112)) + (_e215 * (_e111 + _e113))) + (_e239 * (_e111 + _e157))) + (_e251 * (_e111 + _e158))) + ((((_e212 * (_e112 + _e113)) + (_e216 * (_e112 + _e114))) + (_e240 * (_e112 + _e157))) + (_e252 * (_e112 + _e158)))) + ((((_e213 * (_e113 + _e114)) + (_e217 * (_e113 + _e111))) + (_e241 * (_e113 + _e157))) + (_e253 * (_e113 + _e158)))) + ((((_e214 * (_e114 + _e111)) + (_e218 * (_e114 + _e112))) + (_e242 * (_e114 + _e157))) + (_e254 * (_e114 + _e158)))) + (_e425 * (_e157 + _e158))))) / _e428);
                    let _e744 = ((((((((_e211 + _e215) + _e239) + _e251) + (((_e212 + _e216) + _e240) + _e252)) + (((_e213 + _e217) + _e241) + _e253)) + (((_e214 + _e218) + _e242) + _e254)) + _e425) / _e428);
                    let _e746 = ((_e743 * _e743) - _e744);
                    if (_e746 > 0f) {
                        phi_1010_ = sqrt(_e746);
                    } else {
                        phi_1010_ = 0f;
                    }
                    let _e750 = phi_1010_;
                    if (_e743 > 0f) {
                        let _e753 = (-(_e743) - _e750);
                        phi_1027_ = lt_bvh_slab_Span(_e753, (_e744 / _e753));
                    } else {
                        let _e756 = (_e750 - _e743);
                        if (_e756 > 0f) {
                            phi_1025_ = (_e744 / _e756);
                        } else {
                            phi_1025_ = 0f;
                        }
                        let _e760 = phi_1025_;
                        phi_1027_ = lt_bvh_slab_Span(_e760, _e756);
                    }
                    let _e763 = phi_1027_;
                    if (_e763.near >= 0f) {
                        phi_1088_ = 1f;
                        phi_1089_ = f32();
                        phi_1090_ = true;
                    } else {
                        let _e767 = (_e763.far <= 0f);
                        if _e767 {
                            phi_1086_ = (_e422 / _e428);
                            phi_1087_ = f32();
                        } else {
                            let _e778 = (((((_e150 * _e111) + (_e152 * _e112)) + (_e154 * _e113)) + (_e156 * _e114)) + (_e147 * (_e157 + _e158)));
                            let _e794 = (((((_e150 * (_e111 * _e111)) + (_e152 * (_e112 * _e112))) + (_e154 * (_e113 * _e113))) + (_e156 * (_e114 * _e114))) + (_e147 * ((_e157 * _e157) + (_e158 * _e158))));
                            if (-(_e763.near) <= _e763.far) {
                                phi_1085_ = (1f - (((_e763.near * _e763.near) * ((_e763.far * _e794) - _e778)) / (_e763.far - _e763.near)));
                            } else {
                                phi_1085_ = ((_e422 / _e428) + (((_e763.far * _e763.far) * (_e778 - (_e763.near * _e794))) / (_e763.far - _e763.near)));
                            }
                            let _e813 = phi_1085_;
                            phi_1086_ = f32();
                            phi_1087_ = _e813;
                        }
                        let _e815 = phi_1086_;
                        let _e817 = phi_1087_;
                        phi_1088_ = _e815;
                        phi_1089_ = _e817;
                        phi_1090_ = _e767;
                    }
                    let _e819 = phi_1088_;
                    let _e821 = phi_1089_;
                    let _e823 = phi_1090_;
                    if _e823 {
                        phi_1094_ = _e819;
                    } else {
                        phi_1094_ = _e821;
                    }
                    let _e825 = phi_1094_;
                    if ((bitcast<u32>(_e825) & 2147483647u) > 2139095040u) {
                        phi_1111_ = _e825;
                    } else {
                        if (_e825 < 0f) {
                            phi_1110_ = 0f;
                        } else {
                            if (_e825 > 1f) {
                                phi_1109_ = 1f;
                            } else {
                                phi_1109_ = _e825;
                            }
                            let _e832 = phi_1109_;
                            phi_1110_ = _e832;
                        }
                        let _e834 = phi_1110_;
                        phi_1111_ = _e834;
                    }
                    let _e836 = phi_1111_;
                    phi_1112_ = f32();
                    phi_1113_ = _e836;
                }
                let _e838 = phi_1112_;
                let _e840 = phi_1113_;
                phi_1114_ = _e838;
                phi_1115_ = _e840;
                phi_1116_ = _e730;
            }
            let _e842 = phi_1114_;
            let _e844 = phi_1115_;
            let _e846 = phi_1116_;
            if _e846 {
            }
            phi_1120_ = _e842;
            phi_1121_ = _e844;
            phi_1122_ = _e846;
        }
        let _e848 = phi_1120_;
        let _e850 = phi_1121_;
        let _e852 = phi_1122_;
        phi_1123_ = _e848;
        phi_1124_ = _e850;
        phi_1125_ = _e852;
    }
    let _e854 = phi_1123_;
    let _e856 = phi_1124_;
    let _e858 = phi_1125_;
    if _e858 {
        phi_1129_ = _e854;
    } else {
        phi_1129_ = _e856;
    }
    let _e860 = phi_1129_;
    return _e860;
}

fn function_() {
    var local_1: f32;
    var phi_1184_: bool;
    var phi_1185_: bool;
    var phi_1186_: bool;
    var phi_1187_: bool;
    var phi_1191_: bool;
    var phi_1261_: bool;
    var phi_1262_: bool;
    var phi_1273_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1274_: bool;
    var phi_1275_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1276_: bool;
    var phi_1283_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1287_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1307_: lt_math_LightPoint;
    var phi_1310_: u32;
    var phi_1312_: lt_math_LevelPoint;
    var phi_1398_: bool;
    var phi_1407_: bool;
    var phi_1416_: bool;
    var phi_1417_: bool;
    var phi_1418_: bool;
    var phi_1419_: bool;
    var phi_1420_: bool;
    var phi_1421_: bool;
    var phi_1422_: bool;
    var phi_1426_: bool;
    var phi_1453_: bool;
    var phi_1454_: bool;
    var phi_1455_: bool;
    var phi_1456_: bool;
    var phi_1457_: bool;
    var phi_1458_: bool;
    var phi_1459_: bool;
    var phi_1460_: bool;
    var phi_1464_: bool;
    var phi_1473_: lt_math_LightPoint;
    var phi_1474_: u32;
    var phi_1475_: lt_math_LevelPoint;
    var phi_1476_: bool;
    var phi_1308_: lt_math_LightPoint;
    var phi_1311_: u32;
    var phi_1313_: lt_math_LevelPoint;
    var phi_1477_: bool;
    var local_2: lt_math_LevelPoint;
    var local_3: lt_math_LevelPoint;
    var phi_1517_: bool;
    var phi_1518_: bool;
    var phi_1519_: bool;
    var phi_1520_: bool;
    var phi_1524_: bool;
    var phi_1606_: f32;
    var phi_1724_: f32;
    var phi_1725_: f32;
    var phi_1728_: f32;
    var phi_1757_: f32;
    var phi_1762_: f32;
    var phi_1763_: bool;
    var phi_1764_: f32;
    var phi_1765_: bool;
    var phi_1769_: f32;
    var phi_1789_: f32;
    var phi_1794_: f32;
    var phi_1795_: bool;
    var phi_1796_: f32;
    var phi_1797_: bool;
    var phi_1801_: f32;
    var local_4: lt_math_LevelPoint;
    var phi_1850_: i32;
    var phi_1855_: i32;
    var phi_1860_: i32;
    var phi_1865_: i32;
    var phi_1874_: i32;
    var phi_1879_: i32;
    var phi_1884_: i32;
    var phi_1889_: i32;
    var phi_1940_: bool;
    var phi_1948_: bool;
    var phi_1960_: bool;
    var phi_1961_: bool;
    var phi_1965_: f32;
    var phi_1971_: f32;
    var phi_1973_: evaluate_Verdict;
    var phi_1978_: evaluate_Verdict;
    var phi_1979_: evaluate_Verdict;
    var phi_1983_: bool;
    var phi_1984_: u32;
    var phi_1995_: u32;

    let _e47 = id_1;
    let _e48 = local_5;
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
                phi_1184_ = (_e85 == _e87);
                phi_1185_ = false;
            } else {
                phi_1184_ = bool();
                phi_1185_ = true;
            }
            let _e90 = phi_1184_;
            let _e92 = phi_1185_;
            phi_1186_ = _e90;
            phi_1187_ = _e92;
        } else {
            phi_1186_ = bool();
            phi_1187_ = true;
        }
        let _e94 = phi_1186_;
        let _e96 = phi_1187_;
        if _e96 {
            phi_1191_ = false;
        } else {
            phi_1191_ = _e94;
        }
        let _e98 = phi_1191_;
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
                    phi_1262_ = true;
                } else {
                    let _e151 = p.member.light.range_squared;
                    if (_e134 <= _e151) {
                        let _e154 = p.member.light.cos_outer;
                        phi_1261_ = (-((((_e116 * _e136.x) + (_e117 * _e136.y)) + (_e118 * _e136.z))) >= (_e154 * sqrt(_e134)));
                    } else {
                        phi_1261_ = false;
                    }
                    let _e159 = phi_1261_;
                    phi_1262_ = _e159;
                }
                let _e161 = phi_1262_;
                if _e161 {
                    let _e163 = samples.member[_e64.first_primitive].flags;
                    let _e171 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e177 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e171.unnamed.visibility, false), _e171.unnamed_1);
                    phi_1273_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e177.unnamed, ((_e163 & 1u) == 0u));
                    phi_1274_ = false;
                } else {
                    phi_1273_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_1274_ = true;
                }
                let _e182 = phi_1273_;
                let _e184 = phi_1274_;
                phi_1275_ = _e182;
                phi_1276_ = _e184;
            } else {
                phi_1275_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_1276_ = true;
            }
            let _e186 = phi_1275_;
            let _e188 = phi_1276_;
            if _e188 {
                let _e194 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e200 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e194.unnamed.visibility, false), _e194.unnamed_1);
                phi_1283_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e200.unnamed, true);
            } else {
                phi_1283_ = _e186;
            }
            let _e205 = phi_1283_;
            phi_1287_ = _e205;
        } else {
            let _e211 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e217 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e211.unnamed.visibility, false), _e211.unnamed_1);
            phi_1287_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e217.unnamed, true);
        }
        let _e222 = phi_1287_;
        if _e222.unnamed_1 {
            phi_1979_ = evaluate_Verdict(_e222.unnamed.visibility, _e222.unnamed.is_doubted);
        } else {
            let _e230 = samples.member[_e64.first_primitive].position;
            let _e232 = p.member.map_size;
            let _e234 = (0.5f / f32(_e232));
            let _e241 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e248 = lt_math_LightPoint(vec2<f32>(_e241.uv.x, 0f), _e241.depth, _e241.is_inside);
            let _e252 = lt_math_LightPoint(_e248.uv, 0f, _e248.is_inside);
            phi_1307_ = lt_math_LightPoint();
            phi_1310_ = 0u;
            phi_1312_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e252.uv, _e252.depth, false));
            loop {
                let _e259 = phi_1307_;
                let _e261 = phi_1310_;
                let _e263 = phi_1312_;
                local_2 = _e263;
                local_3 = _e263;
                local_4 = _e263;
                if (_e261 < _e71) {
                    if _e263.point.is_inside {
                        phi_1473_ = lt_math_LightPoint();
                        phi_1474_ = u32();
                        phi_1475_ = lt_math_LevelPoint();
                        phi_1476_ = false;
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
                                phi_1398_ = (_e299 <= 1f);
                            } else {
                                phi_1398_ = false;
                            }
                            let _e331 = phi_1398_;
                            if _e331 {
                                if (_e313 >= 0f) {
                                    phi_1407_ = (_e313 <= 1f);
                                } else {
                                    phi_1407_ = false;
                                }
                                let _e335 = phi_1407_;
                                if _e335 {
                                    if (_e326 >= 0f) {
                                        phi_1416_ = (_e326 <= 1f);
                                    } else {
                                        phi_1416_ = false;
                                    }
                                    let _e339 = phi_1416_;
                                    phi_1417_ = _e339;
                                    phi_1418_ = false;
                                } else {
                                    phi_1417_ = bool();
                                    phi_1418_ = true;
                                }
                                let _e341 = phi_1417_;
                                let _e343 = phi_1418_;
                                phi_1419_ = _e341;
                                phi_1420_ = _e343;
                            } else {
                                phi_1419_ = bool();
                                phi_1420_ = true;
                            }
                            let _e345 = phi_1419_;
                            let _e347 = phi_1420_;
                            phi_1421_ = _e345;
                            phi_1422_ = _e347;
                        } else {
                            phi_1421_ = bool();
                            phi_1422_ = true;
                        }
                        let _e349 = phi_1421_;
                        let _e351 = phi_1422_;
                        if _e351 {
                            phi_1426_ = false;
                        } else {
                            phi_1426_ = _e349;
                        }
                        let _e353 = phi_1426_;
                        if _e353 {
                            if (_e299 >= _e234) {
                                if (_e299 <= (1f - _e234)) {
                                    if (_e313 >= _e234) {
                                        phi_1453_ = (_e313 <= (1f - _e234));
                                        phi_1454_ = false;
                                    } else {
                                        phi_1453_ = bool();
                                        phi_1454_ = true;
                                    }
                                    let _e361 = phi_1453_;
                                    let _e363 = phi_1454_;
                                    phi_1455_ = _e361;
                                    phi_1456_ = _e363;
                                } else {
                                    phi_1455_ = bool();
                                    phi_1456_ = true;
                                }
                                let _e365 = phi_1455_;
                                let _e367 = phi_1456_;
                                phi_1457_ = _e365;
                                phi_1458_ = _e367;
                            } else {
                                phi_1457_ = bool();
                                phi_1458_ = true;
                            }
                            let _e369 = phi_1457_;
                            let _e371 = phi_1458_;
                            phi_1459_ = _e369;
                            phi_1460_ = _e371;
                        } else {
                            phi_1459_ = bool();
                            phi_1460_ = true;
                        }
                        let _e373 = phi_1459_;
                        let _e375 = phi_1460_;
                        if _e375 {
                            phi_1464_ = false;
                        } else {
                            phi_1464_ = _e373;
                        }
                        let _e377 = phi_1464_;
                        let _e384 = lt_math_LightPoint(vec2<f32>(_e299, _e259.uv.y), _e259.depth, _e259.is_inside);
                        let _e391 = lt_math_LightPoint(vec2<f32>(_e384.uv.x, _e313), _e384.depth, _e384.is_inside);
                        let _e395 = lt_math_LightPoint(_e391.uv, _e326, _e391.is_inside);
                        let _e399 = lt_math_LightPoint(_e395.uv, _e395.depth, _e377);
                        phi_1473_ = _e399;
                        phi_1474_ = (_e261 + 1u);
                        phi_1475_ = lt_math_LevelPoint(_e261, _e399);
                        phi_1476_ = true;
                    }
                    let _e403 = phi_1473_;
                    let _e405 = phi_1474_;
                    let _e407 = phi_1475_;
                    let _e409 = phi_1476_;
                    phi_1308_ = _e403;
                    phi_1311_ = _e405;
                    phi_1313_ = _e407;
                    phi_1477_ = _e409;
                } else {
                    phi_1308_ = lt_math_LightPoint();
                    phi_1311_ = u32();
                    phi_1313_ = lt_math_LevelPoint();
                    phi_1477_ = false;
                }
                let _e411 = phi_1308_;
                let _e413 = phi_1311_;
                let _e415 = phi_1313_;
                let _e417 = phi_1477_;
                continue;
                continuing {
                    phi_1307_ = _e411;
                    phi_1310_ = _e413;
                    phi_1312_ = _e415;
                    break if !(_e417);
                }
            }
            let _e420 = local_2;
            if _e420.point.is_inside {
                if (0f > 0f) {
                    let _e426 = local_3;
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
                            phi_1517_ = (_e431.row_w.z == _e443);
                            phi_1518_ = false;
                        } else {
                            phi_1517_ = bool();
                            phi_1518_ = true;
                        }
                        let _e446 = phi_1517_;
                        let _e448 = phi_1518_;
                        phi_1519_ = _e446;
                        phi_1520_ = _e448;
                    } else {
                        phi_1519_ = bool();
                        phi_1520_ = true;
                    }
                    let _e450 = phi_1519_;
                    let _e452 = phi_1520_;
                    if _e452 {
                        phi_1524_ = false;
                    } else {
                        phi_1524_ = _e450;
                    }
                    let _e454 = phi_1524_;
                    if _e454 {
                        let _e456 = samples.member[_e64.first_primitive].normal;
                        let _e458 = p.member.map_size;
                        let _e528 = ((abs(((((_e431.row_x.x * _e456.x) + (_e431.row_x.y * _e456.y)) + (_e431.row_x.z * _e456.z)) / (((_e431.row_x.x * _e431.row_x.x) + (_e431.row_x.y * _e431.row_x.y)) + (_e431.row_x.z * _e431.row_x.z)))) + abs(((((_e431.row_y.x * _e456.x) + (_e431.row_y.y * _e456.y)) + (_e431.row_y.z * _e456.z)) / (((_e431.row_y.x * _e431.row_y.x) + (_e431.row_y.y * _e431.row_y.y)) + (_e431.row_y.z * _e431.row_y.z))))) / (abs(((((_e431.row_z.x * _e456.x) + (_e431.row_z.y * _e456.y)) + (_e431.row_z.z * _e456.z)) / (((_e431.row_z.x * _e431.row_z.x) + (_e431.row_z.y * _e431.row_z.y)) + (_e431.row_z.z * _e431.row_z.z)))) * f32(_e458)));
                        if (_e528 < 0.002f) {
                            phi_1606_ = _e528;
                        } else {
                            phi_1606_ = 0.002f;
                        }
                        let _e531 = phi_1606_;
                        phi_1725_ = _e531;
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
                            phi_1724_ = _e645;
                        } else {
                            phi_1724_ = _e647;
                        }
                        let _e650 = phi_1724_;
                        phi_1725_ = _e650;
                    }
                    let _e652 = phi_1725_;
                    phi_1728_ = (_e420.point.depth - (0f * _e652));
                } else {
                    phi_1728_ = _e420.point.depth;
                }
                let _e656 = phi_1728_;
                let _e662 = p.member.map_size;
                let _e663 = f32(_e662);
                let _e666 = ((_e420.point.uv.x * _e663) - 0.5f);
                let _e667 = ((_e420.point.uv.y * _e663) - 0.5f);
                if (_e666 > -8388608f) {
                    let _e679 = f32(select(0i, select(select(i32(_e666), i32(-2147483648), (_e666 < bitcast<f32>(3472883712u))), 2147483647i, (_e666 > bitcast<f32>(1325400063u))), (_e666 == _e666)));
                    if (_e679 > _e666) {
                        phi_1757_ = 1f;
                    } else {
                        phi_1757_ = 0f;
                    }
                    let _e682 = phi_1757_;
                    if (_e666 < 8388608f) {
                        phi_1762_ = (_e679 - _e682);
                        phi_1763_ = false;
                    } else {
                        phi_1762_ = f32();
                        phi_1763_ = true;
                    }
                    let _e685 = phi_1762_;
                    let _e687 = phi_1763_;
                    phi_1764_ = _e685;
                    phi_1765_ = _e687;
                } else {
                    phi_1764_ = f32();
                    phi_1765_ = true;
                }
                let _e689 = phi_1764_;
                let _e691 = phi_1765_;
                if _e691 {
                    phi_1769_ = _e666;
                } else {
                    phi_1769_ = _e689;
                }
                let _e693 = phi_1769_;
                if (_e667 > -8388608f) {
                    let _e705 = f32(select(0i, select(select(i32(_e667), i32(-2147483648), (_e667 < bitcast<f32>(3472883712u))), 2147483647i, (_e667 > bitcast<f32>(1325400063u))), (_e667 == _e667)));
                    if (_e705 > _e667) {
                        phi_1789_ = 1f;
                    } else {
                        phi_1789_ = 0f;
                    }
                    let _e708 = phi_1789_;
                    if (_e667 < 8388608f) {
                        phi_1794_ = (_e705 - _e708);
                        phi_1795_ = false;
                    } else {
                        phi_1794_ = f32();
                        phi_1795_ = true;
                    }
                    let _e711 = phi_1794_;
                    let _e713 = phi_1795_;
                    phi_1796_ = _e711;
                    phi_1797_ = _e713;
                } else {
                    phi_1796_ = f32();
                    phi_1797_ = true;
                }
                let _e715 = phi_1796_;
                let _e717 = phi_1797_;
                if _e717 {
                    phi_1801_ = _e667;
                } else {
                    phi_1801_ = _e715;
                }
                let _e719 = phi_1801_;
                let _e720 = (_e666 - _e693);
                let _e721 = (_e667 - _e719);
                let _e730 = select(0i, select(select(i32(_e693), i32(-2147483648), (_e693 < bitcast<f32>(3472883712u))), 2147483647i, (_e693 > bitcast<f32>(1325400063u))), (_e693 == _e693));
                let _e739 = select(0i, select(select(i32(_e719), i32(-2147483648), (_e719 < bitcast<f32>(3472883712u))), 2147483647i, (_e719 > bitcast<f32>(1325400063u))), (_e719 == _e719));
                let _e750 = p.member.test;
                let _e751 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e750);
                let _e753 = p.member.map_size;
                let _e755 = local_4;
                local_1 = _e751;
                let _e758 = ((_e755.level * _e753) * _e753);
                let _e760 = (bitcast<i32>(_e753) - 1i);
                if (_e730 > 0i) {
                    phi_1850_ = _e730;
                } else {
                    phi_1850_ = 0i;
                }
                let _e763 = phi_1850_;
                if (_e739 > 0i) {
                    phi_1855_ = _e739;
                } else {
                    phi_1855_ = 0i;
                }
                let _e766 = phi_1855_;
                if (_e763 < _e760) {
                    phi_1860_ = _e763;
                } else {
                    phi_1860_ = _e760;
                }
                let _e769 = phi_1860_;
                if (_e766 < _e760) {
                    phi_1865_ = _e766;
                } else {
                    phi_1865_ = _e760;
                }
                let _e772 = phi_1865_;
                let _e773 = bitcast<u32>(_e769);
                let _e775 = (_e730 + 1i);
                let _e776 = (_e739 + 1i);
                if (_e775 > 0i) {
                    phi_1874_ = _e775;
                } else {
                    phi_1874_ = 0i;
                }
                let _e779 = phi_1874_;
                if (_e776 > 0i) {
                    phi_1879_ = _e776;
                } else {
                    phi_1879_ = 0i;
                }
                let _e782 = phi_1879_;
                if (_e779 < _e760) {
                    phi_1884_ = _e779;
                } else {
                    phi_1884_ = _e760;
                }
                let _e785 = phi_1884_;
                if (_e782 < _e760) {
                    phi_1889_ = _e782;
                } else {
                    phi_1889_ = _e760;
                }
                let _e788 = phi_1889_;
                let _e789 = bitcast<u32>(_e785);
                let _e791 = (bitcast<u32>(_e772) * _e753);
                let _e792 = (bitcast<u32>(_e788) * _e753);
                let _e797 = ((_e791 + _e773) + _e758);
                let _e798 = ((_e791 + _e789) + _e758);
                let _e799 = ((_e792 + _e773) + _e758);
                let _e800 = ((_e792 + _e789) + _e758);
                if (_e797 < _e53) {
                } else {
                    return;
                }
                let _e804 = map.member[(0u + _e797)];
                if (_e798 < _e53) {
                } else {
                    return;
                }
                let _e808 = map.member[(0u + _e798)];
                if (_e799 < _e53) {
                } else {
                    return;
                }
                let _e812 = map.member[(0u + _e799)];
                if (_e800 < _e53) {
                } else {
                    return;
                }
                let _e816 = map.member[(0u + _e800)];
                let _e818 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local_1), vec4<f32>(_e804, _e808, _e812, _e816), vec4<f32>(((1f - _e720) * (1f - _e721)), (_e720 * (1f - _e721)), ((1f - _e720) * _e721), (_e720 * _e721)), _e656);
                let _e820 = p.member.epsilon;
                if (_e818 <= _e820) {
                    phi_1940_ = true;
                } else {
                    phi_1940_ = (_e818 >= (1f - _e820));
                }
                let _e825 = phi_1940_;
                if ((bitcast<u32>(_e818) & 2147483647u) > 2139095040u) {
                    phi_1948_ = true;
                } else {
                    phi_1948_ = !(_e825);
                }
                let _e831 = phi_1948_;
                if _e831 {
                    if (_e818 > 0f) {
                        if (_e818 < 1f) {
                            phi_1960_ = false;
                        } else {
                            phi_1960_ = true;
                        }
                        let _e835 = phi_1960_;
                        phi_1961_ = _e835;
                    } else {
                        phi_1961_ = true;
                    }
                    let _e837 = phi_1961_;
                    if _e837 {
                        phi_1965_ = 0.5f;
                    } else {
                        phi_1965_ = _e818;
                    }
                    let _e839 = phi_1965_;
                    phi_1973_ = evaluate_Verdict(_e839, true);
                } else {
                    if (_e818 > 0.5f) {
                        phi_1971_ = 1f;
                    } else {
                        phi_1971_ = 0f;
                    }
                    let _e843 = phi_1971_;
                    phi_1973_ = evaluate_Verdict(_e843, false);
                }
                let _e846 = phi_1973_;
                phi_1978_ = evaluate_Verdict(_e846.visibility, _e846.is_doubted);
            } else {
                phi_1978_ = evaluate_Verdict(0.5f, true);
            }
            let _e852 = phi_1978_;
            phi_1979_ = _e852;
        }
        let _e854 = phi_1979_;
        visibility.member[_e64.first_primitive] = _e854.visibility;
        phi_1983_ = _e854.is_doubted;
        phi_1984_ = _e64.first_primitive;
    } else {
        phi_1983_ = false;
        phi_1984_ = 0u;
    }
    let _e859 = phi_1983_;
    let _e861 = phi_1984_;
    if (_e48 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e859 {
        let _e865 = atomicAdd((&shared_[0u]), 1u);
        phi_1995_ = _e865;
    } else {
        phi_1995_ = 0u;
    }
    let _e867 = phi_1995_;
    workgroupBarrier();
    if (_e48 == 0u) {
        let _e871 = atomicLoad((&shared_[0u]));
        let _e872 = atomicAdd((&list.member[3u]), _e871);
        atomicStore((&shared_[1u]), _e872);
    }
    workgroupBarrier();
    if _e859 {
        let _e875 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e875) + _e867)]), _e861);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_msm_hausdorff_levels_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_5 = local;
    function_();
}
