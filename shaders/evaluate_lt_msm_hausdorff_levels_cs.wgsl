struct abi_LightParams {
    place: vec4<f32>,
    axis: vec3<f32>,
    cos_outer: f32,
    range_squared: f32,
    cos_inner: f32,
    pad: vec2<u32>,
}

struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_9 {
    member: array<abi_Sample>,
}

struct type_13 {
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
var<storage> samples: type_9;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_31;
@group(0) @binding(2) 
var<storage> map: type_13;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_13;
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
        let _e56 = phi_149_;
        let _e58 = phi_150_;
        phi_151_ = _e56;
        phi_152_ = _e58;
    } else {
        phi_151_ = lt_bvh_traverse_Tree();
        phi_152_ = true;
    }
    let _e60 = phi_151_;
    let _e62 = phi_152_;
    if _e62 {
        phi_157_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_157_ = _e60;
    }
    let _e67 = phi_157_;
    return lt_bvh_traverse_Tree(_e67.root, _e67.first_primitive);
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

    let _e47 = (*param_4);
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
            let _e54 = phi_184_;
            phi_185_ = _e54;
        }
        let _e56 = phi_185_;
        phi_186_ = _e56;
    }
    let _e58 = phi_186_;
    let _e59 = (_e58 - 0.00000047683716f);
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
            let _e67 = phi_203_;
            phi_204_ = _e67;
        }
        let _e69 = phi_204_;
        phi_205_ = _e69;
    }
    let _e71 = phi_205_;
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
            let _e79 = phi_221_;
            phi_222_ = _e79;
        }
        let _e81 = phi_222_;
        phi_223_ = _e81;
    }
    let _e83 = phi_223_;
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
            let _e91 = phi_239_;
            phi_240_ = _e91;
        }
        let _e93 = phi_240_;
        phi_241_ = _e93;
    }
    let _e95 = phi_241_;
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
            let _e103 = phi_257_;
            phi_258_ = _e103;
        }
        let _e105 = phi_258_;
        phi_259_ = _e105;
    }
    let _e107 = phi_259_;
    let _e108 = (_e71 - _e59);
    let _e109 = (_e83 - _e59);
    let _e110 = (_e95 - _e59);
    let _e111 = (_e107 - _e59);
    let _e122 = ((((_e108 * param_6.x) + (_e109 * param_6.y)) + (_e110 * param_6.z)) + (_e111 * param_6.w));
    if ((bitcast<u32>(_e122) & 2147483647u) > 2139095040u) {
        phi_1099_ = _e122;
        phi_1100_ = f32();
        phi_1101_ = true;
    } else {
        if (_e108 >= 0f) {
            if (_e109 >= 0f) {
                if (_e110 >= 0f) {
                    phi_294_ = (_e111 >= 0f);
                    phi_295_ = false;
                } else {
                    phi_294_ = bool();
                    phi_295_ = true;
                }
                let _e131 = phi_294_;
                let _e133 = phi_295_;
                phi_296_ = _e131;
                phi_297_ = _e133;
            } else {
                phi_296_ = bool();
                phi_297_ = true;
            }
            let _e135 = phi_296_;
            let _e137 = phi_297_;
            phi_298_ = _e135;
            phi_299_ = _e137;
        } else {
            phi_298_ = bool();
            phi_299_ = true;
        }
        let _e139 = phi_298_;
        let _e141 = phi_299_;
        if _e141 {
            phi_303_ = false;
        } else {
            phi_303_ = _e139;
        }
        let _e143 = phi_303_;
        if _e143 {
            phi_1096_ = 1f;
            phi_1097_ = f32();
            phi_1098_ = true;
        } else {
            let _e144 = (0.5f * _e47);
            let _e145 = (1f - _e47);
            let _e147 = (param_6.x * _e145);
            let _e149 = (param_6.y * _e145);
            let _e151 = (param_6.z * _e145);
            let _e153 = (param_6.w * _e145);
            let _e154 = -(_e59);
            let _e155 = (1f - _e59);
            let _e157 = (vec4<f32>(1f, 1f, 1f, 1f).x - _e71);
            let _e159 = (vec4<f32>(1f, 1f, 1f, 1f).y - _e83);
            let _e161 = (vec4<f32>(1f, 1f, 1f, 1f).z - _e95);
            let _e163 = (vec4<f32>(1f, 1f, 1f, 1f).w - _e107);
            let _e164 = (_e108 - _e109);
            let _e165 = (_e109 - _e110);
            let _e166 = (_e110 - _e111);
            let _e167 = (_e111 - _e108);
            let _e168 = (_e164 * _e164);
            let _e169 = (_e165 * _e165);
            let _e170 = (_e166 * _e166);
            let _e171 = (_e167 * _e167);
            let _e172 = (_e108 - _e110);
            let _e173 = (_e109 - _e111);
            let _e174 = (_e110 - _e108);
            let _e175 = (_e111 - _e109);
            let _e176 = (_e172 * _e172);
            let _e177 = (_e173 * _e173);
            let _e178 = (_e174 * _e174);
            let _e179 = (_e175 * _e175);
            let _e184 = ((_e147 * _e149) * _e168);
            let _e185 = ((_e149 * _e151) * _e169);
            let _e186 = ((_e151 * _e153) * _e170);
            let _e187 = ((_e153 * _e147) * _e171);
            let _e196 = (((0.5f * _e147) * _e151) * _e176);
            let _e197 = (((0.5f * _e149) * _e153) * _e177);
            let _e198 = (((0.5f * _e151) * _e147) * _e178);
            let _e199 = (((0.5f * _e153) * _e149) * _e179);
            let _e200 = (_e108 * _e109);
            let _e201 = (_e109 * _e110);
            let _e202 = (_e110 * _e111);
            let _e203 = (_e111 * _e108);
            let _e204 = (_e108 * _e110);
            let _e205 = (_e109 * _e111);
            let _e206 = (_e110 * _e108);
            let _e207 = (_e111 * _e109);
            let _e208 = (_e184 * _e200);
            let _e209 = (_e185 * _e201);
            let _e210 = (_e186 * _e202);
            let _e211 = (_e187 * _e203);
            let _e212 = (_e196 * _e204);
            let _e213 = (_e197 * _e205);
            let _e214 = (_e198 * _e206);
            let _e215 = (_e199 * _e207);
            let _e216 = (_e71 * _e71);
            let _e217 = (_e83 * _e83);
            let _e218 = (_e95 * _e95);
            let _e219 = (_e107 * _e107);
            let _e220 = (_e157 * _e157);
            let _e221 = (_e159 * _e159);
            let _e222 = (_e161 * _e161);
            let _e223 = (_e163 * _e163);
            let _e224 = (_e144 * _e147);
            let _e225 = (_e144 * _e149);
            let _e226 = (_e144 * _e151);
            let _e227 = (_e144 * _e153);
            let _e236 = (((_e224 * _e108) * _e216) * _e154);
            let _e237 = (((_e225 * _e109) * _e217) * _e154);
            let _e238 = (((_e226 * _e110) * _e218) * _e154);
            let _e239 = (((_e227 * _e111) * _e219) * _e154);
            let _e248 = (((_e224 * _e108) * _e220) * _e155);
            let _e249 = (((_e225 * _e109) * _e221) * _e155);
            let _e250 = (((_e226 * _e110) * _e222) * _e155);
            let _e251 = (((_e227 * _e111) * _e223) * _e155);
            let _e419 = (((((((_e184 * _e151) * _e169) * _e176) + (_e144 * (((_e184 * ((_e216 * _e217) + (_e220 * _e221))) + (_e196 * ((_e216 * _e218) + (_e220 * _e222)))) + ((_e224 * _e216) * _e220)))) + ((((_e185 * _e153) * _e170) * _e177) + (_e144 * (((_e185 * ((_e217 * _e218) + (_e221 * _e222))) + (_e197 * ((_e217 * _e219) + (_e221 * _e223)))) + ((_e225 * _e217) * _e221))))) + ((((_e186 * _e147) * _e171) * _e178) + (_e144 * (((_e186 * ((_e218 * _e219) + (_e222 * _e223))) + (_e198 * ((_e218 * _e216) + (_e222 * _e220)))) + ((_e226 * _e218) * _e222))))) + ((((_e187 * _e149) * _e168) * _e179) + (_e144 * (((_e187 * ((_e219 * _e216) + (_e223 * _e220))) + (_e199 * ((_e219 * _e217) + (_e223 * _e221)))) + ((_e227 * _e219) * _e223)))));
            let _e422 = (((_e144 * _e144) * _e154) * _e155);
            let _e425 = (((((((_e208 * _e200) + (_e212 * _e204)) + (_e108 * ((_e236 * _e154) + (_e248 * _e155)))) + (((_e209 * _e201) + (_e213 * _e205)) + (_e109 * ((_e237 * _e154) + (_e249 * _e155))))) + (((_e210 * _e202) + (_e214 * _e206)) + (_e110 * ((_e238 * _e154) + (_e250 * _e155))))) + (((_e211 * _e203) + (_e215 * _e207)) + (_e111 * ((_e239 * _e154) + (_e251 * _e155))))) + ((_e422 * _e154) * _e155));
            let _e431 = (_e425 < 0.0000000000000000000000000000000001f);
            if _e431 {
                if ((bitcast<u32>(_e108) & 2147483647u) > 2139095040u) {
                    phi_616_ = _e108;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_615_ = 0f;
                    } else {
                        if (_e108 < 0f) {
                            phi_614_ = 0f;
                        } else {
                            phi_614_ = 1f;
                        }
                        let _e440 = phi_614_;
                        phi_615_ = _e440;
                    }
                    let _e442 = phi_615_;
                    phi_616_ = _e442;
                }
                let _e444 = phi_616_;
                if ((bitcast<u32>(_e109) & 2147483647u) > 2139095040u) {
                    phi_635_ = _e109;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_634_ = 0f;
                    } else {
                        if (_e109 < 0f) {
                            phi_633_ = 0f;
                        } else {
                            phi_633_ = 1f;
                        }
                        let _e453 = phi_633_;
                        phi_634_ = _e453;
                    }
                    let _e455 = phi_634_;
                    phi_635_ = _e455;
                }
                let _e457 = phi_635_;
                if ((bitcast<u32>(_e110) & 2147483647u) > 2139095040u) {
                    phi_654_ = _e110;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_653_ = 0f;
                    } else {
                        if (_e110 < 0f) {
                            phi_652_ = 0f;
                        } else {
                            phi_652_ = 1f;
                        }
                        let _e466 = phi_652_;
                        phi_653_ = _e466;
                    }
                    let _e468 = phi_653_;
                    phi_654_ = _e468;
                }
                let _e470 = phi_654_;
                if ((bitcast<u32>(_e111) & 2147483647u) > 2139095040u) {
                    phi_673_ = _e111;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_672_ = 0f;
                    } else {
                        if (_e111 < 0f) {
                            phi_671_ = 0f;
                        } else {
                            phi_671_ = 1f;
                        }
                        let _e479 = phi_671_;
                        phi_672_ = _e479;
                    }
                    let _e481 = phi_672_;
                    phi_673_ = _e481;
                }
                let _e483 = phi_673_;
                let _e491 = (((((_e444 * _e147) + (_e457 * _e149)) + (_e470 * _e151)) + (_e483 * _e153)) + _e144);
                if ((bitcast<u32>(_e491) & 2147483647u) > 2139095040u) {
                    phi_698_ = _e491;
                } else {
                    if (_e491 < 0f) {
                        phi_697_ = 0f;
                    } else {
                        if (_e491 > 1f) {
                            phi_696_ = 1f;
                        } else {
                            phi_696_ = _e491;
                        }
                        let _e498 = phi_696_;
                        phi_697_ = _e498;
                    }
                    let _e500 = phi_697_;
                    phi_698_ = _e500;
                }
                let _e502 = phi_698_;
                phi_1094_ = _e502;
                phi_1095_ = f32();
            } else {
                let _e504 = ((0.5f * -(((((((((_e208 * (_e108 + _e109)) + (_e212 * (_e108 + _e110))) + (_e236 * (_e108 + _e154))) + (_e248 * (_e108 + _e155))) + ((((_e209 * (_e109 + _e110)) + (_e213 * (_e109 + _e111))) + (_e237 * (_e109 + _e154))) + (_e249 * (_e109 + _e155)))) + ((((_e210 * (_e110 + _e111)) + (_e214 * (_e110 + _e108))) + (_e238 * (_e110 + _e154))) + (_e250 * (_e110 + _e155)))) + ((((_e211 * (_e111 + _e108)) + (_e215 * (_e111 + _e109))) + (_e239 * (_e111 + _e154))) + (_e251 * (_e111 + _e155)))) + (_e422 * (_e154 + _e155))))) / _e425);
                let _e505 = ((((((((_e208 + _e212) + _e236) + _e248) + (((_e209 + _e213) + _e237) + _e249)) + (((_e210 + _e214) + _e238) + _e250)) + (((_e211 + _e215) + _e239) + _e251)) + _e422) / _e425);
                let _e507 = ((_e504 * _e504) - _e505);
                if (_e507 > 0f) {
                    phi_709_ = sqrt(_e507);
                } else {
                    phi_709_ = 0f;
                }
                let _e511 = phi_709_;
                if (_e504 > 0f) {
                    let _e514 = (-(_e504) - _e511);
                    phi_726_ = lt_bvh_slab_Span(_e514, (_e505 / _e514));
                } else {
                    let _e517 = (_e511 - _e504);
                    if (_e517 > 0f) {
                        phi_724_ = (_e505 / _e517);
                    } else {
                        phi_724_ = 0f;
                    }
                    let _e521 = phi_724_;
                    phi_726_ = lt_bvh_slab_Span(_e521, _e517);
                }
                let _e524 = phi_726_;
                if (_e524.near >= 0f) {
                    phi_787_ = 1f;
                    phi_788_ = f32();
                    phi_789_ = true;
                } else {
                    let _e528 = (_e524.far <= 0f);
                    if _e528 {
                        phi_785_ = (_e419 / _e425);
                        phi_786_ = f32();
                    } else {
                        let _e539 = (((((_e147 * _e108) + (_e149 * _e109)) + (_e151 * _e110)) + (_e153 * _e111)) + (_e144 * (_e154 + _e155)));
                        let _e555 = (((((_e147 * (_e108 * _e108)) + (_e149 * (_e109 * _e109))) + (_e151 * (_e110 * _e110))) + (_e153 * (_e111 * _e111))) + (_e144 * ((_e154 * _e154) + (_e155 * _e155))));
                        if (-(_e524.near) <= _e524.far) {
                            phi_784_ = (1f - (((_e524.near * _e524.near) * ((_e524.far * _e555) - _e539)) / (_e524.far - _e524.near)));
                        } else {
                            phi_784_ = ((_e419 / _e425) + (((_e524.far * _e524.far) * (_e539 - (_e524.near * _e555))) / (_e524.far - _e524.near)));
                        }
                        let _e574 = phi_784_;
                        phi_785_ = f32();
                        phi_786_ = _e574;
                    }
                    let _e576 = phi_785_;
                    let _e578 = phi_786_;
                    phi_787_ = _e576;
                    phi_788_ = _e578;
                    phi_789_ = _e528;
                }
                let _e580 = phi_787_;
                let _e582 = phi_788_;
                let _e584 = phi_789_;
                if _e584 {
                    phi_793_ = _e580;
                } else {
                    phi_793_ = _e582;
                }
                let _e586 = phi_793_;
                if ((_e524.near * _e154) >= (1f - 0.00001f)) {
                    phi_803_ = true;
                } else {
                    phi_803_ = ((_e524.near * _e155) >= (1f - 0.00001f));
                }
                let _e594 = phi_803_;
                if _e594 {
                    if ((_e524.far * _e154) >= (1f - 0.00001f)) {
                        phi_816_ = true;
                    } else {
                        phi_816_ = ((_e524.far * _e155) >= (1f - 0.00001f));
                    }
                    let _e602 = phi_816_;
                    if _e602 {
                        phi_820_ = false;
                    } else {
                        phi_820_ = true;
                    }
                    let _e604 = phi_820_;
                    phi_821_ = _e604;
                } else {
                    phi_821_ = true;
                }
                let _e606 = phi_821_;
                if _e606 {
                    let _e608 = (-(_e154) < 0.0001f);
                    if _e608 {
                        phi_831_ = bool();
                    } else {
                        phi_831_ = (_e155 < 0.0001f);
                    }
                    let _e611 = phi_831_;
                    phi_832_ = _e611;
                    phi_833_ = _e608;
                } else {
                    phi_832_ = bool();
                    phi_833_ = true;
                }
                let _e613 = phi_832_;
                let _e615 = phi_833_;
                if _e615 {
                    phi_837_ = true;
                } else {
                    phi_837_ = _e613;
                }
                let _e617 = phi_837_;
                if !(_e617) {
                    let _e623 = ((_e147 * _e71) * _e157);
                    let _e624 = ((_e149 * _e83) * _e159);
                    let _e625 = ((_e151 * _e95) * _e161);
                    let _e626 = ((_e153 * _e107) * _e163);
                    let _e644 = ((((_e623 * (_e108 * _e108)) + (_e624 * (_e109 * _e109))) + (_e625 * (_e110 * _e110))) + (_e626 * (_e111 * _e111)));
                    if (_e644 < 0.0000000000000000000000000000000001f) {
                        if ((bitcast<u32>(_e108) & 2147483647u) > 2139095040u) {
                            phi_890_ = _e108;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_889_ = 0f;
                            } else {
                                if (_e108 < 0f) {
                                    phi_888_ = 0f;
                                } else {
                                    phi_888_ = 1f;
                                }
                                let _e654 = phi_888_;
                                phi_889_ = _e654;
                            }
                            let _e656 = phi_889_;
                            phi_890_ = _e656;
                        }
                        let _e658 = phi_890_;
                        if ((bitcast<u32>(_e109) & 2147483647u) > 2139095040u) {
                            phi_909_ = _e109;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_908_ = 0f;
                            } else {
                                if (_e109 < 0f) {
                                    phi_907_ = 0f;
                                } else {
                                    phi_907_ = 1f;
                                }
                                let _e667 = phi_907_;
                                phi_908_ = _e667;
                            }
                            let _e669 = phi_908_;
                            phi_909_ = _e669;
                        }
                        let _e671 = phi_909_;
                        if ((bitcast<u32>(_e110) & 2147483647u) > 2139095040u) {
                            phi_928_ = _e110;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_927_ = 0f;
                            } else {
                                if (_e110 < 0f) {
                                    phi_926_ = 0f;
                                } else {
                                    phi_926_ = 1f;
                                }
                                let _e680 = phi_926_;
                                phi_927_ = _e680;
                            }
                            let _e682 = phi_927_;
                            phi_928_ = _e682;
                        }
                        let _e684 = phi_928_;
                        if ((bitcast<u32>(_e111) & 2147483647u) > 2139095040u) {
                            phi_947_ = _e111;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_946_ = 0f;
                            } else {
                                if (_e111 < 0f) {
                                    phi_945_ = 0f;
                                } else {
                                    phi_945_ = 1f;
                                }
                                let _e693 = phi_945_;
                                phi_946_ = _e693;
                            }
                            let _e695 = phi_946_;
                            phi_947_ = _e695;
                        }
                        let _e697 = phi_947_;
                        let _e705 = (((((_e658 * _e147) + (_e671 * _e149)) + (_e684 * _e151)) + (_e697 * _e153)) + _e144);
                        if ((bitcast<u32>(_e705) & 2147483647u) > 2139095040u) {
                            phi_972_ = _e705;
                        } else {
                            if (_e705 < 0f) {
                                phi_971_ = 0f;
                            } else {
                                if (_e705 > 1f) {
                                    phi_970_ = 1f;
                                } else {
                                    phi_970_ = _e705;
                                }
                                let _e712 = phi_970_;
                                phi_971_ = _e712;
                            }
                            let _e714 = phi_971_;
                            phi_972_ = _e714;
                        }
                        let _e716 = phi_972_;
                        phi_1060_ = _e716;
                    } else {
                        let _e717 = (((((_e623 * _e108) + (_e624 * _e109)) + (_e625 * _e110)) + (_e626 * _e111)) / _e644);
                        let _e734 = ((_e147 * _e108) * (vec4<f32>(1f, 1f, 1f, 1f).x - (_e717 * _e108)));
                        let _e735 = ((_e149 * _e109) * (vec4<f32>(1f, 1f, 1f, 1f).y - (_e717 * _e109)));
                        let _e736 = ((_e151 * _e110) * (vec4<f32>(1f, 1f, 1f, 1f).z - (_e717 * _e110)));
                        let _e737 = ((_e153 * _e111) * (vec4<f32>(1f, 1f, 1f, 1f).w - (_e717 * _e111)));
                        if (_e717 > 0f) {
                            phi_1059_ = ((1f - _e144) - (((((_e734 * _e157) + (_e735 * _e159)) + (_e736 * _e161)) + (_e737 * _e163)) / (_e154 * (1f - (_e154 * _e717)))));
                        } else {
                            phi_1059_ = ((((((((_e623 * ((_e624 * _e168) + ((0.5f * _e625) * _e176))) * vec4<f32>(1f, 1f, 1f, 1f).x) + ((_e624 * ((_e625 * _e169) + ((0.5f * _e626) * _e177))) * vec4<f32>(1f, 1f, 1f, 1f).y)) + ((_e625 * ((_e626 * _e170) + ((0.5f * _e623) * _e178))) * vec4<f32>(1f, 1f, 1f, 1f).z)) + ((_e626 * ((_e623 * _e171) + ((0.5f * _e624) * _e179))) * vec4<f32>(1f, 1f, 1f, 1f).w)) / (_e644 * (-(_e154) * _e155))) + _e144) + (((((_e734 * _e71) + (_e735 * _e83)) + (_e736 * _e95)) + (_e737 * _e107)) / (_e155 * (1f - (_e717 * _e155)))));
                        }
                        let _e801 = phi_1059_;
                        phi_1060_ = _e801;
                    }
                    let _e803 = phi_1060_;
                    if ((bitcast<u32>(_e586) & 2147483647u) > 2139095040u) {
                        phi_1071_ = true;
                    } else {
                        let _e807 = (_e586 < _e803);
                        if _e807 {
                        }
                        phi_1071_ = _e807;
                    }
                    let _e809 = phi_1071_;
                    if _e809 {
                        phi_1075_ = _e586;
                    } else {
                        phi_1075_ = _e803;
                    }
                    let _e811 = phi_1075_;
                    phi_1076_ = _e811;
                } else {
                    phi_1076_ = _e586;
                }
                let _e813 = phi_1076_;
                if ((bitcast<u32>(_e813) & 2147483647u) > 2139095040u) {
                    phi_1093_ = _e813;
                } else {
                    if (_e813 < 0f) {
                        phi_1092_ = 0f;
                    } else {
                        if (_e813 > 1f) {
                            phi_1091_ = 1f;
                        } else {
                            phi_1091_ = _e813;
                        }
                        let _e820 = phi_1091_;
                        phi_1092_ = _e820;
                    }
                    let _e822 = phi_1092_;
                    phi_1093_ = _e822;
                }
                let _e824 = phi_1093_;
                phi_1094_ = f32();
                phi_1095_ = _e824;
            }
            let _e826 = phi_1094_;
            let _e828 = phi_1095_;
            phi_1096_ = _e826;
            phi_1097_ = _e828;
            phi_1098_ = _e431;
        }
        let _e830 = phi_1096_;
        let _e832 = phi_1097_;
        let _e834 = phi_1098_;
        phi_1099_ = _e830;
        phi_1100_ = _e832;
        phi_1101_ = _e834;
    }
    let _e836 = phi_1099_;
    let _e838 = phi_1100_;
    let _e840 = phi_1101_;
    if _e840 {
        phi_1105_ = _e836;
    } else {
        phi_1105_ = _e838;
    }
    let _e842 = phi_1105_;
    return _e842;
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
    var phi_1703_: f32;
    var phi_1704_: f32;
    var phi_1707_: f32;
    var phi_1736_: f32;
    var phi_1741_: f32;
    var phi_1742_: bool;
    var phi_1743_: f32;
    var phi_1744_: bool;
    var phi_1748_: f32;
    var phi_1768_: f32;
    var phi_1773_: f32;
    var phi_1774_: bool;
    var phi_1775_: f32;
    var phi_1776_: bool;
    var phi_1780_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_1829_: i32;
    var phi_1834_: i32;
    var phi_1839_: i32;
    var phi_1844_: i32;
    var phi_1853_: i32;
    var phi_1858_: i32;
    var phi_1863_: i32;
    var phi_1868_: i32;
    var phi_1919_: bool;
    var phi_1927_: bool;
    var phi_1939_: bool;
    var phi_1940_: bool;
    var phi_1944_: f32;
    var phi_1950_: f32;
    var phi_1952_: evaluate_Verdict;
    var phi_1957_: evaluate_Verdict;
    var phi_1958_: evaluate_Verdict;

    let _e44 = id_1;
    let _e51 = arrayLength((&map.member));
    let _e57 = arrayLength((&levels.member));
    let _e60 = p.member.size[0u];
    let _e62 = p.member.size[1u];
    let _e63 = lt_shaders_entry_pixel_index(_e44, _e60, _e62);
    if (bitcast<i32>(_e63.root) != 0i) {
        let _e69 = p.member.level_count;
        if (_e63.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e76 = samples.member[(0u + _e63.first_primitive)].normal[0u];
        let _e78 = global[0u];
        if (_e76 == _e78) {
            let _e81 = samples.member[(0u + _e63.first_primitive)].normal[1u];
            let _e83 = global[1u];
            if (_e81 == _e83) {
                let _e86 = samples.member[(0u + _e63.first_primitive)].normal[2u];
                let _e88 = global[2u];
                phi_1165_ = (_e86 == _e88);
                phi_1166_ = false;
            } else {
                phi_1165_ = bool();
                phi_1166_ = true;
            }
            let _e91 = phi_1165_;
            let _e93 = phi_1166_;
            phi_1167_ = _e91;
            phi_1168_ = _e93;
        } else {
            phi_1167_ = bool();
            phi_1168_ = true;
        }
        let _e95 = phi_1167_;
        let _e97 = phi_1168_;
        if _e97 {
            phi_1172_ = false;
        } else {
            phi_1172_ = _e95;
        }
        let _e99 = phi_1172_;
        if !(_e99) {
            let _e102 = samples.member[(0u + _e63.first_primitive)].position;
            let _e104 = p.member.light.place;
            let _e110 = p.member.light.place[3u];
            let _e117 = (_e104.x - (_e102.x * _e110));
            let _e118 = (_e104.y - (_e102.y * _e110));
            let _e119 = (_e104.z - (_e102.z * _e110));
            let _e121 = samples.member[(0u + _e63.first_primitive)].normal;
            if ((((_e121.x * _e117) + (_e121.y * _e118)) + (_e121.z * _e119)) > 0f) {
                let _e135 = (((_e117 * _e117) + (_e118 * _e118)) + (_e119 * _e119));
                let _e137 = p.member.light.axis;
                let _e149 = p.member.light.place[3u];
                if (_e149 == 0f) {
                    phi_1243_ = true;
                } else {
                    let _e152 = p.member.light.range_squared;
                    if (_e135 <= _e152) {
                        let _e155 = p.member.light.cos_outer;
                        phi_1242_ = (-((((_e117 * _e137.x) + (_e118 * _e137.y)) + (_e119 * _e137.z))) >= (_e155 * sqrt(_e135)));
                    } else {
                        phi_1242_ = false;
                    }
                    let _e160 = phi_1242_;
                    phi_1243_ = _e160;
                }
                let _e162 = phi_1243_;
                if _e162 {
                    let _e164 = samples.member[(0u + _e63.first_primitive)].flags;
                    let _e172 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e178 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e172.unnamed.visibility, false), _e172.unnamed_1);
                    phi_1254_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e178.unnamed, ((_e164 & 1u) == 0u));
                    phi_1255_ = false;
                } else {
                    phi_1254_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_1255_ = true;
                }
                let _e183 = phi_1254_;
                let _e185 = phi_1255_;
                phi_1256_ = _e183;
                phi_1257_ = _e185;
            } else {
                phi_1256_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_1257_ = true;
            }
            let _e187 = phi_1256_;
            let _e189 = phi_1257_;
            if _e189 {
                let _e195 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e201 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e195.unnamed.visibility, false), _e195.unnamed_1);
                phi_1264_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e201.unnamed, true);
            } else {
                phi_1264_ = _e187;
            }
            let _e206 = phi_1264_;
            phi_1268_ = _e206;
        } else {
            let _e212 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e218 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e212.unnamed.visibility, false), _e212.unnamed_1);
            phi_1268_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e218.unnamed, true);
        }
        let _e223 = phi_1268_;
        if _e223.unnamed_1 {
            phi_1958_ = evaluate_Verdict(_e223.unnamed.visibility, _e223.unnamed.is_doubted);
        } else {
            let _e231 = samples.member[(0u + _e63.first_primitive)].position;
            let _e233 = p.member.map_size;
            let _e235 = (0.5f / f32(_e233));
            let _e242 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e249 = lt_math_LightPoint(vec2<f32>(_e242.uv.x, 0f), _e242.depth, _e242.is_inside);
            let _e253 = lt_math_LightPoint(_e249.uv, 0f, _e249.is_inside);
            phi_1288_ = lt_math_LightPoint();
            phi_1291_ = 0u;
            phi_1293_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e253.uv, _e253.depth, false));
            loop {
                let _e260 = phi_1288_;
                let _e262 = phi_1291_;
                let _e264 = phi_1293_;
                local_1 = _e264;
                local_2 = _e264;
                local_3 = _e264;
                if (_e262 < _e69) {
                    if _e264.point.is_inside {
                        phi_1454_ = lt_math_LightPoint();
                        phi_1455_ = u32();
                        phi_1456_ = lt_math_LevelPoint();
                        phi_1457_ = false;
                    } else {
                        if (_e262 < _e57) {
                        } else {
                            return;
                        }
                        let _e275 = levels.member[(0u + _e262)].row_w;
                        let _e286 = ((((_e275.x * _e231.x) + (_e275.y * _e231.y)) + (_e275.z * _e231.z)) + (_e275.w * 1f));
                        let _e288 = levels.member[(0u + _e262)].row_x;
                        let _e300 = (((((_e288.x * _e231.x) + (_e288.y * _e231.y)) + (_e288.z * _e231.z)) + (_e288.w * 1f)) / _e286);
                        let _e302 = levels.member[(0u + _e262)].row_y;
                        let _e314 = (((((_e302.x * _e231.x) + (_e302.y * _e231.y)) + (_e302.z * _e231.z)) + (_e302.w * 1f)) / _e286);
                        let _e316 = levels.member[(0u + _e262)].row_z;
                        let _e327 = ((((_e316.x * _e231.x) + (_e316.y * _e231.y)) + (_e316.z * _e231.z)) + (_e316.w * 1f));
                        if (_e286 > 0f) {
                            if (_e300 >= 0f) {
                                phi_1379_ = (_e300 <= 1f);
                            } else {
                                phi_1379_ = false;
                            }
                            let _e332 = phi_1379_;
                            if _e332 {
                                if (_e314 >= 0f) {
                                    phi_1388_ = (_e314 <= 1f);
                                } else {
                                    phi_1388_ = false;
                                }
                                let _e336 = phi_1388_;
                                if _e336 {
                                    if (_e327 >= 0f) {
                                        phi_1397_ = (_e327 <= 1f);
                                    } else {
                                        phi_1397_ = false;
                                    }
                                    let _e340 = phi_1397_;
                                    phi_1398_ = _e340;
                                    phi_1399_ = false;
                                } else {
                                    phi_1398_ = bool();
                                    phi_1399_ = true;
                                }
                                let _e342 = phi_1398_;
                                let _e344 = phi_1399_;
                                phi_1400_ = _e342;
                                phi_1401_ = _e344;
                            } else {
                                phi_1400_ = bool();
                                phi_1401_ = true;
                            }
                            let _e346 = phi_1400_;
                            let _e348 = phi_1401_;
                            phi_1402_ = _e346;
                            phi_1403_ = _e348;
                        } else {
                            phi_1402_ = bool();
                            phi_1403_ = true;
                        }
                        let _e350 = phi_1402_;
                        let _e352 = phi_1403_;
                        if _e352 {
                            phi_1407_ = false;
                        } else {
                            phi_1407_ = _e350;
                        }
                        let _e354 = phi_1407_;
                        if _e354 {
                            if (_e300 >= _e235) {
                                if (_e300 <= (1f - _e235)) {
                                    if (_e314 >= _e235) {
                                        phi_1434_ = (_e314 <= (1f - _e235));
                                        phi_1435_ = false;
                                    } else {
                                        phi_1434_ = bool();
                                        phi_1435_ = true;
                                    }
                                    let _e362 = phi_1434_;
                                    let _e364 = phi_1435_;
                                    phi_1436_ = _e362;
                                    phi_1437_ = _e364;
                                } else {
                                    phi_1436_ = bool();
                                    phi_1437_ = true;
                                }
                                let _e366 = phi_1436_;
                                let _e368 = phi_1437_;
                                phi_1438_ = _e366;
                                phi_1439_ = _e368;
                            } else {
                                phi_1438_ = bool();
                                phi_1439_ = true;
                            }
                            let _e370 = phi_1438_;
                            let _e372 = phi_1439_;
                            phi_1440_ = _e370;
                            phi_1441_ = _e372;
                        } else {
                            phi_1440_ = bool();
                            phi_1441_ = true;
                        }
                        let _e374 = phi_1440_;
                        let _e376 = phi_1441_;
                        if _e376 {
                            phi_1445_ = false;
                        } else {
                            phi_1445_ = _e374;
                        }
                        let _e378 = phi_1445_;
                        let _e385 = lt_math_LightPoint(vec2<f32>(_e300, _e260.uv.y), _e260.depth, _e260.is_inside);
                        let _e392 = lt_math_LightPoint(vec2<f32>(_e385.uv.x, _e314), _e385.depth, _e385.is_inside);
                        let _e396 = lt_math_LightPoint(_e392.uv, _e327, _e392.is_inside);
                        let _e400 = lt_math_LightPoint(_e396.uv, _e396.depth, _e378);
                        phi_1454_ = _e400;
                        phi_1455_ = (_e262 + 1u);
                        phi_1456_ = lt_math_LevelPoint(_e262, _e400);
                        phi_1457_ = true;
                    }
                    let _e404 = phi_1454_;
                    let _e406 = phi_1455_;
                    let _e408 = phi_1456_;
                    let _e410 = phi_1457_;
                    phi_1289_ = _e404;
                    phi_1292_ = _e406;
                    phi_1294_ = _e408;
                    phi_1458_ = _e410;
                } else {
                    phi_1289_ = lt_math_LightPoint();
                    phi_1292_ = u32();
                    phi_1294_ = lt_math_LevelPoint();
                    phi_1458_ = false;
                }
                let _e412 = phi_1289_;
                let _e414 = phi_1292_;
                let _e416 = phi_1294_;
                let _e418 = phi_1458_;
                continue;
                continuing {
                    phi_1288_ = _e412;
                    phi_1291_ = _e414;
                    phi_1293_ = _e416;
                    break if !(_e418);
                }
            }
            let _e421 = local_1;
            if _e421.point.is_inside {
                if (0f > 0f) {
                    let _e427 = local_2;
                    if (_e427.level < _e57) {
                    } else {
                        return;
                    }
                    let _e432 = levels.member[(0u + _e427.level)];
                    let _e438 = global[0u];
                    if (_e432.row_w.x == _e438) {
                        let _e441 = global[1u];
                        if (_e432.row_w.y == _e441) {
                            let _e444 = global[2u];
                            phi_1498_ = (_e432.row_w.z == _e444);
                            phi_1499_ = false;
                        } else {
                            phi_1498_ = bool();
                            phi_1499_ = true;
                        }
                        let _e447 = phi_1498_;
                        let _e449 = phi_1499_;
                        phi_1500_ = _e447;
                        phi_1501_ = _e449;
                    } else {
                        phi_1500_ = bool();
                        phi_1501_ = true;
                    }
                    let _e451 = phi_1500_;
                    let _e453 = phi_1501_;
                    if _e453 {
                        phi_1505_ = false;
                    } else {
                        phi_1505_ = _e451;
                    }
                    let _e455 = phi_1505_;
                    if _e455 {
                        let _e457 = samples.member[(0u + _e63.first_primitive)].normal;
                        let _e459 = p.member.map_size;
                        let _e529 = ((abs(((((_e432.row_x.x * _e457.x) + (_e432.row_x.y * _e457.y)) + (_e432.row_x.z * _e457.z)) / (((_e432.row_x.x * _e432.row_x.x) + (_e432.row_x.y * _e432.row_x.y)) + (_e432.row_x.z * _e432.row_x.z)))) + abs(((((_e432.row_y.x * _e457.x) + (_e432.row_y.y * _e457.y)) + (_e432.row_y.z * _e457.z)) / (((_e432.row_y.x * _e432.row_y.x) + (_e432.row_y.y * _e432.row_y.y)) + (_e432.row_y.z * _e432.row_y.z))))) / (abs(((((_e432.row_z.x * _e457.x) + (_e432.row_z.y * _e457.y)) + (_e432.row_z.z * _e457.z)) / (((_e432.row_z.x * _e432.row_z.x) + (_e432.row_z.y * _e432.row_z.y)) + (_e432.row_z.z * _e432.row_z.z)))) * f32(_e459)));
                        if (_e529 < 0.002f) {
                            phi_1587_ = _e529;
                        } else {
                            phi_1587_ = 0.002f;
                        }
                        let _e532 = phi_1587_;
                        phi_1704_ = _e532;
                    } else {
                        let _e534 = p.member.map_size;
                        let _e540 = samples.member[(0u + _e63.first_primitive)].position;
                        let _e551 = ((((_e432.row_w.x * _e540.x) + (_e432.row_w.y * _e540.y)) + (_e432.row_w.z * _e540.z)) + _e432.row_w.w);
                        let _e564 = ((_e432.row_x.x - (_e432.row_w.x * _e421.point.uv.x)) / _e551);
                        let _e565 = ((_e432.row_x.y - (_e432.row_w.y * _e421.point.uv.x)) / _e551);
                        let _e566 = ((_e432.row_x.z - (_e432.row_w.z * _e421.point.uv.x)) / _e551);
                        let _e579 = ((_e432.row_y.x - (_e432.row_w.x * _e421.point.uv.y)) / _e551);
                        let _e580 = ((_e432.row_y.y - (_e432.row_w.y * _e421.point.uv.y)) / _e551);
                        let _e581 = ((_e432.row_y.z - (_e432.row_w.z * _e421.point.uv.y)) / _e551);
                        let _e587 = samples.member[(0u + _e63.first_primitive)].normal;
                        let _e592 = ((_e580 * _e587.z) - (_e587.y * _e581));
                        let _e597 = ((_e581 * _e587.x) - (_e587.z * _e579));
                        let _e602 = ((_e579 * _e587.y) - (_e587.x * _e580));
                        let _e604 = samples.member[(0u + _e63.first_primitive)].normal;
                        let _e609 = ((_e565 * _e604.z) - (_e604.y * _e566));
                        let _e614 = ((_e566 * _e604.x) - (_e604.z * _e564));
                        let _e619 = ((_e564 * _e604.y) - (_e604.x * _e565));
                        let _e646 = ((abs(((((_e432.row_z.x * _e592) + (_e432.row_z.y * _e597)) + (_e432.row_z.z * _e602)) / (((_e564 * _e592) + (_e565 * _e597)) + (_e566 * _e602)))) + abs(((((_e432.row_z.x * _e609) + (_e432.row_z.y * _e614)) + (_e432.row_z.z * _e619)) / (((_e579 * _e609) + (_e580 * _e614)) + (_e581 * _e619))))) / f32(_e534));
                        if (_e646 < 0.002f) {
                            phi_1703_ = _e646;
                        } else {
                            phi_1703_ = 0.002f;
                        }
                        let _e649 = phi_1703_;
                        phi_1704_ = _e649;
                    }
                    let _e651 = phi_1704_;
                    phi_1707_ = (_e421.point.depth - (0f * _e651));
                } else {
                    phi_1707_ = _e421.point.depth;
                }
                let _e655 = phi_1707_;
                let _e661 = p.member.map_size;
                let _e662 = f32(_e661);
                let _e665 = ((_e421.point.uv.x * _e662) - 0.5f);
                let _e666 = ((_e421.point.uv.y * _e662) - 0.5f);
                if (_e665 > -8388608f) {
                    let _e678 = f32(select(0i, select(select(i32(_e665), i32(-2147483648), (_e665 < bitcast<f32>(3472883712u))), 2147483647i, (_e665 > bitcast<f32>(1325400063u))), (_e665 == _e665)));
                    if (_e678 > _e665) {
                        phi_1736_ = 1f;
                    } else {
                        phi_1736_ = 0f;
                    }
                    let _e681 = phi_1736_;
                    if (_e665 < 8388608f) {
                        phi_1741_ = (_e678 - _e681);
                        phi_1742_ = false;
                    } else {
                        phi_1741_ = f32();
                        phi_1742_ = true;
                    }
                    let _e684 = phi_1741_;
                    let _e686 = phi_1742_;
                    phi_1743_ = _e684;
                    phi_1744_ = _e686;
                } else {
                    phi_1743_ = f32();
                    phi_1744_ = true;
                }
                let _e688 = phi_1743_;
                let _e690 = phi_1744_;
                if _e690 {
                    phi_1748_ = _e665;
                } else {
                    phi_1748_ = _e688;
                }
                let _e692 = phi_1748_;
                if (_e666 > -8388608f) {
                    let _e704 = f32(select(0i, select(select(i32(_e666), i32(-2147483648), (_e666 < bitcast<f32>(3472883712u))), 2147483647i, (_e666 > bitcast<f32>(1325400063u))), (_e666 == _e666)));
                    if (_e704 > _e666) {
                        phi_1768_ = 1f;
                    } else {
                        phi_1768_ = 0f;
                    }
                    let _e707 = phi_1768_;
                    if (_e666 < 8388608f) {
                        phi_1773_ = (_e704 - _e707);
                        phi_1774_ = false;
                    } else {
                        phi_1773_ = f32();
                        phi_1774_ = true;
                    }
                    let _e710 = phi_1773_;
                    let _e712 = phi_1774_;
                    phi_1775_ = _e710;
                    phi_1776_ = _e712;
                } else {
                    phi_1775_ = f32();
                    phi_1776_ = true;
                }
                let _e714 = phi_1775_;
                let _e716 = phi_1776_;
                if _e716 {
                    phi_1780_ = _e666;
                } else {
                    phi_1780_ = _e714;
                }
                let _e718 = phi_1780_;
                let _e719 = (_e665 - _e692);
                let _e720 = (_e666 - _e718);
                let _e729 = select(0i, select(select(i32(_e692), i32(-2147483648), (_e692 < bitcast<f32>(3472883712u))), 2147483647i, (_e692 > bitcast<f32>(1325400063u))), (_e692 == _e692));
                let _e738 = select(0i, select(select(i32(_e718), i32(-2147483648), (_e718 < bitcast<f32>(3472883712u))), 2147483647i, (_e718 > bitcast<f32>(1325400063u))), (_e718 == _e718));
                let _e749 = p.member.test;
                let _e750 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e749);
                let _e752 = p.member.map_size;
                let _e754 = local_3;
                local = _e750;
                let _e757 = ((_e754.level * _e752) * _e752);
                let _e759 = (bitcast<i32>(_e752) - 1i);
                if (_e729 > 0i) {
                    phi_1829_ = _e729;
                } else {
                    phi_1829_ = 0i;
                }
                let _e762 = phi_1829_;
                if (_e738 > 0i) {
                    phi_1834_ = _e738;
                } else {
                    phi_1834_ = 0i;
                }
                let _e765 = phi_1834_;
                if (_e762 < _e759) {
                    phi_1839_ = _e762;
                } else {
                    phi_1839_ = _e759;
                }
                let _e768 = phi_1839_;
                if (_e765 < _e759) {
                    phi_1844_ = _e765;
                } else {
                    phi_1844_ = _e759;
                }
                let _e771 = phi_1844_;
                let _e772 = bitcast<u32>(_e768);
                let _e774 = (_e729 + 1i);
                let _e775 = (_e738 + 1i);
                if (_e774 > 0i) {
                    phi_1853_ = _e774;
                } else {
                    phi_1853_ = 0i;
                }
                let _e778 = phi_1853_;
                if (_e775 > 0i) {
                    phi_1858_ = _e775;
                } else {
                    phi_1858_ = 0i;
                }
                let _e781 = phi_1858_;
                if (_e778 < _e759) {
                    phi_1863_ = _e778;
                } else {
                    phi_1863_ = _e759;
                }
                let _e784 = phi_1863_;
                if (_e781 < _e759) {
                    phi_1868_ = _e781;
                } else {
                    phi_1868_ = _e759;
                }
                let _e787 = phi_1868_;
                let _e788 = bitcast<u32>(_e784);
                let _e790 = (bitcast<u32>(_e771) * _e752);
                let _e791 = (bitcast<u32>(_e787) * _e752);
                let _e796 = ((_e790 + _e772) + _e757);
                let _e797 = ((_e790 + _e788) + _e757);
                let _e798 = ((_e791 + _e772) + _e757);
                let _e799 = ((_e791 + _e788) + _e757);
                if (_e796 < _e51) {
                } else {
                    return;
                }
                let _e803 = map.member[(0u + _e796)];
                if (_e797 < _e51) {
                } else {
                    return;
                }
                let _e807 = map.member[(0u + _e797)];
                if (_e798 < _e51) {
                } else {
                    return;
                }
                let _e811 = map.member[(0u + _e798)];
                if (_e799 < _e51) {
                } else {
                    return;
                }
                let _e815 = map.member[(0u + _e799)];
                let _e817 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e803, _e807, _e811, _e815), vec4<f32>(((1f - _e719) * (1f - _e720)), (_e719 * (1f - _e720)), ((1f - _e719) * _e720), (_e719 * _e720)), _e655);
                let _e819 = p.member.epsilon;
                if (_e817 <= _e819) {
                    phi_1919_ = true;
                } else {
                    phi_1919_ = (_e817 >= (1f - _e819));
                }
                let _e824 = phi_1919_;
                if ((bitcast<u32>(_e817) & 2147483647u) > 2139095040u) {
                    phi_1927_ = true;
                } else {
                    phi_1927_ = !(_e824);
                }
                let _e830 = phi_1927_;
                if _e830 {
                    if (_e817 > 0f) {
                        if (_e817 < 1f) {
                            phi_1939_ = false;
                        } else {
                            phi_1939_ = true;
                        }
                        let _e834 = phi_1939_;
                        phi_1940_ = _e834;
                    } else {
                        phi_1940_ = true;
                    }
                    let _e836 = phi_1940_;
                    if _e836 {
                        phi_1944_ = 0.5f;
                    } else {
                        phi_1944_ = _e817;
                    }
                    let _e838 = phi_1944_;
                    phi_1952_ = evaluate_Verdict(_e838, true);
                } else {
                    if (_e817 > 0.5f) {
                        phi_1950_ = 1f;
                    } else {
                        phi_1950_ = 0f;
                    }
                    let _e842 = phi_1950_;
                    phi_1952_ = evaluate_Verdict(_e842, false);
                }
                let _e845 = phi_1952_;
                phi_1957_ = evaluate_Verdict(_e845.visibility, _e845.is_doubted);
            } else {
                phi_1957_ = evaluate_Verdict(0.5f, true);
            }
            let _e851 = phi_1957_;
            phi_1958_ = _e851;
        }
        let _e853 = phi_1958_;
        if (_e63.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e63.first_primitive)] = _e853.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_msm_hausdorff_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
