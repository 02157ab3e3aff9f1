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
    pad0_: u32,
    pad1_: u32,
    pad2_: u32,
}

struct type_36 {
    member: abi_ShadowParams,
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
    var phi_708_: f32;
    var phi_723_: f32;
    var phi_725_: lt_bvh_slab_Span;
    var phi_783_: f32;
    var phi_784_: f32;
    var phi_785_: f32;
    var phi_786_: f32;
    var phi_787_: f32;
    var phi_788_: bool;
    var phi_792_: f32;
    var phi_802_: bool;
    var phi_815_: bool;
    var phi_819_: bool;
    var phi_820_: bool;
    var phi_830_: bool;
    var phi_831_: bool;
    var phi_832_: bool;
    var phi_836_: bool;
    var phi_887_: f32;
    var phi_888_: f32;
    var phi_889_: f32;
    var phi_906_: f32;
    var phi_907_: f32;
    var phi_908_: f32;
    var phi_925_: f32;
    var phi_926_: f32;
    var phi_927_: f32;
    var phi_944_: f32;
    var phi_945_: f32;
    var phi_946_: f32;
    var phi_969_: f32;
    var phi_970_: f32;
    var phi_971_: f32;
    var phi_1058_: f32;
    var phi_1059_: f32;
    var phi_1070_: bool;
    var phi_1074_: f32;
    var phi_1075_: f32;
    var phi_1090_: f32;
    var phi_1091_: f32;
    var phi_1092_: f32;
    var phi_1093_: f32;
    var phi_1094_: f32;
    var phi_1095_: f32;
    var phi_1096_: f32;
    var phi_1097_: bool;
    var phi_1098_: f32;
    var phi_1099_: f32;
    var phi_1100_: bool;
    var phi_1104_: f32;

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
        phi_1098_ = _e121;
        phi_1099_ = f32();
        phi_1100_ = true;
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
            phi_1095_ = 1f;
            phi_1096_ = f32();
            phi_1097_ = true;
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
                phi_1093_ = _e501;
                phi_1094_ = f32();
            } else {
                let _e503 = ((0.5f * -(((((((((_e207 * (_e107 + _e108)) + (_e211 * (_e107 + _e109))) + (_e235 * (_e107 + _e153))) + (_e247 * (_e107 + _e154))) + ((((_e208 * (_e108 + _e109)) + (_e212 * (_e108 + _e110))) + (_e236 * (_e108 + _e153))) + (_e248 * (_e108 + _e154)))) + ((((_e209 * (_e109 + _e110)) + (_e213 * (_e109 + _e107))) + (_e237 * (_e109 + _e153))) + (_e249 * (_e109 + _e154)))) + ((((_e210 * (_e110 + _e107)) + (_e214 * (_e110 + _e108))) + (_e238 * (_e110 + _e153))) + (_e250 * (_e110 + _e154)))) + (_e421 * (_e153 + _e154))))) / _e424);
                let _e504 = ((((((((_e207 + _e211) + _e235) + _e247) + (((_e208 + _e212) + _e236) + _e248)) + (((_e209 + _e213) + _e237) + _e249)) + (((_e210 + _e214) + _e238) + _e250)) + _e421) / _e424);
                let _e506 = ((_e503 * _e503) - _e504);
                if (_e506 > 0f) {
                    phi_708_ = sqrt(_e506);
                } else {
                    phi_708_ = 0f;
                }
                let _e510 = phi_708_;
                if (_e503 > 0f) {
                    let _e513 = (-(_e503) - _e510);
                    phi_725_ = lt_bvh_slab_Span(_e513, (_e504 / _e513));
                } else {
                    let _e516 = (_e510 - _e503);
                    if (_e516 > 0f) {
                        phi_723_ = (_e504 / _e516);
                    } else {
                        phi_723_ = 0f;
                    }
                    let _e520 = phi_723_;
                    phi_725_ = lt_bvh_slab_Span(_e520, _e516);
                }
                let _e523 = phi_725_;
                if (_e523.near >= 0f) {
                    phi_786_ = 1f;
                    phi_787_ = f32();
                    phi_788_ = true;
                } else {
                    let _e527 = (_e523.far <= 0f);
                    if _e527 {
                        phi_784_ = (_e418 / _e424);
                        phi_785_ = f32();
                    } else {
                        let _e538 = (((((_e146 * _e107) + (_e148 * _e108)) + (_e150 * _e109)) + (_e152 * _e110)) + (_e143 * (_e153 + _e154)));
                        let _e554 = (((((_e146 * (_e107 * _e107)) + (_e148 * (_e108 * _e108))) + (_e150 * (_e109 * _e109))) + (_e152 * (_e110 * _e110))) + (_e143 * ((_e153 * _e153) + (_e154 * _e154))));
                        if (-(_e523.near) <= _e523.far) {
                            phi_783_ = (1f - (((_e523.near * _e523.near) * ((_e523.far * _e554) - _e538)) / (_e523.far - _e523.near)));
                        } else {
                            phi_783_ = ((_e418 / _e424) + (((_e523.far * _e523.far) * (_e538 - (_e523.near * _e554))) / (_e523.far - _e523.near)));
                        }
                        let _e573 = phi_783_;
                        phi_784_ = f32();
                        phi_785_ = _e573;
                    }
                    let _e575 = phi_784_;
                    let _e577 = phi_785_;
                    phi_786_ = _e575;
                    phi_787_ = _e577;
                    phi_788_ = _e527;
                }
                let _e579 = phi_786_;
                let _e581 = phi_787_;
                let _e583 = phi_788_;
                if _e583 {
                    phi_792_ = _e579;
                } else {
                    phi_792_ = _e581;
                }
                let _e585 = phi_792_;
                if ((_e523.near * _e153) >= (1f - 0.00001f)) {
                    phi_802_ = true;
                } else {
                    phi_802_ = ((_e523.near * _e154) >= (1f - 0.00001f));
                }
                let _e593 = phi_802_;
                if _e593 {
                    if ((_e523.far * _e153) >= (1f - 0.00001f)) {
                        phi_815_ = true;
                    } else {
                        phi_815_ = ((_e523.far * _e154) >= (1f - 0.00001f));
                    }
                    let _e601 = phi_815_;
                    if _e601 {
                        phi_819_ = false;
                    } else {
                        phi_819_ = true;
                    }
                    let _e603 = phi_819_;
                    phi_820_ = _e603;
                } else {
                    phi_820_ = true;
                }
                let _e605 = phi_820_;
                if _e605 {
                    let _e607 = (-(_e153) < 0.0001f);
                    if _e607 {
                        phi_830_ = bool();
                    } else {
                        phi_830_ = (_e154 < 0.0001f);
                    }
                    let _e610 = phi_830_;
                    phi_831_ = _e610;
                    phi_832_ = _e607;
                } else {
                    phi_831_ = bool();
                    phi_832_ = true;
                }
                let _e612 = phi_831_;
                let _e614 = phi_832_;
                if _e614 {
                    phi_836_ = true;
                } else {
                    phi_836_ = _e612;
                }
                let _e616 = phi_836_;
                if !(_e616) {
                    let _e622 = ((_e146 * _e70) * _e156);
                    let _e623 = ((_e148 * _e82) * _e158);
                    let _e624 = ((_e150 * _e94) * _e160);
                    let _e625 = ((_e152 * _e106) * _e162);
                    let _e643 = ((((_e622 * (_e107 * _e107)) + (_e623 * (_e108 * _e108))) + (_e624 * (_e109 * _e109))) + (_e625 * (_e110 * _e110)));
                    if (_e643 < 0.0000000000000000000000000000000001f) {
                        if ((bitcast<u32>(_e107) & 2147483647u) > 2139095040u) {
                            phi_889_ = _e107;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_888_ = 0f;
                            } else {
                                if (_e107 < 0f) {
                                    phi_887_ = 0f;
                                } else {
                                    phi_887_ = 1f;
                                }
                                let _e653 = phi_887_;
                                phi_888_ = _e653;
                            }
                            let _e655 = phi_888_;
                            phi_889_ = _e655;
                        }
                        let _e657 = phi_889_;
                        if ((bitcast<u32>(_e108) & 2147483647u) > 2139095040u) {
                            phi_908_ = _e108;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_907_ = 0f;
                            } else {
                                if (_e108 < 0f) {
                                    phi_906_ = 0f;
                                } else {
                                    phi_906_ = 1f;
                                }
                                let _e666 = phi_906_;
                                phi_907_ = _e666;
                            }
                            let _e668 = phi_907_;
                            phi_908_ = _e668;
                        }
                        let _e670 = phi_908_;
                        if ((bitcast<u32>(_e109) & 2147483647u) > 2139095040u) {
                            phi_927_ = _e109;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_926_ = 0f;
                            } else {
                                if (_e109 < 0f) {
                                    phi_925_ = 0f;
                                } else {
                                    phi_925_ = 1f;
                                }
                                let _e679 = phi_925_;
                                phi_926_ = _e679;
                            }
                            let _e681 = phi_926_;
                            phi_927_ = _e681;
                        }
                        let _e683 = phi_927_;
                        if ((bitcast<u32>(_e110) & 2147483647u) > 2139095040u) {
                            phi_946_ = _e110;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_945_ = 0f;
                            } else {
                                if (_e110 < 0f) {
                                    phi_944_ = 0f;
                                } else {
                                    phi_944_ = 1f;
                                }
                                let _e692 = phi_944_;
                                phi_945_ = _e692;
                            }
                            let _e694 = phi_945_;
                            phi_946_ = _e694;
                        }
                        let _e696 = phi_946_;
                        let _e704 = (((((_e657 * _e146) + (_e670 * _e148)) + (_e683 * _e150)) + (_e696 * _e152)) + _e143);
                        if ((bitcast<u32>(_e704) & 2147483647u) > 2139095040u) {
                            phi_971_ = _e704;
                        } else {
                            if (_e704 < 0f) {
                                phi_970_ = 0f;
                            } else {
                                if (_e704 > 1f) {
                                    phi_969_ = 1f;
                                } else {
                                    phi_969_ = _e704;
                                }
                                let _e711 = phi_969_;
                                phi_970_ = _e711;
                            }
                            let _e713 = phi_970_;
                            phi_971_ = _e713;
                        }
                        let _e715 = phi_971_;
                        phi_1059_ = _e715;
                    } else {
                        let _e716 = (((((_e622 * _e107) + (_e623 * _e108)) + (_e624 * _e109)) + (_e625 * _e110)) / _e643);
                        let _e733 = ((_e146 * _e107) * (vec4<f32>(1f, 1f, 1f, 1f).x - (_e716 * _e107)));
                        let _e734 = ((_e148 * _e108) * (vec4<f32>(1f, 1f, 1f, 1f).y - (_e716 * _e108)));
                        let _e735 = ((_e150 * _e109) * (vec4<f32>(1f, 1f, 1f, 1f).z - (_e716 * _e109)));
                        let _e736 = ((_e152 * _e110) * (vec4<f32>(1f, 1f, 1f, 1f).w - (_e716 * _e110)));
                        if (_e716 > 0f) {
                            phi_1058_ = ((1f - _e143) - (((((_e733 * _e156) + (_e734 * _e158)) + (_e735 * _e160)) + (_e736 * _e162)) / (_e153 * (1f - (_e153 * _e716)))));
                        } else {
                            phi_1058_ = ((((((((_e622 * ((_e623 * _e167) + ((0.5f * _e624) * _e175))) * vec4<f32>(1f, 1f, 1f, 1f).x) + ((_e623 * ((_e624 * _e168) + ((0.5f * _e625) * _e176))) * vec4<f32>(1f, 1f, 1f, 1f).y)) + ((_e624 * ((_e625 * _e169) + ((0.5f * _e622) * _e177))) * vec4<f32>(1f, 1f, 1f, 1f).z)) + ((_e625 * ((_e622 * _e170) + ((0.5f * _e623) * _e178))) * vec4<f32>(1f, 1f, 1f, 1f).w)) / (_e643 * (-(_e153) * _e154))) + _e143) + (((((_e733 * _e70) + (_e734 * _e82)) + (_e735 * _e94)) + (_e736 * _e106)) / (_e154 * (1f - (_e716 * _e154)))));
                        }
                        let _e800 = phi_1058_;
                        phi_1059_ = _e800;
                    }
                    let _e802 = phi_1059_;
                    if ((bitcast<u32>(_e585) & 2147483647u) > 2139095040u) {
                        phi_1070_ = true;
                    } else {
                        let _e806 = (_e585 < _e802);
                        if _e806 {
                        }
                        phi_1070_ = _e806;
                    }
                    let _e808 = phi_1070_;
                    if _e808 {
                        phi_1074_ = _e585;
                    } else {
                        phi_1074_ = _e802;
                    }
                    let _e810 = phi_1074_;
                    phi_1075_ = _e810;
                } else {
                    phi_1075_ = _e585;
                }
                let _e812 = phi_1075_;
                if ((bitcast<u32>(_e812) & 2147483647u) > 2139095040u) {
                    phi_1092_ = _e812;
                } else {
                    if (_e812 < 0f) {
                        phi_1091_ = 0f;
                    } else {
                        if (_e812 > 1f) {
                            phi_1090_ = 1f;
                        } else {
                            phi_1090_ = _e812;
                        }
                        let _e819 = phi_1090_;
                        phi_1091_ = _e819;
                    }
                    let _e821 = phi_1091_;
                    phi_1092_ = _e821;
                }
                let _e823 = phi_1092_;
                phi_1093_ = f32();
                phi_1094_ = _e823;
            }
            let _e825 = phi_1093_;
            let _e827 = phi_1094_;
            phi_1095_ = _e825;
            phi_1096_ = _e827;
            phi_1097_ = _e430;
        }
        let _e829 = phi_1095_;
        let _e831 = phi_1096_;
        let _e833 = phi_1097_;
        phi_1098_ = _e829;
        phi_1099_ = _e831;
        phi_1100_ = _e833;
    }
    let _e835 = phi_1098_;
    let _e837 = phi_1099_;
    let _e839 = phi_1100_;
    if _e839 {
        phi_1104_ = _e835;
    } else {
        phi_1104_ = _e837;
    }
    let _e841 = phi_1104_;
    return _e841;
}

fn function_() {
    var local_1: f32;
    var phi_1153_: bool;
    var phi_1154_: bool;
    var phi_1155_: bool;
    var phi_1156_: bool;
    var phi_1160_: bool;
    var phi_1204_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1208_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1285_: bool;
    var phi_1294_: bool;
    var phi_1303_: bool;
    var phi_1304_: bool;
    var phi_1305_: bool;
    var phi_1306_: bool;
    var phi_1307_: bool;
    var phi_1308_: bool;
    var phi_1309_: bool;
    var phi_1313_: bool;
    var phi_1407_: f32;
    var phi_1410_: f32;
    var phi_1439_: f32;
    var phi_1444_: f32;
    var phi_1445_: bool;
    var phi_1446_: f32;
    var phi_1447_: bool;
    var phi_1451_: f32;
    var phi_1471_: f32;
    var phi_1476_: f32;
    var phi_1477_: bool;
    var phi_1478_: f32;
    var phi_1479_: bool;
    var phi_1483_: f32;
    var phi_1529_: i32;
    var phi_1534_: i32;
    var phi_1539_: i32;
    var phi_1544_: i32;
    var phi_1553_: i32;
    var phi_1558_: i32;
    var phi_1563_: i32;
    var phi_1568_: i32;
    var phi_1615_: bool;
    var phi_1623_: bool;
    var phi_1635_: bool;
    var phi_1636_: bool;
    var phi_1640_: f32;
    var phi_1646_: f32;
    var phi_1648_: evaluate_Verdict;
    var phi_1653_: evaluate_Verdict;
    var phi_1654_: evaluate_Verdict;
    var phi_1658_: bool;
    var phi_1659_: u32;
    var phi_1670_: u32;

    let _e43 = id_1;
    let _e44 = local_2;
    let _e49 = arrayLength((&map.member));
    let _e54 = p.member.size[0u];
    let _e56 = p.member.size[1u];
    let _e57 = lt_shaders_entry_pixel_index(_e43, _e54, _e56);
    if (bitcast<i32>(_e57.root) != 0i) {
        let _e64 = p.member.light;
        let _e67 = samples.member[_e57.first_primitive].normal[0u];
        let _e69 = global[0u];
        if (_e67 == _e69) {
            let _e72 = samples.member[_e57.first_primitive].normal[1u];
            let _e74 = global[1u];
            if (_e72 == _e74) {
                let _e77 = samples.member[_e57.first_primitive].normal[2u];
                let _e79 = global[2u];
                phi_1153_ = (_e77 == _e79);
                phi_1154_ = false;
            } else {
                phi_1153_ = bool();
                phi_1154_ = true;
            }
            let _e82 = phi_1153_;
            let _e84 = phi_1154_;
            phi_1155_ = _e82;
            phi_1156_ = _e84;
        } else {
            phi_1155_ = bool();
            phi_1156_ = true;
        }
        let _e86 = phi_1155_;
        let _e88 = phi_1156_;
        if _e88 {
            phi_1160_ = false;
        } else {
            phi_1160_ = _e86;
        }
        let _e90 = phi_1160_;
        if !(_e90) {
            let _e93 = samples.member[_e57.first_primitive].normal;
            let _e95 = samples.member[_e57.first_primitive].position;
            if ((((_e93.x * (_e64.x - (_e95.x * _e64.w))) + (_e93.y * (_e64.y - (_e95.y * _e64.w)))) + (_e93.z * (_e64.z - (_e95.z * _e64.w)))) > 0f) {
                let _e119 = samples.member[_e57.first_primitive].flags;
                let _e127 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e133 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e127.unnamed.visibility, false), _e127.unnamed_1);
                phi_1204_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e133.unnamed, ((_e119 & 1u) == 0u));
            } else {
                let _e142 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e148 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e142.unnamed.visibility, false), _e142.unnamed_1);
                phi_1204_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e148.unnamed, true);
            }
            let _e153 = phi_1204_;
            phi_1208_ = _e153;
        } else {
            let _e159 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e165 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e159.unnamed.visibility, false), _e159.unnamed_1);
            phi_1208_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e165.unnamed, true);
        }
        let _e170 = phi_1208_;
        if _e170.unnamed_1 {
            phi_1654_ = evaluate_Verdict(_e170.unnamed.visibility, _e170.unnamed.is_doubted);
        } else {
            let _e178 = samples.member[_e57.first_primitive].position;
            let _e184 = p.member.projection.row_w;
            let _e195 = ((((_e184.x * _e178.x) + (_e184.y * _e178.y)) + (_e184.z * _e178.z)) + (_e184.w * 1f));
            let _e197 = p.member.projection.row_x;
            let _e209 = (((((_e197.x * _e178.x) + (_e197.y * _e178.y)) + (_e197.z * _e178.z)) + (_e197.w * 1f)) / _e195);
            let _e211 = p.member.projection.row_y;
            let _e223 = (((((_e211.x * _e178.x) + (_e211.y * _e178.y)) + (_e211.z * _e178.z)) + (_e211.w * 1f)) / _e195);
            let _e225 = p.member.projection.row_z;
            let _e236 = ((((_e225.x * _e178.x) + (_e225.y * _e178.y)) + (_e225.z * _e178.z)) + (_e225.w * 1f));
            if (_e195 > 0f) {
                if (_e209 >= 0f) {
                    phi_1285_ = (_e209 <= 1f);
                } else {
                    phi_1285_ = false;
                }
                let _e241 = phi_1285_;
                if _e241 {
                    if (_e223 >= 0f) {
                        phi_1294_ = (_e223 <= 1f);
                    } else {
                        phi_1294_ = false;
                    }
                    let _e245 = phi_1294_;
                    if _e245 {
                        if (_e236 >= 0f) {
                            phi_1303_ = (_e236 <= 1f);
                        } else {
                            phi_1303_ = false;
                        }
                        let _e249 = phi_1303_;
                        phi_1304_ = _e249;
                        phi_1305_ = false;
                    } else {
                        phi_1304_ = bool();
                        phi_1305_ = true;
                    }
                    let _e251 = phi_1304_;
                    let _e253 = phi_1305_;
                    phi_1306_ = _e251;
                    phi_1307_ = _e253;
                } else {
                    phi_1306_ = bool();
                    phi_1307_ = true;
                }
                let _e255 = phi_1306_;
                let _e257 = phi_1307_;
                phi_1308_ = _e255;
                phi_1309_ = _e257;
            } else {
                phi_1308_ = bool();
                phi_1309_ = true;
            }
            let _e259 = phi_1308_;
            let _e261 = phi_1309_;
            if _e261 {
                phi_1313_ = false;
            } else {
                phi_1313_ = _e259;
            }
            let _e263 = phi_1313_;
            if _e263 {
                if (0f > 0f) {
                    let _e266 = samples.member[_e57.first_primitive].normal;
                    let _e268 = p.member.map_size;
                    let _e271 = p.member.projection.row_x;
                    let _e293 = p.member.projection.row_y;
                    let _e315 = p.member.projection.row_z;
                    let _e342 = ((abs(((((_e271.x * _e266.x) + (_e271.y * _e266.y)) + (_e271.z * _e266.z)) / (((_e271.x * _e271.x) + (_e271.y * _e271.y)) + (_e271.z * _e271.z)))) + abs(((((_e293.x * _e266.x) + (_e293.y * _e266.y)) + (_e293.z * _e266.z)) / (((_e293.x * _e293.x) + (_e293.y * _e293.y)) + (_e293.z * _e293.z))))) / (abs(((((_e315.x * _e266.x) + (_e315.y * _e266.y)) + (_e315.z * _e266.z)) / (((_e315.x * _e315.x) + (_e315.y * _e315.y)) + (_e315.z * _e315.z)))) * f32(_e268)));
                    if (_e342 < 0.002f) {
                        phi_1407_ = _e342;
                    } else {
                        phi_1407_ = 0.002f;
                    }
                    let _e345 = phi_1407_;
                    phi_1410_ = (_e236 - (0f * _e345));
                } else {
                    phi_1410_ = _e236;
                }
                let _e349 = phi_1410_;
                let _e351 = p.member.map_size;
                let _e352 = f32(_e351);
                let _e355 = ((_e209 * _e352) - 0.5f);
                let _e356 = ((_e223 * _e352) - 0.5f);
                if (_e355 > -8388608f) {
                    let _e368 = f32(select(0i, select(select(i32(_e355), i32(-2147483648), (_e355 < bitcast<f32>(3472883712u))), 2147483647i, (_e355 > bitcast<f32>(1325400063u))), (_e355 == _e355)));
                    if (_e368 > _e355) {
                        phi_1439_ = 1f;
                    } else {
                        phi_1439_ = 0f;
                    }
                    let _e371 = phi_1439_;
                    if (_e355 < 8388608f) {
                        phi_1444_ = (_e368 - _e371);
                        phi_1445_ = false;
                    } else {
                        phi_1444_ = f32();
                        phi_1445_ = true;
                    }
                    let _e374 = phi_1444_;
                    let _e376 = phi_1445_;
                    phi_1446_ = _e374;
                    phi_1447_ = _e376;
                } else {
                    phi_1446_ = f32();
                    phi_1447_ = true;
                }
                let _e378 = phi_1446_;
                let _e380 = phi_1447_;
                if _e380 {
                    phi_1451_ = _e355;
                } else {
                    phi_1451_ = _e378;
                }
                let _e382 = phi_1451_;
                if (_e356 > -8388608f) {
                    let _e394 = f32(select(0i, select(select(i32(_e356), i32(-2147483648), (_e356 < bitcast<f32>(3472883712u))), 2147483647i, (_e356 > bitcast<f32>(1325400063u))), (_e356 == _e356)));
                    if (_e394 > _e356) {
                        phi_1471_ = 1f;
                    } else {
                        phi_1471_ = 0f;
                    }
                    let _e397 = phi_1471_;
                    if (_e356 < 8388608f) {
                        phi_1476_ = (_e394 - _e397);
                        phi_1477_ = false;
                    } else {
                        phi_1476_ = f32();
                        phi_1477_ = true;
                    }
                    let _e400 = phi_1476_;
                    let _e402 = phi_1477_;
                    phi_1478_ = _e400;
                    phi_1479_ = _e402;
                } else {
                    phi_1478_ = f32();
                    phi_1479_ = true;
                }
                let _e404 = phi_1478_;
                let _e406 = phi_1479_;
                if _e406 {
                    phi_1483_ = _e356;
                } else {
                    phi_1483_ = _e404;
                }
                let _e408 = phi_1483_;
                let _e409 = (_e355 - _e382);
                let _e410 = (_e356 - _e408);
                let _e419 = select(0i, select(select(i32(_e382), i32(-2147483648), (_e382 < bitcast<f32>(3472883712u))), 2147483647i, (_e382 > bitcast<f32>(1325400063u))), (_e382 == _e382));
                let _e428 = select(0i, select(select(i32(_e408), i32(-2147483648), (_e408 < bitcast<f32>(3472883712u))), 2147483647i, (_e408 > bitcast<f32>(1325400063u))), (_e408 == _e408));
                let _e439 = p.member.test;
                let _e440 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e439);
                let _e442 = p.member.map_size;
                local_1 = _e440;
                let _e444 = (bitcast<i32>(_e442) - 1i);
                if (_e419 > 0i) {
                    phi_1529_ = _e419;
                } else {
                    phi_1529_ = 0i;
                }
                let _e447 = phi_1529_;
                if (_e428 > 0i) {
                    phi_1534_ = _e428;
                } else {
                    phi_1534_ = 0i;
                }
                let _e450 = phi_1534_;
                if (_e447 < _e444) {
                    phi_1539_ = _e447;
                } else {
                    phi_1539_ = _e444;
                }
                let _e453 = phi_1539_;
                if (_e450 < _e444) {
                    phi_1544_ = _e450;
                } else {
                    phi_1544_ = _e444;
                }
                let _e456 = phi_1544_;
                let _e457 = bitcast<u32>(_e453);
                let _e459 = (_e419 + 1i);
                let _e460 = (_e428 + 1i);
                if (_e459 > 0i) {
                    phi_1553_ = _e459;
                } else {
                    phi_1553_ = 0i;
                }
                let _e463 = phi_1553_;
                if (_e460 > 0i) {
                    phi_1558_ = _e460;
                } else {
                    phi_1558_ = 0i;
                }
                let _e466 = phi_1558_;
                if (_e463 < _e444) {
                    phi_1563_ = _e463;
                } else {
                    phi_1563_ = _e444;
                }
                let _e469 = phi_1563_;
                if (_e466 < _e444) {
                    phi_1568_ = _e466;
                } else {
                    phi_1568_ = _e444;
                }
                let _e472 = phi_1568_;
                let _e473 = bitcast<u32>(_e469);
                let _e475 = (bitcast<u32>(_e456) * _e442);
                let _e476 = (bitcast<u32>(_e472) * _e442);
                let _e477 = (_e475 + _e457);
                let _e478 = (_e475 + _e473);
                let _e479 = (_e476 + _e457);
                let _e480 = (_e476 + _e473);
                if (_e477 < _e49) {
                } else {
                    return;
                }
                let _e484 = map.member[(0u + _e477)];
                if (_e478 < _e49) {
                } else {
                    return;
                }
                let _e488 = map.member[(0u + _e478)];
                if (_e479 < _e49) {
                } else {
                    return;
                }
                let _e492 = map.member[(0u + _e479)];
                if (_e480 < _e49) {
                } else {
                    return;
                }
                let _e496 = map.member[(0u + _e480)];
                let _e498 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local_1), vec4<f32>(_e484, _e488, _e492, _e496), vec4<f32>(((1f - _e409) * (1f - _e410)), (_e409 * (1f - _e410)), ((1f - _e409) * _e410), (_e409 * _e410)), _e349);
                let _e500 = p.member.epsilon;
                if (_e498 <= _e500) {
                    phi_1615_ = true;
                } else {
                    phi_1615_ = (_e498 >= (1f - _e500));
                }
                let _e505 = phi_1615_;
                if ((bitcast<u32>(_e498) & 2147483647u) > 2139095040u) {
                    phi_1623_ = true;
                } else {
                    phi_1623_ = !(_e505);
                }
                let _e511 = phi_1623_;
                if _e511 {
                    if (_e498 > 0f) {
                        if (_e498 < 1f) {
                            phi_1635_ = false;
                        } else {
                            phi_1635_ = true;
                        }
                        let _e515 = phi_1635_;
                        phi_1636_ = _e515;
                    } else {
                        phi_1636_ = true;
                    }
                    let _e517 = phi_1636_;
                    if _e517 {
                        phi_1640_ = 0.5f;
                    } else {
                        phi_1640_ = _e498;
                    }
                    let _e519 = phi_1640_;
                    phi_1648_ = evaluate_Verdict(_e519, true);
                } else {
                    if (_e498 > 0.5f) {
                        phi_1646_ = 1f;
                    } else {
                        phi_1646_ = 0f;
                    }
                    let _e523 = phi_1646_;
                    phi_1648_ = evaluate_Verdict(_e523, false);
                }
                let _e526 = phi_1648_;
                phi_1653_ = evaluate_Verdict(_e526.visibility, _e526.is_doubted);
            } else {
                phi_1653_ = evaluate_Verdict(0.5f, true);
            }
            let _e532 = phi_1653_;
            phi_1654_ = _e532;
        }
        let _e534 = phi_1654_;
        visibility.member[_e57.first_primitive] = _e534.visibility;
        phi_1658_ = _e534.is_doubted;
        phi_1659_ = _e57.first_primitive;
    } else {
        phi_1658_ = false;
        phi_1659_ = 0u;
    }
    let _e539 = phi_1658_;
    let _e541 = phi_1659_;
    if (_e44 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e539 {
        let _e545 = atomicAdd((&shared_[0u]), 1u);
        phi_1670_ = _e545;
    } else {
        phi_1670_ = 0u;
    }
    let _e547 = phi_1670_;
    workgroupBarrier();
    if (_e44 == 0u) {
        let _e551 = atomicLoad((&shared_[0u]));
        let _e552 = atomicAdd((&list.member[3u]), _e551);
        atomicStore((&shared_[1u]), _e552);
    }
    workgroupBarrier();
    if _e539 {
        let _e555 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e555) + _e547)]), _e541);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_msm_hausdorff_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
