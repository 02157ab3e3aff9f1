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
        let _e57 = phi_149_;
        let _e59 = phi_150_;
        phi_151_ = _e57;
        phi_152_ = _e59;
    } else {
        phi_151_ = lt_bvh_traverse_Tree();
        phi_152_ = true;
    }
    let _e61 = phi_151_;
    let _e63 = phi_152_;
    if _e63 {
        phi_157_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_157_ = _e61;
    }
    let _e68 = phi_157_;
    return lt_bvh_traverse_Tree(_e68.root, _e68.first_primitive);
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

    let _e48 = (*param_4);
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
            let _e55 = phi_184_;
            phi_185_ = _e55;
        }
        let _e57 = phi_185_;
        phi_186_ = _e57;
    }
    let _e59 = phi_186_;
    let _e60 = (_e59 - 0.00000047683716f);
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
            let _e68 = phi_203_;
            phi_204_ = _e68;
        }
        let _e70 = phi_204_;
        phi_205_ = _e70;
    }
    let _e72 = phi_205_;
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
            let _e80 = phi_221_;
            phi_222_ = _e80;
        }
        let _e82 = phi_222_;
        phi_223_ = _e82;
    }
    let _e84 = phi_223_;
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
            let _e92 = phi_239_;
            phi_240_ = _e92;
        }
        let _e94 = phi_240_;
        phi_241_ = _e94;
    }
    let _e96 = phi_241_;
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
            let _e104 = phi_257_;
            phi_258_ = _e104;
        }
        let _e106 = phi_258_;
        phi_259_ = _e106;
    }
    let _e108 = phi_259_;
    let _e109 = (_e72 - _e60);
    let _e110 = (_e84 - _e60);
    let _e111 = (_e96 - _e60);
    let _e112 = (_e108 - _e60);
    let _e123 = ((((_e109 * param_6.x) + (_e110 * param_6.y)) + (_e111 * param_6.z)) + (_e112 * param_6.w));
    if ((bitcast<u32>(_e123) & 2147483647u) > 2139095040u) {
        phi_1099_ = _e123;
        phi_1100_ = f32();
        phi_1101_ = true;
    } else {
        if (_e109 >= 0f) {
            if (_e110 >= 0f) {
                if (_e111 >= 0f) {
                    phi_294_ = (_e112 >= 0f);
                    phi_295_ = false;
                } else {
                    phi_294_ = bool();
                    phi_295_ = true;
                }
                let _e132 = phi_294_;
                let _e134 = phi_295_;
                phi_296_ = _e132;
                phi_297_ = _e134;
            } else {
                phi_296_ = bool();
                phi_297_ = true;
            }
            let _e136 = phi_296_;
            let _e138 = phi_297_;
            phi_298_ = _e136;
            phi_299_ = _e138;
        } else {
            phi_298_ = bool();
            phi_299_ = true;
        }
        let _e140 = phi_298_;
        let _e142 = phi_299_;
        if _e142 {
            phi_303_ = false;
        } else {
            phi_303_ = _e140;
        }
        let _e144 = phi_303_;
        if _e144 {
            phi_1096_ = 1f;
            phi_1097_ = f32();
            phi_1098_ = true;
        } else {
            let _e145 = (0.5f * _e48);
            let _e146 = (1f - _e48);
            let _e148 = (param_6.x * _e146);
            let _e150 = (param_6.y * _e146);
            let _e152 = (param_6.z * _e146);
            let _e154 = (param_6.w * _e146);
            let _e155 = -(_e60);
            let _e156 = (1f - _e60);
            let _e158 = (vec4<f32>(1f, 1f, 1f, 1f).x - _e72);
            let _e160 = (vec4<f32>(1f, 1f, 1f, 1f).y - _e84);
            let _e162 = (vec4<f32>(1f, 1f, 1f, 1f).z - _e96);
            let _e164 = (vec4<f32>(1f, 1f, 1f, 1f).w - _e108);
            let _e165 = (_e109 - _e110);
            let _e166 = (_e110 - _e111);
            let _e167 = (_e111 - _e112);
            let _e168 = (_e112 - _e109);
            let _e169 = (_e165 * _e165);
            let _e170 = (_e166 * _e166);
            let _e171 = (_e167 * _e167);
            let _e172 = (_e168 * _e168);
            let _e173 = (_e109 - _e111);
            let _e174 = (_e110 - _e112);
            let _e175 = (_e111 - _e109);
            let _e176 = (_e112 - _e110);
            let _e177 = (_e173 * _e173);
            let _e178 = (_e174 * _e174);
            let _e179 = (_e175 * _e175);
            let _e180 = (_e176 * _e176);
            let _e185 = ((_e148 * _e150) * _e169);
            let _e186 = ((_e150 * _e152) * _e170);
            let _e187 = ((_e152 * _e154) * _e171);
            let _e188 = ((_e154 * _e148) * _e172);
            let _e197 = (((0.5f * _e148) * _e152) * _e177);
            let _e198 = (((0.5f * _e150) * _e154) * _e178);
            let _e199 = (((0.5f * _e152) * _e148) * _e179);
            let _e200 = (((0.5f * _e154) * _e150) * _e180);
            let _e201 = (_e109 * _e110);
            let _e202 = (_e110 * _e111);
            let _e203 = (_e111 * _e112);
            let _e204 = (_e112 * _e109);
            let _e205 = (_e109 * _e111);
            let _e206 = (_e110 * _e112);
            let _e207 = (_e111 * _e109);
            let _e208 = (_e112 * _e110);
            let _e209 = (_e185 * _e201);
            let _e210 = (_e186 * _e202);
            let _e211 = (_e187 * _e203);
            let _e212 = (_e188 * _e204);
            let _e213 = (_e197 * _e205);
            let _e214 = (_e198 * _e206);
            let _e215 = (_e199 * _e207);
            let _e216 = (_e200 * _e208);
            let _e217 = (_e72 * _e72);
            let _e218 = (_e84 * _e84);
            let _e219 = (_e96 * _e96);
            let _e220 = (_e108 * _e108);
            let _e221 = (_e158 * _e158);
            let _e222 = (_e160 * _e160);
            let _e223 = (_e162 * _e162);
            let _e224 = (_e164 * _e164);
            let _e225 = (_e145 * _e148);
            let _e226 = (_e145 * _e150);
            let _e227 = (_e145 * _e152);
            let _e228 = (_e145 * _e154);
            let _e237 = (((_e225 * _e109) * _e217) * _e155);
            let _e238 = (((_e226 * _e110) * _e218) * _e155);
            let _e239 = (((_e227 * _e111) * _e219) * _e155);
            let _e240 = (((_e228 * _e112) * _e220) * _e155);
            let _e249 = (((_e225 * _e109) * _e221) * _e156);
            let _e250 = (((_e226 * _e110) * _e222) * _e156);
            let _e251 = (((_e227 * _e111) * _e223) * _e156);
            let _e252 = (((_e228 * _e112) * _e224) * _e156);
            let _e420 = (((((((_e185 * _e152) * _e170) * _e177) + (_e145 * (((_e185 * ((_e217 * _e218) + (_e221 * _e222))) + (_e197 * ((_e217 * _e219) + (_e221 * _e223)))) + ((_e225 * _e217) * _e221)))) + ((((_e186 * _e154) * _e171) * _e178) + (_e145 * (((_e186 * ((_e218 * _e219) + (_e222 * _e223))) + (_e198 * ((_e218 * _e220) + (_e222 * _e224)))) + ((_e226 * _e218) * _e222))))) + ((((_e187 * _e148) * _e172) * _e179) + (_e145 * (((_e187 * ((_e219 * _e220) + (_e223 * _e224))) + (_e199 * ((_e219 * _e217) + (_e223 * _e221)))) + ((_e227 * _e219) * _e223))))) + ((((_e188 * _e150) * _e169) * _e180) + (_e145 * (((_e188 * ((_e220 * _e217) + (_e224 * _e221))) + (_e200 * ((_e220 * _e218) + (_e224 * _e222)))) + ((_e228 * _e220) * _e224)))));
            let _e423 = (((_e145 * _e145) * _e155) * _e156);
            let _e426 = (((((((_e209 * _e201) + (_e213 * _e205)) + (_e109 * ((_e237 * _e155) + (_e249 * _e156)))) + (((_e210 * _e202) + (_e214 * _e206)) + (_e110 * ((_e238 * _e155) + (_e250 * _e156))))) + (((_e211 * _e203) + (_e215 * _e207)) + (_e111 * ((_e239 * _e155) + (_e251 * _e156))))) + (((_e212 * _e204) + (_e216 * _e208)) + (_e112 * ((_e240 * _e155) + (_e252 * _e156))))) + ((_e423 * _e155) * _e156));
            let _e432 = (_e426 < 0.0000000000000000000000000000000001f);
            if _e432 {
                if ((bitcast<u32>(_e109) & 2147483647u) > 2139095040u) {
                    phi_616_ = _e109;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_615_ = 0f;
                    } else {
                        if (_e109 < 0f) {
                            phi_614_ = 0f;
                        } else {
                            phi_614_ = 1f;
                        }
                        let _e441 = phi_614_;
                        phi_615_ = _e441;
                    }
                    let _e443 = phi_615_;
                    phi_616_ = _e443;
                }
                let _e445 = phi_616_;
                if ((bitcast<u32>(_e110) & 2147483647u) > 2139095040u) {
                    phi_635_ = _e110;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_634_ = 0f;
                    } else {
                        if (_e110 < 0f) {
                            phi_633_ = 0f;
                        } else {
                            phi_633_ = 1f;
                        }
                        let _e454 = phi_633_;
                        phi_634_ = _e454;
                    }
                    let _e456 = phi_634_;
                    phi_635_ = _e456;
                }
                let _e458 = phi_635_;
                if ((bitcast<u32>(_e111) & 2147483647u) > 2139095040u) {
                    phi_654_ = _e111;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_653_ = 0f;
                    } else {
                        if (_e111 < 0f) {
                            phi_652_ = 0f;
                        } else {
                            phi_652_ = 1f;
                        }
                        let _e467 = phi_652_;
                        phi_653_ = _e467;
                    }
                    let _e469 = phi_653_;
                    phi_654_ = _e469;
                }
                let _e471 = phi_654_;
                if ((bitcast<u32>(_e112) & 2147483647u) > 2139095040u) {
                    phi_673_ = _e112;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_672_ = 0f;
                    } else {
                        if (_e112 < 0f) {
                            phi_671_ = 0f;
                        } else {
                            phi_671_ = 1f;
                        }
                        let _e480 = phi_671_;
                        phi_672_ = _e480;
                    }
                    let _e482 = phi_672_;
                    phi_673_ = _e482;
                }
                let _e484 = phi_673_;
                let _e492 = (((((_e445 * _e148) + (_e458 * _e150)) + (_e471 * _e152)) + (_e484 * _e154)) + _e145);
                if ((bitcast<u32>(_e492) & 2147483647u) > 2139095040u) {
                    phi_698_ = _e492;
                } else {
                    if (_e492 < 0f) {
                        phi_697_ = 0f;
                    } else {
                        if (_e492 > 1f) {
                            phi_696_ = 1f;
                        } else {
                            phi_696_ = _e492;
                        }
                        let _e499 = phi_696_;
                        phi_697_ = _e499;
                    }
                    let _e501 = phi_697_;
                    phi_698_ = _e501;
                }
                let _e503 = phi_698_;
                phi_1094_ = _e503;
                phi_1095_ = f32();
            } else {
                let _e505 = ((0.5f * -(((((((((_e209 * (_e109 + _e110)) + (_e213 * (_e109 + _e111))) + (_e237 * (_e109 + _e155))) + (_e249 * (_e109 + _e156))) + ((((_e210 * (_e110 + _e111)) + (_e214 * (_e110 + _e112))) + (_e238 * (_e110 + _e155))) + (_e250 * (_e110 + _e156)))) + ((((_e211 * (_e111 + _e112)) + (_e215 * (_e111 + _e109))) + (_e239 * (_e111 + _e155))) + (_e251 * (_e111 + _e156)))) + ((((_e212 * (_e112 + _e109)) + (_e216 * (_e112 + _e110))) + (_e240 * (_e112 + _e155))) + (_e252 * (_e112 + _e156)))) + (_e423 * (_e155 + _e156))))) / _e426);
                let _e506 = ((((((((_e209 + _e213) + _e237) + _e249) + (((_e210 + _e214) + _e238) + _e250)) + (((_e211 + _e215) + _e239) + _e251)) + (((_e212 + _e216) + _e240) + _e252)) + _e423) / _e426);
                let _e508 = ((_e505 * _e505) - _e506);
                if (_e508 > 0f) {
                    phi_709_ = sqrt(_e508);
                } else {
                    phi_709_ = 0f;
                }
                let _e512 = phi_709_;
                if (_e505 > 0f) {
                    let _e515 = (-(_e505) - _e512);
                    phi_726_ = lt_bvh_slab_Span(_e515, (_e506 / _e515));
                } else {
                    let _e518 = (_e512 - _e505);
                    if (_e518 > 0f) {
                        phi_724_ = (_e506 / _e518);
                    } else {
                        phi_724_ = 0f;
                    }
                    let _e522 = phi_724_;
                    phi_726_ = lt_bvh_slab_Span(_e522, _e518);
                }
                let _e525 = phi_726_;
                if (_e525.near >= 0f) {
                    phi_787_ = 1f;
                    phi_788_ = f32();
                    phi_789_ = true;
                } else {
                    let _e529 = (_e525.far <= 0f);
                    if _e529 {
                        phi_785_ = (_e420 / _e426);
                        phi_786_ = f32();
                    } else {
                        let _e540 = (((((_e148 * _e109) + (_e150 * _e110)) + (_e152 * _e111)) + (_e154 * _e112)) + (_e145 * (_e155 + _e156)));
                        let _e556 = (((((_e148 * (_e109 * _e109)) + (_e150 * (_e110 * _e110))) + (_e152 * (_e111 * _e111))) + (_e154 * (_e112 * _e112))) + (_e145 * ((_e155 * _e155) + (_e156 * _e156))));
                        if (-(_e525.near) <= _e525.far) {
                            phi_784_ = (1f - (((_e525.near * _e525.near) * ((_e525.far * _e556) - _e540)) / (_e525.far - _e525.near)));
                        } else {
                            phi_784_ = ((_e420 / _e426) + (((_e525.far * _e525.far) * (_e540 - (_e525.near * _e556))) / (_e525.far - _e525.near)));
                        }
                        let _e575 = phi_784_;
                        phi_785_ = f32();
                        phi_786_ = _e575;
                    }
                    let _e577 = phi_785_;
                    let _e579 = phi_786_;
                    phi_787_ = _e577;
                    phi_788_ = _e579;
                    phi_789_ = _e529;
                }
                let _e581 = phi_787_;
                let _e583 = phi_788_;
                let _e585 = phi_789_;
                if _e585 {
                    phi_793_ = _e581;
                } else {
                    phi_793_ = _e583;
                }
                let _e587 = phi_793_;
                if ((_e525.near * _e155) >= (1f - 0.00001f)) {
                    phi_803_ = true;
                } else {
                    phi_803_ = ((_e525.near * _e156) >= (1f - 0.00001f));
                }
                let _e595 = phi_803_;
                if _e595 {
                    if ((_e525.far * _e155) >= (1f - 0.00001f)) {
                        phi_816_ = true;
                    } else {
                        phi_816_ = ((_e525.far * _e156) >= (1f - 0.00001f));
                    }
                    let _e603 = phi_816_;
                    if _e603 {
                        phi_820_ = false;
                    } else {
                        phi_820_ = true;
                    }
                    let _e605 = phi_820_;
                    phi_821_ = _e605;
                } else {
                    phi_821_ = true;
                }
                let _e607 = phi_821_;
                if _e607 {
                    let _e609 = (-(_e155) < 0.0001f);
                    if _e609 {
                        phi_831_ = bool();
                    } else {
                        phi_831_ = (_e156 < 0.0001f);
                    }
                    let _e612 = phi_831_;
                    phi_832_ = _e612;
                    phi_833_ = _e609;
                } else {
                    phi_832_ = bool();
                    phi_833_ = true;
                }
                let _e614 = phi_832_;
                let _e616 = phi_833_;
                if _e616 {
                    phi_837_ = true;
                } else {
                    phi_837_ = _e614;
                }
                let _e618 = phi_837_;
                if !(_e618) {
                    let _e624 = ((_e148 * _e72) * _e158);
                    let _e625 = ((_e150 * _e84) * _e160);
                    let _e626 = ((_e152 * _e96) * _e162);
                    let _e627 = ((_e154 * _e108) * _e164);
                    let _e645 = ((((_e624 * (_e109 * _e109)) + (_e625 * (_e110 * _e110))) + (_e626 * (_e111 * _e111))) + (_e627 * (_e112 * _e112)));
                    if (_e645 < 0.0000000000000000000000000000000001f) {
                        if ((bitcast<u32>(_e109) & 2147483647u) > 2139095040u) {
                            phi_890_ = _e109;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_889_ = 0f;
                            } else {
                                if (_e109 < 0f) {
                                    phi_888_ = 0f;
                                } else {
                                    phi_888_ = 1f;
                                }
                                let _e655 = phi_888_;
                                phi_889_ = _e655;
                            }
                            let _e657 = phi_889_;
                            phi_890_ = _e657;
                        }
                        let _e659 = phi_890_;
                        if ((bitcast<u32>(_e110) & 2147483647u) > 2139095040u) {
                            phi_909_ = _e110;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_908_ = 0f;
                            } else {
                                if (_e110 < 0f) {
                                    phi_907_ = 0f;
                                } else {
                                    phi_907_ = 1f;
                                }
                                let _e668 = phi_907_;
                                phi_908_ = _e668;
                            }
                            let _e670 = phi_908_;
                            phi_909_ = _e670;
                        }
                        let _e672 = phi_909_;
                        if ((bitcast<u32>(_e111) & 2147483647u) > 2139095040u) {
                            phi_928_ = _e111;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_927_ = 0f;
                            } else {
                                if (_e111 < 0f) {
                                    phi_926_ = 0f;
                                } else {
                                    phi_926_ = 1f;
                                }
                                let _e681 = phi_926_;
                                phi_927_ = _e681;
                            }
                            let _e683 = phi_927_;
                            phi_928_ = _e683;
                        }
                        let _e685 = phi_928_;
                        if ((bitcast<u32>(_e112) & 2147483647u) > 2139095040u) {
                            phi_947_ = _e112;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_946_ = 0f;
                            } else {
                                if (_e112 < 0f) {
                                    phi_945_ = 0f;
                                } else {
                                    phi_945_ = 1f;
                                }
                                let _e694 = phi_945_;
                                phi_946_ = _e694;
                            }
                            let _e696 = phi_946_;
                            phi_947_ = _e696;
                        }
                        let _e698 = phi_947_;
                        let _e706 = (((((_e659 * _e148) + (_e672 * _e150)) + (_e685 * _e152)) + (_e698 * _e154)) + _e145);
                        if ((bitcast<u32>(_e706) & 2147483647u) > 2139095040u) {
                            phi_972_ = _e706;
                        } else {
                            if (_e706 < 0f) {
                                phi_971_ = 0f;
                            } else {
                                if (_e706 > 1f) {
                                    phi_970_ = 1f;
                                } else {
                                    phi_970_ = _e706;
                                }
                                let _e713 = phi_970_;
                                phi_971_ = _e713;
                            }
                            let _e715 = phi_971_;
                            phi_972_ = _e715;
                        }
                        let _e717 = phi_972_;
                        phi_1060_ = _e717;
                    } else {
                        let _e718 = (((((_e624 * _e109) + (_e625 * _e110)) + (_e626 * _e111)) + (_e627 * _e112)) / _e645);
                        let _e735 = ((_e148 * _e109) * (vec4<f32>(1f, 1f, 1f, 1f).x - (_e718 * _e109)));
                        let _e736 = ((_e150 * _e110) * (vec4<f32>(1f, 1f, 1f, 1f).y - (_e718 * _e110)));
                        let _e737 = ((_e152 * _e111) * (vec4<f32>(1f, 1f, 1f, 1f).z - (_e718 * _e111)));
                        let _e738 = ((_e154 * _e112) * (vec4<f32>(1f, 1f, 1f, 1f).w - (_e718 * _e112)));
                        if (_e718 > 0f) {
                            phi_1059_ = ((1f - _e145) - (((((_e735 * _e158) + (_e736 * _e160)) + (_e737 * _e162)) + (_e738 * _e164)) / (_e155 * (1f - (_e155 * _e718)))));
                        } else {
                            phi_1059_ = ((((((((_e624 * ((_e625 * _e169) + ((0.5f * _e626) * _e177))) * vec4<f32>(1f, 1f, 1f, 1f).x) + ((_e625 * ((_e626 * _e170) + ((0.5f * _e627) * _e178))) * vec4<f32>(1f, 1f, 1f, 1f).y)) + ((_e626 * ((_e627 * _e171) + ((0.5f * _e624) * _e179))) * vec4<f32>(1f, 1f, 1f, 1f).z)) + ((_e627 * ((_e624 * _e172) + ((0.5f * _e625) * _e180))) * vec4<f32>(1f, 1f, 1f, 1f).w)) / (_e645 * (-(_e155) * _e156))) + _e145) + (((((_e735 * _e72) + (_e736 * _e84)) + (_e737 * _e96)) + (_e738 * _e108)) / (_e156 * (1f - (_e718 * _e156)))));
                        }
                        let _e802 = phi_1059_;
                        phi_1060_ = _e802;
                    }
                    let _e804 = phi_1060_;
                    if ((bitcast<u32>(_e587) & 2147483647u) > 2139095040u) {
                        phi_1071_ = true;
                    } else {
                        let _e808 = (_e587 < _e804);
                        if _e808 {
                        }
                        phi_1071_ = _e808;
                    }
                    let _e810 = phi_1071_;
                    if _e810 {
                        phi_1075_ = _e587;
                    } else {
                        phi_1075_ = _e804;
                    }
                    let _e812 = phi_1075_;
                    phi_1076_ = _e812;
                } else {
                    phi_1076_ = _e587;
                }
                let _e814 = phi_1076_;
                if ((bitcast<u32>(_e814) & 2147483647u) > 2139095040u) {
                    phi_1093_ = _e814;
                } else {
                    if (_e814 < 0f) {
                        phi_1092_ = 0f;
                    } else {
                        if (_e814 > 1f) {
                            phi_1091_ = 1f;
                        } else {
                            phi_1091_ = _e814;
                        }
                        let _e821 = phi_1091_;
                        phi_1092_ = _e821;
                    }
                    let _e823 = phi_1092_;
                    phi_1093_ = _e823;
                }
                let _e825 = phi_1093_;
                phi_1094_ = f32();
                phi_1095_ = _e825;
            }
            let _e827 = phi_1094_;
            let _e829 = phi_1095_;
            phi_1096_ = _e827;
            phi_1097_ = _e829;
            phi_1098_ = _e432;
        }
        let _e831 = phi_1096_;
        let _e833 = phi_1097_;
        let _e835 = phi_1098_;
        phi_1099_ = _e831;
        phi_1100_ = _e833;
        phi_1101_ = _e835;
    }
    let _e837 = phi_1099_;
    let _e839 = phi_1100_;
    let _e841 = phi_1101_;
    if _e841 {
        phi_1105_ = _e837;
    } else {
        phi_1105_ = _e839;
    }
    let _e843 = phi_1105_;
    return _e843;
}

fn function_() {
    var local: f32;
    var phi_1165_: bool;
    var phi_1166_: bool;
    var phi_1167_: bool;
    var phi_1168_: bool;
    var phi_1172_: bool;
    var phi_1242_: bool;
    var phi_1243_: bool;
    var phi_1254_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1255_: bool;
    var phi_1256_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1257_: bool;
    var phi_1264_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1268_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1288_: lt_math_LightPoint;
    var phi_1291_: u32;
    var phi_1293_: lt_math_LevelPoint;
    var phi_1379_: bool;
    var phi_1388_: bool;
    var phi_1397_: bool;
    var phi_1398_: bool;
    var phi_1399_: bool;
    var phi_1400_: bool;
    var phi_1401_: bool;
    var phi_1402_: bool;
    var phi_1403_: bool;
    var phi_1407_: bool;
    var phi_1434_: bool;
    var phi_1435_: bool;
    var phi_1436_: bool;
    var phi_1437_: bool;
    var phi_1438_: bool;
    var phi_1439_: bool;
    var phi_1440_: bool;
    var phi_1441_: bool;
    var phi_1445_: bool;
    var phi_1454_: lt_math_LightPoint;
    var phi_1455_: u32;
    var phi_1456_: lt_math_LevelPoint;
    var phi_1457_: bool;
    var phi_1289_: lt_math_LightPoint;
    var phi_1292_: u32;
    var phi_1294_: lt_math_LevelPoint;
    var phi_1458_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_1498_: bool;
    var phi_1499_: bool;
    var phi_1500_: bool;
    var phi_1501_: bool;
    var phi_1505_: bool;
    var phi_1587_: f32;
    var phi_1705_: f32;
    var phi_1706_: f32;
    var phi_1709_: f32;
    var phi_1738_: f32;
    var phi_1743_: f32;
    var phi_1744_: bool;
    var phi_1745_: f32;
    var phi_1746_: bool;
    var phi_1750_: f32;
    var phi_1770_: f32;
    var phi_1775_: f32;
    var phi_1776_: bool;
    var phi_1777_: f32;
    var phi_1778_: bool;
    var phi_1782_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_1831_: i32;
    var phi_1836_: i32;
    var phi_1841_: i32;
    var phi_1846_: i32;
    var phi_1855_: i32;
    var phi_1860_: i32;
    var phi_1865_: i32;
    var phi_1870_: i32;
    var phi_1915_: evaluate_Verdict;
    var phi_1916_: evaluate_Verdict;
    var phi_1917_: bool;
    var phi_1918_: evaluate_Verdict;
    var phi_1919_: evaluate_Verdict;
    var phi_1920_: bool;
    var phi_1924_: evaluate_Verdict;

    let _e45 = id_1;
    let _e52 = arrayLength((&map.member));
    let _e58 = arrayLength((&levels.member));
    let _e61 = p.member.size[0u];
    let _e63 = p.member.size[1u];
    let _e64 = lt_shaders_entry_pixel_index(_e45, _e61, _e63);
    if (bitcast<i32>(_e64.root) != 0i) {
        let _e70 = p.member.level_count;
        if (_e64.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e77 = samples.member[(0u + _e64.first_primitive)].normal[0u];
        let _e79 = global[0u];
        if (_e77 == _e79) {
            let _e82 = samples.member[(0u + _e64.first_primitive)].normal[1u];
            let _e84 = global[1u];
            if (_e82 == _e84) {
                let _e87 = samples.member[(0u + _e64.first_primitive)].normal[2u];
                let _e89 = global[2u];
                phi_1165_ = (_e87 == _e89);
                phi_1166_ = false;
            } else {
                phi_1165_ = bool();
                phi_1166_ = true;
            }
            let _e92 = phi_1165_;
            let _e94 = phi_1166_;
            phi_1167_ = _e92;
            phi_1168_ = _e94;
        } else {
            phi_1167_ = bool();
            phi_1168_ = true;
        }
        let _e96 = phi_1167_;
        let _e98 = phi_1168_;
        if _e98 {
            phi_1172_ = false;
        } else {
            phi_1172_ = _e96;
        }
        let _e100 = phi_1172_;
        if !(_e100) {
            let _e103 = samples.member[(0u + _e64.first_primitive)].position;
            let _e105 = p.member.light.place;
            let _e111 = p.member.light.place[3u];
            let _e118 = (_e105.x - (_e103.x * _e111));
            let _e119 = (_e105.y - (_e103.y * _e111));
            let _e120 = (_e105.z - (_e103.z * _e111));
            let _e122 = samples.member[(0u + _e64.first_primitive)].normal;
            if ((((_e122.x * _e118) + (_e122.y * _e119)) + (_e122.z * _e120)) > 0f) {
                let _e136 = (((_e118 * _e118) + (_e119 * _e119)) + (_e120 * _e120));
                let _e138 = p.member.light.axis;
                let _e150 = p.member.light.place[3u];
                if (_e150 == 0f) {
                    phi_1243_ = true;
                } else {
                    let _e153 = p.member.light.range_squared;
                    if (_e136 <= _e153) {
                        let _e156 = p.member.light.cos_outer;
                        phi_1242_ = (-((((_e118 * _e138.x) + (_e119 * _e138.y)) + (_e120 * _e138.z))) >= (_e156 * sqrt(_e136)));
                    } else {
                        phi_1242_ = false;
                    }
                    let _e161 = phi_1242_;
                    phi_1243_ = _e161;
                }
                let _e163 = phi_1243_;
                if _e163 {
                    let _e165 = samples.member[(0u + _e64.first_primitive)].flags;
                    let _e173 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e179 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e173.unnamed.visibility, false), _e173.unnamed_1);
                    phi_1254_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e179.unnamed, ((_e165 & 1u) == 0u));
                    phi_1255_ = false;
                } else {
                    phi_1254_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_1255_ = true;
                }
                let _e184 = phi_1254_;
                let _e186 = phi_1255_;
                phi_1256_ = _e184;
                phi_1257_ = _e186;
            } else {
                phi_1256_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_1257_ = true;
            }
            let _e188 = phi_1256_;
            let _e190 = phi_1257_;
            if _e190 {
                let _e196 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e202 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e196.unnamed.visibility, false), _e196.unnamed_1);
                phi_1264_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e202.unnamed, true);
            } else {
                phi_1264_ = _e188;
            }
            let _e207 = phi_1264_;
            phi_1268_ = _e207;
        } else {
            let _e213 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e219 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e213.unnamed.visibility, false), _e213.unnamed_1);
            phi_1268_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e219.unnamed, true);
        }
        let _e224 = phi_1268_;
        if _e224.unnamed_1 {
            phi_1918_ = evaluate_Verdict(_e224.unnamed.visibility, _e224.unnamed.is_doubted);
            phi_1919_ = evaluate_Verdict();
            phi_1920_ = true;
        } else {
            let _e232 = samples.member[(0u + _e64.first_primitive)].position;
            let _e234 = p.member.map_size;
            let _e236 = (0.5f / f32(_e234));
            let _e243 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e250 = lt_math_LightPoint(vec2<f32>(_e243.uv.x, 0f), _e243.depth, _e243.is_inside);
            let _e254 = lt_math_LightPoint(_e250.uv, 0f, _e250.is_inside);
            phi_1288_ = lt_math_LightPoint();
            phi_1291_ = 0u;
            phi_1293_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e254.uv, _e254.depth, false));
            loop {
                let _e261 = phi_1288_;
                let _e263 = phi_1291_;
                let _e265 = phi_1293_;
                local_1 = _e265;
                local_2 = _e265;
                local_3 = _e265;
                if (_e263 < _e70) {
                    if _e265.point.is_inside {
                        phi_1454_ = lt_math_LightPoint();
                        phi_1455_ = u32();
                        phi_1456_ = lt_math_LevelPoint();
                        phi_1457_ = false;
                    } else {
                        if (_e263 < _e58) {
                        } else {
                            return;
                        }
                        let _e276 = levels.member[(0u + _e263)].row_w;
                        let _e287 = ((((_e276.x * _e232.x) + (_e276.y * _e232.y)) + (_e276.z * _e232.z)) + (_e276.w * 1f));
                        let _e289 = levels.member[(0u + _e263)].row_x;
                        let _e301 = (((((_e289.x * _e232.x) + (_e289.y * _e232.y)) + (_e289.z * _e232.z)) + (_e289.w * 1f)) / _e287);
                        let _e303 = levels.member[(0u + _e263)].row_y;
                        let _e315 = (((((_e303.x * _e232.x) + (_e303.y * _e232.y)) + (_e303.z * _e232.z)) + (_e303.w * 1f)) / _e287);
                        let _e317 = levels.member[(0u + _e263)].row_z;
                        let _e328 = ((((_e317.x * _e232.x) + (_e317.y * _e232.y)) + (_e317.z * _e232.z)) + (_e317.w * 1f));
                        if (_e287 > 0f) {
                            if (_e301 >= 0f) {
                                phi_1379_ = (_e301 <= 1f);
                            } else {
                                phi_1379_ = false;
                            }
                            let _e333 = phi_1379_;
                            if _e333 {
                                if (_e315 >= 0f) {
                                    phi_1388_ = (_e315 <= 1f);
                                } else {
                                    phi_1388_ = false;
                                }
                                let _e337 = phi_1388_;
                                if _e337 {
                                    if (_e328 >= 0f) {
                                        phi_1397_ = (_e328 <= 1f);
                                    } else {
                                        phi_1397_ = false;
                                    }
                                    let _e341 = phi_1397_;
                                    phi_1398_ = _e341;
                                    phi_1399_ = false;
                                } else {
                                    phi_1398_ = bool();
                                    phi_1399_ = true;
                                }
                                let _e343 = phi_1398_;
                                let _e345 = phi_1399_;
                                phi_1400_ = _e343;
                                phi_1401_ = _e345;
                            } else {
                                phi_1400_ = bool();
                                phi_1401_ = true;
                            }
                            let _e347 = phi_1400_;
                            let _e349 = phi_1401_;
                            phi_1402_ = _e347;
                            phi_1403_ = _e349;
                        } else {
                            phi_1402_ = bool();
                            phi_1403_ = true;
                        }
                        let _e351 = phi_1402_;
                        let _e353 = phi_1403_;
                        if _e353 {
                            phi_1407_ = false;
                        } else {
                            phi_1407_ = _e351;
                        }
                        let _e355 = phi_1407_;
                        if _e355 {
                            if (_e301 >= _e236) {
                                if (_e301 <= (1f - _e236)) {
                                    if (_e315 >= _e236) {
                                        phi_1434_ = (_e315 <= (1f - _e236));
                                        phi_1435_ = false;
                                    } else {
                                        phi_1434_ = bool();
                                        phi_1435_ = true;
                                    }
                                    let _e363 = phi_1434_;
                                    let _e365 = phi_1435_;
                                    phi_1436_ = _e363;
                                    phi_1437_ = _e365;
                                } else {
                                    phi_1436_ = bool();
                                    phi_1437_ = true;
                                }
                                let _e367 = phi_1436_;
                                let _e369 = phi_1437_;
                                phi_1438_ = _e367;
                                phi_1439_ = _e369;
                            } else {
                                phi_1438_ = bool();
                                phi_1439_ = true;
                            }
                            let _e371 = phi_1438_;
                            let _e373 = phi_1439_;
                            phi_1440_ = _e371;
                            phi_1441_ = _e373;
                        } else {
                            phi_1440_ = bool();
                            phi_1441_ = true;
                        }
                        let _e375 = phi_1440_;
                        let _e377 = phi_1441_;
                        if _e377 {
                            phi_1445_ = false;
                        } else {
                            phi_1445_ = _e375;
                        }
                        let _e379 = phi_1445_;
                        let _e386 = lt_math_LightPoint(vec2<f32>(_e301, _e261.uv.y), _e261.depth, _e261.is_inside);
                        let _e393 = lt_math_LightPoint(vec2<f32>(_e386.uv.x, _e315), _e386.depth, _e386.is_inside);
                        let _e397 = lt_math_LightPoint(_e393.uv, _e328, _e393.is_inside);
                        let _e401 = lt_math_LightPoint(_e397.uv, _e397.depth, _e379);
                        phi_1454_ = _e401;
                        phi_1455_ = (_e263 + 1u);
                        phi_1456_ = lt_math_LevelPoint(_e263, _e401);
                        phi_1457_ = true;
                    }
                    let _e405 = phi_1454_;
                    let _e407 = phi_1455_;
                    let _e409 = phi_1456_;
                    let _e411 = phi_1457_;
                    phi_1289_ = _e405;
                    phi_1292_ = _e407;
                    phi_1294_ = _e409;
                    phi_1458_ = _e411;
                } else {
                    phi_1289_ = lt_math_LightPoint();
                    phi_1292_ = u32();
                    phi_1294_ = lt_math_LevelPoint();
                    phi_1458_ = false;
                }
                let _e413 = phi_1289_;
                let _e415 = phi_1292_;
                let _e417 = phi_1294_;
                let _e419 = phi_1458_;
                continue;
                continuing {
                    phi_1288_ = _e413;
                    phi_1291_ = _e415;
                    phi_1293_ = _e417;
                    break if !(_e419);
                }
            }
            let _e422 = local_1;
            if _e422.point.is_inside {
                if (0f > 0f) {
                    let _e428 = local_2;
                    if (_e428.level < _e58) {
                    } else {
                        return;
                    }
                    let _e433 = levels.member[(0u + _e428.level)];
                    let _e439 = global[0u];
                    if (_e433.row_w.x == _e439) {
                        let _e442 = global[1u];
                        if (_e433.row_w.y == _e442) {
                            let _e445 = global[2u];
                            phi_1498_ = (_e433.row_w.z == _e445);
                            phi_1499_ = false;
                        } else {
                            phi_1498_ = bool();
                            phi_1499_ = true;
                        }
                        let _e448 = phi_1498_;
                        let _e450 = phi_1499_;
                        phi_1500_ = _e448;
                        phi_1501_ = _e450;
                    } else {
                        phi_1500_ = bool();
                        phi_1501_ = true;
                    }
                    let _e452 = phi_1500_;
                    let _e454 = phi_1501_;
                    if _e454 {
                        phi_1505_ = false;
                    } else {
                        phi_1505_ = _e452;
                    }
                    let _e456 = phi_1505_;
                    if _e456 {
                        let _e458 = samples.member[(0u + _e64.first_primitive)].normal;
                        let _e460 = p.member.map_size;
                        let _e530 = ((abs(((((_e433.row_x.x * _e458.x) + (_e433.row_x.y * _e458.y)) + (_e433.row_x.z * _e458.z)) / (((_e433.row_x.x * _e433.row_x.x) + (_e433.row_x.y * _e433.row_x.y)) + (_e433.row_x.z * _e433.row_x.z)))) + abs(((((_e433.row_y.x * _e458.x) + (_e433.row_y.y * _e458.y)) + (_e433.row_y.z * _e458.z)) / (((_e433.row_y.x * _e433.row_y.x) + (_e433.row_y.y * _e433.row_y.y)) + (_e433.row_y.z * _e433.row_y.z))))) / (abs(((((_e433.row_z.x * _e458.x) + (_e433.row_z.y * _e458.y)) + (_e433.row_z.z * _e458.z)) / (((_e433.row_z.x * _e433.row_z.x) + (_e433.row_z.y * _e433.row_z.y)) + (_e433.row_z.z * _e433.row_z.z)))) * f32(_e460)));
                        if (_e530 < 0.002f) {
                            phi_1587_ = _e530;
                        } else {
                            phi_1587_ = 0.002f;
                        }
                        let _e533 = phi_1587_;
                        phi_1706_ = _e533;
                    } else {
                        let _e535 = p.member.map_size;
                        let _e541 = samples.member[(0u + _e64.first_primitive)].position;
                        let _e552 = ((((_e433.row_w.x * _e541.x) + (_e433.row_w.y * _e541.y)) + (_e433.row_w.z * _e541.z)) + _e433.row_w.w);
                        let _e565 = ((_e433.row_x.x - (_e433.row_w.x * _e422.point.uv.x)) / _e552);
                        let _e566 = ((_e433.row_x.y - (_e433.row_w.y * _e422.point.uv.x)) / _e552);
                        let _e567 = ((_e433.row_x.z - (_e433.row_w.z * _e422.point.uv.x)) / _e552);
                        let _e580 = ((_e433.row_y.x - (_e433.row_w.x * _e422.point.uv.y)) / _e552);
                        let _e581 = ((_e433.row_y.y - (_e433.row_w.y * _e422.point.uv.y)) / _e552);
                        let _e582 = ((_e433.row_y.z - (_e433.row_w.z * _e422.point.uv.y)) / _e552);
                        let _e588 = samples.member[(0u + _e64.first_primitive)].normal;
                        let _e593 = ((_e581 * _e588.z) - (_e588.y * _e582));
                        let _e598 = ((_e582 * _e588.x) - (_e588.z * _e580));
                        let _e603 = ((_e580 * _e588.y) - (_e588.x * _e581));
                        let _e605 = samples.member[(0u + _e64.first_primitive)].normal;
                        let _e610 = ((_e566 * _e605.z) - (_e605.y * _e567));
                        let _e615 = ((_e567 * _e605.x) - (_e605.z * _e565));
                        let _e620 = ((_e565 * _e605.y) - (_e605.x * _e566));
                        let _e647 = ((abs(((((_e433.row_z.x * _e593) + (_e433.row_z.y * _e598)) + (_e433.row_z.z * _e603)) / (((_e565 * _e593) + (_e566 * _e598)) + (_e567 * _e603)))) + abs(((((_e433.row_z.x * _e610) + (_e433.row_z.y * _e615)) + (_e433.row_z.z * _e620)) / (((_e580 * _e610) + (_e581 * _e615)) + (_e582 * _e620))))) / f32(_e535));
                        let _e649 = (16f / f32(_e535));
                        if (_e647 < _e649) {
                            phi_1705_ = _e647;
                        } else {
                            phi_1705_ = _e649;
                        }
                        let _e652 = phi_1705_;
                        phi_1706_ = _e652;
                    }
                    let _e654 = phi_1706_;
                    phi_1709_ = (_e422.point.depth - (0f * _e654));
                } else {
                    phi_1709_ = _e422.point.depth;
                }
                let _e658 = phi_1709_;
                let _e664 = p.member.map_size;
                let _e665 = f32(_e664);
                let _e668 = ((_e422.point.uv.x * _e665) - 0.5f);
                let _e669 = ((_e422.point.uv.y * _e665) - 0.5f);
                if (_e668 > -8388608f) {
                    let _e681 = f32(select(0i, select(select(i32(_e668), i32(-2147483648), (_e668 < bitcast<f32>(3472883712u))), 2147483647i, (_e668 > bitcast<f32>(1325400063u))), (_e668 == _e668)));
                    if (_e681 > _e668) {
                        phi_1738_ = 1f;
                    } else {
                        phi_1738_ = 0f;
                    }
                    let _e684 = phi_1738_;
                    if (_e668 < 8388608f) {
                        phi_1743_ = (_e681 - _e684);
                        phi_1744_ = false;
                    } else {
                        phi_1743_ = f32();
                        phi_1744_ = true;
                    }
                    let _e687 = phi_1743_;
                    let _e689 = phi_1744_;
                    phi_1745_ = _e687;
                    phi_1746_ = _e689;
                } else {
                    phi_1745_ = f32();
                    phi_1746_ = true;
                }
                let _e691 = phi_1745_;
                let _e693 = phi_1746_;
                if _e693 {
                    phi_1750_ = _e668;
                } else {
                    phi_1750_ = _e691;
                }
                let _e695 = phi_1750_;
                if (_e669 > -8388608f) {
                    let _e707 = f32(select(0i, select(select(i32(_e669), i32(-2147483648), (_e669 < bitcast<f32>(3472883712u))), 2147483647i, (_e669 > bitcast<f32>(1325400063u))), (_e669 == _e669)));
                    if (_e707 > _e669) {
                        phi_1770_ = 1f;
                    } else {
                        phi_1770_ = 0f;
                    }
                    let _e710 = phi_1770_;
                    if (_e669 < 8388608f) {
                        phi_1775_ = (_e707 - _e710);
                        phi_1776_ = false;
                    } else {
                        phi_1775_ = f32();
                        phi_1776_ = true;
                    }
                    let _e713 = phi_1775_;
                    let _e715 = phi_1776_;
                    phi_1777_ = _e713;
                    phi_1778_ = _e715;
                } else {
                    phi_1777_ = f32();
                    phi_1778_ = true;
                }
                let _e717 = phi_1777_;
                let _e719 = phi_1778_;
                if _e719 {
                    phi_1782_ = _e669;
                } else {
                    phi_1782_ = _e717;
                }
                let _e721 = phi_1782_;
                let _e722 = (_e668 - _e695);
                let _e723 = (_e669 - _e721);
                let _e732 = select(0i, select(select(i32(_e695), i32(-2147483648), (_e695 < bitcast<f32>(3472883712u))), 2147483647i, (_e695 > bitcast<f32>(1325400063u))), (_e695 == _e695));
                let _e741 = select(0i, select(select(i32(_e721), i32(-2147483648), (_e721 < bitcast<f32>(3472883712u))), 2147483647i, (_e721 > bitcast<f32>(1325400063u))), (_e721 == _e721));
                let _e752 = p.member.test;
                let _e753 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e752);
                let _e755 = p.member.map_size;
                let _e757 = local_3;
                local = _e753;
                let _e760 = ((_e757.level * _e755) * _e755);
                let _e762 = (bitcast<i32>(_e755) - 1i);
                if (_e732 > 0i) {
                    phi_1831_ = _e732;
                } else {
                    phi_1831_ = 0i;
                }
                let _e765 = phi_1831_;
                if (_e741 > 0i) {
                    phi_1836_ = _e741;
                } else {
                    phi_1836_ = 0i;
                }
                let _e768 = phi_1836_;
                if (_e765 < _e762) {
                    phi_1841_ = _e765;
                } else {
                    phi_1841_ = _e762;
                }
                let _e771 = phi_1841_;
                if (_e768 < _e762) {
                    phi_1846_ = _e768;
                } else {
                    phi_1846_ = _e762;
                }
                let _e774 = phi_1846_;
                let _e775 = bitcast<u32>(_e771);
                let _e777 = (_e732 + 1i);
                let _e778 = (_e741 + 1i);
                if (_e777 > 0i) {
                    phi_1855_ = _e777;
                } else {
                    phi_1855_ = 0i;
                }
                let _e781 = phi_1855_;
                if (_e778 > 0i) {
                    phi_1860_ = _e778;
                } else {
                    phi_1860_ = 0i;
                }
                let _e784 = phi_1860_;
                if (_e781 < _e762) {
                    phi_1865_ = _e781;
                } else {
                    phi_1865_ = _e762;
                }
                let _e787 = phi_1865_;
                if (_e784 < _e762) {
                    phi_1870_ = _e784;
                } else {
                    phi_1870_ = _e762;
                }
                let _e790 = phi_1870_;
                let _e791 = bitcast<u32>(_e787);
                let _e793 = (bitcast<u32>(_e774) * _e755);
                let _e794 = (bitcast<u32>(_e790) * _e755);
                let _e799 = ((_e793 + _e775) + _e760);
                let _e800 = ((_e793 + _e791) + _e760);
                let _e801 = ((_e794 + _e775) + _e760);
                let _e802 = ((_e794 + _e791) + _e760);
                if (_e799 < _e52) {
                } else {
                    return;
                }
                let _e806 = map.member[(0u + _e799)];
                if (_e800 < _e52) {
                } else {
                    return;
                }
                let _e810 = map.member[(0u + _e800)];
                if (_e801 < _e52) {
                } else {
                    return;
                }
                let _e814 = map.member[(0u + _e801)];
                if (_e802 < _e52) {
                } else {
                    return;
                }
                let _e818 = map.member[(0u + _e802)];
                let _e820 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e806, _e810, _e814, _e818), vec4<f32>(((1f - _e722) * (1f - _e723)), (_e722 * (1f - _e723)), ((1f - _e722) * _e723), (_e722 * _e723)), _e658);
                phi_1915_ = evaluate_Verdict(_e820, false);
                phi_1916_ = evaluate_Verdict();
                phi_1917_ = false;
            } else {
                phi_1915_ = evaluate_Verdict();
                phi_1916_ = evaluate_Verdict(1f, false);
                phi_1917_ = true;
            }
            let _e824 = phi_1915_;
            let _e826 = phi_1916_;
            let _e828 = phi_1917_;
            phi_1918_ = _e826;
            phi_1919_ = _e824;
            phi_1920_ = _e828;
        }
        let _e830 = phi_1918_;
        let _e832 = phi_1919_;
        let _e834 = phi_1920_;
        if _e834 {
            phi_1924_ = _e830;
        } else {
            phi_1924_ = _e832;
        }
        let _e836 = phi_1924_;
        if (_e64.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e64.first_primitive)] = _e836.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_msm_hausdorff_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
