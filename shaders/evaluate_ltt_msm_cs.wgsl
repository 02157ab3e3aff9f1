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
    var phi_145_: lt_bvh_traverse_Tree;
    var phi_146_: bool;
    var phi_147_: lt_bvh_traverse_Tree;
    var phi_148_: bool;
    var phi_153_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_145_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_146_ = false;
        } else {
            phi_145_ = lt_bvh_traverse_Tree();
            phi_146_ = true;
        }
        let _e53 = phi_145_;
        let _e55 = phi_146_;
        phi_147_ = _e53;
        phi_148_ = _e55;
    } else {
        phi_147_ = lt_bvh_traverse_Tree();
        phi_148_ = true;
    }
    let _e57 = phi_147_;
    let _e59 = phi_148_;
    if _e59 {
        phi_153_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_153_ = _e57;
    }
    let _e64 = phi_153_;
    return lt_bvh_traverse_Tree(_e64.root, _e64.first_primitive);
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_180_: f32;
    var phi_181_: f32;
    var phi_182_: f32;
    var phi_199_: f32;
    var phi_200_: f32;
    var phi_201_: f32;
    var phi_217_: f32;
    var phi_218_: f32;
    var phi_219_: f32;
    var phi_235_: f32;
    var phi_236_: f32;
    var phi_237_: f32;
    var phi_253_: f32;
    var phi_254_: f32;
    var phi_255_: f32;
    var phi_290_: bool;
    var phi_291_: bool;
    var phi_292_: bool;
    var phi_293_: bool;
    var phi_294_: bool;
    var phi_295_: bool;
    var phi_299_: bool;
    var phi_610_: f32;
    var phi_611_: f32;
    var phi_612_: f32;
    var phi_629_: f32;
    var phi_630_: f32;
    var phi_631_: f32;
    var phi_648_: f32;
    var phi_649_: f32;
    var phi_650_: f32;
    var phi_667_: f32;
    var phi_668_: f32;
    var phi_669_: f32;
    var phi_692_: f32;
    var phi_693_: f32;
    var phi_694_: f32;
    var phi_705_: f32;
    var phi_720_: f32;
    var phi_722_: lt_bvh_slab_Span;
    var phi_780_: f32;
    var phi_781_: f32;
    var phi_782_: f32;
    var phi_783_: f32;
    var phi_784_: f32;
    var phi_785_: bool;
    var phi_789_: f32;
    var phi_804_: f32;
    var phi_805_: f32;
    var phi_806_: f32;
    var phi_807_: f32;
    var phi_808_: f32;
    var phi_809_: f32;
    var phi_810_: f32;
    var phi_811_: bool;
    var phi_812_: f32;
    var phi_813_: f32;
    var phi_814_: bool;
    var phi_818_: f32;

    let _e44 = (*param_4);
    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_182_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_181_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_180_ = 1f;
            } else {
                phi_180_ = param_7;
            }
            let _e51 = phi_180_;
            phi_181_ = _e51;
        }
        let _e53 = phi_181_;
        phi_182_ = _e53;
    }
    let _e55 = phi_182_;
    let _e56 = (_e55 - 0.00000047683716f);
    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_201_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_200_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_199_ = 1f;
            } else {
                phi_199_ = param_5.x;
            }
            let _e64 = phi_199_;
            phi_200_ = _e64;
        }
        let _e66 = phi_200_;
        phi_201_ = _e66;
    }
    let _e68 = phi_201_;
    if ((bitcast<u32>(param_5.y) & 2147483647u) > 2139095040u) {
        phi_219_ = param_5.y;
    } else {
        if (param_5.y < 0f) {
            phi_218_ = 0f;
        } else {
            if (param_5.y > 1f) {
                phi_217_ = 1f;
            } else {
                phi_217_ = param_5.y;
            }
            let _e76 = phi_217_;
            phi_218_ = _e76;
        }
        let _e78 = phi_218_;
        phi_219_ = _e78;
    }
    let _e80 = phi_219_;
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_237_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_236_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_235_ = 1f;
            } else {
                phi_235_ = param_5.z;
            }
            let _e88 = phi_235_;
            phi_236_ = _e88;
        }
        let _e90 = phi_236_;
        phi_237_ = _e90;
    }
    let _e92 = phi_237_;
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_255_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_254_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_253_ = 1f;
            } else {
                phi_253_ = param_5.w;
            }
            let _e100 = phi_253_;
            phi_254_ = _e100;
        }
        let _e102 = phi_254_;
        phi_255_ = _e102;
    }
    let _e104 = phi_255_;
    let _e105 = (_e68 - _e56);
    let _e106 = (_e80 - _e56);
    let _e107 = (_e92 - _e56);
    let _e108 = (_e104 - _e56);
    let _e119 = ((((_e105 * param_6.x) + (_e106 * param_6.y)) + (_e107 * param_6.z)) + (_e108 * param_6.w));
    if ((bitcast<u32>(_e119) & 2147483647u) > 2139095040u) {
        phi_812_ = _e119;
        phi_813_ = f32();
        phi_814_ = true;
    } else {
        if (_e105 >= 0f) {
            if (_e106 >= 0f) {
                if (_e107 >= 0f) {
                    phi_290_ = (_e108 >= 0f);
                    phi_291_ = false;
                } else {
                    phi_290_ = bool();
                    phi_291_ = true;
                }
                let _e128 = phi_290_;
                let _e130 = phi_291_;
                phi_292_ = _e128;
                phi_293_ = _e130;
            } else {
                phi_292_ = bool();
                phi_293_ = true;
            }
            let _e132 = phi_292_;
            let _e134 = phi_293_;
            phi_294_ = _e132;
            phi_295_ = _e134;
        } else {
            phi_294_ = bool();
            phi_295_ = true;
        }
        let _e136 = phi_294_;
        let _e138 = phi_295_;
        if _e138 {
            phi_299_ = false;
        } else {
            phi_299_ = _e136;
        }
        let _e140 = phi_299_;
        if _e140 {
            phi_809_ = 1f;
            phi_810_ = f32();
            phi_811_ = true;
        } else {
            let _e141 = (0.5f * _e44);
            let _e142 = (1f - _e44);
            let _e144 = (param_6.x * _e142);
            let _e146 = (param_6.y * _e142);
            let _e148 = (param_6.z * _e142);
            let _e150 = (param_6.w * _e142);
            let _e151 = -(_e56);
            let _e152 = (1f - _e56);
            let _e154 = (vec4<f32>(1f, 1f, 1f, 1f).x - _e68);
            let _e156 = (vec4<f32>(1f, 1f, 1f, 1f).y - _e80);
            let _e158 = (vec4<f32>(1f, 1f, 1f, 1f).z - _e92);
            let _e160 = (vec4<f32>(1f, 1f, 1f, 1f).w - _e104);
            let _e161 = (_e105 - _e106);
            let _e162 = (_e106 - _e107);
            let _e163 = (_e107 - _e108);
            let _e164 = (_e108 - _e105);
            let _e165 = (_e161 * _e161);
            let _e166 = (_e162 * _e162);
            let _e167 = (_e163 * _e163);
            let _e168 = (_e164 * _e164);
            let _e169 = (_e105 - _e107);
            let _e170 = (_e106 - _e108);
            let _e171 = (_e107 - _e105);
            let _e172 = (_e108 - _e106);
            let _e173 = (_e169 * _e169);
            let _e174 = (_e170 * _e170);
            let _e175 = (_e171 * _e171);
            let _e176 = (_e172 * _e172);
            let _e181 = ((_e144 * _e146) * _e165);
            let _e182 = ((_e146 * _e148) * _e166);
            let _e183 = ((_e148 * _e150) * _e167);
            let _e184 = ((_e150 * _e144) * _e168);
            let _e193 = (((0.5f * _e144) * _e148) * _e173);
            let _e194 = (((0.5f * _e146) * _e150) * _e174);
            let _e195 = (((0.5f * _e148) * _e144) * _e175);
            let _e196 = (((0.5f * _e150) * _e146) * _e176);
            let _e197 = (_e105 * _e106);
            let _e198 = (_e106 * _e107);
            let _e199 = (_e107 * _e108);
            let _e200 = (_e108 * _e105);
            let _e201 = (_e105 * _e107);
            let _e202 = (_e106 * _e108);
            let _e203 = (_e107 * _e105);
            let _e204 = (_e108 * _e106);
            let _e205 = (_e181 * _e197);
            let _e206 = (_e182 * _e198);
            let _e207 = (_e183 * _e199);
            let _e208 = (_e184 * _e200);
            let _e209 = (_e193 * _e201);
            let _e210 = (_e194 * _e202);
            let _e211 = (_e195 * _e203);
            let _e212 = (_e196 * _e204);
            let _e213 = (_e68 * _e68);
            let _e214 = (_e80 * _e80);
            let _e215 = (_e92 * _e92);
            let _e216 = (_e104 * _e104);
            let _e217 = (_e154 * _e154);
            let _e218 = (_e156 * _e156);
            let _e219 = (_e158 * _e158);
            let _e220 = (_e160 * _e160);
            let _e221 = (_e141 * _e144);
            let _e222 = (_e141 * _e146);
            let _e223 = (_e141 * _e148);
            let _e224 = (_e141 * _e150);
            let _e233 = (((_e221 * _e105) * _e213) * _e151);
            let _e234 = (((_e222 * _e106) * _e214) * _e151);
            let _e235 = (((_e223 * _e107) * _e215) * _e151);
            let _e236 = (((_e224 * _e108) * _e216) * _e151);
            let _e245 = (((_e221 * _e105) * _e217) * _e152);
            let _e246 = (((_e222 * _e106) * _e218) * _e152);
            let _e247 = (((_e223 * _e107) * _e219) * _e152);
            let _e248 = (((_e224 * _e108) * _e220) * _e152);
            let _e416 = (((((((_e181 * _e148) * _e166) * _e173) + (_e141 * (((_e181 * ((_e213 * _e214) + (_e217 * _e218))) + (_e193 * ((_e213 * _e215) + (_e217 * _e219)))) + ((_e221 * _e213) * _e217)))) + ((((_e182 * _e150) * _e167) * _e174) + (_e141 * (((_e182 * ((_e214 * _e215) + (_e218 * _e219))) + (_e194 * ((_e214 * _e216) + (_e218 * _e220)))) + ((_e222 * _e214) * _e218))))) + ((((_e183 * _e144) * _e168) * _e175) + (_e141 * (((_e183 * ((_e215 * _e216) + (_e219 * _e220))) + (_e195 * ((_e215 * _e213) + (_e219 * _e217)))) + ((_e223 * _e215) * _e219))))) + ((((_e184 * _e146) * _e165) * _e176) + (_e141 * (((_e184 * ((_e216 * _e213) + (_e220 * _e217))) + (_e196 * ((_e216 * _e214) + (_e220 * _e218)))) + ((_e224 * _e216) * _e220)))));
            let _e419 = (((_e141 * _e141) * _e151) * _e152);
            let _e422 = (((((((_e205 * _e197) + (_e209 * _e201)) + (_e105 * ((_e233 * _e151) + (_e245 * _e152)))) + (((_e206 * _e198) + (_e210 * _e202)) + (_e106 * ((_e234 * _e151) + (_e246 * _e152))))) + (((_e207 * _e199) + (_e211 * _e203)) + (_e107 * ((_e235 * _e151) + (_e247 * _e152))))) + (((_e208 * _e200) + (_e212 * _e204)) + (_e108 * ((_e236 * _e151) + (_e248 * _e152))))) + ((_e419 * _e151) * _e152));
            let _e428 = (_e422 < 0.0000000000000000000000000000000001f);
            if _e428 {
                if ((bitcast<u32>(_e105) & 2147483647u) > 2139095040u) {
                    phi_612_ = _e105;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_611_ = 0f;
                    } else {
                        if (_e105 < 0f) {
                            phi_610_ = 0f;
                        } else {
                            phi_610_ = 1f;
                        }
                        let _e437 = phi_610_;
                        phi_611_ = _e437;
                    }
                    let _e439 = phi_611_;
                    phi_612_ = _e439;
                }
                let _e441 = phi_612_;
                if ((bitcast<u32>(_e106) & 2147483647u) > 2139095040u) {
                    phi_631_ = _e106;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_630_ = 0f;
                    } else {
                        if (_e106 < 0f) {
                            phi_629_ = 0f;
                        } else {
                            phi_629_ = 1f;
                        }
                        let _e450 = phi_629_;
                        phi_630_ = _e450;
                    }
                    let _e452 = phi_630_;
                    phi_631_ = _e452;
                }
                let _e454 = phi_631_;
                if ((bitcast<u32>(_e107) & 2147483647u) > 2139095040u) {
                    phi_650_ = _e107;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_649_ = 0f;
                    } else {
                        if (_e107 < 0f) {
                            phi_648_ = 0f;
                        } else {
                            phi_648_ = 1f;
                        }
                        let _e463 = phi_648_;
                        phi_649_ = _e463;
                    }
                    let _e465 = phi_649_;
                    phi_650_ = _e465;
                }
                let _e467 = phi_650_;
                if ((bitcast<u32>(_e108) & 2147483647u) > 2139095040u) {
                    phi_669_ = _e108;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_668_ = 0f;
                    } else {
                        if (_e108 < 0f) {
                            phi_667_ = 0f;
                        } else {
                            phi_667_ = 1f;
                        }
                        let _e476 = phi_667_;
                        phi_668_ = _e476;
                    }
                    let _e478 = phi_668_;
                    phi_669_ = _e478;
                }
                let _e480 = phi_669_;
                let _e488 = (((((_e441 * _e144) + (_e454 * _e146)) + (_e467 * _e148)) + (_e480 * _e150)) + _e141);
                if ((bitcast<u32>(_e488) & 2147483647u) > 2139095040u) {
                    phi_694_ = _e488;
                } else {
                    if (_e488 < 0f) {
                        phi_693_ = 0f;
                    } else {
                        if (_e488 > 1f) {
                            phi_692_ = 1f;
                        } else {
                            phi_692_ = _e488;
                        }
                        let _e495 = phi_692_;
                        phi_693_ = _e495;
                    }
                    let _e497 = phi_693_;
                    phi_694_ = _e497;
                }
                let _e499 = phi_694_;
                phi_807_ = _e499;
                phi_808_ = f32();
            } else {
                let _e501 = ((0.5f * -(((((((((_e205 * (_e105 + _e106)) + (_e209 * (_e105 + _e107))) + (_e233 * (_e105 + _e151))) + (_e245 * (_e105 + _e152))) + ((((_e206 * (_e106 + _e107)) + (_e210 * (_e106 + _e108))) + (_e234 * (_e106 + _e151))) + (_e246 * (_e106 + _e152)))) + ((((_e207 * (_e107 + _e108)) + (_e211 * (_e107 + _e105))) + (_e235 * (_e107 + _e151))) + (_e247 * (_e107 + _e152)))) + ((((_e208 * (_e108 + _e105)) + (_e212 * (_e108 + _e106))) + (_e236 * (_e108 + _e151))) + (_e248 * (_e108 + _e152)))) + (_e419 * (_e151 + _e152))))) / _e422);
                let _e502 = ((((((((_e205 + _e209) + _e233) + _e245) + (((_e206 + _e210) + _e234) + _e246)) + (((_e207 + _e211) + _e235) + _e247)) + (((_e208 + _e212) + _e236) + _e248)) + _e419) / _e422);
                let _e504 = ((_e501 * _e501) - _e502);
                if (_e504 > 0f) {
                    phi_705_ = sqrt(_e504);
                } else {
                    phi_705_ = 0f;
                }
                let _e508 = phi_705_;
                if (_e501 > 0f) {
                    let _e511 = (-(_e501) - _e508);
                    phi_722_ = lt_bvh_slab_Span(_e511, (_e502 / _e511));
                } else {
                    let _e514 = (_e508 - _e501);
                    if (_e514 > 0f) {
                        phi_720_ = (_e502 / _e514);
                    } else {
                        phi_720_ = 0f;
                    }
                    let _e518 = phi_720_;
                    phi_722_ = lt_bvh_slab_Span(_e518, _e514);
                }
                let _e521 = phi_722_;
                if (_e521.near >= 0f) {
                    phi_783_ = 1f;
                    phi_784_ = f32();
                    phi_785_ = true;
                } else {
                    let _e525 = (_e521.far <= 0f);
                    if _e525 {
                        phi_781_ = (_e416 / _e422);
                        phi_782_ = f32();
                    } else {
                        let _e536 = (((((_e144 * _e105) + (_e146 * _e106)) + (_e148 * _e107)) + (_e150 * _e108)) + (_e141 * (_e151 + _e152)));
                        let _e552 = (((((_e144 * (_e105 * _e105)) + (_e146 * (_e106 * _e106))) + (_e148 * (_e107 * _e107))) + (_e150 * (_e108 * _e108))) + (_e141 * ((_e151 * _e151) + (_e152 * _e152))));
                        if (-(_e521.near) <= _e521.far) {
                            phi_780_ = (1f - (((_e521.near * _e521.near) * ((_e521.far * _e552) - _e536)) / (_e521.far - _e521.near)));
                        } else {
                            phi_780_ = ((_e416 / _e422) + (((_e521.far * _e521.far) * (_e536 - (_e521.near * _e552))) / (_e521.far - _e521.near)));
                        }
                        let _e571 = phi_780_;
                        phi_781_ = f32();
                        phi_782_ = _e571;
                    }
                    let _e573 = phi_781_;
                    let _e575 = phi_782_;
                    phi_783_ = _e573;
                    phi_784_ = _e575;
                    phi_785_ = _e525;
                }
                let _e577 = phi_783_;
                let _e579 = phi_784_;
                let _e581 = phi_785_;
                if _e581 {
                    phi_789_ = _e577;
                } else {
                    phi_789_ = _e579;
                }
                let _e583 = phi_789_;
                if ((bitcast<u32>(_e583) & 2147483647u) > 2139095040u) {
                    phi_806_ = _e583;
                } else {
                    if (_e583 < 0f) {
                        phi_805_ = 0f;
                    } else {
                        if (_e583 > 1f) {
                            phi_804_ = 1f;
                        } else {
                            phi_804_ = _e583;
                        }
                        let _e590 = phi_804_;
                        phi_805_ = _e590;
                    }
                    let _e592 = phi_805_;
                    phi_806_ = _e592;
                }
                let _e594 = phi_806_;
                phi_807_ = f32();
                phi_808_ = _e594;
            }
            let _e596 = phi_807_;
            let _e598 = phi_808_;
            phi_809_ = _e596;
            phi_810_ = _e598;
            phi_811_ = _e428;
        }
        let _e600 = phi_809_;
        let _e602 = phi_810_;
        let _e604 = phi_811_;
        phi_812_ = _e600;
        phi_813_ = _e602;
        phi_814_ = _e604;
    }
    let _e606 = phi_812_;
    let _e608 = phi_813_;
    let _e610 = phi_814_;
    if _e610 {
        phi_818_ = _e606;
    } else {
        phi_818_ = _e608;
    }
    let _e612 = phi_818_;
    return _e612;
}

fn function_() {
    var local_1: f32;
    var phi_872_: bool;
    var phi_873_: bool;
    var phi_874_: bool;
    var phi_875_: bool;
    var phi_879_: bool;
    var phi_923_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_927_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1004_: bool;
    var phi_1013_: bool;
    var phi_1022_: bool;
    var phi_1023_: bool;
    var phi_1024_: bool;
    var phi_1025_: bool;
    var phi_1026_: bool;
    var phi_1027_: bool;
    var phi_1028_: bool;
    var phi_1032_: bool;
    var phi_1126_: f32;
    var phi_1129_: f32;
    var phi_1158_: f32;
    var phi_1163_: f32;
    var phi_1164_: bool;
    var phi_1165_: f32;
    var phi_1166_: bool;
    var phi_1170_: f32;
    var phi_1190_: f32;
    var phi_1195_: f32;
    var phi_1196_: bool;
    var phi_1197_: f32;
    var phi_1198_: bool;
    var phi_1202_: f32;
    var phi_1248_: i32;
    var phi_1253_: i32;
    var phi_1258_: i32;
    var phi_1263_: i32;
    var phi_1272_: i32;
    var phi_1277_: i32;
    var phi_1282_: i32;
    var phi_1287_: i32;
    var phi_1334_: bool;
    var phi_1342_: bool;
    var phi_1347_: f32;
    var phi_1350_: evaluate_Verdict;
    var phi_1351_: evaluate_Verdict;
    var phi_1355_: bool;
    var phi_1356_: u32;
    var phi_1362_: u32;

    let _e41 = id_1;
    let _e42 = local_2;
    let _e47 = arrayLength((&map.member));
    if (_e42 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    let _e54 = p.member.size[0u];
    let _e56 = p.member.size[1u];
    let _e57 = lt_shaders_entry_pixel_index(_e41, _e54, _e56);
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
                phi_872_ = (_e77 == _e79);
                phi_873_ = false;
            } else {
                phi_872_ = bool();
                phi_873_ = true;
            }
            let _e82 = phi_872_;
            let _e84 = phi_873_;
            phi_874_ = _e82;
            phi_875_ = _e84;
        } else {
            phi_874_ = bool();
            phi_875_ = true;
        }
        let _e86 = phi_874_;
        let _e88 = phi_875_;
        if _e88 {
            phi_879_ = false;
        } else {
            phi_879_ = _e86;
        }
        let _e90 = phi_879_;
        if !(_e90) {
            let _e93 = samples.member[_e57.first_primitive].normal;
            let _e95 = samples.member[_e57.first_primitive].position;
            if ((((_e93.x * (_e64.x - (_e95.x * _e64.w))) + (_e93.y * (_e64.y - (_e95.y * _e64.w)))) + (_e93.z * (_e64.z - (_e95.z * _e64.w)))) > 0f) {
                let _e119 = samples.member[_e57.first_primitive].flags;
                let _e127 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e133 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e127.unnamed.visibility, false), _e127.unnamed_1);
                phi_923_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e133.unnamed, ((_e119 & 1u) == 0u));
            } else {
                let _e142 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e148 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e142.unnamed.visibility, false), _e142.unnamed_1);
                phi_923_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e148.unnamed, true);
            }
            let _e153 = phi_923_;
            phi_927_ = _e153;
        } else {
            let _e159 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e165 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e159.unnamed.visibility, false), _e159.unnamed_1);
            phi_927_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e165.unnamed, true);
        }
        let _e170 = phi_927_;
        if _e170.unnamed_1 {
            phi_1351_ = evaluate_Verdict(_e170.unnamed.visibility, _e170.unnamed.is_doubted);
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
                    phi_1004_ = (_e209 <= 1f);
                } else {
                    phi_1004_ = false;
                }
                let _e241 = phi_1004_;
                if _e241 {
                    if (_e223 >= 0f) {
                        phi_1013_ = (_e223 <= 1f);
                    } else {
                        phi_1013_ = false;
                    }
                    let _e245 = phi_1013_;
                    if _e245 {
                        if (_e236 >= 0f) {
                            phi_1022_ = (_e236 <= 1f);
                        } else {
                            phi_1022_ = false;
                        }
                        let _e249 = phi_1022_;
                        phi_1023_ = _e249;
                        phi_1024_ = false;
                    } else {
                        phi_1023_ = bool();
                        phi_1024_ = true;
                    }
                    let _e251 = phi_1023_;
                    let _e253 = phi_1024_;
                    phi_1025_ = _e251;
                    phi_1026_ = _e253;
                } else {
                    phi_1025_ = bool();
                    phi_1026_ = true;
                }
                let _e255 = phi_1025_;
                let _e257 = phi_1026_;
                phi_1027_ = _e255;
                phi_1028_ = _e257;
            } else {
                phi_1027_ = bool();
                phi_1028_ = true;
            }
            let _e259 = phi_1027_;
            let _e261 = phi_1028_;
            if _e261 {
                phi_1032_ = false;
            } else {
                phi_1032_ = _e259;
            }
            let _e263 = phi_1032_;
            if _e263 {
                if (0f > 0f) {
                    let _e266 = samples.member[_e57.first_primitive].normal;
                    let _e268 = p.member.map_size;
                    let _e271 = p.member.projection.row_x;
                    let _e293 = p.member.projection.row_y;
                    let _e315 = p.member.projection.row_z;
                    let _e342 = ((abs(((((_e271.x * _e266.x) + (_e271.y * _e266.y)) + (_e271.z * _e266.z)) / (((_e271.x * _e271.x) + (_e271.y * _e271.y)) + (_e271.z * _e271.z)))) + abs(((((_e293.x * _e266.x) + (_e293.y * _e266.y)) + (_e293.z * _e266.z)) / (((_e293.x * _e293.x) + (_e293.y * _e293.y)) + (_e293.z * _e293.z))))) / (abs(((((_e315.x * _e266.x) + (_e315.y * _e266.y)) + (_e315.z * _e266.z)) / (((_e315.x * _e315.x) + (_e315.y * _e315.y)) + (_e315.z * _e315.z)))) * f32(_e268)));
                    if (_e342 < 0.002f) {
                        phi_1126_ = _e342;
                    } else {
                        phi_1126_ = 0.002f;
                    }
                    let _e345 = phi_1126_;
                    phi_1129_ = (_e236 - (0f * _e345));
                } else {
                    phi_1129_ = _e236;
                }
                let _e349 = phi_1129_;
                let _e351 = p.member.map_size;
                let _e352 = f32(_e351);
                let _e355 = ((_e209 * _e352) - 0.5f);
                let _e356 = ((_e223 * _e352) - 0.5f);
                if (_e355 > -8388608f) {
                    let _e368 = f32(select(0i, select(select(i32(_e355), i32(-2147483648), (_e355 < bitcast<f32>(3472883712u))), 2147483647i, (_e355 > bitcast<f32>(1325400063u))), (_e355 == _e355)));
                    if (_e368 > _e355) {
                        phi_1158_ = 1f;
                    } else {
                        phi_1158_ = 0f;
                    }
                    let _e371 = phi_1158_;
                    if (_e355 < 8388608f) {
                        phi_1163_ = (_e368 - _e371);
                        phi_1164_ = false;
                    } else {
                        phi_1163_ = f32();
                        phi_1164_ = true;
                    }
                    let _e374 = phi_1163_;
                    let _e376 = phi_1164_;
                    phi_1165_ = _e374;
                    phi_1166_ = _e376;
                } else {
                    phi_1165_ = f32();
                    phi_1166_ = true;
                }
                let _e378 = phi_1165_;
                let _e380 = phi_1166_;
                if _e380 {
                    phi_1170_ = _e355;
                } else {
                    phi_1170_ = _e378;
                }
                let _e382 = phi_1170_;
                if (_e356 > -8388608f) {
                    let _e394 = f32(select(0i, select(select(i32(_e356), i32(-2147483648), (_e356 < bitcast<f32>(3472883712u))), 2147483647i, (_e356 > bitcast<f32>(1325400063u))), (_e356 == _e356)));
                    if (_e394 > _e356) {
                        phi_1190_ = 1f;
                    } else {
                        phi_1190_ = 0f;
                    }
                    let _e397 = phi_1190_;
                    if (_e356 < 8388608f) {
                        phi_1195_ = (_e394 - _e397);
                        phi_1196_ = false;
                    } else {
                        phi_1195_ = f32();
                        phi_1196_ = true;
                    }
                    let _e400 = phi_1195_;
                    let _e402 = phi_1196_;
                    phi_1197_ = _e400;
                    phi_1198_ = _e402;
                } else {
                    phi_1197_ = f32();
                    phi_1198_ = true;
                }
                let _e404 = phi_1197_;
                let _e406 = phi_1198_;
                if _e406 {
                    phi_1202_ = _e356;
                } else {
                    phi_1202_ = _e404;
                }
                let _e408 = phi_1202_;
                let _e409 = (_e355 - _e382);
                let _e410 = (_e356 - _e408);
                let _e419 = select(0i, select(select(i32(_e382), i32(-2147483648), (_e382 < bitcast<f32>(3472883712u))), 2147483647i, (_e382 > bitcast<f32>(1325400063u))), (_e382 == _e382));
                let _e428 = select(0i, select(select(i32(_e408), i32(-2147483648), (_e408 < bitcast<f32>(3472883712u))), 2147483647i, (_e408 > bitcast<f32>(1325400063u))), (_e408 == _e408));
                let _e439 = p.member.test;
                let _e440 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e439);
                let _e442 = p.member.map_size;
                local_1 = _e440;
                let _e444 = (bitcast<i32>(_e442) - 1i);
                if (_e419 > 0i) {
                    phi_1248_ = _e419;
                } else {
                    phi_1248_ = 0i;
                }
                let _e447 = phi_1248_;
                if (_e428 > 0i) {
                    phi_1253_ = _e428;
                } else {
                    phi_1253_ = 0i;
                }
                let _e450 = phi_1253_;
                if (_e447 < _e444) {
                    phi_1258_ = _e447;
                } else {
                    phi_1258_ = _e444;
                }
                let _e453 = phi_1258_;
                if (_e450 < _e444) {
                    phi_1263_ = _e450;
                } else {
                    phi_1263_ = _e444;
                }
                let _e456 = phi_1263_;
                let _e457 = bitcast<u32>(_e453);
                let _e459 = (_e419 + 1i);
                let _e460 = (_e428 + 1i);
                if (_e459 > 0i) {
                    phi_1272_ = _e459;
                } else {
                    phi_1272_ = 0i;
                }
                let _e463 = phi_1272_;
                if (_e460 > 0i) {
                    phi_1277_ = _e460;
                } else {
                    phi_1277_ = 0i;
                }
                let _e466 = phi_1277_;
                if (_e463 < _e444) {
                    phi_1282_ = _e463;
                } else {
                    phi_1282_ = _e444;
                }
                let _e469 = phi_1282_;
                if (_e466 < _e444) {
                    phi_1287_ = _e466;
                } else {
                    phi_1287_ = _e444;
                }
                let _e472 = phi_1287_;
                let _e473 = bitcast<u32>(_e469);
                let _e475 = (bitcast<u32>(_e456) * _e442);
                let _e476 = (bitcast<u32>(_e472) * _e442);
                let _e477 = (_e475 + _e457);
                let _e478 = (_e475 + _e473);
                let _e479 = (_e476 + _e457);
                let _e480 = (_e476 + _e473);
                if (_e477 < _e47) {
                } else {
                    return;
                }
                let _e484 = map.member[(0u + _e477)];
                if (_e478 < _e47) {
                } else {
                    return;
                }
                let _e488 = map.member[(0u + _e478)];
                if (_e479 < _e47) {
                } else {
                    return;
                }
                let _e492 = map.member[(0u + _e479)];
                if (_e480 < _e47) {
                } else {
                    return;
                }
                let _e496 = map.member[(0u + _e480)];
                let _e498 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local_1), vec4<f32>(_e484, _e488, _e492, _e496), vec4<f32>(((1f - _e409) * (1f - _e410)), (_e409 * (1f - _e410)), ((1f - _e409) * _e410), (_e409 * _e410)), _e349);
                let _e500 = p.member.epsilon;
                if (_e498 <= _e500) {
                    phi_1334_ = true;
                } else {
                    phi_1334_ = (_e498 >= (1f - _e500));
                }
                let _e505 = phi_1334_;
                if ((bitcast<u32>(_e498) & 2147483647u) > 2139095040u) {
                    phi_1342_ = true;
                } else {
                    phi_1342_ = !(_e505);
                }
                let _e511 = phi_1342_;
                if (_e498 > 0.5f) {
                    phi_1347_ = 1f;
                } else {
                    phi_1347_ = 0f;
                }
                let _e514 = phi_1347_;
                phi_1350_ = evaluate_Verdict(_e514, _e511);
            } else {
                phi_1350_ = evaluate_Verdict(1f, true);
            }
            let _e518 = phi_1350_;
            phi_1351_ = _e518;
        }
        let _e520 = phi_1351_;
        visibility.member[_e57.first_primitive] = _e520.visibility;
        phi_1355_ = _e520.is_doubted;
        phi_1356_ = _e57.first_primitive;
    } else {
        phi_1355_ = false;
        phi_1356_ = 0u;
    }
    let _e525 = phi_1355_;
    let _e527 = phi_1356_;
    if _e525 {
        let _e529 = atomicAdd((&shared_[0u]), 1u);
        phi_1362_ = _e529;
    } else {
        phi_1362_ = 0u;
    }
    let _e531 = phi_1362_;
    workgroupBarrier();
    if (_e42 == 0u) {
        let _e535 = atomicLoad((&shared_[0u]));
        let _e536 = atomicAdd((&list.member[3u]), _e535);
        atomicStore((&shared_[1u]), _e536);
    }
    workgroupBarrier();
    if _e525 {
        let _e539 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e539) + _e531)]), _e527);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_msm_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
