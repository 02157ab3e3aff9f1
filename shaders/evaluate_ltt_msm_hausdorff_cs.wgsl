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

struct type_36 {
    member: abi_ShadowParams,
}

struct lt_math_OneLevel {
    projection: lt_math_LightProjection,
}

struct lt_bvh_slab_Span {
    near: f32,
    far: f32,
}

struct type_43 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
var<private> local_2: u32;
@group(0) @binding(1) 
var<storage> samples: type_10;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(0) 
var<uniform> p: type_36;
@group(0) @binding(2) 
var<storage> map: type_18;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_18;
@group(0) @binding(4) 
var<storage, read_write> list: type_43;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_149_: lt_bvh_traverse_Tree;
    var phi_150_: bool;
    var phi_151_: lt_bvh_traverse_Tree;
    var phi_152_: bool;
    var phi_157_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_149_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_150_ = false;
        } else {
            phi_149_ = lt_bvh_traverse_Tree();
            phi_150_ = true;
        }
        let _e55 = phi_149_;
        let _e57 = phi_150_;
        phi_151_ = _e55;
        phi_152_ = _e57;
    } else {
        phi_151_ = lt_bvh_traverse_Tree();
        phi_152_ = true;
    }
    let _e59 = phi_151_;
    let _e61 = phi_152_;
    if _e61 {
        phi_157_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_157_ = _e59;
    }
    let _e66 = phi_157_;
    return lt_bvh_traverse_Tree(_e66.root, _e66.first_primitive);
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_184_: f32;
    var phi_185_: f32;
    var phi_186_: f32;
    var phi_203_: f32;
    var phi_204_: f32;
    var phi_205_: f32;
    var phi_221_: f32;
    var phi_222_: f32;
    var phi_223_: f32;
    var phi_239_: f32;
    var phi_240_: f32;
    var phi_241_: f32;
    var phi_257_: f32;
    var phi_258_: f32;
    var phi_259_: f32;
    var phi_294_: bool;
    var phi_295_: bool;
    var phi_296_: bool;
    var phi_297_: bool;
    var phi_298_: bool;
    var phi_299_: bool;
    var phi_303_: bool;
    var phi_614_: f32;
    var phi_615_: f32;
    var phi_616_: f32;
    var phi_633_: f32;
    var phi_634_: f32;
    var phi_635_: f32;
    var phi_652_: f32;
    var phi_653_: f32;
    var phi_654_: f32;
    var phi_671_: f32;
    var phi_672_: f32;
    var phi_673_: f32;
    var phi_696_: f32;
    var phi_697_: f32;
    var phi_698_: f32;
    var phi_709_: f32;
    var phi_724_: f32;
    var phi_726_: lt_bvh_slab_Span;
    var phi_784_: f32;
    var phi_785_: f32;
    var phi_786_: f32;
    var phi_787_: f32;
    var phi_788_: f32;
    var phi_789_: bool;
    var phi_793_: f32;
    var phi_803_: bool;
    var phi_816_: bool;
    var phi_820_: bool;
    var phi_821_: bool;
    var phi_831_: bool;
    var phi_832_: bool;
    var phi_833_: bool;
    var phi_837_: bool;
    var phi_888_: f32;
    var phi_889_: f32;
    var phi_890_: f32;
    var phi_907_: f32;
    var phi_908_: f32;
    var phi_909_: f32;
    var phi_926_: f32;
    var phi_927_: f32;
    var phi_928_: f32;
    var phi_945_: f32;
    var phi_946_: f32;
    var phi_947_: f32;
    var phi_970_: f32;
    var phi_971_: f32;
    var phi_972_: f32;
    var phi_1059_: f32;
    var phi_1060_: f32;
    var phi_1071_: bool;
    var phi_1075_: f32;
    var phi_1076_: f32;
    var phi_1091_: f32;
    var phi_1092_: f32;
    var phi_1093_: f32;
    var phi_1094_: f32;
    var phi_1095_: f32;
    var phi_1096_: f32;
    var phi_1097_: f32;
    var phi_1098_: bool;
    var phi_1099_: f32;
    var phi_1100_: f32;
    var phi_1101_: bool;
    var phi_1105_: f32;

    let _e46 = (*param_4);
    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_186_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_185_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_184_ = 1f;
            } else {
                phi_184_ = param_7;
            }
            let _e53 = phi_184_;
            phi_185_ = _e53;
        }
        let _e55 = phi_185_;
        phi_186_ = _e55;
    }
    let _e57 = phi_186_;
    let _e58 = (_e57 - 0.00000047683716f);
    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_205_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_204_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_203_ = 1f;
            } else {
                phi_203_ = param_5.x;
            }
            let _e66 = phi_203_;
            phi_204_ = _e66;
        }
        let _e68 = phi_204_;
        phi_205_ = _e68;
    }
    let _e70 = phi_205_;
    if ((bitcast<u32>(param_5.y) & 2147483647u) > 2139095040u) {
        phi_223_ = param_5.y;
    } else {
        if (param_5.y < 0f) {
            phi_222_ = 0f;
        } else {
            if (param_5.y > 1f) {
                phi_221_ = 1f;
            } else {
                phi_221_ = param_5.y;
            }
            let _e78 = phi_221_;
            phi_222_ = _e78;
        }
        let _e80 = phi_222_;
        phi_223_ = _e80;
    }
    let _e82 = phi_223_;
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_241_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_240_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_239_ = 1f;
            } else {
                phi_239_ = param_5.z;
            }
            let _e90 = phi_239_;
            phi_240_ = _e90;
        }
        let _e92 = phi_240_;
        phi_241_ = _e92;
    }
    let _e94 = phi_241_;
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_259_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_258_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_257_ = 1f;
            } else {
                phi_257_ = param_5.w;
            }
            let _e102 = phi_257_;
            phi_258_ = _e102;
        }
        let _e104 = phi_258_;
        phi_259_ = _e104;
    }
    let _e106 = phi_259_;
    let _e107 = (_e70 - _e58);
    let _e108 = (_e82 - _e58);
    let _e109 = (_e94 - _e58);
    let _e110 = (_e106 - _e58);
    let _e121 = ((((_e107 * param_6.x) + (_e108 * param_6.y)) + (_e109 * param_6.z)) + (_e110 * param_6.w));
    if ((bitcast<u32>(_e121) & 2147483647u) > 2139095040u) {
        phi_1099_ = _e121;
        phi_1100_ = f32();
        phi_1101_ = true;
    } else {
        if (_e107 >= 0f) {
            if (_e108 >= 0f) {
                if (_e109 >= 0f) {
                    phi_294_ = (_e110 >= 0f);
                    phi_295_ = false;
                } else {
                    phi_294_ = bool();
                    phi_295_ = true;
                }
                let _e130 = phi_294_;
                let _e132 = phi_295_;
                phi_296_ = _e130;
                phi_297_ = _e132;
            } else {
                phi_296_ = bool();
                phi_297_ = true;
            }
            let _e134 = phi_296_;
            let _e136 = phi_297_;
            phi_298_ = _e134;
            phi_299_ = _e136;
        } else {
            phi_298_ = bool();
            phi_299_ = true;
        }
        let _e138 = phi_298_;
        let _e140 = phi_299_;
        if _e140 {
            phi_303_ = false;
        } else {
            phi_303_ = _e138;
        }
        let _e142 = phi_303_;
        if _e142 {
            phi_1096_ = 1f;
            phi_1097_ = f32();
            phi_1098_ = true;
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
                    phi_616_ = _e107;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_615_ = 0f;
                    } else {
                        if (_e107 < 0f) {
                            phi_614_ = 0f;
                        } else {
                            phi_614_ = 1f;
                        }
                        let _e439 = phi_614_;
                        phi_615_ = _e439;
                    }
                    let _e441 = phi_615_;
                    phi_616_ = _e441;
                }
                let _e443 = phi_616_;
                if ((bitcast<u32>(_e108) & 2147483647u) > 2139095040u) {
                    phi_635_ = _e108;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_634_ = 0f;
                    } else {
                        if (_e108 < 0f) {
                            phi_633_ = 0f;
                        } else {
                            phi_633_ = 1f;
                        }
                        let _e452 = phi_633_;
                        phi_634_ = _e452;
                    }
                    let _e454 = phi_634_;
                    phi_635_ = _e454;
                }
                let _e456 = phi_635_;
                if ((bitcast<u32>(_e109) & 2147483647u) > 2139095040u) {
                    phi_654_ = _e109;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_653_ = 0f;
                    } else {
                        if (_e109 < 0f) {
                            phi_652_ = 0f;
                        } else {
                            phi_652_ = 1f;
                        }
                        let _e465 = phi_652_;
                        phi_653_ = _e465;
                    }
                    let _e467 = phi_653_;
                    phi_654_ = _e467;
                }
                let _e469 = phi_654_;
                if ((bitcast<u32>(_e110) & 2147483647u) > 2139095040u) {
                    phi_673_ = _e110;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_672_ = 0f;
                    } else {
                        if (_e110 < 0f) {
                            phi_671_ = 0f;
                        } else {
                            phi_671_ = 1f;
                        }
                        let _e478 = phi_671_;
                        phi_672_ = _e478;
                    }
                    let _e480 = phi_672_;
                    phi_673_ = _e480;
                }
                let _e482 = phi_673_;
                let _e490 = (((((_e443 * _e146) + (_e456 * _e148)) + (_e469 * _e150)) + (_e482 * _e152)) + _e143);
                if ((bitcast<u32>(_e490) & 2147483647u) > 2139095040u) {
                    phi_698_ = _e490;
                } else {
                    if (_e490 < 0f) {
                        phi_697_ = 0f;
                    } else {
                        if (_e490 > 1f) {
                            phi_696_ = 1f;
                        } else {
                            phi_696_ = _e490;
                        }
                        let _e497 = phi_696_;
                        phi_697_ = _e497;
                    }
                    let _e499 = phi_697_;
                    phi_698_ = _e499;
                }
                let _e501 = phi_698_;
                phi_1094_ = _e501;
                phi_1095_ = f32();
            } else {
                let _e503 = ((0.5f * -(((((((((_e207 * (_e107 + _e108)) + (_e211 * (_e107 + _e109))) + (_e235 * (_e107 + _e153))) + (_e247 * (_e107 + _e154))) + ((((_e208 * (_e108 + _e109)) + (_e212 * (_e108 + _e110))) + (_e236 * (_e108 + _e153))) + (_e248 * (_e108 + _e154)))) + ((((_e209 * (_e109 + _e110)) + (_e213 * (_e109 + _e107))) + (_e237 * (_e109 + _e153))) + (_e249 * (_e109 + _e154)))) + ((((_e210 * (_e110 + _e107)) + (_e214 * (_e110 + _e108))) + (_e238 * (_e110 + _e153))) + (_e250 * (_e110 + _e154)))) + (_e421 * (_e153 + _e154))))) / _e424);
                let _e504 = ((((((((_e207 + _e211) + _e235) + _e247) + (((_e208 + _e212) + _e236) + _e248)) + (((_e209 + _e213) + _e237) + _e249)) + (((_e210 + _e214) + _e238) + _e250)) + _e421) / _e424);
                let _e506 = ((_e503 * _e503) - _e504);
                if (_e506 > 0f) {
                    phi_709_ = sqrt(_e506);
                } else {
                    phi_709_ = 0f;
                }
                let _e510 = phi_709_;
                if (_e503 > 0f) {
                    let _e513 = (-(_e503) - _e510);
                    phi_726_ = lt_bvh_slab_Span(_e513, (_e504 / _e513));
                } else {
                    let _e516 = (_e510 - _e503);
                    if (_e516 > 0f) {
                        phi_724_ = (_e504 / _e516);
                    } else {
                        phi_724_ = 0f;
                    }
                    let _e520 = phi_724_;
                    phi_726_ = lt_bvh_slab_Span(_e520, _e516);
                }
                let _e523 = phi_726_;
                if (_e523.near >= 0f) {
                    phi_787_ = 1f;
                    phi_788_ = f32();
                    phi_789_ = true;
                } else {
                    let _e527 = (_e523.far <= 0f);
                    if _e527 {
                        phi_785_ = (_e418 / _e424);
                        phi_786_ = f32();
                    } else {
                        let _e538 = (((((_e146 * _e107) + (_e148 * _e108)) + (_e150 * _e109)) + (_e152 * _e110)) + (_e143 * (_e153 + _e154)));
                        let _e554 = (((((_e146 * (_e107 * _e107)) + (_e148 * (_e108 * _e108))) + (_e150 * (_e109 * _e109))) + (_e152 * (_e110 * _e110))) + (_e143 * ((_e153 * _e153) + (_e154 * _e154))));
                        if (-(_e523.near) <= _e523.far) {
                            phi_784_ = (1f - (((_e523.near * _e523.near) * ((_e523.far * _e554) - _e538)) / (_e523.far - _e523.near)));
                        } else {
                            phi_784_ = ((_e418 / _e424) + (((_e523.far * _e523.far) * (_e538 - (_e523.near * _e554))) / (_e523.far - _e523.near)));
                        }
                        let _e573 = phi_784_;
                        phi_785_ = f32();
                        phi_786_ = _e573;
                    }
                    let _e575 = phi_785_;
                    let _e577 = phi_786_;
                    phi_787_ = _e575;
                    phi_788_ = _e577;
                    phi_789_ = _e527;
                }
                let _e579 = phi_787_;
                let _e581 = phi_788_;
                let _e583 = phi_789_;
                if _e583 {
                    phi_793_ = _e579;
                } else {
                    phi_793_ = _e581;
                }
                let _e585 = phi_793_;
                if ((_e523.near * _e153) >= (1f - 0.00001f)) {
                    phi_803_ = true;
                } else {
                    phi_803_ = ((_e523.near * _e154) >= (1f - 0.00001f));
                }
                let _e593 = phi_803_;
                if _e593 {
                    if ((_e523.far * _e153) >= (1f - 0.00001f)) {
                        phi_816_ = true;
                    } else {
                        phi_816_ = ((_e523.far * _e154) >= (1f - 0.00001f));
                    }
                    let _e601 = phi_816_;
                    if _e601 {
                        phi_820_ = false;
                    } else {
                        phi_820_ = true;
                    }
                    let _e603 = phi_820_;
                    phi_821_ = _e603;
                } else {
                    phi_821_ = true;
                }
                let _e605 = phi_821_;
                if _e605 {
                    let _e607 = (-(_e153) < 0.0001f);
                    if _e607 {
                        phi_831_ = bool();
                    } else {
                        phi_831_ = (_e154 < 0.0001f);
                    }
                    let _e610 = phi_831_;
                    phi_832_ = _e610;
                    phi_833_ = _e607;
                } else {
                    phi_832_ = bool();
                    phi_833_ = true;
                }
                let _e612 = phi_832_;
                let _e614 = phi_833_;
                if _e614 {
                    phi_837_ = true;
                } else {
                    phi_837_ = _e612;
                }
                let _e616 = phi_837_;
                if !(_e616) {
                    let _e622 = ((_e146 * _e70) * _e156);
                    let _e623 = ((_e148 * _e82) * _e158);
                    let _e624 = ((_e150 * _e94) * _e160);
                    let _e625 = ((_e152 * _e106) * _e162);
                    let _e643 = ((((_e622 * (_e107 * _e107)) + (_e623 * (_e108 * _e108))) + (_e624 * (_e109 * _e109))) + (_e625 * (_e110 * _e110)));
                    if (_e643 < 0.0000000000000000000000000000000001f) {
                        if ((bitcast<u32>(_e107) & 2147483647u) > 2139095040u) {
                            phi_890_ = _e107;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_889_ = 0f;
                            } else {
                                if (_e107 < 0f) {
                                    phi_888_ = 0f;
                                } else {
                                    phi_888_ = 1f;
                                }
                                let _e653 = phi_888_;
                                phi_889_ = _e653;
                            }
                            let _e655 = phi_889_;
                            phi_890_ = _e655;
                        }
                        let _e657 = phi_890_;
                        if ((bitcast<u32>(_e108) & 2147483647u) > 2139095040u) {
                            phi_909_ = _e108;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_908_ = 0f;
                            } else {
                                if (_e108 < 0f) {
                                    phi_907_ = 0f;
                                } else {
                                    phi_907_ = 1f;
                                }
                                let _e666 = phi_907_;
                                phi_908_ = _e666;
                            }
                            let _e668 = phi_908_;
                            phi_909_ = _e668;
                        }
                        let _e670 = phi_909_;
                        if ((bitcast<u32>(_e109) & 2147483647u) > 2139095040u) {
                            phi_928_ = _e109;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_927_ = 0f;
                            } else {
                                if (_e109 < 0f) {
                                    phi_926_ = 0f;
                                } else {
                                    phi_926_ = 1f;
                                }
                                let _e679 = phi_926_;
                                phi_927_ = _e679;
                            }
                            let _e681 = phi_927_;
                            phi_928_ = _e681;
                        }
                        let _e683 = phi_928_;
                        if ((bitcast<u32>(_e110) & 2147483647u) > 2139095040u) {
                            phi_947_ = _e110;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_946_ = 0f;
                            } else {
                                if (_e110 < 0f) {
                                    phi_945_ = 0f;
                                } else {
                                    phi_945_ = 1f;
                                }
                                let _e692 = phi_945_;
                                phi_946_ = _e692;
                            }
                            let _e694 = phi_946_;
                            phi_947_ = _e694;
                        }
                        let _e696 = phi_947_;
                        let _e704 = (((((_e657 * _e146) + (_e670 * _e148)) + (_e683 * _e150)) + (_e696 * _e152)) + _e143);
                        if ((bitcast<u32>(_e704) & 2147483647u) > 2139095040u) {
                            phi_972_ = _e704;
                        } else {
                            if (_e704 < 0f) {
                                phi_971_ = 0f;
                            } else {
                                if (_e704 > 1f) {
                                    phi_970_ = 1f;
                                } else {
                                    phi_970_ = _e704;
                                }
                                let _e711 = phi_970_;
                                phi_971_ = _e711;
                            }
                            let _e713 = phi_971_;
                            phi_972_ = _e713;
                        }
                        let _e715 = phi_972_;
                        phi_1060_ = _e715;
                    } else {
                        let _e716 = (((((_e622 * _e107) + (_e623 * _e108)) + (_e624 * _e109)) + (_e625 * _e110)) / _e643);
                        let _e733 = ((_e146 * _e107) * (vec4<f32>(1f, 1f, 1f, 1f).x - (_e716 * _e107)));
                        let _e734 = ((_e148 * _e108) * (vec4<f32>(1f, 1f, 1f, 1f).y - (_e716 * _e108)));
                        let _e735 = ((_e150 * _e109) * (vec4<f32>(1f, 1f, 1f, 1f).z - (_e716 * _e109)));
                        let _e736 = ((_e152 * _e110) * (vec4<f32>(1f, 1f, 1f, 1f).w - (_e716 * _e110)));
                        if (_e716 > 0f) {
                            phi_1059_ = ((1f - _e143) - (((((_e733 * _e156) + (_e734 * _e158)) + (_e735 * _e160)) + (_e736 * _e162)) / (_e153 * (1f - (_e153 * _e716)))));
                        } else {
                            phi_1059_ = ((((((((_e622 * ((_e623 * _e167) + ((0.5f * _e624) * _e175))) * vec4<f32>(1f, 1f, 1f, 1f).x) + ((_e623 * ((_e624 * _e168) + ((0.5f * _e625) * _e176))) * vec4<f32>(1f, 1f, 1f, 1f).y)) + ((_e624 * ((_e625 * _e169) + ((0.5f * _e622) * _e177))) * vec4<f32>(1f, 1f, 1f, 1f).z)) + ((_e625 * ((_e622 * _e170) + ((0.5f * _e623) * _e178))) * vec4<f32>(1f, 1f, 1f, 1f).w)) / (_e643 * (-(_e153) * _e154))) + _e143) + (((((_e733 * _e70) + (_e734 * _e82)) + (_e735 * _e94)) + (_e736 * _e106)) / (_e154 * (1f - (_e716 * _e154)))));
                        }
                        let _e800 = phi_1059_;
                        phi_1060_ = _e800;
                    }
                    let _e802 = phi_1060_;
                    if ((bitcast<u32>(_e585) & 2147483647u) > 2139095040u) {
                        phi_1071_ = true;
                    } else {
                        let _e806 = (_e585 < _e802);
                        if _e806 {
                        }
                        phi_1071_ = _e806;
                    }
                    let _e808 = phi_1071_;
                    if _e808 {
                        phi_1075_ = _e585;
                    } else {
                        phi_1075_ = _e802;
                    }
                    let _e810 = phi_1075_;
                    phi_1076_ = _e810;
                } else {
                    phi_1076_ = _e585;
                }
                let _e812 = phi_1076_;
                if ((bitcast<u32>(_e812) & 2147483647u) > 2139095040u) {
                    phi_1093_ = _e812;
                } else {
                    if (_e812 < 0f) {
                        phi_1092_ = 0f;
                    } else {
                        if (_e812 > 1f) {
                            phi_1091_ = 1f;
                        } else {
                            phi_1091_ = _e812;
                        }
                        let _e819 = phi_1091_;
                        phi_1092_ = _e819;
                    }
                    let _e821 = phi_1092_;
                    phi_1093_ = _e821;
                }
                let _e823 = phi_1093_;
                phi_1094_ = f32();
                phi_1095_ = _e823;
            }
            let _e825 = phi_1094_;
            let _e827 = phi_1095_;
            phi_1096_ = _e825;
            phi_1097_ = _e827;
            phi_1098_ = _e430;
        }
        let _e829 = phi_1096_;
        let _e831 = phi_1097_;
        let _e833 = phi_1098_;
        phi_1099_ = _e829;
        phi_1100_ = _e831;
        phi_1101_ = _e833;
    }
    let _e835 = phi_1099_;
    let _e837 = phi_1100_;
    let _e839 = phi_1101_;
    if _e839 {
        phi_1105_ = _e835;
    } else {
        phi_1105_ = _e837;
    }
    let _e841 = phi_1105_;
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
    var phi_1286_: bool;
    var phi_1295_: bool;
    var phi_1304_: bool;
    var phi_1305_: bool;
    var phi_1306_: bool;
    var phi_1307_: bool;
    var phi_1308_: bool;
    var phi_1309_: bool;
    var phi_1310_: bool;
    var phi_1314_: bool;
    var phi_1404_: f32;
    var phi_1407_: f32;
    var phi_1436_: f32;
    var phi_1441_: f32;
    var phi_1442_: bool;
    var phi_1443_: f32;
    var phi_1444_: bool;
    var phi_1448_: f32;
    var phi_1468_: f32;
    var phi_1473_: f32;
    var phi_1474_: bool;
    var phi_1475_: f32;
    var phi_1476_: bool;
    var phi_1480_: f32;
    var phi_1528_: i32;
    var phi_1533_: i32;
    var phi_1538_: i32;
    var phi_1543_: i32;
    var phi_1552_: i32;
    var phi_1557_: i32;
    var phi_1562_: i32;
    var phi_1567_: i32;
    var phi_1618_: bool;
    var phi_1626_: bool;
    var phi_1638_: bool;
    var phi_1639_: bool;
    var phi_1643_: f32;
    var phi_1649_: f32;
    var phi_1651_: evaluate_Verdict;
    var phi_1656_: evaluate_Verdict;
    var phi_1657_: evaluate_Verdict;
    var phi_1661_: bool;
    var phi_1662_: u32;
    var phi_1673_: u32;

    let _e43 = id_1;
    let _e44 = local_2;
    let _e49 = arrayLength((&map.member));
    let _e54 = p.member.size[0u];
    let _e56 = p.member.size[1u];
    let _e57 = lt_shaders_entry_pixel_index(_e43, _e54, _e56);
    if (bitcast<i32>(_e57.root) != 0i) {
        let _e64 = p.member.projection;
        let _e65 = lt_math_OneLevel(_e64);
        let _e67 = p.member.light;
        let _e70 = samples.member[_e57.first_primitive].normal[0u];
        let _e72 = global[0u];
        if (_e70 == _e72) {
            let _e75 = samples.member[_e57.first_primitive].normal[1u];
            let _e77 = global[1u];
            if (_e75 == _e77) {
                let _e80 = samples.member[_e57.first_primitive].normal[2u];
                let _e82 = global[2u];
                phi_1157_ = (_e80 == _e82);
                phi_1158_ = false;
            } else {
                phi_1157_ = bool();
                phi_1158_ = true;
            }
            let _e85 = phi_1157_;
            let _e87 = phi_1158_;
            phi_1159_ = _e85;
            phi_1160_ = _e87;
        } else {
            phi_1159_ = bool();
            phi_1160_ = true;
        }
        let _e89 = phi_1159_;
        let _e91 = phi_1160_;
        if _e91 {
            phi_1164_ = false;
        } else {
            phi_1164_ = _e89;
        }
        let _e93 = phi_1164_;
        if !(_e93) {
            let _e96 = samples.member[_e57.first_primitive].normal;
            let _e98 = samples.member[_e57.first_primitive].position;
            if ((((_e96.x * (_e67.x - (_e98.x * _e67.w))) + (_e96.y * (_e67.y - (_e98.y * _e67.w)))) + (_e96.z * (_e67.z - (_e98.z * _e67.w)))) > 0f) {
                let _e122 = samples.member[_e57.first_primitive].flags;
                let _e130 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e136 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e130.unnamed.visibility, false), _e130.unnamed_1);
                phi_1208_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e136.unnamed, ((_e122 & 1u) == 0u));
            } else {
                let _e145 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e151 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e145.unnamed.visibility, false), _e145.unnamed_1);
                phi_1208_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e151.unnamed, true);
            }
            let _e156 = phi_1208_;
            phi_1212_ = _e156;
        } else {
            let _e162 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e168 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e162.unnamed.visibility, false), _e162.unnamed_1);
            phi_1212_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e168.unnamed, true);
        }
        let _e173 = phi_1212_;
        if _e173.unnamed_1 {
            phi_1657_ = evaluate_Verdict(_e173.unnamed.visibility, _e173.unnamed.is_doubted);
        } else {
            let _e181 = samples.member[_e57.first_primitive].position;
            let _e199 = ((((_e65.projection.row_w.x * _e181.x) + (_e65.projection.row_w.y * _e181.y)) + (_e65.projection.row_w.z * _e181.z)) + (_e65.projection.row_w.w * 1f));
            let _e213 = (((((_e65.projection.row_x.x * _e181.x) + (_e65.projection.row_x.y * _e181.y)) + (_e65.projection.row_x.z * _e181.z)) + (_e65.projection.row_x.w * 1f)) / _e199);
            let _e227 = (((((_e65.projection.row_y.x * _e181.x) + (_e65.projection.row_y.y * _e181.y)) + (_e65.projection.row_y.z * _e181.z)) + (_e65.projection.row_y.w * 1f)) / _e199);
            let _e240 = ((((_e65.projection.row_z.x * _e181.x) + (_e65.projection.row_z.y * _e181.y)) + (_e65.projection.row_z.z * _e181.z)) + (_e65.projection.row_z.w * 1f));
            if (_e199 > 0f) {
                if (_e213 >= 0f) {
                    phi_1286_ = (_e213 <= 1f);
                } else {
                    phi_1286_ = false;
                }
                let _e245 = phi_1286_;
                if _e245 {
                    if (_e227 >= 0f) {
                        phi_1295_ = (_e227 <= 1f);
                    } else {
                        phi_1295_ = false;
                    }
                    let _e249 = phi_1295_;
                    if _e249 {
                        if (_e240 >= 0f) {
                            phi_1304_ = (_e240 <= 1f);
                        } else {
                            phi_1304_ = false;
                        }
                        let _e253 = phi_1304_;
                        phi_1305_ = _e253;
                        phi_1306_ = false;
                    } else {
                        phi_1305_ = bool();
                        phi_1306_ = true;
                    }
                    let _e255 = phi_1305_;
                    let _e257 = phi_1306_;
                    phi_1307_ = _e255;
                    phi_1308_ = _e257;
                } else {
                    phi_1307_ = bool();
                    phi_1308_ = true;
                }
                let _e259 = phi_1307_;
                let _e261 = phi_1308_;
                phi_1309_ = _e259;
                phi_1310_ = _e261;
            } else {
                phi_1309_ = bool();
                phi_1310_ = true;
            }
            let _e263 = phi_1309_;
            let _e265 = phi_1310_;
            if _e265 {
                phi_1314_ = false;
            } else {
                phi_1314_ = _e263;
            }
            let _e267 = phi_1314_;
            if _e267 {
                if (0f > 0f) {
                    let _e270 = samples.member[_e57.first_primitive].normal;
                    let _e272 = p.member.map_size;
                    let _e342 = ((abs(((((_e64.row_x.x * _e270.x) + (_e64.row_x.y * _e270.y)) + (_e64.row_x.z * _e270.z)) / (((_e64.row_x.x * _e64.row_x.x) + (_e64.row_x.y * _e64.row_x.y)) + (_e64.row_x.z * _e64.row_x.z)))) + abs(((((_e64.row_y.x * _e270.x) + (_e64.row_y.y * _e270.y)) + (_e64.row_y.z * _e270.z)) / (((_e64.row_y.x * _e64.row_y.x) + (_e64.row_y.y * _e64.row_y.y)) + (_e64.row_y.z * _e64.row_y.z))))) / (abs(((((_e64.row_z.x * _e270.x) + (_e64.row_z.y * _e270.y)) + (_e64.row_z.z * _e270.z)) / (((_e64.row_z.x * _e64.row_z.x) + (_e64.row_z.y * _e64.row_z.y)) + (_e64.row_z.z * _e64.row_z.z)))) * f32(_e272)));
                    if (_e342 < 0.002f) {
                        phi_1404_ = _e342;
                    } else {
                        phi_1404_ = 0.002f;
                    }
                    let _e345 = phi_1404_;
                    phi_1407_ = (_e240 - (0f * _e345));
                } else {
                    phi_1407_ = _e240;
                }
                let _e349 = phi_1407_;
                let _e351 = p.member.map_size;
                let _e352 = f32(_e351);
                let _e355 = ((_e213 * _e352) - 0.5f);
                let _e356 = ((_e227 * _e352) - 0.5f);
                if (_e355 > -8388608f) {
                    let _e368 = f32(select(0i, select(select(i32(_e355), i32(-2147483648), (_e355 < bitcast<f32>(3472883712u))), 2147483647i, (_e355 > bitcast<f32>(1325400063u))), (_e355 == _e355)));
                    if (_e368 > _e355) {
                        phi_1436_ = 1f;
                    } else {
                        phi_1436_ = 0f;
                    }
                    let _e371 = phi_1436_;
                    if (_e355 < 8388608f) {
                        phi_1441_ = (_e368 - _e371);
                        phi_1442_ = false;
                    } else {
                        phi_1441_ = f32();
                        phi_1442_ = true;
                    }
                    let _e374 = phi_1441_;
                    let _e376 = phi_1442_;
                    phi_1443_ = _e374;
                    phi_1444_ = _e376;
                } else {
                    phi_1443_ = f32();
                    phi_1444_ = true;
                }
                let _e378 = phi_1443_;
                let _e380 = phi_1444_;
                if _e380 {
                    phi_1448_ = _e355;
                } else {
                    phi_1448_ = _e378;
                }
                let _e382 = phi_1448_;
                if (_e356 > -8388608f) {
                    let _e394 = f32(select(0i, select(select(i32(_e356), i32(-2147483648), (_e356 < bitcast<f32>(3472883712u))), 2147483647i, (_e356 > bitcast<f32>(1325400063u))), (_e356 == _e356)));
                    if (_e394 > _e356) {
                        phi_1468_ = 1f;
                    } else {
                        phi_1468_ = 0f;
                    }
                    let _e397 = phi_1468_;
                    if (_e356 < 8388608f) {
                        phi_1473_ = (_e394 - _e397);
                        phi_1474_ = false;
                    } else {
                        phi_1473_ = f32();
                        phi_1474_ = true;
                    }
                    let _e400 = phi_1473_;
                    let _e402 = phi_1474_;
                    phi_1475_ = _e400;
                    phi_1476_ = _e402;
                } else {
                    phi_1475_ = f32();
                    phi_1476_ = true;
                }
                let _e404 = phi_1475_;
                let _e406 = phi_1476_;
                if _e406 {
                    phi_1480_ = _e356;
                } else {
                    phi_1480_ = _e404;
                }
                let _e408 = phi_1480_;
                let _e409 = (_e355 - _e382);
                let _e410 = (_e356 - _e408);
                let _e419 = select(0i, select(select(i32(_e382), i32(-2147483648), (_e382 < bitcast<f32>(3472883712u))), 2147483647i, (_e382 > bitcast<f32>(1325400063u))), (_e382 == _e382));
                let _e428 = select(0i, select(select(i32(_e408), i32(-2147483648), (_e408 < bitcast<f32>(3472883712u))), 2147483647i, (_e408 > bitcast<f32>(1325400063u))), (_e408 == _e408));
                let _e439 = p.member.test;
                let _e440 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e439);
                let _e442 = p.member.map_size;
                local_1 = _e440;
                let _e444 = ((0u * _e442) * _e442);
                let _e446 = (bitcast<i32>(_e442) - 1i);
                if (_e419 > 0i) {
                    phi_1528_ = _e419;
                } else {
                    phi_1528_ = 0i;
                }
                let _e449 = phi_1528_;
                if (_e428 > 0i) {
                    phi_1533_ = _e428;
                } else {
                    phi_1533_ = 0i;
                }
                let _e452 = phi_1533_;
                if (_e449 < _e446) {
                    phi_1538_ = _e449;
                } else {
                    phi_1538_ = _e446;
                }
                let _e455 = phi_1538_;
                if (_e452 < _e446) {
                    phi_1543_ = _e452;
                } else {
                    phi_1543_ = _e446;
                }
                let _e458 = phi_1543_;
                let _e459 = bitcast<u32>(_e455);
                let _e461 = (_e419 + 1i);
                let _e462 = (_e428 + 1i);
                if (_e461 > 0i) {
                    phi_1552_ = _e461;
                } else {
                    phi_1552_ = 0i;
                }
                let _e465 = phi_1552_;
                if (_e462 > 0i) {
                    phi_1557_ = _e462;
                } else {
                    phi_1557_ = 0i;
                }
                let _e468 = phi_1557_;
                if (_e465 < _e446) {
                    phi_1562_ = _e465;
                } else {
                    phi_1562_ = _e446;
                }
                let _e471 = phi_1562_;
                if (_e468 < _e446) {
                    phi_1567_ = _e468;
                } else {
                    phi_1567_ = _e446;
                }
                let _e474 = phi_1567_;
                let _e475 = bitcast<u32>(_e471);
                let _e477 = (bitcast<u32>(_e458) * _e442);
                let _e478 = (bitcast<u32>(_e474) * _e442);
                let _e483 = ((_e477 + _e459) + _e444);
                let _e484 = ((_e477 + _e475) + _e444);
                let _e485 = ((_e478 + _e459) + _e444);
                let _e486 = ((_e478 + _e475) + _e444);
                if (_e483 < _e49) {
                } else {
                    return;
                }
                let _e490 = map.member[(0u + _e483)];
                if (_e484 < _e49) {
                } else {
                    return;
                }
                let _e494 = map.member[(0u + _e484)];
                if (_e485 < _e49) {
                } else {
                    return;
                }
                let _e498 = map.member[(0u + _e485)];
                if (_e486 < _e49) {
                } else {
                    return;
                }
                let _e502 = map.member[(0u + _e486)];
                let _e504 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local_1), vec4<f32>(_e490, _e494, _e498, _e502), vec4<f32>(((1f - _e409) * (1f - _e410)), (_e409 * (1f - _e410)), ((1f - _e409) * _e410), (_e409 * _e410)), _e349);
                let _e506 = p.member.epsilon;
                if (_e504 <= _e506) {
                    phi_1618_ = true;
                } else {
                    phi_1618_ = (_e504 >= (1f - _e506));
                }
                let _e511 = phi_1618_;
                if ((bitcast<u32>(_e504) & 2147483647u) > 2139095040u) {
                    phi_1626_ = true;
                } else {
                    phi_1626_ = !(_e511);
                }
                let _e517 = phi_1626_;
                if _e517 {
                    if (_e504 > 0f) {
                        if (_e504 < 1f) {
                            phi_1638_ = false;
                        } else {
                            phi_1638_ = true;
                        }
                        let _e521 = phi_1638_;
                        phi_1639_ = _e521;
                    } else {
                        phi_1639_ = true;
                    }
                    let _e523 = phi_1639_;
                    if _e523 {
                        phi_1643_ = 0.5f;
                    } else {
                        phi_1643_ = _e504;
                    }
                    let _e525 = phi_1643_;
                    phi_1651_ = evaluate_Verdict(_e525, true);
                } else {
                    if (_e504 > 0.5f) {
                        phi_1649_ = 1f;
                    } else {
                        phi_1649_ = 0f;
                    }
                    let _e529 = phi_1649_;
                    phi_1651_ = evaluate_Verdict(_e529, false);
                }
                let _e532 = phi_1651_;
                phi_1656_ = evaluate_Verdict(_e532.visibility, _e532.is_doubted);
            } else {
                phi_1656_ = evaluate_Verdict(0.5f, true);
            }
            let _e538 = phi_1656_;
            phi_1657_ = _e538;
        }
        let _e540 = phi_1657_;
        visibility.member[_e57.first_primitive] = _e540.visibility;
        phi_1661_ = _e540.is_doubted;
        phi_1662_ = _e57.first_primitive;
    } else {
        phi_1661_ = false;
        phi_1662_ = 0u;
    }
    let _e545 = phi_1661_;
    let _e547 = phi_1662_;
    if (_e44 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e545 {
        let _e551 = atomicAdd((&shared_[0u]), 1u);
        phi_1673_ = _e551;
    } else {
        phi_1673_ = 0u;
    }
    let _e553 = phi_1673_;
    workgroupBarrier();
    if (_e44 == 0u) {
        let _e557 = atomicLoad((&shared_[0u]));
        let _e558 = atomicAdd((&list.member[3u]), _e557);
        atomicStore((&shared_[1u]), _e558);
    }
    workgroupBarrier();
    if _e545 {
        let _e561 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e561) + _e553)]), _e547);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_msm_hausdorff_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
