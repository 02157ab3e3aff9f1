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
        let _e54 = phi_146_;
        let _e56 = phi_147_;
        phi_148_ = _e54;
        phi_149_ = _e56;
    } else {
        phi_148_ = lt_bvh_traverse_Tree();
        phi_149_ = true;
    }
    let _e58 = phi_148_;
    let _e60 = phi_149_;
    if _e60 {
        phi_154_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_154_ = _e58;
    }
    let _e65 = phi_154_;
    return lt_bvh_traverse_Tree(_e65.root, _e65.first_primitive);
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
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
    var phi_805_: f32;
    var phi_806_: f32;
    var phi_807_: f32;
    var phi_808_: f32;
    var phi_809_: f32;
    var phi_810_: f32;
    var phi_811_: f32;
    var phi_812_: bool;
    var phi_813_: f32;
    var phi_814_: f32;
    var phi_815_: bool;
    var phi_819_: f32;

    let _e45 = (*param_4);
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
            let _e52 = phi_181_;
            phi_182_ = _e52;
        }
        let _e54 = phi_182_;
        phi_183_ = _e54;
    }
    let _e56 = phi_183_;
    let _e57 = (_e56 - 0.00000047683716f);
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
            let _e65 = phi_200_;
            phi_201_ = _e65;
        }
        let _e67 = phi_201_;
        phi_202_ = _e67;
    }
    let _e69 = phi_202_;
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
            let _e77 = phi_218_;
            phi_219_ = _e77;
        }
        let _e79 = phi_219_;
        phi_220_ = _e79;
    }
    let _e81 = phi_220_;
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
            let _e89 = phi_236_;
            phi_237_ = _e89;
        }
        let _e91 = phi_237_;
        phi_238_ = _e91;
    }
    let _e93 = phi_238_;
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
            let _e101 = phi_254_;
            phi_255_ = _e101;
        }
        let _e103 = phi_255_;
        phi_256_ = _e103;
    }
    let _e105 = phi_256_;
    let _e106 = (_e69 - _e57);
    let _e107 = (_e81 - _e57);
    let _e108 = (_e93 - _e57);
    let _e109 = (_e105 - _e57);
    let _e120 = ((((_e106 * param_6.x) + (_e107 * param_6.y)) + (_e108 * param_6.z)) + (_e109 * param_6.w));
    if ((bitcast<u32>(_e120) & 2147483647u) > 2139095040u) {
        phi_813_ = _e120;
        phi_814_ = f32();
        phi_815_ = true;
    } else {
        if (_e106 >= 0f) {
            if (_e107 >= 0f) {
                if (_e108 >= 0f) {
                    phi_291_ = (_e109 >= 0f);
                    phi_292_ = false;
                } else {
                    phi_291_ = bool();
                    phi_292_ = true;
                }
                let _e129 = phi_291_;
                let _e131 = phi_292_;
                phi_293_ = _e129;
                phi_294_ = _e131;
            } else {
                phi_293_ = bool();
                phi_294_ = true;
            }
            let _e133 = phi_293_;
            let _e135 = phi_294_;
            phi_295_ = _e133;
            phi_296_ = _e135;
        } else {
            phi_295_ = bool();
            phi_296_ = true;
        }
        let _e137 = phi_295_;
        let _e139 = phi_296_;
        if _e139 {
            phi_300_ = false;
        } else {
            phi_300_ = _e137;
        }
        let _e141 = phi_300_;
        if _e141 {
            phi_810_ = 1f;
            phi_811_ = f32();
            phi_812_ = true;
        } else {
            let _e142 = (0.5f * _e45);
            let _e143 = (1f - _e45);
            let _e145 = (param_6.x * _e143);
            let _e147 = (param_6.y * _e143);
            let _e149 = (param_6.z * _e143);
            let _e151 = (param_6.w * _e143);
            let _e152 = -(_e57);
            let _e153 = (1f - _e57);
            let _e155 = (vec4<f32>(1f, 1f, 1f, 1f).x - _e69);
            let _e157 = (vec4<f32>(1f, 1f, 1f, 1f).y - _e81);
            let _e159 = (vec4<f32>(1f, 1f, 1f, 1f).z - _e93);
            let _e161 = (vec4<f32>(1f, 1f, 1f, 1f).w - _e105);
            let _e162 = (_e106 - _e107);
            let _e163 = (_e107 - _e108);
            let _e164 = (_e108 - _e109);
            let _e165 = (_e109 - _e106);
            let _e166 = (_e162 * _e162);
            let _e167 = (_e163 * _e163);
            let _e168 = (_e164 * _e164);
            let _e169 = (_e165 * _e165);
            let _e170 = (_e106 - _e108);
            let _e171 = (_e107 - _e109);
            let _e172 = (_e108 - _e106);
            let _e173 = (_e109 - _e107);
            let _e174 = (_e170 * _e170);
            let _e175 = (_e171 * _e171);
            let _e176 = (_e172 * _e172);
            let _e177 = (_e173 * _e173);
            let _e182 = ((_e145 * _e147) * _e166);
            let _e183 = ((_e147 * _e149) * _e167);
            let _e184 = ((_e149 * _e151) * _e168);
            let _e185 = ((_e151 * _e145) * _e169);
            let _e194 = (((0.5f * _e145) * _e149) * _e174);
            let _e195 = (((0.5f * _e147) * _e151) * _e175);
            let _e196 = (((0.5f * _e149) * _e145) * _e176);
            let _e197 = (((0.5f * _e151) * _e147) * _e177);
            let _e198 = (_e106 * _e107);
            let _e199 = (_e107 * _e108);
            let _e200 = (_e108 * _e109);
            let _e201 = (_e109 * _e106);
            let _e202 = (_e106 * _e108);
            let _e203 = (_e107 * _e109);
            let _e204 = (_e108 * _e106);
            let _e205 = (_e109 * _e107);
            let _e206 = (_e182 * _e198);
            let _e207 = (_e183 * _e199);
            let _e208 = (_e184 * _e200);
            let _e209 = (_e185 * _e201);
            let _e210 = (_e194 * _e202);
            let _e211 = (_e195 * _e203);
            let _e212 = (_e196 * _e204);
            let _e213 = (_e197 * _e205);
            let _e214 = (_e69 * _e69);
            let _e215 = (_e81 * _e81);
            let _e216 = (_e93 * _e93);
            let _e217 = (_e105 * _e105);
            let _e218 = (_e155 * _e155);
            let _e219 = (_e157 * _e157);
            let _e220 = (_e159 * _e159);
            let _e221 = (_e161 * _e161);
            let _e222 = (_e142 * _e145);
            let _e223 = (_e142 * _e147);
            let _e224 = (_e142 * _e149);
            let _e225 = (_e142 * _e151);
            let _e234 = (((_e222 * _e106) * _e214) * _e152);
            let _e235 = (((_e223 * _e107) * _e215) * _e152);
            let _e236 = (((_e224 * _e108) * _e216) * _e152);
            let _e237 = (((_e225 * _e109) * _e217) * _e152);
            let _e246 = (((_e222 * _e106) * _e218) * _e153);
            let _e247 = (((_e223 * _e107) * _e219) * _e153);
            let _e248 = (((_e224 * _e108) * _e220) * _e153);
            let _e249 = (((_e225 * _e109) * _e221) * _e153);
            let _e417 = (((((((_e182 * _e149) * _e167) * _e174) + (_e142 * (((_e182 * ((_e214 * _e215) + (_e218 * _e219))) + (_e194 * ((_e214 * _e216) + (_e218 * _e220)))) + ((_e222 * _e214) * _e218)))) + ((((_e183 * _e151) * _e168) * _e175) + (_e142 * (((_e183 * ((_e215 * _e216) + (_e219 * _e220))) + (_e195 * ((_e215 * _e217) + (_e219 * _e221)))) + ((_e223 * _e215) * _e219))))) + ((((_e184 * _e145) * _e169) * _e176) + (_e142 * (((_e184 * ((_e216 * _e217) + (_e220 * _e221))) + (_e196 * ((_e216 * _e214) + (_e220 * _e218)))) + ((_e224 * _e216) * _e220))))) + ((((_e185 * _e147) * _e166) * _e177) + (_e142 * (((_e185 * ((_e217 * _e214) + (_e221 * _e218))) + (_e197 * ((_e217 * _e215) + (_e221 * _e219)))) + ((_e225 * _e217) * _e221)))));
            let _e420 = (((_e142 * _e142) * _e152) * _e153);
            let _e423 = (((((((_e206 * _e198) + (_e210 * _e202)) + (_e106 * ((_e234 * _e152) + (_e246 * _e153)))) + (((_e207 * _e199) + (_e211 * _e203)) + (_e107 * ((_e235 * _e152) + (_e247 * _e153))))) + (((_e208 * _e200) + (_e212 * _e204)) + (_e108 * ((_e236 * _e152) + (_e248 * _e153))))) + (((_e209 * _e201) + (_e213 * _e205)) + (_e109 * ((_e237 * _e152) + (_e249 * _e153))))) + ((_e420 * _e152) * _e153));
            let _e429 = (_e423 < 0.0000000000000000000000000000000001f);
            if _e429 {
                if ((bitcast<u32>(_e106) & 2147483647u) > 2139095040u) {
                    phi_613_ = _e106;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_612_ = 0f;
                    } else {
                        if (_e106 < 0f) {
                            phi_611_ = 0f;
                        } else {
                            phi_611_ = 1f;
                        }
                        let _e438 = phi_611_;
                        phi_612_ = _e438;
                    }
                    let _e440 = phi_612_;
                    phi_613_ = _e440;
                }
                let _e442 = phi_613_;
                if ((bitcast<u32>(_e107) & 2147483647u) > 2139095040u) {
                    phi_632_ = _e107;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_631_ = 0f;
                    } else {
                        if (_e107 < 0f) {
                            phi_630_ = 0f;
                        } else {
                            phi_630_ = 1f;
                        }
                        let _e451 = phi_630_;
                        phi_631_ = _e451;
                    }
                    let _e453 = phi_631_;
                    phi_632_ = _e453;
                }
                let _e455 = phi_632_;
                if ((bitcast<u32>(_e108) & 2147483647u) > 2139095040u) {
                    phi_651_ = _e108;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_650_ = 0f;
                    } else {
                        if (_e108 < 0f) {
                            phi_649_ = 0f;
                        } else {
                            phi_649_ = 1f;
                        }
                        let _e464 = phi_649_;
                        phi_650_ = _e464;
                    }
                    let _e466 = phi_650_;
                    phi_651_ = _e466;
                }
                let _e468 = phi_651_;
                if ((bitcast<u32>(_e109) & 2147483647u) > 2139095040u) {
                    phi_670_ = _e109;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_669_ = 0f;
                    } else {
                        if (_e109 < 0f) {
                            phi_668_ = 0f;
                        } else {
                            phi_668_ = 1f;
                        }
                        let _e477 = phi_668_;
                        phi_669_ = _e477;
                    }
                    let _e479 = phi_669_;
                    phi_670_ = _e479;
                }
                let _e481 = phi_670_;
                let _e489 = (((((_e442 * _e145) + (_e455 * _e147)) + (_e468 * _e149)) + (_e481 * _e151)) + _e142);
                if ((bitcast<u32>(_e489) & 2147483647u) > 2139095040u) {
                    phi_695_ = _e489;
                } else {
                    if (_e489 < 0f) {
                        phi_694_ = 0f;
                    } else {
                        if (_e489 > 1f) {
                            phi_693_ = 1f;
                        } else {
                            phi_693_ = _e489;
                        }
                        let _e496 = phi_693_;
                        phi_694_ = _e496;
                    }
                    let _e498 = phi_694_;
                    phi_695_ = _e498;
                }
                let _e500 = phi_695_;
                phi_808_ = _e500;
                phi_809_ = f32();
            } else {
                let _e502 = ((0.5f * -(((((((((_e206 * (_e106 + _e107)) + (_e210 * (_e106 + _e108))) + (_e234 * (_e106 + _e152))) + (_e246 * (_e106 + _e153))) + ((((_e207 * (_e107 + _e108)) + (_e211 * (_e107 + _e109))) + (_e235 * (_e107 + _e152))) + (_e247 * (_e107 + _e153)))) + ((((_e208 * (_e108 + _e109)) + (_e212 * (_e108 + _e106))) + (_e236 * (_e108 + _e152))) + (_e248 * (_e108 + _e153)))) + ((((_e209 * (_e109 + _e106)) + (_e213 * (_e109 + _e107))) + (_e237 * (_e109 + _e152))) + (_e249 * (_e109 + _e153)))) + (_e420 * (_e152 + _e153))))) / _e423);
                let _e503 = ((((((((_e206 + _e210) + _e234) + _e246) + (((_e207 + _e211) + _e235) + _e247)) + (((_e208 + _e212) + _e236) + _e248)) + (((_e209 + _e213) + _e237) + _e249)) + _e420) / _e423);
                let _e505 = ((_e502 * _e502) - _e503);
                if (_e505 > 0f) {
                    phi_706_ = sqrt(_e505);
                } else {
                    phi_706_ = 0f;
                }
                let _e509 = phi_706_;
                if (_e502 > 0f) {
                    let _e512 = (-(_e502) - _e509);
                    phi_723_ = lt_bvh_slab_Span(_e512, (_e503 / _e512));
                } else {
                    let _e515 = (_e509 - _e502);
                    if (_e515 > 0f) {
                        phi_721_ = (_e503 / _e515);
                    } else {
                        phi_721_ = 0f;
                    }
                    let _e519 = phi_721_;
                    phi_723_ = lt_bvh_slab_Span(_e519, _e515);
                }
                let _e522 = phi_723_;
                if (_e522.near >= 0f) {
                    phi_784_ = 1f;
                    phi_785_ = f32();
                    phi_786_ = true;
                } else {
                    let _e526 = (_e522.far <= 0f);
                    if _e526 {
                        phi_782_ = (_e417 / _e423);
                        phi_783_ = f32();
                    } else {
                        let _e537 = (((((_e145 * _e106) + (_e147 * _e107)) + (_e149 * _e108)) + (_e151 * _e109)) + (_e142 * (_e152 + _e153)));
                        let _e553 = (((((_e145 * (_e106 * _e106)) + (_e147 * (_e107 * _e107))) + (_e149 * (_e108 * _e108))) + (_e151 * (_e109 * _e109))) + (_e142 * ((_e152 * _e152) + (_e153 * _e153))));
                        if (-(_e522.near) <= _e522.far) {
                            phi_781_ = (1f - (((_e522.near * _e522.near) * ((_e522.far * _e553) - _e537)) / (_e522.far - _e522.near)));
                        } else {
                            phi_781_ = ((_e417 / _e423) + (((_e522.far * _e522.far) * (_e537 - (_e522.near * _e553))) / (_e522.far - _e522.near)));
                        }
                        let _e572 = phi_781_;
                        phi_782_ = f32();
                        phi_783_ = _e572;
                    }
                    let _e574 = phi_782_;
                    let _e576 = phi_783_;
                    phi_784_ = _e574;
                    phi_785_ = _e576;
                    phi_786_ = _e526;
                }
                let _e578 = phi_784_;
                let _e580 = phi_785_;
                let _e582 = phi_786_;
                if _e582 {
                    phi_790_ = _e578;
                } else {
                    phi_790_ = _e580;
                }
                let _e584 = phi_790_;
                if ((bitcast<u32>(_e584) & 2147483647u) > 2139095040u) {
                    phi_807_ = _e584;
                } else {
                    if (_e584 < 0f) {
                        phi_806_ = 0f;
                    } else {
                        if (_e584 > 1f) {
                            phi_805_ = 1f;
                        } else {
                            phi_805_ = _e584;
                        }
                        let _e591 = phi_805_;
                        phi_806_ = _e591;
                    }
                    let _e593 = phi_806_;
                    phi_807_ = _e593;
                }
                let _e595 = phi_807_;
                phi_808_ = f32();
                phi_809_ = _e595;
            }
            let _e597 = phi_808_;
            let _e599 = phi_809_;
            phi_810_ = _e597;
            phi_811_ = _e599;
            phi_812_ = _e429;
        }
        let _e601 = phi_810_;
        let _e603 = phi_811_;
        let _e605 = phi_812_;
        phi_813_ = _e601;
        phi_814_ = _e603;
        phi_815_ = _e605;
    }
    let _e607 = phi_813_;
    let _e609 = phi_814_;
    let _e611 = phi_815_;
    if _e611 {
        phi_819_ = _e607;
    } else {
        phi_819_ = _e609;
    }
    let _e613 = phi_819_;
    return _e613;
}

fn function_() {
    var local: f32;
    var phi_879_: bool;
    var phi_880_: bool;
    var phi_881_: bool;
    var phi_882_: bool;
    var phi_886_: bool;
    var phi_956_: bool;
    var phi_957_: bool;
    var phi_968_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_969_: bool;
    var phi_970_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_971_: bool;
    var phi_978_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_982_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1002_: lt_math_LightPoint;
    var phi_1005_: u32;
    var phi_1007_: lt_math_LevelPoint;
    var phi_1093_: bool;
    var phi_1102_: bool;
    var phi_1111_: bool;
    var phi_1112_: bool;
    var phi_1113_: bool;
    var phi_1114_: bool;
    var phi_1115_: bool;
    var phi_1116_: bool;
    var phi_1117_: bool;
    var phi_1121_: bool;
    var phi_1148_: bool;
    var phi_1149_: bool;
    var phi_1150_: bool;
    var phi_1151_: bool;
    var phi_1152_: bool;
    var phi_1153_: bool;
    var phi_1154_: bool;
    var phi_1155_: bool;
    var phi_1159_: bool;
    var phi_1168_: lt_math_LightPoint;
    var phi_1169_: u32;
    var phi_1170_: lt_math_LevelPoint;
    var phi_1171_: bool;
    var phi_1003_: lt_math_LightPoint;
    var phi_1006_: u32;
    var phi_1008_: lt_math_LevelPoint;
    var phi_1172_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_1212_: bool;
    var phi_1213_: bool;
    var phi_1214_: bool;
    var phi_1215_: bool;
    var phi_1219_: bool;
    var phi_1301_: f32;
    var phi_1417_: f32;
    var phi_1418_: f32;
    var phi_1421_: f32;
    var phi_1450_: f32;
    var phi_1455_: f32;
    var phi_1456_: bool;
    var phi_1457_: f32;
    var phi_1458_: bool;
    var phi_1462_: f32;
    var phi_1482_: f32;
    var phi_1487_: f32;
    var phi_1488_: bool;
    var phi_1489_: f32;
    var phi_1490_: bool;
    var phi_1494_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_1543_: i32;
    var phi_1548_: i32;
    var phi_1553_: i32;
    var phi_1558_: i32;
    var phi_1567_: i32;
    var phi_1572_: i32;
    var phi_1577_: i32;
    var phi_1582_: i32;
    var phi_1627_: evaluate_Verdict;
    var phi_1628_: evaluate_Verdict;
    var phi_1629_: bool;
    var phi_1630_: evaluate_Verdict;
    var phi_1631_: evaluate_Verdict;
    var phi_1632_: bool;
    var phi_1636_: evaluate_Verdict;

    let _e42 = id_1;
    let _e49 = arrayLength((&map.member));
    let _e55 = arrayLength((&levels.member));
    let _e58 = p.member.size[0u];
    let _e60 = p.member.size[1u];
    let _e61 = lt_shaders_entry_pixel_index(_e42, _e58, _e60);
    if (bitcast<i32>(_e61.root) != 0i) {
        let _e67 = p.member.level_count;
        if (_e61.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e74 = samples.member[(0u + _e61.first_primitive)].normal[0u];
        let _e76 = global[0u];
        if (_e74 == _e76) {
            let _e79 = samples.member[(0u + _e61.first_primitive)].normal[1u];
            let _e81 = global[1u];
            if (_e79 == _e81) {
                let _e84 = samples.member[(0u + _e61.first_primitive)].normal[2u];
                let _e86 = global[2u];
                phi_879_ = (_e84 == _e86);
                phi_880_ = false;
            } else {
                phi_879_ = bool();
                phi_880_ = true;
            }
            let _e89 = phi_879_;
            let _e91 = phi_880_;
            phi_881_ = _e89;
            phi_882_ = _e91;
        } else {
            phi_881_ = bool();
            phi_882_ = true;
        }
        let _e93 = phi_881_;
        let _e95 = phi_882_;
        if _e95 {
            phi_886_ = false;
        } else {
            phi_886_ = _e93;
        }
        let _e97 = phi_886_;
        if !(_e97) {
            let _e100 = samples.member[(0u + _e61.first_primitive)].position;
            let _e102 = p.member.light.place;
            let _e108 = p.member.light.place[3u];
            let _e115 = (_e102.x - (_e100.x * _e108));
            let _e116 = (_e102.y - (_e100.y * _e108));
            let _e117 = (_e102.z - (_e100.z * _e108));
            let _e119 = samples.member[(0u + _e61.first_primitive)].normal;
            if ((((_e119.x * _e115) + (_e119.y * _e116)) + (_e119.z * _e117)) > 0f) {
                let _e133 = (((_e115 * _e115) + (_e116 * _e116)) + (_e117 * _e117));
                let _e135 = p.member.light.axis;
                let _e147 = p.member.light.place[3u];
                if (_e147 == 0f) {
                    phi_957_ = true;
                } else {
                    let _e150 = p.member.light.range_squared;
                    if (_e133 <= _e150) {
                        let _e153 = p.member.light.cos_outer;
                        phi_956_ = (-((((_e115 * _e135.x) + (_e116 * _e135.y)) + (_e117 * _e135.z))) >= (_e153 * sqrt(_e133)));
                    } else {
                        phi_956_ = false;
                    }
                    let _e158 = phi_956_;
                    phi_957_ = _e158;
                }
                let _e160 = phi_957_;
                if _e160 {
                    let _e162 = samples.member[(0u + _e61.first_primitive)].flags;
                    let _e170 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e176 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e170.unnamed.visibility, false), _e170.unnamed_1);
                    phi_968_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e176.unnamed, ((_e162 & 1u) == 0u));
                    phi_969_ = false;
                } else {
                    phi_968_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_969_ = true;
                }
                let _e181 = phi_968_;
                let _e183 = phi_969_;
                phi_970_ = _e181;
                phi_971_ = _e183;
            } else {
                phi_970_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_971_ = true;
            }
            let _e185 = phi_970_;
            let _e187 = phi_971_;
            if _e187 {
                let _e193 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e199 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e193.unnamed.visibility, false), _e193.unnamed_1);
                phi_978_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e199.unnamed, true);
            } else {
                phi_978_ = _e185;
            }
            let _e204 = phi_978_;
            phi_982_ = _e204;
        } else {
            let _e210 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e216 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e210.unnamed.visibility, false), _e210.unnamed_1);
            phi_982_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e216.unnamed, true);
        }
        let _e221 = phi_982_;
        if _e221.unnamed_1 {
            phi_1630_ = evaluate_Verdict(_e221.unnamed.visibility, _e221.unnamed.is_doubted);
            phi_1631_ = evaluate_Verdict();
            phi_1632_ = true;
        } else {
            let _e229 = samples.member[(0u + _e61.first_primitive)].position;
            let _e231 = p.member.map_size;
            let _e233 = (0.5f / f32(_e231));
            let _e240 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e247 = lt_math_LightPoint(vec2<f32>(_e240.uv.x, 0f), _e240.depth, _e240.is_inside);
            let _e251 = lt_math_LightPoint(_e247.uv, 0f, _e247.is_inside);
            phi_1002_ = lt_math_LightPoint();
            phi_1005_ = 0u;
            phi_1007_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e251.uv, _e251.depth, false));
            loop {
                let _e258 = phi_1002_;
                let _e260 = phi_1005_;
                let _e262 = phi_1007_;
                local_1 = _e262;
                local_2 = _e262;
                local_3 = _e262;
                if (_e260 < _e67) {
                    if _e262.point.is_inside {
                        phi_1168_ = lt_math_LightPoint();
                        phi_1169_ = u32();
                        phi_1170_ = lt_math_LevelPoint();
                        phi_1171_ = false;
                    } else {
                        if (_e260 < _e55) {
                        } else {
                            return;
                        }
                        let _e273 = levels.member[(0u + _e260)].row_w;
                        let _e284 = ((((_e273.x * _e229.x) + (_e273.y * _e229.y)) + (_e273.z * _e229.z)) + (_e273.w * 1f));
                        let _e286 = levels.member[(0u + _e260)].row_x;
                        let _e298 = (((((_e286.x * _e229.x) + (_e286.y * _e229.y)) + (_e286.z * _e229.z)) + (_e286.w * 1f)) / _e284);
                        let _e300 = levels.member[(0u + _e260)].row_y;
                        let _e312 = (((((_e300.x * _e229.x) + (_e300.y * _e229.y)) + (_e300.z * _e229.z)) + (_e300.w * 1f)) / _e284);
                        let _e314 = levels.member[(0u + _e260)].row_z;
                        let _e325 = ((((_e314.x * _e229.x) + (_e314.y * _e229.y)) + (_e314.z * _e229.z)) + (_e314.w * 1f));
                        if (_e284 > 0f) {
                            if (_e298 >= 0f) {
                                phi_1093_ = (_e298 <= 1f);
                            } else {
                                phi_1093_ = false;
                            }
                            let _e330 = phi_1093_;
                            if _e330 {
                                if (_e312 >= 0f) {
                                    phi_1102_ = (_e312 <= 1f);
                                } else {
                                    phi_1102_ = false;
                                }
                                let _e334 = phi_1102_;
                                if _e334 {
                                    if (_e325 >= 0f) {
                                        phi_1111_ = (_e325 <= 1f);
                                    } else {
                                        phi_1111_ = false;
                                    }
                                    let _e338 = phi_1111_;
                                    phi_1112_ = _e338;
                                    phi_1113_ = false;
                                } else {
                                    phi_1112_ = bool();
                                    phi_1113_ = true;
                                }
                                let _e340 = phi_1112_;
                                let _e342 = phi_1113_;
                                phi_1114_ = _e340;
                                phi_1115_ = _e342;
                            } else {
                                phi_1114_ = bool();
                                phi_1115_ = true;
                            }
                            let _e344 = phi_1114_;
                            let _e346 = phi_1115_;
                            phi_1116_ = _e344;
                            phi_1117_ = _e346;
                        } else {
                            phi_1116_ = bool();
                            phi_1117_ = true;
                        }
                        let _e348 = phi_1116_;
                        let _e350 = phi_1117_;
                        if _e350 {
                            phi_1121_ = false;
                        } else {
                            phi_1121_ = _e348;
                        }
                        let _e352 = phi_1121_;
                        if _e352 {
                            if (_e298 >= _e233) {
                                if (_e298 <= (1f - _e233)) {
                                    if (_e312 >= _e233) {
                                        phi_1148_ = (_e312 <= (1f - _e233));
                                        phi_1149_ = false;
                                    } else {
                                        phi_1148_ = bool();
                                        phi_1149_ = true;
                                    }
                                    let _e360 = phi_1148_;
                                    let _e362 = phi_1149_;
                                    phi_1150_ = _e360;
                                    phi_1151_ = _e362;
                                } else {
                                    phi_1150_ = bool();
                                    phi_1151_ = true;
                                }
                                let _e364 = phi_1150_;
                                let _e366 = phi_1151_;
                                phi_1152_ = _e364;
                                phi_1153_ = _e366;
                            } else {
                                phi_1152_ = bool();
                                phi_1153_ = true;
                            }
                            let _e368 = phi_1152_;
                            let _e370 = phi_1153_;
                            phi_1154_ = _e368;
                            phi_1155_ = _e370;
                        } else {
                            phi_1154_ = bool();
                            phi_1155_ = true;
                        }
                        let _e372 = phi_1154_;
                        let _e374 = phi_1155_;
                        if _e374 {
                            phi_1159_ = false;
                        } else {
                            phi_1159_ = _e372;
                        }
                        let _e376 = phi_1159_;
                        let _e383 = lt_math_LightPoint(vec2<f32>(_e298, _e258.uv.y), _e258.depth, _e258.is_inside);
                        let _e390 = lt_math_LightPoint(vec2<f32>(_e383.uv.x, _e312), _e383.depth, _e383.is_inside);
                        let _e394 = lt_math_LightPoint(_e390.uv, _e325, _e390.is_inside);
                        let _e398 = lt_math_LightPoint(_e394.uv, _e394.depth, _e376);
                        phi_1168_ = _e398;
                        phi_1169_ = (_e260 + 1u);
                        phi_1170_ = lt_math_LevelPoint(_e260, _e398);
                        phi_1171_ = true;
                    }
                    let _e402 = phi_1168_;
                    let _e404 = phi_1169_;
                    let _e406 = phi_1170_;
                    let _e408 = phi_1171_;
                    phi_1003_ = _e402;
                    phi_1006_ = _e404;
                    phi_1008_ = _e406;
                    phi_1172_ = _e408;
                } else {
                    phi_1003_ = lt_math_LightPoint();
                    phi_1006_ = u32();
                    phi_1008_ = lt_math_LevelPoint();
                    phi_1172_ = false;
                }
                let _e410 = phi_1003_;
                let _e412 = phi_1006_;
                let _e414 = phi_1008_;
                let _e416 = phi_1172_;
                continue;
                continuing {
                    phi_1002_ = _e410;
                    phi_1005_ = _e412;
                    phi_1007_ = _e414;
                    break if !(_e416);
                }
            }
            let _e419 = local_1;
            if _e419.point.is_inside {
                if (0f > 0f) {
                    let _e425 = local_2;
                    if (_e425.level < _e55) {
                    } else {
                        return;
                    }
                    let _e430 = levels.member[(0u + _e425.level)];
                    let _e436 = global[0u];
                    if (_e430.row_w.x == _e436) {
                        let _e439 = global[1u];
                        if (_e430.row_w.y == _e439) {
                            let _e442 = global[2u];
                            phi_1212_ = (_e430.row_w.z == _e442);
                            phi_1213_ = false;
                        } else {
                            phi_1212_ = bool();
                            phi_1213_ = true;
                        }
                        let _e445 = phi_1212_;
                        let _e447 = phi_1213_;
                        phi_1214_ = _e445;
                        phi_1215_ = _e447;
                    } else {
                        phi_1214_ = bool();
                        phi_1215_ = true;
                    }
                    let _e449 = phi_1214_;
                    let _e451 = phi_1215_;
                    if _e451 {
                        phi_1219_ = false;
                    } else {
                        phi_1219_ = _e449;
                    }
                    let _e453 = phi_1219_;
                    if _e453 {
                        let _e455 = samples.member[(0u + _e61.first_primitive)].normal;
                        let _e457 = p.member.map_size;
                        let _e527 = ((abs(((((_e430.row_x.x * _e455.x) + (_e430.row_x.y * _e455.y)) + (_e430.row_x.z * _e455.z)) / (((_e430.row_x.x * _e430.row_x.x) + (_e430.row_x.y * _e430.row_x.y)) + (_e430.row_x.z * _e430.row_x.z)))) + abs(((((_e430.row_y.x * _e455.x) + (_e430.row_y.y * _e455.y)) + (_e430.row_y.z * _e455.z)) / (((_e430.row_y.x * _e430.row_y.x) + (_e430.row_y.y * _e430.row_y.y)) + (_e430.row_y.z * _e430.row_y.z))))) / (abs(((((_e430.row_z.x * _e455.x) + (_e430.row_z.y * _e455.y)) + (_e430.row_z.z * _e455.z)) / (((_e430.row_z.x * _e430.row_z.x) + (_e430.row_z.y * _e430.row_z.y)) + (_e430.row_z.z * _e430.row_z.z)))) * f32(_e457)));
                        if (_e527 < 0.002f) {
                            phi_1301_ = _e527;
                        } else {
                            phi_1301_ = 0.002f;
                        }
                        let _e530 = phi_1301_;
                        phi_1418_ = _e530;
                    } else {
                        let _e532 = p.member.map_size;
                        let _e538 = samples.member[(0u + _e61.first_primitive)].position;
                        let _e549 = ((((_e430.row_w.x * _e538.x) + (_e430.row_w.y * _e538.y)) + (_e430.row_w.z * _e538.z)) + _e430.row_w.w);
                        let _e562 = ((_e430.row_x.x - (_e430.row_w.x * _e419.point.uv.x)) / _e549);
                        let _e563 = ((_e430.row_x.y - (_e430.row_w.y * _e419.point.uv.x)) / _e549);
                        let _e564 = ((_e430.row_x.z - (_e430.row_w.z * _e419.point.uv.x)) / _e549);
                        let _e577 = ((_e430.row_y.x - (_e430.row_w.x * _e419.point.uv.y)) / _e549);
                        let _e578 = ((_e430.row_y.y - (_e430.row_w.y * _e419.point.uv.y)) / _e549);
                        let _e579 = ((_e430.row_y.z - (_e430.row_w.z * _e419.point.uv.y)) / _e549);
                        let _e585 = samples.member[(0u + _e61.first_primitive)].normal;
                        let _e590 = ((_e578 * _e585.z) - (_e585.y * _e579));
                        let _e595 = ((_e579 * _e585.x) - (_e585.z * _e577));
                        let _e600 = ((_e577 * _e585.y) - (_e585.x * _e578));
                        let _e602 = samples.member[(0u + _e61.first_primitive)].normal;
                        let _e607 = ((_e563 * _e602.z) - (_e602.y * _e564));
                        let _e612 = ((_e564 * _e602.x) - (_e602.z * _e562));
                        let _e617 = ((_e562 * _e602.y) - (_e602.x * _e563));
                        let _e644 = ((abs(((((_e430.row_z.x * _e590) + (_e430.row_z.y * _e595)) + (_e430.row_z.z * _e600)) / (((_e562 * _e590) + (_e563 * _e595)) + (_e564 * _e600)))) + abs(((((_e430.row_z.x * _e607) + (_e430.row_z.y * _e612)) + (_e430.row_z.z * _e617)) / (((_e577 * _e607) + (_e578 * _e612)) + (_e579 * _e617))))) / f32(_e532));
                        if (_e644 < 0.002f) {
                            phi_1417_ = _e644;
                        } else {
                            phi_1417_ = 0.002f;
                        }
                        let _e647 = phi_1417_;
                        phi_1418_ = _e647;
                    }
                    let _e649 = phi_1418_;
                    phi_1421_ = (_e419.point.depth - (0f * _e649));
                } else {
                    phi_1421_ = _e419.point.depth;
                }
                let _e653 = phi_1421_;
                let _e659 = p.member.map_size;
                let _e660 = f32(_e659);
                let _e663 = ((_e419.point.uv.x * _e660) - 0.5f);
                let _e664 = ((_e419.point.uv.y * _e660) - 0.5f);
                if (_e663 > -8388608f) {
                    let _e676 = f32(select(0i, select(select(i32(_e663), i32(-2147483648), (_e663 < bitcast<f32>(3472883712u))), 2147483647i, (_e663 > bitcast<f32>(1325400063u))), (_e663 == _e663)));
                    if (_e676 > _e663) {
                        phi_1450_ = 1f;
                    } else {
                        phi_1450_ = 0f;
                    }
                    let _e679 = phi_1450_;
                    if (_e663 < 8388608f) {
                        phi_1455_ = (_e676 - _e679);
                        phi_1456_ = false;
                    } else {
                        phi_1455_ = f32();
                        phi_1456_ = true;
                    }
                    let _e682 = phi_1455_;
                    let _e684 = phi_1456_;
                    phi_1457_ = _e682;
                    phi_1458_ = _e684;
                } else {
                    phi_1457_ = f32();
                    phi_1458_ = true;
                }
                let _e686 = phi_1457_;
                let _e688 = phi_1458_;
                if _e688 {
                    phi_1462_ = _e663;
                } else {
                    phi_1462_ = _e686;
                }
                let _e690 = phi_1462_;
                if (_e664 > -8388608f) {
                    let _e702 = f32(select(0i, select(select(i32(_e664), i32(-2147483648), (_e664 < bitcast<f32>(3472883712u))), 2147483647i, (_e664 > bitcast<f32>(1325400063u))), (_e664 == _e664)));
                    if (_e702 > _e664) {
                        phi_1482_ = 1f;
                    } else {
                        phi_1482_ = 0f;
                    }
                    let _e705 = phi_1482_;
                    if (_e664 < 8388608f) {
                        phi_1487_ = (_e702 - _e705);
                        phi_1488_ = false;
                    } else {
                        phi_1487_ = f32();
                        phi_1488_ = true;
                    }
                    let _e708 = phi_1487_;
                    let _e710 = phi_1488_;
                    phi_1489_ = _e708;
                    phi_1490_ = _e710;
                } else {
                    phi_1489_ = f32();
                    phi_1490_ = true;
                }
                let _e712 = phi_1489_;
                let _e714 = phi_1490_;
                if _e714 {
                    phi_1494_ = _e664;
                } else {
                    phi_1494_ = _e712;
                }
                let _e716 = phi_1494_;
                let _e717 = (_e663 - _e690);
                let _e718 = (_e664 - _e716);
                let _e727 = select(0i, select(select(i32(_e690), i32(-2147483648), (_e690 < bitcast<f32>(3472883712u))), 2147483647i, (_e690 > bitcast<f32>(1325400063u))), (_e690 == _e690));
                let _e736 = select(0i, select(select(i32(_e716), i32(-2147483648), (_e716 < bitcast<f32>(3472883712u))), 2147483647i, (_e716 > bitcast<f32>(1325400063u))), (_e716 == _e716));
                let _e747 = p.member.test;
                let _e748 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e747);
                let _e750 = p.member.map_size;
                let _e752 = local_3;
                local = _e748;
                let _e755 = ((_e752.level * _e750) * _e750);
                let _e757 = (bitcast<i32>(_e750) - 1i);
                if (_e727 > 0i) {
                    phi_1543_ = _e727;
                } else {
                    phi_1543_ = 0i;
                }
                let _e760 = phi_1543_;
                if (_e736 > 0i) {
                    phi_1548_ = _e736;
                } else {
                    phi_1548_ = 0i;
                }
                let _e763 = phi_1548_;
                if (_e760 < _e757) {
                    phi_1553_ = _e760;
                } else {
                    phi_1553_ = _e757;
                }
                let _e766 = phi_1553_;
                if (_e763 < _e757) {
                    phi_1558_ = _e763;
                } else {
                    phi_1558_ = _e757;
                }
                let _e769 = phi_1558_;
                let _e770 = bitcast<u32>(_e766);
                let _e772 = (_e727 + 1i);
                let _e773 = (_e736 + 1i);
                if (_e772 > 0i) {
                    phi_1567_ = _e772;
                } else {
                    phi_1567_ = 0i;
                }
                let _e776 = phi_1567_;
                if (_e773 > 0i) {
                    phi_1572_ = _e773;
                } else {
                    phi_1572_ = 0i;
                }
                let _e779 = phi_1572_;
                if (_e776 < _e757) {
                    phi_1577_ = _e776;
                } else {
                    phi_1577_ = _e757;
                }
                let _e782 = phi_1577_;
                if (_e779 < _e757) {
                    phi_1582_ = _e779;
                } else {
                    phi_1582_ = _e757;
                }
                let _e785 = phi_1582_;
                let _e786 = bitcast<u32>(_e782);
                let _e788 = (bitcast<u32>(_e769) * _e750);
                let _e789 = (bitcast<u32>(_e785) * _e750);
                let _e794 = ((_e788 + _e770) + _e755);
                let _e795 = ((_e788 + _e786) + _e755);
                let _e796 = ((_e789 + _e770) + _e755);
                let _e797 = ((_e789 + _e786) + _e755);
                if (_e794 < _e49) {
                } else {
                    return;
                }
                let _e801 = map.member[(0u + _e794)];
                if (_e795 < _e49) {
                } else {
                    return;
                }
                let _e805 = map.member[(0u + _e795)];
                if (_e796 < _e49) {
                } else {
                    return;
                }
                let _e809 = map.member[(0u + _e796)];
                if (_e797 < _e49) {
                } else {
                    return;
                }
                let _e813 = map.member[(0u + _e797)];
                let _e815 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e801, _e805, _e809, _e813), vec4<f32>(((1f - _e717) * (1f - _e718)), (_e717 * (1f - _e718)), ((1f - _e717) * _e718), (_e717 * _e718)), _e653);
                phi_1627_ = evaluate_Verdict(_e815, false);
                phi_1628_ = evaluate_Verdict();
                phi_1629_ = false;
            } else {
                phi_1627_ = evaluate_Verdict();
                phi_1628_ = evaluate_Verdict(1f, false);
                phi_1629_ = true;
            }
            let _e819 = phi_1627_;
            let _e821 = phi_1628_;
            let _e823 = phi_1629_;
            phi_1630_ = _e821;
            phi_1631_ = _e819;
            phi_1632_ = _e823;
        }
        let _e825 = phi_1630_;
        let _e827 = phi_1631_;
        let _e829 = phi_1632_;
        if _e829 {
            phi_1636_ = _e825;
        } else {
            phi_1636_ = _e827;
        }
        let _e831 = phi_1636_;
        if (_e61.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e61.first_primitive)] = _e831.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_msm_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
