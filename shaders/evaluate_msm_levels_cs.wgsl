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

struct type_35 {
    member: array<lt_math_LightProjection>,
}

struct lt_math_LightPoint {
    uv: vec2<f32>,
    depth: f32,
    is_inside: bool,
}

struct lt_math_LevelPoint {
    level: u32,
    point: lt_math_LightPoint,
}

struct lt_bvh_slab_Span {
    near: f32,
    far: f32,
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
var<storage> levels: type_35;

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
        let _e55 = phi_147_;
        let _e57 = phi_148_;
        phi_149_ = _e55;
        phi_150_ = _e57;
    } else {
        phi_149_ = lt_bvh_traverse_Tree();
        phi_150_ = true;
    }
    let _e59 = phi_149_;
    let _e61 = phi_150_;
    if _e61 {
        phi_155_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_155_ = _e59;
    }
    let _e66 = phi_155_;
    return lt_bvh_traverse_Tree(_e66.root, _e66.first_primitive);
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

    let _e46 = (*param_4);
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
            let _e53 = phi_182_;
            phi_183_ = _e53;
        }
        let _e55 = phi_183_;
        phi_184_ = _e55;
    }
    let _e57 = phi_184_;
    let _e58 = (_e57 - 0.00000047683716f);
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
            let _e66 = phi_201_;
            phi_202_ = _e66;
        }
        let _e68 = phi_202_;
        phi_203_ = _e68;
    }
    let _e70 = phi_203_;
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
            let _e78 = phi_219_;
            phi_220_ = _e78;
        }
        let _e80 = phi_220_;
        phi_221_ = _e80;
    }
    let _e82 = phi_221_;
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
            let _e90 = phi_237_;
            phi_238_ = _e90;
        }
        let _e92 = phi_238_;
        phi_239_ = _e92;
    }
    let _e94 = phi_239_;
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
            let _e102 = phi_255_;
            phi_256_ = _e102;
        }
        let _e104 = phi_256_;
        phi_257_ = _e104;
    }
    let _e106 = phi_257_;
    let _e107 = (_e70 - _e58);
    let _e108 = (_e82 - _e58);
    let _e109 = (_e94 - _e58);
    let _e110 = (_e106 - _e58);
    let _e121 = ((((_e107 * param_6.x) + (_e108 * param_6.y)) + (_e109 * param_6.z)) + (_e110 * param_6.w));
    if ((bitcast<u32>(_e121) & 2147483647u) > 2139095040u) {
        phi_814_ = _e121;
        phi_815_ = f32();
        phi_816_ = true;
    } else {
        if (_e107 >= 0f) {
            if (_e108 >= 0f) {
                if (_e109 >= 0f) {
                    phi_292_ = (_e110 >= 0f);
                    phi_293_ = false;
                } else {
                    phi_292_ = bool();
                    phi_293_ = true;
                }
                let _e130 = phi_292_;
                let _e132 = phi_293_;
                phi_294_ = _e130;
                phi_295_ = _e132;
            } else {
                phi_294_ = bool();
                phi_295_ = true;
            }
            let _e134 = phi_294_;
            let _e136 = phi_295_;
            phi_296_ = _e134;
            phi_297_ = _e136;
        } else {
            phi_296_ = bool();
            phi_297_ = true;
        }
        let _e138 = phi_296_;
        let _e140 = phi_297_;
        if _e140 {
            phi_301_ = false;
        } else {
            phi_301_ = _e138;
        }
        let _e142 = phi_301_;
        if _e142 {
            phi_811_ = 1f;
            phi_812_ = f32();
            phi_813_ = true;
        } else {
            let _e143 = (0.5f * _e46);
            let _e144 = (1f - _e46);
            let _e146 = (param_6.x * _e144);
            let _e148 = (param_6.y * _e144);
            let _e150 = (param_6.z * _e144);
            let _e152 = (param_6.w * _e144);
            let _e153 = -(_e58);
            let _e154 = (1f - _e58);
            let _e156 = (vec4<f32>(1f, 1f, 1f, 1f).x - _e70);
            let _e158 = (vec4<f32>(1f, 1f, 1f, 1f).y - _e82);
            let _e160 = (vec4<f32>(1f, 1f, 1f, 1f).z - _e94);
            let _e162 = (vec4<f32>(1f, 1f, 1f, 1f).w - _e106);
            let _e163 = (_e107 - _e108);
            let _e164 = (_e108 - _e109);
            let _e165 = (_e109 - _e110);
            let _e166 = (_e110 - _e107);
            let _e167 = (_e163 * _e163);
            let _e168 = (_e164 * _e164);
            let _e169 = (_e165 * _e165);
            let _e170 = (_e166 * _e166);
            let _e171 = (_e107 - _e109);
            let _e172 = (_e108 - _e110);
            let _e173 = (_e109 - _e107);
            let _e174 = (_e110 - _e108);
            let _e175 = (_e171 * _e171);
            let _e176 = (_e172 * _e172);
            let _e177 = (_e173 * _e173);
            let _e178 = (_e174 * _e174);
            let _e183 = ((_e146 * _e148) * _e167);
            let _e184 = ((_e148 * _e150) * _e168);
            let _e185 = ((_e150 * _e152) * _e169);
            let _e186 = ((_e152 * _e146) * _e170);
            let _e195 = (((0.5f * _e146) * _e150) * _e175);
            let _e196 = (((0.5f * _e148) * _e152) * _e176);
            let _e197 = (((0.5f * _e150) * _e146) * _e177);
            let _e198 = (((0.5f * _e152) * _e148) * _e178);
            let _e199 = (_e107 * _e108);
            let _e200 = (_e108 * _e109);
            let _e201 = (_e109 * _e110);
            let _e202 = (_e110 * _e107);
            let _e203 = (_e107 * _e109);
            let _e204 = (_e108 * _e110);
            let _e205 = (_e109 * _e107);
            let _e206 = (_e110 * _e108);
            let _e207 = (_e183 * _e199);
            let _e208 = (_e184 * _e200);
            let _e209 = (_e185 * _e201);
            let _e210 = (_e186 * _e202);
            let _e211 = (_e195 * _e203);
            let _e212 = (_e196 * _e204);
            let _e213 = (_e197 * _e205);
            let _e214 = (_e198 * _e206);
            let _e215 = (_e70 * _e70);
            let _e216 = (_e82 * _e82);
            let _e217 = (_e94 * _e94);
            let _e218 = (_e106 * _e106);
            let _e219 = (_e156 * _e156);
            let _e220 = (_e158 * _e158);
            let _e221 = (_e160 * _e160);
            let _e222 = (_e162 * _e162);
            let _e223 = (_e143 * _e146);
            let _e224 = (_e143 * _e148);
            let _e225 = (_e143 * _e150);
            let _e226 = (_e143 * _e152);
            let _e235 = (((_e223 * _e107) * _e215) * _e153);
            let _e236 = (((_e224 * _e108) * _e216) * _e153);
            let _e237 = (((_e225 * _e109) * _e217) * _e153);
            let _e238 = (((_e226 * _e110) * _e218) * _e153);
            let _e247 = (((_e223 * _e107) * _e219) * _e154);
            let _e248 = (((_e224 * _e108) * _e220) * _e154);
            let _e249 = (((_e225 * _e109) * _e221) * _e154);
            let _e250 = (((_e226 * _e110) * _e222) * _e154);
            let _e418 = (((((((_e183 * _e150) * _e168) * _e175) + (_e143 * (((_e183 * ((_e215 * _e216) + (_e219 * _e220))) + (_e195 * ((_e215 * _e217) + (_e219 * _e221)))) + ((_e223 * _e215) * _e219)))) + ((((_e184 * _e152) * _e169) * _e176) + (_e143 * (((_e184 * ((_e216 * _e217) + (_e220 * _e221))) + (_e196 * ((_e216 * _e218) + (_e220 * _e222)))) + ((_e224 * _e216) * _e220))))) + ((((_e185 * _e146) * _e170) * _e177) + (_e143 * (((_e185 * ((_e217 * _e218) + (_e221 * _e222))) + (_e197 * ((_e217 * _e215) + (_e221 * _e219)))) + ((_e225 * _e217) * _e221))))) + ((((_e186 * _e148) * _e167) * _e178) + (_e143 * (((_e186 * ((_e218 * _e215) + (_e222 * _e219))) + (_e198 * ((_e218 * _e216) + (_e222 * _e220)))) + ((_e226 * _e218) * _e222)))));
            let _e421 = (((_e143 * _e143) * _e153) * _e154);
            let _e424 = (((((((_e207 * _e199) + (_e211 * _e203)) + (_e107 * ((_e235 * _e153) + (_e247 * _e154)))) + (((_e208 * _e200) + (_e212 * _e204)) + (_e108 * ((_e236 * _e153) + (_e248 * _e154))))) + (((_e209 * _e201) + (_e213 * _e205)) + (_e109 * ((_e237 * _e153) + (_e249 * _e154))))) + (((_e210 * _e202) + (_e214 * _e206)) + (_e110 * ((_e238 * _e153) + (_e250 * _e154))))) + ((_e421 * _e153) * _e154));
            let _e430 = (_e424 < 0.0000000000000000000000000000000001f);
            if _e430 {
                if ((bitcast<u32>(_e107) & 2147483647u) > 2139095040u) {
                    phi_614_ = _e107;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_613_ = 0f;
                    } else {
                        if (_e107 < 0f) {
                            phi_612_ = 0f;
                        } else {
                            phi_612_ = 1f;
                        }
                        let _e439 = phi_612_;
                        phi_613_ = _e439;
                    }
                    let _e441 = phi_613_;
                    phi_614_ = _e441;
                }
                let _e443 = phi_614_;
                if ((bitcast<u32>(_e108) & 2147483647u) > 2139095040u) {
                    phi_633_ = _e108;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_632_ = 0f;
                    } else {
                        if (_e108 < 0f) {
                            phi_631_ = 0f;
                        } else {
                            phi_631_ = 1f;
                        }
                        let _e452 = phi_631_;
                        phi_632_ = _e452;
                    }
                    let _e454 = phi_632_;
                    phi_633_ = _e454;
                }
                let _e456 = phi_633_;
                if ((bitcast<u32>(_e109) & 2147483647u) > 2139095040u) {
                    phi_652_ = _e109;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_651_ = 0f;
                    } else {
                        if (_e109 < 0f) {
                            phi_650_ = 0f;
                        } else {
                            phi_650_ = 1f;
                        }
                        let _e465 = phi_650_;
                        phi_651_ = _e465;
                    }
                    let _e467 = phi_651_;
                    phi_652_ = _e467;
                }
                let _e469 = phi_652_;
                if ((bitcast<u32>(_e110) & 2147483647u) > 2139095040u) {
                    phi_671_ = _e110;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_670_ = 0f;
                    } else {
                        if (_e110 < 0f) {
                            phi_669_ = 0f;
                        } else {
                            phi_669_ = 1f;
                        }
                        let _e478 = phi_669_;
                        phi_670_ = _e478;
                    }
                    let _e480 = phi_670_;
                    phi_671_ = _e480;
                }
                let _e482 = phi_671_;
                let _e490 = (((((_e443 * _e146) + (_e456 * _e148)) + (_e469 * _e150)) + (_e482 * _e152)) + _e143);
                if ((bitcast<u32>(_e490) & 2147483647u) > 2139095040u) {
                    phi_696_ = _e490;
                } else {
                    if (_e490 < 0f) {
                        phi_695_ = 0f;
                    } else {
                        if (_e490 > 1f) {
                            phi_694_ = 1f;
                        } else {
                            phi_694_ = _e490;
                        }
                        let _e497 = phi_694_;
                        phi_695_ = _e497;
                    }
                    let _e499 = phi_695_;
                    phi_696_ = _e499;
                }
                let _e501 = phi_696_;
                phi_809_ = _e501;
                phi_810_ = f32();
            } else {
                let _e503 = ((0.5f * -(((((((((_e207 * (_e107 + _e108)) + (_e211 * (_e107 + _e109))) + (_e235 * (_e107 + _e153))) + (_e247 * (_e107 + _e154))) + ((((_e208 * (_e108 + _e109)) + (_e212 * (_e108 + _e110))) + (_e236 * (_e108 + _e153))) + (_e248 * (_e108 + _e154)))) + ((((_e209 * (_e109 + _e110)) + (_e213 * (_e109 + _e107))) + (_e237 * (_e109 + _e153))) + (_e249 * (_e109 + _e154)))) + ((((_e210 * (_e110 + _e107)) + (_e214 * (_e110 + _e108))) + (_e238 * (_e110 + _e153))) + (_e250 * (_e110 + _e154)))) + (_e421 * (_e153 + _e154))))) / _e424);
                let _e504 = ((((((((_e207 + _e211) + _e235) + _e247) + (((_e208 + _e212) + _e236) + _e248)) + (((_e209 + _e213) + _e237) + _e249)) + (((_e210 + _e214) + _e238) + _e250)) + _e421) / _e424);
                let _e506 = ((_e503 * _e503) - _e504);
                if (_e506 > 0f) {
                    phi_707_ = sqrt(_e506);
                } else {
                    phi_707_ = 0f;
                }
                let _e510 = phi_707_;
                if (_e503 > 0f) {
                    let _e513 = (-(_e503) - _e510);
                    phi_724_ = lt_bvh_slab_Span(_e513, (_e504 / _e513));
                } else {
                    let _e516 = (_e510 - _e503);
                    if (_e516 > 0f) {
                        phi_722_ = (_e504 / _e516);
                    } else {
                        phi_722_ = 0f;
                    }
                    let _e520 = phi_722_;
                    phi_724_ = lt_bvh_slab_Span(_e520, _e516);
                }
                let _e523 = phi_724_;
                if (_e523.near >= 0f) {
                    phi_785_ = 1f;
                    phi_786_ = f32();
                    phi_787_ = true;
                } else {
                    let _e527 = (_e523.far <= 0f);
                    if _e527 {
                        phi_783_ = (_e418 / _e424);
                        phi_784_ = f32();
                    } else {
                        let _e538 = (((((_e146 * _e107) + (_e148 * _e108)) + (_e150 * _e109)) + (_e152 * _e110)) + (_e143 * (_e153 + _e154)));
                        let _e554 = (((((_e146 * (_e107 * _e107)) + (_e148 * (_e108 * _e108))) + (_e150 * (_e109 * _e109))) + (_e152 * (_e110 * _e110))) + (_e143 * ((_e153 * _e153) + (_e154 * _e154))));
                        if (-(_e523.near) <= _e523.far) {
                            phi_782_ = (1f - (((_e523.near * _e523.near) * ((_e523.far * _e554) - _e538)) / (_e523.far - _e523.near)));
                        } else {
                            phi_782_ = ((_e418 / _e424) + (((_e523.far * _e523.far) * (_e538 - (_e523.near * _e554))) / (_e523.far - _e523.near)));
                        }
                        let _e573 = phi_782_;
                        phi_783_ = f32();
                        phi_784_ = _e573;
                    }
                    let _e575 = phi_783_;
                    let _e577 = phi_784_;
                    phi_785_ = _e575;
                    phi_786_ = _e577;
                    phi_787_ = _e527;
                }
                let _e579 = phi_785_;
                let _e581 = phi_786_;
                let _e583 = phi_787_;
                if _e583 {
                    phi_791_ = _e579;
                } else {
                    phi_791_ = _e581;
                }
                let _e585 = phi_791_;
                if ((bitcast<u32>(_e585) & 2147483647u) > 2139095040u) {
                    phi_808_ = _e585;
                } else {
                    if (_e585 < 0f) {
                        phi_807_ = 0f;
                    } else {
                        if (_e585 > 1f) {
                            phi_806_ = 1f;
                        } else {
                            phi_806_ = _e585;
                        }
                        let _e592 = phi_806_;
                        phi_807_ = _e592;
                    }
                    let _e594 = phi_807_;
                    phi_808_ = _e594;
                }
                let _e596 = phi_808_;
                phi_809_ = f32();
                phi_810_ = _e596;
            }
            let _e598 = phi_809_;
            let _e600 = phi_810_;
            phi_811_ = _e598;
            phi_812_ = _e600;
            phi_813_ = _e430;
        }
        let _e602 = phi_811_;
        let _e604 = phi_812_;
        let _e606 = phi_813_;
        phi_814_ = _e602;
        phi_815_ = _e604;
        phi_816_ = _e606;
    }
    let _e608 = phi_814_;
    let _e610 = phi_815_;
    let _e612 = phi_816_;
    if _e612 {
        phi_820_ = _e608;
    } else {
        phi_820_ = _e610;
    }
    let _e614 = phi_820_;
    return _e614;
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
    var phi_1420_: f32;
    var phi_1421_: f32;
    var phi_1424_: f32;
    var phi_1453_: f32;
    var phi_1458_: f32;
    var phi_1459_: bool;
    var phi_1460_: f32;
    var phi_1461_: bool;
    var phi_1465_: f32;
    var phi_1485_: f32;
    var phi_1490_: f32;
    var phi_1491_: bool;
    var phi_1492_: f32;
    var phi_1493_: bool;
    var phi_1497_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_1546_: i32;
    var phi_1551_: i32;
    var phi_1556_: i32;
    var phi_1561_: i32;
    var phi_1570_: i32;
    var phi_1575_: i32;
    var phi_1580_: i32;
    var phi_1585_: i32;
    var phi_1630_: evaluate_Verdict;
    var phi_1631_: evaluate_Verdict;
    var phi_1632_: bool;
    var phi_1633_: evaluate_Verdict;
    var phi_1634_: evaluate_Verdict;
    var phi_1635_: bool;
    var phi_1639_: evaluate_Verdict;

    let _e43 = id_1;
    let _e50 = arrayLength((&map.member));
    let _e56 = arrayLength((&levels.member));
    let _e59 = p.member.size[0u];
    let _e61 = p.member.size[1u];
    let _e62 = lt_shaders_entry_pixel_index(_e43, _e59, _e61);
    if (bitcast<i32>(_e62.root) != 0i) {
        let _e68 = p.member.level_count;
        if (_e62.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e75 = samples.member[(0u + _e62.first_primitive)].normal[0u];
        let _e77 = global[0u];
        if (_e75 == _e77) {
            let _e80 = samples.member[(0u + _e62.first_primitive)].normal[1u];
            let _e82 = global[1u];
            if (_e80 == _e82) {
                let _e85 = samples.member[(0u + _e62.first_primitive)].normal[2u];
                let _e87 = global[2u];
                phi_880_ = (_e85 == _e87);
                phi_881_ = false;
            } else {
                phi_880_ = bool();
                phi_881_ = true;
            }
            let _e90 = phi_880_;
            let _e92 = phi_881_;
            phi_882_ = _e90;
            phi_883_ = _e92;
        } else {
            phi_882_ = bool();
            phi_883_ = true;
        }
        let _e94 = phi_882_;
        let _e96 = phi_883_;
        if _e96 {
            phi_887_ = false;
        } else {
            phi_887_ = _e94;
        }
        let _e98 = phi_887_;
        if !(_e98) {
            let _e101 = samples.member[(0u + _e62.first_primitive)].position;
            let _e103 = p.member.light.place;
            let _e109 = p.member.light.place[3u];
            let _e116 = (_e103.x - (_e101.x * _e109));
            let _e117 = (_e103.y - (_e101.y * _e109));
            let _e118 = (_e103.z - (_e101.z * _e109));
            let _e120 = samples.member[(0u + _e62.first_primitive)].normal;
            if ((((_e120.x * _e116) + (_e120.y * _e117)) + (_e120.z * _e118)) > 0f) {
                let _e134 = (((_e116 * _e116) + (_e117 * _e117)) + (_e118 * _e118));
                let _e136 = p.member.light.axis;
                let _e148 = p.member.light.place[3u];
                if (_e148 == 0f) {
                    phi_958_ = true;
                } else {
                    let _e151 = p.member.light.range_squared;
                    if (_e134 <= _e151) {
                        let _e154 = p.member.light.cos_outer;
                        phi_957_ = (-((((_e116 * _e136.x) + (_e117 * _e136.y)) + (_e118 * _e136.z))) >= (_e154 * sqrt(_e134)));
                    } else {
                        phi_957_ = false;
                    }
                    let _e159 = phi_957_;
                    phi_958_ = _e159;
                }
                let _e161 = phi_958_;
                if _e161 {
                    let _e163 = samples.member[(0u + _e62.first_primitive)].flags;
                    let _e171 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e177 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e171.unnamed.visibility, false), _e171.unnamed_1);
                    phi_969_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e177.unnamed, ((_e163 & 1u) == 0u));
                    phi_970_ = false;
                } else {
                    phi_969_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_970_ = true;
                }
                let _e182 = phi_969_;
                let _e184 = phi_970_;
                phi_971_ = _e182;
                phi_972_ = _e184;
            } else {
                phi_971_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_972_ = true;
            }
            let _e186 = phi_971_;
            let _e188 = phi_972_;
            if _e188 {
                let _e194 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e200 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e194.unnamed.visibility, false), _e194.unnamed_1);
                phi_979_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e200.unnamed, true);
            } else {
                phi_979_ = _e186;
            }
            let _e205 = phi_979_;
            phi_983_ = _e205;
        } else {
            let _e211 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e217 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e211.unnamed.visibility, false), _e211.unnamed_1);
            phi_983_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e217.unnamed, true);
        }
        let _e222 = phi_983_;
        if _e222.unnamed_1 {
            phi_1633_ = evaluate_Verdict(_e222.unnamed.visibility, _e222.unnamed.is_doubted);
            phi_1634_ = evaluate_Verdict();
            phi_1635_ = true;
        } else {
            let _e230 = samples.member[(0u + _e62.first_primitive)].position;
            let _e232 = p.member.map_size;
            let _e234 = (0.5f / f32(_e232));
            let _e241 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e248 = lt_math_LightPoint(vec2<f32>(_e241.uv.x, 0f), _e241.depth, _e241.is_inside);
            let _e252 = lt_math_LightPoint(_e248.uv, 0f, _e248.is_inside);
            phi_1003_ = lt_math_LightPoint();
            phi_1006_ = 0u;
            phi_1008_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e252.uv, _e252.depth, false));
            loop {
                let _e259 = phi_1003_;
                let _e261 = phi_1006_;
                let _e263 = phi_1008_;
                local_1 = _e263;
                local_2 = _e263;
                local_3 = _e263;
                if (_e261 < _e68) {
                    if _e263.point.is_inside {
                        phi_1169_ = lt_math_LightPoint();
                        phi_1170_ = u32();
                        phi_1171_ = lt_math_LevelPoint();
                        phi_1172_ = false;
                    } else {
                        if (_e261 < _e56) {
                        } else {
                            return;
                        }
                        let _e274 = levels.member[(0u + _e261)].row_w;
                        let _e285 = ((((_e274.x * _e230.x) + (_e274.y * _e230.y)) + (_e274.z * _e230.z)) + (_e274.w * 1f));
                        let _e287 = levels.member[(0u + _e261)].row_x;
                        let _e299 = (((((_e287.x * _e230.x) + (_e287.y * _e230.y)) + (_e287.z * _e230.z)) + (_e287.w * 1f)) / _e285);
                        let _e301 = levels.member[(0u + _e261)].row_y;
                        let _e313 = (((((_e301.x * _e230.x) + (_e301.y * _e230.y)) + (_e301.z * _e230.z)) + (_e301.w * 1f)) / _e285);
                        let _e315 = levels.member[(0u + _e261)].row_z;
                        let _e326 = ((((_e315.x * _e230.x) + (_e315.y * _e230.y)) + (_e315.z * _e230.z)) + (_e315.w * 1f));
                        if (_e285 > 0f) {
                            if (_e299 >= 0f) {
                                phi_1094_ = (_e299 <= 1f);
                            } else {
                                phi_1094_ = false;
                            }
                            let _e331 = phi_1094_;
                            if _e331 {
                                if (_e313 >= 0f) {
                                    phi_1103_ = (_e313 <= 1f);
                                } else {
                                    phi_1103_ = false;
                                }
                                let _e335 = phi_1103_;
                                if _e335 {
                                    if (_e326 >= 0f) {
                                        phi_1112_ = (_e326 <= 1f);
                                    } else {
                                        phi_1112_ = false;
                                    }
                                    let _e339 = phi_1112_;
                                    phi_1113_ = _e339;
                                    phi_1114_ = false;
                                } else {
                                    phi_1113_ = bool();
                                    phi_1114_ = true;
                                }
                                let _e341 = phi_1113_;
                                let _e343 = phi_1114_;
                                phi_1115_ = _e341;
                                phi_1116_ = _e343;
                            } else {
                                phi_1115_ = bool();
                                phi_1116_ = true;
                            }
                            let _e345 = phi_1115_;
                            let _e347 = phi_1116_;
                            phi_1117_ = _e345;
                            phi_1118_ = _e347;
                        } else {
                            phi_1117_ = bool();
                            phi_1118_ = true;
                        }
                        let _e349 = phi_1117_;
                        let _e351 = phi_1118_;
                        if _e351 {
                            phi_1122_ = false;
                        } else {
                            phi_1122_ = _e349;
                        }
                        let _e353 = phi_1122_;
                        if _e353 {
                            if (_e299 >= _e234) {
                                if (_e299 <= (1f - _e234)) {
                                    if (_e313 >= _e234) {
                                        phi_1149_ = (_e313 <= (1f - _e234));
                                        phi_1150_ = false;
                                    } else {
                                        phi_1149_ = bool();
                                        phi_1150_ = true;
                                    }
                                    let _e361 = phi_1149_;
                                    let _e363 = phi_1150_;
                                    phi_1151_ = _e361;
                                    phi_1152_ = _e363;
                                } else {
                                    phi_1151_ = bool();
                                    phi_1152_ = true;
                                }
                                let _e365 = phi_1151_;
                                let _e367 = phi_1152_;
                                phi_1153_ = _e365;
                                phi_1154_ = _e367;
                            } else {
                                phi_1153_ = bool();
                                phi_1154_ = true;
                            }
                            let _e369 = phi_1153_;
                            let _e371 = phi_1154_;
                            phi_1155_ = _e369;
                            phi_1156_ = _e371;
                        } else {
                            phi_1155_ = bool();
                            phi_1156_ = true;
                        }
                        let _e373 = phi_1155_;
                        let _e375 = phi_1156_;
                        if _e375 {
                            phi_1160_ = false;
                        } else {
                            phi_1160_ = _e373;
                        }
                        let _e377 = phi_1160_;
                        let _e384 = lt_math_LightPoint(vec2<f32>(_e299, _e259.uv.y), _e259.depth, _e259.is_inside);
                        let _e391 = lt_math_LightPoint(vec2<f32>(_e384.uv.x, _e313), _e384.depth, _e384.is_inside);
                        let _e395 = lt_math_LightPoint(_e391.uv, _e326, _e391.is_inside);
                        let _e399 = lt_math_LightPoint(_e395.uv, _e395.depth, _e377);
                        phi_1169_ = _e399;
                        phi_1170_ = (_e261 + 1u);
                        phi_1171_ = lt_math_LevelPoint(_e261, _e399);
                        phi_1172_ = true;
                    }
                    let _e403 = phi_1169_;
                    let _e405 = phi_1170_;
                    let _e407 = phi_1171_;
                    let _e409 = phi_1172_;
                    phi_1004_ = _e403;
                    phi_1007_ = _e405;
                    phi_1009_ = _e407;
                    phi_1173_ = _e409;
                } else {
                    phi_1004_ = lt_math_LightPoint();
                    phi_1007_ = u32();
                    phi_1009_ = lt_math_LevelPoint();
                    phi_1173_ = false;
                }
                let _e411 = phi_1004_;
                let _e413 = phi_1007_;
                let _e415 = phi_1009_;
                let _e417 = phi_1173_;
                continue;
                continuing {
                    phi_1003_ = _e411;
                    phi_1006_ = _e413;
                    phi_1008_ = _e415;
                    break if !(_e417);
                }
            }
            let _e420 = local_1;
            if _e420.point.is_inside {
                if (0f > 0f) {
                    let _e426 = local_2;
                    if (_e426.level < _e56) {
                    } else {
                        return;
                    }
                    let _e431 = levels.member[(0u + _e426.level)];
                    let _e437 = global[0u];
                    if (_e431.row_w.x == _e437) {
                        let _e440 = global[1u];
                        if (_e431.row_w.y == _e440) {
                            let _e443 = global[2u];
                            phi_1213_ = (_e431.row_w.z == _e443);
                            phi_1214_ = false;
                        } else {
                            phi_1213_ = bool();
                            phi_1214_ = true;
                        }
                        let _e446 = phi_1213_;
                        let _e448 = phi_1214_;
                        phi_1215_ = _e446;
                        phi_1216_ = _e448;
                    } else {
                        phi_1215_ = bool();
                        phi_1216_ = true;
                    }
                    let _e450 = phi_1215_;
                    let _e452 = phi_1216_;
                    if _e452 {
                        phi_1220_ = false;
                    } else {
                        phi_1220_ = _e450;
                    }
                    let _e454 = phi_1220_;
                    if _e454 {
                        let _e456 = samples.member[(0u + _e62.first_primitive)].normal;
                        let _e458 = p.member.map_size;
                        let _e528 = ((abs(((((_e431.row_x.x * _e456.x) + (_e431.row_x.y * _e456.y)) + (_e431.row_x.z * _e456.z)) / (((_e431.row_x.x * _e431.row_x.x) + (_e431.row_x.y * _e431.row_x.y)) + (_e431.row_x.z * _e431.row_x.z)))) + abs(((((_e431.row_y.x * _e456.x) + (_e431.row_y.y * _e456.y)) + (_e431.row_y.z * _e456.z)) / (((_e431.row_y.x * _e431.row_y.x) + (_e431.row_y.y * _e431.row_y.y)) + (_e431.row_y.z * _e431.row_y.z))))) / (abs(((((_e431.row_z.x * _e456.x) + (_e431.row_z.y * _e456.y)) + (_e431.row_z.z * _e456.z)) / (((_e431.row_z.x * _e431.row_z.x) + (_e431.row_z.y * _e431.row_z.y)) + (_e431.row_z.z * _e431.row_z.z)))) * f32(_e458)));
                        if (_e528 < 0.002f) {
                            phi_1302_ = _e528;
                        } else {
                            phi_1302_ = 0.002f;
                        }
                        let _e531 = phi_1302_;
                        phi_1421_ = _e531;
                    } else {
                        let _e533 = p.member.map_size;
                        let _e539 = samples.member[(0u + _e62.first_primitive)].position;
                        let _e550 = ((((_e431.row_w.x * _e539.x) + (_e431.row_w.y * _e539.y)) + (_e431.row_w.z * _e539.z)) + _e431.row_w.w);
                        let _e563 = ((_e431.row_x.x - (_e431.row_w.x * _e420.point.uv.x)) / _e550);
                        let _e564 = ((_e431.row_x.y - (_e431.row_w.y * _e420.point.uv.x)) / _e550);
                        let _e565 = ((_e431.row_x.z - (_e431.row_w.z * _e420.point.uv.x)) / _e550);
                        let _e578 = ((_e431.row_y.x - (_e431.row_w.x * _e420.point.uv.y)) / _e550);
                        let _e579 = ((_e431.row_y.y - (_e431.row_w.y * _e420.point.uv.y)) / _e550);
                        let _e580 = ((_e431.row_y.z - (_e431.row_w.z * _e420.point.uv.y)) / _e550);
                        let _e586 = samples.member[(0u + _e62.first_primitive)].normal;
                        let _e591 = ((_e579 * _e586.z) - (_e586.y * _e580));
                        let _e596 = ((_e580 * _e586.x) - (_e586.z * _e578));
                        let _e601 = ((_e578 * _e586.y) - (_e586.x * _e579));
                        let _e603 = samples.member[(0u + _e62.first_primitive)].normal;
                        let _e608 = ((_e564 * _e603.z) - (_e603.y * _e565));
                        let _e613 = ((_e565 * _e603.x) - (_e603.z * _e563));
                        let _e618 = ((_e563 * _e603.y) - (_e603.x * _e564));
                        let _e645 = ((abs(((((_e431.row_z.x * _e591) + (_e431.row_z.y * _e596)) + (_e431.row_z.z * _e601)) / (((_e563 * _e591) + (_e564 * _e596)) + (_e565 * _e601)))) + abs(((((_e431.row_z.x * _e608) + (_e431.row_z.y * _e613)) + (_e431.row_z.z * _e618)) / (((_e578 * _e608) + (_e579 * _e613)) + (_e580 * _e618))))) / f32(_e533));
                        let _e647 = (16f / f32(_e533));
                        if (_e645 < _e647) {
                            phi_1420_ = _e645;
                        } else {
                            phi_1420_ = _e647;
                        }
                        let _e650 = phi_1420_;
                        phi_1421_ = _e650;
                    }
                    let _e652 = phi_1421_;
                    phi_1424_ = (_e420.point.depth - (0f * _e652));
                } else {
                    phi_1424_ = _e420.point.depth;
                }
                let _e656 = phi_1424_;
                let _e662 = p.member.map_size;
                let _e663 = f32(_e662);
                let _e666 = ((_e420.point.uv.x * _e663) - 0.5f);
                let _e667 = ((_e420.point.uv.y * _e663) - 0.5f);
                if (_e666 > -8388608f) {
                    let _e679 = f32(select(0i, select(select(i32(_e666), i32(-2147483648), (_e666 < bitcast<f32>(3472883712u))), 2147483647i, (_e666 > bitcast<f32>(1325400063u))), (_e666 == _e666)));
                    if (_e679 > _e666) {
                        phi_1453_ = 1f;
                    } else {
                        phi_1453_ = 0f;
                    }
                    let _e682 = phi_1453_;
                    if (_e666 < 8388608f) {
                        phi_1458_ = (_e679 - _e682);
                        phi_1459_ = false;
                    } else {
                        phi_1458_ = f32();
                        phi_1459_ = true;
                    }
                    let _e685 = phi_1458_;
                    let _e687 = phi_1459_;
                    phi_1460_ = _e685;
                    phi_1461_ = _e687;
                } else {
                    phi_1460_ = f32();
                    phi_1461_ = true;
                }
                let _e689 = phi_1460_;
                let _e691 = phi_1461_;
                if _e691 {
                    phi_1465_ = _e666;
                } else {
                    phi_1465_ = _e689;
                }
                let _e693 = phi_1465_;
                if (_e667 > -8388608f) {
                    let _e705 = f32(select(0i, select(select(i32(_e667), i32(-2147483648), (_e667 < bitcast<f32>(3472883712u))), 2147483647i, (_e667 > bitcast<f32>(1325400063u))), (_e667 == _e667)));
                    if (_e705 > _e667) {
                        phi_1485_ = 1f;
                    } else {
                        phi_1485_ = 0f;
                    }
                    let _e708 = phi_1485_;
                    if (_e667 < 8388608f) {
                        phi_1490_ = (_e705 - _e708);
                        phi_1491_ = false;
                    } else {
                        phi_1490_ = f32();
                        phi_1491_ = true;
                    }
                    let _e711 = phi_1490_;
                    let _e713 = phi_1491_;
                    phi_1492_ = _e711;
                    phi_1493_ = _e713;
                } else {
                    phi_1492_ = f32();
                    phi_1493_ = true;
                }
                let _e715 = phi_1492_;
                let _e717 = phi_1493_;
                if _e717 {
                    phi_1497_ = _e667;
                } else {
                    phi_1497_ = _e715;
                }
                let _e719 = phi_1497_;
                let _e720 = (_e666 - _e693);
                let _e721 = (_e667 - _e719);
                let _e730 = select(0i, select(select(i32(_e693), i32(-2147483648), (_e693 < bitcast<f32>(3472883712u))), 2147483647i, (_e693 > bitcast<f32>(1325400063u))), (_e693 == _e693));
                let _e739 = select(0i, select(select(i32(_e719), i32(-2147483648), (_e719 < bitcast<f32>(3472883712u))), 2147483647i, (_e719 > bitcast<f32>(1325400063u))), (_e719 == _e719));
                let _e750 = p.member.test;
                let _e751 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e750);
                let _e753 = p.member.map_size;
                let _e755 = local_3;
                local = _e751;
                let _e758 = ((_e755.level * _e753) * _e753);
                let _e760 = (bitcast<i32>(_e753) - 1i);
                if (_e730 > 0i) {
                    phi_1546_ = _e730;
                } else {
                    phi_1546_ = 0i;
                }
                let _e763 = phi_1546_;
                if (_e739 > 0i) {
                    phi_1551_ = _e739;
                } else {
                    phi_1551_ = 0i;
                }
                let _e766 = phi_1551_;
                if (_e763 < _e760) {
                    phi_1556_ = _e763;
                } else {
                    phi_1556_ = _e760;
                }
                let _e769 = phi_1556_;
                if (_e766 < _e760) {
                    phi_1561_ = _e766;
                } else {
                    phi_1561_ = _e760;
                }
                let _e772 = phi_1561_;
                let _e773 = bitcast<u32>(_e769);
                let _e775 = (_e730 + 1i);
                let _e776 = (_e739 + 1i);
                if (_e775 > 0i) {
                    phi_1570_ = _e775;
                } else {
                    phi_1570_ = 0i;
                }
                let _e779 = phi_1570_;
                if (_e776 > 0i) {
                    phi_1575_ = _e776;
                } else {
                    phi_1575_ = 0i;
                }
                let _e782 = phi_1575_;
                if (_e779 < _e760) {
                    phi_1580_ = _e779;
                } else {
                    phi_1580_ = _e760;
                }
                let _e785 = phi_1580_;
                if (_e782 < _e760) {
                    phi_1585_ = _e782;
                } else {
                    phi_1585_ = _e760;
                }
                let _e788 = phi_1585_;
                let _e789 = bitcast<u32>(_e785);
                let _e791 = (bitcast<u32>(_e772) * _e753);
                let _e792 = (bitcast<u32>(_e788) * _e753);
                let _e797 = ((_e791 + _e773) + _e758);
                let _e798 = ((_e791 + _e789) + _e758);
                let _e799 = ((_e792 + _e773) + _e758);
                let _e800 = ((_e792 + _e789) + _e758);
                if (_e797 < _e50) {
                } else {
                    return;
                }
                let _e804 = map.member[(0u + _e797)];
                if (_e798 < _e50) {
                } else {
                    return;
                }
                let _e808 = map.member[(0u + _e798)];
                if (_e799 < _e50) {
                } else {
                    return;
                }
                let _e812 = map.member[(0u + _e799)];
                if (_e800 < _e50) {
                } else {
                    return;
                }
                let _e816 = map.member[(0u + _e800)];
                let _e818 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e804, _e808, _e812, _e816), vec4<f32>(((1f - _e720) * (1f - _e721)), (_e720 * (1f - _e721)), ((1f - _e720) * _e721), (_e720 * _e721)), _e656);
                phi_1630_ = evaluate_Verdict(_e818, false);
                phi_1631_ = evaluate_Verdict();
                phi_1632_ = false;
            } else {
                phi_1630_ = evaluate_Verdict();
                phi_1631_ = evaluate_Verdict(1f, false);
                phi_1632_ = true;
            }
            let _e822 = phi_1630_;
            let _e824 = phi_1631_;
            let _e826 = phi_1632_;
            phi_1633_ = _e824;
            phi_1634_ = _e822;
            phi_1635_ = _e826;
        }
        let _e828 = phi_1633_;
        let _e830 = phi_1634_;
        let _e832 = phi_1635_;
        if _e832 {
            phi_1639_ = _e828;
        } else {
            phi_1639_ = _e830;
        }
        let _e834 = phi_1639_;
        if (_e62.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e62.first_primitive)] = _e834.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_msm_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
