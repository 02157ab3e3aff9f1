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
        let _e55 = phi_146_;
        let _e57 = phi_147_;
        phi_148_ = _e55;
        phi_149_ = _e57;
    } else {
        phi_148_ = lt_bvh_traverse_Tree();
        phi_149_ = true;
    }
    let _e59 = phi_148_;
    let _e61 = phi_149_;
    if _e61 {
        phi_154_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_154_ = _e59;
    }
    let _e66 = phi_154_;
    return lt_bvh_traverse_Tree(_e66.root, _e66.first_primitive);
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

    let _e46 = (*param_4);
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
            let _e53 = phi_181_;
            phi_182_ = _e53;
        }
        let _e55 = phi_182_;
        phi_183_ = _e55;
    }
    let _e57 = phi_183_;
    let _e58 = (_e57 - 0.00000047683716f);
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
            let _e66 = phi_200_;
            phi_201_ = _e66;
        }
        let _e68 = phi_201_;
        phi_202_ = _e68;
    }
    let _e70 = phi_202_;
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
            let _e78 = phi_218_;
            phi_219_ = _e78;
        }
        let _e80 = phi_219_;
        phi_220_ = _e80;
    }
    let _e82 = phi_220_;
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
            let _e90 = phi_236_;
            phi_237_ = _e90;
        }
        let _e92 = phi_237_;
        phi_238_ = _e92;
    }
    let _e94 = phi_238_;
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
            let _e102 = phi_254_;
            phi_255_ = _e102;
        }
        let _e104 = phi_255_;
        phi_256_ = _e104;
    }
    let _e106 = phi_256_;
    let _e107 = (_e70 - _e58);
    let _e108 = (_e82 - _e58);
    let _e109 = (_e94 - _e58);
    let _e110 = (_e106 - _e58);
    let _e121 = ((((_e107 * param_6.x) + (_e108 * param_6.y)) + (_e109 * param_6.z)) + (_e110 * param_6.w));
    if ((bitcast<u32>(_e121) & 2147483647u) > 2139095040u) {
        phi_813_ = _e121;
        phi_814_ = f32();
        phi_815_ = true;
    } else {
        if (_e107 >= 0f) {
            if (_e108 >= 0f) {
                if (_e109 >= 0f) {
                    phi_291_ = (_e110 >= 0f);
                    phi_292_ = false;
                } else {
                    phi_291_ = bool();
                    phi_292_ = true;
                }
                let _e130 = phi_291_;
                let _e132 = phi_292_;
                phi_293_ = _e130;
                phi_294_ = _e132;
            } else {
                phi_293_ = bool();
                phi_294_ = true;
            }
            let _e134 = phi_293_;
            let _e136 = phi_294_;
            phi_295_ = _e134;
            phi_296_ = _e136;
        } else {
            phi_295_ = bool();
            phi_296_ = true;
        }
        let _e138 = phi_295_;
        let _e140 = phi_296_;
        if _e140 {
            phi_300_ = false;
        } else {
            phi_300_ = _e138;
        }
        let _e142 = phi_300_;
        if _e142 {
            phi_810_ = 1f;
            phi_811_ = f32();
            phi_812_ = true;
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
                    phi_613_ = _e107;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_612_ = 0f;
                    } else {
                        if (_e107 < 0f) {
                            phi_611_ = 0f;
                        } else {
                            phi_611_ = 1f;
                        }
                        let _e439 = phi_611_;
                        phi_612_ = _e439;
                    }
                    let _e441 = phi_612_;
                    phi_613_ = _e441;
                }
                let _e443 = phi_613_;
                if ((bitcast<u32>(_e108) & 2147483647u) > 2139095040u) {
                    phi_632_ = _e108;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_631_ = 0f;
                    } else {
                        if (_e108 < 0f) {
                            phi_630_ = 0f;
                        } else {
                            phi_630_ = 1f;
                        }
                        let _e452 = phi_630_;
                        phi_631_ = _e452;
                    }
                    let _e454 = phi_631_;
                    phi_632_ = _e454;
                }
                let _e456 = phi_632_;
                if ((bitcast<u32>(_e109) & 2147483647u) > 2139095040u) {
                    phi_651_ = _e109;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_650_ = 0f;
                    } else {
                        if (_e109 < 0f) {
                            phi_649_ = 0f;
                        } else {
                            phi_649_ = 1f;
                        }
                        let _e465 = phi_649_;
                        phi_650_ = _e465;
                    }
                    let _e467 = phi_650_;
                    phi_651_ = _e467;
                }
                let _e469 = phi_651_;
                if ((bitcast<u32>(_e110) & 2147483647u) > 2139095040u) {
                    phi_670_ = _e110;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_669_ = 0f;
                    } else {
                        if (_e110 < 0f) {
                            phi_668_ = 0f;
                        } else {
                            phi_668_ = 1f;
                        }
                        let _e478 = phi_668_;
                        phi_669_ = _e478;
                    }
                    let _e480 = phi_669_;
                    phi_670_ = _e480;
                }
                let _e482 = phi_670_;
                let _e490 = (((((_e443 * _e146) + (_e456 * _e148)) + (_e469 * _e150)) + (_e482 * _e152)) + _e143);
                if ((bitcast<u32>(_e490) & 2147483647u) > 2139095040u) {
                    phi_695_ = _e490;
                } else {
                    if (_e490 < 0f) {
                        phi_694_ = 0f;
                    } else {
                        if (_e490 > 1f) {
                            phi_693_ = 1f;
                        } else {
                            phi_693_ = _e490;
                        }
                        let _e497 = phi_693_;
                        phi_694_ = _e497;
                    }
                    let _e499 = phi_694_;
                    phi_695_ = _e499;
                }
                let _e501 = phi_695_;
                phi_808_ = _e501;
                phi_809_ = f32();
            } else {
                let _e503 = ((0.5f * -(((((((((_e207 * (_e107 + _e108)) + (_e211 * (_e107 + _e109))) + (_e235 * (_e107 + _e153))) + (_e247 * (_e107 + _e154))) + ((((_e208 * (_e108 + _e109)) + (_e212 * (_e108 + _e110))) + (_e236 * (_e108 + _e153))) + (_e248 * (_e108 + _e154)))) + ((((_e209 * (_e109 + _e110)) + (_e213 * (_e109 + _e107))) + (_e237 * (_e109 + _e153))) + (_e249 * (_e109 + _e154)))) + ((((_e210 * (_e110 + _e107)) + (_e214 * (_e110 + _e108))) + (_e238 * (_e110 + _e153))) + (_e250 * (_e110 + _e154)))) + (_e421 * (_e153 + _e154))))) / _e424);
                let _e504 = ((((((((_e207 + _e211) + _e235) + _e247) + (((_e208 + _e212) + _e236) + _e248)) + (((_e209 + _e213) + _e237) + _e249)) + (((_e210 + _e214) + _e238) + _e250)) + _e421) / _e424);
                let _e506 = ((_e503 * _e503) - _e504);
                if (_e506 > 0f) {
                    phi_706_ = sqrt(_e506);
                } else {
                    phi_706_ = 0f;
                }
                let _e510 = phi_706_;
                if (_e503 > 0f) {
                    let _e513 = (-(_e503) - _e510);
                    phi_723_ = lt_bvh_slab_Span(_e513, (_e504 / _e513));
                } else {
                    let _e516 = (_e510 - _e503);
                    if (_e516 > 0f) {
                        phi_721_ = (_e504 / _e516);
                    } else {
                        phi_721_ = 0f;
                    }
                    let _e520 = phi_721_;
                    phi_723_ = lt_bvh_slab_Span(_e520, _e516);
                }
                let _e523 = phi_723_;
                if (_e523.near >= 0f) {
                    phi_784_ = 1f;
                    phi_785_ = f32();
                    phi_786_ = true;
                } else {
                    let _e527 = (_e523.far <= 0f);
                    if _e527 {
                        phi_782_ = (_e418 / _e424);
                        phi_783_ = f32();
                    } else {
                        let _e538 = (((((_e146 * _e107) + (_e148 * _e108)) + (_e150 * _e109)) + (_e152 * _e110)) + (_e143 * (_e153 + _e154)));
                        let _e554 = (((((_e146 * (_e107 * _e107)) + (_e148 * (_e108 * _e108))) + (_e150 * (_e109 * _e109))) + (_e152 * (_e110 * _e110))) + (_e143 * ((_e153 * _e153) + (_e154 * _e154))));
                        if (-(_e523.near) <= _e523.far) {
                            phi_781_ = (1f - (((_e523.near * _e523.near) * ((_e523.far * _e554) - _e538)) / (_e523.far - _e523.near)));
                        } else {
                            phi_781_ = ((_e418 / _e424) + (((_e523.far * _e523.far) * (_e538 - (_e523.near * _e554))) / (_e523.far - _e523.near)));
                        }
                        let _e573 = phi_781_;
                        phi_782_ = f32();
                        phi_783_ = _e573;
                    }
                    let _e575 = phi_782_;
                    let _e577 = phi_783_;
                    phi_784_ = _e575;
                    phi_785_ = _e577;
                    phi_786_ = _e527;
                }
                let _e579 = phi_784_;
                let _e581 = phi_785_;
                let _e583 = phi_786_;
                if _e583 {
                    phi_790_ = _e579;
                } else {
                    phi_790_ = _e581;
                }
                let _e585 = phi_790_;
                if ((bitcast<u32>(_e585) & 2147483647u) > 2139095040u) {
                    phi_807_ = _e585;
                } else {
                    if (_e585 < 0f) {
                        phi_806_ = 0f;
                    } else {
                        if (_e585 > 1f) {
                            phi_805_ = 1f;
                        } else {
                            phi_805_ = _e585;
                        }
                        let _e592 = phi_805_;
                        phi_806_ = _e592;
                    }
                    let _e594 = phi_806_;
                    phi_807_ = _e594;
                }
                let _e596 = phi_807_;
                phi_808_ = f32();
                phi_809_ = _e596;
            }
            let _e598 = phi_808_;
            let _e600 = phi_809_;
            phi_810_ = _e598;
            phi_811_ = _e600;
            phi_812_ = _e430;
        }
        let _e602 = phi_810_;
        let _e604 = phi_811_;
        let _e606 = phi_812_;
        phi_813_ = _e602;
        phi_814_ = _e604;
        phi_815_ = _e606;
    }
    let _e608 = phi_813_;
    let _e610 = phi_814_;
    let _e612 = phi_815_;
    if _e612 {
        phi_819_ = _e608;
    } else {
        phi_819_ = _e610;
    }
    let _e614 = phi_819_;
    return _e614;
}

fn lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(param_8: f32, param_9: f32) -> f32 {
    var phi_827_: f32;

    if (param_8 < param_9) {
        phi_827_ = param_8;
    } else {
        phi_827_ = param_9;
    }
    let _e46 = phi_827_;
    return _e46;
}

fn function_() {
    var local: f32;
    var phi_888_: bool;
    var phi_889_: bool;
    var phi_890_: bool;
    var phi_891_: bool;
    var phi_895_: bool;
    var phi_939_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_943_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_963_: lt_math_LightPoint;
    var phi_966_: u32;
    var phi_968_: lt_math_LevelPoint;
    var phi_1054_: bool;
    var phi_1063_: bool;
    var phi_1072_: bool;
    var phi_1073_: bool;
    var phi_1074_: bool;
    var phi_1075_: bool;
    var phi_1076_: bool;
    var phi_1077_: bool;
    var phi_1078_: bool;
    var phi_1082_: bool;
    var phi_1109_: bool;
    var phi_1110_: bool;
    var phi_1111_: bool;
    var phi_1112_: bool;
    var phi_1113_: bool;
    var phi_1114_: bool;
    var phi_1115_: bool;
    var phi_1116_: bool;
    var phi_1120_: bool;
    var phi_1129_: lt_math_LightPoint;
    var phi_1130_: u32;
    var phi_1131_: lt_math_LevelPoint;
    var phi_1132_: bool;
    var phi_964_: lt_math_LightPoint;
    var phi_967_: u32;
    var phi_969_: lt_math_LevelPoint;
    var phi_1133_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_1173_: bool;
    var phi_1174_: bool;
    var phi_1175_: bool;
    var phi_1176_: bool;
    var phi_1180_: bool;
    var phi_1262_: f32;
    var phi_1378_: f32;
    var phi_1379_: f32;
    var phi_1382_: f32;
    var phi_1411_: f32;
    var phi_1416_: f32;
    var phi_1417_: bool;
    var phi_1418_: f32;
    var phi_1419_: bool;
    var phi_1423_: f32;
    var phi_1443_: f32;
    var phi_1448_: f32;
    var phi_1449_: bool;
    var phi_1450_: f32;
    var phi_1451_: bool;
    var phi_1455_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_1504_: i32;
    var phi_1509_: i32;
    var phi_1514_: i32;
    var phi_1519_: i32;
    var phi_1528_: i32;
    var phi_1533_: i32;
    var phi_1538_: i32;
    var phi_1543_: i32;
    var local_4: lt_math_LevelPoint;
    var phi_1615_: f32;
    var phi_1617_: evaluate_Verdict;
    var phi_1618_: bool;
    var phi_1619_: evaluate_Verdict;
    var phi_1620_: bool;
    var phi_1625_: evaluate_Verdict;
    var phi_1626_: bool;
    var phi_1628_: evaluate_Verdict;
    var phi_1629_: evaluate_Verdict;
    var phi_1630_: bool;
    var phi_1634_: evaluate_Verdict;
    var phi_1635_: evaluate_Verdict;
    var phi_1636_: bool;
    var phi_1640_: evaluate_Verdict;

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
        let _e73 = p.member.light;
        let _e76 = samples.member[(0u + _e62.first_primitive)].normal[0u];
        let _e78 = global[0u];
        if (_e76 == _e78) {
            let _e81 = samples.member[(0u + _e62.first_primitive)].normal[1u];
            let _e83 = global[1u];
            if (_e81 == _e83) {
                let _e86 = samples.member[(0u + _e62.first_primitive)].normal[2u];
                let _e88 = global[2u];
                phi_888_ = (_e86 == _e88);
                phi_889_ = false;
            } else {
                phi_888_ = bool();
                phi_889_ = true;
            }
            let _e91 = phi_888_;
            let _e93 = phi_889_;
            phi_890_ = _e91;
            phi_891_ = _e93;
        } else {
            phi_890_ = bool();
            phi_891_ = true;
        }
        let _e95 = phi_890_;
        let _e97 = phi_891_;
        if _e97 {
            phi_895_ = false;
        } else {
            phi_895_ = _e95;
        }
        let _e99 = phi_895_;
        if !(_e99) {
            let _e102 = samples.member[(0u + _e62.first_primitive)].normal;
            let _e104 = samples.member[(0u + _e62.first_primitive)].position;
            if ((((_e102.x * (_e73.x - (_e104.x * _e73.w))) + (_e102.y * (_e73.y - (_e104.y * _e73.w)))) + (_e102.z * (_e73.z - (_e104.z * _e73.w)))) > 0f) {
                let _e128 = samples.member[(0u + _e62.first_primitive)].flags;
                let _e136 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e142 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e136.unnamed.visibility, false), _e136.unnamed_1);
                phi_939_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e142.unnamed, ((_e128 & 1u) == 0u));
            } else {
                let _e151 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e157 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e151.unnamed.visibility, false), _e151.unnamed_1);
                phi_939_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e157.unnamed, true);
            }
            let _e162 = phi_939_;
            phi_943_ = _e162;
        } else {
            let _e168 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e174 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e168.unnamed.visibility, false), _e168.unnamed_1);
            phi_943_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e174.unnamed, true);
        }
        let _e179 = phi_943_;
        if _e179.unnamed_1 {
            phi_1634_ = evaluate_Verdict(_e179.unnamed.visibility, _e179.unnamed.is_doubted);
            phi_1635_ = evaluate_Verdict();
            phi_1636_ = true;
        } else {
            let _e187 = samples.member[(0u + _e62.first_primitive)].position;
            let _e189 = p.member.map_size;
            let _e191 = (0.5f / f32(_e189));
            let _e198 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e205 = lt_math_LightPoint(vec2<f32>(_e198.uv.x, 0f), _e198.depth, _e198.is_inside);
            let _e209 = lt_math_LightPoint(_e205.uv, 0f, _e205.is_inside);
            phi_963_ = lt_math_LightPoint();
            phi_966_ = 0u;
            phi_968_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e209.uv, _e209.depth, false));
            loop {
                let _e216 = phi_963_;
                let _e218 = phi_966_;
                let _e220 = phi_968_;
                local_1 = _e220;
                local_2 = _e220;
                local_3 = _e220;
                local_4 = _e220;
                if (_e218 < _e68) {
                    if _e220.point.is_inside {
                        phi_1129_ = lt_math_LightPoint();
                        phi_1130_ = u32();
                        phi_1131_ = lt_math_LevelPoint();
                        phi_1132_ = false;
                    } else {
                        if (_e218 < _e56) {
                        } else {
                            return;
                        }
                        let _e231 = levels.member[(0u + _e218)].row_w;
                        let _e242 = ((((_e231.x * _e187.x) + (_e231.y * _e187.y)) + (_e231.z * _e187.z)) + (_e231.w * 1f));
                        let _e244 = levels.member[(0u + _e218)].row_x;
                        let _e256 = (((((_e244.x * _e187.x) + (_e244.y * _e187.y)) + (_e244.z * _e187.z)) + (_e244.w * 1f)) / _e242);
                        let _e258 = levels.member[(0u + _e218)].row_y;
                        let _e270 = (((((_e258.x * _e187.x) + (_e258.y * _e187.y)) + (_e258.z * _e187.z)) + (_e258.w * 1f)) / _e242);
                        let _e272 = levels.member[(0u + _e218)].row_z;
                        let _e283 = ((((_e272.x * _e187.x) + (_e272.y * _e187.y)) + (_e272.z * _e187.z)) + (_e272.w * 1f));
                        if (_e242 > 0f) {
                            if (_e256 >= 0f) {
                                phi_1054_ = (_e256 <= 1f);
                            } else {
                                phi_1054_ = false;
                            }
                            let _e288 = phi_1054_;
                            if _e288 {
                                if (_e270 >= 0f) {
                                    phi_1063_ = (_e270 <= 1f);
                                } else {
                                    phi_1063_ = false;
                                }
                                let _e292 = phi_1063_;
                                if _e292 {
                                    if (_e283 >= 0f) {
                                        phi_1072_ = (_e283 <= 1f);
                                    } else {
                                        phi_1072_ = false;
                                    }
                                    let _e296 = phi_1072_;
                                    phi_1073_ = _e296;
                                    phi_1074_ = false;
                                } else {
                                    phi_1073_ = bool();
                                    phi_1074_ = true;
                                }
                                let _e298 = phi_1073_;
                                let _e300 = phi_1074_;
                                phi_1075_ = _e298;
                                phi_1076_ = _e300;
                            } else {
                                phi_1075_ = bool();
                                phi_1076_ = true;
                            }
                            let _e302 = phi_1075_;
                            let _e304 = phi_1076_;
                            phi_1077_ = _e302;
                            phi_1078_ = _e304;
                        } else {
                            phi_1077_ = bool();
                            phi_1078_ = true;
                        }
                        let _e306 = phi_1077_;
                        let _e308 = phi_1078_;
                        if _e308 {
                            phi_1082_ = false;
                        } else {
                            phi_1082_ = _e306;
                        }
                        let _e310 = phi_1082_;
                        if _e310 {
                            if (_e256 >= _e191) {
                                if (_e256 <= (1f - _e191)) {
                                    if (_e270 >= _e191) {
                                        phi_1109_ = (_e270 <= (1f - _e191));
                                        phi_1110_ = false;
                                    } else {
                                        phi_1109_ = bool();
                                        phi_1110_ = true;
                                    }
                                    let _e318 = phi_1109_;
                                    let _e320 = phi_1110_;
                                    phi_1111_ = _e318;
                                    phi_1112_ = _e320;
                                } else {
                                    phi_1111_ = bool();
                                    phi_1112_ = true;
                                }
                                let _e322 = phi_1111_;
                                let _e324 = phi_1112_;
                                phi_1113_ = _e322;
                                phi_1114_ = _e324;
                            } else {
                                phi_1113_ = bool();
                                phi_1114_ = true;
                            }
                            let _e326 = phi_1113_;
                            let _e328 = phi_1114_;
                            phi_1115_ = _e326;
                            phi_1116_ = _e328;
                        } else {
                            phi_1115_ = bool();
                            phi_1116_ = true;
                        }
                        let _e330 = phi_1115_;
                        let _e332 = phi_1116_;
                        if _e332 {
                            phi_1120_ = false;
                        } else {
                            phi_1120_ = _e330;
                        }
                        let _e334 = phi_1120_;
                        let _e341 = lt_math_LightPoint(vec2<f32>(_e256, _e216.uv.y), _e216.depth, _e216.is_inside);
                        let _e348 = lt_math_LightPoint(vec2<f32>(_e341.uv.x, _e270), _e341.depth, _e341.is_inside);
                        let _e352 = lt_math_LightPoint(_e348.uv, _e283, _e348.is_inside);
                        let _e356 = lt_math_LightPoint(_e352.uv, _e352.depth, _e334);
                        phi_1129_ = _e356;
                        phi_1130_ = (_e218 + 1u);
                        phi_1131_ = lt_math_LevelPoint(_e218, _e356);
                        phi_1132_ = true;
                    }
                    let _e360 = phi_1129_;
                    let _e362 = phi_1130_;
                    let _e364 = phi_1131_;
                    let _e366 = phi_1132_;
                    phi_964_ = _e360;
                    phi_967_ = _e362;
                    phi_969_ = _e364;
                    phi_1133_ = _e366;
                } else {
                    phi_964_ = lt_math_LightPoint();
                    phi_967_ = u32();
                    phi_969_ = lt_math_LevelPoint();
                    phi_1133_ = false;
                }
                let _e368 = phi_964_;
                let _e370 = phi_967_;
                let _e372 = phi_969_;
                let _e374 = phi_1133_;
                continue;
                continuing {
                    phi_963_ = _e368;
                    phi_966_ = _e370;
                    phi_968_ = _e372;
                    break if !(_e374);
                }
            }
            let _e377 = local_1;
            if _e377.point.is_inside {
                if (0f > 0f) {
                    let _e383 = local_2;
                    if (_e383.level < _e56) {
                    } else {
                        return;
                    }
                    let _e388 = levels.member[(0u + _e383.level)];
                    let _e394 = global[0u];
                    if (_e388.row_w.x == _e394) {
                        let _e397 = global[1u];
                        if (_e388.row_w.y == _e397) {
                            let _e400 = global[2u];
                            phi_1173_ = (_e388.row_w.z == _e400);
                            phi_1174_ = false;
                        } else {
                            phi_1173_ = bool();
                            phi_1174_ = true;
                        }
                        let _e403 = phi_1173_;
                        let _e405 = phi_1174_;
                        phi_1175_ = _e403;
                        phi_1176_ = _e405;
                    } else {
                        phi_1175_ = bool();
                        phi_1176_ = true;
                    }
                    let _e407 = phi_1175_;
                    let _e409 = phi_1176_;
                    if _e409 {
                        phi_1180_ = false;
                    } else {
                        phi_1180_ = _e407;
                    }
                    let _e411 = phi_1180_;
                    if _e411 {
                        let _e413 = samples.member[(0u + _e62.first_primitive)].normal;
                        let _e415 = p.member.map_size;
                        let _e485 = ((abs(((((_e388.row_x.x * _e413.x) + (_e388.row_x.y * _e413.y)) + (_e388.row_x.z * _e413.z)) / (((_e388.row_x.x * _e388.row_x.x) + (_e388.row_x.y * _e388.row_x.y)) + (_e388.row_x.z * _e388.row_x.z)))) + abs(((((_e388.row_y.x * _e413.x) + (_e388.row_y.y * _e413.y)) + (_e388.row_y.z * _e413.z)) / (((_e388.row_y.x * _e388.row_y.x) + (_e388.row_y.y * _e388.row_y.y)) + (_e388.row_y.z * _e388.row_y.z))))) / (abs(((((_e388.row_z.x * _e413.x) + (_e388.row_z.y * _e413.y)) + (_e388.row_z.z * _e413.z)) / (((_e388.row_z.x * _e388.row_z.x) + (_e388.row_z.y * _e388.row_z.y)) + (_e388.row_z.z * _e388.row_z.z)))) * f32(_e415)));
                        if (_e485 < 0.002f) {
                            phi_1262_ = _e485;
                        } else {
                            phi_1262_ = 0.002f;
                        }
                        let _e488 = phi_1262_;
                        phi_1379_ = _e488;
                    } else {
                        let _e490 = p.member.map_size;
                        let _e496 = samples.member[(0u + _e62.first_primitive)].position;
                        let _e507 = ((((_e388.row_w.x * _e496.x) + (_e388.row_w.y * _e496.y)) + (_e388.row_w.z * _e496.z)) + _e388.row_w.w);
                        let _e520 = ((_e388.row_x.x - (_e388.row_w.x * _e377.point.uv.x)) / _e507);
                        let _e521 = ((_e388.row_x.y - (_e388.row_w.y * _e377.point.uv.x)) / _e507);
                        let _e522 = ((_e388.row_x.z - (_e388.row_w.z * _e377.point.uv.x)) / _e507);
                        let _e535 = ((_e388.row_y.x - (_e388.row_w.x * _e377.point.uv.y)) / _e507);
                        let _e536 = ((_e388.row_y.y - (_e388.row_w.y * _e377.point.uv.y)) / _e507);
                        let _e537 = ((_e388.row_y.z - (_e388.row_w.z * _e377.point.uv.y)) / _e507);
                        let _e543 = samples.member[(0u + _e62.first_primitive)].normal;
                        let _e548 = ((_e536 * _e543.z) - (_e543.y * _e537));
                        let _e553 = ((_e537 * _e543.x) - (_e543.z * _e535));
                        let _e558 = ((_e535 * _e543.y) - (_e543.x * _e536));
                        let _e560 = samples.member[(0u + _e62.first_primitive)].normal;
                        let _e565 = ((_e521 * _e560.z) - (_e560.y * _e522));
                        let _e570 = ((_e522 * _e560.x) - (_e560.z * _e520));
                        let _e575 = ((_e520 * _e560.y) - (_e560.x * _e521));
                        let _e602 = ((abs(((((_e388.row_z.x * _e548) + (_e388.row_z.y * _e553)) + (_e388.row_z.z * _e558)) / (((_e520 * _e548) + (_e521 * _e553)) + (_e522 * _e558)))) + abs(((((_e388.row_z.x * _e565) + (_e388.row_z.y * _e570)) + (_e388.row_z.z * _e575)) / (((_e535 * _e565) + (_e536 * _e570)) + (_e537 * _e575))))) / f32(_e490));
                        if (_e602 < 0.002f) {
                            phi_1378_ = _e602;
                        } else {
                            phi_1378_ = 0.002f;
                        }
                        let _e605 = phi_1378_;
                        phi_1379_ = _e605;
                    }
                    let _e607 = phi_1379_;
                    phi_1382_ = (_e377.point.depth - (0f * _e607));
                } else {
                    phi_1382_ = _e377.point.depth;
                }
                let _e611 = phi_1382_;
                let _e617 = p.member.map_size;
                let _e618 = f32(_e617);
                let _e621 = ((_e377.point.uv.x * _e618) - 0.5f);
                let _e622 = ((_e377.point.uv.y * _e618) - 0.5f);
                if (_e621 > -8388608f) {
                    let _e634 = f32(select(0i, select(select(i32(_e621), i32(-2147483648), (_e621 < bitcast<f32>(3472883712u))), 2147483647i, (_e621 > bitcast<f32>(1325400063u))), (_e621 == _e621)));
                    if (_e634 > _e621) {
                        phi_1411_ = 1f;
                    } else {
                        phi_1411_ = 0f;
                    }
                    let _e637 = phi_1411_;
                    if (_e621 < 8388608f) {
                        phi_1416_ = (_e634 - _e637);
                        phi_1417_ = false;
                    } else {
                        phi_1416_ = f32();
                        phi_1417_ = true;
                    }
                    let _e640 = phi_1416_;
                    let _e642 = phi_1417_;
                    phi_1418_ = _e640;
                    phi_1419_ = _e642;
                } else {
                    phi_1418_ = f32();
                    phi_1419_ = true;
                }
                let _e644 = phi_1418_;
                let _e646 = phi_1419_;
                if _e646 {
                    phi_1423_ = _e621;
                } else {
                    phi_1423_ = _e644;
                }
                let _e648 = phi_1423_;
                if (_e622 > -8388608f) {
                    let _e660 = f32(select(0i, select(select(i32(_e622), i32(-2147483648), (_e622 < bitcast<f32>(3472883712u))), 2147483647i, (_e622 > bitcast<f32>(1325400063u))), (_e622 == _e622)));
                    if (_e660 > _e622) {
                        phi_1443_ = 1f;
                    } else {
                        phi_1443_ = 0f;
                    }
                    let _e663 = phi_1443_;
                    if (_e622 < 8388608f) {
                        phi_1448_ = (_e660 - _e663);
                        phi_1449_ = false;
                    } else {
                        phi_1448_ = f32();
                        phi_1449_ = true;
                    }
                    let _e666 = phi_1448_;
                    let _e668 = phi_1449_;
                    phi_1450_ = _e666;
                    phi_1451_ = _e668;
                } else {
                    phi_1450_ = f32();
                    phi_1451_ = true;
                }
                let _e670 = phi_1450_;
                let _e672 = phi_1451_;
                if _e672 {
                    phi_1455_ = _e622;
                } else {
                    phi_1455_ = _e670;
                }
                let _e674 = phi_1455_;
                let _e675 = (_e621 - _e648);
                let _e676 = (_e622 - _e674);
                let _e685 = select(0i, select(select(i32(_e648), i32(-2147483648), (_e648 < bitcast<f32>(3472883712u))), 2147483647i, (_e648 > bitcast<f32>(1325400063u))), (_e648 == _e648));
                let _e694 = select(0i, select(select(i32(_e674), i32(-2147483648), (_e674 < bitcast<f32>(3472883712u))), 2147483647i, (_e674 > bitcast<f32>(1325400063u))), (_e674 == _e674));
                let _e705 = p.member.test;
                let _e706 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e705);
                let _e708 = p.member.map_size;
                let _e710 = local_3;
                local = _e706;
                let _e713 = ((_e710.level * _e708) * _e708);
                let _e715 = (bitcast<i32>(_e708) - 1i);
                if (_e685 > 0i) {
                    phi_1504_ = _e685;
                } else {
                    phi_1504_ = 0i;
                }
                let _e718 = phi_1504_;
                if (_e694 > 0i) {
                    phi_1509_ = _e694;
                } else {
                    phi_1509_ = 0i;
                }
                let _e721 = phi_1509_;
                if (_e718 < _e715) {
                    phi_1514_ = _e718;
                } else {
                    phi_1514_ = _e715;
                }
                let _e724 = phi_1514_;
                if (_e721 < _e715) {
                    phi_1519_ = _e721;
                } else {
                    phi_1519_ = _e715;
                }
                let _e727 = phi_1519_;
                let _e728 = bitcast<u32>(_e724);
                let _e730 = (_e685 + 1i);
                let _e731 = (_e694 + 1i);
                if (_e730 > 0i) {
                    phi_1528_ = _e730;
                } else {
                    phi_1528_ = 0i;
                }
                let _e734 = phi_1528_;
                if (_e731 > 0i) {
                    phi_1533_ = _e731;
                } else {
                    phi_1533_ = 0i;
                }
                let _e737 = phi_1533_;
                if (_e734 < _e715) {
                    phi_1538_ = _e734;
                } else {
                    phi_1538_ = _e715;
                }
                let _e740 = phi_1538_;
                if (_e737 < _e715) {
                    phi_1543_ = _e737;
                } else {
                    phi_1543_ = _e715;
                }
                let _e743 = phi_1543_;
                let _e744 = bitcast<u32>(_e740);
                let _e746 = (bitcast<u32>(_e727) * _e708);
                let _e747 = (bitcast<u32>(_e743) * _e708);
                let _e752 = ((_e746 + _e728) + _e713);
                let _e753 = ((_e746 + _e744) + _e713);
                let _e754 = ((_e747 + _e728) + _e713);
                let _e755 = ((_e747 + _e744) + _e713);
                if (_e752 < _e50) {
                } else {
                    return;
                }
                let _e759 = map.member[(0u + _e752)];
                if (_e753 < _e50) {
                } else {
                    return;
                }
                let _e763 = map.member[(0u + _e753)];
                if (_e754 < _e50) {
                } else {
                    return;
                }
                let _e767 = map.member[(0u + _e754)];
                if (_e755 < _e50) {
                } else {
                    return;
                }
                let _e771 = map.member[(0u + _e755)];
                let _e773 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e759, _e763, _e767, _e771), vec4<f32>(((1f - _e675) * (1f - _e676)), (_e675 * (1f - _e676)), ((1f - _e675) * _e676), (_e675 * _e676)), _e611);
                let _e775 = p.member.fade_uv;
                if (_e775 > 0f) {
                    let _e778 = local_4;
                    if ((_e778.level + 1u) == _e68) {
                        let _e787 = p.member.fade_uv;
                        let _e789 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e377.point.uv.x, (1f - _e377.point.uv.x));
                        let _e791 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e377.point.uv.y, (1f - _e377.point.uv.y));
                        let _e792 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e789, _e791);
                        if (_e792 < _e787) {
                            phi_1615_ = (1f - ((1f - _e773) * (_e792 / _e787)));
                        } else {
                            phi_1615_ = _e773;
                        }
                        let _e799 = phi_1615_;
                        phi_1617_ = evaluate_Verdict(_e799, false);
                        phi_1618_ = false;
                    } else {
                        phi_1617_ = evaluate_Verdict();
                        phi_1618_ = true;
                    }
                    let _e802 = phi_1617_;
                    let _e804 = phi_1618_;
                    phi_1619_ = _e802;
                    phi_1620_ = _e804;
                } else {
                    phi_1619_ = evaluate_Verdict();
                    phi_1620_ = true;
                }
                let _e806 = phi_1619_;
                let _e808 = phi_1620_;
                if _e808 {
                    phi_1625_ = evaluate_Verdict(_e773, false);
                    phi_1626_ = false;
                } else {
                    phi_1625_ = evaluate_Verdict();
                    phi_1626_ = true;
                }
                let _e811 = phi_1625_;
                let _e813 = phi_1626_;
                phi_1628_ = _e811;
                phi_1629_ = _e806;
                phi_1630_ = _e813;
            } else {
                phi_1628_ = evaluate_Verdict();
                phi_1629_ = evaluate_Verdict(1f, false);
                phi_1630_ = true;
            }
            let _e816 = phi_1628_;
            let _e818 = phi_1629_;
            let _e820 = phi_1630_;
            if _e820 {
            }
            phi_1634_ = _e818;
            phi_1635_ = _e816;
            phi_1636_ = _e820;
        }
        let _e822 = phi_1634_;
        let _e824 = phi_1635_;
        let _e826 = phi_1636_;
        if _e826 {
            phi_1640_ = _e822;
        } else {
            phi_1640_ = _e824;
        }
        let _e828 = phi_1640_;
        if (_e62.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e62.first_primitive)] = _e828.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_msm_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
