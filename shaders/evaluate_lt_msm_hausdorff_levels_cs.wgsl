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

struct type_31 {
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

struct type_37 {
    member: array<lt_math_LightProjection>,
}

struct lt_math_LevelPoint {
    level: u32,
    point: lt_math_LightPoint,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_15;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_31;
@group(0) @binding(2) 
var<storage> map: type_19;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_19;
@group(0) @binding(4) 
var<storage> levels: type_37;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_148_: lt_bvh_traverse_Tree;
    var phi_149_: bool;
    var phi_150_: lt_bvh_traverse_Tree;
    var phi_151_: bool;
    var phi_156_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_148_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_149_ = false;
        } else {
            phi_148_ = lt_bvh_traverse_Tree();
            phi_149_ = true;
        }
        let _e55 = phi_148_;
        let _e57 = phi_149_;
        phi_150_ = _e55;
        phi_151_ = _e57;
    } else {
        phi_150_ = lt_bvh_traverse_Tree();
        phi_151_ = true;
    }
    let _e59 = phi_150_;
    let _e61 = phi_151_;
    if _e61 {
        phi_156_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_156_ = _e59;
    }
    let _e66 = phi_156_;
    return lt_bvh_traverse_Tree(_e66.root, _e66.first_primitive);
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_183_: f32;
    var phi_184_: f32;
    var phi_185_: f32;
    var phi_202_: f32;
    var phi_203_: f32;
    var phi_204_: f32;
    var phi_220_: f32;
    var phi_221_: f32;
    var phi_222_: f32;
    var phi_238_: f32;
    var phi_239_: f32;
    var phi_240_: f32;
    var phi_256_: f32;
    var phi_257_: f32;
    var phi_258_: f32;
    var phi_293_: bool;
    var phi_294_: bool;
    var phi_295_: bool;
    var phi_296_: bool;
    var phi_297_: bool;
    var phi_298_: bool;
    var phi_302_: bool;
    var phi_613_: f32;
    var phi_614_: f32;
    var phi_615_: f32;
    var phi_632_: f32;
    var phi_633_: f32;
    var phi_634_: f32;
    var phi_651_: f32;
    var phi_652_: f32;
    var phi_653_: f32;
    var phi_670_: f32;
    var phi_671_: f32;
    var phi_672_: f32;
    var phi_695_: f32;
    var phi_696_: f32;
    var phi_697_: f32;
    var phi_744_: f32;
    var phi_745_: f32;
    var phi_746_: f32;
    var phi_763_: f32;
    var phi_764_: f32;
    var phi_765_: f32;
    var phi_782_: f32;
    var phi_783_: f32;
    var phi_784_: f32;
    var phi_801_: f32;
    var phi_802_: f32;
    var phi_803_: f32;
    var phi_826_: f32;
    var phi_827_: f32;
    var phi_828_: f32;
    var phi_907_: bool;
    var phi_951_: f32;
    var phi_952_: f32;
    var phi_953_: bool;
    var phi_954_: f32;
    var phi_955_: bool;
    var phi_956_: f32;
    var phi_957_: bool;
    var phi_961_: f32;
    var phi_962_: f32;
    var phi_981_: f32;
    var phi_982_: f32;
    var phi_983_: f32;
    var phi_994_: f32;
    var phi_1009_: f32;
    var phi_1011_: lt_bvh_slab_Span;
    var phi_1069_: f32;
    var phi_1070_: f32;
    var phi_1071_: f32;
    var phi_1072_: f32;
    var phi_1073_: f32;
    var phi_1074_: bool;
    var phi_1078_: f32;
    var phi_1093_: f32;
    var phi_1094_: f32;
    var phi_1095_: f32;
    var phi_1096_: f32;
    var phi_1097_: f32;
    var phi_1098_: f32;
    var phi_1099_: f32;
    var phi_1100_: bool;
    var phi_1104_: f32;
    var phi_1105_: f32;
    var phi_1106_: bool;
    var phi_1107_: f32;
    var phi_1108_: f32;
    var phi_1109_: bool;
    var phi_1113_: f32;

    let _e46 = (*param_4);
    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_185_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_184_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_183_ = 1f;
            } else {
                phi_183_ = param_7;
            }
            let _e53 = phi_183_;
            phi_184_ = _e53;
        }
        let _e55 = phi_184_;
        phi_185_ = _e55;
    }
    let _e57 = phi_185_;
    let _e58 = (_e57 - 0.00000047683716f);
    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_204_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_203_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_202_ = 1f;
            } else {
                phi_202_ = param_5.x;
            }
            let _e66 = phi_202_;
            phi_203_ = _e66;
        }
        let _e68 = phi_203_;
        phi_204_ = _e68;
    }
    let _e70 = phi_204_;
    if ((bitcast<u32>(param_5.y) & 2147483647u) > 2139095040u) {
        phi_222_ = param_5.y;
    } else {
        if (param_5.y < 0f) {
            phi_221_ = 0f;
        } else {
            if (param_5.y > 1f) {
                phi_220_ = 1f;
            } else {
                phi_220_ = param_5.y;
            }
            let _e78 = phi_220_;
            phi_221_ = _e78;
        }
        let _e80 = phi_221_;
        phi_222_ = _e80;
    }
    let _e82 = phi_222_;
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_240_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_239_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_238_ = 1f;
            } else {
                phi_238_ = param_5.z;
            }
            let _e90 = phi_238_;
            phi_239_ = _e90;
        }
        let _e92 = phi_239_;
        phi_240_ = _e92;
    }
    let _e94 = phi_240_;
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_258_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_257_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_256_ = 1f;
            } else {
                phi_256_ = param_5.w;
            }
            let _e102 = phi_256_;
            phi_257_ = _e102;
        }
        let _e104 = phi_257_;
        phi_258_ = _e104;
    }
    let _e106 = phi_258_;
    let _e107 = (_e70 - _e58);
    let _e108 = (_e82 - _e58);
    let _e109 = (_e94 - _e58);
    let _e110 = (_e106 - _e58);
    let _e121 = ((((_e107 * param_6.x) + (_e108 * param_6.y)) + (_e109 * param_6.z)) + (_e110 * param_6.w));
    if ((bitcast<u32>(_e121) & 2147483647u) > 2139095040u) {
        phi_1107_ = _e121;
        phi_1108_ = f32();
        phi_1109_ = true;
    } else {
        if (_e107 >= 0f) {
            if (_e108 >= 0f) {
                if (_e109 >= 0f) {
                    phi_293_ = (_e110 >= 0f);
                    phi_294_ = false;
                } else {
                    phi_293_ = bool();
                    phi_294_ = true;
                }
                let _e130 = phi_293_;
                let _e132 = phi_294_;
                phi_295_ = _e130;
                phi_296_ = _e132;
            } else {
                phi_295_ = bool();
                phi_296_ = true;
            }
            let _e134 = phi_295_;
            let _e136 = phi_296_;
            phi_297_ = _e134;
            phi_298_ = _e136;
        } else {
            phi_297_ = bool();
            phi_298_ = true;
        }
        let _e138 = phi_297_;
        let _e140 = phi_298_;
        if _e140 {
            phi_302_ = false;
        } else {
            phi_302_ = _e138;
        }
        let _e142 = phi_302_;
        if _e142 {
            phi_1104_ = 1f;
            phi_1105_ = f32();
            phi_1106_ = true;
        } else {
            let _e143 = (0.5f * _e46);
            let _e144 = (1f - _e46);
            let _e146 = (param_6.x * _e144);
            let _e148 = (param_6.y * _e144);
            let _e150 = (param_6.z * _e144);
            let _e152 = (param_6.w * _e144);
            let _e153 = -(_e58);
            let _e154 = (1f - _e58);
            let _e156 = (vec4<f32>(1f, 1f, 1f, 1f).x - _e70);
            let _e158 = (vec4<f32>(1f, 1f, 1f, 1f).y - _e82);
            let _e160 = (vec4<f32>(1f, 1f, 1f, 1f).z - _e94);
            let _e162 = (vec4<f32>(1f, 1f, 1f, 1f).w - _e106);
            let _e163 = (_e107 - _e108);
            let _e164 = (_e108 - _e109);
            let _e165 = (_e109 - _e110);
            let _e166 = (_e110 - _e107);
            let _e167 = (_e163 * _e163);
            let _e168 = (_e164 * _e164);
            let _e169 = (_e165 * _e165);
            let _e170 = (_e166 * _e166);
            let _e171 = (_e107 - _e109);
            let _e172 = (_e108 - _e110);
            let _e173 = (_e109 - _e107);
            let _e174 = (_e110 - _e108);
            let _e175 = (_e171 * _e171);
            let _e176 = (_e172 * _e172);
            let _e177 = (_e173 * _e173);
            let _e178 = (_e174 * _e174);
            let _e183 = ((_e146 * _e148) * _e167);
            let _e184 = ((_e148 * _e150) * _e168);
            let _e185 = ((_e150 * _e152) * _e169);
            let _e186 = ((_e152 * _e146) * _e170);
            let _e195 = (((0.5f * _e146) * _e150) * _e175);
            let _e196 = (((0.5f * _e148) * _e152) * _e176);
            let _e197 = (((0.5f * _e150) * _e146) * _e177);
            let _e198 = (((0.5f * _e152) * _e148) * _e178);
            let _e199 = (_e107 * _e108);
            let _e200 = (_e108 * _e109);
            let _e201 = (_e109 * _e110);
            let _e202 = (_e110 * _e107);
            let _e203 = (_e107 * _e109);
            let _e204 = (_e108 * _e110);
            let _e205 = (_e109 * _e107);
            let _e206 = (_e110 * _e108);
            let _e207 = (_e183 * _e199);
            let _e208 = (_e184 * _e200);
            let _e209 = (_e185 * _e201);
            let _e210 = (_e186 * _e202);
            let _e211 = (_e195 * _e203);
            let _e212 = (_e196 * _e204);
            let _e213 = (_e197 * _e205);
            let _e214 = (_e198 * _e206);
            let _e215 = (_e70 * _e70);
            let _e216 = (_e82 * _e82);
            let _e217 = (_e94 * _e94);
            let _e218 = (_e106 * _e106);
            let _e219 = (_e156 * _e156);
            let _e220 = (_e158 * _e158);
            let _e221 = (_e160 * _e160);
            let _e222 = (_e162 * _e162);
            let _e223 = (_e143 * _e146);
            let _e224 = (_e143 * _e148);
            let _e225 = (_e143 * _e150);
            let _e226 = (_e143 * _e152);
            let _e235 = (((_e223 * _e107) * _e215) * _e153);
            let _e236 = (((_e224 * _e108) * _e216) * _e153);
            let _e237 = (((_e225 * _e109) * _e217) * _e153);
            let _e238 = (((_e226 * _e110) * _e218) * _e153);
            let _e247 = (((_e223 * _e107) * _e219) * _e154);
            let _e248 = (((_e224 * _e108) * _e220) * _e154);
            let _e249 = (((_e225 * _e109) * _e221) * _e154);
            let _e250 = (((_e226 * _e110) * _e222) * _e154);
            let _e418 = (((((((_e183 * _e150) * _e168) * _e175) + (_e143 * (((_e183 * ((_e215 * _e216) + (_e219 * _e220))) + (_e195 * ((_e215 * _e217) + (_e219 * _e221)))) + ((_e223 * _e215) * _e219)))) + ((((_e184 * _e152) * _e169) * _e176) + (_e143 * (((_e184 * ((_e216 * _e217) + (_e220 * _e221))) + (_e196 * ((_e216 * _e218) + (_e220 * _e222)))) + ((_e224 * _e216) * _e220))))) + ((((_e185 * _e146) * _e170) * _e177) + (_e143 * (((_e185 * ((_e217 * _e218) + (_e221 * _e222))) + (_e197 * ((_e217 * _e215) + (_e221 * _e219)))) + ((_e225 * _e217) * _e221))))) + ((((_e186 * _e148) * _e167) * _e178) + (_e143 * (((_e186 * ((_e218 * _e215) + (_e222 * _e219))) + (_e198 * ((_e218 * _e216) + (_e222 * _e220)))) + ((_e226 * _e218) * _e222)))));
            let _e421 = (((_e143 * _e143) * _e153) * _e154);
            let _e424 = (((((((_e207 * _e199) + (_e211 * _e203)) + (_e107 * ((_e235 * _e153) + (_e247 * _e154)))) + (((_e208 * _e200) + (_e212 * _e204)) + (_e108 * ((_e236 * _e153) + (_e248 * _e154))))) + (((_e209 * _e201) + (_e213 * _e205)) + (_e109 * ((_e237 * _e153) + (_e249 * _e154))))) + (((_e210 * _e202) + (_e214 * _e206)) + (_e110 * ((_e238 * _e153) + (_e250 * _e154))))) + ((_e421 * _e153) * _e154));
            if (_e424 < 0.0000000000000000000000000000000001f) {
                if ((bitcast<u32>(_e107) & 2147483647u) > 2139095040u) {
                    phi_615_ = _e107;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_614_ = 0f;
                    } else {
                        if (_e107 < 0f) {
                            phi_613_ = 0f;
                        } else {
                            phi_613_ = 1f;
                        }
                        let _e439 = phi_613_;
                        phi_614_ = _e439;
                    }
                    let _e441 = phi_614_;
                    phi_615_ = _e441;
                }
                let _e443 = phi_615_;
                if ((bitcast<u32>(_e108) & 2147483647u) > 2139095040u) {
                    phi_634_ = _e108;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_633_ = 0f;
                    } else {
                        if (_e108 < 0f) {
                            phi_632_ = 0f;
                        } else {
                            phi_632_ = 1f;
                        }
                        let _e452 = phi_632_;
                        phi_633_ = _e452;
                    }
                    let _e454 = phi_633_;
                    phi_634_ = _e454;
                }
                let _e456 = phi_634_;
                if ((bitcast<u32>(_e109) & 2147483647u) > 2139095040u) {
                    phi_653_ = _e109;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_652_ = 0f;
                    } else {
                        if (_e109 < 0f) {
                            phi_651_ = 0f;
                        } else {
                            phi_651_ = 1f;
                        }
                        let _e465 = phi_651_;
                        phi_652_ = _e465;
                    }
                    let _e467 = phi_652_;
                    phi_653_ = _e467;
                }
                let _e469 = phi_653_;
                if ((bitcast<u32>(_e110) & 2147483647u) > 2139095040u) {
                    phi_672_ = _e110;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_671_ = 0f;
                    } else {
                        if (_e110 < 0f) {
                            phi_670_ = 0f;
                        } else {
                            phi_670_ = 1f;
                        }
                        let _e478 = phi_670_;
                        phi_671_ = _e478;
                    }
                    let _e480 = phi_671_;
                    phi_672_ = _e480;
                }
                let _e482 = phi_672_;
                let _e490 = (((((_e443 * _e146) + (_e456 * _e148)) + (_e469 * _e150)) + (_e482 * _e152)) + _e143);
                if ((bitcast<u32>(_e490) & 2147483647u) > 2139095040u) {
                    phi_697_ = _e490;
                } else {
                    if (_e490 < 0f) {
                        phi_696_ = 0f;
                    } else {
                        if (_e490 > 1f) {
                            phi_695_ = 1f;
                        } else {
                            phi_695_ = _e490;
                        }
                        let _e497 = phi_695_;
                        phi_696_ = _e497;
                    }
                    let _e499 = phi_696_;
                    phi_697_ = _e499;
                }
                let _e501 = phi_697_;
                phi_1098_ = _e501;
                phi_1099_ = f32();
                phi_1100_ = true;
            } else {
                let _e506 = ((_e146 * _e70) * _e156);
                let _e507 = ((_e148 * _e82) * _e158);
                let _e508 = ((_e150 * _e94) * _e160);
                let _e509 = ((_e152 * _e106) * _e162);
                let _e516 = ((((_e506 * _e107) + (_e507 * _e108)) + (_e508 * _e109)) + (_e509 * _e110));
                let _e527 = ((((_e506 * (_e107 * _e107)) + (_e507 * (_e108 * _e108))) + (_e508 * (_e109 * _e109))) + (_e509 * (_e110 * _e110)));
                if (_e527 < 0.0000000000000000000000000000000001f) {
                    if ((bitcast<u32>(_e107) & 2147483647u) > 2139095040u) {
                        phi_746_ = _e107;
                    } else {
                        if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                            phi_745_ = 0f;
                        } else {
                            if (_e107 < 0f) {
                                phi_744_ = 0f;
                            } else {
                                phi_744_ = 1f;
                            }
                            let _e537 = phi_744_;
                            phi_745_ = _e537;
                        }
                        let _e539 = phi_745_;
                        phi_746_ = _e539;
                    }
                    let _e541 = phi_746_;
                    if ((bitcast<u32>(_e108) & 2147483647u) > 2139095040u) {
                        phi_765_ = _e108;
                    } else {
                        if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                            phi_764_ = 0f;
                        } else {
                            if (_e108 < 0f) {
                                phi_763_ = 0f;
                            } else {
                                phi_763_ = 1f;
                            }
                            let _e550 = phi_763_;
                            phi_764_ = _e550;
                        }
                        let _e552 = phi_764_;
                        phi_765_ = _e552;
                    }
                    let _e554 = phi_765_;
                    if ((bitcast<u32>(_e109) & 2147483647u) > 2139095040u) {
                        phi_784_ = _e109;
                    } else {
                        if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                            phi_783_ = 0f;
                        } else {
                            if (_e109 < 0f) {
                                phi_782_ = 0f;
                            } else {
                                phi_782_ = 1f;
                            }
                            let _e563 = phi_782_;
                            phi_783_ = _e563;
                        }
                        let _e565 = phi_783_;
                        phi_784_ = _e565;
                    }
                    let _e567 = phi_784_;
                    if ((bitcast<u32>(_e110) & 2147483647u) > 2139095040u) {
                        phi_803_ = _e110;
                    } else {
                        if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                            phi_802_ = 0f;
                        } else {
                            if (_e110 < 0f) {
                                phi_801_ = 0f;
                            } else {
                                phi_801_ = 1f;
                            }
                            let _e576 = phi_801_;
                            phi_802_ = _e576;
                        }
                        let _e578 = phi_802_;
                        phi_803_ = _e578;
                    }
                    let _e580 = phi_803_;
                    let _e588 = (((((_e541 * _e146) + (_e554 * _e148)) + (_e567 * _e150)) + (_e580 * _e152)) + _e143);
                    if ((bitcast<u32>(_e588) & 2147483647u) > 2139095040u) {
                        phi_828_ = _e588;
                    } else {
                        if (_e588 < 0f) {
                            phi_827_ = 0f;
                        } else {
                            if (_e588 > 1f) {
                                phi_826_ = 1f;
                            } else {
                                phi_826_ = _e588;
                            }
                            let _e595 = phi_826_;
                            phi_827_ = _e595;
                        }
                        let _e597 = phi_827_;
                        phi_828_ = _e597;
                    }
                    let _e599 = phi_828_;
                    phi_962_ = _e599;
                } else {
                    let _e601 = (_e527 - (_e153 * _e516));
                    let _e603 = ((_e154 * _e516) - _e527);
                    let _e608 = ((_e146 * _e107) * _e156);
                    let _e609 = ((_e148 * _e108) * _e158);
                    let _e610 = ((_e150 * _e109) * _e160);
                    let _e611 = ((_e152 * _e110) * _e162);
                    let _e637 = (_e143 + (((((_e608 * ((_e609 * _e167) + ((0.5f * _e610) * _e175))) + (_e609 * ((_e610 * _e168) + ((0.5f * _e611) * _e176)))) + (_e610 * ((_e611 * _e169) + ((0.5f * _e608) * _e177)))) + (_e611 * ((_e608 * _e170) + ((0.5f * _e609) * _e178)))) / (_e153 * _e601)));
                    let _e642 = ((_e146 * _e107) * _e70);
                    let _e643 = ((_e148 * _e108) * _e82);
                    let _e644 = ((_e150 * _e109) * _e94);
                    let _e645 = ((_e152 * _e110) * _e106);
                    let _e671 = (_e143 + (((((_e642 * ((_e643 * _e167) + ((0.5f * _e644) * _e175))) + (_e643 * ((_e644 * _e168) + ((0.5f * _e645) * _e176)))) + (_e644 * ((_e645 * _e169) + ((0.5f * _e642) * _e177)))) + (_e645 * ((_e642 * _e170) + ((0.5f * _e643) * _e178)))) / (_e154 * _e603)));
                    let _e672 = (_e516 > 0f);
                    if _e672 {
                        phi_907_ = (_e603 > 0f);
                    } else {
                        phi_907_ = (_e601 < 0f);
                    }
                    let _e676 = phi_907_;
                    if _e676 {
                        if (_e637 >= 0f) {
                            if (_e671 >= 0f) {
                                if _e672 {
                                    phi_951_ = (1f - _e637);
                                } else {
                                    phi_951_ = ((((((_e506 * ((_e507 * _e167) + ((0.5f * _e508) * _e175))) + (_e507 * ((_e508 * _e168) + ((0.5f * _e509) * _e176)))) + (_e508 * ((_e509 * _e169) + ((0.5f * _e506) * _e177)))) + (_e509 * ((_e506 * _e170) + ((0.5f * _e507) * _e178)))) / (_e527 * (-(_e153) * _e154))) + _e671);
                                }
                                let _e709 = phi_951_;
                                phi_952_ = _e709;
                                phi_953_ = false;
                            } else {
                                phi_952_ = f32();
                                phi_953_ = true;
                            }
                            let _e711 = phi_952_;
                            let _e713 = phi_953_;
                            phi_954_ = _e711;
                            phi_955_ = _e713;
                        } else {
                            phi_954_ = f32();
                            phi_955_ = true;
                        }
                        let _e715 = phi_954_;
                        let _e717 = phi_955_;
                        phi_956_ = _e715;
                        phi_957_ = _e717;
                    } else {
                        phi_956_ = f32();
                        phi_957_ = true;
                    }
                    let _e719 = phi_956_;
                    let _e721 = phi_957_;
                    if _e721 {
                        phi_961_ = 1f;
                    } else {
                        phi_961_ = _e719;
                    }
                    let _e723 = phi_961_;
                    phi_962_ = _e723;
                }
                let _e725 = phi_962_;
                let _e726 = (_e725 < 1f);
                if _e726 {
                    if ((bitcast<u32>(_e725) & 2147483647u) > 2139095040u) {
                        phi_983_ = _e725;
                    } else {
                        if (_e725 < 0f) {
                            phi_982_ = 0f;
                        } else {
                            if (_e725 > 1f) {
                                phi_981_ = 1f;
                            } else {
                                phi_981_ = _e725;
                            }
                            let _e733 = phi_981_;
                            phi_982_ = _e733;
                        }
                        let _e735 = phi_982_;
                        phi_983_ = _e735;
                    }
                    let _e737 = phi_983_;
                    phi_1096_ = _e737;
                    phi_1097_ = f32();
                } else {
                    let _e739 = ((0.5f * -(((((((((_e207 * (_e107 + _e108)) + (_e211 * (_e107 + _e109))) + (_e235 * (_e107 + _e153))) + (_e247 * (_e107 + _e154))) + ((((_e208 * (_e108 + _e109)) + (_e212 * (_e108 + _e110))) + (_e236 * (_e108 + _e153))) + (_e248 * (_e108 + _e154)))) + ((((_e209 * (_e109 + _e110)) + (_e213 * (_e109 + _e107))) + (_e237 * (_e109 + _e153))) + (_e249 * (_e109 + _e154)))) + ((((_e210 * (_e110 + _e107)) + (_e214 * (_e110 + _e108))) + (_e238 * (_e110 + _e153))) + (_e250 * (_e110 + _e154)))) + (_e421 * (_e153 + _e154))))) / _e424);
                    let _e740 = ((((((((_e207 + _e211) + _e235) + _e247) + (((_e208 + _e212) + _e236) + _e248)) + (((_e209 + _e213) + _e237) + _e249)) + (((_e210 + _e214) + _e238) + _e250)) + _e421) / _e424);
                    let _e742 = ((_e739 * _e739) - _e740);
                    if (_e742 > 0f) {
                        phi_994_ = sqrt(_e742);
                    } else {
                        phi_994_ = 0f;
                    }
                    let _e746 = phi_994_;
                    if (_e739 > 0f) {
                        let _e749 = (-(_e739) - _e746);
                        phi_1011_ = lt_bvh_slab_Span(_e749, (_e740 / _e749));
                    } else {
                        let _e752 = (_e746 - _e739);
                        if (_e752 > 0f) {
                            phi_1009_ = (_e740 / _e752);
                        } else {
                            phi_1009_ = 0f;
                        }
                        let _e756 = phi_1009_;
                        phi_1011_ = lt_bvh_slab_Span(_e756, _e752);
                    }
                    let _e759 = phi_1011_;
                    if (_e759.near >= 0f) {
                        phi_1072_ = 1f;
                        phi_1073_ = f32();
                        phi_1074_ = true;
                    } else {
                        let _e763 = (_e759.far <= 0f);
                        if _e763 {
                            phi_1070_ = (_e418 / _e424);
                            phi_1071_ = f32();
                        } else {
                            let _e774 = (((((_e146 * _e107) + (_e148 * _e108)) + (_e150 * _e109)) + (_e152 * _e110)) + (_e143 * (_e153 + _e154)));
                            let _e790 = (((((_e146 * (_e107 * _e107)) + (_e148 * (_e108 * _e108))) + (_e150 * (_e109 * _e109))) + (_e152 * (_e110 * _e110))) + (_e143 * ((_e153 * _e153) + (_e154 * _e154))));
                            if (-(_e759.near) <= _e759.far) {
                                phi_1069_ = (1f - (((_e759.near * _e759.near) * ((_e759.far * _e790) - _e774)) / (_e759.far - _e759.near)));
                            } else {
                                phi_1069_ = ((_e418 / _e424) + (((_e759.far * _e759.far) * (_e774 - (_e759.near * _e790))) / (_e759.far - _e759.near)));
                            }
                            let _e809 = phi_1069_;
                            phi_1070_ = f32();
                            phi_1071_ = _e809;
                        }
                        let _e811 = phi_1070_;
                        let _e813 = phi_1071_;
                        phi_1072_ = _e811;
                        phi_1073_ = _e813;
                        phi_1074_ = _e763;
                    }
                    let _e815 = phi_1072_;
                    let _e817 = phi_1073_;
                    let _e819 = phi_1074_;
                    if _e819 {
                        phi_1078_ = _e815;
                    } else {
                        phi_1078_ = _e817;
                    }
                    let _e821 = phi_1078_;
                    if ((bitcast<u32>(_e821) & 2147483647u) > 2139095040u) {
                        phi_1095_ = _e821;
                    } else {
                        if (_e821 < 0f) {
                            phi_1094_ = 0f;
                        } else {
                            if (_e821 > 1f) {
                                phi_1093_ = 1f;
                            } else {
                                phi_1093_ = _e821;
                            }
                            let _e828 = phi_1093_;
                            phi_1094_ = _e828;
                        }
                        let _e830 = phi_1094_;
                        phi_1095_ = _e830;
                    }
                    let _e832 = phi_1095_;
                    phi_1096_ = f32();
                    phi_1097_ = _e832;
                }
                let _e834 = phi_1096_;
                let _e836 = phi_1097_;
                phi_1098_ = _e834;
                phi_1099_ = _e836;
                phi_1100_ = _e726;
            }
            let _e838 = phi_1098_;
            let _e840 = phi_1099_;
            let _e842 = phi_1100_;
            if _e842 {
            }
            phi_1104_ = _e838;
            phi_1105_ = _e840;
            phi_1106_ = _e842;
        }
        let _e844 = phi_1104_;
        let _e846 = phi_1105_;
        let _e848 = phi_1106_;
        phi_1107_ = _e844;
        phi_1108_ = _e846;
        phi_1109_ = _e848;
    }
    let _e850 = phi_1107_;
    let _e852 = phi_1108_;
    let _e854 = phi_1109_;
    if _e854 {
        phi_1113_ = _e850;
    } else {
        phi_1113_ = _e852;
    }
    let _e856 = phi_1113_;
    return _e856;
}

fn function_() {
    var local: f32;
    var phi_1173_: bool;
    var phi_1174_: bool;
    var phi_1175_: bool;
    var phi_1176_: bool;
    var phi_1180_: bool;
    var phi_1250_: bool;
    var phi_1251_: bool;
    var phi_1262_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1263_: bool;
    var phi_1264_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1265_: bool;
    var phi_1272_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1276_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1296_: lt_math_LightPoint;
    var phi_1299_: u32;
    var phi_1301_: lt_math_LevelPoint;
    var phi_1387_: bool;
    var phi_1396_: bool;
    var phi_1405_: bool;
    var phi_1406_: bool;
    var phi_1407_: bool;
    var phi_1408_: bool;
    var phi_1409_: bool;
    var phi_1410_: bool;
    var phi_1411_: bool;
    var phi_1415_: bool;
    var phi_1442_: bool;
    var phi_1443_: bool;
    var phi_1444_: bool;
    var phi_1445_: bool;
    var phi_1446_: bool;
    var phi_1447_: bool;
    var phi_1448_: bool;
    var phi_1449_: bool;
    var phi_1453_: bool;
    var phi_1462_: lt_math_LightPoint;
    var phi_1463_: u32;
    var phi_1464_: lt_math_LevelPoint;
    var phi_1465_: bool;
    var phi_1297_: lt_math_LightPoint;
    var phi_1300_: u32;
    var phi_1302_: lt_math_LevelPoint;
    var phi_1466_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_1506_: bool;
    var phi_1507_: bool;
    var phi_1508_: bool;
    var phi_1509_: bool;
    var phi_1513_: bool;
    var phi_1595_: f32;
    var phi_1713_: f32;
    var phi_1714_: f32;
    var phi_1717_: f32;
    var phi_1746_: f32;
    var phi_1751_: f32;
    var phi_1752_: bool;
    var phi_1753_: f32;
    var phi_1754_: bool;
    var phi_1758_: f32;
    var phi_1778_: f32;
    var phi_1783_: f32;
    var phi_1784_: bool;
    var phi_1785_: f32;
    var phi_1786_: bool;
    var phi_1790_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_1839_: i32;
    var phi_1844_: i32;
    var phi_1849_: i32;
    var phi_1854_: i32;
    var phi_1863_: i32;
    var phi_1868_: i32;
    var phi_1873_: i32;
    var phi_1878_: i32;
    var phi_1929_: bool;
    var phi_1937_: bool;
    var phi_1949_: bool;
    var phi_1950_: bool;
    var phi_1954_: f32;
    var phi_1960_: f32;
    var phi_1962_: evaluate_Verdict;
    var phi_1967_: evaluate_Verdict;
    var phi_1968_: evaluate_Verdict;

    let _e43 = id_1;
    let _e50 = arrayLength((&map.member));
    let _e56 = arrayLength((&levels.member));
    let _e59 = p.member.size[0u];
    let _e61 = p.member.size[1u];
    let _e62 = lt_shaders_entry_pixel_index(_e43, _e59, _e61);
    if (bitcast<i32>(_e62.root) != 0i) {
        let _e68 = p.member.level_count;
        if (_e62.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e75 = samples.member[(0u + _e62.first_primitive)].normal[0u];
        let _e77 = global[0u];
        if (_e75 == _e77) {
            let _e80 = samples.member[(0u + _e62.first_primitive)].normal[1u];
            let _e82 = global[1u];
            if (_e80 == _e82) {
                let _e85 = samples.member[(0u + _e62.first_primitive)].normal[2u];
                let _e87 = global[2u];
                phi_1173_ = (_e85 == _e87);
                phi_1174_ = false;
            } else {
                phi_1173_ = bool();
                phi_1174_ = true;
            }
            let _e90 = phi_1173_;
            let _e92 = phi_1174_;
            phi_1175_ = _e90;
            phi_1176_ = _e92;
        } else {
            phi_1175_ = bool();
            phi_1176_ = true;
        }
        let _e94 = phi_1175_;
        let _e96 = phi_1176_;
        if _e96 {
            phi_1180_ = false;
        } else {
            phi_1180_ = _e94;
        }
        let _e98 = phi_1180_;
        if !(_e98) {
            let _e101 = samples.member[(0u + _e62.first_primitive)].position;
            let _e103 = p.member.light.place;
            let _e109 = p.member.light.place[3u];
            let _e116 = (_e103.x - (_e101.x * _e109));
            let _e117 = (_e103.y - (_e101.y * _e109));
            let _e118 = (_e103.z - (_e101.z * _e109));
            let _e120 = samples.member[(0u + _e62.first_primitive)].normal;
            if ((((_e120.x * _e116) + (_e120.y * _e117)) + (_e120.z * _e118)) > 0f) {
                let _e134 = (((_e116 * _e116) + (_e117 * _e117)) + (_e118 * _e118));
                let _e136 = p.member.light.axis;
                let _e148 = p.member.light.place[3u];
                if (_e148 == 0f) {
                    phi_1251_ = true;
                } else {
                    let _e151 = p.member.light.range_squared;
                    if (_e134 <= _e151) {
                        let _e154 = p.member.light.cos_outer;
                        phi_1250_ = (-((((_e116 * _e136.x) + (_e117 * _e136.y)) + (_e118 * _e136.z))) >= (_e154 * sqrt(_e134)));
                    } else {
                        phi_1250_ = false;
                    }
                    let _e159 = phi_1250_;
                    phi_1251_ = _e159;
                }
                let _e161 = phi_1251_;
                if _e161 {
                    let _e163 = samples.member[(0u + _e62.first_primitive)].flags;
                    let _e171 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e177 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e171.unnamed.visibility, false), _e171.unnamed_1);
                    phi_1262_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e177.unnamed, ((_e163 & 1u) == 0u));
                    phi_1263_ = false;
                } else {
                    phi_1262_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_1263_ = true;
                }
                let _e182 = phi_1262_;
                let _e184 = phi_1263_;
                phi_1264_ = _e182;
                phi_1265_ = _e184;
            } else {
                phi_1264_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_1265_ = true;
            }
            let _e186 = phi_1264_;
            let _e188 = phi_1265_;
            if _e188 {
                let _e194 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e200 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e194.unnamed.visibility, false), _e194.unnamed_1);
                phi_1272_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e200.unnamed, true);
            } else {
                phi_1272_ = _e186;
            }
            let _e205 = phi_1272_;
            phi_1276_ = _e205;
        } else {
            let _e211 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e217 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e211.unnamed.visibility, false), _e211.unnamed_1);
            phi_1276_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e217.unnamed, true);
        }
        let _e222 = phi_1276_;
        if _e222.unnamed_1 {
            phi_1968_ = evaluate_Verdict(_e222.unnamed.visibility, _e222.unnamed.is_doubted);
        } else {
            let _e230 = samples.member[(0u + _e62.first_primitive)].position;
            let _e232 = p.member.map_size;
            let _e234 = (0.5f / f32(_e232));
            let _e241 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e248 = lt_math_LightPoint(vec2<f32>(_e241.uv.x, 0f), _e241.depth, _e241.is_inside);
            let _e252 = lt_math_LightPoint(_e248.uv, 0f, _e248.is_inside);
            phi_1296_ = lt_math_LightPoint();
            phi_1299_ = 0u;
            phi_1301_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e252.uv, _e252.depth, false));
            loop {
                let _e259 = phi_1296_;
                let _e261 = phi_1299_;
                let _e263 = phi_1301_;
                local_1 = _e263;
                local_2 = _e263;
                local_3 = _e263;
                if (_e261 < _e68) {
                    if _e263.point.is_inside {
                        phi_1462_ = lt_math_LightPoint();
                        phi_1463_ = u32();
                        phi_1464_ = lt_math_LevelPoint();
                        phi_1465_ = false;
                    } else {
                        if (_e261 < _e56) {
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
                                phi_1387_ = (_e299 <= 1f);
                            } else {
                                phi_1387_ = false;
                            }
                            let _e331 = phi_1387_;
                            if _e331 {
                                if (_e313 >= 0f) {
                                    phi_1396_ = (_e313 <= 1f);
                                } else {
                                    phi_1396_ = false;
                                }
                                let _e335 = phi_1396_;
                                if _e335 {
                                    if (_e326 >= 0f) {
                                        phi_1405_ = (_e326 <= 1f);
                                    } else {
                                        phi_1405_ = false;
                                    }
                                    let _e339 = phi_1405_;
                                    phi_1406_ = _e339;
                                    phi_1407_ = false;
                                } else {
                                    phi_1406_ = bool();
                                    phi_1407_ = true;
                                }
                                let _e341 = phi_1406_;
                                let _e343 = phi_1407_;
                                phi_1408_ = _e341;
                                phi_1409_ = _e343;
                            } else {
                                phi_1408_ = bool();
                                phi_1409_ = true;
                            }
                            let _e345 = phi_1408_;
                            let _e347 = phi_1409_;
                            phi_1410_ = _e345;
                            phi_1411_ = _e347;
                        } else {
                            phi_1410_ = bool();
                            phi_1411_ = true;
                        }
                        let _e349 = phi_1410_;
                        let _e351 = phi_1411_;
                        if _e351 {
                            phi_1415_ = false;
                        } else {
                            phi_1415_ = _e349;
                        }
                        let _e353 = phi_1415_;
                        if _e353 {
                            if (_e299 >= _e234) {
                                if (_e299 <= (1f - _e234)) {
                                    if (_e313 >= _e234) {
                                        phi_1442_ = (_e313 <= (1f - _e234));
                                        phi_1443_ = false;
                                    } else {
                                        phi_1442_ = bool();
                                        phi_1443_ = true;
                                    }
                                    let _e361 = phi_1442_;
                                    let _e363 = phi_1443_;
                                    phi_1444_ = _e361;
                                    phi_1445_ = _e363;
                                } else {
                                    phi_1444_ = bool();
                                    phi_1445_ = true;
                                }
                                let _e365 = phi_1444_;
                                let _e367 = phi_1445_;
                                phi_1446_ = _e365;
                                phi_1447_ = _e367;
                            } else {
                                phi_1446_ = bool();
                                phi_1447_ = true;
                            }
                            let _e369 = phi_1446_;
                            let _e371 = phi_1447_;
                            phi_1448_ = _e369;
                            phi_1449_ = _e371;
                        } else {
                            phi_1448_ = bool();
                            phi_1449_ = true;
                        }
                        let _e373 = phi_1448_;
                        let _e375 = phi_1449_;
                        if _e375 {
                            phi_1453_ = false;
                        } else {
                            phi_1453_ = _e373;
                        }
                        let _e377 = phi_1453_;
                        let _e384 = lt_math_LightPoint(vec2<f32>(_e299, _e259.uv.y), _e259.depth, _e259.is_inside);
                        let _e391 = lt_math_LightPoint(vec2<f32>(_e384.uv.x, _e313), _e384.depth, _e384.is_inside);
                        let _e395 = lt_math_LightPoint(_e391.uv, _e326, _e391.is_inside);
                        let _e399 = lt_math_LightPoint(_e395.uv, _e395.depth, _e377);
                        phi_1462_ = _e399;
                        phi_1463_ = (_e261 + 1u);
                        phi_1464_ = lt_math_LevelPoint(_e261, _e399);
                        phi_1465_ = true;
                    }
                    let _e403 = phi_1462_;
                    let _e405 = phi_1463_;
                    let _e407 = phi_1464_;
                    let _e409 = phi_1465_;
                    phi_1297_ = _e403;
                    phi_1300_ = _e405;
                    phi_1302_ = _e407;
                    phi_1466_ = _e409;
                } else {
                    phi_1297_ = lt_math_LightPoint();
                    phi_1300_ = u32();
                    phi_1302_ = lt_math_LevelPoint();
                    phi_1466_ = false;
                }
                let _e411 = phi_1297_;
                let _e413 = phi_1300_;
                let _e415 = phi_1302_;
                let _e417 = phi_1466_;
                continue;
                continuing {
                    phi_1296_ = _e411;
                    phi_1299_ = _e413;
                    phi_1301_ = _e415;
                    break if !(_e417);
                }
            }
            let _e420 = local_1;
            if _e420.point.is_inside {
                if (0f > 0f) {
                    let _e426 = local_2;
                    if (_e426.level < _e56) {
                    } else {
                        return;
                    }
                    let _e431 = levels.member[(0u + _e426.level)];
                    let _e437 = global[0u];
                    if (_e431.row_w.x == _e437) {
                        let _e440 = global[1u];
                        if (_e431.row_w.y == _e440) {
                            let _e443 = global[2u];
                            phi_1506_ = (_e431.row_w.z == _e443);
                            phi_1507_ = false;
                        } else {
                            phi_1506_ = bool();
                            phi_1507_ = true;
                        }
                        let _e446 = phi_1506_;
                        let _e448 = phi_1507_;
                        phi_1508_ = _e446;
                        phi_1509_ = _e448;
                    } else {
                        phi_1508_ = bool();
                        phi_1509_ = true;
                    }
                    let _e450 = phi_1508_;
                    let _e452 = phi_1509_;
                    if _e452 {
                        phi_1513_ = false;
                    } else {
                        phi_1513_ = _e450;
                    }
                    let _e454 = phi_1513_;
                    if _e454 {
                        let _e456 = samples.member[(0u + _e62.first_primitive)].normal;
                        let _e458 = p.member.map_size;
                        let _e528 = ((abs(((((_e431.row_x.x * _e456.x) + (_e431.row_x.y * _e456.y)) + (_e431.row_x.z * _e456.z)) / (((_e431.row_x.x * _e431.row_x.x) + (_e431.row_x.y * _e431.row_x.y)) + (_e431.row_x.z * _e431.row_x.z)))) + abs(((((_e431.row_y.x * _e456.x) + (_e431.row_y.y * _e456.y)) + (_e431.row_y.z * _e456.z)) / (((_e431.row_y.x * _e431.row_y.x) + (_e431.row_y.y * _e431.row_y.y)) + (_e431.row_y.z * _e431.row_y.z))))) / (abs(((((_e431.row_z.x * _e456.x) + (_e431.row_z.y * _e456.y)) + (_e431.row_z.z * _e456.z)) / (((_e431.row_z.x * _e431.row_z.x) + (_e431.row_z.y * _e431.row_z.y)) + (_e431.row_z.z * _e431.row_z.z)))) * f32(_e458)));
                        if (_e528 < 0.002f) {
                            phi_1595_ = _e528;
                        } else {
                            phi_1595_ = 0.002f;
                        }
                        let _e531 = phi_1595_;
                        phi_1714_ = _e531;
                    } else {
                        let _e533 = p.member.map_size;
                        let _e539 = samples.member[(0u + _e62.first_primitive)].position;
                        let _e550 = ((((_e431.row_w.x * _e539.x) + (_e431.row_w.y * _e539.y)) + (_e431.row_w.z * _e539.z)) + _e431.row_w.w);
                        let _e563 = ((_e431.row_x.x - (_e431.row_w.x * _e420.point.uv.x)) / _e550);
                        let _e564 = ((_e431.row_x.y - (_e431.row_w.y * _e420.point.uv.x)) / _e550);
                        let _e565 = ((_e431.row_x.z - (_e431.row_w.z * _e420.point.uv.x)) / _e550);
                        let _e578 = ((_e431.row_y.x - (_e431.row_w.x * _e420.point.uv.y)) / _e550);
                        let _e579 = ((_e431.row_y.y - (_e431.row_w.y * _e420.point.uv.y)) / _e550);
                        let _e580 = ((_e431.row_y.z - (_e431.row_w.z * _e420.point.uv.y)) / _e550);
                        let _e586 = samples.member[(0u + _e62.first_primitive)].normal;
                        let _e591 = ((_e579 * _e586.z) - (_e586.y * _e580));
                        let _e596 = ((_e580 * _e586.x) - (_e586.z * _e578));
                        let _e601 = ((_e578 * _e586.y) - (_e586.x * _e579));
                        let _e603 = samples.member[(0u + _e62.first_primitive)].normal;
                        let _e608 = ((_e564 * _e603.z) - (_e603.y * _e565));
                        let _e613 = ((_e565 * _e603.x) - (_e603.z * _e563));
                        let _e618 = ((_e563 * _e603.y) - (_e603.x * _e564));
                        let _e645 = ((abs(((((_e431.row_z.x * _e591) + (_e431.row_z.y * _e596)) + (_e431.row_z.z * _e601)) / (((_e563 * _e591) + (_e564 * _e596)) + (_e565 * _e601)))) + abs(((((_e431.row_z.x * _e608) + (_e431.row_z.y * _e613)) + (_e431.row_z.z * _e618)) / (((_e578 * _e608) + (_e579 * _e613)) + (_e580 * _e618))))) / f32(_e533));
                        let _e647 = (16f / f32(_e533));
                        if (_e645 < _e647) {
                            phi_1713_ = _e645;
                        } else {
                            phi_1713_ = _e647;
                        }
                        let _e650 = phi_1713_;
                        phi_1714_ = _e650;
                    }
                    let _e652 = phi_1714_;
                    phi_1717_ = (_e420.point.depth - (0f * _e652));
                } else {
                    phi_1717_ = _e420.point.depth;
                }
                let _e656 = phi_1717_;
                let _e662 = p.member.map_size;
                let _e663 = f32(_e662);
                let _e666 = ((_e420.point.uv.x * _e663) - 0.5f);
                let _e667 = ((_e420.point.uv.y * _e663) - 0.5f);
                if (_e666 > -8388608f) {
                    let _e679 = f32(select(0i, select(select(i32(_e666), i32(-2147483648), (_e666 < bitcast<f32>(3472883712u))), 2147483647i, (_e666 > bitcast<f32>(1325400063u))), (_e666 == _e666)));
                    if (_e679 > _e666) {
                        phi_1746_ = 1f;
                    } else {
                        phi_1746_ = 0f;
                    }
                    let _e682 = phi_1746_;
                    if (_e666 < 8388608f) {
                        phi_1751_ = (_e679 - _e682);
                        phi_1752_ = false;
                    } else {
                        phi_1751_ = f32();
                        phi_1752_ = true;
                    }
                    let _e685 = phi_1751_;
                    let _e687 = phi_1752_;
                    phi_1753_ = _e685;
                    phi_1754_ = _e687;
                } else {
                    phi_1753_ = f32();
                    phi_1754_ = true;
                }
                let _e689 = phi_1753_;
                let _e691 = phi_1754_;
                if _e691 {
                    phi_1758_ = _e666;
                } else {
                    phi_1758_ = _e689;
                }
                let _e693 = phi_1758_;
                if (_e667 > -8388608f) {
                    let _e705 = f32(select(0i, select(select(i32(_e667), i32(-2147483648), (_e667 < bitcast<f32>(3472883712u))), 2147483647i, (_e667 > bitcast<f32>(1325400063u))), (_e667 == _e667)));
                    if (_e705 > _e667) {
                        phi_1778_ = 1f;
                    } else {
                        phi_1778_ = 0f;
                    }
                    let _e708 = phi_1778_;
                    if (_e667 < 8388608f) {
                        phi_1783_ = (_e705 - _e708);
                        phi_1784_ = false;
                    } else {
                        phi_1783_ = f32();
                        phi_1784_ = true;
                    }
                    let _e711 = phi_1783_;
                    let _e713 = phi_1784_;
                    phi_1785_ = _e711;
                    phi_1786_ = _e713;
                } else {
                    phi_1785_ = f32();
                    phi_1786_ = true;
                }
                let _e715 = phi_1785_;
                let _e717 = phi_1786_;
                if _e717 {
                    phi_1790_ = _e667;
                } else {
                    phi_1790_ = _e715;
                }
                let _e719 = phi_1790_;
                let _e720 = (_e666 - _e693);
                let _e721 = (_e667 - _e719);
                let _e730 = select(0i, select(select(i32(_e693), i32(-2147483648), (_e693 < bitcast<f32>(3472883712u))), 2147483647i, (_e693 > bitcast<f32>(1325400063u))), (_e693 == _e693));
                let _e739 = select(0i, select(select(i32(_e719), i32(-2147483648), (_e719 < bitcast<f32>(3472883712u))), 2147483647i, (_e719 > bitcast<f32>(1325400063u))), (_e719 == _e719));
                let _e750 = p.member.test;
                let _e751 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e750);
                let _e753 = p.member.map_size;
                let _e755 = local_3;
                local = _e751;
                let _e758 = ((_e755.level * _e753) * _e753);
                let _e760 = (bitcast<i32>(_e753) - 1i);
                if (_e730 > 0i) {
                    phi_1839_ = _e730;
                } else {
                    phi_1839_ = 0i;
                }
                let _e763 = phi_1839_;
                if (_e739 > 0i) {
                    phi_1844_ = _e739;
                } else {
                    phi_1844_ = 0i;
                }
                let _e766 = phi_1844_;
                if (_e763 < _e760) {
                    phi_1849_ = _e763;
                } else {
                    phi_1849_ = _e760;
                }
                let _e769 = phi_1849_;
                if (_e766 < _e760) {
                    phi_1854_ = _e766;
                } else {
                    phi_1854_ = _e760;
                }
                let _e772 = phi_1854_;
                let _e773 = bitcast<u32>(_e769);
                let _e775 = (_e730 + 1i);
                let _e776 = (_e739 + 1i);
                if (_e775 > 0i) {
                    phi_1863_ = _e775;
                } else {
                    phi_1863_ = 0i;
                }
                let _e779 = phi_1863_;
                if (_e776 > 0i) {
                    phi_1868_ = _e776;
                } else {
                    phi_1868_ = 0i;
                }
                let _e782 = phi_1868_;
                if (_e779 < _e760) {
                    phi_1873_ = _e779;
                } else {
                    phi_1873_ = _e760;
                }
                let _e785 = phi_1873_;
                if (_e782 < _e760) {
                    phi_1878_ = _e782;
                } else {
                    phi_1878_ = _e760;
                }
                let _e788 = phi_1878_;
                let _e789 = bitcast<u32>(_e785);
                let _e791 = (bitcast<u32>(_e772) * _e753);
                let _e792 = (bitcast<u32>(_e788) * _e753);
                let _e797 = ((_e791 + _e773) + _e758);
                let _e798 = ((_e791 + _e789) + _e758);
                let _e799 = ((_e792 + _e773) + _e758);
                let _e800 = ((_e792 + _e789) + _e758);
                if (_e797 < _e50) {
                } else {
                    return;
                }
                let _e804 = map.member[(0u + _e797)];
                if (_e798 < _e50) {
                } else {
                    return;
                }
                let _e808 = map.member[(0u + _e798)];
                if (_e799 < _e50) {
                } else {
                    return;
                }
                let _e812 = map.member[(0u + _e799)];
                if (_e800 < _e50) {
                } else {
                    return;
                }
                let _e816 = map.member[(0u + _e800)];
                let _e818 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e804, _e808, _e812, _e816), vec4<f32>(((1f - _e720) * (1f - _e721)), (_e720 * (1f - _e721)), ((1f - _e720) * _e721), (_e720 * _e721)), _e656);
                let _e820 = p.member.epsilon;
                if (_e818 <= _e820) {
                    phi_1929_ = true;
                } else {
                    phi_1929_ = (_e818 >= (1f - _e820));
                }
                let _e825 = phi_1929_;
                if ((bitcast<u32>(_e818) & 2147483647u) > 2139095040u) {
                    phi_1937_ = true;
                } else {
                    phi_1937_ = !(_e825);
                }
                let _e831 = phi_1937_;
                if _e831 {
                    if (_e818 > 0f) {
                        if (_e818 < 1f) {
                            phi_1949_ = false;
                        } else {
                            phi_1949_ = true;
                        }
                        let _e835 = phi_1949_;
                        phi_1950_ = _e835;
                    } else {
                        phi_1950_ = true;
                    }
                    let _e837 = phi_1950_;
                    if _e837 {
                        phi_1954_ = 0.5f;
                    } else {
                        phi_1954_ = _e818;
                    }
                    let _e839 = phi_1954_;
                    phi_1962_ = evaluate_Verdict(_e839, true);
                } else {
                    if (_e818 > 0.5f) {
                        phi_1960_ = 1f;
                    } else {
                        phi_1960_ = 0f;
                    }
                    let _e843 = phi_1960_;
                    phi_1962_ = evaluate_Verdict(_e843, false);
                }
                let _e846 = phi_1962_;
                phi_1967_ = evaluate_Verdict(_e846.visibility, _e846.is_doubted);
            } else {
                phi_1967_ = evaluate_Verdict(0.5f, true);
            }
            let _e852 = phi_1967_;
            phi_1968_ = _e852;
        }
        let _e854 = phi_1968_;
        if (_e62.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e62.first_primitive)] = _e854.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_msm_hausdorff_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
