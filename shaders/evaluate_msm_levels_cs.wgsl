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
    fade_uv: f32,
    pad0_: u32,
}

struct type_32 {
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
var<uniform> p: type_32;
@group(0) @binding(2) 
var<storage> map: type_13;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_13;
@group(0) @binding(4) 
var<storage> levels: type_37;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_149_: lt_bvh_traverse_Tree;
    var phi_150_: bool;
    var phi_151_: lt_bvh_traverse_Tree;
    var phi_152_: bool;
    var phi_157_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_149_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_150_ = false;
        } else {
            phi_149_ = lt_bvh_traverse_Tree();
            phi_150_ = true;
        }
        let _e55 = phi_149_;
        let _e57 = phi_150_;
        phi_151_ = _e55;
        phi_152_ = _e57;
    } else {
        phi_151_ = lt_bvh_traverse_Tree();
        phi_152_ = true;
    }
    let _e59 = phi_151_;
    let _e61 = phi_152_;
    if _e61 {
        phi_157_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_157_ = _e59;
    }
    let _e66 = phi_157_;
    return lt_bvh_traverse_Tree(_e66.root, _e66.first_primitive);
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_184_: f32;
    var phi_185_: f32;
    var phi_186_: f32;
    var phi_203_: f32;
    var phi_204_: f32;
    var phi_205_: f32;
    var phi_221_: f32;
    var phi_222_: f32;
    var phi_223_: f32;
    var phi_239_: f32;
    var phi_240_: f32;
    var phi_241_: f32;
    var phi_257_: f32;
    var phi_258_: f32;
    var phi_259_: f32;
    var phi_294_: bool;
    var phi_295_: bool;
    var phi_296_: bool;
    var phi_297_: bool;
    var phi_298_: bool;
    var phi_299_: bool;
    var phi_303_: bool;
    var phi_614_: f32;
    var phi_615_: f32;
    var phi_616_: f32;
    var phi_633_: f32;
    var phi_634_: f32;
    var phi_635_: f32;
    var phi_652_: f32;
    var phi_653_: f32;
    var phi_654_: f32;
    var phi_671_: f32;
    var phi_672_: f32;
    var phi_673_: f32;
    var phi_696_: f32;
    var phi_697_: f32;
    var phi_698_: f32;
    var phi_709_: f32;
    var phi_724_: f32;
    var phi_726_: lt_bvh_slab_Span;
    var phi_784_: f32;
    var phi_785_: f32;
    var phi_786_: f32;
    var phi_787_: f32;
    var phi_788_: f32;
    var phi_789_: bool;
    var phi_793_: f32;
    var phi_808_: f32;
    var phi_809_: f32;
    var phi_810_: f32;
    var phi_811_: f32;
    var phi_812_: f32;
    var phi_813_: f32;
    var phi_814_: f32;
    var phi_815_: bool;
    var phi_816_: f32;
    var phi_817_: f32;
    var phi_818_: bool;
    var phi_822_: f32;

    let _e46 = (*param_4);
    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_186_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_185_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_184_ = 1f;
            } else {
                phi_184_ = param_7;
            }
            let _e53 = phi_184_;
            phi_185_ = _e53;
        }
        let _e55 = phi_185_;
        phi_186_ = _e55;
    }
    let _e57 = phi_186_;
    let _e58 = (_e57 - 0.00000047683716f);
    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_205_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_204_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_203_ = 1f;
            } else {
                phi_203_ = param_5.x;
            }
            let _e66 = phi_203_;
            phi_204_ = _e66;
        }
        let _e68 = phi_204_;
        phi_205_ = _e68;
    }
    let _e70 = phi_205_;
    if ((bitcast<u32>(param_5.y) & 2147483647u) > 2139095040u) {
        phi_223_ = param_5.y;
    } else {
        if (param_5.y < 0f) {
            phi_222_ = 0f;
        } else {
            if (param_5.y > 1f) {
                phi_221_ = 1f;
            } else {
                phi_221_ = param_5.y;
            }
            let _e78 = phi_221_;
            phi_222_ = _e78;
        }
        let _e80 = phi_222_;
        phi_223_ = _e80;
    }
    let _e82 = phi_223_;
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_241_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_240_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_239_ = 1f;
            } else {
                phi_239_ = param_5.z;
            }
            let _e90 = phi_239_;
            phi_240_ = _e90;
        }
        let _e92 = phi_240_;
        phi_241_ = _e92;
    }
    let _e94 = phi_241_;
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_259_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_258_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_257_ = 1f;
            } else {
                phi_257_ = param_5.w;
            }
            let _e102 = phi_257_;
            phi_258_ = _e102;
        }
        let _e104 = phi_258_;
        phi_259_ = _e104;
    }
    let _e106 = phi_259_;
    let _e107 = (_e70 - _e58);
    let _e108 = (_e82 - _e58);
    let _e109 = (_e94 - _e58);
    let _e110 = (_e106 - _e58);
    let _e121 = ((((_e107 * param_6.x) + (_e108 * param_6.y)) + (_e109 * param_6.z)) + (_e110 * param_6.w));
    if ((bitcast<u32>(_e121) & 2147483647u) > 2139095040u) {
        phi_816_ = _e121;
        phi_817_ = f32();
        phi_818_ = true;
    } else {
        if (_e107 >= 0f) {
            if (_e108 >= 0f) {
                if (_e109 >= 0f) {
                    phi_294_ = (_e110 >= 0f);
                    phi_295_ = false;
                } else {
                    phi_294_ = bool();
                    phi_295_ = true;
                }
                let _e130 = phi_294_;
                let _e132 = phi_295_;
                phi_296_ = _e130;
                phi_297_ = _e132;
            } else {
                phi_296_ = bool();
                phi_297_ = true;
            }
            let _e134 = phi_296_;
            let _e136 = phi_297_;
            phi_298_ = _e134;
            phi_299_ = _e136;
        } else {
            phi_298_ = bool();
            phi_299_ = true;
        }
        let _e138 = phi_298_;
        let _e140 = phi_299_;
        if _e140 {
            phi_303_ = false;
        } else {
            phi_303_ = _e138;
        }
        let _e142 = phi_303_;
        if _e142 {
            phi_813_ = 1f;
            phi_814_ = f32();
            phi_815_ = true;
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
                    phi_616_ = _e107;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_615_ = 0f;
                    } else {
                        if (_e107 < 0f) {
                            phi_614_ = 0f;
                        } else {
                            phi_614_ = 1f;
                        }
                        let _e439 = phi_614_;
                        phi_615_ = _e439;
                    }
                    let _e441 = phi_615_;
                    phi_616_ = _e441;
                }
                let _e443 = phi_616_;
                if ((bitcast<u32>(_e108) & 2147483647u) > 2139095040u) {
                    phi_635_ = _e108;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_634_ = 0f;
                    } else {
                        if (_e108 < 0f) {
                            phi_633_ = 0f;
                        } else {
                            phi_633_ = 1f;
                        }
                        let _e452 = phi_633_;
                        phi_634_ = _e452;
                    }
                    let _e454 = phi_634_;
                    phi_635_ = _e454;
                }
                let _e456 = phi_635_;
                if ((bitcast<u32>(_e109) & 2147483647u) > 2139095040u) {
                    phi_654_ = _e109;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_653_ = 0f;
                    } else {
                        if (_e109 < 0f) {
                            phi_652_ = 0f;
                        } else {
                            phi_652_ = 1f;
                        }
                        let _e465 = phi_652_;
                        phi_653_ = _e465;
                    }
                    let _e467 = phi_653_;
                    phi_654_ = _e467;
                }
                let _e469 = phi_654_;
                if ((bitcast<u32>(_e110) & 2147483647u) > 2139095040u) {
                    phi_673_ = _e110;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_672_ = 0f;
                    } else {
                        if (_e110 < 0f) {
                            phi_671_ = 0f;
                        } else {
                            phi_671_ = 1f;
                        }
                        let _e478 = phi_671_;
                        phi_672_ = _e478;
                    }
                    let _e480 = phi_672_;
                    phi_673_ = _e480;
                }
                let _e482 = phi_673_;
                let _e490 = (((((_e443 * _e146) + (_e456 * _e148)) + (_e469 * _e150)) + (_e482 * _e152)) + _e143);
                if ((bitcast<u32>(_e490) & 2147483647u) > 2139095040u) {
                    phi_698_ = _e490;
                } else {
                    if (_e490 < 0f) {
                        phi_697_ = 0f;
                    } else {
                        if (_e490 > 1f) {
                            phi_696_ = 1f;
                        } else {
                            phi_696_ = _e490;
                        }
                        let _e497 = phi_696_;
                        phi_697_ = _e497;
                    }
                    let _e499 = phi_697_;
                    phi_698_ = _e499;
                }
                let _e501 = phi_698_;
                phi_811_ = _e501;
                phi_812_ = f32();
            } else {
                let _e503 = ((0.5f * -(((((((((_e207 * (_e107 + _e108)) + (_e211 * (_e107 + _e109))) + (_e235 * (_e107 + _e153))) + (_e247 * (_e107 + _e154))) + ((((_e208 * (_e108 + _e109)) + (_e212 * (_e108 + _e110))) + (_e236 * (_e108 + _e153))) + (_e248 * (_e108 + _e154)))) + ((((_e209 * (_e109 + _e110)) + (_e213 * (_e109 + _e107))) + (_e237 * (_e109 + _e153))) + (_e249 * (_e109 + _e154)))) + ((((_e210 * (_e110 + _e107)) + (_e214 * (_e110 + _e108))) + (_e238 * (_e110 + _e153))) + (_e250 * (_e110 + _e154)))) + (_e421 * (_e153 + _e154))))) / _e424);
                let _e504 = ((((((((_e207 + _e211) + _e235) + _e247) + (((_e208 + _e212) + _e236) + _e248)) + (((_e209 + _e213) + _e237) + _e249)) + (((_e210 + _e214) + _e238) + _e250)) + _e421) / _e424);
                let _e506 = ((_e503 * _e503) - _e504);
                if (_e506 > 0f) {
                    phi_709_ = sqrt(_e506);
                } else {
                    phi_709_ = 0f;
                }
                let _e510 = phi_709_;
                if (_e503 > 0f) {
                    let _e513 = (-(_e503) - _e510);
                    phi_726_ = lt_bvh_slab_Span(_e513, (_e504 / _e513));
                } else {
                    let _e516 = (_e510 - _e503);
                    if (_e516 > 0f) {
                        phi_724_ = (_e504 / _e516);
                    } else {
                        phi_724_ = 0f;
                    }
                    let _e520 = phi_724_;
                    phi_726_ = lt_bvh_slab_Span(_e520, _e516);
                }
                let _e523 = phi_726_;
                if (_e523.near >= 0f) {
                    phi_787_ = 1f;
                    phi_788_ = f32();
                    phi_789_ = true;
                } else {
                    let _e527 = (_e523.far <= 0f);
                    if _e527 {
                        phi_785_ = (_e418 / _e424);
                        phi_786_ = f32();
                    } else {
                        let _e538 = (((((_e146 * _e107) + (_e148 * _e108)) + (_e150 * _e109)) + (_e152 * _e110)) + (_e143 * (_e153 + _e154)));
                        let _e554 = (((((_e146 * (_e107 * _e107)) + (_e148 * (_e108 * _e108))) + (_e150 * (_e109 * _e109))) + (_e152 * (_e110 * _e110))) + (_e143 * ((_e153 * _e153) + (_e154 * _e154))));
                        if (-(_e523.near) <= _e523.far) {
                            phi_784_ = (1f - (((_e523.near * _e523.near) * ((_e523.far * _e554) - _e538)) / (_e523.far - _e523.near)));
                        } else {
                            phi_784_ = ((_e418 / _e424) + (((_e523.far * _e523.far) * (_e538 - (_e523.near * _e554))) / (_e523.far - _e523.near)));
                        }
                        let _e573 = phi_784_;
                        phi_785_ = f32();
                        phi_786_ = _e573;
                    }
                    let _e575 = phi_785_;
                    let _e577 = phi_786_;
                    phi_787_ = _e575;
                    phi_788_ = _e577;
                    phi_789_ = _e527;
                }
                let _e579 = phi_787_;
                let _e581 = phi_788_;
                let _e583 = phi_789_;
                if _e583 {
                    phi_793_ = _e579;
                } else {
                    phi_793_ = _e581;
                }
                let _e585 = phi_793_;
                if ((bitcast<u32>(_e585) & 2147483647u) > 2139095040u) {
                    phi_810_ = _e585;
                } else {
                    if (_e585 < 0f) {
                        phi_809_ = 0f;
                    } else {
                        if (_e585 > 1f) {
                            phi_808_ = 1f;
                        } else {
                            phi_808_ = _e585;
                        }
                        let _e592 = phi_808_;
                        phi_809_ = _e592;
                    }
                    let _e594 = phi_809_;
                    phi_810_ = _e594;
                }
                let _e596 = phi_810_;
                phi_811_ = f32();
                phi_812_ = _e596;
            }
            let _e598 = phi_811_;
            let _e600 = phi_812_;
            phi_813_ = _e598;
            phi_814_ = _e600;
            phi_815_ = _e430;
        }
        let _e602 = phi_813_;
        let _e604 = phi_814_;
        let _e606 = phi_815_;
        phi_816_ = _e602;
        phi_817_ = _e604;
        phi_818_ = _e606;
    }
    let _e608 = phi_816_;
    let _e610 = phi_817_;
    let _e612 = phi_818_;
    if _e612 {
        phi_822_ = _e608;
    } else {
        phi_822_ = _e610;
    }
    let _e614 = phi_822_;
    return _e614;
}

fn lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(param_8: f32, param_9: f32) -> f32 {
    var phi_830_: f32;

    if (param_8 < param_9) {
        phi_830_ = param_8;
    } else {
        phi_830_ = param_9;
    }
    let _e46 = phi_830_;
    return _e46;
}

fn function_() {
    var local: f32;
    var phi_890_: bool;
    var phi_891_: bool;
    var phi_892_: bool;
    var phi_893_: bool;
    var phi_897_: bool;
    var phi_967_: bool;
    var phi_968_: bool;
    var phi_979_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_980_: bool;
    var phi_981_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_982_: bool;
    var phi_989_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_993_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1013_: lt_math_LightPoint;
    var phi_1016_: u32;
    var phi_1018_: lt_math_LevelPoint;
    var phi_1104_: bool;
    var phi_1113_: bool;
    var phi_1122_: bool;
    var phi_1123_: bool;
    var phi_1124_: bool;
    var phi_1125_: bool;
    var phi_1126_: bool;
    var phi_1127_: bool;
    var phi_1128_: bool;
    var phi_1132_: bool;
    var phi_1159_: bool;
    var phi_1160_: bool;
    var phi_1161_: bool;
    var phi_1162_: bool;
    var phi_1163_: bool;
    var phi_1164_: bool;
    var phi_1165_: bool;
    var phi_1166_: bool;
    var phi_1170_: bool;
    var phi_1179_: lt_math_LightPoint;
    var phi_1180_: u32;
    var phi_1181_: lt_math_LevelPoint;
    var phi_1182_: bool;
    var phi_1014_: lt_math_LightPoint;
    var phi_1017_: u32;
    var phi_1019_: lt_math_LevelPoint;
    var phi_1183_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_1223_: bool;
    var phi_1224_: bool;
    var phi_1225_: bool;
    var phi_1226_: bool;
    var phi_1230_: bool;
    var phi_1312_: f32;
    var phi_1428_: f32;
    var phi_1429_: f32;
    var phi_1432_: f32;
    var phi_1461_: f32;
    var phi_1466_: f32;
    var phi_1467_: bool;
    var phi_1468_: f32;
    var phi_1469_: bool;
    var phi_1473_: f32;
    var phi_1493_: f32;
    var phi_1498_: f32;
    var phi_1499_: bool;
    var phi_1500_: f32;
    var phi_1501_: bool;
    var phi_1505_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_1554_: i32;
    var phi_1559_: i32;
    var phi_1564_: i32;
    var phi_1569_: i32;
    var phi_1578_: i32;
    var phi_1583_: i32;
    var phi_1588_: i32;
    var phi_1593_: i32;
    var local_4: lt_math_LevelPoint;
    var phi_1665_: f32;
    var phi_1667_: evaluate_Verdict;
    var phi_1668_: bool;
    var phi_1669_: evaluate_Verdict;
    var phi_1670_: bool;
    var phi_1675_: evaluate_Verdict;
    var phi_1676_: bool;
    var phi_1678_: evaluate_Verdict;
    var phi_1679_: evaluate_Verdict;
    var phi_1680_: bool;
    var phi_1684_: evaluate_Verdict;
    var phi_1685_: evaluate_Verdict;
    var phi_1686_: bool;
    var phi_1690_: evaluate_Verdict;

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
                phi_890_ = (_e85 == _e87);
                phi_891_ = false;
            } else {
                phi_890_ = bool();
                phi_891_ = true;
            }
            let _e90 = phi_890_;
            let _e92 = phi_891_;
            phi_892_ = _e90;
            phi_893_ = _e92;
        } else {
            phi_892_ = bool();
            phi_893_ = true;
        }
        let _e94 = phi_892_;
        let _e96 = phi_893_;
        if _e96 {
            phi_897_ = false;
        } else {
            phi_897_ = _e94;
        }
        let _e98 = phi_897_;
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
                    phi_968_ = true;
                } else {
                    let _e151 = p.member.light.range_squared;
                    if (_e134 <= _e151) {
                        let _e154 = p.member.light.cos_outer;
                        phi_967_ = (-((((_e116 * _e136.x) + (_e117 * _e136.y)) + (_e118 * _e136.z))) >= (_e154 * sqrt(_e134)));
                    } else {
                        phi_967_ = false;
                    }
                    let _e159 = phi_967_;
                    phi_968_ = _e159;
                }
                let _e161 = phi_968_;
                if _e161 {
                    let _e163 = samples.member[(0u + _e62.first_primitive)].flags;
                    let _e171 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e177 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e171.unnamed.visibility, false), _e171.unnamed_1);
                    phi_979_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e177.unnamed, ((_e163 & 1u) == 0u));
                    phi_980_ = false;
                } else {
                    phi_979_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_980_ = true;
                }
                let _e182 = phi_979_;
                let _e184 = phi_980_;
                phi_981_ = _e182;
                phi_982_ = _e184;
            } else {
                phi_981_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_982_ = true;
            }
            let _e186 = phi_981_;
            let _e188 = phi_982_;
            if _e188 {
                let _e194 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e200 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e194.unnamed.visibility, false), _e194.unnamed_1);
                phi_989_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e200.unnamed, true);
            } else {
                phi_989_ = _e186;
            }
            let _e205 = phi_989_;
            phi_993_ = _e205;
        } else {
            let _e211 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e217 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e211.unnamed.visibility, false), _e211.unnamed_1);
            phi_993_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e217.unnamed, true);
        }
        let _e222 = phi_993_;
        if _e222.unnamed_1 {
            phi_1684_ = evaluate_Verdict(_e222.unnamed.visibility, _e222.unnamed.is_doubted);
            phi_1685_ = evaluate_Verdict();
            phi_1686_ = true;
        } else {
            let _e230 = samples.member[(0u + _e62.first_primitive)].position;
            let _e232 = p.member.map_size;
            let _e234 = (0.5f / f32(_e232));
            let _e241 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e248 = lt_math_LightPoint(vec2<f32>(_e241.uv.x, 0f), _e241.depth, _e241.is_inside);
            let _e252 = lt_math_LightPoint(_e248.uv, 0f, _e248.is_inside);
            phi_1013_ = lt_math_LightPoint();
            phi_1016_ = 0u;
            phi_1018_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e252.uv, _e252.depth, false));
            loop {
                let _e259 = phi_1013_;
                let _e261 = phi_1016_;
                let _e263 = phi_1018_;
                local_1 = _e263;
                local_2 = _e263;
                local_3 = _e263;
                local_4 = _e263;
                if (_e261 < _e68) {
                    if _e263.point.is_inside {
                        phi_1179_ = lt_math_LightPoint();
                        phi_1180_ = u32();
                        phi_1181_ = lt_math_LevelPoint();
                        phi_1182_ = false;
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
                                phi_1104_ = (_e299 <= 1f);
                            } else {
                                phi_1104_ = false;
                            }
                            let _e331 = phi_1104_;
                            if _e331 {
                                if (_e313 >= 0f) {
                                    phi_1113_ = (_e313 <= 1f);
                                } else {
                                    phi_1113_ = false;
                                }
                                let _e335 = phi_1113_;
                                if _e335 {
                                    if (_e326 >= 0f) {
                                        phi_1122_ = (_e326 <= 1f);
                                    } else {
                                        phi_1122_ = false;
                                    }
                                    let _e339 = phi_1122_;
                                    phi_1123_ = _e339;
                                    phi_1124_ = false;
                                } else {
                                    phi_1123_ = bool();
                                    phi_1124_ = true;
                                }
                                let _e341 = phi_1123_;
                                let _e343 = phi_1124_;
                                phi_1125_ = _e341;
                                phi_1126_ = _e343;
                            } else {
                                phi_1125_ = bool();
                                phi_1126_ = true;
                            }
                            let _e345 = phi_1125_;
                            let _e347 = phi_1126_;
                            phi_1127_ = _e345;
                            phi_1128_ = _e347;
                        } else {
                            phi_1127_ = bool();
                            phi_1128_ = true;
                        }
                        let _e349 = phi_1127_;
                        let _e351 = phi_1128_;
                        if _e351 {
                            phi_1132_ = false;
                        } else {
                            phi_1132_ = _e349;
                        }
                        let _e353 = phi_1132_;
                        if _e353 {
                            if (_e299 >= _e234) {
                                if (_e299 <= (1f - _e234)) {
                                    if (_e313 >= _e234) {
                                        phi_1159_ = (_e313 <= (1f - _e234));
                                        phi_1160_ = false;
                                    } else {
                                        phi_1159_ = bool();
                                        phi_1160_ = true;
                                    }
                                    let _e361 = phi_1159_;
                                    let _e363 = phi_1160_;
                                    phi_1161_ = _e361;
                                    phi_1162_ = _e363;
                                } else {
                                    phi_1161_ = bool();
                                    phi_1162_ = true;
                                }
                                let _e365 = phi_1161_;
                                let _e367 = phi_1162_;
                                phi_1163_ = _e365;
                                phi_1164_ = _e367;
                            } else {
                                phi_1163_ = bool();
                                phi_1164_ = true;
                            }
                            let _e369 = phi_1163_;
                            let _e371 = phi_1164_;
                            phi_1165_ = _e369;
                            phi_1166_ = _e371;
                        } else {
                            phi_1165_ = bool();
                            phi_1166_ = true;
                        }
                        let _e373 = phi_1165_;
                        let _e375 = phi_1166_;
                        if _e375 {
                            phi_1170_ = false;
                        } else {
                            phi_1170_ = _e373;
                        }
                        let _e377 = phi_1170_;
                        let _e384 = lt_math_LightPoint(vec2<f32>(_e299, _e259.uv.y), _e259.depth, _e259.is_inside);
                        let _e391 = lt_math_LightPoint(vec2<f32>(_e384.uv.x, _e313), _e384.depth, _e384.is_inside);
                        let _e395 = lt_math_LightPoint(_e391.uv, _e326, _e391.is_inside);
                        let _e399 = lt_math_LightPoint(_e395.uv, _e395.depth, _e377);
                        phi_1179_ = _e399;
                        phi_1180_ = (_e261 + 1u);
                        phi_1181_ = lt_math_LevelPoint(_e261, _e399);
                        phi_1182_ = true;
                    }
                    let _e403 = phi_1179_;
                    let _e405 = phi_1180_;
                    let _e407 = phi_1181_;
                    let _e409 = phi_1182_;
                    phi_1014_ = _e403;
                    phi_1017_ = _e405;
                    phi_1019_ = _e407;
                    phi_1183_ = _e409;
                } else {
                    phi_1014_ = lt_math_LightPoint();
                    phi_1017_ = u32();
                    phi_1019_ = lt_math_LevelPoint();
                    phi_1183_ = false;
                }
                let _e411 = phi_1014_;
                let _e413 = phi_1017_;
                let _e415 = phi_1019_;
                let _e417 = phi_1183_;
                continue;
                continuing {
                    phi_1013_ = _e411;
                    phi_1016_ = _e413;
                    phi_1018_ = _e415;
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
                            phi_1223_ = (_e431.row_w.z == _e443);
                            phi_1224_ = false;
                        } else {
                            phi_1223_ = bool();
                            phi_1224_ = true;
                        }
                        let _e446 = phi_1223_;
                        let _e448 = phi_1224_;
                        phi_1225_ = _e446;
                        phi_1226_ = _e448;
                    } else {
                        phi_1225_ = bool();
                        phi_1226_ = true;
                    }
                    let _e450 = phi_1225_;
                    let _e452 = phi_1226_;
                    if _e452 {
                        phi_1230_ = false;
                    } else {
                        phi_1230_ = _e450;
                    }
                    let _e454 = phi_1230_;
                    if _e454 {
                        let _e456 = samples.member[(0u + _e62.first_primitive)].normal;
                        let _e458 = p.member.map_size;
                        let _e528 = ((abs(((((_e431.row_x.x * _e456.x) + (_e431.row_x.y * _e456.y)) + (_e431.row_x.z * _e456.z)) / (((_e431.row_x.x * _e431.row_x.x) + (_e431.row_x.y * _e431.row_x.y)) + (_e431.row_x.z * _e431.row_x.z)))) + abs(((((_e431.row_y.x * _e456.x) + (_e431.row_y.y * _e456.y)) + (_e431.row_y.z * _e456.z)) / (((_e431.row_y.x * _e431.row_y.x) + (_e431.row_y.y * _e431.row_y.y)) + (_e431.row_y.z * _e431.row_y.z))))) / (abs(((((_e431.row_z.x * _e456.x) + (_e431.row_z.y * _e456.y)) + (_e431.row_z.z * _e456.z)) / (((_e431.row_z.x * _e431.row_z.x) + (_e431.row_z.y * _e431.row_z.y)) + (_e431.row_z.z * _e431.row_z.z)))) * f32(_e458)));
                        if (_e528 < 0.002f) {
                            phi_1312_ = _e528;
                        } else {
                            phi_1312_ = 0.002f;
                        }
                        let _e531 = phi_1312_;
                        phi_1429_ = _e531;
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
                        if (_e645 < 0.002f) {
                            phi_1428_ = _e645;
                        } else {
                            phi_1428_ = 0.002f;
                        }
                        let _e648 = phi_1428_;
                        phi_1429_ = _e648;
                    }
                    let _e650 = phi_1429_;
                    phi_1432_ = (_e420.point.depth - (0f * _e650));
                } else {
                    phi_1432_ = _e420.point.depth;
                }
                let _e654 = phi_1432_;
                let _e660 = p.member.map_size;
                let _e661 = f32(_e660);
                let _e664 = ((_e420.point.uv.x * _e661) - 0.5f);
                let _e665 = ((_e420.point.uv.y * _e661) - 0.5f);
                if (_e664 > -8388608f) {
                    let _e677 = f32(select(0i, select(select(i32(_e664), i32(-2147483648), (_e664 < bitcast<f32>(3472883712u))), 2147483647i, (_e664 > bitcast<f32>(1325400063u))), (_e664 == _e664)));
                    if (_e677 > _e664) {
                        phi_1461_ = 1f;
                    } else {
                        phi_1461_ = 0f;
                    }
                    let _e680 = phi_1461_;
                    if (_e664 < 8388608f) {
                        phi_1466_ = (_e677 - _e680);
                        phi_1467_ = false;
                    } else {
                        phi_1466_ = f32();
                        phi_1467_ = true;
                    }
                    let _e683 = phi_1466_;
                    let _e685 = phi_1467_;
                    phi_1468_ = _e683;
                    phi_1469_ = _e685;
                } else {
                    phi_1468_ = f32();
                    phi_1469_ = true;
                }
                let _e687 = phi_1468_;
                let _e689 = phi_1469_;
                if _e689 {
                    phi_1473_ = _e664;
                } else {
                    phi_1473_ = _e687;
                }
                let _e691 = phi_1473_;
                if (_e665 > -8388608f) {
                    let _e703 = f32(select(0i, select(select(i32(_e665), i32(-2147483648), (_e665 < bitcast<f32>(3472883712u))), 2147483647i, (_e665 > bitcast<f32>(1325400063u))), (_e665 == _e665)));
                    if (_e703 > _e665) {
                        phi_1493_ = 1f;
                    } else {
                        phi_1493_ = 0f;
                    }
                    let _e706 = phi_1493_;
                    if (_e665 < 8388608f) {
                        phi_1498_ = (_e703 - _e706);
                        phi_1499_ = false;
                    } else {
                        phi_1498_ = f32();
                        phi_1499_ = true;
                    }
                    let _e709 = phi_1498_;
                    let _e711 = phi_1499_;
                    phi_1500_ = _e709;
                    phi_1501_ = _e711;
                } else {
                    phi_1500_ = f32();
                    phi_1501_ = true;
                }
                let _e713 = phi_1500_;
                let _e715 = phi_1501_;
                if _e715 {
                    phi_1505_ = _e665;
                } else {
                    phi_1505_ = _e713;
                }
                let _e717 = phi_1505_;
                let _e718 = (_e664 - _e691);
                let _e719 = (_e665 - _e717);
                let _e728 = select(0i, select(select(i32(_e691), i32(-2147483648), (_e691 < bitcast<f32>(3472883712u))), 2147483647i, (_e691 > bitcast<f32>(1325400063u))), (_e691 == _e691));
                let _e737 = select(0i, select(select(i32(_e717), i32(-2147483648), (_e717 < bitcast<f32>(3472883712u))), 2147483647i, (_e717 > bitcast<f32>(1325400063u))), (_e717 == _e717));
                let _e748 = p.member.test;
                let _e749 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e748);
                let _e751 = p.member.map_size;
                let _e753 = local_3;
                local = _e749;
                let _e756 = ((_e753.level * _e751) * _e751);
                let _e758 = (bitcast<i32>(_e751) - 1i);
                if (_e728 > 0i) {
                    phi_1554_ = _e728;
                } else {
                    phi_1554_ = 0i;
                }
                let _e761 = phi_1554_;
                if (_e737 > 0i) {
                    phi_1559_ = _e737;
                } else {
                    phi_1559_ = 0i;
                }
                let _e764 = phi_1559_;
                if (_e761 < _e758) {
                    phi_1564_ = _e761;
                } else {
                    phi_1564_ = _e758;
                }
                let _e767 = phi_1564_;
                if (_e764 < _e758) {
                    phi_1569_ = _e764;
                } else {
                    phi_1569_ = _e758;
                }
                let _e770 = phi_1569_;
                let _e771 = bitcast<u32>(_e767);
                let _e773 = (_e728 + 1i);
                let _e774 = (_e737 + 1i);
                if (_e773 > 0i) {
                    phi_1578_ = _e773;
                } else {
                    phi_1578_ = 0i;
                }
                let _e777 = phi_1578_;
                if (_e774 > 0i) {
                    phi_1583_ = _e774;
                } else {
                    phi_1583_ = 0i;
                }
                let _e780 = phi_1583_;
                if (_e777 < _e758) {
                    phi_1588_ = _e777;
                } else {
                    phi_1588_ = _e758;
                }
                let _e783 = phi_1588_;
                if (_e780 < _e758) {
                    phi_1593_ = _e780;
                } else {
                    phi_1593_ = _e758;
                }
                let _e786 = phi_1593_;
                let _e787 = bitcast<u32>(_e783);
                let _e789 = (bitcast<u32>(_e770) * _e751);
                let _e790 = (bitcast<u32>(_e786) * _e751);
                let _e795 = ((_e789 + _e771) + _e756);
                let _e796 = ((_e789 + _e787) + _e756);
                let _e797 = ((_e790 + _e771) + _e756);
                let _e798 = ((_e790 + _e787) + _e756);
                if (_e795 < _e50) {
                } else {
                    return;
                }
                let _e802 = map.member[(0u + _e795)];
                if (_e796 < _e50) {
                } else {
                    return;
                }
                let _e806 = map.member[(0u + _e796)];
                if (_e797 < _e50) {
                } else {
                    return;
                }
                let _e810 = map.member[(0u + _e797)];
                if (_e798 < _e50) {
                } else {
                    return;
                }
                let _e814 = map.member[(0u + _e798)];
                let _e816 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e802, _e806, _e810, _e814), vec4<f32>(((1f - _e718) * (1f - _e719)), (_e718 * (1f - _e719)), ((1f - _e718) * _e719), (_e718 * _e719)), _e654);
                let _e818 = p.member.fade_uv;
                if (_e818 > 0f) {
                    let _e821 = local_4;
                    if ((_e821.level + 1u) == _e68) {
                        let _e830 = p.member.fade_uv;
                        let _e832 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e420.point.uv.x, (1f - _e420.point.uv.x));
                        let _e834 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e420.point.uv.y, (1f - _e420.point.uv.y));
                        let _e835 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e832, _e834);
                        if (_e835 < _e830) {
                            phi_1665_ = (1f - ((1f - _e816) * (_e835 / _e830)));
                        } else {
                            phi_1665_ = _e816;
                        }
                        let _e842 = phi_1665_;
                        phi_1667_ = evaluate_Verdict(_e842, false);
                        phi_1668_ = false;
                    } else {
                        phi_1667_ = evaluate_Verdict();
                        phi_1668_ = true;
                    }
                    let _e845 = phi_1667_;
                    let _e847 = phi_1668_;
                    phi_1669_ = _e845;
                    phi_1670_ = _e847;
                } else {
                    phi_1669_ = evaluate_Verdict();
                    phi_1670_ = true;
                }
                let _e849 = phi_1669_;
                let _e851 = phi_1670_;
                if _e851 {
                    phi_1675_ = evaluate_Verdict(_e816, false);
                    phi_1676_ = false;
                } else {
                    phi_1675_ = evaluate_Verdict();
                    phi_1676_ = true;
                }
                let _e854 = phi_1675_;
                let _e856 = phi_1676_;
                phi_1678_ = _e854;
                phi_1679_ = _e849;
                phi_1680_ = _e856;
            } else {
                phi_1678_ = evaluate_Verdict();
                phi_1679_ = evaluate_Verdict(1f, false);
                phi_1680_ = true;
            }
            let _e859 = phi_1678_;
            let _e861 = phi_1679_;
            let _e863 = phi_1680_;
            if _e863 {
            }
            phi_1684_ = _e861;
            phi_1685_ = _e859;
            phi_1686_ = _e863;
        }
        let _e865 = phi_1684_;
        let _e867 = phi_1685_;
        let _e869 = phi_1686_;
        if _e869 {
            phi_1690_ = _e865;
        } else {
            phi_1690_ = _e867;
        }
        let _e871 = phi_1690_;
        if (_e62.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e62.first_primitive)] = _e871.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_msm_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
