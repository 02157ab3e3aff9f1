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
        let _e56 = phi_148_;
        let _e58 = phi_149_;
        phi_150_ = _e56;
        phi_151_ = _e58;
    } else {
        phi_150_ = lt_bvh_traverse_Tree();
        phi_151_ = true;
    }
    let _e60 = phi_150_;
    let _e62 = phi_151_;
    if _e62 {
        phi_156_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_156_ = _e60;
    }
    let _e67 = phi_156_;
    return lt_bvh_traverse_Tree(_e67.root, _e67.first_primitive);
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

    let _e47 = (*param_4);
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
            let _e54 = phi_183_;
            phi_184_ = _e54;
        }
        let _e56 = phi_184_;
        phi_185_ = _e56;
    }
    let _e58 = phi_185_;
    let _e59 = (_e58 - 0.00000047683716f);
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
            let _e67 = phi_202_;
            phi_203_ = _e67;
        }
        let _e69 = phi_203_;
        phi_204_ = _e69;
    }
    let _e71 = phi_204_;
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
            let _e79 = phi_220_;
            phi_221_ = _e79;
        }
        let _e81 = phi_221_;
        phi_222_ = _e81;
    }
    let _e83 = phi_222_;
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
            let _e91 = phi_238_;
            phi_239_ = _e91;
        }
        let _e93 = phi_239_;
        phi_240_ = _e93;
    }
    let _e95 = phi_240_;
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
            let _e103 = phi_256_;
            phi_257_ = _e103;
        }
        let _e105 = phi_257_;
        phi_258_ = _e105;
    }
    let _e107 = phi_258_;
    let _e108 = (_e71 - _e59);
    let _e109 = (_e83 - _e59);
    let _e110 = (_e95 - _e59);
    let _e111 = (_e107 - _e59);
    let _e122 = ((((_e108 * param_6.x) + (_e109 * param_6.y)) + (_e110 * param_6.z)) + (_e111 * param_6.w));
    if ((bitcast<u32>(_e122) & 2147483647u) > 2139095040u) {
        phi_1098_ = _e122;
        phi_1099_ = f32();
        phi_1100_ = true;
    } else {
        if (_e108 >= 0f) {
            if (_e109 >= 0f) {
                if (_e110 >= 0f) {
                    phi_293_ = (_e111 >= 0f);
                    phi_294_ = false;
                } else {
                    phi_293_ = bool();
                    phi_294_ = true;
                }
                let _e131 = phi_293_;
                let _e133 = phi_294_;
                phi_295_ = _e131;
                phi_296_ = _e133;
            } else {
                phi_295_ = bool();
                phi_296_ = true;
            }
            let _e135 = phi_295_;
            let _e137 = phi_296_;
            phi_297_ = _e135;
            phi_298_ = _e137;
        } else {
            phi_297_ = bool();
            phi_298_ = true;
        }
        let _e139 = phi_297_;
        let _e141 = phi_298_;
        if _e141 {
            phi_302_ = false;
        } else {
            phi_302_ = _e139;
        }
        let _e143 = phi_302_;
        if _e143 {
            phi_1095_ = 1f;
            phi_1096_ = f32();
            phi_1097_ = true;
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
                    phi_615_ = _e108;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_614_ = 0f;
                    } else {
                        if (_e108 < 0f) {
                            phi_613_ = 0f;
                        } else {
                            phi_613_ = 1f;
                        }
                        let _e440 = phi_613_;
                        phi_614_ = _e440;
                    }
                    let _e442 = phi_614_;
                    phi_615_ = _e442;
                }
                let _e444 = phi_615_;
                if ((bitcast<u32>(_e109) & 2147483647u) > 2139095040u) {
                    phi_634_ = _e109;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_633_ = 0f;
                    } else {
                        if (_e109 < 0f) {
                            phi_632_ = 0f;
                        } else {
                            phi_632_ = 1f;
                        }
                        let _e453 = phi_632_;
                        phi_633_ = _e453;
                    }
                    let _e455 = phi_633_;
                    phi_634_ = _e455;
                }
                let _e457 = phi_634_;
                if ((bitcast<u32>(_e110) & 2147483647u) > 2139095040u) {
                    phi_653_ = _e110;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_652_ = 0f;
                    } else {
                        if (_e110 < 0f) {
                            phi_651_ = 0f;
                        } else {
                            phi_651_ = 1f;
                        }
                        let _e466 = phi_651_;
                        phi_652_ = _e466;
                    }
                    let _e468 = phi_652_;
                    phi_653_ = _e468;
                }
                let _e470 = phi_653_;
                if ((bitcast<u32>(_e111) & 2147483647u) > 2139095040u) {
                    phi_672_ = _e111;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_671_ = 0f;
                    } else {
                        if (_e111 < 0f) {
                            phi_670_ = 0f;
                        } else {
                            phi_670_ = 1f;
                        }
                        let _e479 = phi_670_;
                        phi_671_ = _e479;
                    }
                    let _e481 = phi_671_;
                    phi_672_ = _e481;
                }
                let _e483 = phi_672_;
                let _e491 = (((((_e444 * _e147) + (_e457 * _e149)) + (_e470 * _e151)) + (_e483 * _e153)) + _e144);
                if ((bitcast<u32>(_e491) & 2147483647u) > 2139095040u) {
                    phi_697_ = _e491;
                } else {
                    if (_e491 < 0f) {
                        phi_696_ = 0f;
                    } else {
                        if (_e491 > 1f) {
                            phi_695_ = 1f;
                        } else {
                            phi_695_ = _e491;
                        }
                        let _e498 = phi_695_;
                        phi_696_ = _e498;
                    }
                    let _e500 = phi_696_;
                    phi_697_ = _e500;
                }
                let _e502 = phi_697_;
                phi_1093_ = _e502;
                phi_1094_ = f32();
            } else {
                let _e504 = ((0.5f * -(((((((((_e208 * (_e108 + _e109)) + (_e212 * (_e108 + _e110))) + (_e236 * (_e108 + _e154))) + (_e248 * (_e108 + _e155))) + ((((_e209 * (_e109 + _e110)) + (_e213 * (_e109 + _e111))) + (_e237 * (_e109 + _e154))) + (_e249 * (_e109 + _e155)))) + ((((_e210 * (_e110 + _e111)) + (_e214 * (_e110 + _e108))) + (_e238 * (_e110 + _e154))) + (_e250 * (_e110 + _e155)))) + ((((_e211 * (_e111 + _e108)) + (_e215 * (_e111 + _e109))) + (_e239 * (_e111 + _e154))) + (_e251 * (_e111 + _e155)))) + (_e422 * (_e154 + _e155))))) / _e425);
                let _e505 = ((((((((_e208 + _e212) + _e236) + _e248) + (((_e209 + _e213) + _e237) + _e249)) + (((_e210 + _e214) + _e238) + _e250)) + (((_e211 + _e215) + _e239) + _e251)) + _e422) / _e425);
                let _e507 = ((_e504 * _e504) - _e505);
                if (_e507 > 0f) {
                    phi_708_ = sqrt(_e507);
                } else {
                    phi_708_ = 0f;
                }
                let _e511 = phi_708_;
                if (_e504 > 0f) {
                    let _e514 = (-(_e504) - _e511);
                    phi_725_ = lt_bvh_slab_Span(_e514, (_e505 / _e514));
                } else {
                    let _e517 = (_e511 - _e504);
                    if (_e517 > 0f) {
                        phi_723_ = (_e505 / _e517);
                    } else {
                        phi_723_ = 0f;
                    }
                    let _e521 = phi_723_;
                    phi_725_ = lt_bvh_slab_Span(_e521, _e517);
                }
                let _e524 = phi_725_;
                if (_e524.near >= 0f) {
                    phi_786_ = 1f;
                    phi_787_ = f32();
                    phi_788_ = true;
                } else {
                    let _e528 = (_e524.far <= 0f);
                    if _e528 {
                        phi_784_ = (_e419 / _e425);
                        phi_785_ = f32();
                    } else {
                        let _e539 = (((((_e147 * _e108) + (_e149 * _e109)) + (_e151 * _e110)) + (_e153 * _e111)) + (_e144 * (_e154 + _e155)));
                        let _e555 = (((((_e147 * (_e108 * _e108)) + (_e149 * (_e109 * _e109))) + (_e151 * (_e110 * _e110))) + (_e153 * (_e111 * _e111))) + (_e144 * ((_e154 * _e154) + (_e155 * _e155))));
                        if (-(_e524.near) <= _e524.far) {
                            phi_783_ = (1f - (((_e524.near * _e524.near) * ((_e524.far * _e555) - _e539)) / (_e524.far - _e524.near)));
                        } else {
                            phi_783_ = ((_e419 / _e425) + (((_e524.far * _e524.far) * (_e539 - (_e524.near * _e555))) / (_e524.far - _e524.near)));
                        }
                        let _e574 = phi_783_;
                        phi_784_ = f32();
                        phi_785_ = _e574;
                    }
                    let _e576 = phi_784_;
                    let _e578 = phi_785_;
                    phi_786_ = _e576;
                    phi_787_ = _e578;
                    phi_788_ = _e528;
                }
                let _e580 = phi_786_;
                let _e582 = phi_787_;
                let _e584 = phi_788_;
                if _e584 {
                    phi_792_ = _e580;
                } else {
                    phi_792_ = _e582;
                }
                let _e586 = phi_792_;
                if ((_e524.near * _e154) >= (1f - 0.00001f)) {
                    phi_802_ = true;
                } else {
                    phi_802_ = ((_e524.near * _e155) >= (1f - 0.00001f));
                }
                let _e594 = phi_802_;
                if _e594 {
                    if ((_e524.far * _e154) >= (1f - 0.00001f)) {
                        phi_815_ = true;
                    } else {
                        phi_815_ = ((_e524.far * _e155) >= (1f - 0.00001f));
                    }
                    let _e602 = phi_815_;
                    if _e602 {
                        phi_819_ = false;
                    } else {
                        phi_819_ = true;
                    }
                    let _e604 = phi_819_;
                    phi_820_ = _e604;
                } else {
                    phi_820_ = true;
                }
                let _e606 = phi_820_;
                if _e606 {
                    let _e608 = (-(_e154) < 0.0001f);
                    if _e608 {
                        phi_830_ = bool();
                    } else {
                        phi_830_ = (_e155 < 0.0001f);
                    }
                    let _e611 = phi_830_;
                    phi_831_ = _e611;
                    phi_832_ = _e608;
                } else {
                    phi_831_ = bool();
                    phi_832_ = true;
                }
                let _e613 = phi_831_;
                let _e615 = phi_832_;
                if _e615 {
                    phi_836_ = true;
                } else {
                    phi_836_ = _e613;
                }
                let _e617 = phi_836_;
                if !(_e617) {
                    let _e623 = ((_e147 * _e71) * _e157);
                    let _e624 = ((_e149 * _e83) * _e159);
                    let _e625 = ((_e151 * _e95) * _e161);
                    let _e626 = ((_e153 * _e107) * _e163);
                    let _e644 = ((((_e623 * (_e108 * _e108)) + (_e624 * (_e109 * _e109))) + (_e625 * (_e110 * _e110))) + (_e626 * (_e111 * _e111)));
                    if (_e644 < 0.0000000000000000000000000000000001f) {
                        if ((bitcast<u32>(_e108) & 2147483647u) > 2139095040u) {
                            phi_889_ = _e108;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_888_ = 0f;
                            } else {
                                if (_e108 < 0f) {
                                    phi_887_ = 0f;
                                } else {
                                    phi_887_ = 1f;
                                }
                                let _e654 = phi_887_;
                                phi_888_ = _e654;
                            }
                            let _e656 = phi_888_;
                            phi_889_ = _e656;
                        }
                        let _e658 = phi_889_;
                        if ((bitcast<u32>(_e109) & 2147483647u) > 2139095040u) {
                            phi_908_ = _e109;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_907_ = 0f;
                            } else {
                                if (_e109 < 0f) {
                                    phi_906_ = 0f;
                                } else {
                                    phi_906_ = 1f;
                                }
                                let _e667 = phi_906_;
                                phi_907_ = _e667;
                            }
                            let _e669 = phi_907_;
                            phi_908_ = _e669;
                        }
                        let _e671 = phi_908_;
                        if ((bitcast<u32>(_e110) & 2147483647u) > 2139095040u) {
                            phi_927_ = _e110;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_926_ = 0f;
                            } else {
                                if (_e110 < 0f) {
                                    phi_925_ = 0f;
                                } else {
                                    phi_925_ = 1f;
                                }
                                let _e680 = phi_925_;
                                phi_926_ = _e680;
                            }
                            let _e682 = phi_926_;
                            phi_927_ = _e682;
                        }
                        let _e684 = phi_927_;
                        if ((bitcast<u32>(_e111) & 2147483647u) > 2139095040u) {
                            phi_946_ = _e111;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_945_ = 0f;
                            } else {
                                if (_e111 < 0f) {
                                    phi_944_ = 0f;
                                } else {
                                    phi_944_ = 1f;
                                }
                                let _e693 = phi_944_;
                                phi_945_ = _e693;
                            }
                            let _e695 = phi_945_;
                            phi_946_ = _e695;
                        }
                        let _e697 = phi_946_;
                        let _e705 = (((((_e658 * _e147) + (_e671 * _e149)) + (_e684 * _e151)) + (_e697 * _e153)) + _e144);
                        if ((bitcast<u32>(_e705) & 2147483647u) > 2139095040u) {
                            phi_971_ = _e705;
                        } else {
                            if (_e705 < 0f) {
                                phi_970_ = 0f;
                            } else {
                                if (_e705 > 1f) {
                                    phi_969_ = 1f;
                                } else {
                                    phi_969_ = _e705;
                                }
                                let _e712 = phi_969_;
                                phi_970_ = _e712;
                            }
                            let _e714 = phi_970_;
                            phi_971_ = _e714;
                        }
                        let _e716 = phi_971_;
                        phi_1059_ = _e716;
                    } else {
                        let _e717 = (((((_e623 * _e108) + (_e624 * _e109)) + (_e625 * _e110)) + (_e626 * _e111)) / _e644);
                        let _e734 = ((_e147 * _e108) * (vec4<f32>(1f, 1f, 1f, 1f).x - (_e717 * _e108)));
                        let _e735 = ((_e149 * _e109) * (vec4<f32>(1f, 1f, 1f, 1f).y - (_e717 * _e109)));
                        let _e736 = ((_e151 * _e110) * (vec4<f32>(1f, 1f, 1f, 1f).z - (_e717 * _e110)));
                        let _e737 = ((_e153 * _e111) * (vec4<f32>(1f, 1f, 1f, 1f).w - (_e717 * _e111)));
                        if (_e717 > 0f) {
                            phi_1058_ = ((1f - _e144) - (((((_e734 * _e157) + (_e735 * _e159)) + (_e736 * _e161)) + (_e737 * _e163)) / (_e154 * (1f - (_e154 * _e717)))));
                        } else {
                            phi_1058_ = ((((((((_e623 * ((_e624 * _e168) + ((0.5f * _e625) * _e176))) * vec4<f32>(1f, 1f, 1f, 1f).x) + ((_e624 * ((_e625 * _e169) + ((0.5f * _e626) * _e177))) * vec4<f32>(1f, 1f, 1f, 1f).y)) + ((_e625 * ((_e626 * _e170) + ((0.5f * _e623) * _e178))) * vec4<f32>(1f, 1f, 1f, 1f).z)) + ((_e626 * ((_e623 * _e171) + ((0.5f * _e624) * _e179))) * vec4<f32>(1f, 1f, 1f, 1f).w)) / (_e644 * (-(_e154) * _e155))) + _e144) + (((((_e734 * _e71) + (_e735 * _e83)) + (_e736 * _e95)) + (_e737 * _e107)) / (_e155 * (1f - (_e717 * _e155)))));
                        }
                        let _e801 = phi_1058_;
                        phi_1059_ = _e801;
                    }
                    let _e803 = phi_1059_;
                    if ((bitcast<u32>(_e586) & 2147483647u) > 2139095040u) {
                        phi_1070_ = true;
                    } else {
                        let _e807 = (_e586 < _e803);
                        if _e807 {
                        }
                        phi_1070_ = _e807;
                    }
                    let _e809 = phi_1070_;
                    if _e809 {
                        phi_1074_ = _e586;
                    } else {
                        phi_1074_ = _e803;
                    }
                    let _e811 = phi_1074_;
                    phi_1075_ = _e811;
                } else {
                    phi_1075_ = _e586;
                }
                let _e813 = phi_1075_;
                if ((bitcast<u32>(_e813) & 2147483647u) > 2139095040u) {
                    phi_1092_ = _e813;
                } else {
                    if (_e813 < 0f) {
                        phi_1091_ = 0f;
                    } else {
                        if (_e813 > 1f) {
                            phi_1090_ = 1f;
                        } else {
                            phi_1090_ = _e813;
                        }
                        let _e820 = phi_1090_;
                        phi_1091_ = _e820;
                    }
                    let _e822 = phi_1091_;
                    phi_1092_ = _e822;
                }
                let _e824 = phi_1092_;
                phi_1093_ = f32();
                phi_1094_ = _e824;
            }
            let _e826 = phi_1093_;
            let _e828 = phi_1094_;
            phi_1095_ = _e826;
            phi_1096_ = _e828;
            phi_1097_ = _e431;
        }
        let _e830 = phi_1095_;
        let _e832 = phi_1096_;
        let _e834 = phi_1097_;
        phi_1098_ = _e830;
        phi_1099_ = _e832;
        phi_1100_ = _e834;
    }
    let _e836 = phi_1098_;
    let _e838 = phi_1099_;
    let _e840 = phi_1100_;
    if _e840 {
        phi_1104_ = _e836;
    } else {
        phi_1104_ = _e838;
    }
    let _e842 = phi_1104_;
    return _e842;
}

fn function_() {
    var local: f32;
    var phi_1164_: bool;
    var phi_1165_: bool;
    var phi_1166_: bool;
    var phi_1167_: bool;
    var phi_1171_: bool;
    var phi_1241_: bool;
    var phi_1242_: bool;
    var phi_1253_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1254_: bool;
    var phi_1255_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1256_: bool;
    var phi_1263_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1267_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1287_: lt_math_LightPoint;
    var phi_1290_: u32;
    var phi_1292_: lt_math_LevelPoint;
    var phi_1378_: bool;
    var phi_1387_: bool;
    var phi_1396_: bool;
    var phi_1397_: bool;
    var phi_1398_: bool;
    var phi_1399_: bool;
    var phi_1400_: bool;
    var phi_1401_: bool;
    var phi_1402_: bool;
    var phi_1406_: bool;
    var phi_1433_: bool;
    var phi_1434_: bool;
    var phi_1435_: bool;
    var phi_1436_: bool;
    var phi_1437_: bool;
    var phi_1438_: bool;
    var phi_1439_: bool;
    var phi_1440_: bool;
    var phi_1444_: bool;
    var phi_1453_: lt_math_LightPoint;
    var phi_1454_: u32;
    var phi_1455_: lt_math_LevelPoint;
    var phi_1456_: bool;
    var phi_1288_: lt_math_LightPoint;
    var phi_1291_: u32;
    var phi_1293_: lt_math_LevelPoint;
    var phi_1457_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_1497_: bool;
    var phi_1498_: bool;
    var phi_1499_: bool;
    var phi_1500_: bool;
    var phi_1504_: bool;
    var phi_1586_: f32;
    var phi_1702_: f32;
    var phi_1703_: f32;
    var phi_1706_: f32;
    var phi_1735_: f32;
    var phi_1740_: f32;
    var phi_1741_: bool;
    var phi_1742_: f32;
    var phi_1743_: bool;
    var phi_1747_: f32;
    var phi_1767_: f32;
    var phi_1772_: f32;
    var phi_1773_: bool;
    var phi_1774_: f32;
    var phi_1775_: bool;
    var phi_1779_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_1828_: i32;
    var phi_1833_: i32;
    var phi_1838_: i32;
    var phi_1843_: i32;
    var phi_1852_: i32;
    var phi_1857_: i32;
    var phi_1862_: i32;
    var phi_1867_: i32;
    var phi_1912_: evaluate_Verdict;
    var phi_1913_: evaluate_Verdict;
    var phi_1914_: bool;
    var phi_1915_: evaluate_Verdict;
    var phi_1916_: evaluate_Verdict;
    var phi_1917_: bool;
    var phi_1921_: evaluate_Verdict;

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
                phi_1164_ = (_e86 == _e88);
                phi_1165_ = false;
            } else {
                phi_1164_ = bool();
                phi_1165_ = true;
            }
            let _e91 = phi_1164_;
            let _e93 = phi_1165_;
            phi_1166_ = _e91;
            phi_1167_ = _e93;
        } else {
            phi_1166_ = bool();
            phi_1167_ = true;
        }
        let _e95 = phi_1166_;
        let _e97 = phi_1167_;
        if _e97 {
            phi_1171_ = false;
        } else {
            phi_1171_ = _e95;
        }
        let _e99 = phi_1171_;
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
                    phi_1242_ = true;
                } else {
                    let _e152 = p.member.light.range_squared;
                    if (_e135 <= _e152) {
                        let _e155 = p.member.light.cos_outer;
                        phi_1241_ = (-((((_e117 * _e137.x) + (_e118 * _e137.y)) + (_e119 * _e137.z))) >= (_e155 * sqrt(_e135)));
                    } else {
                        phi_1241_ = false;
                    }
                    let _e160 = phi_1241_;
                    phi_1242_ = _e160;
                }
                let _e162 = phi_1242_;
                if _e162 {
                    let _e164 = samples.member[(0u + _e63.first_primitive)].flags;
                    let _e172 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e178 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e172.unnamed.visibility, false), _e172.unnamed_1);
                    phi_1253_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e178.unnamed, ((_e164 & 1u) == 0u));
                    phi_1254_ = false;
                } else {
                    phi_1253_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_1254_ = true;
                }
                let _e183 = phi_1253_;
                let _e185 = phi_1254_;
                phi_1255_ = _e183;
                phi_1256_ = _e185;
            } else {
                phi_1255_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_1256_ = true;
            }
            let _e187 = phi_1255_;
            let _e189 = phi_1256_;
            if _e189 {
                let _e195 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e201 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e195.unnamed.visibility, false), _e195.unnamed_1);
                phi_1263_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e201.unnamed, true);
            } else {
                phi_1263_ = _e187;
            }
            let _e206 = phi_1263_;
            phi_1267_ = _e206;
        } else {
            let _e212 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e218 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e212.unnamed.visibility, false), _e212.unnamed_1);
            phi_1267_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e218.unnamed, true);
        }
        let _e223 = phi_1267_;
        if _e223.unnamed_1 {
            phi_1915_ = evaluate_Verdict(_e223.unnamed.visibility, _e223.unnamed.is_doubted);
            phi_1916_ = evaluate_Verdict();
            phi_1917_ = true;
        } else {
            let _e231 = samples.member[(0u + _e63.first_primitive)].position;
            let _e233 = p.member.map_size;
            let _e235 = (0.5f / f32(_e233));
            let _e242 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e249 = lt_math_LightPoint(vec2<f32>(_e242.uv.x, 0f), _e242.depth, _e242.is_inside);
            let _e253 = lt_math_LightPoint(_e249.uv, 0f, _e249.is_inside);
            phi_1287_ = lt_math_LightPoint();
            phi_1290_ = 0u;
            phi_1292_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e253.uv, _e253.depth, false));
            loop {
                let _e260 = phi_1287_;
                let _e262 = phi_1290_;
                let _e264 = phi_1292_;
                local_1 = _e264;
                local_2 = _e264;
                local_3 = _e264;
                if (_e262 < _e69) {
                    if _e264.point.is_inside {
                        phi_1453_ = lt_math_LightPoint();
                        phi_1454_ = u32();
                        phi_1455_ = lt_math_LevelPoint();
                        phi_1456_ = false;
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
                                phi_1378_ = (_e300 <= 1f);
                            } else {
                                phi_1378_ = false;
                            }
                            let _e332 = phi_1378_;
                            if _e332 {
                                if (_e314 >= 0f) {
                                    phi_1387_ = (_e314 <= 1f);
                                } else {
                                    phi_1387_ = false;
                                }
                                let _e336 = phi_1387_;
                                if _e336 {
                                    if (_e327 >= 0f) {
                                        phi_1396_ = (_e327 <= 1f);
                                    } else {
                                        phi_1396_ = false;
                                    }
                                    let _e340 = phi_1396_;
                                    phi_1397_ = _e340;
                                    phi_1398_ = false;
                                } else {
                                    phi_1397_ = bool();
                                    phi_1398_ = true;
                                }
                                let _e342 = phi_1397_;
                                let _e344 = phi_1398_;
                                phi_1399_ = _e342;
                                phi_1400_ = _e344;
                            } else {
                                phi_1399_ = bool();
                                phi_1400_ = true;
                            }
                            let _e346 = phi_1399_;
                            let _e348 = phi_1400_;
                            phi_1401_ = _e346;
                            phi_1402_ = _e348;
                        } else {
                            phi_1401_ = bool();
                            phi_1402_ = true;
                        }
                        let _e350 = phi_1401_;
                        let _e352 = phi_1402_;
                        if _e352 {
                            phi_1406_ = false;
                        } else {
                            phi_1406_ = _e350;
                        }
                        let _e354 = phi_1406_;
                        if _e354 {
                            if (_e300 >= _e235) {
                                if (_e300 <= (1f - _e235)) {
                                    if (_e314 >= _e235) {
                                        phi_1433_ = (_e314 <= (1f - _e235));
                                        phi_1434_ = false;
                                    } else {
                                        phi_1433_ = bool();
                                        phi_1434_ = true;
                                    }
                                    let _e362 = phi_1433_;
                                    let _e364 = phi_1434_;
                                    phi_1435_ = _e362;
                                    phi_1436_ = _e364;
                                } else {
                                    phi_1435_ = bool();
                                    phi_1436_ = true;
                                }
                                let _e366 = phi_1435_;
                                let _e368 = phi_1436_;
                                phi_1437_ = _e366;
                                phi_1438_ = _e368;
                            } else {
                                phi_1437_ = bool();
                                phi_1438_ = true;
                            }
                            let _e370 = phi_1437_;
                            let _e372 = phi_1438_;
                            phi_1439_ = _e370;
                            phi_1440_ = _e372;
                        } else {
                            phi_1439_ = bool();
                            phi_1440_ = true;
                        }
                        let _e374 = phi_1439_;
                        let _e376 = phi_1440_;
                        if _e376 {
                            phi_1444_ = false;
                        } else {
                            phi_1444_ = _e374;
                        }
                        let _e378 = phi_1444_;
                        let _e385 = lt_math_LightPoint(vec2<f32>(_e300, _e260.uv.y), _e260.depth, _e260.is_inside);
                        let _e392 = lt_math_LightPoint(vec2<f32>(_e385.uv.x, _e314), _e385.depth, _e385.is_inside);
                        let _e396 = lt_math_LightPoint(_e392.uv, _e327, _e392.is_inside);
                        let _e400 = lt_math_LightPoint(_e396.uv, _e396.depth, _e378);
                        phi_1453_ = _e400;
                        phi_1454_ = (_e262 + 1u);
                        phi_1455_ = lt_math_LevelPoint(_e262, _e400);
                        phi_1456_ = true;
                    }
                    let _e404 = phi_1453_;
                    let _e406 = phi_1454_;
                    let _e408 = phi_1455_;
                    let _e410 = phi_1456_;
                    phi_1288_ = _e404;
                    phi_1291_ = _e406;
                    phi_1293_ = _e408;
                    phi_1457_ = _e410;
                } else {
                    phi_1288_ = lt_math_LightPoint();
                    phi_1291_ = u32();
                    phi_1293_ = lt_math_LevelPoint();
                    phi_1457_ = false;
                }
                let _e412 = phi_1288_;
                let _e414 = phi_1291_;
                let _e416 = phi_1293_;
                let _e418 = phi_1457_;
                continue;
                continuing {
                    phi_1287_ = _e412;
                    phi_1290_ = _e414;
                    phi_1292_ = _e416;
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
                            phi_1497_ = (_e432.row_w.z == _e444);
                            phi_1498_ = false;
                        } else {
                            phi_1497_ = bool();
                            phi_1498_ = true;
                        }
                        let _e447 = phi_1497_;
                        let _e449 = phi_1498_;
                        phi_1499_ = _e447;
                        phi_1500_ = _e449;
                    } else {
                        phi_1499_ = bool();
                        phi_1500_ = true;
                    }
                    let _e451 = phi_1499_;
                    let _e453 = phi_1500_;
                    if _e453 {
                        phi_1504_ = false;
                    } else {
                        phi_1504_ = _e451;
                    }
                    let _e455 = phi_1504_;
                    if _e455 {
                        let _e457 = samples.member[(0u + _e63.first_primitive)].normal;
                        let _e459 = p.member.map_size;
                        let _e529 = ((abs(((((_e432.row_x.x * _e457.x) + (_e432.row_x.y * _e457.y)) + (_e432.row_x.z * _e457.z)) / (((_e432.row_x.x * _e432.row_x.x) + (_e432.row_x.y * _e432.row_x.y)) + (_e432.row_x.z * _e432.row_x.z)))) + abs(((((_e432.row_y.x * _e457.x) + (_e432.row_y.y * _e457.y)) + (_e432.row_y.z * _e457.z)) / (((_e432.row_y.x * _e432.row_y.x) + (_e432.row_y.y * _e432.row_y.y)) + (_e432.row_y.z * _e432.row_y.z))))) / (abs(((((_e432.row_z.x * _e457.x) + (_e432.row_z.y * _e457.y)) + (_e432.row_z.z * _e457.z)) / (((_e432.row_z.x * _e432.row_z.x) + (_e432.row_z.y * _e432.row_z.y)) + (_e432.row_z.z * _e432.row_z.z)))) * f32(_e459)));
                        if (_e529 < 0.002f) {
                            phi_1586_ = _e529;
                        } else {
                            phi_1586_ = 0.002f;
                        }
                        let _e532 = phi_1586_;
                        phi_1703_ = _e532;
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
                            phi_1702_ = _e646;
                        } else {
                            phi_1702_ = 0.002f;
                        }
                        let _e649 = phi_1702_;
                        phi_1703_ = _e649;
                    }
                    let _e651 = phi_1703_;
                    phi_1706_ = (_e421.point.depth - (0f * _e651));
                } else {
                    phi_1706_ = _e421.point.depth;
                }
                let _e655 = phi_1706_;
                let _e661 = p.member.map_size;
                let _e662 = f32(_e661);
                let _e665 = ((_e421.point.uv.x * _e662) - 0.5f);
                let _e666 = ((_e421.point.uv.y * _e662) - 0.5f);
                if (_e665 > -8388608f) {
                    let _e678 = f32(select(0i, select(select(i32(_e665), i32(-2147483648), (_e665 < bitcast<f32>(3472883712u))), 2147483647i, (_e665 > bitcast<f32>(1325400063u))), (_e665 == _e665)));
                    if (_e678 > _e665) {
                        phi_1735_ = 1f;
                    } else {
                        phi_1735_ = 0f;
                    }
                    let _e681 = phi_1735_;
                    if (_e665 < 8388608f) {
                        phi_1740_ = (_e678 - _e681);
                        phi_1741_ = false;
                    } else {
                        phi_1740_ = f32();
                        phi_1741_ = true;
                    }
                    let _e684 = phi_1740_;
                    let _e686 = phi_1741_;
                    phi_1742_ = _e684;
                    phi_1743_ = _e686;
                } else {
                    phi_1742_ = f32();
                    phi_1743_ = true;
                }
                let _e688 = phi_1742_;
                let _e690 = phi_1743_;
                if _e690 {
                    phi_1747_ = _e665;
                } else {
                    phi_1747_ = _e688;
                }
                let _e692 = phi_1747_;
                if (_e666 > -8388608f) {
                    let _e704 = f32(select(0i, select(select(i32(_e666), i32(-2147483648), (_e666 < bitcast<f32>(3472883712u))), 2147483647i, (_e666 > bitcast<f32>(1325400063u))), (_e666 == _e666)));
                    if (_e704 > _e666) {
                        phi_1767_ = 1f;
                    } else {
                        phi_1767_ = 0f;
                    }
                    let _e707 = phi_1767_;
                    if (_e666 < 8388608f) {
                        phi_1772_ = (_e704 - _e707);
                        phi_1773_ = false;
                    } else {
                        phi_1772_ = f32();
                        phi_1773_ = true;
                    }
                    let _e710 = phi_1772_;
                    let _e712 = phi_1773_;
                    phi_1774_ = _e710;
                    phi_1775_ = _e712;
                } else {
                    phi_1774_ = f32();
                    phi_1775_ = true;
                }
                let _e714 = phi_1774_;
                let _e716 = phi_1775_;
                if _e716 {
                    phi_1779_ = _e666;
                } else {
                    phi_1779_ = _e714;
                }
                let _e718 = phi_1779_;
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
                    phi_1828_ = _e729;
                } else {
                    phi_1828_ = 0i;
                }
                let _e762 = phi_1828_;
                if (_e738 > 0i) {
                    phi_1833_ = _e738;
                } else {
                    phi_1833_ = 0i;
                }
                let _e765 = phi_1833_;
                if (_e762 < _e759) {
                    phi_1838_ = _e762;
                } else {
                    phi_1838_ = _e759;
                }
                let _e768 = phi_1838_;
                if (_e765 < _e759) {
                    phi_1843_ = _e765;
                } else {
                    phi_1843_ = _e759;
                }
                let _e771 = phi_1843_;
                let _e772 = bitcast<u32>(_e768);
                let _e774 = (_e729 + 1i);
                let _e775 = (_e738 + 1i);
                if (_e774 > 0i) {
                    phi_1852_ = _e774;
                } else {
                    phi_1852_ = 0i;
                }
                let _e778 = phi_1852_;
                if (_e775 > 0i) {
                    phi_1857_ = _e775;
                } else {
                    phi_1857_ = 0i;
                }
                let _e781 = phi_1857_;
                if (_e778 < _e759) {
                    phi_1862_ = _e778;
                } else {
                    phi_1862_ = _e759;
                }
                let _e784 = phi_1862_;
                if (_e781 < _e759) {
                    phi_1867_ = _e781;
                } else {
                    phi_1867_ = _e759;
                }
                let _e787 = phi_1867_;
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
                phi_1912_ = evaluate_Verdict(_e817, false);
                phi_1913_ = evaluate_Verdict();
                phi_1914_ = false;
            } else {
                phi_1912_ = evaluate_Verdict();
                phi_1913_ = evaluate_Verdict(1f, false);
                phi_1914_ = true;
            }
            let _e821 = phi_1912_;
            let _e823 = phi_1913_;
            let _e825 = phi_1914_;
            phi_1915_ = _e823;
            phi_1916_ = _e821;
            phi_1917_ = _e825;
        }
        let _e827 = phi_1915_;
        let _e829 = phi_1916_;
        let _e831 = phi_1917_;
        if _e831 {
            phi_1921_ = _e827;
        } else {
            phi_1921_ = _e829;
        }
        let _e833 = phi_1921_;
        if (_e63.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e63.first_primitive)] = _e833.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_msm_hausdorff_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
