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

struct type_22 {
    member: array<abi_Sample>,
}

struct type_26 {
    member: array<f32>,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
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

struct type_35 {
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

struct lt_bvh_slab_Span {
    near: f32,
    far: f32,
}

struct type_42 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_22;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_35;
@group(0) @binding(2) 
var<storage> map: type_26;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_26;
var<private> local_2: u32;
@group(0) @binding(4) 
var<storage, read_write> list: type_42;
var<workgroup> shared_: array<atomic<u32>, 2>;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_147_: lt_bvh_traverse_Tree;
    var phi_148_: bool;
    var phi_149_: lt_bvh_traverse_Tree;
    var phi_150_: bool;
    var phi_155_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_147_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_148_ = false;
        } else {
            phi_147_ = lt_bvh_traverse_Tree();
            phi_148_ = true;
        }
        let _e55 = phi_147_;
        let _e57 = phi_148_;
        phi_149_ = _e55;
        phi_150_ = _e57;
    } else {
        phi_149_ = lt_bvh_traverse_Tree();
        phi_150_ = true;
    }
    let _e59 = phi_149_;
    let _e61 = phi_150_;
    if _e61 {
        phi_155_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_155_ = _e59;
    }
    let _e66 = phi_155_;
    return lt_bvh_traverse_Tree(_e66.root, _e66.first_primitive);
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_182_: f32;
    var phi_183_: f32;
    var phi_184_: f32;
    var phi_201_: f32;
    var phi_202_: f32;
    var phi_203_: f32;
    var phi_219_: f32;
    var phi_220_: f32;
    var phi_221_: f32;
    var phi_237_: f32;
    var phi_238_: f32;
    var phi_239_: f32;
    var phi_255_: f32;
    var phi_256_: f32;
    var phi_257_: f32;
    var phi_292_: bool;
    var phi_293_: bool;
    var phi_294_: bool;
    var phi_295_: bool;
    var phi_296_: bool;
    var phi_297_: bool;
    var phi_301_: bool;
    var phi_612_: f32;
    var phi_613_: f32;
    var phi_614_: f32;
    var phi_631_: f32;
    var phi_632_: f32;
    var phi_633_: f32;
    var phi_650_: f32;
    var phi_651_: f32;
    var phi_652_: f32;
    var phi_669_: f32;
    var phi_670_: f32;
    var phi_671_: f32;
    var phi_694_: f32;
    var phi_695_: f32;
    var phi_696_: f32;
    var phi_707_: f32;
    var phi_722_: f32;
    var phi_724_: lt_bvh_slab_Span;
    var phi_782_: f32;
    var phi_783_: f32;
    var phi_784_: f32;
    var phi_785_: f32;
    var phi_786_: f32;
    var phi_787_: bool;
    var phi_791_: f32;
    var phi_801_: bool;
    var phi_814_: bool;
    var phi_818_: bool;
    var phi_819_: bool;
    var phi_829_: bool;
    var phi_830_: bool;
    var phi_831_: bool;
    var phi_835_: bool;
    var phi_886_: f32;
    var phi_887_: f32;
    var phi_888_: f32;
    var phi_905_: f32;
    var phi_906_: f32;
    var phi_907_: f32;
    var phi_924_: f32;
    var phi_925_: f32;
    var phi_926_: f32;
    var phi_943_: f32;
    var phi_944_: f32;
    var phi_945_: f32;
    var phi_968_: f32;
    var phi_969_: f32;
    var phi_970_: f32;
    var phi_1057_: f32;
    var phi_1058_: f32;
    var phi_1069_: bool;
    var phi_1073_: f32;
    var phi_1074_: f32;
    var phi_1089_: f32;
    var phi_1090_: f32;
    var phi_1091_: f32;
    var phi_1092_: f32;
    var phi_1093_: f32;
    var phi_1094_: f32;
    var phi_1095_: f32;
    var phi_1096_: bool;
    var phi_1097_: f32;
    var phi_1098_: f32;
    var phi_1099_: bool;
    var phi_1103_: f32;

    let _e46 = (*param_4);
    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_184_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_183_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_182_ = 1f;
            } else {
                phi_182_ = param_7;
            }
            let _e53 = phi_182_;
            phi_183_ = _e53;
        }
        let _e55 = phi_183_;
        phi_184_ = _e55;
    }
    let _e57 = phi_184_;
    let _e58 = (_e57 - 0.00000047683716f);
    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_203_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_202_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_201_ = 1f;
            } else {
                phi_201_ = param_5.x;
            }
            let _e66 = phi_201_;
            phi_202_ = _e66;
        }
        let _e68 = phi_202_;
        phi_203_ = _e68;
    }
    let _e70 = phi_203_;
    if ((bitcast<u32>(param_5.y) & 2147483647u) > 2139095040u) {
        phi_221_ = param_5.y;
    } else {
        if (param_5.y < 0f) {
            phi_220_ = 0f;
        } else {
            if (param_5.y > 1f) {
                phi_219_ = 1f;
            } else {
                phi_219_ = param_5.y;
            }
            let _e78 = phi_219_;
            phi_220_ = _e78;
        }
        let _e80 = phi_220_;
        phi_221_ = _e80;
    }
    let _e82 = phi_221_;
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_239_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_238_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_237_ = 1f;
            } else {
                phi_237_ = param_5.z;
            }
            let _e90 = phi_237_;
            phi_238_ = _e90;
        }
        let _e92 = phi_238_;
        phi_239_ = _e92;
    }
    let _e94 = phi_239_;
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_257_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_256_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_255_ = 1f;
            } else {
                phi_255_ = param_5.w;
            }
            let _e102 = phi_255_;
            phi_256_ = _e102;
        }
        let _e104 = phi_256_;
        phi_257_ = _e104;
    }
    let _e106 = phi_257_;
    let _e107 = (_e70 - _e58);
    let _e108 = (_e82 - _e58);
    let _e109 = (_e94 - _e58);
    let _e110 = (_e106 - _e58);
    let _e121 = ((((_e107 * param_6.x) + (_e108 * param_6.y)) + (_e109 * param_6.z)) + (_e110 * param_6.w));
    if ((bitcast<u32>(_e121) & 2147483647u) > 2139095040u) {
        phi_1097_ = _e121;
        phi_1098_ = f32();
        phi_1099_ = true;
    } else {
        if (_e107 >= 0f) {
            if (_e108 >= 0f) {
                if (_e109 >= 0f) {
                    phi_292_ = (_e110 >= 0f);
                    phi_293_ = false;
                } else {
                    phi_292_ = bool();
                    phi_293_ = true;
                }
                let _e130 = phi_292_;
                let _e132 = phi_293_;
                phi_294_ = _e130;
                phi_295_ = _e132;
            } else {
                phi_294_ = bool();
                phi_295_ = true;
            }
            let _e134 = phi_294_;
            let _e136 = phi_295_;
            phi_296_ = _e134;
            phi_297_ = _e136;
        } else {
            phi_296_ = bool();
            phi_297_ = true;
        }
        let _e138 = phi_296_;
        let _e140 = phi_297_;
        if _e140 {
            phi_301_ = false;
        } else {
            phi_301_ = _e138;
        }
        let _e142 = phi_301_;
        if _e142 {
            phi_1094_ = 1f;
            phi_1095_ = f32();
            phi_1096_ = true;
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
            let _e430 = (_e424 < 0.0000000000000000000000000000000001f);
            if _e430 {
                if ((bitcast<u32>(_e107) & 2147483647u) > 2139095040u) {
                    phi_614_ = _e107;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_613_ = 0f;
                    } else {
                        if (_e107 < 0f) {
                            phi_612_ = 0f;
                        } else {
                            phi_612_ = 1f;
                        }
                        let _e439 = phi_612_;
                        phi_613_ = _e439;
                    }
                    let _e441 = phi_613_;
                    phi_614_ = _e441;
                }
                let _e443 = phi_614_;
                if ((bitcast<u32>(_e108) & 2147483647u) > 2139095040u) {
                    phi_633_ = _e108;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_632_ = 0f;
                    } else {
                        if (_e108 < 0f) {
                            phi_631_ = 0f;
                        } else {
                            phi_631_ = 1f;
                        }
                        let _e452 = phi_631_;
                        phi_632_ = _e452;
                    }
                    let _e454 = phi_632_;
                    phi_633_ = _e454;
                }
                let _e456 = phi_633_;
                if ((bitcast<u32>(_e109) & 2147483647u) > 2139095040u) {
                    phi_652_ = _e109;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_651_ = 0f;
                    } else {
                        if (_e109 < 0f) {
                            phi_650_ = 0f;
                        } else {
                            phi_650_ = 1f;
                        }
                        let _e465 = phi_650_;
                        phi_651_ = _e465;
                    }
                    let _e467 = phi_651_;
                    phi_652_ = _e467;
                }
                let _e469 = phi_652_;
                if ((bitcast<u32>(_e110) & 2147483647u) > 2139095040u) {
                    phi_671_ = _e110;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_670_ = 0f;
                    } else {
                        if (_e110 < 0f) {
                            phi_669_ = 0f;
                        } else {
                            phi_669_ = 1f;
                        }
                        let _e478 = phi_669_;
                        phi_670_ = _e478;
                    }
                    let _e480 = phi_670_;
                    phi_671_ = _e480;
                }
                let _e482 = phi_671_;
                let _e490 = (((((_e443 * _e146) + (_e456 * _e148)) + (_e469 * _e150)) + (_e482 * _e152)) + _e143);
                if ((bitcast<u32>(_e490) & 2147483647u) > 2139095040u) {
                    phi_696_ = _e490;
                } else {
                    if (_e490 < 0f) {
                        phi_695_ = 0f;
                    } else {
                        if (_e490 > 1f) {
                            phi_694_ = 1f;
                        } else {
                            phi_694_ = _e490;
                        }
                        let _e497 = phi_694_;
                        phi_695_ = _e497;
                    }
                    let _e499 = phi_695_;
                    phi_696_ = _e499;
                }
                let _e501 = phi_696_;
                phi_1092_ = _e501;
                phi_1093_ = f32();
            } else {
                let _e503 = ((0.5f * -(((((((((_e207 * (_e107 + _e108)) + (_e211 * (_e107 + _e109))) + (_e235 * (_e107 + _e153))) + (_e247 * (_e107 + _e154))) + ((((_e208 * (_e108 + _e109)) + (_e212 * (_e108 + _e110))) + (_e236 * (_e108 + _e153))) + (_e248 * (_e108 + _e154)))) + ((((_e209 * (_e109 + _e110)) + (_e213 * (_e109 + _e107))) + (_e237 * (_e109 + _e153))) + (_e249 * (_e109 + _e154)))) + ((((_e210 * (_e110 + _e107)) + (_e214 * (_e110 + _e108))) + (_e238 * (_e110 + _e153))) + (_e250 * (_e110 + _e154)))) + (_e421 * (_e153 + _e154))))) / _e424);
                let _e504 = ((((((((_e207 + _e211) + _e235) + _e247) + (((_e208 + _e212) + _e236) + _e248)) + (((_e209 + _e213) + _e237) + _e249)) + (((_e210 + _e214) + _e238) + _e250)) + _e421) / _e424);
                let _e506 = ((_e503 * _e503) - _e504);
                if (_e506 > 0f) {
                    phi_707_ = sqrt(_e506);
                } else {
                    phi_707_ = 0f;
                }
                let _e510 = phi_707_;
                if (_e503 > 0f) {
                    let _e513 = (-(_e503) - _e510);
                    phi_724_ = lt_bvh_slab_Span(_e513, (_e504 / _e513));
                } else {
                    let _e516 = (_e510 - _e503);
                    if (_e516 > 0f) {
                        phi_722_ = (_e504 / _e516);
                    } else {
                        phi_722_ = 0f;
                    }
                    let _e520 = phi_722_;
                    phi_724_ = lt_bvh_slab_Span(_e520, _e516);
                }
                let _e523 = phi_724_;
                if (_e523.near >= 0f) {
                    phi_785_ = 1f;
                    phi_786_ = f32();
                    phi_787_ = true;
                } else {
                    let _e527 = (_e523.far <= 0f);
                    if _e527 {
                        phi_783_ = (_e418 / _e424);
                        phi_784_ = f32();
                    } else {
                        let _e538 = (((((_e146 * _e107) + (_e148 * _e108)) + (_e150 * _e109)) + (_e152 * _e110)) + (_e143 * (_e153 + _e154)));
                        let _e554 = (((((_e146 * (_e107 * _e107)) + (_e148 * (_e108 * _e108))) + (_e150 * (_e109 * _e109))) + (_e152 * (_e110 * _e110))) + (_e143 * ((_e153 * _e153) + (_e154 * _e154))));
                        if (-(_e523.near) <= _e523.far) {
                            phi_782_ = (1f - (((_e523.near * _e523.near) * ((_e523.far * _e554) - _e538)) / (_e523.far - _e523.near)));
                        } else {
                            phi_782_ = ((_e418 / _e424) + (((_e523.far * _e523.far) * (_e538 - (_e523.near * _e554))) / (_e523.far - _e523.near)));
                        }
                        let _e573 = phi_782_;
                        phi_783_ = f32();
                        phi_784_ = _e573;
                    }
                    let _e575 = phi_783_;
                    let _e577 = phi_784_;
                    phi_785_ = _e575;
                    phi_786_ = _e577;
                    phi_787_ = _e527;
                }
                let _e579 = phi_785_;
                let _e581 = phi_786_;
                let _e583 = phi_787_;
                if _e583 {
                    phi_791_ = _e579;
                } else {
                    phi_791_ = _e581;
                }
                let _e585 = phi_791_;
                if ((_e523.near * _e153) >= (1f - 0.00001f)) {
                    phi_801_ = true;
                } else {
                    phi_801_ = ((_e523.near * _e154) >= (1f - 0.00001f));
                }
                let _e593 = phi_801_;
                if _e593 {
                    if ((_e523.far * _e153) >= (1f - 0.00001f)) {
                        phi_814_ = true;
                    } else {
                        phi_814_ = ((_e523.far * _e154) >= (1f - 0.00001f));
                    }
                    let _e601 = phi_814_;
                    if _e601 {
                        phi_818_ = false;
                    } else {
                        phi_818_ = true;
                    }
                    let _e603 = phi_818_;
                    phi_819_ = _e603;
                } else {
                    phi_819_ = true;
                }
                let _e605 = phi_819_;
                if _e605 {
                    let _e607 = (-(_e153) < 0.0001f);
                    if _e607 {
                        phi_829_ = bool();
                    } else {
                        phi_829_ = (_e154 < 0.0001f);
                    }
                    let _e610 = phi_829_;
                    phi_830_ = _e610;
                    phi_831_ = _e607;
                } else {
                    phi_830_ = bool();
                    phi_831_ = true;
                }
                let _e612 = phi_830_;
                let _e614 = phi_831_;
                if _e614 {
                    phi_835_ = true;
                } else {
                    phi_835_ = _e612;
                }
                let _e616 = phi_835_;
                if !(_e616) {
                    let _e622 = ((_e146 * _e70) * _e156);
                    let _e623 = ((_e148 * _e82) * _e158);
                    let _e624 = ((_e150 * _e94) * _e160);
                    let _e625 = ((_e152 * _e106) * _e162);
                    let _e643 = ((((_e622 * (_e107 * _e107)) + (_e623 * (_e108 * _e108))) + (_e624 * (_e109 * _e109))) + (_e625 * (_e110 * _e110)));
                    if (_e643 < 0.0000000000000000000000000000000001f) {
                        if ((bitcast<u32>(_e107) & 2147483647u) > 2139095040u) {
                            phi_888_ = _e107;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_887_ = 0f;
                            } else {
                                if (_e107 < 0f) {
                                    phi_886_ = 0f;
                                } else {
                                    phi_886_ = 1f;
                                }
                                let _e653 = phi_886_;
                                phi_887_ = _e653;
                            }
                            let _e655 = phi_887_;
                            phi_888_ = _e655;
                        }
                        let _e657 = phi_888_;
                        if ((bitcast<u32>(_e108) & 2147483647u) > 2139095040u) {
                            phi_907_ = _e108;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_906_ = 0f;
                            } else {
                                if (_e108 < 0f) {
                                    phi_905_ = 0f;
                                } else {
                                    phi_905_ = 1f;
                                }
                                let _e666 = phi_905_;
                                phi_906_ = _e666;
                            }
                            let _e668 = phi_906_;
                            phi_907_ = _e668;
                        }
                        let _e670 = phi_907_;
                        if ((bitcast<u32>(_e109) & 2147483647u) > 2139095040u) {
                            phi_926_ = _e109;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_925_ = 0f;
                            } else {
                                if (_e109 < 0f) {
                                    phi_924_ = 0f;
                                } else {
                                    phi_924_ = 1f;
                                }
                                let _e679 = phi_924_;
                                phi_925_ = _e679;
                            }
                            let _e681 = phi_925_;
                            phi_926_ = _e681;
                        }
                        let _e683 = phi_926_;
                        if ((bitcast<u32>(_e110) & 2147483647u) > 2139095040u) {
                            phi_945_ = _e110;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_944_ = 0f;
                            } else {
                                if (_e110 < 0f) {
                                    phi_943_ = 0f;
                                } else {
                                    phi_943_ = 1f;
                                }
                                let _e692 = phi_943_;
                                phi_944_ = _e692;
                            }
                            let _e694 = phi_944_;
                            phi_945_ = _e694;
                        }
                        let _e696 = phi_945_;
                        let _e704 = (((((_e657 * _e146) + (_e670 * _e148)) + (_e683 * _e150)) + (_e696 * _e152)) + _e143);
                        if ((bitcast<u32>(_e704) & 2147483647u) > 2139095040u) {
                            phi_970_ = _e704;
                        } else {
                            if (_e704 < 0f) {
                                phi_969_ = 0f;
                            } else {
                                if (_e704 > 1f) {
                                    phi_968_ = 1f;
                                } else {
                                    phi_968_ = _e704;
                                }
                                let _e711 = phi_968_;
                                phi_969_ = _e711;
                            }
                            let _e713 = phi_969_;
                            phi_970_ = _e713;
                        }
                        let _e715 = phi_970_;
                        phi_1058_ = _e715;
                    } else {
                        let _e716 = (((((_e622 * _e107) + (_e623 * _e108)) + (_e624 * _e109)) + (_e625 * _e110)) / _e643);
                        let _e733 = ((_e146 * _e107) * (vec4<f32>(1f, 1f, 1f, 1f).x - (_e716 * _e107)));
                        let _e734 = ((_e148 * _e108) * (vec4<f32>(1f, 1f, 1f, 1f).y - (_e716 * _e108)));
                        let _e735 = ((_e150 * _e109) * (vec4<f32>(1f, 1f, 1f, 1f).z - (_e716 * _e109)));
                        let _e736 = ((_e152 * _e110) * (vec4<f32>(1f, 1f, 1f, 1f).w - (_e716 * _e110)));
                        if (_e716 > 0f) {
                            phi_1057_ = ((1f - _e143) - (((((_e733 * _e156) + (_e734 * _e158)) + (_e735 * _e160)) + (_e736 * _e162)) / (_e153 * (1f - (_e153 * _e716)))));
                        } else {
                            phi_1057_ = ((((((((_e622 * ((_e623 * _e167) + ((0.5f * _e624) * _e175))) * vec4<f32>(1f, 1f, 1f, 1f).x) + ((_e623 * ((_e624 * _e168) + ((0.5f * _e625) * _e176))) * vec4<f32>(1f, 1f, 1f, 1f).y)) + ((_e624 * ((_e625 * _e169) + ((0.5f * _e622) * _e177))) * vec4<f32>(1f, 1f, 1f, 1f).z)) + ((_e625 * ((_e622 * _e170) + ((0.5f * _e623) * _e178))) * vec4<f32>(1f, 1f, 1f, 1f).w)) / (_e643 * (-(_e153) * _e154))) + _e143) + (((((_e733 * _e70) + (_e734 * _e82)) + (_e735 * _e94)) + (_e736 * _e106)) / (_e154 * (1f - (_e716 * _e154)))));
                        }
                        let _e800 = phi_1057_;
                        phi_1058_ = _e800;
                    }
                    let _e802 = phi_1058_;
                    if ((bitcast<u32>(_e585) & 2147483647u) > 2139095040u) {
                        phi_1069_ = true;
                    } else {
                        let _e806 = (_e585 < _e802);
                        if _e806 {
                        }
                        phi_1069_ = _e806;
                    }
                    let _e808 = phi_1069_;
                    if _e808 {
                        phi_1073_ = _e585;
                    } else {
                        phi_1073_ = _e802;
                    }
                    let _e810 = phi_1073_;
                    phi_1074_ = _e810;
                } else {
                    phi_1074_ = _e585;
                }
                let _e812 = phi_1074_;
                if ((bitcast<u32>(_e812) & 2147483647u) > 2139095040u) {
                    phi_1091_ = _e812;
                } else {
                    if (_e812 < 0f) {
                        phi_1090_ = 0f;
                    } else {
                        if (_e812 > 1f) {
                            phi_1089_ = 1f;
                        } else {
                            phi_1089_ = _e812;
                        }
                        let _e819 = phi_1089_;
                        phi_1090_ = _e819;
                    }
                    let _e821 = phi_1090_;
                    phi_1091_ = _e821;
                }
                let _e823 = phi_1091_;
                phi_1092_ = f32();
                phi_1093_ = _e823;
            }
            let _e825 = phi_1092_;
            let _e827 = phi_1093_;
            phi_1094_ = _e825;
            phi_1095_ = _e827;
            phi_1096_ = _e430;
        }
        let _e829 = phi_1094_;
        let _e831 = phi_1095_;
        let _e833 = phi_1096_;
        phi_1097_ = _e829;
        phi_1098_ = _e831;
        phi_1099_ = _e833;
    }
    let _e835 = phi_1097_;
    let _e837 = phi_1098_;
    let _e839 = phi_1099_;
    if _e839 {
        phi_1103_ = _e835;
    } else {
        phi_1103_ = _e837;
    }
    let _e841 = phi_1103_;
    return _e841;
}

fn function_() {
    var local_1: f32;
    var phi_1157_: bool;
    var phi_1158_: bool;
    var phi_1159_: bool;
    var phi_1160_: bool;
    var phi_1164_: bool;
    var phi_1208_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1212_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1289_: bool;
    var phi_1298_: bool;
    var phi_1307_: bool;
    var phi_1308_: bool;
    var phi_1309_: bool;
    var phi_1310_: bool;
    var phi_1311_: bool;
    var phi_1312_: bool;
    var phi_1313_: bool;
    var phi_1317_: bool;
    var phi_1411_: f32;
    var phi_1414_: f32;
    var phi_1443_: f32;
    var phi_1448_: f32;
    var phi_1449_: bool;
    var phi_1450_: f32;
    var phi_1451_: bool;
    var phi_1455_: f32;
    var phi_1475_: f32;
    var phi_1480_: f32;
    var phi_1481_: bool;
    var phi_1482_: f32;
    var phi_1483_: bool;
    var phi_1487_: f32;
    var phi_1533_: i32;
    var phi_1538_: i32;
    var phi_1543_: i32;
    var phi_1548_: i32;
    var phi_1557_: i32;
    var phi_1562_: i32;
    var phi_1567_: i32;
    var phi_1572_: i32;
    var phi_1619_: bool;
    var phi_1627_: bool;
    var phi_1632_: f32;
    var phi_1635_: evaluate_Verdict;
    var phi_1636_: evaluate_Verdict;
    var phi_1640_: bool;
    var phi_1641_: u32;
    var phi_1647_: u32;

    let _e43 = id_1;
    let _e44 = local_2;
    let _e49 = arrayLength((&map.member));
    if (_e44 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    let _e56 = p.member.size[0u];
    let _e58 = p.member.size[1u];
    let _e59 = lt_shaders_entry_pixel_index(_e43, _e56, _e58);
    if (bitcast<i32>(_e59.root) != 0i) {
        let _e66 = p.member.light;
        let _e69 = samples.member[_e59.first_primitive].normal[0u];
        let _e71 = global[0u];
        if (_e69 == _e71) {
            let _e74 = samples.member[_e59.first_primitive].normal[1u];
            let _e76 = global[1u];
            if (_e74 == _e76) {
                let _e79 = samples.member[_e59.first_primitive].normal[2u];
                let _e81 = global[2u];
                phi_1157_ = (_e79 == _e81);
                phi_1158_ = false;
            } else {
                phi_1157_ = bool();
                phi_1158_ = true;
            }
            let _e84 = phi_1157_;
            let _e86 = phi_1158_;
            phi_1159_ = _e84;
            phi_1160_ = _e86;
        } else {
            phi_1159_ = bool();
            phi_1160_ = true;
        }
        let _e88 = phi_1159_;
        let _e90 = phi_1160_;
        if _e90 {
            phi_1164_ = false;
        } else {
            phi_1164_ = _e88;
        }
        let _e92 = phi_1164_;
        if !(_e92) {
            let _e95 = samples.member[_e59.first_primitive].normal;
            let _e97 = samples.member[_e59.first_primitive].position;
            if ((((_e95.x * (_e66.x - (_e97.x * _e66.w))) + (_e95.y * (_e66.y - (_e97.y * _e66.w)))) + (_e95.z * (_e66.z - (_e97.z * _e66.w)))) > 0f) {
                let _e121 = samples.member[_e59.first_primitive].flags;
                let _e129 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e135 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e129.unnamed.visibility, false), _e129.unnamed_1);
                phi_1208_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e135.unnamed, ((_e121 & 1u) == 0u));
            } else {
                let _e144 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e150 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e144.unnamed.visibility, false), _e144.unnamed_1);
                phi_1208_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e150.unnamed, true);
            }
            let _e155 = phi_1208_;
            phi_1212_ = _e155;
        } else {
            let _e161 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e167 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e161.unnamed.visibility, false), _e161.unnamed_1);
            phi_1212_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e167.unnamed, true);
        }
        let _e172 = phi_1212_;
        if _e172.unnamed_1 {
            phi_1636_ = evaluate_Verdict(_e172.unnamed.visibility, _e172.unnamed.is_doubted);
        } else {
            let _e180 = samples.member[_e59.first_primitive].position;
            let _e186 = p.member.projection.row_w;
            let _e197 = ((((_e186.x * _e180.x) + (_e186.y * _e180.y)) + (_e186.z * _e180.z)) + (_e186.w * 1f));
            let _e199 = p.member.projection.row_x;
            let _e211 = (((((_e199.x * _e180.x) + (_e199.y * _e180.y)) + (_e199.z * _e180.z)) + (_e199.w * 1f)) / _e197);
            let _e213 = p.member.projection.row_y;
            let _e225 = (((((_e213.x * _e180.x) + (_e213.y * _e180.y)) + (_e213.z * _e180.z)) + (_e213.w * 1f)) / _e197);
            let _e227 = p.member.projection.row_z;
            let _e238 = ((((_e227.x * _e180.x) + (_e227.y * _e180.y)) + (_e227.z * _e180.z)) + (_e227.w * 1f));
            if (_e197 > 0f) {
                if (_e211 >= 0f) {
                    phi_1289_ = (_e211 <= 1f);
                } else {
                    phi_1289_ = false;
                }
                let _e243 = phi_1289_;
                if _e243 {
                    if (_e225 >= 0f) {
                        phi_1298_ = (_e225 <= 1f);
                    } else {
                        phi_1298_ = false;
                    }
                    let _e247 = phi_1298_;
                    if _e247 {
                        if (_e238 >= 0f) {
                            phi_1307_ = (_e238 <= 1f);
                        } else {
                            phi_1307_ = false;
                        }
                        let _e251 = phi_1307_;
                        phi_1308_ = _e251;
                        phi_1309_ = false;
                    } else {
                        phi_1308_ = bool();
                        phi_1309_ = true;
                    }
                    let _e253 = phi_1308_;
                    let _e255 = phi_1309_;
                    phi_1310_ = _e253;
                    phi_1311_ = _e255;
                } else {
                    phi_1310_ = bool();
                    phi_1311_ = true;
                }
                let _e257 = phi_1310_;
                let _e259 = phi_1311_;
                phi_1312_ = _e257;
                phi_1313_ = _e259;
            } else {
                phi_1312_ = bool();
                phi_1313_ = true;
            }
            let _e261 = phi_1312_;
            let _e263 = phi_1313_;
            if _e263 {
                phi_1317_ = false;
            } else {
                phi_1317_ = _e261;
            }
            let _e265 = phi_1317_;
            if _e265 {
                if (0f > 0f) {
                    let _e268 = samples.member[_e59.first_primitive].normal;
                    let _e270 = p.member.map_size;
                    let _e273 = p.member.projection.row_x;
                    let _e295 = p.member.projection.row_y;
                    let _e317 = p.member.projection.row_z;
                    let _e344 = ((abs(((((_e273.x * _e268.x) + (_e273.y * _e268.y)) + (_e273.z * _e268.z)) / (((_e273.x * _e273.x) + (_e273.y * _e273.y)) + (_e273.z * _e273.z)))) + abs(((((_e295.x * _e268.x) + (_e295.y * _e268.y)) + (_e295.z * _e268.z)) / (((_e295.x * _e295.x) + (_e295.y * _e295.y)) + (_e295.z * _e295.z))))) / (abs(((((_e317.x * _e268.x) + (_e317.y * _e268.y)) + (_e317.z * _e268.z)) / (((_e317.x * _e317.x) + (_e317.y * _e317.y)) + (_e317.z * _e317.z)))) * f32(_e270)));
                    if (_e344 < 0.002f) {
                        phi_1411_ = _e344;
                    } else {
                        phi_1411_ = 0.002f;
                    }
                    let _e347 = phi_1411_;
                    phi_1414_ = (_e238 - (0f * _e347));
                } else {
                    phi_1414_ = _e238;
                }
                let _e351 = phi_1414_;
                let _e353 = p.member.map_size;
                let _e354 = f32(_e353);
                let _e357 = ((_e211 * _e354) - 0.5f);
                let _e358 = ((_e225 * _e354) - 0.5f);
                if (_e357 > -8388608f) {
                    let _e370 = f32(select(0i, select(select(i32(_e357), i32(-2147483648), (_e357 < bitcast<f32>(3472883712u))), 2147483647i, (_e357 > bitcast<f32>(1325400063u))), (_e357 == _e357)));
                    if (_e370 > _e357) {
                        phi_1443_ = 1f;
                    } else {
                        phi_1443_ = 0f;
                    }
                    let _e373 = phi_1443_;
                    if (_e357 < 8388608f) {
                        phi_1448_ = (_e370 - _e373);
                        phi_1449_ = false;
                    } else {
                        phi_1448_ = f32();
                        phi_1449_ = true;
                    }
                    let _e376 = phi_1448_;
                    let _e378 = phi_1449_;
                    phi_1450_ = _e376;
                    phi_1451_ = _e378;
                } else {
                    phi_1450_ = f32();
                    phi_1451_ = true;
                }
                let _e380 = phi_1450_;
                let _e382 = phi_1451_;
                if _e382 {
                    phi_1455_ = _e357;
                } else {
                    phi_1455_ = _e380;
                }
                let _e384 = phi_1455_;
                if (_e358 > -8388608f) {
                    let _e396 = f32(select(0i, select(select(i32(_e358), i32(-2147483648), (_e358 < bitcast<f32>(3472883712u))), 2147483647i, (_e358 > bitcast<f32>(1325400063u))), (_e358 == _e358)));
                    if (_e396 > _e358) {
                        phi_1475_ = 1f;
                    } else {
                        phi_1475_ = 0f;
                    }
                    let _e399 = phi_1475_;
                    if (_e358 < 8388608f) {
                        phi_1480_ = (_e396 - _e399);
                        phi_1481_ = false;
                    } else {
                        phi_1480_ = f32();
                        phi_1481_ = true;
                    }
                    let _e402 = phi_1480_;
                    let _e404 = phi_1481_;
                    phi_1482_ = _e402;
                    phi_1483_ = _e404;
                } else {
                    phi_1482_ = f32();
                    phi_1483_ = true;
                }
                let _e406 = phi_1482_;
                let _e408 = phi_1483_;
                if _e408 {
                    phi_1487_ = _e358;
                } else {
                    phi_1487_ = _e406;
                }
                let _e410 = phi_1487_;
                let _e411 = (_e357 - _e384);
                let _e412 = (_e358 - _e410);
                let _e421 = select(0i, select(select(i32(_e384), i32(-2147483648), (_e384 < bitcast<f32>(3472883712u))), 2147483647i, (_e384 > bitcast<f32>(1325400063u))), (_e384 == _e384));
                let _e430 = select(0i, select(select(i32(_e410), i32(-2147483648), (_e410 < bitcast<f32>(3472883712u))), 2147483647i, (_e410 > bitcast<f32>(1325400063u))), (_e410 == _e410));
                let _e441 = p.member.test;
                let _e442 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e441);
                let _e444 = p.member.map_size;
                local_1 = _e442;
                let _e446 = (bitcast<i32>(_e444) - 1i);
                if (_e421 > 0i) {
                    phi_1533_ = _e421;
                } else {
                    phi_1533_ = 0i;
                }
                let _e449 = phi_1533_;
                if (_e430 > 0i) {
                    phi_1538_ = _e430;
                } else {
                    phi_1538_ = 0i;
                }
                let _e452 = phi_1538_;
                if (_e449 < _e446) {
                    phi_1543_ = _e449;
                } else {
                    phi_1543_ = _e446;
                }
                let _e455 = phi_1543_;
                if (_e452 < _e446) {
                    phi_1548_ = _e452;
                } else {
                    phi_1548_ = _e446;
                }
                let _e458 = phi_1548_;
                let _e459 = bitcast<u32>(_e455);
                let _e461 = (_e421 + 1i);
                let _e462 = (_e430 + 1i);
                if (_e461 > 0i) {
                    phi_1557_ = _e461;
                } else {
                    phi_1557_ = 0i;
                }
                let _e465 = phi_1557_;
                if (_e462 > 0i) {
                    phi_1562_ = _e462;
                } else {
                    phi_1562_ = 0i;
                }
                let _e468 = phi_1562_;
                if (_e465 < _e446) {
                    phi_1567_ = _e465;
                } else {
                    phi_1567_ = _e446;
                }
                let _e471 = phi_1567_;
                if (_e468 < _e446) {
                    phi_1572_ = _e468;
                } else {
                    phi_1572_ = _e446;
                }
                let _e474 = phi_1572_;
                let _e475 = bitcast<u32>(_e471);
                let _e477 = (bitcast<u32>(_e458) * _e444);
                let _e478 = (bitcast<u32>(_e474) * _e444);
                let _e479 = (_e477 + _e459);
                let _e480 = (_e477 + _e475);
                let _e481 = (_e478 + _e459);
                let _e482 = (_e478 + _e475);
                if (_e479 < _e49) {
                } else {
                    return;
                }
                let _e486 = map.member[(0u + _e479)];
                if (_e480 < _e49) {
                } else {
                    return;
                }
                let _e490 = map.member[(0u + _e480)];
                if (_e481 < _e49) {
                } else {
                    return;
                }
                let _e494 = map.member[(0u + _e481)];
                if (_e482 < _e49) {
                } else {
                    return;
                }
                let _e498 = map.member[(0u + _e482)];
                let _e500 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local_1), vec4<f32>(_e486, _e490, _e494, _e498), vec4<f32>(((1f - _e411) * (1f - _e412)), (_e411 * (1f - _e412)), ((1f - _e411) * _e412), (_e411 * _e412)), _e351);
                let _e502 = p.member.epsilon;
                if (_e500 <= _e502) {
                    phi_1619_ = true;
                } else {
                    phi_1619_ = (_e500 >= (1f - _e502));
                }
                let _e507 = phi_1619_;
                if ((bitcast<u32>(_e500) & 2147483647u) > 2139095040u) {
                    phi_1627_ = true;
                } else {
                    phi_1627_ = !(_e507);
                }
                let _e513 = phi_1627_;
                if (_e500 > 0.5f) {
                    phi_1632_ = 1f;
                } else {
                    phi_1632_ = 0f;
                }
                let _e516 = phi_1632_;
                phi_1635_ = evaluate_Verdict(_e516, _e513);
            } else {
                phi_1635_ = evaluate_Verdict(1f, true);
            }
            let _e520 = phi_1635_;
            phi_1636_ = _e520;
        }
        let _e522 = phi_1636_;
        visibility.member[_e59.first_primitive] = _e522.visibility;
        phi_1640_ = _e522.is_doubted;
        phi_1641_ = _e59.first_primitive;
    } else {
        phi_1640_ = false;
        phi_1641_ = 0u;
    }
    let _e527 = phi_1640_;
    let _e529 = phi_1641_;
    if _e527 {
        let _e531 = atomicAdd((&shared_[0u]), 1u);
        phi_1647_ = _e531;
    } else {
        phi_1647_ = 0u;
    }
    let _e533 = phi_1647_;
    workgroupBarrier();
    if (_e44 == 0u) {
        let _e537 = atomicLoad((&shared_[0u]));
        let _e538 = atomicAdd((&list.member[3u]), _e537);
        atomicStore((&shared_[1u]), _e538);
    }
    workgroupBarrier();
    if _e527 {
        let _e541 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e541) + _e533)]), _e529);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_msm_hausdorff_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
