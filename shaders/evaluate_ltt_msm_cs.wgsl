struct abi_LightParams {
    place: vec4<f32>,
    axis: vec3<f32>,
    cos_outer: f32,
    range_squared: f32,
    cos_inner: f32,
    number: u32,
    mask_words: u32,
}

struct type_9 {
    member: array<u32>,
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

struct type_20 {
    member: array<abi_Sample>,
}

struct type_24 {
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

struct type_38 {
    member: abi_ShadowParams,
}

struct lt_math_OneLevel {
    projection: lt_math_LightProjection,
}

struct lt_bvh_slab_Span {
    near: f32,
    far: f32,
}

struct type_45 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
var<private> local_2: u32;
@group(0) @binding(1) 
var<storage> samples: type_20;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(0) 
var<uniform> p: type_38;
@group(0) @binding(2) 
var<storage> map: type_24;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_24;
@group(0) @binding(4) 
var<storage, read_write> list: type_45;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_150_: lt_bvh_traverse_Tree;
    var phi_151_: bool;
    var phi_152_: lt_bvh_traverse_Tree;
    var phi_153_: bool;
    var phi_158_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_150_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_151_ = false;
        } else {
            phi_150_ = lt_bvh_traverse_Tree();
            phi_151_ = true;
        }
        let _e53 = phi_150_;
        let _e55 = phi_151_;
        phi_152_ = _e53;
        phi_153_ = _e55;
    } else {
        phi_152_ = lt_bvh_traverse_Tree();
        phi_153_ = true;
    }
    let _e57 = phi_152_;
    let _e59 = phi_153_;
    if _e59 {
        phi_158_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_158_ = _e57;
    }
    let _e64 = phi_158_;
    return lt_bvh_traverse_Tree(_e64.root, _e64.first_primitive);
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_185_: f32;
    var phi_186_: f32;
    var phi_187_: f32;
    var phi_204_: f32;
    var phi_205_: f32;
    var phi_206_: f32;
    var phi_222_: f32;
    var phi_223_: f32;
    var phi_224_: f32;
    var phi_240_: f32;
    var phi_241_: f32;
    var phi_242_: f32;
    var phi_258_: f32;
    var phi_259_: f32;
    var phi_260_: f32;
    var phi_295_: bool;
    var phi_296_: bool;
    var phi_297_: bool;
    var phi_298_: bool;
    var phi_299_: bool;
    var phi_300_: bool;
    var phi_304_: bool;
    var phi_615_: f32;
    var phi_616_: f32;
    var phi_617_: f32;
    var phi_634_: f32;
    var phi_635_: f32;
    var phi_636_: f32;
    var phi_653_: f32;
    var phi_654_: f32;
    var phi_655_: f32;
    var phi_672_: f32;
    var phi_673_: f32;
    var phi_674_: f32;
    var phi_697_: f32;
    var phi_698_: f32;
    var phi_699_: f32;
    var phi_710_: f32;
    var phi_725_: f32;
    var phi_727_: lt_bvh_slab_Span;
    var phi_785_: f32;
    var phi_786_: f32;
    var phi_787_: f32;
    var phi_788_: f32;
    var phi_789_: f32;
    var phi_790_: bool;
    var phi_794_: f32;
    var phi_809_: f32;
    var phi_810_: f32;
    var phi_811_: f32;
    var phi_812_: f32;
    var phi_813_: f32;
    var phi_814_: f32;
    var phi_815_: f32;
    var phi_816_: bool;
    var phi_817_: f32;
    var phi_818_: f32;
    var phi_819_: bool;
    var phi_823_: f32;

    let _e44 = (*param_4);
    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_187_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_186_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_185_ = 1f;
            } else {
                phi_185_ = param_7;
            }
            let _e51 = phi_185_;
            phi_186_ = _e51;
        }
        let _e53 = phi_186_;
        phi_187_ = _e53;
    }
    let _e55 = phi_187_;
    let _e56 = (_e55 - 0.00000047683716f);
    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_206_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_205_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_204_ = 1f;
            } else {
                phi_204_ = param_5.x;
            }
            let _e64 = phi_204_;
            phi_205_ = _e64;
        }
        let _e66 = phi_205_;
        phi_206_ = _e66;
    }
    let _e68 = phi_206_;
    if ((bitcast<u32>(param_5.y) & 2147483647u) > 2139095040u) {
        phi_224_ = param_5.y;
    } else {
        if (param_5.y < 0f) {
            phi_223_ = 0f;
        } else {
            if (param_5.y > 1f) {
                phi_222_ = 1f;
            } else {
                phi_222_ = param_5.y;
            }
            let _e76 = phi_222_;
            phi_223_ = _e76;
        }
        let _e78 = phi_223_;
        phi_224_ = _e78;
    }
    let _e80 = phi_224_;
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_242_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_241_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_240_ = 1f;
            } else {
                phi_240_ = param_5.z;
            }
            let _e88 = phi_240_;
            phi_241_ = _e88;
        }
        let _e90 = phi_241_;
        phi_242_ = _e90;
    }
    let _e92 = phi_242_;
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_260_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_259_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_258_ = 1f;
            } else {
                phi_258_ = param_5.w;
            }
            let _e100 = phi_258_;
            phi_259_ = _e100;
        }
        let _e102 = phi_259_;
        phi_260_ = _e102;
    }
    let _e104 = phi_260_;
    let _e105 = (_e68 - _e56);
    let _e106 = (_e80 - _e56);
    let _e107 = (_e92 - _e56);
    let _e108 = (_e104 - _e56);
    let _e119 = ((((_e105 * param_6.x) + (_e106 * param_6.y)) + (_e107 * param_6.z)) + (_e108 * param_6.w));
    if ((bitcast<u32>(_e119) & 2147483647u) > 2139095040u) {
        phi_817_ = _e119;
        phi_818_ = f32();
        phi_819_ = true;
    } else {
        if (_e105 >= 0f) {
            if (_e106 >= 0f) {
                if (_e107 >= 0f) {
                    phi_295_ = (_e108 >= 0f);
                    phi_296_ = false;
                } else {
                    phi_295_ = bool();
                    phi_296_ = true;
                }
                let _e128 = phi_295_;
                let _e130 = phi_296_;
                phi_297_ = _e128;
                phi_298_ = _e130;
            } else {
                phi_297_ = bool();
                phi_298_ = true;
            }
            let _e132 = phi_297_;
            let _e134 = phi_298_;
            phi_299_ = _e132;
            phi_300_ = _e134;
        } else {
            phi_299_ = bool();
            phi_300_ = true;
        }
        let _e136 = phi_299_;
        let _e138 = phi_300_;
        if _e138 {
            phi_304_ = false;
        } else {
            phi_304_ = _e136;
        }
        let _e140 = phi_304_;
        if _e140 {
            phi_814_ = 1f;
            phi_815_ = f32();
            phi_816_ = true;
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
                    phi_617_ = _e105;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_616_ = 0f;
                    } else {
                        if (_e105 < 0f) {
                            phi_615_ = 0f;
                        } else {
                            phi_615_ = 1f;
                        }
                        let _e437 = phi_615_;
                        phi_616_ = _e437;
                    }
                    let _e439 = phi_616_;
                    phi_617_ = _e439;
                }
                let _e441 = phi_617_;
                if ((bitcast<u32>(_e106) & 2147483647u) > 2139095040u) {
                    phi_636_ = _e106;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_635_ = 0f;
                    } else {
                        if (_e106 < 0f) {
                            phi_634_ = 0f;
                        } else {
                            phi_634_ = 1f;
                        }
                        let _e450 = phi_634_;
                        phi_635_ = _e450;
                    }
                    let _e452 = phi_635_;
                    phi_636_ = _e452;
                }
                let _e454 = phi_636_;
                if ((bitcast<u32>(_e107) & 2147483647u) > 2139095040u) {
                    phi_655_ = _e107;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_654_ = 0f;
                    } else {
                        if (_e107 < 0f) {
                            phi_653_ = 0f;
                        } else {
                            phi_653_ = 1f;
                        }
                        let _e463 = phi_653_;
                        phi_654_ = _e463;
                    }
                    let _e465 = phi_654_;
                    phi_655_ = _e465;
                }
                let _e467 = phi_655_;
                if ((bitcast<u32>(_e108) & 2147483647u) > 2139095040u) {
                    phi_674_ = _e108;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_673_ = 0f;
                    } else {
                        if (_e108 < 0f) {
                            phi_672_ = 0f;
                        } else {
                            phi_672_ = 1f;
                        }
                        let _e476 = phi_672_;
                        phi_673_ = _e476;
                    }
                    let _e478 = phi_673_;
                    phi_674_ = _e478;
                }
                let _e480 = phi_674_;
                let _e488 = (((((_e441 * _e144) + (_e454 * _e146)) + (_e467 * _e148)) + (_e480 * _e150)) + _e141);
                if ((bitcast<u32>(_e488) & 2147483647u) > 2139095040u) {
                    phi_699_ = _e488;
                } else {
                    if (_e488 < 0f) {
                        phi_698_ = 0f;
                    } else {
                        if (_e488 > 1f) {
                            phi_697_ = 1f;
                        } else {
                            phi_697_ = _e488;
                        }
                        let _e495 = phi_697_;
                        phi_698_ = _e495;
                    }
                    let _e497 = phi_698_;
                    phi_699_ = _e497;
                }
                let _e499 = phi_699_;
                phi_812_ = _e499;
                phi_813_ = f32();
            } else {
                let _e501 = ((0.5f * -(((((((((_e205 * (_e105 + _e106)) + (_e209 * (_e105 + _e107))) + (_e233 * (_e105 + _e151))) + (_e245 * (_e105 + _e152))) + ((((_e206 * (_e106 + _e107)) + (_e210 * (_e106 + _e108))) + (_e234 * (_e106 + _e151))) + (_e246 * (_e106 + _e152)))) + ((((_e207 * (_e107 + _e108)) + (_e211 * (_e107 + _e105))) + (_e235 * (_e107 + _e151))) + (_e247 * (_e107 + _e152)))) + ((((_e208 * (_e108 + _e105)) + (_e212 * (_e108 + _e106))) + (_e236 * (_e108 + _e151))) + (_e248 * (_e108 + _e152)))) + (_e419 * (_e151 + _e152))))) / _e422);
                let _e502 = ((((((((_e205 + _e209) + _e233) + _e245) + (((_e206 + _e210) + _e234) + _e246)) + (((_e207 + _e211) + _e235) + _e247)) + (((_e208 + _e212) + _e236) + _e248)) + _e419) / _e422);
                let _e504 = ((_e501 * _e501) - _e502);
                if (_e504 > 0f) {
                    phi_710_ = sqrt(_e504);
                } else {
                    phi_710_ = 0f;
                }
                let _e508 = phi_710_;
                if (_e501 > 0f) {
                    let _e511 = (-(_e501) - _e508);
                    phi_727_ = lt_bvh_slab_Span(_e511, (_e502 / _e511));
                } else {
                    let _e514 = (_e508 - _e501);
                    if (_e514 > 0f) {
                        phi_725_ = (_e502 / _e514);
                    } else {
                        phi_725_ = 0f;
                    }
                    let _e518 = phi_725_;
                    phi_727_ = lt_bvh_slab_Span(_e518, _e514);
                }
                let _e521 = phi_727_;
                if (_e521.near >= 0f) {
                    phi_788_ = 1f;
                    phi_789_ = f32();
                    phi_790_ = true;
                } else {
                    let _e525 = (_e521.far <= 0f);
                    if _e525 {
                        phi_786_ = (_e416 / _e422);
                        phi_787_ = f32();
                    } else {
                        let _e536 = (((((_e144 * _e105) + (_e146 * _e106)) + (_e148 * _e107)) + (_e150 * _e108)) + (_e141 * (_e151 + _e152)));
                        let _e552 = (((((_e144 * (_e105 * _e105)) + (_e146 * (_e106 * _e106))) + (_e148 * (_e107 * _e107))) + (_e150 * (_e108 * _e108))) + (_e141 * ((_e151 * _e151) + (_e152 * _e152))));
                        if (-(_e521.near) <= _e521.far) {
                            phi_785_ = (1f - (((_e521.near * _e521.near) * ((_e521.far * _e552) - _e536)) / (_e521.far - _e521.near)));
                        } else {
                            phi_785_ = ((_e416 / _e422) + (((_e521.far * _e521.far) * (_e536 - (_e521.near * _e552))) / (_e521.far - _e521.near)));
                        }
                        let _e571 = phi_785_;
                        phi_786_ = f32();
                        phi_787_ = _e571;
                    }
                    let _e573 = phi_786_;
                    let _e575 = phi_787_;
                    phi_788_ = _e573;
                    phi_789_ = _e575;
                    phi_790_ = _e525;
                }
                let _e577 = phi_788_;
                let _e579 = phi_789_;
                let _e581 = phi_790_;
                if _e581 {
                    phi_794_ = _e577;
                } else {
                    phi_794_ = _e579;
                }
                let _e583 = phi_794_;
                if ((bitcast<u32>(_e583) & 2147483647u) > 2139095040u) {
                    phi_811_ = _e583;
                } else {
                    if (_e583 < 0f) {
                        phi_810_ = 0f;
                    } else {
                        if (_e583 > 1f) {
                            phi_809_ = 1f;
                        } else {
                            phi_809_ = _e583;
                        }
                        let _e590 = phi_809_;
                        phi_810_ = _e590;
                    }
                    let _e592 = phi_810_;
                    phi_811_ = _e592;
                }
                let _e594 = phi_811_;
                phi_812_ = f32();
                phi_813_ = _e594;
            }
            let _e596 = phi_812_;
            let _e598 = phi_813_;
            phi_814_ = _e596;
            phi_815_ = _e598;
            phi_816_ = _e428;
        }
        let _e600 = phi_814_;
        let _e602 = phi_815_;
        let _e604 = phi_816_;
        phi_817_ = _e600;
        phi_818_ = _e602;
        phi_819_ = _e604;
    }
    let _e606 = phi_817_;
    let _e608 = phi_818_;
    let _e610 = phi_819_;
    if _e610 {
        phi_823_ = _e606;
    } else {
        phi_823_ = _e608;
    }
    let _e612 = phi_823_;
    return _e612;
}

fn function_() {
    var local_1: f32;
    var phi_874_: bool;
    var phi_875_: bool;
    var phi_876_: bool;
    var phi_877_: bool;
    var phi_881_: bool;
    var phi_951_: bool;
    var phi_952_: bool;
    var phi_963_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_964_: bool;
    var phi_965_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_966_: bool;
    var phi_973_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_977_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1051_: bool;
    var phi_1060_: bool;
    var phi_1069_: bool;
    var phi_1070_: bool;
    var phi_1071_: bool;
    var phi_1072_: bool;
    var phi_1073_: bool;
    var phi_1074_: bool;
    var phi_1075_: bool;
    var phi_1079_: bool;
    var phi_1169_: f32;
    var phi_1172_: f32;
    var phi_1201_: f32;
    var phi_1206_: f32;
    var phi_1207_: bool;
    var phi_1208_: f32;
    var phi_1209_: bool;
    var phi_1213_: f32;
    var phi_1233_: f32;
    var phi_1238_: f32;
    var phi_1239_: bool;
    var phi_1240_: f32;
    var phi_1241_: bool;
    var phi_1245_: f32;
    var phi_1293_: i32;
    var phi_1298_: i32;
    var phi_1303_: i32;
    var phi_1308_: i32;
    var phi_1317_: i32;
    var phi_1322_: i32;
    var phi_1327_: i32;
    var phi_1332_: i32;
    var phi_1383_: bool;
    var phi_1391_: bool;
    var phi_1403_: bool;
    var phi_1404_: bool;
    var phi_1408_: f32;
    var phi_1414_: f32;
    var phi_1416_: evaluate_Verdict;
    var phi_1421_: evaluate_Verdict;
    var phi_1422_: evaluate_Verdict;
    var phi_1426_: bool;
    var phi_1427_: u32;
    var phi_1438_: u32;

    let _e41 = id_1;
    let _e42 = local_2;
    let _e47 = arrayLength((&map.member));
    let _e52 = p.member.size[0u];
    let _e54 = p.member.size[1u];
    let _e55 = lt_shaders_entry_pixel_index(_e41, _e52, _e54);
    if (bitcast<i32>(_e55.root) != 0i) {
        let _e62 = p.member.projection;
        let _e63 = lt_math_OneLevel(_e62);
        let _e67 = samples.member[_e55.first_primitive].normal[0u];
        let _e69 = global[0u];
        if (_e67 == _e69) {
            let _e72 = samples.member[_e55.first_primitive].normal[1u];
            let _e74 = global[1u];
            if (_e72 == _e74) {
                let _e77 = samples.member[_e55.first_primitive].normal[2u];
                let _e79 = global[2u];
                phi_874_ = (_e77 == _e79);
                phi_875_ = false;
            } else {
                phi_874_ = bool();
                phi_875_ = true;
            }
            let _e82 = phi_874_;
            let _e84 = phi_875_;
            phi_876_ = _e82;
            phi_877_ = _e84;
        } else {
            phi_876_ = bool();
            phi_877_ = true;
        }
        let _e86 = phi_876_;
        let _e88 = phi_877_;
        if _e88 {
            phi_881_ = false;
        } else {
            phi_881_ = _e86;
        }
        let _e90 = phi_881_;
        if !(_e90) {
            let _e93 = samples.member[_e55.first_primitive].position;
            let _e95 = p.member.light.place;
            let _e101 = p.member.light.place[3u];
            let _e108 = (_e95.x - (_e93.x * _e101));
            let _e109 = (_e95.y - (_e93.y * _e101));
            let _e110 = (_e95.z - (_e93.z * _e101));
            let _e112 = samples.member[_e55.first_primitive].normal;
            if ((((_e112.x * _e108) + (_e112.y * _e109)) + (_e112.z * _e110)) > 0f) {
                let _e126 = (((_e108 * _e108) + (_e109 * _e109)) + (_e110 * _e110));
                let _e128 = p.member.light.axis;
                let _e140 = p.member.light.place[3u];
                if (_e140 == 0f) {
                    phi_952_ = true;
                } else {
                    let _e143 = p.member.light.range_squared;
                    if (_e126 <= _e143) {
                        let _e146 = p.member.light.cos_outer;
                        phi_951_ = (-((((_e108 * _e128.x) + (_e109 * _e128.y)) + (_e110 * _e128.z))) >= (_e146 * sqrt(_e126)));
                    } else {
                        phi_951_ = false;
                    }
                    let _e151 = phi_951_;
                    phi_952_ = _e151;
                }
                let _e153 = phi_952_;
                if _e153 {
                    let _e155 = samples.member[_e55.first_primitive].flags;
                    let _e163 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e169 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e163.unnamed.visibility, false), _e163.unnamed_1);
                    phi_963_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e169.unnamed, ((_e155 & 1u) == 0u));
                    phi_964_ = false;
                } else {
                    phi_963_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_964_ = true;
                }
                let _e174 = phi_963_;
                let _e176 = phi_964_;
                phi_965_ = _e174;
                phi_966_ = _e176;
            } else {
                phi_965_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_966_ = true;
            }
            let _e178 = phi_965_;
            let _e180 = phi_966_;
            if _e180 {
                let _e186 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e192 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e186.unnamed.visibility, false), _e186.unnamed_1);
                phi_973_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e192.unnamed, true);
            } else {
                phi_973_ = _e178;
            }
            let _e197 = phi_973_;
            phi_977_ = _e197;
        } else {
            let _e203 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e209 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e203.unnamed.visibility, false), _e203.unnamed_1);
            phi_977_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e209.unnamed, true);
        }
        let _e214 = phi_977_;
        if _e214.unnamed_1 {
            phi_1422_ = evaluate_Verdict(_e214.unnamed.visibility, _e214.unnamed.is_doubted);
        } else {
            let _e222 = samples.member[_e55.first_primitive].position;
            let _e240 = ((((_e63.projection.row_w.x * _e222.x) + (_e63.projection.row_w.y * _e222.y)) + (_e63.projection.row_w.z * _e222.z)) + (_e63.projection.row_w.w * 1f));
            let _e254 = (((((_e63.projection.row_x.x * _e222.x) + (_e63.projection.row_x.y * _e222.y)) + (_e63.projection.row_x.z * _e222.z)) + (_e63.projection.row_x.w * 1f)) / _e240);
            let _e268 = (((((_e63.projection.row_y.x * _e222.x) + (_e63.projection.row_y.y * _e222.y)) + (_e63.projection.row_y.z * _e222.z)) + (_e63.projection.row_y.w * 1f)) / _e240);
            let _e281 = ((((_e63.projection.row_z.x * _e222.x) + (_e63.projection.row_z.y * _e222.y)) + (_e63.projection.row_z.z * _e222.z)) + (_e63.projection.row_z.w * 1f));
            if (_e240 > 0f) {
                if (_e254 >= 0f) {
                    phi_1051_ = (_e254 <= 1f);
                } else {
                    phi_1051_ = false;
                }
                let _e286 = phi_1051_;
                if _e286 {
                    if (_e268 >= 0f) {
                        phi_1060_ = (_e268 <= 1f);
                    } else {
                        phi_1060_ = false;
                    }
                    let _e290 = phi_1060_;
                    if _e290 {
                        if (_e281 >= 0f) {
                            phi_1069_ = (_e281 <= 1f);
                        } else {
                            phi_1069_ = false;
                        }
                        let _e294 = phi_1069_;
                        phi_1070_ = _e294;
                        phi_1071_ = false;
                    } else {
                        phi_1070_ = bool();
                        phi_1071_ = true;
                    }
                    let _e296 = phi_1070_;
                    let _e298 = phi_1071_;
                    phi_1072_ = _e296;
                    phi_1073_ = _e298;
                } else {
                    phi_1072_ = bool();
                    phi_1073_ = true;
                }
                let _e300 = phi_1072_;
                let _e302 = phi_1073_;
                phi_1074_ = _e300;
                phi_1075_ = _e302;
            } else {
                phi_1074_ = bool();
                phi_1075_ = true;
            }
            let _e304 = phi_1074_;
            let _e306 = phi_1075_;
            if _e306 {
                phi_1079_ = false;
            } else {
                phi_1079_ = _e304;
            }
            let _e308 = phi_1079_;
            if _e308 {
                if (0f > 0f) {
                    let _e311 = samples.member[_e55.first_primitive].normal;
                    let _e313 = p.member.map_size;
                    let _e383 = ((abs(((((_e62.row_x.x * _e311.x) + (_e62.row_x.y * _e311.y)) + (_e62.row_x.z * _e311.z)) / (((_e62.row_x.x * _e62.row_x.x) + (_e62.row_x.y * _e62.row_x.y)) + (_e62.row_x.z * _e62.row_x.z)))) + abs(((((_e62.row_y.x * _e311.x) + (_e62.row_y.y * _e311.y)) + (_e62.row_y.z * _e311.z)) / (((_e62.row_y.x * _e62.row_y.x) + (_e62.row_y.y * _e62.row_y.y)) + (_e62.row_y.z * _e62.row_y.z))))) / (abs(((((_e62.row_z.x * _e311.x) + (_e62.row_z.y * _e311.y)) + (_e62.row_z.z * _e311.z)) / (((_e62.row_z.x * _e62.row_z.x) + (_e62.row_z.y * _e62.row_z.y)) + (_e62.row_z.z * _e62.row_z.z)))) * f32(_e313)));
                    if (_e383 < 0.002f) {
                        phi_1169_ = _e383;
                    } else {
                        phi_1169_ = 0.002f;
                    }
                    let _e386 = phi_1169_;
                    phi_1172_ = (_e281 - (0f * _e386));
                } else {
                    phi_1172_ = _e281;
                }
                let _e390 = phi_1172_;
                let _e392 = p.member.map_size;
                let _e393 = f32(_e392);
                let _e396 = ((_e254 * _e393) - 0.5f);
                let _e397 = ((_e268 * _e393) - 0.5f);
                if (_e396 > -8388608f) {
                    let _e409 = f32(select(0i, select(select(i32(_e396), i32(-2147483648), (_e396 < bitcast<f32>(3472883712u))), 2147483647i, (_e396 > bitcast<f32>(1325400063u))), (_e396 == _e396)));
                    if (_e409 > _e396) {
                        phi_1201_ = 1f;
                    } else {
                        phi_1201_ = 0f;
                    }
                    let _e412 = phi_1201_;
                    if (_e396 < 8388608f) {
                        phi_1206_ = (_e409 - _e412);
                        phi_1207_ = false;
                    } else {
                        phi_1206_ = f32();
                        phi_1207_ = true;
                    }
                    let _e415 = phi_1206_;
                    let _e417 = phi_1207_;
                    phi_1208_ = _e415;
                    phi_1209_ = _e417;
                } else {
                    phi_1208_ = f32();
                    phi_1209_ = true;
                }
                let _e419 = phi_1208_;
                let _e421 = phi_1209_;
                if _e421 {
                    phi_1213_ = _e396;
                } else {
                    phi_1213_ = _e419;
                }
                let _e423 = phi_1213_;
                if (_e397 > -8388608f) {
                    let _e435 = f32(select(0i, select(select(i32(_e397), i32(-2147483648), (_e397 < bitcast<f32>(3472883712u))), 2147483647i, (_e397 > bitcast<f32>(1325400063u))), (_e397 == _e397)));
                    if (_e435 > _e397) {
                        phi_1233_ = 1f;
                    } else {
                        phi_1233_ = 0f;
                    }
                    let _e438 = phi_1233_;
                    if (_e397 < 8388608f) {
                        phi_1238_ = (_e435 - _e438);
                        phi_1239_ = false;
                    } else {
                        phi_1238_ = f32();
                        phi_1239_ = true;
                    }
                    let _e441 = phi_1238_;
                    let _e443 = phi_1239_;
                    phi_1240_ = _e441;
                    phi_1241_ = _e443;
                } else {
                    phi_1240_ = f32();
                    phi_1241_ = true;
                }
                let _e445 = phi_1240_;
                let _e447 = phi_1241_;
                if _e447 {
                    phi_1245_ = _e397;
                } else {
                    phi_1245_ = _e445;
                }
                let _e449 = phi_1245_;
                let _e450 = (_e396 - _e423);
                let _e451 = (_e397 - _e449);
                let _e460 = select(0i, select(select(i32(_e423), i32(-2147483648), (_e423 < bitcast<f32>(3472883712u))), 2147483647i, (_e423 > bitcast<f32>(1325400063u))), (_e423 == _e423));
                let _e469 = select(0i, select(select(i32(_e449), i32(-2147483648), (_e449 < bitcast<f32>(3472883712u))), 2147483647i, (_e449 > bitcast<f32>(1325400063u))), (_e449 == _e449));
                let _e480 = p.member.test;
                let _e481 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e480);
                let _e483 = p.member.map_size;
                local_1 = _e481;
                let _e485 = ((0u * _e483) * _e483);
                let _e487 = (bitcast<i32>(_e483) - 1i);
                if (_e460 > 0i) {
                    phi_1293_ = _e460;
                } else {
                    phi_1293_ = 0i;
                }
                let _e490 = phi_1293_;
                if (_e469 > 0i) {
                    phi_1298_ = _e469;
                } else {
                    phi_1298_ = 0i;
                }
                let _e493 = phi_1298_;
                if (_e490 < _e487) {
                    phi_1303_ = _e490;
                } else {
                    phi_1303_ = _e487;
                }
                let _e496 = phi_1303_;
                if (_e493 < _e487) {
                    phi_1308_ = _e493;
                } else {
                    phi_1308_ = _e487;
                }
                let _e499 = phi_1308_;
                let _e500 = bitcast<u32>(_e496);
                let _e502 = (_e460 + 1i);
                let _e503 = (_e469 + 1i);
                if (_e502 > 0i) {
                    phi_1317_ = _e502;
                } else {
                    phi_1317_ = 0i;
                }
                let _e506 = phi_1317_;
                if (_e503 > 0i) {
                    phi_1322_ = _e503;
                } else {
                    phi_1322_ = 0i;
                }
                let _e509 = phi_1322_;
                if (_e506 < _e487) {
                    phi_1327_ = _e506;
                } else {
                    phi_1327_ = _e487;
                }
                let _e512 = phi_1327_;
                if (_e509 < _e487) {
                    phi_1332_ = _e509;
                } else {
                    phi_1332_ = _e487;
                }
                let _e515 = phi_1332_;
                let _e516 = bitcast<u32>(_e512);
                let _e518 = (bitcast<u32>(_e499) * _e483);
                let _e519 = (bitcast<u32>(_e515) * _e483);
                let _e524 = ((_e518 + _e500) + _e485);
                let _e525 = ((_e518 + _e516) + _e485);
                let _e526 = ((_e519 + _e500) + _e485);
                let _e527 = ((_e519 + _e516) + _e485);
                if (_e524 < _e47) {
                } else {
                    return;
                }
                let _e531 = map.member[(0u + _e524)];
                if (_e525 < _e47) {
                } else {
                    return;
                }
                let _e535 = map.member[(0u + _e525)];
                if (_e526 < _e47) {
                } else {
                    return;
                }
                let _e539 = map.member[(0u + _e526)];
                if (_e527 < _e47) {
                } else {
                    return;
                }
                let _e543 = map.member[(0u + _e527)];
                let _e545 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local_1), vec4<f32>(_e531, _e535, _e539, _e543), vec4<f32>(((1f - _e450) * (1f - _e451)), (_e450 * (1f - _e451)), ((1f - _e450) * _e451), (_e450 * _e451)), _e390);
                let _e547 = p.member.epsilon;
                if (_e545 <= _e547) {
                    phi_1383_ = true;
                } else {
                    phi_1383_ = (_e545 >= (1f - _e547));
                }
                let _e552 = phi_1383_;
                if ((bitcast<u32>(_e545) & 2147483647u) > 2139095040u) {
                    phi_1391_ = true;
                } else {
                    phi_1391_ = !(_e552);
                }
                let _e558 = phi_1391_;
                if _e558 {
                    if (_e545 > 0f) {
                        if (_e545 < 1f) {
                            phi_1403_ = false;
                        } else {
                            phi_1403_ = true;
                        }
                        let _e562 = phi_1403_;
                        phi_1404_ = _e562;
                    } else {
                        phi_1404_ = true;
                    }
                    let _e564 = phi_1404_;
                    if _e564 {
                        phi_1408_ = 0.5f;
                    } else {
                        phi_1408_ = _e545;
                    }
                    let _e566 = phi_1408_;
                    phi_1416_ = evaluate_Verdict(_e566, true);
                } else {
                    if (_e545 > 0.5f) {
                        phi_1414_ = 1f;
                    } else {
                        phi_1414_ = 0f;
                    }
                    let _e570 = phi_1414_;
                    phi_1416_ = evaluate_Verdict(_e570, false);
                }
                let _e573 = phi_1416_;
                phi_1421_ = evaluate_Verdict(_e573.visibility, _e573.is_doubted);
            } else {
                phi_1421_ = evaluate_Verdict(0.5f, true);
            }
            let _e579 = phi_1421_;
            phi_1422_ = _e579;
        }
        let _e581 = phi_1422_;
        visibility.member[_e55.first_primitive] = _e581.visibility;
        phi_1426_ = _e581.is_doubted;
        phi_1427_ = _e55.first_primitive;
    } else {
        phi_1426_ = false;
        phi_1427_ = 0u;
    }
    let _e586 = phi_1426_;
    let _e588 = phi_1427_;
    if (_e42 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e586 {
        let _e592 = atomicAdd((&shared_[0u]), 1u);
        phi_1438_ = _e592;
    } else {
        phi_1438_ = 0u;
    }
    let _e594 = phi_1438_;
    workgroupBarrier();
    if (_e42 == 0u) {
        let _e598 = atomicLoad((&shared_[0u]));
        let _e599 = atomicAdd((&list.member[3u]), _e598);
        atomicStore((&shared_[1u]), _e599);
    }
    workgroupBarrier();
    if _e586 {
        let _e602 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e602) + _e594)]), _e588);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_msm_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
