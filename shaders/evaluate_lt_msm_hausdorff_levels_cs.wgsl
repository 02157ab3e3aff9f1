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

struct type_29 {
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

struct type_35 {
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
var<uniform> p: type_29;
@group(0) @binding(2) 
var<storage> map: type_13;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_13;
@group(0) @binding(4) 
var<storage> levels: type_35;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_146_: lt_bvh_traverse_Tree;
    var phi_147_: bool;
    var phi_148_: lt_bvh_traverse_Tree;
    var phi_149_: bool;
    var phi_154_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_146_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_147_ = false;
        } else {
            phi_146_ = lt_bvh_traverse_Tree();
            phi_147_ = true;
        }
        let _e56 = phi_146_;
        let _e58 = phi_147_;
        phi_148_ = _e56;
        phi_149_ = _e58;
    } else {
        phi_148_ = lt_bvh_traverse_Tree();
        phi_149_ = true;
    }
    let _e60 = phi_148_;
    let _e62 = phi_149_;
    if _e62 {
        phi_154_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_154_ = _e60;
    }
    let _e67 = phi_154_;
    return lt_bvh_traverse_Tree(_e67.root, _e67.first_primitive);
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_181_: f32;
    var phi_182_: f32;
    var phi_183_: f32;
    var phi_200_: f32;
    var phi_201_: f32;
    var phi_202_: f32;
    var phi_218_: f32;
    var phi_219_: f32;
    var phi_220_: f32;
    var phi_236_: f32;
    var phi_237_: f32;
    var phi_238_: f32;
    var phi_254_: f32;
    var phi_255_: f32;
    var phi_256_: f32;
    var phi_291_: bool;
    var phi_292_: bool;
    var phi_293_: bool;
    var phi_294_: bool;
    var phi_295_: bool;
    var phi_296_: bool;
    var phi_300_: bool;
    var phi_611_: f32;
    var phi_612_: f32;
    var phi_613_: f32;
    var phi_630_: f32;
    var phi_631_: f32;
    var phi_632_: f32;
    var phi_649_: f32;
    var phi_650_: f32;
    var phi_651_: f32;
    var phi_668_: f32;
    var phi_669_: f32;
    var phi_670_: f32;
    var phi_693_: f32;
    var phi_694_: f32;
    var phi_695_: f32;
    var phi_706_: f32;
    var phi_721_: f32;
    var phi_723_: lt_bvh_slab_Span;
    var phi_781_: f32;
    var phi_782_: f32;
    var phi_783_: f32;
    var phi_784_: f32;
    var phi_785_: f32;
    var phi_786_: bool;
    var phi_790_: f32;
    var phi_800_: bool;
    var phi_813_: bool;
    var phi_817_: bool;
    var phi_818_: bool;
    var phi_828_: bool;
    var phi_829_: bool;
    var phi_830_: bool;
    var phi_834_: bool;
    var phi_885_: f32;
    var phi_886_: f32;
    var phi_887_: f32;
    var phi_904_: f32;
    var phi_905_: f32;
    var phi_906_: f32;
    var phi_923_: f32;
    var phi_924_: f32;
    var phi_925_: f32;
    var phi_942_: f32;
    var phi_943_: f32;
    var phi_944_: f32;
    var phi_967_: f32;
    var phi_968_: f32;
    var phi_969_: f32;
    var phi_1056_: f32;
    var phi_1057_: f32;
    var phi_1068_: bool;
    var phi_1072_: f32;
    var phi_1073_: f32;
    var phi_1088_: f32;
    var phi_1089_: f32;
    var phi_1090_: f32;
    var phi_1091_: f32;
    var phi_1092_: f32;
    var phi_1093_: f32;
    var phi_1094_: f32;
    var phi_1095_: bool;
    var phi_1096_: f32;
    var phi_1097_: f32;
    var phi_1098_: bool;
    var phi_1102_: f32;

    let _e47 = (*param_4);
    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_183_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_182_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_181_ = 1f;
            } else {
                phi_181_ = param_7;
            }
            let _e54 = phi_181_;
            phi_182_ = _e54;
        }
        let _e56 = phi_182_;
        phi_183_ = _e56;
    }
    let _e58 = phi_183_;
    let _e59 = (_e58 - 0.00000047683716f);
    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_202_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_201_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_200_ = 1f;
            } else {
                phi_200_ = param_5.x;
            }
            let _e67 = phi_200_;
            phi_201_ = _e67;
        }
        let _e69 = phi_201_;
        phi_202_ = _e69;
    }
    let _e71 = phi_202_;
    if ((bitcast<u32>(param_5.y) & 2147483647u) > 2139095040u) {
        phi_220_ = param_5.y;
    } else {
        if (param_5.y < 0f) {
            phi_219_ = 0f;
        } else {
            if (param_5.y > 1f) {
                phi_218_ = 1f;
            } else {
                phi_218_ = param_5.y;
            }
            let _e79 = phi_218_;
            phi_219_ = _e79;
        }
        let _e81 = phi_219_;
        phi_220_ = _e81;
    }
    let _e83 = phi_220_;
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_238_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_237_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_236_ = 1f;
            } else {
                phi_236_ = param_5.z;
            }
            let _e91 = phi_236_;
            phi_237_ = _e91;
        }
        let _e93 = phi_237_;
        phi_238_ = _e93;
    }
    let _e95 = phi_238_;
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_256_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_255_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_254_ = 1f;
            } else {
                phi_254_ = param_5.w;
            }
            let _e103 = phi_254_;
            phi_255_ = _e103;
        }
        let _e105 = phi_255_;
        phi_256_ = _e105;
    }
    let _e107 = phi_256_;
    let _e108 = (_e71 - _e59);
    let _e109 = (_e83 - _e59);
    let _e110 = (_e95 - _e59);
    let _e111 = (_e107 - _e59);
    let _e122 = ((((_e108 * param_6.x) + (_e109 * param_6.y)) + (_e110 * param_6.z)) + (_e111 * param_6.w));
    if ((bitcast<u32>(_e122) & 2147483647u) > 2139095040u) {
        phi_1096_ = _e122;
        phi_1097_ = f32();
        phi_1098_ = true;
    } else {
        if (_e108 >= 0f) {
            if (_e109 >= 0f) {
                if (_e110 >= 0f) {
                    phi_291_ = (_e111 >= 0f);
                    phi_292_ = false;
                } else {
                    phi_291_ = bool();
                    phi_292_ = true;
                }
                let _e131 = phi_291_;
                let _e133 = phi_292_;
                phi_293_ = _e131;
                phi_294_ = _e133;
            } else {
                phi_293_ = bool();
                phi_294_ = true;
            }
            let _e135 = phi_293_;
            let _e137 = phi_294_;
            phi_295_ = _e135;
            phi_296_ = _e137;
        } else {
            phi_295_ = bool();
            phi_296_ = true;
        }
        let _e139 = phi_295_;
        let _e141 = phi_296_;
        if _e141 {
            phi_300_ = false;
        } else {
            phi_300_ = _e139;
        }
        let _e143 = phi_300_;
        if _e143 {
            phi_1093_ = 1f;
            phi_1094_ = f32();
            phi_1095_ = true;
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
                    phi_613_ = _e108;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_612_ = 0f;
                    } else {
                        if (_e108 < 0f) {
                            phi_611_ = 0f;
                        } else {
                            phi_611_ = 1f;
                        }
                        let _e440 = phi_611_;
                        phi_612_ = _e440;
                    }
                    let _e442 = phi_612_;
                    phi_613_ = _e442;
                }
                let _e444 = phi_613_;
                if ((bitcast<u32>(_e109) & 2147483647u) > 2139095040u) {
                    phi_632_ = _e109;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_631_ = 0f;
                    } else {
                        if (_e109 < 0f) {
                            phi_630_ = 0f;
                        } else {
                            phi_630_ = 1f;
                        }
                        let _e453 = phi_630_;
                        phi_631_ = _e453;
                    }
                    let _e455 = phi_631_;
                    phi_632_ = _e455;
                }
                let _e457 = phi_632_;
                if ((bitcast<u32>(_e110) & 2147483647u) > 2139095040u) {
                    phi_651_ = _e110;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_650_ = 0f;
                    } else {
                        if (_e110 < 0f) {
                            phi_649_ = 0f;
                        } else {
                            phi_649_ = 1f;
                        }
                        let _e466 = phi_649_;
                        phi_650_ = _e466;
                    }
                    let _e468 = phi_650_;
                    phi_651_ = _e468;
                }
                let _e470 = phi_651_;
                if ((bitcast<u32>(_e111) & 2147483647u) > 2139095040u) {
                    phi_670_ = _e111;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_669_ = 0f;
                    } else {
                        if (_e111 < 0f) {
                            phi_668_ = 0f;
                        } else {
                            phi_668_ = 1f;
                        }
                        let _e479 = phi_668_;
                        phi_669_ = _e479;
                    }
                    let _e481 = phi_669_;
                    phi_670_ = _e481;
                }
                let _e483 = phi_670_;
                let _e491 = (((((_e444 * _e147) + (_e457 * _e149)) + (_e470 * _e151)) + (_e483 * _e153)) + _e144);
                if ((bitcast<u32>(_e491) & 2147483647u) > 2139095040u) {
                    phi_695_ = _e491;
                } else {
                    if (_e491 < 0f) {
                        phi_694_ = 0f;
                    } else {
                        if (_e491 > 1f) {
                            phi_693_ = 1f;
                        } else {
                            phi_693_ = _e491;
                        }
                        let _e498 = phi_693_;
                        phi_694_ = _e498;
                    }
                    let _e500 = phi_694_;
                    phi_695_ = _e500;
                }
                let _e502 = phi_695_;
                phi_1091_ = _e502;
                phi_1092_ = f32();
            } else {
                let _e504 = ((0.5f * -(((((((((_e208 * (_e108 + _e109)) + (_e212 * (_e108 + _e110))) + (_e236 * (_e108 + _e154))) + (_e248 * (_e108 + _e155))) + ((((_e209 * (_e109 + _e110)) + (_e213 * (_e109 + _e111))) + (_e237 * (_e109 + _e154))) + (_e249 * (_e109 + _e155)))) + ((((_e210 * (_e110 + _e111)) + (_e214 * (_e110 + _e108))) + (_e238 * (_e110 + _e154))) + (_e250 * (_e110 + _e155)))) + ((((_e211 * (_e111 + _e108)) + (_e215 * (_e111 + _e109))) + (_e239 * (_e111 + _e154))) + (_e251 * (_e111 + _e155)))) + (_e422 * (_e154 + _e155))))) / _e425);
                let _e505 = ((((((((_e208 + _e212) + _e236) + _e248) + (((_e209 + _e213) + _e237) + _e249)) + (((_e210 + _e214) + _e238) + _e250)) + (((_e211 + _e215) + _e239) + _e251)) + _e422) / _e425);
                let _e507 = ((_e504 * _e504) - _e505);
                if (_e507 > 0f) {
                    phi_706_ = sqrt(_e507);
                } else {
                    phi_706_ = 0f;
                }
                let _e511 = phi_706_;
                if (_e504 > 0f) {
                    let _e514 = (-(_e504) - _e511);
                    phi_723_ = lt_bvh_slab_Span(_e514, (_e505 / _e514));
                } else {
                    let _e517 = (_e511 - _e504);
                    if (_e517 > 0f) {
                        phi_721_ = (_e505 / _e517);
                    } else {
                        phi_721_ = 0f;
                    }
                    let _e521 = phi_721_;
                    phi_723_ = lt_bvh_slab_Span(_e521, _e517);
                }
                let _e524 = phi_723_;
                if (_e524.near >= 0f) {
                    phi_784_ = 1f;
                    phi_785_ = f32();
                    phi_786_ = true;
                } else {
                    let _e528 = (_e524.far <= 0f);
                    if _e528 {
                        phi_782_ = (_e419 / _e425);
                        phi_783_ = f32();
                    } else {
                        let _e539 = (((((_e147 * _e108) + (_e149 * _e109)) + (_e151 * _e110)) + (_e153 * _e111)) + (_e144 * (_e154 + _e155)));
                        let _e555 = (((((_e147 * (_e108 * _e108)) + (_e149 * (_e109 * _e109))) + (_e151 * (_e110 * _e110))) + (_e153 * (_e111 * _e111))) + (_e144 * ((_e154 * _e154) + (_e155 * _e155))));
                        if (-(_e524.near) <= _e524.far) {
                            phi_781_ = (1f - (((_e524.near * _e524.near) * ((_e524.far * _e555) - _e539)) / (_e524.far - _e524.near)));
                        } else {
                            phi_781_ = ((_e419 / _e425) + (((_e524.far * _e524.far) * (_e539 - (_e524.near * _e555))) / (_e524.far - _e524.near)));
                        }
                        let _e574 = phi_781_;
                        phi_782_ = f32();
                        phi_783_ = _e574;
                    }
                    let _e576 = phi_782_;
                    let _e578 = phi_783_;
                    phi_784_ = _e576;
                    phi_785_ = _e578;
                    phi_786_ = _e528;
                }
                let _e580 = phi_784_;
                let _e582 = phi_785_;
                let _e584 = phi_786_;
                if _e584 {
                    phi_790_ = _e580;
                } else {
                    phi_790_ = _e582;
                }
                let _e586 = phi_790_;
                if ((_e524.near * _e154) >= (1f - 0.00001f)) {
                    phi_800_ = true;
                } else {
                    phi_800_ = ((_e524.near * _e155) >= (1f - 0.00001f));
                }
                let _e594 = phi_800_;
                if _e594 {
                    if ((_e524.far * _e154) >= (1f - 0.00001f)) {
                        phi_813_ = true;
                    } else {
                        phi_813_ = ((_e524.far * _e155) >= (1f - 0.00001f));
                    }
                    let _e602 = phi_813_;
                    if _e602 {
                        phi_817_ = false;
                    } else {
                        phi_817_ = true;
                    }
                    let _e604 = phi_817_;
                    phi_818_ = _e604;
                } else {
                    phi_818_ = true;
                }
                let _e606 = phi_818_;
                if _e606 {
                    let _e608 = (-(_e154) < 0.0001f);
                    if _e608 {
                        phi_828_ = bool();
                    } else {
                        phi_828_ = (_e155 < 0.0001f);
                    }
                    let _e611 = phi_828_;
                    phi_829_ = _e611;
                    phi_830_ = _e608;
                } else {
                    phi_829_ = bool();
                    phi_830_ = true;
                }
                let _e613 = phi_829_;
                let _e615 = phi_830_;
                if _e615 {
                    phi_834_ = true;
                } else {
                    phi_834_ = _e613;
                }
                let _e617 = phi_834_;
                if !(_e617) {
                    let _e623 = ((_e147 * _e71) * _e157);
                    let _e624 = ((_e149 * _e83) * _e159);
                    let _e625 = ((_e151 * _e95) * _e161);
                    let _e626 = ((_e153 * _e107) * _e163);
                    let _e644 = ((((_e623 * (_e108 * _e108)) + (_e624 * (_e109 * _e109))) + (_e625 * (_e110 * _e110))) + (_e626 * (_e111 * _e111)));
                    if (_e644 < 0.0000000000000000000000000000000001f) {
                        if ((bitcast<u32>(_e108) & 2147483647u) > 2139095040u) {
                            phi_887_ = _e108;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_886_ = 0f;
                            } else {
                                if (_e108 < 0f) {
                                    phi_885_ = 0f;
                                } else {
                                    phi_885_ = 1f;
                                }
                                let _e654 = phi_885_;
                                phi_886_ = _e654;
                            }
                            let _e656 = phi_886_;
                            phi_887_ = _e656;
                        }
                        let _e658 = phi_887_;
                        if ((bitcast<u32>(_e109) & 2147483647u) > 2139095040u) {
                            phi_906_ = _e109;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_905_ = 0f;
                            } else {
                                if (_e109 < 0f) {
                                    phi_904_ = 0f;
                                } else {
                                    phi_904_ = 1f;
                                }
                                let _e667 = phi_904_;
                                phi_905_ = _e667;
                            }
                            let _e669 = phi_905_;
                            phi_906_ = _e669;
                        }
                        let _e671 = phi_906_;
                        if ((bitcast<u32>(_e110) & 2147483647u) > 2139095040u) {
                            phi_925_ = _e110;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_924_ = 0f;
                            } else {
                                if (_e110 < 0f) {
                                    phi_923_ = 0f;
                                } else {
                                    phi_923_ = 1f;
                                }
                                let _e680 = phi_923_;
                                phi_924_ = _e680;
                            }
                            let _e682 = phi_924_;
                            phi_925_ = _e682;
                        }
                        let _e684 = phi_925_;
                        if ((bitcast<u32>(_e111) & 2147483647u) > 2139095040u) {
                            phi_944_ = _e111;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_943_ = 0f;
                            } else {
                                if (_e111 < 0f) {
                                    phi_942_ = 0f;
                                } else {
                                    phi_942_ = 1f;
                                }
                                let _e693 = phi_942_;
                                phi_943_ = _e693;
                            }
                            let _e695 = phi_943_;
                            phi_944_ = _e695;
                        }
                        let _e697 = phi_944_;
                        let _e705 = (((((_e658 * _e147) + (_e671 * _e149)) + (_e684 * _e151)) + (_e697 * _e153)) + _e144);
                        if ((bitcast<u32>(_e705) & 2147483647u) > 2139095040u) {
                            phi_969_ = _e705;
                        } else {
                            if (_e705 < 0f) {
                                phi_968_ = 0f;
                            } else {
                                if (_e705 > 1f) {
                                    phi_967_ = 1f;
                                } else {
                                    phi_967_ = _e705;
                                }
                                let _e712 = phi_967_;
                                phi_968_ = _e712;
                            }
                            let _e714 = phi_968_;
                            phi_969_ = _e714;
                        }
                        let _e716 = phi_969_;
                        phi_1057_ = _e716;
                    } else {
                        let _e717 = (((((_e623 * _e108) + (_e624 * _e109)) + (_e625 * _e110)) + (_e626 * _e111)) / _e644);
                        let _e734 = ((_e147 * _e108) * (vec4<f32>(1f, 1f, 1f, 1f).x - (_e717 * _e108)));
                        let _e735 = ((_e149 * _e109) * (vec4<f32>(1f, 1f, 1f, 1f).y - (_e717 * _e109)));
                        let _e736 = ((_e151 * _e110) * (vec4<f32>(1f, 1f, 1f, 1f).z - (_e717 * _e110)));
                        let _e737 = ((_e153 * _e111) * (vec4<f32>(1f, 1f, 1f, 1f).w - (_e717 * _e111)));
                        if (_e717 > 0f) {
                            phi_1056_ = ((1f - _e144) - (((((_e734 * _e157) + (_e735 * _e159)) + (_e736 * _e161)) + (_e737 * _e163)) / (_e154 * (1f - (_e154 * _e717)))));
                        } else {
                            phi_1056_ = ((((((((_e623 * ((_e624 * _e168) + ((0.5f * _e625) * _e176))) * vec4<f32>(1f, 1f, 1f, 1f).x) + ((_e624 * ((_e625 * _e169) + ((0.5f * _e626) * _e177))) * vec4<f32>(1f, 1f, 1f, 1f).y)) + ((_e625 * ((_e626 * _e170) + ((0.5f * _e623) * _e178))) * vec4<f32>(1f, 1f, 1f, 1f).z)) + ((_e626 * ((_e623 * _e171) + ((0.5f * _e624) * _e179))) * vec4<f32>(1f, 1f, 1f, 1f).w)) / (_e644 * (-(_e154) * _e155))) + _e144) + (((((_e734 * _e71) + (_e735 * _e83)) + (_e736 * _e95)) + (_e737 * _e107)) / (_e155 * (1f - (_e717 * _e155)))));
                        }
                        let _e801 = phi_1056_;
                        phi_1057_ = _e801;
                    }
                    let _e803 = phi_1057_;
                    if ((bitcast<u32>(_e586) & 2147483647u) > 2139095040u) {
                        phi_1068_ = true;
                    } else {
                        let _e807 = (_e586 < _e803);
                        if _e807 {
                        }
                        phi_1068_ = _e807;
                    }
                    let _e809 = phi_1068_;
                    if _e809 {
                        phi_1072_ = _e586;
                    } else {
                        phi_1072_ = _e803;
                    }
                    let _e811 = phi_1072_;
                    phi_1073_ = _e811;
                } else {
                    phi_1073_ = _e586;
                }
                let _e813 = phi_1073_;
                if ((bitcast<u32>(_e813) & 2147483647u) > 2139095040u) {
                    phi_1090_ = _e813;
                } else {
                    if (_e813 < 0f) {
                        phi_1089_ = 0f;
                    } else {
                        if (_e813 > 1f) {
                            phi_1088_ = 1f;
                        } else {
                            phi_1088_ = _e813;
                        }
                        let _e820 = phi_1088_;
                        phi_1089_ = _e820;
                    }
                    let _e822 = phi_1089_;
                    phi_1090_ = _e822;
                }
                let _e824 = phi_1090_;
                phi_1091_ = f32();
                phi_1092_ = _e824;
            }
            let _e826 = phi_1091_;
            let _e828 = phi_1092_;
            phi_1093_ = _e826;
            phi_1094_ = _e828;
            phi_1095_ = _e431;
        }
        let _e830 = phi_1093_;
        let _e832 = phi_1094_;
        let _e834 = phi_1095_;
        phi_1096_ = _e830;
        phi_1097_ = _e832;
        phi_1098_ = _e834;
    }
    let _e836 = phi_1096_;
    let _e838 = phi_1097_;
    let _e840 = phi_1098_;
    if _e840 {
        phi_1102_ = _e836;
    } else {
        phi_1102_ = _e838;
    }
    let _e842 = phi_1102_;
    return _e842;
}

fn function_() {
    var local: f32;
    var phi_1163_: bool;
    var phi_1164_: bool;
    var phi_1165_: bool;
    var phi_1166_: bool;
    var phi_1170_: bool;
    var phi_1214_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1218_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1238_: lt_math_LightPoint;
    var phi_1241_: u32;
    var phi_1243_: lt_math_LevelPoint;
    var phi_1329_: bool;
    var phi_1338_: bool;
    var phi_1347_: bool;
    var phi_1348_: bool;
    var phi_1349_: bool;
    var phi_1350_: bool;
    var phi_1351_: bool;
    var phi_1352_: bool;
    var phi_1353_: bool;
    var phi_1357_: bool;
    var phi_1384_: bool;
    var phi_1385_: bool;
    var phi_1386_: bool;
    var phi_1387_: bool;
    var phi_1388_: bool;
    var phi_1389_: bool;
    var phi_1390_: bool;
    var phi_1391_: bool;
    var phi_1395_: bool;
    var phi_1404_: lt_math_LightPoint;
    var phi_1405_: u32;
    var phi_1406_: lt_math_LevelPoint;
    var phi_1407_: bool;
    var phi_1239_: lt_math_LightPoint;
    var phi_1242_: u32;
    var phi_1244_: lt_math_LevelPoint;
    var phi_1408_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_1448_: bool;
    var phi_1449_: bool;
    var phi_1450_: bool;
    var phi_1451_: bool;
    var phi_1455_: bool;
    var phi_1537_: f32;
    var phi_1653_: f32;
    var phi_1654_: f32;
    var phi_1657_: f32;
    var phi_1686_: f32;
    var phi_1691_: f32;
    var phi_1692_: bool;
    var phi_1693_: f32;
    var phi_1694_: bool;
    var phi_1698_: f32;
    var phi_1718_: f32;
    var phi_1723_: f32;
    var phi_1724_: bool;
    var phi_1725_: f32;
    var phi_1726_: bool;
    var phi_1730_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_1779_: i32;
    var phi_1784_: i32;
    var phi_1789_: i32;
    var phi_1794_: i32;
    var phi_1803_: i32;
    var phi_1808_: i32;
    var phi_1813_: i32;
    var phi_1818_: i32;
    var phi_1869_: bool;
    var phi_1877_: bool;
    var phi_1889_: bool;
    var phi_1890_: bool;
    var phi_1894_: f32;
    var phi_1900_: f32;
    var phi_1902_: evaluate_Verdict;
    var phi_1907_: evaluate_Verdict;
    var phi_1908_: evaluate_Verdict;

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
        let _e74 = p.member.light;
        let _e77 = samples.member[(0u + _e63.first_primitive)].normal[0u];
        let _e79 = global[0u];
        if (_e77 == _e79) {
            let _e82 = samples.member[(0u + _e63.first_primitive)].normal[1u];
            let _e84 = global[1u];
            if (_e82 == _e84) {
                let _e87 = samples.member[(0u + _e63.first_primitive)].normal[2u];
                let _e89 = global[2u];
                phi_1163_ = (_e87 == _e89);
                phi_1164_ = false;
            } else {
                phi_1163_ = bool();
                phi_1164_ = true;
            }
            let _e92 = phi_1163_;
            let _e94 = phi_1164_;
            phi_1165_ = _e92;
            phi_1166_ = _e94;
        } else {
            phi_1165_ = bool();
            phi_1166_ = true;
        }
        let _e96 = phi_1165_;
        let _e98 = phi_1166_;
        if _e98 {
            phi_1170_ = false;
        } else {
            phi_1170_ = _e96;
        }
        let _e100 = phi_1170_;
        if !(_e100) {
            let _e103 = samples.member[(0u + _e63.first_primitive)].normal;
            let _e105 = samples.member[(0u + _e63.first_primitive)].position;
            if ((((_e103.x * (_e74.x - (_e105.x * _e74.w))) + (_e103.y * (_e74.y - (_e105.y * _e74.w)))) + (_e103.z * (_e74.z - (_e105.z * _e74.w)))) > 0f) {
                let _e129 = samples.member[(0u + _e63.first_primitive)].flags;
                let _e137 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e143 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e137.unnamed.visibility, false), _e137.unnamed_1);
                phi_1214_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e143.unnamed, ((_e129 & 1u) == 0u));
            } else {
                let _e152 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e158 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e152.unnamed.visibility, false), _e152.unnamed_1);
                phi_1214_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e158.unnamed, true);
            }
            let _e163 = phi_1214_;
            phi_1218_ = _e163;
        } else {
            let _e169 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e175 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e169.unnamed.visibility, false), _e169.unnamed_1);
            phi_1218_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e175.unnamed, true);
        }
        let _e180 = phi_1218_;
        if _e180.unnamed_1 {
            phi_1908_ = evaluate_Verdict(_e180.unnamed.visibility, _e180.unnamed.is_doubted);
        } else {
            let _e188 = samples.member[(0u + _e63.first_primitive)].position;
            let _e190 = p.member.map_size;
            let _e192 = (0.5f / f32(_e190));
            let _e199 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e206 = lt_math_LightPoint(vec2<f32>(_e199.uv.x, 0f), _e199.depth, _e199.is_inside);
            let _e210 = lt_math_LightPoint(_e206.uv, 0f, _e206.is_inside);
            phi_1238_ = lt_math_LightPoint();
            phi_1241_ = 0u;
            phi_1243_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e210.uv, _e210.depth, false));
            loop {
                let _e217 = phi_1238_;
                let _e219 = phi_1241_;
                let _e221 = phi_1243_;
                local_1 = _e221;
                local_2 = _e221;
                local_3 = _e221;
                if (_e219 < _e69) {
                    if _e221.point.is_inside {
                        phi_1404_ = lt_math_LightPoint();
                        phi_1405_ = u32();
                        phi_1406_ = lt_math_LevelPoint();
                        phi_1407_ = false;
                    } else {
                        if (_e219 < _e57) {
                        } else {
                            return;
                        }
                        let _e232 = levels.member[(0u + _e219)].row_w;
                        let _e243 = ((((_e232.x * _e188.x) + (_e232.y * _e188.y)) + (_e232.z * _e188.z)) + (_e232.w * 1f));
                        let _e245 = levels.member[(0u + _e219)].row_x;
                        let _e257 = (((((_e245.x * _e188.x) + (_e245.y * _e188.y)) + (_e245.z * _e188.z)) + (_e245.w * 1f)) / _e243);
                        let _e259 = levels.member[(0u + _e219)].row_y;
                        let _e271 = (((((_e259.x * _e188.x) + (_e259.y * _e188.y)) + (_e259.z * _e188.z)) + (_e259.w * 1f)) / _e243);
                        let _e273 = levels.member[(0u + _e219)].row_z;
                        let _e284 = ((((_e273.x * _e188.x) + (_e273.y * _e188.y)) + (_e273.z * _e188.z)) + (_e273.w * 1f));
                        if (_e243 > 0f) {
                            if (_e257 >= 0f) {
                                phi_1329_ = (_e257 <= 1f);
                            } else {
                                phi_1329_ = false;
                            }
                            let _e289 = phi_1329_;
                            if _e289 {
                                if (_e271 >= 0f) {
                                    phi_1338_ = (_e271 <= 1f);
                                } else {
                                    phi_1338_ = false;
                                }
                                let _e293 = phi_1338_;
                                if _e293 {
                                    if (_e284 >= 0f) {
                                        phi_1347_ = (_e284 <= 1f);
                                    } else {
                                        phi_1347_ = false;
                                    }
                                    let _e297 = phi_1347_;
                                    phi_1348_ = _e297;
                                    phi_1349_ = false;
                                } else {
                                    phi_1348_ = bool();
                                    phi_1349_ = true;
                                }
                                let _e299 = phi_1348_;
                                let _e301 = phi_1349_;
                                phi_1350_ = _e299;
                                phi_1351_ = _e301;
                            } else {
                                phi_1350_ = bool();
                                phi_1351_ = true;
                            }
                            let _e303 = phi_1350_;
                            let _e305 = phi_1351_;
                            phi_1352_ = _e303;
                            phi_1353_ = _e305;
                        } else {
                            phi_1352_ = bool();
                            phi_1353_ = true;
                        }
                        let _e307 = phi_1352_;
                        let _e309 = phi_1353_;
                        if _e309 {
                            phi_1357_ = false;
                        } else {
                            phi_1357_ = _e307;
                        }
                        let _e311 = phi_1357_;
                        if _e311 {
                            if (_e257 >= _e192) {
                                if (_e257 <= (1f - _e192)) {
                                    if (_e271 >= _e192) {
                                        phi_1384_ = (_e271 <= (1f - _e192));
                                        phi_1385_ = false;
                                    } else {
                                        phi_1384_ = bool();
                                        phi_1385_ = true;
                                    }
                                    let _e319 = phi_1384_;
                                    let _e321 = phi_1385_;
                                    phi_1386_ = _e319;
                                    phi_1387_ = _e321;
                                } else {
                                    phi_1386_ = bool();
                                    phi_1387_ = true;
                                }
                                let _e323 = phi_1386_;
                                let _e325 = phi_1387_;
                                phi_1388_ = _e323;
                                phi_1389_ = _e325;
                            } else {
                                phi_1388_ = bool();
                                phi_1389_ = true;
                            }
                            let _e327 = phi_1388_;
                            let _e329 = phi_1389_;
                            phi_1390_ = _e327;
                            phi_1391_ = _e329;
                        } else {
                            phi_1390_ = bool();
                            phi_1391_ = true;
                        }
                        let _e331 = phi_1390_;
                        let _e333 = phi_1391_;
                        if _e333 {
                            phi_1395_ = false;
                        } else {
                            phi_1395_ = _e331;
                        }
                        let _e335 = phi_1395_;
                        let _e342 = lt_math_LightPoint(vec2<f32>(_e257, _e217.uv.y), _e217.depth, _e217.is_inside);
                        let _e349 = lt_math_LightPoint(vec2<f32>(_e342.uv.x, _e271), _e342.depth, _e342.is_inside);
                        let _e353 = lt_math_LightPoint(_e349.uv, _e284, _e349.is_inside);
                        let _e357 = lt_math_LightPoint(_e353.uv, _e353.depth, _e335);
                        phi_1404_ = _e357;
                        phi_1405_ = (_e219 + 1u);
                        phi_1406_ = lt_math_LevelPoint(_e219, _e357);
                        phi_1407_ = true;
                    }
                    let _e361 = phi_1404_;
                    let _e363 = phi_1405_;
                    let _e365 = phi_1406_;
                    let _e367 = phi_1407_;
                    phi_1239_ = _e361;
                    phi_1242_ = _e363;
                    phi_1244_ = _e365;
                    phi_1408_ = _e367;
                } else {
                    phi_1239_ = lt_math_LightPoint();
                    phi_1242_ = u32();
                    phi_1244_ = lt_math_LevelPoint();
                    phi_1408_ = false;
                }
                let _e369 = phi_1239_;
                let _e371 = phi_1242_;
                let _e373 = phi_1244_;
                let _e375 = phi_1408_;
                continue;
                continuing {
                    phi_1238_ = _e369;
                    phi_1241_ = _e371;
                    phi_1243_ = _e373;
                    break if !(_e375);
                }
            }
            let _e378 = local_1;
            if _e378.point.is_inside {
                if (0f > 0f) {
                    let _e384 = local_2;
                    if (_e384.level < _e57) {
                    } else {
                        return;
                    }
                    let _e389 = levels.member[(0u + _e384.level)];
                    let _e395 = global[0u];
                    if (_e389.row_w.x == _e395) {
                        let _e398 = global[1u];
                        if (_e389.row_w.y == _e398) {
                            let _e401 = global[2u];
                            phi_1448_ = (_e389.row_w.z == _e401);
                            phi_1449_ = false;
                        } else {
                            phi_1448_ = bool();
                            phi_1449_ = true;
                        }
                        let _e404 = phi_1448_;
                        let _e406 = phi_1449_;
                        phi_1450_ = _e404;
                        phi_1451_ = _e406;
                    } else {
                        phi_1450_ = bool();
                        phi_1451_ = true;
                    }
                    let _e408 = phi_1450_;
                    let _e410 = phi_1451_;
                    if _e410 {
                        phi_1455_ = false;
                    } else {
                        phi_1455_ = _e408;
                    }
                    let _e412 = phi_1455_;
                    if _e412 {
                        let _e414 = samples.member[(0u + _e63.first_primitive)].normal;
                        let _e416 = p.member.map_size;
                        let _e486 = ((abs(((((_e389.row_x.x * _e414.x) + (_e389.row_x.y * _e414.y)) + (_e389.row_x.z * _e414.z)) / (((_e389.row_x.x * _e389.row_x.x) + (_e389.row_x.y * _e389.row_x.y)) + (_e389.row_x.z * _e389.row_x.z)))) + abs(((((_e389.row_y.x * _e414.x) + (_e389.row_y.y * _e414.y)) + (_e389.row_y.z * _e414.z)) / (((_e389.row_y.x * _e389.row_y.x) + (_e389.row_y.y * _e389.row_y.y)) + (_e389.row_y.z * _e389.row_y.z))))) / (abs(((((_e389.row_z.x * _e414.x) + (_e389.row_z.y * _e414.y)) + (_e389.row_z.z * _e414.z)) / (((_e389.row_z.x * _e389.row_z.x) + (_e389.row_z.y * _e389.row_z.y)) + (_e389.row_z.z * _e389.row_z.z)))) * f32(_e416)));
                        if (_e486 < 0.002f) {
                            phi_1537_ = _e486;
                        } else {
                            phi_1537_ = 0.002f;
                        }
                        let _e489 = phi_1537_;
                        phi_1654_ = _e489;
                    } else {
                        let _e491 = p.member.map_size;
                        let _e497 = samples.member[(0u + _e63.first_primitive)].position;
                        let _e508 = ((((_e389.row_w.x * _e497.x) + (_e389.row_w.y * _e497.y)) + (_e389.row_w.z * _e497.z)) + _e389.row_w.w);
                        let _e521 = ((_e389.row_x.x - (_e389.row_w.x * _e378.point.uv.x)) / _e508);
                        let _e522 = ((_e389.row_x.y - (_e389.row_w.y * _e378.point.uv.x)) / _e508);
                        let _e523 = ((_e389.row_x.z - (_e389.row_w.z * _e378.point.uv.x)) / _e508);
                        let _e536 = ((_e389.row_y.x - (_e389.row_w.x * _e378.point.uv.y)) / _e508);
                        let _e537 = ((_e389.row_y.y - (_e389.row_w.y * _e378.point.uv.y)) / _e508);
                        let _e538 = ((_e389.row_y.z - (_e389.row_w.z * _e378.point.uv.y)) / _e508);
                        let _e544 = samples.member[(0u + _e63.first_primitive)].normal;
                        let _e549 = ((_e537 * _e544.z) - (_e544.y * _e538));
                        let _e554 = ((_e538 * _e544.x) - (_e544.z * _e536));
                        let _e559 = ((_e536 * _e544.y) - (_e544.x * _e537));
                        let _e561 = samples.member[(0u + _e63.first_primitive)].normal;
                        let _e566 = ((_e522 * _e561.z) - (_e561.y * _e523));
                        let _e571 = ((_e523 * _e561.x) - (_e561.z * _e521));
                        let _e576 = ((_e521 * _e561.y) - (_e561.x * _e522));
                        let _e603 = ((abs(((((_e389.row_z.x * _e549) + (_e389.row_z.y * _e554)) + (_e389.row_z.z * _e559)) / (((_e521 * _e549) + (_e522 * _e554)) + (_e523 * _e559)))) + abs(((((_e389.row_z.x * _e566) + (_e389.row_z.y * _e571)) + (_e389.row_z.z * _e576)) / (((_e536 * _e566) + (_e537 * _e571)) + (_e538 * _e576))))) / f32(_e491));
                        if (_e603 < 0.002f) {
                            phi_1653_ = _e603;
                        } else {
                            phi_1653_ = 0.002f;
                        }
                        let _e606 = phi_1653_;
                        phi_1654_ = _e606;
                    }
                    let _e608 = phi_1654_;
                    phi_1657_ = (_e378.point.depth - (0f * _e608));
                } else {
                    phi_1657_ = _e378.point.depth;
                }
                let _e612 = phi_1657_;
                let _e618 = p.member.map_size;
                let _e619 = f32(_e618);
                let _e622 = ((_e378.point.uv.x * _e619) - 0.5f);
                let _e623 = ((_e378.point.uv.y * _e619) - 0.5f);
                if (_e622 > -8388608f) {
                    let _e635 = f32(select(0i, select(select(i32(_e622), i32(-2147483648), (_e622 < bitcast<f32>(3472883712u))), 2147483647i, (_e622 > bitcast<f32>(1325400063u))), (_e622 == _e622)));
                    if (_e635 > _e622) {
                        phi_1686_ = 1f;
                    } else {
                        phi_1686_ = 0f;
                    }
                    let _e638 = phi_1686_;
                    if (_e622 < 8388608f) {
                        phi_1691_ = (_e635 - _e638);
                        phi_1692_ = false;
                    } else {
                        phi_1691_ = f32();
                        phi_1692_ = true;
                    }
                    let _e641 = phi_1691_;
                    let _e643 = phi_1692_;
                    phi_1693_ = _e641;
                    phi_1694_ = _e643;
                } else {
                    phi_1693_ = f32();
                    phi_1694_ = true;
                }
                let _e645 = phi_1693_;
                let _e647 = phi_1694_;
                if _e647 {
                    phi_1698_ = _e622;
                } else {
                    phi_1698_ = _e645;
                }
                let _e649 = phi_1698_;
                if (_e623 > -8388608f) {
                    let _e661 = f32(select(0i, select(select(i32(_e623), i32(-2147483648), (_e623 < bitcast<f32>(3472883712u))), 2147483647i, (_e623 > bitcast<f32>(1325400063u))), (_e623 == _e623)));
                    if (_e661 > _e623) {
                        phi_1718_ = 1f;
                    } else {
                        phi_1718_ = 0f;
                    }
                    let _e664 = phi_1718_;
                    if (_e623 < 8388608f) {
                        phi_1723_ = (_e661 - _e664);
                        phi_1724_ = false;
                    } else {
                        phi_1723_ = f32();
                        phi_1724_ = true;
                    }
                    let _e667 = phi_1723_;
                    let _e669 = phi_1724_;
                    phi_1725_ = _e667;
                    phi_1726_ = _e669;
                } else {
                    phi_1725_ = f32();
                    phi_1726_ = true;
                }
                let _e671 = phi_1725_;
                let _e673 = phi_1726_;
                if _e673 {
                    phi_1730_ = _e623;
                } else {
                    phi_1730_ = _e671;
                }
                let _e675 = phi_1730_;
                let _e676 = (_e622 - _e649);
                let _e677 = (_e623 - _e675);
                let _e686 = select(0i, select(select(i32(_e649), i32(-2147483648), (_e649 < bitcast<f32>(3472883712u))), 2147483647i, (_e649 > bitcast<f32>(1325400063u))), (_e649 == _e649));
                let _e695 = select(0i, select(select(i32(_e675), i32(-2147483648), (_e675 < bitcast<f32>(3472883712u))), 2147483647i, (_e675 > bitcast<f32>(1325400063u))), (_e675 == _e675));
                let _e706 = p.member.test;
                let _e707 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e706);
                let _e709 = p.member.map_size;
                let _e711 = local_3;
                local = _e707;
                let _e714 = ((_e711.level * _e709) * _e709);
                let _e716 = (bitcast<i32>(_e709) - 1i);
                if (_e686 > 0i) {
                    phi_1779_ = _e686;
                } else {
                    phi_1779_ = 0i;
                }
                let _e719 = phi_1779_;
                if (_e695 > 0i) {
                    phi_1784_ = _e695;
                } else {
                    phi_1784_ = 0i;
                }
                let _e722 = phi_1784_;
                if (_e719 < _e716) {
                    phi_1789_ = _e719;
                } else {
                    phi_1789_ = _e716;
                }
                let _e725 = phi_1789_;
                if (_e722 < _e716) {
                    phi_1794_ = _e722;
                } else {
                    phi_1794_ = _e716;
                }
                let _e728 = phi_1794_;
                let _e729 = bitcast<u32>(_e725);
                let _e731 = (_e686 + 1i);
                let _e732 = (_e695 + 1i);
                if (_e731 > 0i) {
                    phi_1803_ = _e731;
                } else {
                    phi_1803_ = 0i;
                }
                let _e735 = phi_1803_;
                if (_e732 > 0i) {
                    phi_1808_ = _e732;
                } else {
                    phi_1808_ = 0i;
                }
                let _e738 = phi_1808_;
                if (_e735 < _e716) {
                    phi_1813_ = _e735;
                } else {
                    phi_1813_ = _e716;
                }
                let _e741 = phi_1813_;
                if (_e738 < _e716) {
                    phi_1818_ = _e738;
                } else {
                    phi_1818_ = _e716;
                }
                let _e744 = phi_1818_;
                let _e745 = bitcast<u32>(_e741);
                let _e747 = (bitcast<u32>(_e728) * _e709);
                let _e748 = (bitcast<u32>(_e744) * _e709);
                let _e753 = ((_e747 + _e729) + _e714);
                let _e754 = ((_e747 + _e745) + _e714);
                let _e755 = ((_e748 + _e729) + _e714);
                let _e756 = ((_e748 + _e745) + _e714);
                if (_e753 < _e51) {
                } else {
                    return;
                }
                let _e760 = map.member[(0u + _e753)];
                if (_e754 < _e51) {
                } else {
                    return;
                }
                let _e764 = map.member[(0u + _e754)];
                if (_e755 < _e51) {
                } else {
                    return;
                }
                let _e768 = map.member[(0u + _e755)];
                if (_e756 < _e51) {
                } else {
                    return;
                }
                let _e772 = map.member[(0u + _e756)];
                let _e774 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e760, _e764, _e768, _e772), vec4<f32>(((1f - _e676) * (1f - _e677)), (_e676 * (1f - _e677)), ((1f - _e676) * _e677), (_e676 * _e677)), _e612);
                let _e776 = p.member.epsilon;
                if (_e774 <= _e776) {
                    phi_1869_ = true;
                } else {
                    phi_1869_ = (_e774 >= (1f - _e776));
                }
                let _e781 = phi_1869_;
                if ((bitcast<u32>(_e774) & 2147483647u) > 2139095040u) {
                    phi_1877_ = true;
                } else {
                    phi_1877_ = !(_e781);
                }
                let _e787 = phi_1877_;
                if _e787 {
                    if (_e774 > 0f) {
                        if (_e774 < 1f) {
                            phi_1889_ = false;
                        } else {
                            phi_1889_ = true;
                        }
                        let _e791 = phi_1889_;
                        phi_1890_ = _e791;
                    } else {
                        phi_1890_ = true;
                    }
                    let _e793 = phi_1890_;
                    if _e793 {
                        phi_1894_ = 0.5f;
                    } else {
                        phi_1894_ = _e774;
                    }
                    let _e795 = phi_1894_;
                    phi_1902_ = evaluate_Verdict(_e795, true);
                } else {
                    if (_e774 > 0.5f) {
                        phi_1900_ = 1f;
                    } else {
                        phi_1900_ = 0f;
                    }
                    let _e799 = phi_1900_;
                    phi_1902_ = evaluate_Verdict(_e799, false);
                }
                let _e802 = phi_1902_;
                phi_1907_ = evaluate_Verdict(_e802.visibility, _e802.is_doubted);
            } else {
                phi_1907_ = evaluate_Verdict(0.5f, true);
            }
            let _e808 = phi_1907_;
            phi_1908_ = _e808;
        }
        let _e810 = phi_1908_;
        if (_e63.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e63.first_primitive)] = _e810.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_msm_hausdorff_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
