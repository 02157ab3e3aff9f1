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
        let _e53 = phi_146_;
        let _e55 = phi_147_;
        phi_148_ = _e53;
        phi_149_ = _e55;
    } else {
        phi_148_ = lt_bvh_traverse_Tree();
        phi_149_ = true;
    }
    let _e57 = phi_148_;
    let _e59 = phi_149_;
    if _e59 {
        phi_154_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_154_ = _e57;
    }
    let _e64 = phi_154_;
    return lt_bvh_traverse_Tree(_e64.root, _e64.first_primitive);
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

    let _e44 = (*param_4);
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
            let _e51 = phi_181_;
            phi_182_ = _e51;
        }
        let _e53 = phi_182_;
        phi_183_ = _e53;
    }
    let _e55 = phi_183_;
    let _e56 = (_e55 - 0.00000047683716f);
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
            let _e64 = phi_200_;
            phi_201_ = _e64;
        }
        let _e66 = phi_201_;
        phi_202_ = _e66;
    }
    let _e68 = phi_202_;
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
            let _e76 = phi_218_;
            phi_219_ = _e76;
        }
        let _e78 = phi_219_;
        phi_220_ = _e78;
    }
    let _e80 = phi_220_;
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
            let _e88 = phi_236_;
            phi_237_ = _e88;
        }
        let _e90 = phi_237_;
        phi_238_ = _e90;
    }
    let _e92 = phi_238_;
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
            let _e100 = phi_254_;
            phi_255_ = _e100;
        }
        let _e102 = phi_255_;
        phi_256_ = _e102;
    }
    let _e104 = phi_256_;
    let _e105 = (_e68 - _e56);
    let _e106 = (_e80 - _e56);
    let _e107 = (_e92 - _e56);
    let _e108 = (_e104 - _e56);
    let _e119 = ((((_e105 * param_6.x) + (_e106 * param_6.y)) + (_e107 * param_6.z)) + (_e108 * param_6.w));
    if ((bitcast<u32>(_e119) & 2147483647u) > 2139095040u) {
        phi_813_ = _e119;
        phi_814_ = f32();
        phi_815_ = true;
    } else {
        if (_e105 >= 0f) {
            if (_e106 >= 0f) {
                if (_e107 >= 0f) {
                    phi_291_ = (_e108 >= 0f);
                    phi_292_ = false;
                } else {
                    phi_291_ = bool();
                    phi_292_ = true;
                }
                let _e128 = phi_291_;
                let _e130 = phi_292_;
                phi_293_ = _e128;
                phi_294_ = _e130;
            } else {
                phi_293_ = bool();
                phi_294_ = true;
            }
            let _e132 = phi_293_;
            let _e134 = phi_294_;
            phi_295_ = _e132;
            phi_296_ = _e134;
        } else {
            phi_295_ = bool();
            phi_296_ = true;
        }
        let _e136 = phi_295_;
        let _e138 = phi_296_;
        if _e138 {
            phi_300_ = false;
        } else {
            phi_300_ = _e136;
        }
        let _e140 = phi_300_;
        if _e140 {
            phi_810_ = 1f;
            phi_811_ = f32();
            phi_812_ = true;
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
                    phi_613_ = _e105;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_612_ = 0f;
                    } else {
                        if (_e105 < 0f) {
                            phi_611_ = 0f;
                        } else {
                            phi_611_ = 1f;
                        }
                        let _e437 = phi_611_;
                        phi_612_ = _e437;
                    }
                    let _e439 = phi_612_;
                    phi_613_ = _e439;
                }
                let _e441 = phi_613_;
                if ((bitcast<u32>(_e106) & 2147483647u) > 2139095040u) {
                    phi_632_ = _e106;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_631_ = 0f;
                    } else {
                        if (_e106 < 0f) {
                            phi_630_ = 0f;
                        } else {
                            phi_630_ = 1f;
                        }
                        let _e450 = phi_630_;
                        phi_631_ = _e450;
                    }
                    let _e452 = phi_631_;
                    phi_632_ = _e452;
                }
                let _e454 = phi_632_;
                if ((bitcast<u32>(_e107) & 2147483647u) > 2139095040u) {
                    phi_651_ = _e107;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_650_ = 0f;
                    } else {
                        if (_e107 < 0f) {
                            phi_649_ = 0f;
                        } else {
                            phi_649_ = 1f;
                        }
                        let _e463 = phi_649_;
                        phi_650_ = _e463;
                    }
                    let _e465 = phi_650_;
                    phi_651_ = _e465;
                }
                let _e467 = phi_651_;
                if ((bitcast<u32>(_e108) & 2147483647u) > 2139095040u) {
                    phi_670_ = _e108;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_669_ = 0f;
                    } else {
                        if (_e108 < 0f) {
                            phi_668_ = 0f;
                        } else {
                            phi_668_ = 1f;
                        }
                        let _e476 = phi_668_;
                        phi_669_ = _e476;
                    }
                    let _e478 = phi_669_;
                    phi_670_ = _e478;
                }
                let _e480 = phi_670_;
                let _e488 = (((((_e441 * _e144) + (_e454 * _e146)) + (_e467 * _e148)) + (_e480 * _e150)) + _e141);
                if ((bitcast<u32>(_e488) & 2147483647u) > 2139095040u) {
                    phi_695_ = _e488;
                } else {
                    if (_e488 < 0f) {
                        phi_694_ = 0f;
                    } else {
                        if (_e488 > 1f) {
                            phi_693_ = 1f;
                        } else {
                            phi_693_ = _e488;
                        }
                        let _e495 = phi_693_;
                        phi_694_ = _e495;
                    }
                    let _e497 = phi_694_;
                    phi_695_ = _e497;
                }
                let _e499 = phi_695_;
                phi_808_ = _e499;
                phi_809_ = f32();
            } else {
                let _e501 = ((0.5f * -(((((((((_e205 * (_e105 + _e106)) + (_e209 * (_e105 + _e107))) + (_e233 * (_e105 + _e151))) + (_e245 * (_e105 + _e152))) + ((((_e206 * (_e106 + _e107)) + (_e210 * (_e106 + _e108))) + (_e234 * (_e106 + _e151))) + (_e246 * (_e106 + _e152)))) + ((((_e207 * (_e107 + _e108)) + (_e211 * (_e107 + _e105))) + (_e235 * (_e107 + _e151))) + (_e247 * (_e107 + _e152)))) + ((((_e208 * (_e108 + _e105)) + (_e212 * (_e108 + _e106))) + (_e236 * (_e108 + _e151))) + (_e248 * (_e108 + _e152)))) + (_e419 * (_e151 + _e152))))) / _e422);
                let _e502 = ((((((((_e205 + _e209) + _e233) + _e245) + (((_e206 + _e210) + _e234) + _e246)) + (((_e207 + _e211) + _e235) + _e247)) + (((_e208 + _e212) + _e236) + _e248)) + _e419) / _e422);
                let _e504 = ((_e501 * _e501) - _e502);
                if (_e504 > 0f) {
                    phi_706_ = sqrt(_e504);
                } else {
                    phi_706_ = 0f;
                }
                let _e508 = phi_706_;
                if (_e501 > 0f) {
                    let _e511 = (-(_e501) - _e508);
                    phi_723_ = lt_bvh_slab_Span(_e511, (_e502 / _e511));
                } else {
                    let _e514 = (_e508 - _e501);
                    if (_e514 > 0f) {
                        phi_721_ = (_e502 / _e514);
                    } else {
                        phi_721_ = 0f;
                    }
                    let _e518 = phi_721_;
                    phi_723_ = lt_bvh_slab_Span(_e518, _e514);
                }
                let _e521 = phi_723_;
                if (_e521.near >= 0f) {
                    phi_784_ = 1f;
                    phi_785_ = f32();
                    phi_786_ = true;
                } else {
                    let _e525 = (_e521.far <= 0f);
                    if _e525 {
                        phi_782_ = (_e416 / _e422);
                        phi_783_ = f32();
                    } else {
                        let _e536 = (((((_e144 * _e105) + (_e146 * _e106)) + (_e148 * _e107)) + (_e150 * _e108)) + (_e141 * (_e151 + _e152)));
                        let _e552 = (((((_e144 * (_e105 * _e105)) + (_e146 * (_e106 * _e106))) + (_e148 * (_e107 * _e107))) + (_e150 * (_e108 * _e108))) + (_e141 * ((_e151 * _e151) + (_e152 * _e152))));
                        if (-(_e521.near) <= _e521.far) {
                            phi_781_ = (1f - (((_e521.near * _e521.near) * ((_e521.far * _e552) - _e536)) / (_e521.far - _e521.near)));
                        } else {
                            phi_781_ = ((_e416 / _e422) + (((_e521.far * _e521.far) * (_e536 - (_e521.near * _e552))) / (_e521.far - _e521.near)));
                        }
                        let _e571 = phi_781_;
                        phi_782_ = f32();
                        phi_783_ = _e571;
                    }
                    let _e573 = phi_782_;
                    let _e575 = phi_783_;
                    phi_784_ = _e573;
                    phi_785_ = _e575;
                    phi_786_ = _e525;
                }
                let _e577 = phi_784_;
                let _e579 = phi_785_;
                let _e581 = phi_786_;
                if _e581 {
                    phi_790_ = _e577;
                } else {
                    phi_790_ = _e579;
                }
                let _e583 = phi_790_;
                if ((bitcast<u32>(_e583) & 2147483647u) > 2139095040u) {
                    phi_807_ = _e583;
                } else {
                    if (_e583 < 0f) {
                        phi_806_ = 0f;
                    } else {
                        if (_e583 > 1f) {
                            phi_805_ = 1f;
                        } else {
                            phi_805_ = _e583;
                        }
                        let _e590 = phi_805_;
                        phi_806_ = _e590;
                    }
                    let _e592 = phi_806_;
                    phi_807_ = _e592;
                }
                let _e594 = phi_807_;
                phi_808_ = f32();
                phi_809_ = _e594;
            }
            let _e596 = phi_808_;
            let _e598 = phi_809_;
            phi_810_ = _e596;
            phi_811_ = _e598;
            phi_812_ = _e428;
        }
        let _e600 = phi_810_;
        let _e602 = phi_811_;
        let _e604 = phi_812_;
        phi_813_ = _e600;
        phi_814_ = _e602;
        phi_815_ = _e604;
    }
    let _e606 = phi_813_;
    let _e608 = phi_814_;
    let _e610 = phi_815_;
    if _e610 {
        phi_819_ = _e606;
    } else {
        phi_819_ = _e608;
    }
    let _e612 = phi_819_;
    return _e612;
}

fn function_() {
    var local_1: f32;
    var phi_868_: bool;
    var phi_869_: bool;
    var phi_870_: bool;
    var phi_871_: bool;
    var phi_875_: bool;
    var phi_919_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_923_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1000_: bool;
    var phi_1009_: bool;
    var phi_1018_: bool;
    var phi_1019_: bool;
    var phi_1020_: bool;
    var phi_1021_: bool;
    var phi_1022_: bool;
    var phi_1023_: bool;
    var phi_1024_: bool;
    var phi_1028_: bool;
    var phi_1122_: f32;
    var phi_1125_: f32;
    var phi_1154_: f32;
    var phi_1159_: f32;
    var phi_1160_: bool;
    var phi_1161_: f32;
    var phi_1162_: bool;
    var phi_1166_: f32;
    var phi_1186_: f32;
    var phi_1191_: f32;
    var phi_1192_: bool;
    var phi_1193_: f32;
    var phi_1194_: bool;
    var phi_1198_: f32;
    var phi_1244_: i32;
    var phi_1249_: i32;
    var phi_1254_: i32;
    var phi_1259_: i32;
    var phi_1268_: i32;
    var phi_1273_: i32;
    var phi_1278_: i32;
    var phi_1283_: i32;
    var phi_1330_: bool;
    var phi_1338_: bool;
    var phi_1350_: bool;
    var phi_1351_: bool;
    var phi_1355_: f32;
    var phi_1361_: f32;
    var phi_1363_: evaluate_Verdict;
    var phi_1368_: evaluate_Verdict;
    var phi_1369_: evaluate_Verdict;
    var phi_1373_: bool;
    var phi_1374_: u32;
    var phi_1385_: u32;

    let _e41 = id_1;
    let _e42 = local_2;
    let _e47 = arrayLength((&map.member));
    let _e52 = p.member.size[0u];
    let _e54 = p.member.size[1u];
    let _e55 = lt_shaders_entry_pixel_index(_e41, _e52, _e54);
    if (bitcast<i32>(_e55.root) != 0i) {
        let _e62 = p.member.light;
        let _e65 = samples.member[_e55.first_primitive].normal[0u];
        let _e67 = global[0u];
        if (_e65 == _e67) {
            let _e70 = samples.member[_e55.first_primitive].normal[1u];
            let _e72 = global[1u];
            if (_e70 == _e72) {
                let _e75 = samples.member[_e55.first_primitive].normal[2u];
                let _e77 = global[2u];
                phi_868_ = (_e75 == _e77);
                phi_869_ = false;
            } else {
                phi_868_ = bool();
                phi_869_ = true;
            }
            let _e80 = phi_868_;
            let _e82 = phi_869_;
            phi_870_ = _e80;
            phi_871_ = _e82;
        } else {
            phi_870_ = bool();
            phi_871_ = true;
        }
        let _e84 = phi_870_;
        let _e86 = phi_871_;
        if _e86 {
            phi_875_ = false;
        } else {
            phi_875_ = _e84;
        }
        let _e88 = phi_875_;
        if !(_e88) {
            let _e91 = samples.member[_e55.first_primitive].normal;
            let _e93 = samples.member[_e55.first_primitive].position;
            if ((((_e91.x * (_e62.x - (_e93.x * _e62.w))) + (_e91.y * (_e62.y - (_e93.y * _e62.w)))) + (_e91.z * (_e62.z - (_e93.z * _e62.w)))) > 0f) {
                let _e117 = samples.member[_e55.first_primitive].flags;
                let _e125 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e131 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e125.unnamed.visibility, false), _e125.unnamed_1);
                phi_919_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e131.unnamed, ((_e117 & 1u) == 0u));
            } else {
                let _e140 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e146 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e140.unnamed.visibility, false), _e140.unnamed_1);
                phi_919_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e146.unnamed, true);
            }
            let _e151 = phi_919_;
            phi_923_ = _e151;
        } else {
            let _e157 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e163 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e157.unnamed.visibility, false), _e157.unnamed_1);
            phi_923_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e163.unnamed, true);
        }
        let _e168 = phi_923_;
        if _e168.unnamed_1 {
            phi_1369_ = evaluate_Verdict(_e168.unnamed.visibility, _e168.unnamed.is_doubted);
        } else {
            let _e176 = samples.member[_e55.first_primitive].position;
            let _e182 = p.member.projection.row_w;
            let _e193 = ((((_e182.x * _e176.x) + (_e182.y * _e176.y)) + (_e182.z * _e176.z)) + (_e182.w * 1f));
            let _e195 = p.member.projection.row_x;
            let _e207 = (((((_e195.x * _e176.x) + (_e195.y * _e176.y)) + (_e195.z * _e176.z)) + (_e195.w * 1f)) / _e193);
            let _e209 = p.member.projection.row_y;
            let _e221 = (((((_e209.x * _e176.x) + (_e209.y * _e176.y)) + (_e209.z * _e176.z)) + (_e209.w * 1f)) / _e193);
            let _e223 = p.member.projection.row_z;
            let _e234 = ((((_e223.x * _e176.x) + (_e223.y * _e176.y)) + (_e223.z * _e176.z)) + (_e223.w * 1f));
            if (_e193 > 0f) {
                if (_e207 >= 0f) {
                    phi_1000_ = (_e207 <= 1f);
                } else {
                    phi_1000_ = false;
                }
                let _e239 = phi_1000_;
                if _e239 {
                    if (_e221 >= 0f) {
                        phi_1009_ = (_e221 <= 1f);
                    } else {
                        phi_1009_ = false;
                    }
                    let _e243 = phi_1009_;
                    if _e243 {
                        if (_e234 >= 0f) {
                            phi_1018_ = (_e234 <= 1f);
                        } else {
                            phi_1018_ = false;
                        }
                        let _e247 = phi_1018_;
                        phi_1019_ = _e247;
                        phi_1020_ = false;
                    } else {
                        phi_1019_ = bool();
                        phi_1020_ = true;
                    }
                    let _e249 = phi_1019_;
                    let _e251 = phi_1020_;
                    phi_1021_ = _e249;
                    phi_1022_ = _e251;
                } else {
                    phi_1021_ = bool();
                    phi_1022_ = true;
                }
                let _e253 = phi_1021_;
                let _e255 = phi_1022_;
                phi_1023_ = _e253;
                phi_1024_ = _e255;
            } else {
                phi_1023_ = bool();
                phi_1024_ = true;
            }
            let _e257 = phi_1023_;
            let _e259 = phi_1024_;
            if _e259 {
                phi_1028_ = false;
            } else {
                phi_1028_ = _e257;
            }
            let _e261 = phi_1028_;
            if _e261 {
                if (0f > 0f) {
                    let _e264 = samples.member[_e55.first_primitive].normal;
                    let _e266 = p.member.map_size;
                    let _e269 = p.member.projection.row_x;
                    let _e291 = p.member.projection.row_y;
                    let _e313 = p.member.projection.row_z;
                    let _e340 = ((abs(((((_e269.x * _e264.x) + (_e269.y * _e264.y)) + (_e269.z * _e264.z)) / (((_e269.x * _e269.x) + (_e269.y * _e269.y)) + (_e269.z * _e269.z)))) + abs(((((_e291.x * _e264.x) + (_e291.y * _e264.y)) + (_e291.z * _e264.z)) / (((_e291.x * _e291.x) + (_e291.y * _e291.y)) + (_e291.z * _e291.z))))) / (abs(((((_e313.x * _e264.x) + (_e313.y * _e264.y)) + (_e313.z * _e264.z)) / (((_e313.x * _e313.x) + (_e313.y * _e313.y)) + (_e313.z * _e313.z)))) * f32(_e266)));
                    if (_e340 < 0.002f) {
                        phi_1122_ = _e340;
                    } else {
                        phi_1122_ = 0.002f;
                    }
                    let _e343 = phi_1122_;
                    phi_1125_ = (_e234 - (0f * _e343));
                } else {
                    phi_1125_ = _e234;
                }
                let _e347 = phi_1125_;
                let _e349 = p.member.map_size;
                let _e350 = f32(_e349);
                let _e353 = ((_e207 * _e350) - 0.5f);
                let _e354 = ((_e221 * _e350) - 0.5f);
                if (_e353 > -8388608f) {
                    let _e366 = f32(select(0i, select(select(i32(_e353), i32(-2147483648), (_e353 < bitcast<f32>(3472883712u))), 2147483647i, (_e353 > bitcast<f32>(1325400063u))), (_e353 == _e353)));
                    if (_e366 > _e353) {
                        phi_1154_ = 1f;
                    } else {
                        phi_1154_ = 0f;
                    }
                    let _e369 = phi_1154_;
                    if (_e353 < 8388608f) {
                        phi_1159_ = (_e366 - _e369);
                        phi_1160_ = false;
                    } else {
                        phi_1159_ = f32();
                        phi_1160_ = true;
                    }
                    let _e372 = phi_1159_;
                    let _e374 = phi_1160_;
                    phi_1161_ = _e372;
                    phi_1162_ = _e374;
                } else {
                    phi_1161_ = f32();
                    phi_1162_ = true;
                }
                let _e376 = phi_1161_;
                let _e378 = phi_1162_;
                if _e378 {
                    phi_1166_ = _e353;
                } else {
                    phi_1166_ = _e376;
                }
                let _e380 = phi_1166_;
                if (_e354 > -8388608f) {
                    let _e392 = f32(select(0i, select(select(i32(_e354), i32(-2147483648), (_e354 < bitcast<f32>(3472883712u))), 2147483647i, (_e354 > bitcast<f32>(1325400063u))), (_e354 == _e354)));
                    if (_e392 > _e354) {
                        phi_1186_ = 1f;
                    } else {
                        phi_1186_ = 0f;
                    }
                    let _e395 = phi_1186_;
                    if (_e354 < 8388608f) {
                        phi_1191_ = (_e392 - _e395);
                        phi_1192_ = false;
                    } else {
                        phi_1191_ = f32();
                        phi_1192_ = true;
                    }
                    let _e398 = phi_1191_;
                    let _e400 = phi_1192_;
                    phi_1193_ = _e398;
                    phi_1194_ = _e400;
                } else {
                    phi_1193_ = f32();
                    phi_1194_ = true;
                }
                let _e402 = phi_1193_;
                let _e404 = phi_1194_;
                if _e404 {
                    phi_1198_ = _e354;
                } else {
                    phi_1198_ = _e402;
                }
                let _e406 = phi_1198_;
                let _e407 = (_e353 - _e380);
                let _e408 = (_e354 - _e406);
                let _e417 = select(0i, select(select(i32(_e380), i32(-2147483648), (_e380 < bitcast<f32>(3472883712u))), 2147483647i, (_e380 > bitcast<f32>(1325400063u))), (_e380 == _e380));
                let _e426 = select(0i, select(select(i32(_e406), i32(-2147483648), (_e406 < bitcast<f32>(3472883712u))), 2147483647i, (_e406 > bitcast<f32>(1325400063u))), (_e406 == _e406));
                let _e437 = p.member.test;
                let _e438 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e437);
                let _e440 = p.member.map_size;
                local_1 = _e438;
                let _e442 = (bitcast<i32>(_e440) - 1i);
                if (_e417 > 0i) {
                    phi_1244_ = _e417;
                } else {
                    phi_1244_ = 0i;
                }
                let _e445 = phi_1244_;
                if (_e426 > 0i) {
                    phi_1249_ = _e426;
                } else {
                    phi_1249_ = 0i;
                }
                let _e448 = phi_1249_;
                if (_e445 < _e442) {
                    phi_1254_ = _e445;
                } else {
                    phi_1254_ = _e442;
                }
                let _e451 = phi_1254_;
                if (_e448 < _e442) {
                    phi_1259_ = _e448;
                } else {
                    phi_1259_ = _e442;
                }
                let _e454 = phi_1259_;
                let _e455 = bitcast<u32>(_e451);
                let _e457 = (_e417 + 1i);
                let _e458 = (_e426 + 1i);
                if (_e457 > 0i) {
                    phi_1268_ = _e457;
                } else {
                    phi_1268_ = 0i;
                }
                let _e461 = phi_1268_;
                if (_e458 > 0i) {
                    phi_1273_ = _e458;
                } else {
                    phi_1273_ = 0i;
                }
                let _e464 = phi_1273_;
                if (_e461 < _e442) {
                    phi_1278_ = _e461;
                } else {
                    phi_1278_ = _e442;
                }
                let _e467 = phi_1278_;
                if (_e464 < _e442) {
                    phi_1283_ = _e464;
                } else {
                    phi_1283_ = _e442;
                }
                let _e470 = phi_1283_;
                let _e471 = bitcast<u32>(_e467);
                let _e473 = (bitcast<u32>(_e454) * _e440);
                let _e474 = (bitcast<u32>(_e470) * _e440);
                let _e475 = (_e473 + _e455);
                let _e476 = (_e473 + _e471);
                let _e477 = (_e474 + _e455);
                let _e478 = (_e474 + _e471);
                if (_e475 < _e47) {
                } else {
                    return;
                }
                let _e482 = map.member[(0u + _e475)];
                if (_e476 < _e47) {
                } else {
                    return;
                }
                let _e486 = map.member[(0u + _e476)];
                if (_e477 < _e47) {
                } else {
                    return;
                }
                let _e490 = map.member[(0u + _e477)];
                if (_e478 < _e47) {
                } else {
                    return;
                }
                let _e494 = map.member[(0u + _e478)];
                let _e496 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local_1), vec4<f32>(_e482, _e486, _e490, _e494), vec4<f32>(((1f - _e407) * (1f - _e408)), (_e407 * (1f - _e408)), ((1f - _e407) * _e408), (_e407 * _e408)), _e347);
                let _e498 = p.member.epsilon;
                if (_e496 <= _e498) {
                    phi_1330_ = true;
                } else {
                    phi_1330_ = (_e496 >= (1f - _e498));
                }
                let _e503 = phi_1330_;
                if ((bitcast<u32>(_e496) & 2147483647u) > 2139095040u) {
                    phi_1338_ = true;
                } else {
                    phi_1338_ = !(_e503);
                }
                let _e509 = phi_1338_;
                if _e509 {
                    if (_e496 > 0f) {
                        if (_e496 < 1f) {
                            phi_1350_ = false;
                        } else {
                            phi_1350_ = true;
                        }
                        let _e513 = phi_1350_;
                        phi_1351_ = _e513;
                    } else {
                        phi_1351_ = true;
                    }
                    let _e515 = phi_1351_;
                    if _e515 {
                        phi_1355_ = 0.5f;
                    } else {
                        phi_1355_ = _e496;
                    }
                    let _e517 = phi_1355_;
                    phi_1363_ = evaluate_Verdict(_e517, true);
                } else {
                    if (_e496 > 0.5f) {
                        phi_1361_ = 1f;
                    } else {
                        phi_1361_ = 0f;
                    }
                    let _e521 = phi_1361_;
                    phi_1363_ = evaluate_Verdict(_e521, false);
                }
                let _e524 = phi_1363_;
                phi_1368_ = evaluate_Verdict(_e524.visibility, _e524.is_doubted);
            } else {
                phi_1368_ = evaluate_Verdict(0.5f, true);
            }
            let _e530 = phi_1368_;
            phi_1369_ = _e530;
        }
        let _e532 = phi_1369_;
        visibility.member[_e55.first_primitive] = _e532.visibility;
        phi_1373_ = _e532.is_doubted;
        phi_1374_ = _e55.first_primitive;
    } else {
        phi_1373_ = false;
        phi_1374_ = 0u;
    }
    let _e537 = phi_1373_;
    let _e539 = phi_1374_;
    if (_e42 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e537 {
        let _e543 = atomicAdd((&shared_[0u]), 1u);
        phi_1385_ = _e543;
    } else {
        phi_1385_ = 0u;
    }
    let _e545 = phi_1385_;
    workgroupBarrier();
    if (_e42 == 0u) {
        let _e549 = atomicLoad((&shared_[0u]));
        let _e550 = atomicAdd((&list.member[3u]), _e549);
        atomicStore((&shared_[1u]), _e550);
    }
    workgroupBarrier();
    if _e537 {
        let _e553 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e553) + _e545)]), _e539);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_msm_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
