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
        let _e53 = phi_147_;
        let _e55 = phi_148_;
        phi_149_ = _e53;
        phi_150_ = _e55;
    } else {
        phi_149_ = lt_bvh_traverse_Tree();
        phi_150_ = true;
    }
    let _e57 = phi_149_;
    let _e59 = phi_150_;
    if _e59 {
        phi_155_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_155_ = _e57;
    }
    let _e64 = phi_155_;
    return lt_bvh_traverse_Tree(_e64.root, _e64.first_primitive);
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

    let _e44 = (*param_4);
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
            let _e51 = phi_182_;
            phi_183_ = _e51;
        }
        let _e53 = phi_183_;
        phi_184_ = _e53;
    }
    let _e55 = phi_184_;
    let _e56 = (_e55 - 0.00000047683716f);
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
            let _e64 = phi_201_;
            phi_202_ = _e64;
        }
        let _e66 = phi_202_;
        phi_203_ = _e66;
    }
    let _e68 = phi_203_;
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
            let _e76 = phi_219_;
            phi_220_ = _e76;
        }
        let _e78 = phi_220_;
        phi_221_ = _e78;
    }
    let _e80 = phi_221_;
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
            let _e88 = phi_237_;
            phi_238_ = _e88;
        }
        let _e90 = phi_238_;
        phi_239_ = _e90;
    }
    let _e92 = phi_239_;
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
            let _e100 = phi_255_;
            phi_256_ = _e100;
        }
        let _e102 = phi_256_;
        phi_257_ = _e102;
    }
    let _e104 = phi_257_;
    let _e105 = (_e68 - _e56);
    let _e106 = (_e80 - _e56);
    let _e107 = (_e92 - _e56);
    let _e108 = (_e104 - _e56);
    let _e119 = ((((_e105 * param_6.x) + (_e106 * param_6.y)) + (_e107 * param_6.z)) + (_e108 * param_6.w));
    if ((bitcast<u32>(_e119) & 2147483647u) > 2139095040u) {
        phi_814_ = _e119;
        phi_815_ = f32();
        phi_816_ = true;
    } else {
        if (_e105 >= 0f) {
            if (_e106 >= 0f) {
                if (_e107 >= 0f) {
                    phi_292_ = (_e108 >= 0f);
                    phi_293_ = false;
                } else {
                    phi_292_ = bool();
                    phi_293_ = true;
                }
                let _e128 = phi_292_;
                let _e130 = phi_293_;
                phi_294_ = _e128;
                phi_295_ = _e130;
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
        if _e138 {
            phi_301_ = false;
        } else {
            phi_301_ = _e136;
        }
        let _e140 = phi_301_;
        if _e140 {
            phi_811_ = 1f;
            phi_812_ = f32();
            phi_813_ = true;
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
                    phi_614_ = _e105;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_613_ = 0f;
                    } else {
                        if (_e105 < 0f) {
                            phi_612_ = 0f;
                        } else {
                            phi_612_ = 1f;
                        }
                        let _e437 = phi_612_;
                        phi_613_ = _e437;
                    }
                    let _e439 = phi_613_;
                    phi_614_ = _e439;
                }
                let _e441 = phi_614_;
                if ((bitcast<u32>(_e106) & 2147483647u) > 2139095040u) {
                    phi_633_ = _e106;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_632_ = 0f;
                    } else {
                        if (_e106 < 0f) {
                            phi_631_ = 0f;
                        } else {
                            phi_631_ = 1f;
                        }
                        let _e450 = phi_631_;
                        phi_632_ = _e450;
                    }
                    let _e452 = phi_632_;
                    phi_633_ = _e452;
                }
                let _e454 = phi_633_;
                if ((bitcast<u32>(_e107) & 2147483647u) > 2139095040u) {
                    phi_652_ = _e107;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_651_ = 0f;
                    } else {
                        if (_e107 < 0f) {
                            phi_650_ = 0f;
                        } else {
                            phi_650_ = 1f;
                        }
                        let _e463 = phi_650_;
                        phi_651_ = _e463;
                    }
                    let _e465 = phi_651_;
                    phi_652_ = _e465;
                }
                let _e467 = phi_652_;
                if ((bitcast<u32>(_e108) & 2147483647u) > 2139095040u) {
                    phi_671_ = _e108;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_670_ = 0f;
                    } else {
                        if (_e108 < 0f) {
                            phi_669_ = 0f;
                        } else {
                            phi_669_ = 1f;
                        }
                        let _e476 = phi_669_;
                        phi_670_ = _e476;
                    }
                    let _e478 = phi_670_;
                    phi_671_ = _e478;
                }
                let _e480 = phi_671_;
                let _e488 = (((((_e441 * _e144) + (_e454 * _e146)) + (_e467 * _e148)) + (_e480 * _e150)) + _e141);
                if ((bitcast<u32>(_e488) & 2147483647u) > 2139095040u) {
                    phi_696_ = _e488;
                } else {
                    if (_e488 < 0f) {
                        phi_695_ = 0f;
                    } else {
                        if (_e488 > 1f) {
                            phi_694_ = 1f;
                        } else {
                            phi_694_ = _e488;
                        }
                        let _e495 = phi_694_;
                        phi_695_ = _e495;
                    }
                    let _e497 = phi_695_;
                    phi_696_ = _e497;
                }
                let _e499 = phi_696_;
                phi_809_ = _e499;
                phi_810_ = f32();
            } else {
                let _e501 = ((0.5f * -(((((((((_e205 * (_e105 + _e106)) + (_e209 * (_e105 + _e107))) + (_e233 * (_e105 + _e151))) + (_e245 * (_e105 + _e152))) + ((((_e206 * (_e106 + _e107)) + (_e210 * (_e106 + _e108))) + (_e234 * (_e106 + _e151))) + (_e246 * (_e106 + _e152)))) + ((((_e207 * (_e107 + _e108)) + (_e211 * (_e107 + _e105))) + (_e235 * (_e107 + _e151))) + (_e247 * (_e107 + _e152)))) + ((((_e208 * (_e108 + _e105)) + (_e212 * (_e108 + _e106))) + (_e236 * (_e108 + _e151))) + (_e248 * (_e108 + _e152)))) + (_e419 * (_e151 + _e152))))) / _e422);
                let _e502 = ((((((((_e205 + _e209) + _e233) + _e245) + (((_e206 + _e210) + _e234) + _e246)) + (((_e207 + _e211) + _e235) + _e247)) + (((_e208 + _e212) + _e236) + _e248)) + _e419) / _e422);
                let _e504 = ((_e501 * _e501) - _e502);
                if (_e504 > 0f) {
                    phi_707_ = sqrt(_e504);
                } else {
                    phi_707_ = 0f;
                }
                let _e508 = phi_707_;
                if (_e501 > 0f) {
                    let _e511 = (-(_e501) - _e508);
                    phi_724_ = lt_bvh_slab_Span(_e511, (_e502 / _e511));
                } else {
                    let _e514 = (_e508 - _e501);
                    if (_e514 > 0f) {
                        phi_722_ = (_e502 / _e514);
                    } else {
                        phi_722_ = 0f;
                    }
                    let _e518 = phi_722_;
                    phi_724_ = lt_bvh_slab_Span(_e518, _e514);
                }
                let _e521 = phi_724_;
                if (_e521.near >= 0f) {
                    phi_785_ = 1f;
                    phi_786_ = f32();
                    phi_787_ = true;
                } else {
                    let _e525 = (_e521.far <= 0f);
                    if _e525 {
                        phi_783_ = (_e416 / _e422);
                        phi_784_ = f32();
                    } else {
                        let _e536 = (((((_e144 * _e105) + (_e146 * _e106)) + (_e148 * _e107)) + (_e150 * _e108)) + (_e141 * (_e151 + _e152)));
                        let _e552 = (((((_e144 * (_e105 * _e105)) + (_e146 * (_e106 * _e106))) + (_e148 * (_e107 * _e107))) + (_e150 * (_e108 * _e108))) + (_e141 * ((_e151 * _e151) + (_e152 * _e152))));
                        if (-(_e521.near) <= _e521.far) {
                            phi_782_ = (1f - (((_e521.near * _e521.near) * ((_e521.far * _e552) - _e536)) / (_e521.far - _e521.near)));
                        } else {
                            phi_782_ = ((_e416 / _e422) + (((_e521.far * _e521.far) * (_e536 - (_e521.near * _e552))) / (_e521.far - _e521.near)));
                        }
                        let _e571 = phi_782_;
                        phi_783_ = f32();
                        phi_784_ = _e571;
                    }
                    let _e573 = phi_783_;
                    let _e575 = phi_784_;
                    phi_785_ = _e573;
                    phi_786_ = _e575;
                    phi_787_ = _e525;
                }
                let _e577 = phi_785_;
                let _e579 = phi_786_;
                let _e581 = phi_787_;
                if _e581 {
                    phi_791_ = _e577;
                } else {
                    phi_791_ = _e579;
                }
                let _e583 = phi_791_;
                if ((bitcast<u32>(_e583) & 2147483647u) > 2139095040u) {
                    phi_808_ = _e583;
                } else {
                    if (_e583 < 0f) {
                        phi_807_ = 0f;
                    } else {
                        if (_e583 > 1f) {
                            phi_806_ = 1f;
                        } else {
                            phi_806_ = _e583;
                        }
                        let _e590 = phi_806_;
                        phi_807_ = _e590;
                    }
                    let _e592 = phi_807_;
                    phi_808_ = _e592;
                }
                let _e594 = phi_808_;
                phi_809_ = f32();
                phi_810_ = _e594;
            }
            let _e596 = phi_809_;
            let _e598 = phi_810_;
            phi_811_ = _e596;
            phi_812_ = _e598;
            phi_813_ = _e428;
        }
        let _e600 = phi_811_;
        let _e602 = phi_812_;
        let _e604 = phi_813_;
        phi_814_ = _e600;
        phi_815_ = _e602;
        phi_816_ = _e604;
    }
    let _e606 = phi_814_;
    let _e608 = phi_815_;
    let _e610 = phi_816_;
    if _e610 {
        phi_820_ = _e606;
    } else {
        phi_820_ = _e608;
    }
    let _e612 = phi_820_;
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
    var phi_1001_: bool;
    var phi_1010_: bool;
    var phi_1019_: bool;
    var phi_1020_: bool;
    var phi_1021_: bool;
    var phi_1022_: bool;
    var phi_1023_: bool;
    var phi_1024_: bool;
    var phi_1025_: bool;
    var phi_1029_: bool;
    var phi_1119_: f32;
    var phi_1122_: f32;
    var phi_1151_: f32;
    var phi_1156_: f32;
    var phi_1157_: bool;
    var phi_1158_: f32;
    var phi_1159_: bool;
    var phi_1163_: f32;
    var phi_1183_: f32;
    var phi_1188_: f32;
    var phi_1189_: bool;
    var phi_1190_: f32;
    var phi_1191_: bool;
    var phi_1195_: f32;
    var phi_1243_: i32;
    var phi_1248_: i32;
    var phi_1253_: i32;
    var phi_1258_: i32;
    var phi_1267_: i32;
    var phi_1272_: i32;
    var phi_1277_: i32;
    var phi_1282_: i32;
    var phi_1333_: bool;
    var phi_1341_: bool;
    var phi_1353_: bool;
    var phi_1354_: bool;
    var phi_1358_: f32;
    var phi_1364_: f32;
    var phi_1366_: evaluate_Verdict;
    var phi_1371_: evaluate_Verdict;
    var phi_1372_: evaluate_Verdict;
    var phi_1376_: bool;
    var phi_1377_: u32;
    var phi_1388_: u32;

    let _e41 = id_1;
    let _e42 = local_2;
    let _e47 = arrayLength((&map.member));
    let _e52 = p.member.size[0u];
    let _e54 = p.member.size[1u];
    let _e55 = lt_shaders_entry_pixel_index(_e41, _e52, _e54);
    if (bitcast<i32>(_e55.root) != 0i) {
        let _e62 = p.member.projection;
        let _e63 = lt_math_OneLevel(_e62);
        let _e65 = p.member.light;
        let _e68 = samples.member[_e55.first_primitive].normal[0u];
        let _e70 = global[0u];
        if (_e68 == _e70) {
            let _e73 = samples.member[_e55.first_primitive].normal[1u];
            let _e75 = global[1u];
            if (_e73 == _e75) {
                let _e78 = samples.member[_e55.first_primitive].normal[2u];
                let _e80 = global[2u];
                phi_872_ = (_e78 == _e80);
                phi_873_ = false;
            } else {
                phi_872_ = bool();
                phi_873_ = true;
            }
            let _e83 = phi_872_;
            let _e85 = phi_873_;
            phi_874_ = _e83;
            phi_875_ = _e85;
        } else {
            phi_874_ = bool();
            phi_875_ = true;
        }
        let _e87 = phi_874_;
        let _e89 = phi_875_;
        if _e89 {
            phi_879_ = false;
        } else {
            phi_879_ = _e87;
        }
        let _e91 = phi_879_;
        if !(_e91) {
            let _e94 = samples.member[_e55.first_primitive].normal;
            let _e96 = samples.member[_e55.first_primitive].position;
            if ((((_e94.x * (_e65.x - (_e96.x * _e65.w))) + (_e94.y * (_e65.y - (_e96.y * _e65.w)))) + (_e94.z * (_e65.z - (_e96.z * _e65.w)))) > 0f) {
                let _e120 = samples.member[_e55.first_primitive].flags;
                let _e128 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e134 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e128.unnamed.visibility, false), _e128.unnamed_1);
                phi_923_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e134.unnamed, ((_e120 & 1u) == 0u));
            } else {
                let _e143 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e149 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e143.unnamed.visibility, false), _e143.unnamed_1);
                phi_923_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e149.unnamed, true);
            }
            let _e154 = phi_923_;
            phi_927_ = _e154;
        } else {
            let _e160 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e166 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e160.unnamed.visibility, false), _e160.unnamed_1);
            phi_927_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e166.unnamed, true);
        }
        let _e171 = phi_927_;
        if _e171.unnamed_1 {
            phi_1372_ = evaluate_Verdict(_e171.unnamed.visibility, _e171.unnamed.is_doubted);
        } else {
            let _e179 = samples.member[_e55.first_primitive].position;
            let _e197 = ((((_e63.projection.row_w.x * _e179.x) + (_e63.projection.row_w.y * _e179.y)) + (_e63.projection.row_w.z * _e179.z)) + (_e63.projection.row_w.w * 1f));
            let _e211 = (((((_e63.projection.row_x.x * _e179.x) + (_e63.projection.row_x.y * _e179.y)) + (_e63.projection.row_x.z * _e179.z)) + (_e63.projection.row_x.w * 1f)) / _e197);
            let _e225 = (((((_e63.projection.row_y.x * _e179.x) + (_e63.projection.row_y.y * _e179.y)) + (_e63.projection.row_y.z * _e179.z)) + (_e63.projection.row_y.w * 1f)) / _e197);
            let _e238 = ((((_e63.projection.row_z.x * _e179.x) + (_e63.projection.row_z.y * _e179.y)) + (_e63.projection.row_z.z * _e179.z)) + (_e63.projection.row_z.w * 1f));
            if (_e197 > 0f) {
                if (_e211 >= 0f) {
                    phi_1001_ = (_e211 <= 1f);
                } else {
                    phi_1001_ = false;
                }
                let _e243 = phi_1001_;
                if _e243 {
                    if (_e225 >= 0f) {
                        phi_1010_ = (_e225 <= 1f);
                    } else {
                        phi_1010_ = false;
                    }
                    let _e247 = phi_1010_;
                    if _e247 {
                        if (_e238 >= 0f) {
                            phi_1019_ = (_e238 <= 1f);
                        } else {
                            phi_1019_ = false;
                        }
                        let _e251 = phi_1019_;
                        phi_1020_ = _e251;
                        phi_1021_ = false;
                    } else {
                        phi_1020_ = bool();
                        phi_1021_ = true;
                    }
                    let _e253 = phi_1020_;
                    let _e255 = phi_1021_;
                    phi_1022_ = _e253;
                    phi_1023_ = _e255;
                } else {
                    phi_1022_ = bool();
                    phi_1023_ = true;
                }
                let _e257 = phi_1022_;
                let _e259 = phi_1023_;
                phi_1024_ = _e257;
                phi_1025_ = _e259;
            } else {
                phi_1024_ = bool();
                phi_1025_ = true;
            }
            let _e261 = phi_1024_;
            let _e263 = phi_1025_;
            if _e263 {
                phi_1029_ = false;
            } else {
                phi_1029_ = _e261;
            }
            let _e265 = phi_1029_;
            if _e265 {
                if (0f > 0f) {
                    let _e268 = samples.member[_e55.first_primitive].normal;
                    let _e270 = p.member.map_size;
                    let _e340 = ((abs(((((_e62.row_x.x * _e268.x) + (_e62.row_x.y * _e268.y)) + (_e62.row_x.z * _e268.z)) / (((_e62.row_x.x * _e62.row_x.x) + (_e62.row_x.y * _e62.row_x.y)) + (_e62.row_x.z * _e62.row_x.z)))) + abs(((((_e62.row_y.x * _e268.x) + (_e62.row_y.y * _e268.y)) + (_e62.row_y.z * _e268.z)) / (((_e62.row_y.x * _e62.row_y.x) + (_e62.row_y.y * _e62.row_y.y)) + (_e62.row_y.z * _e62.row_y.z))))) / (abs(((((_e62.row_z.x * _e268.x) + (_e62.row_z.y * _e268.y)) + (_e62.row_z.z * _e268.z)) / (((_e62.row_z.x * _e62.row_z.x) + (_e62.row_z.y * _e62.row_z.y)) + (_e62.row_z.z * _e62.row_z.z)))) * f32(_e270)));
                    if (_e340 < 0.002f) {
                        phi_1119_ = _e340;
                    } else {
                        phi_1119_ = 0.002f;
                    }
                    let _e343 = phi_1119_;
                    phi_1122_ = (_e238 - (0f * _e343));
                } else {
                    phi_1122_ = _e238;
                }
                let _e347 = phi_1122_;
                let _e349 = p.member.map_size;
                let _e350 = f32(_e349);
                let _e353 = ((_e211 * _e350) - 0.5f);
                let _e354 = ((_e225 * _e350) - 0.5f);
                if (_e353 > -8388608f) {
                    let _e366 = f32(select(0i, select(select(i32(_e353), i32(-2147483648), (_e353 < bitcast<f32>(3472883712u))), 2147483647i, (_e353 > bitcast<f32>(1325400063u))), (_e353 == _e353)));
                    if (_e366 > _e353) {
                        phi_1151_ = 1f;
                    } else {
                        phi_1151_ = 0f;
                    }
                    let _e369 = phi_1151_;
                    if (_e353 < 8388608f) {
                        phi_1156_ = (_e366 - _e369);
                        phi_1157_ = false;
                    } else {
                        phi_1156_ = f32();
                        phi_1157_ = true;
                    }
                    let _e372 = phi_1156_;
                    let _e374 = phi_1157_;
                    phi_1158_ = _e372;
                    phi_1159_ = _e374;
                } else {
                    phi_1158_ = f32();
                    phi_1159_ = true;
                }
                let _e376 = phi_1158_;
                let _e378 = phi_1159_;
                if _e378 {
                    phi_1163_ = _e353;
                } else {
                    phi_1163_ = _e376;
                }
                let _e380 = phi_1163_;
                if (_e354 > -8388608f) {
                    let _e392 = f32(select(0i, select(select(i32(_e354), i32(-2147483648), (_e354 < bitcast<f32>(3472883712u))), 2147483647i, (_e354 > bitcast<f32>(1325400063u))), (_e354 == _e354)));
                    if (_e392 > _e354) {
                        phi_1183_ = 1f;
                    } else {
                        phi_1183_ = 0f;
                    }
                    let _e395 = phi_1183_;
                    if (_e354 < 8388608f) {
                        phi_1188_ = (_e392 - _e395);
                        phi_1189_ = false;
                    } else {
                        phi_1188_ = f32();
                        phi_1189_ = true;
                    }
                    let _e398 = phi_1188_;
                    let _e400 = phi_1189_;
                    phi_1190_ = _e398;
                    phi_1191_ = _e400;
                } else {
                    phi_1190_ = f32();
                    phi_1191_ = true;
                }
                let _e402 = phi_1190_;
                let _e404 = phi_1191_;
                if _e404 {
                    phi_1195_ = _e354;
                } else {
                    phi_1195_ = _e402;
                }
                let _e406 = phi_1195_;
                let _e407 = (_e353 - _e380);
                let _e408 = (_e354 - _e406);
                let _e417 = select(0i, select(select(i32(_e380), i32(-2147483648), (_e380 < bitcast<f32>(3472883712u))), 2147483647i, (_e380 > bitcast<f32>(1325400063u))), (_e380 == _e380));
                let _e426 = select(0i, select(select(i32(_e406), i32(-2147483648), (_e406 < bitcast<f32>(3472883712u))), 2147483647i, (_e406 > bitcast<f32>(1325400063u))), (_e406 == _e406));
                let _e437 = p.member.test;
                let _e438 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e437);
                let _e440 = p.member.map_size;
                local_1 = _e438;
                let _e442 = ((0u * _e440) * _e440);
                let _e444 = (bitcast<i32>(_e440) - 1i);
                if (_e417 > 0i) {
                    phi_1243_ = _e417;
                } else {
                    phi_1243_ = 0i;
                }
                let _e447 = phi_1243_;
                if (_e426 > 0i) {
                    phi_1248_ = _e426;
                } else {
                    phi_1248_ = 0i;
                }
                let _e450 = phi_1248_;
                if (_e447 < _e444) {
                    phi_1253_ = _e447;
                } else {
                    phi_1253_ = _e444;
                }
                let _e453 = phi_1253_;
                if (_e450 < _e444) {
                    phi_1258_ = _e450;
                } else {
                    phi_1258_ = _e444;
                }
                let _e456 = phi_1258_;
                let _e457 = bitcast<u32>(_e453);
                let _e459 = (_e417 + 1i);
                let _e460 = (_e426 + 1i);
                if (_e459 > 0i) {
                    phi_1267_ = _e459;
                } else {
                    phi_1267_ = 0i;
                }
                let _e463 = phi_1267_;
                if (_e460 > 0i) {
                    phi_1272_ = _e460;
                } else {
                    phi_1272_ = 0i;
                }
                let _e466 = phi_1272_;
                if (_e463 < _e444) {
                    phi_1277_ = _e463;
                } else {
                    phi_1277_ = _e444;
                }
                let _e469 = phi_1277_;
                if (_e466 < _e444) {
                    phi_1282_ = _e466;
                } else {
                    phi_1282_ = _e444;
                }
                let _e472 = phi_1282_;
                let _e473 = bitcast<u32>(_e469);
                let _e475 = (bitcast<u32>(_e456) * _e440);
                let _e476 = (bitcast<u32>(_e472) * _e440);
                let _e481 = ((_e475 + _e457) + _e442);
                let _e482 = ((_e475 + _e473) + _e442);
                let _e483 = ((_e476 + _e457) + _e442);
                let _e484 = ((_e476 + _e473) + _e442);
                if (_e481 < _e47) {
                } else {
                    return;
                }
                let _e488 = map.member[(0u + _e481)];
                if (_e482 < _e47) {
                } else {
                    return;
                }
                let _e492 = map.member[(0u + _e482)];
                if (_e483 < _e47) {
                } else {
                    return;
                }
                let _e496 = map.member[(0u + _e483)];
                if (_e484 < _e47) {
                } else {
                    return;
                }
                let _e500 = map.member[(0u + _e484)];
                let _e502 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local_1), vec4<f32>(_e488, _e492, _e496, _e500), vec4<f32>(((1f - _e407) * (1f - _e408)), (_e407 * (1f - _e408)), ((1f - _e407) * _e408), (_e407 * _e408)), _e347);
                let _e504 = p.member.epsilon;
                if (_e502 <= _e504) {
                    phi_1333_ = true;
                } else {
                    phi_1333_ = (_e502 >= (1f - _e504));
                }
                let _e509 = phi_1333_;
                if ((bitcast<u32>(_e502) & 2147483647u) > 2139095040u) {
                    phi_1341_ = true;
                } else {
                    phi_1341_ = !(_e509);
                }
                let _e515 = phi_1341_;
                if _e515 {
                    if (_e502 > 0f) {
                        if (_e502 < 1f) {
                            phi_1353_ = false;
                        } else {
                            phi_1353_ = true;
                        }
                        let _e519 = phi_1353_;
                        phi_1354_ = _e519;
                    } else {
                        phi_1354_ = true;
                    }
                    let _e521 = phi_1354_;
                    if _e521 {
                        phi_1358_ = 0.5f;
                    } else {
                        phi_1358_ = _e502;
                    }
                    let _e523 = phi_1358_;
                    phi_1366_ = evaluate_Verdict(_e523, true);
                } else {
                    if (_e502 > 0.5f) {
                        phi_1364_ = 1f;
                    } else {
                        phi_1364_ = 0f;
                    }
                    let _e527 = phi_1364_;
                    phi_1366_ = evaluate_Verdict(_e527, false);
                }
                let _e530 = phi_1366_;
                phi_1371_ = evaluate_Verdict(_e530.visibility, _e530.is_doubted);
            } else {
                phi_1371_ = evaluate_Verdict(0.5f, true);
            }
            let _e536 = phi_1371_;
            phi_1372_ = _e536;
        }
        let _e538 = phi_1372_;
        visibility.member[_e55.first_primitive] = _e538.visibility;
        phi_1376_ = _e538.is_doubted;
        phi_1377_ = _e55.first_primitive;
    } else {
        phi_1376_ = false;
        phi_1377_ = 0u;
    }
    let _e543 = phi_1376_;
    let _e545 = phi_1377_;
    if (_e42 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e543 {
        let _e549 = atomicAdd((&shared_[0u]), 1u);
        phi_1388_ = _e549;
    } else {
        phi_1388_ = 0u;
    }
    let _e551 = phi_1388_;
    workgroupBarrier();
    if (_e42 == 0u) {
        let _e555 = atomicLoad((&shared_[0u]));
        let _e556 = atomicAdd((&list.member[3u]), _e555);
        atomicStore((&shared_[1u]), _e556);
    }
    workgroupBarrier();
    if _e543 {
        let _e559 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e559) + _e551)]), _e545);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_msm_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
