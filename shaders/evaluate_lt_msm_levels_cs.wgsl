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
    var phi_144_: lt_bvh_traverse_Tree;
    var phi_145_: bool;
    var phi_146_: lt_bvh_traverse_Tree;
    var phi_147_: bool;
    var phi_152_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_144_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_145_ = false;
        } else {
            phi_144_ = lt_bvh_traverse_Tree();
            phi_145_ = true;
        }
        let _e54 = phi_144_;
        let _e56 = phi_145_;
        phi_146_ = _e54;
        phi_147_ = _e56;
    } else {
        phi_146_ = lt_bvh_traverse_Tree();
        phi_147_ = true;
    }
    let _e58 = phi_146_;
    let _e60 = phi_147_;
    if _e60 {
        phi_152_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_152_ = _e58;
    }
    let _e65 = phi_152_;
    return lt_bvh_traverse_Tree(_e65.root, _e65.first_primitive);
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_179_: f32;
    var phi_180_: f32;
    var phi_181_: f32;
    var phi_198_: f32;
    var phi_199_: f32;
    var phi_200_: f32;
    var phi_216_: f32;
    var phi_217_: f32;
    var phi_218_: f32;
    var phi_234_: f32;
    var phi_235_: f32;
    var phi_236_: f32;
    var phi_252_: f32;
    var phi_253_: f32;
    var phi_254_: f32;
    var phi_289_: bool;
    var phi_290_: bool;
    var phi_291_: bool;
    var phi_292_: bool;
    var phi_293_: bool;
    var phi_294_: bool;
    var phi_298_: bool;
    var phi_609_: f32;
    var phi_610_: f32;
    var phi_611_: f32;
    var phi_628_: f32;
    var phi_629_: f32;
    var phi_630_: f32;
    var phi_647_: f32;
    var phi_648_: f32;
    var phi_649_: f32;
    var phi_666_: f32;
    var phi_667_: f32;
    var phi_668_: f32;
    var phi_691_: f32;
    var phi_692_: f32;
    var phi_693_: f32;
    var phi_704_: f32;
    var phi_719_: f32;
    var phi_721_: lt_bvh_slab_Span;
    var phi_779_: f32;
    var phi_780_: f32;
    var phi_781_: f32;
    var phi_782_: f32;
    var phi_783_: f32;
    var phi_784_: bool;
    var phi_788_: f32;
    var phi_803_: f32;
    var phi_804_: f32;
    var phi_805_: f32;
    var phi_806_: f32;
    var phi_807_: f32;
    var phi_808_: f32;
    var phi_809_: f32;
    var phi_810_: bool;
    var phi_811_: f32;
    var phi_812_: f32;
    var phi_813_: bool;
    var phi_817_: f32;

    let _e45 = (*param_4);
    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_181_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_180_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_179_ = 1f;
            } else {
                phi_179_ = param_7;
            }
            let _e52 = phi_179_;
            phi_180_ = _e52;
        }
        let _e54 = phi_180_;
        phi_181_ = _e54;
    }
    let _e56 = phi_181_;
    let _e57 = (_e56 - 0.00000047683716f);
    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_200_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_199_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_198_ = 1f;
            } else {
                phi_198_ = param_5.x;
            }
            let _e65 = phi_198_;
            phi_199_ = _e65;
        }
        let _e67 = phi_199_;
        phi_200_ = _e67;
    }
    let _e69 = phi_200_;
    if ((bitcast<u32>(param_5.y) & 2147483647u) > 2139095040u) {
        phi_218_ = param_5.y;
    } else {
        if (param_5.y < 0f) {
            phi_217_ = 0f;
        } else {
            if (param_5.y > 1f) {
                phi_216_ = 1f;
            } else {
                phi_216_ = param_5.y;
            }
            let _e77 = phi_216_;
            phi_217_ = _e77;
        }
        let _e79 = phi_217_;
        phi_218_ = _e79;
    }
    let _e81 = phi_218_;
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_236_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_235_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_234_ = 1f;
            } else {
                phi_234_ = param_5.z;
            }
            let _e89 = phi_234_;
            phi_235_ = _e89;
        }
        let _e91 = phi_235_;
        phi_236_ = _e91;
    }
    let _e93 = phi_236_;
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_254_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_253_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_252_ = 1f;
            } else {
                phi_252_ = param_5.w;
            }
            let _e101 = phi_252_;
            phi_253_ = _e101;
        }
        let _e103 = phi_253_;
        phi_254_ = _e103;
    }
    let _e105 = phi_254_;
    let _e106 = (_e69 - _e57);
    let _e107 = (_e81 - _e57);
    let _e108 = (_e93 - _e57);
    let _e109 = (_e105 - _e57);
    let _e120 = ((((_e106 * param_6.x) + (_e107 * param_6.y)) + (_e108 * param_6.z)) + (_e109 * param_6.w));
    if ((bitcast<u32>(_e120) & 2147483647u) > 2139095040u) {
        phi_811_ = _e120;
        phi_812_ = f32();
        phi_813_ = true;
    } else {
        if (_e106 >= 0f) {
            if (_e107 >= 0f) {
                if (_e108 >= 0f) {
                    phi_289_ = (_e109 >= 0f);
                    phi_290_ = false;
                } else {
                    phi_289_ = bool();
                    phi_290_ = true;
                }
                let _e129 = phi_289_;
                let _e131 = phi_290_;
                phi_291_ = _e129;
                phi_292_ = _e131;
            } else {
                phi_291_ = bool();
                phi_292_ = true;
            }
            let _e133 = phi_291_;
            let _e135 = phi_292_;
            phi_293_ = _e133;
            phi_294_ = _e135;
        } else {
            phi_293_ = bool();
            phi_294_ = true;
        }
        let _e137 = phi_293_;
        let _e139 = phi_294_;
        if _e139 {
            phi_298_ = false;
        } else {
            phi_298_ = _e137;
        }
        let _e141 = phi_298_;
        if _e141 {
            phi_808_ = 1f;
            phi_809_ = f32();
            phi_810_ = true;
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
                    phi_611_ = _e106;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_610_ = 0f;
                    } else {
                        if (_e106 < 0f) {
                            phi_609_ = 0f;
                        } else {
                            phi_609_ = 1f;
                        }
                        let _e438 = phi_609_;
                        phi_610_ = _e438;
                    }
                    let _e440 = phi_610_;
                    phi_611_ = _e440;
                }
                let _e442 = phi_611_;
                if ((bitcast<u32>(_e107) & 2147483647u) > 2139095040u) {
                    phi_630_ = _e107;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_629_ = 0f;
                    } else {
                        if (_e107 < 0f) {
                            phi_628_ = 0f;
                        } else {
                            phi_628_ = 1f;
                        }
                        let _e451 = phi_628_;
                        phi_629_ = _e451;
                    }
                    let _e453 = phi_629_;
                    phi_630_ = _e453;
                }
                let _e455 = phi_630_;
                if ((bitcast<u32>(_e108) & 2147483647u) > 2139095040u) {
                    phi_649_ = _e108;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_648_ = 0f;
                    } else {
                        if (_e108 < 0f) {
                            phi_647_ = 0f;
                        } else {
                            phi_647_ = 1f;
                        }
                        let _e464 = phi_647_;
                        phi_648_ = _e464;
                    }
                    let _e466 = phi_648_;
                    phi_649_ = _e466;
                }
                let _e468 = phi_649_;
                if ((bitcast<u32>(_e109) & 2147483647u) > 2139095040u) {
                    phi_668_ = _e109;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_667_ = 0f;
                    } else {
                        if (_e109 < 0f) {
                            phi_666_ = 0f;
                        } else {
                            phi_666_ = 1f;
                        }
                        let _e477 = phi_666_;
                        phi_667_ = _e477;
                    }
                    let _e479 = phi_667_;
                    phi_668_ = _e479;
                }
                let _e481 = phi_668_;
                let _e489 = (((((_e442 * _e145) + (_e455 * _e147)) + (_e468 * _e149)) + (_e481 * _e151)) + _e142);
                if ((bitcast<u32>(_e489) & 2147483647u) > 2139095040u) {
                    phi_693_ = _e489;
                } else {
                    if (_e489 < 0f) {
                        phi_692_ = 0f;
                    } else {
                        if (_e489 > 1f) {
                            phi_691_ = 1f;
                        } else {
                            phi_691_ = _e489;
                        }
                        let _e496 = phi_691_;
                        phi_692_ = _e496;
                    }
                    let _e498 = phi_692_;
                    phi_693_ = _e498;
                }
                let _e500 = phi_693_;
                phi_806_ = _e500;
                phi_807_ = f32();
            } else {
                let _e502 = ((0.5f * -(((((((((_e206 * (_e106 + _e107)) + (_e210 * (_e106 + _e108))) + (_e234 * (_e106 + _e152))) + (_e246 * (_e106 + _e153))) + ((((_e207 * (_e107 + _e108)) + (_e211 * (_e107 + _e109))) + (_e235 * (_e107 + _e152))) + (_e247 * (_e107 + _e153)))) + ((((_e208 * (_e108 + _e109)) + (_e212 * (_e108 + _e106))) + (_e236 * (_e108 + _e152))) + (_e248 * (_e108 + _e153)))) + ((((_e209 * (_e109 + _e106)) + (_e213 * (_e109 + _e107))) + (_e237 * (_e109 + _e152))) + (_e249 * (_e109 + _e153)))) + (_e420 * (_e152 + _e153))))) / _e423);
                let _e503 = ((((((((_e206 + _e210) + _e234) + _e246) + (((_e207 + _e211) + _e235) + _e247)) + (((_e208 + _e212) + _e236) + _e248)) + (((_e209 + _e213) + _e237) + _e249)) + _e420) / _e423);
                let _e505 = ((_e502 * _e502) - _e503);
                if (_e505 > 0f) {
                    phi_704_ = sqrt(_e505);
                } else {
                    phi_704_ = 0f;
                }
                let _e509 = phi_704_;
                if (_e502 > 0f) {
                    let _e512 = (-(_e502) - _e509);
                    phi_721_ = lt_bvh_slab_Span(_e512, (_e503 / _e512));
                } else {
                    let _e515 = (_e509 - _e502);
                    if (_e515 > 0f) {
                        phi_719_ = (_e503 / _e515);
                    } else {
                        phi_719_ = 0f;
                    }
                    let _e519 = phi_719_;
                    phi_721_ = lt_bvh_slab_Span(_e519, _e515);
                }
                let _e522 = phi_721_;
                if (_e522.near >= 0f) {
                    phi_782_ = 1f;
                    phi_783_ = f32();
                    phi_784_ = true;
                } else {
                    let _e526 = (_e522.far <= 0f);
                    if _e526 {
                        phi_780_ = (_e417 / _e423);
                        phi_781_ = f32();
                    } else {
                        let _e537 = (((((_e145 * _e106) + (_e147 * _e107)) + (_e149 * _e108)) + (_e151 * _e109)) + (_e142 * (_e152 + _e153)));
                        let _e553 = (((((_e145 * (_e106 * _e106)) + (_e147 * (_e107 * _e107))) + (_e149 * (_e108 * _e108))) + (_e151 * (_e109 * _e109))) + (_e142 * ((_e152 * _e152) + (_e153 * _e153))));
                        if (-(_e522.near) <= _e522.far) {
                            phi_779_ = (1f - (((_e522.near * _e522.near) * ((_e522.far * _e553) - _e537)) / (_e522.far - _e522.near)));
                        } else {
                            phi_779_ = ((_e417 / _e423) + (((_e522.far * _e522.far) * (_e537 - (_e522.near * _e553))) / (_e522.far - _e522.near)));
                        }
                        let _e572 = phi_779_;
                        phi_780_ = f32();
                        phi_781_ = _e572;
                    }
                    let _e574 = phi_780_;
                    let _e576 = phi_781_;
                    phi_782_ = _e574;
                    phi_783_ = _e576;
                    phi_784_ = _e526;
                }
                let _e578 = phi_782_;
                let _e580 = phi_783_;
                let _e582 = phi_784_;
                if _e582 {
                    phi_788_ = _e578;
                } else {
                    phi_788_ = _e580;
                }
                let _e584 = phi_788_;
                if ((bitcast<u32>(_e584) & 2147483647u) > 2139095040u) {
                    phi_805_ = _e584;
                } else {
                    if (_e584 < 0f) {
                        phi_804_ = 0f;
                    } else {
                        if (_e584 > 1f) {
                            phi_803_ = 1f;
                        } else {
                            phi_803_ = _e584;
                        }
                        let _e591 = phi_803_;
                        phi_804_ = _e591;
                    }
                    let _e593 = phi_804_;
                    phi_805_ = _e593;
                }
                let _e595 = phi_805_;
                phi_806_ = f32();
                phi_807_ = _e595;
            }
            let _e597 = phi_806_;
            let _e599 = phi_807_;
            phi_808_ = _e597;
            phi_809_ = _e599;
            phi_810_ = _e429;
        }
        let _e601 = phi_808_;
        let _e603 = phi_809_;
        let _e605 = phi_810_;
        phi_811_ = _e601;
        phi_812_ = _e603;
        phi_813_ = _e605;
    }
    let _e607 = phi_811_;
    let _e609 = phi_812_;
    let _e611 = phi_813_;
    if _e611 {
        phi_817_ = _e607;
    } else {
        phi_817_ = _e609;
    }
    let _e613 = phi_817_;
    return _e613;
}

fn function_() {
    var local: f32;
    var phi_878_: bool;
    var phi_879_: bool;
    var phi_880_: bool;
    var phi_881_: bool;
    var phi_885_: bool;
    var phi_929_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_933_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_953_: lt_math_LightPoint;
    var phi_956_: u32;
    var phi_958_: lt_math_LevelPoint;
    var phi_1044_: bool;
    var phi_1053_: bool;
    var phi_1062_: bool;
    var phi_1063_: bool;
    var phi_1064_: bool;
    var phi_1065_: bool;
    var phi_1066_: bool;
    var phi_1067_: bool;
    var phi_1068_: bool;
    var phi_1072_: bool;
    var phi_1099_: bool;
    var phi_1100_: bool;
    var phi_1101_: bool;
    var phi_1102_: bool;
    var phi_1103_: bool;
    var phi_1104_: bool;
    var phi_1105_: bool;
    var phi_1106_: bool;
    var phi_1110_: bool;
    var phi_1119_: lt_math_LightPoint;
    var phi_1120_: u32;
    var phi_1121_: lt_math_LevelPoint;
    var phi_1122_: bool;
    var phi_954_: lt_math_LightPoint;
    var phi_957_: u32;
    var phi_959_: lt_math_LevelPoint;
    var phi_1123_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_1163_: bool;
    var phi_1164_: bool;
    var phi_1165_: bool;
    var phi_1166_: bool;
    var phi_1170_: bool;
    var phi_1252_: f32;
    var phi_1368_: f32;
    var phi_1369_: f32;
    var phi_1372_: f32;
    var phi_1401_: f32;
    var phi_1406_: f32;
    var phi_1407_: bool;
    var phi_1408_: f32;
    var phi_1409_: bool;
    var phi_1413_: f32;
    var phi_1433_: f32;
    var phi_1438_: f32;
    var phi_1439_: bool;
    var phi_1440_: f32;
    var phi_1441_: bool;
    var phi_1445_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_1494_: i32;
    var phi_1499_: i32;
    var phi_1504_: i32;
    var phi_1509_: i32;
    var phi_1518_: i32;
    var phi_1523_: i32;
    var phi_1528_: i32;
    var phi_1533_: i32;
    var phi_1584_: bool;
    var phi_1592_: bool;
    var phi_1604_: bool;
    var phi_1605_: bool;
    var phi_1609_: f32;
    var phi_1615_: f32;
    var phi_1617_: evaluate_Verdict;
    var phi_1622_: evaluate_Verdict;
    var phi_1623_: evaluate_Verdict;

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
        let _e72 = p.member.light;
        let _e75 = samples.member[(0u + _e61.first_primitive)].normal[0u];
        let _e77 = global[0u];
        if (_e75 == _e77) {
            let _e80 = samples.member[(0u + _e61.first_primitive)].normal[1u];
            let _e82 = global[1u];
            if (_e80 == _e82) {
                let _e85 = samples.member[(0u + _e61.first_primitive)].normal[2u];
                let _e87 = global[2u];
                phi_878_ = (_e85 == _e87);
                phi_879_ = false;
            } else {
                phi_878_ = bool();
                phi_879_ = true;
            }
            let _e90 = phi_878_;
            let _e92 = phi_879_;
            phi_880_ = _e90;
            phi_881_ = _e92;
        } else {
            phi_880_ = bool();
            phi_881_ = true;
        }
        let _e94 = phi_880_;
        let _e96 = phi_881_;
        if _e96 {
            phi_885_ = false;
        } else {
            phi_885_ = _e94;
        }
        let _e98 = phi_885_;
        if !(_e98) {
            let _e101 = samples.member[(0u + _e61.first_primitive)].normal;
            let _e103 = samples.member[(0u + _e61.first_primitive)].position;
            if ((((_e101.x * (_e72.x - (_e103.x * _e72.w))) + (_e101.y * (_e72.y - (_e103.y * _e72.w)))) + (_e101.z * (_e72.z - (_e103.z * _e72.w)))) > 0f) {
                let _e127 = samples.member[(0u + _e61.first_primitive)].flags;
                let _e135 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e141 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e135.unnamed.visibility, false), _e135.unnamed_1);
                phi_929_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e141.unnamed, ((_e127 & 1u) == 0u));
            } else {
                let _e150 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e156 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e150.unnamed.visibility, false), _e150.unnamed_1);
                phi_929_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e156.unnamed, true);
            }
            let _e161 = phi_929_;
            phi_933_ = _e161;
        } else {
            let _e167 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e173 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e167.unnamed.visibility, false), _e167.unnamed_1);
            phi_933_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e173.unnamed, true);
        }
        let _e178 = phi_933_;
        if _e178.unnamed_1 {
            phi_1623_ = evaluate_Verdict(_e178.unnamed.visibility, _e178.unnamed.is_doubted);
        } else {
            let _e186 = samples.member[(0u + _e61.first_primitive)].position;
            let _e188 = p.member.map_size;
            let _e190 = (0.5f / f32(_e188));
            let _e197 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e204 = lt_math_LightPoint(vec2<f32>(_e197.uv.x, 0f), _e197.depth, _e197.is_inside);
            let _e208 = lt_math_LightPoint(_e204.uv, 0f, _e204.is_inside);
            phi_953_ = lt_math_LightPoint();
            phi_956_ = 0u;
            phi_958_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e208.uv, _e208.depth, false));
            loop {
                let _e215 = phi_953_;
                let _e217 = phi_956_;
                let _e219 = phi_958_;
                local_1 = _e219;
                local_2 = _e219;
                local_3 = _e219;
                if (_e217 < _e67) {
                    if _e219.point.is_inside {
                        phi_1119_ = lt_math_LightPoint();
                        phi_1120_ = u32();
                        phi_1121_ = lt_math_LevelPoint();
                        phi_1122_ = false;
                    } else {
                        if (_e217 < _e55) {
                        } else {
                            return;
                        }
                        let _e230 = levels.member[(0u + _e217)].row_w;
                        let _e241 = ((((_e230.x * _e186.x) + (_e230.y * _e186.y)) + (_e230.z * _e186.z)) + (_e230.w * 1f));
                        let _e243 = levels.member[(0u + _e217)].row_x;
                        let _e255 = (((((_e243.x * _e186.x) + (_e243.y * _e186.y)) + (_e243.z * _e186.z)) + (_e243.w * 1f)) / _e241);
                        let _e257 = levels.member[(0u + _e217)].row_y;
                        let _e269 = (((((_e257.x * _e186.x) + (_e257.y * _e186.y)) + (_e257.z * _e186.z)) + (_e257.w * 1f)) / _e241);
                        let _e271 = levels.member[(0u + _e217)].row_z;
                        let _e282 = ((((_e271.x * _e186.x) + (_e271.y * _e186.y)) + (_e271.z * _e186.z)) + (_e271.w * 1f));
                        if (_e241 > 0f) {
                            if (_e255 >= 0f) {
                                phi_1044_ = (_e255 <= 1f);
                            } else {
                                phi_1044_ = false;
                            }
                            let _e287 = phi_1044_;
                            if _e287 {
                                if (_e269 >= 0f) {
                                    phi_1053_ = (_e269 <= 1f);
                                } else {
                                    phi_1053_ = false;
                                }
                                let _e291 = phi_1053_;
                                if _e291 {
                                    if (_e282 >= 0f) {
                                        phi_1062_ = (_e282 <= 1f);
                                    } else {
                                        phi_1062_ = false;
                                    }
                                    let _e295 = phi_1062_;
                                    phi_1063_ = _e295;
                                    phi_1064_ = false;
                                } else {
                                    phi_1063_ = bool();
                                    phi_1064_ = true;
                                }
                                let _e297 = phi_1063_;
                                let _e299 = phi_1064_;
                                phi_1065_ = _e297;
                                phi_1066_ = _e299;
                            } else {
                                phi_1065_ = bool();
                                phi_1066_ = true;
                            }
                            let _e301 = phi_1065_;
                            let _e303 = phi_1066_;
                            phi_1067_ = _e301;
                            phi_1068_ = _e303;
                        } else {
                            phi_1067_ = bool();
                            phi_1068_ = true;
                        }
                        let _e305 = phi_1067_;
                        let _e307 = phi_1068_;
                        if _e307 {
                            phi_1072_ = false;
                        } else {
                            phi_1072_ = _e305;
                        }
                        let _e309 = phi_1072_;
                        if _e309 {
                            if (_e255 >= _e190) {
                                if (_e255 <= (1f - _e190)) {
                                    if (_e269 >= _e190) {
                                        phi_1099_ = (_e269 <= (1f - _e190));
                                        phi_1100_ = false;
                                    } else {
                                        phi_1099_ = bool();
                                        phi_1100_ = true;
                                    }
                                    let _e317 = phi_1099_;
                                    let _e319 = phi_1100_;
                                    phi_1101_ = _e317;
                                    phi_1102_ = _e319;
                                } else {
                                    phi_1101_ = bool();
                                    phi_1102_ = true;
                                }
                                let _e321 = phi_1101_;
                                let _e323 = phi_1102_;
                                phi_1103_ = _e321;
                                phi_1104_ = _e323;
                            } else {
                                phi_1103_ = bool();
                                phi_1104_ = true;
                            }
                            let _e325 = phi_1103_;
                            let _e327 = phi_1104_;
                            phi_1105_ = _e325;
                            phi_1106_ = _e327;
                        } else {
                            phi_1105_ = bool();
                            phi_1106_ = true;
                        }
                        let _e329 = phi_1105_;
                        let _e331 = phi_1106_;
                        if _e331 {
                            phi_1110_ = false;
                        } else {
                            phi_1110_ = _e329;
                        }
                        let _e333 = phi_1110_;
                        let _e340 = lt_math_LightPoint(vec2<f32>(_e255, _e215.uv.y), _e215.depth, _e215.is_inside);
                        let _e347 = lt_math_LightPoint(vec2<f32>(_e340.uv.x, _e269), _e340.depth, _e340.is_inside);
                        let _e351 = lt_math_LightPoint(_e347.uv, _e282, _e347.is_inside);
                        let _e355 = lt_math_LightPoint(_e351.uv, _e351.depth, _e333);
                        phi_1119_ = _e355;
                        phi_1120_ = (_e217 + 1u);
                        phi_1121_ = lt_math_LevelPoint(_e217, _e355);
                        phi_1122_ = true;
                    }
                    let _e359 = phi_1119_;
                    let _e361 = phi_1120_;
                    let _e363 = phi_1121_;
                    let _e365 = phi_1122_;
                    phi_954_ = _e359;
                    phi_957_ = _e361;
                    phi_959_ = _e363;
                    phi_1123_ = _e365;
                } else {
                    phi_954_ = lt_math_LightPoint();
                    phi_957_ = u32();
                    phi_959_ = lt_math_LevelPoint();
                    phi_1123_ = false;
                }
                let _e367 = phi_954_;
                let _e369 = phi_957_;
                let _e371 = phi_959_;
                let _e373 = phi_1123_;
                continue;
                continuing {
                    phi_953_ = _e367;
                    phi_956_ = _e369;
                    phi_958_ = _e371;
                    break if !(_e373);
                }
            }
            let _e376 = local_1;
            if _e376.point.is_inside {
                if (0f > 0f) {
                    let _e382 = local_2;
                    if (_e382.level < _e55) {
                    } else {
                        return;
                    }
                    let _e387 = levels.member[(0u + _e382.level)];
                    let _e393 = global[0u];
                    if (_e387.row_w.x == _e393) {
                        let _e396 = global[1u];
                        if (_e387.row_w.y == _e396) {
                            let _e399 = global[2u];
                            phi_1163_ = (_e387.row_w.z == _e399);
                            phi_1164_ = false;
                        } else {
                            phi_1163_ = bool();
                            phi_1164_ = true;
                        }
                        let _e402 = phi_1163_;
                        let _e404 = phi_1164_;
                        phi_1165_ = _e402;
                        phi_1166_ = _e404;
                    } else {
                        phi_1165_ = bool();
                        phi_1166_ = true;
                    }
                    let _e406 = phi_1165_;
                    let _e408 = phi_1166_;
                    if _e408 {
                        phi_1170_ = false;
                    } else {
                        phi_1170_ = _e406;
                    }
                    let _e410 = phi_1170_;
                    if _e410 {
                        let _e412 = samples.member[(0u + _e61.first_primitive)].normal;
                        let _e414 = p.member.map_size;
                        let _e484 = ((abs(((((_e387.row_x.x * _e412.x) + (_e387.row_x.y * _e412.y)) + (_e387.row_x.z * _e412.z)) / (((_e387.row_x.x * _e387.row_x.x) + (_e387.row_x.y * _e387.row_x.y)) + (_e387.row_x.z * _e387.row_x.z)))) + abs(((((_e387.row_y.x * _e412.x) + (_e387.row_y.y * _e412.y)) + (_e387.row_y.z * _e412.z)) / (((_e387.row_y.x * _e387.row_y.x) + (_e387.row_y.y * _e387.row_y.y)) + (_e387.row_y.z * _e387.row_y.z))))) / (abs(((((_e387.row_z.x * _e412.x) + (_e387.row_z.y * _e412.y)) + (_e387.row_z.z * _e412.z)) / (((_e387.row_z.x * _e387.row_z.x) + (_e387.row_z.y * _e387.row_z.y)) + (_e387.row_z.z * _e387.row_z.z)))) * f32(_e414)));
                        if (_e484 < 0.002f) {
                            phi_1252_ = _e484;
                        } else {
                            phi_1252_ = 0.002f;
                        }
                        let _e487 = phi_1252_;
                        phi_1369_ = _e487;
                    } else {
                        let _e489 = p.member.map_size;
                        let _e495 = samples.member[(0u + _e61.first_primitive)].position;
                        let _e506 = ((((_e387.row_w.x * _e495.x) + (_e387.row_w.y * _e495.y)) + (_e387.row_w.z * _e495.z)) + _e387.row_w.w);
                        let _e519 = ((_e387.row_x.x - (_e387.row_w.x * _e376.point.uv.x)) / _e506);
                        let _e520 = ((_e387.row_x.y - (_e387.row_w.y * _e376.point.uv.x)) / _e506);
                        let _e521 = ((_e387.row_x.z - (_e387.row_w.z * _e376.point.uv.x)) / _e506);
                        let _e534 = ((_e387.row_y.x - (_e387.row_w.x * _e376.point.uv.y)) / _e506);
                        let _e535 = ((_e387.row_y.y - (_e387.row_w.y * _e376.point.uv.y)) / _e506);
                        let _e536 = ((_e387.row_y.z - (_e387.row_w.z * _e376.point.uv.y)) / _e506);
                        let _e542 = samples.member[(0u + _e61.first_primitive)].normal;
                        let _e547 = ((_e535 * _e542.z) - (_e542.y * _e536));
                        let _e552 = ((_e536 * _e542.x) - (_e542.z * _e534));
                        let _e557 = ((_e534 * _e542.y) - (_e542.x * _e535));
                        let _e559 = samples.member[(0u + _e61.first_primitive)].normal;
                        let _e564 = ((_e520 * _e559.z) - (_e559.y * _e521));
                        let _e569 = ((_e521 * _e559.x) - (_e559.z * _e519));
                        let _e574 = ((_e519 * _e559.y) - (_e559.x * _e520));
                        let _e601 = ((abs(((((_e387.row_z.x * _e547) + (_e387.row_z.y * _e552)) + (_e387.row_z.z * _e557)) / (((_e519 * _e547) + (_e520 * _e552)) + (_e521 * _e557)))) + abs(((((_e387.row_z.x * _e564) + (_e387.row_z.y * _e569)) + (_e387.row_z.z * _e574)) / (((_e534 * _e564) + (_e535 * _e569)) + (_e536 * _e574))))) / f32(_e489));
                        if (_e601 < 0.002f) {
                            phi_1368_ = _e601;
                        } else {
                            phi_1368_ = 0.002f;
                        }
                        let _e604 = phi_1368_;
                        phi_1369_ = _e604;
                    }
                    let _e606 = phi_1369_;
                    phi_1372_ = (_e376.point.depth - (0f * _e606));
                } else {
                    phi_1372_ = _e376.point.depth;
                }
                let _e610 = phi_1372_;
                let _e616 = p.member.map_size;
                let _e617 = f32(_e616);
                let _e620 = ((_e376.point.uv.x * _e617) - 0.5f);
                let _e621 = ((_e376.point.uv.y * _e617) - 0.5f);
                if (_e620 > -8388608f) {
                    let _e633 = f32(select(0i, select(select(i32(_e620), i32(-2147483648), (_e620 < bitcast<f32>(3472883712u))), 2147483647i, (_e620 > bitcast<f32>(1325400063u))), (_e620 == _e620)));
                    if (_e633 > _e620) {
                        phi_1401_ = 1f;
                    } else {
                        phi_1401_ = 0f;
                    }
                    let _e636 = phi_1401_;
                    if (_e620 < 8388608f) {
                        phi_1406_ = (_e633 - _e636);
                        phi_1407_ = false;
                    } else {
                        phi_1406_ = f32();
                        phi_1407_ = true;
                    }
                    let _e639 = phi_1406_;
                    let _e641 = phi_1407_;
                    phi_1408_ = _e639;
                    phi_1409_ = _e641;
                } else {
                    phi_1408_ = f32();
                    phi_1409_ = true;
                }
                let _e643 = phi_1408_;
                let _e645 = phi_1409_;
                if _e645 {
                    phi_1413_ = _e620;
                } else {
                    phi_1413_ = _e643;
                }
                let _e647 = phi_1413_;
                if (_e621 > -8388608f) {
                    let _e659 = f32(select(0i, select(select(i32(_e621), i32(-2147483648), (_e621 < bitcast<f32>(3472883712u))), 2147483647i, (_e621 > bitcast<f32>(1325400063u))), (_e621 == _e621)));
                    if (_e659 > _e621) {
                        phi_1433_ = 1f;
                    } else {
                        phi_1433_ = 0f;
                    }
                    let _e662 = phi_1433_;
                    if (_e621 < 8388608f) {
                        phi_1438_ = (_e659 - _e662);
                        phi_1439_ = false;
                    } else {
                        phi_1438_ = f32();
                        phi_1439_ = true;
                    }
                    let _e665 = phi_1438_;
                    let _e667 = phi_1439_;
                    phi_1440_ = _e665;
                    phi_1441_ = _e667;
                } else {
                    phi_1440_ = f32();
                    phi_1441_ = true;
                }
                let _e669 = phi_1440_;
                let _e671 = phi_1441_;
                if _e671 {
                    phi_1445_ = _e621;
                } else {
                    phi_1445_ = _e669;
                }
                let _e673 = phi_1445_;
                let _e674 = (_e620 - _e647);
                let _e675 = (_e621 - _e673);
                let _e684 = select(0i, select(select(i32(_e647), i32(-2147483648), (_e647 < bitcast<f32>(3472883712u))), 2147483647i, (_e647 > bitcast<f32>(1325400063u))), (_e647 == _e647));
                let _e693 = select(0i, select(select(i32(_e673), i32(-2147483648), (_e673 < bitcast<f32>(3472883712u))), 2147483647i, (_e673 > bitcast<f32>(1325400063u))), (_e673 == _e673));
                let _e704 = p.member.test;
                let _e705 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e704);
                let _e707 = p.member.map_size;
                let _e709 = local_3;
                local = _e705;
                let _e712 = ((_e709.level * _e707) * _e707);
                let _e714 = (bitcast<i32>(_e707) - 1i);
                if (_e684 > 0i) {
                    phi_1494_ = _e684;
                } else {
                    phi_1494_ = 0i;
                }
                let _e717 = phi_1494_;
                if (_e693 > 0i) {
                    phi_1499_ = _e693;
                } else {
                    phi_1499_ = 0i;
                }
                let _e720 = phi_1499_;
                if (_e717 < _e714) {
                    phi_1504_ = _e717;
                } else {
                    phi_1504_ = _e714;
                }
                let _e723 = phi_1504_;
                if (_e720 < _e714) {
                    phi_1509_ = _e720;
                } else {
                    phi_1509_ = _e714;
                }
                let _e726 = phi_1509_;
                let _e727 = bitcast<u32>(_e723);
                let _e729 = (_e684 + 1i);
                let _e730 = (_e693 + 1i);
                if (_e729 > 0i) {
                    phi_1518_ = _e729;
                } else {
                    phi_1518_ = 0i;
                }
                let _e733 = phi_1518_;
                if (_e730 > 0i) {
                    phi_1523_ = _e730;
                } else {
                    phi_1523_ = 0i;
                }
                let _e736 = phi_1523_;
                if (_e733 < _e714) {
                    phi_1528_ = _e733;
                } else {
                    phi_1528_ = _e714;
                }
                let _e739 = phi_1528_;
                if (_e736 < _e714) {
                    phi_1533_ = _e736;
                } else {
                    phi_1533_ = _e714;
                }
                let _e742 = phi_1533_;
                let _e743 = bitcast<u32>(_e739);
                let _e745 = (bitcast<u32>(_e726) * _e707);
                let _e746 = (bitcast<u32>(_e742) * _e707);
                let _e751 = ((_e745 + _e727) + _e712);
                let _e752 = ((_e745 + _e743) + _e712);
                let _e753 = ((_e746 + _e727) + _e712);
                let _e754 = ((_e746 + _e743) + _e712);
                if (_e751 < _e49) {
                } else {
                    return;
                }
                let _e758 = map.member[(0u + _e751)];
                if (_e752 < _e49) {
                } else {
                    return;
                }
                let _e762 = map.member[(0u + _e752)];
                if (_e753 < _e49) {
                } else {
                    return;
                }
                let _e766 = map.member[(0u + _e753)];
                if (_e754 < _e49) {
                } else {
                    return;
                }
                let _e770 = map.member[(0u + _e754)];
                let _e772 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e758, _e762, _e766, _e770), vec4<f32>(((1f - _e674) * (1f - _e675)), (_e674 * (1f - _e675)), ((1f - _e674) * _e675), (_e674 * _e675)), _e610);
                let _e774 = p.member.epsilon;
                if (_e772 <= _e774) {
                    phi_1584_ = true;
                } else {
                    phi_1584_ = (_e772 >= (1f - _e774));
                }
                let _e779 = phi_1584_;
                if ((bitcast<u32>(_e772) & 2147483647u) > 2139095040u) {
                    phi_1592_ = true;
                } else {
                    phi_1592_ = !(_e779);
                }
                let _e785 = phi_1592_;
                if _e785 {
                    if (_e772 > 0f) {
                        if (_e772 < 1f) {
                            phi_1604_ = false;
                        } else {
                            phi_1604_ = true;
                        }
                        let _e789 = phi_1604_;
                        phi_1605_ = _e789;
                    } else {
                        phi_1605_ = true;
                    }
                    let _e791 = phi_1605_;
                    if _e791 {
                        phi_1609_ = 0.5f;
                    } else {
                        phi_1609_ = _e772;
                    }
                    let _e793 = phi_1609_;
                    phi_1617_ = evaluate_Verdict(_e793, true);
                } else {
                    if (_e772 > 0.5f) {
                        phi_1615_ = 1f;
                    } else {
                        phi_1615_ = 0f;
                    }
                    let _e797 = phi_1615_;
                    phi_1617_ = evaluate_Verdict(_e797, false);
                }
                let _e800 = phi_1617_;
                phi_1622_ = evaluate_Verdict(_e800.visibility, _e800.is_doubted);
            } else {
                phi_1622_ = evaluate_Verdict(0.5f, true);
            }
            let _e806 = phi_1622_;
            phi_1623_ = _e806;
        }
        let _e808 = phi_1623_;
        if (_e61.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e61.first_primitive)] = _e808.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_msm_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
