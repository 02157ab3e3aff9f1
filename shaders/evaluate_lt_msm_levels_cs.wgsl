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
        let _e54 = phi_147_;
        let _e56 = phi_148_;
        phi_149_ = _e54;
        phi_150_ = _e56;
    } else {
        phi_149_ = lt_bvh_traverse_Tree();
        phi_150_ = true;
    }
    let _e58 = phi_149_;
    let _e60 = phi_150_;
    if _e60 {
        phi_155_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_155_ = _e58;
    }
    let _e65 = phi_155_;
    return lt_bvh_traverse_Tree(_e65.root, _e65.first_primitive);
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
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
    var phi_806_: f32;
    var phi_807_: f32;
    var phi_808_: f32;
    var phi_809_: f32;
    var phi_810_: f32;
    var phi_811_: f32;
    var phi_812_: f32;
    var phi_813_: bool;
    var phi_814_: f32;
    var phi_815_: f32;
    var phi_816_: bool;
    var phi_820_: f32;

    let _e45 = (*param_4);
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
            let _e52 = phi_182_;
            phi_183_ = _e52;
        }
        let _e54 = phi_183_;
        phi_184_ = _e54;
    }
    let _e56 = phi_184_;
    let _e57 = (_e56 - 0.00000047683716f);
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
            let _e65 = phi_201_;
            phi_202_ = _e65;
        }
        let _e67 = phi_202_;
        phi_203_ = _e67;
    }
    let _e69 = phi_203_;
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
            let _e77 = phi_219_;
            phi_220_ = _e77;
        }
        let _e79 = phi_220_;
        phi_221_ = _e79;
    }
    let _e81 = phi_221_;
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
            let _e89 = phi_237_;
            phi_238_ = _e89;
        }
        let _e91 = phi_238_;
        phi_239_ = _e91;
    }
    let _e93 = phi_239_;
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
            let _e101 = phi_255_;
            phi_256_ = _e101;
        }
        let _e103 = phi_256_;
        phi_257_ = _e103;
    }
    let _e105 = phi_257_;
    let _e106 = (_e69 - _e57);
    let _e107 = (_e81 - _e57);
    let _e108 = (_e93 - _e57);
    let _e109 = (_e105 - _e57);
    let _e120 = ((((_e106 * param_6.x) + (_e107 * param_6.y)) + (_e108 * param_6.z)) + (_e109 * param_6.w));
    if ((bitcast<u32>(_e120) & 2147483647u) > 2139095040u) {
        phi_814_ = _e120;
        phi_815_ = f32();
        phi_816_ = true;
    } else {
        if (_e106 >= 0f) {
            if (_e107 >= 0f) {
                if (_e108 >= 0f) {
                    phi_292_ = (_e109 >= 0f);
                    phi_293_ = false;
                } else {
                    phi_292_ = bool();
                    phi_293_ = true;
                }
                let _e129 = phi_292_;
                let _e131 = phi_293_;
                phi_294_ = _e129;
                phi_295_ = _e131;
            } else {
                phi_294_ = bool();
                phi_295_ = true;
            }
            let _e133 = phi_294_;
            let _e135 = phi_295_;
            phi_296_ = _e133;
            phi_297_ = _e135;
        } else {
            phi_296_ = bool();
            phi_297_ = true;
        }
        let _e137 = phi_296_;
        let _e139 = phi_297_;
        if _e139 {
            phi_301_ = false;
        } else {
            phi_301_ = _e137;
        }
        let _e141 = phi_301_;
        if _e141 {
            phi_811_ = 1f;
            phi_812_ = f32();
            phi_813_ = true;
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
                    phi_614_ = _e106;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_613_ = 0f;
                    } else {
                        if (_e106 < 0f) {
                            phi_612_ = 0f;
                        } else {
                            phi_612_ = 1f;
                        }
                        let _e438 = phi_612_;
                        phi_613_ = _e438;
                    }
                    let _e440 = phi_613_;
                    phi_614_ = _e440;
                }
                let _e442 = phi_614_;
                if ((bitcast<u32>(_e107) & 2147483647u) > 2139095040u) {
                    phi_633_ = _e107;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_632_ = 0f;
                    } else {
                        if (_e107 < 0f) {
                            phi_631_ = 0f;
                        } else {
                            phi_631_ = 1f;
                        }
                        let _e451 = phi_631_;
                        phi_632_ = _e451;
                    }
                    let _e453 = phi_632_;
                    phi_633_ = _e453;
                }
                let _e455 = phi_633_;
                if ((bitcast<u32>(_e108) & 2147483647u) > 2139095040u) {
                    phi_652_ = _e108;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_651_ = 0f;
                    } else {
                        if (_e108 < 0f) {
                            phi_650_ = 0f;
                        } else {
                            phi_650_ = 1f;
                        }
                        let _e464 = phi_650_;
                        phi_651_ = _e464;
                    }
                    let _e466 = phi_651_;
                    phi_652_ = _e466;
                }
                let _e468 = phi_652_;
                if ((bitcast<u32>(_e109) & 2147483647u) > 2139095040u) {
                    phi_671_ = _e109;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_670_ = 0f;
                    } else {
                        if (_e109 < 0f) {
                            phi_669_ = 0f;
                        } else {
                            phi_669_ = 1f;
                        }
                        let _e477 = phi_669_;
                        phi_670_ = _e477;
                    }
                    let _e479 = phi_670_;
                    phi_671_ = _e479;
                }
                let _e481 = phi_671_;
                let _e489 = (((((_e442 * _e145) + (_e455 * _e147)) + (_e468 * _e149)) + (_e481 * _e151)) + _e142);
                if ((bitcast<u32>(_e489) & 2147483647u) > 2139095040u) {
                    phi_696_ = _e489;
                } else {
                    if (_e489 < 0f) {
                        phi_695_ = 0f;
                    } else {
                        if (_e489 > 1f) {
                            phi_694_ = 1f;
                        } else {
                            phi_694_ = _e489;
                        }
                        let _e496 = phi_694_;
                        phi_695_ = _e496;
                    }
                    let _e498 = phi_695_;
                    phi_696_ = _e498;
                }
                let _e500 = phi_696_;
                phi_809_ = _e500;
                phi_810_ = f32();
            } else {
                let _e502 = ((0.5f * -(((((((((_e206 * (_e106 + _e107)) + (_e210 * (_e106 + _e108))) + (_e234 * (_e106 + _e152))) + (_e246 * (_e106 + _e153))) + ((((_e207 * (_e107 + _e108)) + (_e211 * (_e107 + _e109))) + (_e235 * (_e107 + _e152))) + (_e247 * (_e107 + _e153)))) + ((((_e208 * (_e108 + _e109)) + (_e212 * (_e108 + _e106))) + (_e236 * (_e108 + _e152))) + (_e248 * (_e108 + _e153)))) + ((((_e209 * (_e109 + _e106)) + (_e213 * (_e109 + _e107))) + (_e237 * (_e109 + _e152))) + (_e249 * (_e109 + _e153)))) + (_e420 * (_e152 + _e153))))) / _e423);
                let _e503 = ((((((((_e206 + _e210) + _e234) + _e246) + (((_e207 + _e211) + _e235) + _e247)) + (((_e208 + _e212) + _e236) + _e248)) + (((_e209 + _e213) + _e237) + _e249)) + _e420) / _e423);
                let _e505 = ((_e502 * _e502) - _e503);
                if (_e505 > 0f) {
                    phi_707_ = sqrt(_e505);
                } else {
                    phi_707_ = 0f;
                }
                let _e509 = phi_707_;
                if (_e502 > 0f) {
                    let _e512 = (-(_e502) - _e509);
                    phi_724_ = lt_bvh_slab_Span(_e512, (_e503 / _e512));
                } else {
                    let _e515 = (_e509 - _e502);
                    if (_e515 > 0f) {
                        phi_722_ = (_e503 / _e515);
                    } else {
                        phi_722_ = 0f;
                    }
                    let _e519 = phi_722_;
                    phi_724_ = lt_bvh_slab_Span(_e519, _e515);
                }
                let _e522 = phi_724_;
                if (_e522.near >= 0f) {
                    phi_785_ = 1f;
                    phi_786_ = f32();
                    phi_787_ = true;
                } else {
                    let _e526 = (_e522.far <= 0f);
                    if _e526 {
                        phi_783_ = (_e417 / _e423);
                        phi_784_ = f32();
                    } else {
                        let _e537 = (((((_e145 * _e106) + (_e147 * _e107)) + (_e149 * _e108)) + (_e151 * _e109)) + (_e142 * (_e152 + _e153)));
                        let _e553 = (((((_e145 * (_e106 * _e106)) + (_e147 * (_e107 * _e107))) + (_e149 * (_e108 * _e108))) + (_e151 * (_e109 * _e109))) + (_e142 * ((_e152 * _e152) + (_e153 * _e153))));
                        if (-(_e522.near) <= _e522.far) {
                            phi_782_ = (1f - (((_e522.near * _e522.near) * ((_e522.far * _e553) - _e537)) / (_e522.far - _e522.near)));
                        } else {
                            phi_782_ = ((_e417 / _e423) + (((_e522.far * _e522.far) * (_e537 - (_e522.near * _e553))) / (_e522.far - _e522.near)));
                        }
                        let _e572 = phi_782_;
                        phi_783_ = f32();
                        phi_784_ = _e572;
                    }
                    let _e574 = phi_783_;
                    let _e576 = phi_784_;
                    phi_785_ = _e574;
                    phi_786_ = _e576;
                    phi_787_ = _e526;
                }
                let _e578 = phi_785_;
                let _e580 = phi_786_;
                let _e582 = phi_787_;
                if _e582 {
                    phi_791_ = _e578;
                } else {
                    phi_791_ = _e580;
                }
                let _e584 = phi_791_;
                if ((bitcast<u32>(_e584) & 2147483647u) > 2139095040u) {
                    phi_808_ = _e584;
                } else {
                    if (_e584 < 0f) {
                        phi_807_ = 0f;
                    } else {
                        if (_e584 > 1f) {
                            phi_806_ = 1f;
                        } else {
                            phi_806_ = _e584;
                        }
                        let _e591 = phi_806_;
                        phi_807_ = _e591;
                    }
                    let _e593 = phi_807_;
                    phi_808_ = _e593;
                }
                let _e595 = phi_808_;
                phi_809_ = f32();
                phi_810_ = _e595;
            }
            let _e597 = phi_809_;
            let _e599 = phi_810_;
            phi_811_ = _e597;
            phi_812_ = _e599;
            phi_813_ = _e429;
        }
        let _e601 = phi_811_;
        let _e603 = phi_812_;
        let _e605 = phi_813_;
        phi_814_ = _e601;
        phi_815_ = _e603;
        phi_816_ = _e605;
    }
    let _e607 = phi_814_;
    let _e609 = phi_815_;
    let _e611 = phi_816_;
    if _e611 {
        phi_820_ = _e607;
    } else {
        phi_820_ = _e609;
    }
    let _e613 = phi_820_;
    return _e613;
}

fn function_() {
    var local: f32;
    var phi_880_: bool;
    var phi_881_: bool;
    var phi_882_: bool;
    var phi_883_: bool;
    var phi_887_: bool;
    var phi_957_: bool;
    var phi_958_: bool;
    var phi_969_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_970_: bool;
    var phi_971_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_972_: bool;
    var phi_979_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_983_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1003_: lt_math_LightPoint;
    var phi_1006_: u32;
    var phi_1008_: lt_math_LevelPoint;
    var phi_1094_: bool;
    var phi_1103_: bool;
    var phi_1112_: bool;
    var phi_1113_: bool;
    var phi_1114_: bool;
    var phi_1115_: bool;
    var phi_1116_: bool;
    var phi_1117_: bool;
    var phi_1118_: bool;
    var phi_1122_: bool;
    var phi_1149_: bool;
    var phi_1150_: bool;
    var phi_1151_: bool;
    var phi_1152_: bool;
    var phi_1153_: bool;
    var phi_1154_: bool;
    var phi_1155_: bool;
    var phi_1156_: bool;
    var phi_1160_: bool;
    var phi_1169_: lt_math_LightPoint;
    var phi_1170_: u32;
    var phi_1171_: lt_math_LevelPoint;
    var phi_1172_: bool;
    var phi_1004_: lt_math_LightPoint;
    var phi_1007_: u32;
    var phi_1009_: lt_math_LevelPoint;
    var phi_1173_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_1213_: bool;
    var phi_1214_: bool;
    var phi_1215_: bool;
    var phi_1216_: bool;
    var phi_1220_: bool;
    var phi_1302_: f32;
    var phi_1418_: f32;
    var phi_1419_: f32;
    var phi_1422_: f32;
    var phi_1451_: f32;
    var phi_1456_: f32;
    var phi_1457_: bool;
    var phi_1458_: f32;
    var phi_1459_: bool;
    var phi_1463_: f32;
    var phi_1483_: f32;
    var phi_1488_: f32;
    var phi_1489_: bool;
    var phi_1490_: f32;
    var phi_1491_: bool;
    var phi_1495_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_1544_: i32;
    var phi_1549_: i32;
    var phi_1554_: i32;
    var phi_1559_: i32;
    var phi_1568_: i32;
    var phi_1573_: i32;
    var phi_1578_: i32;
    var phi_1583_: i32;
    var phi_1634_: bool;
    var phi_1642_: bool;
    var phi_1654_: bool;
    var phi_1655_: bool;
    var phi_1659_: f32;
    var phi_1665_: f32;
    var phi_1667_: evaluate_Verdict;
    var phi_1672_: evaluate_Verdict;
    var phi_1673_: evaluate_Verdict;

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
                phi_880_ = (_e84 == _e86);
                phi_881_ = false;
            } else {
                phi_880_ = bool();
                phi_881_ = true;
            }
            let _e89 = phi_880_;
            let _e91 = phi_881_;
            phi_882_ = _e89;
            phi_883_ = _e91;
        } else {
            phi_882_ = bool();
            phi_883_ = true;
        }
        let _e93 = phi_882_;
        let _e95 = phi_883_;
        if _e95 {
            phi_887_ = false;
        } else {
            phi_887_ = _e93;
        }
        let _e97 = phi_887_;
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
                    phi_958_ = true;
                } else {
                    let _e150 = p.member.light.range_squared;
                    if (_e133 <= _e150) {
                        let _e153 = p.member.light.cos_outer;
                        phi_957_ = (-((((_e115 * _e135.x) + (_e116 * _e135.y)) + (_e117 * _e135.z))) >= (_e153 * sqrt(_e133)));
                    } else {
                        phi_957_ = false;
                    }
                    let _e158 = phi_957_;
                    phi_958_ = _e158;
                }
                let _e160 = phi_958_;
                if _e160 {
                    let _e162 = samples.member[(0u + _e61.first_primitive)].flags;
                    let _e170 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e176 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e170.unnamed.visibility, false), _e170.unnamed_1);
                    phi_969_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e176.unnamed, ((_e162 & 1u) == 0u));
                    phi_970_ = false;
                } else {
                    phi_969_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_970_ = true;
                }
                let _e181 = phi_969_;
                let _e183 = phi_970_;
                phi_971_ = _e181;
                phi_972_ = _e183;
            } else {
                phi_971_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_972_ = true;
            }
            let _e185 = phi_971_;
            let _e187 = phi_972_;
            if _e187 {
                let _e193 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e199 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e193.unnamed.visibility, false), _e193.unnamed_1);
                phi_979_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e199.unnamed, true);
            } else {
                phi_979_ = _e185;
            }
            let _e204 = phi_979_;
            phi_983_ = _e204;
        } else {
            let _e210 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e216 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e210.unnamed.visibility, false), _e210.unnamed_1);
            phi_983_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e216.unnamed, true);
        }
        let _e221 = phi_983_;
        if _e221.unnamed_1 {
            phi_1673_ = evaluate_Verdict(_e221.unnamed.visibility, _e221.unnamed.is_doubted);
        } else {
            let _e229 = samples.member[(0u + _e61.first_primitive)].position;
            let _e231 = p.member.map_size;
            let _e233 = (0.5f / f32(_e231));
            let _e240 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e247 = lt_math_LightPoint(vec2<f32>(_e240.uv.x, 0f), _e240.depth, _e240.is_inside);
            let _e251 = lt_math_LightPoint(_e247.uv, 0f, _e247.is_inside);
            phi_1003_ = lt_math_LightPoint();
            phi_1006_ = 0u;
            phi_1008_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e251.uv, _e251.depth, false));
            loop {
                let _e258 = phi_1003_;
                let _e260 = phi_1006_;
                let _e262 = phi_1008_;
                local_1 = _e262;
                local_2 = _e262;
                local_3 = _e262;
                if (_e260 < _e67) {
                    if _e262.point.is_inside {
                        phi_1169_ = lt_math_LightPoint();
                        phi_1170_ = u32();
                        phi_1171_ = lt_math_LevelPoint();
                        phi_1172_ = false;
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
                                phi_1094_ = (_e298 <= 1f);
                            } else {
                                phi_1094_ = false;
                            }
                            let _e330 = phi_1094_;
                            if _e330 {
                                if (_e312 >= 0f) {
                                    phi_1103_ = (_e312 <= 1f);
                                } else {
                                    phi_1103_ = false;
                                }
                                let _e334 = phi_1103_;
                                if _e334 {
                                    if (_e325 >= 0f) {
                                        phi_1112_ = (_e325 <= 1f);
                                    } else {
                                        phi_1112_ = false;
                                    }
                                    let _e338 = phi_1112_;
                                    phi_1113_ = _e338;
                                    phi_1114_ = false;
                                } else {
                                    phi_1113_ = bool();
                                    phi_1114_ = true;
                                }
                                let _e340 = phi_1113_;
                                let _e342 = phi_1114_;
                                phi_1115_ = _e340;
                                phi_1116_ = _e342;
                            } else {
                                phi_1115_ = bool();
                                phi_1116_ = true;
                            }
                            let _e344 = phi_1115_;
                            let _e346 = phi_1116_;
                            phi_1117_ = _e344;
                            phi_1118_ = _e346;
                        } else {
                            phi_1117_ = bool();
                            phi_1118_ = true;
                        }
                        let _e348 = phi_1117_;
                        let _e350 = phi_1118_;
                        if _e350 {
                            phi_1122_ = false;
                        } else {
                            phi_1122_ = _e348;
                        }
                        let _e352 = phi_1122_;
                        if _e352 {
                            if (_e298 >= _e233) {
                                if (_e298 <= (1f - _e233)) {
                                    if (_e312 >= _e233) {
                                        phi_1149_ = (_e312 <= (1f - _e233));
                                        phi_1150_ = false;
                                    } else {
                                        phi_1149_ = bool();
                                        phi_1150_ = true;
                                    }
                                    let _e360 = phi_1149_;
                                    let _e362 = phi_1150_;
                                    phi_1151_ = _e360;
                                    phi_1152_ = _e362;
                                } else {
                                    phi_1151_ = bool();
                                    phi_1152_ = true;
                                }
                                let _e364 = phi_1151_;
                                let _e366 = phi_1152_;
                                phi_1153_ = _e364;
                                phi_1154_ = _e366;
                            } else {
                                phi_1153_ = bool();
                                phi_1154_ = true;
                            }
                            let _e368 = phi_1153_;
                            let _e370 = phi_1154_;
                            phi_1155_ = _e368;
                            phi_1156_ = _e370;
                        } else {
                            phi_1155_ = bool();
                            phi_1156_ = true;
                        }
                        let _e372 = phi_1155_;
                        let _e374 = phi_1156_;
                        if _e374 {
                            phi_1160_ = false;
                        } else {
                            phi_1160_ = _e372;
                        }
                        let _e376 = phi_1160_;
                        let _e383 = lt_math_LightPoint(vec2<f32>(_e298, _e258.uv.y), _e258.depth, _e258.is_inside);
                        let _e390 = lt_math_LightPoint(vec2<f32>(_e383.uv.x, _e312), _e383.depth, _e383.is_inside);
                        let _e394 = lt_math_LightPoint(_e390.uv, _e325, _e390.is_inside);
                        let _e398 = lt_math_LightPoint(_e394.uv, _e394.depth, _e376);
                        phi_1169_ = _e398;
                        phi_1170_ = (_e260 + 1u);
                        phi_1171_ = lt_math_LevelPoint(_e260, _e398);
                        phi_1172_ = true;
                    }
                    let _e402 = phi_1169_;
                    let _e404 = phi_1170_;
                    let _e406 = phi_1171_;
                    let _e408 = phi_1172_;
                    phi_1004_ = _e402;
                    phi_1007_ = _e404;
                    phi_1009_ = _e406;
                    phi_1173_ = _e408;
                } else {
                    phi_1004_ = lt_math_LightPoint();
                    phi_1007_ = u32();
                    phi_1009_ = lt_math_LevelPoint();
                    phi_1173_ = false;
                }
                let _e410 = phi_1004_;
                let _e412 = phi_1007_;
                let _e414 = phi_1009_;
                let _e416 = phi_1173_;
                continue;
                continuing {
                    phi_1003_ = _e410;
                    phi_1006_ = _e412;
                    phi_1008_ = _e414;
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
                            phi_1213_ = (_e430.row_w.z == _e442);
                            phi_1214_ = false;
                        } else {
                            phi_1213_ = bool();
                            phi_1214_ = true;
                        }
                        let _e445 = phi_1213_;
                        let _e447 = phi_1214_;
                        phi_1215_ = _e445;
                        phi_1216_ = _e447;
                    } else {
                        phi_1215_ = bool();
                        phi_1216_ = true;
                    }
                    let _e449 = phi_1215_;
                    let _e451 = phi_1216_;
                    if _e451 {
                        phi_1220_ = false;
                    } else {
                        phi_1220_ = _e449;
                    }
                    let _e453 = phi_1220_;
                    if _e453 {
                        let _e455 = samples.member[(0u + _e61.first_primitive)].normal;
                        let _e457 = p.member.map_size;
                        let _e527 = ((abs(((((_e430.row_x.x * _e455.x) + (_e430.row_x.y * _e455.y)) + (_e430.row_x.z * _e455.z)) / (((_e430.row_x.x * _e430.row_x.x) + (_e430.row_x.y * _e430.row_x.y)) + (_e430.row_x.z * _e430.row_x.z)))) + abs(((((_e430.row_y.x * _e455.x) + (_e430.row_y.y * _e455.y)) + (_e430.row_y.z * _e455.z)) / (((_e430.row_y.x * _e430.row_y.x) + (_e430.row_y.y * _e430.row_y.y)) + (_e430.row_y.z * _e430.row_y.z))))) / (abs(((((_e430.row_z.x * _e455.x) + (_e430.row_z.y * _e455.y)) + (_e430.row_z.z * _e455.z)) / (((_e430.row_z.x * _e430.row_z.x) + (_e430.row_z.y * _e430.row_z.y)) + (_e430.row_z.z * _e430.row_z.z)))) * f32(_e457)));
                        if (_e527 < 0.002f) {
                            phi_1302_ = _e527;
                        } else {
                            phi_1302_ = 0.002f;
                        }
                        let _e530 = phi_1302_;
                        phi_1419_ = _e530;
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
                            phi_1418_ = _e644;
                        } else {
                            phi_1418_ = 0.002f;
                        }
                        let _e647 = phi_1418_;
                        phi_1419_ = _e647;
                    }
                    let _e649 = phi_1419_;
                    phi_1422_ = (_e419.point.depth - (0f * _e649));
                } else {
                    phi_1422_ = _e419.point.depth;
                }
                let _e653 = phi_1422_;
                let _e659 = p.member.map_size;
                let _e660 = f32(_e659);
                let _e663 = ((_e419.point.uv.x * _e660) - 0.5f);
                let _e664 = ((_e419.point.uv.y * _e660) - 0.5f);
                if (_e663 > -8388608f) {
                    let _e676 = f32(select(0i, select(select(i32(_e663), i32(-2147483648), (_e663 < bitcast<f32>(3472883712u))), 2147483647i, (_e663 > bitcast<f32>(1325400063u))), (_e663 == _e663)));
                    if (_e676 > _e663) {
                        phi_1451_ = 1f;
                    } else {
                        phi_1451_ = 0f;
                    }
                    let _e679 = phi_1451_;
                    if (_e663 < 8388608f) {
                        phi_1456_ = (_e676 - _e679);
                        phi_1457_ = false;
                    } else {
                        phi_1456_ = f32();
                        phi_1457_ = true;
                    }
                    let _e682 = phi_1456_;
                    let _e684 = phi_1457_;
                    phi_1458_ = _e682;
                    phi_1459_ = _e684;
                } else {
                    phi_1458_ = f32();
                    phi_1459_ = true;
                }
                let _e686 = phi_1458_;
                let _e688 = phi_1459_;
                if _e688 {
                    phi_1463_ = _e663;
                } else {
                    phi_1463_ = _e686;
                }
                let _e690 = phi_1463_;
                if (_e664 > -8388608f) {
                    let _e702 = f32(select(0i, select(select(i32(_e664), i32(-2147483648), (_e664 < bitcast<f32>(3472883712u))), 2147483647i, (_e664 > bitcast<f32>(1325400063u))), (_e664 == _e664)));
                    if (_e702 > _e664) {
                        phi_1483_ = 1f;
                    } else {
                        phi_1483_ = 0f;
                    }
                    let _e705 = phi_1483_;
                    if (_e664 < 8388608f) {
                        phi_1488_ = (_e702 - _e705);
                        phi_1489_ = false;
                    } else {
                        phi_1488_ = f32();
                        phi_1489_ = true;
                    }
                    let _e708 = phi_1488_;
                    let _e710 = phi_1489_;
                    phi_1490_ = _e708;
                    phi_1491_ = _e710;
                } else {
                    phi_1490_ = f32();
                    phi_1491_ = true;
                }
                let _e712 = phi_1490_;
                let _e714 = phi_1491_;
                if _e714 {
                    phi_1495_ = _e664;
                } else {
                    phi_1495_ = _e712;
                }
                let _e716 = phi_1495_;
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
                    phi_1544_ = _e727;
                } else {
                    phi_1544_ = 0i;
                }
                let _e760 = phi_1544_;
                if (_e736 > 0i) {
                    phi_1549_ = _e736;
                } else {
                    phi_1549_ = 0i;
                }
                let _e763 = phi_1549_;
                if (_e760 < _e757) {
                    phi_1554_ = _e760;
                } else {
                    phi_1554_ = _e757;
                }
                let _e766 = phi_1554_;
                if (_e763 < _e757) {
                    phi_1559_ = _e763;
                } else {
                    phi_1559_ = _e757;
                }
                let _e769 = phi_1559_;
                let _e770 = bitcast<u32>(_e766);
                let _e772 = (_e727 + 1i);
                let _e773 = (_e736 + 1i);
                if (_e772 > 0i) {
                    phi_1568_ = _e772;
                } else {
                    phi_1568_ = 0i;
                }
                let _e776 = phi_1568_;
                if (_e773 > 0i) {
                    phi_1573_ = _e773;
                } else {
                    phi_1573_ = 0i;
                }
                let _e779 = phi_1573_;
                if (_e776 < _e757) {
                    phi_1578_ = _e776;
                } else {
                    phi_1578_ = _e757;
                }
                let _e782 = phi_1578_;
                if (_e779 < _e757) {
                    phi_1583_ = _e779;
                } else {
                    phi_1583_ = _e757;
                }
                let _e785 = phi_1583_;
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
                let _e817 = p.member.epsilon;
                if (_e815 <= _e817) {
                    phi_1634_ = true;
                } else {
                    phi_1634_ = (_e815 >= (1f - _e817));
                }
                let _e822 = phi_1634_;
                if ((bitcast<u32>(_e815) & 2147483647u) > 2139095040u) {
                    phi_1642_ = true;
                } else {
                    phi_1642_ = !(_e822);
                }
                let _e828 = phi_1642_;
                if _e828 {
                    if (_e815 > 0f) {
                        if (_e815 < 1f) {
                            phi_1654_ = false;
                        } else {
                            phi_1654_ = true;
                        }
                        let _e832 = phi_1654_;
                        phi_1655_ = _e832;
                    } else {
                        phi_1655_ = true;
                    }
                    let _e834 = phi_1655_;
                    if _e834 {
                        phi_1659_ = 0.5f;
                    } else {
                        phi_1659_ = _e815;
                    }
                    let _e836 = phi_1659_;
                    phi_1667_ = evaluate_Verdict(_e836, true);
                } else {
                    if (_e815 > 0.5f) {
                        phi_1665_ = 1f;
                    } else {
                        phi_1665_ = 0f;
                    }
                    let _e840 = phi_1665_;
                    phi_1667_ = evaluate_Verdict(_e840, false);
                }
                let _e843 = phi_1667_;
                phi_1672_ = evaluate_Verdict(_e843.visibility, _e843.is_doubted);
            } else {
                phi_1672_ = evaluate_Verdict(0.5f, true);
            }
            let _e849 = phi_1672_;
            phi_1673_ = _e849;
        }
        let _e851 = phi_1673_;
        if (_e61.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e61.first_primitive)] = _e851.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_msm_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
